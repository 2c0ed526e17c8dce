//! Text to tokens. Comments, line breaks and stray separators are tokens too, so that the text can
//! be printed again; only plain white space is left out, as what lies between the tokens.

use logos::Logos;

use crate::diagnostics::Span;

/// What a token is. Everything that is not [`TokenKind::is_trivia`] takes part in records.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum TokenKind {
    /// `[+-]? digits`, of any length.
    Integer,
    /// Any other number.
    Real,
    /// `0,5`: read as a number, reported as E003.
    DecimalComma,
    /// A number too large for a double.
    HugeNumber,
    /// A word that begins like a number, or spells an infinity or NaN.
    MalformedNumber,
    /// Any other word with a letter or digit in it.
    Word,
    /// A word of signs only.
    Invalid,
    /// `"…"`, a file name.
    Quoted,
    /// `# … #`.
    Comment,
    /// A comment that is taken to end with its line.
    UnterminatedComment,
    /// `, ; < > ( ) { }`: read as white space.
    Separator,
    Newline,
    /// U+FEFF at the start of the text.
    ByteOrderMark,
}

impl TokenKind {
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

/// Twelve bytes: a kind and a stretch of the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    pub kind: TokenKind,
    pub start: u32,
    pub len: u32,
}

impl Token {
    fn new(kind: TokenKind, start: usize, end: usize) -> Token {
        Token {
            kind,
            start: start as u32,
            len: (end - start) as u32,
        }
    }

    pub fn end(&self) -> u32 {
        self.start + self.len
    }

    pub fn span(&self) -> Span {
        Span::new(self.start, self.end())
    }

    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        source
            .get(self.start as usize..self.end() as usize)
            .unwrap_or("")
    }

    /// The value of an [`TokenKind::Integer`], cut off at the limits of `i64`.
    pub fn integer(&self, source: &str) -> Option<i64> {
        if self.kind != TokenKind::Integer {
            return None;
        }
        let text = self.text(source);
        Some(text.parse().unwrap_or(if text.starts_with('-') {
            i64::MIN
        } else {
            i64::MAX
        }))
    }

    /// The value of an [`TokenKind::Integer`] that fits, as IDs, types and counts do.
    pub fn int(&self, source: &str) -> Option<i32> {
        match self.kind {
            TokenKind::Integer => self.text(source).parse().ok(),
            _ => None,
        }
    }

    /// The value of a number; a decimal comma counts as a point. `None` for everything else.
    pub fn number(&self, source: &str) -> Option<f64> {
        let text = self.text(source);
        match self.kind {
            TokenKind::Integer | TokenKind::Real => text.parse().ok(),
            TokenKind::DecimalComma => text.replace(',', ".").parse().ok(),
            _ => None,
        }
    }
}

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
    #[regex(r"[,;<>(){}]")]
    Separator,
    /// Its end is found by hand: where it is depends on the comments before.
    #[token("#", comment)]
    Comment(bool),
    #[regex(r##"[^\p{White_Space}#,;<>(){}"]+"##, priority = 1)]
    #[token("\"", priority = 1)]
    Word,
    // Only there to carry the lifetime of the extras.
    #[allow(dead_code)]
    Never(&'s ()),
}

/// Offsets of the `#` that open a comment nobody closes, ascending; the lexer walks along them.
#[derive(Debug, Clone, Copy, Default)]
struct Unclosed<'s>(&'s [u32]);

/// Runs to the closing `#`, or to the end of the line where there is none; says which.
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
/// that ends with its line (see [`super::comments`]).
pub fn lex(text: &str, unclosed: &[u32]) -> Vec<Token> {
    let mut tokens = Vec::with_capacity(text.len() / 4);
    tokens.extend(Tokens::new(text, unclosed));
    tokens
}

/// The tokens of a text, one after another.
pub struct Tokens<'s> {
    text: &'s str,
    /// How far the text is cut; `raw` may lag behind.
    at: usize,
    raw: logos::Lexer<'s, Raw<'s>>,
    /// The comma behind an integer.
    comma: Option<Token>,
    /// Where the last separator ends.
    separated: usize,
}

impl<'s> Tokens<'s> {
    /// For `unclosed` see [`lex`].
    pub fn new(text: &'s str, unclosed: &'s [u32]) -> Tokens<'s> {
        Tokens {
            text,
            at: 0,
            raw: Raw::lexer_with_extras(text, Unclosed(unclosed)),
            comma: None,
            separated: usize::MAX,
        }
    }

    /// The next token, if it is what most are: a line break, or a number without an exponent between
    /// white space. It is what the automaton would say, and sooner.
    fn plain(&mut self) -> Option<Token> {
        let bytes = self.text.as_bytes();
        let byte = |i: usize| bytes.get(i).copied();
        let mut at = self.at;
        while let Some(b' ' | b'\t') = byte(at) {
            at += 1;
        }
        self.at = at;
        let start = at;
        let kind = match byte(at)? {
            b'\n' => {
                at += 1;
                TokenKind::Newline
            }
            b'\r' => {
                at += if byte(at + 1) == Some(b'\n') { 2 } else { 1 };
                TokenKind::Newline
            }
            b'0'..=b'9' | b'+' | b'-' | b'.' => {
                let digits = |from: usize| {
                    let rest = bytes.get(from..).unwrap_or_default();
                    rest.iter().take_while(|b| b.is_ascii_digit()).count()
                };
                at += usize::from(matches!(bytes[at], b'+' | b'-'));
                let mut count = digits(at);
                at += count;
                let mut kind = TokenKind::Integer;
                if byte(at) == Some(b'.') {
                    let fraction = digits(at + 1);
                    at += 1 + fraction;
                    count += fraction;
                    kind = TokenKind::Real;
                }
                let ends = matches!(byte(at), None | Some(b' ' | b'\t' | b'\n' | b'\r' | b'#'));
                if count == 0 || !ends || at - start >= SURELY_FINITE {
                    return None;
                }
                kind
            }
            _ => return None,
        };
        self.at = at;
        Some(Token::new(kind, start, at))
    }
}

