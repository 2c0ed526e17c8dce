//! The quadrics: the general one, and those with a name.

use super::around::quadric_bounds;
use super::facts::*;
use crate::geometry::sign::{Scalar, at_most_zero};
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;
use crate::solids::contacts::quadric::QuadricMatrix;
use crate::solids::definite::is_ellipsoid;

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
    /// The quadric's polynomial, multiplied by its denominators so that there are no divisions.
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

    /// The symmetric matrix Q with which the quadric is xᵀQx ≤ 0.
    pub fn matrix(&self) -> QuadricMatrix {
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
            is_quadric: true,
            ..Character::PLAIN
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

    fn support(&self, _: Vec3) -> Option<Support> {
        None
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

    fn faces(&self, out: &mut Faces) {
        out.quadric(&self.matrix());
    }
}
