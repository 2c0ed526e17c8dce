//! W322: lengths in one object that differ too much for its numbers.

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::geometry::Matrix;
use crate::lint::spelling::rough;
use crate::lint::{Context, live_nodes};
use crate::scene::{Geometry, Node, Shape};

/// The largest ratio of two lengths: of the sixteen digits of a double, half are then left for the
/// smaller one, and squares of such numbers, which every curved surface asks for, have none left.
const RATIO_MAX: f64 = 1e8;

/// A length of a shape and what it is.
#[derive(Debug, Clone, Copy)]
struct Length {
    size: f64,
    what: &'static str,
    /// The axis of the shape along which it lies, where the others come out differently.
    axis: Option<usize>,
}

/// How much two axes must differ in stretch for a length to be told with its axis: lengths are told
/// in four digits, and what is the same in all of them needs no axis.
const UNEVEN: f64 = 1.001;

const AXES: [&str; 3] = ["x", "y", "z"];

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let mut spoken = vec![false; scene.shapes.len()];
    for (i, shape) in scene.shapes.iter().enumerate() {
        if let Some((small, large)) = extremes(&shape.geometry, &Matrix::IDENTITY) {
            spoken[i] = true;
            out.push(finding(context, shape, small, large));
        }
    }
    // Shapes that come out like that only by what moves and stretches them.
    if scene.matrices.is_empty() {
        return;
    }
    for (node, _) in scene.nodes.iter().zip(live_nodes(scene)).filter(|n| n.1) {
        if let Node::Transform { child, matrix } = *node
            && let Node::Shape(s) = scene.nodes[child as usize]
            && !spoken[s as usize]
            && let Some((small, large)) = extremes(
                &scene.shapes[s as usize].geometry,
                &scene.matrices[matrix as usize],
            )
        {
            spoken[s as usize] = true;
            let shape = &scene.shapes[s as usize];
            let finding = finding(context, shape, small, large);
            out.push(match (small.axis, large.axis) {
                (Some(s), Some(l)) => finding
                    .case("stretched")
                    .with("small-axis", AXES[s])
                    .with("large-axis", AXES[l]),
                _ => finding.case("moved"),
            });
        }
    }
}

fn finding(context: &Context, shape: &Shape, small: Length, large: Length) -> Diagnostic {
    let span = context
        .params(shape.span)
        .map_or(shape.span, |p| p.span_of(0, p.len()));
    Diagnostic::new(Code::W322, span)
        .with("type", Value::Term(shape.ty.title))
        .with("id", shape.id.to_string())
        .with("large", Value::Term(large.what))
        .with("large-size", rough(large.size))
        .with("small", Value::Term(small.what))
        .with("small-size", rough(small.size))
}

/// The smallest and the largest length of a shape moved by a matrix, where they are too different.
fn extremes(geometry: &Geometry, m: &Matrix) -> Option<(Length, Length)> {
    if let (Geometry::Sphere { centre, radius }, true) = (geometry, *m == Matrix::IDENTITY) {
        // Nearly all spheres are not far away in any direction.
        const FAR: f64 = RATIO_MAX / 2.0;
        if *radius > 0.0 && centre.iter().all(|x| x.abs() < FAR * radius) {
            return None;
        }
    }
    let mut small: Option<Length> = None;
    let mut large: Option<Length> = None;
    lengths(geometry, m, &mut |size, what, axis| {
        // A length of zero is another rule's matter.
        if size > 0.0 && size.is_finite() {
            if small.is_none_or(|s| size < s.size) {
                small = Some(Length { size, what, axis });
            }
            if large.is_none_or(|l| size > l.size) {
                large = Some(Length { size, what, axis });
            }
        }
    });
    let (small, mut large) = (small?, large?);
    // How far away it is counts as a length too, but never as the small one.
    if let Some(p) = place(geometry) {
        let [x, y, z] = m.point(p);
        let size = x.hypot(y).hypot(z);
        if size.is_finite() && size > large.size {
            let what = "its distance from the origin";
            large = Length {
                size,
                what,
                axis: None,
            };
        }
    }
    (large.size / small.size > RATIO_MAX).then_some((small, large))
}

