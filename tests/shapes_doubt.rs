//! Quadrics, cones and solids of revolution against hard lines: what doubles call certain, numbers
//! of twice their length must confirm, and few lines may be called uncertain.

use crate::trace_support;
use trace_support::Random;
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::affine::Affine;
use zpg::internals::geometry::affine::Slack;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::line::{Line, Traced};
use zpg::internals::geometry::number::Real;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Geometry;
use zpg::internals::trace::shapes::{Primitive, Root, Roots};

/// Hard lines a kind of shape and a test; as many as the variable says for a longer look.
fn lines() -> usize {
    let asked = std::env::var("ZPG_HARD_LINES").ok();
    asked.and_then(|n| n.parse().ok()).unwrap_or(10_000)
}

/// A shape, about how large it is, the points where its surface is not smooth, and the directions
/// in which it reaches for infinity or that lie in it.
struct Sample {
    geometry: Geometry,
    primitive: Primitive,
    size: f64,
    corners: Vec<Vec3>,
    along: Vec<Vec3>,
}

const KINDS: [&str; 10] = [
    "ellipsoid",
    "quadric",
    "cone",
    "double cone",
    "parabolic cylinder",
    "hyperbolic cylinder",
    "hyperboloid of one sheet",
    "hyperboloid of two sheets",
    "hyperbolic paraboloid",
    "revolution",
];

/// A direction in which the second degree of a general quadric vanishes, where the line of two
/// random ones has it.
fn asymptote(q: &[f64; 16], r: &mut Random) -> Option<Vec3> {
    let (u, v) = (r.point(1.0), r.point(1.0));
    let form = |x: Vec3, y: Vec3| {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                sum += q[4 * i + j] * (x[i] * y[j] + x[j] * y[i]) / 2.0;
            }
        }
        sum
    };
    let (a, b, c) = (form(v, v), form(u, v), form(u, u));
    let root = (b * b - a * c).sqrt();
    root.is_finite().then(|| u + v * ((root - b) / a))
}

fn profile(r: &mut Random, size: f64) -> Vec<[f64; 2]> {
    let n = 2 + r.below(6) as usize;
    let grid = r.below(2) == 0;
    let mut points: Vec<[f64; 2]> = (0..n)
        .map(|_| match grid {
            true => [r.below(4) as f64 / 2.0, r.below(5) as f64 / 2.0 - 1.0],
            false => [r.within(0.0, 1.5), r.within(-1.0, 1.0)],
        })
        .collect();
    if r.below(3) == 0 {
        points.push(points[0]);
    }
    points.iter().map(|p| p.map(|x| x * size)).collect()
}

/// A shape of a kind with semi-axes that differ by up to a hundred, of a size within 1e±6.
fn sample(kind: usize, r: &mut Random) -> Sample {
    let base = r.within(-6.0, 6.0);
    let mut axis = || 10f64.powf((base + r.within(-1.0, 1.0)).clamp(-6.0, 6.0));
    let (a, b, c) = (axis(), axis(), axis());
    let size = 10f64.powf(base);
    let angle = r.within(0.0, std::f64::consts::TAU);
    let (sin, cos) = angle.sin_cos();
    let (mut corners, mut along) = (vec![], vec![]);
    let geometry = match kind {
        0 => Geometry::Ellipsoid {
            semi_axes: [a, b, c],
        },
        1 => {
            let q = std::array::from_fn(|i| {
                let scale =
                    [1.0, size, size * size][usize::from(i % 4 == 3) + usize::from(i / 4 == 3)];
                r.within(-1.0, 1.0) * scale
            });
            along.extend(asymptote(&q, r));
            Geometry::Quadric(Box::new(q))
        }
        2 | 3 => {
            let (height, radius) = (if kind == 2 { -a } else { a }, b);
            corners.push(Vec3::ZERO);
            corners.push(Vec3::new(radius * cos, height, radius * sin));
            along.push(corners[1]);
            if kind == 2 {
                Geometry::Cone { height, radius }
            } else {
                corners.push(-corners[1]);
                Geometry::DoubleCone { height, radius }
            }
        }
        4 => {
            along.push(Vec3::new(0.0, 1.0, r.within(-1.0, 1.0)));
            // y = size where x = size.
            Geometry::ParabolicCylinder { a: size.sqrt() }
        }
        5 => {
            along.push(Vec3::new(a, b, 0.0));
            along.push(Vec3::new(a, -b, r.within(-a, a)));
            Geometry::HyperbolicCylinder { a, b }
        }
        6 | 7 => {
            along.push(Vec3::new(a * cos, b, c * sin));
            corners.push(Vec3::new(a * cos, 0.0, c * sin));
            let sheets = kind as u32 - 5;
            Geometry::Hyperboloid { a, b, c, sheets }
        }
        8 => {
            let (a, b) = ((size * a / size).sqrt(), (size * b / size).sqrt());
            along.push(Vec3::new(a, r.within(-1.0, 1.0) * a, b));
            along.push(Vec3::new(0.0, 1.0, 0.0));
            corners.push(Vec3::ZERO);
            Geometry::HyperbolicParaboloid { a, b }
        }
        _ => {
            let profile = profile(r, size);
            let at = |[x, y]: [f64; 2]| Vec3::new(x * cos, y, x * sin);
            corners.extend(profile.iter().copied().map(at));
            corners.push(Vec3::new(profile[0][0], profile[0][1], 0.0));
            for w in profile.windows(2) {
                along.push(at(w[1]) - at(w[0]));
                // As it is where the coordinates are exact.
                along.push(Vec3::new(w[1][0] - w[0][0], w[1][1] - w[0][1], 0.0));
            }
            along.push(Vec3::new(0.0, 1.0, 0.0));
            Geometry::Revolution {
                profile,
                colours: vec![],
            }
        }
    };
    along.retain(|d| d.any() && d.is_finite());
    Sample {
        primitive: Primitive::new(&geometry),
        geometry,
        size,
        corners,
        along,
    }
}

