//! The numbers the geometric kernel computes with.
//!
//! Everything between a ray and its crossings is generic over [`Real`]: `f32`, `f64` and
//! [`Dd`](super::dd::Dd), whose 32 digits check the other two and decide what they cannot.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A floating-point number.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    const ZERO: Self;
    const ONE: Self;
    const INFINITY: Self;
    /// A bound on the relative error of one operation, square roots included: the unit roundoff
    /// where operations are correctly rounded.
    const ROUNDOFF: Self;

    /// The nearest number to a double.
    fn of(x: f64) -> Self;
    /// The nearest double.
    fn to_f64(self) -> f64;
    /// The number as the sum of the nearest double and the rest, which is a double, too: exact, but for quad-doubles.
    fn parts(self) -> (f64, f64);
    /// The nearest number to the sum of these two parts.
    fn of_parts(parts: (f64, f64)) -> Self;
    /// The square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    /// self · a + b, rounded only once if this kind of number allows it.
    fn mul_add(self, a: Self, b: Self) -> Self;
    fn is_finite(self) -> bool;

    /// Whether the sum of two numbers is known to be exact. Only double-doubles know it: what doubles cannot tell is
    /// decided there.
    #[inline]
    fn adds_exactly(self, _other: Self) -> bool {
        false
    }

    #[inline]
    fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }

    #[inline]
    fn recip(self) -> Self {
        Self::ONE / self
    }

    /// The lesser of two numbers. If one of them is NaN, the other one.
    #[inline]
    fn min(self, other: Self) -> Self {
        if other < self || self.is_nan() {
            other
        } else {
            self
        }
    }

    /// The greater of two numbers. If one of them is NaN, the other one.
    #[inline]
    fn max(self, other: Self) -> Self {
        if other > self || self.is_nan() {
            other
        } else {
            self
        }
    }

    #[inline]
    fn square(self) -> Self {
        self * self
    }

    /// a·b − c·d with an error of at most 1.5 units in the last place of the result where
    /// `mul_add` rounds once (Kahan; Jeannerod, Louvet and Muller, "Further analysis of Kahan's
    /// algorithm for the accurate computation of 2×2 determinants", 2013).
    #[inline]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let cd = c * d;
        let error = (-c).mul_add(d, cd);
        a.mul_add(b, -cd) + error
    }

    /// γₙ = nu / (1 − nu), the bound on the relative error of n rounded operations in a row
    /// (Higham, Accuracy and Stability of Numerical Algorithms, lemma 3.1; pbrt-v4, section 6.8).
    #[inline]
    fn gamma(n: u32) -> Self {
        let nu = Self::of(f64::from(n)) * Self::ROUNDOFF;
        nu / (Self::ONE - nu)
    }
}

macro_rules! hardware {
    ($t:ty) => {
        impl Real for $t {
            const ZERO: $t = 0.0;
            const ONE: $t = 1.0;
            const INFINITY: $t = <$t>::INFINITY;
            const ROUNDOFF: $t = <$t>::EPSILON / 2.0;

            #[inline]
            fn of(x: f64) -> $t {
                x as $t
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
            #[inline]
            fn parts(self) -> (f64, f64) {
                (self as f64, 0.0)
            }
            #[inline]
            fn of_parts((high, _): (f64, f64)) -> $t {
                high as $t
            }
            #[inline]
            fn sqrt(self) -> $t {
                <$t>::sqrt(self)
            }
            #[inline]
            fn abs(self) -> $t {
                <$t>::abs(self)
            }
            #[inline]
            fn mul_add(self, a: $t, b: $t) -> $t {
                <$t>::mul_add(self, a, b)
            }
            #[inline]
            fn is_finite(self) -> bool {
                <$t>::is_finite(self)
            }
            #[inline]
            fn is_nan(self) -> bool {
                <$t>::is_nan(self)
            }
            #[inline]
            fn min(self, other: $t) -> $t {
                <$t>::min(self, other)
            }
            #[inline]
            fn max(self, other: $t) -> $t {
                <$t>::max(self, other)
            }
        }
    };
}

hardware!(f32);
hardware!(f64);
