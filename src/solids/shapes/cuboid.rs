//! The box along the axes.

use super::facts::*;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::{FaceId, Faces};

pub struct Cuboid {
    pub min: Vec3,
    pub max: Vec3,
}

impl Cuboid {
    pub fn corner(&self, k: usize) -> Vec3 {
        std::array::from_fn(|i| {
            if k >> i & 1 == 0 {
                self.min[i]
            } else {
                self.max[i]
            }
        })
    }
}

impl Facts for Cuboid {
    fn character(&self) -> Character {
        Character::PLAIN
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Aabb::new(self.min, self.max).transformed(m)
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let (min, max) = (self.min, self.max);
        Some(Support::towards(
            std::array::from_fn(|i| if d[i] < 0.0 { min[i] } else { max[i] }),
            std::array::from_fn(|i| min[i] / 2.0 + max[i] / 2.0),
        ))
    }

    fn holds(&self, p: Vec3) -> bool {
        (0..3).all(|i| self.min[i] < self.max[i] && (self.min[i]..=self.max[i]).contains(&p[i]))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let side = |i: usize, f: f64, g: f64| {
            Taylor::flat(f, std::array::from_fn(|k| if k == i { g } else { 0.0 }))
        };
        let slab =
            |i: usize| side(i, p[i] - self.max[i], 1.0).both(side(i, self.min[i] - p[i], -1.0));
        slab(0).both(slab(1)).both(slab(2))
    }

    fn faces(&self, out: &mut Faces) {
        let (min, max) = (self.min, self.max);
        let centre: Vec3 = std::array::from_fn(|i| min[i] / 2.0 + max[i] / 2.0);
        let half: Vec3 = std::array::from_fn(|i| max[i] / 2.0 - min[i] / 2.0);
        let along =
            |i: usize, x: f64| -> Vec3 { std::array::from_fn(|j| if i == j { x } else { 0.0 }) };
        for axis in 0..3 {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            for upper in [false, true] {
                let mut c = centre;
                c[axis] = if upper { max[axis] } else { min[axis] };
                let sides = (along(j, half[j]), along(k, half[k]));
                let outwards = along(axis, if upper { 1.0 } else { -1.0 });
                out.parallelogram(FaceId::Side { axis, upper }, c, sides, outwards);
            }
        }
    }
}
