//! The search for faces that lie in one another, in time that hardly grows faster than the scene.

use rustc_hash::FxHashSet;

use super::directions::Sample;
use super::face::{Face, FaceId, FaceShape, Faces, QUADRIC, quadric_form};
use super::planes::{Meeting, Planes};
use super::quadric;
use super::sample;
use crate::geometry::array::{across, add};
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3};
use crate::solids::ancestry::NONE;
use crate::solids::bounds::NodeBounds;
use crate::solids::leaf::Leaf;
use crate::solids::points::Points;
use crate::solids::shapes::facts::Facts;
use crate::solids::tree::{Answer, Tree};

/// Distance at which two faces are in one place, as a share of the smaller shape: the language's own bound.
pub const FACE_REL_GAP: f64 = 1e-9;

/// Rounding of a point's coordinates on the way through two matrices, as a share of their size.
pub const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The distance of three points around a sample from it, as a multiple of the distance that counts as none. The faces
/// must meet at these points, too: otherwise the sample may be on the border of something else, where rounding decides
/// the side. On a curved surface the points are off the surface by the square of their distance over the radius, which
/// is less than the distance that counts as none down to radii of a hundred-thousandth of the size.
const AROUND: f64 = 100.0;

/// The greatest thickness of a skin, as a share of the shape that was cut.
const SKIN_REL_THICKNESS: f64 = 0.01;

/// A face of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactSide {
    /// The shape's own node.
    pub node: NodeId,
    /// Index into the scene's shapes.
    pub shape: u32,
    /// The ID by which the shape is written in the operand; `copy` is the ID of the copy of which the shape is a part.
    pub id: u32,
    pub copy: Option<u32>,
    /// The operand that the shape is, or of which it is a part.
    pub operand: NodeId,
    pub part: FaceId,
    /// Whether the face is round.
    pub round: bool,
    /// The longest side of the shape's bounds, in the coordinates of the scene.
    pub size: f64,
    /// The factor from lengths in the shape's record to lengths in the scene, on average over all directions.
    pub stretch: f64,
    /// Whether the shape cuts: the points in the shape are not in the result.
    pub cuts: bool,
}

#[derive(Debug, Clone, Copy)]
pub struct FaceContact {
    /// The difference or intersection.
    pub operation: NodeId,
    /// The face of each operand, the tool's first. The tool is the second operand, unless only the first one cuts.
    pub sides: [ContactSide; 2],
    /// A point of both faces, in the coordinates of the scene that is drawn, or of the largest object of which the
    /// operation is a part.
    pub witness: Vec3,
    /// Whether the tool leaves no more than a skin of the shape that it cuts: a longer tool would leave nothing.
    pub skin: bool,
}

/// Finds for each face of a tool the first face that lies in it, if rounding decides what is left of the two and this
/// can be seen.
pub fn search(scene: &Scene, bounds: &[NodeBounds], roots: &[NodeId]) -> Vec<FaceContact> {
    let cuts = |n: &Node| matches!(n, Node::Difference(..) | Node::Intersection(..));
    if !scene.nodes.iter().any(cuts) {
        return Vec::new();
    }
    let tree = Tree::new(scene, bounds, roots);
    // Round faces can lie in a quadric only if there are quadrics.
    let of = |leaf: &Leaf| Some(&scene.shapes[leaf.shape? as usize].geometry);
    let is_quadric = |leaf: &Leaf| of(leaf).is_some_and(|g| g.character().is_quadric);
    let quadrics = tree.leaves.iter().any(is_quadric);
    let mut planes = Planes::new(&tree);
    let mut search = None;
    let mut found = Vec::new();
    let mut all = Vec::new();
    // The leaves of a group stand together.
    let group = |leaf: &Leaf| tree.places[leaf.place as usize].group;
    let mut from = 0;
    for leaves in tree.leaves.chunk_by(|a, b| group(a) == group(b)) {
        let first = from as u32;
        from += leaves.len();
        if leaves.len() < 2 || group(&leaves[0]) == NONE {
            continue;
        }
        all.clear();
        all.reserve(6 * leaves.len());
        for (i, leaf) in (first..).zip(leaves) {
            if let Some(geometry) = of(leaf) {
                let from = all.len();
                geometry.faces(&mut Faces {
                    leaf: i,
                    m: &leaf.matrix,
                    out: &mut all,
                });
                if quadrics {
                    as_quadrics(geometry, &leaf.matrix, from, &mut all);
                }
            }
        }
        let pairs = planes.pairs(&all);
        if !pairs.is_empty() {
            let new = || Search::new(scene, bounds, &tree);
            (search.get_or_insert_with(new)).group(&all, &pairs, &mut found);
        }
    }
    found
}

