//! What people write who know other programs: directions as points, colours by name, several records in one.

use std::fs;

use zpg::internals::analysis::{Analysis, repair};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, fixes};

use super::rules::{SCENE, with};
use super::{fixed, guessed, read};

/// What the first fix of the first finding with a code makes of a text.
#[track_caller]
fn first(text: &str, code: Code) -> String {
    let all = repair::proposals(&read(text));
    let finding = all.iter().find(|d| d.code == code);
    let finding = finding.unwrap_or_else(|| panic!("{text}\n{all:?}"));
    fixes::apply(text, finding.fixes.first().into_iter()).0
}

fn codes(text: &str) -> Vec<Code> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).map(|d| d.code).collect()
}

/// A line of the scene, what is found in it, and the lines that were meant.
const LINES: &[(usize, &str, Code, &str)] = &[
    // The numbers behind a lamp's, and behind a shape's.
    (
        13,
        "10 -402 0.8 4 6 5",
        Code::E009,
        "10 -402 0.8\n10 -1 4 6 5",
    ),
    (13, "10 -402 4 6 5", Code::E009, "10 -402 1\n10 -1 4 6 5"),
    (
        13,
        "10 -402 0.8 4 6 5 1 0 0",
        Code::E009,
        "10 -402 0.8\n10 -1 4 6 5\n10 -701 1 0 0",
    ),
    (
        13,
        "10 -402 0.8 # lamp # 4 6 5",
        Code::E009,
        "10 -402 0.8 # lamp # \n10 -1 4 6 5",
    ),
    (
        12,
        "9 -401 0.3 1 0 0",
        Code::E009,
        "9 -401 0.3\n9 -701 1 0 0",
    ),
    (
        5,
        "5 11 0 1 0 1 4 6 5",
        Code::E009,
        "5 11 0 1 0 1\n5 -1 4 6 5",
    ),
    // As POV-Ray has it: the place first, which brackets may say.
    (
        13,
        "10 -402 4 6 5 0.9",
        Code::E009,
        "10 -402 0.9\n10 -1 4 6 5",
    ),
    (
        13,
        "10 -402 <4, 6, 5> 1",
        Code::E009,
        "10 -402 1\n10 -1 4 6 5",
    ),
    (
        13,
        "10 -402 <4,6,5>, 1",
        Code::E009,
        "10 -402 1\n10 -1 4 6 5",
    ),
    (
        13,
        "10 402 4 6 5 0.9",
        Code::E007,
        "10 -402 0.9\n10 -1 4 6 5",
    ),
    (
        13,
        "10 -402 <4,6,5> <1,0,0>",
        Code::E009,
        "10 -402 1\n10 -1 4 6 5\n10 -701 1 0 0",
    ),
    (13, "10 -402 <4,6,5>", Code::E009, "10 -402 1\n10 -1 4 6 5"),
    (
        13,
        "10 -402 1 <4,6,5>",
        Code::E009,
        "10 -402 1\n10 -1 4 6 5",
    ),
    (
        5,
        "5 14 <0,1,0> 2 0.5",
        Code::E009,
        "5 14 2 0.5\n5 -1 0 1 0",
    ),
    (
        5,
        "5 torus <0,1,0> 2 0.5",
        Code::E006,
        "5 14 2 0.5\n5 -1 0 1 0",
    ),
    (
        5,
        "5 torus <0, 1, 0>, 2, 0.5",
        Code::E006,
        "5 14 2 0.5\n5 -1 0 1 0",
    ),
    (
        5,
        "5 cylinder <0,0,0>, <0,2,0>, 0.5",
        Code::E006,
        "5 1 2 0.5 0 0.5 2",
    ),
    (
        5,
        "5 cone <0,0,0>, 1, <0,2,0>, 0",
        Code::E006,
        "5 1 2 1 0 0 2",
    ),
    (
        5,
        "5 cone 1 0 0 1 1 2 0 0.5",
        Code::E006,
        "5 1 2 1 0 0.5 2\n5 -1 1 0 0",
    ),
    (
        17,
        "1 9999 8 <0.2,0.3,0.4>",
        Code::E009,
        "12 -701 0.2 0.3 0.4\n1 9999 8 12",
    ),
    // A rotation about a vector.
    (8, "6 -2 30 0 1 0", Code::E009, "6 -2 30 2"),
    (8, "6 -2 0 0 -1 30", Code::E009, "6 -2 -30 3"),
    (8, "6 -2 <0,1,0>, 30", Code::E009, "6 -2 30 2"),
    // Three operands.
    (
        10,
        "12 9 1\n13 9 2\n7 -103 6 5 12 13",
        Code::E009,
        "12 9 1\n13 9 2\n14 -103 6 5\n15 -103 14 12\n7 -103 15 13",
    ),
    // The points of a profile, counted.
    (5, "5 1 5 0 0 1 1", Code::E008, "5 1 2 0 0 1 1"),
    (5, "5 1 5 0 0 1 1 0 2", Code::E008, "5 1 3 0 0 1 1 0 2"),
    // Colours by name are no comment.
    (
        3,
        "12 -302 white black 1\n4 12 -3 -1 -3 3 0 3",
        Code::E012,
        "13 -701 1 1 1\n14 -701 0 0 0\n12 -302 13 14 1\n4 12 -3 -1 -3 3 0 3",
    ),
    // The lost minus wins over a sphere.
    (13, "10 402 1 4 6 5", Code::E007, "10 -402 1\n10 -1 4 6 5"),
    (
        13,
        "10 402 1 4 6 5 1 0 0",
        Code::E007,
        "10 -402 1\n10 -1 4 6 5\n10 -701 1 0 0",
    ),
    // One number for three.
    (
        6,
        "5 -1 0.5 0 0\n5 -203 1.5",
        Code::E008,
        "5 -1 0.5 0 0\n5 -203 1.5 1.5 1.5",
    ),
    (1, "2 -701 0.5", Code::E008, "2 -701 0.5 0.5 0.5"),
    // Axes by letters.
    (8, "6 -2 30 y", Code::E012, "6 -2 30 2"),
    (8, "6 -2 y 30", Code::E012, "6 -2 30 2"),
    (8, "6 -2 X -30", Code::E012, "6 -2 -30 1"),
    (8, "6 -2 30 Z", Code::E012, "6 -2 30 3"),
    // Colours by name; 128 of 255 is 0.2158605 in linear light.
    (1, "2 -701 red", Code::E003, "2 -701 1 0 0"),
    (1, "2 -701 červená", Code::E003, "2 -701 1 0 0"),
    (
        1,
        "2 -701 \"white\" # w #",
        Code::E003,
        "2 -701 1 1 1 # w #",
    ),
    (1, "2 -701 maroon", Code::E003, "2 -701 0.216 0 0"),
    (1, "2 -701 hnědá", Code::E003, "2 -701 0.376 0.023 0.023"),
    (
        1,
        "2 -701 rebeccapurple",
        Code::E003,
        "2 -701 0.133 0.033 0.32",
    ),
    (1, "2 -701 fialový", Code::E003, "2 -701 0.216 0 0.216"),
    // Materials.
    (
        6,
        "5 -1 0.5 0 0\n5 -201 sklo",
        Code::E003,
        "5 -1 0.5 0 0\n5 -201 0 0.1 0.9",
    ),
    (
        6,
        "5 -1 0.5 0 0\n5 -203 glass # g #",
        Code::E003,
        "5 -1 0.5 0 0\n5 -203 1.5 1.5 1.5 # g #",
    ),
    (
        6,
        "5 -1 0.5 0 0\n5 -201 Mirror",
        Code::E003,
        "5 -1 0.5 0 0\n5 -201 0 1 0",
    ),
    (1, "2 -701 zelena", Code::E003, "2 -701 0 0.216 0"),
    // Colours where their IDs belong.
    (
        17,
        "1 9999 8 0.2 0.3 0.4",
        Code::E009,
        "12 -701 0.2 0.3 0.4\n1 9999 8 12",
    ),
    (
        17,
        "1 9999 8 modrá",
        Code::E012,
        "12 -701 0 0 1\n1 9999 8 12",
    ),
    (
        17,
        "1 9999 8 0 0.5 1 -9 -9 -9 9 9 9",
        Code::E009,
        "12 -701 0 0.5 1\n1 9999 8 12 -9 -9 -9 9 9 9",
    ),
    (
        3,
        "12 -399 4 4 1 0 0 1 1 1\n4 12 -3 -1 -3 3 0 3",
        Code::E009,
        "13 -701 1 0 0\n14 -701 1 1 1\n12 -399 4 4 13 14\n4 12 -3 -1 -3 3 0 3",
    ),
    (
        3,
        "12 -399 4 4 2 0 0 1\n4 12 -3 -1 -3 3 0 3",
        Code::E009,
        "13 -701 0 0 1\n12 -399 4 4 2 13\n4 12 -3 -1 -3 3 0 3",
    ),
    (
        3,
        "12 -399 4 4 red 2\n4 12 -3 -1 -3 3 0 3",
        Code::E012,
        "13 -701 1 0 0\n12 -399 4 4 13 2\n4 12 -3 -1 -3 3 0 3",
    ),
    // A cylinder.
    (5, "5 cylinder 1 2", Code::E006, "5 1 2 1 0 1 2"),
    (5, "5 válec 1 2", Code::E006, "5 1 2 1 0 1 2"),
    (5, "5 cylinder 0 0 0 0 2 0 1", Code::E006, "5 1 2 1 0 1 2"),
    (
        5,
        "5 cylinder 2 0 1 2 3 1 0.5",
        Code::E006,
        "5 1 2 0.5 0 0.5 3\n5 -1 2 0 1",
    ),
    // The camera stands at 0 4 12 and looks at 0 1 0.
    (
        16,
        "11 -501 0 4 12 0 1 0 0 1 0 40",
        Code::E207,
        "11 -501 0 4 12 0 -3 -12 0 1 0 40",
    ),
    (
        16,
        "11 -501 0 4 12 0 0 0 0 1 0 40",
        Code::E203,
        "11 -501 0 4 12 0 -4 -12 0 1 0 40",
    ),
    (
        16,
        "11 -501 9 4 12 1 0.1 0.3 0 1 0 40",
        Code::W324,
        "11 -501 9 4 12 -8 -3.9 -11.7 0 1 0 40",
    ),
    // Its position, the point, and the angle.
    (
        16,
        "11 -501 0 4 12 0 1 0 40",
        Code::E008,
        "11 -501 0 4 12 0 -3 -12 0 1 0 40",
    ),
    // Straight down from above.
    (
        16,
        "11 -501 0 20 0 0 -1 0 0 1 0 40",
        Code::E207,
        "11 -501 0 20 0 0 -1 0 0 0 -1 40",
    ),
];

