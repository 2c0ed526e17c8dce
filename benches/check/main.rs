//! Everything that is promised about reading and checking: where mistakes are found, and how quickly, beside other programs in the same run: medians of
//! several runs, one after the other in turn. Fails if a bar is missed. See benches/README.md. Only some parts:
//! `cargo bench --bench check -- process small`.

mod growth;
#[path = "../plot.rs"]
mod plot;
mod program;
mod recovery;
mod scenes;

use std::path::Path;
use std::time::{Duration, Instant};

use program::{Outcome, Run, median};
use scenes::Scene;
use zpg::internals::analysis::{Analysis, repair};

/// A line of the table.
struct Line {
    what: String,
    measured: f64,
    unit: &'static str,
    bar: f64,
    goal: Option<f64>,
    /// Whether more is better.
    more: bool,
}

impl Line {
    fn is_missed(&self) -> bool {
        match self.more {
            true => self.measured < self.bar,
            false => self.measured > self.bar,
        }
    }
}

/// What measures something, with a folder for its files.
type Part = fn(&Path, &mut Table);

/// The table so far.
#[derive(Default)]
struct Table(Vec<Line>);

impl Table {
    fn add(
        &mut self,
        what: impl Into<String>,
        measured: f64,
        unit: &'static str,
        bar: f64,
        more: bool,
    ) {
        self.with_goal(what, measured, unit, (bar, None), more);
    }

    fn with_goal(
        &mut self,
        what: impl Into<String>,
        measured: f64,
        unit: &'static str,
        (bar, goal): (f64, Option<f64>),
        more: bool,
    ) {
        let line = Line {
            what: what.into(),
            measured,
            unit,
            bar,
            goal,
            more,
        };
        let verdict = if line.is_missed() { "MISSED" } else { "" };
        let goal = line.goal.map_or(String::new(), |g| format!(" (goal {g})"));
        println!(
            "| {} | {} {} | {} {}{goal} | {verdict} |",
            line.what,
            rounded(line.measured, line.unit),
            line.unit,
            if line.more { "≥" } else { "≤" },
            line.bar,
        );
        self.0.push(line);
    }
}

fn rounded(x: f64, unit: &str) -> String {
    match x {
        // What matters is how far it is from all.
        x if unit == "%" => format!("{x:.2}"),
        x if x >= 100.0 => format!("{x:.0}"),
        x if x >= 10.0 => format!("{x:.1}"),
        x => format!("{x:.2}"),
    }
}

/// How often each is run.
const RUNS: usize = 5;
/// The size of a large scene.
const MB: f64 = 1e6;
const SIZE: usize = 20_000_000;

fn main() {
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let mut table = Table::default();
    println!("| what | measured | bar | |\n|---|---:|---:|---|");
    let parts: [(&str, Part); 8] = [
        ("peers", peers),
        ("kinds", kinds),
        ("mistakes", mistakes),
        ("process", |_, table| in_process(table)),
        ("repair", |_, table| repair(table)),
        ("small", small_and_long),
        ("growth", growth::growth),
        ("recovery", |_, table| recovery::recovery(table)),
    ];
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let is_asked = |name: &str| asked.iter().any(|a| a == name);
    let all = !parts.iter().any(|(name, _)| is_asked(name));
    for (name, part) in parts {
        if all || is_asked(name) {
            part(folder.path(), &mut table);
        }
    }
    let missed: Vec<&Line> = table.0.iter().filter(|l| l.is_missed()).collect();
    if !missed.is_empty() {
        println!("\n{} of {} bars are missed:", missed.len(), table.0.len());
        for line in missed {
            println!("- {}", line.what);
        }
        std::process::exit(1);
    }
}

