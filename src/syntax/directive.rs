//! Comments that are meant for zpg: `# zpg: allow(W307) #`.

use super::lexer::Token;
use crate::diagnostics::Span;

/// The beginning of every such comment, behind its `#`.
pub const PREFIX: &str = "zpg:";

/// The beginnings of such comments for ruff, flake8 and black: a comment that has one is meant for zpg, which does not
/// understand it.
const FOREIGN: [&str; 4] = ["noqa", "fmt: off", "fmt: on", "fmt: skip"];

/// Whether a token is such a comment. It needs no `0` in front.
pub fn is_directive(token: &Token, text: &str) -> bool {
    if !token.kind().is_comment() {
        return false;
    }
    let inside = token.text(text).trim_start_matches('#').trim_start();
    let is_end = |rest: &str| rest.is_empty() || rest.starts_with([':', '#']);
    without_word(inside, PREFIX).is_some()
        || FOREIGN
            .iter()
            .any(|word| without_word(inside, word).is_some_and(is_end))
}

/// The text after a word, in any case, at the start of a text.
pub fn without_word<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let start = text.get(..word.len())?;
    (start.eq_ignore_ascii_case(word)).then(|| text[word.len()..].trim_start())
}

/// The text between the signs.
pub fn inside(comment: &str) -> &str {
    comment.trim_start_matches('#').trim_end_matches('#').trim()
}

/// A comment that allows findings.
pub struct Allow<'a> {
    /// The span of the list between the brackets.
    pub list: Span,
    /// The entries, empty ones too.
    pub entries: Vec<&'a str>,
    /// Whether the comment is about the next record wherever it stands: `allow-next(…)`.
    pub is_about_next: bool,
}

impl<'a> Allow<'a> {
    /// Reads `allow(…)` or `allow-next(…)`; nothing for another comment.
    pub fn read(token: &Token, text: &'a str) -> Option<Allow<'a>> {
        let comment = token.text(text);
        let rest = without_word(inside(comment), PREFIX)?;
        let next = without_word(rest, "allow-next");
        let rest = next.or_else(|| without_word(rest, "allow"))?;
        // What follows is the reason.
        let (list, _) = rest.strip_prefix('(')?.split_once(')')?;
        let start = token.start + comment.find('(')? as u32 + 1;
        Some(Allow {
            list: Span::new(start, start + list.len() as u32),
            entries: list.split(',').map(str::trim).collect(),
            is_about_next: next.is_some(),
        })
    }
}
