//! The plane, and the half-space below one.

use super::facts::*;
use crate::geometry::array::{across, length, unit};
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::{FaceId, Faces};

pub struct HalfSpace {
    pub abcd: [f64; 4],
    /// Whether the shape is a half-space, which has an inside, and not a plane.
    pub solid: bool,
}

impl HalfSpace {
    pub fn normal(&self) -> Vec3 {
        let [a, b, c, _] = self.abcd;
        [a, b, c]
    }

    /// ax + by + cz + d.
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        (0..3).fold(N::of(self.abcd[3]), |sum, i| {
            sum + N::of(self.abcd[i]) * N::of(p[i])
        })
    }

    /// The bounds, which are finite only on an axis that the plane is at right angles to.
    fn local_bounds(&self) -> Aabb {
        let mut all = Aabb::ALL;
        let p = &self.abcd;
        for i in 0..3 {
            if p[i] != 0.0 && (0..3).all(|j| j == i || p[j] == 0.0) {
                let at = -p[3] / p[i];
                if !self.solid || p[i] > 0.0 {
                    all.max[i] = at;
                }
                if !self.solid || p[i] < 0.0 {
                    all.min[i] = at;
                }
                return all.padded_by([at.abs(); 3]);
            }
        }
        all
    }
}

impl Facts for HalfSpace {
    fn character(&self) -> Character {
        Character {
            is_flat: !self.solid,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        self.solid
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        self.local_bounds().transformed(m)
    }

    fn support(&self, _: Vec3) -> Option<Support> {
        None
    }

    fn holds(&self, p: Vec3) -> bool {
        self.solid && at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let [x, y, z] = p;
        let [a, b, c, d] = self.abcd;
        match self.solid {
            true => Taylor::flat(a * x + b * y + c * z + d, [a, b, c]),
            false => Taylor::nowhere(),
        }
    }

    fn faces(&self, out: &mut Faces) {
        let Some(n) = unit(self.normal()).filter(|_| self.solid) else {
            return;
        };
        let point = n.map(|x| -x * (self.abcd[3] / length(self.normal())));
        // Any two directions in the plane.
        out.endless(FaceId::All, point, across(n).into(), n);
    }
}
