//! W305: a shape without volume, or a surface without area.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::Shape;
use crate::scene::record::Params;
use crate::solids::shapes::facts::{Degenerate, Facts};

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
    finding
        .with("pairs", pairs.join(", "))
        .with("lower", name(first))
        .with("upper", name(first + half))
        .label(p.span_of(first + half, 1), "other")
}
