//! Undefined IDs whose definition stands in a comment: no other ID was meant.

use rustc_hash::FxHashMap;

use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic};
use crate::syntax::hidden;
use crate::syntax::table::Effect;

const CASE: &str = "hidden";

/// Whether a finding says that a comment defines the ID which it calls undefined.
pub(super) fn is_told(d: &Diagnostic) -> bool {
    d.code == Code::E101 && d.case == CASE
}

/// Adds to findings about undefined IDs the line of the comment that defines them, and drops proposals of other IDs.
pub(super) fn retell(analysis: &Analysis, findings: &mut [Diagnostic]) {
    let mut undefined = (findings.iter_mut())
        .filter(|d| d.code == Code::E101 && d.case.is_empty())
        .peekable();
    if undefined.peek().is_none() {
        return;
    }
    let source = &analysis.source;
    let mut lines: FxHashMap<u32, usize> = FxHashMap::default();
    for (comment, records) in hidden::records(&source.text, &analysis.document) {
        let line = source.position(comment.start).line;
        let defining = |r: &&hidden::Hidden| !matches!(r.ty.effect, Effect::Changes(_));
        for record in records.iter().filter(defining) {
            lines.entry(record.id).or_insert(line as usize);
        }
    }
    for d in undefined {
        if let Some(line) = super::named(d).and_then(|id| lines.get(&id)) {
            d.case = CASE;
            d.fixes.clear();
            d.values.push(("line", line.to_string().into()));
        }
    }
}
