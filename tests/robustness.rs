//! Bad input: whatever the bytes, an answer, memory in proportion, exit 0, 1 or 2.

use std::io::Write;
use std::process::{Command, Stdio};

use proptest::prelude::*;
use zpg::internals::analysis::Analysis;

use crate::support::cases;

/// Address space of the process, in KiB, for inputs of a few megabytes.
const MEMORY_KIB: u32 = 4 << 20;

/// Stack of its first thread, in KiB: small enough that any recursion on the depth of a scene is found.
const STACK_KIB: u32 = 1 << 10;

/// Runs a command on standard input with limited memory and gives its exit status and errors.
fn run(arguments: &[&str], input: &[u8]) -> (i32, String) {
    let mut child = Command::new("sh")
        .arg("-c")
        .arg(format!(
            "ulimit -v {MEMORY_KIB}; ulimit -s {STACK_KIB}; exec \"$0\" \"$@\""
        ))
        .arg(crate::support::program::PATH)
        .args(arguments)
        .env("RUST_BACKTRACE", "0")
        .env("LC_ALL", "C")
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    let writer = std::thread::spawn(move || stdin.write_all(&input));
    let output = child.wait_with_output().unwrap();
    let _ = writer.join();
    let code = output.status.code().unwrap_or(-1);
    (code, String::from_utf8_lossy(&output.stderr).into_owned())
}

#[track_caller]
fn answers(name: &str, input: &[u8]) {
    for arguments in [
        &["check", "-"][..],
        &["check", "-", "--format", "json"],
        &["fmt", "-"],
        &["convert", "-", "--to", "pov"],
        &["render", "-", "-o", "-", "--size", "8x6"],
    ] {
        // A picture needs a file to go to.
        let folder = tempfile::tempdir().unwrap();
        let picture = folder.path().join("p.png");
        let picture = picture.to_str().unwrap();
        let arguments: Vec<&str> = arguments
            .iter()
            .enumerate()
            .map(|(i, a)| if i == 3 && *a == "-" { picture } else { *a })
            .collect();
        let (code, errors) = run(&arguments, input);
        assert!(
            (0..=2).contains(&code),
            "{name}: {arguments:?} ended with {code}\n{errors:.2000}"
        );
        assert!(
            !errors.contains("panicked"),
            "{name}: {arguments:?}\n{errors:.2000}"
        );
    }
}

fn chain(record: impl Fn(u32, u32) -> String, n: u32) -> Vec<u8> {
    let mut text = "2 9 1\n3 11 0.5 0 0 1\n".to_owned();
    for i in 4..4 + n {
        text += &record(i, if i == 4 { 2 } else { i - 1 });
    }
    text += &format!("1 9999 {} 0\n", 3 + n);
    text.into_bytes()
}

#[test]
fn bytes_that_are_no_scene() {
    let mut state = 1u64;
    let many = cases(20_000, 50_000);
    let noise: Vec<u8> = (0..many)
        .map(|_| {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 56) as u8
        })
        .collect();
    answers("noise", &noise);
    answers("nothing", b"");
    answers("NULs", &vec![0; many]);
    answers("digits", "9".repeat(2_000_000).as_bytes());
    answers("zeros", "0 ".repeat(many).as_bytes());
    answers("ones", "1 ".repeat(many).as_bytes());
    answers("number signs", "#\n".repeat(2 * many + 1).as_bytes());
    answers("one long line", "2 9 1 x ".repeat(many / 2).as_bytes());
}

#[test]
fn claims_that_no_file_can_hold() {
    answers("N", b"2 1 2000000000 0 1 1 0\n1 9999 2 0\n");
    answers("N", b"2 2 2000000000 0 1 1 0\n1 9999 2 0\n");
    answers("N", b"2 1 9223372036854775807 0 1\n");
    answers("N", b"2 1 99999999999999999999999999 0 1\n");
    answers(
        "cells",
        b"2 -701 1 1 1\n3 9 1\n3 -399 2147483647 2147483647 2 2\n1 9999 3 0\n",
    );
    answers(
        "cells",
        b"2 -701 1 1 1\n3 9 1\n3 -399 99999999999 2 2 2\n1 9999 3 0\n",
    );
    answers(
        "numbers",
        b"2 11 1e308 -1e308 1e-320 1e308\n2 -3 1e200 1e200 1e200\n2 -3 1e200 1 1\n1 9999 2 0\n",
    );
}

