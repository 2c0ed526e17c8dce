//! Triangles with shading normals.

use crate::geometry::array::length;
use crate::scene::{Geometry, TriangleNormals, Vec3};
use crate::translate::pov::budget::{Budget, Limit};

/// The largest error of the normals, as a fraction of their differences. Its effect on a colour is less than half a
/// step of a picture with 8 bits.
const OFF: f64 = 1e-3;

/// The bound on the error of the cut triangle's normals, for the report.
pub(super) const BOUND: &str =
    "off by less than a thousandth of the difference between two normals";

/// Cuts a triangle with vertex normals into pieces. POV-Ray makes the normals of the corners equally long before it
/// interpolates, so the normals inside are wrong where lengths differ. The pieces have the triangle's interpolated
/// normals at their corners, which makes the error small. If the normals are equally long, the triangle itself is the
/// only piece.
pub(super) fn cut(vertices: &[Vec3; 3], normals: &[Vec3; 3], budget: &Budget) -> Vec<Geometry> {
    let parts = parts(normals);
    let parts = match budget.spend(Limit::TrianglePieces, parts) {
        true => parts,
        false => Limit::TrianglePieces.most(),
    };
    let at = |(i, j): (usize, usize), from: &[Vec3; 3]| -> Vec3 {
        let (u, v) = (i as f64 / parts as f64, j as f64 / parts as f64);
        std::array::from_fn(|k| from[0][k] * (1.0 - u - v) + from[1][k] * u + from[2][k] * v)
    };
    let part = |corners: [(usize, usize); 3]| Geometry::Triangle {
        vertices: Box::new(corners.map(|c| at(c, vertices))),
        normals: TriangleNormals::PerVertex(Box::new(corners.map(|c| at(c, normals)))),
    };
    let mut all = Vec::new();
    for i in 0..parts {
        for j in 0..parts - i {
            all.push(part([(i, j), (i + 1, j), (i, j + 1)]));
            if i + j + 1 < parts {
                all.push(part([(i + 1, j), (i + 1, j + 1), (i, j + 1)]));
            }
        }
    }
    all
}

/// The number of pieces along each side. If one of two normals is longer than the other by a fraction ρ, interpolating
/// between normals of equal length is off by up to ρ/4 of their difference. In n pieces, ρ and the difference are n
/// times less, and the error is ρ/4n².
fn parts(normals: &[Vec3; 3]) -> usize {
    let lengths = normals.map(length);
    let most = lengths.iter().fold(0.0f64, |m, l| m.max(*l));
    let least = lengths.iter().fold(most, |m, l| m.min(*l));
    let parts = ((most / least - 1.0) / (4.0 * OFF)).sqrt().ceil();
    // A normal of length 0 gives NaN or a very large number.
    match parts.is_nan() {
        true => usize::MAX,
        false => (parts as usize).max(1),
    }
}

/// Whether normals are equally long within rounding, including the rounding of normals that were written with ten
/// digits.
pub(super) fn are_equally_long(normals: &[Vec3; 3]) -> bool {
    let lengths = normals.map(length);
    lengths
        .iter()
        .all(|l| (l - lengths[0]).abs() <= 1e-9 * lengths[0])
}
