//! N606: a part of the picture is brighter than white.

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::geometry::array::add;
use crate::lint::Context;
use crate::lint::glance::{MAX_NODES, SIZE, glance};
use crate::lint::spelling::decimal;
use crate::scene::{Entity, Geometry, Optics, Paint, Render, Rgb, Scene, Shape, Texture};
use crate::solids::staging::{Viewpoint, staged};
use crate::syntax::quote;
use crate::syntax::table::{Family, Kind};
use crate::trace::Images;
use crate::trace::film::{MAX_BRIGHT_PERCENT, is_above_white};
use std::ops::ControlFlow;

/// Most mirrors and panes on a path of light: more add nothing that matters.
const DEPTH: u32 = 4;

/// Least number of bright pixels for a finding: fewer may be chance where few pixels are examined.
const MIN_BRIGHT: usize = 4;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(render) = context.scene.render else {
        return;
    };
    if context.scene.nodes.len() > MAX_NODES || !is_overlit(context.scene, &render) {
        return;
    }
    let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
    let scene = staged(context.scene, Viewpoint::Scene, aspect);
    let Some(images) = images(context) else {
        return;
    };
    let most = scene.chosen_cameras().filter_map(|camera| {
        let (mut looked, mut bright) = (0_u32, 0_usize);
        // Where the whole picture takes too long, some pixels of it must do.
        let _ = glance(&scene, &images, camera, DEPTH, |pixels, x, y| {
            looked += 1;
            bright += usize::from(is_above_white(pixels.sum(x, y, 0..1, 1)));
            ControlFlow::Continue(())
        });
        let share = 100.0 * bright as f64 / f64::from(looked.max(1));
        (bright >= MIN_BRIGHT && share >= MAX_BRIGHT_PERCENT).then_some(share)
    });
    let Some(percent) = most.max_by(f64::total_cmp) else {
        return;
    };
    let percent = format!("{percent:.0}");
    let mut diagnostic = Diagnostic::new(Code::N606, render.span).with("percent", percent);
    if let Some(light) = brightest(context.scene) {
        let kind = light.kind.map_or("light", Kind::name);
        diagnostic = (diagnostic.with("light", Value::Term(kind)))
            .with("id", light.id.to_string())
            .label(light.span, "light");
        diagnostic.fixes.extend(of_per_cent(context, light));
    }
    out.push(diagnostic);
}

/// Most bytes of pictures on surfaces, once they are decoded, for which the pictures are read.
const MAX_IMAGE_BYTES: u64 = 16 << 20;

/// The pictures on the scene's surfaces; `None` if they cannot be read, or are larger than [`MAX_IMAGE_BYTES`].
fn images(context: &Context) -> Option<Images> {
    if Images::files(context.scene).is_empty() {
        return Some(Images::default());
    }
    Images::load_within(context.scene, context.folder?, MAX_IMAGE_BYTES).ok()
}

/// The fix that divides the intensity of a light by 100. `None` unless the intensity is from 10 to 100, which seems to
/// be per cent.
fn of_per_cent(context: &Context, light: &Entity) -> Option<Fix> {
    const INTENSITY: usize = 0;
    // A copy has no intensity of its own.
    let p = context
        .params(light.span)
        .filter(|p| p.ty.family == Family::Light)?;
    let written: f64 = p.text_of(INTENSITY).parse().ok()?;
    let text = (10.0..=100.0)
        .contains(&written)
        .then(|| decimal(written / 100.0))?;
    let place = p.span_of(INTENSITY, 1);
    let fix = Fix::replace("fix-write", Applicability::Unsafe, place, text.clone());
    Some(fix.with("number", quote(&text)))
}

/// The light of the greatest intensity.
fn brightest(scene: &Scene) -> Option<&Entity> {
    let ambient = scene.ambient_lights.iter().map(|l| (l.id, l.intensity));
    let points = scene.point_lights.iter().map(|l| (l.id, l.intensity));
    let (id, _) = ambient.chain(points).max_by(|a, b| a.1.total_cmp(&b.1))?;
    scene.entities.iter().find(|e| e.id == id)
}

/// Whether all lights together, or the background, are brighter than white, and no surface gives out more light than it
/// gets, which W301 and W302 report. Most scenes are not overlit, and need no picture.
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
