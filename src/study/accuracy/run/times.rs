//! Times each configuration, in rounds of random order.

use super::sample::Sample;
use super::{FEWEST_PIXELS, LEAST_PIXELS, LEAST_SECONDS, OBJECTS, PICTURES, Run, TIMES, TimedItem};
use crate::diagnostics::{Complaint, Error};
use crate::study::accuracy::configurations::Settings;
use crate::study::accuracy::runner::Timed;
use crate::study::accuracy::sample_tiles::{Tile, shuffle};
use std::time::Instant;

impl Run<'_> {
    /// Times all configurations and effects on one thread, in rounds of random order.
    pub(super) fn times(&mut self) -> Result<(), Error> {
        let default = Settings::default();
        self.calibrate()?;
        // Time that earlier steps have not used may be used here.
        let behind = OBJECTS + PICTURES;
        let own = self.seconds(TIMES);
        let seconds = self.left(behind).clamp(own / 4.0, 1.5 * own);
        let most = self.options.runs.unwrap_or(5);
        let mut runs = most;
        // Configurations with the same computation are timed once, the default four times.
        let mut entries: Vec<TimedItem> = Vec::new();
        for i in 0..self.configurations.len() {
            let known = &self.known[i];
            let is_timed = !known.dropped && known.same_as.is_none() && known.measured.is_some();
            if is_timed && !self.configurations[i].is_default() {
                entries.push(TimedItem::Configuration(i));
            }
        }
        entries.extend((0..self.effects.len()).map(TimedItem::Effect));
        const REPEATS: usize = 4;
        entries.extend((0..REPEATS).map(TimedItem::Default));
        self.repeats = vec![Vec::new(); REPEATS];
        let plan = |run: &Self, entries: &[TimedItem], runs: usize| -> (Vec<Sample>, f64) {
            let each = run.on_one(seconds) / (runs * entries.len()) as f64;
            let frame = run.default_tiles(each);
            let samples: Vec<Sample> = (entries.iter())
                .map(|e| run.sample_for(e, each, frame))
                .collect();
            let cost = |(e, sample): (&TimedItem, &Sample)| run.predicted_cost(e, sample);
            let sum: f64 = entries.iter().zip(&samples).map(cost).sum();
            (samples, sum * runs as f64)
        };
        let (mut samples, mut predicted) = plan(self, &entries, runs);
        let allowed = 1.1 * self.on_one(seconds);
        if predicted > allowed {
            let dropped: Vec<usize> = (entries.iter())
                .filter_map(|e| match e {
                    TimedItem::Configuration(i) if self.configurations[*i].inner => Some(*i),
                    _ => None,
                })
                .collect();
            for i in dropped {
                self.drop_rung(i);
                entries.retain(|e| *e != TimedItem::Configuration(i));
            }
            (samples, predicted) = plan(self, &entries, runs);
        }
        if predicted > allowed && self.options.runs.is_none() {
            runs = 3;
            (samples, predicted) = plan(self, &entries, runs);
        }
        self.predicted = predicted;
        if let Some(last) = entries.len().checked_sub(REPEATS) {
            self.frame = samples[last].clone();
        }
        let lists: Vec<Vec<Tile>> = samples.iter().map(|s| s.of(&self.tiles)).collect();
        let mut order: Vec<usize> = (0..entries.len()).collect();
        let (mut done, mut longest) = (0, 0.0f64);
        let start_of_all = Instant::now();
        'all: for round in 0..most {
            // Rounds beyond the planned ones are done if time is left after all.
            if round >= runs && self.left(behind) < 1.1 * longest {
                self.cut.push(Complaint::new("accuracy-cut-runs"));
                break;
            }
            if round >= runs {
                self.predicted += predicted / runs as f64;
            }
            let start = Instant::now();
            shuffle(&mut order, round as u64);
            if round == 0 {
                // The default comes first: all other times are multiples of its time.
                order.sort_by_key(|&e| !matches!(entries[e], TimedItem::Default(_)));
            }
            for &e in &order {
                if self.is_stopped() {
                    break 'all;
                }
                // The first round may use the time of later steps, too.
                let is_late = match round {
                    0 => self.left(0.0) < 0.0,
                    _ => start_of_all.elapsed().as_secs_f64() > 1.1 * seconds,
                };
                if is_late && round > 0 {
                    self.cut.push(Complaint::new("accuracy-cut-runs"));
                    break 'all;
                }
                let is_default = matches!(entries[e], TimedItem::Default(_));
                let cost = self.predicted_cost(&entries[e], &samples[e]);
                if is_late && !is_default && !self.is_cheap(cost) {
                    continue;
                }
                let settings = match entries[e] {
                    TimedItem::Configuration(i) => self.configurations[i].settings,
                    TimedItem::Effect(i) => self.effects[i].1,
                    TimedItem::Default(_) => default,
                };
                let mut timed = self.time(&settings, &lists[e])?;
                self.timed += timed.cpu;
                // The colours are known from the step that measures errors.
                timed.drawn.colours = Vec::new();
                match entries[e] {
                    TimedItem::Configuration(i) => {
                        self.known[i].sample = samples[e].clone();
                        self.known[i].times.push(timed);
                    }
                    TimedItem::Effect(i) => {
                        self.effects[i].2.sample = samples[e].clone();
                        self.effects[i].2.times.push(timed);
                    }
                    TimedItem::Default(i) => self.repeats[i].push(timed),
                }
                done += 1;
                let behind = done as f64 / (runs * entries.len()) as f64;
                (self.progress)("accuracy-step-times", 0.55 + 0.4 * behind.min(1.0));
            }
            longest = longest.max(start.elapsed().as_secs_f64());
        }
        Ok(())
    }

    /// The number of tiles that the default is timed on in a run of `seconds` CPU seconds.
    fn default_tiles(&self, seconds: f64) -> usize {
        let cost = self.entry_cost(&TimedItem::Default(0));
        self.tiles_for(seconds, cost, least_pixels(cost, seconds))
    }

    /// The sample that an item is timed on in a run of `seconds` CPU seconds: the `frame` tiles of the default, or a
    /// part of them.
    fn sample_for(&self, entry: &TimedItem, seconds: f64, frame: usize) -> Sample {
        let cost = self.entry_cost(entry);
        let tiles = self.tiles_for(seconds, cost, least_pixels(cost, seconds));
        let known = frame.min(self.weights.len());
        if tiles >= frame || known == 0 || matches!(entry, TimedItem::Default(_)) {
            return Sample::first(frame);
        }
        let weights = &self.weights[..known];
        let few = tiles as f64 / Sample::skew(weights);
        match (few as usize).max(FEWEST_TILES) {
            count if count < known => Sample::by_time(weights, count),
            _ => Sample::first(known),
        }
    }

    /// The CPU seconds that a run of a sample is going to take, by the default's times on its tiles.
    fn predicted_cost(&self, entry: &TimedItem, sample: &Sample) -> f64 {
        let pixels = sample.pixels(&self.tiles) as f64;
        self.entry_cost(entry) * pixels * sample.share_of(&self.weights)
    }

    /// The CPU time of some runs as a multiple of the default's on the same tiles.
    pub(super) fn times_default(
        &self,
        times: &[Timed],
        sample: &Sample,
        repeats: &[Vec<Timed>],
    ) -> Option<f64> {
        // The first list of the default's runs alone is used: it has as many runs as those of other items.
        sample.ratio(times, &self.frame, repeats.first()?)
    }
}

/// The fewest pixels of a run, at `cost` seconds a pixel. `seconds` limits their number.
fn least_pixels(cost: f64, seconds: f64) -> f64 {
    let least = LEAST_PIXELS.max(LEAST_SECONDS / cost.max(1e-12));
    let affordable = (1.25 * seconds / cost.max(1e-12)).max(FEWEST_PIXELS);
    least.min(LEAST_PIXELS * 4.0).min(affordable)
}

/// The smallest number of tiles that stand for the picture.
const FEWEST_TILES: usize = 12;
