//! Advice on settings, with the reason: one to three sentences by a fixed rule.

use super::configurations::{Axis, Kind};
use super::number_format::{self, count, say};
use super::report::{Advice, Report, Row};
use crate::diagnostics::{Complaint, Language, Value};

/// A copy of a report, with the advice in a language.
pub fn in_language(report: &Report, language: Language) -> Report {
    let mut own = report.clone();
    advise(&mut own, language);
    own
}

/// Writes the advice into a report.
pub fn advise(report: &mut Report, language: Language) {
    let parts = match wrong_reference(report, language) {
        Some(wrong) => vec![wrong],
        None => {
            let (limit, change) = (limit(report, language), change(report, language));
            let said = [&limit, &change].into_iter().flatten();
            let is_said = said.into_iter().any(|part| part.text.contains("`--depth "));
            let depth = depth(report, language).filter(|_| !is_said);
            let all = [
                limit,
                busy(report, language),
                change,
                depth,
                numbers(report, language),
                unchecked(report, language),
            ];
            all.into_iter().flatten().collect()
        }
    };
    report.advice = match parts.first() {
        Some(first) => first.text.clone(),
        None => say(language, "accuracy-advice-none", &[]),
    };
    report.advice_parts = parts;
}

/// The advice if the independent tracer comes to other pixels than the reference. It replaces all other advice.
fn wrong_reference(report: &Report, language: Language) -> Option<Advice> {
    let checked = report.wrong_reference()?;
    let places: Vec<String> = (checked.wrong_pixels.iter())
        .map(|[x, y]| format!("({x}, {y})"))
        .collect();
    let text = say(
        language,
        "accuracy-advice-wrong",
        &[
            ("wrong", count(checked.wrong)),
            ("pixels", count(checked.pixels)),
            (
                "largest",
                Value::Decimal(format!("{:.1e}", checked.largest)),
            ),
            ("places", places.join(", ").into()),
        ],
    );
    Some(Advice {
        what: "reference",
        text,
    })
}

/// The advice not to trust the times, since the machine was busy with other programs.
fn busy(report: &Report, language: Language) -> Option<Advice> {
    let times = number_format::times(language, report.too_busy()?);
    Some(Advice {
        what: "busy",
        text: say(language, "accuracy-advice-busy", &[("times", times.into())]),
    })
}

fn unchecked(report: &Report, language: Language) -> Option<Advice> {
    let checked = report
        .reference
        .get(Kind::Numbers.name())?
        .checked
        .as_ref()?;
    let why = checked.not_checked.clone()?;
    Some(Advice {
        what: "reference",
        text: say(
            language,
            "accuracy-advice-unchecked",
            &[("why", why.into())],
        ),
    })
}

/// The kinds of error that the advice weighs. Facets are not among them: they are no error of the scene as it is drawn.
const WEIGHED: [Kind; 3] = [Kind::Edges, Kind::Light, Kind::Numbers];

/// The axes on which the default settings are inexact.
const INEXACT: [Axis; 4] = [Axis::Samples, Axis::Depth, Axis::Cutoff, Axis::Precision];

/// The axes of the weighed kinds whose errors were measured.
fn measured(report: &Report) -> impl Iterator<Item = Axis> {
    let axes = Axis::ALL
        .into_iter()
        .filter(|axis| WEIGHED.contains(&axis.kind()));
    axes.filter(|&axis| {
        let mut rows = report.rows.iter().filter(|r| r.is_on(axis));
        rows.any(|r| r.error.is_some())
    })
}

/// Whether all errors of the default settings are known: on each inexact axis the scene has none, or it was measured.
fn is_whole(report: &Report) -> bool {
    let unasked = Complaint::new("accuracy-skip-unasked");
    let is_known = |axis: Axis| {
        let skipped = report.skipped.iter().find(|s| s.axis == axis.name());
        match skipped {
            Some(skipped) => skipped.why != unasked,
            None => report.default_of(axis.kind()).is_some(),
        }
    };
    INEXACT.into_iter().all(is_known)
}

/// The default row of the kind of error that is largest at the default settings.
pub fn largest(report: &Report) -> Option<&Row> {
    let defaults = WEIGHED.into_iter().filter_map(|k| report.default_of(k));
    defaults.max_by(|a, b| a.steps().total_cmp(&b.steps()))
}

