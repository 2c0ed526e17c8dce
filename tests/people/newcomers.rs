//! What somebody writes who knows POV-Ray, or has lost a number or the order of two: all guesses together make the
//! scene that was meant.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language, fixes};
use zpg::internals::format::{Options, format};

use super::{fixed, read};

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

/// The first error of a text, with what is proposed.
fn first_error(text: &str) -> Diagnostic {
    let all = repair::proposals(&read(text));
    all.into_iter().find(Diagnostic::is_error).unwrap()
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
    ("2 16 0 1 0 2 0.5\n", "2 16 2 0.5\n2 -1 0 1 0\n"),
    // At the origin there is nothing to be moved.
    ("2 16 0 0 0 2 0.5\n", "2 16 2 0.5\n"),
    ("2 16 2 0.5 0 0 0\n", "2 16 2 0.5\n"),
    ("2 14 <0,0,0>, 0.5, 0.15\n", "2 14 0.5 0.15\n"),
    // ID and type swapped.
    ("12 2 -1 -1 -1 1 1 1\n", "2 12 -1 -1 -1 1 1 1\n"),
    ("14 2 1 0.3\n", "2 14 1 0.3\n"),
    (
        "2 14 0.5 0.15 1.3 1.5 -3\n",
        "2 14 0.5 0.15\n2 -1 1.3 1.5 -3\n",
    ),
];

/// The same behind a ball, which is drawn.
const BEHIND: &[(&str, &str)] = &[
    // A colour that is used, with ID and type swapped.
    (
        "-701 14 0.1 0.1 0.2\n2 -299 14 0\n",
        "14 -701 0.1 0.1 0.2\n2 -299 14 0\n",
    ),
    // A space in the type, or a typing error.
    ("2 -7 01 0.9 0.1 0.1\n", "2 -701 0.9 0.1 0.1\n"),
    ("3 -702 1 0 0\n2 -299 3 0\n", "3 -701 1 0 0\n2 -299 3 0\n"),
    // The name of a type behind its number, or in its place.
    ("2 -701 rgb 1 0 0\n", "2 -701 1 0 0\n"),
    ("2 -701 rgb <1,0,0>\n", "2 -701 1 0 0\n"),
    ("2 -701 color red\n", "2 -701 1 0 0\n"),
    ("2 color red\n", "2 -701 1 0 0\n"),
    ("2 barva červená\n", "2 -701 1 0 0\n"),
    // Colours of two words: CSS's darkblue is 0 0 139, and navy 0 0 128, in sRGB.
    ("2 -701 dark blue\n", "2 -701 0 0 0.26\n"),
    ("2 colour dark blue\n", "2 -701 0 0 0.26\n"),
    ("2 barva tmavě modrá\n", "2 -701 0 0 0.216\n"),
    (
        "2 -399 4 4 dark blue white\n",
        "51 -701 0 0 0.26\n52 -701 1 1 1\n2 -399 4 4 51 52\n",
    ),
    // A colour that has a record, by its comment or its numbers; the other one gets one.
    (
        "7 -701 0.9 0.1 0.1 # red #\n8 -701 1 1 1\n2 -399 1 1 red white\n",
        "7 -701 0.9 0.1 0.1 # red #\n8 -701 1 1 1\n2 -399 1 1 7 8\n",
    ),
    (
        "7 -701 1 0 0\n2 -399 1 1 červená bílá\n",
        "7 -701 1 0 0\n51 -701 1 1 1\n2 -399 1 1 7 51\n",
    ),
    // Changes that have lost their IDs in the middle of an object's records.
    (
        "-1 1 0 0\n2 -701 1 0 0\n-2 30 2\n-201 0.5 0.5 0\n",
        "2 -1 1 0 0\n2 -701 1 0 0\n2 -2 30 2\n2 -201 0.5 0.5 0\n",
    ),
    // Comments of C on several lines, with numbers in quotes, or of numbers alone.
    (
        "// equation \"= -3\"\n// two lines\n2 -701 1 0 0 // red\n",
        "0 # equation \"= -3\" #\n0 # two lines #\n2 -701 1 0 0 # red #\n",
    ),
    (
        "/* first */\n//\n//second: 1 2\n2 -701 1 0 0\n",
        "0 # first #\n\n0 # second: 1 2 #\n2 -701 1 0 0\n",
    ),
    ("// 2 * 3 = 6\n", "0 # 2 * 3 = 6 #\n"),
    // Records that are switched off; what stands in zpg's own signs there, too.
    (
        "/* off:\n2 -701 1 0 0\n*/\n",
        "0 # off: #\n0 # ~ 2 -701 1 0 0 #\n",
    ),
    (
        "2 -701 1 0 0 /* red,\n  or green:\n 2 -701 0 1 0 # green #\n*/ 2 -2 30 2\n",
        "2 -701 1 0 0 # red, #\n0 # or green: #\n0 # ~ 2 -701 0 1 0 ~~ green ~~ #\n 2 -2 30 2\n",
    ),
    // Bytes, hexadecimal digits and CSS are one colour of sRGB.
    ("2 -701 26 77 179\n", "2 -701 0.0103 0.074 0.45\n"),
    ("2 -701 #1a4db3\n", "2 -701 0.0103 0.074 0.45\n"),
    ("2 -701 rgb(26, 77, 179)\n", "2 -701 0.0103 0.074 0.45\n"),
    ("2 -701 255 165 0\n", "2 -701 1 0.376 0\n"),
    ("2 -701 orange\n", "2 -701 1 0.376 0\n"),
    // A place in square brackets before the numbers of the record.
    ("51 -402 [4,6,5] 1\n", "51 -402 1\n51 -1 4 6 5\n"),
    ("51 -402 [4, 6, 5] 0.5\n", "51 -402 0.5\n51 -1 4 6 5\n"),
    // Only the other place of an assignment has something that nothing needs.
    (
        "6 -201 0.8 0.2 0\n2 -299 3 0\n",
        "6 -201 0.8 0.2 0\n2 -299 0 6\n",
    ),
    ("2 pigment 1 0 0\n", "2 -701 1 0 0\n"),
    // The colours of a checkerboard before the numbers of its fields.
    (
        "12 -701 1 0 0\n13 -701 0 1 0\n2 -399 12 13 2 2\n",
        "12 -701 1 0 0\n13 -701 0 1 0\n2 -399 2 2 12 13\n",
    ),
    // The only thing that nothing names has another ID by a typing error.
    (
        "21 -701 1 0 0\n3 -399 1 1 12 12\n2 -299 3 0\n",
        "12 -701 1 0 0\n3 -399 1 1 12 12\n2 -299 3 0\n",
    ),
    // Decimal points that are lost, per cent, parts by kind, digits of a Czech keyboard.
    ("2 -701 09 06 01\n", "2 -701 0.9 0.6 0.1\n"),
    ("2 -701 .1 .3 7\n", "2 -701 .1 .3 0.7\n"),
    ("2 -701 90 60 10\n", "2 -701 0.9 0.6 0.1\n"),
    ("2 -201 0.05 01 0.85\n", "2 -201 0.05 0.1 0.85\n"),
    ("2 -201 0.2 08 0\n", "2 -201 0.2 0.8 0\n"),
    ("2 -201 0.05 0.1 85\n", "2 -201 0.05 0.1 0.85\n"),
    ("2 -201 5 0.1 0.85\n", "2 -201 0.05 0.1 0.85\n"),
    // The sum would be 1.15, or 0.6.
    ("2 -201 0.2 0.1 85\n", "2 -201 0.2 0.1 85\n"),
    ("2 -201 0.05 0.1 45\n", "2 -201 0.05 0.1 45\n"),
    (
        "2 -202 0.2 0.3 0.1 0.8 0.7 0.9 0 0 0\n",
        "2 -202 0.2 0.8 0 0.3 0.7 0 0.1 0.9 0\n",
    ),
    ("2 -701 é + +\n", "2 -701 0 1 1\n"),
    // A digit of the type.
    ("2 -71 0.9 0.6 0.1\n", "2 -701 0.9 0.6 0.1\n"),
    // A comma that begins a number.
    ("2 -701 0,2 ,4 1\n", "2 -701 0.2 .4 1\n"),
    // A grey, and a second record on the line.
    ("2 -701 rgb 0.8\n", "2 -701 0.8 0.8 0.8\n"),
    (
        "51 -402 0.5 51 -1 4 6 5 51 -701 yellow\n",
        "51 -402 0.5\n51 -1 4 6 5\n51 -701 1 1 0\n",
    ),
    // A keyword before the ID.
    ("translate 2 -1.3 1.15 0\n", "2 -1 -1.3 1.15 0\n"),
    ("posun 2 -1.3 1.15 0\n", "2 -1 -1.3 1.15 0\n"),
    // Per cent.
    (
        "35 -201 80 20 0\n2 -299 0 35\n",
        "35 -201 0.8 0.2 0\n2 -299 0 35\n",
    ),
    (
        "35 -201 62.5 5 0\n2 -299 0 35\n",
        "35 -201 0.625 0.05 0\n2 -299 0 35\n",
    ),
];

