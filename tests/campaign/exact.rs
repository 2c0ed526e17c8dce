//! Exact numbers: integers times powers of two, which is what floating-point numbers and their
//! sums and products are.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use dashu_int::ops::{BitTest, SquareRoot};
use dashu_int::{IBig, Sign, UBig};
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// A number rounded to [`DIGITS`] binary digits.
pub type Big = FBig<HalfEven, 2>;

/// Enough that a distance of 2⁻¹⁰⁰ of a size is known to 2⁻⁷⁵ of itself at an origin 10⁸ sizes away.
pub const DIGITS: usize = 256;

/// mantissa · 2^exponent.
#[derive(Debug, Clone)]
pub struct Exact {
    pub mantissa: IBig,
    pub exponent: i64,
}

pub type Point = [Exact; 3];

impl Exact {
    pub fn zero() -> Exact {
        Exact::whole(0)
    }

    pub fn whole(x: i64) -> Exact {
        Exact {
            mantissa: IBig::from(x),
            exponent: 0,
        }
    }

    /// A finite double.
    pub fn of(x: f64) -> Exact {
        assert!(x.is_finite());
        if x == 0.0 {
            return Exact::zero();
        }
        let bits = x.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
        let (mantissa, exponent) = match field {
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, field - 1075),
        };
        let zeros = mantissa.trailing_zeros();
        let mantissa = (mantissa >> zeros) as i64;
        Exact {
            mantissa: IBig::from(if x < 0.0 { -mantissa } else { mantissa }),
            exponent: exponent + i64::from(zeros),
        }
    }

    /// 2^exponent.
    pub fn power_of_two(exponent: i64) -> Exact {
        Exact {
            mantissa: IBig::from(1),
            exponent,
        }
    }

    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i32 {
        if self.is_zero() {
            0
        } else if self.mantissa.sign() == Sign::Negative {
            -1
        } else {
            1
        }
    }

    pub fn is_positive(&self) -> bool {
        self.sign() > 0
    }

    pub fn is_negative(&self) -> bool {
        self.sign() < 0
    }

    pub fn square(&self) -> Exact {
        self * self
    }

    pub fn twice(&self) -> Exact {
        self.shifted(1)
    }

    /// Times 2^by.
    pub fn shifted(&self, by: i64) -> Exact {
        Exact {
            mantissa: self.mantissa.clone(),
            exponent: self.exponent + by,
        }
    }

    /// The number of digits of the mantissa.
    pub fn digits(&self) -> i64 {
        length(&self.mantissa) as i64
    }

    /// The exponent of the highest binary digit; that of the least number for zero.
    pub fn top(&self) -> i64 {
        if self.is_zero() {
            return i64::MIN / 4;
        }
        self.digits() + self.exponent - 1
    }

    /// Rounded to [`DIGITS`].
    pub fn big(&self) -> Big {
        Big::from_parts(self.mantissa.clone(), self.exponent as isize)
            .with_precision(DIGITS)
            .value()
    }

    /// Close to it.
    pub fn about(&self) -> f64 {
        self.big().to_f64().value()
    }

    /// The mantissa at a lower exponent.
    pub fn mantissa_at(&self, exponent: i64) -> IBig {
        &self.mantissa << (self.exponent - exponent) as usize
    }

    /// Bounds on the square root of a number that is not negative, `digits` or more of them; equal
    /// ones where it is exact.
    pub fn root(&self, digits: i64) -> (Exact, Exact) {
        let mut shift = (2 * digits - self.digits()).max(0);
        shift += (self.exponent - shift).rem_euclid(2);
        let radicand = UBig::try_from(&self.mantissa << shift as usize).expect("no negative root");
        let root = radicand.sqrt();
        let exact = &root * &root == radicand;
        let exponent = (self.exponent - shift) / 2;
        let low = Exact {
            mantissa: IBig::from(root),
            exponent,
        };
        let high = if exact {
            low.clone()
        } else {
            &low + &Exact::power_of_two(exponent)
        };
        (low, high)
    }

    /// Bounds on the quotient by a number that is not zero, `digits` or more of them; equal ones
    /// where it is exact.
    pub fn over(&self, divisor: &Exact, digits: i64) -> (Exact, Exact) {
        if self.is_zero() {
            return (Exact::zero(), Exact::zero());
        }
        let shift = (digits + divisor.digits() - self.digits()).max(0);
        let (n, d) = (&self.mantissa << shift as usize, &divisor.mantissa);
        let quotient = &n / d;
        let rest = &n - &quotient * d;
        let exponent = self.exponent - shift - divisor.exponent;
        let at = |mantissa: IBig| Exact { mantissa, exponent };
        // Integer division cuts off towards zero.
        if rest.is_zero() {
            (at(quotient.clone()), at(quotient))
        } else if self.sign() * divisor.sign() > 0 {
            (at(quotient.clone()), at(quotient + 1))
        } else {
            (at(&quotient - 1), at(quotient))
        }
    }
}

fn length(x: &IBig) -> usize {
    match x.as_ubig() {
        Some(x) => x.bit_len(),
        None => (-x).bit_len(),
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: &Exact) -> Exact {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        let mantissa = if self.exponent == other.exponent {
            &self.mantissa + &other.mantissa
        } else if self.exponent > exponent {
            self.mantissa_at(exponent) + &other.mantissa
        } else {
            &self.mantissa + other.mantissa_at(exponent)
        };
        Exact { mantissa, exponent }
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact {
            mantissa: -&self.mantissa,
            exponent: self.exponent,
        }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: &Exact) -> Exact {
        Exact {
            mantissa: &self.mantissa * &other.mantissa,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Neg for Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        -&self
    }
}

/// The operators on values and on values with references.
macro_rules! owned {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact {
                (&self).$method(&other)
            }
        }
        impl $trait<&Exact> for Exact {
            type Output = Exact;
            fn $method(self, other: &Exact) -> Exact {
                (&self).$method(other)
            }
        }
        impl $trait<Exact> for &Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact {
                self.$method(&other)
            }
        }
    )*};
}

owned!(Add add, Sub sub, Mul mul);

impl PartialEq for Exact {
    fn eq(&self, other: &Exact) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Exact {}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Exact) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Exact {
    fn cmp(&self, other: &Exact) -> Ordering {
        let (a, b) = (self.sign(), other.sign());
        if a != b || a == 0 {
            return a.cmp(&b);
        }
        match self.top().cmp(&other.top()) {
            Ordering::Equal => (self - other).sign().cmp(&0),
            larger if a > 0 => larger,
            larger => larger.reverse(),
        }
    }
}

pub fn point(p: [f64; 3]) -> Point {
    p.map(Exact::of)
}

pub fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| &a[i] - &b[i])
}

pub fn dot(a: &Point, b: &Point) -> Exact {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub fn cross(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

/// o + t·d.
pub fn along(o: &Point, d: &Point, t: &Exact) -> Point {
    std::array::from_fn(|i| &o[i] + &d[i] * t)
}
