//! Cheap tests against the shapes themselves, in doubles and in double-double.

use super::facet::tests::Random;
use super::quick_reject::Pass;
use super::{Primitive, Roots};
use crate::geometry::affine::Affine;
use crate::geometry::dd::Dd;
use crate::geometry::line::{Line, Traced};
use crate::geometry::number::Real;
use crate::geometry::vec::Vec3;
use crate::scene::Geometry;

const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Lines a shape. With `NEAR_LINES` in the environment so many.
fn lines() -> u32 {
    let asked = std::env::var("NEAR_LINES").ok();
    asked.map_or(4000, |n| n.parse().expect("a number of lines"))
}

/// A profile of many points that goes up in waves.
fn wave(points: u32) -> Vec<[f64; 2]> {
    let at = |i: u32| f64::from(i) / f64::from(points);
    (0..=points)
        .map(|i| [0.5 + 0.3 * (at(i) * 40.0).sin(), 3.0 * at(i)])
        .collect()
}

fn quadric(rows: [[f64; 4]; 4]) -> Geometry {
    let numbers = rows.as_flattened().try_into().unwrap();
    Geometry::Quadric(Box::new(numbers))
}

/// Shapes with a cheap test, some of them flat, thin, small or large.
fn shapes() -> Vec<Geometry> {
    let torus = |major, minor| Geometry::Torus { major, minor };
    let ellipsoid = |semi_axes| Geometry::Ellipsoid { semi_axes };
    let cone = |height, radius| Geometry::Cone { height, radius };
    let revolution = |profile: &[[f64; 2]]| Geometry::Revolution {
        profile: profile.to_vec(),
        colours: Vec::new(),
    };
    vec![
        torus(1.0, 0.3),
        torus(2e3, 1.9e3),
        torus(1.0, 1.5),
        torus(3e-8, 3e-10),
        ellipsoid([1.0, 0.8, 1.3]),
        ellipsoid([0.01, 1.0, 3.0]),
        ellipsoid([5e7, 5e5, 5e4]),
        // Turned, far from the origin, and flat.
        quadric([
            [1.0, 0.3, 0.0, -0.5],
            [0.3, 2.0, 0.1, 0.2],
            [0.0, 0.1, 0.5, -0.3],
            [-0.5, 0.2, -0.3, -2.0],
        ]),
        quadric([
            [1.0, 0.0, 0.0, -100.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 4.0, 0.0],
            [-100.0, 0.0, 0.0, 9999.0],
        ]),
        quadric([
            [1e-12, 0.0, 0.0, 0.0],
            [0.0, 4e-8, 0.0, 0.0],
            [0.0, 0.0, 1e-12, 0.0],
            [0.0, 0.0, 0.0, -1.0],
        ]),
        cone(1.0, 0.4),
        cone(-3e-6, 1e-6),
        cone(0.05, 2.0),
        Geometry::DoubleCone {
            height: 1.2,
            radius: 0.5,
        },
        Geometry::DoubleCone {
            height: 40.0,
            radius: 0.5,
        },
        revolution(&[[0.2, -1.0], [0.5, 0.0], [0.3, 0.6], [0.6, 1.0]]),
        revolution(&[[2.0, 5.0], [3.0, 5.0], [3.0, 5.5], [2.0, 5.0]]),
        revolution(&[[0.0, 7.0], [1e-3, 7.2], [0.0, 9.0]]),
        // A goblet, one that crosses itself, and one with steps and a part that is traced twice.
        revolution(&[
            [0.0, 0.0],
            [1.0, 0.0],
            [0.1, 0.2],
            [0.1, 1.0],
            [0.9, 2.0],
            [0.8, 2.0],
            [0.0, 1.1],
        ]),
        revolution(&[[0.3, 0.0], [1.0, 1.0], [0.2, 1.1], [0.9, 0.1], [0.4, 2.0]]),
        revolution(&[
            [0.5, 0.0],
            [0.5, 1.0],
            [0.9, 1.0],
            [0.9, 3.0],
            [0.9, 2.0],
            [0.2, 2.0],
            [0.2, 4.0],
        ]),
        revolution(&wave(60)),
        revolution(&wave(500)),
    ]
}

fn crossings<R: Traced>(shape: &Primitive, line: &Line<R>, roots: &mut Roots<R>) {
    roots.clear();
    shape.intersect().crossings(line, roots);
}

