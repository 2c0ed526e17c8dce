//! Records that somebody forgot to write, and other slips of newcomers: what is said, and what is guessed.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language, Severity, fixes};

use super::{read, said};
use crate::support::program;

/// A ring and a cube on a table, without mistakes.
const TABLE: &str = "\
40 12 -4 -1 -4 4 0 4
40 -701 0.3 0.4 0.5
41 14 0.7 0.25
41 -701 0.6 0.35 0.1
41 -1 -1.5 0.25 -1
42 12 1 0 -1 2 1 0
50 -101 41 42
51 -101 50 40
60 -402 0.8
60 -1 -4 6 3
63 -501 0 4.4 6 0 -0.68 -1 0 1 0 34
1 9999 51 0
";

const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n";

const COURSE: [&str; 2] = [
    include_str!("../../docs/course/scenes/1-snowman.zpg"),
    include_str!("../../docs/course/scenes/2-cup.zpg"),
];

fn scene(lines: &str, drawn: u32) -> String {
    format!("{lines}\n{REST}1 9999 {drawn} 0\n")
}

/// A scene without the line that begins so.
fn without(text: &str, line: &str) -> String {
    let (gone, left): (Vec<&str>, Vec<&str>) = text.lines().partition(|l| l.starts_with(line));
    assert_eq!(gone.len(), 1, "{line}");
    left.join("\n") + "\n"
}

fn findings(text: &str) -> Vec<Diagnostic> {
    repair::proposals(&read(text))
}

/// The scene after all guesses, and how many these were.
fn fixed(text: &str) -> (String, usize) {
    let mended = fixing::to_fixed_point(read(text), true, Analysis::of);
    (mended.analysis.source.text.clone(), mended.count)
}

/// The only finding about a text.
fn only(text: &str) -> Diagnostic {
    let mut all = findings(text);
    let told: Vec<String> = all.iter().flat_map(said).collect();
    assert_eq!(all.len(), 1, "{told:#?}\n{text}");
    all.remove(0)
}

#[test]
fn the_table_has_no_mistakes() {
    assert_eq!(findings(TABLE), []);
}

/// Nobody guesses another ID for what has lost its definition.
#[test]
fn forgotten_lamps_and_shapes() {
    let [snowman, cup] = COURSE;
    let template = include_str!("../../src/commands/new/scene.zpg");
    for (text, line, case) in [
        (TABLE, "60 -402", "missing-lamp"),
        (TABLE, "41 14", "missing-shape"),
        (snowman, "50 -402", "missing-lamp"),
        (cup, "60 -402", "missing"),
        (template, "11 -402", "missing-lamp"),
        (snowman, "22 11", "missing-shape"),
        (cup, "20 1 2", "missing-shape"),
        (template, "3 14", "missing-shape"),
    ] {
        let text = without(text, line);
        let finding = only(&text);
        assert_eq!((finding.code, finding.case), (Code::E101, case), "{line}");
        assert_eq!(finding.fixes, [], "{line}");
        assert_eq!(fixed(&text), (text.clone(), 0), "{line}");
    }
    let words = only(&without(TABLE, "60 -402")).wording(Language::English);
    assert!(words.message.contains("`60 -402`"), "{}", words.message);
}

/// A slip of one digit is none of these.
#[test]
fn slips_of_ids_are_guessed() {
    for (line, slip) in [
        ("41 -1 -1.5", "43 -1 -1.5"),
        ("50 -101 41 42", "50 -101 41 43"),
        ("60 -1 -4", "61 -1 -4"),
        ("51 -101 50 40", "51 -101 52 40"),
    ] {
        assert_eq!(fixed(&TABLE.replace(line, slip)).0, TABLE, "{slip}");
    }
}

/// Two objects that nothing uses are those of the union that is missing.
#[test]
fn forgotten_unions() {
    let [snowman, _] = COURSE;
    for (text, line) in [(snowman, "40 -101"), (TABLE, "50 -101"), (TABLE, "51 -101")] {
        let left = without(text, line);
        let finding = only(&left);
        assert_eq!(finding.case, "missing-union", "{line}");
        let values = |text: &str| super::values(text);
        let (made, count) = fixed(&left);
        assert_eq!(count, 1);
        let is_union = |l: &&str| l.starts_with(line);
        let union = made.lines().find(is_union).expect("the union");
        assert_eq!(values(union).len(), 4);
        assert_eq!(findings(&made), []);
    }
    // Of three objects nobody can tell.
    let text = without(&without(TABLE, "50 -101"), "51 -101");
    assert_eq!(fixed(&text).1, 0);
}

