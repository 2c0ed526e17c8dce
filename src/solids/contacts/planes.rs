//! The search for faces that may lie in one another. Faces are sorted by their planes, and within a plane found by
//! their outlines.

use super::face::{Face, FaceShape, QUADRIC};
use super::sample::SLIVER;
use super::search::{FACE_REL_GAP, ROUNDING};
use crate::geometry::Aabb;
use crate::geometry::array::dot;
use crate::geometry::boxes::Boxes;
use crate::parallel;
use crate::scene::Vec3;
use crate::solids::tree::Tree;

/// The most faces and boxes that are looked at, for all faces together: some tenths of a second. Faces that are not
/// looked at are not reported.
const STEPS: usize = 20_000_000;

/// The most pairs: several times as many as the later steps can try at points.
const PAIRS: usize = 500_000;

/// Cost of finding the operation that joins two shapes, in steps.
const JOIN_COST: usize = 8;

/// The most faces in one plane that are compared one by one; for more an index is made.
const MAX_FACES_COMPARED_SINGLY: usize = 16;

type Cell = [i16; 3];

/// The key by which a face is sorted. The keys of all faces are sorted, and most of them are then thrown away.
#[derive(Clone, Copy)]
struct Filed {
    cell: Cell,
    /// Whether a face in the same plane may be in another cell.
    on_border: bool,
    face: u32,
    at: f64,
    /// The size of the numbers that make up the face.
    magnitude: f64,
}

impl Filed {
    /// The key to sort by: cell, then number, as one integer; then face.
    fn order(&self) -> (u128, u32) {
        let [x, y, z] = self.cell.map(|c| u64::from(c as u16 ^ 0x8000));
        let cell = x << 32 | y << 16 | z;
        // The bits of the number, changed so that their order is that of `total_cmp`.
        let bits = self.at.to_bits();
        let at = bits ^ ((bits as i64 >> 63) as u64 | 1 << 63);
        (u128::from(cell) << 64 | u128::from(at), self.face)
    }
}

/// The number of cells per unit of a normal's component: steps of a ten-thousandth.
const CELLS: f64 = 1e4;

/// A direction along which no scene is built. Products with it tell points apart by one number.
const ODD: Vec3 = [0.612_372, 0.288_675, 0.736_203];

/// A direction like [`ODD`], for sums of whole numbers.
const ODD_CELL: [i32; 3] = [612, 289, 736];

/// The magnitude of a quadric's key. Times [`ROUNDING`] it is a ten-millionth, to within which the numbers of one
/// surface agree: rounding in the matrices grows with the distance from the origin. Samples decide in the end.
const QUADRIC_LOOSENESS: f64 = 1e-7 / ROUNDING;

/// A sorted face with all that the search asks of it, since the faces themselves lie far apart in memory.
struct SortedFace {
    cell: Cell,
    at: f64,
    face: u32,
    leaf: u32,
    /// Whether a face in the same plane may be in another cell.
    on_border: bool,
    flat: bool,
    /// Whether the face is one of the shape's own: see [`Face::own`].
    own: bool,
    /// The size of the shape. `magnitude` is the size of the numbers that make up the face.
    size: f64,
    magnitude: f64,
    bounds: Aabb,
}

impl SortedFace {
    /// The cell and the number of a face that lies in this one. Flat faces that lie in one another look in opposite
    /// directions; round faces are filed without a direction.
    fn opposite(&self) -> (Cell, f64) {
        match self.flat {
            true => (self.cell.map(|c| -c), -self.at),
            false => (self.cell, self.at),
        }
    }

    /// A number for the direction of a flat face, 0 for round ones. Two faces that look against each other have
    /// opposite numbers, up to the width of a cell.
    fn side(&self) -> i32 {
        match self.flat {
            true => (0..3).map(|i| ODD_CELL[i] * i32::from(self.cell[i])).sum(),
            false => 0,
        }
    }

    /// Whether the face looks for others that lie in it. Faces with a clearly negative side are only found.
    fn asks(&self) -> bool {
        self.side() >= -ODD_CELL.iter().sum::<i32>()
    }

