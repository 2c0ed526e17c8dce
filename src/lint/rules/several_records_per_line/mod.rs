//! S503: more than one record on a line.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::format::Options;
use crate::lint::Context;
use crate::syntax::Item;
use crate::syntax::lexer::TokenKind;

/// The records of a line.
#[derive(Default)]
struct Line<'a> {
    /// The first of its records.
    first: Option<&'a Item>,
    /// The record before the others on the line, if it began on an earlier line.
    torn: Option<&'a Item>,
    /// The records that begin on the line, behind another record.
    more: Vec<&'a Item>,
    /// Whether some record on the line cannot be read.
    broken: bool,
}

/// Characters that S501 reports where somebody separates records by them.
const SEPARATORS: [char; 2] = [';', ','];

/// Whether a character may stand between two records of a line.
fn is_between(c: char) -> bool {
    [' ', '\t'].contains(&c) || SEPARATORS.contains(&c)
}

/// The indices of the first tokens of records that may be meant as the place of the lamp before them.
type Places = FxHashSet<u32>;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let document = context.document;
    let places = context.lamps_with_places().into_iter();
    let places: Places = places.map(|(_, place)| place.first).collect();
    let mut line = Line::default();
    for pair in document.items.windows(2) {
        let [before, item] = [&pair[0], &pair[1]];
        let between = before.ends().1 + 1..item.ends().0;
        if breaks(context, between.start, between.end) {
            report(context, &line, true, &places, out);
            line = Line::default();
            continue;
        }
        // A broken stretch has been reported, and its end is only a guess.
        if matches!(before, Item::Broken(_)) || matches!(item, Item::Broken(_)) {
            line.broken = true;
            continue;
        }
        if is_torn(context, before) {
            report(context, &line, false, &places, out);
            line = Line {
                first: Some(before),
                torn: Some(before),
                ..Line::default()
            };
        }
        line.first.get_or_insert(before);
        line.more.push(item);
    }
    report(context, &line, true, &places, out);
}

/// Whether one of the tokens from `first` to `end`, without the latter, ends a line.
fn breaks(context: &Context, first: u32, end: u32) -> bool {
    let tokens = &context.document.tokens[first as usize..end as usize];
    tokens.iter().any(|t| t.kind() == TokenKind::Newline)
}

fn is_torn(context: &Context, item: &Item) -> bool {
    let (first, last) = item.ends();
    breaks(context, first, last)
}

/// Reports a line with several records. If the line `ends` behind its last record, the fix joins the lines of that
/// record.
fn report(context: &Context, line: &Line, ends: bool, places: &Places, out: &mut Vec<Diagnostic>) {
    let Some(first) = line.more.first() else {
        return;
    };
    // Another finding, an error, reports a record that is rather surplus numbers of the record before.
    let is_surplus = |item: &&Item| context.document.is_redefining(item.ends().0);
    if line.more.iter().any(is_surplus) {
        return;
    }
    let text = context.text;
    let mut edits = line.torn.map_or(Vec::new(), |torn| joined(context, torn));
    edits.extend(line.more.iter().map(|item| {
        let start = context.document.item_span(item).start;
        let before = &text[..start as usize];
        let blank = before.trim_end_matches(is_between).len() as u32;
        Edit {
            span: Span::new(blank, start),
            text: "\n".to_owned(),
        }
    }));
    // If another record follows the last one, the report of that record's line joins the last one.
    if let Some(last) = line.more.last().filter(|_| ends) {
        edits.extend(joined(context, last));
        let end = context.document.item_span(last).end;
        let behind = &text[end as usize..];
        let separators = behind.len() - behind.trim_start_matches(is_between).len();
        if behind[..separators].contains(SEPARATORS) {
            edits.push(Edit {
                span: Span::new(end, end + separators as u32),
                text: String::new(),
            });
        }
    }
    let fix = Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Safe,
        edits,
    };
    let finding = Diagnostic::new(Code::S503, context.document.item_span(first))
        .with("count", Value::Count(line.more.len() as u64));
    // Text that cannot be read is understood by its lines: cut otherwise, it may become something else. So beside it, a
    // line is cut only if it holds whole records and nothing else. A record that may have taken another one's numbers
    // must not look as if all were well. A lamp whose place may have been read as a shape must not stay at the origin.
    // A 0 behind a record may be a number too many of it.
    let has_zero = line
        .more
        .iter()
        .any(|item| matches!(item, Item::Void { .. }));
    let is_doubted =
        |item: &Item| context.document.is_doubted(item.ends().0) || places.contains(&item.ends().0);
    let mut items = line.first.into_iter().chain(line.more.iter().copied());
    let is_whole = line.torn.is_none() && !line.more.last().is_some_and(|l| is_torn(context, l));
    let is_sure = !context.document.contents.broken || is_whole && !line.broken;
    let without_zero = without_zero(context, line).filter(|_| is_sure);
    out.push(match is_sure && !has_zero && !items.any(is_doubted) {
        true => finding.fix(fix),
        false => without_zero.into_iter().fold(finding, Diagnostic::fix),
    });
}

/// The fix that removes a lone 0 behind the only record of a line. Nothing else of the scene changes.
fn without_zero(context: &Context, line: &Line) -> Option<Fix> {
    let [zero @ Item::Void { .. }] = line.more[..] else {
        return None;
    };
    let own = context.document.item_span(zero);
    // Such a 0 may introduce the comment behind it.
    let has_comment = context.text[own.range()].contains('#');
    let before = &context.text[..own.start as usize];
    let start = before.trim_end_matches([' ', '\t']).len() as u32;
    let fix = Fix::replace(
        "fix-zero",
        Applicability::Choice,
        Span::new(start, own.end),
        "",
    );
    (!has_comment && line.torn.is_none()).then_some(fix)
}

/// The edits that join the lines of a record into one; none if the record has comments or is too long for a line.
fn joined(context: &Context, item: &Item) -> Vec<Edit> {
    let (first, last) = item.ends();
    let tokens = &context.document.tokens[first as usize..=last as usize];
    if tokens.iter().any(|t| t.kind().is_comment()) {
        return Vec::new();
    }
    let words = tokens.iter().filter(|t| t.kind() != TokenKind::Newline);
    let words: Vec<Span> = words.map(|t| t.span()).collect();
    let length: usize = words.iter().map(|w| 1 + (w.end - w.start) as usize).sum();
    if length > Options::default().width {
        return Vec::new();
    }
    let gaps = words.windows(2).map(|w| Span::new(w[0].end, w[1].start));
    gaps.filter(|gap| context.text[gap.start as usize..gap.end as usize].contains(['\n', '\r']))
        .map(|span| Edit {
            span,
            text: " ".to_owned(),
        })
        .collect()
}
