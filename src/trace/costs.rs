//! The cost of each pixel, as a picture in false colours.

use super::film::{Packing, write_rgb8};
use std::io::{self, Write};

/// Intersection tests, with boxes and shapes, per pixel, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CostMap {
    pub width: u32,
    pub height: u32,
    pub tests: Vec<u32>,
}

impl CostMap {
    /// The largest number of tests of a pixel.
    pub fn max(&self) -> u32 {
        self.tests.iter().copied().max().unwrap_or(0)
    }

    /// This map with another of the same size on its right.
    pub fn beside(&self, right: &CostMap) -> CostMap {
        let width = self.width.max(1) as usize;
        let rows = self.tests.chunks(width).zip(right.tests.chunks(width));
        CostMap {
            width: self.width + right.width,
            height: self.height,
            tests: rows.flat_map(|(l, r)| [l, r].concat()).collect(),
        }
    }

    /// The sum of two maps of one size.
    pub fn plus(&self, other: &CostMap) -> CostMap {
        let both = self.tests.iter().zip(&other.tests);
        CostMap {
            tests: both.map(|(a, b)| a.saturating_add(*b)).collect(),
            ..*self
        }
    }

    /// An 8-bit PNG in the colours of “inferno”, whose steps look even: from black, for no test at
    /// all, to light yellow, for `max` tests. The place on the scale is log(1 + tests) / log(1 + max).
    pub fn write_png(&self, out: impl Write, max: u32) -> io::Result<()> {
        let scale = libm::log1p(f64::from(max.max(1)));
        let bytes: Vec<u8> = self
            .tests
            .iter()
            .flat_map(|&n| {
                let place = (libm::log1p(f64::from(n)) / scale).min(1.0);
                colorous::INFERNO.eval_continuous(place).into_array()
            })
            .collect();
        write_rgb8(out, [self.width, self.height], &bytes, Packing::Quick)
    }
}
