//! W316: several cameras, and nothing that says which one takes the picture.

use crate::diagnostics::{Applicability, Code, Diagnostic, Value};
use crate::lint::Context;
use crate::scene::{Entity, View};
use crate::syntax::Item;
use crate::syntax::table::{Kind, RecordKind};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let cameras = &context.scene.cameras;
    let View::Mono(used) = context.scene.view else {
        return;
    };
    // A selection counts even where it could not be read.
    let selects = |item: &Item| match item {
        Item::Record(r) => matches!(r.kind, RecordKind::MonoCamera | RecordKind::StereoCamera),
        Item::Broken(b) => b
            .kind
            .is_none_or(|kind| matches!(kind, RecordKind::MonoCamera | RecordKind::StereoCamera)),
        Item::Void { .. } => false,
    };
    if cameras.len() < 2 || context.document.items.iter().any(selects) {
        return;
    }
    let place = |id: u32| {
        let is_camera = |e: &&Entity| e.id == id && e.kind == Some(Kind::Camera);
        context.scene.entities.iter().rev().find(is_camera)
    };
    let (used, first) = (cameras[used].id, cameras[0].id);
    let (Some(camera), Some(other)) = (place(used), place(first)) else {
        return;
    };
    let d = Diagnostic::new(Code::W316, camera.span)
        .with("count", Value::Count(cameras.len() as u64))
        .with("id", used.to_string())
        .with("other", first.to_string())
        .label(other.span, "unused");
    // The picture stays the same, but only its author knows whether it is the right one.
    let selection = (context.params(camera.span).zip(context.free_id())).map(|(p, id)| {
        let line = format!("{id} -502 {used}");
        context.add_behind(p.span(), "fix", Applicability::Unsafe, &[line])
    });
    out.push(match selection {
        Some(fix) => d.fix(fix),
        None => d,
    });
}
