//! W315: records that are lost in a comment.

use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::syntax::commented_out::is_commented_out;
use crate::syntax::lexer::TokenKind;
use crate::syntax::table::RecordKind;
use crate::syntax::{self, Item};

/// How many bytes of comments are read as records, in all. Reading is linear, but slow where the layout
/// must testify, as in prose.
const BYTES_MAX: usize = 1 << 18;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.long_comments {
        return;
    }
    let mut budget = BYTES_MAX;
    for t in &context.document.tokens {
        if t.kind() != TokenKind::Comment || t.length() < 2 {
            continue;
        }
        // Other editors may comment out several lines as one.
        if is_commented_out(t.text(context.text)) {
            continue;
        }
        let span = t.span();
        let inside = Span::new(span.start + 1, span.end - 1);
        if !context.text[inside.range()].contains('\n') {
            continue;
        }
        let mut hidden: Vec<(Span, &'static str, u32)> = Vec::new();
        for block in blocks(context.text, inside) {
            budget = match budget.checked_sub(block.range().len()) {
                Some(left) => left,
                None => return,
            };
            read(context.text, block, &mut hidden);
        }
        if let Some(&(first, title, id)) = hidden.first() {
            let line = context.text[span.range()].lines().next().unwrap_or("");
            let begin = Span::new(span.start, span.start + line.trim_end().len() as u32);
            out.push(
                Diagnostic::new(Code::W315, begin)
                    .with("count", Value::Count(hidden.len() as u64))
                    .with("type", Value::Term(title))
                    .with("id", id.to_string())
                    .label(first, "first")
                    .label(Span::new(span.end - 1, span.end), "end"),
            );
        }
    }
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
fn read(text: &str, block: Span, hidden: &mut Vec<(Span, &'static str, u32)>) {
    let text = &text[block.range()];
    let (document, _) = syntax::parse(text);
    let blank = |s: &str| s.trim_matches([' ', '\t', '\r']).is_empty();
    // Where the last record ended that fills its lines so far: others may follow on the line.
    let mut end_of_whole = 0;
    let mut waiting: Vec<(Span, &'static str, u32)> = Vec::new();
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
                waiting.push((place, r.ty().title, r.id));
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

#[cfg(test)]
mod tests {
    use crate::lint::testing::found;

    #[test]
    fn within_the_budget() {
        let much = format!("0 #\n{}\n3 9 1\n#", "1 2 3 4 5\n".repeat(30_000));
        assert!(found(&much).is_empty());
    }
}
