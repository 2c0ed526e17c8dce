//! Four rays of a bundle, held against one shape after the other.
//!
//! The lanes are the rays, not the shapes as in [`search`](super::search). What is said of a ray here is what is said there,
//! with the same formulas and the same bounds.

use super::block::{Block, Shapes};
use super::bundle::{Along, Candidate, REL_ROOM};
use super::cull::in_box;
use super::lanes::{LANES, Lanes, V3, either, gathered, is_greater, is_less, lanes_where, mask};
use super::leaf::Leaf;
use super::probe::Probe;
use super::query::{
    Ask, BENT, Crossed, Crossing, End, Query, SKINS, Start, Tests, UNKNOWN_FACE, Within,
};
use super::scratch::Scratch;
use super::search::Met;
use super::shadow::TO;
use super::spans::Entry;
use super::stage::Stage;
use crate::trace::shapes::Root;

/// Four rays.
pub struct Packet<'w> {
    starts: [&'w Start; LANES],
    probe: Probe<Lanes>,
    /// In t, how far from a start a place is that cannot be taken for it.
    pub(super) skin: Lanes,
    /// Those that are asked for, as bits.
    live: u32,
    /// Those that start outside of everything.
    outside: u32,
    /// Those that go against the normal of the surface that they start on.
    pub(super) goes_in: u32,
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

    /// Those of some rays that may be in a box up to some t.
    #[inline(always)]
    fn in_box(&self, candidate: &Candidate, to: Lanes, rays: u32) -> u32 {
        let (origin, inverse) = (V3(self.probe.origin), V3(self.probe.inverse));
        let [near, far] = in_box(&candidate.bounds, origin, inverse, [-self.skin, to]);
        // Written so that NaN counts as met.
        rays & !is_greater(near, far * Lanes::splat(1.0 + REL_ROOM)).to_bitmask()
    }

    /// The rays that start on a leaf.
    #[inline(always)]
    pub(super) fn on(&self, leaf: &Leaf) -> u32 {
        lanes_where(|lane| self.starts[lane].left == leaf.twin)
    }

    /// The rays that surely miss a leaf without lanes up to some t, and those that surely go through it.
    #[inline(always)]
    fn passing(&self, block: &Block, leaf: &Leaf, to: f64) -> (u32, u32) {
        let here = self.on(leaf);
        // What is convex is not met again by a ray that leaves it.
        let leaves_it = if leaf.is_convex {
            here & !self.goes_in
        } else {
            0
        };
        let Some(cull) = &block.cull else {
            return (leaves_it, 0);
        };
        let (origin, direction) = (V3(self.probe.origin), V3(self.probe.direction));
        let passing = cull.passing(origin, direction, self.skin, to);
        (passing.beside | leaves_it, passing.through & !here)
    }

    /// Where some rays, which start outside of everything, meet a leaf with lanes; `probe` has them in the leaf's space.
    #[inline(always)]
    fn meet(
        &self,
        probe: &Probe<Lanes>,
        (shape, leaf): (&Shapes, &Leaf),
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
        let chords = shape.chords(probe, -(self.skin + hair), to + hair);
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
    /// Those that meet it, as bits.
    pub met: u32,
    /// Those of which that is not known.
    pub doubt: u32,
    pub t: Lanes,
    /// A bound on the error of t.
    pub error: Lanes,
}

/// The nearest crossings so far.
struct Nearest {
    crossings: [Crossing; LANES],
    t: Lanes,
    error: Lanes,
    /// The least t of all that is not the nearest.
    second: Lanes,
    /// What is met up to here may be as near as the nearest.
    limit: Lanes,
    /// The rays that rounding may have decided something about, as bits.
    doubt: u32,
}

impl Nearest {
    #[inline(always)]
    fn nothing() -> Nearest {
        let never = Lanes::splat(f64::INFINITY);
        Nearest {
            crossings: [Crossing::NONE; LANES],
            t: never,
            error: Lanes::ZERO,
            second: never,
            limit: never,
            doubt: 0,
        }
    }

    /// Takes places where some rays meet something; returns those to which it is the nearest.
    #[inline(always)]
    fn consider(&mut self, ahead: &Ahead) -> u32 {
        let &Ahead { t, error, .. } = ahead;
        self.doubt |= ahead.doubt;
        let met = mask(ahead.met);
        let is_nearer = met & is_less(t, self.t);
        let other = either(is_nearer, self.t - self.error, t - error);
        self.second = either(met, self.second.fast_min(other), self.second);
        self.limit = either(is_nearer, t + (error + error), self.limit);
        self.t = either(is_nearer, t, self.t);
        self.error = either(is_nearer, error, self.error);
        is_nearer.to_bitmask()
    }

    /// Takes what a leaf without lanes says of one ray.
    #[inline(always)]
    fn consider_single(&mut self, lane: usize, crossed: Crossed, ahead: &[Crossing]) {
        match (crossed, ahead.first()) {
            (Crossed::Doubt | Crossed::Somewhere, _) => self.doubt |= 1 << lane,
            (Crossed::Ahead, Some(crossing)) => {
                let one = Ahead {
                    met: 1 << lane,
                    doubt: 0,
                    t: Lanes::splat(crossing.end.t),
                    error: Lanes::splat(crossing.end.error),
                };
                if self.consider(&one) != 0 {
                    self.crossings[lane] = *crossing;
                }
            }
            _ => {}
        }
    }
}

/// The lanes of some bits.
#[inline(always)]
fn lanes(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

impl Stage<'_> {
    /// The surfaces that four rays meet first. Those that start inside of something are in doubt.
    #[inline(never)]
    pub fn first_of_four(
        &self,
        along: &Along,
        packet: &Packet,
        scratch: &mut Scratch,
        tests: &mut [Tests; LANES],
    ) -> [Met; LANES] {
        let mut best = Nearest::nothing();
        best.doubt = !packet.outside;
        for candidate in &along.candidates {
            let beyond = is_greater(Lanes::splat(candidate.near), best.limit).to_bitmask();
            let open = packet.live & !best.doubt;
            if open & !beyond == 0 {
                break;
            }
            let rays = packet.in_box(candidate, best.limit, open);
            let block = &self.blocks[candidate.block as usize];
            if rays == 0 {
                continue;
            }
            if let Shapes::Single = block.shapes {
                let number = block.leaves[0];
                let leaf = &self.leaves[number as usize];
                let mut rays = rays;
                if let Some(spans) = self.spans(leaf) {
                    scratch.merges += u64::from(rays.count_ones());
                    lanes(rays).for_each(|lane| tests[lane].shapes += spans.count());
                    let entry = self.entry(packet, spans, best.limit, rays);
                    for lane in lanes(best.consider(&entry.ahead)) {
                        best.crossings[lane] = entry.crossing(lane);
                    }
                    rays = entry.rest;
                    if rays == 0 {
                        continue;
                    }
                }
                let (beside, _) = packet.passing(block, leaf, f64::INFINITY);
                for lane in lanes(rays & !beside) {
                    let query = Query::new(packet.starts[lane]);
                    let stretch = [-query.skin, best.limit.to_array()[lane]];
                    let tests = &mut tests[lane];
                    tests.shapes += 1;
                    let with = (&mut *scratch, tests);
                    let crossed = self.meet_single(&query, number, stretch, Ask::First, with);
                    best.consider_single(lane, crossed, &scratch.ahead);
                }
                continue;
            }
            lanes(rays).for_each(|lane| tests[lane].shapes += 1);
            let mut moved = None;
            let probe = self.in_space(packet, block.placement, &mut moved);
            for (shape, &number) in block.apart.iter().zip(&block.leaves) {
                let leaf = &self.leaves[number as usize];
                let ahead = packet.meet(probe, (shape, leaf), best.limit, rays);
                let (t, error) = (ahead.t.to_array(), ahead.error.to_array());
                for lane in lanes(best.consider(&ahead)) {
                    let (t, error) = (t[lane], error[lane]);
                    best.crossings[lane] = Crossing {
                        surface: number,
                        root: Root {
                            t,
                            face: UNKNOWN_FACE,
                        },
                        end: End { t, error },
                        is_exit: false,
                    };
                }
            }
        }
        let alone = is_greater(best.second, best.limit).to_bitmask();
        let mut all = [Met::Doubt; LANES];
        for lane in lanes(packet.live & !best.doubt) {
            let crossing = best.crossings[lane];
            all[lane] = match self.leaves.get(crossing.surface as usize) {
                None => Met::Nothing,
                Some(_) if alone >> lane & 1 == 0 => Met::Doubt,
                Some(leaf) => {
                    let behind = match leaf.is_solid {
                        true => Within::one(leaf.solid),
                        false => Within::NOTHING,
                    };
                    Met::Surface(crossing, [Within::NOTHING, behind])
                }
            };
        }
        all
    }

    /// Finds what four rays to a lamp may meet, into [`Along::blocks`]. Returns those that surely meet something opaque that
    /// is near nothing transparent, as bits; what these may meet is not complete.
    #[inline(never)]
    pub fn shadows_of_four(&self, along: &mut Along, packet: &Packet) -> u32 {
        let (one, end) = (Lanes::splat(1.0), Lanes::splat(TO));
        let mut dark = 0;
        let Along {
            candidates, blocks, ..
        } = along;
        blocks.iter_mut().for_each(Vec::clear);
        // What is in the way of these is likely in the way of the next ones: it comes first then.
        let mut foremost = 0;
        for (i, candidate) in candidates.iter().enumerate() {
            let open = packet.live & !dark;
            if open == 0 {
                break;
            }
            let mut rays = packet.in_box(candidate, one, open);
            if rays == 0 {
                continue;
            }
            let block = &self.blocks[candidate.block as usize];
            if let Shapes::Single = block.shapes {
                let leaf = &self.leaves[block.leaves[0] as usize];
                let (beside, through) = match self.spans(leaf) {
                    Some(spans) => {
                        let asked = rays & packet.outside;
                        let Entry { ahead, rest, .. } = self.entry(packet, spans, one, asked);
                        let before = is_less(ahead.t + ahead.error, end).to_bitmask();
                        (asked & !(ahead.met | rest), ahead.met & before)
                    }
                    None => packet.passing(block, leaf, 1.0),
                };
                if leaf.is_dark() {
                    dark |= rays & packet.outside & through;
                }
                rays &= !(beside | dark);
            } else if block.is_dark {
                let mut moved = None;
                let probe = self.in_space(packet, block.placement, &mut moved);
                let asked = rays & packet.outside;
                rays &= !packet.outside;
                for (shape, &number) in block.apart.iter().zip(&block.leaves) {
                    let leaf = &self.leaves[number as usize];
                    let ahead = packet.meet(probe, (shape, leaf), one, asked & !dark);
                    if leaf.is_dark() {
                        let before = is_less(ahead.t + ahead.error, end).to_bitmask();
                        dark |= ahead.met & before;
                    }
                    rays |= ahead.doubt | ahead.met;
                }
                rays &= !dark;
            }
            if open & dark != 0 {
                foremost = i;
            }
            lanes(rays).for_each(|lane| blocks[lane].push(candidate.block));
        }
        if foremost != 0 {
            candidates.swap(0, foremost);
        }
        dark
    }

    /// The rays of a packet in the space of a placement, kept in `moved` where that is another one.
    #[inline(always)]
    pub(super) fn in_space<'p>(
        &self,
        packet: &'p Packet,
        placement: u32,
        moved: &'p mut Option<Probe<Lanes>>,
    ) -> &'p Probe<Lanes> {
        if placement == 0 {
            return &packet.probe;
        }
        let place = &self.graph.placements[placement as usize];
        moved.insert(packet.probe.four_through(&place.back))
    }
}
