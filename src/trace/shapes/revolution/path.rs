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
use crate::trace::ray::Line;
use crate::trace::vec::Vec3;

/// A line relative to the axis, in scaled coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Path<R> {
    /// The line's own parameter at τ = 0, and per unit of τ.
    start: R,
    unit: R,
    /// The point at τ = 0, the line's closest approach to the shape's centre, and the unit
    /// direction.
    point: Vec3<R>,
    direction: Vec3<R>,
    s0: R,
    delta: R,
    across: R,
    along: R,
    /// Bound on the error of s₀, y₀ and δ.
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
}

/// A crossing of the line with one segment.
#[derive(Debug, Clone, Copy)]
pub struct Cut<R> {
    pub t: R,
    /// Bound on the error of t.
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
        let direction = line.direction * R::of(first);
        let second = normaliser(direction.abs().max_component().to_f64());
        let direction = direction * R::of(second);
        let length = direction.length();
        let unit = R::of(first) / R::of(scale) * R::of(second) / length;
        let direction = direction / length;
        // The point is exact for the τ that came out, but for one rounding, however far away the
        // origin is and whatever the error of τ. A second pass brings it to where the first one
        // should have got.
        let mut start = R::ZERO;
        let mut point = origin;
        for _ in 0..2 {
            let relative = Vec3::new(point[0], point[1] - R::of(centre), point[2]);
            start -= relative.dot(direction);
            point = origin.zip(direction, |o, d| start.mul_add(d, o));
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
        // The points have one rounding behind them; (dx, dz) five, the sums two more.
        let error = R::gamma(8) * (point[0].abs() + point[1].abs() + point[2].abs());
        let path = Path {
            start,
            unit,
            point,
            direction,
            s0,
            delta,
            across,
            along: direction[1],
            error,
        };
        let finite = unit.is_finite() && start.is_finite() && point.is_finite();
        (finite && across.is_finite() && s0.is_finite() && delta.is_finite()).then_some(path)
    }

    /// The line's own parameter.
    fn t(&self, tau: R) -> R {
        (self.start + tau) * self.unit
    }

