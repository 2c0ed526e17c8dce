//! The first surface that a ray meets.

use super::block::{Block, Shapes};
use super::leaf::{Kind, Leaf};
use super::probe::Probe;
use super::query::{
    Ask, BENT, Crossed, Crossing, End, NONE, Query, Start, Tests, UNKNOWN_FACE, Within,
};
use super::scratch::Scratch;
use super::stage::Stage;
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH as CHILDREN};
use crate::trace::shapes::Root;

/// The first surface that a ray meets.
#[derive(Debug, Clone, Copy)]
pub enum Met {
    Nothing,
    /// The kernel does not know.
    Doubt,
    /// A surface, and the solids before and behind it.
    Surface(Crossing, [Within; 2]),
}

/// The nearest crossing among those that have been found.
struct Nearest {
    crossing: Crossing,
    /// A lower bound on the t of all other crossings.
    second: f64,
    /// The largest t at which a crossing may be as near as the nearest.
    limit: f64,
}

impl Nearest {
    const NOTHING: Nearest = Nearest {
        crossing: Crossing::NONE,
        second: f64::INFINITY,
        limit: f64::INFINITY,
    };

    #[inline(always)]
    fn consider(&mut self, crossing: Crossing) {
        let (end, best) = (crossing.end, self.crossing.end);
        if end.t >= best.t {
            self.second = self.second.min(end.t - end.error);
            return;
        }
        self.second = self.second.min(best.t - best.error);
        self.limit = end.t + 2.0 * end.error;
        self.crossing = crossing;
    }
}

