//! Commenting records out and in, whole lines at a time.
//!
//! If a record or a comment spans several lines, they are commented out together, and come back together. Commenting
//! lines out and in gives the text as it was.

use std::ops::RangeInclusive;

use memchr::memchr2_iter;

use crate::analysis::Analysis;
use crate::diagnostics::{Edit, SourceFile, Span, fixes};
use crate::syntax::commented_out::{self, CommentedOut, END, SIGN, TILDE};

/// The direction that a user asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// In if all lines are commented out, else out.
    Toggle,
    Out,
    In,
}

/// The most lines of which each sign gets an edit of its own. Single edits keep the cursor at its place, but cost
/// time, so more lines are replaced as a whole.
const LINES_WITH_EDITS_OF_THEIR_OWN: usize = 1000;

/// The edits that comment out or in the lines that some selections touch, all in one direction.
pub fn edits(analysis: &Analysis, selections: &[Span], mode: Mode) -> Vec<Edit> {
    let lines = Lines::of(analysis);
    let coming_in = lines.touched(selections, &|line| lines.goes_on(line));
    let mode = match mode {
        Mode::Toggle if lines.all_are_out(&coming_in) => Mode::In,
        Mode::Toggle => Mode::Out,
        asked => asked,
    };
    if mode == Mode::In {
        let all = coming_in.into_iter().flatten();
        return lines.gathered(all, |line| lines.comes_in(line));
    }
    // A line that is commented out is no part of a record, even where recovery takes it for one.
    let is_out = |line| lines.commented_out(line).is_some();
    let hangs = |line: usize| {
        let is_spanned = lines.spanned[line] && !is_out(line) && !(line > 0 && is_out(line - 1));
        is_spanned || lines.goes_on(line)
    };
    let going_out = lines.touched(selections, &hangs);
    // A blank line between records stays blank.
    let has_to = |line: &usize| {
        !lines.is_blank(*line) || hangs(*line) || *line + 1 < lines.count() && hangs(*line + 1)
    };
    let all = going_out.into_iter().flatten().filter(has_to);
    lines.gathered(all, |line| lines.goes_out(line, hangs(line)))
}

/// The direction in which [`Mode::Toggle`] comments the lines of a selection; `None` if all of them are blank.
pub fn direction(analysis: &Analysis, selection: Span) -> Option<Mode> {
    let lines = Lines::of(analysis);
    let touched = lines.touched(&[selection], &|line| lines.goes_on(line));
    let is_blank = touched.iter().cloned().flatten().all(|l| lines.is_blank(l));
    match lines.all_are_out(&touched) {
        true => Some(Mode::In),
        false => (!is_blank).then_some(Mode::Out),
    }
}

struct Lines<'a> {
    source: &'a SourceFile,
    /// For each line, whether a record or a comment that began on an earlier line goes on.
    spanned: Vec<bool>,
}

impl<'a> Lines<'a> {
    fn of(analysis: &'a Analysis) -> Lines<'a> {
        let (document, source) = (&analysis.document, &analysis.source);
        let mut spanned = vec![false; source.line_count()];
        let items = document.items.iter().map(|i| document.item_span(i));
        let comments = document.comments().map(|t| t.span());
        for span in items.chain(comments) {
            let last = source.line_index(span.end);
            spanned[source.line_index(span.start)..=last]
                .iter_mut()
                .skip(1)
                .for_each(|s| *s = true);
        }
        Lines { source, spanned }
    }

    fn count(&self) -> usize {
        self.spanned.len()
    }

    /// A line without its line break and the file's byte order mark.
    fn span(&self, line: usize) -> Span {
        let span = self.source.line_span(line);
        let has_mark = self.source.slice(span).starts_with('\u{feff}');
        Span::new(span.start + 3 * u32::from(has_mark), span.end)
    }

    fn text(&self, line: usize) -> &'a str {
        self.source.slice(self.span(line))
    }

    fn is_blank(&self, line: usize) -> bool {
        self.text(line).trim_ascii().is_empty()
    }

    fn commented_out(&self, line: usize) -> Option<CommentedOut> {
        commented_out::read(self.text(line))
    }

    fn goes_on(&self, line: usize) -> bool {
        self.commented_out(line).is_some_and(|c| c.goes_on)
    }