#[test]
fn lines_that_other_programs_would_understand() {
    for &(line, written, code, meant) in LINES {
        let text = with(line, written);
        assert_eq!(first(&text, code), with(line, meant), "{written}");
    }
}

/// A lamp that has lost its minus becomes no sphere, and what is written is read again without errors.
#[test]
fn what_is_written_for_them_is_right() {
    for &(line, written, _, meant) in LINES {
        let text = fixed(&with(line, written));
        assert_eq!(codes(&text), [], "{written}: {text}");
        // Other findings may have fixes of their own.
        let mut lines = meant.lines().map(str::trim);
        let is_there = |line: &str| text.lines().any(|l| l.trim() == line);
        assert!(lines.any(is_there), "{written}: {text}");
    }
}

/// Words one above the other, before what could be their numbers.
#[test]
fn colours_and_materials_by_name_on_many_lines() {
    let written = "10 -701 červená\n11 -701 zelená\n12 -701 modrá\n13 -201 sklo\n2 11 0 0 0 1\n\
                   2 -299 10 13\n1 9999 2 0\n";
    let mut meant = written.to_owned();
    for (word, numbers) in [
        ("červená", "1 0 0"),
        ("zelená", "0 0.216 0"),
        ("modrá", "0 0 1"),
        ("sklo", "0 0.1 0.9"),
    ] {
        meant = meant.replace(word, numbers);
    }
    assert_eq!(codes(written), [Code::E003; 4]);
    assert_eq!(fixed(written), meant);
}

