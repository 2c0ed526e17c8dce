//! Shapes that Mitsuba has itself.

use super::xml;
use crate::geometry::Matrix;
use crate::scene::{Geometry, Scene, Vec3};
use crate::trace::graph::Graph;
use crate::translate::mesh::{SurfaceLabel, picture::is_pictured, shape::flat};

/// A shape of Mitsuba's.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Exact {
    kind: &'static str,
    body: String,
    shape: u32,
    /// The factors and the summands that make the scene's surface coordinates of Mitsuba's; `None` where Mitsuba's are
    /// something else.
    pub uv: Option<[[f64; 2]; 2]>,
}

impl Exact {
    pub(super) fn xml(&self, bsdf: &str, number: usize) -> String {
        format!(
            "  <shape type=\"{}\" id=\"Object_{}_{number}\">\n    {}\n    {bsdf}\n  </shape>\n",
            self.kind, self.shape, self.body
        )
    }
}

/// The middle of the region in which an endless shape is seen, and how far the shape has to reach from there.
#[derive(Debug, Clone, Copy)]
pub(super) struct RequiredExtent {
    pub centre: Vec3,
    pub far: f64,
}

/// Half the side of the middle rectangle of an endless shape, as a fraction of the distance that the shape reaches.
/// This distance is a thousand times the scene's size, so the rectangle holds the scene with room around.
const NEAR_PART: f64 = 1.0 / 32.0;

/// Whether the shape of a skin is a plane or a half-space.
pub(super) fn is_endless(scene: &Scene, graph: &Graph, skin: &SurfaceLabel) -> bool {
    let record = skin.primitive.map(|p| graph.records[p as usize] as usize);
    let geometry = record.map(|record| &scene.shapes[record].geometry);
    matches!(geometry, Some(Geometry::Plane(_) | Geometry::HalfSpace(_)))
}

