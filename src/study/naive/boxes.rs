//! A binary tree of bounding boxes, in which each node is split at the median.

use crate::geometry::array::each;

/// An axis-aligned box, by its lower and upper corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds(pub [f64; 3], pub [f64; 3]);

impl Bounds {
    pub const ALL: Bounds = Bounds([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
    pub const NONE: Bounds = Bounds([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);

    pub fn is_bounded(&self) -> bool {
        self.0.iter().chain(&self.1).all(|x| x.is_finite())
    }

    pub fn around(&self, other: &Bounds) -> Bounds {
        Bounds(
            each([0, 1, 2], |i| self.0[i].min(other.0[i])),
            each([0, 1, 2], |i| self.1[i].max(other.1[i])),
        )
    }

    pub fn common(&self, other: &Bounds) -> Bounds {
        Bounds(
            each([0, 1, 2], |i| self.0[i].max(other.0[i])),
            each([0, 1, 2], |i| self.1[i].min(other.1[i])),
        )
    }

    /// The bounds, wider on each side by a billionth of the larger coordinate of the axis.
    fn padded(&self) -> Bounds {
        let pad = |i: usize| 1e-9 * self.0[i].abs().max(self.1[i].abs()).max(1e-300);
        Bounds(
            each([0, 1, 2], |i| self.0[i] - pad(i)),
            each([0, 1, 2], |i| self.1[i] + pad(i)),
        )
    }

    /// Whether a half-line may meet the bounds.
    fn meets(&self, origin: [f64; 3], direction: [f64; 3]) -> bool {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            // The rounding of the origin is padded beside that of the bounds.
            let pad = 1e-9 * origin[i].abs();
            let [a, b] = [self.0[i] - pad - origin[i], self.1[i] + pad - origin[i]];
            if direction[i] == 0.0 {
                if a > 0.0 || b < 0.0 {
                    return false;
                }
                continue;
            }
            let (a, b) = (a / direction[i], b / direction[i]);
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
        let slack = 1e-9 * (near.abs() + far.abs());
        near <= far + slack && far + slack >= 0.0
    }
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    /// The range of a leaf's items; empty for an inner node.
    items: std::ops::Range<usize>,
    /// The number of an inner node's right child. The left child comes right after the node.
    right: usize,
}

#[derive(Debug, Default)]
pub struct Boxes {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

const LEAF: usize = 3;

impl Boxes {
    pub fn new(mut all: Vec<(u32, Bounds)>) -> Boxes {
        let mut nodes: Vec<Node> = Vec::new();
        let mut pending = vec![(0..all.len(), None)];
        while let Some((range, parent)) = pending.pop() {
            if range.is_empty() {
                continue;
            }
            let here = nodes.len();
            if let Some(parent) = parent {
                let parent: &mut Node = &mut nodes[parent];
                parent.right = here;
            }
            let slice = &mut all[range.clone()];
            let bounds = slice
                .iter()
                .fold(Bounds::NONE, |b, x| b.around(&x.1))
                .padded();
            let is_leaf = slice.len() <= LEAF;
            nodes.push(Node {
                bounds,
                items: if is_leaf { range.clone() } else { 0..0 },
                right: 0,
            });
            if !is_leaf {
                let extent = |i: &usize| bounds.1[*i] - bounds.0[*i];
                let axis = (0..3)
                    .max_by(|a, b| extent(a).total_cmp(&extent(b)))
                    .unwrap_or(0);
                let middle = slice.len() / 2;
                let centre = |b: &Bounds| b.0[axis] + b.1[axis];
                slice.select_nth_unstable_by(middle, |a, b| centre(&a.1).total_cmp(&centre(&b.1)));
                pending.push((range.start + middle..range.end, Some(here)));
                pending.push((range.start..range.start + middle, None));
            }
        }
        Boxes {
            nodes,
            items: all.into_iter().map(|x| x.0).collect(),
        }
    }

    /// Calls `found` for every item whose box a half-line may meet.
    pub fn visit(&self, origin: [f64; 3], direction: [f64; 3], mut found: impl FnMut(u32)) {
        let mut pending = vec![0];
        while let Some(i) = pending.pop() {
            let Some(node) = self.nodes.get(i) else {
                continue;
            };
            if !node.bounds.meets(origin, direction) {
                continue;
            }
            match node.items.is_empty() {
                false => self.items[node.items.clone()]
                    .iter()
                    .for_each(|&x| found(x)),
                true => pending.extend([node.right, i + 1]),
            }
        }
    }
}
