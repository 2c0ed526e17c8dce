//! How much light of a lamp gets to a point.

use super::bundle::Blocks;
use super::leaf::{Kind, Leaf};
use super::probe::Probe;
use super::query::{Ask, BENT, Crossed, Crossing, End, NONE, Query, Start, Tests};
use super::scratch::{Passed, Scratch};
use super::stage::{Shapes, Stage};
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH};

/// What light of a lamp does.
#[derive(Debug, Clone, Copy)]
pub enum Light {
    /// It is seen, with this share of it left.
    Seen(Vec3),
    Dark,
    /// The kernel does not know.
    Doubtful,
}

/// The nearest thing that lets nothing through, where something transparent may hide it.
#[derive(Clone, Copy)]
struct Blocked {
    end: End,
    operand: u32,
}

/// What has been found on the way.
enum Found {
    Nothing,
    Dark,
    Doubt,
}

/// The end of rays to lamps: see [`AT_LAMP`](crate::trace::precision::Precision::AT_LAMP).
const TO: f64 = 1.0 - 1.0 / (1u64 << 27) as f64;
/// Transparent things on the way to a lamp at most.
const PASSED: usize = 64;
/// Before the start of every ray.
const BEFORE: End = End {
    t: -1.0,
    error: 0.0,
};

/// Whether a place is before the lamp; `None` where that is not known.
#[inline(always)]
fn is_on_the_way(end: End) -> Option<bool> {
    match end.t {
        t if t + end.error < TO => Some(true),
        t if t - end.error > TO => Some(false),
        _ => None,
    }
}

