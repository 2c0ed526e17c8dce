//! Guesses of which several are as good, and what they say in both languages.

use zpg::internals::analysis::{Analysis, fixing};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Language};

use super::{fixed, guessed, read};

const REST: &str = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.3\n50 -1 4 6 5\n";

fn scene(records: &str, drawn: u32) -> String {
    format!("{records}\n{REST}1 9999 {drawn} 0\n")
}

/// A finding's fixes in a language.
fn titles(d: &Diagnostic, language: Language) -> Vec<String> {
    d.wording(language).fixes
}

fn is_choice(d: &Diagnostic) -> bool {
    let is_one = |f: &zpg::internals::diagnostics::Fix| f.applicability == Applicability::Choice;
    d.fixes.iter().all(is_one)
}

fn safely_fixed(text: &str) -> String {
    let mended = fixing::to_fixed_point(read(text), false, Analysis::of);
    mended.analysis.source.text
}

/// Bounds out of order, and what may be meant. A lost minus gives the cube, where one is named.
#[test]
fn bounds_out_of_order_by_one_number() {
    let of = |bounds: &str| scene(bounds, 20);
    let text = of("20 12 1.5 0 1.5 2.9 1.4 -0.1 # cube #");
    let (finding, made) = guessed(&text, Code::E202);
    let meant = [
        "20 12 1.5 0 -1.5 2.9 1.4 -0.1 # cube #",
        "20 12 1.5 0 -0.1 2.9 1.4 1.5 # cube #",
    ];
    assert_eq!(made, meant.map(of));
    assert_eq!(
        titles(&finding, Language::Czech)[0],
        "napsat `-1.5` místo `1.5`"
    );
    assert!(is_choice(&finding));
    assert_eq!(fixed(&text), text);
    assert_eq!(safely_fixed(&text), text);
    // Without the word, too, equal edges are likelier than a swap that makes none.
    let bare = text.replace(" # cube #", "");
    let (_, made) = guessed(&bare, Code::E202);
    assert_eq!(made, meant.map(|m| of(m.trim_end_matches(" # cube #"))));
    // Otherwise the swap comes first.
    let (_, made) = guessed(&bare.replace("2.9 1.4", "2.7 1.3"), Code::E202);
    assert_eq!(made[0], of("20 12 1.5 0 -0.1 2.7 1.3 1.5"));
    // A number that begins with a zero is the likelier slip.
    let text = of("20 12 015 0 -1.5 2.9 1.4 -0.1");
    let (finding, made) = guessed(&text, Code::E202);
    let first = ["0.15", "1.5"].map(|x| text.replace("015", x));
    assert_eq!(made[..2], first);
    assert!(is_choice(&finding));
    assert_eq!(safely_fixed(&text), text);
    // No other number brings these into order.
    for (written, meant) in [
        ("20 12 1 0 -1 -1 2 1", "20 12 -1 0 -1 1 2 1"),
        ("20 12 1 1 1 -2 0 -3", "20 12 -2 0 -3 1 1 1"),
    ] {
        assert_eq!(safely_fixed(&of(written)), of(meant));
    }
}

/// A lost point explains what else is said of a record.
#[test]
fn a_lost_point_explains_what_else_is_said() {
    let moon = "20 11 0 1 0 1\n10 11 3 1 2 06 # moon #\n21 -101 20 10";
    let cut = "20 12 -1 0 -1 1 2 1\n21 11 0 2 0 06\n22 -103 20 21";
    for (records, drawn, code, written, meant) in [
        ("20 14 0.8 025 # ring #", 20, Code::W320, "025", "0.25"),
        (moon, 21, Code::W326, "06", "0.6"),
        (cut, 22, Code::W319, "06", "0.6"),
    ] {
        let text = scene(records, drawn);
        let (finding, made) = guessed(&text, code);
        assert!(made.is_empty(), "{text}");
        let said = finding.wording(Language::English);
        assert!(said.help.is_none());
        let note = format!(
            "a number in this record begins with a zero; write `{meant}` and this message goes away"
        );
        assert!(said.notes.contains(&note), "{said:?}");
        let note = format!("číslo v záznamu začíná nulou: s `{meant}` toto hlášení zmizí");
        assert!(finding.wording(Language::Czech).notes.contains(&note));
        assert_eq!(fixed(&text), text.replace(written, meant));
    }
    // With a point the tube would still be wider than the ring.
    let text = scene("20 14 0.2 08", 20);
    let (_, made) = guessed(&text, Code::W320);
    assert_eq!(made, [text.replace("0.2 08", "08 0.2")]);
}

