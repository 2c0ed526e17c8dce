//! Affine maps with their inverses, and what they do to rounding errors.

use super::vec::{Vec3, gamma};
use crate::scene::Matrix;

/// An affine map x ↦ rows · x + offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    pub rows: [Vec3; 3],
    pub offset: Vec3,
}

impl Affine {
    pub fn new(m: &Matrix) -> Affine {
        let row = |i: usize| Vec3::new(m.0[i][0], m.0[i][1], m.0[i][2]);
        Affine {
            rows: [row(0), row(1), row(2)],
            offset: Vec3::new(m.0[0][3], m.0[1][3], m.0[2][3]),
        }
    }

    pub fn point(&self, p: Vec3) -> Vec3 {
        self.vector(p) + self.offset
    }

    pub fn vector(&self, v: Vec3) -> Vec3 {
        Vec3::new(
            self.rows[0].dot(v),
            self.rows[1].dot(v),
            self.rows[2].dot(v),
        )
    }

    /// The image of a normal under the inverse of this map: the transpose times n.
    pub fn transposed(&self, n: Vec3) -> Vec3 {
        self.rows[0] * n[0] + self.rows[1] * n[1] + self.rows[2] * n[2]
    }

    /// A bound on the error of `point(p)` where p is off by at most `error`:
    /// (γ₃ + 1)|M| error + γ₄(|M||p| + |offset|) (pbrt-v4, section 6.8.6).
    pub fn point_error(&self, p: Vec3, error: Vec3) -> Vec3 {
        let mut out = Vec3::ZERO;
        for i in 0..3 {
            let row = self.rows[i].abs();
            out[i] = (1.0 + gamma(3)) * row.dot(error)
                + gamma(4) * (row.dot(p.abs()) + self.offset[i].abs());
        }
        out
    }
}

/// A map from an object's space into its parent's, and back.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    pub out: Affine,
    pub back: Affine,
}
