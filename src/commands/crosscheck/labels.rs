//! Pictures side by side, each with a title above it, and a legend of colours below the last one.

use crate::commands::canvas::{Canvas, LARGE, PAPER, SMALL, WHITE};

/// A colour and what it means.
pub(super) type Meaning = ([u8; 3], String);

/// Room around a line of text, in pixels.
const MARGIN: u32 = 4;

/// Puts pictures of one size side by side, each under its title, and the legend of colours under the last one.
pub(super) fn beside<const N: usize>(
    [width, height]: [u32; 2],
    pictures: [(&str, &[u8]); N],
    legend: &[Meaning],
) -> Canvas {
    let columns = N as u32;
    let head = LARGE.character_size.height + 2 * MARGIN;
    let places = legend_places(width, legend);
    let line = SMALL.character_size.height + MARGIN;
    let lines = places.last().map_or(0, |[_, row]| row + 1);
    let mut sheet = Canvas::new(
        [columns * width, head + height + lines * line + MARGIN],
        PAPER,
    );
    for (column, (title, picture)) in (0..).zip(pictures) {
        let left = column * width;
        sheet.write(&LARGE, [left + MARGIN, MARGIN], left + width, WHITE, title);
        sheet.paste([left, head], width, picture);
    }
    let left = (columns - 1) * width;
    for ((colour, meaning), [x, row]) in legend.iter().zip(places) {
        let (x, y) = (left + x, head + height + MARGIN + row * line);
        let side = SMALL.character_size.height - MARGIN;
        sheet.fill([x, y + MARGIN / 2], [side; 2], *colour);
        let end = sheet.width;
        sheet.write(&SMALL, [x + side + MARGIN, y], end, WHITE, meaning);
    }
    sheet
}

/// The place of each entry of a legend: pixels from the left, and the line from 0.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn row(sheet: &Canvas, y: u32, from: u32, to: u32) -> &[u8] {
        let at = |x: u32| 3 * (y as usize * sheet.width as usize + x as usize);
        &sheet.rgb[at(from)..at(to)]
    }

    fn ink(sheet: &Canvas, rows: std::ops::Range<u32>, from: u32, to: u32) -> usize {
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