/// Lines of the rest: what is there, what is written, and what was meant.
const INSTEAD: &[(&str, &str, &str)] = &[
    ("1 9999 2 0", "render 2 0", "1 9999 2 0"),
    ("1 9999 2 0", "render 2", "1 9999 2 0"),
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 camera <0,3,8> <0,1,0> 45",
        "9 -501 0 3 8 0 -2 -8 0 1 0 45",
    ),
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6 0 0 -1 0 1 0",
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
    ),
    // Words between the numbers; the direction is the point minus the position.
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6 look_at 0 0 0 0 1 0 45",
        "9 -501 0 0 6 0 0 -6 0 1 0 45",
    ),
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 location 0 0 6 direction 0 0 -1 sky 0 1 0 angle 45",
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
    ),
    // The angle before the up vector, or before all.
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6 0 0 -1 45 0 1 0",
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
    ),
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 45 0 0 6 0 0 -1 0 1 0",
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
    ),
    // A number of the up vector is lost, or all of it where the direction looks like one.
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6 0 0 -1 0 1 45",
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
    ),
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6 0.1 0 -1 45",
        "9 -501 0 0 6 0.1 0 -1 0 1 0 45",
    ),
    // What is moved is a lamp.
    ("50 -402 1\n", "50 -401 1\n", "50 -402 1\n"),
    // A line of the camera is left out.
    (
        "9 -501 0 0 6 0 0 -1 0 1 0 45",
        "9 -501 0 0 6\n  0 0 -1\n  45",
        "9 -501 0 0 6\n  0 0 -1 0 1 0\n  45",
    ),
    // ID and type swapped, the minus in its place.
    ("50 -402 1\n", "402 -50 1\n", "50 -402 1\n"),
    (
        "50 -402 1\n50 -1 3 5 5",
        "50 light <5,8,6> 0.8",
        "50 -402 0.8\n50 -1 5 8 6",
    ),
    (
        "50 -402 1\n50 -1 3 5 5",
        "50 light_source { <5,8,6> rgb 0.8 }",
        "50 -402 0.8\n50 -1 5 8 6",
    ),
    (
        "50 -402 1\n50 -1 3 5 5",
        "50 light_source <5,8,6> 0.8",
        "50 -402 0.8\n50 -1 5 8 6",
    ),
];

/// What is drawn is joined with an object on a line of its own, the second of a scene.
const JOINED: &[(&str, &str)] = &[
    ("sphere 4 0 1.6 0 0.6", "4 11 0 1.6 0 0.6"),
    ("koule 4 0 1.6 0 0.6", "4 11 0 1.6 0 0.6"),
    ("sphere { <0,1.6,0>, 0.6 }", "4 11  0 1.6 0  0.6"),
    ("14 4 1 0.3", "4 14 1 0.3"),
    // A shape with its properties and moves, as POV-Ray has them.
    (
        "box { <0,0,0>, <1,1,1> pigment { color rgb <1,0,0> } }",
        "4 12 0 0 0 1 1 1\n4 -701 1 0 0",
    ),
    (
        "4 sphere { <0,1,0>, 1 texture { pigment { color Red } } }",
        "4 11 0 1 0 1\n4 -701 1 0 0",
    ),
    (
        "torus { 1, 0.2 pigment { Yellow } rotate <90,0,45> scale 2 translate <0,1.5,0> } # ring #",
        "4 14 1 0.2\n4 -701 1 1 0\n4 -2 90 1\n4 -2 45 3\n4 -3 2 2 2\n4 -1 0 1.5 0 # ring #",
    ),
    // Names before the numbers.
    ("4 11 x=0 y=1.6 z=0 r=0.6", "4 11 0 1.6 0 0.6"),
    ("4 11 0 1.6 0 r = 0.6", "4 11 0 1.6 0 0.6"),
    ("4 11 r=0.6 x: 0 y: 1.6 z: 0", "4 11 0 1.6 0 0.6"),
    // Two readings of one number, of which the first is not always meant.
    ("4 11 0.41.5 0 0.6", "4 11 0.41 .5 0 0.6"),
    // A profile without the number of its points; a length with a unit.
    ("4 1 0 0  1 0  1 2  0 2", "4 1 4 0 0  1 0  1 2  0 2"),
    ("4 1 1.2 0  1.2 2.5", "4 1 2 1.2 0  1.2 2.5"),
    ("4 14 0.7 0.15m", "4 14 0.7 0.15"),
    // A digit of the type is lost, doubled, or exchanged with another; the space before it is lost.
    ("4 41 1 0.3", "4 14 1 0.3"),
    ("4 114 1 0.3", "4 14 1 0.3"),
    ("411 0 1.6 0 0.6", "4 11 0 1.6 0 0.6"),
    (
        "4 11 0 1.6 0 0.6\n-101 6 2 4",
        "4 11 0 1.6 0 0.6\n6 -101 2 4",
    ),
    // A rectangle by two corners in space: the two other axes are those of the rectangle, turned and moved.
    ("4 5 -5 0 -4 5 0 6", "4 5 -5 -4 5 6\n4 -2 90 1"),
    (
        "4 5 5 -1 6 -5 -1 -4",
        "4 5 -5 -4 5 6\n4 -2 90 1\n4 -1 0 -1 0",
    ),
    ("4 5 -5 0 -3 5 4 -3", "4 5 -5 0 5 4\n4 -1 0 0 -3"),
    (
        "4 5 -2 0 -4 -2 3 1",
        "4 5 -4 0 1 3\n4 -2 -90 2\n4 -1 -2 0 0",
    ),
    // An assignment without its type.
    (
        "4 11 0 1.6 0 0.6\n41 -201 0.5 0.5 0\n4 41",
        "4 11 0 1.6 0 0.6\n41 -201 0.5 0.5 0\n4 -299 0 41",
    ),
    // The ID is a type, too.
    (
        "4 11 0 1.6 0 0.6\n4 -710 0.9 0.1 0.1",
        "4 11 0 1.6 0 0.6\n4 -701 0.9 0.1 0.1",
    ),
];

#[test]
fn lines_behind_what_is_drawn() {
    for (written, meant) in BEHIND {
        let ball = "2 9 1\n";
        assert_eq!(
            fixed(&format!("{ball}{written}{REST}")),
            format!("{ball}{meant}{REST}")
        );
    }
}

#[test]
fn lines_of_the_rest() {
    for (old, written, meant) in INSTEAD {
        let text = |new: &str| format!("2 9 1\n{}", REST.replace(old, new));
        assert_eq!(fixed(&text(written)), text(meant));
    }
}

fn joined(line: &str) -> String {
    let rest = REST.replace("9999 2", "9999 7");
    format!("2 9 1\n{line}\n7 -101 2 4\n{rest}")
}

#[test]
fn objects_with_a_damaged_beginning() {
    for (written, meant) in JOINED {
        assert_eq!(fixed(&joined(written)), joined(meant));
    }
    let merged = joined("4 11 0 1.6 0 0.6");
    assert_eq!(fixed(&merged.replace("7 -101", "7 merge")), merged);
}

