//! The search for faces that lie in one another, in time that hardly grows faster than the scene.
//!
//! From each difference or intersection the search goes down to the child that is made of more
//! shapes, as far as there is one. On the way back up it knows the faces of everything below, by
//! the planes they lie in; the smaller child of each operation is looked up among them and added.
//! So a face is added once for each time that what it belongs to at least doubles.

use std::collections::BTreeSet;

use super::face::{Face, Form, Leaf, Part, faces};
use super::inside::Inside;
use super::sample::{self, Sample};
use super::vector::{add, dot};
use crate::scene::bounds::NodeBounds;
use crate::scene::{Aabb, Matrix, Node, NodeId, Scene, Vec3};

/// How near two faces must be, as a share of the smaller shape: the language's own bound.
pub const NEAR: f64 = 1e-9;

/// Rounding of a point's coordinates on the way through two matrices, as a share of their size.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Nodes visited and faces compared, in all and on the way down from one operation. Scenes that share
/// parts without end would take longer: what is not looked at is not spoken of.
const STEPS: usize = 4_000_000;
const CHAIN_STEPS: usize = 2_000_000;

/// What a trial of two faces at all their samples costs, in steps.
const SAMPLES_COST: usize = 128;

/// One of two faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// The shape's own node.
    pub node: NodeId,
    /// Index into the scene's shapes.
    pub shape: u32,
    pub part: Part,
    /// The longest side of the shape's bounds, in the coordinates of the operation.
    pub size: f64,
    /// How much longer its lengths are there than in its record, on the average.
    pub stretch: f64,
    /// Whether it cuts: what is in the shape is not in the result.
    pub cuts: bool,
}

#[derive(Debug, Clone, Copy)]
pub struct Found {
    /// The difference or intersection.
    pub operation: NodeId,
    /// One from each operand.
    pub sides: [Side; 2],
    /// A point of both, in the coordinates of the operation.
    pub witness: Vec3,
}

/// All pairs of faces that lie in one another so that what is left of the two is up to rounding.
pub fn search(scene: &Scene, bounds: &[NodeBounds], live: &[bool]) -> Vec<Found> {
    let mut search = Search {
        scene,
        inside: Inside::new(scene, bounds),
        weights: weights(scene),
        left: 0,
        found: Vec::new(),
    };
    let mut done = vec![false; scene.nodes.len()];
    let mut steps = STEPS;
    for top in (0..scene.nodes.len()).rev() {
        let cuts = matches!(
            scene.nodes[top],
            Node::Difference(..) | Node::Intersection(..)
        );
        if cuts && live[top] && !done[top] {
            let allowed = steps.min(CHAIN_STEPS);
            search.left = allowed;
            // A chain that is too long is left where it is; the others have their turn.
            let _ = search.chain(top as NodeId, &mut done);
            steps -= allowed - search.left;
        }
        if steps == 0 {
            break;
        }
    }
    search.found
}

/// Of how many shapes each node is made, shared ones counted as often as they occur.
fn weights(scene: &Scene) -> Vec<u32> {
    let mut out: Vec<u32> = Vec::with_capacity(scene.nodes.len());
    for node in &scene.nodes {
        let children = node.children().into_iter().flatten();
        let sum = children.fold(0u32, |w, c| w.saturating_add(out[c as usize]));
        out.push(sum.max(1));
    }
    out
}

struct Search<'a> {
    scene: &'a Scene,
    inside: Inside<'a>,
    weights: Vec<u32>,
    left: usize,
    found: Vec<Found>,
}

/// Faces of what a chain is made of so far.
#[derive(Default)]
struct Known {
    leaves: Vec<Leaf>,
    /// Each with whether it is turned round, before `turned` is counted in.
    faces: Vec<(Face, bool)>,
    /// Whether everything so far has been turned round.
    turned: bool,
    /// By the direction of the outward normal and the distance of the plane, or by class and place.
    index: BTreeSet<(Cell, i64, u32)>,
    /// The largest size of a finite leaf.
    largest: f64,
}

type Cell = [i32; 3];

/// A unit vector's components in steps of a ten-thousandth.
const CELLS: f64 = 1e4;

/// A direction that no scene is built along, to tell places apart by one number.
const ODD: Vec3 = [0.612_372, 0.288_675, 0.736_203];

