//! Definitions that a scene needs and lacks: the records that are left use or change the ID that is not defined.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{named, switched_off};
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::scene::{Entity, names};
use crate::syntax::table::{Effect, Family, Kind, ParamKind, RecordKind, RecordType};
use crate::syntax::{Item, Record};

/// The most IDs that are examined.
const IDS: usize = 16;

/// Whether a finding says that the definition of an ID is missing.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    d.code == Code::E101 && d.case.starts_with("missing")
}

/// The records of a scene, with the uses and the moves of its IDs.
struct Ids<'a> {
    analysis: &'a Analysis,
    records: Vec<&'a Record>,
    /// How often records name an ID.
    uses: FxHashMap<u32, usize>,
    /// The IDs that a transformation changes.
    moved: FxHashSet<u32>,
}

/// Replaces the findings about an ID by one that says that its definition is missing, and proposes no other ID. The
/// caller tries the guesses at the definition.
pub(super) fn retell(analysis: &Analysis, findings: &mut Vec<Diagnostic>) {
    let is_of_id = |d: &&Diagnostic| {
        let is_open = matches!(d.case, "" | "changed") && !switched_off::is_told(d);
        matches!(d.code, Code::E101 | Code::E103) && is_open
    };
    let mut seen = FxHashSet::default();
    let mut ids: Vec<u32> = (findings.iter().filter(is_of_id))
        .filter_map(named)
        .filter(|&id| seen.insert(id))
        .take(IDS)
        .collect();
    ids.sort_unstable();
    // A record that cannot be read, is defined twice or has a reserved ID may be the missing definition.
    let is_broken = |item: &Item| matches!(item, Item::Broken(_));
    if ids.is_empty()
        || analysis.document.items.iter().any(is_broken)
        || (findings.iter()).any(|d| matches!(d.code, Code::E102 | Code::E105))
    {
        return;
    }
    let scene = Ids::new(analysis);
    for id in ids {
        let of_id = |d: &Diagnostic| is_of_id(&d) && named(d) == Some(id);
        let spans: Vec<Span> = (findings.iter().filter(|d| of_id(d)))
            .map(|d| d.span)
            .collect();
        let Some(finding) = spans.first().and_then(|_| scene.missing(id, &spans)) else {
            continue;
        };
        let copies = scene.copies(id);
        let is_of_copy =
            |d: &Diagnostic| is_of_id(&d) && named(d).is_some_and(|id| copies.contains(&id));
        // A record with several errors has a slip of its own.
        let told: FxHashSet<u32> = (spans.iter())
            .filter_map(|&span| scene.record_at(span))
            .map(|record| record.first)
            .collect();
        let is_of_those = |d: &Diagnostic| {
            scene
                .record_at(d.span)
                .is_some_and(|r| told.contains(&r.first))
        };
        let mut others = findings
            .iter()
            .filter(|d| d.is_error() && !of_id(d) && !is_of_copy(d));
        if others.any(is_of_those) {
            continue;
        }
        let is_lamp = finding.case == "missing-lamp";
        // If the definition is missing, it is plain that a property has no use, or that there is no light.
        let is_plain = |d: &Diagnostic| {
            d.code == Code::W310 && named(d) == Some(id) || d.code == Code::N603 && is_lamp
        };
        findings.retain(|d| !of_id(d) && !is_of_copy(d) && !is_plain(d));
        findings.push(finding);
        crate::diagnostics::sort(findings);
    }
}

impl<'a> Ids<'a> {
    fn new(analysis: &'a Analysis) -> Ids<'a> {
        let records: Vec<&Record> = (analysis.document.items.iter())
            .filter_map(Item::record)
            .collect();
        let (mut uses, mut moved) = (FxHashMap::default(), FxHashSet::default());
        for record in &records {
            if record.ty().family == Family::Transformation {
                moved.insert(record.id);
            }
            for id in names::references(&analysis.document, record) {
                *uses.entry(id).or_default() += 1;
            }
        }
        Ids {
            analysis,
            records,
            uses,
            moved,
        }
    }

    fn uses(&self, id: u32) -> usize {
        self.uses.get(&id).copied().unwrap_or(0)
    }

    /// The record that contains or touches a place.
    fn record_at(&self, place: Span) -> Option<&'a Record> {
        let span = |r: &Record| self.analysis.document.span(r.first, r.last);
        let behind = self.records.partition_point(|r| span(r).start <= place.end);
        let near = &self.records[behind.saturating_sub(2)..behind];
        near.iter().find(|r| span(r).touches(place)).copied()
    }

