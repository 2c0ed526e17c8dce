//! The cone and the double cone about the y axis, apex at the origin.

use super::line::{Bounded, Chord, Inside, push_all};
use super::{QuadricForm, turn};
use crate::geometry::Matrix;
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::convex_piece::ConvexPiece;
use crate::trace::shapes::error_bound::is_final;
use crate::trace::shapes::outline::{Form, Outline};
use crate::trace::shapes::quad_double::decide_closer;
use crate::trace::shapes::quick_reject::{Ball, POLYNOMIAL_MARGIN, Pass, is_above};
use crate::trace::shapes::support::Support;
use crate::trace::shapes::{Intersect, Located, Root, Roots, Shape};

/// The part of x² + z² ≤ y² between the apex and y = 1, or, for a double cone, between y = −1 and y = 1. It is scaled
/// by the base radius across the axis, and along the axis by the height, which may be negative.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    form: QuadricForm,
    record: solids::cone::Cone,
    bounds: Aabb,
}

/// The faces: the lateral surface, the base disc at y = height, and a double cone's other disc at y = −height.
const SIDE: u32 = 0;
const BASE: u32 = 1;
const OPPOSITE: u32 = 2;

impl Cone {
    pub fn new(record: solids::cone::Cone) -> Cone {
        let [height, radius] = [record.height, record.radius];
        Cone {
            form: QuadricForm::canonical([1.0, -1.0, 1.0], 0.0, 0.0, [radius, height, radius]),
            bounds: record.bounds(&Matrix::IDENTITY).padded(),
            record,
        }
    }

    pub fn form(&self) -> &QuadricForm {
        &self.form
    }

    /// The height of a single cone; `None` for a double cone.
    pub fn single_height(&self) -> Option<f64> {
        (!self.record.double).then_some(self.record.height)
    }

    /// How a line passes the part of the cone between two heights. The line is beside that part if the form is
    /// positive wherever the line is in the slab between the heights and in the ball around the cone.
    fn pass_between(&self, line: &Line, stretch: [f64; 2], [low, high]: [f64; 2]) -> Pass {
        let (height, radius) = (self.record.height.abs(), self.record.radius);
        let size = (height * height + radius * radius).sqrt();
        let approach = match Ball::meets(line, stretch, Vec3::ZERO, size) {
            Ball::Misses => return Pass::Beside,
            Ball::Unknown => return Pass::Perhaps,
            Ball::Meets(approach) => approach,
        };
        let Some(stretch) = approach.between(1, low, high) else {
            return Pass::Beside;
        };
        let [p, d] = each([approach.point, approach.direction], |v| {
            Vec3::new(v[0] / radius, v[1] / height, v[2] / radius)
        });
        let form = |v: Vec3, w: Vec3| v[0] * w[0] + v[2] * w[2] - v[1] * w[1];
        let margin = POLYNOMIAL_MARGIN * (size / radius.min(height)).powi(2);
        let coefficients @ [a, b, c] = [form(d, d), form(p, d), form(p, p)];
        if is_above(coefficients, stretch, margin) {
            return Pass::Beside;
        }
        // Goes from the stretch's middle towards the deepest place inside, but not to the very end, which is on the
        // base.
        let [middle, half] = [
            0.5 * (stretch[0] + stretch[1]),
            0.45 * (stretch[1] - stretch[0]),
        ];
        let slope = a * middle + b;
        let deepest = if a > 0.0 { (slope / a).abs() } else { half };
        let at = middle - deepest.min(half).copysign(slope);
        approach.through(at, margin, |t| {
            // The place also has to be as far inside of the slab as the margin asks for.
            let y = approach.point[1] + t * approach.direction[1];
            let outside = (low - y).max(y - high) / size;
            (outside * margin / POLYNOMIAL_MARGIN).max((a * t + b + b) * t + c)
        })
    }
}

impl Shape for Cone {
    fn outline(&self) -> Outline {
        Outline::exact(Form::Quadric(self.form.polynomial()))
    }

