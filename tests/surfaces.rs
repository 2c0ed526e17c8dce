//! Points on surfaces and rays in them: closed solids hold their boundary, a ray that lies in a surface
//! does not cross it, and where a ray crosses one is a point of the ray.

use crate::campaign::rng::Rng;
use crate::exact::algebra::{Q, q};
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Scene;
use zpg::internals::trace::precision::Precision;
use zpg::internals::trace::{Ray, Tracer, members};

fn scene(text: &str) -> Scene {
    let loaded = Analysis::new("scene.zpg", text.into());
    let errors: Vec<_> = loaded
        .findings()
        .iter()
        .filter(|d| d.code.as_str().starts_with('E'))
        .collect();
    assert!(errors.is_empty(), "{text}: {errors:?}");
    loaded.scene
}

/// Half a number of eighths: sums and products of a few of these are exact.
fn eighths(rng: &mut Rng, low: i32, high: i32) -> f64 {
    f64::from(low * 8 + rng.below(((high - low) * 8 + 1) as usize) as i32) / 8.0
}

/// (cos, sin) of an angle, times a whole number: Pythagorean triples.
const CIRCLE: [[f64; 3]; 8] = [
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [-1.0, 0.0, 1.0],
    [3.0, 4.0, 5.0],
    [-4.0, 3.0, 5.0],
    [5.0, -12.0, 13.0],
    [-8.0, -15.0, 17.0],
    [24.0, 7.0, 25.0],
];

