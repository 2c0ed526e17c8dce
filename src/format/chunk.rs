//! A scene cut into chunks. A chunk is the records and comments that stand together on a line, or on several lines
//! where a record or a comment goes on.

use std::ops::Range;

use super::document_range::DocumentRange;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::{Document, Item, commas};

/// A record, or a comment between records.
pub(super) struct Element<'a> {
    pub piece: Fragment<'a>,
    /// The indices of the first and of the last token.
    pub first: u32,
    pub last: u32,
    /// Whether the element keeps its layout: it was not read in full, or has a token or comma in doubt.
    pub frozen: bool,
}

#[derive(Clone, Copy)]
pub(super) enum Fragment<'a> {
    Item(&'a Item),
    Comment,
    /// A token that belongs to no item.
    Unread,
}

/// Neighbouring elements without a line break between them.
#[derive(Default)]
pub(super) struct Chunk<'a> {
    pub elements: Vec<Element<'a>>,
    /// Whether a blank line comes before the chunk.
    pub after_blank_line: bool,
}

impl<'a> Chunk<'a> {
    /// The range of bytes of the chunk, from its first to its last character.
    pub(super) fn span(&self, document: &Document) -> Range<usize> {
        match (self.elements.first(), self.elements.last()) {
            (Some(first), Some(last)) => document.span(first.first, last.last).range(),
            _ => 0..0,
        }
    }

    /// Whether the chunk keeps its layout, since its line breaks may say what was meant.
    pub(super) fn is_frozen(&self) -> bool {
        self.elements.iter().any(|e| e.frozen)
    }

    pub(super) fn items(&self) -> impl Iterator<Item = &'a Item> {
        self.elements.iter().filter_map(|e| match e.piece {
            Fragment::Item(item) => Some(item),
            Fragment::Comment | Fragment::Unread => None,
        })
    }

    /// The range of bytes of the chunk's whole lines, with all white space but without the last line break.
    pub(super) fn whole_lines(&self, text: &str, document: &Document) -> Range<usize> {
        let Range { start, end } = self.span(document);
        let mark = match text.starts_with(super::BYTE_ORDER_MARK) {
            true => super::BYTE_ORDER_MARK.len_utf8(),
            false => 0,
        };
        let start = text[..start].rfind(BREAKS).map_or(mark, |i| i + 1);
        let end = text[end..].find(BREAKS).map_or(text.len(), |i| end + i);
        start..end
    }
}

const BREAKS: [char; 2] = ['\n', '\r'];

/// Cuts a part of a scene into chunks.
pub(super) struct Chunks<'a> {
    text: &'a str,
    document: &'a Document,
    items: &'a [Item],
    /// The index of the next token, and the index behind the last token of the part.
    at: usize,
    end: usize,
    /// Whether the part has a doubtful token: a comment without a closing `#`, a decimal comma or a huge number. The
    /// formatter leaves those where they are.
    has_doubtful: bool,
}

impl<'a> Chunks<'a> {
    pub(super) fn new(text: &'a str, document: &'a Document, part: &DocumentRange) -> Chunks<'a> {
        Chunks {
            text,
            document,
            items: &document.items[part.items.clone()],
            at: part.tokens.start,
            end: part.tokens.end,
            has_doubtful: document.tokens[part.tokens.clone()].iter().any(is_doubtful),
        }
    }

    /// Fills `chunk` with the next chunk. `false` if there is none.
    pub(super) fn next(&mut self, chunk: &mut Chunk<'a>) -> bool {
        chunk.elements.clear();
        chunk.after_blank_line = false;
        let tokens = &self.document.tokens[..self.end];
        let mut ends_line = false;
        while let Some(token) = tokens.get(self.at) {
            let index = self.at as u32;
            if token.kind() == TokenKind::Newline {
                if !chunk.elements.is_empty() {
                    break;
                }
                chunk.after_blank_line |= ends_line;
                ends_line = true;
                self.at += 1;
                continue;
            }
            ends_line = false;
            let element = |piece, last: u32, frozen| Element {
                piece,
                first: index,
                last,
                frozen,
            };
            let item = self.items.first().filter(|item| item.ends().0 == index);
            if let Some(item) = item {
                self.items = &self.items[1..];
                let last = item.ends().1;
                let inside = self.at..last as usize + 1;
                self.at = inside.end;
                let frozen = matches!(item, Item::Broken(_))
                    || self.has_doubtful && tokens[inside].iter().any(is_doubtful)
                    || self.has_doubtful_comma(item);
                chunk
                    .elements
                    .push(element(Fragment::Item(item), last, frozen));
                continue;
            }
            self.at += 1;
            if token.kind().is_comment() {
                let frozen = is_doubtful(token);
                chunk
                    .elements
                    .push(element(Fragment::Comment, index, frozen));
            } else if !token.kind().is_trivia() {
                chunk.elements.push(element(Fragment::Unread, index, true));
            }
        }
        !chunk.elements.is_empty()
    }

    /// Whether an item is a record with a comma that may be a decimal one. Printed with spaces between the numbers, it
    /// could not be seen any more.
    fn has_doubtful_comma(&self, item: &Item) -> bool {
        let doubtful = |record| !commas::in_doubt_of(self.text, self.document, record).is_empty();
        self.document.contents.separators && item.record().is_some_and(doubtful)
    }
}

/// Whether a token must be left where it stands: a comment that only the end of its line ends, a decimal comma, or a
/// huge number.
fn is_doubtful(token: &Token) -> bool {
    matches!(
        token.kind(),
        TokenKind::UnterminatedComment | TokenKind::DecimalComma | TokenKind::HugeNumber
    )
}
