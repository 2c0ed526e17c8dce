//! Lays out pages of `zpg explain`: as text on a terminal, elsewhere as Markdown, wrapped to a width.

use crate::diagnostics::layout::{hanging, wrapped};

/// How a page is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PageStyle {
    Markdown,
    Text { colour: bool },
}

/// Escape sequences of a terminal: `BOLD` and `CODE` begin a style, `PLAIN` ends it.
const BOLD: &str = "\u{1b}[1m";
const CODE: &str = "\u{1b}[36m";
const PLAIN: &str = "\u{1b}[0m";

/// The page wrapped to `width` columns. Lines of examples are not wrapped.
pub(super) fn laid_out(page: &str, form: PageStyle, width: usize) -> String {
    let mut pages = Pages {
        form,
        width,
        out: String::new(),
        text: String::new(),
        indent: "",
    };
    let mut is_example = false;
    for line in page.lines() {
        if line.starts_with("```") {
            pages.end();
            is_example = !is_example;
            if form == PageStyle::Markdown {
                pages.line(line);
            }
        } else if is_example {
            let indent = if form == PageStyle::Markdown {
                ""
            } else {
                "    "
            };
            pages.line(format!("{indent}{line}").trim_end());
        } else {
            pages.add(line);
        }
    }
    pages.end();
    pages.out
}

struct Pages {
    form: PageStyle,
    width: usize,
    out: String,
    /// The paragraph or the entry of a list that is being collected; `indent` stands before its further lines.
    text: String,
    indent: &'static str,
}

impl Pages {
    fn line(&mut self, line: &str) {
        self.out.push_str(line);
        self.out.push('\n');
    }

    /// Takes in a line of prose, of a list or of a table, or a heading.
    fn add(&mut self, line: &str) {
        let is_heading = line.starts_with('#');
        if line.is_empty() || is_heading {
            self.end();
            let heading = line.trim_start_matches('#').trim_start();
            match self.form {
                PageStyle::Text { colour: true } if is_heading => {
                    self.line(&format!("{BOLD}{heading}{PLAIN}"));
                }
                PageStyle::Text { .. } => self.line(heading),
                PageStyle::Markdown => self.line(line),
            }
        } else if let Some(entry) = line.strip_prefix("- ") {
            self.end();
            self.text = format!("- {}", entry.trim_end());
            self.indent = "  ";
        } else if line.starts_with(' ') && self.text.is_empty() {
            let line = hanging(line, self.width);
            self.line(&line);
        } else {
            if !self.text.is_empty() {
                self.text.push(' ');
            }
            self.text.push_str(line.trim());
        }
    }

    /// Writes the paragraph or the entry that has been collected, if there is one.
    fn end(&mut self) {
        if !self.text.is_empty() {
            let text = wrapped(&std::mem::take(&mut self.text), self.width, self.indent);
            let text = match self.form {
                PageStyle::Text { colour: true } => coloured(&text),
                _ => text,
            };
            self.line(&text);
        }
        self.indent = "";
    }
}

/// The text with code in a colour, in place of the backquotes around it.
fn coloured(text: &str) -> String {
    let mut out = String::new();
    for (i, part) in text.split('`').enumerate() {
        match i {
            0 => {}
            i if i % 2 == 1 => out.push_str(CODE),
            _ => out.push_str(PLAIN),
        }
        out.push_str(part);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Language};
    use crate::features::pages::{code_page, type_page};
    use crate::syntax::table::RECORD_TYPES;
    use unicode_width::UnicodeWidthStr as _;

    const PAGE: &str = "# undefined-id (E101)\n\n## What it does\n\nReports a `reference` to an ID\nthat no record defines.\n\n\
                        - one of\n  two lines\n- another\n\n```zpg\n1 9999   3 0\n```\n\n    ID 14 R r\n";

    #[test]
    fn a_page_is_text() {
        let text = laid_out(PAGE, PageStyle::Text { colour: false }, 30);
        assert_eq!(
            text,
            "undefined-id (E101)\n\nWhat it does\n\nReports a `reference` to an ID\nthat no record defines.\n\n\
             - one of two lines\n- another\n\n    1 9999   3 0\n\n    ID 14 R r\n"
        );
        let text = laid_out(PAGE, PageStyle::Text { colour: true }, 32);
        assert!(
            text.starts_with("\u{1b}[1mundefined-id (E101)\u{1b}[0m\n"),
            "{text}"
        );
        assert!(text.contains("a \u{1b}[36mreference\u{1b}[0m to") && !text.contains('`'));
    }

    #[test]
    fn in_a_pipe_it_is_the_same_markdown() {
        let page = laid_out(PAGE, PageStyle::Markdown, 80);
        let words = |text: &str| {
            text.split_whitespace()
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        assert_eq!(words(&page), words(PAGE));
        assert!(page.contains("\nReports a `reference` to an ID that no record defines.\n"));
        assert!(page.contains("\n```zpg\n1 9999   3 0\n```\n"));
    }

    /// Nothing of Markdown is left but the signs of code, and no line of prose is too wide.
    #[test]
    fn every_page_is_text() {
        for language in [Language::English, Language::Czech] {
            let codes = Code::ALL.iter().map(|c| code_page(*c, language));
            let types = RECORD_TYPES.iter().map(|t| type_page(t, language));
            for page in codes.chain(types) {
                for width in [80, 120] {
                    let text = laid_out(&page, PageStyle::Text { colour: false }, width);
                    for line in text.lines() {
                        assert!(
                            !line.starts_with(['#', '|', '*', '>']) && !line.starts_with("```"),
                            "{line}"
                        );
                        assert!(!line.contains("**") && !line.contains("]("), "{line}");
                        assert!(line.width() <= width || line.starts_with("    "), "{line}");
                    }
                }
            }
        }
    }
}
