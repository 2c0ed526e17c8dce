//! Pixels one by one, in doubles: for those who measure what a picture costs and how good it is.
//!
//! With the [`switches`](super::switches) this is all that [`study`](crate::study) asks of the kernel besides
//! pictures and probes.

use super::adaptive::{First, contrast};
use super::picture::{Numbers, Pen, Settings};
use super::precision::Precision;
use super::ray::Ray;
use super::search::escalate::Walkers;
use super::stats::Counts;
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
    /// The distance in units of the unit direction: the number and, for those that have it, what it is rounded by.
    pub t: (f64, f64),
}

/// Draws pixels of one picture on one thread.
pub trait Pixels {
    /// The sum of samples of a pixel: linear RGB, not clipped. Sample `i` of any number above one is
    /// the same; a single one is the centre.
    fn sum(&mut self, x: u32, y: u32, samples: std::ops::Range<u32>, of: u32) -> Rgb;

    /// The object that is seen first through the centre of a pixel; `None`: the background.
    fn seen(&mut self, x: u32, y: u32) -> Option<VisibleObject>;

    /// The counts since the last reset.
    fn counts(&mut self) -> Counts;

    fn reset(&mut self);

    /// Takes the first samples of pixels whose neighbours are going to be drawn adaptively.
    fn look_around(&mut self, _pixels: &[[u32; 2]]) {}

    /// As many samples as the tolerance of the settings asks for: their mean and their number. Kernels
    /// that have no such thing take one.
    fn adaptive(&mut self, x: u32, y: u32) -> (Rgb, u32) {
        (self.sum(x, y, 0..1, 1), 1)
    }
}

impl Tracer {
    /// Hands out what draws the pixels of a picture. Of the settings, `samples`, `crop`, `wanted` and
    /// `stop` do not matter.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn pixels<T>(
        &self,
        camera: &Camera,
        settings: &Settings,
        draw: impl FnOnce(&mut dyn Pixels) -> T,
    ) -> Result<T, Error> {
        match settings.numbers {
            Numbers::F32 => self.pixels_in::<f32, T>(camera, settings, draw),
            Numbers::F64 => self.pixels_in::<f64, T>(camera, settings, draw),
            Numbers::Dd => self.pixels_in::<Dd, T>(camera, settings, draw),
        }
    }

    fn pixels_in<R: Precision, T>(
        &self,
        camera: &Camera,
        settings: &Settings,
        draw: impl FnOnce(&mut dyn Pixels) -> T,
    ) -> Result<T, Error> {
        self.drawing(camera, settings, |drawing| {
            draw(&mut Single {
                pen: drawing.pen::<R>(),
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
    /// For questions that are not to be counted.
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
    fn look_at(&mut self, pixels: impl Iterator<Item = [u32; 2]>) {
        let new: Vec<[u32; 2]> = pixels.filter(|p| !self.first.contains_key(p)).collect();
        let first = self.pen.first(&new);
        self.first.extend(new.into_iter().zip(first));
    }
}

impl<R: Precision> Pixels for Single<'_, '_, R> {
    fn sum(&mut self, x: u32, y: u32, samples: std::ops::Range<u32>, of: u32) -> Rgb {
        let add = |sum: Vec3, i| sum + self.pen.sample(x, y, i, of);
        samples.fold(Vec3::ZERO, add).0
    }

    fn seen(&mut self, x: u32, y: u32) -> Option<VisibleObject> {
        let drawing = self.pen.drawing;
        let ray = (drawing.view).ray(f64::from(x) + 0.5, f64::from(y) + 0.5)?;
        let mut ray: Ray<R> = ray.cast();
        if !ray.line.is_sound() {
            return None;
        }
        ray.within = drawing.within;
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
            self.look_at(outer);
        }
    }

    fn adaptive(&mut self, x: u32, y: u32) -> (Rgb, u32) {
        self.look_at(self.around([x, y]));
        let near = self.around([x, y]).filter_map(|p| self.first.get(&p));
        let contrast = contrast(near);
        let first = self.first.get(&[x, y]).copied().unwrap_or_default();
        let estimates = (self.pen).estimates(&[[x, y]], &[(first, contrast)], self.tolerance);
        let (estimate, _) = estimates.into_iter().next().unwrap_or_default();
        (estimate.mean.0, estimate.samples())
    }
}
