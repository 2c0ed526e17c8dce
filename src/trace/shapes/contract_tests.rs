//! Tori, triangles and geodesic spheres against lines that nearly touch them: what doubles decide is
//! what double-double decides, and crossings are on the surface.

use super::facet::tests::Random;
use super::geodesic_sphere::{GeodesicSphere, MAX_SPLITS};
use super::torus::Torus;
use super::triangle::Triangle;
use super::{Intersect, Roots};
use crate::geometry::affine::Affine;
use crate::geometry::dd::Dd;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::scene::TriangleNormals;
use std::f64::consts::TAU;

/// A number in double-double, exactly.
fn exact<R: Traced>(x: R) -> Dd {
    let high = x.to_f64();
    Dd::sum(high, (x - R::of(high)).to_f64())
}

fn lift<R: Traced, S: Traced>(v: Vec3<R>) -> Vec3<S> {
    Vec3(v.0.map(|x| S::of(x.to_f64())))
}

fn any_of<T, const N: usize>(random: &mut Random, list: [T; N]) -> T {
    let i = random.next() as usize % N;
    list.into_iter().nth(i).expect("i is below N")
}

/// The results of a run of lines.
#[derive(Default, Debug)]
struct Tally {
    lines: u32,
    crossings: u32,
    doubtful: u32,
}

impl Tally {
    /// The machine epsilon, of double-double 2⁻¹⁰⁰, 64 times over.
    const BACKWARD_ERROR: f64 = 64.0;

    /// Crossings ascend and are on the surface, but for so many machine epsilons of the larger of
    /// the origin's distance and the size.
    fn backward<R: Traced>(
        epsilon: f64,
        line: &Line<R>,
        roots: &Roots<R>,
        size: f64,
        distance: &dyn Fn(Vec3<Dd>, u32) -> Dd,
    ) {
        let (o, d) = (
            Vec3(line.origin.0.map(exact)),
            Vec3(line.direction.0.map(exact)),
        );
        let reach = size.max(o.length().to_f64());
        for pair in roots.list.windows(2) {
            assert!(pair[0].t < pair[1].t);
        }
        for root in &roots.list {
            let off = distance(o + d * exact(root.t), root.face).to_f64() / (epsilon * reach);
            assert!(off <= Tally::BACKWARD_ERROR, "{off} {line:?} {roots:?}");
        }
    }

    /// A line in doubles, and the same in double-double, which is the one that is meant.
    fn check<S: Intersect<f32> + Intersect<f64> + Intersect<Dd> + std::fmt::Debug>(
        &mut self,
        shape: &S,
        (plain, meant): (&Line<f64>, &Line<Dd>),
        size: f64,
        distance: &dyn Fn(Vec3<Dd>, u32) -> Dd,
    ) {
        let (mut short, mut found, mut truth) =
            (Roots::default(), Roots::default(), Roots::default());
        let rough = Line::<f32>::new(lift(plain.origin), lift(plain.direction));
        shape.crossings(&rough, &mut short);
        shape.crossings(plain, &mut found);
        shape.crossings(meant, &mut truth);
        self.lines += 1;
        self.crossings += found.list.len() as u32;
        self.doubtful += u32::from(found.uncertain);
        if !found.uncertain {
            assert!(
                !truth.uncertain
                    && found.list.len() == truth.list.len()
                    && found.inside == truth.inside,
                "{shape:?} {plain:?}\n{found:?}\n{truth:?}"
            );
        }
        Tally::backward(f32::EPSILON.into(), &rough, &short, size, distance);
        Tally::backward(f64::EPSILON, plain, &found, size, distance);
        Tally::backward(0.5f64.powi(100), meant, &truth, size, distance);
    }

    /// Half of the lines come closer to a decision than any double could tell, and most of them
    /// from far: the others are decided.
    fn decides(&self) {
        assert!(self.doubtful > self.lines / 20, "{self:?}");
        assert!(self.doubtful < self.lines / 3 * 2, "{self:?}");
        assert!(self.crossings > self.lines / 5, "{self:?}");
    }

    /// A line through the target from so far away, as it is and through a random placement.
    fn aim<S: Intersect<f32> + Intersect<f64> + Intersect<Dd> + std::fmt::Debug>(
        &mut self,
        random: &mut Random,
        shape: &S,
        (target, direction): (Vec3, Vec3),
        size: f64,
        distance: &dyn Fn(Vec3<Dd>, u32) -> Dd,
    ) {
        let furthest = any_of(random, [1.0, 4.0, 8.0]);
        let away = size * random.length(-1.0, furthest);
        let direction = direction.unit();
        let origin = target - direction * away;
        let direction = direction * random.length(-6.0, 6.0);
        let line = Line::new(origin, direction);
        let meant = Line::new(lift(origin), lift(direction));
        self.check(shape, (&line, &meant), size, distance);

        let (x, y) = (random.point(1.0).unit(), random.point(1.0));
        let z = x.cross(y).unit();
        let scale = random.length(-6.0, 6.0);
        let rows = [x, z.cross(x), z].map(|row| row * scale);
        let offset = random.length(-3.0, 6.0) * size;
        let offset = random.point(offset);
        let to_world = |v: Vec3| (rows[0] * v[0] + rows[1] * v[1] + rows[2] * v[2]) / scale / scale;
        let (origin, direction) = (to_world(origin - offset), to_world(direction));
        let plain = Affine::of(rows, offset);
        let fine = Affine::of(rows.map(lift::<f64, Dd>), lift(offset));
        let line = Line::new(origin, direction).through(&plain);
        let meant = Line::new(lift(origin), lift(direction)).through(&fine);
        self.check(shape, (&line, &meant), size, distance);
    }
}

