//! Primary rays alone, beside Mitsuba and Embree: nanoseconds a pixel on one thread, without what comes before and after.

use std::path::Path;
use std::process::{Command, Stdio};

use super::scenes::{self, Scene};
use super::{Bars, SIZE};

/// Embree, in single precision, takes at least this share of our time.
const EMBREE: f64 = 0.5;

/// Prints a line a scene; leaves out what no Python here has.
pub fn rays(seed: u64, folder: &Path, bars: &mut Bars) {
    println!("\n| primary rays alone, ns a pixel | zpg | Mitsuba | Embree | |");
    println!("|---|---:|---:|---:|---|");
    for scene in scenes::of_rays(seed) {
        let ours = ours(&scene, folder);
        let Some(theirs) = theirs(&scene, folder) else {
            println!(
                "| {} | {ours:.0} | no Python with Mitsuba | | |",
                scene.name
            );
            continue;
        };
        let of = |program: &str| theirs[program].as_f64();
        let [mitsuba, embree] = ["mitsuba", "embree"].map(of);
        let is_met = mitsuba.is_none_or(|theirs| ours <= theirs)
            && embree.is_none_or(|theirs| ours * EMBREE <= theirs);
        let shown = |time: Option<f64>| time.map(|t| format!("{t:.0}")).unwrap_or_default();
        println!(
            "| {} | {ours:.0} | {} | {} | {} |",
            scene.name,
            shown(mitsuba),
            shown(embree),
            bars.judge(is_met)
        );
    }
}

/// The phase `trace`, of the quickest run.
fn ours(scene: &Scene, folder: &Path) -> f64 {
    let [zpg, statistics, picture] = ["rays.zpg", "rays.json", "rays.png"].map(|f| folder.join(f));
    std::fs::write(&zpg, &scene.text).expect("the folder can be written to");
    let [width, height] = SIZE;
    let run = |_| {
        let drawn = Command::new(env!("CARGO_BIN_EXE_zpg"))
            .args(["render", "--quiet", "--threads=1", "--samples=1"])
            .arg(format!("--size={width}x{height}"))
            .arg(format!("--stats={}", statistics.display()))
            .arg("-o")
            .args([&picture, &zpg])
            .status();
        assert!(drawn.is_ok_and(|status| status.success()), "{}", scene.name);
        let text = std::fs::read_to_string(&statistics).expect("statistics were written");
        let all: serde_json::Value = serde_json::from_str(&text).expect("they are JSON");
        all["seconds"]["trace"].as_f64().expect("a number")
    };
    let least = (0..super::RUNS).map(run).fold(f64::INFINITY, f64::min);
    least / f64::from(width * height) * 1e9
}

/// What the script rays.py prints.
fn theirs(scene: &Scene, folder: &Path) -> Option<serde_json::Value> {
    let balls = |line: &str| line.split_once(" 11 ").map(|(_, ball)| format!("{ball}\n"));
    let spheres: String = scene.text.lines().filter_map(balls).collect();
    let path = match spheres.is_empty() {
        true => {
            let mesh = folder.join("rays.ply");
            let converted = Command::new(env!("CARGO_BIN_EXE_zpg"))
                .args(["convert", "-o"])
                .args([&mesh, &folder.join("rays.zpg")])
                .stderr(Stdio::null())
                .status();
            assert!(converted.is_ok_and(|status| status.success()));
            mesh
        }
        false => {
            let list = folder.join("rays.txt");
            std::fs::write(&list, spheres).expect("the folder can be written to");
            list
        }
    };
    let python = std::env::var("MITSUBA").unwrap_or_else(|_| "python3".to_owned());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/render/rays.py");
    let said = Command::new(python).arg(script).arg(&path).output().ok()?;
    serde_json::from_slice(&said.stdout).ok()
}
