//! Records that are left out: what is said of the ID that they would define, and no guess that hides it.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language};

use super::{read, said};
use crate::support::program::{folder, zpg};

const CAMERA: &str = "9 -501 0 3 12 0 -0.2 -1 0 1 0 45\n";
const LAMP: &str = "50 -402 0.9\n50 -1 4 7 6\n";

fn scene(lines: &str, drawn: &str) -> String {
    format!("{lines}{CAMERA}{LAMP}1 9999 {drawn}\n")
}

/// The errors of a text, of which no guess is taken.
fn untaken(text: &str) -> Vec<Diagnostic> {
    let mended = fixing::to_fixed_point(read(text), true, Analysis::of);
    assert_eq!(mended.analysis.source.text, text);
    let all = repair::proposals(&read(text));
    all.into_iter().filter(Diagnostic::is_error).collect()
}

/// The only error of a text, of which no guess is taken.
fn only(text: &str) -> Diagnostic {
    let mut all = untaken(text);
    let told: Vec<String> = all.iter().flat_map(said).collect();
    assert_eq!(all.len(), 1, "{told:#?}\n{text}");
    all.remove(0)
}

fn written(finding: &Diagnostic) -> Vec<&str> {
    let edits = finding.fixes.iter().flat_map(|f| &f.edits);
    edits.map(|e| e.text.trim()).collect()
}

/// The other colour of a checkerboard is no guess for the one that is missing.
#[test]
fn a_colour_of_a_checkerboard() {
    let floor = "10 5  -5 -5  5 5\n10 -399 8 8  14 15\n";
    let text = scene(&format!("15 -701 0.9 0.9 0.85\n{floor}"), "10 0");
    let finding = only(&text);
    assert_eq!((finding.code, finding.case), (Code::E101, "missing-colour"));
    assert_eq!(finding.fixes, []);
    for (language, message) in [
        (
            Language::English,
            "14 is not defined: the definition of this colour may be missing",
        ),
        (
            Language::Czech,
            "14 není definováno: možná chybí definice této barvy",
        ),
    ] {
        assert_eq!(finding.wording(language).message, message);
    }
    // A third colour, which nothing has, may be meant.
    let colours = "15 -701 0.9 0.9 0.85\n24 -701 0.1 0.1 0.1\n";
    let text = scene(&format!("{colours}{floor}"), "10 0");
    let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
    let meant = [
        text.replace("14 15\n", "24 15\n"),
        text.replace("24 -701", "14 -701"),
    ];
    assert!(meant.contains(&mended.analysis.source.text));
}

/// The colour of an object is rather not the background.
#[test]
fn a_colour_of_the_background() {
    let lines = "2 11 0 1 0 1\n14 -701 1 0 0\n2 -299 14 0\n";
    let finding = only(&scene(lines, "2 16"));
    assert_eq!((finding.code, written(&finding)), (Code::E101, vec!["14"]));
    assert_eq!(finding.notes, ["lost"]);
    // Nothing has it.
    let text = scene("2 11 0 1 0 1\n2 -701 1 0 0\n14 -701 1 0 0\n", "2 16");
    let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
    let meant = [
        text.replace("2 16", "2 14"),
        text.replace("14 -701", "16 -701"),
    ];
    assert!(meant.contains(&mended.analysis.source.text));
}

/// A move before the lamp with the next ID, or behind the one with the ID before, is that of a lamp.
#[test]
fn a_lamp_beside_another() {
    let balls = "2 11 -1 1 0 1\n3 11 1.5 1 0 1\n20 -101 2 3\n";
    for lamps in [
        "50 -1 -4 7 6\n51 -402 0.3\n51 -1 5 5 4\n",
        "49 -402 0.3\n49 -1 5 5 4\n50 -1 -4 7 6\n",
    ] {
        let finding = only(&format!("{balls}{lamps}{CAMERA}1 9999 20 0\n"));
        assert_eq!((finding.code, finding.case), (Code::E101, "missing-lamp"));
        assert_eq!(finding.fixes, []);
        for language in [Language::English, Language::Czech] {
            assert!(finding.wording(language).message.contains("`50 -402`"));
        }
    }
}

/// Behind its use a shape is not moved.
#[test]
fn a_move_behind_the_use_of_a_shape() {
    let lines = "2 11 -1 1 0 1\n3 11 1.5 1 0 1\n20 -101 2 3\n4 -1 -4 7 6\n";
    let text = scene(lines, "20 0");
    let finding = repair::proposals(&read(&text)).remove(0);
    assert_eq!(finding.code, Code::E101);
    let shapes = ["2", "3"];
    assert!(!written(&finding).iter().any(|id| shapes.contains(id)));
}

