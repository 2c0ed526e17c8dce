//! The sphere.

use super::around::Around;
use super::ball;
use super::facts::*;
use super::lengthen::Cut;
use super::sizes::RADIUS;
use super::sizes::Sizes;
use crate::geometry::array::{length, sub};
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::BALL;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use crate::solids::distance;

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
            is_flat: false,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
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

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        Some(Ball {
            centre: self.centre,
            semi_axes: [self.radius; 3],
            held: 1.0,
        })
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        Some(distance(m.point(self.centre), p) + self.radius * ball::even_scale(m)?)
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let n = ball::direction(d);
        let point = std::array::from_fn(|i| self.centre[i] + self.radius * n[i]);
        Some(Support::towards(point, self.centre))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        Some(self.centre)
    }

    fn sizes(&self, sizes: &mut Sizes) {
        sizes.axes([self.radius; 3], [RADIUS; 3]);
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

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        out.round(Part::All, self.centre, self.radius, BALL);
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        if part != Part::All {
            return None;
        }
        let mut out = [[0.0; 4]; 4];
        let square: f64 = self.centre.iter().map(|c| c * c).sum();
        (0..3).for_each(|i| {
            out[i][i] = 1.0;
            (out[i][3], out[3][i]) = (-self.centre[i], -self.centre[i]);
        });
        out[3][3] = square - self.radius * self.radius;
        Some(out)
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        ball::samples(self.centre, [self.radius; 3])
    }

    fn plane(&self) -> Option<[f64; 4]> {
        None
    }

    fn flat_faces(&self, _: &Matrix) -> Vec<FlatFace> {
        Vec::new()
    }

    fn ends(&self, _: usize) -> Vec<f64> {
        Vec::new()
    }

    fn degenerate(&self) -> Option<Degenerate> {
        None
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        Some(Geometry::Sphere {
            centre: self.centre,
            radius: ball::grown(self.radius, by)?,
        })
    }

    fn lengthened(&self, _: &Cut) -> Option<Geometry> {
        None
    }

    fn written(&self, _: Part) -> Written {
        Written::ALL
    }

    fn moved_out(&self, _: Part, _: f64, _: f64) -> Option<Vec<Moved>> {
        None
    }
}
