//! Random shapes of every kind, and what lines may be aimed at in them.

use super::rng::Rng;
use super::truth::length;
use std::f64::consts::TAU;
use zpg::internals::scene::{Geometry, TriangleNormals};

/// The kinds of shapes, in the order of the language.
pub const KINDS: [&str; 23] = [
    "surface of revolution",
    "plane",
    "half-space",
    "rectangle",
    "triangle",
    "sphere",
    "sphere off the origin",
    "ellipsoid",
    "box",
    "geodesic sphere",
    "torus, tube 1/4",
    "torus, tube 1",
    "torus, tube 1e-4",
    "torus, spindle",
    "quadric",
    "cone",
    "double cone",
    "parabolic cylinder",
    "hyperbolic cylinder",
    "hyperboloid, one sheet",
    "hyperboloid, two sheets",
    "hyperbolic paraboloid",
    "cylinder",
];

/// How far apart the axes of a shape, and the scales of a map, may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// By a factor of a hundred, as in most scenes.
    Usual,
    /// By a factor of 10⁸, as in needles and sheets.
    Stretched,
}

impl Spread {
    /// The name of a kind of shape with axes this far apart.
    pub fn name(self, kind: usize) -> String {
        match self {
            Spread::Usual => KINDS[kind].to_owned(),
            Spread::Stretched => format!("{}, stretched", KINDS[kind]),
        }
    }

    /// A number of few digits, or of many: the length of an axis in sizes of the shape.
    fn factor(self, rng: &mut Rng) -> f64 {
        match self {
            Spread::Stretched => rng.decade(-4.0, 4.0),
            Spread::Usual if rng.chance(0.3) => *rng.pick(&[0.25, 0.5, 1.0, 1.0, 2.0, 3.0]),
            Spread::Usual => rng.decade(-1.0, 1.0),
        }
    }

    /// Three axes of a shape that otherwise has none.
    fn axes(self, size: f64, rng: &mut Rng) -> [f64; 3] {
        match self {
            Spread::Usual => [size; 3],
            Spread::Stretched => [0; 3].map(|_| size * self.factor(rng)),
        }
    }

    /// The size of a shape with such axes.
    fn reach(self, size: f64, axes: [f64; 2]) -> f64 {
        match self {
            Spread::Usual => size,
            Spread::Stretched => axes[0].max(axes[1]),
        }
    }
}

/// A shape to shoot at.
pub struct Target {
    pub geometry: Geometry,
    pub centre: [f64; 3],
    /// What its extent is like.
    pub size: f64,
    /// Of what is stretched: the edges of a box of the shape's extent, from the centre to its faces.
    pub stretch: Option<[[f64; 3]; 3]>,
    /// Whether it goes on for ever.
    pub unbounded: bool,
    /// The apex, points of rims, seams and edges, vertices, the centre.
    pub anchors: Vec<[f64; 3]>,
    /// Coordinates at which axis-parallel lines touch, by axis.
    pub marks: [Vec<f64>; 3],
    /// Those of asymptotes, generators and the like.
    pub directions: Vec<[f64; 3]>,
}

fn turned(rho: f64, y: f64, angle: f64) -> [f64; 3] {
    [rho * angle.cos(), y, rho * angle.sin()]
}

/// The point itself, or one on a quarter turn, exactly.
fn around(rng: &mut Rng, rho: f64, y: f64) -> [f64; 3] {
    match rng.below(4) {
        0 => [rho, y, 0.0],
        1 => [0.0, y, -rho],
        _ => {
            let angle = rng.range(0.0, TAU);
            turned(rho, y, angle)
        }
    }
}

fn size(rng: &mut Rng) -> f64 {
    if rng.chance(0.2) {
        *rng.pick(&[1.0, 0.25, 2.0, 1024.0, 1e-6, 1e6])
    } else {
        rng.decade(-6.0, 6.0)
    }
}

