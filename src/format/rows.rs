//! Records that take several lines: matrices, and profiles that are too long for one line.

use std::ops::Range;

use super::cell::{Cell, Column, Context, HEAD, may_align, spaces};
use super::options::Options;
use super::page::Page;
use super::run::{self, RecordLine};
use crate::syntax::Record;
use crate::syntax::table::{ParamKind, RecordType};

const INDENT: usize = 2;
/// The number of rows of a matrix, and of its columns.
const MATRIX: usize = 4;

/// A part of a record in rows.
enum RowPart<'a> {
    Cell(Cell<'a>),
    /// Comments with nothing but spaces between them.
    Comments(Comments<'a>),
}

struct Comments<'a> {
    all: Vec<&'a str>,
    /// Whether a line break stands before the comments, and whether one stands behind them.
    first: bool,
    last: bool,
}

/// Values of a record that are cut into rows. `group` values are a point, a colour or a row of a matrix, and `per_row`
/// groups stand in a row.
struct Section {
    values: Range<usize>,
    group: usize,
    per_row: usize,
}

impl Section {
    fn starts_group(&self, value: usize) -> bool {
        self.values.contains(&value) && (value - self.values.start).is_multiple_of(self.group)
    }
}

/// A printed line: the range of the record's parts on it, without the comments behind them.
struct Row {
    parts: Range<usize>,
    /// The index of the first value on the line. The ID is value 0.
    value: usize,
    /// Whether the part behind `parts` is the comments at the end of this line.
    trail: bool,
}

/// Whether a record is printed in rows.
pub(super) fn is_wanted(context: &Context, record: &Record) -> bool {
    if is_matrix(record.ty()) {
        return true;
    }
    let width = context.options.width;
    // A number takes two columns at least, with the space before it.
    record.ty().is_counted()
        && (2 * record.params as usize > width
            || run::natural_width(context, record) > width
            || is_commented(context, record))
}

fn is_matrix(ty: &RecordType) -> bool {
    ty.vectors == [MATRIX; MATRIX]
}

/// Whether a profile has comments between its points.
fn is_commented(context: &Context, record: &Record) -> bool {
    if !run::has_comments(context, record) {
        return false;
    }
    let sections = sections(record);
    let mut value = 0;
    parts(context, record).iter().any(|part| match part {
        RowPart::Cell(_) => {
            value += 1;
            false
        }
        RowPart::Comments(_) => ends_group(&sections, value),
    })
}

/// The sections of a record that are cut into rows. The values before the first section are the first line.
fn sections(record: &Record) -> Vec<Section> {
    if is_matrix(record.ty()) {
        return vec![Section {
            values: HEAD..HEAD + MATRIX * MATRIX,
            group: MATRIX,
            per_row: 1,
        }];
    }
    let mut start = HEAD + record.ty().params.len();
    let section = |group: &&[_]| {
        let values = start..start + group.len() * record.count();
        start = values.end;
        Section {
            values,
            group: group.len(),
            per_row: 1,
        }
    };
    record.ty().repeats.iter().map(section).collect()
}

/// Whether a point, a colour, a row of a matrix or the head of the record ends right before value `value`.
fn ends_group(sections: &[Section], value: usize) -> bool {
    sections
        .iter()
        .any(|s| s.starts_group(value) || s.values.end == value)
}

fn parts<'a>(context: &Context<'a>, record: &Record) -> Vec<RowPart<'a>> {
    let mut parts = Vec::new();
    let mut values = 0;
    let mut end = None;
    for token in context.tokens(record) {
        let span = token.span().range();
        let gap = end.map_or("", |end| &context.text[end..span.start]);
        let line_break = gap.contains(['\n', '\r']);
        end = Some(span.end);
        if let Some(RowPart::Comments(before)) = parts.last_mut() {
            before.last = line_break;
        }
        if !token.kind().is_comment() {
            parts.push(RowPart::Cell(context.cell(record, values, token)));
            values += 1;
            continue;
        }
        let text = token.text(context.text);
        match parts.last_mut() {
            Some(RowPart::Comments(before)) if !line_break => before.all.push(text),
            _ => parts.push(RowPart::Comments(Comments {
                all: vec![text],
                first: line_break,
                last: false,
            })),
        }
    }
    parts
}