/// A solid's record and points that are exactly on its boundary.
fn boundary(rng: &mut Rng, kind: usize) -> (String, Vec<[f64; 3]>) {
    let [cos, sin, radius] = *rng.pick(&CIRCLE);
    let s = 2f64.powi(rng.below(7) as i32 - 3);
    let (c, n, r) = (cos * s, sin * s, radius * s);
    let mut centre = || eighths(rng, -4, 4);
    let at = [centre(), centre(), centre()];
    match kind {
        0 => (
            format!("9 {r:?}"),
            vec![[c, n, 0.0], [0.0, c, n], [n, 0.0, c]],
        ),
        1 => (
            format!("11 {:?} {:?} {:?} {r:?}", at[0], at[1], at[2]),
            vec![
                [at[0] + c, at[1] + n, at[2]],
                [at[0], at[1] - c, at[2] + n],
                [at[0] + n, at[1], at[2] + c],
            ],
        ),
        2 => {
            let high = at.map(|x| x + 1.0 + s);
            let record = format!(
                "12 {:?} {:?} {:?} {:?} {:?} {:?}",
                at[0], at[1], at[2], high[0], high[1], high[2]
            );
            // Corners, edges and faces.
            let mut points = Vec::new();
            for corner in 0..27 {
                let place = [corner % 3, corner / 3 % 3, corner / 9];
                if place != [1; 3] {
                    points.push(std::array::from_fn(|i| match place[i] {
                        0 => at[i],
                        1 => at[i] + 0.5,
                        _ => high[i],
                    }));
                }
            }
            (record, points)
        }
        3 => (
            format!("4 {cos:?} {sin:?} 1 {:?}", -(cos * cos + sin * sin)),
            vec![
                [cos, sin, 0.0],
                [cos - sin, sin + cos, 0.0],
                [cos + 1.0, sin, -cos],
            ],
        ),
        // Cones: apex, side, base, the base's rim.
        4 => (
            format!("16 {s:?} {r:?}"),
            vec![
                [0.0; 3],
                [c / 2.0, s / 2.0, n / 2.0],
                [c, s, n],
                [0.0, s, 0.0],
                [c / 2.0, s, 0.0],
            ],
        ),
        5 => (
            format!("17 {s:?} {r:?}"),
            vec![
                [0.0; 3],
                [c, -s, n],
                [c / 4.0, s / 4.0, n / 4.0],
                [0.0, -s, 0.0],
            ],
        ),
        6 => (
            format!("10 {r:?} {:?} {s:?}", 2.0 * r),
            vec![
                [c, 2.0 * n, 0.0],
                [-c, -2.0 * n, 0.0],
                [0.0, 0.0, s],
                [r, 0.0, 0.0],
            ],
        ),
        // A torus, an outer or an inner equator, above and below the tube's centre.
        7 => (
            format!("14 {r:?} {:?}", r / 4.0),
            vec![
                [c * 1.25, 0.0, n * 1.25],
                [c * 0.75, 0.0, n * 0.75],
                [c, r / 4.0, n],
                [c, -r / 4.0, n],
            ],
        ),
        // A tube wider than the ring: the lemon's tips and its equator.
        8 => (
            format!("14 {:?} {:?}", 3.0 * s, 5.0 * s),
            vec![
                [0.0, 4.0 * s, 0.0],
                [0.0, -4.0 * s, 0.0],
                [2.0 * s, 0.0, 0.0],
                [8.0 * s, 0.0, 0.0],
            ],
        ),
        // A cylinder with a ring, coaxial cones and discs.
        9 => (
            format!("1 4 {:?} 2 {r:?} 1 {r:?} -1 {:?} -2", 2.0 * r, r / 2.0),
            vec![
                [c, 0.0, n],
                [c, 1.0, n],
                [1.5 * c, 1.5, 1.5 * n],
                [0.75 * c, -1.5, 0.75 * n],
                [c, 2.0, n],
                [0.0, 2.0, 0.0],
                [c / 4.0, -2.0, n / 4.0],
                [2.0 * c, 2.0, 2.0 * n],
            ],
        ),
        10 => (
            format!(
                "1 5 {:?} 0 {:?} 1 {r:?} 1 {r:?} 0 {:?} 0",
                2.0 * r,
                2.0 * r,
                2.0 * r
            ),
            vec![
                [2.0 * c, 0.5, 2.0 * n],
                [c, 0.25, n],
                [1.5 * c, 1.0, 1.5 * n],
                [1.25 * c, 0.0, 1.25 * n],
            ],
        ),
        11 => (
            format!("15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 {:?}", -r * r),
            vec![[c, n, 0.0], [0.0, c, n]],
        ),
        12 => (
            format!("18 {s:?}"),
            vec![[s, 1.0, 7.0], [2.0 * s, 4.0, -3.0], [0.0; 3]],
        ),
        13 => (
            format!("19 {s:?} 2"),
            vec![[s, 0.0, 0.5], [1.25 * s, 1.5, 0.0]],
        ),
        14 => (
            format!("20 1 1 1 {}", 1 + rng.below(2)),
            // Both kinds of sheets: the second has these, too.
            vec![],
        ),
        15 => (
            format!("21 {s:?} 1"),
            vec![[s, 1.0, 0.0], [s, 0.0, 1.0], [0.0, -4.0, 2.0]],
        ),
        16 => (
            "20 1 1 1 1".to_owned(),
            vec![[1.0, 0.0, 0.0], [1.25, 0.75, 0.0], [0.0, -0.75, 1.25]],
        ),
        _ => (
            "20 1 1 1 2".to_owned(),
            vec![[0.0, 1.0, 0.0], [0.75, 1.25, 0.0], [0.0, -1.25, 0.75]],
        ),
    }
}

/// Whether some solid holds a point, by the program.
fn holds(scene: &Scene, point: [f64; 3]) -> bool {
    let root = scene.render.unwrap().root;
    members(scene, root, Vec3(point)).unwrap().in_root
}

