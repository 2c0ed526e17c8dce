//! Pictures within a page.

use super::super::measure::{distance, steps};
use super::super::report::Raster;
use crate::study::page::address;
use crate::trace::film::srgb8;

pub(super) fn picture(raster: &Raster) -> String {
    let bytes: Vec<u8> = raster
        .pixels
        .iter()
        .flatten()
        .map(|&x| srgb8(x as f32))
        .collect();
    address(raster.width, raster.height, &bytes)
}

/// Draws the difference of two pictures, times a factor that makes it visible; wrong pixels are framed if there are
/// few. Returns the address of the picture, the factor, the largest difference in steps, and the number of pixels that
/// are off by more than a step.
pub(super) fn difference(a: &Raster, b: &Raster) -> (String, f64, f64, usize) {
    let off: Vec<f64> = a
        .pixels
        .iter()
        .zip(&b.pixels)
        .map(|(a, b)| distance(*a, *b))
        .collect();
    let largest = off.iter().copied().fold(0.0, f64::max);
    let wrong = off.iter().filter(|d| **d > 1.0).count();
    let factor = match largest {
        l if l <= 0.0 => 1.0,
        l if l > 64.0 => 1.0,
        l if l > 16.0 => 4.0,
        l if l > 4.0 => 16.0,
        l => 10f64.powf((255.0 / l).log10().floor()),
    };
    let mut bytes: Vec<u8> = (a.pixels.iter().zip(&b.pixels))
        .flat_map(|(a, b)| {
            [0, 1, 2].map(|c| ((steps(a[c]) - steps(b[c])).abs() * factor).min(255.0) as u8)
        })
        .collect();
    let (w, h) = (a.width as i64, a.height as i64);
    if wrong > 0 && wrong <= 40 {
        for (i, _) in off.iter().enumerate().filter(|(_, d)| **d > 1.0) {
            let (x, y) = (i as i64 % w, i as i64 / w);
            for k in -2..=2i64 {
                for (dx, dy) in [(k, -2), (k, 2), (-2, k), (2, k)] {
                    let (x, y) = (x + dx, y + dy);
                    if (0..w).contains(&x) && (0..h).contains(&y) {
                        let at = 3 * (y * w + x) as usize;
                        bytes[at..at + 3].copy_from_slice(&[213, 94, 0]);
                    }
                }
            }
        }
    }
    (address(a.width, a.height, &bytes), factor, largest, wrong)
}

/// Draws values in the colours of cividis, from 0 to the value that 99 % of them do not exceed; grey where there is no
/// value. Returns the address of the picture and that value.
pub(super) fn map(width: u32, height: u32, values: &[f64]) -> (String, f64) {
    // A single expensive pixel must not make all others dark.
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let most = sorted
        .get(sorted.len() * 99 / 100)
        .copied()
        .unwrap_or(1.0)
        .max(1e-12);
    let colour = |v: &f64| match v.is_finite() {
        true => {
            let c = colorous::CIVIDIS.eval_continuous((v / most).clamp(0.0, 1.0).sqrt());
            [c.r, c.g, c.b]
        }
        false => [128; 3],
    };
    let bytes: Vec<u8> = values.iter().flat_map(colour).collect();
    (address(width, height, &bytes), most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_wrong_pixels_are_counted_and_scaled() {
        let raster = |x: f64| Raster {
            width: 8,
            height: 8,
            pixels: (0..64)
                .map(|i| [if i == 27 { x } else { 0.5 }; 3])
                .collect(),
        };
        let (_, factor, largest, wrong) = difference(&raster(1.0), &raster(0.5));
        assert_eq!((factor, wrong), (1.0, 1));
        assert!((largest - 255.0 * (1.0 - 0.735_356_983)).abs() < 1e-3);
        let (_, factor, largest, wrong) = difference(&raster(0.5 + 1e-6), &raster(0.5));
        assert!(wrong == 0 && largest < 1.0 && factor * largest <= 255.0 && factor > 1e5);
    }
}