/// An operation whose colour is left, where two objects are not used.
#[test]
fn an_operation_with_a_colour() {
    let shapes = "2 12 -1 0 -1  1 2 1\n3 11 0 2 1  1\n";
    let rest = "7 11 3 1 0 1\n8 -101 7 6\n";
    for left in ["6 -701 0.9 0.3 0.1\n", "6 -1 0 1 0\n6 -701 0.9 0.3 0.1\n"] {
        let finding = only(&scene(&format!("{shapes}{left}{rest}"), "8 0"));
        assert_eq!(
            (finding.code, finding.case),
            (Code::E101, "missing-operation")
        );
        let operations = ["6 -101 2 3", "6 -102 2 3", "6 -103 2 3"];
        assert_eq!(written(&finding), operations);
        assert_eq!(finding.notes, ["choose"]);
        for (language, message) in [
            (
                Language::English,
                "6 is no object: the record of the object 6 may be missing",
            ),
            (
                Language::Czech,
                "6 není objekt: možná chybí záznam objektu 6",
            ),
        ] {
            assert_eq!(finding.wording(language).message, message);
        }
    }
    // With one object left that one is meant.
    let text = scene(
        &format!("2 11 0 1 0 1\n6 -701 0.9 0.3 0.1\n{rest}2 -299 6 0\n"),
        "8 0",
    );
    let finding = repair::proposals(&read(&text)).remove(0);
    assert_eq!(finding.case, "");
}

/// A picture that is not there keeps no other error of one slip.
#[test]
fn a_picture_that_is_not_there() {
    let lines = "2 11 -2 1 0 1\n3 11 2 1 0 1\n7 11 0 1 3 1\n3 11 0 1 0 1 # koule s texturou #\n\
                 8 -301 mesic.png\n20 -101 2 3\n21 -101 20 7\n4 -101 21 8\n";
    let text = scene(lines, "4 0");
    let dir = folder(&[("a.zpg", &text)]);
    let run = zpg(dir.path(), &["check", "--format", "json", "a.zpg"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
    let all = json["files"][0]["diagnostics"]
        .as_array()
        .expect("findings");
    let errors = all.iter().filter(|d| d["severity"] == "error");
    let codes: Vec<&str> = errors
        .map(|d| d["code"].as_str().expect("a code"))
        .collect();
    assert_eq!(codes, ["E102", "E210"]);
    let run = zpg(dir.path(), &["check", "--fix", "--unsafe-fixes", "a.zpg"]);
    assert!(!run.status.success());
    let made = std::fs::read_to_string(dir.path().join("a.zpg")).expect("a scene");
    assert_eq!(made, text.replace("3 11 0 1 0 1 #", "8 11 0 1 0 1 #"));
}

/// What another operand holds is no guess for an operand.
#[test]
fn parts_of_another_operand() {
    let lines = "2 11 0 1 0 1\n3 11 2 1 0 1\n5 -101 2 3\n6 -101 5 4\n";
    let finding = repair::proposals(&read(&scene(lines, "6 0"))).remove(0);
    assert_eq!(finding.code, Code::E101);
    let guesses = written(&finding);
    assert!(
        !guesses.iter().any(|g| ["2", "3"].contains(g)),
        "{guesses:?}"
    );
}

/// The render record without its ID, whose second number is the number of a type, too.
#[test]
fn a_render_record_without_its_id() {
    let text = scene("24 11 0 1 0 1\n16 -701 1 0 0\n", "24 16");
    let slip = text.replace("1 9999", "9999");
    let finding = repair::proposals(&read(&slip)).remove(0);
    assert_eq!((finding.code, finding.case), (Code::E005, "lost"));
    assert_eq!(finding.fixes.len(), 1);
    let mended = fixing::to_fixed_point(read(&slip), true, Analysis::of);
    assert_eq!(mended.analysis.source.text, text);
}

/// A colour or an optical property that is used elsewhere is rather not the one that is missing, even with the next ID.
#[test]
fn a_property_beside_one_that_is_used() {
    let floor = "61 -701 1 1 1\n62 -701 0.5 0.7 0.9\n10 12 -4 -1 -4 4 0 4\n10 -399 8 8 60 61\n";
    let balls =
        "36 -201 0.5 0 0.5\n2 11 -1 1 0 1\n3 11 1 1 0 1\n2 -299 0 35\n3 -299 0 36\n4 -101 2 3\n";
    for (lines, drawn, said) in [(floor, "10 62", "60"), (balls, "4 0", "35")] {
        let finding = only(&scene(lines, drawn));
        assert_eq!(
            (finding.code, finding.notes.as_slice()),
            (Code::E101, &["lost"][..])
        );
        for (language, message, note) in [
            (
                Language::English,
                "is not defined",
                "its definition may be missing",
            ),
            (
                Language::Czech,
                "není definováno",
                "možná chybí jeho definice",
            ),
        ] {
            let wording = finding.wording(language);
            assert_eq!(wording.message, format!("{said} {message}"));
            assert!(
                wording.notes.iter().any(|n| n.starts_with(note)),
                "{:?}",
                wording.notes
            );
        }
    }
    // What nothing else has is meant: all IDs are off by one, or one is.
    for (text, meant) in [
        (scene(floor, "10 0"), "10 -399 8 8 61 62\n"),
        (
            scene(&balls.replace("3 -299 0 36\n", ""), "4 0"),
            "2 -299 0 36\n",
        ),
    ] {
        let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
        assert!(
            mended.analysis.source.text.contains(meant),
            "{}",
            mended.analysis.source.text
        );
    }
}
