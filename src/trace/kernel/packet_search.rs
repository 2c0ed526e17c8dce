//! The first surfaces that four rays of a bundle meet, and the shapes between four places and a lamp.

use super::block::{Block, Shapes};
use super::bundle::Along;
use super::chain::Local;
use super::geodesic;
use super::lanes::{LANES, Lanes, either, is_greater, is_less, mask};
use super::leaf::{Kind, Leaf};
use super::packet::{Ahead, Packet};
use super::query::{Ask, Crossed, Crossing, End, Query, Tests, UNKNOWN_FACE, Within};
use super::scratch::Scratch;
use super::search::Met;
use super::shadow::TO;
use super::spans::Entry;
use super::stage::Stage;
use super::torus;
use crate::trace::shapes::{Primitive, Root};

/// The nearest crossings of four rays among those that have been found.
struct Nearest {
    crossings: [Crossing; LANES],
    t: Lanes,
    error: Lanes,
    /// A lower bound on the t of all other crossings.
    second: Lanes,
    /// The largest t at which a crossing may be as near as the nearest.
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

    /// Takes in the places where some rays meet a leaf. Returns, as bits, the rays whose nearest crossing is there.
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

    /// Takes in the answer of a leaf without lanes about the ray in one lane.
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

/// The indices of the lanes whose bits are set.
#[inline(always)]
fn lanes(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

impl Stage<'_> {
    /// The surfaces that four rays meet first. Rays that start inside of a solid are said to be in doubt.
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
            let rays = packet.in_box(&candidate.bounds, best.limit, open);
            let block = &self.blocks[candidate.block as usize];
            if rays == 0 {
                continue;
            }
            if let Shapes::Single = block.shapes {
                self.nearer_of_four(packet, (block, rays), &mut best, scratch, tests);
                continue;
            }
            lanes(rays).for_each(|lane| tests[lane].shapes += 1);
            let mut moved = None;
            let probe = packet.in_space(&self.graph.placements, block.placement, &mut moved);
            for (i, number) in block.each_leaf() {
                let leaf = &self.leaves[number as usize];
                let ahead = packet.meet(probe, (block, i, leaf), best.limit, rays);
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

    /// Looks for nearer crossings in a block with one leaf without lanes, which `rays` may meet.
    #[inline(never)]
    fn nearer_of_four(
        &self,
        packet: &Packet,
        (block, mut rays): (&Block, u32),
        best: &mut Nearest,
        scratch: &mut Scratch,
        tests: &mut [Tests; LANES],
    ) {
        let number = block.leaves[0];
        let leaf = &self.leaves[number as usize];
        if let Some(spans) = self.spans(leaf) {
            scratch.merges += u64::from(rays.count_ones());
            lanes(rays).for_each(|lane| tests[lane].shapes += spans.count());
            let entry = spans.entry(self.space(), packet, best.limit, rays);
            for lane in lanes(best.consider(&entry.ahead)) {
                best.crossings[lane] = entry.crossing(lane);
            }
            rays = entry.rest;
            if rays == 0 {
                return;
            }
        }
        let (beside, _) = packet.passing(block, leaf, best.limit);
        rays &= !beside;
        if rays == 0 {
            return;
        }
        lanes(rays).for_each(|lane| tests[lane].shapes += 1);
        let mut lines = None;
        // Rays that start on the leaf are asked more, by `meet_single`.
        let plain = rays & !packet.on(leaf);
        if leaf.kind == Kind::Other && plain != 0 {
            let local = packet.enter(&self.chains_of([leaf; LANES]));
            if let Some((ahead, faces, none)) = self.meet_solved(packet, &local, leaf, plain) {
                let (t, error) = (ahead.t.to_array(), ahead.error.to_array());
                for lane in lanes(best.consider(&ahead)) {
                    let (t, error) = (t[lane], error[lane]);
                    best.crossings[lane] = Crossing {
                        surface: number,
                        root: Root {
                            t,
                            face: faces[lane],
                        },
                        end: End { t, error },
                        is_exit: false,
                    };
                }
                rays &= !(ahead.met | none);
            }
            lines = (rays & plain != 0).then(|| local.lines());
        }
        let limits = best.limit.to_array();
        for lane in lanes(rays) {
            let query = Query::new(packet.starts[lane]);
            let stretch = [-query.skin, limits[lane]];
            let crossed = match &lines {
                Some(lines) if plain >> lane & 1 != 0 => {
                    self.meet_on_line(&query, number, &lines[lane], stretch, scratch)
                }
                _ => {
                    let mut counted = Tests::default();
                    let with = (&mut *scratch, &mut counted);
                    let crossed = self.meet_single(&query, number, stretch, Ask::First, with);
                    tests[lane].add(counted);
                    crossed
                }
            };
            best.consider_single(lane, crossed, &scratch.ahead);
        }
    }

    /// Finds where `rays` meet a torus or a geodesic sphere ahead of their starts, with the faces that they meet there,
    /// and, as bits, the rays that surely miss it. Rays in neither set have to be asked one by one. `None` for other
    /// shapes.
    #[inline(always)]
    fn meet_solved(
        &self,
        packet: &Packet,
        local: &Local,
        leaf: &Leaf,
        rays: u32,
    ) -> Option<(Ahead, [u32; LANES], u32)> {
        let (met, none, t, error, faces) = match &self.graph.primitives[leaf.primitive as usize] {
            Primitive::Torus(torus) => {
                let found = torus::first(torus, local, packet.skin, rays);
                let error = local.bent_error(leaf.extent, found.t);
                let none = found.known & !found.met;
                (found.met, none, found.t, error, [0; LANES])
            }
            Primitive::GeodesicSphere(sphere) => {
                let found = geodesic::first(sphere, local, packet.skin, rays);
                let error = local.flat_error(leaf.extent, found.t, found.speed);
                (found.met, 0, found.t, error, found.faces)
            }
            _ => return None,
        };
        let met = met & is_greater(t, packet.skin + error).to_bitmask();
        let ahead = Ahead {
            met,
            doubt: 0,
            t,
            error,
        };
        Some((ahead, faces, none))
    }

    /// Lists in [`Along::blocks`] the blocks that four rays to a lamp may meet. Returns, as bits, the rays that surely
    /// meet an opaque leaf near which nothing is transparent; their lists are not complete.
    #[inline(never)]
    pub fn shadows_of_four(&self, along: &mut Along, packet: &Packet) -> u32 {
        let (one, end) = (Lanes::splat(1.0), Lanes::splat(TO));
        let mut dark = 0;
        let Along {
            candidates, blocks, ..
        } = along;
        blocks.iter_mut().for_each(Vec::clear);
        // A block in the way of these rays is likely in the way of the next ones: it is moved to the front.
        let mut foremost = 0;
        for (i, candidate) in candidates.iter().enumerate() {
            let open = packet.live & !dark;
            if open == 0 {
                break;
            }
            let mut rays = packet.in_box(&candidate.bounds, one, open);
            if rays == 0 {
                continue;
            }
            let block = &self.blocks[candidate.block as usize];
            if let Shapes::Single = block.shapes {
                let leaf = &self.leaves[block.leaves[0] as usize];
                let (beside, through) = match self.spans(leaf) {
                    Some(spans) => {
                        let asked = rays & packet.outside;
                        let Entry { ahead, rest, .. } =
                            spans.entry(self.space(), packet, one, asked);
                        let before = is_less(ahead.t + ahead.error, end).to_bitmask();
                        (asked & !(ahead.met | rest), ahead.met & before)
                    }
                    None => packet.passing(block, leaf, one),
                };
                if leaf.is_dark() {
                    dark |= rays & packet.outside & through;
                }
                rays &= !(beside | dark);
            } else if block.is_dark {
                let mut moved = None;
                let probe = packet.in_space(&self.graph.placements, block.placement, &mut moved);
                let asked = rays & packet.outside;
                rays &= !packet.outside;
                for (i, number) in block.each_leaf() {
                    let leaf = &self.leaves[number as usize];
                    let ahead = packet.meet(probe, (block, i, leaf), one, asked & !dark);
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
}
