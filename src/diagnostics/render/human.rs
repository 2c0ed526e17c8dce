//! Findings for people: lines of the scene with arrows and texts, notes, help and fixes.

#![warn(missing_docs)]

use std::collections::BTreeMap;
use std::io::{self, Write};

use ariadne::{Cache, CharSet, Color, Config, Fmt, IndexType, Label, Report, ReportKind, Source};

use super::excerpt::{self, Excerpt, MARK};
use super::labels;
use super::visible;
use crate::diagnostics::layout::wrapped_if;
use crate::diagnostics::source::Locator;
use crate::diagnostics::wording::Wording;
use crate::diagnostics::{
    Applicability, Code, Diagnostic, Fix, Language, Severity, SourceFile, Span, Value,
};
use crate::parallel;

/// The largest number of lines between two places in the same section of a report: ariadne walks through all lines of a
/// section.
const LINES_BETWEEN_SECTIONS: usize = 50;
/// The look of findings that are shown to people.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// Whether the text has colours of a terminal.
    pub colour: bool,
    /// The language of the messages.
    pub language: Language,
    /// The largest width of lines in columns; `None` for no limit. Lines of the scene are never wrapped.
    pub width: Option<usize>,
}

/// Writes a file's findings, in the order they are given.
pub fn write(
    out: &mut dyn Write,
    file: &SourceFile,
    diagnostics: &[Diagnostic],
    look: Look,
) -> io::Result<()> {
    let mut locator = Locator::new(file);
    let mut folds: BTreeMap<&str, Fold> = BTreeMap::new();
    let mut rows: Vec<Row> = Vec::new();
    let mut is_shown = |d: &Diagnostic| {
        let fold = folds.entry(d.code.as_str()).or_insert(Fold {
            severity: d.severity,
            shown: 0,
            places: Vec::new(),
            more: 0,
        });
        if fold.shown == SHOWN {
            fold.add(d.span, &mut locator);
            return false;
        }
        fold.shown += 1;
        true
    };
    let mut shown: Vec<&Diagnostic> = Vec::new();
    for d in diagnostics {
        let is_shown = match d.is_error() {
            true => Row::add(&mut rows, d, file),
            false => is_shown(d),
        };
        shown.extend(is_shown.then_some(d));
    }
    // The errors of a short row are shown one by one.
    let few = |r: &&mut Row| r.more.len() < ROW;
    let back: Vec<&Diagnostic> = (rows.iter_mut().filter(few))
        .flat_map(|r| std::mem::take(&mut r.more))
        .collect();
    if !back.is_empty() {
        shown.extend(back);
        shown.sort_by_key(|d| (d.span, d.code.as_str()));
    }
    let printer = Printer {
        file,
        path: visible(&file.path).into_owned(),
        look,
    };
    // All errors are shown, and there may be very many. Threads word them side by side, but not all texts are in memory
    // at once.
    for some in shown.chunks(16 * TOGETHER) {
        let parts: Vec<_> = some.chunks(TOGETHER).collect();
        for text in parallel::map(parts.len(), |i| printer.texts(parts[i])) {
            out.write_all(&text?)?;
        }
    }
    for row in rows.iter().filter(|r| !r.more.is_empty()) {
        printer.write_row(out, row, &mut locator)?;
    }
    for (code, fold) in &folds {
        printer.write_fold(out, code, fold)?;
    }
    Ok(())
}

/// The number of findings that one thread puts into words at a time.
const TOGETHER: usize = 512;

/// The largest number of findings of one code that are shown; further ones in a file become a count. Errors become a
/// count only in rows.
const SHOWN: usize = 9;
/// The largest number of findings that are not shown but named by their places.
const PLACES: usize = 6;

/// The least width of notes, however narrow the terminal is.
const LEAST_ROOM: usize = 20;

/// The smallest number of records after the first one of a row that become a count.
const ROW: usize = 3;

/// Errors about records on successive lines with the same number of parameters too few or too many.
struct Row<'d> {
    first: &'d Diagnostic,
    more: Vec<&'d Diagnostic>,
    /// The line of the last record.
    line: usize,
}

impl<'d> Row<'d> {
    /// Adds an error to its row. Returns whether the error is the first of its row, or belongs to no row.
    fn add(rows: &mut Vec<Row<'d>>, d: &'d Diagnostic, file: &SourceFile) -> bool {
        if !matches!(d.code, Code::E008 | Code::E009) {
            return true;
        }
        let line = file.line_index(file.floor(d.span.start));
        match rows.last_mut() {
            Some(row) if row.line + 1 == line && row.is_like(d) => {
                row.line = line;
                row.more.push(d);
                false
            }
            _ => {
                rows.push(Row {
                    first: d,
                    more: Vec::new(),
                    line,
                });
                true
            }
        }
    }