/// The row to recommend for the largest kind of error: the most accurate of the cheapest ones that reach the goal.
/// `None` if the default reaches the goal, or if no row does.
pub fn recommended(report: &Report) -> Option<&Row> {
    let worst = largest(report)?;
    let goal = report.goal.steps;
    if worst.steps() <= goal {
        return None;
    }
    let kind = worst.kind()?;
    let most = goal * (1.0 + report.goal.tolerance);
    let ok = || {
        let rows = report.of_kind(kind);
        rows.filter(|r| r.steps() <= most && r.times_default.is_some() && r.same_as.is_none())
    };
    let time = |r: &Row| r.times_default.unwrap_or(f64::INFINITY);
    let least = ok().map(time).fold(f64::INFINITY, f64::min);
    let cheap = ok().filter(|r| time(r) <= least * (1.0 + report.noise.relative));
    cheap.min_by(|a, b| a.steps().total_cmp(&b.steps()))
}

fn limit(report: &Report, language: Language) -> Option<Advice> {
    let worst = largest(report)?;
    let kind = worst.kind()?;
    let error = |steps| number_format::error(language, steps);
    let goal = number_format::local(language, report.goal.steps.to_string());
    let others: Vec<f64> = (WEIGHED.into_iter())
        .filter(|&k| k != kind)
        .filter_map(|k| report.default_of(k))
        .map(Row::steps)
        .collect();
    let rest = others.iter().copied().fold(0.0, f64::max);
    let kind_name = number_format::kind(language, kind);
    let text = if worst.steps() <= report.goal.steps {
        let message = match is_whole(report) {
            true => "accuracy-advice-enough",
            false => "accuracy-advice-enough-of",
        };
        let axes: Vec<&str> = measured(report).map(Axis::name).collect();
        let unit = if report.goal.steps == 1.0 {
            "step"
        } else {
            "steps"
        };
        say(
            language,
            message,
            &[
                ("goal", goal.into()),
                ("unit", unit.into()),
                ("axes", axes.join(", ").into()),
                ("kind", kind_name.into()),
                ("error", error(worst.steps()).into()),
            ],
        )
    } else {
        let found = recommended(report);
        let mut text = say(
            language,
            "accuracy-advice-limit",
            &[
                ("kind", kind_name.into()),
                ("error", error(worst.steps()).into()),
            ],
        );
        text.push(' ');
        let margin = report.margin(kind);
        match found {
            Some(row) => {
                // An error below twice the margin is uncertain, and only this bound is told.
                let reached = match row.steps() < 2.0 * margin {
                    true => say(
                        language,
                        "accuracy-at-most",
                        &[("error", error(2.0 * margin).into())],
                    ),
                    false => error(row.steps()),
                };
                let times = number_format::times(language, row.times_default.unwrap_or(1.0));
                text += &say(
                    language,
                    "accuracy-advice-set",
                    &[
                        ("option", row.option.clone().into()),
                        ("error", reached.into()),
                        ("times", times.into()),
                    ],
                );
                // On the other axis of the kind, the cheapest setting that reaches the goal is told if it costs more.
                let other = report
                    .of_kind(kind)
                    .filter(|r| r.axis != row.axis && r.same_as.is_none())
                    .filter(|r| r.steps() <= report.goal.steps * (1.0 + report.goal.tolerance))
                    .filter_map(|r| Some((r, r.times_default?)))
                    .min_by(|a, b| a.1.total_cmp(&b.1));
                if let Some((other, time)) = other
                    && time > row.times_default.unwrap_or(1.0) * (1.0 + report.noise.relative)
                {
                    text.push(' ');
                    text += &say(
                        language,
                        "accuracy-advice-dearer",
                        &[
                            ("option", other.option.clone().into()),
                            ("error", error(other.steps()).into()),
                            ("times", number_format::times(language, time).into()),
                        ],
                    );
                }
            }
            None => {
                let rows = report
                    .of_kind(kind)
                    .filter(|r| !r.default && r.times_default.is_some());
                if let Some(best) = rows.min_by(|a, b| a.steps().total_cmp(&b.steps())) {
                    let times = number_format::times(language, best.times_default.unwrap_or(1.0));
                    text += &say(
                        language,
                        "accuracy-advice-even",
                        &[
                            ("option", best.option.clone().into()),
                            ("error", error(best.steps()).into()),
                            ("times", times.into()),
                        ],
                    );
                }
            }
        }
        if !others.is_empty() {
            text.push(' ');
            // The error is rounded up to hundredths.
            let above = match rest {
                r if r < 0.01 => 0.01,
                r => ((r * 100.0).floor() + 1.0) / 100.0,
            };
            text += &say(
                language,
                match is_whole(report) {
                    true => "accuracy-advice-others",
                    false => "accuracy-advice-others-of",
                },
                &[("error", error(above).into())],
            );
        }
        text
    };
    Some(Advice {
        what: "limit",
        text,
    })
}

