//! What a scene is made of.

use rustc_hash::FxHashMap;

use super::geometry::Geometry;
use crate::diagnostics::Span;
use crate::geometry::Matrix;
use crate::syntax::ids::IdTable;
use crate::syntax::table::{Kind, RecordKind, RecordType, ShapeKind};

pub type Vec3 = [f64; 3];
/// Linear red, green, blue.
pub type Rgb = [f64; 3];
/// Index into [`Scene::nodes`].
pub type NodeId = u32;

/// A resolved scene.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    pub nodes: Vec<Node>,
    /// The record that made each node, as long as `nodes` and in file order.
    pub origins: Vec<Origin>,
    pub shapes: Vec<Shape>,
    pub matrices: Vec<Matrix>,
    pub paints: Vec<Paint>,
    /// Ambient and point lights as they stand at the end of the file, in file order.
    pub ambient_lights: Vec<AmbientLight>,
    pub point_lights: Vec<PointLight>,
    /// Cameras as they stand at the end of the file, in file order.
    pub cameras: Vec<Camera>,
    /// The cameras that take the picture.
    pub view: View,
    pub render: Option<Render>,
    pub promises: Vec<Promise>,
    /// Every entity, in the order of definition.
    pub entities: Vec<Entity>,
    /// A number for every ID that is defined, from 0 on in the order of first definition.
    pub ids: IdTable,
    /// The earlier state of each transformation or paint that goes on from one which others need as it is.
    pub steps: FxHashMap<NodeId, Derivation>,
}

/// How an object in the arena came of an earlier state of the same one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Derivation {
    pub from: NodeId,
    /// The matrix that a transformation applies after the earlier one; index into [`Scene::matrices`].
    pub matrix: Option<u32>,
}

/// An object in the arena.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Node {
    /// Index into [`Scene::shapes`].
    Shape(u32),
    Union(NodeId, NodeId),
    Intersection(NodeId, NodeId),
    Difference(NodeId, NodeId),
    Complement(NodeId),
    /// The child moved by [`Scene::matrices`]`[matrix]`, which is affine and invertible.
    Transform {
        child: NodeId,
        matrix: u32,
    },
    /// The child with [`Scene::paints`]`[paint]` over what its parts have of those aspects.
    Paint {
        child: NodeId,
        paint: u32,
    },
    /// The entity `id` is a copy of the child: what the copied entity itself owned is now `id`'s.
    Copy {
        child: NodeId,
        id: u32,
    },
}

impl Node {
    /// The nodes that the node is made of; two for an operation with two operands.
    pub fn children(self) -> impl DoubleEndedIterator<Item = NodeId> + Clone {
        let [first, second] = match self {
            Node::Shape(_) => [None; 2],
            Node::Union(a, b) | Node::Intersection(a, b) | Node::Difference(a, b) => {
                [Some(a), Some(b)]
            }
            Node::Complement(child)
            | Node::Transform { child, .. }
            | Node::Paint { child, .. }
            | Node::Copy { child, .. } => [Some(child), None],
        };
        first.into_iter().chain(second)
    }
}

impl Scene {
    /// The cameras that take the picture: none, one, or left and right.
    pub fn chosen_cameras(&self) -> impl Iterator<Item = &Camera> {
        self.view.cameras().filter_map(|i| self.cameras.get(i))
    }

    /// The shapes and where they are written, in file order: each has one node, and [`shapes`](Self::shapes) has the
    /// order of the nodes.
    pub fn written_shapes(&self) -> impl Iterator<Item = (&Shape, Span)> {
        debug_assert_eq!(self.nodes.len(), self.origins.len());
        let nodes = self.nodes.iter().zip(&self.origins);
        nodes.filter_map(|(node, origin)| match *node {
            Node::Shape(shape) => Some((&self.shapes[shape as usize], origin.span)),
            _ => None,
        })
    }

    /// Has all that was made by records lie elsewhere.
    pub fn move_spans(&mut self, to: impl Fn(Span) -> Span) {
        self.origins.iter_mut().for_each(|o| o.span = to(o.span));
        self.promises.iter_mut().for_each(|p| p.span = to(p.span));
        self.entities.iter_mut().for_each(|e| e.span = to(e.span));
        self.render.iter_mut().for_each(|r| r.span = to(r.span));
        for paint in &mut self.paints {
            if let Some(Texture::Image { span, .. }) = &mut paint.texture {
                *span = to(*span);
            }
        }
    }
}

/// The record that made a node: every node is made by one record, and a record makes at most one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Origin {
    /// The entity that the record defines or changes.
    pub id: u32,
    pub span: Span,
}

/// One shape record. The origin of its node says where it is written.
#[derive(Debug, Clone)]
pub struct Shape {
    pub id: u32,
    pub kind: ShapeKind,
    pub geometry: Geometry,
}

// A large scene has millions of them.
const _: () = assert!(size_of::<Shape>() <= 64);

impl Shape {
    pub fn ty(&self) -> &'static RecordType {
        RecordType::of(RecordKind::Shape(self.kind))
    }
}