/// A comment with a `#` in it: one guess, which is taken.
#[test]
fn signs_within_comments() {
    for (line, meant) in [
        ("2 11 0 1 0 1 # a # ball #", "2 11 0 1 0 1 # a ball #"),
        (
            "2 11 0 1 0 1 # above # the desk #",
            "2 11 0 1 0 1 # above the desk #",
        ),
        (
            "0 # the mug # with a handle #\n2 11 0 1 0 1",
            "0 # the mug with a handle #\n2 11 0 1 0 1",
        ),
    ] {
        let text = scene(line, 2);
        assert_eq!(only(&text).fixes.len(), 1);
        assert_eq!(fixed(&text), (scene(meant, 2), 1));
    }
    let many = only(&scene("2 11 0 1 0 1 # ball #1", 2));
    assert_eq!(
        (many.code, &many.notes[..]),
        (Code::E009, &["comment-ends"][..])
    );
}

/// An operation of an object and itself.
#[test]
fn the_same_operand_twice() {
    for code in [-101, -102] {
        let d = only(&scene(&format!("2 11 0 1 0 1\n4 {code} 2 2"), 4));
        assert_eq!((d.code, d.case, d.fixes.len()), (Code::W333, "same", 0));
    }
    let lines = "41 11 0 1 0 1\n42 12 1 0 0 2 1 1\n51 -101 41 41";
    let meant = lines.replace("41 41", "41 42");
    assert_eq!(fixed(&scene(lines, 51)), (scene(&meant, 51), 1));
}

/// What only a guess brings to light is not guessed at: as many guesses are taken as were announced.
#[test]
fn as_many_guesses_as_announced() {
    let lines = "20 11 0 0 0 1\n20 -3 2\n21 11 0.5 0 0 1.5\n21 -203 1.5 1.5 1.5\n20 -203 1.4 1.4 1.4\n\
                 20 -201 0 0 1\n21 -201 0 0 1\n22 -101 20 21";
    let text = scene(lines, 22);
    let announced = findings(&text);
    let applied = announced.iter().filter_map(|d| d.applicable_fix(true));
    assert_eq!(fixed(&text).1, applied.count());
    let left = fixed(&text).0;
    assert_eq!(left.lines().count(), text.lines().count(), "{left}");
}

/// A lost end of a line between two records of one ID.
#[test]
fn lost_ends_of_lines() {
    let lines = "41 14 0.7 0.2541 -701 0.6 0.35 0.1\n41 -1 0 0.5 0";
    let meant = lines.replace("0.2541", "0.25\n41");
    assert_eq!(fixed(&scene(lines, 41)), (scene(&meant, 41), 1));
}

/// Shapes as OpenSCAD has them: a cone of two radii, a box of three edges.
#[test]
fn shapes_by_their_sizes() {
    for (line, meant) in [
        ("42 16 1.5 0.6 0", "42 16 1.5 0.6"),
        ("42 16 1.5 0.6 0.3", "42 1 2 0.6 0 0.3 1.5"),
    ] {
        assert_eq!(fixed(&scene(line, 42)), (scene(meant, 42), 1));
    }
    let text = scene("20 12 8 0.3 8", 20);
    let shown = only(&text)
        .fixes
        .into_iter()
        .map(|f| f.edits[0].text.clone());
    let shown: Vec<String> = shown.collect();
    assert_eq!(shown, ["12 -4 -0.15 -4 4 0.15 4", "12 0 0 0 8 0.3 8"]);
    assert_eq!(fixed(&text).1, 0);
    assert_eq!(only(&text).severity, Severity::Error);
}

