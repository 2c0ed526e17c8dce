//! Slips in IDs, types and numbers that looked like something else: each first guess is what was meant, and no other
//! finding speaks of the line.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Language};

use super::{fixed, guessed, read};

/// A lamp and a camera.
const REST: &str = "50 -402 0.8\n50 -1 4 6 5\n90 -501 0 3 9 0 -0.25 -1 0 1 0 40\n";
/// A box and a ball in it, from which others are made.
const TWO: &str = "8 12 -1 0 -1 1 2 1\n9 11 0 2 0 0.9\n";

fn errors(text: &str) -> Vec<Diagnostic> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).collect()
}

/// The only error of a text, and the scene that each guess makes.
#[track_caller]
fn only(text: &str, code: Code) -> (Diagnostic, Vec<String>) {
    let codes: Vec<Code> = errors(text).iter().map(|d| d.code).collect();
    assert_eq!(codes, [code], "{text}");
    guessed(text, code)
}

/// A text with one slip, the code of its only error, and what is written in place of what.
struct Slip {
    text: String,
    code: Code,
    written: &'static str,
    meant: &'static str,
}

#[track_caller]
fn holds(slip: Slip) {
    let Slip {
        text,
        code,
        written,
        meant,
    } = slip;
    let (_, made) = only(&text, code);
    let right = text.replacen(written, meant, 1);
    assert_ne!(right, text);
    assert_eq!(made.first(), Some(&right));
    assert_eq!(fixed(&text), right);
    assert!(errors(&right).is_empty(), "{right}");
}

/// A letter or a point in an ID, whose object has properties below.
#[test]
fn ids_with_a_letter_or_a_point() {
    let properties = "10 -2 30 2\n10 -701 0.8 0.2 0.2\n";
    for written in ["1O", "1o"] {
        holds(Slip {
            text: format!("{TWO}{written} -103 8 9\n{properties}{REST}1 9999 10 0\n"),
            code: Code::E003,
            written,
            meant: "10",
        });
    }
    let ball = "1O 11 0 3 0 0.9\n10 -701 0.8 0.2 0.2\n11 -101 9 10\n";
    holds(Slip {
        text: format!("9 11 0 2 0 0.9\n{ball}{REST}1 9999 11 0\n"),
        code: Code::E003,
        written: "1O",
        meant: "10",
    });
    // Only the render record has the ID 1.
    holds(Slip {
        text: format!("{TWO}1.0 -103 8 9\n{REST}1 9999 10 0\n"),
        code: Code::E010,
        written: "1.0",
        meant: "10",
    });
    let render = format!("{TWO}{REST}1.0 9999 8 0\n");
    assert_eq!(
        only(&render, Code::E010).0.fixes[0].applicability,
        Applicability::Safe
    );
}

/// A record behind a sign as of Python's comments, whose properties stand below.
#[test]
fn a_record_behind_a_sign_of_other_languages() {
    let below = "10 -2 30 2\n10 -701 0.8 0.2 0.2\n10 -201 0.1 0.1 0.8\n";
    let text = format!("{TWO}#10 -103 8 9\n{below}{REST}1 9999 10 0\n");
    let (finding, made) = guessed(&text, Code::E103);
    assert_eq!(made, [text.replace('#', "")]);
    assert_eq!(finding.fixes[0].applicability, Applicability::Choice);
    let all = errors(&text);
    let guesses = all.iter().filter(|d| d.code != Code::E002);
    assert_eq!(guesses.map(|d| d.fixes.len()).sum::<usize>(), 1);
}

