//! The lengths of a shape.

use crate::geometry::Matrix;

/// How much two axes must differ in stretch for a length to be told with its axis: lengths are told
/// in four digits, and what is the same in all of them needs no axis.
const UNEVEN: f64 = 1.001;

/// A length of a shape and what it is.
#[derive(Debug, Clone, Copy)]
pub struct Length {
    pub size: f64,
    pub what: &'static str,
    /// The axis of the shape along which it lies, where the others come out differently.
    pub axis: Option<usize>,
}

/// Takes a shape's lengths, moved by a matrix.
pub struct Sizes<'a> {
    pub matrix: &'a Matrix,
    /// How much longer the matrix makes what lies along an axis.
    pub stretch: [f64; 3],
    is_uneven: bool,
    take: &'a mut dyn FnMut(Length),
}

pub const RADIUS: &str = "its radius";

impl<'a> Sizes<'a> {
    pub fn new(matrix: &'a Matrix, take: &'a mut dyn FnMut(Length)) -> Sizes<'a> {
        let m = &matrix.0;
        let stretch: [f64; 3] = std::array::from_fn(|j| m[0][j].hypot(m[1][j]).hypot(m[2][j]));
        let (least, most) = stretch
            .iter()
            .fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        Sizes {
            matrix,
            stretch,
            is_uneven: most > UNEVEN * least,
            take,
        }
    }

    /// A length where it is, in all directions.
    pub fn add(&mut self, size: f64, what: &'static str) {
        let axis = None;
        (self.take)(Length { size, what, axis });
    }

    /// One that lies along an axis, not stretched yet.
    pub fn along(&mut self, axis: usize, size: f64, what: &'static str) {
        (self.take)(Length {
            size: size * self.stretch[axis],
            what,
            axis: self.is_uneven.then_some(axis),
        });
    }

    /// One along each axis.
    pub fn axes(&mut self, sizes: [f64; 3], what: [&'static str; 3]) {
        (0..3).for_each(|i| self.along(i, sizes[i], what[i]));
    }

    /// One along each axis, which is a part of its name.
    pub fn named(&mut self, sizes: [f64; 3], what: [&'static str; 3]) {
        (0..3).for_each(|i| self.add(sizes[i] * self.stretch[i], what[i]));
    }
}
