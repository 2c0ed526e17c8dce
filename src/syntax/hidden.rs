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

/// Finds the comments over several lines that hide records: the span of each, with the records in it.
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
        // Text that is commented out is hidden on purpose. Other editors may comment out several lines as one.
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

/// Two lines that each begin with a `#`, as if that sign switched its line off. The first line is a comment, which ends
/// with the `#` of the second line. So the second line is no comment.
#[derive(Debug)]
pub struct LoneSigns {
    /// The spans of the two lines, from the `#` on.
    pub lines: [Span; 2],
    /// The text of each line without its `#`.
    pub texts: [String; 2],
    /// The IDs of the records on the second line.
    pub ids: Vec<u32>,
}

/// Finds the pairs of lines with lone signs whose second line is records without its sign. `comments` are the comments
/// that hide [records].
pub fn lone_signs(text: &str, comments: &[(Span, Vec<Hidden>)]) -> Vec<LoneSigns> {
    let mut out = Vec::new();
    let mut budget = BYTES_MAX;
    for (comment, _) in comments {
        let begins_line = |at: u32| {
            let before = text[..at as usize].trim_end_matches([' ', '\t']);
            before.is_empty() || before.ends_with(['\n', '\r'])
        };
        let sign = comment.end - 1;
        let inside = text[comment.start as usize + 1..sign as usize].trim();
        let line = text[comment.start as usize..].lines().next().unwrap_or("");
        let is_line = line[1..].trim() == inside;
        if !is_line || !begins_line(comment.start) || !begins_line(sign) {
            continue;
        }
        let rest = text[comment.end as usize..].lines().next().unwrap_or("");
        budget = match budget.checked_sub(rest.len()) {
            Some(left) => left,
            None => return out,
        };
        let Some(document) = of_records(rest) else {
            continue;
        };
        let span = |start: u32, line: &str| Span::new(start, start + line.trim_end().len() as u32);
        out.push(LoneSigns {
            lines: [
                span(comment.start, line),
                Span::new(sign, span(comment.end, rest).end),
            ],
            texts: [inside, rest.trim()].map(str::to_owned),
            ids: (document.items.iter().filter_map(Item::record))
                .map(|r| r.id)
                .collect(),
        });
    }
    out
}

/// A line that is a comment, and would be records without the signs of the comment.
#[derive(Debug)]
pub struct Line {
    /// The part of the line to replace, from its first token to the end of the comment.
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
        if let Some(document) = of_records(&inside) {
            out.push(Line {
                span: Span::new(rest[0].start, comment.end()),
                text: inside,
                document,
            });
        }
    }
    out
}

/// Parses a text that is made of records and comments alone; `None` for any other text.
fn of_records(text: &str) -> Option<Document> {
    // `1 0` is as likely to be a pair of numbers as a placeholder.
    let is_record =
        |item: &Item| matches!(item, Item::Record(r) if r.kind != RecordKind::Undefined);
    let document = super::parser::parse_plain(text)?;
    let is_such = !document.items.is_empty() && document.items.iter().all(is_record);
    is_such.then_some(document)
}

/// The text inside of a comment, if it is one line that begins with a number. A comment that nobody closes may have
/// another comment inside.
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

/// The stretches of neighbouring lines that begin with a number. Prose is left out, as it is slow to read.
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

/// Adds those records of a block to `hidden` that fill their lines.
fn read(text: &str, block: Span, hidden: &mut Vec<Hidden>) {
    let text = &text[block.range()];
    let (document, _) = super::parse(text);
    let blank = |s: &str| s.trim_matches([' ', '\t', '\r']).is_empty();
    // The end of the last record that fills its lines up to there. Other records may follow on its last line.
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
