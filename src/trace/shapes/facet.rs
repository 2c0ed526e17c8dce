//! Flat triangular facets that lines cannot slip between.
//!
//! The method is that of Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1),
//! 2013: space is sheared so that the line becomes the z axis, and the facet is met where its
//! projection holds the origin of the xy plane. A projected corner depends on the line and that
//! corner alone, and an edge function changes nothing but its sign when its ends are swapped; so the
//! facets on both sides of an edge always agree about the side on which the line passes it.

use crate::geometry::array::each;
use crate::geometry::dd::Dd;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;

/// A vector of doubles in another kind of number.
pub(super) fn lift<R: Traced>(v: Vec3) -> Vec3<R> {
    Vec3(each(v.0, R::of))
}

/// A double-double number in another kind of number, rounded.
pub(super) fn narrow<R: Traced>(x: Dd) -> R {
    let (high, low) = x.parts();
    R::of(high) + R::of(low)
}

/// Bound on the error of a point's projection that comes from the error of the line, for points with coordinates up to
/// `reach`. Infinite where the direction is hardly known.
///
/// The point is projected relative to the line's point at the same depth. That point is off by the drift δ across, and
/// a slope up to 1 adds what it makes of δ in depth. Where the direction's components are off by a sixteenth of the
/// longest at most, the slope is up to (1 + 1/16) / (1 − 1/16), and t at that depth up to 1 / (1 − 1/16) times the t
/// that the drift is computed for: in all (1 + 1.134) · 1.067 < 2.5.
pub(super) fn drift_across<R: Traced>(line: &Line<R>, reach: R) -> R {
    let drift = line.drift(reach);
    if drift == R::ZERO {
        return drift;
    }
    let longest = line.direction.abs().max_component();
    if line.slack.direction <= longest * R::of(1.0 / 16.0) {
        drift * R::of(2.5)
    } else {
        R::INFINITY
    }
}

/// The map that turns a direction into the z axis and keeps the other two axes where they are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shear<R> {
    /// The axes that become x, y and z; z is the direction's longest one.
    axes: [usize; 3],
    /// The direction over its longest component; that component is 1.
    pub slope: Vec3<R>,
    /// The direction's longest component, signed: the depth gained while t grows by 1.
    pub pace: R,
}

/// A point in the sheared space; its z, the depth, is in units of [`Shear::slope`].
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Projected<R> {
    pub x: R,
    pub y: R,
    pub depth: R,
}

impl<R: Traced> Shear<R> {
    pub(super) fn along(direction: Vec3<R>) -> Shear<R> {
        let size = direction.abs();
        let mut z = 0;
        for i in 1..3 {
            if size[i] > size[z] {
                z = i;
            }
        }
        Shear {
            axes: [(z + 1) % 3, (z + 2) % 3, z],
            slope: direction / direction[z],
            pace: direction[z],
        }
    }

    /// Projects a point, given relative to a point of the line. The line's point becomes the origin.
    #[inline]
    pub(super) fn project(&self, p: Vec3<R>) -> Projected<R> {
        let [x, y, z] = self.axes;
        let depth = p[z];
        Projected {
            x: p[x] - self.slope[x] * depth,
            y: p[y] - self.slope[y] * depth,
            depth,
        }
    }
}

impl<R: Traced> Projected<R> {
    /// |x| + |y|.
    fn reach(&self) -> R {
        self.x.abs() + self.y.abs()
    }
}

/// Twice the signed area of the triangle of the origin and two projected points: which side of the
/// edge from p to q the line passes.
///
/// The result is the rounded products' difference, plus the difference of their rounding errors, which `mul_add` gives
/// exactly. It is off by one rounding of the result and a rounding of the errors, so that weights keep their digits
/// where a facet is seen at a flat angle. Rounding keeps the order of numbers, so the sign is never the wrong one, and
/// swapping p and q turns each step into its exact negative.
#[inline]
fn edge<R: Traced>(p: Projected<R>, q: Projected<R>) -> R {
    let (a, b) = (p.x * q.y, p.y * q.x);
    (a - b) + (p.x.mul_add(q.y, -a) - p.y.mul_add(q.x, -b))
}

/// The direction in which a line, taken along its [slope](Shear::slope), goes through a facet whose corners run
/// counter-clockwise around its normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PassageDirection {
    /// The slope points against the normal.
    In,
    Out,
}

/// A line's passage through a facet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage<R> {
    pub way: PassageDirection,
    /// Barycentric weights of the corners; none negative, their sum 1 but for rounding.
    pub weights: [R; 3],
    pub depth: R,
}

/// Whether a line may pass, and surely passes, through a facet in one of the two directions.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Certainty {
    /// Whether the line may pass through, within the rounding errors.
    pub possible: bool,
    /// Whether the line surely passes through, whatever the rounding errors.
    pub certain: bool,
}

/// A facet's projection and its edge functions, each opposite to the corner of the same number.
#[derive(Debug, Clone, Copy)]
pub(super) struct Facet<R> {
    corners: [Projected<R>; 3],
    edges: [R; 3],
}

impl<R: Traced> Facet<R> {
    #[inline]
    pub(super) fn new(corners: [Projected<R>; 3]) -> Facet<R> {
        let [a, b, c] = corners;
        Facet {
            corners,
            edges: [edge(b, c), edge(c, a), edge(a, b)],
        }
    }

    /// The passage of the line through the facet, whose edges and corners are a part of it. `None` for a facet that is
    /// seen edge-on, and where numbers overflow: every comparison with NaN fails.
    #[inline]
    pub(super) fn passage(&self) -> Option<Passage<R>> {
        let e = self.edges;
        let area = e[0] + e[1] + e[2];
        let way = if area > R::ZERO && e.iter().all(|&e| e >= R::ZERO) {
            PassageDirection::Out
        } else if area < R::ZERO && e.iter().all(|&e| e <= R::ZERO) {
            PassageDirection::In
        } else {
            return None;
        };
        let weights = each(e, |e| e / area);
        let z = each(self.corners, |c| c.depth);
        let depth = weights[0] * z[0] + weights[1] * z[1] + weights[2] * z[2];
        // The exact depth is between those of the corners.
        let depth = depth
            .max(z[0].min(z[1]).min(z[2]))
            .min(z[0].max(z[1]).max(z[2]));
        depth.is_finite().then_some(Passage {
            way,
            weights,
            depth,
        })
    }

    /// The certainty of the ways in and out when every projected coordinate is off by at most `noise`. None is certain
    /// where numbers overflow: a NaN may be a passage.
    ///
    /// p × q is then off by at most noise (|p|₁ + |q|₁) + 2 noise², and its own rounding adds
    /// γ₂|p|₁|q|₁ at most: less than the first term again, since `noise` exceeds γ₂ times any
    /// coordinate.
    pub(super) fn verdicts(&self, noise: R) -> [Certainty; 2] {
        let two = R::of(2.0);
        let [a, b, c] = each(self.corners, |c| c.reach());
        let bounds = each([b + c, c + a, a + b], |sum| two * noise * (sum + noise));
        let all = |holds: fn(R, R) -> bool| (0..3).all(|i| holds(self.edges[i], bounds[i]));
        let any = |holds: fn(R, R) -> bool| (0..3).any(|i| holds(self.edges[i], bounds[i]));
        [
            Certainty {
                possible: !any(|e, bound| e > bound),
                certain: all(|e, bound| e < -bound),
            },
            Certainty {
                possible: !any(|e, bound| e < -bound),
                certain: all(|e, bound| e > bound),
            },
        ]
    }
}

#[cfg(test)]
pub(super) mod tests;
