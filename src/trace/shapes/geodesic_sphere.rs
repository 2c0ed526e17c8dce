//! The geodesic sphere: an icosahedron whose facets are split in four again and again, with the new
//! vertices pushed out onto the sphere.
//!
//! The splitting is itself the hierarchy that lines are traced through: the corners of a facet are found on the way
//! down to it. A new vertex depends on the two ends of its edge alone, and not on their order, so that neighbours have
//! equal corners, bit for bit. Everything is computed for radius 1 and scaled at the end.
//!
//! The cone of a facet lies between the planes through its edges and the centre. All parts that the facet is split into
//! are in that cone. A line meets facets on two stretches alone, where it enters the sphere and where it leaves it. So
//! the search goes down through the facets whose cones these stretches meet, mostly one of four.

mod middles;

use super::facet::{Facet, Passage, PassageDirection, Projected, Shear, drift_across, narrow};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::icosahedron::FACES;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::support::Support;
use std::f64::consts::{PI, TAU};

use middles::Middles;
pub use middles::facets_above;

/// The language allows no more splits.
pub(super) const MAX_SPLITS: u32 = 9;

#[derive(Debug, Clone, PartialEq)]
pub struct GeodesicSphere {
    record: solids::geodesic_sphere::GeodesicSphere,
    /// 1 / √(1 + φ²) and φ / √(1 + φ²): the icosahedron's coordinates other than 0.
    coordinates: [Dd; 2],
    /// The number √5 − 2: see [`GeodesicSphere::facets`].
    share: Dd,
    /// The distance from the centre, in radii, that no point of a facet is below.
    inner: f64,
}

/// A line as the facets of the unit sphere see it. All lengths are in radii.
struct View<R> {
    shear: Shear<R>,
    /// The line's point closest to the centre.
    nearest: Vec3<R>,
    /// The depth of `nearest`, from the line's origin.
    depth: R,
    /// Bound on the error of the facets' projected coordinates.
    noise: R,
}

/// The relation of a line to the sphere, before any facet is looked at.
enum Sight<R> {
    /// The line certainly passes the sphere.
    Passes,
    /// The line comes from so far that numbers overflow.
    Lost,
    Near(View<R>),
}

/// A facet on the way down through the hierarchy. Each bit of `near` stands for a quarter that is still to be visited.
#[derive(Clone, Copy, Default)]
struct PendingFacet<R> {
    corners: [Vec3<R>; 3],
    /// The middles of the edges opposite to the corners of the same number.
    middles: [Vec3<R>; 3],
    face: u32,
    near: u32,
}

/// A stretch of a line between two ends. A point up to `tolerance` behind a plane counts as in front of it.
#[derive(Clone, Copy)]
struct Stretch<R> {
    ends: [Vec3<R>; 2],
    tolerance: R,
}

impl<R: Traced> Stretch<R> {
    /// Whether the stretch reaches the side that `normal` points to, of a plane through the centre; and whether it
    /// reaches the other side.
    #[inline]
    fn sides(&self, normal: Vec3<R>) -> [bool; 2] {
        let [a, b] = each(self.ends, |end| normal.dot(end));
        [a.max(b) >= -self.tolerance, a.min(b) <= self.tolerance]
    }

    /// The quarters of a facet whose cones the stretch may meet: a bit for each. The arguments are the middles of the
    /// facet's edges; the stretch meets the cone of the facet. A plane through two of the middles and the centre cuts
    /// off the quarter at a corner; the last quarter is on the other side of all three.
    #[inline]
    fn quarters(&self, [bc, ca, ab]: [Vec3<R>; 3]) -> u32 {
        let normals = [ab.cross(ca), bc.cross(ab), ca.cross(bc)];
        let [a, b, c] = each(normals, |normal| self.sides(normal));
        let inmost = a[1] & b[1] & c[1];
        u32::from(a[0]) | u32::from(b[0]) << 1 | u32::from(c[0]) << 2 | u32::from(inmost) << 3
    }
}

/// The corners of one of the four parts of a facet, which run the same way round.
fn quarter<T: Copy>([a, b, c]: [T; 3], [bc, ca, ab]: [T; 3], index: u32) -> [T; 3] {
    match index {
        0 => [a, ab, ca],
        1 => [ab, b, bc],
        2 => [ca, bc, c],
        _ => [bc, ca, ab],
    }
}

