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
    /// The leaf whose surface it is; [`NONE`](super::query::NONE) for a face that is not on the way.
    pub surface: u32,
}

/// Children in the tree of an intersection still to be visited, with lower bounds on where the ray meets them:
/// `pending` are next, `beyond` are visited if the search gets that far.
#[derive(Debug, Default)]
pub struct Inner {
    pub pending: Vec<(f32, Child)>,
    pub beyond: Vec<(f32, Child)>,
}

/// Scratch memory kept from one search to the next.
#[derive(Debug, Default)]
pub struct Scratch {
    /// Children in the scene's tree still to be visited, with lower bounds on where the ray meets them.
    pub pending: Vec<(f32, Child)>,
    /// Transparent things on the way.
    pub passed: Vec<Passed>,
    /// Opaque things on the way that something transparent may hide, with their near faces.
    pub opaque: Vec<Passed>,
    /// The faces of the things in `passed`, each with the index of its thing.
    pub faces: Vec<(Face, u32)>,
    /// Crossings with later operands, leaf by leaf: from within an earlier operand they are not seen.
    pub hidden: Vec<(u32, End)>,
    /// Where the ray meets the leaf without lanes that was asked last.
    pub ahead: Vec<Crossing>,
    pub roots: Roots,
    /// The crossings with the operands of the intersection that was asked last.
    pub events: Vec<Crossing>,
    /// Operands with a crossing that is too near the start to say on which side of it. The flag: whether the ray goes
    /// into the operand there.
    pub at_start: Vec<(u32, bool)>,
    /// For each crossing in `events`, a lower bound on the t of it and of all behind it.
    pub least: Vec<f64>,
    /// For each gate of the intersection, the number of its unmet operands: see [`Csg`](super::csg::Csg).
    pub unmet: Vec<u32>,
    pub inner: Inner,
    /// The number of times that intersections have merged their crossings, or found the first place without a merge.
    pub merges: u64,
}
