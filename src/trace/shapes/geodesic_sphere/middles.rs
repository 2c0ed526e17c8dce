//! The middles of the edges of a geodesic sphere's facets.

use super::GeodesicSphere;
use crate::geometry::array::each;
use crate::geometry::line::Traced;
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use std::sync::OnceLock;

/// The middle of an edge, pushed out to the sphere.
///
/// The result has six roundings: the sum, half of the squared length's three, the root, the quotient and the product.
fn middle<R: Traced>(a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
    let sum = a + b;
    sum * sum.dot(sum).sqrt().recip()
}

/// The middles of the edges that are opposite to the corners.
#[inline]
fn middles<R: Traced>([a, b, c]: [Vec3<R>; 3]) -> [Vec3<R>; 3] {
    [middle(b, c), middle(c, a), middle(a, b)]
}

/// The number of levels whose facets have their middles in a table. Those of the sixth level take 1.5 MB and 2 ms.
const LEVELS: u32 = 6;
static TABLES: [OnceLock<Vec<[Vec3; 3]>>; LEVELS as usize + 1] =
    [const { OnceLock::new() }; LEVELS as usize + 1];

/// The number of facets of all levels above one, which has 20 · 4^level facets itself.
pub fn facets_above(level: u32) -> u32 {
    20 * ((1 << (2 * level)) - 1) / 3
}

/// The middles of facets: from a table for the first levels, computed for the others.
#[derive(Clone, Copy)]
pub(super) struct Middles<'t> {
    /// The middles in doubles, of the facets of all levels that are in the table, level by level. Empty for other
    /// numbers.
    pub(super) table: &'t [[Vec3; 3]],
}

impl Middles<'_> {
    pub(super) fn new<R: Traced>(sphere: &GeodesicSphere) -> Middles<'static> {
        if R::ROUNDOFF != R::of(f64::ROUNDOFF) {
            return Middles { table: &[] };
        }
        let levels = sphere.record.splits.min(LEVELS);
        let table = TABLES[levels as usize].get_or_init(|| {
            let mut table: Vec<[Vec3; 3]> = Vec::new();
            for level in 0..levels {
                let known = Middles { table: &table };
                let faces = 0..20u32 << (2 * level);
                let next: Vec<_> = faces
                    .map(|face| middles(sphere.facet(face, level, known)))
                    .collect();
                table.extend(next);
            }
            table
        });
        Middles { table }
    }

    /// The middles of facet `face` of a level, which has 20 · 4^level facets.
    #[inline]
    pub(super) fn of<R: Traced>(
        self,
        corners: [Vec3<R>; 3],
        face: u32,
        level: u32,
    ) -> [Vec3<R>; 3] {
        let before = facets_above(level);
        match self.table.get((before + face) as usize) {
            Some(known) => each(*known, |middle| Vec3(each(middle.0, R::of))),
            None => middles(corners),
        }
    }
}