/// A picture with another name is none that was meant.
#[test]
fn pictures_that_are_not_there() {
    let picture = include_bytes!("../../scenes/hard/pictures/sheet.png");
    for (there, is_near) in [("good.png", false), ("mon.png", true), ("moon.jpg", true)] {
        let text = scene("2 12 0 0 0 1 1 1\n2 -301 moon.png", 2);
        let dir = program::folder(&[("a.zpg", &text)]);
        std::fs::write(dir.path().join(there), picture).expect("a picture");
        let run = program::zpg(dir.path(), &["check", "a.zpg"]);
        let said = program::text(&run.stdout);
        assert!(said.contains("E210"), "{said}");
        assert_eq!(said.contains(there), is_near, "{said}");
    }
}

/// The plane of POV-Ray, whose last number has the other sign, is no plane with the numbers as they stand.
#[test]
fn planes_of_povray() {
    let meant = "3 4 0 1 0 1\n2 11 0 0 0 1";
    for plane in [
        "plane { <0,1,0>, -1 }",
        "plane { <0, 1, 0>, -1 }",
        "plane { y, -1 }",
    ] {
        let text = scene(&format!("3 {plane}\n2 11 0 0 0 1"), 2);
        assert_eq!(only(&text).fixes.len(), 1, "{plane}");
        assert_eq!(fixed(&text).0, scene(meant, 2), "{plane}");
    }
    for (plane, record) in [
        ("3 plane { <0,1,0>, -1 }", "3 4 0 1 0 1"),
        ("3 plane <0,1,0>, -1", "3 4 0 1 0 1"),
        ("3 plane { <0,1,0>, -1 } # floor #", "3 4 0 1 0 1 # floor #"),
    ] {
        let lines = |line: &str| scene(&format!("2 11 0 1 0 1\n{line}\n20 -103 2 3"), 20);
        assert_eq!(fixed(&lines(plane)).0, lines(record), "{plane}");
    }
    // Without brackets either sign may be meant.
    let text = scene("2 11 0 0 0 3\n3 plane 0 1 0 -1\n20 -103 2 3", 20);
    assert_eq!(fixed(&text).0, text);
    let error = findings(&text).remove(0);
    let made = error
        .fixes
        .iter()
        .map(|fix| fixes::apply(&text, std::iter::once(fix)).0);
    let lines: Vec<String> = made
        .map(|text| text.lines().nth(1).unwrap().into())
        .collect();
    for record in ["3 4 0 1 0 -1", "3 4 0 1 0 1"] {
        assert!(lines.iter().any(|line| line == record), "{lines:?}");
    }
    for (language, why) in [
        (Language::English, "whose d has the other sign"),
        (Language::Czech, "jejíž d má opačné znaménko"),
    ] {
        let told: Vec<String> = error.wording(language).fixes;
        assert!(told.iter().any(|t| t.contains(why)), "{told:?}");
    }
}

/// A lamp of POV-Ray is as bright as its grey, with an ID and without.
#[test]
fn lamps_of_povray() {
    for (look, intensity, colour) in [
        ("color rgb 1", "1", ""),
        ("rgb 0.8", "0.8", ""),
        ("color rgb<1,1,1>*0.8", "0.8", ""),
        (", rgb <1,1,1>*0.8", "0.8", ""),
        (", 0.8", "0.8", ""),
        ("color rgb <1,0.5,0>*0.8", "0.8", "1 0.5 0"),
        ("color White", "1", "1 1 1"),
    ] {
        let drawn = "2 11 0 1 0 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 2 0\n";
        for (written, id) in [("", 10), ("70 ", 70)] {
            let line = format!("{written}light_source {{ <4, 6, 5> {look} }}\n");
            let mut records = format!("{id} -402 {intensity}\n{id} -1 4 6 5\n");
            if !colour.is_empty() {
                records += &format!("{id} -701 {colour}\n");
            }
            let text = line + drawn;
            let errors: Vec<Diagnostic> = findings(&text)
                .into_iter()
                .filter(Diagnostic::is_error)
                .collect();
            assert_eq!(errors.len(), 1, "{text}");
            assert_eq!(errors[0].fixes.len(), 1, "{text}");
            assert_eq!(fixed(&text), (records + drawn, 1), "{text}");
        }
    }
}