/// Spheres, unions and comments: beside `wc`, POV-Ray, and programs that read other languages.
fn peers(folder: &Path, table: &mut Table) {
    let scene = scenes::mixed(SIZE);
    let path = folder.join("mixed.zpg");
    std::fs::write(&path, &scene.text).expect("the folder can be written to");
    let pov = folder.join("mixed.pov");
    std::fs::write(&pov, scenes::pov_ray(&scene.text)).expect("the folder can be written to");
    let size = scene.text.len() as f64;
    let (mut wc, mut one, mut two, mut fmt, mut povray) = (vec![], vec![], vec![], vec![], vec![]);
    let mut memory = 0.0f64;
    for i in 0..RUNS {
        wc.extend(
            Run::new("wc")
                .arg("-w")
                .arg(&path)
                .env("LC_ALL", "C")
                .seconds(),
        );
        let check = Run::zpg().arg("check").arg(&path);
        let (seconds, kilobytes) = check.env("RAYON_NUM_THREADS", "1").measured();
        one.push(seconds);
        memory = memory.max(kilobytes * 1024.0 / size);
        two.extend(Run::zpg().arg("check").arg(&path).seconds());
        fmt.extend(Run::zpg().arg("fmt").arg("--check").arg(&path).seconds());
        if i < 3 {
            let run = Run::new("povray")
                .arg("+W1")
                .arg("+H1")
                .arg("-D")
                .arg("-GA")
                .arg("-F");
            povray.extend(run.arg(format!("+I{}", pov.display())).seconds());
        }
    }
    let [wc, one, two, fmt] = [wc, one, two, fmt].map(median);
    table.with_goal(
        "check, beside `LC_ALL=C wc -w`",
        one / wc,
        "×",
        (2.5, Some(1.5)),
        false,
    );
    if povray.is_empty() {
        println!("| POV-Ray's parser | is not installed | | |");
    } else {
        let ratio = median(povray) / one;
        table.with_goal(
            "POV-Ray's parser, beside check",
            ratio,
            "×",
            (6.0, Some(12.0)),
            true,
        );
    }
    table.with_goal(
        "check, one core",
        size / MB / one,
        "MB/s",
        (100.0, Some(170.0)),
        true,
    );
    table.add("check, all cores", size / MB / two, "MB/s", 150.0, true);
    table.add("memory, beside the file", memory, "×", 6.0, false);
    table.add("fmt --check, beside `wc -w`", fmt / wc, "×", 3.5, false);
    orientation(folder, &scene, one);
}

/// What has no bar: other languages' readers over as much.
fn orientation(folder: &Path, scene: &Scene, one: f64) {
    let numbers: Vec<f64> = (scene.text.split_ascii_whitespace())
        .filter_map(|word| word.parse().ok())
        .collect();
    let json = serde_json::to_string(&numbers).expect("numbers are JSON");
    let start = Instant::now();
    let read: Vec<f64> = serde_json::from_str(&json).expect("it was just written");
    assert_eq!(read.len(), numbers.len());
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "| (serde_json, the same numbers, beside check) | {} × | | |",
        rounded(seconds / one, "×")
    );
    let python = folder.join("scene.py");
    let lines = (scene.text.lines().enumerate()).map(|(i, line)| {
        format!(
            "x{i} = [{}]\n",
            line.split('#')
                .next()
                .unwrap_or("")
                .trim()
                .replace(' ', ", ")
        )
    });
    let mut text = String::new();
    lines
        .take_while(|line| {
            text += line;
            text.len() < SIZE
        })
        .for_each(drop);
    std::fs::write(&python, &text).expect("the folder can be written to");
    let ruff = Run::new("ruff")
        .arg("check")
        .arg("--isolated")
        .arg("--no-cache")
        .arg(&python);
    beside("ruff, as many bytes of Python", &ruff, one);
    let toml = folder.join("scene.toml");
    std::fs::write(&toml, &text).expect("the folder can be written to");
    let taplo = Run::new("taplo").arg("check").arg(&toml);
    beside("taplo, as many tokens of TOML", &taplo, one);
}

/// Another program, beside the seconds that `check` takes.
fn beside(name: &str, program: &Run, check: f64) {
    let measured = match program.at_most(MINUTE) {
        Outcome::Done(s) => format!("{} ×", rounded(s / check, "×")),
        Outcome::Stopped => format!("more than {} ×", rounded(MINUTE / check, "×")),
        Outcome::Absent => "is not installed".to_owned(),
    };
    println!("| ({name}, beside check) | {measured} | | |");
}

/// Other programs are stopped after so many seconds.
const MINUTE: f64 = 60.0;

/// Eight kinds of scenes without mistakes.
fn kinds(folder: &Path, table: &mut Table) {
    for scene in scenes::kinds(SIZE) {
        let path = folder.join("kind.zpg");
        std::fs::write(&path, &scene.text).expect("the folder can be written to");
        let seconds = (0..3).filter_map(|_| Run::zpg().arg("check").arg(&path).seconds());
        let speed = scene.text.len() as f64 / MB / median(seconds.collect());
        table.add(format!("check: {}", scene.name), speed, "MB/s", 60.0, true);
    }
}

