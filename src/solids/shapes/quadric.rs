//! The quadrics: the general one, and those with a name.

use super::around::quadric_bounds;
use super::facts::*;
use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;
use crate::solids::contacts::quadric::samples;
use crate::solids::definite::{Verdict, is_ellipsoid, judge};

pub enum Quadric<'a> {
    /// xᵀQx ≤ 0.
    General(&'a [f64; 16]),
    /// x²/a² ≤ y.
    ParabolicCylinder { a: f64 },
    /// x²/a² − y²/b² ≤ 1.
    HyperbolicCylinder { a: f64, b: f64 },
    /// x²/a² − y²/b² + z²/c² ≤ ±1, with + for one sheet and − for two.
    Hyperboloid { a: f64, b: f64, c: f64, sheets: u32 },
    /// x²/a² − z²/b² ≤ y.
    HyperbolicParaboloid { a: f64, b: f64 },
}

impl Quadric<'_> {
    /// Its polynomial, without divisions.
    fn form_at<N: Scalar>(&self, p: Vec3) -> N {
        let square = |x: f64| N::of(x).square();
        let [x, y, z] = p;
        match *self {
            Quadric::General(q) => {
                let v = [x, y, z, 1.0];
                let terms = (0..16).map(|k| N::of(q[k]) * N::of(v[k / 4]) * N::of(v[k % 4]));
                terms.fold(N::of(0.0), |sum, term| sum + term)
            }
            Quadric::ParabolicCylinder { a } => square(x) - N::of(y) * square(a),
            Quadric::HyperbolicCylinder { a, b } => {
                square(x) * square(b) - (square(y) + square(b)) * square(a)
            }
            Quadric::Hyperboloid { a, b, c, sheets } => {
                let [a, b, c] = [a, b, c].map(square);
                let (bc, ca, ab) = (b.clone() * c.clone(), c.clone() * a.clone(), a * b);
                let one = match sheets == 2 {
                    true => -(ab.clone() * c),
                    false => ab.clone() * c,
                };
                square(x) * bc - square(y) * ca + square(z) * ab - one
            }
            Quadric::HyperbolicParaboloid { a, b } => {
                square(x) * square(b) - square(z) * square(a) - N::of(y) * square(a) * square(b)
            }
        }
    }

    /// The symmetric matrix.
    pub fn matrix(&self) -> Form {
        let square = |x: f64| 1.0 / (x * x);
        let (diagonal, linear) = match *self {
            Quadric::General(q) => {
                return std::array::from_fn(|i| {
                    std::array::from_fn(|j| q[4 * i + j] / 2.0 + q[4 * j + i] / 2.0)
                });
            }
            Quadric::ParabolicCylinder { a } => ([square(a), 0.0, 0.0, 0.0], -0.5),
            Quadric::HyperbolicCylinder { a, b } => ([square(a), -square(b), 0.0, -1.0], 0.0),
            Quadric::Hyperboloid { a, b, c, sheets } => {
                let last = if sheets == 1 { -1.0 } else { 1.0 };
                ([square(a), -square(b), square(c), last], 0.0)
            }
            Quadric::HyperbolicParaboloid { a, b } => ([square(a), 0.0, -square(b), 0.0], -0.5),
        };
        let mut out = [[0.0; 4]; 4];
        (0..4).for_each(|i| out[i][i] = diagonal[i]);
        (out[1][3], out[3][1]) = (linear, linear);
        out
    }
}

