//! Bundles of rays that are tested against the boxes of a tree.

use super::aabb::Aabb;
use super::array::each;
use super::vec::Vec3;
use super::wide_bvh::{
    Frame, MAX_ORIGIN_DISTANCE, MIN_DIRECTION_COMPONENT, Node, PARAMETER_REL_ERROR, STILL, WIDTH,
    power,
};
use wide::f32x8;

/// Many rays at once. At every t the points of all rays are in a box whose corners move along lines. The corners are in
/// single precision, and moved outwards by as much as they may be off, like the origin of a
/// [`Beam`](super::wide_bvh::Beam).
#[derive(Debug, Clone, Copy)]
pub struct Shaft {
    /// The upper corner, which is compared with the lower sides of boxes, and the lower corner, which is compared with
    /// the upper sides.
    sides: [Side; 2],
    /// The factor from the parameter t of the rays to the parameter of the shaft: a power of two.
    pace: f64,
    /// The reciprocal of `pace`.
    unpace: f64,
}

/// A moving corner, as it is compared with the sides of boxes.
#[derive(Debug, Clone, Copy)]
struct Side {
    origin: [f32; 3],
    inverse: [f32; 3],
    /// For each axis, whether the corner moves from outside to inside when it passes the side of a box with which it is
    /// compared.
    enters: [bool; 3],
}

impl Shaft {
    /// The shaft of rays whose points at t = 0 are in `start`. The lower and the upper corner of that box move by the
    /// `steps` with t, and the points of all rays stay between them. `None` if single precision cannot hold the
    /// numbers.
    pub fn new(start: &Aabb, steps: [Vec3; 2], frame: &Frame) -> Option<Shaft> {
        let size = each(steps, |d| d.abs().max_component());
        let (size, per_size) = power(size[0].max(size[1]))?;
        let (pace, unpace) = (size * frame.per_unit, frame.unit * per_size);
        let per_unit = frame.per_unit;
        let side = |corner: [f64; 3], direction: Vec3, outwards: f64| {
            let origin = (Vec3(corner) - frame.centre) * per_unit;
            let direction = direction * per_size;
            let is_near =
                origin.abs().max_component() < MAX_ORIGIN_DISTANCE && direction.is_finite();
            let numbers = each([0, 1, 2], |i| {
                let (o, d) = (origin[i] as f32, direction[i] as f32);
                let off = o.abs() * (2.0 * f32::EPSILON) + MIN_DIRECTION_COMPONENT;
                let (off, d) = match d.abs() < MIN_DIRECTION_COMPONENT {
                    // A corner that hardly moves is taken to move outwards.
                    true => (off + STILL, MIN_DIRECTION_COMPONENT * outwards as f32),
                    false => (off, d),
                };
                (o + off * outwards as f32, 1.0 / d)
            });
            let side = Side {
                origin: each(numbers, |(origin, _)| origin),
                inverse: each(numbers, |(_, inverse)| inverse),
                enters: each(numbers, |(_, inverse)| inverse * outwards as f32 > 0.0),
            };
            is_near.then_some(side)
        };
        let [least, most] = steps;
        let sides = [side(start.max, most, 1.0)?, side(start.min, least, -1.0)?];
        (pace.is_normal() && unpace.is_normal()).then_some(Shaft {
            sides,
            pace,
            unpace,
        })
    }

    /// Converts a parameter of the rays to one of the shaft.
    #[inline]
    pub fn pace(&self, t: f64) -> f32 {
        (t * self.pace) as f32
    }

    /// Converts a parameter of the shaft to one of the rays.
    #[inline]
    pub fn unpace(&self, t: f32) -> f64 {
        f64::from(t) * self.unpace
    }

    /// The children of a node, a bit each, whose boxes some ray may meet at a parameter of the shaft in [from, to]. For
    /// each child a lower bound on the parameter at which the first ray enters its box comes with them.
    #[inline]
    pub fn meets(&self, node: &Node, [from, to]: [f32; 2]) -> (u32, [f32; WIDTH]) {
        let (mut near, mut far) = (f32x8::splat(from), f32x8::splat(to));
        for (side, boxes) in self.sides.iter().zip(&node.sides) {
            for (i, planes) in boxes.iter().enumerate() {
                let at = (*planes - f32x8::splat(side.origin[i])) * f32x8::splat(side.inverse[i]);
                match side.enters[i] {
                    true => near = near.fast_max(at),
                    false => far = far.fast_min(at),
                }
            }
        }
        near *= f32x8::splat(1.0 - PARAMETER_REL_ERROR);
        far *= f32x8::splat(1.0 + PARAMETER_REL_ERROR);
        (near.simd_le(far).to_bitmask(), near.to_array())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::wide_bvh::{Is, Tree};
    use crate::testing::random;

    /// No box is missed that a ray of the bundle goes through, nor is it said to be farther away than it is.
    #[test]
    fn shafts_miss_no_box_that_a_ray_meets() {
        let mut next = random();
        let mut real = move |size: f64| (next(2_000_001) as f64 / 1e6 - 1.0) * size;
        let mut met = 0;
        for round in 0..400 {
            let size = [1.0, 1e6, 1e-9][round % 3];
            let mut vector = |size: f64| Vec3::new(real(size), real(size), real(size));
            let boxes: Vec<(u32, Aabb)> = (0..8)
                .map(|i| {
                    let (p, q) = (vector(2.0 * size), vector(size).abs());
                    (i, Aabb::new(p, p + q))
                })
                .collect();
            let frame = Frame::around(boxes.iter().map(|(_, b)| b));
            let tree = Tree::new(boxes.clone(), &frame);
            let rays: Vec<[Vec3; 2]> = (0..40)
                .map(|_| {
                    let mut direction = vector(0.3) + Vec3::new(0.0, 0.0, 1.0);
                    if round % 5 == 0 {
                        direction = Vec3::new(0.0, direction[1], direction[2]);
                    }
                    [vector(size) - Vec3::new(0.0, 0.0, 6.0 * size), direction]
                })
                .collect();
            let bounds = |k: usize| {
                let all = rays.iter().map(|ray| Aabb::new(ray[k], ray[k]));
                all.fold(Aabb::EMPTY, |all, p| all.hull(&p))
            };
            let [start, directions] = [bounds(0), bounds(1)];
            let directions = [Vec3(directions.min), Vec3(directions.max)];
            let shaft = Shaft::new(&start, directions, &frame).unwrap();
            let to = 20.0 * size;
            let (found, near) = shaft.meets(&tree.nodes[0], [0.0, shaft.pace(to)]);
            for (slot, child) in tree.nodes[0].children.iter().enumerate() {
                let Is::Item(item) = child.is() else { continue };
                let Some((_, bounds)) = boxes.get(item as usize) else {
                    continue;
                };
                for &[origin, direction] in &rays {
                    let line = crate::geometry::line::Line::new(origin, direction);
                    let Some((t, _)) = bounds.clip(&line, 0.0, to) else {
                        continue;
                    };
                    met += 1;
                    assert!(found >> slot & 1 == 1, "{round} {bounds:?} {line:?}");
                    assert!(near[slot] <= shaft.pace(t) * 1.001 + 1e-6, "{round}");
                }
            }
        }
        assert!(met > 1000, "{met}");
    }
}