/// A line that comes near a shape, as it is or through a map that turns and scales it.
fn aimed(random: &mut Random, shape: &Primitive) -> Line {
    let bounds = shape.shape().bounds();
    let half = Vec3(bounds.extent()) * 0.7;
    let beside = random.point(1.0);
    let target = Vec3(bounds.centre()) + Vec3([0, 1, 2].map(|i| beside[i] * half[i]));
    let away = bounds.radius() * random.length(-1.0, 4.0);
    let direction = random.point(1.0).unit();
    let (origin, direction) = (
        target - direction * away,
        direction * random.length(-3.0, 3.0),
    );
    if random.next().is_multiple_of(2) {
        return Line::new(origin, direction);
    }
    let (x, y) = (random.point(1.0).unit(), random.point(1.0));
    let z = x.cross(y).unit();
    let scale = random.length(-2.0, 2.0);
    let rows = [x, z.cross(x), z].map(|row| row * scale);
    let to_world = |v: Vec3| (rows[0] * v[0] + rows[1] * v[1] + rows[2] * v[2]) / scale / scale;
    Line::new(to_world(origin), to_world(direction)).through(&Affine::of(rows, Vec3::ZERO))
}

#[test]
fn what_misses_crosses_nothing_and_what_goes_through_is_in_it() {
    let mut random = Random(11);
    let (mut went_through, mut told_through) = (0, 0);
    for geometry in shapes() {
        let shape = Primitive::new(&geometry);
        let (mut found, mut truth) = (Roots::default(), Roots::<Dd>::default());
        let (mut missed, mut told) = (0, 0);
        for _ in 0..lines() {
            let line = aimed(&mut random, &shape);
            let length = line.origin.length() / line.direction.length();
            let stretch = match random.next() % 3 {
                0 => ALL,
                _ => {
                    let from = length * random.length(-0.3, 0.1);
                    [from, from + length * random.length(-3.0, 0.0)]
                }
            };
            crossings(&shape, &line.cast(), &mut truth);
            let is_in = |t: Dd| (stretch[0]..=stretch[1]).contains(&t.to_f64());
            let crosses = truth.list.iter().any(|root| is_in(root.t));
            let pass = shape.shape().pass(&line, stretch);
            missed += u32::from(!crosses);
            // Where the line is in the solid after its origin, and comes out within the stretch.
            let start = stretch[0].max(0.0);
            let through = truth.list.chunks_exact(2).any(|chord| {
                let [from, to] = [0, 1].map(|i: usize| chord[i].t.to_f64());
                to > start && from < stretch[1] && to < stretch[1]
            });
            went_through += u32::from(through);
            if pass == Pass::Through {
                told_through += 1;
                assert!(
                    through && !truth.inside,
                    "{geometry:?} {line:?} {stretch:?} {truth:?}"
                );
            }
            if pass != Pass::Beside {
                continue;
            }
            told += 1;
            assert!(!crosses, "{geometry:?} {line:?} {stretch:?} {truth:?}");
            if stretch == ALL {
                crossings(&shape, &line, &mut found);
                assert!(!found.uncertain && !found.inside, "{geometry:?} {line:?}");
                assert!(found.list.is_empty(), "{geometry:?} {line:?} {found:?}");
            }
        }
        // Most of them are told.
        assert!(told * 10 > missed * 6, "{geometry:?}: {told} of {missed}");
    }
    assert!(
        told_through * 2 > went_through,
        "{told_through} of {went_through}"
    );
}

/// Shapes without bounds, and lines from near and far.
#[test]
fn unbounded_quadrics_are_not_crossed_where_they_are_missed() {
    let shapes = [
        // A cylinder, one that is turned and far from the origin, and a cone beside it.
        quadric([
            [1.0, 0.0, 0.0, 0.0],
            [0.0; 4],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, -0.25],
        ]),
        quadric([
            [1.0, 1.0, 0.0, -9.0],
            [1.0, 1.0, 0.0, -9.0],
            [0.0, 0.0, 2.0, 0.0],
            [-9.0, -9.0, 0.0, 80.0],
        ]),
        quadric([
            [1.0, 0.0, 0.0, -2.0],
            [0.0, -0.5, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [-2.0, 0.0, 0.0, 4.0],
        ]),
        Geometry::ParabolicCylinder { a: 0.7 },
        Geometry::HyperbolicCylinder { a: 0.01, b: 3.0 },
        Geometry::HyperbolicParaboloid { a: 1.0, b: 40.0 },
        Geometry::Hyperboloid {
            a: 1.0,
            b: 0.5,
            c: 2.0,
            sheets: 1,
        },
        Geometry::Hyperboloid {
            a: 1e5,
            b: 3e5,
            c: 2e4,
            sheets: 2,
        },
    ];
    let mut random = Random(13);
    for geometry in shapes {
        let shape = Primitive::new(&geometry);
        let (mut found, mut truth) = (Roots::default(), Roots::<Dd>::default());
        let (mut missed, mut told) = (0, 0);
        for _ in 0..lines() {
            let size = shape.shape().extent().min(1e6);
            let origin = random.point(1.0) * (size * random.length(-1.0, 3.0));
            let target = random.point(1.0) * (size * random.length(-1.0, 1.0));
            let mut line = Line::new(origin, (target - origin) * random.length(-3.0, 3.0));
            if random.next().is_multiple_of(2) {
                line.slack.origin = line.origin.abs().max_component() * random.length(-16.0, -8.0);
            }
            crossings(&shape, &line.cast(), &mut truth);
            let crosses = truth.inside || truth.uncertain || !truth.list.is_empty();
            missed += u32::from(!crosses);
            if shape.shape().pass(&line, ALL) == Pass::Beside {
                told += 1;
                assert!(!crosses, "{geometry:?} {line:?} {truth:?}");
                crossings(&shape, &line, &mut found);
                assert!(!found.uncertain && !found.inside, "{geometry:?} {line:?}");
                assert!(found.list.is_empty(), "{geometry:?} {line:?} {found:?}");
            }
        }
        assert!(told * 2 >= missed, "{geometry:?}: {told} of {missed}");
    }
}

