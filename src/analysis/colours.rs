//! Findings about colours as other programs write them, `7 -701 #ff8000`, `7 -701 rgb(255, 128, 0)` or
//! `7 -701 dark red`, and about materials by name, `7 -201 glass`. Each colour or material is one finding, which says
//! the numbers to write.

use super::materials;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, SourceFile, Span};
use crate::lint::spelling::linear_part;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::RecordKind;
use crate::syntax::{Document, Item, colour_names, hex, quote};

/// Replaces the findings about each record that has a colour in hexadecimal digits, or a colour or material by name, by
/// one finding.
pub fn join(document: &Document, source: &SourceFile, findings: &mut Vec<Diagnostic>) {
    if !document.contents.broken {
        return;
    }
    for item in &document.items {
        let Item::Broken(broken) = item else { continue };
        if let Some(kind) = broken.kind
            && let Some(finding) = one_word(document, &source.text, broken.first, kind)
        {
            let start = document.tokens[broken.first as usize].start;
            let record = start..finding.fixes[0].edits[0].span.end;
            findings.retain(|d| !record.contains(&d.span.start));
            findings.push(finding);
        }
    }
}

/// The finding about a colour or a material in the place of a record's numbers. `id` is the index of the token of the
/// record's ID. `None` if there is no such word.
fn one_word(document: &Document, text: &str, id: u32, kind: RecordKind) -> Option<Diagnostic> {
    let tokens = document.tokens[id as usize..].iter();
    let mut on_line = tokens.take_while(|t| t.kind() != TokenKind::Newline);
    let word = on_line.by_ref().nth(2)?;
    let more: Vec<&Token> = on_line.take_while(|t| !t.kind().is_comment()).collect();
    if !more.is_empty() {
        // The colour may be two words, or have numbers in brackets.
        let span = word.span().to(more.last()?.span());
        let is_colour = kind == RecordKind::Colour && word.kind() == TokenKind::Word;
        let colour = shown(&text[span.range()]).filter(|_| is_colour)?;
        let finding = Diagnostic::new(Code::E003, span).case("colour");
        return Some(proposing(finding, text, span, (spelled_out(colour), "")));
    }
    let within = word.text(text).trim_matches('"');
    if kind != RecordKind::Colour {
        let numbers = materials::numbers(kind, within)?;
        let finding = Diagnostic::new(Code::E003, word.span()).case("material");
        return Some(proposing(finding, text, word.span(), (numbers, "")));
    }
    let (span, colour, comment) = match word.kind().is_comment() {
        true => in_comment(word, text)?,
        false => (word.span(), shown(within)?, String::new()),
    };
    let finding = Diagnostic::new(Code::E003, span).case("colour");
    let numbers = spelled_out(colour);
    Some(proposing(finding, text, word.span(), (numbers, &comment)))
}

/// Completes a finding about a word with the fix that writes numbers in its place, and a comment behind them.
fn proposing(
    finding: Diagnostic,
    text: &str,
    word: Span,
    (numbers, comment): (String, &str),
) -> Diagnostic {
    let written = quote(&text[finding.span.range()]);
    finding
        .with("text", written)
        .with("number", quote(&numbers))
        .fix(Fix::replace(
            "fix",
            Applicability::Unsafe,
            word,
            numbers + comment,
        ))
}

/// The numbers of the colour that a word means, in hexadecimal digits or by name. `None` if it means no colour.
pub fn numbers(word: &str) -> Option<String> {
    shown(word.trim_matches('"')).map(spelled_out)
}

/// The sRGB colour that a word means.
fn shown(word: &str) -> Option<[u8; 3]> {
    hex::colour(word).or_else(|| colour_names::colour(word))
}

fn spelled_out(shown: [u8; 3]) -> String {
    shown.map(linear_part).join(" ")
}

/// The colour in hexadecimal digits whose `#` was read as the beginning of a comment: its span, its value, and the rest
/// of the comment as a comment of its own.
fn in_comment(sign: &Token, text: &str) -> Option<(Span, [u8; 3], String)> {
    let whole = sign.text(text);
    let (word, colour) = hex::at_start(whole)?;
    let rest = whole[word.len()..].trim();
    let words = rest.strip_prefix('#').unwrap_or(rest);
    let words = words.strip_suffix('#').unwrap_or(words).trim();
    let comment = match words {
        "" => String::new(),
        words if words.contains('#') => return None,
        words => format!(" # {words} #"),
    };
    let span = Span::new(sign.start, sign.start + word.len() as u32);
    Some((span, colour, comment))
}
