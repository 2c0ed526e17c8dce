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
    let names: &[&str] = match record.ty.code {
        -201 => &[""],
        _ => &[" in red", " in green", " in blue"],
    };
    let mut channels = Vec::new();
    for ((k, t), name) in values.chunks(3).zip(tokens.chunks(3)).zip(names) {
        let sum: f64 = k.iter().sum();
        let in_range = k.iter().all(|x| (0.0..=1.0).contains(x));
        if in_range && sum > 1.0 + ROUNDING {
            channels.push((
                t[0].span().to(t[2].span()),
                format!("kd + ks + kt = {}{name}", short(sum)),
            ));
        }
    }
    let Some(((span, first), rest)) = channels.split_first() else {
        return;
    };
    let mut d = Diagnostic::new(
        Code::W302,
        *span,
        format!("this surface gives off more light than it gets: {first}"),
    )
    .here("more than 1")
    .help("the three parts share the light that arrives; their sum should be at most 1");
    for (span, text) in rest {
        d = d.label(*span, text.clone());
    }
    out.push(d);
}

/// A sum of decimals without the rounding of its last digits.
fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
