//! Circles about the y axis.

use crate::scene::Vec3;
use crate::solids::contacts::quadric::QuadricMatrix;

/// The number of corners of the polygon around a circle.
const CORNERS: usize = 64;

/// The corners of a polygon around a circle about the y axis.
pub fn around(radius: f64, y: f64) -> impl Iterator<Item = Vec3> {
    let radius = radius / (std::f64::consts::PI / CORNERS as f64).cos();
    (0..CORNERS).map(move |i| {
        let angle = i as f64 * (std::f64::consts::TAU / CORNERS as f64);
        [radius * angle.cos(), y, radius * angle.sin()]
    })
}

/// The point of a circle about the y axis that is furthest in a direction.
pub fn towards(d: Vec3, radius: f64, y: f64) -> Vec3 {
    let [x, z] = unit([d[0], d[2]]);
    [radius * x, y, radius * z]
}

/// The matrix of x² + z² = (slope·y + start)².
pub fn cone(slope: f64, start: f64) -> QuadricMatrix {
    let mut out = [[0.0; 4]; 4];
    (out[0][0], out[1][1], out[2][2]) = (1.0, -slope * slope, 1.0);
    (out[1][3], out[3][1], out[3][3]) = (-slope * start, -slope * start, -start * start);
    out
}

/// The unit vector in the direction of a vector; an arbitrary one if the vector has no direction.
pub fn unit<const N: usize>(v: [f64; N]) -> [f64; N] {
    let largest = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return std::array::from_fn(|i| f64::from(u8::from(i == 0)));
    }
    let v = v.map(|x| x / largest);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}
