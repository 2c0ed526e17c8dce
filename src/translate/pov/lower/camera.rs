//! Cameras.

use crate::diagnostics::{Complaint, Error, Value};
use crate::geometry::Aabb;
use crate::geometry::array::{add, cross, dot, length, sub, unit};
use crate::scene::sight::Sight;
use crate::scene::{Camera, Scene, Vec3};
use crate::solids::staging::Basis;
use crate::translate::about_camera;
use crate::translate::fidelity::{Fidelity, Report};
use crate::translate::pov::Options;
use crate::translate::pov::tree::Lens;

/// A camera that takes the picture, and its rays.
pub(super) struct Eye {
    pub camera: Camera,
    pub lens: Lens,
}

/// The cameras that take the picture: one, or left and right.
///
/// # Errors
/// A camera whose rays are not those of a pinhole or parallel.
pub(super) fn eyes(
    scene: &Scene,
    whole: Aabb,
    options: &Options,
    report: &mut Report,
) -> Result<Vec<Eye>, Error> {
    let mut out = Vec::new();
    for &camera in scene.chosen_cameras() {
        let fault = |message| Error::scene(about_camera(&camera, message));
        let basis = Basis::of(&camera).ok_or_else(|| fault("camera-nowhere"))?;
        let mut lens = match &camera.projection {
            None => match from_far(&camera, &basis, options.aspect(), whole) {
                Some((lens, off)) => {
                    let pixels = off * f64::from(options.size.0.max(options.size.1));
                    report.state(
                        "camera far away",
                        Fidelity::Approximate(
                            Complaint::new("fidelity-parallel")
                                .with("pixels", Value::Decimal(format!("{pixels:.1e}"))),
                        ),
                        "",
                    );
                    lens
                }
                None => pinhole(&camera, &basis, options.aspect()),
            },
            Some(p) => {
                let sight = Sight::of(p).map_err(|_| fault("camera-of-no-lens"))?;
                let lens = projecting(&sight, &camera, &basis)
                    .ok_or_else(|| fault("camera-of-no-lens"))?;
                if !lens.parallel && !sees_all_behind_near(&sight, &camera, &basis, whole) {
                    report.state(
                        "near plane of the projection matrix",
                        Fidelity::approximate(
                            "what lies between the camera and the near plane is seen",
                        ),
                        "",
                    );
                }
                lens
            }
        };
        if lens.parallel {
            report.state(
                "parallel rays",
                Fidelity::approximate("moved by a billionth of the picture"),
                "so that none runs exactly along a face",
            );
        }
        lens.caption = match camera.id {
            0 => "the scene has no camera".to_owned(),
            id => options.captions.entity(id),
        };
        lens.shift = shift(&lens);
        for v in [&mut lens.direction, &mut lens.right, &mut lens.up] {
            *v = clean(*v);
        }
        out.push(Eye { camera, lens });
    }
    Ok(out)
}

fn pinhole(camera: &Camera, basis: &Basis, aspect: f64) -> Lens {
    let height = 2.0 * (camera.fovy / 2.0).to_radians().tan();
    Lens {
        location: camera.position,
        direction: basis.forward,
        right: basis.right.map(|c| c * height * aspect),
        up: basis.up.map(|c| c * height),
        ..Lens::default()
    }
}

/// The distance of the camera, in radii of the scene, beyond which its rays are written as parallel: POV-Ray's numbers
/// do not suffice for rays from there.
const TELESCOPE: f64 = 1e5;

/// A lens with parallel rays for a pinhole that is far from all of the scene, and the error of the picture, as a
/// fraction of its larger side. `None` if the camera is nearer.
fn from_far(camera: &Camera, basis: &Basis, aspect: f64, scene: Aabb) -> Option<(Lens, f64)> {
    if scene.is_empty() || !scene.is_finite() {
        return None;
    }
    let (centre, radius) = (scene.centre(), scene.radius());
    let distance = dot(
        basis.forward,
        std::array::from_fn(|i| centre[i] - camera.position[i]),
    );
    if distance < TELESCOPE * radius || radius == 0.0 {
        return None;
    }
    let lens = pinhole(camera, basis, aspect);
    let near = distance - 2.0 * radius;
    let lens = Lens {
        parallel: true,
        location: std::array::from_fn(|i| camera.position[i] + near * basis.forward[i]),
        direction: lens.direction,
        right: lens.right.map(|c| c * distance),
        up: lens.up.map(|c| c * distance),
        ..lens
    };
    Some((lens, 0.5 * radius / (distance - radius)))
}

