//! Surfaces of second degree: crossings against the definitions of the shapes, evaluated in
//! double-double arithmetic point by point.

use crate::trace_support;
use trace_support::*;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::line::{Line, Traced};
use zpg::internals::geometry::number::Real;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Geometry;
use zpg::internals::trace::Ray;
use zpg::internals::trace::shapes::{Primitive, Roots};

/// Negative inside, positive outside: the definition of each shape as the language gives it.
fn value(geometry: &Geometry, p: Vec3<Dd>) -> Dd {
    let n = Dd::of;
    let (x, y, z) = (p[0], p[1], p[2]);
    let over = |x: Dd, a: f64| (x / n(a)).square();
    match *geometry {
        Geometry::Ellipsoid {
            semi_axes: [a, b, c],
        } => over(x, a) + over(y, b) + over(z, c) - Dd::ONE,
        Geometry::Quadric(ref q) => {
            let h = [x, y, z, Dd::ONE];
            let mut sum = Dd::ZERO;
            for i in 0..4 {
                for j in 0..4 {
                    sum += n(q[4 * i + j]) * h[i] * h[j];
                }
            }
            sum
        }
        Geometry::Cone { height, radius } => {
            let s = y / n(height);
            let side = over(x, radius) + over(z, radius) - s.square();
            side.max(-s).max(s - Dd::ONE)
        }
        Geometry::DoubleCone { height, radius } => {
            let s = y / n(height);
            let side = over(x, radius) + over(z, radius) - s.square();
            side.max(s.abs() - Dd::ONE)
        }
        Geometry::ParabolicCylinder { a } => over(x, a) - y,
        Geometry::HyperbolicCylinder { a, b } => over(x, a) - over(y, b) - Dd::ONE,
        Geometry::Hyperboloid { a, b, c, sheets } => {
            let one = n(if sheets == 1 { -1.0 } else { 1.0 });
            over(x, a) - over(y, b) + over(z, c) + one
        }
        Geometry::HyperbolicParaboloid { a, b } => over(x, a) - over(z, b) - y,
        _ => unreachable!(),
    }
}

fn crossings<R: Traced>(geometry: &Geometry, line: &Line<R>) -> Roots<R> {
    let mut roots = Roots::default();
    let shape = Primitive::new(geometry);
    shape.intersect().crossings(line, &mut roots);
    roots
}

fn line<R: Traced>(o: [f64; 3], d: [f64; 3]) -> Line<R> {
    Line::new(Vec3(o.map(R::of)), Vec3(d.map(R::of)))
}

/// t of all crossings in doubles and in double-doubles, which must be as many.
fn both(geometry: &Geometry, o: [f64; 3], d: [f64; 3]) -> (bool, Vec<f64>) {
    let plain: Roots = crossings(geometry, &line(o, d));
    let exact: Roots<Dd> = crossings(geometry, &line(o, d));
    assert_eq!(plain.inside, exact.inside, "{geometry:?} {o:?} {d:?}");
    let t: Vec<f64> = plain.list.iter().map(|r| r.t).collect();
    let e: Vec<f64> = exact.list.iter().map(|r| r.t.to_f64()).collect();
    assert_eq!(t.len(), e.len(), "{geometry:?} {o:?} {d:?}");
    for (a, b) in t.iter().zip(&e) {
        assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{t:?} {e:?}");
    }
    (plain.inside, t)
}

/// One of every kind, of sizes within 1e±`spread`.
fn shape(kind: u64, r: &mut Random, spread: f64) -> (Geometry, f64) {
    let base = r.within(-spread, spread);
    let mut size = || 10f64.powf(base + r.within(-0.5, 0.5));
    let (a, b, c) = (size(), size(), size());
    let flip = if r.below(2) == 0 { 1.0 } else { -1.0 };
    let geometry = match kind {
        0 => Geometry::Ellipsoid {
            semi_axes: [a, b, c],
        },
        1 => Geometry::Quadric(Box::new(std::array::from_fn(|i| {
            let scale = [1.0, a, a * a][usize::from(i % 4 == 3) + usize::from(i / 4 == 3)];
            r.within(-1.0, 1.0) * scale
        }))),
        2 => Geometry::Cone {
            height: flip * a,
            radius: b,
        },
        3 => Geometry::DoubleCone {
            height: a,
            radius: b,
        },
        4 => Geometry::ParabolicCylinder { a: a.sqrt() },
        5 => Geometry::HyperbolicCylinder { a, b },
        6 => Geometry::Hyperboloid {
            a,
            b,
            c,
            sheets: 1 + r.below(2) as u32,
        },
        _ => Geometry::HyperbolicParaboloid {
            a: a.sqrt(),
            b: b.sqrt(),
        },
    };
    (geometry, a)
}