/// A line does not meet a shape again from where it has come out of it on.
#[test]
fn what_is_not_met_again_is_left_for_good() {
    let mut random = Random(12);
    for geometry in shapes() {
        let shape = Primitive::new(&geometry);
        let mut truth = Roots::<Dd>::default();
        let (mut left, mut told) = (0, 0);
        for _ in 0..lines() {
            let line = aimed(&mut random, &shape);
            crossings(&shape, &line.cast(), &mut truth);
            let Some(&[.., root]) = truth.list.chunks_exact(2).next() else {
                continue;
            };
            let point = shape.intersect().locate(&line.cast::<Dd>(), root).point;
            let onwards = Line::new(point.cast(), random.point(1.0).unit());
            crossings(&shape, &onwards.cast(), &mut truth);
            // Not one that goes in, or nearly along the surface.
            let size = shape.shape().bounds().radius();
            let (start, ahead): (Vec<f64>, Vec<f64>) = (truth.list.iter())
                .map(|root| root.t.to_f64())
                .filter(|&t| t > -1e-9 * size)
                .partition(|&t| t < 1e-9 * size);
            let is_out = start.len() == 1 && ahead.len() % 2 == 0;
            if !is_out || truth.uncertain {
                continue;
            }
            left += u32::from(ahead.is_empty());
            if !shape.shape().is_met_again(&onwards) {
                told += 1;
                assert!(ahead.is_empty(), "{geometry:?} {onwards:?} {truth:?}");
            }
        }
        let share = match geometry {
            Geometry::Torus { .. } => 6,
            Geometry::Revolution { .. } => 3,
            Geometry::DoubleCone { .. } => 6,
            _ if shape.shape().is_convex() => 6,
            _ => 0,
        };
        let least = left * share;
        assert!(told * 10 >= least, "{geometry:?}: {told} of {left}");
    }
}

/// The crossings for a search for the nearest are the beginning of all crossings, up to the first that counts.
#[test]
fn first_crossings_are_the_first_of_all() {
    fn compare<R: Traced>(shape: &Primitive, line: &Line, near: f64) -> usize {
        let (line, near) = (line.cast::<R>(), R::of(near));
        let (mut first, mut all) = (Roots::default(), Roots::default());
        shape.intersect().first_crossings(&line, near, &mut first);
        shape.intersect().crossings(&line, &mut all);
        let count = first.list.len();
        assert!(first.list[..] == all.list[..count], "{shape:?} {line:?}");
        assert!(first.inside == all.inside);
        if count < all.list.len() {
            let reach = line.origin.abs().max_component();
            let size = reach / line.direction.abs().max_component();
            let clear = near + size * R::of(0.01);
            assert!(first.list.last().is_some_and(|root| root.t > clear));
        } else {
            assert!(first.uncertain == all.uncertain);
        }
        all.list.len() - count
    }
    let mut random = Random(13);
    for geometry in shapes() {
        let shape = Primitive::new(&geometry);
        let mut spared = 0;
        for i in 0..lines() {
            let line = aimed(&mut random, &shape);
            let length = line.origin.length() / line.direction.length();
            let near = length * random.length(-2.0, 0.1);
            spared += compare::<f64>(&shape, &line, near);
            if i % 8 == 0 {
                compare::<Dd>(&shape, &line, near);
            }
        }
        let spares = matches!(
            geometry,
            Geometry::Torus { .. } | Geometry::GeodesicSphere { .. }
        );
        assert!(spared > 0 || !spares, "{geometry:?}");
    }
}