/// The lens of a projection matrix; `None` where its rays neither come from one point nor are parallel.
fn projecting(sight: &Sight, camera: &Camera, basis: &Basis) -> Option<Lens> {
    let place = |p: Vec3| add(camera.position, basis.turned(p), 1.0);
    let [direction, along_x, along_y] = sight.direction().map(|v| basis.turned(v));
    let lens = if sight.is_parallel() {
        let [middle, right, top] =
            [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| sight.ray(x, y));
        let middle = middle?.0;
        let across = |edge: Vec3| basis.turned(sub(edge, middle)).map(|c| 2.0 * c);
        Lens {
            parallel: true,
            location: place(middle),
            direction: unit(direction)?,
            right: across(right?.0),
            up: across(top?.0),
            ..Lens::default()
        }
    } else {
        let length = length(direction);
        Lens {
            location: place(sight.eye()?),
            direction: direction.map(|c| c / length),
            right: along_x.map(|c| 2.0 * c / length),
            up: along_y.map(|c| 2.0 * c / length),
            ..Lens::default()
        }
    };
    let finite = [lens.location, lens.direction, lens.right, lens.up]
        .iter()
        .flatten()
        .all(|x| x.is_finite());
    finite.then_some(lens)
}

/// The vector by which parallel rays are moved. They could all run exactly along faces and seams, where POV-Ray does
/// not know what to do.
fn shift(lens: &Lens) -> Vec3 {
    // A fraction of the picture's size: a millionth of a pixel, and a million times the rounding errors.
    const CAMERA_SHIFT: f64 = 1e-9;
    let shift: Vec3 = std::array::from_fn(|i| CAMERA_SHIFT * (0.6 * lens.right[i] + lens.up[i]));
    clean(shift.map(|x| format!("{x:.1e}").parse().unwrap_or(x)))
}

/// A vector whose components are 0 where they are but rounding errors.
fn clean(v: Vec3) -> Vec3 {
    let largest = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    v.map(|x| {
        if x.abs() < 4.0 * f64::EPSILON * largest {
            0.0
        } else {
            x
        }
    })
}

/// The corners of the picture.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Whether no part of the scene lies between the eye and the near plane, where rays start.
fn sees_all_behind_near(sight: &Sight, camera: &Camera, basis: &Basis, scene: Aabb) -> bool {
    let Some(eye) = sight.eye() else {
        return true;
    };
    // Depths are measured from the eye along the normal of the picture plane; the depth of `direction` is 1.
    let [direction, along_x, along_y] = sight.direction();
    let normal = cross(along_x, along_y);
    let pace = dot(normal, direction);
    let depth = |way: Vec3, normal: Vec3| dot(normal, way) / pace;
    let starts = CORNERS.map(|[x, y]| match sight.ray(x, y) {
        Some((start, _)) => depth(sub(start, eye), normal),
        None => f64::NAN,
    });
    let eye = add(camera.position, basis.turned(eye), 1.0);
    let normal = basis.turned(normal);
    let corner = |k: usize| {
        std::array::from_fn(|i| {
            if k >> i & 1 == 0 {
                scene.min[i]
            } else {
                scene.max[i]
            }
        })
    };
    let nearest = (0..8)
        .map(|k| depth(sub(corner(k), eye), normal))
        .fold(f64::INFINITY, f64::min);
    scene.is_empty() || starts.iter().all(|s| (0.0..=nearest).contains(s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Matrix;

    /// A lens must have the rays of the reference tracer.
    #[test]
    fn lenses_have_the_rays_of_the_tracer() {
        let perspective = Matrix([
            [1.5, 0.0, 0.2, 0.0],
            [0.1, 2.0, -0.3, 0.0],
            [0.0, 0.0, -1.2, -2.2],
            [0.0, 0.0, -1.0, 0.0],
        ]);
        let parallel = Matrix([
            [0.5, 0.1, 0.2, 0.1],
            [0.0, 0.7, -0.3, 0.2],
            [0.0, 0.0, -0.2, -1.1],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        for (projection, is_parallel) in [(perspective, false), (parallel, true)] {
            let camera = Camera {
                id: 2,
                position: [1.0, 2.0, 3.0],
                direction: [-0.3, -0.2, -1.0],
                up: [0.1, 1.0, 0.0],
                fovy: 45.0,
                projection: Some(projection),
            };
            let basis = Basis::of(&camera).unwrap();
            let lens = projecting(&Sight::of(&projection).unwrap(), &camera, &basis).unwrap();
            assert_eq!(lens.parallel, is_parallel);
            let view = crate::trace::camera::View::new(&camera, 40, 30).unwrap();
            for [x, y] in [[0.5, 0.5], [20.0, 15.0], [33.0, 2.0]] {
                let ray = view.ray(x, y).unwrap();
                let (s, t) = (x / 40.0 - 0.5, 0.5 - y / 30.0);
                let across: Vec3 = std::array::from_fn(|i| s * lens.right[i] + t * lens.up[i]);
                let (from, way) = if is_parallel {
                    (
                        std::array::from_fn(|i| lens.location[i] + across[i]),
                        lens.direction,
                    )
                } else {
                    let way = std::array::from_fn(|i| lens.direction[i] + across[i]);
                    (lens.location, way)
                };
                let d = ray.line.direction.0;
                let length = dot(way, way).sqrt();
                let offset: Vec3 = std::array::from_fn(|i| ray.line.origin.0[i] - from[i]);
                let off = cross(offset, d);
                for i in 0..3 {
                    assert!((way[i] / length - d[i]).abs() < 1e-12, "{x} {y}");
                    assert!(off[i].abs() < 1e-12, "{x} {y}");
                }
            }
        }
    }
}
