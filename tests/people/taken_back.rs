//! Textures and colours that a line below takes away: by 0 for T, or since it has the ID of the object above.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language, fixes};

use super::read;

const PROPERTIES: &str = "14 -701 0.9 0.1 0.1\n15 -701 0.1 0.9 0.1\n35 -201 0.7 0.3 0\n";

fn scene(lines: &str, drawn: u32) -> String {
    let rest = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n1 9999";
    format!("{PROPERTIES}{lines}{rest} {drawn} 0\n")
}

/// What is said of colours, textures and assignments.
fn said(text: &str) -> Vec<Diagnostic> {
    let mut all = repair::proposals(&read(text));
    all.retain(|d| matches!(d.code, Code::W331 | Code::W334));
    all
}

/// 0 for T removes what was given above; the guess keeps it.
#[test]
fn zero_for_a_texture_removes_it() {
    let slips = [
        (
            "2 11 0 1 0 1\n2 -399 8 4 14 15\n2 -299 0 35\n",
            "2 11 0 1 0 1\n2 -299 0 35\n2 -399 8 4 14 15\n",
        ),
        (
            "2 11 0 1 0 1\n2 -701 0.9 0.5 0.1\n2 -299 0 35\n",
            "2 11 0 1 0 1\n2 -299 0 35\n2 -701 0.9 0.5 0.1\n",
        ),
        (
            "2 11 0 1 0 1\n2 -701 0.9 0.5 0.1\n2 -1 1 0 0\n2 -299 0 35\n",
            "2 11 0 1 0 1\n2 -1 1 0 0\n2 -299 0 35\n2 -701 0.9 0.5 0.1\n",
        ),
        (
            "16 -399 8 4 14 15\n2 11 0 1 0 1\n2 -299 16 0\n2 -299 0 35\n",
            "16 -399 8 4 14 15\n2 11 0 1 0 1\n2 -299 16 35\n",
        ),
    ];
    for (lines, meant) in slips {
        let text = scene(lines, 2);
        let all = said(&text);
        assert_eq!((all.len(), all[0].case), (1, "taken-back"), "{lines}");
        let [english, czech] =
            [Language::English, Language::Czech].map(|l| all[0].wording(l).message);
        assert!(english.contains("T is 0"), "{english}");
        assert!(czech.contains("T = 0"), "{czech}");
        let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
        assert_eq!(mended.analysis.source.text, scene(meant, 2));
        assert!(said(&scene(meant, 2)).is_empty(), "{meant}");
    }
}

/// What moves with its object cannot stand behind its transformation.
#[test]
fn a_checkerboard_is_not_moved_behind_a_transformation() {
    let all = said(&scene(
        "2 11 0 1 0 1\n2 -399 8 4 14 15\n2 -1 1 0 0\n2 -299 0 35\n",
        2,
    ));
    assert_eq!((all.len(), all[0].case), (1, "taken-back"));
    assert!(all[0].fixes.is_empty());
}

/// An assignment of another texture or colour overrides a colour, too.
#[test]
fn an_assignment_overrides_a_colour() {
    let all = said(&scene(
        "2 11 0 1 0 1\n2 -701 0.9 0.5 0.1\n2 -299 14 35\n",
        2,
    ));
    assert_eq!((all.len(), all[0].case), (1, "given"));
}

/// A copy is taken back to the default on purpose, and so is what something has been made of.
#[test]
fn zero_may_be_meant() {
    for lines in [
        "2 11 0 1 0 1\n2 -701 0.9 0.5 0.1\n3 -1000 2\n3 -299 0 35\n4 -101 2 3\n",
        "2 11 0 1 0 1\n2 -701 0.9 0.5 0.1\n3 -1000 2\n2 -299 0 35\n2 -1 3 0 0\n4 -101 2 3\n",
        "2 11 0 1 0 1\n2 -299 0 35\n2 -701 0.9 0.5 0.1\n3 11 2 1 0 1\n4 -101 2 3\n",
    ] {
        assert!(said(&scene(lines, 4)).is_empty(), "{lines}");
    }
}

/// A copied line covers the texture of the object above: the object that has none is a choice.
#[test]
fn a_colour_with_the_id_of_the_object_above() {
    let lines = "16 -399 8 4 14 15\n2 11 0 1 0 1\n2 -299 16 0\n3 16 -2 1\n3 -1 1.2 2 0\n\
                 2 -701 0.1 0.6 0.3\n4 -101 2 3\n";
    let text = scene(lines, 4);
    let all = said(&text);
    assert_eq!((all.len(), all[0].code), (1, Code::W331));
    let meant = scene(&lines.replace("2 -701", "3 -701"), 4);
    assert_eq!(fixes::apply(&text, all[0].fixes.iter()).0, meant);
    assert!(said(&meant).is_empty());
    // Nothing but the object itself can be meant.
    let alone = "16 -399 8 4 14 15\n2 11 0 1 0 1\n2 -299 16 0\n2 -701 0.1 0.6 0.3\n";
    assert!(said(&scene(alone, 2))[0].fixes.is_empty());
}

/// The two numbers of an assignment are written anew in whatever order they stand.
#[test]
fn an_optical_property_that_is_none() {
    let free = "5 -701 0.9 0.2 0.1\n2 9 1\n2 -299 0 4\n1 9999 2 0\n";
    let two = "5 -701 0.9 0.2 0.1\n6 -701 0.2 0.3 0.9\n2 11 0 1 0 1\n2 -299 0 5\n1 9999 2 0\n";
    for (text, meant) in [(free, "2 -299 5 0"), (two, "2 -299 5 0")] {
        let all = repair::proposals(&read(text));
        let error = all.iter().find(|d| d.is_error()).expect("4 and 5 are none");
        let fix = error.fixes.first().expect("a guess");
        let (mended, _) = fixes::apply(text, [fix].into_iter());
        assert!(mended.contains(meant), "{mended}");
    }
}
