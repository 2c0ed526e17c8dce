//! Vectors of three numbers, and the constants of rounding.

use super::number::Real;
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
pub struct Vec3<R = f64>(pub [R; 3]);

impl<R: Real> Vec3<R> {
    pub const ZERO: Vec3<R> = Vec3([R::ZERO; 3]);
    pub const ONE: Vec3<R> = Vec3([R::ONE; 3]);

    pub const fn new(x: R, y: R, z: R) -> Vec3<R> {
        Vec3([x, y, z])
    }

    /// The same function of every component.
    pub fn map(self, f: impl Fn(R) -> R) -> Vec3<R> {
        Vec3(self.0.map(f))
    }

    /// A function of the components of two vectors.
    pub fn zip(self, other: Vec3<R>, f: impl Fn(R, R) -> R) -> Vec3<R> {
        Vec3([
            f(self.0[0], other.0[0]),
            f(self.0[1], other.0[1]),
            f(self.0[2], other.0[2]),
        ])
    }

    pub fn dot(self, other: Vec3<R>) -> R {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    pub fn cross(self, other: Vec3<R>) -> Vec3<R> {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vec3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The product, component by component.
    pub fn times(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a * b)
    }

    pub fn abs(self) -> Vec3<R> {
        self.map(R::abs)
    }

    pub fn max_component(self) -> R {
        self.0[0].max(self.0[1]).max(self.0[2])
    }

    pub fn length(self) -> R {
        let scale = self.abs().max_component();
        if scale == R::ZERO || !scale.is_finite() {
            return scale;
        }
        // Scaled, so that neither large nor small components overflow in their squares.
        let v = self / scale;
        scale * v.dot(v).sqrt()
    }

    /// The vector of length 1 in this direction; zero stays zero.
    pub fn unit(self) -> Vec3<R> {
        let scale = self.abs().max_component();
        if scale == R::ZERO || !scale.is_finite() {
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
        self.0.iter().any(|&x| x != R::ZERO)
    }

    /// In another kind of number, each component rounded.
    pub fn cast<S: Real>(self) -> Vec3<S> {
        Vec3(self.0.map(|x| S::of_parts(x.parts())))
    }
}

impl<R> From<[R; 3]> for Vec3<R> {
    fn from(v: [R; 3]) -> Vec3<R> {
        Vec3(v)
    }
}

impl<R> From<Vec3<R>> for [R; 3] {
    fn from(v: Vec3<R>) -> [R; 3] {
        v.0
    }
}

impl<R> Index<usize> for Vec3<R> {
    type Output = R;
    fn index(&self, i: usize) -> &R {
        &self.0[i]
    }
}

impl<R> IndexMut<usize> for Vec3<R> {
    fn index_mut(&mut self, i: usize) -> &mut R {
        &mut self.0[i]
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Vec3<R>;
    fn add(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a + b)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Vec3<R>;
    fn sub(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a - b)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Vec3<R>;
    fn neg(self) -> Vec3<R> {
        self.map(|a| -a)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Vec3<R>;
    fn mul(self, s: R) -> Vec3<R> {
        self.map(|a| a * s)
    }
}

impl<R: Real> Div<R> for Vec3<R> {
    type Output = Vec3<R>;
    fn div(self, s: R) -> Vec3<R> {
        self.map(|a| a / s)
    }
}