/// ID and type in each other's place, where the ID is a type, too, and the same in the render record.
#[test]
fn ids_and_types_swapped() {
    for id in ["20", "21", "24"] {
        let text = format!("11 {id} -2 1 0 0.9\n{id} -701 0.9 0.2 0.1\n{REST}1 9999 {id} 0\n");
        let (finding, made) = only(&text, Code::E005);
        assert_eq!(finding.case, "exchanged");
        assert_eq!(
            made,
            [text.replacen(&format!("11 {id}"), &format!("{id} 11"), 1)]
        );
    }
    // A sound hyperboloid stays.
    assert!(errors(&format!("11 20 1 1 1 1\n{REST}1 9999 11 0\n")).is_empty());
    let ball = "20 11 -2 1 0 1\n35 11 2 1 0 1\n36 -101 20 35\n12 -701 0.1 0.1 0.1\n";
    for (written, meant) in [
        ("1 20 9999 0", "1 9999 20 0"),
        ("1 36 9999 12", "1 9999 36 12"),
    ] {
        let text = format!("{ball}{REST}{written}\n");
        let (finding, made) = only(&text, Code::E005);
        assert_eq!(made, [text.replace(written, meant)]);
        for (language, said, guess) in [
            (
                Language::English,
                "the render record begins with `1 9999`; the ID of what is drawn follows",
                "write `",
            ),
            (
                Language::Czech,
                "renderovací záznam začíná `1 9999`; ID toho, co se vykreslí, stojí až za tím",
                "napsat `",
            ),
        ] {
            let words = finding.wording(language);
            assert_eq!(words.message, said);
            assert!(
                words.fixes[0].contains(&format!("{guess}{meant}`")),
                "{:?}",
                words.fixes
            );
        }
    }
    // A type behind its numbers.
    holds(Slip {
        text: format!(
            "20 9 1\n{}1 9999 20 0\n",
            REST.replace("-402 0.8", "0.8 -402")
        ),
        code: Code::E010,
        written: "0.8 -402",
        meant: "-402 0.8",
    });
}

/// The ID of the next object in a record of the one above.
#[test]
fn ids_of_the_next_object() {
    let next = "21 11 0 1 0 1\n21 -701 0.9 0.2 0.1\n30 -101 20 21\n";
    holds(Slip {
        text: format!(
            "20 14 0.8 0.25\n20 -2 90 1\n21 -1 -2 1.05 0\n20 -701 0.2 0.6 0.3\n{next}{REST}1 9999 30 0\n"
        ),
        code: Code::E107,
        written: "21 -1",
        meant: "20 -1",
    });
    let glass = |optics: &str, below: &str| {
        let two = format!("20 11 -2 1 0 1\n20 -201 {optics}\n21 -203 1.5 1.5 1.5\n");
        format!("{two}21 11 1 1 0 1\n{below}30 -101 20 21\n{REST}1 9999 30 0\n")
    };
    holds(Slip {
        text: glass("0.05 0.05 0.9", "21 -701 0.9 0.2 0.1\n"),
        code: Code::E102,
        written: "21 -203",
        meant: "20 -203",
    });
    // Both let light through, or neither: it is the one's with its ID.
    for text in [
        glass("0.05 0.05 0.9", "21 -201 0.1 0.1 0.8\n"),
        glass("0.8 0.2 0", ""),
    ] {
        let (_, made) = only(&text, Code::E102);
        assert!(
            made.iter()
                .all(|made| made.contains("\n21 11 1 1 0 1\n21 -203")),
            "{made:?}"
        );
    }
}

/// Spaces, points and ends of lines that are lost or stand beside their place.
#[test]
fn lost_spaces_and_points() {
    let balls = "20 11 -2 1 0 1\n21 110 1 0.2 1\n22 11 2 1 0 1\n30 -101 20 21\n31 -101 30 22\n";
    holds(Slip {
        text: format!("{balls}{REST}1 9999 31 0\n"),
        code: Code::E003,
        written: "110",
        meant: "11 0",
    });
    let ball = |line: &str| format!("20 11 -2 1 0 1\n{line}\n{REST}1 9999 20 0\n");
    holds(Slip {
        text: ball("20 -701 .9 .2. 1"),
        code: Code::E003,
        written: ".2. 1",
        meant: ".2 .1",
    });
    // No other number has a point, so the second one has none either.
    holds(Slip {
        text: ball("20 -1 1 .2. 1"),
        code: Code::E003,
        written: ".2.",
        meant: ".2",
    });
    let text = ball("20 -701 0.9 02. 0.1");
    assert_eq!(guessed(&text, Code::W301).1, [text.replace("02.", "0.2")]);
    for dash in ["-", "–"] {
        let text =
            format!("20 11 -2 1 0 1\n21 11 2 1 0 1\n30 -101 20{dash}21\n{REST}1 9999 30 0\n");
        let (_, made) = only(&text, Code::E003);
        assert_eq!(made, [text.replace(&format!("20{dash}21"), "20 21")]);
    }
    holds(Slip {
        text: format!(
            "20 11 -2 1 0 1\n20 -701 0.9 0.2 0.121 11 2 1 0 1\n30 -101 20 21\n{REST}1 9999 30 0\n"
        ),
        code: Code::E009,
        written: "0.121 11",
        meant: "0.1\n21 11",
    });
    // The second record lacks a number: which one, the next finding asks.
    let text = ball("20 -701 0.9 0.2 0.1 20 -201 0.7 0.3");
    let (finding, made) = only(&text, Code::E009);
    assert_eq!(made, [text.replace("0.1 20", "0.1\n20")]);
    assert_eq!(finding.fixes[0].applicability, Applicability::Choice);
    assert_eq!(only(&made[0], Code::E008).0.code, Code::E008);
}