fn mistakes(folder: &Path, table: &mut Table) {
    let path = folder.join("mistakes.zpg");
    let seconds = |scene: Scene, runs: usize| {
        std::fs::write(&path, &scene.text).expect("the folder can be written to");
        let check = || Run::zpg().args(["check", "--memory", "64G"]);
        let all = (0..runs).filter_map(|_| check().arg(&path).seconds());
        (scene.text.len() as f64 / MB, median(all.collect()))
    };
    let (size, some) = seconds(scenes::mistake_on_every_20th_line(SIZE), 3);
    table.add(
        "check: a mistake on every 20th line",
        size / some,
        "MB/s",
        30.0,
        true,
    );
    let (_, all) = seconds(scenes::number_missing_on_every_line(SIZE), 3);
    table.add(
        "check: a number missing on every line, 20 MB",
        all,
        "s",
        2.0,
        false,
    );
    let (_, large) = seconds(scenes::number_missing_on_every_line(10 * SIZE), 1);
    table.add(
        "check: a number missing on every line, 200 MB",
        large,
        "s",
        25.0,
        false,
    );
}

/// As the language server calls it, which keeps freed memory.
fn in_process(table: &mut Table) {
    zpg::internals::allocator::keep(zpg::internals::lsp::KEPT_BYTES);
    for (lines, bar) in [(20_000, 5.0), (200_000, 45.0)] {
        for mistakes in [0, 10] {
            let text = scenes::lines(lines, mistakes);
            let mut times: Vec<f64> = (0..RUNS * 3)
                .map(|_| {
                    let bytes = text.clone().into_bytes();
                    let start = Instant::now();
                    let analysis = Analysis::new("scene.zpg", bytes);
                    let count = analysis.findings().len();
                    let time = start.elapsed();
                    assert!(count >= mistakes, "{count} findings");
                    time.as_secs_f64() * 1e3
                })
                .collect();
            times.remove(0);
            let what = format!("in process: {lines} lines, {mistakes} mistakes");
            table.add(what, median(times), "ms", bar, false);
        }
    }
}

/// What was meant, found by trying; the scene is read, and its findings are known.
fn repair(table: &mut Table) {
    for records in [200, 50_000] {
        let text = scenes::slips(records, 20);
        let analysis = Analysis::new("scene.zpg", text.into_bytes());
        let errors = analysis.findings().iter().filter(|d| d.is_error()).count();
        assert!(errors >= 20, "{errors} errors");
        let time = least(RUNS, || {
            std::hint::black_box(repair::proposals(&analysis));
        });
        let what = format!("in process: proposals for {records} records with 20 errors");
        table.add(what, time.as_secs_f64() * 1e3, "ms", 50.0, false);
    }
}

fn small_and_long(folder: &Path, table: &mut Table) {
    let path = folder.join("small.zpg");
    std::fs::write(&path, scenes::lines(10, 0)).expect("the folder can be written to");
    let times = (0..4 * RUNS).filter_map(|_| Run::zpg().arg("check").arg(&path).seconds());
    let small = median(times.collect());
    table.add("check: ten lines", small * 1e3, "ms", 6.0, false);
    let path = folder.join("chain.zpg");
    std::fs::write(&path, scenes::chain(1_000_000)).expect("the folder can be written to");
    let runs: Vec<(f64, f64)> = (0..3)
        .map(|_| Run::zpg().arg("check").arg(&path).measured())
        .collect();
    let seconds = median(runs.iter().map(|r| r.0).collect());
    let memory = runs.iter().fold(0.0f64, |m, r| m.max(r.1)) / 1e3;
    table.add(
        "check: a union chain of a million spheres",
        seconds,
        "s",
        1.2,
        false,
    );
    table.add("the same, memory", memory, "MB", 500.0, false);
}

/// The least of some runs in process.
pub fn least(runs: usize, mut run: impl FnMut()) -> Duration {
    let time = |_| {
        let start = Instant::now();
        run();
        start.elapsed()
    };
    (0..runs).map(time).min().unwrap_or_default()
}
