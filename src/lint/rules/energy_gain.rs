//! W302: a surface that gives more light than it gets.

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::syntax::{Item, Record};

/// The sum of the decimal numbers may exceed 1 by the rounding of its three terms and two additions.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for item in &context.document.items {
        if let Item::Record(record) = item
            && matches!(record.ty.code, -201 | -202)
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
    let channels: &[(&str, &str)] = match record.ty.code {
        -201 => &[("", "")],
        _ => &[
            ("red", "sum-in-red"),
            ("green", "sum-in-green"),
            ("blue", "sum-in-blue"),
        ],
    };
    let mut finding: Option<Diagnostic> = None;
    for ((k, t), &(channel, phrase)) in values.chunks(3).zip(tokens.chunks(3)).zip(channels) {
        let sum: f64 = k.iter().sum();
        let in_range = k.iter().all(|x| (0.0..=1.0).contains(x));
        if in_range && sum > 1.0 + ROUNDING {
            let span = t[0].span().to(t[2].span());
            finding = Some(match finding {
                None => Diagnostic::new(Code::W302, span)
                    .case(channel)
                    .with("sum", short(sum)),
                Some(d) => d.label(span, phrase).with(channel, short(sum)),
            });
        }
    }
    out.extend(finding);
}

/// A sum of decimals without the rounding of its last digits.
fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
