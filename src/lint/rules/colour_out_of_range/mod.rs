//! W301: a colour with a part outside of 0 to 1.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::lint::Context;
use crate::lint::spelling::rough;
use crate::scene::record::Params;
use crate::syntax::table::RecordKind;

/// Whole numbers up to 255 are bytes as image programs show them. Up to 100 they may as well be
/// per cent, and nothing is proposed.
const BYTE_MAX: f64 = 255.0;
const PER_CENT_MAX: f64 = 100.0;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for record in context.records() {
        // Its numbers may be another record's: W314 says so.
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

/// `first` is the parameter where the colours begin.
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
    let all = || (first..p.len()).map(|i| p.number(i));
    let largest = all().fold(0.0, f64::max);
    let bytes = all().all(|x| x.fract() == 0.0 && (0.0..=BYTE_MAX).contains(&x));
    if bytes && largest > PER_CENT_MAX {
        let edits = (first..p.len()).filter(|&i| p.number(i) != 0.0);
        d.note("bytes").fix(Fix {
            title: "divide",
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits: edits
                .map(|i| edit(p, i, rough(p.number(i) / BYTE_MAX)))
                .collect(),
        })
    } else {
        let edits = (first..p.len()).filter(|&i| is_outside(p, i));
        d.fix(Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits: edits
                .map(|i| edit(p, i, rough(p.number(i).clamp(0.0, 1.0))))
                .collect(),
        })
    }
}

fn edit(p: &Params, i: usize, text: String) -> Edit {
    Edit {
        span: p.span_of(i, 1),
        text,
    }
}
