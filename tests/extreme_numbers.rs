//! Whatever finite numbers a valid scene and a ray are made of, nothing that leaves the tracer is
//! NaN or infinite, crossings ascend and alternate, and nothing panics. In every precision.
//!
//! `PROPTEST_CASES=5000 cargo test --release --test all extreme_numbers` is the long run.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestError, TestRunner};
use std::sync::atomic::{AtomicU32, Ordering};
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::trace::precision::Precision;
use zpg::internals::trace::{Numbers, Ray, Settings, Tracer, selected_camera};

/// From 5e-324 to the largest double, small numbers and zero among them.
fn size() -> BoxedStrategy<f64> {
    prop_oneof![
        4 => 0.1..10.0f64,
        4 => (-323.0..308.0f64).prop_map(|e| 10f64.powf(e).max(5e-324)),
        1 => Just(f64::MAX),
        1 => Just(f64::MIN_POSITIVE),
        1 => Just(5e-324),
        1 => Just(1e308),
        1 => Just(1e-320),
        1 => Just(1.0),
    ]
    .boxed()
}

fn number() -> BoxedStrategy<f64> {
    prop_oneof![1 => Just(0.0), 4 => size(), 4 => size().prop_map(|x| -x)].boxed()
}

fn numbers(n: usize) -> BoxedStrategy<Vec<f64>> {
    prop::collection::vec(number(), n).boxed()
}

fn sizes(n: usize) -> BoxedStrategy<Vec<f64>> {
    prop::collection::vec(size(), n).boxed()
}

/// Lower and upper corner.
fn corners(n: usize) -> BoxedStrategy<Vec<f64>> {
    numbers(2 * n)
        .prop_map(move |mut v| {
            for i in 0..n {
                if v[i] > v[n + i] {
                    v.swap(i, n + i);
                }
            }
            v
        })
        .boxed()
}

/// A profile, with or without its number of colours.
fn profile(coloured: bool) -> BoxedStrategy<String> {
    prop::collection::vec((size(), number()), 2..6)
        .prop_map(move |points| {
            let list: Vec<f64> = points.iter().flat_map(|p| [p.0, p.1]).collect();
            let colours = if coloured { 3 * points.len() } else { 0 };
            format!(
                "{}{}{}",
                points.len(),
                joined(&list),
                " 0.5".repeat(colours)
            )
        })
        .boxed()
}

fn joined(v: &[f64]) -> String {
    v.iter().map(|x| format!(" {x:e}")).collect()
}

/// Types and parameters of shapes, one strategy for each type.
fn shapes() -> Vec<BoxedStrategy<String>> {
    let plain = |ty: u32, v: BoxedStrategy<Vec<f64>>| {
        v.prop_map(move |v| format!("{ty}{}", joined(&v))).boxed()
    };
    let two = |ty: u32, a: BoxedStrategy<Vec<f64>>, b: BoxedStrategy<Vec<f64>>| {
        (a, b)
            .prop_map(move |(a, b)| format!("{ty}{}{}", joined(&a), joined(&b)))
            .boxed()
    };
    let whole = |ty: u32, v: BoxedStrategy<Vec<f64>>, last: std::ops::Range<u32>| {
        (v, last)
            .prop_map(move |(v, n)| format!("{ty}{} {n}", joined(&v)))
            .boxed()
    };
    vec![
        profile(false).prop_map(|p| format!("1 {p}")).boxed(),
        profile(true).prop_map(|p| format!("2 {p}")).boxed(),
        plain(3, numbers(4)),
        plain(4, numbers(4)),
        plain(5, corners(2)),
        plain(6, numbers(9)),
        plain(7, numbers(12)),
        plain(8, numbers(18)),
        plain(9, sizes(1)),
        plain(10, sizes(3)),
        two(11, numbers(3), sizes(1)),
        plain(12, corners(3)),
        whole(13, sizes(1), 0..3),
        plain(14, sizes(2)),
        plain(15, numbers(16)),
        two(16, numbers(1), sizes(1)),
        plain(17, sizes(2)),
        plain(18, sizes(1)),
        plain(19, sizes(2)),
        whole(20, sizes(3), 1..3),
        plain(21, sizes(2)),
    ]
}

