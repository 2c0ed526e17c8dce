//! Crossings with quadrics whose terms cancel: needles, sheets, and what is small and far from the origin.
//!
//! Where F is small beside its terms, their rounding moves a crossing by much more than the rounding of the line does.
//! From a computed crossing on, F along the line is a quadratic in t. Its three coefficients are summed in twice the
//! working precision here. Its smaller root is the step to the true crossing.

use super::form::{OPERATIONS, PAIRS, QuadricForm};
use super::line::{Bounded, leading};
use crate::geometry::array::each;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::trace::shapes::Roots;
use crate::trace::shapes::error_bound::{is_final, parameter_error};

/// Distance from the surface that the rounding of F may put a crossing at, in units of roundoff times the largest
/// coordinate of the line's origin or the crossing. The rounding of the crossing and of its t come on top: √3 and 2√3
/// units at most, so that all is below 4 ε, which are 8 units.
const MAX_CROSSING_ROUNDOFFS: f64 = 2.0;

/// A sum of products by compensated summation: the errors of products come from fused multiply-adds, those of sums from
/// Knuth's two-sum (Ogita, Rump and Oishi, "Accurate Sum and Dot Product", 2005).
pub(super) struct Sum<R> {
    sum: R,
    lost: R,
    /// The sizes of the terms, added up.
    size: R,
    /// Whether no addition has had a rounding error.
    pub exact: bool,
}

impl<R: Traced> Sum<R> {
    pub(super) fn new() -> Sum<R> {
        Sum {
            sum: R::ZERO,
            lost: R::ZERO,
            size: R::ZERO,
            exact: true,
        }
    }

    /// Adds k·x·y; returns the size of the product.
    #[inline(always)]
    pub(super) fn add(&mut self, k: R, x: R, y: R) -> R {
        let half = k * x;
        let half_error = k.mul_add(x, -half);
        let term = half * y;
        let term_error = half.mul_add(y, -term) + half_error * y;
        let next = self.sum + term;
        let back = next - self.sum;
        let rest = (self.sum - (next - back)) + (term - back) + term_error;
        self.lost += rest;
        self.exact &= rest == R::ZERO;
        self.sum = next;
        let size = term.abs();
        self.size += size;
        size
    }

    #[inline(always)]
    pub(super) fn value(&self) -> R {
        self.sum + self.lost
    }

    /// The error bound: γₙ² of the sizes of the terms, or γₙ of them where products are not fused; n is
    /// [`OPERATIONS`].
    #[inline(always)]
    pub(super) fn noise(&self) -> R {
        let gamma = R::gamma(OPERATIONS);
        let noise = if !is_final::<R>() {
            gamma * gamma
        } else {
            gamma
        };
        noise * self.size
    }

    /// The value and its error bound: 2u of the value plus the [noise](Self::noise).
    fn bounded(&self) -> Bounded<R> {
        let value = self.value();
        Bounded {
            value,
            error: R::gamma(2) * value.abs() + self.noise(),
        }
    }
}

impl QuadricForm {
    /// Whether F is to be summed in twice the working precision. Double-double has digits enough without that, and
    /// single precision has lost digits of the coefficients.
    #[inline]
    pub(super) fn is_summed_closely<R: Traced>(&self) -> bool {
        self.cancels && !is_final::<R>() && parameter_error::<R>() == R::ZERO
    }

    /// Moves the crossings onto the surface. Marks them as uncertain if one cannot be brought
    /// [near](MAX_CROSSING_ROUNDOFFS) enough.
    #[inline(never)]
    pub(super) fn refine<R: Traced>(&self, line: &Line<R>, roots: &mut Roots<R>) {
        if roots.uncertain {
            return;
        }
        let mut last = -R::INFINITY;
        for root in &mut roots.list {
            let Some(t) = self.refined(line, root.t).filter(|&t| t > last) else {
                (roots.uncertain, roots.coarse) = (true, true);
                return;
            };
            (root.t, last) = (t, t);
        }
    }

    /// The crossing near t; `None` where its place is not known well enough.
    fn refined<R: Traced>(&self, line: &Line<R>, t: R) -> Option<R> {
        let d = line.direction;
        let p = line.origin.zip(d, |o, d| d.mul_add(t, o));
        let c = self.closely(p);
        let gradient = each([0, 1, 2], |i| self.slope_closely(p, i));
        let (mut b, mut error) = (R::ZERO, R::ZERO);
        for (i, slope) in gradient.iter().enumerate() {
            b += slope.value * d[i];
            error += (slope.error + R::gamma(4) * slope.value.abs()) * d[i].abs();
        }
        let a = leading(self, d);
        let (two, four) = (R::of(2.0), R::of(4.0));
        let root = R::difference_of_products(b, b, four * a.value, c.value).sqrt();
        let sum = if b < R::ZERO { b - root } else { b + root };
        let step = match c.value == R::ZERO {
            true => R::ZERO,
            false => -(two * c.value / sum),
        };
        let way = step.abs();
        // The rounding of the step has the effect of a change of c by a few units in its last place.
        let off = c.error + R::gamma(4) * c.value.abs() + (error + a.error * way) * way;
        let slope = Vec3(each(gradient, |g| g.value.abs() - g.error)).max_component();
        let reach = (line.origin.abs().max_component()).max(p.abs().max_component());
        let near = off <= R::of(MAX_CROSSING_ROUNDOFFS) * R::ROUNDOFF * reach * slope;
        let t = t + step;
        (near && slope > R::ZERO && t.is_finite()).then_some(t)
    }

    /// F(x), in twice the working precision.
    #[inline(never)]
    pub(super) fn closely<R: Traced>(&self, x: Vec3<R>) -> Bounded<R> {
        let mut sum = Sum::new();
        sum.add(R::of(self.constant), R::ONE, R::ONE);
        for i in 0..3 {
            sum.add(R::of(self.square[i]), x[i], x[i]);
            sum.add(R::of(self.linear[i]), x[i], R::ONE);
            sum.add(R::of(self.rest[1][i]), x[i], R::ONE);
        }
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            sum.add(R::of(self.mixed[k]), x[i], x[j]);
            sum.add(R::of(self.rest[0][k]), x[i], x[j]);
        }
        sum.bounded()
    }

    /// The derivative of F along an axis at x, in twice the working precision.
    #[inline(never)]
    pub(super) fn slope_closely<R: Traced>(&self, x: Vec3<R>, axis: usize) -> Bounded<R> {
        let mut sum = Sum::new();
        sum.add(R::of(2.0 * self.square[axis]), x[axis], R::ONE);
        sum.add(R::of(self.linear[axis]), R::ONE, R::ONE);
        sum.add(R::of(self.rest[1][axis]), R::ONE, R::ONE);
        for (k, (i, j)) in PAIRS.into_iter().enumerate() {
            let other = match axis {
                _ if axis == i => j,
                _ if axis == j => i,
                _ => continue,
            };
            sum.add(R::of(self.mixed[k]), x[other], R::ONE);
            sum.add(R::of(self.rest[0][k]), x[other], R::ONE);
        }
        sum.bounded()
    }
}
