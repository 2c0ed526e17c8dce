//! Plain numbers and vectors of them.

use crate::geometry::array::each;
use f256::f256;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point number as a textbook uses it.
pub trait Number:
    Copy
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The distance up to which a crossing is taken for the surface that the ray has just left. If
    /// `OFFSET_IS_RELATIVE`, it is a share of the largest coordinate of the ray's origin and direction, otherwise a
    /// value of t.
    const OFFSET: Self;
    const OFFSET_IS_RELATIVE: bool;
    /// The last share of the way to a lamp, in which a surface throws no shadow: the lamp may lie on this surface.
    const LAMP: Self;
    /// The bound below which coefficients are taken for zero.
    const TINY: Self;
    /// Whether roots come from formulas and intervals include their ends, as in textbooks. Otherwise roots are isolated
    /// by those of the derivative, and found by halving.
    const TEXTBOOK: bool;

    fn of(x: f64) -> Self;
    fn wide(self) -> f64;
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    fn cbrt(self) -> Self;
    fn cos(self) -> Self;
    fn acos(self) -> Self;
}

macro_rules! number {
    ($t:ident, $offset:literal, $lamp:literal, $tiny:literal) => {
        impl Number for $t {
            const OFFSET: $t = $offset;
            const OFFSET_IS_RELATIVE: bool = false;
            const LAMP: $t = $lamp;
            const TINY: $t = $tiny;
            const TEXTBOOK: bool = true;

            fn of(x: f64) -> $t {
                x as $t
            }
            fn wide(self) -> f64 {
                self.into()
            }
            fn abs(self) -> $t {
                $t::abs(self)
            }
            fn sqrt(self) -> $t {
                $t::sqrt(self)
            }
            fn cbrt(self) -> $t {
                $t::cbrt(self)
            }
            fn cos(self) -> $t {
                $t::cos(self)
            }
            fn acos(self) -> $t {
                $t::acos(self)
            }
        }
    };
}

number!(f32, 1e-4, 1e-4, 1e-6);
number!(f64, 1e-6, 1e-8, 1e-9);

/// A number of about 71 decimal digits.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Wide(f256);

/// Writes the number rounded to a double: the code that writes all digits would bring large tables along.
impl std::fmt::Debug for Wide {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?}", self.wide())
    }
}

const fn power_of_two(exponent: i32) -> Wide {
    Wide(f256::from_bits((((262_143 + exponent) as u128) << 108, 0)))
}

impl Number for Wide {
    // 2⁻⁴⁶: surfaces whose distance is a rounding of the scene's own numbers count as one surface.
    const OFFSET: Wide = power_of_two(-46);
    const OFFSET_IS_RELATIVE: bool = true;
    // 2⁻²⁷, as the reference of the language has it.
    const LAMP: Wide = power_of_two(-27);
    const TINY: Wide = power_of_two(-190);
    const TEXTBOOK: bool = false;

    fn of(x: f64) -> Wide {
        Wide(f256::from(x))
    }

    /// The number as a double, rounded towards zero.
    fn wide(self) -> f64 {
        let (high, _) = self.0.to_bits();
        let sign = if high >> 127 == 1 { -1.0 } else { 1.0 };
        let exponent = (high >> 108) as i32 & 0x7ffff;
        let fraction = high & ((1 << 108) - 1);
        match exponent {
            0 => 0.0 * sign,
            0x7ffff if fraction != 0 => f64::NAN,
            0x7ffff => sign * f64::INFINITY,
            // 53 of the 109 digits, with the leading one.
            _ => {
                let digits = ((1 << 108 | fraction) >> 56) as f64;
                sign * libm::ldexp(digits, exponent - 262_143 - 52)
            }
        }
    }

    fn abs(self) -> Wide {
        Wide(self.0.abs())
    }

    fn sqrt(self) -> Wide {
        Wide(self.0.sqrt())
    }

    fn cbrt(self) -> Wide {
        // Only the formulas need a cube root, and these numbers do without formulas.
        Wide::of(self.wide().cbrt())
    }

    fn cos(self) -> Wide {
        Wide::of(self.wide().cos())
    }

    fn acos(self) -> Wide {
        Wide::of(self.wide().acos())
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Wide {
            type Output = Wide;

            fn $method(self, other: Wide) -> Wide {
                Wide($trait::$method(self.0, other.0))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Wide {
    type Output = Wide;

    fn neg(self) -> Wide {
        Wide(-self.0)
    }
}

pub type V<T> = [T; 3];

pub fn vector<T: Number>(v: [f64; 3]) -> V<T> {
    each(v, T::of)
}

#[inline]
pub fn add<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
pub fn sub<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub fn scale<T: Number>(a: V<T>, s: T) -> V<T> {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline]
pub fn dot<T: Number>(a: V<T>, b: V<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub fn cross<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline]
pub fn unit<T: Number>(a: V<T>) -> V<T> {
    scale(a, T::of(1.0) / dot(a, a).sqrt())
}

/// The largest absolute value of a vector's components.
pub fn size<T: Number>(a: V<T>) -> T {
    a.into_iter()
        .fold(T::of(0.0), |m, x| if x.abs() > m { x.abs() } else { m })
}

/// A half-line; also the whole line, where crossings behind the origin count too.
#[derive(Clone, Copy, Debug)]
pub struct Ray<T> {
    pub origin: V<T>,
    pub direction: V<T>,
}

impl<T: Number> Ray<T> {
    #[inline]
    pub fn at(&self, t: T) -> V<T> {
        add(self.origin, scale(self.direction, t))
    }

    /// The t up to which a crossing is taken for the surface that the ray leaves.
    pub fn offset(&self) -> T {
        match T::OFFSET_IS_RELATIVE {
            false => T::OFFSET,
            true => {
                let (o, d) = (size(self.origin), size(self.direction));
                let most = if o > d { o } else { d };
                T::OFFSET * most / d
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_numbers_have_seventy_digits() {
        for x in [1.0, -0.75, 1e300, -3e-300, 0.0, std::f64::consts::PI] {
            assert_eq!(Wide::of(x).wide(), x);
        }
        let two = Wide::of(2.0);
        let off = two.sqrt() * two.sqrt() - two;
        assert!(off.abs().wide() < 1e-70, "{off:?}");
        assert_eq!(Wide::OFFSET.wide(), (-46f64).exp2());
        assert_eq!(Wide::TINY.wide(), (-190f64).exp2());
    }
}
