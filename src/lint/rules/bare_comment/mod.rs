//! S502: a stand-alone comment that no VOID record introduces.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span};
use crate::lint::Context;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::{Item, is_directive};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let tokens = &context.document.tokens;
    let mut items = context.document.items.iter().peekable();
    // The item that ended last before the token at hand.
    let mut previous: Option<&Item> = None;
    let comments = (tokens.iter().enumerate())
        .filter(|(_, t)| context.document.contents.comments && t.kind() == TokenKind::Comment);
    for (i, t) in comments {
        while let Some(item) = items.next_if(|item| (item.ends().1 as usize) < i) {
            previous = Some(item);
        }
        let inside = items
            .peek()
            .is_some_and(|item| (item.ends().0 as usize) < i);
        if inside || !stands_alone(tokens, i) {
            continue;
        }
        let introduced = matches!(previous, Some(Item::Void { token })
            if tokens[*token as usize + 1..i].iter().all(|t| t.kind() == TokenKind::Newline));
        if introduced || is_directive(t, context.text) {
            continue;
        }
        out.push(Diagnostic::new(Code::S502, t.span()).fix(Fix::replace(
            "fix",
            Applicability::Safe,
            Span::new(t.start, t.start),
            "0 ",
        )));
    }
}

/// Whether nothing else stands on the comment's line.
fn stands_alone(tokens: &[Token], i: usize) -> bool {
    let edge = |t: &Token| matches!(t.kind(), TokenKind::Newline | TokenKind::ByteOrderMark);
    tokens[..i].last().is_none_or(edge) && tokens.get(i + 1).is_none_or(edge)
}
