//! The sheet as a PNG picture. One row of its boxes is in memory at a time.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;

use super::cell::{Cell, found};
use crate::commands::canvas::{Canvas, Colour, LARGE, PAPER, SMALL, WHITE, letters};
use crate::commands::size::Size;
use crate::diagnostics::layout::wrapped;
use crate::diagnostics::{Complaint, Language};

/// The text by which a sheet names itself, so that it is no picture of the next one.
const MARK: (&str, &str) = ("Software", "zpg sheet");

/// Pixels between boxes.
const GAP: u32 = 12;
/// Pixels around text within a box.
const MARGIN: u32 = 4;
/// Pixels from one line of text to the next one.
const LINE: u32 = 16;
const HEAD_LINE: u32 = 24;
/// The lines of text in a box: a name, a size, and what was found.
const LINES: u32 = 3;

/// The background colour of a box, behind its picture.
const CARD: Colour = [48; 3];
const GREY: Colour = [170; 3];
const RED: Colour = [255, 128, 128];
const YELLOW: Colour = [240, 208, 96];

/// The layout of a sheet of boxes.
pub(super) struct Layout {
    pub columns: u32,
    rows: u32,
    size: Size,
    width: u32,
    head: Vec<String>,
}

impl Layout {
    /// The layout of `count` boxes with thumbnails of `size`. Unless a number of columns is given, the sheet is about a
    /// third wider than high. `Err` if the sheet is too large for a PNG.
    pub(super) fn new(
        count: usize,
        columns: Option<u32>,
        size: Size,
        head: &str,
    ) -> Result<Layout, Complaint> {
        let most = u32::try_from(count).unwrap_or(u32::MAX).max(1);
        let [wide, high] = [size.width + GAP, box_height(size)].map(f64::from);
        let usual = (count as f64 * high / wide * 4.0 / 3.0).sqrt().ceil() as u32;
        let columns = columns.unwrap_or(usual).clamp(1, most);
        let width = u64::from(columns) * u64::from(size.width + GAP) + u64::from(GAP);
        // A PNG has 31 bits for its width and for its height.
        let fits = |side: u64| {
            u32::try_from(side)
                .ok()
                .filter(|side| *side <= i32::MAX as u32)
        };
        let width = fits(width).ok_or_else(|| Complaint::new("sheet-too-large"))?;
        let head = wrapped(head, letters(&LARGE, width - 2 * GAP).max(8), "");
        let layout = Layout {
            columns,
            rows: most.div_ceil(columns),
            size,
            width,
            head: head.lines().map(str::to_owned).collect(),
        };
        let height = u64::from(layout.rows) * u64::from(box_height(size));
        match fits(height + u64::from(layout.head_height())) {
            Some(_) => Ok(layout),
            None => Err(Complaint::new("sheet-too-large")),
        }
    }

    fn head_height(&self) -> u32 {
        2 * GAP + self.head.len() as u32 * HEAD_LINE
    }

    fn height(&self) -> u32 {
        self.head_height() + self.rows * box_height(self.size)
    }
}

/// The height of a box in pixels, with the gap below it.
fn box_height(size: Size) -> u32 {
    size.height + MARGIN + LINES * LINE + GAP
}

/// Writes the sheet, whose boxes are read one by one.
pub(super) fn write<'e>(
    out: &mut dyn Write,
    layout: &Layout,
    language: Language,
    mut cells: impl Iterator<Item = io::Result<Cell<'e>>>,
) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, layout.width, layout.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.add_text_chunk(MARK.0.to_owned(), MARK.1.to_owned())?;
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Up);
    let mut file = encoder.write_header()?;
    let mut out = file.stream_writer()?;
    let mut head = Canvas::new([layout.width, layout.head_height()], PAPER);
    for (y, line) in (0..).zip(&layout.head) {
        let at = [GAP, GAP + y * HEAD_LINE];
        head.write(&LARGE, at, layout.width, WHITE, line);
    }
    out.write_all(&head.rgb)?;
    for _ in 0..layout.rows {
        let mut row = Canvas::new([layout.width, box_height(layout.size)], PAPER);
        for (column, cell) in (0..layout.columns).zip(&mut cells) {
            let left = GAP + column * (layout.size.width + GAP);
            draw(&mut row, left, layout.size, &cell?, language);
        }
        out.write_all(&row.rgb)?;
    }
    out.finish()?;
    Ok(file.finish()?)
}

