//! Scratch memory kept from one search to the next, so that nothing is allocated for a ray.

use super::query::{Crossing, End};
use crate::geometry::wide_bvh::Child;
use crate::trace::shapes::Roots;

/// Something transparent that light passes.
#[derive(Debug, Clone, Copy)]
pub struct Passed {
    pub leaf: u32,
    pub near: Face,
    pub far: Face,
}

/// Where light goes into something or out of it.
#[derive(Debug, Clone, Copy)]
pub struct Face {
    pub end: End,
    /// The leaf whose surface it is; [`NONE`](super::query::NONE): none that is on the way.
    pub surface: u32,
}

/// Children in the tree of an intersection still to be visited, with bounds from below on where they are met: next, and
/// perhaps later.
#[derive(Debug, Default)]
pub struct Inner {
    pub pending: Vec<(f32, Child)>,
    pub beyond: Vec<(f32, Child)>,
}

/// Scratch memory kept from one search to the next.
#[derive(Debug, Default)]
pub struct Scratch {
    /// Children still to be visited, with bounds from below on where they are met.
    pub pending: Vec<(f32, Child)>,
    /// Transparent things on the way.
    pub passed: Vec<Passed>,
    /// Opaque things on the way that something transparent may hide, with their near faces.
    pub opaque: Vec<Passed>,
    /// Faces of what is passed, and which of them each is of.
    pub faces: Vec<(Face, u32)>,
    /// Crossings with later operands, which are not seen from within an earlier one, leaf by leaf.
    pub hidden: Vec<(u32, End)>,
    /// Where the last leaf without lanes is met.
    pub ahead: Vec<Crossing>,
    pub roots: Roots,
    /// With the operands of the last intersection.
    pub events: Vec<Crossing>,
    /// Operands whose crossings are too near the start to say on which side of it; whether the ray goes in.
    pub at_start: Vec<(u32, bool)>,
    /// The least t of each of them and all behind it.
    pub least: Vec<f64>,
    /// Of each gate of it, how many operands are unmet: see [`Csg`](super::csg::Csg).
    pub unmet: Vec<u32>,
    pub inner: Inner,
    /// How many lists of crossings intersections have merged.
    pub merges: u64,
}
