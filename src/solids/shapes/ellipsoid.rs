//! The ellipsoid about the origin.

use super::around::Around;
use super::ball;
use super::facts::*;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::BALL;
use crate::solids::contacts::face::{FaceId, Faces};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    pub semi_axes: Vec3,
}

impl Ellipsoid {
    /// (x²/a² + y²/b² + z²/c² − 1) · a²b²c².
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        let [x, y, z] = p.map(|x| N::of(x).square());
        let [a, b, c] = self.semi_axes.map(|x| N::of(x).square());
        let (bc, ca, ab) = (b.clone() * c.clone(), c.clone() * a.clone(), a * b);
        x * bc + y * ca + z * ab.clone() - ab * c
    }
}

impl Facts for Ellipsoid {
    fn character(&self) -> Character {
        Character {
            is_round: true,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Around::new(m).ellipsoid([0.0; 3], self.semi_axes).boxed()
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let axes = self.semi_axes;
        let n = ball::direction(std::array::from_fn(|i| axes[i] * d[i]));
        Some(Support::towards(
            std::array::from_fn(|i| axes[i] * n[i]),
            [0.0; 3],
        ))
    }

    fn holds(&self, p: Vec3) -> bool {
        at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let unit = |a: f64| 1.0 / (a * a);
        Taylor::sum(p, self.semi_axes.map(unit), -1.0, 0.0)
    }

    fn faces(&self, out: &mut Faces) {
        let [a, b, c] = self.semi_axes;
        out.round(FaceId::All, [0.0; 3], (a * b * c).cbrt(), BALL);
    }
}
