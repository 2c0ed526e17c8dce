//! Lines that were copied with their ID, and what a comment or a place says of them otherwise.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Code, Language};

use super::{fixed, guessed, read};

const REST: &str = "60 -501 0 2 9 0 -0.2 -1 0 1 0 40\n50 -402 0.8\n50 -1 4 6 5\n1 9999 9 0\n";

fn scene(records: &str) -> String {
    format!("{records}\n{REST}")
}

fn codes(text: &str) -> Vec<Code> {
    let all = repair::proposals(&read(text));
    all.iter().map(|d| d.code).collect()
}

/// The texts have one finding each, whose first guess is taken and leaves no finding.
#[track_caller]
fn mends(code: Code, slips: &[(&str, &str)]) {
    for (written, meant) in slips {
        let text = scene(written);
        assert_eq!(codes(&text), [code], "{text}");
        let (finding, made) = guessed(&text, code);
        assert_eq!(made[0], scene(meant));
        assert_eq!(fixed(&text), scene(meant));
        assert!(codes(&fixed(&text)).is_empty(), "{text}");
        for language in [Language::English, Language::Czech] {
            assert_eq!(finding.wording(language).fixes.len(), made.len());
        }
    }
}

#[track_caller]
fn helps(text: &str, code: Code, meant: [&str; 2]) {
    let (finding, _) = guessed(text, code);
    let said = [Language::English, Language::Czech].map(|l| finding.wording(l).help.unwrap());
    assert_eq!(said, meant);
}

/// Of a mirror that lets all light through its comment speaks, and no index is proposed.
#[test]
fn a_mirror_by_its_comment_needs_no_index() {
    let floor = "3 4 0 1 0 0\n9 -101 2 3";
    for lines in [
        "2 11 0 1 0 1 # zrcadlová koule #\n2 -201 0 0 1",
        "2 11 0 1 0 1\n2 -201 0 0 1 # mirror #",
        "21 -201 0 0 1 # zrcadlo #\n2 11 0 1 0 1\n2 -299 0 21",
    ] {
        let written = [lines, floor].join("\n");
        let meant = written.replace("-201 0 0 1", "-201 0 1 0");
        mends(Code::W342, &[(&written, &meant)]);
    }
    // Glass is that of which the index is forgotten.
    let glass = "2 11 0 1 0 1 # skleněná koule #\n2 -201 0 0 1\n";
    assert_eq!(codes(&scene(&[glass, floor].concat())), [Code::W337]);
}

/// Clear glass cuts no hole into what is apart from it, though the boxes of the two overlap.
#[test]
fn glass_apart_from_a_ball_cuts_no_hole() {
    let with = |x: f64| {
        scene(&format!(
            "2 11 0 1 0 1\n2 -201 0 0 1 # sklo #\n4 11 {x} 1 {x} 1\n\
             5 4 0 1 0 0\n6 -101 2 4\n9 -101 6 5"
        ))
    };
    // The centres are 2.4 apart, and 1.84: √2 times as much.
    assert_eq!(codes(&with(1.7)), [Code::W337]);
    assert!(!codes(&with(1.3)).contains(&Code::W337));
    // Both moved alike.
    let moved = with(1.7).replace("9 -101 6 5", "6 -1 0 1 0\n9 -101 6 5");
    assert_eq!(codes(&moved), [Code::W337]);
}

/// One lost sign in the normal of a floor.
#[test]
fn a_floor_above_its_height() {
    let lines = |ball: &str, floor: &str| format!("{ball}\n{floor}\n9 -101 2 3");
    let ball = "2 11 0 1 0 1 # koule #";
    for word in ["podlaha", "floor", "zem"] {
        let floor = |numbers| lines("2 9 1 # koule #", &format!("3 4 {numbers} # {word} #"));
        mends(Code::W325, &[(&floor("0 -1 0 1"), &floor("0 1 0 1"))]);
        // Moved down, with both signs right, it lies at -1.5.
        let moved = |numbers| lines(ball, &format!("3 4 {numbers} # {word} #\n3 -1 0 -0.5 0"));
        mends(Code::W325, &[(&moved("0 -1 0 1"), &moved("0 1 0 1"))]);
    }
    let text = scene(&lines(ball, "3 4 0 -1 0 0.5 # podlaha #"));
    let (finding, made) = guessed(&text, Code::W325);
    // Turned round it would hold the lower part of the ball.
    assert_eq!(made[0], scene(&lines(ball, "3 4 0 1 0 0.5 # podlaha #")));
    assert_eq!(made[1], scene(&lines(ball, "3 4 0 1 0 -0.5 # podlaha #")));
    assert_eq!(
        finding.wording(Language::Czech).fixes[0],
        "změnit znaménko normály: napsat `0 1 0 0.5`"
    );
    // The height is right: both signs are wrong.
    let text = scene(&lines(ball, "3 4 0 -1 0 -1 # podlaha #"));
    let (_, made) = guessed(&text, Code::W325);
    assert_eq!(made, [scene(&lines(ball, "3 4 0 1 0 1 # podlaha #"))]);
}

