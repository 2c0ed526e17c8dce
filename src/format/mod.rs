//! The pretty-printer: one record a line, numbers under each other, comments where they were. It needs
//! the tokens and the tree alone.
//!
//! All threads print a long file, each a part of it ([`document_range`]). A part is cut into chunks: the records and
//! comments that stand together on their lines ([`chunk`]). Chunks become lines with a record each ([`lines`]). Records
//! of one type are aligned as a run ([`run`]); matrices and long profiles take several lines ([`rows`]). A page holds
//! the lines of a part. The comments are aligned where the pages are joined ([`page`]).
//!
//! Two things in the language depend on layout, and the printer keeps both:
//!
//! - Optional parameters are present when just as many numbers are left on the line. A record is
//!   printed on one line and nothing but comments follows it there. (The exceptions, matrices and
//!   profiles in rows, have no optional parameters.)
//! - Where the scene has errors, the lines tell what was meant. Three kinds of lines are left as they are, to the byte:
//!   a line with a part that could not be read, a line with a comma that may be a decimal one, and the lines of a
//!   record that takes numbers from a line which would be a record of its own.
//!
//! The printer tests its result each time: the result is read again, and lines whose mistakes would be read differently
//! in the new layout stay as they are.

mod cell;
mod chunk;
mod compare;
pub mod difference;
mod document_range;
mod lines;
mod number;
mod options;
mod page;
mod rows;
mod run;
mod width;

use std::ops::{Range, RangeInclusive};

pub use compare::same_content;
pub use options::{Numbers, Options};

use crate::diagnostics::source::line_break;
use crate::diagnostics::{Edit, Span};
use crate::parallel;
use crate::syntax::table::RecordType;
use crate::syntax::{Document, Item, last_row, parse};
use cell::Context;
use chunk::{Chunk, Chunks};
use document_range::DocumentRange;
use lines::{Care, Printer};
use page::Page;

/// Prints a scene anew. `document` is the tree of `text`.
pub fn format(text: &str, document: &Document, options: &Options) -> String {
    attempt(text, document, options, None).map_or_else(|| text.to_owned(), |(printed, _)| printed)
}

/// The edit that gives the records which touch `lines`, counted from 1, the layout that they have when the whole scene
/// is formatted. `None` if they have that layout already.
pub fn format_range(
    text: &str,
    document: &Document,
    options: &Options,
    lines: RangeInclusive<usize>,
) -> Option<Edit> {
    let wanted = bytes_of(text, lines)?;
    attempt(text, document, options, Some(wanted))?.1
}

/// Prints the text anew. If `wanted`, a range of bytes, is given, only the records that touch it change, and the result
/// comes with the edit that changes them, if there is one. `None` if the content would not stay the same.
fn attempt(
    text: &str,
    document: &Document,
    options: &Options,
    wanted: Option<Range<usize>>,
) -> Option<(String, Option<Edit>)> {
    let broken = document.items.iter().any(|i| matches!(i, Item::Broken(_)));
    let mut care = Care {
        zeros: broken,
        // In another layout the mistake in these records could not be seen any more, or a correct record would look
        // wrong.
        items: (document.doubted.iter())
            .chain(&document.redefining)
            .copied()
            .chain(ending_with_record(document))
            .collect(),
    };
    for round in 0..ROUNDS {
        let (result, edit) = print(text, document, options, &care, wanted.clone());
        if result == text {
            return Some((result, None));
        }
        if !broken && compare::are_plainly_same(text, document, &result) {
            return Some((result, edit));
        }
        let (again, _) = parse(&result);
        let (before, after) = ((text, document), (result.as_str(), &again));
        let differences = compare::differences(before, after);
        if differences.is_empty() && compare::comments(before).eq(compare::comments(after)) {
            return Some((result, edit));
        }
        care.zeros = true;
        let reach = (1 << round) - 1;
        for i in differences {
            let near = i.saturating_sub(reach)..(i + reach + 1).min(document.items.len());
            care.items
                .extend(document.items[near].iter().map(|item| item.ends().0));
        }
    }
    None
}

