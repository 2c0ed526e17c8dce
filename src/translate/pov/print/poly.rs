//! Solids bounded by polynomials. POV-Ray takes a point to be inside of such a solid if the polynomial's value is below
//! 1e-4, so the coefficients are made large.

use super::shape::{Primitive, size_unit};
use crate::translate::number;

/// The largest coefficient that is written. POV-Ray's tolerance is 1e-10 of it.
const MAX_COEFFICIENT: f64 = 1e6;

/// The matrix Q of a quadric xᵀQx ≤ 0, row by row, with these factors of x², y², z² and y, and this constant.
pub(super) fn diagonal(x: f64, y: f64, z: f64, linear: f64, constant: f64) -> [f64; 16] {
    let mut q = [0.0; 16];
    (q[0], q[5], q[10], q[13], q[15]) = (x, y, z, linear, constant);
    q
}

pub(super) fn quadric(q: &[f64; 16]) -> Primitive {
    let largest = q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let q = q.map(|x| x / largest);
    // The coefficients of x², xy, xz, x, y², yz, y, z², z and 1, in this order.
    let coefficients = [
        q[0],
        q[1] + q[4],
        q[2] + q[8],
        q[3] + q[12],
        q[5],
        q[6] + q[9],
        q[7] + q[13],
        q[10],
        q[11] + q[14],
        q[15],
    ];
    let most = |which: &[usize]| {
        which
            .iter()
            .fold(0.0f64, |m, i| m.max(coefficients[*i].abs()))
    };
    let square = most(&[0, 1, 2, 4, 5, 7]);
    let linear = most(&[3, 6, 8]);
    let constant = most(&[9]);
    // The size of the surface follows from those of its terms that balance each other.
    let size = match (square > 0.0, linear > 0.0, constant > 0.0) {
        (true, true, _) => (linear / square).max((constant / square).sqrt()),
        (true, false, true) => (constant / square).sqrt(),
        (false, true, true) => constant / linear,
        _ => 1.0,
    };
    let unit = size_unit(size);
    let mut scaled = coefficients;
    for (i, c) in scaled.iter_mut().enumerate() {
        *c *= match i {
            3 | 6 | 8 => unit,
            9 => 1.0,
            _ => unit * unit,
        };
    }
    let most = scaled.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let list: Vec<String> = scaled
        .iter()
        .map(|c| number(c / most * MAX_COEFFICIENT))
        .collect();
    Primitive::new("poly", format!("2, <{}>", list.join(", "))).scaled(unit)
}

/// The torus with the ring's radius R and the tube's radius r, as a quartic: (x² + y² + z² + R² − r²)² − 4R²(x² + z²) ≤
/// 0.
pub(super) fn quartic_torus(major: f64, minor: f64) -> Primitive {
    let k = (major - minor) * (major + minor);
    let ring = 4.0 * major * major;
    let terms = [
        ([4, 0, 0], 1.0),
        ([0, 4, 0], 1.0),
        ([0, 0, 4], 1.0),
        ([2, 2, 0], 2.0),
        ([2, 0, 2], 2.0),
        ([0, 2, 2], 2.0),
        ([2, 0, 0], 2.0 * k - ring),
        ([0, 2, 0], 2.0 * k),
        ([0, 0, 2], 2.0 * k - ring),
        ([0, 0, 0], k * k),
    ];
    let list: Vec<String> = terms
        .iter()
        .map(|([x, y, z], c)| format!("xyz({x}, {y}, {z}): {}", number(c * MAX_COEFFICIENT)))
        .collect();
    Primitive::new("polynomial", format!("4, {} sturm", list.join(", ")))
}
