//! Slips of IDs in blocks of records: a copied line, the ID of the next or the last object, two digits swapped.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language, fixes};

use super::read;

/// A lamp and a camera.
const VIEW: &str = "50 -402 1\n50 -1 3 5 5\n9 -501 0 1 7 0 0 -1 0 1 0 40\n";
const FLOOR: &str = "2 12 -6 -1 -6 6 0 6\n";
/// A union of two objects, with the floor.
const JOINED: &str = "3 -101 21 22\n4 -101 2 3\n";

fn scene(parts: &[&str]) -> String {
    parts.concat()
}

fn findings(text: &str) -> Vec<Diagnostic> {
    repair::proposals(&read(text))
}

fn the(code: Code, text: &str) -> Diagnostic {
    let found = findings(text).into_iter().find(|d| d.code == code);
    found.unwrap_or_else(|| panic!("no {code:?}\n{text}"))
}

/// The lines that each guess of a finding makes anew.
fn guesses(text: &str, finding: &Diagnostic) -> Vec<String> {
    let old: Vec<&str> = text.lines().collect();
    let new = finding.fixes.iter().map(|fix| {
        let (fixed, _) = fixes::apply(text, [fix].into_iter());
        let lines = fixed.lines().filter(|line| !old.contains(line));
        lines.collect::<Vec<_>>().join("; ")
    });
    new.collect()
}

/// The text after fixes, guesses too if asked for, and how many these were.
fn mended(text: &str, unsafe_too: bool) -> (String, usize) {
    let mended = fixing::to_fixed_point(read(text), unsafe_too, Analysis::of);
    (mended.analysis.source.text.clone(), mended.count)
}

/// The ID of the render record and what it draws in each other's place. A safe fix that is offered is made.
#[test]
fn the_render_record_has_the_id_of_what_it_draws() {
    let colour = "12 -701 0 0 0.1\n";
    for (written, meant) in [("4 9999 1 0", "1 9999 4 0"), ("4 9999 1 12", "1 9999 4 12")] {
        let with = |render: &str| {
            let rest = [FLOOR, "3 11 0 1 0 1\n4 -101 2 3\n", colour, VIEW].concat();
            format!("{rest}{render}\n")
        };
        let finding = the(Code::E105, &with(written));
        assert_eq!(finding.case, "swapped");
        let said = [Language::English, Language::Czech].map(|l| finding.wording(l).message);
        assert!(said[0].contains("are swapped"), "{said:?}");
        assert!(said[1].contains("prohozené"), "{said:?}");
        assert_eq!(mended(&with(written), false), (with(meant), 1));
    }
    // What is drawn is wrong, too: the ID is mended all the same.
    for drawn in ["99", "1", "0"] {
        let with = |id: u32| scene(&[FLOOR, VIEW, &format!("{id} 9999 {drawn} 0\n")]);
        let finding = the(Code::E105, &with(7));
        assert_eq!((finding.case, finding.fixes.len()), ("", 1));
        assert_eq!(mended(&with(7), false), (with(1), 1), "{drawn}");
    }
}

/// A copied line with the ID of the object before, right under the definition of the next one.
#[test]
fn a_copied_property_keeps_its_id() {
    let two = |a: &str, b: &str, c: &str| {
        let first = format!("21 11 -1.2 1 0 1\n21 {a}\n22 11 1.2 1 0 1\n");
        let second = format!("{b}\n{c}");
        scene(&[FLOOR, &first, &second, JOINED, VIEW, "1 9999 4 0\n"])
    };
    let (opaque, clear, index) = (
        "-201 0.15 0.8 0",
        "-201 0.05 0.1 0.85",
        "22 -203 1.5 1.5 1.5\n",
    );
    let text = two(opaque, &format!("21 {clear}"), index);
    assert_eq!(
        guesses(&text, &the(Code::W334, &text)),
        [format!("22 {clear}")]
    );
    assert!(the(Code::W318, &text).fixes.is_empty());
    assert_eq!(mended(&text, true), (text, 0));
    let text = two("-701 1 0 0", "21 -701 0 1 0", "");
    assert_eq!(guesses(&text, &the(Code::W334, &text)), ["22 -701 0 1 0"]);
    // Where the next one has its own, another line lies between: nobody knows.
    let text = two("-701 1 0 0", "22 -701 0 1 0", "21 -701 0 0 1\n");
    assert_eq!(guesses(&text, &the(Code::W334, &text)), ["2 -701 0 0 1"]);
    assert_eq!(mended(&text, true), (text, 0));
}

