//! The model of a scene: nodes, shapes, textures, lights, cameras.

#![warn(missing_docs)]

use rustc_hash::FxHashMap;

use super::geometry::Geometry;
use crate::diagnostics::Span;
use crate::geometry::Matrix;
use crate::syntax::ids::IdTable;
use crate::syntax::table::{Kind, RecordKind, RecordType, ShapeKind};

/// Three numbers: a point, a direction or factors.
pub type Vec3 = [f64; 3];
/// Linear red, green, blue.
pub type Rgb = [f64; 3];
/// Index into [`Scene::nodes`].
pub type NodeId = u32;

/// A resolved scene.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// The arena of nodes: children stand before their parents.
    pub nodes: Vec<Node>,
    /// The record that made each node, as long as `nodes` and in file order.
    pub origins: Vec<Origin>,
    /// The shapes of the nodes.
    pub shapes: Vec<Shape>,
    /// The matrices of transformations.
    pub matrices: Vec<Matrix>,
    /// The properties that are painted on.
    pub paints: Vec<Paint>,
    /// Ambient and point lights as they stand at the end of the file, in file order.
    pub ambient_lights: Vec<AmbientLight>,
    /// Point lights, likewise.
    pub point_lights: Vec<PointLight>,
    /// Cameras as they stand at the end of the file, in file order.
    pub cameras: Vec<Camera>,
    /// The cameras that take the picture.
    pub view: View,
    /// The render record, if there is one that can be followed.
    pub render: Option<Render>,
    /// The bounding volumes.
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
    /// The node of the earlier state.
    pub from: NodeId,
    /// The matrix that a transformation applies after the earlier one; index into [`Scene::matrices`].
    pub matrix: Option<u32>,
}

/// An object in the arena.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Node {
    /// Index into [`Scene::shapes`].
    Shape(u32),
    /// The points in either operand.
    Union(NodeId, NodeId),
    /// The points in both operands.
    Intersection(NodeId, NodeId),
    /// The points in the first operand and not in the second.
    Difference(NodeId, NodeId),
    /// The points outside of the operand.
    Complement(NodeId),
    /// The child moved by [`Scene::matrices`]`[matrix]`, which is affine and invertible.
    Transform {
        /// The node that is moved.
        child: NodeId,
        /// Index into [`Scene::matrices`].
        matrix: u32,
    },
    /// The child with [`Scene::paints`]`[paint]` over what its parts have of those aspects.
    Paint {
        /// The node that is painted.
        child: NodeId,
        /// Index into [`Scene::paints`].
        paint: u32,
    },
    /// The entity `id` is a copy of the child: what the copied entity itself owned is now `id`'s.
    Copy {
        /// The node that is copied.
        child: NodeId,
        /// The ID of the copy.
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

    /// Whether any optics mirror or let light through: then things are seen that no camera looks at.
    pub fn has_mirrors_or_glass(&self) -> bool {
        let mut optics = self.paints.iter().filter_map(|p| p.optics);
        optics.any(|o| o.ks != [0.0; 3] || o.kt != [0.0; 3])
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
    /// The record's place in the text.
    pub span: Span,
}

/// A shape record. The origin of its node says where it is written.
#[derive(Debug, Clone)]
pub struct Shape {
    /// The ID of the record.
    pub id: u32,
    /// The kind of the record.
    pub kind: ShapeKind,
    /// The numbers of the record.
    pub geometry: Geometry,
}

// A large scene has millions of them.
const _: () = assert!(size_of::<Shape>() <= 64);

impl Shape {
    /// The entry of the record's type in the table.
    pub fn ty(&self) -> &'static RecordType {
        RecordType::of(RecordKind::Shape(self.kind))
    }
}

