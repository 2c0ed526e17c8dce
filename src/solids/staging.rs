//! Cameras and lights for scenes without any.

use super::bounds::{NodeBounds, node_bounds};
use crate::geometry::Aabb;
use crate::geometry::array::{add, cross, unit};
use crate::scene::{AmbientLight, Camera, PointLight, Scene, Vec3, View};
use std::borrow::Cow;

/// The vertical field of view of the automatic camera, in degrees.
const AUTOMATIC_FOVY: f64 = 45.0;
/// The factor by which the bounding sphere is enlarged for framing, so that a margin is left around it.
const FRAMING_FACTOR: f64 = 1.05;
/// Intensities of the automatic lights: together no more than white.
const AMBIENT: f64 = 0.2;
const LAMP: f64 = 0.8;
/// The place of the automatic lamp, seen from the middle of the scene: degrees to the left of the camera, degrees above
/// the horizontal, and the distance in radii of the scene.
const LAMP_LEFT: f64 = 70.0;
const LAMP_HEIGHT: f64 = 45.0;
const LAMP_RADII: f64 = 10.0;

/// The choice of the camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Viewpoint {
    /// The cameras of the scene's own view; without any, the automatic one.
    #[default]
    Scene,
    /// The camera of this number in [`Scene::cameras`].
    Camera(usize),
    /// An automatic camera that looks at the scene from this side.
    Side(Side),
}

/// The side that an automatic camera looks at the scene from: x points to the right, y up, z to the front.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    /// The direction halfway between the right, the front and above.
    Iso,
}

impl Side {
    /// Degrees to the right of the front, and above the horizontal.
    fn angles(self) -> [f64; 2] {
        match self {
            Side::Front => [0.0, 0.0],
            Side::Back => [180.0, 0.0],
            Side::Left => [-90.0, 0.0],
            Side::Right => [90.0, 0.0],
            Side::Top => [0.0, 90.0],
            Side::Bottom => [0.0, -90.0],
            Side::Iso => [45.0, ISOMETRIC],
        }
    }
}

/// The elevation of a view along the diagonal of a cube: the arc tangent of 1/√2, in degrees.
const ISOMETRIC: f64 = 35.264_389_682_754_654;
/// The angles of the automatic camera, as in [`Side::angles`]: an object shows its front, its right side and its top.
const AUTOMATIC: [f64; 2] = [30.0, 25.0];

/// The scene as it is drawn, with the camera that takes the picture and with light. A camera or lights that the scene
/// lacks are added, under ID 0. `aspect` is the picture's width divided by its height.
///
/// A scene without a camera gets one that looks from 30° to the right of the front and 25° above the horizontal. A
/// scene without any light gets an ambient light of 0.2 and a lamp of 0.8, above the camera and to its left.
pub fn staged(scene: &Scene, viewpoint: Viewpoint, aspect: f64) -> Cow<'_, Scene> {
    let view = match viewpoint {
        Viewpoint::Scene => scene.view,
        Viewpoint::Camera(i) => View::Mono(i),
        Viewpoint::Side(_) => View::Automatic,
    };
    let (seen, dark) = (has_cameras(scene, view), is_dark(scene));
    if seen && !dark && view == scene.view {
        return Cow::Borrowed(scene);
    }
    let mut staged = scene.clone();
    staged.view = view;
    if seen && !dark {
        return Cow::Owned(staged);
    }
    let (centre, radius) = middle(&seen_box(scene, &node_bounds(scene)));
    if !seen {
        let angles = match viewpoint {
            Viewpoint::Side(side) => side.angles(),
            _ => AUTOMATIC,
        };
        staged.view = View::Mono(staged.cameras.len());
        (staged.cameras).push(camera_around(centre, radius, angles, aspect));
    }
    if dark {
        let white = [1.0; 3];
        let camera = staged.chosen_cameras().next().copied();
        staged.ambient_lights.push(AmbientLight {
            id: 0,
            intensity: AMBIENT,
            colour: white,
        });
        staged.point_lights.push(PointLight {
            id: 0,
            position: lamp(centre, radius, camera.as_ref()),
            intensity: LAMP,
            colour: white,
        });
    }
    Cow::Owned(staged)
}

