//! The rays of projection matrices, against the matrices themselves in exact arithmetic: every point
//! of a ray is seen at the ray's place in the picture, in front of the eye, and the ray begins on the
//! clip cube and leads away from the eye.

use crate::campaign::rng::Rng;
use crate::exact::algebra::{Q, q, to_f64};
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::Code;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::sight::{Blind, Sight};
use zpg::internals::scene::{Camera, Rgb};
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::trace::camera::View;
use zpg::internals::trace::{Settings, Tracer};

type Rows = [[f64; 4]; 4];

/// Matrices of the kinds that are in use, each with its name.
fn standard(rng: &mut Rng) -> Vec<(&'static str, Rows)> {
    let mut number = |low: f64, high: f64| rng.range(low, high);
    let (sx, sy) = (number(0.5, 4.0), number(0.5, 4.0));
    let (cx, cy) = (number(-0.8, 0.8), number(-0.8, 0.8));
    let near = number(0.01, 2.0);
    let far = near * number(1.5, 1e4);
    let scale = number(0.1, 9.0);
    let top: [[f64; 4]; 2] = [[sx, 0.0, cx, 0.0], [0.0, sy, cy, 0.0]];
    let w = [0.0, 0.0, -1.0, 0.0];
    let perspective = |z: f64, one: f64| [top[0], top[1], [0.0, 0.0, z, one], w];
    let (a, b) = (
        -(far + near) / (far - near),
        -2.0 * far * near / (far - near),
    );
    let mut sheared = perspective(a, b);
    sheared[0][1] = number(-0.5, 0.5);
    sheared[1][0] = number(-0.5, 0.5);
    // The near plane is any plane before the eye: Lengyel, "Oblique view frustum depth projection
    // and clipping", 2005.
    let oblique = [top[0], top[1], [0.1, -0.2, -1.3, -0.7 * near], w];
    let parallel = [
        [sx, 0.0, 0.1, cx],
        [0.0, sy, -0.2, cy],
        [0.0, 0.0, -0.2, -1.1],
        [0.0, 0.0, 0.0, 1.0],
    ];
    vec![
        ("OpenGL", perspective(a, b)),
        ("OpenGL, infinite", perspective(-1.0, -2.0 * near)),
        (
            "OpenGL, beyond infinity",
            perspective(-0.9999999999999999, -2.0 * near),
        ),
        (
            "OpenGL, beyond infinity by far",
            perspective(-0.999, -2.0 * near),
        ),
        ("OpenGL, reversed", perspective(-a, -b)),
        (
            "OpenGL, reversed and infinite",
            perspective(1.0, 2.0 * near),
        ),
        (
            "Direct3D",
            perspective(far / (near - far), far * near / (near - far)),
        ),
        ("Direct3D, infinite", perspective(-1.0, -near)),
        (
            "Direct3D, reversed",
            perspective(near / (far - near), far * near / (far - near)),
        ),
        ("Direct3D, reversed and infinite", perspective(0.0, near)),
        ("sheared", sheared),
        ("oblique", oblique),
        ("parallel", parallel),
        (
            "scaled",
            perspective(a, b).map(|row| row.map(|x| x * scale)),
        ),
        ("the negative", perspective(a, b).map(|row| row.map(|x| -x))),
        (
            "the negative, infinite",
            perspective(-1.0, -2.0 * near).map(|row| row.map(|x| -x)),
        ),
        (
            "very small",
            perspective(a, b).map(|row| row.map(|x| x * 1e-250)),
        ),
        (
            "very large",
            perspective(a, b).map(|row| row.map(|x| x * 1e250)),
        ),
        (
            "telescope",
            [
                [1e6, 0.0, 0.0, 0.0],
                [0.0, 1e6, 0.0, 0.0],
                [0.0, 0.0, a, b],
                w,
            ],
        ),
        ("far away", [top[0], top[1], [0.0, 0.0, -1.0, -2e9], w]),
    ]
}