fn crossings<R: Traced>(shape: &Primitive, line: &Line<R>) -> Roots<R> {
    let mut roots = Roots::default();
    shape.intersect().crossings(line, &mut roots);
    assert!(roots.list.iter().all(|root| root.t.is_finite()));
    assert!(roots.list.windows(2).all(|w| w[0].t < w[1].t), "{roots:?}");
    roots
}

fn cast<R: Traced>(line: &Line) -> Line<R> {
    Line::new(line.origin.cast(), line.direction.cast())
}

/// An axis of coordinates, either way.
fn any_axis(r: &mut Random) -> Vec3 {
    let mut d = Vec3::ZERO;
    d[r.below(3) as usize] = if r.below(2) == 0 { 1.0 } else { -1.0 };
    d
}

/// A point of the surface and the normal there, found along a random line.
fn on_surface(s: &Sample, r: &mut Random) -> Option<(Vec3, Vec3)> {
    let (from, to) = (r.point(3.0 * s.size), r.point(s.size));
    let line = Line::new(from, to - from);
    let roots = crossings::<f64>(&s.primitive, &line);
    let n = roots.list.len() as u64;
    let root = *roots.list.get(r.below(n.max(1)) as usize)?;
    let at = s.primitive.intersect().locate(&line, root);
    Some((at.point, at.normal.unit()))
}

/// A line that is hard for the shape: through or close past a corner, touching the surface or
/// nearly so, along an asymptote or generator or nearly so, along an axis.
fn hard_line(s: &Sample, r: &mut Random) -> Line {
    // From exactly through the decimal exponents of rounding errors to plainly beside.
    let mut off = |scale: f64| match r.below(3) {
        0 => 0.0,
        1 => scale * 10f64.powf(r.within(-18.0, -13.0)) * r.within(-1.0, 1.0).signum(),
        _ => scale * 10f64.powf(r.within(-13.0, -1.0)) * r.within(-1.0, 1.0).signum(),
    };
    let (aside, turn) = (off(s.size), off(1.0));
    let surface = on_surface(s, r);
    let touching = |n: Vec3, r: &mut Random| n.cross(r.point(1.0)).unit();
    let pick = |list: &[Vec3], r: &mut Random| {
        let n = list.len() as u64;
        (n > 0).then(|| list[r.below(n.max(1)) as usize])
    };
    let (corner, along) = (pick(&s.corners, r), pick(&s.along, r));
    let random = r.point(1.0).unit();
    let (target, direction) = match (r.below(8), surface, corner, along) {
        (0 | 1, Some((p, n)), ..) => (p + n * aside, touching(n, r)),
        // Touching, along an axis: where the normal can be made perpendicular to it.
        (2, Some((p, n)), ..) => {
            let d = any_axis(r);
            let flat = n - d * n.dot(d);
            (p + flat * aside, d)
        }
        (3, _, Some(p), _) => (p + random * aside, r.point(1.0).unit()),
        (4, Some((p, _)), Some(q), _) => (q + random * aside, p - q),
        (5, _, Some(p), Some(d)) => (p + random * aside, d),
        (6, Some((p, _)), _, Some(d)) => (p + random * aside, d.unit() + random * turn),
        (7, _, Some(p), _) => (p + random * aside, any_axis(r)),
        _ => {
            let d = along.unwrap_or(random);
            (r.point(s.size), d.unit() + r.point(1.0) * turn)
        }
    };
    let direction = if direction.any() { direction } else { random };
    let away = match r.below(3) {
        0 => 0.0,
        1 => 4.0,
        _ => 10f64.powf(r.within(0.0, 8.0)),
    };
    let origin = target - direction.unit() * (s.size * away);
    let length = 10f64.powf(r.within(-6.0, 6.0));
    let direction = match r.below(2) {
        0 => direction * length,
        _ => direction.unit() * length,
    };
    Line::new(origin, direction)
}

