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
    /// The properties that objects were given.
    pub paints: Vec<Paint>,
    /// Ambient lights as they stand at the end of the file, in file order.
    pub ambient_lights: Vec<AmbientLight>,
    /// Point lights as they stand at the end of the file, in file order.
    pub point_lights: Vec<PointLight>,
    /// Cameras as they stand at the end of the file, in file order.
    pub cameras: Vec<Camera>,
    /// The cameras that take the picture.
    pub view: View,
    /// The render record. `None` if there is none, or if its reference to an object leads nowhere.
    pub render: Option<Render>,
    /// The bounding volumes, each with the node that is promised to lie inside.
    pub promises: Vec<Promise>,
    /// Every entity, in the order of definition.
    pub entities: Vec<Entity>,
    /// A number for every ID that is defined, from 0 on in the order of first definition.
    pub ids: IdTable,
    /// The step to a moved or painted node from an earlier state of its object that something else uses. Consecutive
    /// moves share one node, and so do consecutive paints, so the child of the node is an even earlier state.
    pub steps: FxHashMap<NodeId, Derivation>,
}

/// The step from an earlier state of an object to a later one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Derivation {
    /// The node of the earlier state.
    pub from: NodeId,
    /// Index into [`Scene::matrices`] of the matrix by which the step moves the earlier state. `None` for a paint.
    pub matrix: Option<u32>,
}

/// A node of the arena: an object as it is at one point of the file.
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
    /// The child with the properties in [`Scene::paints`]`[paint]`. Each of them that is set overrides what the child's
    /// parts have.
    Paint {
        /// The node that is painted.
        child: NodeId,
        /// Index into [`Scene::paints`].
        paint: u32,
    },
    /// The entity `id`, which is a copy of the child. What the copied entity owned belongs to `id` in the copy.
    Copy {
        /// The node that is copied.
        child: NodeId,
        /// The ID of the copy.
        id: u32,
    },
}

impl Node {
    /// The operands of an operation or complement, or the node that is moved, painted or copied. None for a shape.
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

    /// Whether any optics reflect or transmit light. Rays then also meet objects at which no camera looks.
    pub fn has_mirrors_or_glass(&self) -> bool {
        let mut optics = self.paints.iter().filter_map(|p| p.optics);
        optics.any(|o| o.ks != [0.0; 3] || o.kt != [0.0; 3])
    }

    /// The shapes and the places of their records, in file order. Each shape has one node, and [`shapes`](Self::shapes)
    /// is in the order of the nodes.
    pub fn written_shapes(&self) -> impl Iterator<Item = (&Shape, Span)> {
        debug_assert_eq!(self.nodes.len(), self.origins.len());
        let nodes = self.nodes.iter().zip(&self.origins);
        nodes.filter_map(|(node, origin)| match *node {
            Node::Shape(shape) => Some((&self.shapes[shape as usize], origin.span)),
            _ => None,
        })
    }

    /// Replaces every span in the scene; `to` gives the new span for an old one.
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

// A large scene has millions of these values.
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
    /// Cubes of two alternating colours, in the coordinates of the node that is painted.
    Solid {
        /// The colours that alternate.
        colours: [Rgb; 2],
        /// The edge of a cube.
        size: f64,
    },
    /// An image file in the scene's folder.
    Image {
        /// The file name as it is written.
        file: String,
        /// The place of the file name in the text.
        span: Span,
    },
}

/// The distance, in cells, by which the borders between the cells of a pattern are moved down. A face that lies in a
/// border is then wholly in the cell above, however its points are rounded. The distance is some millions of roundings.
pub const CELL_NUDGE: f64 = 1e-9;

impl Texture {
    /// The colour at a place in a pattern of two colours. `cells` are the coordinates of the place, in cells.
    pub fn cell_colour(colours: &[Rgb; 2], cells: &[f64]) -> Rgb {
        let sum: f64 = cells.iter().map(|x| (x + CELL_NUDGE).floor()).sum();
        colours[usize::from(sum.rem_euclid(2.0) >= 1.0)]
    }
}

/// The diffuse, mirrored and transmitted parts of light, each per colour channel.
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

/// The colour of everything that was given none.
pub const DEFAULT_COLOUR: Rgb = [1.0; 3];
/// The refractive index of everything that was given none, and of the space outside of all objects.
pub const DEFAULT_INDEX: Rgb = [1.0; 3];

/// Properties that an object was given. Each one that is set overrides what the object's parts have.
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
    /// The projection matrix, if the camera has one: clip coordinates = projection · view · point, with OpenGL's clip
    /// cube.
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
    /// The kind of the value. `None` where the record that defines the ID is broken and its type is unknown.
    pub kind: Option<Kind>,
    /// The node of an object; `NO_NODE` for an entity of another kind.
    node: NodeId,
    /// The ID token of the record that defines the entity.
    pub span: Span,
}

// A large scene has millions of these values.
const _: () = assert!(size_of::<Entity>() == 20);

impl Entity {
    /// The value of `node` for an entity that is no object. No scene has as many nodes.
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

    /// The node of an object at the end of the file. `None` if the entity is no object.
    pub fn node(&self) -> Option<NodeId> {
        (self.node != Entity::NO_NODE).then_some(self.node)
    }

    /// Gives the entity another node.
    pub fn set_node(&mut self, node: NodeId) {
        self.node = node;
    }
}
