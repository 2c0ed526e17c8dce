//! The printed lines. Those of neighbouring records are held back until it is known where their
//! comments go.

use std::ops::Range;

use memchr::{memchr2, memrchr2};

use super::cell::spaces;
use super::options::Options;
use super::width::display_width;

/// What was printed last.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Last {
    /// Nothing, or a blank line.
    Blank,
    Comment,
    Record,
}

pub struct Page<'a> {
    options: &'a Options,
    line_break: &'static str,
    out: String,
    last: Last,
    held: Held,
    /// Whether what is written now is asked for, and where in `out` all that is stands.
    pub wanted: bool,
    found: Option<Range<usize>>,
}

/// Lines of records held back, from the first with a comment on, and the one that is written now.
#[derive(Default)]
struct Held {
    /// The lines, without the spaces before the comments.
    text: String,
    /// Where the line begins that is written now.
    line: usize,
    comments: Vec<Comment>,
    /// From where to where the column of the comments may be; there are some.
    columns: (usize, usize),
    /// Where what is asked for stands.
    found: Option<Range<usize>>,
}

/// A comment behind a line.
struct Comment {
    /// Its place in the text.
    at: usize,
    /// The width of what stands before it.
    code: usize,
}

/// Between a record and its comment.
const GAP: usize = 2;

impl<'a> Page<'a> {
    pub fn new(options: &'a Options, line_break: &'static str, capacity: usize) -> Page<'a> {
        Page {
            options,
            line_break,
            out: String::with_capacity(capacity),
            last: Last::Blank,
            held: Held::default(),
            wanted: true,
            found: None,
        }
    }

    /// The whole text.
    pub fn finish(mut self) -> (String, Option<Range<usize>>) {
        self.flush();
        (self.out, self.found)
    }

    /// What begins the file without being a line.
    pub fn mark(&mut self, mark: char) {
        self.out.push(mark);
    }

    pub fn blank_line(&mut self) {
        self.flush();
        if self.last != Last::Blank {
            self.out.push_str(self.line_break);
            self.last = Last::Blank;
        }
    }

    /// Begins a heading: there is a blank line before it, unless it belongs to comments above.
    pub fn heading(&mut self) {
        self.flush();
        if self.last == Last::Record {
            self.blank_line();
        }
    }

    /// Lines as they are.
    pub fn verbatim(&mut self, text: &str) {
        self.flush();
        self.put(text, Last::Record);
    }

    /// A line of comments.
    pub fn comment(&mut self, text: &str) {
        self.flush();
        self.put(text, Last::Comment);
    }

    fn put(&mut self, text: &str, last: Last) {
        let start = self.out.len();
        self.out.push_str(text);
        let end = self.out.len();
        self.out.push_str(self.line_break);
        self.last = last;
        if self.wanted {
            extend(&mut self.found, start..end);
        }
    }

    /// Where a line of a record is written, up to [`Page::end_line`].
    pub fn line(&mut self) -> &mut String {
        &mut self.held.text
    }

    /// Ends a line of a record, with the comments behind it.
    pub fn end_line<'t>(&mut self, comments: impl Iterator<Item = &'t str>) {
        let held = &mut self.held;
        let code = held.text.len();
        for comment in comments {
            if held.text.len() > code {
                held.text.push(' ');
            }
            held.text.push_str(comment);
        }
        if held.text.len() > code {
            self.align(code);
        }
        let held = &mut self.held;
        if self.wanted {
            extend(&mut held.found, held.line..held.text.len());
        }
        held.text.push_str(self.line_break);
        held.line = held.text.len();
        self.last = Last::Record;
        if held.comments.is_empty() {
            self.flush();
        }
    }

    /// Takes in the comment at some place of the line that is written now. As many lines as possible have
    /// theirs in one column, as long as all of these stay within the width. (This is how clang-format
    /// does it.)
    fn align(&mut self, at: usize) {
        let mut at = at;
        let line = &self.held.text[self.held.line..at];
        let last = memrchr2(b'\n', b'\r', line.as_bytes()).map_or(line, |i| &line[i + 1..]);
        let code = display_width(last);
        let one_line = last.len() == line.len();
        let least = code + GAP;
        let mut most = least;
        if self.options.align && one_line {
            let comment = &self.held.text[at..];
            let end = memchr2(b'\n', b'\r', comment.as_bytes());
            let length = display_width(&comment[..end.unwrap_or(comment.len())]);
            let room = (self.options.width).checked_sub(length);
            // One that is too long wherever it stands may stand with the others.
            let room = room.filter(|&room| room >= least);
            most = room.unwrap_or(self.options.width).max(least);
        }
        let both = match self.held.columns {
            _ if self.held.comments.is_empty() => (least, most),
            (low, high) => (low.max(least), high.min(most)),
        };
        if both.0 <= both.1 {
            self.held.columns = both;
        } else {
            at -= self.held.line;
            self.flush();
            self.held.columns = (least, most);
        }
        self.held.comments.push(Comment { at, code });
    }

    /// Puts out the lines held back, with their comments in one column, but for the one that is written now.
    pub fn flush(&mut self) {
        let (held, out) = (&mut self.held, &mut self.out);
        let mut done = 0;
        // What is found moves with the text.
        let mut found = (held.found.as_ref()).map(|f| f.start + out.len()..f.end + out.len());
        for &Comment { at, code } in &held.comments {
            out.push_str(&held.text[done..at]);
            let missing = held.columns.0.saturating_sub(code).max(GAP);
            spaces(out, missing);
            if let Some((found, old)) = found.as_mut().zip(held.found.as_ref()) {
                found.start += if at < old.start { missing } else { 0 };
                found.end += if at < old.end { missing } else { 0 };
            }
            done = at;
        }
        out.push_str(&held.text[done..held.line]);
        if let Some(found) = found {
            extend(&mut self.found, found);
        }
        held.text.drain(..held.line);
        held.line = 0;
        held.comments.clear();
        held.found = None;
    }
}

/// Widens a stretch to what follows it.
fn extend(stretch: &mut Option<Range<usize>>, more: Range<usize>) {
    let start = stretch.as_ref().map_or(more.start, |s| s.start);
    *stretch = Some(start..more.end);
}