/// Doubles against double-doubles: inside, the number of crossings, their faces.
fn agree(s: &Sample, plain: &Roots, fine: &Roots<Dd>, line: &Line) {
    let geometry = &s.geometry;
    let say = || format!("{geometry:?}\n{line:?}\n{plain:?}\n{fine:?}");
    assert_eq!(plain.inside, fine.inside, "{}", say());
    assert_eq!(plain.list.len(), fine.list.len(), "{}", say());
    for (a, b) in plain.list.iter().zip(&fine.list) {
        assert_eq!(a.face, b.face, "{}", say());
    }
}

/// A bound on how far a crossing is from the surface, for the point o + t·d as it is, in units of
/// max(|origin|, size, |point|): the lesser of the ways to the true crossing and to the point that
/// it is located at, in numbers of twice the length.
fn distance(s: &Sample, line: &Line, root: &Root, fine: &Root<Dd>) -> f64 {
    let exact = cast::<Dd>(line);
    let t = Dd::of(root.t);
    let face = root.face;
    let near = s.primitive.intersect().locate(&exact, Root { t, face });
    let off = near.point - exact.at(t);
    // A quadric's point is moved in the units of its axes, which may be far from the shortest way:
    // that is along the normal.
    let off = match s.geometry {
        Geometry::Revolution { .. } => off.length(),
        _ => off.dot(near.normal.unit()).abs(),
    };
    let along = (fine.t - t).abs() * exact.direction.length();
    let point = near.point.length().to_f64();
    off.min(along).to_f64() / line.origin.length().max(s.size).max(point)
}

/// 2⁻¹⁰⁰: four times the bound on the error of a double-double operation.
const FINE_EPSILON: f64 = f64::EPSILON * f64::EPSILON * 16.0;

/// The same for a crossing in double-doubles, in the same numbers: the rounding of the measurement
/// adds some of the crossing's own kind.
fn own_distance(s: &Sample, line: &Line, root: &Root<Dd>) -> f64 {
    let exact = cast::<Dd>(line);
    let near = s.primitive.intersect().locate(&exact, *root);
    let off = near.point - exact.at(root.t);
    let off = match s.geometry {
        Geometry::Revolution { .. } => off.length(),
        _ => off.dot(near.normal.unit()).abs(),
    };
    let point = near.point.length().to_f64();
    off.to_f64() / line.origin.length().max(s.size).max(point)
}

#[test]
fn what_is_certain_is_so() {
    for (kind, name) in KINDS.iter().enumerate() {
        let mut r = Random(100 + kind as u64 * 1_000_003);
        let (mut certain, mut worst, mut finest) = (0, 0.0f64, 0.0f64);
        let mut s = sample(kind, &mut r);
        for i in 0..lines() {
            if i % 8 == 0 {
                s = sample(kind, &mut r);
            }
            let line = hard_line(&s, &mut r);
            let plain = crossings::<f64>(&s.primitive, &line);
            let fine = crossings::<Dd>(&s.primitive, &cast(&line));
            crossings::<f32>(&s.primitive, &cast(&line));
            if plain.uncertain {
                continue;
            }
            certain += 1;
            agree(&s, &plain, &fine, &line);
            for (root, true_root) in plain.list.iter().zip(&fine.list) {
                worst = worst.max(distance(&s, &line, root, true_root) / f64::EPSILON);
            }
            for root in &fine.list {
                finest = finest.max(own_distance(&s, &line, root) / FINE_EPSILON);
            }
        }
        println!("{name}: {certain} certain, {worst:.1} and {finest:.1} eps off");
        assert!(certain > lines() / 4, "{name}: {certain}");
        assert!(worst <= 64.0 && finest <= 64.0, "{name}: {worst} {finest}");
    }
}