    fn convex_piece(&self) -> Option<ConvexPiece> {
        let base = [self.record.radius, self.record.height];
        (!self.record.double).then(|| ConvexPiece::turned([[0.0; 2], base]))?
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn pass(&self, line: &Line, stretch: [f64; 2]) -> Pass {
        self.pass_between(line, stretch, [self.bounds.min[1], self.bounds.max[1]])
    }

    /// Each half is convex: a line that leaves one half may meet only the other half.
    fn is_met_again(&self, line: &Line) -> bool {
        let other = match line.origin[1] > 0.0 {
            true => [self.bounds.min[1], 0.0],
            false => [0.0, self.bounds.max[1]],
        };
        let ahead = [0.0, f64::INFINITY];
        self.record.double && self.pass_between(line, ahead, other) != Pass::Beside
    }

    fn uv(&self, p: Vec3, face: u32) -> [f64; 2] {
        let v = if face != SIDE {
            libm::hypot(p[0], p[2]) / self.record.radius
        } else if self.record.double {
            0.5 * (p[1] / self.record.height) + 0.5
        } else {
            p[1] / self.record.height
        };
        [turn(p), v]
    }

    fn is_convex(&self) -> bool {
        !self.record.double
    }

    fn support(&self, face: u32) -> Option<Support> {
        let base = [self.record.radius, self.record.height];
        Some(Support::turned(match face {
            SIDE if self.record.double => return None,
            SIDE => [[0.0; 2], base],
            BASE => [[0.0, base[1]], base],
            _ => [[0.0, -base[1]], [base[0], -base[1]]],
        }))
    }

    fn holds(&self, point: Vec3) -> bool {
        self.record.holds(point.0)
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        sink(self.record.height);
        sink(self.record.radius);
        sink(f64::from(u8::from(self.record.double)));
    }
}

/// A stretch of a line in one half of the infinite double cone, the one where y has the sign of
/// `half`; its ends may be infinite.
struct Stretch<R> {
    from: Bounded<R>,
    to: Bounded<R>,
    half: R,
}

impl Cone {
    /// Cuts a stretch where it passes the base disc of its half, and appends it.
    ///
    /// The part that is left is decided by how far the stretch's ends are below the disc's plane. If neither end is
    /// below, no more than a touch is left. At a finite end that distance is the difference of three terms with at
    /// most six roundings, and has the errors of the end, the origin and the direction as well. An infinite end is
    /// above the plane: a line that has one is no less steep than the cone.
    fn cut<R: Traced>(&self, chord: &Chord<R>, stretch: Stretch<R>, roots: &mut Roots<R>) {
        let Stretch { from, to, half } = stretch;
        if half < R::ZERO && !self.record.double {
            return;
        }
        let rising = half * chord.direction[1];
        let height = half * chord.origin[1];
        let disc = if half > R::ZERO { BASE } else { OPPOSITE };
        let mut close = true;
        let mut below = |end: Bounded<R>| {
            if !end.value.is_finite() {
                return false;
            }
            let step = rising * end.value;
            let left = Bounded {
                value: chord.w - height - step,
                error: R::gamma(6) * (chord.w + height.abs() + step.abs())
                    + rising.abs() * end.error
                    + chord.moved[1]
                    + chord.turned[1] * (end.value.abs() + end.error),
            };
            roots.uncertain |= left.is_doubtful();
            close &= left.is_zero();
            left.value > R::ZERO && !left.is_zero()
        };
        let at = (chord.w - height) / rising;
        let ends = match (below(from), below(to)) {
            (false, false) => {
                // Both ends are on the disc, so that the line lies in it.
                if close {
                    roots.along = Some(Vec3::new(0.0, 1.0, 0.0));
                    roots.uncertain |= !is_final::<R>();
                }
                return;
            }
            (true, true) => [(from.value, SIDE), (to.value, SIDE)],
            (true, false) => [(from.value, SIDE), (at, disc)],
            (false, true) => [(at, disc), (to.value, SIDE)],
        };
        if at.is_nan() {
            roots.uncertain = true;
            return;
        }
        push_all(roots, each(ends, |(tau, face)| (chord.t(tau), face)));
    }

