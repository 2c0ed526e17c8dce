//! Double-double numbers: the unevaluated sum of two doubles, about 32 digits.
//!
//! The algorithms and their error bounds are those of Joldeş, Muller and Popescu, "Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2),
//! 2017; u = 2⁻⁵³ below. The square root is one Newton step from the double root (Karp and
//! Markstein, "High-precision division and square root", ACM TOMS 23(4), 1997).

use super::number::Real;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `high + low`, where `high` is the sum rounded to a double. An infinite or undefined number is
/// its high part alone. The exponents are those of doubles, so products that reach below about
/// 1e-290 lose digits.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dd {
    high: f64,
    low: f64,
}

/// a + b = s + e exactly (Knuth).
#[inline]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let back = s - a;
    (s, (a - (s - back)) + (b - back))
}

/// a + b = s + e exactly, where |a| ≥ |b| or a = 0 (Dekker).
#[inline]
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// a · b = p + e exactly, short of underflow.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    (p, a.mul_add(b, -p))
}

impl Dd {
    /// The sum of any two doubles, exactly.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Dd {
        let (s, e) = two_sum(a, b);
        Dd::settled(s, e)
    }

    /// A number from its two parts. If the high part is not finite, the low part means nothing and is dropped.
    #[inline]
    fn settled(high: f64, low: f64) -> Dd {
        Dd {
            high,
            low: if high.is_finite() { low } else { 0.0 },
        }
    }
}

impl From<f64> for Dd {
    #[inline]
    fn from(x: f64) -> Dd {
        Dd { high: x, low: 0.0 }
    }
}

impl Add for Dd {
    type Output = Dd;
    /// Algorithm 6, AccurateDWPlusDW: relative error at most 3u²/(1 − 4u).
    #[inline]
    fn add(self, other: Dd) -> Dd {
        let (s, e) = two_sum(self.high, other.high);
        if !s.is_finite() {
            return Dd::from(s);
        }
        let (t, f) = two_sum(self.low, other.low);
        let (s, e) = fast_two_sum(s, e + t);
        let (high, low) = fast_two_sum(s, e + f);
        Dd::settled(high, low)
    }
}

impl Sub for Dd {
    type Output = Dd;
    #[inline]
    fn sub(self, other: Dd) -> Dd {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Dd;
    /// Algorithm 12, DWTimesDW3: relative error below 4u².
    #[inline]
    fn mul(self, other: Dd) -> Dd {
        let (p, e) = two_product(self.high, other.high);
        if !p.is_finite() {
            return Dd::from(p);
        }
        let low = self.low * other.low;
        let cross = self.high.mul_add(other.low, low);
        let cross = self.low.mul_add(other.high, cross);
        let (high, low) = fast_two_sum(p, e + cross);
        Dd::settled(high, low)
    }
}

impl Div for Dd {
    type Output = Dd;
    /// Algorithm 17, DWDivDW2: relative error below 15u² + 56u³.
    #[inline]
    fn div(self, other: Dd) -> Dd {
        let quotient = self.high / other.high;
        if !quotient.is_finite() || !other.high.is_finite() {
            return Dd::from(quotient);
        }
        let product = other * Dd::from(quotient);
        if !product.high.is_finite() {
            // The greatest numbers, whose product with the quotient is rounded up to infinity.
            return Dd::from(quotient);
        }
        let rest = (self.high - product.high) + (self.low - product.low);
        let (high, low) = fast_two_sum(quotient, rest / other.high);
        Dd::settled(high, low)
    }
}

impl Neg for Dd {
    type Output = Dd;
    #[inline]
    fn neg(self) -> Dd {
        Dd {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl AddAssign for Dd {
    #[inline]
    fn add_assign(&mut self, other: Dd) {
        *self = *self + other;
    }
}

impl SubAssign for Dd {
    #[inline]
    fn sub_assign(&mut self, other: Dd) {
        *self = *self - other;
    }
}

impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Dd) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            decided => decided,
        }
    }
}

impl Real for Dd {
    const ZERO: Dd = Dd {
        high: 0.0,
        low: 0.0,
    };
    const ONE: Dd = Dd {
        high: 1.0,
        low: 0.0,
    };
    const INFINITY: Dd = Dd {
        high: f64::INFINITY,
        low: 0.0,
    };
    /// 16u² = 2⁻¹⁰², which no operation here exceeds.
    const ROUNDOFF: Dd = Dd {
        high: 1.0 / (1u128 << 102) as f64,
        low: 0.0,
    };