/// What no record says of a surface becomes a comment, and the shape is none.
#[test]
fn a_shape_with_a_finish() {
    let line =
        "4 sphere { <0,1.6,0>, 0.6 pigment { Red } finish { ambient 0.2 } translate <1,0,0> }";
    let meant = joined("4 11 0 1.6 0 0.6\n4 -701 1 0 0\n4 -1 1 0 0 # finish { ambient 0.2 } #");
    assert_eq!(fixed(&joined(line)), meant);
}

/// Operations as equations of sets.
#[test]
fn equations_of_sets() {
    for (written, meant) in [
        ("7 = 2 - 4", "7 -103 2 4"),
        ("7 = 2 + 4", "7 -101 2 4"),
        ("7=2∪4", "7 -101 2 4"),
        ("7 := 4 ∩ 2", "7 -102 4 2"),
        ("7 = 4 \\ 2", "7 -103 4 2"),
        ("7 = 2-4 # all #", "7 -103 2 4 # all #"),
    ] {
        let text = |line: &str| {
            let rest = REST.replace("9999 2", "9999 7");
            format!("2 9 1\n4 11 0.4 0.5 0 0.9\n{line}\n{rest}")
        };
        assert_eq!(fixed(&text(written)), text(meant));
    }
}

/// A number with two points may be several pairs.
#[test]
fn all_pairs_of_a_number_are_proposed() {
    let text = |numbers: &str| format!("2 11 {numbers} 0 0.6\n{REST}");
    let all = repair::proposals(&read(&text("0.41.5")));
    let error = all.iter().find(|d| d.code == Code::E003).unwrap();
    let written = |fix| fixes::apply(&text("0.41.5"), std::iter::once(fix)).0;
    let mut proposed: Vec<String> = error.fixes.iter().map(written).collect();
    proposed.sort();
    let mut expected = ["0.41 .5", "0.4 1.5", "0.41 5"].map(text);
    expected.sort();
    assert_eq!(proposed, expected);
}

/// A sphere that has lost a number is no half-space that has lost its ID.
#[test]
fn an_id_that_is_a_type_and_a_number_that_is_lost() {
    let text = joined("4 11 0 1.6 0.6\n4 -701 1 0 0");
    let all = repair::proposals(&read(&text));
    let errors: Vec<Code> = (all.iter().filter(|d| d.is_error()))
        .map(|d| d.code)
        .collect();
    assert_eq!(errors, [Code::E008]);
    assert_eq!(fixed(&text), text);
    // Where another ID is used and defined nowhere, it may be the lost one.
    let lost = joined("11 0 1.6 0 0.6");
    let all = repair::proposals(&read(&lost));
    assert!(all.iter().any(|d| d.code == Code::E005), "{all:?}");
}

/// A minus that is lost in a box, or one too many, is proposed; a box may be meant as thin as nothing.
#[test]
fn the_minus_of_a_thin_box() {
    for (written, meant) in [
        ("2 12 -2 0 1 2 1 1", "2 12 -2 0 -1 2 1 1"),
        ("2 12 -2 0 -1 2 1 -1", "2 12 -2 0 -1 2 1 1"),
    ] {
        let text = |line: &str| format!("{line}\n{REST}");
        let all = repair::proposals(&read(&text(written)));
        let thin = all.iter().find(|d| d.code == Code::W305).unwrap();
        let (proposed, _) = fixes::apply(&text(written), thin.fixes.first().into_iter());
        assert_eq!(proposed, text(meant));
        assert_eq!(fixed(&text(written)), text(written));
    }
    let floor = read(&format!("2 12 -1 0 -1 1 0 1\n{REST}"));
    assert!(floor.findings().iter().all(|d| d.fixes.is_empty()));
}

/// Names of types and colours are no comment.
#[test]
fn no_keyword_is_a_comment() {
    for text in [
        joined("sphere 4 0 1.6 0 0.6"),
        joined("sphere { <0,1.6,0>, 0.6 }"),
    ] {
        let all = repair::proposals(&read(&text));
        let mut titles = all.iter().flat_map(|d| &d.fixes).map(|f| f.title);
        assert!(titles.all(|title| title != "fix-comment"), "{all:?}");
    }
}

/// ID and type may be swapped where the ID is defined as something else, but not in a row of ellipsoids of which one
/// lacks a number.
#[test]
fn swapped_where_something_else_has_the_id() {
    let scene = |line: &str| {
        format!(
            "{line}\n2 -701 1 0 0\n3 9 0.5\n4 -101 2 3\n{}",
            REST.replace("9999 2", "9999 4")
        )
    };
    assert_eq!(fixed(&scene("11 2 0 0 0 1")), scene("2 11 0 0 0 1"));
    let row = "11 10 1 2 0.5\n12 10 2 0.5 1\n13 10 0.5 1\n14 -101 11 12\n2 -101 14 13\n";
    assert_eq!(fixed(&format!("{row}{REST}")), format!("{row}{REST}"));
}

/// Where a definition is missing, no record is bent to name something else.
#[test]
fn a_lost_definition_is_not_replaced() {
    let rest = REST.replace("9999 2", "9999 5");
    // 4 is named twice, or is the one between 3 and 5.
    for tool in ["4 -1 1 0 0\n", ""] {
        let text = format!("2 9 1\n3 12 0 0 0 2 2 2\n{tool}5 -103 3 4\n{rest}");
        assert_eq!(fixed(&text), text);
        let all = repair::proposals(&read(&text));
        let undefined = all.iter().find(|d| d.code == Code::E101).unwrap();
        assert!(undefined.notes.contains(&"lost"), "{undefined:?}");
    }
    // A typing error names nothing of the kind.
    let text = |id: u32| format!("2 9 1\n3 12 0 0 0 2 2 2\n5 -103 2 {id}\n{rest}");
    assert_eq!(fixed(&text(33)), text(3));
}

/// What an operation makes of an object under the same ID has another one, which later lines name.
#[test]
fn an_operation_with_the_id_of_its_operand() {
    let text = |new: u32| {
        format!("2 9 1\n3 12 0 0 0 2 2 2\n{new} -103 3 2\n5 14 2 0.2\n6 -101 5 {new}\n{REST}")
            .replace("9999 2", "9999 6")
    };
    assert_eq!(fixed(&text(3)), text(51));
    // A digit of the type is lost; a geodesic sphere would leave the operands unused.
    let whole = text(4);
    assert_eq!(fixed(&whole.replace("-103", "-13")), whole);
}

/// The last 0 of three angles is not the one before a comment.
#[test]
fn angles_before_a_comment() {
    let text = "2 12 0 0 0 1 1 1\n2 -2 90 0 0 # turned #\n1 9999 2 0\n";
    let analysis = read(text);
    let printed = format(text, &analysis.document, &Options::default());
    assert!(printed.contains("2 -2 90 0 0 # turned #"), "{printed}");
    let safe = fixing::to_fixed_point(read(text), false, Analysis::of);
    assert_eq!(safe.analysis.source.text, text);
    assert!(fixed(text).contains("2 -2 90 1"));
}

/// A sphere that has lost a number is no ellipsoid, and a comma that may begin a number is not removed for certain.
#[test]
fn what_is_not_certain() {
    let text = format!("2 11 0.2 0.4 1.5\n2 -701 1 0 0\n{REST}");
    assert_eq!(fixed(&text), text);
    let text = format!("2 11 0 0 ,5 1\n{REST}");
    let safe = fixing::to_fixed_point(read(&text), false, Analysis::of);
    assert_eq!(safe.analysis.source.text, text);
    assert_eq!(fixed(&text), text.replace(',', "."));
}

/// What an error leaves out of a scene may be what a warning would miss.
#[test]
fn warnings_wait_for_errors() {
    let text = format!("2 11 0 0 0 1\n2 -201 0.8 0.1 0.1.\n2 -203 1.5 1.5 1.5\n{REST}");
    let analysis = read(&text);
    let mut warned = analysis.findings().iter().filter(|d| d.code == Code::W318);
    assert!(warned.next().is_none());
    // The floor that cannot be read is what covers the face in which the tool ends.
    let text = "20 1 2 1 0 1 3\n21 12 -0.3 0 0.5 0.3 1 1.5\n22 -103 20 21\n30 4 0 1 0\n\
                33 -101 22 30\n42 -501 1 3 10 0 -0.1 -1 0 1 0 40\n1 9999 33 0\n";
    let codes = |text: &str| -> Vec<Code> {
        let analysis = read(text);
        analysis.findings().iter().map(|d| d.code).collect()
    };
    assert!(!codes(text).contains(&Code::W321));
    assert!(!codes(&text.replace("4 0 1 0", "4 0 1 0 0")).contains(&Code::W321));
    let alone = text.replace("30 4 0 1 0", "30 4 0 1 0 5");
    assert!(codes(&alone).contains(&Code::W321));
}

