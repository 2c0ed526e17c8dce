//! A colour that nothing needs as the background, where the render record has none.

use crate::diagnostics::{Applicability, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::background;
use crate::syntax::quote;

/// Says of unused colours, given by the place of their findings and their IDs, that the render record may name them. The
/// one that a comment calls the background is meant so; another one may be.
pub(super) fn add(context: &Context, colours: &[(usize, u32)], out: &mut [Diagnostic]) {
    let Some(render) = context.scene.render.filter(|_| !colours.is_empty()) else {
        return;
    };
    let Some(p) = context.params(render.span) else {
        return;
    };
    if p.number(1) != 0.0 {
        return;
    }
    let meant = background::meant(context.document, context.text, &context.scene.entities);
    for &(at, id) in colours {
        let finding = &mut out[at];
        finding.case = "colour";
        let text = format!("{} {} {} {id}", p.id, p.ty.code, p.text_of(0));
        finding.values.push(("text", quote(&text).into()));
        let Some(meant) = meant.as_ref().filter(|b| b.id == id) else {
            continue;
        };
        let span = p.span_of(1, 1);
        let mut fix = Fix::replace(
            "fix-background",
            Applicability::Choice,
            span,
            id.to_string(),
        );
        if meant.is_called_so {
            finding.fixes.clear();
            fix.applicability = Applicability::Unsafe;
        }
        finding.fixes.push(fix.with("text", quote(&text)));
    }
}
