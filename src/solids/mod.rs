//! Facts about solids that need no ray: their names, the points that they hold, the solids within them.

pub mod ancestry;
pub mod bounds;
pub mod contacts;
pub mod containment;
pub mod definite;
pub mod distance_field;
pub mod extent;
pub mod facet;
pub mod hull;
pub mod inside;
pub mod leaf;
pub mod lowest;
pub mod orbit;
pub mod outline;
pub mod points;
pub mod proofs;
pub mod shapes;
pub mod staging;
pub mod support;
pub mod tree;
pub mod within;

use crate::diagnostics::Span;
use crate::scene::{Node, NodeId, Scene, Vec3};

/// The distance between two points.
pub fn distance(p: Vec3, q: Vec3) -> f64 {
    let [x, y, z]: Vec3 = std::array::from_fn(|i| p[i] - q[i]);
    let square = x * x + y * y + z * z;
    // `hypot` is slow, and needed only where the squares overflow, or lose digits as subnormals.
    match (1e-200..1e200).contains(&square) {
        true => square.sqrt(),
        false => x.hypot(y).hypot(z),
    }
}

/// The name of a node for people, and its place in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Named {
    /// The name of the node's kind, a term of the messages.
    pub title: &'static str,
    /// The ID under which the node is written where it occurs: its own or that of a copy.
    pub id: u32,
    pub span: Span,
}

/// The name of the shape or operation that a node is a state or a copy of. `None` for complements.
pub fn named(scene: &Scene, node: NodeId) -> Option<Named> {
    named_core(scene, node)
        .filter(|(_, core)| !matches!(core, Node::Complement(_)))
        .map(|(named, _)| named)
}

/// The shape, operation or complement that a node is a state or a copy of, with its name.
pub fn named_core(scene: &Scene, node: NodeId) -> Option<(Named, Node)> {
    let mut copies = scene.states(node).filter_map(|(_, node)| match node {
        Node::Copy { id, .. } => Some(id),
        _ => None,
    });
    let (core, last) = scene.states(node).last()?;
    let record = scene.origins[core as usize];
    let (title, id) = match last {
        Node::Shape(s) => {
            let shape = &scene.shapes[s as usize];
            (shape.ty().title, shape.id)
        }
        Node::Union(..) => ("union", record.id),
        Node::Intersection(..) => ("intersection", record.id),
        Node::Difference(..) => ("difference", record.id),
        Node::Complement(_) => ("complement", record.id),
        _ => return None,
    };
    let named = Named {
        title,
        id: copies.next().unwrap_or(id),
        span: record.span,
    };
    Some((named, last))
}
