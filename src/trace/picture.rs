//! A picture, row by row.

#![warn(missing_docs)]

mod pen;
mod quick;

use super::adaptive::{BATCH_SAMPLES, First, contrast};
use super::camera::View;
use super::compile::cannot_draw;
use super::costs::CostMap;
use super::film::Film;
use super::kernel;
use super::kernel::Stage;
use super::plan::Effect;
use super::precision::Precision;
use super::sampling::sample;
use super::shade::{Features, Limits, Shader};
use super::stats::{Counts, Samples};
use super::tracer::{Light, Tracer};
use crate::diagnostics::{Error, Span};
use crate::geometry::dd::Dd;
use crate::geometry::vec::Vec3;
use crate::parallel;
use crate::scene::{Camera, Scene};
use crate::solids::staging;
pub(super) use pen::Pen;
use pen::{Draw, Pixel, Quick};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crop {
    /// The first column, from 0 at the left.
    pub x: u32,
    /// The first row, from 0 at the top.
    pub y: u32,
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
}

/// The kind of numbers with which the tracer computes between a ray and its hits. Camera rays and colours are always
/// doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Numbers {
    /// Single precision; a doubtful decision stands as it is rounded.
    F32,
    /// Double precision; a doubtful decision is made again in double-double.
    #[default]
    F64,
    /// Double-double, about 32 digits.
    Dd,
}

impl Numbers {
    /// The name of the numbers on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Numbers::F32 => "f32",
            Numbers::F64 => "f64",
            Numbers::Dd => "dd",
        }
    }
}

/// How a picture is taken.
#[derive(Debug, Clone)]
pub struct Settings {
    /// The width of the whole picture in pixels, at least 1.
    pub width: u32,
    /// The height of the whole picture in pixels, at least 1.
    pub height: u32,
    /// The part of the picture that is drawn; `None` for all of it.
    pub crop: Option<Crop>,
    /// For each pixel of the whole picture, row by row from the top, whether it is drawn; the others are black. `None`
    /// draws all pixels.
    pub wanted: Option<Arc<[bool]>>,
    /// Number of samples per pixel, at least 1.
    pub samples: u32,
    /// If given, it replaces `samples`: each pixel gets as many samples as bring its estimated error, in linear RGB,
    /// below this number above 0; see [`super::adaptive`].
    pub tolerance: Option<f64>,
    /// The shift of all samples to the right and down, in pixels.
    pub shift: [f64; 2],
    /// Rays deeper than this contribute nothing; a camera ray has depth 0.
    pub depth: u32,
    /// Rays whose weight is below this in every channel contribute nothing; with 0 all rays contribute.
    pub cutoff: f64,
    /// The kind of numbers between a ray and its hits.
    pub numbers: Numbers,
    /// A flag for another thread to break the drawing off. Once it is set, no more pixels are drawn;
    /// [`Picture::finished`] tells which rows are complete.
    pub stop: Option<Arc<AtomicBool>>,
}

impl Settings {
    /// The part of the picture that is drawn, in pixels.
    fn part(&self) -> Crop {
        self.crop.unwrap_or(Crop {
            x: 0,
            y: 0,
            width: self.width,
            height: self.height,
        })
    }

    /// The least number of samples of a pixel.
    fn first_samples(&self) -> u32 {
        match self.tolerance {
            Some(_) => BATCH_SAMPLES,
            None => self.samples.max(1),
        }
    }
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            width: 640,
            height: 480,
            crop: None,
            wanted: None,
            samples: 1,
            tolerance: None,
            shift: [0.0; 2],
            depth: 10,
            cutoff: 1.0 / 4096.0,
            numbers: Numbers::F64,
            stop: None,
        }
    }
}

/// A film and the counts of the work for it.
pub struct Picture {
    /// The pixels.
    pub film: Film,
    /// The samples that were taken.
    pub samples: Samples,
    /// The intersection tests of each pixel.
    pub costs: CostMap,
    /// For each pixel, row by row, whether it shows light that was totally reflected.
    pub total_reflection: Vec<bool>,
    /// For each row, whether it was drawn to its end before the picture was stopped.
    pub finished: Vec<bool>,
    /// Counts of rays and of other work.
    pub counts: Counts,
}

/// The camera that takes a scene's picture: the selected one, the left one of a stereo pair, or an automatic one that
/// frames the scene.
pub fn selected_camera(scene: &Scene, aspect: f64) -> Camera {
    // The list of cameras is never empty.
    staging::selected_cameras(scene, aspect).swap_remove(0)
}

