//! Which faces may lie in one another: faces filed by their planes, and there by their outlines.

use super::face::{Face, Form, QUADRIC};
use super::search::{NEAR, ROUNDING};
use super::vector::dot;
use crate::lint::solids::boxes::Boxes;
use crate::lint::solids::tree::{NONE, Tree};
use crate::scene::{Aabb, Vec3};

/// Faces and boxes looked at, for all faces together: some tenths of a second. What is not looked at
/// is not spoken of.
const STEPS: usize = 20_000_000;

/// Pairs at most.
const PAIRS: usize = 2_000_000;

/// Fewer faces than this in one plane are looked at one by one.
const FEW: usize = 16;

type Cell = [i32; 3];

/// A unit vector's components in steps of a ten-thousandth.
const CELLS: f64 = 1e4;

/// A direction that no scene is built along, to tell places apart by one number.
const ODD: Vec3 = [0.612_372, 0.288_675, 0.736_203];

/// The numbers of quadrics agree to within a ten-millionth or are those of different surfaces:
/// rounding on the way through their matrices is magnified by where they are, and samples decide.
const LOOSE: f64 = 1e-7 / ROUNDING;

/// A face in the file, with all that is asked of it: the faces themselves lie far apart in memory.
struct Entry {
    group: u32,
    cell: Cell,
    at: f64,
    face: u32,
    leaf: u32,
    /// Whether a neighbour may be in another cell.
    on_border: bool,
    flat: bool,
    /// See [`Face::own`].
    own: bool,
    /// Of the shape, and of the numbers that the face is made of.
    size: f64,
    magnitude: f64,
    bounds: Aabb,
}

impl Entry {
    /// The cell and the number of a face that lies in this one: flat ones look the other way, round
    /// ones are filed without a side.
    fn opposite(&self) -> (Cell, f64) {
        match self.flat {
            true => (self.cell.map(|c| -c), -self.at),
            false => (self.cell, self.at),
        }
    }
}

/// Faces of one group that lie in one plane, or in planes very near to each other.
struct Run {
    /// Its group and cell.
    filed: (u32, Cell),
    /// The least and the largest number by which its entries are told apart.
    low: f64,
    high: f64,
    start: usize,
    end: usize,
    /// Over the entries from `start` on; made when it is first needed.
    index: Option<Box<Boxes>>,
}

/// Where a face is filed: its cell and a number that differs little for faces that differ little,
/// and how large the numbers are that it is made of.
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
            let size = match *class {
                QUADRIC => LOOSE,
                _ => anchor.iter().fold(scale.abs(), |m, x| m.max(x.abs())),
            };
            let at = dot(ODD, *anchor) + std::f64::consts::SQRT_2 * scale;
            ([i32::MAX, i32::from(*class), 0], at, size)
        }
    }
}

/// The cell on the other side of a border within a hundredth of a step, along each axis.
fn beyond_border(normal: Vec3, cell: Cell) -> [Option<i32>; 3] {
    std::array::from_fn(|i| {
        let x = normal[i] * CELLS;
        let near = [x - 0.01, x + 0.01].map(|x| x.round() as i32);
        near.into_iter().find(|&c| c != cell[i])
    })
}

