//! Text to tokens. Comments, line breaks and stray separators are tokens too, so that the text can
//! be printed again; only plain white space is left out, as what lies between the tokens.

use std::fmt;

use logos::Logos;

use crate::diagnostics::Span;
use crate::parallel;

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
    /// `, ; < > ( ) { }`, and `⟨ ⟩` as the handout prints them (and `〈 〉 ‹ ›`): read as white space.
    Separator,
    Newline,
    /// U+FEFF at the start of the text.
    ByteOrderMark,
}

impl TokenKind {
    /// In the order of their numbers.
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
    /// The kind above [`LENGTH_BITS`], the length below.
    packed: u32,
}

const LENGTH_BITS: u32 = 28;

impl Token {
    /// No token of a scene is as long, 256 MiB; [`recognise`](super::recognise) sees to that, by [`too_long`]. Longer
    /// ones are cut off here.
    pub const LENGTH_MAX: usize = (1 << LENGTH_BITS) - 1;

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

    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        source
            .get(self.start as usize..self.end() as usize)
            .unwrap_or("")
    }

    /// The value of an [`TokenKind::Integer`], cut off at the limits of `i64`.
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

    /// The value of an [`TokenKind::Integer`] that fits, as IDs, types and counts do.
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
    #[regex(r"[,;<>(){}⟨⟩〈〉〈〉‹›]")]
    Separator,
    /// Its end is found by hand: where it is depends on the comments before.
    #[token("#", comment)]
    Comment(bool),
    #[regex(r##"[^\p{White_Space}#,;<>(){}⟨⟩〈〉〈〉‹›"]+"##, priority = 1)]
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

/// A text's tokens, and of the significant ones what every reader asks for, in columns.
#[derive(Debug, Default)]
pub struct Lexed {
    /// All tokens.
    pub tokens: Vec<Token>,
    /// The significant ones.
    pub sigs: Vec<Sig>,
    /// Their values, as long as `sigs`; NaN where one is no number.
    pub values: Vec<f64>,
    /// The significant tokens that are no plain numbers, ascending.
    odd: Vec<u32>,
    /// There is a comment, a separator, a word, a comment over several lines, a comment that nobody closes, a token that can never be
    /// right.
    pub has_comment: bool,
    pub has_separator: bool,
    pub has_word: bool,
    pub has_long_comment: bool,
    pub has_unclosed: bool,
    pub has_bad: bool,
    /// No significant token has come since the last line break.
    at_line_start: bool,
}

/// A significant token: its index among all tokens, and whether it is the first one of its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sig(u32);

impl Sig {
    /// A file has fewer than 2³¹ bytes, and so fewer tokens.
    const STARTS_LINE: u32 = 1 << 31;

    fn new(index: usize, starts_line: bool) -> Sig {
        Sig(index as u32 | if starts_line { Sig::STARTS_LINE } else { 0 })
    }

    /// The index among all tokens.
    pub fn token(self) -> u32 {
        self.0 & !Sig::STARTS_LINE
    }

    pub fn starts_line(self) -> bool {
        self.0 & Sig::STARTS_LINE != 0
    }
}

impl Lexed {
    /// Cuts a text and reads its numbers. For `unclosed` see [`lex`]. A long text is cut by all threads.
    pub fn new(text: &str, unclosed: &[u32]) -> Lexed {
        let threads = rayon::current_num_threads().min(text.len() / PART_MIN);
        if threads > 1
            && unclosed.is_empty()
            && let Some(lexed) = Lexed::in_parts(text, &lines_near(text, threads))
        {
            return lexed;
        }
        Lexed::part(text, 0, unclosed, text.len())
    }

    /// A text that is cut in parts, which end at `ends`, behind line breaks. `None` if one of those is in a comment.
    fn in_parts(text: &str, ends: &[usize]) -> Option<Lexed> {
        let mut parts = parallel::map(ends.len(), |i| {
            let start = if i == 0 { 0 } else { ends[i - 1] };
            // The first part takes in the others.
            let room = if i == 0 { text.len() } else { ends[i] - start };
            Lexed::part(&text[..ends[i]], start, &[], room)
        })
        .into_iter();
        let mut lexed = parts.next()?;
        for part in parts {
            // What is open at the end of a part may be closed in the next one.
            if lexed.has_unclosed {
                return None;
            }
            lexed.append(part);
        }
        Some(lexed)
    }

