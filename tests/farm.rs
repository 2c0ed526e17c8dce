//! `zpg farm`: jobs, as what runs them takes them.

pub mod jobs;
mod slurm;

use std::fs;
use std::os::unix::process::CommandExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::program::{self, folder};
use jobs::{MONO, STEREO, are_those_of, class, one, pictures, says};
use slurm::Slurm;

/// What a class asks for: a name with brackets, two frames.
const CLASS: [&str; 6] = [
    "--size",
    "24x18",
    "--frames",
    "0-1",
    "--set",
    "5.x[3]=0.1..0.9",
];

/// The job of a class, and what one machine draws of it, in `whole`.
fn class_job(engine: &str) -> tempfile::TempDir {
    let dir = class();
    let job = [
        "farm", "one", "two", "--tiles", "3", "-o", "the job", "--for", engine,
    ];
    let said = says(dir.path(), &[&job[..], &CLASS].concat(), 0);
    assert!(said.contains("18 tasks of about "), "{said}");
    // The job has the scenes of each folder in a folder.
    for (from, place) in [("one/žlutý kůň", "1"), ("one/a", "1"), ("two/a", "2")] {
        let scene = format!("{from}.zpg");
        let whole = format!("whole/{place}");
        fs::create_dir_all(dir.path().join(&whole)).unwrap();
        says(
            dir.path(),
            &[&["render", &scene, "-o", &whole], &CLASS[..]].concat(),
            0,
        );
    }
    dir
}

/// The pictures of a class and the sheet of them are there.
#[track_caller]
fn is_drawn(dir: &Path, out: &str) {
    let out = dir.join("the job").join(out);
    are_those_of(&out, &dir.join("whole"));
    // Two frames of two pictures, and two frames of a pair.
    assert_eq!(pictures(&out).len(), 8);
    let sheet = fs::read_to_string(out.join("sheet.html")).unwrap();
    for name in ["žlutý kůň.0000_left", "a.0001", "broken"] {
        assert!(sheet.contains(name), "{name}");
    }
    let findings = fs::read_to_string(out.join("findings.json")).unwrap();
    assert!(
        findings.contains("broken.zpg") && findings.contains("E008"),
        "{findings}"
    );
}

/// `make` in a job, in a group of processes of its own.
fn make(job: &Path) -> Command {
    let mut command = Command::new("make");
    let zpg = format!("ZPG={}", program::PATH);
    command
        .args(["-j", "2", &zpg])
        .current_dir(job)
        .env("LC_ALL", "C");
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .process_group(0);
    command
}

#[test]
#[ignore = "needs make"]
fn make_draws_a_class() {
    let dir = class_job("shell");
    let status = make(&dir.path().join("the job")).status();
    assert!(
        status
            .expect("make is there; tests/run installs it")
            .success()
    );
    is_drawn(dir.path(), "out");
}

#[test]
#[ignore = "needs make"]
fn make_that_was_killed_goes_on() {
    let dir = one(STEREO);
    let options = ["--size", "80x60", "--samples", "16"];
    let farm = [
        "farm", "a.zpg", "--tiles", "12", "-o", "job", "--for", "shell",
    ];
    says(dir.path(), &[&farm[..], &options].concat(), 0);
    fs::create_dir(dir.path().join("whole")).unwrap();
    says(
        dir.path(),
        &[&["render", "a.zpg", "-o", "whole/a.png"], &options[..]].concat(),
        0,
    );
    let job = dir.path().join("job");
    let parts = || -> Vec<PathBuf> {
        let files = fs::read_dir(job.join("out/parts/a")).into_iter().flatten();
        let paths = files.map(|file| file.unwrap().path());
        paths
            .filter(|path| path.extension().is_some_and(|e| e == "png"))
            .collect()
    };
    let mut child = make(&job)
        .spawn()
        .expect("make is there; tests/run installs it");
    let start = Instant::now();
    while parts().len() < 3 {
        assert!(start.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(5));
    }
    // make, the shells and zpg.
    let killed = Command::new("kill")
        .args(["-9", "--", &format!("-{}", child.id())])
        .status();
    assert!(killed.unwrap().success() && !child.wait().unwrap().success());
    assert!(!job.join("out/a_left.png").exists());
    let modified = |path: &PathBuf| fs::metadata(path).unwrap().modified().unwrap();
    // A task writes the left and the right picture of a band one after the other; it may have been killed between them.
    let is_pair = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy();
        let other = match name.contains("left") {
            true => name.replace("left", "right"),
            false => name.replace("right", "left"),
        };
        path.with_file_name(other).exists()
    };
    let before: Vec<_> = parts()
        .into_iter()
        .filter(is_pair)
        .map(|path| (modified(&path), path))
        .collect();
    assert!((2..24).contains(&before.len()), "{}", before.len());
    assert!(make(&job).status().unwrap().success());
    are_those_of(&job.join("out"), &dir.path().join("whole"));
    // What was drawn is not drawn again.
    assert!(before.iter().all(|(time, path)| modified(path) == *time));
    // Pictures that somebody has removed are drawn again.
    fs::remove_dir_all(job.join("out")).unwrap();
    assert!(make(&job).status().unwrap().success());
    are_those_of(&job.join("out"), &dir.path().join("whole"));
}