impl Target {
    /// A random shape of a kind, given by its number in [`KINDS`].
    pub fn new(kind: usize, spread: Spread, rng: &mut Rng) -> Target {
        let size = size(rng);
        match KINDS[kind] {
            "surface of revolution" => revolution(size, spread, rng),
            "plane" => plane(size, rng, false),
            "half-space" => plane(size, rng, true),
            "rectangle" => rectangle(size, spread, rng),
            "triangle" => triangle(size, spread, rng),
            "sphere" => sphere(size, [0.0; 3]),
            "sphere off the origin" => {
                let far = size * rng.decade(-1.0, 4.0);
                sphere(size, rng.cube().map(|x| x * far))
            }
            "ellipsoid" => {
                let semi_axes = std::array::from_fn(|_| size * spread.factor(rng));
                let mut target = cuboid(semi_axes.map(|x| -x), semi_axes, rng);
                target.geometry = Geometry::Ellipsoid { semi_axes };
                target.anchors = (0..3)
                    .map(|i| std::array::from_fn(|j| if i == j { semi_axes[i] } else { 0.0 }))
                    .collect();
                target.stretched(spread)
            }
            "box" => {
                let far = if rng.chance(0.5) {
                    0.0
                } else {
                    size * rng.decade(-1.0, 3.0)
                };
                let min = rng.cube().map(|x| x * far);
                let max = min.map(|x| x + size * spread.factor(rng));
                cuboid(min, max, rng).stretched(spread)
            }
            "geodesic sphere" => geodesic(size, rng),
            "torus, tube 1/4" => torus(size, 0.25 * size, rng),
            "torus, tube 1" => torus(size, size, rng),
            "torus, tube 1e-4" => torus(size, 1e-4 * size, rng),
            "torus, spindle" => {
                let tube = size * rng.range(1.0, 4.0);
                torus(size, tube, rng)
            }
            "cone" => {
                let (height, radius) = (
                    size * spread.factor(rng) * rng.sign(),
                    size * spread.factor(rng),
                );
                cone(height, radius, false, rng).stretched(spread)
            }
            "double cone" => {
                let (height, radius) = (size * spread.factor(rng), size * spread.factor(rng));
                cone(height, radius, true, rng).stretched(spread)
            }
            "cylinder" => {
                let (radius, height) = (size * spread.factor(rng), size * spread.factor(rng));
                let size = spread.reach(size, [radius, height]);
                profile(vec![[radius, -height], [radius, height]], size, rng).stretched(spread)
            }
            other => second(other, size, spread, rng),
        }
    }

    /// With the box that lines are aimed at, if the spread asks for it: as far as the marks of the axes reach.
    fn stretched(mut self, spread: Spread) -> Target {
        if spread == Spread::Stretched {
            let reach = |i: usize| {
                let far = self.marks[i].iter().map(|x| (x - self.centre[i]).abs());
                far.fold(0.0, f64::max)
            };
            self.stretch = Some(diagonal([reach(0), reach(1), reach(2)]));
        }
        self
    }