/// A bound on the rounding in the value of the definition at t, and on how deep a chord is that
/// cannot be told from a touch.
///
/// A value is the sum of up to 16 products of three factors, each of them a coordinate of two
/// roundings and a division: at most 4·3 + 16 roundings of the sizes of the terms, which are those
/// of the definition with every sign turned to plus. A chord that is taken for a touch is as deep
/// as its discriminant over 4a: the rounding of b² and 4ac, whose terms have 20 roundings each where
/// the line is closest, and are no larger there.
fn noise(geometry: &Geometry, l: &Line<Dd>, t: Dd) -> Dd {
    let (o, d) = (l.origin.abs(), l.direction.abs());
    Dd::gamma(2 * 20 + 28) * sizes(geometry, o + d * t.abs())
}

/// The sum of the sizes of the terms of the definition, for a point without negative coordinates.
fn sizes(geometry: &Geometry, p: Vec3<Dd>) -> Dd {
    let over = |x: Dd, a: f64| (x / Dd::of(a)).square();
    match *geometry {
        Geometry::Quadric(ref q) => value(&Geometry::Quadric(Box::new(q.map(f64::abs))), p),
        Geometry::Cone { height, radius } | Geometry::DoubleCone { height, radius } => {
            let s = over(p[1], height);
            over(p[0], radius) + s + over(p[2], radius) + s.sqrt() + Dd::ONE
        }
        Geometry::Ellipsoid { .. } => value(geometry, p) + Dd::of(2.0),
        Geometry::ParabolicCylinder { a } => over(p[0], a) + p[1],
        Geometry::HyperbolicCylinder { a, b } => over(p[0], a) + over(p[1], b) + Dd::ONE,
        Geometry::Hyperboloid { a, b, c, .. } => {
            over(p[0], a) + over(p[1], b) + over(p[2], c) + Dd::ONE
        }
        Geometry::HyperbolicParaboloid { a, b } => over(p[0], a) + over(p[2], b) + p[1],
        _ => unreachable!(),
    }
}

/// The sides of a line between its crossings, against the definition.
fn check_sides(geometry: &Geometry, l: &Line<Dd>, roots: &Roots<Dd>) {
    let mut inside = roots.inside;
    let t: Vec<Dd> = roots.list.iter().map(|r| r.t).collect();
    let test = |t: Dd, inside: bool| {
        let f = value(geometry, l.at(t));
        let noise = noise(geometry, l, t);
        assert!(
            f.abs() <= noise || (f < Dd::ZERO) == inside,
            "{geometry:?} {l:?} {roots:?} at {t:?}: {f:?}"
        );
    };
    assert!(t.windows(2).all(|w| w[0] < w[1]));
    let closest = -(l.origin.dot(l.direction) / l.direction.dot(l.direction));
    let (first, last) = (
        t.first().copied().unwrap_or(closest),
        t.last().copied().unwrap_or(closest),
    );
    let scale = (last - first) + (last - closest).abs() + l.direction.length().recip();
    for k in 0..12 {
        // Beyond the last crossing and before the first, ever further away.
        let far = scale * Dd::of(10f64.powi(k - 4));
        test(first - far, inside);
        test(last + far, inside ^ (t.len() % 2 == 1));
    }
    for w in t.windows(2) {
        inside = !inside;
        for k in 1..16 {
            test(w[0] + (w[1] - w[0]) * Dd::of(f64::from(k) / 16.0), inside);
        }
    }
}

