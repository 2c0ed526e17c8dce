//! Surfaces of second degree.

use super::exact::{Exact, Point, dot, minus, point};
use super::truth::{Answer, norm};
use zpg::internals::scene::Geometry;

/// The pairs of axes of mixed terms.
const PAIRS: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Σ squareᵢxᵢ² + mixed·(xy, xz, yz) + linear·x + constant ≤ 0, where x is taken from the centre.
/// Semi-axes are brought to whole numbers: (x/a)² + (y/b)² − 1 is (xb)² + (ya)² − (ab)².
pub struct Second {
    centre: Point,
    square: Point,
    mixed: Point,
    linear: Point,
    constant: Exact,
}

impl Second {
    pub fn new(geometry: &Geometry) -> Second {
        match *geometry {
            Geometry::Sphere { centre, radius } => Second {
                centre: point(centre),
                ..Second::canonical([1, 1, 1], 0, -1, [radius; 3])
            },
            Geometry::Ellipsoid { semi_axes } => Second::canonical([1, 1, 1], 0, -1, semi_axes),
            Geometry::ParabolicCylinder { a } => Second::canonical([1, 0, 0], -1, 0, [a, 1.0, 1.0]),
            Geometry::HyperbolicCylinder { a, b } => {
                Second::canonical([1, -1, 0], 0, -1, [a, b, 1.0])
            }
            Geometry::Hyperboloid { a, b, c, sheets } => {
                let constant = if sheets == 1 { -1 } else { 1 };
                Second::canonical([1, -1, 1], 0, constant, [a, b, c])
            }
            Geometry::HyperbolicParaboloid { a, b } => {
                Second::canonical([1, 0, -1], -1, 0, [a, 1.0, b])
            }
            Geometry::Quadric(ref q) => {
                let q = q.map(Exact::of);
                let both = |i: usize, j: usize| &q[4 * i + j] + &q[4 * j + i];
                Second {
                    centre: point([0.0; 3]),
                    square: std::array::from_fn(|i| q[5 * i].clone()),
                    mixed: PAIRS.map(|(i, j)| both(i, j)),
                    linear: std::array::from_fn(|i| both(i, 3)),
                    constant: q[15].clone(),
                }
            }
            _ => panic!("not of second degree"),
        }
    }

    /// Σ squareᵢ(xᵢ/unitᵢ)² + linear·y + constant, where y has the unit 1.
    fn canonical(square: [i64; 3], linear: i64, constant: i64, units: [f64; 3]) -> Second {
        let u = units.map(|x| Exact::of(x).square());
        let all = &u[0] * &u[1] * &u[2];
        let others: Point = std::array::from_fn(|i| &u[(i + 1) % 3] * &u[(i + 2) % 3]);
        Second {
            centre: point([0.0; 3]),
            square: std::array::from_fn(|i| Exact::whole(square[i]) * &others[i]),
            mixed: point([0.0; 3]),
            linear: [Exact::zero(), Exact::whole(linear) * &all, Exact::zero()],
            constant: Exact::whole(constant) * all,
        }
    }

    /// The terms of second degree.
    fn curved(&self, v: &Point) -> Exact {
        let mut sum = Exact::zero();
        for (s, x) in self.square.iter().zip(v) {
            if !s.is_zero() {
                sum = sum + s * x.square();
            }
        }
        for (m, (i, j)) in self.mixed.iter().zip(PAIRS) {
            if !m.is_zero() {
                sum = sum + m * (&v[i] * &v[j]);
            }
        }
        sum
    }

    fn value_from_centre(&self, p: &Point) -> Exact {
        self.curved(p) + dot(&self.linear, p) + &self.constant
    }

    fn gradient_from_centre(&self, p: &Point) -> Point {
        let mut g: Point =
            std::array::from_fn(|i| (&self.square[i] * &p[i]).twice() + &self.linear[i]);
        for (m, (i, j)) in self.mixed.iter().zip(PAIRS) {
            if !m.is_zero() {
                g[i] = &g[i] + m * &p[j];
                g[j] = &g[j] + m * &p[i];
            }
        }
        g
    }

    /// Negative inside.
    pub fn value(&self, p: &Point) -> Exact {
        self.value_from_centre(&minus(p, &self.centre))
    }

    pub fn answer(&self, o: &Point, d: &Point) -> Answer {
        let o = minus(o, &self.centre);
        // at² + 2bt + c
        let a = self.curved(d);
        let b = dot(&self.gradient_from_centre(&o), d).shifted(-1);
        let c = self.value_from_centre(&o);
        let (crossings, inside) = if !a.is_zero() {
            let discriminant = b.square() - &a * &c;
            (2 * usize::from(discriminant.is_positive()), a.is_negative())
        } else if !b.is_zero() {
            (1, b.is_positive())
        } else {
            (0, c.is_negative())
        };
        Answer {
            crossings,
            inside,
            within: a.is_zero() && b.is_zero() && c.is_zero(),
        }
    }

    /// The distance along the gradient or, if that is shorter, along some other direction: an upper
    /// bound on the true one, close to it where the surface is smooth.
    pub fn distance(&self, p: &Point, line: &Point) -> f64 {
        let p = minus(p, &self.centre);
        let value = self.value_from_centre(&p).about();
        if value == 0.0 {
            return 0.0;
        }
        let gradient = self.gradient_from_centre(&p);
        let along = |v: &Point| {
            // value + 2bs + as², the lesser root.
            let a = self.curved(v).about();
            let b = dot(&gradient, v).about() / 2.0;
            let discriminant = b * b - a * value;
            if discriminant < 0.0 {
                return f64::INFINITY;
            }
            let s = value / (b.abs() + discriminant.sqrt());
            let distance = s.abs() * norm(v);
            if distance.is_nan() {
                f64::INFINITY
            } else {
                distance
            }
        };
        // A vector of few digits is as good.
        let short = |v: &Point| {
            let largest = v.iter().map(Exact::top).max().unwrap_or(0);
            let v = [0, 1, 2].map(|i| v[i].shifted(-largest).about());
            point(v)
        };
        let unit = |i: usize| {
            let mut v = [0.0; 3];
            v[i] = 1.0;
            point(v)
        };
        [short(&gradient), short(line), unit(0), unit(1), unit(2)]
            .iter()
            .map(along)
            .fold(f64::INFINITY, f64::min)
    }
}