#[test]
fn solids_hold_their_boundary() {
    let mut rng = Rng::new(31);
    let (mut asked, mut outside, mut stretched_too) = (0, 0, 0);
    for round in 0..40 * 18 {
        let (record, points) = boundary(&mut rng, round % 18);
        let plain = scene(&format!("2 {record}\n1 9999 2 0\n"));
        // Moved, turned by a quarter and scaled by a power of two: all exact.
        let [x, y, z] = [0, 1, 2].map(|_| eighths(&mut rng, -3, 3));
        let moved = scene(&format!(
            "2 {record}\n2 -2 90 2\n2 -3 2 -0.5 4\n2 -1 {x:?} {y:?} {z:?}\n1 9999 2 0\n"
        ));
        // The complement holds no point of the boundary.
        let complement = scene(&format!("2 {record}\n3 -104 2\n1 9999 3 0\n"));
        for p in points {
            asked += 1;
            assert!(holds(&plain, p), "{record}: {p:?}");
            assert!(!holds(&complement, p), "{record}: {p:?}");
            let turned = [2.0 * p[2] + x, -0.5 * p[1] + y, -4.0 * p[0] + z];
            assert!(
                holds(&moved, turned),
                "{record}, moved by {x} {y} {z}: {p:?} {turned:?}"
            );
            // Stretched by a number that is no power of two: what is exactly there is on the boundary.
            for by in [3.0, 0.7, -1.1] {
                let there = p.map(|x| x * by);
                if (0..3).all(|i| q(p[i]) * q(by) == q(there[i])) {
                    let stretched = scene(&format!(
                        "2 {record}\n2 -3 {by:?} {by:?} {by:?}\n1 9999 2 0\n"
                    ));
                    assert!(holds(&stretched, there), "{record} {by}: {p:?}");
                    stretched_too += 1;
                }
            }
            // Some of the nearest places are outside: the point is on the boundary, not within.
            let near = |i: usize, up: bool| {
                let mut p = p;
                let step = if up { f64::next_up } else { f64::next_down };
                p[i] = if p[i] == 0.0 {
                    if up { 1e-9 } else { -1e-9 }
                } else {
                    step(p[i])
                };
                p
            };
            let beside =
                (0..3).any(|i| [true, false].iter().any(|up| !holds(&plain, near(i, *up))));
            outside += usize::from(beside);
        }
    }
    assert!(
        asked > 2000 && outside * 10 > asked * 9 && stretched_too > 2000,
        "{asked} {outside} {stretched_too}"
    );
}

/// In a tall lathe no line may decide: points of the boundary and beside it, by the profile itself in
/// rational numbers.
#[test]
fn lathes_hold_what_their_profile_says() {
    let mut rng = Rng::new(32);
    for _ in 0..150 {
        let n = 2 + rng.below(6);
        let profile: Vec<[f64; 2]> = (0..n)
            .map(|_| [eighths(&mut rng, 0, 3), eighths(&mut rng, -2, 2)])
            .collect();
        if profile.windows(2).any(|p| p[0] == p[1]) || profile.first() == profile.last() {
            continue;
        }
        let numbers: Vec<String> = profile.iter().flatten().map(|x| format!("{x:?}")).collect();
        let scene = scene(&format!("2 1 {n} {}\n1 9999 2 0\n", numbers.join(" ")));
        let mut closed = vec![[0.0, profile[0][1]]];
        closed.extend(&profile);
        closed.push([0.0, profile[n - 1][1]]);
        for _ in 0..20 {
            let [cos, sin, r] = *rng.pick(&CIRCLE);
            // A radius, as a multiple of the triple's, so that it is exact.
            let (radius, y) = (eighths(&mut rng, 0, 3), eighths(&mut rng, -2, 2));
            let p = [cos * radius, y, sin * radius];
            let (rho, y) = (q(radius * r), q(y));
            let on = closed.windows(2).filter(|pair| {
                let [a, b] = [pair[0], pair[1]].map(|p| p.map(q));
                let cross = (&rho - &a[0]) * (&b[1] - &a[1]) - (&y - &a[1]) * (&b[0] - &a[0]);
                let between = |x: &Q, a: &Q, b: &Q| (a <= x && x <= b) || (b <= x && x <= a);
                cross == Q::ZERO && between(&rho, &a[0], &b[0]) && between(&y, &a[1], &b[1])
            });
            let on = on.count();
            let beyond = closed.windows(2).filter(|pair| {
                let [a, b] = [pair[0], pair[1]].map(|p| p.map(q));
                (a[1] > y) != (b[1] > y)
                    && rho < &a[0] + (&y - &a[1]) / (&b[1] - &a[1]) * (&b[0] - &a[0])
            });
            // Where segments lie in each other, what is left of them is not told here.
            if on <= 1 {
                let meant = on == 1 || beyond.count() % 2 == 1;
                assert_eq!(holds(&scene, p), meant, "{profile:?} {p:?}");
            }
        }
    }
}