/// A property by its ID, behind the type of the property in place of an assignment.
#[test]
fn properties_by_their_ids() {
    let others = "31 -201 0.5 0.5 0\n14 -701 1 0 0\n32 -399 2 2 14 14\n12 11 0 1 0 1\n2 11 3 1 0 1\n\
                  20 -101 12 2\n12 -299 0 31\n2 -299 32 0";
    for (line, meant) in [
        ("12 -203 31", "12 -299 0 31"),
        ("12 -201 31", "12 -299 0 31"),
        ("12 -202 31", "12 -299 0 31"),
        ("2 -399 32", "2 -299 32 0"),
        ("2 -302 32", "2 -299 32 0"),
        ("2 -301 32", "2 -299 32 0"),
    ] {
        let text = scene(&others.replace(meant, line), 20);
        assert_eq!(only(&text).fixes.len(), 1, "{line}");
        assert_eq!(fixed(&text), (scene(others, 20), 1), "{line}");
    }
}

/// A word before the letter of an axis.
#[test]
fn axes_with_a_word() {
    for axis in ["x", "osa x", "axis x", "osy x"] {
        let text = scene(&format!("8 11 0 1 0 1\n8 -2 90 {axis}"), 8);
        only(&text);
        assert_eq!(
            fixed(&text),
            (scene("8 11 0 1 0 1\n8 -2 90 1", 8), 1),
            "{axis}"
        );
    }
}

/// A plane across an axis as its equation.
#[test]
fn equations_of_planes() {
    for (line, meant) in [
        ("2 4 y = 0", "2 4 0 1 0 0"),
        ("2 4 y=0", "2 4 0 1 0 0"),
        ("2 3 y = 1", "2 3 0 1 0 -1"),
        ("2 3 z = -1.5", "2 3 0 0 1 1.5"),
    ] {
        let text = scene(line, 2);
        only(&text);
        assert_eq!(fixed(&text), (scene(meant, 2), 1), "{line}");
    }
}

/// Decimal commas in square brackets: one error.
#[test]
fn commas_in_square_brackets() {
    let text = scene("11 11 [0,9; 2; -0,3] 0,5", 11);
    let all = repair::proposals(&read(&text));
    assert_eq!(all.iter().filter(|d| d.is_error()).count(), 1);
    assert_eq!(fixed(&text), (scene("11 11 0.9 2 -0.3 0.5", 11), 2));
}

/// The first number of a shape is no type where the ID has no other shape.
#[test]
fn types_that_are_missing_before_what_could_be_one() {
    let with = |line: &str| scene(&format!("2 11 0 0 0 1\n{line}\n4 -101 2 3"), 4);
    for (line, meant) in [
        ("3 -2 0.9 1 0.9", "3 11 -2 0.9 1 0.9"),
        ("3 -1 0.5 0 2 1 1", "3 12 -1 0.5 0 2 1 1"),
        ("3 2 0.5 0 0.5 1.6", "3 1 2 0.5 0 0.5 1.6"),
    ] {
        let finding = only(&with(line));
        assert_eq!(finding.code, Code::E006, "{line}");
        assert_eq!(fixed(&with(line)).0, with(meant), "{line}");
    }
    let moved = with("3 11 0 2 0 1\n3 -2 0.9 1 0.9");
    assert_eq!(only(&moved).code, Code::E009);
}

/// A ball of ID 7 and one that has lost its ID; `colour` is that of the second.
fn two_balls(record: &str, colour: u32, uses: &str) -> String {
    format!(
        "7 11 2 0 0 1\n{colour} -701 0.3 0.4 0.5\n{record}\n{uses}\n20 -101 7 8\n{REST}1 9999 20 0\n"
    )
}

/// Without its ID a ball at the left is a change of what has the number of its type for its ID.
#[test]
fn balls_whose_ids_are_lost_before_a_type_that_is_an_id() {
    for colour in [11, 13] {
        for x in [-1, -2, -3, -4] {
            for uses in [format!("8 -299 {colour} 0"), String::new()] {
                let record = format!("11 {x} 0.7 1 0.7");
                let text = two_balls(&record, colour, &uses);
                let finding = only(&text);
                assert_eq!((finding.code, finding.case), (Code::E005, "lost"), "{text}");
                let titles: Vec<&str> = finding.fixes.iter().map(|f| f.title).collect();
                assert_eq!(titles, ["put-lost-id-in-front"], "{text}");
                let meant = two_balls(&format!("8 {record}"), colour, &uses);
                assert_eq!(fixed(&text), (meant, 1));
            }
        }
    }
}

