//! Maps from one space into another, four at once.

use super::lanes::{LANES, V3};
use crate::geometry::affine::Affine;

/// A map for each of four things.
pub struct Maps {
    rows: [V3; 3],
    pub offset: V3,
}

impl Maps {
    #[inline(always)]
    pub fn gathered<T>(places: [&T; LANES], map: impl Fn(&T) -> &Affine) -> Maps {
        let row = |i: usize| V3::gathered(places, |p| &map(p).rows[i].0);
        Maps {
            rows: [row(0), row(1), row(2)],
            offset: V3::gathered(places, |p| &map(p).offset.0),
        }
    }

    #[inline(always)]
    pub fn vector(&self, v: V3) -> V3 {
        V3([
            self.rows[0].dot(v),
            self.rows[1].dot(v),
            self.rows[2].dot(v),
        ])
    }

    #[inline(always)]
    pub fn point(&self, p: V3) -> V3 {
        self.vector(p) + self.offset
    }

    /// For each component of [`vector`](Self::vector), the sum of the sizes of its terms; `v` holds sizes, too.
    #[inline(always)]
    pub fn sizes(&self, v: V3) -> V3 {
        let size = |i: usize| self.rows[i].abs().dot(v);
        V3([size(0), size(1), size(2)])
    }

    /// Multiplies vectors by the transposed matrices: see [`Affine::transposed`].
    #[inline(always)]
    pub fn transposed(&self, n: V3) -> V3 {
        self.rows[0] * n.0[0] + self.rows[1] * n.0[1] + self.rows[2] * n.0[2]
    }
}
