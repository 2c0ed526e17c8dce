//! Axis-aligned boxes whose sides may be infinitely far away.

use super::vector::length;
use super::{Matrix, Vec3};

/// The points between `min` and `max`, faces included. A box with `min` above `max` in some
/// coordinate is empty; faces may lie at infinity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    pub min: Vec3,
    pub max: Vec3,
}

/// The relative rounding error of a product of a matrix row and a point: four products, four sums
/// and the error of the point itself, with room to spare.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Boxes that are this near, as a part of their coordinates, touch: far more than roundings move anything, far less
/// than anybody means.
const NEAR: f64 = 1e-9;

impl Aabb {
    pub const EMPTY: Aabb = Aabb {
        min: [f64::INFINITY; 3],
        max: [f64::NEG_INFINITY; 3],
    };
    /// All of space.
    pub const ALL: Aabb = Aabb {
        min: [f64::NEG_INFINITY; 3],
        max: [f64::INFINITY; 3],
    };

    pub fn new(min: Vec3, max: Vec3) -> Aabb {
        Aabb { min, max }
    }

    pub fn is_empty(&self) -> bool {
        (0..3).any(|i| self.min[i] > self.max[i])
    }

    /// Whether the box is empty or has all its faces at finite places.
    pub fn is_finite(&self) -> bool {
        self.is_empty() || self.min.iter().chain(&self.max).all(|x| x.is_finite())
    }

    /// The smallest box around both.
    pub fn hull(&self, other: &Aabb) -> Aabb {
        if self.is_empty() {
            return *other;
        }
        if other.is_empty() {
            return *self;
        }
        Aabb {
            min: std::array::from_fn(|i| self.min[i].min(other.min[i])),
            max: std::array::from_fn(|i| self.max[i].max(other.max[i])),
        }
    }

    pub fn intersection(&self, other: &Aabb) -> Aabb {
        Aabb {
            min: std::array::from_fn(|i| self.min[i].max(other.min[i])),
            max: std::array::from_fn(|i| self.max[i].min(other.max[i])),
        }
    }

    /// Whether the two have a point in common; touching faces count.
    pub fn overlaps(&self, other: &Aabb) -> bool {
        !self.intersection(other).is_empty()
    }

    /// Whether the two have a point in common but for what a few roundings may have moved them apart.
    pub fn touches(&self, other: &Aabb) -> bool {
        let hair = NEAR * self.far().max(other.far());
        (0..3).all(|i| self.min[i] <= other.max[i] + hair && other.min[i] <= self.max[i] + hair)
    }

    /// The largest of its finite coordinates, in size.
    pub fn far(&self) -> f64 {
        let finite = [self.min, self.max]
            .into_iter()
            .flatten()
            .filter(|x| x.is_finite());
        finite.fold(0.0, |m, x| m.max(x.abs()))
    }

    pub fn contains(&self, p: Vec3) -> bool {
        (0..3).all(|i| self.min[i] <= p[i] && p[i] <= self.max[i])
    }

    /// Whether all of the other box lies in this one.
    pub fn holds(&self, other: &Aabb) -> bool {
        other.is_empty() || (self.contains(other.min) && self.contains(other.max))
    }

    /// The middle of a finite box that is not empty.
    pub fn centre(&self) -> Vec3 {
        std::array::from_fn(|i| self.min[i] / 2.0 + self.max[i] / 2.0)
    }

    /// Half the diagonal of a finite box that is not empty: the radius of the sphere around it.
    pub fn radius(&self) -> f64 {
        let half: Vec3 = std::array::from_fn(|i| self.max[i] / 2.0 - self.min[i] / 2.0);
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

    /// The box grown by the rounding of the numbers that made it.
    pub(super) fn padded(&self, magnitude: Vec3) -> Aabb {
        Aabb {
            min: std::array::from_fn(|i| {
                outwards(self.min[i] - ROUNDING * magnitude[i], f64::NEG_INFINITY)
            }),
            max: std::array::from_fn(|i| {
                outwards(self.max[i] + ROUNDING * magnitude[i], f64::INFINITY)
            }),
        }
    }
}

/// Overflow and undefined sums become the infinity that is safe to assume.
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
