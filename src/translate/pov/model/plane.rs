//! Planes, and shapes with the face in a given plane moved outwards.

use super::lengthen::EndMove;
use crate::geometry::Matrix;
use crate::geometry::array::{length, sub};
use crate::scene::{Geometry, Vec3};

/// The largest distance of two unit normals that count as equal: rotations may round by this much.
const NORMAL_EPS: f64 = 1e-9;
/// The largest distance of two planes that count as one, as a fraction of the distance by which the plane is moved.
const OFFSET_REL_EPS: f64 = 1e-3;

/// A plane n·x + d = 0 whose normal has the length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plane {
    pub n: Vec3,
    pub d: f64,
}

impl Plane {
    pub(crate) fn of(n: Vec3, d: f64) -> Option<Plane> {
        let length = length(n);
        let plane = Plane {
            n: n.map(|x| x / length),
            d: d / length,
        };
        (plane.n.iter().all(|x| x.is_finite()) && plane.d.is_finite()).then_some(plane)
    }

    /// The plane in the coordinates that `m` maps from, and the factor from lengths across the plane here to lengths
    /// there. `None` if the plane has no finite normal there.
    pub(crate) fn moved_back(&self, m: &Matrix) -> Option<(Plane, f64)> {
        let n = std::array::from_fn(|j| (0..3).map(|i| self.n[i] * m.0[i][j]).sum());
        let d = self.d + (0..3).map(|i| self.n[i] * m.0[i][3]).sum::<f64>();
        Some((Plane::of(n, d)?, 1.0 / length(n)))
    }

    /// The plane moved by `by` in the direction of its normal.
    pub(crate) fn moved(&self, by: f64) -> Plane {
        Plane {
            d: self.d - by,
            ..*self
        }
    }
}

/// The shape with its flat face in `plane` moved outwards by `by`. `None` if it has no such face that can be moved.
pub(super) fn with_plane_moved(geometry: &Geometry, plane: &Plane, by: f64) -> Option<Geometry> {
    let near = |a: f64, b: f64| (a - b).abs() <= OFFSET_REL_EPS * by.abs();
    if let (Some([a, b, c, d]), true) = (geometry.plane(), geometry.is_solid()) {
        let n = [a, b, c];
        let here = Plane::of(n, d)?;
        let is_it = length(sub(here.n, plane.n)) <= NORMAL_EPS && near(here.d, plane.d);
        return is_it.then(|| Geometry::HalfSpace([a, b, c, d - by * length(n)]));
    }
    // All other shapes have movable flat faces only perpendicular to their axes.
    let axis = (0..3).find(|i| plane.n[*i].abs() > 1.0 - NORMAL_EPS)?;
    let sign = plane.n[axis].signum();
    let (upper, at) = (sign > 0.0, -plane.d * sign);
    geometry.with_end_moved(&EndMove { axis, upper, by }, |end| near(*end, at))
}
