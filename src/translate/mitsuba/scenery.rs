//! Cameras, lights and the integrator.

use std::f64::consts::PI;
use std::fmt::Write as _;

use super::frame::SceneFrame;
use super::options::{Integrator, Options};
use super::xml::{rgb, transform, vector};
use crate::diagnostics::Error;
use crate::geometry::{Aabb, Matrix};
use crate::scene::{Camera, Scene};
use crate::solids::staging::Basis;
use crate::translate::about_camera;
use crate::translate::lens::{Lens, Pinhole};
use crate::translate::number;

/// Samples a pixel of a path-traced picture.
const SAMPLES: u32 = 64;

/// The distance that shapes without end reach, in radii of a box around the scene, its cameras and the origin. The
/// horizon is then less than a pixel below where it should be.
const HORIZON: f64 = 1e3;

/// The distance that shapes without end reach from the middle of the region.
pub(super) fn reach(region: &Aabb, cameras: &[Camera]) -> f64 {
    let all = cameras.iter().fold(*region, |all, c| {
        all.hull(&Aabb::new(c.position, c.position))
    });
    let origin = Aabb::new([0.0; 3], [0.0; 3]);
    HORIZON * all.hull(&origin).radius()
}

/// The distance of a near plane from the camera at which it hides nothing, as a fraction of the scene's size.
const NEAR_PLANE_SIZES: f64 = 1e-7;
/// The distance of a near plane from the camera at which it hides nothing, as a fraction of the distance to the nearest
/// surface that is seen.
const NEAR_PLANE_SHARE: f64 = 1e-3;

/// The integrator and the camera. `all` is a box around everything that is drawn, `nearest` the distance to the nearest
/// surface that is seen, and `reach` the distance that shapes without end reach.
pub(super) fn view(
    scene: &Scene,
    camera: &Camera,
    all: &Aabb,
    nearest: f64,
    reach: f64,
    options: &Options,
) -> Result<String, Error> {
    let nowhere = || Error::scene(about_camera(camera, "camera-nowhere"));
    let basis = Basis::of(camera).ok_or_else(nowhere)?;
    let (sensor, near) = sensor(camera, &basis, options.size).ok_or_else(nowhere)?;
    let integrator = match options.integrator {
        Integrator::Path => format!(
            "  <integrator type=\"path\">\n    <integer name=\"max_depth\" value=\"{}\"/>\n    \
             <boolean name=\"hide_emitters\" value=\"{}\"/>\n  </integrator>\n",
            options.depth.saturating_add(2).min(i32::MAX as u32),
            environment(scene).is_none_or(|e| e.hidden),
        ),
        Integrator::Aov => "  <integrator type=\"aov\">\n    <string name=\"aovs\" \
             value=\"position:position,normal:sh_normal,shape:shape_index\"/>\n  </integrator>\n"
            .to_owned(),
    };
    let sampler = match options.integrator {
        Integrator::Path => format!(
            "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"{SAMPLES}\"/></sampler>"
        ),
        Integrator::Aov => {
            "<sampler type=\"stratified\"><integer name=\"sample_count\" value=\"1\"/>\
             <boolean name=\"jitter\" value=\"false\"/></sampler>"
                .to_owned()
        }
    };
    // The distance must be more than 0, also as a number of single precision.
    let close = (NEAR_PLANE_SHARE * nearest)
        .min(NEAR_PLANE_SIZES * reach / HORIZON)
        .max(1e-30);
    let start = || before(all, camera, &basis).max(close);
    let (width, height) = options.size;
    Ok(format!(
        "{integrator}{sensor}    <float name=\"near_clip\" value=\"{}\"/>\n    \
         <float name=\"far_clip\" value=\"{}\"/>\n    \
         {sampler}\n    <film type=\"hdrfilm\">\n      <integer name=\"width\" value=\"{width}\"/>\n      \
         <integer name=\"height\" value=\"{height}\"/>\n      <rfilter type=\"box\"/>\n      \
         <string name=\"pixel_format\" value=\"rgb\"/>\n      \
         <string name=\"component_format\" value=\"float32\"/>\n    </film>\n  </sensor>\n",
        number(near.unwrap_or_else(start)),
        number(reach * 10.0),
    ))
}

/// The distance along the camera's axis at which rays start: halfway to the nearest corner of `all`, since single
/// precision is less exact far from the start of a ray. 0 if there is no such corner, or the camera has a projection
/// matrix.
fn before(all: &Aabb, camera: &Camera, basis: &Basis) -> f64 {
    let depth = |i: usize| {
        let ends = [all.min[i], all.max[i]].map(|x| basis.forward[i] * (x - camera.position[i]));
        ends[0].min(ends[1])
    };
    let nearest = depth(0) + depth(1) + depth(2);
    match nearest.is_finite() && camera.projection.is_none() {
        true => (nearest / 2.0).max(0.0),
        false => 0.0,
    }
}

