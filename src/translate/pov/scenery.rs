//! Lights.

use super::frame::power_of_two_about;
use super::tree::Light;
use crate::scene::{NodeId, Optics, PointLight, Render, Rgb, Scene};
use crate::solids::bounds::NodeBounds;
use crate::syntax::Captions;
use crate::trace::plan::unseen::view::on_surfaces;

/// The point lights.
pub fn point_lights(scene: &Scene, captions: &Captions) -> Vec<Light> {
    let light = |light: &PointLight| Light {
        caption: captions.entity(light.id),
        position: light.position,
        colour: light.colour,
        intensity: light.intensity,
    };
    scene.point_lights.iter().map(light).collect()
}

/// Whether any lamp lies on a surface.
pub fn is_lit_from_surface(scene: &Scene, bounds: &[NodeBounds], root: NodeId) -> bool {
    let places: Vec<_> = scene.point_lights.iter().map(|l| l.position).collect();
    on_surfaces(scene, bounds, root, &places).contains(&true)
}

/// The sum of the ambient lights.
pub fn ambient(scene: &Scene) -> Rgb {
    let mut sum = [0.0; 3];
    for light in &scene.ambient_lights {
        for (s, c) in sum.iter_mut().zip(light.colour) {
            *s += light.intensity * c;
        }
    }
    sum
}

/// Lights are dimmed by at most this: a 16-bit file keeps eight bits then.
const DIMMEST: f64 = 1.0 / 256.0;

/// The power of two that keeps every value below 1. It follows from the recursion of the light:
/// one more bounce on a surface shows at most kd·(all light) + (ks + kt)·(what was seen before).
pub fn light_scale<'a>(
    scene: &Scene,
    render: &Render,
    optics: impl Iterator<Item = &'a Optics> + Clone,
    depth: u32,
) -> f64 {
    let mut light = ambient(scene);
    for point in &scene.point_lights {
        for (s, c) in light.iter_mut().zip(point.colour) {
            *s += point.intensity * c;
        }
    }
    let mut brightest = 0.0f64;
    for (c, light) in light.iter().enumerate() {
        let background = render.background[c];
        let mut seen = background;
        for _ in 0..=depth {
            let bounce = |o: &Optics| o.kd[c] * light + (o.ks[c] + o.kt[c]) * seen;
            seen = optics.clone().map(bounce).fold(background, f64::max);
        }
        brightest = brightest.max(seen);
    }
    if brightest > 1.0 {
        power_of_two_about(1.0 / brightest).max(DIMMEST)
    } else {
        1.0
    }
}
