//! Where lines cross shapes: coefficients from the origin as it is, inclusive ends everywhere.

use super::number::{Number, Ray, V, cross, dot, sub, unit, vector};
use super::polynomial::{quadratic, quartic};
use super::solid::{Hit, Hits};
use zpg::scene::Geometry;

/// Whether shapes of this kind can be drawn.
pub fn is_known(geometry: &Geometry) -> bool {
    !matches!(
        geometry,
        Geometry::GeodesicSphere { .. } | Geometry::Triangle { .. }
    )
}

/// All crossings of a line with a shape, in the shape's space.
pub fn crossings<'s, T: Number>(geometry: &'s Geometry, ray: &Ray<T>) -> Hits<'s, T> {
    let n = T::of;
    let mut hits = Hits::default();
    match geometry {
        Geometry::Sphere { centre, radius } => sphere(vector(*centre), n(*radius), ray, &mut hits),
        Geometry::Box { min, max } => cuboid(vector(*min), vector(*max), ray, &mut hits),
        Geometry::Torus { major, minor } => torus(n(*major), n(*minor), ray, &mut hits),
        Geometry::Plane(p) => {
            if let Some(t) = plane(p, ray) {
                hits.list.push(Hit {
                    sheet: true,
                    ..plane_hit(p, ray, t)
                });
            }
            return hits;
        }
        Geometry::HalfSpace(p) => {
            let side = dot(vector([p[0], p[1], p[2]]), ray.direction);
            match plane(p, ray) {
                Some(t) => {
                    hits.inside = side > n(0.0);
                    hits.list.push(plane_hit(p, ray, t));
                }
                None => {
                    let value = dot(vector([p[0], p[1], p[2]]), ray.origin) + n(p[3]);
                    hits.inside = value <= n(0.0);
                }
            }
            return hits;
        }
        Geometry::Rectangle { min, max } => {
            let t = -ray.origin[2] / ray.direction[2];
            let p = ray.at(t);
            let uv = [0, 1].map(|i| (p[i] - n(min[i])) / (n(max[i]) - n(min[i])));
            if uv.iter().all(|&x| x >= n(0.0) && x <= n(1.0)) {
                hits.list.push(Hit {
                    sheet: true,
                    uv,
                    ..Hit::new(t, vector([0.0, 0.0, 1.0]))
                });
            }
            return hits;
        }
        Geometry::Revolution { profile, .. } => revolution(profile, ray, &mut hits),
        Geometry::Cone { height, radius } => {
            revolution(&[[0.0, 0.0], [*radius, *height]], ray, &mut hits);
        }
        Geometry::DoubleCone { height, radius } => {
            let profile = [[*radius, -height], [0.0, 0.0], [*radius, *height]];
            revolution(&profile, ray, &mut hits);
        }
        Geometry::Ellipsoid { semi_axes: s } => {
            let matrix = diagonal(s.map(|x| 1.0 / (x * x)), 0.0, -1.0);
            quadric(&matrix, ray, &mut hits);
        }
        Geometry::Quadric(matrix) => quadric(matrix, ray, &mut hits),
        Geometry::ParabolicCylinder { a } => {
            quadric(
                &diagonal([1.0 / (a * a), 0.0, 0.0], -1.0, 0.0),
                ray,
                &mut hits,
            );
        }
        Geometry::HyperbolicCylinder { a, b } => {
            let matrix = diagonal([1.0 / (a * a), -1.0 / (b * b), 0.0], 0.0, -1.0);
            quadric(&matrix, ray, &mut hits);
        }
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let constant = if *sheets == 1 { -1.0 } else { 1.0 };
            let squares = [1.0 / (a * a), -1.0 / (b * b), 1.0 / (c * c)];
            quadric(&diagonal(squares, 0.0, constant), ray, &mut hits);
        }
        Geometry::HyperbolicParaboloid { a, b } => {
            let matrix = diagonal([1.0 / (a * a), 0.0, -1.0 / (b * b)], -1.0, 0.0);
            quadric(&matrix, ray, &mut hits);
        }
        Geometry::GeodesicSphere { .. } | Geometry::Triangle { .. } => {}
    }
    hits.order();
    hits
}