/// Three numbers behind the type of a rotation: a lamp that nothing moved is moved, and so is what a comment says so of.
#[test]
fn rotations_that_are_moves() {
    let lamp = |line: &str| {
        let rest = REST.replace("50 -1 4 6 5", line);
        format!("20 11 -1 0 0 1\n{rest}1 9999 20 0\n")
    };
    let text = lamp("50 -2 -4 7 6");
    assert_eq!(only(&text, Code::E009).1, [text.replace("-2", "-1")]);
    assert_eq!(fixed(&text), text.replace("-2", "-1"));
    let turned = |text: &str, turns: &str| text.replace("20 -2 1 0.5 0", turns);
    let ball =
        |comment: &str| format!("20 12 -1 0 -1 1 1 1\n20 -2 1 0.5 0{comment}\n{REST}1 9999 20 0\n");
    for comment in ["", " # moved #", " # posunutá koule #"] {
        let text = ball(comment);
        let (finding, made) = only(&text, Code::E009);
        let turns = turned(&text, "20 -2 1 1\n20 -2 0.5 2");
        assert_eq!(made, [text.replace("20 -2", "20 -1"), turns]);
        let is_told = finding.fixes[0].applicability == Applicability::Unsafe;
        assert_eq!(is_told, !comment.is_empty());
    }
    // Angles as people write them.
    for angles in ["30 0 45", "15 0 0", "-90 20 0"] {
        let text = ball("").replace("1 0.5 0", angles);
        let (_, made) = only(&text, Code::E009);
        assert!(
            made.iter().all(|made| made.contains("\n20 -2 ")),
            "{made:?}"
        );
    }
}

/// A 0 too many behind the numbers of a record, before a comment: no safe fix makes a record of it, and what is certain
/// elsewhere is mended.
#[test]
fn a_zero_too_many_is_no_record() {
    let safely = |text: &str| {
        let mended = fixing::to_fixed_point(read(text), false, Analysis::of);
        (mended.analysis.source.text, mended.count)
    };
    let cube = "2 12 -1 0 -1 1 2 1 # krychle #\n";
    for (record, meant) in [
        ("2 -2 0 45 0   # otočit okolo y #", "45 2 "),
        ("2 -2 0 20 0 # about y #", "20 2 "),
    ] {
        let whole = format!("{cube}{record}\n3 9 0.5\n9 -101 2 3\n{REST}1 9999 9 0\n");
        let (_, made) = only(&whole, Code::E009);
        let wrong = record.split(" #").next().unwrap().trim_end();
        let right = whole.replace(wrong, &format!("2 -2 {}", meant.trim_end()));
        assert_eq!(made, [right]);
        assert_eq!(safely(&whole), (whole.clone(), 0));
        let text = whole.replace("0.5", "0,5");
        assert_eq!(safely(&text), (whole, 1));
    }
    for comment in ["koule", "ball"] {
        let ball = format!("21 11 -2 1 0 1 0 # {comment} #\n");
        let whole = format!("{ball}3 9 0.5\n9 -101 21 3\n{REST}1 9999 9 0\n");
        assert_eq!(safely(&whole), (whole.clone(), 0));
        let text = whole.replace("0.5", "0,5");
        let codes: Vec<Code> = errors(&text).iter().map(|d| d.code).collect();
        assert_eq!(codes, [Code::E009, Code::E003]);
        assert_eq!(safely(&text), (whole, 1));
    }
}

