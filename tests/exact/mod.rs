//! The yardstick of the tests of precision: scenes evaluated in exact rational arithmetic.
//!
//! A solid is a Boolean combination of sets p < 0 with polynomials p of degree 2 or 4. On a line
//! they are polynomials in t, whose roots Sturm's theorem isolates, and between neighbouring roots
//! the combination is evaluated. Nothing here is rounded and nothing is shared with the tracer but
//! the reading of the scene; a surface is crossed where the state changes, so a touch is nothing.

pub mod algebra;

use algebra::{Poly, Q, Root, Whole, q, to_f64};
use std::cmp::Ordering;
use zpg::internals::scene::{Geometry, Node, NodeId, Scene};

type Map = [[Q; 4]; 3];

/// A polynomial in x, y, z.
#[derive(Debug, Clone)]
enum Form {
    /// (x, y, z, 1)ᵀ M (x, y, z, 1), M symmetric.
    Second(Box<[[Q; 4]; 4]>),
    /// (|p|² + R² − r²)² − 4R²(x² + z²), which is negative where an odd number of the two halves of
    /// a spindle hold p.
    Torus { shift: Q, four: Q },
}

#[derive(Debug, Clone)]
struct Surface {
    form: Form,
    /// From the scene's space to that of the form.
    back: Map,
}

#[derive(Debug, Clone)]
enum Set {
    /// Where a surface's form is negative.
    Under(usize),
    Not(Box<Set>),
    All(Vec<Set>),
    Any(Vec<Set>),
    /// The points in an odd number of them.
    Odd(Vec<Set>),
}

impl Set {
    fn holds(&self, under: &[bool]) -> bool {
        match self {
            Set::Under(i) => under[*i],
            Set::Not(a) => !a.holds(under),
            Set::All(parts) => parts.iter().all(|p| p.holds(under)),
            Set::Any(parts) => parts.iter().any(|p| p.holds(under)),
            Set::Odd(parts) => parts.iter().filter(|p| p.holds(under)).count() % 2 == 1,
        }
    }
}

/// The scene under one node, made ready.
#[derive(Debug, Clone)]
pub struct Exact {
    surfaces: Vec<Surface>,
    set: Set,
    /// Surfaces without inside.
    sheets: Vec<usize>,
    /// The largest length in the shapes.
    pub size: f64,
}

/// A change of sides.
#[derive(Debug, Clone)]
pub struct Change {
    pub t: Root,
    /// `None` for a surface without inside.
    pub entering: Option<bool>,
    /// The surfaces that are crossed here, as numbers of [`Exact::distance`].
    pub surfaces: Vec<usize>,
}

/// All of a ray.
#[derive(Debug)]
pub struct Answer {
    pub inside_at_origin: bool,
    pub changes: Vec<Change>,
}

fn identity() -> Map {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { Q::ONE } else { Q::ZERO }))
}

/// The inverse of an affine matrix, by cofactors.
fn inverse(m: &[[f64; 4]; 4]) -> Map {
    let a = |i: usize, j: usize| q(m[i % 3][j % 3]);
    let minor =
        |i: usize, j: usize| a(i + 1, j + 1) * a(i + 2, j + 2) - a(i + 1, j + 2) * a(i + 2, j + 1);
    let determinant = (0..3).fold(Q::ZERO, |sum, j| sum + a(0, j) * minor(0, j));
    let mut back = identity();
    for (i, row) in back.iter_mut().enumerate().take(3) {
        for (j, number) in row.iter_mut().enumerate().take(3) {
            *number = minor(j, i) / &determinant;
        }
        row[3] = -(0..3).fold(Q::ZERO, |sum, j| sum + &row[j] * q(m[j][3]));
    }
    back
}

/// First `b`, then `a`.
fn after(a: &Map, b: &Map) -> Map {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let last = if j == 3 { a[i][3].clone() } else { Q::ZERO };
            (0..3).fold(last, |sum, k| sum + &a[i][k] * &b[k][j])
        })
    })
}

impl Exact {
    /// The whole scene of a render record.
    pub fn new(scene: &Scene) -> Exact {
        Exact::of(scene, scene.render.unwrap().root)
    }

    pub fn of(scene: &Scene, node: NodeId) -> Exact {
        let mut exact = Exact {
            surfaces: Vec::new(),
            set: Set::Any(Vec::new()),
            sheets: Vec::new(),
            size: 0.0,
        };
        exact.set = exact.node(scene, node, &identity());
        exact
    }

