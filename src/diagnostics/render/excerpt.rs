//! Excerpts of a file, with the lines that findings point at, as sources for ariadne.
//!
//! Ariadne indexes a whole source and prints whole lines. Scenes have many megabytes, sometimes on one line. Therefore
//! ariadne gets a stand-in: it reaches from the first line that is needed to the last one. Only lines that are needed
//! have text, and long ones only a window of it. The line numbers are corrected afterwards.

use ariadne::Source;

use super::{is_disruptive, visible_char};
use crate::diagnostics::{SourceFile, Span};

/// The largest number of characters of a line that is shown whole.
const WHOLE_LINE: usize = 200;
/// The number of characters of a longer line that are shown before the start of a span.
const BEFORE: usize = 60;
/// The number of characters that are shown from the start of the span on.
const AFTER: usize = 140;
/// The sign for the part of a line that is left out.
const ELLIPSIS: char = '…';

/// Marks a section's name in ariadne's output. The place in the file replaces the name afterwards: ariadne would count
/// lines and columns in the excerpt. The mark never occurs in what is printed.
pub(super) const MARK: char = '\u{1}';

/// A stand-in for some lines of a file that are close to each other.
pub(super) struct Excerpt {
    pub source: Source<String>,
    /// The lines with text, ascending.
    lines: Vec<Line>,
}

/// A line with text.
struct Line {
    /// The number of the line, from 0.
    number: usize,
    /// The stretch of the file's text that is shown.
    window: Span,
    /// The start of that stretch in the stand-in, in characters.
    start: usize,
}

impl Excerpt {
    /// An excerpt with the lines on which these spans start. Where several spans start on one long
    /// line, the window is around the first.
    pub(super) fn new(file: &SourceFile, spans: impl Iterator<Item = Span>) -> Excerpt {
        let mut starts: Vec<(usize, u32)> = spans
            .map(|span| {
                let at = file.floor(span.start);
                (file.line_index(at), at)
            })
            .collect();
        starts.sort_by_key(|&(number, _)| number);
        starts.dedup_by_key(|&mut (number, _)| number);

        let mut text = String::new();
        let mut lines = Vec::with_capacity(starts.len());
        let mut chars = 0;
        let mut next = starts.first().map_or(0, |first| first.0);
        for (number, at) in starts {
            let gap = number - next;
            text.extend(std::iter::repeat_n('\n', gap));
            chars += gap;
            let window = window(file, number, at);
            let whole = line(file, number);
            if window.start > whole.start {
                text.push(ELLIPSIS);
                chars += 1;
            }
            let start = chars;
            for c in file.slice(window).chars() {
                text.push(if c == '\t' { c } else { visible_char(c) });
                chars += 1;
            }
            if window.end < whole.end {
                text.push(ELLIPSIS);
                chars += 1;
            }
            // Ariadne drops spans that touch the end of a text without a line break.
            text.push('\n');
            chars += 1;
            next = number + 1;
            lines.push(Line {
                number,
                window,
                start,
            });
        }
        Excerpt {
            source: Source::from(text),
            lines,
        }
    }

    /// The numbers of the first and the last line, from 1 on.
    fn numbers(&self) -> [usize; 2] {
        [self.lines.first(), self.lines.last()].map(|line| line.map_or(1, |l| l.number + 1))
    }

    /// The range of a span in the stand-in, in characters. It has at least one, and ends at the latest where the shown
    /// part of its first line does. `None` if the span's start is not shown.
    pub(super) fn place(&self, file: &SourceFile, span: Span) -> Option<std::ops::Range<usize>> {
        let from = file.floor(span.start);
        let number = file.line_index(from);
        let i = self
            .lines
            .binary_search_by_key(&number, |l| l.number)
            .ok()?;
        let line = &self.lines[i];
        let Span { start, end } = line.window;
        // A line break or a byte order mark counts as the place beside it.
        let from = from.clamp(start, end.max(start));
        if span.start > end && self::line(file, number).end > end {
            return None;
        }
        if span.start < start && self::line(file, number).start < start {
            return None;
        }
        let to = file.floor(span.end).clamp(from, end);
        let chars = |a: u32, b: u32| file.slice(Span::new(a, b)).chars().count();
        let first = line.start + chars(start, from);
        Some(first..first + chars(from, to).max(1))
    }
}

/// Replaces the line numbers in ariadne's lines by those in the file, in a margin that is wide enough for them.
pub(super) fn with_line_numbers<'a>(
    lines: impl Iterator<Item = &'a str>,
    sections: &[(usize, Excerpt)],
) -> String {
    let all = || sections.iter().map(|(_, excerpt)| excerpt);
    let ours = margin(sections) - 2;
    let theirs = all()
        .map(|e| e.numbers()[1] + 1 - e.numbers()[0])
        .map(digits);
    let theirs = theirs.max().unwrap_or(1);
    let mut first = 1;
    let mut out = String::new();
    for line in lines {
        if let Some(section) = line.split(MARK).nth(1) {
            let named = |s: &&(usize, Excerpt)| s.0.to_string() == section;
            first = sections.iter().find(named).map_or(1, |s| s.1.numbers()[0]);
        }
        let margin = Margin::of(line, theirs + 2);
        let text = match margin.text.trim().parse::<usize>() {
            Ok(number) => format!(" {:>ours$} ", number + first - 1),
            Err(_) => {
                let fill = margin.text.chars().next().unwrap_or(' ');
                std::iter::repeat_n(fill, ours + 2).collect()
            }
        };
        // Escape sequences in the first two columns keep their place, all others come behind the margin.
        let mut colours = margin.colours.into_iter().peekable();
        for (i, c) in text.chars().enumerate() {
            while let Some((_, colour)) = colours.next_if(|(at, _)| i <= 1 && *at <= i) {
                out += colour;
            }
            out.push(c);
        }
        out.extend(colours.map(|(_, colour)| colour));
        let rest = margin.rest;
        let end = out.len();
        out += rest;
        out.truncate(out.trim_end().len().max(end));
        out.push('\n');
    }
    out
}

