//! Colours of tools that are taken away, held against the colours that the cuts have.

use crate::scene::{Node, NodeId, Rgb, Scene, Texture, fold_up};
use rustc_hash::FxHashSet;

/// The colours of an object.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Colours {
    None,
    One(Rgb),
    Several,
}

impl Colours {
    fn and(self, other: Colours) -> Colours {
        match (self, other) {
            (Colours::None, one) | (one, Colours::None) => one,
            (one, other) if one == other => one,
            _ => Colours::Several,
        }
    }
}

/// The colours that are not seen on the cuts of their tools, and differ from those of the cuts.
pub(super) struct Instead {
    differing: FxHashSet<usize>,
}

impl Instead {
    /// `paintings` are nodes that give a colour which is cut away, each with the index of its record.
    pub(super) fn new(
        scene: &Scene,
        paintings: impl Iterator<Item = (NodeId, usize)>,
        is_drawn: impl Fn(NodeId) -> bool,
    ) -> Instead {
        let mut paintings = paintings.peekable();
        let mut differing = FxHashSet::default();
        if paintings.peek().is_some() {
            let cuts = cuts(scene, is_drawn);
            for (node, record) in paintings {
                let own = given(scene, scene.nodes[node as usize]);
                if own != Some(cuts[node as usize]) {
                    differing.insert(record);
                }
            }
        }
        Instead { differing }
    }

    /// Whether a cut has another colour than the record with this index gives.
    pub(super) fn differs(&self, record: usize) -> bool {
        self.differing.contains(&record)
    }
}

/// The colour that a paint gives to all below it.
fn given(scene: &Scene, node: Node) -> Option<Colours> {
    let Node::Paint { paint, .. } = node else {
        return None;
    };
    match scene.paints[paint as usize].texture {
        Some(Texture::Colour(colour)) => Some(Colours::One(colour)),
        Some(_) => Some(Colours::Several),
        None => None,
    }
}

/// For each node the colours of the cut faces that it leaves as a part of a tool.
fn cuts(scene: &Scene, is_drawn: impl Fn(NodeId) -> bool) -> Vec<Colours> {
    let own = fold_up(&scene.nodes, |_, node, own: &[Colours]| {
        let of = |n: NodeId| own[n as usize];
        match node {
            Node::Shape(_) => Colours::One([1.0; 3]),
            Node::Union(a, b) | Node::Intersection(a, b) => of(a).and(of(b)),
            Node::Difference(a, _) => of(a),
            Node::Paint { child, .. } => given(scene, node).unwrap_or(of(child)),
            Node::Complement(child) | Node::Transform { child, .. } | Node::Copy { child, .. } => {
                of(child)
            }
        }
    });
    let mut above = vec![Colours::None; scene.nodes.len()];
    let mut cuts = above.clone();
    // Children stand before their parents.
    let drawn = (0..scene.nodes.len())
        .rev()
        .filter(|&i| is_drawn(i as NodeId));
    for at in drawn {
        let node = scene.nodes[at];
        let over = match above[at] {
            Colours::None => given(scene, node).unwrap_or(Colours::None),
            over => over,
        };
        for child in node.children() {
            let child = child as usize;
            above[child] = above[child].and(over);
            cuts[child] = cuts[child].and(cuts[at]);
        }
        if let Node::Difference(a, tool) = node {
            let seen = match over {
                Colours::None => own[a as usize],
                over => over,
            };
            cuts[tool as usize] = cuts[tool as usize].and(seen);
        }
    }
    cuts
}