    fn node(&mut self, scene: &Scene, node: NodeId, back: &Map) -> Set {
        match scene.nodes[node as usize] {
            Node::Shape(s) => self.shape(&scene.shapes[s as usize].geometry, back),
            Node::Union(a, b) => {
                Set::Any(vec![self.node(scene, a, back), self.node(scene, b, back)])
            }
            Node::Intersection(a, b) => {
                Set::All(vec![self.node(scene, a, back), self.node(scene, b, back)])
            }
            Node::Difference(a, b) => {
                let less = Set::Not(Box::new(self.node(scene, b, back)));
                Set::All(vec![self.node(scene, a, back), less])
            }
            Node::Complement(a) => Set::Not(Box::new(self.node(scene, a, back))),
            Node::Paint { child, .. } | Node::Copy { child, .. } => self.node(scene, child, back),
            Node::Transform { child, matrix } => {
                let step = inverse(&scene.matrices[matrix as usize].0);
                self.node(scene, child, &after(&step, back))
            }
        }
    }

    fn under(&mut self, form: Form, back: &Map) -> Set {
        self.surfaces.push(Surface {
            form,
            back: back.clone(),
        });
        Set::Under(self.surfaces.len() - 1)
    }

    /// a x + b y + c z + d < 0.
    fn half(&mut self, abcd: [Q; 4], back: &Map) -> Set {
        let mut m: [[Q; 4]; 4] = Default::default();
        let [a, b, c, d] = abcd;
        for (i, x) in [a, b, c].into_iter().enumerate() {
            m[i][3] = x / Q::from(2u32);
            m[3][i] = m[i][3].clone();
        }
        m[3][3] = d;
        self.under(Form::Second(m.into()), back)
    }

    /// a x² + b y² + c z² + e y + d < 0.
    fn round(&mut self, [a, b, c]: [Q; 3], e: Q, d: Q, back: &Map) -> Set {
        let mut m: [[Q; 4]; 4] = Default::default();
        (m[0][0], m[1][1], m[2][2], m[3][3]) = (a, b, c, d);
        m[1][3] = e / Q::from(2u32);
        m[3][1] = m[1][3].clone();
        self.under(Form::Second(m.into()), back)
    }

    /// low < coordinate < high.
    fn between(&mut self, axis: usize, low: f64, high: f64, back: &Map) -> Set {
        let row = |factor: Q, d: Q| {
            let mut r: [Q; 4] = Default::default();
            (r[axis], r[3]) = (factor, d);
            r
        };
        let above = self.half(row(-Q::ONE, q(low)), back);
        let below = self.half(row(Q::ONE, -q(high)), back);
        Set::All(vec![above, below])
    }