/// Adds the round faces from index `from` on once more, as the quadrics in which they lie.
fn as_quadrics(geometry: &Geometry, m: &Matrix, from: usize, all: &mut Vec<Face>) {
    for i in from..all.len() {
        let Face { leaf, part, .. } = all[i];
        if matches!(all[i].form, FaceShape::Round { class: QUADRIC, .. }) {
            continue;
        }
        let form = geometry.quadric(part);
        if let Some(at) = form.and_then(|q| quadric::fingerprint(&q, m)) {
            let form = quadric_form(at);
            let own = false;
            all.push(Face {
                leaf,
                part,
                form,
                own,
            });
        }
    }
}

/// The key by which a contact is reported once: the operation, the tool's shape and face, and whether the tool and the
/// other shape cut.
type Done = (NodeId, (u32, FaceId), (bool, bool));

struct Search<'a> {
    scene: &'a Scene,
    tree: &'a Tree,
    points: Points<'a>,
    /// The keys of the contacts that have been found.
    done: FxHashSet<Done>,
}

/// Two faces to be compared, one from each operand.
struct Pair<'a> {
    /// The operation's place in the tree.
    operation: u32,
    faces: [&'a Face; 2],
    leaves: [&'a Leaf; 2],
}

impl Pair<'_> {
    /// The size of the smaller shape. If both shapes are infinite, their distance from the origin stands for it, or 1
    /// if they go through the origin.
    fn size(&self, p: Vec3) -> f64 {
        let size = self.leaves[0].size.min(self.leaves[1].size);
        if size.is_finite() {
            return size;
        }
        let far = |p: Vec3| p.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let planes = self.faces.map(|f| match &f.form {
            FaceShape::Flat { point, .. } => far(*point),
            FaceShape::Round { .. } => far(p),
        });
        match planes[0].max(planes[1]) {
            0.0 => 1.0,
            far => far,
        }
    }
}

