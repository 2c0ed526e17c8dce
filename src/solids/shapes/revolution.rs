//! The surface of revolution about the y axis.

use super::around::Around;
use super::circle;
use super::facts::*;
use super::profile;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Rgb;
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;

pub struct Revolution<'a> {
    pub profile: &'a [[f64; 2]],
    pub colours: &'a [Rgb],
}

/// The most points of a profile that is examined point by point. For a longer profile the box is made before the shape
/// is moved, to keep the work linear, and there is no hull.
pub const MAX_EXAMINED_POINTS: usize = 64;

impl Facts for Revolution<'_> {
    fn character(&self) -> Character {
        Character {
            is_round: true,
            has_colours: !self.colours.is_empty(),
            may_cover_itself: true,
            ..Character::PLAIN
        }
    }

    fn is_convex(&self) -> bool {
        self.profile.len() <= MAX_EXAMINED_POINTS && profile::is_convex(self.profile)
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let rings = |around: Around| {
            let each = self.profile.iter();
            each.fold(around, |all, p| all.ring(p[1], p[0])).boxed()
        };
        match self.profile.len() <= MAX_EXAMINED_POINTS {
            true => rings(Around::new(m)),
            false => rings(Around::new(&Matrix::IDENTITY)).transformed(m),
        }
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let profile = self.profile;
        let out = d[0].hypot(d[2]);
        let far = |p: &[f64; 2]| out * p[0] + d[1] * p[1];
        let indices = 0..profile.len();
        let i = indices.max_by(|&i, &j| far(&profile[i]).total_cmp(&far(&profile[j])))?;
        let [x, y] = profile[i];
        // The way inwards is halfway between the two pieces that meet at the point.
        let [a, b] = profile::neighbours(profile, i).map(|q| circle::unit([q[0] - x, q[1] - y]));
        let [out, _, side] = circle::towards(d, 1.0, 0.0);
        Some(Support {
            point: circle::towards(d, x, y),
            inwards: Some([out * (a[0] + b[0]), a[1] + b[1], side * (a[0] + b[0])]),
        })
    }

    fn holds(&self, p: Vec3) -> bool {
        profile::holds(self.profile, p)
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let (around, y) = (p[0].hypot(p[2]), p[1]);
        let (away, out, up) = profile::nearest(self.profile, around, y);
        let inside = profile::holds(self.profile, [around, y, 0.0]);
        let sign = if inside { -1.0 } else { 1.0 };
        Taylor::turned(p, sign * away, sign * out, sign * up)
    }

    fn faces(&self, out: &mut Faces) {
        if self.profile.len() <= MAX_EXAMINED_POINTS {
            out.revolution(self.profile);
        }
    }
}