/// Prints a record in rows.
pub(super) fn print<'a>(context: &Context<'a>, page: &mut Page, entry: &RecordLine<'a>) {
    let record = entry.record;
    let parts = parts(context, record);
    let mut sections = sections(record);
    let columns = fit(context, &parts, &mut sections);
    let rows = loop {
        let rows = rows(&parts, &sections);
        let widest = sections.iter_mut().max_by_key(|s| s.per_row);
        match widest {
            Some(section) if section.per_row > 1 && reads_as_records(&parts, &rows) => {
                section.per_row -= 1;
            }
            _ => break rows,
        }
    };
    for (i, row) in rows.iter().enumerate() {
        let out = page.line();
        if i == 0 {
            entry.write_lead(context, out);
        } else {
            spaces(out, INDENT);
        }
        write(
            context,
            out,
            &parts[row.parts.clone()],
            row.value,
            &sections,
            &columns,
        );
        let own = row.trail.then(|| match &parts[row.parts.end] {
            RowPart::Comments(comments) => comments.all.as_slice(),
            RowPart::Cell(_) => &[],
        });
        let own = own.unwrap_or_default().iter().copied();
        if i + 1 < rows.len() {
            page.end_line(own);
        } else {
            page.end_line(own.chain(entry.trail(context)));
        }
    }
}

/// The number of spaces between the points of a row. Two spaces could not be told from those of the alignment.
fn between(options: &Options) -> usize {
    if options.group { 4 } else { 1 }
}

/// Chooses how many points a row has in each section. Returns the columns of each section, `None` if its values are not
/// aligned.
fn fit(context: &Context, parts: &[RowPart], sections: &mut [Section]) -> Vec<Option<Vec<Column>>> {
    let values: Vec<&Cell> = parts.iter().filter_map(RowPart::cell).collect();
    let width = context.options.width;
    let between = between(context.options);
    let mut columns = Vec::new();
    for section in sections {
        let mut own = vec![Column::default(); section.group];
        let mut unaligned = 0;
        for group in values[section.values.clone()].chunks(section.group) {
            unaligned = unaligned.max(group.iter().map(|c| c.width()).sum());
            for (column, cell) in own.iter_mut().zip(group) {
                column.widen(cell);
            }
        }
        let aligned = own.iter().map(Column::width).sum::<usize>();
        let spaces = section.group - 1;
        let may = context.options.align
            && may_align(
                INDENT + aligned + spaces,
                INDENT + unaligned + spaces,
                width,
            );
        let one = spaces + if may { aligned } else { unaligned };
        if !section.values.is_empty() && section.group < MATRIX {
            section.per_row = ((width + between).saturating_sub(INDENT) / (one + between)).max(1);
        }
        columns.push(may.then_some(own));
    }
    columns
}

impl<'a> RowPart<'a> {
    fn cell(&self) -> Option<&Cell<'a>> {
        match self {
            RowPart::Cell(cell) => Some(cell),
            RowPart::Comments(_) => None,
        }
    }
}

