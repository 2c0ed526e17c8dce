//! W341: a shape whose comment describes its numbers otherwise than they are read: a size for the bounds of a box or
//! rectangle, a diameter for the radius of a sphere, a radius that is not the sphere's last number, or the height and
//! radius of a cone in another order.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::sizes::{by_comment, cone_by_comment, sphere_by_comment};
use crate::syntax::table::ShapeKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    for (shape, span) in context.scene.written_shapes() {
        let check = match shape.kind {
            ShapeKind::Sphere | ShapeKind::SphereAtOrigin => sphere,
            ShapeKind::Box | ShapeKind::Rectangle => bounds,
            ShapeKind::Cone => cone,
            _ => continue,
        };
        out.extend(context.params(span).and_then(|p| check(&p)));
    }
}

fn sphere(p: &Params) -> Option<Diagnostic> {
    let (case, fix) = sphere_by_comment(p)?;
    let finding = Diagnostic::new(Code::W341, p.span_of(p.len() - 1, 1)).case(case);
    Some(finding.with("id", p.id.to_string()).fix(fix))
}

fn cone(p: &Params) -> Option<Diagnostic> {
    let fix = cone_by_comment(p)?;
    let finding = Diagnostic::new(Code::W341, p.span_of(0, 2)).case("cone");
    Some(finding.with("id", p.id.to_string()).fix(fix))
}

fn bounds(p: &Params) -> Option<Diagnostic> {
    let half = p.len() / 2;
    // W305 reports a shape that holds nothing.
    let is_flat = (0..half).any(|i| p.number(i) == p.number(i + half));
    let fixes = by_comment(p, half);
    let finding = Diagnostic::new(Code::W341, p.span_of(half, half))
        .with("type", Value::Term(p.ty.title))
        .with("id", p.id.to_string());
    let all = || fixes.into_iter().fold(finding, Diagnostic::fix);
    (!is_flat).then(all).filter(|d| !d.fixes.is_empty())
}