impl Tracer {
    /// The features that the plan calls for. `outside` is whether all camera rays start outside of every solid. To a
    /// camera inside of a lone convex shape, the shape's far side may be in the way of lights.
    fn features(&self, outside: bool) -> Features {
        let (plan, without) = (&self.plan, &self.graph.without);
        let inside = plan.lone_convex && !outside;
        Features {
            shadows: (plan.on(Effect::Shadows) || inside) && !without.shadows,
            glass: plan.on(Effect::Refraction) && !without.refraction,
            mirrors: plan.on(Effect::Reflection) && !without.reflection,
            dispersion: plan.on(Effect::Dispersion) && !without.dispersion,
        }
    }

    /// Takes a picture. `progress` is called after every row, from any thread.
    ///
    /// A pixel depends on the scene and on its own place alone; with a tolerance, also on its neighbours. So the result
    /// does not depend on the number of threads.
    ///
    /// # Errors
    ///
    /// A camera that cannot take pictures: see [`View::new`].
    pub fn render(
        &self,
        camera: &Camera,
        settings: &Settings,
        progress: impl Fn() + Sync,
    ) -> Result<Picture, Error> {
        let stage = self.stage(settings);
        self.render_on(stage.as_ref(), camera, settings, progress)
    }

    /// Takes a picture as [`render`](Self::render) does, with the quick kernel if there is a stage: see
    /// [`stage`](Self::stage). Several pictures share one stage.
    ///
    /// # Errors
    ///
    /// As [`render`](Self::render).
    pub(crate) fn render_on(
        &self,
        stage: Option<&Stage>,
        camera: &Camera,
        settings: &Settings,
        progress: impl Fn() + Sync,
    ) -> Result<Picture, Error> {
        match settings.numbers {
            Numbers::F32 => self.render_in::<f32>(stage, camera, settings, &progress),
            Numbers::F64 => self.render_in::<f64>(stage, camera, settings, &progress),
            Numbers::Dd => self.render_in::<Dd>(stage, camera, settings, &progress),
        }
    }

    fn render_in<R: Precision>(
        &self,
        stage: Option<&Stage>,
        camera: &Camera,
        settings: &Settings,
        progress: &(dyn Fn() + Sync),
    ) -> Result<Picture, Error> {
        self.drawing(camera, settings, |drawing| {
            drawing.picture::<R>(stage, settings, progress)
        })
    }

    /// Sets up the state that all pixels of a picture have in common, and calls `draw` with it.
    pub(super) fn drawing<'t, T>(
        &'t self,
        camera: &Camera,
        settings: &Settings,
        draw: impl FnOnce(&Drawing<'t>) -> T,
    ) -> Result<T, Error> {
        let Settings { width, height, .. } = *settings;
        let view = View::new(camera, width, height)
            .ok_or_else(|| cannot_draw("draw-projection", Span::default(), camera.id))?;
        let limits = Limits {
            depth: settings.depth,
            cutoff: settings.cutoff,
        };
        let eye = match () {
            () if self.clip.is_some() => Eye::Anywhere,
            () if !view.is_pinhole() => Eye::OfEachRay,
            () if self.holds(&mut self.walker::<f64>(), view.position()) => Eye::Anywhere,
            () => Eye::Outside,
        };
        let lights = &self.lights[..];
        let features = self.features(eye == Eye::Outside);
        Ok(draw(&Drawing {
            tracer: self,
            lights,
            limits,
            eye,
            shift: settings.shift,
            features,
            view,
            wanted: settings.wanted.clone(),
            width,
            stop: settings.stop.clone(),
        }))
    }
}

/// Where the rays of a camera start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Eye {
    /// At one point outside of every solid.
    Outside,
    /// Each at a point of its own, which may be in a solid.
    OfEachRay,
    /// In a solid, or where a render box cuts solids open.
    Anywhere,
}

/// The state that the rows of a picture have in common.
pub(super) struct Drawing<'t> {
    pub(super) tracer: &'t Tracer,
    lights: &'t [Light],
    limits: Limits,
    pub(super) view: View,
    eye: Eye,
    shift: [f64; 2],
    features: Features,
    wanted: Option<Arc<[bool]>>,
    /// The width of the whole picture.
    width: u32,
    stop: Option<Arc<AtomicBool>>,
}

