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

use super::tree::Run;
use crate::trace::number::Real;
use crate::trace::quartic::root_between;
use crate::trace::ray::{Line, Slack};
use crate::trace::shapes::closer::is_last;
use crate::trace::shapes::doubt::is_final;
use crate::trace::vec::Vec3;

/// A line relative to the axis, in scaled coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Path<R> {
    /// The line's own parameter at τ = 0, as a multiple of `unit`, a power of two; τ is in units of
    /// length, of which one of `unit` holds `length`.
    start: R,
    unit: R,
    length: R,
    /// The point at τ = 0, close to the line's closest approach to the shape's centre, and the unit
    /// direction.
    point: Vec3<R>,
    direction: Vec3<R>,
    s0: R,
    delta: R,
    across: R,
    along: R,
    /// Bound on what rounding does to s₀, y₀ and δ.
    rounded: R,
    /// How far, at most, the point and the unit direction are from those of the line that is meant,
    /// whatever the way.
    moved: R,
    turned: R,
    /// What these three do to along times a point's distance from the axis, at the height of p.
    fuzz: R,
    /// Whether a chord level with a seam belongs to the segment below it, not above.
    below: bool,
    /// Bound on the error of s₀, y₀ and δ from all three, where the plane of the line turns with
    /// its direction.
    error: R,
}

/// The ring of a profile point and how the line passes it.
#[derive(Debug, Clone, Copy)]
pub struct Ring<R> {
    pub radius: R,
    pub y: R,
    /// along · s where the line is at the ring's height; equally the distance of the line from
    /// (0, y) in its plane, with a sign.
    offset: R,
    inside: bool,
    uncertain: bool,
    /// along²(ρ² − r²) is at least this.
    least: R,
}

/// A crossing of the line with one segment.
#[derive(Debug, Clone, Copy)]
pub struct Cut<R> {
    pub tau: R,
    /// Bound on the error of τ.
    pub error: R,
    /// The line goes against the segment's normal: towards the axis, down for flat segments.
    pub against: bool,
}

/// The crossings of a line with one segment, not in order.
#[derive(Debug, Clone, Copy)]
pub struct Cuts<R> {
    pub list: [Option<Cut<R>>; 2],
    pub uncertain: bool,
}

/// The power of two 2⁻ᵉ that brings a finite number |x| with 2ᵉ ≤ |x| < 2ᵉ⁺¹ into [1, 2), as far
/// as it and its inverse are normal numbers.
pub fn normaliser(x: f64) -> f64 {
    const EXPONENTS: u64 = 2046;
    let exponent = (x.abs().to_bits() >> 52).clamp(1, EXPONENTS - 1);
    f64::from_bits((EXPONENTS - exponent) << 52)
}

