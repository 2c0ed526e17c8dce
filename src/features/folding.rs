//! Folding: sections under `0 # … #`, long comments, records of several lines.

use crate::analysis::Analysis;
use crate::syntax::Item;
use crate::syntax::commented_out::is_commented_out;
use crate::syntax::lexer::TokenKind;

/// Lines that can be folded, from 0, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fold {
    pub first: usize,
    pub last: usize,
    pub kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Section,
    Comment,
    Record,
}

/// The lines on which sections begin.
pub fn headings(analysis: &Analysis) -> Vec<usize> {
    let tokens = &analysis.document.tokens;
    let line = |token: usize| analysis.source.line_index(tokens[token].start);
    heading_tokens(analysis).into_iter().map(line).collect()
}

/// The indices of the tokens with which sections begin. Each is a lone `0` that is first on its line and has a
/// comment as the next token. A record that is commented out begins no section.
pub fn heading_tokens(analysis: &Analysis) -> Vec<usize> {
    let document = &analysis.document;
    let mut out = Vec::new();
    for item in &document.items {
        let Item::Void { token } = *item else {
            continue;
        };
        let at = token as usize;
        let introduces = document.tokens.get(at + 1).is_some_and(|t| {
            t.kind().is_comment() && !is_commented_out(t.text(&analysis.source.text))
        });
        let first = at.checked_sub(1).map(|i| document.tokens[i].kind());
        let is_first = matches!(
            first,
            None | Some(TokenKind::Newline | TokenKind::ByteOrderMark)
        );
        if introduces && is_first {
            out.push(at);
        }
    }
    out
}

/// All folds of a text, in order of the first line.
pub fn folds(analysis: &Analysis) -> Vec<Fold> {
    let (document, source) = (&analysis.document, &analysis.source);
    let mut out = Vec::new();
    let mut add = |first: usize, last: usize, kind| {
        if first < last {
            out.push(Fold { first, last, kind });
        }
    };
    let headings = headings(analysis);
    for (i, &first) in headings.iter().enumerate() {
        // A section ends before the next heading, or at the end of the file.
        let Some(next) = headings[i + 1..].iter().find(|&&n| n > first) else {
            add(
                first,
                last_line(analysis, source.line_count()),
                Kind::Section,
            );
            continue;
        };
        add(first, last_line(analysis, *next), Kind::Section);
    }
    for token in document.comments() {
        let last = source.line_index(token.end());
        add(source.line_index(token.start), last, Kind::Comment);
    }
    for item in &document.items {
        let span = document.item_span(item);
        let last = source.line_index(span.end);
        add(source.line_index(span.start), last, Kind::Record);
    }
    out.sort_by_key(|f| (f.first, f.last));
    out.dedup_by_key(|f| f.first);
    out
}

/// The last line before `before` that has text on it.
fn last_line(analysis: &Analysis, before: usize) -> usize {
    let source = &analysis.source;
    let is_blank = |line: &usize| source.slice(source.line_span(*line)).trim().is_empty();
    (0..before).rev().find(|line| !is_blank(line)).unwrap_or(0)
}
