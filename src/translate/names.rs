//! Names of the objects of a translation: the IDs of the scene, and its captions beside them.

use std::collections::HashMap;

use crate::scene::{Entity, Node, NodeId, Scene};
use crate::syntax::Captions;
use crate::syntax::table::{RecordKind, RecordType};

/// The entities of a scene by their IDs.
pub struct Names<'a> {
    scene: &'a Scene,
    captions: &'a Captions,
    nodes: HashMap<u32, NodeId>,
}

impl<'a> Names<'a> {
    pub fn new(scene: &'a Scene, captions: &'a Captions) -> Names<'a> {
        let node = |e: &Entity| Some((e.id, e.node()?));
        Names {
            scene,
            captions,
            nodes: scene.entities.iter().filter_map(node).collect(),
        }
    }

    /// The words of the scene's comment about an entity; `None` if there is none.
    pub fn words(&self, id: u32) -> Option<&str> {
        self.captions.get(id)
    }

    /// The entity's type of record, and the words of the scene's comment about it. `None` for an ID that is not of an
    /// object.
    pub fn comment(&self, id: u32) -> Option<String> {
        comment(self.scene, self.captions, *self.nodes.get(&id)?, id)
    }
}

/// The type of record that defined an entity, and the words of the scene's comment about it. `node` is one of the
/// entity's nodes. `None` for the ID 0.
pub fn comment(scene: &Scene, captions: &Captions, node: NodeId, id: u32) -> Option<String> {
    // The type is that of the first node below that is not merely moved or painted. A few steps tell; beyond 64 there
    // is no description.
    let kind = scene
        .states(node)
        .take(64)
        .find_map(|(_, node)| match node {
            Node::Transform { .. } | Node::Paint { .. } => None,
            Node::Shape(shape) => Some(scene.shapes[shape as usize].ty().kind),
            Node::Union(..) => Some(RecordKind::Union),
            Node::Intersection(..) => Some(RecordKind::Intersection),
            Node::Difference(..) => Some(RecordKind::Difference),
            Node::Complement(_) => Some(RecordKind::Complement),
            Node::Copy { .. } => Some(RecordKind::Copy),
        })?;
    let title = RecordType::of(kind).title;
    (id != 0).then(|| match captions.get(id) {
        Some(words) => format!("{title}, {words}"),
        None => title.to_owned(),
    })
}

/// For every node the ID of its entity, 0 where none can be told. An entity's node stands on top of
/// a chain of transformations and properties over the shape or operation that defined it; the whole
/// chain is the entity's, in its earlier states.
pub fn node_ids(scene: &Scene) -> Vec<u32> {
    let mut ids = vec![0; scene.nodes.len()];
    for entity in &scene.entities {
        for (id, node) in entity.node().into_iter().flat_map(|n| scene.states(n)) {
            if ids[id as usize] != 0 {
                break;
            }
            ids[id as usize] = entity.id;
            if !node.is_change() {
                break;
            }
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