impl Stage<'_> {
    /// The share of light that gets along a ray to a lamp at t = 1. `along` are the blocks on its way, if they are known;
    /// `last` is the block that was in the way of the light before.
    #[inline(always)]
    pub fn light(
        &self,
        start: &Start,
        along: Option<&Blocks>,
        last: &mut u32,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Light {
        if start.within == NONE && along.is_some_and(|along| along.is_empty()) {
            return Light::Seen(Vec3::ONE);
        }
        let query = Query::new(start);
        scratch.passed.clear();
        let mut blocked = None;
        if start.within != NONE && !self.leaves_own(&query, &mut blocked, scratch, tests) {
            return Light::Doubtful;
        }
        match along {
            Some(along) => {
                for &(_, block) in along {
                    match self.in_the_way(&query, block, &mut blocked, scratch, tests) {
                        Found::Nothing => {}
                        Found::Doubt => return Light::Doubtful,
                        Found::Dark => return Light::Dark,
                    }
                }
            }
            None => {
                let beam = Beam::new(&query.line, &self.all.frame);
                let ends = [0.0, beam.pace(1.0)];
                self.begin(scratch);
                if !self.has_glass && *last != NONE {
                    scratch.pending.push((0.0, Child::item(*last)));
                }
                let mut next = None;
                while let Some((_, child)) = next.take().or_else(|| scratch.pending.pop()) {
                    let block = match child.is() {
                        Is::Node(node) => {
                            tests.boxes += WIDTH as u32;
                            let node = &self.all.tree.nodes[node as usize];
                            next = beam.first(node, ends, |near, child| {
                                scratch.pending.push((near, child));
                            });
                            continue;
                        }
                        Is::Item(block) => block,
                    };
                    match self.in_the_way(&query, block, &mut blocked, scratch, tests) {
                        Found::Nothing => {}
                        Found::Doubt => return Light::Doubtful,
                        Found::Dark => {
                            *last = block;
                            return Light::Dark;
                        }
                    }
                }
            }
        }
        match blocked {
            Some(blocked) => self.behind_glass(blocked, &scratch.passed),
            None => self.share(&mut scratch.passed),
        }
    }

    /// Notes what in a block is in the way of light.
    #[inline(always)]
    fn in_the_way(
        &self,
        query: &Query,
        block: u32,
        blocked: &mut Option<Blocked>,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Found {
        let block = &self.blocks[block as usize];
        tests.shapes += 1;
        if let Shapes::Alone = block.shapes {
            return self.meets_alone(query, block.leaves[0], blocked, (scratch, tests));
        }
        let (start, skin) = (query.start, query.skin);
        let mut moved = Probe::NONE;
        let probe = self.placed(&query.probe, block.placement, &mut moved);
        let hair = BENT * 2.0 * ((probe.reach + block.extent) * probe.per_pace + 1.0);
        let chords = block.chords(probe, -(skin + hair), 1.0 + hair);
        let mut maybe = chords.maybe;
        while maybe != 0 {
            let lane = maybe.trailing_zeros() as usize % 4;
            maybe &= maybe - 1;
            let own = block.leaves[lane];
            let leaf = &self.leaves[own as usize];
            if own == start.within {
                continue;
            }
            if leaf.twin == start.left {
                if start.goes_in && leaf.is_solid {
                    return Found::Doubt;
                }
                continue;
            }
            if chords.sure >> lane & 1 == 0 {
                return Found::Doubt;
            }
            let out = self.rough(probe, leaf, chords.far[lane], false);
            if out.t < -(skin + out.error) {
                continue;
            }
            let end = self.rough(probe, leaf, chords.near[lane], true);
            if end.t - end.error > TO {
                continue;
            }
            if end.t <= skin + end.error {
                return Found::Doubt;
            }
            match self.met(own, leaf, [end, out], blocked, scratch) {
                Found::Nothing => {}
                found => return found,
            }
        }
        Found::Nothing
    }

    /// Notes a leaf that light meets at one place and leaves at another, ahead of the ray's start.
    #[inline(always)]
    fn met(
        &self,
        number: u32,
        leaf: &Leaf,
        [near, far]: [End; 2],
        blocked: &mut Option<Blocked>,
        scratch: &mut Scratch,
    ) -> Found {
        match is_on_the_way(near) {
            Some(false) => return Found::Nothing,
            Some(true) => {}
            None => return Found::Doubt,
        }
        if !leaf.is_clear {
            if leaf.is_lone {
                return Found::Dark;
            }
            if blocked.is_none_or(|before| near.t < before.end.t) {
                *blocked = Some(Blocked {
                    end: near,
                    operand: leaf.operand,
                });
            }
            return Found::Nothing;
        }
        let faces = match is_on_the_way(far) {
            Some(true) if leaf.is_solid => 2,
            Some(_) => 1,
            None => return Found::Doubt,
        };
        if scratch.passed.len() == PASSED {
            return Found::Doubt;
        }
        scratch.passed.push(Passed {
            leaf: number,
            near,
            far,
            faces,
        });
        Found::Nothing
    }

    /// Notes what a leaf without lanes is in the way of.
    #[inline(never)]
    fn meets_alone(
        &self,
        query: &Query,
        number: u32,
        blocked: &mut Option<Blocked>,
        (scratch, tests): (&mut Scratch, &mut Tests),
    ) -> Found {
        if number == query.start.within {
            return Found::Nothing;
        }
        let leaf = &self.leaves[number as usize];
        let stretch = [-query.skin, 1.0];
        let ask = match (leaf.is_clear, leaf.is_lone) {
            (true, _) => Ask::All,
            (false, true) => Ask::Any,
            (false, false) => Ask::First,
        };
        match self.meet_alone(query, number, stretch, ask, (scratch, tests)) {
            Crossed::Nothing => return Found::Nothing,
            Crossed::Somewhere => return Found::Dark,
            Crossed::Doubt => return Found::Doubt,
            Crossed::Ahead => {}
        }
        let ahead = std::mem::take(&mut scratch.ahead);
        let found = self.met_all(number, &ahead, blocked, scratch);
        scratch.ahead = ahead;
        found
    }

    /// Notes a leaf that light meets from outside, and where it crosses that.
    fn met_all(
        &self,
        number: u32,
        ahead: &[Crossing],
        blocked: &mut Option<Blocked>,
        scratch: &mut Scratch,
    ) -> Found {
        let leaf = &self.leaves[number as usize];
        let chords = ahead.chunks(if leaf.is_solid { 2 } else { 1 });
        let mut ends = chords.map(|chord| match chord {
            [near, far] => [near.end, far.end],
            [near] if leaf.is_solid => [near.end, End::NEVER],
            _ => [chord[0].end; 2],
        });
        let met = |ends| self.met(number, leaf, ends, blocked, scratch);
        (ends.by_ref().map(met))
            .find(|found| !matches!(found, Found::Nothing))
            .unwrap_or(Found::Nothing)
    }

    /// Notes where light leaves the leaf that it starts in; whether that is known.
    #[inline(always)]
    fn leaves_own(
        &self,
        query: &Query,
        blocked: &mut Option<Blocked>,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> bool {
        let start = query.start;
        let leaf = &self.leaves[start.within as usize];
        let out = if matches!(leaf.kind, Kind::Other | Kind::Csg) {
            let everywhere = [-query.skin, f64::INFINITY];
            match self.meet_alone(query, start.within, everywhere, Ask::All, (scratch, tests)) {
                Crossed::Ahead => {
                    let mut ahead = std::mem::take(&mut scratch.ahead);
                    let out = ahead.first().map_or(End::NEVER, |crossing| crossing.end);
                    ahead.drain(..ahead.len().min(1));
                    // It may come back.
                    let found = self.met_all(start.within, &ahead, blocked, scratch);
                    scratch.ahead = ahead;
                    matches!(found, Found::Nothing).then_some(out)
                }
                Crossed::Nothing | Crossed::Somewhere | Crossed::Doubt => None,
            }
        } else {
            let mut moved = Probe::NONE;
            let probe = self.placed(&query.probe, leaf.placement, &mut moved);
            self.way_out(probe, leaf, query.skin)
        };
        let Some((out, is_left)) = out.and_then(|out| Some((out, is_on_the_way(out)?))) else {
            return false;
        };
        scratch.passed.push(Passed {
            leaf: start.within,
            near: BEFORE,
            far: out,
            faces: u32::from(is_left),
        });
        true
    }

    /// Whether what is opaque is seen by the light that may have come into something transparent before: an earlier
    /// operand owns what both are in.
    #[cold]
    fn behind_glass(&self, blocked: Blocked, passed: &[Passed]) -> Light {
        let hides = |around: &Passed| {
            let is_apart = blocked.end.is_before(around.near) || around.far.is_before(blocked.end);
            !is_apart && self.leaves[around.leaf as usize].operand < blocked.operand
        };
        match passed.iter().any(hides) {
            true => Light::Doubtful,
            false => Light::Dark,
        }
    }

    /// What is left of light behind all that it passes.
    #[inline(always)]
    fn share(&self, passed: &mut [Passed]) -> Light {
        let mut share = Vec3::ONE;
        if passed.len() > 1 {
            passed.sort_unstable_by(|a, b| a.near.t.total_cmp(&b.near.t));
        }
        let mut before: Option<&Passed> = None;
        for next in passed.iter() {
            let leaf = &self.leaves[next.leaf as usize];
            // One in another: which faces count is not looked up here.
            if !leaf.is_lone && before.is_some_and(|before| !before.far.is_before(next.near)) {
                return Light::Doubtful;
            }
            let kt = Vec3(leaf.kt);
            for _ in 0..next.faces {
                share = share.times(kt);
            }
            before = Some(next);
        }
        Light::Seen(share)
    }
}
