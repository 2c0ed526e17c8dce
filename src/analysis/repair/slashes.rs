//! Comments as C has them, `// …` and `/* … */`, on one line or on many.

use super::whole::Matter;
use crate::analysis::Analysis;
use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Span, Value};
use crate::syntax::commented_out::comment_out;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::quote;

/// Finds the C comments of a text; the fix rewrites them as comments of zpg. `None` if the only one is words at the end
/// of its line: the finding about that line says so.
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
    let blocks = blocks(analysis);
    // Whether a place is within a comment over several lines.
    let within = |at: u32| {
        let next = blocks.partition_point(|b| b.edit.span.start <= at);
        let block = next.checked_sub(1).map(|i| &blocks[i]);
        block.is_some_and(|b| at < b.edit.span.end)
    };
    let mut edits: Vec<Edit> = Vec::new();
    // Whether something else follows a comment on its line.
    let mut is_before = false;
    for line in lines {
        let Some(last) = line.last() else { continue };
        let mut end = 0;
        for (at, token) in line.iter().enumerate() {
            let rest = &text[token.start as usize..last.end() as usize];
            let is_block = rest.starts_with(BEGIN);
            let is_begin = is_block || rest.starts_with("//");
            if !is_begin || token.start < end || token.kind().is_comment() || within(token.start) {
                continue;
            }
            let words = match is_block {
                false => rest.trim_start_matches('/'),
                true => match rest[BEGIN.len()..].find(END) {
                    Some(length) => &rest[BEGIN.len()..][..length],
                    // The comment ends on another line.
                    None => break,
                },
            };
            let length = match is_block {
                true => BEGIN.len() + words.len() + END.len(),
                false => rest.len(),
            };
            // A comment of zpg that goes on behind the C comment is not cut.
            if length < rest.len() && words.matches('#').count() % 2 == 1 {
                break;
            }
            let span = Span::new(token.start, token.start + length as u32);
            end = span.end;
            let is_trivia = |some: &[Token]| some.iter().all(|t| t.kind().is_trivia());
            let behind = line.partition_point(|t| t.start < end);
            let is_last = is_trivia(&line[behind..]);
            is_before |= !is_last;
            let comment = as_comment(words);
            let is_alone = is_last && is_trivia(&line[..at]);
            let void = if is_alone && !comment.is_empty() {
                "0 "
            } else {
                ""
            };
            let text = format!("{void}{comment}");
            edits.push(Edit { span, text });
        }
    }
    let is_of_words = edits.len() == 1 && edits[0].text.contains(char::is_alphabetic);
    if blocks.is_empty() && is_of_words && !is_before {
        return None;
    }
    let count = edits.len() + blocks.iter().map(|b| b.lines).sum::<usize>();
    edits.extend(blocks.into_iter().map(|b| b.edit));
    edits.sort_by_key(|e| e.span.start);
    let first = edits.first()?;
    let sign = Span::new(first.span.start, first.span.start + 2);
    let spans = edits.iter().map(|e| e.span).collect();
    let finding = Diagnostic::new(Code::E001, sign)
        .case("slashes")
        .with("text", quote(analysis.source.slice(sign)))
        .with("count", Value::Count(count as u64))
        .fix(Fix::guess("fix", edits));
    Some(Matter { finding, spans })
}

/// Writes the words of a C comment as a comment of zpg. Empty if there are no words.
pub(super) fn as_comment(words: &str) -> String {
    let words = words.replace('#', " ");
    let words: Vec<&str> = words.split_whitespace().collect();
    match words.is_empty() {
        true => String::new(),
        false => format!("# {} #", words.join(" ")),
    }
}

/// A comment from `/*` to `*/` over several lines.
struct Block {
    /// A comment for each line in its place.
    edit: Edit,
    /// The number of lines of the comment that are not empty.
    lines: usize,
}

/// Finds all C comments over several lines. A line that may be a record is commented out as an editor does it.
fn blocks(analysis: &Analysis) -> Vec<Block> {
    let text = analysis.source.text.as_str();
    let mut blocks = Vec::new();
    let mut end = 0;
    for token in &analysis.document.tokens {
        let start = token.start as usize;
        if start < end || token.kind().is_comment() || !token.text(text).starts_with(BEGIN) {
            continue;
        }
        // If one comment has no end, no later comment has one.
        let Some(length) = text[start + BEGIN.len()..].find(END) else {
            break;
        };
        let inside = &text[start + BEGIN.len()..][..length];
        end = start + BEGIN.len() + length + END.len();
        // A comment of zpg that goes on behind the C comment is not cut.
        if !inside.contains('\n') || inside.matches('#').count() % 2 == 1 {
            continue;
        }
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let is_alone = text[line_start..start].trim().is_empty();
        let mut lines: Vec<String> = Vec::new();
        for (i, line) in inside.lines().enumerate() {
            let line = line.trim();
            if !line.is_empty() {
                lines.push(commented(line, i == 0 && !is_alone));
            }
        }
        let rest = text[end..].lines().next().unwrap_or("");
        let count = lines.len();
        let mut text = lines.join("\n");
        if !rest.trim().is_empty() && count > 0 {
            text.push('\n');
        }
        let span = Span::new(start as u32, end as u32);
        blocks.push(Block {
            edit: Edit { span, text },
            lines: count,
        });
    }
    blocks
}

const BEGIN: &str = "/*";
const END: &str = "*/";

/// Writes a line as a comment. Behind a record the comment needs no `0` before it.
fn commented(line: &str, is_behind: bool) -> String {
    let is_record = line.starts_with(|c: char| c.is_ascii_digit());
    if is_record && !is_behind {
        return comment_out(line);
    }
    let words = line.replace('#', " ");
    let words: Vec<&str> = words.split_whitespace().collect();
    let void = if is_behind { "" } else { "0 " };
    format!("{void}# {} #", words.join(" "))
}
