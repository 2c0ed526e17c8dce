//! Chunks to lines: records that stand together on a line of the file get a line each.

use std::collections::HashSet;

use super::cell::Context;
use super::chunk::{Chunk, Element, Fragment};
use super::page::Page;
use super::rows;
use super::run::{RecordLine, Run};
use crate::syntax::commented_out::is_commented_out;
use crate::syntax::lexer::Token;
use crate::syntax::{Item, is_directive};

/// The parts of the file's layout that the printer keeps, besides lines that could not be read in full.
#[derive(Debug, Default)]
pub(super) struct Care {
    /// The first tokens of items whose lines stay as they are.
    pub items: HashSet<u32>,
    /// Whether a `0` that introduces a comment behind a record stays.
    pub zeros: bool,
}

/// Puts the chunks of a file on a page, one after another.
pub(super) struct Printer<'a> {
    context: Context<'a>,
    care: &'a Care,
    pub page: Page<'a>,
    run: Run<'a>,
    /// The lines of the current chunk. The vector is kept, so that its memory is used again.
    lines: Vec<Line<'a>>,
    /// Whether a comment for zpg stands above, which is about the next record.
    spoken_to: bool,
}

/// A line to print: its item, if any, and the indices of its first and last token.
struct Line<'a> {
    item: Option<&'a Item>,
    first: u32,
    last: u32,
    /// Whether a `0` introduces the comment behind the record.
    has_zero: bool,
}

impl<'a> Printer<'a> {
    pub(super) fn new(context: Context<'a>, care: &'a Care, page: Page<'a>) -> Printer<'a> {
        Printer {
            context,
            care,
            page,
            run: Run::default(),
            lines: Vec::new(),
            spoken_to: false,
        }
    }

    pub(super) fn finish(mut self) -> Page<'a> {
        self.run.print(&self.context, &mut self.page);
        self.page
    }

    pub(super) fn blank_line(&mut self) {
        self.run.print(&self.context, &mut self.page);
        self.page.blank_line();
        self.spoken_to = false;
    }

    /// Prints a chunk.
    pub(super) fn chunk(&mut self, chunk: &Chunk<'a>, wanted: bool) {
        let mut lines = std::mem::take(&mut self.lines);
        set_lines(&mut lines, chunk, &self.context);
        let spoken_to = self.spoken_to || self.speaks(chunk);
        self.spoken_to = spoken_to && !lines.iter().any(Line::is_record);
        if chunk.is_frozen() || self.has_to_stay(chunk, &lines, spoken_to) {
            self.verbatim(chunk, &lines, wanted);
        } else {
            for line in &lines {
                match line.item {
                    Some(Item::Record(record)) => {
                        let tokens = (line.first, line.last);
                        let entry = RecordLine {
                            record,
                            tokens,
                            keeps_zero: line.has_zero && self.care.zeros,
                            wanted,
                        };
                        self.run.push(&self.context, &mut self.page, entry);
                    }
                    _ => self.text(line, wanted),
                }
            }
        }
        self.lines = lines;
    }

    /// Prints a chunk as it is.
    fn verbatim(&mut self, chunk: &Chunk<'a>, lines: &[Line], wanted: bool) {
        let Context { text, document, .. } = self.context;
        self.run.print(&self.context, &mut self.page);
        self.page.wanted = wanted;
        if lines.first().is_some_and(|line| self.is_heading(line)) {
            self.page.heading();
        }
        let text = &text[chunk.whole_lines(text, document)];
        if lines.iter().any(Line::is_record) {
            self.page.verbatim(text);
        } else {
            self.page.comment(text);
        }
    }

    /// Prints a line without a record: comments, a heading.
    fn text(&mut self, line: &Line, wanted: bool) {
        let context = &self.context;
        self.run.print(context, &mut self.page);
        self.page.wanted = wanted;
        let tokens = &context.document.tokens[line.first as usize..=line.last as usize];
        let texts = (tokens.iter())
            .filter(|t| t.kind().is_comment() || !t.kind().is_trivia())
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
        let is_for_people = |t: &Token| !is_directive(t, text) && !is_commented_out(t.text(text));
        matches!(line.item, Some(Item::Void { .. })) && tokens.iter().all(is_for_people)
    }

    /// Whether a line is printed in several rows. A number behind the last row could be read as part of a record with
    /// it.
    fn wraps(&self, line: &Line) -> bool {
        match line.item {
            Some(Item::Record(record)) => rows::is_wanted(&self.context, record),
            _ => false,
        }
    }

    /// Whether the lines of a chunk must stay as they are, since another layout could change their meaning.
    fn has_to_stay(&self, chunk: &Chunk, lines: &[Line], spoken_to: bool) -> bool {
        let is_kept = |item: &Item| self.care.items.contains(&item.ends().0);
        // A comment for zpg above a line is about all records on that line.
        (lines.len() > 1 && spoken_to)
            || (self.care.zeros
                && lines
                    .iter()
                    .any(|l| l.has_zero && (lines.len() > 1 || self.wraps(l))))
            || (!self.care.items.is_empty() && chunk.items().any(is_kept))
    }

    /// Whether the chunk has a comment for zpg.
    fn speaks(&self, chunk: &Chunk) -> bool {
        let Context { text, document, .. } = self.context;
        let speaks = |e: &Element| {
            let tokens = &document.tokens[e.first as usize..=e.last as usize];
            tokens.iter().any(|t| is_directive(t, text))
        };
        document.contents.directives && chunk.elements.iter().any(speaks)
    }
}

impl Line<'_> {
    fn is_record(&self) -> bool {
        matches!(self.item, Some(Item::Record(_) | Item::Broken(_)))
    }
}

/// Fills `lines` with the lines that a chunk becomes. Comments before the first item stay before it, and other comments
/// stay behind the item that they follow. A `0` at the end that only introduces a comment behind a record is dropped. A
/// `-0` introduces none.
fn set_lines<'a>(lines: &mut Vec<Line<'a>>, chunk: &Chunk<'a>, context: &Context) {
    lines.clear();
    let last_item = (chunk.elements.iter()).rposition(|e| !matches!(e.piece, Fragment::Comment));
    for (i, element) in chunk.elements.iter().enumerate() {
        let Element { first, last, .. } = *element;
        let item = match element.piece {
            Fragment::Comment | Fragment::Unread => None,
            Fragment::Item(item) => Some(item),
        };
        let is_zero = |token: u32| {
            let token = &context.document.tokens[token as usize];
            !token.text(context.text).starts_with('-')
        };
        let introduces = matches!(item, Some(Item::Void { token }) if is_zero(*token))
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
}
