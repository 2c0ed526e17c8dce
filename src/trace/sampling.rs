//! Places of the samples in a pixel.

use crate::geometry::array::each;

/// The reciprocals of the plastic number and of its square: the additive recurrence that fills the
/// square most evenly (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
const STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_2];

/// Sample `i` of `n` in pixel (x, y), in [0, 1)². A single sample is the centre. Several samples are shifted together,
/// around the edges of the pixel, by an amount that depends on the pixel alone.
#[inline]
pub fn sample(x: u32, y: u32, i: u32, n: u32) -> [f64; 2] {
    if n <= 1 {
        return [0.5, 0.5];
    }
    let seed = hash((u64::from(y) << 32) | u64::from(x));
    let shift = each([seed >> 32, seed & 0xffff_ffff], |h| {
        h as f64 / 4_294_967_296.0
    });
    each([0, 1], |k| (shift[k] + STEP[k] * f64::from(i)).fract())
}

/// The finaliser of splitmix64 (Steele, Lea and Flood, 2014).
pub fn hash(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
