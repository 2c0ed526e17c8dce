//! Axis-aligned boxes whose sides may be infinitely far away.

use super::affine::Affine;
use super::array::{each, length};
use super::line::Line;
use super::matrix::Matrix;
use super::vec::gamma;

/// The points between `min` and `max`, faces included. A box with `min` above `max` in some
/// coordinate is empty; faces may lie at infinity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    pub min: [f64; 3],
    pub max: [f64; 3],
}

/// The relative rounding error of a product of a matrix row and a point: four products, four sums
/// and the error of the point itself, with room to spare.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The greatest gap between boxes that count as touching, as a share of their coordinates: far more than rounding, and
/// far less than any gap that is meant.
const TOUCH_REL_GAP: f64 = 1e-9;

impl Aabb {
    pub const EMPTY: Aabb = Aabb {
        min: [f64::INFINITY; 3],
        max: [f64::NEG_INFINITY; 3],
    };
    /// The box of all space.
    pub const ALL: Aabb = Aabb {
        min: [f64::NEG_INFINITY; 3],
        max: [f64::INFINITY; 3],
    };

    #[inline]
    pub fn new(min: impl Into<[f64; 3]>, max: impl Into<[f64; 3]>) -> Aabb {
        let (min, max) = (min.into(), max.into());
        Aabb { min, max }
    }

    #[inline]
    pub fn is_empty(&self) -> bool {
        (0..3).any(|i| self.min[i] > self.max[i])
    }

    /// Whether the box is empty or has all its faces at finite places.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.is_empty() || self.min.iter().chain(&self.max).all(|x| x.is_finite())
    }

    /// Whether the box holds anything and has all its faces at finite places.
    #[inline]
    pub fn is_bounded(&self) -> bool {
        self.is_finite() && !self.is_empty()
    }

    /// The smallest box around both boxes.
    #[inline]
    pub fn hull(&self, other: &Aabb) -> Aabb {
        if self.is_empty() {
            return *other;
        }
        if other.is_empty() {
            return *self;
        }
        Aabb {
            min: each([0, 1, 2], |i| self.min[i].min(other.min[i])),
            max: each([0, 1, 2], |i| self.max[i].max(other.max[i])),
        }
    }

    #[inline]
    pub fn intersection(&self, other: &Aabb) -> Aabb {
        Aabb {
            min: each([0, 1, 2], |i| self.min[i].max(other.min[i])),
            max: each([0, 1, 2], |i| self.max[i].min(other.max[i])),
        }
    }

    /// Whether the two have a point in common; touching faces count.
    #[inline]
    pub fn overlaps(&self, other: &Aabb) -> bool {
        !self.intersection(other).is_empty()
    }

    /// Whether the two boxes have a point in common, or are so near to each other that rounding may have parted them.
    #[inline]
    pub fn touches(&self, other: &Aabb) -> bool {
        let hair = TOUCH_REL_GAP * self.far().max(other.far());
        (0..3).all(|i| self.min[i] <= other.max[i] + hair && other.min[i] <= self.max[i] + hair)
    }

    /// The largest absolute value of the box's coordinates.
    #[inline]
    pub fn reach(&self) -> f64 {
        let all = [self.min, self.max].into_iter().flatten();
        all.fold(0.0, |m, x| m.max(x.abs()))
    }

    /// The largest absolute value of the box's finite coordinates.
    pub fn far(&self) -> f64 {
        let finite = [self.min, self.max]
            .into_iter()
            .flatten()
            .filter(|x| x.is_finite());
        finite.fold(0.0, |m, x| m.max(x.abs()))
    }

    pub fn contains(&self, p: [f64; 3]) -> bool {
        (0..3).all(|i| self.min[i] <= p[i] && p[i] <= self.max[i])
    }

    /// Whether all of the other box lies in this one.
    pub fn holds(&self, other: &Aabb) -> bool {
        other.is_empty() || (self.contains(other.min) && self.contains(other.max))
    }

    /// The middle of a finite box that is not empty.
    #[inline]
    pub fn centre(&self) -> [f64; 3] {
        each([0, 1, 2], |i| self.min[i] / 2.0 + self.max[i] / 2.0)
    }

    pub fn corners(&self) -> [[f64; 3]; 8] {
        std::array::from_fn(|k| {
            each([0, 1, 2], |i| match k >> i & 1 {
                0 => self.min[i],
                _ => self.max[i],
            })
        })
    }

    /// Half the diagonal of a finite box that is not empty: the radius of the sphere around it.
    pub fn radius(&self) -> f64 {
        let half: [f64; 3] = each([0, 1, 2], |i| self.max[i] / 2.0 - self.min[i] / 2.0);
        length(half)
    }

    /// A box around the image under an affine matrix: interval arithmetic, row by row, rounded
    /// outwards.
    pub fn transformed(&self, m: &Matrix) -> Aabb {
        if self.is_empty() {
            return Aabb::EMPTY;
        }
        let mut out = Aabb::ALL;
        for (i, row) in m.0.iter().take(3).enumerate() {
            let (mut low, mut high) = (row[3], row[3]);
            let (mut low_error, mut high_error) = (row[3].abs(), row[3].abs());
            for j in (0..3).filter(|&j| row[j] != 0.0) {
                let (a, b) = (row[j] * self.min[j], row[j] * self.max[j]);
                low += a.min(b);
                high += a.max(b);
                low_error += a.min(b).abs();
                high_error += a.max(b).abs();
            }
            out.min[i] = outwards(low - ROUNDING * low_error, f64::NEG_INFINITY);
            out.max[i] = outwards(high + ROUNDING * high_error, f64::INFINITY);
        }
        out
    }

    #[inline]
    pub fn extent(&self) -> [f64; 3] {
        each([0, 1, 2], |i| self.max[i] - self.min[i])
    }

    /// Half the surface area, which the surface area heuristic compares.
    #[inline]
    pub fn half_area(&self) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let e = self.extent();
        e[0] * e[1] + e[1] * e[2] + e[2] * e[0]
    }

    /// A box that certainly holds the image of everything in this one.
    ///
    /// Arvo's method (Graphics Gems, "Transforming axis-aligned bounding boxes") gives the box. The box is then widened
    /// by the rounding of the sums, and of the points on the surfaces inside, which are images under this matrix, too.
    /// Each rounding is at most γ₄(Σ|mᵢⱼ xⱼ| + |tᵢ|), so the box is widened by twice as much.
    pub fn image(&self, m: &Affine) -> Aabb {
        if self.is_empty() {
            return Aabb::EMPTY;
        }
        let mut out = Aabb::EMPTY;
        for i in 0..3 {
            let (mut low, mut high, mut size) = (m.offset[i], m.offset[i], m.offset[i].abs());
            for j in 0..3 {
                let k = m.rows[i][j];
                if k != 0.0 {
                    let (a, b) = (k * self.min[j], k * self.max[j]);
                    low += a.min(b);
                    high += a.max(b);
                    size += a.abs().max(b.abs());
                }
            }
            let slack = 2.0 * gamma(4) * size;
            // An infinite side stays where it is; it must not turn a finite one into a NaN.
            let slack = if slack.is_finite() { slack } else { 0.0 };
            out.min[i] = low - slack;
            out.max[i] = high + slack;
        }
        out
    }

    /// Widens a box computed from rounded corners by a few units in the last place.
    pub fn padded(&self) -> Aabb {
        let pad = |x: f64| {
            if x.is_finite() {
                gamma(4) * x.abs()
            } else {
                0.0
            }
        };
        Aabb::new(
            each(self.min, |x| x - pad(x)),
            each(self.max, |x| x + pad(x)),
        )
    }

    /// The part of `[from, to]` in which the line is in the box; `None` where there is none.
    /// `from` must not be negative.
    ///
    /// Each plane's t has three rounded operations behind it; the ends are widened by 1 ± 2γ₃, so
    /// that no box the exact line meets is missed (Ize, "Robust BVH Ray Traversal", JCGT 2(2),
    /// 2013). A NaN (a line in a face's plane) loses every comparison and restricts nothing.
    #[inline]
    pub fn clip(&self, line: &Line, from: f64, to: f64) -> Option<(f64, f64)> {
        const CLIP_REL_ERROR: f64 = 2.0 * gamma(3);
        let (mut near, mut far) = (from, f64::INFINITY);
        for i in 0..3 {
            // The processor cannot predict which side the ray meets first. So the sides are chosen by index, without a
            // branch.
            let sides = [self.min[i], self.max[i]];
            let first = usize::from(line.inverse[i] < 0.0);
            let a = (sides[first] - line.origin[i]) * line.inverse[i];
            let b = (sides[1 - first] - line.origin[i]) * line.inverse[i];
            near = if a > near { a } else { near };
            far = if b < far { b } else { far };
        }
        let near = from.max(near * (1.0 - CLIP_REL_ERROR));
        let far = to.min(far * (1.0 + CLIP_REL_ERROR));
        (near <= far).then_some((near, far))
    }

    /// The box grown by the rounding of the numbers that made it, whose size is `magnitude`.
    #[inline]
    pub fn padded_by(&self, magnitude: [f64; 3]) -> Aabb {
        Aabb {
            min: each([0, 1, 2], |i| {
                outwards(self.min[i] - ROUNDING * magnitude[i], f64::NEG_INFINITY)
            }),
            max: each([0, 1, 2], |i| {
                outwards(self.max[i] + ROUNDING * magnitude[i], f64::INFINITY)
            }),
        }
    }
}

