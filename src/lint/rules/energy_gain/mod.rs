//! W302: a surface that gives more light than it gets.

use crate::diagnostics::{Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::spelling::shares;
use crate::syntax::table::RecordKind;
use crate::syntax::with_point;
use crate::syntax::{Item, Record};

/// The sum of the decimal numbers may exceed 1 by the rounding of its three terms and two additions.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

pub(in crate::lint) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for item in &context.document.items {
        if let Item::Record(record) = item
            && matches!(record.kind, RecordKind::Optics | RecordKind::OpticsRgb)
        {
            check_record(context, record, out);
        }
    }
}

fn check_record(context: &Context, record: &Record, out: &mut Vec<Diagnostic>) {
    let tokens: Vec<_> = context.document.params(record).collect();
    let values: Vec<f64> = tokens
        .iter()
        .filter_map(|t| t.number(context.text))
        .collect();
    let channels: &[(&str, &str)] = match record.kind {
        RecordKind::Optics => &[("", "")],
        _ => &[
            ("red", "sum-in-red"),
            ("green", "sum-in-green"),
            ("blue", "sum-in-blue"),
        ],
    };
    let texts: Vec<&str> = tokens.iter().map(|t| t.text(context.text)).collect();
    let mut gains = Vec::new();
    let mut edits = Vec::new();
    for ((k, t), &(channel, phrase)) in values.chunks(3).zip(tokens.chunks(3)).zip(channels) {
        let sum: f64 = k.iter().sum();
        let in_range = k.iter().all(|x| (0.0..=1.0).contains(x));
        if in_range && sum > 1.0 + ROUNDING {
            let changed = t.iter().zip(shares(k, sum));
            let changed = changed.filter(|(t, text)| t.text(context.text) != text.as_str());
            edits.extend(changed.map(|(t, text)| Edit {
                span: t.span(),
                text,
            }));
            gains.push((sum, t[0].span().to(t[2].span()), channel, phrase));
        }
    }
    // The finding is about the channel with the largest sum, the first among equals; the others get labels.
    gains.sort_by(|a, b| b.0.total_cmp(&a.0));
    let Some(((sum, span, channel, _), others)) = gains.split_first() else {
        return;
    };
    let worst = Diagnostic::new(Code::W302, *span)
        .case(channel)
        .with("sum", short(*sum));
    let written = |(title, new): (&'static str, Vec<String>)| {
        let changed = (tokens.iter().zip(new)).filter(|(t, new)| t.text(context.text) != new);
        let edits = changed.map(|(t, text)| Edit {
            span: t.span(),
            text,
        });
        Fix::guess(title, edits.collect())
    };
    let slip = with_points(&texts).or_else(|| by_channel(&texts));
    let fixes = slip
        .map(written)
        .into_iter()
        .chain([Fix::guess("fix", edits)]);
    let worst = fixes.fold(worst, Diagnostic::fix);
    out.push(
        others
            .iter()
            .fold(worst, |d, &(sum, span, channel, phrase)| {
                d.label(span, phrase).with(channel, short(sum))
            }),
    );
}

/// Restores the decimal points that some parts have lost. Returns the title of the fix and the new texts; `None` if a
/// sum is still above 1.
fn with_points(texts: &[&str]) -> Option<(&'static str, Vec<String>)> {
    let new = texts
        .iter()
        .map(|t| with_point(t).unwrap_or((*t).to_owned()));
    let new: Vec<String> = new.collect();
    is_within(&new).then_some(("point-lost", new))
}

/// Turns nine parts that may be given kind by kind (kd in red, green and blue, then ks, then kt) into parts channel by
/// channel. Returns the title of the fix and the new texts; `None` if a sum is still above 1.
fn by_channel(texts: &[&str]) -> Option<(&'static str, Vec<String>)> {
    let nine: &[&str; 9] = texts.try_into().ok()?;
    let new: Vec<String> = (0..9).map(|i| nine[i % 3 * 3 + i / 3].to_owned()).collect();
    is_within(&new).then_some(("kinds", new))
}

