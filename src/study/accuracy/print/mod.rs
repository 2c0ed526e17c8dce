//! The report for people: on the terminal, as Markdown, as diagrams and as a page.

pub mod html;
mod image;
mod labels;
pub mod markdown;
pub mod svg;
mod tables;
pub mod terminal;

use super::advice::in_language;
use super::report::Report;
use crate::diagnostics::Language;

/// Names and contents of the files of a report. All but the JSON are in `language`.
pub fn files(report: &Report, language: Language) -> Vec<(&'static str, String)> {
    let json = serde_json::to_string_pretty(report).unwrap_or_default() + "\n";
    let report = &in_language(report, language);
    vec![
        ("accuracy.json", json),
        ("accuracy.md", markdown::text(report, language)),
        ("accuracy.svg", svg::file(report, language)),
        ("accuracy.html", html::text(report, language)),
    ]
}