/// Type and parameters of a transformation.
fn change() -> BoxedStrategy<String> {
    prop_oneof![
        numbers(3).prop_map(|v| format!("-1{}", joined(&v))),
        (number(), 1..4u32).prop_map(|(x, axis)| format!("-2 {x:e} {axis}")),
        (sizes(3), any::<bool>()).prop_map(|(mut v, flip)| {
            v[1] = if flip { -v[1] } else { v[1] };
            format!("-3{}", joined(&v))
        }),
        numbers(12).prop_map(|v| format!("-4{} 0 0 0 1", joined(&v))),
    ]
    .boxed()
}

/// The text of a scene: a shape and up to two more of any type, changed, and operations.
fn scene(first: BoxedStrategy<String>) -> BoxedStrategy<String> {
    let changes = || prop::collection::vec(change(), 0..2);
    let any = proptest::strategy::Union::new(shapes());
    (
        (first, changes()),
        prop::collection::vec((any, changes()), 0..3),
        prop::collection::vec(0..4u32, 5),
    )
        .prop_map(|(first, others, operations)| {
            let parts: Vec<_> = std::iter::once(first).chain(others).collect();
            let mut text = String::new();
            for (i, (shape, changes)) in parts.iter().enumerate() {
                text += &format!("{} {shape}\n", 10 + i);
                for change in changes {
                    text += &format!("{} {change}\n", 10 + i);
                }
            }
            let mut root = 10;
            for (i, operation) in operations.iter().enumerate().take(parts.len() + 1).skip(1) {
                let (id, other) = (30 + i, 10 + i % parts.len());
                text += &match operation {
                    3 => format!("{id} -104 {root}\n"),
                    k => format!("{id} -{} {root} {other}\n", 101 + k),
                };
                root = id;
            }
            format!("{text}5 -201 0.4 0.3 0.3\n{root} -299 0 5\n1 9999 {root} 0\n")
        })
        .boxed()
}

/// Rays from anywhere to anywhere, and from anywhere towards the origin.
fn rays() -> BoxedStrategy<Vec<(Vec<f64>, Vec<f64>)>> {
    let free = (numbers(3), numbers(3));
    let aimed = (numbers(3), size()).prop_map(|(o, s)| {
        let largest = o.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(5e-324);
        let d = o.iter().map(|x| -(x / largest) * s).collect();
        (o, d)
    });
    let near = (prop::collection::vec(-2.0..2.0f64, 3), numbers(3));
    prop::collection::vec(prop_oneof![free, aimed, near], 8).boxed()
}

/// What is wrong with the answer about a ray, in one kind of number.
fn fault<R: Precision>(tracer: &Tracer, o: &[f64], d: &[f64]) -> Option<String> {
    let (o, d) = (Vec3::new(o[0], o[1], o[2]), Vec3::new(d[0], d[1], d[2]));
    let ray: Ray<R> = Ray::new(o, d).cast();
    if !ray.line.is_sound() {
        // Single precision does not hold it.
        return None;
    }
    let sound = |v: Vec3<R>| v.is_finite();
    let mut walker = tracer.walker::<R>();
    let probe = tracer.probe(&mut walker, &ray);
    let mut inside = probe.inside_at_origin;
    let mut last = R::ZERO;
    for c in &probe.crossings {
        let hit = &c.hit;
        let finite = hit.t.is_finite()
            && sound(hit.point)
            && sound(hit.normal)
            && sound(hit.shading)
            && sound(c.normal)
            && hit.skin.is_finite()
            && c.uv.iter().all(|x| x.is_finite())
            && hit.colour.iter().all(|x| x.is_finite());
        if !finite {
            return Some(format!("not finite: {c:?}"));
        }
        // A dozen roundings at most.
        let off = |n: Vec3<R>| (n.length() - R::ONE).abs() > R::gamma(12);
        if off(c.normal) || off(hit.shading) {
            return Some(format!("no unit normal: {c:?}"));
        }
        if hit.t < last || hit.t <= R::ZERO {
            return Some(format!("{:?} after {last:?}", hit.t));
        }
        last = hit.t;
        if let Some(entering) = c.entering {
            if entering == inside {
                return Some(format!("twice the same side: {c:?}"));
            }
            inside = entering;
        }
    }
    let first = tracer.hit(&mut walker, &ray);
    if first.is_some_and(|h| !h.t.is_finite() || !sound(h.point) || !sound(h.normal)) {
        return Some(format!("not finite: {first:?}"));
    }
    None
}

