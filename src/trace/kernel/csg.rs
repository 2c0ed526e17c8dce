//! Intersections and differences, of shapes or of other operations. The places where a ray crosses the shapes are put
//! in order; at each place the counts of the gates tell whether the whole begins or ends there.

use super::block::{Block, Shapes, in_loose_blocks};
use super::expand::{Gate, Operands};
use super::lanes::{LANES, Lanes};
use super::leaf::{Kind, Leaf};
use super::packet::Packet;
use super::probe::Probe;
use super::query::{Ask, BENT, Crossed, Crossing, End, NONE, Query, Tests, UNKNOWN_FACE};
use super::scalar::Raw;
use super::scratch::{Inner, Scratch};
use super::spans::Spans;
use super::stage::{Forest, Stage};
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH as CHILDREN};
use crate::trace::shapes::Root;

/// An intersection or a difference, as a ray walks through it.
///
/// Each operation is a gate, and each gate counts its unmet operands. A first operand is unmet at a place outside of
/// it; a cut is unmet at a place inside of it. A place is in the gate if the count is zero. A union is stored as its
/// complement, with all its operands as cuts. So its count is zero outside of the union, and `is_union` reverses the
/// result.
#[derive(Debug)]
pub struct Csg {
    /// Blocks of the first operands that are shapes: they contain the whole.
    firsts: Vec<u32>,
    /// The blocks of the other shapes.
    others: Forest,
    /// All gates: the gate of the whole comes first, and each gate before the gates that are its operands.
    gates: Vec<Gate>,
    /// How many operands of each gate are unmet at a place outside of all shapes.
    unmet: Vec<u32>,
    /// The greatest extent of the shapes.
    extent: f64,
    /// A quicker way to find the first place, if there are only a few shapes, all with lanes.
    pub spans: Option<Spans>,
}

/// The most crossings with which a sweep stops early. Each block of a sweep goes through all crossings again, so with
/// more it is quicker to list all that the ray may cross.
const MAX_SWEPT_CROSSINGS: usize = 64;

/// The most operands with boxes that are asked without a test of their boxes.
const MAX_LOOSE: usize = 4;

impl Csg {
    pub fn new(leaves: &[Leaf], operands: Operands, blocks: &mut Vec<Block>) -> Csg {
        let mut unmet = vec![0; operands.gates.len()];
        for leaf in operands.all().map(|leaf| &leaves[leaf as usize]) {
            unmet[leaf.gate as usize] += u32::from(!leaf.is_cut);
        }
        for (number, gate) in operands.gates.iter().enumerate().skip(1).rev() {
            let is_in = (unmet[number] == 0) != gate.is_union;
            unmet[gate.parent as usize] += u32::from(is_in == gate.is_cut);
        }
        let extents = operands.all().map(|leaf| leaves[leaf as usize].extent);
        let extent = extents.fold(0.0, f64::max);
        let spans = Spans::new(leaves, &operands);
        let first = blocks.len() as u32;
        in_loose_blocks(leaves, &operands.firsts, blocks);
        let firsts = (first..blocks.len() as u32).collect();
        let (mut loose, mut boxes) = (operands.loose, operands.boxes);
        if boxes.len() <= MAX_LOOSE {
            loose.extend(boxes.drain(..).map(|(leaf, _)| leaf));
        }
        Csg {
            firsts,
            others: Forest::new(leaves, &loose, boxes, blocks),
            gates: operands.gates,
            unmet,
            extent,
            spans,
        }
    }

    /// Updates the counts `unmet` for a place that moves into a leaf (`goes_in`) or out of it.
    #[inline]
    fn enter_or_leave(&self, leaf: &Leaf, goes_in: bool, unmet: &mut [u32]) {
        let (mut gate, mut is_cut, mut goes_in) = (leaf.gate as usize, leaf.is_cut, goes_in);
        loop {
            let was_in = unmet[gate] == 0;
            match goes_in == is_cut {
                true => unmet[gate] += 1,
                false => unmet[gate] = unmet[gate].saturating_sub(1),
            }
            let is_in = unmet[gate] == 0;
            if is_in == was_in || gate == 0 {
                return;
            }
            let this = self.gates[gate];
            goes_in = is_in != this.is_union;
            (gate, is_cut) = (this.parent as usize, this.is_cut);
        }
    }
}