/// Runs openjd on a template of a job.
#[track_caller]
fn openjd(job: &Path, arguments: &[&str]) {
    const VERSION: &str = "0.8.0";
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("a target folder");
    let program = target.join(format!("openjd-{VERSION}/bin/openjd"));
    let run = Command::new(&program)
        .args(arguments)
        .current_dir(job)
        .output();
    let run = run.unwrap_or_else(|e| panic!("{}: {e}: tests/run installs it", program.display()));
    let said = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success(), "{arguments:?}: {said}");
}

#[test]
#[ignore = "needs openjd"]
fn openjd_draws_a_class() {
    let dir = class_job("openjd");
    let job = dir.path().join("the job");
    let zpg = format!("Zpg={}", program::PATH);
    for (template, out) in [("job.yaml", "out"), ("job-plain.yaml", "it's plain")] {
        openjd(&job, &["check", template]);
        let out_option = format!("Out={out}");
        let run = ["run", template, "--step", "Join", "--run-dependencies"];
        openjd(&job, &[&run[..], &["-p", &zpg, "-p", &out_option]].concat());
        is_drawn(dir.path(), out);
    }
}

#[test]
#[ignore = "needs Slurm"]
fn slurm_draws_frames() {
    let dir = one(MONO);
    let options = ["--size", "24x18", "--frames", "0-3", "--orbit", "9,360"];
    let farm = [
        "farm", "a.zpg", "--tiles", "2", "-o", "job", "--for", "slurm",
    ];
    says(dir.path(), &[&farm[..], &options].concat(), 0);
    fs::create_dir(dir.path().join("whole")).unwrap();
    says(
        dir.path(),
        &[&["render", "a.zpg", "-o", "whole/a.png"], &options[..]].concat(),
        0,
    );
    let slurm = Slurm::start(16);
    let job = dir.path().join("job");
    let submit = |program: &str, arguments: &[&str]| {
        let mut command = slurm.command(program);
        command
            .args(arguments)
            .current_dir(&job)
            .env("ZPG", program::PATH);
        let run = command.output().unwrap();
        assert!(run.status.success(), "{run:?}");
    };
    for script in ["draw.slurm", "join.slurm"] {
        submit("sbatch", &["--test-only", script]);
    }
    submit("sh", &["submit.sh", "--comment=a comment"]);
    slurm.wait_for_all(Duration::from_secs(60));
    are_those_of(&job.join("out"), &dir.path().join("whole"));
}

#[test]
fn an_array_of_slurm_has_at_most_1000_elements() {
    let dir = one(MONO);
    let farm = [
        "farm", "a.zpg", "--size", "8x2500", "--tiles", "2500", "-o", "job", "--for",
    ];
    let said = says(dir.path(), &[&farm[..], &["slurm"]].concat(), 0);
    assert!(
        said.contains("2500 tasks") && said.contains("3 tasks are drawn in one go"),
        "{said}"
    );
    // 833 elements draw 3 tasks each, and one draws the last one.
    let script = fs::read_to_string(dir.path().join("job/draw.slurm")).unwrap();
    assert!(script.contains("--array=0-833%64\n"), "{script}");
    assert!(script.contains("* 3 + 1))\n"), "{script}");
    // Others have no such limit. What Slurm starts is gone: it would draw other tasks.
    says(dir.path(), &[&farm[..], &["shell"]].concat(), 0);
    let makefile = fs::read_to_string(dir.path().join("job/Makefile")).unwrap();
    assert!(makefile.contains("seq 0 2499"), "{makefile}");
    assert!(!dir.path().join("job/draw.slurm").exists());
    assert!(!dir.path().join("job/submit.sh").exists());
}

