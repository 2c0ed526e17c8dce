//! Comparison of a scene's findings before and after a fix: whether the scene checks worse.

use std::collections::BTreeMap;

use rustc_hash::{FxHashMap, FxHashSet};

use super::Analysis;
use crate::diagnostics::render::Tally;
use crate::diagnostics::{Code, Diagnostic, Severity};
use crate::lint;
use crate::scene::names::references;
use crate::syntax::Item;

/// How much there is to repair, as numbers that are compared in order: errors; malformed tokens among them, which hide
/// other faults of their records; warnings; notes; remarks on style; then the number of findings of each code, since
/// codes that come first hide those that follow.
pub(super) fn weight(analysis: &Analysis) -> Vec<usize> {
    weight_of(analysis.findings())
}

/// The weight of a scene after a fix. If the scene had no picture before and has one now, findings about pictures do
/// not count, since their causes were there before.
pub(super) fn weight_after(before: &Analysis, after: &Analysis) -> Vec<usize> {
    let is_first = before.scene.render.is_none() && after.scene.render.is_some();
    if !is_first {
        return weight(after);
    }
    let counted = |d: &&Diagnostic| !lint::is_of_pictures(d.code);
    let all: Vec<Diagnostic> = after.findings().iter().filter(counted).cloned().collect();
    weight_of(&all)
}

fn weight_of(findings: &[Diagnostic]) -> Vec<usize> {
    let counts = counts(findings.iter());
    let count = |code: &Code| counts.get(code).copied().unwrap_or(0);
    let malformed = [Code::E001, Code::E002, Code::E003, Code::E004, Code::E010];
    let mut tally = Tally::default();
    tally.add(findings);
    let mut weight = vec![tally.errors, malformed.iter().map(count).sum()];
    weight.extend([tally.warnings, tally.notes, tally.style]);
    weight.extend(Code::ALL.iter().map(count));
    weight
}

/// Whether a line that a fix left as it was has an error that it did not have before. On changed lines an error may
/// take the place of one that hid it. Two kinds of new errors do not count, since once all can be read they take the
/// place of others: an ID that is defined twice, on a line that names the ID of a record which could not be read; and
/// errors of the record that a surplus number 0 begins.
pub(super) fn has_new_errors(before: &Analysis, after: &Analysis) -> bool {
    let mut numbers: FxHashMap<&str, usize> = FxHashMap::default();
    let before_lines = lines(before).map(|line| {
        let next = numbers.len();
        Some(*numbers.entry(line).or_insert(next))
    });
    let before_lines: Vec<_> = before_lines.collect();
    let after_lines: Vec<_> = lines(after)
        .map(|line| numbers.get(line).copied())
        .collect();
    let old = errors(before, &before_lines);
    let new = errors(after, &after_lines);
    let is_more = |error: &(Code, usize)| new.get(error) > old.get(error);
    let is_in_place = |error: &(Code, usize)| {
        let surplus = (Code::E009, error.1);
        old.get(&surplus) > new.get(&surplus)
    };
    let all = new.keys().copied();
    let mut more = all
        .filter(|error| is_more(error) && !is_in_place(error))
        .peekable();
    if more.peek().is_none() {
        return false;
    }
    let hidden = unreadable_ids(before);
    let mut of_number = vec![0; numbers.len()];
    for (i, number) in before_lines.iter().enumerate() {
        of_number[number.unwrap_or_default()] = i;
    }
    more.any(|(code, line)| code != Code::E102 || !names(before, of_number[line], &hidden))
}

/// The IDs of records that cannot be read.
fn unreadable_ids(analysis: &Analysis) -> FxHashSet<u32> {
    let items = analysis.document.items.iter();
    let broken = items.filter_map(|item| match item {
        Item::Broken(broken) => broken.id,
        _ => None,
    });
    broken.collect()
}

/// Whether a record on a line has or names one of some IDs.
fn names(analysis: &Analysis, line: usize, ids: &FxHashSet<u32>) -> bool {
    let (source, document) = (&analysis.source, &analysis.document);
    let span = source.line_span(line);
    let start = |item: &Item| document.item_span(item).start;
    let first = document
        .items
        .partition_point(|item| start(item) < span.start);
    let on_line = document.items[first..].iter();
    let mut records = on_line
        .take_while(|item| start(item) < span.end)
        .filter_map(Item::record);
    records.any(|record| {
        let mut references = references(document, record);
        ids.contains(&record.id) || references.any(|id| ids.contains(&id))
    })
}

fn lines(analysis: &Analysis) -> impl Iterator<Item = &str> {
    let source = &analysis.source;
    (0..source.line_count()).map(|i| source.slice(source.line_span(i)).trim())
}

/// The number of errors for each code and each number of a line. `numbers` has the numbers by line; lines without one
/// are left out.
fn errors(analysis: &Analysis, numbers: &[Option<usize>]) -> FxHashMap<(Code, usize), usize> {
    let mut counts = FxHashMap::default();
    for d in analysis.findings().iter().filter(|d| d.is_error()) {
        let line = analysis.source.line_index(d.span.start);
        if let Some(line) = numbers.get(line).copied().flatten() {
            *counts.entry((d.code, line)).or_default() += 1;
        }
    }
    counts
}

/// Whether the errors are the same after a fix, and the warnings of some code are more.
pub(super) fn harms(before: &Analysis, after: &Analysis) -> bool {
    let of = |severity: Severity| {
        [before, after].map(|analysis| {
            let all = analysis.findings().iter();
            counts(all.filter(|d| d.severity == severity))
        })
    };
    let [errors, errors_left] = of(Severity::Error);
    let [old, new] = of(Severity::Warning);
    let more = |(code, count): (&Code, &usize)| old.get(code).is_none_or(|old| count > old);
    errors == errors_left && new.iter().any(more)
}

/// The number of findings for each code.
pub(super) fn counts<'a>(all: impl Iterator<Item = &'a Diagnostic>) -> BTreeMap<Code, usize> {
    let mut counts = BTreeMap::new();
    all.for_each(|d| *counts.entry(d.code).or_default() += 1);
    counts
}
