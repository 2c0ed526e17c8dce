//! Scenes that would need more memory than is allowed are refused, in words, before they take it.

use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Output};

/// Runs zpg with so much address space, in MiB.
fn limited(mebibytes: u64, folder: &Path, arguments: &[&str]) -> Output {
    Command::new("sh")
        .arg("-c")
        .arg(format!("ulimit -v {}; exec \"$0\" \"$@\"", mebibytes << 10))
        .arg(crate::support::program::PATH)
        .args(arguments)
        .env("LC_ALL", "C")
        .current_dir(folder)
        .output()
        .unwrap()
}

/// A ball, and again and again a copy of all, moved, and both together.
fn doublings(count: u32, by: &str) -> String {
    let mut text = "2 9 1\n".to_owned();
    let mut last = 2;
    for id in (3..).step_by(2).take(count as usize) {
        let sum = id + 1;
        writeln!(
            text,
            "{id} -105 {last}\n{id} -1 {by}\n{sum} -101 {last} {id}"
        )
        .unwrap();
        last = sum;
    }
    let camera = "900 -501 0 0 9  0 0 -1  0 1 0  45\n901 -402 1\n901 -1 3 5 5\n";
    text + camera + &format!("1 9999 {last} 0\n")
}

const OVERLAPPING: &str = "0.1 0.07 0.03";

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

#[test]
fn copies_that_overlap_are_refused_before_they_fill_the_memory() {
    let dir = tempfile::tempdir().unwrap();
    for (count, parts) in [(26, "2^26"), (64, "2^64"), (400, "2^400")] {
        let scene = doublings(count, OVERLAPPING);
        std::fs::write(dir.path().join("a.zpg"), scene).unwrap();
        for arguments in [
            &["render", "a.zpg", "--size", "32x24"][..],
            &["render", "a.zpg", "--size", "32x24", "--threads", "9999"],
            &["render", "a.zpg", "--size", "32x24", "--precision", "dd"],
            &["probe", "a.zpg", "--ray", "0 0 9  0 0 -1"],
            &["probe", "a.zpg", "--pixel", "3,4", "--size", "8x6"],
            &["convert", "a.zpg", "--to", "pov"],
            &["convert", "a.zpg", "--to", "ply"],
            &["convert", "a.zpg", "--to", "obj"],
            &["convert", "a.zpg", "--to", "glb"],
            &["convert", "a.zpg", "--to", "mitsuba", "-o", "a.xml"],
        ] {
            let output = limited(3000, dir.path(), arguments);
            let said = said(&output);
            assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
            if !said.contains("triangles") {
                assert!(said.contains(parts), "{arguments:?}: {said}");
                assert!(said.contains("--memory 1.5G"), "{arguments:?}: {said}");
            }
        }
        // What looks at each part once does not mind.
        for arguments in [
            &["check", "a.zpg"][..],
            &["convert", "a.zpg", "--to", "json"],
            &["convert", "a.zpg", "--to", "zpg"],
            &["probe", "a.zpg", "--point", "0 0 0"],
            &["plan", "a.zpg"],
        ] {
            let output = limited(3000, dir.path(), arguments);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{arguments:?}: {}",
                said(&output)
            );
        }
        let left = std::fs::read_dir(dir.path()).unwrap().count();
        assert_eq!(left, 1, "nothing is written");
    }
}

/// As many doublings as there is memory for are drawn within it.
#[test]
fn what_is_begun_keeps_to_the_memory() {
    let dir = tempfile::tempdir().unwrap();
    let mut drawn = 0;
    for count in [4, 14, 15, 16, 17, 18] {
        let scene = doublings(count, OVERLAPPING);
        std::fs::write(dir.path().join("a.zpg"), scene).unwrap();
        for precision in ["f64", "dd"] {
            let arguments = ["render", "a.zpg", "--size", "4x3", "--memory", "300M"];
            let arguments = [&arguments[..], &["--precision", precision]].concat();
            let stats = [&arguments[..], &["--stats", "s.json", "--threads", "2"]].concat();
            let output = limited(4000, dir.path(), &stats);
            match output.status.code() {
                Some(0) => {
                    let stats = std::fs::read(dir.path().join("s.json")).unwrap();
                    let stats: serde_json::Value = serde_json::from_slice(&stats).unwrap();
                    let peak = stats["peak_memory_bytes"].as_u64().unwrap();
                    assert!(peak < 300 << 20, "{count} {precision}: {peak}");
                    drawn += 1;
                }
                code => assert_eq!(code, Some(1), "{}", said(&output)),
            }
        }
    }
    assert!(drawn >= 4, "{drawn}");
}

#[test]
fn shared_parts_that_do_not_overlap_are_drawn() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let billion = root.join("scenes/gallery/billion.zpg");
    let arguments = [
        "render",
        billion.to_str().unwrap(),
        "--size",
        "32x24",
        "--samples",
        "1",
        "--memory",
        "100M",
    ];
    let output = limited(3000, dir.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
}

#[test]
fn sizes_that_need_too_much_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.zpg"), doublings(2, OVERLAPPING)).unwrap();
    let big = "2 9 1 # the same again #\n".repeat(100_000);
    std::fs::write(dir.path().join("b.zpg"), big).unwrap();
    for (arguments, what) in [
        (
            &["render", "a.zpg", "--size", "16000x16000", "--memory", "1G"][..],
            "the picture would take",
        ),
        (&["render", "b.zpg", "--memory", "100M"], "it is so long"),
        (
            &[
                "probe",
                "b.zpg",
                "--ray",
                "0 0 9 0 0 -1",
                "--memory",
                "100M",
            ],
            "it is so long",
        ),
        (
            &["convert", "b.zpg", "--to", "zpg", "--memory", "100M"],
            "it is so long",
        ),
        (&["check", "b.zpg", "--memory", "100M"], "it is so long"),
        (&["check", "a.zpg", "--memory", "much"], "800M or 12G"),
    ] {
        let output = limited(3000, dir.path(), arguments);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?}: {}",
            said(&output)
        );
        assert!(
            said(&output).contains(what),
            "{arguments:?}: {}",
            said(&output)
        );
    }
    let output = limited(3000, dir.path(), &["check", "b.zpg"]);
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn threads_are_four_for_each_processor_at_most() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.zpg"), doublings(2, OVERLAPPING)).unwrap();
    let cores = std::thread::available_parallelism().unwrap().get();
    let most = 4 * cores;
    let wanted = most.to_string();
    for (threads, expected) in [("9999", most), ("0", cores), ("1", 1), (&wanted, most)] {
        let arguments = [
            "render",
            "a.zpg",
            "--size",
            "8x6",
            "--stats",
            "s.json",
            "--threads",
            threads,
        ];
        let output = limited(3000, dir.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let stats = std::fs::read(dir.path().join("s.json")).unwrap();
        let stats: serde_json::Value = serde_json::from_slice(&stats).unwrap();
        assert_eq!(stats["threads"], expected);
        assert_eq!(
            said(&output).contains("--threads 9999 is too many"),
            threads == "9999"
        );
    }
}
