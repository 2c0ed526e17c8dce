//! Twelve pictures beside POV-Ray: processor seconds of the whole process, the PNG included, on one thread, one sample a
//! pixel; the least of some runs in turn. Both programs go to the same depth and leave out the same: nothing, and then
//! what counts for less than 1/4096. POV-Ray draws the translation and what a person would write, and the quicker one
//! counts. The two pictures are held against each other. Fails if a bar is missed. See benches/README.md.
//!
//! Then what certainty costs, what a second thread brings, how the phases grow with the scene, and some single figures.
//!
//! `cargo bench --bench render` measures all; `-- tori lights` the scenes whose names hold these words; `-- povray`,
//! `certainty`, `threads`, `growth` or `around` that part; `-- write DIR` writes the scenes, by hand for POV-Ray, too.

mod by_hand;
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
/// The programs follow as many rays, but for this factor: the same work.
const ONE_ORDER: f64 = 3.0;
/// More pixels than this may not differ, those on edges apart.
const MAX_DIFFERING_SHARE: f64 = 0.01;

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

/// What a picture costs: processor seconds and rays, those of shadows apart.
#[derive(Clone, Copy)]
struct Cost {
    seconds: f64,
    rays: f64,
}

/// Cutoffs: nothing is left out, and what zpg leaves out unless asked.
const CUTOFFS: [&str; 2] = ["0", "1/4096"];
const CUTOFF: [f64; 2] = [0.0, 1.0 / 4096.0];

/// What the programs took for a scene, for each cutoff.
struct Measured {
    translated: [Cost; 2],
    by_hand: [Cost; 2],
    ours: [Cost; 2],
}

impl Measured {
    /// How many times as long POV-Ray takes, with what suits it better.
    fn ratio(&self, cutoff: usize) -> f64 {
        let theirs = [self.translated, self.by_hand].map(|cost| cost[cutoff].seconds);
        theirs[0].min(theirs[1]) / self.ours[cutoff].seconds
    }
}

