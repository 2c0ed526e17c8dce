//! Differences of intersections in the order that POV-Ray can have: (A ∩ B) − C is written as (A − C) ∩ B if A is of
//! several looks. Each part of A is then cut by itself.

use super::rewrite::{Rewrite, below};
use crate::scene::{Node, NodeId, Scene};
use crate::translate::pov::budget::Budget;
use crate::translate::pov::model::materials::{Facts, Material};

/// The scene with such operations in the other order; `None` if there are none.
pub(super) fn reordered(scene: &Scene, facts: &Facts, budget: &Budget) -> Option<Scene> {
    let root = scene.render?.root;
    if !(0..=root).any(|node| is_candidate(scene, node, budget)) {
        return None;
    }
    let materials = &facts.materials;
    let mut out = Rewrite::of(scene);
    let mut any = false;
    for node in (0..=root).filter(|node| materials[*node as usize].uses > 0) {
        let renewed = out.renew(node);
        let by = match (scene.nodes[node as usize], renewed) {
            (Node::Difference(a, _), Node::Difference(now, tool))
                if !is_uniform(&materials[a as usize]) =>
            {
                cut_first(&mut out, node, (now, tool), budget)
            }
            _ => None,
        };
        any |= by.is_some();
        match by {
            Some(by) => out.replace(node, by),
            None => out.settle(node, renewed),
        }
    }
    any.then(|| out.finish())
}

/// Whether a node is a difference of an intersection.
fn is_candidate(scene: &Scene, node: NodeId, budget: &Budget) -> bool {
    let Node::Difference(a, _) = scene.nodes[node as usize] else {
        return false;
    };
    let core = below(scene, a, budget).1;
    matches!(scene.nodes[core as usize], Node::Intersection(..))
}

/// Whether a solid has the same look and index everywhere.
fn is_uniform(solid: &Material) -> bool {
    solid.texture.uniform && solid.optics.uniform && solid.index.uniform
}

/// Adds (A − C) ∩ B for (A ∩ B) − C, with the origin of `node`, and returns it. The base is A ∩ B, the tool is C.
/// `None` if the base is no intersection.
fn cut_first(
    out: &mut Rewrite,
    node: NodeId,
    (base, tool): (NodeId, NodeId),
    budget: &Budget,
) -> Option<NodeId> {
    let (way, core) = below(&out.scene, base, budget);
    let Node::Intersection(a, b) = out.scene.nodes[core as usize] else {
        return None;
    };
    let [a, b] = [a, b].map(|operand| out.done(&way, operand));
    let cut = out.push(Node::Difference(a, tool), node);
    Some(out.push(Node::Intersection(cut, b), node))
}
