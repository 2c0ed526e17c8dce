//! W326: a point light inside of something that lets no light through, or on its surface.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::scene::{Entity, Vec3};
use crate::syntax::table::Kind;
use crate::trace::plan::unseen::view::{Held, held};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let lamps = &scene.point_lights;
    let cameras = chosen_cameras(context);
    let places: Vec<Vec3> = (lamps.iter().map(|l| l.position))
        .chain(cameras.iter().map(|(c, _)| c.position))
        .collect();
    let holders = held(scene, context.bounds(), render.root, &places);
    let (holders, eyes) = holders.split_at(lamps.len());
    if holders.iter().all(Option::is_none) {
        return;
    }
    let is_lamp = |e: &&Entity| e.kind == Some(Kind::PointLight);
    let places: FxHashMap<u32, Span> = (scene.entities.iter().filter(is_lamp))
        .map(|e| (e.id, e.span))
        .collect();
    for (lamp, held) in lamps.iter().zip(holders) {
        let Some(held) = held else { continue };
        // It lights what a camera sees that is inside of the same thing.
        let together =
            |eye: &Held| !held.on_surface && !eye.on_surface && eye.solid.span == held.solid.span;
        if eyes.iter().flatten().any(together) {
            continue;
        }
        let Some(span) = places.get(&lamp.id) else {
            continue;
        };
        let finding = Diagnostic::new(Code::W326, *span)
            .case(if held.on_surface { "surface" } else { "" })
            .with("id", lamp.id.to_string())
            .with("solid", Value::Term(held.solid.title))
            .with("solid-id", held.solid.id.to_string())
            .label(held.solid.span, "solid");
        out.push(match lamp.position == [0.0; 3] {
            true => finding.note("lamp-at-origin"),
            false => finding,
        });
    }
}