/// The cameras that take the picture: one, or left and right; without any, the automatic one.
pub fn selected_cameras(scene: &Scene, aspect: f64) -> Vec<Camera> {
    let chosen: Vec<Camera> = scene.chosen_cameras().copied().collect();
    match chosen.is_empty() {
        true => vec![automatic_camera(scene, &node_bounds(scene), aspect)],
        false => chosen,
    }
}

/// Whether a view has cameras, and the scene has all of them.
fn has_cameras(scene: &Scene, view: View) -> bool {
    view != View::Automatic && view.cameras().all(|i| i < scene.cameras.len())
}

/// Whether a scene has no light at all.
pub fn is_dark(scene: &Scene) -> bool {
    scene.ambient_lights.is_empty() && scene.point_lights.is_empty()
}

/// The unit vector from the middle of a scene to a camera or lamp at these angles: degrees to the right of the front,
/// and above the horizontal.
fn towards([azimuth, elevation]: [f64; 2]) -> Vec3 {
    // Whole quarters of a turn give exact results.
    let turn = |degrees: f64| match degrees {
        90.0 | -90.0 => [1f64.copysign(degrees), 0.0],
        180.0 => [0.0, -1.0],
        _ => [
            libm::sin(degrees.to_radians()),
            libm::cos(degrees.to_radians()),
        ],
    };
    let ([x, z], [y, across]) = (turn(azimuth), turn(elevation));
    [x * across, y, z * across]
}

/// The camera that sees a ball at these angles, so far away that the ball fits into the picture both ways.
fn camera_around(centre: Vec3, radius: f64, angles: [f64; 2], aspect: f64) -> Camera {
    let vertical = (AUTOMATIC_FOVY / 2.0).to_radians();
    let horizontal = libm::atan(libm::tan(vertical) * aspect);
    let distance = FRAMING_FACTOR * radius / libm::sin(vertical.min(horizontal));
    let out = towards(angles);
    let up = match angles[1] {
        90.0 => [0.0, 0.0, -1.0],
        -90.0 => [0.0, 0.0, 1.0],
        _ => [0.0, 1.0, 0.0],
    };
    Camera {
        id: 0,
        position: add(centre, out, distance),
        direction: out.map(|x| 0.0 - x),
        up,
        fovy: AUTOMATIC_FOVY,
        projection: None,
    }
}

/// The camera of a scene that has none. `aspect` is the picture's width divided by its height.
pub fn automatic_camera(scene: &Scene, bounds: &[NodeBounds], aspect: f64) -> Camera {
    let (centre, radius) = middle(&seen_box(scene, bounds));
    camera_around(centre, radius, AUTOMATIC, aspect)
}

/// The place of the automatic lamp: to the left of the camera about the vertical axis through the middle of the scene.
/// If the camera looks straight up, the lamp stands as far below the horizontal, so that it lights what is seen.
fn lamp(centre: Vec3, radius: f64, camera: Option<&Camera>) -> Vec3 {
    let front = ([0.0, 0.0, 1.0], LAMP_HEIGHT);
    let (back, height) = camera.and_then(Basis::of).map_or(front, |basis| {
        let [x, y, z] = basis.forward;
        // If a camera looks straight down or up, its right vector still tells where it stands.
        match libm::hypot(x, z) > MIN_HORIZONTAL_SINE {
            true => ([-x, 0.0, -z], LAMP_HEIGHT),
            false => (
                cross(basis.right, [0.0, 1.0, 0.0]),
                LAMP_HEIGHT.copysign(-y),
            ),
        }
    });
    let azimuth = libm::atan2(back[0], back[2]).to_degrees() - LAMP_LEFT;
    add(centre, towards([azimuth, height]), LAMP_RADII * radius)
}

