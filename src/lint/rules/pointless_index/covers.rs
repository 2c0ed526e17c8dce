//! Optics of a whole object that keep light out of a part with an index, though the part by itself lets light through.

use super::{lets_through, paint_of, transmits};
use crate::diagnostics::Span;
use crate::lint::Context;
use crate::scene::{Node, NodeId, Optics, Scene};
use crate::syntax::Record;
use crate::syntax::table::RecordKind;

pub(super) struct Covers<'a> {
    scene: &'a Scene,
    transmits: Vec<bool>,
    /// For each node the outermost paint with optics above it: these optics count.
    above: Vec<Option<NodeId>>,
}

impl<'a> Covers<'a> {
    pub(super) fn new(scene: &'a Scene) -> Covers<'a> {
        let mut above: Vec<Option<NodeId>> = vec![None; scene.nodes.len()];
        // Children stand before their parents.
        for (i, &node) in scene.nodes.iter().enumerate().rev() {
            let has_optics = paint_of(scene, node).is_some_and(|p| p.optics.is_some());
            let own = above[i].or_else(|| has_optics.then_some(i as NodeId));
            for child in node.children() {
                let below = &mut above[child as usize];
                *below = below.or(own);
            }
        }
        Covers {
            scene,
            transmits: transmits(scene),
            above,
        }
    }

    fn optics(&self, node: NodeId) -> Option<Optics> {
        paint_of(self.scene, self.scene.nodes[node as usize])?.optics
    }

    /// The paint with opaque optics above a transparent object with the index that a record gives; `None` if there is
    /// none.
    pub(super) fn of(&self, sources: &[Option<Span>], source: Span) -> Option<NodeId> {
        let nodes = (0..).zip(&self.scene.nodes);
        let mut own = nodes.filter(|(node, _)| sources[*node as usize] == Some(source));
        own.find_map(|(node, made)| {
            let Node::Paint { child, .. } = made else {
                return None;
            };
            let clear = match self.optics(node) {
                Some(optics) => lets_through(optics.kt),
                None => self.transmits[*child as usize],
            };
            let cover = self.above[node as usize].filter(|_| clear)?;
            let covers = |optics: Optics| !lets_through(optics.kt);
            self.optics(cover).is_some_and(covers).then_some(cover)
        })
    }
}

/// The record that gives a paint its optics.
pub(super) fn optics_of<'a>(context: &Context<'a>, paint: NodeId) -> Option<&'a Record> {
    let origin = context.scene.origins[paint as usize];
    let start = |r: &Record| context.document.span(r.first, r.last).start;
    let own = context.records().filter(|r| r.id == origin.id);
    let own = own.take_while(|r| start(r) <= origin.span.start);
    let gives = |r: &&Record| r.ty().gives_optics() || r.kind == RecordKind::Assignment;
    own.filter(gives).last()
}