fn beside_pov_ray(scenes: &[&Scene], folder: &Path, bars: &mut Bars) {
    println!(
        "| scene | POV-Ray, s | by hand, s | zpg, s | ratio | bar | rays of POV-Ray | of zpg | pixels that differ \
         | cutoff 1/4096: POV-Ray, s | by hand, s | zpg, s | ratio | |"
    );
    println!("|---|{}---|", "---:|".repeat(12));
    let mut logarithms = Vec::new();
    let mut rows: Vec<chart::Row> = Vec::new();
    for scene in scenes {
        let measured = measured(scene, folder);
        let ratio = [0, 1].map(|cutoff| measured.ratio(cutoff));
        if !scene.csg {
            logarithms.push(ratio[0].ln());
        }
        rows.push((scene.name, ratio[0]));
        let differ = differing(folder);
        let bar = scene.bar.unwrap_or(LEAST);
        let seconds = |i: usize| {
            let [theirs, hand, ours] = [measured.translated, measured.by_hand, measured.ours]
                .map(|cost| format!("{:.2}", cost[i].seconds));
            // Shown where it matters.
            let differs = measured.by_hand[i].seconds / measured.translated[i].seconds;
            let hand = match (0.9..=1.1).contains(&differs) {
                true => String::new(),
                false => hand,
            };
            match measured.ours[i].seconds.is_finite() {
                true => format!("{theirs} | {hand} | {ours} | {:.2}", ratio[i]),
                false => " | | | ".to_owned(),
            }
        };
        let [theirs, ours] = [measured.translated[0].rays, measured.ours[0].rays];
        let same_work = (1.0 / ONE_ORDER..=ONE_ORDER).contains(&(theirs / ours));
        println!(
            "| {} | {} | {bar} | {theirs:.2e} | {ours:.2e} | {:.2} % | {} | {} |",
            scene.name,
            seconds(0),
            differ * 100.0,
            seconds(1),
            bars.judge(ratio[0] >= bar && differ <= MAX_DIFFERING_SHARE && same_work)
        );
    }
    if logarithms.len() == 9 {
        let mean = (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp();
        let verdict = bars.judge(mean >= MEAN);
        println!(
            "| mean of those without CSG | | | | {mean:.2} | {MEAN} | | | | | | | | {verdict} |"
        );
        let path = concat!(env!("CARGO_TARGET_TMPDIR"), "/speed.svg");
        if std::fs::write(path, chart::svg(&rows)).is_ok() {
            println!("\nThe chart is `{path}`.");
        }
    }
}

fn write_all(scenes: &[Scene], folder: &Path) {
    std::fs::create_dir_all(folder).expect("the folder can be made");
    for scene in scenes {
        let path = folder.join(scene.name.replace(' ', "-") + ".zpg");
        let by_hand = by_hand::written(&scene.text, 0.0);
        for (ending, text) in [("zpg", &scene.text), ("pov", &by_hand)] {
            std::fs::write(path.with_extension(ending), text)
                .expect("the folder can be written to");
        }
    }
}

/// What the programs take in turn, the least of some runs. All write a PNG of eight bits a channel.
fn measured(scene: &Scene, folder: &Path) -> Measured {
    let [zpg, pov, ours, theirs] = files(folder);
    std::fs::write(&zpg, &scene.text).expect("the folder can be written to");
    let program = env!("CARGO_BIN_EXE_zpg");
    let path = |path: &Path| path.display().to_string();
    let converted = Command::new(program)
        .args(["convert", "--to", "pov"])
        .args([path(&zpg), "-o".to_owned(), path(&pov)])
        .stderr(Stdio::null())
        .status();
    assert!(
        converted.is_ok_and(|status| status.success()),
        "{}",
        scene.name
    );
    let translation = std::fs::read_to_string(&pov).expect("a scene was written");
    let statistics = folder.join("statistics.json");
    let mut costs = [[Cost::NONE; 3]; 2];
    for (i, costs) in costs.iter_mut().enumerate() {
        // Without mirrors and glass nothing is left out.
        if i == 1 && !scene.text.contains(" -201 ") {
            break;
        }
        let bailout = CUTOFF[i];
        let translation = translation.replace("adc_bailout 0", &format!("adc_bailout {bailout}"));
        let texts = [translation, by_hand::written(&scene.text, bailout)];
        let commands = [0, 1].map(|k| {
            let pov = folder.join(["translated.pov", "by-hand.pov"][k]);
            std::fs::write(&pov, &texts[k]).expect("the folder can be written to");
            pov_ray(&pov, &theirs, &["+FN8", "File_Gamma=srgb"])
        });
        let [width, height] = SIZE;
        let render = [
            program.to_owned(),
            "render".to_owned(),
            path(&zpg),
            "--threads=1".to_owned(),
            "--samples=1".to_owned(),
            format!("--size={width}x{height}"),
            format!("--cutoff={}", CUTOFFS[i]),
            format!("--stats={}", path(&statistics)),
            "-o".to_owned(),
            path(&ours),
        ];
        for run in 0..RUNS {
            for (cost, command) in costs.iter_mut().zip(&commands) {
                if run == 0 || cost.seconds < LONG {
                    let (seconds, said) = run_timed(command);
                    cost.take(seconds, || pov_rays(&said));
                }
            }
            let (seconds, _) = run_timed(&render);
            costs[2].take(seconds, || zpg_rays(&statistics));
        }
    }
    let of = |k: usize| [costs[0][k], costs[1][k]];
    // Once more, as exact as a file can be, for the pixels.
    let dimmed = format!("Declare=Light_Scale={}", light_scale(&pov));
    run_timed(&pov_ray(
        &pov,
        &theirs,
        &["+FN16", "File_Gamma=1.0", &dimmed],
    ));
    Measured {
        translated: of(0),
        by_hand: of(1),
        ours: of(2),
    }
}

impl Cost {
    const NONE: Cost = Cost {
        seconds: f64::INFINITY,
        rays: 0.0,
    };

    fn take(&mut self, seconds: f64, rays: impl FnOnce() -> f64) {
        self.seconds = self.seconds.min(seconds);
        self.rays = rays();
    }
}

/// What all light is to be multiplied by, so that it fits into a picture file: a translation's head says it.
fn light_scale(pov: &Path) -> f64 {
    let text = std::fs::read_to_string(pov).expect("a scene was written");
    let said = text.split("Declare=Light_Scale=").nth(1);
    let number = said.and_then(|s| s.split_whitespace().next());
    number.map_or(1.0, |s| s.parse().expect("a number"))
}

fn pov_ray(scene: &Path, picture: &Path, output: &[&str]) -> Vec<String> {
    let [width, height] = SIZE;
    let mut command = vec![
        "povray".to_owned(),
        format!("+I{}", scene.display()),
        format!("+O{}", picture.display()),
        format!("+W{width}"),
        format!("+H{height}"),
        "+WT1".to_owned(),
        "-D".to_owned(),
    ];
    command.extend(output.iter().map(|&o| o.to_owned()));
    command
}

/// Rays from the eye, mirrored and refracted ones, as POV-Ray counts them in what it says.
fn pov_rays(said: &str) -> f64 {
    let behind = |label: &str| {
        let mut words = said.split(label).nth(1)?.split_whitespace();
        words.next()?.parse::<f64>().ok()
    };
    behind("\nRays:").unwrap_or_else(|| panic!("POV-Ray does not count its rays: {said}"))
}

/// The same of a picture's statistics.
fn zpg_rays(statistics: &Path) -> f64 {
    let text = std::fs::read_to_string(statistics).expect("statistics were written");
    let all: serde_json::Value = serde_json::from_str(&text).expect("they are JSON");
    let kinds = ["camera", "reflection", "refraction"];
    let rays = kinds.map(|kind| all["rays"][kind].as_f64().expect("a number"));
    rays.iter().sum()
}

fn files(folder: &Path) -> [PathBuf; 4] {
    ["scene.zpg", "scene.pov", "ours.png", "theirs.png"].map(|name| folder.join(name))
}

/// The processor seconds of a program, as the shell has them, and what the program says.
fn run_timed(command: &[String]) -> (f64, String) {
    let timed = Command::new("bash")
        .args(["-c", r#"TIMEFORMAT="%3U %3S"; time "$@" 2>&1"#, "bash"])
        .args(command)
        .output()
        .expect("there is a bash");
    let said = String::from_utf8_lossy(&timed.stdout).into_owned();
    assert!(timed.status.success(), "{command:?}: {said}");
    let times = String::from_utf8_lossy(&timed.stderr).into_owned();
    let times = times.split_whitespace().map(|t| t.parse::<f64>());
    let seconds = times.sum::<Result<f64, _>>().expect("two numbers");
    (seconds, said)
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
        .arg("--samples=1")
        .arg("--cutoff=0")
        .arg("-o")
        .arg(&exact)
        .output();
    assert!(drawn.is_ok_and(|out| out.status.success()));
    let map = std::fs::read(&exact).expect("a picture was written");
    let numbers = map.len() - 12 * (width * height) as usize;
    let ours: Vec<f64> = (map[numbers..].chunks_exact(4))
        .map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])))
        .collect();
    let scale = light_scale(&pov);
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
