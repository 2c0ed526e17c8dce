//! What every shape says of itself.

use super::lengthen::Cut;
use super::sizes::Sizes;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Vec3};
use crate::solids::contacts::directions::Sample;
use crate::solids::contacts::face::{Faces, Part};
use crate::solids::contacts::quadric::Form;

/// What is true of a shape without a ray, in its own coordinates. No method has a default: whoever adds a
/// shape gives an answer to each question, and nobody else has to ask which shape it is.
pub trait Facts {
    fn character(&self) -> Character;

    /// Whether it is a solid that holds every point between two of its points.
    fn is_convex(&self) -> bool;

    // Where it is.

    /// A box around it, moved by an affine matrix, that is never too small.
    fn bounds(&self, m: &Matrix) -> Aabb;

    /// Points between which all of it lies: the corners of shapes that have some, polygons around circles.
    /// `None` where balls and boxes serve as well.
    fn hull(&self) -> Option<Vec<Vec3>>;

    /// The ellipsoid that it is or has for its hull; `None` for all that is not round like that.
    fn ball(&self) -> Option<Ball>;

    /// A distance from a point that nothing of the moved shape exceeds by more than rounding, where that is
    /// known more closely than by a box.
    fn farthest(&self, m: &Matrix, p: Vec3) -> Option<f64>;

    /// Its point that is furthest in a direction; of a geodesic sphere the corner that lies next to it.
    /// `None` for shapes without end.
    fn support(&self, d: Vec3) -> Option<Support>;

    /// Where something without end is at home, and of what size its features are there. Nobody asks shapes
    /// that end.
    fn home(&self) -> (Vec3, f64);

    /// Some point of it, where its record names one.
    fn place(&self) -> Option<Vec3>;

    /// Its lengths, moved, by the names that people have for them.
    fn sizes(&self, sizes: &mut Sizes);

    // Which points it holds.

    /// Whether a point of finite coordinates is in the solid or on its boundary, decided exactly on the numbers
    /// of the record; surfaces hold nothing.
    fn holds(&self, p: Vec3) -> bool;

    /// A function that is below zero inside, near a point. Nobody asks surfaces.
    fn taylor(&self, p: Vec3) -> Taylor;

    /// How many pieces a test of a point goes through, of shapes that have any number of them; else none.
    fn pieces(&self) -> usize;

    // Its faces.

    /// Adds those that can lie in a face of another shape.
    fn faces(&self, out: &mut Faces);

    /// The symmetric matrix of the quadric that a round face lies in.
    fn quadric(&self, part: Part) -> Option<Form>;

    /// A round face about the y axis as a piece of a profile.
    fn mantle(&self, part: Part) -> Option<Mantle>;

    /// Points of its surface with normals, where it is one round face that is no mantle.
    fn samples(&self) -> Vec<Sample>;

    /// a, b, c, d of the plane that it is or that bounds it, and nothing else.
    fn plane(&self) -> Option<[f64; 4]>;

    /// Its outermost flat faces, each with a box around it where a matrix leads.
    fn flat_faces(&self, m: &Matrix) -> Vec<FlatFace>;

    /// Where it has flat faces across an axis that [`lengthened`](Self::lengthened) can move.
    fn ends(&self, axis: usize) -> Vec<f64>;

    // What is wrong with it.

    /// How it fails to have an inside, or of a surface an area.
    fn degenerate(&self) -> Option<Degenerate>;

    /// Where its surface runs through itself.
    fn crossing(&self) -> Option<Crossing>;

    // What it can be changed into.

    /// The shape whose surface lies so far outside of its own, or inside if the number is negative, and
    /// nowhere on the other side of it. `None` where none of the language's shapes is that, or nothing would
    /// be left.
    fn offset(&self, by: f64) -> Option<Geometry>;

    /// The shape with its flush faces farther out, if it has any that can be moved.
    fn lengthened(&self, longer: &Cut) -> Option<Geometry>;

    // Its record.

    /// Where a face is written, and what it is called.
    fn written(&self, part: Part) -> Written;

    /// The record with a face farther out: by a part of the shape's own length, or where it has none by
    /// `room`. `None` where the face is not one that a parameter moves.
    fn moved_out(&self, part: Part, share: f64, room: f64) -> Option<Vec<Moved>>;
}

