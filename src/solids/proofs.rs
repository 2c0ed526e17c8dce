//! Proofs that two solids have nothing in common, or that one holds all of the other: by boxes, balls, half-spaces,
//! planes between them, and equality.

use super::distance;
use super::extent::ball;
use super::support::extent;
use crate::geometry::array::{cross, length, unit};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3, fold_up};
use crate::solids::bounds::NodeBounds;
use crate::solids::within::{CLEARANCE_REL, PlacedShape, far};

/// The most literals that a list keeps. The first ones are kept, since a chain begins with the object that is cut.
pub const KEPT: usize = 4;

/// The most parts of a union that are looked at, as long as the budget [`Proofs::left`] lasts; then no more than
/// [`KEPT`].
const PARTS: usize = 64;

/// The budget of parts in unions of more than [`KEPT`], for all proofs together: some hundredths of a second.
const MORE: usize = 100_000;

/// The most pairs of parts of two unions that are compared, for all proofs together: some hundredths of a second.
const PAIRS: usize = 100_000;

/// A node in the coordinates of the operation; with `true`, the complement of the node.
pub type Literal = (NodeId, bool);

/// A few literals that must all hold: the first [`KEPT`] if there are more.
#[derive(Debug, Clone, Copy)]
pub struct Literals {
    all: [Literal; KEPT],
    count: usize,
}

impl Literals {
    pub fn new(first: Literal) -> Literals {
        Literals {
            all: [first; KEPT],
            count: 1,
        }
    }

    pub fn extend(&mut self, more: &[Literal]) {
        for &literal in more.iter().take(KEPT - self.count) {
            self.all[self.count] = literal;
            self.count += 1;
        }
    }
}

impl std::ops::Deref for Literals {
    type Target = [Literal];

    fn deref(&self) -> &[Literal] {
        &self.all[..self.count]
    }
}

/// The reason why an operation is empty.
pub enum Reason {
    /// The first ends before the second begins, along an axis.
    Apart {
        axis: usize,
        end: f64,
        begin: f64,
    },
    /// Two balls are further from each other than their radii.
    Balls {
        between: f64,
        radii: f64,
    },
    /// The first is outside of the second, a half-space.
    Beyond,
    /// A plane lies between them. The dot product with the unit vector `normal` is at most `end` in the first and at
    /// least `begin` in the second.
    Plane {
        normal: Vec3,
        end: f64,
        begin: f64,
    },
    /// Each part of the second, a union, is apart from the first, or from all its parts.
    Parts,
    /// The first is within the second, which is taken away.
    Within,
    Same,
}

/// Proofs about the solids of a scene.
pub struct Proofs<'a> {
    scene: &'a Scene,
    bounds: &'a [NodeBounds],
    /// For each node, whether a surface without an inside is part of it: the laws of sets do not apply to surfaces.
    sheets: Vec<bool>,
    left: usize,
    pairs_left: usize,
}

