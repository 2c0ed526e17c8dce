//! Assignments whose IDs are in wrong places: the record has a wrong ID or none, and the ID of the object may be among
//! its references.

use rustc_hash::FxHashSet;

use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::whole::records;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit};
use crate::scene::names;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Family, Kind, RecordKind, RecordType};
use crate::syntax::{Item, Record};

/// The most objects that are proposed for an assignment that names none.
const MAX_CHOICES: usize = 2;

impl LineContext<'_> {
    /// Puts the IDs of an assignment into the places for their kinds, if its own ID is missing or that of no object:
    /// `-299 2 35` and `35 -299 35 2`, where 2 is an object and 35 optics. An ID that is written twice is meant once.
    pub(super) fn assigned(&self, finding: &Diagnostic) -> Option<Candidate> {
        let ty = RecordType::of(RecordKind::Assignment);
        let is_type = |i: usize| self.int(i) == Some(ty.code.into());
        let is_lost = finding.code == Code::E005 && is_type(0);
        let is_of_object = self.int(0).and_then(|id| self.kind_of(id)) == Some(Kind::Object);
        let is_wrong = finding.code == Code::E103 && is_type(1) && !is_of_object;
        if !is_lost && !is_wrong || self.tokens.len() != 3 + usize::from(is_wrong) {
            return None;
        }
        let mut places: [Option<i64>; 3] = [None; 3];
        let ids = self.tokens.iter().map(|t| t.integer(self.text));
        for (_, id) in ids.enumerate().filter(|(i, _)| !is_type(*i)) {
            let Some(id) = id.filter(|&id| id != 0) else {
                continue;
            };
            let place = match self.kind_of(id)? {
                Kind::Object => 0,
                Kind::Texture | Kind::Colour => 1,
                Kind::Optics => 2,
                _ => return None,
            };
            if places[place].replace(id).is_some_and(|other| other != id) {
                return None;
            }
        }
        let [Some(object), texture, optics] = places else {
            return None;
        };
        let kinds = [Some(object), texture, optics].into_iter().flatten();
        if kinds.count() < 2 {
            return None;
        }
        let [texture, optics] = [texture, optics].map(|id| id.unwrap_or(0));
        let text = format!("{object} {} {texture} {optics}", ty.code);
        let span = self.tokens.first()?.span().to(self.tokens.last()?.span());
        let is_new = self.text[span.range()] != text;
        let habit = if is_lost { Habit::Id } else { Habit::Swapped };
        is_new.then(|| Candidate::writing(habit, span, text))
    }

    /// Joins an optical property and a refractive index that an assignment names as two: `5 -299 6 7` becomes `5 -299 0 6`,
    /// and the record of the index gets the ID 6. Nothing else names the index.
    pub(super) fn as_one_property(&self, finding: &Diagnostic) -> Option<Candidate> {
        let is_one = self
            .ty()
            .is_some_and(|ty| ty.kind == RecordKind::Assignment);
        let (&[one, two], true) = (self.params(), is_one && finding.code == Code::E103) else {
            return None;
        };
        let document = &self.analysis.document;
        let records = document.items.iter().filter_map(Item::record);
        let above = |id: i64| -> Vec<&Record> {
            let is_own = |r: &&Record| i64::from(r.id) == id;
            records.clone().filter(is_own).take(3).collect()
        };
        let only = |t: Token| match above(t.integer(self.text)?)[..] {
            [record] => Some(record),
            _ => None,
        };
        let [first, second] = [only(one)?, only(two)?];
        let is_light = |r: &Record| matches!(r.kind, RecordKind::Optics | RecordKind::OpticsRgb);
        let is_index = |r: &Record| r.kind == RecordKind::RefractiveIndex;
        let (light, index, kept) = match () {
            () if is_light(first) && is_index(second) => (first, second, one),
            () if is_index(first) && is_light(second) => (second, first, two),
            () => return None,
        };
        let naming = records.filter(|r| names::references(document, r).any(|id| id == index.id));
        if naming.count() > 1 {
            return None;
        }
        let kept = kept.text(self.text).to_owned();
        let mut joined = self.write(Habit::Swapped, &[(one, "0".into()), (two, kept)])?;
        joined.fix.title = "fix-joined";
        joined.fix.values.extend([
            ("id", index.id.to_string().into()),
            ("other", light.id.to_string().into()),
        ]);
        joined.fix.edits.push(Edit {
            span: document.id_token(index).span(),
            text: light.id.to_string(),
        });
        joined.fix.edits.sort_by_key(|edit| edit.span.start);
        Some(joined)
    }

    /// Guesses at the object of an assignment that has lost its ID, if its references are right: shapes above that have
    /// no such property yet. Two shapes are a choice; more are too many.
    pub(super) fn assigned_to(&self, finding: &Diagnostic) -> Vec<Candidate> {
        let ty = RecordType::of(RecordKind::Assignment);
        let [head, texture, optics] = self.tokens[..] else {
            return Vec::new();
        };
        let is_lost = finding.code == Code::E005 && self.int(0) == Some(ty.code.into());
        let kind = |t: &Token| Some((t.integer(self.text)?, self.kind_of(t.integer(self.text)?)));
        let (Some(texture), Some(optics)) = (kind(&texture), kind(&optics)) else {
            return Vec::new();
        };
        let is_of = |(id, kind): (i64, Option<Kind>), kinds: &[Kind]| {
            id == 0 || kind.is_some_and(|kind| kinds.contains(&kind))
        };
        let fits = is_of(texture, &[Kind::Texture, Kind::Colour]) && is_of(optics, &[Kind::Optics]);
        if !is_lost || !fits || (texture.0, optics.0) == (0, 0) {
            return Vec::new();
        }
        let mut shapes: Vec<u32> = Vec::new();
        let mut given: FxHashSet<u32> = FxHashSet::default();
        for record in records(self.analysis) {
            let is_above =
                self.analysis.document.span(record.first, record.last).end <= self.line.start;
            match record.ty().family {
                Family::Shape if is_above => shapes.push(record.id),
                Family::Texture | Family::Colour if texture.0 != 0 => {
                    given.insert(record.id);
                }
                Family::Property if optics.0 != 0 || record.kind == ty.kind => {
                    given.insert(record.id);
                }
                _ => {}
            }
        }
        shapes.retain(|id| !given.contains(id));
        if shapes.len() > MAX_CHOICES {
            return Vec::new();
        }
        let is_one = shapes.len() == 1;
        let written = |id: &u32| {
            let new = [(head, format!("{id} {}", ty.code))];
            let mut candidate = self.write(Habit::Id, &new)?;
            if !is_one {
                candidate.fix.applicability = Applicability::Choice;
            }
            Some(candidate)
        };
        shapes.iter().filter_map(written).collect()
    }

    /// The IDs that records name, for a finding about a reference of an assignment that is of a wrong kind, and
    /// may be 0 instead.
    pub(super) fn of_others(&self, finding: &Diagnostic) -> FxHashSet<u32> {
        let is_one = self
            .ty()
            .is_some_and(|ty| ty.kind == RecordKind::Assignment);
        let is_reference = self.params().iter().any(|t| t.span() == finding.span);
        match is_one && is_reference && finding.code == Code::E103 {
            true => self.named_ids(),
            false => FxHashSet::default(),
        }
    }
}
