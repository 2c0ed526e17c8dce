//! The shapes by their definitions in the language, and what is true of a line and a point.
//!
//! Nothing here is rounded but the last steps of a distance. It shares no code and no method with
//! the kernel: second-degree surfaces are judged by the sign of an exact discriminant, the torus by
//! Sturm's theorem, solids of revolution by points between all places where a line could change
//! sides.

use super::exact::{Exact, Point, along, cross, dot, minus, point};
use super::facets::Facets;
use super::roots::sign_changes;
use super::second::Second;
use super::turned::Turned;
use zpg::internals::scene::Geometry;

/// What a line does at a shape. A touch has no inside and is not counted, and neither is a line
/// that lies in the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Answer {
    pub crossings: usize,
    /// Whether it comes from inside.
    pub inside: bool,
    /// Whether it lies in the surface all along, which is neither inside nor outside.
    pub within: bool,
}

impl Answer {
    /// Whether this many crossings, from this side, are right.
    pub fn admits(self, crossings: usize, inside: bool) -> bool {
        self.crossings == crossings && (self.inside == inside || self.within)
    }

    fn outside(crossings: usize) -> Answer {
        Answer {
            crossings,
            inside: false,
            within: false,
        }
    }
}

pub enum Truth {
    Second(Second),
    Turned(Turned),
    Facets(Facets),
    Torus {
        major: Exact,
        minor: Exact,
    },
    Cuboid {
        min: Point,
        max: Point,
    },
    Plane {
        normal: Point,
        d: Exact,
        solid: bool,
    },
    Rectangle {
        min: [Exact; 2],
        max: [Exact; 2],
    },
    Triangle([Point; 3]),
}

impl Truth {
    pub fn new(geometry: &Geometry) -> Truth {
        let plane = |abcd: [f64; 4], solid| Truth::Plane {
            normal: point([abcd[0], abcd[1], abcd[2]]),
            d: Exact::of(abcd[3]),
            solid,
        };
        match *geometry {
            Geometry::Plane(abcd) => plane(abcd, false),
            Geometry::HalfSpace(abcd) => plane(abcd, true),
            Geometry::Rectangle { min, max } => Truth::Rectangle {
                min: min.map(Exact::of),
                max: max.map(Exact::of),
            },
            Geometry::Triangle { ref vertices, .. } => Truth::Triangle(vertices.map(point)),
            Geometry::Box { min, max } => Truth::Cuboid {
                min: point(min),
                max: point(max),
            },
            Geometry::Torus { major, minor } => Truth::Torus {
                major: Exact::of(major),
                minor: Exact::of(minor),
            },
            Geometry::GeodesicSphere { radius, splits } => {
                Truth::Facets(Facets::new(radius, splits))
            }
            Geometry::Revolution { ref profile, .. } => Truth::Turned(Turned::new(profile)),
            // A cone is a slanted line turned about the axis, closed by its base; the double cone
            // is two of them.
            Geometry::Cone { height, radius } => {
                Truth::Turned(Turned::new(&[[0.0, 0.0], [radius, height]]))
            }
            Geometry::DoubleCone { height, radius } => Truth::Turned(Turned::new(&[
                [radius, -height],
                [0.0, 0.0],
                [radius, height],
            ])),
            _ => Truth::Second(Second::new(geometry)),
        }
    }

    pub fn is_solid(&self) -> bool {
        !matches!(
            self,
            Truth::Plane { solid: false, .. } | Truth::Rectangle { .. } | Truth::Triangle(_)
        )
    }

