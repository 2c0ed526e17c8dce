//! Properties in wrong places: above the object that they are for, or with the ID of the next object in place of the ID
//! of the one above. Also objects that are used before they are defined, where only their properties stand above the
//! use.

use rustc_hash::FxHashMap;

use super::whole::{Matter, records};
use crate::analysis::{Analysis, moving};
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span};
use crate::syntax::table::{Effect, Kind, RecordKind};
use crate::syntax::{Record, quote};

/// Most objects whose properties are moved in one file.
const MAX_OBJECTS: usize = 8;

/// Whether a finding says that properties stand above their object.
fn is_early(d: &Diagnostic) -> bool {
    d.code == Code::E102 && d.case == "property"
}

/// Whether a finding proposes to move properties behind their object.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    is_early(d) && !d.fixes.is_empty()
}

/// Finds objects that are used where only their properties are defined. The fix moves each definition above these.
pub(super) fn definitions(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Matter> {
    let mut wrong: FxHashMap<u32, Vec<&Diagnostic>> = FxHashMap::default();
    for d in findings.iter().filter(|d| d.code == Code::E103) {
        if let Some(id) = super::named(d) {
            wrong.entry(id).or_default().push(d);
        }
    }
    let uses = |d: &Diagnostic| {
        let own = super::named(d).and_then(|id| wrong.get(&id));
        own.map_or(&[][..], Vec::as_slice)
    };
    let first_use = |d: &Diagnostic| {
        let used = uses(d).iter().find(|e| e.case.is_empty())?.span;
        Some(used).filter(|used| used.end <= d.span.start)
    };
    let used: Vec<(&Diagnostic, Span)> = (findings.iter())
        .filter(|d| is_early(d))
        .filter_map(|d| Some((d, first_use(d)?)))
        .take(MAX_OBJECTS)
        .collect();
    let definitions: Vec<&Diagnostic> = used.iter().map(|(d, _)| *d).collect();
    let moved = moving::above(&analysis.source, &analysis.document, &definitions);
    let matters = used
        .into_iter()
        .zip(moved)
        .filter_map(|((d, used), moved)| {
            let (fix, mut spans) = moved?;
            spans.push(d.span);
            spans.extend(uses(d).iter().map(|e| e.span));
            let finding = Diagnostic::new(Code::E107, used)
                .with("id", super::named(d)?.to_string())
                .label(d.span, "later")
                .fix(fix);
            Some(Matter { finding, spans })
        });
    matters.collect()
}

/// Finds objects whose properties stand above them; the fix moves the properties behind the object. Nothing is proposed
/// where some ID is undefined or used as a wrong kind, since the object may be meant to have that ID. A property that
/// rather belongs to the object above gets the ID of that object, unless it stands right above the object whose ID it
/// has, and that has no other.
pub(super) fn properties(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Matter> {
    let early: Vec<&Diagnostic> = (findings.iter().filter(|d| is_early(d)))
        .take(MAX_OBJECTS)
        .collect();
    if early.is_empty() {
        return Vec::new();
    }
    let (source, document) = (&analysis.source, &analysis.document);
    let moved = moving::behind(source, document, &early);
    let lines: Vec<Span> = moved.iter().flatten().flat_map(|m| m.1.clone()).collect();
    let may_be_other = |d: &Diagnostic| {
        let is_reference = matches!(d.code, Code::E101 | Code::E103);
        is_reference && !lines.iter().any(|line| line.touches(d.span))
    };
    if findings.iter().any(may_be_other) {
        return Vec::new();
    }
    let blocks = Blocks::new(analysis);
    let slips: Vec<Option<Slip>> = early.iter().map(|d| blocks.slip(d)).collect();
    // A person who writes properties before their object does so more than once.
    let is_habit = early.len() > 1 && slips.iter().flatten().all(|slip| !slip.is_sure);
    let matters = early.into_iter().zip(moved).zip(slips);
    let matters = matters.filter_map(|((d, moved), slip)| {
        let (mut fix, mut spans) = moved?;
        spans.push(d.span);
        let finding = d.clone();
        let finding = match slip.filter(|_| !is_habit) {
            None => finding.fix(fix),
            Some(mut slip) => {
                fix.applicability = Applicability::Choice;
                if !slip.is_sure {
                    slip.fix.applicability = Applicability::Choice;
                }
                finding.fix(slip.fix).fix(fix)
            }
        };
        Some(Matter { finding, spans })
    });
    matters.collect()
}

/// A property that rather belongs to the object above.
struct Slip {
    /// The fix that writes the ID of the object above.
    fix: Fix,
    /// Whether the object whose ID the property has gets such a property below, or has no use for one.
    is_sure: bool,
}

/// The records of a scene in order, and the properties that they give to each ID.
struct Blocks<'a> {
    analysis: &'a Analysis,
    records: Vec<&'a Record>,
    /// For each ID and each property that it is given: the first token of the last record that gives it.
    given: FxHashMap<(u32, Given), u32>,
}

/// A property that a record gives an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Given {
    Optics,
    Texture,
    Index,
}

