//! Points where shapes reach furthest, on their surface and known exactly.

use std::cell::Cell;

use super::extent::beyond;
use super::shapes::facts::{Facts, Support};
use crate::geometry::Matrix;
use crate::geometry::array::dot;
use crate::scene::{Geometry, Vec3, Volume};

/// The most corrections of a direction outwards. After each one the point is at least as far out. For shapes with
/// corners, two or three are enough.
const STEPS: usize = 12;

/// Points of a moved shape that may reach out of a volume, one for each of the [`directions`]; none for planes,
/// half-spaces and quadrics. For a box they are the points that reach furthest. Each question about a direction takes
/// one from `left`. When `left` is 0, there are no more points.
pub fn support_points<'a>(
    geometry: &'a Geometry,
    m: &'a Matrix,
    volume: &'a Volume,
    directions: &'a [Vec3],
    left: &'a Cell<usize>,
) -> impl Iterator<Item = Support> + 'a {
    let ask = move |d: Vec3| {
        left.set(left.get().checked_sub(1)?);
        moved_support(geometry, m, d)
    };
    let reach = move |d: Vec3| {
        let mut support = ask(d)?;
        if let Volume::Sphere { centre, .. } = volume {
            // The point that is furthest in the direction of the last point is not nearer.
            for _ in 0..STEPS {
                let way = std::array::from_fn(|i| support.point[i] - centre[i]);
                let next = ask(way)?;
                if beyond(volume, next.point) <= beyond(volume, support.point) {
                    break;
                }
                support = next;
            }
        }
        Some(support)
    };
    directions.iter().copied().filter_map(reach)
}

/// The least and the largest dot product of a moved shape's points with a direction. `None` for planes, half-spaces and
/// quadrics.
pub fn extent(geometry: &Geometry, m: &Matrix, d: Vec3) -> Option<(f64, f64)> {
    let along = |d: Vec3| Some(dot(moved_support(geometry, m, d)?.point, d));
    Some((-along(d.map(|x| -x))?, along(d)?))
}

/// Directions in which a shape may reach beyond a volume: towards the sides of a box; for a sphere towards the sides,
/// edges and corners of a cube.
pub fn directions(volume: &Volume) -> Vec<Vec3> {
    let part = |k: usize| (k % 3) as f64 - 1.0;
    let all = (0..27).map(|k| [part(k), part(k / 3), part(k / 9)]);
    let axes = |v: &Vec3| v.iter().filter(|x| **x != 0.0).count();
    let most = match volume {
        Volume::Box { .. } => 1,
        Volume::Sphere { .. } => 3,
    };
    all.filter(|v| (1..=most).contains(&axes(v))).collect()
}

/// The point of a moved shape that is furthest in a direction.
fn moved_support(geometry: &Geometry, m: &Matrix, d: Vec3) -> Option<Support> {
    let local = std::array::from_fn(|j| (0..3).map(|i| m.0[i][j] * d[i]).sum());
    let support = geometry.support(local)?;
    Some(Support {
        point: m.point(support.point),
        inwards: support.inwards.map(|v| m.vector(v)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::solids::inside::Inside;
    use crate::testing::solids;

    /// Boxes of shapes are exact, so that the support points must lie on their sides; and the way inwards leads
    /// in, the other way out.
    #[test]
    fn support_points_lie_where_the_bounds_end() {
        let m = Matrix::rotation(37.0, 2)
            .after(&Matrix::rotation(20.0, 0))
            .after(&Matrix::scaling(1.0, 2.0, 0.5));
        let scene = Scene::default();
        let mut inside = Inside::new(&scene, &[]);
        let back = m.inverse().unwrap();
        for g in solids() {
            let bounds = g.bounds(&m);
            for i in 0..3 {
                let d = std::array::from_fn(|k| f64::from(u8::from(k == i)));
                let (low, high) = extent(&g, &m, d).unwrap();
                let off = (low - bounds.min[i])
                    .abs()
                    .max((high - bounds.max[i]).abs());
                assert!(off < 1e-12, "{g:?} {i}: {low} {high} {bounds:?}");
                let support = moved_support(&g, &m, d).unwrap();
                let step = |by: f64| {
                    let v = support.inwards.unwrap();
                    back.point(std::array::from_fn(|k| support.point[k] + by * v[k]))
                };
                assert_eq!(inside.shape(&g, step(1e-6)), Some(true), "{g:?}");
                assert_eq!(inside.shape(&g, step(-1e-6)), Some(false), "{g:?}");
            }
        }
    }

    #[test]
    fn the_furthest_from_a_point() {
        let ball = |radius| Volume::Sphere {
            centre: [0.0; 3],
            radius,
        };
        let cube = Geometry::Box {
            min: [-1.0; 3],
            max: [1.0, 1.0, 2.0],
        };
        let m = Matrix::rotation(30.0, 1);
        let best = |g: &Geometry| {
            let from = ball(0.0);
            let directions = directions(&from);
            let left = Cell::new(1000);
            let all = support_points(g, &m, &from, &directions, &left);
            all.fold(0.0f64, |b, t| b.max(beyond(&from, t.point)))
        };
        assert!((best(&cube) - 6f64.sqrt()).abs() < 1e-12);
        let long = Geometry::Ellipsoid {
            semi_axes: [1.0, 1.1, 3.0],
        };
        assert!((best(&long) - 3.0).abs() < 1e-3, "{}", best(&long));
    }
}