/// The width of the margin: a space on each side of the largest number.
pub(super) fn margin(sections: &[(usize, Excerpt)]) -> usize {
    let last = sections.iter().map(|(_, excerpt)| excerpt.numbers()[1]);
    last.map(digits).max().unwrap_or(1) + 2
}

fn digits(number: usize) -> usize {
    number.checked_ilog10().unwrap_or(0) as usize + 1
}

/// The margin before the text on a line of ariadne's output.
struct Margin<'a> {
    text: String,
    /// The escape sequences, each with the number of the margin's characters before it.
    colours: Vec<(usize, &'a str)>,
    rest: &'a str,
}

impl<'a> Margin<'a> {
    fn of(line: &'a str, width: usize) -> Margin<'a> {
        let mut margin = Margin {
            text: String::new(),
            colours: Vec::new(),
            rest: line,
        };
        let mut count = 0;
        while let Some(c) = margin.rest.chars().next() {
            let end = match c {
                '\u{1b}' => margin.rest.find('m').map_or(margin.rest.len(), |i| i + 1),
                _ if count == width => break,
                _ => c.len_utf8(),
            };
            let (head, rest) = margin.rest.split_at(end);
            match c {
                '\u{1b}' => margin.colours.push((count, head)),
                _ => {
                    margin.text.push(c);
                    count += 1;
                }
            }
            margin.rest = rest;
        }
        margin
    }
}

/// The span of a line without its line break and without a byte order mark.
fn line(file: &SourceFile, number: usize) -> Span {
    let Span { mut start, end } = file.line_span(number);
    if number == 0 && file.text.starts_with('\u{feff}') {
        start = (start + 3).min(end);
    }
    Span::new(start, end)
}

/// The part of a line that is shown, around an offset in it.
fn window(file: &SourceFile, number: usize, at: u32) -> Span {
    let whole = line(file, number);
    if file.slice(whole).chars().nth(WHOLE_LINE).is_none() {
        return whole;
    }
    let at = at.clamp(whole.start, whole.end);
    let start = file
        .slice(Span::new(whole.start, at))
        .char_indices()
        .rev()
        .nth(BEFORE - 1)
        .map_or(whole.start, |(i, _)| whole.start + i as u32);
    let end = file
        .slice(Span::new(at, whole.end))
        .char_indices()
        .nth(AFTER)
        .map_or(whole.end, |(i, _)| at + i as u32);
    Span::new(start, end)
}

/// A line that is safe to print, cut if it is long.
pub(super) fn shorten(text: &str) -> String {
    let mut out: String = text.chars().take(AFTER).map(visible_char).collect();
    if text.chars().nth(AFTER).is_some() {
        out.push(ELLIPSIS);
    }
    debug_assert!(!out.contains(is_disruptive));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(excerpt: &Excerpt, place: std::ops::Range<usize>) -> String {
        let text = excerpt.source.text();
        text.chars().skip(place.start).take(place.len()).collect()
    }

    #[test]
    fn only_the_lines_needed_have_text() {
        let file = SourceFile::new("a", "\u{feff}2 9 ž\r\n3 9 1\r\n\r\n4 9 2".into());
        let first = Span::new(7, 9);
        let last = Span::new(file.text.len() as u32, file.text.len() as u32);
        let excerpt = Excerpt::new(&file, [last, first].into_iter());
        assert_eq!(excerpt.source.text(), "2 9 ž\n\n\n4 9 2\n");
        let place = excerpt.place(&file, first).unwrap();
        assert_eq!(shown(&excerpt, place), "ž");
        assert!(excerpt.place(&file, last).is_some());
        assert!(excerpt.place(&file, Span::new(13, 14)).is_none());
    }

    #[test]
    fn a_long_line_is_cut_around_what_matters() {
        let text = format!("{}x{}", "žž ".repeat(1_000), " 1".repeat(1_000));
        let at = text.find('x').unwrap() as u32;
        let file = SourceFile::new("a", text.into());
        let span = Span::new(at, at + 1);
        let excerpt = Excerpt::new(&file, std::iter::once(span));
        assert_eq!(
            excerpt.source.text().chars().count(),
            BEFORE + AFTER + "……\n".chars().count()
        );
        let place = excerpt.place(&file, span).unwrap();
        assert_eq!(shown(&excerpt, place), "x");
        assert!(excerpt.place(&file, Span::new(0, 1)).is_none());
        assert!(
            excerpt
                .place(&file, Span::new(at + 900, at + 901))
                .is_none()
        );
    }
}
