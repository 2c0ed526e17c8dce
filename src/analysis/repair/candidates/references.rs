//! Guesses at other IDs: for the references of a record, and for its own ID.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{Candidate, Habit, LineContext, MAX_CANDIDATES};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::{Entity, names};
use crate::syntax::lexer::Token;
use crate::syntax::table::{Effect, Family, Kind, Param, ParamKind, RecordKind, RecordType};
use crate::syntax::{Item, Record, quote};

/// The title of the fix that deletes a record that is written twice.
pub(super) const AGAIN_TITLE: &str = "fix-again";

impl LineContext<'_> {
    /// The parameters that are references, each with the kinds that it may refer to.
    fn referring(&self) -> Vec<(Token, &'static [Kind])> {
        let Some(ty) = self.ty().filter(|ty| self.fits(ty)) else {
            return Vec::new();
        };
        let kinds = |p: &'static Param| match p.kind {
            ParamKind::Reference { kinds, .. } => Some(kinds),
            _ => None,
        };
        (self.params().iter().enumerate())
            .filter_map(|(i, &t)| Some((t, kinds(ty.param(i, 0)?)?)))
            .filter(|(t, _)| t.integer(self.text).is_some())
            .collect()
    }

    /// The entities of some kinds that the record may refer to: those above it, or all for a render record or a choice
    /// of cameras.
    pub(super) fn entities(&self, kinds: &'static [Kind]) -> impl Iterator<Item = &Entity> {
        let late = self.ty().is_some_and(|ty| {
            matches!(
                ty.kind,
                RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
            )
        });
        let before = self.line.start;
        (self.analysis.scene.entities.iter())
            .filter(move |e| late || e.span.start < before)
            .filter(|e| e.kind.is_none_or(|k| kinds.contains(&k)))
    }

    /// Guesses at other references: two are swapped, all are off by one or two, or one names the wrong ID.
    pub(super) fn references(&self, finding: &Diagnostic, out: &mut Vec<Candidate>) {
        let all = self.referring();
        if !all.iter().any(|(t, _)| finding.span == t.span()) {
            return;
        }
        // A definition below has its own proposal: to be moved up.
        if finding.code == Code::E107 && finding.case != "cycle" {
            return;
        }
        // A lamp among the operands: no other object is meant.
        if finding.notes.contains(&"no-part") {
            return;
        }
        if self.has_complement(finding) {
            out.extend(self.as_difference());
            return;
        }
        // A render record need not name a camera: cameras are found by themselves.
        let is_camera =
            |t: &Token| t.integer(self.text).and_then(|id| self.kind_of(id)) == Some(Kind::Camera);
        let named = all.iter().find(|(t, _)| finding.span == t.span());
        if let (Some((t, _)), Some(RecordKind::Render)) = (named, self.ty().map(|ty| ty.kind))
            && is_camera(t)
        {
            out.extend(self.write(Habit::Reference, &[(*t, String::from("0"))]));
        }
        // An assignment of an object to itself may leave that property as it is, which 0 says.
        if let Some((t, _)) = named
            && self.is_of_itself(t)
        {
            out.extend(self.write(Habit::Reference, &[(*t, String::from("0"))]));
        }
        self.swapped(out);
        self.colours_first(out);
        self.other_place(finding, &all, out);
        out.extend(
            all.iter()
                .filter(|(t, _)| finding.span == t.span())
                .find_map(|(t, kinds)| self.renamed(t, kinds)),
        );
        let id = |t: &Token| t.integer(self.text).unwrap_or(0);
        // A single reference is off by one at most, and 0 is no reference.
        let several = all.iter().filter(|(t, _)| id(t) != 0).count() > 1;
        // References to other kinds that are right stay as they are.
        let own_kinds = named.map(|n| n.1);
        let is_right = |(t, kinds): &(Token, &'static [Kind])| {
            let is_defined = || self.entities(kinds).any(|e| i64::from(e.id) == id(t));
            id(t) == 0 || Some(*kinds) != own_kinds && is_defined()
        };
        let mut others = all.iter().filter(|(t, _)| finding.span != t.span());
        let stay = several && finding.code == Code::E101 && others.all(is_right);
        let most = match (stay, several) {
            (true, _) => 0,
            (false, true) => 4,
            (false, false) => 2,
        };
        let held = self.held(finding, &all);
        for by in &[1, -1, 2, -2][..most] {
            let shifted: Option<Vec<(Token, String)>> = (all.iter())
                .filter(|(t, _)| id(t) != 0)
                .map(|(t, _)| {
                    let new = id(t).checked_add(*by).filter(|&id| id > 0)?;
                    // All may be off by one. Off by two, none may become a part of another operand.
                    let is_held = held.iter().any(|&id| i64::from(id) == new);
                    (by.abs() == 1 || !is_held).then(|| (*t, new.to_string()))
                })
                .collect();
            out.extend(shifted.and_then(|new| self.write(Habit::Shifted, &new)));
        }
        let is_render = self.ty().is_some_and(|ty| ty.kind == RecordKind::Render);
        let parts = match is_render {
            true => self.named_ids(),
            false => FxHashSet::default(),
        };
        // Where nothing may stand, a property that another record names is not meant instead of a wrong kind.
        let of_others = self.of_others(finding);
        for (t, kinds) in all.iter().filter(|(t, _)| finding.span == t.span()) {
            let written = id(t);
            let text = written.to_string();
            let used: Vec<i64> = all.iter().map(|(t, _)| id(t)).collect();
            // An operation needs two operands that differ, a checkerboard two colours, and a pair of eyes two cameras.
            let is_of_two = (self.ty()).is_some_and(|ty| {
                let is_pair =
                    [RecordKind::Checkerboard, RecordKind::StereoCamera].contains(&ty.kind);
                ty.family == Family::Operation || is_pair
            });
            let mut others: Vec<(bool, bool, usize, u64, u32)> = (self.entities(kinds))
                .filter(|e| i64::from(e.id) != written && Some(e.id) != self.id())
                .filter(|e| !is_of_two || !used.contains(&i64::from(e.id)))
                .filter(|e| !held.contains(&e.id) && !of_others.contains(&e.id))
                .map(|e| {
                    let new = e.id.to_string();
                    (
                        // The drawn object is hardly a part of another object.
                        parts.contains(&e.id),
                        used.contains(&i64::from(e.id)),
                        strsim::osa_distance(&text, &new),
                        i64::from(e.id).abs_diff(written),
                        e.id,
                    )
                })
                .collect();
            others.sort_unstable();
            if others.is_empty() && several && !of_others.is_empty() {
                out.extend(self.write(Habit::Reference, &[(*t, String::from("0"))]));
            }
            out.extend(
                (others.iter().take(MAX_CANDIDATES))
                    .filter_map(|o| self.write(Habit::Reference, &[(*t, o.4.to_string())])),
            );
        }
    }

    /// Whether a fix writes an operand that another operand of the operation already has as a part, or, in an
    /// assignment, an ID that another record names.
    pub(in crate::analysis::repair) fn is_held(&self, finding: &Diagnostic, fix: &Fix) -> bool {
        let [edit] = fix.edits.as_slice() else {
            return false;
        };
        let new = edit.text.parse();
        edit.span == finding.span
            && new.is_ok_and(|id| {
                self.held(finding, &self.referring()).contains(&id)
                    || self.of_others(finding).contains(&id)
            })
    }

    /// The IDs of all parts that the other operands of an operation are made of. None of them is meant as an operand.
    fn held(&self, finding: &Diagnostic, all: &[(Token, &'static [Kind])]) -> FxHashSet<u32> {
        let mut held = FxHashSet::default();
        if !self.is_operation() {
            return held;
        }
        let others = all.iter().filter(|(t, _)| finding.span != t.span());
        let mut todo: Vec<u32> = others
            .filter_map(|(t, _)| u32::try_from(t.integer(self.text)?).ok())
            .collect();
        let document = &self.analysis.document;
        let mut parts: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
        for record in document.items.iter().filter_map(Item::record) {
            let is_made = record.ty().family == Family::Operation;
            if is_made && document.id_token(record).start < self.line.start {
                let references = names::references(document, record);
                parts.entry(record.id).or_default().extend(references);
            }
        }
        while let Some(id) = todo.pop() {
            let new = parts.get(&id).into_iter().flatten();
            todo.extend(new.filter(|&&part| held.insert(part)));
        }
        held
    }

    /// Whether a guess only leads to a colour, texture or optics that other references name already, by one changed
    /// digit or by IDs that are all off by the same number. Then the definition of the written ID is rather missing.
    pub(in crate::analysis::repair) fn is_of_others(
        &self,
        finding: &Diagnostic,
        guess: &Candidate,
    ) -> bool {
        let is_property = |kind: &Kind| *kind != Kind::Object;
        let referring = self.referring();
        let is_one = referring
            .iter()
            .any(|(t, kinds)| t.span() == finding.span && kinds.iter().all(is_property));
        let is_shift = guess.habit == Habit::Shifted;
        if !is_one || !is_shift && guess.habit != Habit::Reference {
            return false;
        }
        let digits = |text: &str| {
            let mut digits = text.as_bytes().to_vec();
            digits.sort_unstable();
            digits
        };
        let is_other_digit = |edit: &Edit| {
            let written = &self.text[edit.span.range()];
            written.len() == edit.text.len() && digits(written) != digits(&edit.text)
        };
        let own: Vec<i64> = (referring.iter())
            .filter_map(|(t, _)| t.integer(self.text))
            .collect();
        let named = self.named_ids();
        let is_of_others = |edit: &Edit| {
            let new: Option<u32> = edit.text.parse().ok();
            new.is_some_and(|id| own.contains(&i64::from(id)) || named.contains(&id))
        };
        let edits = &guess.fix.edits;
        edits
            .iter()
            .all(|edit| (is_shift || is_other_digit(edit)) && is_of_others(edit))
    }

    /// Whether a reference of an assignment is the ID of the object to which the assignment assigns.
    fn is_of_itself(&self, reference: &Token) -> bool {
        let is_assignment = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Assignment);
        is_assignment && self.id().map(i64::from) == reference.integer(self.text)
    }

    /// Whether a finding is about a reference by which an object is assigned to itself.
    pub(crate) fn assigns_itself(&self, finding: &Diagnostic) -> bool {
        let named = self.params().iter().find(|t| t.span() == finding.span);
        named.is_some_and(|t| self.is_of_itself(t))
    }

    /// The kind of the entity that has an ID.
    pub(super) fn kind_of(&self, id: i64) -> Option<Kind> {
        let mut entities = self.analysis.scene.entities.iter();
        entities.find(|e| i64::from(e.id) == id)?.kind
    }

    /// The IDs that records refer to.
    pub(super) fn named_ids(&self) -> FxHashSet<u32> {
        let document = &self.analysis.document;
        let records = document.items.iter().filter_map(Item::record);
        records
            .flat_map(|r| names::references(document, r))
            .collect()
    }

    /// Whether a fix makes the record change an object that an operation above already uses: such a change has no
    /// effect.
    pub(in crate::analysis::repair) fn is_behind_use(&self, fix: &Fix) -> bool {
        let [edit] = fix.edits.as_slice() else {
            return false;
        };
        let changes = self
            .ty()
            .is_some_and(|ty| !matches!(ty.effect, Effect::Defines(_)));
        let new = edit.text.parse();
        changes
            && edit.span == self.tokens[0].span()
            && new.is_ok_and(|id| self.used_above().contains(&id))
    }

    /// The IDs that operations above refer to.
    fn used_above(&self) -> FxHashSet<u32> {
        let document = &self.analysis.document;
        let records = document.items.iter().filter_map(Item::record);
        let above = records.take_while(|r| document.id_token(r).start < self.line.start);
        let operations = above.filter(|r| r.ty().family == Family::Operation);
        operations
            .flat_map(|r| names::references(document, r))
            .collect()
    }

    /// Guesses that a reference for which there is no entity of the right kind was meant for another parameter, which
    /// is 0. That parameter gets the only unused entity of its kind.
    fn other_place(
        &self,
        finding: &Diagnostic,
        all: &[(Token, &'static [Kind])],
        out: &mut Vec<Candidate>,
    ) {
        let own = all.iter().find(|(t, _)| finding.span == t.span());
        let Some((own, _)) = own.filter(|(_, kinds)| self.entities(kinds).next().is_none()) else {
            return;
        };
        let named = self.named_ids();
        for (place, kinds) in all.iter().filter(|(t, _)| t.integer(self.text) == Some(0)) {
            let mut unused = self.entities(kinds).filter(|e| !named.contains(&e.id));
            if let (Some(one), None) = (unused.next(), unused.next()) {
                let new = [(*own, "0".to_owned()), (*place, one.id.to_string())];
                out.extend(self.write(Habit::Reference, &new));
            }
        }
    }

    /// Guesses that the colours of a checkerboard stand before the numbers of its fields.
    fn colours_first(&self, out: &mut Vec<Candidate>) {
        let is_one = (self.ty()).is_some_and(|ty| ty.kind == RecordKind::Checkerboard);
        if let ([a, b, c, d], true) = (self.params(), is_one) {
            let new = [(a, c), (b, d), (c, a), (d, b)];
            let new = new.map(|(t, new)| (*t, new.text(self.text).to_owned()));
            out.extend(self.write(Habit::Swapped, &new));
        }
    }

    /// Guesses that the only unused entity of the right kind should have the ID that is named here. All records of the
    /// entity get that ID.
    fn renamed(&self, named: &Token, kinds: &'static [Kind]) -> Option<Candidate> {
        let document = &self.analysis.document;
        let all_named = self.named_ids();
        let mut unused = (self.entities(kinds))
            .filter(|e| Some(e.id) != self.id() && !all_named.contains(&e.id));
        let (Some(one), None) = (unused.next(), unused.next()) else {
            return None;
        };
        let id = named.text(self.text).to_owned();
        let head = Token::new(named.kind(), one.span.start as usize, one.span.end as usize);
        let mut candidate = self.write(Habit::Id, &[(head, id.clone())])?;
        let records = document.items.iter().filter_map(Item::record);
        let own = records
            .filter(|r| r.id == one.id)
            .map(|r| document.id_token(r).span());
        let changes = own.filter(|span| *span != one.span);
        let changes = changes.map(|span| Edit {
            span,
            text: id.clone(),
        });
        candidate.fix.edits.extend(changes);
        candidate.fix.edits.sort_by_key(|e| e.span.start);
        Some(candidate)
    }

    /// Guesses that the ID of a record and its references are in each other's places, if just one other order has each
    /// of the right kind.
    pub(super) fn arranged(&self, out: &mut Vec<Candidate>) {
        let changed = self.ty().map(|ty| ty.effect);
        let Some(Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = changed else {
            return;
        };
        let referring = self.referring();
        if !(1..=2).contains(&referring.len()) {
            return;
        }
        let slots: Vec<(Token, &'static [Kind], bool)> =
            std::iter::once((self.tokens[0], kinds, false))
                .chain(referring.into_iter().map(|(t, kinds)| (t, kinds, true)))
                .collect();
        let fits = |t: &Token, &(_, kinds, or_none): &(Token, &'static [Kind], bool)| {
            let id = t.integer(self.text);
            id == Some(0) && or_none || self.entities(kinds).any(|e| id == Some(i64::from(e.id)))
        };
        const ORDERS: [[usize; 3]; 5] = [[1, 0, 2], [2, 1, 0], [0, 2, 1], [1, 2, 0], [2, 0, 1]];
        let mut right = ORDERS
            .iter()
            .map(|order| &order[..slots.len()])
            .filter(|order| order.iter().all(|&i| i < slots.len()))
            .filter(|order| {
                order
                    .iter()
                    .zip(&slots)
                    .all(|(&i, slot)| fits(&slots[i].0, slot))
            })
            .map(|order| {
                let text = |i: usize| slots[i].0.text(self.text).to_owned();
                let new = order.iter().zip(&slots).map(|(&i, slot)| (slot.0, text(i)));
                new.collect::<Vec<_>>()
            });
        if let (Some(new), None) = (right.next(), right.next()) {
            out.extend(self.write(Habit::Swapped, &new));
        }
    }

    /// Guesses that two references are in each other's place.
    pub(super) fn swapped(&self, out: &mut Vec<Candidate>) {
        let all = self.referring();
        let texts = |t: &Token| t.text(self.text).to_owned();
        if let [(a, _), (b, _)] = all[..] {
            out.extend(self.write(Habit::Swapped, &[(a, texts(&b)), (b, texts(&a))]));
        }
    }

    /// Guesses at another ID of the record: what else it may change or define.
    pub(super) fn ids(&self, finding: &Diagnostic, undefined: &[u32], out: &mut Vec<Candidate>) {
        if finding.code == Code::E102 && finding.span == self.tokens[0].span() {
            let head = self.tokens[0];
            if let Some(again) = self.again() {
                out.clear();
                out.push(again);
                return;
            }
            out.extend(self.reversed_copy(undefined));
            let misused = self.misused_below();
            let new = undefined.iter().take(MAX_CANDIDATES / 2);
            let new = misused.iter().chain(new);
            let changes = Vec::from_iter(self.id().into_iter().flat_map(|id| self.changes(id)));
            out.extend(new.filter_map(|id| {
                let text = id.to_string();
                let mut candidate = self.write(Habit::Id, &[(head, text.clone())])?;
                let others = changes.iter().map(|&span| Edit {
                    span,
                    text: text.clone(),
                });
                candidate.fix.edits.extend(others);
                Some(candidate)
            }));
            return;
        }
        let Some(ty) = self.ty().filter(|ty| self.fits(ty)) else {
            return;
        };
        let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = ty.effect else {
            return;
        };
        let head = self.tokens[0];
        let Some(id) = self.id().filter(|_| finding.span == head.span()) else {
            return;
        };
        // The change may come before its definition, or belong to the object above, if that has no such record.
        if finding.code == Code::E107 {
            let is_such = |id: u32| {
                let records = self.analysis.document.items.iter().filter_map(Item::record);
                let mut all = records.filter(|r| r.id == id);
                all.any(|r| r.kind == ty.kind)
            };
            let before = self.id_before(kinds).filter(|&id| !is_such(id));
            let habit = match before.is_some() && before == self.id_behind() {
                true => Habit::Between,
                false => Habit::Id,
            };
            out.extend(before.and_then(|id| self.write(habit, &[(head, id.to_string())])));
            return;
        }
        out.extend(self.as_lamp(finding, id, kinds));
        out.extend(self.of_object_above(finding, id, kinds));
        let text = id.to_string();
        // Between two records of one object, the record rather belongs to that object.
        let around = self
            .id_before(kinds)
            .filter(|&id| self.id_behind() == Some(id));
        let before = self.id_before(kinds);
        let used = self.used_above();
        let mut others: Vec<(bool, usize, bool, u32, u32)> = (self.entities(kinds))
            .filter(|e| e.id != id)
            // A change of a shape has no effect behind an operation that uses the shape.
            .filter(|e| !used.contains(&e.id))
            .map(|e| {
                let new = e.id.to_string();
                let distance = strsim::osa_distance(&text, &new);
                // A lost digit makes the ID above likelier than other IDs.
                let is_apart = Some(e.id) != before || new.len() <= text.len();
                (
                    Some(e.id) != around,
                    distance,
                    is_apart,
                    e.id.abs_diff(id),
                    e.id,
                )
            })
            .collect();
        others.sort_unstable();
        out.extend(
            (others.iter().take(MAX_CANDIDATES / 2))
                .filter_map(|o| self.write(Habit::Id, &[(head, o.4.to_string())])),
        );
    }

    /// Guesses that a copy has its ID and that of its original in each other's place, if nothing defines what it
    /// copies.
    fn reversed_copy(&self, undefined: &[u32]) -> Option<Candidate> {
        let is_copy = self.ty().is_some_and(|ty| ty.kind == RecordKind::Copy);
        let (&[of], true) = (self.params(), is_copy) else {
            return None;
        };
        let id = u32::try_from(of.integer(self.text)?).ok()?;
        let head = self.tokens[0];
        let texts = |t: &Token| t.text(self.text).to_owned();
        let is_new = undefined.contains(&id);
        is_new.then(|| self.write(Habit::Id, &[(head, texts(&of)), (of, texts(&head))]))?
    }

    /// The IDs that are used as a wrong kind, since only a property below defines them: the ID may be that of an object
    /// whose definition is this record.
    fn misused_below(&self) -> Vec<u32> {
        let wrong = self.analysis.errors.iter().filter(|e| e.0 == Code::E103);
        let mut ids: Vec<u32> = wrong
            .filter_map(|(_, span)| self.text.get(span.range())?.parse().ok())
            .collect();
        ids.sort_unstable();
        ids.dedup();
        let is_property = |kind: Kind| matches!(kind, Kind::Optics | Kind::Texture | Kind::Colour);
        let below = (self.analysis.scene.entities.iter())
            .filter(|e| e.span.start > self.line.end && e.kind.is_some_and(is_property));
        ids.retain(|&id| below.clone().any(|e| e.id == id));
        ids.truncate(MAX_CANDIDATES / 4);
        ids
    }

    /// Guesses that the record repeats the one directly before it, and deletes it.
    fn again(&self) -> Option<Candidate> {
        let document = &self.analysis.document;
        let items = document.items.iter().rev();
        let mut before = items.filter(|item| document.item_span(item).end <= self.line.start);
        let before = before.next()?.record()?;
        let texts = |t: &Token| t.text(self.text);
        let before = document.significant(before.first, before.last).map(texts);
        if !before.eq(self.tokens.iter().map(texts)) {
            return None;
        }
        let last = self.tokens.last()?;
        let is_alone = self.line.end == last.end() && self.line.start == self.tokens[0].start;
        let source = &self.analysis.source;
        let line = source.line_index(source.floor(self.line.start));
        let start = source.line_span(line).start.min(self.line.start);
        let end = match line + 1 < source.line_count() {
            true => source.line_span(line + 1).start,
            false => self.line.end,
        };
        let fix = Fix::replace(
            AGAIN_TITLE,
            Applicability::Unsafe,
            Span::new(start, end),
            "",
        );
        is_alone.then_some(Candidate::new(Habit::Id, fix))
    }

    /// Guesses that all records of an ID that no other record names are for the entity right above them.
    fn of_object_above(
        &self,
        finding: &Diagnostic,
        id: u32,
        kinds: &'static [Kind],
    ) -> Option<Candidate> {
        let document = &self.analysis.document;
        let records: Vec<&Record> = document.items.iter().filter_map(Item::record).collect();
        let own = |r: &&Record| r.id == id && !matches!(r.ty().effect, Effect::Defines(_));
        let first = records.iter().position(own)?;
        let count = records[first..].iter().take_while(|r| own(r)).count();
        let all = records.iter().filter(|r| r.id == id).count();
        let above = records[first.checked_sub(1)?].id;
        let is_known = self.entities(kinds).any(|e| e.id == above);
        let is_half = finding.code == Code::E103 && count > 1 && count == all && is_known;
        if !is_half || self.named_ids().contains(&id) {
            return None;
        }
        let heads = records[first..first + count].iter();
        let new = heads.map(|r| (*document.id_token(r), above.to_string()));
        let mut candidate = self.write(Habit::Id, &new.collect::<Vec<_>>())?;
        let number = quote(&above.to_string());
        candidate.fix.title = "fix-write-all";
        candidate.fix.values = vec![
            ("number", number.into()),
            ("count", Value::Count(count as u64)),
        ];
        Some(candidate)
    }

    /// Guesses that an ambient light is a point light, since the record moves it.
    fn as_lamp(&self, finding: &Diagnostic, id: u32, kinds: &'static [Kind]) -> Option<Candidate> {
        let is_one = finding.code == Code::E103 && kinds.contains(&Kind::PointLight);
        let document = &self.analysis.document;
        let mut records = document.items.iter().filter_map(Item::record);
        let light = records.find(|r| r.id == id && r.kind == RecordKind::AmbientLight)?;
        let ty = document.significant(light.first, light.last).nth(1)?;
        let code = RecordType::of(RecordKind::PointLight).code.to_string();
        let lamp = is_one.then_some((*ty, code))?;
        self.write(Habit::Sibling, &[lamp])
    }
}
