//! The cone and the double cone about the y axis, apex at the origin.

use super::around::Around;
use super::circle;
use super::facts::*;
use crate::geometry::array::dot;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::CONE;
use crate::solids::contacts::face::{FaceId, Faces};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    pub height: f64,
    pub radius: f64,
    pub double: bool,
}

impl Cone {
    /// (x²/r² + z²/r² − y²/h²) · r²h².
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        let [x, y, z] = p.map(|c| N::of(c).square());
        let [h, r] = [self.height, self.radius].map(|c| N::of(c).square());
        (x + z) * h - y * r
    }

    /// The function of one half of the cone. `along` is the height of the point from the apex towards the base, and
    /// `up` is the sign of y in that direction.
    fn half(&self, p: Vec3, along: f64, up: f64) -> Taylor {
        let (height, radius) = (self.height.abs(), self.radius);
        let around = p[0].hypot(p[2]);
        let slant = height.hypot(radius);
        let side = (around * height - along * radius) / slant;
        Taylor::turned(p, along - height, 0.0, up).both(Taylor::turned(
            p,
            side,
            height / slant,
            -up * radius / slant,
        ))
    }
}

impl Facts for Cone {
    fn character(&self) -> Character {
        Character {
            is_round: true,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        !self.double
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let around = match self.double {
            true => Around::new(m)
                .ring(self.height, self.radius)
                .ring(-self.height, self.radius),
            false => Around::new(m)
                .ellipsoid([0.0; 3], [0.0; 3])
                .ring(self.height, self.radius),
        };
        around.boxed()
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        if self.double {
            let y = if d[1] < 0.0 {
                -self.height
            } else {
                self.height
            };
            let rim = circle::towards(d, self.radius, y);
            return Some(Support::towards(rim, [0.0, 0.75 * y, 0.0]));
        }
        let base = circle::towards(d, self.radius, self.height);
        let point = if dot(base, d) > 0.0 { base } else { [0.0; 3] };
        Some(Support::towards(point, [0.0, 0.75 * self.height, 0.0]))
    }

    fn holds(&self, p: Vec3) -> bool {
        let y = if self.height < 0.0 { -p[1] } else { p[1] };
        let least = if self.double { -self.height.abs() } else { 0.0 };
        let level = (least..=self.height.abs()).contains(&y);
        level && at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let y = p[1];
        match self.double {
            true => self.half(p, y.abs(), if y < 0.0 { -1.0 } else { 1.0 }),
            false => self.half(p, self.height.signum() * y, self.height.signum()),
        }
    }

    fn faces(&self, out: &mut Faces) {
        let base = |upper| FaceId::Base { upper };
        let ring = (0.0, self.radius);
        match self.double {
            true => {
                out.disc(base(true), self.height, ring, 1.0);
                out.disc(base(false), -self.height, ring, -1.0);
            }
            false => out.disc(base(true), self.height, ring, self.height.signum()),
        }
        out.round(FaceId::Mantle, [0.0; 3], 0.0, CONE);
    }
}
