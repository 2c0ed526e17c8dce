//! W307 and W311 on random solids: whatever overlaps, or reaches out of its volume, so far that it can be
//! seen is found, and what only comes near is not. That something does so is known from where the two were
//! put, and made sure of by tests of points; not by the rules' own search.

use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Diagnostic, Value};
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::geometry::{Aabb, Matrix};
use zpg::internals::scene::{NodeId, Scene};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::trace::{Images, Ray, Tracer, members};

use crate::campaign::rng::Rng;
use crate::support::seeds;

/// All solids, by what stands behind the ID; whether they are convex.
fn solid(rng: &mut Rng, kind: usize) -> (String, bool) {
    let mut n = |low: f64, high: f64| (rng.range(low, high) * 1e3).round() / 1e3;
    match kind {
        0 => (format!("9 {}", n(0.3, 2.0)), true),
        1 => (
            format!("10 {} {} {}", n(0.3, 2.0), n(0.3, 2.0), n(0.3, 2.0)),
            true,
        ),
        2 => (
            format!("11 {} {} 0.5 {}", n(-1.0, 1.0), n(-1.0, 1.0), n(0.3, 2.0)),
            true,
        ),
        3 => (
            format!(
                "12 {} {} -0.5 {} {} 1",
                n(-2.0, -0.2),
                n(-2.0, -0.2),
                n(0.2, 2.0),
                n(0.2, 2.0)
            ),
            true,
        ),
        4 => {
            let r = n(0.3, 2.0);
            (format!("13 {r} {}", rng.below(5)), true)
        }
        5 => {
            let major = n(0.5, 2.0);
            (format!("14 {major} {}", n(0.1, 0.9) * major), false)
        }
        6 => (format!("14 {} {}", n(0.3, 0.6), n(0.7, 1.2)), false),
        7 => (format!("16 {} {}", n(0.3, 2.0), n(0.3, 2.0)), true),
        8 => (format!("16 {} {}", n(-2.0, -0.3), n(0.3, 2.0)), true),
        9 => (format!("17 {} {}", n(0.3, 2.0), n(0.3, 2.0)), false),
        // A cylinder, a truncated cone, a vase, a ring.
        10 => {
            let r = n(0.3, 1.5);
            (format!("1 2 {r} -1 {r} {}", n(-0.5, 1.0)), true)
        }
        11 => (
            format!("1 2 {} -1 {} {}", n(0.0, 1.0), n(0.2, 1.5), n(-0.5, 1.0)),
            true,
        ),
        12 => (
            format!(
                "1 5 0 -1 {} -0.8 {} 0 {} 0.5 0.2 1",
                n(0.8, 1.5),
                n(0.2, 0.6),
                n(0.7, 1.2)
            ),
            false,
        ),
        13 => {
            let (r, w) = (n(0.5, 1.5), n(0.1, 0.5));
            (
                format!("1 5 {r} 0 {} 0 {} 0.5 {r} 0.5 {r} 0", r + w, r + w),
                false,
            )
        }
        14 => {
            let r = n(0.3, 1.5);
            (format!("2 2 {r} -1 {r} 1 1 0 0 0 0 1"), true)
        }
        // An ellipsoid as a quadric, off its middle; a cone of both ways; a paraboloid.
        15 => {
            let (a, b, c) = (n(0.3, 3.0), n(0.3, 3.0), n(0.3, 3.0));
            let (x, y) = (n(-0.3, 0.3), n(-0.3, 0.3));
            (
                format!("15 {a} {x} 0 0.5 {x} {b} {y} 0 0 {y} {c} -0.2 0.5 0 -0.2 -2"),
                true,
            )
        }
        16 => (
            format!(
                "15 {} 0 0 0 0 -1 0 0 0 0 {} 0 0 0 0 0",
                n(0.3, 3.0),
                n(0.3, 3.0)
            ),
            false,
        ),
        17 => (
            format!("4 {} {} 1 {}", n(-1.0, 1.0), n(-1.0, 1.0), n(-1.0, 1.0)),
            true,
        ),
        18 => (format!("18 {}", n(0.3, 2.0)), true),
        19 => (format!("19 {} {}", n(0.3, 2.0), n(0.3, 2.0)), false),
        20 => (
            format!("20 {} {} {} 1", n(0.3, 2.0), n(0.3, 2.0), n(0.3, 2.0)),
            false,
        ),
        21 => (
            format!("20 {} {} {} 2", n(0.3, 2.0), n(0.3, 2.0), n(0.3, 2.0)),
            false,
        ),
        _ => (format!("21 {} {}", n(0.3, 2.0), n(0.3, 2.0)), false),
    }
}

