//! The parts of the outermost union that a half-space holds, or would hold with other numbers, and those that a plane
//! hides.

use super::members::{Member, members};
use crate::geometry::array::length;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;
use crate::solids::within::{CLEARANCE_REL, far};
use crate::solids::{Named, named};

/// The place of a part of the outermost union: the map from the coordinates of its shape into those of the scene.
pub fn placed(scene: &Scene, bounds: &[NodeBounds], root: NodeId, part: NodeId) -> Option<Matrix> {
    let parts = members(scene, bounds, root);
    let own = parts.iter().find(|m| m.node == part)?;
    Some(*own.matrix())
}

/// The box of the first part of the outermost union that is the one asked for.
pub fn box_of(
    scene: &Scene,
    bounds: &[NodeBounds],
    root: NodeId,
    is_it: impl Fn(NodeId) -> bool,
) -> Option<Aabb> {
    let parts = members(scene, bounds, root);
    let own = parts.iter().find(|m| is_it(m.node))?;
    own.bounds.is_bounded().then_some(own.bounds)
}

/// The boxes of the bounded parts of the outermost union.
pub fn boxes(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> Vec<Aabb> {
    let parts = members(scene, bounds, root);
    let boxes = parts.iter().map(|m| m.bounds).filter(Aabb::is_bounded);
    boxes.collect()
}

/// A half-space or a plane with its placement, and the boxes of all bounded parts.
pub struct Sides {
    /// The map from the coordinates of the scene into those of the half-space or the plane.
    back: Matrix,
    /// Whether these coordinates are those of the scene: nothing moves the half-space or the plane.
    pub is_untouched: bool,
    boxes: Vec<Aabb>,
}

impl Sides {
    /// Finds a half-space or a plane by its name; `None` if none of this name is a part of the outermost union.
    pub fn new(scene: &Scene, bounds: &[NodeBounds], root: NodeId, name: Named) -> Option<Sides> {
        let parts = members(scene, bounds, root);
        let is_one =
            |geometry: &Geometry| matches!(geometry, Geometry::HalfSpace(_) | Geometry::Plane(_));
        let own = (parts.iter())
            .filter(|m| m.geometry(scene).is_some_and(is_one))
            .find(|m| named(scene, m.node) == Some(name))?;
        Sides::of(own, &parts)
    }

    pub(super) fn of(own: &Member, parts: &[Member]) -> Option<Sides> {
        Some(Sides {
            back: own.matrix().inverse()?,
            is_untouched: *own.matrix() == Matrix::IDENTITY,
            boxes: (parts.iter().map(|m| m.bounds))
                .filter(|b| b.is_bounded() && !b.is_empty())
                .collect(),
        })
    }

    /// The numbers of a half-space or a plane in the coordinates of the scene.
    pub fn in_scene(&self, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
        let value = |[x, y, z]: Vec3| a * x + b * y + c * z;
        let along = |axis: usize| {
            let mut unit: Vec3 = [0.0; 3];
            unit[axis] = 1.0;
            value(self.back.vector(unit))
        };
        let at_origin = value(self.back.point([0.0; 3])) + d;
        [along(0), along(1), along(2), at_origin]
    }

    /// Whether the half-space ax + by + cz + d ≤ 0, placed like this one, holds a point of the scene or has it on its
    /// boundary.
    pub fn holds(&self, [a, b, c, d]: [f64; 4], point: Vec3) -> bool {
        let local = self.back.point(point);
        let [x, y, z] = local;
        let value = a * x + b * y + c * z + d;
        value <= CLEARANCE_REL * far(&[a, b, c]) * far(&local).max(1.0)
    }

    /// Whether a box lies outside of a half-space with these numbers, or reaches in by no more than a share of the
    /// box's size.
    pub fn is_clear_of(&self, [a, b, c, d]: [f64; 4], of: &Aabb, share: f64) -> bool {
        let size = (0..3).fold(0.0f64, |m, i| m.max(of.max[i] - of.min[i]));
        let least = -share * size * length([a, b, c]);
        (of.corners().iter()).all(|&corner| {
            let [x, y, z] = self.back.point(corner);
            a * x + b * y + c * z + d >= least
        })
    }

    /// Whether some bounded part lies wholly within a half-space with these numbers.
    pub fn buries(&self, numbers: [f64; 4]) -> bool {
        let is_in = |&corner: &Vec3| self.holds(numbers, corner);
        self.boxes.iter().any(|b| b.corners().iter().all(is_in))
    }

    /// Whether some bounded part lies wholly within the half-space with the numbers `then`, but not wholly within the
    /// one with the numbers `now`.
    pub fn would_bury(&self, now: [f64; 4], then: [f64; 4]) -> bool {
        let all_of =
            |numbers, b: &Aabb| (b.corners().iter()).all(|&corner| self.holds(numbers, corner));
        (self.boxes.iter()).any(|b| all_of(then, b) && !all_of(now, b))
    }

    /// Whether some bounded part lies wholly across a plane with these numbers, as seen from the first of the places
    /// `from`. The part may touch the plane.
    pub fn hides(&self, numbers: [f64; 4], from: &[Vec3]) -> bool {
        let own = from.first().map(|&p| self.side(numbers, p));
        let is_across = |p: &Vec3| Some(self.side(numbers, *p)) != own;
        self.boxes.iter().any(|b| b.corners().iter().all(is_across))
    }

    /// Whether a plane with these numbers lies between all of a box and every one of the places `from`, and touches
    /// neither.
    pub fn is_between(&self, numbers: [f64; 4], from: &[Vec3], of: &Aabb) -> bool {
        let side = |point: &Vec3| self.side(numbers, *point);
        let across = match from.first().map(side) {
            Some(Side::Below) => Side::Above,
            Some(Side::Above) => Side::Below,
            Some(Side::On) | None => return false,
        };
        let is_apart = |p: &Vec3| side(p) != Side::On && side(p) != across;
        from.iter().all(is_apart) && of.corners().iter().all(|p| side(p) == across)
    }

    fn side(&self, [a, b, c, d]: [f64; 4], point: Vec3) -> Side {
        let local = self.back.point(point);
        let [x, y, z] = local;
        let value = a * x + b * y + c * z + d;
        let near = CLEARANCE_REL * far(&[a, b, c]) * far(&local).max(1.0);
        match value {
            _ if value > near => Side::Above,
            _ if value < -near => Side::Below,
            _ => Side::On,
        }
    }
}

/// The side of a plane on which a point lies, as far as rounding can tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Below,
    On,
    Above,
}
