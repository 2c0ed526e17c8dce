//! The facts that every shape states about itself.

use crate::geometry::{Aabb, Matrix};
use crate::scene::Vec3;
use crate::solids::contacts::face::Faces;

/// The questions that every shape answers, in its own coordinates. No method has a default: whoever adds a shape gives
/// an answer to each question. A question that few shapes answer is a match over [`AnyShape`](super::AnyShape) in the
/// place where it is asked.
pub trait Facts {
    fn character(&self) -> Character;

    /// Whether the shape is a solid that holds every point between two of its points.
    fn is_convex(&self) -> bool;

    /// A box around the shape after an affine matrix has moved it. The box is never too small.
    fn bounds(&self, m: &Matrix) -> Aabb;

    /// The point of the shape that is furthest in a direction; for a geodesic sphere the corner that is nearest to the
    /// direction. `None` for planes, half-spaces and quadrics.
    fn support(&self, d: Vec3) -> Option<Support>;

    /// Whether a point of finite coordinates is in the solid or on its boundary, decided exactly on the numbers
    /// of the record; surfaces hold nothing.
    fn holds(&self, p: Vec3) -> bool;

    /// The shape's function near a point: it is below zero inside. Surfaces are not asked.
    fn taylor(&self, p: Vec3) -> Taylor;

    /// Adds the faces that can lie in a face of another shape.
    fn faces(&self, out: &mut Faces);
}

/// The traits of a shape that do not depend on a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Character {
    /// Whether the shape is a solid of revolution about the y axis, or would be one if it were moved and scaled, as
    /// spheres and ellipsoids would.
    pub is_round: bool,
    /// Whether the shape is a flat surface without shading normals.
    pub is_flat: bool,
    /// Whether the shape is a quadric, general or named. Spheres, ellipsoids and cones do not count.
    pub is_quadric: bool,
    /// Whether the shape has shading normals of its own.
    pub is_smooth: bool,
    /// Whether the shape has colours of its own.
    pub has_colours: bool,
    /// Whether parts of the surface can coincide, where they then cancel each other out.
    pub may_cover_itself: bool,
}

impl Character {
    /// The character of a shape without any of these traits.
    pub const PLAIN: Character = Character {
        is_round: false,
        is_flat: false,
        is_quadric: false,
        is_smooth: false,
        has_colours: false,
        may_cover_itself: false,
    };
}

/// An ellipsoid whose axes are along the coordinate axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    pub centre: Vec3,
    pub semi_axes: Vec3,
    /// Factor by which the ellipsoid shrinks to one that the shape surely holds; 1 where the shape is the ellipsoid.
    pub held: f64,
}

/// A point of a shape's surface.
#[derive(Debug, Clone, Copy)]
pub struct Support {
    pub point: Vec3,
    /// A vector from the point into the shape, of any length; `None` for surfaces.
    pub inwards: Option<Vec3>,
}

impl Support {
    pub fn towards(point: Vec3, middle: Vec3) -> Support {
        Support {
            point,
            inwards: Some(std::array::from_fn(|i| middle[i] - point[i])),
        }
    }

    pub fn sheet(point: Vec3) -> Support {
        Support {
            point,
            inwards: None,
        }
    }
}

/// A function that is below zero inside of a shape: its value at a point, its gradient, and a bound of
/// the second-order term.
#[derive(Debug, Clone, Copy)]
pub struct Taylor {
    pub f: f64,
    pub g: Vec3,
    pub bend: f64,
}

impl Taylor {
    /// A function that is linear around the point, with the value `f` and the gradient `g`.
    pub fn flat(f: f64, g: Vec3) -> Taylor {
        Taylor { f, g, bend: 0.0 }
    }

    /// The function of an intersection: the larger of the two.
    pub fn both(self, other: Taylor) -> Taylor {
        if self.f > other.f { self } else { other }
    }

    /// The function of a surface, which has no inside.
    pub fn nowhere() -> Taylor {
        Taylor::flat(f64::MAX, [1.0, 0.0, 0.0])
    }

    /// A function of the distance from the y axis and of the height, given by its value `f` and its slopes along both.
    pub fn turned([x, _, z]: Vec3, f: f64, out: f64, up: f64) -> Taylor {
        let around = x.hypot(z);
        let (cos, sin) = match around > 0.0 {
            true => (x / around, z / around),
            false => (1.0, 0.0),
        };
        Taylor::flat(f, [out * cos, up, out * sin])
    }

    /// A sum of squares with factors, a part that is linear in y, and a constant.
    pub fn sum([x, y, z]: Vec3, s: [f64; 3], constant: f64, linear: f64) -> Taylor {
        Taylor {
            f: s[0] * x * x + s[1] * y * y + s[2] * z * z + linear * y + constant,
            g: [2.0 * s[0] * x, 2.0 * s[1] * y + linear, 2.0 * s[2] * z],
            bend: s.iter().fold(0.0f64, |m, s| m.max(s.abs())),
        }
    }
}
