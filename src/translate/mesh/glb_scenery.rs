//! Cameras and lights of a glTF file.

use std::f64::consts::PI;

use serde_json::{Value, json};

use super::extent::Extent;
use crate::geometry::array::{cross, dot, length, sub};
use crate::scene::{Camera, PointLight, Scene, Vec3};
use crate::solids::staging::Basis;
use crate::translate::lens::{Lens, Pinhole};
use crate::translate::names::Names;

/// The extension that lights are written in.
pub(super) const LIGHTS: &str = "KHR_lights_punctual";

/// Distance from a camera, in radii of the scene, below which nothing is drawn: the format asks for a number above 0.
const NEAR_PLANE_RADII: f64 = 1e-3;
/// Distance that parallel rays go beyond the middle of the scene, in radii: past its farthest side.
const PARALLEL_RAY_RADII: f64 = 2.0;
/// The least distance of a light from the middle of the scene, in radii, that counts for its brightness: a nearer
/// light is as bright as one at this distance.
const MIN_LIGHT_RADII: f64 = 0.1;
/// Tolerance for a camera that is not askew: how far the middle of the picture may be from the optical axis, in units
/// of half its size, and how far the dot products of the camera's axes may be from 0.
const STRAIGHT: f64 = 1e-6;

/// Cameras and lights, each with the node that places it.
#[derive(Default)]
pub struct Scenery {
    pub cameras: Vec<Value>,
    pub lights: Vec<Value>,
    pub nodes: Vec<Value>,
}

impl Scenery {
    /// The counterparts of the scene's cameras and of `lights`. Cameras that take the picture come first. A camera or
    /// light without a counterpart is left out.
    pub fn of(scene: &Scene, lights: &[PointLight], extent: &Extent, names: &Names) -> Scenery {
        let mut out = Scenery::default();
        for camera in in_order(scene) {
            let Some((mut seen, matrix)) = view(camera, extent) else {
                continue;
            };
            named(&mut seen, names.words(camera.id));
            out.nodes.push(json!({
                "name": format!("Camera_{}", camera.id), "camera": out.cameras.len(), "matrix": matrix,
            }));
            out.cameras.push(seen);
        }
        for light in lights {
            let Some(mut lamp) = lamp(light, extent) else {
                continue;
            };
            named(&mut lamp, names.words(light.id));
            out.nodes.push(json!({
                "name": format!("Light_{}", light.id), "translation": light.position,
                "extensions": { LIGHTS: { "light": out.lights.len() } },
            }));
            out.lights.push(lamp);
        }
        out
    }
}

/// Whether a camera has a counterpart in glTF.
pub(super) fn has_counterpart(camera: &Camera) -> bool {
    lens(camera).is_some()
}

fn named(value: &mut Value, words: Option<&str>) {
    if let Some(words) = words {
        value["name"] = json!(words);
    }
}

fn in_order(scene: &Scene) -> impl Iterator<Item = &Camera> {
    let view = scene.view;
    let others =
        (0..scene.cameras.len()).filter(move |i| view.cameras().all(|chosen| chosen != *i));
    (view.cameras().chain(others)).filter_map(|i| scene.cameras.get(i))
}

/// The counterpart of a camera in glTF.
enum Counterpart {
    /// A perspective camera: the vertical angle in radians, width divided by height if the camera has its own, and
    /// the distance of the near plane, 0 if the camera has none.
    Perspective {
        angle: f64,
        aspect: Option<f64>,
        near: f64,
    },
    /// A parallel camera, with half the width and height.
    Parallel { half: [f64; 2] },
}

