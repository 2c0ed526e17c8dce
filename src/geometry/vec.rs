//! Vectors of three numbers, and the constants of rounding.

#![warn(missing_docs)]

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
#[derive(Debug, Clone, Copy, Default)]
pub struct Vec3<R = f64>(pub [R; 3]);

/// The implementation that would be derived, inlined.
impl<R: PartialEq> PartialEq for Vec3<R> {
    #[inline]
    fn eq(&self, other: &Vec3<R>) -> bool {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        a == x && b == y && c == z
    }
}

impl<R: Real> Vec3<R> {
    /// The vector (0, 0, 0).
    pub const ZERO: Vec3<R> = Vec3([R::ZERO; 3]);
    /// The vector (1, 1, 1).
    pub const ONE: Vec3<R> = Vec3([R::ONE; 3]);

    /// The vector with these components.
    #[inline]
    pub const fn new(x: R, y: R, z: R) -> Vec3<R> {
        Vec3([x, y, z])
    }

    /// Applies a function to every component.
    #[inline]
    pub fn map(self, f: impl Fn(R) -> R) -> Vec3<R> {
        let [x, y, z] = self.0;
        Vec3([f(x), f(y), f(z)])
    }

    /// Applies a function to the components of two vectors, pair by pair.
    #[inline]
    pub fn zip(self, other: Vec3<R>, f: impl Fn(R, R) -> R) -> Vec3<R> {
        Vec3([
            f(self.0[0], other.0[0]),
            f(self.0[1], other.0[1]),
            f(self.0[2], other.0[2]),
        ])
    }

    /// The dot product.
    #[inline]
    pub fn dot(self, other: Vec3<R>) -> R {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    /// The cross product.
    #[inline]
    pub fn cross(self, other: Vec3<R>) -> Vec3<R> {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vec3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The product, component by component.
    #[inline]
    pub fn times(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a * b)
    }

    /// The absolute values of the components.
    #[inline]
    pub fn abs(self) -> Vec3<R> {
        self.map(R::abs)
    }

    /// The largest component.
    #[inline]
    pub fn max_component(self) -> R {
        self.0[0].max(self.0[1]).max(self.0[2])
    }

    /// The Euclidean length.
    #[inline]
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
    #[inline]
    pub fn unit(self) -> Vec3<R> {
        let scale = self.abs().max_component();
        if scale == R::ZERO || !scale.is_finite() {
            return Vec3::ZERO;
        }
        let v = self / scale;
        v / v.dot(v).sqrt()
    }

    /// Whether all components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }

    /// Whether some component differs from zero.
    #[inline]
    pub fn any(self) -> bool {
        self.0.iter().any(|&x| x != R::ZERO)
    }

    /// The vector in another kind of number, each component rounded.
    #[inline]
    pub fn cast<S: Real>(self) -> Vec3<S> {
        let part = |x: R| S::of_parts(x.parts());
        let [x, y, z] = self.0;
        Vec3([part(x), part(y), part(z)])
    }
}

impl<R> From<[R; 3]> for Vec3<R> {
    #[inline]
    fn from(v: [R; 3]) -> Vec3<R> {
        Vec3(v)
    }
}

impl<R> From<Vec3<R>> for [R; 3] {
    #[inline]
    fn from(v: Vec3<R>) -> [R; 3] {
        v.0
    }
}

impl<R> Index<usize> for Vec3<R> {
    type Output = R;
    #[inline]
    fn index(&self, i: usize) -> &R {
        &self.0[i]
    }
}

impl<R> IndexMut<usize> for Vec3<R> {
    #[inline]
    fn index_mut(&mut self, i: usize) -> &mut R {
        &mut self.0[i]
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Vec3<R>;
    #[inline]
    fn add(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a + b)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Vec3<R>;
    #[inline]
    fn sub(self, other: Vec3<R>) -> Vec3<R> {
        self.zip(other, |a, b| a - b)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Vec3<R>;
    #[inline]
    fn neg(self) -> Vec3<R> {
        self.map(|a| -a)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Vec3<R>;
    #[inline]
    fn mul(self, s: R) -> Vec3<R> {
        self.map(|a| a * s)
    }
}

impl<R: Real> Div<R> for Vec3<R> {
    type Output = Vec3<R>;
    #[inline]
    fn div(self, s: R) -> Vec3<R> {
        self.map(|a| a / s)
    }
}
