//! Where shapes reach furthest: points of their surface, known exactly.

use std::cell::Cell;

use super::extent::beyond;
use crate::geometry::array::dot;
use crate::geometry::{Matrix, icosahedron};
use crate::scene::{Geometry, Vec3, Volume};

/// A point of a shape's surface.
#[derive(Debug, Clone, Copy)]
pub struct Support {
    pub point: Vec3,
    /// A way from there into the shape, of any length; `None` for surfaces.
    pub inwards: Option<Vec3>,
}

/// How often a way outwards is corrected: each time the point found is at least as far out, and with
/// corners it is there after two or three times.
const STEPS: usize = 12;

/// Points of a moved shape that reach out of a volume, looked for along its [`directions`]; none for shapes
/// without end. Of a box they are those that reach furthest. Each direction asked for is taken from what
/// is `left`; where nothing is, there are no more.
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
            // What is furthest along the way to the furthest point so far is not nearer.
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

/// How far a moved shape goes in a direction, as the least and the largest product with it; `None` for
/// shapes without end.
pub fn extent(geometry: &Geometry, m: &Matrix, d: Vec3) -> Option<(f64, f64)> {
    let along = |d: Vec3| Some(dot(moved_support(geometry, m, d)?.point, d));
    Some((-along(d.map(|x| -x))?, along(d)?))
}

/// Where to look for what reaches beyond a volume: towards the sides of a box, and all around a sphere
/// towards the sides, edges and corners of one.
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
    let support = support(geometry, local)?;
    Some(Support {
        point: m.point(support.point),
        inwards: support.inwards.map(|v| m.vector(v)),
    })
}

/// The point of a shape that is furthest in a direction, in the shape's coordinates. Of a geodesic
/// sphere it is the corner that lies next to it.
fn support(geometry: &Geometry, d: Vec3) -> Option<Support> {
    let towards = |point: Vec3, middle: Vec3| Support {
        point,
        inwards: Some(std::array::from_fn(|i| middle[i] - point[i])),
    };
    let sheet = |point: Vec3| Support {
        point,
        inwards: None,
    };
    let side = |low: f64, high: f64, up: f64| if up < 0.0 { low } else { high };
    let rim = |radius: f64, y: f64| {
        let [x, z] = unit([d[0], d[2]]);
        [radius * x, y, radius * z]
    };
    Some(match geometry {
        Geometry::Sphere { centre, radius } => {
            let n = unit(d);
            towards(std::array::from_fn(|i| centre[i] + radius * n[i]), *centre)
        }
        Geometry::Ellipsoid { semi_axes } => {
            let n: Vec3 = unit(std::array::from_fn(|i| semi_axes[i] * d[i]));
            towards(std::array::from_fn(|i| semi_axes[i] * n[i]), [0.0; 3])
        }
        Geometry::GeodesicSphere { radius, splits } => {
            towards(geodesic_corner(d, *splits).map(|x| radius * x), [0.0; 3])
        }
        Geometry::Box { min, max } => towards(
            std::array::from_fn(|i| side(min[i], max[i], d[i])),
            std::array::from_fn(|i| min[i] / 2.0 + max[i] / 2.0),
        ),
        Geometry::Rectangle { min, max } => {
            sheet([side(min[0], max[0], d[0]), side(min[1], max[1], d[1]), 0.0])
        }
        Geometry::Triangle { vertices, .. } => {
            let far = |a: &&Vec3, b: &&Vec3| dot(**a, d).total_cmp(&dot(**b, d));
            sheet(*vertices.iter().max_by(far)?)
        }
        Geometry::Torus { major, minor } => {
            let (core, n) = (rim(*major, 0.0), unit(d));
            towards(std::array::from_fn(|i| core[i] + minor * n[i]), core)
        }
        Geometry::Cone { height, radius } => {
            let base = rim(*radius, *height);
            let point = if dot(base, d) > 0.0 { base } else { [0.0; 3] };
            towards(point, [0.0, 0.75 * height, 0.0])
        }
        Geometry::DoubleCone { height, radius } => {
            let y = side(-height, *height, d[1]);
            towards(rim(*radius, y), [0.0, 0.75 * y, 0.0])
        }
        Geometry::Revolution { profile, .. } => {
            let out = d[0].hypot(d[2]);
            let far = |p: &[f64; 2]| out * p[0] + d[1] * p[1];
            let indices = 0..profile.len();
            let i = indices.max_by(|&i, &j| far(&profile[i]).total_cmp(&far(&profile[j])))?;
            let [x, y] = profile[i];
            let point = rim(x, y);
            // Half-way between the two pieces that meet there.
            let [a, b] = neighbours(profile, i).map(|q| unit([q[0] - x, q[1] - y]));
            let [out, _, side] = rim(1.0, 0.0);
            let inwards = [out * (a[0] + b[0]), a[1] + b[1], side * (a[0] + b[0])];
            Support {
                point,
                inwards: Some(inwards),
            }
        }
        _ => return None,
    })
}

