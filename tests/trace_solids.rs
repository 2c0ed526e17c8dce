//! Sets along rays: what the tracer says about crossings against point-by-point evaluation.

use crate::trace_support;
use trace_support::*;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::*;
use zpg::internals::trace::{Ray, Tracer};

/// Whether a point is in a node, from the definition of each shape and operation.
fn inside(scene: &Scene, node: NodeId, p: [f64; 3]) -> bool {
    match scene.nodes[node as usize] {
        Node::Shape(s) => match scene.shapes[s as usize].geometry {
            Geometry::Sphere { centre: c, radius } => {
                (0..3).map(|i| (p[i] - c[i]).powi(2)).sum::<f64>() <= radius * radius
            }
            Geometry::Box { min, max } => (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i]),
            Geometry::HalfSpace([a, b, c, d]) => a * p[0] + b * p[1] + c * p[2] + d <= 0.0,
            Geometry::Torus { major, minor } => (p[0].hypot(p[2]) - major).hypot(p[1]) <= minor,
            Geometry::Ellipsoid { semi_axes: a } => {
                (0..3).map(|i| (p[i] / a[i]).powi(2)).sum::<f64>() <= 1.0
            }
            Geometry::Cone { height, radius } => {
                let share = p[1] / height;
                (0.0..=1.0).contains(&share) && p[0].hypot(p[2]) <= share * radius
            }
            Geometry::Hyperboloid { a, b, c, sheets } => {
                let side = if sheets == 1 { -1.0 } else { 1.0 };
                (p[0] / a).powi(2) - (p[1] / b).powi(2) + (p[2] / c).powi(2) + side <= 0.0
            }
            Geometry::HyperbolicParaboloid { a, b } => {
                (p[0] / a).powi(2) - (p[2] / b).powi(2) - p[1] <= 0.0
            }
            Geometry::Revolution { ref profile, .. } => in_profile(profile, p[0].hypot(p[2]), p[1]),
            _ => panic!("no definition of this shape"),
        },
        Node::Union(a, b) => inside(scene, a, p) || inside(scene, b, p),
        Node::Intersection(a, b) => inside(scene, a, p) && inside(scene, b, p),
        Node::Difference(a, b) => inside(scene, a, p) && !inside(scene, b, p),
        Node::Complement(a) => !inside(scene, a, p),
        Node::Transform { child, matrix } => {
            let back = scene.matrices[matrix as usize].inverse().unwrap();
            inside(scene, child, back.point(p))
        }
        Node::Paint { child, .. } | Node::Copy { child, .. } => inside(scene, child, p),
    }
}

/// The even-odd rule: whether a ray outwards from (x, y) meets the profile an odd number of times.
/// The discs and the axis that close it are level or behind: such a ray never meets them.
fn in_profile(profile: &[[f64; 2]], x: f64, y: f64) -> bool {
    let crosses = |pair: &&[[f64; 2]]| {
        let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
        (y0 > y) != (y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)
    };
    profile.windows(2).filter(crosses).count() % 2 == 1
}

fn random_matrix(r: &mut Random) -> Matrix {
    let turn = Matrix::rotation(r.within(-180.0, 180.0), r.below(3) as usize);
    let scale = Matrix::scaling(r.within(0.5, 2.0), -r.within(0.5, 2.0), r.within(0.5, 2.0));
    let p = r.point(1.0);
    Matrix::translation(p[0], p[1], p[2]).after(&turn.after(&scale))
}