    /// A point close to the surface, and the normal there, of length 1.
    pub fn surface(&self, rng: &mut Rng) -> ([f64; 3], [f64; 3]) {
        let angle = rng.range(0.0, TAU);
        let turn =
            |rho: f64, y: f64, out: f64, up: f64| (turned(rho, y, angle), turned(out, up, angle));
        match self.geometry {
            Geometry::Sphere { centre, radius } => {
                let n = rng.direction();
                (std::array::from_fn(|i| centre[i] + radius * n[i]), n)
            }
            Geometry::Ellipsoid { semi_axes } => {
                let n = rng.direction();
                let p = std::array::from_fn(|i| semi_axes[i] * n[i]);
                (p, unit(std::array::from_fn(|i| n[i] / semi_axes[i])))
            }
            Geometry::Torus { major, minor } => {
                let tube = rng.range(0.0, TAU);
                let (out, up) = (tube.cos(), tube.sin());
                turn(major + minor * out, minor * up, out, up)
            }
            Geometry::Cone { height, radius } => {
                let share = rng.unit();
                let (out, up) = (height.abs(), -radius * height.signum());
                let long = out.hypot(up);
                turn(radius * share, height * share, out / long, up / long)
            }
            Geometry::DoubleCone { height, radius } => {
                let share = rng.range(-1.0, 1.0);
                let (out, up) = (height, -radius * share.signum());
                let long = out.hypot(up);
                turn(radius * share.abs(), height * share, out / long, up / long)
            }
            Geometry::Revolution { ref profile, .. } => {
                let i = rng.below(profile.len() - 1);
                let (p, q) = (profile[i], profile[i + 1]);
                let (w, h, share) = (q[0] - p[0], q[1] - p[1], rng.unit());
                let long = w.hypot(h).max(f64::MIN_POSITIVE);
                turn(p[0] + share * w, p[1] + share * h, h / long, -w / long)
            }
            Geometry::Box { min, max } => {
                let mut p = std::array::from_fn(|i| rng.range(min[i], max[i]));
                let axis = rng.below(3);
                let upper = rng.chance(0.5);
                p[axis] = if upper { max[axis] } else { min[axis] };
                let mut n = [0.0; 3];
                n[axis] = if upper { 1.0 } else { -1.0 };
                (p, n)
            }
            Geometry::Rectangle { min, max } => {
                let p = [rng.range(min[0], max[0]), rng.range(min[1], max[1]), 0.0];
                (p, [0.0, 0.0, 1.0])
            }
            Geometry::Triangle { ref vertices, .. } => facet_point(**vertices, rng),
            Geometry::Plane(abcd) | Geometry::HalfSpace(abcd) => {
                let normal = [abcd[0], abcd[1], abcd[2]];
                let square: f64 = normal.iter().map(|x| x * x).sum();
                let q = rng.cube().map(|x| x * 4.0 * self.size);
                let value: f64 = (0..3).map(|i| normal[i] * q[i]).sum::<f64>() + abcd[3];
                let p = std::array::from_fn(|i| q[i] - normal[i] * value / square);
                (p, unit(normal))
            }
            Geometry::GeodesicSphere { radius, .. } => {
                let n = rng.direction();
                (n.map(|x| x * radius), n)
            }
            _ => self.second_surface(rng),
        }
    }

    /// A random vector from the centre: up to so many sizes of the shape, or of each axis of what is stretched.
    pub fn within(&self, sizes: f64, rng: &mut Rng) -> [f64; 3] {
        let v = rng.cube();
        match &self.stretch {
            None => v.map(|x| x * sizes * self.size),
            Some(edges) => spanned(edges, v.map(|x| x * sizes)),
        }
    }

    /// Where a random line meets a surface of second degree.
    fn second_surface(&self, rng: &mut Rng) -> ([f64; 3], [f64; 3]) {
        let q = matrix(&self.geometry);
        let product = |v: [f64; 4], w: [f64; 4]| -> f64 {
            let terms = (0..16).map(|k| q[k] * v[k / 4] * w[k % 4]);
            terms.sum()
        };
        /// Some lines meet nothing, and some surfaces are empty.
        const TRIES: usize = 8;
        for _ in 0..TRIES {
            let o = self.within(3.0, rng);
            let d = match &self.stretch {
                None => rng.direction(),
                Some(edges) => unit(spanned(edges, rng.direction())),
            };
            let (o4, d4) = ([o[0], o[1], o[2], 1.0], [d[0], d[1], d[2], 0.0]);
            let (a, b, c) = (product(d4, d4), product(o4, d4), product(o4, o4));
            let t = (-b + rng.sign() * (b * b - a * c).sqrt()) / a;
            let p: [f64; 3] = std::array::from_fn(|i| o[i] + t * d[i]);
            if t.is_finite() && t.abs() < 100.0 * self.size && p.iter().all(|x| x.is_finite()) {
                let n = std::array::from_fn(|i| {
                    let mut e = [0.0; 4];
                    e[i] = 1.0;
                    product([p[0], p[1], p[2], 1.0], e)
                });
                return (p, unit(n));
            }
        }
        (self.centre, rng.direction())
    }
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let size = length(v);
    if size > 0.0 {
        v.map(|x| x / size)
    } else {
        [0.0, 1.0, 0.0]
    }
}

/// The edges of a box along the axes.
fn diagonal(lengths: [f64; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { lengths[i] } else { 0.0 }))
}

/// The sum of vectors, each times a number.
fn spanned(edges: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|j| edges[j][i] * v[j]).sum())
}

