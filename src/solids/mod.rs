//! What is true of solids without a ray: what people call them, which points they hold, what lies
//! within them.

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

/// How far two points are from each other.
pub fn distance(p: Vec3, q: Vec3) -> f64 {
    let [x, y, z]: Vec3 = std::array::from_fn(|i| p[i] - q[i]);
    let square = x * x + y * y + z * z;
    // `hypot` is slow, and needed only where the squares overflow, or lose digits as subnormals.
    match (1e-200..1e200).contains(&square) {
        true => square.sqrt(),
        false => x.hypot(y).hypot(z),
    }
}

/// What people call a node, and where it is written.
#[derive(Debug, Clone, Copy)]
pub struct Named {
    /// The name of its kind, a term.
    pub title: &'static str,
    /// The ID by which it is written where it occurs: its own or that of a copy.
    pub id: u32,
    pub span: Span,
}

/// The shape or operation that a node is a state of; `None` for complements.
pub fn named(scene: &Scene, mut node: NodeId) -> Option<Named> {
    let mut copy = None;
    loop {
        node = match scene.nodes[node as usize] {
            Node::Transform { child, .. } | Node::Paint { child, .. } => child,
            Node::Copy { child, id } => {
                copy = copy.or(Some(id));
                child
            }
            Node::Shape(s) => {
                let shape = &scene.shapes[s as usize];
                return Some(Named {
                    title: shape.ty().title,
                    id: copy.unwrap_or(shape.id),
                    span: scene.origins[node as usize].span,
                });
            }
            Node::Complement(_) => return None,
            operation => {
                let title = match operation {
                    Node::Union(..) => "union",
                    Node::Intersection(..) => "intersection",
                    _ => "difference",
                };
                let record = scene.origins[node as usize];
                return Some(Named {
                    title,
                    id: copy.unwrap_or(record.id),
                    span: record.span,
                });
            }
        }
    }
}
