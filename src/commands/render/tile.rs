//! Bands of rows, from which a picture is put together.

use std::ops::Range;
use std::str::FromStr;

use crate::diagnostics::Complaint;

/// The bands `first` to `last` of the `count` bands of a picture, counted from 1: `3/8`, `3-5/8`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    first: u32,
    last: u32,
    count: u32,
}

impl FromStr for Tile {
    type Err = Complaint;

    fn from_str(text: &str) -> Result<Tile, Complaint> {
        let wrong = || Complaint::new("expected-tile");
        let number = |text: &str| text.trim().parse::<u32>().map_err(|_| wrong());
        let (bands, count) = text.split_once('/').ok_or_else(wrong)?;
        let (first, last) = bands.split_once('-').unwrap_or((bands, bands));
        let (first, last, count) = (number(first)?, number(last)?, number(count)?);
        match 1 <= first && first <= last && last <= count {
            true => Ok(Tile { first, last, count }),
            false => Err(wrong()),
        }
    }
}

impl Tile {
    /// The rows of these bands in a picture of this height. Band I of N has the rows from ⌊(I−1)·height/N⌋ up to, and
    /// without, ⌊I·height/N⌋.
    ///
    /// # Errors
    ///
    /// There are more bands than rows.
    pub fn rows(self, height: u32) -> Result<Range<u32>, Complaint> {
        if self.count > height {
            return Err(Complaint::new("more-tiles-than-rows")
                .with("count", self.count.to_string())
                .with("height", height.to_string()));
        }
        let start = |band: u32| u64::from(band) * u64::from(height) / u64::from(self.count);
        // At most the height.
        Ok(start(self.first - 1) as u32..start(self.last) as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_cover_a_picture_once() {
        for height in [1, 7, 480, u32::MAX] {
            for count in [1, 2, 7, 16].into_iter().filter(|&n| n <= height) {
                let bands = (1..=count).map(|i| {
                    let tile: Tile = format!("{i}/{count}").parse().unwrap();
                    tile.rows(height).unwrap()
                });
                let mut end = 0;
                for band in bands {
                    assert!(band.start == end && band.end > end);
                    end = band.end;
                }
                assert_eq!(end, height);
            }
        }
        let several: Tile = "2-3/4".parse().unwrap();
        assert_eq!(several.rows(480), Ok(120..360));
    }

    #[test]
    fn what_is_no_band() {
        for text in [
            "", "1", "0/4", "5/4", "3-2/4", "1/0", "a/4", "1/4/2", "-1/4",
        ] {
            assert!(text.parse::<Tile>().is_err(), "{text}");
        }
        let many: Tile = "1/9".parse().unwrap();
        assert!(many.rows(8).is_err());
    }
}
