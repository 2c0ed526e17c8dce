//! Twelve pictures beside POV-Ray: processor seconds of the whole process, the PNG included, on one thread, one sample a
//! pixel; the least of some runs in turn. The two pictures are held against each other. Fails if a bar is missed. See
//! benches/README.md.
//!
//! Then what certainty costs, what a second thread brings, how the phases grow with the scene, and some single figures.
//!
//! `cargo bench --bench render` measures all; `-- tori lights` the scenes whose names hold these words; `-- povray`,
//! `certainty`, `threads`, `growth` or `around` that part; `-- write DIR` writes the scenes.

mod chart;
mod growth;
mod kernels;
#[path = "../plot.rs"]
mod plot;
mod scenes;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use scenes::Scene;

const SIZE: [u32; 2] = [640, 480];
/// POV-Ray is run once where it takes longer than this, in seconds.
const LONG: f64 = 10.0;
const RUNS: usize = 5;
/// A pixel differs if one of its channels does by more than this, linear, of white.
const ALIKE: f64 = 0.01;
/// It lies on an edge if it differs from a neighbour by more than this: what is seen there is up to rounding.
const EDGE: f64 = 0.1;
/// More pixels than this may not differ, those on edges apart.
const FEW: f64 = 0.01;

/// What is promised: how many times as long POV-Ray takes.
const MEAN: f64 = 3.5;
const LEAST: f64 = 2.5;

/// How many bars are missed.
#[derive(Default)]
struct Bars {
    missed: usize,
}

impl Bars {
    fn judge(&mut self, is_met: bool) -> &'static str {
        self.missed += usize::from(!is_met);
        if is_met { "" } else { "MISSED" }
    }
}

/// What is measured besides, by the names to ask for them.
const PARTS: [&str; 5] = ["povray", "certainty", "threads", "growth", "around"];

fn main() {
    let asked: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let seed = std::env::var("RENDER_SEED").ok();
    let scenes = scenes::all(seed.map_or(1, |s| s.parse().expect("a number")));
    if let [write, folder] = &asked[..]
        && write == "write"
    {
        return write_all(&scenes, Path::new(folder));
    }
    let (parts, names): (Vec<String>, Vec<String>) =
        (asked.into_iter()).partition(|a| PARTS.contains(&a.as_str()));
    let is_asked = |part: &str| parts.is_empty() || parts.iter().any(|p| p == part);
    let chosen: Vec<&Scene> = (scenes.iter())
        .filter(|s| names.is_empty() || names.iter().any(|a| s.name.contains(a.as_str())))
        .collect();
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let (folder, mut bars) = (folder.path(), Bars::default());
    if is_asked("povray") {
        beside_pov_ray(&chosen, folder, &mut bars);
    }
    if is_asked("certainty") {
        kernels::certainty(&chosen, &mut bars);
    }
    if is_asked("threads") {
        growth::threads(&chosen, folder, &mut bars);
    }
    if is_asked("growth") {
        growth::growth(folder, &mut bars);
    }
    if is_asked("around") {
        growth::around(&scenes, folder, &mut bars);
    }
    if bars.missed > 0 {
        println!("\n{} bars are missed.", bars.missed);
        std::process::exit(1);
    }
}