    /// The lines that some selections touch, as ranges in order, none twice. Each range is extended by the lines that
    /// hang together with it. `hangs` tells whether a line belongs to the line before it.
    fn touched(
        &self,
        selections: &[Span],
        hangs: &dyn Fn(usize) -> bool,
    ) -> Vec<RangeInclusive<usize>> {
        let mut all: Vec<(usize, usize)> = selections.iter().map(|s| self.selected(*s)).collect();
        all.sort_unstable();
        let mut out: Vec<RangeInclusive<usize>> = Vec::new();
        for (mut first, mut last) in all {
            if out.last().is_some_and(|before| last <= *before.end()) {
                continue;
            }
            while first > 0 && hangs(first) {
                first -= 1;
            }
            while last + 1 < self.count() && hangs(last + 1) {
                last += 1;
            }
            match out.last_mut().filter(|before| first <= *before.end()) {
                Some(before) => *before = *before.start()..=last,
                None => out.push(first..=last),
            }
        }
        out
    }

    /// The first and last line of a selection. A selection that ends at the start of a line does not touch that line.
    fn selected(&self, selection: Span) -> (usize, usize) {
        let first = self.source.line_index(selection.start);
        let last = self.source.line_index(selection.end);
        let ends_before = last > first && self.source.line_span(last).start == selection.end;
        (first, last - usize::from(ends_before))
    }

    /// Whether every line is commented out or blank, and at least one is not blank.
    fn all_are_out(&self, lines: &[RangeInclusive<usize>]) -> bool {
        let mut written = (lines.iter().cloned().flatten())
            .filter(|line| !self.is_blank(*line))
            .map(|line| self.commented_out(line).is_some())
            .peekable();
        written.peek().is_some() && written.all(|is_out| is_out)
    }

    fn goes_out(&self, line: usize, goes_on: bool) -> Vec<Edit> {
        let (span, text) = (self.span(line), self.text(line));
        let begin = commented_out::begin(goes_on);
        if text.is_empty() {
            let text = [begin, END].concat();
            return vec![Edit { span, text }];
        }
        let signs = memchr2_iter(b'#', b'~', text.as_bytes()).map(|at| {
            let coded = match text.as_bytes()[at] {
                b'#' => SIGN,
                _ => TILDE,
            };
            edit(span.start, at..at + 1, coded)
        });
        let begins = edit(span.start, 0..0, begin);
        let ends = edit(span.start, text.len()..text.len(), END);
        std::iter::once(begins).chain(signs).chain([ends]).collect()
    }

    fn comes_in(&self, line: usize) -> Vec<Edit> {
        let Some(CommentedOut { text: inside, .. }) = self.commented_out(line) else {
            return Vec::new();
        };
        let (start, text) = (self.span(line).start, self.text(line));
        let mut out = vec![edit(start, 0..inside.start, "")];
        let mut at = inside.start;
        while let Some(next) = memchr::memchr(b'~', &text.as_bytes()[at..inside.end]) {
            at += next;
            let plain = match &text[at..inside.end] {
                coded if coded.starts_with(SIGN) => "#",
                coded if coded.starts_with(TILDE) => "~",
                // This sign was written by hand, so it stays.
                _ => {
                    at += 1;
                    continue;
                }
            };
            out.push(edit(start, at..at + 2, plain));
            at += 2;
        }
        out.push(edit(start, inside.end..text.len(), ""));
        out
    }

    /// The edits of all lines; a single edit if there are too many lines.
    fn gathered(
        &self,
        lines: impl Iterator<Item = usize>,
        edits: impl Fn(usize) -> Vec<Edit>,
    ) -> Vec<Edit> {
        let lines: Vec<usize> = lines.collect();
        let all: Vec<Edit> = lines.iter().flat_map(|line| edits(*line)).collect();
        let (Some(first), Some(last)) = (lines.first(), lines.last()) else {
            return all;
        };
        if lines.len() <= LINES_WITH_EDITS_OF_THEIR_OWN {
            return all;
        }
        let span = self.span(*first).to(self.span(*last));
        let moved = all.into_iter().map(|e| Edit {
            span: Span::new(e.span.start - span.start, e.span.end - span.start),
            ..e
        });
        let text = fixes::edited(self.source.slice(span), &moved.collect::<Vec<_>>());
        vec![Edit { span, text }]
    }
}

/// An edit of some bytes of a line that starts at an offset.
fn edit(start: u32, bytes: std::ops::Range<usize>, text: &str) -> Edit {
    Edit {
        span: Span::new(start + bytes.start as u32, start + bytes.end as u32),
        text: text.to_owned(),
    }
}