/// The clip coordinates of a point of the camera's space.
fn clip(rows: &Rows, p: &[Q; 3]) -> [Q; 4] {
    rows.map(|r| (0..3).fold(q(r[3]), |sum, j| sum + q(r[j]) * &p[j]))
}

/// start + t · direction, exactly.
fn point((start, direction): &([f64; 3], [f64; 3]), t: f64) -> [Q; 3] {
    std::array::from_fn(|i| q(start[i]) + q(t) * q(direction[i]))
}

/// How far off a ray is, by what it should be: the worst over some of its points, in parts of the
/// picture's half width.
fn judge(name: &str, rows: &Rows, x: f64, y: f64) -> f64 {
    let sight = Sight::of(&Matrix(*rows)).unwrap_or_else(|e| panic!("{name}: {e:?} {rows:?}"));
    let mut ray = sight
        .ray(x, y)
        .unwrap_or_else(|| panic!("{name}: {rows:?}"));
    // Steps as long as the start is far from the eye.
    let size = |v: [f64; 3]| v.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let step = size(ray.0).max(1e-300) / size(ray.1);
    ray.1 = ray.1.map(|c| c * step);
    let start = clip(rows, &point(&ray, 0.0));
    // A matrix in front of whose eye nothing is seen at all stands for its negative.
    let sign = if start[3] > Q::ZERO { q(1.0) } else { q(-1.0) };
    let depth = to_f64(&(&start[2] / &start[3]));
    assert!(
        (depth.abs() - 1.0).abs() < 1e-9,
        "{name}: starts at depth {depth}"
    );
    let mut worst = 0.0f64;
    let mut before = Q::ZERO;
    for t in [0.0, 0.5, 1.0, 3.0, 1e3] {
        let [cx, cy, _, cw] = clip(rows, &point(&ray, t));
        let cw_signed = &cw * &sign;
        assert!(cw_signed > Q::ZERO, "{name}: behind the eye at {t}");
        if t > 0.0 && sight.eye().is_some() {
            assert!(cw_signed > before, "{name}: comes nearer to the eye at {t}");
        }
        before = cw_signed;
        for (c, meant) in [(cx, x), (cy, y)] {
            worst = worst.max((to_f64(&(c / &cw)) - meant).abs());
        }
    }
    worst
}

#[test]
fn rays_are_those_of_the_matrix() {
    let mut rng = Rng::new(20);
    for _ in 0..300 {
        let (x, y) = (rng.range(-1.0, 1.0), rng.range(-1.0, 1.0));
        for (name, rows) in standard(&mut rng) {
            let off = judge(name, &rows, x, y);
            // A telescope enlarges what is rounded, and so do points a thousand times as far as
            // where parallel rays start.
            let bound = match name {
                "telescope" => 1e-9,
                "parallel" => 1e-11,
                _ => 1e-13,
            };
            assert!(off < bound, "{name}: {off:e} {rows:?} {x} {y}");
        }
    }
}

/// All matrices of small whole numbers: each takes pictures, is singular, or is refused; none that takes
/// pictures lacks a ray, and none that is refused would have them all.
#[test]
fn any_matrix_has_all_rays_or_is_refused() {
    let mut rng = Rng::new(21);
    let (mut taken, mut refused) = (0, 0);
    for _ in 0..3000 {
        let rows: Rows =
            std::array::from_fn(|_| std::array::from_fn(|_| rng.range(-3.5, 3.5).round()));
        match Sight::of(&Matrix(rows)) {
            Ok(_) => {
                taken += 1;
                for (x, y) in [
                    (0.0, 0.0),
                    (-1.0, 1.0),
                    (1.0, -1.0),
                    (1.0, 1.0),
                    (-1.0, -1.0),
                ] {
                    assert!(judge("whole numbers", &rows, x, y) < 1e-9, "{rows:?}");
                }
            }
            Err(Blind::Singular) => assert_eq!(determinant(&rows), 0.0),
            Err(Blind::InPart) => {
                refused += 1;
                assert_ne!(determinant(&rows), 0.0);
                // Depths −1 and 1 of some point are both behind the eye, and of some other both
                // behind the negative's.
                let inverse = Matrix(rows).inverse().unwrap();
                let behind = |sign: f64| {
                    (0..=20)
                        .flat_map(|i| (0..=20).map(move |j| (i, j)))
                        .any(|(i, j)| {
                            let (x, y) = (f64::from(i) / 10.0 - 1.0, f64::from(j) / 10.0 - 1.0);
                            [-1.0, 1.0].iter().all(|z| {
                                let r = inverse.0[3];
                                sign * (r[0] * x + r[1] * y + r[2] * z + r[3]) <= 1e-12
                            })
                        })
                };
                assert!(behind(1.0) && behind(-1.0), "{rows:?}");
            }
        }
    }
    assert!(taken > 100 && refused > 100, "{taken} {refused}");
}

