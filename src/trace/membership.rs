//! The solids that a point is in.
//!
//! The walk asks every occurrence of a node in the node's own space, operands before operations. It skips an occurrence
//! if the point is outside of a box around all solids below the node. The answer of a shared node for a point is kept,
//! so it is computed once.

use super::graph::outermost;
use crate::diagnostics::{Complaint, Error};
use crate::geometry::array::each;
use crate::geometry::sign::{Exact, Scalar};
use crate::geometry::vec::Vec3;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Node, NodeId, Scene, fold_up};
use crate::solids::bounds::{NodeBounds, node_bounds};
use crate::solids::containment::in_shape;
use dashu_float::Context;
use dashu_float::round::mode::HalfEven;
use std::array;
use std::collections::{BTreeSet, HashMap};

/// The most steps of a walk, besides a few for every node of the scene. A walk needs more only if the point is in the
/// bounds of millions of occurrences of shared objects.
const STEPS_MAX: usize = 1 << 22;

/// The solids that hold a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Membership {
    /// IDs, ascending, of the shapes and operations at the root and below it that hold the point in any occurrence.
    pub inside: BTreeSet<u32>,
    /// Whether the root itself holds the point.
    pub in_root: bool,
}

/// Finds the solids at `root` and below it that hold a point.
///
/// Shapes are closed: a shape holds the points of its boundary. Operations are those of sets, so neither the complement
/// of the shape nor a solid that the shape is taken away from holds these points. Surfaces without inside hold nothing.
/// An occurrence of a copy is listed by the copy's ID and not by that of its original; the operands are listed for
/// both.
///
/// # Errors
///
/// A transformation has no inverse or takes the point out of range, or too many occurrences would have to be asked.
pub fn members(scene: &Scene, root: NodeId, point: Vec3) -> Result<Membership, Error> {
    let mut walk = Walk {
        scene,
        reach: reaches(scene, root),
        ids: operation_ids(scene),
        inverses: HashMap::new(),
        answers: HashMap::new(),
        values: Vec::new(),
        tasks: Vec::new(),
        inside: BTreeSet::new(),
    };
    let in_root = walk.run(root, point)?;
    Ok(Membership {
        inside: walk.inside,
        in_root,
    })
}

/// For each node up to `root`: a box that holds every solid at and below it.
fn reaches(scene: &Scene, root: NodeId) -> Vec<Aabb> {
    let own: Vec<NodeBounds> = node_bounds(scene);
    // The flag says whether all operations below a node are unions. Then the node's own bounds hold all solids below
    // it, and they are tighter.
    let reach = fold_up(scene.up_to(root), |id, node, reach: &[(Aabb, bool)]| {
        let own = &own[id as usize];
        let of = |n: NodeId| reach[n as usize].0;
        let simple = |n: NodeId| reach[n as usize].1;
        match node {
            Node::Shape(_) => (own.all, true),
            Node::Union(a, b) => (of(a).hull(&of(b)), simple(a) && simple(b)),
            Node::Intersection(a, b) | Node::Difference(a, b) => (of(a).hull(&of(b)), false),
            Node::Complement(_) => (Aabb::ALL, false),
            Node::Transform { child, .. } if simple(child) => (own.all, true),
            Node::Transform { child, matrix } => (
                of(child).transformed(&scene.matrices[matrix as usize]),
                false,
            ),
            Node::Paint { child, .. } | Node::Copy { child, .. } => reach[child as usize],
        }
    });
    reach.into_iter().map(|(all, _)| all).collect()
}

/// The ID of each operation, by its node. The node is the one that the entity's own record made, below the nodes that
/// later records put above it; no other entity has that node.
fn operation_ids(scene: &Scene) -> HashMap<NodeId, u32> {
    let mut ids = HashMap::new();
    for entity in &scene.entities {
        let Some(node) = entity.node().map(|n| scene.defined(n)) else {
            continue;
        };
        // The nodes of copies and shapes have their IDs with them.
        if !matches!(
            scene.nodes[node as usize],
            Node::Copy { .. } | Node::Shape(_)
        ) {
            ids.insert(node, entity.id);
        }
    }
    ids
}

/// A node, the ID that it is listed by, and the bits of a point in the node's space.
type Question = (NodeId, u32, [u64; 3]);

enum Task {
    Ask(NodeId, Vec3),
    /// Computes the answer of an operation from the answers of its operands.
    Combine {
        core: NodeId,
        id: u32,
        question: Question,
    },
}

struct Walk<'a> {
    scene: &'a Scene,
    reach: Vec<Aabb>,
    ids: HashMap<NodeId, u32>,
    inverses: HashMap<u32, Inverse>,
    answers: HashMap<Question, bool>,
    values: Vec<bool>,
    tasks: Vec<Task>,
    inside: BTreeSet<u32>,
}

