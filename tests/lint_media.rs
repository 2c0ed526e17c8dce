//! W307 and W318 against the tracer: an index that is said to have no effect has none, and parts of which nothing is
//! said look as the intersection and both differences do.

use std::fmt::Write as _;

use super::support::{cases, seeds};
use super::trace_support::small;
use crate::rng::Rng;
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::{Code, Diagnostic};
use zpg::internals::trace::{Tracer, selected_camera};

const WIDTH: u32 = 25;
const HEIGHT: u32 = 19;

fn read(text: &str) -> Analysis {
    let analysis = Analysis::new("scene.zpg", text.as_bytes().to_vec());
    assert!(analysis.is_sound(), "{text}\n{:?}", analysis.findings());
    analysis
}

/// The picture of a scene, as bits.
fn picture(text: &str) -> Vec<[u32; 3]> {
    let scene = read(text).scene;
    let tracer = Tracer::new(&scene).unwrap();
    let camera = selected_camera(&scene, f64::from(WIDTH) / f64::from(HEIGHT));
    let settings = small(WIDTH, HEIGHT);
    let picture = tracer.render(&camera, &settings, || ()).unwrap();
    (picture.film.pixels.iter())
        .map(|p| p.map(f32::to_bits))
        .collect()
}

/// A number with a digit behind the point.
fn tenth(rng: &mut Rng, low: f64, high: f64) -> f64 {
    (rng.range(low, high) * 10.0).round() / 10.0
}

/// A scene of a few solids and sheets that overlap, touch and lie within each other, of all operations, properties
/// given to parts and to wholes, and now and then a camera within, or a box that cuts.
fn overlapping(rng: &mut Rng) -> String {
    let mut out = String::new();
    let bodies = 2 + rng.below(4);
    let mut objects: Vec<usize> = Vec::new();
    // Things may also be far from each other.
    let wide = *rng.pick(&[1.0, 1.0, 4.0]);
    for id in 10..10 + bodies {
        let s = *rng.pick(&[0.5, 1.0, 1.5]);
        let body = match rng.below(10) {
            0..=2 => format!("9 {s}"),
            3 | 4 => format!("12 -{s} -{s} -{s} {s} {s} {s}"),
            5 => format!("10 {s} 0.8 {s}"),
            6 => format!("1 2 {s} -{s} {s} {s}"),
            7 => format!("14 1 {}", s / 2.0),
            8 => format!("5 -{s} -{s} {s} {s}"),
            _ => format!("7 -{s} -1 0 {s} -1 0 0 1 0 0.5 0.3 1"),
        };
        writeln!(out, "{id} {body}").unwrap();
        let place: Vec<String> = (0..3)
            .map(|_| (wide * *rng.pick(&[-1.0, -0.5, 0.0, 0.5, 1.0])).to_string())
            .collect();
        writeln!(out, "{id} -1 {}", place.join(" ")).unwrap();
        properties(rng, &mut out, id);
        objects.push(id);
    }
    let mut next = 10 + bodies;
    while objects.len() > 1 {
        let a = objects.swap_remove(rng.below(objects.len()));
        let b = objects.swap_remove(rng.below(objects.len()));
        let operation = *rng.pick(&[-101, -101, -101, -102, -103]);
        writeln!(out, "{next} {operation} {a} {b}").unwrap();
        if rng.chance(0.1) {
            writeln!(out, "{} -104 {next}", next + 1).unwrap();
            writeln!(out, "{} -104 {}", next + 2, next + 1).unwrap();
            next += 2;
        }
        if rng.chance(0.4) {
            properties(rng, &mut out, next);
        }
        objects.push(next);
        next += 1;
    }
    let eye = match rng.below(6) {
        0 => [tenth(rng, -1.0, 1.0), tenth(rng, -1.0, 1.0), 0.3],
        _ => [0.4, 0.9, 4.0 + 2.0 * wide],
    };
    let clip = match rng.below(5) {
        0 => " -1.2 -1.1 -2 1.3 0.4 0.7",
        _ => "",
    };
    writeln!(
        out,
        "4 -501 {} {} {} -0.05 -0.1 -1 0 1 0 50",
        eye[0], eye[1], eye[2]
    )
    .unwrap();
    writeln!(
        out,
        "5 -402 0.8\n5 -1 3 5 4\n6 -401 0.3\n7 -701 0.2 0.3 0.5"
    )
    .unwrap();
    writeln!(out, "1 9999 {} 7{clip}", objects[0]).unwrap();
    out
}

