//! Points at which two faces are tried: where both can be, and nowhere special.

use super::face::{Face, Form, Part};
use super::quadric;
use crate::geometry::array::{across, add, cross, dot, length, middle, sub, unit};
use crate::scene::{Geometry, Vec3};
use crate::solids::leaf::Leaf;

/// A point of a surface and the direction at right angles to it, of length 1.
pub type Sample = (Vec3, Vec3);

/// Overlaps narrower than this share of the smaller shape may be rounding: silence.
pub const SLIVER: f64 = 1e-6;

/// Where two flat faces overlap: nothing where that is less than a sliver.
pub fn flat(one: &Face, two: &Face, size: f64) -> Vec<Sample> {
    let Form::Flat { normal, point, .. } = &one.form else {
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

/// Points of a plane, up to some way from this one.
fn plane(point: Vec3, normal: Vec3, size: f64) -> Vec<Sample> {
    let [u, v] = across(normal);
    let away = |i: u32| {
        // At distances of no pattern.
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

/// Points of a round face, in the coordinates of the search, at angles that no scene is built with.
pub fn round(one: (&Face, &Leaf, &Geometry), two: (&Face, &Leaf, &Geometry)) -> Vec<Sample> {
    // The one that is a piece of its surface, if one is.
    let own = |of: (&Face, &Leaf, &Geometry)| mantle(of.2, of.0.part).is_some();
    let (one, two) = if own(two) && !own(one) {
        (two, one)
    } else {
        (one, two)
    };
    let (face, leaf, geometry) = one;
    let Some(back) = leaf.matrix.inverse() else {
        return Vec::new();
    };
    let local = match geometry {
        Geometry::Sphere { centre, radius } => ball(*centre, [*radius; 3]),
        Geometry::Ellipsoid { semi_axes } => ball([0.0; 3], *semi_axes),
        Geometry::Torus { major, minor } => torus(*major, *minor),
        _ => match mantle(geometry, face.part) {
            None => quadric::form(geometry).map_or(Vec::new(), |q| quadric::samples(&q)),
            Some(own) => {
                // The stretch of the axis that both have.
                let there = back.after(&two.1.matrix);
                let along = |(_, y): (f64, f64)| there.point([0.0, y, 0.0])[1];
                let other = mantle(two.2, two.0.part).map(|m| (along(m.0), along(m.1)));
                let (a, b) = other.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
                mantle_samples(own, (a.min(b), a.max(b)))
            }
        },
    };
    let normal_out = |n: Vec3| -> Option<Vec3> {
        // Normals go by the transpose of the inverse.
        unit(std::array::from_fn(|j| {
            (0..3).map(|i| back.0[i][j] * n[i]).sum()
        }))
    };
    local
        .into_iter()
        .filter_map(|(p, n)| Some((leaf.matrix.point(p), normal_out(n)?)))
        .collect()
}

/// The sine and cosine of so many golden angles, and a little.
fn turn(i: u32) -> (f64, f64) {
    (f64::from(i) * 2.399_963 + 0.3).sin_cos()
}

/// Of `count` directions all around one.
pub fn direction(i: u32, count: u32) -> Vec3 {
    let y = 1.0 - (2.0 * f64::from(i) + 1.037) / f64::from(count);
    let (sin, cos) = turn(i);
    let ring = (1.0 - y * y).sqrt();
    [ring * cos, y, ring * sin]
}

fn ball(centre: Vec3, axes: Vec3) -> Vec<Sample> {
    const COUNT: u32 = 24;
    (0..COUNT)
        .map(|i| {
            let d = direction(i, COUNT);
            (
                std::array::from_fn(|k| centre[k] + axes[k] * d[k]),
                std::array::from_fn(|k| d[k] / axes[k]),
            )
        })
        .collect()
}

fn torus(major: f64, minor: f64) -> Vec<Sample> {
    (0..24)
        .map(|i| {
            let (su, cu) = turn(i);
            let (sv, cv) = (f64::from(i) * 1.137 + 0.2).sin_cos();
            let ring = major + minor * cv;
            ([ring * cu, minor * sv, ring * su], [cv * cu, sv, cv * su])
        })
        .collect()
}

type Profile = ([f64; 2], [f64; 2]);

/// A round face about the y axis as a piece of a profile: (radius, height) of its two ends.
fn mantle(geometry: &Geometry, part: Part) -> Option<((f64, f64), (f64, f64))> {
    let ends: Profile = match (geometry, part) {
        (Geometry::Cone { height, radius }, Part::Mantle) => ([0.0, 0.0], [*radius, *height]),
        // One half stands for both.
        (Geometry::DoubleCone { height, radius }, Part::Mantle) => ([0.0, 0.0], [*radius, *height]),
        (Geometry::Revolution { profile, .. }, Part::Piece(i)) => {
            (*profile.get(i)?, *profile.get(i + 1)?)
        }
        _ => return None,
    };
    Some(((ends.0[0], ends.0[1]), (ends.1[0], ends.1[1])))
}

fn mantle_samples(
    ((r0, y0), (r1, y1)): ((f64, f64), (f64, f64)),
    within: (f64, f64),
) -> Vec<Sample> {
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
