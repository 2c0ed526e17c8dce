//! PNG and JPEG files decoded.

use super::orientation::Orientation;
use crate::diagnostics::Complaint;
use std::fmt::Display;
use std::fs;
use std::io::Cursor;
use std::path::Path;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// The samples of a picture, of 8 or 16 bits: row by row from the top, three numbers a pixel.
#[derive(Debug, Clone, PartialEq)]
pub enum Pixels {
    Eight(Vec<u8>),
    Sixteen(Vec<u16>),
}

/// How large a picture may be.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// The most columns, and the most rows.
    pub side: u32,
    /// The most bytes that the decoded pixels may take.
    pub bytes: u64,
    /// The message about a picture that takes more bytes. The message is given the picture's `width` and `height`.
    pub too_large: &'static str,
}

/// Width, height and pixels of a file; grey becomes RGB, and alpha is ignored.
///
/// # Errors
///
/// The file cannot be read or decoded, or the picture is too large.
pub fn decode(path: &Path, limits: &Limits) -> Result<([u32; 2], Pixels), Complaint> {
    let file = fs::read(path).map_err(|e| Complaint::from(&e))?;
    match file.starts_with(b"\x89PNG") {
        true => png(&file, limits),
        false => jpeg(&file, limits),
    }
}

impl Limits {
    /// Refuses a picture that is too large. `sample` is the number of bytes that a sample takes; a pixel has three
    /// samples.
    pub fn check(&self, [width, height]: [u32; 2], sample: u64) -> Result<(), Complaint> {
        let sized = |message| {
            Complaint::new(message)
                .with("width", width.to_string())
                .with("height", height.to_string())
        };
        if width.max(height) > self.side {
            return Err(sized("picture-too-wide").with("side", self.side.to_string()));
        }
        let bytes = (u64::from(width) * u64::from(height)).saturating_mul(3 * sample);
        match bytes > self.bytes {
            true => Err(sized(self.too_large)),
            false => Ok(()),
        }
    }
}

/// The complaint about a picture that cannot be decoded. The decoder's own message names parts of the formats, which is
/// of no use to whoever has drawn the scene.
pub fn broken(_: impl Display) -> Complaint {
    Complaint::new("picture-broken")
}

fn png(file: &[u8], limits: &Limits) -> Result<([u32; 2], Pixels), Complaint> {
    let mut decoder = png::Decoder::new(Cursor::new(file));
    // Palettes become colours, and samples of less than 8 bits take 8.
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(broken)?;
    let size = [reader.info().width, reader.info().height];
    let (colour, depth) = reader.output_color_type();
    let sample = if depth == png::BitDepth::Sixteen {
        2
    } else {
        1
    };
    limits.check(size, sample)?;
    let length = reader.output_buffer_size();
    let mut data = vec![0; length.ok_or_else(|| Complaint::new("pictures-too-large"))?];
    let frame = reader.next_frame(&mut data).map_err(broken)?;
    data.truncate(frame.buffer_size());
    let samples = colour.samples();
    let pixels = match depth {
        png::BitDepth::Sixteen => {
            let wide: Vec<u16> = (data.chunks_exact(2))
                .map(|pair| u16::from_be_bytes([pair[0], pair[1]]))
                .collect();
            Pixels::Sixteen(rgb(&wide, samples))
        }
        _ => Pixels::Eight(rgb(&data, samples)),
    };
    Ok((size, pixels))
}

/// The colours of pixels, three numbers each. `samples` numbers a pixel are given: 1 for grey, 2 for grey and alpha, 3
/// for RGB, 4 for RGB and alpha.
pub fn rgb<T: Copy>(data: &[T], samples: usize) -> Vec<T> {
    let pixels = data.chunks_exact(samples);
    match samples {
        1 | 2 => pixels.flat_map(|p| [p[0]; 3]).collect(),
        _ => pixels.flat_map(|p| [p[0], p[1], p[2]]).collect(),
    }
}

fn jpeg(file: &[u8], limits: &Limits) -> Result<([u32; 2], Pixels), Complaint> {
    let options = DecoderOptions::default()
        .set_strict_mode(false)
        .set_max_width(usize::MAX)
        .set_max_height(usize::MAX);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(file), options);
    decoder.decode_headers().map_err(broken)?;
    let (width, height) = decoder.dimensions().unwrap_or_default();
    // Sides of JPEG are numbers of 16 bits.
    let size = [width as u32, height as u32];
    limits.check(size, 1)?;
    if !first_is_finest(file) {
        return Err(Complaint::new("picture-broken"));
    }
    let (colours, samples) = match decoder.input_colorspace() {
        Some(ColorSpace::Luma) => (ColorSpace::Luma, 1),
        _ => (ColorSpace::RGB, 3),
    };
    let orientation = Orientation::of(decoder.exif().map(Vec::as_slice));
    decoder.set_options(options.jpeg_set_out_colorspace(colours));
    let data = decoder.decode().map_err(broken)?;
    let (size, pixels) = orientation.upright(size, rgb(&data, samples));
    Ok((size, Pixels::Eight(pixels)))
}

/// Whether no component of a JPEG has more samples, across or down, than the first: the decoder relies on it, and
/// decodes other pictures wrongly.
fn first_is_finest(file: &[u8]) -> bool {
    // The segments after the two bytes that every JPEG begins with.
    let mut rest = file.get(2..).unwrap_or_default();
    while let [0xff, tail @ ..] = rest {
        match tail {
            // Any number of fill bytes may stand before a segment.
            [0xff, ..] => rest = tail,
            // The header of a frame. Three markers in its range mean something else: tables of codes, a reserved one,
            // and arithmetic coding.
            [0xc0..=0xcf, _, _, _, _, _, _, _, count, components @ ..]
                if !matches!(tail[0], 0xc4 | 0xc8 | 0xcc) =>
            {
                let samples = |c: &[u8]| [c[1] >> 4, c[1] & 15];
                let mut samples = components
                    .chunks_exact(3)
                    .take((*count).into())
                    .map(samples);
                let first = samples.next().unwrap_or_default();
                return samples.all(|n| n[0] <= first[0] && n[1] <= first[1]);
            }
            [_, high, low, ..] => {
                let length = usize::from(u16::from_be_bytes([*high, *low]));
                rest = tail.get(1 + length..).unwrap_or_default();
            }
            _ => break,
        }
    }
    true
}
