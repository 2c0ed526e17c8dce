//! The printed lines. Those of neighbouring records are held back until it is known where their
//! comments go.

use std::ops::Range;

use super::cell::spaces;
use super::options::Options;

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
    /// The lines held back, and their characters.
    lines: Vec<Line>,
    held: String,
    /// Whether what is written now is asked for, and where in `out` all that is stands.
    pub wanted: bool,
    pub found: Option<Range<usize>>,
}

/// A line of a record, in the characters held back.
struct Line {
    /// One past the last number.
    code: usize,
    end: usize,
    wanted: bool,
}

/// Between a record and its comment.
const GAP: usize = 2;
/// Comments may have these in them.
const BREAKS: [char; 2] = ['\n', '\r'];

impl<'a> Page<'a> {
    pub fn new(options: &'a Options, line_break: &'static str, capacity: usize) -> Page<'a> {
        Page {
            options,
            line_break,
            out: String::with_capacity(capacity),
            last: Last::Blank,
            lines: Vec::new(),
            held: String::new(),
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
            self.find(start, end);
        }
    }

    fn find(&mut self, start: usize, end: usize) {
        let start = self.found.as_ref().map_or(start, |f| f.start);
        self.found = Some(start..end);
    }

    /// Where a line of a record is written, up to [`Page::end_line`].
    pub fn line(&mut self) -> &mut String {
        &mut self.held
    }

    /// Ends a line of a record, with the comments behind it.
    pub fn end_line<'t>(&mut self, comments: impl Iterator<Item = &'t str>) {
        let code = self.held.len();
        for comment in comments {
            if self.held.len() > code {
                self.held.push(' ');
            }
            self.held.push_str(comment);
        }
        let end = self.held.len();
        let wanted = self.wanted;
        self.lines.push(Line { code, end, wanted });
    }

    /// Puts out the lines held back: as many as possible have their comments in one column, as long
    /// as all of these stay within the width. (This is how clang-format does it.)
    pub fn flush(&mut self) {
        if self.lines.is_empty() {
            return;
        }
        let lines = std::mem::take(&mut self.lines);
        let held = std::mem::take(&mut self.held);
        let (mut first, mut low, mut high) = (0, 0, usize::MAX);
        let mut start = 0;
        for (i, line) in lines.iter().enumerate() {
            let code = &held[start..line.code];
            let comment = &held[line.code..line.end];
            start = line.end;
            if comment.is_empty() {
                continue;
            }
            let (least, most) = self.columns(code, comment);
            if low.max(least) > high.min(most) {
                self.write(&held, &lines, first..i, low);
                (first, low, high) = (i, least, most);
            } else {
                (low, high) = (low.max(least), high.min(most));
            }
        }
        self.write(&held, &lines, first..lines.len(), low);
        self.last = Last::Record;
        // The room is used again.
        (self.lines, self.held) = (lines, held);
        self.lines.clear();
        self.held.clear();
    }

    /// From where to where the comment behind some code may begin.
    fn columns(&self, code: &str, comment: &str) -> (usize, usize) {
        let one_line = !code.contains(BREAKS);
        let least = width(code.rsplit(BREAKS).next().unwrap_or_default()) + GAP;
        if !self.options.align || !one_line {
            return (least, least);
        }
        let length = width(comment.split(BREAKS).next().unwrap_or_default());
        let most = match self.options.width.checked_sub(length) {
            Some(most) if most >= least => most,
            // It is too long wherever it stands.
            _ => self.options.width,
        };
        (least, most.max(least))
    }

    /// Puts out some of the lines with their comments in a column.
    fn write(&mut self, held: &str, lines: &[Line], which: Range<usize>, column: usize) {
        let mut start = which.start.checked_sub(1).map_or(0, |i| lines[i].end);
        for line in &lines[which] {
            let at = self.out.len();
            let code = &held[start..line.code];
            self.out.push_str(code);
            if line.end > line.code {
                let last = code.rsplit(BREAKS).next().unwrap_or_default();
                spaces(&mut self.out, column.saturating_sub(width(last)).max(GAP));
                self.out.push_str(&held[line.code..line.end]);
            }
            if line.wanted {
                self.find(at, self.out.len());
            }
            self.out.push_str(self.line_break);
            start = line.end;
        }
    }
}

fn width(text: &str) -> usize {
    text.chars().count()
}
