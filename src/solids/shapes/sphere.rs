//! The sphere.

use super::around::Around;
use super::ball;
use super::facts::*;
use crate::geometry::array::{length, sub};
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::BALL;
use crate::solids::contacts::face::{FaceId, Faces};

pub struct Sphere {
    pub centre: Vec3,
    pub radius: f64,
}

impl Sphere {
    /// |p − c|² − r².
    fn power_of<N: Scalar>(&self, p: Vec3) -> N {
        let radius = N::of(self.radius);
        (0..3).fold(-radius.square(), |sum, i| {
            sum + (N::of(p[i]) - N::of(self.centre[i])).square()
        })
    }
}

impl Facts for Sphere {
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
        Around::new(m)
            .ellipsoid(self.centre, [self.radius; 3])
            .boxed()
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let n = ball::direction(d);
        let point = std::array::from_fn(|i| self.centre[i] + self.radius * n[i]);
        Some(Support::towards(point, self.centre))
    }

    fn holds(&self, p: Vec3) -> bool {
        at_most_zero(self.power_of(p), || self.power_of(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let v = sub(p, self.centre);
        let away = length(v);
        let g = match away > 0.0 {
            true => v.map(|c| c / away),
            false => [1.0, 0.0, 0.0],
        };
        Taylor::flat(away - self.radius, g)
    }

    fn faces(&self, out: &mut Faces) {
        out.round(FaceId::All, self.centre, self.radius, BALL);
    }
}
