//! Lines against tori, by hand, in double-double and by dense sampling of the tube's distance.

use super::*;
use crate::geometry::dd::Dd;
use crate::geometry::number::Real;

fn meet<R: Traced>(torus: &Torus, o: [f64; 3], d: [f64; 3]) -> Roots<R> {
    let mut roots = Roots::default();
    let line = Line::new(Vec3(o.map(R::of)), Vec3(d.map(R::of)));
    torus.crossings(&line, &mut roots);
    assert!(!roots.inside && roots.list.len().is_multiple_of(2));
    assert!(roots.list.windows(2).all(|w| w[0].t < w[1].t));
    assert!(roots.list.iter().all(|root| root.t.is_finite()));
    for (i, &root) in roots.list.iter().enumerate() {
        let at = torus.locate(&line, root);
        assert!(at.point.is_finite() && at.error.is_finite() && at.normal.any());
        let along = at.normal.unit().dot(line.direction.unit());
        let sign = if i % 2 == 0 { -along } else { along };
        assert!(sign > R::of(-1e-3), "{along:?}");
    }
    roots
}

fn ts<R: Traced>(torus: &Torus, o: [f64; 3], d: [f64; 3]) -> Vec<f64> {
    meet::<R>(torus, o, d)
        .list
        .iter()
        .map(|r| r.t.to_f64())
        .collect()
}

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Touches are no crossings, and are known to be close calls.
fn touches<R: Traced>() {
    let torus = Torus::new(1.0, 0.25);
    for o in [[1.0, 0.25, -5.0], [0.0, 0.25, -5.0], [1.25, 0.0, -5.0]] {
        let roots = meet::<R>(&torus, o, Z);
        assert!(roots.list.is_empty() && roots.uncertain, "{o:?} {roots:?}");
    }
    // Where the touches are not at numbers of the kind, the line may as well pass by.
    assert!(ts::<R>(&torus, [0.6, 0.25, -5.0], Z).is_empty());
    // In, a touch from within, out.
    let roots = meet::<R>(&torus, [0.75, 0.0, -5.0], Z);
    let t: Vec<f64> = roots.list.iter().map(|r| r.t.to_f64()).collect();
    assert!(t.len() == 2 && roots.uncertain, "{roots:?}");
    // 1.25² = 0.75² + 1².
    assert!((t[0] - 4.0).abs() < 1e-15 * 8.0 && (t[1] - 6.0).abs() < 1e-15 * 8.0);
    // The waist of a horn.
    let down = ts::<R>(&Torus::new(1.0, 1.0), [0.0, 5.0, 0.0], [0.0, -1.0, 0.0]);
    assert!(down.is_empty());
}

#[test]
fn a_touch_has_no_inside() {
    touches::<f64>();
    touches::<Dd>();
}

/// A line one unit in the last place inside the rim is within the rounding of doubles, one of 64 units is not;
/// double-double tells both.
#[test]
fn the_bound_at_its_edge() {
    let torus = Torus::new(1.0, 0.25);
    for (ulps, decided) in [(1.0, false), (64.0, true)] {
        let x = 1.25 - ulps * f64::EPSILON;
        let plain = meet::<f64>(&torus, [x, 0.0, -5.0], Z);
        assert_eq!(plain.uncertain, !decided);
        assert_eq!(plain.list.len(), if decided { 2 } else { 0 });
        let exact = meet::<Dd>(&torus, [x, 0.0, -5.0], Z);
        assert!(!exact.uncertain && exact.list.len() == 2);
    }
}

#[test]
fn a_thin_chord_is_found() {
    let torus = Torus::new(1.0, 0.25);
    let x = 1.25 - 1e-9;
    for t in [
        ts::<f64>(&torus, [x, 0.0, -5.0], Z),
        ts::<Dd>(&torus, [x, 0.0, -5.0], Z),
    ] {
        // 5 ∓ √(1.25² − x²), of which the difference is exact.
        let half = ((1.25 - x) * (1.25 + x)).sqrt();
        assert!((half - 5e-5).abs() < 1e-10);
        assert_eq!(t.len(), 2);
        assert!((t[0] - (5.0 - half)).abs() < 1e-12 && (t[1] - (5.0 + half)).abs() < 1e-12);
    }
}

#[test]
fn thin_and_small_tori() {
    thin_and_small::<f64>();
    thin_and_small::<Dd>();
}

