//! How much light of a lamp gets to a point.

use super::block::Shapes;
use super::leaf::{Kind, Leaf};
use super::probe::Probe;
use super::query::{Ask, BENT, Crossed, Crossing, End, NONE, Query, Start, Tests};
use super::scratch::{Face, Passed, Scratch};
use super::stage::Stage;
use crate::geometry::vec::Vec3;
use crate::geometry::wide_bvh::{Beam, Is, WIDTH as CHILDREN};

/// The light of a lamp that is left behind everything on its way.
#[derive(Debug, Clone, Copy)]
pub enum Light {
    /// The lamp is seen, with this share of its light left.
    Seen(Vec3),
    Dark,
    /// The kernel does not know.
    Doubtful,
}

/// How a block is in the way of light.
enum Found {
    Nothing,
    Dark,
    Doubt,
}

/// The t at which rays to lamps end, just before the lamp at t = 1: see
/// [`AT_LAMP`](crate::trace::precision::Precision::AT_LAMP).
pub const TO: f64 = 1.0 - 1.0 / (1u64 << 27) as f64;
/// The most transparent leaves on the way to a lamp, and the most opaque leaves that may be hidden. With more, the ray
/// is in doubt.
const MAX_PASSED: usize = 64;
/// A face before the start of every ray.
const BEFORE: Face = Face {
    end: End {
        t: -1.0,
        error: 0.0,
    },
    surface: NONE,
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
    /// The share of light that gets along a ray to a lamp at t = 1. `along` are the numbers of the blocks on its way,
    /// if they are known; `last` is the block that was in the way of the lamp's light last.
    #[inline(always)]
    pub fn light(
        &self,
        start: &Start,
        along: Option<&[u32]>,
        last: &mut u32,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Light {
        if start.within.is_empty() && along.is_some_and(|along| along.is_empty()) {
            return Light::Seen(Vec3::ONE);
        }
        let query = Query::new(start);
        scratch.passed.clear();
        scratch.opaque.clear();
        for solid in start.within.0.into_iter().filter(|&solid| solid != NONE) {
            if !self.leaves_own(&query, solid, scratch, tests) {
                return Light::Doubtful;
            }
            let is_left = scratch
                .passed
                .last()
                .is_some_and(|own| own.far.surface != NONE);
            if is_left && !self.lets_light_through {
                return match solid == start.within.owner() {
                    true => Light::Dark,
                    false => Light::Doubtful,
                };
            }
        }
        let own = [scratch.passed.len(), scratch.opaque.len()];
        match along {
            Some(along) => {
                for &block in along {
                    match self.in_the_way(&query, block, scratch, tests) {
                        Found::Nothing => {}
                        Found::Doubt => return Light::Doubtful,
                        Found::Dark => return Light::Dark,
                    }
                }
            }
            None => {
                let beam = Beam::new(&query.line, &self.all.frame);
                let ends = [0.0, beam.pace(1.0)];
                if *last != NONE {
                    if let Found::Dark = self.in_the_way(&query, *last, scratch, tests) {
                        return Light::Dark;
                    }
                    // The walk meets this block once more.
                    scratch.passed.truncate(own[0]);
                    scratch.opaque.truncate(own[1]);
                }
                self.begin(scratch);
                let mut next = None;
                while let Some((_, child)) = next.take().or_else(|| scratch.pending.pop()) {
                    let block = match child.is() {
                        Is::Node(node) => {
                            tests.boxes += CHILDREN as u32;
                            let node = &self.all.tree.nodes[node as usize];
                            next = beam.first(node, ends, |near, child| {
                                scratch.pending.push((near, child));
                            });
                            continue;
                        }
                        Is::Item(block) => block,
                    };
                    match self.in_the_way(&query, block, scratch, tests) {
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
        let Scratch { opaque, passed, .. } = &*scratch;
        let is_seen =
            |own: &Passed| !self.may_be_hidden(own, passed) && !self.may_be_hidden(own, opaque);
        if opaque.iter().any(is_seen) {
            return Light::Dark;
        }
        match scratch.opaque[..] {
            [] => self.share(scratch),
            _ if !self.lets_light_through => Light::Doubtful,
            _ => self.share_with_opaque(&query, scratch, tests),
        }
    }

    /// Notes the leaves of a block that are in the way of light.
    #[inline(always)]
    fn in_the_way(
        &self,
        query: &Query,
        block: u32,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> Found {
        let block = &self.blocks[block as usize];
        tests.shapes += 1;
        if let Shapes::Single = block.shapes {
            return self.meets_single(query, block.leaves[0], (scratch, tests));
        }
        let (start, skin) = (query.start, query.skin);
        let mut moved = Probe::NONE;
        let probe = self.placed(&query.probe, block.placement, &mut moved);
        let hair = BENT * 2.0 * ((probe.reach + block.extent) * probe.per_pace + 1.0);
        let chords = block.chords(probe, -(skin + hair), 1.0 + hair);
        let (near_ends, far_ends) = (chords.near.to_array(), chords.far.to_array());
        let mut maybe = chords.maybe;
        while maybe != 0 {
            let lane = maybe.trailing_zeros() as usize % 4;
            maybe &= maybe - 1;
            let own = block.leaves[lane];
            let leaf = &self.leaves[own as usize];
            if start.within.has(own) {
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
            let out = leaf.rough(probe, far_ends[lane], false);
            if out.t < -(skin + out.error) {
                continue;
            }
            let end = leaf.rough(probe, near_ends[lane], true);
            if end.t - end.error > TO {
                continue;
            }
            if end.t <= skin + end.error {
                return Found::Doubt;
            }
            let faces = [end, out].map(|end| Face { end, surface: own });
            match self.note_chord(own, faces, scratch) {
                Found::Nothing => {}
                found => return found,
            }
        }
        Found::Nothing
    }

    /// Notes a leaf that light enters at the face `near` and leaves at `far`, both ahead of the ray's start.
    #[inline(always)]
    fn note_chord(&self, number: u32, [near, far]: [Face; 2], scratch: &mut Scratch) -> Found {
        let leaf = &self.leaves[number as usize];
        let passed = Passed {
            leaf: number,
            near,
            far,
        };
        if leaf.is_clear && self.lets_light_through {
            return match self.note_passed(passed, scratch) {
                true => Found::Nothing,
                false => Found::Doubt,
            };
        }
        match is_on_the_way(near.end) {
            Some(true) if leaf.is_lone => return Found::Dark,
            Some(true) if scratch.opaque.len() < MAX_PASSED => scratch.opaque.push(passed),
            Some(_) => {}
            None => return Found::Doubt,
        }
        Found::Nothing
    }

    /// Notes how a leaf without lanes is in the way of the light.
    #[inline(never)]
    fn meets_single(
        &self,
        query: &Query,
        number: u32,
        (scratch, tests): (&mut Scratch, &mut Tests),
    ) -> Found {
        if query.start.within.has(number) {
            return Found::Nothing;
        }
        let leaf = &self.leaves[number as usize];
        let stretch = [-query.skin, 1.0];
        let ask = match (leaf.is_clear, leaf.is_lone) {
            (true, _) => Ask::All,
            (false, true) => Ask::Any,
            (false, false) => Ask::First,
        };
        match self.meet_single(query, number, stretch, ask, (scratch, tests)) {
            Crossed::Nothing => return Found::Nothing,
            Crossed::Somewhere => return Found::Dark,
            Crossed::Doubt => return Found::Doubt,
            Crossed::Ahead => {}
        }
        let ahead = std::mem::take(&mut scratch.ahead);
        let found = self.note_chords(number, &ahead, scratch);
        scratch.ahead = ahead;
        found
    }

    /// Notes a leaf that light meets from outside: a chord for each pair of the crossings `ahead`.
    fn note_chords(&self, number: u32, ahead: &[Crossing], scratch: &mut Scratch) -> Found {
        let note = |faces| self.note_chord(number, faces, scratch);
        chords(&self.leaves[number as usize], ahead)
            .map(note)
            .find(|found| !matches!(found, Found::Nothing))
            .unwrap_or(Found::Nothing)
    }

    /// Notes where light leaves a solid that it starts in; `false` if the place is not known.
    #[inline(always)]
    fn leaves_own(
        &self,
        query: &Query,
        own: u32,
        scratch: &mut Scratch,
        tests: &mut Tests,
    ) -> bool {
        let leaf = &self.leaves[own as usize];
        let far = if matches!(leaf.kind, Kind::Quadric | Kind::Other | Kind::Csg) {
            let everywhere = [-query.skin, f64::INFINITY];
            match self.meet_single(query, own, everywhere, Ask::All, (scratch, tests)) {
                Crossed::Ahead => {
                    let mut ahead = std::mem::take(&mut scratch.ahead);
                    let far = ahead.first().map(|crossing| Face {
                        end: crossing.end,
                        surface: crossing.surface,
                    });
                    ahead.drain(..ahead.len().min(1));
                    // The ray may come back into the solid.
                    let found = self.note_chords(own, &ahead, scratch);
                    scratch.ahead = ahead;
                    far.filter(|_| matches!(found, Found::Nothing))
                }
                Crossed::Nothing | Crossed::Somewhere | Crossed::Doubt => None,
            }
        } else {
            let mut moved = Probe::NONE;
            let probe = self.placed(&query.probe, leaf.placement, &mut moved);
            let end = leaf.way_out(probe, query.skin);
            end.map(|end| Face { end, surface: own })
        };
        let Some((mut far, is_left)) = far.and_then(|far| Some((far, is_on_the_way(far.end)?)))
        else {
            return false;
        };
        if !is_left {
            far.surface = NONE;
        }
        scratch.passed.push(Passed {
            leaf: own,
            near: BEFORE,
            far,
        });
        true
    }

    /// Whether the near face of the leaf `opaque` may be hidden in one of the `others`: an earlier operand owns the
    /// points that both hold, and within one medium there are no faces. Light gets into an opaque leaf only where its
    /// near face is hidden.
    #[inline]
    fn may_be_hidden(&self, opaque: &Passed, others: &[Passed]) -> bool {
        let leaf = |passed: &Passed| &self.leaves[passed.leaf as usize];
        let (own, end) = (leaf(opaque), opaque.near.end);
        let may_hide = |other: &Passed| {
            other.leaf != opaque.leaf
                && (leaf(other).operand < own.operand || leaf(other).look.medium == own.look.medium)
        };
        let is_apart =
            |other: &Passed| end.is_before(other.near.end) || other.far.end.is_before(end);
        (others.iter()).any(|other| may_hide(other) && !is_apart(other))
    }

    /// The light that is left if each opaque leaf on the way begins in something that hides its near face.
    #[cold]
    fn share_with_opaque(&self, query: &Query, scratch: &mut Scratch, tests: &mut Tests) -> Light {
        let opaque = std::mem::take(&mut scratch.opaque);
        let mut is_known = opaque.len() < MAX_PASSED;
        for &passed in &opaque {
            let leaf = &self.leaves[passed.leaf as usize];
            if !matches!(leaf.kind, Kind::Other | Kind::Csg) {
                is_known &= self.note_passed(passed, scratch);
                continue;
            }
            let stretch = [-query.skin, 1.0];
            let crossed = self.meet_single(query, passed.leaf, stretch, Ask::All, (scratch, tests));
            is_known &= matches!(crossed, Crossed::Ahead);
            let ahead = std::mem::take(&mut scratch.ahead);
            for [near, far] in chords(leaf, &ahead) {
                let leaf = passed.leaf;
                is_known &= self.note_passed(Passed { leaf, near, far }, scratch);
            }
            scratch.ahead = ahead;
        }
        scratch.opaque = opaque;
        match is_known {
            true => self.share_of_many(scratch),
            false => Light::Doubtful,
        }
    }

    /// Notes a leaf that light passes, if it begins before the lamp. `false` if that is not known, or if there are too
    /// many.
    #[inline(always)]
    fn note_passed(&self, mut passed: Passed, scratch: &mut Scratch) -> bool {
        let is_solid = self.leaves[passed.leaf as usize].is_solid;
        match (
            is_on_the_way(passed.near.end),
            is_on_the_way(passed.far.end),
        ) {
            (Some(false), _) => return true,
            (Some(true), Some(true)) if is_solid => {}
            (Some(true), Some(_)) => passed.far.surface = NONE,
            _ => return false,
        }
        let has_room = scratch.passed.len() < MAX_PASSED;
        if has_room {
            scratch.passed.push(passed);
        }
        has_room
    }

    /// The light that is left behind all leaves that it passes.
    #[inline(always)]
    fn share(&self, scratch: &mut Scratch) -> Light {
        match &scratch.passed[..] {
            [] => Light::Seen(Vec3::ONE),
            [passed] => {
                let share = self.behind(Vec3::ONE, passed.near);
                Light::Seen(self.behind(share, passed.far))
            }
            _ => self.share_of_many(scratch),
        }
    }

    /// The share of light that is left behind a face.
    #[inline(always)]
    fn behind(&self, share: Vec3, face: Face) -> Vec3 {
        match self.leaves.get(face.surface as usize) {
            Some(leaf) => share.times(Vec3(leaf.look.kt)),
            None => share,
        }
    }

    /// The share of light that several leaves let through. Faces that are hidden in earlier operands do not count.
    #[inline(never)]
    fn share_of_many(&self, Scratch { passed, faces, .. }: &mut Scratch) -> Light {
        faces.clear();
        for (number, passed) in (0..).zip(&*passed) {
            let both = [passed.near, passed.far].into_iter();
            faces.extend(
                both.filter(|face| face.surface != NONE)
                    .map(|face| (face, number)),
            );
        }
        faces.sort_unstable_by(|(a, _), (b, _)| a.end.t.total_cmp(&b.end.t));
        let mut share = Vec3::ONE;
        let mut before: Option<Face> = None;
        for &(face, number) in &*faces {
            let own = &self.leaves[passed[number as usize].leaf as usize];
            if !own.is_lone && own.is_solid {
                let mut around: Option<&Leaf> = None;
                let mut is_hidden = false;
                for (_, other) in (0..).zip(&*passed).filter(|(other, _)| *other != number) {
                    if face.end.is_before(other.near.end) || other.far.end.is_before(face.end) {
                        continue;
                    }
                    let is_in =
                        other.near.end.is_before(face.end) && face.end.is_before(other.far.end);
                    let leaf = &self.leaves[other.leaf as usize];
                    if !(is_in && leaf.is_solid) {
                        return Light::Doubtful;
                    }
                    is_hidden |= leaf.operand < own.operand;
                    if around.is_none_or(|around| leaf.operand < around.operand) {
                        around = Some(leaf);
                    }
                }
                if is_hidden {
                    continue;
                }
                // The same medium on both sides: there is no surface.
                if around.is_some_and(|around| around.look.medium == own.look.medium) {
                    continue;
                }
            }
            let is_next = |before: Face| {
                let kt = [before, face].map(|face| self.leaves[face.surface as usize].look.kt);
                before.end.is_before(face.end) || kt[0] == kt[1]
            };
            if !before.is_none_or(is_next) {
                return Light::Doubtful;
            }
            share = self.behind(share, face);
            if !share.any() {
                return Light::Dark;
            }
            before = Some(face);
        }
        Light::Seen(share)
    }
}

/// The faces where light meets a leaf from outside and leaves it, chord by chord. On a surface without an inside both
/// are one place.
fn chords(leaf: &Leaf, ahead: &[Crossing]) -> impl Iterator<Item = [Face; 2]> {
    let is_solid = leaf.is_solid;
    let face = |crossing: &Crossing| Face {
        end: crossing.end,
        surface: crossing.surface,
    };
    let endless = Face {
        end: End::NEVER,
        surface: NONE,
    };
    ahead
        .chunks(if is_solid { 2 } else { 1 })
        .map(move |chord| match chord {
            [near, far] => [face(near), face(far)],
            [near] if is_solid => [face(near), endless],
            _ => [face(&chord[0]); 2],
        })
}
