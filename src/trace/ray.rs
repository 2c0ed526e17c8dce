//! Rays, and what is known about the surfaces that they start on.

#![warn(missing_docs)]

use super::shapes::support::Passage;
use crate::geometry::line::{Line, Traced};
use crate::geometry::vec::Vec3;

/// The surface a ray starts on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Left<R = f64> {
    /// A number for the surface, made of its shape and the way the shape is placed.
    pub surface: u64,
    /// The index of the surface's shape in the graph's primitives.
    pub primitive: u32,
    /// Whether the ray goes into the surface's solid. Entries and exits alternate. So the root that is the starting
    /// point itself is the nearest to the origin among the entries, or among the exits.
    pub entering: bool,
    /// Bound on the distance of the starting point from the true surface. Another surface that is closer to the
    /// starting point, along that surface's normal, cannot be told from it and counts as behind the ray.
    pub skin: R,
    /// The way in which the ray passes the surface that its starting face is a part of; `None` where other shapes have
    /// no faces in that surface.
    pub passage: Option<Passage>,
}

/// A ray: a line from t = 0 on.
#[derive(Debug, Clone, Copy)]
pub struct Ray<R: Traced = f64> {
    /// The line.
    pub line: Line<R>,
    /// The surface that the ray starts on, if it leaves one.
    pub left: Option<Left<R>>,
    /// Whether the ray is known to start outside of every solid.
    pub is_outside: bool,
}

impl<R: Traced> Ray<R> {
    /// A ray that leaves no surface, and may start inside of solids.
    #[inline]
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Ray<R> {
        Ray {
            line: Line::new(origin, direction),
            left: None,
            is_outside: false,
        }
    }

    /// The ray in another kind of number, rounded.
    #[inline]
    pub fn cast<S: Traced>(&self) -> Ray<S> {
        Ray {
            line: self.line.cast(),
            left: self.left.map(|left| Left {
                surface: left.surface,
                primitive: left.primitive,
                entering: left.entering,
                skin: S::of_parts(left.skin.parts()),
                passage: left.passage,
            }),
            is_outside: self.is_outside,
        }
    }
}
