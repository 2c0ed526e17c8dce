//! W328: a camera whose up vector is nearly along its view direction.

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix};
use crate::geometry::array::{cross, length, unit};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::lint::spelling::spelled;
use crate::scene::record::Params;
use crate::scene::{Camera, Vec3};
use crate::solids::staging::Basis;
use crate::syntax::table::RecordKind;

/// The sine of the angle between the two below which nobody has chosen it.
const SINE: f64 = 1e-3;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (camera, p) in chosen_cameras(context) {
        let (Some(direction), Some(up)) = (unit(camera.direction), unit(camera.up)) else {
            continue;
        };
        let sine = length(cross(direction, up));
        if sine >= SINE || p.ty.kind != RecordKind::Camera {
            continue;
        }
        let d = Diagnostic::new(Code::W328, p.span_of(3, 6))
            .with("id", camera.id.to_string())
            .with("angle", format!("{:.1e}", sine.asin().to_degrees()));
        out.push(match upright(camera, &p) {
            Some(fix) => d.fix(fix),
            None => d,
        });
    }
}

/// A fix that has the same way up in the picture, but for the digits that are left out.
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