fn beside_pov_ray(scenes: &[&Scene], folder: &Path, bars: &mut Bars) {
    println!("| scene | POV-Ray, s | zpg, s | ratio | bar | pixels that differ | |");
    println!("|---|---:|---:|---:|---:|---:|---|");
    let mut logarithms = Vec::new();
    let mut rows: Vec<chart::Row> = Vec::new();
    for scene in scenes {
        let [theirs, ours] = measured(scene, folder);
        let ratio = theirs / ours;
        if !scene.csg {
            logarithms.push(ratio.ln());
        }
        rows.push((scene.name, ratio));
        let differ = differing(folder);
        let bar = scene.bar.unwrap_or(LEAST);
        println!(
            "| {} | {theirs:.2} | {ours:.2} | {ratio:.2} | {bar} | {:.2} % | {} |",
            scene.name,
            differ * 100.0,
            bars.judge(ratio >= bar && differ <= FEW)
        );
    }
    let mean = (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp();
    if logarithms.len() == 9 {
        let verdict = bars.judge(mean >= MEAN);
        println!("| mean of those without CSG | | | {mean:.2} | {MEAN} | | {verdict} |");
        let path = concat!(env!("CARGO_TARGET_TMPDIR"), "/speed.svg");
        if std::fs::write(path, chart::svg(&rows)).is_ok() {
            println!("| `{path}` | | | | | | |");
        }
    }
}

fn write_all(scenes: &[Scene], folder: &Path) {
    std::fs::create_dir_all(folder).expect("the folder can be made");
    for scene in scenes {
        let path = folder.join(scene.name.replace(' ', "-") + ".zpg");
        std::fs::write(path, &scene.text).expect("the folder can be written to");
    }
}

/// The processor seconds of POV-Ray and of zpg.
fn measured(scene: &Scene, folder: &Path) -> [f64; 2] {
    let [zpg, pov, ours, theirs] = files(folder);
    std::fs::write(&zpg, &scene.text).expect("the folder can be written to");
    let program = env!("CARGO_BIN_EXE_zpg");
    let converted = Command::new(program)
        .args(["convert", "--to", "pov"])
        .arg(&zpg)
        .arg("-o")
        .arg(&pov)
        .stderr(Stdio::null())
        .status();
    assert!(
        converted.is_ok_and(|status| status.success()),
        "{}",
        scene.name
    );
    let [width, height] = SIZE;
    let render = [
        program.to_owned(),
        "render".to_owned(),
        zpg.display().to_string(),
        "--threads=1".to_owned(),
        format!("--size={width}x{height}"),
        "-o".to_owned(),
        ours.display().to_string(),
    ];
    let povray = [
        "povray".to_owned(),
        format!("+I{}", pov.display()),
        format!("+O{}", theirs.display()),
        format!("+W{width}"),
        format!("+H{height}"),
        "+WT1".to_owned(),
        "-D".to_owned(),
        "-GA".to_owned(),
        "+FN16".to_owned(),
        "File_Gamma=1.0".to_owned(),
    ];
    let mut least = [f64::INFINITY; 2];
    for run in 0..RUNS {
        if run == 0 || least[0] < LONG {
            least[0] = least[0].min(seconds(&povray));
        }
        least[1] = least[1].min(seconds(&render));
    }
    least
}

fn files(folder: &Path) -> [PathBuf; 4] {
    ["scene.zpg", "scene.pov", "ours.png", "theirs.png"].map(|name| folder.join(name))
}

/// The processor seconds of a program, as the shell has them.
fn seconds(command: &[String]) -> f64 {
    let timed = Command::new("bash")
        .args([
            "-c",
            r#"TIMEFORMAT="%3U %3S"; time "$@" >/dev/null 2>&1"#,
            "bash",
        ])
        .args(command)
        .output()
        .expect("there is a bash");
    assert!(timed.status.success(), "{command:?}");
    let times = String::from_utf8_lossy(&timed.stderr).into_owned();
    let times = times.split_whitespace().map(|t| t.parse::<f64>());
    times.sum::<Result<f64, _>>().expect("two numbers")
}

/// The share of the pixels that differ.
fn differing(folder: &Path) -> f64 {
    let [scene, pov, _, theirs] = files(folder);
    let exact = folder.join("ours.pfm");
    let [width, height] = SIZE;
    let drawn = Command::new(env!("CARGO_BIN_EXE_zpg"))
        .arg("render")
        .arg(&scene)
        .arg(format!("--size={width}x{height}"))
        .arg("-o")
        .arg(&exact)
        .output();
    assert!(drawn.is_ok_and(|out| out.status.success()));
    let map = std::fs::read(&exact).expect("a picture was written");
    let numbers = map.len() - 12 * (width * height) as usize;
    let ours: Vec<f64> = (map[numbers..].chunks_exact(4))
        .map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])))
        .collect();
    // All light is multiplied by a number, so that it fits into the file.
    let text = std::fs::read_to_string(&pov).expect("a scene was written");
    let scale = text
        .split("Light_Scale = ")
        .nth(1)
        .and_then(|s| s.split(';').next());
    let scale: f64 = scale.map_or(1.0, |s| s.parse().expect("a number"));
    let theirs = image::open(theirs)
        .expect("a picture was written")
        .to_rgb16();
    // A float map begins with the last row.
    let at = |x: u32, y: u32| 3 * ((height - 1 - y) * width + x) as usize;
    let is_edge = |x: u32, y: u32| {
        let beside = |x: u32, y: u32| {
            (x.saturating_sub(1)..(x + 2).min(width))
                .flat_map(move |x| (y.saturating_sub(1)..(y + 2).min(height)).map(move |y| (x, y)))
        };
        beside(x, y)
            .any(|(u, v)| (0..3).any(|c| (ours[at(x, y) + c] - ours[at(u, v) + c]).abs() > EDGE))
    };
    let differs = |&(x, y): &(u32, u32)| {
        let pixel = theirs.get_pixel(x, y).0;
        let off = |c: usize| (ours[at(x, y) + c] - f64::from(pixel[c]) / 65535.0 / scale).abs();
        (0..3).any(|c| off(c) > ALIKE) && !is_edge(x, y)
    };
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let count = pixels.filter(differs).count();
    count as f64 / f64::from(width * height)
}
