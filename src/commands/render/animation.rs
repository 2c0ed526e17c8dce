//! Animated pictures (APNG), made of PNG files.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use crate::commands::atomic_file;
use crate::diagnostics::Complaint;
use crate::trace::film::{Packing, encoder};

/// Writes an animated picture that is shown again and again, from PNG files of 8-bit sRGB and one size. Returns its
/// width and height in pixels.
pub(super) fn write(path: &Path, pictures: &[PathBuf], fps: u16) -> Result<[u32; 2], Complaint> {
    let mut size = [0; 2];
    atomic_file::write(path, |out| {
        size = animated(out, pictures, fps)?;
        Ok(())
    })?;
    Ok(size)
}

fn animated(out: &mut dyn Write, pictures: &[PathBuf], fps: u16) -> io::Result<[u32; 2]> {
    let mut pictures = pictures.iter().map(|path| read(path));
    let count = pictures.len() as u32;
    let nothing = || io::Error::other("an animated picture without frames");
    let (size, first) = pictures.next().ok_or_else(nothing)??;
    let mut encoder = encoder(out, size, png::BitDepth::Eight, Packing::Small);
    encoder.set_animated(count, 0)?;
    encoder.set_frame_delay(1, fps)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&first)?;
    for picture in pictures {
        writer.write_image_data(&picture?.1)?;
    }
    writer.finish()?;
    Ok(size)
}

/// Reads a PNG that this run has drawn: its width and height, and the bytes of its pixels.
fn read(path: &Path) -> io::Result<([u32; 2], Vec<u8>)> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let length = reader.output_buffer_size();
    let length = length.ok_or_else(|| io::Error::from(io::ErrorKind::OutOfMemory))?;
    let mut pixels = vec![0; length];
    let info = reader.next_frame(&mut pixels)?;
    pixels.truncate(info.buffer_size());
    Ok(([info.width, info.height], pixels))
}
