//! Numbers with a leading zero that lack their decimal point, and so explain other findings on their record: with the
//! point, those findings are gone.

use super::{Engine, judge};
use crate::analysis::Analysis;
use crate::diagnostics::wording::EXPLAINED;
use crate::diagnostics::{Applicability, Code, Diagnostic, Span};

/// The most numbers that are tried with a decimal point.
const MAX_TRIED: usize = 8;

/// Whether a finding says that a number with a leading zero explains it.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    d.notes.contains(&EXPLAINED)
}

impl Engine<'_> {
    /// Tries a decimal point in numbers with a leading zero. A finding that is gone with the point loses its own fixes
    /// and names the number.
    pub(super) fn leading_zeros(&mut self) {
        let zeros = |d: &&Diagnostic| d.code == Code::S505 && d.fixes.len() == 1;
        let zeros: Vec<Diagnostic> = (self.findings.iter().filter(zeros))
            .take(MAX_TRIED)
            .cloned()
            .collect();
        for zero in zeros {
            let Some(record) = record(self.analysis, zero.span) else {
                continue;
            };
            let explained = |d: &Diagnostic| {
                let is_here = |span: Span| record.touches(span);
                let edits = d.fixes.iter().flat_map(|f| &f.edits);
                let here = is_here(d.span) || d.labels.iter().any(|l| is_here(l.span));
                !matches!(d.code, Code::S505)
                    && !d.is_error()
                    && (here || edits.map(|e| e.span).any(is_here))
            };
            if !self.findings.iter().any(explained) {
                continue;
            }
            let Some(scene) = self.attempt(zero.fixes.first(), &[]) else {
                return;
            };
            if judge::errors(&scene) > judge::errors(self.analysis) {
                continue;
            }
            // The fix edits a single line, so all lines keep their numbers.
            let line =
                |a: &Analysis, d: &Diagnostic| a.source.line_index(a.source.floor(d.span.start));
            let left: Vec<(Code, usize)> = (scene.findings().iter())
                .map(|d| (d.code, line(&scene, d)))
                .collect();
            let mut is_any = false;
            for d in self.findings.iter_mut().filter(|d| explained(d)) {
                if left.contains(&(d.code, line(self.analysis, d))) || is_told(d) {
                    continue;
                }
                is_any = true;
                d.fixes.clear();
                d.notes.push(EXPLAINED);
                d.values
                    .extend(zero.values.iter().filter(|v| v.0 == "number").cloned());
            }
            if is_any
                && let Some(own) = self.findings.iter_mut().find(|d| **d == zero)
                && let Some(fix) = own.fixes.first_mut()
            {
                fix.applicability = Applicability::Unsafe;
            }
        }
    }
}

/// The span of the record that contains a place.
fn record(analysis: &Analysis, at: Span) -> Option<Span> {
    let item = analysis.document.item_at(at.start)?;
    Some(analysis.document.item_span(&analysis.document.items[item]))
}