impl Stage<'_> {
    /// The surface that a ray meets first.
    #[inline(always)]
    pub fn first(&self, start: &Start, scratch: &mut Scratch, tests: &mut Tests) -> Met {
        let within = match start.within.owner() {
            NONE => None,
            number => Some(&self.leaves[number as usize]),
        };
        if let Some(own) = within.filter(|own| own.is_lone) {
            return self.other_side(start, own, scratch, tests);
        }
        let query = Query::new(start);
        let mut best = Nearest::NOTHING;
        scratch.hidden.clear();
        let beam = Beam::new(&query.line, &self.all.frame);
        self.begin(scratch);
        let mut next = None;
        while let Some((near, child)) = next.take().or_else(|| scratch.pending.pop()) {
            let most = beam.pace(best.limit);
            if near > most {
                continue;
            }
            match child.is() {
                Is::Node(node) => {
                    tests.boxes += CHILDREN as u32;
                    let node = &self.all.tree.nodes[node as usize];
                    next = beam.nearest(node, [0.0, most], &mut scratch.pending);
                }
                Is::Item(block) => {
                    let block = &self.blocks[block as usize];
                    if !self.nearer(&query, within, block, &mut best, scratch, tests) {
                        return Met::Doubt;
                    }
                }
            }
        }
        let found = best.crossing;
        if found.surface == NONE {
            // A ray that crosses hidden solids has to leave the solid that hides them: without a way out something is
            // wrong.
            return match scratch.hidden[..] {
                [] => Met::Nothing,
                _ => Met::Doubt,
            };
        }
        if best.second <= best.limit {
            return Met::Doubt;
        }
        if start.within.is_empty() {
            let leaf = &self.leaves[found.surface as usize];
            let behind = if leaf.is_solid {
                Within::one(leaf.solid)
            } else {
                Within::NOTHING
            };
            return Met::Surface(found, [Within::NOTHING, behind]);
        }
        match self.sides(start.within, found, &scratch.hidden) {
            Some(sides) => Met::Surface(found, sides),
            None => Met::Doubt,
        }
    }

    /// The solids before and behind the crossing `found`. The ray starts in the solids `within`; `hidden` are its
    /// crossings with hidden solids, leaf by leaf. `None` where the solids are not known, or where the medium is the
    /// same on both sides, so that there is no surface.
    fn sides(&self, within: Within, found: Crossing, hidden: &[(u32, End)]) -> Option<[Within; 2]> {
        let leaf = &self.leaves[found.surface as usize];
        let mut before = within;
        for crossings in hidden.chunk_by(|a, b| a.0 == b.0) {
            let is_passed = |(_, end): &&(u32, End)| end.is_before(found.end);
            let is_behind = |(_, end): &&(u32, End)| found.end.is_before(*end);
            let passed = crossings.iter().filter(is_passed).count();
            if passed + crossings.iter().filter(is_behind).count() != crossings.len() {
                return None;
            }
            if passed % 2 == 1 {
                before = self.across(before, crossings[0].0)?;
            }
        }
        if !leaf.is_solid {
            return Some([before; 2]);
        }
        let behind = match self.across(before, leaf.solid) {
            // No ray goes on into an opaque solid, so the other solids there do not matter.
            None if !leaf.is_clear => Within::one(leaf.solid),
            behind => behind?,
        };
        let [a, b] = [before, behind].map(|side| self.leaves.get(side.owner() as usize));
        let is_one_medium = a
            .zip(b)
            .is_some_and(|(a, b)| a.look.medium == b.look.medium);
        (!is_one_medium).then_some([before, behind])
    }

    /// The solids on the other side of the surface of `solid`; `None` if they are too many.
    fn across(&self, within: Within, solid: u32) -> Option<Within> {
        let operand = |solid: u32| self.leaves[solid as usize].operand;
        match within.has(solid) {
            true => Some(within.without(solid)),
            false => within.with(solid, |other| operand(solid) < operand(other)),
        }
    }

    /// Looks for a nearer surface in a block; `false` if the ray is in doubt. `within` is the leaf that owns the ray's
    /// start.
    #[inline(always)]
    fn nearer(
        &self,
        query: &Query,
        within: Option<&Leaf>,
        block: &Block,
        best: &mut Nearest,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> bool {
        // An earlier operand hides the later solids inside of it.
        let is_hidden =
            |leaf: &Leaf| within.is_some_and(|own| leaf.is_solid && leaf.operand > own.operand);
        let (start, skin) = (query.start, query.skin);
        tests.shapes += 1;
        if let Shapes::Single = block.shapes {
            let number = block.leaves[0];
            let is_hidden = is_hidden(&self.leaves[number as usize]);
            let stretch = [-skin, best.limit];
            let ask = if is_hidden { Ask::All } else { Ask::First };
            match self.meet_single(query, number, stretch, ask, (scratch, tests)) {
                Crossed::Doubt | Crossed::Somewhere => return false,
                Crossed::Nothing => {}
                Crossed::Ahead if is_hidden => {
                    let ends = scratch.ahead.iter().map(|crossing| (number, crossing.end));
                    scratch.hidden.extend(ends);
                }
                Crossed::Ahead => {
                    if let Some(&crossing) = scratch.ahead.first() {
                        best.consider(crossing);
                    }
                }
            }
            return true;
        }
        let mut moved = Probe::NONE;
        let probe = self.placed(&query.probe, block.placement, &mut moved);
        let from = -(skin + BENT * ((probe.reach + block.extent) * probe.per_pace + 1.0));
        let chords = block.chords(probe, from, best.limit);
        let (near_ends, far_ends) = (chords.near.to_array(), chords.far.to_array());
        let mut maybe = chords.maybe;
        while maybe != 0 {
            let lane = maybe.trailing_zeros() as usize % 4;
            maybe &= maybe - 1;
            let number = block.leaves[lane];
            let leaf = &self.leaves[number as usize];
            if leaf.twin == start.left && !start.within.has(number) {
                if start.goes_in && leaf.is_solid {
                    return false;
                }
                continue;
            }
            if chords.sure >> lane & 1 == 0 {
                return false;
            }
            let out = leaf.rough(probe, far_ends[lane], false);
            let crossing = |end: End, is_exit| Crossing {
                surface: number,
                root: Root {
                    t: end.t,
                    face: UNKNOWN_FACE,
                },
                end,
                is_exit,
            };
            if start.within.has(number) {
                if out.t <= 2.0 * (skin + out.error) {
                    return false;
                }
                match is_hidden(leaf) {
                    true => scratch.hidden.push((number, out)),
                    false => best.consider(crossing(out, true)),
                }
                continue;
            }
            if out.t < -(skin + out.error) {
                continue;
            }
            let end = leaf.rough(probe, near_ends[lane], true);
            let is_ahead = end.t > skin + end.error;
            if !is_ahead {
                return false;
            }
            if is_hidden(leaf) {
                scratch.hidden.extend([(number, end), (number, out)]);
            } else {
                best.consider(crossing(end, false));
            }
        }
        true
    }

    /// The way out of the lone leaf `own` that the ray is in: the ray meets nothing else before it.
    #[inline(always)]
    fn other_side(
        &self,
        start: &Start,
        own: &Leaf,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Met {
        if !matches!(own.kind, Kind::Quadric | Kind::Other | Kind::Csg) {
            let crossing = Crossing {
                surface: start.within.owner(),
                is_exit: true,
                ..Crossing::NONE
            };
            return Met::Surface(crossing, [start.within, Within::NOTHING]);
        }
        tests.shapes += 1;
        let query = Query::new(start);
        let everywhere = [-query.skin, f64::INFINITY];
        let own = start.within.owner();
        match self.meet_single(&query, own, everywhere, Ask::First, (scratch, tests)) {
            Crossed::Ahead => match scratch.ahead.first() {
                Some(&crossing) => Met::Surface(crossing, [start.within, Within::NOTHING]),
                None => Met::Doubt,
            },
            Crossed::Nothing | Crossed::Somewhere | Crossed::Doubt => Met::Doubt,
        }
    }

    /// Begins a walk through the scene: puts the root of the tree and all blocks without bounds on the stack.
    #[inline(always)]
    pub(super) fn begin(&self, scratch: &mut Scratch) {
        scratch.pending.clear();
        if !self.all.tree.nodes.is_empty() {
            scratch.pending.push((0.0, Child::ROOT));
        }
        for &block in &self.all.loose {
            scratch.pending.push((0.0, Child::item(block)));
        }
    }
}
