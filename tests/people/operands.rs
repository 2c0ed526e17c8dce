//! Operands and IDs that are wrong while another object is used by nothing.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Applicability, Code, Language, fixes};

use super::{fixed, guessed, read};

/// A camera and a lamp.
const REST: &str = "40 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n";

fn scene(text: &str) -> String {
    let drawn = text.lines().last().and_then(|l| l.split(' ').next());
    format!("{text}{REST}1 9999 {} 0\n", drawn.unwrap())
}

/// What is written, what is said of it, and what was meant. All lines but some at the end are the same.
const MEANT: &[(&str, Code, &str)] = &[
    // A union of a chain is lost.
    (
        "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 11 4 1 0 1\n20 -101 2 3\n22 -101 21 5\n",
        Code::E101,
        "2 11 -2 1 0 1\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 11 4 1 0 1\n20 -101 2 3\n21 -101 20 4\n22 -101 21 5\n",
    ),
    // One object as both operands of a difference.
    (
        "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n4 -103 2 2\n",
        Code::W319,
        "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n4 -103 2 3\n",
    ),
    // A copy with both IDs in each other's place.
    (
        "2 11 0 1 0 1\n2 -105 3\n3 -1 2.5 0 0\n4 -101 2 3\n",
        Code::E102,
        "2 11 0 1 0 1\n3 -105 2\n3 -1 2.5 0 0\n4 -101 2 3\n",
    ),
    // An ID that has lost a digit on all lines but the first.
    (
        "2 11 0 1 0 1\n19 16 -1.2 0.5\n9 -1 0.5 1.2 0.4\n9 -701 0.95 0.7 0.1\n20 -101 2 19\n",
        Code::E103,
        "2 11 0 1 0 1\n19 16 -1.2 0.5\n19 -1 0.5 1.2 0.4\n19 -701 0.95 0.7 0.1\n20 -101 2 19\n",
    ),
];

#[test]
fn what_was_meant_comes_first() {
    for (text, code, meant) in MEANT {
        let (finding, made) = guessed(&scene(text), *code);
        assert_eq!(made.first(), Some(&scene(meant)), "{finding:?}");
        assert_eq!(fixed(&scene(text)), scene(meant));
    }
    let (finding, _) = guessed(&scene(MEANT[3].0), Code::E103);
    for (language, said) in [
        (Language::English, "write `19` in all 2 records"),
        (Language::Czech, "napsat `19` ve všech 2 záznamech"),
    ] {
        assert_eq!(finding.wording(language).fixes[0], said);
    }
}

/// What is defined below may have been meant, and so may an object above that nothing uses.
#[test]
fn an_operand_below_or_an_unused_one() {
    let text = "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n4 -103 2 6\n6 11 3 1 0 1\n7 -101 4 6\n";
    let (finding, made) = guessed(&scene(text), Code::E107);
    let up = "2 12 -1 0 -1 1 2 1\n3 11 0 1 1 0.7\n6 11 3 1 0 1\n4 -103 2 6\n7 -101 4 6\n";
    assert_eq!(
        made,
        [scene(up), scene(&text.replace("4 -103 2 6", "4 -103 2 3"))]
    );
    assert!((finding.fixes.iter()).all(|f| f.applicability == Applicability::Choice));
    assert_eq!(fixed(&scene(text)), scene(text));
    // Nothing else would be left of it, or there is nothing that is not used.
    for text in [
        text.replace("7 -101 4 6", "7 -101 4 3"),
        text.replace("7 -101 4 6", "7 -101 4 6\n8 -101 7 3"),
    ] {
        let (_, made) = guessed(&scene(&text), Code::E107);
        assert_eq!(made.len(), 1);
        assert!(!fixed(&scene(&text)).contains("4 -103 2 3"));
    }
}

/// A lamp that is a copy has no intensity to be written otherwise.
#[test]
fn a_lamp_copied_and_not_moved() {
    let text = scene("2 11 0 1 0 1\n").replace("1 9999", "51 -105 50\n1 9999");
    let all = repair::proposals(&read(&text));
    assert!(all.iter().all(|d| d.fixes.is_empty()), "{all:?}");
    assert!(all.iter().any(|d| d.code == Code::W333), "{all:?}");
    let moved = text.replace("51 -105 50\n", "51 -105 50\n51 -1 -8 0 0\n");
    let all = repair::proposals(&read(&moved));
    assert!(all.iter().all(|d| d.code != Code::W333), "{all:?}");
}

/// A ∩ −B, as it stands on paper: the minus is no complement, so it is a difference, and never A ∩ B.
#[test]
fn a_complement_with_a_minus() {
    let with = |line: &str| scene(&format!("2 12 -1 -1 -1 1 1 1\n3 11 1 1 1 0.9\n{line}\n"));
    for (written, meant) in [("4 -102 2 -3", "4 -103 2 3"), ("4 -102 -2 3", "4 -103 3 2")] {
        let (finding, made) = guessed(&with(written), Code::E101);
        assert_eq!(made, [with(meant)]);
        assert_eq!(fixed(&with(written)), with(meant));
        let id = &meant[meant.len() - 1..];
        let two = &meant[2..];
        for (language, said) in [
            (
                Language::English,
                format!(
                    "a minus does not mean the complement here; the intersection with the complement of {id} is a difference: write `{two}`"
                ),
            ),
            (
                Language::Czech,
                format!(
                    "minus zde není doplněk; průnik s doplňkem objektu {id} je rozdíl: napsat `{two}`"
                ),
            ),
        ] {
            assert_eq!(finding.wording(language).fixes[0], said);
        }
    }
    // An intersection of two complements is no difference.
    assert_eq!(fixed(&with("4 -102 -2 -3")), with("4 -102 -2 -3"));
    // What a difference takes away may have a minus too many.
    assert_eq!(fixed(&with("4 -103 2 -3")), with("4 -103 2 3"));
}

