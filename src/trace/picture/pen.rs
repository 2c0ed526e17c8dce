//! Drawing of samples and pixels, on one thread.

use super::Drawing;
use crate::geometry::vec::Vec3;
use crate::scene::Rgb;
use crate::trace::adaptive::{BATCH_SAMPLES, Estimate, First, MAX_SAMPLES};
use crate::trace::film::developed;
use crate::trace::kernel::{self, Tile};
use crate::trace::precision::Precision;
use crate::trace::ray::Ray;
use crate::trace::search::escalate::Walkers;
use crate::trace::shade::Shader;
use crate::trace::stats::{Cost, Counts};
use crate::trace::tracer::Tracer;

/// A finished pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pixel {
    pub(super) colour: [f32; 3],
    pub(super) samples: u32,
    pub(super) cost: Cost,
}

/// The place of a sample: the column and the row of its pixel, its number in the pixel, and the number of samples of
/// the pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct SampleOf {
    pub(super) pixel: [u32; 2],
    pub(super) sample: u32,
    pub(super) of: u32,
}

/// The result of a sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) light: Vec3,
    pub(super) cost: Cost,
}

/// The quick kernel on one thread.
pub(super) struct Quick<'d> {
    scene: &'d kernel::Scene<'d>,
    tile: Box<Tile>,
    counts: Counts,
    rays: Vec<[Vec3; 2]>,
    /// Walkers that tell whether a ray starts in a solid, for cameras whose rays start at points of their own.
    starts: Walkers<'d, f64>,
}

impl<'d> Quick<'d> {
    pub(super) fn new(scene: &'d kernel::Scene<'d>, tracer: &'d Tracer) -> Quick<'d> {
        Quick {
            scene,
            starts: tracer.walker(),
            tile: Box::default(),
            counts: Counts::default(),
            rays: Vec::new(),
        }
    }
}

/// Draws pixels on one thread.
pub(in crate::trace) struct Pen<'d, 't, R: Precision> {
    pub(in crate::trace) shader: Shader<'d, R>,
    pub(in crate::trace) drawing: &'d Drawing<'t>,
    /// The quick kernel, if it can draw the scene. `shader` draws the samples that the kernel cannot draw.
    pub(super) quick: Option<Quick<'d>>,
}

impl<R: Precision> Pen<'_, '_, R> {
    /// Sets all counts to 0.
    pub(in crate::trace) fn reset(&mut self) {
        self.shader.reset();
        if let Some(quick) = &mut self.quick {
            quick.tile.take_work();
            quick.counts = Counts::default();
        }
    }

    /// The counts since the last reset.
    pub(in crate::trace) fn counts(&mut self) -> Counts {
        let mut counts = self.shader.counts();
        if let Some(quick) = &mut self.quick {
            quick.counts.work += quick.tile.take_work();
            counts += quick.counts;
        }
        counts
    }

    /// Draws samples, and returns them in the order of their places.
    pub(super) fn samples(&mut self, places: &[SampleOf]) -> Vec<Sample> {
        let Some(mut quick) = self.quick.take() else {
            return places.iter().map(|&place| self.slow(place)).collect();
        };
        let Drawing { tracer, .. } = *self.drawing;
        let is_outside = self.drawing.is_outside();
        let mut line = |place: &SampleOf| {
            let [x, y] = place.pixel;
            let line = self.drawing.line(x, y, place.sample, place.of)?;
            let is_outside = is_outside || !tracer.holds(&mut quick.starts, line[0]);
            is_outside.then_some(line)
        };
        let mut samples = Vec::with_capacity(places.len());
        for places in places.chunks(kernel::TILE[0] * kernel::TILE[1]) {
            quick.rays.clear();
            quick
                .rays
                .extend(places.iter().map(|place| line(place).unwrap_or_default()));
            let drawn = (quick.tile).draw(quick.scene, &mut self.shader, &quick.rays);
            samples.extend(drawn.iter().zip(places).map(|(drawn, &place)| {
                if drawn.is_lost {
                    return self.slow(place);
                }
                drawn.count(&mut quick.counts);
                Sample {
                    light: drawn.light,
                    cost: drawn.cost(),
                }
            }));
        }
        self.quick = Some(quick);
        samples
    }

    /// Draws a sample without the quick kernel.
    fn slow(&mut self, place: SampleOf) -> Sample {
        let SampleOf {
            pixel: [x, y],
            sample,
            of,
        } = place;
        let before = self.shader.spent();
        let light = self.sample(x, y, sample, of);
        let cost = self.shader.cost_since(before);
        Sample { light, cost }
    }

    /// The light of sample `i` of `n` of pixel (x, y), drawn without the quick kernel. It is 0 if the projection has no
    /// ray there, or if the ray is out of the range of the numbers.
    pub(in crate::trace) fn sample(&mut self, x: u32, y: u32, i: u32, n: u32) -> Vec3 {
        let line = self.drawing.line(x, y, i, n);
        match line.map(|[origin, direction]| Ray::new(origin, direction).cast::<R>()) {
            Some(mut ray) if ray.line.is_sound() => {
                ray.is_outside = self.drawing.is_outside();
                Vec3(self.shader.radiance(&ray))
            }
            _ => Vec3::ZERO,
        }
    }

