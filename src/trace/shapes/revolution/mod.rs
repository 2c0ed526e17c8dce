//! The solid of revolution: a profile polyline turned about the y axis.

mod path;
#[cfg(test)]
mod tests;
mod tree;

use super::{Intersect, Located, Root, Roots, Shape};
use crate::scene::Rgb;
use crate::trace::bounds::Bounds;
use crate::trace::number::Real;
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;
use path::{Path, normaliser};
use std::f64::consts::TAU;
use tree::Run;

/// Set in a face where the outward normal is the opposite of the segment's own: of (h, −w) for a
/// segment that rises by h over w, and of (0, 1) for a flat one. In a profile that crosses itself
/// both sides of one segment may be the outer one in different places.
const FLIPPED: u32 = 1 << 31;

/// Points (x, y) with x ≥ 0 turned about the y axis. Inside is what the closed profile surrounds
/// by the even-odd rule. It closes with a flat disc from each end point to the axis, unless the
/// ends are the same point; the axis itself is no surface.
///
/// Faces: segment i, from point i to point i + 1 of n points, is face i; the disc at the first
/// point is face n − 1 and the one at the last point face n.
#[derive(Debug, Clone, PartialEq)]
pub struct Revolution {
    /// The profile and, unless it is a ring, points on the axis before and after it; times `scale`.
    points: Vec<[f64; 2]>,
    /// One a profile point, or none.
    colours: Vec<Rgb>,
    ring: bool,
    /// A power of two that brings the largest coordinate into [1, 2).
    scale: f64,
    /// The height of the centre, times `scale`.
    centre: f64,
    tree: Vec<Run>,
    /// Arc length from the profile's first point to each point, times `scale`.
    arc: Vec<f64>,
}

impl Revolution {
    pub fn new(profile: &[[f64; 2]], colours: &[Rgb]) -> Revolution {
        let size = |f: fn(f64, f64) -> f64, from: f64| {
            let all = profile.iter().flatten().map(|x| x.abs());
            all.fold(from, f)
        };
        let scale = normaliser(size(f64::max, 0.0));
        let mut points: Vec<[f64; 2]> = profile.iter().map(|p| p.map(|x| x * scale)).collect();
        let ring = profile.first() == profile.last();
        if let (false, Some(&first), Some(&last)) = (ring, points.first(), points.last()) {
            points.insert(0, [0.0, first[1]]);
            points.push([0.0, last[1]]);
        }
        let tree = tree::build(&points);
        let centre = tree
            .first()
            .map_or(0.0, |run| 0.5 * run.y[0] + 0.5 * run.y[1]);
        let mut arc = Vec::with_capacity(profile.len());
        let mut length = 0.0;
        for (i, p) in profile.iter().enumerate() {
            if let Some(q) = i.checked_sub(1).map(|i| profile[i]) {
                let [dx, dy] = [0, 1].map(|k| p[k] * scale - q[k] * scale);
                length += dx.hypot(dy);
            }
            arc.push(length);
        }
        Revolution {
            points,
            colours: colours.to_vec(),
            ring,
            scale,
            centre,
            tree,
            arc,
        }
    }

    /// The face of the segment that begins at `points[i]`.
    fn face(&self, i: u32) -> u32 {
        let n = self.arc.len() as u32;
        match (self.ring, i) {
            (true, _) => i,
            (false, 0) => n - 1,
            (false, i) if i == n => n,
            (false, i) => i - 1,
        }
    }

    /// The index in `points` of the segment with this face.
    fn segment(&self, face: u32) -> usize {
        let face = (face & !FLIPPED) as usize;
        let n = self.arc.len();
        if self.ring || face == n {
            face
        } else if face + 1 == n {
            0
        } else {
            face + 1
        }
    }

    /// How far along its segment a point on the surface is, from 0 to 1; scaled coordinates.
    fn share<R: Real>(&self, segment: usize, radius: R, y: R) -> R {
        let (p, q) = (self.points[segment], self.points[segment + 1]);
        let (w, h) = (R::of(q[0]) - R::of(p[0]), R::of(q[1]) - R::of(p[1]));
        let k = w.abs().max(h.abs());
        if k == R::ZERO {
            return R::ZERO;
        }
        let (a, b) = (w / k, h / k);
        let along = ((radius - R::of(p[0])) / k) * a + ((y - R::of(p[1])) / k) * b;
        (along / (a * a + b * b)).max(R::ZERO).min(R::ONE)
    }

    /// The profile point before a point on the surface, and how far it is to the next; a disc
    /// belongs to the end point it closes.
    fn place(&self, point: Vec3, face: u32) -> (usize, f64) {
        let n = self.arc.len();
        let p = point * self.scale;
        match (face & !FLIPPED) as usize {
            i if i + 1 < n => {
                let radius = p[0].hypot(p[2]);
                (i, self.share(self.segment(face), radius, p[1]))
            }
            i if i + 1 == n => (0, 0.0),
            _ => (n - 1, 0.0),
        }
    }
}

impl Shape for Revolution {
    fn bounds(&self) -> Bounds {
        self.tree.first().map_or(Bounds::EMPTY, |run| {
            let r = run.radius[1];
            let scaled = Bounds::new(Vec3::new(-r, run.y[0], -r), Vec3::new(r, run.y[1], r));
            let up = 1.0 / self.scale;
            Bounds::new(scaled.min * up, scaled.max * up).padded()
        })
    }