    /// Cuts a text from the start of a line to its end, with room for the tokens of so many bytes.
    fn part(text: &str, start: usize, unclosed: &[u32], room: usize) -> Lexed {
        let mut lexed = Lexed {
            tokens: Vec::with_capacity(room / 4),
            sigs: Vec::with_capacity(room / 5),
            values: Vec::with_capacity(room / 5),
            at_line_start: true,
            ..Lexed::default()
        };
        let mut tokens = Tokens::from(text, start, unclosed);
        loop {
            // Most tokens are plain numbers.
            let (token, value) = match tokens.comma {
                None => match tokens.plain() {
                    Some(found) => found,
                    None => match tokens.other() {
                        Some(token) => (token, token.number(text).unwrap_or(f64::NAN)),
                        None => break,
                    },
                },
                Some(comma) => {
                    tokens.comma = None;
                    (comma, f64::NAN)
                }
            };
            lexed.push(text, token, value);
        }
        lexed
    }

    /// Takes in the tokens that follow.
    fn append(&mut self, mut part: Lexed) {
        let (tokens, sigs) = (self.tokens.len() as u32, self.sigs.len() as u32);
        self.tokens.append(&mut part.tokens);
        self.sigs
            .extend(part.sigs.iter().map(|sig| Sig(sig.0 + tokens)));
        self.values.append(&mut part.values);
        self.odd.extend(part.odd.iter().map(|i| i + sigs));
        self.has_comment |= part.has_comment;
        self.has_separator |= part.has_separator;
        self.has_word |= part.has_word;
        self.has_long_comment |= part.has_long_comment;
        self.has_unclosed |= part.has_unclosed;
        self.has_bad |= part.has_bad;
        self.at_line_start = part.at_line_start;
    }

    /// The columns of tokens that were cut before.
    pub fn of(text: &str, tokens: Vec<Token>) -> Lexed {
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
            TokenKind::Comment => {
                let comment = &text.as_bytes()[token.span().range()];
                self.has_comment = true;
                self.has_long_comment |= memchr::memchr2(b'\n', b'\r', comment).is_some();
            }
            TokenKind::UnterminatedComment => self.has_unclosed = true,
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
    pub fn all_numbers(&self, from: usize, to: usize) -> bool {
        let next = self.odd.partition_point(|&i| (i as usize) < from);
        self.odd.get(next).is_none_or(|&i| i as usize >= to)
    }
}

/// A text is not cut in parts of fewer bytes.
const PART_MIN: usize = 1 << 18;

/// Where a text may be cut in so many parts of about the same length: behind line breaks that are in no comment, if
/// every `#` is one of a comment. The last one is the end of the text.
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
        Tokens::from(text, 0, unclosed)
    }

    /// From a place on, where a token begins.
    fn from(text: &'s str, at: usize, unclosed: &'s [u32]) -> Tokens<'s> {
        Tokens {
            text,
            at,
            raw: Raw::lexer_with_extras(text, Unclosed(unclosed)),
            comma: None,
            separated: usize::MAX,
        }
    }

    /// The next token and its value, if it is what most are: a line break, a comment that is closed, or a
    /// number without an exponent between white space. It is what the automaton would say, and sooner.
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
        // Both are exact, and so the quotient is rounded once (W. D. Clinger, How to read floating point
        // numbers accurately, PLDI 1990).
        let value = if count <= EXACT_DIGITS && decimals < POWERS.len() {
            let magnitude = digits as f64 / POWERS[decimals];
            if first == b'-' { -magnitude } else { magnitude }
        } else {
            self.text[start..at].parse().unwrap_or(f64::NAN)
        };
        Some((Token::new(kind, start, at), value))
    }
}

/// Numbers of so many digits are less than 2⁵³.
const EXACT_DIGITS: usize = 15;

/// Powers of ten; those up to 10²² are exact.
const POWERS: [f64; 16] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
];

/// A number of fewer characters and no exponent is finite.
const SURELY_FINITE: usize = 300;

impl Iterator for Tokens<'_> {
    type Item = Token;

    fn next(&mut self) -> Option<Token> {
        if let Some(comma) = self.comma.take() {
            return Some(comma);
        }
        match self.plain() {
            Some((token, _)) => Some(token),
            None => self.other(),
        }
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
mod tests;