/// A light among the operands of a union shines by itself, wherever its records stand.
#[test]
fn a_light_in_a_union() {
    let lamp = "51 -402 0.9\n51 -1 -4 8 6\n";
    let (ball, union) = ("2 11 0 1 0 1\n", "3 -101 2 51\n");
    let changes = "3 -701 1 0 0\n4 11 3 1 0 1\n5 -101 4 3\n";
    let meant = scene(&format!("{ball}{lamp}{}", changes.replace('3', "2")));
    let meant = meant.replace("4 11 2 1", "4 11 3 1");
    for text in [
        format!("{ball}{union}{lamp}{changes}"),
        format!("{ball}{lamp}{union}{changes}"),
    ] {
        let text = scene(&text);
        let (finding, made) = guessed(&text, Code::E103);
        assert_eq!(made, [meant.as_str()]);
        assert_eq!(fixed(&text), meant);
        for (language, said, noted) in [
            (
                Language::English,
                "leave out the union 3, and write `2` in its place",
                "a light shines by itself; it is not part of an object",
            ),
            (
                Language::Czech,
                "vynechat sjednocení 3 a místo něj napsat `2`",
                "bodové světlo svítí samo; není částí tělesa",
            ),
        ] {
            let wording = finding.wording(language);
            assert_eq!(wording.fixes, [said]);
            assert_eq!(wording.notes, [noted]);
        }
    }
    // An object that nothing uses may be meant in place of the light.
    let text = scene(&format!("{ball}6 11 3 1 0 1\n{lamp}{union}{changes}"));
    let (finding, made) = guessed(&text, Code::E103);
    assert_eq!(made.len(), 1);
    assert_eq!(finding.fixes[0].applicability, Applicability::Choice);
    assert_eq!(fixed(&text), text);
}

/// A colour that comes too late for a texture may be that of the object right above.
#[test]
fn a_late_colour_under_an_object() {
    let text = scene(
        "60 -701 0.1 0.1 0.1\n61 -701 0.9 0.9 0.9\n10 5 -4 -4 4 4\n10 -399 8 8 60 61\n\
         23 12 1 0 -1 3 2 1\n60 -701 1 0.5 0\n4 -101 23 10\n",
    );
    let late = |text: &str| {
        let all = read(text).findings().to_vec();
        all.into_iter().find(|d| d.code == Code::W309).unwrap()
    };
    let finding = late(&text);
    let made = fixes::apply(&text, finding.fixes.iter()).0;
    assert_eq!(made, text.replace("60 -701 1 0.5 0", "23 -701 1 0.5 0"));
    assert_eq!(finding.fixes[0].applicability, Applicability::Choice);
    for (language, said) in [
        (
            Language::English,
            "if it is meant for the object right above, write `23`",
        ),
        (
            Language::Czech,
            "patří-li objektu hned nad ním, napsat `23`",
        ),
    ] {
        assert_eq!(finding.wording(language).fixes, [said]);
    }
    // That object has a colour.
    let text = text.replace("60 -701 1 0.5", "23 -701 1 1 1\n60 -701 1 0.5");
    assert_eq!(late(&text).fixes, []);
}

/// An unused property is told with the line that assigns it.
#[test]
fn an_unused_property_has_its_assignment_said() {
    for (unused, said) in [
        ("32 -701 1 0 0", "`ID -299 32 0`"),
        ("32 -201 0 0.8 0.2", "`ID -299 0 32`"),
    ] {
        let text = scene(&format!("{unused}\n2 11 0 1 0 1\n"));
        let all = read(&text).findings().to_vec();
        let finding = all.into_iter().find(|d| d.code == Code::W310).unwrap();
        for language in [Language::English, Language::Czech] {
            let help = finding.wording(language).help.unwrap();
            assert!(help.contains(said), "{help}");
        }
    }
}

/// A change that comes too late for an operation, in the place of that of the object right above.
#[test]
fn a_late_change_under_an_object() {
    let text = |changes: &str| {
        scene(&format!(
            "2 12 -1 0 -1 1 2 1\n3 11 1 2 1 0.8\n4 -103 2 3\n5 14 0.8 0.2\n{changes}6 -101 4 5\n"
        ))
    };
    for (written, meant, is_sure) in [
        (
            "2 -1 -2 0.2 0\n5 -701 0.9 0.2 0.1\n",
            "5 -1 -2 0.2 0\n5 -701 0.9 0.2 0.1\n",
            true,
        ),
        (
            "5 -1 -2 0.2 0\n2 -701 0.9 0.2 0.1\n",
            "5 -1 -2 0.2 0\n5 -701 0.9 0.2 0.1\n",
            false,
        ),
    ] {
        let (finding, made) = guessed(&text(written), Code::W309);
        assert_eq!(made, [text(meant)]);
        let said = [Language::English, Language::Czech].map(|l| finding.wording(l).fixes);
        assert_eq!(
            said[0],
            ["if it is meant for the object right above, write `5`"]
        );
        assert_eq!(said[1], ["patří-li objektu hned nad ním, napsat `5`"]);
        assert_eq!(fixed(&text(written)) == text(meant), is_sure);
    }
    // The difference itself is right above, or has a move of its own.
    for changes in [
        "5 -1 -2 0 0\n2 -1 -2 0.2 0\n",
        "5 -1 -2 0 0\n5 -701 1 0 0\n2 -1 -2 0.2 0\n",
    ] {
        let (finding, _) = guessed(&text(changes), Code::W309);
        assert_eq!(finding.fixes, [], "{changes}");
    }
}
