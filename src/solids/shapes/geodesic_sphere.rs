//! The geodesic sphere.

use super::around::Around;
use super::facts::*;
use crate::geometry::array::{cross, dot, sub, unit};
use crate::geometry::dd::Dd;
use crate::geometry::number::Real;
use crate::geometry::vec;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;
use crate::solids::facet::{corner, facet};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeodesicSphere {
    pub radius: f64,
    pub splits: u32,
}

/// The radius of a ball that a geodesic sphere holds after 0, 1, 2 and more splits, as a share of the circumscribed
/// radius. The shares are rounded down from 0.7946, 0.9341, 0.9822 and 0.9954. Each split adds corners, and takes
/// nothing away.
const HELD: [f64; 4] = [0.79, 0.93, 0.98, 0.99];

/// An upper bound on the rounding of the corners in doubles, after any number of splits, for the sphere of radius 1.
const ROUNDED: f64 = 1e-13;

impl GeodesicSphere {
    pub fn held(&self) -> f64 {
        HELD[HELD.len().min(self.splits as usize + 1) - 1]
    }
}

impl Facts for GeodesicSphere {
    fn character(&self) -> Character {
        Character::PLAIN
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Around::new(m).ellipsoid([0.0; 3], [self.radius; 3]).boxed()
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let point = corner(d, self.splits).map(|x| self.radius * x);
        Some(Support::towards(point, [0.0; 3]))
    }

    /// Decided in double-double where doubles leave a doubt. Exact arithmetic does not help: the corners are not
    /// numbers of the record.
    fn holds(&self, p: Vec3) -> bool {
        let away = p[0].hypot(p[1]).hypot(p[2]);
        match away {
            a if a > self.radius * (1.0 + ROUNDED) => return false,
            a if a <= self.held() * self.radius => return true,
            _ => {}
        }
        let [a, b, c] = facet(vec::Vec3(p), self.splits).map(|v| v.0);
        if let Some(n) = unit(cross(sub(b, a), sub(c, a))) {
            let out = (dot(n, p.map(|x| x / self.radius)) - dot(n, a)) * dot(n, a).signum();
            if out.abs() > ROUNDED {
                return out < 0.0;
            }
        }
        let p = vec::Vec3(p).cast::<Dd>();
        let [a, b, c] = facet(p, self.splits);
        let n = (b - a).cross(c - a);
        let out = n.dot(p) - Dd::of(self.radius) * n.dot(a);
        match n.dot(a) < Dd::ZERO {
            true => out >= Dd::ZERO,
            false => out <= Dd::ZERO,
        }
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let [a, b, c] = facet(vec::Vec3(p), self.splits).map(|v| v.0);
        let n = cross(sub(b, a), sub(c, a));
        let n = if dot(n, a) < 0.0 { n.map(|x| -x) } else { n };
        Taylor::flat(dot(n, p) - self.radius * dot(n, a), n)
    }

    fn faces(&self, _: &mut Faces) {}
}
