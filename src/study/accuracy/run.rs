//! From a scene to a report: pilot, references, errors, times.

use super::axes;
use super::check;
use super::facets::{self, Facets};
use super::measure::{Measured, compare, steps};
use super::report::{
    Budget, Checked, Effect, Goal, Machine, Maps, Margin, Noise, Object, Pictures, Raster,
    Reference, Report, Row, RowError, Skipped, mark_front,
};
use super::rungs::{Axis, Kernel, Kind, Rung, Settings, ladder};
use super::stage::{Drawn, Stage, Timed};
use super::tiles::{TILE, Tile, WHOLE, chosen, shuffle};
use super::timing::{Spread, noise};
use crate::diagnostics::{Error, Language};
use crate::scene::{Camera, Rgb, Scene};
use crate::trace::pixels::Seen;
use crate::trace::stats::Rays;
use crate::trace::{Images, Numbers};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// What is asked.
#[derive(Debug, Clone)]
pub struct Options {
    pub size: [u32; 2],
    /// The axes to run.
    pub axes: Vec<Axis>,
    /// Timed runs of each rung; 5 if not said.
    pub runs: Option<usize>,
    /// Seconds that all may take.
    pub budget: f64,
    /// The error that is wanted, in steps.
    pub goal: f64,
    pub language: Language,
    /// Once this is set, what is finished is reported.
    pub stop: Arc<AtomicBool>,
}

/// The share by which the goal may be missed: 1.01 must not cost twice as much as 1.00.
pub const SLACK: f64 = 0.15;

/// Seconds that are spent if nothing is said.
pub const BUDGET: f64 = 120.0;

/// The shortest run that is worth ranking.
const LEAST_SECONDS: f64 = 0.05;
const LEAST_PIXELS: f64 = 2000.0;

/// Who is told how far it is: what is done now, the name of a message, and the share of all that is
/// behind.
pub type Progress<'p> = &'p dyn Fn(&'static str, f64);

/// What is known of a rung's computation.
#[derive(Default)]
struct Known {
    /// Seconds a pixel, on one thread.
    cost: f64,
    /// Seconds a ray, by the pilot.
    per_ray: f64,
    drawn: Option<Drawn>,
    /// How many tiles that are.
    tiles: usize,
    measured: Option<Measured>,
    same_as: Option<usize>,
    dropped: bool,
    times: Vec<Timed>,
    timed_tiles: usize,
}

/// Everything that is known while it runs.
struct Run<'i> {
    options: &'i Options,
    images: &'i Images,
    stage: Stage<'i>,
    tiles: Vec<Tile>,
    whole: bool,
    rungs: Vec<Rung>,
    known: Vec<Known>,
    effects: Vec<(&'static str, Settings, Known)>,
    facets: BTreeMap<Axis, Settings>,
    reference: BTreeMap<&'static str, Reference>,
    skipped: Vec<Skipped>,
    cut: Vec<String>,
    start: Instant,
    progress: Progress<'i>,
    threads: f64,
    /// Linear RGB of references, in the order of the tiles' pixels.
    edges: Vec<Rgb>,
    light: Vec<Rgb>,
    exact: Vec<Rgb>,
    predicted: f64,
    timed: f64,
    repeats: Vec<Vec<Timed>>,
}

/// Studies a scene.
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
    let stage = Stage::new(scene.clone(), images, camera, options.size)?;
    let share = (options.budget / BUDGET).ceil().clamp(1.0, 16.0) as usize;
    let [width, height] = options.size;
    let tiles = chosen(options.size, share);
    let mut run = Run {
        options,
        images,
        stage,
        whole: u64::from(width) * u64::from(height) <= WHOLE || share == 16,
        tiles,
        rungs: Vec::new(),
        known: Vec::new(),
        effects: Vec::new(),
        facets: BTreeMap::new(),
        reference: BTreeMap::new(),
        skipped: Vec::new(),
        cut: Vec::new(),
        start: Instant::now(),
        progress,
        threads: rayon::current_num_threads() as f64,
        edges: Vec::new(),
        light: Vec::new(),
        exact: Vec::new(),
        predicted: 0.0,
        timed: 0.0,
        repeats: Vec::new(),
    };
    run.all()?;
    run.report(name, before)
}

fn load() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/loadavg").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

fn say(language: Language, message: &'static str) -> String {
    language.say(message, &[])
}

