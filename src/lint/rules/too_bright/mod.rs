//! N606: a part of the picture is brighter than white.

use crate::diagnostics::{Code, Diagnostic};
use crate::geometry::array::add;
use crate::lint::Context;
use crate::lint::glance::{MAX_NODES, SIZE, glance};
use crate::scene::{Geometry, Optics, Paint, Render, Rgb, Scene, Shape, Texture};
use crate::solids::staging::{Viewpoint, staged};
use crate::trace::film::{MAX_BRIGHT_PERCENT, is_above_white};
use std::ops::ControlFlow;

/// Most mirrors and panes on a path of light: more add nothing that matters.
const DEPTH: u32 = 4;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    if context.scene.nodes.len() > MAX_NODES || !is_overlit(context.scene, &render) {
        return;
    }
    let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
    let scene = staged(context.scene, Viewpoint::Scene, aspect);
    let pixels = (SIZE[0] * SIZE[1]) as usize;
    let most = scene.chosen_cameras().filter_map(|camera| {
        let mut bright = vec![false; pixels];
        glance(&scene, camera, DEPTH, |pixels, x, y| {
            let colour = pixels.sum(x, y, 0..1, 1);
            bright[(y * SIZE[0] + x) as usize] = is_above_white(colour);
            ControlFlow::Continue(())
        })?;
        Some(bright.iter().filter(|&&bright| bright).count())
    });
    let Some(bright) = most
        .max()
        .filter(|&n| 100.0 * n as f64 >= MAX_BRIGHT_PERCENT * pixels as f64)
    else {
        return;
    };
    let percent = (100 * bright + pixels / 2) / pixels;
    let diagnostic = Diagnostic::new(Code::N606, render.span);
    out.push(diagnostic.with("percent", percent.to_string()));
}

/// Whether all lights together, or the background, are brighter than white, and no surface gives out more than it gets:
/// of that W301 and W302 speak. Most scenes are not overlit, and need no picture.
fn is_overlit(scene: &Scene, render: &Render) -> bool {
    let is_white_at_most = |c: Rgb| c.iter().all(|&x| x <= 1.0);
    let ambient = scene.ambient_lights.iter().map(|l| (l.intensity, l.colour));
    let points = scene.point_lights.iter().map(|l| (l.intensity, l.colour));
    let sum = (ambient.chain(points)).fold([0.0; 3], |sum, (intensity, colour)| {
        add(sum, colour, intensity)
    });
    let paint = |paint: &Paint| {
        let colours = match &paint.texture {
            Some(Texture::Colour(colour)) => is_white_at_most(*colour),
            Some(Texture::Checkerboard { colours, .. } | Texture::Solid { colours, .. }) => {
                colours.iter().all(|&c| is_white_at_most(c))
            }
            Some(Texture::Image { .. }) | None => true,
        };
        let all = |o: Optics| is_white_at_most(add(add(o.kd, o.ks, 1.0), o.kt, 1.0));
        colours && paint.optics.is_none_or(all)
    };
    let shape = |shape: &Shape| match &shape.geometry {
        Geometry::Revolution { colours, .. } => colours.iter().all(|&c| is_white_at_most(c)),
        _ => true,
    };
    let is_bright = !is_white_at_most(sum) || !is_white_at_most(render.background);
    is_bright && scene.paints.iter().all(paint) && scene.shapes.iter().all(shape)
}
