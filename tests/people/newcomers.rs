//! What somebody writes who knows POV-Ray, or has lost a number or the order of two: all guesses together make the
//! scene that was meant.

use zpg::analysis::{Analysis, fixing};

use super::read;

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

fn fixed(text: &str) -> String {
    let mended = fixing::to_fixed_point(read(text), true, Analysis::of);
    mended.analysis.source.text.clone()
}

/// What is written before the rest, and what was meant.
const BEFORE: &[(&str, &str)] = &[
    // POV-Ray turns about x, then y, then z, and no turn is a move.
    (
        "2 12 -1 -1 -1 1 1 1\n2 -2 30 45 0\n",
        "2 12 -1 -1 -1 1 1 1\n2 -2 30 1\n2 -2 45 2\n",
    ),
    (
        "2 12 -1 -1 -1 1 1 1\n2 -2 10 20 30\n",
        "2 12 -1 -1 -1 1 1 1\n2 -2 10 1\n2 -2 20 2\n2 -2 30 3\n",
    ),
    // The place of a torus first: its tube is the thinner one.
    (
        "2 14 1.3 1.5 -3 0.5 0.15\n",
        "2 14 0.5 0.15\n2 -1 1.3 1.5 -3\n",
    ),
    ("2 14 0 1 0 0.5 0.15\n", "2 14 0.5 0.15\n2 -1 0 1 0\n"),
    ("2 10 0 1 0 0.5 0.6 0.7\n", "2 10 0.5 0.6 0.7\n2 -1 0 1 0\n"),
    (
        "2 14 0.5 0.15 1.3 1.5 -3\n",
        "2 14 0.5 0.15\n2 -1 1.3 1.5 -3\n",
    ),
];

#[test]
fn lines_before_the_rest_of_a_scene() {
    for (written, meant) in BEFORE {
        assert_eq!(fixed(&format!("{written}{REST}")), format!("{meant}{REST}"));
    }
}

/// What is used as an object and is a colour only has lost its definition to the ID of the render record.
#[test]
fn an_object_with_the_id_of_the_render_record() {
    for (written, meant) in [
        (
            "2 9 1\n1 11 2 0 0 1\n3 -701 1 0 0\n4 -101 2 3\n1 9999 4 0\n",
            "2 9 1\n3 11 2 0 0 1\n3 -701 1 0 0\n4 -101 2 3\n1 9999 4 0\n",
        ),
        (
            "35 -201 0.8 0.2 0\n2 9 1\n1 11 1 1 0 0.6\n4 -701 1 0 0\n4 -299 0 35\n7 -103 2 4\n1 9999 7 0\n",
            "35 -201 0.8 0.2 0\n2 9 1\n4 11 1 1 0 0.6\n4 -701 1 0 0\n4 -299 0 35\n7 -103 2 4\n1 9999 7 0\n",
        ),
    ] {
        assert_eq!(fixed(written), meant);
    }
}

/// A move that is a guess takes the object out of view; the camera was right.
#[test]
fn no_guess_follows_another_one() {
    let written = "2 11 0 0 0 1 0 0 90\n";
    let moved = "2 11 0 0 0 1\n2 -1 0 0 90\n";
    assert_eq!(fixed(&format!("{written}{REST}")), format!("{moved}{REST}"));
}
