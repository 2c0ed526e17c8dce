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
    /// Index into [`Graph::placements`]; 0 leaves the part where it is.
    pub placement: u32,
    /// Index into [`Graph::paints`]; 0 is no paint.
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
    /// The part without its IDs. It is equal for parts that cannot be told apart in a picture.
    pub fn unnamed(self) -> Part {
        Part {
            shape: 0,
            owner: 0,
            ..self
        }
    }
}

/// The paint over a part, aspect by aspect; `None` where the part keeps its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Coat {
    /// Indices into [`Graph::textures`] and [`Graph::placements`]. The placement leads from the texture's space into
    /// the space of the object that the part belongs to.
    pub texture: Option<(u32, u32)>,
    /// Index into [`Graph::optics`].
    pub optics: Option<u32>,
    /// Index into [`Graph::indices`].
    pub index: Option<u32>,
}

/// Parts in no fixed order that are searched by their places: a ray may meet any number of them.
#[derive(Debug, Default)]
pub struct Group {
    /// Indices into [`Graph::parts`] of the parts without bounds.
    pub loose: Vec<u32>,
    /// The tree of the other parts; its items are indices into [`Graph::parts`].
    pub tree: Tree,
    /// The parts of the group that hold something transparent, if no paint above changes that; `None` if there are
    /// none.
    pub clear: Option<Box<Group>>,
    /// The parts of the group that hold something opaque, if no paint above changes that; `None` if all parts do.
    pub opaque: Option<Box<Group>>,
}

impl Group {
    /// All parts, those without bounds first.
    pub fn parts(&self) -> impl Iterator<Item = u32> + '_ {
        self.loose.iter().copied().chain(self.tree.items())
    }
}

/// The sorts of media that a part or an object holds, if no paint above changes that: opaque, transparent or both.
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
        /// Whether a face made by a cut has the properties of the solid that is cut, as in a difference. Otherwise the
        /// face has those of the cut.
        inherit: bool,
    },
}

#[derive(Debug)]
pub struct Object {
    pub operation: Operation,
    /// A box that holds the object.
    pub bounds: Aabb,
    /// The units in which the object's trees keep the boxes of its parts.
    pub frame: Frame,
    pub holds: Holds,
}

#[derive(Debug, Default)]
pub struct Graph {
    pub primitives: Vec<Primitive>,
    /// The extent of each of `primitives`: see [`Shape::extent`].
    ///
    /// [`Shape::extent`]: super::shapes::Shape::extent
    pub extents: Vec<f64>,
    /// For each of `primitives`, the index into [`Scene::shapes`] of a record with the same shape.
    ///
    /// [`Scene::shapes`]: crate::scene::Scene::shapes
    pub records: Vec<u32>,
    pub objects: Vec<Object>,
    pub parts: Vec<Part>,
    pub matrices: Vec<Matrix>,
    /// For each of `matrices`, the maps out of the space below and back into it.
    pub placements: Vec<Placement>,
    pub paints: Vec<Coat>,
    pub textures: Vec<Texture>,
    /// For each of `textures`, its picture; `None` if it is no image texture.
    pub bitmaps: Vec<Option<Arc<Bitmap>>>,
    pub optics: Vec<Optics>,
    pub indices: Vec<Rgb>,
    /// Index of the object that is the scene, a union.
    pub root: u32,
    /// The limit on the memory that a ray may take to enter objects.
    pub room: MemoryLimit,
    /// The effects that are switched off, to measure their costs.
    pub without: Without,
    /// A solver that finds crossings in doubles in place of the shapes' own code, for comparisons.
    pub solver: Option<Box<dyn Solver>>,
}

impl Graph {
    /// The sorts of media that a part holds, unless a paint covers the object that it belongs to. Objects are made
    /// after their operands, so the operands' sorts are known.
    pub fn holds(&self, part: &Part) -> Holds {
        match (self.paints[part.paint as usize].optics, part.target) {
            (Some(optics), _) => self.made_of(optics),
            (None, Target::Shape(_)) => self.made_of(0),
            (None, Target::Object(o)) => self.objects[o as usize].holds,
        }
    }

    /// The sort of medium that optics make: transparent if their kt is not 0, else opaque. `optics` is an index into
    /// [`Graph::optics`].
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

/// The ID of the upper of two entities, or that of the lower one if there is no upper one; 0 stands for no entity.
pub fn outermost(above: u32, below: u32) -> u32 {
    if above == 0 { below } else { above }
}
