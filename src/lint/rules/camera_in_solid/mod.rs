//! W325: a camera inside of something that lets no light through.

use std::cell::LazyCell;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::geometry::array::length;
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::buried_shape::mended::laid;
use crate::lint::rules::nothing_in_view::{LONGEST_WRITTEN, is_moved, sees, to_be_seen};
use crate::lint::signs::sign_that_frees;
use crate::lint::spelling::{decimal, opposite};
use crate::scene::record::Params;
use crate::scene::{Camera, NodeId, Scene, Vec3};
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::syntax::{Record, quote};
use crate::trace::plan::unseen::sides::Sides;
use crate::trace::plan::unseen::view::{Held, held};

/// The chosen cameras that are inside of an opaque solid, each with its record and the solid.
fn within<'c>(context: &'c Context) -> Vec<((&'c Camera, Params<'c>), Held)> {
    let scene = context.scene;
    let Some(render) = scene.render else {
        return Vec::new();
    };
    // The rays of a projection matrix do not start at the camera's position.
    let cameras: Vec<_> = (chosen_cameras(context).into_iter())
        .filter(|(camera, _)| camera.projection.is_none())
        .collect();
    let places: Vec<Vec3> = cameras.iter().map(|(c, _)| c.position).collect();
    let holders = held(scene, context.bounds(), render.root, &places);
    let inside = |held: Option<Held>| held.filter(|h| !h.on_surface);
    let both = cameras.into_iter().zip(holders);
    both.filter_map(|(camera, held)| Some((camera, inside(held)?)))
        .collect()
}

/// The IDs of the cameras that are inside of an opaque solid.
pub(super) fn cameras(context: &Context) -> FxHashSet<u32> {
    let all = within(context).into_iter();
    all.map(|((camera, _), _)| camera.id).collect()
}

/// The spans of the solids that hold a camera.
pub(super) fn solids(context: &Context) -> FxHashSet<Span> {
    let all = within(context).into_iter();
    all.map(|(_, held)| held.solid.span).collect()
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let scalings = LazyCell::new(|| scalings_in_per_cent(context));
    for ((camera, camera_record), held) in &within(context) {
        let finding = Diagnostic::new(Code::W325, camera_record.span_of(0, 3))
            .with("id", camera.id.to_string())
            .with("solid", Value::Term(held.solid.title))
            .with("solid-id", held.solid.id.to_string())
            .label(held.solid.span, "solid");
        let half_space = context
            .params(held.solid.span)
            .filter(|p| p.ty.kind == RecordKind::Shape(ShapeKind::HalfSpace));
        let mut finding = match half_space {
            Some(p) => {
                let sides = Sides::new(scene, context.bounds(), render.root, held.solid);
                match sides {
                    Some(sides) => beside(scene, finding, (camera, camera_record), (&p, &sides)),
                    None => finding.case("half-space"),
                }
            }
            None => match context.params(held.solid.span).filter(is_reversed) {
                Some(quadric) => finding.case("quadric").fix(turned(&quadric)),
                None => finding,
            },
        };
        let swapped = swapped(context, render.root, camera, camera_record);
        finding.fixes.splice(0..0, swapped);
        let laid = laid(context, held.solid);
        if laid.is_some() && finding.case == "half-space-kept" {
            finding.case = "half-space";
        }
        finding.fixes.splice(0..0, laid);
        let scaling = scalings.get(&held.solid.id);
        finding
            .fixes
            .splice(0..0, scaling.map(|scaling| from_per_cent(context, scaling)));
        if finding.fixes.is_empty() {
            let freed = freed(context, render.root, (camera, camera_record), held);
            finding.fixes.extend(freed);
        }
        out.push(finding);
    }
}

/// For each ID with a single scaling that scaling, if its factors look like per cent: whole numbers above 10.
fn scalings_in_per_cent<'c>(context: &'c Context) -> FxHashMap<u32, &'c Record> {
    /// Factors up to this one are meant as factors; larger ones may be per cent.
    const MIN_PER_CENT: f64 = 10.0;
    let is_per_cent = |x: f64| x > MIN_PER_CENT && x.fract() == 0.0;
    let mut all = FxHashMap::default();
    for record in context.records().filter(|r| r.kind == RecordKind::Scaling) {
        let factors: Vec3 = context.record_params(record).numbers(0);
        let is_one = factors.into_iter().all(is_per_cent) && !all.contains_key(&record.id);
        all.insert(record.id, is_one.then_some(record));
    }
    let all = all.into_iter();
    all.filter_map(|(id, record)| Some((id, record?))).collect()
}

