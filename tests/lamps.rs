//! Lamps that lie on surfaces: random shapes in random places, alone, cut, joined and of glass, with the lamp where the
//! shape's own definition has its surface.

use crate::support::povray;
use crate::trace_support::*;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use zpg::internals::analysis::Analysis;
use zpg::internals::scene::Scene;
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::study::naive::{Naive, Wide};
use zpg::internals::trace::{Images, Numbers, Picture, Settings, members, selected_camera};
use zpg::internals::translate::pov::{self, Options};

const SIZE: [u32; 2] = [32, 24];
/// Linear values may differ by so much.
const MAX_DIFFERENCE: f32 = 1e-4;
/// Outside of a surface, in scenes of size 1 to 10: more than the share of the way to a lamp that counts as the lamp.
const OFF_SURFACE: f64 = 1e-7;
/// Surely inside.
const INSIDE: f64 = -1e-5;

fn add(a: [f64; 3], b: [f64; 3], by: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + by * b[i])
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!(" {x:?}")).collect()
}

/// A shape, as its record has it, with a point of its surface and a direction outwards there.
struct Spot {
    record: String,
    point: [f64; 3],
    outwards: [f64; 3],
    is_solid: bool,
}

/// Kinds of spots.
const KINDS: u64 = 16;

fn spot(kind: u64, r: &mut Random) -> Spot {
    let size = r.within(0.6, 1.2);
    let turn = r.within(0.0, TAU);
    let (sin, cos) = turn.sin_cos();
    let rise = r.within(-0.9, 0.9);
    let flat = f64::sqrt(1.0 - rise * rise);
    let way = [flat * cos, rise, flat * sin];
    let half = [0; 3].map(|_| r.within(0.4, 1.1));
    let solid = |record: String, point, outwards| Spot {
        record,
        point,
        outwards,
        is_solid: true,
    };
    let sheet = |record: String, point, outwards| Spot {
        is_solid: false,
        ..solid(record, point, outwards)
    };
    match kind {
        0 => {
            let c = [0; 3].map(|_| r.within(-0.3, 0.3));
            let record = format!("11{}", words(&[c[0], c[1], c[2], size]));
            solid(record, add(c, way, size), way)
        }
        // The very lowest point, in numbers that are exact.
        1 => solid("11 0 1 0 1".into(), [0.0; 3], [0.0, -1.0, 0.0]),
        // A face, an edge and a corner of a box.
        2..=4 => {
            let mut outwards = [0.0; 3];
            let mut point = half.map(|h| h * r.within(-0.9, 0.9));
            for i in 0..(kind - 1) as usize {
                let sign = if r.below(2) == 0 { -1.0 } else { 1.0 };
                (point[i], outwards[i]) = (half[i] * sign, sign);
            }
            let [x, y, z] = half;
            solid(
                format!("12{}", words(&[-x, -y, -z, x, y, z])),
                point,
                outwards,
            )
        }
        // Through the origin, and elsewhere.
        5 => solid("4 0 1 0 0".into(), [0.3, 0.0, -0.2], [0.0, 1.0, 0.0]),
        6 => {
            let record = format!("4{}", words(&[way[0], way[1], way[2], -size]));
            solid(record, add([0.0; 3], way, size), way)
        }
        7 => {
            let point = [half[0] * way[0], half[1] * way[1], half[2] * way[2]];
            let outwards = [0, 1, 2].map(|i| way[i] / half[i]);
            solid(format!("10{}", words(&half)), point, outwards)
        }
        // The side of a cone, and its apex.
        8 => {
            let y = r.within(0.2, 0.8);
            let record = format!("16{}", words(&[size, half[0]]));
            let around = half[0] * y;
            let point = [around * cos, size * y, around * sin];
            solid(record, point, [size * cos, -half[0], size * sin])
        }
        9 => solid(
            format!("16{}", words(&[size, half[0]])),
            [0.0; 3],
            [0.0, -1.0, 0.0],
        ),
        10 => {
            // Once around the tube, the inner side too.
            let (s, c) = r.within(0.0, TAU).sin_cos();
            let tube = r.within(0.1, 0.4);
            let outwards = [c * cos, s, c * sin];
            let ring = [size * cos, 0.0, size * sin];
            let record = format!("14{}", words(&[size, tube]));
            solid(record, add(ring, outwards, tube), outwards)
        }
        11 => {
            // x²/a² + z²/b² = y
            let [a, b, _] = half;
            let q = [
                1.0 / (a * a),
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                -0.5,
                0.0,
                0.0,
                1.0 / (b * b),
                0.0,
                0.0,
                -0.5,
                0.0,
                0.0,
            ];
            let (x, z) = (a * way[0], b * way[2]);
            let point = [x, x * x * q[0] + z * z * q[10], z];
            let outwards = [2.0 * x * q[0], -1.0, 2.0 * z * q[10]];
            solid(format!("15{}", words(&q)), point, outwards)
        }
        12 => {
            // The inner wall of a bowl, halfway up.
            let record = format!(
                "1 4{}",
                words(&[0.2, 0.0, size, 1.0, size + 0.2, 1.0, 0.4, -0.2])
            );
            let around = (0.2 + size) / 2.0;
            let point = [around * cos, 0.5, around * sin];
            solid(record, point, [-cos, size - 0.2, -sin])
        }
        13 => {
            let record = format!("5{}", words(&[-half[0], -half[1], half[0], half[1]]));
            sheet(record, [0.3 * half[0], -0.2, 0.0], [0.0, 0.0, 1.0])
        }
        14 => {
            let record = format!(
                "6{}",
                words(&[0.0, 0.0, 0.0, size, 0.1, 0.2, -0.2, size, 0.1])
            );
            // A third of the two edges each.
            let point = [(size - 0.2) / 3.0, (size + 0.1) / 3.0, 0.3 / 3.0];
            let outwards = [
                0.1 * 0.1 - 0.2 * size,
                -0.2 * 0.2 - size * 0.1,
                size * size + 0.02,
            ];
            sheet(record, point, outwards)
        }
        _ => {
            let record = format!("3{}", words(&[way[0], way[1], way[2], -size]));
            sheet(record, add([0.0; 3], way, size), way)
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Whole {
    Alone,
    CutBySomethingLarge,
    WithAHole,
    Glass,
}

/// A scene with the lamp so far off the surface, outwards.
fn text(spot: &Spot, whole: Whole, seed: u64, off: f64) -> String {
    let mut r = Random(seed);
    let lamp = add(spot.point, spot.outwards, off);
    let mut out = format!("2 {}\n7 -402 0.9\n7 -1{}\n", spot.record, words(&lamp));
    let way = [0; 3].map(|_| r.within(0.7, 1.4));
    let moves = match r.below(4) {
        0 => String::new(),
        1 => format!("-1{}", words(&[0; 3].map(|_| r.within(-0.5, 0.5)))),
        2 => format!("-2 {:?} {}", r.within(-180.0, 180.0), 1 + r.below(3)),
        _ => format!("-3{}", words(&way)),
    };
    let turn = format!("-2 {:?} {}", r.within(-180.0, 180.0), 1 + r.below(3));
    let (object, tool) = match whole {
        Whole::Alone => (2, ""),
        Whole::CutBySomethingLarge => (4, "3 11 0 0 0 9\n4 -102 2 3\n"),
        Whole::WithAHole => (4, "3 11 7 -7 0 0.9\n4 -103 2 3\n"),
        Whole::Glass => (2, "2 -201 0.2 0.1 0.6\n"),
    };
    out += tool;
    for id in [object, 7] {
        for change in [&moves, &turn] {
            if !change.is_empty() {
                let _ = writeln!(out, "{id} {change}");
            }
        }
    }
    // A room around it, open in front, and something else in the way.
    out += "10 12 -5 -5 -5 5 -4 9\n11 12 -5 -5 -5 -4 5 9\n12 12 -5 -5 -5 5 5 -4\n13 11 2.4 -1.1 0.7 0.6\n";
    out += "14 12 4 -5 -5 5 5 9\n15 12 -5 4 -5 5 5 9\n";
    let mut last = object;
    for (id, part) in (20..).zip([10, 11, 12, 13, 14, 15]) {
        let _ = writeln!(out, "{id} -101 {last} {part}");
        last = id;
    }
    let eye = [r.within(-2.0, 2.0), r.within(-2.0, 2.0), 8.5];
    let aim = add([0.0; 3], eye, -1.0);
    let _ = writeln!(out, "8 -501{}{} 0 1 0 60", words(&eye), words(&aim));
    let _ = writeln!(out, "1 9999 {last} 0");
    out
}

fn resolved(text: &str) -> Scene {
    let analysis = Analysis::new("scene.zpg", text.as_bytes().to_vec());
    assert!(analysis.is_sound(), "{text}\n{:?}", analysis.findings());
    analysis.scene
}

fn drawn(scene: &Scene, numbers: Numbers) -> Picture {
    let settings = Settings {
        numbers,
        cutoff: 0.0,
        ..small(SIZE[0], SIZE[1])
    };
    picture(scene, &settings)
}

/// In how many pixels two pictures differ.
fn unlike(a: &Picture, b: &Picture, most: f32) -> usize {
    let pixels = a.film.pixels.iter().zip(&b.film.pixels);
    let far = |(a, b): &(&[f32; 3], &[f32; 3])| (0..3).any(|c| (a[c] - b[c]).abs() > most);
    pixels.filter(far).count()
}

/// All kinds of surfaces in all kinds of wholes.
fn each_case(mut check: impl FnMut(&Spot, Whole, u64)) {
    let wholes = [
        Whole::Alone,
        Whole::CutBySomethingLarge,
        Whole::WithAHole,
        Whole::Glass,
    ];
    for seed in 0..2 * KINDS {
        let mut r = Random(1000 * seed);
        let spot = spot(seed % KINDS, &mut r);
        check(&spot, wholes[((seed + seed / KINDS) % 4) as usize], seed);
    }
}

/// Doubles, double-double and the independent evaluator draw one picture.
#[test]
fn lamps_on_surfaces_look_the_same_in_all_numbers() {
    let images = Images::default();
    let mut lit = 0;
    each_case(|spot, whole, seed| {
        let text = text(spot, whole, seed, 0.0);
        let scene = resolved(&text);
        let [double, fine] = [Numbers::F64, Numbers::Dd].map(|n| drawn(&scene, n));
        assert_eq!(unlike(&double, &fine, 1e-5), 0, "{text}");
        let camera = selected_camera(&scene, 4.0 / 3.0);
        let naive = Naive::<Wide>::new(&scene, &images, &camera, SIZE, 10, 0.0).unwrap();
        let places: Vec<[u32; 2]> = (0..SIZE[0] * SIZE[1])
            .skip(seed as usize % 11)
            .step_by(11)
            .map(|i| [i % SIZE[0], i / SIZE[0]])
            .collect();
        for (sample, [x, y]) in naive.pixels(&places).unwrap().iter().zip(&places) {
            let ours = double.film.pixel(*x, *y);
            let off = (0..3).map(|c| (f64::from(ours[c]) - sample.colour[c]).abs());
            assert!(off.fold(0.0, f64::max) < 1e-6, "{x} {y}\n{text}");
        }
        lit += double.film.pixels.iter().filter(|p| p[0] > 0.01).count();
    });
    // Of each scene a part is lit.
    assert!(lit > 32 * 150, "{lit}");
}

/// A lamp on a solid lights what it lights a hair outside of it, and on a sheet both what it lights on the one side and on
/// the other. A hair inside of an opaque solid it lights nothing of the room.
#[test]
fn a_lamp_on_a_surface_lights_the_outer_side() {
    let mut compared = 0;
    each_case(|spot, whole, seed| {
        if whole == Whole::Glass {
            // There the way out of the glass, at the lamp, takes light away.
            return;
        }
        let scene = resolved(&text(spot, whole, seed, 0.0));
        let eye = scene.cameras[0].position.into();
        if members(&scene, scene.render.unwrap().root, eye)
            .unwrap()
            .in_root
        {
            // It sees what a lamp lights inside.
            return;
        }
        compared += 1;
        let inwards = if spot.is_solid { INSIDE } else { -OFF_SURFACE };
        let [on, outside, inside] = [0.0, OFF_SURFACE, inwards].map(|off| {
            let text = text(spot, whole, seed, off);
            drawn(&resolved(&text), Numbers::F64)
        });
        let mut expected = outside;
        if !spot.is_solid {
            for (a, b) in expected.film.pixels.iter_mut().zip(&inside.film.pixels) {
                *a = [0, 1, 2].map(|c| a[c].max(b[c]));
            }
        } else if ![3, 4, 9].contains(&(seed % KINDS)) {
            let most = inside
                .film
                .pixels
                .iter()
                .flatten()
                .fold(0.0, |m: f32, x| m.max(*x));
            assert!(most < 1e-6, "{most} {}", text(spot, whole, seed, INSIDE));
        }
        let apart = unlike(&on, &expected, MAX_DIFFERENCE);
        assert!(apart <= 1, "{apart} {}", text(spot, whole, seed, 0.0));
    });
    assert!(compared > 16, "{compared}");
}

/// So does POV-Ray: off edges, where its tolerances show, and except for glass that reflects totally, which it has no
/// notion of here.
#[test]
#[ignore = "needs POV-Ray"]
fn pov_ray_draws_lamps_on_surfaces() {
    let (mut compared, mut grouped) = (0, 0);
    each_case(|spot, whole, seed| {
        let text = text(spot, whole, seed, 0.0);
        let scene = resolved(&text);
        let options = Options {
            size: (SIZE[0], SIZE[1]),
            ..Options::default()
        };
        let translation =
            pov::write(&scene, &node_bounds(&scene), &options).expect("a translation");
        grouped += usize::from(translation.files[0].text.contains("light_group"));
        let theirs = povray::render(&format!("lamp-{seed}"), &translation, 0, options.size);
        let ours = drawn(&scene, Numbers::F64);
        let far = |(a, b): &(&[f32; 3], &[f64; 3])| {
            (0..3).any(|c| (f64::from(a[c]) - b[c]).abs() > 2.0 / 255.0)
        };
        let apart = (ours.film.pixels.iter().zip(&theirs.pixels)).filter(far);
        let apart = apart.count();
        assert!(apart <= 3, "{apart} {text}");
        compared += 1;
    });
    assert_eq!(grouped, compared);
}
