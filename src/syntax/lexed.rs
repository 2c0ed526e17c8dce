//! The tokens of a text in columns. All threads work on a long text, each on a part.

use super::commented_out::is_commented_out;
use super::directive::is_directive;
use super::lexer::{Token, TokenKind, Tokens};
use crate::parallel;

/// The tokens of a text; for the significant ones also their values, and whether they begin lines, in columns.
#[derive(Debug, Default)]
pub(super) struct Lexed {
    /// All tokens.
    pub tokens: Vec<Token>,
    /// The significant ones.
    pub sigs: Vec<Sig>,
    /// The value of each token in `sigs`; NaN for a token that is no number.
    pub values: Vec<f64>,
    /// Indices into `sigs` of the tokens that are neither integers nor reals, ascending.
    odd: Vec<u32>,
    /// Indices into `sigs` of each `0` that begins a [commented out](super::commented_out) line, ascending.
    out: Vec<u32>,
    /// Whether the text has a comment.
    pub has_comment: bool,
    /// Whether the text has a separator.
    pub has_separator: bool,
    /// Whether the text has a word.
    pub has_word: bool,
    /// Whether the text has a comment over several lines.
    pub has_long_comment: bool,
    /// Whether the text has a comment that nobody closes.
    pub has_unclosed: bool,
    /// Whether the text has a token that is wrong everywhere: a malformed or huge number, a decimal comma, or mere
    /// signs.
    pub has_bad: bool,
    /// Whether a comment is meant for zpg.
    pub has_directive: bool,
    /// Whether no significant token has come since the last line break.
    at_line_start: bool,
}

/// A significant token: its index among all tokens, and whether it is the first one of its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sig(u32);

impl Sig {
    /// The flag of the first token of a line. An index never reaches this bit: a file has fewer than 2³¹ bytes, and so
    /// fewer tokens.
    const STARTS_LINE: u32 = 1 << 31;

    fn new(index: usize, starts_line: bool) -> Sig {
        Sig(index as u32 | if starts_line { Sig::STARTS_LINE } else { 0 })
    }

    /// The index among all tokens.
    pub(super) fn token(self) -> u32 {
        self.0 & !Sig::STARTS_LINE
    }

    pub(super) fn starts_line(self) -> bool {
        self.0 & Sig::STARTS_LINE != 0
    }
}

impl Lexed {
    /// Cuts a text into tokens and reads its numbers. For `unclosed` see [`lex`](super::lexer::lex).
    pub(super) fn new(text: &str, unclosed: &[u32]) -> Lexed {
        let parts = parallel::parts(text.len());
        if parts > 1
            && unclosed.is_empty()
            && let Some(lexed) = Lexed::in_parts(text, &lines_near(text, parts))
        {
            return lexed;
        }
        Lexed::part(text, 0, unclosed, text.len())
    }

    /// Cuts a text in parts on all threads. The parts end at the byte offsets `ends`, behind line breaks. `None` if a
    /// part ends inside of a comment.
    fn in_parts(text: &str, ends: &[usize]) -> Option<Lexed> {
        let mut parts = parallel::map(ends.len(), |i| {
            let start = if i == 0 { 0 } else { ends[i - 1] };
            // The first part has room for the whole text, since the others are appended to it.
            let room = if i == 0 { text.len() } else { ends[i] - start };
            Lexed::part(&text[..ends[i]], start, &[], room)
        })
        .into_iter();
        let mut lexed = parts.next()?;
        for part in parts {
            // A comment that is open at the end of a part may be closed in the next part.
            if lexed.has_unclosed {
                return None;
            }
            lexed.append(part);
        }
        Some(lexed)
    }

    /// Cuts a text into tokens, from byte `start`, where a line begins, to its end. Reserves memory for the tokens of
    /// `room` bytes.
    fn part(text: &str, start: usize, unclosed: &[u32], room: usize) -> Lexed {
        let mut lexed = Lexed {
            tokens: Vec::with_capacity(room / 4),
            sigs: Vec::with_capacity(room / 5),
            values: Vec::with_capacity(room / 5),
            at_line_start: true,
            ..Lexed::default()
        };
        let mut tokens = Tokens::starting_at(text, start, unclosed);
        while let Some((token, value)) = tokens.next_valued() {
            lexed.push(text, token, value);
        }
        lexed
    }

