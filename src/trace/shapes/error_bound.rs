//! Bounds on rounding errors, for several shapes.

use crate::geometry::number::Real;

/// Whether there is no finer number to ask, but for shapes that go on [`quad_double`](super::quad_double): what
/// this one cannot tell from a touch is one. That is double-double, whose products and sums are not
/// fused and rounded once as those of the others.
pub(super) fn is_final<R: Real>() -> bool {
    R::ROUNDOFF < R::of(f64::EPSILON / 4.0)
}

/// A bound on the relative error of a shape's own numbers, which are doubles, in this kind of
/// number.
pub(super) fn parameter_error<R: Real>() -> R {
    if R::ROUNDOFF > R::of(f64::EPSILON) {
        R::ROUNDOFF
    } else {
        R::ZERO
    }
}

/// The least size of a sum of products, u⁴, for which what its products lose by underflow is far
/// below a unit in its last place: the least normal number of every kind is below u⁵.
pub(super) fn least<R: Real>() -> R {
    R::ROUNDOFF.square().square()
}

/// Whether sums of products of this size neither underflow nor overflow, nor do their squares.
pub(super) fn fits<R: Real>(size: R) -> bool {
    size >= least() && size <= least::<R>().recip()
}

/// How far a place is on the way from the lower to the upper end, as a share of all of it; 0 where
/// there is no way.
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
