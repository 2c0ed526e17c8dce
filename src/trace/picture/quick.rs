//! A picture by the quick kernel, in bands of rows.

use super::{Crop, Drawing, Numbers, Settings};
use crate::geometry::vec::Vec3;
use crate::trace::kernel;
use crate::trace::shade::Shader;

impl<'t> Drawing<'t> {
    /// The scene for the quick kernel, if that can draw it, knows most of it, and saves time.
    pub(in crate::trace) fn quick_stage(&self, settings: &Settings) -> Option<kernel::Stage<'t>> {
        let part = settings.part();
        // To set up the kernel takes about as long for a shape as to draw a few pixels.
        let pixels = part.width as usize * part.height as usize;
        let most = (pixels / 8).saturating_mul(settings.first_samples() as usize);
        let stage = self.stage(settings.numbers, most)?;
        self.is_mostly_sure(&self.scene(&stage), part)
            .then_some(stage)
    }

    /// The scene for the quick kernel, if that can draw it.
    fn stage(&self, numbers: Numbers, most: usize) -> Option<kernel::Stage<'t>> {
        let graph = &self.tracer.graph;
        let is_for_it = numbers == Numbers::F64 && self.is_outside && !graph.without.kernel;
        is_for_it.then(|| kernel::Stage::new(graph, most)).flatten()
    }

    /// Whether the kernel knows most pixels of a few places in the picture.
    fn is_mostly_sure(&self, scene: &kernel::Scene, part: Crop) -> bool {
        let [columns, rows] = [part.width, part.height].map(|n| n as usize);
        let [across, down] = [columns / kernel::TILE[0], rows / kernel::TILE[1]];
        // They take a hundredth of the time.
        let tiles = (across * down / 128).min(64);
        let mut tile = kernel::Tile::default();
        let mut shader: Shader = self.shader();
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
            let drawn = tile.draw(scene, &mut shader, &rays);
            all += drawn.len();
            sure += drawn
                .iter()
                .filter(|pixel| !pixel.is_lost && pixel.cost().slow == 0)
                .count();
        }
        all - sure <= all / 8
    }

    pub(in crate::trace) fn scene<'s>(&'s self, stage: &'s kernel::Stage<'s>) -> kernel::Scene<'s> {
        kernel::Scene {
            stage,
            lights: self.lights,
            ambient: self.tracer.ambient,
            background: self.tracer.background,
            limits: self.limits,
            features: self.features,
            is_lone_convex: self.tracer.plan.lone_convex,
        }
    }
}

/// The columns and rows that the quick kernel draws together: with many samples one row, so that a picture that is
/// interrupted keeps what is done.
pub(super) fn tile(samples: u32) -> [usize; 2] {
    let [across, down] = kernel::TILE;
    let height = (down / samples as usize).max(1);
    [(across * down / (height * samples as usize)).max(1), height]
}