/// Scenes of one kind with their rays: how many are valid, in how many pixels there is something,
/// and the smallest scene with a fault.
fn try_kind(kind: usize, cases: u32) -> (u32, u32, Option<String>) {
    let mut runner = TestRunner::new(Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(kind as u64),
        ..Config::default()
    });
    let (valid, met) = (AtomicU32::new(0), AtomicU32::new(0));
    let first = shapes().swap_remove(kind);
    let result = runner.run(&(scene(first), rays()), |(text, rays)| {
        let loaded = Analysis::new("a.zpg", text.into_bytes());
        // What the language does not allow is not drawn.
        if !loaded.is_sound() {
            return Ok(());
        }
        let scene = staged(&loaded.scene, Viewpoint::Scene, 4.0 / 3.0);
        let Ok(tracer) = Tracer::new(&scene) else {
            return Ok(());
        };
        valid.fetch_add(1, Ordering::Relaxed);
        for (o, d) in rays.iter().filter(|r| r.1.iter().any(|x| *x != 0.0)) {
            let faults = [
                ("f32", fault::<f32>(&tracer, o, d)),
                ("f64", fault::<f64>(&tracer, o, d)),
                ("dd", fault::<Dd>(&tracer, o, d)),
            ];
            if let Some((kind, Some(fault))) = faults.into_iter().find(|f| f.1.is_some()) {
                return Err(TestCaseError::fail(format!("{kind} {o:?} {d:?}: {fault}")));
            }
        }
        let camera = selected_camera(&scene, 4.0 / 3.0);
        for numbers in [Numbers::F32, Numbers::F64, Numbers::Dd] {
            let settings = Settings {
                width: 4,
                height: 3,
                depth: 3,
                numbers,
                ..Settings::default()
            };
            let Ok(picture) = tracer.render(&camera, &settings, || ()) else {
                continue;
            };
            for i in 0..12 {
                let pixel = picture.film.pixel(i % 4, i / 4);
                if !pixel.iter().all(|x| x.is_finite()) {
                    let what = format!("{numbers:?}, pixel {i}: {pixel:?}");
                    return Err(TestCaseError::fail(what));
                }
                if numbers == Numbers::F64 && pixel.iter().any(|x| *x > 0.0) {
                    met.fetch_add(1, Ordering::Relaxed);
                }
            }
        }
        Ok(())
    });
    let fault = match result {
        Ok(()) => None,
        Err(TestError::Fail(why, (text, _))) => Some(format!("{why}\n{text}")),
        Err(e) => Some(e.to_string()),
    };
    (valid.into_inner(), met.into_inner(), fault)
}

