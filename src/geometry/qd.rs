//! Quad-double numbers: the unevaluated sum of four doubles, about 64 digits.
//!
//! Quad-doubles decide about the few lines that pass a shape so closely that the squares of the distances are below
//! what double-double can tell. They are made to be simple rather than fast: every operation collects the terms of its
//! result exactly and renormalises them by repeated error-free vector sums (Ogita, Rump and Oishi, "Accurate sum and
//! dot product", SIAM J. Sci. Comput. 26(6), 2005); u = 2⁻⁵³ below.

use super::array::each;
use super::dd::{Dd, two_product, two_sum};
use super::number::Real;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// The sum of its parts, each at most half a unit in the last place of the one before. An infinite or undefined number
/// is its first part alone. The exponents are those of doubles, so digits below about 1e-290 are lost.
#[derive(Debug, Clone, Copy, Default)]
pub struct Qd([f64; PARTS]);

const PARTS: usize = 4;

impl Qd {
    /// The sum of the terms, with the larger ones first as far as their sizes are known. It is exact but for the part
    /// beyond the fourth double, which is hardly more than u⁴ of the sum.
    fn sum_of<const N: usize>(mut terms: [f64; N]) -> Qd {
        // Each pass is exact and carries the terms upwards. When a pass changes nothing, no term is more than half a
        // unit in the last place of the one before, and zeros have sunk to the end. A few passes are enough; the limit,
        // twice the number of terms, makes sure that the loop ends.
        for _ in 0..2 * N {
            let mut settled = true;
            for i in (1..N).rev() {
                let (sum, error) = two_sum(terms[i - 1], terms[i]);
                settled &= sum == terms[i - 1];
                (terms[i - 1], terms[i]) = (sum, error);
            }
            if !terms[0].is_finite() {
                return Qd([terms[0], 0.0, 0.0, 0.0]);
            }
            if settled {
                break;
            }
        }
        Qd(std::array::from_fn(|i| terms[i]))
    }

    /// The nearest double-double, or one of the two nearest.
    pub fn to_dd(self) -> Dd {
        let [a, b, c, _] = self.0;
        if a.is_finite() {
            Dd::sum(a, b + c)
        } else {
            Dd::from(a)
        }
    }

    fn times(self, factor: f64) -> Qd {
        let [a, b, c, d] = each(self.0, |x| two_product(x, factor));
        if !a.0.is_finite() {
            return Qd::of(a.0);
        }
        Qd::sum_of([a.0, a.1, b.0, b.1, c.0, c.1, d.0, d.1])
    }
}

impl From<Dd> for Qd {
    fn from(x: Dd) -> Qd {
        let (a, b) = x.parts();
        Qd([a, b, 0.0, 0.0])
    }
}

impl Add for Qd {
    type Output = Qd;
    fn add(self, other: Qd) -> Qd {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        let lead = a + e;
        if !lead.is_finite() {
            return Qd::of(lead);
        }
        Qd::sum_of([a, e, b, f, c, g, d, h])
    }
}

impl Sub for Qd {
    type Output = Qd;
    fn sub(self, other: Qd) -> Qd {
        self + -other
    }
}

impl Mul for Qd {
    type Output = Qd;
    /// The product. Products of parts down to u³ of the result are exact, and those of u⁴ rounded. Those of u⁵, at most
    /// three, and the roundings, at most nine, are below u⁴ by far.
    fn mul(self, other: Qd) -> Qd {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (self.0, other.0);
        let (p00, e00) = two_product(a0, b0);
        if !p00.is_finite() {
            return Qd::of(p00);
        }
        let [(p01, e01), (p10, e10)] = [two_product(a0, b1), two_product(a1, b0)];
        let [(p02, e02), (p11, e11), (p20, e20)] = [
            two_product(a0, b2),
            two_product(a1, b1),
            two_product(a2, b0),
        ];
        let [(p03, e03), (p12, e12), (p21, e21), (p30, e30)] = [
            two_product(a0, b3),
            two_product(a1, b2),
            two_product(a2, b1),
            two_product(a3, b0),
        ];
        let last = a1 * b3 + a2 * b2 + a3 * b1 + ((e03 + e30) + (e12 + e21));
        Qd::sum_of([
            p00, p01, p10, e00, p02, p11, p20, e01, e10, p03, p12, p21, p30, e02, e11, e20, last,
        ])
    }
}

