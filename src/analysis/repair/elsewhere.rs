//! Slips that show on other lines: a record whose type takes up the numbers of the next lines, a shape whose ID is
//! lost, and a copy of something that is no object but is used as one.

use rustc_hash::FxHashSet;

use super::candidates::{Candidate, Habit, LineContext};
use super::whole::records;
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::scene::names;
use crate::syntax::Record;
use crate::syntax::table::{Family, Kind, RecordKind, RecordType};

/// A line that may be to blame for errors on other lines.
pub(super) struct Suspect {
    /// The finding about the line if it is to blame.
    pub finding: Diagnostic,
    pub candidates: Vec<Candidate>,
    /// The span that was misread because of the line; findings there are dropped.
    pub misread: Span,
    /// The fewest errors that a candidate has to repair.
    pub least: usize,
}

/// Most suspects of each kind that are tried.
const MAX_SUSPECTS: usize = 4;

/// The lines that may be to blame for errors on others.
pub(super) fn suspects(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Suspect> {
    let mut all: Vec<Suspect> = taking(analysis).take(MAX_SUSPECTS).collect();
    all.extend(without_ids(analysis, findings));
    all.extend(exchanged(analysis, findings).into_iter().take(MAX_SUSPECTS));
    all.extend(render_exchanged(analysis, findings));
    all.extend(exchanged_shapes(analysis, findings).take(MAX_SUSPECTS));
    all.extend(copies(analysis, findings).into_iter().take(MAX_SUSPECTS));
    all
}

/// Finds lines that are whole records of a sibling type, one that people take for the written type. As it is written,
/// the record goes on behind the line.
fn taking(analysis: &Analysis) -> impl Iterator<Item = Suspect> {
    let source = &analysis.source;
    let spans = records(analysis).map(|r| analysis.document.span(r.first, r.last));
    let line = move |at: u32| source.line_index(source.floor(at));
    spans
        .filter(move |span| line(span.start) != line(span.end))
        .filter_map(move |span| {
            let place = LineContext::both(analysis, span.start).into_iter().next()?;
            let mut candidates = Vec::new();
            place.siblings(&mut candidates);
            candidates.retain(|c| c.ty.is_some());
            let finding = place.wrong_count().filter(|_| !candidates.is_empty())?;
            Some(Suspect {
                finding,
                candidates,
                misread: place.line().to(source.line_span(line(span.end))),
                least: 1,
            })
        })
}

/// Finds shapes whose ID is lost: they read as changes of the entity whose ID is the number of their type. The lost ID
/// must be the only other undefined ID, or the only other ID that is used as a wrong kind.
fn without_ids(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Suspect> {
    let is_wrong = |d: &&Diagnostic| matches!(d.code, Code::E101 | Code::E103);
    let heads = findings.iter().filter(is_wrong).filter_map(|d| {
        let place = LineContext::both(analysis, d.span.start)
            .into_iter()
            .next()?;
        let is_head = d.span.start == place.line().start && super::named(d) == place.id();
        let ty = place.shape_without_id()?;
        (is_head && place.changes_nothing()).then_some((place, ty))
    });
    let suspect = |(place, ty): (LineContext, _)| {
        let own = place.id();
        let of = |code: Code| {
            let of_others = findings
                .iter()
                .filter(move |d| d.code == code && super::named(d) != own);
            of_others.filter_map(|d| Some((super::named(d)?, d.span)))
        };
        let mut others = of(Code::E101).peekable();
        let (id, used) = match others.peek() {
            Some(&first) => others.all(|o| o.0 == first.0).then_some(first)?,
            None => {
                let mut misused = of(Code::E103);
                let first = misused.next()?;
                misused.all(|o| o.0 == first.0).then_some(first)?
            }
        };
        let (mut finding, candidate) = place.without_id(ty, id)?;
        finding = finding.label(used, "lost-id-used-here");
        finding.notes.push("lost-id-may-be-this");
        Some(Suspect {
            finding,
            candidates: vec![candidate],
            misread: place.line(),
            least: 2,
        })
    };
    heads.take(MAX_SUSPECTS).filter_map(suspect).collect()
}

/// Finds lines with ID and type in each other's place, where the true ID is undefined elsewhere, or used as a wrong
/// kind.
fn exchanged(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Suspect> {
    let mut undefined = super::undefined(findings);
    let misused = findings.iter().filter(|d| d.code == Code::E103);
    undefined.extend(misused.filter_map(super::named));
    if undefined.is_empty() {
        return Vec::new();
    }
    let mut lines = FxHashSet::default();
    let mut out = Vec::new();
    for d in findings.iter().filter(|d| d.is_error()) {
        let place = LineContext::both(analysis, d.span.start).into_iter().next();
        let Some(place) = place.filter(|place| lines.insert(place.line().start)) else {
            continue;
        };
        let Some((finding, candidate)) = place.exchange() else {
            continue;
        };
        let id = candidate.fix.edits[0].text.parse();
        if id.is_ok_and(|id| undefined.contains(&id)) {
            out.push(Suspect {
                finding,
                candidates: vec![candidate],
                misread: place.line(),
                least: 2,
            });
        }
    }
    out
}

/// Finds a render record whose type stands behind the ID of the drawn object.
fn render_exchanged(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Suspect> {
    let suspect = |d: &Diagnostic| {
        let place = LineContext::both(analysis, d.span.start)
            .into_iter()
            .next()?;
        let (finding, candidate) = place.render_exchanged()?;
        Some(Suspect {
            finding,
            candidates: vec![candidate],
            misread: place.line(),
            least: 1,
        })
    };
    // The render record is mostly the last record.
    let errors = findings.iter().rev().filter(|d| d.is_error());
    errors.take(MAX_SUSPECTS).find_map(suspect)
}

/// Finds shapes that can be read with ID and type in either order, as `11 3 0 1 0 1`, where the number in the place of
/// the type is an ID that is used but undefined or of a wrong kind, and the written ID is used nowhere.
fn exchanged_shapes<'a>(
    analysis: &'a Analysis,
    findings: &[Diagnostic],
) -> impl Iterator<Item = Suspect> + use<'a> {
    let is_wrong = |d: &&Diagnostic| matches!(d.code, Code::E101 | Code::E103);
    let wanted: FxHashSet<u32> = (findings.iter().filter(is_wrong))
        .filter_map(super::named)
        .collect();
    let mut used: FxHashSet<u32> = FxHashSet::default();
    if !wanted.is_empty() {
        for record in records(analysis) {
            used.extend(names::references(&analysis.document, record));
            if record.ty().family != Family::Shape {
                used.insert(record.id);
            }
        }
    }
    let is_one = move |record: &&Record| {
        let ty = record.ty();
        let is_wanted = u32::try_from(ty.code).is_ok_and(|code| wanted.contains(&code));
        let other = RecordType::by_code(record.id.into());
        let is_either = other.is_some_and(|other| other.family == Family::Shape);
        ty.family == Family::Shape && is_wanted && is_either && !used.contains(&record.id)
    };
    let shapes = records(analysis).filter(is_one);
    shapes.filter_map(|record| {
        let head = analysis.document.id_token(record).start;
        let place = LineContext::both(analysis, head).into_iter().next()?;
        let (finding, candidate) = place.exchanged_heads()?;
        Some(Suspect {
            finding,
            candidates: vec![candidate],
            misread: place.line(),
            least: 1,
        })
    })
}

/// Finds copies of an entity that is no object, where at least two references to the copy ask for another kind.
fn copies(analysis: &Analysis, findings: &[Diagnostic]) -> Vec<Suspect> {
    let misused = findings.iter().filter(|d| d.code == Code::E103);
    let mut named: Vec<u32> = misused.filter_map(super::named).collect();
    named.sort_unstable();
    let twice = named.chunk_by(|a, b| a == b).filter(|c| c.len() > 1);
    let is_copy = |record: &&Record| record.kind == RecordKind::Copy;
    let copies = twice
        .filter_map(|c| analysis.definition(c[0]))
        .filter(is_copy);
    copies.filter_map(|record| copy(analysis, record)).collect()
}

fn copy(analysis: &Analysis, record: &Record) -> Option<Suspect> {
    let operand = analysis.document.params(record).next()?;
    let id = u32::try_from(operand.integer(&analysis.source.text)?).ok()?;
    let original = analysis.scene.entities.iter().find(|e| e.id == id)?;
    let finding = Diagnostic::new(Code::E103, operand.span())
        .with("id", id.to_string())
        .with("kind", Value::Term(original.kind?.name()))
        .with("kinds", Value::OneOf(vec![Kind::Object.name()]))
        .with("parameter", Value::Term(record.ty().params.first()?.doc))
        .label(original.span, "defined-here");
    let place = LineContext::both(analysis, operand.start)
        .into_iter()
        .next()?;
    let mut candidates = place.candidates(&finding, &[], &[]);
    candidates.retain(|c| matches!(c.habit, Habit::Shifted | Habit::Reference));
    Some(Suspect {
        finding,
        candidates,
        misread: operand.span(),
        least: 2,
    })
}
