//! Rows about rays that leave a surface: they never meet it again at once.

use super::ask::Precision;
use super::trace_support::{Builder, Random};
use zpg::scene::{Geometry, Matrix, NodeId};
use zpg::trace::vec::Vec3;
use zpg::trace::{Ray, Tracer};

/// Sends rays from `from` to a solid and away from where they hit it. Outwards from a convex solid
/// nothing is met; inwards the next crossing is the way out; and of any solid the crossing that
/// follows is of the other kind. Returns the number of hits.
fn leave(tracer: &Tracer, rays: &[(Vec3, Vec3)], convex: bool, r: &mut Random, what: &str) -> u32 {
    let mut walker = tracer.walker();
    let mut left = 0;
    for &(origin, aim) in rays {
        let mut ray = Ray::new(origin, (aim - origin).unit());
        ray.outside = !tracer.holds(&mut walker, ray.line.origin);
        let Some(hit) = tracer.hit(&mut walker, &ray) else {
            continue;
        };
        left += 1;
        for _ in 0..2 {
            let d = r.point(1.0).unit();
            let outwards = d.dot(hit.normal) > 0.0;
            // `onwards` is inwards for a ray that came from outside.
            let next = hit.leave(d, hit.entering != outwards);
            let again = tracer.hit(&mut walker, &next);
            if let Some(again) = &again {
                let what = format!("{what}: {ray:?} {d:?} {hit:?} {again:?}");
                assert!(again.t > 0.0 && again.entering == outwards, "{what}");
                assert!(!(outwards && convex), "{what}");
            }
        }
    }
    left
}

pub fn row_18_leave_a_small_sphere(_: Precision) {
    let mut r = Random(18);
    let mut b = Builder::default();
    let root = b.sphere(0.0, 0.083, 0.4, 0.015);
    let tracer = b.tracer(root);
    let centre = Vec3::new(0.0, 0.083, 0.4);
    let rays: Vec<_> = (0..20_000)
        .map(|_| (centre + r.point(1.0).unit(), centre + r.point(0.01)))
        .collect();
    let left = leave(&tracer, &rays, true, &mut r, "sphere");
    assert!(left > 18_000, "{left}");
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
        _ => Geometry::Quadric([
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
        ]),
    };
    (b.shape(geometry), matches!(kind, 0..=3 | 5 | 11))
}

/// pbrt's Reintersect test: sizes 1e±4, origins up to 1e8 sizes away, shapes anywhere.
pub fn row_39_leave_everything(_: Precision) {
    let mut r = Random(39);
    let mut left = 0;
    for round in 0..1000 {
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
        let rays: Vec<_> = (0..1000)
            .map(|_| {
                let away = r.point(1.0).unit() * size * 10f64.powf(r.within(0.0, 8.0));
                (p + away, p + r.point(0.7 * size))
            })
            .collect();
        let what = format!("round {round}, size {size:e}, at {p:?}");
        left += leave(&tracer, &rays, convex, &mut r, &what);
    }
    assert!(left > 250_000, "{left}");
}
