//! A picture by the quick kernel, in bands of rows.

use super::{Drawing, Eye, Numbers, Settings};
use crate::trace::kernel;

impl<'t> Drawing<'t> {
    /// Sets the scene up for the quick kernel; `None` if the kernel cannot draw the picture or would save no time.
    pub(in crate::trace) fn quick_stage(&self, settings: &Settings) -> Option<kernel::Stage<'t>> {
        let part = settings.part();
        // Setting up the kernel takes, for each shape, about as long as drawing a few pixels.
        let pixels = part.width as usize * part.height as usize;
        let most = (pixels / 8).saturating_mul(settings.first_samples() as usize);
        let graph = &self.tracer.graph;
        let is_for_it =
            settings.numbers == Numbers::F64 && self.eye != Eye::Anywhere && !graph.without.kernel;
        is_for_it.then(|| kernel::Stage::new(graph, most)).flatten()
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

/// The numbers of columns and rows that the quick kernel draws together. With many samples it is one row, so that an
/// interrupted picture keeps the rows that are done.
pub(super) fn tile(samples: u32) -> [usize; 2] {
    let [across, down] = kernel::TILE;
    let height = (down / samples as usize).max(1);
    [(across * down / (height * samples as usize)).max(1), height]
}