/// The number of crossings on a ray in a kind of number, and whether it starts inside.
fn crossings<R: Precision>(scene: &Scene, origin: [f64; 3], direction: [f64; 3]) -> (usize, bool) {
    let tracer = Tracer::new(scene).unwrap();
    let ray = Ray::new(Vec3(origin), Vec3(direction));
    let probe = tracer.probe(&mut tracer.walker::<R>(), &ray.cast());
    (probe.crossings.len(), probe.inside_at_origin)
}

/// Records, with the origin and the direction of rays that lie in a flat face.
fn rays_in_faces(rng: &mut Rng, kind: usize) -> (String, [f64; 3], [f64; 3]) {
    let slope = eighths(rng, -2, 2);
    let side = [-1.0, 1.0][rng.below(2)];
    match kind {
        // A box, in each of its faces, along an edge, and across a corner of a face.
        0 => {
            let axis = rng.below(3);
            let mut o = [-5.0, -5.0 * slope, -5.0];
            let mut d = [1.0, slope, 1.0];
            (o[axis], d[axis]) = (side, 0.0);
            ("12 -1 -1 -1 1 1 1".to_owned(), o, d)
        }
        1 => (
            "12 -1 -1 -1 1 1 1".to_owned(),
            [1.0, side, -5.0],
            [0.0, 0.0, 1.0],
        ),
        2 => (
            "4 1 2 -2 -3".to_owned(),
            [1.0, 1.0, 0.0],
            // At right angles to the normal.
            [2.0 + 2.0 * slope, slope, 1.0 + 2.0 * slope],
        ),
        3 => (
            "16 2 1".to_owned(),
            [-5.0, 2.0, slope / 8.0],
            [1.0, 0.0, 0.0],
        ),
        4 => (
            "17 2 1".to_owned(),
            [-5.0, 2.0 * side, slope / 8.0],
            [1.0, 0.0, 0.0],
        ),
        // A lathe's end discs, and a step within its profile.
        5 => (
            "1 2 1 -1 1 1".to_owned(),
            [-5.0, side, slope / 8.0],
            [1.0, 0.0, 0.0],
        ),
        6 => (
            "1 4 2 -1 2 0 1 0 1 1".to_owned(),
            [-5.0, 0.0, 1.5],
            [1.0, 0.0, 0.0],
        ),
        // A quadric that is a slab: y² ≤ 1.
        _ => (
            "15 0 0 0 0  0 1 0 0  0 0 0 0  0 0 0 -1".to_owned(),
            [-5.0, side, 3.0],
            [1.0, 0.0, slope],
        ),
    }
}

/// A line that lies in a surface does not cross it, whatever the solid; placed by a map, too.
#[test]
fn rays_in_a_face_do_not_cross_it() {
    let mut rng = Rng::new(33);
    for round in 0..400 {
        let (record, o, d) = rays_in_faces(&mut rng, round % 8);
        let plain = scene(&format!("2 {record}\n1 9999 2 0\n"));
        let moved = scene(&format!(
            "2 {record}\n2 -2 90 2\n2 -3 2 -0.5 4\n2 -1 0.125 0.25 0.5\n1 9999 2 0\n"
        ));
        let turned = |p: [f64; 3]| [2.0 * p[2], -0.5 * p[1], -4.0 * p[0]];
        let [x, y, z] = turned(o);
        let away = [x + 0.125, y + 0.25, z + 0.5];
        for (scene, o, d) in [(&plain, o, d), (&moved, away, turned(d))] {
            assert_eq!(
                crossings::<f64>(scene, o, d),
                (0, false),
                "{record}: {o:?} {d:?}"
            );
            assert_eq!(
                crossings::<Dd>(scene, o, d),
                (0, false),
                "{record}: {o:?} {d:?}"
            );
        }
        // Both sides of the boundary are the complement's, too: all of the line but a face of no thickness.
        let complement = scene(&format!("2 {record}\n3 -104 2\n1 9999 3 0\n"));
        let found = crossings::<f64>(&complement, o, d);
        assert!(found.0 <= 2, "{record}: {found:?}");
    }
}

