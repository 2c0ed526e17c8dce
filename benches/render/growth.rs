//! How the phases of a picture grow with the scene, and what more threads bring.

use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use super::scenes::Scene;
use super::{Bars, plot};

const COUNTS: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];
const PHASES: [&str; 4] = ["load", "plan", "build", "trace"];
/// What leaves the cache may take longer for that by itself.
const CACHE: f64 = 2.0;
/// Shorter than this, in seconds, is noise.
const NOISE: f64 = 0.01;
/// Two threads are as many times as quick as one.
const TWICE: f64 = 1.9;
/// The phase `trace` is to take so long on one thread, in seconds.
const LONG: f64 = 0.5;

/// What `--stats` says of a picture.
fn stats(scene: &Path, size: [u32; 2], threads: u32) -> serde_json::Value {
    let to = scene.with_extension("json");
    let drawn = Command::new(env!("CARGO_BIN_EXE_zpg"))
        .arg("render")
        .arg(scene)
        .arg(format!("--size={}x{}", size[0], size[1]))
        .arg(format!("--threads={threads}"))
        .arg("--samples=1")
        .arg("--stats")
        .arg(&to)
        .arg("-o")
        .arg(scene.with_extension("png"))
        .stdout(Stdio::null())
        .status();
    assert!(drawn.is_ok_and(|status| status.success()), "{scene:?}");
    let text = std::fs::read_to_string(to).expect("the statistics are written");
    serde_json::from_str(&text).expect("they are JSON")
}

fn seconds(stats: &serde_json::Value, phase: &str) -> f64 {
    stats["seconds"][phase].as_f64().expect("a number")
}

/// Writes the records of a thing with this ID, at a place and of a size.
type Thing = fn(usize, [f64; 3], f64) -> String;

/// Things in a cube that all fill equally, and the chain of operations over them.
fn chain(count: usize, thing: Thing, operation: fn(usize) -> i32) -> String {
    let mut text = String::new();
    let side = (count as f64).cbrt().ceil();
    for i in 0..count {
        let k = i as f64;
        let place = [
            k % side,
            (k / side).floor() % side,
            (k / side / side).floor(),
        ];
        text += &thing(10 + i, place.map(|n| (n / side - 0.5) * 20.0), 8.0 / side);
    }
    let end = 10 + count;
    for i in 1..count {
        let before = if i == 1 { 10 } else { end + i - 2 };
        let _ = writeln!(text, "{} {} {before} {}", end + i - 1, operation(i), 10 + i);
    }
    let root = end + count - 2;
    text + &format!("2 -402 1\n2 -1 20 30 40\n3 -501 0 0 40  0 0 -1  0 1 0  40\n1 9999 {root} 0\n")
}

fn sphere(id: usize, [x, y, z]: [f64; 3], size: f64) -> String {
    format!("{id} 11 {x} {y} {z} {size}\n")
}

fn torus(id: usize, [x, y, z]: [f64; 3], size: f64) -> String {
    format!("{id} 14 {size} {}\n{id} -1 {x} {y} {z}\n", 0.3 * size)
}

/// Of the object 7.
fn instance(id: usize, [x, y, z]: [f64; 3], size: f64) -> String {
    format!("{id} -105 7\n{id} -3 {size} {size} {size}\n{id} -1 {x} {y} {z}\n")
}

const UNION: i32 = -101;
const DIFFERENCE: i32 = -103;