    /// Appends the crossings. Each stretch of the line in the infinite double cone lies in one half of it. The half is
    /// given by the sign of y in the middle of a bounded stretch, and at the infinite end of an unbounded one. The
    /// apex is never compared with a plane through it.
    ///
    /// In the space of the form x² + z² − y², the plane through the origin and a line steeper than the cone has
    /// signature (1, 1). So the discriminant of such a line is never negative, and zero only where the line meets the
    /// apex: a line that is inside everywhere goes through the apex.
    fn append<R: Traced>(&self, chord: &Chord<R>, roots: &mut Roots<R>) {
        roots.uncertain |= chord.uncertain;
        let up = if chord.direction[1] < R::ZERO {
            -R::ONE
        } else {
            R::ONE
        };
        let stretch = |from, to, half| Stretch { from, to, half };
        let end = |value| Bounded {
            value,
            error: R::ZERO,
        };
        let (first, last) = (end(-R::INFINITY), end(R::INFINITY));
        match chord.inside {
            Inside::Nowhere => {}
            Inside::Between(x, y) => {
                if let Some(half) = Cone::half(chord, roots) {
                    self.cut(chord, stretch(x.bounded(), y.bounded(), half), roots);
                }
            }
            Inside::Below(x) => self.cut(chord, stretch(first, x.bounded(), -up), roots),
            Inside::Above(x) => self.cut(chord, stretch(x.bounded(), last, up), roots),
            Inside::Around(x, y) => {
                self.cut(chord, stretch(first, x.bounded(), -up), roots);
                self.cut(chord, stretch(y.bounded(), last, up), roots);
            }
            Inside::Everywhere => {
                // Two stretches that meet at the apex: there the crossings of both halves cancel.
                let apex = chord.middle();
                self.cut(chord, stretch(first, apex, -up), roots);
                self.cut(chord, stretch(apex, last, up), roots);
            }
        }
    }

    /// The half of the double cone that a bounded stretch is in: the sign of y in the stretch's middle. `None` where
    /// the middle may be the apex.
    fn half<R: Traced>(chord: &Chord<R>, roots: &mut Roots<R>) -> Option<R> {
        let (y, slope) = (chord.origin[1], chord.direction[1]);
        let Bounded { value, error } = chord.middle();
        let step = value * slope;
        let middle = Bounded {
            value: y + step,
            error: R::gamma(4) * (y.abs() + step.abs())
                + slope.abs() * error
                + chord.moved[1]
                + chord.turned[1] * (value.abs() + error),
        };
        roots.uncertain |= middle.is_doubtful();
        (!middle.is_zero()).then(|| {
            if middle.value < R::ZERO {
                -R::ONE
            } else {
                R::ONE
            }
        })
    }

    fn decide<R: Traced>(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let mut chord = Chord::new(&self.form, line);
        self.append(&chord, roots);
        if roots.uncertain && chord.sharpen(&self.form) {
            roots.clear();
            self.append(&chord, roots);
        }
    }
}

impl<R: Traced> Intersect<R> for Cone {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        self.decide(line, roots);
        decide_closer(line, roots, |line, roots| self.decide(line, roots));
    }

    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        Some(match root.face {
            SIDE => self.form.speed(line, root.t),
            _ => line.direction[1].abs(),
        })
    }

    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        let height = R::of(self.record.height);
        if root.face == SIDE {
            let mut located: Located<R> = self.form.locate(line, root.t);
            // At the apex of a cone the axis is as good a normal as any.
            if !self.record.double && !located.point.any() {
                located.normal = Vec3::new(R::ZERO, -height, R::ZERO);
            }
            return located;
        }
        // y is the disc's own, exactly; the others come from a t of a few roundings, times d and
        // added to o.
        let side = if root.face == BASE { height } else { -height };
        let step = line.direction * root.t;
        let mut point = line.origin + step;
        point[1] = side;
        let mut error = (line.origin.abs() + step.abs()) * R::gamma(8);
        error[1] = R::ZERO;
        Located {
            point,
            error,
            normal: Vec3::new(R::ZERO, side, R::ZERO),
        }
    }
}
