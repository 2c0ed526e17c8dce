//! The surface of revolution about the y axis.

use super::around::Around;
use super::circle;
use super::crossing::first_crossing;
use super::facts::*;
use super::in_line::{InLine, in_line};
use super::lengthen::Cut;
use super::offset::offset_profile;
use super::profile;
use super::sizes::Sizes;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Rgb;
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

pub struct Revolution<'a> {
    pub profile: &'a [[f64; 2]],
    pub colours: &'a [Rgb],
}

/// Profiles longer than this are bounded before they are moved, to keep the work linear; and have no hull.
const LONG: usize = 64;

impl Facts for Revolution<'_> {
    fn character(&self) -> Character {
        Character {
            is_round: true,
            is_flat: false,
            is_quadric: false,
            is_smooth: false,
            has_colours: !self.colours.is_empty(),
            may_cover_itself: true,
        }
    }

    fn is_convex(&self) -> bool {
        self.profile.len() <= LONG && profile::is_convex(self.profile)
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        let rings = |around: Around| {
            let each = self.profile.iter();
            each.fold(around, |all, p| all.ring(p[1], p[0])).boxed()
        };
        match self.profile.len() <= LONG {
            true => rings(Around::new(m)),
            false => rings(Around::new(&Matrix::IDENTITY)).transformed(m),
        }
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        if self.profile.len() > LONG {
            return None;
        }
        let rims = self.profile.iter();
        Some(rims.flat_map(|p| circle::around(p[0], p[1])).collect())
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, _: &Matrix, _: Vec3) -> Option<f64> {
        None
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let profile = self.profile;
        let out = d[0].hypot(d[2]);
        let far = |p: &[f64; 2]| out * p[0] + d[1] * p[1];
        let indices = 0..profile.len();
        let i = indices.max_by(|&i, &j| far(&profile[i]).total_cmp(&far(&profile[j])))?;
        let [x, y] = profile[i];
        // Half-way between the two pieces that meet there.
        let [a, b] = profile::neighbours(profile, i).map(|q| circle::unit([q[0] - x, q[1] - y]));
        let [out, _, side] = circle::towards(d, 1.0, 0.0);
        Some(Support {
            point: circle::towards(d, x, y),
            inwards: Some([out * (a[0] + b[0]), a[1] + b[1], side * (a[0] + b[0])]),
        })
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        self.profile.first().map(|p| [0.0, p[1], 0.0])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        for axis in [0, 2] {
            for p in self.profile {
                sizes.along(axis, p[0], "a radius of its profile");
            }
            for w in self.profile.windows(2) {
                let (dx, dy) = (
                    (w[1][0] - w[0][0]) * sizes.stretch[axis],
                    (w[1][1] - w[0][1]) * sizes.stretch[1],
                );
                sizes.add(dx.hypot(dy), "a piece of its profile");
            }
        }
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

    fn pieces(&self) -> usize {
        self.profile.len()
    }

    fn faces(&self, out: &mut Faces) {
        if self.profile.len() <= LONG {
            out.revolution(self.profile);
        }
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        let Part::Piece(i) = part else {
            return None;
        };
        let ([x0, y0], [x1, y1]) = (*self.profile.get(i)?, *self.profile.get(i + 1)?);
        let slope = (x1 - x0) / (y1 - y0);
        Some(circle::cone(slope, x0 - slope * y0))
    }

    fn mantle(&self, part: Part) -> Option<Mantle> {
        let Part::Piece(i) = part else {
            return None;
        };
        let ([a, b], [c, d]) = (*self.profile.get(i)?, *self.profile.get(i + 1)?);
        Some(((a, b), (c, d)))
    }

    fn samples(&self) -> Vec<Sample> {
        Vec::new()
    }

    fn plane(&self) -> Option<[f64; 4]> {
        None
    }

    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        let ends = [1.0, -1.0].map(|sign: f64| {
            let highest = |y: f64, p: &[f64; 2]| y.max(sign * p[1]);
            let y = self.profile.iter().fold(f64::NEG_INFINITY, highest) * sign;
            let level = self.profile.iter().filter(|p| p[1] == y);
            circle::disc(y, level.fold(0.0, |r, p| p[0].max(r)), sign, m)
        });
        ends.into()
    }

    fn ends(&self, axis: usize) -> Vec<f64> {
        match axis == 1 {
            true => self.profile.iter().map(|p| p[1]).collect(),
            false => Vec::new(),
        }
    }

    fn degenerate(&self) -> Option<Degenerate> {
        let line = in_line(&profile::closed(self.profile))?;
        let on_axis = self.profile.iter().all(|q| q[0] == 0.0);
        Some(Degenerate {
            case: match line {
                _ if on_axis => "axis",
                InLine::Exactly => "profile",
                InLine::Rounded => "profile-nearly",
            },
            params: (1, 2 * self.profile.len()),
            equal: Vec::new(),
        })
    }

    fn crossing(&self) -> Option<Crossing> {
        first_crossing(self.profile)
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        Some(Geometry::Revolution {
            profile: offset_profile(self.profile, |_| by)?,
            colours: Vec::new(),
        })
    }

    fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        if !self.colours.is_empty() {
            return None;
        }
        Some(Geometry::Revolution {
            profile: longer.profile(self.profile)?,
            colours: Vec::new(),
        })
    }

    fn written(&self, part: Part) -> Written {
        match part {
            Part::Cap(i) => Written::at(1 + 2 * i, 2, "disc"),
            Part::Piece(i) => Written::at(1 + 2 * i, 4, "piece"),
            _ => Written::ALL,
        }
    }

    fn moved_out(&self, part: Part, share: f64, _: f64) -> Option<Vec<Moved>> {
        let points = profile::level_points(self.profile, part, share)?;
        let moved = points.into_iter().map(|(i, y, hair)| (2 + 2 * i, y, hair));
        Some(moved.collect())
    }
}
