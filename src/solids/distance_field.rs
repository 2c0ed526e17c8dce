//! How far a point is from the boundary of a solid, roughly and rather too little: below zero inside,
//! above zero outside.

use crate::geometry::Matrix;
use crate::geometry::array::{cross, dot, length, sub};
use crate::scene::{Geometry, Node, NodeId, Scene, Vec3};
use crate::solids::containment::in_profile;
use crate::solids::facet::facet;

/// Solids of more shapes, and profiles of more points, are not looked at.
const SHAPES_MAX: usize = 32;
const PROFILE_MAX: usize = 128;

/// A solid in its place, as the steps of a calculation.
pub struct Field<'a> {
    steps: Vec<Step<'a>>,
    /// What the steps have come to, kept from one point to the next.
    values: Vec<Slope>,
    /// What one point costs, in steps.
    pub cost: usize,
}

/// A distance from what is below zero, and the direction in which it grows, of length 1 or none.
#[derive(Debug, Clone, Copy)]
pub struct Slope {
    pub distance: f64,
    pub up: Vec3,
}

impl Slope {
    pub const NOWHERE: Slope = Slope {
        distance: f64::INFINITY,
        up: [0.0; 3],
    };

    /// Of two that are both to be below zero the one that is further from it.
    pub fn both(self, other: Slope) -> Slope {
        if self.distance > other.distance {
            self
        } else {
            other
        }
    }

    fn turned(self) -> Slope {
        Slope {
            distance: -self.distance,
            up: self.up.map(|x| -x),
        }
    }
}

enum Step<'a> {
    Shape(&'a Geometry, Box<Placement>),
    /// Surfaces have no inside.
    Nothing,
    Union,
    Intersection,
    Difference,
    Complement,
}

/// From the coordinates of the root back to those of a shape.
struct Placement {
    back: Matrix,
    /// An upper bound of how much longer that makes what is shortest.
    stretch: f64,
}

