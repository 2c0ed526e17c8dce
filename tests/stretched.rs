//! Needles, sheets and what is small and far away: crossings, normals and surface coordinates where the terms of a
//! quadric cancel. The right answers were computed in rational arithmetic from the doubles as they are.

use crate::support::program::{folder, text, zpg};
use crate::trace_support::Random;
use serde_json::Value;
use zpg::internals::geometry::affine::Affine;
use zpg::internals::geometry::dd::Dd;
use zpg::internals::geometry::line::{Line, Traced};
use zpg::internals::geometry::number::Real;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Geometry;
use zpg::internals::trace::shapes::{Primitive, Roots};

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
        let out = zpg(dir.path(), &arguments);
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

/// A ball behind a map from the line's space into its own, and where the line crosses it.
struct Pressed {
    radius: f64,
    map: [[f64; 4]; 3],
    origin: [f64; 3],
    direction: [f64; 3],
    known: [f64; 2],
}

/// The direction nearly vanishes under the map; doubles place the crossings 50 to 1 000 ε wrong.
#[allow(clippy::excessive_precision)]
const PRESSED: [Pressed; 3] = [
    Pressed {
        radius: 39861.7396314341,
        map: [
            [
                -50227.84821100918,
                245377.1499732914,
                140168.89235408878,
                557928.4510738859,
            ],
            [
                -6.819335832080277,
                -0.22024330540344322,
                -2.0580735543253725,
                117.09687285946944,
            ],
            [
                -0.006103792635306575,
                -0.013636108550995984,
                0.021683905978896807,
                -0.5222596994241739,
            ],
        ],
        origin: [30.820804914977764, 33.24742336998626, -51.13850433117139],
        direction: [
            -7.413185178714269e-5,
            -0.0001710978928849403,
            0.00027295674348011095,
        ],
        known: [-1588697195.481822364094, 1589219377.6171855864597],
    },
    Pressed {
        radius: 273988.7440834861,
        map: [
            [
                -0.0011616389372059415,
                0.000287950028070365,
                0.0014111153449126465,
                6005.364947195125,
            ],
            [
                -2.226994169027611,
                -4.293410865420907,
                -0.9571686434613288,
                -48875.452423326205,
            ],
            [
                1.017372372881787e-5,
                -7.484745740393054e-6,
                9.902398422774994e-6,
                5.295269266112502,
            ],
        ],
        origin: [1839904.4918064314, -371501.34266092913, -2665490.364149112],
        direction: [-13402.893897735794, 9828.492913315815, -12902.502226672666],
        known: [-572736.1809247616360401, 572738.54876818623889612],
    },
    Pressed {
        radius: 319.10693082552956,
        map: [
            [
                0.046975836962737154,
                0.0039024967658903295,
                0.01695144751171383,
                8924.130452028687,
            ],
            [
                -1.2829906828565954e-7,
                5.063816312134059e-7,
                2.3896504610254917e-7,
                -0.08057772226089477,
            ],
            [
                -0.008821288388096168,
                -0.01544946472117712,
                0.02800226298678085,
                9778.47910668073,
            ],
        ],
        origin: [-151506.44115589568, 371297.3189828611, -192075.03331223928],
        direction: [842.6708503445174, -3325.8771811684464, -1569.5781166138215],
        known: [-101791.8700290249065181, 101866.59657260200759338],
    },
];

fn pressed<R: Traced>(known: &Pressed) -> Roots<R> {
    let rows = known.map.map(|[x, y, z, _]| Vec3([x, y, z]).cast());
    let map = Affine::of(rows, Vec3(known.map.map(|row| row[3])).cast());
    let line = Line::new(Vec3(known.origin).cast(), Vec3(known.direction).cast()).through(&map);
    let shape = Primitive::new(&Geometry::Sphere {
        centre: [0.0; 3],
        radius: known.radius,
    });
    let mut roots = Roots::default();
    shape.intersect().crossings(&line, &mut roots);
    roots.doubt_blurred(&line);
    roots
}

/// What a map has pressed to nothing is asked for in double-double, which knows it to the last digit.
#[test]
fn a_direction_that_nearly_vanishes_is_doubted() {
    for known in &PRESSED {
        let doubles = pressed::<f64>(known);
        assert!(doubles.uncertain && doubles.coarse, "{doubles:?}");
        let finer = pressed::<Dd>(known);
        assert!(!finer.uncertain, "{finer:?}");
        let found: Vec<f64> = finer.list.iter().map(|root| root.t.to_f64()).collect();
        for (t, meant) in found.iter().zip(known.known) {
            assert!(
                (t - meant).abs() <= 2.0 * f64::EPSILON * meant.abs(),
                "{t:e}, not {meant:e}"
            );
        }
        assert_eq!(found.len(), 2);
    }
}

/// A turn, from near and far, is no reason for doubt.
#[test]
fn turns_are_not_doubted() {
    let mut random = Random(5);
    for _ in 0..10_000 {
        let (a, b) = (random.point(1.0).unit(), random.point(1.0));
        let b = (b - a * a.dot(b)).unit();
        let map = Affine::of([a, b, a.cross(b)], random.point(10.0));
        let away = 10f64.powf(random.within(0.0, 8.0));
        let origin = random.point(1.0).unit() * away;
        let line: Line = Line::new(origin, random.point(0.5) - origin);
        let line = line.through(&map);
        for t in [0.1, 0.9, 1.0, 1.1, 20.0] {
            assert!(!line.is_blurred_at(t, 32.0), "{line:?} {t}");
        }
    }
}
