//! A line as a solid of revolution sees it.
//!
//! In the plane through the line and parallel to the axis the line is straight: with s across and
//! y along the axis it is (s, y) = (s₀ + τ·across, y₀ + τ·along), and its distance from the axis is
//! ρ² = s² + δ² with δ the plane's distance from the axis.
//!
//! Which segments are crossed is decided at the profile's points, not on the segments. The line
//! crosses the plane of each point's ring either inside the ring or outside; a segment is crossed
//! once if its two ends disagree, and never or twice if they agree. Neighbours share the decision
//! on the ring between them, so whatever the rounding, the crossings of a closed profile are even
//! in number and the line changes sides at each.

mod cut;

pub(super) use cut::Cut;

use super::tree::Run;
use crate::geometry::affine::Slack;
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::trace::shapes::error_bound::is_final;
use crate::trace::shapes::quad_double::is_last;

/// A line relative to the axis, in scaled coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Path<R> {
    /// The line's own parameter t at τ = 0, as a multiple of `unit`, which is a power of two. τ counts in units of
    /// length: while t grows by `unit`, τ grows by `length`.
    start: R,
    unit: R,
    length: R,
    /// The point at τ = 0, close to the line's closest approach to the shape's centre.
    point: Vec3<R>,
    s0: R,
    delta: R,
    across: R,
    along: R,
    /// Bound on what rounding does to s₀, y₀ and δ.
    rounded: R,
    /// Bounds on how far the point and the unit direction are from those of the line that is meant, in any direction.
    moved: R,
    turned: R,
    /// Bound on the effect of `rounded`, `moved` and `turned` on along times a point's distance from the axis, at the
    /// height of `point`.
    fuzz: R,
    /// Whether a chord level with a seam belongs to the segment below it, not above.
    below: bool,
    /// Bound on the error of s₀, y₀ and δ from `rounded`, `moved` and `turned`, where the plane of the line turns with
    /// the line's direction.
    error: R,
}

/// The point of a line close to its closest approach to a shape's centre, in scaled coordinates: see [`Path`].
pub(super) struct ClosestApproach<R> {
    start: R,
    unit: R,
    length: R,
    point: Vec3<R>,
    direction: Vec3<R>,
    /// The direction times powers of two, before it is made a unit vector.
    exact: Vec3<R>,
}

/// The ring of a profile point and how the line passes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring<R> {
    pub radius: R,
    pub y: R,
    /// along · s where the line is at the ring's height; equally the distance of the line from
    /// (0, y) in its plane, with a sign.
    offset: R,
    inside: bool,
    uncertain: bool,
    /// A lower bound on along²(ρ² − r²).
    least: R,
}

/// The power of two 2⁻ᵉ that brings a finite number |x| with 2ᵉ ≤ |x| < 2ᵉ⁺¹ into [1, 2), as far as the power and its
/// inverse are normal numbers.
pub(super) fn normaliser(x: f64) -> f64 {
    const EXPONENTS: u64 = 2046;
    let exponent = (x.abs().to_bits() >> 52).clamp(1, EXPONENTS - 1);
    f64::from_bits((EXPONENTS - exponent) << 52)
}

impl<R: Traced> ClosestApproach<R> {
    /// The approach of a line to a shape with the centre (0, `centre`, 0), in coordinates scaled by the power of two
    /// `scale`.
    #[inline(always)]
    pub(super) fn new(line: &Line<R>, scale: f64, centre: f64) -> ClosestApproach<R> {
        let origin = line.origin * R::of(scale);
        // The scaling takes two steps, since the inverse of a subnormal length is no number.
        let first = normaliser(line.direction.abs().max_component().to_f64());
        let exact = line.direction * R::of(first);
        let second = normaliser(exact.abs().max_component().to_f64());
        let exact = exact * R::of(second);
        let length = exact.length();
        let unit = R::of(first) / R::of(scale) * R::of(second);
        let direction = exact / length;
        // The point is exact for the computed parameter, but for one rounding, however far away the origin is and
        // whatever the parameter's error. For the direction is not rounded yet and the parameter is a double, whose
        // product with another double is exact in double-double, too. A second pass brings the point to where the
        // first one should have got.
        let square = exact.dot(exact);
        let mut start = R::ZERO;
        let mut point = origin;
        for _ in 0..2 {
            let relative = Vec3::new(point[0], point[1] - R::of(centre), point[2]);
            start = R::of((start - relative.dot(exact) / square).to_f64());
            point = origin.zip(exact, |o, d| start.mul_add(d, o));
        }
        ClosestApproach {
            start,
            unit,
            length,
            point,
            direction,
            exact,
        }
    }

