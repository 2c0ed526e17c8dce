//! Measures how far each configuration is from its reference.

use super::{Distances, ERRORS, FEWEST_PIXELS, LEAST_PIXELS, OBJECTS, PICTURES, Run, TIMES, rays};
use crate::diagnostics::Error;
use crate::scene::Rgb;
use crate::study::accuracy::configurations::{Axis, Configuration, Kernel, Kind, Settings};
use crate::study::accuracy::measure::compare;
use crate::study::accuracy::runner::Drawn;
use crate::trace::Numbers;
use crate::trace::pixels::VisibleObject;
use std::collections::BTreeMap;
use std::time::Instant;

impl Run<'_> {
    /// Draws every configuration and measures how far it is from the reference of its kind.
    pub(super) fn errors(&mut self) -> Result<(), Error> {
        let mut references: BTreeMap<Axis, Vec<Rgb>> = BTreeMap::new();
        let list: Vec<(Axis, Settings)> = self.facets.iter().map(|(a, s)| (*a, *s)).collect();
        for (axis, settings) in list {
            let seconds = self.on_all(self.seconds(0.02));
            let tiles = self.tiles_for(seconds, self.cost(&settings), LEAST_PIXELS);
            let drawn = self.draw(&settings, tiles)?;
            references.insert(axis, drawn.colours);
        }
        let count = self
            .configurations
            .iter()
            .zip(&self.known)
            .filter(|r| !r.1.dropped)
            .count();
        let seconds = self.allotted(ERRORS, TIMES / 2.0 + OBJECTS + PICTURES);
        let start = Instant::now();
        let share = self.on_all(seconds) / count.max(1) as f64;
        let mut last: Option<(Axis, usize)> = None;
        for i in 0..self.configurations.len() {
            if self.known[i].dropped {
                continue;
            }
            let configuration = self.configurations[i].clone();
            let is_late = start.elapsed().as_secs_f64() > 1.5 * seconds;
            if is_late
                && !configuration.is_default()
                && !self.is_cheap(self.known[i].cost * FEWEST_PIXELS)
            {
                self.drop_rung(i);
                continue;
            }
            // On the axes of depth and cutoff, everything is dropped after the first configuration beyond the default
            // that draws the same picture as an earlier one.
            if let Some((axis, same)) = last
                && axis == configuration.axis
                && matches!(axis, Axis::Depth | Axis::Cutoff)
                && self.known[same].same_as.is_some()
                && self.is_beyond_default(same)
            {
                self.known[i].dropped = true;
                continue;
            }
            let reference = match configuration.axis.kind() {
                Kind::Edges => &self.edges,
                Kind::Light => &self.light,
                Kind::Numbers => &self.exact,
                Kind::Facets => references.get(&configuration.axis).unwrap_or(&self.light),
            };
            let there = self.tiles_of(reference.len());
            let cost = self.known[i].cost;
            let affordable = (2.0 * share / cost.max(1e-12)).max(FEWEST_PIXELS);
            let least = match is_late {
                true => FEWEST_PIXELS,
                false => LEAST_PIXELS.min(affordable),
            };
            let share = if is_late { 0.0 } else { share };
            let tiles = self.tiles_for(share, cost, least).min(there);
            if tiles == 0 {
                continue;
            }
            let reference = reference.clone();
            let drawn = self.draw(&configuration.settings, tiles)?;
            let whole = self.whole && tiles == self.tiles.len();
            let measured = compare(&drawn.colours, &reference, &self.sizes(tiles), whole);
            let same = (0..i).find(|&j| self.is_same(j, &configuration, &drawn, tiles));
            let known = &mut self.known[i];
            known.same_as = same.filter(|_| !configuration.is_default());
            (known.drawn, known.tiles, known.measured) = (Some(drawn), tiles, Some(measured));
            last = Some((configuration.axis, i));
            if self.is_stopped() {
                return Ok(());
            }
        }
        let seconds = self.on_all(self.seconds(0.01));
        let tiles = self.tiles_for(seconds, self.cost(&Settings::default()), LEAST_PIXELS);
        let base = self.draw(&Settings::default(), tiles)?;
        let sizes = self.sizes(tiles);
        for i in 0..self.effects.len() {
            let settings = self.effects[i].1;
            let drawn = self.draw(&settings, tiles)?;
            let known = &mut self.effects[i].2;
            known.measured = Some(compare(&drawn.colours, &base.colours, &sizes, false));
            (known.drawn, known.tiles) = (Some(drawn), tiles);
        }
        Ok(())
    }

    pub(super) fn tiles_of(&self, pixels: usize) -> usize {
        let mut sum = 0;
        (self.tiles.iter())
            .take_while(|t| {
                sum += t.count();
                sum <= pixels
            })
            .count()
    }

    /// Whether configuration `i` is deeper or has a lower cutoff than the default, as the reference of light does.
    pub(super) fn is_beyond_default(&self, i: usize) -> bool {
        let (settings, default) = (self.configurations[i].settings, Settings::default());
        settings.depth > default.depth || settings.cutoff < default.cutoff
    }

    /// Whether configuration `j`, drawn before, is the same computation: as many rays, and the same numbers.
    pub(super) fn is_same(
        &self,
        j: usize,
        configuration: &Configuration,
        drawn: &Drawn,
        tiles: usize,
    ) -> bool {
        let (known, other) = (&self.known[j], &self.configurations[j]);
        let Some(before) = &known.drawn else {
            return false;
        };
        let alike = |s: &Settings| {
            (
                s.samples,
                s.tolerance,
                s.kernel == configuration.settings.kernel,
                s.roots,
                s.variant,
            )
        };
        let common = self.pixels(tiles.min(known.tiles));
        alike(&other.settings) == alike(&configuration.settings)
            && !known.dropped
            && (tiles != known.tiles || rays(&before.counts.rays) == rays(&drawn.counts.rays))
            && before.colours[..common] == drawn.colours[..common]
    }

    /// For each configuration of numbers: its number, and how the objects that it sees first differ from those of
    /// double-double.
    pub(super) fn numbers_seen(&mut self, stopped: bool) -> Result<Vec<(usize, Distances)>, Error> {
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
        let right = self.runner.seen(&exact, &list)?;
        for i in 0..self.configurations.len() {
            let configuration = &self.configurations[i];
            if configuration.axis != Axis::Precision
                || self.known[i].dropped
                || self.known[i].drawn.is_none()
            {
                continue;
            }
            let settings = configuration.settings;
            let bits = match settings.kernel {
                Kernel::Ours(Numbers::F32) | Kernel::PlainF32 => 23,
                Kernel::Ours(Numbers::F64) | Kernel::PlainF64 => 52,
                Kernel::Ours(Numbers::Dd) => 105,
            };
            let seen = self.runner.seen(&settings, &list)?;
            found.push((i, distances(&seen, &right, bits)));
        }
        Ok(found)
    }
}

/// Compares the objects seen first with the right ones. Returns the number of pixels that see another object; and for
/// the other pixels the median and the largest error of the distance, in units of the last of `bits` binary digits.
fn distances(
    seen: &[Option<VisibleObject>],
    right: &[Option<VisibleObject>],
    bits: i32,
) -> (usize, f64, f64) {
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
