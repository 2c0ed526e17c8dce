//! The box along the axes.

use super::facts::*;
use super::lengthen::Cut;
use super::lengthen::{HAIR, outward};
use super::sizes::Sizes;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use crate::solids::distance;

pub struct Cuboid {
    pub min: Vec3,
    pub max: Vec3,
}

impl Cuboid {
    fn corner(&self, k: usize) -> Vec3 {
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
        Character {
            is_round: false,
            is_flat: false,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Aabb::new(self.min, self.max).transformed(m)
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        Some((0..8).map(|k| self.corner(k)).collect())
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        let each = (0..8).map(|k| distance(m.point(self.corner(k)), p));
        Some(each.fold(0.0, f64::max))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let (min, max) = (self.min, self.max);
        Some(Support::towards(
            std::array::from_fn(|i| if d[i] < 0.0 { min[i] } else { max[i] }),
            std::array::from_fn(|i| min[i] / 2.0 + max[i] / 2.0),
        ))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    /// The corner that is nearest to the origin.
    fn place(&self) -> Option<Vec3> {
        Some(std::array::from_fn(|i| {
            0f64.clamp(self.min[i], self.max[i])
        }))
    }

    fn sizes(&self, sizes: &mut Sizes) {
        sizes.named(
            std::array::from_fn(|i| self.max[i] - self.min[i]),
            ["its width in x", "its height in y", "its depth in z"],
        );
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

    fn pieces(&self) -> usize {
        0
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
                out.parallelogram(Part::Side { axis, upper }, c, sides, outwards);
            }
        }
    }

    fn quadric(&self, _: Part) -> Option<Form> {
        None
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        Vec::new()
    }

    fn plane(&self) -> Option<[f64; 4]> {
        None
    }

    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        let axis = |i: usize, sign: f64| -> Vec3 {
            std::array::from_fn(|k| if k == i { sign } else { 0.0 })
        };
        let ends = (0..3).flat_map(|i| [(i, -1.0), (i, 1.0)]);
        let faces = ends.map(|(i, sign)| {
            let at = if sign > 0.0 { self.max[i] } else { self.min[i] };
            let (mut min, mut max) = (self.min, self.max);
            (min[i], max[i]) = (at, at);
            FlatFace {
                n: axis(i, sign),
                d: -sign * at,
                around: Aabb::new(min, max).transformed(m),
            }
        });
        faces.collect()
    }

    fn ends(&self, axis: usize) -> Vec<f64> {
        vec![self.min[axis], self.max[axis]]
    }

    fn degenerate(&self) -> Option<Degenerate> {
        let equal: Vec<usize> = (0..3).filter(|&i| self.min[i] == self.max[i]).collect();
        Some(Degenerate {
            case: "box",
            params: (*equal.first()?, 1),
            equal,
        })
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        let (min, max) = (self.min, self.max);
        let grown = |x: f64| x + by > x / 2.0;
        let thick = (0..3).all(|i| grown((max[i] - min[i]) / 2.0));
        thick.then(|| Geometry::Box {
            min: min.map(|x| x - by),
            max: max.map(|x| x + by),
        })
    }

    fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        let cut = &longer.around;
        let (mut low, mut high) = (self.min, self.max);
        let mut any = false;
        for i in 0..3 {
            let size = self.max[i] - self.min[i];
            let hair = HAIR * size.max(longer.size(i));
            let step = longer.step(size);
            for end in [&mut low[i], &mut high[i]] {
                if let Some(by) = outward(*end, (cut.min[i], cut.max[i]), hair, step) {
                    *end += by;
                    any = true;
                }
            }
        }
        any.then_some(Geometry::Box {
            min: low,
            max: high,
        })
    }

    fn written(&self, part: Part) -> Written {
        match part {
            Part::Side { axis, upper } => Written {
                is_named: true,
                ..Written::at(if upper { axis + 3 } else { axis }, 1, "side")
            },
            _ => Written::ALL,
        }
    }

    fn moved_out(&self, part: Part, share: f64, _: f64) -> Option<Vec<Moved>> {
        let Part::Side { axis, upper } = part else {
            return None;
        };
        let hair = share * (self.max[axis] - self.min[axis]);
        let moved = match upper {
            true => (axis + 3, self.max[axis] + hair, hair),
            false => (axis, self.min[axis] - hair, hair),
        };
        Some(vec![moved])
    }
}
