//! Intersections and differences with a proof that they are empty, or that nothing is taken away.
//!
//! An operation without unions is the intersection of a list: of some objects, and of the complements of others. It is
//! empty if two of the objects lie apart, or if an object lies within a complemented one or equals it. Of a long chain
//! of operations only a few list entries are kept.

use super::Context;
use crate::scene::{Node, NodeId, fold_up};
use crate::solids::proofs::{Literals, Proofs, Reason};

/// An intersection or a difference with a proof.
pub(super) struct Proven {
    pub node: NodeId,
    pub what: Proof,
}

pub(super) enum Proof {
    /// An operation that is empty because of these two nodes.
    Empty(NodeId, NodeId, Reason),
    /// A difference whose operands have nothing in common.
    Idle(Reason),
}

/// All operations with a proof, in the order of the nodes. Operations with an empty operand are left out: the operand
/// has a proof already.
pub(super) fn proven(context: &Context) -> Vec<Proven> {
    let scene = context.scene;
    let bounds = context.bounds();
    let mut proofs = Proofs::new(scene, bounds);
    let mut out = Vec::new();
    // For each node whether it is empty, which a finding here or of the rules about shapes says, and its list.
    fold_up(&scene.nodes, |node, made, done: &[(bool, Literals)]| {
        let is_empty = |n: NodeId| done[n as usize].0;
        let list = |n: NodeId| done[n as usize].1;
        let own = Literals::new((node, false));
        match made {
            Node::Shape(_) => (bounds[node as usize].all.is_empty(), own),
            Node::Transform { child, .. } => (is_empty(child), own),
            Node::Paint { child, .. } | Node::Copy { child, .. } => done[child as usize],
            Node::Union(a, b) => (is_empty(a) && is_empty(b), own),
            Node::Complement(child) => match list(child)[..] {
                [(n, turned)] => (false, Literals::new((n, !turned))),
                _ => (false, own),
            },
            Node::Intersection(a, b) | Node::Difference(a, b) => {
                let cut = matches!(made, Node::Difference(..));
                let first = list(a);
                let second = match cut {
                    true => proofs.complement(b, &list(b)),
                    false => list(b).to_vec(),
                };
                let mut nothing = is_empty(a) || (!cut && is_empty(b));
                if !(nothing || cut && is_empty(b)) {
                    let proof = proofs.nothing(&first, &second, (!cut).then_some((a, b)));
                    nothing = proof.is_some();
                    let what = match proof {
                        Some((x, y, reason)) => Some(Proof::Empty(x, y, reason)),
                        None if cut => {
                            let common = proofs.nothing(&first, &list(b), Some((a, b)));
                            common.map(|(_, _, reason)| Proof::Idle(reason))
                        }
                        None => None,
                    };
                    out.extend(what.map(|what| Proven { node, what }));
                }
                let mut all = first;
                all.extend(&second);
                (nothing, all)
            }
        }
    });
    out
}
