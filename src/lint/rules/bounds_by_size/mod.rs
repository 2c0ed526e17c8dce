//! W341: a box or a rectangle whose comment speaks of a size, and a sphere whose comment gives a radius or a diameter, as
//! their numbers are not read.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::sizes::{by_comment, sphere_by_comment};
use crate::syntax::table::ShapeKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    for (shape, span) in (context.scene.written_shapes())
        .filter(|(s, _)| matches!(s.kind, ShapeKind::Sphere | ShapeKind::SphereAtOrigin))
    {
        let Some(p) = context.params(span) else {
            continue;
        };
        if let Some((case, fix)) = sphere_by_comment(&p) {
            out.push(
                Diagnostic::new(Code::W341, p.span_of(p.len() - 1, 1))
                    .case(case)
                    .with("id", shape.id.to_string())
                    .fix(fix),
            );
        }
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
        let fixes = by_comment(&p, half);
        if !fixes.is_empty() && !is_flat {
            let finding = Diagnostic::new(Code::W341, p.span_of(half, half))
                .with("type", Value::Term(shape.ty().title))
                .with("id", shape.id.to_string());
            out.push(fixes.into_iter().fold(finding, Diagnostic::fix));
        }
    }
}
