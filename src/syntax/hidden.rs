//! Records that are lost in comments.

use super::commented_out::{SIGN, TILDE, is_commented_out};
use super::lexer::{Token, TokenKind};
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

/// A line that is a comment and would be records without it.
#[derive(Debug)]
pub struct Line {
    /// All of the line that is to be replaced.
    pub span: Span,
    /// The line without the signs of the comment.
    pub text: String,
    pub document: Document,
}

/// The lines that are comments around records, and nothing else.
pub fn lines(text: &str, document: &Document) -> Vec<Line> {
    let mut out = Vec::new();
    let mut budget = BYTES_MAX;
    let tokens = &document.tokens;
    let newline = |t: &&Token| t.kind() == TokenKind::Newline;
    let mut at = 0;
    while at < tokens.len() {
        let rest = &tokens[at..];
        let end = rest.iter().position(|t| newline(&t)).unwrap_or(rest.len());
        at += end + 1;
        let line = &rest[..end];
        let line = match line {
            [void, rest @ ..] if void.text(text) == "0" => rest,
            line => line,
        };
        let [comment] = line else { continue };
        if !comment.kind().is_comment() {
            continue;
        }
        let Some(inside) = inside(comment, text) else {
            continue;
        };
        budget = match budget.checked_sub(inside.len()) {
            Some(left) => left,
            None => return out,
        };
        // `1 0` is as likely to be a pair of numbers as a placeholder.
        let is_record =
            |item: &Item| matches!(item, Item::Record(r) if r.kind != RecordKind::Undefined);
        if let Some(document) = super::parser::parse_plain(&inside)
            && !document.items.is_empty()
            && document.items.iter().all(is_record)
        {
            out.push(Line {
                span: Span::new(rest[0].start, comment.end()),
                text: inside,
                document,
            });
        }
    }
    out
}

/// What a comment on a line has in it, where that begins with a number. A comment that is not closed may have one in it.
fn inside(comment: &Token, text: &str) -> Option<String> {
    let written = comment.text(text);
    let inside = written.strip_prefix('#')?;
    let inside = match comment.kind() {
        TokenKind::Comment => inside.strip_suffix('#')?,
        _ => inside,
    };
    let inside = match is_commented_out(written) {
        true => (inside.trim_start_matches([' ', '~', '+']))
            .replace(SIGN, "#")
            .replace(TILDE, "~"),
        false => inside.to_owned(),
    };
    let inside = inside.trim();
    let is_number = inside.starts_with(|c: char| c.is_ascii_digit());
    (is_number && !inside.contains('\n')).then(|| inside.to_owned())
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