/// Some point of the shape.
fn place(geometry: &Geometry) -> Option<[f64; 3]> {
    match geometry {
        Geometry::Sphere { centre, .. } => Some(*centre),
        // The corner that is nearest to the origin.
        Geometry::Box { min, max } => Some(std::array::from_fn(|i| 0f64.clamp(min[i], max[i]))),
        Geometry::Rectangle { min, max } => {
            Some([0f64.clamp(min[0], max[0]), 0f64.clamp(min[1], max[1]), 0.0])
        }
        Geometry::Triangle { vertices, .. } => Some(vertices[0]),
        Geometry::Revolution { profile, .. } => profile.first().map(|p| [0.0, p[1], 0.0]),
        Geometry::Plane(_) | Geometry::HalfSpace(_) | Geometry::Quadric(_) => None,
        _ => Some([0.0; 3]),
    }
}

type Add<'a> = &'a mut dyn FnMut(f64, &'static str, Option<usize>);

fn lengths(geometry: &Geometry, m: &Matrix, add: Add) {
    // How much longer the matrix makes what lies along an axis.
    let stretch: [f64; 3] = std::array::from_fn(|j| m.0[0][j].hypot(m.0[1][j]).hypot(m.0[2][j]));
    let (least, most) = stretch
        .iter()
        .fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
    let uneven = most > UNEVEN * least;
    let told = |i: usize| uneven.then_some(i);
    let mut axes =
        |sizes: [f64; 3], what: [&'static str; 3], told: &dyn Fn(usize) -> Option<usize>| {
            for i in 0..3 {
                add(sizes[i] * stretch[i], what[i], told(i));
            }
        };
    // Sizes that have an axis in their name.
    let named = |_| None;
    const RADIUS: &str = "its radius";
    match geometry {
        Geometry::Sphere { radius, .. } | Geometry::GeodesicSphere { radius, .. } => {
            axes([*radius; 3], [RADIUS; 3], &told);
        }
        Geometry::Ellipsoid { semi_axes } => axes(
            *semi_axes,
            ["its semi-axis a", "its semi-axis b", "its semi-axis c"],
            &named,
        ),
        Geometry::Box { min, max } => axes(
            std::array::from_fn(|i| max[i] - min[i]),
            ["its width in x", "its height in y", "its depth in z"],
            &named,
        ),
        Geometry::Rectangle { min, max } => axes(
            [max[0] - min[0], max[1] - min[1], 0.0],
            ["its width in x", "its height in y", ""],
            &named,
        ),
        Geometry::Torus { major, minor } => {
            axes([*major, 0.0, *major], ["its ring's radius R"; 3], &told);
            axes([*minor; 3], ["its tube's radius r"; 3], &told);
        }
        Geometry::Cone { height, radius } | Geometry::DoubleCone { height, radius } => axes(
            [*radius, height.abs(), *radius],
            [RADIUS, "its height", RADIUS],
            &told,
        ),
        Geometry::ParabolicCylinder { a } => axes([*a, 0.0, 0.0], ["its half width a"; 3], &named),
        Geometry::HyperbolicCylinder { a, b } => axes(
            [*a, *b, 0.0],
            ["its semi-axis a", "its semi-axis b", ""],
            &named,
        ),
        Geometry::Hyperboloid { a, b, c, .. } => axes(
            [*a, *b, *c],
            ["its semi-axis a", "its semi-axis b", "its semi-axis c"],
            &named,
        ),
        Geometry::HyperbolicParaboloid { a, b } => axes(
            [*a, 0.0, *b],
            ["its half width a", "", "its half width b"],
            &named,
        ),
        Geometry::Triangle { vertices, .. } => {
            let [a, b, c] = vertices.map(|v| m.point(v));
            let distance =
                |p: [f64; 3], q: [f64; 3]| (p[0] - q[0]).hypot(p[1] - q[1]).hypot(p[2] - q[2]);
            for (p, q) in [(a, b), (b, c), (c, a)] {
                add(distance(p, q), "an edge", None);
            }
        }
        Geometry::Revolution { profile, .. } => {
            for axis in [0, 2] {
                let radial = stretch[axis];
                for p in profile {
                    add(p[0] * radial, "a radius of its profile", told(axis));
                }
                for w in profile.windows(2) {
                    let (dx, dy) = (
                        (w[1][0] - w[0][0]) * radial,
                        (w[1][1] - w[0][1]) * stretch[1],
                    );
                    add(dx.hypot(dy), "a piece of its profile", None);
                }
            }
        }
        Geometry::Plane(_) | Geometry::HalfSpace(_) | Geometry::Quadric(_) => {}
    }
}
