//! A bounding volume hierarchy over boxes.

use super::aabb::Aabb;
use super::array::each;
use crate::parallel;
use std::ops::ControlFlow;

/// The most boxes in one leaf.
const LEAF: usize = 4;
/// The number of bins of the surface area heuristic.
const BINS: usize = 16;
/// The numbers of boxes for which the two halves are built on two threads. With more boxes, their nodes would take too
/// much memory while they are put together.
const SHARED: std::ops::RangeInclusive<usize> = 1024..=131_072;

#[derive(Debug, Clone, Copy)]
pub struct Node {
    pub bounds: Aabb,
    /// For an inner node (`count` = 0), the index of its right child; the left child is the next node. For a leaf, the
    /// place in [`Bvh::items`] where its items begin.
    pub index: u32,
    pub count: u32,
}

/// Nodes in depth-first order, the root first; no nodes where there are no items.
#[derive(Debug, Default)]
pub struct Bvh {
    pub nodes: Vec<Node>,
    pub items: Vec<u32>,
}

impl Bvh {
    /// Builds the tree over items with finite boxes: binned surface area heuristic along the axis
    /// in which the centres spread most (Wald, "On fast Construction of SAH-based Bounding Volume
    /// Hierarchies", 2007).
    pub fn new(boxes: Vec<(u32, Aabb)>) -> Bvh {
        Bvh::with_leaves(boxes, LEAF)
    }

    /// [`new`](Self::new) with at most `leaf` boxes in one leaf, unless they all have the same centre.
    pub fn with_leaves(mut boxes: Vec<(u32, Aabb)>, leaf: usize) -> Bvh {
        // Asking for the number of threads may start them, so it is asked only where they are used.
        let threads = match SHARED.contains(&boxes.len()) {
            true => parallel::threads(),
            false => 1,
        };
        // At least twice as many pieces as threads, since they take different times.
        let forks = match threads {
            1 => 0,
            threads => threads.next_power_of_two().ilog2() + 1,
        };
        let mut nodes = nodes_shared(&mut boxes, 0, leaf, forks);
        nodes.shrink_to_fit();
        Bvh {
            nodes,
            items: boxes.into_iter().map(|b| b.0).collect(),
        }
    }

