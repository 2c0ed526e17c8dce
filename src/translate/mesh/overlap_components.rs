//! Groups of boxes that overlap: the connected components of their overlaps.

use std::ops::ControlFlow;

use crate::geometry::Aabb;
use crate::geometry::bvh::Bvh;

/// Groups of boxes that are connected by overlaps, and the tree of all boxes.
pub(super) struct OverlapComponents {
    /// A tree whose items are the indices of the boxes. Items that follow each other are near each other in space.
    pub tree: Bvh,
    /// For each box the number of its component, from 0.
    pub numbers: Vec<u32>,
    pub count: usize,
}

/// The number of a component that is not known yet.
const NONE: u32 = u32::MAX;

impl OverlapComponents {
    pub(super) fn of(boxes: &[Aabb]) -> OverlapComponents {
        let tree = tree(boxes);
        let mut left = Left::of(&tree, boxes.len());
        let mut numbers = vec![NONE; boxes.len()];
        let (mut count, mut pending, mut found) = (0, Vec::new(), Vec::new());
        for &first in &tree.items {
            if numbers[first as usize] != NONE {
                continue;
            }
            found.push(first);
            loop {
                // A box that has a component is not looked at again, so each box is found once.
                for i in found.drain(..) {
                    numbers[i as usize] = count;
                    left.take(i);
                    pending.push(i);
                }
                let Some(i) = pending.pop() else {
                    break;
                };
                let b = &boxes[i as usize];
                let _ = tree.visit_below(
                    b,
                    |node| left.nodes[node as usize] > 0,
                    |j| {
                        if numbers[j as usize] == NONE && b.overlaps(&boxes[j as usize]) {
                            found.push(j);
                        }
                        ControlFlow::Continue(())
                    },
                );
            }
            count += 1;
        }
        OverlapComponents {
            tree,
            numbers,
            count: count as usize,
        }
    }
}

/// How many boxes without a component there are below each node of a tree.
struct Left {
    nodes: Vec<u32>,
    /// The parent of each node; the root is its own.
    parents: Vec<u32>,
    /// For each box the node that it is in.
    leaves: Vec<u32>,
}

impl Left {
    fn of(tree: &Bvh, boxes: usize) -> Left {
        let n = tree.nodes.len();
        let (mut nodes, mut parents, mut leaves) = (vec![0; n], vec![0; n], vec![0; boxes]);
        // A node stands before its children, so the counts are added up from the end.
        for i in (0..n as u32).rev() {
            let node = &tree.nodes[i as usize];
            if node.count > 0 {
                nodes[i as usize] = node.count;
                let start = node.index as usize;
                for &item in &tree.items[start..start + node.count as usize] {
                    leaves[item as usize] = i;
                }
            } else {
                for child in [i + 1, node.index] {
                    nodes[i as usize] += nodes[child as usize];
                    parents[child as usize] = i;
                }
            }
        }
        Left {
            nodes,
            parents,
            leaves,
        }
    }

    fn take(&mut self, item: u32) {
        let mut node = self.leaves[item as usize];
        loop {
            self.nodes[node as usize] -= 1;
            if node == 0 {
                return;
            }
            node = self.parents[node as usize];
        }
    }
}

pub(super) fn tree(boxes: &[Aabb]) -> Bvh {
    let numbered = boxes.iter().enumerate();
    Bvh::new(numbered.map(|(i, b)| (i as u32, *b)).collect())
}

#[cfg(test)]
mod tests {
    use super::super::union_find::UnionFind;
    use super::*;

    #[test]
    fn crowds_are_what_pairs_make() {
        // Boxes all over a cube, some of them large: a sequence that looks random.
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1u32 << 24)
        };
        for (n, size) in [(0, 1.0), (1, 1.0), (300, 0.05), (300, 0.1), (300, 0.5)] {
            let boxes: Vec<Aabb> = (0..n)
                .map(|_| {
                    let corner = [next(), next(), next()];
                    let size = size * next();
                    Aabb::new(corner, corner.map(|x| x + size))
                })
                .collect();
            let mut sets = UnionFind::new(n);
            for i in 0..n {
                for j in 0..i {
                    if boxes[i].overlaps(&boxes[j]) {
                        sets.join(i as u32, j as u32);
                    }
                }
            }
            let components = OverlapComponents::of(&boxes);
            for i in 0..n {
                for j in 0..i {
                    let together = sets.find(i as u32) == sets.find(j as u32);
                    assert_eq!(together, components.numbers[i] == components.numbers[j]);
                }
            }
            let most = components.numbers.iter().max().map_or(0, |m| m + 1);
            assert_eq!(components.count, most as usize);
        }
    }
}
