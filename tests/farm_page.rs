//! `docs/farm.md`: its table is what the simulation gives, its commands do what it says, and so in Czech.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::campaign::rng;
use crate::support::program;
use model::{DELAYS, Delays, NODES, run, table, work};

#[path = "../benches/farm/model.rs"]
mod model;

const PAGES: [&str; 2] = ["docs/farm.md", "docs/farm.cs.md"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn page(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap()
}

#[test]
fn the_table_is_that_of_the_simulation() {
    let rows = table();
    for name in PAGES {
        let page = page(name);
        let shown: Vec<&str> = page.lines().filter(|l| l.ends_with(" % |")).collect();
        assert_eq!(shown, rows, "{name}");
    }
}

/// Without delays nothing but joining comes on top of the work, whatever the tiles are.
#[test]
fn nothing_is_wasted_where_nothing_delays() {
    let none = Delays {
        queue: 0.0,
        start: 0.0,
        build: 0.0,
        failures: 0.0,
        again: 0.0,
    };
    for tile_time in model::TILE_TIMES {
        for nodes in NODES {
            let outcome = run(tile_time, nodes, &none, &mut rng::Rng::new(1));
            let least = work() / nodes as f64;
            assert!(outcome.end >= least, "{tile_time} {nodes}");
            assert!(outcome.waste < 1e-4, "{tile_time} {nodes}");
            // At most one tile longer, of which the dearest takes less than three times the average.
            let most = least + 3.0 * tile_time + 30.0;
            assert!(outcome.end <= most, "{tile_time} {nodes}");
        }
    }
}

/// What is wasted on average is known: each try of a task starts and builds, and a failed one takes half of its time.
#[test]
fn the_waste_is_the_expected_one() {
    const RUNS: u64 = 20;
    for (tile_time, tasks) in [(5.0, 60_000.0), (120.0, 2_500.0)] {
        let failed = DELAYS.failures / (1.0 - DELAYS.failures);
        let each = work() / tasks + DELAYS.build;
        let busy = tasks * (DELAYS.start * (1.0 + failed) + each + failed * each / 2.0);
        let expected = 1.0 - work() / busy;
        let waste = |seed| run(tile_time, 100, &DELAYS, &mut rng::Rng::new(seed)).waste;
        let mean = (0..RUNS).map(waste).sum::<f64>() / RUNS as f64;
        let off = (mean / expected - 1.0).abs();
        assert!(off < 0.03, "{tile_time}: {mean} {expected}");
    }
}

/// The commands of each section, without comments.
fn commands(page: &str) -> Vec<Vec<String>> {
    let section = |section: &str| {
        let blocks = section.split("```sh\n").skip(1);
        let lines = blocks.flat_map(|b| b.split("```").next().unwrap().lines());
        lines
            .map(|l| l.split(" # ").next().unwrap().trim().to_owned())
            .collect()
    };
    page.split("\n## ").map(section).collect()
}

#[test]
fn both_pages_have_the_same_commands() {
    let [english, czech] = PAGES.map(|name| commands(&page(name)));
    assert_eq!(english, czech);
    assert!(english.iter().flatten().count() > 20);
}

/// All commands but those of engines and of other programs, on small pictures. Whatever needs an engine is in
/// `tests/farm.rs`.
#[cfg(unix)]
#[test]
fn the_commands_do_what_the_page_says() {
    const OTHERS: [&str; 7] = [
        "cargo", "ffmpeg", "ls", "openjd", "python3", "squeue", "tail",
    ];
    let drawn = [
        &["pawns/submit.sh", "pawns/join.slurm"][..],
        &["job/job.yaml", "job/job-plain.yaml"],
        &["two/out/pawns.png", "two/out/parts/pawns/8-of-8.png"],
        &["class/out/good.png", "class/out/sheet.html"],
        &[
            "orbit/out/pawns.0000.png",
            "orbit/out/pawns.0099.png",
            "short.apng",
        ],
    ];
    let sections = commands(&page(PAGES[0]));
    let sections: Vec<&Vec<String>> = sections.iter().filter(|s| !s.is_empty()).collect();
    // The last one prints the table.
    assert_eq!(sections.len(), drawn.len());
    let pawns = root().join("scenes/gallery/pawns.zpg");
    for (section, files) in sections.into_iter().zip(drawn) {
        let is_ours = |line: &&String| {
            let first = line.split_whitespace().next().unwrap();
            !OTHERS.contains(&first) && !line.contains("submit.sh") && !line.contains("PATH=")
        };
        let mut script = "set -eu; home=$PWD\n".to_owned();
        for line in section.iter().filter(is_ours) {
            let mut line = line.replace("3840x2160", "48x27");
            for size in ["640x360", "320x180"] {
                line = line.replace(size, "16x9");
            }
            // What follows in a section does not lie in the job's folder.
            if line.starts_with("zpg ") {
                script += "cd \"$home\"\n";
            }
            script += &(line + "\n");
        }
        let folder = program::folder(&[
            (
                "submissions/good.zpg",
                "2 9 1\n9 -501 0 0 5 0 0 -1 0 1 0 45\n1 9999 2 0\n",
            ),
            ("submissions/bad.zpg", "2 9 0,5\n1 9999 2 0\n"),
        ]);
        let home = folder.path();
        fs::create_dir_all(home.join("scenes/gallery")).unwrap();
        fs::copy(&pawns, home.join("scenes/gallery/pawns.zpg")).unwrap();
        fs::create_dir(home.join("bin")).unwrap();
        std::os::unix::fs::symlink(program::PATH, home.join("bin/zpg")).unwrap();
        let path = std::env::var("PATH").unwrap();
        let output = Command::new("sh")
            .args(["-c", &script])
            .env("PATH", format!("{}:{path}", home.join("bin").display()))
            .env("HOME", home)
            .env("LC_ALL", "C")
            .current_dir(home)
            .output()
            .unwrap();
        let said = program::text(&output.stderr);
        assert!(output.status.success(), "{script}{said}");
        for file in files {
            assert!(home.join(file).exists(), "{file}: {script}{said}");
        }
    }
}
