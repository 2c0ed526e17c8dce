//! The report of a run, in the form that was asked for.

use std::io::{self, Write};

use crate::diagnostics::layout::wrapped_if;
use crate::diagnostics::render::human::{self, Look};
use crate::diagnostics::render::{Tally, github, gitlab, json, junit, sarif, short};
use crate::diagnostics::{Diagnostic, SourceFile, Value};

/// How to print the findings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub(super) enum Format {
    /// With the lines in question, notes and proposed fixes
    #[default]
    #[value(alias = "full")]
    Human,
    /// One line for each finding
    #[value(alias = "concise")]
    Short,
    /// For programs
    Json,
    /// For code scanning: SARIF 2.1.0
    Sarif,
    /// For GitHub Actions: annotations of pull requests
    Github,
    /// For merge requests in GitLab: a Code Quality report in JSON
    Gitlab,
    /// For lists of test results: JUnit XML
    Junit,
}

impl Format {
    /// How the names of files in this format end, except for plain text.
    pub(super) fn endings(self) -> &'static [&'static str] {
        match self {
            Format::Human | Format::Short | Format::Github => &[],
            Format::Json | Format::Gitlab => &["json"],
            Format::Sarif => &["sarif", "json"],
            Format::Junit => &["xml"],
        }
    }
}

/// The findings of a file, ready to be put out.
pub(super) enum Output {
    Text(Vec<u8>),
    Json(json::File),
    Sarif(sarif::File),
    Gitlab(gitlab::File),
    Junit(junit::File),
}

impl Output {
    pub(super) fn new(
        format: Format,
        source: &SourceFile,
        diagnostics: Vec<Diagnostic>,
        look: Look,
    ) -> Output {
        let language = look.language;
        let mut text = Vec::new();
        let written = match format {
            Format::Human => human::write(&mut text, source, &diagnostics, look),
            Format::Short => short::write(&mut text, source, &diagnostics, language),
            Format::Json => return Output::Json(json::File::new(source, diagnostics)),
            Format::Sarif => return Output::Sarif(sarif::File::new(source, diagnostics)),
            Format::Github => github::write(&mut text, source, &diagnostics, language),
            Format::Gitlab => {
                return Output::Gitlab(gitlab::File::new(source, &diagnostics, language));
            }
            Format::Junit => {
                return Output::Junit(junit::File::new(source, &diagnostics, language));
            }
        };
        debug_assert!(written.is_ok(), "memory takes everything");
        Output::Text(text)
    }
}

/// Writes the findings of all files. `fixes` says in a line what was mended; `complete` is whether every file could be
/// read. With `quiet` there is no summary.
pub(super) fn write(
    out: &mut dyn Write,
    format: Format,
    outputs: Vec<Output>,
    fixes: &str,
    total: &Tally,
    complete: bool,
    (look, quiet): (Look, bool),
) -> io::Result<()> {
    let mut reports = Vec::new();
    let mut scans = Vec::new();
    let (mut issues, mut suites) = (Vec::new(), Vec::new());
    for output in outputs {
        match output {
            Output::Text(text) => out.write_all(&text)?,
            Output::Json(report) => reports.push(report),
            Output::Sarif(scan) => scans.push(scan),
            Output::Gitlab(file) => issues.push(file),
            Output::Junit(suite) => suites.push(suite),
        }
    }
    match format {
        // With nothing read there is nothing to sum up.
        Format::Human if total.files > 0 && !quiet => {
            let files = [("files", Value::Count(total.files as u64))];
            let sum = match total.is_clean() && !complete {
                // A file that could not be read has passed no check.
                true => look.language.say("tally-incomplete", &files),
                false => total.sentence(look.language),
            };
            let text = format!("{fixes}{sum}");
            writeln!(out, "{}", wrapped_if(&text, look.width, "  "))
        }
        Format::Human | Format::Short | Format::Github => Ok(()),
        Format::Json => json::write(out, &reports, total),
        Format::Sarif => sarif::write(out, &scans, complete),
        Format::Gitlab => gitlab::write(out, issues),
        Format::Junit => junit::write(out, &suites),
    }
}