/// A ball that is taken away holds all that it is taken away from: both are in each other's place, or, where comments say
/// what is cut, the ball may be too large.
#[test]
fn a_cut_that_is_too_large() {
    let of = |cuboid: &str, ball: &str| {
        let records = format!("20 12 -1 0 -1 1 2 1{cuboid}\n21 11 0 2 0 6{ball}\n22 -103 20 21");
        scene(&records, 22)
    };
    for cuboid in ["", " # cube #"] {
        let text = of(cuboid, "");
        let (finding, made) = guessed(&text, Code::W319);
        assert_eq!(made, [text.replace("20 21", "21 20")]);
        assert_eq!(is_choice(&finding), !cuboid.is_empty());
    }
    let smaller = [
        "if the subtracted object should be ten times smaller, write `0 2 0 0.6` for 21",
        "má-li být odečítaný objekt desetkrát menší, napsat `0 2 0 0.6` pro 21",
    ];
    for (cuboid, ball) in [
        (" # cube #", " # what is cut from it #"),
        (" # krychle #", " # díra #"),
    ] {
        let text = of(cuboid, ball);
        let (finding, made) = guessed(&text, Code::W319);
        let meant = [("0 2 0 6", "0 2 0 0.6"), ("20 21", "21 20")];
        assert_eq!(
            [Language::English, Language::Czech].map(|l| titles(&finding, l)[0].clone()),
            smaller
        );
        assert_eq!(made, meant.map(|(from, to)| text.replace(from, to)));
        assert!(is_choice(&finding));
        assert_eq!(fixed(&text), text);
    }
    // A tenth of it would lie apart.
    let text = of("", "").replace("0 2 0 6", "4 5 0 9");
    let (_, made) = guessed(&text, Code::W319);
    assert_eq!(made, [text.replace("20 21", "21 20")]);
    assert_eq!(fixed(&text), made[0]);
    let called = of(" # cube #", "").replace("0 2 0 6", "4 5 0 9");
    assert_eq!(fixed(&called), called);
}

/// A floor by its comment that stands across x holds the lamp.
#[test]
fn a_floor_across_x_holds_a_lamp() {
    let floor = |normal: &str, comment: &str| {
        format!(
            "20 11 2 1 0 1\n22 4 {normal} 0 # {comment} #\n23 -101 20 22\n9 -501 2 2 8 0 -0.2 -1 0 1 0 40\n\
             50 -402 0.3\n50 -1 -5 4 3\n1 9999 23 0\n"
        )
    };
    for comment in ["floor", "podlaha", "the table"] {
        let text = floor("1 0 0", comment);
        let (finding, made) = guessed(&text, Code::W326);
        assert_eq!(made[0], floor("0 1 0", comment));
        assert_eq!(
            [Language::English, Language::Czech].map(|l| titles(&finding, l)[0].clone()),
            [
                "lay the floor across the y axis: write `0 1 0`",
                "položit podlahu kolmo k ose y: napsat `0 1 0`"
            ]
        );
        assert_eq!(fixed(&text), floor("0 1 0", comment));
    }
    let (_, made) = guessed(&floor("1 0 0", "wall"), Code::W326);
    assert_eq!(made, [floor("1 0 0", "wall").replace("-5 4 3", "5 4 3")]);
}

