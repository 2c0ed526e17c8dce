//! A record that is transformed and the same shape written out draw the same picture.

use crate::campaign::rng::Rng;
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::Matrix;
use zpg::internals::trace::{Settings, Tracer, selected_camera};

fn text(numbers: &[f64]) -> String {
    let all: Vec<String> = numbers.iter().map(|x| format!("{x:?}")).collect();
    all.join(" ")
}

/// −3 and −1 records of object 20 that scale and then move.
fn placed([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> String {
    format!("20 -3 {x:?} {y:?} {z:?}\n20 -1 {u:?} {v:?} {w:?}\n")
}

/// A number from 0.5 to 1.6, to three digits.
fn size(rng: &mut Rng) -> f64 {
    rng.range(500.0, 1600.0).round() / 1000.0
}

fn offset(rng: &mut Rng) -> f64 {
    rng.range(-700.0, 700.0).round() / 1000.0
}

/// Any affine map that is not flat, as records of object 20 and as a matrix.
fn any_map(rng: &mut Rng) -> (String, Matrix) {
    let mut records = String::new();
    let mut matrix = Matrix::IDENTITY;
    for _ in 0..2 {
        let scale = [0; 3].map(|_| size(rng) * rng.sign());
        let (angle, axis) = (rng.range(-180.0, 180.0).round(), rng.below(3));
        let shift = [0; 3].map(|_| offset(rng) / 2.0);
        records += &format!(
            "20 -3 {}\n20 -2 {angle} {}\n20 -1 {}\n",
            text(&scale),
            axis + 1,
            text(&shift)
        );
        let [[x, y, z], [u, v, w]] = [scale, shift];
        matrix = Matrix::translation(u, v, w)
            .after(&Matrix::rotation(angle, axis))
            .after(&Matrix::scaling(x, y, z))
            .after(&matrix);
    }
    (records, matrix)
}

/// The transpose of the inverse times a row of four numbers, or a normal with 0 for the fourth.
fn covector(inverse: &Matrix, n: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|j| (0..4).map(|i| n[i] * inverse.0[i][j]).sum())
}

/// The record of object 20 with records that transform it, and the same shape in one record.
fn pair(rng: &mut Rng, ty: u32) -> (String, String) {
    let scale = [0; 3].map(|_| size(rng));
    let signs = [0; 3].map(|_| rng.sign());
    let mirrored: [f64; 3] = std::array::from_fn(|i| scale[i] * signs[i]);
    let shift = [0; 3].map(|_| offset(rng));
    let s = scale[0];
    let (a, b, c) = (size(rng), size(rng), size(rng));
    let uniform = [s * signs[0], s * signs[1], s * signs[2]];
    // Across the y axis alike.
    let turned = [s * signs[0], mirrored[1], s * signs[2]];
    let up = [0.0, shift[1], 0.0];
    let still = [0.0; 3];
    let record = |numbers: &[f64]| format!("20 {ty} {}\n", text(numbers));
    match ty {
        1 | 2 => {
            let n = 3 + rng.below(3);
            let points: Vec<[f64; 2]> = (0..n)
                .map(|i| [size(rng) * 0.7, i as f64 * 0.4 - 0.6 + 0.1 * size(rng)])
                .collect();
            let colours: Vec<f64> = match ty {
                2 => (0..3 * n).map(|_| rng.range(0.1, 0.9)).collect(),
                _ => Vec::new(),
            };
            let lathe = |k: f64, l: f64, m: f64| {
                let profile = points.iter().flat_map(|p| [k * p[0], l * p[1] + m]);
                let numbers: Vec<f64> = profile.chain(colours.iter().copied()).collect();
                format!("20 {ty} {n} {}\n", text(&numbers))
            };
            (
                lathe(1.0, 1.0, 0.0) + &placed(turned, up),
                lathe(s, turned[1], up[1]),
            )
        }
        3 | 4 => {
            let (records, matrix) = any_map(rng);
            let [x, y, z] = rng.direction();
            let plane = [x, y, z, offset(rng)];
            let inverse = matrix.inverse().unwrap();
            (
                record(&plane) + &records,
                record(&covector(&inverse, plane)),
            )
        }
        5 => {
            let [x, y] = [mirrored[0], mirrored[1]];
            let ends = |k: f64, m: f64, from: f64, to: f64| {
                let (p, q) = (k * from + m, k * to + m);
                (p.min(q), p.max(q))
            };
            let (x0, x1) = ends(x, shift[0], -a, b);
            let (y0, y1) = ends(y, shift[1], -c, a);
            (
                record(&[-a, -c, b, a]) + &placed(mirrored, [shift[0], shift[1], 0.0]),
                record(&[x0, y0, x1, y1]),
            )
        }
        6..=8 => {
            let (records, matrix) = any_map(rng);
            let inverse = matrix.inverse().unwrap();
            let corners = [0; 3].map(|_| rng.cube().map(|x| 1.4 * x));
            let normals: Vec<[f64; 3]> = match ty {
                6 => vec![],
                7 => vec![rng.direction()],
                _ => (0..3).map(|_| rng.direction()).collect(),
            };
            let mut numbers: Vec<f64> = corners.as_flattened().to_vec();
            numbers.extend(normals.as_flattened());
            let mut written: Vec<f64> = corners.iter().flat_map(|p| matrix.point(*p)).collect();
            for [x, y, z] in normals {
                written.extend(&covector(&inverse, [x, y, z, 0.0])[..3]);
            }
            (record(&numbers) + &records, record(&written))
        }
        9 => (
            format!("20 9 {a:?}\n{}", placed(uniform, shift)),
            format!("20 11 {} {:?}\n", text(&shift), a * s),
        ),
        10 => (
            record(&[a, b, c]) + &placed(mirrored, still),
            record(&[a * scale[0], b * scale[1], c * scale[2]]),
        ),
        11 => {
            let centre = [0; 3].map(|_| offset(rng));
            let there: Vec<f64> = (0..3).map(|i| uniform[i] * centre[i] + shift[i]).collect();
            (
                format!("20 11 {} {a:?}\n", text(&centre)) + &placed(uniform, shift),
                format!("20 11 {} {:?}\n", text(&there), a * s),
            )
        }
        12 => {
            let (min, max) = ([-a, -b, -c], [c, a, b]);
            let ends = [min, max]
                .map(|p| -> [f64; 3] { std::array::from_fn(|i| mirrored[i] * p[i] + shift[i]) });
            let low = std::array::from_fn::<f64, 3, _>(|i| ends[0][i].min(ends[1][i]));
            let high = std::array::from_fn::<f64, 3, _>(|i| ends[0][i].max(ends[1][i]));
            (
                record(&[min, max].concat()) + &placed(mirrored, shift),
                record(&[low, high].concat()),
            )
        }
        13 => {
            let splits = rng.below(3);
            (
                format!("20 13 {a:?} {splits}\n") + &placed([s; 3], still),
                format!("20 13 {:?} {splits}\n", a * s),
            )
        }
        14 => (
            record(&[a, 0.3 * b]) + &placed(uniform, still),
            record(&[a * s, 0.3 * b * s]),
        ),
        15 => {
            let (records, matrix) = any_map(rng);
            let mut form = [0.0; 16];
            for (i, x) in form.iter_mut().enumerate() {
                *x = if i % 5 == 0 {
                    size(rng)
                } else {
                    0.2 * offset(rng)
                };
            }
            form[15] = -1.0;
            let inverse = matrix.inverse().unwrap().0;
            let moved: Vec<f64> = (0..16)
                .map(|k| {
                    let (i, j) = (k / 4, k % 4);
                    let terms = (0..16).map(|m| inverse[m / 4][i] * form[m] * inverse[m % 4][j]);
                    terms.sum()
                })
                .collect();
            (record(&form) + &records, record(&moved))
        }
        16 => (
            record(&[a, b]) + &placed(turned, still),
            record(&[a * turned[1], b * s]),
        ),
        17 => (
            record(&[a, b]) + &placed(turned, still),
            record(&[a * scale[1], b * s]),
        ),
        // What the height is scaled by, the form is divided by.
        18 => (
            record(&[a]) + &placed([scale[0], scale[1], scale[2]], still),
            record(&[a * scale[0] / scale[1].sqrt()]),
        ),
        19 => (
            record(&[a, b]) + &placed(mirrored, [0.0, 0.0, shift[2]]),
            record(&[a * scale[0], b * scale[1]]),
        ),
        20 => {
            let sheets = 1 + rng.below(2);
            let numbers = |k: [f64; 3]| text(&[a * k[0], b * k[1], c * k[2]]);
            (
                format!("20 20 {} {sheets}\n", numbers([1.0; 3])) + &placed(mirrored, still),
                format!("20 20 {} {sheets}\n", numbers(scale)),
            )
        }
        _ => (
            record(&[a, b]) + &placed(scale, still),
            record(
                &[a, b]
                    .map(|x| x / scale[1].sqrt())
                    .iter()
                    .enumerate()
                    .map(|(i, x)| x * scale[2 * i])
                    .collect::<Vec<f64>>(),
            ),
        ),
    }
}

/// A picture of 40 × 30 pixels, linear.
fn picture(records: &str, material: &str) -> Vec<[f32; 3]> {
    let scene = format!(
        "{records}{material}21 4 0 1 0 3\n22 -101 20 21\n10 -501 0.4 1 7  -0.05 -0.15 -1  0 1 0  40\n\
         40 -402 0.7\n40 -1 3 4 5\n41 -402 0.4\n41 -1 -4 1 -6\n42 -401 0.1\n\
         1 9999 22 0 -9 -9 -9 9 9 9\n"
    );
    let loaded = Analysis::new("scene.zpg", scene.clone().into());
    let wrong = loaded
        .findings()
        .iter()
        .find(|d| d.code.as_str().starts_with('E'));
    assert!(wrong.is_none(), "{scene}{wrong:?}");
    let settings = Settings {
        width: 40,
        height: 30,
        ..Settings::default()
    };
    let tracer = Tracer::new(&loaded.scene).unwrap();
    let camera = selected_camera(&loaded.scene, 4.0 / 3.0);
    let picture = tracer.render(&camera, &settings, || ()).unwrap();
    picture.film.pixels
}

#[test]
fn transformed_and_written_out_draw_the_same() {
    let mut rng = Rng::new(61);
    let mut shown = [0; 22];
    for round in 0..5 * 21 {
        let ty = 1 + round % 21;
        let (transformed, written) = pair(&mut rng, ty);
        let material = match round / 21 {
            0 | 1 => "",
            2 => "20 -201 0.5 0.5 0\n",
            // Surfaces have no refraction.
            _ => "20 -201 0.1 0.2 0.7\n20 -203 1.5 1.5 1.5\n",
        };
        let (a, b) = (picture(&transformed, material), picture(&written, material));
        let differ = a
            .iter()
            .zip(&b)
            .filter(|(a, b)| (0..3).any(|i| (a[i] - b[i]).abs() > 1e-4));
        let differ = differ.count();
        // A pixel's ray may pass an edge within rounding, or be bent by a stretch of it.
        assert!(
            differ <= 1,
            "{differ} pixels:\n{transformed}\n{written}{material}"
        );
        let empty = picture("20 11 0 0 0 0.001\n", material);
        let seen = a.iter().zip(&empty).filter(|(a, b)| a != b).count();
        shown[ty as usize] += seen;
    }
    assert!(shown[1..].iter().all(|n| *n > 100), "{shown:?}");
}

/// The example that was found: the normal is on one side of the triangle before it is stretched and on
/// the other one after.
#[test]
fn a_stretched_triangle_is_dark_where_the_written_one_is() {
    let scene = |triangle: &str| {
        let text = format!(
            "{triangle}10 -501 3 0.3 3 -0.9 0 -1 0 1 0 20\n12 -402 1\n12 -1 5 1 -2\n1 9999 20 0\n"
        );
        let loaded = Analysis::new("scene.zpg", text.into());
        let settings = Settings {
            width: 20,
            height: 15,
            ..Settings::default()
        };
        let tracer = Tracer::new(&loaded.scene).unwrap();
        let camera = selected_camera(&loaded.scene, 4.0 / 3.0);
        tracer
            .render(&camera, &settings, || ())
            .unwrap()
            .film
            .pixel(10, 7)
    };
    let stretched = scene("20 7 0 0 0 0 1 0 1 0 -1 1 0 -0.9\n20 -3 1 1 0.5\n");
    let written = scene("20 7 0 0 0 0 1 0 1 0 -0.5 1 0 -1.8\n");
    assert_eq!(stretched, [0.0; 3]);
    assert_eq!(written, [0.0; 3]);
}
