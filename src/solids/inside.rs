//! Whether a point is in an object, within a budget of steps. A shape decides exactly about the point in its own
//! coordinates. The matrices round that point, for which the caller has to leave room.

use super::tree::{both, either};
use crate::geometry::Matrix;
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3};
use crate::solids::bounds::NodeBounds;
use crate::solids::containment::in_shape;

/// The most steps of all tests together: nodes visited and profile points compared. A second has room for many times as
/// many.
const STEPS: usize = 5_000_000;

/// Tells which points are in the objects of one scene, as long as the steps last.
pub struct Inside<'a> {
    scene: &'a Scene,
    bounds: &'a [NodeBounds],
    /// Inverses of the scene's matrices, made when they are first needed.
    inverses: Vec<Option<Matrix>>,
    left: usize,
    /// Buffers of [`node`](Self::node), kept from one point to the next.
    tasks: Vec<Task>,
    answers: Vec<Option<bool>>,
}

enum Task {
    Ask(NodeId, Vec3),
    /// Negates the last answer.
    Not,
    /// Asks the first operand, unless the answer of the second one settles the operation.
    First(NodeId, Vec3),
    /// Joins the answer of the first operand with the answer of the second, which is given.
    Join(NodeId, Option<bool>),
}

impl<'a> Inside<'a> {
    pub fn new(scene: &'a Scene, bounds: &'a [NodeBounds]) -> Inside<'a> {
        Inside {
            scene,
            bounds,
            inverses: vec![None; scene.matrices.len()],
            left: STEPS,
            tasks: Vec::new(),
            answers: Vec::new(),
        }
    }

    /// Whether a point, in the node's coordinates, is in the node. `None` if this is not known, or no steps are left.
    pub fn node(&mut self, node: NodeId, p: Vec3) -> Option<bool> {
        self.tasks.clear();
        self.answers.clear();
        self.tasks.push(Task::Ask(node, p));
        while let Some(task) = self.tasks.pop() {
            self.left = self.left.checked_sub(1)?;
            match task {
                Task::Ask(node, p) => self.ask(node, p)?,
                Task::Not => {
                    let answer = self.answers.pop()?;
                    self.answers.push(answer.map(|x| !x));
                }
                Task::First(node, p) => {
                    let second = self.answers.pop()?;
                    match (self.scene.nodes[node as usize], second) {
                        (Node::Union(..), Some(true)) => self.answers.push(Some(true)),
                        (Node::Intersection(..), Some(false))
                        | (Node::Difference(..), Some(true)) => self.answers.push(Some(false)),
                        (operation, _) => {
                            self.tasks.push(Task::Join(node, second));
                            self.tasks.push(Task::Ask(operation.children().next()?, p));
                        }
                    }
                }
                Task::Join(node, second) => {
                    let first = self.answers.pop()?;
                    let joined = match self.scene.nodes[node as usize] {
                        Node::Union(..) => either(first, second),
                        Node::Intersection(..) => both(first, second),
                        _ => both(first, second.map(|x| !x)),
                    };
                    self.answers.push(joined);
                }
            }
        }
        self.answers.pop()?
    }

    fn ask(&mut self, node: NodeId, p: Vec3) -> Option<()> {
        if !self.bounds[node as usize].all.contains(p) {
            self.answers.push(Some(false));
            return Some(());
        }
        match self.scene.nodes[node as usize] {
            Node::Shape(s) => {
                let geometry = &self.scene.shapes[s as usize].geometry;
                let answer = self.shape(geometry, p);
                self.answers.push(answer);
            }
            Node::Transform { child, matrix } => {
                let known = &mut self.inverses[matrix as usize];
                if known.is_none() {
                    *known = self.scene.matrices[matrix as usize].inverse();
                }
                self.tasks.push(Task::Ask(child, (*known)?.point(p)));
            }
            Node::Paint { child, .. } | Node::Copy { child, .. } => {
                self.tasks.push(Task::Ask(child, p));
            }
            Node::Complement(child) => {
                self.tasks.push(Task::Not);
                self.tasks.push(Task::Ask(child, p));
            }
            // The second operand is asked first: chains grow by second operands, which are mostly the smaller ones.
            Node::Union(_, second)
            | Node::Intersection(_, second)
            | Node::Difference(_, second) => {
                self.tasks.push(Task::First(node, p));
                self.tasks.push(Task::Ask(second, p));
            }
        }
        Some(())
    }

    /// Whether a point, in the shape's coordinates, is in the shape. `None` if too few steps are left.
    pub fn shape(&mut self, geometry: &Geometry, p: Vec3) -> Option<bool> {
        self.left = self.left.checked_sub(geometry.pieces())?;
        Some(in_shape(geometry, p))
    }
}