/// A move with the ID of what has a place already, behind what has none.
#[test]
fn a_move_of_another_object_or_of_the_camera() {
    let ring =
        "20 11 -2 1 0 1\n21 14 0.75 0.25\n21 -2 90 1\n20 -1 2 1 0\n21 -701 1 0 0\n23 -101 20 21";
    let text = scene(ring, 23);
    let (_, made) = guessed(&text, Code::W336);
    assert_eq!(made, [text.replace("20 -1 2", "21 -1 2")]);
    let text = scene("20 11 0 1 0 1", 20).replace("50 -1 4", "9 -1 4");
    let (finding, made) = guessed(&text, Code::W336);
    assert_eq!(made, [text.replace("9 -1 4", "50 -1 4")]);
    assert_eq!(
        [Language::English, Language::Czech].map(|l| finding.wording(l).message),
        [
            "9 is moved here, and the point light 50 right above is not moved",
            "zde se posouvá 9 a bodové světlo 50 hned nad tím vůbec"
        ]
    );
    // The ring has its own place.
    let silent = scene(&ring.replace("21 -2", "21 -1 0 0 2\n21 -2"), 23);
    assert!(
        read(&silent)
            .findings()
            .iter()
            .all(|d| d.code != Code::W336)
    );
}

/// Balls on a floor are taken away from it, where a union is meant.
#[test]
fn a_cut_that_merely_touches() {
    let of = |ball: &str| {
        let balls = format!("20 11 -2 1 0 1\n21 11 {ball}\n22 4 0 1 0 0");
        scene(&format!("{balls}\n30 -101 22 20\n31 -103 30 21"), 31)
    };
    // On the floor, and beside the other ball at a distance of both radii.
    for ball in ["1.5 0.8 0 0.8", "0 1 0 1"] {
        let text = of(ball);
        let (finding, made) = guessed(&text, Code::W332);
        assert_eq!(made, [text.replace("31 -103", "31 -101")]);
        assert!(is_choice(&finding));
        assert_eq!(
            [Language::English, Language::Czech].map(|l| finding.wording(l).message),
            [
                "the difference 31 takes nothing away: the sphere 21 merely touches the union 30",
                "rozdíl 31 nic neubírá: koule 21 se jen dotýká objektu 30 (sjednocení)"
            ]
        );
    }
    // A dent in the floor, or in the ball.
    for ball in ["1.5 0.7 0 0.8", "-0.1 1 0 1"] {
        let all = read(&of(ball));
        assert!(all.findings().iter().all(|d| d.code != Code::W332));
    }
}

/// A scaling in per cent holds the camera.
#[test]
fn a_scaling_in_per_cent() {
    let text = scene("20 9 0.7\n20 -3 150 150 150", 20);
    let (finding, made) = guessed(&text, Code::W325);
    assert_eq!(made[0], text.replace("150 150 150", "1.5 1.5 1.5"));
    assert_eq!(
        [Language::English, Language::Czech].map(|l| titles(&finding, l)[0].clone()),
        [
            "if the factors of `20 -3 150 150 150` are in per cent, write `1.5 1.5 1.5`",
            "jsou-li čísla v `20 -3 150 150 150` procenta, napsat `1.5 1.5 1.5`"
        ]
    );
    assert_eq!(fixed(&text), text);
    for factors in ["150 150 1.5", "12.5 12.5 12.5", "10 10 100"] {
        let other = text.replace("150 150 150", factors);
        let all = read(&other);
        let titles = all.findings().iter().flat_map(|d| &d.fixes);
        assert!(titles.map(|f| f.title).all(|t| t != "fix-per-cent"));
    }
}

/// A camera whose place has lost or got a minus looks away from what is drawn.
#[test]
fn a_coordinate_of_the_place_with_another_sign() {
    let text = scene("20 11 0 1 0 1", 20).replace("0 2 8 0", "0 2 -8 0");
    let (finding, made) = guessed(&text, Code::W324);
    let meant = [("-0.2 -1", "-0.2 1"), ("-8", "8")];
    assert_eq!(made[..2], meant.map(|(from, to)| text.replace(from, to)));
    assert_eq!(
        titles(&finding, Language::Czech)[1],
        "změnit znaménko z kamery: napsat `0 2 8`"
    );
    assert_eq!(finding.fixes[1].applicability, Applicability::Choice);
}

