//! Twelve pictures and twenty mixtures beside POV-Ray: processor seconds of the whole process, the PNG included, on one thread, one sample a
//! pixel; the least of some runs in turn. Both programs go to the same depth and leave out the same: nothing, and then
//! what counts for less than 1/4096. POV-Ray draws the translation and what a person would write, and the quicker one
//! counts. The two pictures are held against each other. Fails if a bar is missed. See benches/README.md.
//!
//! Then primary rays alone beside Mitsuba and Embree, what certainty costs, what a second thread brings, how the phases grow with the scene, and some single figures.
//!
//! `cargo bench --bench render` measures all; `-- tori lights` the scenes whose names hold these words; `-- povray`,
//! `mixtures`, `rays`, `certainty`, `threads`, `growth` or `around` that part; `-- write DIR` writes the scenes, by hand for
//! POV-Ray, too. `RENDER_SEED=4,5,6` draws other scenes: of several seeds the worst counts beside POV-Ray, and the first
//! one serves for the rest.

mod by_hand;
mod chart;
mod growth;
mod kernels;
#[path = "../plot.rs"]
mod plot;
mod rays;
mod scenes;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use scenes::Scene;

const SIZE: [u32; 2] = [640, 480];
/// POV-Ray is run once where it takes longer than this, in seconds.
const LONG: f64 = 10.0;
const RUNS: usize = 5;
const RUNS_OF_MIXTURES: usize = 2;
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
/// Scenes of a seed.
const FEWEST_FOR_MEAN: usize = 12;
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
const PARTS: [&str; 7] = [
    "povray",
    "mixtures",
    "rays",
    "certainty",
    "threads",
    "growth",
    "around",
];
/// Without `RENDER_SEED`.
const SEEDS: &str = "1,2,3";

fn main() {
    let asked: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let seeds = std::env::var("RENDER_SEED").unwrap_or_else(|_| SEEDS.to_owned());
    let seeds: Vec<u64> = (seeds.split(','))
        .map(|s| s.trim().parse().expect("a number"))
        .collect();
    let scenes = scenes::all(seeds[0]);
    if let [write, folder] = &asked[..]
        && write == "write"
    {
        write_all(&scenes, Path::new(folder));
        return write_all(&scenes::mixtures(seeds[0]), Path::new(folder));
    }
    let (parts, names): (Vec<String>, Vec<String>) =
        (asked.into_iter()).partition(|a| PARTS.contains(&a.as_str()));
    let is_asked = |part: &str| parts.is_empty() || parts.iter().any(|p| p == part);
    let is_chosen =
        |s: &Scene| names.is_empty() || names.iter().any(|a| s.name.contains(a.as_str()));
    let chosen: Vec<&Scene> = scenes.iter().filter(|s| is_chosen(s)).collect();
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let (folder, mut bars) = (folder.path(), Bars::default());
    let beside = |kind: fn(u64) -> Vec<Scene>, (runs, chart): (usize, &str), bars: &mut Bars| {
        let of_seed = |&seed: &u64| {
            println!("\nSeed {seed}.\n");
            let mut scenes = kind(seed);
            scenes.retain(is_chosen);
            beside_pov_ray(&scenes, (folder, runs))
        };
        worst(&seeds.iter().map(of_seed).collect::<Vec<_>>(), chart, bars);
    };
    if is_asked("povray") {
        beside(scenes::all, (RUNS, "speed.svg"), &mut bars);
    }
    if is_asked("mixtures") {
        beside(
            scenes::mixtures,
            (RUNS_OF_MIXTURES, "mixtures.svg"),
            &mut bars,
        );
    }
    if is_asked("rays") {
        rays::rays(seeds[0], folder, &mut bars);
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

/// A scene beside POV-Ray.
struct Beside {
    name: String,
    csg: bool,
    bar: f64,
    ratio: f64,
    /// Whether the pictures agree, and both programs follow as many rays.
    is_fair: bool,
}

/// Prints a line a scene.
fn beside_pov_ray(scenes: &[Scene], (folder, runs): (&Path, usize)) -> Vec<Beside> {
    println!(
        "| scene | POV-Ray, s | by hand, s | zpg, s | ratio | rays of POV-Ray | of zpg | pixels that differ \
         | cutoff 1/4096: POV-Ray, s | by hand, s | zpg, s | ratio |"
    );
    println!("|---|{}", "---:|".repeat(11));
    let of = |scene: &Scene| {
        let measured = measured(scene, (folder, runs));
        let ratio = [0, 1].map(|cutoff| measured.ratio(cutoff));
        let differ = differing(folder);
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
        println!(
            "| {} | {} | {theirs:.2e} | {ours:.2e} | {:.2} % | {} |",
            scene.name,
            seconds(0),
            differ * 100.0,
            seconds(1),
        );
        let same_work = (1.0 / ONE_ORDER..=ONE_ORDER).contains(&(theirs / ours));
        Beside {
            name: scene.name.clone(),
            csg: scene.csg,
            bar: scene.bar.unwrap_or(LEAST),
            ratio: ratio[0],
            is_fair: differ <= MAX_DIFFERING_SHARE && same_work,
        }
    };
    scenes.iter().map(of).collect()
}

/// Judges the scenes of each seed: the least ratio of a scene counts, and the least mean.
fn worst(seeds: &[Vec<Beside>], chart: &str, bars: &mut Bars) {
    let Some(first) = seeds.first() else { return };
    println!("\n| the worst of {} | ratio | bar | |", seeds.len());
    println!("|---|---:|---:|---|");
    let mut rows: Vec<chart::Row> = Vec::new();
    for (i, Beside { name, bar, .. }) in first.iter().enumerate() {
        let all = || seeds.iter().map(|scenes| &scenes[i]);
        let ratio = all().fold(f64::INFINITY, |least, scene| least.min(scene.ratio));
        let is_met = ratio >= *bar && all().all(|scene| scene.is_fair);
        println!("| {name} | {ratio:.2} | {bar} | {} |", bars.judge(is_met));
        rows.push((name, ratio));
    }
    let mean = |scenes: &Vec<Beside>| {
        let logarithms = scenes.iter().filter(|scene| !scene.csg);
        let logarithms: Vec<f64> = logarithms.map(|scene| scene.ratio.ln()).collect();
        (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
    };
    // Of a few chosen scenes a mean says nothing.
    if first.len() < FEWEST_FOR_MEAN {
        return;
    }
    let least = seeds.iter().map(mean).fold(f64::INFINITY, f64::min);
    let verdict = bars.judge(least >= MEAN);
    println!("| mean, without those of CSG | {least:.2} | {MEAN} | {verdict} |");
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(chart);
    if std::fs::write(&path, chart::svg(&rows)).is_ok() {
        println!("\nThe chart is `{}`.", path.display());
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
fn measured(scene: &Scene, (folder, runs): (&Path, usize)) -> Measured {
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
        for run in 0..runs {
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
