//! The report as Markdown.

use super::super::configurations::Kind;
use super::super::number_format::{self, local, say};
use super::super::report::{Report, Row};
use super::tables::{self, Table};
use super::terminal::sureness;
use crate::diagnostics::Language;
use std::fmt::Write as _;

pub fn text(report: &Report, language: Language) -> String {
    let [w, h] = report.size;
    let mut out = format!(
        "# {}\n\n`{}`, {w} × {h}\n\n",
        say(language, "accuracy-title", &[]),
        report.scene
    );
    for part in &report.advice_parts {
        let _ = writeln!(out, "{}\n", part.text);
    }
    out.push_str("![](accuracy.svg)\n");
    for kind in Kind::ALL {
        let rows: Vec<&Row> = report.of_kind(kind).collect();
        if rows.is_empty() {
            continue;
        }
        let name = number_format::kind(language, kind);
        let _ = writeln!(out, "\n## {}{}\n", name[..1].to_uppercase(), &name[1..]);
        let _ = writeln!(
            out,
            "{}\n|---|---:|---:|---:|---:|---:|---|",
            say(language, "accuracy-markdown-head", &[])
        );
        for row in rows {
            let times = row
                .times_default
                .map_or("–".into(), |t| number_format::times(language, t));
            let error = row.error.as_ref();
            let note = match &row.same_as {
                Some(other) => say(
                    language,
                    "accuracy-same-as",
                    &[("other", other.clone().into())],
                ),
                None if row.default => say(language, "accuracy-default", &[]),
                None if row.pareto => say(language, "accuracy-front", &[]),
                None => String::new(),
            };
            let _ = writeln!(
                out,
                "| {} | {times} | {} | {} | {} | {} | {note} |",
                row.name(),
                number_format::error(language, row.steps()),
                error.map_or(String::new(), |e| local(language, format!("{:.4}", e.flip))),
                error.map_or(String::new(), |e| format!(
                    "{} / {}",
                    e.pixels_off, e.pixels
                )),
                error.map_or(String::new(), |e| number_format::error(
                    language,
                    e.max_steps
                )),
            );
        }
    }
    let _ = writeln!(out, "\n{}", say(language, "accuracy-note-columns", &[]));
    for (note, table) in [
        ("accuracy-note-objects", tables::objects(report, language)),
        ("accuracy-note-effects", tables::effects(report, language)),
    ] {
        if !table.rows.is_empty() {
            let _ = writeln!(out, "\n{}\n\n{}", say(language, note, &[]), shown(&table));
        }
    }
    let _ = writeln!(out, "\n{}", sureness(report, language).join(" · "));
    out
}

fn shown(table: &Table) -> String {
    let line = |cells: &[String]| format!("| {} |", cells.join(" | "));
    let rule = format!("|---|{}", "---:|".repeat(table.head.len() - 1));
    let mut lines = vec![line(&table.head), rule];
    lines.extend(table.rows.iter().map(|cells| line(cells)));
    lines.join("\n")
}
