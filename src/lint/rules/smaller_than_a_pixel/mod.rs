//! W329: all that is drawn is smaller than a pixel.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::spelling::rough;
use crate::syntax::table::RecordKind;
use crate::trace::plan::unseen::view::{Parts, USUAL, out_of_view, pixels};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let bounds = context.bounds();
    let Some(render) = scene.render else { return };
    for (camera, p) in chosen_cameras(context) {
        let size = pixels(scene, bounds, render.root, camera);
        let Some(size) = size.filter(|s| *s < 1.0) else {
            continue;
        };
        // Another rule reports a scene that is out of view.
        if out_of_view(scene, bounds, render.root, camera, Parts::All).is_some() {
            continue;
        }
        let span = match p.ty.kind {
            RecordKind::Camera => p.span_of(0, p.len()),
            _ => p.span(),
        };
        out.push(
            Diagnostic::new(Code::W329, span)
                .with("id", camera.id.to_string())
                .with("size", Value::Decimal(rough(size)))
                .with("width", USUAL[0].to_string())
                .with("height", USUAL[1].to_string()),
        );
    }
}