fn facet_point(vertices: [[f64; 3]; 3], rng: &mut Rng) -> ([f64; 3], [f64; 3]) {
    let [a, b, c] = vertices;
    let (mut s, mut t) = (rng.unit(), rng.unit());
    if s + t > 1.0 {
        (s, t) = (1.0 - s, 1.0 - t);
    }
    let p = std::array::from_fn(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]));
    let (e, f): ([f64; 3], [f64; 3]) = (
        std::array::from_fn(|i| b[i] - a[i]),
        std::array::from_fn(|i| c[i] - a[i]),
    );
    (p, unit(cross(e, f)))
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn sphere(radius: f64, centre: [f64; 3]) -> Target {
    Target {
        geometry: Geometry::Sphere { centre, radius },
        centre,
        size: radius,
        unbounded: false,
        anchors: vec![centre],
        marks: std::array::from_fn(|i| vec![centre[i] - radius, centre[i], centre[i] + radius]),
        directions: vec![],
        stretch: None,
    }
}

fn cuboid(min: [f64; 3], max: [f64; 3], rng: &mut Rng) -> Target {
    let corner = |bits: usize| -> [f64; 3] {
        std::array::from_fn(|i| if bits >> i & 1 == 0 { min[i] } else { max[i] })
    };
    let mut anchors: Vec<[f64; 3]> = (0..8).map(corner).collect();
    for bits in 0..8 {
        let mut edge = corner(bits);
        let axis = rng.below(3);
        edge[axis] = rng.range(min[axis], max[axis]);
        anchors.push(edge);
    }
    let centre: [f64; 3] = std::array::from_fn(|i| 0.5 * (min[i] + max[i]));
    Target {
        geometry: Geometry::Box { min, max },
        centre,
        size: length(std::array::from_fn(|i| 0.5 * (max[i] - min[i]))),
        unbounded: false,
        anchors,
        marks: std::array::from_fn(|i| vec![min[i], centre[i], max[i]]),
        directions: vec![],
        stretch: None,
    }
}

fn rectangle(size: f64, spread: Spread, rng: &mut Rng) -> Target {
    let min = [0; 2].map(|_| rng.range(-2.0, 1.0) * size);
    let max = min.map(|x| x + size * spread.factor(rng));
    let (low, high) = ([min[0], min[1], 0.0], [max[0], max[1], 0.0]);
    Target {
        geometry: Geometry::Rectangle { min, max },
        ..cuboid(low, high, rng).stretched(spread)
    }
}

fn triangle(size: f64, spread: Spread, rng: &mut Rng) -> Target {
    let far = if rng.chance(0.5) {
        0.0
    } else {
        size * rng.decade(-1.0, 3.0)
    };
    let shift = rng.cube().map(|x| x * far);
    let axes = spread.axes(size, rng);
    let mut vertex = || -> [f64; 3] {
        let v = rng.cube();
        std::array::from_fn(|i| shift[i] + axes[i] * v[i])
    };
    let vertices = [vertex(), vertex(), vertex()];
    let [a, b, c] = vertices;
    let mut anchors = vertices.to_vec();
    for (v, w) in [(a, b), (b, c), (c, a)] {
        let share = rng.unit();
        anchors.push(std::array::from_fn(|i| v[i] + share * (w[i] - v[i])));
        anchors.push(std::array::from_fn(|i| 0.5 * (w[i] + v[i])));
    }
    Target {
        geometry: Geometry::Triangle {
            vertices: Box::new(vertices),
            normals: TriangleNormals::Flat,
        },
        centre: std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0),
        size,
        unbounded: false,
        anchors,
        marks: std::array::from_fn(|i| vec![a[i], b[i], c[i]]),
        directions: vec![
            std::array::from_fn(|i| (b[i] - a[i]) / size),
            std::array::from_fn(|i| (c[i] - a[i]) / size),
        ],
        stretch: None,
    }
    .stretched(spread)
}

fn plane(size: f64, rng: &mut Rng, solid: bool) -> Target {
    let mut normal = rng.direction();
    if rng.chance(0.3) {
        normal = [0.0; 3];
        normal[rng.below(3)] = rng.sign();
    }
    let long = rng.decade(-3.0, 3.0);
    let far = size * rng.range(-1.0, 1.0);
    let abcd = [
        normal[0] * long,
        normal[1] * long,
        normal[2] * long,
        -far * long,
    ];
    let foot = normal.map(|x| x * far);
    let across = unit(cross(normal, rng.direction()));
    Target {
        geometry: if solid {
            Geometry::HalfSpace(abcd)
        } else {
            Geometry::Plane(abcd)
        },
        centre: foot,
        size,
        unbounded: true,
        anchors: vec![foot],
        marks: foot.map(|x| vec![x, 0.0]),
        directions: vec![across],
        stretch: None,
    }
}