    /// Appends the tokens of the next part of the text.
    fn append(&mut self, mut part: Lexed) {
        let (tokens, sigs) = (self.tokens.len() as u32, self.sigs.len() as u32);
        self.odd.extend(part.odd.iter().map(|i| i + sigs));
        self.out.extend(part.out.iter().map(|i| i + sigs));
        // Most of the time goes into memory that is touched for the first time. Two threads share it.
        let moved = part.sigs.iter().map(|sig| Sig(sig.0 + tokens));
        parallel::both(
            || self.tokens.append(&mut part.tokens),
            || {
                self.sigs.extend(moved);
                self.values.append(&mut part.values);
            },
        );
        self.has_comment |= part.has_comment;
        self.has_separator |= part.has_separator;
        self.has_word |= part.has_word;
        self.has_long_comment |= part.has_long_comment;
        self.has_unclosed |= part.has_unclosed;
        self.has_bad |= part.has_bad;
        self.has_directive |= part.has_directive;
        self.at_line_start = part.at_line_start;
    }

    /// Makes the columns for tokens that exist already.
    pub(super) fn of(text: &str, tokens: Vec<Token>) -> Lexed {
        let mut lexed = Lexed {
            tokens: Vec::with_capacity(tokens.len()),
            at_line_start: true,
            ..Lexed::default()
        };
        for token in tokens {
            let value = token.number(text).unwrap_or(f64::NAN);
            lexed.push(text, token, value);
        }
        lexed
    }

    #[inline(always)]
    fn push(&mut self, text: &str, token: Token, value: f64) {
        let index = self.tokens.len();
        self.tokens.push(token);
        match token.kind() {
            TokenKind::Newline => self.at_line_start = true,
            kind @ (TokenKind::Comment | TokenKind::UnterminatedComment) => {
                self.has_directive |= is_directive(&token, text);
                if kind == TokenKind::UnterminatedComment {
                    self.has_unclosed = true;
                } else {
                    let comment = &text.as_bytes()[token.span().range()];
                    self.has_comment = true;
                    self.has_long_comment |= memchr::memchr2(b'\n', b'\r', comment).is_some();
                    let head = self.sigs.last().filter(|sig| {
                        let is_zero = self.values.last() == Some(&0.0);
                        is_zero && sig.starts_line() && sig.token() as usize + 1 == index
                    });
                    if head.is_some() && is_commented_out(&text[token.span().range()]) {
                        self.out.push(self.sigs.len() as u32 - 1);
                    }
                }
            }
            TokenKind::Separator => self.has_separator = true,
            TokenKind::ByteOrderMark => {}
            kind => {
                if !matches!(kind, TokenKind::Integer | TokenKind::Real) {
                    self.odd.push(self.sigs.len() as u32);
                    self.has_word |= matches!(kind, TokenKind::Word | TokenKind::Invalid);
                    self.has_bad |= !matches!(kind, TokenKind::Word | TokenKind::Quoted);
                }
                self.sigs.push(Sig::new(index, self.at_line_start));
                self.values.push(value);
                self.at_line_start = false;
            }
        }
    }

    /// Whether significant tokens `from..to` are plain numbers, all of them.
    pub(super) fn all_numbers(&self, from: usize, to: usize) -> bool {
        let next = self.odd.partition_point(|&i| (i as usize) < from);
        self.odd.get(next).is_none_or(|&i| i as usize >= to)
    }

    /// Whether a line that is commented out begins among significant tokens `from..to`. A record does not go on across
    /// that line.
    #[inline]
    pub(super) fn goes_out(&self, from: usize, to: usize) -> bool {
        let next = self.out.partition_point(|&i| (i as usize) < from);
        self.out.get(next).is_some_and(|&i| (i as usize) < to)
    }
}

/// The byte offsets at which the parts of a text end, if it is cut into about `parts` parts of equal length. Each is
/// behind a line break outside of comments, provided that every `#` opens or closes a comment. The last offset is the
/// end of the text.
fn lines_near(text: &str, parts: usize) -> Vec<usize> {
    let bytes = text.as_bytes();
    let mut ends: Vec<usize> = Vec::with_capacity(parts);
    let (mut at, mut in_comment) = (0, false);
    for part in 1..parts {
        let near = (text.len() / parts * part).max(at);
        in_comment ^= memchr::memchr_iter(b'#', &bytes[at..near]).count() % 2 == 1;
        let end = memchr::memchr2_iter(b'#', b'\n', &bytes[near..]).find(|&i| {
            in_comment ^= bytes[near + i] == b'#';
            bytes[near + i] == b'\n' && !in_comment
        });
        let Some(end) = end else { break };
        at = near + end + 1;
        ends.push(at);
    }
    ends.push(text.len());
    ends
}

#[cfg(test)]
mod tests;
