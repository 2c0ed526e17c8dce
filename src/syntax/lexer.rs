//! Text to tokens. Comments, line breaks and stray separators are tokens too, so that the text can be printed again.
//! Only plain white space has no tokens: it is the text between them.

use std::fmt;

use logos::Logos;

use crate::diagnostics::Span;

/// The kind of a token. Everything that is not [`TokenKind::is_trivia`] takes part in records.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum TokenKind {
    /// `[+-]? digits`, of any length.
    Integer,
    /// A number of any other kind.
    Real,
    /// `0,5`: read as a number, reported as E003.
    DecimalComma,
    /// A number too large for a double.
    HugeNumber,
    /// A word that begins like a number, or spells an infinity or NaN.
    MalformedNumber,
    /// A word of any other kind, with a letter or digit in it.
    Word,
    /// A word of signs only.
    Invalid,
    /// `"…"`, a file name.
    Quoted,
    /// `# … #`.
    Comment,
    /// A comment without a closing `#`, which is taken to end with its line.
    UnterminatedComment,
    /// A separator, one of [`SEPARATORS`], read as white space.
    Separator,
    Newline,
    /// U+FEFF at the start of the text or of a line: a file began there before several were joined.
    ByteOrderMark,
}

impl TokenKind {
    /// All kinds in the order of their numbers.
    const ALL: [TokenKind; 13] = [
        TokenKind::Integer,
        TokenKind::Real,
        TokenKind::DecimalComma,
        TokenKind::HugeNumber,
        TokenKind::MalformedNumber,
        TokenKind::Word,
        TokenKind::Invalid,
        TokenKind::Quoted,
        TokenKind::Comment,
        TokenKind::UnterminatedComment,
        TokenKind::Separator,
        TokenKind::Newline,
        TokenKind::ByteOrderMark,
    ];

    pub fn is_trivia(self) -> bool {
        matches!(
            self,
            TokenKind::Comment
                | TokenKind::UnterminatedComment
                | TokenKind::Separator
                | TokenKind::Newline
                | TokenKind::ByteOrderMark
        )
    }

    /// Whether the token is a number, or begins like one.
    pub fn is_numeric(self) -> bool {
        matches!(
            self,
            TokenKind::Integer
                | TokenKind::Real
                | TokenKind::DecimalComma
                | TokenKind::HugeNumber
                | TokenKind::MalformedNumber
        )
    }

    pub fn is_comment(self) -> bool {
        matches!(self, TokenKind::Comment | TokenKind::UnterminatedComment)
    }

    /// Whether the token has a value that can be used as a number.
    pub fn is_number(self) -> bool {
        matches!(
            self,
            TokenKind::Integer | TokenKind::Real | TokenKind::DecimalComma
        )
    }

    /// Whether the token can never be right, except perhaps as a file name.
    pub fn is_bad(self) -> bool {
        matches!(
            self,
            TokenKind::DecimalComma
                | TokenKind::HugeNumber
                | TokenKind::MalformedNumber
                | TokenKind::Word
                | TokenKind::Invalid
                | TokenKind::Quoted
        )
    }
}

/// A kind and a place in the text, in eight bytes: a large file has millions of tokens.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Token {
    pub start: u32,
    /// The number of the kind above the lowest [`LENGTH_BITS`] bits, the length in bytes in those.
    packed: u32,
}

const LENGTH_BITS: u32 = 28;

impl Token {
    /// The greatest length that a token can store, 256 MiB less a byte. Longer tokens are cut off at this length, and
    /// [`recognise`](super::recognise) refuses a text that has a token of this length, by [`too_long`].
    pub const LENGTH_MAX: usize = (1 << LENGTH_BITS) - 1;

    #[inline]
    pub fn new(kind: TokenKind, start: usize, end: usize) -> Token {
        Token {
            start: start as u32,
            packed: (kind as u32) << LENGTH_BITS | (end - start).min(Token::LENGTH_MAX) as u32,
        }
    }

    #[inline(always)]
    pub fn kind(self) -> TokenKind {
        TokenKind::ALL[(self.packed >> LENGTH_BITS) as usize]
    }

