//! One record as text.

use super::number;
use crate::syntax::lexer::TokenKind;
use crate::syntax::table::{ParamKind, RecordType};
use crate::syntax::{Document, Item, Record};

/// How many numbers stand in a row of a matrix, and what stands before a row.
const ROW: usize = 4;
const INDENT: &str = "  ";

/// Prints an item. A broken one is printed as it is.
pub fn print(out: &mut String, text: &str, document: &Document, item: &Item, line_break: &str) {
    match item {
        Item::Void { .. } => out.push('0'),
        Item::Record(record) => print_record(out, text, document, record, line_break),
        Item::Broken(_) => out.push_str(&text[document.item_span(item).range()]),
    }
}

/// Prints a record: its tokens and the comments between them, one space apart; a matrix in rows.
fn print_record(
    out: &mut String,
    text: &str,
    document: &Document,
    record: &Record,
    line_break: &str,
) {
    let matrix = is_matrix(record.ty);
    // The number of values printed; the ID and the type are the first two.
    let mut values = 0;
    // The next thing starts a row, unless it is a comment behind what ends the row before it.
    let mut row_is_due = false;
    let mut last_end = None;
    for token in &document.tokens[record.first as usize..=record.last as usize] {
        let is_comment = token.kind.is_comment();
        if token.kind.is_trivia() && !is_comment {
            continue;
        }
        let span = token.span().range();
        if let Some(end) = last_end {
            let gap: &str = &text[end..span.start];
            let same_line = !gap.contains(['\n', '\r']);
            if row_is_due && !(is_comment && same_line) {
                out.push_str(line_break);
                out.push_str(INDENT);
                row_is_due = false;
            } else {
                out.push(' ');
            }
        }
        last_end = Some(span.end);
        let spelled = token.text(text);
        if is_comment {
            out.push_str(spelled);
            continue;
        }
        match (place(record, values), token.kind) {
            (Place::Integer, TokenKind::Integer) => out.push_str(&number::integer(spelled)),
            (Place::Real, TokenKind::Integer | TokenKind::Real) => {
                out.push_str(&number::real(spelled));
            }
            _ => out.push_str(spelled),
        }
        values += 1;
        // Rows end behind the type and behind every fourth parameter.
        row_is_due = matrix && values >= 2 && (values - 2) % ROW == 0;
    }
}

/// Whether the parameters are a 4×4 matrix.
fn is_matrix(ty: &RecordType) -> bool {
    ty.params.len() == ROW * ROW && ty.params[0].name == "m11"
}

/// What a value may be.
enum Place {
    Integer,
    Real,
    Name,
}

/// What the `i`-th value of a record may be, counting the ID and the type.
fn place(record: &Record, i: usize) -> Place {
    let Some(i) = i.checked_sub(2) else {
        return Place::Integer;
    };
    match record.ty.param(i, record.count as usize).map(|p| p.kind) {
        Some(ParamKind::Real) => Place::Real,
        Some(ParamKind::Integer | ParamKind::Count | ParamKind::Reference { .. }) => Place::Integer,
        Some(ParamKind::FileName) | None => Place::Name,
    }
}