    /// Whether this face of a pair is the one that finds the other, so that a pair is found once.
    fn precedes(&self, other: &SortedFace) -> bool {
        (other.side(), self.leaf) < (self.side(), other.leaf)
    }
}

/// A range of the sorted faces: they lie in one plane, or in planes very near to each other.
struct Run {
    cell: Cell,
    /// The least number of the faces' keys; `high` is the largest.
    low: f64,
    high: f64,
    start: usize,
    end: usize,
    /// The index of the faces from `start` on, made when it is first needed.
    index: Option<Box<Boxes>>,
}

/// The key of a face: its cell, a number that is nearly equal for nearly equal faces, and the size of the numbers that
/// make up the face. `turned`: the face looks the other way, as part of a complement.
fn key(form: &FaceShape, turned: bool) -> (Cell, f64, f64) {
    match form {
        FaceShape::Flat { normal, point, .. } => {
            let n = if turned { normal.map(|x| -x) } else { *normal };
            let cell = n.map(|x| (x * CELLS).round() as i16);
            let size = point.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            (cell, dot(n, *point), size)
        }
        FaceShape::Round {
            anchor,
            scale,
            class,
        } => {
            let size = match *class {
                QUADRIC => QUADRIC_LOOSENESS,
                _ => anchor.iter().fold(scale.abs(), |m, x| m.max(x.abs())),
            };
            let at = dot(ODD, *anchor) + std::f64::consts::SQRT_2 * scale;
            ([i16::MAX, i16::from(*class), 0], at, size)
        }
    }
}

/// For each axis, the coordinate of the cell behind a border, if the normal is within a hundredth of a step of one.
fn beyond_border(normal: Vec3, cell: Cell) -> [Option<i16>; 3] {
    std::array::from_fn(|i| {
        let x = normal[i] * CELLS;
        let near = [x - 0.01, x + 0.01].map(|x| x.round() as i16);
        near.into_iter().find(|&c| c != cell[i])
    })
}

/// Whether a face in the same plane may be in another cell.
fn on_border(form: &FaceShape, cell: Cell, turned: bool) -> bool {
    let FaceShape::Flat { normal, .. } = form else {
        return false;
    };
    let sign = if turned { -1.0 } else { 1.0 };
    let others = beyond_border(normal.map(|x| sign * x), cell);
    others.iter().any(Option::is_some)
}

/// All cells in which a face in the same plane can be.
fn cells(form: &FaceShape, turned: bool, cell: Cell) -> Vec<Cell> {
    let FaceShape::Flat { normal, .. } = form else {
        return vec![cell];
    };
    let sign = if turned { -1.0 } else { 1.0 };
    let others = beyond_border(normal.map(|x| sign * x), cell);
    let mut out = vec![cell];
    for (i, other) in others.into_iter().enumerate() {
        let Some(other) = other else { continue };
        for k in 0..out.len() {
            let mut c = out[k];
            c[i] = other;
            out.push(c);
        }
    }
    out
}

/// Two faces that may lie in one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Meeting {
    /// The two leaves, the later one first.
    leaves: [u32; 2],
    /// The faces, that of the later leaf first.
    pub faces: [u32; 2],
    /// The place of the operation that joins their shapes.
    pub operation: u32,
}

/// The search for pairs, for one group after the other, with one budget for all.
pub(super) struct Planes<'a> {
    tree: &'a Tree,
    /// The largest size of all bounded shapes.
    largest: f64,
    steps: usize,
    pairs: usize,
}

