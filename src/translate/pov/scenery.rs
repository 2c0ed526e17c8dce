//! Lights, and the two scales of the export.

use super::camera::Eye;
use super::text::{rgb, vector};
use crate::scene::bounds::NodeBounds;
use crate::scene::frame::{headlight, seen_box};
use crate::scene::{Optics, Render, Rgb, Scene};

/// The point lights, one a line; where there is no light at all, a headlight for each camera.
pub fn point_lights(scene: &Scene, eyes: &[Eye]) -> String {
    let mut out = String::new();
    for light in &scene.point_lights {
        out.push_str(&format!(
            "light_source {{ {}, {}*Light_Scale scale Unit }} // {}\n",
            vector(&light.position),
            rgb(light.colour.map(|c| c * light.intensity)),
            light.id
        ));
    }
    for (eye, switch) in eyes.iter().zip(["Eye = 0", "Eye = 1"]) {
        let Some(light) = headlight(scene, &eye.camera) else {
            continue;
        };
        let text = format!(
            "light_source {{ {}, rgb 1*Light_Scale scale Unit }} // the scene has no light\n",
            vector(&light.position)
        );
        out.push_str(&if eyes.len() > 1 {
            format!("#if ({switch})\n  {text}#end\n")
        } else {
            text
        });
    }
    out
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

/// The size that the scene is scaled to. Shadow rays overlook what is closer than 1e-3, and nothing
/// is seen beyond 1e7: these are 1/32 000 and 300 000 of the scene.
const SIZE: f64 = 32.0;

/// The power of two that brings the scene to about that size: tolerances are absolute there.
pub fn unit(scene: &Scene, bounds: &[NodeBounds], eyes: &[Eye]) -> f64 {
    let seen = seen_box(scene, bounds);
    let size = if seen.is_empty() {
        let distance = |e: &Eye| (e.camera.position.iter()).fold(0.0f64, |m, x| m.max(x.abs()));
        eyes.iter().map(distance).fold(0.0, f64::max)
    } else {
        seen.radius()
    };
    power_of_two_about(SIZE / size)
}

/// The largest power of two that is not above `x`; 1 for a number without one.
fn power_of_two_about(x: f64) -> f64 {
    let exponent = x.log2().floor();
    if exponent.abs() <= 900.0 {
        2f64.powi(exponent as i32)
    } else {
        1.0
    }
}

/// Lights are dimmed by at most this: a 16-bit file keeps eight bits then.
const DIMMEST: f64 = 1.0 / 256.0;

/// The power of two that keeps every value below 1. It follows from the recursion of the light:
/// one more bounce on a surface shows at most kd·(all light) + (ks + kt)·(what was seen before).
pub fn light_scale<'a>(
    scene: &Scene,
    render: &Render,
    eyes: &[Eye],
    optics: impl Iterator<Item = &'a Optics> + Clone,
    depth: u32,
) -> f64 {
    let mut light = ambient(scene);
    let head = eyes.first().and_then(|e| headlight(scene, &e.camera));
    for point in scene.point_lights.iter().chain(head.as_ref()) {
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