const KINDS: usize = 23;
/// Those that end.
const FINITE: usize = 16;

fn load(text: &str) -> Analysis {
    let loaded = Analysis::new("scene.zpg", text.as_bytes().to_vec());
    assert!(loaded.is_sound(), "{text}\n{:?}", loaded.findings());
    loaded
}

fn rows(m: &Matrix) -> String {
    let numbers = m.0.iter().flatten().map(|x| format!("{x:?}"));
    numbers.collect::<Vec<_>>().join(" ")
}

/// A turn by any angles, and sometimes a stretch before it.
fn placement(rng: &mut Rng, ends: bool) -> Matrix {
    let turn = Matrix::rotation(rng.range(0.0, 360.0), 0)
        .after(&Matrix::rotation(rng.range(0.0, 360.0), 1))
        .after(&Matrix::rotation(rng.range(0.0, 360.0), 2));
    match rng.below(3) {
        0 => turn.after(&Matrix::scaling(
            rng.range(0.3, 3.0),
            rng.range(0.3, 3.0),
            rng.range(0.3, 3.0),
        )),
        // What has no end is not looked for far from where it is at home.
        1 if ends => turn.after(&Matrix::scaling(0.01, 0.01, 0.01)),
        _ => turn,
    }
}

/// The rotation that takes one direction to another.
fn turned(from: Vec3, to: Vec3) -> Matrix {
    let axis = |v: Vec3| {
        let least = if v[0].abs() < 0.7 {
            Vec3([1.0, 0.0, 0.0])
        } else {
            Vec3([0.0, 1.0, 0.0])
        };
        let u = v.cross(least);
        let u = u * (1.0 / u.length());
        [v, u, v.cross(u)]
    };
    let (f, t) = (axis(from), axis(to));
    let mut m = Matrix::IDENTITY;
    for k in 0..9 {
        let (i, j) = (k / 3, k % 3);
        m.0[i][j] = t.iter().zip(&f).map(|(t, f)| t[i] * f[j]).sum();
    }
    m
}

fn only(scene: &Scene, root: NodeId) -> Tracer {
    let mut scene = scene.clone();
    let render = scene.render.as_mut().unwrap();
    (render.root, render.clip) = (root, None);
    Tracer::with_images(&scene, &Images::default()).expect("there are no images")
}

/// Points of a surface met by random rays, with the normals there.
fn surface(rng: &mut Rng, scene: &Scene, root: NodeId, b: &Aabb, rays: usize) -> Vec<[Vec3; 2]> {
    let tracer = only(scene, root);
    let mut walkers = tracer.walker::<f64>();
    let mut out = Vec::new();
    for _ in 0..rays {
        let mut point = || {
            Vec3(std::array::from_fn(|i| {
                let (low, high) = (b.min[i].max(-3.0), b.max[i].min(3.0));
                rng.range(low.min(high), high.max(low))
            }))
        };
        let (p, q) = (point(), point());
        let ray = Ray::new(p - (q - p) * 9.0, q - p);
        let met = tracer.crossings(&mut walkers, &ray);
        out.extend(met.iter().map(|c| [c.hit.point, c.normal]));
    }
    out
}

/// The longest side of something that ends; what has no end is as large as it is written.
fn extent(b: &Aabb) -> f64 {
    let longest = (0..3).fold(0.0f64, |m, i| m.max(b.max[i] - b.min[i]));
    if longest.is_finite() { longest } else { 1.0 }
}

fn of(loaded: &Analysis, code: Code) -> Vec<&Diagnostic> {
    loaded
        .findings()
        .iter()
        .filter(|d| d.code == code)
        .collect()
}

fn witness(d: &Diagnostic) -> Vec3 {
    Vec3(["x", "y", "z"].map(|axis| {
        let value = &d.values.iter().find(|v| v.0 == axis).unwrap().1;
        match value {
            Value::Text(text) => text.parse().unwrap(),
            Value::Decimal(number) => number.parse().unwrap(),
            other => panic!("{other:?}"),
        }
    }))
}

