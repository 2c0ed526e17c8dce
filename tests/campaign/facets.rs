//! The geodesic sphere, facet by facet.

use super::exact::{Exact, Point, along, cross, dot, minus, point};
use super::truth::{length, sides, triangle_distance};
use std::sync::OnceLock;

/// Digits of the vertices, which are irrational.
const DIGITS: i64 = 320;

/// What is less than 2 to minus this, in units of the sizes that go into it, is taken for zero: it
/// comes of the vertices' being cut off, as lines given by doubles are either much further from an
/// edge or meet it exactly.
const NOTHING: i64 = 240;

pub struct Facets {
    facets: Vec<Facet>,
    radius: f64,
}

/// Counter-clockwise as seen from outside.
struct Facet {
    vertices: [Point; 3],
    normal: Point,
    centre: [f64; 3],
    /// How far its corners are from its centre, at most.
    reach: f64,
}

impl Facets {
    pub fn new(radius: f64, splits: u32) -> Facets {
        let size = Exact::of(radius);
        let facet = |vertices: [Point; 3]| {
            let vertices = vertices.map(|v| v.map(|x| x * &size));
            let about = vertices.each_ref().map(|v| v.each_ref().map(Exact::about));
            let centre: [f64; 3] =
                std::array::from_fn(|i| (about[0][i] + about[1][i] + about[2][i]) / 3.0);
            let from_centre = |v: &[f64; 3]| length(std::array::from_fn(|i| v[i] - centre[i]));
            Facet {
                normal: cross(
                    &minus(&vertices[1], &vertices[0]),
                    &minus(&vertices[2], &vertices[0]),
                ),
                reach: about.iter().map(from_centre).fold(0.0, f64::max),
                vertices,
                centre,
            }
        };
        Facets {
            facets: unit_facets(splits).iter().cloned().map(facet).collect(),
            radius,
        }
    }

    /// The facets that a line may meet, told by their distances from it, with much to spare.
    fn near<'a>(&'a self, o: &Point, d: &Point) -> impl Iterator<Item = &'a Facet> {
        let t = (-dot(o, d)).over(&dot(d, d), 128).0;
        let foot = along(o, d, &t).map(|x| x.about());
        let largest = d.iter().map(Exact::top).max().unwrap_or(0);
        let way = d.each_ref().map(|x| x.shifted(-largest).about());
        let way = way.map(|x| x / length(way));
        self.facets.iter().filter(move |f| {
            let from: [f64; 3] = std::array::from_fn(|i| f.centre[i] - foot[i]);
            let along: f64 = (0..3).map(|i| from[i] * way[i]).sum();
            let apart = length(std::array::from_fn(|i| from[i] - along * way[i]));
            apart <= f.reach + 1e-3 * self.radius
        })
    }

    /// A line that meets an edge or a corner meets several facets in one place: it crosses there if
    /// it goes the same way through all of them, and touches if not.
    pub fn crossings(&self, o: &Point, d: &Point) -> usize {
        let size = |v: &Point| v.iter().map(Exact::top).max().unwrap_or(0);
        let radius = Exact::of(self.radius).top();
        let nothing = Exact::power_of_two(2 * size(o).max(radius) + size(d) - NOTHING);
        let sign = |x: &Exact| {
            if *x < nothing && -x < nothing {
                0
            } else {
                x.sign()
            }
        };
        let mut hits: Vec<(Exact, i32)> = Vec::new();
        for f in self.near(o, d) {
            let sides = sides(&f.vertices, o, d).map(|e| sign(&e));
            let way = if sides.contains(&1) { 1 } else { -1 };
            if sides == [0; 3] || sides.contains(&-way) {
                continue;
            }
            let height = dot(&minus(&f.vertices[0], o), &f.normal);
            hits.push((height.over(&dot(d, &f.normal), DIGITS).0, way));
        }
        hits.sort_by(|a, b| a.0.cmp(&b.0));
        // Half of the digits of t.
        let apart = Exact::power_of_two(size(o).max(radius) - size(d) - NOTHING / 2);
        let mut crossings = 0;
        let mut rest = &hits[..];
        while let Some((first, way)) = rest.first() {
            let here = rest.iter().take_while(|(t, _)| t - first < apart).count();
            crossings += usize::from(rest[..here].iter().all(|(_, w)| w == way));
            rest = &rest[here..];
        }
        crossings
    }

    /// Every way out of the inside meets the surface an odd number of times; in a direction that is
    /// not in line with anything.
    pub fn holds(&self, p: &Point) -> bool {
        let d = point([0.61803, 0.27182, 0.31415]);
        let ahead = self.near(p, &d).filter(|f| {
            let sides = sides(&f.vertices, p, &d).map(|e| e.sign());
            let through = sides == [1; 3] || sides == [-1; 3];
            let height = dot(&minus(&f.vertices[0], p), &f.normal);
            through && height.sign() == dot(&d, &f.normal).sign()
        });
        ahead.count() % 2 == 1
    }

    pub fn distance(&self, p: &Point) -> f64 {
        /// How many of the facets that seem nearest are looked at.
        const NEAREST: usize = 12;
        let about = p.each_ref().map(Exact::about);
        let from = |f: &Facet| length(std::array::from_fn(|i| f.centre[i] - about[i]));
        let mut order: Vec<(f64, &Facet)> = self.facets.iter().map(|f| (from(f), f)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let near = order.iter().take(NEAREST);
        near.map(|(_, f)| triangle_distance(&f.vertices, p))
            .fold(f64::INFINITY, f64::min)
    }
}

