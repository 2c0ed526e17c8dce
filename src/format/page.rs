//! The printed lines. The columns of the comments behind records are chosen when all lines are printed.

use std::iter;
use std::ops::Range;

use memchr::{memchr2, memrchr2};

use super::cell::spaces;
use super::options::Options;
use super::width::display_width;

/// The kind of the line that was printed last.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Last {
    /// A blank line, or no line yet.
    Blank,
    Comment,
    Record,
}

pub(super) struct Page<'a> {
    options: &'a Options,
    line_break: &'static str,
    /// The printed lines. The spaces before the comments behind records are still missing.
    text: String,
    /// The byte of `text` at which the current line starts.
    line: usize,
    comments: Vec<Comment>,
    /// Whether the next comment starts a new column.
    apart: bool,
    last: Last,
    /// Whether the current line is one of those that the caller asked for. `found` is the range of bytes of `text` with
    /// all of those lines.
    pub wanted: bool,
    found: Option<Range<usize>>,
}

/// A comment behind a line.
struct Comment {
    /// The byte of the page's text at which the comment starts.
    at: usize,
    /// The width of the line before the comment, in columns.
    code: u32,
    /// The rightmost column at which the comment may begin.
    most: u32,
    /// Whether the comment starts a new column.
    apart: bool,
}

impl Comment {
    /// The leftmost column at which the comment may begin.
    fn least(&self) -> u32 {
        self.code + GAP
    }
}

/// Number of spaces between a record and its comment.
const GAP: u32 = 2;

impl<'a> Page<'a> {
    /// An empty page with room for `capacity` bytes.
    pub(super) fn new(options: &'a Options, line_break: &'static str, capacity: usize) -> Page<'a> {
        Page {
            options,
            line_break,
            text: String::with_capacity(capacity),
            line: 0,
            comments: Vec::new(),
            apart: false,
            last: Last::Blank,
            wanted: true,
            found: None,
        }
    }

    /// Says that the page before this one ended with a record.
    pub(super) fn follows_record(&mut self) {
        self.last = Last::Record;
    }

    /// Writes a byte order mark at the start of the file. The mark takes no column of the first line.
    pub(super) fn mark(&mut self, mark: char) {
        self.text.push(mark);
        self.line = self.text.len();
    }

    pub(super) fn blank_line(&mut self) {
        self.end_column();
        if self.last != Last::Blank {
            self.text.push_str(self.line_break);
            self.line = self.text.len();
            self.last = Last::Blank;
        }
    }

    /// Begins a heading. If the line above is a record, writes a blank line first.
    pub(super) fn heading(&mut self) {
        self.end_column();
        if self.last == Last::Record {
            self.blank_line();
        }
    }

    /// Writes the lines of a record as they are.
    pub(super) fn verbatim(&mut self, text: &str) {
        self.end_column();
        self.put(text, Last::Record);
    }

    /// Writes a line of comments, or several.
    pub(super) fn comment(&mut self, text: &str) {
        self.end_column();
        self.put(text, Last::Comment);
    }

    fn put(&mut self, text: &str, last: Last) {
        self.text.push_str(text);
        self.break_line(last);
    }

    /// Says that the next comment behind a record starts a new column.
    pub(super) fn end_column(&mut self) {
        self.apart = true;
    }

    /// The text that a line of a record is appended to, up to [`Page::end_line`].
    pub(super) fn line(&mut self) -> &mut String {
        &mut self.text
    }

    /// Ends a line of a record and writes the comments behind the record.
    pub(super) fn end_line<'t>(&mut self, comments: impl Iterator<Item = &'t str>) {
        let code = self.text.len();
        for comment in comments {
            if self.text.len() > code {
                self.text.push(' ');
            }
            self.text.push_str(comment);
        }
        if self.text.len() > code {
            self.comment_at(code);
        }
        self.break_line(Last::Record);
    }

    fn break_line(&mut self, last: Last) {
        if self.wanted {
            extend(&mut self.found, self.line..self.text.len());
        }
        self.text.push_str(self.line_break);
        self.line = self.text.len();
        self.last = last;
    }

    /// Notes the comment that starts at byte `at` of the current line, and how far it may be moved.
    fn comment_at(&mut self, at: usize) {
        let line = &self.text[self.line..at];
        let last = memrchr2(b'\n', b'\r', line.as_bytes()).map_or(line, |i| &line[i + 1..]);
        let code = display_width(last);
        let one_line = last.len() == line.len();
        let least = code + GAP as usize;
        let mut most = least;
        if self.options.align && one_line {
            let comment = &self.text[at..];
            let end = memchr2(b'\n', b'\r', comment.as_bytes());
            let length = display_width(&comment[..end.unwrap_or(comment.len())]);
            let room = (self.options.width).checked_sub(length);
            // A comment that is too long for the width at any column may be aligned with the others all the same.
            let room = room.filter(|&room| room >= least);
            most = room.unwrap_or(self.options.width).max(least);
        }
        self.comments.push(Comment {
            at,
            code: code as u32,
            most: u32::try_from(most).unwrap_or(u32::MAX),
            apart: std::mem::take(&mut self.apart),
        });
    }
}