/// The colour of the second lamp has the ID of the first one.
#[test]
fn a_copied_colour_of_a_lamp_keeps_its_id() {
    let with = |id: u32| {
        let lamp = format!("50 -701 1 1 0.9\n51 -402 0.3\n51 -1 -5 4 3\n{id} -701 1 0.9 0.7\n");
        scene(&[FLOOR, VIEW, &lamp, "1 9999 2 0\n"])
    };
    let text = with(50);
    assert_eq!(
        guesses(&text, &the(Code::W334, &text)),
        ["51 -701 1 0.9 0.7"]
    );
    let [guess] = &the(Code::W334, &text).fixes[..] else {
        panic!("more than one guess");
    };
    assert_eq!(fixes::apply(&text, [guess].into_iter()).0, with(51));
}

/// A property of an object with the ID of the next one, which is defined below.
#[test]
fn a_property_with_the_id_of_the_next_object() {
    let two = |id: u32, own: &str| {
        let blocks = format!("21 14 0.8 0.2\n{id} -201 0.15 0.8 0\n22 11 1.9 1 0 1\n{own}");
        scene(&[FLOOR, &blocks, JOINED, VIEW, "1 9999 4 0\n"])
    };
    let clear = "22 -201 0.05 0.1 0.85\n22 -203 1.5 1.5 1.5\n";
    let text = two(22, clear);
    let made = guesses(&text, &the(Code::E102, &text));
    assert_eq!(made[0], "21 -201 0.15 0.8 0");
    assert_eq!(mended(&text, true).0, two(21, clear));
    // Where the next one has no other, it is moved: both the ID and the place are that one's.
    let moved = |text: &str, lines: &str, meant: &str| {
        assert_eq!(the(Code::E102, text).fixes.len(), 1, "{text}");
        assert_eq!(mended(text, true), (text.replace(lines, meant), 1));
    };
    let (above, object) = ("22 -201 0.15 0.8 0\n", "22 11 1.9 1 0 1\n");
    let (lines, meant) = ([above, object].concat(), [object, above].concat());
    moved(&two(22, ""), &lines, &meant);
    // So it is with an operation.
    let (above, object) = ("44 -701 0.9 0.7 0.1\n", "44 -101 2 33\n");
    let (lines, meant) = ([above, object].concat(), [object, above].concat());
    let ring = "33 14 0.8 0.2\n";
    let text = scene(&[FLOOR, ring, &lines, VIEW, "1 9999 44 0\n"]);
    moved(&text, &lines, &meant);
    // With a record in between it may be meant for either.
    let lines = format!("{ring}{above}5 11 3 1 0 1\n6 -101 5 2\n44 -101 6 33\n");
    let text = scene(&[FLOOR, &lines, VIEW, "1 9999 44 0\n"]);
    let made = guesses(&text, &the(Code::E102, &text));
    assert_eq!((made.len(), &*made[0]), (2, "33 -701 0.9 0.7 0.1"));
    assert_eq!(mended(&text, true), (text, 0));
    // Who writes properties first has them moved.
    let first = "21 -701 1 0 0\n21 14 0.8 0.2\n22 -701 0 1 0\n22 11 1.9 1 0 1\n";
    let text = scene(&[FLOOR, first, JOINED, VIEW, "1 9999 4 0\n"]);
    let fixed = mended(&text, true).0;
    assert!(
        fixed.contains("22 11 1.9 1 0 1\n22 -701 0 1 0\n"),
        "{fixed}"
    );
}