impl<'a> Proofs<'a> {
    pub fn new(scene: &'a Scene, bounds: &'a [NodeBounds]) -> Proofs<'a> {
        let sheets = fold_up(&scene.nodes, |_, node, sheets| match node {
            Node::Shape(s) => !scene.shapes[s as usize].geometry.is_solid(),
            _ => node.children().any(|c| sheets[c as usize]),
        });
        Proofs {
            scene,
            bounds,
            sheets,
            left: MORE,
            pairs_left: PAIRS,
        }
    }

    /// The complement of a node as a list of literals that must all hold. `list` is the node itself as a list.
    pub fn complement(&mut self, node: NodeId, list: &[Literal]) -> Vec<Literal> {
        match *list {
            [(n, true)] => vec![(n, false)],
            // The complement of a union is outside of each of its parts.
            [(n, false)] => self.parts(n).into_iter().map(|p| (p, true)).collect(),
            _ => vec![(node, true)],
        }
    }

    /// Two nodes, one from each list, that have nothing in common, in the order of the reason. `whole`: the operands,
    /// if both are to hold.
    pub fn nothing(
        &mut self,
        first: &[Literal],
        second: &[Literal],
        whole: Option<(NodeId, NodeId)>,
    ) -> Option<(NodeId, NodeId, Reason)> {
        for &(x, x_out) in first {
            for &(y, y_out) in second {
                let reason = match (x_out, y_out) {
                    (false, false) => match self.apart(x, y) {
                        // The reason names the second node as the union, so the nodes are exchanged.
                        None if self.in_parts(y, x) => return Some((y, x, Reason::Parts)),
                        None if self.in_parts(x, y) => Some(Reason::Parts),
                        None if self.beyond(y, &placed(self.scene, x)) => {
                            return Some((y, x, Reason::Beyond));
                        }
                        reason => reason,
                    },
                    (false, true) => self.covered(x, y),
                    (true, false) => match self.covered(y, x) {
                        Some(reason) => return Some((y, x, reason)),
                        None => None,
                    },
                    (true, true) => None,
                };
                if let Some(reason) = reason {
                    return Some(match reason {
                        Reason::Apart { axis, end, begin } if end > begin => {
                            let (end, begin) = (begin, end);
                            (y, x, Reason::Apart { axis, end, begin })
                        }
                        reason => (x, y, reason),
                    });
                }
            }
        }
        let (a, b) = whole?;
        match self.boxes_apart(a, b)? {
            (axis, end, begin, false) => Some((a, b, Reason::Apart { axis, end, begin })),
            (axis, end, begin, true) => Some((b, a, Reason::Apart { axis, end, begin })),
        }
    }

    fn all(&self, n: NodeId) -> &Aabb {
        &self.bounds[n as usize].all
    }

    /// An axis along which the boxes of two nodes are apart: where the lower box ends, where the upper one begins, and
    /// whether the lower box is the second node's. Boxes are rounded outwards.
    fn boxes_apart(&self, a: NodeId, b: NodeId) -> Option<(usize, f64, f64, bool)> {
        let (a, b) = (self.all(a), self.all(b));
        // Boxes that are nearer to each other than this may touch, as far as the numbers go.
        let clear = |end: f64, begin: f64| begin - end > CLEARANCE_REL * (end.abs() + begin.abs());
        (0..3).find_map(
            |i| match (clear(a.max[i], b.min[i]), clear(b.max[i], a.min[i])) {
                (true, _) => Some((i, a.max[i], b.min[i], false)),
                (_, true) => Some((i, b.max[i], a.min[i], true)),
                _ => None,
            },
        )
    }

    fn apart(&self, x: NodeId, y: NodeId) -> Option<Reason> {
        if self.all(x).is_empty() || self.all(y).is_empty() {
            return None;
        }
        if let Some((axis, end, begin, second)) = self.boxes_apart(x, y) {
            // If the second box is the lower one, the numbers are exchanged here, and the caller exchanges the nodes.
            let (end, begin) = if second { (begin, end) } else { (end, begin) };
            return Some(Reason::Apart { axis, end, begin });
        }
        let (p, q) = (placed(self.scene, x), placed(self.scene, y));
        if let (Some((c, r)), Some((d, s))) = (self.ball(&p), self.ball(&q)) {
            let between = distance(c, d);
            let clear = CLEARANCE_REL * (r + s + far(&c) + far(&d));
            let radii = r + s;
            return (between > radii + clear).then_some(Reason::Balls { between, radii });
        }
        // The reason names the first node as outside of the second.
        if self.beyond(x, &q) {
            return Some(Reason::Beyond);
        }
        self.plane_between(&p, &q)
    }

    /// Whether each part of a union is apart from `x`, or from all parts of `x` if `x` is a union, too.
    fn in_parts(&mut self, x: NodeId, union: NodeId) -> bool {
        if self.all(x).is_empty() {
            return false;
        }
        let parts = self.parts(union);
        if parts.len() < 2 {
            return false;
        }
        let near: Vec<NodeId> = (parts.iter().copied())
            .filter(|&part| self.apart(x, part).is_none() && self.apart(part, x).is_none())
            .collect();
        near.is_empty() || self.are_apart(x, &near)
    }

    /// Whether each part of a union is apart from each of the other nodes.
    fn are_apart(&mut self, union: NodeId, others: &[NodeId]) -> bool {
        if !matches!(
            self.scene.nodes[self.unpainted(union) as usize],
            Node::Union(..)
        ) {
            return false;
        }
        let parts = self.parts(union);
        let left = self.pairs_left.checked_sub(parts.len() * others.len());
        let Some(left) = left.filter(|_| parts.len() > 1) else {
            return false;
        };
        self.pairs_left = left;
        let is_apart = |&a: &NodeId, &b: &NodeId| {
            self.all(a).is_empty()
                || self.all(b).is_empty()
                || self.apart(a, b).is_some()
                || self.apart(b, a).is_some()
        };
        (parts.iter()).all(|a| others.iter().all(|b| is_apart(a, b)))
    }

    /// The node below all paints and copies.
    fn unpainted(&self, mut node: NodeId) -> NodeId {
        while let Node::Paint { child, .. } | Node::Copy { child, .. } =
            self.scene.nodes[node as usize]
        {
            node = child;
        }
        node
    }

    /// The parts of a union. If there are too many, some of them stay together as smaller unions.
    fn parts(&mut self, node: NodeId) -> Vec<NodeId> {
        let most = if self.left > 0 { PARTS } else { KEPT };
        let mut out = Vec::new();
        let mut todo = vec![node];
        while let Some(n) = todo.pop() {
            match self.scene.nodes[n as usize] {
                Node::Union(a, b) if todo.len() + out.len() + 2 <= most => todo.extend([b, a]),
                Node::Paint { child, .. } | Node::Copy { child, .. } => todo.push(child),
                _ => out.push(n),
            }
        }
        if out.len() > KEPT {
            self.left = self.left.saturating_sub(out.len());
        }
        out
    }

    /// A plane between two bounded shapes: along a face of one of them, along an edge of each, or across the line
    /// between their centres.
    fn plane_between(&self, p: &Placed, q: &Placed) -> Option<Reason> {
        let (g, h) = (self.geometry(p)?, self.geometry(q)?);
        let edges = |m: &Matrix| -> [Vec3; 3] {
            std::array::from_fn(|j| std::array::from_fn(|i| m.0[i][j]))
        };
        let (e, f) = (edges(&p.matrix), edges(&q.matrix));
        let across = |e: &[Vec3; 3]| [0, 1, 2].map(|i| cross(e[(i + 1) % 3], e[(i + 2) % 3]));
        let [a, b] = [p, q].map(|x| self.all(x.node).centre());
        let way = std::array::from_fn(|i| b[i] - a[i]);
        let both = e.iter().flat_map(|x| f.map(|y| cross(*x, y)));
        let all = across(&e)
            .into_iter()
            .chain(across(&f))
            .chain(both)
            .chain([way]);
        for normal in all.filter_map(unit) {
            let (low, high) = extent(g, &p.matrix, normal)?;
            let (from, to) = extent(h, &q.matrix, normal)?;
            let size = [low, high, from, to]
                .iter()
                .fold(0.0f64, |m, x| m.max(x.abs()));
            // The products are rounded by the distance of the shapes from the origin, not only by their extent along
            // the normal.
            let places = [p, q].map(|x| far(&self.all(x.node).min).max(far(&self.all(x.node).max)));
            let clear = CLEARANCE_REL * (size + places[0] + places[1]);
            if from - high > clear {
                let (end, begin) = (high, from);
                return Some(Reason::Plane { normal, end, begin });
            }
            if low - to > clear {
                let normal = normal.map(|x| -x);
                let (end, begin) = (-low, -to);
                return Some(Reason::Plane { normal, end, begin });
            }
        }
        None
    }

    fn ball(&self, p: &Placed) -> Option<(Vec3, f64)> {
        ball(self.scene, p.shape?, &p.matrix)
    }

    fn geometry(&self, p: &Placed) -> Option<&Geometry> {
        Some(&self.scene.shapes[p.shape? as usize].geometry)
    }

    /// Whether all of a bounded node is outside of a half-space.
    fn beyond(&self, x: NodeId, plane: &Placed) -> bool {
        let Some(Geometry::HalfSpace([a, b, c, d])) = self.geometry(plane) else {
            return false;
        };
        let Some(corners) = corners_of(self.all(x), plane) else {
            return false;
        };
        corners.iter().all(|[x, y, z]| {
            let terms = [a * x, b * y, c * z, *d];
            let size: f64 = terms.iter().map(|t| t.abs()).sum();
            terms.iter().sum::<f64>() > CLEARANCE_REL * size
        })
    }

    /// The reason why `x` without `y` is empty, if that is proved.
    pub fn covered(&self, x: NodeId, y: NodeId) -> Option<Reason> {
        let (p, q) = (placed(self.scene, x), placed(self.scene, y));
        let solid = !self.sheets[x as usize] && !self.sheets[y as usize];
        if solid && p.matrix == q.matrix {
            let equal = |s: u32, t: u32| {
                self.scene.shapes[s as usize].geometry == self.scene.shapes[t as usize].geometry
            };
            let same = match (p.shape, q.shape) {
                (Some(s), Some(t)) => equal(s, t),
                _ => p.core == q.core,
            };
            if same {
                return Some(Reason::Same);
            }
        }
        let outer = PlacedShape::new(self.geometry(&q)?, q.matrix)?;
        let shape = self.geometry(&p).map(|g| (g, &p.matrix));
        (outer.holds(self.all(x), shape) || self.between_faces(&p, &q)).then_some(Reason::Within)
    }

    /// Whether the shape `p` lies between the faces of the shape `q`, which are all planes.
    fn between_faces(&self, p: &Placed, q: &Placed) -> bool {
        let (Some(g), Some(h)) = (self.geometry(p), self.geometry(q)) else {
            return false;
        };
        let Some(back) = q.matrix.inverse() else {
            return false;
        };
        // A coordinate in the space of `q` is the dot product with a vector, plus a number.
        let row = |i: usize| -> (Vec3, f64) {
            let r = back.0[i];
            ([r[0], r[1], r[2]], r[3])
        };
        let b = self.all(p.node);
        let place = far(&b.min).max(far(&b.max));
        let reaches = |(normal, offset): (Vec3, f64)| {
            let (low, high) = extent(g, &p.matrix, normal)?;
            let size = length(normal) * place + offset.abs();
            Some((
                low + offset - CLEARANCE_REL * size,
                high + offset + CLEARANCE_REL * size,
            ))
        };
        match h {
            Geometry::Box { min, max } => (0..3)
                .all(|i| reaches(row(i)).is_some_and(|(low, high)| min[i] < low && high < max[i])),
            Geometry::HalfSpace([a, b, c, d]) => {
                let rows = [row(0), row(1), row(2)];
                let factors = [a, b, c];
                let normal =
                    std::array::from_fn(|k| (0..3).map(|i| factors[i] * rows[i].0[k]).sum());
                let offset = (0..3).map(|i| factors[i] * rows[i].1).sum::<f64>() + d;
                reaches((normal, offset)).is_some_and(|(_, high)| high < 0.0)
            }
            // Nothing is proved of other shapes.
            _ => false,
        }
    }
}

/// The corners of a box that is slightly enlarged, in the coordinates of a shape. `None` if the box is empty or
/// infinite.
fn corners_of(b: &Aabb, to: &Placed) -> Option<[Vec3; 8]> {
    if !b.is_finite() || b.is_empty() {
        return None;
    }
    let clear = CLEARANCE_REL * (b.radius() + far(&b.min).max(far(&b.max)));
    let back = to.matrix.inverse()?;
    Some(std::array::from_fn(|k| {
        back.point(std::array::from_fn(|i| match k >> i & 1 {
            0 => b.min[i] - clear,
            _ => b.max[i] + clear,
        }))
    }))
}

/// A node with its core, and the matrix from the core's coordinates to the node's.
struct Placed {
    node: NodeId,
    core: NodeId,
    shape: Option<u32>,
    matrix: Matrix,
}

fn placed(scene: &Scene, whole: NodeId) -> Placed {
    let (core, matrix) = scene.core(whole, Matrix::IDENTITY);
    Placed {
        node: whole,
        core,
        shape: match scene.nodes[core as usize] {
            Node::Shape(s) => Some(s),
            _ => None,
        },
        matrix,
    }
}
