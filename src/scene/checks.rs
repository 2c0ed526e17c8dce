//! Checks of a record that concern several parameters at once.

use super::record::Params;
use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};

/// E203 unless the three parameters from `first` on make a vector with a direction.
pub fn non_zero(
    p: &Params,
    first: usize,
    what: &'static str,
    out: &mut Vec<Diagnostic>,
) -> Option<()> {
    if p.numbers::<3>(first).iter().any(|&x| x != 0.0) {
        return Some(());
    }
    out.push(
        Diagnostic::new(Code::E203, p.span_of(first, 3))
            .with("vector", Value::Term(what))
            .with("type", Value::Term(p.ty.title)),
    );
    None
}

/// E202 unless each of `n` lower bounds from `first` on is below its upper bound, `n` further on.
pub fn ordered(p: &Params, first: usize, n: usize, out: &mut Vec<Diagnostic>) -> Option<()> {
    let inverted: Vec<usize> = (first..first + n)
        .filter(|&i| p.number(i) > p.number(i + n))
        .collect();
    if inverted.is_empty() {
        return Some(());
    }
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    // Lower and upper bounds in turn, each pair in order and not equal: xmin xmax ymin ymax zmin zmax.
    let in_turn = (0..n).all(|i| p.number(first + 2 * i) < p.number(first + 2 * i + 1));
    // The bound that belongs to each place.
    let order: Vec<usize> = match in_turn {
        true => [0, 1]
            .iter()
            .flat_map(|end| (0..n).map(move |i| first + 2 * i + end))
            .collect(),
        false => (first..first + 2 * n)
            .map(|i| match i < first + n {
                true if inverted.contains(&i) => i + n,
                false if inverted.contains(&(i - n)) => i - n,
                _ => i,
            })
            .collect(),
    };
    let edits = (first..).zip(order).filter(|(to, from)| to != from);
    let edits = edits.map(|(to, from)| Edit {
        span: p.span_of(to, 1),
        text: p.text_of(from).to_owned(),
    });
    let at = inverted[0];
    out.push(
        Diagnostic::new(Code::E202, p.span_of(at, 1))
            .with("lower", name(at))
            .with("upper", name(at + n))
            .with("type", Value::Term(p.ty.title))
            .with("others", Value::Count(inverted.len() as u64 - 1))
            .label(p.span_of(at + n, 1), "other")
            .fix(Fix {
                title: if in_turn { "fix-order" } else { "fix" },
                values: Vec::new(),
                applicability: match in_turn {
                    true => Applicability::Unsafe,
                    false => Applicability::Safe,
                },
                edits: edits.collect(),
            }),
    );
    None
}
