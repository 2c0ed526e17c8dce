//! PNG files of every form, byte by byte: libraries write few of them.

/// The picture of the tests is so wide and so high: no multiple of the eight pixels of Adam7.
pub const SIZE: [usize; 2] = [13, 11];

/// How samples are stored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Colour {
    Grey = 0,
    Rgb = 2,
    Palette = 3,
    GreyAlpha = 4,
    Rgba = 6,
}

/// A PNG to be written.
pub struct Png<'a> {
    pub depth: u8,
    pub colour: Colour,
    pub interlaced: bool,
    /// Chunks before the pixels: name and content.
    pub chunks: &'a [(&'a str, Vec<u8>)],
}

impl Png<'_> {
    /// The file; `sample` gives the samples of a pixel, as many as the colour has.
    pub fn file(&self, sample: impl Fn(usize, usize) -> Vec<u16>) -> Vec<u8> {
        let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
        let size = SIZE.map(|n| (n as u32).to_be_bytes());
        let rest = [self.depth, self.colour as u8, 0, 0, self.interlaced.into()];
        chunk(&mut out, "IHDR", &[&size.concat()[..], &rest].concat());
        for (name, content) in self.chunks {
            chunk(&mut out, name, content);
        }
        // Where each pass of Adam7 starts, and its steps.
        let passes: &[[usize; 4]] = match self.interlaced {
            false => &[[0, 0, 1, 1]],
            true => &[
                [0, 0, 8, 8],
                [4, 0, 8, 8],
                [0, 4, 4, 8],
                [2, 0, 4, 4],
                [0, 2, 2, 4],
                [1, 0, 2, 2],
                [0, 1, 1, 2],
            ],
        };
        let mut rows = Vec::new();
        for &[x, y, right, down] in passes {
            for y in (y..SIZE[1]).step_by(down) {
                let row = (x..SIZE[0]).step_by(right).flat_map(|x| sample(x, y));
                let row: Vec<u16> = row.collect();
                if !row.is_empty() {
                    rows.push(0);
                    rows.extend(self.packed(&row));
                }
            }
        }
        chunk(&mut out, "IDAT", &zlib(&rows));
        chunk(&mut out, "IEND", &[]);
        out
    }

    fn packed(&self, samples: &[u16]) -> Vec<u8> {
        match self.depth {
            16 => samples.iter().flat_map(|s| s.to_be_bytes()).collect(),
            depth => {
                let byte = |some: &[u16]| {
                    let shifted = some.iter().enumerate();
                    let shifted =
                        shifted.map(|(i, s)| (*s as u8) << (8 - depth as usize * (i + 1)));
                    shifted.fold(0, |all, s| all | s)
                };
                samples.chunks(8 / depth as usize).map(byte).collect()
            }
        }
    }
}

fn chunk(out: &mut Vec<u8>, name: &str, content: &[u8]) {
    out.extend((content.len() as u32).to_be_bytes());
    let body = [name.as_bytes(), content].concat();
    let mut crc = u32::MAX;
    for byte in &body {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 };
        }
    }
    out.extend(body);
    out.extend((!crc).to_be_bytes());
}

/// A stream that stores a few bytes as they are.
pub fn zlib(bytes: &[u8]) -> Vec<u8> {
    let length = u16::try_from(bytes.len()).expect("a small picture");
    let (mut a, mut b) = (1u32, 0u32);
    for byte in bytes {
        a = (a + u32::from(*byte)) % 65521;
        b = (b + a) % 65521;
    }
    let mut out = vec![0x78, 0x01, 1];
    out.extend(length.to_le_bytes());
    out.extend((!length).to_le_bytes());
    out.extend(bytes);
    out.extend((b << 16 | a).to_be_bytes());
    out
}
