//! The facets of a geodesic sphere.

use crate::geometry::array::{cross, dot, unit};
use crate::geometry::icosahedron;
use crate::scene::Vec3;

/// The corners of the facet that a direction goes through, of the sphere of radius 1.
pub fn facet(d: Vec3, splits: u32) -> [Vec3; 3] {
    let mut corners = icosahedron::vertices();
    // Every facet of an icosahedron has the three corners that are nearest to what goes through it.
    corners.sort_by(|a, b| dot(*b, d).total_cmp(&dot(*a, d)));
    let mut facet = [corners[0], corners[1], corners[2]];
    for _ in 0..splits {
        let [a, b, c] = facet;
        let middle = |p: Vec3, q: Vec3| -> Vec3 {
            let sum: Vec3 = std::array::from_fn(|k| p[k] + q[k]);
            unit(sum).unwrap_or(p)
        };
        let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
        // Planes through the middle of the sphere part the four.
        let parts = [[a, p, r], [b, q, p], [c, r, q]];
        let through = |[corner, u, v]: &[Vec3; 3]| {
            let n = cross(*u, *v);
            dot(n, d) * dot(n, *corner) > 0.0
        };
        facet = parts.into_iter().find(through).unwrap_or([p, q, r]);
    }
    facet
}