type Kind = (&'static str, fn(usize) -> String);

const KINDS: [Kind; 4] = [
    ("spheres", |n| chain(n, sphere, |_| UNION)),
    ("tori", |n| chain(n, torus, |_| UNION)),
    ("instances", |n| {
        "5 9 1\n6 12 -1 -1 -1 1 1 1\n7 -101 5 6\n".to_owned() + &chain(n, instance, |_| UNION)
    }),
    ("chained operations", |n| {
        let operation = |i: usize| match i.is_multiple_of(2) {
            true => UNION,
            false => DIFFERENCE,
        };
        chain(n, sphere, operation)
    }),
];

/// 10³ to 10⁶ things of four kinds: no step of ten times as many takes longer than n·log n and the cache make it, in no
/// phase. Draws a plot for each phase in the target folder.
pub fn growth(folder: &Path, bars: &mut Bars) {
    println!("\n| phase | of | 10³, s | 10⁴, s | 10⁵, s | 10⁶, s | worst step | bar | |");
    println!("|---|---|---:|---:|---:|---:|---:|---:|---|");
    let mut curves: Vec<Vec<(&str, Vec<f64>)>> = vec![Vec::new(); PHASES.len()];
    for (name, write) in KINDS {
        let all = COUNTS.map(|count| {
            let path = folder.join("growth.zpg");
            std::fs::write(&path, write(count)).expect("the folder can be written to");
            stats(&path, [320, 240], 1)
        });
        for (phase, curves) in PHASES.iter().zip(&mut curves) {
            curves.push((name, all.each_ref().map(|s| seconds(s, phase)).to_vec()));
        }
    }
    let n_log_n = |n: usize| n as f64 * (n as f64).ln();
    for (phase, curves) in PHASES.iter().zip(&curves) {
        for (name, times) in curves {
            let steps = (1..COUNTS.len()).filter(|&i| times[i] > NOISE).map(|i| {
                let before = times[i - 1].max(NOISE / 10.0);
                times[i] / before / (n_log_n(COUNTS[i]) / n_log_n(COUNTS[i - 1]))
            });
            let worst = steps.fold(0.0, f64::max);
            let shown: Vec<String> = times.iter().map(|t| format!("{t:.4}")).collect();
            println!(
                "| {phase} | {name} | {} | {worst:.2} | {CACHE} | {} |",
                shown.join(" | "),
                bars.judge(worst <= CACHE)
            );
        }
        let path = format!("{}/growth-{phase}.svg", env!("CARGO_TARGET_TMPDIR"));
        if std::fs::write(&path, plot::svg(&COUNTS, curves)).is_ok() {
            println!("| | `{path}` | | | | | | | |");
        }
    }
}

/// Two threads beside one: wall seconds of the phase `trace`.
pub fn threads(scenes: &[&Scene], folder: &Path, bars: &mut Bars) {
    println!("\n| threads | size | one, s | two, s | ratio | bar | |");
    println!("|---|---|---:|---:|---:|---:|---|");
    for scene in scenes {
        let path = folder.join("threads.zpg");
        std::fs::write(&path, &scene.text).expect("the folder can be written to");
        let mut size = [640, 480];
        let mut one = seconds(&stats(&path, size, 1), "trace");
        while one < LONG {
            size = size.map(|side| side * 2);
            one = seconds(&stats(&path, size, 1), "trace");
        }
        let picture = path.with_extension("png");
        let drawn = || std::fs::read(&picture).expect("a picture was written");
        let before = drawn();
        let mut two = f64::INFINITY;
        for _ in 0..3 {
            two = two.min(seconds(&stats(&path, size, 2), "trace"));
            assert!(
                before == drawn(),
                "{}: other bytes on two threads",
                scene.name
            );
            one = one.min(seconds(&stats(&path, size, 1), "trace"));
        }
        let ratio = one / two;
        println!(
            "| {} | {}×{} | {one:.2} | {two:.2} | {ratio:.2} | {TWICE} | {} |",
            scene.name,
            size[0],
            size[1],
            bars.judge(ratio >= TWICE)
        );
    }
}

/// The size of the binary without symbols, by the program `strip` of the binutils.
fn stripped(to: &Path) -> Option<f64> {
    let mut strip = Command::new("strip");
    let strip = strip.arg("-o").arg(to).arg(env!("CARGO_BIN_EXE_zpg"));
    strip.status().is_ok_and(|s| s.success()).then_some(())?;
    std::fs::metadata(to).ok().map(|m| m.len() as f64)
}

/// Single figures: a small picture, a large union, ten thousand spheres.
pub fn around(scenes: &[Scene], folder: &Path, bars: &mut Bars) {
    println!("\n| | measured | bar | |\n|---|---:|---:|---|");
    let mut add = |what: &str, measured: f64, unit: &str, bar: f64| {
        println!(
            "| {what} | {measured:.3} {unit} | {bar} {unit} | {} |",
            bars.judge(measured <= bar)
        );
    };
    let handout = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/scenes/handout/4-checkerboard-and-spheres.zpg"
    );
    let path = folder.join("handout.zpg");
    std::fs::copy(handout, &path).expect("the scene is there");
    let mut least = f64::INFINITY;
    for _ in 0..9 {
        let start = std::time::Instant::now();
        stats(&path, [320, 240], 2);
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    add("the handout's last scene at 320×240", least, "ms", 40.0);

    let spheres = scenes.iter().find(|s| s.name == "ten thousand spheres");
    if let Some(spheres) = spheres {
        let path = folder.join("spheres.zpg");
        std::fs::write(&path, &spheres.text).expect("the folder can be written to");
        let mut least = f64::INFINITY;
        for _ in 0..9 {
            let stats = stats(&path, [16, 12], 2);
            let phases = ["load", "plan", "build"].map(|phase| seconds(&stats, phase));
            least = least.min(phases.iter().sum::<f64>() * 1e3);
        }
        add("reading and building 10 000 spheres", least, "ms", 25.0);
    }

    let path = folder.join("union.zpg");
    std::fs::write(&path, KINDS[0].1(1_000_000)).expect("the folder can be written to");
    let stats = stats(&path, [16, 12], 2);
    let all = ["load", "plan", "build", "trace"].map(|phase| seconds(&stats, phase));
    add(
        "a union of 10⁶ spheres, to the first pixel",
        all.iter().sum(),
        "s",
        4.0,
    );
    let memory = stats["peak_memory_bytes"].as_f64().expect("a number") / 1e6;
    add("the same, memory", memory, "MB", 700.0);
    let bytes = stripped(&folder.join("zpg")).unwrap_or(f64::INFINITY);
    add("the stripped binary", bytes / 1e6, "MB", 10.0);
}
