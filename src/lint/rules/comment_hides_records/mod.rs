//! W315: records that are lost in a comment.

use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::syntax::hidden;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (span, records) in hidden::records(context.text, context.document) {
        let first = records[0];
        let line = context.text[span.range()].lines().next().unwrap_or("");
        let begin = Span::new(span.start, span.start + line.trim_end().len() as u32);
        out.push(
            Diagnostic::new(Code::W315, begin)
                .with("count", Value::Count(records.len() as u64))
                .with("type", Value::Term(first.ty.title))
                .with("id", first.id.to_string())
                .label(first.span, "first")
                .label(Span::new(span.end - 1, span.end), "end"),
        );
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
