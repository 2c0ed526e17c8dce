//! Cameras.

use super::Options;
use super::build::Builder;
use super::frame::Frame;
use super::text::{entity, vector};
use crate::scene::frame::{Basis, selected_cameras};
use crate::scene::vector::{cross, dot, length};
use crate::scene::{Aabb, Camera, Matrix, Scene, Vec3};
use crate::syntax::Captions;
use crate::translate::Unsupported;
use crate::translate::fidelity::Fidelity;

/// A camera that takes the picture, and its rays.
pub struct Eye {
    pub camera: Camera,
    lens: Lens,
}

impl Eye {
    /// Where its rays come from; the middle of the picture where they are parallel.
    pub fn location(&self) -> Vec3 {
        self.lens.location
    }
}

/// POV-Ray's rays are direction + (x − ½)·right + (½ − y)·up, from the location or, if they are
/// parallel, from the location moved by that. The vectors may be of any hand and need not be at
/// right angles.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Lens {
    parallel: bool,
    location: Vec3,
    direction: Vec3,
    right: Vec3,
    up: Vec3,
}

/// The cameras that take the picture: one, or left and right.
///
/// # Errors
/// A camera whose rays are not those of a pinhole or parallel.
pub fn eyes(
    scene: &Scene,
    builder: &mut Builder,
    options: &Options,
) -> Result<Vec<Eye>, Unsupported> {
    let chosen = selected_cameras(scene, options.aspect());
    let mut out = Vec::with_capacity(chosen.len());
    for camera in chosen {
        let fault = |message| Unsupported::camera(&camera, message);
        let basis = Basis::of(&camera).ok_or_else(|| fault("camera-nowhere"))?;
        let lens = match &camera.projection {
            None => match from_far(&camera, &basis, options.aspect(), builder.box_of_root()) {
                Some((lens, off)) => {
                    let pixels = off * f64::from(options.size.0.max(options.size.1));
                    builder.report.state(
                        "camera far away",
                        Fidelity::Approximate(format!(
                            "its rays are made parallel: off by less than {pixels:.1e} pixels"
                        )),
                        "",
                    );
                    lens
                }
                None => pinhole(&camera, &basis, options.aspect()),
            },
            Some(p) => {
                let back = clip_to_scene(p, &camera, &basis);
                let lens = (back.and_then(|m| projecting(&m)))
                    .ok_or_else(|| fault("camera-of-no-lens"))?;
                if let Some(back) = back
                    && !sees_all_behind_near(&back, &lens, builder.box_of_root())
                {
                    builder.report.state(
                        "near plane of the projection matrix",
                        Fidelity::Approximate(
                            "what lies between the camera and the near plane is seen".to_owned(),
                        ),
                        "",
                    );
                }
                lens
            }
        };
        if lens.parallel {
            builder.report.state(
                "parallel rays",
                Fidelity::Approximate("moved by a billionth of the picture".to_owned()),
                "so that none runs exactly along a face",
            );
        }
        out.push(Eye { camera, lens });
    }
    Ok(out)
}

fn pinhole(camera: &Camera, basis: &Basis, aspect: f64) -> Lens {
    let height = 2.0 * (camera.fovy / 2.0).to_radians().tan();
    Lens {
        parallel: false,
        location: camera.position,
        direction: basis.forward,
        right: basis.right.map(|c| c * height * aspect),
        up: basis.up.map(|c| c * height),
    }
}

/// What is more than so many radii away is looked at in parallel: POV-Ray's numbers do not suffice for
/// rays from there.
const TELESCOPE: f64 = 1e5;

/// Parallel rays for a pinhole that is far from all of the scene, and how far off they are, as a part
/// of the picture's larger side.
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
    };
    Some((lens, 0.5 * radius / (distance - radius)))
}

/// From the clip cube to the scene.
fn clip_to_scene(projection: &Matrix, camera: &Camera, basis: &Basis) -> Option<Matrix> {
    let row = |v: Vec3| [v[0], v[1], v[2], -dot(v, camera.position)];
    let view = Matrix([
        row(basis.right),
        row(basis.up),
        row(basis.forward.map(|c| -c)),
        [0.0, 0.0, 0.0, 1.0],
    ]);
    projection.after(&view).inverse()
}

/// A point of the scene before the division: x, y, z and w.
type Homogeneous = [f64; 4];

fn column(m: &Matrix, j: usize) -> Homogeneous {
    std::array::from_fn(|i| m.0[i][j])
}

fn at(m: &Matrix, clip: [f64; 4]) -> Homogeneous {
    std::array::from_fn(|i| (0..4).map(|j| m.0[i][j] * clip[j]).sum())
}

