//! Crossings of lines with shapes, by formulas with coefficients from the ray's own origin.

use super::boxes::{Bounds, Boxes};
use super::number::{Number, Ray, V, add, cross, dot, scale, sub, unit, vector};
use super::polynomial::{Few, quadratic, quartic};
use crate::geometry::array::each;
use crate::scene::{Geometry, Rgb, TriangleNormals};
use std::f64::consts::{PI, TAU};

/// A shape in numbers of one kind.
pub enum NaiveShape<T> {
    Sphere {
        centre: V<T>,
        radius: T,
    },
    Box([V<T>; 2]),
    Torus {
        major: T,
        minor: T,
    },
    Plane {
        normal: V<T>,
        d: T,
        solid: bool,
    },
    Rectangle([[T; 2]; 2]),
    Triangle([V<T>; 3]),
    /// The quadric xᵀQx = 0, with x = (x, y, z, 1).
    Quadric([[T; 4]; 4]),
    /// The pieces of the profile, each between two points (radius, height), then the discs that close the ends.
    Revolution(Vec<[[T; 2]; 2]>),
    Geodesic {
        facets: Vec<[V<T>; 3]>,
        boxes: Boxes,
    },
}

/// All crossings of a line with a shape, ascending.
#[derive(Debug, Clone)]
pub struct Roots<T> {
    /// Whether the line is inside of the shape before its first crossing.
    pub inside: bool,
    /// For each crossing, t on the line and the number of the face.
    pub list: Vec<(T, u32)>,
}

impl<T> Default for Roots<T> {
    fn default() -> Roots<T> {
        Roots {
            inside: false,
            list: Vec::new(),
        }
    }
}

/// The largest number of splits of a geodesic sphere whose facets can be listed.
pub const MAX_SPLITS: u32 = 6;

impl<T: Number> NaiveShape<T> {
    /// Makes the shape of a geometry; `None` for a geodesic sphere with too many facets.
    pub fn new(geometry: &Geometry) -> Option<NaiveShape<T>> {
        let n = T::of;
        let points = |profile: &[[f64; 2]]| {
            let point = |p: [f64; 2]| p.map(T::of);
            let mut pieces: Vec<_> = (profile.windows(2))
                .map(|w| [point(w[0]), point(w[1])])
                .collect();
            if let (Some(&first), Some(&last)) = (profile.first(), profile.last())
                && first != last
            {
                for end in [first, last] {
                    pieces.push([[n(0.0), n(end[1])], point(end)]);
                }
            }
            NaiveShape::Revolution(pieces)
        };
        let one = n(1.0);
        let squared = |x: f64| n(x) * n(x);
        let over = |x: f64| one / squared(x);
        Some(match geometry {
            Geometry::Sphere { centre, radius } => NaiveShape::Sphere {
                centre: vector(*centre),
                radius: n(*radius),
            },
            Geometry::Box { min, max } => NaiveShape::Box([vector(*min), vector(*max)]),
            Geometry::Torus { major, minor } => NaiveShape::Torus {
                major: n(*major),
                minor: n(*minor),
            },
            Geometry::Plane(p) | Geometry::HalfSpace(p) => NaiveShape::Plane {
                normal: vector([p[0], p[1], p[2]]),
                d: n(p[3]),
                solid: geometry.is_solid(),
            },
            Geometry::Rectangle { min, max } => NaiveShape::Rectangle([min.map(n), max.map(n)]),
            Geometry::Triangle { vertices, .. } => NaiveShape::Triangle(vertices.map(vector)),
            Geometry::Revolution { profile, .. } => points(profile),
            Geometry::Cone { height, radius } => points(&[[0.0, 0.0], [*radius, *height]]),
            Geometry::DoubleCone { height, radius } => {
                points(&[[*radius, -height], [0.0, 0.0], [*radius, *height]])
            }
            Geometry::Ellipsoid {
                semi_axes: [a, b, c],
            } => diagonal([over(*a), over(*b), over(*c)], 0.0, -1.0),
            Geometry::Quadric(m) => NaiveShape::Quadric(std::array::from_fn(|i| {
                std::array::from_fn(|j| n(m[4 * i + j]))
            })),
            Geometry::ParabolicCylinder { a } => diagonal([over(*a), n(0.0), n(0.0)], -1.0, 0.0),
            Geometry::HyperbolicCylinder { a, b } => {
                diagonal([over(*a), -over(*b), n(0.0)], 0.0, -1.0)
            }
            Geometry::Hyperboloid { a, b, c, sheets } => {
                let constant = if *sheets == 1 { -1.0 } else { 1.0 };
                diagonal([over(*a), -over(*b), over(*c)], 0.0, constant)
            }
            Geometry::HyperbolicParaboloid { a, b } => {
                diagonal([over(*a), n(0.0), -over(*b)], -1.0, 0.0)
            }
            Geometry::GeodesicSphere { splits, .. } if *splits > MAX_SPLITS => return None,
            Geometry::GeodesicSphere { radius, splits } => geodesic(n(*radius), *splits),
        })
    }

