//! Close calls whose answers are known by hand.

use super::*;
use crate::geometry::number::Real;

fn cube() -> Primitive {
    Primitive::new(&Geometry::Box {
        min: [-1.0; 3],
        max: [1.0; 3],
    })
}

fn sphere(centre: [f64; 3], radius: f64) -> Primitive {
    Primitive::new(&Geometry::Sphere { centre, radius })
}

fn ts<R: Traced>(shape: &Primitive, o: [f64; 3], d: [f64; 3]) -> (Vec<f64>, bool) {
    let roots = meet::<R>(shape, &line(Vec3(o), Vec3(d)));
    let list = roots.list.iter().map(|root| root.t.to_f64()).collect();
    (list, roots.uncertain)
}

/// In doubles and in double-double: how many crossings, and whether that is doubtful.
fn counts(shape: &Primitive, o: [f64; 3], d: [f64; 3]) -> [(usize, bool); 2] {
    let (plain, fine) = (ts::<f64>(shape, o, d), ts::<Dd>(shape, o, d));
    [(plain.0.len(), plain.1), (fine.0.len(), fine.1)]
}

/// Each bound on either side of its edge, by hand.
#[test]
fn bounds_at_their_edges() {
    // |f| ≤ 6, so that p is off by 24u and the discriminant by 2·24u + 4u + 2u = 54u; it is 4ku.
    let ball = sphere([0.0; 3], 1.0);
    for (k, doubtful) in [(13.0, true), (14.0, false)] {
        let o = [1.0 - k * f64::EPSILON, 0.0, -5.0];
        assert_eq!(
            counts(&ball, o, [0.0, 0.0, 1.0]),
            [(2, doubtful), (2, false)]
        );
        let o = [1.0 + k * f64::EPSILON, 0.0, -5.0];
        assert_eq!(
            counts(&ball, o, [0.0, 0.0, 1.0]),
            [(0, doubtful), (0, false)]
        );
    }
    // Near and far, at 6, are off by 24u each; they are ku apart.
    for (k, doubtful) in [(40.0, true), (56.0, false)] {
        let by = |s: f64| counts(&cube(), [-5.0, -7.0 + s * k * U, 0.0], [1.0, 1.0, 0.0]);
        assert_eq!(by(1.0), [(2, doubtful), (2, false)]);
        assert_eq!(by(-1.0), [(0, doubtful), (0, false)]);
    }
    // The slope is ku of terms that add up to 2, off by 8u.
    let half = Primitive::new(&Geometry::HalfSpace([1.0, 1.0, 0.0, -1.0]));
    for (k, doubtful) in [(7.0, true), (9.0, false)] {
        assert_eq!(
            counts(&half, [0.0, 3.0, 0.0], [1.0, -1.0 + k * U, 0.0]),
            [(1, doubtful), (1, false)]
        );
    }
    // Along the face x = 1: the value 3 + ku − 3 has terms that add up to 6, off by 30u.
    let half = Primitive::new(&Geometry::HalfSpace([1.0, 0.0, 0.0, -3.0]));
    for (k, doubtful) in [(28.0, true), (32.0, false)] {
        for (s, inside) in [(1.0, false), (-1.0, true)] {
            let along = line(
                Vec3::new(3.0 + s * k * U, 0.0, 0.0),
                Vec3::new(0.0, 1.0, 0.0),
            );
            let roots = meet::<f64>(&half, &along);
            assert_eq!((roots.inside, roots.uncertain), (inside, doubtful), "{k}");
        }
    }
    // The point 1 ± ku on the border 1 is off by 4u + 2u.
    let square = Primitive::new(&Geometry::Rectangle {
        min: [-1.0; 2],
        max: [1.0; 2],
    });
    for (x, count, doubtful) in [
        (-5.0, 1, true),
        (-7.0, 1, false),
        (4.0, 0, true),
        (8.0, 0, false),
    ] {
        assert_eq!(
            counts(&square, [0.0, 0.0, 4.0], [0.25 + x * U / 4.0, 0.0, -1.0]),
            [(count, doubtful), (count, false)],
            "{x}"
        );
    }
}