/// A glass and an opaque solid in one union, the second one put to the first one's surface by a share of
/// the smaller one's size; where they should meet.
struct Two {
    text: String,
    middle: Vec3,
    size: f64,
}

fn two(rng: &mut Rng, kinds: [usize; 2], share: f64) -> Option<Two> {
    let (one, two) = (solid(rng, kinds[0]).0, solid(rng, kinds[1]).0);
    let [m, n] = kinds.map(|kind| placement(rng, kind < FINITE));
    let alone = |what: &str, m: &Matrix| format!("2 {what}\n2 -4 {}\n1 9999 2 0\n", rows(m));
    let mut face = |what: &str, m: &Matrix| {
        let loaded = load(&alone(what, m));
        let root = loaded.scene.render?.root;
        let b = node_bounds(&loaded.scene)[root as usize].all;
        let all = surface(rng, &loaded.scene, root, &b, 20);
        let size = extent(&b);
        (!all.is_empty()).then(|| (all[rng.below(all.len())], size))
    };
    let ([a, normal], size) = face(&one, &m)?;
    let ([b, other], size_two) = face(&two, &n)?;
    let size = size.min(size_two);
    let target = a - normal * (share * size);
    let place = Matrix::translation(target[0], target[1], target[2])
        .after(&turned(other, -normal))
        .after(&Matrix::translation(-b[0], -b[1], -b[2]))
        .after(&n);
    let order = if rng.chance(0.5) { "2 3" } else { "3 2" };
    Some(Two {
        text: format!(
            "2 {one}\n2 -4 {}\n2 -201 0 0 1\n3 {two}\n3 -4 {}\n4 -101 {order}\n1 9999 4 0\n",
            rows(&m),
            rows(&place)
        ),
        middle: a - normal * (share * size / 2.0),
        size,
    })
}

/// Whether both parts of a union hold a point and what is around it.
fn in_both(scene: &Scene, p: Vec3, around: f64) -> bool {
    let root = scene.render.unwrap().root;
    let holds = |p: Vec3| {
        members(scene, root, p).is_ok_and(|m| [2, 3].iter().all(|i| m.inside.contains(i)))
    };
    holds(p)
        && (0..6).all(|k| {
            let mut q = p;
            q.0[k / 2] += if k % 2 == 0 { around } else { -around };
            holds(q)
        })
}

/// Whether each of the two parts reaches out of the other one. Where one does not, nobody can tell whose
/// its inside is.
fn both_reach_out(rng: &mut Rng, two: &Two, scene: &Scene) -> bool {
    let lines: Vec<&str> = two.text.lines().collect();
    [(2, 0..2), (3, 3..5)].into_iter().all(|(id, records)| {
        let alone = lines[records].join("\n") + &format!("\n1 9999 {id} 0\n");
        let alone = load(&alone).scene;
        let root = alone.render.unwrap().root;
        let b = node_bounds(&alone)[root as usize].all;
        let surface = surface(rng, &alone, root, &b, 200);
        surface.iter().any(|&[point, _]| {
            let members = members(scene, scene.render.unwrap().root, point);
            members.is_ok_and(|m| m.inside.iter().all(|&i| i == id))
        })
    })
}

#[test]
fn what_overlaps_visibly_is_found() {
    let mut silent = String::new();
    let (mut count, mut missed) = (0, 0);
    for seed in seeds("OVERLAPS", 0..600) {
        let mut rng = Rng::new(seed);
        let kinds = [rng.below(KINDS), rng.below(KINDS)];
        let share = rng.decade(-2.8, 0.0);
        let Some(two) = two(&mut rng, kinds, share) else {
            continue;
        };
        let loaded = load(&two.text);
        let deep = in_both(&loaded.scene, two.middle, 2e-4 * two.size);
        if !deep || !both_reach_out(&mut rng, &two, &loaded.scene) {
            continue;
        }
        count += 1;
        match of(&loaded, Code::W307)[..] {
            [] => {
                missed += 1;
                silent += &format!("{seed}: {kinds:?} share {share}\n{}\n", two.text);
            }
            [found, ..] => {
                let p = witness(found);
                assert!(
                    in_both(&loaded.scene, p, 0.0),
                    "{seed}: {p:?}\n{}",
                    two.text
                );
            }
        }
    }
    assert!(count > 300, "{count}");
    assert!(silent.is_empty(), "silent: {missed} of {count}\n{silent}");
}

