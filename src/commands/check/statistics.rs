//! How often each code was found.

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;

use crate::diagnostics::render::{Tally, json};
use crate::diagnostics::{Code, Diagnostic};

/// For each code: how many findings, and how many of them can be fixed safely.
#[derive(Debug, Default)]
pub(super) struct Statistics(BTreeMap<Code, (usize, usize)>);

/// The report for programs.
#[derive(Serialize)]
struct Report<'a> {
    version: u32,
    /// The codes with their counts, the most frequent first.
    statistics: Vec<Row>,
    summary: &'a Tally,
}

#[derive(Serialize)]
struct Row {
    code: &'static str,
    name: &'static str,
    count: usize,
    fixable: usize,
}

impl Statistics {
    pub(super) fn new(diagnostics: &[Diagnostic]) -> Statistics {
        let mut counts = BTreeMap::new();
        for d in diagnostics {
            let (found, fixable) = counts.entry(d.code).or_insert((0, 0));
            *found += 1;
            *fixable += usize::from(d.applicable_fix(false).is_some());
        }
        Statistics(counts)
    }

    pub(super) fn sum<'a>(all: impl Iterator<Item = &'a Statistics>) -> Statistics {
        let mut sum = Statistics::default();
        for (&code, &(found, fixable)) in all.flat_map(|s| &s.0) {
            let entry = sum.0.entry(code).or_insert((0, 0));
            entry.0 += found;
            entry.1 += fixable;
        }
        sum
    }

    /// The codes, the most frequent first.
    fn rows(&self) -> Vec<(&Code, &(usize, usize))> {
        let mut rows: Vec<_> = self.0.iter().collect();
        rows.sort_by_key(|&(_, &(found, _))| std::cmp::Reverse(found));
        rows
    }

    /// Writes the counts as JSON, with the totals of the run.
    pub(super) fn write_json(&self, out: &mut dyn Write, total: &Tally) -> io::Result<()> {
        let row = |(code, &(count, fixable)): (&Code, &(usize, usize))| Row {
            code: code.as_str(),
            name: code.name(),
            count,
            fixable,
        };
        let report = Report {
            version: json::VERSION,
            statistics: self.rows().into_iter().map(row).collect(),
            summary: total,
        };
        serde_json::to_writer_pretty(&mut *out, &report)?;
        writeln!(out)
    }

    /// Writes a line for each code, the most frequent first: how many findings it has, and how many of them `--fix`
    /// mends.
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let rows = self.rows();
        let width = |n: Option<usize>| n.unwrap_or(0).to_string().len();
        let found = width(rows.iter().map(|r| r.1.0).max());
        for (code, (count, fixable)) in rows {
            write!(out, "{count:>found$}  {}  {}", code.as_str(), code.name())?;
            match fixable {
                0 => writeln!(out)?,
                n if n == count => writeln!(out, "  [--fix]")?,
                n => writeln!(out, "  [--fix: {n}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Analysis;

    #[test]
    fn the_most_frequent_come_first() {
        let of = |text: &str| Statistics::new(Analysis::new("a.zpg", text.into()).findings());
        let all = [of("2 9 0,5\n3 9\n"), of("2 9 0,5\n2 9 x\n1 9999 2 0\n")];
        let mut out = Vec::new();
        Statistics::sum(all.iter()).write(&mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(
            text.starts_with("2  E003  malformed-number  [--fix]\n"),
            "{text}"
        );
        assert!(text.contains("1  E012  unexpected-word\n"), "{text}");
    }
}