/// The fix that divides the factors of a scaling by 100.
fn from_per_cent(context: &Context, scaling: &Record) -> Fix {
    let p = context.record_params(scaling);
    let factors: Vec3 = p.numbers(0);
    let parts = factors.map(|x| decimal(x / 100.0)).join(" ");
    let text = quote(&context.text[p.span().range()]);
    let span = p.span_of(0, 3);
    let fix = Fix::replace("fix-per-cent", Applicability::Choice, span, parts.clone());
    fix.with("text", text).with("number", quote(&parts))
}

/// The fix that gives one coordinate of the camera's position the other sign. `None` unless the camera is then outside
/// of the solid and sees something.
fn freed(
    context: &Context,
    root: NodeId,
    (camera, p): (&Camera, &Params),
    held: &Held,
) -> Option<Fix> {
    if p.ty.kind != RecordKind::Camera || is_moved(camera, p) {
        return None;
    }
    let (axis, number) = sign_that_frees(context, camera.position, held, p)?;
    let mut then = *camera;
    then.position[axis] = -then.position[axis];
    if !sees(
        context,
        root,
        &then,
        then.direction,
        to_be_seen(context, root),
    ) {
        return None;
    }
    let all = [0, 1, 2].map(|i| match i == axis {
        true => number.as_str(),
        false => p.text_of(i),
    });
    let all = quote(&all.join(" "));
    let span = p.span_of(axis, 1);
    let fix = Fix::replace(
        "fix-sign-of-place",
        Applicability::Unsafe,
        span,
        number.clone(),
    );
    Some(fix.with("number", all).with("axis", ["x", "y", "z"][axis]))
}

/// Whether all signs of a quadric seem to be reversed: no coefficient of x², y² or z² is positive and one is negative,
/// so that the inside lies around the shape that was meant.
fn is_reversed(p: &Params) -> bool {
    let squares = || [0, 5, 10].into_iter().map(|i| p.number(i));
    p.ty.kind == RecordKind::Shape(ShapeKind::Quadric)
        && squares().all(|x| x <= 0.0)
        && squares().any(|x| x < 0.0)
}

/// Adds the case, the numbers and the fixes to the finding about a half-space that holds the camera. A fix is left out
/// if the camera stays inside, or if more of the scene is buried.
fn beside(
    scene: &Scene,
    finding: Diagnostic,
    (camera, camera_record): (&Camera, &Params),
    (half_space, sides): (&Params, &Sides),
) -> Diagnostic {
    let now: [f64; 4] = half_space.numbers(0);
    // The number of lamps that the changed half-space holds in addition; `None` if the change does not help.
    let lamps = |then: [f64; 4]| {
        let is_worse = sides.holds(then, camera.position) || sides.would_bury(now, then);
        let lamps = scene.point_lights.iter();
        let lamps =
            lamps.filter(|l| sides.holds(then, l.position) && !sides.holds(now, l.position));
        (!is_worse).then(|| lamps.count())
    };
    let [a, b, c, d] = now;
    let is_turned = lamps([-a, -b, -c, -d]);
    let is_moved = lamps([a, b, c, -d]);
    let mut fixes = Vec::new();
    fixes.extend(is_turned.map(|_| turned(half_space)));
    let is_first = is_moved.is_some_and(|lamps| is_turned.is_none_or(|other| lamps < other));
    if is_moved.is_some() {
        fixes.insert(if is_first { 0 } else { fixes.len() }, moved(half_space));
    }
    let (case, fixes) = match laid_down(camera, camera_record, (now, sides)) {
        Some(fix) => ("z-up", vec![fix]),
        None if is_first => ("half-space-d", fixes),
        None if fixes.is_empty() => ("half-space-kept", fixes),
        None => ("half-space", fixes),
    };
    let plane = (0..3).find(|&i| (0..3).all(|j| (i == j) != (now[j] == 0.0)));
    let (case, axis) = match plane.filter(|_| sides.is_untouched) {
        Some(axis) => (case, axis),
        None if case == "half-space-d" => ("half-space-sign", 0),
        None => (case, 0),
    };
    let at = |d: f64| Value::Decimal(decimal(-d / now[axis]));
    let finding = (finding.case(case))
        .with("axis", ["x", "y", "z"][axis])
        .with("d", Value::Decimal(decimal(d)))
        .with("at", at(d))
        .with("other-d", Value::Decimal(decimal(-d)))
        .with("other-at", at(-d));
    fixes.into_iter().fold(finding, Diagnostic::fix)
}