/// A colour or optics that were copied with their ID, where the other ID is used.
#[test]
fn properties_copied_with_their_id() {
    let tiles = |id: u32| {
        format!(
            "20 -701 0.9 0.9 0.85 # cream #\n{id} -701 0.25 0.3 0.35 # slate #\n\
             22 -701 0.9 0.2 0.1 # red #\n40 -399 1 1 20 21 # tiles #\n2 4 0 1 0 0\n\
             2 -299 40 0\n3 11 0 1 0 1\n3 -299 22 0\n9 -101 2 3"
        )
    };
    mends(Code::E101, &[(&tiles(20), &tiles(21))]);
    helps(
        &scene(&tiles(20)),
        Code::E101,
        [
            "20 is defined twice: the second definition is probably that of 21",
            "20 je definováno dvakrát: druhá definice patří spíš k 21",
        ],
    );
    // The index behind the copy goes with it.
    let both = |id: u32| glass([30, id, id]);
    mends(Code::E101, &[(&both(30), &both(31))]);
    // Used in between, the first is none that was copied.
    let used = tiles(20).replace(
        "\n20 -701 0.25",
        "\n23 11 0 0 0 9\n23 -701 1 1 1\n20 -701 0.25",
    );
    let used = used.replace("23 -701 1 1 1", "23 -299 20 0");
    let (_, made) = guessed(&scene(&used), Code::E101);
    assert!(
        made.iter().all(|text| !text.contains("\n21 -701")),
        "{made:?}"
    );
}

/// A mirror and glass, with these IDs of their optics and of the index.
fn glass([mirror, glass, index]: [u32; 3]) -> String {
    format!(
        "{mirror} -201 0.1 0.9 0 # mirror #\n{glass} -201 0.05 0.1 0.85 # glass #\n\
         {index} -203 1.5 1.5 1.5\n2 4 0 1 0 0\n3 11 -2 1 0 1\n3 -299 0 30\n\
         4 11 2 1 0 1\n4 -299 0 31\n5 -101 3 4\n9 -101 5 2"
    )
}

/// Optics with an index alone lack the parts that others are given twice.
#[test]
fn optics_copied_beside_their_index() {
    let (written, meant) = (glass([30, 30, 31]), glass([30, 31, 31]));
    mends(Code::W334, &[(&written, &meant)]);
    helps(
        &scene(&written),
        Code::W334,
        [
            "31 has a refractive index but no kd, ks and kt: the second is probably meant for it",
            "31 má index lomu, ale ne kd, ks a kt: druhý záznam patří spíš k němu",
        ],
    );
}

/// The index of the mirror is that of the glass.
#[test]
fn an_index_with_the_id_of_other_optics() {
    let (written, meant) = (glass([30, 31, 30]), glass([30, 31, 31]));
    mends(Code::W318, &[(&written, &meant)]);
    helps(
        &scene(&written),
        Code::W318,
        [
            "31 lets light through and has no index",
            "31 propouští světlo a index nemá",
        ],
    );
}

/// A difference or an intersection is one object, and a union several.
#[test]
fn an_operation_that_is_moved_and_then_turned() {
    let of = |code: i32| {
        scene(&format!(
            "2 12 -1 0 -1 1 1 1\n4 11 0 1 0 0.8\n5 {code} 2 4\n5 -1 1.5 0 -1.5\n\
             5 -2 20 2\n3 4 0 1 0 0\n9 -101 5 3"
        ))
    };
    let swapped =
        |code| of(code).replace("5 -1 1.5 0 -1.5\n5 -2 20 2", "5 -2 20 2\n5 -1 1.5 0 -1.5");
    for code in [-102, -103] {
        assert_eq!(codes(&of(code)), [Code::N609]);
        let (_, made) = guessed(&of(code), Code::N609);
        assert_eq!(made, [swapped(code)]);
        assert!(codes(&swapped(code)).is_empty());
    }
    assert!(codes(&of(-101)).is_empty());
}

