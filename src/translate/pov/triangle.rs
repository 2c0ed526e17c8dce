//! Triangles with shading normals.

use super::shape::Primitive;
use super::text::vector;
use crate::scene::Vec3;

/// POV-Ray makes the normals of the corners equally long before it interpolates. Where they are not,
/// the triangle is cut into so many along each side, with its own normals at their corners.
const PARTS: usize = 24;

/// What the cut triangle's normals are off by at most, for the report.
pub const BOUND: &str = "off by less than a thousandth of the difference between two normals";

pub fn smooth(vertices: &[Vec3; 3], normals: &[Vec3; 3]) -> Primitive {
    let corner = |i: usize| format!("{}, {}", vector(&vertices[i]), vector(&normals[i]));
    if are_equally_long(normals) {
        return Primitive::new("smooth_triangle", [0, 1, 2].map(corner).join(", "));
    }
    let mut lines = Vec::new();
    let at = |i: usize, j: usize| {
        let (u, v) = (i as f64 / PARTS as f64, j as f64 / PARTS as f64);
        let mix = |from: &[Vec3; 3]| -> Vec3 {
            std::array::from_fn(|k| from[0][k] * (1.0 - u - v) + from[1][k] * u + from[2][k] * v)
        };
        format!("{}, {}", vector(&mix(vertices)), vector(&mix(normals)))
    };
    for i in 0..PARTS {
        for j in 0..PARTS - i {
            let mut part = |corners: [(usize, usize); 3]| {
                let corners = corners.map(|(i, j)| at(i, j));
                lines.push(format!("smooth_triangle {{ {} }}", corners.join(", ")));
            };
            part([(i, j), (i + 1, j), (i, j + 1)]);
            if i + j + 1 < PARTS {
                part([(i + 1, j), (i + 1, j + 1), (i, j + 1)]);
            }
        }
    }
    Primitive {
        keyword: "mesh",
        lines,
    }
}

/// Within rounding.
pub fn are_equally_long(normals: &[Vec3; 3]) -> bool {
    let lengths = normals.map(|n| n[0].hypot(n[1]).hypot(n[2]));
    lengths
        .iter()
        .all(|l| (l - lengths[0]).abs() <= 1e-9 * lengths[0])
}