impl GeodesicSphere {
    /// A sphere with at most [`MAX_SPLITS`] splits.
    pub fn new(radius: f64, splits: u32) -> GeodesicSphere {
        let phi = (Dd::ONE + Dd::of(5.0).sqrt()) / Dd::of(2.0);
        let short = Dd::ONE / (Dd::ONE + phi * phi).sqrt();
        let splits = splits.min(MAX_SPLITS);
        GeodesicSphere {
            record: solids::geodesic_sphere::GeodesicSphere { radius, splits },
            coordinates: [short, phi * short],
            share: Dd::of(5.0).sqrt() - Dd::of(2.0),
            inner: inner_radius(2.0 * short.to_f64(), splits),
        }
    }

    /// The radius and the number of splits.
    pub fn numbers(&self) -> (f64, u32) {
        (self.record.radius, self.record.splits)
    }

    /// The distance from the centre, in radii, that no point of a facet is below.
    pub fn inner(&self) -> f64 {
        self.inner
    }

    /// The middles of the edges of facets, for some first levels, level by level: see [`facets_above`].
    pub fn known_middles(&self) -> &'static [[Vec3; 3]] {
        Middles::new::<f64>(self).table
    }

    /// The scalar products of a vector with the icosahedron's vertices.
    fn heights<R: Traced>(&self, p: Vec3<R>) -> [R; 12] {
        let [short, long] = each(self.coordinates, narrow::<R>);
        let mut heights = [R::ZERO; 12];
        for (axis, of) in heights.chunks_exact_mut(4).enumerate() {
            let (x, y) = (short * p[(axis + 1) % 3], long * p[(axis + 2) % 3]);
            of.copy_from_slice(&[x + y, x - y, y - x, -(x + y)]);
        }
        heights
    }

    /// The facets of the icosahedron whose cones a stretch meets: a bit for each.
    ///
    /// With the vertices a, b and c of a facet, whose scalar products with each other are k = 1/√5, the plane through
    /// the centre, b and c has the normal b × c, whose product with p is √(1 + 2k) ≈ 1.38 times
    /// a·p − (a + b + c)·p · k / (1 + 2k), and k / (1 + 2k) = √5 − 2.
    fn facets<R: Traced>(&self, stretch: &Stretch<R>) -> u32 {
        let share = narrow::<R>(self.share);
        let heights = each(stretch.ends, |end| self.heights(end));
        let mut near = 0;
        for (bit, corners) in (0..).zip(FACES) {
            let beyond = each([0, 1], |end: usize| {
                let of = each(corners, |i| heights[end][i]);
                let level = share * (of[0] + of[1] + of[2]);
                each(of, |height| height - level)
            });
            let [a, b, c] = each([0, 1, 2], |i: usize| {
                beyond[0][i].max(beyond[1][i]) >= -stretch.tolerance
            });
            near |= u32::from(a & b & c) << bit;
        }
        near
    }

    /// The distance from the line, coordinate by coordinate in the sheared space, within which facets are looked at.
    /// `None` for noise of the order of the facets, which are about 2^−splits across: nothing would be known about the
    /// line, and all facets would be looked at.
    fn slack<R: Traced>(&self, view: &View<R>) -> Option<R> {
        let finest = R::of(1.0 / 16.0 / f64::from(1 << self.record.splits));
        let slack = R::of(SEARCH_ROUNDOFFS) * R::ROUNDOFF + view.noise;
        // False for NaN.
        (view.noise <= finest).then_some(slack)
    }

    /// The t and the face of a crossing, from the depth and the face of a passage.
    fn root<R: Traced>(&self, view: &View<R>, (depth, face): (R, u32)) -> (R, u32) {
        let radius = R::of(self.record.radius);
        ((view.depth + depth) * radius / view.shear.pace, face)
    }

    /// The vertices of the icosahedron on the unit sphere.
    pub fn icosahedron<R: Traced>(&self) -> [Vec3<R>; 12] {
        let [short, long] = each(self.coordinates, narrow::<R>);
        let mut vertices = [Vec3::ZERO; 12];
        for (i, v) in vertices.iter_mut().enumerate() {
            v[(i / 4 + 1) % 3] = if i & 2 == 0 { short } else { -short };
            v[(i / 4 + 2) % 3] = if i & 1 == 0 { long } else { -long };
        }
        vertices
    }

    /// The corners of a facet, on the unit sphere. Its number is that of the icosahedron's facet
    /// followed by the quarter taken at each split, in base 4.
    pub(super) fn corners<R: Traced>(&self, face: u32) -> [Vec3<R>; 3] {
        self.facet(face, self.record.splits, Middles::new::<R>(self))
    }

    /// The corners of facet `face` after `splits` splits.
    fn facet<R: Traced>(&self, face: u32, splits: u32, known: Middles) -> [Vec3<R>; 3] {
        let vertices = self.icosahedron();
        let base = (face >> (2 * splits)) as usize % FACES.len();
        let mut corners = each(FACES[base], |i| vertices[i]);
        for level in 0..splits {
            let split = face >> (2 * (splits - level - 1));
            let middles = known.of(corners, split >> 2, level);
            corners = quarter(corners, middles, split & 3);
        }
        corners
    }

    /// Finds the facets that the line passes on some stretches. A facet that both stretches reach counts twice.
    fn meet<R: Traced>(&self, view: &View<R>, stretches: &[Stretch<R>]) -> Met<R> {
        let mut met = Met::default();
        for stretch in stretches {
            self.descend(stretch, |corners, face| {
                met.consider(view, each(corners, |at| view.project(at)), face);
            });
        }
        met
    }

    /// Calls `leaf` with the corners and numbers of all facets whose cones a stretch meets.
    fn descend<R: Traced>(&self, stretch: &Stretch<R>, mut leaf: impl FnMut([Vec3<R>; 3], u32)) {
        let known = Middles::new::<R>(self);
        let split = |corners, face, level| {
            let middles = known.of(corners, face, level);
            PendingFacet {
                corners,
                middles,
                face,
                near: stretch.quarters(middles),
            }
        };
        let vertices = self.icosahedron();
        let mut stack = [PendingFacet::default(); MAX_SPLITS as usize];
        let mut facets = self.facets(stretch);
        while facets != 0 {
            let face = facets.trailing_zeros();
            facets &= facets - 1;
            let corners = each(FACES[face as usize], |i| vertices[i]);
            if self.record.splits == 0 {
                leaf(corners, face);
                continue;
            }
            stack[0] = split(corners, face, 0);
            let mut depth = 1;
            while depth > 0 {
                let frame = &mut stack[depth as usize - 1];
                if frame.near == 0 {
                    depth -= 1;
                    continue;
                }
                let index = frame.near.trailing_zeros();
                frame.near &= frame.near - 1;
                let corners = quarter(frame.corners, frame.middles, index);
                let face = frame.face * 4 + index;
                if depth == self.record.splits {
                    leaf(corners, face);
                } else {
                    stack[depth as usize] = split(corners, face, depth);
                    depth += 1;
                }
            }
        }
    }
}

