//! W341: a box or a rectangle whose comment speaks of a centre or a corner and a size, as its numbers are not read.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::sizes::by_comment;
use crate::syntax::table::ShapeKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    let shapes = context.scene.written_shapes();
    for (shape, span) in
        shapes.filter(|(s, _)| matches!(s.kind, ShapeKind::Box | ShapeKind::Rectangle))
    {
        let Some(p) = context.params(span) else {
            continue;
        };
        let half = p.len() / 2;
        // Of what holds nothing W305 speaks.
        let is_flat = (0..half).any(|i| p.number(i) == p.number(i + half));
        if let Some(fix) = by_comment(&p, half).filter(|_| !is_flat) {
            out.push(
                Diagnostic::new(Code::W341, p.span_of(half, half))
                    .with("type", Value::Term(shape.ty().title))
                    .with("id", shape.id.to_string())
                    .fix(fix),
            );
        }
    }
}