/// Between solids face to face is no gap, and what is cut flush is open.
#[test]
fn rays_between_two_solids_face_to_face() {
    for (text, o, d, meant) in [
        // Two boxes, of the same length and of others.
        (
            "2 12 -1 -1 -1 1 0 1\n3 12 -1 0 -1 1 1 1\n4 -101 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (2, false),
        ),
        (
            "2 12 -1 -1 -1 1 0 1\n3 12 0 0 -1 3 1 1\n4 -101 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (2, false),
        ),
        (
            "2 12 -1 -1 -1 0 0 1\n3 12 1 0 -1 3 1 1\n4 -101 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (0, false),
        ),
        // Four boxes around an edge.
        (
            "2 12 -1 -1 -1 0 0 1\n3 12 0 -1 -1 1 0 1\n5 12 -1 0 -1 0 1 1\n6 12 0 0 -1 1 1 1\n7 -101 2 3\n8 -101 5 6\n4 -101 7 8",
            [0.0, 0.0, -5.0],
            [0.0, 0.0, 1.0],
            (2, false),
        ),
        // A box on the ground, along the ground: within the box's face and the ground's.
        (
            "2 4 0 1 0 0\n3 12 -1 0 -1 1 1 1\n4 -101 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (2, false),
        ),
        // Stacked lathes, and a cone on a lathe.
        (
            "2 1 2 1 -1 1 0\n3 1 2 1 0 1 1\n4 -101 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (2, false),
        ),
        (
            "2 1 2 1 1 1 2\n3 16 1 1\n4 -101 2 3",
            [-5.0, 1.0, 0.5],
            [1.0, 0.0, 0.0],
            (2, false),
        ),
        // A box less one that is flush with its face: the line is in the face of both.
        (
            "2 12 -1 -1 -1 1 1 1\n3 12 -0.5 0 -1 0.5 1 1\n4 -103 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (4, false),
        ),
        (
            "2 12 -1 -1 -1 1 1 1\n3 12 -1 0 -1 1 1 1\n4 -103 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (0, false),
        ),
        // An edge with something in three of its four quarters, in two that are opposite, and a ball that
        // touches it there.
        (
            "2 12 0.5 -2 -1 2.5 -0.5 0.5\n3 1 2 1.5 -0.5 1.5 1\n4 -101 2 3",
            [-8.5, -0.5, 0.5],
            [1.0, 0.0, 0.0],
            (0, false),
        ),
        (
            "2 12 0 0 -1 1 1 1\n3 12 -1 -1 -1 0 0 1\n4 -101 2 3",
            [0.0, 0.0, -5.0],
            [0.0, 0.0, 1.0],
            (0, false),
        ),
        (
            "2 12 0.5 -2 -1 1 0 -0.5\n3 11 1 -0.5 1 1.5\n4 -101 2 3",
            [1.0, -9.5, -0.5],
            [0.0, 1.0, 0.0],
            (0, false),
        ),
        // A tool whose rim the line touches, in the plane of its top.
        (
            "2 12 -3 -3 -3 3 3 3\n3 1 2 0.5 -0.5 0.5 1\n4 -103 2 3",
            [-0.5, 1.0, -7.5],
            [0.0, 0.0, 1.0],
            (2, false),
        ),
        // In the face of a box that begins where something else ends.
        (
            "2 4 0 0 -1 -0.5\n3 12 -0.5 0 -0.5 0.5 1 0\n4 -103 2 3",
            [-0.5, 0.5, -7.5],
            [0.0, 0.0, 1.0],
            (1, false),
        ),
        // What two boxes have in common that touch is nothing.
        (
            "2 12 -1 -1 -1 1 0 1\n3 12 -1 0 -1 1 1 1\n4 -102 2 3",
            [-5.0, 0.0, 0.5],
            [1.0, 0.0, 0.0],
            (0, false),
        ),
    ] {
        let scene = scene(&format!("{text}\n1 9999 4 0\n"));
        assert_eq!(crossings::<f64>(&scene, o, d), meant, "{text}");
        assert_eq!(crossings::<Dd>(&scene, o, d), meant, "{text}");
    }
}

