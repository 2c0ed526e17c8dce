//! Powers of two: scaling that rounds nothing, short of underflow.

use super::number::Real;
use super::vec::Vec3;

/// The k with 2ᵏ ≤ |x| < 2ᵏ⁺¹, for a finite x. For zero, the k of the least double.
#[inline]
pub fn exponent(x: f64) -> i32 {
    const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
    let field = |x: f64| ((x.to_bits() >> MANTISSA) & 0x7ff) as i32;
    if field(x) > 0 {
        return field(x) - 1023;
    }
    // A factor of 2⁶⁴ makes a subnormal number normal.
    let lifted = x * (1u128 << 64) as f64;
    (field(lifted) - 1023 - 64).max(-1074)
}

/// x · 2ᵏ, rounded only where the result leaves the normal numbers.
#[inline]
pub fn shifted<R: Real>(mut x: R, mut k: i32) -> R {
    // Every kind of number has 2^±100. Steps no larger than that lose no bits on the way to a normal number.
    const STEP: i32 = 100;
    while k != 0 {
        let part = k.clamp(-STEP, STEP);
        x = x * R::of(f64::from_bits(((1023 + part) as u64) << 52));
        k -= part;
    }
    x
}

/// Every component times 2ᵏ.
#[inline]
pub fn shifted_vector<R: Real>(v: Vec3<R>, k: i32) -> Vec3<R> {
    if k == 0 { v } else { v.map(|x| shifted(x, k)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact_to_the_ends_of_the_numbers() {
        let least = f64::from_bits(1);
        for (x, k) in [
            (1.0, 0),
            (1.99, 0),
            (0.5, -1),
            (3.0, 1),
            (-8.0, 3),
            (least, -1074),
        ] {
            assert_eq!(exponent(x), k, "{x}");
        }
        assert_eq!(exponent(0.0), -1074);
        assert_eq!(exponent(f64::MAX), 1023);
        assert_eq!(exponent(f64::MIN_POSITIVE / 2.0), -1023);
        assert_eq!(shifted(least, 1074), 1.0);
        assert_eq!(shifted(1.5, -1022), 1.5 * f64::MIN_POSITIVE);
        assert_eq!(shifted(1.0f32, -126), f32::MIN_POSITIVE);
        assert_eq!(shifted(1.0, 5000), f64::INFINITY);
    }
}
