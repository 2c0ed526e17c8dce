//! N608: a small object outside of the picture, where another reading of one coordinate, with the other sign or a
//! decimal point, would bring the object into the picture. Where something mirrors or lets light through, only an object
//! that is much farther away than all others.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::geometry::array::{add, length, sub};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::rules::nothing_in_view::name;
use crate::lint::spelling::opposite;
use crate::scene::record::Params;
use crate::scene::{Node, Vec3};
use crate::solids::named_core;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::syntax::{quote, tenth};
use crate::trace::plan::unseen::view::USUAL;
use crate::trace::plan::unseen::views::{Aside, Views};

/// Most nodes of a scene for which the rule runs.
const MAX_NODES: usize = 200_000;
/// Most objects outside of the picture for which the rule runs: more of them are there on purpose.
const MAX_ASIDE: usize = 4;
/// Least number of objects in the picture for each object outside of it.
const MIN_WITHIN_PER_ASIDE: usize = 2;
/// Least ratio of the distance of an object from the middle of the others to the largest of theirs, where the object may
/// be seen in a mirror or through glass.
const MIN_DISTANCE_RATIO: f64 = 3.0;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    if scene.nodes.len() > MAX_NODES {
        return;
    }
    let Some(views) = Views::new(scene, context.bounds(), render.root) else {
        return;
    };
    let count = views.aside.len();
    if count > MAX_ASIDE || views.within.len() < MIN_WITHIN_PER_ASIDE * count {
        return;
    }
    let picture = views.within.iter().fold(Aabb::EMPTY, |all, b| all.hull(b));
    let reach = match scene.has_mirrors_or_glass() {
        true => {
            let corners = views.within.iter().flat_map(|b| [b.min, b.max]);
            let far = corners.map(|place| length(sub(place, picture.centre())));
            MIN_DISTANCE_RATIO * far.fold(0.0, f64::max)
        }
        false => 0.0,
    };
    let is_far = |part: &Aside| length(sub(part.bounds.centre(), picture.centre())) >= reach;
    for part in views.aside.iter().filter(|part| is_far(part)) {
        // An object as large as all the others together is a wall or a floor.
        if part.bounds.radius() < picture.radius() {
            out.extend(finding(context, &views, part));
        }
    }
}

/// The finding about an object outside of the picture; `None` if no other reading brings the object into the picture.
fn finding(context: &Context, views: &Views, part: &Aside) -> Option<Diagnostic> {
    let (object, _) = named_core(context.scene, part.node)?;
    let readings: Vec<(Span, Fix)> = places(context, part)
        .iter()
        .flat_map(|(p, map)| readings(views, part, p, map))
        .collect();
    let (span, _) = *readings.first()?;
    let finding = Diagnostic::new(Code::N608, span)
        .with("object", Value::Term(object.title))
        .with("object-id", object.id.to_string())
        .with("camera", views.camera.to_string())
        .with("where", name(part.side))
        .with("width", USUAL[0].to_string())
        .with("height", USUAL[1].to_string());
    let fixes = readings.into_iter().map(|(_, fix)| fix);
    Some(fixes.fold(finding, Diagnostic::fix))
}

/// The records of an object whose first three numbers are a place (translations and a sphere), each with the map from
/// the record's coordinates into those of the scene. The list ends at a copy: the records below it are about its
/// original.
fn places<'c>(context: &'c Context, part: &Aside) -> Vec<(Params<'c>, Matrix)> {
    let scene = context.scene;
    let mut out = Vec::new();
    // More than the object's own transformations moves it, so its records do not say where it is.
    if scene.core(part.node, Matrix::IDENTITY).1 != part.moved {
        return out;
    }
    let mut map = Matrix::IDENTITY;
    for (id, node) in scene.states(part.node) {
        let kind = match node {
            Node::Transform { .. } => RecordKind::Translation,
            Node::Shape(_) => RecordKind::Shape(ShapeKind::Sphere),
            Node::Paint { .. } => continue,
            _ => break,
        };
        let record = context.params(scene.origins[id as usize].span);
        out.extend(record.filter(|p| p.ty.kind == kind).map(|p| (p, map)));
        if let Node::Transform { matrix, .. } = node {
            map = map.after(&scene.matrices[matrix as usize]);
        }
    }
    out
}

/// The other readings of a place that bring the object into the picture, each with the span of the place and the fix:
/// one coordinate has a decimal point before its last digit, or the other sign.
fn readings(views: &Views, part: &Aside, p: &Params, map: &Matrix) -> Vec<(Span, Fix)> {
    let middle = |axis: usize, then: f64| {
        let mut by: Vec3 = [0.0; 3];
        by[axis] = then - p.number(axis);
        add(part.bounds.centre(), map.vector(by), 1.0)
    };
    let is_taken = |place: Vec3| views.within.iter().any(|b| b.contains(place));
    // An object at the mirrored place makes a pair with this one, so the sign is meant.
    if (0..3).any(|i| p.number(i) != 0.0 && is_taken(middle(i, -p.number(i)))) {
        return Vec::new();
    }
    let brings = |axis: usize, then: f64| {
        let place = middle(axis, then);
        views.shows(place) && !is_taken(place)
    };
    let fix = |axis: usize, title: &'static str, text: String| {
        let span = p.span_of(axis, 1);
        let fix = Fix::replace(title, Applicability::Choice, span, text.clone());
        (p.span_of(0, 3), fix.with("number", quote(&text)))
    };
    let mut out = Vec::new();
    for axis in 0..3 {
        let number = p.number(axis);
        let is_long = number.abs() >= 10.0;
        let text = tenth(p.text_of(axis)).filter(|_| is_long && brings(axis, number / 10.0));
        out.extend(text.map(|text| fix(axis, "fix-decimal", text)));
        if number != 0.0 && brings(axis, -number) {
            out.push(fix(axis, "fix-sign", opposite(p, axis)));
        }
    }
    out
}
