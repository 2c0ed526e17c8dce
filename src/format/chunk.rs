//! A scene cut into chunks: what stands together on a line, or on several where a record or a
//! comment goes on.

use std::ops::Range;

use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::{Document, Item};

/// A record, or a comment between records.
pub struct Element {
    pub piece: Piece,
    /// Bytes of the text.
    pub start: usize,
    pub end: usize,
    /// To be printed as it is: it could not be read in full.
    pub frozen: bool,
}

pub enum Piece {
    Item(Item),
    /// A comment, by its token.
    Comment(u32),
    /// A token that belongs to no item.
    Unread(u32),
}

/// Neighbours without a line break between them.
pub struct Chunk {
    /// At least one.
    pub elements: Vec<Element>,
}

impl Chunk {
    /// From its first to its last character.
    pub fn span(&self) -> Range<usize> {
        let start = self.elements.first().map_or(0, |e| e.start);
        let end = self.elements.last().map_or(0, |e| e.end);
        start..end
    }

    /// Whether its layout may bear witness to what was meant.
    pub fn is_frozen(&self) -> bool {
        self.elements.iter().any(|e| e.frozen)
    }

    pub fn items(&self) -> impl Iterator<Item = &Item> {
        self.elements.iter().filter_map(|e| match &e.piece {
            Piece::Item(item) => Some(item),
            Piece::Comment(_) | Piece::Unread(_) => None,
        })
    }

    /// Its lines with all white space, but for the last line break.
    pub fn whole_lines(&self, text: &str) -> Range<usize> {
        let Range { start, end } = self.span();
        let mark = match text.starts_with(super::BYTE_ORDER_MARK) {
            true => super::BYTE_ORDER_MARK.len_utf8(),
            false => 0,
        };
        let start = text[..start].rfind(BREAKS).map_or(mark, |i| i + 1);
        let end = text[end..].find(BREAKS).map_or(text.len(), |i| end + i);
        start..end
    }
}

/// Whether there is a blank line in what lies between two chunks.
pub fn has_blank_line(between: &str) -> bool {
    if line_breaks(between) < 2 {
        return false;
    }
    let between = between.replace("\r\n", "\n");
    let mut lines = between.split(BREAKS).skip(1).peekable();
    // What stands before the last chunk on its line is no line either.
    std::iter::from_fn(|| lines.next().filter(|_| lines.peek().is_some()))
        .any(|line| line.trim().is_empty())
}

const BREAKS: [char; 2] = ['\n', '\r'];

/// How many line breaks a text has.
pub fn line_breaks(text: &str) -> usize {
    let bytes = text.as_bytes();
    let is_break =
        |(i, &b): (usize, &u8)| b == b'\n' || (b == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
    bytes.iter().enumerate().filter(|&x| is_break(x)).count()
}

/// Cuts a scene into chunks.
pub fn chunks<'a>(text: &'a str, document: &'a Document) -> impl Iterator<Item = Chunk> + 'a {
    let mut elements = elements(document).peekable();
    std::iter::from_fn(move || {
        let mut chunk = Chunk {
            elements: vec![elements.next()?],
        };
        while let Some(next) =
            elements.next_if(|next| line_breaks(&text[chunk.span().end..next.start]) == 0)
        {
            chunk.elements.push(next);
        }
        Some(chunk)
    })
}

/// The records and the comments between them, in order.
fn elements(document: &Document) -> impl Iterator<Item = Element> + '_ {
    let tokens = &document.tokens;
    let mut items = document.items.iter().peekable();
    let mut next = 0;
    std::iter::from_fn(move || {
        loop {
            let token = tokens.get(next)?;
            if let Some(&item) = items.next_if(|item| item.ends().0 as usize == next) {
                let (first, last) = item.ends();
                next = last as usize + 1;
                let span = document.span(first, last);
                let inside = &tokens[first as usize..next];
                return Some(Element {
                    piece: Piece::Item(item),
                    start: span.start as usize,
                    end: span.end as usize,
                    frozen: matches!(item, Item::Broken(_)) || inside.iter().any(is_doubtful),
                });
            }
            let index = next as u32;
            next += 1;
            let element = |piece, frozen| {
                let span = token.span().range();
                Some(Element {
                    piece,
                    start: span.start,
                    end: span.end,
                    frozen,
                })
            };
            if token.kind.is_comment() {
                return element(Piece::Comment(index), is_doubtful(token));
            } else if !token.kind.is_trivia() {
                return element(Piece::Unread(index), true);
            }
        }
    })
}

/// Whether a token has to be seen where it stands: a comment that nothing but the end of its line
/// ends, or a number that is not right.
fn is_doubtful(token: &Token) -> bool {
    matches!(
        token.kind,
        TokenKind::UnterminatedComment | TokenKind::DecimalComma | TokenKind::HugeNumber
    )
}