    /// How often a line crosses the surface.
    pub fn answer(&self, o: &Point, d: &Point) -> Answer {
        match self {
            Truth::Second(s) => s.answer(o, d),
            Truth::Turned(s) => Answer::outside(s.crossings(o, d)),
            Truth::Facets(s) => Answer::outside(s.crossings(o, d)),
            Truth::Torus { major, minor } => Answer::outside(torus(major, minor, o, d)),
            Truth::Cuboid { min, max } => Answer::outside(cuboid(min, max, o, d)),
            Truth::Plane {
                normal,
                d: k,
                solid,
            } => {
                let slope = dot(normal, d);
                let value = dot(normal, o) + k;
                Answer {
                    crossings: usize::from(!slope.is_zero()),
                    inside: *solid
                        && if slope.is_zero() {
                            value.is_negative()
                        } else {
                            slope.is_positive()
                        },
                    within: *solid && slope.is_zero() && value.is_zero(),
                }
            }
            Truth::Rectangle { min, max } => {
                // At t = −z/dz, times dz.
                let hit = !d[2].is_zero()
                    && (0..2).all(|i| {
                        let p = &o[i] * &d[2] - &d[i] * &o[2];
                        let above = (&p - &min[i] * &d[2]).sign() * d[2].sign();
                        let below = (&max[i] * &d[2] - &p).sign() * d[2].sign();
                        above >= 0 && below >= 0
                    });
                Answer::outside(usize::from(hit))
            }
            Truth::Triangle(vertices) => {
                let sides = sides(vertices, o, d).map(|e| e.sign());
                let hit = sides != [0; 3]
                    && (sides.iter().all(|&s| s >= 0) || sides.iter().all(|&s| s <= 0));
                Answer::outside(usize::from(hit))
            }
        }
    }

    /// Whether a point is inside of a solid or on its surface. On a surface of revolution it may be
    /// either.
    pub fn holds(&self, p: &Point) -> bool {
        match self {
            Truth::Second(s) => !s.value(p).is_positive(),
            Truth::Turned(s) => s.holds(p),
            Truth::Facets(s) => s.holds(p),
            Truth::Torus { major, minor } => {
                let (k, s) = torus_parts(major, minor, p);
                !(k.square() - s).is_positive()
            }
            Truth::Cuboid { min, max } => (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i]),
            Truth::Plane { normal, d, solid } => *solid && !(dot(normal, p) + d).is_positive(),
            Truth::Rectangle { .. } | Truth::Triangle(_) => false,
        }
    }

    /// How far a point is from the surface, or a little more: right to some ten digits however
    /// small it is, as long as it is small. `line` is a direction in which to look for the surface
    /// where the normal is no help.
    pub fn distance(&self, p: &Point, line: &Point) -> f64 {
        match self {
            Truth::Second(s) => s.distance(p, line),
            Truth::Turned(s) => s.distance(p),
            Truth::Facets(s) => s.distance(p),
            Truth::Torus { major, minor } => torus_distance(major, minor, p),
            Truth::Cuboid { min, max } => {
                let below: [f64; 3] = std::array::from_fn(|i| (&min[i] - &p[i]).about());
                let above: [f64; 3] = std::array::from_fn(|i| (&p[i] - &max[i]).about());
                let out: [f64; 3] = std::array::from_fn(|i| below[i].max(above[i]));
                if out.iter().any(|&x| x > 0.0) {
                    length(out.map(|x| x.max(0.0)))
                } else {
                    -out[0].max(out[1]).max(out[2])
                }
            }
            Truth::Plane { normal, d, .. } => (dot(normal, p) + d).about().abs() / norm(normal),
            Truth::Rectangle { min, max } => {
                let out = |i: usize| {
                    let (below, above) = (&min[i] - &p[i], &p[i] - &max[i]);
                    below.max(above).max(Exact::zero()).about()
                };
                length([out(0), out(1), p[2].about()])
            }
            Truth::Triangle(vertices) => triangle_distance(vertices, p),
        }
    }
}

