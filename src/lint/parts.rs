//! Whether objects have surfaces and solids in them.

use crate::scene::{Node, NodeId, Scene, fold_up};

/// The sorts of parts that an object is made of.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Parts {
    /// The node of a surface that is part of the object.
    pub surface: Option<NodeId>,
    /// Whether a solid is part of the object.
    pub solid: bool,
}

/// The parts of each node. The result of an intersection, a difference or a complement counts as solid alone: the
/// finding at the operation says what a surface becomes there.
pub(super) fn parts(scene: &Scene) -> Vec<Parts> {
    fold_up(&scene.nodes, |i, node, parts: &[Parts]| {
        let of = |n: NodeId| parts[n as usize];
        match node {
            Node::Shape(s) => match scene.shapes[s as usize].geometry.is_solid() {
                true => Parts {
                    surface: None,
                    solid: true,
                },
                false => Parts {
                    surface: Some(i),
                    solid: false,
                },
            },
            Node::Union(a, b) => Parts {
                surface: of(a).surface.or(of(b).surface),
                solid: of(a).solid || of(b).solid,
            },
            Node::Transform { child, .. }
            | Node::Paint { child, .. }
            | Node::Copy { child, .. } => of(child),
            Node::Intersection(..) | Node::Difference(..) | Node::Complement(_) => Parts {
                surface: None,
                solid: true,
            },
        }
    })
}
