//! Text to tree: lex, read what is plain; else read by arity, and where that fails or looks odd, let the layout testify.

use chumsky::Parser;

use super::ast::{Document, Item};
use super::faults::Verdict;
use super::layout::{self, Piece};
use super::lexer::{self, Token, TokenKind};
use super::stream::Stream;
use super::witness::{self, Witnesses};
use super::{comments, plain, reader, references, report, respell};
use crate::diagnostics::{self, Diagnostic};

/// Parses a scene text. It never fails: what cannot be read is in the findings, sorted by place,
/// and every character of the text is still in the document.
pub fn parse(text: &str) -> (Document, Vec<Diagnostic>) {
    let tokens = lexer::lex(text, &[]);
    match plain::items(text, &tokens) {
        Some(items) => (Document { tokens, items }, Vec::new()),
        None => in_full(text, tokens),
    }
}

/// Reads a text of which nothing is known.
pub(super) fn in_full(text: &str, mut tokens: Vec<Token>) -> (Document, Vec<Diagnostic>) {
    if comments::in_trouble(&tokens, text) {
        let unclosed = comments::unclosed(text);
        if !unclosed.is_empty() {
            tokens = lexer::lex(text, &unclosed);
        }
    }
    let mut diagnostics = Vec::new();
    report::comments(text, &tokens, &mut diagnostics);
    let (tokens, glued) = respell::respell(text, tokens);
    respell::report(text, &tokens, &glued, &mut diagnostics);
    let mut items = items(text, &tokens, &mut diagnostics);
    respell::broken(&mut items, &tokens, &glued);
    diagnostics::sort(&mut diagnostics);
    (Document { tokens, items }, diagnostics)
}

fn items(text: &str, tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> Vec<Item> {
    let stream = Stream::new(text, tokens);
    let strict = reader::records(&stream).parse(&stream.sigs).into_output();
    if let Some(items) = &strict
        && witness::is_undisturbed(&stream, extents(items))
    {
        // The reading is right and the layout agrees: there is nothing more to ask.
        return strict.unwrap_or_default();
    }
    let witnesses = Witnesses::new(&stream);
    let strict: Option<Vec<Piece>> =
        strict.map(|items| layout::whole_pieces(&stream, extents(&items)));
    let mut pieces = layout::cut(&stream, &witnesses, strict.as_deref(), false);
    let takes_over = |p: &Piece| {
        matches!(p.verdict, Verdict::Whole(_)) && witnesses.takes_over(&stream, p.start, p.end)
    };
    let mut damage = references::damage(&stream, &pieces);
    if damage > 0 && pieces.iter().any(takes_over) {
        // A record took numbers from a line that looks like one of its own. As something is
        // missing now, believe the line.
        let doubting = layout::cut(&stream, &witnesses, strict.as_deref(), true);
        let other = references::damage(&stream, &doubting);
        if other <= damage {
            (pieces, damage) = (doubting, other);
        }
    }
    let cut_off = tokens
        .iter()
        .any(|t| t.kind == TokenKind::UnterminatedComment);
    if damage > 0
        && !cut_off
        && let Some(strict) = strict
    {
        // The arity has a reading without faults. If nothing is undefined or defined twice in it,
        // it stands against two errors, and against one where no line was crossed.
        let sound = references::damage(&stream, &strict) == 0;
        if sound && (damage > 1 || !witness::is_odd(&stream, &witnesses, &strict)) {
            pieces = strict;
        }
    }
    report::pieces(&stream, &witnesses, &pieces, diagnostics);
    pieces.iter().map(|p| p.item(&stream)).collect()
}

/// The items' tokens, as half-open ranges of significant tokens.
pub(super) fn extents(items: &[Item]) -> impl Iterator<Item = (usize, usize)> {
    let mut start = 0;
    items.iter().map(move |item| {
        let length = match item {
            Item::Record(r) => 2 + r.params as usize,
            Item::Void { .. } | Item::Broken(_) => 1,
        };
        start += length;
        (start - length, start)
    })
}
