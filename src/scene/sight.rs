//! The rays of a projection matrix: one for every point of the picture.
//!
//! A point X = (x, y, z, 1) of the camera's space has the clip coordinates P·X. Its place in the picture is (P₀·X /
//! P₃·X, P₁·X / P₃·X), where Pᵢ are the rows of P, and its depth is P₂·X / P₃·X. The points that are seen at (x, y) lie
//! on the line where the planes P₀ − x·P₃ and P₁ − y·P₃ meet. The direction of this line is the cross product of the
//! planes' normals. It is linear in x and y and does not depend on the near and the far plane, so a far plane at
//! infinity, or beyond, is no special case.
//!
//! Rays start on the plane of depth −1, or on the plane of depth 1 where that one is nearer to the eye (reversed
//! depth). The eye is where P₀, P₁ and P₃ vanish. A ray starts in front of the eye: where the fourth clip coordinate is
//! positive. A matrix and its negative stand for the same lines. If all rays start in front of the eye only with the
//! negative, the negative is meant.
//!
//! All decisions are computed exactly, in big numbers.

use super::model::Vec3;
use crate::geometry::Matrix;
use crate::geometry::sign::{Exact, Scalar};

/// A vector that is linear in the picture coordinates: its coefficients of 1, x and y. The coordinates go from −1 to 1,
/// x to the right and y up.
type Linear<const N: usize> = [[f64; N]; 3];

/// The rays of a projection matrix in the camera's space: x to the right, y up, z against the view
/// direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// The starts of rays: homogeneous, with a fourth coordinate that is positive all over the picture.
    start: Linear<4>,
    /// The directions of the lines, in any length.
    direction: Linear<3>,
    /// The place where all the lines meet: homogeneous; the fourth coordinate is zero where they are parallel.
    eye: [f64; 4],
}

/// The reason why a projection matrix takes no picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blind {
    /// The matrix has no inverse.
    Singular,
    /// A part of the picture has no ray: nothing in front of the eye is seen there.
    InPart,
}

impl Sight {
    /// Computes the rays of a projection matrix.
    ///
    /// # Errors
    ///
    /// A matrix that is singular, or that has no ray for some point of the picture.
    pub fn of(matrix: &Matrix) -> Result<Sight, Blind> {
        let rows = matrix.0.map(|row| row.map(Exact::of));
        let determinant = dot(&generalized_cross(&rows[0], &rows[1], &rows[2]), &rows[3]);
        if determinant == Exact::ZERO {
            return Err(Blind::Singular);
        }
        let negative = rows.clone().map(|row| row.map(|x| -x));
        let turned = determinant < Exact::ZERO;
        (Sight::in_front(&rows, turned))
            .or_else(|| Sight::in_front(&negative, turned))
            .ok_or(Blind::InPart)
    }

    /// The rays of the matrix with these rows. `None` if a ray does not start in front of the eye. `turned`: the
    /// determinant is negative.
    fn in_front(rows: &[[Exact; 4]; 4], turned: bool) -> Option<Sight> {
        let [x, y, z, w] = rows;
        let oriented = |v: [Exact; 4]| if turned { v.map(|c| -c) } else { v };
        let eye = oriented(generalized_cross(x, y, w));
        // The fourth coordinate is greater on the nearer of the planes of depth −1 and 1, by twice the fourth
        // coordinate of the eye.
        let reversed = eye[3] < Exact::ZERO;
        let plane: [Exact; 4] = std::array::from_fn(|i| match reversed {
            true => &z[i] - &w[i],
            false => &z[i] + &w[i],
        });
        let start = [
            oriented(generalized_cross(x, y, &plane)),
            oriented(generalized_cross(y, w, &plane)),
            oriented(generalized_cross(x, w, &plane)).map(|c| -c),
        ];
        let in_front = |x: f64, y: f64| {
            let [one, of_x, of_y] = [0, 1, 2].map(|i| start[i][3].clone());
            one + of_x * Exact::of(x) + of_y * Exact::of(y) > Exact::ZERO
        };
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        if !corners.iter().all(|[x, y]| in_front(*x, *y)) {
            return None;
        }
        let backwards = turned != reversed;
        let normal = |v: &[Exact; 4]| [0, 1, 2].map(|i| v[i].clone());
        let (x, y, w) = (normal(x), normal(y), normal(w));
        let directed = |v: [Exact; 3]| if backwards { v.map(|c| -c) } else { v };
        let direction = [
            directed(cross(&x, &y)),
            directed(cross(&y, &w)),
            directed(cross(&w, &x)),
        ];
        Some(Sight {
            start: rounded(&start),
            direction: rounded(&direction),
            eye: rounded(&[eye])[0],
        })
    }

