//! Plain numbers and vectors of them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point number as a textbook uses it.
pub trait Number:
    Copy
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// What crossings nearer than this are taken for: the surface the ray has just left.
    const OFFSET: Self;
    /// What coefficients smaller than this are taken for: zero.
    const TINY: Self;

    fn of(x: f64) -> Self;
    fn wide(self) -> f64;
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    fn cbrt(self) -> Self;
    fn cos(self) -> Self;
    fn acos(self) -> Self;
    fn floor(self) -> Self;
}

macro_rules! number {
    ($t:ident, $offset:literal, $tiny:literal) => {
        impl Number for $t {
            const OFFSET: $t = $offset;
            const TINY: $t = $tiny;

            fn of(x: f64) -> $t {
                x as $t
            }
            fn wide(self) -> f64 {
                self.into()
            }
            fn abs(self) -> $t {
                $t::abs(self)
            }
            fn sqrt(self) -> $t {
                $t::sqrt(self)
            }
            fn cbrt(self) -> $t {
                $t::cbrt(self)
            }
            fn cos(self) -> $t {
                $t::cos(self)
            }
            fn acos(self) -> $t {
                $t::acos(self)
            }
            fn floor(self) -> $t {
                $t::floor(self)
            }
        }
    };
}

number!(f32, 1e-4, 1e-6);
number!(f64, 1e-6, 1e-9);

pub type V<T> = [T; 3];

pub fn vector<T: Number>(v: [f64; 3]) -> V<T> {
    v.map(T::of)
}

pub fn add<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale<T: Number>(a: V<T>, s: T) -> V<T> {
    a.map(|x| x * s)
}

pub fn dot<T: Number>(a: V<T>, b: V<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross<T: Number>(a: V<T>, b: V<T>) -> V<T> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn unit<T: Number>(a: V<T>) -> V<T> {
    scale(a, T::of(1.0) / dot(a, a).sqrt())
}

/// A half-line; also the whole line, where crossings behind the origin count too.
#[derive(Clone, Copy)]
pub struct Ray<T> {
    pub origin: V<T>,
    pub direction: V<T>,
}

impl<T: Number> Ray<T> {
    pub fn at(&self, t: T) -> V<T> {
        add(self.origin, scale(self.direction, t))
    }
}
