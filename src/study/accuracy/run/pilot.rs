//! Plans the configurations, and learns the cost of each from a few tiles.

use super::{ConfigurationState, LEAST_PIXELS, Run, TimedItem, rays};
use crate::diagnostics::{Complaint, Error};
use crate::study::accuracy::configurations::{Axis, Configuration, Kernel, Settings, ladder};
use crate::study::accuracy::facets::Facets;
use crate::study::accuracy::report::Skipped;
use crate::study::accuracy::{axes, facets};

/// The share of the budget in which the default is timed once more, to calibrate the pilot's costs.
const CALIBRATION: f64 = 0.01;

/// The share of the budget in which meshes are made.
const MESHES: f64 = 0.05;

impl Run<'_> {
    /// Collects the configurations of the axes that the scene calls for.
    pub(super) fn plan(&mut self) -> Result<(), Error> {
        let seconds = self.seconds(MESHES);
        for axis in Axis::ALL {
            let wanted = self.options.axes.contains(&axis);
            let why = match wanted {
                false => Some("accuracy-skip-unasked"),
                true => axes::skipped(axis, &self.runner),
            };
            let mut configurations = Vec::new();
            let mut why = why;
            if why.is_none() {
                let made = match axis {
                    Axis::Tessellation => facets::meshes(&mut self.runner, seconds)?,
                    Axis::Levels => facets::levels(&mut self.runner)?,
                    _ => {
                        configurations = ladder(axis);
                        None
                    }
                };
                if let Some(Facets {
                    configurations: made,
                    reference,
                }) = made
                {
                    configurations = made;
                    self.facets.insert(axis, reference);
                } else if configurations.is_empty() {
                    why = Some("accuracy-skip-mesh");
                }
            }
            if axis == Axis::Precision
                && !configurations.is_empty()
                && let Some(no_plain) = axes::no_plain(&self.runner)
            {
                configurations.retain(|r| matches!(r.settings.kernel, Kernel::Ours(_)));
                self.skipped.push(Skipped {
                    axis: "precision plain",
                    why: Complaint::new(no_plain),
                });
            }
            if let Some(why) = why {
                self.skipped.push(Skipped {
                    axis: axis.name(),
                    why: Complaint::new(why),
                });
            }
            self.configurations.extend(configurations);
        }
        self.known = self
            .configurations
            .iter()
            .map(|_| ConfigurationState::default())
            .collect();
        for (name, without) in axes::effects(&self.runner.tracer().plan) {
            let settings = Settings {
                without,
                ..Settings::default()
            };
            self.effects
                .push((name, settings, ConfigurationState::default()));
        }
        Ok(())
    }

    /// Draws each configuration once on a few tiles, to learn its cost.
    pub(super) fn pilot(&mut self) -> Result<(), Error> {
        let few = (self.tiles.len() / 16).clamp(4.min(self.tiles.len()), 40);
        let mut costs: Vec<(Settings, [f64; 2])> = Vec::new();
        let deadline = self.seconds(0.15);
        let latest = self.seconds(0.25);
        let pixels = self.pixels(few) as f64;
        for i in 0..self.configurations.len() + self.effects.len() {
            let settings = match self.configurations.get(i) {
                Some(configuration) => configuration.settings,
                None => self.effects[i - self.configurations.len()].1,
            };
            // The cost of many samples is computed from the cost of four.
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
            let is_default = self
                .configurations
                .get(i)
                .is_none_or(Configuration::is_default);
            if known.is_none() && !is_default && self.start.elapsed().as_secs_f64() > latest {
                self.drop_rung(i);
                continue;
            }
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
                    let tiles = self.tiles[..few].to_vec();
                    let timed = self.time(&asked, &tiles)?;
                    let rays = rays(&timed.drawn.counts.rays).max(1) as f64;
                    let cost = [timed.cpu / pixels, timed.cpu / rays];
                    costs.push((asked, cost));
                    cost
                }
            };
            let known = match i < self.configurations.len() {
                true => &mut self.known[i],
                false => &mut self.effects[i - self.configurations.len()].2,
            };
            (known.cost, known.per_ray) = (cost[0] * times, cost[1]);
            if self.is_stopped() {
                break;
            }
        }
        Ok(())
    }

    /// The seconds a pixel of settings that the pilot tried; of the default for other settings.
    pub(super) fn cost(&self, settings: &Settings) -> f64 {
        let of = |s: &Settings| {
            let found = self.configurations.iter().position(|r| r.settings == *s);
            found.map(|i| self.known[i].cost)
        };
        of(settings)
            .or_else(|| of(&Settings::default()))
            .unwrap_or(1e-5)
    }

    /// The seconds a pixel of an item that is to be timed. They follow from the rays of the pixels that were drawn for
    /// errors, which are more than the pilot's.
    pub(super) fn entry_cost(&self, entry: &TimedItem) -> f64 {
        let known = match entry {
            TimedItem::Configuration(i) => Some(&self.known[*i]),
            TimedItem::Effect(i) => Some(&self.effects[*i].2),
            TimedItem::Default(_) => {
                let default = self.configurations.iter().position(|r| r.is_default());
                default.map(|i| &self.known[i])
            }
        };
        let by_rays = known.and_then(|known| {
            let rays = rays(&known.drawn.as_ref()?.counts.rays) as f64;
            Some(known.per_ray * rays / self.pixels(known.tiles).max(1) as f64)
        });
        let cost = match (by_rays, known) {
            (Some(cost), _) => cost,
            (None, Some(known)) => known.cost,
            (None, None) => self.cost(&Settings::default()),
        };
        cost * self.calibration
    }

    /// Measures the default settings on more tiles than the pilot had. The ratio of the measured time to the estimate
    /// then corrects the estimated cost of every setting.
    pub(super) fn calibrate(&mut self) -> Result<(), Error> {
        let cost = self.entry_cost(&TimedItem::Default(0));
        let tiles = self.tiles_for(self.on_one(self.seconds(CALIBRATION)), cost, LEAST_PIXELS);
        let list = self.tiles[..tiles].to_vec();
        let timed = self.time(&Settings::default(), &list)?;
        self.calibration = timed.cpu / (cost * self.pixels(tiles) as f64).max(1e-12);
        self.weights = timed.tiles;
        Ok(())
    }

    pub(super) fn drop_rung(&mut self, i: usize) {
        if !self.known[i].dropped {
            self.known[i].dropped = true;
            let name = format!(
                "{} {}",
                self.configurations[i].axis.name(),
                self.configurations[i].label
            );
            self.cut.push(Complaint::quoted(name));
        }
    }

    pub(super) fn drop_rungs(&mut self, which: impl Fn(&Configuration) -> bool) {
        for i in 0..self.configurations.len() {
            if which(&self.configurations[i]) && !self.configurations[i].is_default() {
                self.drop_rung(i);
            }
        }
    }
}
