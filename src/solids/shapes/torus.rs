//! The torus about the y axis.

use super::around::Around;
use super::ball;
use super::circle;
use super::facts::*;
use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::directions::turn;
use crate::solids::contacts::face::TORUS;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

pub struct Torus {
    pub major: f64,
    pub minor: f64,
}

impl Torus {
    /// (x² + y² + z² + R² − r²)² − 4R²(x² + z²): at most zero in the tube and, by the even-odd rule, not
    /// in the lemon.
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
            is_flat: false,
            is_quadric: false,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        Around::new(m).torus(self.major, self.minor).boxed()
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        let out = self.major + self.minor;
        let rims = [self.minor, -self.minor].into_iter();
        Some(rims.flat_map(|y| circle::around(out, y)).collect())
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64> {
        let scale = ball::even_scale(m)?;
        // The point of the tube's core that is furthest away, and from there as much further.
        let [x, y, z] = m.inverse()?.point(p);
        Some(scale * ((x.hypot(z) + self.major).hypot(y) + self.minor))
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let (core, n) = (circle::towards(d, self.major, 0.0), ball::direction(d));
        let point = std::array::from_fn(|i| core[i] + self.minor * n[i]);
        Some(Support::towards(point, core))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        Some([0.0; 3])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        sizes.axes([self.major, 0.0, self.major], ["its ring's radius R"; 3]);
        sizes.axes([self.minor; 3], ["its tube's radius r"; 3]);
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
        // By the even-odd rule.
        ring(self.major).both(Taylor::flat(-far.f, far.g.map(|x| -x)))
    }

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        out.round(Part::All, [0.0; 3], self.major + self.minor, TORUS);
    }

    fn quadric(&self, _: Part) -> Option<Form> {
        None
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        let (major, minor) = (self.major, self.minor);
        (0..24)
            .map(|i| {
                let (su, cu) = turn(i);
                let (sv, cv) = (f64::from(i) * 1.137 + 0.2).sin_cos();
                let ring = major + minor * cv;
                ([ring * cu, minor * sv, ring * su], [cv * cu, sv, cv * su])
            })
            .collect()
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
        (self.major < self.minor).then_some(Crossing::Tube)
    }

    fn offset(&self, by: f64) -> Option<Geometry> {
        if self.major <= self.minor {
            return None;
        }
        Some(Geometry::Torus {
            major: self.major,
            minor: ball::grown(self.minor, by).filter(|r| *r < self.major)?,
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
