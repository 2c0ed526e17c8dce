//! The scene as the tracer walks it: a graph of operations whose shared parts stay shared.
//!
//! Complements have been driven down to the shapes, chains of one operation flattened, and each
//! chain of transformations and properties above a part folded into one placement and one paint.

use super::bitmap::Bitmap;
use super::memory_limit::MemoryLimit;
use super::shapes::Primitive;
use super::switches::{Solver, Without};
use crate::geometry::Matrix;
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::Placement;
use crate::geometry::wide_bvh::{Frame, Tree};
use crate::scene::{Optics, Rgb, Texture};
use std::ops::Range;
use std::sync::Arc;

/// The shape or object that a part is an occurrence of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Target {
    /// Index into [`Graph::primitives`].
    Shape(u32),
    /// Index into [`Graph::objects`].
    Object(u32),
}

/// An operand of an operation: a shape or an object, placed and painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Part {
    pub target: Target,
    /// Index into [`Graph::placements`]; 0 stays where it is.
    pub placement: u32,
    /// Index into [`Graph::paints`]; 0 paints nothing.
    pub paint: u32,
    /// Whether the part is the complement of a shape; never set for an object.
    pub inverted: bool,
    /// ID of the entity whose record made the shape; 0 for an object.
    pub shape: u32,
    /// ID of the outermost entity above the part, within the object it belongs to, that was given
    /// properties; 0 where there is none.
    pub owner: u32,
}

impl Part {
    /// The part without its IDs: equal for parts that cannot be told apart in a picture.
    pub fn unnamed(self) -> Part {
        Part {
            shape: 0,
            owner: 0,
            ..self
        }
    }
}

/// The paint over a part, per aspect; `None` leaves the part's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Coat {
    /// Index into [`Graph::textures`], and the placement of the painted coordinates in the object
    /// the part belongs to.
    pub texture: Option<(u32, u32)>,
    /// Index into [`Graph::optics`].
    pub optics: Option<u32>,
    /// Index into [`Graph::indices`].
    pub index: Option<u32>,
}

/// Parts of which any number may be on a ray's way.
#[derive(Debug, Default)]
pub struct Group {
    /// Indices into [`Graph::parts`] of those without bounds.
    pub loose: Vec<u32>,
    /// The tree of the other parts; its items are indices into [`Graph::parts`].
    pub tree: Tree,
    /// The parts among them that hold something transparent, if no paint above says otherwise; `None` where there are
    /// none.
    pub clear: Option<Box<Group>>,
    /// The parts among them that hold something opaque, likewise; `None` where all of them do.
    pub opaque: Option<Box<Group>>,
}

impl Group {
    /// All parts, those without bounds first.
    pub fn parts(&self) -> impl Iterator<Item = u32> + '_ {
        self.loose.iter().copied().chain(self.tree.items())
    }
}

/// The sorts of media that the surfaces of a thing may be made of, as far as it is not painted over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Holds {
    pub opaque: bool,
    pub clear: bool,
}

impl Holds {
    pub fn and(self, other: Holds) -> Holds {
        Holds {
            opaque: self.opaque || other.opaque,
            clear: self.clear || other.clear,
        }
    }
}

/// An operation. Parts with smaller indices are earlier operands.
#[derive(Debug)]
pub enum Operation {
    Union(Group),
    /// The points in all parts of `first` and in no part of `cuts`.
    Intersection {
        first: Range<u32>,
        cuts: Group,
        /// Whether faces made by the cuts look like what is cut, not like what cuts: a difference.
        inherit: bool,
    },
}

#[derive(Debug)]
pub struct Object {
    pub operation: Operation,
    /// Holds the object.
    pub bounds: Aabb,
    /// The units of the boxes of the object's parts.
    pub frame: Frame,
    pub holds: Holds,
}

#[derive(Debug, Default)]
pub struct Graph {
    pub primitives: Vec<Primitive>,
    /// Extents of the shapes, beside `primitives`: see [`Shape::extent`].
    ///
    /// [`Shape::extent`]: super::shapes::Shape::extent
    pub extents: Vec<f64>,
    /// Indices into [`Scene::shapes`] of a record that says the same, beside `primitives`.
    ///
    /// [`Scene::shapes`]: crate::scene::Scene::shapes
    pub records: Vec<u32>,
    pub objects: Vec<Object>,
    pub parts: Vec<Part>,
    pub matrices: Vec<Matrix>,
    /// Placements, beside `matrices`.
    pub placements: Vec<Placement>,
    pub paints: Vec<Coat>,
    pub textures: Vec<Texture>,
    /// The pictures of image textures, beside `textures`.
    pub bitmaps: Vec<Option<Arc<Bitmap>>>,
    pub optics: Vec<Optics>,
    pub indices: Vec<Rgb>,
    /// Index of the object that is the scene, a union.
    pub root: u32,
    /// How many objects a ray may enter.
    pub room: MemoryLimit,
    /// The effects that are taken out, for those who measure what they cost.
    pub without: Without,
    /// A solver that finds crossings in doubles instead of the shapes themselves, for those who compare.
    pub solver: Option<Box<dyn Solver>>,
}

impl Graph {
    /// The sorts of media that a part holds, unless something is painted over the object it belongs to. Objects come
    /// after those that they are made of.
    pub fn holds(&self, part: &Part) -> Holds {
        match (self.paints[part.paint as usize].optics, part.target) {
            (Some(optics), _) => self.made_of(optics),
            (None, Target::Shape(_)) => self.made_of(0),
            (None, Target::Object(o)) => self.objects[o as usize].holds,
        }
    }

    /// The sort of medium that a thing with these optics holds.
    pub fn made_of(&self, optics: u32) -> Holds {
        let clear = self.optics[optics as usize].kt != [0.0; 3];
        Holds {
            opaque: !clear,
            clear,
        }
    }

    pub fn root(&self) -> &Object {
        &self.objects[self.root as usize]
    }
}

/// The upper one of two IDs, one above the other, if there is one; 0 is none.
pub fn outermost(above: u32, below: u32) -> u32 {
    if above == 0 { below } else { above }
}
