//! Bounds on rounding errors, for several shapes.

use crate::geometry::number::Real;

/// Whether this kind of number is final: true for double-double and quad-double. What a final number cannot tell from
/// a touch counts as a touch. Only the shapes that use [`quad_double`](super::quad_double) have a finer number to ask
/// after double-double. Products and sums of double-double are not fused and rounded once, as those of coarser kinds
/// are.
pub(super) fn is_final<R: Real>() -> bool {
    R::ROUNDOFF < R::of(f64::EPSILON / 4.0)
}

/// A bound on the relative error that a shape's own numbers, which are doubles, have in this kind of number.
pub(super) fn parameter_error<R: Real>() -> R {
    if R::ROUNDOFF > R::of(f64::EPSILON) {
        R::ROUNDOFF
    } else {
        R::ZERO
    }
}

/// The size u⁴ of a sum of products above which underflow does not matter: what the products lose by it is far below a
/// unit in the sum's last place, since the least normal number of every kind is below u⁵.
pub(super) fn least<R: Real>() -> R {
    R::ROUNDOFF.square().square()
}

/// Whether sums of products of this size neither underflow nor overflow, nor do their squares.
pub(super) fn fits<R: Real>(size: R) -> bool {
    size >= least() && size <= least::<R>().recip()
}

/// The position of `x` between two ends, from 0 at `min` to 1 at `max`; 0 if `min` is not below `max`.
pub(super) fn share(x: f64, min: f64, max: f64) -> f64 {
    if min >= max {
        return 0.0;
    }
    let extent = max - min;
    if extent.is_finite() {
        (x - min) / extent
    } else {
        (x * 0.5 - min * 0.5) / (max * 0.5 - min * 0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dd::Dd;

    #[test]
    fn kinds_of_numbers() {
        assert!(!is_final::<f32>() && !is_final::<f64>() && is_final::<Dd>());
        assert_eq!(parameter_error::<f32>(), f32::ROUNDOFF);
        assert_eq!(parameter_error::<f64>(), 0.0);
        assert_eq!(parameter_error::<Dd>(), Dd::ZERO);
        assert!(f32::ROUNDOFF.powi(5) > f32::MIN_POSITIVE);
        assert!(fits(least::<f32>()) && !fits(least::<f32>() / 2.0));
        assert!(fits(1.0) && !fits(f64::NAN) && !fits(f64::INFINITY));
    }

    #[test]
    fn shares_of_the_longest_ways() {
        assert_eq!(share(2.5, 2.0, 4.0), 0.25);
        assert_eq!(share(7.0, 7.0, 7.0), 0.0);
        assert_eq!(share(0.0, -f64::MAX, f64::MAX), 0.5);
        assert_eq!(share(f64::MAX, -f64::MAX, f64::MAX), 1.0);
        assert_eq!(share(-f64::MAX / 2.0, -f64::MAX, f64::MAX), 0.25);
        let least = f64::from_bits(1);
        assert_eq!(share(least, 0.0, least), 1.0);
    }
}
