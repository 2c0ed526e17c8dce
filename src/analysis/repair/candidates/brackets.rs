//! Square brackets around numbers, which are no separators: `[4,6,5]`.

use crate::diagnostics::Span;
use crate::syntax::lexer::{Token, TokenKind};

/// The brackets before and behind the number that a token is without them; nothing if it has none.
fn around(t: &Token, text: &str) -> Option<[Span; 2]> {
    let written = t.text(text);
    let open = written.len() - written.trim_start_matches('[').len();
    let close = written.len() - written.trim_end_matches(']').len();
    let within = written.get(open..written.len() - close)?;
    let is_number = within.is_empty() || within.parse::<f64>().is_ok_and(f64::is_finite);
    (is_number && open + close > 0).then(|| {
        let (start, end) = (t.start, t.end());
        [
            Span::new(start, start + open as u32),
            Span::new(end - close as u32, end),
        ]
    })
}

/// Takes brackets from tokens, and tokens that are nothing else.
pub(super) fn strip(tokens: &mut Vec<Token>, text: &str) {
    for t in tokens.iter_mut() {
        if let Some([open, close]) = around(t, text).filter(|[open, close]| open.end < close.start)
        {
            let within = &text[open.end as usize..close.start as usize];
            let kind = match within.parse::<i64>() {
                Ok(_) => TokenKind::Integer,
                Err(_) => TokenKind::Real,
            };
            *t = Token::new(kind, open.end as usize, close.start as usize);
        }
    }
    tokens.retain(|t| around(t, text).is_none());
}

/// All brackets that belong to tokens.
pub(super) fn all<'t>(tokens: &'t [Token], text: &'t str) -> impl Iterator<Item = Span> + 't {
    let each = tokens.iter().filter_map(|t| around(t, text)).flatten();
    each.filter(|span| !span.range().is_empty())
}
