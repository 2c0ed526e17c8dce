//! Pixels one by one, with colours in doubles, to measure the cost and the quality of a picture.
//!
//! Together with the [`switches`](super::switches) this is all that [`study`](crate::study) uses of the tracer besides
//! pictures and probes.

use super::adaptive::{Estimate, First, contrast};
pub use super::kernel::Stage;
use super::picture::{Numbers, Pen, Settings};
use super::precision::Precision;
use super::ray::Ray;
use super::search::escalate::Walkers;
use super::stats::{Cost, Counts};
use super::tracer::Tracer;
use crate::diagnostics::Error;
use crate::geometry::dd::Dd;
use crate::geometry::vec::Vec3;
use crate::scene::{Camera, Rgb};
use rustc_hash::{FxHashMap, FxHashSet};

/// The object that is seen first through a point of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VisibleObject {
    /// ID of the entity whose properties apply.
    pub object: u32,
    /// The distance along the ray as a sum of two doubles: the second one is 0 unless the ray was traced in
    /// double-double.
    pub t: (f64, f64),
}

/// Draws pixels of one picture on one thread.
pub trait Pixels {
    /// The sum of the samples numbered `samples` of a pixel with `of` samples: linear RGB, not clipped. With `of` = 1
    /// the sample is the pixel's centre. With any larger `of`, sample `i` is the same.
    fn sum(&mut self, x: u32, y: u32, samples: std::ops::Range<u32>, of: u32) -> Rgb;

    /// The object that is seen first through the centre of a pixel; `None`: the background.
    fn seen(&mut self, x: u32, y: u32) -> Option<VisibleObject>;

    /// The counts since the last reset.
    fn counts(&mut self) -> Counts;

    fn reset(&mut self);

    /// Prepares to draw `pixels` adaptively: takes the first samples of all neighbours that are not among them.
    fn look_around(&mut self, _pixels: &[[u32; 2]]) {}

    /// The sums that [`sum`](Self::sum) returns, for many pixels, drawn in whatever way is the quickest.
    fn sums(&mut self, pixels: &[[u32; 2]], samples: std::ops::Range<u32>, of: u32) -> Vec<Rgb> {
        let sum = |&[x, y]: &[u32; 2]| self.sum(x, y, samples.clone(), of);
        pixels.iter().map(sum).collect()
    }

    /// Means of pixels over as many samples as the tolerance of the settings asks for, each with the number of samples.
    /// Without adaptive sampling it is one sample.
    fn adaptive(&mut self, pixels: &[[u32; 2]]) -> Vec<(Rgb, u32)> {
        let sums = self.sums(pixels, 0..1, 1);
        sums.into_iter().map(|sum| (sum, 1)).collect()
    }
}

impl Tracer {
    /// Calls `draw` with an object that draws single pixels of a picture, with the quick kernel if there is a stage.
    /// The settings `samples`, `crop`, `wanted` and `stop` do not matter.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn pixels<T>(
        &self,
        camera: &Camera,
        settings: &Settings,
        stage: Option<&Stage>,
        draw: impl FnOnce(&mut dyn Pixels) -> T,
    ) -> Result<T, Error> {
        match settings.numbers {
            Numbers::F32 => self.pixels_in::<f32, T>(camera, settings, stage, draw),
            Numbers::F64 => self.pixels_in::<f64, T>(camera, settings, stage, draw),
            Numbers::Dd => self.pixels_in::<Dd, T>(camera, settings, stage, draw),
        }
    }

    fn pixels_in<R: Precision, T>(
        &self,
        camera: &Camera,
        settings: &Settings,
        stage: Option<&Stage>,
        draw: impl FnOnce(&mut dyn Pixels) -> T,
    ) -> Result<T, Error> {
        self.drawing(camera, settings, |drawing| {
            let quick = drawing.quick(stage);
            draw(&mut Single {
                pen: drawing.pen::<R>(quick.as_ref()),
                walkers: drawing.tracer.walker::<R>(),
                tolerance: settings.tolerance.unwrap_or(0.0),
                size: [settings.width, settings.height],
                first: FxHashMap::default(),
            })
        })
    }
}

struct Single<'d, 't, R: Precision> {
    pen: Pen<'d, 't, R>,
    /// Walkers for questions whose work is not counted.
    walkers: Walkers<'t, R>,
    tolerance: f64,
    size: [u32; 2],
    first: FxHashMap<[u32; 2], First>,
}

impl<R: Precision> Single<'_, '_, R> {
    fn around(&self, [x, y]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> + use<R> {
        let [w, h] = self.size;
        let rows = y.saturating_sub(1)..(y + 2).min(h);
        rows.flat_map(move |y| (x.saturating_sub(1)..(x + 2).min(w)).map(move |x| [x, y]))
    }
}

impl<R: Precision> Single<'_, '_, R> {
    /// Takes the first samples of pixels that have none.
    fn look_at(&mut self, pixels: Vec<[u32; 2]>) {
        let mut new = pixels;
        new.retain(|p| !self.first.contains_key(p));
        new.sort_unstable_by_key(|&[x, y]| [y, x]);
        new.dedup();
        let first = self.pen.first(&new);
        self.first.extend(new.into_iter().zip(first));
    }
}

impl<R: Precision> Pixels for Single<'_, '_, R> {
    fn sum(&mut self, x: u32, y: u32, samples: std::ops::Range<u32>, of: u32) -> Rgb {
        let add = |sum: Vec3, i| sum + self.pen.sample(x, y, i, of);
        samples.fold(Vec3::ZERO, add).0
    }

    fn sums(&mut self, pixels: &[[u32; 2]], samples: std::ops::Range<u32>, of: u32) -> Vec<Rgb> {
        self.pen.sums(pixels, samples, of)
    }

    fn seen(&mut self, x: u32, y: u32) -> Option<VisibleObject> {
        let drawing = self.pen.drawing;
        let ray = (drawing.view).ray(f64::from(x) + 0.5, f64::from(y) + 0.5)?;
        let mut ray: Ray<R> = ray.cast();
        if !ray.line.is_sound() {
            return None;
        }
        ray.is_outside = drawing.is_outside();
        let probe = drawing.tracer.probe(&mut self.walkers, &ray);
        let first = probe.crossings.first()?;
        Some(VisibleObject {
            object: first.object,
            t: first.hit.t.parts(),
        })
    }

    fn counts(&mut self) -> Counts {
        self.pen.counts()
    }

    fn reset(&mut self) {
        self.pen.reset();
    }

    fn look_around(&mut self, pixels: &[[u32; 2]]) {
        let inner: FxHashSet<[u32; 2]> = pixels.iter().copied().collect();
        for &pixel in pixels {
            let outer = self.around(pixel).filter(|p| !inner.contains(p));
            self.look_at(outer.collect());
        }
    }

    fn adaptive(&mut self, pixels: &[[u32; 2]]) -> Vec<(Rgb, u32)> {
        self.look_at(
            pixels
                .iter()
                .flat_map(|&pixel| self.around(pixel))
                .collect(),
        );
        let of = |&pixel: &[u32; 2]| {
            let near = self.around(pixel).filter_map(|p| self.first.get(&p));
            let contrast = contrast(near);
            (
                self.first.get(&pixel).copied().unwrap_or_default(),
                contrast,
            )
        };
        let first: Vec<(First, f64)> = pixels.iter().map(of).collect();
        let estimates = self.pen.estimates(pixels, &first, self.tolerance);
        let mean = |(estimate, _): (Estimate, Cost)| (estimate.mean.0, estimate.samples());
        estimates.into_iter().map(mean).collect()
    }
}
