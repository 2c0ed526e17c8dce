//! Partial parses. There are many ways to cut a text into pieces up to a place. For the cheapest one the state at the
//! place is known: the IDs that are defined, their kinds, and the highest ID.

use rustc_hash::FxHashMap;

use super::super::signature::{allows, fits};
use super::super::table::{Effect, Kind, Param, ParamKind, RecordKind, RecordType};
use super::diagnosis::{Diagnosis, RecordCandidate};
use super::prices::{
    CHANGES_NOTHING, DEFINED_TWICE, LIKE_A_TYPE, LIKE_AN_ID, MAY_BE_LOST, NOT_ALLOWED,
    OUT_OF_ORDER, REFERS_TO_NOTHING, RENDER_ID, WRONG_KIND,
};
use super::slips::LEAST_HEAD;
use super::stretch::Stretch;
use super::surroundings::Surroundings;

/// The last piece of the cheapest way to a place.
#[derive(Debug, Clone, Copy, Default)]
struct BackPointer {
    /// The start of the piece.
    from: u32,
    /// A place further back on the way, and how many pieces are before this one: with these, places on the way are
    /// found in a logarithmic number of jumps.
    jump: u32,
    depth: u32,
    /// The highest ID on the way.
    top: u32,
    /// Whether an ID may be defined that is not known here: a record has lost its ID, or there are other stretches.
    lost: bool,
}

/// The ID that a piece has.
#[derive(Debug, Clone, Copy)]
pub(super) enum Id {
    Is(u32),
    /// The record should have an ID and has none.
    Lost,
    None,
}

/// A piece that defines an ID: the place at which it ends, and the kind of the ID's value.
#[derive(Debug, Clone, Copy)]
struct Definition {
    end: u32,
    /// `None` if the kind cannot be told.
    kind: Option<Kind>,
}

pub(super) struct PartialParses<'a, 's> {
    stretch: &'a Stretch<'s>,
    around: &'a Surroundings,
    steps: Vec<BackPointer>,
    defined: FxHashMap<u32, Vec<Definition>>,
    /// The last places arrived at. A place far back that is on no way to one of these will be on no way later, either.
    latest: [u32; STATES],
}

/// How many ways to a token are kept apart. Each of them is a place of its own.
pub(super) const STATES: usize = 4;

/// The most definitions of an ID that are kept without a check whether they are on any way.
const DEFINITIONS: usize = 8;
/// A place this many places back is on all ways or on none.
const SETTLED: usize = 2000;

impl<'a, 's> PartialParses<'a, 's> {
    pub(super) fn new(
        stretch: &'a Stretch<'s>,
        around: &'a Surroundings,
        places: usize,
    ) -> PartialParses<'a, 's> {
        let mut steps = vec![BackPointer::default(); places];
        // The first record of a text has the ID 2, mostly.
        steps[0].top = u32::from(!stretch.is_behind(0));
        steps[0].lost = around.others;
        PartialParses {
            stretch,
            around,
            steps,
            defined: FxHashMap::default(),
            latest: [0; STATES],
        }
    }

    /// Says that the last piece of the cheapest way to place `end` begins at place `from`. `id` is the ID of the piece,
    /// and `ty` is its type, or `None` if the type is unknown.
    pub(super) fn arrive(
        &mut self,
        (from, end): (usize, usize),
        id: Id,
        ty: Option<&'static RecordType>,
    ) {
        let back = self.steps[from];
        let further = self.steps[back.jump as usize];
        let furthest = self.steps[further.jump as usize];
        let far = back.depth - further.depth == further.depth - furthest.depth;
        self.steps[end] = BackPointer {
            from: from as u32,
            jump: if far { further.jump } else { from as u32 },
            depth: back.depth + 1,
            top: back.top,
            lost: back.lost || matches!(id, Id::Lost),
        };
        self.latest[end % STATES] = end as u32;
        let Id::Is(id @ 2..) = id else { return };
        let kind = match ty.map(|t| t.effect) {
            // A copy has the kind of the original, which is not looked up.
            Some(_) if ty.is_some_and(|t| t.kind == RecordKind::Copy) => None,
            Some(Effect::Defines(kind)) => Some(kind),
            Some(Effect::DefinesOrChanges(kind, _)) if self.kind(id, from).is_none() => Some(kind),
            None => None,
            _ => return,
        };
        self.steps[end].top = back.top.max(id);
        let end = end as u32;
        self.define(id, Definition { end, kind });
    }

    fn define(&mut self, id: u32, definition: Definition) {
        let mut all = self.defined.remove(&id).unwrap_or_default();
        if all.len() >= DEFINITIONS && all.len().is_power_of_two() {
            let settled = (definition.end as usize).saturating_sub(SETTLED);
            let is_on_any = |end: u32| self.latest.iter().any(|&way| self.is_on(end, way));
            all.retain(|d| d.end as usize > settled || is_on_any(d.end));
        }
        all.push(definition);
        self.defined.insert(id, all);
    }

    /// Whether a place is on the cheapest way to another.
    fn is_on(&self, place: u32, way_to: u32) -> bool {
        let mut at = way_to;
        while at > place {
            let step = &self.steps[at as usize];
            at = if step.jump >= place {
                step.jump
            } else {
                step.from
            };
        }
        at == place
    }