/// All cells in which a neighbour of this one's face can be.
fn cells(form: &Form, turned: bool, cell: Cell) -> Vec<Cell> {
    let Form::Flat { normal, .. } = form else {
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

/// Pairs of faces, of different leaves of one group, that look against each other in one plane or
/// are round and of one place, and whose outlines overlap; the earlier leaf's face first.
pub fn pairs(tree: &Tree, faces: &[Face]) -> Vec<(u32, u32)> {
    let place = |f: &Face| &tree.places[tree.leaves[f.leaf as usize].place as usize];
    let sizes = || tree.leaves.iter().map(|l| l.size);
    let largest = sizes().filter(|s| s.is_finite()).fold(0.0, f64::max);
    let mut entries: Vec<Entry> = faces
        .iter()
        .enumerate()
        .map(|(i, face)| {
            let (cell, at, magnitude) = key(&face.form, place(face).turned);
            let size = tree.leaves[face.leaf as usize].size;
            let normal = match &face.form {
                Form::Flat { normal, .. } => Some(*normal),
                Form::Round { .. } => None,
            };
            let sign = if place(face).turned { -1.0 } else { 1.0 };
            let borders = normal.map(|n| beyond_border(n.map(|x| sign * x), cell));
            Entry {
                group: place(face).group,
                cell,
                at,
                face: i as u32,
                leaf: face.leaf,
                on_border: borders.is_some_and(|b| b.iter().any(Option::is_some)),
                flat: normal.is_some(),
                own: face.own,
                // What has no end is near to what is not far from the origin either.
                size: match normal {
                    _ if size.is_finite() => size,
                    Some(_) => magnitude.max(largest),
                    None => largest,
                },
                magnitude,
                bounds: outline(tree, face),
            }
        })
        .filter(|e| e.group != NONE && e.at.is_finite())
        .collect();
    entries.sort_unstable_by(|a, b| {
        let filed = |e: &Entry| (e.group, e.cell);
        (filed(a).cmp(&filed(b)))
            .then(a.at.total_cmp(&b.at))
            .then(a.face.cmp(&b.face))
    });
    let mut runs: Vec<Run> = Vec::new();
    for i in 0..entries.len() {
        let e = &entries[i];
        let near = i > 0 && {
            let before = &entries[i - 1];
            let room = 2.0 * NEAR * e.size.min(before.size) + ROUNDING * e.magnitude;
            (before.group, before.cell) == (e.group, e.cell) && e.at - before.at <= room
        };
        match runs.last_mut().filter(|_| near) {
            Some(run) => (run.end, run.high) = (i + 1, e.at),
            None => runs.push(Run {
                filed: (e.group, e.cell),
                low: e.at,
                high: e.at,
                start: i,
                end: i + 1,
                index: None,
            }),
        }
    }
    let mut out = Vec::new();
    let mut left = STEPS;
    let mut found = Vec::new();
    for entry in &entries {
        let (cell, at) = entry.opposite();
        let reach = 2.0 * NEAR * entry.size + ROUNDING * entry.magnitude;
        let room = NEAR * entry.size;
        let mut around = entry.bounds;
        around.min = around.min.map(|x| x - room - ROUNDING * x.abs());
        around.max = around.max.map(|x| x + room + ROUNDING * x.abs());
        let cells = match entry.on_border {
            true => {
                let face = &faces[entry.face as usize];
                cells(&face.form, !place(face).turned, cell)
            }
            false => vec![cell],
        };
        for cell in cells {
            let filed = (entry.group, cell);
            let from = runs
                .partition_point(|r| r.filed < filed || r.filed == filed && r.high < at - reach);
            for run in &mut runs[from..] {
                if run.filed != filed || run.low > at + reach {
                    break;
                }
                let steps = run.near(&entries, &around, &mut found);
                for other in found.drain(..) {
                    let other = &entries[other as usize];
                    let both_again = !entry.own && !other.own;
                    if entry.leaf < other.leaf && !both_again && (other.at - at).abs() <= reach {
                        out.push((entry.face, other.face));
                    }
                }
                match left.checked_sub(steps) {
                    Some(rest) if out.len() < PAIRS => left = rest,
                    _ => return sorted(out, faces),
                }
            }
        }
    }
    sorted(out, faces)
}

/// By the later leaf, then the earlier one, which is mostly the workpiece.
fn sorted(mut pairs: Vec<(u32, u32)>, faces: &[Face]) -> Vec<(u32, u32)> {
    let leaf = |f: u32| faces[f as usize].leaf;
    pairs.sort_unstable_by_key(|&(f, g)| (leaf(g), leaf(f), g, f));
    pairs
}

impl Run {
    /// Leaves in `out` the entries whose outlines overlap a box; says how many steps that took.
    fn near(&mut self, entries: &[Entry], around: &Aabb, out: &mut Vec<u32>) -> usize {
        let all = self.start as u32..self.end as u32;
        let overlaps = |i: &u32| entries[*i as usize].bounds.overlaps(around);
        if all.len() <= FEW {
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
        steps += index.near(around, out);
        out.retain(overlaps);
        steps
    }
}

/// A box around a face.
fn outline(tree: &Tree, face: &Face) -> Aabb {
    match &face.form {
        Form::Flat { corners, .. } if !corners.is_empty() => {
            let points = corners.iter().map(|&p| Aabb::new(p, p));
            points.fold(Aabb::EMPTY, |b, p| b.hull(&p))
        }
        _ => tree.leaves[face.leaf as usize].bounds,
    }
}