/// A box that is moved and then turned about the origin, and a hole where it would be otherwise.
#[test]
fn a_hole_beside_what_is_turned_about_the_origin() {
    let of = |changes: &str| {
        let balls = "22 11 2.2 1.3 -0.2 0.5\n30 -103 21 22";
        scene(
            &format!("21 12 -0.6 0 -0.6 0.6 1.2 0.6\n{changes}\n{balls}"),
            30,
        )
    };
    let (moved, turned) = ("21 -1 2.2 0 -0.5", "21 -2 45 2");
    let text = of(&format!("{moved}\n{turned}"));
    let (finding, made) = guessed(&text, Code::W332);
    let meant = of(&format!("{turned}\n{moved}"));
    assert_eq!(made, std::slice::from_ref(&meant));
    assert!(is_choice(&finding));
    assert_eq!(
        [Language::English, Language::Czech].map(|l| titles(&finding, l)[0].clone()),
        [
            "swap the two lines: turn it first, then move it",
            "prohodit oba řádky: nejdřív otočit, potom posunout"
        ]
    );
    assert!(read(&meant).findings().iter().all(|d| d.code != Code::W332));
    // They do not meet in the other order either.
    let (finding, _) = guessed(&text.replace("2.2 0 -0.5", "5 0 -0.5"), Code::W332);
    assert_eq!(finding.fixes, []);
}

/// A leg of a table has lost a sign: the swap of its bounds would make a board of it.
#[test]
fn a_sign_that_makes_two_edges_equal() {
    let leg = |numbers: &str| {
        format!(
            "23 12 {numbers}\n9 -501 0 1 6 0 -0.1 -1 0 1 0 45\n50 -402 0.8\n50 -1 2 4 3\n1 9999 23 0\n"
        )
    };
    let text = leg("0.56 0 -0.36 -0.5 0.72 -0.3");
    let (_, made) = guessed(&text, Code::E202);
    assert_eq!(made[0], leg("-0.56 0 -0.36 -0.5 0.72 -0.3"));
    assert!(made.contains(&leg("-0.5 0 -0.36 0.56 0.72 -0.3")));
    assert_eq!(fixed(&text), text);
}

/// The overlap of two parts is of no matter where they are alike once their optics are in order.
#[test]
fn a_rewriting_that_nothing_needs() {
    let scene = |parts: &str| {
        format!(
            "2 12 -2 0 -2 2 1 2\n2 -202 {parts}\n3 14 1 0.2\n3 -1 0 1.1 0\n4 -101 2 3\n\
             9 -501 0 3 8 0 -0.3 -1 0 1 0 45\n50 -402 0.8\n50 -1 2 6 5\n1 9999 4 0\n"
        )
    };
    let by_kind = scene("0.5 0.5 0.5 0.4 0.4 0.4 0 0 0");
    assert_eq!(
        fixed(&by_kind).replace("  ", " "),
        scene("0.5 0.4 0 0.5 0.4 0 0.5 0.4 0")
    );
}

/// The points of a profile are a radius and a height each.
#[test]
fn points_of_a_profile_by_their_heights() {
    let text = |points: &str| {
        scene(
            &format!("10 1 2 40 0 40 10\n11 1 2 {points}\n2 -103 10 11"),
            2,
        )
    };
    let (finding, made) = guessed(&text("-1 15 40 15"), Code::E208);
    assert_eq!(made, [text("15 -1 15 40"), text("1 15 40 15")]);
    assert!(is_choice(&finding));
    // A negative height would be a radius.
    let (_, made) = guessed(&text("-15 -1 15 40"), Code::E208);
    assert_eq!(made, [text("15 -1 15 40")]);
}

/// A profile may have any number of negative radii: the exchange of all points is proposed once.
#[test]
fn many_negative_radii() {
    const POINTS: usize = 2000;
    let points: String = (0..POINTS).map(|y| format!(" -1 {y}")).collect();
    let text = scene(&format!("2 1 {POINTS}{points}"), 2);
    let all = read(&text);
    let found: Vec<&Diagnostic> = all
        .findings()
        .iter()
        .filter(|d| d.code == Code::E208)
        .collect();
    assert_eq!(found.len(), POINTS);
    let edits = |d: &&Diagnostic| d.fixes.iter().map(|f| f.edits.len()).sum::<usize>();
    assert_eq!(edits(&found[0]), 2 * POINTS + 1);
    assert!(found[1..].iter().all(|d| edits(d) == 1));
}