/// The advice to change a setting that repairs wrong pixels at a low price, or that saves time without being seen.
fn change(report: &Report, language: Language) -> Option<Advice> {
    // If the run was stopped before a setting was timed, there is no such advice.
    if !report.rows.iter().any(|r| r.times_default.is_some()) {
        return None;
    }
    let is_busy = report.too_busy().is_some();
    let worst = largest(report).and_then(Row::kind);
    let mut said = Vec::new();
    let mut saves = false;
    for kind in [Kind::Light]
        .into_iter()
        .filter(|&k| Some(k) != worst || k == Kind::Light)
    {
        let Some(default) = report.default_of(kind) else {
            continue;
        };
        let timed = || {
            let rows = report
                .of_kind(kind)
                .filter(|r| r.same_as.is_none() && !r.default);
            rows.filter_map(|r| Some((r, r.times_default?)))
        };
        let off = default.off();
        if off > 0 && Some(kind) != worst {
            let repair = timed()
                .filter(|(r, t)| 2 * r.off() <= off && *t <= 1.25)
                .min_by_key(|(r, t)| (r.off(), (t * 1000.0) as u64));
            if let Some((row, time)) = repair {
                let put_right = off - row.off();
                let price = match time - 1.0 {
                    _ if is_busy => say(language, "accuracy-price-unsure", &[]),
                    p if p > report.noise.relative => say(
                        language,
                        "accuracy-price",
                        &[("percent", number_format::percent(language, p).into())],
                    ),
                    _ => say(language, "accuracy-price-none", &[]),
                };
                said.push(say(
                    language,
                    "accuracy-advice-repair",
                    &[
                        ("option", row.option.clone().into()),
                        ("right", count(put_right)),
                        ("off", count(off)),
                        ("pixels", count(row.error.as_ref().map_or(0, |e| e.pixels))),
                        ("price", price.into()),
                    ],
                ));
                continue;
            }
        }
        let save = timed()
            .filter(|(r, t)| {
                let is_unseen = r.off() <= off && r.steps() <= report.goal.steps / 10.0;
                is_unseen && saving(report, *t).is_some_and(is_tenth)
            })
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((row, time)) = save {
            saves = true;
            said.push(saved(row, time, language));
        }
    }
    if let Some((row, time)) = single_precision(report) {
        saves = true;
        said.push(saved(row, time, language));
    }
    if said.is_empty() && is_busy {
        return None;
    }
    let what = if saves { "save" } else { "change" };
    let text = match said.is_empty() {
        true => say(language, "accuracy-advice-no-change", &[]),
        false => said.join(" "),
    };
    Some(Advice { what, text })
}

/// The sentence that a setting saves time.
fn saved(row: &Row, time: f64, language: Language) -> String {
    let percent = number_format::percent(language, 1.0 - time);
    let values = [
        ("option", row.option.clone().into()),
        ("percent", percent.into()),
    ];
    say(language, "accuracy-advice-save", &values)
}

/// The row of single precision and its time as a multiple of the default's. `None` unless it saves a tenth of the time
/// and no pixel is off by more than a step.
fn single_precision(report: &Report) -> Option<(&Row, f64)> {
    let mut rows = report.rows.iter().filter(|r| r.is_on(Axis::Precision));
    let row = rows.find(|r| r.setting == "f32" && r.error.is_some() && r.off() == 0)?;
    let time = row.times_default?;
    (saving(report, time).is_some_and(is_tenth)).then_some((row, time))
}

/// The share of the default's time that a setting saves; `None` if this is not certain. `time` is a multiple of the
/// default's time. A saving of a tenth is recommended, and has to exceed the noise twice.
fn saving(report: &Report, time: f64) -> Option<f64> {
    let (share, noise) = (1.0 - time, report.noise.relative);
    let least = if is_tenth(share) { 2.0 * noise } else { noise };
    (report.too_busy().is_none() && share > least).then_some(share)
}

/// Whether a share is at least a tenth once it is rounded to whole percents.
fn is_tenth(share: f64) -> bool {
    (100.0 * share).round() >= 10.0
}

