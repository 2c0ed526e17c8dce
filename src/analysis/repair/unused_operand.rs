//! An operand that is defined below its record, while an unused object above may be meant.

use rustc_hash::FxHashMap;

use super::named;
use super::whole::{records, references};
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span};
use crate::syntax::quote;
use crate::syntax::table::{Family, Kind};

/// Proposes the only unused object above for an operand that is defined below. The proposal stands beside that of
/// moving the definition up, and neither is applied by itself. Another record must use what is defined below, too: else
/// that would be without use.
pub(super) fn add(analysis: &Analysis, findings: &mut [Diagnostic]) {
    let is_early = |d: &&mut Diagnostic| d.code == Code::E107 && d.case.is_empty();
    if !findings.iter_mut().any(|d| is_early(&d)) {
        return;
    }
    let document = &analysis.document;
    let mut uses: FxHashMap<i64, usize> = FxHashMap::default();
    let mut operations: FxHashMap<Span, u32> = FxHashMap::default();
    for record in records(analysis) {
        for (token, id) in references(analysis, record) {
            *uses.entry(id).or_default() += 1;
            if record.ty().family == Family::Operation {
                operations.insert(token.span(), document.id_token(record).start);
            }
        }
    }
    let entities = analysis.scene.entities.iter();
    let objects = entities.filter(|e| e.kind == Some(Kind::Object));
    let unused = objects.filter(|e| !uses.contains_key(&e.id.into()));
    let mut unused: Vec<(u32, u32)> = unused.map(|e| (e.span.start, e.id)).collect();
    unused.sort_unstable();
    for d in findings.iter_mut().filter(is_early) {
        let Some(&start) = operations.get(&d.span) else {
            continue;
        };
        let above = &unused[..unused.partition_point(|u| u.0 < start)];
        let is_shared = named(d).is_some_and(|id| uses.get(&id.into()).is_some_and(|&n| n > 1));
        let (&[(_, id)], true) = (above, is_shared && !d.fixes.is_empty()) else {
            continue;
        };
        let text = id.to_string();
        let fix = Fix::replace("fix-write", Applicability::Choice, d.span, text.clone());
        d.fixes.push(fix.with("number", quote(&text)));
        (d.fixes.iter_mut()).for_each(|f| f.applicability = Applicability::Choice);
        d.notes.push("choose");
    }
}
