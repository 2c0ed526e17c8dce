//! The rectangle in the plane z = 0.

use super::facts::*;
use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use crate::solids::distance;

pub struct Rectangle {
    pub min: [f64; 2],
    pub max: [f64; 2],
}

impl Facts for Rectangle {
    fn character(&self) -> Character {
        Character {
            is_round: false,
            is_flat: true,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let ([a, b], [c, d]) = (self.min, self.max);
        Aabb::new([a, b, 0.0], [c, d, 0.0]).transformed(m)
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        let (min, max) = (self.min, self.max);
        let corner = |k: usize| {
            let x = if k & 1 == 0 { min[0] } else { max[0] };
            [x, if k & 2 == 0 { min[1] } else { max[1] }, 0.0]
        };
        let each = (0..4).map(|k| distance(m.point(corner(k)), p));
        Some(each.fold(0.0, f64::max))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let side = |i: usize| if d[i] < 0.0 { self.min[i] } else { self.max[i] };
        Some(Support::sheet([side(0), side(1), 0.0]))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        let near = |i: usize| 0f64.clamp(self.min[i], self.max[i]);
        Some([near(0), near(1), 0.0])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        let [width, height] = [0, 1].map(|i| self.max[i] - self.min[i]);
        sizes.named(
            [width, height, 0.0],
            ["its width in x", "its height in y", ""],
        );
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn taylor(&self, _: Vec3) -> Taylor {
        Taylor::nowhere()
    }

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, _: &mut Faces) {}

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
        vec![FlatFace {
            n: [0.0, 0.0, 1.0],
            d: 0.0,
            around: self.bounds(m),
        }]
    }

    fn ends(&self, _: usize) -> Vec<f64> {
        Vec::new()
    }

    fn degenerate(&self) -> Option<Degenerate> {
        let equal: Vec<usize> = (0..2).filter(|&i| self.min[i] == self.max[i]).collect();
        Some(Degenerate {
            case: "rectangle",
            params: (*equal.first()?, 1),
            equal,
        })
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, _: f64) -> Option<Geometry> {
        None
    }

    fn lengthened(&self, _: &Cut) -> Option<Geometry> {
        None
    }

    fn written(&self, _: Part) -> Written {
        Written::ALL
    }

    fn moved_out(&self, _: Part, _: f64, _: f64) -> Option<Vec<Moved>> {
        None
    }
}
