//! A record's values as they are to be spelled, and the columns they stand in.

use std::borrow::Cow;

use super::number;
use super::options::{Numbers, Options};
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::ParamKind;
use crate::syntax::{Document, Record};

/// What all of the printing looks at.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    pub text: &'a str,
    pub document: &'a Document,
    pub options: &'a Options,
}

/// How far the ID and the type go, before the parameters.
pub const HEAD: usize = 2;

/// One value.
pub struct Cell<'a> {
    pub text: Cow<'a, str>,
    /// Characters in front of the decimal point, and from it on.
    before: usize,
    after: usize,
}

impl Cell<'_> {
    pub fn width(&self) -> usize {
        self.before + self.after
    }
}

impl<'a> Context<'a> {
    /// The record's tokens with the comments between them, but nothing else.
    pub fn tokens(&self, record: &Record) -> impl Iterator<Item = &'a Token> + use<'a> {
        self.document.tokens[record.first as usize..=record.last as usize]
            .iter()
            .filter(|t| !t.kind.is_trivia() || t.kind.is_comment())
    }

    /// The `i`-th value of a record, counting the ID and the type.
    pub fn cell(&self, record: &Record, i: usize, token: &Token) -> Cell<'a> {
        let spelled = token.text(self.text);
        let kind = match i.checked_sub(HEAD) {
            None => Some(ParamKind::Integer),
            Some(i) => record.ty.param(i, record.count as usize).map(|p| p.kind),
        };
        let text = match (kind, token.kind) {
            _ if self.options.numbers == Numbers::Keep => spelled.into(),
            (Some(ParamKind::Real), TokenKind::Integer | TokenKind::Real) => number::real(spelled),
            (None | Some(ParamKind::Real | ParamKind::FileName), _) => spelled.into(),
            (Some(_), _) => number::integer(spelled),
        };
        let width = match text.is_ascii() {
            true => text.len(),
            false => text.chars().count(),
        };
        // IDs, types and names begin their columns; parameters stand on their points.
        let before = match kind {
            Some(ParamKind::FileName) | None => 0,
            _ if i < HEAD => 0,
            _ => (text.bytes())
                .position(|b| matches!(b, b'.' | b'e' | b'E'))
                .unwrap_or(width),
        };
        Cell {
            text,
            before,
            after: width - before,
        }
    }

    /// How many spaces stand before the `i`-th value, the ID not counted.
    pub fn gap(&self, record: &Record, i: usize) -> usize {
        let wide = self.options.group && i >= HEAD && starts_vector(record, i - HEAD);
        if wide { 2 } else { 1 }
    }
}

/// Whether a parameter is the first of a vector, and there is another vector.
fn starts_vector(record: &Record, i: usize) -> bool {
    let (ty, count) = (record.ty, record.count as usize);
    if ty.is_counted() {
        let Some(mut i) = i.checked_sub(ty.params.len()) else {
            return false;
        };
        for group in ty.repeats {
            if i < group.len() * count {
                return i % group.len() == 0;
            }
            i -= group.len() * count;
        }
        return false;
    }
    let Some(&first) = ty.vectors.first() else {
        return false;
    };
    let mut start = 0;
    record.params as usize > first
        && ty.vectors.iter().any(|length| {
            let found = start == i;
            start += length;
            found
        })
}

/// Values under each other, their decimal points in one place.
#[derive(Debug, Clone, Copy, Default)]
pub struct Column {
    before: usize,
    after: usize,
}

impl Column {
    pub fn widen(&mut self, cell: &Cell) {
        self.before = self.before.max(cell.before);
        self.after = self.after.max(cell.after);
    }

    pub fn width(&self) -> usize {
        self.before + self.after
    }

    /// Writes a cell in its place; how many spaces belong behind it, if something follows.
    pub fn write(&self, out: &mut String, cell: &Cell) -> usize {
        spaces(out, self.before - cell.before);
        out.push_str(&cell.text);
        self.after - cell.after
    }
}

pub fn spaces(out: &mut String, count: usize) {
    const SPACES: &str = "                                ";
    let mut left = count;
    while left > 0 {
        let some = left.min(SPACES.len());
        out.push_str(&SPACES[..some]);
        left -= some;
    }
}

/// Whether something aligned may be so wide: within the page, or if it does not fit there anyway, not
/// much wider than it has to be.
pub fn may_align(aligned: usize, unaligned: usize, width: usize) -> bool {
    aligned <= width.max(unaligned + unaligned / 4)
}