    /// Finds all crossings of a ray's line with the shape, into `roots`.
    pub fn cross(&self, ray: &Ray<T>, roots: &mut Roots<T>) {
        roots.list.clear();
        roots.inside = false;
        let (o, d) = (ray.origin, ray.direction);
        let (zero, one) = (T::of(0.0), T::of(1.0));
        match self {
            NaiveShape::Sphere { centre, radius } => {
                let from = sub(o, *centre);
                let a = dot(d, d);
                let b = T::of(2.0) * dot(from, d);
                let c = dot(from, from) - *radius * *radius;
                let mut few = Few::new();
                quadratic(a, b, c, &mut few);
                roots.list.extend(few.all().iter().map(|&t| (t, 0)));
            }
            NaiveShape::Box([min, max]) => slabs(min, max, ray, roots),
            NaiveShape::Torus { major, minor } => {
                let mut few = Few::new();
                torus(*major, *minor, ray, &mut few);
                roots.list.extend(few.all().iter().map(|&t| (t, 0)));
            }
            NaiveShape::Plane {
                normal,
                d: offset,
                solid,
            } => {
                let (slope, value) = (dot(*normal, d), dot(*normal, o) + *offset);
                if slope.abs() >= T::TINY {
                    roots.inside = *solid && slope > zero;
                    roots.list.push((-value / slope, 0));
                } else {
                    roots.inside = *solid && value <= zero;
                }
            }
            NaiveShape::Rectangle([min, max]) => {
                let t = -o[2] / d[2];
                let p = ray.at(t);
                if (0..2).all(|i| p[i] >= min[i] && p[i] <= max[i]) {
                    roots.list.push((t, 0));
                }
            }
            NaiveShape::Triangle(corners) => {
                if let Some(t) = facet(corners, ray) {
                    roots.list.push((t, 0));
                }
            }
            NaiveShape::Quadric(q) => {
                let times = |p: [T; 4], r: [T; 4]| {
                    let row = |i: usize| {
                        (q[i][0] * r[0] + q[i][1] * r[1]) + (q[i][2] * r[2] + q[i][3] * r[3])
                    };
                    p[0] * row(0) + p[1] * row(1) + p[2] * row(2) + p[3] * row(3)
                };
                let (p, r) = ([o[0], o[1], o[2], one], [d[0], d[1], d[2], zero]);
                let (a, b, c) = (times(r, r), times(p, r) + times(r, p), times(p, p));
                // The sign of the form far back on the line tells whether the line comes from inside.
                roots.inside = match () {
                    () if a.abs() >= T::TINY => a < zero,
                    () if b.abs() >= T::TINY => b > zero,
                    () => c <= zero,
                };
                let mut few = Few::new();
                quadratic(a, b, c, &mut few);
                roots.list.extend(few.all().iter().map(|&t| (t, 0)));
            }
            NaiveShape::Revolution(pieces) => {
                for (i, piece) in pieces.iter().enumerate() {
                    segment(piece, ray, i as u32, roots);
                }
            }
            NaiveShape::Geodesic { facets, boxes } => {
                boxes.visit(each(o, T::wide), each(d, T::wide), |i| {
                    if let Some(t) = facet(&facets[i as usize], ray) {
                        roots.list.push((t, i));
                    }
                });
                // Boxes behind the origin are not visited. An odd number of crossings means that the ray starts inside.
                roots.inside = roots.list.len() % 2 == 1;
            }
        }
        roots.list.retain(|root| root.0.wide().is_finite());
        if roots.list.len() > 1 {
            let order = |a: &(T, u32), b: &(T, u32)| a.0.partial_cmp(&b.0);
            roots
                .list
                .sort_by(|a, b| order(a, b).unwrap_or(std::cmp::Ordering::Equal));
        }
    }

