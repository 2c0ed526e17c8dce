//! IDs in the places of others in assignments, records without a type before a 0, lists of objects to be drawn.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Diagnostic, Language};

use super::read;

/// A lamp and a camera.
const VIEW: &str = "40 -501 0 2 14  0 -0.1 -1  0 1 0  40\n41 -402 0.8\n41 -1 5 8 6\n";

fn scene(lines: &str, drawn: &str) -> String {
    format!("{lines}\n{VIEW}1 9999 {drawn}\n")
}

fn mended(text: &str) -> String {
    let mended = fixing::to_fixed_point(read(text), true, Analysis::of);
    mended.analysis.source.text
}

fn only(text: &str) -> Diagnostic {
    let all = repair::proposals(&read(text));
    let [one] = &all[..] else {
        panic!("{all:?}\n{text}");
    };
    one.clone()
}

/// Each kind of thing that an assignment names has one place; its ID is another one's, or missing.
#[test]
fn assignments_with_ids_in_other_places() {
    let (ball, colour, optics) = ("2 9 1", "35 -701 1 0 0", "36 -201 0.3 0.5 0.1");
    for (properties, line, meant, code) in [
        (colour, "35 -299 35 2", "2 -299 35 0", Code::E103),
        (colour, "35 -299 0 2", "2 -299 35 0", Code::E103),
        (optics, "36 -299 2 36", "2 -299 0 36", Code::E103),
        (optics, "-299 2 36", "2 -299 0 36", Code::E005),
        (optics, "-299 36 2", "2 -299 0 36", Code::E005),
        (colour, "-299 2 35", "2 -299 35 0", Code::E005),
    ] {
        let with = |line: &str| scene(&[ball, properties, line].join("\n"), "2 0");
        let finding = only(&with(line));
        assert_eq!((finding.code, finding.fixes.len()), (code, 1), "{line}");
        assert_eq!(mended(&with(line)), with(meant), "{line}");
    }
    // All three, in no place of their own.
    let with = |line: &str| scene(&[ball, colour, optics, line].join("\n"), "2 0");
    assert_eq!(mended(&with("36 -299 2 35")), with("2 -299 35 36"));
    // The object is missing: it is the one that has none of them.
    assert_eq!(mended(&with("-299 35 36")), with("2 -299 35 36"));
    assert_eq!(mended(&with("-299 0 36")), with("2 -299 0 36"));
    let lines = [ball, optics, "2 -299 0 36", colour, "-299 35 36"];
    let finding = only(&scene(&lines.join("\n"), "2 0"));
    assert_eq!((finding.code, finding.fixes.len()), (Code::E005, 0));
    let said = [Language::English, Language::Czech].map(|l| finding.wording(l).notes[0].clone());
    let meant = [
        "ID is that of the object, T that of its texture or colour, and O that of its optical property; 0 means none",
        "ID je ID objektu, T jeho textury nebo barvy a O jeho optické vlastnosti; 0 znamená žádnou",
    ];
    assert_eq!(said, meant);
    let lines = [ball, "3 11 4 0 0 1", "4 -101 2 3", colour, "-299 35 0"];
    assert_eq!(only(&scene(&lines.join("\n"), "4 0")).fixes.len(), 2);
}

/// The first number is 0, or 1 before a 0: a comment may say which type is missing.
#[test]
fn types_that_are_missing_before_a_zero() {
    for (line, meant, guesses) in [
        (
            "3  0 1.6 0  0.7  # koule #",
            "3 11  0 1.6 0  0.7  # koule #",
            1,
        ),
        (
            "3 0 1.6 0 0.7 # the ball #",
            "3 11 0 1.6 0 0.7 # the ball #",
            1,
        ),
        ("3 0 1.6 0 0.7", "3 11 0 1.6 0 0.7", 2),
        ("3 0 0 0 1 1 1 # kvádr #", "3 12 0 0 0 1 1 1 # kvádr #", 1),
        ("3 0 0 0 1 1 1", "3 12 0 0 0 1 1 1", 1),
    ] {
        let with = |line: &str| scene(line, "3 0");
        let finding = only(&with(line));
        assert_eq!((finding.code, finding.case), (Code::E006, "lost"), "{line}");
        assert_eq!(finding.fixes.len(), guesses, "{line}");
        assert_eq!(mended(&with(line)), with(meant), "{line}");
    }
    for name in ["# červená #", "# red #", ""] {
        let with = |line: &str| scene(&format!("2 9 1\n{line} {name}\n2 -299 3 0"), "2 0");
        for (line, meant) in [("3 1 0 0", "3 -701 1 0 0"), ("3 0 0.2 1", "3 -701 0 0.2 1")] {
            let finding = only(&with(line));
            assert_eq!((finding.code, finding.case), (Code::E006, "lost"), "{line}");
            assert_eq!(mended(&with(line)), with(meant), "{line} {name}");
        }
    }
    // A number too many in an undefined object has no type.
    assert!(only(&scene("2 9 1\n3 0 1.5", "2 0")).code == Code::E009);
}