/// A safe fix waits while a change of its object cannot be read.
#[test]
fn a_bound_waits_for_what_moves_its_object() {
    let text = "2 9 1\n2 1 5 0 0\n2 -602 5 0 0 1.1\n1 9999 2 0\n";
    let safe = fixing::to_fixed_point(read(text), false, Analysis::of);
    assert_eq!(safe.analysis.source.text, text);
    assert_eq!(fixed(text), text.replace("2 1 5", "2 -1 5"));
}

/// A record with too many numbers does not take the next one as well.
#[test]
fn too_many_numbers_before_too_few() {
    let all = repair::proposals(&read(&format!("2 9 1\n2 -3 2 2 2 2\n2 -1 1\n{REST}")));
    let said: Vec<(Code, String)> = (all.iter())
        .map(|d| (d.code, d.wording(Language::English).message))
        .collect();
    assert_eq!(
        said[0].1,
        "too many numbers: a scaling takes 3 numbers, here are 4"
    );
    assert_eq!(
        said[1].1,
        "too few numbers: a translation takes 3 numbers, here is 1"
    );
}

/// A camera whose direction has lost its minus gets it, whatever floor is in view; a point to look at comes second.
#[test]
fn a_lost_minus_of_a_direction() {
    let scene = |floor: &str, at: &str, direction: &str| {
        format!(
            "2 11 0 0 0 1\n2 -1 {at}\n{floor}4 -101 2 3\n9 -501 0 1 8 {direction} 0 1 0 45\n\
             50 -402 1\n50 -1 3 5 5\n1 9999 4 0\n"
        )
    };
    for floor in ["3 4 0 1 0 1\n", "3 3 0 1 0 1\n", "3 12 -1 -1 -1 1 1 -0.5\n"] {
        for at in ["0 0 -2", "0 3 -2"] {
            let written = scene(floor, at, "0 0 1");
            let all = repair::proposals(&read(&written));
            let unseen = all.iter().find(|d| d.code == Code::W324).unwrap();
            assert_eq!(unseen.fixes[0].title, "fix-sign");
            assert_eq!(fixed(&written), scene(floor, at, "0 0 -1"));
        }
    }
    // A point within what is drawn is a point.
    let floor = "3 4 0 1 0 5\n";
    let written = scene(floor, "0.5 -3 0", "0.75 -3 0.25");
    assert_eq!(fixed(&written), scene(floor, "0.5 -3 0", "0.75 -4 -7.75"));
}

/// Where a camera has lost one of its numbers, all places that make a camera are choices. No parameter is said to be
/// missing unless only it can be.
#[test]
fn a_lost_number_of_a_camera() {
    let scene = |numbers: &str| {
        format!("2 11 0 0 0 1\n9 -501 {numbers}\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n")
    };
    let proposed = |numbers: &str| {
        let all = repair::proposals(&read(&scene(numbers)));
        let error = all.into_iter().find(|d| d.code == Code::E008).unwrap();
        let written = |fix| fixes::apply(&scene(numbers), std::iter::once(fix)).0;
        let texts: Vec<String> = error.fixes.iter().map(written).collect();
        (texts, error)
    };
    let (texts, error) = proposed("4 5 -3 -4 -5 0 1 0 45");
    let places = ["0 4 5 -3 -4 -5", "4 5 0 -3 -4 -5", "4 5 -3 -4 -5 0"];
    assert_eq!(texts, places.map(|p| scene(&format!("{p} 0 1 0 45"))));
    assert!(!error.notes.contains(&"lack"), "{error:?}");
    assert_eq!(
        fixed(&scene("4 5 -3 -4 -5 0 1 0 45")),
        scene("4 5 -3 -4 -5 0 1 0 45")
    );
    // The rest of the up vector, and the angle.
    assert_eq!(
        fixed(&scene("0 1 8 0 0 -1 0 1 45")),
        scene("0 1 8 0 0 -1 0 1 0 45")
    );
    assert_eq!(
        fixed(&scene("0 1 8 0 0 -1 0 0 45")),
        scene("0 1 8 0 0 -1 0 1 0 45")
    );
    let (texts, error) = proposed("0 1 8 0 0 -1 0 1 0");
    assert_eq!(texts, [scene("0 1 8 0 0 -1 0 1 0 45")]);
    assert!(error.notes.contains(&"lack"), "{error:?}");
    // Nobody knows what else is missing.
    let (texts, error) = proposed("0 1 8 0 0 -1");
    assert!(texts.is_empty());
    assert!(error.notes.contains(&"lack-any"), "{error:?}");
}

/// The type of an operation between its operands, whatever types have the numbers of these.
#[test]
fn operations_between_their_operands() {
    let scene = |line: &str| {
        format!(
            "3 11 0.5 0 0 1\n51 11 0 0 0 1\n{line}\n{}",
            REST.replace("9999 2", "9999 52")
        )
    };
    for ty in ["-101", "-102", "-103"] {
        for (a, b) in [("51", "3"), ("3", "51")] {
            let written = scene(&format!("52 {a} {ty} {b}"));
            assert_eq!(fixed(&written), scene(&format!("52 {ty} {a} {b}")));
            let safe = fixing::to_fixed_point(read(&written), false, Analysis::of);
            assert_eq!(safe.analysis.source.text, written);
        }
    }
}

/// No fix is promised for decimals of what has none: the cells of a checkerboard are a number.
#[test]
fn decimal_commas_of_whole_numbers() {
    let scene =
        |cells: &str| format!("11 -701 1 0 0\n12 -701 0 0 1\n2 9 1\n2 -399 {cells} 11 12\n{REST}");
    let all = repair::proposals(&read(&scene("1,5 1,5")));
    assert_eq!(all.iter().filter(|d| d.code == Code::E010).count(), 2);
    assert!(
        all.iter()
            .all(|d| d.code != Code::E003 && d.fixes.is_empty()),
        "{all:?}"
    );
    assert_eq!(fixed(&scene("8,0 4")), scene("8 4"));
}

/// A comma and a space are a separator where the count fits; a decimal comma is a guess where it does not.
#[test]
fn decimal_commas_with_a_space() {
    let scene = |line: &str| format!("{line}\n{REST}");
    let safe = |text: &str| {
        let mended = fixing::to_fixed_point(read(text), false, Analysis::of);
        mended.analysis.source.text.clone()
    };
    let list = scene("2 11 0, 9 0 1");
    assert_eq!(safe(&list), scene("2 11 0 9 0 1"));
    for (written, meant) in [
        ("2 11 0 0, 9 0 1", "2 11 0 0.9 0 1"),
        ("2 11 -1,  5 0 0 1", "2 11 -1.5 0 0 1"),
        ("2 10 1, 5 1 1", "2 10 1.5 1 1"),
        ("2 12 0, 9 0, 5 0 2 2 2", "2 12 0.9 0.5 0 2 2 2"),
        // Either may be meant.
        ("2 11 0, 1, 5, 1 1", "2 11 0, 1, 5, 1 1"),
    ] {
        assert_eq!(safe(&scene(written)), scene(written));
        assert_eq!(fixed(&scene(written)), scene(meant));
    }
}

