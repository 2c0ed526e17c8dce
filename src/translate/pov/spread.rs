//! Groups of several media that were moved or given properties as a whole, such as a glass with its wine:
//! written part by part where they touch other glass, since each part has to be seen among those of the
//! union around it.

use std::collections::HashMap;

use super::aspects::Aspects;
use super::facts::{Facts, facts};
use crate::scene::bounds::{NodeBounds, node_bounds};
use crate::scene::{Aabb, Node, NodeId, Scene};

/// Scenes of more parts are left as they are.
const MANY: usize = 512;
/// Groups of more parts, too.
const FEW: usize = 32;

/// The same scene with such groups spread, if there are any.
pub fn spread(scene: &Scene) -> Option<Scene> {
    let root = scene.render?.root;
    let (unions, parts) = spine(scene, root)?;
    if !parts.iter().any(|p| below(scene, *p).1.is_some()) {
        return None;
    }
    let mut aspects = Aspects::of(scene);
    let facts = facts(scene, &mut aspects, root);
    let bounds = node_bounds(scene);
    let is_clear = |node: NodeId| facts[node as usize].transparent;
    let touches = |part: NodeId| {
        let mut others = parts.iter().filter(|other| **other != part);
        others.any(|other| is_clear(*other) && touch(&bounds, part, *other))
    };
    let mut out = None;
    let mut new: HashMap<NodeId, NodeId> = HashMap::new();
    for &part in &parts {
        if is_group(scene, &facts, part)
            && touches(part)
            && let Some(members) = members(scene, part)
        {
            let out = out.get_or_insert_with(|| scene.clone());
            new.insert(part, joined(out, part, &members));
        }
    }
    let mut out = out?;
    for union in unions {
        let Node::Union(a, b) = scene.nodes[union as usize] else {
            continue;
        };
        let now = |node: NodeId| new.get(&node).copied().unwrap_or(node);
        let (now_a, now_b) = (now(a), now(b));
        if (now_a, now_b) != (a, b) {
            let node = push(&mut out, Node::Union(now_a, now_b), union);
            new.insert(union, node);
        }
    }
    let now = |node: &mut NodeId| *node = new.get(node).copied().unwrap_or(*node);
    out.render.iter_mut().for_each(|r| now(&mut r.root));
    (out.promises.iter_mut()).for_each(|p| now(&mut p.node));
    let entities = out.entities.iter_mut();
    entities.filter_map(|e| e.node.as_mut()).for_each(now);
    Some(out)
}

/// The unions that a scene is, children first, and what they are made of.
fn spine(scene: &Scene, root: NodeId) -> Option<(Vec<NodeId>, Vec<NodeId>)> {
    let (mut unions, mut parts) = (Vec::new(), Vec::new());
    let mut todo = vec![root];
    while let Some(node) = todo.pop() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            unions.push(node);
            todo.extend([a, b]);
        } else {
            parts.push(node);
        }
        if parts.len() + unions.len() > 2 * MANY {
            return None;
        }
    }
    unions.sort_unstable();
    unions.dedup();
    Some((unions, parts))
}

/// What is done to a node, the last first, and the union that it is done to, if it is one.
fn below(scene: &Scene, mut node: NodeId) -> (Vec<NodeId>, Option<(NodeId, NodeId)>) {
    let mut way = Vec::new();
    loop {
        match scene.nodes[node as usize] {
            Node::Transform { child, .. } | Node::Paint { child, .. } => {
                way.push(node);
                node = child;
            }
            // Only the names of its parts are the copy's.
            Node::Copy { child, .. } => node = child,
            Node::Union(a, b) => return (way, Some((a, b))),
            _ => return (way, None),
        }
    }
}

/// Whether light goes through a node, and it is of several media.
fn is_group(scene: &Scene, facts: &[Facts], node: NodeId) -> bool {
    let of = &facts[node as usize];
    of.transparent && !(of.optics.uniform && of.index.uniform) && below(scene, node).1.is_some()
}

/// The parts of a group that are no unions themselves, each with what is done to it, the last first.
fn members(scene: &Scene, group: NodeId) -> Option<Vec<(Vec<NodeId>, NodeId)>> {
    let mut todo = vec![(Vec::new(), group)];
    let mut members = Vec::new();
    while let Some((mut way, node)) = todo.pop() {
        if members.len() + todo.len() > FEW {
            return None;
        }
        let (more, union) = below(scene, node);
        if let Some((a, b)) = union {
            way.extend(more);
            todo.extend([(way.clone(), b), (way, a)]);
        } else {
            members.push((way, node));
        }
    }
    Some(members)
}

/// A union of members to which is done by itself what was done to their group.
fn joined(scene: &mut Scene, group: NodeId, members: &[(Vec<NodeId>, NodeId)]) -> NodeId {
    let mut union = None;
    for (way, member) in members {
        let mut node = *member;
        for done in way.iter().rev() {
            let next = match scene.nodes[*done as usize] {
                Node::Transform { matrix, .. } => Node::Transform {
                    child: node,
                    matrix,
                },
                Node::Paint { paint, .. } => Node::Paint { child: node, paint },
                other => other,
            };
            node = push(scene, next, *done);
        }
        union = Some(match union {
            Some(union) => push(scene, Node::Union(union, node), group),
            None => node,
        });
    }
    union.unwrap_or(group)
}

/// Adds a node, made by the record that made another one.
fn push(scene: &mut Scene, node: Node, like: NodeId) -> NodeId {
    scene.nodes.push(node);
    scene.origins.push(scene.origins[like as usize]);
    scene.nodes.len() as NodeId - 1
}

/// Whether the boxes of two nodes have a point in common but for rounding.
fn touch(bounds: &[NodeBounds], a: NodeId, b: NodeId) -> bool {
    let [a, b] = [a, b].map(|node| bounds[node as usize].all);
    let ends = [a, b].into_iter().flat_map(|b: Aabb| [b.min, b.max]);
    let finite = ends.flatten().filter(|x| x.is_finite());
    let hair = 1e-9 * finite.fold(0.0f64, |m, x| m.max(x.abs()));
    (0..3).all(|i| a.min[i] <= b.max[i] + hair && b.min[i] <= a.max[i] + hair)
}
