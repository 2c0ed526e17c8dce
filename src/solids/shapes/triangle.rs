//! The triangle, with and without normals.

use super::around::Around;
use super::facts::*;
use super::in_line::{InLine, in_line};
use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::array::{cross, dot, sub};
use crate::geometry::{Aabb, Matrix};
use crate::scene::TriangleNormals;
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use crate::solids::distance;

pub struct Triangle<'a> {
    pub vertices: [Vec3; 3],
    pub normals: &'a TriangleNormals,
}

impl Facts for Triangle<'_> {
    fn character(&self) -> Character {
        Character {
            is_round: false,
            is_flat: *self.normals == TriangleNormals::Flat,
            is_quadric: false,
            is_smooth: *self.normals != TriangleNormals::Flat,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let corners = self.vertices.into_iter();
        let all = corners.fold(Around::new(m), |all, v| all.ellipsoid(v, [0.0; 3]));
        all.boxed()
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        let each = self.vertices.iter().map(|&q| distance(m.point(q), p));
        Some(each.fold(0.0, f64::max))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let far = |a: &&Vec3, b: &&Vec3| dot(**a, d).total_cmp(&dot(**b, d));
        Some(Support::sheet(*self.vertices.iter().max_by(far)?))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        Some(self.vertices[0])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        let [a, b, c] = self.vertices.map(|v| sizes.matrix.point(v));
        let distance =
            |p: [f64; 3], q: [f64; 3]| (p[0] - q[0]).hypot(p[1] - q[1]).hypot(p[2] - q[2]);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            sizes.add(distance(p, q), "an edge");
        }
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

    /// Only where its normals are those of its plane.
    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        if *self.normals != TriangleNormals::Flat {
            return Vec::new();
        }
        let [p, q, r] = self.vertices;
        let n = cross(sub(q, p), sub(r, p));
        vec![FlatFace {
            n,
            d: -dot(n, p),
            around: self.bounds(m),
        }]
    }

    fn ends(&self, _: usize) -> Vec<f64> {
        Vec::new()
    }

    fn degenerate(&self) -> Option<Degenerate> {
        let case = match in_line(&self.vertices)? {
            InLine::Exactly => "triangle",
            InLine::Rounded => "triangle-nearly",
        };
        Some(Degenerate {
            case,
            params: (0, 9),
            equal: Vec::new(),
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