/// What cannot change a colour comes too late for nothing.
#[test]
fn what_changes_nothing_is_not_late() {
    let text = scene(
        "7 11 2 0 0 1\n11 -701 0.3 0.4 0.5\n7 -299 11 0\n11 -1 0.7 1 0.7",
        7,
    );
    assert_eq!(only(&text).code, Code::E103);
    assert!(read(&text).findings().iter().all(|d| d.code != Code::W309));
}

/// The property that has an index only, rather than the one above that has all.
#[test]
fn the_other_half_of_a_material() {
    for (above, below) in [
        ("20 -201 0.2 0.2 0.6", "21 -203 1.5 1.5 1.5"),
        (
            "20 -201 0.2 0.2 0.6\n20 -203 1.2 1.2 1.2",
            "21 -203 1.5 1.5 1.5",
        ),
    ] {
        let with = |record: &str| {
            let balls = "7 11 2 0 0 1\n8 11 -2 0 0 1";
            let uses = "7 -299 0 20\n8 -299 0 21\n30 -101 7 8";
            scene(&format!("{balls}\n{above}\n{record}\n{below}\n{uses}"), 30)
        };
        let text = with("-201 0.1 0.1 0.8");
        assert_eq!(only(&text).fixes.len(), 1);
        assert_eq!(fixed(&text), (with("21 -201 0.1 0.1 0.8"), 1));
    }
}

/// Unused glass goes to the object that has an index and no optics, and nothing else is said of it.
#[test]
fn glass_that_is_not_assigned_has_one_cure() {
    for said in [" # skleněná koule #", " # glass ball #", ""] {
        let text = |assigned: &str| {
            let glass = format!("35 -201 0.1 0 0.85\n3 11 0 1 0 1{said}\n{assigned}");
            scene(&(glass + "3 -203 1.5 1.5 1.5"), 3)
        };
        let written = text("");
        let found = findings(&written);
        let codes: Vec<Code> = found.iter().map(|d| d.code).collect();
        match said {
            "" => assert_eq!(codes, [Code::W310]),
            _ => assert_eq!(codes, [Code::W310, Code::W342]),
        }
        for d in &found {
            let first = fixes::apply(&written, [&d.fixes[0]].into_iter()).0;
            assert_eq!(first, text("3 -299 0 35\n"), "{d:?}");
        }
        assert_eq!(fixed(&written), (text("3 -299 0 35\n"), 1));
    }
    // What is there is not proposed once more.
    let ball = scene("3 11 0 1 0 1 # glass ball #\n3 -203 1.5 1.5 1.5", 3);
    let finding = only(&ball);
    assert_eq!(finding.code, Code::W342);
    let made = fixes::apply(&ball, finding.fixes.iter()).0;
    assert!(made.contains("3 -201 0.05 0.1 0.85\n3 -203"), "{made}");
    // Optics that let no light through do not go with an index.
    let dull = "35 -201 0.6 0.4 0\n2 11 3 1 0 1\n3 11 0 1 0 1\n3 -203 1.5 1.5 1.5\n4 -101 2 3";
    let (text, _) = fixed(&scene(dull, 4));
    assert!(!text.contains("3 -299"), "{text}");
}

/// An operand that the other one holds already gives way to the only unused object.
#[test]
fn an_operand_that_is_named_in_the_other_one() {
    let text = |operands: &str| {
        let shapes = "2 11 -3 1 0 1\n3 11 0 1 0 1\n5 11 3 1 0 1\n6 -101 2 3\n";
        scene(&format!("{shapes}7 -101 {operands}"), 7)
    };
    for (written, meant) in [("6 3", "6 5"), ("3 6", "5 6"), ("6 6", "6 5")] {
        assert_eq!(fixed(&text(written)).0, text(meant), "{written}");
    }
}
