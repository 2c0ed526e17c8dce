//! The ellipsoid about the origin.

use super::around::Around;
use super::ball;
use super::facts::*;
use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::BALL;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

pub struct Ellipsoid {
    pub semi_axes: Vec3,
}

impl Ellipsoid {
    /// x²/a² + y²/b² + z²/c² − 1, times the squares of the semi-axes.
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
        Around::new(m).ellipsoid([0.0; 3], self.semi_axes).boxed()
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        Some(Ball {
            centre: [0.0; 3],
            semi_axes: self.semi_axes,
            held: 1.0,
        })
    }

    fn farthest(&self, _: &Matrix, _: Vec3) -> Option<f64> {
        None
    }

    fn support(&self, d: Vec3) -> Option<Support> {
        let axes = self.semi_axes;
        let n = ball::direction(std::array::from_fn(|i| axes[i] * d[i]));
        Some(Support::towards(
            std::array::from_fn(|i| axes[i] * n[i]),
            [0.0; 3],
        ))
    }

    fn home(&self) -> (Vec3, f64) {
        ([0.0; 3], 1.0)
    }

    fn place(&self) -> Option<Vec3> {
        Some([0.0; 3])
    }

    fn sizes(&self, sizes: &mut Sizes) {
        sizes.named(
            self.semi_axes,
            ["its semi-axis a", "its semi-axis b", "its semi-axis c"],
        );
    }

    fn holds(&self, p: Vec3) -> bool {
        at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let unit = |a: f64| 1.0 / (a * a);
        Taylor::sum(p, self.semi_axes.map(unit), -1.0, 0.0)
    }

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        let [a, b, c] = self.semi_axes;
        out.round(Part::All, [0.0; 3], (a * b * c).cbrt(), BALL);
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        if part != Part::All {
            return None;
        }
        let mut out = [[0.0; 4]; 4];
        (0..3).for_each(|i| out[i][i] = 1.0 / (self.semi_axes[i] * self.semi_axes[i]));
        out[3][3] = -1.0;
        Some(out)
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        ball::samples([0.0; 3], self.semi_axes)
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
        let [a, b, c] = self.semi_axes.map(|x| ball::grown(x, by));
        Some(Geometry::Ellipsoid {
            semi_axes: [a?, b?, c?],
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
