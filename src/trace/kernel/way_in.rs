//! The way into the space of a shape, and what it rounds.

use crate::geometry::affine::Affine;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;

/// The way into the space of a shape.
#[derive(Debug, Clone)]
pub struct WayIn {
    pub back: Affine,
    /// Bounds on the sums of the sizes of all terms on the way: for a point with coordinates of size 1, and for the
    /// offsets of the maps.
    pub sizes: [f64; 2],
}

/// A bound on the rounding on the way into a shape's space, as a share of the sizes of the terms of a point.
pub const REL_ROUNDED: f64 = 1e-13;

impl WayIn {
    /// Through a chain of placements, the outermost first.
    pub fn new(graph: &Graph, chain: &[u32]) -> WayIn {
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (mut rows, mut offset) = (identity.map(Vec3), Vec3::ZERO);
        let (mut sums, mut added) = (rows, offset);
        for &placement in chain {
            let back = &graph.placements[placement as usize].back;
            let of = |row: Vec3, m: [Vec3; 3]| m[0] * row[0] + m[1] * row[1] + m[2] * row[2];
            offset = back.point(offset);
            added = back.sizes(added) + back.offset.abs();
            rows = back.rows.map(|row| of(row, rows));
            sums = back.rows.map(|row| of(row.abs(), sums));
        }
        let sums = sums.map(|row| row.dot(Vec3::ONE));
        WayIn {
            back: Affine::of(rows, offset),
            sizes: [sums.into_iter().fold(0.0, f64::max), added.max_component()],
        }
    }
}