/// Of a record whose type is known a word in it is no comment.
#[test]
fn no_record_becomes_a_comment() {
    for line in [
        "2 -201 gls",
        "2 -299 10 červená",
        "2 -701 reddish",
        "2 -203 glas",
        "2 -1 up",
    ] {
        let text = format!("2 11 0 0 0 1\n10 -701 1 1 1\n{line}\n1 9999 2 0\n");
        for d in repair::proposals(&read(&text)) {
            let titles: Vec<&str> = d.fixes.iter().map(|f| f.title).collect();
            assert!(!titles.contains(&"fix-comment"), "{line}: {titles:?}");
            assert!(
                d.code != Code::E012 || d.case == "parameter",
                "{line}: {d:?}"
            );
        }
    }
}

/// The lost minus wins over another type, where what the record refers to is undefined, too.
#[test]
fn the_lost_minus_wins_over_undefined_ids() {
    for (written, meant) in [
        ("12 399 1 1 25 26", "12 -399 1 1 25 26"),
        ("4 299 25 26", "4 -299 25 26"),
        ("12 103 25 26", "12 -103 25 26"),
    ] {
        let line = |line: &str| with(3, &format!("4 12 -3 -1 -3 3 0 3\n{line}"));
        assert_eq!(first(&line(written), Code::E007), line(meant));
    }
}