/// A case that doubles hold exactly is decided at once.
#[test]
fn exact_cases_are_certain() {
    let down = [0.0, 0.0, -1.0];
    let both = |count| [(count, false); 2];
    assert_eq!(counts(&cube(), [0.1, 0.2, 5.0], down), both(2));
    // In the plane of a face, along an edge, and beside. What lies in a face crosses nothing; doubles
    // leave it to the final numbers what lies against the face.
    let within = [(0, true), (0, false)];
    assert_eq!(counts(&cube(), [1.0, 0.2, 5.0], down), within);
    assert_eq!(counts(&cube(), [1.0, -1.0, 5.0], down), within);
    assert_eq!(counts(&cube(), [1.0 + 2.0 * U, 0.2, 5.0], down), both(0));
    let flat = Primitive::new(&Geometry::Box {
        min: [-1.0, -1.0, 0.0],
        max: [1.0, 1.0, 0.0],
    });
    assert_eq!(counts(&flat, [0.0, 0.0, 5.0], down), both(0));
    assert_eq!(counts(&flat, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]), both(0));
    let square = Primitive::new(&Geometry::Rectangle {
        min: [-1.0; 2],
        max: [1.0; 2],
    });
    assert_eq!(counts(&square, [1.0, 0.0, 5.0], down), both(1));
    assert_eq!(counts(&square, [1.0 + 2.0 * U, 0.0, 5.0], down), both(0));
    assert_eq!(counts(&square, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]), both(0));
    let floor = Primitive::new(&Geometry::HalfSpace([0.0, 1.0, 0.0, 0.0]));
    for (y, inside, lies) in [
        (1e-60, false, false),
        (0.0, false, true),
        (-1e-60, true, false),
    ] {
        let along = Vec3::new(0.3, 0.0, 0.7);
        let roots = meet::<f64>(&floor, &line(Vec3::new(1.0, y, 2.0), along));
        assert_eq!((roots.inside, roots.uncertain), (inside, lies), "{y}");
        assert_eq!(roots.along.is_some(), lies);
        assert!(roots.list.is_empty());
    }
    // A touch is none, and a close call.
    let ball = sphere([0.0; 3], 1.0);
    assert_eq!(counts(&ball, [1.0, 0.0, -5.0], down), [(0, true); 2]);
}

/// A box turned by a right angle, whose cosine is zero, and lines along the axes: nothing is rounded
/// on their way into its space, and all is certain.
#[test]
fn right_angles_are_no_close_calls() {
    let back = Affine::<f64>::new(&Matrix::rotation(90.0, 1).inverse().unwrap());
    let square = Primitive::new(&Geometry::Rectangle {
        min: [-1.0; 2],
        max: [1.0; 2],
    });
    for x in [-0.9, 0.0, 0.5, 1.5] {
        for axis in 0..3 {
            let (mut o, mut d) = (Vec3::new(x, x, x), Vec3::ZERO);
            (o[axis], d[axis]) = (5.0, -1.0);
            let turned = line::<f64>(o, d).through(&back);
            assert_eq!(turned.slack, Default::default());
            let roots = meet(&cube(), &turned);
            assert_eq!(roots.list.len(), if x < 1.0 { 2 } else { 0 });
            assert!(!roots.uncertain);
            // Turned into the plane x = 0: a line in it does not cross it.
            let roots = meet(&square, &turned);
            let hits = axis == 0 && x < 1.0;
            assert_eq!(roots.list.len(), usize::from(hits), "{x} {axis}");
            assert!(!roots.uncertain, "{x} {axis}");
        }
    }
}

/// Known hard rays against spheres and planes.
#[test]
fn hard_rays() {
    fn all<R: Traced>() {
        let z = [0.0, 0.0, 1.0];
        // 1e-11 inside the rim: the discriminant is off by at most 54u, t by that over twice its root.
        let x = 1.0 - 1e-11;
        let depth = ((1.0 - x) * (1.0 + x)).sqrt();
        let (t, doubtful) = ts::<R>(&sphere([0.0; 3], 1.0), [x, 0.0, -5.0], z);
        assert!(!doubtful && (t[0] - (5.0 - depth)).abs() <= 54.0 * U / (2.0 * depth) + 8.0 * U);
        assert!((5.0 - t[0] - 4.47e-6).abs() < 5e-9);
        // From 1.1e7 away.
        let far = [0.3, 0.2, -1.1e7];
        let (t, doubtful) = ts::<R>(&sphere([0.0; 3], 1.0), far, z);
        assert!(!doubtful && (t[0] - (1.1e7 - 0.87f64.sqrt())).abs() <= 1.1e7 * f64::EPSILON);
        // The horizon of a great sphere.
        let ground = sphere([0.0, -1e6, 0.0], 1e6);
        let (t, doubtful) = ts::<R>(&ground, [0.0, 1e-3, 0.0], [1.0, -1e-3, 0.0]);
        let distance = t[0] * 1.000_001f64.sqrt();
        assert!(!doubtful && (distance - 1.000_501_000_876_0).abs() < 1e-13);
        // 1e4 from the origin, to the rim: numbers there are 1.8e-12 apart.
        let (c, steps) = ([1e4, -1e4, 1e4], 720);
        for i in 0..steps {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(steps);
            for (reach, count) in [(1.0 - 1e-11, 2), (1.0 + 1e-11, 0)] {
                let o = [
                    c[0] + reach * angle.cos(),
                    c[1] + reach * angle.sin(),
                    c[2] - 5.0,
                ];
                let (t, doubtful) = ts::<R>(&sphere(c, 1.0), o, z);
                assert!(!doubtful && t.len() == count);
            }
        }
        // Almost along a plane.
        let floor = Primitive::new(&Geometry::Plane([0.0, 1.0, 0.0, 0.0]));
        let (t, doubtful) = ts::<R>(&floor, [0.0, 1e-8, 0.0], [1.0, -5e-11, 0.0]);
        assert!(!doubtful && (t[0] - 200.0).abs() <= 4.0 * 200.0 * U);
    }
    all::<f64>();
    all::<Dd>();
}
