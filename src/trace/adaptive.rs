//! Adaptive sampling: as many samples as a pixel needs.
//!
//! Every pixel takes [`BATCH_SAMPLES`] samples. It takes no more if these and those of the eight neighbours agree
//! within the tolerance. The neighbours' samples find thin things that a pixel's own samples have missed (Mitchell,
//! "Generating Antialiased Images at Low Sampling Densities", SIGGRAPH 1987). Other pixels take more samples until the
//! larger of two estimates of the error is below the tolerance:
//!
//! - the standard error of the mean by batch means (Asmussen and Glynn, *Stochastic Simulation*,
//!   2007, section IV.5): each [`BATCH_SAMPLES`] samples in a row, which are well spread over the pixel, are
//!   a batch;
//! - the contrast among the neighbours over the number of samples: n well-spread samples can miss a thing that covers
//!   1/n of the pixel. The thing is assumed to differ from the pixel by as much as the neighbours do.
//!
//! Errors are in linear RGB, of the channel where they are largest.

use super::stats::Cost;
use crate::geometry::vec::Vec3;

/// The number of samples in a batch. Every pixel takes at least one batch.
pub const BATCH_SAMPLES: u32 = 4;
/// The fewest samples of a pixel that does not stop after its first batches for low contrast: four batches. The scatter
/// of fewer says little.
pub const MIN_SAMPLES: u32 = 4 * BATCH_SAMPLES;
/// The most samples of a pixel.
pub const MAX_SAMPLES: u32 = 1024;

/// The first samples of a pixel.
#[derive(Debug, Clone, Copy, Default)]
pub struct First {
    pub samples: [[f32; 3]; BATCH_SAMPLES as usize],
    pub cost: Cost,
}

/// The largest difference in one channel between samples of these pixels.
pub fn contrast<'a>(pixels: impl Iterator<Item = &'a First>) -> f64 {
    let (mut low, mut high) = ([f32::INFINITY; 3], [0.0f32; 3]);
    for sample in pixels.flat_map(|p| &p.samples) {
        for c in 0..3 {
            low[c] = low[c].min(sample[c]);
            high[c] = high[c].max(sample[c]);
        }
    }
    (0..3).fold(0.0, |most, c| {
        f64::max(most, f64::from(high[c]) - f64::from(low[c]))
    })
}

/// The mean of a pixel's batches and its scatter, by Welford's recurrence.
#[derive(Debug, Clone, Copy)]
pub struct Estimate {
    batches: f64,
    pub mean: Vec3,
    /// Sum of squared distances from the mean.
    scatter: Vec3,
}

impl Estimate {
    pub fn new() -> Estimate {
        Estimate {
            batches: 0.0,
            mean: Vec3::ZERO,
            scatter: Vec3::ZERO,
        }
    }

    /// Adds the mean of a batch.
    pub fn add(&mut self, batch: Vec3) {
        self.batches += 1.0;
        let before = batch - self.mean;
        self.mean = self.mean + before / self.batches;
        self.scatter = self.scatter + before.times(batch - self.mean);
    }

    pub fn samples(&self) -> u32 {
        self.batches as u32 * BATCH_SAMPLES
    }

    /// The estimated error of the mean, given the contrast among the neighbours.
    fn error(&self, contrast: f64) -> f64 {
        let variance = self.scatter.max_component() / (self.batches - 1.0).max(1.0);
        let scattered = (variance / self.batches).sqrt();
        scattered.max(contrast / f64::from(self.samples()))
    }

    /// Whether a pixel needs no more samples.
    pub fn is_enough(&self, contrast: f64, tolerance: f64) -> bool {
        let n = self.samples();
        match n {
            0 => false,
            _ if n < MIN_SAMPLES => contrast <= tolerance,
            _ => n >= MAX_SAMPLES || self.error(contrast) <= tolerance,
        }
    }

    /// How many more batches a pixel needs at the least; 0 if it needs none.
    pub fn missing_batches(&self, contrast: f64, tolerance: f64) -> u32 {
        if self.is_enough(contrast, tolerance) {
            return 0;
        }
        // With fewer samples, the contrast over their number is above the tolerance.
        let least = (contrast / tolerance) as u32;
        let least = least.clamp(MIN_SAMPLES, MAX_SAMPLES);
        (least.saturating_sub(self.samples()) / BATCH_SAMPLES).max(1)
    }
}

impl Default for Estimate {
    fn default() -> Estimate {
        Estimate::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_pixel_has_enough_at_once() {
        let mut estimate = Estimate::new();
        assert!(!estimate.is_enough(0.0, 0.01));
        estimate.add(Vec3::ONE);
        assert!(estimate.is_enough(0.01, 0.01));
        assert!(!estimate.is_enough(0.011, 0.01));
    }

    #[test]
    fn contrast_among_neighbours_asks_for_samples_in_proportion() {
        let mut estimate = Estimate::new();
        estimate.add(Vec3::ONE);
        assert_eq!(estimate.missing_batches(0.01, 0.01), 0);
        assert_eq!(estimate.missing_batches(0.02, 0.01), 3);
        assert_eq!(estimate.missing_batches(1.0, 0.01), 24);
        assert_eq!(estimate.missing_batches(1.0, 1e-9), 255);
        while !estimate.is_enough(1.0, 0.01) {
            estimate.add(Vec3::ONE);
        }
        assert_eq!(estimate.samples(), 100);
        assert_eq!(estimate.missing_batches(1.0, 0.01), 0);
        assert_eq!(estimate.missing_batches(1.001, 0.01), 1);
        // The scatter asks for more than the contrast.
        estimate.add(Vec3::ONE * 9.0);
        assert_eq!(estimate.missing_batches(1.0, 0.01), 1);
        while !estimate.is_enough(1.0, 1e-9) {
            estimate.add(Vec3::ONE);
        }
        assert_eq!(estimate.samples(), MAX_SAMPLES);
    }

    #[test]
    fn the_standard_error_is_that_of_the_batches() {
        let mut estimate = Estimate::new();
        for x in [0.0, 1.0, 0.0, 1.0] {
            estimate.add(Vec3::ONE * x);
        }
        // Variance 1/3 of four batches.
        let expected = (1.0f64 / 12.0).sqrt();
        assert!((estimate.error(0.0) - expected).abs() < 1e-15);
    }
}
