//! A picture by the quick kernel, in bands of rows.

use super::{Crop, Draw, Drawing, Numbers, Pen, Pixel, Row};
use crate::geometry::vec::Vec3;
use crate::trace::film::developed;
use crate::trace::kernel::{self, Drawn};
use crate::trace::precision::Precision;
use crate::trace::stats::{Counts, Samples};
use crate::trace::switches::Without;
use crate::trace::within::Within;

impl<'t> Drawing<'t> {
    /// The scene for the quick kernel, if that can draw it.
    pub(super) fn stage(&self, numbers: Numbers, most: usize) -> Option<kernel::Stage<'_>> {
        let graph = &self.tracer.graph;
        let is_plain = numbers == Numbers::F64
            && self.within == Within::Outside
            && !self.features.dispersion
            && graph.without == Without::default()
            && graph.solver.is_none();
        is_plain.then(|| kernel::Stage::new(graph, most)).flatten()
    }

    /// Whether the kernel knows most pixels of a few places in the picture.
    pub(super) fn is_mostly_sure(&self, scene: &kernel::Scene, part: Crop) -> bool {
        let [columns, rows] = [part.width, part.height].map(|n| n as usize);
        let [across, down] = [columns / kernel::TILE[0], rows / kernel::TILE[1]];
        // They take a hundredth of the time.
        let tiles = (across * down / 128).min(64);
        let mut tile = kernel::Tile::default();
        let (mut all, mut sure) = (0, 0);
        for i in 0..tiles {
            let number = (2 * i + 1) * across * down / (2 * tiles);
            let [left, top] = [
                number % across * kernel::TILE[0],
                number / across * kernel::TILE[1],
            ];
            let places =
                (0..kernel::TILE[1]).flat_map(|y| (0..kernel::TILE[0]).map(move |x| (x, y)));
            let rays: Vec<[Vec3; 2]> = places
                .filter_map(|(x, y)| {
                    let (x, y) = ((left + x) as u32, (top + y) as u32);
                    self.line(part.x + x, part.y + y, 0, 1)
                })
                .collect();
            let drawn = tile.draw(scene, &rays);
            all += drawn.len();
            sure += drawn.iter().filter(|pixel| !pixel.is_doubtful).count();
        }
        all - sure <= all / 8
    }

    pub(super) fn scene<'s>(&'s self, stage: &'s kernel::Stage<'s>) -> kernel::Scene<'s> {
        kernel::Scene {
            stage,
            lights: self.lights,
            ambient: self.tracer.ambient,
            background: self.tracer.background,
            limits: self.limits,
            features: self.features,
            is_alone: self.tracer.plan.lone_convex,
        }
    }

    /// Draws some rows with the quick kernel. What it does not know is drawn as other rows are.
    pub(super) fn band<'d, R: Precision>(
        &'d self,
        pen: &mut Pen<'d, 't, R>,
        (scene, tile): (&kernel::Scene, &mut kernel::Tile),
        mut band: Vec<Row>,
        left: u32,
        progress: &(dyn Fn() + Sync),
        (samples, draw): (u32, Draw<R>),
    ) -> Vec<(Samples, Counts, bool)> {
        if self.is_to_stop() {
            return vec![(Samples::of(0), Counts::default(), false); band.len()];
        }
        pen.shader.reset();
        tile.take_work();
        let mut taken = vec![Samples::NONE; band.len()];
        let mut counts = Counts::default();
        let width = band.first().map_or(0, |row| row.film.len());
        let (mut places, mut rays) = (Vec::new(), Vec::new());
        let rays_in_tile = kernel::TILE[0] * kernel::TILE[1];
        let across = (rays_in_tile / (band.len() * samples as usize).max(1)).max(1);
        for from in (0..width).step_by(across) {
            places.clear();
            rays.clear();
            let to = width.min(from + across);
            let is_to_stop = self.is_to_stop();
            for row in 0..band.len() {
                let y = band[row].y;
                for column in from..to {
                    let x = left + column as u32;
                    let is_drawn = !is_to_stop && self.is_wanted(x, y);
                    taken[row].add(Samples::of(if is_drawn { samples } else { 0 }));
                    if is_drawn {
                        places.push((row, column));
                        let line = |i| self.line(x, y, i, samples).unwrap_or_default();
                        rays.extend((0..samples).map(line));
                    }
                }
            }
            let drawn = tile.draw(scene, &rays).chunks(samples as usize);
            for (&(row, column), drawn) in places.iter().zip(drawn) {
                let pixel = match drawn.iter().any(|sample| sample.is_doubtful) {
                    true => draw(pen, left + column as u32, band[row].y),
                    false => {
                        counts.quick += 1;
                        drawn.iter().for_each(|sample| sample.count(&mut counts));
                        let sum = drawn.iter().fold(Vec3::ZERO, |sum, s| sum + s.light);
                        Pixel {
                            colour: developed((sum / f64::from(samples)).0),
                            samples,
                            tests: drawn.iter().map(Drawn::tests).fold(0, u32::saturating_add),
                            total_reflection: drawn.iter().any(Drawn::has_total_reflection),
                        }
                    }
                };
                band[row].put(column, pixel);
            }
        }
        counts.work += tile.take_work();
        counts += pen.shader.counts();
        let is_finished = !self.is_to_stop();
        let rows = taken.into_iter().enumerate().map(|(row, samples)| {
            progress();
            let counts = if row == 0 { counts } else { Counts::default() };
            (samples, counts, is_finished)
        });
        rows.collect()
    }
}

/// The rows that the quick kernel draws together: with many samples one, so that a picture that is interrupted keeps what
/// is done.
pub(super) fn in_bands(rows: Vec<Row>, samples: u32) -> Vec<Vec<Row>> {
    let height = (kernel::TILE[1] / samples as usize).max(1);
    let mut bands: Vec<Vec<Row>> = Vec::with_capacity(rows.len().div_ceil(height));
    for row in rows {
        match bands.last_mut() {
            Some(band) if band.len() < height => band.push(row),
            _ => bands.push(vec![row]),
        }
    }
    bands
}
