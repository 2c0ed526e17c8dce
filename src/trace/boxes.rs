//! Boxes to be looked up by where they are.

use super::bounds::Bounds;
use super::bvh::Bvh;
use super::vec::Vec3;
use crate::scene::Aabb;

/// Numbered boxes: a hierarchy of those that end, and the others. Empty ones are nowhere.
pub struct Boxes {
    finite: Bvh,
    /// Of each node of the tree the one that comes after all below it.
    after: Vec<u32>,
    endless: Vec<u32>,
}

impl Boxes {
    pub fn new(all: impl Iterator<Item = (u32, Aabb)>) -> Boxes {
        let mut finite = Vec::new();
        let mut endless = Vec::new();
        for (i, b) in all.filter(|(_, b)| !b.is_empty()) {
            match b.is_finite() {
                true => finite.push((i, Bounds::new(Vec3(b.min), Vec3(b.max)))),
                false => endless.push(i),
            }
        }
        let finite = Bvh::new(finite);
        let mut after = vec![0; finite.nodes.len()];
        for (i, node) in finite.nodes.iter().enumerate().rev() {
            after[i] = match node.count {
                0 => after[node.index as usize],
                _ => i as u32 + 1,
            };
        }
        Boxes {
            finite,
            after,
            endless,
        }
    }

    /// Adds the numbers of all boxes that may overlap or touch one; says how many steps that took.
    pub fn near(&self, around: &Aabb, out: &mut Vec<u32>) -> usize {
        let steps = self.near_finite(around, out);
        out.extend_from_slice(&self.endless);
        steps + self.endless.len()
    }

    /// As [`near`](Self::near), of those that end.
    pub fn near_finite(&self, around: &Aabb, out: &mut Vec<u32>) -> usize {
        let tree = &self.finite;
        let mut steps = 0;
        let mut i = 0;
        while let Some(node) = tree.nodes.get(i) {
            steps += 1;
            let apart =
                |k: usize| around.max[k] < node.bounds.min[k] || node.bounds.max[k] < around.min[k];
            if (0..3).any(apart) {
                i = self.after[i] as usize;
                continue;
            }
            if node.count > 0 {
                let items = node.index as usize..(node.index + node.count) as usize;
                out.extend_from_slice(&tree.items[items]);
            }
            i += 1;
        }
        steps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_touches_is_near_and_what_is_empty_is_nowhere() {
        let row = (0..100u32).map(|i| {
            let x = 2.0 * f64::from(i);
            (i, Aabb::new([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]))
        });
        let others = [
            (100, Aabb::new([0.0; 3], [f64::INFINITY; 3])),
            (101, Aabb::EMPTY),
        ];
        let boxes = Boxes::new(row.chain(others));
        let around = Aabb::new([41.0, 0.5, 1.0], [44.0, 0.5, 3.0]);
        let mut near = Vec::new();
        let steps = boxes.near(&around, &mut near);
        // A leaf's boxes come together; the tree is no deeper than its halves.
        assert!(
            [20, 21, 22, 100].iter().all(|i| near.contains(i)),
            "{near:?}"
        );
        assert!(
            near.len() <= 16 && !near.contains(&101) && steps < 40,
            "{near:?}, {steps}"
        );
        near.clear();
        boxes.near_finite(&Aabb::new([0.0, 1.5, 0.0], [9.0, 2.0, 1.0]), &mut near);
        assert!(near.is_empty());
    }
}
