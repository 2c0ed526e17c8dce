//! How long each rung takes, in shuffled rounds.

use super::{Entry, FEWEST_PIXELS, LEAST_PIXELS, LEAST_SECONDS, OBJECTS, PICTURES, Run, TIMES};
use crate::diagnostics::{Complaint, Error};
use crate::study::accuracy::rungs::Settings;
use crate::study::accuracy::stage::Timed;
use crate::study::accuracy::tiles::shuffle;
use std::time::Instant;

impl Run<'_> {
    /// Runs in shuffled order on one thread.
    pub(super) fn times(&mut self) -> Result<(), Error> {
        let default = Settings::default();
        self.calibrate()?;
        // What the steps before have not used is theirs, too.
        let behind = OBJECTS + PICTURES;
        let own = self.seconds(TIMES);
        let seconds = self.left(behind).clamp(own / 2.0, 1.5 * own);
        let most = self.options.runs.unwrap_or(5);
        let mut runs = most;
        // What is to be timed: rungs that are one computation once, the default four times.
        let mut entries: Vec<Entry> = Vec::new();
        for i in 0..self.rungs.len() {
            let known = &self.known[i];
            let is_timed = !known.dropped && known.same_as.is_none() && known.measured.is_some();
            if is_timed && !self.rungs[i].is_default() {
                entries.push(Entry::Rung(i));
            }
        }
        entries.extend((0..self.effects.len()).map(Entry::Effect));
        const REPEATS: usize = 4;
        entries.extend((0..REPEATS).map(Entry::Default));
        self.repeats = vec![Vec::new(); REPEATS];
        let plan = |run: &Self, entries: &[Entry], runs: usize| -> (Vec<usize>, f64) {
            let each = seconds / (runs * entries.len()) as f64;
            let mut sum = 0.0;
            let most = run.tiles.len();
            let tiles: Vec<usize> = (entries.iter())
                .map(|e| {
                    let cost = run.entry_cost(e);
                    let least = LEAST_PIXELS
                        .max(LEAST_SECONDS / cost.max(1e-12))
                        .min(LEAST_PIXELS * 4.0);
                    // Dear rungs make do with fewer pixels.
                    let affordable = (1.25 * each / cost.max(1e-12)).max(FEWEST_PIXELS);
                    let least = least.min(affordable);
                    let tiles = run.tiles_for(each, cost, least).min(most);
                    sum += run.pixels(tiles) as f64 * cost * runs as f64;
                    tiles
                })
                .collect();
            (tiles, sum)
        };
        let (mut tiles, mut predicted) = plan(self, &entries, runs);
        if predicted > 1.1 * seconds {
            let dropped: Vec<usize> = (entries.iter())
                .filter_map(|e| match e {
                    Entry::Rung(i) if self.rungs[*i].inner => Some(*i),
                    _ => None,
                })
                .collect();
            for i in dropped {
                let name = format!("{} {}", self.rungs[i].axis.name(), self.rungs[i].label);
                self.known[i].dropped = true;
                self.cut.push(Complaint::quoted(name));
                entries.retain(|e| *e != Entry::Rung(i));
            }
            (tiles, predicted) = plan(self, &entries, runs);
        }
        if predicted > 1.1 * seconds && self.options.runs.is_none() {
            runs = 3;
            (tiles, predicted) = plan(self, &entries, runs);
        }
        self.predicted = predicted;
        let mut order: Vec<usize> = (0..entries.len()).collect();
        let (mut done, mut longest) = (0, 0.0f64);
        'all: for round in 0..most {
            // Where runs were left out, and there is time after all, they are done.
            if round >= runs && self.left(behind) < 1.1 * longest {
                self.cut.push(Complaint::new("accuracy-cut-runs"));
                break;
            }
            if round >= runs {
                self.predicted += predicted / runs as f64;
            }
            let start = Instant::now();
            shuffle(&mut order, round as u64);
            for &e in &order {
                if self.is_stopped() {
                    break 'all;
                }
                let settings = match entries[e] {
                    Entry::Rung(i) => self.rungs[i].settings,
                    Entry::Effect(i) => self.effects[i].1,
                    Entry::Default(_) => default,
                };
                let list = self.tiles[..tiles[e]].to_vec();
                let mut timed = self.stage.time(&settings, &list)?;
                self.timed += timed.cpu;
                // The pixels are known.
                timed.drawn.colours = Vec::new();
                match entries[e] {
                    Entry::Rung(i) => {
                        self.known[i].timed_tiles = tiles[e];
                        self.known[i].times.push(timed);
                    }
                    Entry::Effect(i) => {
                        self.effects[i].2.timed_tiles = tiles[e];
                        self.effects[i].2.times.push(timed);
                    }
                    Entry::Default(i) => self.repeats[i].push(timed),
                }
                done += 1;
                let behind = done as f64 / (runs * entries.len()) as f64;
                (self.progress)("accuracy-step-times", 0.55 + 0.4 * behind.min(1.0));
            }
            longest = longest.max(start.elapsed().as_secs_f64());
        }
        Ok(())
    }

    /// The least CPU time of the default on the first tiles.
    pub(super) fn default_time(&self, tiles: usize, repeats: &[Vec<Timed>]) -> Option<f64> {
        let sum = |t: &Timed| (t.tiles.len() >= tiles).then(|| t.tiles[..tiles].iter().sum());
        // As many runs as any other has: the first entry's. Where that has too few tiles, scaled.
        let least = repeats
            .first()?
            .iter()
            .filter_map(sum)
            .fold(f64::INFINITY, f64::min);
        if least.is_finite() {
            return Some(least);
        }
        let all = repeats.first()?.first()?.tiles.len();
        let least = repeats
            .first()?
            .iter()
            .map(|t| t.cpu)
            .fold(f64::INFINITY, f64::min);
        let scale = self.pixels(tiles) as f64 / self.pixels(all).max(1) as f64;
        least.is_finite().then_some(least * scale)
    }
}
