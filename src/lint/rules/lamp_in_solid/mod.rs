//! W326: a point light inside of something that lets no light through, or on its surface.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::buried_shape::mended::laid;
use crate::lint::signs::sign_that_frees;
use crate::scene::record::Params;
use crate::scene::{Entity, PointLight, Vec3};
use crate::syntax::Record;
use crate::syntax::quote;
use crate::syntax::table::{Family, Kind, RecordKind};
use crate::trace::plan::unseen::view::{Held, held as held_at};

/// Most lamps for which other signs are tried: each trial asks all parts of the scene again.
const MAX_TURNED: usize = 16;

/// The lamps that W326 reports, each with the solid that holds it.
fn within<'c>(context: &Context<'c>) -> Vec<(&'c PointLight, Held)> {
    let scene = context.scene;
    let Some(render) = scene.render else {
        return Vec::new();
    };
    let lamps = &scene.point_lights;
    let cameras = chosen_cameras(context);
    let places: Vec<Vec3> = (lamps.iter().map(|l| l.position))
        .chain(cameras.iter().map(|(c, _)| c.position))
        .collect();
    let holders = held_at(scene, context.bounds(), render.root, &places);
    let (holders, eyes) = holders.split_at(lamps.len());
    // A lamp that is inside of the same solid as a camera lights what this camera sees, and is meant to be there.
    let is_alone = |held: &Held| {
        let together =
            |eye: &Held| !held.on_surface && !eye.on_surface && eye.solid.span == held.solid.span;
        !eyes.iter().flatten().any(together)
    };
    let held = lamps.iter().zip(holders.iter().copied());
    held.filter_map(|(lamp, held)| Some((lamp, held.filter(is_alone)?)))
        .collect()
}

/// The spans of the solids that hold a lamp.
pub(super) fn solids(context: &Context) -> FxHashSet<Span> {
    let inside = within(context).into_iter().filter(|(_, h)| !h.on_surface);
    inside.map(|(_, held)| held.solid.span).collect()
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let all = within(context);
    if all.is_empty() {
        return;
    }
    let is_lamp = |e: &&Entity| e.kind == Some(Kind::PointLight);
    let places: FxHashMap<u32, Span> = (context.scene.entities.iter().filter(is_lamp))
        .map(|e| (e.id, e.span))
        .collect();
    let mut turns_left = MAX_TURNED;
    // Each floor is tried once.
    let mut floors: FxHashMap<Span, Option<Fix>> = FxHashMap::default();
    let mut moves: Option<FxHashMap<u32, Option<&Record>>> = None;
    for (lamp, held) in all {
        let Some(span) = places.get(&lamp.id) else {
            continue;
        };
        let finding = Diagnostic::new(Code::W326, *span)
            .case(if held.on_surface { "surface" } else { "" })
            .with("id", lamp.id.to_string())
            .with("solid", Value::Term(held.solid.title))
            .with("solid-id", held.solid.id.to_string())
            .label(held.solid.span, "solid");
        if lamp.position == [0.0; 3] {
            out.push(finding.note("lamp-at-origin"));
            continue;
        }
        let floor = match held.on_surface {
            true => None,
            false => {
                let floor = floors.entry(held.solid.span);
                floor.or_insert_with(|| laid(context, held.solid)).clone()
            }
        };
        let finding = floor.into_iter().fold(finding, Diagnostic::fix);
        let moved = moves.get_or_insert_with(|| only_moves(context));
        let moved = moved.get(&lamp.id).copied().flatten();
        let mirrored = moved
            .map(|record| context.record_params(record))
            .filter(|_| !held.on_surface && turns_left > 0)
            .and_then(|p| {
                turns_left -= 1;
                mirrored(context, lamp, &held, &p)
            });
        out.push(mirrored.into_iter().fold(finding, Diagnostic::fix));
    }
}

/// For each ID with transformations the only one, if it is a translation; `None` for other IDs.
fn only_moves<'c>(context: &'c Context) -> FxHashMap<u32, Option<&'c Record>> {
    let mut all = FxHashMap::default();
    let moves = |r: &&Record| r.ty().family == Family::Transformation;
    for record in context.records().filter(moves) {
        let is_first = !all.contains_key(&record.id);
        let only = Some(record).filter(|r| is_first && r.kind == RecordKind::Translation);
        all.insert(record.id, only);
    }
    all
}

/// The fix that gives one coordinate of a lamp's place the other sign. `None` unless exactly one coordinate frees the
/// lamp in this way.
fn mirrored(context: &Context, lamp: &PointLight, held: &Held, place: &Params) -> Option<Fix> {
    let (axis, number) = sign_that_frees(context, lamp.position, held, place)?;
    let all: Vec<&str> = (0..place.len())
        .map(|i| match i == axis {
            true => number.as_str(),
            false => place.text_of(i),
        })
        .collect();
    let all = quote(&all.join(" "));
    let span = place.span_of(axis, 1);
    let fix = Fix::replace("fix", Applicability::Unsafe, span, number.clone());
    Some(fix.with("number", all).with("axis", ["x", "y", "z"][axis]))
}
