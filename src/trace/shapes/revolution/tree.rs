//! A hierarchy over a long profile: runs of consecutive pieces, boxed in (ρ, y).

use super::overlap_removal::Subsegment;

/// Pieces in one leaf, at most 32.
const LEAF: usize = 12;

/// A run of consecutive pieces.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Run {
    /// The pieces `first .. end`.
    pub first: u32,
    pub end: u32,
    /// The run to go on with if no piece of this run matters: the first run that begins at `end` or later.
    pub next: u32,
    /// Lowest and highest distance from the axis.
    pub radius: [f64; 2],
    pub y: [f64; 2],
}

impl Run {
    pub(super) fn is_leaf(&self) -> bool {
        (self.end - self.first) as usize <= LEAF
    }

    /// The mask of all pieces of a leaf, a bit each from the lowest.
    pub(super) fn all(&self) -> u32 {
        u32::MAX >> (u32::BITS - (self.end - self.first))
    }

    fn join(&mut self, radius: [f64; 2], y: [f64; 2]) {
        for (mine, other) in [(&mut self.radius, radius), (&mut self.y, y)] {
            *mine = [mine[0].min(other[0]), mine[1].max(other[1])];
        }
    }
}

/// The leaves of a tree with their indices, without the leaves in runs for which `misses` holds.
pub(super) fn leaves(
    tree: &[Run],
    mut misses: impl FnMut(usize, &Run) -> bool,
) -> impl Iterator<Item = (usize, &Run)> {
    let mut next = 0;
    std::iter::from_fn(move || {
        while let Some(run) = tree.get(next) {
            let here = next;
            if misses(here, run) {
                next = run.next as usize;
                continue;
            }
            next += 1;
            if run.is_leaf() {
                return Some((here, run));
            }
        }
        None
    })
}

/// The tree over the pieces between points, in preorder: runs are halved until they are leaves.
pub(super) fn build(points: &[[f64; 2]], pieces: &[Subsegment]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    // Runs whose `next` is not known yet, the innermost last.
    let mut open: Vec<usize> = Vec::new();
    let mut pending = vec![(0, pieces.len() as u32)];
    while let Some((first, end)) = pending.pop() {
        if first == end {
            continue;
        }
        let here = runs.len();
        while let Some(&last) = open.last()
            && runs[last].end <= first
        {
            runs[last].next = here as u32;
            open.pop();
        }
        let run = Run {
            first,
            end,
            next: 0,
            radius: [f64::INFINITY, f64::NEG_INFINITY],
            y: [f64::INFINITY, f64::NEG_INFINITY],
        };
        if !run.is_leaf() {
            let middle = first + (end - first) / 2;
            pending.push((middle, end));
            pending.push((first, middle));
        }
        open.push(here);
        runs.push(run);
    }
    for last in open {
        runs[last].next = runs.len() as u32;
    }
    for i in (0..runs.len()).rev() {
        let (first, end) = (runs[i].first as usize, runs[i].end as usize);
        if runs[i].is_leaf() {
            for point in pieces[first..end].iter().flat_map(|p| [p.from, p.to]) {
                let p = points[point as usize];
                runs[i].join([p[0]; 2], [p[1]; 2]);
            }
        } else {
            let right = runs[i + 1].next as usize;
            for child in [i + 1, right] {
                let (radius, y) = (runs[child].radius, runs[child].y);
                runs[i].join(radius, y);
            }
        }
    }
    runs
}