    /// The outward normal at a point of a face, of any length.
    pub fn normal(&self, p: V<T>, face: u32) -> V<T> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        match self {
            NaiveShape::Sphere { centre, .. } => sub(p, *centre),
            NaiveShape::Box(_) => {
                let mut normal = [zero; 3];
                normal[face as usize / 2] = if face % 2 == 1 { one } else { -one };
                normal
            }
            // The gradient of the quartic.
            NaiveShape::Torus { major, minor } => {
                let sum = dot(p, p) + *major * *major - *minor * *minor;
                let twice = T::of(2.0) * *major * *major;
                [p[0] * (sum - twice), p[1] * sum, p[2] * (sum - twice)]
            }
            NaiveShape::Plane { normal, .. } => *normal,
            NaiveShape::Rectangle(_) => [zero, zero, one],
            NaiveShape::Triangle([a, b, c]) => cross(sub(*b, *a), sub(*c, *a)),
            NaiveShape::Geodesic { facets, .. } => {
                let [a, b, c] = facets[face as usize];
                cross(sub(b, a), sub(c, a))
            }
            NaiveShape::Quadric(q) => each([0, 1, 2], |i| {
                let p = [p[0], p[1], p[2], one];
                let add = |sum: T, j: usize| sum + (q[i][j] + q[j][i]) * p[j];
                (0..4).fold(zero, add)
            }),
            NaiveShape::Revolution(pieces) => {
                let [[x0, y0], [x1, y1]] = pieces[face as usize];
                if y0 == y1 {
                    return [zero, one, zero];
                }
                let slope = (x1 - x0) / (y1 - y0);
                [p[0], -(slope * (x0 + slope * (p[1] - y0))), p[2]]
            }
        }
    }
}

fn diagonal<T: Number>([a, b, c]: [T; 3], linear: f64, constant: f64) -> NaiveShape<T> {
    let (o, half) = (T::of(0.0), T::of(linear / 2.0));
    NaiveShape::Quadric([
        [a, o, o, o],
        [o, b, o, half],
        [o, o, c, o],
        [o, half, o, T::of(constant)],
    ])
}

/// A crossing: t, and the number of the face.
type Crossing<T> = (T, u32);

fn slabs<T: Number>(min: &V<T>, max: &V<T>, ray: &Ray<T>, roots: &mut Roots<T>) {
    let (mut near, mut far): (Option<Crossing<T>>, Option<Crossing<T>>) = (None, None);
    for i in 0..3 {
        let inverse = T::of(1.0) / ray.direction[i];
        let axis = 2 * i as u32;
        let mut a = ((min[i] - ray.origin[i]) * inverse, axis);
        let mut b = ((max[i] - ray.origin[i]) * inverse, axis + 1);
        if a.0 > b.0 {
            (a, b) = (b, a);
        }
        if near.is_none_or(|(t, _)| a.0 > t) {
            near = Some(a);
        }
        if far.is_none_or(|(t, _)| b.0 < t) {
            far = Some(b);
        }
    }
    if let (Some(near), Some(far)) = (near, far)
        && near.0 <= far.0
    {
        roots.list.extend([near, far]);
    }
}

/// Appends each t at which the ray's line meets the torus (x² + y² + z² + R² − r²)² − 4R²(x² + z²) = 0.
pub fn torus<T: Number>(major: T, minor: T, ray: &Ray<T>, roots: &mut Few<T>) {
    let (o, d) = (ray.origin, ray.direction);
    let two = T::of(2.0);
    let four_squares = T::of(4.0) * major * major;
    let (a, b) = (dot(d, d), two * dot(o, d));
    let c = dot(o, o) + major * major - minor * minor;
    let lead = a * a;
    let across = |p: V<T>, q: V<T>| p[0] * q[0] + p[2] * q[2];
    let coefficients = [
        two * a * b,
        b * b + two * a * c - four_squares * across(d, d),
        two * b * c - two * four_squares * across(o, d),
        c * c - four_squares * across(o, o),
    ];
    quartic(each(coefficients, |x| x / lead), roots);
}

