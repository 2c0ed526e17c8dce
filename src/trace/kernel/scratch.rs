//! What is kept from one search to the next, so that nothing is allocated for a ray.

use super::query::{Crossing, End};
use crate::geometry::wide_bvh::Child;
use crate::trace::shapes::Roots;

/// Something transparent that light passes.
#[derive(Debug, Clone, Copy)]
pub struct Passed {
    pub leaf: u32,
    pub near: End,
    pub far: End,
    /// How many of its faces are on the way.
    pub faces: u32,
}

/// What is kept from one search to the next.
#[derive(Debug, Default)]
pub struct Scratch {
    /// What is still to be visited, with bounds from below on where it is met.
    pub pending: Vec<(f32, Child)>,
    /// Transparent things on the way.
    pub passed: Vec<Passed>,
    /// Crossings with later operands, which are not seen from within an earlier one, leaf by leaf.
    pub hidden: Vec<(u32, End)>,
    /// Where the last leaf without lanes is met.
    pub ahead: Vec<Crossing>,
    pub roots: Roots,
    /// With the operands of the last intersection.
    pub events: Vec<Crossing>,
    /// The least t of each of them and all behind it.
    pub least: Vec<f64>,
    /// Of each gate of it, how many operands keep the place from being in it: see [`Csg`](super::csg::Csg).
    pub wrong: Vec<u32>,
    pub inner: Vec<Child>,
    /// How many lists of crossings intersections have merged.
    pub merges: u64,
}
