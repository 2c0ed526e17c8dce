//! The results, as they stand in `accuracy.json`.

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
    /// Pictures of the places where errors are largest, with and without the errors.
    #[serde(skip)]
    pub pictures: Vec<Pictures>,
    /// Time and error over the picture.
    #[serde(skip)]
    pub maps: Option<Maps>,
    /// The picture, as plain `zpg render` draws it.
    #[serde(skip)]
    pub picture: Option<Raster>,
    /// Whether the run was stopped before all was done.
    pub stopped: bool,
}

#[derive(Debug, Clone, Serialize)]
pub struct Advice {
    pub what: &'static str,
    pub text: String,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub struct Goal {
    /// Root mean square in steps of 1/255.
    pub steps: f64,
    /// The share by which it may be missed.
    pub tolerance: f64,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub struct Noise {
    /// Times that differ by a smaller share are not ranked.
    pub relative: f64,
    /// Pairs of equal computations that it was measured on.
    pub pairs: usize,
    pub estimator: &'static str,
}

#[derive(Debug, Clone, Serialize)]
pub struct Machine {
    pub cpu: String,
    pub cores: usize,
    /// Threads that times were taken on.
    pub threads: usize,
    /// The wall time of the timed runs as a multiple of their CPU time; `null` of no runs.
    pub wall_over_cpu: Option<f64>,
    /// Before and after, where the system tells.
    pub load: Vec<f64>,
    pub build: &'static str,
    pub version: &'static str,
}

#[derive(Debug, Clone, Serialize)]
pub struct Budget {
    pub asked_seconds: f64,
    /// CPU time of the timed runs, by the pilot.
    pub predicted_seconds: f64,
    /// Seconds that the timed runs took.
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
    /// Pixels that the independent tracer was asked about, its rays, and where it came to another answer.
    #[serde(flatten)]
    pub checked: Option<Checked>,
}

/// How far the reference itself may be off.
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
    /// Pixels that differ only since the rays of the camera are rounded to doubles.
    pub camera_rounding: usize,
    /// The largest difference of a channel, linear, in all others.
    pub largest: f64,
    /// Where: the first few wrong pixels.
    pub wrong_pixels: Vec<[u32; 2]>,
    /// The reason why nothing was checked.
    pub not_checked: Option<Complaint>,
}

#[derive(Debug, Clone, Serialize)]
pub struct Row {
    pub kind: &'static str,
    pub axis: &'static str,
    pub setting: String,
    /// Wall time of the pixels that were timed.
    pub seconds: Option<Spread>,
    pub cpu_seconds: Option<Spread>,
    /// CPU time over that of the default on the same pixels.
    pub times_default: Option<f64>,
    pub pixels_timed: usize,
    /// Rays a second, by the least wall time.
    pub rays_per_second: Option<f64>,
    /// Rays of the pixels that errors were measured on.
    pub rays: u64,
    pub uncertain: u64,
    pub samples_mean: f64,
    pub error: Option<RowError>,
    pub default: bool,
    pub pareto: bool,
    /// The row whose computation this is, too.
    pub same_as: Option<String>,
    /// Whether the error is smaller than what the reference itself may be off.
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
    /// Pixels in which another object is seen first, numbers alone.
    pub wrong_object: Option<usize>,
    /// Distances of what is seen first, in units of the last place of the numbers.
    pub median_ulp: Option<f64>,
    pub max_ulp: Option<f64>,
}

/// Largest linear difference of pictures that are the same: far below what a film of single precision rounds.
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
    /// Share of the default's time that goes when this effect alone is taken out.
    pub saved: Option<f64>,
    /// Whether the share is no more than the noise of the times, or less than nothing.
    pub within_noise: bool,
    pub rays_saved: i64,
    pub error: RowError,
}

#[derive(Debug, Clone, Serialize)]
pub struct Object {
    /// 0: the background.
    pub id: u32,
    pub share_of_pixels: f64,
    pub share_of_time: f64,
    pub share_of_error: f64,
    pub microseconds_per_pixel: f64,
    /// Root mean square of the edges' error in its pixels, at the default.
    pub steps: f64,
}

/// A picture of linear RGB, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<Rgb>,
}

/// A part of the picture by two settings.
#[derive(Debug, Clone)]
pub struct Pictures {
    pub kind: Kind,
    pub default: (String, Raster),
    pub better: (String, Raster),
}

/// Values over the picture: of each pixel, or of each block that tiles stand for.
#[derive(Debug, Clone)]
pub struct Maps {
    pub width: u32,
    pub height: u32,
    /// Microseconds a pixel; NaN where nothing was measured.
    pub time: Vec<f64>,
    /// Steps.
    pub error: Vec<f64>,
}

impl Row {
    /// Steps of the error; infinite where it was not measured.
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

    /// `depth 16`.
    pub fn name(&self) -> String {
        format!("{} {}", self.axis, self.setting)
    }
}

/// Where the timed runs take longer than their CPU time by more than this factor, other programs had the processor.
const BUSY: f64 = 4.0 / 3.0;

impl Report {
    /// The wall time of the timed runs over their CPU time, where the machine was too busy for its times to be trusted.
    pub fn too_busy(&self) -> Option<f64> {
        self.machine
            .wall_over_cpu
            .filter(|&b| !(1.0 / BUSY..=BUSY).contains(&b))
    }

    /// The check of the independent tracer where it comes to other pixels than the reference.
    pub fn wrong_reference(&self) -> Option<&Checked> {
        let checked = self.reference.get(Kind::Numbers.name())?.checked.as_ref();
        checked.filter(|c| c.wrong > 0)
    }

    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |r| r.kind() == Some(kind))
    }

    /// The row of a kind that plain `zpg render` is.
    pub fn default_of(&self, kind: Kind) -> Option<&Row> {
        self.of_kind(kind).find(|r| r.default && r.error.is_some())
    }

    /// Bound on the error of a kind's reference, in steps.
    pub fn margin(&self, kind: Kind) -> f64 {
        let reference = self.reference.get(kind.name());
        reference.and_then(|r| r.margin.steps).unwrap_or(0.0)
    }
}

/// Marks the rows that are on the front of their kind: a row is off it only if another is faster by more
/// than the noise and at least as accurate, or as fast within the noise and more accurate by more than
/// the margin.
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
