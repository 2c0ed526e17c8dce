//! Pixels, one after the other.

use super::Drawing;
use crate::geometry::vec::Vec3;
use crate::trace::adaptive::{BATCH_SAMPLES, Estimate, First, MAX_SAMPLES};
use crate::trace::film::developed;
use crate::trace::precision::Precision;
use crate::trace::ray::Ray;
use crate::trace::shade::Shader;

/// A finished pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pixel {
    pub(super) colour: [f32; 3],
    pub(super) samples: u32,
    pub(super) tests: u32,
    pub(super) total_reflection: bool,
}

/// Draws pixels on one thread.
pub(in crate::trace) struct Pen<'d, 't, R: Precision> {
    pub(in crate::trace) shader: Shader<'d, R>,
    pub(in crate::trace) drawing: &'d Drawing<'t>,
}

impl<R: Precision> Pen<'_, '_, R> {
    /// Intersection tests since the last reset.
    fn tests(&self) -> u64 {
        let counted = self.shader.intersections();
        counted.boxes + counted.shape
    }

    fn tests_since(&self, before: u64) -> u32 {
        u32::try_from(self.tests() - before).unwrap_or(u32::MAX)
    }

    /// Times that light was totally reflected since the last reset.
    fn total(&self) -> u64 {
        self.shader.total()
    }

    /// The light of sample `i` of `n`; where a projection has no ray, or none in
    /// the range of the precision, there is nothing to be seen.
    pub(in crate::trace) fn sample(&mut self, x: u32, y: u32, i: u32, n: u32) -> Vec3 {
        let line = self.drawing.line(x, y, i, n);
        match line.map(|[origin, direction]| Ray::new(origin, direction).cast::<R>()) {
            Some(mut ray) if ray.line.is_sound() => {
                ray.within = self.drawing.within;
                Vec3(self.shader.radiance(&ray))
            }
            _ => Vec3::ZERO,
        }
    }

    /// The mean of `n` samples.
    pub(super) fn fixed(&mut self, x: u32, y: u32, n: u32) -> Pixel {
        let (before, total) = (self.tests(), self.total());
        let mut sum = Vec3::ZERO;
        for i in 0..n {
            sum = sum + self.sample(x, y, i, n);
        }
        Pixel {
            colour: developed((sum / f64::from(n)).0),
            samples: n,
            tests: self.tests_since(before),
            total_reflection: self.total() > total,
        }
    }

    /// The first samples of a pixel that may get more.
    pub(in crate::trace) fn first(&mut self, x: u32, y: u32) -> First {
        let (before, total) = (self.tests(), self.total());
        let samples = [0, 1, 2, 3].map(|i| developed(self.sample(x, y, i, MAX_SAMPLES).0));
        First {
            samples,
            tests: self.tests_since(before),
            total_reflection: self.total() > total,
        }
    }

    /// As many samples as the tolerance asks for, given the first ones.
    pub(super) fn adaptive(
        &mut self,
        x: u32,
        y: u32,
        first: &First,
        contrast: f64,
        tolerance: f64,
    ) -> Pixel {
        let (before, total) = (self.tests(), self.total());
        let estimate = self.estimate(x, y, first, contrast, tolerance);
        Pixel {
            colour: developed(estimate.mean.0),
            samples: estimate.samples(),
            tests: first.tests.saturating_add(self.tests_since(before)),
            total_reflection: first.total_reflection || self.total() > total,
        }
    }

    pub(in crate::trace) fn estimate(
        &mut self,
        x: u32,
        y: u32,
        first: &First,
        contrast: f64,
        tolerance: f64,
    ) -> Estimate {
        let mean = |batch: [Vec3; BATCH_SAMPLES as usize]| {
            batch.into_iter().fold(Vec3::ZERO, |sum, s| sum + s) / f64::from(BATCH_SAMPLES)
        };
        let mut estimate = Estimate::new();
        estimate.add(mean(first.samples.map(|s| Vec3(s.map(f64::from)))));
        while !estimate.is_enough(contrast, tolerance) {
            let n = estimate.samples();
            estimate.add(mean(
                [0, 1, 2, 3].map(|i| self.sample(x, y, n + i, MAX_SAMPLES)),
            ));
        }
        estimate
    }
}

/// Draws the pixel in a column and a row.
pub(super) type Draw<'a, R> = &'a (dyn Fn(&mut Pen<'_, '_, R>, u32, u32) -> Pixel + Sync);