/// The points before and behind one of a profile, closed over the axis or in itself.
fn neighbours(profile: &[[f64; 2]], i: usize) -> [[f64; 2]; 2] {
    let last = profile.len() - 1;
    let ring = profile[0] == profile[last];
    let [x, y] = profile[i];
    // On the axis the other side is the mirror image.
    let closed = |other: usize| match x {
        0.0 => [-profile[other][0], profile[other][1]],
        _ => [0.0, y],
    };
    let before = match i {
        0 if ring => profile[last.saturating_sub(1)],
        0 => closed(1.min(last)),
        i => profile[i - 1],
    };
    let behind = match i {
        i if i == last && ring => profile[1.min(last)],
        i if i == last => closed(last.saturating_sub(1)),
        i => profile[i + 1],
    };
    [before, behind]
}

/// The corner next to a direction, of the sphere of radius 1.
fn geodesic_corner(d: Vec3, splits: u32) -> Vec3 {
    let mut corners = icosahedron::vertices();
    let nearest_first = |a: &Vec3, b: &Vec3| dot(*b, d).total_cmp(&dot(*a, d));
    corners.sort_by(nearest_first);
    // The facet that the direction goes through, then the one of its four parts.
    let first = corners[0];
    let next_to = |a: Vec3, b: &Vec3| dot(a, *b) > 0.4 && dot(a, *b) < 0.9;
    let second = corners.iter().copied().find(|c| next_to(first, c));
    let second = second.unwrap_or(first);
    let third = (corners.iter().copied()).find(|c| next_to(first, c) && next_to(second, c));
    let mut facet = [first, second, third.unwrap_or(second)];
    for _ in 0..splits {
        let [a, b, c] = facet;
        let middle = |p: Vec3, q: Vec3| -> Vec3 { unit(std::array::from_fn(|k| p[k] + q[k])) };
        let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
        let along = |f: &[Vec3; 3]| -> f64 {
            dot(
                unit(std::array::from_fn(|k| f[0][k] + f[1][k] + f[2][k])),
                d,
            )
        };
        for part in [[a, p, r], [b, q, p], [c, r, q], [p, q, r]] {
            if facet == [a, b, c] || along(&part) > along(&facet) {
                facet = part;
            }
        }
    }
    facet.sort_by(nearest_first);
    facet[0]
}

/// A vector of length 1 in the same direction; any for one without direction.
fn unit<const N: usize>(v: [f64; N]) -> [f64; N] {
    let largest = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return std::array::from_fn(|i| f64::from(u8::from(i == 0)));
    }
    let v = v.map(|x| x / largest);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::bounds::shape_bounds;
    use crate::solids::inside::Inside;

    fn shapes() -> Vec<Geometry> {
        vec![
            Geometry::Sphere {
                centre: [1.0, 2.0, 3.0],
                radius: 0.5,
            },
            Geometry::Ellipsoid {
                semi_axes: [1.0, 2.0, 3.0],
            },
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
            Geometry::Revolution {
                profile: vec![[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]],
                colours: Vec::new(),
            },
        ]
    }

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
        for g in shapes() {
            let bounds = shape_bounds(&g, &m);
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

    /// The corners of the language's icosahedron, and of what it is split into: all at distance 1, the
    /// nearest one no further than half an edge's length away.
    #[test]
    fn corners_of_geodesic_spheres() {
        let phi = (1.0 + 5f64.sqrt()) / 2.0;
        let first = geodesic_corner([0.1, 1.0, phi], 0);
        let expected = unit([0.0, 1.0, phi]);
        let all_around = Volume::Sphere {
            centre: [0.0; 3],
            radius: 1.0,
        };
        (0..3).for_each(|i| assert!((first[i] - expected[i]).abs() < 1e-15));
        for (splits, near) in [(0, 0.79), (1, 0.93), (2, 0.98), (5, 0.9995)] {
            for d in directions(&all_around) {
                let d = unit([d[0] + 0.1, d[1] + 0.2, d[2] - 0.3]);
                let c = geodesic_corner(d, splits);
                assert!((dot(c, c) - 1.0).abs() < 1e-12);
                assert!(dot(c, d) > near, "{splits} {d:?} {}", dot(c, d));
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
