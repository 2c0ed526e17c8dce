//! W301: a colour with a part outside of 0 to 1.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::spelling::{linear_part, rough, spelled};
use crate::scene::record::Params;
use crate::syntax::table::RecordKind;
use crate::syntax::with_point;

/// Whole numbers up to 255 are taken for bytes in sRGB, as image programs show them and hexadecimal colours have them.
/// If none is above 100 and one is 10 at least, they are rather per cent.
const BYTE_MAX: f64 = 255.0;
const PER_CENT_MAX: f64 = 100.0;
const PER_CENT_MIN: f64 = 10.0;

pub(in crate::lint) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for record in context.records() {
        // The numbers of a doubted record may belong to another record: W314 reports it.
        if context.document.is_doubted(record.first) {
            continue;
        }
        // The parts of optics are shares of light, not colours.
        if !matches!(record.kind, RecordKind::Colour | RecordKind::Shape(_)) {
            continue;
        }
        let Some(first) = record.ty().first_colour(record.count()) else {
            continue;
        };
        let p = context.record_params(record);
        if (first..p.len()).any(|i| is_outside(&p, i)) {
            out.push(finding(&p, first));
        }
    }
}

fn is_outside(p: &Params, i: usize) -> bool {
    !(0.0..=1.0).contains(&p.number(i))
}

/// The finding about a record with colour parts out of range. `first` is the index of the first colour parameter.
fn finding(p: &Params, first: usize) -> Diagnostic {
    let colours = || (first..p.len()).step_by(3);
    let mut outside = colours().filter(|&i| (i..i + 3).any(|i| is_outside(p, i)));
    let at = outside.next().unwrap_or(first);
    let bad: Vec<usize> = (at..at + 3).filter(|&i| is_outside(p, i)).collect();
    let parts: Vec<String> = bad
        .iter()
        .map(|&i| {
            let name = p.param(i).map_or("", |q| q.name);
            format!("{name} = {}", p.text_of(i))
        })
        .collect();
    let (from, to) = (bad[0], bad[bad.len() - 1]);
    let d = Diagnostic::new(Code::W301, p.span_of(from, to - from + 1))
        .case(if first == 0 { "" } else { "point" })
        .with("parts", parts.join(", "))
        .with("point", ((at - first) / 3 + 1).to_string())
        .with(
            "others",
            crate::diagnostics::Value::Count(outside.count() as u64),
        );
    let values: Vec<f64> = (first..p.len()).map(|i| p.number(i)).collect();
    let scaled = |title, part: fn(f64) -> String| {
        let edits = (first..p.len()).filter(|&i| p.number(i) != 0.0);
        let edits = edits.map(|i| edit(p, i, part(p.number(i))));
        Fix::guess(title, edits.collect())
    };
    let linear = || scaled("linear", |x| linear_part(x as u8));
    let pointed = (first..p.len()).filter_map(|i| Some(edit(p, i, with_point(p.text_of(i))?)));
    let pointed: Vec<Edit> = pointed.collect();
    if !pointed.is_empty() {
        return d.fix(Fix::guess("point-lost", pointed));
    }
    let limited = || {
        let edits = (first..p.len()).filter(|&i| is_outside(p, i));
        let edits = edits.map(|i| edit(p, i, rough(p.number(i).clamp(0.0, 1.0))));
        Fix::guess("fix", edits.collect())
    };
    // A single digit beside decimals: `.1 .3 7`.
    let is_digit = |i: usize| !is_outside(p, i) || p.text_of(i).len() == 1;
    if (first..p.len()).all(is_digit) && values.iter().any(|x| x.fract() != 0.0) {
        let edits = (first..p.len()).filter(|&i| is_outside(p, i));
        let edits = edits.map(|i| edit(p, i, format!("0.{}", p.text_of(i))));
        return d
            .fix(Fix::guess("point-lost", edits.collect()))
            .fix(limited());
    }
    match scale(&values) {
        Some(Scale::Bytes) => {
            let mut shares = scaled("shares", |x| {
                spelled((x / BYTE_MAX * 1000.0).round() / 1000.0)
            });
            shares.applicability = Applicability::Choice;
            d.note("bytes").fix(linear()).fix(shares)
        }
        Some(Scale::PerCent) => {
            (d.fix(scaled("hundredths", |x| rough(x / PER_CENT_MAX)))).fix(linear())
        }
        None => d.fix(limited()),
    }
}

/// The scale of colours written in whole numbers rather than in parts of 1.
enum Scale {
    Bytes,
    PerCent,
}

fn scale(values: &[f64]) -> Option<Scale> {
    let is_whole = |x: &f64| x.fract() == 0.0 && (0.0..=BYTE_MAX).contains(x);
    let largest = values.iter().copied().fold(0.0, f64::max);
    match values.iter().all(is_whole) {
        true if largest > PER_CENT_MAX => Some(Scale::Bytes),
        true if largest >= PER_CENT_MIN => Some(Scale::PerCent),
        _ => None,
    }
}

fn edit(p: &Params, i: usize, text: String) -> Edit {
    Edit {
        span: p.span_of(i, 1),
        text,
    }
}