/// What a shape is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Character {
    /// Whether it is a solid of revolution about the y axis.
    pub is_round: bool,
    /// Whether it is a flat surface, and the same all over.
    pub is_flat: bool,
    /// Whether it is one quadric, whatever its numbers.
    pub is_quadric: bool,
    /// Whether it has shading normals of its own.
    pub is_smooth: bool,
    /// Whether it has colours of its own.
    pub has_colours: bool,
    /// Whether parts of its surface can lie in each other, where there is then nothing.
    pub may_cover_itself: bool,
}

/// An ellipsoid whose axes are along the coordinate axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    pub centre: Vec3,
    pub semi_axes: Vec3,
    /// Which part of it a shape holds that is a little less.
    pub held: f64,
}

/// A point of a shape's surface.
#[derive(Debug, Clone, Copy)]
pub struct Support {
    pub point: Vec3,
    /// A way from there into the shape, of any length; `None` for surfaces.
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
    /// Of the first order.
    pub fn flat(f: f64, g: Vec3) -> Taylor {
        Taylor { f, g, bend: 0.0 }
    }

    /// The larger of two is that of what both hold.
    pub fn both(self, other: Taylor) -> Taylor {
        if self.f > other.f { self } else { other }
    }

    /// Of a surface, which has no inside.
    pub fn nowhere() -> Taylor {
        Taylor::flat(f64::MAX, [1.0, 0.0, 0.0])
    }

    /// Of a function of the distance from the y axis and the height, from its two slopes.
    pub fn turned([x, _, z]: Vec3, f: f64, out: f64, up: f64) -> Taylor {
        let around = x.hypot(z);
        let (cos, sin) = match around > 0.0 {
            true => (x / around, z / around),
            false => (1.0, 0.0),
        };
        Taylor::flat(f, [out * cos, up, out * sin])
    }

    /// Of a sum of squares with factors, a part that is linear in y, and a constant.
    pub fn sum([x, y, z]: Vec3, s: [f64; 3], constant: f64, linear: f64) -> Taylor {
        Taylor {
            f: s[0] * x * x + s[1] * y * y + s[2] * z * z + linear * y + constant,
            g: [2.0 * s[0] * x, 2.0 * s[1] * y + linear, 2.0 * s[2] * z],
            bend: s.iter().fold(0.0f64, |m, s| m.max(s.abs())),
        }
    }
}

/// (radius, height) of the two ends of a piece of a cone or cylinder about the y axis.
pub type Mantle = ((f64, f64), (f64, f64));

/// A flat face: n·x + d = 0 with n outwards, and a box around it.
#[derive(Debug, Clone, Copy)]
pub struct FlatFace {
    pub n: Vec3,
    pub d: f64,
    pub around: Aabb,
}

/// How a shape is degenerate, as its message says it.
#[derive(Debug, Clone, PartialEq)]
pub struct Degenerate {
    pub case: &'static str,
    /// The first of the parameters that make it so, and their number.
    pub params: (usize, usize),
    /// Parameters that are equal to the one half a record further on, where that is why.
    pub equal: Vec<usize>,
}

/// Where a surface runs through itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Crossing {
    /// A tube, around the axis of its ring.
    Tube,
    /// Two pieces of a profile, at (x, y). Piece i runs from point i to the next; the piece after the last
    /// runs from the axis to the first point, the one after that from the last point to the axis.
    Pieces {
        pieces: (usize, usize),
        at: [f64; 2],
    },
}

/// Where a face is written in a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Written {
    /// The first parameter and how many; `None` for the whole record.
    pub params: Option<(usize, usize)>,
    /// What it is, as messages say it.
    pub what: &'static str,
    /// Whether the name of the parameter names it, too.
    pub is_named: bool,
}

impl Written {
    pub fn at(first: usize, count: usize, what: &'static str) -> Written {
        Written {
            params: Some((first, count)),
            what,
            is_named: false,
        }
    }

    pub const ALL: Written = Written {
        params: None,
        what: "all",
        is_named: false,
    };
}

/// A parameter, its new value, and by how much that differs.
pub type Moved = (usize, f64, f64);
