//! A camera whose comment speaks of the point to look at, where its numbers are a direction.

use crate::diagnostics::{Code, Diagnostic};
use crate::geometry::Aabb;
use crate::geometry::array::{dot, length, sub, unit};
use crate::geometry::line::Line;
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::rules::nothing_in_view::{
    AIMED_AT_MIDDLE, LONGEST_WRITTEN, is_moved, sees, to_be_seen, turned_to_point,
};
use crate::lint::rules::{angle_in_radians, camera_in_solid};
use crate::scene::target::{Target, target_by_comment};
use crate::scene::{Camera, Vec3};
use crate::syntax::table::RecordKind;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    for (camera, p) in chosen_cameras(context) {
        if p.ty.kind != RecordKind::Camera || is_moved(camera, &p) {
            continue;
        }
        let Some(said) = target_by_comment(&p) else {
            continue;
        };
        let ended = context.bounds()[render.root as usize].bounded();
        // Of a camera that sees nothing W324 speaks.
        let of = to_be_seen(context, render.root);
        let sees = |way| sees(context, render.root, camera, way, of);
        if !is_point(camera, said, &ended) || !sees(camera.direction) {
            continue;
        }
        let Some(fix) = turned_to_point(camera, &p, sees) else {
            continue;
        };
        // Other rules report an angle of view that looks like radians, and a camera in a solid.
        if angle_in_radians::meant(context, camera, &p).is_some()
            || camera_in_solid::cameras(context).contains(&camera.id)
        {
            continue;
        }
        let finding = Diagnostic::new(Code::W344, p.span_of(3, 3)).case("target");
        out.push(finding.with("id", camera.id.to_string()).fix(fix));
    }
}

/// Whether the direction is rather the point to look at, and as a direction does not lead there. Where the comment gives
/// no coordinates, only the point leads to the bounded objects, and is too long for a direction as people write it.
fn is_point(camera: &Camera, said: Target, ended: &Aabb) -> bool {
    let way = sub(camera.direction, camera.position);
    let (Some(written), Some(meant)) = (unit(camera.direction), unit(way)) else {
        return false;
    };
    let meets = |way: Vec3| {
        let line = Line::new(camera.position.into(), way.into());
        ended.clip(&line, 0.0, f64::INFINITY).is_some()
    };
    let is_named = || length(camera.direction) > LONGEST_WRITTEN && !meets(written) && meets(meant);
    dot(written, meant) < AIMED_AT_MIDDLE && (matches!(said, Target::Point(_)) || is_named())
}