impl<'a> Field<'a> {
    /// The field of a node whose coordinates are taken to those of the root by a matrix; `None` where that
    /// is too much or cannot be told.
    pub fn new(scene: &'a Scene, node: NodeId, matrix: &Matrix) -> Option<Field<'a>> {
        enum Task<'a> {
            Visit(NodeId, Matrix),
            Join(Step<'a>),
        }
        let mut out = Field {
            steps: Vec::new(),
            values: Vec::new(),
            cost: 0,
        };
        let mut tasks = vec![Task::Visit(node, *matrix)];
        while let Some(task) = tasks.pop() {
            let (node, matrix) = match task {
                Task::Join(step) => {
                    out.steps.push(step);
                    continue;
                }
                Task::Visit(node, matrix) => (node, matrix),
            };
            if out.steps.len() + tasks.len() > 4 * SHAPES_MAX {
                return None;
            }
            let mut pair = |step, a, b| {
                tasks.push(Task::Join(step));
                tasks.extend([Task::Visit(b, matrix), Task::Visit(a, matrix)]);
            };
            match scene.nodes[node as usize] {
                Node::Shape(s) => {
                    let geometry = &scene.shapes[s as usize].geometry;
                    out.cost += match geometry {
                        Geometry::Revolution { profile, .. } if profile.len() > PROFILE_MAX => {
                            return None;
                        }
                        Geometry::Revolution { profile, .. } => 4 + profile.len() / 4,
                        _ => 4,
                    };
                    out.steps.push(match geometry.is_solid() {
                        true => {
                            let back = matrix.inverse()?;
                            let rows = &back.0[..3];
                            let squares = rows.iter().flat_map(|r| &r[..3]).map(|x| x * x);
                            let stretch = squares.sum::<f64>().sqrt();
                            Step::Shape(geometry, Box::new(Placement { back, stretch }))
                        }
                        false => Step::Nothing,
                    });
                }
                Node::Transform { child, matrix: m } => {
                    let matrix = matrix.after(&scene.matrices[m as usize]);
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Paint { child, .. } | Node::Copy { child, .. } => {
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Complement(child) => {
                    tasks.push(Task::Join(Step::Complement));
                    tasks.push(Task::Visit(child, matrix));
                }
                Node::Union(a, b) => pair(Step::Union, a, b),
                Node::Intersection(a, b) => pair(Step::Intersection, a, b),
                Node::Difference(a, b) => pair(Step::Difference, a, b),
            }
        }
        Some(out)
    }

    pub fn at(&mut self, p: Vec3) -> Slope {
        let values = &mut self.values;
        values.clear();
        for step in &self.steps {
            let mut last = || values.pop().unwrap_or(Slope::NOWHERE);
            let value = match step {
                Step::Shape(geometry, placement) => placement.slope(geometry, p),
                Step::Nothing => Slope::NOWHERE,
                Step::Complement => last().turned(),
                two => {
                    let (b, a) = (last(), last());
                    match two {
                        Step::Union => a.turned().both(b.turned()).turned(),
                        Step::Intersection => a.both(b),
                        _ => a.both(b.turned()),
                    }
                }
            };
            values.push(value);
        }
        values.pop().unwrap_or(Slope::NOWHERE)
    }
}

impl Placement {
    /// The least t at which |f + g·t| + λt² could be zero, in the coordinates of the root.
    fn slope(&self, geometry: &Geometry, p: Vec3) -> Slope {
        let rows = &self.back.0;
        let Taylor { f, g, bend } = taylor(geometry, self.back.point(p));
        let g: Vec3 = std::array::from_fn(|j| (0..3).map(|i| rows[i][j] * g[i]).sum());
        let steep = length(g);
        let bend = bend * self.stretch * self.stretch;
        let root = (steep * steep + 4.0 * bend * f.abs()).sqrt();
        let distance = match steep + root > 0.0 {
            true => 2.0 * f / (steep + root),
            false if f == 0.0 => 0.0,
            false => f.signum() * f64::MAX,
        };
        let up = if steep > 0.0 {
            g.map(|x| x / steep)
        } else {
            [0.0; 3]
        };
        Slope { distance, up }
    }
}

/// A function that is below zero inside of a shape: its value at a point, its gradient, and a bound of
/// the second-order term.
struct Taylor {
    f: f64,
    g: Vec3,
    bend: f64,
}

fn flat(f: f64, g: Vec3) -> Taylor {
    Taylor { f, g, bend: 0.0 }
}

/// The larger of two is that of what both hold.
fn both(a: Taylor, b: Taylor) -> Taylor {
    if a.f > b.f { a } else { b }
}

fn taylor(geometry: &Geometry, p: Vec3) -> Taylor {
    let [x, y, z] = p;
    // (sign/unit²) of each square, what is added to their sum, and the part that is linear in y.
    let sum = |s: [f64; 3], constant: f64, linear: f64| Taylor {
        f: s[0] * x * x + s[1] * y * y + s[2] * z * z + linear * y + constant,
        g: [2.0 * s[0] * x, 2.0 * s[1] * y + linear, 2.0 * s[2] * z],
        bend: s.iter().fold(0.0f64, |m, s| m.max(s.abs())),
    };
    let unit = |a: f64| 1.0 / (a * a);
    let around = x.hypot(z);
    // A function of the distance from the axis and the height, from its two slopes.
    let turned = |f: f64, out: f64, up: f64| {
        let (cos, sin) = match around > 0.0 {
            true => (x / around, z / around),
            false => (1.0, 0.0),
        };
        flat(f, [out * cos, up, out * sin])
    };
    match *geometry {
        // Surfaces have no field.
        Geometry::Plane(_) | Geometry::Rectangle { .. } | Geometry::Triangle { .. } => {
            flat(f64::MAX, [1.0, 0.0, 0.0])
        }
        Geometry::HalfSpace([a, b, c, d]) => flat(a * x + b * y + c * z + d, [a, b, c]),
        Geometry::Sphere { centre, radius } => {
            let v = sub(p, centre);
            let away = length(v);
            let g = if away > 0.0 {
                v.map(|c| c / away)
            } else {
                [1.0, 0.0, 0.0]
            };
            flat(away - radius, g)
        }
        Geometry::Ellipsoid {
            semi_axes: [a, b, c],
        } => sum([unit(a), unit(b), unit(c)], -1.0, 0.0),
        Geometry::Box { min, max } => {
            let side = |i: usize, f: f64, g: f64| {
                flat(f, std::array::from_fn(|k| if k == i { g } else { 0.0 }))
            };
            let slab = |i: usize| both(side(i, p[i] - max[i], 1.0), side(i, min[i] - p[i], -1.0));
            both(both(slab(0), slab(1)), slab(2))
        }
        Geometry::GeodesicSphere { radius, splits } => {
            let [a, b, c] = facet(p, splits);
            let n = cross(sub(b, a), sub(c, a));
            let n = if dot(n, a) < 0.0 { n.map(|x| -x) } else { n };
            flat(dot(n, p) - radius * dot(n, a), n)
        }
        Geometry::Torus { major, minor } => {
            let ring = |middle: f64| {
                let out = around - middle;
                let away = out.hypot(y);
                match away > 0.0 {
                    true => turned(away - minor, out / away, y / away),
                    false => turned(-minor, 1.0, 0.0),
                }
            };
            let far = ring(-major);
            // By the even-odd rule.
            both(ring(major), flat(-far.f, far.g.map(|x| -x)))
        }
        Geometry::Quadric(q) => {
            let v = [x, y, z, 1.0];
            let row =
                |i: usize| -> f64 { (0..4).map(|j| (q[4 * i + j] + q[4 * j + i]) * v[j]).sum() };
            let squares = (0..9).map(|k| q[4 * (k / 3) + k % 3]).map(|x| x * x);
            Taylor {
                f: (0..4).map(|i| row(i) * v[i]).sum::<f64>() / 2.0,
                g: [0, 1, 2].map(row),
                bend: squares.sum::<f64>().sqrt(),
            }
        }
        Geometry::Cone { height, radius } => {
            let up = height.signum();
            cone(turned, around, up * y, up, height.abs(), radius)
        }
        Geometry::DoubleCone { height, radius } => {
            let up = if y < 0.0 { -1.0 } else { 1.0 };
            cone(turned, around, y.abs(), up, height.abs(), radius)
        }
        Geometry::ParabolicCylinder { a } => sum([unit(a), 0.0, 0.0], 0.0, -1.0),
        Geometry::HyperbolicCylinder { a, b } => sum([unit(a), -unit(b), 0.0], -1.0, 0.0),
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let constant = if sheets == 1 { -1.0 } else { 1.0 };
            sum([unit(a), -unit(b), unit(c)], constant, 0.0)
        }
        Geometry::HyperbolicParaboloid { a, b } => sum([unit(a), 0.0, -unit(b)], 0.0, -1.0),
        Geometry::Revolution { ref profile, .. } => {
            let (away, out, up) = nearest(profile, around, y);
            let inside = in_profile(profile, around, y);
            let sign = if inside { -1.0 } else { 1.0 };
            turned(sign * away, sign * out, sign * up)
        }
    }
}

/// A cone from its apex upwards, in its distance from the axis and its height.
fn cone(
    turned: impl Fn(f64, f64, f64) -> Taylor,
    around: f64,
    along: f64,
    up: f64,
    height: f64,
    radius: f64,
) -> Taylor {
    let slant = height.hypot(radius);
    let side = (around * height - along * radius) / slant;
    both(
        turned(along - height, 0.0, up),
        turned(side, height / slant, -up * radius / slant),
    )
}

/// How far a point is from a profile, closed as the language closes it, and the direction from there.
fn nearest(profile: &[[f64; 2]], x: f64, y: f64) -> (f64, f64, f64) {
    let (first, last) = (profile[0], profile[profile.len() - 1]);
    let ends = [[0.0, first[1]], [0.0, last[1]]];
    let pieces = profile.windows(2).map(|w| (w[0], w[1]));
    let closing = (first != last).then_some([(ends[0], first), (last, ends[1])]);
    let mut best = (f64::INFINITY, 1.0, 0.0);
    for (a, b) in pieces.chain(closing.into_iter().flatten()) {
        let (u, v) = (b[0] - a[0], b[1] - a[1]);
        let square = u * u + v * v;
        // What lies on the axis is no surface.
        if square == 0.0 || a[0] == 0.0 && b[0] == 0.0 {
            continue;
        }
        let t = (((x - a[0]) * u + (y - a[1]) * v) / square).clamp(0.0, 1.0);
        let (dx, dy) = (x - a[0] - t * u, y - a[1] - t * v);
        let away = dx.hypot(dy);
        if away < best.0 {
            best = match away > 0.0 {
                true => (away, dx / away, dy / away),
                false => (0.0, 1.0, 0.0),
            };
        }
    }
    best
}