/// The facets of radius 1, which are made once.
fn unit_facets(splits: u32) -> &'static [[Point; 3]] {
    static MADE: [OnceLock<Vec<[Point; 3]>>; 10] = [const { OnceLock::new() }; 10];
    MADE[splits as usize].get_or_init(|| {
        let vertices = icosahedron();
        let mut list: Vec<[Point; 3]> = Vec::new();
        // Edges are those of the 66 pairs that are closest together, at a cosine of 1/√5.
        let joined = |i: usize, j: usize| dot(&vertices[i], &vertices[j]).about() > 0.4;
        for i in 0..12 {
            for j in i + 1..12 {
                for k in j + 1..12 {
                    if joined(i, j) && joined(j, k) && joined(k, i) {
                        let [a, b, c] = [i, j, k].map(|n| vertices[n].clone());
                        let outwards = dot(&cross(&a, &b), &c).is_positive();
                        list.push(if outwards { [a, b, c] } else { [a, c, b] });
                    }
                }
            }
        }
        assert_eq!(list.len(), 20);
        for _ in 0..splits {
            let split = |[a, b, c]: [Point; 3]| {
                let (ab, bc, ca) = (middle(&a, &b), middle(&b, &c), middle(&c, &a));
                [
                    [a, ab.clone(), ca.clone()],
                    [ab.clone(), b, bc.clone()],
                    [ca.clone(), bc.clone(), c],
                    [bc, ca, ab],
                ]
            };
            list = list.into_iter().flat_map(split).collect();
        }
        list
    })
}

/// (0, ±1, ±φ) and its cyclic permutations, on the unit sphere.
fn icosahedron() -> Vec<Point> {
    let phi = (Exact::whole(5).root(DIGITS).0 + Exact::whole(1)).shifted(-1);
    let mut list = Vec::new();
    for axis in 0..3 {
        for signs in 0..4 {
            let mut v = point([0.0; 3]);
            let signed = |x: Exact, negative: bool| if negative { -x } else { x };
            v[(axis + 1) % 3] = signed(Exact::whole(1), signs & 1 != 0);
            v[(axis + 2) % 3] = signed(phi.clone(), signs & 2 != 0);
            list.push(out_to_the_sphere(v));
        }
    }
    list
}

fn middle(a: &Point, b: &Point) -> Point {
    out_to_the_sphere(std::array::from_fn(|i| &a[i] + &b[i]))
}

/// Cut off towards zero, so that what is symmetric stays so.
fn out_to_the_sphere(v: Point) -> Point {
    let size = dot(&v, &v).root(DIGITS).0;
    v.map(|x| {
        if x.is_negative() {
            -(-x).over(&size, DIGITS).0
        } else {
            x.over(&size, DIGITS).0
        }
    })
}
