//! Formatting: all of a file, some lines, or the line that was just ended.

use std::ops::RangeInclusive;

use imara_diff::{Algorithm, Diff, InternedInput};

use crate::analysis::Analysis;
use crate::diagnostics::{Edit, Span};
use crate::format::{self, Options};

/// What formats a scene, as few lines as possible.
pub fn whole(analysis: &Analysis, options: &Options) -> Vec<Edit> {
    let text = &analysis.source.text;
    let formatted = format::format(text, &analysis.document, options);
    edits(text, &formatted)
}

/// What formats the records that touch some lines, counted from 0.
pub fn lines(analysis: &Analysis, options: &Options, lines: RangeInclusive<usize>) -> Vec<Edit> {
    let lines = lines.start() + 1..=lines.end() + 1;
    let text = &analysis.source.text;
    let edit = format::format_range(text, &analysis.document, options, lines);
    edit.into_iter()
        .filter(|e| text.get(e.span.range()) != Some(&e.text))
        .collect()
}

/// What formats the line before the one that an offset is on, when a line has been ended.
pub fn on_line_break(analysis: &Analysis, options: &Options, offset: u32) -> Vec<Edit> {
    match analysis.source.line_index(offset).checked_sub(1) {
        Some(line) => lines(analysis, options, line..=line),
        None => Vec::new(),
    }
}

/// The edits, in whole lines, that make one text of another.
pub fn edits(before: &str, after: &str) -> Vec<Edit> {
    if before == after {
        return Vec::new();
    }
    let input = InternedInput::new(before, after);
    let diff = Diff::compute(Algorithm::Histogram, &input);
    let starts = |lines: &[imara_diff::Token]| -> Vec<u32> {
        let mut at = 0;
        let mut out = vec![0];
        for line in lines {
            at += input.interner[*line].len() as u32;
            out.push(at);
        }
        out
    };
    let (old, new) = (starts(&input.before), starts(&input.after));
    let edit = |hunk: imara_diff::Hunk| {
        let span = Span::new(
            old[hunk.before.start as usize],
            old[hunk.before.end as usize],
        );
        let text = new[hunk.after.start as usize] as usize..new[hunk.after.end as usize] as usize;
        Edit {
            span,
            text: after[text].to_owned(),
        }
    };
    diff.hunks().map(edit).collect()
}
