//! Which entity a node belongs to, so that the objects of a translation are called after the IDs of
//! the scene.

use crate::scene::{Node, Scene};

/// For every node the ID of its entity, 0 where none can be told. An entity's node stands on top of
/// a chain of transformations and properties over the shape or operation that defined it; the whole
/// chain is the entity's, in its earlier states.
pub fn node_ids(scene: &Scene) -> Vec<u32> {
    let mut ids = vec![0; scene.nodes.len()];
    for entity in &scene.entities {
        let mut next = entity.node;
        while let Some(node) = next.filter(|n| ids[*n as usize] == 0) {
            ids[node as usize] = entity.id;
            next = match scene.nodes[node as usize] {
                Node::Transform { child, .. } | Node::Paint { child, .. } => Some(child),
                _ => None,
            };
        }
    }
    for (i, node) in scene.nodes.iter().enumerate() {
        if ids[i] == 0 {
            ids[i] = match *node {
                Node::Shape(shape) => scene.shapes[shape as usize].id,
                Node::Copy { id, .. } => id,
                Node::Paint { paint, .. } => scene.paints[paint as usize].owner,
                Node::Transform { child, .. }
                | Node::Complement(child)
                | Node::Union(child, _)
                | Node::Intersection(child, _)
                | Node::Difference(child, _) => ids[child as usize],
            };
        }
    }
    ids
}
