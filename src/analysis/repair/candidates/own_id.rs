//! A new ID for a record that has the ID of another one.

use super::inline::{CHAIN_TITLE, FREE_TITLE, OWN_TITLE};
use super::references::AGAIN_TITLE;
use super::{Candidate, Habit, LineContext};
use crate::analysis::repair::whole::{records, references};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::Item;
use crate::syntax::ast::Record;
use crate::syntax::lexer::Token;
use crate::syntax::table::{Effect, Family, Kind, ParamKind, RecordKind, RecordType};

/// The most new IDs that a title names.
const MAX_SHOWN_IDS: usize = 4;

impl LineContext<'_> {
    /// The kind of property that the record defines, and the kind that the entity with its ID has, where these differ.
    pub(super) fn other_property(&self) -> Option<(Kind, Kind)> {
        let is_property = |kind: &Kind| matches!(kind, Kind::Optics | Kind::Texture | Kind::Colour);
        let Effect::DefinesOrChanges(own, _) = self.ty()?.effect else {
            return None;
        };
        let id = self.id()?;
        let mut entities = self.analysis.scene.entities.iter();
        let other = entities.find(|e| e.id == id)?.kind.filter(is_property)?;
        (is_property(&own) && own != other).then_some((own, other))
    }

    /// Guesses at a free ID for the record. If it is a property with the ID of a property of another kind, assignments
    /// of the other property assign the new ID, too.
    pub(super) fn own_id(&self, finding: &Diagnostic, used: &[u32], out: &mut Vec<Candidate>) {
        let head = self.tokens[0].span();
        let is_twice = finding.code == Code::E102 && finding.case.is_empty();
        let property = (self.other_property()).filter(|_| finding.code == Code::E103);
        let (Some(new), Some(id)) = (self.free_id(used), self.id()) else {
            return;
        };
        let is_again = |c: &Candidate| c.fix.title == AGAIN_TITLE;
        if finding.span != head || !(is_twice || property.is_some()) || out.iter().any(is_again) {
            return;
        }
        if is_twice && let Some(chain) = self.chain(id, new) {
            out.push(chain);
            return;
        }
        let mut edits = vec![edit(head, new)];
        if is_twice {
            edits.extend(self.changes(id).map(|place| edit(place, new)));
        }
        let mut objects: Vec<String> = Vec::new();
        if let Some(kinds) = property {
            for (object, place) in self.assignments(id, kinds) {
                edits.push(edit(place, new));
                objects.push(object.to_string());
            }
        }
        edits.sort_by_key(|e| e.span.start);
        let fix = Fix {
            title: if objects.is_empty() {
                FREE_TITLE
            } else {
                OWN_TITLE
            },
            values: vec![
                ("number", new.to_string().into()),
                ("text", objects.join(", ").into()),
                ("count", Value::Count(objects.len() as u64)),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        out.push(Candidate::new(Habit::Id, fix));
    }

    /// Guesses that a change which has lost its ID has the ID of the record before.
    pub(super) fn lost_id(&self, finding: &Diagnostic) -> Option<Candidate> {
        let head = self.tokens.first()?;
        let ty = RecordType::by_code(head.integer(self.text)?)?;
        let (Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds)) = ty.effect else {
            return None;
        };
        let own = &self.tokens[1..];
        let is_one = finding.code == Code::E005 && !own.is_empty() && self.fit(ty, own);
        let before = self.id_before(kinds).filter(|_| is_one)?;
        let id = self.other_half(before, ty).unwrap_or(before);
        let text = format!("{id} {}", head.text(self.text));
        self.write(Habit::Id, &[(*head, text)])
    }

    /// The only other property of the same kind that has no record of this type yet, if the property `before` has one:
    /// a second one there would have no effect.
    fn other_half(&self, before: u32, ty: &RecordType) -> Option<u32> {
        let Effect::DefinesOrChanges(own, _) = ty.effect else {
            return None;
        };
        let has_one = |id: u32| records(self.analysis).any(|r| r.id == id && r.kind == ty.kind);
        let mut others = (self.analysis.scene.entities.iter())
            .filter(|e| e.kind == Some(own) && has_one(before) && !has_one(e.id));
        let other = others.next()?;
        others.next().is_none().then_some(other.id)
    }

    /// Guesses that the minus of an ID is too many, if the ID without it is defined, or used but not defined.
    pub(super) fn negative_id(&self, finding: &Diagnostic, undefined: &[u32]) -> Option<Candidate> {
        let id = u32::try_from(self.int(0)?.checked_neg()?).ok()?;
        let mut entities = self.analysis.scene.entities.iter();
        let is_known = undefined.contains(&id) || entities.any(|e| e.id == id);
        let is_one = finding.code == Code::E005 && self.ty().is_some_and(|ty| self.fits(ty));
        let new = [(self.tokens[0], id.to_string())];
        (is_known && is_one).then(|| self.write(Habit::Id, &new))?
    }

    /// The ID of the record before this one, if its entity is of one of some kinds.
    pub(super) fn id_before(&self, kinds: &'static [Kind]) -> Option<u32> {
        let document = &self.analysis.document;
        let items = document.items.iter().rev();
        let mut before = items.filter(|item| document.item_span(item).end <= self.line.start);
        let id = before.find_map(|item| match item {
            Item::Record(r) => Some(r.id),
            Item::Broken(b) => b.id,
            Item::Void { .. } => None,
        })?;
        self.entities(kinds).any(|e| e.id == id).then_some(id)
    }

    /// The ID of the record behind this one, if that record can be read.
    pub(super) fn id_behind(&self) -> Option<u32> {
        let document = &self.analysis.document;
        let mut items = document.items.iter();
        let behind = items.find(|item| document.item_span(item).start >= self.line.end);
        Some(behind?.record()?.id)
    }

    /// The places of the IDs of the records that follow this one directly and change the entity `id`.
    pub(super) fn changes(&self, id: u32) -> impl Iterator<Item = Span> {
        let document = &self.analysis.document;
        let end = self.tokens.last().map_or(self.line.end, |t| t.end());
        let behind = document.items.iter();
        let behind = behind.skip_while(move |item| document.item_span(item).start < end);
        let records = behind.filter(|item| !matches!(item, Item::Void { .. }));
        let is_change =
            move |r: &&Record| r.id == id && !matches!(r.ty().effect, Effect::Defines(_));
        let own = records.map_while(move |item| item.record().filter(is_change));
        own.map(|r| document.id_token(r).span())
    }

    /// Guesses that operations have the ID of one of their operands, as in `3 -101 3 4` and `3 -101 3 5`. Each gets an
    /// ID of its own, and records behind it name that ID.
    fn chain(&self, id: u32, free: u32) -> Option<Candidate> {
        let is_id = |t: &Token| t.integer(self.text) == Some(id.into());
        if !self.is_operation() || !self.params().iter().any(is_id) {
            return None;
        }
        let document = &self.analysis.document;
        let begin = self.tokens[0].start;
        let behind = records(self.analysis).filter(|r| document.id_token(r).start >= begin);
        let mut edits = Vec::new();
        let mut links: Vec<String> = Vec::new();
        // The render record means the last operation, wherever the render record stands.
        let mut late = Vec::new();
        let mut meant = id;
        for record in behind {
            let named: Vec<Token> = (references(self.analysis, record))
                .filter(|(_, named)| *named == i64::from(id))
                .map(|(t, _)| t)
                .collect();
            if record.kind == RecordKind::Render {
                late.extend(named);
                continue;
            }
            let is_operation = record.ty().family == Family::Operation;
            let is_link = record.id == id && is_operation && !named.is_empty();
            let of_before = named.iter().filter(|_| meant != id);
            edits.extend(of_before.map(|t| edit(t.span(), meant)));
            if is_link {
                meant = free.checked_add(u32::try_from(links.len()).ok()?)?;
                links.push(meant.to_string());
            }
            if record.id == id && (is_link || !matches!(record.ty().effect, Effect::Defines(_))) {
                edits.push(edit(document.id_token(record).span(), meant));
            }
        }
        edits.extend(late.iter().map(|t| edit(t.span(), meant)));
        edits.sort_by_key(|e| e.span.start);
        let shown = match &links[..] {
            [first, second, .., last] if links.len() > MAX_SHOWN_IDS => {
                vec![first.as_str(), second, "…", last]
            }
            all => all.iter().map(String::as_str).collect(),
        };
        let fix = Fix {
            title: CHAIN_TITLE,
            values: vec![
                ("number", shown.join(", ").into()),
                ("text", id.to_string().into()),
                ("count", Value::Count(links.len() as u64)),
            ],
            applicability: Applicability::Unsafe,
            edits,
        };
        Some(Candidate::new(Habit::Id, fix))
    }

    /// The objects to which an ID is assigned, each with the place in the assignment for a property of the kind `own`.
    /// That place is 0 or has the ID as well.
    fn assignments(&self, id: u32, (own, other): (Kind, Kind)) -> Vec<(u32, Span)> {
        let ty = RecordType::of(RecordKind::Assignment);
        let place = |kind: Kind| {
            let takes = |k: &ParamKind| matches!(k, ParamKind::Reference { kinds, .. } if kinds.contains(&kind));
            ty.params.iter().position(|p| takes(&p.kind))
        };
        // Colours and textures share one place.
        let (Some(own), Some(other)) = (place(own), place(other)) else {
            return Vec::new();
        };
        let document = &self.analysis.document;
        let all = document.items.iter().filter_map(Item::record);
        let all = all.filter(|r| r.kind == ty.kind && own != other);
        all.filter_map(|record| {
            let values = document.values(record);
            let is = |i: usize, id: u32| values.get(i) == Some(&f64::from(id));
            let is_meant = is(other, id) && (is(own, 0) || is(own, id)) || is(own, id);
            let token = document.params(record).nth(own).filter(|_| is_meant)?;
            Some((record.id, token.span()))
        })
        .collect()
    }
}

fn edit(span: Span, id: u32) -> Edit {
    Edit {
        span,
        text: id.to_string(),
    }
}