fn random_shape(b: &mut Builder, r: &mut Random) -> NodeId {
    let p = r.point(2.0);
    let s = r.point(1.0).map(|x| x.abs() + 0.2);
    match r.below(11) {
        5 => b.shape(Geometry::Torus {
            major: 1.0 + s[0],
            minor: 0.5 * s[1],
        }),
        6 => b.shape(Geometry::Ellipsoid { semi_axes: s.0 }),
        7 => b.shape(Geometry::Cone {
            height: p[0],
            radius: s[0],
        }),
        8 => b.shape(Geometry::Hyperboloid {
            a: s[0],
            b: s[1],
            c: s[2],
            sheets: 1 + r.below(2) as u32,
        }),
        9 => b.shape(Geometry::HyperbolicParaboloid { a: s[0], b: s[1] }),
        10 => {
            let point = |r: &mut Random| [r.within(0.0, 2.0), r.within(-2.0, 2.0)];
            let profile = (0..2 + r.below(6)).map(|_| point(r)).collect();
            b.shape(Geometry::Revolution {
                profile,
                colours: Vec::new(),
            })
        }
        0 | 1 => b.sphere([p[0], p[1], p[2]], r.within(0.2, 1.5)),
        2 | 3 => {
            let q = r.point(1.0).abs();
            b.cuboid(p.0, (p + q).0)
        }
        _ => b.half_space([p[0], p[1], p[2], r.within(-1.0, 1.0)]),
    }
}

/// A random tree over `n` shapes; nodes may be used more than once.
fn random_tree(b: &mut Builder, r: &mut Random, n: usize) -> NodeId {
    let mut pool: Vec<NodeId> = (0..n).map(|_| random_shape(b, r)).collect();
    for _ in 0..n {
        let pick = |r: &mut Random, pool: &[NodeId]| pool[r.below(pool.len() as u64) as usize];
        let (x, y) = (pick(r, &pool), pick(r, &pool));
        let node = match r.below(6) {
            0 | 1 => b.union(x, y),
            2 => b.intersection(x, y),
            3 => b.difference(x, y),
            4 => b.complement(x),
            _ => {
                let m = random_matrix(r);
                b.moved(x, m)
            }
        };
        pool.push(node);
    }
    pool.into_iter()
        .skip(n)
        .reduce(|a, c| b.union(a, c))
        .unwrap()
}

/// Where a ray changes sides, and which way.
fn crossings(tracer: &Tracer, ray: &Ray) -> Vec<(f64, bool)> {
    let all = tracer.crossings(&mut tracer.walker(), ray);
    let sides = all.iter().filter_map(|c| Some((c.hit.t, c.entering?)));
    sides.collect()
}

#[test]
fn random_trees_agree_with_their_definition() {
    let mut r = Random(11);
    let mut checked = 0;
    for round in 0..300 {
        let mut b = Builder::default();
        let root = random_tree(&mut b, &mut r, 2 + round % 9);
        let tracer = b.tracer_of(root);
        for _ in 0..100 {
            let ray = r.ray(4.0);
            let found = crossings(&tracer, &ray);
            checked += found.len();
            let mut now = tracer.holds(&mut tracer.walker(), ray.line.origin);
            assert_eq!(now, inside(&b.scene, root, ray.line.origin.0));
            let mut last = 0.0;
            for &(t, entering) in &found {
                assert!(t > last && entering != now, "{found:?}");
                let middle = ray.line.at(0.5 * (last + t));
                if t - last > 1e-9 {
                    assert_eq!(inside(&b.scene, root, middle.0), now, "{found:?}");
                }
                (last, now) = (t, entering);
            }
            let beyond = ray.line.at(last + 1.0);
            assert_eq!(inside(&b.scene, root, beyond.0), now);
        }
    }
    assert!(checked > 5000, "{checked}");
}

#[test]
fn first_hits_are_first_crossings() {
    let mut r = Random(5);
    for _ in 0..200 {
        let mut b = Builder::default();
        let root = random_tree(&mut b, &mut r, 5);
        let tracer = b.tracer_of(root);
        let mut walker = tracer.walker();
        for _ in 0..50 {
            let mut ray = r.ray(5.0);
            let all = tracer.crossings(&mut walker, &ray);
            if !tracer.holds(&mut walker, ray.line.origin) {
                ray.is_outside = true;
            }
            let hit = tracer.hit(&mut walker, &ray);
            assert_eq!(hit.map(|h| h.t), all.first().map(|c| c.hit.t));
        }
    }
}

