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

/// A face in the file.
struct Entry {
    group: u32,
    cell: Cell,
    at: f64,
    face: u32,
    bounds: Aabb,
}

/// Faces of one group that lie in one plane, or in planes very near to each other.
struct Run {
    start: usize,
    end: usize,
    /// Over the entries from `start` on; made when it is first needed.
    index: Option<Boxes>,
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
            let (cell, at, _) = key(&face.form, place(face).turned);
            Entry {
                group: place(face).group,
                cell,
                at,
                face: i as u32,
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
    let magnitude = |e: &Entry| key(&faces[e.face as usize].form, false).2;
    // What has no end is near to what is not far from the origin either.
    let size = |e: &Entry| {
        let size = tree.leaves[faces[e.face as usize].leaf as usize].size;
        match faces[e.face as usize].form {
            _ if size.is_finite() => size,
            Form::Flat { .. } => magnitude(e).max(largest),
            Form::Round { .. } => largest,
        }
    };
    let mut runs: Vec<Run> = Vec::new();
    for i in 0..entries.len() {
        let e = &entries[i];
        let near = i > 0 && {
            let before = &entries[i - 1];
            let room = 2.0 * NEAR * size(e).min(size(before)) + ROUNDING * magnitude(e);
            (before.group, before.cell) == (e.group, e.cell) && e.at - before.at <= room
        };
        match runs.last_mut().filter(|_| near) {
            Some(run) => run.end = i + 1,
            None => runs.push(Run {
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
        let face = &faces[entry.face as usize];
        // Flat faces are looked for that look the other way; round ones are filed without a side.
        let turned = !place(face).turned;
        let (cell, at, magnitude) = key(&face.form, turned);
        let reach = 2.0 * NEAR * size(entry) + ROUNDING * magnitude;
        let room = NEAR * size(entry);
        let mut around = entry.bounds;
        around.min = around.min.map(|x| x - room - ROUNDING * x.abs());
        around.max = around.max.map(|x| x + room + ROUNDING * x.abs());
        for cell in cells(&face.form, turned, cell) {
            let filed = (entry.group, cell);
            let from = runs.partition_point(|r| {
                let last = &entries[r.end - 1];
                (last.group, last.cell) < filed
                    || (last.group, last.cell) == filed && last.at < at - reach
            });
            for run in &mut runs[from..] {
                let first = &entries[run.start];
                if (first.group, first.cell) != filed || first.at > at + reach {
                    break;
                }
                let steps = run.near(&entries, &around, &mut found);
                for other in found.drain(..) {
                    let other = &entries[other as usize];
                    let twin = &faces[other.face as usize];
                    let (of, to) = (face.leaf, twin.leaf);
                    if of < to && (face.own || twin.own) && (other.at - at).abs() <= reach {
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
            Boxes::new(all.clone().map(|i| (i, entries[i as usize].bounds)))
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