impl Facts for Quadric<'_> {
    fn character(&self) -> Character {
        Character {
            is_round: false,
            is_flat: false,
            is_quadric: true,
            is_smooth: false,
            has_colours: false,
            may_cover_itself: false,
        }
    }

    fn is_convex(&self) -> bool {
        match *self {
            Quadric::General(q) => is_ellipsoid(q),
            Quadric::ParabolicCylinder { .. } => true,
            Quadric::HyperbolicCylinder { .. }
            | Quadric::Hyperboloid { .. }
            | Quadric::HyperbolicParaboloid { .. } => false,
        }
    }

    fn bounds(&self, m: &Matrix) -> Aabb {
        match *self {
            Quadric::General(q) => quadric_bounds(q).transformed(m),
            Quadric::ParabolicCylinder { .. } => {
                let mut all = Aabb::ALL;
                all.min[1] = 0.0;
                all.transformed(m)
            }
            Quadric::HyperbolicCylinder { .. }
            | Quadric::Hyperboloid { .. }
            | Quadric::HyperbolicParaboloid { .. } => Aabb::ALL,
        }
    }

    fn hull(&self) -> Option<Vec<Vec3>> {
        None
    }

    fn ball(&self) -> Option<Ball> {
        None
    }

    fn farthest(&self, _: &Matrix, _: Vec3) -> Option<f64> {
        None
    }

    fn support(&self, _: Vec3) -> Option<Support> {
        None
    }

    fn home(&self) -> (Vec3, f64) {
        let size = match *self {
            Quadric::General(q) => {
                let largest = |of: &[usize]| of.iter().fold(0.0f64, |m, &k| m.max(q[k].abs()));
                let square = largest(&[0, 1, 2, 4, 5, 6, 8, 9, 10]).max(f64::MIN_POSITIVE);
                let linear = largest(&[3, 7, 11, 12, 13, 14]) / square;
                linear + (largest(&[15]) / square).sqrt() + 1.0
            }
            Quadric::ParabolicCylinder { a } => a.max(1.0),
            Quadric::HyperbolicCylinder { a, b } | Quadric::HyperbolicParaboloid { a, b } => {
                a.max(b)
            }
            Quadric::Hyperboloid { a, b, c, .. } => a.max(b).max(c),
        };
        ([0.0; 3], size)
    }

    fn place(&self) -> Option<Vec3> {
        match self {
            Quadric::General(_) => None,
            _ => Some([0.0; 3]),
        }
    }

    fn sizes(&self, sizes: &mut Sizes) {
        const SEMI_AXES: [&str; 3] = ["its semi-axis a", "its semi-axis b", "its semi-axis c"];
        let [a_axis, b_axis, _] = SEMI_AXES;
        match *self {
            Quadric::General(_) => {}
            Quadric::ParabolicCylinder { a } => {
                sizes.named([a, 0.0, 0.0], ["its half width a"; 3]);
            }
            Quadric::HyperbolicCylinder { a, b } => sizes.named([a, b, 0.0], [a_axis, b_axis, ""]),
            Quadric::Hyperboloid { a, b, c, .. } => sizes.named([a, b, c], SEMI_AXES),
            Quadric::HyperbolicParaboloid { a, b } => {
                sizes.named([a, 0.0, b], ["its half width a", "", "its half width b"]);
            }
        }
    }

    fn holds(&self, p: Vec3) -> bool {
        at_most_zero(self.form_at(p), || self.form_at(p))
    }

    fn taylor(&self, p: Vec3) -> Taylor {
        let unit = |a: f64| 1.0 / (a * a);
        match *self {
            Quadric::General(q) => {
                let v = [p[0], p[1], p[2], 1.0];
                let row = |i: usize| -> f64 {
                    (0..4).map(|j| (q[4 * i + j] + q[4 * j + i]) * v[j]).sum()
                };
                let squares = (0..9).map(|k| q[4 * (k / 3) + k % 3]).map(|x| x * x);
                Taylor {
                    f: (0..4).map(|i| row(i) * v[i]).sum::<f64>() / 2.0,
                    g: [0, 1, 2].map(row),
                    bend: squares.sum::<f64>().sqrt(),
                }
            }
            Quadric::ParabolicCylinder { a } => Taylor::sum(p, [unit(a), 0.0, 0.0], 0.0, -1.0),
            Quadric::HyperbolicCylinder { a, b } => {
                Taylor::sum(p, [unit(a), -unit(b), 0.0], -1.0, 0.0)
            }
            Quadric::Hyperboloid { a, b, c, sheets } => {
                let constant = if sheets == 1 { -1.0 } else { 1.0 };
                Taylor::sum(p, [unit(a), -unit(b), unit(c)], constant, 0.0)
            }
            Quadric::HyperbolicParaboloid { a, b } => {
                Taylor::sum(p, [unit(a), 0.0, -unit(b)], 0.0, -1.0)
            }
        }
    }

    fn pieces(&self) -> usize {
        0
    }

    fn faces(&self, out: &mut Faces) {
        out.quadric(&self.matrix());
    }

    fn quadric(&self, part: Part) -> Option<Form> {
        (part == Part::All).then(|| self.matrix())
    }

    fn mantle(&self, _: Part) -> Option<Mantle> {
        None
    }

    fn samples(&self) -> Vec<Sample> {
        samples(&self.matrix())
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
        let Quadric::General(q) = self else {
            return None;
        };
        let Verdict::Flat(dimensions) = judge(q) else {
            return None;
        };
        Some(Degenerate {
            case: match dimensions {
                0 => "point",
                1 => "line",
                _ => "plane",
            },
            params: (0, 16),
            equal: Vec::new(),
        })
    }

    fn crossing(&self) -> Option<Crossing> {
        None
    }

    fn offset(&self, _: f64) -> Option<Geometry> {
        None
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
