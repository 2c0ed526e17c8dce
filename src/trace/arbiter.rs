//! Questions that the quick kernel cannot answer, and passes on to the full tracer.

use super::ray::Ray;
use super::stats::Cost;
use crate::geometry::vec::Vec3;

/// Answers questions about rays that the quick kernel cannot decide.
pub(super) trait Arbiter {
    /// Appends to `light` the light that comes back along a ray and along each ray that follows from it: each times its
    /// weight, in the order in which light is added up. Returns the cost.
    fn radiance(&mut self, ray: &Ray, weight: Vec3, depth: u32, light: &mut Vec<Vec3>) -> Cost;

    /// The share of light, per channel, that gets along a ray from a lamp at t = 1, and the cost of the answer.
    fn visibility(&mut self, ray: &Ray) -> (Vec3, Cost);
}
