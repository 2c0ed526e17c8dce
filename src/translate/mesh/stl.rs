//! STL, binary: triangles and nothing besides.

use crate::geometry::array::{cross, dot};

/// The start of a file, for people to read. It must not begin with "solid": such files are taken for text.
const HEADER: &[u8] = b"made by zpg; lengths as in the scene, y is up";
const HEADER_BYTES: usize = 80;

/// The bytes of a triangle: its normal, three points, and two bytes without a meaning.
const TRIANGLE_BYTES: usize = 50;

/// The bytes of the file. A triangle that rounding has left without an area has the normal 0, which readers take for
/// unknown.
pub(super) fn write(places: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<u8> {
    let mut out = Vec::with_capacity(HEADER_BYTES + 4 + TRIANGLE_BYTES * triangles.len());
    out.extend_from_slice(HEADER);
    out.resize(HEADER_BYTES, 0);
    // The budget allows fewer triangles than a `u32` can count.
    out.extend_from_slice(&(triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        let corners = triangle.map(|point| places[point as usize]);
        for x in [normal(corners)].iter().chain(&corners).flatten() {
            out.extend_from_slice(&x.to_le_bytes());
        }
        out.extend_from_slice(&[0; 2]);
    }
    out
}

/// The unit normal of a triangle, on the side from which its corners run counter-clockwise; 0 for a triangle without
/// area.
fn normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let edge = |p: [f32; 3]| [0, 1, 2].map(|k| f64::from(p[k]) - f64::from(a[k]));
    let normal = cross(edge(b), edge(c));
    let length = dot(normal, normal).sqrt();
    match length > 0.0 && length.is_finite() {
        true => normal.map(|x| (x / length) as f32),
        false => [0.0; 3],
    }
}
