//! The report for the terminal, in some 35 lines.

use super::super::advice::names;
use super::super::configurations::{Axis, Kind};
use super::super::number_format::{self, local, say};
use super::super::report::{Report, Row};
use crate::diagnostics::layout::{listed, wrapped};
use crate::diagnostics::{Complaint, Language};
use std::fmt::Write as _;
use unicode_width::UnicodeWidthStr as _;

/// The width of a row without its bar, in columns.
const ROW: usize = 78;
/// The length of the longest bar, in columns.
const BAR: usize = 24;
/// The width in columns from which an entry of a list counts as a sentence.
const SENTENCE: usize = 40;
/// The number of rows shown of each kind, unless more are needed.
const MOST_ROWS: usize = 5;

/// The report in lines no wider than `width`, but at least 80 columns. `page` is the line that says where the page was
/// written. Bars are drawn where there is room.
pub fn text(report: &Report, language: Language, page: Option<&str>, width: usize) -> String {
    let width = width.max(ROW + 2);
    let mut out = String::new();
    let [w, h] = report.size;
    let title = say(language, "accuracy-title", &[]);
    let spent = number_format::seconds(language, report.budget.spent_seconds);
    let entries = [title, report.scene.clone(), format!("{w}x{h}"), spent];
    line(&mut out, &listed("", &entries, width, "  "));
    if report.stopped {
        line(&mut out, &say(language, "accuracy-stopped", &[]));
    }
    out.push('\n');
    for (i, part) in report.advice_parts.iter().enumerate() {
        let mark = if i == 0 { "▶ " } else { "  " };
        line(
            &mut out,
            &wrapped(&format!("{mark}{}", part.text), width, "  "),
        );
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
            line(&mut out, &row_line(row, report, language, width));
        }
    }
    out.push('\n');
    let under = match first {
        true => nothing(report, language),
        false => say(
            language,
            "accuracy-legend",
            &[("left", number_format::count(left))],
        ),
    };
    line(&mut out, &wrapped(&under, width, "  "));
    out.push('\n');
    summaries(&mut out, report, language, width);
    if let Some(page) = page {
        line(&mut out, &wrapped(page, width, "  "));
    }
    out
}

/// The text that says why no setting was tried, for each axis that was asked for.
fn nothing(report: &Report, language: Language) -> String {
    let unasked = Complaint::new("accuracy-skip-unasked");
    let asked = report.skipped.iter().filter(|s| s.why != unasked);
    let why: Vec<String> = asked
        .map(|s| format!("{}: {}", s.axis, s.why.wording(language)))
        .collect();
    say(
        language,
        "accuracy-nothing",
        &[("why", why.join(" · ").into())],
    )
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

fn heading(kind: Kind, rows: &[&Row], language: Language) -> String {
    let mut axes: Vec<&str> = rows.iter().map(|r| r.axis).collect();
    axes.dedup();
    format!(
        "{}: {}",
        number_format::kind(language, kind),
        axes.join(", ")
    )
}

/// The rows that are shown: the default, the first and the last, those on the front or in the advice, and all of
/// numbers.
fn kept<'r>(rows: &[&'r Row], report: &Report) -> Vec<&'r Row> {
    // Only the first of several rows with the default settings is needed.
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

fn row_line(row: &Row, report: &Report, language: Language, width: usize) -> String {
    // Rows that were not measured, or have the same computation as another row, are not compared.
    let is_compared = row.error.is_some() && row.same_as.is_none();
    let mark = match (row.default, row.pareto) {
        (true, _) => '◆',
        (_, true) => '●',
        _ if is_compared => '○',
        _ => ' ',
    };
    let [w, h] = report.size;
    let pixels = f64::from(w) * f64::from(h);
    // The time of the whole picture is computed from that of the pixels that were timed.
    let cpu = row.times_default.zip(whole_default(report, pixels));
    let cpu = cpu.map_or("–".into(), |(t, d)| {
        number_format::seconds(language, t * d)
    });
    let times = row.times_default.map_or("–".into(), |t| {
        format!("{} ×", number_format::times(language, t))
    });
    let error = row.error.as_ref();
    let steps = match (&row.same_as, error) {
        (_, None) => "–".into(),
        (_, Some(e)) if e.pixels_differ == 0 => say(language, "accuracy-same", &[]),
        (_, Some(e)) => number_format::error(language, e.steps),
    };
    let flip = error.map_or(String::new(), |e| local(language, format!("{:.4}", e.flip)));
    let off = error.map_or(String::new(), |e| match e.pixels {
        0 => String::new(),
        _ => percent(e.pixels_off, e.pixels, language),
    });
    let bar = row
        .times_default
        .map_or(0, |t| ((t.max(0.1).log2() + 4.0) * 1.6) as usize);
    // Bars cut short would mislead: either all are drawn, or none.
    let room = if width >= ROW + BAR { BAR } else { 0 };
    format!(
        "  {mark} {}{}{}{}{}{}  {}",
        padded(&row.name(), 24),
        right(&cpu, 10),
        right(&times, 10),
        right(&steps, 10),
        right(&flip, 9),
        right(&off, 9),
        "█".repeat(bar.min(room)),
    )
}

