//! Pictures, and the files they go into.

#![warn(missing_docs)]

use super::bitmap;
use crate::geometry::array::each;
use crate::scene::Rgb;
use std::io::{self, Write};
use std::sync::LazyLock;

/// A picture of linear RGB, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// The linear RGB of each pixel: finite numbers, not less than 0.
    pub pixels: Vec<[f32; 3]>,
}

/// A linear colour as a film keeps it, in single precision. Negative numbers become 0, and too large ones the largest
/// number.
pub fn developed(colour: Rgb) -> [f32; 3] {
    each(colour, |x| {
        let x = x.max(0.0).min(f32::MAX as f64);
        x as f32
    })
}

/// Whether a channel of a linear colour is brighter than white, by more than roundings.
pub fn is_above_white<T: Into<f64>>(colour: [T; 3]) -> bool {
    /// White, with room for the rounding errors of lights that are white together.
    const WHITE: f64 = 1.001;
    colour.into_iter().any(|x| x.into() > WHITE)
}

/// The percentage of pixels that may be brighter than white without a note; highlights usually are.
pub const MAX_BRIGHT_PERCENT: f64 = 1.0;

/// The sRGB transfer function (IEC 61966-2-1) of a number from 0 to 1, to 8 bits.
fn encoded(x: f64) -> u8 {
    let y = if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * libm::pow(x, 1.0 / 2.4) - 0.055
    };
    (y * 255.0).round() as u8
}

/// The least linear numbers that sRGB encodes as 1, 2, … 255.
static STEPS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let is_beyond = |x: f32| usize::from(encoded(f64::from(x))) > i;
        // The encoding i + ½ is rounded up from here on, but rounding errors may have moved the place by a few steps.
        let mut step = bitmap::linear((i as f64 + 0.5) / 255.0) as f32;
        while !is_beyond(step) {
            step = step.next_up();
        }
        while is_beyond(step.next_down()) {
            step = step.next_down();
        }
        step
    })
});

/// The number of last bits of a number that [`STARTS`] ignores. The other bits are the sign, the exponent and eight
/// binary digits. They tell the encoding of the number, or one less.
const DIGITS: u32 = f32::MANTISSA_DIGITS - 1 - 8;

/// For all numbers from 0 to 1 that are equal but for their last [`DIGITS`] bits: the sRGB encoding of the least of
/// them.
static STARTS: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let last = 1f32.to_bits() >> DIGITS;
    let mut code = 0;
    let start = |kind: u32| {
        let least = f32::from_bits(kind << DIGITS);
        while STEPS.get(code).is_some_and(|&step| step <= least) {
            code += 1;
        }
        code as u8
    };
    (0..=last).map(start).collect()
});

/// The sRGB transfer function (IEC 61966-2-1), to 8 bits; numbers out of range are clipped.
pub fn srgb8(linear: f32) -> u8 {
    // A NaN fails the comparison and becomes black.
    let in_range = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
    let start = STARTS[(in_range.to_bits() >> DIGITS) as usize];
    start + u8::from(start < u8::MAX && STEPS[usize::from(start)] <= in_range)
}

/// How a PNG is packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Packing {
    /// Packing for a file: about a tenth larger than `Small`, and several times as quick.
    Quick,
    /// Packing for a picture that is sent, or is part of a page.
    Small,
}

/// Writes a PNG of 8-bit sRGB. `rgb` are the rows from the top, with red, green and blue of each pixel.
pub fn write_rgb8(out: impl Write, size: [u32; 2], rgb: &[u8], packing: Packing) -> io::Result<()> {
    write_rgb(out, size, png::BitDepth::Eight, rgb, packing)
}

/// Like [`write_rgb8`], with samples of any depth. A sample of 16 bits is two bytes, the higher one first.
pub fn write_rgb(
    out: impl Write,
    size: [u32; 2],
    depth: png::BitDepth,
    rgb: &[u8],
    packing: Packing,
) -> io::Result<()> {
    let mut writer = encoder(out, size, depth, packing).write_header()?;
    writer.write_image_data(rgb)?;
    writer.finish()?;
    Ok(())
}

/// An encoder of PNG in sRGB.
pub fn encoder<W: Write>(
    out: W,
    [width, height]: [u32; 2],
    depth: png::BitDepth,
    packing: Packing,
) -> png::Encoder<'static, W> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(depth);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    if packing == Packing::Quick {
        encoder.set_compression(png::Compression::Fast);
        encoder.set_filter(png::Filter::Up);
    }
    encoder
}

