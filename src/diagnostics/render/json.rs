//! Findings for machines. The form is a contract: keys, their order, and offsets in bytes of the
//! file as it lies on disk.

use std::io::{self, Write};

use serde::Serialize;

use super::Tally;
use crate::diagnostics::source::{Locator, Position, SourceFile};
use crate::diagnostics::{Applicability, Diagnostic, Fix, Language, Severity, Span};

/// The version of the form; it grows when programs that read the form would have to change.
pub const VERSION: u32 = 1;

/// The findings of a file.
#[derive(Debug, Serialize)]
pub struct File {
    path: String,
    diagnostics: Vec<Finding>,
}

#[derive(Debug, Serialize)]
struct Finding {
    code: &'static str,
    name: &'static str,
    severity: Severity,
    message: String,
    span: Range,
    labels: Vec<Label>,
    notes: Vec<String>,
    help: Option<String>,
    fixes: Vec<Proposal>,
}

#[derive(Debug, Serialize)]
struct Range {
    start: Position,
    end: Position,
}

#[derive(Debug, Serialize)]
struct Label {
    span: Range,
    message: String,
}

#[derive(Debug, Serialize)]
struct Proposal {
    title: String,
    applicability: Applicability,
    edits: Vec<Replacement>,
}

#[derive(Debug, Serialize)]
struct Replacement {
    start: u32,
    end: u32,
    text: String,
}

/// The whole output.
#[derive(Serialize)]
struct Report<'a> {
    version: u32,
    files: &'a [File],
    summary: &'a Tally,
}

impl File {
    /// The findings of a file, which are sorted by their offset. Their texts are in English, since programs read them.
    pub fn new(file: &SourceFile, diagnostics: Vec<Diagnostic>) -> File {
        let mut locator = Locator::new(file);
        File {
            path: file.path.clone(),
            diagnostics: diagnostics
                .into_iter()
                .map(|d| Finding::new(&mut locator, d))
                .collect(),
        }
    }
}

impl Finding {
    fn new(locator: &mut Locator, d: Diagnostic) -> Finding {
        let words = d.wording(Language::English);
        let labels = d.labels.iter().zip(words.labels);
        let fixes = d.fixes.into_iter().zip(words.fixes);
        Finding {
            code: d.code.as_str(),
            name: d.code.name(),
            severity: d.severity,
            message: words.message,
            span: range(locator, d.span),
            labels: labels
                .map(|(l, message)| Label {
                    span: range(locator, l.span),
                    message,
                })
                .collect(),
            notes: words.notes,
            help: words.help,
            fixes: fixes
                .map(|(fix, title)| Proposal::new(locator, fix, title))
                .collect(),
        }
    }
}

impl Proposal {
    fn new(locator: &mut Locator, fix: Fix, title: String) -> Proposal {
        Proposal {
            title,
            applicability: fix.applicability,
            edits: fix
                .edits
                .into_iter()
                .map(|e| Replacement {
                    start: locator.position(e.span.start).offset,
                    end: locator.position(e.span.end).offset,
                    text: e.text,
                })
                .collect(),
        }
    }
}

fn range(locator: &mut Locator, span: Span) -> Range {
    Range {
        start: locator.position(span.start),
        end: locator.position(span.end),
    }
}

/// Writes the whole report.
pub fn write(out: &mut dyn Write, files: &[File], summary: &Tally) -> io::Result<()> {
    let report = Report {
        version: VERSION,
        files,
        summary,
    };
    serde_json::to_writer_pretty(&mut *out, &report)?;
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::{Code, Value};

    #[test]
    fn the_form_is_a_contract() {
        let file = SourceFile::new("a.zpg", "# ž #\n4 -204 0 35\n".into());
        let span = Span::new(9, 13);
        let d = Diagnostic::new(Code::E007, span)
            .case("proposal")
            .with("text", "`-204`")
            .with("number", "-299")
            .with("type", Value::Term("assignment of properties"))
            .label(Span::new(7, 8), "here")
            .note("nothing-drawn")
            .fix(Fix::replace("fix", Applicability::Safe, span, "-299"));
        let mut tally = Tally::default();
        tally.add(std::slice::from_ref(&d));
        let mut out = Vec::new();
        write(&mut out, &[File::new(&file, vec![d])], &tally).unwrap();
        insta::assert_snapshot!(String::from_utf8(out).unwrap(), @r#"
        {
          "version": 1,
          "files": [
            {
              "path": "a.zpg",
              "diagnostics": [
                {
                  "code": "E007",
                  "name": "unknown-type",
                  "severity": "error",
                  "message": "there is no record type `-204`",
                  "span": {
                    "start": {
                      "offset": 9,
                      "line": 2,
                      "column": 3
                    },
                    "end": {
                      "offset": 13,
                      "line": 2,
                      "column": 7
                    }
                  },
                  "labels": [
                    {
                      "span": {
                        "start": {
                          "offset": 7,
                          "line": 2,
                          "column": 1
                        },
                        "end": {
                          "offset": 8,
                          "line": 2,
                          "column": 2
                        }
                      },
                      "message": "here"
                    }
                  ],
                  "notes": [
                    "nothing of it is drawn"
                  ],
                  "help": "these parameters fit type -299, an assignment of properties",
                  "fixes": [
                    {
                      "title": "write `-299` (assignment of properties)",
                      "applicability": "safe",
                      "edits": [
                        {
                          "start": 9,
                          "end": 13,
                          "text": "-299"
                        }
                      ]
                    }
                  ]
                }
              ]
            }
          ],
          "summary": {
            "files": 1,
            "errors": 1,
            "warnings": 0,
            "notes": 0,
            "style": 0
          }
        }
        "#);
    }

    #[test]
    fn offsets_are_bytes_on_disk() {
        let bytes = b"# \xf8\xed # x".to_vec();
        let at = bytes.iter().position(|&b| b == b'x').unwrap();
        let file = SourceFile::new("a.zpg", bytes);
        let in_text = file.text.find('x').unwrap() as u32;
        assert_ne!(at, in_text as usize);
        let d = Diagnostic::new(Code::E106, Span::new(in_text, in_text + 1));
        let json = serde_json::to_value(File::new(&file, vec![d])).unwrap();
        assert_eq!(json["diagnostics"][0]["span"]["start"]["offset"], at);
        assert_eq!(json["diagnostics"][0]["span"]["start"]["column"], at + 1);
    }
}
