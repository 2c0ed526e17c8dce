//! Findings as workflow commands: GitHub shows them beside the lines of a pull request.
//!
//! A command is one line, `::error file=…,line=…::message`. Characters that would end a line, a property or the list of
//! properties are percent-encoded.

use std::io::{self, Write};

use super::{one_text, plain_path, visible};
use crate::diagnostics::source::{Locator, SourceFile};
use crate::diagnostics::{Diagnostic, Language, Severity};

/// Writes a file's findings, in the order they are given.
pub fn write(
    out: &mut dyn Write,
    file: &SourceFile,
    diagnostics: &[Diagnostic],
    language: Language,
) -> io::Result<()> {
    let path = plain_path(&file.path, cfg!(windows));
    let shown = visible(&path);
    let mut locator = Locator::new(file);
    for d in diagnostics {
        let (code, name) = (d.code.as_str(), d.code.name());
        let (start, end) = (
            locator.position(d.span.start),
            locator.position(d.span.end.max(d.span.start)),
        );
        write!(
            out,
            "::{} file={},line={}",
            command(d.severity),
            property(&path),
            start.line
        )?;
        // GitHub takes columns within one line only.
        if start.line == end.line {
            write!(out, ",col={}", start.column)?;
        }
        write!(out, ",endLine={}", end.line)?;
        if start.line == end.line {
            write!(out, ",endColumn={}", end.column)?;
        }
        let title = property(&format!("zpg ({code} {name})"));
        // The log shows nothing but the message: it has to name the place and the code, too.
        let words = d.wording(language);
        let mut message = format!(
            "{shown}:{}:{}: {code}: {}",
            start.line,
            start.column,
            one_text(&words, language)
        );
        for (label, text) in d.labels.iter().zip(&words.labels) {
            let place = locator.position(label.span.start);
            message += &format!("\n{shown}:{}:{}: {text}", place.line, place.column);
        }
        writeln!(out, ",title={title}::{}", data(&message))?;
    }
    Ok(())
}

/// The command for a severity. There are three levels: matters of style share that of notes.
fn command(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note | Severity::Style => "notice",
    }
}

/// Encodes the text after the `::`. Its lines stay lines; within them, foreign text cannot drive the terminal.
fn data(text: &str) -> String {
    let lines: Vec<_> = text.split('\n').map(visible).collect();
    encode(&lines.join("\n"), "%\r\n")
}

/// Encodes the value of a property.
fn property(text: &str) -> String {
    encode(text, "%\r\n:,")
}

/// Percent-encodes the characters of a text that are in `what`, which is ASCII.
fn encode(text: &str, what: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if what.contains(c) {
            out += &format!("%{:02X}", c as u32);
        } else {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Span};

    fn print(path: &str, text: &str, d: Diagnostic) -> String {
        let file = SourceFile::new(path, text.into());
        let mut out = Vec::new();
        write(&mut out, &file, &[d], Language::English).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_command_for_each() {
        let text = "2 9 1\n1 9999 7 0\n";
        let found = Diagnostic::new(Code::E101, Span::new(13, 14)).with("id", "7");
        assert_eq!(
            print("./a.zpg", text, found.clone()),
            "::error file=a.zpg,line=2,col=8,endLine=2,endColumn=9,title=zpg (E101 undefined-id)::\
             a.zpg:2:8: E101: 7 is not defined%0Anothing in this file has this ID\n"
        );
        for (severity, command) in [
            (Severity::Warning, "::warning file="),
            (Severity::Note, "::notice file="),
            (Severity::Style, "::notice file="),
        ] {
            let line = print("a.zpg", text, found.clone().severity(severity));
            assert!(line.starts_with(command), "{line}");
        }
    }

    #[test]
    fn columns_stand_within_one_line() {
        let found = Diagnostic::new(Code::E101, Span::new(4, 7)).with("id", "7");
        let line = print("a.zpg", "2 9 1\n1 9999 7 0\n", found);
        assert!(
            line.starts_with("::error file=a.zpg,line=1,endLine=2,title="),
            "{line}"
        );
    }

    #[test]
    fn a_message_has_its_labels_notes_and_help() {
        let found = Diagnostic::new(Code::E101, Span::new(13, 14))
            .with("id", "7")
            .label(Span::new(0, 1), "here")
            .note("nothing-drawn");
        assert_eq!(
            print("a.zpg", "2 9 1\n1 9999 7 0\n", found)
                .split_once(")::")
                .unwrap()
                .1,
            "a.zpg:2:8: E101: 7 is not defined%0Anothing in this file has this ID%0A\
             nothing of it is drawn%0Aa.zpg:1:1: here\n"
        );
    }

    #[test]
    fn nothing_foreign_ends_a_command() {
        assert_eq!(property("a%b:c,d\r\ne"), "a%25b%3Ac%2Cd%0D%0Ae");
        assert_eq!(data("50 %, so: x\ny"), "50 %25, so: x%0Ay");
        let found = Diagnostic::new(Code::E101, Span::new(0, 1)).with("id", "7\r::error::\u{1b}[x");
        let line = print("odd,name:100%\n::error::.zpg", "2 9 1\n", found);
        assert_eq!(
            line,
            "::error file=odd%2Cname%3A100%25%0A%3A%3Aerror%3A%3A.zpg,line=1,col=1,endLine=1,endColumn=2,\
             title=zpg (E101 undefined-id)::odd,name:100%25 ::error::.zpg:1:1: E101: \
             7 ::error::\u{fffd}[x is not defined%0Anothing in this file has this ID\n"
        );
        assert_eq!(line.lines().count(), 1);
    }
}
