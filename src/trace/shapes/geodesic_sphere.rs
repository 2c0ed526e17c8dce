//! The geodesic sphere: an icosahedron whose facets are split in four again and again, with the new
//! vertices pushed out onto the sphere.
//!
//! The splitting is itself the hierarchy that lines are traced through, so nothing is stored: the
//! corners of a facet are found on the way down to it. A new vertex depends on the two ends of its
//! edge alone, and not on their order, so that neighbours have equal corners, bit for bit. Everything
//! is computed for radius 1 and scaled at the end.

use super::facet::{Facet, Passage, Projected, Shear, Way, drift_across, narrow};
use super::hull;
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
use crate::trace::shapes::support::Support;
use std::f64::consts::{PI, TAU};

/// The language allows no more splits.
pub const MAX_SPLITS: u32 = 9;

#[derive(Debug, Clone, PartialEq)]
pub struct GeodesicSphere {
    radius: f64,
    splits: u32,
    /// 1 / √(1 + φ²) and φ / √(1 + φ²): the icosahedron's coordinates other than 0.
    coordinates: [Dd; 2],
    /// How far from a facet, after so many splits, the facets that it is split into may lie.
    bulges: [f64; MAX_SPLITS as usize + 1],
}

/// A vertex on the unit sphere, and where the line sees it.
#[derive(Debug, Clone, Copy, Default)]
struct Vertex<R> {
    at: Vec3<R>,
    seen: Projected<R>,
}

/// A line as the unit sphere's facets see it.
struct View<R> {
    shear: Shear<R>,
    /// The line's point closest to the centre.
    nearest: Vec3<R>,
    /// The depth of that point, from the line's origin; in radii, as all lengths here.
    depth: R,
    /// Bound on the error of projected coordinates.
    noise: R,
}

/// What is known of a line before any facet is looked at.
enum Sight<R> {
    /// It certainly passes the sphere.
    Passes,
    /// It comes from so far that numbers overflow.
    Lost,
    Near(View<R>),
}

/// A facet on the way down, and how many of its quarters have been seen to.
#[derive(Clone, Copy, Default)]
struct Frame<R> {
    corners: [Vertex<R>; 3],
    /// Of the edges opposite to the corners of the same number.
    middles: [Vertex<R>; 3],
    face: u32,
    next: u32,
}

/// The middle of an edge, pushed out to the sphere.
///
/// Six roundings: the sum, half of the squared length's three, the root, the quotient and the
/// product.
fn middle<R: Traced>(a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
    let sum = a + b;
    sum * sum.dot(sum).sqrt().recip()
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
    /// `splits` up to [`MAX_SPLITS`].
    pub fn new(radius: f64, splits: u32) -> GeodesicSphere {
        let phi = (Dd::ONE + Dd::of(5.0).sqrt()) / Dd::of(2.0);
        let short = Dd::ONE / (Dd::ONE + phi * phi).sqrt();
        GeodesicSphere {
            radius,
            splits: splits.min(MAX_SPLITS),
            coordinates: [short, phi * short],
            bulges: bulges(2.0 * short.to_f64()),
        }
    }

    fn icosahedron<R: Traced>(&self) -> [Vec3<R>; 12] {
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
        let vertices = self.icosahedron();
        let base = (face >> (2 * self.splits)) as usize % FACES.len();
        let mut corners = each(FACES[base], |i| vertices[i]);
        for split in (0..self.splits).rev() {
            let [a, b, c] = corners;
            let middles = [middle(b, c), middle(c, a), middle(a, b)];
            corners = quarter(corners, middles, (face >> (2 * split)) & 3);
        }
        corners
    }

    /// Calls `leaf` with every facet that the line passes at a distance of at most `noise` in the
    /// sheared space, and maybe some more.
    fn visit<R: Traced>(
        &self,
        view: &View<R>,
        noise: R,
        mut leaf: impl FnMut([Projected<R>; 3], u32),
    ) {
        let slack = R::of(SLACK) * R::ROUNDOFF + noise;
        // The shear stretches no vector by more than the length of the slope.
        let stretch = view.shear.slope.length();
        let margins = each(self.bulges, |bulge| R::of(bulge) * stretch + slack);
        let vertices = each(self.icosahedron(), |at| view.vertex(at));
        let mut stack = [Frame::default(); MAX_SPLITS as usize];
        for (face, corners) in (0..).zip(FACES) {
            let corners = each(corners, |i| &vertices[i]);
            if !is_near(corners, margins[0]) {
                continue;
            }
            if self.splits == 0 {
                leaf(each(corners, |c| c.seen), face);
                continue;
            }
            stack[0] = view.split(corners, face);
            let mut depth = 1;
            while depth > 0 {
                let frame = &mut stack[depth - 1];
                let index = frame.next;
                if index == 4 {
                    depth -= 1;
                    continue;
                }
                frame.next += 1;
                let corners = quarter(frame.corners.each_ref(), frame.middles.each_ref(), index);
                let face = frame.face * 4 + index;
                if !is_near(corners, margins[depth]) {
                    continue;
                }
                if depth == self.splits as usize {
                    leaf(each(corners, |c| c.seen), face);
                } else {
                    stack[depth] = view.split(corners, face);
                    depth += 1;
                }
            }
        }
    }
}