/// The advice on depth: whether more depth would show, or less would be enough.
fn depth(report: &Report, language: Language) -> Option<Advice> {
    let number = |row: &Row| row.setting.parse::<u32>().ok();
    let rows = || {
        let rows = report.rows.iter().filter(|r| r.is_on(Axis::Depth));
        rows.filter_map(|r| Some((number(r)?, r, r.times_default?)))
    };
    let (own, default, _) = rows().find(|(_, r, _)| r.default)?;
    let off = default.off();
    let deeper = rows().filter(|(depth, r, _)| *depth > own && r.off() < off);
    let is_alike = |r: &Row| r.off() <= off && r.steps() <= report.goal.steps / 10.0;
    let flatter = || rows().filter(|(depth, r, _)| *depth < own && is_alike(r));
    // Fewer rays cannot take longer. A time that claims so is noise, and no reason to recommend less.
    let may_save = |time: f64| report.too_busy().is_some() || time <= 1.0 + report.noise.relative;
    let less = flatter().filter(|(.., time)| may_save(*time));
    let mut values = vec![("depth", Value::from(own.to_string()))];
    let message = if let Some((_, row, time)) = deeper.min_by_key(|(n, r, _)| (r.off(), *n)) {
        values.extend([
            ("option", row.option.clone().into()),
            ("right", count(off - row.off())),
            ("off", count(off)),
            ("times", number_format::times(language, time).into()),
        ]);
        "accuracy-depth-more"
    } else if let Some((_, row, time)) = less.min_by_key(|(n, ..)| *n) {
        values.extend([
            ("option", row.option.clone().into()),
            ("price", price(report, time, language).into()),
        ]);
        "accuracy-depth-less"
    } else if flatter().next().is_some() {
        "accuracy-depth-same"
    } else if rows().any(|(depth, ..)| depth < own) {
        "accuracy-depth-right"
    } else {
        return None;
    };
    Some(Advice {
        what: "depth",
        text: say(language, message, &values),
    })
}

/// The words for a price in time, as `saves 12 %`. `time` is a multiple of the default's time.
fn price(report: &Report, time: f64, language: Language) -> String {
    let percent = |share: f64| [("percent", number_format::percent(language, share).into())];
    if report.too_busy().is_some() {
        return say(language, "accuracy-time-unsure", &[]);
    }
    match (saving(report, time), time - 1.0) {
        (Some(share), _) => say(language, "accuracy-saves", &percent(share)),
        (None, p) if p > report.noise.relative => say(language, "accuracy-costs", &percent(p)),
        (None, _) => say(language, "accuracy-saves-nothing", &[]),
    }
}

/// Whether the advice mentions the option of a row.
pub fn names(report: &Report, row: &Row) -> bool {
    let option = format!("`{}`", row.option);
    report
        .advice_parts
        .iter()
        .any(|part| part.text.contains(&option))
}

/// The advice about numbers.
fn numbers(report: &Report, language: Language) -> Option<Advice> {
    let of = |name: &str| {
        let mut rows = report.rows.iter().filter(|r| r.is_on(Axis::Precision));
        rows.find(|r| r.setting == name)
    };
    let mut said = Vec::new();
    if let Some(f64_row) = of("f64") {
        let dd = of("dd").and_then(|r| r.times_default);
        let dd = dd.map(|t| number_format::times(language, t));
        let error = f64_row.error.as_ref()?;
        said.push(match (error.is_same(), error.pixels_off, dd) {
            (true, _, Some(dd)) => say(language, "accuracy-numbers-same", &[("times", dd.into())]),
            (_, 0, Some(dd)) => say(language, "accuracy-numbers-unseen", &[("times", dd.into())]),
            (_, 0, None) => say(language, "accuracy-numbers-untimed", &[]),
            (_, n, _) => say(language, "accuracy-numbers-report", &[("off", count(n))]),
        });
    }
    for (name, message) in [
        ("f32", "accuracy-numbers-f32"),
        ("plain-f64", "accuracy-numbers-plain"),
    ] {
        let Some(row) = of(name) else { continue };
        let Some(time) = row.times_default else {
            continue;
        };
        // The advice to save time recommends it already.
        if name == "f32" && single_precision(report).is_some() {
            continue;
        }
        let off = row.off();
        said.push(say(
            language,
            message,
            &[
                ("off", count(off)),
                ("price", price(report, time, language).into()),
            ],
        ));
    }
    (!said.is_empty()).then(|| Advice {
        what: "numbers",
        text: said.join(" "),
    })
}
