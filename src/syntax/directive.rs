//! Comments that are meant for zpg: `# zpg: allow(W307) #`.

use super::lexer::Token;

/// What every such comment begins with, behind its `#`.
pub const PREFIX: &str = "zpg:";

/// Whether a token is such a comment. It needs no `0` in front.
pub fn is_directive(token: &Token, text: &str) -> bool {
    token.kind.is_comment() && inside(token.text(text)).starts_with(PREFIX)
}

/// What stands between the signs.
pub fn inside(comment: &str) -> &str {
    comment.trim_start_matches('#').trim_end_matches('#').trim()
}
