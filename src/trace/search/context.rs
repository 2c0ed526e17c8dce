//! The way of a ray in the graph: the objects entered on the way down from the root.

use crate::geometry::line::{Line, Traced};
use crate::geometry::wide_bvh::Beam;

/// An occurrence of a part: the index of the part in the graph, and the number of the context whose object it belongs
/// to. The part is a shape or an object; only shapes are crossed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Leaf {
    pub part: u32,
    pub context: u32,
}

/// A texture, and the space that it is painted in: below the placement, in the space of the context.
#[derive(Debug, Clone, Copy)]
pub struct Painted {
    pub texture: u32,
    pub placement: u32,
    pub context: u32,
}

/// An object entered on the way down from the root, with the placements and properties above it.
#[derive(Debug, Clone, Copy)]
pub struct Context<R: Traced = f64> {
    pub object: u32,
    /// The ray in the object's space.
    pub line: Line<R>,
    /// The ray in the units of the object's tree.
    pub beam: Beam,
    /// The context that this one was entered from; the root is its own parent.
    pub parent: u32,
    /// The part of the parent's object that was entered.
    pub part: u32,
    pub depth: u32,
    /// A number for the chain of placements from the scene's space down to this one.
    pub(in crate::trace) key: u64,
    pub(in crate::trace) texture: Option<Painted>,
    pub(in crate::trace) optics: Option<u32>,
    pub(in crate::trace) index: Option<u32>,
    /// ID of the outermost entity above that was given properties; 0 if there is none.
    pub(in crate::trace) owner: u32,
}
