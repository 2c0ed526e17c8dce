//! Questions of the quick kernel to those who know.

use super::ray::Ray;
use super::stats::Cost;
use crate::geometry::vec::Vec3;

/// Answers what the kernel does not know.
pub(super) trait Arbiter {
    /// Adds the light that comes back along a ray, and along all rays that follow from it, to a list: each times its
    /// weight, in the order in which light is added up. Returns what that has cost.
    fn radiance(&mut self, ray: &Ray, weight: Vec3, depth: u32, light: &mut Vec<Vec3>) -> Cost;

    /// The share of light that gets along a ray to a lamp at t = 1, and what it has cost to know.
    fn visibility(&mut self, ray: &Ray) -> (Vec3, Cost);
}
