//! The cone and the double cone about the y axis, apex at the origin.

use super::around::Around;
use super::circle;
use super::facts::*;
use super::lengthen::Cut;
use super::lengthen::HAIR;
use super::offset::offset_profile;
use super::sizes::RADIUS;
use super::sizes::Sizes;
use crate::geometry::array::dot;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::CONE;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

pub struct Cone {
    pub height: f64,
    pub radius: f64,
    pub double: bool,
}

impl Cone {
    /// x²/r² + z²/r² − y²/h², times the squares of both.
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        let [x, y, z] = p.map(|c| N::of(c).square());
        let [h, r] = [self.height, self.radius].map(|c| N::of(c).square());
        (x + z) * h - y * r
    }

    /// From the apex upwards, in the height.
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
            is_flat: false,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
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

    fn hull(&self) -> Option<Vec<Vec3>> {
        let mut out: Vec<Vec3> = circle::around(self.radius, self.height).collect();
        match self.double {
            true => out.extend(circle::around(self.radius, -self.height)),
            false => out.push([0.0; 3]),
        }
        Some(out)
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, _: &Matrix, _: Vec3) -> Option<f64> {
        None
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

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        Some([0.0; 3])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        sizes.axes(
            [self.radius, self.height.abs(), self.radius],
            [RADIUS, "its height", RADIUS],
        );
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

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        let base = |upper| Part::Base { upper };
        let ring = (0.0, self.radius);
        match self.double {
            true => {
                out.disc(base(true), self.height, ring, 1.0);
                out.disc(base(false), -self.height, ring, -1.0);
            }
            false => out.disc(base(true), self.height, ring, self.height.signum()),
        }
        out.round(Part::Mantle, [0.0; 3], 0.0, CONE);
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        (part == Part::Mantle).then(|| circle::cone(self.radius / self.height, 0.0))
    }

    /// Of a double cone one half stands for both.
    fn mantle(&self, part: Part) -> Option<Mantle> {
        (part == Part::Mantle).then_some(((0.0, 0.0), (self.radius, self.height)))
    }

    fn samples(&self) -> Vec<Sample> {
        Vec::new()
    }

    fn plane(&self) -> Option<[f64; 4]> {
        None
    }

    /// Those of a double cone are not moved, and POV-Ray shows which it likes.
    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace> {
        match self.double {
            true => Vec::new(),
            false => vec![circle::disc(
                self.height,
                self.radius,
                self.height.signum(),
                m,
            )],
        }
    }

    fn ends(&self, axis: usize) -> Vec<f64> {
        match axis == 1 && !self.double {
            true => vec![self.height],
            false => Vec::new(),
        }
    }

    fn degenerate(&self) -> Option<Degenerate> {
        (self.height == 0.0 && !self.double).then(|| Degenerate {
            case: "cone",
            params: (0, 1),
            equal: Vec::new(),
        })
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        if self.double {
            return None;
        }
        Some(Geometry::Revolution {
            profile: offset_profile(&[[0.0, 0.0], [self.radius, self.height]], |_| by)?,
            colours: Vec::new(),
        })
    }

    fn lengthened(&self, longer: &Cut) -> Option<Geometry> {
        if self.double {
            return None;
        }
        let (cut, height, radius) = (&longer.around, self.height, self.radius);
        let size = height.abs().max(longer.size(1));
        let near = |y: f64| (height - y).abs() <= HAIR * size;
        let flush = (height > 0.0 && near(cut.max[1])) || (height < 0.0 && near(cut.min[1]));
        let by = 1.0 + longer.step(height.abs()) / height.abs();
        flush.then_some(Geometry::Cone {
            height: by * height,
            radius: by * radius,
        })
    }

    fn written(&self, part: Part) -> Written {
        match part {
            Part::Mantle => Written::at(0, 2, "mantle"),
            _ => Written::at(0, 1, "base"),
        }
    }

    fn moved_out(&self, part: Part, share: f64, _: f64) -> Option<Vec<Moved>> {
        if !matches!(part, Part::Base { .. }) {
            return None;
        }
        // Both numbers together keep the mantle where it is.
        let numbers = [self.height, self.radius].into_iter().enumerate();
        let moved = numbers.map(|(i, x)| (i, x + share * x, (share * x).abs()));
        Some(moved.collect())
    }
}