    /// The finding that the definition of `id` is missing; `spans` are the places of the findings about the ID. `None`
    /// if another slip is likelier.
    fn missing(&self, id: u32, spans: &[Span]) -> Option<Diagnostic> {
        let own: Vec<&Record> = (self.records.iter())
            .filter(|r| r.id == id)
            .copied()
            .collect();
        if own
            .iter()
            .any(|r| matches!(r.ty().effect, Effect::Defines(_)))
        {
            return None;
        }
        let document = &self.analysis.document;
        let uses = self.uses(id);
        let is_property = |r: &&&Record| matches!(r.ty().effect, Effect::DefinesOrChanges(..));
        let properties = own.iter().filter(is_property).count();
        let heads: FxHashSet<Span> = own.iter().map(|r| document.id_token(r).span()).collect();
        let is_of_use = |span: &&Span| !heads.contains(*span);
        let wrong = spans.iter().filter(is_of_use).count();
        // Whether the reference at a place asks for an object.
        let asks = |at: Span| self.kinds_at(at) == Some(&[Kind::Object]);
        if spans.iter().filter(is_of_use).any(|&at| !asks(at)) {
            return self.missing_colour(id, spans);
        }
        // The object of an assignment may stand in the place of a property.
        let assigned: FxHashSet<u32> = (own.iter())
            .filter(|r| r.kind == RecordKind::Assignment)
            .flat_map(|r| names::references(document, r))
            .collect();
        let is_object = |e: &Entity| e.kind == Some(Kind::Object) && assigned.contains(&e.id);
        if self.analysis.scene.entities.iter().any(is_object) {
            return None;
        }
        // If other records use the ID as a property, its property records are right and no object is missing.
        if properties > 0 && uses > wrong + self.copied(id) {
            return None;
        }
        if own
            .first()
            .is_some_and(|first| self.has_lost_digit(id, first))
        {
            return None;
        }
        let lights = (own.iter()).all(|r| match r.ty().effect {
            Effect::Changes(kinds) | Effect::DefinesOrChanges(_, kinds) => {
                kinds.contains(&Kind::PointLight)
            }
            Effect::Defines(_) => false,
        });
        let is_lamp = uses == 0 && lights;
        let at = spans[0];
        let finding = Diagnostic::new(Code::E101, at).with("id", id.to_string());
        if wrong > 0
            && let Some(first) = own.first()
            && let Some(fixes) = self.operations(id, first, spans)
        {
            let finding = finding.case("missing-operation").note("choose");
            return Some(fixes.into_iter().fold(finding, Diagnostic::fix));
        }
        if self.is_left_over(id, is_lamp) {
            return None;
        }
        let several = own.len() + uses > 1;
        if is_lamp && (several || self.is_in_order(id, own.first()?)) {
            return Some(finding.case(match self.has_lamp() {
                true => "missing",
                false => "missing-lamp",
            }));
        }
        if is_lamp && own.len() == 1 && self.is_beside_lamp(own[0]) {
            return Some(finding.case("missing-lamp"));
        }
        if several && !own.is_empty() {
            return Some(finding.case("missing-shape"));
        }
        let user = self.record_at(at)?;
        if uses != 1 || !own.is_empty() || !asks(at) {
            return None;
        }
        let start = document.tokens[user.first as usize].start;
        let left: Vec<&Entity> = self.unused(Kind::Object, start).take(3).collect();
        match left[..] {
            // All references of a record may be off by the same number.
            [a, b] if self.is_shifted(user, [a.id, b.id]) => None,
            [a, b] => {
                // In a chain of unions, the union before is the first operand.
                let is_made = |id: u32| {
                    (self.records.iter()).any(|r| r.id == id && r.ty().family == Family::Operation)
                };
                let (a, b) = match is_made(b.id) && !is_made(a.id) {
                    true => (b, a),
                    false => (a, b),
                };
                let text = format!("{id} -101 {} {}", a.id, b.id);
                let span = Span::new(start, start);
                let edits = vec![Edit {
                    span,
                    text: format!("{text}\n"),
                }];
                let fix = Fix::guess("fix-union", edits).with("text", text);
                Some(finding.case("missing-union").fix(fix))
            }
            [_, _, ..] => Some(finding.case("missing")),
            _ => None,
        }
    }

