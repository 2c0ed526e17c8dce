//! Picture files of all formats that `render` writes, read and made smaller. One picture is in memory at a time, and of
//! EXR and PFM only a few rows of it.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

use super::average::{Average, Thumbnail};
use crate::diagnostics::Complaint;
use crate::geometry::array::each;
use crate::trace::bitmap::Bitmap;
use crate::trace::decode::{Limits, Pixels, broken, rgb};

/// The name endings of files that may be pictures.
pub(super) const ENDINGS: [&str; 6] = ["png", "jpg", "jpeg", "webp", "exr", "pfm"];

/// The largest picture that is read: about a hundred million pixels.
const LIMITS: Limits = Limits {
    side: 1 << 20,
    bytes: 3 << 27,
    too_large: "sheet-picture-too-large",
};

/// Reads a picture and shrinks it to fit into `most`, in pixels. The file's first bytes tell its format.
///
/// # Errors
///
/// The file cannot be read or decoded, or the picture is too large.
pub(super) fn shrunk(path: &Path, most: [u32; 2]) -> Result<Thumbnail, Complaint> {
    let cannot = |e: io::Error| Complaint::from(&e);
    let mut file = BufReader::new(File::open(path).map_err(cannot)?);
    let start = file.fill_buf().map_err(cannot)?;
    match start {
        [b'R', b'I', b'F', b'F', ..] => webp(file).map(|bitmap| of_bitmap(&bitmap, most)),
        [0x76, 0x2f, 0x31, 0x01, ..] => exr(path, most),
        [b'P', b'F' | b'f', ..] => pfm(file, most),
        _ => Bitmap::read(path, &LIMITS).map(|bitmap| of_bitmap(&bitmap, most)),
    }
}

fn of_bitmap(bitmap: &Bitmap, most: [u32; 2]) -> Thumbnail {
    let [width, height] = bitmap.size();
    let mut all = Average::new([width, height], most);
    for y in 0..height as usize {
        for x in 0..width as usize {
            all.add(x, y, bitmap.texel(x, y).0);
        }
    }
    all.finish()
}

fn webp(file: BufReader<File>) -> Result<Bitmap, Complaint> {
    let mut decoder = image_webp::WebPDecoder::new(file).map_err(broken)?;
    let (width, height) = decoder.dimensions();
    LIMITS.check([width, height], 1)?;
    let samples = if decoder.has_alpha() { 4 } else { 3 };
    let mut data = vec![0; samples * width as usize * height as usize];
    decoder.read_image(&mut data).map_err(broken)?;
    let texels = Pixels::Eight(rgb(&data, samples));
    Ok(Bitmap::new([width, height], texels))
}

fn exr(path: &Path, most: [u32; 2]) -> Result<Thumbnail, Complaint> {
    use exr::prelude::*;
    let about = MetaData::read_from_file(path, false).map_err(broken)?;
    for header in &about.headers {
        let size = [header.layer_size.width(), header.layer_size.height()];
        LIMITS.check(size.map(|side| u32::try_from(side).unwrap_or(u32::MAX)), 1)?;
    }
    let begin = |size: Vec2<usize>, _: &_| {
        Average::new([size.width(), size.height()].map(|side| side as u32), most)
    };
    let add = |all: &mut Average, at: Vec2<usize>, (r, g, b): (f32, f32, f32)| {
        all.add(at.x(), at.y(), [r, g, b].map(f64::from));
    };
    let picture = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(begin, add)
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_file(path)
        .map_err(broken)?;
    Ok(picture.layer_data.channel_data.pixels.finish())
}

/// A portable float map: colours or greys, from the bottom row up.
fn pfm(mut file: BufReader<File>, most: [u32; 2]) -> Result<Thumbnail, Complaint> {
    let samples = match word(&mut file)?.as_str() {
        "PF" => 3,
        "Pf" => 1,
        _ => return Err(broken("")),
    };
    let mut side = || word(&mut file)?.parse::<u32>().map_err(broken);
    let size @ [width, height] = [side()?, side()?];
    let scale: f64 = word(&mut file)?.parse().map_err(broken)?;
    LIMITS.check(size, 1)?;
    if width == 0 || height == 0 {
        return Err(broken(""));
    }
    let mut all = Average::new(size, most);
    let mut row = vec![0; 4 * samples * width as usize];
    for y in (0..height as usize).rev() {
        file.read_exact(&mut row).map_err(broken)?;
        for (x, pixel) in row.chunks_exact(4 * samples).enumerate() {
            let number = |c: usize| {
                let at = 4 * (c % samples);
                let bytes = [pixel[at], pixel[at + 1], pixel[at + 2], pixel[at + 3]];
                // The sign of the scale says in which order the bytes are.
                f64::from(match scale < 0.0 {
                    true => f32::from_le_bytes(bytes),
                    false => f32::from_be_bytes(bytes),
                })
            };
            all.add(x, y, each([0, 1, 2], number));
        }
    }
    Ok(all.finish())
}

