//! W325: a camera inside of something that lets no light through.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::scene::Vec3;
use crate::scene::record::Params;
use crate::syntax::quote;
use crate::syntax::table::{RecordKind, ShapeKind};
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
        let finding = Diagnostic::new(Code::W325, p.span_of(0, 3))
            .with("id", camera.id.to_string())
            .with("solid", Value::Term(held.solid.title))
            .with("solid-id", held.solid.id.to_string())
            .label(held.solid.span, "solid");
        let half_space = context
            .params(held.solid.span)
            .filter(|p| p.ty.kind == RecordKind::Shape(ShapeKind::HalfSpace));
        out.push(match half_space {
            Some(p) => finding.case("half-space").fix(turned(&p)),
            None => finding,
        });
    }
}

/// The half-space on the other side of its boundary.
fn turned(half_space: &Params) -> Fix {
    let text = |i: usize| match half_space.text_of(i) {
        text if half_space.number(i) == 0.0 => text.to_owned(),
        text => match text.strip_prefix('-') {
            Some(rest) => rest.to_owned(),
            None => format!("-{}", text.trim_start_matches('+')),
        },
    };
    let all: Vec<String> = (0..half_space.len()).map(text).collect();
    let all = all.join(" ");
    let span = half_space.span_of(0, half_space.len());
    let fix = Fix::replace("fix-turn", Applicability::Choice, span, all.clone());
    fix.with("number", quote(&all))
}
