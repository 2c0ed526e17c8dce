//! Pictures beside each other, with what they are above them and what their colours mean below.

use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_2};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::{DrawTarget, Drawable, OriginDimensions, Pixel, Point, Size};
use embedded_graphics::text::{Baseline, Text};

/// A picture of 8-bit RGB, row by row.
pub struct Labelled {
    pub width: u32,
    pub height: u32,
    pub rgb: Vec<u8>,
}

/// A colour and what it means.
pub type Meaning = ([u8; 3], String);

/// Of titles.
const LARGE: MonoFont = iso_8859_2::FONT_10X20;
/// Of meanings.
const SMALL: MonoFont = iso_8859_2::FONT_7X13;
/// Room around a line of text, in pixels.
const MARGIN: u32 = 4;
const PAPER: [u8; 3] = [32; 3];

/// Pictures of one size beside each other, each under its title, and under the last one what its colours mean.
pub fn beside<const N: usize>(
    [width, height]: [u32; 2],
    pictures: [(&str, &[u8]); N],
    legend: &[Meaning],
) -> Labelled {
    let columns = N as u32;
    let head = LARGE.character_size.height + 2 * MARGIN;
    let places = legend_places(width, legend);
    let line = SMALL.character_size.height + MARGIN;
    let lines = places.last().map_or(0, |[_, row]| row + 1);
    let mut sheet = Sheet(Labelled {
        width: columns * width,
        height: head + height + lines * line + MARGIN,
        rgb: Vec::new(),
    });
    let Labelled {
        width: wide,
        height: high,
        ..
    } = sheet.0;
    sheet.0.rgb = PAPER.repeat(wide as usize * high as usize);
    for (column, (title, picture)) in (0..).zip(pictures) {
        let left = column * width;
        sheet.write(&LARGE, [left + MARGIN, MARGIN], left + width, title);
        for (y, row) in (head..).zip(picture.chunks_exact(3 * width as usize)) {
            let at = 3 * (y as usize * wide as usize + left as usize);
            sheet.0.rgb[at..at + row.len()].copy_from_slice(row);
        }
    }
    let left = (columns - 1) * width;
    for ((colour, meaning), [x, row]) in legend.iter().zip(places) {
        let (x, y) = (left + x, head + height + MARGIN + row * line);
        let side = SMALL.character_size.height - MARGIN;
        sheet.fill([x, y + MARGIN / 2], side, *colour);
        sheet.write(&SMALL, [x + side + MARGIN, y], wide, meaning);
    }
    sheet.0
}

/// Where the entries of a legend stand: how far from the left, and in which line.
fn legend_places(width: u32, legend: &[Meaning]) -> Vec<[u32; 2]> {
    let (mut x, mut row) = (MARGIN, 0);
    let place = |(_, meaning): &Meaning| {
        let letters = meaning.chars().count() as u32 + 3;
        let wide = letters * SMALL.character_size.width;
        if x > MARGIN && x + wide > width {
            (x, row) = (MARGIN, row + 1);
        }
        let at = [x, row];
        x += wide;
        at
    };
    legend.iter().map(place).collect()
}

/// What is drawn on.
struct Sheet(Labelled);

impl Sheet {
    /// A text of one line from its upper left corner, as far as it fits.
    fn write(&mut self, font: &MonoFont, [x, y]: [u32; 2], end: u32, text: &str) {
        let fit = end.saturating_sub(x) / font.character_size.width;
        let text: String = text.chars().take(fit as usize).collect();
        let style = MonoTextStyle::new(font, Rgb888::WHITE);
        let place = Point::new(x as i32, y as i32);
        let Ok(_) = Text::with_baseline(&text, place, style, Baseline::Top).draw(self);
    }

    fn fill(&mut self, [left, top]: [u32; 2], side: u32, colour: [u8; 3]) {
        for y in top..top + side {
            for x in left..left + side {
                self.dot(x, y, colour);
            }
        }
    }

    fn dot(&mut self, x: u32, y: u32, colour: [u8; 3]) {
        if x < self.0.width && y < self.0.height {
            let at = 3 * (y as usize * self.0.width as usize + x as usize);
            self.0.rgb[at..at + 3].copy_from_slice(&colour);
        }
    }
}

impl OriginDimensions for Sheet {
    fn size(&self) -> Size {
        Size::new(self.0.width, self.0.height)
    }
}

impl DrawTarget for Sheet {
    type Color = Rgb888;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(
        &mut self,
        dots: I,
    ) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, colour) in dots {
            if let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y)) {
                self.dot(x, y, [colour.r(), colour.g(), colour.b()]);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(sheet: &Labelled, y: u32, from: u32, to: u32) -> &[u8] {
        let at = |x: u32| 3 * (y as usize * sheet.width as usize + x as usize);
        &sheet.rgb[at(from)..at(to)]
    }

    fn ink(sheet: &Labelled, rows: std::ops::Range<u32>, from: u32, to: u32) -> usize {
        let dots = rows.flat_map(|y| row(sheet, y, from, to).chunks_exact(3));
        dots.filter(|dot| **dot == [255; 3]).count()
    }

    #[test]
    fn titles_stand_above_and_meanings_below() {
        let (one, two) = (vec![1; 3 * 40 * 5], vec![2; 3 * 40 * 5]);
        let legend = [
            ([0, 200, 0], "shoda".to_owned()),
            ([255, 0, 0], "rozdíl".to_owned()),
        ];
        let sheet = beside([40, 5], [("zpg", &one), ("ř", &two)], &legend);
        // A title of 28 rows, 5 of pictures, and a line of 17 for each of the meanings, which are too long for one.
        assert_eq!((sheet.width, sheet.height), (80, 28 + 5 + 2 * 17 + 4));
        assert_eq!(sheet.rgb.len(), 3 * 80 * 71);
        for y in 28..33 {
            assert_eq!(row(&sheet, y, 0, 40), &[1; 120]);
            assert_eq!(row(&sheet, y, 40, 80), &[2; 120]);
        }
        assert!(ink(&sheet, 0..28, 0, 40) > 30 && ink(&sheet, 0..28, 40, 80) > 10);
        // Under the last picture only: the colour, then the word.
        assert_eq!(ink(&sheet, 33..71, 0, 40), 0);
        assert!(ink(&sheet, 33..71, 40, 80) > 20);
        assert_eq!(row(&sheet, 41, 44, 46), [0, 200, 0, 0, 200, 0]);
        assert_eq!(row(&sheet, 41 + 17, 44, 46), [255, 0, 0, 255, 0, 0]);
    }

    #[test]
    fn words_end_with_their_picture() {
        let picture = vec![0; 3 * 12];
        let sheet = beside([12, 1], [("a long title", &picture), ("", &picture)], &[]);
        assert!(ink(&sheet, 0..28, 0, 12) <= ink(&sheet, 0..28, 0, 24));
        assert_eq!(ink(&sheet, 0..28, 12, 24), 0);
    }
}