impl Run<'_> {
    fn is_stopped(&self) -> bool {
        self.options.stop.load(Ordering::Relaxed)
    }

    fn seconds(&self, share: f64) -> f64 {
        share * self.options.budget
    }

    fn pixels(&self, tiles: usize) -> usize {
        self.tiles[..tiles].iter().map(|t| t.count()).sum()
    }

    /// As many tiles as take so many seconds at so many a pixel, and no fewer than hold so many pixels.
    fn tiles_for(&self, seconds: f64, cost: f64, least: f64) -> usize {
        let pixels = (seconds / cost.max(1e-12)).max(least);
        let tile = f64::from(TILE * TILE);
        ((pixels / tile).ceil() as usize).clamp(1, self.tiles.len())
    }

    fn all(&mut self) -> Result<(), Error> {
        let steps: [(&'static str, f64, fn(&mut Self) -> Result<(), Error>); 7] = [
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

    /// The rungs of the axes that the scene calls for.
    fn plan(&mut self) -> Result<(), Error> {
        let language = self.options.language;
        for axis in Axis::ALL {
            let wanted = self.options.axes.contains(&axis);
            let why = match wanted {
                false => Some("accuracy-skip-unasked"),
                true => axes::skipped(axis, &self.stage),
            };
            let mut rungs = Vec::new();
            let mut why = why;
            if why.is_none() {
                let made = match axis {
                    Axis::Tessellation => facets::meshes(&mut self.stage)?,
                    Axis::Levels => facets::levels(&mut self.stage)?,
                    _ => {
                        rungs = ladder(axis);
                        None
                    }
                };
                if let Some(Facets {
                    rungs: made,
                    reference,
                }) = made
                {
                    rungs = made;
                    self.facets.insert(axis, reference);
                } else if rungs.is_empty() {
                    why = Some("accuracy-skip-mesh");
                }
            }
            if axis == Axis::Precision
                && !rungs.is_empty()
                && let Some(no_plain) = axes::no_plain(&self.stage)
            {
                rungs.retain(|r| matches!(r.settings.kernel, Kernel::Ours(_)));
                self.skipped.push(Skipped {
                    axis: "precision plain",
                    why: say(language, no_plain),
                });
            }
            if let Some(why) = why {
                self.skipped.push(Skipped {
                    axis: axis.name(),
                    why: say(language, why),
                });
            }
            self.rungs.extend(rungs);
        }
        self.known = self.rungs.iter().map(|_| Known::default()).collect();
        for (name, without) in axes::effects(&self.stage.tracer().plan) {
            let settings = Settings {
                without,
                ..Settings::default()
            };
            self.effects.push((name, settings, Known::default()));
        }
        Ok(())
    }

    /// Each rung once on a few tiles.
    fn pilot(&mut self) -> Result<(), Error> {
        let few = (self.tiles.len() / 16).clamp(4.min(self.tiles.len()), 40);
        let mut costs: Vec<(Settings, [f64; 2])> = Vec::new();
        let deadline = self.seconds(0.15);
        let pixels = self.pixels(few) as f64;
        for i in 0..self.rungs.len() + self.effects.len() {
            let settings = match self.rungs.get(i) {
                Some(rung) => rung.settings,
                None => self.effects[i - self.rungs.len()].1,
            };
            // Many samples cost as many times one.
            let (asked, times) = match settings.samples {
                n if n > 4 => (
                    Settings {
                        samples: 4,
                        ..settings
                    },
                    f64::from(n) / 4.0,
                ),
                _ => (settings, 1.0),
            };
            let known = costs.iter().find(|c| c.0 == asked).map(|c| c.1);
            let cost = match known {
                Some(cost) => cost,
                None => {
                    let late = self.start.elapsed().as_secs_f64() > deadline;
                    let few = if late { few.min(4) } else { few };
                    let pixels = if late {
                        self.pixels(few) as f64
                    } else {
                        pixels
                    };
                    let tiles = &self.tiles[..few];
                    let timed = self.stage.time(&asked, tiles)?;
                    let rays = rays(&timed.drawn.counts.rays).max(1) as f64;
                    let cost = [timed.cpu / pixels, timed.cpu / rays];
                    costs.push((asked, cost));
                    cost
                }
            };
            let known = match i < self.rungs.len() {
                true => &mut self.known[i],
                false => &mut self.effects[i - self.rungs.len()].2,
            };
            (known.cost, known.per_ray) = (cost[0] * times, cost[1]);
            if self.is_stopped() {
                break;
            }
        }
        Ok(())
    }

    /// Seconds a pixel of some settings that the pilot tried, or of the default.
    fn cost(&self, settings: &Settings) -> f64 {
        let of = |s: &Settings| {
            let found = self.rungs.iter().position(|r| r.settings == *s);
            found.map(|i| self.known[i].cost)
        };
        of(settings)
            .or_else(|| of(&Settings::default()))
            .unwrap_or(1e-5)
    }

    /// Double-double, and its check by the independent tracer.
    fn reference_numbers(&mut self) -> Result<(), Error> {
        if !self.rungs.iter().any(|r| r.axis.kind() == Kind::Numbers) {
            return Ok(());
        }
        let settings = Settings {
            kernel: Kernel::Ours(Numbers::Dd),
            ..Settings::default()
        };
        let cost = match self.rungs.iter().any(|r| r.settings == settings) {
            true => self.cost(&settings),
            false => 10.0 * self.cost(&Settings::default()),
        };
        let tiles = self.tiles_for(self.seconds(0.1) * self.threads, cost, LEAST_PIXELS);
        let drawn = self.stage.draw(&settings, &self.tiles[..tiles])?;
        self.exact = drawn.colours;
        let language = self.options.language;
        let mut reference = Reference {
            precision: Some("dd"),
            margin: Margin {
                rmse: None,
                steps: None,
                how: say(language, "accuracy-how-naive"),
            },
            ..Reference::default()
        };
        let seen = self
            .stage
            .seen(&Settings::default(), &self.tiles[..tiles])?;
        let order = check::order(&self.tiles[..tiles], &seen);
        let checked = check::check(
            &self.stage,
            self.images,
            &settings,
            &order,
            &self.exact,
            self.seconds(0.1),
        )?;
        reference.checked = Some(match checked {
            Ok(checked) => {
                reference.margin.rmse = Some(checked.largest);
                checked
            }
            Err(why) => Checked {
                not_checked: Some(say(language, why)),
                ..Checked::default()
            },
        });
        self.reference.insert(Kind::Numbers.name(), reference);
        Ok(())
    }

    /// Deeper and with a lower cutoff than any rung.
    fn reference_light(&mut self) -> Result<(), Error> {
        if !self.rungs.iter().any(|r| r.axis.kind() == Kind::Light) {
            return Ok(());
        }
        let few = 4.min(self.tiles.len());
        let at = |depth, cutoff| Settings {
            depth,
            cutoff,
            ..Settings::default()
        };
        // The deepest that the time allows: the next one must not take longer than the share of it.
        let mut best = at(64, 1e-6);
        let pilot = |run: &mut Self, s: &Settings| -> Result<Timed, Error> {
            let tiles = run.tiles[..few].to_vec();
            run.stage.time(s, &tiles)
        };
        let pixels = self.pixels(few) as f64;
        let mut cost = pilot(self, &best)?.cpu / pixels;
        let allowed = self.seconds(0.12) * self.threads / LEAST_PIXELS;
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
        let tiles = self.tiles_for(self.seconds(0.12) * self.threads, cost, LEAST_PIXELS);
        let drawn = self.stage.draw(&best, &self.tiles[..tiles])?;
        // What one less deep, with ten times the cutoff, comes to.
        let less = at(best.depth / 2, best.cutoff * 10.0);
        let sample = tiles.min(self.tiles.len().div_ceil(4)).max(1);
        let other = self.stage.draw(&less, &self.tiles[..sample])?;
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
                how: say(self.options.language, "accuracy-how-light"),
            },
            ..Reference::default()
        };
        self.reference.insert(Kind::Light.name(), reference);
        Ok(())
    }

    fn drop_rungs(&mut self, which: impl Fn(&Rung) -> bool) {
        for i in 0..self.rungs.len() {
            if which(&self.rungs[i]) && !self.known[i].dropped && !self.rungs[i].is_default() {
                self.known[i].dropped = true;
                let name = format!("{} {}", self.rungs[i].axis.name(), self.rungs[i].label);
                self.cut.push(name);
            }
        }
    }

    fn sizes(&self, tiles: usize) -> Vec<[u32; 2]> {
        self.tiles[..tiles]
            .iter()
            .map(|t| [t.width, t.height])
            .collect()
    }

    /// Many samples, never adaptive: twice as many until half of them come near enough to all, or the time
    /// is up.
    fn reference_edges(&mut self) -> Result<(), Error> {
        if !self.rungs.iter().any(|r| r.axis.kind() == Kind::Edges) {
            return Ok(());
        }
        let base = Settings::default();
        let each = self.cost(&base);
        let allowed = self.seconds(0.2) * self.threads / each;
        // At least so many pixels, rather than more samples.
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
        let tiles = self.tiles_for(allowed, f64::from(samples), LEAST_PIXELS);
        let tiles_list = self.tiles[..tiles].to_vec();
        let sizes = self.sizes(tiles);
        let mut done = 64;
        let mut sums = self.stage.sums(&base, &tiles_list, 0..done)?;
        let mean = |sums: &[Rgb], n: u32| -> Vec<Rgb> {
            sums.iter().map(|s| s.map(|c| c / f64::from(n))).collect()
        };
        let mut margin;
        loop {
            let half = mean(&sums, done);
            let more = self.stage.sums(&base, &tiles_list, done..2 * done)?;
            for (sum, more) in sums.iter_mut().zip(more) {
                *sum = [0, 1, 2].map(|c| sum[c] + more[c]);
            }
            done *= 2;
            self.edges = mean(&sums, done);
            margin = compare(&half, &self.edges, &sizes, true).steps;
            let behind = 0.3 + 0.15 * f64::from(done) / f64::from(samples);
            (self.progress)("accuracy-step-edges", behind.min(0.45));
            // The next one takes as long as all before.
            let is_good = margin < self.options.goal / 4.0 && done >= 512;
            if is_good || done >= samples || self.is_stopped() {
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
                how: say(self.options.language, "accuracy-how-edges"),
            },
            ..Reference::default()
        };
        self.reference.insert(Kind::Edges.name(), reference);
        Ok(())
    }

    /// Draws every rung and measures how far it is from the reference of its kind.
    fn errors(&mut self) -> Result<(), Error> {
        let mut references: BTreeMap<Axis, Vec<Rgb>> = BTreeMap::new();
        let list: Vec<(Axis, Settings)> = self.facets.iter().map(|(a, s)| (*a, *s)).collect();
        for (axis, settings) in list {
            let tiles = self.tiles_for(
                self.seconds(0.02) * self.threads,
                self.cost(&settings),
                LEAST_PIXELS,
            );
            let drawn = self.stage.draw(&settings, &self.tiles[..tiles])?;
            references.insert(axis, drawn.colours);
        }
        let count = self
            .rungs
            .iter()
            .zip(&self.known)
            .filter(|r| !r.1.dropped)
            .count();
        let share = self.seconds(0.15) * self.threads / count.max(1) as f64;
        let mut last: Option<(Axis, usize)> = None;
        for i in 0..self.rungs.len() {
            if self.known[i].dropped {
                continue;
            }
            let rung = self.rungs[i].clone();
            // A ladder ends one rung after its bytes stop changing.
            if let Some((axis, same)) = last
                && axis == rung.axis
                && matches!(axis, Axis::Depth | Axis::Cutoff)
                && self.known[same].same_as.is_some()
                && self.is_beyond_default(same)
            {
                self.known[i].dropped = true;
                continue;
            }
            let reference = match rung.axis.kind() {
                Kind::Edges => &self.edges,
                Kind::Light => &self.light,
                Kind::Numbers => &self.exact,
                Kind::Facets => references.get(&rung.axis).unwrap_or(&self.light),
            };
            let there = self.tiles_of(reference.len());
            let tiles = self
                .tiles_for(share, self.known[i].cost, LEAST_PIXELS)
                .min(there);
            if tiles == 0 {
                continue;
            }
            let reference = reference.clone();
            let drawn = self.stage.draw(&rung.settings, &self.tiles[..tiles])?;
            let whole = self.whole && tiles == self.tiles.len();
            let measured = compare(&drawn.colours, &reference, &self.sizes(tiles), whole);
            let same = (0..i).find(|&j| self.is_same(j, &rung, &drawn, tiles));
            let known = &mut self.known[i];
            known.same_as = same.filter(|_| !rung.is_default());
            (known.drawn, known.tiles, known.measured) = (Some(drawn), tiles, Some(measured));
            last = Some((rung.axis, i));
            if self.is_stopped() {
                return Ok(());
            }
        }
        let tiles = self.tiles_for(
            self.seconds(0.01) * self.threads,
            self.cost(&Settings::default()),
            LEAST_PIXELS,
        );
        let base = self
            .stage
            .draw(&Settings::default(), &self.tiles[..tiles])?;
        let sizes = self.sizes(tiles);
        for i in 0..self.effects.len() {
            let settings = self.effects[i].1;
            let drawn = self.stage.draw(&settings, &self.tiles[..tiles])?;
            let known = &mut self.effects[i].2;
            known.measured = Some(compare(&drawn.colours, &base.colours, &sizes, false));
            (known.drawn, known.tiles) = (Some(drawn), tiles);
        }
        Ok(())
    }

    fn tiles_of(&self, pixels: usize) -> usize {
        let mut sum = 0;
        (self.tiles.iter())
            .take_while(|t| {
                sum += t.count();
                sum <= pixels
            })
            .count()
    }

    /// Whether a rung lies between the default and the reference.
    fn is_beyond_default(&self, i: usize) -> bool {
        let (settings, default) = (self.rungs[i].settings, Settings::default());
        settings.depth > default.depth || settings.cutoff < default.cutoff
    }

    /// Whether rung `j`, drawn before, is the same computation: as many rays, and the same numbers.
    fn is_same(&self, j: usize, rung: &Rung, drawn: &Drawn, tiles: usize) -> bool {
        let (known, other) = (&self.known[j], &self.rungs[j]);
        let Some(before) = &known.drawn else {
            return false;
        };
        let alike = |s: &Settings| {
            (
                s.samples,
                s.tolerance,
                s.kernel == rung.settings.kernel,
                s.roots,
                s.variant,
            )
        };
        let common = self.pixels(tiles.min(known.tiles));
        alike(&other.settings) == alike(&rung.settings)
            && !known.dropped
            && (tiles != known.tiles || rays(&before.counts.rays) == rays(&drawn.counts.rays))
            && before.colours[..common] == drawn.colours[..common]
    }

    /// Runs in shuffled order on one thread.
    fn times(&mut self) -> Result<(), Error> {
        let default = Settings::default();
        let seconds = self.seconds(0.4);
        let mut runs = self.options.runs.unwrap_or(5);
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
                    let least = least.min((4.0 * each / cost.max(1e-12)).max(512.0));
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
                self.cut.push(name);
                entries.retain(|e| *e != Entry::Rung(i));
            }
            (tiles, predicted) = plan(self, &entries, runs);
        }
        if predicted > 1.1 * seconds && self.options.runs.is_none() {
            runs = 3;
            (tiles, predicted) = plan(self, &entries, runs);
            self.cut
                .push(say(self.options.language, "accuracy-cut-runs"));
        }
        self.predicted = predicted;
        let mut order: Vec<usize> = (0..entries.len()).collect();
        let mut done = 0;
        'all: for round in 0..runs {
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
                (self.progress)("accuracy-step-times", 0.55 + 0.4 * behind);
            }
        }
        Ok(())
    }

    /// Seconds a pixel of what is to be timed: by the rays of the pixels that were drawn, of which there are
    /// more than in the pilot.
    fn entry_cost(&self, entry: &Entry) -> f64 {
        let known = match entry {
            Entry::Rung(i) => Some(&self.known[*i]),
            Entry::Effect(i) => Some(&self.effects[*i].2),
            Entry::Default(_) => {
                let default = self.rungs.iter().position(|r| r.is_default());
                default.map(|i| &self.known[i])
            }
        };
        let by_rays = known.and_then(|known| {
            let rays = rays(&known.drawn.as_ref()?.counts.rays) as f64;
            Some(known.per_ray * rays / self.pixels(known.tiles).max(1) as f64)
        });
        match (by_rays, known) {
            (Some(cost), _) => cost,
            (None, Some(known)) => known.cost,
            (None, None) => self.cost(&Settings::default()),
        }
    }

    /// The least CPU time of the default on the first tiles.
    fn default_time(&self, tiles: usize, repeats: &[Vec<Timed>]) -> Option<f64> {
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

    fn report(mut self, name: &str, load_before: Option<f64>) -> Result<Report, Error> {
        let stopped = self.is_stopped();
        let options = self.options;
        let repeats = std::mem::take(&mut self.repeats);
        let mut rows = Vec::new();
        let minima: Vec<f64> = (repeats.iter())
            .filter(|r| !r.is_empty())
            .map(|r| r.iter().map(|t| t.cpu).fold(f64::INFINITY, f64::min))
            .collect();
        let mut pairs = Vec::new();
        for (i, a) in minima.iter().enumerate() {
            pairs.extend(minima[i + 1..].iter().map(|b| [*a, *b]));
        }
        let noise = noise(&pairs);
        let seen = self.numbers_seen(stopped)?;
        let mut defaults = 0;
        for i in 0..self.rungs.len() {
            let (rung, known) = (&self.rungs[i], &self.known[i]);
            let (Some(measured), false) = (&known.measured, known.dropped) else {
                continue;
            };
            let is_default = rung.is_default();
            let (times, tiles): (&[Timed], usize) = match (is_default, known.same_as) {
                (true, _) => {
                    let own = repeats.get(defaults % repeats.len().max(1));
                    defaults += 1;
                    let own = own.map_or(&[][..], |r| &r[..]);
                    (own, own.first().map_or(0, |t| t.tiles.len()))
                }
                (false, Some(j)) if self.rungs[j].is_default() => {
                    let own = repeats.first().map_or(&[][..], |r| &r[..]);
                    (own, own.first().map_or(0, |t| t.tiles.len()))
                }
                (false, Some(j)) => (&self.known[j].times, self.known[j].timed_tiles),
                (false, None) => (&known.times, known.timed_tiles),
            };
            let cpu = Spread::of(&times.iter().map(|t| t.cpu).collect::<Vec<_>>());
            let wall = Spread::of(&times.iter().map(|t| t.wall).collect::<Vec<_>>());
            let times_default = match (is_default, cpu) {
                (_, None) => None,
                (true, _) => Some(1.0),
                (false, Some(cpu)) => self.default_time(tiles, &repeats).map(|d| cpu.min / d),
            };
            let drawn = known.drawn.clone().unwrap_or_default();
            let mut error = RowError::from(measured.clone());
            if let Some((wrong, median, max)) = seen.iter().find(|s| s.0 == i).map(|s| s.1) {
                error.wrong_object = Some(wrong);
                (error.median_ulp, error.max_ulp) = (Some(median), Some(max));
            }
            let kind = rung.axis.kind();
            let margin = self.reference.get(kind.name()).and_then(|r| r.margin.steps);
            let per_second = times
                .first()
                .zip(wall)
                .map(|(t, wall)| rays(&t.drawn.counts.rays) as f64 / wall.min.max(1e-9));
            rows.push(Row {
                kind: kind.name(),
                axis: rung.axis.name(),
                setting: rung.label.clone(),
                seconds: wall,
                cpu_seconds: cpu,
                times_default,
                pixels_timed: self.pixels(tiles.min(self.tiles.len())),
                rays_per_second: per_second,
                rays: rays(&drawn.counts.rays),
                uncertain: drawn.counts.uncertain,
                samples_mean: drawn.samples as f64 / measured.pixels.max(1) as f64,
                below_reference: margin.is_some_and(|m| measured.steps < m),
                error: Some(error),
                default: is_default,
                pareto: false,
                same_as: known
                    .same_as
                    .map(|j| format!("{} {}", self.rungs[j].axis.name(), self.rungs[j].label)),
                of: Some((kind, rung.axis)),
                option: rung.option(),
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
                tolerance: SLACK,
            },
            noise: Noise {
                relative: noise,
                pairs: pairs.len(),
                estimator: "minimum of cpu_seconds",
            },
            machine: Machine {
                cpu: cpu_name(),
                cores: std::thread::available_parallelism().map_or(1, usize::from),
                threads: 1,
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
        super::advice::advise(&mut report, options.language);
        if !stopped {
            self.pictures(&mut report)?;
        }
        report.budget.spent_seconds = self.start.elapsed().as_secs_f64();
        Ok(report)
    }

    /// Of each rung of numbers: pixels that see another object, and distances in units of the last place,
    /// the median and the largest.
    fn numbers_seen(&mut self, stopped: bool) -> Result<Vec<(usize, (usize, f64, f64))>, Error> {
        let mut found = Vec::new();
        if stopped || self.exact.is_empty() {
            return Ok(found);
        }
        let tiles = self.tiles_of(self.exact.len()).min(60);
        let list = self.tiles[..tiles].to_vec();
        let exact = Settings {
            kernel: Kernel::Ours(Numbers::Dd),
            ..Settings::default()
        };
        let right = self.stage.seen(&exact, &list)?;
        for i in 0..self.rungs.len() {
            let rung = &self.rungs[i];
            if rung.axis != Axis::Precision
                || self.known[i].dropped
                || self.known[i].drawn.is_none()
            {
                continue;
            }
            let settings = rung.settings;
            let bits = match settings.kernel {
                Kernel::Ours(Numbers::F32) | Kernel::PlainF32 => 23,
                Kernel::Ours(Numbers::F64) | Kernel::PlainF64 => 52,
                Kernel::Ours(Numbers::Dd) => 105,
            };
            let seen = self.stage.seen(&settings, &list)?;
            found.push((i, distances(&seen, &right, bits)));
        }
        Ok(found)
    }

    fn effects_found(&self, repeats: &[Vec<Timed>], noise: f64) -> Vec<Effect> {
        let base = self.rungs.iter().position(|r| r.is_default());
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
                let cpu = Spread::of(&known.times.iter().map(|t| t.cpu).collect::<Vec<_>>());
                let saved = cpu.and_then(|cpu| {
                    let whole = self.default_time(known.timed_tiles, repeats)?;
                    Some(1.0 - cpu.min / whole)
                });
                // A ray count of the same pixels.
                let own = rays(&known.drawn.as_ref()?.counts.rays) as f64;
                let (all, pixels) = default_rays?;
                let scale = self.pixels(known.tiles) as f64 / pixels.max(1) as f64;
                Some(Effect {
                    name,
                    cpu_seconds: cpu,
                    within_noise: saved.is_some_and(|s| s.abs() <= noise),
                    saved,
                    rays_saved: (all as f64 * scale - own).round() as i64,
                    error: measured.into(),
                })
            })
            .collect()
    }

    /// Time and error by what is seen first, and over the picture.
    fn objects(&mut self) -> Result<(Vec<Object>, Option<Maps>), Error> {
        let settings = Settings {
            samples: 4,
            ..Settings::default()
        };
        // Three runs.
        let cost = 12.0 * self.cost(&Settings::default());
        let tiles = self.tiles_for(self.seconds(0.05), cost, LEAST_PIXELS);
        let list = self.tiles[..tiles].to_vec();
        let times = self.stage.pixel_times(&settings, &list)?;
        let seen = self.stage.seen(&Settings::default(), &list)?;
        let base = self.stage.draw(&Settings::default(), &list)?;
        let mut sums: BTreeMap<u32, (usize, f64, f64, usize)> = BTreeMap::new();
        let error = |i: usize| -> Option<f64> {
            let (a, b) = (base.colours[i], self.edges.get(i)?);
            Some(
                (0..3)
                    .map(|c| (steps(a[c]) - steps(b[c])).powi(2))
                    .sum::<f64>()
                    / 3.0,
            )
        };
        for (i, (time, seen)) in times.iter().zip(&seen).enumerate() {
            let sum = sums.entry(seen.map_or(0, |s| s.object)).or_default();
            sum.0 += 1;
            sum.1 += time;
            if let Some(square) = error(i) {
                sum.2 += square;
                sum.3 += 1;
            }
        }
        let total =
            |f: fn(&(usize, f64, f64, usize)) -> f64| sums.values().map(f).sum::<f64>().max(1e-300);
        let (pixels, time, square) = (total(|s| s.0 as f64), total(|s| s.1), total(|s| s.2));
        let mut objects: Vec<Object> = (sums.iter())
            .map(|(&id, &(n, t, e, with_error))| Object {
                id,
                share_of_pixels: n as f64 / pixels,
                share_of_time: t / time,
                share_of_error: e / square,
                microseconds_per_pixel: t / n as f64 / 4.0 * 1e6,
                steps: (e / with_error.max(1) as f64).sqrt(),
            })
            .collect();
        objects.sort_by(|a, b| b.share_of_time.total_cmp(&a.share_of_time));
        objects.truncate(100);
        let maps = self.maps(&list, &times, &|i| error(i).map(f64::sqrt));
        Ok((objects, Some(maps)))
    }

    fn maps(&self, list: &[Tile], times: &[f64], error: &dyn Fn(usize) -> Option<f64>) -> Maps {
        let [w, h] = self.options.size;
        let block = if self.whole { 1 } else { 32 };
        let (width, height) = (w.div_ceil(block), h.div_ceil(block));
        let count = width as usize * height as usize;
        let mut sums = vec![[0.0f64; 4]; count];
        let mut i = 0;
        for tile in list {
            for [x, y] in tile.pixels() {
                let sum = &mut sums[(y / block * width + x / block) as usize];
                sum[0] += times[i];
                sum[1] += 1.0;
                if let Some(e) = error(i) {
                    sum[2] += e * e;
                    sum[3] += 1.0;
                }
                i += 1;
            }
        }
        Maps {
            width,
            height,
            // Of 0 pixels there is no number.
            time: sums.iter().map(|s| s[0] / s[1] / 4.0 * 1e6).collect(),
            error: sums.iter().map(|s| (s[2] / s[3]).sqrt()).collect(),
        }
    }

    /// The picture, and for each kind the part of it that is worst, by the default and by the most
    /// accurate rung.
    fn pictures(&mut self, report: &mut Report) -> Result<(), Error> {
        let [width, height] = self.options.size;
        // At most so many pixels, so that a page of all stays small.
        let step = (width.max(height)).div_ceil(320).max(1);
        report.picture = Some(self.coarse(step)?);
        for kind in Kind::ALL {
            let Some(default) = self.worst(kind) else {
                continue;
            };
            let best = (0..self.rungs.len())
                .filter(|&i| self.rungs[i].axis.kind() == kind && !self.known[i].dropped)
                .filter(|&i| !self.rungs[i].is_default())
                .filter_map(|i| Some((i, self.known[i].measured.as_ref()?.steps)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            let (shown, better, place) = match (kind, best) {
                (Kind::Numbers, _) => {
                    // The plain kernel in single precision beside what is right.
                    let plain = self.find(Kernel::Ours(Numbers::F32));
                    let exact = self.find(Kernel::Ours(Numbers::F64));
                    match (plain, exact) {
                        (Some(a), Some(b)) => (a, b, default),
                        _ => continue,
                    }
                }
                (_, Some((best, _))) => {
                    let Some(own) = self
                        .rungs
                        .iter()
                        .position(|r| r.axis.kind() == kind && r.is_default())
                    else {
                        continue;
                    };
                    (own, best, default)
                }
                _ => continue,
            };
            let crop = around(place, [width, height]);
            let draw = |run: &mut Self, i: usize| -> Result<(String, Raster), Error> {
                let drawn = run.stage.draw(&run.rungs[i].settings.clone(), &crop.1)?;
                let name = format!("{} {}", run.rungs[i].axis.name(), run.rungs[i].label);
                Ok((name, arranged(&crop, &drawn.colours)))
            };
            let pictures = Pictures {
                kind,
                default: draw(self, shown)?,
                better: draw(self, better)?,
            };
            report.pictures.push(pictures);
        }
        Ok(())
    }

    fn find(&self, kernel: Kernel) -> Option<usize> {
        let of = |r: &Rung| r.axis == Axis::Precision && r.settings.kernel == kernel;
        self.rungs.iter().position(of)
    }

    /// The tile in which the default, or single precision, is farthest from the reference of a kind.
    fn worst(&self, kind: Kind) -> Option<Tile> {
        let reference = match kind {
            Kind::Edges => &self.edges,
            Kind::Light => &self.light,
            Kind::Numbers => &self.exact,
            Kind::Facets => return self.tiles.first().copied(),
        };
        let i = match kind {
            Kind::Numbers => self.find(Kernel::Ours(Numbers::F32))?,
            _ => self
                .rungs
                .iter()
                .position(|r| r.axis.kind() == kind && r.is_default())?,
        };
        let drawn = self.known[i].drawn.as_ref()?;
        let mut at = 0;
        let mut worst = (-1.0, *self.tiles.first()?);
        for tile in &self.tiles {
            let range = at..at + tile.count();
            at = range.end;
            let (Some(a), Some(b)) = (drawn.colours.get(range.clone()), reference.get(range))
            else {
                break;
            };
            let pairs = a
                .iter()
                .zip(b)
                .flat_map(|(a, b)| (0..3).map(|c| steps(a[c]) - steps(b[c])));
            let sum: f64 = pairs.map(|d| d * d).sum();
            if sum > worst.0 {
                worst = (sum, *tile);
            }
        }
        Some(worst.1)
    }

    /// Every so many pixels of every so many rows, by the default.
    fn coarse(&mut self, step: u32) -> Result<Raster, Error> {
        let [w, h] = self.options.size;
        let (width, height) = (w.div_ceil(step), h.div_ceil(step));
        let single = |x: u32, y: u32| Tile {
            x: x * step,
            y: y * step,
            width: 1,
            height: 1,
        };
        let tiles: Vec<Tile> = (0..height)
            .flat_map(|y| (0..width).map(move |x| single(x, y)))
            .collect();
        let drawn = self.stage.draw(&Settings::default(), &tiles)?;
        Ok(Raster {
            width,
            height,
            pixels: drawn.colours,
        })
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Entry {
    Rung(usize),
    Effect(usize),
    Default(usize),
}

fn rays(rays: &Rays) -> u64 {
    rays.camera + rays.shadow + rays.reflection + rays.refraction
}

/// Pixels that see something else, and the median and the largest distance of what is seen, in units of
/// the last of so many bits.
fn distances(seen: &[Option<Seen>], right: &[Option<Seen>], bits: i32) -> (usize, f64, f64) {
    let mut wrong = 0;
    let mut ulps = Vec::new();
    for (a, b) in seen.iter().zip(right) {
        match (a, b) {
            (Some(a), Some(b)) if a.object == b.object => {
                let off = ((a.t.0 - b.t.0) + (a.t.1 - b.t.1)).abs();
                let ulp = (b.t.0.abs().log2().floor() - f64::from(bits)).exp2();
                ulps.push(off / ulp);
            }
            (None, None) => {}
            _ => wrong += 1,
        }
    }
    ulps.sort_by(f64::total_cmp);
    let median = ulps.get(ulps.len() / 2).copied().unwrap_or(0.0);
    (wrong, median, ulps.last().copied().unwrap_or(0.0))
}

/// A part of the picture around a tile: its place and size, and tiles that make it up.
fn around(tile: Tile, [width, height]: [u32; 2]) -> ([u32; 4], Vec<Tile>) {
    let (w, h) = (96.min(width), 72.min(height));
    let start =
        |at: u32, size: u32, all: u32| (at + TILE / 2).saturating_sub(size / 2).min(all - size);
    let (x0, y0) = (start(tile.x, w, width), start(tile.y, h, height));
    let mut tiles = Vec::new();
    for y in (0..h).step_by(TILE as usize) {
        for x in (0..w).step_by(TILE as usize) {
            tiles.push(Tile {
                x: x0 + x,
                y: y0 + y,
                width: TILE.min(w - x),
                height: TILE.min(h - y),
            });
        }
    }
    ([x0, y0, w, h], tiles)
}

fn arranged(([x0, y0, w, h], tiles): &([u32; 4], Vec<Tile>), colours: &[Rgb]) -> Raster {
    let mut pixels = vec![[0.0; 3]; *w as usize * *h as usize];
    let places = tiles.iter().flat_map(|t| t.pixels());
    for ([x, y], colour) in places.zip(colours) {
        pixels[((y - y0) * w + (x - x0)) as usize] = *colour;
    }
    Raster {
        width: *w,
        height: *h,
        pixels,
    }
}

fn cpu_name() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find_map(|l| l.strip_prefix("model name"));
    let name = line.map(|l| l.trim_start_matches([' ', '\t', ':']).to_owned());
    name.unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}