/// The shapes of Mitsuba's that make up the shape of a skin; `None` if Mitsuba has none, or the skin's colours cannot
/// be laid on them. Planes and half-spaces become rectangles: one, and four around it that reach very far, since
/// Mitsuba's rectangles are as exact as they are small.
pub(super) fn shapes(
    scene: &Scene,
    graph: &Graph,
    skin: &SurfaceLabel,
    view: &RequiredExtent,
) -> Option<Vec<Exact>> {
    let record = graph.records[skin.primitive? as usize] as usize;
    let m = &*skin.matrix;
    let placed = |m: &Matrix| xml::transform("to_world", m);
    let made: Vec<Made> = match scene.shapes[record].geometry {
        Geometry::Sphere { centre, radius } => {
            let scale = m.uniform_scale()?;
            // The poles of Mitsuba's sphere lie on z, those of the scene's on y; the scene's v goes from south to
            // north.
            let turned = Matrix([
                [1.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, -1.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]);
            let turn = Matrix::after(m, &turned);
            let rotation = turn.after(&Matrix::scaling(1.0 / scale, 1.0 / scale, 1.0 / scale));
            let mirrored = rotation.determinant3() < 0.0;
            let mut place = if mirrored { Matrix::IDENTITY } else { rotation };
            let r = scale * radius;
            for (row, at) in place.0.iter_mut().zip(m.point(centre)) {
                row.iter_mut().take(3).for_each(|x| *x *= r);
                row[3] = at;
            }
            let uv = (!mirrored).then_some([[1.0, -1.0], [0.0, 1.0]]);
            vec![("sphere", placed(&place), uv)]
        }
        Geometry::Box { min, max } => {
            let centre: Vec3 = std::array::from_fn(|i| min[i] / 2.0 + max[i] / 2.0);
            let half: Vec3 = std::array::from_fn(|i| max[i] / 2.0 - min[i] / 2.0);
            vec![("cube", placed(&m.after(&at(centre, half))), None)]
        }
        Geometry::Rectangle { min, max } => {
            let centre = [
                min[0] / 2.0 + max[0] / 2.0,
                min[1] / 2.0 + max[1] / 2.0,
                0.0,
            ];
            let half = [
                max[0] / 2.0 - min[0] / 2.0,
                max[1] / 2.0 - min[1] / 2.0,
                1.0,
            ];
            let uv = Some([[1.0; 2], [0.0; 2]]);
            vec![("rectangle", placed(&m.after(&at(centre, half))), uv)]
        }
        Geometry::Plane(plane) | Geometry::HalfSpace(plane) => match m.uniform_scale() {
            Some(scale) => around(&Facing::of(plane), m, scale, view),
            // The placed shape is still a plane, but with other surface coordinates.
            None => {
                let facing = Facing::of(placed_plane(plane, m)?);
                let plain = around(&facing, &Matrix::IDENTITY, 1.0, view);
                plain
                    .into_iter()
                    .map(|(kind, body, _)| (kind, body, None))
                    .collect()
            }
        },
        // Mitsuba may have others of these shapes, too, but as meshes they are right.
        _ => return None,
    };
    let plain = skin.plain_colour(graph).is_some();
    let exact = |(kind, body, uv)| Exact {
        kind,
        body,
        shape: skin.shape,
        uv,
    };
    let out: Vec<Exact> = made.into_iter().map(exact).collect();
    (plain || is_pictured(skin, graph) && out.iter().all(|e| e.uv.is_some())).then_some(out)
}

/// A plane, and the directions of its surface coordinates.
struct Facing {
    normal: Vec3,
    /// The point nearest to the origin.
    foot: Vec3,
    u: Vec3,
    v: Vec3,
}

impl Facing {
    fn of([a, b, c, d]: [f64; 4]) -> Facing {
        let length = a.hypot(b).hypot(c);
        let normal = [a, b, c].map(|x| x / length);
        // The language's own bound for planes that lie flat.
        let up = if normal[1].abs() > 0.999 {
            [0.0, 0.0, -1.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        let u = flat::normal_to(up, normal);
        Facing {
            normal,
            foot: normal.map(|x| -d / length * x),
            u,
            v: flat::normal_to(normal, u),
        }
    }
}

/// The plane that a plane becomes when it is placed by `m`; `None` if `m` has no inverse.
fn placed_plane(plane: [f64; 4], m: &Matrix) -> Option<[f64; 4]> {
    let back = m.inverse()?;
    Some(std::array::from_fn(|k| {
        (0..4).map(|i| plane[i] * back.0[i][k]).sum()
    }))
}

/// A shape before it has its name: kind, body, and the factors and summands of its surface coordinates, as in
/// `Exact::uv`.
type Made = (&'static str, String, Option<[[f64; 2]; 2]>);

/// A plane as five rectangles about the place where it is seen. The matrix `m` places them and makes all lengths
/// `scale` times as long.
fn around(plane: &Facing, m: &Matrix, scale: f64, view: &RequiredExtent) -> Vec<Made> {
    let Facing { normal, foot, u, v } = *plane;
    let back = m.inverse().unwrap_or(Matrix::IDENTITY);
    let seen = back.point(view.centre);
    let along = |axis: Vec3| (0..3).map(|i| (seen[i] - foot[i]) * axis[i]).sum::<f64>();
    let far = view.far / scale;
    let near = NEAR_PART * far;
    // If the place is near the plane's foot, the rectangles are centred there.
    let from = [u, v]
        .map(along)
        .map(|x| if x.abs() < near { 0.0 } else { x });
    let (middle, half) = ((far + near) / 2.0, (far - near) / 2.0);
    let strip = |[x, y]: [f64; 2], [p, q]: [f64; 2]| {
        let [x, y] = [from[0] + x, from[1] + y];
        let mut frame = Matrix::IDENTITY;
        for i in 0..3 {
            frame.0[i] = [u[i] * p, v[i] * q, normal[i], foot[i] + x * u[i] + y * v[i]];
        }
        let uv = Some([[2.0 * p, 2.0 * q], [x - p, y - q]]);
        (
            "rectangle",
            xml::transform("to_world", &m.after(&frame)),
            uv,
        )
    };
    vec![
        strip([0.0; 2], [near; 2]),
        strip([middle, 0.0], [half, far]),
        strip([-middle, 0.0], [half, far]),
        strip([0.0, middle], [near, half]),
        strip([0.0, -middle], [near, half]),
    ]
}

fn at(centre: Vec3, half: Vec3) -> Matrix {
    Matrix::translation(centre[0], centre[1], centre[2])
        .after(&Matrix::scaling(half[0], half[1], half[2]))
}
