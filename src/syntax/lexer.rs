//! Text to tokens.
use crate::diagnostics::Span;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum TokenKind {
    Integer,
    Real,
    Word,
    Comment,
    Newline,
}
impl TokenKind {
    pub fn is_trivia(self) -> bool {
        matches!(self, TokenKind::Comment | TokenKind::Newline)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    pub kind: TokenKind,
    pub start: u32,
    pub len: u32,
}
impl Token {
    pub fn span(&self) -> Span {
        Span::new(self.start, self.start + self.len)
    }
    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        &source[self.start as usize..(self.start + self.len) as usize]
    }
}