/// The facets that a line passes.
#[derive(Default)]
struct Met<R> {
    /// The depths at which the line goes in and goes out, each with the number of the facet.
    passages: [Option<(R, u32)>; 2],
    /// Whether the line may pass some facet.
    possible: bool,
    /// Whether the line goes in for certain, and out.
    certain: [bool; 2],
}

impl<R: Traced> Met<R> {
    fn consider(&mut self, view: &View<R>, corners: [Projected<R>; 3], number: u32) {
        let facet = Facet::new(corners);
        for (verdict, certain) in facet.verdicts(view.noise).iter().zip(&mut self.certain) {
            self.possible |= verdict.possible;
            *certain |= verdict.certain;
        }
        let Some(Passage { way, depth, .. }) = facet.passage() else {
            return;
        };
        let (side, sign) = match way {
            PassageDirection::In => (0, R::ONE),
            PassageDirection::Out => (1, -R::ONE),
        };
        // The facet with the lowest number counts among those at one depth, so that their order does not matter.
        let is_first =
            |(z, other): (R, u32)| depth * sign < z * sign || depth == z && number < other;
        if self.passages[side].is_none_or(is_first) {
            self.passages[side] = Some((depth, number));
        }
    }
}

/// The distance from the centre that no point of a facet is below, after some splits of an icosahedron on the unit
/// sphere with edges of length `edge`.
///
/// A facet with corners on the unit sphere and edges up to L long: where its point with barycentric
/// weights α, β, γ lies at distance q from the centre, 1 − q² = αβ|ab|² + βγ|bc|² + γα|ca|² ≤ L²/3.
/// An edge's middle is √(1 − L²/4) or more from the centre, and pushing points
/// that far out onto the sphere stretches their distances by at most the inverse of that; so after
/// the next split no edge is longer than L / 2√(1 − L²/4). The factor 1 − 10⁻¹⁴ covers
/// the rounding.
fn inner_radius(edge: f64, splits: u32) -> f64 {
    let l2 = (0..splits).fold(edge * edge, |l2, _| l2 / (4.0 - l2));
    (1.0 - l2 / 3.0).sqrt() * (1.0 - 1e-14)
}

