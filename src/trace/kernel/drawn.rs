//! Drawn samples, and what they have cost.

use super::query::Tests;
use crate::geometry::vec::Vec3;
use crate::trace::stats::{Cost, Counts};

/// A drawn sample: its light, and counts of the work on it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Drawn {
    /// Whether the kernel could not draw the sample; then the other fields mean nothing.
    pub is_lost: bool,
    /// The cost of the arbiter's answers.
    pub(super) asked: Cost,
    pub light: Vec3,
    pub(super) tests: Tests,
    /// The number of rays to lamps.
    pub(super) shadow: u32,
    /// The number of rays to lamps that have passed something transparent.
    pub(super) transparent: u32,
    pub(super) reflection: u32,
    pub(super) refraction: u32,
    /// The number of total reflections.
    pub(super) total: u32,
    /// The number of ways by which light was to be bent into another medium.
    pub(super) media: u32,
    /// The number of rays that dispersion has added.
    pub(super) parted: u32,
}

impl Drawn {
    /// The cost of the sample.
    pub fn cost(&self) -> Cost {
        let own = self.tests.boxes.saturating_add(self.tests.shapes);
        Cost {
            tests: own.saturating_add(self.asked.tests),
            total_reflection: self.total > 0 || self.asked.total_reflection,
            slow: self.asked.slow.min(1),
        }
    }

    /// Adds the kernel's work on the sample to `all`, except the work on surfaces: see
    /// [`Tile::take_work`](super::Tile::take_work).
    #[inline]
    pub fn count(&self, all: &mut Counts) {
        all.rays.camera += 1;
        all.intersections.boxes += u64::from(self.tests.boxes);
        all.intersections.shape += u64::from(self.tests.shapes);
        if self.shadow + self.reflection + self.refraction + self.total + self.media == 0 {
            return;
        }
        all.rays.shadow += u64::from(self.shadow);
        all.rays.reflection += u64::from(self.reflection);
        all.rays.refraction += u64::from(self.refraction);
        all.rays.total += u64::from(self.total);
        all.work.shadow += u64::from(self.shadow);
        all.work.transparent_shadow += u64::from(self.transparent);
        all.work.reflection += u64::from(self.reflection);
        all.work.refraction += u64::from(self.refraction);
        all.work.medium_change += u64::from(self.media);
        all.work.channel_split += u64::from(self.parted);
    }
}
