//! Makes the report of a run.

use super::sample::{Sample, least};
use super::{GOAL_SLACK, Run, load, rays};
use crate::diagnostics::{Error, Language};
use crate::study::accuracy::advice;
use crate::study::accuracy::report::{
    Budget, Effect, Goal, Machine, Noise, Report, Row, RowError, mark_front,
};
use crate::study::accuracy::runner::Timed;
use crate::study::accuracy::sample_tiles::TILE;
use crate::study::accuracy::timing::{Spread, noise};

impl Run<'_> {
    pub(super) fn report(mut self, name: &str, load_before: Option<f64>) -> Result<Report, Error> {
        let stopped = self.is_stopped();
        let options = self.options;
        let repeats = std::mem::take(&mut self.repeats);
        let mut rows = Vec::new();
        let minima: Vec<f64> = (repeats.iter())
            .filter_map(|r| Some(least(r)?.iter().sum()))
            .collect();
        let busy = busy(self.all_timed(&repeats));
        let mut pairs = Vec::new();
        for (i, a) in minima.iter().enumerate() {
            pairs.extend(minima[i + 1..].iter().map(|b| [*a, *b]));
        }
        let noise = noise(&pairs);
        let seen = self.numbers_seen(stopped)?;
        let mut defaults = 0;
        for i in 0..self.configurations.len() {
            let (configuration, known) = (&self.configurations[i], &self.known[i]);
            let (Some(measured), false) = (&known.measured, known.dropped) else {
                continue;
            };
            let is_default = configuration.is_default();
            let (times, sample): (&[Timed], &Sample) = match (is_default, known.same_as) {
                (true, _) => {
                    let own = repeats.get(defaults % repeats.len().max(1));
                    defaults += 1;
                    (own.map_or(&[][..], |r| &r[..]), &self.frame)
                }
                (false, Some(j)) if self.configurations[j].is_default() => {
                    (repeats.first().map_or(&[][..], |r| &r[..]), &self.frame)
                }
                (false, Some(j)) => (&self.known[j].times, &self.known[j].sample),
                (false, None) => (&known.times, &known.sample),
            };
            let cpu = cpu_of(times);
            let wall = Spread::of(&times.iter().map(|t| t.wall).collect::<Vec<_>>());
            let times_default = match (is_default, cpu) {
                (_, None) => None,
                (true, _) => Some(1.0),
                (false, Some(_)) => self.times_default(times, sample, &repeats),
            };
            let drawn = known.drawn.clone().unwrap_or_default();
            let mut error = RowError::from(measured.clone());
            if let Some((wrong, median, max)) = seen.iter().find(|s| s.0 == i).map(|s| s.1) {
                error.wrong_object = Some(wrong);
                (error.median_ulp, error.max_ulp) = (Some(median), Some(max));
            }
            let kind = configuration.axis.kind();
            let margin = self.reference.get(kind.name()).and_then(|r| r.margin.steps);
            let per_second = times
                .first()
                .zip(wall)
                .map(|(t, wall)| rays(&t.drawn.counts.rays) as f64 / wall.min.max(1e-9));
            rows.push(Row {
                kind: kind.name(),
                axis: configuration.axis.name(),
                setting: configuration.label.clone(),
                seconds: wall,
                cpu_seconds: cpu,
                times_default,
                pixels_timed: sample.pixels(&self.tiles),
                rays_per_second: per_second,
                rays: rays(&drawn.counts.rays),
                uncertain: drawn.counts.uncertain,
                samples_mean: drawn.samples as f64 / measured.pixels.max(1) as f64,
                below_reference: margin.is_some_and(|m| measured.steps < m),
                error: Some(error),
                default: is_default,
                pareto: false,
                same_as: known.same_as.map(|j| {
                    format!(
                        "{} {}",
                        self.configurations[j].axis.name(),
                        self.configurations[j].label
                    )
                }),
                of: Some((kind, configuration.axis)),
                option: configuration.option(),
            });
        }
        let effects = self.effects_found(&repeats, noise);
        let (objects, maps) = match stopped {
            true => (Vec::new(), None),
            false => self.objects()?,
        };
        (self.progress)("accuracy-step-pictures", 0.98);
        let [width, height] = options.size;
        let whole = self.pixels(self.tiles.len()) as f64 / (f64::from(width) * f64::from(height));
        let mut report = Report {
            version: 1,
            scene: name.to_owned(),
            size: options.size,
            advice: String::new(),
            advice_parts: Vec::new(),
            goal: Goal {
                steps: options.goal,
                tolerance: GOAL_SLACK,
            },
            noise: Noise {
                relative: noise,
                pairs: pairs.len(),
                estimator: "least CPU time of each tile, added up",
            },
            machine: Machine {
                cpu: cpu_name(),
                cores: std::thread::available_parallelism().map_or(1, usize::from),
                threads: 1,
                wall_over_cpu: busy,
                load: load_before.into_iter().chain(load()).collect(),
                build: if cfg!(debug_assertions) {
                    "debug"
                } else {
                    "release"
                },
                version: env!("CARGO_PKG_VERSION"),
            },
            budget: Budget {
                asked_seconds: options.budget,
                predicted_seconds: self.predicted,
                timed_seconds: self.timed,
                spent_seconds: 0.0,
                pixels_share: whole,
                tile: (!self.whole).then_some(TILE),
                cut: std::mem::take(&mut self.cut),
            },
            reference: std::mem::take(&mut self.reference),
            rows,
            skipped: std::mem::take(&mut self.skipped),
            effects,
            objects,
            pictures: Vec::new(),
            maps,
            picture: None,
            stopped,
        };
        mark_front(&mut report);
        advice::advise(&mut report, Language::English);
        if !stopped {
            self.pictures(&mut report)?;
        }
        report.budget.spent_seconds = self.start.elapsed().as_secs_f64();
        Ok(report)
    }

    pub(super) fn effects_found(&self, repeats: &[Vec<Timed>], noise: f64) -> Vec<Effect> {
        let base = self.configurations.iter().position(|r| r.is_default());
        let default_rays = base.and_then(|i| {
            let known = &self.known[i];
            Some((
                rays(&known.drawn.as_ref()?.counts.rays),
                self.pixels(known.tiles),
            ))
        });
        (self.effects.iter())
            .filter_map(|(name, _, known)| {
                let measured = known.measured.clone()?;
                let cpu = cpu_of(&known.times);
                let times = self.times_default(&known.times, &known.sample, repeats);
                let saved = times.map(|t| 1.0 - t);
                // The default's rays are scaled to the number of pixels drawn here.
                let own = rays(&known.drawn.as_ref()?.counts.rays) as f64;
                let (all, pixels) = default_rays?;
                let scale = self.pixels(known.tiles) as f64 / pixels.max(1) as f64;
                Some(Effect {
                    name,
                    cpu_seconds: cpu,
                    // Less work cannot take longer, so that a negative saving is noise.
                    within_noise: saved.is_some_and(|s| s <= noise),
                    saved,
                    rays_saved: (all as f64 * scale - own).round() as i64,
                    error: measured.into(),
                })
            })
            .collect()
    }
}

