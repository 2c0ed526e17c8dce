//! What a ray meets first, and how much light gets by.

use super::leaf::{Kind, Leaf};
use super::probe::{Chords, Probe};
use super::stage::{Block, Shapes, Stage};
use super::{cuboid, plane};
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH};

/// No leaf: there is nothing.
pub const NONE: u32 = u32::MAX;
/// No leaf: the kernel does not know.
pub const DOUBT: u32 = u32::MAX - 1;

/// A ray, and what it knows about where it starts.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    /// A bound on the distance of the origin from the surface that it is on.
    pub skin: f64,
    /// The leaf whose surface that is, or [`NONE`].
    pub left: u32,
    /// The leaf that the ray starts in, or [`NONE`].
    pub within: u32,
}

/// Tests, counted.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tests {
    pub boxes: u32,
    pub shapes: u32,
}

/// What light of a lamp does.
#[derive(Debug, Clone, Copy)]
pub enum Light {
    /// It is seen, with this share of it left.
    Seen(Vec3),
    Dark,
    /// The kernel does not know.
    Doubtful,
}

/// What is kept from one search to the next.
#[derive(Debug, Default)]
pub struct Scratch {
    /// What is still to be visited, with bounds from below on where it is met.
    pending: Vec<(f32, Child)>,
    /// Transparent solids on the way: where they begin, how many of their faces count, and which they are.
    passed: Vec<(f64, u32, u32)>,
}

/// A skin tells places apart that are farther from each other than this many of it: the root of the unit roundoff, and a
/// little.
const SKINS: f64 = 1.2e8;
/// A little more than what [`Walker::rough`](crate::trace::search::walk::Walker::rough) says of surfaces that bend away.
const BENT: f64 = 9e-7;
/// The end of rays to lamps: see [`AT_LAMP`](crate::trace::precision::Precision::AT_LAMP).
const TO: f64 = 1.0 - 1.0 / (1u64 << 27) as f64;
/// Transparent solids on the way to a lamp at most.
const PASSED: usize = 64;

/// One end of a chord, with a bound on its error.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    error: f64,
}

