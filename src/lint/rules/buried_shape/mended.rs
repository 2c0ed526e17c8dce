//! Fixes of a half-space that swallows objects, or of a plane that hides them.

use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::geometry::array::{length, sub};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::{PLACE_REL_GAP, camera_in_solid::moved};
use crate::lint::spelling::opposite;
use crate::scene::record::Params;
use crate::scene::{Node, NodeId, Vec3, transformation};
use crate::solids::Named;
use crate::solids::shapes::facts::Facts;
use crate::syntax::Record;
use crate::syntax::quote;
use crate::syntax::table::{Family, RecordKind, ShapeKind};
use crate::syntax::words::FLOOR;
use crate::trace::plan::unseen::sides::{Sides, placed};

/// Beginnings of words for a table, without accents.
const TABLE: [&str; 2] = ["table", "stul"];
/// Most transformations of an object for which another order is tried.
const MAX_TRANSFORMATIONS: usize = 8;

/// Returns the case of the finding and the fixes, for a half-space that holds `parts`. The case is `None` unless the
/// first fix exchanges two transformations of the object.
pub(super) fn mended(
    context: &Context,
    half_space: (Named, &Params),
    parts: &[(Named, NodeId)],
) -> (Option<&'static str>, Vec<Fix>) {
    let scene = context.scene;
    let (solid, p) = half_space;
    let Some(root) = scene.render.map(|r| r.root) else {
        return (None, Vec::new());
    };
    let Some(sides) = Sides::new(scene, context.bounds(), root, solid) else {
        return (None, Vec::new());
    };
    let now: [f64; 4] = p.numbers(0);
    let mut fixes = Vec::new();
    let mut case = None;
    if let [(part, node)] = *parts {
        let order = in_other_order(context, part, node, (now, &sides));
        case = order.is_some().then_some("half-space-order");
        fixes.extend(order);
    }
    let frees = |then: [f64; 4]| frees(context, &sides, then);
    fixes.extend(
        (laid_down(p, now, &sides).or_else(|| with_normal_up(p, now, &sides)))
            .filter(|(then, _)| frees(*then))
            .map(|(_, fix)| fix),
    );
    let [a, b, c, d] = now;
    if d != 0.0 && frees([a, b, c, -d]) {
        fixes.push(moved(p));
    }
    (case, fixes)
}

/// Whether a half-space with these numbers holds nothing that is drawn, no camera and no lamp.
fn frees(context: &Context, sides: &Sides, then: [f64; 4]) -> bool {
    let cameras = chosen_cameras(context).into_iter().map(|(c, _)| c.position);
    let lamps = context.scene.point_lights.iter().map(|l| l.position);
    !sides.buries(then) && !cameras.chain(lamps).any(|place| sides.holds(then, place))
}

/// The fix of a half-space that its comment calls a floor, but that stands upright or fills all above a height. `None`
/// for any other half-space, or if the fixed one still holds a part, a camera or a lamp.
pub(in crate::lint::rules) fn laid(context: &Context, solid: Named) -> Option<Fix> {
    let scene = context.scene;
    let own = RecordKind::Shape(ShapeKind::HalfSpace);
    let p = (context.params(solid.span)).filter(|p| p.id == solid.id && p.ty.kind == own)?;
    let sides = Sides::new(scene, context.bounds(), scene.render?.root, solid)?;
    let now = p.numbers(0);
    let laid = laid_down(&p, now, &sides).or_else(|| with_normal_up(&p, now, &sides));
    let (_, fix) = laid.filter(|(then, _)| frees(context, &sides, *then))?;
    Some(fix)
}

/// The fixes of a plane that hides parts from all cameras. A fix is left out if the fixed plane hides a part, or a lamp
/// that is not hidden now.
pub(super) fn plane(context: &Context, (name, p): (Named, &Params)) -> Vec<Fix> {
    let scene = context.scene;
    let sides =
        (scene.render).and_then(|render| Sides::new(scene, context.bounds(), render.root, name));
    let Some(sides) = sides else {
        return Vec::new();
    };
    let now: [f64; 4] = p.numbers(0);
    let eyes: Vec<Vec3> = scene.cameras.iter().map(|c| c.position).collect();
    let is_dark = |numbers, lamp: Vec3| sides.is_between(numbers, &eyes, &Aabb::new(lamp, lamp));
    let frees = |then: [f64; 4]| {
        let mut lamps = scene.point_lights.iter().map(|l| l.position);
        !sides.hides(then, &eyes) && !lamps.any(|l| is_dark(then, l) && !is_dark(now, l))
    };
    let mut fixes = Vec::new();
    let laid = laid_down(p, now, &sides);
    fixes.extend(laid.filter(|(then, _)| frees(*then)).map(|(_, fix)| fix));
    let [a, b, c, d] = now;
    if d != 0.0 && frees([a, b, c, -d]) {
        fixes.push(moved(p));
    }
    fixes
}

