//! Writes pictures, row by row.

use std::io::{self, BufWriter, Read, Seek, Write};

use exr::block::chunk::Chunk;
use exr::block::lines::LineIndex;
use exr::block::writer::ChunksWriter;
use exr::block::{BlockIndex, UncompressedBlock};
use exr::error::{Error, UnitResult};
use exr::math::Vec2;
use exr::meta::BlockDescription;
use exr::meta::attribute::{
    AttributeValue, ChannelDescription, IntegerBounds, LineOrder, SampleType, Text,
};
use exr::meta::header::Header;
use exr::prelude::Compression;

use super::{Format, Origin, Row};
use crate::trace::film::{self, Packing};

/// Rows from the top, each as wide as the picture.
type Rows<'r> = &'r mut dyn Iterator<Item = io::Result<Row>>;

/// Writes a picture file with an [`Origin`] and all rows from its first to its last; the same rows give the same bytes.
///
/// # Errors
///
/// The errors of the rows and of writing. Rows of sRGB for an EXR, and too few or too many rows, are errors as well.
pub fn write(format: Format, out: &mut dyn Write, origin: &Origin, rows: Rows) -> io::Result<()> {
    match format {
        Format::Png => write_png(out, origin, rows),
        Format::Exr => {
            // An EXR has a table at its start that is filled in at the end, so it is written to a file that can seek.
            let mut file = tempfile::tempfile()?;
            write_exr(&mut file, origin, rows).map_err(io_error)?;
            file.rewind()?;
            copy(&mut file, out)
        }
    }
}

/// Copies all bytes, like `io::copy`, to a writer that is a trait object.
fn copy(from: &mut impl Read, to: &mut dyn Write) -> io::Result<()> {
    let mut buffer = vec![0; 1 << 16];
    loop {
        match from.read(&mut buffer)? {
            0 => return Ok(()),
            n => to.write_all(&buffer[..n])?,
        }
    }
}

fn write_png(out: &mut dyn Write, origin: &Origin, rows: Rows) -> io::Result<()> {
    let size = [origin.size[0], origin.span()[1]];
    let mut encoder = film::encoder(out, size, png::BitDepth::Eight, Packing::Quick);
    encoder.add_text_chunk(Origin::NAME.to_owned(), origin.to_text())?;
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer_with_size(1 << 16)?;
    for row in rows {
        stream.write_all(&row?.into_srgb())?;
    }
    stream.finish()?;
    writer.finish()?;
    Ok(())
}

fn write_exr(file: impl Write + Seek, origin: &Origin, rows: Rows) -> UnitResult {
    let [width, height] = origin.size.map(|side| side as usize);
    let [first, count] = origin.span();
    let first = i32::try_from(first).map_err(|_| Error::Invalid("too many rows".into()))?;
    // An EXR has its channels in the order of their names.
    let channels = ["B", "G", "R"].map(|name| ChannelDescription::named(name, SampleType::F32));
    let mut header = Header::new(
        "main".into(),
        (width, count as usize),
        channels.into_iter().collect(),
    )
    .with_encoding(
        Compression::ZIP16,
        BlockDescription::ScanLines,
        LineOrder::Increasing,
    );
    header.own_attributes.layer_name = None;
    header.own_attributes.layer_position = Vec2(0, first);
    let whole = IntegerBounds::from_dimensions(Vec2(width, height));
    header.shared_attributes.display_window = whole;
    let text = Text::from(origin.to_text().as_str());
    let others = &mut header.own_attributes.other;
    others.insert(Origin::NAME.into(), AttributeValue::Text(text));
    let lines = header.compression.scan_lines_per_block();
    let headers = std::iter::once(header).collect();
    exr::block::write(BufWriter::new(file), headers, true, |meta, chunks| {
        let mut number = 0;
        let mut block = Vec::with_capacity(lines);
        for row in rows {
            match row.map_err(Error::Io)? {
                Row::Linear(row) if row.len() == width => block.push(row),
                _ => return Err(Error::Invalid("rows are linear and of one width".into())),
            }
            if block.len() == lines {
                chunks.write_chunk(number, chunk(&block, number * lines, &meta.headers)?)?;
                number += 1;
                block.clear();
            }
        }
        if !block.is_empty() {
            chunks.write_chunk(number, chunk(&block, number * lines, &meta.headers)?)?;
        }
        Ok(())
    })
}

/// Compresses a block of rows. `first` is the number of its first row in the file.
fn chunk(rows: &[Vec<[f32; 3]>], first: usize, headers: &[Header]) -> exr::error::Result<Chunk> {
    let index = BlockIndex {
        layer: 0,
        pixel_position: Vec2(0, first),
        pixel_size: Vec2(rows[0].len(), rows.len()),
        level: Vec2(0, 0),
    };
    let pixels = UncompressedBlock::from_lines(&headers[0].channels, index, |line| {
        let LineIndex {
            position, channel, ..
        } = line.location;
        let numbers = rows[position.y() - first]
            .iter()
            .map(|pixel| pixel[2 - channel]);
        for (bytes, number) in line.value.chunks_exact_mut(4).zip(numbers) {
            bytes.copy_from_slice(&number.to_ne_bytes());
        }
    });
    pixels.compress_to_chunk(headers)
}

fn io_error(error: Error) -> io::Error {
    match error {
        Error::Io(error) => error,
        other => io::Error::other(other),
    }
}
