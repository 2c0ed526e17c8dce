//! Formatting: all of a file, some lines, or the line that was just ended.

use std::ops::RangeInclusive;

use imara_diff::{Hunk, InternedInput, Token};

use crate::analysis::Analysis;
use crate::diagnostics::{Edit, Span};
use crate::format::{self, Options, difference};

/// The edits that format a scene. They touch as few lines as possible.
pub fn whole(analysis: &Analysis, options: &Options) -> Vec<Edit> {
    let text = &analysis.source.text;
    let formatted = format::format(text, &analysis.document, options);
    edits(text, &formatted)
}

/// The edits that format the records that touch some lines, counted from 0.
pub fn lines(analysis: &Analysis, options: &Options, lines: RangeInclusive<usize>) -> Vec<Edit> {
    let lines = lines.start() + 1..=lines.end() + 1;
    let text = &analysis.source.text;
    let edit = format::format_range(text, &analysis.document, options, lines);
    edit.into_iter()
        .filter(|e| text.get(e.span.range()) != Some(&e.text))
        .collect()
}

/// The edits that format the line before the one that `offset` is on, after a line has been ended. Empty if a record
/// goes on across the line break: the new line is for the record's next numbers.
pub fn on_line_break(analysis: &Analysis, options: &Options, offset: u32) -> Vec<Edit> {
    let at = analysis.source.line_index(offset);
    let edits = match at.checked_sub(1) {
        Some(line) => lines(analysis, options, line..=line),
        None => Vec::new(),
    };
    let start = analysis.source.line_span(at).start;
    match edits.iter().all(|edit| edit.span.end <= start) {
        true => edits,
        false => Vec::new(),
    }
}

/// The edits, in whole lines, that turn `before` into `after`.
pub fn edits(before: &str, after: &str) -> Vec<Edit> {
    let input = InternedInput::new(before, after);
    let starts = |lines: &[Token]| -> Vec<u32> {
        let mut at = 0;
        let mut out = vec![0];
        for line in lines {
            at += input.interner[*line].len() as u32;
            out.push(at);
        }
        out
    };
    let (old, new) = (starts(&input.before), starts(&input.after));
    let hunks: Vec<Hunk> = match input.before.len() == input.after.len() {
        // If the number of lines is the same, each line stays at its place as a rule.
        true => runs(&input.before, &input.after),
        false => difference::of(&input).hunks().collect(),
    };
    let edit = |hunk: Hunk| {
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
    hunks.into_iter().map(edit).collect()
}

/// The runs of lines that differ from the line at the same place. Both texts have the same number of lines.
fn runs(before: &[Token], after: &[Token]) -> Vec<Hunk> {
    let mut out: Vec<Hunk> = Vec::new();
    for (i, _) in (0..)
        .zip(before.iter().zip(after))
        .filter(|(_, (a, b))| a != b)
    {
        match out.last_mut().filter(|hunk| hunk.before.end == i) {
            Some(hunk) => (hunk.before.end, hunk.after.end) = (i + 1, i + 1),
            None => out.push(Hunk {
                before: i..i + 1,
                after: i..i + 1,
            }),
        }
    }
    out
}
