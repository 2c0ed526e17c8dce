//! The records that make textures and colours, and the nodes that paint with them.

use rustc_hash::FxHashMap;

use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Node, NodeId, Texture};
use crate::syntax::table::RecordKind;

/// A record that makes a texture or a colour.
pub(super) struct Given<'a> {
    pub params: Params<'a>,
    pub is_colour: bool,
    /// Index of the record that replaces the texture under the same ID.
    pub replaced: Option<usize>,
}

/// A node that paints, with the record that gives its texture or colour.
pub(super) struct Painting {
    pub node: NodeId,
    /// Index of the record among all that give a texture or colour; `None` if the paint has neither.
    pub texture: Option<usize>,
    /// The index of the painting that goes on from this one: properties given to an object one after the other are one
    /// paint.
    pub next: Option<usize>,
}

/// All records that make textures and colours, and all paintings, in file order.
pub(super) fn textures<'a>(context: &Context<'a>) -> (Vec<Given<'a>>, Vec<Painting>) {
    let scene = context.scene;
    let mut given: Vec<Given> = Vec::new();
    let mut paintings: Vec<Painting> = Vec::new();
    // The present texture of each ID, and the last painting of each object.
    let mut current: FxHashMap<u32, usize> = FxHashMap::default();
    let mut last: FxHashMap<u32, usize> = FxHashMap::default();
    // Nodes are in file order, and a record makes one at most.
    let mut nodes = (0..).zip(&scene.origins).peekable();
    for record in context.records() {
        let p = context.record_params(record);
        let of = |i: usize| u32::try_from(p.integer(i)).ok();
        let texture = match record.kind {
            RecordKind::ImageTexture
            | RecordKind::SolidTexture
            | RecordKind::Checkerboard
            | RecordKind::Colour => Some(given.len()),
            RecordKind::Assignment | RecordKind::Copy => {
                of(0).and_then(|id| current.get(&id)).copied()
            }
            _ => current.get(&p.id).copied(),
        };
        let before = match texture {
            Some(texture) => current.insert(p.id, texture),
            None => current.remove(&p.id),
        };
        let id = p.id;
        let start = p.span().start;
        if texture == Some(given.len()) {
            let is_colour = record.kind == RecordKind::Colour;
            if let Some(before) = before.filter(|_| !is_colour) {
                given[before].replaced = texture;
            }
            given.push(Given {
                params: p,
                is_colour,
                replaced: None,
            });
        }
        let made = nodes.next_if(|(_, origin)| origin.span.start == start);
        let Some((node, Node::Paint { child, paint })) =
            made.map(|(node, _)| (node, scene.nodes[node as usize]))
        else {
            continue;
        };
        let is_given = |at: &usize| match &scene.paints[paint as usize].texture {
            None => false,
            Some(Texture::Colour(_)) => given[*at].is_colour,
            Some(_) => !given[*at].is_colour,
        };
        if let Some(before) = last.insert(id, paintings.len())
            && let Node::Paint { child: same, .. } = scene.nodes[paintings[before].node as usize]
            && same == child
        {
            paintings[before].next = Some(paintings.len());
        }
        paintings.push(Painting {
            node,
            texture: texture.filter(is_given),
            next: None,
        });
    }
    (given, paintings)
}
