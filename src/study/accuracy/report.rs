//! The results of a study, as `accuracy.json` has them.

use super::configurations::{Axis, Kind};
use super::measure::Measured;
use super::timing::Spread;
use crate::diagnostics::Complaint;
use crate::scene::Rgb;
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Debug, Clone, Serialize)]
pub struct Report {
    pub version: u32,
    pub scene: String,
    pub size: [u32; 2],
    pub advice: String,
    pub advice_parts: Vec<Advice>,
    pub goal: Goal,
    pub noise: Noise,
    pub machine: Machine,
    pub budget: Budget,
    pub reference: BTreeMap<&'static str, Reference>,
    pub rows: Vec<Row>,
    pub skipped: Vec<Skipped>,
    pub effects: Vec<Effect>,
    pub objects: Vec<Object>,
    /// The parts of the picture where errors are largest, drawn with the default and with better settings.
    #[serde(skip)]
    pub pictures: Vec<Pictures>,
    /// Time and error over the picture.
    #[serde(skip)]
    pub maps: Option<Maps>,
    /// The picture, as plain `zpg render` draws it.
    #[serde(skip)]
    pub picture: Option<Raster>,
    /// Whether the run was stopped before it was done.
    pub stopped: bool,
}

#[derive(Debug, Clone, Serialize)]
pub struct Advice {
    pub what: &'static str,
    pub text: String,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub struct Goal {
    /// The error that is wanted: root mean square in steps of 1/255.
    pub steps: f64,
    /// The share by which the goal may be missed.
    pub tolerance: f64,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub struct Noise {
    /// Times that differ by a smaller share are not ranked.
    pub relative: f64,
    /// The number of pairs of equal computations that the noise was measured on.
    pub pairs: usize,
    pub estimator: &'static str,
}

#[derive(Debug, Clone, Serialize)]
pub struct Machine {
    pub cpu: String,
    pub cores: usize,
    /// The number of threads that times were taken on.
    pub threads: usize,
    /// The wall time of the timed runs as a multiple of their CPU time; `null` without timed runs.
    pub wall_over_cpu: Option<f64>,
    /// The machine's load before and after the run, where the system tells it.
    pub load: Vec<f64>,
    pub build: &'static str,
    pub version: &'static str,
}

#[derive(Debug, Clone, Serialize)]
pub struct Budget {
    pub asked_seconds: f64,
    /// The CPU time of the timed runs that the pilot predicts.
    pub predicted_seconds: f64,
    /// CPU seconds that the timed runs took.
    pub timed_seconds: f64,
    pub spent_seconds: f64,
    /// Share of the picture's pixels that errors are measured on.
    pub pixels_share: f64,
    /// The side of a tile; `null` where the whole picture was measured.
    pub tile: Option<u32>,
    /// The parts that were left out to keep the budget.
    pub cut: Vec<Complaint>,
}

#[derive(Debug, Clone, Serialize, Default)]
pub struct Reference {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub precision: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub samples: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cutoff: Option<f64>,
    pub margin: Margin,
    /// The outcome of the check by the independent tracer.
    #[serde(flatten)]
    pub checked: Option<Checked>,
}

/// A bound on the error of the reference itself, and how it was found.
#[derive(Debug, Clone, Serialize, Default)]
pub struct Margin {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rmse: Option<f64>,
    pub how: Complaint,
}

#[derive(Debug, Clone, Serialize, Default)]
pub struct Checked {
    pub pixels: usize,
    pub rays: u64,
    pub wrong: usize,
    /// The number of pixels that differ only since the rays of the camera are rounded to doubles.
    pub camera_rounding: usize,
    /// The largest difference of a channel in linear light, over all other pixels.
    pub largest: f64,
    /// Column and row of the first few wrong pixels.
    pub wrong_pixels: Vec<[u32; 2]>,
    /// The reason why nothing was checked.
    pub not_checked: Option<Complaint>,
}

#[derive(Debug, Clone, Serialize)]
pub struct Row {
    pub kind: &'static str,
    pub axis: &'static str,
    pub setting: String,
    /// Wall time for the pixels that were timed.
    pub seconds: Option<Spread>,
    pub cpu_seconds: Option<Spread>,
    /// CPU time as a multiple of the default's on the same pixels.
    pub times_default: Option<f64>,
    pub pixels_timed: usize,
    /// Rays a second, in the run of the least wall time.
    pub rays_per_second: Option<f64>,
    /// The number of rays for the pixels that errors were measured on.
    pub rays: u64,
    pub uncertain: u64,
    pub samples_mean: f64,
    pub error: Option<RowError>,
    pub default: bool,
    pub pareto: bool,
    /// The name of another row with the same computation.
    pub same_as: Option<String>,
    /// Whether the error is smaller than the error that the reference itself may have.
    pub below_reference: bool,
    #[serde(skip)]
    pub of: Option<(Kind, Axis)>,
    /// The settings as an option of `zpg render`.
    #[serde(skip)]
    pub option: String,
}

#[derive(Debug, Clone, Serialize)]
pub struct RowError {
    pub steps: f64,
    pub steps_interval: [f64; 2],
    pub rmse: f64,
    pub relmse: f64,
    pub max: f64,
    pub max_steps: f64,
    pub flip: f64,
    pub pixels: usize,
    pub pixels_off: usize,
    pub pixels_differ: usize,
    /// The number of pixels in which another object is seen first; only for rows of numbers.
    pub wrong_object: Option<usize>,
    /// The median error in the distance of the object seen first, in units of the last place of the numbers.
    pub median_ulp: Option<f64>,
    /// The largest error in the distance, in the same units.
    pub max_ulp: Option<f64>,
}

/// The largest difference in linear light of pictures that count as the same: far below the rounding of a film in
/// single precision.
const SAME_PICTURE_DIFFERENCE: f64 = 1e-9;

impl RowError {
    /// Whether the picture is the same as the reference's.
    pub fn is_same(&self) -> bool {
        self.pixels_differ == 0 || self.max <= SAME_PICTURE_DIFFERENCE
    }
}

impl From<Measured> for RowError {
    fn from(m: Measured) -> RowError {
        RowError {
            steps: m.steps,
            steps_interval: m.interval,
            rmse: m.rmse,
            relmse: m.relmse,
            max: m.max,
            max_steps: m.max_steps,
            flip: m.flip,
            pixels: m.pixels,
            pixels_off: m.pixels_off,
            pixels_differ: m.pixels_differ,
            wrong_object: None,
            median_ulp: None,
            max_ulp: None,
        }
    }
}

#[derive(Debug, Clone, Serialize)]
pub struct Skipped {
    pub axis: &'static str,
    pub why: Complaint,
}

#[derive(Debug, Clone, Serialize)]
pub struct Effect {
    pub name: &'static str,
    pub cpu_seconds: Option<Spread>,
    /// The share of the default's time that is saved when this effect alone is taken out.
    pub saved: Option<f64>,
    /// Whether the saved share is negative or no more than the noise of the times.
    pub within_noise: bool,
    pub rays_saved: i64,
    pub error: RowError,
}

#[derive(Debug, Clone, Serialize)]
pub struct Object {
    /// The object's ID; 0 for the background.
    pub id: u32,
    pub share_of_pixels: f64,
    pub share_of_time: f64,
    pub share_of_error: f64,
    pub microseconds_per_pixel: f64,
    /// The root mean square error of the default in the object's pixels, in steps, against the reference of edges.
    pub steps: f64,
}

/// A picture of linear RGB, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<Rgb>,
}

/// A part of the picture, drawn with two settings; each picture has the name of its settings.
#[derive(Debug, Clone)]
pub struct Pictures {
    pub kind: Kind,
    pub default: (String, Raster),
    pub better: (String, Raster),
}

/// Time and error over the picture: for each pixel, or for each block that tiles stand for.
#[derive(Debug, Clone)]
pub struct Maps {
    pub width: u32,
    pub height: u32,
    /// Microseconds a pixel; NaN where nothing was measured.
    pub time: Vec<f64>,
    /// Root mean square error in steps; NaN where nothing was measured.
    pub error: Vec<f64>,
}

impl Row {
    /// The error in steps; infinite if it was not measured.
    pub fn steps(&self) -> f64 {
        self.error.as_ref().map_or(f64::INFINITY, |e| e.steps)
    }