pub fn length(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// The length of a vector, about.
pub fn norm(v: &Point) -> f64 {
    length([v[0].about(), v[1].about(), v[2].about()])
}

/// On which sides of the edges a line passes: twice the volumes of the tetrahedra of its direction
/// and the edges, all of one sign where it passes through.
pub fn sides(vertices: &[Point; 3], o: &Point, d: &Point) -> [Exact; 3] {
    let seen: [Point; 3] = std::array::from_fn(|i| minus(&vertices[i], o));
    std::array::from_fn(|i| dot(&cross(&seen[i], &seen[(i + 1) % 3]), d))
}

pub fn triangle_distance(vertices: &[Point; 3], p: &Point) -> f64 {
    let [a, b, c] = vertices;
    let normal = cross(&minus(b, a), &minus(c, a));
    let ends = |i: usize| (&vertices[i], &vertices[(i + 1) % 3]);
    let over = (0..3).all(|i| {
        let (v, w) = ends(i);
        !dot(&cross(&minus(w, v), &minus(p, v)), &normal).is_negative()
    });
    if over {
        return dot(&normal, &minus(p, a)).about().abs() / norm(&normal);
    }
    let edges = (0..3).map(|i| {
        let (v, w) = ends(i);
        let (edge, from, back) = (minus(w, v), minus(p, v), minus(p, w));
        if dot(&edge, &from).is_negative() {
            norm(&from)
        } else if dot(&edge, &back).is_positive() {
            norm(&back)
        } else {
            norm(&cross(&edge, &from)) / norm(&edge)
        }
    });
    edges.fold(f64::INFINITY, f64::min)
}

/// The open box has an inside on the line where its way in, the last of the three, is before its
/// way out, the first of the three.
fn cuboid(min: &Point, max: &Point, o: &Point, d: &Point) -> usize {
    // Of the form (numerator, denominator), where that is positive.
    let mut ways: [Vec<(Exact, Exact)>; 2] = Default::default();
    for i in 0..3 {
        let (below, above) = (&min[i] - &o[i], &max[i] - &o[i]);
        match d[i].sign() {
            0 if below.is_negative() && above.is_positive() => {}
            0 => return 0,
            1 => {
                ways[0].push((below, d[i].clone()));
                ways[1].push((above, d[i].clone()));
            }
            _ => {
                ways[0].push((-above, -&d[i]));
                ways[1].push((-below, -&d[i]));
            }
        }
    }
    let before = |a: &(Exact, Exact), b: &(Exact, Exact)| &a.0 * &b.1 < &b.0 * &a.1;
    let inside = ways[0].iter().all(|a| ways[1].iter().all(|b| before(a, b)));
    if inside { 2 } else { 0 }
}

/// x² + y² + z² + R² − r² and 4R²(x² + z²): inside is where the square of the first is less than
/// the second, once in the tube; twice inside is outside.
fn torus_parts(major: &Exact, minor: &Exact, p: &Point) -> (Exact, Exact) {
    let (r2, m2) = (major.square(), minor.square());
    let across = p[0].square() + p[2].square();
    let k = &across + p[1].square() + &r2 - m2;
    (k, (r2 * across).shifted(2))
}

fn torus(major: &Exact, minor: &Exact, o: &Point, d: &Point) -> usize {
    let (a, b) = (dot(d, d), dot(o, d));
    let reach = (major + minor).square();
    // A line that does not come into the sphere around it needs no more.
    if !(b.square() - &a * (dot(o, o) - reach)).is_positive() {
        return 0;
    }
    let (k, s) = torus_parts(major, minor, o);
    let r2 = major.square().shifted(2);
    let flat = |v: &Point, w: &Point| &v[0] * &w[0] + &v[2] * &w[2];
    let b2 = b.twice();
    let coefficients = [
        k.square() - s,
        (&k * &b2 - &r2 * flat(o, d)).twice(),
        (&a * &k).twice() + b2.square() - r2 * flat(d, d),
        (&a * &b2).twice(),
        a.square(),
    ];
    // In a unit of t in which the coefficients are of like sizes, and their integers short.
    let size = |v: &Point| v.iter().map(Exact::top).max().unwrap_or(0);
    let unit = size(o).max(major.top()) - size(d);
    let shifted: Vec<Exact> = (0..)
        .zip(&coefficients)
        .map(|(i, c)| c.shifted(i * unit))
        .collect();
    sign_changes(&shifted)
}

/// The least distance from the two circles (ρ ± R)² + y² = r² that the tube and its image make in
/// the half-plane of a point.
fn torus_distance(major: &Exact, minor: &Exact, p: &Point) -> f64 {
    /// Digits of ρ.
    const DIGITS: i64 = 256;
    let rho = (p[0].square() + p[2].square()).root(DIGITS).0;
    let from = |h: Exact| {
        let square = h.square() + p[1].square();
        let across = square.about().sqrt() + minor.about();
        (square - minor.square()).about().abs() / across
    };
    from(&rho - major).min(from(&rho + major))
}

/// Whether sides are right between the crossings that were found: points halfway between two of
/// them are in the solid and outside of it by turns, or closer to the surface than `tolerance`.
pub fn alternates(
    truth: &Truth,
    (o, d): (&Point, &Point),
    t: &[Exact],
    inside: bool,
    tolerance: f64,
) -> bool {
    t.windows(2).enumerate().all(|(i, w)| {
        let p = along(o, d, &(&w[0] + &w[1]).shifted(-1));
        let expected = inside == (i % 2 == 1);
        truth.holds(&p) == expected || truth.distance(&p, d) <= tolerance
    })
}