/// Triangles that are met nearly edge-on: the exact solution of the equations, or within the rounding
/// of a double-double.
#[test]
fn triangles_are_met_edge_on() {
    let mut rng = Rng::new(34);
    let (mut met, mut flattest) = (0, 1.0f64);
    for _ in 0..2000 {
        let hundredths = |rng: &mut Rng| (rng.range(-100.0, 100.0)).round() / 100.0;
        let corners: [[f64; 3]; 3] =
            std::array::from_fn(|_| std::array::from_fn(|_| hundredths(&mut rng)));
        // From a point of the triangle's plane, beside it, through a point in it.
        let mix = |w: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|i| (0..3).map(|k| w[k] * corners[k][i]).sum())
        };
        let (u, v) = (rng.range(0.1, 0.4), rng.range(0.1, 0.4));
        let inside = mix([1.0 - u - v, u, v]);
        let (a, b) = (rng.range(2.0, 4.0), rng.range(-3.0, 3.0));
        let o = mix([1.0 - a - b, a, b]);
        let d: [f64; 3] = std::array::from_fn(|i| (inside[i] - o[i]) * 0.3);
        let [p0, p1, p2] = corners.map(|c| c.map(q));
        let minus = |a: &[Q; 3], b: &[Q; 3]| -> [Q; 3] { std::array::from_fn(|i| &a[i] - &b[i]) };
        let cross = |a: &[Q; 3], b: &[Q; 3]| -> [Q; 3] {
            std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                &a[j] * &b[k] - &a[k] * &b[j]
            })
        };
        let dot = |a: &[Q; 3], b: &[Q; 3]| (0..3).fold(Q::ZERO, |s, i| s + &a[i] * &b[i]);
        let (o_exact, d_exact) = (o.map(q), d.map(q));
        let n = cross(&minus(&p1, &p0), &minus(&p2, &p0));
        let slope = dot(&n, &d_exact);
        if slope == Q::ZERO || n.iter().all(|x| *x == Q::ZERO) {
            continue;
        }
        let t = dot(&n, &minus(&p0, &o_exact)) / &slope;
        // On which side of its edges the line passes.
        let from = [p0, p1, p2].map(|p| minus(&p, &o_exact));
        let sides: [Q; 3] =
            std::array::from_fn(|i| dot(&d_exact, &cross(&from[(i + 1) % 3], &from[(i + 2) % 3])));
        let one_side = sides.iter().all(|s| *s > Q::ZERO) || sides.iter().all(|s| *s < Q::ZERO);
        let text: Vec<String> = corners.iter().flatten().map(|x| format!("{x:?}")).collect();
        let scene = scene(&format!("2 6 {}\n1 9999 2 0\n", text.join(" ")));
        let tracer = Tracer::new(&scene).unwrap();
        let ray = Ray::new(Vec3(o), Vec3(d));
        let probe = tracer.probe(&mut tracer.walker::<f64>(), &ray);
        let expected = one_side && t > Q::ZERO;
        assert_eq!(
            probe.crossings.len(),
            usize::from(expected),
            "{corners:?} {o:?} {d:?}"
        );
        if let Some(crossing) = probe.crossings.first() {
            met += 1;
            let flat = (slope.to_f64().value() / n_length(&n)).abs();
            flattest = flattest.min(flat);
            // A double-double's rounding, over the slope.
            let off = (q(crossing.hit.t) - &t).to_f64().value().abs();
            assert!(off <= 1e-14 + 1e-28 / flat, "{off:e} at slope {flat:e}");
        }
    }
    assert!(met > 150 && flattest < 1e-17, "{met} {flattest:e}");
}

