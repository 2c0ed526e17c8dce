//! What many rays that go nearly the same way may meet.

use super::cull::in_box;
use super::lanes::{LANES, Lanes, V3, gathered, is_greater, lanes_where};
use super::leaf::Kind;
use super::query::{SKINS, Start};
use super::stage::Stage;
use crate::geometry::aabb::Aabb;
use crate::geometry::array::each;
use crate::geometry::shaft::Shaft;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Child, Is, WIDTH as CHILDREN};

/// A block that some ray of a bundle may meet.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    /// A bound from below on the t at which a ray meets it.
    near: f64,
    block: u32,
    bounds: Aabb,
}

/// Blocks that a ray may meet, the nearest first, with bounds from below on the t at which it does.
pub type Blocks = [(f64, u32)];

/// The blocks on the way of the rays of a bundle.
#[derive(Debug, Default)]
pub struct Along {
    candidates: Vec<Candidate>,
    /// Box tests that have been made.
    pub boxes: u32,
    /// For each of four rays: see [`part`](Self::part).
    pub blocks: [Vec<(f64, u32)>; LANES],
    pending: Vec<Child>,
}

/// Four rays of a bundle.
#[derive(Debug, Clone, Copy)]
pub struct Rays {
    /// Those that are asked for, as bits.
    pub live: u32,
    pub origin: V3,
    pub direction: V3,
    /// In t, how far behind a start something is that may be taken for it.
    pub before: Lanes,
    /// See [`Start::left`](super::query::Start::left).
    pub left: [u32; LANES],
    /// Those that do not go against the normal of the surface that they start on, as bits.
    pub outwards: u32,
    /// Those that are asked only whether anything opaque is on their way, as bits.
    pub shadow: u32,
}

impl Rays {
    #[inline(always)]
    pub fn new(starts: [&Start; LANES], live: u32, is_shadow: bool) -> Rays {
        let direction = V3::gathered(starts, |start| &start.direction);
        let skin = gathered(starts, |start| start.skin * SKINS);
        Rays {
            live,
            origin: V3::gathered(starts, |start| &start.origin),
            direction,
            before: skin / direction.abs().max_component(),
            left: each(starts, |start| start.left),
            outwards: lanes_where(|lane| !starts[lane].goes_in),
            shadow: lanes_where(|lane| is_shadow && starts[lane].within.is_empty()),
        }
    }
}

/// Fewer rays are no bundle.
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

    /// The greatest side.
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

/// With more blocks than this on the way, or more nodes, each ray is quicker by itself.
const MAX_BUNDLE_BLOCKS: usize = 24;
const MAX_BUNDLE_NODES: u32 = 48;
/// Boxes are wider by this part of all coordinates: far more than what is rounded.
const REL_ROOM: f64 = 1e-12;

impl Along {
    /// Finds the blocks that rays of a bundle may meet up to some t; whether that pays. The rays start in a box, whose
    /// corners move by these steps with t: see [`Shaft::new`].
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

    /// Finds those of the blocks that four rays of the bundle may meet up to some t, into [`blocks`](Self::blocks).
    /// Returns, as bits, the rays to lamps that surely go through something opaque that is near nothing transparent; what
    /// these may meet is not complete.
    #[inline(always)]
    pub fn part(&mut self, stage: &Stage, rays: &Rays, to: f64) -> u32 {
        let mut dark = 0;
        self.blocks.iter_mut().for_each(Vec::clear);
        if self.candidates.is_empty() {
            return dark;
        }
        let splat = Lanes::splat;
        let &Rays {
            live,
            origin,
            direction,
            before,
            left,
            outwards,
            shadow,
        } = rays;
        let inverse = V3(each(direction.0, |d| splat(1.0) / d));
        for candidate in &self.candidates {
            let [near, far] = in_box(&candidate.bounds, origin, inverse, [-before, splat(to)]);
            // Written so that NaN counts as met.
            let misses = is_greater(near, far * splat(1.0 + REL_ROOM)).to_bitmask();
            let mut met = live & !misses & !dark;
            let block = &stage.blocks[candidate.block as usize];
            let mut beside = met;
            for (cull, &leaf) in block.culls.iter().zip(&block.leaves) {
                let leaf = &stage.leaves[leaf as usize];
                let starts_here = lanes_where(|lane| left[lane] == leaf.twin);
                // What is convex is not met again by a ray that leaves it.
                let leaves_it = match leaf.kind == Kind::Quadric || leaf.is_convex {
                    true => starts_here & outwards,
                    false => 0,
                };
                if (beside | (met & shadow & !dark)) & !leaves_it == 0 {
                    continue;
                }
                let passing = cull.passing(origin, direction, before, to);
                beside &= passing.beside | leaves_it;
                if leaf.is_lone && !leaf.is_clear {
                    dark |= met & shadow & passing.through & !starts_here;
                }
            }
            if !block.culls.is_empty() {
                met &= !beside;
            }
            while met != 0 {
                let lane = met.trailing_zeros() as usize % LANES;
                met &= met - 1;
                self.blocks[lane].push((candidate.near, candidate.block));
            }
        }
        dark
    }
}