/// The fix that exchanges the camera's position and direction. `None` unless the direction looks like a place and the
/// position like a direction, and the camera is then outside of all solids and sees something.
fn swapped(context: &Context, root: NodeId, camera: &Camera, p: &Params) -> Option<Fix> {
    let then = Camera {
        position: camera.direction,
        direction: camera.position,
        ..*camera
    };
    let is_written = p.ty.kind == RecordKind::Camera && !is_moved(camera, p);
    let [way, place] = [then.direction, then.position].map(length);
    if !is_written || way > LONGEST_WRITTEN || place <= LONGEST_WRITTEN {
        return None;
    }
    let parts = to_be_seen(context, root);
    let holders = held(context.scene, context.bounds(), root, &[then.position]);
    if holders.iter().any(Option::is_some) || !sees(context, root, &then, then.direction, parts) {
        return None;
    }
    let texts = [3, 4, 5, 0, 1, 2].map(|i| p.text_of(i));
    let edits = texts.iter().enumerate().map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text: (*text).to_owned(),
    });
    let fix = Fix {
        applicability: Applicability::Choice,
        ..Fix::guess("fix-place-and-view", edits.collect())
    };
    Some(fix.with("number", quote(&texts.join(" "))))
}

/// The fix that turns a camera with the z axis up into one with the y axis up. `None` unless the camera is in a floor
/// across the y axis, and is then outside of it.
fn laid_down(camera: &Camera, p: &Params, (floor, sides): ([f64; 4], &Sides)) -> Option<Fix> {
    let written: [Vec3; 3] = [p.numbers(0), p.numbers(3), p.numbers(6)];
    let is_written = p.ty.kind == RecordKind::Camera
        && written == [camera.position, camera.direction, camera.up];
    let is_floor = sides.is_untouched && floor[0] == 0.0 && floor[2] == 0.0 && floor[1] > 0.0;
    let [x, y, up] = camera.up;
    let [px, py, pz] = camera.position;
    let is_out = !sides.holds(floor, [px, pz, -py]);
    if !is_written || !is_floor || [x, y] != [0.0; 2] || up <= 0.0 || !is_out {
        return None;
    }
    let texts = (0..3).flat_map(|vector| {
        let at = 3 * vector;
        [
            p.text_of(at).to_owned(),
            p.text_of(at + 2).to_owned(),
            opposite(p, at + 1),
        ]
    });
    let edits = texts.enumerate().map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    Some(Fix::guess("fix", edits.collect()))
}

/// The fix that gives all numbers of a half-space or quadric the other sign, so that its inside becomes its outside.
fn turned(half_space: &Params) -> Fix {
    written(half_space, "fix-turn", |i| opposite(half_space, i))
}

/// The fix that gives d of a half-space or plane the other sign.
pub(super) fn moved(half_space: &Params) -> Fix {
    written(half_space, "fix-move", |i| match i {
        3 => opposite(half_space, i),
        _ => half_space.text_of(i).to_owned(),
    })
}

fn written(half_space: &Params, title: &'static str, text: impl Fn(usize) -> String) -> Fix {
    let all: Vec<String> = (0..half_space.len()).map(text).collect();
    let all = all.join(" ");
    let span = half_space.span_of(0, half_space.len());
    let fix = Fix::replace(title, Applicability::Choice, span, all.clone());
    fix.with("number", quote(&all))
}