/// The distance from a facet within which everything lies that it is split into.
///
/// A facet with corners on the unit sphere and edges up to L long: where its point with barycentric
/// weights α, β, γ lies at distance q from the centre, 1 − q² = αβ|ab|² + βγ|bc|² + γα|ca|² ≤ L²/3.
/// What it is split into is between it and the sphere, straight outwards from its points: at most
/// 1 − √(1 − L²/3) away. An edge's middle is √(1 − L²/4) or more from the centre, and pushing points
/// that far out onto the sphere stretches their distances by at most the inverse of that; so after
/// the next split no edge is longer than L / 2√(1 − L²/4).
fn bulges(edge: f64) -> [f64; MAX_SPLITS as usize + 1] {
    let mut l2 = edge * edge;
    std::array::from_fn(|_| {
        let bulge = (l2 / 3.0) / (1.0 + (1.0 - l2 / 3.0).sqrt());
        l2 /= 4.0 - l2;
        bulge
    })
}

/// What the margins of the search need for rounding, in units of ROUNDOFF.
///
/// A new vertex has 6 roundings of its own, and the errors of the ends of its edge, which pushing
/// the middle out stretches: over all splits by less than 1.26. Ten levels make 76 units, stretched
/// by the shear up to √3 times: 132. The projection of a point, relative to one on the line and up
/// to 2.1 from it, has 4 roundings of at most 4.2 in all, 17 units; the bulge's 5 roundings and the
/// f64 they are done in are a millionth of the bulges themselves apart from the true ones, which the
/// remaining units cover: 2 · 1.74 · 0.21 · 5 = 4.
const SLACK: f64 = 160.0;

/// Whether the origin is in the box around the corners, widened by the margin.
#[inline]
fn is_near<R: Traced>([a, b, c]: [&Vertex<R>; 3], margin: R) -> bool {
    let (a, b, c) = (&a.seen, &b.seen, &c.seen);
    a.x.min(b.x).min(c.x) <= margin
        && a.x.max(b.x).max(c.x) >= -margin
        && a.y.min(b.y).min(c.y) <= margin
        && a.y.max(b.y).max(c.y) >= -margin
}

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
        let noise =
            R::gamma(20) * size + R::of(SLACK) * R::ROUNDOFF + drift_across(line, radius) / radius;
        let beyond = R::ONE + noise;
        let distance = nearest.dot(nearest);
        // The square rounds by γ₄. The nearest point is off along the line by less than the noise,
        // and so the more in distance: by less than half of noise².
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

    fn vertex(&self, at: Vec3<R>) -> Vertex<R> {
        Vertex {
            at,
            seen: self.shear.project(at - self.nearest),
        }
    }

    fn split(&self, corners: [&Vertex<R>; 3], face: u32) -> Frame<R> {
        let [a, b, c] = each(corners, |c| c.at);
        Frame {
            corners: each(corners, |c| *c),
            middles: each([middle(b, c), middle(c, a), middle(a, b)], |m| {
                self.vertex(m)
            }),
            face,
            next: 0,
        }
    }
}