/// The look of a surface before light falls on it.
#[derive(Debug, Clone, PartialEq)]
pub enum Texture {
    /// A single colour.
    Colour(Rgb),
    /// n cells along u, m along v.
    Checkerboard {
        /// Cells along u.
        n: u32,
        /// Cells along v.
        m: u32,
        /// The colours that alternate.
        colours: [Rgb; 2],
    },
    /// Cubes of this edge, in the coordinates of the node that is painted.
    Solid {
        /// The colours that alternate.
        colours: [Rgb; 2],
        /// The edge of a cube.
        size: f64,
    },
    /// A file name beside the scene, and where it is written.
    Image {
        /// The file name as it is written.
        file: String,
        /// The place of the texture in the text.
        span: Span,
    },
}

/// Part of a cell by which the borders between cells are moved down: faces that lie in one are in the cell above,
/// whatever their points are rounded to. Some millions of roundings.
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
    /// The diffuse part.
    pub kd: Rgb,
    /// The mirrored part.
    pub ks: Rgb,
    /// The transmitted part.
    pub kt: Rgb,
}

impl Default for Optics {
    /// The optics of a fully diffuse surface.
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
    /// The texture, if it is set.
    pub texture: Option<Texture>,
    /// The optics, if they are set.
    pub optics: Option<Optics>,
    /// Refractive index per channel.
    pub index: Option<Rgb>,
}

/// Light from everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmbientLight {
    /// The ID of the record.
    pub id: u32,
    /// Factor of the colour.
    pub intensity: f64,
    /// Linear RGB.
    pub colour: Rgb,
}

/// A lamp: light from a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLight {
    /// The ID of the record.
    pub id: u32,
    /// The place of the lamp.
    pub position: Vec3,
    /// Factor of the colour.
    pub intensity: f64,
    /// Linear RGB.
    pub colour: Rgb,
}

/// A camera after its transformations. Direction and up are as written: of any length, not
/// orthogonal, but never parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The ID of the record.
    pub id: u32,
    /// The eye.
    pub position: Vec3,
    /// The direction of view.
    pub direction: Vec3,
    /// The direction that is up in the picture.
    pub up: Vec3,
    /// Vertical field of view in degrees; meaningless with a projection matrix.
    pub fovy: f64,
    /// clip = projection · view · x, OpenGL's clip cube.
    pub projection: Option<Matrix>,
}

/// The cameras of a picture; indices into [`Scene::cameras`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum View {
    /// A scene without a camera, which is framed automatically.
    #[default]
    Automatic,
    /// A single camera.
    Mono(usize),
    /// Two cameras, whose pictures stand side by side.
    Stereo {
        /// The left eye.
        left: usize,
        /// The right eye.
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
    /// The node that is drawn.
    pub root: NodeId,
    /// The ID the record names.
    pub root_id: u32,
    /// The colour where nothing is seen.
    pub background: Rgb,
    /// The region that is drawn: lower and upper corner.
    pub clip: Option<(Vec3, Vec3)>,
    /// The record's place in the text.
    pub span: Span,
}

/// A bounding volume record: the promise that `node` lies inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Promise {
    /// The ID of the record.
    pub id: u32,
    /// The node that lies inside.
    pub node: NodeId,
    /// The volume around the node.
    pub volume: Volume,
    /// The record's place in the text.
    pub span: Span,
}

/// A bounding volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Volume {
    /// A box along the axes.
    Box {
        /// The lower corner.
        min: Vec3,
        /// The upper corner.
        max: Vec3,
    },
    /// A ball.
    Sphere {
        /// The centre.
        centre: Vec3,
        /// The radius.
        radius: f64,
    },
}

/// The value of an ID at the end of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entity {
    /// The ID.
    pub id: u32,
    /// `None` where the record that defines it is broken beyond telling.
    pub kind: Option<Kind>,
    /// See [`Entity::node`].
    node: NodeId,
    /// The ID token of the record that defines the entity.
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

    /// Gives the entity another node.
    pub fn set_node(&mut self, node: NodeId) {
        self.node = node;
    }
}