    pub fn off(&self) -> usize {
        self.error.as_ref().map_or(usize::MAX, |e| e.pixels_off)
    }

    pub fn kind(&self) -> Option<Kind> {
        self.of.map(|of| of.0)
    }

    pub fn is_on(&self, axis: Axis) -> bool {
        self.of.is_some_and(|of| of.1 == axis)
    }

    /// The axis and the setting, as `depth 16`.
    pub fn name(&self) -> String {
        format!("{} {}", self.axis, self.setting)
    }
}

/// The ratio of wall time to CPU time of the timed runs above which other programs had the processor.
const BUSY: f64 = 4.0 / 3.0;

impl Report {
    /// The ratio of wall time to CPU time of the timed runs, if the machine was too busy for its times to be trusted;
    /// `None` otherwise.
    pub fn too_busy(&self) -> Option<f64> {
        self.machine
            .wall_over_cpu
            .filter(|&b| !(1.0 / BUSY..=BUSY).contains(&b))
    }

    /// The check by the independent tracer, if it found other pixels than the reference has.
    pub fn wrong_reference(&self) -> Option<&Checked> {
        let checked = self.reference.get(Kind::Numbers.name())?.checked.as_ref();
        checked.filter(|c| c.wrong > 0)
    }

    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |r| r.kind() == Some(kind))
    }

    /// The row of a kind with the settings of plain `zpg render`.
    pub fn default_of(&self, kind: Kind) -> Option<&Row> {
        self.of_kind(kind).find(|r| r.default && r.error.is_some())
    }

    /// Bound on the error of a kind's reference, in steps.
    pub fn margin(&self, kind: Kind) -> f64 {
        let reference = self.reference.get(kind.name());
        reference.and_then(|r| r.margin.steps).unwrap_or(0.0)
    }
}

/// Marks the rows on the Pareto front of their kind. A row is off the front only if another row is faster by more than
/// the noise and at least as accurate, or as fast within the noise and more accurate by more than the margin.
pub fn mark_front(report: &mut Report) {
    let noise = report.noise.relative;
    let front: Vec<bool> = (report.rows.iter())
        .map(|r| {
            let (Some(time), Some(kind)) = (r.times_default, r.kind()) else {
                return false;
            };
            let margin = report.margin(kind);
            let better = |o: &Row| {
                let Some(other) = o.times_default else {
                    return false;
                };
                let faster = other < time / (1.0 + noise) && o.steps() <= r.steps();
                let as_fast = other <= time * (1.0 + noise);
                faster
                    || (as_fast && o.steps() < r.steps() - margin && o.steps() < r.steps() * 0.98)
            };
            r.error.is_some() && r.same_as.is_none() && !report.of_kind(kind).any(better)
        })
        .collect();
    for (row, front) in report.rows.iter_mut().zip(front) {
        row.pareto = front;
    }
}