    fn is_like(&self, d: &Diagnostic) -> bool {
        let first = self.first;
        (first.code, first.case, &first.values) == (d.code, d.case, &d.values)
    }
}

/// The findings of one code: how many are shown, and where the others are.
struct Fold {
    severity: Severity,
    shown: usize,
    /// The first places of findings that are not shown.
    places: Vec<String>,
    more: usize,
}

impl Fold {
    fn add(&mut self, span: Span, locator: &mut Locator) {
        if self.places.len() < PLACES {
            let place = locator.position(span.start);
            self.places.push(format!("{}:{}", place.line, place.column));
        }
        self.more += 1;
    }
}

struct Printer<'a> {
    file: &'a SourceFile,
    path: String,
    look: Look,
}

/// A place in a report.
struct Mark<'a> {
    span: Span,
    message: &'a str,
    primary: bool,
    line: usize,
    section: usize,
}

impl Printer<'_> {
    fn line(&self, span: Span) -> usize {
        self.file.line_index(self.file.floor(span.start))
    }

    /// Writes a line outside of the frame.
    fn say(&self, out: &mut dyn Write, line: &str) -> io::Result<()> {
        writeln!(out, "{}", wrapped_if(line, self.look.width, "  "))
    }

    /// The texts of some findings, one after the other.
    fn texts(&self, some: &[&Diagnostic]) -> io::Result<Vec<u8>> {
        let mut locator = Locator::new(self.file);
        let mut out = Vec::new();
        for d in some {
            self.write(&mut out, d, &mut locator)?;
        }
        Ok(out)
    }

    fn write(&self, out: &mut dyn Write, d: &Diagnostic, locator: &mut Locator) -> io::Result<()> {
        let language = self.look.language;
        let words = d.wording(language);
        let severity = language.say(d.severity.as_str(), &[]);
        let head = format!("{severity}[{}]:", d.code.as_str());
        let head = head.fg(self.paint(severity_colour(d.severity)));
        self.say(out, &format!("{head} {}", visible(&words.message)))?;

        let marks = self.marks(d, &words);
        let report = self.report(d, &words, &marks)?;
        self.put_places(out, &report, &marks, locator)?;
        writeln!(out)
    }

    fn write_row(&self, out: &mut dyn Write, row: &Row, locator: &mut Locator) -> io::Result<()> {
        let language = self.look.language;
        let severity = language.say(row.first.severity.as_str(), &[]);
        let head = format!("{severity}[{}]:", row.first.code.as_str());
        let head = head.fg(self.paint(severity_colour(row.first.severity)));
        let mut places: Vec<String> = (row.more.iter().take(PLACES))
            .map(|d| locator.position(d.span.start))
            .map(|place| format!("{}:{}", place.line, place.column))
            .collect();
        if row.more.len() > PLACES {
            places.push("…".to_owned());
        }
        let values = [
            ("count", Value::Count(row.more.len() as u64)),
            ("line", (self.line(row.first.span) + 1).to_string().into()),
            ("places", places.join(", ").into()),
        ];
        let text = language.say("folded-row", &values);
        self.say(out, &format!("{head} {text}"))?;
        writeln!(out)
    }

    fn write_fold(&self, out: &mut dyn Write, code: &str, fold: &Fold) -> io::Result<()> {
        if fold.more == 0 {
            return Ok(());
        }
        let language = self.look.language;
        let severity = language.say(fold.severity.as_str(), &[]);
        let head = format!("{severity}[{code}]:");
        let head = head.fg(self.paint(severity_colour(fold.severity)));
        let message = match fold.more > fold.places.len() {
            true => "folded-cut",
            false => "folded",
        };
        let values = [
            ("count", Value::Count(fold.more as u64)),
            ("places", fold.places.join(", ").into()),
        ];
        self.say(out, &format!("{head} {}", language.say(message, &values)))?;
        writeln!(out)
    }

    /// The places of a finding, sorted by section and line. The section of the primary place comes first.
    fn marks<'d>(&self, d: &Diagnostic, words: &'d Wording) -> Vec<Mark<'d>> {
        let here = self.line(d.span);
        let mut marks = vec![Mark {
            span: d.span,
            message: &words.label,
            primary: true,
            line: here,
            section: 0,
        }];
        for (i, (label, message)) in d.labels.iter().zip(&words.labels).enumerate() {
            let line = self.line(label.span);
            marks.push(Mark {
                span: label.span,
                message,
                primary: false,
                line,
                section: if line.abs_diff(here) <= LINES_BETWEEN_SECTIONS {
                    0
                } else {
                    i + 1
                },
            });
        }
        marks.sort_by_key(|m| (m.section, m.line));
        marks
    }

    /// The report without its first line, with [`MARK`]s for the places.
    fn report(&self, d: &Diagnostic, words: &Wording, marks: &[Mark]) -> io::Result<String> {
        let sections: Vec<(usize, Excerpt)> = (marks.chunk_by(|a, b| a.section == b.section))
            .map(|marks| {
                let excerpt = Excerpt::new(self.file, marks.iter().map(|m| m.span));
                (marks[0].section, excerpt)
            })
            .collect();
        let place = |span, section| {
            let excerpt = sections.iter().find(|s| s.0 == section);
            let place = excerpt.and_then(|s| s.1.place(self.file, span));
            (section, place.unwrap_or(0..1))
        };
        // Character indices: ariadne has the excerpt's characters, and cannot cut one in two.
        let config = Config::default()
            .with_color(self.look.colour)
            .with_index_type(IndexType::Char)
            .with_char_set(CharSet::Unicode);
        let mut report = Report::build(ReportKind::Error, place(d.span, 0)).with_config(config);
        for mark in marks {
            let colour = if mark.primary {
                severity_colour(d.severity)
            } else {
                Color::Cyan
            };
            report.add_label(
                Label::new(place(mark.span, mark.section))
                    .with_message(visible(mark.message))
                    .with_color(colour),
            );
        }
        // A note has less room by the margin with line numbers and by what the frame has before it: ` 12 │ Note: `, or
        // `Note 1: ` if there are several notes.
        let margin = excerpt::margin(&sections) + 2;
        let room = |several: bool| {
            let name = if several { 8 } else { 6 };
            self.look
                .width
                .map(|w| w.saturating_sub(margin + name).max(LEAST_ROOM))
        };
        let several = words.notes.len() > 1;
        for note in &words.notes {
            report.add_note(wrapped_if(&visible(note), room(several), ""));
        }
        let several = words.help.iter().count() + d.fixes.len() > 1;
        for help in self.helps(d, words, room(several)) {
            report.add_help(help);
        }
        let mut text = Vec::new();
        report
            .finish()
            .write_for_stdout(Sections(&sections), &mut text)?;
        // Ariadne's own first line does not know the severities note and style.
        let text = String::from_utf8_lossy(&text);
        let lines = text.lines().skip(1);
        let text = excerpt::with_line_numbers(lines, &sections);
        let text = match self.look.width {
            Some(width) => labels::within(&text, width),
            None => text,
        };
        Ok(match self.look.language {
            Language::English => text,
            Language::Czech => in_czech(&text),
        })
    }

    /// Writes a report, with the places in the file instead of the marked names.
    fn put_places(
        &self,
        out: &mut dyn Write,
        report: &str,
        marks: &[Mark],
        locator: &mut Locator,
    ) -> io::Result<()> {
        let mut pieces = report.split(MARK);
        write!(out, "{}", pieces.next().unwrap_or(""))?;
        while let (Some(section), Some(rest)) = (pieces.next(), pieces.next()) {
            let of_section = |m: &&Mark| m.section.to_string() == section;
            let mark = marks
                .iter()
                .filter(of_section)
                .max_by_key(|m| m.primary)
                .or(marks.first());
            let place = locator.position(mark.map_or(0, |m| m.span.start));
            let rest =
                rest.trim_start_matches(|c: char| c == ':' || c == '?' || c.is_ascii_digit());
            write!(out, "{}:{}:{}{rest}", self.path, place.line, place.column)?;
        }
        Ok(())
    }

    fn paint(&self, colour: Color) -> Option<Color> {
        self.look.colour.then_some(colour)
    }

    /// The help, and the proposals of the fixes. The reader is to choose one of the proposals.
    fn helps(&self, d: &Diagnostic, words: &Wording, width: Option<usize>) -> Vec<String> {
        let help = words
            .help
            .iter()
            .map(|h| wrapped_if(&visible(h), width, ""));
        let with_title = |message, title: String, line: usize| {
            let values = [
                ("title", title.into()),
                ("line", (line + 1).to_string().into()),
            ];
            self.look.language.say(message, &values)
        };
        let here = self.line(d.span);
        let fixes = d.fixes.iter().zip(&words.fixes).enumerate();
        let fixes = fixes.map(|(i, (fix, title))| {
            let title = match fix.edits.first().map(|e| self.line(e.span)) {
                // The fix is on another line than the finding.
                Some(line) if !self.touches(fix, here) => {
                    with_title("fix-on-line", title.clone(), line)
                }
                _ => title.clone(),
            };
            match i {
                0 => self.proposal(fix, &title, width),
                _ => self.proposal(fix, &with_title("or-fix", title, here), width),
            }
        });
        help.chain(fixes).collect()
    }

    /// Whether a line lies within those that a fix touches.
    fn touches(&self, fix: &Fix, line: usize) -> bool {
        let first = fix.edits.first().map(|e| self.line(e.span));
        let last = (fix.edits.last()).map(|e| self.file.line_index(self.file.floor(e.span.end)));
        first.is_some_and(|first| first <= line) && last.is_some_and(|last| line <= last)
    }

    /// The text of a fix: its title, and the lines as they would be.
    fn proposal(&self, fix: &Fix, title: &str, width: Option<usize>) -> String {
        let title = visible(title);
        let title = match fix.applicability {
            Applicability::Safe => title.into_owned(),
            Applicability::Unsafe | Applicability::Choice => {
                format!("{title} {}", self.look.language.say("guess", &[]))
            }
        };
        match fixed_lines(self.file, fix).as_slice() {
            [] => wrapped_if(&title, width, ""),
            lines => {
                let title = wrapped_if(&format!("{title}:"), width, "");
                format!("{title}\n{}", lines.join("\n"))
            }
        }
    }
}

