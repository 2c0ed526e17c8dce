//! Four lines, each with a facet of its own: the same numbers as in [`shapes::facet`](crate::trace::shapes), computed in
//! the same order.

use super::lanes::{Lanes, V3, either, fused, is_greater, is_less};
use crate::geometry::array::each;

/// Maps that turn the directions of lines into the z axis and keep the other two axes where they are.
pub struct Shear {
    /// The lanes in which x becomes the z axis, and those in which y does, as masks.
    axes: [Lanes; 2],
    /// The directions over their longest components; these components are 1.
    pub slope: V3,
    /// The slopes along the axes that become x and y.
    across: [Lanes; 2],
    /// The longest components of the directions, signed: the depth gained while t grows by 1.
    pub pace: Lanes,
}

/// Points in the sheared spaces.
#[derive(Clone, Copy)]
pub struct Projected {
    x: Lanes,
    y: Lanes,
    depth: Lanes,
}

impl Shear {
    #[inline(always)]
    pub fn along(direction: V3) -> Shear {
        let [x, y, z] = direction.abs().0;
        let later = is_greater(y, x);
        let last = is_greater(z, x.fast_max(y));
        let axes = [!later & !last, later & !last];
        let pace = turned(direction, axes).0[2];
        let slope = direction.over(pace);
        let [x, y, _] = turned(slope, axes).0;
        Shear {
            axes,
            slope,
            across: [x, y],
            pace,
        }
    }

    /// Projects points, given relative to points of the lines. The points of the lines become the origins.
    #[inline(always)]
    pub fn project(&self, p: V3) -> Projected {
        let [x, y, depth] = turned(p, self.axes).0;
        Projected {
            x: x - self.across[0] * depth,
            y: y - self.across[1] * depth,
            depth,
        }
    }
}

/// The components of vectors along the axes that become x, y and z.
#[inline(always)]
fn turned(v: V3, [first, second]: [Lanes; 2]) -> V3 {
    let [x, y, z] = v.0;
    V3([
        either(first, y, either(second, z, x)),
        either(first, z, either(second, x, y)),
        either(first, x, either(second, y, z)),
    ])
}

/// Twice the signed areas of the triangles of the origins and two projected corners.
#[inline(always)]
fn edge(p: Projected, q: Projected) -> Lanes {
    let (a, b) = (p.x * q.y, p.y * q.x);
    (a - b) + (fused(p.x, q.y, -a) - fused(p.y, q.x, -b))
}

/// Projected facets and their edge functions, each opposite to the corner of the same number.
pub struct Facet {
    corners: [Projected; 3],
    edges: V3,
}

impl Facet {
    #[inline(always)]
    pub fn new(corners: [Projected; 3]) -> Facet {
        let [a, b, c] = corners;
        Facet {
            corners,
            edges: V3([edge(b, c), edge(c, a), edge(a, b)]),
        }
    }

    /// The barycentric weights of the corners where the lines pass.
    #[inline(always)]
    pub fn weights(&self) -> V3 {
        let [a, b, c] = self.edges.0;
        self.edges.over(a + b + c)
    }

    /// The depths at points with these weights.
    #[inline(always)]
    pub fn depth(&self, weights: V3) -> Lanes {
        let depths = V3(each(self.corners, |corner| corner.depth));
        (weights.dot(depths))
            .fast_max(depths.min_component())
            .fast_min(depths.max_component())
    }

    /// A mask: the lines that pass through the facets, and through no edge.
    #[inline(always)]
    pub fn is_passed(&self) -> Lanes {
        let zero = Lanes::ZERO;
        is_greater(self.edges.min_component(), zero) | is_less(self.edges.max_component(), zero)
    }

    /// Masks: the lines that surely go in against the slope's side, and those that surely go out, when every projected
    /// coordinate is off by at most `noise`.
    #[inline(always)]
    pub fn certain(&self, noise: Lanes) -> [Lanes; 2] {
        let [a, b, c] = each(self.corners, |corner| corner.x.abs() + corner.y.abs());
        let twice = noise + noise;
        let bounds = each([b + c, c + a, a + b], |sum| twice * (sum + noise));
        let [x, y, z] = each([0, 1, 2], |i: usize| is_less(self.edges.0[i], -bounds[i]));
        let [p, q, r] = each([0, 1, 2], |i: usize| is_greater(self.edges.0[i], bounds[i]));
        [x & y & z, p & q & r]
    }

    /// The largest projected coordinates, in size, without the depths.
    #[inline(always)]
    pub fn widest(&self) -> Lanes {
        self.corners.iter().fold(Lanes::ZERO, |widest, corner| {
            widest.fast_max(corner.x.abs()).fast_max(corner.y.abs())
        })
    }
}
