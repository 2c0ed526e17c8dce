//! Follows references from record to record, and reports those that lead nowhere.

use std::collections::VecDeque;

use rustc_hash::FxHashMap;

use super::entity::State;
use super::model::{Entity, NodeId, Rgb};
use super::record::Params;
use super::resolve::Resolver;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Label, Span, Value};
use crate::syntax::table::{Effect, Family, Kind, ParamKind, RecordType};
use crate::syntax::{self, Document, Item};

/// The number of defined IDs that are compared with undefined ones, in all, to propose an ID. In a large file only the
/// first errors get a proposal.
const COMPARISONS_MAX: usize = 2_000_000;

/// A record that lost its ID.
pub(super) struct Lost {
    pub ty: Option<&'static RecordType>,
    /// The record's first token, where the parser's finding points.
    pub span: Span,
    /// The IDs to which the record may refer. The lost ID is none of them.
    pub names: Vec<u32>,
}

/// An ID that is used but that no readable record defines. A record that lost its ID may define it.
struct Dangling {
    id: u32,
    kinds: &'static [Kind],
    finding: Diagnostic,
}

#[derive(Default)]
pub(super) struct References {
    /// The number of IDs, from number 0 on, that define the entity whose index is their own number. They need no table.
    numbered: usize,
    /// The index of the entity that each ID defines, by the number of the ID; `u32::MAX` for none. The table is empty
    /// as long as all indices equal the numbers.
    entity: Vec<u32>,
    /// The first definition of each ID, to tell "later" from "nowhere". It is computed when it is first needed, which
    /// is in few scenes.
    definition: Option<FxHashMap<u32, (Span, Option<Kind>)>>,
    pub lost: Vec<Lost>,
    dangling: Vec<Dangling>,
    /// The number of comparisons with defined IDs that are left.
    comparisons: usize,
}

/// The place of the first definition of each ID, which may be a broken record, and its kind if that is known.
fn definitions(document: &Document) -> FxHashMap<u32, (Span, Option<Kind>)> {
    let mut definition = FxHashMap::default();
    for item in &document.items {
        let (id, first, kind) = match item {
            Item::Record(r) => match r.ty().effect {
                Effect::Changes(_) => continue,
                Effect::Defines(kind) | Effect::DefinesOrChanges(kind, _) => {
                    (Some(r.id), r.first, Some(kind))
                }
            },
            Item::Broken(b) => (b.id, b.first, None),
            _ => continue,
        };
        if let Some(id) = id {
            let span = document.tokens[first as usize].span();
            definition.entry(id).or_insert((span, kind));
        }
    }
    definition
}

impl References {
    /// `compares`: whether undefined IDs are compared with defined ones to propose those that were meant.
    pub(super) fn new(compares: bool) -> References {
        References {
            comparisons: if compares { COMPARISONS_MAX } else { 0 },
            ..References::default()
        }
    }

    pub(super) fn defined(&mut self, number: Option<u32>, entity: usize) {
        let Some(number) = number.map(|n| n as usize) else {
            return;
        };
        if self.entity.is_empty() && number == entity && number == self.numbered {
            self.numbered += 1;
            return;
        }
        if self.entity.is_empty() {
            self.entity.extend(0..self.numbered as u32);
        }
        if self.entity.len() <= number {
            self.entity.resize(number + 1, u32::MAX);
        }
        self.entity[number] = entity as u32;
    }

    pub(super) fn entity(&self, number: u32) -> Option<usize> {
        if self.entity.is_empty() {
            return ((number as usize) < self.numbered).then_some(number as usize);
        }
        let index = *self.entity.get(number as usize)?;
        (index != u32::MAX).then_some(index as usize)
    }