fn severity_colour(severity: Severity) -> Color {
    match severity {
        Severity::Error => Color::Red,
        Severity::Warning => Color::Yellow,
        Severity::Note => Color::Blue,
        Severity::Style => Color::Magenta,
    }
}

/// The largest number of lines of a fix that are shown.
const FIX_LINES: usize = 8;
/// The largest number of bytes that these lines may have together to be shown.
const FIX_LINE: u32 = 200;

/// The lines that a fix touches, as they would be after it; no lines if they are too many or too long to be shown.
fn fixed_lines(file: &SourceFile, fix: &Fix) -> Vec<String> {
    let (Some(first), Some(last)) = (fix.edits.first(), fix.edits.last()) else {
        return Vec::new();
    };
    let start = file.line_index(file.floor(first.span.start));
    let mut end = file.line_index(file.floor(last.span.end));
    // A removal that ends at the start of a line does not touch that line.
    if last.text.is_empty() && start < end && file.line_span(end).start == last.span.end {
        end -= 1;
    }
    let lines = Span::new(file.line_span(start).start, file.line_span(end).end);
    if end.saturating_sub(start) >= FIX_LINES || lines.end.saturating_sub(lines.start) > FIX_LINE {
        return Vec::new();
    }
    let mut text = String::new();
    let mut at = lines.start;
    for edit in &fix.edits {
        let (from, to) = (edit.span.start.max(at), edit.span.end);
        text.push_str(file.slice(Span::new(at, from)));
        text.push_str(&edit.text);
        at = to.max(from);
    }
    text.push_str(file.slice(Span::new(at, lines.end.max(at))));
    text.lines()
        .take(FIX_LINES)
        .map(|line| excerpt::shorten(line.trim_start_matches('\u{feff}')))
        .collect()
}

