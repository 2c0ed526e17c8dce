//! Differences and intersections in the order that POV-Ray can have.
//!
//! (A ∩ B) − C is written as (A − C) ∩ B where A is of several looks: each of its parts is then cut by itself. And
//! (A − C) ∩ B as (A ∩ B) − C where C ends flush with B: it is made longer where it ends flush with what it is
//! taken from.

use super::rewrite::{Rewrite, Way, below};
use crate::geometry::Aabb;
use crate::scene::{Node, NodeId, Scene};
use crate::solids::bounds::node_bounds;
use crate::translate::pov::model::materials::{Material, materials};
use crate::translate::pov::model::tables::Tables;

/// Ends that are this near, as a part of the coordinates, may be flush; either order is right where they are not.
const NEAR: f64 = 1e-9;

/// So many cuts of an operand are looked at.
const FEW: usize = 64;

/// The same scene with such operations in the other order, if there are any.
pub fn reordered(scene: &Scene) -> Option<Scene> {
    let root = scene.render?.root;
    if !(0..=root).any(|node| is_candidate(scene, node)) {
        return None;
    }
    let mut tables = Tables::of(scene);
    let facts = materials(scene, &mut tables, root);
    let mut out = Order {
        boxes: node_bounds(scene).iter().map(|b| b.all).collect(),
        out: Rewrite::of(scene),
    };
    let mut any = false;
    for node in 0..=root {
        if facts[node as usize].uses == 0 {
            continue;
        }
        let renewed = out.out.renew(node);
        let by = match (scene.nodes[node as usize], renewed) {
            (Node::Difference(a, _), Node::Difference(now, tool)) if !is_uniform(&facts, a) => {
                out.cut_first(node, now, tool)
            }
            (Node::Intersection(a, b), Node::Intersection(now_a, now_b)) => {
                let like = has_one_look(&facts, a, b);
                let first = is_uniform(&facts, a)
                    .then(|| out.cut_last(node, now_a, now_b, true))
                    .flatten();
                first.or_else(|| like.then(|| out.cut_last(node, now_b, now_a, false))?)
            }
            _ => None,
        };
        any |= by.is_some();
        match by {
            Some(by) => out.out.replace(node, by),
            None => out.out.settle(node, renewed),
        }
        out.bound();
    }
    any.then(|| out.out.finish())
}

/// Whether a node is an operation one of whose operands is one of the other kind.
fn is_candidate(scene: &Scene, node: NodeId) -> bool {
    let core = |node: NodeId| scene.nodes[below(scene, node).1 as usize];
    let is_cut = |node: NodeId| matches!(core(node), Node::Difference(..));
    match scene.nodes[node as usize] {
        Node::Difference(a, _) => matches!(core(a), Node::Intersection(..)),
        Node::Intersection(a, b) => is_cut(a) || is_cut(b),
        _ => false,
    }
}

/// Whether all of a solid has one look and one index.
fn is_uniform(facts: &[Material], node: NodeId) -> bool {
    let f = &facts[node as usize];
    f.texture.uniform && f.optics.uniform && f.index.uniform
}

/// Whether two solids have the same one look and index.
fn has_one_look(facts: &[Material], a: NodeId, b: NodeId) -> bool {
    let [f, g] = [a, b].map(|node| &facts[node as usize]);
    let alike = f.texture == g.texture && f.optics == g.optics && f.index == g.index;
    is_uniform(facts, a) && alike
}

struct Order {
    out: Rewrite,
    /// For each node, those that were added, too.
    boxes: Vec<Aabb>,
}

impl Order {
    /// Boxes for the nodes that were added.
    fn bound(&mut self) {
        let scene = &self.out.scene;
        for node in &scene.nodes[self.boxes.len()..] {
            let of = |id: NodeId| self.boxes[id as usize];
            self.boxes.push(match *node {
                Node::Union(a, b) => of(a).hull(&of(b)),
                Node::Intersection(a, b) => of(a).intersection(&of(b)),
                Node::Difference(a, _) => of(a),
                Node::Transform { child, matrix } => {
                    of(child).transformed(&scene.matrices[matrix as usize])
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => of(child),
                Node::Complement(_) | Node::Shape(_) => Aabb::ALL,
            });
        }
    }

    /// (A ∩ B) − C as (A − C) ∩ B.
    fn cut_first(&mut self, node: NodeId, base: NodeId, tool: NodeId) -> Option<NodeId> {
        let (way, core) = below(&self.out.scene, base);
        let Node::Intersection(a, b) = self.out.scene.nodes[core as usize] else {
            return None;
        };
        let [a, b] = [a, b].map(|operand| self.out.done(&way, operand));
        let cut = self.out.push(Node::Difference(a, tool), node);
        Some(self.out.push(Node::Intersection(cut, b), node))
    }

    /// (A − C) ∩ B, or B ∩ (A − C), as (A ∩ B) − C, if that ends flush with B.
    fn cut_last(
        &mut self,
        node: NodeId,
        cut: NodeId,
        other: NodeId,
        cut_is_first: bool,
    ) -> Option<NodeId> {
        let mut tools: Vec<(Way, NodeId)> = Vec::new();
        let (mut way, mut base) = below(&self.out.scene, cut);
        while let Node::Difference(a, tool) = self.out.scene.nodes[base as usize]
            && tools.len() < FEW
        {
            tools.push((way.clone(), tool));
            let (more, next) = below(&self.out.scene, a);
            way.extend(more);
            base = next;
        }
        let around = self.boxes[other as usize];
        if !tools
            .iter()
            .any(|(way, tool)| self.is_flush(way, *tool, &around))
        {
            return None;
        }
        let base = self.out.done(&way, base);
        let (a, b) = match cut_is_first {
            true => (base, other),
            false => (other, base),
        };
        let mut all = self.out.push(Node::Intersection(a, b), node);
        for (way, tool) in tools.iter().rev() {
            let tool = self.out.done(way, *tool);
            all = self.out.push(Node::Difference(all, tool), node);
        }
        Some(all)
    }

    /// Whether the box of a tool ends where another one does.
    fn is_flush(&self, way: &[NodeId], tool: NodeId, other: &Aabb) -> bool {
        let scene = &self.out.scene;
        let mut own = self.boxes[tool as usize];
        for step in way.iter().rev() {
            if let Node::Transform { matrix, .. } = scene.nodes[*step as usize] {
                own = own.transformed(&scene.matrices[matrix as usize]);
            }
        }
        let near = |a: f64, b: f64| (a - b).abs() <= NEAR * a.abs().max(b.abs());
        let same = |i: usize| near(own.min[i], other.min[i]) || near(own.max[i], other.max[i]);
        own.overlaps(other) && (0..3).any(same)
    }
}