fn geodesic(radius: f64, rng: &mut Rng) -> Target {
    let splits = rng.below(3) as u32;
    let phi = 0.5 * (1.0 + 5f64.sqrt());
    let unit = radius / phi.hypot(1.0);
    let vertex = |i: usize| -> [f64; 3] {
        let mut v = [0.0; 3];
        v[(i + 1) % 3] = unit;
        v[(i + 2) % 3] = phi * unit;
        v
    };
    let edge = [0.0, 0.0, phi * unit];
    let mut target = sphere(radius, [0.0; 3]);
    target.geometry = Geometry::GeodesicSphere { radius, splits };
    target.anchors = vec![vertex(0), vertex(1), vertex(2), edge, [0.0; 3]];
    target
}

fn torus(major: f64, minor: f64, rng: &mut Rng) -> Target {
    let mut anchors = vec![[0.0; 3], [0.0, minor, 0.0]];
    for (rho, y) in [
        (major, minor),
        (major + minor, 0.0),
        ((major - minor).abs(), 0.0),
    ] {
        anchors.push(around(rng, rho, y));
    }
    // The ends of a spindle.
    let end = ((minor - major) * (minor + major)).max(0.0).sqrt();
    anchors.push([0.0, end, 0.0]);
    let across = vec![
        major + minor,
        major - minor,
        major,
        -major - minor,
        minor - major,
        0.0,
    ];
    Target {
        geometry: Geometry::Torus { major, minor },
        centre: [0.0; 3],
        size: major + minor,
        unbounded: false,
        anchors,
        marks: [across.clone(), vec![minor, -minor, 0.0], across],
        directions: vec![],
        stretch: None,
    }
}

fn cone(height: f64, radius: f64, double: bool, rng: &mut Rng) -> Target {
    let rim = around(rng, radius, height);
    let angle = rng.range(0.0, TAU);
    let generator = unit(turned(radius, height, angle));
    let across = vec![radius, -radius, 0.0];
    Target {
        geometry: if double {
            Geometry::DoubleCone { height, radius }
        } else {
            Geometry::Cone { height, radius }
        },
        centre: [0.0, if double { 0.0 } else { 0.5 * height }, 0.0],
        size: height.abs().hypot(radius),
        unbounded: false,
        anchors: vec![
            [0.0; 3],
            rim,
            around(rng, radius, height),
            [0.0, height, 0.0],
        ],
        marks: [across.clone(), vec![height, 0.0], across],
        directions: vec![generator, [radius, height, 0.0].map(|x| x / radius)],
        stretch: None,
    }
}

/// How thin needles are, in sizes of the shape: powers of ten.
const THIN: (f64, f64) = (-17.0, -2.0);

