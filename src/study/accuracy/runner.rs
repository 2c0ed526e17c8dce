//! Draws and times tiles with any settings.

use super::configurations::{Kernel, Roots, Settings};
use super::sample_tiles::Tile;
use crate::diagnostics::Error;
use crate::parallel;
use crate::scene::{Camera, Rgb, Scene};
use crate::study::plain::Plain;
use crate::study::plain::solver;
use crate::trace::pixels::{Pixels, Stage, VisibleObject};
use crate::trace::plan::Plan;
use crate::trace::stats::Counts;
use crate::trace::{self, Images, Numbers, Tracer};
use cpu_time::ThreadTime;
use std::sync::Arc;
use std::time::Instant;

/// A scene that is drawn, and its tracers; the second one is made when it is first needed.
struct Variant {
    scene: Arc<Scene>,
    /// The tracer of the objects that the picture shows.
    tracer: Tracer,
    /// The tracer of the whole scene, with the objects that the picture does not show: single precision may show them.
    whole: Option<Tracer>,
}

/// Draws one scene, and variants of it, with one camera in one size, by any settings.
pub struct Runner<'i> {
    variants: Vec<Variant>,
    images: &'i Images,
    camera: Camera,
    pub size: [u32; 2],
}

/// The pixels of some tiles, one tile after the other, and the work that they took.
#[derive(Debug, Clone, Default)]
pub struct Drawn {
    /// Linear RGB.
    pub colours: Vec<Rgb>,
    pub counts: Counts,
    pub samples: u64,
}

/// The time of a run on one thread, in seconds.
#[derive(Debug, Clone, Default)]
pub struct Timed {
    pub cpu: f64,
    pub wall: f64,
    /// CPU time of each tile.
    pub tiles: Vec<f64>,
    pub drawn: Drawn,
}

impl<'i> Runner<'i> {
    /// # Errors
    ///
    /// As [`Tracer::planned`].
    pub fn new(
        scene: Arc<Scene>,
        images: &'i Images,
        camera: Camera,
        size: [u32; 2],
    ) -> Result<Runner<'i>, Error> {
        let mut runner = Runner {
            variants: Vec::new(),
            images,
            camera,
            size,
        };
        runner.add(scene)?;
        Ok(runner)
    }

    /// Adds a scene that was made from the first one, and returns its number.
    ///
    /// # Errors
    ///
    /// As [`Tracer::planned`].
    pub fn add(&mut self, scene: Arc<Scene>) -> Result<usize, Error> {
        let plan = Plan::of_picture(&scene).ok_or_else(Error::nothing_to_draw)?;
        let tracer = Tracer::planned(&scene, self.images, plan)?;
        self.variants.push(Variant {
            scene,
            tracer,
            whole: None,
        });
        Ok(self.variants.len() - 1)
    }

    /// The tracer of the given scene.
    pub fn tracer(&self) -> &Tracer {
        &self.variants[0].tracer
    }

    pub fn scene(&self) -> &Scene {
        &self.variants[0].scene
    }

    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Prepares the tracer of a variant for settings. The result borrows the runner: one tracer cannot serve two
    /// settings at a time.
    fn prepare(&mut self, settings: &Settings) -> Result<Ready<'_>, Error> {
        let variant = &mut self.variants[settings.variant];
        let tracer = match settings.kernel {
            Kernel::Ours(Numbers::F32) | Kernel::PlainF32 => {
                if variant.whole.is_none() {
                    let whole = Tracer::with_images(&variant.scene, self.images)?;
                    variant.whole = Some(whole);
                }
                variant.whole.as_mut().unwrap_or(&mut variant.tracer)
            }
            _ => &mut variant.tracer,
        };
        tracer.graph.without = settings.without;
        tracer.graph.solver = match settings.roots {
            Roots::Ours => None,
            roots => solver::of(&variant.scene, tracer, roots.into()),
        };
        Ok(Ready {
            tracer,
            stage: None,
            scene: &variant.scene,
            camera: &self.camera,
            size: self.size,
            settings: *settings,
        })
    }

    /// Draws tiles on all threads.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn draw(&mut self, settings: &Settings, tiles: &[Tile]) -> Result<Drawn, Error> {
        let ready = self.prepare(settings)?.staged()?;
        let chunks: Vec<&[Tile]> = tiles.chunks(4).collect();
        let parts = parallel::map_each(chunks, |tiles| {
            ready.pixels(|pixels| {
                let mut drawn = Drawn::default();
                tiles
                    .iter()
                    .for_each(|t| ready.tile(pixels, *t, &mut drawn));
                drawn.counts = pixels.counts();
                drawn
            })
        });
        let parts = parts.into_iter().collect::<Result<Vec<Drawn>, Error>>()?;
        let mut all = Drawn::default();
        for part in parts {
            all.colours.extend(part.colours);
            all.counts += part.counts;
            all.samples += part.samples;
        }
        Ok(all)
    }

    /// Draws tiles on this thread and takes the time.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn time(&mut self, settings: &Settings, tiles: &[Tile]) -> Result<Timed, Error> {
        let ready = self.prepare(settings)?.staged()?;
        ready.pixels(|pixels| {
            let mut timed = Timed::default();
            timed
                .drawn
                .colours
                .reserve(tiles.iter().map(|t| t.count()).sum());
            if settings.tolerance.is_some() {
                // A whole picture draws the surroundings of a tile anyway, so that their time is not counted.
                for tile in tiles {
                    pixels.look_around(&tile.pixels().collect::<Vec<_>>());
                }
                pixels.reset();
            }
            let (wall, mut before) = (Instant::now(), ThreadTime::now().as_duration());
            let first = before;
            for tile in tiles {
                ready.tile(pixels, *tile, &mut timed.drawn);
                let now = ThreadTime::now().as_duration();
                timed.tiles.push((now - before).as_secs_f64());
                before = now;
            }
            timed.cpu = (before - first).as_secs_f64();
            timed.wall = wall.elapsed().as_secs_f64();
            timed.drawn.counts = pixels.counts();
            timed
        })
    }

    /// For each pixel of tiles, the sum of the colours of a range of samples; on all threads.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn sums(
        &mut self,
        settings: &Settings,
        tiles: &[Tile],
        samples: std::ops::Range<u32>,
    ) -> Result<Vec<Rgb>, Error> {
        let ready = self.prepare(settings)?.staged()?;
        let parts = parallel::map_each(tiles.to_vec(), |tile| {
            ready.pixels(|pixels| {
                let places: Vec<[u32; 2]> = tile.pixels().collect();
                pixels.sums(&places, samples.clone(), u32::MAX)
            })
        });
        let parts = parts.into_iter().collect::<Result<Vec<_>, Error>>()?;
        Ok(parts.concat())
    }

    /// For each pixel of tiles, the object that is seen first at its centre; on all threads.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn seen(
        &mut self,
        settings: &Settings,
        tiles: &[Tile],
    ) -> Result<Vec<Option<VisibleObject>>, Error> {
        let ready = self.prepare(settings)?;
        let chunks: Vec<&[Tile]> = tiles.chunks(4).collect();
        let parts = parallel::map_each(chunks, |tiles| {
            ready.pixels(|pixels| {
                let all = tiles.iter().flat_map(|t| t.pixels());
                all.map(|[x, y]| pixels.seen(x, y)).collect::<Vec<_>>()
            })
        });
        let parts = parts.into_iter().collect::<Result<Vec<_>, Error>>()?;
        Ok(parts.concat())
    }

    /// For each pixel of tiles, the least wall time of three runs on this thread, in seconds.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn pixel_times(&mut self, settings: &Settings, tiles: &[Tile]) -> Result<Vec<f64>, Error> {
        let ready = self.prepare(settings)?;
        ready.pixels(|pixels| {
            let all: Vec<[u32; 2]> = tiles.iter().flat_map(|t| t.pixels()).collect();
            let mut least = vec![f64::INFINITY; all.len()];
            for _ in 0..3 {
                for (least, [x, y]) in least.iter_mut().zip(&all) {
                    let start = Instant::now();
                    std::hint::black_box(pixels.sum(*x, *y, 0..settings.samples, settings.samples));
                    *least = least.min(start.elapsed().as_secs_f64());
                }
            }
            least
        })
    }
}

