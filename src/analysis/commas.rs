//! Joining of the findings about the decimal commas of one line into one finding with one fix.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Applicability, Code, Diagnostic, SourceFile, Value};

/// Joins the findings about decimal commas on each line into the first of them.
pub(super) fn join(source: &SourceFile, findings: &mut Vec<Diagnostic>) {
    let is_comma = |d: &Diagnostic| d.code == Code::E003 && d.case == "decimal-comma";
    let line = |d: &Diagnostic| source.line_index(d.span.start);
    let mut lines: FxHashMap<usize, Vec<Diagnostic>> = FxHashMap::default();
    for d in findings.iter().filter(|d| is_comma(d)) {
        lines.entry(line(d)).or_default().push(d.clone());
    }
    lines.retain(|_, all| all.len() > 1);
    if lines.is_empty() {
        return;
    }
    findings.retain_mut(|d| {
        if !is_comma(d) || !lines.contains_key(&line(d)) {
            return true;
        }
        let Some(all) = lines.get_mut(&line(d)).filter(|all| !all.is_empty()) else {
            return false;
        };
        *d = joined(std::mem::take(all));
        true
    });
}

/// Joins several findings on a line into one.
fn joined(mut all: Vec<Diagnostic>) -> Diagnostic {
    all.sort_by_key(|d| d.span.start);
    let count = Value::Count(all.len() as u64);
    let is_safe = |d: &Diagnostic| d.applicable_fix(false).is_some();
    let applicability = match all.iter().all(is_safe) {
        true => Applicability::Safe,
        false => Applicability::Unsafe,
    };
    let edits = all
        .iter()
        .filter_map(|d| d.fixes.first())
        .flat_map(|f| &f.edits);
    let edits: Vec<_> = edits.cloned().collect();
    let mut first = all.swap_remove(0);
    if let Some(fix) = first.fixes.first_mut() {
        (fix.edits, fix.applicability) = (edits, applicability);
    }
    first.case("decimal-commas").with("count", count)
}
