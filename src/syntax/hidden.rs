//! Records that are lost in comments.

use super::commented_out::is_commented_out;
use super::lexer::TokenKind;
use super::table::{RecordKind, RecordType};
use super::{Document, Item};
use crate::diagnostics::Span;

/// How many bytes of comments are read as records, in all. Reading is linear, but slow where the layout
/// must testify, as in prose.
const BYTES_MAX: usize = 1 << 18;

/// Tokens that would be a record without the comment that they are in.
#[derive(Debug, Clone, Copy)]
pub struct Hidden {
    pub span: Span,
    pub ty: &'static RecordType,
    pub id: u32,
}

/// The comments over several lines that have records in them, and these.
pub fn records(text: &str, document: &Document) -> Vec<(Span, Vec<Hidden>)> {
    let mut out = Vec::new();
    if !document.contents.long_comments {
        return out;
    }
    let mut budget = BYTES_MAX;
    for t in &document.tokens {
        if t.kind() != TokenKind::Comment || t.length() < 2 {
            continue;
        }
        // Other editors may comment out several lines as one.
        if is_commented_out(t.text(text)) {
            continue;
        }
        let span = t.span();
        let inside = Span::new(span.start + 1, span.end - 1);
        if !text[inside.range()].contains('\n') {
            continue;
        }
        let mut hidden: Vec<Hidden> = Vec::new();
        for block in blocks(text, inside) {
            budget = match budget.checked_sub(block.range().len()) {
                Some(left) => left,
                None => return out,
            };
            read(text, block, &mut hidden);
        }
        if !hidden.is_empty() {
            out.push((span, hidden));
        }
    }
    out
}

/// The stretches of lines that begin with a number: prose is not worth reading.
fn blocks(text: &str, inside: Span) -> Vec<Span> {
    let mut blocks: Vec<Span> = Vec::new();
    let mut open = false;
    let mut at = inside.start;
    for line in text[inside.range()].split_inclusive('\n') {
        let end = at + line.len() as u32;
        let numeric = line
            .trim_start()
            .starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'));
        match blocks.last_mut() {
            Some(block) if open && numeric => block.end = end,
            _ if numeric => blocks.push(Span::new(at, end)),
            _ => {}
        }
        open = numeric;
        at = end;
    }
    blocks
}

/// The records of a block that fill their lines.
fn read(text: &str, block: Span, hidden: &mut Vec<Hidden>) {
    let text = &text[block.range()];
    let (document, _) = super::parse(text);
    let blank = |s: &str| s.trim_matches([' ', '\t', '\r']).is_empty();
    // Where the last record ended that fills its lines so far: others may follow on the line.
    let mut end_of_whole = 0;
    let mut waiting: Vec<Hidden> = Vec::new();
    for item in &document.items {
        let span = document.item_span(item);
        let before = &text[..span.start as usize];
        let starts = blank(before.rsplit('\n').next().unwrap_or(before));
        let follows = blank(&text[end_of_whole..span.start as usize]);
        if starts {
            waiting.clear();
        }
        match item {
            // `1 0` is as likely to be a pair of numbers as a placeholder.
            Item::Record(r) if r.kind != RecordKind::Undefined && (starts || follows) => {
                let place = Span::new(block.start + span.start, block.start + span.end);
                waiting.push(Hidden {
                    span: place,
                    ty: r.ty(),
                    id: r.id,
                });
                end_of_whole = span.end as usize;
            }
            _ => {
                waiting.clear();
                continue;
            }
        }
        let after = &text[span.end as usize..];
        if blank(after.split('\n').next().unwrap_or(after)) {
            hidden.append(&mut waiting);
        }
    }
}