    /// The point at a parameter of the line, in scaled coordinates, and the unit direction.
    pub(super) fn at(&self, t: R) -> (Vec3<R>, Vec3<R>) {
        let tau = (t / self.unit - self.start) * self.length;
        let point = self.point.zip(self.direction, |o, d| tau.mul_add(d, o));
        (point, self.direction)
    }
}

impl<R: Traced> Path<R> {
    /// The path of a line past a shape with the centre (0, `centre`, 0) in coordinates scaled by the power of two
    /// `scale`. `None` where numbers overflow.
    pub(super) fn new(line: &Line<R>, scale: f64, centre: f64) -> Option<Path<R>> {
        let ClosestApproach {
            start,
            unit,
            length,
            point,
            direction,
            exact,
        } = ClosestApproach::new(line, scale, centre);
        let flat = Vec3::new(direction[0], R::ZERO, direction[2]);
        let across = flat.length();
        let (dx, dz) = if across > R::ZERO {
            (direction[0] / across, direction[2] / across)
        } else {
            (R::ONE, R::ZERO)
        };
        let s0 = R::difference_of_products(point[0], dx, -point[2], dz);
        let delta = R::difference_of_products(point[0], dz, point[2], dx).abs();
        // The points have one rounding behind them; (dx, dz) six, the sums two more.
        let rounded = R::gamma(10) * (point[0].abs() + point[1].abs() + point[2].abs());
        let mut path = Path {
            start,
            unit,
            length,
            point,
            s0,
            delta,
            across,
            along: direction[1],
            rounded,
            moved: R::ZERO,
            turned: R::ZERO,
            below: false,
            fuzz: rounded + rounded,
            error: rounded,
        };
        if is_final::<R>() || line.slack != Slack::default() {
            path.stray(line, exact, scale);
        }
        let finite = unit.is_finite() && start.is_finite() && point.is_finite();
        let finite = finite && across.is_finite() && s0.is_finite() && delta.is_finite();
        (finite && path.error.is_finite()).then_some(path)
    }

    /// Adds the line's slack to the bounds. A length is at most √3 ≤ 7/4 times its largest component. The slack of the
    /// direction is divided by the direction's length. The point is at |start·unit| on the line's own scale. Where the
    /// move to the closest approach is not fused, its product is rounded, too, unless it is exact.
    ///
    /// A direction that turns in the plan moves s₀ and δ by at most the chord between the two unit
    /// vectors times their size: less than twice the sine of the angle, and never more than two.
    fn stray(&mut self, line: &Line<R>, exact: Vec3<R>, scale: f64) {
        const DIAGONAL: f64 = 1.75;
        let diagonal = R::of(DIAGONAL);
        let drift = line.slack.origin + line.slack.direction * (self.start * self.unit).abs();
        let lost = exact.map(|x| {
            if !is_final::<R>() || x == R::of(x.to_f64()) {
                R::ZERO
            } else {
                (x * self.start).abs() * R::gamma(4)
            }
        });
        self.moved = diagonal * (drift * R::of(scale) + lost.max_component());
        // `unit` holds the direction's and the shape's power of two; the latter has to go again.
        self.turned = diagonal * (line.slack.direction * (self.unit * R::of(scale))) / self.length;
        if self.turned > R::ZERO {
            let two = R::of(2.0);
            let swing = (two * (self.turned / self.across)).min(two);
            self.error += swing * (self.s0.abs() + self.delta);
        }
        self.error += self.moved;
        // m·(along + across + 2f): neither exceeds 1, nor both √2.
        let both = self.moved * (R::of(1.5) + self.turned + self.turned);
        self.fuzz += both + self.turned * (self.s0.abs() + self.delta);
    }

    /// The parameter t of the original line at the path's parameter τ.
    pub(super) fn t(&self, tau: R) -> R {
        (self.start + tau / self.length) * self.unit
    }

    /// along · s at the height y.
    fn offset(&self, y: R) -> R {
        R::difference_of_products(self.s0, self.along, self.point[1] - y, self.across)
    }

    /// The absolute values that the offset at the height y is the sum of.
    fn offset_size(&self, y: R) -> R {
        (self.s0 * self.along).abs() + (self.point[1] - y).abs() * self.across
    }