#[test]
fn set_identities() {
    let mut r = Random(77);
    for _ in 0..200 {
        let mut b = Builder::default();
        let x = random_tree(&mut b, &mut r, 4);
        let y = random_tree(&mut b, &mut r, 4);
        let nothing = b.difference(x, x);
        let both = b.intersection(x, x);
        let either = b.union(x, x);
        let not_x = b.complement(x);
        let twice = b.complement(not_x);
        let not_y = b.complement(y);
        let united = b.union(not_x, not_y);
        let morgan = b.complement(united);
        let plain = b.intersection(x, y);
        let swapped = b.intersection(y, x);
        let less = b.difference(x, y);
        let less_morgan = b.intersection(x, not_y);
        let everything = b.union(x, not_x);
        let trace = |node| b.tracer_of(node);
        let same = [
            (trace(both), trace(x)),
            (trace(either), trace(x)),
            (trace(twice), trace(x)),
            (trace(morgan), trace(plain)),
            (trace(swapped), trace(plain)),
            (trace(less_morgan), trace(less)),
        ];
        let (nothing, everything) = (trace(nothing), trace(everything));
        for _ in 0..50 {
            let ray = r.ray(4.0);
            assert_eq!(crossings(&nothing, &ray), []);
            assert!(!nothing.holds(&mut nothing.walker(), ray.line.origin));
            assert_eq!(crossings(&everything, &ray), []);
            assert!(everything.holds(&mut everything.walker(), ray.line.origin));
            for (a, b) in &same {
                assert_eq!(crossings(a, &ray), crossings(b, &ray));
            }
        }
    }
}