impl<R: Real> Path<R> {
    /// The path of a line past a shape with the centre (0, `centre`, 0) in coordinates scaled by
    /// the power of two `scale`. `None` where the line is out of the numbers' reach.
    pub fn new(line: &Line<R>, scale: f64, centre: f64) -> Option<Path<R>> {
        let origin = line.origin * R::of(scale);
        // In two steps, since the inverse of a subnormal length is no number.
        let first = normaliser(line.direction.abs().max_component().to_f64());
        let exact = line.direction * R::of(first);
        let second = normaliser(exact.abs().max_component().to_f64());
        let exact = exact * R::of(second);
        let length = exact.length();
        let unit = R::of(first) / R::of(scale) * R::of(second);
        let direction = exact / length;
        // The point is exact for the parameter that came out, but for one rounding, however far
        // away the origin is and whatever the parameter's error: the direction is not rounded yet
        // and the parameter a double, whose product with another one is exact in double-double,
        // too. A second pass brings it to where the first one should have got.
        let square = exact.dot(exact);
        let mut start = R::ZERO;
        let mut point = origin;
        for _ in 0..2 {
            let relative = Vec3::new(point[0], point[1] - R::of(centre), point[2]);
            start = R::of((start - relative.dot(exact) / square).to_f64());
            point = origin.zip(exact, |o, d| start.mul_add(d, o));
        }
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
            direction,
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

    /// What the line's slack comes to: √3 ≤ 7/4 times a component's, for the direction over its
    /// length; the point is at |start·unit| on the line's own scale. Where the move to the closest
    /// approach is not fused, its product is rounded, too, unless it is exact.
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

    /// The line's own parameter.
    pub fn t(&self, tau: R) -> R {
        (self.start + tau / self.length) * self.unit
    }

    /// The point at a parameter of the line, in scaled coordinates, and the unit direction.
    pub fn at(&self, t: R) -> (Vec3<R>, Vec3<R>) {
        let tau = (t / self.unit - self.start) * self.length;
        let point = self.point.zip(self.direction, |o, d| tau.mul_add(d, o));
        (point, self.direction)
    }

    /// along · s at the height y.
    fn offset(&self, y: R) -> R {
        R::difference_of_products(self.s0, self.along, self.point[1] - y, self.across)
    }

    /// The absolute values that the offset at the height y is the sum of.
    fn offset_size(&self, y: R) -> R {
        (self.s0 * self.along).abs() + (self.point[1] - y).abs() * self.across
    }

    /// How the line passes a ring: along² (ρ² − r²) = offset² − along² (r − δ)(r + δ), which needs
    /// no division, is negative inside. A line that is level with the ring is outside, and so is,
    /// where decisions are final, one that cannot be told from a touch.
    pub fn ring(&self, [radius, y]: [f64; 2]) -> Ring<R> {
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
            // A point on the axis has nothing inside, nor has the line where it never comes close.
            uncertain: radius > R::ZERO && power.abs() <= bound && !self.is_beyond(radius),
            least: power - bound,
        }
    }

    /// Whether all of the line is surely farther than this from the axis. `ring` adds two squares
    /// then, which cannot come out negative.
    fn is_beyond(&self, radius: R) -> bool {
        self.delta - self.error > radius
    }

    /// A bound on the error of along² (ρ² − r²), where the offset is at most `offset`, the sizes of
    /// its terms are at most `size`, the height is at most `low` above or below the path's point,
    /// and the radius is r.
    ///
    /// along·ρ is the length of the vector along·(x, z) in the ring's plane, whose parts are the
    /// offset and along·δ, and along·r another one. Off by e, the square of a length v changes by at
    /// most (2v + e)e. Rounding adds the errors of the offset, two rounded factors in either product
    /// and their difference, and of δ. What is meant for the point p + m and the direction d + f is,
    /// in the plan, (along + f₁)(p + m) − (y₀ − y + m₁)(d + f), and along + f₁ times r. Then there
    /// are three factors and a difference.
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

    /// Whether the line surely passes all rings of a run on the same side, and so crosses none of
    /// its segments. Sure is here: [`Path::ring`] says so too.
    pub fn misses(&self, run: &Run) -> bool {
        let [inner, outer] = run.radius.map(R::of);
        if self.is_beyond(outer) {
            return true;
        }
        let [low, high] = run.y.map(R::of);
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
        // An error in either of the two numbers that are compared, here and in `ring`, and once
        // more what `ring` takes for a touch. The bound grows with all that it is made of, and
        // heights between have no more of it than one end or the other.
        let size = self.offset_size(low).max(self.offset_size(high));
        let far = (self.point[1] - low)
            .abs()
            .max((self.point[1] - high).abs());
        let bound = self.power_error(size, size, far, outer);
        let slack = bound + bound + bound;
        outside > slack || inside > slack
    }

