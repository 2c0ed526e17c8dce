//! How far things reach: out of a volume, and from a point.

use super::distance;
use super::leaf::Leaf;
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

/// How far from even a product of rotations may be.
const EVEN: f64 = 1e-12;

/// The factor of a matrix that moves, turns and scales evenly, and a little more: what it stretches
/// most is stretched by less.
fn even_scale(m: &Matrix) -> Option<f64> {
    let column = |j: usize| -> Vec3 { std::array::from_fn(|i| m.0[i][j]) };
    let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let c: [Vec3; 3] = std::array::from_fn(column);
    let scale = dot(c[0], c[0]);
    let even = (1..3).all(|i| (dot(c[i], c[i]) - scale).abs() <= EVEN * scale)
        && (0..3).all(|i| dot(c[i], c[(i + 1) % 3]).abs() <= EVEN * scale);
    even.then(|| scale.sqrt() * (1.0 + EVEN))
}

/// A distance from a point that nothing of a moved shape exceeds by more than rounding, where that is
/// known more closely than by a box.
fn farthest_point(geometry: &Geometry, m: &Matrix, p: Vec3) -> Option<f64> {
    let of = |points: &[Vec3]| {
        let each = points.iter().map(|&q| distance(m.point(q), p));
        Some(each.fold(0.0, f64::max))
    };
    match *geometry {
        Geometry::Sphere { centre, radius } => {
            Some(distance(m.point(centre), p) + radius * even_scale(m)?)
        }
        Geometry::GeodesicSphere { radius, .. } => {
            Some(distance(m.point([0.0; 3]), p) + radius * even_scale(m)?)
        }
        Geometry::Torus { major, minor } => {
            let scale = even_scale(m)?;
            // The point of the tube's core that is furthest away, and from there as much further.
            let [x, y, z] = m.inverse()?.point(p);
            Some(scale * ((x.hypot(z) + major).hypot(y) + minor))
        }
        Geometry::Box { min, max } => of(&std::array::from_fn::<_, 8, _>(|k| {
            std::array::from_fn(|i| if k >> i & 1 == 0 { min[i] } else { max[i] })
        })),
        Geometry::Rectangle { min, max } => of(&std::array::from_fn::<_, 4, _>(|k| {
            let x = if k & 1 == 0 { min[0] } else { max[0] };
            [x, if k & 2 == 0 { min[1] } else { max[1] }, 0.0]
        })),
        Geometry::Triangle { ref vertices, .. } => of(vertices),
        _ => None,
    }
}

/// A distance from a point that nothing of the leaves exceeds, and its rounding.
pub fn farthest_leaf(scene: &Scene, tree: &Tree, whole: &Aabb, p: Vec3) -> f64 {
    let of = |leaf: &Leaf| {
        let geometry = leaf.shape.map(|s| &scene.shapes[s as usize].geometry);
        let closer = geometry.and_then(|g| farthest_point(g, &leaf.matrix, p));
        let boxed = farthest(&leaf.bounds, p);
        closer.map_or(boxed, |d| boxed.min(d))
    };
    let leaves = tree.leaves.iter().map(of).fold(0.0, f64::max);
    leaves.min(farthest(whole, p))
}
