//! What a first reading of a free-form stretch says that is far from its faults. Nothing in the layout says there
//! where a record begins, but IDs do: what is defined once is not defined again, and what is changed or referred to
//! is defined somewhere. With that the stretch is read once more.

use rustc_hash::{FxHashMap, FxHashSet};

use super::super::table::Effect;
use super::damage;
use super::stretch::Stretch;
use super::surroundings::Surroundings;
use super::verdict::{Piece, Verdict};

/// So many pieces before and behind a fault are not trusted.
const NEAR: usize = 3;

pub struct Trusted<'a> {
    around: &'a Surroundings,
    /// Where each ID is defined.
    defined: FxHashMap<i32, usize>,
    /// The IDs that pieces near a fault begin with.
    perhaps: FxHashSet<i32>,
    /// The IDs that are used and defined by nothing that is trusted.
    missing: FxHashSet<i32>,
}

/// The prices of what does not agree with the rest.
const DEFINED_TWICE: u32 = 700;
const CHANGES_NOTHING: u32 = 500;
const REFERS_TO_NOTHING: u32 = 250;
/// A fault is cheaper by this if it has an ID that something else needs, and dearer if it has one that is taken.
const NEEDED: u32 = 150;

impl<'a> Trusted<'a> {
    pub fn new(stretch: &Stretch, around: &'a Surroundings, pieces: &[Piece]) -> Trusted<'a> {
        let is_fault = |p: &Piece| !matches!(p.verdict, Verdict::Whole(_) | Verdict::Void);
        let faults: Vec<usize> = (0..pieces.len())
            .filter(|&i| is_fault(&pieces[i]))
            .collect();
        let mut trusted = Trusted {
            around,
            defined: FxHashMap::default(),
            perhaps: FxHashSet::default(),
            missing: FxHashSet::default(),
        };
        let mut next = 0;
        for (i, p) in pieces.iter().enumerate() {
            while faults.get(next).is_some_and(|&f| f + NEAR < i) {
                next += 1;
            }
            let id = stretch.sigs[p.start].int.unwrap_or(0);
            match p.verdict {
                Verdict::Whole(r) if faults.get(next).is_none_or(|&f| f > i + NEAR) => {
                    match r.ty.effect {
                        Effect::Changes(_) => drop(trusted.missing.insert(id)),
                        _ => drop(trusted.defined.entry(id).or_insert(p.start)),
                    }
                    let used = damage::of_record(stretch, p.start, r.end);
                    trusted.missing.extend(used);
                }
                _ => drop(trusted.perhaps.insert(id)),
            }
        }
        trusted
            .missing
            .extend(around.dangling.iter().map(|&id| id as i32));
        let Trusted {
            missing, defined, ..
        } = &mut trusted;
        missing.retain(|&id| !defined.contains_key(&id) && !around.is_defined(id as u32));
        trusted
    }

    fn is_defined(&self, id: i32) -> bool {
        self.defined.contains_key(&id) || self.around.is_defined(id as u32)
    }

    /// The price of a record that is right in form.
    pub fn record(&self, stretch: &Stretch, start: usize, end: usize) -> u32 {
        let id = stretch.sigs[start].int.unwrap_or(0);
        let Some(ty) = stretch.record_type(start + 1) else {
            return 0;
        };
        let elsewhere = self.defined.get(&id).is_some_and(|&at| at != start)
            || self.around.is_defined(id as u32);
        let known = |id: i32| self.is_defined(id) || self.perhaps.contains(&id);
        let own = match ty.effect {
            Effect::Defines(_) if elsewhere => DEFINED_TWICE,
            Effect::Changes(_) if !known(id) => CHANGES_NOTHING,
            _ => 0,
        };
        let lost = damage::of_record(stretch, start, end)
            .filter(|&id| !known(id))
            .count();
        own + REFERS_TO_NOTHING * lost.min(2) as u32
    }

    /// What a fault that begins with a token costs more, and less.
    pub fn fault(&self, stretch: &Stretch, start: usize) -> (u32, u32) {
        // A record without its ID behind a number that could be that: the record before has lost a number.
        let code = stretch.record_type(start).filter(|t| t.code < 0);
        let before = start
            .checked_sub(1)
            .and_then(|i| stretch.sigs[i].int)
            .filter(|&id| id > 1);
        if let (Some(ty), Some(id)) = (code, before) {
            let plausible = match ty.effect {
                Effect::Defines(_) => !self.is_defined(id),
                Effect::Changes(_) => self.is_defined(id),
                Effect::DefinesOrChanges(..) => true,
            };
            return (if plausible { NEEDED } else { 0 }, 0);
        }
        let Some(id) = stretch.sigs[start].int.filter(|&id| id > 0) else {
            return (0, 0);
        };
        match stretch.record_type(start + 1).map(|t| t.effect) {
            Some(Effect::Defines(_)) if self.missing.contains(&id) => (0, NEEDED),
            Some(Effect::Defines(_)) if self.is_defined(id) => (NEEDED, 0),
            Some(Effect::Changes(_)) if self.is_defined(id) => (0, NEEDED),
            Some(Effect::Changes(_)) => (NEEDED, 0),
            _ => (0, 0),
        }
    }
}