#[test]
fn random_lines_change_sides_where_the_definition_does() {
    let mut r = Random(3);
    let (mut uncertain, mut met) = (0, [0; 8]);
    let rounds = 16_000;
    for round in 0..rounds {
        let kind = round % 8;
        let (geometry, size) = shape(kind, &mut r, 3.0);
        let target = r.point(1.5 * size);
        let away = size * 10f64.powf(r.within(0.0, 6.0));
        let origin = target + r.point(1.0).unit() * away;
        let direction = (target - origin).unit() * 10f64.powf(r.within(-6.0, 6.0));
        let plain: Line = Line::new(origin, direction);
        let exact = line::<Dd>(origin.0, direction.0);
        let t = crossings(&geometry, &plain);
        let e = crossings(&geometry, &exact);
        check_sides(&geometry, &exact, &e);
        met[kind as usize] += e.list.len();
        uncertain += u32::from(t.uncertain);
        if t.uncertain {
            continue;
        }
        assert_eq!(t.inside, e.inside, "{geometry:?} {plain:?}");
        assert_eq!(t.list.len(), e.list.len(), "{geometry:?} {plain:?}");
        let primitive = Primitive::new(&geometry);
        let bounds = primitive.shape().bounds();
        for (a, b) in t.list.iter().zip(&e.list) {
            assert_eq!(a.face, b.face, "{geometry:?} {plain:?}");
            let here = primitive.intersect().locate(&plain, *a);
            assert!(here.point.is_finite() && here.normal.is_finite() && here.normal.any());
            // The surface is within the error, along the normal: the definition changes sign.
            let n = here.normal.unit();
            let reach = n.abs().dot(here.error);
            let at = |s: f64| {
                let p = here.point.cast::<Dd>() + n.cast::<Dd>() * Dd::of(s * reach);
                value(&geometry, p)
            };
            assert!(
                at(-2.0) <= Dd::ZERO && at(2.0) >= Dd::ZERO,
                "{geometry:?} {plain:?} {here:?}"
            );
            assert!(reach <= 1e-9 * away, "{geometry:?} {plain:?} {here:?}");
            for i in 0..3 {
                let (p, e) = (here.point[i], here.error[i]);
                assert!(bounds.min[i] - e <= p && p <= bounds.max[i] + e);
            }
            assert!(primitive.shape().uv(here.point, a.face)[0] <= 1.0);
        }
    }
    assert!(met.iter().all(|&m| m > 500), "{met:?}");
    // Random lines are rarely too close to call: fewer than one in 50.
    assert!(uncertain * 50 < rounds as u32, "{uncertain}");
}

#[test]
fn lines_through_special_points_alternate() {
    // All lines between the points of a lattice that holds apex, rims, axes and generators.
    let mut r = Random(9);
    let c = [-2.0, -1.0, 0.0, 0.5, 1.0];
    for round in 0..20_000 {
        let pick = |r: &mut Random| [0; 3].map(|_| c[r.below(5) as usize]);
        let (o, d) = (pick(&mut r), pick(&mut r));
        if d == [0.0; 3] {
            continue;
        }
        let geometry = match round % 8 {
            0 => Geometry::Ellipsoid {
                semi_axes: [1.0, 2.0, 0.5],
            },
            1 => Geometry::Quadric(Box::new(std::array::from_fn(|_| c[r.below(5) as usize]))),
            2 => Geometry::Cone {
                height: -1.0,
                radius: 1.0,
            },
            3 => Geometry::DoubleCone {
                height: 1.0,
                radius: 0.5,
            },
            4 => Geometry::ParabolicCylinder { a: 1.0 },
            5 => Geometry::HyperbolicCylinder { a: 1.0, b: 0.5 },
            6 => Geometry::Hyperboloid {
                a: 1.0,
                b: 1.0,
                c: 2.0,
                sheets: 1 + r.below(2) as u32,
            },
            _ => Geometry::HyperbolicParaboloid { a: 1.0, b: 1.0 },
        };
        let exact = crossings(&geometry, &line::<Dd>(o, d));
        let plain = crossings(&geometry, &line::<f64>(o, d));
        assert!(plain.list.windows(2).all(|w| w[0].t < w[1].t));
        check_sides(&geometry, &line(o, d), &exact);
        if !plain.uncertain {
            assert_eq!(
                plain.list.len(),
                exact.list.len(),
                "{geometry:?} {o:?} {d:?}"
            );
        }
    }
}

#[test]
fn near_the_axis_of_a_paraboloid() {
    // x² + z² − y: case 19. The near root is 10 − y where y = (0.5 + εt)².
    let mut q = [0.0; 16];
    (q[0], q[10], q[7]) = (1.0, 1.0, -1.0);
    let paraboloid = Geometry::Quadric(Box::new(q));
    for (epsilon, right) in [
        (1e-7, 9.749999025000048),
        (1e-8, 9.7499999025),
        (1e-9, 9.74999999025),
    ] {
        let (inside, t) = both(&paraboloid, [0.5, 10.0, 0.0], [epsilon, -1.0, 0.0]);
        assert!(!inside && t.len() == 2);
        assert!((t[1] - right).abs() < 1e-12, "{t:?}");
    }
    let (inside, t) = both(&paraboloid, [0.5, 10.0, 0.0], [0.0, -1.0, 0.0]);
    assert!(inside);
    assert_eq!(t, [9.75]);
}