/// Bound on the rounding in the search, in units of ROUNDOFF.
///
/// A new vertex has 6 roundings of its own, and the errors of the ends of its edge, which pushing
/// the middle out stretches: over all splits by less than 1.26. Ten levels make 76 units, stretched
/// by the shear up to √3 times: 132. The projection of a point, relative to one on the line and up
/// to 2.1 from it, has 4 roundings of at most 4.2 in all, 17 units.
pub const SEARCH_ROUNDOFFS: f64 = 160.0;

impl<R: Traced> View<R> {
    fn of(line: &Line<R>, radius: R) -> Sight<R> {
        let shear = Shear::along(line.direction);
        let e = shear.slope;
        let square = e.dot(e);
        let origin = line.origin / radius;
        let mut nearest = origin;
        let mut depth = R::ZERO;
        // The second step takes away the rounding of the first.
        for _ in 0..2 {
            let step = -nearest.dot(e) / square;
            nearest = nearest + e * step;
            depth += step;
        }
        // The origin over the radius, the slope, its product with the step and the sum have a
        // rounding each, of numbers up to |origin| and 2 |origin|: 7 in all, and some more for the
        // second step. The shear stretches them up to √3 times.
        let size = origin[0].abs() + origin[1].abs() + origin[2].abs();
        let noise = R::gamma(20) * size
            + R::of(SEARCH_ROUNDOFFS) * R::ROUNDOFF
            + drift_across(line, radius) / radius;
        let beyond = R::ONE + noise;
        let distance = nearest.dot(nearest);
        // The square rounds by γ₄. The nearest point is off along the line by less than the noise, which adds less
        // than half of noise² to its distance.
        let passes = distance > beyond * beyond * (R::ONE + R::gamma(4)) + noise * noise;
        // The radius may be too large for f32, or too small for what is divided by it.
        if !(radius.is_finite() && distance.is_finite() && depth.is_finite()) {
            Sight::Lost
        } else if passes {
            Sight::Passes
        } else {
            Sight::Near(View {
                shear,
                nearest,
                depth,
                noise,
            })
        }
    }

    fn project(&self, at: Vec3<R>) -> Projected<R> {
        self.shear.project(at - self.nearest)
    }

    /// The two stretches of the line, on the way in and on the way out, on which it may come within `slack` of a facet
    /// in the sheared space, coordinate by coordinate; `None` if it stays farther away. No facet is nearer to the
    /// centre than `inner`.
    ///
    /// A point P of a facet and the line's point Q at the same depth are √2 slack apart at most. The slack is 160 units
    /// of roundoff or more, the facet's corners are off by 76 units, and what is computed here by 20.
    ///
    /// So Q is between the radii inner − 2 slack and 1 + 2 slack. The squares of the radii are widened by more than
    /// three times what these differences make of them.
    ///
    /// The true corners of the facet are on the inner side of the planes of all cones that it is in. Corners that are
    /// off by 76 units make normals, of length 1 at most, that are off by 160. Along such a normal P is above
    /// −236 units, and Q above −√2 slack − 256 units, which is above −4 slack.
    fn stretches(&self, inner: R, slack: R) -> Option<[Stretch<R>; 2]> {
        let (nearest, slope) = (self.nearest, self.shear.slope);
        let square = slope.dot(slope);
        // The nearest point is not quite the nearest.
        let aside = nearest.dot(slope);
        let middle = -aside / square;
        let distance = nearest.dot(nearest) + aside * middle;
        let far = R::of(16.0) * slack;
        let outside = R::ONE + far - distance;
        // False for NaN.
        let is_near = outside >= R::ZERO;
        if !is_near {
            return None;
        }
        let inside = (inner * inner - far - distance).max(R::ZERO);
        let [out, start] = each([outside, inside], |x| (x / square).sqrt());
        let at = |depth: R| nearest + slope * depth;
        let tolerance = R::of(4.0) * slack;
        let ends = [
            [middle - out, middle - start],
            [middle + start, middle + out],
        ];
        Some(each(ends, |ends| Stretch {
            ends: each(ends, at),
            tolerance,
        }))
    }
}

impl Shape for GeodesicSphere {
    fn outline(&self) -> Outline {
        Outline::around(Form::sphere(Vec3::ZERO, self.record.radius))
    }

