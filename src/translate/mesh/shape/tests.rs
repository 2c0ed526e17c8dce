use super::*;
use crate::scene::TriangleNormals;
use std::f64::consts::PI;

const REGION: Aabb = Aabb {
    min: [-2.0, -3.0, -2.5],
    max: [2.5, 2.0, 3.0],
};

fn made(geometry: &Geometry, tolerance: f64) -> Solid {
    let solid = tessellate(geometry, tolerance, &REGION, &mut Budget::default()).unwrap();
    for mesh in &solid.meshes {
        assert!(mesh.is_closed(), "{geometry:?}");
        assert!(mesh.volume() > 0.0, "{geometry:?} {}", mesh.volume());
        assert!(mesh.points.iter().flatten().all(|x| x.is_finite()));
    }
    solid
}

/// Solids whose volume a formula gives.
#[test]
fn volumes_by_formula() {
    let (a, b, c): (f64, f64, f64) = (1.5, 0.7, 2.0);
    let cases = [
        (
            Geometry::Sphere {
                centre: [1.0, 2.0, 3.0],
                radius: a,
            },
            4.0 / 3.0 * PI * a.powi(3),
        ),
        (
            Geometry::Ellipsoid {
                semi_axes: [a, b, c],
            },
            4.0 / 3.0 * PI * a * b * c,
        ),
        (
            Geometry::Torus { major: a, minor: b },
            2.0 * PI * PI * a * b * b,
        ),
        (
            Geometry::Cone {
                height: c,
                radius: a,
            },
            PI * a * a * c / 3.0,
        ),
        (
            Geometry::Cone {
                height: -c,
                radius: a,
            },
            PI * a * a * c / 3.0,
        ),
        (
            Geometry::DoubleCone {
                height: c,
                radius: a,
            },
            2.0 * PI * a * a * c / 3.0,
        ),
        (
            Geometry::Box {
                min: [0.0; 3],
                max: [a, b, c],
            },
            a * b * c,
        ),
        (
            Geometry::Revolution {
                profile: vec![[a, 0.0], [b, c]],
                colours: Vec::new(),
            },
            PI * c / 3.0 * (a * a + a * b + b * b),
        ),
        (
            // A pipe.
            Geometry::Revolution {
                profile: vec![[b, 0.0], [a, 0.0], [a, c], [b, c], [b, 0.0]],
                colours: Vec::new(),
            },
            PI * c * (a * a - b * b),
        ),
        (
            // 4x² + y²/9 + (z − 1)² ≤ 1.
            Geometry::Quadric(Box::new([
                4.0,
                0.0,
                0.0,
                0.0,
                0.0,
                1.0 / 9.0,
                0.0,
                0.0,
                0.0,
                0.0,
                1.0,
                -1.0,
                0.0,
                0.0,
                -1.0,
                0.0,
            ])),
            4.0 / 3.0 * PI * 0.5 * 3.0,
        ),
    ];
    for (geometry, volume) in cases {
        let mut last = f64::INFINITY;
        for tolerance in [0.1, 0.01, 0.001] {
            let got: f64 = made(&geometry, tolerance)
                .meshes
                .iter()
                .map(Mesh::volume)
                .sum();
            let error = (got - volume).abs();
            // The surface of none is more than 60.
            assert!(error <= 60.0 * tolerance, "{geometry:?} {got} {volume}");
            assert!(error <= last + 1e-12);
            last = error;
        }
    }
}

/// Apple without lemon: ∫ over the circle's two halves, each turned about the axis.
#[test]
fn a_torus_wider_than_its_ring() {
    let (major, minor) = (0.6, 1.0);
    // Shells of radius x and the height of the circle there, mirrored where it is beyond the axis.
    let steps = 400_000;
    let shell = |x: f64| {
        let height = |x: f64| (minor * minor - (x - major).powi(2)).max(0.0).sqrt();
        2.0 * PI * x * 2.0 * (height(x) - height(-x))
    };
    let width = (major + minor) / f64::from(steps);
    let volume: f64 = (0..steps)
        .map(|i| shell((f64::from(i) + 0.5) * width) * width)
        .sum();
    let solid = made(&Geometry::Torus { major, minor }, 1e-4);
    let got = solid.meshes[0].volume();
    assert!((got - volume).abs() < 2e-3, "{got} {volume}");
    let horn = made(
        &Geometry::Torus {
            major: 1.0,
            minor: 1.0,
        },
        1e-4,
    );
    assert!((horn.meshes[0].volume() - 2.0 * PI * PI).abs() < 4e-3);
}

