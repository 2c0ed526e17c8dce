//! Text of POV-Ray behind an ID or alone on a line: the records that it stands for, and nothing of it is lost.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::Diagnostic;

use super::{fixed, read};

/// A ball with a line behind it, a camera, a lamp, and what is drawn.
fn scene(line: &str) -> String {
    let rest = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    format!("2 11 0.5 0.5 0 1\n{line}\n{rest}")
}

/// A text becomes another, for one error.
fn becomes(text: &str, meant: &str) {
    let all = repair::proposals(&read(text));
    let errors: Vec<&Diagnostic> = all.iter().filter(|d| d.is_error()).collect();
    assert_eq!(errors.len(), 1, "{text}{errors:#?}");
    assert_eq!(fixed(text), meant);
}

/// Vectors along an axis, and turns about one.
#[test]
fn vectors_along_an_axis() {
    for (line, meant) in [
        ("2 -2 80*x", "2 -2 80 1"),
        ("2 -2 x*80", "2 -2 80 1"),
        ("2 -1 2*z", "2 -1 0 0 2"),
        ("2 -1 -z", "2 -1 0 0 -1"),
        ("2 translate 2*z", "2 -1 0 0 2"),
        ("2 translate z*-2", "2 -1 0 0 -2"),
    ] {
        becomes(&scene(line), &scene(meant));
    }
    let part = |line: &str| {
        let line = format!("20 {line}\n21 -101 2 20");
        scene(&line).replace("9999 2", "9999 21")
    };
    for (line, meant) in [("4 y 0", "4 0 1 0 0"), ("11 2*y 0.5", "11 0 2 0 0.5")] {
        becomes(&part(line), &part(meant));
    }
    // The plane of POV-Ray is on the other side of the origin; a scaling would leave nothing.
    assert_eq!(fixed(&part("4 y 1")), part("4 y 1"));
    assert_eq!(fixed(&scene("2 -3 2*y")), scene("2 -3 2*y"));
}
