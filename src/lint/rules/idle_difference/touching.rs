//! Solids that have no more than a face or a point in common.

use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::operations::Proof;
use crate::scene::{Node, NodeId};
use crate::solids::distance;
use crate::solids::extent::ball;
use crate::solids::within::{CLEARANCE_REL, far};

/// Most parts of an operand: with more, nothing is known.
const MAX_PARTS: usize = 64;

/// Whether the common part of two solids certainly has no thickness. `false` for surfaces and for empty solids, which
/// other rules report.
pub(in crate::lint::rules) fn touch(context: &Context, a: NodeId, b: NodeId) -> bool {
    let (Some(first), Some(second)) = (parts(context, a), parts(context, b)) else {
        return false;
    };
    let is_thin = |&x: &NodeId| second.iter().all(|&y| is_thin(context, x, y));
    first.iter().all(is_thin)
}

/// The parts of a union. `None` if there are too many, or if one is a surface or empty.
pub(super) fn parts(context: &Context, node: NodeId) -> Option<Vec<NodeId>> {
    let (mut all, mut open) = (Vec::new(), vec![node]);
    while let Some(node) = open.pop() {
        match context.scene.nodes[node as usize] {
            Node::Union(a, b) => open.extend([a, b]),
            Node::Paint { child, .. } | Node::Copy { child, .. } => open.push(child),
            _ if is_silent(context, node) => return None,
            _ => all.push(node),
        }
        if all.len() + open.len() > MAX_PARTS {
            return None;
        }
    }
    Some(all)
}

/// Whether a part is a surface, or empty for certain.
fn is_silent(context: &Context, node: NodeId) -> bool {
    let scene = context.scene;
    let (core, _) = scene.core(node, Matrix::IDENTITY);
    match scene.nodes[core as usize] {
        Node::Shape(shape) => !scene.shapes[shape as usize].geometry.is_solid(),
        _ => {
            let at = context.proven().binary_search_by_key(&core, |p| p.node);
            at.is_ok_and(|at| matches!(context.proven()[at].what, Proof::Empty(..)))
        }
    }
}

fn is_thin(context: &Context, x: NodeId, y: NodeId) -> bool {
    let boxes = [x, y].map(|n| &context.bounds()[n as usize].all);
    if boxes.iter().any(|b| b.is_empty()) || [x, y].iter().any(|&n| context.is_flat(n)) {
        return false;
    }
    thin_box(boxes) || balls_touch(context, x, y)
}

/// Whether the common part of two boxes is empty or thin along an axis.
fn thin_box([a, b]: [&Aabb; 2]) -> bool {
    (0..3).any(|i| {
        let ends = [a.max[i], b.max[i], a.min[i], b.min[i]];
        let [low, high] = [a.min[i].max(b.min[i]), a.max[i].min(b.max[i])];
        let reach = ends.into_iter().filter(|x| x.is_finite());
        let reach = reach.fold(0.0f64, |m, x| m.max(x.abs()));
        high - low <= CLEARANCE_REL * reach
    })
}

/// Whether two nodes are balls whose centres are as far apart as their radii together, up to rounding, or farther.
fn balls_touch(context: &Context, x: NodeId, y: NodeId) -> bool {
    let scene = context.scene;
    let of = |node: NodeId| {
        let (core, matrix) = scene.core(node, Matrix::IDENTITY);
        match scene.nodes[core as usize] {
            Node::Shape(shape) => ball(scene, shape, &matrix),
            _ => None,
        }
    };
    let (Some((c, r)), Some((d, s))) = (of(x), of(y)) else {
        return false;
    };
    distance(c, d) >= (r + s) - CLEARANCE_REL * (r + s + far(&c) + far(&d))
}
