//! The printed lines. Where the comments behind records go is known when all of them are printed.

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
    /// The lines, without the spaces between records and the comments behind them.
    text: String,
    /// The start of the line that is written now.
    line: usize,
    comments: Vec<Comment>,
    /// Whether the next comment starts a new column.
    apart: bool,
    last: Last,
    /// Whether what is written now is asked for, and where in `text` all that is stands.
    pub wanted: bool,
    found: Option<Range<usize>>,
}

/// A comment behind a line.
struct Comment {
    /// The comment's offset in the text.
    at: usize,
    /// The width of the text before the comment.
    code: u32,
    /// How far to the right it may begin.
    most: u32,
    /// Whether the comment starts a new column.
    apart: bool,
}

impl Comment {
    /// How far to the left it may begin.
    fn least(&self) -> u32 {
        self.code + GAP
    }
}

/// Number of spaces between a record and its comment.
const GAP: u32 = 2;

impl<'a> Page<'a> {
    /// An empty page, for about so many bytes.
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

    /// The page goes on where another one ended, with a record.
    pub(super) fn follows_record(&mut self) {
        self.last = Last::Record;
    }

    /// Writes a mark that begins the file without being a line.
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

    /// Begins a heading: there is a blank line before it, unless it belongs to comments above.
    pub(super) fn heading(&mut self) {
        self.end_column();
        if self.last == Last::Record {
            self.blank_line();
        }
    }

    /// Lines as they are.
    pub(super) fn verbatim(&mut self, text: &str) {
        self.end_column();
        self.put(text, Last::Record);
    }

    /// A line of comments.
    pub(super) fn comment(&mut self, text: &str) {
        self.end_column();
        self.put(text, Last::Comment);
    }

    fn put(&mut self, text: &str, last: Last) {
        self.text.push_str(text);
        self.break_line(last);
    }

    /// The next comment starts a new column.
    pub(super) fn end_column(&mut self) {
        self.apart = true;
    }

    /// The text that a line of a record is appended to, up to [`Page::end_line`].
    pub(super) fn line(&mut self) -> &mut String {
        &mut self.text
    }

    /// Ends a line of a record, with the comments behind it.
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

    /// Takes in the comment at some place of the line that is written now.
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
            // One that is too long wherever it stands may stand with the others.
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

/// The text of pages that follow one another, and where in it stands what is asked for.
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
            // What is found moves with the text.
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

/// A column shared by so many neighbouring comments; it may lie from `low` to `high`.
struct Column {
    comments: usize,
    low: u32,
    high: u32,
}

/// Columns of comments: as many comments as possible share one, as long as all of these stay within the width. (This is
/// how clang-format does it.)
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

/// Widens a stretch to what follows it.
fn extend(stretch: &mut Option<Range<usize>>, more: Range<usize>) {
    let start = stretch.as_ref().map_or(more.start, |s| s.start);
    *stretch = Some(start..more.end);
}