impl Walk<'_> {
    fn run(&mut self, root: NodeId, point: Vec3) -> Result<bool, Error> {
        let limit = STEPS_MAX + 4 * self.scene.nodes.len();
        let mut steps = 0;
        self.tasks.push(Task::Ask(root, point));
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Ask(node, point) => self.ask(node, point)?,
                Task::Combine { core, id, question } => self.combine(core, id, question),
            }
            steps += 1;
            if steps > limit {
                return Err(self.refusal("too-many-occurrences"));
            }
        }
        Ok(self.values.pop().unwrap_or(false))
    }

    /// Goes down from a node to the shape or operation that it is a state of. Answers for a shape at once. Has the
    /// operands of an operation asked, unless its answer is known.
    fn ask(&mut self, node: NodeId, point: Vec3) -> Result<(), Error> {
        let scene = self.scene;
        let (mut node, mut point, mut copy) = (node, point, 0);
        loop {
            if !self.reach[node as usize].contains(point.0) {
                self.values.push(false);
                return Ok(());
            }
            node = match scene.nodes[node as usize] {
                Node::Paint { child, .. } => child,
                Node::Copy { child, id } => {
                    copy = outermost(copy, id);
                    child
                }
                Node::Transform { child, matrix } => {
                    point = self.back(matrix, point)?;
                    child
                }
                Node::Shape(shape) => {
                    let id = outermost(copy, scene.shapes[shape as usize].id);
                    let holds = self.shape_holds(shape, point);
                    self.answer(id, holds);
                    return Ok(());
                }
                _ => break,
            };
        }
        let own = self.ids.get(&node).copied().unwrap_or(0);
        let id = outermost(copy, own);
        // Adding 0 turns −0 into 0: zeros of both signs are one place.
        let question = (node, id, each(point.0, |x| (x + 0.0).to_bits()));
        if let Some(&known) = self.answers.get(&question) {
            self.values.push(known);
            return Ok(());
        }
        self.tasks.push(Task::Combine {
            core: node,
            id,
            question,
        });
        match scene.nodes[node as usize] {
            Node::Union(a, b) | Node::Intersection(a, b) | Node::Difference(a, b) => {
                self.tasks
                    .extend([Task::Ask(b, point), Task::Ask(a, point)]);
            }
            Node::Complement(child) => self.tasks.push(Task::Ask(child, point)),
            _ => {}
        }
        Ok(())
    }

    fn combine(&mut self, core: NodeId, id: u32, question: Question) {
        let mut next = || self.values.pop().unwrap_or(false);
        // The last operand's answer is on top.
        let holds = match self.scene.nodes[core as usize] {
            Node::Union(..) => next() | next(),
            Node::Intersection(..) => next() & next(),
            Node::Difference(..) => {
                let (b, a) = (next(), next());
                a && !b
            }
            Node::Complement(_) => !next(),
            _ => false,
        };
        self.answers.insert(question, holds);
        self.answer(id, holds);
    }

    fn answer(&mut self, id: u32, holds: bool) {
        if holds && id != 0 {
            self.inside.insert(id);
        }
        self.values.push(holds);
    }

    /// Takes a point from the space above a transformation into the space below it.
    fn back(&mut self, matrix: u32, point: Vec3) -> Result<Vec3, Error> {
        let matrices = &self.scene.matrices;
        let inverse = (self.inverses.entry(matrix))
            .or_insert_with(|| Inverse::of(&matrices[matrix as usize]));
        let singular = inverse.determinant == Exact::ZERO;
        let reason = if singular {
            "no-inverse"
        } else {
            "point-out-of-range"
        };
        inverse.image(point).ok_or_else(|| self.refusal(reason))
    }

    /// Whether a shape holds a point, given in the shape's space, or has it on its boundary.
    fn shape_holds(&self, shape: u32, point: Vec3) -> bool {
        let record = &self.scene.shapes[shape as usize];
        in_shape(&record.geometry, point.0)
    }

    fn refusal(&self, reason: &'static str) -> Error {
        let span = self.scene.render.map(|r| r.span).unwrap_or_default();
        Error::at(span, Complaint::new(reason))
    }
}

/// The inverse of an affine map, exactly: the adjugate of its linear part over the determinant.
struct Inverse {
    adjugate: [[Exact; 3]; 3],
    determinant: Exact,
    offset: [Exact; 3],
}

impl Inverse {
    fn of(m: &Matrix) -> Inverse {
        let at = |i: usize, j: usize| Exact::of(m.0[i % 3][j % 3]);
        let cofactor = |i: usize, j: usize| {
            at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1)
        };
        let adjugate = array::from_fn(|i| array::from_fn(|j| cofactor(j, i)));
        let first: &[Exact; 3] = &adjugate[0];
        let terms = (0..3).map(|j| first[j].clone() * at(j, 0));
        Inverse {
            determinant: terms.fold(Exact::ZERO, |sum, term| sum + term),
            adjugate,
            offset: array::from_fn(|i| Exact::of(m.0[i][3])),
        }
    }

    /// The image of a point under the inverse map, rounded once; `None` if there is no inverse or the image is out of
    /// range.
    fn image(&self, point: Vec3) -> Option<Vec3> {
        const DIGITS: usize = f64::MANTISSA_DIGITS as usize;
        if self.determinant == Exact::ZERO {
            return None;
        }
        let from: [Exact; 3] = array::from_fn(|i| Exact::of(point[i]) - self.offset[i].clone());
        let quotient = |row: &[Exact; 3]| {
            let terms = row.iter().zip(&from).map(|(a, b)| a * b);
            let sum = terms.fold(Exact::ZERO, |sum, term| sum + term);
            let by = self.determinant.repr();
            let rounded = Context::<HalfEven>::new(DIGITS).div(sum.repr(), by);
            rounded.map_or(f64::NAN, |x| x.value().to_f64().value())
        };
        let image = Vec3(self.adjugate.each_ref().map(quotient));
        image.is_finite().then_some(image)
    }
}
