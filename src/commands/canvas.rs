//! A picture of 8-bit RGB with text on it.

use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_2};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::{DrawTarget, Drawable, OriginDimensions, Pixel, Point, Size};
use embedded_graphics::text::{Baseline, Text};

/// The font of titles. Both fonts have the letters of English and Czech.
pub(super) const LARGE: MonoFont = iso_8859_2::FONT_10X20;
/// The font of all other text.
pub(super) const SMALL: MonoFont = iso_8859_2::FONT_7X13;

pub(super) type Colour = [u8; 3];

/// The background colour behind the pictures.
pub(super) const PAPER: Colour = [32; 3];
pub(super) const WHITE: Colour = [255; 3];

/// A picture of 8-bit RGB, row by row from the top.
pub(super) struct Canvas {
    pub width: u32,
    pub height: u32,
    pub rgb: Vec<u8>,
}

impl Canvas {
    pub(super) fn new([width, height]: [u32; 2], paper: Colour) -> Canvas {
        Canvas {
            width,
            height,
            rgb: paper.repeat(width as usize * height as usize),
        }
    }

    /// Writes one line of text with its upper left corner at `[x, y]`. Letters that would reach beyond column `end` are
    /// left out.
    pub(super) fn write(
        &mut self,
        font: &MonoFont,
        [x, y]: [u32; 2],
        end: u32,
        ink: Colour,
        text: &str,
    ) {
        let fit = letters(font, end.saturating_sub(x));
        // A control character would begin another line.
        let shown = |c: char| if c.is_control() { '?' } else { c };
        let text: String = text.chars().take(fit).map(shown).collect();
        let style = MonoTextStyle::new(font, Rgb888::new(ink[0], ink[1], ink[2]));
        let place = Point::new(x as i32, y as i32);
        let Ok(_) = Text::with_baseline(&text, place, style, Baseline::Top).draw(self);
    }

    /// Fills a rectangle with a colour. `[left, top]` is its upper left corner; what lies outside of the canvas is left
    /// out.
    pub(super) fn fill(
        &mut self,
        [left, top]: [u32; 2],
        [width, height]: [u32; 2],
        colour: Colour,
    ) {
        for y in top..top + height {
            for x in left..left + width {
                self.dot(x, y, colour);
            }
        }
    }

    /// Copies a picture of this width onto the canvas, with its upper left corner at `[left, top]`. Rows below the
    /// canvas are left out; the right edge must lie within the canvas.
    pub(super) fn paste(&mut self, [left, top]: [u32; 2], width: u32, rgb: &[u8]) {
        for (y, row) in (top..self.height).zip(rgb.chunks_exact(3 * width.max(1) as usize)) {
            let at = 3 * (y as usize * self.width as usize + left as usize);
            self.rgb[at..at + row.len()].copy_from_slice(row);
        }
    }

    fn dot(&mut self, x: u32, y: u32, colour: Colour) {
        if x < self.width && y < self.height {
            let at = 3 * (y as usize * self.width as usize + x as usize);
            self.rgb[at..at + 3].copy_from_slice(&colour);
        }
    }
}

/// The number of letters that fit into a width in pixels.
pub(super) fn letters(font: &MonoFont, width: u32) -> usize {
    (width / font.character_size.width) as usize
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl DrawTarget for Canvas {
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
