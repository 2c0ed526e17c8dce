//! Where four rays have met a shape each.

use super::lanes::{LANES, Lanes, V3};
use super::leaf::Leaf;
use crate::geometry::vec::Vec3;

/// Points of surfaces, in the scene's space.
#[derive(Debug, Clone, Copy)]
pub struct Resolved {
    /// A mask: where no rounding has decided that the shape is met.
    pub clear: Lanes,
    pub t: Lanes,
    pub point: V3,
    /// Bounds on the error of the point, component by component.
    pub error: V3,
    /// Unit, outwards.
    pub normal: V3,
}

/// A kind of shape, as four rays meet four of it.
pub trait Meet {
    /// Where rays meet leaves in the space of these: at the far ends of chords where `exit` is set.
    fn meet(leaves: [&Leaf; LANES], origin: V3, direction: V3, exit: Lanes) -> Resolved;

    /// The face with this normal: see [`Root::face`](crate::trace::shapes::Root::face).
    fn face(_normal: Vec3) -> u32 {
        0
    }
}