/// A random profile: any line, a ring, steps, a crossing one, needles, many points.
fn revolution(size: f64, spread: Spread, rng: &mut Rng) -> Target {
    let few = 2 + rng.below(6);
    let far = if rng.chance(0.3) {
        size * rng.decade(-1.0, 2.0)
    } else {
        0.0
    };
    let style = rng.below(5);
    let closed = rng.chance(0.5);
    let count = if rng.chance(0.1) { 40 } else { few };
    let mut points: Vec<[f64; 2]> = Vec::new();
    for i in 0..count {
        let last = points.last().copied();
        let mut p = [size * rng.unit(), far + size * rng.range(-1.0, 1.0)];
        match (style, last) {
            // Steps: walls and discs.
            (0, Some(last)) => p[i % 2] = last[i % 2],
            // A smooth outline.
            (1, _) => {
                let angle = std::f64::consts::PI * i as f64 / (count - 1) as f64;
                let waves = 1.0 + 0.2 * (5.0 * angle).cos();
                // The sine of π is not zero: half of them end in a disc of 10⁻¹⁶ sizes.
                let on_axis = closed && (i == 0 || i + 1 == count);
                let x = if on_axis { 0.0 } else { angle.sin() * waves };
                p = [size * x, far - size * angle.cos()];
            }
            // On the axis now and then, and small whole numbers.
            (2, _) => p = [size * rng.below(4) as f64, far + size * rng.below(4) as f64],
            // Needles and steps that are next to nothing: close to one of the last points.
            (3, Some(_)) if rng.chance(0.7) => {
                let near = *rng.pick(&points[points.len().saturating_sub(3)..]);
                p = near.map(|x| x + rng.sign() * size * rng.decade(THIN.0, THIN.1));
                // Some are upright, level, or meet the axis.
                match rng.below(6) {
                    0 => p[0] = near[0],
                    1 => p[1] = near[1],
                    2 => p[0] = size * rng.decade(THIN.0, THIN.1),
                    _ => {}
                }
                p[0] = p[0].abs();
            }
            _ => {}
        }
        points.push(p);
    }
    if points.iter().all(|p| p[0] == 0.0) {
        points[0][0] = size;
    }
    if points.len() > 3 && rng.chance(0.25) {
        points.push(points[0]);
    }
    let [across, along, _] = spread.axes(1.0, rng);
    for point in &mut points {
        *point = [point[0] * across, point[1] * along];
    }
    let size = spread.reach(size, [size * across, size * along]);
    profile(points, size, rng).stretched(spread)
}

fn profile(points: Vec<[f64; 2]>, size: f64, rng: &mut Rng) -> Target {
    let anchors = points.iter().map(|p| around(rng, p[0], p[1])).collect();
    let radii: Vec<f64> = points.iter().flat_map(|p| [p[0], -p[0]]).collect();
    let heights: Vec<f64> = points.iter().map(|p| p[1]).collect();
    let generators = points.windows(2).filter(|w| w[0] != w[1]).map(|w| {
        let (from, to) = (w[0], w[1]);
        unit([to[0] - from[0], to[1] - from[1], 0.0])
    });
    Target {
        centre: [0.0, heights.iter().sum::<f64>() / heights.len() as f64, 0.0],
        size,
        unbounded: false,
        anchors,
        marks: [radii.clone(), heights, radii],
        directions: generators.collect(),
        stretch: None,
        geometry: Geometry::Revolution {
            profile: points,
            colours: vec![],
        },
    }
}

