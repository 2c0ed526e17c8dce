//! Reads the pictures that [`write()`](super::write()) writes.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use exr::block::UncompressedBlock;
use exr::block::reader::{AllChunksReader, ChunksReader, SequentialBlockDecompressor};
use exr::meta::attribute::{AttributeValue, SampleType};

use super::{Format, Origin, Row};
use crate::diagnostics::Complaint;

/// The most pixels of a row that is read.
const MAX_WIDTH: u32 = 1 << 24;

/// A picture file whose rows are read one after the other.
pub struct Rows {
    pub origin: Origin,
    pub format: Format,
    left: u32,
    source: Source,
}

enum Source {
    Png(Box<png::Reader<BufReader<File>>>),
    Exr {
        blocks: Box<SequentialBlockDecompressor<AllChunksReader<BufReader<File>>>>,
        /// Rows of the last block that have not been returned, the next one at the end.
        rows: Vec<Row>,
        /// The number of rows in all blocks that have been read.
        taken: usize,
    },
}

/// Opens a picture that zpg has drawn.
///
/// # Errors
///
/// The file cannot be read, is no PNG or EXR, has no origin, or has another size or other channels than its origin
/// promises.
pub fn open(path: &Path) -> Result<Rows, Complaint> {
    let fail = |e: io::Error| unreadable(path, Complaint::from(&e));
    let mut file = BufReader::new(File::open(path).map_err(fail)?);
    let start = file.fill_buf().map_err(fail)?;
    let opened = match start {
        [0x89, b'P', b'N', b'G', ..] => png_rows(file),
        [0x76, 0x2f, 0x31, 0x01, ..] => exr_rows(file),
        _ => Err(Fault::NoPart),
    };
    opened.map_err(|fault| fault.complaint(path))
}

/// Whether a file is a picture drawn by zpg in which some rows are missing.
pub fn is_part(path: &Path) -> bool {
    open(path).is_ok_and(|rows| !rows.origin.is_whole())
}

/// The reason why a file is not read.
enum Fault {
    /// A file that is no picture drawn by zpg: it has no origin, or does not fit its origin.
    NoPart,
    /// A file that ends too early, or is damaged.
    Broken,
}

impl Fault {
    fn complaint(self, path: &Path) -> Complaint {
        let what = match self {
            Fault::NoPart => "not-drawn-by-zpg",
            Fault::Broken => "picture-cut-off",
        };
        Complaint::new(what).with("path", path)
    }
}

fn unreadable(path: &Path, why: Complaint) -> Complaint {
    Complaint::new("cannot-read")
        .with("path", path)
        .with("reason", why)
}

/// Whether a file of this width and height can have this origin.
fn fits(origin: &Origin, [width, height]: [u32; 2]) -> bool {
    width == origin.size[0] && height == origin.span()[1] && (1..=MAX_WIDTH).contains(&width)
}

fn png_rows(file: BufReader<File>) -> Result<Rows, Fault> {
    let decoder = png::Decoder::new(file);
    let reader = decoder.read_info().map_err(|_| Fault::Broken)?;
    let info = reader.info();
    let texts = info.uncompressed_latin1_text.iter();
    let mut texts = texts.filter(|text| text.keyword == Origin::NAME);
    let origin = texts.find_map(|text| Origin::from_text(&text.text));
    let origin = origin.ok_or(Fault::NoPart)?;
    let is_ours = info.color_type == png::ColorType::Rgb && info.bit_depth == png::BitDepth::Eight;
    if !is_ours || !fits(&origin, [info.width, info.height]) {
        return Err(Fault::NoPart);
    }
    Ok(Rows {
        left: origin.span()[1],
        origin,
        format: Format::Png,
        source: Source::Png(Box::new(reader)),
    })
}

fn exr_rows(file: BufReader<File>) -> Result<Rows, Fault> {
    let reader = exr::block::read(file, false).map_err(|_| Fault::Broken)?;
    let [header] = reader.headers() else {
        return Err(Fault::NoPart);
    };
    let origin = match header.own_attributes.other.get(Origin::NAME.as_bytes()) {
        Some(AttributeValue::Text(text)) => Origin::from_text(&text.to_string()),
        _ => None,
    };
    let origin = origin.ok_or(Fault::NoPart)?;
    let channels = &header.channels.list;
    let names = channels.iter().map(|c| c.name.to_string());
    let is_ours = names.eq(["B", "G", "R"])
        && (channels.iter()).all(|c| c.sample_type == SampleType::F32 && c.sampling.area() == 1);
    let size =
        [header.layer_size.x(), header.layer_size.y()].map(|n| u32::try_from(n).unwrap_or(0));
    if !is_ours || !fits(&origin, size) {
        return Err(Fault::NoPart);
    }
    let chunks = reader.all_chunks(false).map_err(|_| Fault::Broken)?;
    Ok(Rows {
        left: origin.span()[1],
        origin,
        format: Format::Exr,
        source: Source::Exr {
            blocks: Box::new(chunks.sequential_decompressor(false)),
            rows: Vec::new(),
            taken: 0,
        },
    })
}

impl Rows {
    /// The next row; `None` after the last one.
    ///
    /// # Errors
    ///
    /// The file ends too early, or is damaged.
    fn row(&mut self) -> Result<Option<Row>, Fault> {
        if self.left == 0 {
            return Ok(None);
        }
        self.left -= 1;
        let width = self.origin.size[0] as usize;
        let row = match &mut self.source {
            Source::Png(reader) => {
                let row = reader.next_row().map_err(|_| Fault::Broken)?;
                let row = row.ok_or(Fault::Broken)?.data().to_vec();
                // The end of the file, after the last row, may be damaged as well.
                if self.left == 0 {
                    reader.finish().map_err(|_| Fault::Broken)?;
                }
                Row::Srgb(row)
            }
            Source::Exr {
                blocks,
                rows,
                taken,
            } => {
                if rows.is_empty() {
                    let block = blocks.decompress_next_block().ok_or(Fault::Broken)?;
                    *rows = of_block(&block.map_err(|_| Fault::Broken)?, width, *taken)?;
                    *taken += rows.len();
                    rows.reverse();
                }
                rows.pop().ok_or(Fault::Broken)?
            }
        };
        Ok(Some(row))
    }

    /// All rows that have not been read. If the file is damaged, the last item is an error about `path`.
    pub fn all(mut self, path: &Path) -> impl Iterator<Item = Result<Row, Complaint>> {
        std::iter::from_fn(move || {
            let row = self.row().map_err(|fault| fault.complaint(path));
            // No rows follow an error.
            if row.is_err() {
                self.left = 0;
            }
            row.transpose()
        })
    }
}

/// The rows of a block that must begin at row `first` of the file.
fn of_block(block: &UncompressedBlock, width: usize, first: usize) -> Result<Vec<Row>, Fault> {
    let index = &block.index;
    let line = 4 * width;
    let is_next = index.pixel_position.y() == first && index.pixel_size.x() == width;
    if !is_next || block.data.len() != index.pixel_size.y() * 3 * line {
        return Err(Fault::Broken);
    }
    let number = |bytes: &[u8]| f32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let rows = block.data.chunks_exact(3 * line).map(|row| {
        let at = |channel: usize, x: usize| number(&row[channel * line + 4 * x..][..4]);
        let pixel = |x| [2, 1, 0].map(|channel| at(channel, x));
        Row::Linear((0..width).map(pixel).collect())
    });
    Ok(rows.collect())
}