/// Whether a surface with these parts gives no more light than it gets.
fn is_within(texts: &[String]) -> bool {
    let values: Option<Vec<f64>> = texts.iter().map(|t| t.parse().ok()).collect();
    values.is_some_and(|values| {
        let is_part = |x: &f64| (0.0..=1.0).contains(x);
        let sums = values.chunks(3).map(|k| k.iter().sum::<f64>());
        values.iter().all(is_part) && sums.into_iter().all(|sum| sum <= 1.0 + ROUNDING)
    })
}

/// Writes a sum of decimal numbers without the rounding of its last digits, with as many decimals as show that the sum
/// is above 1.
fn short(x: f64) -> String {
    let texts = [6, 9, 12, 15].map(|digits| format!("{x:.digits$}"));
    let above = texts.iter().find(|t| t.parse().is_ok_and(|x: f64| x > 1.0));
    let text = above.unwrap_or(&texts[0]);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::shares;
    use crate::lint::testing::{found, messages};
    use crate::testing::random;

    #[test]
    fn the_parts_divided_by_their_sum() {
        let texts = |k: &[f64]| shares(k, k.iter().sum()).join(" ");
        assert_eq!(texts(&[0.6, 0.6, 0.6]), "0.333 0.333 0.333");
        assert_eq!(texts(&[0.9, 0.3, 0.0]), "0.75 0.25 0");
        assert_eq!(texts(&[1.0, 1.0, 0.0]), "0.5 0.5 0");
        assert_eq!(texts(&[1.0, 0.5, 0.0]), "0.667 0.333 0");
        // Any three: what is written is near, is within the rule, and is short.
        let mut random = random();
        for _ in 0..2000 {
            let k: Vec<f64> = (0..3).map(|_| random(1001) as f64 / 1000.0).collect();
            let sum: f64 = k.iter().sum();
            if sum <= 1.0 {
                continue;
            }
            let all = shares(&k, sum);
            let decimal = |text: &String| {
                let (_, digits) = text.split_once('.').unwrap_or_default();
                let whole: u64 = text.split('.').next().unwrap().parse().unwrap();
                whole * 1_000_000_000 + format!("{digits:0<9}").parse::<u64>().unwrap()
            };
            assert!(
                all.iter().map(decimal).sum::<u64>() <= 1_000_000_000,
                "{k:?} {all:?}"
            );
            for (text, x) in all.iter().zip(&k) {
                let off = text.parse::<f64>().unwrap() - x / sum;
                assert!(off.abs() < 1e-3 && text.len() <= 11, "{k:?} {all:?}");
            }
            assert!(
                found(&format!("2 -201 {}\n", all.join(" ")))
                    .iter()
                    .all(|f| !f.starts_with("W302"))
            );
        }
    }

    #[test]
    fn the_worst_channel_is_named() {
        let scene = "2 -202 .5 .5 .5 1 1 1 0 0 0\n";
        assert_eq!(found(scene)[0], "W302 1:17");
        assert!(messages(scene)[0].ends_with("kd + ks + kt = 3 in green"));
        // Any three sums.
        let mut random = random();
        for _ in 0..200 {
            let k: Vec<u64> = (0..9).map(|_| random(11)).collect();
            let sums: Vec<u64> = k.chunks(3).map(|c| c.iter().sum()).collect();
            let worst = (0..3).rev().max_by_key(|&i| sums[i]).unwrap();
            let shares: Vec<String> = k.iter().map(|k| format!("{}", *k as f64 / 10.0)).collect();
            let all = messages(&format!("2 -202 {}\n", shares.join(" ")));
            let said = all.iter().find(|m| m.contains("more light than it gets"));
            assert_eq!(said.is_some(), sums[worst] > 10, "{shares:?}");
            // Of equal ones it may be any.
            let names = ["red", "green", "blue"].into_iter().zip(&sums);
            let mut worst = names.filter(|n| *n.1 == sums[worst]).map(|n| n.0);
            let ends = |m: &String| worst.any(|name| m.ends_with(&format!(" in {name}")));
            assert!(said.is_none_or(ends), "{said:?} {shares:?}");
        }
    }
}