#[test]
fn joining_many_large_pictures_has_its_time() {
    let dir = one(MONO);
    let farm = [
        "farm",
        "a.zpg",
        "--tile-time",
        "1",
        "-o",
        "job",
        "--for",
        "slurm",
    ];
    let time = |options: &[&str]| {
        says(dir.path(), &[&farm[..], options].concat(), 0);
        let script = fs::read_to_string(dir.path().join("job/join.slurm")).unwrap();
        let time = script
            .lines()
            .find_map(|line| line.strip_prefix("#SBATCH --time="));
        time.unwrap().parse::<u32>().unwrap()
    };
    assert_eq!(time(&["--size", "64x48"]), 10);
    // 10 · 200 · 10⁶ pixels at a microsecond are 2000 seconds.
    assert_eq!(
        time(&[
            "--size",
            "20000x10000",
            "--frames",
            "0-9",
            "--set",
            "2.r=1..2"
        ]),
        34
    );
}

#[test]
fn tasks_have_the_processors_that_they_ask_for() {
    let dir = one(MONO);
    for engine in ["shell", "openjd", "slurm"] {
        let farm = [
            "farm", "a.zpg", "--size", "8x6", "--tiles", "2", "--cores", "3", "-o", engine,
        ];
        says(dir.path(), &[&farm[..], &["--for", engine]].concat(), 0);
        let file = |name: &str| fs::read_to_string(dir.path().join(engine).join(name)).unwrap();
        // Where nobody says anything else, such as with xargs.
        assert!(file("draw.sh").contains("--threads \"${THREADS:-3}\""));
        match engine {
            "shell" => assert!(file("Makefile").contains("export THREADS ?= 3\n")),
            "slurm" => assert!(file("draw.slurm").contains("--cpus-per-task=3\n")),
            _ => assert!(file("job.yaml").contains("amount.worker.vcpu, min: 3}")),
        }
    }
}

/// What is in a folder, with its subfolders.
fn names(folder: &Path) -> Vec<PathBuf> {
    let files = ignore::WalkBuilder::new(folder)
        .standard_filters(false)
        .sort_by_file_path(Ord::cmp)
        .build();
    files.map(|entry| entry.unwrap().into_path()).collect()
}

#[test]
fn bad_input_leaves_nothing_behind() {
    let dir = one(MONO);
    let more = [
        ("other/notes.txt", "notes"),
        ("file", "a file"),
        ("twice/b.zpg", jobs::SCENE),
        ("twice/b.json", ""),
        ("twice/floor.png", ""),
        ("bad/broken.zpg", "2 11 0 0 0\n1 9999 2 0\n"),
        ("bad/torn.zpg", "2 11 0 0 0\n1 9999 2 0\n"),
        ("none/c.zpg", jobs::SCENE),
    ];
    for (name, contents) in more {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, contents).unwrap();
    }
    fs::copy(
        dir.path().join("floor.png"),
        dir.path().join("twice/floor.png"),
    )
    .unwrap();
    let convert = [
        "convert",
        "twice/b.zpg",
        "--to",
        "json",
        "-o",
        "twice/b.json",
    ];
    fs::remove_file(dir.path().join("twice/b.json")).unwrap();
    says(dir.path(), &convert, 0);
    fs::write(dir.path().join("two\nlines.zpg"), jobs::SCENE).unwrap();
    let before = names(dir.path());
    for (arguments, status, message) in [
        ("a.zpg --for shell -o file", 2, "error: cannot write file: "),
        (
            "a.zpg --for shell -o file/job",
            2,
            "error: cannot write file/job: ",
        ),
        (
            "a.zpg --for shell -o other",
            2,
            "error: other has other things in it: ",
        ),
        (
            "a.zpg --for shell -o .",
            2,
            "a.zpg is the scene itself and would be overwritten",
        ),
        (
            "- --for shell -o job",
            2,
            "error: a job needs scenes that are files",
        ),
        (
            "a.zpg --for shell -o job --tiles 31 --size 40x30",
            2,
            "more tiles (31) than the picture has rows (30)",
        ),
        (
            "a.zpg --for shell -o job --tiles 31 --crop 0,0,40,30",
            2,
            "more tiles (31) than",
        ),
        (
            "a.zpg --for shell -o job --tiles 0",
            2,
            "expected a whole number from 1 to 1000000",
        ),
        (
            "a.zpg --for shell -o job --tiles -3",
            2,
            "expected a whole number from 1 to 1000000",
        ),
        (
            "a.zpg --for shell -o job --cores 0",
            2,
            "expected a whole number from 1 to 1000000",
        ),
        ("a.zpg --for shell -o job --tile-time 0", 2, "--tile-time"),
        (
            "a.zpg --for sge -o job",
            2,
            "there are openjd, slurm, shell",
        ),
        ("a.zpg --for shell -o job --size 0x5", 2, "--size"),
        ("a.zpg --for shell -o job --camera 77", 2, "77"),
        (
            "a.zpg --for shell -o job --frames 0-3 --set 5.x[9]=1..2",
            2,
            "5.x[9]",
        ),
        (
            "a.zpg --for shell -o job --frames 0-3 --set 2.r=1..-1",
            1,
            "there are errors in the scene of frame 2",
        ),
        ("bad/broken.zpg --for shell -o job", 1, "too few numbers"),
        ("bad --for shell -o job", 1, "Found 1 error in 1 file"),
        ("none/c.zpg --for shell -o job", 1, "floor.png"),
        ("missing.zpg --for shell -o job", 2, "missing.zpg"),
        (
            "twice/b.zpg twice/b.json --for shell -o job",
            2,
            "two scenes are named b, and",
        ),
        (
            "a.zpg two\nlines.zpg --for shell -o job",
            2,
            "has a line break in it",
        ),
        (
            "a.zpg --for shell -o job --size 4000000x4000000",
            2,
            "error: a picture has at most 268435456 pixels",
        ),
    ] {
        let words: Vec<&str> = ["farm"].into_iter().chain(arguments.split(' ')).collect();
        let said = says(dir.path(), &words, status);
        assert!(said.contains(message), "{arguments}: {said}");
        assert!(!said.contains("panicked"), "{said}");
        assert_eq!(names(dir.path()), before, "{arguments}");
    }
}

