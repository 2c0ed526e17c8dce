//! 4×4 matrices that act on column vectors.

/// A 4×4 matrix, row by row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Matrix(pub [[f64; 4]; 4]);

impl Matrix {
    pub const IDENTITY: Matrix = Matrix([
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]);

    /// From 16 numbers given row by row.
    pub fn from_rows(v: &[f64; 16]) -> Matrix {
        let mut m = [[0.0; 4]; 4];
        for (i, x) in v.iter().enumerate() {
            m[i / 4][i % 4] = *x;
        }
        Matrix(m)
    }

    pub fn translation(x: f64, y: f64, z: f64) -> Matrix {
        let mut m = Matrix::IDENTITY;
        (m.0[0][3], m.0[1][3], m.0[2][3]) = (x, y, z);
        m
    }

    pub fn scaling(x: f64, y: f64, z: f64) -> Matrix {
        let mut m = Matrix::IDENTITY;
        (m.0[0][0], m.0[1][1], m.0[2][2]) = (x, y, z);
        m
    }

    /// A turn about coordinate axis 0, 1 or 2, counter-clockwise seen from the tip of the axis.
    /// Multiples of 90° are exact.
    pub fn rotation(degrees: f64, axis: usize) -> Matrix {
        let (sin, cos) = sin_cos_degrees(degrees);
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut m = Matrix::IDENTITY;
        (m.0[j][j], m.0[j][k]) = (cos, -sin);
        (m.0[k][j], m.0[k][k]) = (sin, cos);
        m
    }

    /// `self · other`: first `other`, then `self`.
    pub fn after(&self, other: &Matrix) -> Matrix {
        let mut m = [[0.0; 4]; 4];
        for (i, row) in m.iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                *x = (0..4).map(|k| self.0[i][k] * other.0[k][j]).sum();
            }
        }
        Matrix(m)
    }

    /// The image of a point under an affine matrix.
    pub fn point(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let r = &self.0[i];
            r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3]
        })
    }

    /// The image of a vector: the translation does not count.
    pub fn vector(&self, v: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let r = &self.0[i];
            r[0] * v[0] + r[1] * v[1] + r[2] * v[2]
        })
    }

    /// Whether the linear part turns and does nothing else: no entry of MᵀM is further from the
    /// identity's than this, and M does not mirror.
    pub fn is_rotation(&self, tolerance: f64) -> bool {
        let m = &self.0;
        let dot = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<f64>();
        let off = |i: usize, j: usize| (dot(i, j) - f64::from(u8::from(i == j))).abs();
        (0..9).all(|k| off(k / 3, k % 3) <= tolerance) && self.determinant3() > 0.0
    }

    /// The determinant of the upper left 3×3 block.
    pub fn determinant3(&self) -> f64 {
        let m = &self.0;
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    }

    /// By how much it scales if it does no more than turn, mirror, scale and move.
    pub fn uniform_scale(&self) -> Option<f64> {
        let dot = |i: usize, j: usize| (0..3).map(|k| self.0[k][i] * self.0[k][j]).sum::<f64>();
        let size = dot(0, 0);
        for i in 0..3 {
            for j in 0..3 {
                let meant = if i == j { size } else { 0.0 };
                // Rotations written with ten digits pass.
                if (dot(i, j) - meant).abs() > 1e-9 * size {
                    return None;
                }
            }
        }
        (size > 0.0).then(|| size.sqrt())
    }

    /// The inverse, by Gauss–Jordan elimination with full pivoting; `None` where a pivot is zero or
    /// an entry of the inverse is not finite.
    pub fn inverse(&self) -> Option<Matrix> {
        let mut a = self.0;
        let mut inv = Matrix::IDENTITY.0;
        let mut columns = [0usize, 1, 2, 3];
        for step in 0..4 {
            let (mut row, mut col, mut best) = (step, step, 0.0);
            for (i, r) in a.iter().enumerate().skip(step) {
                for (j, x) in r.iter().enumerate().skip(step) {
                    if x.abs() > best {
                        (row, col, best) = (i, j, x.abs());
                    }
                }
            }
            if best == 0.0 || !best.is_finite() {
                return None;
            }
            a.swap(step, row);
            inv.swap(step, row);
            if col != step {
                for r in &mut a {
                    r.swap(step, col);
                }
                columns.swap(step, col);
            }
            let pivot = a[step][step];
            for j in 0..4 {
                a[step][j] /= pivot;
                inv[step][j] /= pivot;
            }
            for i in (0..4).filter(|&i| i != step) {
                let f = a[i][step];
                if f != 0.0 {
                    for j in 0..4 {
                        a[i][j] -= f * a[step][j];
                        inv[i][j] -= f * inv[step][j];
                    }
                }
            }
        }
        let mut out = [[0.0; 4]; 4];
        for (i, &c) in columns.iter().enumerate() {
            out[c] = inv[i];
        }
        out.iter()
            .flatten()
            .all(|x| x.is_finite())
            .then_some(Matrix(out))
    }
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90°.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    match turn {
        0.0 => (0.0, 1.0),
        90.0 | -270.0 => (1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        270.0 | -90.0 => (-1.0, 0.0),
        _ => turn.to_radians().sin_cos(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_is_counter_clockwise_from_the_tip() {
        // About x: y goes to z; about y: z goes to x; about z: x goes to y.
        assert_eq!(
            Matrix::rotation(90.0, 0).point([0.0, 1.0, 0.0]),
            [0.0, 0.0, 1.0]
        );
        assert_eq!(
            Matrix::rotation(90.0, 1).point([0.0, 0.0, 1.0]),
            [1.0, 0.0, 0.0]
        );
        assert_eq!(
            Matrix::rotation(90.0, 2).point([1.0, 0.0, 0.0]),
            [0.0, 1.0, 0.0]
        );
    }

    #[test]
    fn inverse_undoes() {
        let m = Matrix::translation(1.0, 2.0, 3.0)
            .after(&Matrix::rotation(30.0, 1))
            .after(&Matrix::scaling(2.0, -1.0, 0.5));
        let p = m.inverse().unwrap().point(m.point([0.3, -4.0, 5.0]));
        for (a, b) in p.iter().zip([0.3, -4.0, 5.0]) {
            assert!((a - b).abs() < 1e-14);
        }
        assert!((m.determinant3() + 1.0).abs() < 1e-15);
        assert!(Matrix::scaling(1.0, 0.0, 1.0).inverse().is_none());
    }
}