/// How far beside the surface a line is aimed: from nothing to a tenth of the size.
fn beside(random: &mut Random) -> f64 {
    match random.next() % 8 {
        0 => 0.0,
        _ => random.length(-17.0, -1.0) * any_of(random, [1.0, -1.0]),
    }
}

/// A point of a torus's surface, the normal there, and a direction that touches the torus: any one,
/// or one along which the surface does not curve, so that three or four crossings meet there.
fn tangent(random: &mut Random, major: f64, minor: f64) -> (Vec3, Vec3, Vec3) {
    let turn = random.within(0.0, TAU);
    let tube = match random.next() % 8 {
        0 => TAU / 4.0,
        1 => TAU / 2.0,
        2 => 0.0,
        _ => random.within(0.0, TAU),
    };
    let (cos, sin) = (turn.cos(), turn.sin());
    let outwards = Vec3::new(cos * tube.cos(), tube.sin(), sin * tube.cos());
    let along_tube = Vec3::new(-cos * tube.sin(), tube.cos(), -sin * tube.sin());
    let along_ring = Vec3::new(-sin, 0.0, cos);
    let rho = major + minor * tube.cos();
    let point = Vec3::new(cos * rho, minor * tube.sin(), sin * rho);
    // The curvatures are 1/r around the tube and cos/ρ around the axis.
    let ratio = -tube.cos() * minor / rho;
    let direction = match random.next() % 4 {
        0 if ratio >= 0.0 => along_ring + along_tube * ratio.sqrt(),
        1 => along_ring,
        2 => along_tube,
        _ => {
            let angle = random.within(0.0, TAU);
            along_ring * angle.cos() + along_tube * angle.sin()
        }
    };
    (point, outwards, direction)
}

fn torus_distance(major: f64, minor: f64) -> impl Fn(Vec3<Dd>, u32) -> Dd {
    move |p, _| {
        let rho = (p[0] * p[0] + p[2] * p[2]).sqrt();
        let off = |centre: f64| {
            let h = rho - Dd::of(centre);
            ((h * h + p[1] * p[1]).sqrt() - Dd::of(minor)).abs()
        };
        off(major).min(off(-major))
    }
}

fn tori(seed: u64, ratio: f64, lines: u32) -> Tally {
    let (mut random, mut tally) = (Random(seed), Tally::default());
    while tally.lines < lines {
        let size = random.length(-6.0, 6.0);
        let (major, minor) = (size, size * ratio);
        let torus = Torus::new(major, minor);
        let (point, normal, direction) = tangent(&mut random, major, minor);
        let target = point + normal * (size.max(minor) * beside(&mut random));
        let distance = torus_distance(major, minor);
        let reach = major + minor;
        tally.aim(&mut random, &torus, (target, direction), reach, &distance);
    }
    tally
}

#[test]
fn tori_doubt_what_rounding_may_change() {
    let all = [0.25, 1.0, 1e-4, 1.5, 20.0, 1e-7];
    for (i, ratio) in all.into_iter().enumerate() {
        tori(i as u64, ratio, 20_000).decides();
    }
}

/// The distance of a point from a triangle, less what the rounding of the normal makes of it: a
/// thin triangle's is known to few digits.
fn triangle_distance(p: Vec3<Dd>, corners: [Vec3<Dd>; 3]) -> Dd {
    let [a, b, c] = corners;
    let n = (b - a).cross(c - a);
    let terms = (b - a).length() * (c - a).length();
    let told = Dd::of(8.0) * Dd::ROUNDOFF * terms / n.length() * (p - a).length();
    let n = n.unit();
    let over = |a: Vec3<Dd>, b: Vec3<Dd>| n.dot((b - a).cross(p - a)) >= Dd::ZERO;
    if over(a, b) && over(b, c) && over(c, a) {
        return (n.dot(p - a).abs() - told).max(Dd::ZERO);
    }
    let to_edge = |a: Vec3<Dd>, b: Vec3<Dd>| {
        let along = (p - a).dot(b - a) / (b - a).dot(b - a);
        let along = along.max(Dd::ZERO).min(Dd::ONE);
        (a + (b - a) * along - p).length()
    };
    to_edge(a, b).min(to_edge(b, c)).min(to_edge(c, a))
}