    /// Calls `found` for every item whose box overlaps or touches the box `around`, and for some of their neighbours,
    /// in the order of the tree, until `found` stops the visit.
    pub fn visit(
        &self,
        around: &Aabb,
        found: impl FnMut(u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.visit_below(around, |_| true, found)
    }

    /// [`visit`](Self::visit), but only at and below the nodes that `wanted` accepts.
    pub fn visit_below(
        &self,
        around: &Aabb,
        mut wanted: impl FnMut(u32) -> bool,
        mut found: impl FnMut(u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut pending = vec![0u32];
        while let Some(i) = pending.pop() {
            let Some(node) = self.nodes.get(i as usize) else {
                continue;
            };
            if !wanted(i) || !node.bounds.overlaps(around) {
                continue;
            }
            if node.count > 0 {
                let start = node.index as usize;
                let items = &self.items[start..start + node.count as usize];
                items.iter().try_for_each(|&j| found(j))?;
            } else {
                pending.extend([node.index, i + 1]);
            }
        }
        ControlFlow::Continue(())
    }
}

/// Builds the nodes of a part of all boxes, which begins there at the index `first`. The two halves are built at the
/// same time, on `forks` levels.
fn nodes_shared(boxes: &mut [(u32, Aabb)], first: usize, leaf: usize, forks: u32) -> Vec<Node> {
    let middle = (forks > 0 && SHARED.contains(&boxes.len())).then(|| split(boxes));
    let Some(middle) = middle.flatten() else {
        return nodes_of(boxes, first, leaf);
    };
    let bounds = hull(boxes);
    let (left, right) = boxes.split_at_mut(middle);
    let (left, right) = parallel::both(
        || nodes_shared(left, first, leaf, forks - 1),
        || nodes_shared(right, first + middle, leaf, forks - 1),
    );
    let mut nodes = Vec::with_capacity(1 + left.len() + right.len());
    nodes.push(Node {
        bounds,
        index: 1 + left.len() as u32,
        count: 0,
    });
    for half in [left, right] {
        let before = nodes.len() as u32;
        nodes.extend(half.into_iter().map(|n| match n.count {
            0 => Node {
                index: before + n.index,
                ..n
            },
            _ => n,
        }));
    }
    nodes
}

/// Builds the nodes of a part of all boxes, which begins there at the index `first`. There is no recursion, since equal
/// boxes can make any tree deep.
fn nodes_of(boxes: &mut [(u32, Aabb)], first: usize, leaf: usize) -> Vec<Node> {
    let mut nodes: Vec<Node> = Vec::with_capacity(boxes.len());
    // The ranges of `boxes` that have no nodes yet, each with the parent whose right child it is.
    let mut pending = vec![(0, boxes.len(), None)];
    while let Some((start, end, parent)) = pending.pop() {
        let slice = &mut boxes[start..end];
        if slice.is_empty() {
            continue;
        }
        if let Some(parent) = parent {
            let here = nodes.len() as u32;
            let node: &mut Node = &mut nodes[parent as usize];
            node.index = here;
        }
        let bounds = hull(slice);
        let here = nodes.len() as u32;
        let middle = (slice.len() > leaf).then(|| split(slice)).flatten();
        nodes.push(Node {
            bounds,
            index: (first + start) as u32,
            count: if middle.is_some() {
                0
            } else {
                (end - start) as u32
            },
        });
        if let Some(middle) = middle {
            pending.push((start + middle, end, Some(here)));
            pending.push((start, start + middle, None));
        }
    }
    nodes
}

#[inline]
fn hull(boxes: &[(u32, Aabb)]) -> Aabb {
    boxes.iter().fold(Aabb::EMPTY, |b, x| grown(b, &x.1))
}

/// [`Aabb::hull`] without a test for empty boxes. Of these, only [`Aabb::EMPTY`] itself is allowed.
#[inline]
fn grown(b: Aabb, other: &Aabb) -> Aabb {
    let less = |a: f64, b: f64| if a < b { a } else { b };
    let more = |a: f64, b: f64| if a > b { a } else { b };
    Aabb {
        min: each([0, 1, 2], |i| less(other.min[i], b.min[i])),
        max: each([0, 1, 2], |i| more(other.max[i], b.max[i])),
    }
}

/// Divides the boxes into two parts and returns the index where the second one begins. `None` if all centres agree.
fn split(boxes: &mut [(u32, Aabb)]) -> Option<usize> {
    let mut centres = Aabb::EMPTY;
    for (_, b) in boxes.iter() {
        let c = b.centre();
        centres = grown(centres, &Aabb::new(c, c));
    }
    let extent = centres.extent();
    let axis = (0..3).fold(0, |a, i| if extent[i] > extent[a] { i } else { a });
    let scale = BINS as f64 / extent[axis];
    if extent[axis] <= 0.0 || !scale.is_finite() {
        return None;
    }
    if let [a, b] = boxes {
        if b.1.centre()[axis] < a.1.centre()[axis] {
            boxes.swap(0, 1);
        }
        return Some(1);
    }
    let low = centres.min[axis];
    let bin = |b: &Aabb| (((b.centre()[axis] - low) * scale) as usize).min(BINS - 1);

    let mut bins = [(0usize, Aabb::EMPTY); BINS];
    for (_, b) in boxes.iter() {
        let slot = &mut bins[bin(b)];
        slot.0 += 1;
        slot.1 = grown(slot.1, b);
    }
    // The number and the cost of the boxes on one side of each cut, swept from either end.
    let sweep = |bins: &mut dyn Iterator<Item = &(usize, Aabb)>| {
        let mut all = (0, Aabb::EMPTY);
        let mut costs = [(0, 0.0); BINS];
        for (slot, bin) in costs.iter_mut().zip(bins) {
            all = (all.0 + bin.0, grown(all.1, &bin.1));
            *slot = (all.0, all.0 as f64 * all.1.half_area());
        }
        costs
    };
    let lefts = sweep(&mut bins.iter());
    let rights = sweep(&mut bins.iter().rev());
    let mut best = (f64::INFINITY, 0);
    for cut in 1..BINS {
        let (left, right) = (lefts[cut - 1], rights[BINS - 1 - cut]);
        if left.0 > 0 && right.0 > 0 && left.1 + right.1 < best.0 {
            best = (left.1 + right.1, cut);
        }
    }
    if best.1 == 0 {
        return None;
    }
    let mut middle = 0;
    for i in 0..boxes.len() {
        if bin(&boxes[i].1) < best.1 {
            boxes.swap(i, middle);
            middle += 1;
        }
    }
    Some(middle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::random;

    #[test]
    fn a_tree_is_the_same_however_many_threads_build_it() {
        let mut next = random();
        let boxes: Vec<(u32, Aabb)> = (0..20_000)
            .map(|i| {
                let least: [f64; 3] = std::array::from_fn(|_| next(100) as f64);
                (i, Aabb::new(least, least.map(|x| x + (1 + next(3)) as f64)))
            })
            .collect();
        for leaf in [1, LEAF] {
            let (mut one, mut many) = (boxes.clone(), boxes.clone());
            let alone = nodes_of(&mut one, 0, leaf);
            let shared = nodes_shared(&mut many, 0, leaf, 4);
            assert!(one.iter().map(|b| b.0).eq(many.iter().map(|b| b.0)));
            assert_eq!(format!("{alone:?}"), format!("{shared:?}"));
        }
    }
}
