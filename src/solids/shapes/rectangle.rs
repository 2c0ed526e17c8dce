//! The rectangle in the plane z = 0.

use super::facts::*;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;

pub struct Rectangle {
    pub min: [f64; 2],
    pub max: [f64; 2],
}

impl Facts for Rectangle {
    fn character(&self) -> Character {
        Character {
            is_flat: true,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let ([a, b], [c, d]) = (self.min, self.max);
        Aabb::new([a, b, 0.0], [c, d, 0.0]).transformed(m)
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let side = |i: usize| if d[i] < 0.0 { self.min[i] } else { self.max[i] };
        Some(Support::sheet([side(0), side(1), 0.0]))
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn taylor(&self, _: Vec3) -> Taylor {
        Taylor::nowhere()
    }

    fn faces(&self, _: &mut Faces) {}
}