    /// How the line passes the ring of a point (radius, y). The line is inside where along²
    /// (ρ² − r²) = offset² − along² (r − δ)(r + δ), which needs no division, is negative. A line that is level with
    /// the ring is outside. In quad-double a line that cannot be told from a touch is outside, too.
    pub(super) fn ring(&self, [radius, y]: [f64; 2]) -> Ring<R> {
        let (radius, y) = (R::of(radius), R::of(y));
        let offset = self.offset(y);
        let along2 = self.along.square();
        let inner = along2 * (radius - self.delta);
        let power = R::difference_of_products(offset, offset, inner, radius + self.delta);
        let low = (self.point[1] - y).abs();
        let bound = self.power_error(offset.abs(), self.offset_size(y), low, radius);
        let touch = if is_last::<R>() { bound } else { R::ZERO };
        Ring {
            radius,
            y,
            offset,
            inside: power < -touch,
            // A ring on the axis has no inside, and a line that never comes close to the ring is outside.
            uncertain: radius > R::ZERO && power.abs() <= bound && !self.is_beyond(radius),
            least: power - bound,
        }
    }

    /// Whether the whole line is farther than `radius` from the axis, even with rounding. In `ring` the sum of two
    /// squares then cannot come out negative.
    fn is_beyond(&self, radius: R) -> bool {
        self.delta - self.error > radius
    }

    /// A bound on the error of along² (ρ² − r²), where the offset is at most `offset`, the sizes of
    /// its terms are at most `size`, the height is at most `low` above or below the path's point,
    /// and the radius is r.
    ///
    /// along·ρ is the length of the vector along·(x, z) in the ring's plane, whose parts are the offset and along·δ;
    /// along·r is another length. If a vector of length v is off by e, its square changes by at most (2v + e)e.
    /// Rounding adds the errors of the offset, two rounded factors in either product and their difference, and of δ.
    /// For the point p + m and the direction d + f of the line that is meant, the vector is, in the plan,
    /// (along + f₁)(p + m) − (y₀ − y + m₁)(d + f), and the other length is along + f₁ times r. The last term is for
    /// three factors and a difference.
    fn power_error(&self, offset: R, size: R, low: R, radius: R) -> R {
        let across = self.along.abs() * (self.delta + radius);
        let (length, size) = (offset + across, size + across);
        let e = R::gamma(8) * size + self.fuzz + self.turned * (low + radius);
        (length + length + e) * e + R::gamma(8) * length.square()
    }

    /// A bound on the error of an offset, in the plane of the line, which turns with it.
    fn offset_error(&self, y: R) -> R {
        R::gamma(8) * self.offset_size(y)
            + self.error
            + self.turned * (self.s0.abs() + (self.point[1] - y).abs())
    }

    /// Whether the line surely passes all rings of a run on the same side, and so crosses none of its segments. In
    /// that case [`Path::ring`] says so too.
    pub(super) fn misses(&self, run: &Run) -> bool {
        let [inner, outer] = each(run.radius, R::of);
        if self.is_beyond(outer) {
            return true;
        }
        let [low, high] = each(run.y, R::of);
        let (a, b) = (self.offset(low), self.offset(high));
        let (least, most) = if (a < R::ZERO) == (b < R::ZERO) {
            (a.abs().min(b.abs()), a.abs().max(b.abs()))
        } else {
            (R::ZERO, a.abs().max(b.abs()))
        };
        let along2 = self.along.square();
        let across = along2 * self.delta.square();
        let outside = least.square() + across - along2 * outer.square();
        let inside = along2 * inner.square() - across - most.square();
        if outside <= R::ZERO && inside <= R::ZERO {
            return false;
        }
        // Twice the bound is for the errors of the two numbers that are compared, here and in `ring`; a third one is
        // for what `ring` takes for a touch. The bound grows with all that it is made of, and at heights between the
        // ends it is no larger than at one end or the other.
        let size = self.offset_size(low).max(self.offset_size(high));
        let far = (self.point[1] - low)
            .abs()
            .max((self.point[1] - high).abs());
        let bound = self.power_error(size, size, far, outer);
        let slack = bound + bound + bound;
        outside > slack || inside > slack
    }

    /// The same path, with a chord level with a seam counted to the segment below the seam.
    pub(super) fn seams_below(self) -> Path<R> {
        Path {
            below: true,
            ..self
        }
    }

    /// Whether a level line may be at a height.
    pub(super) fn may_be_at(&self, y: f64) -> bool {
        (self.point[1] - R::of(y)).abs() <= self.rounded + self.moved
    }

    /// Whether the line surely rises or surely falls, so that it is known which of two heights it reaches first.
    pub(super) fn climbs(&self) -> bool {
        self.along.abs() > self.turned
    }
}

impl<R> Ring<R> {
    pub(super) fn is_uncertain(&self) -> bool {
        self.uncertain
    }
}
