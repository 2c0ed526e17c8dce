//! Directions along which no scene is built.

use crate::scene::Vec3;

/// A point of a surface and the direction at right angles to it.
pub type Sample = (Vec3, Vec3);

/// The sine and cosine of `i` golden angles plus 0.3 radians.
pub fn turn(i: u32) -> (f64, f64) {
    (f64::from(i) * 2.399_963 + 0.3).sin_cos()
}

/// The `i`-th of `count` unit vectors spread evenly over the sphere.
pub fn direction(i: u32, count: u32) -> Vec3 {
    let y = 1.0 - (2.0 * f64::from(i) + 1.037) / f64::from(count);
    let (sin, cos) = turn(i);
    let ring = (1.0 - y * y).sqrt();
    [ring * cos, y, ring * sin]
}
