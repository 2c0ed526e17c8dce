//! Axis-aligned boxes that hold at least what they bound.

use super::affine::Affine;
use super::ray::Beam;
use super::vec::{Vec3, gamma};

/// An axis-aligned box; sides may lie at infinity. Empty where a lower side exceeds the upper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    pub min: Vec3,
    pub max: Vec3,
}

impl Bounds {
    pub const EMPTY: Bounds = Bounds {
        min: Vec3([f64::INFINITY; 3]),
        max: Vec3([f64::NEG_INFINITY; 3]),
    };
    pub const EVERYTHING: Bounds = Bounds {
        min: Vec3([f64::NEG_INFINITY; 3]),
        max: Vec3([f64::INFINITY; 3]),
    };

    pub fn new(min: Vec3, max: Vec3) -> Bounds {
        Bounds { min, max }
    }

    pub fn is_empty(&self) -> bool {
        (0..3).any(|i| self.min[i] > self.max[i])
    }

    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    pub fn union(&self, other: &Bounds) -> Bounds {
        Bounds::new(
            self.min.zip(other.min, f64::min),
            self.max.zip(other.max, f64::max),
        )
    }

    pub fn intersection(&self, other: &Bounds) -> Bounds {
        Bounds::new(
            self.min.zip(other.min, f64::max),
            self.max.zip(other.max, f64::min),
        )
    }

    /// Whether the other box lies inside this one.
    pub fn holds(&self, other: &Bounds) -> bool {
        (0..3).all(|i| self.min[i] <= other.min[i] && other.max[i] <= self.max[i])
    }

    /// The largest coordinate, in size.
    pub fn reach(&self) -> f64 {
        self.min
            .abs()
            .max_component()
            .max(self.max.abs().max_component())
    }

    pub fn centre(&self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    pub fn extent(&self) -> Vec3 {
        self.max - self.min
    }

    /// Half the surface area; what the surface area heuristic compares.
    pub fn half_area(&self) -> f64 {
        let e = self.extent();
        if self.is_empty() {
            return 0.0;
        }
        e[0] * e[1] + e[1] * e[2] + e[2] * e[0]
    }

    /// A box that certainly holds the image of everything in this one.
    ///
    /// Arvo's method (Graphics Gems, "Transforming axis-aligned bounding boxes"), then widened by
    /// the rounding of the sums, and of the points on the surfaces inside, which are themselves
    /// images under this matrix: each is off by at most γ₄(Σ|mᵢⱼ xⱼ| + |tᵢ|), twice over.
    pub fn image(&self, m: &Affine) -> Bounds {
        if self.is_empty() {
            return Bounds::EMPTY;
        }
        let mut out = Bounds::EMPTY;
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
    pub fn padded(&self) -> Bounds {
        let pad = |x: f64| {
            if x.is_finite() {
                gamma(4) * x.abs()
            } else {
                0.0
            }
        };
        Bounds::new(self.min.map(|x| x - pad(x)), self.max.map(|x| x + pad(x)))
    }

    /// The part of `[from, to]` in which the line is in the box; `None` where there is none.
    /// `from` must not be negative.
    ///
    /// Each plane's t has three rounded operations behind it; the ends are widened by 1 ± 2γ₃, so
    /// that no box the exact line meets is missed (Ize, "Robust BVH Ray Traversal", JCGT 2(2),
    /// 2013). A NaN (a line in a face's plane) loses every comparison and restricts nothing.
    #[inline]
    pub fn clip(&self, beam: &Beam, from: f64, to: f64) -> Option<(f64, f64)> {
        const SLACK: f64 = 2.0 * gamma(3);
        let (mut near, mut far) = (from, f64::INFINITY);
        for i in 0..3 {
            let a = (self.min[i] - beam.low[i]) * beam.inverse[i];
            let b = (self.max[i] - beam.high[i]) * beam.inverse[i];
            let (a, b) = if beam.inverse[i] < 0.0 {
                (b, a)
            } else {
                (a, b)
            };
            near = if a > near { a } else { near };
            far = if b < far { b } else { far };
        }
        let near = from.max(near * (1.0 - SLACK));
        let far = to.min(far * (1.0 + SLACK));
        (near <= far).then_some((near, far))
    }
}
