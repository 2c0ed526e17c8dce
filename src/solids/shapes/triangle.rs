//! The triangle, with and without normals.

use super::around::Around;
use super::facts::*;
use crate::geometry::array::dot;
use crate::geometry::{Aabb, Matrix};
use crate::scene::TriangleNormals;
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;

pub struct Triangle<'a> {
    pub vertices: [Vec3; 3],
    pub normals: &'a TriangleNormals,
}

impl Facts for Triangle<'_> {
    fn character(&self) -> Character {
        Character {
            is_flat: *self.normals == TriangleNormals::Flat,
            is_smooth: *self.normals != TriangleNormals::Flat,
            ..Character::PLAIN
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

    fn support(&self, d: Vec3) -> Option<Support> {
        let far = |a: &&Vec3, b: &&Vec3| dot(**a, d).total_cmp(&dot(**b, d));
        Some(Support::sheet(*self.vertices.iter().max_by(far)?))
    }

    fn holds(&self, _: Vec3) -> bool {
        false
    }

    fn taylor(&self, _: Vec3) -> Taylor {
        Taylor::nowhere()
    }

    fn faces(&self, _: &mut Faces) {}
}