impl Shape for GeodesicSphere {
    fn bounds(&self) -> Aabb {
        let r = Vec3::ONE * self.radius;
        Aabb::new(-r, r).padded()
    }

    fn hull_points(&self) -> Vec<[f64; 3]> {
        hull::of_ellipsoid(Vec3::ZERO, Vec3::ONE * self.radius)
    }

    /// Those of the sphere in the point's direction.
    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        let p = point.unit();
        let v = libm::acos((-p[1]).clamp(-1.0, 1.0)) / PI;
        [libm::atan2(-p[2], p[0]).rem_euclid(TAU) / TAU, v]
    }

    fn is_solid(&self) -> bool {
        true
    }

    fn holds(&self, point: Vec3) -> bool {
        solids::geodesic_sphere::GeodesicSphere {
            radius: self.radius,
            splits: self.splits,
        }
        .holds(point.0)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn support(&self, _: u32) -> Option<Support> {
        None
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.radius);
        sink(f64::from(self.splits));
    }
}

impl<R: Traced> Intersect<R> for GeodesicSphere {
    /// The facets met on the way in and on the way out: one of each, or several that share the edge
    /// or corner where the line passes, of which the outermost counts. The projected facets cover
    /// each point of the plane as often one way as the other, whatever the rounding of their common
    /// corners, so a way in never lacks its way out.
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let view = match View::of(line, R::of(self.radius)) {
            Sight::Passes => return,
            Sight::Lost => {
                roots.uncertain = true;
                return;
            }
            Sight::Near(view) => view,
        };
        // Facets are about 2^−splits across. Noise of that order says nothing about a line, and
        // must not make it look at all of them.
        let finest = R::of(1.0 / 16.0 / f64::from(1 << self.splits));
        // False for NaN.
        let is_known = view.noise <= finest;
        let lost = !is_known;
        let noise = if lost { R::ZERO } else { view.noise };
        let (mut near, mut far) = (None::<(R, u32)>, None::<(R, u32)>);
        let (mut possible, mut certain) = (false, [false; 2]);
        self.visit(&view, noise, |corners, face| {
            let facet = Facet::new(corners);
            for (verdict, certain) in facet.verdicts(view.noise).iter().zip(&mut certain) {
                possible |= verdict.possible;
                *certain |= verdict.certain;
            }
            let Some(Passage { way, depth, .. }) = facet.passage() else {
                return;
            };
            match way {
                Way::In if near.is_none_or(|(z, _)| depth < z) => near = Some((depth, face)),
                Way::Out if far.is_none_or(|(z, _)| depth > z) => far = Some((depth, face)),
                _ => {}
            }
        });
        roots.uncertain = lost || possible && certain != [true; 2];
        let (Some(near), Some(far)) = (near, far) else {
            return;
        };
        let radius = R::of(self.radius);
        let t = |(z, face)| ((view.depth + z) * radius / view.shear.pace, face);
        let (near, far) = (t(near), t(far));
        if view.shear.pace > R::ZERO {
            roots.chord(near, far);
        } else {
            roots.chord(far, near);
        }
        // A chord too short for the numbers.
        roots.uncertain |= roots.list.is_empty();
    }

    /// The weighted mean of the facet's corners: off by γ₇ Σ|wᵢ vᵢ| (pbrt-v4, section 6.8.5) and
    /// one rounding of the radius; and the corners by 1.26 · 6 roundings a level (see [`SLACK`]).
    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let radius = R::of(self.radius);
        let corners = self.corners::<R>(root.face);
        let passage = match View::of(line, radius) {
            Sight::Near(view) => Facet::new(each(corners, |at| view.vertex(at).seen)).passage(),
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
        let of_corners = Vec3::ONE * R::gamma(8 * (self.splits + 1));
        Located {
            point: point * radius,
            error: (size * R::gamma(8) + of_corners) * radius,
            normal: (b - a).cross(c - a),
        }
    }
}

#[cfg(test)]
mod tests;