fn placement(r: &mut Random, size: f64) -> Matrix {
    let turn = |r: &mut Random, axis| Matrix::rotation(r.within(-180.0, 180.0), axis);
    let k = 10f64.powf(r.within(-3.0, 3.0));
    let [x, y, z] = (r.point(1.0) * (k * size * 10f64.powf(r.within(0.0, 4.0)))).0;
    let turned = turn(r, 0).after(&turn(r, 1)).after(&turn(r, 2));
    let scale = Matrix::scaling(k, k * r.within(0.5, 2.0), k);
    let placed = turned.after(&scale);
    Matrix::translation(x, y, z).after(&placed)
}

#[test]
fn what_is_certain_is_so_for_placed_shapes() {
    for (kind, name) in KINDS.iter().enumerate() {
        let mut r = Random(7 + kind as u64 * 1_000_003);
        let mut certain = 0;
        let mut s = sample(kind, &mut r);
        for i in 0..lines() {
            if i % 8 == 0 {
                s = sample(kind, &mut r);
            }
            let line = hard_line(&s, &mut r);
            let out = placement(&mut r, s.size);
            let back = out.inverse().unwrap();
            let world = Affine::<f64>::new(&out);
            let line = Line::new(world.point(line.origin), world.vector(line.direction));
            let moved = line.through(&Affine::new(&back));
            let plain = crossings::<f64>(&s.primitive, &moved);
            let exact = cast::<Dd>(&line).through(&Affine::new(&back));
            let fine = crossings::<Dd>(&s.primitive, &exact);
            if !plain.uncertain {
                certain += 1;
                agree(&s, &plain, &fine, &moved);
            }
        }
        println!("{name}: {certain} certain");
        assert!(certain > lines() / 4, "{name}: {certain}");
    }
}

/// Lines that come close to the shape from four sizes away, as they come and by way of a placement.
#[test]
fn ordinary_lines_are_certain() {
    for (kind, name) in KINDS.iter().enumerate() {
        let mut r = Random(31 + kind as u64 * 1_000_003);
        let (mut doubtful, mut placed) = (0, 0);
        let lines = 5 * lines();
        let mut s = sample(kind, &mut r);
        let mut map = (Matrix::IDENTITY, Matrix::IDENTITY);
        for i in 0..lines {
            if i % 64 == 0 {
                s = sample(kind, &mut r);
                // A layer there and back again, whose crossings coincide, is never certain.
                while matches!(&s.geometry, Geometry::Revolution { profile, .. } if doubled(profile))
                {
                    s = sample(kind, &mut r);
                }
                let out = placement(&mut r, s.size);
                map = (out, out.inverse().unwrap());
            }
            let target = r.point(1.2 * s.size);
            let origin = target + r.point(1.0).unit() * (4.0 * s.size);
            let line = Line::new(origin, target - origin);
            doubtful += usize::from(crossings::<f64>(&s.primitive, &line).uncertain);
            let out = Affine::<f64>::new(&map.0);
            let line = Line::new(out.point(line.origin), out.vector(line.direction));
            let line = line.through(&Affine::new(&map.1));
            placed += usize::from(crossings::<f64>(&s.primitive, &line).uncertain);
        }
        println!("{name}: {doubtful} and, placed, {placed} of {lines} doubtful");
        assert!(doubtful == 0 && placed <= 1, "{name}: {doubtful}, {placed}");
    }
}

/// Whether the profile may lie on itself: two segments that are not neighbours meet the same point
/// or line on the coarse grid, or there are but two points.
fn doubled(profile: &[[f64; 2]]) -> bool {
    let grid = |p: &[f64; 2]| {
        let size = profile.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        p.iter().all(|x| (x / size * 12.0).fract().abs() < 1e-9)
    };
    profile.len() <= 3 || profile.iter().all(grid)
}

fn doubt(shape: &Primitive, line: &Line) -> (bool, usize) {
    let roots = crossings::<f64>(shape, line);
    (roots.uncertain, roots.list.len())
}

/// A line that is off by this, everywhere and whichever way.
fn stray(line: Line, origin: f64) -> Line {
    let slack = Slack {
        origin,
        direction: 0.0,
    };
    let mut line = line;
    line.slack = slack;
    line
}