/// Quality of JPEG files, from 1 to 100.
const JPEG_QUALITY: u8 = 95;

impl Film {
    /// The linear RGB of a pixel; (0, 0) is at the top left.
    pub fn pixel(&self, x: u32, y: u32) -> [f32; 3] {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Writes a PNG of 8-bit sRGB.
    pub fn write_png(&self, out: impl Write, packing: Packing) -> io::Result<()> {
        write_rgb8(out, [self.width, self.height], &self.rgb8(), packing)
    }

    /// Writes a JPEG of 8-bit sRGB, of nearly the highest quality and without chroma subsampling.
    pub fn write_jpeg(&self, out: impl Write) -> io::Result<()> {
        use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
        let mut encoder = Encoder::new(out, JPEG_QUALITY);
        encoder.set_sampling_factor(SamplingFactor::F_1_1);
        let [width, height] = [self.width, self.height].map(u16::try_from);
        let too_large = |_| io::Error::other("a JPEG is at most 65535 pixels wide and high");
        let (width, height) = (width.map_err(too_large)?, height.map_err(too_large)?);
        let encoded = encoder.encode(&self.rgb8(), width, height, ColorType::Rgb);
        encoded.map_err(io::Error::other)
    }

    /// Writes a WebP of 8-bit sRGB, without loss.
    pub fn write_webp(&self, out: impl Write) -> io::Result<()> {
        use image_webp::{ColorType, WebPEncoder};
        let encoder = WebPEncoder::new(out);
        let encoded = encoder.encode(&self.rgb8(), self.width, self.height, ColorType::Rgb8);
        encoded.map_err(io::Error::other)
    }

    /// Makes all pixels `times` times as bright.
    pub fn expose(&mut self, times: f64) {
        for pixel in &mut self.pixels {
            *pixel = developed(pixel.map(|x| f64::from(x) * times));
        }
    }

    /// 8-bit sRGB, row by row from the top.
    fn rgb8(&self) -> Vec<u8> {
        self.pixels.iter().flatten().map(|&x| srgb8(x)).collect()
    }

    /// Writes a portable float map: linear, unclamped, little-endian, from the bottom row up.
    pub fn write_pfm(&self, mut out: impl Write) -> io::Result<()> {
        write!(out, "PF\n{} {}\n-1.0\n", self.width, self.height)?;
        let mut bytes = Vec::with_capacity(self.pixels.len() * 12);
        for row in self.pixels.chunks_exact(self.width.max(1) as usize).rev() {
            bytes.extend(row.iter().flatten().flat_map(|x| x.to_le_bytes()));
        }
        out.write_all(&bytes)
    }
}

impl Film {
    /// The rows of the picture, from the top.
    pub fn rows(&self) -> impl Iterator<Item = &[[f32; 3]]> {
        self.pixels.chunks_exact(self.width.max(1) as usize)
    }

    /// This picture on the left and another of the same size on its right.
    pub fn beside(&self, right: &Film) -> Film {
        let width = self.width.max(1) as usize;
        let rows = self.pixels.chunks(width).zip(right.pixels.chunks(width));
        Film {
            width: self.width + right.width,
            height: self.height,
            pixels: rows.flat_map(|(l, r)| [l, r].concat()).collect(),
        }
    }

    /// An anaglyph for glasses of red and cyan: red of this picture, which is the left one, green and blue of the right
    /// one.
    pub fn anaglyph(&self, right: &Film) -> Film {
        let both = self.pixels.iter().zip(&right.pixels);
        Film {
            width: self.width,
            height: self.height,
            pixels: both.map(|(l, r)| [l[0], r[1], r[2]]).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_where_the_transfer_function_steps() {
        let encoded = |bits: u32| usize::from(encoded(f64::from(f32::from_bits(bits))));
        for (i, step) in STEPS.iter().enumerate() {
            let bits = step.to_bits();
            assert_eq!([encoded(bits - 1), encoded(bits)], [i, i + 1]);
            assert_eq!(usize::from(srgb8(*step)), i + 1);
            assert_eq!(usize::from(srgb8(f32::from_bits(bits - 1))), i);
        }
    }
}
