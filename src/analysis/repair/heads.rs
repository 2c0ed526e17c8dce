//! Records that seem to have lost their ID, since the ID is also the number of a type. Another number of the record is
//! wrong.

use super::candidates::LineContext;
use super::whole::{records, references};
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Span};
use crate::syntax::table::{Effect, Family, RecordKind};

/// A longer line is no shape with a comment.
const MAX_RECORD_BYTES: usize = 1000;

/// Whether a shape that an ID is put in front of has errors of its own, such as bounds in the wrong order.
fn is_wrong(analysis: &Analysis, line: Span, id: u32) -> bool {
    let source = &analysis.source;
    let record = &source.text[line.range()];
    if record.len() > MAX_RECORD_BYTES {
        return false;
    }
    let alone = Analysis::trial(source.with_text(format!("{id} {record}\n")));
    // That there is no scene is said behind it.
    let is_own = |span: Span| (span.start as usize) < record.len();
    let is_shape = records(&alone).any(|r| r.ty().family == Family::Shape);
    is_shape && alone.errors.iter().any(|&(_, span)| is_own(span))
}

/// Replaces the finding that a record has lost its ID, if other records use that ID: the new finding says which number
/// is wrong.
pub(super) fn retell(analysis: &Analysis, findings: &mut [Diagnostic]) {
    let is_lost = |d: &Diagnostic| d.code == Code::E005 && d.case == "lost";
    // The lost ID may be one of the undefined ones.
    let has_undefined = findings.iter().any(|d| d.code == Code::E101);
    for d in findings.iter_mut().filter(|d| is_lost(d)) {
        let places = LineContext::both(analysis, d.span.start);
        let Some((place, id)) = places.first().and_then(|p| Some((p, p.id()?))) else {
            continue;
        };
        let own = place.line();
        let is_named = |id: u32| {
            records(analysis).any(|r| {
                let span = analysis.document.span(r.first, r.last);
                let is_head = r.id == id && r.kind != RecordKind::Undefined;
                let mut named = references(analysis, r);
                !own.touches(span) && (is_head || named.any(|n| n.1 == i64::from(id)))
            })
        };
        let is_defined = |id: u32| {
            records(analysis).any(|r| r.id == id && matches!(r.ty().effect, Effect::Defines(_)))
        };
        if !is_named(id) {
            continue;
        }
        // The lost ID is known: it is the only undefined one, and the record as written is a change that is not
        // possible.
        let is_accounted = d.values.iter().any(|v| v.0 == "lost") && place.changes_nothing();
        let told = match has_undefined || is_accounted || is_defined(id) {
            true => None,
            false => place.one_off(),
        };
        let other = || is_wrong(analysis, own, id).then(|| place.wrong_count())?;
        if let Some(told) = told.or_else(|| place.odd_type()).or_else(other) {
            *d = told;
        }
    }
}