fn given(record: &Record) -> Option<Given> {
    match (record.kind, record.ty().effect) {
        (RecordKind::RefractiveIndex, _) => Some(Given::Index),
        (_, Effect::DefinesOrChanges(Kind::Optics, _)) => Some(Given::Optics),
        (_, Effect::DefinesOrChanges(Kind::Texture | Kind::Colour, _)) => Some(Given::Texture),
        _ => None,
    }
}

impl<'a> Blocks<'a> {
    fn new(analysis: &'a Analysis) -> Self {
        let records: Vec<&Record> = records(analysis).collect();
        let mut all = FxHashMap::default();
        for record in &records {
            if let Some(given) = given(record) {
                all.insert((record.id, given), record.first);
            }
            // An assignment gives optics and texture.
            if record.kind == RecordKind::Assignment {
                all.insert((record.id, Given::Optics), record.first);
                all.insert((record.id, Given::Texture), record.first);
            }
        }
        Blocks {
            analysis,
            records,
            given: all,
        }
    }

    /// Finds the slip of a property above the definition of its object: the property stands alone, right below a record
    /// of another object, which has no such property. `None` if it is no slip.
    fn slip(&self, finding: &Diagnostic) -> Option<Slip> {
        let document = &self.analysis.document;
        let start = finding.labels.first()?.span.start;
        let first = (self.records).partition_point(|r| document.id_token(r).start < start);
        let property = *self.records.get(first)?;
        let above = *self.records.get(first.checked_sub(1)?)?;
        let next = *self.records.get(first + 1)?;
        let kind = given(property)?;
        let mut entities = self.analysis.scene.entities.iter();
        let is_object = entities.any(|e| e.id == above.id && e.kind == Some(Kind::Object));
        let is_alone = next.id != property.id || matches!(next.ty().effect, Effect::Defines(_));
        if !is_object || !is_alone || self.given.contains_key(&(above.id, kind)) {
            return None;
        }
        let span = document.id_token(property).span();
        let text = above.id.to_string();
        let number = quote(&text);
        let fix = Fix::guess("fix-write", vec![Edit { span, text }]).with("number", number);
        let defined = document
            .tokens
            .partition_point(|t| t.start < finding.span.start) as u32;
        let last = self.given.get(&(property.id, kind));
        let has_own = last.is_some_and(|&last| last > defined);
        // Only an object that lets light through has a use for a refractive index.
        let is_index = kind == Given::Index;
        let is_for_above = is_index && self.is_clear(above.id) && !self.is_clear(property.id);
        let is_sure = has_own || is_for_above;
        // A property right above the object whose ID it has rather belongs to that object.
        let is_right_above = next.id == property.id;
        (is_sure || !is_right_above).then_some(Slip { fix, is_sure })
    }

    /// Whether records give an ID optics that let light through.
    fn is_clear(&self, id: u32) -> bool {
        let mut own = self.records.iter().filter(|r| r.id == id);
        own.any(|r| {
            let values = self.analysis.document.values(r);
            let mut parts = r.ty().transmitted().filter_map(|i| values.get(i));
            parts.any(|kt| *kt > 0.0)
        })
    }
}