/// The surfaces of second degree that are not bounded, and general ones.
fn second(kind: &str, size: f64, spread: Spread, rng: &mut Rng) -> Target {
    let [a, b, c] = [0; 3].map(|_| size * spread.factor(rng));
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut directions = vec![[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [half, half, 0.0]];
    let mut anchors = vec![[0.0; 3], [a, 0.0, 0.0]];
    let mut stretch = diagonal([a, b, c]);
    let geometry = match kind {
        // x² = a² y: as large as a² is for x = 1; of size a where a is.
        "parabolic cylinder" => Geometry::ParabolicCylinder { a },
        "hyperbolic cylinder" => {
            directions.extend([unit([a, b, 0.0]), [a / b, -1.0, 0.0], unit([a, b, size])]);
            Geometry::HyperbolicCylinder { a, b }
        }
        "hyperboloid, one sheet" | "hyperboloid, two sheets" => {
            let angle = rng.range(0.0, TAU);
            directions.extend([
                unit([a, b, 0.0]),
                [0.0, b / c, 1.0],
                [a * angle.cos() / b, 1.0, c * angle.sin() / b],
            ]);
            anchors.extend([[0.0, b, 0.0], [0.0, 0.0, -c]]);
            Geometry::Hyperboloid {
                a,
                b,
                c,
                sheets: if kind.ends_with("one sheet") { 1 } else { 2 },
            }
        }
        "hyperbolic paraboloid" => {
            directions.extend([unit([a, 0.0, b]), [a / b, 0.0, -1.0], unit([a, size, b])]);
            Geometry::HyperbolicParaboloid { a, b }
        }
        _ => {
            let mut q = quadric(size, rng);
            if spread == Spread::Stretched {
                (q, stretch) = stretched_quadric([a, b, c], rng);
            }
            Geometry::Quadric(Box::new(q))
        }
    };
    Target {
        geometry,
        centre: [0.0; 3],
        size: a.max(b).max(c).max(size),
        unbounded: true,
        anchors,
        marks: [vec![a, -a, 0.0], vec![b, -b, 0.0], vec![c, -c, 0.0]],
        directions,
        stretch: Some(stretch).filter(|_| spread == Spread::Stretched),
    }
}

/// xᵀQx of which only exact sums are made: Q is symmetric.
fn quadric(size: f64, rng: &mut Rng) -> [f64; 16] {
    let mut q = [0.0; 16];
    let all = rng.decade(-3.0, 3.0);
    let over = all / (size * size);
    match rng.below(5) {
        // A cylinder, a cone and a paraboloid about some axis; two planes.
        style @ 0..4 => {
            let axis = rng.below(3);
            for i in 0..3 {
                q[5 * i] = over;
            }
            q[5 * axis] = match style {
                1 => -over,
                _ => 0.0,
            };
            match style {
                0 => q[15] = -all,
                2 => {
                    q[4 * axis + 3] = all / size;
                    q[12 + axis] = q[4 * axis + 3];
                }
                3 => {
                    q[5 * ((axis + 1) % 3)] = 0.0;
                    q[15] = -all;
                }
                _ => {}
            }
        }
        _ => {
            for i in 0..4 {
                for j in 0..=i {
                    let units = match (i, j) {
                        (3, 3) => all,
                        (3, _) => all / size,
                        _ => over,
                    };
                    q[4 * i + j] = rng.range(-1.0, 1.0) * units;
                    q[4 * j + i] = q[4 * i + j];
                }
            }
        }
    }
    q
}

/// A quadric of size 1, stretched along the axes and, in half of the cases, turned; and the edges of the box that the unit
/// cube becomes. The numbers are what rounding makes of that.
fn stretched_quadric(axes: [f64; 3], rng: &mut Rng) -> ([f64; 16], [[f64; 3]; 3]) {
    let q = quadric(1.0, rng);
    let turned = rng.chance(0.5);
    let x = rng.direction();
    let y = unit(cross(x, rng.direction()));
    let rows = match turned {
        true => [x, y, cross(x, y)],
        false => diagonal([1.0; 3]),
    };
    // Back into the space of size 1.
    let mut back = [[0.0; 4]; 4];
    for i in 0..3 {
        for j in 0..3 {
            back[i][j] = rows[i][j] / axes[i];
        }
    }
    back[3][3] = 1.0;
    let mut image = [0.0; 16];
    for i in 0..4 {
        for j in 0..=i {
            let terms = (0..16).map(|k| back[k / 4][i] * q[k] * back[k % 4][j]);
            let sum: f64 = terms.sum();
            // Mostly symmetric; else the sum of both is rounded where it is not kept apart.
            let share = if rng.chance(0.8) { 0.5 } else { rng.unit() };
            image[4 * i + j] = 2.0 * share * sum;
            image[4 * j + i] = if i == j {
                sum
            } else {
                2.0 * (1.0 - share) * sum
            };
        }
    }
    (image, std::array::from_fn(|i| rows[i].map(|x| x * axes[i])))
}

/// Q of xᵀQx, about, for shapes of second degree that are no solids of revolution.
fn matrix(geometry: &Geometry) -> [f64; 16] {
    let (square, y, constant) = match *geometry {
        Geometry::Quadric(ref q) => return **q,
        Geometry::ParabolicCylinder { a } => ([1.0 / a / a, 0.0, 0.0], -1.0, 0.0),
        Geometry::HyperbolicCylinder { a, b } => ([1.0 / a / a, -1.0 / b / b, 0.0], 0.0, -1.0),
        Geometry::Hyperboloid { a, b, c, sheets } => (
            [1.0 / a / a, -1.0 / b / b, 1.0 / c / c],
            0.0,
            if sheets == 1 { -1.0 } else { 1.0 },
        ),
        Geometry::HyperbolicParaboloid { a, b } => ([1.0 / a / a, 0.0, -1.0 / b / b], -1.0, 0.0),
        _ => panic!("not of second degree"),
    };
    let mut q = [0.0; 16];
    for i in 0..3 {
        q[5 * i] = square[i];
    }
    q[7] = y / 2.0;
    q[13] = y / 2.0;
    q[15] = constant;
    q
}