/// Whether the comment of a half-space or plane calls it a floor or a table.
fn is_floor(p: &Params) -> bool {
    p.is_called(&FLOOR) || p.is_called(&TABLE)
}

/// Lays down an upright half-space or plane that its comment calls a floor. Returns the new a, b, c and d, with the
/// normal along y, and the fix. `None` for any other shape.
fn laid_down(p: &Params, now: [f64; 4], sides: &Sides) -> Option<([f64; 4], Fix)> {
    let axis = (0..3).find(|&i| (0..3).all(|j| (i == j) == (now[j] != 0.0)))?;
    if axis == 1 || !sides.is_untouched || !is_floor(p) {
        return None;
    }
    let up = match now[axis] < 0.0 {
        true => opposite(p, axis),
        false => p.text_of(axis).to_owned(),
    };
    let normal = format!("0 {up} 0");
    let fix = Fix::replace(
        "fix-lay",
        Applicability::Unsafe,
        p.span_of(0, 3),
        normal.clone(),
    );
    let fix = fix.with("number", quote(&normal));
    Some(([0.0, now[axis].abs(), 0.0, now[3]], fix))
}

/// Turns up the normal of a half-space that its comment calls a floor, but that fills all above a height y > 0. Returns
/// the new a, b, c and d, and the fix. The surface then lies below the origin, lower than that of the half-space turned
/// round. `None` for any other half-space.
fn with_normal_up(p: &Params, now: [f64; 4], sides: &Sides) -> Option<([f64; 4], Fix)> {
    let [a, b, c, d] = now;
    let is_above = [a, c] == [0.0; 2] && b < 0.0 && d > 0.0;
    let [x, y, z, _] = sides.in_scene(now);
    let is_level = [x, z] == [0.0; 2] && y < 0.0;
    if !is_above || !is_level || !is_floor(p) {
        return None;
    }
    let up = opposite(p, 1);
    let all = [p.text_of(0), &up, p.text_of(2), p.text_of(3)].join(" ");
    let fix = Fix::replace(
        "fix-normal-sign",
        Applicability::Unsafe,
        p.span_of(1, 1),
        up,
    );
    Some(([a, -b, c, d], fix.with("number", quote(&all))))
}

/// The fix that exchanges a rotation of an object with a translation above it. A rotation is about the origin, so the
/// exchange moves the object. `None` unless the middle of the object is then outside of the half-space.
fn in_other_order(
    context: &Context,
    part: Named,
    node: NodeId,
    (now, sides): ([f64; 4], &Sides),
) -> Option<Fix> {
    let scene = context.scene;
    let (core, _) = scene.core(node, Matrix::IDENTITY);
    let Node::Shape(shape) = scene.nodes[core as usize] else {
        return None;
    };
    let geometry = &scene.shapes[shape as usize].geometry;
    let moves = |r: &&Record| r.id == part.id && r.ty().family == Family::Transformation;
    let chain: Vec<Params> = (context.records().filter(moves))
        .take(MAX_TRANSFORMATIONS + 1)
        .map(|r| context.record_params(r))
        .collect();
    if chain.len() > MAX_TRANSFORMATIONS {
        return None;
    }
    let matrix = |p: &Params| transformation(p, &mut Vec::new());
    let matrices: Vec<Matrix> = chain.iter().map(matrix).collect::<Option<_>>()?;
    let bounds = |order: &[usize]| {
        let all = order.iter().map(|&i| &matrices[i]);
        geometry.bounds(&all.fold(Matrix::IDENTITY, |before, m| m.after(&before)))
    };
    let mut order: Vec<usize> = (0..chain.len()).collect();
    // The fix is right only if these records alone move the object.
    let place = placed(scene, context.bounds(), scene.render?.root, node)?;
    let (now_at, by_records) = (geometry.bounds(&place), bounds(&order));
    let apart = length(sub(now_at.centre(), by_records.centre()));
    if !now_at.is_bounded() || apart > PLACE_REL_GAP * now_at.far() {
        return None;
    }
    let is = |i: usize, kind: RecordKind| chain[i].ty.kind == kind;
    // Records next to each other are tried first.
    let pairs = (1..chain.len()).flat_map(|by| (by..chain.len()).map(move |i| (i - by, i)));
    for (early, late) in pairs {
        if !is(late, RecordKind::Rotation) || !is(early, RecordKind::Translation) {
            continue;
        }
        order.swap(late, early);
        let then = bounds(&order);
        if then.is_bounded() && !sides.holds(now, then.centre()) {
            let [rotation, translation] = [late, early].map(|i| chain[i].span());
            let text = |span: Span| context.text[span.range()].to_owned();
            let edits = [(translation, rotation), (rotation, translation)];
            let edits = edits.map(|(span, other)| Edit {
                span,
                text: text(other),
            });
            return Some(Fix {
                applicability: Applicability::Choice,
                ..Fix::guess("fix-order", edits.into())
            });
        }
        order.swap(late, early);
    }
    None
}