/// The name of a type in the place of the ID: a record begins with its ID, which is one that is missing, that of the
/// record before, or a free one.
#[test]
fn names_of_types_without_an_id() {
    let behind = |lines: &str| format!("2 9 1\n{lines}\n{REST}");
    for (written, meant) in [
        (
            format!("sphere 0 1 0 1\n{REST}"),
            format!("2 11 0 1 0 1\n{REST}"),
        ),
        (
            behind("sphere 0 1 0 1\nbox 0 0 0 1 1 1"),
            behind("51 11 0 1 0 1\n52 12 0 0 0 1 1 1"),
        ),
        (
            behind("colour 1 0 0\ntranslate 0 1 0"),
            behind("2 -701 1 0 0\n2 -1 0 1 0"),
        ),
    ] {
        let all = repair::proposals(&read(&written));
        let errors: Vec<(Code, &str)> = all
            .iter()
            .filter(|d| d.is_error())
            .map(|d| (d.code, d.case))
            .collect();
        assert!(
            errors.iter().all(|e| *e == (Code::E005, "name")),
            "{errors:?}"
        );
        let said = all[0].wording(Language::English).message;
        assert!(said.ends_with("a record begins with its ID"), "{said}");
        assert_eq!(fixed(&written), meant);
        let safe = fixing::to_fixed_point(read(&written), false, Analysis::of);
        assert_eq!(safe.analysis.source.text, written);
    }
}

/// A corner or the centre and a size look like swapped corners: any may be meant, unless a size would be negative.
#[test]
fn a_corner_and_a_size() {
    let scene = |numbers: &str| format!("2 12 {numbers}\n{REST}");
    let text = scene("1 2 3 2 1 2");
    let all = repair::proposals(&read(&text));
    let error = all.iter().find(|d| d.code == Code::E202).unwrap();
    let written = |fix| fixes::apply(&text, std::iter::once(fix)).0;
    let proposed: Vec<String> = error.fixes.iter().map(written).collect();
    let centre = scene("0 1.5 2 2 2.5 4");
    assert_eq!(
        proposed,
        [scene("1 1 2 2 2 3"), scene("1 2 3 3 3 5"), centre]
    );
    let said = error.wording(Language::Czech).fixes;
    let centre = "je-li `1 2 3` střed a `2 1 2` velikost, napsat `0 1.5 2 2 2.5 4`";
    assert_eq!(said[2], centre);
    assert_eq!(fixed(&text), text);
    let safe = fixing::to_fixed_point(read(&scene("1 -1 0 -1 1 1")), false, Analysis::of);
    assert_eq!(safe.analysis.source.text, scene("-1 -1 0 1 1 1"));
}

/// One number in the place of three: a grey has it three times, and of the parts of light it may be any.
#[test]
fn one_number_for_three() {
    let scene = |line: &str| format!("2 9 1\n{line}\n{REST}");
    let proposed = |line: &str| {
        let text = scene(line);
        let all = repair::proposals(&read(&text));
        let error = all.into_iter().find(|d| d.code == Code::E008).unwrap();
        let written = |fix| fixes::apply(&text, std::iter::once(fix)).0;
        error.fixes.iter().map(written).collect::<Vec<String>>()
    };
    assert_eq!(proposed("2 -701 10"), [scene("2 -701 10 10 10")]);
    assert_eq!(fixed(&scene("2 -701 0.2")), scene("2 -701 0.2 0.2 0.2"));
    let parts = ["0.2 0 0", "0.8 0 0.2", "0.8 0.2 0"].map(|p| scene(&format!("2 -201 {p}")));
    for one in ["2 -201 20", "2 -201 0.2"] {
        let mut all = proposed(one);
        all.sort();
        assert_eq!(all, parts);
        assert_eq!(fixed(&scene(one)), scene(one));
    }
}

/// A letter for a digit in an ID is mended where it stands, whoever names the ID.
#[test]
fn letters_in_ids() {
    let rest = REST.replace("9999 2", "9999 4");
    for (one, other) in [("1O", "10"), ("2l", "21")] {
        let text = |id: &str| format!("2 9 1\n{id} 11 0 0 0 2\n4 -102 2 {other}\n{rest}");
        let all = repair::proposals(&read(&text(one)));
        let errors: Vec<Code> = all
            .iter()
            .filter(|d| d.is_error())
            .map(|d| d.code)
            .collect();
        assert_eq!(errors, [Code::E003]);
        assert_eq!(fixed(&text(one)), text(other));
    }
}

/// Units go, and so does a second point.
#[test]
fn units_and_doubled_points() {
    for (written, meant) in [
        ("2 9 1\n2 -2 40deg 2", "2 9 1\n2 -2 40 2"),
        ("2 11 0 -11cm 0 15", "2 11 0 -11 0 15"),
        ("2 11 0 0 0 2..5", "2 11 0 0 0 2.5"),
    ] {
        assert_eq!(
            fixed(&format!("{written}\n{REST}")),
            format!("{meant}\n{REST}")
        );
    }
}

/// Cameras, planes, cylinders and lights of POV-Ray on a line become records.
#[test]
fn blocks_of_povray() {
    let rest = "1 9999 2 0\n";
    let lamp = "50 -402 1\n50 -1 3 5 5\n";
    let camera = "9 -501 0 0 6 0 0 -1 0 1 0 45\n";
    for (written, meant) in [
        (
            format!("cylinder {{ <0,0,0>, <0,2,0>, 0.5 }}\n{camera}{lamp}"),
            format!("2 1 2 0.5 0 0.5 2\n{camera}{lamp}"),
        ),
        (
            format!(
                "cylinder {{ <-1,0,0>, <1,0,0>, 0.5 pigment {{ color Red }} }}\n{camera}{lamp}"
            ),
            format!("2 1 2 0.5 0 0.5 2\n2 -2 -90 3\n2 -1 -1 0 0\n2 -701 1 0 0\n{camera}{lamp}"),
        ),
        (
            format!("plane {{ y, -1 pigment {{ color Red }} }}\n{camera}{lamp}"),
            format!("2 4 0 1 0 1\n2 -701 1 0 0\n{camera}{lamp}"),
        ),
        (
            format!("2 9 1\ncamera {{ location <0,1,8> look_at <0,0,0> angle 40 }}\n{lamp}"),
            format!("2 9 1\n51 -501 0 1 8 0 -1 -8 0 1 0 30.5\n{lamp}"),
        ),
        (
            format!("2 9 1\n{camera}light_source {{ <3,5,5> color White }}\n"),
            format!("2 9 1\n{camera}10 -402 1\n10 -1 3 5 5\n10 -701 1 1 1\n"),
        ),
    ] {
        let written = written + rest;
        assert_eq!(fixed(&written), meant + rest);
        let safe = fixing::to_fixed_point(read(&written), false, Analysis::of);
        assert_eq!(
            safe.analysis.source.text.matches('{').count(),
            written.matches('{').count()
        );
    }
}

/// The angle of POV-Ray is that of the width, that of a record is that of the height, and 640 by 480 pixels are meant.
#[test]
fn the_angle_of_pov_ray_is_that_of_the_width() {
    let rest = "2 9 1\n50 -402 1\n50 -1 4 6 5\n1 9999 2 0\n";
    let slip = |block: &str| format!("9 camera {{ {block} }}\n{rest}");
    for (block, meant) in [
        (
            "location <0, 3, 8> look_at <0, 1, 0> angle 40",
            "9 -501 0 3 8 0 -2 -8 0 1 0 30.5",
        ),
        // tan 45° is 1, and the arctangent of 3/4 is 36.87°.
        (
            "angle 90 location <0, 3, 8> direction <0, -2, -8>",
            "9 -501 0 3 8 0 -2 -8 0 1 0 73.7",
        ),
    ] {
        let text = slip(block);
        assert_eq!(fixed(&text), format!("{meant}\n{rest}"));
        let all = repair::proposals(&read(&text));
        let first = &all.iter().find(|d| !d.fixes.is_empty()).unwrap();
        let angle = meant.rsplit(' ').next().unwrap();
        for (language, width) in [
            (Language::English, "spans the width"),
            (Language::Czech, "úhel na šířku"),
        ] {
            let said = &first.wording(language).fixes[0];
            assert!(
                said.contains(width) && said.contains(&format!("`{angle}`")),
                "{said}"
            );
        }
    }
    // Without an angle nothing is to be said of one.
    let text = slip("location <0, 3, 8> look_at <0, 1, 0>");
    let all = repair::proposals(&read(&text));
    let titles = all.iter().flat_map(|d| &d.fixes).map(|f| f.title);
    assert!(titles.clone().count() > 0);
    assert!(titles.clone().all(|title| title != "fix-block-angle"));
}

