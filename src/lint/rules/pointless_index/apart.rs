//! Proofs that an index changes nothing in a picture: no ray that the index could bend reaches a surface on which the
//! index counts.
//!
//! An index counts where light goes through a surface with the medium of that index on one side. Opaque solids have
//! such surfaces where transparent ones overlap or touch them: glass ends inside of a stone, and the light goes on in
//! the medium of the stone. So the proof asks for transparent shapes to lie apart from those with the index.

use crate::diagnostics::Span;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, Optics, Scene};
use crate::solids::bounds::NodeBounds;
use crate::solids::shapes::facts::Facts;
use crate::solids::within::CLEARANCE_REL;
use crate::trace::plan::unseen::Starts;

/// Most nodes visited, and most pairs of shapes compared: some hundredths of a second.
const NODES: usize = 200_000;
const PAIRS: usize = 4_000_000;

/// A shape in its place.
struct Leaf {
    bounds: Aabb,
    /// The record that gives the index of its inside.
    source: Option<Span>,
    is_solid: bool,
    /// Whether a ray may get from one side of the surface to the other.
    clear: bool,
}

#[derive(Clone, Copy)]
struct Task {
    node: NodeId,
    matrix: Matrix,
    optics: Option<Optics>,
    source: Option<Option<Span>>,
    /// Whether the node is within a complement, so that its inside may be all that is around it.
    complement: bool,
}

pub(super) struct Apart {
    leaves: Vec<Leaf>,
    /// Whether no ray starts within a solid. A ray that does sees where media meet.
    is_closed: bool,
    left: usize,
}

impl Apart {
    /// Collects the shapes below `roots`. `sources` has the span of the record for each node that sets an index. `None`
    /// if there is too much to look at.
    pub(super) fn new(
        scene: &Scene,
        bounds: &[NodeBounds],
        sources: &[Option<Span>],
        roots: &[NodeId],
    ) -> Option<Apart> {
        let leaves = leaves(scene, sources, roots)?;
        let starts = Starts::new(scene, bounds);
        let clip = scene.render.and_then(|r| r.clip);
        let clip = clip.map(|(min, max)| Aabb::new(min, max));
        let is_whole = |b: &Aabb| {
            clip.is_none_or(|clip| {
                let hair = CLEARANCE_REL * clip.far().max(b.far());
                (0..3).all(|i| clip.min[i] + hair < b.min[i] && b.max[i] + hair < clip.max[i])
            })
        };
        let is_closed = |leaf: &Leaf| {
            !leaf.is_solid || is_whole(&leaf.bounds) && starts.are_clear_of(&leaf.bounds, None)
        };
        Some(Apart {
            is_closed: leaves.iter().all(is_closed),
            leaves,
            left: PAIRS,
        })
    }

    /// Whether the index that a record gives changes nothing for certain.
    pub(super) fn is_without_effect(&mut self, source: Span) -> bool {
        let all = &self.leaves;
        let own = |leaf: &&Leaf| leaf.source == Some(source);
        for leaf in all.iter().filter(own) {
            match self.left.checked_sub(all.len()) {
                Some(left) => self.left = left,
                None => return false,
            }
            let apart = |other: &Leaf| {
                let (a, b) = (&leaf.bounds, &other.bounds);
                let hair = CLEARANCE_REL * a.far().max(b.far());
                (0..3).any(|i| a.max[i] + hair < b.min[i] || b.max[i] + hair < a.min[i])
            };
            let meets = |other: &Leaf| {
                (other.clear || !self.is_closed && other.source != leaf.source) && !apart(other)
            };
            if all.iter().any(meets) {
                return false;
            }
        }
        true
    }
}

/// All shapes in their places, without the tools of differences; `None` if there are too many.
fn leaves(scene: &Scene, sources: &[Option<Span>], roots: &[NodeId]) -> Option<Vec<Leaf>> {
    let mut out = Vec::new();
    let start = |&node: &NodeId| Task {
        node,
        matrix: Matrix::IDENTITY,
        optics: None,
        source: None,
        complement: false,
    };
    let mut todo: Vec<Task> = roots.iter().map(start).collect();
    let mut left = NODES;
    while let Some(mut task) = todo.pop() {
        left = left.checked_sub(1)?;
        let node = scene.nodes[task.node as usize];
        match node {
            Node::Shape(s) => {
                let geometry = &scene.shapes[s as usize].geometry;
                let optics = task.optics.unwrap_or_default();
                let any = |share: [f64; 3]| share.iter().any(|&k| k > 0.0);
                // A mirror may send rays through itself where its normals are not those of its surface.
                let turned = geometry.character().is_smooth && any(optics.ks);
                out.push(Leaf {
                    bounds: match task.complement {
                        true => Aabb::ALL,
                        false => geometry.bounds(&task.matrix),
                    },
                    source: task.source.flatten(),
                    is_solid: geometry.is_solid(),
                    clear: any(optics.kt) || turned,
                });
            }
            Node::Transform { matrix, .. } => {
                task.matrix = task.matrix.after(&scene.matrices[matrix as usize]);
            }
            Node::Paint { paint, .. } => {
                let paint = &scene.paints[paint as usize];
                let own = paint.index.map(|_| sources[task.node as usize]);
                task.optics = task.optics.or(paint.optics);
                task.source = task.source.or(own);
            }
            Node::Complement(_) => task.complement = true,
            // Nothing is seen of the tool of a difference.
            Node::Difference(first, _) => {
                todo.push(Task {
                    node: first,
                    ..task
                });
                continue;
            }
            Node::Copy { .. } | Node::Union(..) | Node::Intersection(..) => {}
        }
        todo.extend(node.children().map(|node| Task { node, ..task }));
    }
    Some(out)
}
