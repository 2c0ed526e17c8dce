//! Boxes around moved shapes.

use crate::geometry::array::length;
use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;

/// The box around moved ellipsoids, circles and tori, and so around their convex hull.
pub(super) struct Around<'a> {
    matrix: &'a Matrix,
    out: Aabb,
}

impl<'a> Around<'a> {
    pub(super) fn new(matrix: &'a Matrix) -> Around<'a> {
        Around {
            matrix,
            out: Aabb::EMPTY,
        }
    }

    pub(super) fn boxed(self) -> Aabb {
        self.out
    }

    /// Adds an ellipsoid with axes along the coordinate axes. Its image reaches |row · diag(axes)| from the image of
    /// its centre.
    pub(super) fn ellipsoid(self, centre: Vec3, axes: Vec3) -> Self {
        self.add(centre, |r| {
            length([r[0] * axes[0], r[1] * axes[1], r[2] * axes[2]])
        })
    }

    /// Adds a circle about the y axis.
    pub(super) fn ring(self, y: f64, radius: f64) -> Self {
        self.add([0.0, y, 0.0], |r| libm::hypot(r[0] * radius, r[2] * radius))
    }

    /// Adds a torus: the Minkowski sum of a circle about the y axis and a ball.
    pub(super) fn torus(self, major: f64, minor: f64) -> Self {
        self.add([0.0; 3], |r| {
            major * libm::hypot(r[0], r[2]) + minor * length([r[0], r[1], r[2]])
        })
    }

    fn add(mut self, centre: Vec3, reach: impl Fn(&[f64; 4]) -> f64) -> Self {
        let c = self.matrix.point(centre);
        let rows = &self.matrix.0;
        let reach: Vec3 = std::array::from_fn(|i| reach(&rows[i]).abs());
        let magnitude: Vec3 = std::array::from_fn(|i| {
            let r = &rows[i];
            (0..3).map(|j| (r[j] * centre[j]).abs()).sum::<f64>() + r[3].abs() + reach[i]
        });
        let around = Aabb::new(
            std::array::from_fn(|i| c[i] - reach[i]),
            std::array::from_fn(|i| c[i] + reach[i]),
        );
        self.out = self.out.hull(&around.padded_by(magnitude));
        self
    }
}

/// The largest residual of A·A⁻¹ at which the inverse is trusted, and by how much the ellipsoid's
/// half-widths are then grown: their relative error is of the order of the residual.
const TRUSTED_RESIDUAL: f64 = 1e-10;

/// A box around a quadric. xᵀAx + 2bᵀx + c ≤ 0 with a positive definite A is an ellipsoid about −A⁻¹b whose half-width
/// along axis i is √(k·(A⁻¹)ᵢᵢ), k = bᵀA⁻¹b − c. Every other quadric may be unbounded.
pub(super) fn quadric_bounds(q: &[f64; 16]) -> Aabb {
    let s = |i: usize, j: usize| q[4 * i + j] / 2.0 + q[4 * j + i] / 2.0;
    let mut a = Matrix::IDENTITY;
    for i in 0..3 {
        for j in 0..3 {
            a.0[i][j] = s(i, j);
        }
    }
    let minor = s(0, 0) * s(1, 1) - s(0, 1) * s(0, 1);
    if !(s(0, 0) > 0.0 && minor > 0.0 && a.determinant3() > 0.0) {
        return Aabb::ALL;
    }
    let Some(inverse) = a.inverse() else {
        return Aabb::ALL;
    };
    let product = a.after(&inverse);
    let residual = (0..9)
        .map(|k| (product.0[k / 3][k % 3] - Matrix::IDENTITY.0[k / 3][k % 3]).abs())
        .fold(0.0, f64::max);
    let b = [s(0, 3), s(1, 3), s(2, 3)];
    let centre = inverse.vector(b).map(|x| -x);
    let terms: Vec3 = std::array::from_fn(|i| -b[i] * centre[i]);
    let k = terms.iter().sum::<f64>() - s(3, 3);
    let magnitude = terms.iter().map(|t| t.abs()).sum::<f64>() + s(3, 3).abs();
    let k = k + TRUSTED_RESIDUAL * magnitude;
    let trusted = residual < TRUSTED_RESIDUAL;
    if !trusted || !k.is_finite() || (0..3).any(|i| inverse.0[i][i] <= 0.0) {
        return Aabb::ALL;
    }
    if k < 0.0 {
        return Aabb::EMPTY;
    }
    let reach: Vec3 = std::array::from_fn(|i| {
        (k * inverse.0[i][i]).sqrt() * (1.0 + TRUSTED_RESIDUAL) + TRUSTED_RESIDUAL * centre[i].abs()
    });
    Aabb::new(
        std::array::from_fn(|i| centre[i] - reach[i]),
        std::array::from_fn(|i| centre[i] + reach[i]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Vec3, b: Vec3) -> bool {
        (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6)
    }

    #[test]
    fn an_ellipsoid_among_the_quadrics() {
        // (x − 1)² + 4y² + z² − 4 ≤ 0.
        let q = [
            1.0, 0.0, 0.0, -1.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, -3.0,
        ];
        let b = quadric_bounds(&q);
        assert!(near(b.min, [-1.0, -1.0, -2.0]) && near(b.max, [3.0, 1.0, 2.0]));
        assert_eq!(quadric_bounds(&q.map(|x| -x)), Aabb::ALL);
    }
}