/// Appends the crossings of the ray's line with the cone or the ring that a piece of a profile sweeps around the y
/// axis.
pub fn segment<T: Number>(piece: &[[T; 2]; 2], ray: &Ray<T>, face: u32, roots: &mut Roots<T>) {
    let (o, d) = (ray.origin, ray.direction);
    let [[x0, y0], [x1, y1]] = *piece;
    if y0 == y1 {
        let t = (y0 - o[1]) / d[1];
        let p = ray.at(t);
        let square = p[0] * p[0] + p[2] * p[2];
        let (inner, outer) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
        if square >= inner * inner && square <= outer * outer {
            roots.list.push((t, face));
        }
        return;
    }
    let slope = (x1 - x0) / (y1 - y0);
    let here = x0 + slope * (o[1] - y0);
    let grows = slope * d[1];
    let mut few = Few::new();
    quadratic(
        d[0] * d[0] + d[2] * d[2] - grows * grows,
        T::of(2.0) * (o[0] * d[0] + o[2] * d[2] - here * grows),
        o[0] * o[0] + o[2] * o[2] - here * here,
        &mut few,
    );
    let (low, high) = if y0 < y1 { (y0, y1) } else { (y1, y0) };
    for &t in few.all() {
        let y = ray.at(t)[1];
        // In a textbook both ends belong to a piece; here the upper end belongs to the next piece.
        if y >= low && (y < high || (T::TEXTBOOK && y == high)) {
            roots.list.push((t, face));
        }
    }
}

/// The t at which a ray's line meets a triangle (Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997).
fn facet<T: Number>([a, b, c]: &[V<T>; 3], ray: &Ray<T>) -> Option<T> {
    let (e, f) = (sub(*b, *a), sub(*c, *a));
    let p = cross(ray.direction, f);
    let determinant = dot(e, p);
    let zero = T::of(0.0);
    if determinant == zero {
        return None;
    }
    let inverse = T::of(1.0) / determinant;
    let from = sub(ray.origin, *a);
    let u = dot(from, p) * inverse;
    let q = cross(from, e);
    let v = dot(ray.direction, q) * inverse;
    (u >= zero && v >= zero && u + v <= T::of(1.0)).then(|| dot(f, q) * inverse)
}