fn draw(row: &mut Canvas, left: u32, size: Size, cell: &Cell, language: Language) {
    let Size { width, height } = size;
    let end = left + width;
    row.fill([left, 0], [width, height], CARD);
    if let Ok(picture) = &cell.picture {
        let [w, h] = picture.size;
        row.paste([left + (width - w) / 2, (height - h) / 2], w, &picture.rgb);
    }
    if let Some(reason) = cell.reason(language) {
        let is_wrong = cell.entry.picture.is_some() || cell.counts().is_some_and(|c| c.errors > 0);
        let ink = if is_wrong { RED } else { GREY };
        let lines = wrapped(&reason, letters(&SMALL, width - 2 * MARGIN).max(1), "");
        let fit = (height - MARGIN) / LINE;
        for (y, line) in (0..fit).zip(lines.lines()) {
            let at = [left + MARGIN, MARGIN + y * LINE];
            row.write(&SMALL, at, end, ink, line);
        }
    }
    let mut line = |y: u32, ink: Colour, text: &str| {
        let at = [left, height + MARGIN + y * LINE];
        row.write(&SMALL, at, end, ink, text);
    };
    line(
        0,
        WHITE,
        &shortened(&cell.entry.name, letters(&SMALL, width)),
    );
    line(1, GREY, &cell.size().unwrap_or_default());
    if let Some(counts) = cell.counts() {
        let ink = match (counts.errors, counts.warnings) {
            (0, 0) => GREY,
            (0, _) => YELLOW,
            _ => RED,
        };
        // If the warnings have no room beside the errors, they are left out.
        let mut parts = found(counts, language);
        while parts.len() > 1 && parts.join(", ").chars().count() > letters(&SMALL, width) {
            parts.pop();
        }
        line(2, ink, &parts.join(", "));
    }
}

/// A name in at most `fit` letters: of a longer one the middle is replaced by dots.
fn shortened(name: &str, fit: usize) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= fit {
        return name.to_owned();
    }
    let left = fit.saturating_sub(3);
    let (start, end) = (left / 2, letters.len() - left.div_ceil(2));
    let parts = [&letters[..start], &['.'; 3], &letters[end..]];
    parts.concat().into_iter().collect()
}

/// Whether a file is a sheet from an earlier run.
pub(super) fn is_sheet(path: &Path) -> bool {
    let Ok(file) = File::open(path) else {
        return false;
    };
    let Ok(reader) = png::Decoder::new(BufReader::new(file)).read_info() else {
        return false;
    };
    let mut texts = reader.info().uncompressed_latin1_text.iter();
    texts.any(|text| (text.keyword.as_str(), text.text.as_str()) == MARK)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_ends() {
        assert_eq!(shortened("novak.png", 9), "novak.png");
        assert_eq!(shortened("2026/novak-pavel.png", 12), "2026...l.png");
        assert_eq!(shortened("žluťoučký.png", 8), "žl...png");
    }

    #[test]
    fn sheets_are_a_little_wider_than_high() {
        let size = Size {
            width: 240,
            height: 180,
        };
        for count in [1, 2, 12, 300, 10_000] {
            let layout = Layout::new(count, None, size, "a").unwrap();
            assert!(layout.columns * layout.rows >= count as u32);
            assert!(layout.columns * (layout.rows - 1) < count as u32);
            let shape = f64::from(layout.width) / f64::from(layout.height());
            assert!(
                count < 12 || (1.0..1.7).contains(&shape),
                "{count}: {shape}"
            );
        }
        assert_eq!(Layout::new(3, Some(99), size, "a").unwrap().columns, 3);
        let long = Layout::new(usize::MAX, Some(1), size, "a");
        assert!(long.is_err());
    }
}