    /// u as on the sphere, v the arc length along the profile, as a share of all of it: 0 on the
    /// whole disc at the first point and 1 on the one at the last.
    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let u = (-point[2]).atan2(point[0]).rem_euclid(TAU) / TAU;
        let (i, share) = self.place(point, face);
        let length = self.arc.last().copied().unwrap_or(0.0);
        if length == 0.0 {
            return [u, 0.0];
        }
        let step = self.arc.get(i + 1).map_or(0.0, |next| next - self.arc[i]);
        [u, (self.arc[i] + share * step) / length]
    }

    /// Linear between the profile's points; discs have the colour of theirs.
    fn colour(&self, point: Vec3, face: u32) -> Option<Rgb> {
        let (i, share) = self.place(point, face);
        let a = self.colours.get(i)?;
        let b = self.colours.get(i + 1).unwrap_or(a);
        Some([0, 1, 2].map(|k| a[k] * (1.0 - share) + b[k] * share))
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.scale);
        sink(self.points.len() as f64);
        sink(f64::from(u8::from(self.ring)));
        self.points.iter().flatten().copied().for_each(&mut *sink);
        self.colours.iter().flatten().copied().for_each(sink);
    }
}

impl<R: Real> Intersect<R> for Revolution {
    /// Decided ring by ring as [`path`] explains, so that the list is even, hence alternates. Two
    /// crossings at the same t are a layer without thickness and cancel.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let Some(path) = Path::new(line, self.scale, self.centre) else {
            roots.uncertain = true;
            return;
        };
        // The largest error of a crossing.
        let mut error = R::ZERO;
        let mut run = 0;
        while let Some(here) = self.tree.get(run) {
            if path.misses(here) {
                run = here.next as usize;
                continue;
            }
            run += 1;
            if !here.is_leaf() {
                continue;
            }
            let mut before = path.ring(self.points[here.first as usize]);
            roots.uncertain |= before.is_uncertain();
            for i in here.first..here.end {
                let after = path.ring(self.points[i as usize + 1]);
                let cuts = path.segment(&before, &after);
                roots.uncertain |= after.is_uncertain() || cuts.uncertain;
                for cut in cuts.list.into_iter().flatten() {
                    error = error.max(cut.error);
                    let against = if cut.against { FLIPPED } else { 0 };
                    roots.push(cut.t, self.face(i) | against);
                }
                before = after;
            }
        }
        settle(roots, error);
    }

    /// The point of the segment nearest to that of the line, turned to where that is.
    ///
    /// Along the segment it is reckoned from the nearer end, so that the radius is at least half
    /// of either summand. Seven roundings lie behind the radius and each of (x, z) / ρ, the
    /// product included, two of them twice over for the summands; four behind the height.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let segment = self.segment(root.face);
        let (mut p, mut q) = (self.points[segment], self.points[segment + 1]);
        let (mut point, direction) = match Path::new(line, self.scale, self.centre) {
            Some(path) => path.at(root.t),
            None => (Vec3::ZERO, Vec3::ZERO),
        };
        if !point.is_finite() {
            point = Vec3::new(R::of(p[0]), R::of(p[1]), R::ZERO);
        }
        // On the axis any direction will do; the one the line comes from faces it.
        let mut out = Vec3::new(point[0], R::ZERO, point[2]);
        let radius = out.length();
        if !out.any() {
            out = -Vec3::new(direction[0], R::ZERO, direction[2]);
        }
        if !out.any() {
            out = Vec3::new(R::ONE, R::ZERO, R::ZERO);
        }
        let out = out.unit();

        let mut share = self.share(segment, radius, point[1]);
        if share + share > R::ONE {
            share = R::ONE - share;
            std::mem::swap(&mut p, &mut q);
        }
        let [px, py, qx, qy] = [p[0], p[1], q[0], q[1]].map(R::of);
        let (w, h) = (qx - px, qy - py);
        let on = out * (px + share * w);
        let y = py + share * h;
        let y_size = if h == R::ZERO {
            R::ZERO
        } else {
            py.abs() + (share * h).abs()
        };
        let error = Vec3::new(
            on[0].abs() * R::gamma(16),
            y_size * R::gamma(4),
            on[2].abs() * R::gamma(16),
        );

        // (h, −w) of the segment seen from below.
        let k = w.abs().max(h.abs());
        let (mut slope, mut rise) = (-w / k, h / k);
        if h < R::ZERO {
            (slope, rise) = (-slope, -rise);
        }
        if h == R::ZERO {
            (slope, rise) = (R::ONE, R::ZERO);
        }
        let mut normal = Vec3::new(out[0] * rise, slope, out[2] * rise);
        if root.face & FLIPPED != 0 {
            normal = -normal;
        }
        let up = R::ONE / R::of(self.scale);
        Located {
            point: Vec3::new(on[0], y, on[2]) * up,
            error: error * up,
            normal,
        }
    }
}

/// Sorts the crossings, drops pairs at the same t and turns "against the segment's normal" into
/// "the outward normal is flipped".
fn settle<R: Real>(roots: &mut Roots<R>, error: R) {
    let list = &mut roots.list;
    if list.iter().any(|root| !root.t.is_finite()) {
        list.clear();
        roots.uncertain = true;
        return;
    }
    list.sort_by(|a, b| a.t.partial_cmp(&b.t).unwrap_or(std::cmp::Ordering::Equal));
    let apart = error + error;
    roots.uncertain |= list.windows(2).any(|w| w[1].t - w[0].t <= apart);
    let mut kept = 0;
    for i in 0..list.len() {
        if kept > 0 && list[kept - 1].t == list[i].t {
            kept -= 1;
        } else {
            list[kept] = list[i];
            kept += 1;
        }
    }
    list.truncate(kept);
    for (i, root) in list.iter_mut().enumerate() {
        // Where the line enters, the outward normal is the one it goes against.
        if i % 2 == 0 {
            root.face ^= FLIPPED;
        }
    }
}
