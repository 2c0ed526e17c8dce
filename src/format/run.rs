//! Records that take a line each. Neighbouring records of one type stand in columns.

use std::borrow::Borrow;

use super::cell::{Cell, Column, Context, HEAD, may_align, spaces};
use super::page::Page;
use super::rows;
use super::width::display_width;
use crate::syntax::Record;

/// A record with the comments on its line.
pub(super) struct RecordLine<'a> {
    pub record: &'a Record,
    /// Indices of the tokens from the first comment before the record to the last behind it.
    pub tokens: (u32, u32),
    /// Whether a `0` before the comments behind the record stays.
    pub keeps_zero: bool,
    /// Whether the line is among those asked for.
    pub wanted: bool,
}

impl<'a> RecordLine<'a> {
    /// Comments before the record.
    fn lead(&self, context: &Context<'a>) -> impl Iterator<Item = &'a str> + use<'a> {
        comments(context, self.tokens.0, self.record.first, false)
    }

    /// Comments behind the record.
    pub(super) fn trail(&self, context: &Context<'a>) -> impl Iterator<Item = &'a str> + use<'a> {
        let (from, to) = (self.record.last + 1, self.tokens.1 + 1);
        comments(context, from, to, self.keeps_zero)
    }

    /// Whether no comment stands before the record or inside of it.
    fn is_plain(&self, context: &Context<'a>) -> bool {
        self.tokens.0 == self.record.first && !has_comments(context, self.record)
    }

    /// Writes the comments before the record.
    pub(super) fn write_lead(&self, context: &Context<'a>, out: &mut String) {
        for comment in self.lead(context) {
            out.push_str(comment);
            out.push(' ');
        }
    }
}

/// The texts of the comments among tokens `from..to`; with `zeros` also those of the `0` that introduce them.
fn comments<'a>(
    context: &Context<'a>,
    from: u32,
    to: u32,
    zeros: bool,
) -> impl Iterator<Item = &'a str> + use<'a> {
    let text = context.text;
    context.document.tokens[from as usize..to as usize]
        .iter()
        .filter(move |t| t.kind().is_comment() || zeros && !t.kind().is_trivia())
        .map(move |t| t.text(text))
}

/// Whether there are comments in a record.
pub(super) fn has_comments(context: &Context, record: &Record) -> bool {
    // Most records have nothing but their numbers, and can be told by the number of tokens.
    record.last - record.first > record.params + 1
        && context.tokens(record).any(|t| t.kind().is_comment())
}

/// Neighbouring records of one type, whose lines may stand in columns.
#[derive(Default)]
pub(super) struct Run<'a> {
    entries: Vec<RecordLine<'a>>,
    /// The values of the first records, one record after another; at most [`KEPT`] values.
    cells: Vec<Cell<'a>>,
    /// The columns, each as wide as the records need.
    columns: Vec<Column>,
    /// The width of the widest record without columns, and the most spaces that any record has between its values.
    unaligned: usize,
    spaces: usize,
}

/// The most values whose spelling is kept until they are written.
const KEPT: usize = 1 << 12;

impl<'a> Run<'a> {
    /// Adds a record. If the record does not belong to the run, prints the run first.
    pub(super) fn push(&mut self, context: &Context<'a>, page: &mut Page, entry: RecordLine<'a>) {
        if rows::is_wanted(context, entry.record) {
            self.print(context, page);
            page.end_column();
            page.wanted = entry.wanted;
            rows::print(context, page, &entry);
            page.end_column();
            return;
        }
        let plain = entry.is_plain(context);
        let other = |first: &RecordLine| first.record.kind != entry.record.kind;
        if !plain || self.entries.first().is_some_and(other) {
            self.print(context, page);
        }
        self.widen(context, entry.record);
        self.entries.push(entry);
        if !plain {
            self.print(context, page);
        }
    }

    /// Widens the columns to the values of a record.
    #[inline]
    fn widen(&mut self, context: &Context<'a>, record: &'a Record) {
        let (mut width, mut spaces) = (0, 0);
        let gaps = context.gaps(record);
        for (i, cell) in cells(context, record).enumerate() {
            if i == self.columns.len() {
                self.columns.push(Column::default());
            }
            self.columns[i].widen(&cell);
            width += cell.width();
            spaces += if i > 0 { gaps.before(i) } else { 0 };
            if self.cells.len() < KEPT {
                self.cells.push(cell);
            }
        }
        self.unaligned = self.unaligned.max(width + spaces);
        self.spaces = self.spaces.max(spaces);
    }

    /// Whether the records may stand in columns.
    fn may_align(&self, context: &Context) -> bool {
        let aligned = self.spaces + self.columns.iter().map(Column::width).sum::<usize>();
        self.entries.len() > 1
            && context.options.align
            && may_align(aligned, self.unaligned, context.options.width)
    }

    /// Prints the records of the run and empties it.
    pub(super) fn print(&mut self, context: &Context<'a>, page: &mut Page) {
        let aligned = self.may_align(context);
        let mut kept = self.cells.as_slice();
        for entry in self.entries.drain(..) {
            page.wanted = entry.wanted;
            let out = page.line();
            entry.write_lead(context, out);
            let record = entry.record;
            let columns = aligned.then_some(self.columns.as_slice());
            match kept.split_at_checked(record.params as usize + HEAD) {
                Some((cells, rest)) => {
                    kept = rest;
                    write(context, out, record, cells.iter(), columns);
                }
                None => {
                    kept = &[];
                    write(context, out, record, cells(context, record), columns);
                }
            }
            page.end_line(entry.trail(context));
        }
        self.cells.clear();
        self.columns.clear();
        (self.unaligned, self.spaces) = (0, 0);
    }
}

/// The values of a record.
pub(super) fn cells<'a>(
    context: &Context<'a>,
    record: &'a Record,
) -> impl Iterator<Item = Cell<'a>> + use<'a> {
    let context = *context;
    let values = context.document.significant(record.first, record.last);
    values
        .enumerate()
        .map(move |(i, token)| context.cell(record, i, token))
}

/// Writes a record with the comments in it. Only a record without comments may have columns.
fn write<'a>(
    context: &Context,
    out: &mut String,
    record: &Record,
    cells: impl Iterator<Item: Borrow<Cell<'a>>>,
    columns: Option<&[Column]>,
) {
    let gaps = context.gaps(record);
    let mut missing = 0;
    let mut cells = cells.enumerate();
    for token in context.tokens(record) {
        if token.kind().is_comment() {
            out.push(' ');
            out.push_str(token.text(context.text));
        } else if let Some((i, cell)) = cells.next() {
            if i > 0 {
                spaces(out, missing + gaps.before(i));
            }
            match columns {
                Some(columns) => missing = columns[i].write(out, cell.borrow()),
                None => out.push_str(&cell.borrow().text),
            }
        }
    }
}

/// The width of a record on one line by itself, with its comments.
pub(super) fn natural_width(context: &Context, record: &Record) -> usize {
    let mut out = String::new();
    write(context, &mut out, record, cells(context, record), None);
    display_width(&out)
}