    /// Matches undefined IDs with records that lost their ID, at the end of the file. Each such record explains one
    /// undefined ID, which is added to the record's finding. The findings about all other undefined IDs are reported.
    pub(super) fn settle(resolver: &mut Resolver, diagnostics: &mut [Diagnostic]) {
        // The records that lost their ID, by the kind that they define (`None` if it is unknown), in file order.
        let mut lost: Vec<(Option<Kind>, VecDeque<Lost>)> = Vec::new();
        for l in std::mem::take(&mut resolver.references.lost) {
            let kind = match l.ty.map(|t| t.effect) {
                Some(Effect::Defines(k) | Effect::DefinesOrChanges(k, _)) => Some(k),
                Some(Effect::Changes(_)) => continue,
                None => None,
            };
            match lost.iter_mut().find(|q| q.0 == kind) {
                Some(q) => q.1.push_back(l),
                None => lost.push((kind, VecDeque::from([l]))),
            }
        }
        let mut found: FxHashMap<u32, bool> = FxHashMap::default();
        // An ID that may be of fewer kinds has fewer records to choose from, so it chooses earlier.
        let mut dangling = std::mem::take(&mut resolver.references.dangling);
        dangling.sort_by_key(|d| d.kinds.len());
        for d in dangling {
            let is_found = *found.entry(d.id).or_insert_with(|| {
                let may_be = |l: &Lost| !l.names.contains(&d.id);
                let first = lost
                    .iter_mut()
                    .filter(|(kind, _)| kind.is_none_or(|k| d.kinds.contains(&k)))
                    .filter_map(|(_, queue)| Some((queue.iter().position(may_be)?, queue)))
                    .min_by_key(|(at, queue)| queue[*at].span.start);
                let Some(record) = first.and_then(|(at, queue)| queue.remove(at)) else {
                    return false;
                };
                if let Some(f) = finding_at(diagnostics, record.span) {
                    f.labels.push(Label {
                        span: d.finding.span,
                        phrase: "lost-id-used-here",
                    });
                    f.notes.push("lost-id-may-be-this");
                    f.values.push(("lost", d.id.to_string().into()));
                    if f.code == Code::E005 && f.fixes.is_empty() {
                        let start = record.span.start;
                        // The ID may be missing, or another token may stand in its place.
                        let (title, span, text) = match f.case {
                            "lost" => ("put-lost-id-in-front", Span::new(start, start), " "),
                            _ => ("write-lost-id", record.span, ""),
                        };
                        f.fixes.push(Fix::replace(
                            title,
                            Applicability::Unsafe,
                            span,
                            format!("{}{text}", d.id),
                        ));
                    }
                }
                true
            });
            if !is_found {
                resolver.out.push(d.finding);
            }
        }
    }
}

