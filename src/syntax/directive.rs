//! Comments that are meant for zpg: `# zpg: allow(W307) #`.

use super::lexer::Token;
use crate::diagnostics::Span;

/// The word with which a comment for zpg begins, behind its `#`.
pub const PREFIX: &str = "zpg:";

/// The beginnings of comments that silence ruff, flake8 and black. A comment that begins like this was written for zpg
/// by mistake: zpg does not understand it, but it is no comment for people either.
const FOREIGN: [&str; 4] = ["noqa", "fmt: off", "fmt: on", "fmt: skip"];

/// Whether a token is a comment that is meant for zpg and not for people. The comment needs no `0` in front.
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

/// The text behind `word`, if `text` begins with that word in upper or lower case. White space behind the word is
/// skipped, too.
pub fn without_word<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let start = text.get(..word.len())?;
    (start.eq_ignore_ascii_case(word)).then(|| text[word.len()..].trim_start())
}

/// The text of a comment between its `#`, without white space around it.
pub fn inside(comment: &str) -> &str {
    comment.trim_start_matches('#').trim_end_matches('#').trim()
}

/// A comment that allows findings.
pub struct Allow<'a> {
    /// The span of the list between the brackets.
    pub list: Span,
    /// The entries, empty ones too.
    pub entries: Vec<&'a str>,
    /// Whether the comment is an `allow-next(…)`, which is about the next record on whatever line the comment stands.
    pub is_about_next: bool,
}

impl<'a> Allow<'a> {
    /// Reads `allow(…)` or `allow-next(…)`; `None` for another comment.
    pub fn read(token: &Token, text: &'a str) -> Option<Allow<'a>> {
        let comment = token.text(text);
        let rest = without_word(inside(comment), PREFIX)?;
        let next = without_word(rest, "allow-next");
        let rest = next.or_else(|| without_word(rest, "allow"))?;
        // The text behind the bracket is the user's reason.
        let (list, _) = rest.strip_prefix('(')?.split_once(')')?;
        let start = token.start + comment.find('(')? as u32 + 1;
        Some(Allow {
            list: Span::new(start, start + list.len() as u32),
            entries: list.split(',').map(str::trim).collect(),
            is_about_next: next.is_some(),
        })
    }
}
