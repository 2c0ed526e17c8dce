//! Picture files in PNG and OpenEXR, row by row, with a statement of their origin.
//!
//! `render` and `join` write with the same [`write()`], so that a picture joined from parts has the same bytes as one
//! that was drawn at once. Neither writing nor [reading](read::Rows) holds more than a few rows.

mod origin;
pub mod read;
mod write;

pub use origin::Origin;
pub use read::is_part;
pub use write::write;

use std::path::Path;

use crate::trace::film::srgb8;

/// The formats that have room for an [`Origin`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// 8-bit sRGB.
    Png,
    /// Linear, unclamped, 32-bit float.
    Exr,
}

impl Format {
    /// The format by the ending of a name; `None` for unknown endings.
    pub fn of(path: &Path) -> Option<Format> {
        let ending = path.extension()?.to_string_lossy().to_lowercase();
        match ending.as_str() {
            "png" => Some(Format::Png),
            "exr" => Some(Format::Exr),
            _ => None,
        }
    }
}

/// A row of pixels from the left: red, green, blue.
#[derive(Debug, Clone, PartialEq)]
pub enum Row {
    /// 8-bit sRGB, three numbers a pixel.
    Srgb(Vec<u8>),
    Linear(Vec<[f32; 3]>),
}

impl Row {
    /// The row in 8-bit sRGB, three numbers a pixel.
    fn into_srgb(self) -> Vec<u8> {
        match self {
            Row::Srgb(row) => row,
            Row::Linear(row) => row.iter().flatten().map(|&x| srgb8(x)).collect(),
        }
    }
}
