//! W305: a shape without volume, or a surface without area.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::scene::Shape;
use crate::scene::record::Params;
use crate::solids::shapes::facts::{Degenerate, Facts};
use crate::syntax::quote;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (shape, span) in context.scene.written_shapes() {
        if let Some(why) = shape.geometry.degenerate()
            && let Some(p) = context.params(span)
        {
            out.push(finding(shape, &p, &why));
        }
    }
}

fn finding(shape: &Shape, p: &Params, why: &Degenerate) -> Diagnostic {
    let (first, count) = why.params;
    let finding = Diagnostic::new(Code::W305, p.span_of(first, count))
        .case(why.case)
        .with("type", Value::Term(shape.ty().title))
        .with("id", shape.id.to_string());
    if why.equal.is_empty() {
        return finding;
    }
    let name = |i: usize| p.param(i).map_or("", |q| q.name);
    let half = p.len() / 2;
    let pairs: Vec<String> = (why.equal.iter())
        .map(|&i| format!("{} = {}", name(i), name(i + half)))
        .collect();
    let finding = finding
        .with("pairs", pairs.join(", "))
        .with("lower", name(first))
        .with("upper", name(first + half))
        .label(p.span_of(first + half, 1), "other");
    match lost_minus(p, why, half) {
        Some(fix) => finding.fix(fix),
        None => finding,
    }
}

/// One of two equal bounds has lost its minus: the lower one if both are above 0, else the upper one has one too many.
fn lost_minus(p: &Params, why: &Degenerate, half: usize) -> Option<Fix> {
    let &[low] = why.equal.as_slice() else {
        return None;
    };
    let at = match p.numbers::<1>(low) {
        [x] if x > 0.0 => low,
        [x] if x < 0.0 => low + half,
        _ => return None,
    };
    let text = p.text_of(at);
    let new = match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{}", text.trim_start_matches('+')),
    };
    let fix = Fix::replace(
        "fix-write",
        Applicability::Choice,
        p.span_of(at, 1),
        new.clone(),
    );
    Some(fix.with("number", quote(&new)))
}
