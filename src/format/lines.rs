//! Chunks to lines: what stands together in the file is taken apart, a line for each record.

use std::collections::HashSet;

use super::cell::Context;
use super::chunk::{Chunk, Piece};
use super::page::Page;
use super::run::{Entry, Run};
use crate::syntax::{Item, is_directive};

/// What of the file's own layout is kept, besides the lines with something that could not be read.
#[derive(Debug, Default)]
pub struct Care {
    /// The first tokens of items whose lines stay as they are.
    pub items: HashSet<u32>,
    /// A `0` that introduces a comment behind a record stays.
    pub zeros: bool,
}

/// Puts the chunks of a file on a page, one after another.
pub struct Printer<'a> {
    context: Context<'a>,
    care: &'a Care,
    pub page: Page<'a>,
    run: Run,
    /// A comment above speaks to the next line.
    spoken_to: bool,
}

/// A line to be: its item, and all of its tokens.
struct Line {
    item: Option<Item>,
    first: u32,
    last: u32,
    /// A `0` introduces the comment behind the record.
    has_zero: bool,
}

impl<'a> Printer<'a> {
    pub fn new(context: Context<'a>, care: &'a Care, page: Page<'a>) -> Printer<'a> {
        Printer {
            context,
            care,
            page,
            run: Run::default(),
            spoken_to: false,
        }
    }

    pub fn finish(mut self) -> Page<'a> {
        self.run.print(&self.context, &mut self.page);
        self.page
    }

    pub fn blank_line(&mut self) {
        self.run.print(&self.context, &mut self.page);
        self.page.blank_line();
        self.spoken_to = false;
    }

    /// Prints a chunk.
    pub fn chunk(&mut self, chunk: &Chunk, wanted: bool) {
        let context = self.context;
        let lines = lines(chunk);
        let is_record = |l: &Line| matches!(l.item, Some(Item::Record(_) | Item::Broken(_)));
        let spoken_to = self.spoken_to || self.speaks(chunk);
        self.spoken_to = spoken_to && !lines.iter().any(is_record);
        if chunk.is_frozen() || self.has_to_stay(chunk, &lines, spoken_to) {
            self.run.print(&context, &mut self.page);
            self.page.wanted = wanted;
            if self.is_heading(&lines[0]) {
                self.page.heading();
            }
            let text = &context.text[chunk.whole_lines(context.text)];
            if lines.iter().any(is_record) {
                self.page.verbatim(text);
            } else {
                self.page.comment(text);
            }
            return;
        }
        for line in lines {
            if let Some(Item::Record(record)) = line.item {
                let tokens = (line.first, line.last);
                let entry = Entry {
                    record,
                    tokens,
                    wanted,
                };
                self.run.push(&context, &mut self.page, entry);
            } else {
                self.text(&line, wanted);
            }
        }
    }

    /// Prints a line without a record: comments, a heading.
    fn text(&mut self, line: &Line, wanted: bool) {
        let context = &self.context;
        self.run.print(context, &mut self.page);
        self.page.wanted = wanted;
        let tokens = &context.document.tokens[line.first as usize..=line.last as usize];
        let texts = (tokens.iter())
            .filter(|t| t.kind.is_comment() || !t.kind.is_trivia())
            .map(|t| t.text(context.text));
        let text = texts.collect::<Vec<_>>().join(" ");
        if self.is_heading(line) {
            self.page.heading();
        }
        self.page.comment(&text);
    }

    /// Whether a line is a `0` with a comment for people.
    fn is_heading(&self, line: &Line) -> bool {
        let Context { text, document, .. } = self.context;
        let tokens = &document.tokens[line.first as usize..=line.last as usize];
        matches!(line.item, Some(Item::Void { .. }))
            && !tokens.iter().any(|t| is_directive(t, text))
    }

    /// Whether another layout could change what is meant.
    fn has_to_stay(&self, chunk: &Chunk, lines: &[Line], spoken_to: bool) -> bool {
        let is_kept = |item: &Item| self.care.items.contains(&item.ends().0);
        // What is said to a line is said to all of its records.
        (lines.len() > 1 && spoken_to)
            || (self.care.zeros && lines.iter().any(|l| l.has_zero))
            || chunk.items().any(is_kept)
    }

    /// Whether one of its comments is for zpg.
    fn speaks(&self, chunk: &Chunk) -> bool {
        let Context { text, document, .. } = self.context;
        let tokens = chunk.elements.iter().flat_map(|e| match e.piece {
            Piece::Comment(token) | Piece::Unread(token) => token..=token,
            Piece::Item(item) => item.ends().0..=item.ends().1,
        });
        tokens
            .map(|t| &document.tokens[t as usize])
            .any(|t| is_directive(t, text))
    }
}

/// The lines a chunk becomes. Comments before the first item stay before it, others stay behind the
/// item they follow. A `0` at the end that merely introduces a comment behind a record goes.
fn lines(chunk: &Chunk) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let last_item = (chunk.elements.iter()).rposition(|e| !matches!(e.piece, Piece::Comment(_)));
    for (i, element) in chunk.elements.iter().enumerate() {
        let (item, first, last) = match element.piece {
            Piece::Comment(token) => (None, token, token),
            Piece::Item(item) => (Some(item), item.ends().0, item.ends().1),
            Piece::Unread(token) => (None, token, token),
        };
        let introduces = matches!(item, Some(Item::Void { .. }))
            && Some(i) == last_item
            && i + 1 < chunk.elements.len();
        match lines.last_mut() {
            Some(line) if item.is_none() => line.last = last,
            Some(line) if line.item.is_none() => (line.item, line.last) = (item, last),
            Some(line) if introduces && matches!(line.item, Some(Item::Record(_))) => {
                (line.last, line.has_zero) = (last, true);
            }
            _ => lines.push(Line {
                item,
                first,
                last,
                has_zero: false,
            }),
        }
    }
    lines
}
