//! N607: a rotation by a usual angle in radians, or by one that its comment gives in degrees or as a part of π.

use std::cell::LazyCell;

use super::angle_in_radians::usual;
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::spelling::decimal;
use crate::syntax::table::RecordKind;
use crate::syntax::words;

/// Angles in degrees whose radians people know by heart, as parts of π: two decimals are enough to recognise them.
const BY_HEART: [u32; 11] = [15, 30, 45, 60, 90, 120, 135, 150, 180, 270, 360];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let titles = LazyCell::new(|| context.titles());
    for record in context.records().filter(|r| r.kind == RecordKind::Rotation) {
        let p = context.record_params(record);
        let written = p.text_of(ANGLE);
        let parts = (1..=24).map(|k| 15 * k);
        let usual = usual(p.number(ANGLE).abs(), written, &BY_HEART, parts);
        let by_comment = || {
            let has_comments = context.document.contents.comments;
            (has_comments.then(|| {
                p.own_comments()
                    .find_map(|text| said(text, p.number(ANGLE)))
            }))?
        };
        let Some(degrees) = usual.map(|d| d.to_string()).or_else(by_comment) else {
            continue;
        };
        let sign = if p.number(ANGLE) < 0.0 { "-" } else { "" };
        let degrees = format!("{sign}{degrees}");
        let title = titles.get(&record.id).copied().unwrap_or("object");
        let place = p.span_of(ANGLE, 1);
        out.push(
            Diagnostic::new(Code::N607, place)
                .with("angle", written.to_owned())
                .with("degrees", degrees.clone())
                .with("type", Value::Term(title))
                .fix(Fix::replace("fix", Applicability::Unsafe, place, degrees)),
        );
    }
}

/// The index of the angle among the record's parameters.
const ANGLE: usize = 0;
/// Two angles are the same up to this part of them: people round radians to two digits.
const ROUNDED: f64 = 0.02;

/// The angle in degrees, without its sign, that a comment gives for an angle in radians.
fn said(comment: &str, radians: f64) -> Option<String> {
    let text = comment.replace(['−', '–'], "-").replace(',', ".");
    let text = text.replace('°', " ° ").replace('π', "pi").to_lowercase();
    let words: Vec<&str> = text.split_whitespace().collect();
    let is_unit = |word: &str| word == "°" || words::has(word, &["deg", "stup"]);
    let numbered = words.windows(2).filter(|pair| is_unit(pair[1]));
    let in_degrees = numbered.filter_map(|pair| pair[0].parse::<f64>().ok());
    // As `pi/4`, but not `3*pi/4`.
    let parts_of_pi = words.iter().filter_map(|word| {
        let by: f64 = word
            .trim_start_matches('-')
            .strip_prefix("pi/")?
            .parse()
            .ok()?;
        Some(180.0 / by)
    });
    let all: Vec<f64> = in_degrees.chain(parts_of_pi).collect();
    let &[degrees] = all.as_slice() else {
        return None;
    };
    let (is, meant) = (radians.abs(), degrees.abs().to_radians());
    let is_same = is > 0.0 && (is - meant).abs() <= ROUNDED * meant;
    (is_same && (degrees > 0.0 || radians < 0.0)).then(|| decimal(degrees.abs()))
}
