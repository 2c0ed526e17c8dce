//! The tree of a translation that the passes share, before it is text.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::geometry::Matrix;
use crate::scene::{Geometry, Optics, Rgb, Vec3, Volume};

/// A translation that is to be printed.
pub struct Document<'a> {
    /// The comment on the whole scene.
    pub title: Option<&'a str>,
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// The value of POV-Ray's `max_trace_level`.
    pub levels: u32,
    /// Power of two that dims all light enough for an image file.
    pub light_scale: f64,
    pub frame: Frame,
    pub background: Rgb,
    pub ambient: Rgb,
    pub lights: Vec<Light>,
    /// Whether the lights lie in a group with the scene: one of them is on a surface.
    pub lights_in_group: bool,
    pub tree: Tree<'a>,
    /// The scene's name in a comment.
    pub caption: String,
    /// The box outside of which nothing is drawn.
    pub clip: Option<(Vec3, Vec3)>,
    /// Whether the inside of opaque objects can be seen.
    pub cut_open: bool,
}

/// The map from the scene's coordinates to those that POV-Ray works in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The point of the scene that comes to lie in POV-Ray's origin; for most scenes the scene's own origin.
    pub centre: Vec3,
    /// Factor from the scene's lengths to POV-Ray's, a power of two.
    pub unit: f64,
}

impl Frame {
    pub fn is_moved(&self) -> bool {
        self.centre != [0.0; 3]
    }
}

/// The rays of a camera. For a point at x and y of the picture, each from 0 to 1 across and down, the offset is (x −
/// ½)·right + (½ − y)·up. The ray starts at `location`, with the direction `direction` plus the offset; a parallel ray
/// starts at `location` plus the offset, with the direction `direction`. The vectors may be left- or right-handed and
/// need not be at right angles.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Lens {
    pub caption: String,
    pub parallel: bool,
    pub location: Vec3,
    pub direction: Vec3,
    pub right: Vec3,
    pub up: Vec3,
    /// The vector by which parallel rays are moved, so that none runs exactly along a face or a seam.
    pub shift: Vec3,
}

/// A point light.
pub struct Light {
    pub caption: String,
    pub position: Vec3,
    pub colour: Rgb,
    pub intensity: f64,
}

/// A picture file.
#[derive(Clone)]
pub struct Image {
    /// The kind and path of the file in POV-Ray's language.
    pub file: String,
    /// The scene's name of the image.
    pub caption: String,
}

/// The objects that are declared, and those of them that are drawn.
#[derive(Default)]
pub struct Tree<'a> {
    pub images: Vec<Image>,
    pub textures: Vec<Texture<'a>>,
    /// The declared objects, each behind those that it is made of.
    pub objects: Vec<Declaration<'a>>,
    /// The number of the object that is drawn; `None` if there is nothing to draw.
    pub root: Option<usize>,
    pub uses: Uses,
}

/// The features that the objects use, as far as these need declarations or other measures in the file.
#[derive(Default)]
pub struct Uses {
    /// Whether some object has faces that nobody sees.
    pub unseen: bool,
    pub everywhere: bool,
    /// Whether some object has another index than 1.
    pub refraction: bool,
    /// Whether some index differs by channel.
    pub dispersion: bool,
    /// The numbers of splits of geodesic spheres.
    pub splits: BTreeSet<u32>,
}

/// A texture with its optics.
#[derive(Clone)]
pub struct Texture<'a> {
    /// The entity that the texture is named after, 0 for none, and the entity of the shape that it is laid on.
    pub owner: (u32, Option<u32>),
    pub name: String,
    pub pattern: Pattern<'a>,
    pub optics: Optics,
    /// Whether the surface is lit by light that falls on its other side.
    pub is_behind: bool,
}

/// The pattern on a surface.
#[derive(Clone)]
pub enum Pattern<'a> {
    Colour(Rgb),
    /// The points of a profile, and the colour at each of them.
    Profile(&'a [[f64; 2]], &'a [Rgb]),
    /// Cubes in two colours: the matrix that maps from the cubes' coordinates, the colours, and the length of an edge.
    Cubes(Matrix, [Rgb; 2], f64),
    /// A checkerboard along the surface coordinates of a shape: the numbers of cells along them, and the colours.
    Checkerboard(&'a Geometry, [u32; 2], [Rgb; 2]),
    /// An image by its number, along the surface coordinates of a shape.
    Image(&'a Geometry, usize),
}

/// An object with a name of its own.
pub struct Declaration<'a> {
    /// The entity that the object is named after, 0 for none.
    pub id: u32,
    pub name: String,
    pub object: Object<'a>,
}

