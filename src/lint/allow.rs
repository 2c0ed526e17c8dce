//! Comments that allow findings: `# zpg: allow(W307, colour-out-of-range) as it is meant #`.
//!
//! The entries between the brackets are codes, names and groups, as in `zpg.toml`. A comment on a record's line, or
//! alone on the line above, covers the record. At the head of the file, before any record, a comment covers the file.
//! `allow-next(…)` covers the record below it, also at the head. Findings that a comment allows are not reported. An
//! entry that allows nothing is S504.

use std::collections::BTreeMap;

use super::Context;
use super::levels::Selector;
use crate::diagnostics::{self, Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::syntax::Item;
use crate::syntax::directive::{Allow, is_directive};
use crate::syntax::lexer::{Token, TokenKind};

/// The indices of the tokens that are comments for zpg.
pub(super) fn comments(context: &Context) -> Vec<u32> {
    let tokens = match context.document.contents.directives {
        true => context.document.tokens.as_slice(),
        false => &[],
    };
    let is_one = |t: &Token| t.kind() == TokenKind::Comment && is_directive(t, context.text);
    let ones = (0..).zip(tokens).filter(|(_, t)| is_one(t));
    ones.map(|(i, _)| i).collect()
}

/// Removes the findings that these comments allow, and adds findings about what is wrong with the comments. Sorts the
/// findings, if there are any comments.
pub(super) fn apply(context: &Context, comments: &[u32], out: &mut Vec<Diagnostic>) {
    if comments.is_empty() {
        return;
    }
    diagnostics::sort(out);
    let mut layout = Layout::new(context);
    let mut found = FindingsByCode::new(out);
    let mut remarks = Vec::new();
    for &at in comments {
        let directive = Directive::new(&mut layout, at as usize);
        remarks.extend(directive.apply(&mut found));
    }
    let mut allowed = found.allowed(out.len()).into_iter();
    out.retain(|_| !allowed.next().unwrap_or(false));
    out.append(&mut remarks);
    diagnostics::sort(out);
}

/// The findings by their codes. Each finding is examined once, however many comments there are and however much they
/// cover.
struct FindingsByCode {
    codes: BTreeMap<Code, OfCode>,
    /// Whether there is an error. The error may leave out of the scene what a comment is to allow, so a comment that
    /// allows nothing may still be needed.
    is_wrong: bool,
}

/// Findings of one code, in their order.
#[derive(Default)]
struct OfCode {
    /// The starts of the spans.
    starts: Vec<u32>,
    /// Indices of the findings among all.
    indices: Vec<u32>,
    /// For each finding how many more comments allow it than the finding before it; one more entry at the end.
    steps: Vec<i32>,
}

impl FindingsByCode {
    /// Sorts findings by their codes.
    fn new(all: &[Diagnostic]) -> FindingsByCode {
        let mut codes: BTreeMap<Code, OfCode> = BTreeMap::new();
        let may_be_allowed = |d: &&Diagnostic| !d.code.is_never_allowed();
        for (i, d) in all.iter().enumerate().filter(|(_, d)| may_be_allowed(d)) {
            let of = codes.entry(d.code).or_default();
            of.starts.push(d.span.start);
            of.indices.push(i as u32);
        }
        for of in codes.values_mut() {
            of.steps = vec![0; of.starts.len() + 1];
        }
        let is_wrong = all.iter().any(|d| d.is_error() || d.code == Code::E106);
        FindingsByCode { codes, is_wrong }
    }

    /// Allows the findings of some codes that begin in a stretch of text, its end included. Returns whether there are
    /// any.
    fn allow(&mut self, codes: &Selector, covers: Span) -> bool {
        let mut any = false;
        for (_, of) in self
            .codes
            .iter_mut()
            .filter(|(code, _)| codes.holds(**code))
        {
            let first = of.starts.partition_point(|&s| s < covers.start);
            let last = of.starts.partition_point(|&s| s <= covers.end);
            if first < last {
                of.steps[first] += 1;
                of.steps[last] -= 1;
                any = true;
            }
        }
        any
    }

    /// For each finding whether it is allowed.
    fn allowed(&self, count: usize) -> Vec<bool> {
        let mut out = vec![false; count];
        for of in self.codes.values() {
            let mut depth = 0;
            for (&i, step) in of.indices.iter().zip(&of.steps) {
                depth += step;
                out[i as usize] = depth > 0;
            }
        }
        out
    }
}

/// A comment that allows findings.
struct Directive {
    comment: Span,
    /// The span that a fix removes together with the comment: the spaces in front of it, or its whole line if no record
    /// is on it.
    removal: Span,
    /// The text that takes the comment's place: a space if the comment stands between two words, which must not become
    /// one.
    gap: &'static str,
    /// The entries between the brackets, and their span; `None` if the comment is no `allow(…)`.
    entries: Option<(Vec<String>, Span)>,
    /// The span in which the findings begin that the comment may allow; `None` if the comment covers nothing.
    covers: Option<Span>,
}

impl Directive {
    /// Reads the comment whose token has the index `at`.
    fn new(layout: &mut Layout, at: usize) -> Directive {
        let (text, tokens) = (layout.context.text, &layout.context.document.tokens);
        let token = &tokens[at];
        let line = layout.line_at(at);
        let own = layout.records_on(line.span);
        let alone = own.is_none();
        let allow = Allow::read(token, text);
        let covers = if allow.as_ref().is_some_and(|allow| allow.is_about_next) {
            layout.below(line.end)
        } else if own.is_some() {
            own
        } else if layout.none_before(line.span.start) {
            Some(Span::new(0, text.len() as u32))
        } else {
            layout.below(line.end)
        };
        let entries = allow.map(|allow| {
            let all = allow.entries.into_iter().map(str::to_owned).collect();
            (all, allow.list)
        });
        Directive {
            comment: token.span(),
            removal: match alone {
                true => line.whole,
                false => {
                    let before = &text[..token.start as usize];
                    let kept = before.trim_end_matches([' ', '\t']).len();
                    Span::new(kept as u32, token.end())
                }
            },
            gap: match text[token.end() as usize..].chars().next() {
                Some(next) if !alone && !next.is_whitespace() => " ",
                _ => "",
            },
            entries,
            covers,
        }
    }

    /// Allows the findings that the entries name. Returns remarks on entries that allow nothing or are not understood.
    fn apply(&self, found: &mut FindingsByCode) -> Vec<Diagnostic> {
        let new = |case| Diagnostic::new(Code::S504, self.comment).case(case);
        let Some((entries, list)) = &self.entries else {
            return vec![new("unknown")];
        };
        let (mut used, mut unused) = (Vec::new(), Vec::new());
        let (mut unknown, mut errors) = (Vec::new(), Vec::new());
        let mut own = false;
        for entry in entries.iter().filter(|e| !e.is_empty()) {
            let Ok(codes) = entry.parse::<Selector>() else {
                unknown.push(crate::syntax::quote(entry));
                continue;
            };
            if codes.only_errors() {
                errors.push(entry.as_str());
            } else if codes.is(Code::S504) {
                // The entry S504 may be there to allow this very remark.
                own = true;
                used.push(entry.as_str());
            } else if (self.covers).is_some_and(|covers| found.allow(&codes, covers))
                || found.is_wrong
            {
                used.push(entry);
            } else {
                unused.push(entry.as_str());
            }
        }
        let mut remarks = Vec::new();
        if entries.iter().any(String::is_empty) {
            remarks.push(new("empty"));
        }
        let count = |list: &[_]| Value::Count(list.len() as u64);
        if !unknown.is_empty() {
            let d = new("no-code").with("count", Value::Count(unknown.len() as u64));
            remarks.push(d.with("text", unknown.join(", ")));
        }
        if !errors.is_empty() {
            let d = new("error").with("count", count(&errors));
            remarks.push(d.with("code", errors.join(", ")));
        }
        if unused.is_empty() || own {
            return remarks;
        }
        let d = new("")
            .with("entries", unused.join(", "))
            .with("count", count(&unused));
        // No fix is offered until the entries that are not understood are mended.
        if !remarks.is_empty() {
            remarks.push(d);
            return remarks;
        }
        let (span, text) = match used.as_slice() {
            [] => (self.removal, self.gap.to_owned()),
            used => (*list, used.join(", ")),
        };
        vec![d.fix(Fix::replace("fix", Applicability::Safe, span, text))]
    }
}

/// Lines and records by their position. A file may be a single line, or nothing but such comments, so no search here
/// goes over the same text twice.
struct Layout<'a, 'c> {
    context: &'a Context<'c>,
    /// Indices of the tokens that end lines.
    breaks: Vec<u32>,
    /// Indices of the tokens that end blank lines.
    blanks: Vec<u32>,
    /// Indices of the items that are not void.
    records: Vec<u32>,
    /// The record that `below` found last, and the span of its lines.
    last: Option<(u32, Span)>,
}

/// A line of tokens.
struct Line {
    span: Span,
    /// The line with its line break.
    whole: Span,
    /// The index of the first token behind the line.
    end: usize,
}

impl<'a, 'c> Layout<'a, 'c> {
    fn new(context: &'a Context<'c>) -> Layout<'a, 'c> {
        let document = context.document;
        let (mut breaks, mut blanks) = (Vec::new(), Vec::new());
        let mut before = true;
        for (i, token) in document.tokens.iter().enumerate() {
            let is_break = token.kind() == TokenKind::Newline;
            if is_break {
                breaks.push(i as u32);
                if before {
                    blanks.push(i as u32);
                }
            }
            before = is_break;
        }
        let items = (0..).zip(&document.items);
        let records = items.filter(|(_, item)| !matches!(item, Item::Void { .. }));
        Layout {
            context,
            breaks,
            blanks,
            records: records.map(|(i, _)| i).collect(),
            last: None,
        }
    }

    /// The line of a token.
    fn line_at(&self, token: usize) -> Line {
        let tokens = &self.context.document.tokens;
        let next = self.breaks.partition_point(|&b| (b as usize) < token);
        let first = match next.checked_sub(1) {
            Some(before) => self.breaks[before] as usize + 1,
            None => 0,
        };
        let end = self.context.text.len() as u32;
        let (last, after, behind) = match self.breaks.get(next) {
            Some(&b) => {
                let t = &tokens[b as usize];
                (t.start, t.end(), b as usize + 1)
            }
            None => (end, end, tokens.len()),
        };
        let start = tokens[first].start;
        Line {
            span: Span::new(start, last),
            whole: Span::new(start, after),
            end: behind,
        }
    }

    fn span(&self, item: usize) -> Span {
        let document = self.context.document;
        document.item_span(&document.items[item])
    }

    fn record(&self, i: usize) -> Span {
        self.span(self.records[i] as usize)
    }

    /// Whether no record has a part in a line.
    fn is_alone(&self, line: Span) -> bool {
        let first = (self.records).partition_point(|&i| self.span(i as usize).end <= line.start);
        first == self.records.len() || self.record(first).start >= line.end
    }

    /// The span of a line together with all items that have a part in the line; `None` if none of these is a record.
    fn records_on(&self, line: Span) -> Option<Span> {
        if self.is_alone(line) {
            return None;
        }
        let items = &self.context.document.items;
        let span = |item: &Item| self.context.document.item_span(item);
        let first = items.partition_point(|i| span(i).end <= line.start);
        let behind = items.partition_point(|i| span(i).start < line.end);
        Some(line.to(self.span(first)).to(self.span(behind - 1)))
    }

    /// Whether no record begins before a place.
    fn none_before(&self, at: u32) -> bool {
        self.records.is_empty() || self.record(0).start >= at
    }

    /// The span of the record on the line that begins with a token, or on one of the next lines if nothing but comments
    /// stands in between, with the rest of the record's last line. `None` if there is none.
    fn below(&mut self, token: usize) -> Option<Span> {
        let document = self.context.document;
        let first = |i: u32| document.items[i as usize].ends().0 as usize;
        let next = self.records.partition_point(|&i| first(i) < token);
        let &record = self.records.get(next)?;
        // A blank line in between separates the comment from the record.
        let blank = self.blanks.partition_point(|&b| (b as usize) < token);
        if (self.blanks.get(blank)).is_some_and(|&b| (b as usize) < first(record)) {
            return None;
        }
        if let Some((_, lines)) = self.last.filter(|last| last.0 == record) {
            return Some(lines);
        }
        // The span includes all that stands behind the record on its last line.
        let span = self.span(record as usize);
        let rest = &self.context.text[span.end as usize..];
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let lines = Span::new(span.start, span.end + end as u32);
        self.last = Some((record, lines));
        Some(lines)
    }
}
