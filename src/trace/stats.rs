//! What rendering has cost, counted.

use serde::Serialize;
use std::ops::AddAssign;

/// Rays traced, by what they are for. A ray that goes straight on through a surface counts as
/// refraction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Rays {
    pub camera: u64,
    pub shadow: u64,
    pub reflection: u64,
    pub refraction: u64,
    /// Times that light was totally reflected; its rays are among `reflection`.
    #[serde(skip)]
    pub total: u64,
}

/// Intersection tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Intersections {
    /// With boxes of the hierarchies.
    #[serde(rename = "box")]
    pub boxes: u64,
    pub shape: u64,
}

/// All counters of one picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Counts {
    pub rays: Rays,
    pub intersections: Intersections,
    /// Rays about which something was closer than rounding errors: in doubles, those that were
    /// traced again in double-double.
    pub uncertain: u64,
}

impl AddAssign for Intersections {
    fn add_assign(&mut self, other: Intersections) {
        self.boxes += other.boxes;
        self.shape += other.shape;
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Counts) {
        self.rays.camera += other.rays.camera;
        self.rays.shadow += other.rays.shadow;
        self.rays.reflection += other.rays.reflection;
        self.rays.refraction += other.rays.refraction;
        self.rays.total += other.rays.total;
        self.intersections += other.intersections;
        self.uncertain += other.uncertain;
    }
}
