//! N602: the scene is framed automatically.

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::scene::View;
use crate::syntax::Item;
use crate::syntax::table::RecordKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    let contents = &context.document.contents;
    if !contents.broken && !contents.has(&[RecordKind::Camera, RecordKind::ProjectionMatrix]) {
        out.push(Diagnostic::new(Code::N602, render.span));
        return;
    }
    // A camera that could not be read is no reason to say there is none.
    let broken = |item: &Item| matches!(item, Item::Broken(b) if b.kind.is_none_or(|kind| matches!(kind, RecordKind::Camera | RecordKind::ProjectionMatrix)));
    if context.scene.view == View::Automatic
        && context.scene.cameras.is_empty()
        && !context.document.items.iter().any(broken)
        && !context
            .scene
            .entities
            .iter()
            .any(|e| e.kind == Some(crate::syntax::table::Kind::Camera))
    {
        out.push(Diagnostic::new(Code::N602, render.span));
    }
}