    /// The kinds that the reference at a place may refer to. `None` if no reference stands there.
    fn kinds_at(&self, at: Span) -> Option<&'static [Kind]> {
        let record = self.record_at(at)?;
        let mut tokens = self
            .analysis
            .document
            .significant(record.first, record.last);
        let place = tokens.position(|t| t.span() == at)?.checked_sub(2)?;
        match record.ty().params.get(place)?.kind {
            ParamKind::Reference { kinds, .. } => Some(kinds),
            _ => None,
        }
    }

    /// Fixes that define `id` as an operation on the only two unused objects above the record `first`, and write the
    /// operation above that record. `None` if there are not just two, or if IDs that are all off by the same number may
    /// mean them.
    fn operations(&self, id: u32, first: &Record, spans: &[Span]) -> Option<Vec<Fix>> {
        let start = self.analysis.document.tokens[first.first as usize].start;
        let left: Vec<&Entity> = self.unused(Kind::Object, start).take(3).collect();
        let &[a, b] = left.as_slice() else {
            return None;
        };
        let mut users = spans.iter().filter_map(|&at| self.record_at(at));
        if users.any(|user| self.is_shifted(user, [a.id, b.id])) {
            return None;
        }
        let kinds = [
            RecordKind::Union,
            RecordKind::Intersection,
            RecordKind::Difference,
        ];
        let fixes = kinds.map(|kind| {
            let ty = RecordType::of(kind);
            let text = format!("{id} {} {} {}", ty.code, a.id, b.id);
            let span = Span::new(start, start);
            let fix = Fix::replace(
                "fix-operation",
                Applicability::Choice,
                span,
                format!("{text}\n"),
            );
            let fix = fix.with("text", text).with("type", Value::Term(ty.title));
            fix.with("first", a.id.to_string())
                .with("last", b.id.to_string())
        });
        Some(fixes.into())
    }

    /// Whether a record is a translation right behind the records of a lamp whose ID is one smaller, or right before a
    /// lamp whose ID is one larger.
    fn is_beside_lamp(&self, record: &Record) -> bool {
        let behind = self.records.partition_point(|r| r.first <= record.first);
        let before = behind.checked_sub(2).map(|i| self.records[i].id);
        let is_lamp = |id: Option<u32>| {
            let mut entities = self.analysis.scene.entities.iter();
            id.is_some_and(|id| entities.any(|e| e.id == id && e.kind == Some(Kind::PointLight)))
        };
        let next = self.records.get(behind).map(|r| r.id);
        let is_next = |id: Option<u32>, by: i64| {
            id.is_some_and(|id| i64::from(id) == i64::from(record.id) + by) && is_lamp(id)
        };
        record.kind == RecordKind::Translation && (is_next(before, -1) || is_next(next, 1))
    }

    /// The finding that a colour of a checkerboard is missing. `None` if another colour above may be meant.
    fn missing_colour(&self, id: u32, spans: &[Span]) -> Option<Diagnostic> {
        let &[at] = spans else { return None };
        let user = self.record_at(at)?;
        let document = &self.analysis.document;
        let start = document.tokens[user.first as usize].start;
        let own: Vec<u32> = names::references(document, user).collect();
        let is_other =
            |e: &Entity| matches!(e.kind, None | Some(Kind::Colour)) && !own.contains(&e.id);
        let is_one = user.kind == RecordKind::Checkerboard
            && self.uses(id) == 1
            && self.records.iter().all(|r| r.id != id)
            && !(self.analysis.scene.entities.iter()).any(|e| is_other(e) && e.span.start < start);
        let finding = Diagnostic::new(Code::E101, at).with("id", id.to_string());
        is_one.then(|| finding.case("missing-colour"))
    }

    /// Whether the two references of a record would be the IDs in `left` if both were off by the same one or two.
    fn is_shifted(&self, user: &Record, left: [u32; 2]) -> bool {
        let named: Vec<u32> = names::references(&self.analysis.document, user).collect();
        // An object that only this record names would be without use.
        let is_object = |e: &Entity| e.kind == Some(Kind::Object);
        let objects = self.analysis.scene.entities.iter().filter(|e| is_object(e));
        let mut only_here = objects.filter(|e| named.contains(&e.id) && self.uses(e.id) == 1);
        if only_here.next().is_some() {
            return false;
        }
        let is_off = |by: i64| {
            let mut meant = named.iter().map(|&id| i64::from(id) + by);
            named.len() == left.len() && meant.all(|id| left.iter().any(|&l| i64::from(l) == id))
        };
        [1, -1, 2, -2].into_iter().any(is_off)
    }

    /// Whether an ID lies between the IDs that are defined above its record and those defined below, and is no slip of
    /// the ID of the record above.
    fn is_in_order(&self, id: u32, record: &Record) -> bool {
        let document = &self.analysis.document;
        let start = document.tokens[record.first as usize].start;
        let all = || self.analysis.scene.entities.iter();
        let above = all().filter(|e| e.span.start < start);
        let below = all().filter(|e| e.span.start > start && e.kind != Some(Kind::Render));
        let (Some(last), Some(next)) = (above.map(|e| e.id).max(), below.map(|e| e.id).min())
        else {
            return false;
        };
        let before = self.records.iter().rev().find(|r| r.first < record.first);
        let is_near = |other: u32| strsim::osa_distance(&id.to_string(), &other.to_string()) < 2;
        let is_next = last + 1 == id && id + 1 == next;
        last < id && id < next && (is_next || before.is_some_and(|r| !is_near(r.id)))
    }

    fn has_lamp(&self) -> bool {
        let is_lamp = |r: &&Record| r.kind == RecordKind::PointLight;
        self.records.iter().any(is_lamp)
    }

    /// The entities of a kind above a place that no record names.
    fn unused(&self, kind: Kind, before: u32) -> impl Iterator<Item = &'a Entity> {
        let entities = self.analysis.scene.entities.iter();
        entities
            .filter(move |e| e.kind == Some(kind) && e.span.start < before && self.uses(e.id) == 0)
    }

    /// Whether the missing entity may exist under a wrong ID: a lamp that nothing moves, or an object that nothing
    /// uses.
    fn is_left_over(&self, id: u32, is_lamp: bool) -> bool {
        let own = self.records.iter().any(|r| r.id == id);
        match is_lamp {
            true => self
                .unused(Kind::PointLight, u32::MAX)
                .any(|e| !self.moved.contains(&e.id)),
            false => own && self.unused(Kind::Object, u32::MAX).next().is_some(),
        }
    }

    /// Whether the first record of an ID stands right below a record of an object whose ID has one digit more or less.
    /// The records of the ID are then rather those of that object.
    fn has_lost_digit(&self, id: u32, first: &Record) -> bool {
        let behind = self.records.partition_point(|r| r.first < first.first);
        let Some(above) = behind.checked_sub(1).map(|i| self.records[i].id) else {
            return false;
        };
        let mut entities = self.analysis.scene.entities.iter();
        let is_object = entities.any(|e| e.id == above && e.kind == Some(Kind::Object));
        let (a, b) = (id.to_string(), above.to_string());
        let is_slip = a.len().abs_diff(b.len()) == 1 && strsim::osa_distance(&a, &b) == 1;
        is_object && is_slip && id != above + 1 && self.uses(id) == 0
    }

    /// The number of records that copy the object with an ID.
    fn copied(&self, id: u32) -> usize {
        let document = &self.analysis.document;
        let is_copy = |r: &&&Record| r.kind == RecordKind::Copy;
        let of_id = |r: &&Record| names::references(document, r).any(|named| named == id);
        (self.records.iter().filter(is_copy))
            .filter(|r| of_id(r))
            .count()
    }

    /// The IDs of the copies of an object, and of copies of those.
    fn copies(&self, id: u32) -> FxHashSet<u32> {
        let mut all = FxHashSet::default();
        for record in self.records.iter().filter(|r| r.kind == RecordKind::Copy) {
            let mut of = names::references(&self.analysis.document, record);
            if of.any(|named| named == id || all.contains(&named)) {
                all.insert(record.id);
            }
        }
        all
    }
}
