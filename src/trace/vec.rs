//! Vectors of three numbers, and the constants of rounding.

use std::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

/// The unit roundoff u: a correctly rounded operation returns x(1 + e) with |e| ≤ u.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// γₙ = nu / (1 − nu), the bound on the relative error of n rounded operations in a row
/// (Higham, Accuracy and Stability of Numerical Algorithms, lemma 3.1; pbrt-v4, section 6.8).
pub const fn gamma(n: u32) -> f64 {
    let nu = n as f64 * UNIT_ROUNDOFF;
    nu / (1.0 - nu)
}

/// A point, a vector or a colour.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vec3(pub [f64; 3]);

impl Vec3 {
    pub const ZERO: Vec3 = Vec3([0.0; 3]);
    pub const ONE: Vec3 = Vec3([1.0; 3]);

    pub const fn new(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3([x, y, z])
    }

    /// The same function of every component.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Vec3 {
        Vec3(self.0.map(f))
    }

    /// A function of the components of two vectors.
    pub fn zip(self, other: Vec3, f: impl Fn(f64, f64) -> f64) -> Vec3 {
        Vec3([
            f(self.0[0], other.0[0]),
            f(self.0[1], other.0[1]),
            f(self.0[2], other.0[2]),
        ])
    }

    pub fn dot(self, other: Vec3) -> f64 {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    pub fn cross(self, other: Vec3) -> Vec3 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vec3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The product, component by component.
    pub fn times(self, other: Vec3) -> Vec3 {
        self.zip(other, |a, b| a * b)
    }

    pub fn abs(self) -> Vec3 {
        self.map(f64::abs)
    }

    pub fn max_component(self) -> f64 {
        self.0[0].max(self.0[1]).max(self.0[2])
    }

    pub fn length(self) -> f64 {
        let scale = self.abs().max_component();
        if scale == 0.0 || !scale.is_finite() {
            return scale;
        }
        // Scaled, so that neither large nor small components overflow in their squares.
        let v = self / scale;
        scale * v.dot(v).sqrt()
    }

    /// The vector of length 1 in this direction; zero stays zero.
    pub fn unit(self) -> Vec3 {
        let scale = self.abs().max_component();
        if scale == 0.0 || !scale.is_finite() {
            return Vec3::ZERO;
        }
        let v = self / scale;
        v / v.dot(v).sqrt()
    }

    pub fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }

    /// Whether some component differs from zero.
    pub fn any(self) -> bool {
        self.0.iter().any(|&x| x != 0.0)
    }
}

impl From<[f64; 3]> for Vec3 {
    fn from(v: [f64; 3]) -> Vec3 {
        Vec3(v)
    }
}

impl Index<usize> for Vec3 {
    type Output = f64;
    fn index(&self, i: usize) -> &f64 {
        &self.0[i]
    }
}

impl IndexMut<usize> for Vec3 {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.0[i]
    }
}

impl Add for Vec3 {
    type Output = Vec3;
    fn add(self, other: Vec3) -> Vec3 {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Vec3 {
    type Output = Vec3;
    fn sub(self, other: Vec3) -> Vec3 {
        self.zip(other, |a, b| a - b)
    }
}

impl Neg for Vec3 {
    type Output = Vec3;
    fn neg(self) -> Vec3 {
        self.map(|a| -a)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Vec3;
    fn mul(self, s: f64) -> Vec3 {
        self.map(|a| a * s)
    }
}

impl Div<f64> for Vec3 {
    type Output = Vec3;
    fn div(self, s: f64) -> Vec3 {
        self.map(|a| a / s)
    }
}
