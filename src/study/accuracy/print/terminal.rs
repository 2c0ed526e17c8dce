//! The report in some 35 lines.

use super::super::advice::names;
use super::super::report::{Report, Row};
use super::super::rungs::{Axis, Kind};
use super::super::words::{self, local, say};
use crate::diagnostics::Language;
use std::fmt::Write as _;
use unicode_width::UnicodeWidthStr as _;

const WIDTH: usize = 100;
/// Rows of each kind, unless more are needed.
const MOST_ROWS: usize = 5;

/// The text; `page` says where the page is, if it was written.
pub fn text(report: &Report, language: Language, page: Option<&str>) -> String {
    let mut out = String::new();
    let [w, h] = report.size;
    let title = say(language, "accuracy-title", &[]);
    let spent = words::seconds(language, report.budget.spent_seconds);
    line(
        &mut out,
        &format!("{title} · {} · {w}x{h} · {spent}", report.scene),
    );
    if report.stopped {
        line(&mut out, &say(language, "accuracy-stopped", &[]));
    }
    out.push('\n');
    for (i, part) in report.advice_parts.iter().enumerate() {
        let mark = if i == 0 { "▶ " } else { "  " };
        for (j, text) in wrapped(&part.text, WIDTH - 2).into_iter().enumerate() {
            let mark = if j == 0 { mark } else { "  " };
            line(&mut out, &format!("{mark}{text}"));
        }
    }
    let mut left = 0;
    let head = say(language, "accuracy-columns", &[]);
    let mut first = true;
    for kind in Kind::ALL {
        let rows: Vec<&Row> = report.of_kind(kind).collect();
        if rows.is_empty() {
            continue;
        }
        let kept = kept(&rows, report);
        left += rows.len() - kept.len();
        out.push('\n');
        let name = heading(kind, &rows, language);
        match std::mem::take(&mut first) {
            true => line(&mut out, &format!("{}{head}", padded(&name, 32))),
            false => line(&mut out, &name),
        }
        for row in kept {
            line(&mut out, &row_line(row, report, language));
        }
    }
    out.push('\n');
    line(
        &mut out,
        &say(language, "accuracy-legend", &[("left", words::count(left))]),
    );
    summaries(&mut out, report, language);
    if let Some(page) = page {
        line(&mut out, page);
    }
    out
}

fn line(out: &mut String, text: &str) {
    let _ = writeln!(out, "{}", text.trim_end());
}

fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(text.width())))
}

fn right(text: &str, width: usize) -> String {
    format!("{}{text}", " ".repeat(width.saturating_sub(text.width())))
}

/// Words in lines no wider than this.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(last) if last.width() + 1 + word.width() <= width => {
                last.push(' ');
                last.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn heading(kind: Kind, rows: &[&Row], language: Language) -> String {
    let mut axes: Vec<&str> = rows.iter().map(|r| r.axis).collect();
    axes.dedup();
    format!("{}: {}", words::kind(language, kind), axes.join(", "))
}

/// The default, the ends, the front; of the numbers all.
fn kept<'r>(rows: &[&'r Row], report: &Report) -> Vec<&'r Row> {
    // Of the ways to write the default one is enough.
    let default = rows.iter().position(|r| r.default);
    let needed = |i: usize| {
        let row = rows[i];
        Some(i) == default
            || i == 0
            || i + 1 == rows.len() && !row.default
            || row.is_on(Axis::Precision)
            || names(report, row)
    };
    let mut room = MOST_ROWS.saturating_sub((0..rows.len()).filter(|&i| needed(i)).count());
    (0..rows.len())
        .filter(|&i| {
            let takes = rows[i].pareto && rows[i].same_as.is_none() && !rows[i].default && room > 0;
            if !needed(i) && takes {
                room -= 1;
            }
            needed(i) || takes
        })
        .map(|i| rows[i])
        .collect()
}

fn row_line(row: &Row, report: &Report, language: Language) -> String {
    let mark = match (row.default, row.pareto) {
        (true, _) => '◆',
        (_, true) => '●',
        _ => '○',
    };
    let [w, h] = report.size;
    let pixels = f64::from(w) * f64::from(h);
    // Of the whole picture, by the pixels that were timed.
    let cpu = row.times_default.zip(whole_default(report, pixels));
    let cpu = cpu.map_or("–".into(), |(t, d)| words::seconds(language, t * d));
    let times = row
        .times_default
        .map_or("–".into(), |t| format!("{} ×", words::times(language, t)));
    let error = row.error.as_ref();
    let steps = match (&row.same_as, error) {
        (_, None) => "–".into(),
        (_, Some(e)) if e.pixels_differ == 0 => say(language, "accuracy-same", &[]),
        (_, Some(e)) => words::error(language, e.steps),
    };
    let flip = error.map_or(String::new(), |e| local(language, format!("{:.4}", e.flip)));
    let off = error.map_or(String::new(), |e| match e.pixels {
        0 => String::new(),
        _ => percent(e.pixels_off, e.pixels, language),
    });
    let bar = row
        .times_default
        .map_or(0, |t| ((t.max(0.1).log2() + 4.0) * 1.6) as usize);
    format!(
        "  {mark} {}{}{}{}{}{}  {}",
        padded(&row.name(), 24),
        right(&cpu, 10),
        right(&times, 10),
        right(&steps, 10),
        right(&flip, 9),
        right(&off, 9),
        "█".repeat(bar.min(24)),
    )
}