    pub fn length(self) -> u32 {
        self.packed & Token::LENGTH_MAX as u32
    }

    pub fn end(self) -> u32 {
        self.start + self.length()
    }

    pub fn span(&self) -> Span {
        Span::new(self.start, self.end())
    }

    #[inline]
    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        source
            .get(self.start as usize..self.end() as usize)
            .unwrap_or("")
    }

    /// The value of an [`TokenKind::Integer`], clamped to the limits of `i64`.
    pub fn integer(&self, source: &str) -> Option<i64> {
        if self.kind() != TokenKind::Integer {
            return None;
        }
        let text = self.text(source);
        Some(text.parse().unwrap_or(if text.starts_with('-') {
            i64::MIN
        } else {
            i64::MAX
        }))
    }

    /// The value of an [`TokenKind::Integer`] that fits into `i32`, the range of IDs, types and counts.
    pub fn int(&self, source: &str) -> Option<i32> {
        match self.kind() {
            TokenKind::Integer => self.text(source).parse().ok(),
            _ => None,
        }
    }

    /// The value of a number; a decimal comma counts as a point. `None` for everything else.
    pub fn number(&self, source: &str) -> Option<f64> {
        let text = self.text(source);
        match self.kind() {
            TokenKind::Integer | TokenKind::Real => text.parse().ok(),
            TokenKind::DecimalComma => text.replace(',', ".").parse().ok(),
            _ => None,
        }
    }
}

impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} {:?}", self.kind(), self.span().range())
    }
}

/// The punctuation marks of the handout's table notation, and characters that look like them. Code points stand here
/// for the characters, since Unicode normalisation would replace some. The regular expressions below list the same
/// ones.
#[rustfmt::skip]
pub const SEPARATORS: &[char] = &[
    ',', ';', '<', '>', '(', ')', '[', ']', '{', '}',
    // Angle brackets of the handout, of mathematics, of technical and of East Asian texts.
    '\u{27E8}', '\u{27E9}', '\u{2329}', '\u{232A}', '\u{3008}', '\u{3009}',
    // Double angle brackets.
    '\u{27EA}', '\u{27EB}', '\u{300A}', '\u{300B}',
    // Quotation marks in the form of angle brackets.
    '\u{2039}', '\u{203A}', '\u{AB}', '\u{BB}',
    // Ornaments.
    '\u{276C}', '\u{276D}', '\u{276E}', '\u{276F}', '\u{2770}', '\u{2771}',
    // Full-width and small signs: less and greater, parentheses, square brackets, braces.
    '\u{FF1C}', '\u{FF1E}', '\u{FE64}', '\u{FE65}',
    '\u{FF08}', '\u{FF09}', '\u{FE59}', '\u{FE5A}',
    '\u{FF3B}', '\u{FF3D}', '\u{FF5B}', '\u{FF5D}', '\u{FE5B}', '\u{FE5C}',
    // Commas: full-width, small, ideographic.
    '\u{FF0C}', '\u{FE50}', '\u{3001}',
    // Semicolons: full-width, small, and the Greek question mark.
    '\u{FF1B}', '\u{FE54}', '\u{37E}',
];