fn sphere<T: Number>(centre: V<T>, radius: T, ray: &Ray<T>, hits: &mut Hits<T>) {
    let from = sub(ray.origin, centre);
    let a = dot(ray.direction, ray.direction);
    let b = T::of(2.0) * dot(from, ray.direction);
    let c = dot(from, from) - radius * radius;
    let mut roots = Vec::new();
    quadratic(a, b, c, &mut roots);
    let point = |t| sub(ray.at(t), centre);
    (hits.list).extend(roots.into_iter().map(|t| Hit::new(t, point(t))));
}

/// Slabs.
fn cuboid<T: Number>(min: V<T>, max: V<T>, ray: &Ray<T>, hits: &mut Hits<T>) {
    let (mut near, mut far) = (None, None);
    for i in 0..3 {
        let inverse = T::of(1.0) / ray.direction[i];
        let (mut a, mut b) = (
            (min[i] - ray.origin[i]) * inverse,
            (max[i] - ray.origin[i]) * inverse,
        );
        if a > b {
            (a, b) = (b, a);
        }
        if near.is_none_or(|(t, _)| a > t) {
            near = Some((a, i));
        }
        if far.is_none_or(|(t, _)| b < t) {
            far = Some((b, i));
        }
    }
    let (Some(near), Some(far)) = (near, far) else {
        return;
    };
    if near.0 > far.0 {
        return;
    }
    for (t, axis) in [near, far] {
        let p = ray.at(t);
        let part = |i: usize| (p[i] - min[i]) / (max[i] - min[i]);
        let other = |i: usize| (max[i] - p[i]) / (max[i] - min[i]);
        let upper = part(axis) > T::of(0.5);
        let mut normal = [T::of(0.0); 3];
        normal[axis] = T::of(if upper { 1.0 } else { -1.0 });
        // To the right and up as seen from outside.
        let uv = match (axis, upper) {
            (0, true) => [other(2), part(1)],
            (0, false) => [part(2), part(1)],
            (1, true) => [part(0), other(2)],
            (1, false) => [part(0), part(2)],
            (_, true) => [part(0), part(1)],
            (_, false) => [other(0), part(1)],
        };
        hits.list.push(Hit {
            uv,
            ..Hit::new(t, normal)
        });
    }
}

fn plane<T: Number>(p: &[f64; 4], ray: &Ray<T>) -> Option<T> {
    let normal = vector([p[0], p[1], p[2]]);
    let slope = dot(normal, ray.direction);
    (slope.abs() >= T::TINY).then(|| -(dot(normal, ray.origin) + T::of(p[3])) / slope)
}

fn plane_hit<'s, T: Number>(p: &[f64; 4], ray: &Ray<T>, t: T) -> Hit<'s, T> {
    let normal: V<T> = unit(vector([p[0], p[1], p[2]]));
    let across = match normal[1].abs() > T::of(0.999) {
        true => vector([0.0, 0.0, -1.0]),
        false => vector([0.0, 1.0, 0.0]),
    };
    let u = unit(cross(across, normal));
    let v = cross(normal, u);
    let point = ray.at(t);
    Hit {
        uv: [dot(point, u), dot(point, v)],
        ..Hit::new(t, normal)
    }
}

fn torus<T: Number>(major: T, minor: T, ray: &Ray<T>, hits: &mut Hits<T>) {
    let (o, d) = (ray.origin, ray.direction);
    let (two, four) = (T::of(2.0), T::of(4.0));
    let (dd, od) = (dot(d, d), dot(o, d));
    let k = dot(o, o) + major * major - minor * minor;
    let rr = four * major * major;
    let lead = dd * dd;
    let coefficients = [
        four * dd * od,
        two * dd * k + four * od * od - rr * (d[0] * d[0] + d[2] * d[2]),
        four * k * od - two * rr * (o[0] * d[0] + o[2] * d[2]),
        k * k - rr * (o[0] * o[0] + o[2] * o[2]),
    ];
    let mut roots = Vec::new();
    quartic(coefficients.map(|c| c / lead), &mut roots);
    for t in roots {
        let p = ray.at(t);
        let shrink = T::of(1.0) - major / (p[0] * p[0] + p[2] * p[2]).sqrt();
        let normal = [p[0] * shrink, p[1], p[2] * shrink];
        hits.list.push(Hit::new(t, normal));
    }
}