/// A share of pixels: none, or with two digits.
fn percent(part: usize, all: usize, language: Language) -> String {
    let share = 100.0 * part as f64 / all as f64;
    local(
        language,
        match share {
            0.0 => "0".into(),
            s if s < 0.095 => format!("{s:.3} %"),
            s if s < 9.95 => format!("{s:.2} %"),
            s => format!("{s:.0} %"),
        },
    )
}

/// CPU seconds of the default for the whole picture.
pub fn whole_default(report: &Report, pixels: f64) -> Option<f64> {
    let row = report
        .rows
        .iter()
        .find(|r| r.default && r.cpu_seconds.is_some())?;
    let timed = row.pixels_timed.max(1) as f64;
    Some(row.cpu_seconds?.min * pixels / timed)
}

fn summaries(out: &mut String, report: &Report, language: Language) {
    let mut list = |message: &'static str, items: Vec<String>| {
        if !items.is_empty() {
            let text = format!(
                "{}  {}",
                padded(&say(language, message, &[]), 30),
                items.join("   ")
            );
            let mut lines = wrapped_list(&text, WIDTH).into_iter();
            if let Some(first) = lines.next() {
                line(out, &first);
            }
            lines.for_each(|l| line(out, &l));
        }
    };
    let objects = |share: fn(&super::super::report::Object) -> f64| {
        let mut sorted: Vec<_> = report.objects.iter().collect();
        sorted.sort_by(|a, b| share(b).total_cmp(&share(a)));
        let shown = sorted.into_iter().take(4).filter(|o| share(o) >= 0.01);
        shown
            .map(|o| {
                let name = match o.id {
                    0 => say(language, "accuracy-background", &[]),
                    id => format!("#{id}"),
                };
                format!("{name} {} %", words::percent(language, share(o)))
            })
            .collect::<Vec<_>>()
    };
    list("accuracy-time-by", objects(|o| o.share_of_time));
    list("accuracy-error-by", objects(|o| o.share_of_error));
    let effects: Vec<String> = (report.effects.iter())
        .filter_map(|e| {
            let saved = e.saved?;
            let name = words::effect(language, e.name);
            Some(match e.within_noise {
                true => format!("{name} ±0"),
                false => format!("{name} {} %", words::percent(language, saved)),
            })
        })
        .collect();
    list("accuracy-taken-out", effects);
    let skipped: Vec<String> = (report.skipped.iter())
        .map(|s| format!("{}: {}", s.axis, s.why.wording(language)))
        .collect();
    let skipped = (!skipped.is_empty()).then(|| skipped.join("; "));
    list("accuracy-not-run", skipped.into_iter().collect());
    list("accuracy-cut", words::each(language, &report.budget.cut));
    line(out, &sureness(report, language));
}

fn wrapped_list(text: &str, width: usize) -> Vec<String> {
    match text.width() <= width {
        true => vec![text.to_owned()],
        false => {
            let lines = wrapped(text, width - 2);
            lines
                .into_iter()
                .enumerate()
                .map(|(i, l)| if i == 0 { l } else { format!("  {l}") })
                .collect()
        }
    }
}

/// How sure all of this is, in a line.
pub fn sureness(report: &Report, language: Language) -> String {
    let noise = words::percent(language, report.noise.relative);
    let mut parts = vec![say(
        language,
        "accuracy-noise",
        &[("percent", noise.into())],
    )];
    if report.budget.pixels_share < 1.0 {
        let share = words::percent(language, report.budget.pixels_share);
        parts.push(say(
            language,
            "accuracy-share",
            &[("percent", share.into())],
        ));
    }
    if let Some(edges) = report.reference.get(Kind::Edges.name())
        && let (Some(samples), Some(margin)) = (edges.samples, edges.margin.steps)
    {
        let values = [
            ("samples", words::count(samples as usize)),
            ("error", words::error(language, margin).into()),
        ];
        parts.push(say(language, "accuracy-reference-edges", &values));
    }
    let checked = report
        .reference
        .get(Kind::Numbers.name())
        .and_then(|r| r.checked.as_ref());
    if let Some(checked) = checked.filter(|c| c.not_checked.is_none()) {
        let values = [
            ("pixels", words::count(checked.pixels)),
            ("rays", words::count(checked.rays as usize)),
            ("largest", format!("{:.0e}", checked.largest).into()),
        ];
        parts.push(say(language, "accuracy-checked", &values));
    }
    if let [before, .., after] = report.machine.load[..] {
        let load = local(language, format!("{before:.1}, {after:.1}"));
        parts.push(say(language, "accuracy-load", &[("load", load.into())]));
    }
    parts.join(" · ")
}