impl<'a> Planes<'a> {
    pub(super) fn new(tree: &'a Tree) -> Planes<'a> {
        let sizes = tree.leaves.iter().map(|l| l.size);
        Planes {
            tree,
            largest: sizes.filter(|s| s.is_finite()).fold(0.0, f64::max),
            steps: STEPS,
            pairs: PAIRS,
        }
    }

    /// The pairs among the faces of one group that may lie in one another. Flat faces look against each other in one
    /// plane, round ones have one key, and the outlines overlap. The faces are of different leaves, which a difference
    /// or an intersection joins. The pairs are sorted by the later leaf, then by the earlier one, which is mostly the
    /// workpiece.
    pub(super) fn pairs(&mut self, faces: &[Face]) -> Vec<Meeting> {
        let mut out = Vec::new();
        if self.steps > 0 && self.pairs > 0 {
            let entries = self.entries(faces);
            let mut runs = runs(&entries);
            if self.fill(faces, &entries, &mut runs, &mut out).is_none() {
                (self.steps, self.pairs) = (0, 0);
            }
        }
        out.sort_unstable();
        out
    }

    fn turned(&self, face: &Face) -> bool {
        let leaf = &self.tree.leaves[face.leaf as usize];
        self.tree.places[leaf.place as usize].turned
    }

    /// The faces in the order of their keys, without those that surely lie in no other face.
    fn entries(&self, faces: &[Face]) -> Vec<SortedFace> {
        let mut filed = parallel::map(faces.len(), |i| {
            let face = &faces[i];
            let turned = self.turned(face);
            let (cell, at, magnitude) = key(&face.form, turned);
            Filed {
                cell,
                on_border: on_border(&face.form, cell, turned),
                face: i as u32,
                at,
                magnitude,
            }
        });
        filed.retain(|f| f.at.is_finite());
        filed.sort_unstable_by_key(Filed::order);
        let filed = self.opposed(filed);
        let entry = |filed: &Filed| {
            let face = &faces[filed.face as usize];
            let size = self.tree.leaves[face.leaf as usize].size;
            let normal = match &face.form {
                FaceShape::Flat { normal, .. } => Some(*normal),
                FaceShape::Round { .. } => None,
            };
            SortedFace {
                cell: filed.cell,
                at: filed.at,
                face: filed.face,
                leaf: face.leaf,
                on_border: filed.on_border,
                flat: normal.is_some(),
                own: face.own,
                // An infinite shape has no size. The largest bounded shape stands for it, or the distance of its plane
                // from the origin.
                size: match normal {
                    _ if size.is_finite() => size,
                    Some(_) => filed.magnitude.max(self.largest),
                    None => self.largest,
                },
                magnitude: filed.magnitude,
                bounds: outline(self.tree, face),
            }
        };
        parallel::map(filed.len(), |i| entry(&filed[i]))
    }

    /// Keeps the round faces, and the flat ones that may have a flat face against them: in most scenes few. `filed` is
    /// sorted.
    fn opposed(&self, filed: Vec<Filed>) -> Vec<Filed> {
        let flats = filed.partition_point(|f| f.cell[0] < i16::MAX);
        // More than the distance between any two keys of faces in one plane.
        let magnitudes = filed[..flats].iter().map(|f| f.magnitude);
        let magnitude = magnitudes.fold(self.largest, f64::max);
        let reach = (2.0 * FACE_REL_GAP + ROUNDING) * magnitude;
        // While the keys ascend, those of the opposite faces descend.
        let mut below = flats;
        let mut keep = |f: &Filed| {
            let opposite = f.cell.map(|c| -c);
            let past = |g: &Filed| g.cell > opposite || g.cell == opposite && g.at > reach - f.at;
            while below > 0 && past(&filed[below - 1]) {
                below -= 1;
            }
            let last = below.checked_sub(1).map(|last| &filed[last]);
            f.on_border || last.is_some_and(|g| g.cell == opposite && g.at >= -f.at - reach)
        };
        let mut kept: Vec<Filed> = filed[..flats].iter().filter(|f| keep(f)).copied().collect();
        kept.extend_from_slice(&filed[flats..]);
        kept
    }

    /// Adds the pairs to `out`. `None` when no steps or no pairs are left.
    fn fill(
        &mut self,
        faces: &[Face],
        entries: &[SortedFace],
        runs: &mut [Run],
        out: &mut Vec<Meeting>,
    ) -> Option<()> {
        let mut found = Vec::new();
        for entry in entries.iter().filter(|e| e.asks()) {
            let (cell, at) = entry.opposite();
            let reach = 2.0 * FACE_REL_GAP * entry.size + ROUNDING * entry.magnitude;
            let room = FACE_REL_GAP * entry.size;
            let mut around = entry.bounds;
            around.min = around.min.map(|x| x - room - ROUNDING * x.abs());
            around.max = around.max.map(|x| x + room + ROUNDING * x.abs());
            let (mut one, mut several) = (Some(cell), Vec::new());
            if entry.on_border {
                let face = &faces[entry.face as usize];
                (one, several) = (None, cells(&face.form, !self.turned(face), cell));
            }
            for cell in one.into_iter().chain(several) {
                let from = runs
                    .partition_point(|r| r.cell < cell || r.cell == cell && r.high < at - reach);
                for run in &mut runs[from..] {
                    if run.cell != cell || run.low > at + reach {
                        break;
                    }
                    let steps = run.near(entries, &around, &mut found);
                    for other in found.drain(..) {
                        let other = &entries[other as usize];
                        let both_again = !entry.own && !other.own;
                        let apart = (other.at - at).abs() > reach || touch(entry, other);
                        if entry.leaf == other.leaf || !entry.precedes(other) || both_again || apart
                        {
                            continue;
                        }
                        self.steps = self.steps.checked_sub(JOIN_COST)?;
                        let place = |e: &SortedFace| self.tree.leaves[e.leaf as usize].place;
                        if let Some(operation) = self.tree.cut(place(entry), place(other)) {
                            self.pairs = self.pairs.checked_sub(1)?;
                            let late = usize::from(entry.leaf < other.leaf);
                            let both = [entry, other];
                            let both = [both[late], both[1 - late]];
                            out.push(Meeting {
                                leaves: both.map(|e| e.leaf),
                                faces: both.map(|e| e.face),
                                operation,
                            });
                        }
                    }
                    self.steps = self.steps.checked_sub(steps)?;
                }
            }
        }
        Some(())
    }
}

/// Whether two flat faces have no more than a sliver in common ([`SLIVER`]).
fn touch(one: &SortedFace, two: &SortedFace) -> bool {
    let both = one.bounds.intersection(&two.bounds);
    let mut extent: Vec3 = std::array::from_fn(|i| both.max[i] - both.min[i]);
    extent.sort_unstable_by(f64::total_cmp);
    // The overlap is at most √2 times as wide as the second longest side of the box that holds it, and
    // its area at most that times half of the way around it.
    one.flat && two.flat && extent[1] < SLIVER * one.size.min(two.size)
}

/// Divides the sorted faces into runs that lie in one plane.
fn runs(entries: &[SortedFace]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (i, e) in entries.iter().enumerate() {
        let near = i > 0 && {
            let before = &entries[i - 1];
            let room = 2.0 * FACE_REL_GAP * e.size.min(before.size) + ROUNDING * e.magnitude;
            before.cell == e.cell && e.at - before.at <= room
        };
        match runs.last_mut().filter(|_| near) {
            Some(run) => (run.end, run.high) = (i + 1, e.at),
            None => runs.push(Run {
                cell: e.cell,
                low: e.at,
                high: e.at,
                start: i,
                end: i + 1,
                index: None,
            }),
        }
    }
    runs
}

impl Run {
    /// Puts into `out` the faces whose bounds overlap a box, and returns the number of steps that this took.
    fn near(&mut self, entries: &[SortedFace], around: &Aabb, out: &mut Vec<u32>) -> usize {
        let all = self.start as u32..self.end as u32;
        let overlaps = |i: &u32| entries[*i as usize].bounds.overlaps(around);
        if all.len() <= MAX_FACES_COMPARED_SINGLY {
            let steps = all.len();
            out.extend(all.filter(overlaps));
            return steps;
        }
        let mut steps = 0;
        let index = self.index.get_or_insert_with(|| {
            steps += all.len() * 4;
            Box::new(Boxes::new(
                (all.clone()).map(|i| (i, entries[i as usize].bounds)),
            ))
        });
        steps += index.near(around, out) + out.len();
        out.retain(overlaps);
        steps
    }
}

/// A box around a face.
fn outline(tree: &Tree, face: &Face) -> Aabb {
    match face.form.corners() {
        Some(corners) => {
            let points = corners.iter().map(|&p| Aabb::new(p, p));
            points.fold(Aabb::EMPTY, |b, p| b.hull(&p))
        }
        None => tree.leaves[face.leaf as usize].bounds,
    }
}
