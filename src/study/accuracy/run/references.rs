//! The references of the errors. Each kind of error has a reference that is more accurate than every configuration on
//! its axes.

use super::{
    EDGES, ERRORS, FEWEST_PIXELS, LEAST_PIXELS, LIGHT, NUMBERS, OBJECTS, PICTURES, Run, TIMES,
};
use crate::diagnostics::{Complaint, Error};
use crate::scene::Rgb;
use crate::study::accuracy::check;
use crate::study::accuracy::configurations::{Axis, Kernel, Kind, Settings};
use crate::study::accuracy::measure::compare;
use crate::study::accuracy::report::{Checked, Margin, Reference};
use crate::study::accuracy::runner::Timed;
use crate::study::accuracy::sample_tiles::TILE;
use crate::trace::Numbers;
use std::ops::Range;
use std::time::Instant;

/// The share of the budget that is kept for the steps after the references, at the least.
const SHARE_AFTER_REFERENCES: f64 = ERRORS / 2.0 + TIMES / 2.0 + OBJECTS + PICTURES;

impl Run<'_> {
    /// Draws the reference of numbers, in double-double, and has the independent tracer check it.
    pub(super) fn reference_numbers(&mut self) -> Result<(), Error> {
        if !self
            .configurations
            .iter()
            .any(|r| r.axis.kind() == Kind::Numbers)
        {
            return Ok(());
        }
        let settings = Settings {
            kernel: Kernel::Ours(Numbers::Dd),
            ..Settings::default()
        };
        let cost = match self.configurations.iter().any(|r| r.settings == settings) {
            true => self.cost(&settings),
            false => 10.0 * self.cost(&Settings::default()),
        };
        let behind = LIGHT + EDGES + SHARE_AFTER_REFERENCES;
        let seconds = self.on_all(self.allotted(NUMBERS, behind + NUMBERS));
        let tiles = self.tiles_for(seconds, cost, LEAST_PIXELS);
        let drawn = self.draw(&settings, tiles)?;
        self.exact = drawn.colours;
        let mut reference = Reference {
            precision: Some("dd"),
            margin: Margin {
                rmse: None,
                steps: None,
                how: Complaint::new("accuracy-how-naive"),
            },
            ..Reference::default()
        };
        let seen = self
            .runner
            .seen(&Settings::default(), &self.tiles[..tiles])?;
        let seconds = self.allotted(NUMBERS, behind);
        let order = check::order(&self.tiles[..tiles], &seen);
        let checked = check::check(
            &self.runner,
            self.images,
            &settings,
            &order,
            &self.exact,
            [seconds, 3.0 * seconds],
        )?;
        reference.checked = Some(match checked {
            Ok(checked) => {
                reference.margin.rmse = Some(checked.largest);
                checked
            }
            Err(why) => Checked {
                not_checked: Some(Complaint::new(why)),
                ..Checked::default()
            },
        });
        self.reference.insert(Kind::Numbers.name(), reference);
        Ok(())
    }

    /// Draws the reference of light, deeper and with a lower cutoff than any configuration.
    pub(super) fn reference_light(&mut self) -> Result<(), Error> {
        if !self
            .configurations
            .iter()
            .any(|r| r.axis.kind() == Kind::Light)
        {
            return Ok(());
        }
        let few = 4.min(self.tiles.len());
        let at = |depth, cutoff| Settings {
            depth,
            cutoff,
            ..Settings::default()
        };
        // Deeper settings are tried while three times the cost of the last ones still fits into the time.
        let mut best = at(64, 1e-6);
        let pilot = |run: &mut Self, s: &Settings| -> Result<Timed, Error> {
            let tiles = run.tiles[..few].to_vec();
            run.time(s, &tiles)
        };
        let pixels = self.pixels(few) as f64;
        let mut cost = pilot(self, &best)?.cpu / pixels;
        let seconds = self.on_all(self.allotted(LIGHT, EDGES + SHARE_AFTER_REFERENCES));
        let allowed = seconds / LEAST_PIXELS;
        for (depth, cutoff) in [(64, 1e-7), (128, 1e-8)] {
            if cost * 3.0 > allowed || self.is_stopped() {
                break;
            }
            best = at(depth, cutoff);
            cost = pilot(self, &best)?.cpu / pixels;
        }
        if best.cutoff >= 1e-6 {
            self.drop_rungs(|r| r.axis == Axis::Cutoff && r.settings.cutoff <= 1e-6);
        }
        let tiles = self.tiles_for(seconds, cost, LEAST_PIXELS);
        let drawn = self.draw(&best, tiles)?;
        // The margin is the difference from half the depth with ten times the cutoff.
        let less = at(best.depth / 2, best.cutoff * 10.0);
        let sample = tiles.min(self.tiles.len().div_ceil(4)).max(1);
        let other = self.draw(&less, sample)?;
        let margin = compare(&other.colours, &drawn.colours, &self.sizes(sample), true);
        self.light = drawn.colours;
        let reference = Reference {
            precision: Some("f64"),
            samples: Some(1),
            depth: Some(best.depth),
            cutoff: Some(best.cutoff),
            margin: Margin {
                steps: Some(margin.steps),
                rmse: Some(margin.rmse),
                how: Complaint::new("accuracy-how-light"),
            },
            ..Reference::default()
        };
        self.reference.insert(Kind::Light.name(), reference);
        Ok(())
    }

    /// Draws the reference of edges with many samples, never adaptive. Their number is doubled until half of them come
    /// near enough to all, or the time is up.
    pub(super) fn reference_edges(&mut self) -> Result<(), Error> {
        if !self
            .configurations
            .iter()
            .any(|r| r.axis.kind() == Kind::Edges)
        {
            return Ok(());
        }
        let base = Settings::default();
        let each = self.cost(&base);
        let seconds = self.allotted(EDGES, SHARE_AFTER_REFERENCES);
        let allowed = self.on_all(seconds) / each;
        let start = Instant::now();
        // Enough pixels are more important than many samples.
        let mut samples = 4096u32;
        let pixels = |tiles: usize| tiles as f64 * f64::from(TILE * TILE);
        while samples > 64 && f64::from(samples) * LEAST_PIXELS > allowed {
            samples /= 2;
        }
        samples = samples.min(if pixels(self.tiles.len()) > 4.0 * LEAST_PIXELS {
            1024
        } else {
            4096
        });
        // If the time is not enough for 128 samples of that many pixels, fewer pixels are drawn.
        let least = LEAST_PIXELS.min((allowed / 128.0).max(FEWEST_PIXELS));
        let tiles = self.tiles_for(allowed, f64::from(samples), least);
        let sizes = self.sizes(tiles);
        let mut done = 64;
        let sums_of = |run: &mut Self, samples: Range<u32>| {
            run.together(tiles, |runner, tiles| runner.sums(&base, tiles, samples))
        };
        let mut sums = sums_of(self, 0..done)?;
        let mean = |sums: &[Rgb], n: u32| -> Vec<Rgb> {
            sums.iter().map(|s| s.map(|c| c / f64::from(n))).collect()
        };
        let mut margin;
        loop {
            let half = mean(&sums, done);
            let more = sums_of(self, done..2 * done)?;
            for (sum, more) in sums.iter_mut().zip(more) {
                *sum = [0, 1, 2].map(|c| sum[c] + more[c]);
            }
            done *= 2;
            self.edges = mean(&sums, done);
            margin = compare(&half, &self.edges, &sizes, true).steps;
            let behind = 0.3 + 0.15 * f64::from(done) / f64::from(samples);
            (self.progress)("accuracy-step-edges", behind.min(0.45));
            // The next doubling takes as long as all samples before it.
            let is_good = margin < self.options.goal / 4.0 && done >= 512;
            let is_late = 2.0 * start.elapsed().as_secs_f64() > 1.5 * seconds;
            if is_good || done >= samples || is_late || self.is_stopped() {
                break;
            }
        }
        self.drop_rungs(|r| r.axis == Axis::Samples && r.settings.samples > done / 2);
        let reference = Reference {
            precision: Some("f64"),
            samples: Some(done),
            margin: Margin {
                steps: Some(margin),
                rmse: None,
                how: Complaint::new("accuracy-how-edges"),
            },
            ..Reference::default()
        };
        self.reference.insert(Kind::Edges.name(), reference);
        Ok(())
    }

    pub(super) fn sizes(&self, tiles: usize) -> Vec<[u32; 2]> {
        self.tiles[..tiles]
            .iter()
            .map(|t| [t.width, t.height])
            .collect()
    }
}
