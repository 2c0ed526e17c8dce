//! What a scene without a camera or without a light is seen and lit by.

use super::bounds::{NodeBounds, node_bounds};
use crate::geometry::Aabb;
use crate::geometry::array::{cross, unit};
use crate::scene::{Camera, PointLight, Scene, Vec3, View};

/// The vertical field of view of the automatic camera, in degrees.
const AUTOMATIC_FOVY: f64 = 45.0;
/// The bounding sphere is seen as if it were larger by this factor.
const MARGIN: f64 = 1.05;

/// The cameras that take the picture: one, or left and right; without any, one that frames the scene.
pub fn selected_cameras(scene: &Scene, aspect: f64) -> Vec<Camera> {
    let chosen = match scene.view {
        View::Automatic => vec![],
        View::Mono(i) => vec![i],
        View::Stereo { left, right } => vec![left, right],
    };
    let known = chosen.iter().filter_map(|i| scene.cameras.get(*i));
    let cameras: Vec<Camera> = known.copied().collect();
    match cameras.is_empty() {
        true => vec![automatic_camera(scene, &node_bounds(scene), aspect)],
        false => cameras,
    }
}

/// The camera of a scene that has none: it looks along −z at the centre of what is to be seen, and
/// the sphere around that fits into the picture both ways. `aspect` is width by height.
pub fn automatic_camera(scene: &Scene, bounds: &[NodeBounds], aspect: f64) -> Camera {
    let seen = seen_box(scene, bounds);
    let (centre, radius) = if seen.is_empty() {
        ([0.0; 3], 1.0)
    } else {
        (seen.centre(), seen.radius())
    };
    let radius = if radius > 0.0 { radius } else { 1.0 };
    let vertical = (AUTOMATIC_FOVY / 2.0).to_radians();
    let horizontal = libm::atan(libm::tan(vertical) * aspect);
    let distance = MARGIN * radius / libm::sin(vertical.min(horizontal));
    Camera {
        id: 0,
        position: [centre[0], centre[1], centre[2] + distance],
        direction: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        fovy: AUTOMATIC_FOVY,
        projection: None,
    }
}

/// The box that the automatic camera frames: the render record's, else that of the bounded parts
/// of the scene. Finite; empty where nothing is bounded.
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

/// The light of a scene that has none: white, of intensity 1, at the camera.
pub fn headlight(scene: &Scene, camera: &Camera) -> Option<PointLight> {
    (scene.ambient_lights.is_empty() && scene.point_lights.is_empty()).then_some(PointLight {
        id: 0,
        position: camera.position,
        intensity: 1.0,
        colour: [1.0; 3],
    })
}

/// The orthonormal directions of a camera: right = forward × up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Basis {
    pub forward: Vec3,
    pub right: Vec3,
    pub up: Vec3,
}

impl Basis {
    /// `None` where direction and up are parallel or not finite.
    pub fn of(camera: &Camera) -> Option<Basis> {
        let forward = unit(camera.direction)?;
        let right = unit(cross(forward, unit(camera.up)?))?;
        Some(Basis {
            forward,
            right,
            up: cross(right, forward),
        })
    }

    /// A vector of the camera's space (right, up, backwards) in the scene's.
    pub fn turned(&self, v: Vec3) -> Vec3 {
        std::array::from_fn(|i| self.right[i] * v[0] + self.up[i] * v[1] - self.forward[i] * v[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_scene_is_framed_about_the_origin() {
        let camera = automatic_camera(&Scene::default(), &[], 4.0 / 3.0);
        assert_eq!(camera.position[..2], [0.0, 0.0]);
        // The unit sphere with its margin touches the upper edge: sin 22.5° = 1.05 / distance.
        assert!((camera.position[2] * 22.5f64.to_radians().sin() - 1.05).abs() < 1e-12);
        let narrow = automatic_camera(&Scene::default(), &[], 0.5);
        assert!(narrow.position[2] > camera.position[2]);
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