/// F(x, y, z) of xᵀQx.
fn value(q: &[f64; 16], p: [f64; 3]) -> f64 {
    let x = [p[0], p[1], p[2], 1.0];
    let terms = (0..16).map(|k| q[k] * x[k / 4] * x[k % 4]);
    terms.sum()
}

fn winding(meshes: &[Mesh], p: [f64; 3]) -> bool {
    // Crossings of a line upwards.
    let mut count = 0;
    for mesh in meshes {
        for t in 0..mesh.triangles.len() {
            let [a, b, c] = mesh.corners(t);
            let side = |u: [f64; 3], v: [f64; 3]| {
                (u[0] - p[0]) * (v[2] - p[2]) - (u[2] - p[2]) * (v[0] - p[0])
            };
            let (x, y, z) = (side(b, c), side(c, a), side(a, b));
            if (x > 0.0) == (y > 0.0) && (y > 0.0) == (z > 0.0) {
                let at = (x * a[1] + y * b[1] + z * c[1]) / (x + y + z);
                count += usize::from(at > p[1]);
            }
        }
    }
    count % 2 == 1
}

/// Every kind of quadric, turned and moved: points of the region are in the mesh if they are in it.
#[test]
fn quadrics_agree_with_their_polynomial() {
    let diagonal = |a: f64, b: f64, c: f64, y: f64, d: f64| {
        let mut q = [0.0; 16];
        (q[0], q[5], q[10], q[15]) = (a, b, c, d);
        q[7] = y;
        q
    };
    let forms = [
        diagonal(1.0, 2.0, 0.5, 0.0, -1.0),
        diagonal(1.0, -2.0, 0.5, 0.0, -1.0),
        diagonal(1.0, -2.0, 0.5, 0.0, 1.0),
        diagonal(1.0, -2.0, 0.5, 0.0, 0.0),
        diagonal(1.0, 0.0, 0.5, 0.0, -1.0),
        diagonal(1.0, 0.0, 0.5, -1.0, 0.3),
        diagonal(1.0, 0.0, -0.5, -1.0, 0.0),
        diagonal(1.0, 0.0, -0.5, 0.0, -1.0),
        diagonal(1.0, 0.0, -0.5, 0.0, 1.0),
        diagonal(1.0, 0.0, -0.5, 0.0, 0.0),
        diagonal(1.0, 0.0, 0.0, -1.0, 0.2),
        diagonal(1.0, 0.0, 0.0, 0.0, -1.0),
        diagonal(0.0, 0.0, 0.0, 1.0, 0.4),
        diagonal(1.0, 1.0, 1.0, 0.0, 1.0),
        diagonal(0.0, 0.0, 0.0, 0.0, -1.0),
    ];
    let place = Matrix::translation(0.3, -0.2, 0.1)
        .after(&Matrix::rotation(25.0, 0))
        .after(&Matrix::rotation(-50.0, 2));
    let back = place.inverse().unwrap();
    for form in forms {
        for (matrix, sign) in [
            (Matrix::IDENTITY, 1.0),
            (Matrix::IDENTITY, -1.0),
            (back, 1.0),
            (back, -3.0),
        ] {
            // MᵀQM.
            let mut q = [0.0; 16];
            for (k, x) in q.iter_mut().enumerate() {
                for (l, f) in form.iter().enumerate() {
                    *x += sign * f * matrix.0[l / 4][k / 4] * matrix.0[l % 4][k % 4];
                }
            }
            let solid = made(&Geometry::Quadric(Box::new(q)), 1e-3);
            let (mut wrong, mut asked) = (0, 0);
            let halton = |i: u32, base: u32| {
                let (mut i, mut f, mut x) = (i, 1.0, 0.0);
                while i > 0 {
                    f /= f64::from(base);
                    x += f * f64::from(i % base);
                    i /= base;
                }
                x
            };
            for i in 1..200 {
                let p: [f64; 3] = std::array::from_fn(|k| {
                    let s = halton(i, [2, 3, 5][k]);
                    REGION.min[k] + s * (REGION.max[k] - REGION.min[k])
                });
                let f = value(&q, p);
                // Nothing is steeper there than 40: near the surface there is no telling.
                if f.abs() > 0.04 * sign.abs() {
                    asked += 1;
                    let inside = winding(&solid.meshes, p) != solid.outside;
                    wrong += usize::from(inside != (f <= 0.0));
                }
            }
            assert_eq!(wrong, 0, "{form:?} {sign} of {asked}");
            assert!(asked > 150);
        }
    }
}