/// Exact for whole numbers as small as these.
fn determinant(m: &Rows) -> f64 {
    let mut sum = 0.0;
    for i in 0..4 {
        let row = |j: usize| -> [f64; 4] {
            let r = m[1 + j];
            let mut out = [0.0; 4];
            let kept = (0..4).filter(|k| *k != i);
            kept.enumerate().for_each(|(at, k)| out[at] = r[k]);
            out
        };
        let (a, b, c) = (row(0), row(1), row(2));
        let minor = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        sum += if i % 2 == 0 {
            m[0][i] * minor
        } else {
            -m[0][i] * minor
        };
    }
    sum
}

/// The camera's place and axes are those of a camera without the matrix.
#[test]
fn cameras_with_matrices_stand_where_others_do() {
    let mut rng = Rng::new(22);
    for _ in 0..200 {
        let mut number = || rng.range(-3.0, 3.0);
        let plain = Camera {
            id: 2,
            position: [number(), number(), number()],
            direction: [number(), number(), number()],
            up: [number(), number(), number()],
            fovy: 50.0,
            projection: None,
        };
        let cot = 1.0 / 25f64.to_radians().tan();
        let aspect = 4.0 / 3.0;
        let camera = Camera {
            projection: Some(Matrix([
                [cot / aspect, 0.0, 0.0, 0.0],
                [0.0, cot, 0.0, 0.0],
                [0.0, 0.0, -1.0, -0.02],
                [0.0, 0.0, -1.0, 0.0],
            ])),
            ..plain
        };
        let (Some(plain), Some(view)) = (View::new(&plain, 40, 30), View::new(&camera, 40, 30))
        else {
            continue;
        };
        for (x, y) in [(0.5, 0.5), (20.0, 15.0), (33.0, 2.0)] {
            let (meant, ray) = (plain.ray(x, y).unwrap(), view.ray(x, y).unwrap());
            let off = (meant.line.direction - ray.line.direction).length();
            assert!(off < 1e-14, "{off:e}");
            let ahead = (ray.line.origin - meant.line.origin).cross(meant.line.direction);
            assert!(ahead.length() < 1e-14);
        }
    }
}

/// A scene's picture of 20 × 15 pixels.
fn picture(text: &str) -> Vec<Rgb> {
    let loaded = Analysis::new("scene.zpg", text.into());
    let scene = &*staged(&loaded.scene, Viewpoint::Scene, 4.0 / 3.0);
    let camera = zpg::internals::trace::selected_camera(scene, 4.0 / 3.0);
    let settings = Settings {
        width: 20,
        height: 15,
        ..Settings::default()
    };
    let tracer = Tracer::new(scene).unwrap();
    let film = tracer.render(&camera, &settings, || ()).unwrap().film;
    film.pixels.iter().map(|p| p.map(f64::from)).collect()
}

