//! A picture by the quick kernel, in bands of rows.

use super::{Drawing, Eye, Numbers, Settings};
use crate::trace::kernel;
use crate::trace::tracer::Tracer;

impl Tracer {
    /// The scene set up for the quick kernel; `None` if the kernel does not draw pictures with these settings, or would
    /// save no time.
    pub fn stage(&self, settings: &Settings) -> Option<kernel::Stage<'_>> {
        let part = settings.part();
        // Setting up the kernel takes, for each shape, about as long as it saves on four pixels, and is not
        // shared among threads.
        let pixels = part.width as usize * part.height as usize;
        let most = (pixels / 5).saturating_mul(settings.first_samples() as usize);
        let is_for_it =
            settings.numbers == Numbers::F64 && self.clip.is_none() && !self.graph.without.kernel;
        is_for_it
            .then(|| kernel::Stage::new(&self.graph, most))
            .flatten()
    }
}

impl Drawing<'_> {
    /// What the quick kernel draws; `None` without a stage, and for a camera in a solid.
    pub(in crate::trace) fn quick<'s>(
        &'s self,
        stage: Option<&'s kernel::Stage<'s>>,
    ) -> Option<kernel::Scene<'s>> {
        let stage = stage.filter(|_| self.eye != Eye::Anywhere)?;
        Some(kernel::Scene {
            stage,
            lights: self.lights,
            ambient: self.tracer.ambient,
            background: self.tracer.background,
            limits: self.limits,
            features: self.features,
            is_lone_convex: self.tracer.plan.lone_convex,
        })
    }
}

/// The numbers of columns and rows that the quick kernel draws together. With many samples it is one row, so that an
/// interrupted picture keeps the rows that are done.
pub(super) fn tile(samples: u32) -> [usize; 2] {
    let [across, down] = kernel::TILE;
    let height = (down / samples as usize).max(1);
    [(across * down / (height * samples as usize)).max(1), height]
}