/// Rounding may have decided something.
struct Doubt;

/// The ray in the space of the operands that were asked last.
struct Space {
    placement: u32,
    probe: Probe,
}

impl Space {
    const NONE: Space = Space {
        placement: 0,
        probe: Probe::NONE,
    };
}

/// A bound, in t, on the error of crossings with shapes of this extent, together with the skin at the ray's start.
#[inline(always)]
fn hair(query: &Query, probe: &Probe, extent: f64) -> f64 {
    query.skin + BENT * ((probe.reach + extent) * probe.per_pace + 1.0)
}

/// The t by which a difference has surely begun, or is over, provided that no other cut begins before it: the ray has
/// come into all first operands and out of all cuts. Infinite if it never comes out of some cut. The first `firsts`
/// events are crossings with first operands; crossings with cuts follow, cut by cut, each in order.
fn uncovered(events: &[Crossing], firsts: usize) -> f64 {
    let (firsts, cuts) = events.split_at(firsts);
    let ways_in = firsts.iter().filter(|event| !event.is_exit);
    let last = |t: f64, event: &Crossing| t.max(event.end.t + event.end.error);
    let mut t = ways_in.fold(0.0, last);
    loop {
        let before = t;
        let mut rest = cuts;
        while let [event, others @ ..] = rest {
            let (from, out) = match (event.is_exit, others) {
                (true, _) => (f64::NEG_INFINITY, Some(event)),
                (false, [next, ..]) if next.is_exit && next.surface == event.surface => {
                    (event.end.t - event.end.error, Some(next))
                }
                (false, _) => (event.end.t - event.end.error, None),
            };
            rest = match out {
                Some(out) if !std::ptr::eq(out, event) => &others[1..],
                _ => others,
            };
            if from <= t {
                t = out.map_or(f64::INFINITY, |out| last(t, out));
            }
        }
        if t == before || t == f64::INFINITY {
            return t;
        }
    }
}