    /// The kind of an ID's value at a place; `None` if the ID is not defined there, `Some(None)` if the kind cannot be
    /// told.
    fn kind(&self, id: u32, place: usize) -> Option<Option<Kind>> {
        let here = self.defined.get(&id).and_then(|all| {
            let mut all = all.iter().rev();
            all.find(|d| self.is_on(d.end, place as u32))
        });
        if let Some(definition) = here {
            return Some(definition.kind);
        }
        let (at, ty) = self.stretch.defined_elsewhere(self.around, id)?;
        self.stretch.is_behind(at).then_some(match ty.effect {
            Effect::Defines(kind) | Effect::DefinesOrChanges(kind, _) => Some(kind),
            Effect::Changes(_) => None,
        })
    }

    /// The price of doubts about the ID of a record of type `ty` that begins at a place.
    pub(super) fn id(&self, id: u32, ty: Option<&'static RecordType>, place: usize) -> u32 {
        if ty.is_some_and(|t| (t.kind == RecordKind::Render) != (id == 1)) {
            return RENDER_ID;
        }
        if id == 1 {
            return 0;
        }
        let kind = self.kind(id, place);
        let changed = |kinds: &[Kind]| match kind {
            Some(kind) if kind.is_none_or(|k| kinds.contains(&k)) => 0,
            None if self.steps[place].lost => MAY_BE_LOST,
            _ => CHANGES_NOTHING,
        };
        match (ty.map(|t| t.effect), kind) {
            (Some(Effect::Defines(_)), Some(Some(Kind::Undefined))) => 0,
            (Some(Effect::Defines(_)), Some(_)) => DEFINED_TWICE,
            (Some(Effect::Changes(kinds)), _)
            | (Some(Effect::DefinesOrChanges(_, kinds)), Some(_)) => changed(kinds),
            (None, Some(_)) => 0,
            (_, None) => self.order(id, place),
        }
    }

    /// Whether an ID is one of the four numbers behind the highest ID on the way to a place.
    pub(super) fn is_next(&self, id: u32, place: usize) -> bool {
        let top = self.steps[place].top;
        top > 0 && (top + 1..=top + 4).contains(&id)
    }

    /// The price of doubts about a token as a mere number: it could be the next ID.
    pub(super) fn like_an_id(&self, at: usize, place: usize) -> u32 {
        let id = self.stretch.sigs[at]
            .int
            .and_then(|id| u32::try_from(id).ok());
        let next = id.is_some_and(|id| self.is_next(id, place));
        if next { LIKE_AN_ID } else { 0 }
    }

    /// The price of doubts about a new ID at a place.
    fn order(&self, id: u32, place: usize) -> u32 {
        let elsewhere = self.around.is_defined(id);
        match self.steps[place].top {
            _ if elsewhere => DEFINED_TWICE,
            0 => 0,
            top if id > top => (15 * ((id - top) / 2).max(1).ilog2()).min(OUT_OF_ORDER),
            _ => OUT_OF_ORDER,
        }
    }

    /// The price of doubts about a token as a parameter, at a place.
    pub(super) fn param(&self, at: usize, ty: &RecordType, param: &Param, place: usize) -> u32 {
        let sig = &self.stretch.sigs[at];
        if !fits(sig.kind, param.kind) {
            // A bad token has its price as an error elsewhere.
            return if sig.kind.is_bad() { 0 } else { WRONG_KIND };
        }
        if !allows(param, self.stretch.value(at)) {
            return NOT_ALLOWED;
        }
        let ParamKind::Reference { kinds, or_none } = param.kind else {
            let code = sig.int.map_or(0, |code| i64::from(code.saturating_abs()));
            let is_render =
                || RecordType::by_code(code).is_some_and(|t| t.kind == RecordKind::Render);
            let is_type = code >= i64::from(-LEAST_HEAD)
                && (RecordType::by_code(-code).is_some() || is_render());
            return if is_type {
                LIKE_A_TYPE
            } else {
                self.like_an_id(at, place)
            };
        };
        match sig.int.and_then(|id| u32::try_from(id).ok()) {
            Some(0) if or_none => 0,
            Some(id) => match self.kind(id, place) {
                Some(kind) if kind.is_none_or(|k| kinds.contains(&k)) => 0,
                // Selections and the render record may name what comes later.
                None if matches!(ty.effect, Effect::Defines(Kind::Selection | Kind::Render)) => {
                    MAY_BE_LOST
                }
                None if self.steps[place].lost => MAY_BE_LOST,
                _ => REFERS_TO_NOTHING,
            },
            None => REFERS_TO_NOTHING,
        }
    }
}

/// Whether a reading by arity has no error of meaning: no ID that is defined twice, no reference to nothing, no value
/// that is not allowed.
pub(super) fn is_sound(
    stretch: &Stretch,
    around: &Surroundings,
    pieces: &[RecordCandidate],
) -> bool {
    let mut ways = PartialParses::new(stretch, around, stretch.len() + 1);
    pieces.iter().all(|piece| {
        let Diagnosis::Whole(r) = piece.verdict else {
            ways.arrive((piece.start, piece.end), Id::None, None);
            return true;
        };
        let id = stretch.sigs[piece.start].int.unwrap_or(0) as u32;
        let first = piece.start + 2;
        let params = (first..r.end).all(|at| {
            let param = r.ty.param(at - first, r.count as usize);
            param.is_none_or(|p| ways.param(at, r.ty, p, piece.start) < REFERS_TO_NOTHING)
        });
        let sound = params && ways.id(id, Some(r.ty), piece.start) < REFERS_TO_NOTHING;
        ways.arrive((piece.start, piece.end), Id::Is(id), Some(r.ty));
        sound
    })
}