#[derive(Logos, Debug, Clone, Copy, PartialEq)]
#[logos(extras = Unclosed<'s>)]
enum Raw<'s> {
    #[regex(r"[\p{White_Space}--[\r\n]]+")]
    Space,
    #[regex(r"\r\n|\n|\r")]
    Newline,
    #[regex(r"[+-]?[0-9]+", priority = 20)]
    Integer,
    #[regex(r"[+-]?([0-9]+\.[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?", priority = 20)]
    #[regex(r"[+-]?[0-9]+[eE][+-]?[0-9]+", priority = 20)]
    Real,
    #[regex(r"[+-]?[0-9]+,[0-9]+([eE][+-]?[0-9]+)?", priority = 20)]
    DecimalComma,
    #[regex(r#""[^"\r\n]*""#, priority = 20)]
    Quoted,
    #[regex(r"[,;<>()\[\]{}\u{27E8}\u{27E9}\u{2329}\u{232A}\u{3008}\u{3009}\u{2039}\u{203A}\u{AB}\u{BB}\u{27EA}\u{27EB}\u{300A}\u{300B}\u{276C}\u{276D}\u{276E}\u{276F}\u{2770}\u{2771}\u{FF1C}\u{FF1E}\u{FE64}\u{FE65}\u{FF08}\u{FF09}\u{FE59}\u{FE5A}\u{FF3B}\u{FF3D}\u{FF5B}\u{FF5D}\u{FE5B}\u{FE5C}\u{FF0C}\u{FE50}\u{3001}\u{FF1B}\u{FE54}\u{37E}]")]
    Separator,
    /// A comment; the flag says whether it is closed. The function [`comment`] finds its end, which depends on the
    /// offsets of the unclosed ones.
    #[token("#", comment)]
    Comment(bool),
    #[regex(r##"[^\p{White_Space}#,;<>()\[\]{}\u{27E8}\u{27E9}\u{2329}\u{232A}\u{3008}\u{3009}\u{2039}\u{203A}\u{AB}\u{BB}\u{27EA}\u{27EB}\u{300A}\u{300B}\u{276C}\u{276D}\u{276E}\u{276F}\u{2770}\u{2771}\u{FF1C}\u{FF1E}\u{FE64}\u{FE65}\u{FF08}\u{FF09}\u{FE59}\u{FE5A}\u{FF3B}\u{FF3D}\u{FF5B}\u{FF5D}\u{FE5B}\u{FE5C}\u{FF0C}\u{FE50}\u{3001}\u{FF1B}\u{FE54}\u{37E}"]+"##, priority = 1)]
    #[token("\"", priority = 1)]
    Word,
    // This variant carries the lifetime of the extras. No text matches it.
    #[allow(dead_code)]
    Never(&'s ()),
}

/// Offsets of the `#` that open comments which nobody closes, ascending. The lexer drops those that it has passed.
#[derive(Debug, Clone, Copy, Default)]
struct Unclosed<'s>(&'s [u32]);

/// Skips a comment to the closing `#`, or to the end of the line where there is none; returns whether it is closed.
fn comment<'s>(lex: &mut logos::Lexer<'s, Raw<'s>>) -> bool {
    let start = lex.span().start as u32;
    while lex.extras.0.first().is_some_and(|&o| o < start) {
        lex.extras.0 = &lex.extras.0[1..];
    }
    let rest = lex.remainder();
    let line = |rest: &str| rest.find(['\r', '\n']).unwrap_or(rest.len());
    let (length, closed) = if lex.extras.0.first() == Some(&start) {
        (line(rest), false)
    } else {
        match rest.find('#') {
            Some(i) => (i + 1, true),
            None => (line(rest), false),
        }
    };
    lex.bump(length);
    closed
}

/// Cuts a text into tokens. `unclosed` are the offsets of the `#` that are taken to open a comment
/// that ends with its line (see [`recovery::comments`](super::recovery::comments)).
pub fn lex(text: &str, unclosed: &[u32]) -> Vec<Token> {
    let mut tokens = Vec::with_capacity(text.len() / 4);
    tokens.extend(Tokens::new(text, unclosed));
    tokens
}

/// The first token that is too long to be kept whole.
pub fn too_long(text: &str, unclosed: &[u32]) -> Option<Token> {
    if text.len() < Token::LENGTH_MAX {
        return None;
    }
    Tokens::new(text, unclosed).find(|t| t.length() as usize == Token::LENGTH_MAX)
}

/// The tokens of a text, one after another.
pub struct Tokens<'s> {
    text: &'s str,
    /// The byte up to which the text has been cut into tokens; `raw` may lag behind.
    at: usize,
    raw: logos::Lexer<'s, Raw<'s>>,
    /// The comma behind the integer that was returned last, if it is the next token.
    comma: Option<Token>,
    /// The byte at which the last separator ends.
    separated: usize,
}