#[test]
fn named_quadrics_are_those_of_the_language() {
    let inside = |geometry: Geometry, p: [f64; 3]| {
        let solid = made(&geometry, 1e-3);
        winding(&solid.meshes, p) != solid.outside
    };
    let a = || Geometry::ParabolicCylinder { a: 0.5 };
    assert!(inside(a(), [0.3, 1.0, -1.0]) && !inside(a(), [0.9, 1.0, 0.5]));
    let b = || Geometry::HyperbolicCylinder { a: 0.5, b: 1.0 };
    assert!(inside(b(), [0.45, 0.01, 2.0]) && !inside(b(), [0.6, 0.1, 1.0]));
    let c = |sheets| Geometry::Hyperboloid {
        a: 0.5,
        b: 0.6,
        c: 1.0,
        sheets,
    };
    assert!(inside(c(1), [0.1, 0.01, 0.2]) && !inside(c(2), [0.1, 0.01, 0.2]));
    assert!(inside(c(2), [0.1, 1.0, 0.2]) && inside(c(2), [0.1, -1.0, 0.2]));
    let d = || Geometry::HyperbolicParaboloid { a: 0.5, b: 1.0 };
    assert!(inside(d(), [0.1, 0.2, 0.4]) && !inside(d(), [0.9, 0.5, 0.3]));
}

#[test]
fn surfaces_show_one_face() {
    let triangle = Geometry::Triangle {
        vertices: Box::new([[0.0; 3], [2.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        normals: TriangleNormals::Flat,
    };
    let rectangle = Geometry::Rectangle {
        min: [-1.0, 0.0],
        max: [1.0, 2.0],
    };
    let plane = Geometry::Plane([0.2, 1.0, 0.1, 0.3]);
    for (geometry, triangles) in [(triangle, 1), (rectangle, 2), (plane, 2)] {
        let solid = made(&geometry, 0.01);
        let shown = solid.meshes[0].only(|l| l != DROPPED);
        assert_eq!(shown.triangles.len(), triangles);
        let up = shown.corners(0);
        assert!(
            up.iter()
                .all(|p| REGION.contains(*p) || matches!(geometry, Geometry::Plane(_)))
        );
    }
}

#[test]
fn too_fine_a_tolerance_is_refused_before_memory_is_taken() {
    let shapes = [
        Geometry::Sphere {
            centre: [0.0; 3],
            radius: 1.0,
        },
        Geometry::Torus {
            major: 2.0,
            minor: 1.0,
        },
        Geometry::Cone {
            height: 1.0,
            radius: 1.0,
        },
        Geometry::HyperbolicParaboloid { a: 1.0, b: 1.0 },
        Geometry::Hyperboloid {
            a: 1.0,
            b: 1.0,
            c: 1.0,
            sheets: 1,
        },
    ];
    for geometry in shapes {
        for tolerance in [1e-17, 1e-200] {
            let made = tessellate(&geometry, tolerance, &REGION, &mut Budget::default());
            assert!(made.is_err(), "{geometry:?}");
        }
    }
}

#[test]
fn stretches_are_singular_values() {
    let m = Matrix::rotation(33.0, 1)
        .after(&Matrix::scaling(-3.0, 2.0, 0.5))
        .after(&Matrix::rotation(71.0, 0));
    assert!((stretch(&m) - 3.0).abs() < 1e-12);
    assert!((stretch(&Matrix::scaling(1e-200, 1e-201, 0.0)) / 1e-200 - 1.0).abs() < 1e-12);
}