/// Replaces an undefined sum, which comes of overflow, by the infinity that is safe to assume.
#[inline]
fn outwards(x: f64, safe: f64) -> f64 {
    if x.is_nan() { safe } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_side_by_side_touch() {
        let a = Aabb::new([0.0; 3], [0.3; 3]);
        // 0.1 + 0.2 is a rounding beyond 0.3.
        let b = Aabb::new([0.1 + 0.2, 0.0, 0.0], [1.0; 3]);
        assert!(!a.overlaps(&b) && a.touches(&b) && b.touches(&a));
        assert!(!a.touches(&Aabb::new([0.3 + 1e-6, 0.0, 0.0], [1.0; 3])));
        let ground = Aabb::new([f64::NEG_INFINITY; 3], [f64::INFINITY, 0.0, f64::INFINITY]);
        assert!(ground.touches(&a) && !ground.touches(&Aabb::EMPTY));
    }

    #[test]
    fn infinite_sides_stay_where_they_can() {
        let below = Aabb::new([f64::NEG_INFINITY; 3], [f64::INFINITY, 2.0, f64::INFINITY]);
        let moved = below.transformed(&Matrix::translation(5.0, 1.0, 0.0));
        assert!((moved.max[1] - 3.0).abs() < 1e-12);
        assert_eq!(moved.min[1], f64::NEG_INFINITY);
        let turned = below.transformed(&Matrix::rotation(90.0, 2));
        // What was below y = 2 is right of x = −2.
        assert!((turned.min[0] + 2.0).abs() < 1e-12);
        assert_eq!(turned.max, [f64::INFINITY; 3]);
        assert!(!turned.is_finite() && Aabb::EMPTY.is_finite());
    }
}
