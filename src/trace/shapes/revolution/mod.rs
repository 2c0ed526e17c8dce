//! The solid of revolution: a profile polyline turned about the y axis.

mod cylinders;
mod overlap_removal;
mod path;
mod profile_cull;
#[cfg(test)]
mod tests;
mod tree;

use super::quad_double::{decide_closer, is_last};
use super::quick_reject::Pass;
use super::{FLIPPED, Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::scene::Rgb;
use crate::solids::shapes as solids;
use crate::trace::shapes::convex_piece::ConvexPiece;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::support::Support;
use cylinders::Cylinders;
use overlap_removal::Subsegment;
use path::{ClosestApproach, Cut, Path, Ring, normaliser};
use profile_cull::{Beside, Passing};
use std::cell::LazyCell;
use std::f64::consts::TAU;
use std::ops::Deref;
use tree::Run;

/// The number of pieces up to which the outline is the profile. A line's crossings with a longer profile are found
/// more quickly than the pieces are looked at one by one.
const MAX_OUTLINE_PIECES: usize = 64;

/// A profile of points (x, y) with x ≥ 0, turned about the y axis. The solid is what the closed profile surrounds by
/// the even-odd rule. A flat disc from each end point to the axis closes the profile, unless the ends are the same
/// point; the axis itself is no surface.
///
/// Faces: segment i, from point i to point i + 1 of n points, is face i; the disc at the first
/// point is face n − 1 and the one at the last point face n.
#[derive(Debug, Clone, PartialEq)]
pub struct Revolution {
    /// The profile and, unless it is a ring, points on the axis before and after it; times `scale`.
    points: Vec<[f64; 2]>,
    /// The parts of the profile that are surface.
    pieces: Vec<Subsegment>,
    /// A colour for each profile point, or none.
    colours: Vec<Rgb>,
    ring: bool,
    /// A power of two that brings the largest coordinate into [1, 2).
    scale: f64,
    /// The height of the centre, times `scale`.
    centre: f64,
    tree: Vec<Run>,
    bounds: Aabb,
    cylinders: Cylinders,
    beside: Beside,
    /// Arc length from the profile's first point to each point, times `scale`.
    arc: Vec<f64>,
}

impl Revolution {
    /// Whether its profile has colours of its own.
    pub fn has_colours(&self) -> bool {
        !self.colours.is_empty()
    }

    pub fn new(profile: &[[f64; 2]], colours: &[Rgb]) -> Revolution {
        let size = |f: fn(f64, f64) -> f64, from: f64| {
            let all = profile.iter().flatten().map(|x| x.abs());
            all.fold(from, f)
        };
        let scale = normaliser(size(f64::max, 0.0));
        let mut points: Vec<[f64; 2]> = profile.iter().map(|p| each(*p, |x| x * scale)).collect();
        let ring = profile.first() == profile.last();
        if let (false, Some(&first), Some(&last)) = (ring, points.first(), points.last()) {
            points.insert(0, [0.0, first[1]]);
            points.push([0.0, last[1]]);
        }
        let pieces = overlap_removal::pieces(&points);
        let tree = tree::build(&points, &pieces);
        let bounds = tree.first().map_or(Aabb::EMPTY, |run| {
            let r = run.radius[1];
            let (min, max) = (Vec3::new(-r, run.y[0], -r), Vec3::new(r, run.y[1], r));
            let up = 1.0 / scale;
            Aabb::new(min * up, max * up).padded()
        });
        let cylinders = Cylinders::new(&bounds, &points, scale);
        let beside = Beside::new(&points, &pieces, &tree, scale);
        let centre = tree
            .first()
            .map_or(0.0, |run| 0.5 * run.y[0] + 0.5 * run.y[1]);
        let mut arc = Vec::with_capacity(profile.len());
        let mut length = 0.0;
        for (i, p) in profile.iter().enumerate() {
            if let Some(q) = i.checked_sub(1).map(|i| profile[i]) {
                let [dx, dy] = each([0, 1], |k| p[k] * scale - q[k] * scale);
                length += libm::hypot(dx, dy);
            }
            arc.push(length);
        }
        Revolution {
            points,
            pieces,
            colours: colours.to_vec(),
            ring,
            scale,
            centre,
            tree,
            bounds,
            cylinders,
            beside,
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

    /// The position along its segment of a point on the surface, from 0 to 1; all coordinates are scaled.
    fn share<R: Traced>(&self, segment: usize, radius: R, y: R) -> R {
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

    /// The index of the profile point before a point on the surface, and the share of the way to the next one. A disc
    /// belongs to the end point that it closes, with a share of 0.
    fn place(&self, point: Vec3, face: u32) -> (usize, f64) {
        let n = self.arc.len();
        let p = point * self.scale;
        match (face & !FLIPPED) as usize {
            i if i + 1 < n => {
                let radius = libm::hypot(p[0], p[2]);
                (i, self.share(self.segment(face), radius, p[1]))
            }
            i if i + 1 == n => (0, 0.0),
            _ => (n - 1, 0.0),
        }
    }
}

impl Shape for Revolution {
    /// The convex piece of a profile that is one segment: closed, it has two more points on the axis.
    fn convex_piece(&self) -> Option<ConvexPiece> {
        match self.points[..] {
            [_, a, b, _] if !self.ring => {
                ConvexPiece::turned(each([a, b], |point| each(point, |x| x / self.scale)))
            }
            _ => None,
        }
    }

    /// The profile itself; for a long profile, a cylinder around it.
    fn outline(&self) -> Outline {
        if self.pieces.len() <= MAX_OUTLINE_PIECES {
            let points = overlap_removal::outline(&self.points, &self.pieces, self.scale);
            return Outline::exact(Form::Profile(points));
        }
        let widest = self.bounds().max[0];
        let constant = -widest * widest;
        let cylinder = [1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, constant];
        Outline::around(Form::Quadric(cylinder))
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        self.cylinders.pass(line, stretch)
    }

    /// A leaving line is not met again if it may cross no piece ahead but that of its origin. If it crossed that piece
    /// once more, it would stay inside of the solid for ever.
    fn is_met_again(&self, line: &Line) -> bool {
        let Some(passing) = self.beside.passing(line, true) else {
            return true;
        };
        let met = self.beside.met(&self.tree, &passing);
        met.map(|(_, met)| met.count_ones()).sum::<u32>() > 1
    }

    /// u as on the sphere, v the arc length along the profile, as a share of all of it: 0 on the
    /// whole disc at the first point and 1 on the one at the last.
    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        let u = libm::atan2(-point[2], point[0]).rem_euclid(TAU) / TAU;
        let (i, share) = self.place(point, face);
        let length = self.arc.last().copied().unwrap_or(0.0);
        if length == 0.0 {
            return [u, 0.0];
        }
        let step = self.arc.get(i + 1).map_or(0.0, |next| next - self.arc[i]);
        [u, (self.arc[i] + share * step) / length]
    }

    /// Linear between the profile's points; a disc has the colour of the point that it closes.
    fn colour(&self, point: Vec3, face: u32) -> Option<Rgb> {
        let (i, share) = self.place(point, face);
        let a = self.colours.get(i)?;
        let b = self.colours.get(i + 1).unwrap_or(a);
        Some(each([0, 1, 2], |k| a[k] * (1.0 - share) + b[k] * share))
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn support(&self, face: u32) -> Option<Support> {
        let i = self.segment(face);
        // The scale is a power of two.
        let ends = each([i, i + 1], |i| each(self.points[i], |x| x / self.scale));
        Some(Support::turned(ends))
    }

    fn holds(&self, point: Vec3) -> bool {
        solids::profile::holds(&self.points, (point * self.scale).0)
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.scale);
        sink(self.points.len() as f64);
        sink(f64::from(u8::from(self.ring)));
        self.points.iter().flatten().copied().for_each(&mut *sink);
        self.colours.iter().flatten().copied().for_each(sink);
    }
}

impl<R: Traced> Intersect<R> for Revolution {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        self.decide(line, roots);
        decide_closer(line, roots, |line, roots| self.decide(line, roots));
    }

    /// The speed across the surface by the segment's normal (h, −w) in the half-plane of the point; for a point on the
    /// axis only the direction's component along the axis counts.
    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        let segment = self.segment(root.face);
        let (p, q) = (self.points[segment], self.points[segment + 1]);
        let (w, h) = (R::of(q[0]) - R::of(p[0]), R::of(q[1]) - R::of(p[1]));
        let ([x, _, z], d) = (line.at(root.t).0, line.direction);
        let radius = x.abs().max(z.abs());
        let outwards = if radius > R::ZERO && radius.is_finite() {
            let (x, z) = (x / radius, z / radius);
            (x * d[0] + z * d[2]) / (x * x + z * z).sqrt()
        } else {
            R::ZERO
        };
        let across = (h * outwards - w * d[1]).abs();
        // The length is up to √2 of the greater part.
        Some(across / (R::of(1.5) * h.abs().max(w.abs())))
    }

    /// The segment's point nearest to the line's point, turned about the axis to where the line's point is.
    ///
    /// The place along the segment is measured from the nearer end, so that the radius is at least half of either
    /// summand. Seven roundings lie behind the radius and each of (x, z) / ρ, the product included, two of them twice
    /// over for the summands; four lie behind the height.
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let segment = self.segment(root.face);
        let (mut p, mut q) = (self.points[segment], self.points[segment + 1]);
        let (mut point, direction) = ClosestApproach::new(line, self.scale, self.centre).at(root.t);
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
        let [px, py, qx, qy] = each([p[0], p[1], q[0], q[1]], R::of);
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

        // The normal (h, −w) of the segment, which is taken from its lower end.
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

/// Sorts the crossings; returns whether all are farther apart than their errors reach.
fn settle<R: Traced>(roots: &mut Roots<R>, error: R) -> bool {
    let list = &mut roots.list;
    if list.iter().any(|root| !root.t.is_finite()) {
        list.clear();
        roots.uncertain = true;
        return true;
    }
    list.sort_by(|a, b| order(a.t, b.t));
    let apart = error + error;
    list.windows(2).all(|w| w[1].t - w[0].t > apart)
}

fn order<R: Traced>(a: R, b: R) -> std::cmp::Ordering {
    a.partial_cmp(&b).unwrap_or(std::cmp::Ordering::Equal)
}

/// The crossings with the intersection of two solids, from the crossings with each, for lines that do not climb. Where
/// crossings of both are in one place, as far as doubles can tell, the face is the first solid's: a seam belongs to
/// one segment. A common part without thickness has no crossings.
fn common<R: Traced>(a: &[Close<R>], b: &[Close<R>]) -> Vec<Root<R>> {
    let mut found = Vec::new();
    let (mut i, mut j) = (0, 0);
    while let (Some([from, to]), Some([start, end])) = (a.get(i..i + 2), b.get(j..j + 2)) {
        let of = |own: &Close<R>, other: &Close<R>, bound: &Close<R>| {
            let t = bound.root.t;
            let alike = (own.root.t - other.root.t).abs() <= R::of(f64::EPSILON) * t.abs();
            let face = if alike { own } else { bound }.root.face;
            Root { t, face }
        };
        let first = if from.root.t < start.root.t {
            start
        } else {
            from
        };
        let last = if end.root.t < to.root.t { end } else { to };
        if first.root.t < last.root.t && !last.meets(first, false) {
            found.extend([of(from, start, first), of(to, end, last)]);
        }
        if to.root.t < end.root.t {
            i += 2;
        } else {
            j += 2;
        }
    }
    found
}

/// Changes the meaning of [`FLIPPED`] from "the line goes against the segment's normal" to "the outward normal is
/// opposite to the segment's".
fn turn_outwards<R>(list: &mut [Root<R>]) {
    // Where the line enters, the outward normal is the one it goes against.
    for root in list.iter_mut().step_by(2) {
        root.face ^= FLIPPED;
    }
}

/// A crossing with a piece of the profile, and the rings at the ends of the piece.
struct Close<R> {
    cut: Cut<R>,
    root: Root<R>,
    piece: u32,
    ends: [Ring<R>; 2],
}

impl<R: Traced> Close<R> {
    /// Whether two crossings may be in one place.
    ///
    /// Two crossings of one piece are the ends of a chord, and never in one place. Quad-double knows two more such
    /// cases. If the line `climbs` and one piece is above the other, each crossing stays on its own side of the ring
    /// that the pieces may have in common. If two pieces have a point in common and are not in one line, they meet
    /// nowhere else: a line that surely misses the ring of that point crosses them in two places, however close. The
    /// order of the two is left to the final numbers.
    fn meets(&self, other: &Close<R>, climbs: bool) -> bool {
        let span = |[a, b]: [Ring<R>; 2]| (a.y.min(b.y), a.y.max(b.y));
        let ((low, high), (bottom, top)) = (span(self.ends), span(other.ends));
        let beside = (high <= bottom || top <= low) && (low, high) != (bottom, top);
        let mut corners = self.ends.iter().flat_map(|a| each(other.ends, |b| (a, b)));
        let corner = corners.any(|(a, b)| (a.radius, a.y) == (b.radius, b.y) && !a.is_uncertain());
        let apart = is_last::<R>() && (corner || (climbs && beside));
        let known = self.piece == other.piece || apart;
        let gap = (self.cut.tau - other.cut.tau).abs();
        // Written so that NaN is not clear.
        let clear = gap > self.cut.error + other.cut.error;
        !known && !clear
    }
}

impl Revolution {
    /// Finds the crossings, deciding ring by ring as [`path`] explains, so that the list is even, hence alternates.
    /// Two crossings at the same t are a layer without thickness and cancel.
    fn decide<R: Traced>(&self, line: &Line<R>, roots: &mut Roots<R>) {
        // Single precision has its own idea of where a line is.
        let passing = match R::ROUNDOFF > R::of(f64::EPSILON) {
            true => None,
            false => self.beside.passing(&R::coarse(line), false),
        };
        let passing = passing.as_ref();
        // The path is made on demand, since most lines that get here miss all the same.
        let path = LazyCell::new(|| Path::new(line, self.scale, self.centre));
        self.append(&path, passing, roots);
        if is_last::<R>()
            && roots.uncertain
            && let Some(path) = path.as_ref()
            && !path.climbs()
        {
            // A line in the plane of a seam may lie in a surface. Only what is inside both just above and just below
            // the seam counts as inside.
            let above = self.closely(path, passing, &mut roots.uncertain);
            let below = self.closely(&path.seams_below(), passing, &mut roots.uncertain);
            roots.list = common(&above, &below);
            if self.has_step(path) {
                roots.along = Some(Vec3::new(0.0, 1.0, 0.0));
            }
        }
        turn_outwards(&mut roots.list);
    }

    /// Whether a flat part of the surface may be in the level plane of a path.
    fn has_step<R: Traced>(&self, path: &Path<R>) -> bool {
        self.pieces.iter().any(|piece| {
            let [from, to] = each([piece.from, piece.to], |i| self.points[i as usize][1]);
            from == to && path.may_be_at(from)
        })
    }

    /// Appends the crossings, in order. [`FLIPPED`] in a face means that the line goes against the segment's normal.
    fn append<R: Traced>(
        &self,
        path: &impl Deref<Target = Option<Path<R>>>,
        passing: Option<&Passing>,
        roots: &mut Roots<R>,
    ) {
        // The largest error of a crossing.
        let mut error = R::ZERO;
        roots.uncertain |= self.cuts(path, passing, |path, piece, _, list| {
            for cut in list.into_iter().flatten() {
                error = error.max(path.t_error(cut));
                roots.push(path.t(cut.tau), self.marked(piece, cut));
            }
        });
        if !settle(roots, error)
            && let Some(path) = path.as_ref()
        {
            let kept = self.closely(path, passing, &mut roots.uncertain);
            roots.list.clear();
            roots.list.extend(kept.iter().map(|x| x.root));
        }
    }

    /// Calls `found` with the crossings of each piece, in any order. Returns whether rounding may have added or lost a
    /// crossing.
    fn cuts<R: Traced>(
        &self,
        path: &impl Deref<Target = Option<Path<R>>>,
        passing: Option<&Passing>,
        mut found: impl FnMut(&Path<R>, &Subsegment, [&Ring<R>; 2], [Option<Cut<R>>; 2]),
    ) -> bool {
        let mut uncertain = false;
        let mut cut = |path: &Path<R>, run: &Run, mut met: u32| {
            let pieces = &self.pieces[run.first as usize..run.end as usize];
            let mut last: Option<(u32, Ring<R>)> = None;
            while met != 0 {
                let piece = &pieces[met.trailing_zeros() as usize];
                met &= met - 1;
                let ring = |point: u32| path.ring(self.points[point as usize]);
                let before = match last {
                    Some((point, ring)) if point == piece.from => ring,
                    _ => ring(piece.from),
                };
                let after = ring(piece.to);
                let cuts = path.segment(&before, &after);
                uncertain |= before.is_uncertain() || after.is_uncertain() || cuts.uncertain;
                found(path, piece, [&before, &after], cuts.list);
                last = Some((piece.to, after));
            }
        };
        let Some(line) = passing else {
            let Some(path) = path.as_ref() else {
                return true;
            };
            let leaves = tree::leaves(&self.tree, |_, run| path.misses(run));
            leaves.for_each(|(_, run)| cut(path, run, run.all()));
            return uncertain;
        };
        for (run, met) in self.beside.met(&self.tree, line) {
            if met != 0 {
                let Some(path) = path.as_ref() else {
                    return true;
                };
                cut(path, run, met);
            }
        }
        uncertain
    }

    /// The face of a crossing, marked where the line goes against the segment's normal.
    fn marked<R>(&self, piece: &Subsegment, cut: Cut<R>) -> u32 {
        self.face(piece.segment) | if cut.against { FLIPPED } else { 0 }
    }

    /// Finds the crossings once more and compares them one by one. Two in one place are a layer without thickness and
    /// cancel. In quad-double, two that cannot be told from such a layer cancel as well.
    fn closely<R: Traced>(
        &self,
        path: &Path<R>,
        passing: Option<&Passing>,
        uncertain: &mut bool,
    ) -> Vec<Close<R>> {
        let mut all: Vec<Close<R>> = Vec::new();
        self.cuts(&&Some(*path), passing, |path, piece, [a, b], list| {
            for mut cut in list.into_iter().flatten() {
                cut.error = path.closer_error(cut, a, b);
                all.push(Close {
                    cut,
                    root: Root {
                        t: path.t(cut.tau),
                        face: self.marked(piece, cut),
                    },
                    piece: piece.from,
                    ends: [*a, *b],
                });
            }
        });
        if all.iter().any(|x| !x.root.t.is_finite()) {
            *uncertain = true;
            return Vec::new();
        }
        all.sort_by(|a, b| order(a.cut.tau, b.cut.tau));
        let climbs = path.climbs();
        let widest = all.iter().fold(R::ZERO, |e, x| e.max(x.cut.error));
        for (i, here) in all.iter().enumerate() {
            let far = here.cut.error + widest;
            let before = all[..i].iter().rev();
            let mut near = before.take_while(|x| x.cut.tau >= here.cut.tau - far);
            *uncertain |= near.any(|x| here.meets(x, climbs));
        }
        let mut kept: Vec<Close<R>> = Vec::new();
        for here in all {
            match kept.last() {
                Some(last) if is_last::<R>() && here.meets(last, climbs) => {
                    kept.pop();
                }
                Some(last) if last.root.t == here.root.t => {
                    *uncertain = true;
                    kept.pop();
                }
                _ => kept.push(here),
            }
        }
        kept
    }
}
