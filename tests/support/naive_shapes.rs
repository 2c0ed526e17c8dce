//! Shapes for the naive evaluator: inside or not, and where a line crosses the boundary.

use zpg::scene::{Geometry, Vec3};

pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn add(a: Vec3, b: Vec3, s: f64) -> Vec3 {
    std::array::from_fn(|i| a[i] + s * b[i])
}

pub fn unit(v: Vec3) -> Vec3 {
    let l = dot(v, v).sqrt();
    v.map(|c| c / l)
}

pub fn inside(g: &Geometry, p: Vec3) -> bool {
    match g {
        Geometry::Sphere { centre, radius } => {
            let d = add(p, *centre, -1.0);
            dot(d, d) <= radius * radius
        }
        Geometry::Box { min, max } => (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i]),
        Geometry::HalfSpace([a, b, c, d]) => dot([*a, *b, *c], p) + d <= 0.0,
        Geometry::Plane(_) | Geometry::Rectangle { .. } => false,
        g => panic!("the naive evaluator does not know {g:?}"),
    }
}

/// Where a line crosses a boundary: parameter, outward normal, surface coordinates.
pub struct Crossing {
    pub t: f64,
    pub normal: Vec3,
    pub uv: [f64; 2],
}

pub fn crossings(g: &Geometry, o: Vec3, d: Vec3) -> Vec<Crossing> {
    match g {
        Geometry::Sphere { centre, radius } => sphere(*centre, *radius, o, d),
        Geometry::Box { min, max } => cube(*min, *max, o, d),
        Geometry::HalfSpace(p) | Geometry::Plane(p) => plane(p, o, d),
        Geometry::Rectangle { min, max } => rectangle(*min, *max, o, d),
        g => panic!("the naive evaluator does not know {g:?}"),
    }
}

fn sphere(centre: Vec3, radius: f64, o: Vec3, d: Vec3) -> Vec<Crossing> {
    let oc = add(o, centre, -1.0);
    let (a, b, c) = (dot(d, d), dot(oc, d), dot(oc, oc) - radius * radius);
    let root = b * b - a * c;
    if root <= 0.0 {
        return Vec::new();
    }
    let at = |t: f64| {
        let n = unit(add(oc, d, t));
        let turn = (-n[2]).atan2(n[0]) / std::f64::consts::TAU;
        Crossing {
            t,
            normal: n,
            uv: [turn.rem_euclid(1.0), (-n[1]).acos() / std::f64::consts::PI],
        }
    };
    [-root.sqrt(), root.sqrt()].map(|s| at((s - b) / a)).into()
}

fn cube(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> Vec<Crossing> {
    let mut out = Vec::new();
    for axis in 0..3 {
        for (at, side) in [(min[axis], -1.0), (max[axis], 1.0)] {
            let t = (at - o[axis]) / d[axis];
            let p = add(o, d, t);
            if !t.is_finite() || (0..3).any(|i| i != axis && !(min[i] <= p[i] && p[i] <= max[i])) {
                continue;
            }
            let [x, y, z] = std::array::from_fn(|i| (p[i] - min[i]) / (max[i] - min[i]));
            let uv = match (axis, side > 0.0) {
                (0, true) => [1.0 - z, y],
                (0, false) => [z, y],
                (1, true) => [x, 1.0 - z],
                (1, false) => [x, z],
                (_, true) => [x, y],
                (_, false) => [1.0 - x, y],
            };
            let mut normal = [0.0; 3];
            normal[axis] = side;
            out.push(Crossing { t, normal, uv });
        }
    }
    out
}

fn plane(p: &[f64; 4], o: Vec3, d: Vec3) -> Vec<Crossing> {
    let n = [p[0], p[1], p[2]];
    let t = -(dot(n, o) + p[3]) / dot(n, d);
    if !t.is_finite() {
        return Vec::new();
    }
    let at = add(o, d, t);
    let n = unit(n);
    let helper = if n[1].abs() > 0.999 {
        [0.0, 0.0, -1.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let u = unit(cross(helper, n));
    let v = cross(n, u);
    vec![Crossing {
        t,
        normal: n,
        uv: [dot(at, u), dot(at, v)],
    }]
}

fn rectangle(min: [f64; 2], max: [f64; 2], o: Vec3, d: Vec3) -> Vec<Crossing> {
    let t = -o[2] / d[2];
    let p = add(o, d, t);
    let uv: [f64; 2] = std::array::from_fn(|i| (p[i] - min[i]) / (max[i] - min[i]));
    if !t.is_finite() || uv.iter().any(|c| !(0.0..=1.0).contains(c)) {
        return Vec::new();
    }
    vec![Crossing {
        t,
        normal: [0.0, 0.0, 1.0],
        uv,
    }]
}
