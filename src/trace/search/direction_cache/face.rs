//! One face of the cube, with its grid.

use super::body::{DISTANCE_REL_ERROR, Octagon, ROUNDED};
use crate::geometry::array::each;
use crate::geometry::wide_bvh::below;
use std::iter;
use wide::f32x8;

/// Widening of octagons, in units of the longer side. In single precision the sum of two coordinates is known to less
/// than 2⁻²².
const OCTAGON_WIDENING: f64 = 1e-6;
/// Cells of a face for each body that is seen through it.
const CELLS_PER_BODY: f64 = 4.0;
/// Most cells in a row of a face.
const MAX_CELLS_PER_ROW: f64 = 256.0;

/// One face of the cube. Its own coordinates, u and v, are the other two components of a direction over the largest one.
/// Places on it are measured from the lower corner of what is seen, in units of the longer side.
#[derive(Debug, Default)]
pub(super) struct Face {
    lower: [f64; 2],
    /// Units per 1 of u and v.
    scale: f64,
    /// Cells per unit.
    cells: [f32; 2],
    /// Cells in a row, and rows.
    side: usize,
    /// Where the list of each cell begins in `lists`; the last one is the end of all.
    starts: Vec<u32>,
    lists: Vec<VisibleBody>,
}

/// A body as it is seen through a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct VisibleBody {
    /// Index of the body among those of the cache.
    pub index: u32,
    /// No point of it is nearer.
    pub near: f32,
    /// The octagon around it: the least x, y, x + y and x − y, and then the least −x, −y, −(x + y) and −(x − y). One
    /// comparison tests all eight sides.
    sides: [f32; 8],
}

impl Face {
    /// A face of bodies with their distances and octagons, the nearest first.
    pub(super) fn new(bodies: &[(u32, f64, Octagon)]) -> Face {
        if bodies.is_empty() {
            return Face::default();
        }
        let mut lower = [f64::INFINITY; 2];
        let mut upper = [f64::NEG_INFINITY; 2];
        for (.., Octagon([least, most])) in bodies {
            lower = each([0, 1], |i| lower[i].min(least[i]));
            upper = each([0, 1], |i| upper[i].max(most[i]));
        }
        let size = each([0, 1], |i| (upper[i] - lower[i]).max(DISTANCE_REL_ERROR));
        // How many bodies lie behind one another, on average.
        let share = |i: usize, Octagon([least, most]): &Octagon| (most[i] - least[i]) / size[i];
        let shares = bodies.iter().map(|(.., o)| share(0, o) * share(1, o));
        let depth = shares.sum::<f64>().max(1.0);
        let side = (CELLS_PER_BODY * bodies.len() as f64 / depth)
            .sqrt()
            .ceil()
            .clamp(1.0, MAX_CELLS_PER_ROW);
        let scale = size[0].max(size[1]).recip();
        let cells = each(size, |size| (side / (size * scale)) as f32);
        let start = [lower[0], lower[1], lower[0] + lower[1], lower[0] - lower[1]];
        let margin = OCTAGON_WIDENING + ROUNDED * scale;
        let seen: Vec<VisibleBody> = bodies
            .iter()
            .map(|&(index, near, Octagon([least, most]))| {
                let low: [f32; 4] = each([0, 1, 2, 3], |i| {
                    below((least[i] - start[i]) * scale - margin)
                });
                let high: [f32; 4] = each([0, 1, 2, 3], |i| {
                    below((start[i] - most[i]) * scale - margin)
                });
                VisibleBody {
                    index,
                    // Infinite ones are far, but not beyond what a ray may meet.
                    near: below(near.min(f32::MAX.into())),
                    sides: [
                        low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3],
                    ],
                }
            })
            .collect();
        let side = side as usize;
        let mut starts = vec![0; side * side + 1];
        let cells_of = |seen: &VisibleBody| {
            let [columns, rows] = [0, 1].map(|i| {
                let [low, high] = [seen.sides[i], -seen.sides[i + 4]];
                cell(low * cells[i], side)..=cell(high * cells[i], side)
            });
            rows.flat_map(move |row| columns.clone().map(move |column| row * side + column))
        };
        for cell in seen.iter().flat_map(cells_of) {
            starts[cell + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut ends = starts.clone();
        let mut lists = vec![seen[0]; starts[side * side] as usize];
        for seen in &seen {
            for cell in cells_of(seen) {
                lists[ends[cell] as usize] = *seen;
                ends[cell] += 1;
            }
        }
        Face {
            lower,
            scale,
            cells,
            side,
            starts,
            lists,
        }
    }

    /// The bodies behind a point of the face, the nearest first.
    #[inline]
    pub(super) fn behind(&self, uv: [f64; 2]) -> impl Iterator<Item = &VisibleBody> {
        let [x, y] = each([0, 1], |i| ((uv[i] - self.lower[i]) * self.scale) as f32);
        let list = match self.side {
            0 => &[][..],
            side => {
                let cell = cell(y * self.cells[1], side) * side + cell(x * self.cells[0], side);
                &self.lists[self.starts[cell] as usize..self.starts[cell + 1] as usize]
            }
        };
        let (sum, difference) = (x + y, x - y);
        // One branch: the processor could not predict eight.
        let at = f32x8::new([x, y, sum, difference, -x, -y, -sum, -difference]);
        // `filter` is not inlined here; see CONTRIBUTING.md on codegen units.
        let mut rest = list.iter();
        iter::from_fn(move || rest.find(|seen| f32x8::new(seen.sides).simd_le(at).all()))
    }
}

/// The cell of a row that a coordinate is in, or that is nearest to it.
#[inline]
fn cell(x: f32, side: usize) -> usize {
    (x.max(0.0) as usize).min(side - 1)
}
