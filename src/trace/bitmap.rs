//! A decoded picture.

use super::decode::{Limits, Pixels, decode};
use super::film::{Packing, write_rgb};
use crate::diagnostics::Complaint;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use crate::scene::Rgb;
use std::path::Path;
use std::sync::LazyLock;

/// The most columns and the most rows a picture may have.
pub const MAX_SIDE: u32 = 8192;

/// A decoded picture, still in sRGB, row by row from the top, three numbers a texel.
#[derive(Debug, Clone, PartialEq)]
pub struct Bitmap {
    width: u32,
    height: u32,
    texels: Pixels,
}

/// The inverse of the sRGB transfer function (IEC 61966-2-1), of a number in [0, 1].
pub fn linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        libm::pow((encoded + 0.055) / 1.055, 2.4)
    }
}

/// The linear values of the encoded numbers 0, 1, … `max`, where `max` is white.
fn table(max: u32) -> Vec<f64> {
    let max = f64::from(max);
    (0..=max as u32)
        .map(|i| linear(f64::from(i) / max))
        .collect()
}

static EIGHT: LazyLock<Vec<f64>> = LazyLock::new(|| table(255));
static SIXTEEN: LazyLock<Vec<f64>> = LazyLock::new(|| table(65_535));

impl Bitmap {
    /// A bitmap of three numbers a texel.
    pub fn new([width, height]: [u32; 2], texels: Pixels) -> Bitmap {
        Bitmap {
            width,
            height,
            texels,
        }
    }

    /// Reads a PNG or JPEG file.
    ///
    /// # Errors
    ///
    /// The file cannot be read or decoded, or the picture is too large.
    pub fn read(path: &Path, limits: &Limits) -> Result<Bitmap, Complaint> {
        decode(path, limits).map(|(size, texels)| Bitmap::new(size, texels))
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The picture as a PNG: the same texels in sRGB, with the same number of bits.
    pub fn png(&self) -> Vec<u8> {
        let wide: Vec<u8>;
        let (depth, samples) = match &self.texels {
            Pixels::Eight(t) => (png::BitDepth::Eight, t),
            Pixels::Sixteen(t) => {
                wide = t.iter().flat_map(|x| x.to_be_bytes()).collect();
                (png::BitDepth::Sixteen, &wide)
            }
        };
        let mut out = Vec::new();
        // Writing to memory does not fail.
        let _ = write_rgb(
            &mut out,
            [self.width, self.height],
            depth,
            samples,
            Packing::Small,
        );
        out
    }

    pub fn bytes(&self) -> u64 {
        match &self.texels {
            Pixels::Eight(t) => t.len() as u64,
            Pixels::Sixteen(t) => t.len() as u64 * 2,
        }
    }

    /// Linear RGB of a texel; x to the right and y down.
    pub fn texel(&self, x: usize, y: usize) -> Vec3 {
        let at = (y * self.width as usize + x) * 3;
        Vec3(match &self.texels {
            Pixels::Eight(t) => each([0, 1, 2], |c| EIGHT[t[at + c] as usize]),
            Pixels::Sixteen(t) => each([0, 1, 2], |c| SIXTEEN[t[at + c] as usize]),
        })
    }

    /// Linear RGB at (u, v), v upwards from the lower edge: the picture covers the unit square and
    /// repeats beyond it. Between the centres of texels the value is bilinear, across the edges
    /// too.
    pub fn colour(&self, uv: [f64; 2]) -> Rgb {
        // A coordinate that is not finite is no place in the picture; 0 stands for it.
        let [u, v] = each(uv, |x| if x.is_finite() { x - x.floor() } else { 0.0 });
        let [x0, x1, fx] = neighbours(u, self.width);
        let [y0, y1, fy] = neighbours(1.0 - v, self.height);
        let at = |x: f64, y: f64| self.texel(x as usize, y as usize);
        let above = at(x0, y0) * (1.0 - fx) + at(x1, y0) * fx;
        let below = at(x0, y1) * (1.0 - fx) + at(x1, y1) * fx;
        (above * (1.0 - fy) + below * fy).0
    }
}

/// The two neighbours between whose centres `s` lies, of `n` texels on the unit interval: their numbers, and the share
/// of the way from the first centre to the second at which `s` lies.
fn neighbours(s: f64, n: u32) -> [f64; 3] {
    let n = f64::from(n);
    let place = s * n - 0.5;
    let first = place.floor();
    [
        first.rem_euclid(n),
        (first + 1.0).rem_euclid(n),
        place - first,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red and green above, blue and white below.
    fn four() -> Bitmap {
        let rgb = [255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255];
        Bitmap {
            width: 2,
            height: 2,
            texels: Pixels::Eight(rgb.into()),
        }
    }

    #[test]
    fn centres_of_texels_have_their_colours() {
        for shift in [0.0, 1.0, -3.0] {
            let at = |u: f64, v: f64| four().colour([u + shift, v - shift]);
            assert_eq!(at(0.25, 0.25), [0.0, 0.0, 1.0]);
            assert_eq!(at(0.75, 0.25), [1.0, 1.0, 1.0]);
            assert_eq!(at(0.25, 0.75), [1.0, 0.0, 0.0]);
            assert_eq!(at(0.75, 0.75), [0.0, 1.0, 0.0]);
        }
    }

    #[test]
    fn between_them_it_is_bilinear_across_the_edges_too() {
        assert_eq!(four().colour([0.5, 0.75]), [0.5, 0.5, 0.0]);
        assert_eq!(four().colour([0.0, 0.75]), [0.5, 0.5, 0.0]);
        assert_eq!(four().colour([0.25, 0.0]), [0.5, 0.0, 0.5]);
        assert_eq!(four().colour([0.375, 0.75]), [0.75, 0.25, 0.0]);
        assert_eq!(four().colour([f64::INFINITY, f64::NAN]), [0.5, 0.5, 0.5]);
        // So little below 0 that it is rounded to 1.
        assert_eq!(four().colour([-1e-30, 0.75]), [0.5, 0.5, 0.0]);
    }

    #[test]
    fn eight_and_sixteen_bits_are_the_same_scale() {
        assert_eq!(EIGHT[0], 0.0);
        assert_eq!(EIGHT[255], 1.0);
        for i in 0..256 {
            assert_eq!(EIGHT[i], SIXTEEN[i * 257]);
        }
    }
}
