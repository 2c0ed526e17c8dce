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
/// Distance that parallel rays go beyond the scene's farthest side, in radii.
const PARALLEL_RAY_RADII: f64 = 2.0;
/// Distance from the middle of the scene, in radii, below which a light is as bright as from there.
const MIN_LIGHT_RADII: f64 = 0.1;
/// How far the middle of a picture may be from the axis, by half its size, and an axis from a right angle.
const STRAIGHT: f64 = 1e-6;

/// Cameras and lights, each with the node that places it.
#[derive(Default)]
pub struct Scenery {
    pub cameras: Vec<Value>,
    pub lights: Vec<Value>,
    pub nodes: Vec<Value>,
}

impl Scenery {
    /// The cameras of a scene, of which those that take the picture come first, and some lights.
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

/// Whether a camera has a counterpart in the format.
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

/// The counterpart of a camera in the format, and its place: right, up, forward, position.
enum Counterpart {
    /// A perspective camera, with the vertical angle in radians, and width by height where the camera says that itself.
    Perspective {
        angle: f64,
        aspect: Option<f64>,
        near: f64,
    },
    /// A parallel camera, with half the width and height.
    Parallel { half: [f64; 2] },
}

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
    // A picture of one pixel has the shape of that.
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

/// A camera, and its place as sixteen numbers, column by column: it looks against its z.
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

/// A light in candela that at the middle of the scene is as bright as ours: those of the format fade with distance, and
/// a surface sends a π-th of what it receives each way.
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