/// Words are no numbers.
#[test]
fn words_are_not_counted() {
    let all = repair::proposals(&read(&format!("2 9 1\n2 -701 rgb 0.8 0.9\n{REST}")));
    let said = all.iter().map(|d| d.wording(Language::English).message);
    let said: Vec<String> = said.collect();
    assert!(said.iter().all(|s| !s.contains("here are 3")), "{said:?}");
}

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

/// What a fix that is certain writes, and what a guess writes.
fn written(text: &str) -> (String, String) {
    let safe = fixing::to_fixed_point(read(text), false, Analysis::of);
    (safe.analysis.source.text.clone(), fixed(text))
}

/// A union of many operands stays on its line, though its last numbers look like a record.
#[test]
fn operands_that_look_like_a_record() {
    let ball = |id: u32| format!("{id} 11 {} 0 0 1\n", 3 * id);
    for (ids, line, count) in [
        (2..10, "12 -101 2 3 4 5 6 7 8 9", 7),
        (2..8, "14 -101 2 7 3 4 5", 4),
    ] {
        let balls: String = ids.map(ball).collect();
        let rest = REST.replace("9999 2", &format!("9999 {}", &line[..2]));
        let text = format!("{balls}{line}\n{}", rest.replacen('9', "40", 1));
        let all = repair::proposals(&read(&text));
        assert!(all.iter().all(|d| d.code != Code::S503), "{all:?}");
        let (safe, guessed) = written(&text);
        assert_eq!(safe, text);
        assert_eq!(guessed.matches(" -101 ").count(), count);
        let printed = format(&text, &read(&text).document, &Options::default());
        assert!(printed.contains(line), "{printed}");
    }
    // Two records are two.
    let (safe, _) = written(&format!("2 9 1 3 9 2\n4 -101 2 3\n{REST}"));
    assert!(safe.starts_with("2 9 1\n3 9 2\n"), "{safe}");
}

/// A profile that has lost a number is no profile without its count.
#[test]
fn a_lost_number_of_a_profile() {
    for line in [
        "2 1 4  0.5 0  0.5 1  0.2 2  0",
        "2 1 6  0 0  0.8 0  0.6 0.2  0.9  0.8 2  0 0.3",
    ] {
        let text = format!("{line}\n{REST}");
        let error = first_error(&text);
        assert_eq!((error.code, error.fixes.len()), (Code::E008, 0));
        assert_eq!(fixed(&text), text);
    }
    let text = format!("2 1 0.5 0 0.5 1 0.2 2\n{REST}");
    assert_eq!(fixed(&text), text.replace("2 1 0.5", "2 1 3 0.5"));
}

/// A `#` within a comment, as before the number of a task.
#[test]
fn signs_within_comments() {
    for (comment, meant) in [
        ("# see #1 top #", "# see 1 top #"),
        ("# ball #1 #", "# ball 1 #"),
        ("# see #1 top", "# see 1 top #"),
    ] {
        let text = format!("2 11 0 1 0 1 {comment}\n{REST}");
        let error = first_error(&text);
        let shown = fixes::apply(&text, error.fixes.iter()).0;
        assert_eq!(shown, text.replace(comment, meant));
        assert_eq!(written(&text), (text.clone(), shown));
    }
    let text = format!("# Home #1 #\n2 9 1\n{REST}");
    let all = repair::proposals(&read(&text));
    let shown = fixes::apply(&text, all.iter().flat_map(|d| &d.fixes)).0;
    assert_eq!(shown, text.replace("# Home #1 #", "# Home 1 #"));
    assert_eq!(fixed(&text), format!("0 {shown}"));
}

/// A guess is judged in the scene that the guesses of other lines make, and an ID that one of them defines is defined.
#[test]
fn guesses_beside_other_errors() {
    let scene = |second: &str, hole: &str, lamp: &str| {
        format!(
            "2 11 0 1.5 0 1.5\n{second} 0 1.5 0 1.3\n4 12 -2 1.8 -2 2 4 2\n5 {hole} 2 3\n6 -103 5 4\n\
             9 -501 0 5 12 0 -0.35 -1 0 1 0 40\n50 {lamp}\n50 -1 5 9 6\n1 9999 6 0\n"
        )
    };
    let meant = scene("3 11", "-103", "-402 0.8");
    for (second, hole, lamp) in [
        ("2 11", "-103", "-402 0,8"),
        ("311", "-103", "402 0.8"),
        ("3 11", "-13", "-402 O.8"),
        ("3 11", "-13", "402 0.8"),
    ] {
        assert_eq!(fixed(&scene(second, hole, lamp)), meant);
    }
}

/// Arithmetic is done, and another sign in the place of a point becomes one.
#[test]
fn numbers_to_be_calculated() {
    for (number, meant) in [
        ("2^3", "8"),
        ("√2", "1.4142135623730951"),
        ("0'8", "0.8"),
        ("0·8", "0.8"),
        ("0:8", "0.8"),
        ("3*0.3", "0.9"),
        ("0.7+0.2", "0.9"),
        ("½", "0.5"),
        ("0.7f", "0.7"),
    ] {
        let text = |number: &str| format!("2 11 0 1 0 {number}\n{REST}");
        let (safe, guessed) = written(&text(number));
        assert_eq!((safe, guessed), (text(number), text(meant)));
    }
}

/// An operation without its type: no guess drops an operand.
#[test]
fn operations_without_their_type() {
    for (a, b) in [("32", "33"), ("2", "3"), ("20", "23")] {
        let scene = |line: &str| {
            let rest = REST.replace("9999 2", "9999 44");
            format!("{a} 11 0 0 0 1\n{b} 11 1 0 0 1\n{line}\n{rest}")
        };
        let text = scene(&format!("44 {a} {b}"));
        let error = first_error(&text);
        let shown = |fix| fixes::apply(&text, std::iter::once(fix)).0;
        let proposed: Vec<String> = error.fixes.iter().map(shown).collect();
        let types = ["-101", "-102", "-103"];
        assert_eq!(proposed, types.map(|ty| scene(&format!("44 {ty} {a} {b}"))));
        assert_eq!(fixed(&text), proposed[0]);
    }
}

/// A space in the type of what nothing else defines.
#[test]
fn types_with_a_space() {
    let rest = REST.replace("9999 2", "9999 34");
    let text = format!("34 1 4  0.4 0.1\n34 -701 1 0 0\n{rest}");
    assert_eq!(fixed(&text), text.replace("1 4  0.4", "14  0.4"));
}

/// A change between two records of one ID is of that object.
#[test]
fn ids_between_records_of_another() {
    let rest = REST.replace("9999 2", "9999 4");
    let text = format!(
        "24 11 0 0 0 1\n34 14 0.4 0.1\n23 -2 90 1\n34 -1 1.3 1.7 -0.5\n4 -101 24 34\n{rest}"
    );
    assert_eq!(fixed(&text), text.replace("23 -2", "34 -2"));
}

/// A record that stands there twice goes.
#[test]
fn a_record_twice() {
    let rest = "8 -1 0 1 0\n4 -101 2 8\n".to_owned() + &REST.replace("9999 2", "9999 4");
    let once = format!("2 9 1\n8 14 0.7 0.2\n{rest}");
    let twice = once.replace("8 14 0.7 0.2\n", "8 14 0.7 0.2\n8 14 0.7 0.2\n");
    assert_eq!(written(&twice), (twice.clone(), once));
}

/// The direction and the up vector of a camera in each other's place.
#[test]
fn a_view_and_its_up_vector_swapped() {
    let scene = |vectors: &str| {
        format!("2 11 0 1 0 1\n9 -501 0 5 12 {vectors} 40\n50 -402 1\n50 -1 5 9 6\n1 9999 2 0\n")
    };
    let text = scene("0 1 0 0 -0.35 -1");
    let all = repair::proposals(&read(&text));
    let unseen = all.iter().find(|d| d.code == Code::W324).unwrap();
    let titles: Vec<&str> = unseen.fixes.iter().map(|f| f.title).collect();
    assert_eq!(titles, ["fix-view-and-up", "fix-point"]);
    assert_eq!(fixed(&text), scene("0 -0.35 -1 0 1 0"));
}