/// The first tokens of the records whose last row would be a record of its own if it stood alone on its line.
fn ending_with_record(document: &Document) -> impl Iterator<Item = u32> {
    let has_rows = |ty: &RecordType| ty.vectors.len() > 2 && !ty.is_counted();
    let has_any = document.contents.any(has_rows);
    let items = if has_any { &document.items[..] } else { &[] };
    let records = items.iter().filter_map(Item::record);
    let ending = records
        .filter(move |r| has_rows(r.ty()) && last_row::is_record(r.ty(), document.values(r)));
    ending.map(|r| r.first)
}

/// The most attempts to print a scene. After each attempt the lines that were read differently stay as they are, with
/// more lines around them each time.
const ROUNDS: u32 = 7;

fn print(
    text: &str,
    document: &Document,
    options: &Options,
    care: &Care,
    wanted: Option<Range<usize>>,
) -> (String, Option<Edit>) {
    let context = Context {
        text,
        document,
        options,
    };
    let Some(wanted) = wanted else {
        return (print_all(&context, care, parallel::parts(text.len())), None);
    };
    let (page, source) = print_part(
        &context,
        care,
        &DocumentRange::whole(document),
        Some(&wanted),
    );
    let (printed, found) = page::join(vec![page]);
    let Some((source, found)) = source.zip(found) else {
        return (text.to_owned(), None);
    };
    let edit = Edit {
        span: Span::new(source.start as u32, source.end as u32),
        text: printed[found].to_owned(),
    };
    let result = [&text[..source.start], &edit.text, &text[source.end..]].concat();
    (result, Some(edit))
}

/// Prints a scene in up to `parts` parts, on all threads.
fn print_all(context: &Context, care: &Care, parts: usize) -> String {
    let parts = DocumentRange::cut(context.document, parts);
    let pages = parallel::map(parts.len(), |i| {
        print_part(context, care, &parts[i], None).0
    });
    page::join(pages).0
}

/// Prints a part of a scene. Also returns the range of bytes of the text's lines that touch `wanted`; `None` if none
/// do.
fn print_part<'a>(
    context: &Context<'a>,
    care: &'a Care,
    part: &DocumentRange,
    wanted: Option<&Range<usize>>,
) -> (Page<'a>, Option<Range<usize>>) {
    let Context {
        text,
        document,
        options,
    } = *context;
    let mut page = Page::new(options, line_break(text), part.length(document));
    if !part.is_first() {
        page.follows_record();
    } else if text.starts_with(BYTE_ORDER_MARK) {
        page.mark(BYTE_ORDER_MARK);
    }
    let mut printer = Printer::new(*context, care, page);
    let mut source: Option<Range<usize>> = None;
    let (mut chunks, mut chunk) = (Chunks::new(text, document, part), Chunk::default());
    while chunks.next(&mut chunk) {
        if chunk.after_blank_line {
            printer.blank_line();
        }
        let is_wanted = wanted.is_none_or(|wanted| {
            let lines = chunk.whole_lines(text, document);
            let touches = lines.start <= wanted.end && wanted.start <= lines.end;
            if touches {
                source = Some(source.clone().map_or(lines.start, |s| s.start)..lines.end);
            }
            touches
        });
        printer.chunk(&chunk, is_wanted);
    }
    (printer.finish(), source)
}

/// The range of bytes of some lines, counted from 1, without the last line break. `None` if the text has fewer lines.
fn bytes_of(text: &str, lines: RangeInclusive<usize>) -> Option<Range<usize>> {
    let bytes = text.as_bytes();
    let is_break = |i: &usize| match bytes[*i] {
        b'\n' => true,
        b'\r' => bytes.get(i + 1) != Some(&b'\n'),
        _ => false,
    };
    let mut breaks = (0..bytes.len()).filter(is_break);
    let start = match lines.start() {
        0 | 1 => 0,
        line => breaks.nth(line - 2)? + 1,
    };
    let further = lines.end().saturating_sub(*lines.start().max(&1));
    let end = breaks.nth(further).unwrap_or(text.len());
    Some(start..end)
}

const BYTE_ORDER_MARK: char = '\u{feff}';

#[cfg(test)]
mod tests;