/// Length of a unit direction's horizontal part below which a camera looks up or down.
const MIN_HORIZONTAL_SINE: f64 = 1e-3;

/// The middle of the box, and the radius of the ball around it. The radius is more than 0, also for an empty box.
fn middle(seen: &Aabb) -> (Vec3, f64) {
    if seen.is_empty() {
        return ([0.0; 3], 1.0);
    }
    let radius = seen.radius();
    (seen.centre(), if radius > 0.0 { radius } else { 1.0 })
}

/// The middle of what is drawn, or the origin if nothing of it is bounded.
pub fn centre(scene: &Scene, bounds: &[NodeBounds]) -> Vec3 {
    middle(&seen_box(scene, bounds)).0
}

/// The box that the automatic camera frames: the region of the render record, else the box of the bounded parts of what
/// is drawn. The box is finite, and empty where nothing is bounded or drawn.
pub fn seen_box(scene: &Scene, bounds: &[NodeBounds]) -> Aabb {
    match &scene.render {
        Some(render) => match render.clip {
            Some((min, max)) => Aabb::new(min, max),
            None => bounds
                .get(render.root as usize)
                .map_or(Aabb::EMPTY, |b| b.bounded()),
        },
        None => Aabb::EMPTY,
    }
}

/// The orthonormal directions of a camera: right = forward × up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Basis {
    pub forward: Vec3,
    pub right: Vec3,
    pub up: Vec3,
}

impl Basis {
    /// Computes the directions of a camera. `None` if direction and up are parallel or not finite.
    pub fn of(camera: &Camera) -> Option<Basis> {
        let forward = unit(camera.direction)?;
        let right = unit(cross(forward, unit(camera.up)?))?;
        Some(Basis {
            forward,
            right,
            up: cross(right, forward),
        })
    }

    /// The vector in the scene's coordinates whose coordinates in the camera's space (right, up, backwards) are `v`.
    pub fn turned(&self, v: Vec3) -> Vec3 {
        std::array::from_fn(|i| self.right[i] * v[0] + self.up[i] * v[1] - self.forward[i] * v[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_scene_is_framed_about_the_origin() {
        let distance = |aspect| {
            let camera = automatic_camera(&Scene::default(), &[], aspect);
            camera.position.iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        // The unit sphere with its margin touches the upper edge: sin 22.5° = 1.05 / distance.
        assert!((distance(4.0 / 3.0) * 22.5f64.to_radians().sin() - 1.05).abs() < 1e-12);
        assert!(distance(0.5) > distance(4.0 / 3.0));
    }

    #[test]
    fn a_whole_scene_is_left_as_it_is() {
        let mut scene = Scene::default();
        scene
            .cameras
            .push(camera_around([0.0; 3], 1.0, [0.0, 0.0], 1.0));
        scene.view = View::Mono(0);
        assert!(matches!(
            staged(&scene, Viewpoint::Scene, 1.0),
            Cow::Owned(_)
        ));
        scene.ambient_lights.push(AmbientLight {
            id: 5,
            intensity: 0.0,
            colour: [1.0; 3],
        });
        assert!(matches!(
            staged(&scene, Viewpoint::Scene, 1.0),
            Cow::Borrowed(_)
        ));
    }

    #[test]
    fn directions_of_any_length() {
        let camera = Camera {
            id: 2,
            position: [0.0; 3],
            direction: [0.0, 0.0, -1e300],
            up: [0.0, 1e-300, 1e-301],
            fovy: 30.0,
            projection: None,
        };
        let basis = Basis::of(&camera).unwrap();
        assert_eq!(basis.right, [1.0, 0.0, 0.0]);
        assert_eq!(basis.up, [0.0, 1.0, 0.0]);
    }
}