/// A property or a transformation with the ID of an earlier object stands among the records of a later one.
#[test]
fn changes_among_the_records_of_another_object() {
    let scene = |lines: &str| scene(&format!("{lines}\n9 -101 3 5"));
    let grouped = |stray: &str| {
        scene(&format!(
            "3 11 -1.2 1 0 1 # mirror ball #\n3 -201 0.1 0.85 0\n5 14 0.6 0.2 # red ring #\n{stray}"
        ))
    };
    for stray in [
        "3 -701 0.9 0.2 0.1 # red #",
        "3 -2 60 1 # leaning back #",
        "3 -3 1 0.5 1",
    ] {
        let text = grouped(stray);
        let (_, made) = guessed(&text, Code::N610);
        assert_eq!(
            made,
            [text.replacen(&format!("\n{stray}"), &format!("\n5{}", &stray[1..]), 1)]
        );
        assert_eq!(fixed(&text), text);
    }
    let balls = "3 11 -2 1 0 1 # ball #\n5 14 0.6 0.2 # ring #\n3 -2 60 1\n5 -1 1 0.8 0";
    let made = guessed(&scene(balls), Code::N610).1;
    assert_eq!(made, [scene(&balls.replace("3 -2", "5 -2"))]);
    for silent in [
        // A comment names the object, a heading or an empty line stands between.
        grouped("3 -701 0.9 0.2 0.1 # the mirror #"),
        grouped("3 -701 0.9 0.2 0.1 # ball #"),
        grouped("0 # colours #\n3 -701 0.9 0.2 0.1"),
        grouped("\n3 -701 0.9 0.2 0.1"),
        // Both have their colour.
        grouped("3 -701 0.9 0.2 0.1\n5 -701 1 0 0"),
        // Definitions first.
        scene("3 11 -2 1 0 1\n5 14 0.6 0.2\n3 -701 1 0 0\n5 -1 1 0.8 0"),
        // Several.
        grouped("3 -701 0.9 0.2 0.1\n7 12 4 0 0 5 1 1\n3 -2 60 1\n8 -101 7 5"),
    ] {
        let codes: Vec<Code> = read(&silent).findings().iter().map(|d| d.code).collect();
        assert!(!codes.contains(&Code::N610), "{silent}");
    }
}

/// Parts of light and an index of their own, which an assignment names as two properties, become one property.
#[test]
fn light_and_index_of_an_assignment_are_joined() {
    let puddle = "2 4 0 1 0 0.2 # tráva #\n3 -701 0.2 0.5 0.1\n4 -701 0.1 0.3 0.1\n\
                  2 -399 1 1 3 4\n5 10 1.5 0.1 0.8 # louže #\n";
    let rest = "9 -101 5 2";
    for (written, meant) in [
        (
            "6 -201 0.1 0.1 0.8 # voda #\n7 -203 1.33 1.33 1.33\n5 -299 6 7\n",
            "6 -201 0.1 0.1 0.8 # voda #\n6 -203 1.33 1.33 1.33\n5 -299 0 6\n",
        ),
        (
            "7 -203 1.33 1.33 1.33 # water #\n6 -202 0.1 0.1 0.1 0.1 0.1 0.1 0.8 0.8 0.8\n5 -299 7 6\n",
            "6 -203 1.33 1.33 1.33 # water #\n6 -202 0.1 0.1 0.1 0.1 0.1 0.1 0.8 0.8 0.8\n5 -299 0 6\n",
        ),
    ] {
        let text = scene(&[puddle, written, rest].concat());
        let (_, made) = guessed(&text, Code::E103);
        assert_eq!(made, [scene(&[puddle, meant, rest].concat())], "{text}");
    }
    // No colour of the checkerboard is proposed.
    let written = "6 -201 0.1 0.1 0.8\n5 -299 6 6\n";
    let text = scene(&[puddle, written, rest].concat());
    let (_, made) = guessed(&text, Code::E103);
    assert_eq!(made, [text.replace("-299 6 6", "-299 0 6")]);
}