fn triangles(seed: u64, lines: u32) -> Tally {
    let (mut random, mut tally) = (Random(seed), Tally::default());
    while tally.lines < lines {
        let size = random.length(-6.0, 6.0);
        let away = any_of(&mut random, [0.0, 1.0, 1e3]);
        let centre = random.point(size * away);
        let mut corners = [0; 3].map(|_| centre + random.point(size));
        if random.next() % 4 == 0 {
            // A sliver.
            let along = random.within(0.0, 1.0);
            corners[2] = corners[0] + (corners[1] - corners[0]) * along;
            let width = size * random.length(-12.0, 0.0);
            corners[2] = corners[2] + random.point(width);
        }
        let triangle = Triangle::new(corners.map(|c| c.0), TriangleNormals::Flat);
        let [a, b, c] = corners;
        let along = random.within(-0.1, 1.1) * any_of(&mut random, [0.0, 1.0]);
        let normal = (b - a).cross(c - a).unit();
        let beside = (b - a).cross(normal).unit() * (size * beside(&mut random));
        let direction = match random.next() % 4 {
            // In the plane, or nearly.
            0 => {
                (b - a).unit() * random.within(-1.0, 1.0)
                    + (c - a).unit() * random.within(-1.0, 1.0)
                    + normal * random.length(-17.0, -1.0)
            }
            _ => random.point(1.0),
        };
        let target = a + (b - a) * along + beside;
        let reach = corners.iter().fold(0.0, |m: f64, c| m.max(c.length()));
        let fine = corners.map(lift::<f64, Dd>);
        let distance = |p, _| triangle_distance(p, fine);
        tally.aim(
            &mut random,
            &triangle,
            (target, direction),
            reach,
            &distance,
        );
    }
    tally
}

#[test]
fn triangles_doubt_what_rounding_may_change() {
    triangles(1, 100_000).decides();
}

fn geodesic_spheres(seed: u64, splits: u32, lines: u32) -> Tally {
    let (mut random, mut tally) = (Random(seed), Tally::default());
    while tally.lines < lines {
        let radius = random.length(-6.0, 6.0);
        let sphere = GeodesicSphere::new(radius, splits);
        let face = random.next() as u32 % (20 << (2 * splits));
        let [a, b, c] = sphere.corners::<f64>(face);
        let along = random.within(0.0, 1.0) * any_of(&mut random, [0.0, 1.0]);
        let point = a + (b - a) * along;
        // Straight out of the edge or corner, or towards one facet's normal.
        let normal = (b - a).cross(c - a).unit();
        let out = any_of(&mut random, [point.unit(), normal]);
        let side = out.cross(random.point(1.0)).unit();
        let direction = match random.next() % 3 {
            0 => side,
            1 => b - a,
            _ => random.point(1.0),
        };
        let target = (point + out * beside(&mut random)) * radius;
        let distance = |p, face| {
            let corners = sphere.corners::<Dd>(face);
            triangle_distance(p, corners.map(|c| c * Dd::of(radius)))
        };
        tally.aim(&mut random, &sphere, (target, direction), radius, &distance);
    }
    tally
}

#[test]
fn geodesic_spheres_doubt_what_rounding_may_change() {
    for splits in 0..=MAX_SPLITS {
        geodesic_spheres(splits.into(), splits, 3_000).decides();
    }
}

/// Lines from four sizes away at points in and around the shape, as a camera sends them: none is in
/// doubt.
fn doubtful_views<S: Intersect>(random: &mut Random, shape: &S, size: f64, lines: u32) -> u32 {
    let mut doubtful = 0;
    let mut roots = Roots::default();
    for _ in 0..lines {
        let origin = random.point(1.0).unit() * (4.0 * size);
        let line = Line::new(origin, random.point(size) - origin);
        roots.clear();
        shape.crossings(&line, &mut roots);
        doubtful += u32::from(roots.uncertain);
    }
    doubtful
}

#[test]
fn ordinary_lines_are_not_in_doubt() {
    const LINES: u32 = 100_000;
    let mut random = Random(20);
    for ratio in [0.25, 1.0, 1.5, 1e-2, 1e-4] {
        let torus = Torus::new(1.0, ratio);
        let doubtful = doubtful_views(&mut random, &torus, 1.0 + ratio, LINES);
        assert_eq!(doubtful, 0, "{ratio}");
    }
    for splits in [0, 4, 9] {
        let sphere = GeodesicSphere::new(1.0, splits);
        let doubtful = doubtful_views(&mut random, &sphere, 1.0, LINES / 10);
        assert_eq!(doubtful, 0, "{splits}");
    }
    let corners = [0; 3].map(|_| random.point(1.0).0);
    let triangle = Triangle::new(corners, TriangleNormals::Flat);
    assert_eq!(doubtful_views(&mut random, &triangle, 1.0, LINES), 0);
}