#[test]
fn a_job_is_written_anew() {
    let dir = folder(&[(
        "scenes/a.zpg",
        jobs::SCENE.replace("8 -301 floor.png\n", ""),
    )]);
    // The copies in the job are no scenes, although the job is in the folder of the scenes.
    let farm = [
        "farm",
        "scenes",
        "-o",
        "scenes/job",
        "--for",
        "shell",
        "--size",
        "8x6",
        "--tiles",
    ];
    for tiles in ["2", "3"] {
        let said = says(dir.path(), &[&farm[..], &[tiles]].concat(), 0);
        assert!(said.contains(&format!("{tiles} tasks")), "{said}");
        let is_again = tiles == "3";
        assert_eq!(said.contains("holds an earlier job"), is_again, "{said}");
        let list = fs::read_to_string(dir.path().join("scenes/job/scenes.txt")).unwrap();
        assert_eq!(list, "a.zpg\n");
    }
    let own = ["farm", "scenes/job", "-o", "scenes/job", "--for", "shell"];
    let said = says(dir.path(), &own, 2);
    assert!(said.contains("would be overwritten"), "{said}");
}

#[test]
#[ignore = "needs make"]
fn a_single_frame_is_drawn_in_bands() {
    let dir = one(MONO);
    for frames in [&["--frames", "0-9", "--only", "7"][..], &["--frames", "12"]] {
        let options = [frames, &["--set", "2.r=1..0.1", "--size", "16x12"]].concat();
        fs::create_dir(dir.path().join("whole")).unwrap();
        for tiles in ["2", "1"] {
            let farm = [
                "farm", "a.zpg", "-o", "job", "--for", "shell", "--tiles", tiles,
            ];
            let said = says(dir.path(), &[&farm[..], &options].concat(), 0);
            let tasks = ["One task", "2 tasks"][usize::from(tiles == "2")];
            assert!(said.contains(tasks), "{said}");
            says(
                dir.path(),
                &[&["render", "a.zpg", "-o", "whole/a.png"], &options[..]].concat(),
                0,
            );
            assert!(make(&dir.path().join("job")).status().unwrap().success());
            are_those_of(&dir.path().join("job/out"), &dir.path().join("whole"));
            fs::remove_dir_all(dir.path().join("job")).unwrap();
        }
        fs::remove_dir_all(dir.path().join("whole")).unwrap();
    }
}

#[test]
#[ignore = "needs make"]
fn bands_of_an_earlier_job_are_not_taken() {
    let dir = one(MONO);
    fs::create_dir(dir.path().join("whole")).unwrap();
    for (tiles, size) in [("3", "16x12"), ("2", "16x12"), ("2", "20x15")] {
        let farm = [
            "farm", "a.zpg", "-o", "job", "--for", "shell", "--tiles", tiles,
        ];
        says(dir.path(), &[&farm[..], &["--size", size]].concat(), 0);
        says(
            dir.path(),
            &["render", "a.zpg", "-o", "whole/a.png", "--size", size],
            0,
        );
        assert!(make(&dir.path().join("job")).status().unwrap().success());
        are_those_of(&dir.path().join("job/out"), &dir.path().join("whole"));
    }
}
