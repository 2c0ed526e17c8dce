//! Bundles: the blocks that many rays may meet if they go nearly the same way.

use super::lanes::LANES;
use super::packet::REL_ROOM;
use super::stage::Stage;
use crate::geometry::aabb::Aabb;
use crate::geometry::shaft::Shaft;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Child, Is, WIDTH as CHILDREN};

/// A block that some ray of a bundle may meet.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// A lower bound on the t at which any ray of the bundle meets the block.
    pub near: f64,
    pub block: u32,
    pub bounds: Aabb,
}

/// The blocks on the way of the rays of a bundle.
#[derive(Debug, Default)]
pub struct Along {
    pub candidates: Vec<Candidate>,
    /// The number of box tests that the walk through the tree has made.
    pub boxes: u32,
    /// For each of four rays to a lamp, the numbers of the blocks that the ray may meet: see
    /// [`Stage::shadows_of_four`].
    pub blocks: [Vec<u32>; LANES],
    pending: Vec<Child>,
}

/// The least number of rays that are treated as a bundle.
pub const BUNDLE_MIN_RAYS: usize = 8;

/// The least box around some points.
#[derive(Clone, Copy)]
pub struct Around {
    min: [f64; 3],
    max: [f64; 3],
}

impl Around {
    pub const NOTHING: Around = Around {
        min: [f64::INFINITY; 3],
        max: [f64::NEG_INFINITY; 3],
    };

    #[inline(always)]
    pub fn add(&mut self, point: [f64; 3]) {
        let ends = self.min.iter_mut().zip(&mut self.max);
        for ((min, max), x) in ends.zip(point) {
            (*min, *max) = (min.min(x), max.max(x));
        }
    }

    /// The length of the longest side.
    #[inline(always)]
    pub fn spread(&self) -> f64 {
        (0..3).fold(0.0, |most, i| f64::max(most, self.max[i] - self.min[i]))
    }

    pub fn bounds(&self) -> Aabb {
        Aabb {
            min: self.min,
            max: self.max,
        }
    }
}

/// The most blocks on the way, and the most nodes of the tree. With more, each ray is quicker by itself.
const MAX_BUNDLE_BLOCKS: usize = 24;
const MAX_BUNDLE_NODES: u32 = 48;

impl Along {
    /// Finds the blocks that the rays of a bundle may meet before t = `to`; `false` if it does not pay to share them.
    /// All rays start in the box `start`, whose two corners move by `steps` as t grows by 1: see [`Shaft::new`].
    pub fn find(&mut self, stage: &Stage, start: &Aabb, steps: [Vec3; 2], to: f64) -> bool {
        let forest = &stage.all;
        let Some(shaft) = Shaft::new(start, steps, &forest.frame) else {
            return false;
        };
        self.candidates.clear();
        self.boxes = 0;
        self.pending.clear();
        let loose = forest.loose.iter().map(|&block| Candidate {
            near: f64::NEG_INFINITY,
            block,
            bounds: Aabb::ALL,
        });
        self.candidates.extend(loose);
        if !forest.tree.nodes.is_empty() {
            self.pending.push(Child::ROOT);
        }
        let ends = [0.0, shaft.pace(to)];
        let mut nodes = 0;
        while let Some(child) = self.pending.pop() {
            let Is::Node(node) = child.is() else { continue };
            nodes += 1;
            self.boxes += CHILDREN as u32;
            let node = &forest.tree.nodes[node as usize];
            let (mut met, near) = shaft.meets(node, ends);
            while met != 0 {
                let slot = met.trailing_zeros() as usize % CHILDREN;
                met &= met - 1;
                match node.children[slot].is() {
                    Is::Node(_) => self.pending.push(node.children[slot]),
                    Is::Item(block) => {
                        let bounds = &stage.blocks[block as usize].bounds;
                        let room = REL_ROOM * bounds.reach().max(start.reach());
                        let room = Vec3::ONE * room;
                        self.candidates.push(Candidate {
                            near: shaft.unpace(near[slot]),
                            block,
                            bounds: Aabb::new(Vec3(bounds.min) - room, Vec3(bounds.max) + room),
                        });
                    }
                }
            }
            if nodes > MAX_BUNDLE_NODES || self.candidates.len() > MAX_BUNDLE_BLOCKS {
                return false;
            }
        }
        (self.candidates).sort_unstable_by(|a, b| a.near.total_cmp(&b.near));
        true
    }
}
