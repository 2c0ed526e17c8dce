//! Boxes that are looked up by their places.

use super::aabb::Aabb;
use super::bvh::Bvh;
use std::ops::ControlFlow;

/// Numbered boxes: a hierarchy of the finite ones, and a list of the infinite ones. Empty boxes are left out.
pub struct Boxes {
    finite: Bvh,
    endless: Vec<u32>,
}

impl Boxes {
    pub fn new(all: impl Iterator<Item = (u32, Aabb)>) -> Boxes {
        let all = all.filter(|(_, b)| !b.is_empty());
        let (finite, endless): (Vec<_>, Vec<_>) = all.partition(|(_, b)| b.is_finite());
        Boxes {
            finite: Bvh::new(finite),
            endless: endless.into_iter().map(|(i, _)| i).collect(),
        }
    }

    /// Adds to `out` the numbers of all boxes that may overlap or touch the box `around`. Returns the number of steps.
    pub fn near(&self, around: &Aabb, out: &mut Vec<u32>) -> usize {
        let steps = self.near_finite(around, out);
        out.extend_from_slice(&self.endless);
        steps + self.endless.len()
    }

    /// [`near`](Self::near) for the finite boxes alone. Returns the number of steps.
    pub fn near_finite(&self, around: &Aabb, out: &mut Vec<u32>) -> usize {
        let mut steps = 0;
        let step = |_| {
            steps += 1;
            true
        };
        let _: ControlFlow<()> = self.finite.visit_below(around, step, |i| {
            out.push(i);
            ControlFlow::Continue(())
        });
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