/// One piece of a cone or disc after the other, each with both of its ends.
fn revolution<T: Number>(profile: &[[f64; 2]], ray: &Ray<T>, hits: &mut Hits<T>) {
    for ends in profile.windows(2) {
        segment(ends[0], ends[1], ray, hits);
    }
    if let (Some(&first), Some(&last)) = (profile.first(), profile.last())
        && first != last
    {
        for end in [first, last].into_iter().filter(|end| end[0] > 0.0) {
            segment([0.0, end[1]], end, ray, hits);
        }
    }
}

fn segment<T: Number>(a: [f64; 2], b: [f64; 2], ray: &Ray<T>, hits: &mut Hits<T>) {
    let (o, d) = (ray.origin, ray.direction);
    let zero = T::of(0.0);
    let [x0, y0, x1, y1] = [a[0], a[1], b[0], b[1]].map(T::of);
    if a[1] == b[1] {
        let t = (y0 - o[1]) / d[1];
        let p = ray.at(t);
        let square = p[0] * p[0] + p[2] * p[2];
        let (inner, outer) = if x0 < x1 { (x0, x1) } else { (x1, x0) };
        if square >= inner * inner && square <= outer * outer {
            hits.list.push(Hit::new(t, [zero, T::of(1.0), zero]));
        }
        return;
    }
    let slope = (x1 - x0) / (y1 - y0);
    let radius = |y: T| x0 + slope * (y - y0);
    let here = radius(o[1]);
    let grows = slope * d[1];
    let mut roots = Vec::new();
    quadratic(
        d[0] * d[0] + d[2] * d[2] - grows * grows,
        T::of(2.0) * (o[0] * d[0] + o[2] * d[2] - here * grows),
        o[0] * o[0] + o[2] * o[2] - here * here,
        &mut roots,
    );
    let (low, high) = if y0 < y1 { (y0, y1) } else { (y1, y0) };
    for t in roots {
        let p = ray.at(t);
        if p[1] >= low && p[1] <= high {
            let normal = [p[0], -(slope * radius(p[1])), p[2]];
            hits.list.push(Hit::new(t, normal));
        }
    }
}

/// The matrix of ax² + by² + cz² + linear·y + constant.
fn diagonal([a, b, c]: [f64; 3], linear: f64, constant: f64) -> [f64; 16] {
    let half = linear / 2.0;
    [
        a, 0.0, 0.0, 0.0, 0.0, b, 0.0, half, 0.0, 0.0, c, 0.0, 0.0, half, 0.0, constant,
    ]
}

fn quadric<T: Number>(matrix: &[f64; 16], ray: &Ray<T>, hits: &mut Hits<T>) {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let times = |p: [T; 4], q: [T; 4]| {
        let mut sum = zero;
        for i in 0..4 {
            for j in 0..4 {
                sum = sum + p[i] * T::of(matrix[4 * i + j]) * q[j];
            }
        }
        sum
    };
    let four = |v: V<T>, w: T| [v[0], v[1], v[2], w];
    let (o, d) = (four(ray.origin, one), four(ray.direction, zero));
    let (a, b, c) = (times(d, d), times(o, d) + times(d, o), times(o, o));
    // The sign far back on the line.
    hits.inside = match () {
        () if a.abs() >= T::TINY => a < zero,
        () if b.abs() >= T::TINY => b > zero,
        () => c <= zero,
    };
    let mut roots = Vec::new();
    quadratic(a, b, c, &mut roots);
    for t in roots {
        let p = four(ray.at(t), one);
        let normal = [0, 1, 2].map(|i| {
            let mut axis = [zero; 4];
            axis[i] = one;
            times(axis, p) + times(p, axis)
        });
        hits.list.push(Hit::new(t, normal));
    }
}
