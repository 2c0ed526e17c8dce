//! The parts of the scene that are looked for, and how they are seen from a point.

use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::vec::Vec3;
use crate::trace::graph::{Graph, Operation, Target};
use std::sync::Arc;

/// Largest error of a distance, as a share of it.
pub(super) const DISTANCE_REL_ERROR: f64 = 1e-6;
/// Bound on what two roundings may do to a coordinate of a face, several times over.
pub(super) const ROUNDED: f64 = 16.0 * f64::EPSILON;

/// A part of the scene that has bounds, and where it is.
#[derive(Debug)]
pub struct Body {
    /// Index into [`Graph::parts`].
    pub part: u32,
    pub bounds: Aabb,
    /// Points whose convex hull holds the part. Empty where they are not finite.
    pub corners: Vec<Vec3>,
    /// How far each of them may be off, in each coordinate.
    off: f64,
}

/// The octagon that a body is in as it is seen through a face: the least and the largest u, v, u + v and u − v.
#[derive(Debug, Clone, Copy)]
pub struct Octagon(pub [[f64; 4]; 2]);

/// The parts with bounds that a scene is a union of; `None` where there are more than so many.
pub fn bodies(graph: &Graph, most: usize) -> Option<Arc<[Body]>> {
    let root = graph.root();
    let Operation::Union(group) = &root.operation else {
        return None;
    };
    let is_small = group.tree.items().take(most + 1).count() <= most;
    let boxes = group.tree.boxes(&root.frame);
    is_small.then(|| {
        boxes
            .map(|(part, bounds)| Body::new(graph, part, bounds))
            .collect()
    })
}

impl Body {
    fn new(graph: &Graph, number: u32, bounds: Aabb) -> Body {
        let part = &graph.parts[number as usize];
        let own = match part.target {
            Target::Shape(p) => graph.primitives[p as usize].shape().hull_points(),
            Target::Object(o) => graph.objects[o as usize].bounds.corners().to_vec(),
        };
        let out = &graph.placements[part.placement as usize].out;
        let errors = own
            .iter()
            .map(|&p| out.point_error(Vec3(p), Vec3::ZERO).max_component());
        let off = errors.fold(0.0, f64::max);
        let corners: Vec<Vec3> = own.into_iter().map(|p| out.point(Vec3(p))).collect();
        Body::of_corners(number, bounds, (corners, off))
    }

    /// A body of points whose convex hull holds the part, and of how far each of them may be off.
    pub fn of_corners(part: u32, bounds: Aabb, (mut corners, off): (Vec<Vec3>, f64)) -> Body {
        if !(off.is_finite() && corners.iter().all(|c| c.is_finite())) {
            corners.clear();
        }
        Body {
            part,
            bounds,
            corners,
            off,
        }
    }

    /// The octagon around what is seen of the body from a point through a face, if anything is. `around` is the body's
    /// box as seen from the point, and `wider` is how far a ray may be off its line.
    pub fn seen(
        &self,
        point: Vec3,
        (axis, sign): (usize, f64),
        around: &Aabb,
        wider: f64,
    ) -> Option<Octagon> {
        let [lower, upper] = footprint(around, axis, sign)?;
        let mut least = [lower[0], lower[1], f64::NEG_INFINITY, f64::NEG_INFINITY];
        let mut most = [upper[0], upper[1], f64::INFINITY, f64::INFINITY];
        let mut ends = [[f64::INFINITY; 4], [f64::NEG_INFINITY; 4]];
        let mut near = f64::INFINITY;
        let mut is_known = !self.corners.is_empty();
        let [across, along] = others(axis);
        for &corner in &self.corners {
            let way = corner - point;
            let depth = way[axis] * sign;
            let (u, v) = (way[across] / depth, way[along] / depth);
            near = near.min(depth);
            is_known &= u.is_finite() && v.is_finite();
            let of = [u, v, u + v, u - v];
            for i in 0..4 {
                ends[0][i] = ends[0][i].min(of[i]);
                ends[1][i] = ends[1][i].max(of[i]);
            }
        }
        let off = self.off + wider;
        // All of it is in front of the point. Otherwise the projection of the corners says nothing.
        if is_known && near * DISTANCE_REL_ERROR > off {
            let far = |i: usize| ends[1][i].max(-ends[0][i]);
            let size = 1.0 + far(0) + far(1);
            // A quotient of two numbers that are off by as much is off by (off + |u| off) / near, a sum by that of both.
            let margin = size * (2.0 * off / near + ROUNDED);
            for i in 0..4 {
                least[i] = least[i].max(ends[0][i] - margin);
                most[i] = most[i].min(ends[1][i] + margin);
            }
        }
        let is_seen = (0..4).all(|i| least[i] <= most[i]);
        is_seen.then_some(Octagon([least, most]))
    }
}

/// The axes across.
fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The rectangle around a box, as seen from the origin through a face, whose own coordinates are between −1 and 1;
/// `None` where it is not seen.
fn footprint(b: &Aabb, axis: usize, sign: f64) -> Option<[[f64; 2]; 2]> {
    let [near, far] = match sign > 0.0 {
        true => [b.min[axis], b.max[axis]],
        false => [-b.max[axis], -b.min[axis]],
    };
    if far <= 0.0 {
        return None;
    }
    let near = near.max(0.0);
    let edge = 1.0 + ROUNDED;
    // Of what is on one side, the nearest is farthest aside.
    let lower = each(others(axis), |i| {
        let low = b.min[i];
        (low / if low < 0.0 { near } else { far }).max(-edge)
    });
    let upper = each(others(axis), |i| {
        let high = b.max[i];
        (high / if high > 0.0 { near } else { far }).min(edge)
    });
    let is_seen = (0..2).all(|i| lower[i] <= edge && upper[i] >= -edge);
    is_seen.then_some([lower, upper])
}