/// Each colour has an ID of its own, though all are put right at once.
#[test]
fn colours_on_several_lines() {
    let checker = "12 -399 4 4 1 0 0 1 1 1\n13 -399 4 4 blue 2\n4 12 -3 -1 -3 3 0 3";
    let text = with(3, checker).replace("1 9999 8 2", "1 9999 8 0.2 0.3 0.4");
    let meant = "14 -701 1 0 0\n15 -701 1 1 1\n12 -399 4 4 14 15\n16 -701 0 0 1\n13 -399 4 4 16 2\n\
                 4 12 -3 -1 -3 3 0 3";
    let meant = with(3, meant).replace("1 9999 8 2", "17 -701 0.2 0.3 0.4\n1 9999 8 17");
    assert_eq!(fixed(&text), meant);
}

/// Numbers that a record could not have, and colours beyond 1, are no colour.
#[test]
fn what_is_no_colour_is_none() {
    for written in ["1 9999 8 2 3 4", "1 9999 8 0.5 0.5", "1 9999 8 reddish"] {
        let all = repair::proposals(&read(&with(17, written)));
        let titles = all.iter().flat_map(|d| &d.fixes).map(|f| f.title);
        assert!(titles.into_iter().all(|t| t != "fix-inline"), "{written}");
    }
    assert_ne!(codes(&with(1, "2 -701 reddish")), [Code::E003]);
}

#[test]
fn what_changes_nothing_that_is_there_was_not_meant_as_a_shape() {
    for written in ["34 -2 2 30", "34 -2 30 2", "34 -3 1 2 3", "34 -1 4 6 5"] {
        let text = with(6, written);
        for d in repair::proposals(&read(&text)) {
            for fix in &d.fixes {
                let (fixed, _) = fixes::apply(&text, [fix].into_iter());
                let line = fixed.lines().nth(5).unwrap_or_default();
                let code = line.split(' ').nth(1).and_then(|code| code.parse().ok());
                assert!(code.is_none_or(|code: i32| code < 0), "{written} → {line}");
            }
        }
    }
}

/// An undefined ID is said, whatever else is wrong: a record whose ID is another's defines no other, nor do words.
#[test]
fn undefined_ids_are_not_hidden() {
    for other in [
        "5 -701 1 0",
        "5 9",
        "5 -1 0.5 x 0",
        "5 -203 a b c",
        "this is the house",
    ] {
        let text = with(6, other).replace("8 -101 4 7", "8 -101 4 77");
        assert!(
            codes(&text).contains(&Code::E101),
            "{other}: {:?}",
            codes(&text)
        );
    }
    // A record that has lost its ID still may be the one.
    let text = with(3, "12 -3 -1 -3 3 0 3");
    assert!(!codes(&text).contains(&Code::E101));
}

/// No operation has the same thing twice because another ID is missing.
#[test]
fn no_operation_gets_one_thing_twice() {
    for written in ["8 -101 4 77", "8 -103 77 4"] {
        let text = with(11, written);
        for d in repair::proposals(&read(&text)) {
            for fix in &d.fixes {
                let (fixed, _) = fixes::apply(&text, [fix].into_iter());
                assert!(!fixed.contains(" 4 4\n"), "{fixed}");
            }
        }
    }
}