/// Now and then a colour, an optical property and an index, glass among them.
fn properties(rng: &mut Rng, out: &mut String, id: usize) {
    if rng.chance(0.7) {
        let optics = *rng.pick(&["0.7 0 0", "0.5 0.4 0", "0.1 0.1 0.8", "0 0 1", "0.6 0 0"]);
        writeln!(out, "{id} -201 {optics}").unwrap();
    }
    if rng.chance(0.5) {
        let index = *rng.pick(&["1.5 1.5 1.5", "1.3 1.35 1.4", "2 2 2"]);
        writeln!(out, "{id} -203 {index}").unwrap();
    }
    if rng.chance(0.5) {
        let colour = *rng.pick(&["1 0.2 0.1", "0.1 0.9 0.3", "0.3 0.4 1"]);
        writeln!(out, "{id} -701 {colour}").unwrap();
    }
}

/// A picture is the same to the bit whatever an index is that is said to have no effect.
#[test]
fn an_index_without_effect_has_none() {
    let (mut scenes, mut claims) = (0, 0);
    for seed in seeds("MEDIA", cases(0..300, 0..6000)) {
        let text = overlapping(&mut Rng::new(seed));
        let analysis = read(&text);
        let said = |d: &&Diagnostic| d.code == Code::W318 && d.case.is_empty();
        let lines: Vec<usize> = (analysis.findings().iter().filter(said))
            .map(|d| analysis.source.line_index(d.span.start))
            .collect();
        scenes += 1;
        claims += lines.len();
        if lines.is_empty() {
            continue;
        }
        let expected = picture(&text);
        for index in ["1 1 1", "2.5 1.2 1.7"] {
            let other: String = (text.lines().enumerate())
                .map(|(i, line)| match lines.contains(&i) {
                    true => format!("{} -203 {index}\n", line.split(' ').next().unwrap()),
                    false => format!("{line}\n"),
                })
                .collect();
            assert!(
                picture(&other) == expected,
                "seed {seed}: {lines:?}\n{text}"
            );
        }
    }
    // The rule still speaks: of scenes without glass, and of what is away from glass.
    assert!(claims * 8 > scenes, "{claims} claims in {scenes} scenes");
}

/// A solid around the origin, as it is written, and the radii of a ball within it and of one around it.
fn solid(kind: usize, s: f64) -> (String, f64, f64) {
    match kind {
        0 => (format!("9 {s}"), s, s),
        1 => (format!("12 -{s} -{s} -{s} {s} {s} {s}"), s, s * 3f64.sqrt()),
        2 => (format!("10 {s} {} {s}", 0.8 * s), 0.8 * s, s),
        _ => (format!("1 2 {s} -{s} {s} {s}"), s, s * 2f64.sqrt()),
    }
}

