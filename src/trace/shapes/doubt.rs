//! What the bounds on rounding errors of several shapes have in common.

use super::Located;
use crate::trace::number::Real;

/// Whether there is no finer number to ask: what this one cannot tell from a touch is one.
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

/// A place as far as there are numbers for it: what has left them is zero.
pub(super) fn within_numbers<R: Real>(at: Located<R>) -> Located<R> {
    let kept = |x: R| if x.is_finite() { x } else { R::ZERO };
    Located {
        point: at.point.map(kept),
        error: at.error.map(kept),
        normal: at.normal,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::dd::Dd;

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
}