impl Resolver<'_> {
    /// Follows the reference at parameter `i` and returns its ID. `None`: the reference leads nowhere, which was
    /// reported if necessary. `Some(None)`: the reference is 0, "none". With `late`, IDs have their values at the end
    /// of the file.
    pub(super) fn reference(&mut self, p: &Params, i: usize, late: bool) -> Option<Option<u32>> {
        let ParamKind::Reference { kinds, or_none } = p.param(i)?.kind else {
            return None;
        };
        let value = p.integer(i);
        if value == 0 && or_none {
            return Some(None);
        }
        let span = p.span_of(i, 1);
        let what = p.param(i)?.doc;
        let Ok(id) = u32::try_from(value) else {
            self.out.push(no_id(span, value));
            return None;
        };
        if id == 0 {
            self.out.push(no_id(span, value));
            return None;
        }
        let finding = match self.state(id) {
            Some(state) => match state.kind() {
                None => return None,
                Some(kind) if kinds.contains(&kind) => {
                    return (!matches!(state, State::Broken(_))).then_some(Some(id));
                }
                Some(Kind::Undefined) => {
                    Diagnostic::new(Code::E108, span).with("parameter", Value::Term(what))
                }
                Some(kind) => wrong_kind(span, kind, what, kinds),
            },
            None if id == p.id => {
                Diagnostic::new(Code::E104, span).with("parameter", Value::Term(what))
            }
            None if id == 1 => wrong_kind(span, Kind::Render, what, kinds),
            None => match self.later(id).filter(|_| !late) {
                // Moving the definition up would not help: its kind is wrong.
                Some((at, Some(kind))) if kind != Kind::Undefined && !kinds.contains(&kind) => {
                    wrong_kind(span, kind, what, kinds).label(at, "defined-here")
                }
                _ => {
                    self.undefined(id, span, kinds, late, &used(p));
                    return None;
                }
            },
        };
        let finding = self.showing(finding.with("id", id.to_string()), id);
        let kind = match self.state(id) {
            None if finding.code == Code::E103 => self.later(id).and_then(|(_, kind)| kind),
            state => state.and_then(State::kind),
        };
        let is_lamp = matches!(kind, Some(Kind::PointLight | Kind::AmbientLight));
        let finding = match is_lamp && p.ty.family == Family::Operation {
            // A lamp shines without any operation, so no other ID is proposed.
            true => finding.note("no-part"),
            false => self.with_proposal(finding, id, span, kinds, &used(p)),
        };
        match self.state(id) {
            Some(state) => self.say_unless_lost(state, finding, id, kinds),
            None => self.say_unless_any_lost(finding, id, kinds),
        }
        None
    }

    /// Reports a value of the wrong kind. A property may stand there only because the record of the object lost its ID;
    /// so if a record has lost its ID, the finding waits for the end of the file.
    fn say_unless_lost(
        &mut self,
        state: State,
        finding: Diagnostic,
        id: u32,
        kinds: &'static [Kind],
    ) {
        let property = matches!(
            state,
            State::Optics(_) | State::Texture(_) | State::Colour(_)
        );
        if property && !self.references.lost.is_empty() {
            self.references
                .dangling
                .push(Dangling { id, kinds, finding });
        } else {
            self.out.push(finding);
        }
    }

    /// Adds a label to the finding: the place where the ID is defined or declared.
    fn showing(&self, finding: Diagnostic, id: u32) -> Diagnostic {
        let phrase = match finding.code {
            Code::E108 => "declared-here",
            _ => "defined-here",
        };
        match self.entity(id) {
            Some(e) => finding.label(e.span, phrase),
            None => finding,
        }
    }

    /// Reports an ID that is defined only later (E107) or nowhere (E101). `used` are the IDs in the record; it is empty
    /// if the record changes `id`.
    fn undefined(&mut self, id: u32, span: Span, kinds: &'static [Kind], late: bool, used: &[u32]) {
        let changes = used.is_empty();
        if let (false, Some((at, _))) = (late, self.later(id)) {
            let finding = Diagnostic::new(Code::E107, span)
                .case(if changes { "changed" } else { "" })
                .with("id", id.to_string())
                .label(at, "later");
            self.say_unless_any_lost(finding, id, kinds);
            return;
        }
        let finding = Diagnostic::new(Code::E101, span).with("id", id.to_string());
        let finding = self.with_proposal(finding, id, span, kinds, used);
        self.references
            .dangling
            .push(Dangling { id, kinds, finding });
    }

    /// The place of the first definition of an ID in the whole file, and its kind if that is known.
    fn later(&mut self, id: u32) -> Option<(Span, Option<Kind>)> {
        let document = self.document;
        let all = self
            .references
            .definition
            .get_or_insert_with(|| definitions(document));
        all.get(&id).copied()
    }

    /// Reports a finding about an ID. If a record has lost its ID, that record may define this ID, so the finding waits
    /// for the end of the file.
    fn say_unless_any_lost(&mut self, finding: Diagnostic, id: u32, kinds: &'static [Kind]) {
        match self.references.lost.is_empty() {
            true => self.out.push(finding),
            false => self
                .references
                .dangling
                .push(Dangling { id, kinds, finding }),
        }
    }

    /// Reports a record that changes an ID above its definition, if records of this type cannot change that kind of
    /// value at all. Returns whether that is so.
    fn changes_another_kind(&mut self, p: &Params, kinds: &'static [Kind]) -> bool {
        let Some((at, Some(kind))) = self.later(p.id) else {
            return false;
        };
        if kinds.contains(&kind) || kind == Kind::Undefined {
            return false;
        }
        let finding = Diagnostic::new(Code::E103, p.id_span())
            .case("changed")
            .with("kind", Value::Term(kind.name()))
            .with("kinds", one_of(kinds))
            .with("id", p.id.to_string())
            .with("type", Value::Term(p.ty.title))
            .label(at, "defined-here");
        let finding = self.with_proposal(finding, p.id, p.id_span(), kinds, &[]);
        self.say_unless_any_lost(finding, p.id, kinds);
        true
    }

    /// The state of the entity that a record changes. `None` if the record cannot change the entity, which is reported.
    pub(super) fn changed(&mut self, p: &Params, kinds: &'static [Kind]) -> Option<State> {
        let Some(state) = self.state(p.id) else {
            if !self.changes_another_kind(p, kinds) {
                self.undefined(p.id, p.id_span(), kinds, false, &[]);
            }
            return None;
        };
        let finding = match state.kind() {
            None => return Some(State::Broken(None)),
            Some(kind) if kinds.contains(&kind) => return Some(state),
            Some(Kind::Undefined) => Diagnostic::new(Code::E108, p.id_span()).case("changed"),
            Some(kind) => Diagnostic::new(Code::E103, p.id_span())
                .case("changed")
                .with("kind", Value::Term(kind.name()))
                .with("kinds", one_of(kinds)),
        };
        let finding = (finding.with("id", p.id.to_string())).with("type", Value::Term(p.ty.title));
        let finding = self.showing(finding, p.id);
        self.say_unless_lost(state, finding, p.id, kinds);
        None
    }

    pub(super) fn object(&mut self, p: &Params, i: usize) -> Option<NodeId> {
        let id = self.reference(p, i, false)??;
        match self.state(id)? {
            State::Object(node) => Some(node),
            _ => None,
        }
    }

    pub(super) fn colour(&mut self, p: &Params, i: usize) -> Option<Rgb> {
        let id = self.reference(p, i, false)??;
        match self.state(id)? {
            State::Colour(at) => Some(self.values.colours[at as usize]),
            _ => None,
        }
    }

    /// Adds a fix that writes the defined ID of the right kind whose spelling is nearest, if it is near enough. The IDs
    /// in `used`, which the record already has, are not proposed.
    fn with_proposal(
        &mut self,
        finding: Diagnostic,
        id: u32,
        span: Span,
        kinds: &[Kind],
        used: &[u32],
    ) -> Diagnostic {
        let written = id.to_string();
        let most = 1 + written.len() / 4;
        let fits = |e: &&Entity| {
            let is_kind = e.kind.is_some_and(|kind| kinds.contains(&kind));
            is_kind && e.id != id && !used.contains(&e.id)
        };
        // IDs of one digit are all equally near in spelling, so the nearest number is taken. The IDs one edit away are
        // looked up, which takes less time than a comparison with all IDs.
        let one_edit = one_edit_away(&written).filter_map(|near| self.entity(near));
        let one_edit = one_edit.filter(fits);
        let nearest = match one_edit.map(|e| (1, e.id.abs_diff(id), e.id)).min() {
            None if most > 1 => {
                let entities = &self.scene.entities;
                let all = entities.iter().take(self.references.comparisons);
                let all = all.filter(fits);
                // Each edit changes the number of digits by one at most.
                let as_long = |e: &&Entity| {
                    let length = e.id.checked_ilog10().map_or(1, |n| n as usize + 1);
                    length.abs_diff(written.len()) <= most
                };
                let nearest = all.filter(as_long).map(|e| {
                    let distance = strsim::osa_distance(&written, &e.id.to_string());
                    (distance, e.id.abs_diff(id), e.id)
                });
                let nearest = nearest.min();
                let left = self.references.comparisons;
                self.references.comparisons = left.saturating_sub(entities.len());
                nearest
            }
            nearest => nearest,
        };
        match nearest {
            Some((distance, _, near)) if distance <= most => {
                let near = near.to_string();
                finding
                    .with("number", syntax::quote(&near))
                    .fix(Fix::replace("fix-write", Applicability::Unsafe, span, near))
            }
            _ => finding,
        }
    }
}