#[test]
fn along_an_asymptote() {
    // x² − y² = 1 along (1, 1): case 20. (−5 + s)² − (−7 + s)² = 1 at s = 6.25, t = s√2.
    let cylinder = Geometry::HyperbolicCylinder { a: 1.0, b: 1.0 };
    for epsilon in [1e-12, 1e-15] {
        let d = Vec3::new(1.0, 1.0 + epsilon, 0.0).unit();
        let (_, t) = both(&cylinder, [-5.0, -7.0, 0.0], d.0);
        let near = t.iter().copied().find(|t| t.abs() < 100.0).unwrap();
        assert!((near - 8.838_834_76).abs() < 1e-8, "{t:?}");
    }
    let (inside, t) = both(&cylinder, [-5.0, -7.0, 0.0], [1.0, 1.0, 0.0]);
    assert_eq!((inside, t), (true, vec![6.25]));
}

#[test]
fn through_the_apex() {
    // x² + z² − y²: case 21.
    let mut q = [0.0; 16];
    (q[0], q[5], q[10]) = (1.0, -1.0, 1.0);
    let shapes = [
        Geometry::Quadric(Box::new(q)),
        Geometry::Cone {
            height: 10.0,
            radius: 10.0,
        },
        Geometry::DoubleCone {
            height: 10.0,
            radius: 10.0,
        },
    ];
    for shape in &shapes {
        assert_eq!(both(shape, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]).1, [0.0; 0]);
        assert_eq!(both(shape, [-5.0, -5.0, 0.0], [1.0, 1.0, 0.0]).1, [0.0; 0]);
    }
    // Steeper than the cone: inside both halves, one crossing at the apex of a single cone.
    let (o, d) = ([-1.0, -2.0, 0.0], [1.0, 2.0, 0.0]);
    assert_eq!(both(&shapes[0], o, d), (true, vec![]));
    assert_eq!(both(&shapes[1], o, d), (false, vec![1.0, 6.0]));
    assert_eq!(both(&shapes[2], o, d), (false, vec![-4.0, 6.0]));
    // Beside the apex: 4 crossings of the double cone. (1)² + … : |y| = 1 at t = 4 ± 1.
    let (_, t) = both(&shapes[2], [1.0, -4.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(t, [-6.0, 3.0, 5.0, 14.0]);
}

#[test]
fn degenerate_quadrics() {
    let diagonal = |x: f64, y: f64, z: f64, w: f64| {
        let mut q = [0.0; 16];
        (q[0], q[5], q[10], q[15]) = (x, y, z, w);
        Geometry::Quadric(Box::new(q))
    };
    let (o, d) = ([0.25, 0.5, -4.0], [0.0, 0.0, 2.0]);
    let at = |g: &Geometry| both(g, o, d);
    assert_eq!(at(&diagonal(0.0, 0.0, 0.0, 0.0)), (true, vec![]));
    assert_eq!(at(&diagonal(0.0, 0.0, 0.0, -1.0)), (true, vec![]));
    assert_eq!(at(&diagonal(0.0, 0.0, 0.0, 1.0)), (false, vec![]));
    assert_eq!(at(&diagonal(1.0, 1.0, 1.0, 1.0)), (false, vec![]));
    // A slab, its complement, a plane met in a touch, a cylinder from inside along its axis.
    assert_eq!(at(&diagonal(0.0, 0.0, 1.0, -4.0)), (false, vec![1.0, 3.0]));
    assert_eq!(at(&diagonal(0.0, 0.0, -1.0, 4.0)), (true, vec![1.0, 3.0]));
    assert_eq!(at(&diagonal(0.0, 0.0, 1.0, 0.0)), (false, vec![]));
    assert_eq!(at(&diagonal(1.0, 1.0, 0.0, -1.0)), (true, vec![]));
    // Two planes that meet, y² ≤ z²: wedges about the z axis.
    assert_eq!(at(&diagonal(0.0, 1.0, -1.0, 0.0)), (true, vec![1.75, 2.25]));
    // z − 1 ≤ 0, all of it below the diagonal: only the symmetric part counts.
    let mut q = [0.0; 16];
    (q[14], q[15], q[1], q[4]) = (1.0, -1.0, 3.0, -3.0);
    assert_eq!(at(&Geometry::Quadric(Box::new(q))), (true, vec![2.5]));
}

#[test]
fn scale_does_not_matter() {
    // Case 38: sizes 1e±6 and the same line scaled, in powers of two, so that every t is the same.
    let mut r = Random(21);
    for round in 0..2000 {
        let (geometry, _) = shape([0, 2, 3, 5, 6][round % 5], &mut r, 0.0);
        let k = 2f64.powi(r.below(40) as i32 - 20);
        let larger = match geometry.clone() {
            Geometry::Ellipsoid { semi_axes } => Geometry::Ellipsoid {
                semi_axes: semi_axes.map(|x| x * k),
            },
            Geometry::Cone { height, radius } => Geometry::Cone {
                height: height * k,
                radius: radius * k,
            },
            Geometry::DoubleCone { height, radius } => Geometry::DoubleCone {
                height: height * k,
                radius: radius * k,
            },
            Geometry::HyperbolicCylinder { a, b } => {
                Geometry::HyperbolicCylinder { a: a * k, b: b * k }
            }
            Geometry::Hyperboloid { a, b, c, sheets } => Geometry::Hyperboloid {
                a: a * k,
                b: b * k,
                c: c * k,
                sheets,
            },
            other => other,
        };
        let ray = r.ray(2.0);
        let (o, d) = (ray.line.origin, ray.line.direction);
        let t: Roots = crossings(&geometry, &Line::new(o, d));
        let u: Roots = crossings(&larger, &Line::new(o * k, d * k));
        if t.uncertain || u.uncertain {
            continue;
        }
        assert_eq!(t.list.len(), u.list.len());
        for (a, b) in t.list.iter().zip(&u.list) {
            assert!((a.t - b.t).abs() <= 1e-9 * (1.0 + a.t.abs()), "{a:?} {b:?}");
        }
    }
}

#[test]
fn no_line_is_too_extreme() {
    let mut r = Random(4);
    for round in 0..20_000 {
        let (geometry, _) = shape(round % 8, &mut r, 3.0);
        let extreme = |r: &mut Random| {
            Vec3([0; 3].map(|_| match r.below(6) {
                0 => 0.0,
                1 => r.within(-1.0, 1.0),
                2 => 1e308 * r.within(-1.0, 1.0),
                3 => 1e-320 * r.within(-1.0, 1.0),
                _ => r.within(-1.0, 1.0) * 10f64.powf(r.within(-300.0, 300.0)),
            }))
        };
        let (o, d) = (extreme(&mut r), extreme(&mut r));
        if !d.any() {
            continue;
        }
        let l: Line = Line::new(o, d);
        let roots = crossings(&geometry, &l);
        assert!(roots.list.iter().all(|x| x.t.is_finite()));
        assert!(roots.list.windows(2).all(|w| w[0].t < w[1].t));
        let exact = crossings(&geometry, &line::<Dd>(o.0, d.0));
        assert!(exact.list.iter().all(|x| x.t.is_finite()));
        let primitive = Primitive::new(&geometry);
        for root in roots.list {
            let here = primitive.intersect().locate(&l, root);
            assert!(
                here.normal.any() && here.normal.is_finite(),
                "{here:?} {l:?}"
            );
        }
    }
}

#[test]
fn apex_and_seams_have_normals_and_coordinates() {
    let cone = Primitive::new(&Geometry::Cone {
        height: -2.0,
        radius: 1.0,
    });
    let l = Line::new(Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, -1.0, 0.0));
    let mut roots = Roots::default();
    cone.intersect().crossings(&l, &mut roots);
    let t: Vec<f64> = roots.list.iter().map(|r| r.t).collect();
    assert_eq!(t, [3.0, 5.0]);
    let apex = cone.intersect().locate(&l, roots.list[0]);
    assert_eq!(apex.normal, Vec3::new(0.0, 2.0, 0.0));
    let base = cone.intersect().locate(&l, roots.list[1]);
    assert_eq!(base.normal, Vec3::new(0.0, -2.0, 0.0));
    // v = y/h on the side, ρ/r on the disc; u is a quarter at −z.
    let side = Vec3::new(0.0, -1.0, -0.5);
    assert_eq!(cone.shape().uv(side, 0), [0.25, 0.5]);
    assert_eq!(cone.shape().uv(Vec3::new(0.5, -2.0, 0.0), 1), [0.0, 0.5]);
}

