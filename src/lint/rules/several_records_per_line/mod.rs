//! S503: more than one record on a line.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::Context;
use crate::syntax::Item;
use crate::syntax::lexer::TokenKind;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let document = context.document;
    let tokens = &document.tokens;
    // One finding a line, with all records that begin on it behind another one.
    let mut line: Vec<&Item> = Vec::new();
    for pair in document.items.windows(2) {
        let between = pair[0].ends().1 as usize + 1..pair[1].ends().0 as usize;
        let same_line = !tokens[between]
            .iter()
            .any(|t| t.kind() == TokenKind::Newline);
        // A broken stretch was reported; where it ends is only a guess.
        let sound = !matches!(pair[0], Item::Broken(_)) && !matches!(pair[1], Item::Broken(_));
        if same_line && sound {
            line.push(&pair[1]);
        } else if !same_line {
            report(context, &mut line, out);
        }
    }
    report(context, &mut line, out);
}

fn report(context: &Context, line: &mut Vec<&Item>, out: &mut Vec<Diagnostic>) {
    let Some(first) = line.first() else { return };
    let text = context.text;
    let edits = line.iter().map(|item| {
        let start = context.document.item_span(item).start;
        let before = &text[..start as usize];
        let blank = before.trim_end_matches([' ', '\t']).len() as u32;
        Edit {
            span: Span::new(blank, start),
            text: "\n".to_owned(),
        }
    });
    let fix = Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Safe,
        edits: edits.collect(),
    };
    let finding = Diagnostic::new(Code::S503, context.document.item_span(first))
        .with("count", Value::Count(line.len() as u64));
    // What could not be read is read by its lines: with others it may be something else.
    out.push(match context.document.contents.broken {
        true => finding,
        false => finding.fix(fix),
    });
    line.clear();
}
