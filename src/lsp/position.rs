//! Positions in a text as the protocol counts them: lines from 0, and units of UTF-8, UTF-16 or UTF-32 from the line's
//! start. Only this module turns offsets into positions and positions into offsets.

use std::cell::Cell;

use gen_lsp_types::{Position, PositionEncodingKind, Range};
use memchr::memchr2;
use serde_json::Value;

use crate::diagnostics::{SourceFile, Span};

/// The units in which columns of a line are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Units {
    Utf8,
    /// The units that every client knows.
    #[default]
    Utf16,
    Utf32,
}

impl Units {
    /// The best of the units that a client offers, by their names in the protocol: UTF-8, since bytes need no counting.
    pub(super) fn chosen(offered: &[Value]) -> Units {
        let offers = |name: &str| offered.iter().any(|o| o == name);
        match () {
            () if offers("utf-8") => Units::Utf8,
            () if offers("utf-32") => Units::Utf32,
            () => Units::Utf16,
        }
    }

    pub(super) fn kind(self) -> PositionEncodingKind {
        match self {
            Units::Utf8 => PositionEncodingKind::UTF8,
            Units::Utf16 => PositionEncodingKind::UTF16,
            Units::Utf32 => PositionEncodingKind::UTF32,
        }
    }

    /// The length of a text in these units.
    pub(super) fn length(self, text: &str) -> u32 {
        let length = match self {
            _ if text.is_ascii() => text.len(),
            Units::Utf8 => text.len(),
            Units::Utf16 => text.chars().map(char::len_utf16).sum(),
            Units::Utf32 => text.chars().count(),
        };
        length as u32
    }

    /// The byte offset in a line that is a number of units from its start: at most the line's end, and never within a
    /// character.
    fn byte(self, line: &str, units: u32) -> usize {
        let units = units as usize;
        let mut before = 0;
        for (at, c) in line.char_indices() {
            let next = before
                + match self {
                    Units::Utf8 => c.len_utf8(),
                    Units::Utf16 => c.len_utf16(),
                    Units::Utf32 => 1,
                };
            if next > units {
                return at;
            }
            before = next;
        }
        line.len()
    }
}

/// Converts positions and offsets of a source file.
pub(super) struct Places<'a> {
    source: &'a SourceFile,
    units: Units,
    /// The line that was asked for last, and its span: offsets that are asked for in order are found at once.
    last: Cell<(usize, Span)>,
}

impl<'a> Places<'a> {
    pub(super) fn new(source: &'a SourceFile, units: Units) -> Places<'a> {
        let last = Cell::new((0, source.line_span(0)));
        Places {
            source,
            units,
            last,
        }
    }

    fn line_of(&self, offset: u32) -> (usize, Span) {
        let (line, span) = self.last.get();
        if span.start <= offset && offset <= span.end {
            return (line, span);
        }
        let line = self.source.line_index(offset);
        let found = (line, self.source.line_span(line));
        self.last.set(found);
        found
    }

    pub(super) fn position(&self, offset: u32) -> Position {
        let offset = self.source.floor(offset);
        let (line, span) = self.line_of(offset);
        // An offset within a line break becomes the end of the line.
        let end = offset.min(span.end);
        let before = self.source.slice(Span::new(span.start, end));
        Position {
            line: line as u32,
            character: self.units.length(before),
        }
    }

    pub(super) fn range(&self, span: Span) -> Range {
        Range {
            start: self.position(span.start),
            end: self.position(span.end),
        }
    }

    /// The offset of a position. A position behind the end of a line, or of the text, counts as that end.
    pub(super) fn offset(&self, position: Position) -> u32 {
        if position.line as usize >= self.source.line_count() {
            return self.source.text.len() as u32;
        }
        let span = self.source.line_span(position.line as usize);
        let line = self.source.slice(span);
        span.start + self.units.byte(line, position.character) as u32
    }

    pub(super) fn span(&self, range: Range) -> Span {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        Span::new(start.min(end), start.max(end))
    }

    /// The length in units of a span within a line.
    pub(super) fn length(&self, span: Span) -> u32 {
        self.units.length(self.source.slice(span))
    }
}

/// Replaces a range of a text that has no analysis yet by a new text. A range that reaches beyond the text ends with
/// it.
pub(super) fn edit(text: &mut String, units: Units, range: Range, new: &str) {
    let (start, end) = (
        offset_in(text, units, range.start),
        offset_in(text, units, range.end),
    );
    text.replace_range(start.min(end)..start.max(end), new);
}

fn offset_in(text: &str, units: Units, position: Position) -> usize {
    let bytes = text.as_bytes();
    let mut start = 0;
    for _ in 0..position.line {
        match memchr2(b'\n', b'\r', &bytes[start..]) {
            Some(at) => {
                let at = start + at;
                let pair = bytes[at] == b'\r' && bytes.get(at + 1) == Some(&b'\n');
                start = at + 1 + usize::from(pair);
            }
            None => return text.len(),
        }
    }
    let length = memchr2(b'\n', b'\r', &bytes[start..]).unwrap_or(text.len() - start);
    start + units.byte(&text[start..start + length], position.character)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\u{feff}2 9 1 # ž😀 #\r\n3 9 1\r4 9 1\n";

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    /// Counted by hand: the mark is one character; ž is 2, 1, 1 units, the emoji 4, 2, 1.
    #[test]
    fn units() {
        let source = SourceFile::new("a", Vec::new()).with_text(TEXT.to_owned());
        let behind_emoji = (TEXT.find('😀').unwrap() + 4) as u32;
        for (units, column) in [(Units::Utf8, 17), (Units::Utf16, 12), (Units::Utf32, 11)] {
            let places = Places::new(&source, units);
            assert_eq!(places.position(behind_emoji), at(0, column));
            assert_eq!(places.offset(at(0, column)), behind_emoji);
            let third = TEXT.find("4 9").unwrap() as u32;
            assert_eq!(places.position(third), at(2, 0));
            assert_eq!(places.offset(at(2, 0)), third);
            assert_eq!(places.offset(at(9, 9)), TEXT.len() as u32);
            assert_eq!(places.offset(at(1, 99)), third - 1);
        }
        // Within the emoji, and within the line break.
        let places = Places::new(&source, Units::Utf16);
        assert_eq!(places.offset(at(0, 11)), behind_emoji - 4);
        let line_end = TEXT.find('\r').unwrap() as u32;
        assert_eq!(places.position(line_end + 1), places.position(line_end));
    }

    #[test]
    fn edits_count_as_places_do() {
        let source = SourceFile::new("a", Vec::new()).with_text(TEXT.to_owned());
        for units in [Units::Utf8, Units::Utf16, Units::Utf32] {
            let places = Places::new(&source, units);
            for line in 0..6 {
                for character in 0..20 {
                    let offset = offset_in(TEXT, units, at(line, character));
                    assert_eq!(places.offset(at(line, character)), offset as u32);
                }
            }
        }
        let mut text = TEXT.to_owned();
        edit(
            &mut text,
            Units::Utf16,
            Range {
                start: at(1, 2),
                end: at(1, 3),
            },
            "14 5",
        );
        assert!(text.contains("3 14 5 1\r"));
        edit(
            &mut text,
            Units::Utf16,
            Range {
                start: at(70, 0),
                end: at(3, 0),
            },
            "5 9 1",
        );
        assert!(text.ends_with("4 9 1\n5 9 1"));
    }
}