#[test]
fn what_comes_near_is_not() {
    let mut count = 0;
    for seed in seeds("OVERLAPS", 0..300) {
        let mut rng = Rng::new(seed);
        let kinds = [rng.below(KINDS), rng.below(KINDS)];
        let convex = kinds.iter().all(|&k| solid(&mut Rng::new(0), k).1);
        // Two half-spaces or paraboloids meet somewhere.
        if !convex || kinds.iter().all(|&k| k >= FINITE) {
            continue;
        }
        let gap = rng.decade(-6.0, -0.5);
        let Some(two) = two(&mut rng, kinds, -gap) else {
            continue;
        };
        count += 1;
        let loaded = load(&two.text);
        assert!(
            of(&loaded, Code::W307).is_empty(),
            "{seed}: gap {gap}\n{}",
            two.text
        );
    }
    assert!(count > 60, "{count}");
}

/// An object that ends: a shape, or an operation of two that overlap.
fn object(rng: &mut Rng) -> String {
    let part = |id: usize, rng: &mut Rng, kind: usize| {
        let m = placement(rng, true);
        let m = Matrix::translation(rng.range(-0.5, 0.5), rng.range(-0.5, 0.5), 0.1).after(&m);
        format!("{id} {}\n{id} -4 {}\n", solid(rng, kind).0, rows(&m))
    };
    let (kind, other) = (rng.below(FINITE), rng.below(KINDS));
    let first = part(3, rng, kind);
    match rng.below(4) {
        0 => first + "2 -105 3\n",
        1 => first + &part(4, rng, other % FINITE) + "2 -101 3 4\n",
        2 => first + &part(4, rng, other) + "2 -102 3 4\n",
        _ => first + &part(4, rng, other) + "2 -103 3 4\n",
    }
}

#[test]
fn what_reaches_out_visibly_is_found() {
    let mut silent = String::new();
    let (mut count, mut missed) = (0, 0);
    for seed in seeds("OVERSHOOTS", 0..500) {
        let mut rng = Rng::new(seed);
        let object = object(&mut rng);
        let alone = load(&(object.clone() + "1 9999 2 0\n"));
        let root = alone.scene.render.unwrap().root;
        let b = node_bounds(&alone.scene)[root as usize].all;
        if b.is_empty() {
            continue;
        }
        let all = surface(&mut rng, &alone.scene, root, &b, 300);
        if all.len() < 20 {
            continue;
        }
        let tight = all
            .iter()
            .fold(Aabb::EMPTY, |b, [p, _]| b.hull(&Aabb::new(p.0, p.0)));
        let size = extent(&tight);
        let over = rng.range(0.01, 0.03);
        // One side of a box, or a ball, that a known point is beyond.
        let (volume, held) = if rng.chance(0.5) {
            let (axis, up) = (rng.below(3), rng.chance(0.5));
            let wide = |k: f64| Aabb::new(b.min.map(|x| x - k), b.max.map(|x| x + k));
            let mut out = wide(0.01 * size);
            let long = extent(&out).max(
                out.min
                    .iter()
                    .chain(&out.max)
                    .fold(0.0, |m: f64, x| m.max(x.abs())),
            );
            match up {
                true => out.max[axis] = tight.max[axis] - over * long,
                false => out.min[axis] = tight.min[axis] + over * long,
            }
            if out.is_empty() {
                continue;
            }
            let spelled = |b: &Aabb| {
                let [x, y, z] = b.min;
                let [u, v, w] = b.max;
                format!("2 -601 {x:?} {y:?} {z:?} {u:?} {v:?} {w:?}\n")
            };
            (spelled(&out), spelled(&wide(0.0)))
        } else {
            let centre = Vec3(tight.centre()) + Vec3(rng.cube()) * (0.3 * size);
            let far = all
                .iter()
                .fold(0.0f64, |m, [p, _]| m.max((*p - centre).length()));
            let corner = Vec3(std::array::from_fn(|i| {
                (b.max[i] - centre[i])
                    .abs()
                    .max((centre[i] - b.min[i]).abs())
            }));
            let [x, y, z] = centre.0;
            let spelled = |r: f64| format!("2 -602 {x:?} {y:?} {z:?} {r:?}\n");
            let long = far.max(x.abs()).max(y.abs()).max(z.abs());
            if far <= over * long {
                continue;
            }
            (spelled(far - over * long), spelled(corner.length()))
        };
        count += 1;
        let small = load(&(object.clone() + &volume + "1 9999 2 0\n"));
        if of(&small, Code::W311).is_empty() {
            missed += 1;
            silent += &format!("{seed}: by {over}\n{object}{volume}\n");
        }
        let large = load(&(object.clone() + &held + "1 9999 2 0\n"));
        assert!(of(&large, Code::W311).is_empty(), "{seed}\n{object}{held}");
    }
    assert!(count > 300, "{count}");
    assert!(silent.is_empty(), "silent: {missed} of {count}\n{silent}");
}

