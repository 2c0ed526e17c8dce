//! W315: records that are lost in a comment.

use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Span, Value};
use crate::lint::Context;
use crate::syntax::commented_out::comment_out;
use crate::syntax::hidden::{self, LoneSigns};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let comments = hidden::records(context.text, context.document);
    let mut signs = (hidden::lone_signs(context.text, &comments).into_iter()).peekable();
    for (span, records) in comments {
        let own = signs.next_if(|s| s.lines[0].start == span.start);
        let first = records[0];
        let line = context.text[span.range()].lines().next().unwrap_or("");
        let begin = Span::new(span.start, span.start + line.trim_end().len() as u32);
        let mut finding = Diagnostic::new(Code::W315, begin)
            .with("count", Value::Count(records.len() as u64))
            .with("type", Value::Term(first.ty.title))
            .with("id", first.id.to_string())
            .label(first.span, "first")
            .label(Span::new(span.end - 1, span.end), "end");
        finding.fixes.extend(own.map(close_both));
        out.push(finding);
    }
}

/// The fix that makes each of two lines with a lone `#` at the beginning a comment of its own.
fn close_both(signs: LoneSigns) -> Fix {
    let closed = |text: String| match text.contains('#') {
        true => comment_out(&text),
        false => format!("# {text} #"),
    };
    let edits = signs.lines.into_iter().zip(signs.texts);
    let edits = edits.map(|(span, text)| Edit {
        span,
        text: closed(text),
    });
    Fix::guess("fix", edits.collect())
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
