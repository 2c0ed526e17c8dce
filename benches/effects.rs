//! What an effect costs that is off: nothing. Of two scenes one has an effect, which is taken out of the kernel, and the
//! other one does not have it. The two pictures must be the same, the counters of both must show no work for the effect,
//! and the times may differ by the noise. See benches/README.md.

use std::fmt::Write;
use std::time::Instant;

use zpg::internals::analysis::Analysis;
use zpg::internals::study::accuracy::axes;
use zpg::internals::trace::stats::Work;
use zpg::internals::trace::{Settings, Tracer, selected_camera};

const SIZE: [u32; 2] = [240, 180];
const RUNS: usize = 21;
/// What the times of one and the same computation may differ by.
const NOISE: f64 = 0.05;

struct Case {
    effect: &'static str,
    /// What a thing is, with the effect and without.
    with: fn(u32) -> String,
    without: fn(u32) -> String,
    work: fn(&Work) -> u64,
}

/// Somewhere in a cube.
fn moved(id: u32) -> String {
    let [x, y, z] = [31, 57, 83].map(|k| f64::from(id.wrapping_mul(k) % 97) / 12.0 - 4.0);
    format!("{id} -1 {x:?} {y:?} {z:?}\n")
}

fn ball(id: u32) -> String {
    format!("{id} 9 0.6\n") + &moved(id)
}

fn facet(id: u32, normals: &str) -> String {
    let kind = if normals.is_empty() { 6 } else { 8 };
    format!("{id} {kind} 0 0 0  1.5 0 0  0 1.5 0.4 {normals}\n") + &moved(id)
}

const CASES: [Case; 5] = [
    Case {
        effect: "reflection",
        with: |id| ball(id) + &format!("{id} -201 0.6 0.4 0\n"),
        without: |id| ball(id) + &format!("{id} -201 0.6 0 0\n"),
        work: |work| work.reflection,
    },
    Case {
        effect: "refraction",
        with: |id| ball(id) + &format!("{id} -201 0.4 0 0.6\n{id} -203 1.4 1.4 1.4\n"),
        without: |id| ball(id) + &format!("{id} -201 0.4 0 0\n"),
        work: |work| work.refraction + work.transparent_shadow + work.medium_change,
    },
    Case {
        effect: "dispersion",
        with: |id| ball(id) + &format!("{id} -201 0.4 0 0.6\n{id} -203 1.4 1.5 1.6\n"),
        without: |id| ball(id) + &format!("{id} -201 0.4 0 0.6\n{id} -203 1.4 1.4 1.4\n"),
        work: |work| work.channel_split,
    },
    Case {
        effect: "textures",
        with: |id| ball(id) + &format!("{id} -299 5 0\n"),
        without: ball,
        work: |work| work.checkerboard + work.solid_texture + work.image_texture + work.uv,
    },
    Case {
        effect: "smooth-normals",
        with: |id| facet(id, "0.3 0 1  0 0.3 1  0 0 1"),
        without: |id| facet(id, ""),
        work: |work| work.smooth_normal,
    },
];

/// A scene made ready, with the effect taken out if it has it.
fn prepared(case: &Case, thing: fn(u32) -> String) -> (Tracer, zpg::internals::scene::Camera) {
    let mut text = "3 -701 0.9 0.9 0.9\n4 -701 0.2 0.3 0.4\n5 -399 8 4 3 4\n".to_owned();
    for id in 100..200 {
        text += &thing(id);
        match id {
            100 => writeln!(text, "1100 -105 100"),
            _ => writeln!(text, "{} -101 {} {id}", id + 1000, id + 999),
        }
        .expect("a string takes everything");
    }
    text +=
        "6 -402 0.8\n6 -1 8 9 12\n7 -401 0.2\n8 -501 0 0 14  0 0 -1  0 1 0  40\n1 9999 1199 0\n";
    let loaded = Analysis::new(case.effect, text.into_bytes());
    let errors: Vec<_> = loaded.findings().iter().filter(|d| d.is_error()).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let camera = selected_camera(&loaded.scene, f64::from(SIZE[0]) / f64::from(SIZE[1]));
    let mut tracer = Tracer::new(&loaded.scene).expect("the scene can be drawn");
    let effects = axes::effects(&tracer.plan);
    if let Some((_, without)) = effects.into_iter().find(|e| e.0 == case.effect) {
        tracer.graph.without = without;
    }
    (tracer, camera)
}

fn main() {
    println!("| effect that is off | taken out, ms | without it, ms | ratio | |");
    println!("|---|---:|---:|---:|---|");
    let mut missed = false;
    for case in &CASES {
        let both = [case.with, case.without].map(|thing| prepared(case, thing));
        let mut least = [f64::INFINITY; 2];
        let mut pictures = [Vec::new(), Vec::new()];
        for _ in 0..RUNS {
            for (i, (tracer, camera)) in both.iter().enumerate() {
                let [width, height] = SIZE;
                let settings = Settings {
                    width,
                    height,
                    ..Settings::default()
                };
                let drawn = tracer.pixels(camera, &settings, None, |pixels| {
                    let start = Instant::now();
                    let all: Vec<[f64; 3]> = (0..width * height)
                        .map(|p| pixels.sum(p % width, p / width, 0..1, 1))
                        .collect();
                    (start.elapsed().as_secs_f64(), all, pixels.counts().work)
                });
                let (seconds, all, work) = drawn.expect("the camera takes pictures");
                assert_eq!((case.work)(&work), 0, "{}: {work:?}", case.effect);
                least[i] = least[i].min(seconds);
                pictures[i] = all;
            }
        }
        assert_eq!(pictures[0], pictures[1], "{}", case.effect);
        let ratio = least[0] / least[1];
        let is_missed = (ratio - 1.0).abs() > NOISE;
        missed |= is_missed;
        println!(
            "| {} | {:.1} | {:.1} | {ratio:.3} | {} |",
            case.effect,
            least[0] * 1e3,
            least[1] * 1e3,
            if is_missed { "MISSED" } else { "" }
        );
    }
    std::process::exit(i32::from(missed));
}