/// W308 is said where faces of both are left, and not where one lies deep within the other.
#[test]
fn two_looks_where_two_are_left() {
    let (mut both, mut one) = (0, 0);
    for seed in seeds("MIXED", 0..300) {
        let mut rng = Rng::new(seed);
        let kinds = [rng.below(FINITE), rng.below(KINDS)];
        let [first, second] = kinds.map(|kind| solid(&mut rng, kind));
        let [m, n] = kinds.map(|_| placement(&mut rng, true));
        let deep = rng.chance(0.4);
        let text = |m: &Matrix| {
            let order = if seed % 2 == 0 { "2 3" } else { "3 2" };
            format!(
                "2 {}\n2 -4 {}\n2 -701 1 0 0\n3 {}\n3 -4 {}\n4 -102 {order}\n1 9999 4 0\n",
                first.0,
                rows(m),
                second.0,
                rows(&n)
            )
        };
        let mut placed = m;
        if deep && second.1 {
            // Around some point that is inside by much.
            let around = load(&text(&m));
            let root = around
                .scene
                .entities
                .iter()
                .find(|e| e.id == 3)
                .unwrap()
                .node()
                .unwrap();
            let b = node_bounds(&around.scene)[root as usize].all;
            let faces = surface(&mut rng, &around.scene, root, &b, 12);
            if faces.len() < 4 {
                continue;
            }
            let sum = faces.iter().fold(Vec3([0.0; 3]), |sum, [p, _]| sum + *p);
            let middle = sum * (1.0 / faces.len() as f64);
            let small = Matrix::scaling(0.005, 0.005, 0.005);
            placed = Matrix::translation(middle[0], middle[1], middle[2])
                .after(&small.after(&turned(Vec3([1.0, 0.0, 0.0]), Vec3([0.6, 0.0, 0.8]))));
            let within = load(&text(&placed));
            if !in_both(&within.scene, middle, 0.05) && kinds[1] < FINITE {
                // The first one is that small; the second one is asked for alone.
                let root = within
                    .scene
                    .entities
                    .iter()
                    .find(|e| e.id == 3)
                    .unwrap()
                    .node()
                    .unwrap();
                let held = (0..8).all(|k| {
                    let corner = |i: usize| if k >> i & 1 == 0 { -0.05 } else { 0.05 };
                    let p = middle + Vec3([corner(0), corner(1), corner(2)]);
                    members(&within.scene, root, p).is_ok_and(|m| m.in_root)
                });
                if held {
                    one += 1;
                    let found = of(&within, Code::W308);
                    assert!(found.is_empty(), "{seed}: {kinds:?}\n{}", text(&placed));
                }
                continue;
            }
        }
        let loaded = load(&text(&placed));
        let root = loaded.scene.render.unwrap().root;
        let tracer = only(&loaded.scene, root);
        let mut walkers = tracer.walker::<f64>();
        let mut left = std::collections::BTreeSet::new();
        for _ in 0..60 {
            let (p, q) = (Vec3(rng.cube()), Vec3(rng.cube()));
            let ray = Ray::new(p - (q - p) * 9.0, q - p);
            left.extend(tracer.crossings(&mut walkers, &ray).iter().map(|c| c.shape));
        }
        if left.len() == 2 {
            both += 1;
            assert_eq!(
                of(&loaded, Code::W308).len(),
                1,
                "{seed}: {kinds:?}\n{}",
                text(&placed)
            );
        }
    }
    assert!(both > 80 && one > 15, "{both} {one}");
}