/// Solids within each other, of different media, the innermost first: their records. `out`: how far the innermost
/// reaches out of the next one.
fn nest(rng: &mut Rng, count: usize, out: Option<f64>) -> String {
    let mut text = String::new();
    let mut bodies: Vec<(String, f64, f64)> = Vec::new();
    let mut room = 2.0;
    for k in 0..count {
        // What reaches out does so of a ball.
        let kind = if k == 0 && out.is_some() {
            0
        } else {
            rng.below(4)
        };
        let (_, _, around) = solid(kind, 1.0);
        let (body, within, around) = solid(kind, room / around);
        bodies.push((body, within, around));
        room = 0.8 * within;
    }
    bodies.reverse();
    let mut place = [0.0; 3];
    // Each one has its place in the next one.
    for (k, (body, within, around)) in bodies.iter().enumerate().rev() {
        let id = 10 + k;
        writeln!(text, "{id} {body}").unwrap();
        writeln!(text, "{id} -2 {} {}", rng.below(90), 1 + rng.below(3)).unwrap();
        let next = bodies.get(k + 1);
        // As far from the middle as there is room, or further.
        let far = match (next, out) {
            (Some(next), Some(out)) if k == 0 => next.2 + (out - 1.0) * within,
            (Some(next), _) => 0.9 * (next.1 - around),
            (None, _) => 0.0,
        };
        place[rng.below(3)] += far;
        writeln!(text, "{id} -1 {} {} {}", place[0], place[1], place[2]).unwrap();
        let (optics, index) = match (k, rng.below(3)) {
            (0, 0) => ("0.8 0.1 0", "1 1 1"),
            _ => (
                "0.1 0.1 0.8",
                ["1.5 1.5 1.5", "1.3 1.3 1.3", "1.7 1.7 1.7"][k % 3],
            ),
        };
        writeln!(text, "{id} -201 {optics}\n{id} -203 {index}").unwrap();
    }
    text
}

const VIEW: &str = "4 -501 0.4 0.9 7 -0.05 -0.1 -1 0 1 0 45\n5 -402 0.8\n5 -1 3 5 6\n6 -401 0.3\n7 -701 0.2 0.3 0.5\n";

fn drawn(bodies: &str, operations: &str, root: usize) -> String {
    format!("{bodies}{operations}{VIEW}1 9999 {root} 7\n")
}

fn overlaps(text: &str) -> usize {
    let is_one = |d: &&Diagnostic| d.code == Code::W307;
    read(text).findings().iter().filter(is_one).count()
}

/// Nothing is said of solids within each other that are written from the inside out, and the picture is that of
/// (A ∩ B) ∪ ((A − B) ∪ (B − A)).
#[test]
fn parts_within_each_other_are_written_from_the_inside_out() {
    for seed in seeds("MEDIA", cases(0..40, 0..1000)) {
        let mut rng = Rng::new(seed);
        let count = 2 + rng.below(2);
        let bodies = nest(&mut rng, count, None);
        let (mut unions, mut explicit) = (String::new(), String::new());
        let (mut id, mut of_explicit) = (10, 10);
        for k in 1..count {
            let next = 20 + 10 * k;
            writeln!(unions, "{next} -101 {id} {}", 10 + k).unwrap();
            let (a, b) = (of_explicit, 10 + k);
            writeln!(
                explicit,
                "{} -102 {a} {b}\n{} -103 {a} {b}\n{} -103 {b} {a}\n{} -101 {} {}\n{} -101 {} {}",
                next + 1,
                next + 2,
                next + 3,
                next + 4,
                next + 2,
                next + 3,
                next + 5,
                next + 1,
                next + 4
            )
            .unwrap();
            (id, of_explicit) = (next, next + 5);
        }
        let text = drawn(&bodies, &unions, id);
        assert_eq!(overlaps(&text), 0, "seed {seed}\n{text}");
        let other = drawn(&bodies, &explicit, of_explicit);
        assert!(
            picture(&text) == picture(&other),
            "seed {seed}\n{text}\n{other}"
        );
    }
}

/// It speaks where the outer one is first, and where the inner one reaches out.
#[test]
fn parts_within_each_other_in_another_order() {
    for seed in seeds("MEDIA", cases(0..40, 0..1000)) {
        let mut rng = Rng::new(seed);
        let bodies = nest(&mut rng, 3, None);
        let [a, b, c] = *rng.pick(&[
            [10, 12, 11],
            [11, 10, 12],
            [11, 12, 10],
            [12, 10, 11],
            [12, 11, 10],
        ]);
        let text = drawn(&bodies, &format!("20 -101 {a} {b}\n21 -101 20 {c}\n"), 21);
        assert!(overlaps(&text) > 0, "seed {seed}\n{text}");
        let share = *rng.pick(&[0.003, 0.03, 0.3]);
        let bodies = nest(&mut rng, 2, Some(share));
        let text = drawn(&bodies, "20 -101 10 11\n", 20);
        assert_eq!(overlaps(&text), 1, "seed {seed}\n{text}");
    }
}