    fn bounds(&self) -> Aabb {
        let r = Vec3::ONE * self.record.radius;
        Aabb::new(-r, r).padded()
    }

    /// The surface coordinates of the sphere in the point's direction.
    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let p = point.unit();
        let v = libm::acos((-p[1]).clamp(-1.0, 1.0)) / PI;
        [libm::atan2(-p[2], p[0]).rem_euclid(TAU) / TAU, v]
    }

    fn holds(&self, point: Vec3) -> bool {
        self.record.holds(point.0)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn support(&self, _: u32) -> Option<Support> {
        None
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.record.radius);
        sink(f64::from(self.record.splits));
    }
}

impl<R: Traced> Intersect<R> for GeodesicSphere {
    /// Finds the facets met on the way in and on the way out: one of each, or several that share the edge or corner
    /// where the line passes, of which the outermost counts. The projected facets cover each point of the plane as
    /// often one way as the other, whatever the rounding of their common corners, so a line that goes in always goes
    /// out.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let view = match View::of(line, R::of(self.record.radius)) {
            Sight::Passes => return,
            Sight::Lost => {
                roots.uncertain = true;
                return;
            }
            Sight::Near(view) => view,
        };
        let slack = self.slack(&view);
        let stretches = view.stretches(
            R::of(self.inner),
            slack.unwrap_or(R::of(SEARCH_ROUNDOFFS) * R::ROUNDOFF),
        );
        let met = self.meet(&view, stretches.as_ref().map_or(&[], |both| &both[..]));
        roots.uncertain = slack.is_none() || met.possible && met.certain != [true; 2];
        let [Some(near), Some(far)] = met.passages else {
            return;
        };
        let [near, far] = each([near, far], |passage| self.root(&view, passage));
        if view.shear.pace > R::ZERO {
            roots.chord(near, far);
        } else {
            roots.chord(far, near);
        }
        // A chord too short for the numbers was dropped.
        roots.uncertain |= roots.list.is_empty();
    }

    /// Finds the first crossing alone for a line that goes through the ball within all facets. Such lines enter the
    /// solid on one stretch and leave it on another, and only the first stretch is searched.
    fn first_crossings(&self, line: &Line<R>, near: R, roots: &mut Roots<R>) {
        let radius = R::of(self.record.radius);
        if let Sight::Near(view) = View::of(line, radius)
            && let Some(slack) = self.slack(&view)
            && let Some(stretches) = view.stretches(R::of(self.inner), slack)
            && stretches[0].ends[1] != stretches[1].ends[0]
        {
            let first = usize::from(view.shear.pace < R::ZERO);
            let met = self.meet(&view, &stretches[first..=first]);
            let size =
                (line.origin.abs().max_component() + radius) / line.direction.abs().max_component();
            if met.certain[first]
                && let Some(passage) = met.passages[first]
                && let (t, face) = self.root(&view, passage)
                && t > near + size * R::of(0.01)
                && t.is_finite()
            {
                roots.push(t, face);
                return;
            }
        }
        self.crossings(line, roots);
    }

    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        let [a, b, c] = self.corners::<R>(root.face);
        let normal = (b - a).cross(c - a);
        Some(normal.unit().dot(line.direction).abs())
    }

    /// The weighted mean of the facet's corners: off by γ₇ Σ|wᵢ vᵢ| (pbrt-v4, section 6.8.5) and
    /// one rounding of the radius; and the corners by 1.26 · 6 roundings a level (see [`SEARCH_ROUNDOFFS`]).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let radius = R::of(self.record.radius);
        let corners = self.corners::<R>(root.face);
        let passage = match View::of(line, radius) {
            Sight::Near(view) => Facet::new(each(corners, |at| view.project(at))).passage(),
            Sight::Passes | Sight::Lost => None,
        };
        let weights = match passage {
            Some(passage) => passage.weights,
            None => [R::ONE / R::of(3.0); 3],
        };
        let (mut point, mut size) = (Vec3::ZERO, Vec3::ZERO);
        for (v, w) in corners.into_iter().zip(weights) {
            point = point + v * w;
            size = size + v.abs() * w;
        }
        let [a, b, c] = corners;
        let of_corners = Vec3::ONE * R::gamma(8 * (self.record.splits + 1));
        Located {
            point: point * radius,
            error: (size * R::gamma(8) + of_corners) * radius,
            normal: (b - a).cross(c - a),
        }
    }
}

#[cfg(test)]
mod tests;