/// Gives ariadne a source for each section of a report. A section is named by its number between marks.
struct Sections<'a>(&'a [(usize, Excerpt)]);

impl Cache<usize> for Sections<'_> {
    type Storage = String;

    fn fetch(&mut self, section: &usize) -> Result<&Source<String>, impl std::fmt::Debug> {
        let found = self.0.iter().find(|s| s.0 == *section);
        found.map(|s| &s.1.source).ok_or("there is no such section")
    }

    fn display<'a>(&self, section: &'a usize) -> Option<impl std::fmt::Display + 'a> {
        Some(format!("{MARK}{section}{MARK}"))
    }
}

#[cfg(test)]
mod tests;

/// Translates ariadne's labels into Czech. The label of notes becomes a letter longer, so that the lines below it move
/// by one column.
fn in_czech(text: &str) -> String {
    let mut out = String::new();
    let mut is_note = false;
    for line in text.split_inclusive('\n') {
        let line = line.replace("│ Help", "│ Rada");
        if line.contains("│ Note") {
            is_note = true;
            out += &line.replace("│ Note", "│ Pozn.");
        } else if is_note && line.contains("│       ") {
            out += &line.replacen("│       ", "│        ", 1);
        } else {
            is_note = false;
            out += &line;
        }
    }
    out
}