/// Makes a geodesic sphere: the facets of an icosahedron are split in four `splits` times, and the new corners are
/// pushed out onto the sphere.
fn geodesic<T: Number>(radius: T, splits: u32) -> NaiveShape<T> {
    let one = T::of(1.0);
    let phi = (one + T::of(5.0).sqrt()) / T::of(2.0);
    let corner = |v: usize| -> V<T> {
        let (axis, signs) = (v / 4, v % 4);
        let mut p = [T::of(0.0); 3];
        p[(axis + 1) % 3] = if signs & 2 != 0 { -one } else { one };
        p[(axis + 2) % 3] = if signs & 1 != 0 { -phi } else { phi };
        unit(p)
    };
    let mut facets: Vec<[V<T>; 3]> = (crate::geometry::icosahedron::FACES.iter())
        .map(|f| each(*f, corner))
        .collect();
    for _ in 0..splits {
        let between = |a, b| unit(add(a, b));
        facets = (facets.into_iter())
            .flat_map(|[a, b, c]| {
                let (ab, bc, ca) = (between(a, b), between(b, c), between(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    for p in facets.iter_mut().flatten() {
        *p = scale(*p, radius);
    }
    let bounds = |f: &[V<T>; 3]| {
        let points = f.map(|p| p.map(T::wide));
        points
            .iter()
            .fold(Bounds::NONE, |b, p| b.around(&Bounds(*p, *p)))
    };
    let boxes = Boxes::new((0..).zip(&facets).map(|(i, f)| (i, bounds(f))).collect());
    NaiveShape::Geodesic { facets, boxes }
}

fn turn(angle: f64) -> f64 {
    angle.rem_euclid(TAU) / TAU
}

/// The surface coordinates (u, v) of a point on a face, as the language defines them.
pub fn uv(geometry: &Geometry, p: [f64; 3], face: u32) -> [f64; 2] {
    let around = || turn((-p[2]).atan2(p[0]));
    let part = |x: f64, min: f64, max: f64| {
        if max > min {
            (x - min) / (max - min)
        } else {
            0.0
        }
    };
    match geometry {
        Geometry::Sphere { centre, radius } => {
            let [x, y, z] = each([0, 1, 2], |i| p[i] - centre[i]);
            let v = (-y / radius).clamp(-1.0, 1.0).acos() / PI;
            [turn((-z).atan2(x)), v]
        }
        Geometry::Ellipsoid { semi_axes } => [
            around(),
            (-p[1] / semi_axes[1]).clamp(-1.0, 1.0).acos() / PI,
        ],
        Geometry::GeodesicSphere { .. } => {
            let length = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
            [around(), (-p[1] / length).clamp(-1.0, 1.0).acos() / PI]
        }
        Geometry::Box { min, max } => {
            let part = |i: usize| part(p[i], min[i], max[i]);
            match face {
                0 => [part(2), part(1)],
                1 => [1.0 - part(2), part(1)],
                2 => [part(0), part(2)],
                3 => [part(0), 1.0 - part(2)],
                4 => [1.0 - part(0), part(1)],
                _ => [part(0), part(1)],
            }
        }
        Geometry::Rectangle { min, max } => each([0, 1], |i| part(p[i], min[i], max[i])),
        Geometry::Plane(q) | Geometry::HalfSpace(q) => {
            let normal = unit([q[0], q[1], q[2]]);
            let across = match normal[1].abs() > 0.999 {
                true => [0.0, 0.0, -1.0],
                false => [0.0, 1.0, 0.0],
            };
            let u = unit(cross(across, normal));
            [dot(p, u), dot(p, cross(normal, u))]
        }
        Geometry::Triangle { vertices, .. } => {
            let [_, u, v] = weights(vertices, p);
            [u, v]
        }
        Geometry::Torus { major, minor } => {
            let rho = p[0].hypot(p[2]);
            let tube = |across: f64| (across - major).hypot(p[1]) - minor;
            let across = if tube(-rho).abs() < tube(rho).abs() {
                -rho
            } else {
                rho
            };
            [around(), turn(p[1].atan2(across - major))]
        }
        Geometry::Cone { height, radius } => match face {
            0 => [around(), p[1] / height],
            _ => [around(), p[0].hypot(p[2]) / radius],
        },
        Geometry::DoubleCone { height, radius } => match face {
            0 | 1 => [around(), 0.5 * (p[1] / height) + 0.5],
            _ => [around(), p[0].hypot(p[2]) / radius],
        },
        Geometry::Revolution { profile, .. } => {
            let (i, share) = along(profile, p, face);
            let lengths = profile
                .windows(2)
                .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]));
            let lengths: Vec<f64> = lengths.collect();
            let total: f64 = lengths.iter().sum();
            let before: f64 = lengths[..i.min(lengths.len())].iter().sum();
            let here = lengths.get(i).map_or(0.0, |l| share * l);
            [
                around(),
                if total > 0.0 {
                    (before + here) / total
                } else {
                    0.0
                },
            ]
        }
        _ => [around(), p[1]],
    }
}

/// Finds the piece of a profile that a point lies on: the number of the piece's first point, and the share of the way
/// to its second point. On a disc, the number of the disc's point and 0.
fn along(profile: &[[f64; 2]], p: [f64; 3], face: u32) -> (usize, f64) {
    let i = face as usize;
    let pieces = profile.len().saturating_sub(1);
    if i >= pieces {
        return (if i == pieces { 0 } else { pieces }, 0.0);
    }
    let ([x0, y0], [x1, y1]) = (profile[i], profile[i + 1]);
    let share = if (y1 - y0).abs() >= (x1 - x0).abs() {
        (p[1] - y0) / (y1 - y0)
    } else {
        (p[0].hypot(p[2]) - x0) / (x1 - x0)
    };
    (
        i,
        if share.is_finite() {
            share.clamp(0.0, 1.0)
        } else {
            0.0
        },
    )
}

/// The colour that a shape's own record gives a point; `None` for shapes without colours.
pub fn own_colour(geometry: &Geometry, p: [f64; 3], face: u32) -> Option<Rgb> {
    let Geometry::Revolution { profile, colours } = geometry else {
        return None;
    };
    let (i, share) = along(profile, p, face);
    let a = colours.get(i)?;
    let b = colours.get(i + 1).unwrap_or(a);
    Some(each([0, 1, 2], |k| a[k] * (1.0 - share) + b[k] * share))
}

/// The normal that light is computed with, if it differs from the geometric one.
pub fn shading_normal(geometry: &Geometry, p: [f64; 3]) -> Option<[f64; 3]> {
    let Geometry::Triangle { vertices, normals } = geometry else {
        return None;
    };
    match normals {
        TriangleNormals::Flat => None,
        TriangleNormals::One(n) => Some(*n),
        TriangleNormals::PerVertex(n) => {
            let w = weights(vertices, p);
            Some(each([0, 1, 2], |c| {
                n[0][c] * w[0] + n[1][c] * w[1] + n[2][c] * w[2]
            }))
        }
    }
}

/// The barycentric coordinates of `p` in a triangle.
fn weights([a, b, c]: &[[f64; 3]; 3], p: [f64; 3]) -> [f64; 3] {
    let (e, f, g) = (sub(*b, *a), sub(*c, *a), sub(p, *a));
    let n = cross(e, f);
    let square = dot(n, n);
    let v = dot(cross(g, f), n) / square;
    let w = dot(cross(e, g), n) / square;
    [1.0 - v - w, v, w]
}
