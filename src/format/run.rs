//! Records one a line; neighbours of one type stand in columns.

use super::cell::{Cell, Column, Context, may_align, spaces};
use super::page::Page;
use super::rows;
use crate::syntax::Record;

/// A record with the comments on its line.
pub struct Entry {
    pub record: Record,
    /// From the first comment before the record to the last behind it, as tokens.
    pub tokens: (u32, u32),
    /// Whether the line is among those asked for.
    pub wanted: bool,
}

impl Entry {
    /// Comments before the record.
    fn lead<'a>(&self, context: &Context<'a>) -> impl Iterator<Item = &'a str> + use<'a> {
        comments(context, self.tokens.0, self.record.first)
    }

    /// Comments behind the record.
    pub fn trail<'a>(&self, context: &Context<'a>) -> impl Iterator<Item = &'a str> + use<'a> {
        comments(context, self.record.last + 1, self.tokens.1 + 1)
    }

    /// Nothing but numbers up to its end.
    fn is_plain(&self, context: &Context) -> bool {
        self.tokens.0 == self.record.first
            && context.tokens(&self.record).all(|t| !t.kind.is_comment())
    }

    /// Writes what stands before the record.
    pub fn write_lead(&self, context: &Context, out: &mut String) {
        for comment in self.lead(context) {
            out.push_str(comment);
            out.push(' ');
        }
    }
}

/// The comments among some tokens.
fn comments<'a>(
    context: &Context<'a>,
    from: u32,
    to: u32,
) -> impl Iterator<Item = &'a str> + use<'a> {
    let text = context.text;
    context.document.tokens[from as usize..to as usize]
        .iter()
        .filter(|t| t.kind.is_comment())
        .map(move |t| t.text(text))
}

/// Neighbours of one type whose lines may stand in columns.
#[derive(Default)]
pub struct Run(Vec<Entry>);

impl Run {
    /// Adds a record; prints those before it if it does not belong with them.
    pub fn push(&mut self, context: &Context, page: &mut Page, entry: Entry) {
        if rows::is_wanted(context, &entry.record) {
            self.print(context, page);
            page.flush();
            page.wanted = entry.wanted;
            rows::print(context, page, &entry);
            page.flush();
            return;
        }
        let plain = entry.is_plain(context);
        let other = |first: &Entry| first.record.ty.code != entry.record.ty.code;
        if !plain || self.0.first().is_some_and(other) {
            self.print(context, page);
        }
        self.0.push(entry);
        if !plain {
            self.print(context, page);
        }
    }

    /// Prints the records.
    pub fn print(&mut self, context: &Context, page: &mut Page) {
        let columns = (self.0.len() > 1 && context.options.align)
            .then(|| self.columns(context))
            .flatten();
        for entry in self.0.drain(..) {
            page.wanted = entry.wanted;
            let out = page.line();
            entry.write_lead(context, out);
            match &columns {
                Some(columns) => write_columns(context, out, &entry.record, columns),
                None => write(context, out, &entry.record),
            }
            page.end_line(entry.trail(context));
        }
    }

    /// The columns of the records, if they may have any.
    fn columns(&self, context: &Context) -> Option<Vec<Column>> {
        let mut columns: Vec<Column> = Vec::new();
        let mut unaligned = 0;
        let mut gaps = 0;
        for Entry { record, .. } in &self.0 {
            let (mut width, mut between) = (0, 0);
            for (i, cell) in cells(context, record).enumerate() {
                if i == columns.len() {
                    columns.push(Column::default());
                }
                columns[i].widen(&cell);
                width += cell.width();
                between += if i > 0 { context.gap(record, i) } else { 0 };
            }
            unaligned = unaligned.max(width + between);
            gaps = gaps.max(between);
        }
        let aligned = gaps + columns.iter().map(Column::width).sum::<usize>();
        may_align(aligned, unaligned, context.options.width).then_some(columns)
    }
}

/// The values of a record.
pub fn cells<'a>(
    context: &Context<'a>,
    record: &'a Record,
) -> impl Iterator<Item = Cell<'a>> + use<'a> {
    let context = *context;
    let values = context.document.significant(record.first, record.last);
    values
        .enumerate()
        .map(move |(i, token)| context.cell(record, i, token))
}

fn write_columns(context: &Context, out: &mut String, record: &Record, columns: &[Column]) {
    let mut missing = 0;
    for (i, (cell, column)) in cells(context, record).zip(columns).enumerate() {
        if i > 0 {
            spaces(out, missing + context.gap(record, i));
        }
        missing = column.write(out, &cell);
    }
}

/// Writes a record without its neighbours, with the comments in it.
fn write(context: &Context, out: &mut String, record: &Record) {
    let mut i = 0;
    for token in context.tokens(record) {
        if token.kind.is_comment() {
            out.push(' ');
            out.push_str(token.text(context.text));
            continue;
        }
        if i > 0 {
            spaces(out, context.gap(record, i));
        }
        out.push_str(&context.cell(record, i, token).text);
        i += 1;
    }
}

/// How wide a record is on one line by itself, with the comments in it.
pub fn natural_width(context: &Context, record: &Record) -> usize {
    let mut out = String::new();
    write(context, &mut out, record);
    out.chars().count()
}