/// A share of pixels in percent: `0`, or with about two digits.
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

/// The CPU seconds that the default takes for the whole picture, of `pixels` pixels.
pub fn whole_default(report: &Report, pixels: f64) -> Option<f64> {
    let row = report
        .rows
        .iter()
        .find(|r| r.default && r.cpu_seconds.is_some())?;
    let timed = row.pixels_timed.max(1) as f64;
    Some(row.cpu_seconds?.min * pixels / timed)
}

fn summaries(out: &mut String, report: &Report, language: Language, width: usize) {
    let mut list = |message: &'static str, items: Vec<String>| {
        if !items.is_empty() {
            let name = padded(&say(language, message, &[]), 30) + "  ";
            // Sentences begin on a line of their own.
            let first = match items.iter().all(|item| item.width() < SENTENCE) {
                true => &name,
                false => {
                    line(out, name.trim_end());
                    "  "
                }
            };
            line(out, &listed(first, &items, width, "  "));
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
                format!("{name} {} %", number_format::percent(language, share(o)))
            })
            .collect::<Vec<_>>()
    };
    list("accuracy-time-by", objects(|o| o.share_of_time));
    list("accuracy-error-by", objects(|o| o.share_of_error));
    let effects: Vec<String> = (report.effects.iter())
        .filter_map(|e| {
            let saved = e.saved?;
            let name = number_format::effect(language, e.name);
            Some(match e.within_noise {
                true => format!("{name} ±0"),
                false => format!("{name} {} %", number_format::percent(language, saved)),
            })
        })
        .collect();
    list("accuracy-taken-out", effects);
    let together = report.skipped.chunk_by(|a, b| a.why == b.why);
    let skipped = together.map(|all| {
        let axes: Vec<&str> = all.iter().map(|s| s.axis).collect();
        format!("{}: {}", axes.join(", "), all[0].why.wording(language))
    });
    list("accuracy-not-run", skipped.collect());
    list(
        "accuracy-cut",
        number_format::each(language, &report.budget.cut),
    );
    line(out, &listed("", &sureness(report, language), width, "  "));
}

/// The parts of the line that says how certain the report is: noise, share of pixels, references, load.
pub fn sureness(report: &Report, language: Language) -> Vec<String> {
    let noise = number_format::percent(language, report.noise.relative);
    let times = match report.too_busy() {
        Some(_) => "accuracy-noise-busy",
        None => "accuracy-noise",
    };
    let mut parts = vec![say(language, times, &[("percent", noise.into())])];
    if report.budget.pixels_share < 1.0 {
        let share = number_format::percent(language, report.budget.pixels_share);
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
            ("samples", number_format::count(samples as usize)),
            ("error", number_format::error(language, margin).into()),
        ];
        parts.push(say(language, "accuracy-reference-edges", &values));
    }
    let checked = report
        .reference
        .get(Kind::Numbers.name())
        .and_then(|r| r.checked.as_ref());
    if let Some(checked) = checked.filter(|c| c.not_checked.is_none()) {
        let largest = match checked.largest {
            0.0 => number_format::count(0),
            off => format!("{off:.0e}").into(),
        };
        let values = [
            ("pixels", number_format::count(checked.pixels)),
            ("rays", number_format::count(checked.rays as usize)),
            ("largest", largest),
        ];
        parts.push(say(language, "accuracy-checked", &values));
    }
    if let [before, .., after] = report.machine.load[..] {
        let load = |load: f64| local(language, format!("{load:.1}")).into();
        let values = [("before", load(before)), ("after", load(after))];
        parts.push(say(language, "accuracy-load", &values));
    }
    parts
}
