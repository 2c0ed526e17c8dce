//! The report for people: on the terminal, as Markdown, as a page.

pub mod terminal;

use super::report::Report;
use crate::diagnostics::Language;

/// Names and contents of the files of a report.
pub fn files(report: &Report, _language: Language) -> Vec<(&'static str, String)> {
    let json = serde_json::to_string_pretty(report).unwrap_or_default() + "\n";
    vec![("accuracy.json", json)]
}