/// Joins pages that follow one another, and aligns their comments. Also returns the range of bytes of the lines that
/// the caller asked for.
pub(super) fn join(mut pages: Vec<Page>) -> (String, Option<Range<usize>>) {
    if let [page] = pages.as_mut_slice()
        && page.comments.is_empty()
    {
        return (std::mem::take(&mut page.text), page.found.take());
    }
    let columns = columns(&pages);
    let mut columns = columns
        .iter()
        .flat_map(|c| iter::repeat_n(c.low, c.comments));
    let mut out = String::with_capacity(pages.iter().map(|p| p.text.len()).sum());
    let mut found = None;
    for page in pages {
        let mut own = page
            .found
            .as_ref()
            .map(|f| out.len() + f.start..out.len() + f.end);
        let mut done = 0;
        // `zip` asks the comments first, so no column is lost when those of this page have ended.
        for (comment, column) in page.comments.iter().zip(&mut columns) {
            out.push_str(&page.text[done..comment.at]);
            done = comment.at;
            let at = out.len();
            let missing = (column - comment.code) as usize;
            spaces(&mut out, missing);
            // The range of the wanted lines moves with the text.
            if let Some(own) = &mut own {
                own.start += if at < own.start { missing } else { 0 };
                own.end += if at < own.end { missing } else { 0 };
            }
        }
        out.push_str(&page.text[done..]);
        if let Some(own) = own {
            extend(&mut found, own);
        }
    }
    (out, found)
}

/// A column that some neighbouring comments share. It may begin anywhere from `low` to `high`.
struct Column {
    comments: usize,
    low: u32,
    high: u32,
}

/// Chooses the columns of the comments: as many neighbours as possible share a column, as long as each of them fits
/// into the width there. (This is how clang-format does it.)
fn columns(pages: &[Page]) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    let mut apart = true;
    for page in pages {
        for comment in &page.comments {
            let alone = Column {
                comments: 1,
                low: comment.least(),
                high: comment.most,
            };
            let last = columns.last_mut().filter(|_| !comment.apart && !apart);
            let both = last.map(|c| (c.low.max(alone.low), c.high.min(alone.high), c));
            match both {
                Some((low, high, column)) if low <= high => {
                    let comments = column.comments + 1;
                    *column = Column {
                        comments,
                        low,
                        high,
                    };
                }
                _ => columns.push(alone),
            }
            apart = false;
        }
        apart |= page.apart;
    }
    columns
}

/// Extends a range of bytes by a range that follows it.
fn extend(stretch: &mut Option<Range<usize>>, more: Range<usize>) {
    let start = stretch.as_ref().map_or(more.start, |s| s.start);
    *stretch = Some(start..more.end);
}