impl<'s> Tokens<'s> {
    /// The tokens of a text. For `unclosed` see [`lex`].
    pub fn new(text: &'s str, unclosed: &'s [u32]) -> Tokens<'s> {
        Tokens::starting_at(text, 0, unclosed)
    }

    /// The tokens from byte `at` on, which must not be inside of a token.
    pub(super) fn starting_at(text: &'s str, at: usize, unclosed: &'s [u32]) -> Tokens<'s> {
        Tokens {
            text,
            at,
            raw: Raw::lexer_with_extras(text, Unclosed(unclosed)),
            comma: None,
            separated: usize::MAX,
        }
    }

    /// The next token and its value, NaN where it is no number.
    #[inline(always)]
    pub(super) fn next_valued(&mut self) -> Option<(Token, f64)> {
        match self.comma {
            // Most tokens are plain numbers.
            None => match self.plain() {
                Some(found) => Some(found),
                None => {
                    let token = self.other()?;
                    Some((token, token.number(self.text).unwrap_or(f64::NAN)))
                }
            },
            Some(comma) => {
                self.comma = None;
                Some((comma, f64::NAN))
            }
        }
    }

    /// A quick way to read the commonest tokens: a line break, a closed comment, or a number without an exponent that
    /// white space or a `#` follows. Returns the token and the value that the automaton would find; `None` for any
    /// other token.
    #[inline]
    fn plain(&mut self) -> Option<(Token, f64)> {
        let bytes = self.text.as_bytes();
        let byte = |i: usize| bytes.get(i).copied().unwrap_or(b'\n');
        let mut at = self.at;
        while let b' ' | b'\t' = byte(at) {
            at += 1;
        }
        self.at = at;
        let start = at;
        let first = *bytes.get(at)?;
        let newline = |end| (Token::new(TokenKind::Newline, start, end), f64::NAN);
        match first {
            b'\n' => {
                self.at = at + 1;
                return Some(newline(at + 1));
            }
            b'\r' => {
                self.at = at
                    + if bytes.get(at + 1) == Some(&b'\n') {
                        2
                    } else {
                        1
                    };
                return Some(newline(self.at));
            }
            b'#' if self.raw.extras.0.is_empty() => {
                self.at = at + 2 + memchr::memchr(b'#', &bytes[at + 1..])?;
                return Some((Token::new(TokenKind::Comment, start, self.at), f64::NAN));
            }
            b'0'..=b'9' | b'+' | b'-' | b'.' => {}
            _ => return None,
        }
        at += usize::from(matches!(first, b'+' | b'-'));
        let mut digits = 0u64;
        let from = at;
        while let d @ b'0'..=b'9' = byte(at) {
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(d - b'0'));
            at += 1;
        }
        let mut count = at - from;
        let mut kind = TokenKind::Integer;
        let mut decimals = 0;
        if byte(at) == b'.' {
            at += 1;
            let point = at;
            while let d @ b'0'..=b'9' = byte(at) {
                digits = digits.wrapping_mul(10).wrapping_add(u64::from(d - b'0'));
                at += 1;
            }
            decimals = at - point;
            count += decimals;
            kind = TokenKind::Real;
        }
        let ends = matches!(byte(at), b' ' | b'\t' | b'\n' | b'\r' | b'#');
        if count == 0 || !ends || at - start >= SURELY_FINITE {
            return None;
        }
        self.at = at;
        // The digits and the power of ten are exact, and so their quotient is rounded only once (W. D. Clinger, How to
        // read floating point numbers accurately, PLDI 1990).
        let value = if count <= EXACT_DIGITS && decimals < POWERS.len() {
            let magnitude = digits as f64 / POWERS[decimals];
            if first == b'-' { -magnitude } else { magnitude }
        } else {
            self.text[start..at].parse().unwrap_or(f64::NAN)
        };
        Some((Token::new(kind, start, at), value))
    }
}

/// Integers of at most this many digits are less than 2⁵³, and so exact as doubles.
const EXACT_DIGITS: usize = 15;

/// Powers of ten by their exponents. As doubles they are exact, like all powers up to 10²².
const POWERS: [f64; 16] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
];

/// A number without an exponent that has fewer characters than this is finite as a double.
const SURELY_FINITE: usize = 300;