#[test]
fn the_only_object_that_nothing_is_made_of_is_drawn() {
    let (without, _) = SCENE.rsplit_once("1 9999").unwrap();
    assert_eq!(
        fixed(without),
        without.trim_end().to_owned() + "\n1 9999 8 0\n"
    );
    // The root that is written is none.
    assert_eq!(
        first(&with(17, "1 9999 44 0"), Code::E101),
        with(17, "1 9999 8 0")
    );
    // Of two, nobody knows which.
    let two = without.replace("8 -101 4 7\n", "");
    assert_eq!(fixed(&two), two);
}

#[test]
fn folders_of_pictures_are_separated_as_in_every_scene() {
    let line = |name: &str| format!("4 12 -3 -1 -3 3 0 3\n12 -301 {name}");
    for (written, meant) in [
        ("wood\\oak.jpg", Some("wood/oak.jpg")),
        ("\"my wood\\oak.jpg\"", Some("\"my wood/oak.jpg\"")),
        ("..\\oak.jpg", None),
        ("C:\\oak.jpg", None),
    ] {
        let text = with(3, &line(written));
        let all = repair::proposals(&read(&text));
        let finding = all.iter().find(|d| d.code == Code::E209).expect(written);
        let (fixed, _) = fixes::apply(&text, finding.fixes.first().into_iter());
        assert_eq!(fixed, with(3, &line(meant.unwrap_or(written))));
    }
}

#[test]
fn a_picture_beside_the_scene() {
    let dir = tempfile::tempdir().unwrap();
    fs::create_dir(dir.path().join("wood")).unwrap();
    for name in ["wood.png", "wood/oak.jpg", "the sky.png"] {
        fs::write(dir.path().join(name), b"\x89PNG\r\n\x1a\n").unwrap();
    }
    fs::write(dir.path().join("brick.png"), "no picture").unwrap();
    let path = dir.path().join("scene.zpg");
    for (written, meant) in [
        ("woood.png", Some("wood.png")),
        ("Wood.PNG", Some("wood.png")),
        ("wood.jpg", Some("wood.png")),
        ("wood/aok.jpg", Some("wood/oak.jpg")),
        ("the_sky.png", Some("\"the sky.png\"")),
        ("brik.png", None),
        ("marble.png", None),
    ] {
        let line = |name: &str| format!("4 12 -3 -1 -3 3 0 3\n12 -301 {name}");
        let text = with(3, &line(written));
        fs::write(&path, &text).unwrap();
        let name = path.to_string_lossy();
        let all = repair::proposals(&Analysis::new(name, text.clone().into_bytes()));
        let finding = all.iter().find(|d| d.code == Code::E210);
        let Some(finding) = finding else {
            // Names may differ in case alone on this system.
            assert!(dir.path().join(written).exists(), "{written}");
            continue;
        };
        let (fixed, _) = fixes::apply(&text, finding.fixes.first().into_iter());
        let meant = meant.map_or(text, |meant| with(3, &line(meant)));
        assert_eq!(fixed, meant, "{written}");
    }
}

/// Numbers up to 255 may also be plain shares.
#[test]
fn bytes_have_two_readings() {
    let scene = |colour: &str| format!("2 11 0 1 0 1\n2 -701 {colour}\n1 9999 2 0\n");
    let (finding, made) = guessed(&scene("50 100 230"), Code::W301);
    // The sRGB curve of the three bytes; 50 / 255 = 0.19608, 100 / 255 = 0.39216, 230 / 255 = 0.90196.
    let meant = ["0.032 0.127 0.79", "0.196 0.392 0.902"].map(scene);
    assert_eq!(made, meant);
    let kinds = finding.fixes.iter().map(|fix| fix.applicability);
    assert_eq!(
        Vec::from_iter(kinds),
        [Applicability::Unsafe, Applicability::Choice]
    );
}

/// Separators between the records of a line go with the line.
#[test]
fn records_that_separators_divide() {
    for separator in [";", ","] {
        let written =
            format!("2 11 -2.5 1 0 1{separator} 3 11 0 1 0 1{separator}\n4 -101 2 3\n1 9999 4 0\n");
        let (_, made) = guessed(&written, Code::S503);
        let meant = "2 11 -2.5 1 0 1\n3 11 0 1 0 1\n4 -101 2 3\n1 9999 4 0\n";
        assert_eq!(made, [meant]);
    }
}
