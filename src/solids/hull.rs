//! Convex hulls of shapes, from outside: a few points whose hull holds all of a shape.

use crate::scene::{Geometry, Vec3};
use crate::solids::definite::is_ellipsoid;

/// Corners of the polygon around a circle.
const CORNERS: usize = 64;

/// Profiles with more points are not looked at.
const PROFILE_MAX: usize = 64;

/// Points, in the shape's coordinates, between which all of a shape lies: the corners of those that
/// have some, polygons around circles. `None` where balls and boxes serve as well.
pub fn hull(geometry: &Geometry) -> Option<Vec<Vec3>> {
    let mut out = Vec::new();
    let mut rim = |radius: f64, y: f64| out.extend(circle(radius, y));
    match geometry {
        Geometry::Box { min, max } => {
            let corner =
                |k: usize| std::array::from_fn(|i| if k >> i & 1 == 0 { min[i] } else { max[i] });
            out.extend((0..8).map(corner));
        }
        Geometry::Cone { height, radius } => {
            rim(*radius, *height);
            out.push([0.0; 3]);
        }
        Geometry::DoubleCone { height, radius } => {
            rim(*radius, *height);
            rim(*radius, -height);
        }
        Geometry::Torus { major, minor } => {
            rim(major + minor, *minor);
            rim(major + minor, -minor);
        }
        Geometry::Revolution { profile, .. } if profile.len() <= PROFILE_MAX => {
            profile.iter().for_each(|p| rim(p[0], p[1]));
        }
        _ => return None,
    }
    Some(out)
}

/// Points between which all of the ball of radius 1 at the origin lies.
pub fn ball_hull() -> Vec<Vec3> {
    /// Corners of the polygon around a half circle from pole to pole.
    const HALF: usize = 12;
    let step = std::f64::consts::PI / HALF as f64;
    let reach = 1.0 / (step / 2.0).cos();
    let rims = (0..HALF).flat_map(|i| {
        let (x, y) = (step * (i as f64 + 0.5)).sin_cos();
        circle(reach * x, reach * y)
    });
    rims.collect()
}

/// The corners of a polygon around a circle about the y axis.
fn circle(radius: f64, y: f64) -> impl Iterator<Item = Vec3> {
    let radius = radius / (std::f64::consts::PI / CORNERS as f64).cos();
    (0..CORNERS).map(move |i| {
        let angle = i as f64 * (std::f64::consts::TAU / CORNERS as f64);
        [radius * angle.cos(), y, radius * angle.sin()]
    })
}

/// Whether a shape is a solid that holds every point between two of its points.
pub fn is_convex(geometry: &Geometry) -> bool {
    match geometry {
        Geometry::HalfSpace(_)
        | Geometry::Sphere { .. }
        | Geometry::Ellipsoid { .. }
        | Geometry::Box { .. }
        | Geometry::GeodesicSphere { .. }
        | Geometry::Cone { .. }
        | Geometry::ParabolicCylinder { .. } => true,
        Geometry::Revolution { profile, .. } => is_convex_profile(profile),
        Geometry::Quadric(q) => is_ellipsoid(q),
        _ => false,
    }
}

/// Whether a profile that ends at the axis, or is closed by discs, goes one way along it and turns to
/// one side only.
fn is_convex_profile(profile: &[[f64; 2]]) -> bool {
    let (first, last) = (profile[0], profile[profile.len() - 1]);
    if first[1] == last[1] || profile.len() > PROFILE_MAX {
        return false;
    }
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let points: Vec<[f64; 2]> = [&ends[..1], profile, &ends[1..]].concat();
    let up = last[1] > first[1];
    let along = points
        .windows(2)
        .all(|w| w[0][1] == w[1][1] || (w[1][1] > w[0][1]) == up);
    let turns = points.windows(3).all(|w| {
        let side = |i: usize| [w[i + 1][0] - w[i][0], w[i + 1][1] - w[i][1]];
        let ([a, b], [c, d]) = (side(0), side(1));
        if up {
            a * d - b * c >= 0.0
        } else {
            a * d - b * c <= 0.0
        }
    });
    along && turns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Aabb, Matrix};
    use crate::scene::bounds::shape_bounds;

    #[test]
    fn profiles() {
        let convex = |p: &[[f64; 2]]| {
            let turned: Vec<[f64; 2]> = p.iter().rev().copied().collect();
            assert_eq!(is_convex_profile(p), is_convex_profile(&turned), "{p:?}");
            is_convex_profile(p)
        };
        assert!(convex(&[[1.0, 0.0], [1.0, 2.0]]));
        assert!(convex(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]]));
        assert!(convex(&[[0.5, 0.0], [1.0, 1.0], [0.0, 2.0]]));
        // A waist, an edge that hangs down, a ring, a hollow from above.
        assert!(!convex(&[[1.0, 0.0], [0.5, 1.0], [1.0, 2.0]]));
        assert!(!convex(&[[1.0, 0.0], [2.0, -1.0], [1.0, 2.0]]));
        assert!(!convex(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.0]]));
        assert!(!convex(&[[1.0, 0.0], [1.0, 2.0], [0.0, 1.0]]));
        // Level all along: no inside.
        assert!(!convex(&[[1.0, 0.0], [0.0, 0.0], [2.0, 0.0]]));
    }

    /// In every direction the hull goes at least as far as the shape, whose box is exact.
    #[test]
    fn hulls_hold_their_shapes() {
        let shapes = [
            Geometry::Box {
                min: [-1.0, 0.0, 2.0],
                max: [1.0, 3.0, 2.5],
            },
            Geometry::Torus {
                major: 2.0,
                minor: 0.5,
            },
            Geometry::Cone {
                height: -2.0,
                radius: 0.7,
            },
            Geometry::DoubleCone {
                height: 2.0,
                radius: 0.7,
            },
            Geometry::Revolution {
                profile: vec![[0.0, -1.0], [2.0, 0.0], [1.0, 2.0]],
                colours: Vec::new(),
            },
        ];
        for (i, g) in shapes.iter().enumerate() {
            let turn = 23.0 * i as f64;
            let m = Matrix::rotation(turn, 0).after(&Matrix::rotation(turn + 5.0, 2));
            let points = hull(g).unwrap();
            let around = points.iter().fold(Aabb::EMPTY, |b, p| {
                let p = m.point(*p);
                b.hull(&Aabb::new(p, p))
            });
            let own = shape_bounds(g, &m);
            for k in 0..3 {
                let slack = 1e-12;
                assert!(around.min[k] <= own.min[k] + slack && own.max[k] <= around.max[k] + slack);
            }
        }
    }
}
