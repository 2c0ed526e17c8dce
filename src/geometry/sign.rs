//! The sign of a polynomial in doubles, decided exactly: on which side of a surface a point is.
//!
//! A shape writes its polynomial once, over [`Scalar`]. Doubles with a running bound on their error nearly always tell
//! the sign. Where they cannot, numbers that no operation rounds decide.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::ops::{Add, Mul, Neg, Sub};

/// A number that polynomials are computed with.
pub trait Scalar:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// Converts a finite double exactly.
    fn of(x: f64) -> Self;

    fn square(self) -> Self {
        self.clone() * self
    }
}

/// A number that no operation rounds.
pub type Exact = FBig<HalfEven, 2>;

impl Scalar for Exact {
    fn of(x: f64) -> Exact {
        const UNLIMITED: usize = 0;
        match Exact::try_from(x) {
            Ok(x) => x.with_precision(UNLIMITED).value(),
            Err(_) => Exact::ZERO,
        }
    }
}

/// A double, and a bound on its error.
#[derive(Debug, Clone, Copy)]
pub struct Rounded {
    value: f64,
    error: f64,
}

impl Rounded {
    /// A value that an operation has rounded: `error` and the rounding of the value itself add up to its error. The
    /// error's own roundings, a few in each operation, are far below the part by which the error grows here.
    fn new(value: f64, error: f64) -> Rounded {
        const ROUNDOFF: f64 = f64::EPSILON / 2.0;
        const GROWN: f64 = 1.0 + 16.0 * f64::EPSILON;
        Rounded {
            value,
            error: (error + ROUNDOFF * value.abs()) * GROWN + f64::MIN_POSITIVE,
        }
    }
}

impl Scalar for Rounded {
    fn of(value: f64) -> Rounded {
        Rounded { value, error: 0.0 }
    }
}

impl Neg for Rounded {
    type Output = Rounded;
    fn neg(self) -> Rounded {
        Rounded {
            value: -self.value,
            ..self
        }
    }
}

impl Add for Rounded {
    type Output = Rounded;
    fn add(self, other: Rounded) -> Rounded {
        Rounded::new(self.value + other.value, self.error + other.error)
    }
}

impl Sub for Rounded {
    type Output = Rounded;
    fn sub(self, other: Rounded) -> Rounded {
        Rounded::new(self.value - other.value, self.error + other.error)
    }
}

impl Mul for Rounded {
    type Output = Rounded;
    fn mul(self, other: Rounded) -> Rounded {
        let (a, b) = (self.value.abs(), other.value.abs());
        let error = a * other.error + b * self.error + self.error * other.error;
        Rounded::new(self.value * other.value, error)
    }
}

/// Whether a number is at most zero. If the double does not tell, `exact` computes the number and decides.
pub fn at_most_zero(rounded: Rounded, exact: impl FnOnce() -> Exact) -> bool {
    // The comparisons are such that a NaN decides nothing.
    if rounded.value > rounded.error {
        false
    } else if rounded.value < -rounded.error {
        true
    } else {
        exact() <= Exact::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// (a + b)(a − b) − a² + b², which is zero, plus c.
    fn sum<N: Scalar>([a, b, c]: [f64; 3]) -> N {
        let [a, b] = [a, b].map(N::of);
        let product = (a.clone() + b.clone()) * (a.clone() - b.clone());
        product - a.square() + b.square() + N::of(c)
    }

    proptest! {
        #[test]
        fn signs_are_exact(a in -1e9..1e9f64, b in -1e-3..1e3f64, c in -1e-12..1e-12f64) {
            let sign = |c| at_most_zero(sum([a, b, c]), || sum([a, b, c]));
            prop_assert_eq!(sign(c), c <= 0.0);
            prop_assert!(sign(0.0));
        }
    }

    #[test]
    fn numbers_that_leave_the_doubles() {
        for (numbers, meant) in [
            ([1e200, 1e190, 5e-324], false),
            ([1e-200, 1e-190, -5e-324], true),
            ([f64::MAX, -f64::MAX, 0.0], true),
        ] {
            assert_eq!(at_most_zero(sum(numbers), || sum(numbers)), meant);
        }
    }
}
