//! Properties above the object that they are for.

use super::whole::Matter;
use crate::analysis::{Analysis, moving};
use crate::diagnostics::{Code, Diagnostic, Span};

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

/// The objects whose properties stand above them, each with the fix that moves all of these behind it. Where an ID is
/// used and defined nowhere, or is used as something else, the object may rather have another one.
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
    let matters = early.into_iter().zip(moved).filter_map(|(d, moved)| {
        let (fix, mut spans) = moved?;
        spans.push(d.span);
        Some(Matter {
            finding: d.clone().fix(fix),
            spans,
        })
    });
    matters.collect()
}