/// The ball of radius 1 seen from 5 away at a slope of ½ across the picture's half: 5 tan α / ½ of it,
/// with sin α = 1/5.
#[test]
fn pictures_through_infinite_and_reversed_depth() {
    let scene = |z: &str| {
        format!("20 9 1\n10 -99 2 0 0 0  0 2 0 0  0 0 {z}  0 0 -1 0\n10 -1 0 0 5\n1 9999 20 0\n")
    };
    let meant = picture(&scene("-1.0408163265306123 -0.20408163265306123"));
    let reach = 2.0 * (1.0f64 / 5.0).asin().tan();
    for (i, pixel) in meant.iter().enumerate() {
        let (x, y) = (i % 20, i / 20);
        let [x, y] = [
            2.0 * (x as f64 + 0.5) / 20.0 - 1.0,
            1.0 - 2.0 * (y as f64 + 0.5) / 15.0,
        ];
        let inside = x.hypot(y) < reach;
        assert_eq!(pixel[0] > 0.0, inside, "{x} {y}");
    }
    for z in [
        "-1 -0.2",
        "-0.9999999999999999 -0.2",
        "1 0.2",
        "0 0.1",
        "0.02 0.1",
        "-1 -0.1",
    ] {
        let off = picture(&scene(z))
            .iter()
            .zip(&meant)
            .fold(0.0f64, |m, (a, b)| m.max((a[0] - b[0]).abs()));
        assert!(off < 1e-6, "{z}: {off}");
    }
}

/// Where the ray of a part of the picture would start behind the eye.
#[test]
fn matrices_without_rays_are_reported() {
    let found = |rows: &str| -> Vec<Code> {
        let text = format!("20 9 1\n10 -99 {rows}\n10 -1 0 0 5\n1 9999 20 0\n");
        let loaded = Analysis::new("scene.zpg", text.into());
        let errors = loaded
            .findings()
            .iter()
            .filter(|d| d.code.as_str().starts_with('E'));
        errors.map(|d| d.code).collect()
    };
    // w = 1 + x − …: the left part of the picture is behind.
    assert_eq!(
        found("1 0 0 0  0 1 0 0  0 0 -1 -0.2  2 0 0 1"),
        [Code::E207]
    );
    assert_eq!(found("2 0 0 0  0 2 0 0  0 0 -1 -0.2  0 0 -1 0"), []);
    assert_eq!(found("2 0 0 0  0 2 0 0  0 0 -1 0  0 0 -1 0"), [Code::E204]);
    // The third row is 0.1 of the fourth, but for the rounding of 0.1: invertible.
    assert_eq!(
        found("2 0 0 0  0 2 0 0  0 0 -0.1 -0.30000000000000004  0 0 -1 -3"),
        []
    );
}

/// The real POV-Ray sees the same through translations of matrices with a far plane at infinity and of
/// reversed depth; what lies before the near plane is reported as seen.
#[test]
#[ignore = "needs POV-Ray"]
fn povray_sees_what_infinite_and_reversed_matrices_see() {
    let folder = tempfile::tempdir().unwrap();
    for (depth, near) in [
        ("-1 -0.2", "exact"),
        ("-0.9999999999999999 -0.2", "exact"),
        ("1 0.2", "exact"),
        ("0 0.1", "exact"),
        ("-1 -1e9", "near plane"),
    ] {
        let scene = format!(
            "20 9 1\n21 12 -2 -2 -1 2 -1 1\n22 -101 20 21\n10 -99 2 0 0.1 0  0 2 -0.2 0  0 0 {depth}  0 0 -1 0\n\
             10 -2 10 2\n10 -1 1 0.2 5\n12 -402 1\n12 -1 3 4 5\n1 9999 22 0\n"
        );
        std::fs::write(folder.path().join("a.zpg"), scene).unwrap();
        let run = |args: &[&str]| {
            crate::support::program::command()
                .current_dir(folder.path())
                .args(args)
                .output()
                .unwrap()
        };
        let converted = run(&["convert", "a.zpg", "--to", "pov", "-o", "a.pov"]);
        let report = String::from_utf8_lossy(&converted.stderr).into_owned();
        assert_eq!(
            report.contains("near plane"),
            near == "near plane",
            "{depth}: {report}"
        );
        if near == "exact" {
            let run = run(&["crosscheck", "a.zpg", "--with", "povray", "--size", "96x72"]);
            let said = String::from_utf8_lossy(&run.stdout).into_owned()
                + &String::from_utf8_lossy(&run.stderr);
            assert!(said.contains("agrees"), "{depth}: {said}");
        }
    }
}