/// The look of a surface before light falls on it.
#[derive(Debug, Clone, PartialEq)]
pub enum Texture {
    Colour(Rgb),
    /// n cells along u, m along v.
    Checkerboard {
        n: u32,
        m: u32,
        colours: [Rgb; 2],
    },
    /// Cubes of this edge, in the coordinates of the node that is painted.
    Solid {
        colours: [Rgb; 2],
        size: f64,
    },
    /// A file name beside the scene, and where it is written.
    Image {
        file: String,
        span: Span,
    },
}

/// By which part of a cell the borders between cells are moved down: faces that lie in one are in the cell
/// above, whatever their points are rounded to. Some millions of roundings.
pub const CELL_NUDGE: f64 = 1e-9;

impl Texture {
    /// The colour of a pattern's two at a place, given in cells along each coordinate.
    pub fn cell_colour(colours: &[Rgb; 2], cells: &[f64]) -> Rgb {
        let sum: f64 = cells.iter().map(|x| (x + CELL_NUDGE).floor()).sum();
        colours[usize::from(sum.rem_euclid(2.0) >= 1.0)]
    }
}

/// Diffuse, mirrored and transmitted parts, each per channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Optics {
    pub kd: Rgb,
    pub ks: Rgb,
    pub kt: Rgb,
}

impl Default for Optics {
    /// Fully diffuse.
    fn default() -> Optics {
        Optics {
            kd: [1.0; 3],
            ks: [0.0; 3],
            kt: [0.0; 3],
        }
    }
}

/// The colour of everything that nobody gave one.
pub const DEFAULT_COLOUR: Rgb = [1.0; 3];
/// The refractive index of everything that nobody gave one, and of the space outside.
pub const DEFAULT_INDEX: Rgb = [1.0; 3];

/// Properties given to an object: each aspect that is set overrides what the parts have of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Paint {
    /// The entity that was given these properties.
    pub owner: u32,
    pub texture: Option<Texture>,
    pub optics: Option<Optics>,
    /// Refractive index per channel.
    pub index: Option<Rgb>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmbientLight {
    pub id: u32,
    pub intensity: f64,
    pub colour: Rgb,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLight {
    pub id: u32,
    pub position: Vec3,
    pub intensity: f64,
    pub colour: Rgb,
}

/// A camera after its transformations. Direction and up are as written: of any length, not
/// orthogonal, but never parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    pub id: u32,
    pub position: Vec3,
    pub direction: Vec3,
    pub up: Vec3,
    /// Vertical field of view in degrees; meaningless with a projection matrix.
    pub fovy: f64,
    /// clip = projection · view · x, OpenGL's clip cube.
    pub projection: Option<Matrix>,
}

/// The cameras of a picture; indices into [`Scene::cameras`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum View {
    /// There is no camera: the scene is framed automatically.
    #[default]
    Automatic,
    Mono(usize),
    Stereo {
        left: usize,
        right: usize,
    },
}

impl View {
    /// The numbers of the cameras that take the picture: none, one, or left and right.
    pub fn cameras(self) -> impl Iterator<Item = usize> + Clone {
        let chosen = match self {
            View::Automatic => [None, None],
            View::Mono(camera) => [Some(camera), None],
            View::Stereo { left, right } => [Some(left), Some(right)],
        };
        chosen.into_iter().flatten()
    }
}

/// The render record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Render {
    pub root: NodeId,
    /// The ID the record names.
    pub root_id: u32,
    pub background: Rgb,
    /// The region that is drawn: lower and upper corner.
    pub clip: Option<(Vec3, Vec3)>,
    pub span: Span,
}

/// A bounding volume record: the promise that `node` lies inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Promise {
    pub id: u32,
    pub node: NodeId,
    pub volume: Volume,
    pub span: Span,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Volume {
    Box { min: Vec3, max: Vec3 },
    Sphere { centre: Vec3, radius: f64 },
}

/// The value of an ID at the end of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entity {
    pub id: u32,
    /// `None` where the record that defines it is broken beyond telling.
    pub kind: Option<Kind>,
    /// See [`Entity::node`].
    node: NodeId,
    /// The ID token of the record that defines it.
    pub span: Span,
}

// A large scene has millions of them.
const _: () = assert!(size_of::<Entity>() == 20);

impl Entity {
    /// Stands for an entity that is no object: no scene has as many nodes.
    const NO_NODE: NodeId = NodeId::MAX;

    /// An entity without a node yet.
    pub fn new(id: u32, kind: Option<Kind>, span: Span) -> Entity {
        let node = Entity::NO_NODE;
        Entity {
            id,
            kind,
            node,
            span,
        }
    }

    /// The node of an object, as it stands at the end of the file.
    pub fn node(&self) -> Option<NodeId> {
        (self.node != Entity::NO_NODE).then_some(self.node)
    }

    pub fn set_node(&mut self, node: NodeId) {
        self.node = node;
    }
}
