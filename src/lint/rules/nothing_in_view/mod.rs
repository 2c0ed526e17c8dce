//! W324: all that is drawn lies behind the camera, or beside what it sees.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::array::{cross, length, sub, unit};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::angle_in_radians;
use crate::lint::spelling::{decimal, near};
use crate::scene::record::Params;
use crate::scene::{Camera, NodeId, Vec3};
use crate::syntax::quote;
use crate::syntax::table::RecordKind;
use crate::trace::plan::unseen::view::{OutOfView, Parts, USUAL, out_of_view};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    for (camera, p) in chosen_cameras(context) {
        // Of an angle of view that looks like radians another rule speaks.
        if angle_in_radians::meant(context, camera, &p).is_some() {
            continue;
        }
        let is_written = p.ty.kind == RecordKind::Camera;
        let seen = |of| out_of_view(scene, context.bounds(), render.root, camera, of);
        let Some(side) = seen(Parts::All) else {
            // A floor without end is seen from almost everywhere.
            let bounded = is_written && seen(Parts::Bounded).is_some();
            let meant =
                bounded.then(|| turned_to_point(context, render.root, camera, &p, Parts::Bounded));
            out.extend(meant.flatten().map(|fix| {
                Diagnostic::new(Code::W324, p.span_of(3, 3))
                    .case("unbounded")
                    .with("id", camera.id.to_string())
                    .with("width", USUAL[0].to_string())
                    .with("height", USUAL[1].to_string())
                    .fix(fix)
            }));
            continue;
        };
        let span = match is_written {
            true => p.span_of(3, 3),
            false => p.span(),
        };
        let d = Diagnostic::new(Code::W324, span)
            .with("id", camera.id.to_string())
            .with("where", name(side))
            .with("width", USUAL[0].to_string())
            .with("height", USUAL[1].to_string());
        let fixes = match is_written {
            true => turned(context, render.root, camera, &p),
            false => Vec::new(),
        };
        out.push(fixes.into_iter().fold(d, Diagnostic::fix));
    }
}

fn name(side: OutOfView) -> &'static str {
    match side {
        OutOfView::Behind => "behind",
        OutOfView::Left => "left",
        OutOfView::Right => "right",
        OutOfView::Above => "above",
        OutOfView::Below => "below",
        OutOfView::Beside => "beside",
    }
}

/// Fixes that turn the camera to what is drawn: to the point that the direction is meant as, and to the middle. None
/// where something moves the camera.
fn turned(context: &Context, root: NodeId, camera: &Camera, p: &Params) -> Vec<Fix> {
    if is_moved(camera, p) {
        return Vec::new();
    }
    let mut fixes = Vec::from_iter(turned_to_point(context, root, camera, p, Parts::All));
    fixes.extend(with_sign(context, root, camera, p));
    let all = context.bounds()[root as usize].bounded();
    let way = sub(all.centre(), camera.position);
    if all.is_bounded() && sees(context, root, camera, way, Parts::All) {
        let numbers = way.map(|x| near(x, length(way)));
        let other = fix("fix", Vec::new(), numbers, p);
        fixes.extend((fixes.iter().all(|f| f.edits != other.edits)).then_some(other));
    }
    fixes
}

/// The fix that gives the longest part of the direction the other sign, if the camera sees something then.
fn with_sign(context: &Context, root: NodeId, camera: &Camera, p: &Params) -> Option<Fix> {
    let way = camera.direction;
    let longest = (0..3).max_by(|&i, &j| way[i].abs().total_cmp(&way[j].abs()))?;
    let other = std::array::from_fn(|i| if i == longest { -way[i] } else { way[i] });
    let text = |i: usize| match (i == longest, p.text_of(3 + i).strip_prefix('-')) {
        (true, Some(rest)) => rest.to_owned(),
        (true, None) => format!("-{}", p.text_of(3 + i).trim_start_matches('+')),
        (false, _) => p.text_of(3 + i).to_owned(),
    };
    let numbers = [0, 1, 2].map(text);
    let values = vec![("number", quote(&numbers.join(" ")).into())];
    let sees = sees(context, root, camera, other, Parts::All);
    sees.then(|| fix("fix-sign", values, numbers, p))
}

/// The fix that turns the camera to the point that the direction is meant as, if it sees some of these parts then.
fn turned_to_point(
    context: &Context,
    root: NodeId,
    camera: &Camera,
    p: &Params,
    of: Parts,
) -> Option<Fix> {
    let way = sub(camera.direction, camera.position);
    if is_moved(camera, p) || !sees(context, root, camera, way, of) {
        return None;
    }
    let numbers = way.map(decimal);
    let written = (3..6).map(|i| p.text_of(i)).collect::<Vec<_>>().join(" ");
    let values = vec![
        ("text", quote(&written).into()),
        ("number", quote(&numbers.join(" ")).into()),
    ];
    Some(fix("fix-point", values, numbers, p))
}

/// Whether something moves the camera away from what its record says.
fn is_moved(camera: &Camera, p: &Params) -> bool {
    p.numbers(0) != camera.position || p.numbers(3) != camera.direction
}

/// A fix that writes another direction.
fn fix(
    title: &'static str,
    values: Vec<(&'static str, Value)>,
    numbers: [String; 3],
    p: &Params,
) -> Fix {
    let edits = (3..).zip(numbers).map(|(i, text)| Edit {
        span: p.span_of(i, 1),
        text,
    });
    Fix {
        title,
        values,
        applicability: Applicability::Unsafe,
        edits: edits.collect(),
    }
}

/// Whether the camera would see some of these parts if it looked this way. The up vector must not be along it.
fn sees(context: &Context, root: NodeId, camera: &Camera, way: Vec3, of: Parts) -> bool {
    /// The least sine between direction and up.
    const UPRIGHT: f64 = 0.01;
    let (Some(direction), Some(up)) = (unit(way), unit(camera.up)) else {
        return false;
    };
    let turned = Camera {
        direction: way,
        ..*camera
    };
    length(cross(direction, up)) >= UPRIGHT
        && out_of_view(context.scene, context.bounds(), root, &turned, of).is_none()
}
