//! W336: a transformation that stands there twice, one right behind the other.

use crate::diagnostics::{Applicability, Code, Diagnostic, Value};
use crate::lint::Context;
use crate::syntax::{Item, Record};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for pair in context.document.items.windows(2) {
        let [Item::Record(first), Item::Record(second)] = pair else {
            continue;
        };
        if !super::TRANSFORMATIONS.contains(&first.kind) || !is_repeated(context, first, second) {
            continue;
        }
        let p = context.record_params(second);
        let d = Diagnostic::new(Code::W336, p.span())
            .with("type", Value::Term(p.ty.title))
            .with("id", p.id.to_string())
            .label(context.record_params(first).span(), "first");
        out.push(
            match context.take_out(second, "fix", Applicability::Unsafe) {
                Some(fix) => d.fix(fix),
                None => d,
            },
        );
    }
}

/// Whether two records are the same word for word, and nothing between says that they are two.
fn is_repeated(context: &Context, first: &Record, second: &Record) -> bool {
    let words = |r: &Record| {
        let tokens = context.document.significant(r.first, r.last);
        tokens.map(|t| t.text(context.text))
    };
    let between = &context.document.tokens[first.last as usize..second.first as usize];
    first.kind == second.kind
        && first.id == second.id
        && !between.iter().any(|t| t.kind().is_comment())
        && words(first).eq(words(second))
}
