//! How many media a ray can be in at most.

use super::unseen::LeftOut;
use crate::geometry::Aabb;
use crate::scene::{Node, NodeId, Scene, fold_up};
use crate::solids::bounds;

/// An upper bound on the number of transparent solids that hold one point.
///
/// A union counts the larger of its operands if their boxes lie apart, else the sum of both. An intersection and a
/// difference count their first operand, to which their points belong. Complements turn these operations into each
/// other, so in a scene with complements every operation counts the sum. Each node keeps two numbers: one with its own
/// optics, and one as if all of it were transparent, since a paint above may make it transparent.
pub(super) fn depth(scene: &Scene, root: NodeId, complements: bool, left_out: &LeftOut) -> u32 {
    let boxes = match complements {
        false => bounds::node_bounds(scene),
        true => Vec::new(),
    };
    let apart = |a: NodeId, b: NodeId| {
        let of = |n: NodeId| boxes.get(n as usize).map_or(Aabb::ALL, |b| b.all);
        !of(a).overlaps(&of(b))
    };
    // The first number is with the node's own optics, the second as if all were transparent.
    let depths = fold_up(scene.up_to(root), |here, node, depths: &[[u32; 2]]| {
        let of = |n: NodeId| depths[n as usize];
        let both = |a: NodeId, b: NodeId, f: fn(u32, u32) -> u32| {
            let (a, b) = (of(a), of(b));
            [f(a[0], b[0]), f(a[1], b[1])]
        };
        match node {
            Node::Shape(s) => [0, u32::from(scene.shapes[s as usize].geometry.is_solid())],
            Node::Union(a, b) => {
                let kept: Vec<NodeId> = left_out.kept(here, [a, b]).collect();
                match kept[..] {
                    [a, b] if apart(a, b) => both(a, b, u32::max),
                    [a, b] => both(a, b, u32::saturating_add),
                    [one] => of(one),
                    _ => [0, 0],
                }
            }
            Node::Intersection(a, b) | Node::Difference(a, b) if complements => {
                both(a, b, u32::saturating_add)
            }
            Node::Intersection(a, _) | Node::Difference(a, _) => of(a),
            // A complement is all of space less something, and so counts at least once.
            Node::Complement(child) => of(child).map(|n| n.max(1)),
            Node::Transform { child, .. } | Node::Copy { child, .. } => of(child),
            Node::Paint { child, paint } => {
                let all = of(child)[1];
                match scene.paints[paint as usize].optics {
                    None => of(child),
                    Some(optics) if optics.kt != [0.0; 3] => [all, all],
                    Some(_) => [0, all],
                }
            }
        }
    });
    depths[root as usize][0]
}
