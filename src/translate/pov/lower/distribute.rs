//! Groups: unions of several media, or of opaque parts, that were moved or painted as a whole, such as a glass with its
//! wine. A group that touches other glass is written part by part, since each part has to be seen among those of the
//! union around it.

use std::collections::{HashMap, HashSet};

use super::rewrite::{Modifications, Rewrite, below};
use crate::geometry::Aabb;
use crate::scene::{Node, NodeId, Scene};
use crate::translate::pov::budget::{Budget, Limit};
use crate::translate::pov::model::Model;
use crate::translate::pov::model::materials::{Facts, Material};

/// The scene with such groups written part by part; `None` if there are none.
pub(super) fn distributed(scene: &Scene, facts: &Facts, budget: &Budget) -> Option<Scene> {
    let root = scene.render?.root;
    if !facts.is_clear() {
        return None;
    }
    let mut unions: Vec<_> = wholes(scene, root, budget)
        .into_iter()
        .map(|w| w.parts)
        .collect();
    unions.retain(|parts| {
        parts
            .iter()
            .any(|part| union(scene, *part, budget).is_some())
    });
    let is_clear = |node: NodeId| facts.materials[node as usize].transparent;
    let box_of = |node: NodeId| facts.bounds[node as usize].all;
    let mut groups = HashMap::new();
    for parts in unions {
        for &part in &parts {
            let mut others = parts.iter().filter(|other| **other != part);
            if is_group(scene, &facts.materials, part, budget)
                && others.any(|other| is_clear(*other) && box_of(part).touches(&box_of(*other)))
                && let Some(members) = members(scene, part, budget)
            {
                groups.insert(part, members);
            }
        }
    }
    if groups.is_empty() {
        return None;
    }
    let mut out = Rewrite::of(scene);
    for node in 0..=root {
        if let Some(members) = groups.get(&node) {
            let union = joined(&mut out, node, members);
            out.replace(node, union);
        } else if facts.materials[node as usize].uses > 0 {
            let renewed = out.renew(node);
            out.settle(node, renewed);
        }
    }
    Some(out.finish())
}

/// The opaque unions that touch a part, in the union around them, that light goes through.
pub(super) fn beside_clear(model: &Model, root: NodeId) -> HashSet<NodeId> {
    let is_clear = |node: &NodeId| model.materials[*node as usize].transparent;
    let box_of = |node: NodeId| model.box_of(node);
    let mut beside = HashSet::new();
    for whole in wholes(model.scene, root, model.budget) {
        let clear: Vec<Aabb> = (whole.parts.iter().copied())
            .filter(is_clear)
            .map(box_of)
            .collect();
        let opaque = whole.unions.into_iter().filter(|union| !is_clear(union));
        beside.extend(opaque.filter(|u| clear.iter().any(|c| c.touches(&box_of(*u)))));
    }
    beside
}

/// A union that is no operand of another union.
#[derive(Default)]
struct Whole {
    /// The union itself, and all unions among its operands, at any depth.
    unions: Vec<NodeId>,
    /// The operands of these unions that are no unions.
    parts: Vec<NodeId>,
}

/// All unions that are no operands of other unions, except those of too many parts.
fn wholes(scene: &Scene, root: NodeId, budget: &Budget) -> Vec<Whole> {
    let mut is_part = vec![false; root as usize + 1];
    let mut wholes = Vec::new();
    for node in (0..=root).rev() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            if !is_part[node as usize] {
                wholes.extend(whole(scene, node, budget));
            }
            is_part[a as usize] = true;
            is_part[b as usize] = true;
        }
    }
    wholes
}

/// A union with all unions and parts that it is made of; `None` if there are too many.
fn whole(scene: &Scene, union: NodeId, budget: &Budget) -> Option<Whole> {
    let mut whole = Whole::default();
    let mut todo = vec![union];
    while let Some(node) = todo.pop() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            whole.unions.push(node);
            todo.extend([a, b]);
        } else {
            whole.parts.push(node);
        }
        // A whole has one part more than unions, so half of the nodes are parts.
        let nodes = whole.parts.len() + whole.unions.len();
        if !budget.spend(Limit::PartsAround, nodes.div_ceil(2)) {
            return None;
        }
    }
    Some(whole)
}

/// The modifications of a node, the last first, and the two operands of the union that they modify. `None` if they
/// modify no union.
fn union(scene: &Scene, node: NodeId, budget: &Budget) -> Option<(Modifications, NodeId, NodeId)> {
    let (way, core) = below(scene, node, budget);
    match scene.nodes[core as usize] {
        Node::Union(a, b) => Some((way, a, b)),
        _ => None,
    }
}

/// Whether a node is a union of several media, or an opaque one.
fn is_group(scene: &Scene, materials: &[Material], node: NodeId, budget: &Budget) -> bool {
    let of = &materials[node as usize];
    let is_one = of.transparent && of.optics.uniform && of.index.uniform;
    !is_one && union(scene, node, budget).is_some()
}

/// The parts of a group that are no unions themselves, each with its modifications within the group, the last first.
/// `None` if there are too many.
fn members(scene: &Scene, group: NodeId, budget: &Budget) -> Option<Vec<(Modifications, NodeId)>> {
    let mut todo = vec![(Vec::new(), group)];
    let mut members = Vec::new();
    while let Some((mut way, node)) = todo.pop() {
        if !budget.spend(Limit::PartsSplit, members.len() + todo.len()) {
            return None;
        }
        if let Some((more, a, b)) = union(scene, node, budget) {
            way.extend(more);
            todo.extend([(way.clone(), b), (way, a)]);
        } else {
            members.push((way, node));
        }
    }
    Some(members)
}

/// Adds a union of a group's members, each with its modifications, and returns it. Its origin is that of the group.
fn joined(out: &mut Rewrite, group: NodeId, members: &[(Modifications, NodeId)]) -> NodeId {
    let mut union = None;
    for (way, member) in members {
        let node = out.done(way, out.now(*member));
        union = Some(match union {
            Some(union) => out.push(Node::Union(union, node), group),
            None => node,
        });
    }
    union.unwrap_or(group)
}