    /// The crossings with the segment between two rings.
    ///
    /// Between the heights of its ends a segment with the direction (w, h) in (ρ, y) is the set of
    /// h²(s² + δ²) = (h·r + w(y − y₁))², a quadratic aτ² + 2bτ + c once the line is put in. Moved
    /// to the line's closest approach to (0, y₁), N away, where s = N·along and
    /// y = y₁ − N·across, it has
    ///
    ///   a = (h·across − w·along)(h·across + w·along)
    ///   b = along (N·across (h² + w²) − r·h·w)
    ///   b² − ac = h² (E² − a δ²),  E = r·h·across − w·N
    ///
    /// of which every difference is one of two products (Kahan's algorithm). The root at which the
    /// line goes in is (−b − √)/a and the other one (−b + √)/a, whatever the sign of a.
    pub fn segment(&self, first: &Ring<R>, second: &Ring<R>) -> Cuts<R> {
        let mut cuts = Cuts {
            list: [None; 2],
            uncertain: false,
        };
        if first.y == second.y {
            cuts.list[0] = self.level(first, second);
            return cuts;
        }
        // From below, so that a segment is the same in both directions.
        let (low, high) = if first.y < second.y {
            (first, second)
        } else {
            (second, first)
        };
        if low.inside && high.inside || self.is_beyond(low.radius.max(high.radius)) {
            return cuts;
        }
        let (w, h) = (high.radius - low.radius, high.y - low.y);
        let k = R::of(normaliser(w.abs().max(h).to_f64()));
        let (w, h) = (w * k, h * k);
        let (n, r) = (low.offset, low.radius);
        let (x, z) = (self.across, self.along);
        let left = R::difference_of_products(h, x, w, z);
        let right = R::difference_of_products(h, x, -w, z);
        let a = left * right;
        // Both factors have at most six roundings of the unit direction behind them, those of w
        // and h, and what the direction is off by.
        let factor = R::gamma(8) * ((h * x).abs() + (w * z).abs()) + (h + w.abs()) * self.turned;
        let a_error = factor * (left.abs() + right.abs() + factor) + R::gamma(2) * a.abs();

        let both = low.inside == high.inside;
        if both {
            // Outside of both rings. As a function of the height along²(ρ² − r²) has the second
            // derivative 2a/h²: on the way from one ring to the other, h/k high, it falls no lower
            // than a/4k² below the lesser of its values there. And where a is negative, not at all.
            let dip = a + a_error;
            if dip <= R::ZERO || dip < R::of(4.0) * k * k * low.least.min(high.least) {
                return cuts;
            }
        }
        let e = R::difference_of_products(r * h, x, w, n);
        let delta2 = self.delta.square();
        let d = R::difference_of_products(e, e, a * self.delta, self.delta);
        if both {
            // The frustum is convex: there is a chord between the rings if the line meets the cone
            // at all and the chord's middle, s = w·along·E / a, lies between the two heights.
            // Half-open, and in offsets, which neighbours share: what one of them leaves to the
            // other the other takes.
            let middle = z.square() * w * e;
            let (bottom, top) = (low.offset * a, high.offset * a);
            // E's two products have three and two roundings, N its own error.
            let n_error = self.offset_error(low.y);
            let e_error = R::gamma(8) * ((r * h * x).abs() + (w * n).abs())
                + w.abs() * n_error
                + r * h * self.turned;
            let bound = (e.abs() + e.abs() + e_error) * e_error
                + a_error * (self.delta + self.error).square()
                + a.abs() * (self.delta + self.delta + self.error) * self.error
                + R::gamma(6) * (e.square() + a.abs() * delta2);
            let two = R::of(2.0);
            let middle_error = (w * z * z).abs() * e_error
                + (e.abs() + e_error) * w.abs() * self.turned * (two * z.abs() + self.turned)
                + R::gamma(6) * middle.abs();
            let side_error = |ring: &Ring<R>, n_error: R| {
                ring.offset.abs() * a_error + (a.abs() + a_error) * n_error
            };
            let beside = |from: R, to: R, error: R| {
                if to - from > error {
                    Some(true)
                } else if from - to > error {
                    Some(false)
                } else {
                    None
                }
            };
            let sure = [
                (a > a_error).then_some(true),
                beside(bottom, middle, middle_error + side_error(low, n_error)),
                beside(
                    middle,
                    top,
                    middle_error + side_error(high, self.offset_error(high.y)),
                ),
                beside(R::ZERO, d, bound),
            ];
            let touch = if is_last::<R>() { bound } else { R::ZERO };
            if sure.contains(&Some(false)) {
                return cuts;
            }
            cuts.uncertain = sure.contains(&None);
            let between = if self.below {
                bottom < middle && middle <= top
            } else {
                bottom <= middle && middle < top
            };
            if !(a > R::ZERO && between && d > touch) {
                return cuts;
            }
        }
        let root = d.max(R::ZERO).sqrt() * h;
        let b = z * R::difference_of_products(n * x, h.square() + w.square(), r * h, w);
        let s = n * z;
        let radius = R::difference_of_products(r, h, w, n * x);
        let c = R::difference_of_products(h.square(), s.square() + delta2, radius, radius);
        // Both are zero in a line through the apex: the point that all is reckoned from.
        let near = |q: R| if q == R::ZERO { q } else { c / q };
        let (enter, leave) = if b < R::ZERO {
            let q = root - b;
            (near(q), q / a)
        } else {
            let q = -(b + root);
            (q / a, near(q))
        };
        let base = -(self.s0 * x + (self.point[1] - low.y) * z);
        let (from, to) = (self.reach(low), self.reach(high));
        let (from, to) = (from.min(to), from.max(to));
        let cut = |local: R, against: bool| {
            // No farther than the rings at the segment's ends: whatever its error, the crossing
            // stays on its own side of the seams, and of the middle of a chord.
            let mut tau = base + local;
            if z != R::ZERO {
                let (mut from, mut to) = (from, to);
                if both {
                    let middle = (base - b / a).max(from).min(to);
                    *(if against { &mut to } else { &mut from }) = middle;
                }
                tau = self.polished([w, h], low, tau, (from, to), against);
            }
            let local = (tau - base).abs();
            // The quadratic is a difference of two squares with at most sixteen roundings; its
            // slope at a root is twice the root of the discriminant, and less than that up to where
            // an error takes it only while the discriminant stays positive: the root moves by at
            // most error/√ then. If it may not, the vertex is within √(error/|a|), the other root
            // as far beyond it, and another such step takes the quadratic out of its error; one
            // more is for what the error grows by on the way. And the root never moves by more
            // than from one ring to the other.
            let size = (r * h).abs()
                + (w * n).abs()
                + h * (s.abs() + x * local + self.delta)
                + (w * z).abs() * local;
            let shift = self.rounded + self.moved + self.turned * tau.abs();
            let noise = R::gamma(16) * size.square() + (size + size) * (h + w.abs()) * shift;
            let reach = if root.square() > a.abs() * noise {
                noise / root
            } else {
                let four = R::of(4.0);
                let parabola = four * (noise / a.abs()).sqrt();
                parabola.min(to - from + (shift + shift) / z.abs())
            };
            Cut {
                tau,
                error: reach,
                against,
            }
        };
        if both {
            cuts.list = [Some(cut(enter, true)), Some(cut(leave, false))];
        } else {
            // Upwards, it goes in where the lower ring is the one that is passed outside.
            let against = high.inside == (z > R::ZERO);
            cuts.list[0] = Some(cut(if against { enter } else { leave }, against));
        }
        cuts
    }

