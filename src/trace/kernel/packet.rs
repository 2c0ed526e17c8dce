//! Packets: four rays that are tested against one shape after the other.
//!
//! Lanes are rays here; in [`search`](super::search) they are shapes. The answers about a ray are the same in both,
//! with the same formulas and the same bounds.

use super::block::Block;
use super::chain::{Chains, Local};
use super::cull::in_box;
use super::lanes::{LANES, Lanes, V3, gathered, is_greater, is_less, lanes_where};
use super::leaf::Leaf;
use super::probe::Probe;
use super::query::{BENT, SKINS, Start};
use crate::geometry::aabb::Aabb;
use crate::geometry::affine::Placement;

/// The room around boxes, as a share of all coordinates: far more than what is rounded.
pub const REL_ROOM: f64 = 1e-12;

/// Four rays.
pub struct Packet<'w> {
    pub starts: [&'w Start; LANES],
    pub probe: Probe<Lanes>,
    /// The t beyond which a place cannot be taken for the ray's start.
    pub skin: Lanes,
    /// The rays that are asked for, as bits.
    pub live: u32,
    /// The rays that start outside of everything, as bits.
    pub outside: u32,
    /// The rays that go against the normal of the surface that they start on, as bits.
    pub goes_in: u32,
}

impl<'w> Packet<'w> {
    #[inline(always)]
    pub fn new(starts: [&'w Start; LANES], live: u32) -> Packet<'w> {
        let origin = V3::gathered(starts, |start| &start.origin);
        let probe = Probe::of_four(origin, V3::gathered(starts, |start| &start.direction));
        Packet {
            starts,
            skin: gathered(starts, |start| start.skin * SKINS) * probe.per_pace,
            probe,
            live,
            outside: live & lanes_where(|lane| starts[lane].within.is_empty()),
            goes_in: lanes_where(|lane| starts[lane].goes_in),
        }
    }

    /// The rays in the space of a placement. Unless that is the scene's space, the rays are kept in `moved`.
    #[inline(always)]
    pub fn in_space<'p>(
        &'p self,
        placements: &[Placement],
        placement: u32,
        moved: &'p mut Option<Probe<Lanes>>,
    ) -> &'p Probe<Lanes> {
        if placement == 0 {
            return &self.probe;
        }
        moved.insert(
            self.probe
                .four_through(&placements[placement as usize].back),
        )
    }

    /// The rays among `rays` that may be in a box before t = `to`, as bits.
    #[inline(always)]
    pub fn in_box(&self, bounds: &Aabb, to: Lanes, rays: u32) -> u32 {
        let (origin, inverse) = (V3(self.probe.origin), V3(self.probe.inverse));
        let [near, far] = in_box(bounds, origin, inverse, [-self.skin, to]);
        // Written so that NaN counts as met.
        rays & !is_greater(near, far * Lanes::splat(1.0 + REL_ROOM)).to_bitmask()
    }

    /// The rays that start on a leaf, as bits.
    #[inline(always)]
    pub fn on(&self, leaf: &Leaf) -> u32 {
        lanes_where(|lane| self.starts[lane].left == leaf.twin)
    }

    /// The rays in the spaces of leaves.
    #[inline(always)]
    pub fn enter(&self, chains: &Chains) -> Local {
        chains.enter(V3(self.probe.origin), V3(self.probe.direction))
    }

    /// The rays that surely miss a leaf without lanes before t = `to`, and the rays that surely go through it, both as
    /// bits.
    #[inline(always)]
    pub fn passing(&self, block: &Block, leaf: &Leaf, to: Lanes) -> (u32, u32) {
        let here = self.on(leaf);
        let out = here & !self.goes_in;
        // A ray that leaves a convex leaf does not meet it again.
        let is_left = if leaf.is_convex { out } else { 0 };
        let Some(cull) = &block.cull else {
            return (is_left, 0);
        };
        let (origin, direction) = (V3(self.probe.origin), V3(self.probe.direction));
        let passing = cull.passing(origin, direction, self.skin, to);
        let is_left = is_left | out & passing.leaves;
        (passing.beside | is_left, passing.through & !here)
    }

    /// Finds where `rays` meet a leaf with lanes before t = `to`. They start outside of everything; `probe` holds them
    /// in the leaf's space.
    #[inline(always)]
    pub fn meet(
        &self,
        probe: &Probe<Lanes>,
        (block, i, leaf): (&Block, usize, &Leaf),
        to: Lanes,
        rays: u32,
    ) -> Ahead {
        let splat = Lanes::splat;
        let here = rays & self.on(leaf);
        let mut doubt = if leaf.is_solid {
            here & self.goes_in
        } else {
            0
        };
        let size = (probe.reach + splat(leaf.extent)) * probe.per_pace + splat(1.0);
        let hair = splat(BENT) * size;
        let stretch = [-(self.skin + hair), to + hair];
        let chords = block.chords_alone((i, leaf), probe, stretch);
        let maybe = rays & !here & chords.maybe;
        doubt |= maybe & !chords.sure;
        let mut met = maybe & chords.sure;
        let mut error = Lanes::ZERO;
        if met != 0 {
            let far_error = leaf.errors(probe, chords.far, false);
            met &= !is_less(chords.far, -(self.skin + far_error)).to_bitmask();
            error = leaf.errors(probe, chords.near, true);
            let is_ahead = is_greater(chords.near, self.skin + error).to_bitmask();
            doubt |= met & !is_ahead;
            met &= is_ahead;
        }
        Ahead {
            met,
            doubt,
            t: chords.near,
            error,
        }
    }
}

/// Where four rays meet a leaf ahead of their starts.
pub struct Ahead {
    /// The rays that surely meet the leaf, as bits.
    pub met: u32,
    /// The rays that are in doubt, as bits.
    pub doubt: u32,
    pub t: Lanes,
    /// A bound on the error of t.
    pub error: Lanes,
}