/// The ID of a colour for its numbers is assigned; of what is assigned to an object instead of itself none is taken.
#[test]
fn colours_by_their_ids() {
    let text = format!("2 9 1\n20 -701 1 0 0\n2 -701 20\n{REST}");
    assert_eq!(fixed(&text), text.replace("2 -701 20", "2 -299 20 0"));
    let text =
        format!("2 9 1\n25 -201 0.7 0.3 0\n26 -701 1 0 0\n27 -701 1 1 0\n2 -299 2 25\n{REST}");
    let error = first_error(&text);
    assert_eq!((error.code, error.fixes.len()), (Code::E103, 3));
    assert_eq!(fixed(&text), text);
}

/// A camera without its up vector takes no numbers of a render record with a slip in its type.
#[test]
fn two_slips_on_neighbouring_lines() {
    let scene = |up: &str, ty: &str| {
        format!(
            "14 11 0 1 0 1\n50 -402 1\n50 -1 5 9 6\n9 -501 0 5 12 0 -0.35 -1{up} 40\n1 {ty} 14 0\n"
        )
    };
    let text = scene("", "999");
    assert_eq!(written(&text), (text.clone(), scene(" 0 1 0", "9999")));
}

/// A refractive index that has lost its point is a choice.
#[test]
fn refractive_indices_without_a_point() {
    let text = format!("2 9 1\n2 -203 15 15 15\n2 -201 0 0.1 0.9\n{REST}");
    let all = repair::proposals(&read(&text));
    let large = all.iter().find(|d| d.code == Code::W318).unwrap();
    assert_eq!(large.case, "too-large");
    let shown = fixes::apply(&text, large.fixes.iter()).0;
    assert_eq!(shown, text.replace("15 15 15", "1.5 1.5 1.5"));
    assert_eq!(fixed(&text), text);
}

/// A zero that stands for nothing has rather a point behind it: a choice, which `fmt` leaves to people.
#[test]
fn numbers_that_begin_with_a_zero() {
    for (number, meant) in [("08", "0.8"), ("+05", "0.5"), ("015", "0.15")] {
        let scene =
            |number: &str| format!("2 9 1\n{}", REST.replace("3 5 5", &format!("3 {number} 5")));
        let text = scene(number);
        let all = repair::proposals(&read(&text));
        let odd = all.iter().find(|d| d.code == Code::S505).unwrap();
        let shown = fixes::apply(&text, odd.fixes.iter()).0;
        assert_eq!(shown, scene(meant));
        assert_eq!(written(&text), (text.clone(), text.clone()));
        let printed = format(&text, &read(&text).document, &Options::default());
        assert!(printed.contains(&format!(" {number} ")), "{printed}");
    }
    let all = repair::proposals(&read(&format!("2 11 0 00 0 1\n{REST}")));
    assert!(all.iter().all(|d| d.code != Code::S505));
}

/// A space beside a decimal point, where there are too many numbers.
#[test]
fn points_with_a_space() {
    for (number, meant) in [("-0. 35", "-0.35"), ("0 .8", "0.8")] {
        let text = format!("2 11 0 0 {number} 1\n{REST}");
        assert_eq!(written(&text), (text.clone(), text.replace(number, meant)));
    }
}

/// Moves, turns and properties of POV-Ray behind an ID.
#[test]
fn clauses_of_povray_behind_an_id() {
    for (line, meant) in [
        ("2 scale 1.2", "2 -3 1.2 1.2 1.2"),
        ("2 rotate x*75", "2 -2 75 1"),
        ("2 rotate -30*y", "2 -2 -30 2"),
        ("2 pigment { color rgb <1,0,0> }", "2 -701 1 0 0"),
        ("2 interior { ior 1.5 }", "2 -203 1.5 1.5 1.5"),
    ] {
        let text = format!("2 11 0.5 0.5 0 1\n{line}\n{REST}");
        let error = first_error(&text);
        let shown = fixes::apply(&text, error.fixes.iter()).0;
        assert_eq!(shown, text.replace(line, meant));
    }
}

/// A difference with a wrong digit in its type.
#[test]
fn a_difference_that_looks_like_an_index() {
    let rest = REST.replace("9999 2", "9999 6");
    let text = format!("3 11 0 0 0 1\n4 11 1 0 0 1\n6 -203 3 4\n{rest}");
    assert_eq!(fixed(&text), text.replace("-203", "-103"));
}

/// A radius with a minus is a choice: the minus goes.
#[test]
fn a_radius_with_a_minus() {
    let text = format!("2 9 -0.5\n{REST}");
    let all = repair::proposals(&read(&text));
    let error = all.iter().find(|d| d.code == Code::E201).unwrap();
    let shown = fixes::apply(&text, error.fixes.iter()).0;
    assert_eq!(shown, text.replace("-0.5", "0.5"));
    assert_eq!(fixed(&text), text);
}

/// An ID that nothing defines is told of every record that has it.
#[test]
fn an_undefined_id_in_many_records() {
    let lines: String = (10..50).map(|id| format!("{id} -101 2 77\n")).collect();
    let all = repair::proposals(&read(&format!("2 11 0 0 0 1\n{lines}{REST}")));
    let undefined = all.iter().filter(|d| d.code == Code::E101);
    assert_eq!(undefined.count(), 40);
}

/// A space between two numbers is lost: behind the type, between operands, behind a zero.
#[test]
fn lost_spaces_between_numbers() {
    for (line, meant) in [
        ("26 110.8 0.5 0 0.5", "26 11 0.8 0.5 0 0.5"),
        ("26 113 0.5 0 0.5", "26 11 3 0.5 0 0.5"),
        ("26 122 0 0 4 1 1", "26 12 2 0 0 4 1 1"),
        ("26 11 3 00.5 1", "26 11 3 0 0.5 1"),
    ] {
        let rest = "26 -701 0.2 0.3 0.8\n4 -101 2 26\n".to_owned();
        let rest = rest + &REST.replace("9999 2", "9999 4");
        let text = format!("2 9 1\n{line}\n{rest}");
        assert_eq!(fixed(&text), text.replace(line, meant));
    }
    let rest = REST.replace("9999 2", "9999 4");
    for (line, meant) in [
        (
            "3 -7010.2 0.3 0.8\n4 -101 2 3",
            "3 -701 0.2 0.3 0.8\n4 -101 2 3",
        ),
        ("4 -10123", "4 -101 2 3"),
        ("4 -101 23", "4 -101 2 3"),
    ] {
        let text = format!("2 9 1\n3 11 3 0.5 0 0.5\n{line}\n{rest}");
        assert_eq!(fixed(&text), text.replace(line, meant));
    }
}

/// An ID glued to its type, where properties of the object stand below.
#[test]
fn glued_ids_with_properties_below() {
    let rest = REST.replace("9999 2", "9999 4");
    let below = [
        "26 -701 0.2 0.3 0.8\n4 -101 2 26\n",
        "26 -299 11 14\n26 -203 1.5 1.5 1.5\n4 -101 2 26\n",
    ];
    for below in below {
        let above = "10 -701 0.9 0.2 0.1\n11 -701 1 0 0\n14 -201 0.5 0 0.5\n2 9 1\n2 -299 10 0\n";
        let text = format!("{above}2611 3 0.5 0 0.5\n{below}{rest}");
        assert_eq!(fixed(&text), text.replace("2611 3", "26 11 3"));
    }
}

/// A lost digit of an ID: that of the record above comes first.
#[test]
fn lost_digits_of_ids() {
    let rest = REST.replace("9999 2", "9999 31");
    let text = format!(
        "20 12 -1 0 -1 1 1 1\n21 9 0.3\n22 -105 21\n2 -1 2 0 0\n30 -101 20 21\n31 -101 30 22\n{rest}"
    );
    assert_eq!(fixed(&text), text.replace("2 -1 2 0 0", "22 -1 2 0 0"));
}

