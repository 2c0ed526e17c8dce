//! Where four rays have met a shape each.

use super::lanes::{Lanes, V3};

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
