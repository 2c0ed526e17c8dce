//! Points at which two faces are compared: points that both faces may have, in no special position.

use super::directions::{Sample, turn};
use super::face::{Face, FaceShape};
use super::round::Mantle;
use crate::geometry::array::{across, add, cross, dot, length, middle, sub, unit};
use crate::scene::{Geometry, Vec3};
use crate::solids::leaf::Leaf;

/// The width of an overlap, as a share of the smaller shape, below which the overlap may be due to rounding and is not
/// reported.
pub(super) const SLIVER: f64 = 1e-6;

/// Samples of the overlap of two flat faces: none where the overlap is less than a sliver.
pub(super) fn flat(one: &Face, two: &Face, size: f64) -> Vec<Sample> {
    let FaceShape::Flat { normal, point, .. } = &one.form else {
        return Vec::new();
    };
    let outline = match (one.form.corners(), two.form.corners()) {
        (None, None) => return plane(*point, *normal, size),
        (Some(outline), None) | (None, Some(outline)) => outline.to_vec(),
        (Some(a), Some(b)) => clipped(&a, &b, *normal),
    };
    let n = outline.len();
    let edge = |i: usize| sub(outline[(i + 1) % n], outline[i]);
    let around: f64 = (0..n).map(|i| length(edge(i))).sum();
    let centre = middle(&outline);
    let area: f64 = (0..n)
        .map(|i| length(cross(sub(outline[i], centre), edge(i))) / 2.0)
        .sum();
    if n < 3 || area <= SLIVER * size * around {
        return Vec::new();
    }
    let mut points = vec![centre];
    for (i, &p) in outline.iter().enumerate() {
        let corner = sub(p, centre);
        let side = add(corner, edge(i), 0.47);
        points.extend([
            add(centre, corner, 0.53),
            add(centre, side, 0.87),
            add(centre, corner, 0.91),
        ]);
    }
    points.extend(one.form.samples().chain(two.form.samples()));
    points.into_iter().map(|p| (p, *normal)).collect()
}

/// Points of a plane around `point`, at up to 2.3 times `size` from it.
fn plane(point: Vec3, normal: Vec3, size: f64) -> Vec<Sample> {
    let [u, v] = across(normal);
    let away = |i: u32| {
        // The distances are not regular either.
        let (sin, cos) = turn(i);
        let far = size * 0.317 * f64::from(i);
        (add(add(point, u, far * cos), v, far * sin), normal)
    };
    (0..8).map(away).collect()
}

/// The part of a convex outline that lies within another one of the same plane (Sutherland and
/// Hodgman).
fn clipped(a: &[Vec3], by: &[Vec3], normal: Vec3) -> Vec<Vec3> {
    let centre = middle(by);
    let mut outline = a.to_vec();
    for i in 0..by.len() {
        let edge = sub(by[(i + 1) % by.len()], by[i]);
        let mut inwards = cross(normal, edge);
        if dot(inwards, sub(centre, by[i])) < 0.0 {
            inwards = inwards.map(|x| -x);
        }
        let depth = |p: Vec3| dot(inwards, sub(p, by[i]));
        let mut next = Vec::with_capacity(outline.len() + 1);
        for k in 0..outline.len() {
            let (p, q) = (outline[k], outline[(k + 1) % outline.len()]);
            let (dp, dq) = (depth(p), depth(q));
            if dp >= 0.0 {
                next.push(p);
            }
            if (dp < 0.0) != (dq < 0.0) {
                next.push(add(p, sub(q, p), dp / (dp - dq)));
            }
        }
        outline = next;
    }
    outline
}

/// Points that two round faces may have in common, where the leaves are placed, at angles along which no scene is
/// built.
pub(super) fn round(one: (&Face, &Leaf, &Geometry), two: (&Face, &Leaf, &Geometry)) -> Vec<Sample> {
    // The face that is a piece of a profile comes first, if one is.
    let own = |of: (&Face, &Leaf, &Geometry)| of.2.mantle(of.0.part).is_some();
    let (one, two) = if own(two) && !own(one) {
        (two, one)
    } else {
        (one, two)
    };
    let (face, leaf, geometry) = one;
    let Some(back) = leaf.matrix.inverse() else {
        return Vec::new();
    };
    let local = match geometry.mantle(face.part) {
        None => geometry.samples(),
        Some(own) => {
            // Both pieces cover this stretch of the axis.
            let there = back.after(&two.1.matrix);
            let along = |(_, y): (f64, f64)| there.point([0.0, y, 0.0])[1];
            let other = two.2.mantle(two.0.part);
            let other = other.map(|m| (along(m.0), along(m.1)));
            let (a, b) = other.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            mantle_samples(own, (a.min(b), a.max(b)))
        }
    };
    let normal_out = |n: Vec3| -> Option<Vec3> {
        // The transpose of the inverse matrix maps normals.
        unit(std::array::from_fn(|j| {
            (0..3).map(|i| back.0[i][j] * n[i]).sum()
        }))
    };
    local
        .into_iter()
        .filter_map(|(p, n)| Some((leaf.matrix.point(p), normal_out(n)?)))
        .collect()
}

fn mantle_samples(((r0, y0), (r1, y1)): Mantle, within: (f64, f64)) -> Vec<Sample> {
    let (low, high) = (y0.min(y1).max(within.0), y0.max(y1).min(within.1));
    if low >= high {
        return Vec::new();
    }
    let slope = (r1 - r0) / (y1 - y0);
    let mut out = Vec::new();
    for share in [0.47, 0.21, 0.83] {
        let y = low + (high - low) * share;
        let r = r0 + slope * (y - y0);
        for i in 0..8 {
            let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_4 + 0.3 + share).sin_cos();
            out.push(([r * cos, y, r * sin], [cos, -slope, sin]));
        }
    }
    out
}
