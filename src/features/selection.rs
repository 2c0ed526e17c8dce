//! Selecting outwards: a number, its vector, its record, its section, all.

use crate::analysis::Analysis;
use crate::diagnostics::Span;

use super::folding;
use super::token_at_offset::{Role, place_at};

/// The spans around an offset, the smallest first; each holds the one before it.
pub fn selection(analysis: &Analysis, offset: u32) -> Vec<Span> {
    let source = &analysis.source;
    let mut out: Vec<Span> = Vec::new();
    let mut add = |span: Span| {
        let holds = |last: &Span| span.start <= last.start && last.end <= span.end && span != *last;
        if out.last().is_none_or(holds) {
            out.push(span);
        }
    };
    if let Some(place) = place_at(analysis, offset) {
        add(place.token.span());
        if let Role::Param(i, _) = place.role {
            let (first, length) = group(place.record.ty(), i, place.record.count());
            let tokens = analysis
                .document
                .params(place.record)
                .skip(first)
                .take(length);
            let span = tokens.map(|t| t.span()).reduce(Span::to);
            add(span.unwrap_or(place.token.span()));
            let params = analysis.document.params(place.record).map(|t| t.span());
            add(params.reduce(Span::to).unwrap_or(place.token.span()));
        }
        add(super::entity::span(analysis, place.record));
    } else {
        let tokens = &analysis.document.tokens;
        let at = tokens.partition_point(|t| t.start <= offset);
        let token = at
            .checked_sub(1)
            .map(|i| tokens[i])
            .filter(|t| t.end() >= offset);
        add(token
            .filter(|t| t.kind().is_comment())
            .map_or(Span::new(offset, offset), |t| t.span()));
    }
    let line = source.line_index(offset);
    add(source.line_span(line));
    let headings = folding::headings(analysis);
    let next = headings.partition_point(|&h| h <= line);
    if let Some(first) = next.checked_sub(1).map(|i| headings[i]) {
        let last = headings.get(next).map_or(source.line_count(), |&n| n) - 1;
        add(source.line_span(first).to(source.line_span(last)));
    }
    add(Span::new(0, source.text.len() as u32));
    out
}

/// The vector that a parameter belongs to: the position of its first number, and the number of its numbers.
fn group(ty: &crate::syntax::table::RecordType, i: usize, count: usize) -> (usize, usize) {
    let mut start = 0;
    for &length in ty.vectors {
        if i < start + length {
            return (start, length);
        }
        start += length;
    }
    let mut start = ty.params.len();
    if i < start {
        return (0, start);
    }
    for group in ty.repeats {
        let length = group.len() * count;
        if i < start + length {
            let first = start + (i - start) / group.len() * group.len();
            return (first, group.len());
        }
        start += length;
    }
    (start, ty.optional.len())
}
