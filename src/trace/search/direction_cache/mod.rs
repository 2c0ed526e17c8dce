//! What rays from a fixed point, or to it, may meet: found by their direction, without a tree.
//!
//! A cube around the point has a grid of cells on each face. A cell lists the parts that are behind it as seen from the
//! point, the nearest first. That is POV-Ray's vista buffer where the point is the eye, and a light buffer where it is a
//! light (Haines and Greenberg, "The Light Buffer", IEEE CG&A 6(9), 1986). For each part a cell also keeps the octagon
//! around it, as it is seen through the face.
//!
//! No part that a ray meets is missed: boxes and octagons are widened by more than a ray in doubles may be off the
//! straight line between its ends.

mod body;
mod face;
#[cfg(test)]
mod tests;

pub use body::{Body, bodies};

use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use body::DISTANCE_REL_ERROR;
use face::Face;
use std::iter;
use std::sync::Arc;

/// The bodies in each direction from a point.
#[derive(Debug)]
pub struct DirectionCache {
    bodies: Arc<[Body]>,
    /// By axis and, below and above, by the sign of a direction's largest component.
    faces: [[Face; 2]; 3],
    /// Rays that come from farther away may be off by more than boxes are widened.
    far: f64,
}

/// The caches of the eye and of each light, where they are known.
#[derive(Debug, Default)]
pub struct DirectionCaches {
    pub eye: Option<DirectionCache>,
    /// Beside the lights.
    pub lights: Vec<Option<DirectionCache>>,
}

/// Whether one end of a ray is a point from which it is known what lies in which direction.
#[derive(Debug, Clone, Copy)]
pub enum End<'v> {
    /// The ray starts there, and has a direction of length 1.
    At(&'v DirectionCache),
    /// The ray is there at t = 1.
    To(&'v DirectionCache),
    /// Neither end is such a point.
    Anywhere,
}

/// Widening of boxes, as a share of the largest coordinate there is.
const BOX_WIDENING: f64 = 1e-9;
/// Largest distance that a ray may start at, in units of that coordinate. Its direction is rounded once, which takes it
/// less than 10⁻¹² of that coordinate off: a thousandth of what boxes are wider by.
const MAX_ORIGIN_DISTANCE: f64 = 1e3;

impl DirectionCache {
    /// The cache of some bodies as seen from a point; `None` where there are no numbers for it.
    pub fn new(bodies: &Arc<[Body]>, point: Vec3) -> Option<DirectionCache> {
        let reaches = bodies.iter().map(|body| body.bounds.reach());
        let reach = reaches.fold(point.abs().max_component(), f64::max);
        let wider = BOX_WIDENING * reach;
        if !(wider.is_normal() && (MAX_ORIGIN_DISTANCE * reach).is_finite()) {
            return None;
        }
        let mut around: Vec<(f64, u32, Aabb)> = (0..)
            .zip(bodies.iter())
            .map(|(index, body)| {
                let b = &body.bounds;
                let min = each([0, 1, 2], |i| b.min[i] - point[i] - wider);
                let max = each([0, 1, 2], |i| b.max[i] - point[i] + wider);
                let gap = Vec3(each([0, 1, 2], |i| min[i].max(-max[i]).max(0.0)));
                (
                    gap.length() * (1.0 - DISTANCE_REL_ERROR),
                    index,
                    Aabb { min, max },
                )
            })
            .collect();
        around.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let face = |axis: usize, sign: f64| {
            let seen = around.iter().filter_map(|(near, index, b)| {
                let body = &bodies[*index as usize];
                Some((*index, *near, body.seen(point, (axis, sign), b, wider)?))
            });
            Face::new(&seen.collect::<Vec<_>>())
        };
        Some(DirectionCache {
            bodies: Arc::clone(bodies),
            faces: [0, 1, 2].map(|axis| [-1.0, 1.0].map(|sign| face(axis, sign))),
            far: MAX_ORIGIN_DISTANCE * reach,
        })
    }

    /// The bodies that a ray from the point may meet, each with its least distance.
    pub fn leaving(&self, direction: Vec3) -> impl Iterator<Item = (f64, &Body)> {
        let [x, y, z] = direction.0;
        let [x_size, y_size, z_size] = direction.abs().0;
        // In the order of `others`.
        let (axis, largest, across) = match () {
            () if x_size >= y_size && x_size >= z_size => (0, x, [y, z]),
            () if y_size >= z_size => (1, y, [z, x]),
            () => (2, z, [x, y]),
        };
        let face = &self.faces[axis][usize::from(largest > 0.0)];
        let per_depth = largest.abs().recip();
        let mut behind = face.behind(each(across, |component| component * per_depth));
        // As in `Face::behind`.
        iter::from_fn(move || {
            let seen = behind.next()?;
            Some((f64::from(seen.near), &self.bodies[seen.index as usize]))
        })
    }

    /// The bodies that a ray may meet that comes to the point by a way: as [`leaving`](Self::leaving). `None`: it comes
    /// from too far away.
    #[inline]
    pub fn arriving(&self, way: Vec3) -> Option<impl Iterator<Item = (f64, &Body)>> {
        let size = way.abs().max_component();
        let length = way.length() * (1.0 + DISTANCE_REL_ERROR);
        let is_within = move |(near, _): &(f64, _)| *near <= length;
        (size <= self.far).then(|| self.leaving(-way).take_while(is_within))
    }
}
