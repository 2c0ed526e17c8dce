//! Corners of triangles for files: each with the true surface's normal, and with surface coordinates if the triangle
//! shows a picture.

use super::surface_label::SurfaceLabel;
use super::triangle_mesh::Mesh;
use crate::geometry::array::{cross, length, sub};
use crate::parallel;
use crate::scene::Vec3;
use crate::trace::graph::Graph;

/// The share of the way from a corner to the middle of its triangle at which normal and surface coordinates are
/// looked up, so that the place is on the triangle's own side of an edge. The share is more than points are rounded,
/// and so small that normals and surface coordinates differ by a thousandth of their change across the triangle.
const ASIDE: f64 = 1e-3;

/// A corner of a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// A unit vector that points outwards.
    pub normal: Vec3,
    /// Texture coordinates without a seam inside the triangle; 0 if the triangle shows no picture.
    pub uv: [f64; 2],
}

/// The corners of every triangle. Triangles without area have normals of 0. Only triangles whose label is `pictured`
/// have surface coordinates.
pub fn corners(
    mesh: &Mesh,
    skins: &[SurfaceLabel],
    graph: &Graph,
    pictured: impl Fn(u32) -> bool + Sync,
) -> Vec<[Corner; 3]> {
    let of = |t: usize| {
        let none = Corner {
            normal: [0.0; 3],
            uv: [0.0; 2],
        };
        let label = mesh.labels[t];
        let at = mesh.corners(t);
        let [a, b, c] = at;
        let n = cross(sub(b, a), sub(c, a));
        let length = length(n);
        let Some(skin) = skins.get(label as usize).filter(|_| length > 0.0) else {
            return [none; 3];
        };
        let flat = n.map(|x| x / length);
        let middle: Vec3 = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
        let pictured = pictured(label);
        let around = pictured.then(|| skin.uv(graph, middle, flat)).flatten();
        at.map(|p| {
            let near: Vec3 = std::array::from_fn(|i| p[i] + ASIDE * (middle[i] - p[i]));
            let normal = skin.shading_normal(graph, near, flat).unwrap_or(flat);
            let uv = around.and_then(|around| {
                let uv = skin.uv(graph, near, flat)?;
                let turns = skin.turns(graph);
                Some(std::array::from_fn(|i| match turns[i] {
                    // The coordinate is moved to the side of the seam that the triangle's middle is on.
                    true => uv[i] - (uv[i] - around[i]).round(),
                    false => uv[i],
                }))
            });
            Corner {
                normal,
                uv: uv.unwrap_or([0.0; 2]),
            }
        })
    };
    parallel::map(mesh.triangles.len(), of)
}
