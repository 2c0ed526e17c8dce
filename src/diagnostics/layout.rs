//! Lays out text in lines that are no wider than a terminal.

use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm, core::display_width};

/// Wraps text into lines no wider than `width`, unless a single word is. Lines after the first begin with `indent`.
/// Line breaks of the text are kept.
pub fn wrapped(text: &str, width: usize, indent: &str) -> String {
    let options = Options::new(width)
        .subsequent_indent(indent)
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    let text = together(text, width / 2);
    let lines = text.split('\n').map(|line| textwrap::fill(line, &options));
    lines.collect::<Vec<_>>().join("\n").replace(BOUND, " ")
}

/// A space at which no line may end. No text has this character, to which Unicode gives no meaning.
const BOUND: char = '\u{e000}';

/// Keeps text between backquotes together: it is a command or a record to be copied, and no line ends in it unless it
/// is longer than `longest`.
fn together(text: &str, longest: usize) -> String {
    let mut out = String::with_capacity(text.len());
    for (i, part) in text.split('`').enumerate() {
        if i > 0 {
            out.push('`');
        }
        match i % 2 == 1 && part.len() <= longest && !part.contains('\n') {
            true => out.extend(part.chars().map(|c| if c == ' ' { BOUND } else { c })),
            false => out.push_str(part),
        }
    }
    out
}

/// Wraps a line of columns or of an example. Further lines begin below the last column that has room, or are indented
/// by four more.
pub fn hanging(line: &str, width: usize) -> String {
    if display_width(line) <= width {
        return line.to_owned();
    }
    let indent = line.len() - line.trim_start().len();
    // Columns are set off by two spaces at the least.
    let words = line
        .char_indices()
        .filter(|(_, c)| *c != ' ')
        .map(|(at, _)| at);
    let is_start = |at: &usize| *at > indent && line[..*at].ends_with("  ");
    let mut columns = words.filter(is_start).map(|at| display_width(&line[..at]));
    let column = columns.rfind(|column| column + LEAST_COLUMN <= width);
    wrapped(line, width, &" ".repeat(column.unwrap_or(indent + 4)))
}

/// The least width that a column must have left to be continued on further lines.
const LEAST_COLUMN: usize = 24;

/// Wraps paragraphs into lines no wider than `width`. Indented lines are columns or examples, and stay lines.
pub fn paragraphs(text: &str, width: usize) -> String {
    let mut out: Vec<String> = Vec::new();
    let mut words = String::new();
    for line in text.lines().chain([""]) {
        let is_text = !line.is_empty() && !line.starts_with(' ');
        if is_text {
            if !words.is_empty() {
                words.push(' ');
            }
            words += line;
            continue;
        }
        if !words.is_empty() {
            out.push(wrapped(&std::mem::take(&mut words), width, ""));
        }
        out.push(hanging(line, width));
    }
    // The empty line at the end was added by the loop.
    out.pop();
    out.join("\n")
}

/// Wraps text as [`wrapped`] does; without a width, the text stays unchanged.
pub fn wrapped_if(text: &str, width: Option<usize>, indent: &str) -> String {
    width.map_or_else(|| text.to_owned(), |width| wrapped(text, width, indent))
}

/// Joins entries by ` · ` behind `first`, in lines no wider than `width`. Where possible a line ends between two
/// entries, with the point.
pub fn listed(first: &str, entries: &[String], width: usize, indent: &str) -> String {
    let mut lines = Vec::new();
    let mut line = first.to_owned();
    for (i, entry) in entries.iter().enumerate() {
        let is_last = i + 1 == entries.len();
        let entry = if is_last {
            entry.clone()
        } else {
            // The point is never alone in a line.
            format!("{entry}{BOUND}·")
        };
        let space = if line.is_empty() || i == 0 { "" } else { " " };
        let fits = |text: &str| display_width(text) <= width;
        let longer = format!("{line}{space}{entry}");
        if i == 0 || fits(&longer) {
            line = longer;
        } else {
            lines.push(std::mem::replace(&mut line, format!("{indent}{entry}")));
        }
    }
    lines.push(line);
    let all: Vec<String> = (lines.iter())
        .map(|line| wrapped(line, width, indent))
        .collect();
    all.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However many spaces there are before a column.
    #[test]
    fn what_goes_on_is_under_its_column() {
        for gap in 2..9 {
            let head = format!("E004{}", " ".repeat(gap));
            let line = format!("{head}aaaa bbbb cccc dddd eeee ffff");
            let indent = " ".repeat(head.len());
            let width = head.len() + 24;
            let expected = format!("{head}aaaa bbbb cccc dddd eeee\n{indent}ffff");
            assert_eq!(hanging(&line, width), expected, "{gap}");
        }
    }

    #[test]
    fn words_stay_whole_and_lines_within_the_width() {
        let text = "eins zwei drei  vier\nfünf -v--x";
        assert_eq!(
            wrapped(text, 10, "  "),
            "eins zwei\n  drei\n  vier\nfünf -v--x"
        );
        assert_eq!(
            wrapped("a-very-long-name of", 6, ""),
            "a-very-long-name\nof"
        );
        // Colours take no room.
        assert_eq!(
            wrapped("\u{1b}[31mred\u{1b}[0m blue", 8, ""),
            "\u{1b}[31mred\u{1b}[0m blue"
        );
        assert_eq!(wrapped_if("a b", None, ""), "a b");
        // What is to be copied stays on a line.
        assert_eq!(wrapped("see `a b c` there", 10, ""), "see\n`a b c`\nthere");
        assert_eq!(wrapped("see `a b c d e`", 10, ""), "see `a b c\nd e`");
    }

    #[test]
    fn columns_stay_columns() {
        let text =
            "one two\nthree four\n\n  abc  eins zwei drei vier f\u{fc}nf sechs sieben acht\nfive";
        assert_eq!(
            paragraphs(text, 40),
            "one two three four\n\n  abc  eins zwei drei vier f\u{fc}nf sechs\n       sieben acht\nfive"
        );
        assert_eq!(hanging("  a command line", 12), "  a command\n      line");
    }

    #[test]
    fn lists_end_their_lines_with_the_point() {
        let entries = ["one one", "two", "three"].map(str::to_owned);
        assert_eq!(listed("", &entries, 40, ""), "one one · two · three");
        assert_eq!(
            listed("x: ", &entries, 16, "  "),
            "x: one one ·\n  two · three"
        );
    }
}
