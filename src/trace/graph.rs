//! The scene as the tracer walks it: a graph of operations whose shared parts stay shared.
//!
//! Complements have been driven down to the shapes, chains of one operation flattened, and each
//! chain of transformations and properties above a part folded into one placement and one paint.

use super::affine::Placement;
use super::bounds::Bounds;
use super::bvh::Bvh;
use super::image::Bitmap;
use super::shapes::Primitive;
use crate::scene::{Matrix, Optics, Rgb, Texture};
use std::ops::Range;
use std::sync::Arc;

/// What a part is an occurrence of.
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
    /// The complement of a shape; never set for an object.
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

/// What is painted over a part, per aspect; `None` leaves the part's own.
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
    /// The others; its items are indices into [`Graph::parts`].
    pub bvh: Bvh,
}

/// An operation. Parts with smaller indices are earlier operands.
#[derive(Debug)]
pub enum Operation {
    Union(Group),
    /// What is in all of `first` and in none of `cuts`.
    Intersection {
        first: Range<u32>,
        cuts: Group,
        /// Faces made by the cuts look like what is cut, not like what cuts: a difference.
        inherit: bool,
    },
}

#[derive(Debug)]
pub struct Object {
    pub operation: Operation,
    /// Holds the object.
    pub bounds: Bounds,
}

#[derive(Debug, Default)]
pub struct Graph {
    pub primitives: Vec<Primitive>,
    pub objects: Vec<Object>,
    pub parts: Vec<Part>,
    pub matrices: Vec<Matrix>,
    /// Beside `matrices`.
    pub placements: Vec<Placement>,
    pub paints: Vec<Coat>,
    pub textures: Vec<Texture>,
    /// Beside `textures`: the pictures of image textures.
    pub bitmaps: Vec<Option<Arc<Bitmap>>>,
    pub optics: Vec<Optics>,
    pub indices: Vec<Rgb>,
    /// Index of the object that is the scene, a union.
    pub root: u32,
}

impl Graph {
    pub fn root(&self) -> &Object {
        &self.objects[self.root as usize]
    }

    /// The one part of a scene that is a single convex shape: nothing could ever be in its own way.
    pub fn lone_convex(&self) -> bool {
        let Operation::Union(group) = &self.root().operation else {
            return false;
        };
        let mut parts = group.loose.iter().chain(&group.bvh.items);
        match (parts.next(), parts.next()) {
            (Some(&only), None) => {
                let part = self.parts[only as usize];
                match part.target {
                    Target::Shape(p) => {
                        !part.inverted && self.primitives[p as usize].shape().is_convex()
                    }
                    Target::Object(_) => false,
                }
            }
            _ => false,
        }
    }
}