/// Cuts a record into lines. A comment behind a group ends its line. A comment that begins a line in the file begins
/// one here, too, or stands alone if it does so there. All other comments stay between their numbers.
fn rows(parts: &[RowPart], sections: &[Section]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    let (mut start, mut first, mut value) = (0, 0, 0);
    // How many groups are on the current line, and whether the line is full.
    let (mut groups, mut full) = (0, false);
    for (i, part) in parts.iter().enumerate() {
        let at_end = ends_group(sections, value);
        let mut close = |end: usize, trail: bool| {
            rows.push(Row {
                parts: start..end,
                value: first,
                trail,
            });
        };
        match part {
            RowPart::Cell(_) => {
                if full {
                    if start < i {
                        close(i, false);
                    }
                    (start, first, groups, full) = (i, value, 0, false);
                }
                value += 1;
                if !ends_group(sections, value) {
                    continue;
                }
                groups += 1;
                let section = sections.iter().find(|s| s.values.contains(&(value - 1)));
                full = section.is_none_or(|s| value == s.values.end || groups == s.per_row);
            }
            RowPart::Comments(_) if !at_end => {}
            RowPart::Comments(c) if !c.first => {
                close(i, true);
                (start, first, groups, full) = (i + 1, value, 0, true);
            }
            RowPart::Comments(c) => {
                if start < i {
                    close(i, false);
                }
                (start, first, groups, full) = (i, value, 0, c.last);
            }
        }
    }
    if start < parts.len() {
        rows.push(Row {
            parts: start..parts.len(),
            value: first,
            trail: false,
        });
    }
    rows
}

/// Whether any row except the first could be read as a record of its own, or as the beginning of one.
fn reads_as_records(parts: &[RowPart], rows: &[Row]) -> bool {
    let values: Vec<&str> = (parts.iter().filter_map(RowPart::cell))
        .map(|c| c.text.as_ref())
        .collect();
    let starts: Vec<usize> = rows.iter().map(|r| r.value).collect();
    starts.iter().skip(1).any(|&start| {
        let integer = |i: usize| values.get(start + i).and_then(|v| v.parse::<i64>().ok());
        let (Some(1..), Some(code)) = (integer(0), integer(1)) else {
            return false;
        };
        let Some(ty) = RecordType::by_code(code) else {
            return false;
        };
        let counted = ty
            .params
            .first()
            .is_some_and(|p| p.kind == ParamKind::Count);
        let count = match (counted, integer(HEAD)) {
            (false, _) => 0,
            (true, Some(count @ 2..)) => count as u64,
            (true, _) => return false,
        };
        let end = |arity: u64| (start + HEAD) as u64 + arity;
        let arity = ty.arity(count);
        [end(arity), end(arity + ty.optional.len() as u64)]
            .into_iter()
            .any(|end| end >= values.len() as u64 || starts.binary_search(&(end as usize)).is_ok())
    })
}

/// Writes a row. `value` is the index of its first value in the record.
fn write(
    context: &Context,
    out: &mut String,
    parts: &[RowPart],
    value: usize,
    sections: &[Section],
    columns: &[Option<Vec<Column>>],
) {
    let mut value = value;
    // Between comments the numbers could not stand under each other.
    let section = sections.iter().position(|s| s.values.contains(&value));
    let columns = section
        .filter(|_| parts.iter().all(|p| p.cell().is_some()))
        .and_then(|s| columns[s].as_deref().zip(sections.get(s)));
    let mut missing = 0;
    for (i, part) in parts.iter().enumerate() {
        match part {
            RowPart::Comments(comments) => {
                for (j, comment) in comments.all.iter().enumerate() {
                    out.push_str(if i + j > 0 { " " } else { "" });
                    out.push_str(comment);
                }
            }
            RowPart::Cell(cell) => {
                let starts_group = section.is_some_and(|s| sections[s].starts_group(value));
                let gap = match i.checked_sub(1).map(|before| &parts[before]) {
                    None => 0,
                    Some(RowPart::Cell(_)) if starts_group => between(context.options),
                    Some(_) => 1,
                };
                spaces(out, missing + gap);
                match columns {
                    Some((columns, section)) => {
                        let column = (value - section.values.start) % section.group;
                        missing = columns[column].write(out, cell);
                    }
                    None => out.push_str(&cell.text),
                }
                value += 1;
            }
        }
    }
}