/// A number of fewer characters and no exponent is finite.
const SURELY_FINITE: usize = 300;

impl Iterator for Tokens<'_> {
    type Item = Token;

    fn next(&mut self) -> Option<Token> {
        if let Some(comma) = self.comma.take() {
            return Some(comma);
        }
        self.plain().or_else(|| self.other())
    }
}

impl Tokens<'_> {
    /// The next token, whatever it is.
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
                        // Lex again from the comma on: what follows it may be longer than it looked.
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
                    if span.start == 0 && slice.starts_with('\u{feff}') {
                        self.at = '\u{feff}'.len_utf8();
                        self.raw = Raw::lexer_with_extras(self.text, self.raw.extras);
                        return Some(Token::new(TokenKind::ByteOrderMark, 0, self.at));
                    }
                    word(slice)
                }
            };
            return Some(Token::new(kind, span.start, span.end));
        }
    }
}

/// The given kind for a number that fits a double.
fn finite(text: &str, kind: TokenKind) -> TokenKind {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() => kind,
        _ => TokenKind::HugeNumber,
    }
}

/// Tells words that were meant as numbers from other words and from mere signs.
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
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        lex(text, &[]).iter().map(|t| t.kind).collect()
    }

    #[test]
    fn numbers_and_near_numbers() {
        use TokenKind::*;
        assert_eq!(
            kinds("1 +2 -3. .5 1.5e-3 2E5 1e 1.2.3 1.5abc 0x10 --1 nan -inf 5- @5"),
            [
                Integer,
                Integer,
                Real,
                Real,
                Real,
                Real,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
                MalformedNumber,
            ]
        );
        assert_eq!(
            kinds("1e999 @ $! wood.png \"a b.png\""),
            [HugeNumber, Invalid, Invalid, Word, Quoted]
        );
        assert_eq!(kinds(&"9".repeat(2_000_000)), [HugeNumber]);
        assert_eq!(kinds("01.png \u{feff}"), [MalformedNumber, Invalid]);
    }

    #[test]
    fn commas() {
        use TokenKind::*;
        assert_eq!(kinds("0,5 -1,25e3"), [DecimalComma, DecimalComma]);
        assert_eq!(
            kinds("1,2,3"),
            [Integer, Separator, Integer, Separator, Integer]
        );
        assert_eq!(kinds("1, 2"), [Integer, Separator, Integer]);
        assert_eq!(kinds("1,5.25"), [Integer, Separator, Real]);
        assert_eq!(kinds("1.5,2.5"), [Real, Separator, Real]);
        assert_eq!(
            kinds("<0,5>"),
            [Separator, Integer, Separator, Integer, Separator]
        );
    }

    #[test]
    fn comments() {
        use TokenKind::*;
        assert_eq!(kinds("0 # a\nb # 1"), [Integer, Comment, Integer]);
        assert_eq!(
            kinds("0 # a\n1"),
            [Integer, UnterminatedComment, Newline, Integer]
        );
        let text = "2 # a\n3 # b #";
        assert_eq!(
            lex(text, &[2]).iter().map(|t| t.kind).collect::<Vec<_>>(),
            [Integer, UnterminatedComment, Newline, Integer, Comment]
        );
    }

    proptest::proptest! {
        /// The short way says what the automaton says.
        #[test]
        fn plain_tokens_are_those_of_the_automaton(text in "[0-9+.,eE# \\n\\r\\t\\-\"x]{0,40}") {
            let mut tokens = Tokens::new(&text, &[]);
            let automaton: Vec<Token> =
                std::iter::from_fn(|| tokens.comma.take().or_else(|| tokens.other())).collect();
            proptest::prop_assert_eq!(lex(&text, &[]), automaton);
        }
    }

    #[test]
    fn byte_order_mark_and_odd_spaces() {
        use TokenKind::*;
        assert_eq!(
            kinds("\u{feff}2\u{a0}9 1"),
            [ByteOrderMark, Integer, Integer, Integer]
        );
    }

    #[test]
    fn millions_of_comments_need_no_stack() {
        assert_eq!(lex(&"##".repeat(1_000_000), &[]).len(), 1_000_000);
    }
}