/// Doubles as integers of the same order.
fn order(x: f64) -> i64 {
    let bits = (x + 0.0).to_bits() as i64;
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// Where a face is filed: its cell and a number that differs little for faces that differ little.
fn key(form: &Form, turned: bool) -> (Cell, f64, f64) {
    match form {
        Form::Flat { normal, point, .. } => {
            let n = if turned { normal.map(|x| -x) } else { *normal };
            let cell = n.map(|x| (x * CELLS).round() as i32);
            let size = point.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            (cell, dot(n, *point), size)
        }
        Form::Round {
            anchor,
            scale,
            class,
        } => {
            let size = anchor.iter().fold(scale.abs(), |m, x| m.max(x.abs()));
            let at = dot(ODD, *anchor) + std::f64::consts::SQRT_2 * scale;
            ([i32::MAX, i32::from(*class), 0], at, size)
        }
    }
}

/// All cells in which a neighbour of this one's face can be.
fn cells(form: &Form, turned: bool, cell: Cell) -> Vec<Cell> {
    let Form::Flat { normal, .. } = form else {
        return vec![cell];
    };
    let sign = if turned { -1.0 } else { 1.0 };
    let mut out = vec![cell];
    for i in 0..3 {
        let x = normal[i] * sign * CELLS;
        // Within a hundredth of a step of the border, neighbours may be on its other side.
        let other = [x - 0.01, x + 0.01].map(|x| x.round() as i32);
        if let Some(&o) = other.iter().find(|&&o| o != cell[i]) {
            for k in 0..out.len() {
                let mut c = out[k];
                c[i] = o;
                out.push(c);
            }
        }
    }
    out
}

impl Known {
    fn take(&mut self, faces: &mut Vec<(Face, bool)>) {
        for (face, turned) in faces.drain(..) {
            self.add(face, turned);
        }
    }

    fn add(&mut self, face: Face, turned: bool) {
        let turned = turned != self.turned;
        let (cell, at, _) = key(&face.form, turned);
        let number = self.faces.len() as u32;
        self.index.insert((cell, order(at), number));
        self.faces.push((face, turned));
    }

    /// Faces that look the other way in the plane of a face with these sides, and equal round ones.
    fn against(&self, face: &Face, turned: bool, size: f64) -> Vec<u32> {
        // Filed under `self.turned`, and for flat ones the normal is the opposite one.
        let as_filed = (turned != self.turned) != matches!(face.form, Form::Flat { .. });
        let (cell, at, magnitude) = key(&face.form, as_filed);
        let size = if size.is_finite() { size } else { self.largest };
        let reach = 2.0 * NEAR * size + ROUNDING * magnitude;
        let mut out = Vec::new();
        let (low, high) = (at - reach, at + reach);
        if low.is_nan() || high.is_nan() {
            // Beyond the numbers nothing is in one place.
            return out;
        }
        for cell in cells(&face.form, as_filed, cell) {
            let range = (cell, order(low), 0)..=(cell, order(high), u32::MAX);
            out.extend(self.index.range(range).map(|e| e.2));
        }
        out
    }
}

/// A node on the way down, and from its coordinates into those of the search.
struct Step {
    node: NodeId,
    matrix: Matrix,
}

impl Search<'_> {
    fn spend(&mut self, steps: usize) -> Option<()> {
        let left = self.left.checked_sub(steps);
        self.left = left.unwrap_or(0);
        left.map(|_| ())
    }

    /// Looks at all operations on the way from this one down; `None` when no steps are left.
    fn chain(&mut self, top: NodeId, done: &mut [bool]) -> Option<()> {
        let mut steps = vec![Step {
            node: top,
            matrix: Matrix::IDENTITY,
        }];
        loop {
            self.spend(1)?;
            let Step { node, matrix } = steps[steps.len() - 1];
            let node = self.scene.nodes[node as usize];
            let matrix = match node {
                Node::Transform { matrix: m, .. } => matrix.after(&self.scene.matrices[m as usize]),
                _ => matrix,
            };
            match self.heavy(node) {
                Some((heavy, _)) => steps.push(Step {
                    node: heavy,
                    matrix,
                }),
                None => break,
            }
        }
        let mut known = Known::default();
        let bottom = steps.pop()?;
        let mut new = Vec::new();
        self.collect(&bottom, false, &mut known, &mut new)?;
        known.take(&mut new);
        while let Some(Step { node: id, matrix }) = steps.pop() {
            let node = self.scene.nodes[id as usize];
            let Some((heavy, Some(light))) = self.heavy(node) else {
                known.turned ^= matches!(node, Node::Complement(_));
                continue;
            };
            let mut turned = false;
            if let Node::Difference(first, _) = node {
                turned = heavy == first;
                known.turned ^= !turned;
            }
            let side = Step {
                node: light,
                matrix,
            };
            self.collect(&side, turned, &mut known, &mut new)?;
            let cuts = !matches!(node, Node::Union(..));
            if cuts && !std::mem::replace(&mut done[id as usize], true) {
                self.compare(id, &matrix, &known, &new)?;
            }
            // At the top nobody asks any more.
            match steps.is_empty() {
                true => new.clear(),
                false => known.take(&mut new),
            }
        }
        Some(())
    }

    /// The child that is made of more shapes, and the other one.
    fn heavy(&self, node: Node) -> Option<(NodeId, Option<NodeId>)> {
        let weight = |n: NodeId| self.weights[n as usize];
        match node.children() {
            [Some(a), Some(b)] if weight(a) >= weight(b) => Some((a, Some(b))),
            [Some(a), Some(b)] => Some((b, Some(a))),
            [Some(a), None] => Some((a, None)),
            _ => None,
        }
    }

    /// Collects the faces of all shapes of a node; the shapes are added to those of the chain.
    fn collect(
        &mut self,
        top: &Step,
        turned: bool,
        known: &mut Known,
        out: &mut Vec<(Face, bool)>,
    ) -> Option<()> {
        let mut todo = vec![(top.node, top.matrix, turned)];
        let mut new = Vec::new();
        while let Some((id, matrix, turned)) = todo.pop() {
            self.spend(1)?;
            match self.scene.nodes[id as usize] {
                Node::Shape(shape) => {
                    let leaf = Leaf::new(self.scene, id, shape, matrix);
                    if leaf.size.is_finite() {
                        known.largest = known.largest.max(leaf.size);
                    }
                    let geometry = &self.scene.shapes[shape as usize].geometry;
                    faces(geometry, known.leaves.len() as u32, &matrix, &mut new);
                    self.spend(new.len())?;
                    known.leaves.push(leaf);
                    out.extend(new.drain(..).map(|face| (face, turned)));
                }
                Node::Transform { child, matrix: m } => {
                    let m = &self.scene.matrices[m as usize];
                    todo.push((child, matrix.after(m), turned));
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => {
                    todo.push((child, matrix, turned));
                }
                Node::Complement(child) => todo.push((child, matrix, !turned)),
                Node::Union(a, b) | Node::Intersection(a, b) => {
                    todo.extend([(b, matrix, turned), (a, matrix, turned)]);
                }
                Node::Difference(a, b) => {
                    todo.extend([(b, matrix, !turned), (a, matrix, turned)]);
                }
            }
        }
        Some(())
    }

    /// Looks up the faces of the smaller operand among those of the larger one.
    fn compare(
        &mut self,
        operation: NodeId,
        matrix: &Matrix,
        known: &Known,
        new: &[(Face, bool)],
    ) -> Option<()> {
        let leaves = &known.leaves;
        let back = matrix.inverse()?;
        for (face, turned) in new {
            let leaf = &leaves[face.leaf as usize];
            let mut partners = known.against(face, *turned, leaf.size);
            // The earliest is mostly the workpiece.
            partners.sort_unstable();
            self.spend(partners.len())?;
            for partner in partners {
                let (other, other_turned) = &known.faces[partner as usize];
                let other_leaf = &leaves[other.leaf as usize];
                let pair = Pair {
                    operation,
                    back: &back,
                    faces: [face, other],
                    leaves: [leaf, other_leaf],
                };
                if self.identical(&pair) || !touch(&pair) {
                    continue;
                }
                self.spend(SAMPLES_COST)?;
                if let Some(witness) = self.witness(&pair) {
                    let side = |f: &Face, l: &Leaf, cuts: bool| {
                        let stretch = l.matrix.determinant3().abs().cbrt();
                        let out = back.determinant3().abs().cbrt();
                        Side {
                            node: l.node,
                            shape: l.shape,
                            part: f.part,
                            size: l.size * out,
                            stretch: stretch * out,
                            cuts,
                        }
                    };
                    self.found.push(Found {
                        operation,
                        sides: [
                            side(face, leaf, *turned),
                            side(other, other_leaf, *other_turned != known.turned),
                        ],
                        witness: back.point(witness),
                    });
                    break;
                }
            }
        }
        Some(())
    }

    /// Equal shapes in equal places: their surfaces are one, and decided exactly.
    fn identical(&self, pair: &Pair) -> bool {
        let [a, b] = pair.leaves;
        let geometry = |l: &Leaf| &self.scene.shapes[l.shape as usize].geometry;
        a.matrix == b.matrix && geometry(a) == geometry(b)
    }

    /// A point at which both operands change sides, one into the result and one out of it, within
    /// the distance that counts as none.
    fn witness(&mut self, pair: &Pair) -> Option<Vec3> {
        let size = pair.size();
        let scene = self.scene;
        let geometry = |l: &Leaf| &scene.shapes[l.shape as usize].geometry;
        let [f, g] = pair.faces;
        let [l, k] = pair.leaves;
        let (samples, needed): (Vec<Sample>, usize) = match f.form {
            Form::Flat { .. } => (sample::flat(f, g, size), 1),
            // Round surfaces can touch in a point or a line; two odd points are no chance.
            Form::Round { .. } => (sample::round((f, l, geometry(l)), (g, k, geometry(k))), 2),
        };
        let mut met = 0;
        for (p, n) in samples {
            if self.meets(pair, p, n, size) {
                met += 1;
                if met >= needed {
                    return Some(p);
                }
            }
        }
        None
    }

    fn meets(&mut self, pair: &Pair, p: Vec3, n: Vec3, size: f64) -> bool {
        let magnitude = p.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let reach = NEAR * if size.is_finite() { size } else { magnitude };
        let reach = reach + ROUNDING * magnitude;
        let sides = [add(p, n, -reach), add(p, n, reach)];
        // Both shapes first: that is quick.
        for leaf in pair.leaves {
            if !leaf
                .bounds
                .overlaps(&Aabb::new(sides[0], sides[0]).hull(&Aabb::new(sides[1], sides[1])))
            {
                return false;
            }
            let Some(back) = leaf.matrix.inverse() else {
                return false;
            };
            let geometry = &self.scene.shapes[leaf.shape as usize].geometry;
            let [below, above] = sides.map(|q| self.inside.shape(geometry, back.point(q)));
            if below.is_none() || above.is_none() || below == above {
                return false;
            }
        }
        let (node, [a, b]) = (
            self.scene.nodes[pair.operation as usize],
            self.scene.nodes[pair.operation as usize].children(),
        );
        let (Some(a), Some(b)) = (a, b) else {
            return false;
        };
        let [p, q] = sides.map(|q| pair.back.point(q));
        let mut ask = |operand: NodeId, turned: bool| -> Option<[bool; 2]> {
            let below = self.inside.node(operand, p)?;
            let above = self.inside.node(operand, q)?;
            Some([below != turned, above != turned])
        };
        let difference = matches!(node, Node::Difference(..));
        match (ask(a, false), ask(b, difference)) {
            (Some(x), Some(y)) => x[0] != x[1] && y[0] != y[1] && x[0] != y[0],
            _ => false,
        }
    }
}

/// Two faces to be compared, one from each operand.
struct Pair<'a> {
    operation: NodeId,
    /// From the coordinates of the search into the operation's.
    back: &'a Matrix,
    faces: [&'a Face; 2],
    leaves: [&'a Leaf; 2],
}

impl Pair<'_> {
    /// The smaller shape's size; infinite where neither has an end.
    fn size(&self) -> f64 {
        self.leaves[0].size.min(self.leaves[1].size)
    }
}

/// Whether the outlines of two faces can overlap.
fn touch(pair: &Pair) -> bool {
    let around = |f: &Face| match &f.form {
        Form::Flat { corners, .. } if !corners.is_empty() => {
            let points = corners.iter().map(|&p| Aabb::new(p, p));
            points.fold(Aabb::EMPTY, |b, p| b.hull(&p))
        }
        _ => Aabb::ALL,
    };
    let size = pair.size();
    let room = if size.is_finite() { NEAR * size } else { 0.0 };
    let mut a = around(pair.faces[0]);
    a.min = a.min.map(|x| x - room - ROUNDING * x.abs());
    a.max = a.max.map(|x| x + room + ROUNDING * x.abs());
    a.overlaps(&around(pair.faces[1])) && pair.leaves[0].bounds.overlaps(&pair.leaves[1].bounds)
}
