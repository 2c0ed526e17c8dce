//! How far things reach: out of a volume, and from a point.

use super::distance;
use super::leaf::Leaf;
use super::shapes::ball::even_scale;
use super::shapes::facts::Facts;
use super::tree::Tree;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Scene, Vec3, Volume};

/// What is outside by less than this share of a volume's size is not reported: numbers in scenes
/// are often written with six or seven digits.
pub const WRITTEN: f64 = 1e-6;

/// By how much a point is outside of a volume; below zero inside.
pub fn beyond(volume: &Volume, p: Vec3) -> f64 {
    match volume {
        Volume::Box { min, max } => (0..3)
            .map(|i| (p[i] - max[i]).max(min[i] - p[i]))
            .fold(f64::NEG_INFINITY, f64::max),
        Volume::Sphere { centre, radius } => distance(p, *centre) - radius,
    }
}

/// The size that a volume's numbers are written with: its extent, and how far it is away.
pub fn size(volume: &Volume) -> f64 {
    let of = |points: [Vec3; 2]| points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    match volume {
        Volume::Box { min, max } => of([*min, *max]),
        Volume::Sphere { centre, radius } => of([*centre, [*radius; 3]]),
    }
}

/// By how much the point of a box that is furthest out is outside of a volume.
pub fn farthest_out(volume: &Volume, b: &Aabb) -> f64 {
    match volume {
        Volume::Box { .. } => beyond(volume, b.min).max(beyond(volume, b.max)),
        Volume::Sphere { centre, radius } => farthest(b, *centre) - radius,
    }
}

/// The largest distance of a box's points from a point.
pub fn farthest(b: &Aabb, p: Vec3) -> f64 {
    if b.is_empty() {
        return 0.0;
    }
    let reach: Vec3 = std::array::from_fn(|i| (b.max[i] - p[i]).abs().max((p[i] - b.min[i]).abs()));
    // Five roundings in a row, upwards.
    reach[0].hypot(reach[1]).hypot(reach[2]) * (1.0 + 8.0 * f64::EPSILON)
}

/// A ball and its place, where a leaf is one: spheres that are moved, turned and scaled evenly.
pub fn ball(scene: &Scene, shape: u32, m: &Matrix) -> Option<(Vec3, f64)> {
    let Geometry::Sphere { centre, radius } = scene.shapes[shape as usize].geometry else {
        return None;
    };
    Some((m.point(centre), radius * even_scale(m)?))
}

/// A distance from a point that nothing of the leaves exceeds, and its rounding.
pub fn farthest_leaf(scene: &Scene, tree: &Tree, whole: &Aabb, p: Vec3) -> f64 {
    let of = |leaf: &Leaf| {
        let geometry = leaf.shape.map(|s| &scene.shapes[s as usize].geometry);
        let closer = geometry.and_then(|g| g.farthest(&leaf.matrix, p));
        let boxed = farthest(&leaf.bounds, p);
        closer.map_or(boxed, |d| boxed.min(d))
    };
    let leaves = tree.leaves.iter().map(of).fold(0.0, f64::max);
    leaves.min(farthest(whole, p))
}
