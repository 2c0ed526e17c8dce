//! Lines in an object's space, and rays with what they know about where they start.

use super::affine::Affine;
use super::number::Real;
use super::vec::Vec3;

/// A line o + t·d. Affine maps keep t, so all spaces share one parameter.
#[derive(Debug, Clone, Copy)]
pub struct Line<R = f64> {
    pub origin: Vec3<R>,
    /// Of any length but zero.
    pub direction: Vec3<R>,
    /// 1 / direction, component by component; infinite where that is zero.
    pub inverse: Vec3<R>,
}

impl<R: Real> Line<R> {
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Line<R> {
        Line {
            origin,
            direction,
            inverse: direction.map(R::recip),
        }
    }

    pub fn at(&self, t: R) -> Vec3<R> {
        self.origin + self.direction * t
    }
}

impl Line {
    pub fn through(&self, map: &Affine) -> Line {
        Line::new(map.point(self.origin), map.vector(self.direction))
    }
}

/// The surface a ray starts on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Left {
    /// Which surface: the shape's geometry and the way it is placed.
    pub surface: u64,
    /// Whether the ray goes into the surface's solid. Crossings alternate, so this and being
    /// nearest to the origin single out the root that is the starting point itself.
    pub entering: bool,
    /// Bound on the distance of the starting point from the true surface. What lies closer to the
    /// starting point than this, along its own normal, cannot be told from it and is behind it.
    pub skin: f64,
}

/// A ray: a line from t = 0 on.
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    pub line: Line,
    pub left: Option<Left>,
    /// Known to start outside of every solid.
    pub outside: bool,
}

impl Ray {
    /// A ray that starts anywhere.
    pub fn new(origin: Vec3, direction: Vec3) -> Ray {
        Ray {
            line: Line::new(origin, direction),
            left: None,
            outside: false,
        }
    }
}
