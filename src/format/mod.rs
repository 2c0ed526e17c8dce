//! The pretty-printer: one record a line, numbers in their shortest spelling, comments where they
//! were. It needs the tokens and the tree alone.
//!
//! Two things in the language depend on layout, and this is how they are kept:
//!
//! - Optional parameters are present when just as many numbers are left on the line. A record is
//!   printed on one line and nothing but comments follows it there. (The exception, matrices in four
//!   rows, have no optional parameters.)
//! - Where the scene has errors, the lines tell what was meant. A line with something on it that
//!   could not be read is left as it is, to the byte.
//!
//! Whether that worked can be tested: [`same_content`].

mod chunk;
mod compare;
mod number;
mod record;

pub use compare::same_content;

use crate::syntax::Document;
use chunk::{Chunk, Element, Piece};

/// Prints a scene anew. `document` is the tree of `text`.
pub fn format(text: &str, document: &Document) -> String {
    let mut out = String::with_capacity(text.len());
    let line_break = line_break(text);
    if text.starts_with(BYTE_ORDER_MARK) {
        out.push(BYTE_ORDER_MARK);
    }
    let mut last_end = None;
    for chunk in chunk::chunks(text, document) {
        let span = chunk.span();
        if let Some(end) = last_end {
            let breaks = chunk::line_breaks(&text[end..span.start]);
            out.push_str(if breaks > 1 { line_break } else { "" });
        }
        last_end = Some(span.end);
        if chunk.is_frozen() {
            out.push_str(chunk.whole_lines(text));
        } else {
            print_chunk(&mut out, text, document, &chunk, line_break);
        }
        out.push_str(line_break);
    }
    out
}

const BYTE_ORDER_MARK: char = '\u{feff}';

/// The line break of the file, which is that of its first line.
fn line_break(text: &str) -> &'static str {
    match text.find(['\n', '\r']) {
        Some(at) if text[at..].starts_with("\r\n") => "\r\n",
        _ => "\n",
    }
}

/// Prints what stands on a line, a line for each record; the last line without its line break.
/// Comments before the first record stay before it, others stay behind the record they follow.
fn print_chunk(out: &mut String, text: &str, document: &Document, chunk: &Chunk, line_break: &str) {
    let mut line_has_record = false;
    for (i, Element { piece, .. }) in chunk.elements.iter().enumerate() {
        let is_record = !matches!(piece, Piece::Comment(_));
        if is_record && line_has_record {
            out.push_str(line_break);
        } else if i > 0 {
            out.push(' ');
        }
        line_has_record |= is_record;
        match *piece {
            Piece::Comment(token) | Piece::Unread(token) => {
                out.push_str(document.tokens[token as usize].text(text));
            }
            Piece::Item(item) => record::print(out, text, document, &item, line_break),
        }
    }
}

#[cfg(test)]
mod tests;