#[test]
fn long_chains() {
    let n = cases(8_000, 20_000);
    for op in [-101, -102, -103] {
        answers(
            &op.to_string(),
            &chain(|i, b| format!("{i} {op} {b} 3\n"), n),
        );
    }
    answers("complement", &chain(|i, b| format!("{i} -104 {b}\n"), n));
    answers("copy", &chain(|i, b| format!("{i} -105 {b}\n"), n));
    answers(
        "mixed",
        &chain(|i, b| format!("{i} {} {b} 3\n", -101 - i as i32 % 3), n),
    );
    answers(
        "moves",
        &chain(|_, _| "3 -1 0.1 0 0\n3 -701 1 0 0\n".into(), n),
    );
}

#[test]
fn many_doublings() {
    // Each proposal is tried, with a search for contacts among as many copies as one may look at.
    for (op, times) in [(-101, 60), (-102, 24), (-103, 60)] {
        answers(
            &op.to_string(),
            &chain(|i, b| format!("{i} {op} {b} {b}\n"), times),
        );
    }
}

#[test]
fn many_mistakes() {
    let last = cases(1_500, 4_000);
    let lines = |f: &dyn Fn(u32) -> String| (2..last).map(f).collect::<String>().into_bytes();
    answers(
        "undefined",
        &lines(&|i| format!("{i} -101 {} {}\n", i + 500_000, i + 600_000)),
    );
    answers("duplicates", &lines(&|_| "2 9 1\n".into()));
    answers(
        "lost",
        &lines(&|i| format!("-101 2 3\n{i} -104 {}\n", i + 500_000)),
    );
    answers("unknown", &lines(&|i| format!("{i} 77 1 2 3\n")));
    answers("counts", &lines(&|i| format!("{i} 1 50000 1 2 3\n")));
}

/// Pieces of scenes, to get further into the parser than random bytes do.
const PIECES: &[&str] = &[
    "0",
    "1",
    "2",
    "3",
    "9",
    "11",
    "15",
    "18",
    "20",
    "-1",
    "-2",
    "-101",
    "-103",
    "-202",
    "-299",
    "-301",
    "-302",
    "-399",
    "-501",
    "9999",
    "0.5",
    "1e9",
    "-0",
    "+7",
    "1e999",
    "1.2.3",
    "0,5",
    "x",
    "@",
    "\"a b\"",
    "wood.png",
    "#",
    "# a #",
    "# zpg: x #",
    "\n",
    "\n",
    "\r\n",
    "\t",
    ",",
    "<",
    ">",
    "\u{feff}",
    "\u{0}",
    "ž",
    "−1",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn check_never_panics_on_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        examine(bytes);
    }

    #[test]
    fn check_never_panics_on_pieces(
        pieces in proptest::collection::vec(proptest::sample::select(PIECES), 0..80),
        spaced in any::<bool>(),
    ) {
        examine(pieces.join(if spaced { " " } else { "" }).into_bytes());
    }
}

/// What must hold of any input.
fn examine(bytes: Vec<u8>) {
    let loaded = Analysis::new("p.zpg", bytes);
    let text = &loaded.source.text;
    assert_eq!(&loaded.document.print(text), text);
    let mut last = 0;
    for item in &loaded.document.items {
        let span = loaded.document.item_span(item);
        assert!(span.start >= last && span.end > span.start);
        last = span.end;
    }
    for d in loaded.findings() {
        let spans = d.labels.iter().map(|l| l.span).chain([d.span]);
        let edits = d.fixes.iter().flat_map(|f| f.edits.iter().map(|e| e.span));
        for span in spans.chain(edits) {
            assert!(text.get(span.range()).is_some(), "{span:?} of {d:?}");
        }
    }
}