/// The render record draws one object: of a list it is the union.
#[test]
fn a_list_of_objects_to_be_drawn() {
    let balls = |count: i32| {
        let balls = (0..count).map(|i| format!("{} 11 {} 0 0 1\n", 2 + i, 3 * i - 9));
        balls.collect::<String>() + "39 -701 0 0 0.1"
    };
    for (count, list, meant) in [
        (2, "2 3 0", "42 -101 2 3\n1 9999 42 0\n"),
        (2, "2 3 39", "42 -101 2 3\n1 9999 42 39\n"),
        (3, "2 3 4 0", "42 -101 2 3\n43 -101 42 4\n1 9999 43 0\n"),
        (3, "2 3 4", "42 -101 2 3\n43 -101 42 4\n1 9999 43 0\n"),
        (
            6,
            "2 3 4 5 6 7 0",
            "42 -101 2 3\n43 -101 42 4\n44 -101 43 5\n45 -101 44 6\n46 -101 45 7\n1 9999 46 0\n",
        ),
    ] {
        let text = scene(&balls(count), list);
        let meant = format!("{}\n{VIEW}{meant}", balls(count));
        let of_record = |d: &Diagnostic| matches!(d.code, Code::E008 | Code::E009);
        assert!(
            repair::proposals(&read(&text)).iter().any(of_record),
            "{list}"
        );
        assert_eq!(mended(&text), meant, "{list}");
    }
    // An object that stands there twice, or is none, is no part of a list.
    for list in ["2 3 2 0", "2 39 3 0", "2 3 99 0"] {
        let all = repair::proposals(&read(&scene(&balls(2), list)));
        let mut fixes = all.iter().flat_map(|d| &d.fixes);
        assert!(fixes.all(|fix| fix.title != "fix-parts"), "{list}");
    }
}

/// What overrides, covers or hides a property is named in both languages.
#[test]
fn what_leaves_a_property_without_effect() {
    let glass = "2 11 0 1 0 1\n2 -201 0.05 0.1 0.85\n2 -203 1.5 1.5 1.5\n";
    let mirror = "2 11 0 0 0 1\n2 -201 0 0.9 0\n2 -701 1 0 0\n3 4 0 1 0 1\n4 -101 2 3";
    let copy = "2 11 0 0 0 1\n2 -701 0 1 0\n3 -105 2\n3 -701 1 0 0\n4 -101 2 3";
    let covered = format!("{glass}3 4 0 1 0 0\n4 -101 2 3\n4 -201 0.5 0.5 0");
    for (lines, code, case, english, czech) in [
        (
            &*covered,
            Code::W318,
            "covered",
            "remove `4 -201`",
            "odstraňte `4 -201`",
        ),
        (
            mirror,
            Code::W331,
            "dark-colour",
            "remove the colour",
            "barvu odstraňte",
        ),
        (
            copy,
            Code::W333,
            "painted",
            "only one of the two can be seen",
            "vidět může být jen jeden",
        ),
    ] {
        let finding = only(&scene(lines, "4 0"));
        assert_eq!((finding.code, finding.case), (code, case));
        for (language, words) in [(Language::English, english), (Language::Czech, czech)] {
            let help = finding.wording(language).help.unwrap_or_default();
            assert!(help.contains(words), "{help}");
        }
    }
}