impl<'t> Drawing<'t> {
    /// Draws the picture, or the part of it that the settings ask for.
    fn picture<R: Precision>(
        &self,
        stage: Option<&Stage>,
        settings: &Settings,
        progress: &(dyn Fn() + Sync),
    ) -> Picture {
        let Settings { width, height, .. } = *settings;
        let crop = settings.part();
        let samples = settings.first_samples();
        let quick = self.quick(stage);
        let quick = quick.as_ref();
        let Some(tolerance) = settings.tolerance else {
            let draw = |pen: &mut Pen<R>, pixels: &[[u32; 2]]| pen.fixed(pixels, samples);
            return self.drawn((crop, samples), progress, quick, &draw);
        };
        // A pixel at the border of the part has neighbours outside, which adaptive sampling looks at as well.
        let (left, top) = (crop.x.saturating_sub(1), crop.y.saturating_sub(1));
        let around = Crop {
            x: left,
            y: top,
            width: (crop.x + crop.width).saturating_add(1).min(width) - left,
            height: (crop.y + crop.height).saturating_add(1).min(height) - top,
        };
        let (first, counts) = self.first_samples::<R>(around, quick);
        let of = |[x, y]: [u32; 2]| {
            let (x, y) = (x - left, y - top);
            let at = |x: u32, y: u32| &first[y as usize][x as usize];
            let columns = x.saturating_sub(1)..(x + 2).min(around.width);
            let rows = y.saturating_sub(1)..(y + 2).min(around.height);
            let near = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
            (*at(x, y), contrast(near.map(|(x, y)| at(x, y))))
        };
        let draw = |pen: &mut Pen<R>, pixels: &[[u32; 2]]| {
            let first: Vec<(First, f64)> = pixels.iter().map(|&pixel| of(pixel)).collect();
            pen.adaptive(pixels, &first, tolerance)
        };
        let mut picture = self.drawn((crop, samples), progress, quick, &draw);
        picture.counts += counts;
        picture
    }

