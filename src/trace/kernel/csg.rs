//! Intersections and differences: what is in all of some solids and in none of some others, the cuts.

use super::leaf::{Kind, Leaf};
use super::probe::Probe;
use super::query::{Ask, BENT, Crossed, Crossing, End, NONE, Query, Tests};
use super::scalar::Raw;
use super::scratch::{Event, Scratch};
use super::stage::{Block, Csg, Shapes, Stage};
use crate::geometry::wide_bvh::{Beam, Child, Is, WIDTH};
use crate::trace::shapes::Root;

/// How many of the operands a place is in.
#[derive(Debug, Clone, Copy, Default)]
struct State {
    firsts: usize,
    cuts: usize,
}

impl State {
    fn after(mut self, event: &Event) -> State {
        let count = match event.is_cut {
            true => &mut self.cuts,
            false => &mut self.firsts,
        };
        match event.goes_in {
            true => *count += 1,
            false => *count = count.saturating_sub(1),
        }
        self
    }
}

/// Rounding may have decided something.
struct Doubt;

impl Stage<'_> {
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
        scratch.merges += 1;
        let Ok(mut state) = self.events(query, whole, csg, [from, to], scratch, tests) else {
            return Crossed::Doubt;
        };
        let is_in = |state: State| state.firsts == csg.count && state.cuts == 0;
        if is_in(state) != (query.start.within == number) {
            return Crossed::Doubt;
        }
        let events = &mut scratch.events;
        events.sort_unstable_by(|a, b| a.crossing.end.t.total_cmp(&b.crossing.end.t));
        for (i, event) in events.iter().enumerate() {
            let (before, after) = (state, state.after(event));
            // Two in one place, of which the order may matter.
            let next = events.get(i + 1);
            if next.is_some_and(|next| !event.crossing.end.is_before(next.crossing.end)) {
                return Crossed::Doubt;
            }
            if is_in(before) != is_in(after) {
                scratch.ahead.push(event.crossing);
                if ask != Ask::All {
                    break;
                }
            }
            state = after;
        }
        match scratch.ahead[..] {
            [] => Crossed::Nothing,
            _ => Crossed::Ahead,
        }
    }

    /// Lists where a ray crosses operands; returns which of them it starts in.
    fn events(
        &self,
        query: &Query,
        whole: &Leaf,
        csg: &Csg,
        [from, to]: [f64; 2],
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Result<State, Doubt> {
        let mut state = State::default();
        // Beyond the way out of the first operands nothing matters.
        let mut end = to;
        for &block in &csg.firsts {
            let before = (state.firsts, scratch.events.len());
            let block = &self.blocks[block as usize];
            self.operands(
                query,
                block,
                [from, f64::INFINITY],
                false,
                (&mut state, scratch),
            )?;
            let met = &scratch.events[before.1..];
            if (state.firsts, scratch.events.len()) == before {
                // Neither in it nor before it.
                scratch.events.clear();
                return Ok(State::default());
            }
            let out = met.iter().filter(|event| !event.goes_in);
            let out = out.map(|event| event.crossing.end.t + event.crossing.end.error);
            let last = out.fold(f64::NEG_INFINITY, f64::max);
            if block.leaves[1] == NONE && last > f64::NEG_INFINITY {
                end = end.min(last);
            }
        }
        tests.shapes += csg.firsts.len() as u32;
        for &block in &csg.cuts.loose {
            let block = &self.blocks[block as usize];
            self.operands(query, block, [from, end], true, (&mut state, scratch))?;
        }
        if csg.cuts.tree.nodes.is_empty() {
            return Ok(state);
        }
        let beam = Beam::new(
            &self.line_through(&query.line, whole.chain),
            &csg.cuts.frame,
        );
        let ends = [0.0, beam.pace(end)];
        let mut pending = std::mem::take(&mut scratch.inner);
        pending.clear();
        pending.push(Child::ROOT);
        let mut result = Ok(());
        while let Some(child) = pending.pop() {
            match child.is() {
                Is::Node(node) => {
                    tests.boxes += WIDTH as u32;
                    let node = &csg.cuts.tree.nodes[node as usize];
                    let first = beam.first(node, ends, |_, child| pending.push(child));
                    pending.extend(first.map(|(_, child)| child));
                }
                Is::Item(block) => {
                    tests.shapes += 1;
                    let block = &self.blocks[block as usize];
                    let stretch = [from, end];
                    result = self.operands(query, block, stretch, true, (&mut state, scratch));
                    if result.is_err() {
                        break;
                    }
                }
            }
        }
        scratch.inner = pending;
        result.map(|()| state)
    }

    /// Lists where a ray crosses the operands in a block.
    #[inline(always)]
    fn operands(
        &self,
        query: &Query,
        block: &Block,
        [from, to]: [f64; 2],
        is_cut: bool,
        (state, scratch): (&mut State, &mut Scratch),
    ) -> Result<(), Doubt> {
        let is_inside = |state: &mut State| match is_cut {
            true => state.cuts += 1,
            false => state.firsts += 1,
        };
        if let Shapes::Alone = block.shapes {
            let surface = block.leaves[0];
            let leaf = &self.leaves[surface as usize];
            let mut roots = std::mem::take(&mut scratch.roots);
            // All of the line: what is crossed nowhere near may still be around the start.
            let everywhere = [from, f64::INFINITY];
            let crossed = self.cross(query, surface, everywhere, Ask::All, &mut roots);
            let listed = match crossed {
                Raw::Doubt => Err(Doubt),
                Raw::Nothing | Raw::Somewhere => Ok(()),
                Raw::Ahead { line, mut inside } => {
                    if inside {
                        is_inside(state);
                    }
                    for &root in &roots.list {
                        scratch.events.push(Event {
                            crossing: Crossing {
                                surface,
                                root,
                                end: self.end(leaf, &line, root),
                                is_exit: inside,
                            },
                            is_cut,
                            goes_in: !inside,
                        });
                        inside = !inside;
                    }
                    Ok(())
                }
            };
            scratch.roots = roots;
            return listed;
        }
        let (start, skin) = (query.start, query.skin);
        let mut moved = Probe::NONE;
        let probe = self.placed(&query.probe, block.placement, &mut moved);
        let hair = skin + BENT * ((probe.reach + block.extent) * probe.per_pace + 1.0);
        let chords = block.chords(probe, -hair, to + hair);
        let mut maybe = chords.maybe;
        while maybe != 0 {
            let lane = maybe.trailing_zeros() as usize % 4;
            maybe &= maybe - 1;
            let surface = block.leaves[lane];
            let leaf = &self.leaves[surface as usize];
            let mut note = |end: End, is_exit: bool| {
                let root = Root { t: end.t, face: 0 };
                scratch.events.push(Event {
                    crossing: Crossing {
                        surface,
                        root,
                        end,
                        is_exit,
                    },
                    is_cut,
                    goes_in: !is_exit,
                });
            };
            if leaf.twin == start.left {
                if start.goes_in {
                    is_inside(state);
                    // There is no way out of a half-space for what has come in.
                    if leaf.kind != Kind::HalfSpace {
                        note(self.way_out(probe, leaf, skin).ok_or(Doubt)?, true);
                    }
                }
                continue;
            }
            if chords.sure >> lane & 1 == 0 {
                return Err(Doubt);
            }
            let end = |t: f64, is_near| match t.is_finite() {
                true => self.rough(probe, leaf, t, is_near),
                false => End { t, error: 0.0 },
            };
            let far = end(chords.far[lane], false);
            if far.t < -(skin + far.error) {
                continue;
            }
            let near = end(chords.near[lane], true);
            if near.t < -(skin + near.error) && far.t > skin + far.error {
                is_inside(state);
            } else if near.t > skin + near.error {
                note(near, false);
            } else {
                return Err(Doubt);
            }
            if far.t < f64::INFINITY {
                note(far, true);
            }
        }
        Ok(())
    }
}