    fn shape(&mut self, geometry: &Geometry, back: &Map) -> Set {
        let one = || Q::ONE;
        let over = |a: f64| Q::ONE / (q(a) * q(a));
        let mut size = |lengths: &[f64]| {
            self.size = lengths.iter().fold(self.size, |s, x| s.max(x.abs()));
        };
        match *geometry {
            Geometry::Sphere { centre, radius } => {
                size(&[radius]);
                let mut map = identity();
                for i in 0..3 {
                    map[i][3] = -q(centre[i]);
                }
                let d = -(q(radius) * q(radius));
                self.round([one(), one(), one()], Q::ZERO, d, &after(&map, back))
            }
            Geometry::Ellipsoid { semi_axes } => {
                size(&semi_axes);
                self.round(semi_axes.map(over), Q::ZERO, -one(), back)
            }
            Geometry::Box { min, max } => {
                size(&min);
                size(&max);
                Set::All(
                    (0..3)
                        .map(|i| self.between(i, min[i], max[i], back))
                        .collect(),
                )
            }
            Geometry::HalfSpace(abcd) => self.half(abcd.map(q), back),
            Geometry::Plane(abcd) => {
                self.half(abcd.map(q), back);
                self.sheets.push(self.surfaces.len() - 1);
                Set::Any(Vec::new())
            }
            Geometry::Torus { major, minor } => {
                size(&[major + minor]);
                let (r2, m2) = (q(major) * q(major), q(minor) * q(minor));
                let form = Form::Torus {
                    shift: &r2 - m2,
                    four: r2 * Q::from(4u32),
                };
                self.under(form, back)
            }
            Geometry::Quadric(ref m) => {
                let matrix: [[Q; 4]; 4] = std::array::from_fn(|i| {
                    std::array::from_fn(|j| (q(m[4 * i + j]) + q(m[4 * j + i])) / Q::from(2u32))
                });
                self.under(Form::Second(matrix.into()), back)
            }
            Geometry::Cone { height, radius } => {
                size(&[height, radius]);
                let r = over(radius);
                let side = self.round([r.clone(), -over(height), r], Q::ZERO, Q::ZERO, back);
                let (low, high) = (height.min(0.0), height.max(0.0));
                Set::All(vec![side, self.between(1, low, high, back)])
            }
            Geometry::DoubleCone { height, radius } => {
                size(&[height, radius]);
                let r = over(radius);
                let side = self.round([r.clone(), -over(height), r], Q::ZERO, Q::ZERO, back);
                Set::All(vec![
                    side,
                    self.between(1, -height.abs(), height.abs(), back),
                ])
            }
            Geometry::ParabolicCylinder { a } => {
                self.round([over(a), Q::ZERO, Q::ZERO], -one(), Q::ZERO, back)
            }
            Geometry::HyperbolicCylinder { a, b } => {
                self.round([over(a), -over(b), Q::ZERO], Q::ZERO, -one(), back)
            }
            Geometry::Hyperboloid { a, b, c, sheets } => {
                let d = if sheets == 1 { -one() } else { one() };
                self.round([over(a), -over(b), over(c)], Q::ZERO, d, back)
            }
            Geometry::HyperbolicParaboloid { a, b } => {
                self.round([over(a), Q::ZERO, -over(b)], -one(), Q::ZERO, back)
            }
            Geometry::Revolution { ref profile, .. } => {
                size(profile.as_flattened());
                let pairs = profile.windows(2).filter(|p| p[0][1] != p[1][1]);
                Set::Odd(pairs.map(|p| self.within(p[0], p[1], back)).collect())
            }
            ref other => panic!("no exact form of {other:?}"),
        }
    }

    /// Points of a surface of revolution that are nearer to the axis than an edge of the profile.
    fn within(&mut self, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2], back: &Map) -> Set {
        let slope = (q(x1) - q(x0)) / (q(y1) - q(y0));
        // ρ² < (x₀ + (y − y₀) slope)² = (slope y + c)².
        let c = q(x0) - q(y0) * &slope;
        let two = Q::from(2u32);
        let side = self.round(
            [Q::ONE, -(&slope * &slope), Q::ONE],
            -(two * &slope * &c),
            -(&c * &c),
            back,
        );
        // Half-open, so that a line that lies in the plane of a seam is of one segment.
        let (low, high) = (y0.min(y1), y0.max(y1));
        let below = |y: f64| [Q::ZERO, Q::ONE, Q::ZERO, -q(y)];
        let lower = Set::Not(Box::new(self.half(below(low), back)));
        Set::All(vec![side, lower, self.half(below(high), back)])
    }

    /// Everything on a ray with t > 0, ascending.
    pub fn trace(&self, o: [f64; 3], d: [f64; 3]) -> Answer {
        let (o, d) = (o.map(q), d.map(q));
        let polys: Vec<Poly> = self.surfaces.iter().map(|s| s.along(&o, &d)).collect();
        let mut events: Vec<(Root, Vec<usize>)> = vec![(Root::rational(Q::ZERO), Vec::new())];
        for (i, poly) in polys.iter().enumerate() {
            for mut root in poly.roots() {
                let found = events.binary_search_by(|e| e.0.clone().compare(&mut root));
                match found {
                    Ok(k) => events[k].1.push(i),
                    Err(k) => events.insert(k, (root, vec![i])),
                }
            }
        }
        // Separate neighbours, so that a rational number lies between.
        for k in 1..events.len() {
            let (left, right) = events.split_at_mut(k);
            let (a, b) = (&mut left[k - 1].0, &mut right[0].0);
            while a.high >= b.low {
                a.refine();
                b.refine();
            }
        }
        let whole: Vec<Whole> = polys.iter().map(Poly::whole).collect();
        let state = |t: &Q| {
            let under: Vec<bool> = whole.iter().map(|p| p.sign(t) < 0).collect();
            self.set.holds(&under)
        };
        let first = events.iter().position(|e| e.1.is_empty() || is_zero(&e.0));
        let first = first.unwrap();
        let after = |k: usize| match events.get(k + 1) {
            Some(next) => state(&((&events[k].0.high + &next.0.low) / Q::from(2u32))),
            None => state(&(&events[k].0.high + Q::ONE)),
        };
        let mut inside = after(first);
        let inside_at_origin = inside;
        let mut changes = Vec::new();
        for (k, (t, surfaces)) in events.iter().enumerate().skip(first + 1) {
            let now = after(k);
            let sheet = surfaces.iter().any(|s| self.sheets.contains(s));
            if now != inside || sheet {
                changes.push(Change {
                    t: t.clone(),
                    entering: (now != inside).then_some(now),
                    surfaces: surfaces.clone(),
                });
            }
            inside = now;
        }
        Answer {
            inside_at_origin,
            changes,
        }
    }

    /// The distance of a point from a surface, to first order: |f| / |∇f|.
    pub fn distance(&self, surface: usize, p: &[Q; 3]) -> f64 {
        let (value, gradient) = self.surfaces[surface].gradient(p);
        let square = gradient.iter().fold(Q::ZERO, |sum, g| sum + g * g);
        if value.is_zero() {
            return 0.0;
        }
        to_f64(&((&value * &value) / square)).sqrt()
    }
}

