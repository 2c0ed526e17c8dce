//! W325: a camera inside of something that lets no light through.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::scene::Vec3;
use crate::trace::plan::unseen::view::held;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    // The rays of a projection matrix start elsewhere.
    let cameras: Vec<_> = (chosen_cameras(context).into_iter())
        .filter(|(camera, _)| camera.projection.is_none())
        .collect();
    let places: Vec<Vec3> = cameras.iter().map(|(c, _)| c.position).collect();
    let holders = held(scene, context.bounds(), render.root, &places);
    for ((camera, p), held) in cameras.iter().zip(holders) {
        let Some(held) = held.filter(|h| !h.on_surface) else {
            continue;
        };
        out.push(
            Diagnostic::new(Code::W325, p.span_of(0, 3))
                .with("id", camera.id.to_string())
                .with("solid", Value::Term(held.solid.title))
                .with("solid-id", held.solid.id.to_string())
                .label(held.solid.span, "solid"),
        );
    }
}