/// The ID of a definition alone is wrong: what stands below it is right.
#[test]
fn a_definition_with_another_id_than_its_block() {
    let with = |id: u32| {
        let block = format!("{id} 14 0.6 0.2\n33 -1 -0.9 0.2 1.4\n33 -701 0.9 0.7 0.1\n");
        scene(&[FLOOR, &block, "4 -101 2 33\n", VIEW, "1 9999 4 0\n"])
    };
    let text = with(36);
    let found = findings(&text);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(guesses(&text, &found[0]), ["33 14 0.6 0.2"]);
    let said = [Language::English, Language::Czech].map(|l| found[0].wording(l).fixes.concat());
    assert!(said[0].contains("in the definition above"), "{said:?}");
    assert!(said[1].contains("v definici výše"), "{said:?}");
    assert_eq!(mended(&text, true), (with(33), 1));
}

/// A colour that nothing has, right under an object that has none.
#[test]
fn an_unused_colour_right_under_its_object() {
    let with = |object: u32, colour: u32| {
        let block = format!("3 11 0 1 0 1\n{object} -103 2 3\n{colour} -701 0.9 0.2 0.1\n");
        scene(&[FLOOR, &block, VIEW, &format!("1 9999 {object} 0\n")])
    };
    // Two digits are swapped, or one is another.
    for colour in [23, 31] {
        let text = with(32, colour);
        let made = guesses(&text, &the(Code::W310, &text));
        assert_eq!(made[0], "32 -701 0.9 0.2 0.1");
        assert_eq!(mended(&text, true).0, with(32, 32));
    }
    for (object, colour) in [(32, 77), (4, 5)] {
        let text = with(object, colour);
        let made = guesses(&text, &the(Code::W310, &text));
        assert_eq!(made[0], format!("{object} -701 0.9 0.2 0.1"));
        assert_eq!(mended(&text, true), (text, 0));
    }
}

/// One number of fields in place of two.
#[test]
fn a_checkerboard_with_one_number_of_fields() {
    let with = |numbers: &str| {
        let board = format!("10 -701 1 0 0\n11 -701 0 1 0\n2 -399 {numbers}\n");
        scene(&[FLOOR, &board, VIEW, "1 9999 2 0\n"])
    };
    let both = ["2 -399 12 12 10 11", "2 -399 1 2 10 11"];
    let cases = [("12 10 11", &both[..]), ("8 10 11", &["2 -399 8 8 10 11"])];
    for (numbers, meant) in cases {
        let text = with(numbers);
        let finding = the(Code::E008, &text);
        assert_eq!(guesses(&text, &finding), meant);
        let said = [Language::English, Language::Czech].map(|l| finding.wording(l).fixes.concat());
        assert!(
            said[0].contains("both directions have the same value"),
            "{said:?}"
        );
        assert!(said[1].contains("totéž číslo v obou směrech"), "{said:?}");
        assert_eq!(mended(&text, true), (text, 0));
    }
}

/// Two colours are a checkerboard with one field of each.
#[test]
fn a_checkerboard_of_two_colours_alone() {
    let scene = |lines: &str| {
        format!(
            "2 4 0 1 0 0\n{lines}\n9 -501 0 3 9 0 -0.2 -1 0 1 0 40\n50 -402 0.8\n50 -1 4 6 5\n1 9999 2 0\n"
        )
    };
    let text = scene("2 -399 1 1 1 0 0 0");
    let (finding, made) = super::guessed(&text, super::Code::E009);
    let right = scene("51 -701 1 1 1\n52 -701 0 0 0\n2 -399 1 1 51 52");
    assert_eq!(made, std::slice::from_ref(&right), "{finding:?}");
    assert_eq!(super::fixed(&text), right);
    // Both colours have records.
    let known = "20 -701 1 1 1\n21 -701 0 0 0\n";
    let text = scene(&format!("{known}2 -399 1 1 1 0 0 0"));
    let right = scene(&format!("{known}2 -399 1 1 20 21"));
    assert_eq!(super::fixed(&text), right);
}