    /// Draws pixels with `n` samples each.
    pub(super) fn fixed(&mut self, pixels: &[[u32; 2]], n: u32) -> Vec<Pixel> {
        let places = pixels.iter().flat_map(|&pixel| places(pixel, 0..n, n));
        let samples = self.samples(&places.collect::<Vec<_>>());
        let pixel = |samples: &[Sample]| Pixel {
            colour: developed((sum(samples) / f64::from(n)).0),
            samples: n,
            cost: cost(samples),
        };
        samples.chunks(n as usize).map(pixel).collect()
    }

    /// For each pixel, the sum of the samples numbered `samples` of `of`: linear RGB, not clipped.
    pub(in crate::trace) fn sums(
        &mut self,
        pixels: &[[u32; 2]],
        samples: std::ops::Range<u32>,
        of: u32,
    ) -> Vec<Rgb> {
        let places = pixels
            .iter()
            .flat_map(|&pixel| places(pixel, samples.clone(), of));
        let drawn = self.samples(&places.collect::<Vec<_>>());
        let sum = |samples: &[Sample]| sum(samples).0;
        drawn.chunks(samples.len().max(1)).map(sum).collect()
    }

    /// Takes the first samples of pixels that are to be drawn adaptively.
    pub(in crate::trace) fn first(&mut self, pixels: &[[u32; 2]]) -> Vec<First> {
        let of = |&pixel: &[u32; 2]| places(pixel, 0..BATCH_SAMPLES, MAX_SAMPLES);
        let samples = self.samples(&pixels.iter().flat_map(of).collect::<Vec<_>>());
        let (batches, _) = samples.as_chunks::<{ BATCH_SAMPLES as usize }>();
        let first = |batch: &[Sample; BATCH_SAMPLES as usize]| First {
            samples: batch.map(|sample| developed(sample.light.0)),
            cost: cost(batch),
        };
        batches.iter().map(first).collect()
    }

    /// Draws pixels with as many samples as the tolerance asks for. `first` are the first samples of each pixel and the
    /// contrast among its neighbours.
    pub(super) fn adaptive(
        &mut self,
        pixels: &[[u32; 2]],
        first: &[(First, f64)],
        tolerance: f64,
    ) -> Vec<Pixel> {
        let estimates = self.estimates(pixels, first, tolerance).into_iter();
        let pixel = |(estimate, cost): (Estimate, Cost)| Pixel {
            colour: developed(estimate.mean.0),
            samples: estimate.samples(),
            cost,
        };
        estimates.map(pixel).collect()
    }

    /// The estimates of pixels by as many samples as the tolerance asks for, and their costs: see
    /// [`adaptive`](Self::adaptive).
    pub(in crate::trace) fn estimates(
        &mut self,
        pixels: &[[u32; 2]],
        first: &[(First, f64)],
        tolerance: f64,
    ) -> Vec<(Estimate, Cost)> {
        let begun = |(first, _): &(First, f64)| {
            let mut estimate = Estimate::new();
            let samples = first.samples.map(|s| Vec3(s.map(f64::from)));
            estimate.add(mean(&samples));
            (estimate, first.cost)
        };
        let mut all: Vec<(Estimate, Cost)> = first.iter().map(begun).collect();
        loop {
            let missing = |i: usize| (all[i].0).missing_batches(first[i].1, tolerance);
            let open: Vec<(usize, u32)> = (0..all.len())
                .map(|i| (i, missing(i)))
                .filter(|&(_, missing)| missing > 0)
                .collect();
            if open.is_empty() {
                return all;
            }
            let more = open.iter().flat_map(|&(i, missing)| {
                let from = all[i].0.samples();
                places(pixels[i], from..from + missing * BATCH_SAMPLES, MAX_SAMPLES)
            });
            let samples = self.samples(&more.collect::<Vec<_>>());
            let mut batches = samples.chunks(BATCH_SAMPLES as usize);
            for (i, missing) in open {
                let (estimate, cost_of) = &mut all[i];
                for batch in batches.by_ref().take(missing as usize) {
                    estimate.add(sum(batch) / f64::from(BATCH_SAMPLES));
                    *cost_of += cost(batch);
                }
            }
        }
    }
}

/// The places of some samples of a pixel.
fn places(
    pixel: [u32; 2],
    samples: std::ops::Range<u32>,
    of: u32,
) -> impl Iterator<Item = SampleOf> {
    samples.map(move |sample| SampleOf { pixel, sample, of })
}

fn mean(batch: &[Vec3; BATCH_SAMPLES as usize]) -> Vec3 {
    batch.iter().fold(Vec3::ZERO, |sum, s| sum + *s) / f64::from(BATCH_SAMPLES)
}

fn sum(samples: &[Sample]) -> Vec3 {
    (samples.iter()).fold(Vec3::ZERO, |sum, sample| sum + sample.light)
}

fn cost(samples: &[Sample]) -> Cost {
    samples.iter().fold(Cost::default(), |mut all, sample| {
        all += sample.cost;
        all
    })
}

/// Draws some pixels, given by their columns and rows.
pub(super) type Draw<'a, R> = &'a (dyn Fn(&mut Pen<'_, '_, R>, &[[u32; 2]]) -> Vec<Pixel> + Sync);
