//! The ellipsoid about the origin.

use super::line::Chord;
use super::{QuadricForm, turn};
use crate::geometry::Matrix;
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::convex_piece::ConvexPiece;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::quick_reject::{Ball, POLYNOMIAL_MARGIN, Pass};
use crate::trace::shapes::support::Support;
use crate::trace::shapes::{Intersect, Located, Root, Roots, Shape};
use std::f64::consts::PI;

/// The unit sphere, scaled. A line is taken to the sphere's space and its origin to the closest
/// approach to the centre there, so the discriminant comes from the part of the offset that is
/// perpendicular to the line (Haines, Günther and Akenine-Möller, "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems, chapter 7).
#[derive(Debug, Clone, PartialEq)]
pub struct Ellipsoid {
    form: QuadricForm,
    record: solids::ellipsoid::Ellipsoid,
    bounds: Aabb,
}

impl Ellipsoid {
    pub fn new(record: solids::ellipsoid::Ellipsoid) -> Ellipsoid {
        Ellipsoid {
            form: QuadricForm::canonical([1.0; 3], 0.0, -1.0, record.semi_axes),
            bounds: record.bounds(&Matrix::IDENTITY).padded(),
            record,
        }
    }

    pub fn form(&self) -> &QuadricForm {
        &self.form
    }
}

impl Shape for Ellipsoid {
    fn outline(&self) -> Outline {
        Outline::exact(Form::Quadric(self.form.polynomial()))
    }

    fn convex_piece(&self) -> Option<ConvexPiece> {
        ConvexPiece::all_of(&self.form.polynomial())
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The line is beside the ellipsoid if the form is positive even at its minimum on the line.
    fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        let [least, .., most] = sorted(self.record.semi_axes);
        let approach = match Ball::meets(line, stretch, Vec3::ZERO, most) {
            Ball::Misses => return Pass::Beside,
            Ball::Unknown => return Pass::Perhaps,
            Ball::Meets(approach) => approach,
        };
        let [p, d] = each([approach.point, approach.direction], |v| {
            Vec3(each([0, 1, 2], |i| v[i] / self.record.semi_axes[i]))
        });
        let (a, b) = (d.dot(d), p.dot(d));
        let form = p.dot(p) - 1.0 - b * b / a;
        // The form counts in semi-axes, so the margin grows with the square of their ratio.
        let margin = POLYNOMIAL_MARGIN * (most / least).powi(2);
        if margin.is_normal() && form > margin {
            return Pass::Beside;
        }
        // The place where the line is deepest inside.
        let [from, to] = approach.stretch;
        let deepest = (-b / a).max(from).min(to);
        let value = |t: f64| (a * t + b + b) * t + p.dot(p) - 1.0;
        approach.through(deepest, margin, value)
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        // The coordinates of the sphere: y is divided by its semi-axis, and the angle about the y axis stays as it is.
        let v = libm::acos((-point[1] / self.record.semi_axes[1]).clamp(-1.0, 1.0)) / PI;
        [turn(point), v]
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
        self.record.semi_axes.into_iter().for_each(sink);
    }
}

fn sorted(mut lengths: [f64; 3]) -> [f64; 3] {
    lengths.sort_by(f64::total_cmp);
    lengths
}

impl<R: Traced> Intersect<R> for Ellipsoid {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        Chord::new(&self.form, line).append(roots);
    }

    fn speed(&self, _: &Line<R>, _: Root<R>) -> Option<R> {
        None
    }

    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        self.form.locate(line, root.t)
    }
}
