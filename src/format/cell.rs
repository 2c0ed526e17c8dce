//! The values of a record in their new spelling, and the columns in which they stand.

use std::borrow::Cow;

use super::number;
use super::options::{Numbers, Options};
use super::width::display_width;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{ParamKind, RecordType};
use crate::syntax::{Document, Record};

/// The text, its tree and the options, which all of the printer needs.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    pub text: &'a str,
    pub document: &'a Document,
    pub options: &'a Options,
}

/// The number of values before the parameters: the ID and the type.
pub(super) const HEAD: usize = 2;

/// A value and its place in the layout.
pub(super) struct Cell<'a> {
    pub text: Cow<'a, str>,
    /// The columns that the part before the decimal point takes, and those of the rest, with the point.
    before: usize,
    after: usize,
}

impl Cell<'_> {
    pub(super) fn width(&self) -> usize {
        self.before + self.after
    }
}

impl<'a> Context<'a> {
    /// The record's tokens with the comments between them, but nothing else.
    pub(super) fn tokens(&self, record: &Record) -> impl Iterator<Item = &'a Token> + use<'a> {
        self.document.tokens[record.first as usize..=record.last as usize]
            .iter()
            .filter(|t| !t.kind().is_trivia() || t.kind().is_comment())
    }

    /// The `i`-th value of a record, counting the ID and the type.
    pub(super) fn cell(&self, record: &Record, i: usize, token: &Token) -> Cell<'a> {
        let spelled = token.text(self.text);
        let kind = kind(record, i);
        if kind == ParamKind::Real
            && let Some(before) = number::canonical(spelled)
        {
            return Cell {
                text: spelled.into(),
                before,
                after: spelled.len() - before,
            };
        }
        let text = match (kind, token.kind()) {
            _ if self.options.numbers == Numbers::Keep => spelled.into(),
            (ParamKind::Real, TokenKind::Integer | TokenKind::Real) => {
                number::real(spelled, self.document.values(record)[i - HEAD])
            }
            (ParamKind::Real | ParamKind::FileName, _) => spelled.into(),
            _ => number::integer(spelled),
        };
        // IDs, types and file names are aligned at their beginnings, parameters at their decimal points.
        let (width, before) = match kind {
            ParamKind::FileName => (display_width(&text), 0),
            _ if i < HEAD => (text.len(), 0),
            ParamKind::Real => {
                let point = |b| matches!(b, b'.' | b'e' | b'E');
                let before = text.bytes().position(point);
                (text.len(), before.unwrap_or(text.len()))
            }
            _ => (text.len(), text.len()),
        };
        Cell {
            text,
            before,
            after: width - before,
        }
    }

    /// How many spaces stand between the values of a record.
    pub(super) fn gaps(&self, record: &Record) -> Gaps {
        match self.options.group {
            true => Gaps::of(record),
            false => Gaps::default(),
        }
    }
}

/// The kind of a record's `i`-th value, counting the ID and the type.
fn kind(record: &Record, i: usize) -> ParamKind {
    let ty = record.ty();
    let Some(i) = i.checked_sub(HEAD) else {
        return ParamKind::Integer;
    };
    match ty.params.get(i) {
        Some(param) => param.kind,
        // Repeated parameters are real, all of them.
        None if ty.is_counted() => ParamKind::Real,
        None => (ty.optional.get(i - ty.params.len())).map_or(ParamKind::Real, |p| p.kind),
    }
}

/// Says which gaps between the values of a record are two spaces wide and not one.
#[derive(Clone, Copy, Default)]
pub(super) struct Gaps {
    /// A bit for each value that begins a vector. The lowest bit is that of the ID.
    wide: u32,
    /// For a profile the number of its points, and its type, which says how many values a point has.
    points: Option<(usize, &'static RecordType)>,
}

impl Gaps {
    /// The gaps of a record. If a record has more than one vector, a wide gap stands before each.
    fn of(record: &Record) -> Gaps {
        let ty = record.ty();
        if ty.is_counted() {
            let points = Some((record.count(), ty));
            return Gaps { wide: 0, points };
        }
        let mut wide = 0;
        let mut start = HEAD;
        for &length in ty.vectors {
            wide |= 1 << start;
            start += length;
        }
        let several = (ty.vectors.first()).is_some_and(|&first| record.params as usize > first);
        Gaps {
            wide: if several { wide } else { 0 },
            points: None,
        }
    }

    /// How many spaces stand before the `i`-th value of the record. The ID is value 0.
    pub(super) fn before(&self, i: usize) -> usize {
        let wide = match self.points {
            None => i < u32::BITS as usize && self.wide >> i & 1 == 1,
            Some((count, ty)) => starts_point(ty, count, i),
        };
        if wide { 2 } else { 1 }
    }
}

/// Whether the `i`-th value of a profile, the ID being value 0, begins a point or a colour.
fn starts_point(ty: &RecordType, count: usize, i: usize) -> bool {
    let Some(mut i) = i.checked_sub(HEAD + ty.params.len()) else {
        return false;
    };
    for group in ty.repeats {
        if i < group.len() * count {
            return i % group.len() == 0;
        }
        i -= group.len() * count;
    }
    false
}

/// The width of a column of values whose decimal points stand under each other.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Column {
    before: usize,
    after: usize,
}

impl Column {
    #[inline]
    pub(super) fn widen(&mut self, cell: &Cell) {
        self.before = self.before.max(cell.before);
        self.after = self.after.max(cell.after);
    }

    pub(super) fn width(&self) -> usize {
        self.before + self.after
    }

    /// Writes a cell in its place. Returns how many spaces must follow it if another value does.
    pub(super) fn write(&self, out: &mut String, cell: &Cell) -> usize {
        spaces(out, self.before - cell.before);
        out.push_str(&cell.text);
        self.after - cell.after
    }
}

pub(super) fn spaces(out: &mut String, count: usize) {
    const SPACES: &str = "                                ";
    let mut left = count;
    while left > 0 {
        let some = left.min(SPACES.len());
        out.push_str(&SPACES[..some]);
        left -= some;
    }
}

/// Whether lines may be aligned: the aligned ones take at most `width` columns, or at most a quarter more than the
/// unaligned ones.
pub(super) fn may_align(aligned: usize, unaligned: usize, width: usize) -> bool {
    aligned <= width.max(unaligned + unaligned / 4)
}