    /// A pen that draws pixels on one thread, with the quick kernel if that can draw the scene.
    pub(super) fn pen<'d, R: Precision>(
        &'d self,
        quick: Option<&'d kernel::Scene<'d>>,
    ) -> Pen<'d, 't, R> {
        Pen {
            shader: Shader::new(self.tracer, self.lights, self.limits, self.features),
            drawing: self,
            quick: quick.map(|scene| Quick::new(scene, self.tracer)),
        }
    }

    /// The origin and direction of the ray of sample `i` of `n` in a pixel; `None` if the projection has no ray there.
    #[inline]
    fn line(&self, x: u32, y: u32, i: u32, n: u32) -> Option<[Vec3; 2]> {
        let [dx, dy] = sample(x, y, i, n);
        let [dx, dy] = [dx + self.shift[0], dy + self.shift[1]];
        self.view.line(f64::from(x) + dx, f64::from(y) + dy)
    }

    /// Whether all rays of the camera start outside of every solid.
    pub(super) fn is_outside(&self) -> bool {
        self.eye == Eye::Outside
    }

    fn is_wanted(&self, x: u32, y: u32) -> bool {
        let at = y as usize * self.width as usize + x as usize;
        (self.wanted.as_deref()).is_none_or(|w| w.get(at).copied().unwrap_or(false))
    }

    /// Whether to break off: the flag of the settings is set, or a ray has used up its memory.
    fn is_to_stop(&self) -> bool {
        (self.stop.as_deref()).is_some_and(|stop| stop.load(Ordering::Relaxed))
            || self.tracer.graph.room.is_exhausted()
    }

    /// Draws a part of the picture in parallel, some rows at a time. Pixels that are not drawn before a break-off are
    /// black. `samples` is the least number of samples of a pixel.
    fn drawn<R: Precision>(
        &self,
        (part, samples): (Crop, u32),
        progress: &(dyn Fn() + Sync),
        quick: Option<&kernel::Scene>,
        draw: Draw<R>,
    ) -> Picture {
        let Crop { width, height, .. } = part;
        let count = width as usize * height as usize;
        let mut film = vec![[0.0; 3]; count];
        let mut tests = vec![0; count];
        let mut total_reflection = vec![false; count];
        let side = (width as usize).max(1);
        let rows: Vec<Row> = (part.y..)
            .zip(film.chunks_mut(side))
            .zip(
                tests
                    .chunks_mut(side)
                    .zip(total_reflection.chunks_mut(side)),
            )
            .map(|((y, film), (tests, total_reflection))| Row {
                y,
                film,
                tests,
                total_reflection,
            })
            .collect();
        let shape = if quick.is_some() {
            quick::tile(samples)
        } else {
            [1, 1]
        };
        let drawn = parallel::map_each_with(
            in_bands(rows, shape[1]),
            || self.pen(quick),
            |pen, band| self.band(pen, band, (part.x, shape[0]), progress, draw),
        );
        let mut samples = Samples::NONE;
        let mut counts = Counts::default();
        let mut finished = Vec::with_capacity(height as usize);
        for band in drawn {
            counts += band.counts;
            for of_row in band.samples {
                samples.add(of_row);
                finished.push(band.is_finished);
            }
        }
        samples.min = samples.min.min(samples.max);
        Picture {
            film: Film {
                width,
                height,
                pixels: film,
            },
            samples,
            costs: CostMap {
                width,
                height,
                tests,
            },
            total_reflection,
            finished,
            counts,
        }
    }

    /// Draws rows whose first column is `left`, `across` columns at a time, until they are done or the drawing breaks
    /// off.
    fn band<'d, R: Precision>(
        &'d self,
        pen: &mut Pen<'d, 't, R>,
        mut band: Vec<Row>,
        (left, across): (u32, usize),
        progress: &(dyn Fn() + Sync),
        draw: Draw<R>,
    ) -> Band {
        let mut samples = vec![Samples::NONE; band.len()];
        if self.is_to_stop() {
            samples.fill(Samples::of(0));
            return Band {
                samples,
                counts: Counts::default(),
                is_finished: false,
            };
        }
        pen.reset();
        let mut quick = 0;
        let width = band.first().map_or(0, |row| row.film.len());
        let (mut places, mut pixels) = (Vec::new(), Vec::new());
        for from in (0..width).step_by(across) {
            places.clear();
            pixels.clear();
            let is_to_stop = self.is_to_stop();
            for (row, samples) in samples.iter_mut().enumerate() {
                let y = band[row].y;
                for column in from..width.min(from + across) {
                    let x = left + column as u32;
                    match self.is_wanted(x, y) && !is_to_stop {
                        true => {
                            places.push((row, column));
                            pixels.push([x, y]);
                        }
                        false => samples.add(Samples::of(0)),
                    }
                }
            }
            for (&(row, column), pixel) in places.iter().zip(draw(pen, &pixels)) {
                samples[row].add(Samples::of(pixel.samples));
                quick += u64::from(pixel.cost.slow == 0);
                band[row].put(column, pixel);
            }
        }
        band.iter().for_each(|_| progress());
        let mut counts = pen.counts();
        counts.quick = quick;
        Band {
            samples,
            counts,
            // A reason to stop never goes away, so a look at the end suffices.
            is_finished: !self.is_to_stop(),
        }
    }

    /// The first samples of each pixel of a part, row by row, and the counts of the work. Adaptive sampling decides by
    /// them how many more samples a pixel needs.
    fn first_samples<R: Precision>(
        &self,
        part: Crop,
        quick: Option<&kernel::Scene>,
    ) -> (Vec<Vec<First>>, Counts) {
        let across = if quick.is_some() { kernel::TILE[0] } else { 1 };
        let rows = parallel::map_with(
            part.height as usize,
            || self.pen::<R>(quick),
            |pen, row| {
                let y = part.y + row as u32;
                pen.reset();
                let mut row = vec![First::default(); part.width as usize];
                let columns: Vec<u32> = (part.x..part.x + part.width).collect();
                for columns in columns.chunks(across) {
                    let is_drawn = |&x: &u32| self.is_wanted(x, y) && !self.is_to_stop();
                    let columns = columns.iter().copied().filter(is_drawn);
                    let pixels: Vec<[u32; 2]> = columns.map(|x| [x, y]).collect();
                    for ([x, _], first) in pixels.iter().zip(pen.first(&pixels)) {
                        row[(x - part.x) as usize] = first;
                    }
                }
                (row, pen.counts())
            },
        );
        let mut counts = Counts::default();
        let rows = rows.into_iter().map(|(row, cost)| {
            counts += cost;
            row
        });
        (rows.collect(), counts)
    }
}

/// The result of some rows that were drawn together.
struct Band {
    /// The samples of each row.
    samples: Vec<Samples>,
    counts: Counts,
    /// Whether the rows were drawn to their end.
    is_finished: bool,
}

/// Splits rows into bands of `height` rows, which are drawn together; the last band may be lower.
fn in_bands(rows: Vec<Row>, height: usize) -> Vec<Vec<Row>> {
    let mut bands: Vec<Vec<Row>> = Vec::with_capacity(rows.len().div_ceil(height));
    for row in rows {
        match bands.last_mut() {
            Some(band) if band.len() < height => band.push(row),
            _ => bands.push(vec![row]),
        }
    }
    bands
}

/// A row of the picture, to be drawn into.
struct Row<'p> {
    y: u32,
    film: &'p mut [[f32; 3]],
    tests: &'p mut [u32],
    total_reflection: &'p mut [bool],
}

impl Row<'_> {
    fn put(&mut self, column: usize, pixel: Pixel) {
        self.film[column] = pixel.colour;
        self.tests[column] = pixel.cost.tests;
        self.total_reflection[column] = pixel.cost.total_reflection;
    }
}
