//! The run from a scene to a report: pilot, references, errors, times.

mod errors;
mod objects;
mod pace;
mod pictures;
mod pilot;
mod references;
mod result;
mod sample;
mod times;

use super::configurations::{Axis, Configuration, Kernel, Settings};
use super::measure::Measured;
use super::report::{Reference, Report, Skipped};
use super::runner::{Drawn, Runner, Timed};
use super::sample_tiles::{TILE, Tile, WHOLE, chosen};
use crate::diagnostics::{Complaint, Error};
use crate::scene::{Camera, Rgb, Scene};
use crate::trace::Images;
use crate::trace::stats::Rays;
use cpu_time::ProcessTime;
use pace::Pace;
use sample::Sample;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// The options of a study.
#[derive(Debug, Clone)]
pub struct Options {
    pub size: [u32; 2],
    /// The axes to run.
    pub axes: Vec<Axis>,
    /// The number of timed runs of each configuration; `None` for 5.
    pub runs: Option<usize>,
    /// Seconds that the whole study may take.
    pub budget: f64,
    /// The error that is wanted, in steps.
    pub goal: f64,
    /// The flag that stops the study: once it is set, the results that are finished are reported.
    pub stop: Arc<AtomicBool>,
}

/// The share by which a configuration may miss the goal: 1.00 steps instead of 1.01 are not worth twice the time.
pub const GOAL_SLACK: f64 = 0.15;

/// The budget in seconds unless another one is given.
pub const DEFAULT_SECONDS: f64 = 120.0;

/// CPU seconds of the shortest run that is worth ranking.
const LEAST_SECONDS: f64 = 0.05;
const LEAST_PIXELS: f64 = 2000.0;

/// The number of pixels that expensive configurations are measured on when time is short: eight tiles.
const FEWEST_PIXELS: f64 = 512.0;

/// Shares of the budget for the steps: the references (numbers and their check have as much each), errors, times, what
/// each object costs, and the pictures side by side.
const NUMBERS: f64 = 0.1;
const LIGHT: f64 = 0.12;
const EDGES: f64 = 0.2;
const ERRORS: f64 = 0.15;
const TIMES: f64 = 0.4;
const OBJECTS: f64 = 0.05;
const PICTURES: f64 = 0.08;

/// The share of the budget below which a piece of work is done even if the time is up.
const CHEAP_SHARE: f64 = 0.005;

