//! Pictures made smaller: each pixel is the average of what it covers, in linear light.

use crate::commands::canvas::Colour;
use crate::scene::Rgb;
use crate::trace::film::srgb8;

/// A picture of 8-bit RGB, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Thumbnail {
    /// The width and height in pixels of the picture that was shrunk.
    pub original: [u32; 2],
    pub size: [u32; 2],
    pub rgb: Vec<u8>,
}

/// The sums of a picture's pixels, from which the smaller picture is made. Pixels may be added in any order.
pub(super) struct Average {
    from: [u32; 2],
    to: [u32; 2],
    columns: Vec<Parts>,
    rows: Vec<Parts>,
    sums: Vec<Rgb>,
}

/// The columns or rows of the smaller picture that one column or row of the larger one covers. There are at most two of
/// them, as no picture is made larger.
#[derive(Clone, Copy)]
struct Parts {
    first: usize,
    /// The covered part of `first`, and that of the column or row behind it: from 0 to 1.
    shares: [f64; 2],
}

impl Parts {
    fn all(from: u32, to: u32) -> Vec<Parts> {
        let [wide, narrow] = [from, to].map(u64::from);
        let parts = |i: u64| {
            // The unit of length is such that a pixel of the larger picture has `narrow` units, and one of the smaller
            // picture `wide`.
            let [start, end] = [i * narrow, (i + 1) * narrow];
            let first = start / wide;
            let within = end.min((first + 1) * wide) - start;
            Parts {
                first: first as usize,
                shares: [within, narrow - within].map(|part| part as f64 / wide as f64),
            }
        };
        (0..wide).map(parts).collect()
    }
}

/// The size of a picture that is shrunk to fit into `most` and keeps its proportions. A picture that fits keeps its
/// size.
fn fitted([width, height]: [u32; 2], most: [u32; 2]) -> [u32; 2] {
    let [w, h, most_w, most_h] = [width, height, most[0], most[1]].map(u64::from);
    let rounded = |a: u64, b: u64, c: u64| ((2 * a * b + c) / (2 * c).max(1)).max(1) as u32;
    if w <= most_w && h <= most_h {
        [width, height]
    } else if w * most_h >= h * most_w {
        [most[0], rounded(h, most_w, w)]
    } else {
        [rounded(w, most_h, h), most[1]]
    }
}

impl Average {
    /// Begins the average of a picture of size `from`, to fit into `most`. The picture is not made larger.
    pub(super) fn new(from: [u32; 2], most: [u32; 2]) -> Average {
        let to = fitted(from, most);
        Average {
            from,
            to,
            columns: Parts::all(from[0], to[0]),
            rows: Parts::all(from[1], to[1]),
            sums: vec![[0.0; 3]; to[0] as usize * to[1] as usize],
        }
    }

    /// Adds a pixel of the larger picture, in linear light. A colour brighter than white counts as white, as it looks
    /// on a screen: otherwise one bright spot would make all pixels around it white.
    pub(super) fn add(&mut self, x: usize, y: usize, colour: Rgb) {
        let (column, row) = (self.columns[x], self.rows[y]);
        // NaN counts as black.
        let colour = colour.map(|c| if c > 0.0 { c.min(1.0) } else { 0.0 });
        let width = self.to[0] as usize;
        for (down, share) in row.shares.into_iter().enumerate() {
            for (right, part) in column.shares.into_iter().enumerate() {
                let weight = share * part;
                if weight > 0.0 {
                    let sum = &mut self.sums[(row.first + down) * width + column.first + right];
                    for (sum, c) in sum.iter_mut().zip(colour) {
                        *sum += weight * c;
                    }
                }
            }
        }
    }

    pub(super) fn finish(self) -> Thumbnail {
        let encoded = |sum: &Rgb| -> Colour { sum.map(|c| srgb8(c as f32)) };
        Thumbnail {
            original: self.from,
            size: self.to,
            rgb: self.sums.iter().flat_map(encoded).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_fit_and_keep_their_shape() {
        for (from, most, to) in [
            ([640, 480], [240, 180], [240, 180]),
            ([1920, 1080], [240, 180], [240, 135]),
            ([480, 640], [240, 180], [135, 180]),
            ([100, 50], [240, 180], [100, 50]),
            ([100_000, 1], [240, 180], [240, 1]),
            ([1, 100_000], [240, 180], [1, 180]),
        ] {
            assert_eq!(fitted(from, most), to, "{from:?}");
        }
    }

    /// Each pixel of the larger picture is counted once in all, and each of the smaller one is full.
    #[test]
    fn shares_are_those_of_an_area() {
        for (from, to) in [(7, 3), (640, 240), (5, 5), (1000, 1)] {
            let parts = Parts::all(from, to);
            let mut full = vec![0.0; to as usize + 1];
            for part in &parts {
                full[part.first] += part.shares[0];
                full[part.first + 1] += part.shares[1];
            }
            assert_eq!(full.pop(), Some(0.0));
            assert!(full.iter().all(|sum| (sum - 1.0).abs() < 1e-12), "{full:?}");
        }
    }

    /// White and black beside each other are half of the light, which is 188 in sRGB, and not 128. Of three columns in
    /// two, the middle one is shared.
    #[test]
    fn light_is_averaged_and_not_its_code() {
        let shrunk = |most, colours: &[f64]| {
            let mut all = Average::new([colours.len() as u32, 1], most);
            for (x, c) in colours.iter().enumerate() {
                all.add(x, 0, [*c; 3]);
            }
            all.finish().rgb
        };
        assert_eq!(shrunk([1, 1], &[1.0, 0.0]), [188; 3]);
        // 2/3 of the first and 1/3 of the second.
        let third = srgb8((1.0 / 3.0) as f32);
        assert_eq!(shrunk([2, 1], &[0.0, 1.0, 0.0]), [third; 6]);
        // Brighter than white is white, and what is no number is black.
        assert_eq!(shrunk([1, 1], &[1e30, f64::NAN]), [188; 3]);
        assert_eq!(shrunk([1, 1], &[f64::INFINITY, -1.0]), [188; 3]);
    }
}
