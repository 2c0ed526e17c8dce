//! Rows about rays that leave a surface: they never meet it again at once.

use super::ask::Precision;
use super::cases;
use super::trace_support::{Builder, Random};
use zpg::internals::geometry::Matrix;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::{Geometry, NodeId};
use zpg::internals::trace::precision;
use zpg::internals::trace::{Ray, Tracer};

/// What became of the rays.
#[derive(Debug, Default)]
struct Tally {
    /// Rays that hit something and left it twice.
    left: u32,
    /// Of the latter those that met the next crossing at t ≤ 0.
    backwards: u32,
}

/// Sends rays from `from` to a solid and away from where they hit it. Outwards from a convex solid
/// nothing is met; inwards the next crossing is the way out; and of any solid the crossing that
/// follows is of the other kind.
fn leave_in<R: precision::Precision>(
    tracer: &Tracer,
    rays: &[(Vec3, Vec3)],
    convex: bool,
    r: &mut Random,
    what: &str,
) -> Tally {
    let mut walker = tracer.walker::<R>();
    let mut tally = Tally::default();
    for &(origin, aim) in rays {
        let mut ray = Ray::new(origin, (aim - origin).unit()).cast::<R>();
        if !tracer.holds(&mut walker, ray.line.origin) {
            ray.is_outside = true;
        }
        let Some(hit) = tracer.hit(&mut walker, &ray) else {
            continue;
        };
        tally.left += 1;
        for _ in 0..2 {
            let d = r.point(1.0).unit().cast::<R>();
            let outwards = d.dot(hit.normal) > R::ZERO;
            // `onwards` is inwards for a ray that came from outside.
            let next = hit.leave(d, hit.entering != outwards);
            let again = tracer.hit(&mut walker, &next);
            if let Some(again) = &again {
                let what = format!("{what}: {ray:?} {d:?} {hit:?} {again:?}");
                assert!(again.entering == outwards, "{what}");
                assert!(!(outwards && convex), "{what}");
                tally.backwards += u32::from(again.t <= R::ZERO);
            }
        }
    }
    tally
}

/// [`leave_in`] the numbers of a precision.
fn leave(
    precision: Precision,
    tracer: &Tracer,
    rays: &[(Vec3, Vec3)],
    convex: bool,
    r: &mut Random,
    what: &str,
) -> Tally {
    let leave = match precision {
        Precision::F32 => leave_in::<f32>,
        Precision::F64 => leave_in::<f64>,
        Precision::Dd => leave_in::<Dd>,
    };
    leave(tracer, rays, convex, r, what)
}

pub fn row_18_leave_a_small_sphere(precision: Precision) {
    let mut r = Random(18);
    let mut b = Builder::default();
    let root = b.sphere([0.0, 0.083, 0.4], 0.015);
    let tracer = b.tracer(root);
    let centre = Vec3::new(0.0, 0.083, 0.4);
    let rays: Vec<_> = (0..20_000)
        .map(|_| (centre + r.point(1.0).unit(), centre + r.point(0.01)))
        .collect();
    let tally = leave(precision, &tracer, &rays, true, &mut r, "sphere");
    assert!(tally.left > 18_000 && tally.backwards == 0, "{tally:?}");
}

/// A solid within a ball of radius 2·size around `p`, or an unbounded one, and whether it is convex.
fn solid(b: &mut Builder, r: &mut Random, kind: u32, size: f64) -> (NodeId, bool) {
    let share = |r: &mut Random| size * r.within(0.1, 1.0);
    let (a, c, e) = (share(r), share(r), share(r));
    let geometry = match kind {
        0 => Geometry::Sphere {
            centre: [0.0; 3],
            radius: a,
        },
        1 => Geometry::Box {
            min: [-a, -c, -e],
            max: [c, e, a],
        },
        2 => Geometry::HalfSpace([c, -a, e, 0.1 * size * size]),
        3 => Geometry::Ellipsoid {
            semi_axes: [a, c, e],
        },
        4 => Geometry::Torus {
            major: a,
            minor: 0.3 * a,
        },
        5 => Geometry::Cone {
            height: -a,
            radius: c,
        },
        6 => Geometry::DoubleCone {
            height: a,
            radius: c,
        },
        7 => Geometry::Revolution {
            profile: vec![[0.0, c], [a, e], [0.5 * a, -c], [0.0, -c]],
            colours: Vec::new(),
        },
        8 => Geometry::HyperbolicCylinder { a, b: c },
        9 => Geometry::Hyperboloid {
            a,
            b: c,
            c: e,
            sheets: 1 + r.below(2) as u32,
        },
        10 => Geometry::GeodesicSphere {
            radius: a,
            splits: r.below(4) as u32,
        },
        _ => Geometry::Quadric(Box::new([
            1.0 / (a * a),
            0.0,
            0.0,
            0.0,
            0.0,
            1.0 / (c * c),
            0.0,
            0.0,
            0.0,
            0.0,
            1.0 / (e * e),
            0.0,
            0.0,
            0.0,
            0.0,
            -1.0,
        ])),
    };
    (b.shape(geometry), matches!(kind, 0..=3 | 5 | 11))
}

/// pbrt's Reintersect test: sizes 1e±4, origins up to 1e8 sizes away, shapes anywhere. In dd, which
/// takes six times as long as doubles, a tenth of the rays.
///
/// In single precision, where doubts stand as they are rounded, the side of a crossing is always
/// right, its place not: a ray into a solid may not see the chord before it, being off by more than
/// that, and then names a way out behind its start. Some 150 of 500 000 hits are left so.
pub fn row_39_leave_everything(precision: Precision) {
    let each = match precision {
        Precision::Dd => 100,
        Precision::F32 | Precision::F64 => 1000,
    };
    let mut r = Random(39);
    let mut tally = Tally::default();
    let rounds = cases(240, 1000);
    for round in 0..rounds {
        let mut b = Builder::default();
        let size = 10f64.powf(r.within(-4.0, 4.0));
        let (shape, convex) = solid(&mut b, &mut r, (round / 2) % 12, size);
        let turn = Matrix::rotation(r.within(-180.0, 180.0), r.below(3) as usize);
        let far = size * 10f64.powf(r.within(-4.0, 4.0));
        let p = r.point(far);
        // Every other one stretched and mirrored too.
        let shape_of = match round % 2 {
            0 => turn,
            _ => turn.after(&Matrix::scaling(
                r.within(0.5, 2.0),
                -r.within(0.5, 2.0),
                r.within(0.5, 2.0),
            )),
        };
        let matrix = Matrix::translation(p[0], p[1], p[2]).after(&shape_of);
        let root = b.moved(shape, matrix);
        let tracer = b.tracer(root);
        let rays: Vec<_> = (0..each)
            .map(|_| {
                let away = r.point(1.0).unit() * size * 10f64.powf(r.within(0.0, 8.0));
                (p + away, p + r.point(0.7 * size))
            })
            .collect();
        let what = format!("round {round}, size {size:e}, at {p:?}");
        let Tally { left, backwards } = leave(precision, &tracer, &rays, convex, &mut r, &what);
        tally.left += left;
        tally.backwards += backwards;
    }
    assert!(4 * tally.left > rounds * each, "{tally:?}");
    match precision {
        Precision::F32 => assert!(tally.backwards < tally.left / 1000, "{tally:?}"),
        Precision::F64 | Precision::Dd => assert_eq!(tally.backwards, 0),
    }
}
