//! The torus about the y axis.

use super::around::Around;
use super::ball;
use super::circle;
use super::facts::*;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::TORUS;
use crate::solids::contacts::face::{FaceId, Faces};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    pub major: f64,
    pub minor: f64,
}

impl Torus {
    /// (x² + y² + z² + R² − r²)² − 4R²(x² + z²). The value is at most zero in the tube and, by the even-odd rule, above
    /// zero in the lemon, where the tube overlaps itself.
    fn quartic_at<N: Scalar>(&self, p: Vec3) -> N {
        let [x, y, z] = p.map(|c| N::of(c).square());
        let [major, minor] = [self.major, self.minor].map(|r| N::of(r).square());
        let across = x + z;
        let sum = across.clone() + y + major.clone() - minor;
        sum.square() - N::of(4.0) * major * across
    }
}

impl Facts for Torus {
    fn character(&self) -> Character {
        Character {
            is_round: true,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Around::new(m).torus(self.major, self.minor).boxed()
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let (core, n) = (circle::towards(d, self.major, 0.0), ball::direction(d));
        let point = std::array::from_fn(|i| core[i] + self.minor * n[i]);
        Some(Support::towards(point, core))
    }

    fn holds(&self, p: Vec3) -> bool {
        at_most_zero(self.quartic_at(p), || self.quartic_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let (around, y) = (p[0].hypot(p[2]), p[1]);
        let ring = |middle: f64| {
            let out = around - middle;
            let away = out.hypot(y);
            match away > 0.0 {
                true => Taylor::turned(p, away - self.minor, out / away, y / away),
                false => Taylor::turned(p, -self.minor, 1.0, 0.0),
            }
        };
        let far = ring(-self.major);
        // By the even-odd rule the lemon is outside.
        ring(self.major).both(Taylor::flat(-far.f, far.g.map(|x| -x)))
    }

    fn faces(&self, out: &mut Faces) {
        out.round(FaceId::All, [0.0; 3], self.major + self.minor, TORUS);
    }
}
