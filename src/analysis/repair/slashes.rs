//! Comments as C has them, `// …` and `/* … */`, on one line or on many.

use super::whole::Matter;
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::lexer::TokenKind;
use crate::syntax::quote;

/// All such comments of a text, as its own ones. What is wrong with a single one of words, its own line says.
pub(super) fn comments(analysis: &Analysis, findings: &[Diagnostic]) -> Option<Matter> {
    let is_unread = |d: &Diagnostic| matches!(d.code, Code::E001 | Code::E012);
    if !findings.iter().any(is_unread) {
        return None;
    }
    let text = analysis.source.text.as_str();
    let lines = analysis
        .document
        .tokens
        .split(|t| t.kind() == TokenKind::Newline);
    let mut edits: Vec<Edit> = Vec::new();
    for line in lines {
        let begins = |sign: &str| line.iter().position(|t| t.text(text).starts_with(sign));
        let (Some(at), Some(last)) = (begins("//").or_else(|| begins("/*")), line.last()) else {
            continue;
        };
        let span = line[at].span().to(last.span());
        let written = text[span.range()].trim();
        let words = match written.strip_prefix("/*").map(|w| w.strip_suffix("*/")) {
            Some(Some(words)) => words,
            // It ends on another line.
            Some(None) => continue,
            None => written.trim_start_matches('/'),
        };
        let words = words.replace('#', " ");
        let words: Vec<&str> = words.split_whitespace().collect();
        let comment = match words.is_empty() {
            true => String::new(),
            false => format!("# {} #", words.join(" ")),
        };
        let is_alone = line[..at].iter().all(|t| t.kind().is_trivia());
        let void = if is_alone && !words.is_empty() {
            "0 "
        } else {
            ""
        };
        let text = format!("{void}{comment}");
        edits.push(Edit { span, text });
    }
    let first = edits.first()?;
    let is_of_words = first.text.contains(char::is_alphabetic);
    if edits.len() < 2 && is_of_words {
        return None;
    }
    let sign = Span::new(first.span.start, first.span.start + 2);
    let spans = edits.iter().map(|e| e.span).collect();
    let finding = Diagnostic::new(Code::E001, sign)
        .case("slashes")
        .with("text", quote(analysis.source.slice(sign)))
        .with("count", Value::Count(edits.len() as u64))
        .fix(Fix::guess("fix", edits));
    Some(Matter { finding, spans })
}