/// Case 22: a paraboloid cut by a cylinder and two half-spaces, seen from every side.
#[test]
fn clipped_quadrics_in_a_scene() {
    let mut b = Builder::default();
    let mut q = [0.0; 16];
    (q[0], q[10], q[7], q[15]) = (1.0, 1.0, 1.0, -1.0);
    let bowl = b.shape(Geometry::Quadric(Box::new(q)));
    let mut q = [0.0; 16];
    (q[0], q[10], q[15]) = (1.0, 1.0, -1.0);
    let tube = b.shape(Geometry::Quadric(Box::new(q)));
    let slab = b.cuboid([-5.0, -1.0, -5.0], [5.0, 1.0, 5.0]);
    let tube = b.intersection(tube, slab);
    let root = b.intersection(bowl, tube);
    let tracer = b.tracer(root);
    let inside = |p: Vec3| {
        let square = p[0] * p[0] + p[2] * p[2];
        square + p[1] - 1.0 <= 0.0 && square <= 1.0 && p[1].abs() <= 1.0
    };
    let mut r = Random(6);
    let mut walker = tracer.walker();
    for _ in 0..5000 {
        let from = r.point(1.0).unit() * 10.0;
        let aim = r.point(0.5);
        let ray = Ray::new(from, aim - from);
        let all = tracer.crossings(&mut walker, &ray);
        assert!(all.is_empty() || all.len() == 2, "{ray:?}");
        if inside(aim) {
            assert!(all[0].hit.t < 1.0 && all[1].hit.t > 1.0, "{ray:?}");
            assert_eq!(all[0].entering, Some(true));
        }
        for c in &all {
            assert!(c.hit.normal.is_finite() && c.hit.normal.any());
        }
        if let [a, b] = &all[..] {
            assert!(inside(ray.line.at(0.5 * (a.hit.t + b.hit.t))), "{ray:?}");
        }
    }
}

