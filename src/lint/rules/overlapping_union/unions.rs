//! The unions of a scene and their operands, every operand in its place.

use rustc_hash::FxHashMap;

use super::medium::{Coat, Colouring, Medium, looks};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, Scene};
use crate::solids::ancestry::{Ancestry, NONE};
use crate::solids::bounds::NodeBounds;
use crate::solids::shapes::facts::Facts;
use crate::solids::{Named, named};
use crate::trace::plan::unseen::LeftOut;

/// Most repeated visits of nodes, in scenes that share parts.
const MAX_REPEATED_NODES: usize = 200_000;

/// A part of a union that is no union itself.
pub(super) struct UnionOperand {
    pub(super) node: NodeId,
    pub(super) named: Named,
    /// The map from the operand's coordinates into those of the root.
    pub(super) matrix: Matrix,
    pub(super) bounds: Aabb,
    pub(super) medium: u32,
    pub(super) colouring: Option<Colouring>,
    pub(super) union: u32,
    /// The outermost object that the operand is a part of, if an intersection or a difference in between may cut
    /// something off; `None` otherwise.
    pub(super) cut: Option<NodeId>,
    /// Whether differences, and no intersection, may cut something off: a cut face then looks like the part it cuts
    /// through.
    pub(super) opened: bool,
}

struct Task {
    node: NodeId,
    matrix: Matrix,
    coat: Coat,
    copy: Option<u32>,
    union: u32,
    root: NodeId,
    cut: bool,
    /// Whether an intersection above may cut something off.
    clipped: bool,
}

pub(super) struct Unions {
    /// The nodes of the unions, once for each place where a union occurs. A union stands before the unions within it.
    pub(super) places: Vec<NodeId>,
    /// For each place of a union the place of the union around it.
    pub(super) ancestry: Ancestry,
    /// The operands in their order.
    pub(super) parts: Vec<UnionOperand>,
    pub(super) media: Vec<Medium>,
}

impl Unions {
    /// Collects the operands of all unions whose medium is known.
    ///
    /// Skips the operands in `left_out`: they cannot be seen, so nothing in the picture depends on them.
    pub(super) fn new(
        scene: &Scene,
        bounds: &[NodeBounds],
        roots: &[NodeId],
        left_out: &LeftOut,
    ) -> Unions {
        let mut all = Unions {
            places: Vec::new(),
            ancestry: Ancestry::default(),
            parts: Vec::new(),
            media: Vec::new(),
        };
        let mut known: FxHashMap<[u64; 12], u32> = FxHashMap::default();
        let start = |&node: &NodeId| Task {
            node,
            matrix: Matrix::IDENTITY,
            coat: Coat::default(),
            copy: None,
            union: NONE,
            root: node,
            cut: false,
            clipped: false,
        };
        let mut todo: Vec<Task> = roots.iter().rev().map(start).collect();
        let mut left = scene.nodes.len() + MAX_REPEATED_NODES;
        let mut parents = Vec::new();
        while let Some(mut task) = todo.pop() {
            match left.checked_sub(1) {
                Some(l) => left = l,
                None => break,
            }
            match scene.nodes[task.node as usize] {
                Node::Transform { child, matrix } => {
                    task.matrix = task.matrix.after(&scene.matrices[matrix as usize]);
                    task.node = child;
                    todo.push(task);
                }
                Node::Paint { child, paint } => {
                    task.coat = task.coat.over(scene, paint);
                    task.node = child;
                    todo.push(task);
                }
                Node::Copy { child, id } => {
                    task.copy = task.copy.or(Some(id));
                    task.node = child;
                    todo.push(task);
                }
                Node::Union(a, b) => {
                    let union = all.places.len() as u32;
                    all.places.push(task.node);
                    parents.push(task.union);
                    for node in left_out.kept(task.node, [a, b]).rev() {
                        let copy = None;
                        todo.push(Task {
                            node,
                            union,
                            copy,
                            ..task
                        });
                    }
                }
                Node::Shape(s) => {
                    if scene.shapes[s as usize].geometry.is_solid() {
                        all.part(scene, bounds, &task, &mut known);
                    }
                }
                operation @ (Node::Intersection(first, _) | Node::Difference(first, _)) => {
                    all.part(scene, bounds, &task, &mut known);
                    // The inside of the result is that of the first operand.
                    todo.push(Task {
                        node: first,
                        copy: None,
                        union: NONE,
                        cut: true,
                        clipped: task.clipped || matches!(operation, Node::Intersection(..)),
                        ..task
                    });
                }
                // The medium inside of a complement is not known.
                Node::Complement(_) => {}
            }
        }
        all.ancestry = Ancestry::new(&parents);
        all
    }

    fn part(
        &mut self,
        scene: &Scene,
        bounds: &[NodeBounds],
        task: &Task,
        known: &mut FxHashMap<[u64; 12], u32>,
    ) {
        if task.union == NONE {
            return;
        }
        let (medium, colouring) = looks(scene, task.node, task.coat);
        let (Some(mut named), Some(medium)) = (named(scene, task.node), medium) else {
            return;
        };
        named.id = task.copy.unwrap_or(named.id);
        let media = &mut self.media;
        let medium = *known.entry(medium.bits()).or_insert_with(|| {
            media.push(medium);
            media.len() as u32 - 1
        });
        let own = bounds[task.node as usize].all;
        let bounds = match scene.nodes[task.node as usize] {
            // The bounds of the moved shape are closer than its own box, moved.
            Node::Shape(s) => scene.shapes[s as usize].geometry.bounds(&task.matrix),
            _ => own.transformed(&task.matrix),
        };
        if !bounds.is_empty() {
            self.parts.push(UnionOperand {
                node: task.node,
                named,
                matrix: task.matrix,
                bounds,
                medium,
                colouring,
                union: task.union,
                cut: task.cut.then_some(task.root),
                opened: task.cut && !task.clipped,
            });
        }
    }
}
