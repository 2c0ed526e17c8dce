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
    for (&line, all) in &mut lines {
        let text = &source.text[source.line_span(line).range()];
        let numbers = all.iter().map(|d| &source.text[d.span.range()]);
        if is_mixed(text, numbers) {
            let fixes = all.iter_mut().flat_map(|d| &mut d.fixes);
            fixes.for_each(|f| f.applicability = Applicability::Unsafe);
        }
    }
    findings.retain_mut(|d| {
        if !is_comma(d) || !lines.contains_key(&line(d)) {
            return true;
        }
        let Some(all) = lines.get_mut(&line(d)).filter(|all| !all.is_empty()) else {
            return false;
        };
        *d = match all.len() {
            1 => all.swap_remove(0),
            _ => joined(std::mem::take(all)),
        };
        true
    });
}

/// Whether a line has semicolons, and commas between digits besides those of `numbers`, which have decimal commas. Its
/// commas may separate numbers and its semicolons points, or the other way round.
fn is_mixed<'a>(line: &str, numbers: impl Iterator<Item = &'a str>) -> bool {
    let record = line.split('#').next().unwrap_or_default();
    let commas = |text: &str| {
        let three = text.as_bytes().windows(3);
        let is_comma = |w: &&[u8]| w[1] == b',' && w[0].is_ascii_digit() && w[2].is_ascii_digit();
        three.filter(is_comma).count()
    };
    record.contains(';') && commas(record) > numbers.map(commas).sum()
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
