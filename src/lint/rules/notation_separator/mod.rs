//! S501: separators of the handout's table notation, copied into a scene.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::Context;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::{Item, commas, quote};

/// Whether a separator is a comma that may be a decimal one, since digits stand on both sides. If a space follows the
/// comma, the numbers on both sides must have no other point or comma.
fn is_between_digits(text: &str, separator: &Token) -> bool {
    let before = &text[..separator.start as usize];
    let behind = &text[separator.end() as usize..];
    let number = behind.trim_start_matches([' ', '\t']);
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let is_pair = separator.text(text) == ","
        && is_digit(before.chars().next_back())
        && is_digit(number.chars().next());
    let has_more = |c: Option<char>| c.is_some_and(|c| matches!(c, '.' | ','));
    let of_digits = |c: char| c.is_ascii_digit();
    is_pair
        && (behind.len() == number.len()
            || !has_more(before.trim_end_matches(of_digits).chars().next_back())
                && !has_more(number.trim_start_matches(of_digits).chars().next()))
}

/// Whether a separator is a comma that a number may begin with: `,5` for 0.5.
fn begins_number(text: &str, separator: &Token) -> bool {
    let at = |i: usize| text.as_bytes().get(i);
    let before = (separator.start as usize).checked_sub(1).and_then(at);
    separator.text(text) == ","
        && before.is_none_or(u8::is_ascii_whitespace)
        && at(separator.end() as usize).is_some_and(u8::is_ascii_digit)
}

/// Whether a record that cannot be read has a part in the line of a separator.
fn is_broken(context: &Context, separator: Span) -> bool {
    let (text, document) = (context.text, context.document);
    let at = separator.start as usize;
    let start = text[..at].rfind(['\n', '\r']).map_or(0, |i| i + 1);
    let end = text[at..].find(['\n', '\r']).map_or(text.len(), |i| at + i);
    let first =
        (document.items).partition_point(|item| document.item_span(item).end as usize <= start);
    let on_line = document.items[first..].iter();
    let mut on_line = on_line.take_while(|item| (document.item_span(item).start as usize) < end);
    on_line.any(|item| matches!(item, Item::Broken(_)))
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.separators {
        return;
    }
    let in_doubt = commas::in_doubt(context.text, context.document);
    // One finding a line is enough.
    for line in context
        .document
        .tokens
        .split(|t| t.kind() == TokenKind::Newline)
    {
        let separators: Vec<&Token> = line
            .iter()
            .filter(|t| t.kind() == TokenKind::Separator)
            .collect();
        let Some(first) = separators.first() else {
            continue;
        };
        let text = context.text.as_bytes();
        let space = |i: usize| text.get(i).is_none_or(u8::is_ascii_whitespace);
        let is_next = |a: &Token, b: &Token| a.end() == b.start;
        // For each separator whether white space follows the unbroken row of separators that it begins.
        let mut behind: Vec<bool> = separators.iter().map(|t| space(t.end() as usize)).collect();
        for i in (1..separators.len()).rev() {
            if is_next(separators[i - 1], separators[i]) {
                behind[i - 1] = behind[i];
            }
        }
        let mut edits = Vec::new();
        for (i, (t, behind)) in separators.iter().zip(behind).enumerate() {
            // Numbers that only separators keep apart need one space in their place.
            let before = t.start as usize;
            let is_behind_another = i > 0 && is_next(separators[i - 1], t);
            let apart = behind || is_behind_another || before == 0 || space(before - 1);
            // Where spaces stand on both sides, those behind the separator stay.
            let blank = |i: &usize| matches!(text[*i], b' ' | b'\t');
            let blanks = (0..before).rev().take_while(blank).count();
            let start = before - if behind { blanks } else { 0 };
            edits.push(Edit {
                span: Span::new(start as u32, t.end()),
                text: if apart { "" } else { " " }.to_owned(),
            });
        }
        let finding = Diagnostic::new(Code::S501, first.span())
            .with("text", first.text(context.text).to_owned())
            .with("count", Value::Count(separators.len() as u64));
        let last = separators[separators.len() - 1].start;
        let at = in_doubt.partition_point(|pair| pair.end <= first.start);
        let doubtful = in_doubt.get(at).filter(|pair| pair.start < last);
        if let Some(&pair) = doubtful {
            let words = &context.text[pair.range()];
            let finding = Diagnostic::new(Code::S501, pair).case("decimal");
            let finding = finding.with("number", quote(&words.replace(',', " ")));
            out.push(
                finding
                    .with("text", quote(words))
                    .fix(Fix::guess("fix", edits)),
            );
            continue;
        }
        let leading: Vec<Span> = (separators.iter())
            .filter(|t| begins_number(context.text, t))
            .map(|t| t.span())
            .collect();
        if !leading.is_empty() {
            let mut points = edits.clone();
            for edit in points.iter_mut().filter(|e| leading.contains(&e.span)) {
                edit.text = String::from(".");
            }
            out.push((finding.fix(Fix::guess("points", points))).fix(Fix::guess("fix", edits)));
            continue;
        }
        // A broken record on the line may be broken by what the separators stand for, as a decimal comma or a comment.
        let may_say_more = line.iter().any(|t| t.kind() == TokenKind::Word)
            || separators
                .iter()
                .any(|t| is_between_digits(context.text, t));
        out.push(match may_say_more && is_broken(context, first.span()) {
            true => finding,
            false => finding.fix(Fix {
                title: "fix",
                values: Vec::new(),
                applicability: Applicability::Safe,
                edits,
            }),
        });
    }
}
