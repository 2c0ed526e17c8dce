//! Where four rays have met a shape each.

use super::lanes::{LANES, Lanes, V3};
use super::leaf::Leaf;
use crate::geometry::vec::Vec3;

/// The points where four rays meet their shapes, in the space of the rays.
#[derive(Debug, Clone, Copy)]
pub struct Resolved {
    /// A mask: the lanes that surely meet the shape, whatever is rounded.
    pub clear: Lanes,
    pub t: Lanes,
    pub point: V3,
    /// Bounds on the error of the point, component by component.
    pub error: V3,
    /// The outward normal, of any length.
    pub normal: V3,
}

/// A kind of shape of which four rays meet one each.
pub trait Meet {
    /// Whether a shape may have normals of its own for shading.
    const IS_SMOOTH: bool = false;

    /// The points where rays meet their leaves, for rays in the spaces of the leaves: at the far ends of chords where
    /// `exit` is set, elsewhere at the near ends.
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, exit: Lanes) -> Resolved;

    /// The face with this normal: see [`Root::face`](crate::trace::shapes::Root::face).
    fn face(_normal: Vec3) -> u32 {
        0
    }
}