/// A tracer made ready for some settings.
struct Ready<'s> {
    tracer: &'s Tracer,
    /// The stage of the quick kernel, if that draws the picture.
    stage: Option<Stage<'s>>,
    scene: &'s Scene,
    camera: &'s Camera,
    size: [u32; 2],
    settings: Settings,
}

impl<'s> Ready<'s> {
    /// Adds the stage of the quick kernel, if that kernel draws the picture.
    fn staged(mut self) -> Result<Ready<'s>, Error> {
        if let Kernel::Ours(numbers) = self.settings.kernel {
            self.stage = self.tracer.stage(&self.taken(numbers));
        }
        Ok(self)
    }

    fn pixels<T>(&self, draw: impl FnOnce(&mut dyn Pixels) -> T) -> Result<T, Error> {
        let all = (self.scene, self.tracer, self.camera);
        match self.settings.kernel {
            Kernel::Ours(numbers) => {
                let (taken, stage) = (self.taken(numbers), self.stage.as_ref());
                self.tracer.pixels(self.camera, &taken, stage, draw)
            }
            Kernel::PlainF32 => Plain::<f32>::pixels(all, &self.taken(Numbers::F32), draw),
            Kernel::PlainF64 => Plain::<f64>::pixels(all, &self.taken(Numbers::F64), draw),
        }
    }

    /// The tracer's settings for the whole picture.
    fn taken(&self, numbers: Numbers) -> trace::Settings {
        let [width, height] = self.size;
        let settings = self.settings;
        trace::Settings {
            width,
            height,
            samples: settings.samples,
            tolerance: settings.tolerance,
            depth: settings.depth,
            cutoff: settings.cutoff,
            numbers,
            ..trace::Settings::default()
        }
    }

    fn tile(&self, pixels: &mut dyn Pixels, tile: Tile, drawn: &mut Drawn) {
        let n = self.settings.samples;
        let places: Vec<[u32; 2]> = tile.pixels().collect();
        let all = match self.settings.tolerance {
            Some(_) => pixels.adaptive(&places),
            None => {
                let mean = |sum: Rgb| (sum.map(|c| c / f64::from(n)), n);
                (pixels.sums(&places, 0..n, n).into_iter().map(mean)).collect()
            }
        };
        for (colour, samples) in all {
            drawn.colours.push(colour);
            drawn.samples += u64::from(samples);
        }
    }
}

impl From<Roots> for solver::Method {
    fn from(roots: Roots) -> solver::Method {
        match roots {
            Roots::ClosedForm => solver::Method::ClosedForm,
            Roots::Recentred | Roots::Ours => solver::Method::Recentred,
            Roots::Polished => solver::Method::Polished,
        }
    }
}