#[test]
fn nothing_undefined_leaves_the_tracer() {
    let cases = std::env::var("PROPTEST_CASES").ok();
    let cases = cases
        .and_then(|n| n.parse().ok())
        .unwrap_or(crate::support::cases(15, 100));
    let (mut all, mut seen, mut faults) = (0, 0, Vec::new());
    for kind in 0..shapes().len() {
        let (valid, met, fault) = try_kind(kind, cases);
        all += valid;
        seen += met;
        faults.extend(fault.map(|f| format!("type {}: {f}", kind + 1)));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{all} scenes, something in {seen} pixels");
    assert!(all > 150 && seen > 150, "{all} {seen}");
}

/// Whether the origin is inside, and t, the point and the way of each crossing.
type Met = (bool, Vec<(f64, [f64; 3], Option<bool>)>);

fn met<R: Precision>(text: &str, o: [f64; 3], d: [f64; 3]) -> Met {
    let text = format!("{text}\n1 9999 10 0\n");
    let loaded = Analysis::new("a.zpg", text.into_bytes());
    assert!(loaded.is_sound());
    let tracer = Tracer::new(&loaded.scene).expect("a scene that can be drawn");
    let probe = tracer.probe(
        &mut tracer.walker::<R>(),
        &Ray::new(Vec3(o), Vec3(d)).cast(),
    );
    let crossing = |c: &zpg::internals::trace::Crossing<R>| {
        let point = c.hit.point.0.map(|x| x.to_f64());
        (c.hit.t.to_f64(), point, c.entering)
    };
    (
        probe.inside_at_origin,
        probe.crossings.iter().map(crossing).collect(),
    )
}

/// In double precision and double-double, which have one range.
fn both(text: &str, o: [f64; 3], d: [f64; 3]) -> Met {
    let answer = met::<f64>(text, o, d);
    assert_eq!(answer, met::<Dd>(text, o, d));
    answer
}

#[test]
fn a_ray_ends_where_the_numbers_do() {
    let z = [0.0, 0.0, 1.0];
    // z ≥ 1e309.
    let beyond = both("10 4 0 0 -0.1 1e308", [0.0; 3], [0.0, 0.0, 1.2e184]);
    assert_eq!(beyond, (false, vec![]));
    // z ≤ 1e309 holds all there is.
    assert_eq!(both("10 4 0 0 0.1 -1e308", [0.0; 3], z), (true, vec![]));
    // From within its lemon, into the tube at r − R; out of it only at r + R.
    let torus = "10 14 1e308 1.5e308";
    let upwards = [0.0, 0.0, 1e308];
    for (inside, crossings) in [
        met::<f64>(torus, [0.0; 3], upwards),
        met::<Dd>(torus, [0.0; 3], upwards),
    ] {
        assert!(!inside && crossings.len() == 1);
        let (t, point, entering) = crossings[0];
        assert!((t - 0.5).abs() < 1e-15 && (point[2] / 0.5e308 - 1.0).abs() < 1e-15);
        assert_eq!(entering, Some(true));
    }
    // A line that stands still in the space of a ball of radius 1e308.
    let ball = "10 9 1\n10 -3 1e308 1e308 1e308";
    let still = [0.0, 0.0, 1e-20];
    assert_eq!(both(ball, [0.5e308; 3], still), (true, vec![]));
    assert_eq!(both(ball, [0.0, 0.0, 1.5e308], still), (false, vec![]));
}

#[test]
fn tiny_numbers_are_as_good_as_others() {
    // z ≥ 0, by a normal that has no inverse, and left at t = 1e-309.
    let plane = "10 4 0 0 -2.2250738585072014e-308 0";
    let (inside, crossings) = both(plane, [0.0, 0.0, 0.1], [0.0, 0.0, -1e308]);
    assert!(inside && crossings.len() == 1);
    let (t, point, entering) = crossings[0];
    assert!((t / 1e-309 - 1.0).abs() < 1e-14 && point == [0.0; 3] && entering == Some(false));
}

#[test]
fn single_precision_has_its_own_range() {
    // A ball that is met at a distance of 1e40, and one at 1e30.
    for (z, count) in [(1e40, 0), (1e30, 2)] {
        let text = format!("10 11 0 0 {z:e} {:e}", z / 4.0);
        assert_eq!(met::<f32>(&text, [0.0; 3], [0.0, 0.0, 1e20]).1.len(), count);
        assert_eq!(met::<f64>(&text, [0.0; 3], [0.0, 0.0, 1e20]).1.len(), 2);
    }
}
