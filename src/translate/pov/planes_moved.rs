//! Shapes with their faces in some planes farther out.

use super::coplanar::Plane;
use crate::geometry::Aabb;
use crate::geometry::array::{length, sub};
use crate::scene::Geometry;
use crate::solids::shapes::facts::Facts;
use crate::solids::shapes::lengthen::{Cut, HALF};

/// Normals that are this near are one: what rotations may do.
const FLAT: f64 = 1e-9;
/// Planes that are nearer than this part of what they are moved by are one.
const NEAR: f64 = 1e-3;

/// The shape with its flat faces in some planes farther out, if it has any there.
pub fn with_planes_moved(geometry: &Geometry, planes: &[(Plane, f64)]) -> Option<Geometry> {
    let mut out: Option<Geometry> = None;
    for (plane, by) in planes {
        let now = out.as_ref().unwrap_or(geometry);
        let near = |a: f64, b: f64| (a - b).abs() <= NEAR * by;
        if let (Some([a, b, c, d]), true) = (now.plane(), now.is_solid()) {
            let n = [a, b, c];
            let here = Plane::of(n, d)?;
            if length(sub(here.n, plane.n)) <= FLAT && near(here.d, plane.d) {
                let d = d - by * length(n);
                out = Some(Geometry::HalfSpace([a, b, c, d]));
            }
            continue;
        }
        // All others have such faces across their axes only.
        let Some(axis) = (0..3).find(|i| plane.n[*i].abs() > 1.0 - FLAT) else {
            continue;
        };
        let sign = plane.n[axis].signum();
        let at = -plane.d * sign;
        let Some(end) = now.ends(axis).into_iter().find(|end| near(*end, at)) else {
            continue;
        };
        let mut around = Aabb::ALL;
        match sign > 0.0 {
            true => around.max[axis] = end,
            false => around.min[axis] = end,
        }
        let most = *by;
        let cut = Cut {
            around,
            by: HALF,
            most,
        };
        out = now.lengthened(&cut).or(out);
    }
    out
}
