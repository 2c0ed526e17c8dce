//! N603: a headlight shines where there is no light.

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::syntax::Item;
use crate::syntax::table::Kind;

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    let scene = context.scene;
    let light = |k: Option<Kind>| matches!(k, Some(Kind::AmbientLight | Kind::PointLight));
    let broken = |item: &Item| matches!(item, Item::Broken(b) if b.ty.is_none_or(|t| matches!(t.code, -401 | -402)));
    if scene.ambient_lights.is_empty()
        && scene.point_lights.is_empty()
        && !scene.entities.iter().any(|e| light(e.kind))
        && !context.document.items.iter().any(broken)
    {
        out.push(Diagnostic::new(Code::N603, render.span));
    }
}
