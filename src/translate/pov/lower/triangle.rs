//! Triangles with shading normals.

use crate::geometry::array::length;
use crate::scene::{Geometry, TriangleNormals, Vec3};
use crate::translate::pov::budget::{Budget, Limit};

/// The normals may be off by this share of their differences: what that does to a colour is less than
/// half a step of a picture with 8 bits.
const OFF: f64 = 1e-3;

/// The bound on the error of the cut triangle's normals, for the report.
pub(super) const BOUND: &str =
    "off by less than a thousandth of the difference between two normals";

/// POV-Ray makes the normals of the corners equally long before it interpolates. Where they are not, the triangle is cut
/// into pieces with its own normals at their corners: triangles whose interpolated normals are those of one: itself, where its normals are equally long.
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

/// Between two normals one of which is longer by a part ρ, equally long ones are off by up to ρ/4 of
/// their difference; in n parts, where ρ and the differences are n times less, by ρ/4n².
fn parts(normals: &[Vec3; 3]) -> usize {
    let lengths = normals.map(length);
    let most = lengths.iter().fold(0.0f64, |m, l| m.max(*l));
    let least = lengths.iter().fold(most, |m, l| m.min(*l));
    let parts = ((most / least - 1.0) / (4.0 * OFF)).sqrt().ceil();
    // No number, or a very large one, for a normal without length.
    match parts.is_nan() {
        true => usize::MAX,
        false => (parts as usize).max(1),
    }
}

/// Whether normals are equally long within rounding, also that of normals that were written with ten digits.
pub(super) fn are_equally_long(normals: &[Vec3; 3]) -> bool {
    let lengths = normals.map(length);
    lengths
        .iter()
        .all(|l| (l - lengths[0]).abs() <= 1e-9 * lengths[0])
}