impl Run<'_> {
    /// All runs that were timed.
    fn all_timed<'t>(&'t self, repeats: &'t [Vec<Timed>]) -> impl Iterator<Item = &'t Timed> {
        let effects = self.effects.iter().map(|e| &e.2);
        let others = self.known.iter().chain(effects).flat_map(|k| &k.times);
        repeats.iter().flatten().chain(others)
    }
}

/// The spread of the CPU time of some runs. Its minimum adds up the least time of each tile.
fn cpu_of(times: &[Timed]) -> Option<Spread> {
    let spread = Spread::of(&times.iter().map(|t| t.cpu).collect::<Vec<_>>())?;
    Some(Spread {
        min: least(times)?.iter().sum(),
        ..spread
    })
}

/// The wall time of runs as a multiple of their CPU time.
fn busy<'t>(times: impl Iterator<Item = &'t Timed>) -> Option<f64> {
    let (mut wall, mut cpu) = (0.0, 0.0);
    for timed in times {
        wall += timed.wall;
        cpu += timed.cpu;
    }
    (cpu > 0.0).then(|| wall / cpu)
}

fn cpu_name() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find_map(|l| l.strip_prefix("model name"));
    let name = line.map(|l| l.trim_start_matches([' ', '\t', ':']).to_owned());
    name.unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}