/// A word of a header, with the one blank after it.
fn word(file: &mut impl BufRead) -> Result<String, Complaint> {
    /// Most bytes of a word in a header.
    const MAX_WORD_BYTES: usize = 64;
    let mut word = String::new();
    while word.len() <= MAX_WORD_BYTES {
        let mut byte = [0];
        file.read_exact(&mut byte).map_err(broken)?;
        match byte[0] {
            blank if blank.is_ascii_whitespace() && word.is_empty() => {}
            blank if blank.is_ascii_whitespace() => return Ok(word),
            letter => word.push(letter.into()),
        }
    }
    Err(broken(""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture_files::{self, Format, Origin, Row};
    use crate::trace::Film;
    use std::io::Write;

    /// A picture whose rows and columns differ.
    fn film() -> Film {
        let colour = |i: usize| [i as f32 / 24.0, 0.5, if i < 12 { 0.0 } else { 1.0 }];
        Film {
            width: 6,
            height: 4,
            pixels: (0..24).map(colour).collect(),
        }
    }

    /// The picture in a file as `zpg render` writes it.
    fn drawn(format: Format) -> Vec<u8> {
        let origin = Origin {
            version: String::new(),
            scene: String::new(),
            settings: String::new(),
            size: [6, 4],
            rows: vec![[0, 4]],
            unfinished: false,
        };
        let film = film();
        let mut rows = film.rows().map(|row| Ok(Row::Linear(row.to_vec())));
        let mut bytes = Vec::new();
        picture_files::write(format, &mut bytes, &origin, &mut rows).unwrap();
        bytes
    }

    /// The picture as it is in files of 8 bits.
    fn encoded() -> Vec<u8> {
        let pixels = film().pixels;
        let codes = pixels.iter().flatten();
        codes.map(|&x| crate::trace::film::srgb8(x)).collect()
    }

    fn read(bytes: &[u8]) -> Result<Thumbnail, Complaint> {
        let mut file = tempfile::NamedTempFile::new().unwrap();
        file.write_all(bytes).unwrap();
        shrunk(file.path(), [240, 180])
    }

    fn files() -> [Vec<u8>; 4] {
        let mut all = [const { Vec::new() }; 4];
        let [png, webp, exr, pfm] = &mut all;
        film()
            .write_png(png, crate::trace::film::Packing::Quick)
            .unwrap();
        film().write_webp(webp).unwrap();
        *exr = drawn(Format::Exr);
        film().write_pfm(pfm).unwrap();
        all
    }

    #[test]
    fn every_format_without_loss_gives_the_same_picture() {
        for file in files() {
            let thumbnail = read(&file).unwrap();
            assert_eq!(thumbnail.original, [6, 4]);
            assert_eq!(thumbnail.size, [6, 4]);
            assert_eq!(thumbnail.rgb, encoded());
        }
        let mut jpeg = Vec::new();
        film().write_jpeg(&mut jpeg).unwrap();
        assert_eq!(read(&jpeg).unwrap().size, [6, 4]);
        // Grey, the higher byte first.
        let mut grey = b"Pf\n2 1\n1.0\n".to_vec();
        grey.extend([0.0f32, 1.0].iter().flat_map(|x| x.to_be_bytes()));
        assert_eq!(read(&grey).unwrap().rgb, [0, 0, 0, 255, 255, 255]);
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        for file in files() {
            for end in [0, 3, file.len() / 2, file.len() * 3 / 4] {
                let said = read(&file[..end]).unwrap_err().to_string();
                assert!(said.starts_with("it is damaged"), "{end}: {said}");
            }
        }
    }

    /// Whatever a file holds, it is a picture or it is refused.
    #[test]
    fn damaged_files_do_no_harm() {
        let mut jpeg = Vec::new();
        film().write_jpeg(&mut jpeg).unwrap();
        let files = files().into_iter().chain([jpeg]);
        let mut state = 1_u64;
        let mut random = |n: usize| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as usize % n
        };
        for file in files {
            for _ in 0..300 {
                let mut file = file.clone();
                for _ in 0..=random(3) {
                    let at = random(file.len());
                    file[at] = [0, 1, 0x7f, 0x80, 0xff, random(256) as u8][random(6)];
                }
                let _ = read(&file);
            }
        }
    }

    #[test]
    fn what_is_too_large_is_refused_at_once() {
        for size in ["1000000 1000000", "4294967295 1"] {
            let header = format!("PF\n{size}\n-1.0\n");
            let said = read(header.as_bytes()).unwrap_err().to_string();
            assert!(said.starts_with("it has "), "{said}");
        }
        let mut png = Vec::new();
        let mut encoder = png::Encoder::new(&mut png, 100_000, 100_000);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().unwrap();
        writer.write_chunk(png::chunk::IDAT, &[0; 9]).unwrap();
        drop(writer);
        let said = read(&png).unwrap_err().to_string();
        assert!(said.starts_with("it has 100000 × 100000 pixels"), "{said}");
    }
}
