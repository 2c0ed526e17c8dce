//! What is known for certain of intersections and differences: that there is nothing in them, or that nothing is taken
//! away.
//!
//! An operation without unions is that everything of a list is to hold: some things, and the complements of others. It is
//! empty if two of the first lie apart, if one of the first lies within one of the second, or is the same. Chains keep a
//! few of their list only.

use super::Context;
use crate::scene::{Node, NodeId};
use crate::solids::proofs::{Literals, Proofs, Reason};

/// An intersection or a difference of which something is known.
pub struct Proven {
    pub node: NodeId,
    pub what: Proof,
}

pub enum Proof {
    /// There is nothing in it, because of two nodes.
    Empty(NodeId, NodeId, Reason),
    /// A difference whose operands have nothing in common.
    Idle(Reason),
}

/// All such operations, in the order of the nodes. Those of an empty operand are left out: of that has been spoken.
pub fn proven(context: &Context) -> Vec<Proven> {
    let scene = context.scene;
    let bounds = context.bounds();
    let mut proofs = Proofs::new(scene, bounds);
    let mut out = Vec::new();
    // What is empty has been spoken of, here or by the rules about shapes.
    let mut empty: Vec<bool> = Vec::with_capacity(scene.nodes.len());
    let mut lists: Vec<Literals> = Vec::with_capacity(scene.nodes.len());
    for (i, node) in scene.nodes.iter().enumerate() {
        let is_empty = |n: NodeId| empty[n as usize];
        let own = Literals::new((i as NodeId, false));
        let (nothing, list) = match *node {
            Node::Shape(_) => (bounds[i].all.is_empty(), own),
            Node::Transform { child, .. } => (is_empty(child), own),
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                (is_empty(child), lists[child as usize])
            }
            Node::Union(a, b) => (is_empty(a) && is_empty(b), own),
            Node::Complement(child) => match lists[child as usize][..] {
                [(n, turned)] => (false, Literals::new((n, !turned))),
                _ => (false, own),
            },
            Node::Intersection(a, b) | Node::Difference(a, b) => {
                let cut = matches!(node, Node::Difference(..));
                let first = lists[a as usize];
                let second = match cut {
                    true => proofs.complement(b, &lists),
                    false => lists[b as usize].to_vec(),
                };
                let mut nothing = is_empty(a) || (!cut && is_empty(b));
                if !(nothing || cut && is_empty(b)) {
                    let proof = proofs.nothing(&first, &second, (!cut).then_some((a, b)));
                    nothing = proof.is_some();
                    let what = match proof {
                        Some((x, y, reason)) => Some(Proof::Empty(x, y, reason)),
                        None if cut => {
                            let tool = &lists[b as usize];
                            let common = proofs.nothing(&first, tool, Some((a, b)));
                            common.map(|(_, _, reason)| Proof::Idle(reason))
                        }
                        None => None,
                    };
                    let node = i as NodeId;
                    out.extend(what.map(|what| Proven { node, what }));
                }
                let mut all = first;
                all.extend(&second);
                (nothing, all)
            }
        };
        empty.push(nothing);
        lists.push(list);
    }
    out
}
