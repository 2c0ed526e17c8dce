//! W324: all that is drawn lies behind the camera, or beside what it sees.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::geometry::array::{cross, length, sub, unit};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::angle_in_radians;
use crate::lint::spelling::near;
use crate::scene::record::Params;
use crate::scene::{Camera, NodeId};
use crate::syntax::table::RecordKind;
use crate::trace::plan::unseen::view::{Side, USUAL, out_of_view};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    for (camera, p) in chosen_cameras(context) {
        // Of an angle of view that looks like radians another rule speaks.
        if angle_in_radians::meant(context, camera, &p).is_some() {
            continue;
        }
        let Some(side) = out_of_view(scene, context.bounds(), render.root, camera) else {
            continue;
        };
        let is_written = p.ty.kind == RecordKind::Camera;
        let span = match is_written {
            true => p.span_of(3, 3),
            false => p.span(),
        };
        let d = Diagnostic::new(Code::W324, span)
            .with("id", camera.id.to_string())
            .with("where", name(side))
            .with("width", USUAL[0].to_string())
            .with("height", USUAL[1].to_string());
        out.push(
            match is_written
                .then(|| towards(context, render.root, camera, &p))
                .flatten()
            {
                Some(fix) => d.fix(fix),
                None => d,
            },
        );
    }
}

fn name(side: Side) -> &'static str {
    match side {
        Side::Behind => "behind",
        Side::Left => "left",
        Side::Right => "right",
        Side::Above => "above",
        Side::Below => "below",
        Side::Beside => "beside",
    }
}

/// A fix that turns the camera to the middle of what is drawn and ends. `None` where something moves the camera, or the
/// up vector would then be along the direction.
fn towards(context: &Context, root: NodeId, camera: &Camera, p: &Params) -> Option<Fix> {
    /// The least sine between direction and up.
    const UPRIGHT: f64 = 0.01;
    let all = context.bounds()[root as usize].bounded();
    if p.numbers(0) != camera.position || p.numbers(3) != camera.direction || !all.is_bounded() {
        return None;
    }
    let way = sub(all.centre(), camera.position);
    let sine = length(cross(unit(way)?, unit(camera.up)?));
    let turned = Camera {
        direction: way,
        ..*camera
    };
    if sine < UPRIGHT || out_of_view(context.scene, context.bounds(), root, &turned).is_some() {
        return None;
    }
    let edits = (0..3).map(|i| Edit {
        span: p.span_of(3 + i, 1),
        text: near(way[i], length(way)),
    });
    Some(Fix {
        title: "fix",
        values: Vec::new(),
        applicability: Applicability::Unsafe,
        edits: edits.collect(),
    })
}
