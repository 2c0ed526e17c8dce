//! S501: separators of the handout's table notation, copied into a scene.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::lint::Context;
use crate::syntax::lexer::{Token, TokenKind};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.separators {
        return;
    }
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
        let mut edits = Vec::new();
        for t in &separators {
            // Numbers that only the separator keeps apart need a space in its place.
            let apart = space(t.end() as usize) || t.start == 0 || space(t.start as usize - 1);
            edits.push(Edit {
                span: t.span(),
                text: if apart { "" } else { " " }.to_owned(),
            });
        }
        out.push(
            Diagnostic::new(Code::S501, first.span())
                .with("text", first.text(context.text).to_owned())
                .with("count", Value::Count(separators.len() as u64))
                .fix(Fix {
                    title: "fix",
                    values: Vec::new(),
                    applicability: Applicability::Safe,
                    edits,
                }),
        );
    }
}