impl Iterator for Tokens<'_> {
    type Item = Token;

    #[inline]
    fn next(&mut self) -> Option<Token> {
        self.next_valued().map(|(token, _)| token)
    }
}

impl Tokens<'_> {
    /// The next token of any kind, found by the automaton; `None` at the end of the text.
    fn other(&mut self) -> Option<Token> {
        loop {
            self.raw.bump(self.at - self.raw.span().end);
            let raw = self.raw.next()?;
            let span = self.raw.span();
            let slice = self.raw.slice();
            self.at = span.end;
            let kind = match raw {
                Ok(Raw::Space) => continue,
                Ok(Raw::Newline) => TokenKind::Newline,
                Ok(Raw::Integer) if slice.len() < SURELY_FINITE => TokenKind::Integer,
                Ok(Raw::Real) if slice.len() < SURELY_FINITE && !slice.contains(['e', 'E']) => {
                    TokenKind::Real
                }
                Ok(Raw::Integer) => finite(slice, TokenKind::Integer),
                Ok(Raw::Real) => finite(slice, TokenKind::Real),
                Ok(Raw::DecimalComma) => {
                    // A comma inside a longer list, such as `1,2,3`, separates; so does one before
                    // a number with a point of its own, `1,5.2`.
                    let before = self.separated == span.start;
                    let after = (self.raw.remainder())
                        .starts_with(|c: char| c != '#' && c != ';' && !c.is_whitespace());
                    if before || after {
                        // The automaton begins again at the comma: the number behind it may be longer than it looked.
                        let comma = span.start + slice.find(',').unwrap_or(0);
                        self.comma = Some(Token::new(TokenKind::Separator, comma, comma + 1));
                        (self.at, self.separated) = (comma + 1, comma + 1);
                        self.raw = Raw::lexer_with_extras(self.text, self.raw.extras);
                        return Some(Token::new(TokenKind::Integer, span.start, comma));
                    }
                    TokenKind::DecimalComma
                }
                Ok(Raw::Quoted) => TokenKind::Quoted,
                Ok(Raw::Separator) => {
                    self.separated = span.end;
                    TokenKind::Separator
                }
                Ok(Raw::Comment(true)) => TokenKind::Comment,
                Ok(Raw::Comment(false)) => TokenKind::UnterminatedComment,
                Ok(Raw::Word | Raw::Never(_)) | Err(()) => {
                    if slice.starts_with(MARK) && begins_a_file(&self.text[..span.start]) {
                        self.at = span.start + MARK.len_utf8();
                        self.raw = Raw::lexer_with_extras(self.text, self.raw.extras);
                        return Some(Token::new(TokenKind::ByteOrderMark, span.start, self.at));
                    }
                    word(slice)
                }
            };
            return Some(Token::new(kind, span.start, span.end));
        }
    }
}

/// The byte order mark that a file in Unicode may begin with.
const MARK: char = '\u{feff}';

/// Whether a file may begin right behind the text `before`: at the start, or where several files were joined line by
/// line.
fn begins_a_file(before: &str) -> bool {
    before.is_empty() || before.ends_with(['\n', '\r', MARK])
}

/// Returns `kind` for a number that is finite as a double, else [`TokenKind::HugeNumber`].
fn finite(text: &str, kind: TokenKind) -> TokenKind {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() => kind,
        _ => TokenKind::HugeNumber,
    }
}

/// The kind of a word: one that was meant as a number, another word with letters, or mere signs.
fn word(text: &str) -> TokenKind {
    let unsigned = text.trim_start_matches(['+', '-', '−', '–', '.']);
    let letters = unsigned.to_ascii_lowercase();
    let has_letters = text.chars().any(|c| c.is_alphabetic() || c == '_');
    let has_digits = text.contains(|c: char| c.is_ascii_digit());
    if unsigned.starts_with(|c: char| c.is_ascii_digit())
        || (has_digits && !has_letters)
        || matches!(letters.as_str(), "nan" | "inf" | "infinity")
    {
        TokenKind::MalformedNumber
    } else if has_letters {
        TokenKind::Word
    } else {
        TokenKind::Invalid
    }
}

#[cfg(test)]
mod tests;