    /// A closer bound on the error of a crossing between two rings, from f = h(ρ − r) − w(y − y₁)
    /// at the line's own points.
    ///
    /// The line that is meant has an f that is off by `noise` at most. Where f keeps half of its
    /// slope as far as 2·noise/|slope|, it has a root no farther than that. The slope changes with
    /// ρ″ = across²·δ²/ρ³, and with the direction.
    pub fn closer_error(&self, cut: Cut<R>, first: &Ring<R>, second: &Ring<R>) -> R {
        let (low, high) = if first.y < second.y {
            (first, second)
        } else {
            (second, first)
        };
        let (w, h) = (high.radius - low.radius, high.y - low.y);
        if h == R::ZERO {
            return cut.error;
        }
        let k = R::of(normaliser(w.abs().max(h).to_f64()));
        let (w, h) = (w * k, h * k);
        let (x, z, tau) = (self.across, self.along, cut.tau);
        let s = self.s0 + tau * x;
        let rho = (s.square() + self.delta.square()).sqrt();
        let y = self.point[1] + tau * z;
        let f = h * (rho - low.radius) - w * (y - low.y);
        let slope = (h * x * (s / rho) - w * z).abs();
        // Five roundings of a term or less, and of its own terms.
        let terms = rho + low.radius + y.abs() + low.y.abs() + self.s0.abs() + tau.abs();
        let shift = self.rounded + self.moved + self.turned * tau.abs() + R::gamma(8) * terms;
        let noise = (h + w.abs()) * shift + f.abs();
        let reach = (noise + noise) / slope;
        let nearest = (s.abs() - x * reach).max(R::ZERO);
        let least = (nearest.square() + self.delta.square()).sqrt();
        let share = self.delta / least;
        let bend = h * x.square() * share.square() / least * reach;
        // False for NaN.
        if bend + (h + w.abs()) * self.turned <= slope * R::of(0.5) {
            cut.error.min(reach)
        } else {
            cut.error
        }
    }

