//! The half-space.

use super::plane::{Plane, PlaneRelation};
use super::{Intersect, Located, Root, Roots, Shape};
use crate::geometry::aabb::Aabb;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;
use crate::solids::shapes as solids;
use crate::solids::shapes::facts::Facts;
use crate::trace::shapes::support::Support;

/// The solid ax + by + cz + d ≤ 0.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpace {
    face: Plane,
}

impl HalfSpace {
    pub fn new(abcd: [f64; 4]) -> HalfSpace {
        HalfSpace {
            face: Plane::new(abcd),
        }
    }

    /// a, b, c, d as written.
    pub fn abcd(&self) -> [f64; 4] {
        self.face.abcd()
    }
}

impl Shape for HalfSpace {
    /// The flat box of the face, extended to infinity on the side opposite to the normal.
    fn bounds(&self) -> Aabb {
        let mut bounds = self.face.bounds();
        for i in 0..3 {
            if bounds.min[i].is_finite() {
                if self.face.normal()[i] > 0.0 {
                    bounds.min[i] = f64::NEG_INFINITY;
                } else {
                    bounds.max[i] = f64::INFINITY;
                }
            }
        }
        bounds
    }

    fn extent(&self) -> f64 {
        self.face.extent()
    }

    fn uv(&self, point: Vec3, face: u32) -> [f64; 2] {
        self.face.uv(point, face)
    }

    fn support(&self, face: u32) -> Option<Support> {
        self.face.support(face)
    }

    fn holds(&self, point: Vec3) -> bool {
        solids::half_space::HalfSpace {
            abcd: self.face.abcd(),
            solid: true,
        }
        .holds(point.0)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn feed(&self, sink: &mut dyn FnMut(f64)) {
        self.face.feed(sink);
    }
}

impl<R: Traced> Intersect<R> for HalfSpace {
    fn crossings(&self, line: &Line<R>, roots: &mut Roots<R>) {
        let meeting = self.face.meet(line);
        roots.uncertain = meeting.uncertain;
        match meeting.way {
            PlaneRelation::Across { t, outwards } => {
                roots.inside = outwards;
                roots.push(t, 0);
            }
            PlaneRelation::Along { side, close } => {
                roots.inside = side.is_lt();
                roots.uncertain |= close;
                roots.along = side.is_eq().then(|| self.face.normal());
            }
        }
    }

    fn speed(&self, line: &Line<R>, root: Root<R>) -> Option<R> {
        self.face.speed(line, root)
    }

    fn locate(&self, line: &Line<R>, root: Root<R>) -> Located<R> {
        self.face.locate(line, root)
    }
}