/// The function that is told how far the study is: the name of a message about the present step, and the share of the
/// study that is done.
pub type Progress<'p> = &'p dyn Fn(&'static str, f64);

/// The state of a configuration's computation.
#[derive(Default)]
struct ConfigurationState {
    /// Seconds a pixel, on one thread.
    cost: f64,
    /// Seconds a ray, by the pilot.
    per_ray: f64,
    drawn: Option<Drawn>,
    /// The number of tiles in `drawn`.
    tiles: usize,
    measured: Option<Measured>,
    same_as: Option<usize>,
    dropped: bool,
    times: Vec<Timed>,
    /// The tiles that were timed.
    sample: Sample,
}

/// A step from a scene to a report.
type StudyStep<R> = fn(&mut R) -> Result<(), Error>;

/// The number of pixels that see another object first; the median and the largest error of the distance in the others,
/// in units of the last place.
type Distances = (usize, f64, f64);

/// The state of a run.
struct Run<'i> {
    options: &'i Options,
    images: &'i Images,
    runner: Runner<'i>,
    tiles: Vec<Tile>,
    whole: bool,
    configurations: Vec<Configuration>,
    known: Vec<ConfigurationState>,
    effects: Vec<(&'static str, Settings, ConfigurationState)>,
    facets: BTreeMap<Axis, Settings>,
    reference: BTreeMap<&'static str, Reference>,
    skipped: Vec<Skipped>,
    cut: Vec<Complaint>,
    start: Instant,
    progress: Progress<'i>,
    pace: Pace,
    /// The linear RGB of the references of edges, light and numbers, in the order of the tiles' pixels.
    edges: Vec<Rgb>,
    light: Vec<Rgb>,
    exact: Vec<Rgb>,
    /// The time that a pixel of the default takes, as a multiple of what the pilot predicts.
    calibration: f64,
    predicted: f64,
    timed: f64,
    repeats: Vec<Vec<Timed>>,
    /// The tiles that the default was timed on.
    frame: Sample,
    /// CPU seconds that the default takes for each of the first tiles.
    weights: Vec<f64>,
}

/// Studies a scene within a budget. `name` is the scene's name in the report.
///
/// # Errors
///
/// As [`Tracer::render`](crate::trace::Tracer::render).
pub fn run(
    name: &str,
    scene: &Arc<Scene>,
    images: &Images,
    camera: Camera,
    options: &Options,
    progress: Progress,
) -> Result<Report, Error> {
    let before = load();
    let runner = Runner::new(scene.clone(), images, camera, options.size)?;
    let share = (options.budget / DEFAULT_SECONDS).ceil().clamp(1.0, 16.0) as usize;
    let [width, height] = options.size;
    let tiles = chosen(options.size, share);
    let mut run = Run {
        options,
        images,
        runner,
        whole: u64::from(width) * u64::from(height) <= WHOLE || share == 16,
        tiles,
        configurations: Vec::new(),
        known: Vec::new(),
        effects: Vec::new(),
        facets: BTreeMap::new(),
        reference: BTreeMap::new(),
        skipped: Vec::new(),
        cut: Vec::new(),
        start: Instant::now(),
        progress,
        pace: Pace::new(rayon::current_num_threads() as f64),
        edges: Vec::new(),
        light: Vec::new(),
        exact: Vec::new(),
        calibration: 1.0,
        predicted: 0.0,
        timed: 0.0,
        repeats: Vec::new(),
        frame: Sample::default(),
        weights: Vec::new(),
    };
    run.all()?;
    run.report(name, before)
}

fn load() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/loadavg").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

impl Run<'_> {
    fn is_stopped(&self) -> bool {
        self.options.stop.load(Ordering::Relaxed)
    }

    fn seconds(&self, share: f64) -> f64 {
        share * self.options.budget
    }

    /// The seconds that a step may take: its share of the budget, or less if earlier steps took more than theirs, but
    /// at least a quarter. `behind` is the share of all later steps.
    fn allotted(&self, share: f64, behind: f64) -> f64 {
        let least = self.seconds(share) / 4.0;
        self.left(behind).clamp(least, self.seconds(share))
    }

    /// The CPU seconds that one thread gets in a number of seconds.
    fn on_one(&self, seconds: f64) -> f64 {
        seconds * self.pace.of_one()
    }

    /// The CPU seconds that all threads together get in a number of seconds.
    fn on_all(&self, seconds: f64) -> f64 {
        seconds * self.pace.of_all()
    }

    /// Whether a piece of work of `seconds` CPU seconds is done even if the time is up.
    fn is_cheap(&self, seconds: f64) -> bool {
        seconds < self.on_one(self.seconds(CHEAP_SHARE))
    }

    /// Draws tiles on one thread, and takes the time.
    fn time(&mut self, settings: &Settings, tiles: &[Tile]) -> Result<Timed, Error> {
        let timed = self.runner.time(settings, tiles)?;
        self.pace.one(timed.cpu, timed.wall);
        Ok(timed)
    }

    /// Does some work with the first tiles on all threads, and counts its time in the pace.
    fn together<T>(
        &mut self,
        tiles: usize,
        work: impl FnOnce(&mut Runner, &[Tile]) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let (start, cpu) = (Instant::now(), ProcessTime::now());
        let done = work(&mut self.runner, &self.tiles[..tiles])?;
        let (cpu, wall) = (cpu.elapsed(), start.elapsed());
        self.pace.all(cpu.as_secs_f64(), wall.as_secs_f64());
        Ok(done)
    }

    /// Draws the first tiles on all threads.
    fn draw(&mut self, settings: &Settings, tiles: usize) -> Result<Drawn, Error> {
        self.together(tiles, |runner, tiles| runner.draw(settings, tiles))
    }

    /// The seconds of the budget that are left, without the share `behind` that is kept for later steps.
    fn left(&self, behind: f64) -> f64 {
        self.options.budget - self.start.elapsed().as_secs_f64() - self.seconds(behind)
    }

    fn pixels(&self, tiles: usize) -> usize {
        self.tiles[..tiles].iter().map(|t| t.count()).sum()
    }

    /// Number of tiles that take `seconds` at `cost` seconds a pixel, and hold at least `least` pixels.
    fn tiles_for(&self, seconds: f64, cost: f64, least: f64) -> usize {
        let pixels = (seconds / cost.max(1e-12)).max(least);
        let tile = f64::from(TILE * TILE);
        ((pixels / tile).ceil() as usize).clamp(1, self.tiles.len())
    }

    fn all(&mut self) -> Result<(), Error> {
        let steps: [(&'static str, f64, StudyStep<Self>); 7] = [
            ("accuracy-step-pilot", 0.0, Self::pilot),
            ("accuracy-step-numbers", 0.1, Self::reference_numbers),
            ("accuracy-step-light", 0.25, Self::reference_light),
            ("accuracy-step-edges", 0.3, Self::reference_edges),
            ("accuracy-step-errors", 0.45, Self::errors),
            ("accuracy-step-times", 0.55, Self::times),
            ("accuracy-step-objects", 0.95, |_| Ok(())),
        ];
        self.plan()?;
        for (name, behind, step) in steps {
            if self.is_stopped() {
                break;
            }
            (self.progress)(name, behind);
            step(self)?;
        }
        Ok(())
    }

    fn find(&self, kernel: Kernel) -> Option<usize> {
        let of = |r: &Configuration| r.axis == Axis::Precision && r.settings.kernel == kernel;
        self.configurations.iter().position(of)
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum TimedItem {
    Configuration(usize),
    Effect(usize),
    Default(usize),
}

fn rays(rays: &Rays) -> u64 {
    rays.camera + rays.shadow + rays.reflection + rays.refraction
}
