//! Groups of several media that were moved or given properties as a whole, such as a glass with its wine:
//! written part by part where they touch other glass, since each part has to be seen among those of the
//! union around it.

use std::collections::HashMap;

use super::aspects::Aspects;
use super::facts::{Facts, facts};
use super::rewrite::{Rewrite, Way, below};
use crate::scene::bounds::{NodeBounds, node_bounds};
use crate::scene::{Aabb, Node, NodeId, Scene};

/// Unions of more parts are left as they are.
const MANY: usize = 512;
/// Groups of more parts, too.
const FEW: usize = 32;

/// The same scene with such groups spread, if there are any.
pub fn spread(scene: &Scene) -> Option<Scene> {
    let root = scene.render?.root;
    let mut unions = wholes(scene, root);
    unions.retain(|parts| parts.iter().any(|part| union(scene, *part).is_some()));
    if unions.is_empty() {
        return None;
    }
    let mut aspects = Aspects::of(scene);
    let facts = facts(scene, &mut aspects, root);
    let bounds = node_bounds(scene);
    let is_clear = |node: NodeId| facts[node as usize].transparent;
    let mut groups = HashMap::new();
    for parts in unions {
        for &part in &parts {
            let mut others = parts.iter().filter(|other| **other != part);
            if is_group(scene, &facts, part)
                && others.any(|other| is_clear(*other) && touch(&bounds, part, *other))
                && let Some(members) = members(scene, part)
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
        } else if facts[node as usize].uses > 0 {
            let renewed = out.renew(node);
            out.settle(node, renewed);
        }
    }
    Some(out.finish())
}

/// The parts of all unions that are no parts of unions themselves, but of those of very many.
fn wholes(scene: &Scene, root: NodeId) -> Vec<Vec<NodeId>> {
    let mut is_part = vec![false; root as usize + 1];
    let mut wholes = Vec::new();
    for node in (0..=root).rev() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            if !is_part[node as usize] {
                wholes.extend(parts(scene, node));
            }
            is_part[a as usize] = true;
            is_part[b as usize] = true;
        }
    }
    wholes
}

/// What a union is made of, that of the unions among its operands, too.
fn parts(scene: &Scene, union: NodeId) -> Option<Vec<NodeId>> {
    let mut parts = Vec::new();
    let mut todo = vec![union];
    let mut unions = 0;
    while let Some(node) = todo.pop() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            unions += 1;
            todo.extend([a, b]);
        } else {
            parts.push(node);
        }
        if parts.len() + unions > 2 * MANY {
            return None;
        }
    }
    Some(parts)
}

/// What is done to a union, the last first, and its operands; `None` for what is none.
fn union(scene: &Scene, node: NodeId) -> Option<(Way, NodeId, NodeId)> {
    let (way, core) = below(scene, node);
    match scene.nodes[core as usize] {
        Node::Union(a, b) => Some((way, a, b)),
        _ => None,
    }
}

/// Whether light goes through a node, and it is of several media.
fn is_group(scene: &Scene, facts: &[Facts], node: NodeId) -> bool {
    let of = &facts[node as usize];
    of.transparent && !(of.optics.uniform && of.index.uniform) && union(scene, node).is_some()
}

/// The parts of a group that are no unions themselves, each with what is done to it, the last first.
fn members(scene: &Scene, group: NodeId) -> Option<Vec<(Way, NodeId)>> {
    let mut todo = vec![(Vec::new(), group)];
    let mut members = Vec::new();
    while let Some((mut way, node)) = todo.pop() {
        if members.len() + todo.len() > FEW {
            return None;
        }
        if let Some((more, a, b)) = union(scene, node) {
            way.extend(more);
            todo.extend([(way.clone(), b), (way, a)]);
        } else {
            members.push((way, node));
        }
    }
    Some(members)
}

/// A union of members to which is done by itself what was done to their group.
fn joined(out: &mut Rewrite, group: NodeId, members: &[(Way, NodeId)]) -> NodeId {
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

/// Whether the boxes of two nodes have a point in common but for rounding.
fn touch(bounds: &[NodeBounds], a: NodeId, b: NodeId) -> bool {
    let [a, b] = [a, b].map(|node| bounds[node as usize].all);
    let ends = [a, b].into_iter().flat_map(|b: Aabb| [b.min, b.max]);
    let finite = ends.flatten().filter(|x| x.is_finite());
    let hair = 1e-9 * finite.fold(0.0f64, |m, x| m.max(x.abs()));
    (0..3).all(|i| a.min[i] <= b.max[i] + hair && b.min[i] <= a.max[i] + hair)
}