#[test]
fn a_box_less_one_with_a_common_face_is_open() {
    let mut b = Builder::default();
    let outer = b.cuboid([-1.0; 3], [1.0; 3]);
    let inner = b.cuboid([-0.5, -0.5, -0.5], [0.5, 0.5, 1.0]);
    let root = b.difference(outer, inner);
    let tracer = b.tracer(root);
    let down = Ray::new(Vec3::new(0.1, 0.2, 5.0), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(crossings(&tracer, &down), [(5.5, true), (6.0, false)]);
}

/// A face that two operands of an intersection have in one place is the first one's, however the
/// places of the two are rounded.
#[test]
fn common_faces_of_an_intersection_are_the_first_operands() {
    let text = "2 9 1.14\n2 -1 1.86 1.4 0.88\n5 12 3 -3 -3 4 4 4\n6 -103 2 5\n6 -701 1 0 0\n\
        4 -102 2 6\n4 -3 1.15 1.15 1.15\n7 11 9 9 9 1\n8 -101 6 7\n8 -1 20 0 0\n9 -101 4 8\n\
        1 9999 9 0\n";
    let loaded = zpg::internals::analysis::Analysis::new("scene", text.as_bytes().to_vec());
    let tracer = Tracer::new(&loaded.scene).unwrap();
    let mut walkers: zpg::internals::trace::Walkers<f64> = tracer.walker();
    let mut r = Random(5);
    let mut seen = 0;
    for _ in 0..300 {
        let origin = [r.within(-3.0, 6.0), r.within(-3.0, 6.0), 9.0];
        let to = [r.within(1.3, 2.9), r.within(0.8, 2.4), 1.0];
        let direction: [f64; 3] = std::array::from_fn(|i| to[i] - origin[i]);
        let ray = Ray::new(origin.into(), direction.into());
        for crossing in tracer.probe(&mut walkers, &ray).crossings {
            // The other union's parts are twenty units away.
            if crossing.hit.point.0[0] < 9.0 && crossing.shape == 2 {
                assert_eq!(crossing.object, 2, "{ray:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 300);
}

#[test]
fn surfaces_are_cut_and_never_cut() {
    let mut b = Builder::default();
    let plane = b.shape(Geometry::Plane([0.0, 0.0, 1.0, 0.0]));
    let ball = b.sphere([0.0, 0.0, 0.0], 1.0);
    let disc = b.intersection(plane, ball);
    let holed = b.difference(plane, ball);
    let whole = b.difference(ball, plane);
    let count = |node, x: f64| {
        let tracer = b.tracer_of(node);
        let ray = Ray::new(Vec3::new(x, 0.0, 5.0), Vec3::new(0.0, 0.0, -1.0));
        let all = tracer.crossings(&mut tracer.walker(), &ray);
        all.iter()
            .map(|c| (c.hit.t, c.entering))
            .collect::<Vec<_>>()
    };
    assert_eq!(count(disc, 0.25), [(5.0, None)]);
    assert_eq!(count(disc, 1.25), []);
    assert_eq!(count(holed, 0.25), []);
    assert_eq!(count(holed, 1.25), [(5.0, None)]);
    assert_eq!(count(whole, 0.0), [(4.0, Some(true)), (6.0, Some(false))]);
}

#[test]
fn sixty_doublings_are_one_sphere() {
    let mut b = Builder::default();
    let mut a = b.sphere([0.0, 0.0, 0.0], 1.0);
    for _ in 0..60 {
        a = b.union(a, a);
    }
    let tracer = b.tracer(a);
    assert_eq!(tracer.graph.parts.len(), 1);
    let ray = Ray::new(Vec3::new(0.0, 0.0, 3.0), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(crossings(&tracer, &ray), [(2.0, true), (4.0, false)]);
}

#[test]
fn a_billion_spheres_from_thirty_moved_copies() {
    let mut b = Builder::default();
    let mut a = b.sphere([0.0, 0.0, 0.0], 0.4);
    for i in 0..30 {
        let step = f64::from(1 << (i / 3));
        let m = match i % 3 {
            0 => Matrix::translation(step, 0.0, 0.0),
            1 => Matrix::translation(0.0, step, 0.0),
            _ => Matrix::translation(0.0, 0.0, step),
        };
        let copy = b.moved(a, m);
        a = b.union(a, copy);
    }
    let tracer = b.tracer(a);
    assert!(tracer.graph.parts.len() <= 61);
    let mut r = Random(3);
    let mut walker = tracer.walker();
    for _ in 0..2000 {
        // Spheres stand on all whole numbers from 0 to 1023.
        let cell = Vec3([0; 3].map(|_| r.below(1024) as f64));
        let height = r.within(0.45, 0.55);
        let origin = cell + Vec3::new(r.within(-0.2, 0.2), r.within(-0.2, 0.2), height);
        let mut ray = Ray::new(origin, Vec3::new(0.0, 0.0, -1.0));
        ray.is_outside = true;
        let hit = tracer.hit(&mut walker, &ray).expect("a sphere below");
        let d = origin - cell;
        let t = d[2] - (0.16 - d[0] * d[0] - d[1] * d[1]).sqrt();
        assert!((hit.t - t).abs() < 1e-12);
    }
}

/// Chains as long as files can make them: nothing may recurse on them.
#[test]
fn long_chains() {
    const N: usize = 60_000;
    let settings = small(16, 12);
    let chain = |b: &mut Builder, operation: fn(&mut Builder, NodeId, NodeId) -> NodeId| {
        let mut r = Random(9);
        let mut a = b.sphere([0.0, 0.0, 0.0], 10.0);
        for _ in 0..N {
            let p = r.point(1.0).unit() * 10.0;
            let s = b.sphere([p[0], p[1], p[2]], 0.2);
            a = operation(b, a, s);
        }
        a
    };
    let operations: [fn(&mut Builder, NodeId, NodeId) -> NodeId; 3] =
        [Builder::union, Builder::difference, |b, a, _| {
            b.complement(a)
        }];
    for operation in operations {
        let mut b = Builder::default();
        let a = chain(&mut b, operation);
        b.camera([0.0, 0.0, 40.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 45.0);
        let film = picture(&b.render(a, [0.0; 3]), &settings).film;
        assert!(film.pixel(8, 6)[0] > 0.1);
        assert_eq!(film.pixel(0, 0), [0.0; 3]);
    }
    // Both kinds in turn cannot be flattened: as deep as it gets.
    let mut b = Builder::default();
    let mut a = b.sphere([0.0, 0.0, 0.0], 10.0);
    for i in 0..20_000 {
        let s = b.sphere([20.0, f64::from(i), 0.0], 0.2);
        let t = b.sphere([0.0, 0.0, 10.0], 0.1 + f64::from(i) * 1e-5);
        a = b.difference(a, t);
        a = b.union(a, s);
    }
    let tracer = b.tracer(a);
    let ray = Ray::new(Vec3::new(1.0, 0.0, 30.0), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(crossings(&tracer, &ray).len(), 2);
}