fn is_zero(root: &Root) -> bool {
    let mut root = root.clone();
    root.compare(&mut Root::rational(Q::ZERO)) == Ordering::Equal
}

impl Surface {
    fn vector(&self, v: &[Q; 3]) -> [Q; 3] {
        std::array::from_fn(|i| (0..3).fold(Q::ZERO, |sum, j| sum + &self.back[i][j] * &v[j]))
    }

    fn point(&self, p: &[Q; 3]) -> [Q; 3] {
        let v = self.vector(p);
        std::array::from_fn(|i| &v[i] + &self.back[i][3])
    }

    /// The form along a line.
    fn along(&self, o: &[Q; 3], d: &[Q; 3]) -> Poly {
        let (o, d) = (self.point(o), self.vector(d));
        let linear = |i: usize| match i {
            3 => Poly::new(vec![Q::ONE]),
            _ => Poly::new(vec![o[i].clone(), d[i].clone()]),
        };
        let zero = || Poly::new(Vec::new());
        match &self.form {
            Form::Second(m) => {
                let mut sum = zero();
                for (i, row) in m.iter().enumerate() {
                    for (j, factor) in row.iter().enumerate() {
                        if !factor.is_zero() {
                            sum = sum.plus(&linear(i).times(&linear(j)), factor);
                        }
                    }
                }
                sum
            }
            Form::Torus { shift, four } => {
                let square = |i: usize| linear(i).times(&linear(i));
                let flat = square(0).plus(&square(2), &Q::ONE);
                let all = flat.plus(&square(1), &Q::ONE);
                let all = all.plus(&Poly::new(vec![Q::ONE]), shift);
                all.times(&all).plus(&flat, &-four)
            }
        }
    }

    /// The form and its gradient at a point of the scene's space.
    fn gradient(&self, p: &[Q; 3]) -> (Q, [Q; 3]) {
        let p = self.point(p);
        let (value, local): (Q, [Q; 3]) = match &self.form {
            Form::Second(m) => {
                let h = [p[0].clone(), p[1].clone(), p[2].clone(), Q::ONE];
                let rows: [Q; 4] =
                    std::array::from_fn(|i| (0..4).fold(Q::ZERO, |sum, j| sum + &m[i][j] * &h[j]));
                let value = (0..4).fold(Q::ZERO, |sum, i| sum + &rows[i] * &h[i]);
                (value, std::array::from_fn(|i| &rows[i] * Q::from(2u32)))
            }
            Form::Torus { shift, four } => {
                let flat = &p[0] * &p[0] + &p[2] * &p[2];
                let all = &flat + &p[1] * &p[1] + shift;
                let value = &all * &all - four * flat;
                let gradient = std::array::from_fn(|i| {
                    let ring = if i == 1 {
                        Q::ZERO
                    } else {
                        four * Q::from(2u32)
                    };
                    (&all * Q::from(4u32) - ring) * &p[i]
                });
                (value, gradient)
            }
        };
        let gradient = std::array::from_fn(|j| {
            (0..3).fold(Q::ZERO, |sum, i| sum + &self.back[i][j] * &local[i])
        });
        (value, gradient)
    }
}
