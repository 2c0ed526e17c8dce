//! W330: a camera sees objects, and no light falls on any of them.
//!
//! Mirrors and glass leave no bounds for what is lit, so the rule looks at a small picture.

use crate::diagnostics::{Code, Diagnostic};
use crate::lint::Context;
use crate::lint::glance::{MAX_NODES, SIZE, glance, without_images};
use crate::lint::records::chosen_cameras;
use crate::lint::rules::{camera_in_solid, lamp_in_solid};
use crate::scene::{AmbientLight, Camera, Scene};
use crate::syntax::table::Kind;
use crate::trace::Images;
use std::ops::ControlFlow;

/// Most mirrors and panes on a path of light: a surface lit by more is as good as black.
const DEPTH: u32 = 4;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let is_dark = |light: &AmbientLight| light.intensity == 0.0 || light.colour == [0.0; 3];
    if scene.nodes.len() > MAX_NODES || !scene.ambient_lights.iter().all(is_dark) {
        return;
    }
    let is_lamp = |id: u32| scene.point_lights.iter().any(|light| light.id == id);
    let lamp = (scene.entities.iter())
        .find(|e| e.kind == Some(Kind::PointLight) && is_lamp(e.id))
        .map(|e| e.span);
    let Some(lamp) = lamp else { return };
    let plain = without_images(scene);
    let scene = plain.as_ref();
    for (camera, p) in chosen_cameras(context) {
        if is_lit(scene, camera) != Some(false) {
            continue;
        }
        // No lamp is to blame if all that the camera sees is black even under an ambient light.
        let mut bright = scene.clone();
        bright.ambient_lights.push(AmbientLight {
            id: 0,
            intensity: 1.0,
            colour: [1.0; 3],
        });
        if is_lit(&bright, camera) != Some(true) {
            continue;
        }
        if is_shut_in(context) {
            return;
        }
        out.push(
            Diagnostic::new(Code::W330, lamp)
                .with("id", camera.id.to_string())
                .with("width", SIZE[0].to_string())
                .with("height", SIZE[1].to_string())
                .label(p.span(), "camera"),
        );
    }
}

/// Whether a camera or every lamp is inside of a solid, which other rules report.
fn is_shut_in(context: &Context) -> bool {
    let (mut cameras, mut lights) = (Vec::new(), Vec::new());
    camera_in_solid::check(context, &mut cameras);
    lamp_in_solid::check(context, &mut lights);
    !cameras.is_empty() || lights.len() == context.scene.point_lights.len()
}

/// Whether light comes from any object in a small picture. `None` if no object is seen, or the picture cannot be taken
/// or takes too long.
fn is_lit(scene: &Scene, camera: &Camera) -> Option<bool> {
    let mut lit = None;
    glance(scene, &Images::default(), camera, DEPTH, |pixels, x, y| {
        if pixels.seen(x, y).is_some() {
            lit = Some(pixels.sum(x, y, 0..1, 1) != [0.0; 3]);
        }
        match lit {
            Some(true) => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    })?;
    lit
}
