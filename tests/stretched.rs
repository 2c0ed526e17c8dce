//! Needles, sheets and what is small and far away: crossings, normals and surface coordinates where the terms of a
//! quadric cancel. The right answers were computed in rational arithmetic from the doubles as they are.

use crate::support::program::{folder, text, zpg};
use serde_json::Value;
use zpg::geometry::dd::Dd;
use zpg::geometry::line::{Line, Traced};
use zpg::geometry::vec::Vec3;
use zpg::scene::Geometry;
use zpg::trace::shapes::{Primitive, Roots};

const NEEDLE: [f64; 16] = [
    1e8, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1e8, 0.0, 0.0, 0.0, 0.0, -1.0,
];
const SHEET: [f64; 16] = [
    1.0, 0.0, 0.0, 0.0, 0.0, 1e16, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0,
];
/// Of radius 1/32, about (1000, 0, 0).
const BALL: [f64; 16] = [
    1.0,
    0.0,
    0.0,
    -1000.0,
    0.0,
    1.0,
    0.0,
    0.0,
    0.0,
    0.0,
    1.0,
    0.0,
    -1000.0,
    0.0,
    0.0,
    1e6 - 1.0 / 1024.0,
];

/// A quadric, the two points of a line, and where the line crosses it.
type Known = ([f64; 16], [f64; 3], [f64; 3], [f64; 2]);

#[allow(clippy::excessive_precision)]
const KNOWN: [Known; 3] = [
    (
        NEEDLE,
        [0.8485420081224309, 2.761100563884834, -0.8101235316705764],
        [-0.8487110578222483, -1.7877988797343614, 0.8102789367175587],
        [0.999785273107785991871, 0.999823433795780258094],
    ),
    (
        SHEET,
        [0.3, 2.5, 0.4],
        [0.1, -1.7, 0.05],
        [1.470588230830081057697, 1.470588239758154308521],
    ),
    (
        BALL,
        [3.0, 4.0, 5.0],
        [997.0, -4.01, -4.99],
        [0.999972059709886077447, 1.000027960007432357645],
    ),
];

fn length(v: [f64; 3]) -> f64 {
    v.into_iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn crossings<R: Traced>(q: [f64; 16], origin: [f64; 3], direction: [f64; 3]) -> Roots<R> {
    let shape = Primitive::new(&Geometry::Quadric(Box::new(q)));
    let mut roots = Roots::default();
    let line = Line::new(Vec3(origin).cast(), Vec3(direction).cast());
    shape.intersect().crossings(&line, &mut roots);
    roots
}

/// Even along the line, where a slanted crossing is farther off than from the surface, none is off by more than 4 ε.
#[test]
fn crossings_are_where_they_are() {
    for (q, origin, direction, known) in KNOWN {
        let most = 4.0 * f64::EPSILON * length(origin).max(1.0) / length(direction);
        // Beside the rounding of t itself.
        let most = most + f64::EPSILON;
        let doubles = crossings::<f64>(q, origin, direction);
        assert!(!doubles.uncertain, "{q:?}");
        let finer = crossings::<Dd>(q, origin, direction);
        let both = [
            doubles.list.iter().map(|root| root.t).collect::<Vec<_>>(),
            finer.cast::<f64>().list.iter().map(|root| root.t).collect(),
        ];
        for found in both {
            assert_eq!(found.len(), 2);
            for (t, meant) in found.iter().zip(known) {
                assert!((t - meant).abs() <= most, "{q:?}: {t:e}, not {meant:e}");
            }
        }
    }
}

/// A number of an answer; double-double is written as text.
fn number(value: &Value) -> f64 {
    let text = value.as_str().and_then(|text| text.parse().ok());
    value.as_f64().or(text).expect("a number")
}

/// A needle 10⁻⁴ thick bends within 10⁻⁴: normals are known to 10⁴ times what points are.
#[test]
fn a_probe_of_a_needle() {
    let words = NEEDLE.map(|x| x.to_string()).join(" ");
    let scene = format!("10 15 {words}\n2 -501 0 0 9 0 0 -1 0 1 0 45\n3 -401 1\n1 9999 10 0\n");
    let dir = folder(&[("a.zpg", &scene)]);
    let (_, origin, direction, known) = KNOWN[0];
    let ray = [origin, direction]
        .concat()
        .iter()
        .map(f64::to_string)
        .collect::<Vec<_>>()
        .join(" ");
    let meant = [
        (
            [
                0.5788346361395663,
                0.0004272506679799491,
                -0.8154448365536706,
            ],
            [0.1517538262684282, 0.9736855726478215],
        ),
        (
            [
                -0.8412406137350341,
                0.0004266753675714313,
                0.5406607510730124,
            ],
            [0.5909128714467923, 0.9736173490125755],
        ),
    ];
    for precision in ["f64", "dd"] {
        let arguments = ["probe", "a.zpg", "--precision", precision, "--ray", &ray];
        let out = zpg(dir.path(), &arguments, "");
        let answer: Value = serde_json::from_str(&text(&out.stdout)).expect("an answer");
        let hits = answer["hits"].as_array().expect("hits");
        assert_eq!(hits.len(), 2, "{answer}");
        for ((hit, t), (normal, uv)) in hits.iter().zip(known).zip(meant) {
            let is = |key: &str, i: usize| number(&hit[key][i]);
            let off = |key: &str, i: usize, meant: f64| (is(key, i) - meant).abs();
            assert!((number(&hit["t"]) - t).abs() < 2e-15, "{hit}");
            assert!((0..3).all(|i| off("normal", i, normal[i]) < 4e-11), "{hit}");
            assert!(
                off("uv", 0, uv[0]) < 1e-11 && off("uv", 1, uv[1]) < 4e-15,
                "{hit}"
            );
        }
    }
}
