//! What rules about geometry share: the scene with every shape in its place, and tests of points.

pub mod boxes;
pub mod facet;
pub mod field;
pub mod hull;
pub mod inside;
pub mod leaf;
pub mod meeting;
pub mod points;
pub mod proofs;
pub mod reach;
pub mod tips;
pub mod tree;
pub mod ways;

use crate::diagnostics::Span;
use crate::scene::{Node, NodeId, OperationRecord, Scene, Vec3};

/// What is drawn; without a render record all objects that are part of no other.
pub fn roots(scene: &Scene, live: &[bool]) -> Vec<NodeId> {
    if let Some(render) = &scene.render {
        return vec![render.root];
    }
    let mut part = vec![false; scene.nodes.len()];
    for (node, _) in scene.nodes.iter().zip(live).filter(|n| *n.1) {
        for child in node.children().into_iter().flatten() {
            part[child as usize] = true;
        }
    }
    let tops = (0..scene.nodes.len()).filter(|&i| live[i] && !part[i]);
    tops.map(|i| i as NodeId).collect()
}

/// A coordinate of a place on something of a size: to a thousandth of that, so that the place named
/// is still there.
pub fn near(x: f64, size: f64) -> String {
    let digits = if size.is_finite() && size > 0.0 {
        3 - size.log10().floor() as i32
    } else {
        3
    };
    if !(0..=12).contains(&digits) {
        let rounded = format!("{x:.9e}").parse().unwrap_or(x);
        return format!("{rounded}");
    }
    let text = format!("{x:.precision$}", precision = digits as usize);
    let text = match text.split_once('.') {
        Some(_) => text.trim_end_matches('0').trim_end_matches('.'),
        None => &text,
    };
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

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
                    title: shape.ty.title,
                    id: copy.unwrap_or(shape.id),
                    span: shape.span,
                });
            }
            Node::Complement(_) => return None,
            operation => {
                let title = match operation {
                    Node::Union(..) => "union",
                    Node::Intersection(..) => "intersection",
                    _ => "difference",
                };
                let record = operation_of(scene, node)?;
                return Some(Named {
                    title,
                    id: copy.unwrap_or(record.id),
                    span: record.span,
                });
            }
        }
    }
}

/// The record that made the node of an operation.
pub fn operation_of(scene: &Scene, node: NodeId) -> Option<&OperationRecord> {
    let at = (scene.operations).binary_search_by_key(&node, |o| o.node);
    scene.operations.get(at.ok()?)
}
