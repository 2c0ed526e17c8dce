//! Whether a point is in a shape, in the shape's coordinates.

use super::shapes::facts::Facts;
use crate::scene::{Geometry, Vec3};

/// Whether a point is in a shape, decided exactly on the shape's numbers. A point that is not finite is in no shape.
pub fn in_shape(geometry: &Geometry, p: Vec3) -> bool {
    p.iter().all(|x| x.is_finite()) && geometry.holds(p)
}