/// An infinite solid without its clip holds the origin's side at infinity, turned and moved.
#[test]
fn an_unbounded_quadric_holds_what_it_should() {
    let mut b = Builder::default();
    let saddle = b.shape(Geometry::HyperbolicParaboloid { a: 1.0, b: 2.0 });
    let m = Matrix::translation(1.0, 2.0, 3.0).after(&Matrix::rotation(90.0, 1));
    let moved = b.moved(saddle, m);
    let clip = b.cuboid([-4.0; 3], [4.0; 3]);
    let root = b.intersection(moved, clip);
    let tracer = b.tracer(root);
    let mut r = Random(8);
    let mut walker = tracer.walker();
    for _ in 0..2000 {
        let p = r.point(6.0);
        // Turned by 90° about y: x' = z, z' = −x, so x = −z', z = x'.
        let (x, y, z) = (-(p[2] - 3.0), p[1] - 2.0, p[0] - 1.0);
        let right = p.abs().max_component() <= 4.0 && x * x - z * z / 4.0 - y <= 0.0;
        assert_eq!(tracer.holds(&mut walker, p), right, "{p:?}");
    }
}

/// Lines along the generators of a cylinder that has been turned and stretched by a map with an inexact
/// inverse: they cross nothing, and are inside or not by where they start.
#[test]
fn generators_of_turned_cylinders() {
    use zpg::internals::geometry::Matrix;
    use zpg::internals::geometry::affine::Affine;
    use zpg::internals::geometry::dd::Dd;
    let shape = Primitive::new(&Geometry::HyperbolicCylinder {
        a: 0.9630584716796875,
        b: 0.15234375,
    });
    let m = Matrix([
        [-3.0, 0.0, -4.0, 0.0],
        [0.0, 5.0, 0.0, 0.0],
        [4.0, 0.0, -3.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]);
    let back = Affine::<Dd>::new(&m).inverse().unwrap();
    // x²/a² − y²/b² at the start: 3.9 − 1156 is inside, 3.9 − 0 is not.
    for (y, inside) in [(-5.1697540283203125, true), (0.0, false)] {
        let start = m.point([1.899505615234375, y, -4.3822021484375]);
        let along = m.vector([0.0, 0.0, 4.059112548828125]);
        let line = Line::<Dd>::new(Vec3(start).cast(), Vec3(along).cast()).through(&back);
        let mut roots = Roots::<Dd>::default();
        shape.intersect().crossings(&line, &mut roots);
        assert_eq!((roots.inside, roots.list.len()), (inside, 0), "{y}");
    }
}