fn n_length(n: &[Q; 3]) -> f64 {
    let n = [0, 1, 2].map(|i| n[i].to_f64().value());
    (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt()
}

/// The example that was found: the triangle's plane is met at an angle of 10⁻¹⁸.
#[test]
fn a_triangle_met_at_the_flattest_angle() {
    let scene = scene("20 6 0.35 0.57 0.04 0.02 -0.21 0.99 -0.42 -0.7 -0.48\n1 9999 20 0\n");
    let tracer = Tracer::new(&scene).unwrap();
    let ray = Ray::new(
        Vec3([0.36101314190205425, 0.9100924166076163, -1.5543976604850502]),
        Vec3([
            -0.10032196886053925,
            -0.3036341448836658,
            0.6197407726962163,
        ]),
    );
    let probe = tracer.probe(&mut tracer.walker::<f64>(), &ray);
    assert!((probe.crossings[0].hit.t - 3.15139831).abs() < 1e-8);
    let probe = tracer.probe(&mut tracer.walker::<Dd>(), &ray.cast());
    assert_eq!(probe.crossings.len(), 1);
}

/// The place of a crossing is the ray's, o + t·d, within a few units in the last place of its terms, also
/// where shapes are stretched ten million times as far along one axis as along another.
#[test]
fn places_are_those_of_the_ray() {
    let mut rng = Rng::new(35);
    let (mut crossed, mut worst) = (0, 0.0f64);
    for round in 0..3000 {
        let record = match round % 9 {
            0 => "1 4 0.5 -1 1 -0.5 0.7 0.4 0.2 1".to_owned(),
            1 => "16 1 1".to_owned(),
            2 => "17 1 1".to_owned(),
            3 => "10 1 0.5 2".to_owned(),
            4 => "11 0.1 0.2 0.3 1".to_owned(),
            5 => "14 1 0.25".to_owned(),
            6 => "12 -1 -0.5 -1 1 0.7 1.1".to_owned(),
            7 => "13 1 2".to_owned(),
            _ => "20".to_owned(),
        };
        let scales = [0, 1, 2].map(|_| rng.decade(-7.0, 7.0));
        let mixed = match rng.below(3) {
            0 => [scales[0]; 3],
            _ => scales,
        };
        let [x, y, z] = mixed;
        let (a, b) = (rng.range(-180.0, 180.0), rng.range(-180.0, 180.0));
        let [u, v, w] = rng.cube();
        let scene = scene(&format!(
            "2 {record}\n2 -3 {x:?} {y:?} {z:?}\n2 -2 {a:?} 1\n2 -2 {b:?} 3\n2 -1 {u:?} {v:?} {w:?}\n1 9999 2 0\n"
        ));
        let matrix = scene.matrices[match scene.nodes[scene.render.unwrap().root as usize] {
            zpg::internals::scene::Node::Transform { matrix, .. } => matrix as usize,
            other => panic!("{other:?}"),
        }];
        let tracer = Tracer::new(&scene).unwrap();
        for _ in 0..4 {
            // From outside through a point within.
            let within = matrix.point(rng.cube().map(|c| 0.9 * c));
            let start = matrix.point(rng.direction().map(|c| 5.0 * c));
            let d: [f64; 3] = std::array::from_fn(|i| within[i] - start[i]);
            let ray = Ray::new(Vec3(start), Vec3(d));
            for crossing in tracer.probe(&mut tracer.walker::<f64>(), &ray).crossings {
                crossed += 1;
                let (t, p) = (crossing.hit.t, crossing.hit.point);
                for i in 0..3 {
                    let exact = q(start[i]) + q(t) * q(d[i]);
                    let off = (q(p[i]) - exact).to_f64().value().abs();
                    let size = start[i].abs() + (t * d[i]).abs();
                    worst = worst.max(off / size / f64::EPSILON);
                }
            }
        }
    }
    assert!(crossed > 8000, "{crossed}");
    assert!(worst <= 16.0, "{worst}");
}