/// A shape whose type has lost a digit, which reads as a profile with a wrong number of points: a comment names it.
#[test]
fn shapes_that_lost_a_digit() {
    let ball = ["koule", "koule vlevo", "a ball", "sphere"];
    let ring = ["torus", "prsten", "ring", "a torus"];
    let cuboid = ["krychle", "kostka", "box", "cube"];
    let cone = ["kužel", "cone", "a cone", "modrý kužel"];
    for (numbers, meant, comments) in [
        ("1 0 1 0 1", "11", ball),
        ("1 -2 1 0 1", "11", ball),
        ("1 0.6 0.2", "14", ring),
        ("1 1 0.3", "14", ring),
        ("1 -1 0 -1 1 2 1", "12", cuboid),
        ("2 -1 0 -1 1 2 1", "12", cuboid),
        ("1 2 0.5", "16", cone),
    ] {
        for comment in comments {
            let text = format!("21 {numbers} # {comment} #\n{REST}1 9999 21 0\n");
            let all = errors(&text);
            assert_eq!(all.len(), 1, "{text}");
            let behind = numbers.split_once(' ').unwrap().1;
            let right = text.replacen(numbers, &format!("{meant} {behind}"), 1);
            assert_eq!(guessed(&text, all[0].code).1, std::slice::from_ref(&right));
            assert_eq!(fixed(&text), right);
        }
    }
    for comment in ["válec", "a cylinder"] {
        let text = format!("21 1 1 2 # {comment} #\n{REST}1 9999 21 0\n");
        let right = text.replacen("1 1 2", "1 2 1 0 1 2", 1);
        assert_eq!(guessed(&text, Code::E206).1.first(), Some(&right));
    }
    // The profile of one is none.
    for comment in ["profil koule", "profile of a ball"] {
        let text = format!("21 1 0 1 1 2 # {comment} #\n{REST}1 9999 21 0\n");
        let (_, made) = guessed(&text, errors(&text)[0].code);
        assert!(made.contains(&text.replacen("1 0 1 1", "1 2 0 1 1", 1)));
        assert!(made.iter().all(|made| !made.starts_with("21 11 ")));
    }
}

/// A box by three numbers and an edge: a comment says whether they are its corner or its centre.
#[test]
fn cubes_by_a_corner_or_a_centre() {
    let cube = |comment: &str| format!("2 12 0 0 0 2{comment}\n{REST}1 9999 2 0\n");
    let [corner, centre] = ["0 0 0 2 2 2", "-1 -1 -1 1 1 1"];
    for (comment, meant) in [
        (" # krychle, roh v počátku, hrana 2 #", &[corner][..]),
        (" # cube, corner at the origin, edge 2 #", &[corner]),
        (" # krychle se středem v počátku #", &[centre]),
        (" # cube about the centre #", &[centre]),
        (" # krychle #", &[centre, corner]),
        (" # cube #", &[centre, corner]),
    ] {
        let text = cube(comment);
        let with = |numbers: &&str| text.replace("0 0 0 2", numbers);
        let right: Vec<String> = meant.iter().map(with).collect();
        assert_eq!(only(&text, Code::E008).1, right);
        let is_told = meant.len() == 1;
        assert_eq!(fixed(&text), if is_told { right[0].clone() } else { text });
    }
}

/// A quadric takes sixteen numbers: with the type of one, a torus, a box or a ball would take the next records for its
/// rows.
#[test]
fn quadrics_that_are_other_shapes() {
    let ring = "15 -2 60 1\n15 -1 0 0.8 0.8\n15 -701 0.9 0.2 0.1";
    let cuboid = "15 -1 0 0.8 0.8\n15 -701 0.9 0.2 0.1";
    let ball = "15 -1 0 0.8 0.8\n15 -701 0.9 0.2 0.1\n15 -201 0.1 0.8 0";
    for (numbers, behind, comment, meant) in [
        ("0.6 0.2", ring, "ring", "14"),
        ("0.6 0.2", ring, "prsten", "14"),
        ("-1 0 -1 1 1.2 1", cuboid, "box", "12"),
        ("-1 0 -1 1 1.2 1", cuboid, "krychle", "12"),
        ("0 1 0 1", cuboid, "ball", "11"),
        ("0.8", ball, "", ""),
    ] {
        let text = format!("15 15 {numbers} # {comment} #\n{behind}\n{REST}1 9999 15 0\n");
        let (finding, made) = only(&text, Code::E008);
        assert_eq!(read(&text).source.position(finding.span.start).line, 1);
        if meant.is_empty() {
            assert!(made.is_empty(), "{made:?}");
            assert_eq!(fixed(&text), text);
            continue;
        }
        let right = text.replacen("15 15", &format!("15 {meant}"), 1);
        assert_eq!(made, std::slice::from_ref(&right));
        assert_eq!(fixed(&text), right);
    }
    // Rows that begin with the same number are rows where they are no records of the object.
    let rows = "15 15 1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 -1\n15 -1 0 1 0";
    let text = format!("{rows}\n{REST}1 9999 15 0\n");
    assert_eq!(repair::proposals(&read(&text)), []);
}

