//! Geometry of balls and ellipsoids.

use crate::geometry::Matrix;
use crate::scene::Vec3;
use crate::solids::contacts::directions::{Sample, direction as spread};

/// The unit vector in the direction of a vector; an arbitrary one if the vector has no direction.
pub fn direction(v: Vec3) -> Vec3 {
    super::circle::unit(v)
}

/// The length `x` plus `by`, which may be negative. `None` if less than half of `x` would be left.
pub fn grown(x: f64, by: f64) -> Option<f64> {
    Some(x + by).filter(|y| *y > x / 2.0)
}

/// The relative error with which a product of rotations still counts as even.
const EVEN: f64 = 1e-12;

/// The factor of a matrix that moves, turns and scales evenly, rounded up: no vector is stretched by more. `None` for
/// other matrices.
pub fn even_scale(m: &Matrix) -> Option<f64> {
    let column = |j: usize| -> Vec3 { std::array::from_fn(|i| m.0[i][j]) };
    let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let c: [Vec3; 3] = std::array::from_fn(column);
    let scale = dot(c[0], c[0]);
    let even = (1..3).all(|i| (dot(c[i], c[i]) - scale).abs() <= EVEN * scale)
        && (0..3).all(|i| dot(c[i], c[(i + 1) % 3]).abs() <= EVEN * scale);
    even.then(|| scale.sqrt() * (1.0 + EVEN))
}

/// Points of an ellipsoid with normals.
pub fn samples(centre: Vec3, axes: Vec3) -> Vec<Sample> {
    const COUNT: u32 = 24;
    (0..COUNT)
        .map(|i| {
            let d = spread(i, COUNT);
            (
                std::array::from_fn(|k| centre[k] + axes[k] * d[k]),
                std::array::from_fn(|k| d[k] / axes[k]),
            )
        })
        .collect()
}