/// The hits of a tube of 1e-4 are held even by f32, from near.
#[test]
fn a_thin_tube_in_single_precision() {
    let t = ts::<f32>(&Torus::new(1.0, 1e-4), [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(t.len(), 4, "{t:?}");
    for (a, b) in t.iter().zip([3.9999, 4.0001, 5.9999, 6.0001]) {
        assert!((a - b).abs() < f64::from(f32::EPSILON) * 8.0, "{a} {b}");
    }
}

fn thin_and_small<R: Traced>() {
    let thin = Torus::new(1.0, 1e-4);
    for x in [5.0, 1e3] {
        let t = ts::<R>(&thin, [-x, 0.0, 0.0], [1.0, 0.0, 0.0]);
        let expected = [-1.0001, -0.9999, 0.9999, 1.0001].map(|e| x + e);
        assert_eq!(t.len(), 4);
        for (a, b) in t.iter().zip(expected) {
            assert!((a - b).abs() < 4.0 * f64::EPSILON * x, "{a} {b}");
        }
    }
    let small = Torus::new(1e-4, 0.25e-4);
    for view in [[0.0, 1.0, 0.0], [1e-6, -3.0, 2e-6], [2e-5, 1.0, 1e-5]] {
        let o = view.map(|x: f64| -x);
        assert!(ts::<R>(&small, o, view).is_empty());
    }
}

/// Lines from far away meet the torus as lines from near: the origin is moved along the line without loss.
#[test]
fn distance_costs_nothing() {
    from_afar::<f64>();
    from_afar::<Dd>();
}

fn from_afar<R: Traced>() {
    let far = 1e6;
    for minor in [0.25, 1e-4] {
        let torus = Torus::new(1.0, minor);
        for i in 0..200 {
            let x = -1.3 + 0.013 * f64::from(i);
            let near = meet::<R>(&torus, [x, 0.3 * minor, -4.0], Z);
            let away = meet::<R>(&torus, [x, 0.3 * minor, -far], Z);
            assert_eq!(near.list.len(), away.list.len());
            for (a, b) in near.list.iter().zip(&away.list) {
                let moved = (b.t.to_f64() - far) - (a.t.to_f64() - 4.0);
                assert!(moved.abs() <= 2.0 * f64::EPSILON * far, "{moved:e}");
            }
        }
    }
}

/// Through the lemon of a spindle: in, out into the lemon, in again, out. R = 1, r = 2: the axis
/// leaves at y = ±√3; along x the outer surface is at ±3 and the lemon's at ±1.
#[test]
fn the_lemon_is_outside() {
    let torus = Torus::new(1.0, 2.0);
    let roots = meet::<f64>(&torus, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let found: Vec<(f64, u32)> = roots.list.iter().map(|r| (r.t, r.face)).collect();
    assert_eq!(found.len(), 4);
    for ((t, face), expected) in found
        .into_iter()
        .zip([(2.0, 0), (4.0, 1), (6.0, 1), (8.0, 0)])
    {
        assert!((t - expected.0).abs() < 1e-14 && face == expected.1);
    }
    // Straight up near the axis, inside only between the lemon's tip and the outer surface.
    let t = ts::<f64>(&torus, [0.1, -9.0, 0.0], [0.0, 1.0, 0.0]);
    let (tip, top) = ((4.0f64 - 1.21).sqrt(), (4.0f64 - 0.81).sqrt());
    let expected = [9.0 - top, 9.0 - tip, 9.0 + tip, 9.0 + top];
    assert_eq!(t.len(), 4);
    assert!(
        t.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13),
        "{t:?}"
    );
}

/// Across the pinch of a horn torus: outside is where |x| < 1 − √(1 − y²), half of y² wide, which is
/// less than the digits of t in the end.
#[test]
fn the_pinch_is_open_at_any_height() {
    let torus = Torus::new(1.0, 1.0);
    const X: [f64; 3] = [1.0, 0.0, 0.0];
    for y in [1e-3, 1e-7, 1e-8, 1e-14, 1e-15, 1e-16, 1e-17, 1e-22, 1e-28] {
        for y in [y, -y] {
            let found = meet::<Dd>(&torus, [-5.0, y, 0.0], X);
            assert_eq!(found.list.len(), 4, "{y}");
            assert!(!found.uncertain);
            for root in &found.list[1..3] {
                assert!((root.t.to_f64() - 5.0).abs() <= 0.5001 * y * y + 1e-15);
            }
            let plain = meet::<f64>(&torus, [-5.0, y, 0.0], X);
            assert!(plain.uncertain || plain.list.len() == 4, "{y}");
        }
    }
    assert_eq!(meet::<Dd>(&torus, [-5.0, 0.0, 0.0], X).list.len(), 2);
}

#[test]
fn surface_coordinates() {
    let torus = Torus::new(1.0, 0.25);
    let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() < 1e-15);
    assert!(near(torus.uv(Vec3::new(1.25, 0.0, 0.0), OUTER), [0.0, 0.0]));
    assert!(near(
        torus.uv(Vec3::new(0.0, 0.25, -1.0), OUTER),
        [0.25, 0.25]
    ));
    assert!(near(
        torus.uv(Vec3::new(-0.75, 0.0, 0.0), OUTER),
        [0.5, 0.5]
    ));
    assert!(near(
        torus.uv(Vec3::new(0.0, -0.25, 1.0), OUTER),
        [0.75, 0.75]
    ));
    let spindle = Torus::new(1.0, 2.0);
    assert!(near(
        spindle.uv(Vec3::new(1.0, 0.0, 0.0), LEMON),
        [0.0, 0.5]
    ));
}

/// Numbers in [0, 1) (SplitMix64).
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// A line aimed into a torus of size 1, or one that grazes it: from far or near, of any length.
fn random_line(s: &mut u64, torus: &Torus) -> ([f64; 3], [f64; 3]) {
    let mut within = |a: f64, b: f64| a + (b - a) * random(s);
    let (turn, tube) = (within(0.0, TAU), within(0.0, TAU));
    let normal = [turn.cos() * tube.cos(), tube.sin(), turn.sin() * tube.cos()];
    let ring = [turn.cos(), 0.0, turn.sin()];
    let depth = if within(0.0, 1.0) < 0.5 {
        within(0.0, 1.0)
    } else {
        1.0 - 10f64.powf(within(-12.0, -1.0))
    };
    let target: [f64; 3] = std::array::from_fn(|i| {
        torus.record.major * ring[i] + depth * torus.record.minor * normal[i]
    });
    let mut d: [f64; 3] = std::array::from_fn(|_| within(-1.0, 1.0));
    if depth > 0.9 {
        let along: f64 = (0..3).map(|i| d[i] * normal[i]).sum();
        d = std::array::from_fn(|i| d[i] - along * normal[i]);
    } else if within(0.0, 1.0) < 0.2 {
        d[(within(0.0, 3.0)) as usize] = 0.0;
    }
    let size = torus.record.major + torus.record.minor;
    let away = size * 10f64.powf(within(-1.0, 6.0));
    let stretch = 10f64.powf(within(-6.0, 6.0));
    (
        std::array::from_fn(|i| target[i] - away * d[i]),
        d.map(|x| x * stretch),
    )
}

fn random_torus(s: &mut u64) -> Torus {
    let size = 10f64.powf(6.0 * random(s) - 3.0);
    let ratio = [1e-4, 0.01, 0.25, 0.9, 1.0, 1.5, 20.0][(7.0 * random(s)) as usize];
    Torus::new(size, size * ratio)
}

/// A decision is the same as in double-double, and the roots agree to the rounding of t and of the point where the line
/// meets the surface, over how steeply it does.
#[test]
fn agrees_with_double_double() {
    let (mut s, mut crossings, mut uncertain) = (1, 0, 0);
    for _ in 0..20_000 {
        let torus = random_torus(&mut s);
        let (o, d) = random_line(&mut s, &torus);
        let (plain, exact) = (meet::<f64>(&torus, o, d), meet::<Dd>(&torus, o, d));
        if plain.uncertain {
            uncertain += 1;
            continue;
        }
        assert_eq!(plain.list.len(), exact.list.len(), "{torus:?} {o:?} {d:?}");
        let line = Line::new(Vec3(o.map(Dd::of)), Vec3(d.map(Dd::of)));
        let length = Vec3(d).length();
        for (a, b) in plain.list.iter().zip(&exact.list) {
            crossings += 1;
            assert_eq!(a.face, b.face);
            let normal = torus.locate(&line, *b).normal.unit();
            let steep = normal.dot(line.direction.unit()).abs().to_f64();
            let size = torus.record.major + torus.record.minor;
            let error = (Dd::of(a.t) - b.t).abs().to_f64() * length;
            // Near the extremum a root moves as the square root of what moves the surface.
            let ulp = 16.0 * f64::EPSILON * size;
            let bound = (ulp / steep).min((ulp * size).sqrt())
                + 4.0 * f64::EPSILON * b.t.abs().to_f64() * length;
            assert!(
                error <= bound,
                "{error:e} {bound:e} {steep:e} {torus:?} {o:?} {d:?}"
            );
        }
    }
    assert!(crossings > 20_000, "{crossings}");
    assert!(uncertain < 200, "{uncertain}");
}

/// The number of crossings and their places by stepping along the line and halving: even-odd over
/// the circles that the line meets in each half-plane.
#[test]
fn agrees_with_sampling() {
    const STEPS: usize = 4000;
    let mut s = 7;
    for _ in 0..400 {
        let ratio = [0.05, 0.25, 0.9, 1.5, 3.0][(5.0 * random(&mut s)) as usize];
        let torus = Torus::new(1.0, ratio);
        let size = 1.0 + ratio;
        let (_, d) = random_line(&mut s, &torus);
        let d = Vec3(d).unit();
        let o = Vec3(std::array::from_fn(|_| size * (2.0 * random(&mut s) - 1.0)));
        let inside = |t: f64| {
            let [x, y, z] = (o + d * t).0;
            let rho = x.hypot(z);
            let holds = |centre: f64| (rho - centre).hypot(y) < ratio;
            holds(1.0) != holds(-1.0)
        };
        let at = |i: usize| 3.0 * size * (2.0 * i as f64 / STEPS as f64 - 1.0);
        let mut expected = Vec::new();
        for i in 0..STEPS {
            let (mut a, mut b) = (at(i), at(i + 1));
            if inside(a) != inside(b) {
                for _ in 0..60 {
                    let m = (a + b) / 2.0;
                    if inside(m) == inside(a) { a = m } else { b = m }
                }
                expected.push(a);
            }
        }
        // Chords that a step may jump over are not there to be compared.
        let step = at(1) - at(0);
        let mut found = ts::<f64>(&torus, o.0, d.0);
        let mut i = 1;
        while i < found.len() {
            let jumped = !expected.iter().any(|e| (e - found[i]).abs() < 1e-9);
            if jumped && found[i] - found[i - 1] < step {
                found.drain(i - 1..=i);
                i = i.max(2) - 1;
            } else {
                i += 1;
            }
        }
        assert_eq!(found.len(), expected.len(), "{torus:?} {o:?} {d:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

/// Lines at the ends of the numbers: `meet` checks that nothing leaves them.
#[test]
fn no_line_makes_a_nan() {
    extreme_lines::<f32>();
    extreme_lines::<f64>();
    extreme_lines::<Dd>();
}

fn extreme_lines<R: Traced>() {
    let values = [0.0, 1.0, -0.75, 1e-320, 1e-200, 1e200, -1e308];
    let n = values.len();
    for torus in [(1.0, 0.25), (1e-300, 1e-302), (1e300, 1e301), (1.0, 1e-320)] {
        let torus = Torus::new(torus.0, torus.1);
        for i in 0..n.pow(6) {
            let v: [f64; 6] = std::array::from_fn(|k| values[i / n.pow(k as u32) % n]);
            let v = v.map(R::of);
            let line = Line::new(Vec3([v[0], v[1], v[2]]), Vec3([v[3], v[4], v[5]]));
            // Some of the numbers are not there in f32.
            let is_line = v.iter().all(|x| x.is_finite()) && line.direction.any();
            if i % 29 == 0 && is_line {
                let mut roots = Roots::default();
                torus.crossings(&line, &mut roots);
                assert!(roots.list.len().is_multiple_of(2));
                for &root in &roots.list {
                    assert!(root.t.is_finite());
                    let at = torus.locate(&line, root);
                    assert!(
                        at.point.is_finite() && at.error.is_finite(),
                        "{torus:?} {line:?}"
                    );
                    assert!(at.normal.is_finite() && at.normal.any());
                }
            }
        }
    }
}

/// Points lie within their bounds of the surface, whatever t was, and the box around them all.
#[test]
fn points_are_on_the_surface() {
    let mut s = 3;
    for _ in 0..5000 {
        let torus = random_torus(&mut s);
        let (o, d) = random_line(&mut s, &torus);
        let line = Line::new(Vec3(o), Vec3(d));
        for root in meet::<f64>(&torus, o, d).list {
            let at = torus.locate(&line, root);
            let [x, y, z] = at.point.0.map(Dd::of);
            let centre = Dd::of(if root.face == LEMON {
                -torus.record.major
            } else {
                torus.record.major
            });
            let h = (x * x + z * z).sqrt() - centre;
            let off = ((h * h + y * y).sqrt() - Dd::of(torus.record.minor))
                .abs()
                .to_f64();
            assert!(off <= at.error.length(), "{off:e} {at:?}");
            let b = torus.bounds();
            assert!((0..3).all(|i| b.min[i] <= at.point[i] && at.point[i] <= b.max[i]));
        }
    }
}