/// The numbers that are one edit away from a written number: a digit inserted, removed or replaced, or two neighbours
/// swapped. Some occur twice.
fn one_edit_away(written: &str) -> impl Iterator<Item = u32> {
    let text = written.as_bytes();
    let replaced = move |range: std::ops::Range<usize>, new: &[u8]| {
        [&text[..range.start], new, &text[range.end..]].concat()
    };
    let put_in = (0..=text.len()).flat_map(move |at| (b'0'..=b'9').map(move |d| (at..at, d)));
    let other = (0..text.len()).flat_map(move |at| (b'0'..=b'9').map(move |d| (at..at + 1, d)));
    let changed = put_in.chain(other).map(move |(at, d)| replaced(at, &[d]));
    let taken_out = (0..text.len()).map(move |at| replaced(at..at + 1, &[]));
    let swapped = text.windows(2).enumerate();
    let swapped = swapped.map(move |(at, pair)| replaced(at..at + 2, &[pair[1], pair[0]]));
    let numbers = changed.chain(taken_out).chain(swapped);
    // A number is not written with a zero in front.
    let numbers = numbers.filter(|n| n.len() == 1 || n.first() != Some(&b'0'));
    numbers.filter_map(|n| std::str::from_utf8(&n).ok()?.parse().ok())
}

