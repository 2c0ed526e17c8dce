//! Fits the texts of labels into the width of a terminal. Ariadne puts each text on one line, behind an arrow:
//!
//! ```text
//!  3 │ 30 11 0 0 0 -1
//!    │ ─┬          ─┬
//!    │  │           ╰── a text
//!    │  ╰────────────── another one that goes on
//!    │                  here
//! ```

use unicode_width::UnicodeWidthChar as _;

use crate::diagnostics::layout::wrapped;

/// The least width of a text. A text with less room begins farther left, on a line of its own.
const MIN_TEXT_WIDTH: usize = 36;

/// A report in which each label has as many lines as it needs to fit the width.
pub(super) fn within(report: &str, width: usize) -> String {
    let mut out = String::with_capacity(report.len());
    for line in report.lines() {
        match Label::of(line).filter(|label| label.end > width) {
            Some(label) => label.write(&mut out, width),
            None => out.push_str(line),
        }
        out.push('\n');
    }
    out
}

struct Label<'l> {
    /// The arrow with everything before it on the line, and the colours.
    before: &'l str,
    text: &'l str,
    /// The column where the text begins.
    start: usize,
    /// The column where the text ends.
    end: usize,
}

impl<'l> Label<'l> {
    /// The label on a line, if there is one.
    fn of(line: &'l str) -> Option<Label<'l>> {
        // A line of the scene has a number before the margin.
        let corner = line.find('╰')?;
        let is_margin = |c: char| matches!(c, '│' | '┆' | ' ');
        let head: String = seen(line[..corner].chars()).collect();
        if !head.chars().all(is_margin) {
            return None;
        }
        let arrow = |c: char| matches!(c, '╰' | '─' | '┴' | '│' | '┼');
        let mut at = corner;
        let mut is_escape = false;
        for (i, c) in line[corner..].char_indices() {
            is_escape = c == '\u{1b}' || is_escape && c != 'm';
            let is_seen = !is_escape && c != 'm';
            if is_seen && !arrow(c) {
                at = corner + i;
                break;
            }
        }
        let text = line.get(at + 1..)?;
        let start = columns(&line[..=at]);
        (at > corner).then(|| Label {
            before: &line[..at],
            text,
            start,
            end: start + columns(text),
        })
    }

    fn write(&self, out: &mut String, width: usize) {
        let own_line = self.start + MIN_TEXT_WIDTH > width;
        let start = match own_line {
            true => width.saturating_sub(MIN_TEXT_WIDTH + 12),
            false => self.start,
        };
        let text = wrapped(
            self.text,
            width.saturating_sub(start).max(MIN_TEXT_WIDTH),
            "",
        );
        let indent = self.indent(start);
        out.push_str(self.before);
        for (i, line) in text.lines().enumerate() {
            match i == 0 && !own_line {
                true => out.push(' '),
                false => {
                    out.push('\n');
                    out.push_str(&indent);
                }
            }
            out.push_str(line);
        }
    }

    /// The text before further lines of a label: the margin, and arrows of other labels.
    fn indent(&self, columns: usize) -> String {
        let mut out = String::new();
        let (mut count, mut is_escape) = (0, false);
        for c in self.before.chars() {
            is_escape |= c == '\u{1b}';
            if is_escape {
                out.push(c);
                is_escape = c != 'm';
                continue;
            }
            if count < columns {
                out.push(if matches!(c, '│' | '┆') { c } else { ' ' });
                count += 1;
            }
        }
        out.extend(std::iter::repeat_n(' ', columns - count));
        out
    }
}

/// The characters that are seen: those outside of escape sequences.
fn seen(chars: impl Iterator<Item = char>) -> impl Iterator<Item = char> {
    chars
        .scan(false, |is_escape, c| {
            let hidden = *is_escape || c == '\u{1b}';
            *is_escape = hidden && c != 'm';
            Some((!hidden).then_some(c))
        })
        .flatten()
}

fn columns(text: &str) -> usize {
    seen(text.chars()).map(|c| c.width().unwrap_or(0)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_goes_on_below_itself() {
        let report = "   │  │  ╰── one two three four five six seven eight nine\n   │  ╰───── b\n";
        assert_eq!(
            within(report, 51),
            "   │  │  ╰── one two three four five six seven\n   │  │      eight nine\n   │  ╰───── b\n"
        );
        assert_eq!(within(report, 80), report);
    }

    #[test]
    fn far_on_the_right_it_begins_farther_left() {
        let arrow = format!("   │ {}╰──", " ".repeat(60));
        let text = "one two three four five six seven eight nine ten";
        let shown = within(&format!("{arrow} {text}\n"), 80);
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[0], arrow);
        assert!(lines.len() > 1 && lines[1..].iter().all(|l| l.starts_with("   │   ")));
        assert!(lines[1..].iter().all(|l| columns(l) <= 80), "{shown}");
        let words = lines[1..].iter().flat_map(|l| l.split_whitespace().skip(1));
        assert_eq!(words.collect::<Vec<_>>().join(" "), text);
    }

    #[test]
    fn colours_are_kept_and_take_no_room() {
        let report = "\u{1b}[38;5;246m   │\u{1b}[0m \u{1b}[31m╰\u{1b}[0m\u{1b}[31m──\u{1b}[0m one two three four five six seven eight\n";
        let shown = within(report, 50);
        let plain: String = seen(shown.chars()).collect();
        assert_eq!(plain, "   │ ╰── one two three four five six seven eight\n");
        let shown = within(report, 45);
        let plain: String = seen(shown.chars()).collect();
        assert_eq!(
            plain,
            "   │ ╰── one two three four five six seven\n   │     eight\n"
        );
        // A line of the scene that looks like one.
        let scene = " 3 │ # ╰── one two three four five six seven eight #\n";
        assert_eq!(within(scene, 40), scene);
    }
}
