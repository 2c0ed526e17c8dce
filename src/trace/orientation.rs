//! The orientation in which a camera was held, by the Exif data of a JPEG file.

use exif::{In, Reader, Tag};

/// How rows and columns of a file lie in the upright picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Orientation {
    /// Whether the picture's rows are the file's columns.
    is_turned: bool,
    /// Whether the file's columns go from right to left, and its rows from bottom to top.
    is_mirrored: [bool; 2],
}

impl Orientation {
    /// The orientation in Exif data; upright where the data has none that can be understood.
    pub(super) fn of(exif: Option<&[u8]>) -> Orientation {
        let read = |data: &[u8]| Reader::new().read_raw(data.to_vec()).ok();
        let exif = exif.and_then(read);
        let field = exif
            .as_ref()
            .and_then(|all| all.get_field(Tag::Orientation, In::PRIMARY));
        Orientation::numbered(field.and_then(|field| field.value.get_uint(0)))
    }

    /// The orientation with a number in Exif 2.32, table 4.6.4.A.6. The comments say on which sides of the picture the
    /// file's first row and first column are.
    fn numbered(number: Option<u32>) -> Orientation {
        let (is_turned, is_mirrored) = match number {
            Some(2) => (false, [true, false]), // top, right
            Some(3) => (false, [true, true]),  // bottom, right
            Some(4) => (false, [false, true]), // bottom, left
            Some(5) => (true, [false, false]), // left, top
            Some(6) => (true, [false, true]),  // right, top
            Some(7) => (true, [true, true]),   // right, bottom
            Some(8) => (true, [true, false]),  // left, bottom
            _ => (false, [false, false]),      // top, left
        };
        Orientation {
            is_turned,
            is_mirrored,
        }
    }

    /// The size and the pixels of the upright picture, from those of the file: three numbers a pixel, row by row from
    /// the top.
    pub(super) fn upright(self, [width, height]: [u32; 2], pixels: Vec<u8>) -> ([u32; 2], Vec<u8>) {
        let size = match self.is_turned {
            false => [width, height],
            true => [height, width],
        };
        if self == Orientation::numbered(None) {
            return (size, pixels);
        }
        let mut out = Vec::with_capacity(pixels.len());
        for y in 0..size[1] {
            for x in 0..size[0] {
                let [mut column, mut row] = if self.is_turned { [y, x] } else { [x, y] };
                if self.is_mirrored[0] {
                    column = width - 1 - column;
                }
                if self.is_mirrored[1] {
                    row = height - 1 - row;
                }
                let at = 3 * (row as usize * width as usize + column as usize);
                out.extend_from_slice(&pixels[at..at + 3]);
            }
        }
        (size, out)
    }
}
