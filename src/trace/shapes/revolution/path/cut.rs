//! Crossing of a line with one segment of a profile, once the rings at its ends say that there is one.

use super::{Path, Ring, normaliser};
use crate::geometry::line::Traced;
use crate::trace::quartic::root_between;
use crate::trace::shapes::quad_double::is_last;

/// A crossing of the line with one segment.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cut<R> {
    pub tau: R,
    /// Bound on the error of τ.
    pub error: R,
    /// Whether the line goes against the segment's normal: towards the axis, down for flat segments.
    pub against: bool,
}

/// The crossings of a line with one segment, not in order.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cuts<R> {
    pub list: [Option<Cut<R>>; 2],
    pub uncertain: bool,
}

impl<R: Traced> Path<R> {
    /// The crossings with the segment between two rings.
    ///
    /// Let the segment run from (r, y₁), the first ring, in the direction (w, h) in the plane of (ρ, y). Between the
    /// heights of its ends, its surface is where h²(s² + δ²) = (h·r + w(y − y₁))²; s, δ and τ are as in the
    /// [module](super). With the line's s and y this is a quadratic aτ² + 2bτ + c. If τ is counted
    /// from the line's closest approach to (0, y₁), at the distance N, where s = N·along and y = y₁ − N·across, the
    /// quadratic has
    ///
    ///   a = (h·across − w·along)(h·across + w·along)
    ///   b = along (N·across (h² + w²) − r·h·w)
    ///   b² − ac = h² (E² − a δ²),  E = r·h·across − w·N
    ///
    /// Each difference here is a difference of two products, which Kahan's algorithm computes accurately. The line
    /// enters at the root (−b − √)/a and leaves at (−b + √)/a, whatever the sign of a.
    pub(crate) fn segment(&self, first: &Ring<R>, second: &Ring<R>) -> Cuts<R> {
        let mut cuts = Cuts {
            list: [None; 2],
            uncertain: false,
        };
        if first.y == second.y {
            cuts.list[0] = self.level(first, second);
            return cuts;
        }
        // The segment is taken from its lower end, so that it is the same in both directions.
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
            // The line is outside of both rings. As a function of the height along²(ρ² − r²) has the second derivative
            // 2a/h²: on the way from one ring to the other, h/k high, it falls no lower than a/4k² below the lesser of
            // its values at the rings. Where a is negative, it does not fall below that value at all.
            let dip = a + a_error;
            if dip <= R::ZERO || dip < R::of(4.0) * k * k * low.least.min(high.least) {
                return cuts;
            }
        }
        let e = R::difference_of_products(r * h, x, w, n);
        let delta2 = self.delta.square();
        let d = R::difference_of_products(e, e, a * self.delta, self.delta);
        if both {
            // The frustum is convex: there is a chord between the rings if the line meets the cone at all and the
            // chord's middle, s = w·along·E / a, lies between the two heights. The interval of heights is half-open
            // and is compared in offsets, which neighbours share, so that a middle on a seam belongs to exactly one of
            // them.
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
        // For a line through the apex q and c may both be zero: the root is then at the place that roots are measured
        // from.
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
            // The quadratic is a difference of two squares with at most sixteen roundings. Its slope at a root is
            // twice the root √ of the discriminant. While the discriminant stays positive within the error, the slope
            // is on average at least √ up to where the error takes the root: the root moves by at most error/√. Where
            // the discriminant may not stay positive, the vertex is within √(error/|a|), the other root as far beyond
            // the vertex, and another such step takes the quadratic out of its error; one more step is for what the
            // error grows by on the way. The root never moves by more than from one ring to the other.
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
            // A rising line goes in if it passes the lower ring outside.
            let against = high.inside == (z > R::ZERO);
            cuts.list[0] = Some(cut(if against { enter } else { leave }, against));
        }
        cuts
    }

    /// A closer bound on the error of a crossing between two rings, from f = h(ρ − r) − w(y − y₁)
    /// at the line's own points.
    ///
    /// The line that is meant has an f that differs by at most `noise`. Where f keeps half of its slope as far as
    /// 2·noise/|slope|, that line has a root no farther away. The slope changes with ρ″ = across²·δ²/ρ³, and with the
    /// direction.
    pub(crate) fn closer_error(&self, cut: Cut<R>, first: &Ring<R>, second: &Ring<R>) -> R {
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
        // Five roundings of a term or less, and those of the terms themselves.
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
    /// The quadratic is computed from the lower ring, which may be far from where the line meets the segment, and that
    /// makes the roots of lines along the segment's slope inexact. This function is computed from the line's own
    /// points.
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
        // A value within eight roundings of its terms cannot be improved.
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

    /// A bound on the error of a crossing's t, with the roundings of a division, a sum and a product.
    pub(crate) fn t_error(&self, cut: Cut<R>) -> R {
        let rounded = R::gamma(4) * (self.start.abs() + cut.tau.abs() / self.length);
        (cut.error / self.length + rounded) * self.unit.abs()
    }
}