/// The lens of a matrix from clip coordinates to the scene.
///
/// All lines of sight (x, y, ·, 1) meet in the image of (0, 0, 1, 0): a pinhole, or a direction. With
/// C for it and q for the image of (x, y, 0, 1), the line's direction is q·C_w − C·q_w, linear in x
/// and y.
fn projecting(back: &Matrix) -> Option<Lens> {
    let c = column(back, 2);
    let size = |v: Homogeneous| v[..3].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let [x, y, q] = [0, 1, 3].map(|j| column(back, j));
    // Where the scene's coordinates are of the size of q, C is a direction if its w is but rounding.
    // Zero, but for the roundings of the matrix's inverse; so below.
    let parallel = c[3].abs() * size(q) <= 1e-12 * size(c) * q[3].abs();
    let lens = if parallel {
        if (x[3].abs() + y[3].abs()) > 1e-12 * q[3].abs() {
            return None;
        }
        let near = at(back, [0.0, 0.0, -1.0, 1.0]);
        let by_w = |v: Homogeneous| -> Vec3 { std::array::from_fn(|i| v[i] / q[3]) };
        Lens {
            parallel,
            location: by_w(near),
            direction: by_w(c),
            right: by_w(x).map(|v| 2.0 * v),
            up: by_w(y).map(|v| 2.0 * v),
        }
    } else {
        let away = |v: Homogeneous| -> Vec3 { std::array::from_fn(|i| v[i] * c[3] - c[i] * v[3]) };
        let sign = forward_sign(back, c[3])?;
        let direction = away(q).map(|v| v * sign);
        let length = length(direction);
        Lens {
            parallel,
            location: std::array::from_fn(|i| c[i] / c[3]),
            direction: direction.map(|v| v / length),
            right: away(x).map(|v| 2.0 * sign * v / length),
            up: away(y).map(|v| 2.0 * sign * v / length),
        }
    };
    let finite = [lens.location, lens.direction, lens.right, lens.up]
        .iter()
        .flatten()
        .all(|x| x.is_finite());
    finite.then_some(lens)
}

impl Lens {
    /// Parallel rays could all run exactly along faces and seams, where POV-Ray does not know what to
    /// do: they are moved by a hair.
    fn shift(&self) -> String {
        // By the size of the picture: a millionth of a pixel, and a million times what is rounded.
        const HAIR: f64 = 1e-9;
        let shift: Vec3 = std::array::from_fn(|i| HAIR * (0.6 * self.right[i] + self.up[i]));
        let shift = shift.map(|x| format!("{x:.1e}").parse().unwrap_or(x));
        format!(
            "  translate {} // by a hair, so that no ray runs exactly along a face or a seam\n",
            vector(&clean(shift))
        )
    }
}

/// A vector without what is but rounding.
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

/// Whether the way from the near to the far plane is that of q·C_w − C·q_w, or the opposite: the same
/// all over the picture, else `None`.
fn forward_sign(back: &Matrix, w: f64) -> Option<f64> {
    let sign = |[x, y]: [f64; 2]| {
        let [near, far] = [-1.0, 1.0].map(|z| at(back, [x, y, z, 1.0])[3]);
        ((1.0 / far - 1.0 / near) / w).signum()
    };
    let first = sign(CORNERS[0]);
    (!first.is_nan() && CORNERS.iter().all(|c| sign(*c) == first)).then_some(first)
}

/// Whether nothing of the scene lies between a pinhole and the near plane; parallel rays begin there
/// anyway.
fn sees_all_behind_near(back: &Matrix, lens: &Lens, scene: Aabb) -> bool {
    if lens.parallel || scene.is_empty() {
        return true;
    }
    // Depths along the normal of the picture plane, in units of the direction's.
    let normal = cross(lens.right, lens.up);
    let pace = dot(normal, lens.direction);
    let depth = |p: Vec3| {
        let way = std::array::from_fn(|i| p[i] - lens.location[i]);
        dot(normal, way) / pace
    };
    let near = CORNERS.map(|[x, y]| {
        let p = at(back, [x, y, -1.0, 1.0]);
        depth(std::array::from_fn(|i| p[i] / p[3]))
    });
    let nearest = (0..8)
        .map(|corner: usize| {
            depth(std::array::from_fn(|i| {
                if corner >> i & 1 == 0 {
                    scene.min[i]
                } else {
                    scene.max[i]
                }
            }))
        })
        .fold(f64::INFINITY, f64::min);
    near.iter().all(|n| (0.0..=nearest).contains(n))
}

/// The cameras as text: one, or two behind a switch.
pub fn cameras(eyes: &[Eye], frame: &Frame, captions: &Captions) -> String {
    let mut out = String::new();
    let place = frame.modifiers();
    for (i, eye) in eyes.iter().enumerate() {
        let lens = &eye.lens;
        let comment = match eye.camera.id {
            0 => " // the scene has no camera".to_owned(),
            id => format!(" // {}", entity(id, captions)),
        };
        let (kind, shift) = match lens.parallel {
            true => ("  orthographic\n", lens.shift()),
            false => ("", String::new()),
        };
        let text = format!(
            "camera {{{comment}\n{kind}  location {}\n  direction {}\n  right {}\n  up {}\n{shift}  {place}\n}}\n",
            vector(&lens.location),
            vector(&clean(lens.direction)),
            vector(&clean(lens.right)),
            vector(&clean(lens.up)),
        );
        out.push_str(&if eyes.len() > 1 {
            format!("#if (Eye = {i})\n{text}#end\n")
        } else {
            text
        });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let lens = projecting(&clip_to_scene(&projection, &camera, &basis).unwrap()).unwrap();
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