impl Div for Qd {
    type Output = Qd;
    /// Long division, a double at a time. Each remainder is at most 2u of the one before, and is rounded by some u⁴ of
    /// the dividend. After the fifth step only this rounding is left of the error.
    fn div(self, other: Qd) -> Qd {
        let first = self.0[0] / other.0[0];
        if !first.is_finite() || !other.0[0].is_finite() {
            return Qd::of(first);
        }
        let mut quotient = [first, 0.0, 0.0, 0.0, 0.0];
        let mut rest = self;
        for i in 1..quotient.len() {
            rest -= other.times(quotient[i - 1]);
            let next = rest.0[0] / other.0[0];
            if !next.is_finite() {
                // The greatest numbers, whose product with the quotient is rounded up to infinity.
                return Qd::of(first);
            }
            quotient[i] = next;
        }
        Qd::sum_of(quotient)
    }
}

impl Neg for Qd {
    type Output = Qd;
    fn neg(self) -> Qd {
        Qd(each(self.0, |x| -x))
    }
}

impl AddAssign for Qd {
    fn add_assign(&mut self, other: Qd) {
        *self = *self + other;
    }
}

impl SubAssign for Qd {
    fn sub_assign(&mut self, other: Qd) {
        *self = *self - other;
    }
}

impl PartialEq for Qd {
    fn eq(&self, other: &Qd) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Qd {
    /// Compares by the sign of the difference, as a number that lies halfway between two doubles may have either one
    /// for its first part.
    fn partial_cmp(&self, other: &Qd) -> Option<Ordering> {
        let (a, b) = (self.0[0], other.0[0]);
        let apart = (a - b).abs() > (a.abs() + b.abs()) * f64::EPSILON;
        if apart || !a.is_finite() || !b.is_finite() {
            return a.partial_cmp(&b);
        }
        (*self - *other).0[0].partial_cmp(&0.0)
    }
}

impl Real for Qd {
    const ZERO: Qd = Qd([0.0; PARTS]);
    const ONE: Qd = Qd([1.0, 0.0, 0.0, 0.0]);
    const INFINITY: Qd = Qd([f64::INFINITY, 0.0, 0.0, 0.0]);
    /// 2⁻²⁰⁶ = 64u⁴, which no operation here exceeds.
    const ROUNDOFF: Qd = Qd([
        1.0 / (1u128 << 103) as f64 / (1u128 << 103) as f64,
        0.0,
        0.0,
        0.0,
    ]);

    fn of(x: f64) -> Qd {
        Qd([x, 0.0, 0.0, 0.0])
    }

    fn to_f64(self) -> f64 {
        self.0[0]
    }

    /// Rounded to a double-double.
    fn parts(self) -> (f64, f64) {
        self.to_dd().parts()
    }

    fn of_parts((high, low): (f64, f64)) -> Qd {
        Qd([high, low, 0.0, 0.0])
    }

    /// Newton's method from the root in doubles, with the slope in doubles, too: each of four steps divides the error
    /// by 2⁵⁰.
    fn sqrt(self) -> Qd {
        let root = self.0[0].sqrt();
        // For zero, infinity and NaN the root in doubles is the answer.
        if root == 0.0 || !root.is_finite() {
            return Qd::of(root);
        }
        let mut x = Qd::of(root);
        for _ in 0..4 {
            let rest = self - x * x;
            x += Qd::of(rest.0[0] / (2.0 * root));
        }
        x
    }

    fn abs(self) -> Qd {
        if self.0[0] < 0.0 { -self } else { self }
    }

    fn mul_add(self, a: Qd, b: Qd) -> Qd {
        self * a + b
    }

    fn is_finite(self) -> bool {
        self.0[0].is_finite()
    }

