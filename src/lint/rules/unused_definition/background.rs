//! An unused colour as the background of a render record that has none.

use crate::diagnostics::{Applicability, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::background;
use crate::syntax::quote;

/// Adds to the findings about unused colours that the render record may name them. `colours` are the indices of the
/// findings in `out`, each with the ID of its colour. A colour that a comment calls the background is surely meant so;
/// another one may be.
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