impl Stage<'_> {
    /// The spans of a leaf that is an intersection of a few shapes with lanes; `None` for other leaves.
    #[inline(always)]
    pub fn spans(&self, leaf: &Leaf) -> Option<&Spans> {
        match leaf.kind {
            Kind::Csg => self.csgs[leaf.primitive as usize].spans.as_ref(),
            _ => None,
        }
    }

    /// Finds where a ray crosses the boundary of intersection `number`, ahead of its start and before t = `to`: the
    /// first place, or all places, in `scratch.ahead`.
    #[inline(never)]
    pub fn boundary(
        &self,
        query: &Query,
        number: u32,
        [from, to]: [f64; 2],
        ask: Ask,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Crossed {
        let whole = &self.leaves[number as usize];
        let csg = &self.csgs[whole.primitive as usize];
        scratch.events.clear();
        scratch.ahead.clear();
        scratch.at_start.clear();
        scratch.merges += 1;
        if let Some(spans) = &csg.spans
            && ask != Ask::All
            && !query.start.within.has(number)
        {
            let packet = Packet::new([query.start; LANES], 1);
            let entry = spans.entry(self.space(), &packet, Lanes::splat(to), 1);
            if entry.rest == 0 {
                tests.shapes += spans.count();
                if entry.ahead.met == 0 {
                    return Crossed::Nothing;
                }
                scratch.ahead.push(entry.crossing(0));
                return Crossed::Ahead;
            }
        }
        scratch.unmet.clear();
        scratch.unmet.extend(&csg.unmet);
        let is_swept = ask != Ask::All && !query.start.within.has(number);
        let found = self.events(query, (whole, csg), [from, to], is_swept, (scratch, tests));
        if let Err(Doubt) = found {
            return Crossed::Doubt;
        }
        let Scratch {
            events,
            least,
            unmet,
            ahead,
            at_start,
            ..
        } = scratch;
        let mut is_in = unmet[0] == 0;
        if is_in != query.start.within.has(number) {
            return Crossed::Doubt;
        }
        match at_start[..] {
            [] => {}
            // A crossing at the start must not change whether the ray is inside.
            [(leaf, goes_in)] => {
                let leaf = &self.leaves[leaf as usize];
                csg.enter_or_leave(leaf, !goes_in, unmet);
                let was_in = unmet[0] == 0;
                csg.enter_or_leave(leaf, goes_in, unmet);
                if was_in != is_in {
                    return Crossed::Doubt;
                }
            }
            _ => return Crossed::Doubt,
        }
        events.sort_unstable_by(|a, b| a.end.t.total_cmp(&b.end.t));
        least.clear();
        least.resize(events.len(), f64::INFINITY);
        let mut t = f64::INFINITY;
        for (event, least) in events.iter().zip(&mut *least).rev() {
            t = t.min(event.end.t - event.end.error);
            *least = t;
        }
        // Whether `end` is before crossing `other` and all crossings behind that, whatever the errors.
        let is_before = |end: End, other: usize| {
            (least.get(other)).is_none_or(|&least| end.t + end.error < least)
        };
        let mut is_passed = false;
        for (i, event) in events.iter().enumerate() {
            if std::mem::take(&mut is_passed) {
                continue;
            }
            let leaf = &self.leaves[event.surface as usize];
            if let Some(next) = events.get(i + 1).filter(|_| !is_before(event.end, i + 1)) {
                // Two crossings in one place: the effect of each must not depend on which of them comes first.
                let other = &self.leaves[next.surface as usize];
                let mut after = |leaf: &Leaf, goes_in| {
                    csg.enter_or_leave(leaf, goes_in, unmet);
                    unmet[0] == 0
                };
                let [one, both] = [after(leaf, !event.is_exit), after(other, !next.is_exit)];
                let [two, before] = [after(leaf, event.is_exit), after(other, next.is_exit)];
                let is_free = (before != one) == (two != both) && (one != both) == (before != two);
                let are_two = is_before(event.end, i + 2) && is_before(next.end, i + 2);
                // Two faces in one plane are crossed together, so neither comes first.
                let cancel = || before == both && self.are_flush(query, [event, next]);
                match are_two {
                    true if is_free => {}
                    true if cancel() => {
                        csg.enter_or_leave(leaf, !event.is_exit, unmet);
                        csg.enter_or_leave(other, !next.is_exit, unmet);
                        is_passed = true;
                        continue;
                    }
                    _ => return Crossed::Doubt,
                }
            }
            csg.enter_or_leave(leaf, !event.is_exit, unmet);
            if is_in != (unmet[0] == 0) {
                is_in = !is_in;
                ahead.push(*event);
                if ask != Ask::All {
                    break;
                }
            }
        }
        match ahead[..] {
            [] => Crossed::Nothing,
            _ => Crossed::Ahead,
        }
    }

    /// Lists the crossings of a ray with operands in `scratch.events`, and counts the operands that the ray starts in.
    /// If `is_swept`, crossings behind the first place of the boundary may be missing.
    fn events(
        &self,
        query: &Query,
        (whole, csg): (&Leaf, &Csg),
        [from, to]: [f64; 2],
        is_swept: bool,
        (scratch, tests): (&mut Scratch, &mut Tests),
    ) -> Result<(), Doubt> {
        let mut space = Space::NONE;
        // Beyond the way out of the first operands nothing matters.
        let mut end = to;
        for &block in &csg.firsts {
            let before = (scratch.unmet[0], scratch.events.len());
            let block = &self.blocks[block as usize];
            let stretch = [from, f64::INFINITY];
            self.operands((query, &mut space), block, stretch, csg, scratch)?;
            let met = &scratch.events[before.1..];
            if (scratch.unmet[0], scratch.events.len()) == before {
                // The ray neither starts in these first operands nor meets them: it misses the whole.
                scratch.events.clear();
                return Ok(());
            }
            let out = met.iter().filter(|event| event.is_exit);
            let out = out.map(|event| event.end.t + event.end.error);
            let last = out.fold(f64::NEG_INFINITY, f64::max);
            if block.leaves[1] == NONE && last > f64::NEG_INFINITY {
                end = end.min(last);
            }
        }
        tests.shapes += csg.firsts.len() as u32;
        let firsts = scratch.events.len();
        for &block in &csg.others.loose {
            let block = &self.blocks[block as usize];
            self.operands((query, &mut space), block, [from, end], csg, scratch)?;
        }
        if csg.others.tree.nodes.is_empty() {
            return Ok(());
        }
        let beam = Beam::new(
            &self.line_through(&query.line, whole.chain),
            &csg.others.frame,
        );
        // The sweep looks at all cuts that begin before the first uncovered place of the first operands.
        let is_swept = is_swept && csg.gates.len() == 1;
        let margin = 2.0 * hair(query, &query.probe, csg.extent);
        let needed = |events: &[Crossing]| match is_swept && events.len() <= MAX_SWEPT_CROSSINGS {
            true => end.min(uncovered(events, firsts) + margin),
            false => end,
        };
        let mut reach = beam.pace(needed(&scratch.events));
        let ends = [0.0, beam.pace(end)];
        let Inner {
            mut pending,
            mut beyond,
        } = std::mem::take(&mut scratch.inner);
        pending.clear();
        beyond.clear();
        pending.push((0.0, Child::ROOT));
        let mut result = Ok(());
        while result.is_ok() {
            let Some((near, child)) = pending.pop() else {
                let is_needed = |&mut (near, _): &mut (f32, Child)| near <= reach;
                pending.extend(beyond.extract_if(.., is_needed));
                match pending.is_empty() {
                    true => break,
                    false => continue,
                }
            };
            if near > reach {
                beyond.push((near, child));
                continue;
            }
            match child.is() {
                Is::Node(node) => {
                    tests.boxes += CHILDREN as u32;
                    let node = &csg.others.tree.nodes[node as usize];
                    let nearest = beam.nearest(node, ends, &mut pending);
                    pending.extend(nearest);
                }
                Is::Item(block) => {
                    tests.shapes += 1;
                    let block = &self.blocks[block as usize];
                    let stretch = [from, end];
                    result = self.operands((query, &mut space), block, stretch, csg, scratch);
                    if is_swept {
                        reach = reach.max(beam.pace(needed(&scratch.events)));
                    }
                }
            }
        }
        scratch.inner = Inner { pending, beyond };
        result
    }

    /// Lists the crossings of a ray with one operand, as the arbiter's formulas find them.
    fn operand(
        &self,
        query: &Query,
        surface: u32,
        from: f64,
        csg: &Csg,
        scratch: &mut Scratch,
    ) -> Result<(), Doubt> {
        let leaf = &self.leaves[surface as usize];
        let mut roots = std::mem::take(&mut scratch.roots);
        // The whole line is asked: a way out that is far away may mean that the start is inside.
        let everywhere = [from, f64::INFINITY];
        let crossed = self.cross(query, surface, everywhere, Ask::All, &mut roots);
        let listed = match crossed {
            Raw::Doubt => Err(Doubt),
            Raw::Nothing | Raw::Somewhere => Ok(()),
            Raw::Ahead { line, mut inside } => {
                if inside {
                    csg.enter_or_leave(leaf, true, &mut scratch.unmet);
                }
                for &root in &roots.list {
                    scratch.events.push(Crossing {
                        surface,
                        root,
                        end: self.end(leaf, &line, root),
                        is_exit: inside,
                    });
                    inside = !inside;
                }
                Ok(())
            }
        };
        scratch.roots = roots;
        listed
    }

    /// Lists the crossings of a ray with the operands in a block.
    #[inline(always)]
    fn operands(
        &self,
        (query, space): (&Query, &mut Space),
        block: &Block,
        [from, to]: [f64; 2],
        csg: &Csg,
        scratch: &mut Scratch,
    ) -> Result<(), Doubt> {
        if let Shapes::Single = block.shapes {
            return self.operand(query, block.leaves[0], from, csg, scratch);
        }
        let (start, skin) = (query.start, query.skin);
        if block.placement != space.placement {
            space.placement = block.placement;
            self.placed(&query.probe, block.placement, &mut space.probe);
        }
        let probe = match block.placement {
            0 => &query.probe,
            _ => &space.probe,
        };
        let hair = hair(query, probe, block.extent);
        let chords = block.chords(probe, -hair, to + hair);
        let (near_ends, far_ends) = (chords.near.to_array(), chords.far.to_array());
        let mut maybe = chords.maybe;
        while maybe != 0 {
            let lane = maybe.trailing_zeros() as usize % 4;
            maybe &= maybe - 1;
            let surface = block.leaves[lane];
            let leaf = &self.leaves[surface as usize];
            let note = |end: End, is_exit: bool, scratch: &mut Scratch| {
                scratch.events.push(Crossing {
                    surface,
                    root: Root {
                        t: end.t,
                        face: UNKNOWN_FACE,
                    },
                    end,
                    is_exit,
                });
            };
            if leaf.twin == start.left {
                if start.goes_in && leaf.kind == Kind::Quadric {
                    self.operand(query, surface, from, csg, scratch)?;
                } else if start.goes_in {
                    csg.enter_or_leave(leaf, true, &mut scratch.unmet);
                    // A ray that goes into a half-space never comes out of it.
                    if leaf.kind != Kind::HalfSpace {
                        let out = leaf.way_out(probe, skin).ok_or(Doubt)?;
                        note(out, true, scratch);
                    }
                }
                continue;
            }
            if chords.sure >> lane & 1 == 0 {
                return Err(Doubt);
            }
            let far = leaf.rough(probe, far_ends[lane], false);
            if far.t < -(skin + far.error) {
                continue;
            }
            let near = leaf.rough(probe, near_ends[lane], true);
            let is_met_ahead = near.t > skin + near.error;
            let is_left_ahead = far.t > skin + far.error;
            let is_met_before = near.t < -(skin + near.error);
            match (is_met_ahead, is_left_ahead) {
                (true, _) => note(near, false, scratch),
                (false, true) => csg.enter_or_leave(leaf, true, &mut scratch.unmet),
                (false, false) if is_met_before => {}
                (false, false) => return Err(Doubt),
            }
            if !(is_met_ahead || is_met_before && is_left_ahead) {
                scratch.at_start.push((surface, is_left_ahead));
            }
            if (is_met_ahead || is_left_ahead) && far.t < f64::INFINITY {
                note(far, true, scratch);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Out of a first operand from 1 to 9 cuts are taken that hide each other's ends, and one that begins behind those.
    #[test]
    fn the_first_uncovered_place() {
        let event = |surface: u32, t: f64, is_exit: bool| Crossing {
            surface,
            end: End { t, error: 0.0 },
            is_exit,
            ..Crossing::NONE
        };
        let first = [event(0, 1.0, false), event(0, 9.0, true)];
        let cuts = [
            event(1, 2.5, false),
            event(1, 4.0, true),
            // The ray starts in this one.
            event(2, 2.0, true),
            event(3, 1.5, false),
            event(3, 3.0, true),
            event(4, 5.0, false),
            event(4, 6.0, true),
        ];
        let all = |cuts: &[Crossing]| uncovered(&[&first[..], cuts].concat(), 2);
        assert_eq!(all(&cuts), 4.0);
        assert_eq!(all(&cuts[..2]), 1.0);
        assert_eq!(all(&cuts[2..]), 3.0);
        // One without a way out.
        assert_eq!(all(&[event(1, 0.5, false)]), f64::INFINITY);
        assert_eq!(uncovered(&[], 0), 0.0);
    }
}