/// The bounds at their edge: within some units in the last place of where the answer changes there
/// is doubt, some dozens away there is none; and likewise for lines that stray.
#[test]
fn doubt_begins_where_rounding_reaches() {
    let sphere = Geometry::Ellipsoid {
        semi_axes: [1.0; 3],
    };
    let cone = Geometry::Cone {
        height: 1.0,
        radius: 1.0,
    };
    let lathe = Geometry::Revolution {
        profile: vec![[0.0, 2.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]],
        colours: vec![],
    };
    let upwards = Vec3::new(0.0, 1.0, 0.0);
    let level = Vec3::new(0.0, 0.0, 1.0);
    // At x = 1 the sphere's side, at y = 1 the cone's disc, at x = 1 the lathe's wall.
    type Place = fn(f64) -> Vec3;
    let cases: [(Geometry, Place, Vec3); 3] = [
        (sphere, |x| Vec3::new(x, 0.0, -5.0), level),
        (cone, |y| Vec3::new(0.0, y, -5.0), level),
        (lathe, |x| Vec3::new(x, -5.0, 0.0), upwards),
    ];
    for (geometry, at, direction) in cases {
        let shape = Primitive::new(&geometry);
        let line = |off: f64| Line::new(at(1.0 + off), direction);
        for k in [-2.0, 2.0] {
            let close = line(k * f64::EPSILON);
            assert!(doubt(&shape, &close).0, "{geometry:?} {k}");
        }
        assert_eq!(doubt(&shape, &line(-100.0 * f64::EPSILON)), (false, 2));
        assert_eq!(doubt(&shape, &line(100.0 * f64::EPSILON)), (false, 0));
        for (off, found) in [(-1e-9, 2), (1e-9, 0)] {
            assert_eq!(doubt(&shape, &line(off)), (false, found), "{geometry:?}");
            let near = stray(line(off), 2e-9);
            assert!(doubt(&shape, &near).0, "{geometry:?}");
            let far = stray(line(off), 1e-10);
            assert_eq!(doubt(&shape, &far), (false, found), "{geometry:?}");
        }
    }
}

/// Rays along the axes that hit plainly are certain, also where a coefficient is zero, and so is
/// the exact way through the middle of a lathe's wall.
#[test]
fn plain_lines_along_axes_are_certain() {
    let mut q = [0.0; 16];
    (q[0], q[10], q[7]) = (1.0, 1.0, -1.0);
    let lathe = Geometry::Revolution {
        profile: vec![[0.0, 2.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]],
        colours: vec![],
    };
    let hyperbola = Geometry::HyperbolicCylinder { a: 1.0, b: 1.0 };
    let down = [0.0, -1.0, 0.0];
    let cases = [
        (Geometry::Quadric(Box::new(q)), [0.5, 10.0, 0.0], down, 1),
        (
            Geometry::ParabolicCylinder { a: 1.0 },
            [0.5, 10.0, 0.0],
            down,
            1,
        ),
        (hyperbola, [-5.0, -7.0, 0.0], [1.0, 1.0, 0.0], 1),
        (lathe.clone(), [0.5, 10.0, 0.0], down, 2),
        (lathe, [-5.0, 0.5, 0.25], [1.0, 0.0, 0.0], 2),
    ];
    for (geometry, origin, direction, found) in cases {
        let shape = Primitive::new(&geometry);
        let line = Line::new(origin.into(), direction.into());
        assert_eq!(doubt(&shape, &line), (false, found), "{geometry:?}");
    }
}

/// Finite numbers of every size, that stray or not: crossings are finite and ascend.
#[test]
fn extreme_lines_have_finite_crossings() {
    for kind in 0..KINDS.len() {
        let mut r = Random(77 + kind as u64);
        for _ in 0..500 {
            let s = sample(kind, &mut r);
            let extreme = |r: &mut Random, most: f64| {
                Vec3([0; 3].map(|_| match r.below(4) {
                    0 => 0.0,
                    1 => r.within(-1.0, 1.0),
                    _ => r.within(-1.0, 1.0) * 10f64.powf(r.within(-most, most)),
                }))
            };
            for most in [30.0, 300.0, 308.0] {
                let (o, d) = (extreme(&mut r, most), extreme(&mut r, most));
                if !d.any() {
                    continue;
                }
                let mut line = Line::new(o, d);
                crossings::<f64>(&s.primitive, &line);
                crossings::<Dd>(&s.primitive, &cast(&line));
                if most == 30.0 && cast::<f32>(&line).direction.any() {
                    crossings::<f32>(&s.primitive, &cast(&line));
                }
                line.slack = Slack {
                    origin: o.abs().max_component() * f64::EPSILON,
                    direction: d.abs().max_component() * f64::EPSILON,
                };
                crossings::<f64>(&s.primitive, &line);
            }
        }
    }
}
