//! Findings for merge requests in GitLab: a Code Quality report, a list of issues in JSON.
//!
//! GitLab compares the fingerprints of two runs to tell new issues from old ones. A fingerprint is made of the file,
//! the code and the text of the line, but not of the line's number, which may change.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::io::{self, Write};

use rustc_hash::FxHasher;
use serde::Serialize;

use super::{one_text, plain_path};
use crate::diagnostics::source::{Locator, Position};
use crate::diagnostics::{Diagnostic, Language, Severity, SourceFile, Span};

/// The findings of a file.
pub struct File(Vec<Issue>);

#[derive(Serialize)]
struct Issue {
    check_name: &'static str,
    description: String,
    severity: &'static str,
    fingerprint: String,
    location: Location,
    #[serde(skip)]
    print: u64,
}

#[derive(Serialize)]
struct Location {
    path: String,
    positions: Positions,
}

#[derive(Serialize)]
struct Positions {
    begin: LineColumn,
    end: LineColumn,
}

#[derive(Serialize)]
struct LineColumn {
    line: u32,
    column: u32,
}

impl File {
    pub fn new(file: &SourceFile, diagnostics: &[Diagnostic], language: Language) -> File {
        let path = plain_path(&file.path, cfg!(windows));
        let mut locator = Locator::new(file);
        let mut issue = |d: &Diagnostic| {
            let begin = locator.position(d.span.start);
            let end = locator.position(d.span.end.max(d.span.start));
            Issue {
                check_name: d.code.as_str(),
                description: format!("{}: {}", d.code.as_str(), text(d, language)),
                severity: severity(d.severity),
                fingerprint: String::new(),
                location: Location {
                    path: path.clone(),
                    positions: Positions {
                        begin: place(&begin),
                        end: place(&end),
                    },
                },
                print: print(&path, d, line(file, d.span)),
            }
        };
        File(diagnostics.iter().map(&mut issue).collect())
    }
}

/// The whole message on one line.
fn text(d: &Diagnostic, language: Language) -> String {
    one_text(&d.wording(language), language).replace('\n', "; ")
}

fn place(position: &Position) -> LineColumn {
    LineColumn {
        line: position.line,
        column: position.column,
    }
}

/// The line that a finding is on.
fn line(file: &SourceFile, span: Span) -> &str {
    file.slice(file.line_span(file.line_index(file.floor(span.start))))
        .trim()
}

fn print(path: &str, d: &Diagnostic, line: &str) -> u64 {
    let mut hasher = FxHasher::default();
    (path, d.code.as_str(), line).hash(&mut hasher);
    hasher.finish()
}

/// The severity in GitLab's words: info, minor, major, critical and blocker.
fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "major",
        Severity::Warning => "minor",
        Severity::Note | Severity::Style => "info",
    }
}

/// Writes the report of a run.
pub fn write(out: &mut dyn Write, files: Vec<File>) -> io::Result<()> {
    let mut issues: Vec<Issue> = files.into_iter().flat_map(|file| file.0).collect();
    // Equal findings on equal lines are numbered, so that their fingerprints differ.
    let mut seen: HashMap<u64, u64> = HashMap::new();
    for issue in &mut issues {
        let count = seen.entry(issue.print).or_insert(0);
        issue.fingerprint = format!("{:016x}-{count}", issue.print);
        *count += 1;
    }
    serde_json::to_writer_pretty(&mut *out, &issues)?;
    writeln!(out)
}