    /// The point at a parameter of the line, in scaled coordinates, and the unit direction.
    pub fn at(&self, t: R) -> (Vec3<R>, Vec3<R>) {
        let tau = t / self.unit - self.start;
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
    /// no division, is negative inside. A line that is level with the ring is outside.
    pub fn ring(&self, [radius, y]: [f64; 2]) -> Ring<R> {
        let (radius, y) = (R::of(radius), R::of(y));
        let offset = self.offset(y);
        let along2 = self.along.square();
        let inner = along2 * (radius - self.delta);
        let power = R::difference_of_products(offset, offset, inner, radius + self.delta);
        // (s + e)² − s² ≤ (2|s| + e)e for the offset and δ, whose errors are `error` and, for the
        // offset, that of two rounded factors in either product and of their difference; then
        // three factors and a difference.
        let error = self.offset_error(y);
        let bound = (offset.abs() + offset.abs() + error) * error
            + along2 * (self.delta + self.delta + self.error) * self.error
            + R::gamma(8) * (offset.square() + along2 * (radius.square() + self.delta.square()));
        Ring {
            radius,
            y,
            offset,
            inside: power < R::ZERO,
            // A point on the axis has nothing inside.
            uncertain: radius > R::ZERO && power.abs() <= bound,
        }
    }

    fn offset_error(&self, y: R) -> R {
        R::gamma(8) * self.offset_size(y) + self.error
    }

    /// Whether the line surely passes all rings of a run on the same side, and so crosses none of
    /// its segments. Sure is here: [`Path::ring`] says so too.
    pub fn misses(&self, run: &Run) -> bool {
        let [inner, outer] = run.radius.map(R::of);
        // `ring` adds two squares then, which cannot come out negative.
        if self.delta >= outer {
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
        let size = self.offset_size(low).max(self.offset_size(high));
        // Offsets and squares here and in `ring` have at most eight roundings behind them each.
        let slack =
            R::gamma(20) * (size.square() + along2 * (outer.square() + self.delta.square()));
        let across = along2 * self.delta.square();
        let outside = least.square() + across - along2 * outer.square();
        let inside = along2 * inner.square() - across - most.square();
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
        if low.inside && high.inside {
            return cuts;
        }
        let (w, h) = (high.radius - low.radius, high.y - low.y);
        let k = R::of(normaliser(w.abs().max(h).to_f64()));
        let (w, h) = (w * k, h * k);
        let (n, r) = (low.offset, low.radius);
        let (x, z) = (self.across, self.along);
        let left = R::difference_of_products(h, x, w, z);
        let a = left * R::difference_of_products(h, x, -w, z);
        let e = R::difference_of_products(r * h, x, w, n);
        let delta2 = self.delta.square();
        let d = R::difference_of_products(e, e, a * self.delta, self.delta);

        let both = low.inside == high.inside;
        if both {
            // Outside of both rings. The frustum is convex: there is a chord between them if the
            // line meets the cone at all and the chord's middle, s = w·along·E / a, lies between
            // the two heights. Half-open, and in offsets, which neighbours share: what one of them
            // leaves to the other the other takes.
            let middle = z.square() * w * e;
            if !(a > R::ZERO && low.offset * a <= middle && middle < high.offset * a) {
                return cuts;
            }
            // E's two products have three and two roundings, and N its own error; the factors of a
            // are off by those of the unit direction, six, and w and h.
            let e_error = R::gamma(8) * ((r * h * x).abs() + (w * n).abs())
                + w.abs() * self.offset_error(low.y);
            let steep = (h * x).abs() + (w * z).abs();
            let bound = (e.abs() + e.abs() + e_error) * e_error
                + a * (self.delta + self.delta + self.error) * self.error
                + R::gamma(20) * (e.square() + steep.square() * delta2);
            cuts.uncertain = d.abs() <= bound;
            if d <= R::ZERO || d.is_nan() {
                return cuts;
            }
        } else {
            cuts.uncertain = d < R::ZERO;
        }
        let root = d.max(R::ZERO).sqrt() * h;
        let b = z * R::difference_of_products(n * x, h.square() + w.square(), r * h, w);
        let s = n * z;
        let radius = R::difference_of_products(r, h, w, n * x);
        let c = R::difference_of_products(h.square(), s.square() + delta2, radius, radius);
        let (enter, leave) = if b < R::ZERO {
            let q = root - b;
            (c / q, q / a)
        } else {
            let q = -(b + root);
            (q / a, c / q)
        };
        let base = -(self.s0 * x + (self.point[1] - low.y) * z);
        let cut = |local: R, against: bool| {
            let tau = self.clamped(base + local, low, high);
            let local = (tau - base).abs();
            // The quadratic is a difference of two squares with at most sixteen roundings; its
            // slope at a root is twice the root of the discriminant.
            let size = (r * h).abs()
                + (w * n).abs()
                + h * (s.abs() + x * local + self.delta)
                + (w * z).abs() * local;
            let noise = R::gamma(16) * size.square() + (size + size) * (h + w.abs()) * self.error;
            let reach = if root > R::ZERO {
                noise / (root + root)
            } else {
                R::ZERO
            };
            Cut {
                t: self.t(tau),
                error: (reach + R::gamma(4) * (self.start.abs() + tau.abs())) * self.unit.abs(),
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

    /// τ at the height of a ring; the line must not be level.
    fn reach(&self, ring: &Ring<R>) -> R {
        (ring.y - self.point[1]) / self.along
    }

    /// A root no farther than the rings at the segment's ends, where the line passes them at all:
    /// whatever its error, it stays on its own side of the seams.
    fn clamped(&self, tau: R, low: &Ring<R>, high: &Ring<R>) -> R {
        if self.along == R::ZERO {
            return tau;
        }
        let (a, b) = (self.reach(low), self.reach(high));
        // `max` and `min` take the other number for a NaN.
        tau.max(a.min(b)).min(a.max(b))
    }

    /// The crossing with a flat segment.
    fn level(&self, first: &Ring<R>, second: &Ring<R>) -> Option<Cut<R>> {
        (first.inside != second.inside).then(|| {
            let tau = self.reach(first);
            let tau_error = self.error / self.along.abs() + R::gamma(4) * tau.abs();
            Cut {
                t: self.t(tau),
                error: (tau_error + R::gamma(4) * self.start.abs()) * self.unit.abs(),
                against: self.along < R::ZERO,
            }
        })
    }
}

impl<R> Ring<R> {
    pub fn is_uncertain(&self) -> bool {
        self.uncertain
    }
}