/// The beginning of a sensor, with its place and its field of view; and the distance of the near plane, if a projection
/// matrix gives one. `None` if the camera is no lens.
fn sensor(
    camera: &Camera,
    basis: &Basis,
    (width, height): (u32, u32),
) -> Option<(String, Option<f64>)> {
    if camera.projection.is_none() {
        let target = std::array::from_fn(|i| camera.position[i] + basis.forward[i]);
        let text = format!(
            "  <sensor type=\"perspective\">\n    <string name=\"fov_axis\" value=\"y\"/>\n    \
             <float name=\"fov\" value=\"{}\"/>\n    \
             <transform name=\"to_world\"><lookat origin=\"{}\" target=\"{}\" up=\"{}\"/></transform>\n",
            number(camera.fovy),
            vector(camera.position),
            vector(target),
            vector(basis.up),
        );
        return Some((text, None));
    }
    match Lens::of(camera, width, height)? {
        Lens::Parallel([origin, right, up, forward]) => {
            // Mitsuba's camera looks along its z axis, and its x axis points to the left; it sees x from −1 to 1.
            let aspect = f64::from(width) / f64::from(height);
            let mut place = Matrix::IDENTITY;
            for i in 0..3 {
                place.0[i] = [-right[i], aspect * up[i], forward[i], origin[i]];
            }
            let text = format!(
                "  <sensor type=\"orthographic\">\n    {}\n",
                transform("to_world", &place)
            );
            Some((text, None))
        }
        Lens::Pinhole(p) => {
            let [x, y] = p.shift;
            let text = format!(
                "  <sensor type=\"perspective\">\n    <string name=\"fov_axis\" value=\"y\"/>\n    \
                 <float name=\"fov\" value=\"{}\"/>\n    \
                 <float name=\"principal_point_offset_x\" value=\"{}\"/>\n    \
                 <float name=\"principal_point_offset_y\" value=\"{}\"/>\n    {}\n",
                number(p.field_of_view),
                number(x / 2.0),
                number(-y / 2.0),
                transform("to_world", &place(&p)),
            );
            Some((text, Some(p.near).filter(|n| *n > 0.0)))
        }
    }
}

/// The matrix from the camera's coordinates to the world's. Mitsuba's camera looks along its z axis, and its x axis
/// points to the left.
fn place(pinhole: &Pinhole) -> Matrix {
    let mut out = Matrix::IDENTITY;
    for i in 0..3 {
        out.0[i] = [
            -pinhole.right[i],
            pinhole.up[i],
            pinhole.forward[i],
            pinhole.position[i],
        ];
    }
    out
}

/// Whether Mitsuba has the camera exactly: its pixels are squares, or its rays parallel.
pub fn is_exact(camera: &Camera, (width, height): (u32, u32)) -> bool {
    camera.projection.is_none()
        || !matches!(Lens::of(camera, width, height), Some(Lens::Pinhole(p)) if !p.is_exact())
}

/// Longest side of a picture that is proposed, in pixels.
const MAX_PICTURE_SIDE: u32 = 4096;

/// The picture size, of those at which the pixels of all cameras are squares, with the height nearest to the given one.
/// `None` if there is none, or the pixels are squares already.
pub fn square_size(cameras: &[Camera], (width, height): (u32, u32)) -> Option<(u32, u32)> {
    let of_no_squares = cameras.iter().find(|c| !is_exact(c, (width, height)))?;
    let Some(Lens::Pinhole(pinhole)) = Lens::of(of_no_squares, width, height) else {
        return None;
    };
    let aspect = pinhole.pixel? * f64::from(width) / f64::from(height);
    (1..=MAX_PICTURE_SIDE)
        .map(|h| ((aspect * f64::from(h)).round() as u32, h))
        .filter(|size| (1..=MAX_PICTURE_SIDE).contains(&size.0))
        .filter(|size| cameras.iter().all(|c| is_exact(c, *size)))
        .min_by_key(|size| size.1.abs_diff(height))
}

/// The surroundings of the scene.
struct Environment {
    light: [f64; 3],
    /// Whether the environment is not seen: the background is black.
    hidden: bool,
}

/// The environment: the ambient light, or without it a background that is not black. `None` if there is neither.
fn environment(scene: &Scene) -> Option<Environment> {
    let background = scene.render.map_or([0.0; 3], |r| r.background);
    let mut light = [0.0; 3];
    for lamp in &scene.ambient_lights {
        for (sum, c) in light.iter_mut().zip(lamp.colour) {
            *sum += lamp.intensity * c;
        }
    }
    let dark = background == [0.0; 3];
    match (light == [0.0; 3], dark) {
        (true, true) => None,
        (true, false) => Some(Environment {
            light: background,
            hidden: false,
        }),
        (false, hidden) => Some(Environment { light, hidden }),
    }
}

/// The text of all lights. Mitsuba's point lights fade with distance; each is as bright as the scene's at the middle of
/// the region.
pub(super) fn lights(scene: &Scene, frame: &SceneFrame, region: &Aabb) -> String {
    let mut out = String::new();
    if let Some(e) = environment(scene) {
        // Writing to a string does not fail.
        let _ = writeln!(
            out,
            "  <emitter type=\"constant\">{}</emitter>",
            rgb("radiance", e.light)
        );
    }
    let middle = region.centre();
    for lamp in &scene.point_lights {
        let position = frame.place(lamp.position);
        let d: [f64; 3] = std::array::from_fn(|i| position[i] - middle[i]);
        let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        let power = lamp.colour.map(|c| c * lamp.intensity * PI * square);
        let _ = writeln!(
            out,
            "  <emitter type=\"point\" id=\"Light_{}\"><point name=\"position\" value=\"{}\"/>{}</emitter>",
            lamp.id,
            vector(position),
            rgb("intensity", power)
        );
    }
    out
}
