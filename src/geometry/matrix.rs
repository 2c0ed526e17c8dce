//! 4×4 matrices that act on column vectors.

use std::f64::consts::FRAC_1_SQRT_2;

use dashu_int::IBig;

use super::array::each;
use super::exact;

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

    /// The matrix of 16 numbers given row by row.
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
        each([0, 1, 2], |i| {
            let r = &self.0[i];
            r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3]
        })
    }

    /// The image of a vector: the translation does not count.
    pub fn vector(&self, v: [f64; 3]) -> [f64; 3] {
        each([0, 1, 2], |i| {
            let r = &self.0[i];
            r[0] * v[0] + r[1] * v[1] + r[2] * v[2]
        })
    }

    /// Whether the linear part is a rotation: no entry of MᵀM differs from the identity's by more than `tolerance`, and
    /// M does not mirror.
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

    /// The sign of the determinant of the upper left 3×3 block, exactly: 1, -1 or 0.
    pub fn orientation(&self) -> i32 {
        let m = &self.0;
        let row = |i: usize| [m[i][0], m[i][1], m[i][2]];
        let sizes = Matrix(m.map(|r| r.map(f64::abs)));
        // Rounding changes the result by no more than a few roundings of the products' sizes, unless these underflow.
        let (x, bound) = (
            self.determinant3(),
            16.0 * f64::EPSILON * sizes.permanent3(),
        );
        match x.abs() > bound && bound > 1e-280 && bound.is_finite() {
            true => {
                if x > 0.0 {
                    1
                } else {
                    -1
                }
            }
            false => exact::sign(&exact::determinant([row(0), row(1), row(2)])),
        }
    }

    /// The permanent of the upper left 3×3 block: the determinant with all products added.
    fn permanent3(&self) -> f64 {
        let m = &self.0;
        m[0][0] * (m[1][1] * m[2][2] + m[1][2] * m[2][1])
            + m[0][1] * (m[1][0] * m[2][2] + m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] + m[1][1] * m[2][0])
    }

    /// Whether the matrix does no more than move.
    pub fn is_translation(&self) -> bool {
        let [x, y, z, last] = &self.0;
        let unit = [x, y, z].into_iter().zip(&Matrix::IDENTITY.0);
        *last == Matrix::IDENTITY.0[3] && unit.into_iter().all(|(row, unit)| row[..3] == unit[..3])
    }

    /// Whether the matrix has no inverse, decided exactly.
    pub fn is_singular(&self) -> bool {
        match self.0[3] == [0.0, 0.0, 0.0, 1.0] {
            true => self.orientation() == 0,
            false => exact::determinant(self.0) == IBig::ZERO,
        }
    }

    /// Whether an affine matrix is so far from singular, as nearly all are, that nothing more needs to be computed: it
    /// is regular, and [`Matrix::inverse`] finds no pivot that is zero.
    ///
    /// With complete pivoting the pivots are those of a matrix whose entries differ by less than 8n³ρu · 10³ < 10⁻⁹
    /// (n = 4, growth ρ ≤ 5, u = 2⁻⁵³; N. J. Higham, Accuracy and Stability of Numerical Algorithms, 9.3). Its
    /// cofactors are below 4 · 10⁵, so its determinant differs by less than 0.01 from one of at least 1/8.
    pub fn is_plainly_invertible(&self) -> bool {
        let [x, y, z, last] = &self.0;
        let within =
            |row: &[f64; 4]| row[..3].iter().all(|x| x.abs() <= 8.0) && row[3].abs() <= 1e3;
        *last == [0.0, 0.0, 0.0, 1.0]
            && [x, y, z].into_iter().all(within)
            && self.determinant3().abs() >= 0.125
    }

    /// The scale factor of a matrix that does no more than turn, mirror, scale and move; `None` for others.
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
///
/// Whole turns, and then quarter turns, are taken off without rounding, so that angles that are the
/// same, such as 80° and −280°, have the same sines to the bit, and those of an angle and its negative
/// differ in their signs alone.
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    let mut quarters = (turn / 90.0).round();
    let mut rest = turn - 90.0 * quarters;
    // 45° is taken for 90° − 45°, whether it comes as 45° or as −315°.
    if rest >= 45.0 {
        (quarters, rest) = (quarters + 1.0, rest - 90.0);
    } else if rest < -45.0 {
        (quarters, rest) = (quarters - 1.0, rest + 90.0);
    }
    let (sin, cos) = match rest {
        -45.0 => (-FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        _ => libm::sincos(rest.to_radians()),
    };
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        /// Entries of few bits, so that singular and nearly singular matrices are among them.
        #[test]
        fn what_is_plainly_invertible_is_so(
            linear in proptest::array::uniform9(-8i8..=8),
            fine in proptest::array::uniform9(-3i8..=3),
            moved in proptest::array::uniform3(-1e3..1e3),
        ) {
            let entry = |i: usize| f64::from(linear[i]) / 4.0 + f64::from(fine[i]) * 1e-9;
            let mut m = Matrix::IDENTITY;
            for (i, by) in moved.into_iter().enumerate() {
                m.0[i] = [entry(3 * i), entry(3 * i + 1), entry(3 * i + 2), by];
            }
            if m.is_plainly_invertible() {
                proptest::prop_assert!(!m.is_singular() && m.inverse().is_some());
            }
        }
    }

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
    fn the_same_angle_is_the_same_matrix() {
        let bits = |degrees: f64, axis| {
            Matrix::rotation(degrees, axis)
                .0
                .map(|r| r.map(f64::to_bits))
        };
        let mut seed = 7u64;
        let mut angles: Vec<f64> = (-720..=720).map(f64::from).collect();
        angles.extend((0..2000).map(|_| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            // Multiples of 2⁻³² that are the same after whole turns, exactly.
            (seed >> 32) as f64 / (1u64 << 23) as f64 - 256.0
        }));
        angles.extend([
            45.0,
            -45.0,
            135.0,
            45.0f64.next_down(),
            45.0 + 64.0 * f64::EPSILON,
        ]);
        for angle in angles {
            for turns in [-720.0, -360.0, 360.0, 1080.0] {
                let other = angle + turns;
                if other - turns == angle && other - angle == turns {
                    for axis in 0..3 {
                        assert_eq!(bits(angle, axis), bits(other, axis), "{angle} {other}");
                    }
                }
            }
            let there = Matrix::rotation(angle, 0).0;
            let back = Matrix::rotation(-angle, 0).0;
            for (i, j) in [(1, 1), (1, 2), (2, 1), (2, 2)] {
                assert_eq!(there[i][j], back[j][i], "{angle}");
            }
            // Against the platform's functions, within their rounding and that of the radians.
            let (sin, cos) = (angle % 360.0).to_radians().sin_cos();
            assert!((there[2][1] - sin).abs() < 4e-15 && (there[1][1] - cos).abs() < 4e-15);
        }
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert_eq!(
            Matrix::rotation(-315.0, 2).point([1.0, 0.0, 0.0]),
            [half, half, 0.0]
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
