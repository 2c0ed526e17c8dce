//! W328: a camera whose up vector is nearly along its view direction; a note on a camera that takes another axis for up
//! in a scene where y is up.

mod floor;

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Severity, Value};
use crate::geometry::array::{cross, length, unit};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::spelling::spelled;
use crate::scene::record::Params;
use crate::scene::{Camera, Vec3};
use crate::solids::staging::Basis;
use crate::syntax::table::RecordKind;
use floor::Way;

/// The sine of the angle between up vector and direction below which nobody has chosen the angle.
const SINE: f64 = 1e-3;
/// The up vector of most cameras.
const UP: Vec3 = [0.0, 1.0, 0.0];
/// The picture counts as turned if the cosine of the angle in it between its own way up and that of the scene is at
/// most this.
const TURNED: f64 = 0.5;
/// A camera that looks up or down by more than this sine may have another way up.
const LEVEL: f64 = 0.7;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (camera, p) in chosen_cameras(context) {
        let (Some(direction), Some(up)) = (unit(camera.direction), unit(camera.up)) else {
            continue;
        };
        let sine = length(cross(direction, up));
        if sine >= SINE {
            out.extend(turned(context, camera, &p));
            continue;
        }
        if p.ty.kind != RecordKind::Camera {
            continue;
        }
        let d = Diagnostic::new(Code::W328, p.span_of(3, 6))
            .with("id", camera.id.to_string())
            .with(
                "angle",
                Value::Decimal(format!("{:.1e}", sine.asin().to_degrees())),
            );
        out.push(match upright(camera, &p) {
            Some(fix) => d.fix(fix),
            None => d,
        });
    }
}

/// The fix that writes the picture's own way up, with two decimals, as the up vector. `None` if something turns the
/// camera.
fn upright(camera: &Camera, p: &Params) -> Option<Fix> {
    let written: [Vec3; 2] = [p.numbers(3), p.numbers(6)];
    if written != [camera.direction, camera.up] {
        return None;
    }
    let up = Basis::of(camera)?.up.map(|x| (x * 100.0).round() / 100.0);
    Some(
        Fix {
            title: "fix",
            values: Vec::new(),
            applicability: Applicability::Unsafe,
            edits: (0..3)
                .map(|i| Edit {
                    span: p.span_of(6 + i, 1),
                    text: spelled(up[i]),
                })
                .collect(),
        }
        .with("up", up.map(spelled).join(" ")),
    )
}

/// The note on a camera whose up vector points along another axis than +y, although the scene stands on a floor
/// perpendicular to the y axis.
fn turned(context: &Context, camera: &Camera, p: &Params) -> Option<Diagnostic> {
    let render = context.scene.render?;
    let written: [Vec3; 2] = [p.numbers(3), p.numbers(6)];
    let is_written = p.ty.kind == RecordKind::Camera && written == [camera.direction, camera.up];
    if !is_written || context.has_broken() {
        return None;
    }
    let way = Way::along(camera.up)?;
    let [_, sine, _] = unit(camera.direction)?;
    let [_, up, _] = Basis::of(camera)?.up;
    if sine.abs() > LEVEL || up > TURNED * (1.0 - sine * sine).sqrt() {
        return None;
    }
    let floor = floor::floor(context, render.root, way)?;
    let above = |place: Vec3| place[1] > floor;
    let lamps = &context.scene.point_lights;
    if lamps.is_empty() || !lamps.iter().all(|l| above(l.position)) || !above(camera.position) {
        return None;
    }
    let edits = (0..3).map(|i| Edit {
        span: p.span_of(6 + i, 1),
        text: spelled(UP[i]),
    });
    let d = Diagnostic::new(Code::W328, p.span_of(6, 3));
    let d = d.case(if way.axis == 1 {
        "upside-down"
    } else {
        "turned"
    });
    let d = d.severity(Severity::Note).with("id", camera.id.to_string());
    let d = d.with("axis", way.name());
    Some(d.fix(Fix::guess("fix", edits.collect())))
}