/// A refractive index with swapped digits in its ID is of what is transparent, and of nothing that is opaque.
#[test]
fn swapped_digits_of_an_index() {
    let rest = REST.replace("9999 2", "9999 4");
    let scene = |glass: &str, index: &str| {
        format!(
            "12 9 1\n{glass}{index} -203 1.5 1.5 1.5\n3 12 -4 -3 -4 4 -2 4\n4 -101 12 3\n{rest}"
        )
    };
    let glass = "12 -201 0 0.1 0.9\n";
    assert_eq!(fixed(&scene(glass, "21")), scene(glass, "12"));
    let opaque = scene("", "21");
    assert_eq!(fixed(&opaque), opaque);
    let unused = repair::proposals(&read(&opaque));
    let unused = unused.iter().find(|d| d.code == Code::W310).unwrap();
    assert_eq!(unused.fixes.len(), 0);
}

/// An assignment just above the definition of the next object, which has one of its own below: it is of the object above.
#[test]
fn assignments_above_the_next_definition() {
    let rest = REST.replace("9999 2", "9999 4");
    let scene = |id: u32| {
        format!(
            "12 -701 1 0 0\n13 -201 0.5 0 0.5\n25 11 0.8 0 0 1\n25 -1 0 0 1\n{id} -299 12 13\n26 11 3 0 0 1\n\
             26 -299 12 0\n4 -101 25 26\n{rest}"
        )
    };
    assert_eq!(fixed(&scene(26)), scene(25));
    let error = first_error(&scene(26));
    assert_eq!((error.code, error.fixes.len()), (Code::E107, 2));
}

/// A copied line whose ID was not changed: the object that lacks such a record is a choice.
#[test]
fn copied_lines_with_the_same_id() {
    let rest = REST.replace("9999 2", "9999 4");
    let text = format!(
        "10 -701 1 0 0\n11 -701 0 0 1\n2 9 1\n2 -299 10 0\n3 11 3 0.5 0 0.5\n2 -299 11 0\n4 -101 2 3\n{rest}"
    );
    let all = repair::proposals(&read(&text));
    let idle = all.iter().find(|d| d.code == Code::W334).unwrap();
    let shown = fixes::apply(&text, idle.fixes.iter()).0;
    assert_eq!(shown, text.replace("2 -299 11", "3 -299 11"));
    assert_eq!(fixed(&text), text);
}

/// What is left undone by `--unsafe-fixes` keeps its proposals, and says why; no more is promised than is done.
#[test]
fn guesses_that_are_left() {
    let rest = REST.replace("9999 2", "9999 4");
    let text = format!("2 9 1\n3 11 -3 0.5 0 -0.5\n4 -101 2 3\n{rest}");
    let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
    let mut findings = mended.findings;
    fixing::explain_what_is_left(&mended.analysis, &mut findings);
    let radius = findings.iter().find(|d| d.code == Code::E201).unwrap();
    assert_eq!(
        (radius.fixes.len(), &radius.notes[..]),
        (1, &["undecided"][..])
    );
}

/// The numbers of a cylinder behind the type of a surface of revolution.
#[test]
fn cylinders_behind_type_1() {
    for line in ["2 1 0 0 0 0 0.8 0 0.4", "2 1 0.4 0.8"] {
        assert_eq!(
            fixed(&format!("{line}\n{REST}")),
            format!("2 1 2 0.4 0 0.4 0.8\n{REST}")
        );
    }
}

/// A corner and a size of a box, where the bounds might stand in turn, too: the size comes first.
#[test]
fn a_corner_and_a_size_before_swapped_bounds() {
    let text = format!("2 12 -2 0.9 -1 4 0.1 2\n{REST}");
    let error = first_error(&text);
    let titles: Vec<&str> = error.fixes.iter().map(|f| f.title).collect();
    assert_eq!(titles, ["fix-size", "fix", "fix-order"]);
    let shown = fixes::apply(&text, error.fixes.iter().take(1)).0;
    assert_eq!(shown, text.replace("4 0.1 2", "2 1 1"));
    assert_eq!(fixed(&text), text);
}

/// Square roots are calculated.
#[test]
fn square_roots_as_functions() {
    for (number, meant) in [
        ("sqrt(2)/2", "0.707106781187"),
        ("-sqrt(4)", "-2"),
        ("1/sqrt(4)", "0.5"),
    ] {
        let text = format!("2 11 {number} 0 0 1\n{REST}");
        assert_eq!(fixed(&text), text.replace(number, meant));
    }
}

/// A comment with both its signs in front.
#[test]
fn comments_behind_two_signs() {
    let text = format!("2 9 1\n## mug outside\n{REST}");
    assert_eq!(
        fixed(&text),
        text.replace("## mug outside", "0 # mug outside #")
    );
    let text = format!("2 9 1 ## mug outside\n{REST}");
    assert_eq!(
        fixed(&text),
        text.replace("## mug outside", "# mug outside #")
    );
}

/// An up vector that is zero.
#[test]
fn an_up_vector_of_zeros() {
    let text = format!("2 9 1\n{}", REST.replace("0 1 0 45", "0 0 0 45"));
    assert_eq!(fixed(&text), text.replace("0 0 0 45", "0 1 0 45"));
}

/// A rectangle by two corners in space fills what these say: its bounds are theirs.
#[test]
fn the_corners_of_a_rectangle_stay() {
    for (numbers, corners) in [
        ("-5 0 -4 5 0 6", [[-5.0, 0.0, -4.0], [5.0, 0.0, 6.0]]),
        ("-5 2 -4 5 2 6", [[-5.0, 2.0, -4.0], [5.0, 2.0, 6.0]]),
        ("-5 0 -3 5 4 -3", [[-5.0, 0.0, -3.0], [5.0, 4.0, -3.0]]),
        ("-2 0 -4 -2 3 1", [[-2.0, 0.0, -4.0], [-2.0, 3.0, 1.0]]),
    ] {
        let text = fixed(&format!("2 5 {numbers}\n{REST}"));
        let analysis = read(&text);
        let root = analysis.scene.render.unwrap().root;
        let bounds = analysis.bounds()[root as usize].all;
        for (got, meant) in [(bounds.min, corners[0]), (bounds.max, corners[1])] {
            let is_near = |i: usize| (got[i] - meant[i]).abs() < 1e-6;
            assert!((0..3).all(is_near), "{numbers}: {got:?}\n{text}");
        }
    }
}

/// A cone whose ID is the type of a box, which its numbers are no box of: it has a place, and something else uses its ID.
#[test]
fn an_id_that_is_a_type() {
    let text = |cone: &str| {
        let rest = REST.replace("9999 2", "9999 13");
        format!("2 11 0 1 0 1\n{cone}12 -701 0.3 0.7 0.2\n13 -101 2 12\n{rest}")
    };
    let written = text("12 16 -2 0 1 1.5 0.5 # kužel #\n");
    let error = first_error(&written);
    assert_eq!(error.code, Code::E009);
    let meant = text("12 16 1.5 0.5\n12 -1 -2 0 1 # kužel #\n");
    assert_eq!(fixed(&written), meant);
    // A box that is right has lost its ID.
    let written = text("12 -3 -2 0 -1 1.5 0.5\n");
    assert_eq!(first_error(&written).code, Code::E005);
}

/// A colour where its ID belongs: the ID of one with these numbers, whatever its comment says, and 0 for black.
#[test]
fn a_background_that_is_a_colour() {
    let text = |background: &str, above: &str| {
        let rest = REST.replace("9999 2 0", &format!("9999 4 {background}"));
        format!(
            "11 -701 0.2 0.2 0.25 # černá #\n2 11 0 1 0 1\n3 11 2 1 0 0.5\n3 -299 11 0\n\
             4 -101 2 3\n{}",
            rest.replace("1 9999", &format!("{above}1 9999"))
        )
    };
    for (written, meant, above) in [
        ("0 0 0", "0", ""),
        ("0.2 0.2 0.25", "11", ""),
        ("0.2 0.2 0.26", "11", ""),
        ("0.2 0.2 0.4", "51", "51 -701 0.2 0.2 0.4\n"),
        ("černá", "11", ""),
    ] {
        assert_eq!(fixed(&text(written, "")), text(meant, above), "{written}");
    }
}