    /// The start of the ray at (x, y), and its direction of any length. `None` if a number is out of range or the
    /// direction is zero.
    pub fn ray(&self, x: f64, y: f64) -> Option<(Vec3, Vec3)> {
        let [sx, sy, sz, sw] = at(&self.start, x, y);
        let (start, direction) = ([sx / sw, sy / sw, sz / sw], at(&self.direction, x, y));
        let finite = start.iter().chain(&direction).all(|c| c.is_finite());
        (finite && direction.iter().any(|c| *c != 0.0)).then_some((start, direction))
    }

    /// The direction of the ray in the middle of the picture, of any length, and the changes of the direction from the
    /// middle to the right edge and from the middle to the upper edge.
    pub fn direction(&self) -> [Vec3; 3] {
        self.direction
    }

    /// The place where all lines of sight meet. `None` if it is out of range, as for parallel lines.
    pub fn eye(&self) -> Option<Vec3> {
        let [x, y, z, w] = self.eye;
        let eye = [x / w, y / w, z / w];
        eye.iter().all(|c| c.is_finite()).then_some(eye)
    }

    /// Whether the rays are parallel and evenly spaced, up to a relative error of 10⁻¹²: the numbers of a computed
    /// matrix are rounded.
    pub fn is_parallel(&self) -> bool {
        const ROUNDED: f64 = 1e-12;
        let size = |v: [f64; 4]| v[..3].iter().fold(0.0f64, |m, c| m.max(c.abs()));
        let [middle, of_x, of_y] = self.start;
        let even = of_x[3].abs() + of_y[3].abs() <= ROUNDED * middle[3];
        even && self.eye[3].abs() * size(middle) <= ROUNDED * size(self.eye) * middle[3]
    }
}

/// The value of a linear function.
fn at<const N: usize>(f: &Linear<N>, x: f64, y: f64) -> [f64; N] {
    std::array::from_fn(|i| f[0][i] + x * f[1][i] + y * f[2][i])
}

/// The vector whose dot product with any other vector v is the determinant of the rows a, b, c, v.
fn generalized_cross(a: &[Exact; 4], b: &[Exact; 4], c: &[Exact; 4]) -> [Exact; 4] {
    std::array::from_fn(|j| {
        let kept = |v: &[Exact; 4]| -> [Exact; 3] {
            std::array::from_fn(|i| v[if i < j { i } else { i + 1 }].clone())
        };
        let minor = dot(&cross(&kept(a), &kept(b)), &kept(c));
        if j % 2 == 0 { -minor } else { minor }
    })
}

fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

fn dot<const N: usize>(a: &[Exact; N], b: &[Exact; N]) -> Exact {
    a.iter().zip(b).fold(Exact::ZERO, |sum, (a, b)| sum + a * b)
}

/// The vectors in doubles, scaled by one power of two so that the largest number is about 1.
fn rounded<const N: usize, const M: usize>(vectors: &[[Exact; N]; M]) -> [[f64; N]; M] {
    let exponent = |x: &Exact| {
        let digits = isize::try_from(x.repr().digits()).unwrap_or(0);
        (*x != Exact::ZERO).then_some(x.repr().exponent() + digits)
    };
    let largest = vectors
        .iter()
        .flatten()
        .filter_map(exponent)
        .max()
        .unwrap_or(0);
    std::array::from_fn(|m| {
        std::array::from_fn(|i| {
            let x = &vectors[m][i];
            (x.clone() >> largest).to_f64().value()
        })
    })
}