/// The counterpart of a camera, and its placement: right, up, forward, position. `None` for a camera that is askew or
/// mirrors the picture.
fn lens(camera: &Camera) -> Option<(Counterpart, [Vec3; 4])> {
    let basis = Basis::of(camera)?;
    if camera.projection.is_none() {
        let angle = camera.fovy.to_radians();
        let own = Counterpart::Perspective {
            angle,
            aspect: None,
            near: 0.0,
        };
        return Some((own, [basis.right, basis.up, basis.forward, camera.position]));
    }
    // A picture of one pixel has the same shape as the pixel.
    match Lens::of(camera, 1, 1)? {
        Lens::Pinhole(Pinhole {
            position,
            right,
            up,
            forward,
            field_of_view,
            shift,
            near,
            pixel,
        }) => {
            let straight = shift.iter().all(|s| s.abs() < STRAIGHT);
            let own = Counterpart::Perspective {
                angle: field_of_view.to_radians(),
                aspect: Some(pixel.filter(|_| straight)?),
                near,
            };
            is_right_handed(right, up, forward).then_some((own, [right, up, forward, position]))
        }
        Lens::Parallel([start, right, up, forward]) => {
            let half = [length(right), length(up)];
            let [right, up] = [(right, half[0]), (up, half[1])].map(|(v, by)| v.map(|x| x / by));
            let straight = [dot(right, up), dot(right, forward), dot(up, forward)];
            let own = Counterpart::Parallel { half };
            (straight.iter().all(|x| x.abs() < STRAIGHT) && is_right_handed(right, up, forward))
                .then_some((own, [right, up, forward, start]))
        }
    }
}

fn is_right_handed(right: Vec3, up: Vec3, forward: Vec3) -> bool {
    dot(cross(right, up), forward) < 0.0
}

/// A camera in glTF, and its matrix as sixteen numbers, column by column. A glTF camera looks along −z. `None` if the
/// camera has no counterpart.
fn view(camera: &Camera, extent: &Extent) -> Option<(Value, [f64; 16])> {
    let radius = extent.radius;
    let (own, [right, up, forward, position]) = lens(camera)?;
    let seen = match own {
        Counterpart::Perspective {
            angle,
            aspect,
            near,
        } => {
            let near = if near > 0.0 {
                near
            } else {
                NEAR_PLANE_RADII * radius
            };
            let mut lens = json!({ "yfov": angle, "znear": near });
            if let Some(aspect) = aspect {
                lens["aspectRatio"] = json!(aspect);
            }
            json!({ "type": "perspective", "perspective": lens })
        }
        Counterpart::Parallel { half: [x, y] } => {
            let away = length(sub(extent.region.centre(), position));
            let lens = json!({ "xmag": x, "ymag": y, "znear": 0.0, "zfar": away + PARALLEL_RAY_RADII * radius });
            json!({ "type": "orthographic", "orthographic": lens })
        }
    };
    let columns = [right, up, forward.map(|x| -x), position];
    let mut matrix = [0.0; 16];
    for (i, column) in columns.iter().enumerate() {
        matrix[4 * i..4 * i + 3].copy_from_slice(column);
    }
    matrix[15] = 1.0;
    matrix
        .iter()
        .all(|x| x.is_finite())
        .then_some((seen, matrix))
}

/// A point light as glTF JSON, its intensity in candela. The scene's lights do not fade with distance; glTF's fade with
/// its square. The intensity is chosen so that both are equally bright at the middle of the scene: multiplied by the
/// squared distance, and by π, since a diffuse surface in glTF reflects 1/π of its irradiance in each direction. `None`
/// if the light is dark or a number is not finite.
fn lamp(light: &PointLight, extent: &Extent) -> Option<Value> {
    let distance =
        length(sub(light.position, extent.region.centre())).max(MIN_LIGHT_RADII * extent.radius);
    let colour = light.colour.map(|c| (c * light.intensity).max(0.0));
    let brightest = colour.iter().fold(0.0f64, |most, &c| most.max(c));
    let intensity = brightest * PI * distance * distance;
    let numbers = light.position.iter().chain(&colour).chain([&intensity]);
    let fits = numbers.into_iter().all(|x| x.is_finite());
    (fits && brightest > 0.0).then(|| {
        let colour = colour.map(|c| c / brightest);
        json!({ "type": "point", "color": colour, "intensity": intensity })
    })
}
