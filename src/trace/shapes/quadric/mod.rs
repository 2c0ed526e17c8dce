//! Surfaces of second degree: the ellipsoid, the general quadric and the canonical ones, which
//! share a [`QuadricForm`] and its meeting with a line ([`Chord`]), and the cones.

mod axial;
pub mod cone;
pub mod ellipsoid;
mod form;
mod line;
mod refine;

pub use axial::Axial;
pub use form::{OPERATIONS, QuadricForm};

use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::Matrix;
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::scene::Geometry;
use crate::solids::shapes::facts::Facts;
use crate::solids::shapes::quadric::Quadric as Record;
use crate::trace::shapes::convex_piece::ConvexPiece;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::quad_double::decide_closer;
use crate::trace::shapes::quick_reject::{Ball, LINE_REL_ERROR, POLYNOMIAL_MARGIN, Pass};
use crate::trace::shapes::support::Support;
use line::Chord;
use std::f64::consts::TAU;

/// The solid F(x) ≤ 0 of a polynomial of second degree, bounded or not.
#[derive(Debug, Clone, PartialEq)]
pub struct Quadric {
    /// The geometry of the record.
    geometry: Box<Geometry>,
    form: QuadricForm,
    bounds: Aabb,
    convex: bool,
    /// Bounds on the summed sizes of the terms of second, first and no degree, for coordinates up to 1.
    sizes: [f64; 3],
    /// For a bounded quadric the centre and radius of a ball around it, and a bound on the sizes of all terms in there.
    ball: Option<(Vec3, f64, f64)>,
}

impl Quadric {
    /// The quadric of a record; `geometry` is the same shape.
    pub fn new(geometry: &Geometry, record: &Record) -> Quadric {
        let form = match *record {
            Record::General(q) => QuadricForm::symmetric_part(q),
            Record::ParabolicCylinder { a } => {
                QuadricForm::canonical([1.0, 0.0, 0.0], -1.0, 0.0, [a, 1.0, 1.0])
            }
            Record::HyperbolicCylinder { a, b } => {
                QuadricForm::canonical([1.0, -1.0, 0.0], 0.0, -1.0, [a, b, 1.0])
            }
            Record::Hyperboloid { a, b, c, sheets } => {
                let constant = if sheets == 2 { 1.0 } else { -1.0 };
                QuadricForm::canonical([1.0, -1.0, 1.0], 0.0, constant, [a, b, c])
            }
            Record::HyperbolicParaboloid { a, b } => {
                QuadricForm::canonical([1.0, 0.0, -1.0], -1.0, 0.0, [a, 1.0, b])
            }
        };
        let bounds = record.bounds(&Matrix::IDENTITY).padded();
        let sizes = form.sizes();
        let ball = bounds.is_bounded().then(|| {
            let radius = bounds.radius();
            let size = size(sizes, bounds.reach() + radius);
            (Vec3(bounds.centre()), radius, size)
        });
        Quadric {
            geometry: Box::new(geometry.clone()),
            form,
            bounds,
            // Ellipsoids alone are bounded.
            convex: ball.is_some() || matches!(record, Record::ParabolicCylinder { .. }),
            sizes,
            ball,
        }
    }

    /// Whether F is positive on the whole line, by more than rounding and the line's slack can change.
    ///
    /// Along the line F is a t² + b t + c. The sizes of the terms of a, b and c, where all coordinates are as large as
    /// the largest one, bound the errors that rounding and the line's slack cause in the three.
    fn is_missed(&self, line: &Line) -> bool {
        let [reach, pace] = each([line.origin, line.direction], |v| v.abs().max_component());
        let slack = line.slack;
        if !(slack.origin <= LINE_REL_ERROR * reach && slack.direction <= LINE_REL_ERROR * pace) {
            return false;
        }
        let unit = self.form.units();
        let [p, d] = each([line.origin, line.direction], |v| v.zip(unit, |x, s| x / s));
        let [a, b, c] = self.form.along(p, d);
        let [second, first, _] = self.sizes;
        let sizes = [
            second * pace * pace,
            (2.0 * second * reach + first) * pace,
            size(self.sizes, reach),
        ];
        let least = POLYNOMIAL_MARGIN * (sizes[1] * sizes[1] + 4.0 * sizes[0] * sizes[2]);
        least.is_normal() && a > POLYNOMIAL_MARGIN * sizes[0] && 4.0 * a * c - b * b > least
    }
}

/// Size of all terms together for coordinates up to `reach`, from the sizes of the terms for coordinates up to 1.
fn size([second, first, constant]: [f64; 3], reach: f64) -> f64 {
    (second * reach + first) * reach + constant
}

/// The angle about the y axis, as a share of a full turn.
fn turn(p: Vec3) -> f64 {
    libm::atan2(-p[2], p[0]).rem_euclid(TAU) / TAU
}

impl Shape for Quadric {
    fn outline(&self) -> Outline {
        Outline::exact(Form::Quadric(self.form.polynomial()))
    }

    fn convex_piece(&self) -> Option<ConvexPiece> {
        ConvexPiece::all_of(&self.form.polynomial())
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn extent(&self) -> f64 {
        if self.bounds.is_bounded() {
            self.bounds.reach()
        } else {
            self.form.extent()
        }
    }

    /// A line is beside an unbounded solid if F is positive on the whole line. An ellipsoid is judged by the least
    /// value of F on the stretch.
    fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        let Some((centre, radius, size)) = self.ball else {
            return match self.is_missed(line) {
                true => Pass::Beside,
                false => Pass::Perhaps,
            };
        };
        let approach = match Ball::meets(line, stretch, centre, radius) {
            Ball::Misses => return Pass::Beside,
            Ball::Unknown => return Pass::Perhaps,
            Ball::Meets(approach) => approach,
        };
        let [a, b, c] = self.form.along(centre + approach.point, approach.direction);
        let margin = POLYNOMIAL_MARGIN * size;
        let value = |t: f64| (a * t + b) * t + c;
        let [from, to] = approach.stretch;
        let lowest = (-b / (a + a)).max(from).min(to);
        if margin.is_normal() && a > 0.0 && value(lowest) > margin {
            return Pass::Beside;
        }
        approach.through(lowest, margin, value)
    }

    fn uv(&self, point: Vec3, _: u32) -> [f64; 2] {
        [turn(point), point[1]]
    }

    fn is_convex(&self) -> bool {
        self.convex
    }

    fn holds(&self, point: Vec3) -> bool {
        self.geometry.holds(point.0)
    }

    fn support(&self, _: u32) -> Option<Support> {
        None
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.form.feed(sink);
    }
}

impl<R: Traced> Intersect<R> for Quadric {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        Chord::new(&self.form, line).append(roots);
        decide_closer(line, roots, |line, roots| {
            Chord::new(&self.form, line).append(roots);
        });
        if self.form.is_summed_closely::<R>() {
            self.form.refine(line, roots);
        }
    }

    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        Some(self.form.speed(line, root.t))
    }

    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        self.form.locate(line, root.t)
    }
}