/// The finding with exactly this span; `diagnostics` are sorted by place.
pub(super) fn finding_at(diagnostics: &mut [Diagnostic], span: Span) -> Option<&mut Diagnostic> {
    let at = diagnostics.partition_point(|d| d.span.start < span.start);
    diagnostics[at..]
        .iter_mut()
        .take_while(|d| d.span.start == span.start)
        .find(|d| d.span == span)
}

/// The IDs that a record has: its own and those that it refers to.
fn used(p: &Params) -> Vec<u32> {
    let refers = |i: &usize| {
        p.param(*i)
            .is_some_and(|q| matches!(q.kind, ParamKind::Reference { .. }))
    };
    let others = (0..p.len()).filter(refers).map(|i| p.integer(i));
    let others = others.filter_map(|id| u32::try_from(id).ok());
    std::iter::once(p.id).chain(others).collect()
}

fn no_id(span: Span, value: i64) -> Diagnostic {
    Diagnostic::new(Code::E101, span)
        .case("no-id")
        .with("number", value.to_string())
}

fn wrong_kind(span: Span, kind: Kind, what: &'static str, kinds: &[Kind]) -> Diagnostic {
    Diagnostic::new(Code::E103, span)
        .with("kind", Value::Term(kind.name()))
        .with("parameter", Value::Term(what))
        .with("kinds", one_of(kinds))
}

/// The kinds as a message lists them: "an object, a point light or a camera".
fn one_of(kinds: &[Kind]) -> Value {
    Value::OneOf(kinds.iter().map(|k| k.name()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn numbers_one_edit_away_are_all_that_are() {
        for id in [0, 7, 10, 99, 100, 120, 2011] {
            let written = id.to_string();
            let found: BTreeSet<u32> = one_edit_away(&written).filter(|&n| n != id).collect();
            let is_near = |n: &u32| strsim::osa_distance(&written, &n.to_string()) == 1;
            assert!(found.into_iter().eq((0..100_000).filter(is_near)), "{id}");
        }
    }
}
