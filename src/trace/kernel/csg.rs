//! Intersections and differences, of shapes or of other operations: the places where a ray crosses any of the shapes are
//! put in order, and at each one it is told whether the whole begins or ends there.

use super::block::{Block, Shapes, in_blocks};
use super::expand::{Gate, Operands};
use super::lanes::{LANES, Lanes};
use super::leaf::{Kind, Leaf};
use super::packet::Packet;
use super::probe::Probe;
use super::query::{Ask, BENT, Crossed, Crossing, End, NONE, Query, Tests, UNKNOWN_FACE};
use super::scalar::Raw;
use super::scratch::Scratch;
use super::spans::Spans;
use super::stage::{Forest, Stage};
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH as CHILDREN};
use crate::trace::shapes::Root;

/// An intersection as a ray walks it.
///
/// Each gate counts its unmet operands: a first one is unmet where the place is not in it, a cut where the place is in it.
/// Where the count is zero the place is in the gate. A union is kept as its complement: what is in none of its operands,
/// which are cuts of it. So its count is zero outside of the union, and `is_union` turns the result round.
#[derive(Debug)]
pub struct Csg {
    /// Blocks of shapes that all of it is in.
    firsts: Vec<u32>,
    /// The other shapes.
    others: Forest,
    /// That of the whole comes first, each one before its operands.
    gates: Vec<Gate>,
    /// How many operands of each gate are unmet at a place outside of all shapes.
    unmet: Vec<u32>,
    /// A quicker way to the first place, if there are few shapes.
    pub spans: Option<Spans>,
}

/// So few operands are asked without a look at their boxes.
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
        let spans = Spans::new(leaves, &operands);
        let first = blocks.len() as u32;
        in_blocks(leaves, &operands.firsts, blocks);
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
            spans,
        }
    }

    /// Counts that a place goes into a shape, or out of it.
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

impl Stage<'_> {
    /// The operands of a leaf that is an intersection of a few shapes.
    #[inline(always)]
    pub fn spans(&self, leaf: &Leaf) -> Option<&Spans> {
        match leaf.kind {
            Kind::Csg => self.csgs[leaf.primitive as usize].spans.as_ref(),
            _ => None,
        }
    }

    /// Finds where a ray crosses the boundary of an intersection ahead of its start, up to some t: the first place, or all
    /// of them.
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
        if let Err(Doubt) = self.events(query, whole, csg, [from, to], scratch, tests) {
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
        // Whether one is before another and all behind that, whatever the errors.
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
                // Two in one place: what each of them does must not depend on which comes first.
                let other = &self.leaves[next.surface as usize];
                let mut after = |leaf: &Leaf, goes_in| {
                    csg.enter_or_leave(leaf, goes_in, unmet);
                    unmet[0] == 0
                };
                let [one, both] = [after(leaf, !event.is_exit), after(other, !next.is_exit)];
                let [two, before] = [after(leaf, event.is_exit), after(other, next.is_exit)];
                let is_free = (before != one) == (two != both) && (one != both) == (before != two);
                let are_two = is_before(event.end, i + 2) && is_before(next.end, i + 2);
                // Of faces in one plane neither comes first.
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

    /// Lists where a ray crosses operands, and goes into those that it starts in.
    fn events(
        &self,
        query: &Query,
        whole: &Leaf,
        csg: &Csg,
        [from, to]: [f64; 2],
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Result<(), Doubt> {
        // Beyond the way out of the first operands nothing matters.
        let mut end = to;
        for &block in &csg.firsts {
            let before = (scratch.unmet[0], scratch.events.len());
            let block = &self.blocks[block as usize];
            self.operands(query, block, [from, f64::INFINITY], csg, scratch)?;
            let met = &scratch.events[before.1..];
            if (scratch.unmet[0], scratch.events.len()) == before {
                // Neither in it nor before it.
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
        for &block in &csg.others.loose {
            let block = &self.blocks[block as usize];
            self.operands(query, block, [from, end], csg, scratch)?;
        }
        if csg.others.tree.nodes.is_empty() {
            return Ok(());
        }
        let beam = Beam::new(
            &self.line_through(&query.line, whole.chain),
            &csg.others.frame,
        );
        let ends = [0.0, beam.pace(end)];
        let mut pending = std::mem::take(&mut scratch.inner);
        pending.clear();
        pending.push(Child::ROOT);
        let mut result = Ok(());
        while let Some(child) = pending.pop() {
            match child.is() {
                Is::Node(node) => {
                    tests.boxes += CHILDREN as u32;
                    let node = &csg.others.tree.nodes[node as usize];
                    let first = beam.first(node, ends, |_, child| pending.push(child));
                    pending.extend(first.map(|(_, child)| child));
                }
                Is::Item(block) => {
                    tests.shapes += 1;
                    let block = &self.blocks[block as usize];
                    let stretch = [from, end];
                    result = self.operands(query, block, stretch, csg, scratch);
                    if result.is_err() {
                        break;
                    }
                }
            }
        }
        scratch.inner = pending;
        result
    }

    /// Lists where a ray crosses an operand, as the arbiter finds it.
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
        // All of the line: a way out that is far away may mean that the start is inside.
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

    /// Lists where a ray crosses the operands in a block.
    #[inline(always)]
    fn operands(
        &self,
        query: &Query,
        block: &Block,
        [from, to]: [f64; 2],
        csg: &Csg,
        scratch: &mut Scratch,
    ) -> Result<(), Doubt> {
        if let Shapes::Single = block.shapes {
            return self.operand(query, block.leaves[0], from, csg, scratch);
        }
        let (start, skin) = (query.start, query.skin);
        let mut moved = Probe::NONE;
        let probe = self.placed(&query.probe, block.placement, &mut moved);
        let hair = skin + BENT * ((probe.reach + block.extent) * probe.per_pace + 1.0);
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
                    // There is no way out of a half-space for what has come in.
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