/// An object.
#[derive(Debug, Clone, PartialEq)]
pub struct Object<'a> {
    pub body: Body<'a>,
    /// The modifiers in the order they apply: the innermost first.
    pub modifiers: Vec<Modifier<'a>>,
    pub comment: Option<String>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Body<'a> {
    Shape(Cow<'a, Geometry>),
    /// Triangles that are one object.
    Mesh(Vec<Geometry>),
    /// The declared object with this number.
    Declared(usize),
    /// All space.
    Everything,
    Operation(Operation, Vec<Object<'a>>),
}

/// POV-Ray's operations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    Union,
    Merge,
    Intersection,
    Difference,
    /// A difference whose cut faces take the texture of the part they cut.
    CutawayDifference,
}

/// A property of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Modifier<'a> {
    Matrix(Matrix),
    /// A texture by its number.
    Texture(usize),
    /// A texture, by its number, for the side of the surface that its normals do not point to.
    InnerTexture(usize),
    /// The texture of a face that nobody sees: all light goes through.
    Unseen,
    /// The texture `Unseen` for the inner side of the faces alone; the outer side keeps its own.
    UnseenWithin,
    /// The refractive index within.
    Index(Rgb),
    Inverse,
    /// A clip: only the part of the object that is inside of another one is there.
    Clip(Box<Object<'a>>),
    /// A volume that certainly holds the object.
    Bound(Volume),
}

impl<'a> Object<'a> {
    pub fn new(body: Body<'a>) -> Object<'a> {
        Object {
            body,
            modifiers: Vec::new(),
            comment: None,
        }
    }

    /// An object without anything in it.
    pub fn nothing() -> Object<'a> {
        Object::new(Body::Operation(Operation::Union, Vec::new()))
    }

    /// Makes one object of several; a single one stays as it is.
    pub fn of(operation: Operation, mut operands: Vec<Object<'a>>) -> Object<'a> {
        match (operands.len(), operands.pop()) {
            (1, Some(only)) => only,
            (_, last) => {
                operands.extend(last);
                Object::new(Body::Operation(operation, operands))
            }
        }
    }

    /// Makes one object of several; `None` if there are no operands.
    pub fn unless_empty(operation: Operation, operands: Vec<Object<'a>>) -> Option<Object<'a>> {
        (!operands.is_empty()).then(|| Object::of(operation, operands))
    }

    pub fn with(mut self, modifiers: impl IntoIterator<Item = Modifier<'a>>) -> Object<'a> {
        self.modifiers.extend(modifiers);
        self
    }

    /// Calls `f` with each object that this one is written with: operands, the object itself, and objects that clip it,
    /// in the order of the text. Declared objects are not entered. Operations nest a few levels deep at most: deeper
    /// ones are declared objects.
    pub fn each(&mut self, f: &mut dyn FnMut(&mut Object<'a>)) {
        if let Body::Operation(_, operands) = &mut self.body {
            operands.iter_mut().for_each(|operand| operand.each(f));
        }
        f(self);
        for modifier in &mut self.modifiers {
            if let Modifier::Clip(by) = modifier {
                by.each(f);
            }
        }
    }
}

impl<'a> Modifier<'a> {
    /// The modifier that keeps the part of an object inside of another one.
    pub fn inside(by: Object<'a>) -> Modifier<'a> {
        Modifier::Clip(Box::new(by))
    }

    /// The modifier that keeps the part of an object outside of another one: it clips by all of space without the other
    /// object. Clipping by an `inverse` object would fail: unless it is one of the simplest shapes it keeps its bounds,
    /// and POV-Ray takes these for the bounds of an endless object that is clipped by it.
    pub fn outside(of: Object<'a>) -> Modifier<'a> {
        let operands = vec![Object::new(Body::Everything), of];
        Modifier::inside(Object::of(Operation::Difference, operands))
    }
}