    fn difference_of_products(a: Qd, b: Qd, c: Qd, d: Qd) -> Qd {
        a * b - c * d
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_int::IBig;
    use proptest::prelude::*;

    /// Numbers whose parts are next to each other, or have zeros between.
    fn qd() -> impl Strategy<Value = Qd> {
        let part = || (-1.0..1.0f64, 0..40i32);
        (-1e12..1e12f64, part(), part(), part()).prop_map(|(first, b, c, d)| {
            let mut parts = [first, 0.0, 0.0, 0.0];
            for (i, (share, gap)) in [b, c, d].into_iter().enumerate() {
                parts[i + 1] = parts[i] * share * f64::EPSILON / 4.0 * 0.5f64.powi(gap);
            }
            Qd::sum_of(parts)
        })
    }

    /// A number times 2^1000, exactly.
    fn exact(x: Qd) -> IBig {
        x.0.iter().fold(IBig::ZERO, |sum, part| {
            let field = (part.to_bits() >> 52 & 0x7ff) as i32;
            let mantissa = part.abs() / f64::from_bits((field as u64) << 52) * 2f64.powi(52);
            let size = match *part {
                0.0 => IBig::ZERO,
                _ => IBig::from(mantissa as u64) << (field - 1075 + 1000) as usize,
            };
            if *part < 0.0 { sum - size } else { sum + size }
        })
    }

    /// Whether two numbers differ by no more than the roundoff of the second.
    fn near(got: IBig, meant: IBig) -> bool {
        let size = |x: IBig| if x < IBig::ZERO { -x } else { x };
        size(got - &meant) << 206 <= size(meant)
    }

    proptest! {
        /// All operations to the bound, by whole numbers of any length.
        #[test]
        fn operations_against_whole_numbers(a in qd(), b in qd()) {
            let (x, y) = (exact(a), exact(b));
            prop_assert!(near(exact(a + b), &x + &y));
            prop_assert!(near(exact(a * b) << 1000, &x * &y));
            prop_assert!(near(exact(a - b), &x - &y));
            if b != Qd::ZERO {
                prop_assert!(near(exact(a / b) * &y, &x << 1000));
            }
            let root = exact(a.abs().sqrt());
            // Twice the error in the square.
            prop_assert!(near((&root * &root) >> 1, exact(a.abs()) << 999) || a == Qd::ZERO);
            prop_assert_eq!(a < b, x < y);
            prop_assert_eq!(a == b, x == y);
        }

        /// Every part is at most half of the last place of the one before.
        #[test]
        fn parts_do_not_overlap(a in qd(), b in qd()) {
            for x in [a, a + b, a * b, a / b, a.abs().sqrt()] {
                prop_assert!(x.0.windows(2).all(|w| w[0] + w[1] == w[0]), "{:?}", x);
            }
        }
    }

    #[test]
    fn zeros_and_cancellation_leave_all_digits() {
        let tiny = Qd::of(2f64.powi(-150));
        assert_eq!(
            ((Qd::ONE + tiny) - Qd::ONE).0,
            [2f64.powi(-150), 0.0, 0.0, 0.0]
        );
        let sum = Qd::sum_of([
            1.0,
            -1.0,
            0.0,
            2f64.powi(-60),
            0.0,
            0.0,
            2f64.powi(-300),
            0.0,
        ]);
        assert_eq!(sum.0, [2f64.powi(-60), 2f64.powi(-300), 0.0, 0.0]);
        // A tie has two expansions, which are one number.
        let half = f64::EPSILON / 2.0;
        let (a, b) = (
            Qd([1.0, half, 0.0, 0.0]),
            Qd([1.0 + f64::EPSILON, -half, 0.0, 0.0]),
        );
        assert_eq!(a.partial_cmp(&b), Some(Ordering::Equal));
        assert!(a + tiny > b && b - tiny < a);
    }

    #[test]
    fn to_double_double_and_back() {
        let third = Qd::ONE / Qd::of(3.0);
        let dd = Dd::ONE / Dd::of(3.0);
        assert!((third - Qd::from(dd)).abs() <= Qd::of(Dd::ROUNDOFF.to_f64()));
        assert_eq!(Qd::from(dd).to_dd(), dd);
        assert_eq!(Qd::from(dd).parts(), dd.parts());
        assert!((third * Qd::of(3.0) - Qd::ONE).abs() <= Qd::ROUNDOFF);
    }

    #[test]
    fn infinities_and_nan_are_kept() {
        let huge = Qd::of(f64::MAX);
        assert_eq!(huge + huge, Qd::INFINITY);
        assert_eq!(huge * Qd::of(-2.0), -Qd::INFINITY);
        assert_eq!(Qd::ONE / Qd::ZERO, Qd::INFINITY);
        assert_eq!(Qd::ONE / Qd::INFINITY, Qd::ZERO);
        assert_eq!(Qd::INFINITY.to_dd(), Dd::INFINITY);
        assert_eq!(Qd::INFINITY.sqrt(), Qd::INFINITY);
        assert!((Qd::ZERO / Qd::ZERO).is_nan());
        assert!(Qd::of(-1.0).sqrt().is_nan());
        assert!(huge > Qd::ONE && -Qd::INFINITY < huge);
        assert_eq!(Qd::of(f64::NAN).partial_cmp(&Qd::ONE), None);
    }
}