    /// The root of h(ρ − r) − w(y − y₁) between two places, by Newton's method from `start`.
    ///
    /// The quadratic is reckoned from the ring below, which may be far from where the line meets
    /// the segment, and the roots of lines along its slope suffer from that; this is reckoned from
    /// the line's own points.
    fn polished(&self, [w, h]: [R; 2], low: &Ring<R>, start: R, ends: (R, R), against: bool) -> R {
        let off = |tau: R| {
            let s = self.s0 + tau * self.across;
            let rho = (s.square() + self.delta.square()).sqrt();
            let y = self.point[1] + tau * self.along;
            let slope = if rho > R::ZERO { s / rho } else { R::ZERO };
            (
                h * (rho - low.radius) - w * (y - low.y),
                h * self.across * slope - w * self.along,
            )
        };
        let start = start.max(ends.0).min(ends.1);
        // Eight roundings of its terms are as good as it gets.
        let (value, size) = (off(start).0.abs(), low.radius + low.y.abs());
        let size = size + (start - ends.0).abs().min((start - ends.1).abs());
        if value <= (h + w.abs()) * (self.rounded + R::gamma(8) * size) {
            return start;
        }
        let precision = R::ROUNDOFF * ends.0.abs().max(ends.1.abs());
        root_between(off, ends, !against, start, precision)
    }

    /// τ at the height of a ring; the line must not be level.
    fn reach(&self, ring: &Ring<R>) -> R {
        (ring.y - self.point[1]) / self.along
    }

    /// The crossing with a flat segment.
    fn level(&self, first: &Ring<R>, second: &Ring<R>) -> Option<Cut<R>> {
        (first.inside != second.inside).then(|| {
            let tau = self.reach(first);
            let least = self.along.abs() - self.turned;
            let error = if least > R::ZERO {
                (self.rounded + self.moved + self.turned * tau.abs()) / least
            } else {
                R::INFINITY
            };
            Cut {
                tau,
                error: error + R::gamma(4) * tau.abs(),
                against: self.along < R::ZERO,
            }
        })
    }

    /// A bound on the error of a crossing's t, with a division, a sum and a product.
    pub fn t_error(&self, cut: Cut<R>) -> R {
        let rounded = R::gamma(4) * (self.start.abs() + cut.tau.abs() / self.length);
        (cut.error / self.length + rounded) * self.unit.abs()
    }

    /// The same path, with what is level with a seam counted to the segment below it.
    pub fn seams_below(self) -> Path<R> {
        Path {
            below: true,
            ..self
        }
    }

    /// Whether it is known which of two heights the line reaches first.
    pub fn climbs(&self) -> bool {
        self.along.abs() > self.turned
    }
}

impl<R> Ring<R> {
    pub fn is_uncertain(&self) -> bool {
        self.uncertain
    }
}
