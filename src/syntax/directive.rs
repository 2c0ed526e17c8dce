//! Comments that are meant for zpg: `# zpg: allow(W307) #`.

use super::lexer::Token;
use crate::diagnostics::Span;

/// What every such comment begins with, behind its `#`.
pub const PREFIX: &str = "zpg:";

/// Whether a token is such a comment. It needs no `0` in front.
pub fn is_directive(token: &Token, text: &str) -> bool {
    if !token.kind().is_comment() {
        return false;
    }
    let inside = token.text(text).trim_start_matches('#').trim_start();
    without_word(inside, PREFIX).is_some()
}

/// What follows a word, in any case, at the start of a text.
pub fn without_word<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let start = text.get(..word.len())?;
    (start.eq_ignore_ascii_case(word)).then(|| text[word.len()..].trim_start())
}

/// What stands between the signs.
pub fn inside(comment: &str) -> &str {
    comment.trim_start_matches('#').trim_end_matches('#').trim()
}

/// What stands between the brackets of `allow(…)`: where, and its entries, with empty ones. Nothing for another
/// comment.
pub fn entries<'a>(token: &Token, text: &'a str) -> Option<(Span, Vec<&'a str>)> {
    let comment = token.text(text);
    let rest = without_word(inside(comment), PREFIX)?;
    let rest = without_word(rest, "allow")?.strip_prefix('(')?;
    // What follows is the reason.
    let (list, _) = rest.split_once(')')?;
    let start = token.start + comment.find('(')? as u32 + 1;
    let span = Span::new(start, start + list.len() as u32);
    Some((span, list.split(',').map(str::trim).collect()))
}
