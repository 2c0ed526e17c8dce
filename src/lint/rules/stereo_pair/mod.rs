//! W338: a pair of cameras for a stereo picture that makes none: one camera for both eyes, two cameras with one view,
//! the eyes exchanged, or a selection below that overrides the pair.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::geometry::array::{dot, sub, unit};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Camera, View};
use crate::solids::staging::Basis;
use crate::syntax::table::RecordKind;
use crate::syntax::{Record, quote};

/// Least cosine of the angle between the views of a pair of eyes, and of that between the picture's left and the way
/// from the left eye to the right one if the eyes are swapped: some 45 degrees.
const EYES_COS: f64 = 0.7;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let is_selection =
        |r: &&Record| matches!(r.kind, RecordKind::MonoCamera | RecordKind::StereoCamera);
    let selections = context.records().filter(is_selection);
    let mut selections: Vec<&Record> = selections.collect();
    let Some(last) = selections.pop() else {
        return;
    };
    if let (RecordKind::MonoCamera, Some(pair)) = (last.kind, selections.last())
        && pair.kind == RecordKind::StereoCamera
    {
        out.push(overridden(context, pair, last));
    }
    if let View::Stereo { left, right } = context.scene.view
        && last.kind == RecordKind::StereoCamera
    {
        let cameras = &context.scene.cameras;
        let p = context.record_params(last);
        out.extend(pair(context, &p, &cameras[left], &cameras[right]));
    }
}

/// The finding about a pair that a single camera below it overrides.
fn overridden(context: &Context, pair: &Record, last: &Record) -> Diagnostic {
    let p = context.record_params(pair);
    let d = Diagnostic::new(Code::W338, p.span())
        .case("overridden")
        .with("id", p.id.to_string())
        .with("other", last.id.to_string())
        .label(context.record_params(last).span(), "second");
    match context.take_out(last, "fix", Applicability::Choice) {
        Some(fix) => d.fix(fix),
        None => d,
    }
}

/// The finding about the pair that takes the picture.
fn pair(context: &Context, p: &Params, left: &Camera, right: &Camera) -> Option<Diagnostic> {
    if left.id == right.id {
        return Some(one_camera(context, p, left));
    }
    let (case, fixes) = match sides(left, right) {
        _ if is_same(left, right) => ("same", Vec::new()),
        Some(side) if side < -EYES_COS => ("swapped", vec![swapped(p)]),
        _ => return None,
    };
    let mut d = Diagnostic::new(Code::W338, p.span())
        .case(case)
        .with("left", left.id.to_string())
        .with("right", right.id.to_string());
    d.fixes = fixes;
    Some(d)
}

/// The finding about a single camera for both eyes. If there is exactly one other camera, the fix names it.
fn one_camera(context: &Context, p: &Params, camera: &Camera) -> Diagnostic {
    let d = Diagnostic::new(Code::W338, p.span()).with("id", camera.id.to_string());
    let mut others = context.scene.cameras.iter().filter(|c| c.id != camera.id);
    match (others.next(), others.next()) {
        (Some(other), None) => {
            let id = other.id.to_string();
            let fix = Fix::replace("fix", Applicability::Unsafe, p.span_of(1, 1), id.clone());
            d.fix(fix.with("number", quote(&id)))
        }
        _ => d,
    }
}

/// Whether two cameras show the same picture. `false` if one has a projection matrix.
fn is_same(left: &Camera, right: &Camera) -> bool {
    left.position == right.position
        && unit(left.direction) == unit(right.direction)
        && left.projection.is_none()
        && right.projection.is_none()
}

/// The cosine of the angle between the way from the left eye to the right one and the right of the picture; `None` if
/// the two are no pair of eyes, or if a matrix may turn the picture around.
fn sides(left: &Camera, right: &Camera) -> Option<f64> {
    let [left_basis, right_basis] = [Basis::of(left)?, Basis::of(right)?];
    let is_pair = dot(left_basis.forward, right_basis.forward) > EYES_COS
        && dot(left_basis.up, right_basis.up) > EYES_COS;
    let is_plain = left.projection.is_none() && right.projection.is_none();
    let way = unit(sub(right.position, left.position)).filter(|_| is_pair && is_plain)?;
    let [one, other] = [dot(way, left_basis.right), dot(way, right_basis.right)];
    Some(if one < 0.0 {
        one.max(other)
    } else {
        one.min(other)
    })
}

/// The fix that gives each eye the other's camera.
fn swapped(p: &Params) -> Fix {
    let [left, right] = [0, 1].map(|i| p.text_of(i).to_owned());
    let number = quote(&format!("{right} {left}"));
    let edits = [(0, right), (1, left)].map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    Fix::guess("fix", edits.into()).with("number", number)
}