impl<'a> Search<'a> {
    fn new(scene: &'a Scene, bounds: &'a [NodeBounds], tree: &'a Tree) -> Search<'a> {
        Search {
            scene,
            points: Points::new(scene, bounds, tree),
            tree,
            done: FxHashSet::default(),
        }
    }

    /// Compares the pairs of faces of one group, and adds the contacts to `found`.
    fn group(&mut self, all: &[Face], pairs: &[Meeting], found: &mut Vec<FaceContact>) {
        let tree = self.tree;
        for pair in pairs {
            let Meeting { operation, .. } = *pair;
            let [later, earlier] = pair.faces.map(|f| &all[f as usize]);
            let faces = [earlier, later];
            let leaves = faces.map(|f| &tree.leaves[f.leaf as usize]);
            let pair = Pair {
                operation,
                faces,
                leaves,
            };
            let tool = self.tool(&pair);
            let cuts = |i: usize| self.cuts(&pair, leaves[i]);
            let done = (
                tree.places[operation as usize].node,
                (leaves[tool].shape.unwrap_or_default(), faces[tool].part),
                (cuts(tool), cuts(1 - tool)),
            );
            if self.done.contains(&done) || self.identical(&pair) {
                continue;
            }
            if self.points.is_spent() {
                return;
            }
            if let Some(witness) = self.witness(&pair) {
                self.done.insert(done);
                found.push(FaceContact {
                    operation: done.0,
                    sides: self.sides(&pair),
                    witness,
                    skin: self.leaves_a_skin(&pair),
                });
            }
        }
    }

    fn geometry(&self, leaf: &Leaf) -> Option<&Geometry> {
        Some(&self.scene.shapes[leaf.shape? as usize].geometry)
    }

    /// Whether the two shapes and their places are equal: then their surfaces are one, and decided exactly.
    fn identical(&self, pair: &Pair) -> bool {
        let [a, b] = pair.leaves;
        a.matrix == b.matrix && self.geometry(a) == self.geometry(b)
    }

    /// Whether the tool holds the corners of the workpiece's bounds after they are moved inwards by the thickness of a
    /// skin, and nothing but cuts lies between the workpiece and the operation.
    fn leaves_a_skin(&mut self, pair: &Pair) -> bool {
        let tool = self.tool(pair);
        let other = pair.leaves[1 - tool];
        let b = other.bounds;
        let held = (0..8).all(|k| {
            let corner: Vec3 = std::array::from_fn(|i| {
                let (from, to) = match k >> i & 1 {
                    0 => (b.min[i], b.max[i]),
                    _ => (b.max[i], b.min[i]),
                };
                from + SKIN_REL_THICKNESS * (to - from)
            });
            self.points.in_leaf(pair.faces[tool].leaf, corner) == Some(true)
        });
        held && self.tree.only_cuts_between(other.place, pair.operation)
    }

    /// The index of a pair's tool: the second, unless only the first one cuts.
    fn tool(&self, pair: &Pair) -> usize {
        match pair.leaves.map(|leaf| self.cuts(pair, leaf)) {
            [true, false] => 0,
            _ => 1,
        }
    }

    fn cuts(&self, pair: &Pair, leaf: &Leaf) -> bool {
        let turned = |i: u32| self.tree.places[i as usize].turned;
        turned(leaf.place) != turned(pair.operation)
    }

    /// The operand of the pair's operation that a leaf is part of.
    fn operand(&self, pair: &Pair, leaf: &Leaf) -> NodeId {
        let [first, second] = self.tree.places[pair.operation as usize].children;
        let place = if leaf.place < second { first } else { second };
        self.tree.places[place as usize].node
    }

    /// The two sides of a pair, the tool's first.
    fn sides(&self, pair: &Pair) -> [ContactSide; 2] {
        let side = |face: &Face, leaf: &Leaf| ContactSide {
            node: leaf.node,
            shape: leaf.shape.unwrap_or_default(),
            id: leaf.id,
            copy: self.tree.copy_within(leaf.place, pair.operation),
            operand: self.operand(pair, leaf),
            part: face.part,
            round: matches!(face.form, FaceShape::Round { .. }),
            size: leaf.size,
            stretch: leaf.matrix.determinant3().abs().cbrt(),
            cuts: self.cuts(pair, leaf),
        };
        let tool = self.tool(pair);
        [tool, 1 - tool].map(|i| side(pair.faces[i], pair.leaves[i]))
    }

    /// A point at which the faces meet and this can be seen: both operands change sides there, one into the result and
    /// one out of it, within the distance that counts as none.
    fn witness(&mut self, pair: &Pair) -> Option<Vec3> {
        let [f, g] = pair.faces;
        let [l, k] = pair.leaves;
        let (samples, needed): (Vec<Sample>, usize) = match &f.form {
            FaceShape::Flat { point, .. } => (sample::flat(f, g, pair.size(*point)), 1),
            // Round surfaces can touch in a point or a line, but hardly at two irregular points by chance.
            FaceShape::Round { .. } => (
                sample::round((f, l, self.geometry(l)?), (g, k, self.geometry(k)?)),
                2,
            ),
        };
        let mut met = 0;
        for (p, n) in samples {
            if self.shows(pair, p, n) {
                met += 1;
                if met >= needed {
                    return Some(p);
                }
            }
        }
        None
    }

    /// Whether the two faces meet at a point and at three points around it.
    fn shows(&mut self, pair: &Pair, p: Vec3, n: Vec3) -> bool {
        let magnitude = p.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let reach = FACE_REL_GAP * pair.size(p) + ROUNDING * magnitude;
        // The two shapes are asked first, since this is quick.
        if !self.change_sides(pair, p, n, reach) {
            return false;
        }
        let away = AROUND * reach;
        let room = 2.0 * away;
        let around = Aabb::new(p.map(|x| x - room), p.map(|x| x + room));
        let Some(near) = self.points.near(&around) else {
            return false;
        };
        if !self.meets(pair, p, n, reach, &near) {
            return false;
        }
        let [u, v] = across(n);
        // The corners of a triangle: every line through the middle has some of them on either side.
        [(1.0, 0.1), (-0.6, 0.8), (-0.4, -0.9)]
            .into_iter()
            .all(|(a, b)| {
                let q = add(add(p, u, a * away), v, b * away);
                self.change_sides(pair, q, n, reach) && self.meets(pair, q, n, reach, &near)
            })
    }

    /// Whether both shapes change sides at a point, within `reach` along the normal `n`.
    fn change_sides(&mut self, pair: &Pair, p: Vec3, n: Vec3, reach: f64) -> bool {
        pair.faces.iter().all(|face| {
            let sides = [-reach, reach].map(|by| self.points.in_leaf(face.leaf, add(p, n, by)));
            matches!(sides, [Some(below), Some(above)] if below != above)
        })
    }

    /// Whether both operands change sides at a point, one into the result and the other out of it, and this decides
    /// what is seen. `near`: all leaves that may hold a point around there.
    fn meets(&mut self, pair: &Pair, p: Vec3, n: Vec3, reach: f64, near: &[u32]) -> bool {
        let sides = [add(p, n, -reach), add(p, n, reach)];
        if let Some((low, high)) = self.scene.render.and_then(|r| r.clip)
            && !sides
                .iter()
                .all(|q| (0..3).all(|i| low[i] < q[i] && q[i] < high[i]))
        {
            return false;
        }
        let [Some(below), Some(above)] = sides.map(|q| self.points.at(q, near)) else {
            return false;
        };
        let operands = self.tree.places[pair.operation as usize].children;
        let changes = operands.map(|operand| {
            let negated = self.tree.places[operand as usize].negated;
            let ask = |answers: &[(u32, Answer)]| self.tree.value(operand, answers);
            Some([ask(&below)? != negated, ask(&above)? != negated])
        });
        let [Some(a), Some(b)] = changes else {
            return false;
        };
        if a[0] == a[1] || b[0] == b[1] || a[0] == b[0] {
            return false;
        }
        if self.scene.render.is_none() {
            return true;
        }
        // Another part that changes sides there would also decide what is left.
        match [below, above].map(|answers| self.tree.decides(pair.operation, &answers)) {
            [Some(x), Some(y)] => x == y,
            _ => false,
        }
    }
}
