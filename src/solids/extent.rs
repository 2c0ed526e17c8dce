//! The distances by which things reach out of a volume, and from a point.

use super::distance;
use super::leaf::Leaf;
use super::shapes::AnyShape;
use super::shapes::ball::{self, even_scale};
use super::tree::Tree;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Scene, Vec3, Volume};

/// Share of a volume's size up to which a thing may reach out of it without a report: numbers in scenes are often
/// written with six or seven digits.
pub const WRITTEN: f64 = 1e-6;

/// Distance by which a point is outside of a volume; below zero inside.
pub fn beyond(volume: &Volume, p: Vec3) -> f64 {
    match volume {
        Volume::Box { min, max } => (0..3)
            .map(|i| (p[i] - max[i]).max(min[i] - p[i]))
            .fold(f64::NEG_INFINITY, f64::max),
        Volume::Sphere { centre, radius } => distance(p, *centre) - radius,
    }
}

/// The largest number with which a volume is written, in absolute value: it grows with the volume's extent and with its
/// distance from the origin.
pub fn size(volume: &Volume) -> f64 {
    let of = |points: [Vec3; 2]| points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    match volume {
        Volume::Box { min, max } => of([*min, *max]),
        Volume::Sphere { centre, radius } => of([*centre, [*radius; 3]]),
    }
}

/// Distance by which the point of a box that is furthest out is outside of a volume.
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
    // The result is rounded up by more than the five roundings in a row.
    reach[0].hypot(reach[1]).hypot(reach[2]) * (1.0 + 8.0 * f64::EPSILON)
}

/// The centre and the radius of a shape that is a ball in its place: a sphere that is moved, turned and scaled evenly.
/// `None` for other shapes.
pub fn ball(scene: &Scene, shape: u32, m: &Matrix) -> Option<(Vec3, f64)> {
    let Geometry::Sphere { centre, radius } = scene.shapes[shape as usize].geometry else {
        return None;
    };
    Some((m.point(centre), radius * even_scale(m)?))
}

/// An upper bound, up to rounding, on the distance of the leaves' points from a point.
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

impl Geometry {
    /// An upper bound, up to rounding, on the distance of the moved shape's points from a point. `None` if none is
    /// known that is closer than a box's.
    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        match AnyShape::of(self) {
            AnyShape::Cuboid(s) => {
                let each = (0..8).map(|k| distance(m.point(s.corner(k)), p));
                Some(each.fold(0.0, f64::max))
            }
            AnyShape::GeodesicSphere(s) => {
                Some(distance(m.point([0.0; 3]), p) + s.radius * ball::even_scale(m)?)
            }
            AnyShape::Rectangle(s) => {
                let (min, max) = (s.min, s.max);
                let corner = |k: usize| {
                    let x = if k & 1 == 0 { min[0] } else { max[0] };
                    [x, if k & 2 == 0 { min[1] } else { max[1] }, 0.0]
                };
                let each = (0..4).map(|k| distance(m.point(corner(k)), p));
                Some(each.fold(0.0, f64::max))
            }
            AnyShape::Sphere(s) => {
                Some(distance(m.point(s.centre), p) + s.radius * ball::even_scale(m)?)
            }
            AnyShape::Torus(s) => {
                let scale = ball::even_scale(m)?;
                // The distance of the furthest point of the tube's core, and the radius of the tube on top.
                let [x, y, z] = m.inverse()?.point(p);
                Some(scale * ((x.hypot(z) + s.major).hypot(y) + s.minor))
            }
            AnyShape::Triangle(s) => {
                let each = s.vertices.iter().map(|&q| distance(m.point(q), p));
                Some(each.fold(0.0, f64::max))
            }
            AnyShape::Cone(_)
            | AnyShape::Ellipsoid(_)
            | AnyShape::HalfSpace(_)
            | AnyShape::Quadric(_)
            | AnyShape::Revolution(_) => None,
        }
    }
}