/// The cone goes down, which a double cone cannot.
#[test]
fn double_cones_that_are_cones() {
    let text = |comment: &str| format!("15 17 -1.5 0.5 # {comment} #\n{REST}1 9999 15 0\n");
    for (comment, is_cone) in [
        ("cone, apex up", true),
        ("kužel", true),
        ("double cone", false),
        ("dvojitý kužel", false),
        ("hat", false),
    ] {
        let text = text(comment);
        let (_, made) = only(&text, Code::E201);
        let cone = text.replacen("15 17", "15 16", 1);
        assert_eq!(made.contains(&cone), is_cone, "{text}");
    }
}

#[test]
fn pictures_behind_another_texture() {
    for written in ["-302", "-399"] {
        let slip = Slip {
            text: format!("8 12 -1 0 -1 1 2 1\n8 {written} wood.png\n{REST}1 9999 8 0\n"),
            code: Code::E012,
            written,
            meant: "-301",
        };
        let (_, made) = only(&slip.text, slip.code);
        let right = slip.text.replacen(slip.written, slip.meant, 1);
        assert_eq!(made.first(), Some(&right));
    }
}

/// A digit of the ID is lost, and the ID that is left is the render record's.
#[test]
fn properties_with_the_id_1() {
    for property in ["-701 0.9 0.2 0.1", "-1 0 1 0", "-201 0.1 0.8 0"] {
        let lines = format!("15 11 0 1 0 1 # ball #\n1 {property}");
        let text = format!("2 4 0 1 0 0\n{lines}\n4 -101 2 15\n{REST}1 9999 4 0\n");
        let (_, made) = only(&text, Code::E105);
        let right = text.replacen("\n1 -", "\n15 -", 1);
        assert_eq!(made.first(), Some(&right));
        assert_eq!(fixed(&text), right);
    }
    // What has that property already is not meant.
    let text = format!("15 11 0 1 0 1\n15 -701 1 0 0\n1 -701 0.9 0.2 0.1\n{REST}1 9999 15 0\n");
    let (_, made) = only(&text, Code::E105);
    assert!(made.first().unwrap().contains("\n91 -701 0.9 0.2 0.1\n"));
}

/// The last numbers of a union of many may be read as a torus; nothing is said of the objects that are left over then.
#[test]
fn unions_of_many_are_one_mistake() {
    for last in [13, 14, 15, 16, 17] {
        let ids = (12..=last).map(|id| id.to_string()).collect::<Vec<_>>();
        let balls: String = (ids.iter().enumerate())
            .map(|(i, id)| format!("{id} 11 {} 1 0 1\n", 2 * i))
            .collect();
        let text = format!(
            "2 4 0 1 0 0\n{balls}20 -101 2 {}\n{REST}1 9999 20 0\n",
            ids.join(" ")
        );
        let all = repair::proposals(&read(&text));
        let codes: Vec<Code> = all.iter().map(|d| d.code).collect();
        assert_eq!(codes, [Code::E009], "{text}");
        assert!(errors(&fixed(&text)).is_empty());
    }
}

/// The space between the type of a profile and its number of points is lost, and `12` is the type of a box.
#[test]
fn profiles_that_are_boxes() {
    let disc = "10 1 2 40 0 40 10\n";
    for (above, numbers, comment) in [
        (disc, "15 -1 15 40", "bore, radius 15"),
        ("", "1 0 1 2", "cylinder, radius 1, height 2"),
        ("", "1 0 1 2", "válec"),
    ] {
        let of = |head: &str| {
            let drawn = match above {
                "" => 11,
                _ => 14,
            };
            let cut = if above.is_empty() {
                ""
            } else {
                "14 -103 10 11\n"
            };
            format!("{above}11 {head} {numbers} # {comment} #\n{cut}{REST}1 9999 {drawn} 0\n")
        };
        let (_, made) = only(&of("12"), Code::E003);
        assert_eq!(made.first(), Some(&of("1 2")));
    }
    let cube = format!("11 12 1 0 1 2 # cube #\n{REST}1 9999 11 0\n");
    let (_, made) = only(&cube, Code::E008);
    assert!(made.iter().all(|made| !made.contains("11 1 2 ")));
}