impl Stage<'_> {
    /// A ray in the space of a placement, kept in `moved` where that is another one.
    #[inline(always)]
    fn placed<'p>(&self, probe: &'p Probe, placement: u32, moved: &'p mut Probe) -> &'p Probe {
        if placement == 0 {
            return probe;
        }
        *moved = probe.through(&self.placements[placement as usize].back);
        moved
    }

    /// With a bound on the error.
    #[inline(always)]
    fn rough(&self, probe: &Probe, leaf: &Leaf, t: f64, is_near: bool) -> End {
        let error = match leaf.kind {
            Kind::Sphere => BENT * ((probe.reach + leaf.extent) * probe.per_pace + t.abs()),
            Kind::Cuboid => cuboid::rough(probe, &leaf.numbers, leaf.extent, t, is_near),
            Kind::Plane | Kind::HalfSpace => plane::rough(probe, *leaf.first(), leaf.extent, t),
            Kind::Rectangle => {
                let size = probe.reach + leaf.extent + t.abs() * probe.pace;
                cuboid::SHARE * size / probe.direction[2].abs()
            }
        };
        End { t, error }
    }

    /// The leaf that a ray meets first.
    #[inline(always)]
    pub fn first(&self, start: &Start, scratch: &mut Scratch, tests: &mut Tests) -> u32 {
        if start.within != NONE {
            return start.within;
        }
        let probe = Probe::new(start.origin, start.direction);
        // A direction of unit length.
        let skin = start.skin * SKINS;
        let (mut found, mut best) = (
            NONE,
            End {
                t: f64::INFINITY,
                error: 0.0,
            },
        );
        // The least t of all that is not the nearest, and as far as what may be as near goes.
        let (mut second, mut limit) = (f64::INFINITY, f64::INFINITY);
        let beam = self.beam(start);
        self.begin(scratch);
        let mut next = None;
        while let Some((near, child)) = next.take().or_else(|| scratch.pending.pop()) {
            let most = beam.pace(limit);
            if near > most {
                continue;
            }
            let block = match child.is() {
                Is::Node(node) => {
                    tests.boxes += WIDTH as u32;
                    let base = scratch.pending.len();
                    next = beam.first(
                        &self.tree.nodes[node as usize],
                        [0.0, most],
                        |near, child| {
                            let pending = &mut scratch.pending;
                            let mut at = pending.len();
                            pending.push((near, child));
                            while at > base && pending[at - 1].0 < near {
                                pending[at] = pending[at - 1];
                                at -= 1;
                            }
                            pending[at] = (near, child);
                        },
                    );
                    continue;
                }
                Is::Item(block) => &self.blocks[block as usize],
            };
            tests.shapes += 1;
            let mut moved = Probe::NONE;
            let probe = self.placed(&probe, block.placement, &mut moved);
            let from = -(skin + BENT * ((probe.reach + block.extent) * probe.per_pace + 1.0));
            let chords = block.chords(probe, from, limit);
            let mut maybe = chords.maybe;
            while maybe != 0 {
                let lane = maybe.trailing_zeros() as usize % 4;
                maybe &= maybe - 1;
                let number = block.leaves[lane];
                if number == start.left {
                    continue;
                }
                let leaf = &self.leaves[number as usize];
                if chords.sure >> lane & 1 == 0 {
                    return DOUBT;
                }
                let out = self.rough(probe, leaf, chords.far[lane], false);
                if out.t < -(skin + out.error) {
                    continue;
                }
                let end = self.rough(probe, leaf, chords.near[lane], true);
                let is_ahead = end.t > skin + end.error;
                if !is_ahead {
                    return DOUBT;
                }
                if end.t < best.t {
                    second = second.min(best.t - best.error);
                    (best, found) = (end, number);
                    limit = best.t + 2.0 * best.error;
                } else {
                    second = second.min(end.t - end.error);
                }
            }
        }
        if found == NONE {
            return NONE;
        }
        let leaf = &self.leaves[found as usize];
        if second <= limit || (leaf.is_clear && !leaf.is_lone) {
            return DOUBT;
        }
        found
    }

    /// Puts all that there is on the stack.
    #[inline(always)]
    fn begin(&self, scratch: &mut Scratch) {
        scratch.pending.clear();
        if !self.tree.nodes.is_empty() {
            scratch.pending.push((0.0, Child::ROOT));
        }
        for &block in &self.loose {
            scratch.pending.push((0.0, Child::item(block)));
        }
    }

    #[inline(always)]
    fn beam(&self, start: &Start) -> Beam {
        Beam::new(
            &Line::new(Vec3(start.origin), Vec3(start.direction)),
            &self.frame,
        )
    }

    /// The share of light that gets along a ray to a lamp at t = 1. `last` is the block that was in the way of the light
    /// before.
    #[inline(always)]
    pub fn light(
        &self,
        start: &Start,
        last: &mut u32,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Light {
        let probe = Probe::new(start.origin, start.direction);
        // In units of the way, which is no longer than 1.8 times its largest component.
        let skin = start.skin * SKINS * probe.per_pace;
        scratch.passed.clear();
        if start.within != NONE {
            let leaf = &self.leaves[start.within as usize];
            let mut moved = Probe::NONE;
            let probe = self.placed(&probe, leaf.placement, &mut moved);
            match self.way_out(probe, leaf, skin) {
                Some(out) if out.t + out.error < TO => scratch.passed.push((-1.0, 1, start.within)),
                Some(out) if out.t - out.error > TO => {}
                _ => return Light::Doubtful,
            }
        }
        let beam = self.beam(start);
        let ends = [0.0, beam.pace(1.0)];
        self.begin(scratch);
        if !self.has_glass && *last != NONE {
            scratch.pending.push((0.0, Child::item(*last)));
        }
        let mut next = None;
        while let Some((_, child)) = next.take().or_else(|| scratch.pending.pop()) {
            let number = match child.is() {
                Is::Node(node) => {
                    tests.boxes += WIDTH as u32;
                    next = beam.first(&self.tree.nodes[node as usize], ends, |near, child| {
                        scratch.pending.push((near, child));
                    });
                    continue;
                }
                Is::Item(number) => number,
            };
            let block = &self.blocks[number as usize];
            tests.shapes += 1;
            let mut moved = Probe::NONE;
            let probe = self.placed(&probe, block.placement, &mut moved);
            let hair = BENT * 2.0 * ((probe.reach + block.extent) * probe.per_pace + 1.0);
            let chords = block.chords(probe, -(skin + hair), 1.0 + hair);
            let mut maybe = chords.maybe;
            while maybe != 0 {
                let lane = maybe.trailing_zeros() as usize % 4;
                maybe &= maybe - 1;
                let leaf = block.leaves[lane];
                if leaf == start.left || leaf == start.within {
                    continue;
                }
                let (own, leaf) = (leaf, &self.leaves[leaf as usize]);
                if chords.sure >> lane & 1 == 0 {
                    return Light::Doubtful;
                }
                let out = self.rough(probe, leaf, chords.far[lane], false);
                if out.t < -(skin + out.error) {
                    continue;
                }
                let end = self.rough(probe, leaf, chords.near[lane], true);
                if end.t - end.error > TO {
                    continue;
                }
                if !(end.t > skin + end.error && end.t + end.error < TO) {
                    return Light::Doubtful;
                }
                if !leaf.is_clear {
                    *last = number;
                    return Light::Dark;
                }
                let faces = match out.t {
                    t if t + out.error < TO => 2,
                    t if t - out.error > TO => 1,
                    _ => return Light::Doubtful,
                };
                if !leaf.is_lone || scratch.passed.len() == PASSED {
                    return Light::Doubtful;
                }
                scratch.passed.push((end.t, faces, own));
            }
        }
        Light::Seen(self.share(&mut scratch.passed))
    }

    /// Where a ray that starts on a leaf and goes into it comes out again.
    #[inline(always)]
    fn way_out(&self, probe: &Probe, leaf: &Leaf, skin: f64) -> Option<End> {
        let t = match leaf.kind {
            Kind::Sphere => {
                let term = |i: usize| (leaf.numbers[i] - probe.origin[i]) * probe.direction[i];
                2.0 * (term(0) + term(1) + term(2)) * probe.per_square
            }
            Kind::Cuboid => {
                let far = |i: usize| {
                    let [low, high] = each([i, 3 + i], |side: usize| {
                        (leaf.numbers[side] - probe.origin[i]) * probe.inverse[i]
                    });
                    low.max(high)
                };
                far(0).min(far(1)).min(far(2))
            }
            // Nothing goes through these.
            Kind::Plane | Kind::HalfSpace | Kind::Rectangle => return None,
        };
        let out = self.rough(probe, leaf, t, false);
        (out.t > 2.0 * (skin + out.error)).then_some(out)
    }

    /// What solids on the way leave of light.
    #[inline(always)]
    fn share(&self, passed: &mut [(f64, u32, u32)]) -> Vec3 {
        let mut share = Vec3::ONE;
        if passed.len() > 1 {
            passed.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        }
        for &(_, faces, leaf) in passed.iter() {
            let kt = Vec3(self.leaves[leaf as usize].kt);
            for _ in 0..faces {
                share = share.times(kt);
            }
        }
        share
    }
}

impl Block {
    #[inline(always)]
    fn chords(&self, probe: &Probe, from: f64, to: f64) -> Chords {
        match &self.shapes {
            Shapes::Spheres(spheres) => spheres.chords(probe, from, to),
            Shapes::Cuboids(cuboids) => cuboids.chords(probe, from, to),
            Shapes::Planes(planes) => planes.chords(probe, from, to),
            Shapes::Rectangles(rectangles) => rectangles.chords(probe, from, to),
        }
    }
}