    #[inline]
    fn of(x: f64) -> Dd {
        Dd::from(x)
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.high
    }

    #[inline]
    fn parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    #[inline]
    fn of_parts((high, low): (f64, f64)) -> Dd {
        Dd { high, low }
    }

    #[inline]
    fn sqrt(self) -> Dd {
        let root = self.high.sqrt();
        // For zero, infinity and NaN the root in doubles is the answer.
        if root == 0.0 || !root.is_finite() {
            return Dd::from(root);
        }
        let rest = self - Dd::from(root) * Dd::from(root);
        let (high, low) = fast_two_sum(root, rest.high / (2.0 * root));
        Dd::settled(high, low)
    }

    #[inline]
    fn abs(self) -> Dd {
        if self.high < 0.0 { -self } else { self }
    }

    #[inline]
    fn mul_add(self, a: Dd, b: Dd) -> Dd {
        self * a + b
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.high.is_finite()
    }

    /// Whether the sum is exact in double-double, as the sum of two doubles is.
    #[inline]
    fn adds_exactly(self, other: Dd) -> bool {
        self.low == 0.0 && other.low == 0.0 && (self.high + other.high).is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn dd() -> impl Strategy<Value = Dd> {
        (-1e12..1e12f64, -1.0..1.0f64).prop_map(|(a, b)| Dd::sum(a, a * b / 4.0 * f64::EPSILON))
    }

    proptest! {
        /// Identities that hold to the stated bounds, whatever the numbers.
        #[test]
        fn operations_undo_each_other(a in dd(), b in dd()) {
            let near = |x: Dd, y: Dd, scale: Dd| {
                (x - y).abs() <= Dd::of(4.0) * Dd::ROUNDOFF * scale
            };
            prop_assert!(near((a + b) - b, a, a.abs() + b.abs()));
            if b != Dd::ZERO {
                prop_assert!(near((a / b) * b, a, a.abs()));
            }
            let root = a.abs().sqrt();
            prop_assert!(near(root * root, a.abs(), a.abs()));
            prop_assert!(near(a * b, b * a, (a * b).abs()));
        }
    }

    #[test]
    fn knows_more_digits_than_a_double() {
        // 1/3 = 0.333…: three times it is 1 to within 2⁻¹⁰², and not so in doubles.
        let third = Dd::ONE / Dd::of(3.0);
        let (high, low) = third.parts();
        assert_eq!(high, 1.0 / 3.0);
        // 1/3 − fl(1/3) is a third of the last bit's half: 2⁻⁵⁴/3.
        assert_eq!(low, (0.5f64).powi(54) / 3.0);
        assert!((third * Dd::of(3.0) - Dd::ONE).abs() <= Dd::ROUNDOFF);
        // (√2)² − 2 by the known digits of √2.
        let root = Dd::of(2.0).sqrt();
        assert_eq!(root.parts().0, std::f64::consts::SQRT_2);
        let low = Dd::of(-9.667_293_313_452_913e-17);
        assert!((Dd::of(root.parts().1) - low).abs() <= Dd::ROUNDOFF * root);
    }

    #[test]
    fn infinities_and_nan_are_kept() {
        let huge = Dd::of(f64::MAX);
        assert_eq!(huge + huge, Dd::INFINITY);
        assert_eq!(huge * Dd::of(-2.0), -Dd::INFINITY);
        assert_eq!(Dd::ONE / Dd::ZERO, Dd::INFINITY);
        assert_eq!(Dd::ONE / Dd::INFINITY, Dd::ZERO);
        let divisor = 4.699781079894748e25;
        assert_eq!(huge / Dd::of(divisor), Dd::of(f64::MAX / divisor));
        assert!((Dd::ZERO / Dd::ZERO).is_nan());
        assert!(Dd::of(-1.0).sqrt().is_nan());
        assert_eq!(Dd::INFINITY.sqrt(), Dd::INFINITY);
        assert_eq!(Dd::of(f64::NAN).max(Dd::ONE), Dd::ONE);
    }
}
