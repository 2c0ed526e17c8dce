//! What a comment says of a record, and the record says otherwise.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Code, Language, fixes};

use super::{fixed, guessed, read};

const REST: &str = "50 -402 0.9\n50 -1 4 6 5\n9 -501 0 2 9 0 -0.2 -1 0 1 0 50\n1 9999 2 0\n";

fn scene(records: &str) -> String {
    format!("{records}\n{REST}")
}

/// Bounds that a comment calls a centre or a corner and a size, and the first guess.
const SIZES: &[(&str, Code, &str)] = &[
    (
        "2 12 2 1 0 2 2 2 # kostka se středem 2 1 0 a hranou 2 #",
        Code::W305,
        "2 12 1 0 -1 3 2 1 # kostka se středem 2 1 0 a hranou 2 #",
    ),
    (
        "0 # box, size 2, center 2 1 0 #\n2 12 2 1 0 2 2 2",
        Code::W305,
        "0 # box, size 2, center 2 1 0 #\n2 12 1 0 -1 3 2 1",
    ),
    (
        "2 12 2 1 0 1 2 2 # centre and edges #",
        Code::E202,
        "2 12 1.5 0 -1 2.5 2 1 # centre and edges #",
    ),
    (
        "2 12 2 1 0 2 2 2 # centre, half size #",
        Code::W305,
        "2 12 0 -1 -2 4 3 2 # centre, half size #",
    ),
    (
        "2 12 2 1 0 2 2 2 # střed a poloviční hrana #",
        Code::W305,
        "2 12 0 -1 -2 4 3 2 # střed a poloviční hrana #",
    ),
    (
        "2 12 2 1 0 2 2 2 # roh a velikost #",
        Code::W305,
        "2 12 2 1 0 4 3 2 # roh a velikost #",
    ),
    (
        "2 5 2 1 2 2 # centre and size #",
        Code::W305,
        "2 5 1 0 3 2 # centre and size #",
    ),
];

#[test]
fn a_centre_and_a_size_by_a_comment() {
    for (written, code, meant) in SIZES {
        let (finding, made) = guessed(&scene(written), *code);
        assert_eq!(made[0], scene(meant), "{written}");
        assert_eq!(fixed(&scene(written)), scene(meant), "{written}");
        for language in [Language::English, Language::Czech] {
            assert_eq!(finding.wording(language).fixes.len(), made.len());
        }
    }
}

/// Without a comment a lost minus comes first, and nothing is taken without being asked. A prism is no edge.
#[test]
fn a_centre_and_a_size_without_a_comment() {
    for comment in ["", " # hranol #", " # in the centre of the room #"] {
        let text = scene(&format!("2 12 2 1 0 2 2 2{comment}"));
        let (finding, made) = guessed(&text, Code::W305);
        let at = usize::from(!comment.contains("centre"));
        assert_eq!(made[at], text.replace("2 1 0 2 2 2", "1 0 -1 3 2 1"));
        assert!(made.contains(&text.replace("12 2 1", "12 -2 1")));
        assert_eq!(fixed(&text), text);
        let said = finding.wording(Language::Czech).fixes;
        assert_eq!(
            said[at],
            "je-li `2 1 0` střed a `2 2 2` velikost, napsat `1 0 -1 3 2 1`"
        );
    }
    // Nothing has a size of 0.
    let flat = read(&scene("2 12 -1 0 -1 1 0 1 # centre and size #"));
    assert!(flat.findings().iter().all(|d| d.fixes.is_empty()));
}

/// A box 13 and a ball 14, with comments, and their difference.
fn cut(comments: [&str; 3], operands: &str) -> String {
    let [cuboid, ball, difference] = comments;
    scene(&format!(
        "13 12 -1 -1 -1 1 1 1{cuboid}\n14 11 1 1 1 0.8{ball}\n2 -103 {operands}{difference}"
    ))
}

/// Comments of the box, the ball and the difference, by which the box remains.
const REVERSED: &[[&str; 3]] = &[
    ["", "", " # kostka bez koule #"],
    ["", "", " # box minus ball #"],
    ["", "", " # red cube without the small sphere #"],
    ["", "", " # the cube less a sphere #"],
    ["", "", " # cube with a round hole #"],
    ["", "", " # krychle s kulatou dírou #"],
    ["", "", " # kvádr bez dvou koulí #"],
    ["", " # koule, která se odečte #", ""],
    ["", " # koule (odečtou se) #", ""],
    ["", " # odečítaná koule #", ""],
    ["", " # sphere, to be subtracted #", ""],
    ["", " # díra #", ""],
    ["", " # kulatý výřez #", ""],
    ["", " # co se odečte #", ""],
    ["", " # co bude vyříznuto #", ""],
    [" # block #", " # what is cut from it #", ""],
    ["", " # what is taken away #", ""],
    ["", " # the cut #", ""],
    ["", " # cuts off the corner #", ""],
    ["", " # odřezává roh #", ""],
    ["", "", " # block with a hollow #"],
    ["", "", " # kvádr s dírou #"],
    ["", "", " # kvádr se zářezem #"],
    [" # podstavec #", " # jamka #", " # podstavec bez jamky #"],
    [" # dům #", " # dveře #", " # dům - dveře #"],
    [" # dům #", " # okno #", " # rozdíl domu a okna #"],
    [" # zeď #", " # okno #", " # od zdi odečteme okno #"],
    [
        " # the lid #",
        " # the pot #",
        " # the lid without the pot #",
    ],
];

/// Comments of a difference that say the same in other words.
const TAKEN_FROM: &[&str] = &[
    "kvádr - koule",
    "box – sphere",
    "od kvádru odečtu kouli",
    "z kvádru ubereme kouli",
    "kouli odečteme od kvádru",
    "odečíst kouli od kvádru",
    "koule vyříznutá z kvádru",
    "koule, která se odečte od kvádru",
    "odečtení koule od kvádru",
    "rozdíl kvádru a koule",
    "rozdíl mezi kvádrem a koulí",
    "koulí vydlabaný kvádr",
    "kvádr vydlabaný koulí",
    "kvádr s odečtenou koulí",
    "13 - 14",
    "13-14",
    "13 bez 14",
    "13 minus 14",
    "block - ball",
    "subtract the ball from the block",
    "ball cut out of the block",
    "block with a ball taken away",
    "block cut by a ball",
    "ball removed from block",
    "difference of block and ball",
];

#[test]
fn a_difference_that_a_comment_reverses() {
    let phrases: Vec<String> = TAKEN_FROM.iter().map(|s| format!(" # {s} #")).collect();
    let phrases = phrases.iter().map(|said| ["", "", said.as_str()]);
    for comments in &REVERSED.iter().copied().chain(phrases).collect::<Vec<_>>() {
        let text = cut(*comments, "14 13");
        let (finding, made) = guessed(&text, Code::W340);
        assert_eq!(made, [cut(*comments, "13 14")]);
        assert_eq!(fixed(&text), made[0]);
        for language in [Language::English, Language::Czech] {
            let said = finding.wording(language).message;
            assert!(said.contains("14") && said.contains("13"), "{said}");
        }
        let right = read(&cut(*comments, "13 14"));
        assert!(right.findings().iter().all(|d| d.code != Code::W340));
    }
}

/// Comments of the box, the ball and the operation, by which the ball is taken from the box.
const MINUS: &[[&str; 3]] = &[
    ["", "", " # box minus ball #"],
    ["", "", " # kostka bez koule #"],
    ["", " # scoop #", " # box minus scoop #"],
    [" # podstavec #", " # jamka #", " # podstavec bez jamky #"],
    ["", "", " # box - ball #"],
    ["", "", " # subtract the ball from the box #"],
];

/// An operation whose comment begins with the name of another one.
#[test]
fn an_operation_that_its_comment_calls_another() {
    let text = |code: &str, said: &str| {
        cut(["", "", &format!(" # {said} #")], "13 14").replace("-103", code)
    };
    for (code, said, meant) in [
        ("-101", "difference", "-103"),
        ("-102", "CSG difference", "-103"),
        ("-101", "the difference", "-103"),
        ("-101", "rozdíl", "-103"),
        ("-103", "intersection", "-102"),
        ("-103", "the union of both", "-101"),
        ("-101", "průnik", "-102"),
        ("-102", "sjednocení krychle a koule", "-101"),
    ] {
        let (finding, made) = guessed(&text(code, said), Code::W340);
        assert_eq!(finding.case, "called");
        assert_eq!(made, [text(meant, said)]);
    }
    for (code, said) in [
        ("-103", "difference of a union and an intersection"),
        ("-103", "without the union"),
        ("-101", "union of the difference and the ball"),
    ] {
        let found = read(&text(code, said));
        assert!(
            found.findings().iter().all(|d| d.code != Code::W340),
            "{said}"
        );
    }
}

/// A union with a part that its comment calls a hole.
#[test]
fn a_union_with_a_hole() {
    let text = |comments: [&str; 3], code: &str| {
        cut(
            comments.map(|c| match c {
                "" => "",
                c => Box::leak(format!(" # {c} #").into_boxed_str()),
            }),
            "13 14",
        )
        .replace("-103", code)
    };
    for comments in [
        ["", "hole", "disc with hole"],
        ["", "díra", "deska s dírou"],
        ["", "the cutter", "block with a bore"],
    ] {
        let (_, made) = guessed(&text(comments, "-101"), Code::W340);
        assert_eq!(made, [text(comments, "-103")]);
    }
    for comments in [
        ["", "hole", ""],
        ["", "", "disc with hole"],
        ["", "ball", "beside the hole"],
    ] {
        let found = read(&text(comments, "-101"));
        assert!(
            found.findings().iter().all(|d| d.code != Code::W340),
            "{comments:?}"
        );
    }
}

/// Another operation than the difference that its comment says; the colours differ, of which W308 has no guess then.
#[test]
fn an_operation_whose_comment_says_a_difference() {
    let operation =
        |comments: &[&str; 3], code: &str| cut(*comments, "13 14").replace("-103", code);
    for (code, words) in [
        ("-101", ["union 2", "sjednocení 2"]),
        ("-102", ["intersection 2", "průnik 2"]),
    ] {
        for comments in MINUS {
            let text = operation(comments, code);
            let (finding, made) = guessed(&text, Code::W340);
            assert_eq!(made, [operation(comments, "-103")]);
            for (language, word) in [Language::English, Language::Czech].into_iter().zip(words) {
                let said = finding.wording(language).message;
                assert!(said.contains(word), "{said}");
            }
            let painted = text.replace("\n2 -10", "\n13 -701 0.9 0.1 0.1\n2 -10");
            let meant =
                operation(comments, "-103").replace("\n2 -10", "\n13 -701 0.9 0.1 0.1\n2 -10");
            assert_eq!(fixed(&painted), meant);
            let mixed = read(&painted);
            let mut mixed = mixed.findings().iter().filter(|d| d.code == Code::W308);
            assert!(mixed.all(|d| d.fixes.is_empty()), "{painted}");
        }
        for comments in [
            ["", "", " # box and ball #"],
            ["", "", " # ball minus box #"],
            ["", "", " # box minus box #"],
            ["", "", " # box without colour, ball #"],
            ["", "", " # krychle bez barvy a koule #"],
        ] {
            let found = read(&operation(&comments, code));
            assert!(
                found.findings().iter().all(|d| d.code != Code::W340),
                "{comments:?}"
            );
        }
    }
    // A − B may be written as A ∩ −B.
    let complement =
        cut(["", "", " # box minus ball #"], "13 15").replace("\n2 -103", "\n15 -104 14\n2 -102");
    let found = read(&complement);
    assert!(
        found.findings().iter().all(|d| d.code != Code::W340),
        "{complement}"
    );
}

/// What comments say of something else, or of both, is no reason.
#[test]
fn a_difference_that_no_comment_reverses() {
    for comments in [
        ["", "", ""],
        ["", "", " # koule bez krychle #"],
        ["", "", " # ball with a square hole #"],
        ["", "", " # koule s hranatou dírou #"],
        ["", "", " # koule bez koule #"],
        ["", "", " # without a box, the ball #"],
        ["", "", " # box and ball #"],
        ["", "", " # koule (kostka bez barvy) #"],
        ["", "", " # koule - první, kvádr - druhý #"],
        ["", "", " # koule – tu kvádr protíná #"],
        ["", "", " # 14 - 13 #"],
        ["", "", " # 13 - 24 #"],
        ["", "", " # rozdíl koule a kvádru #"],
        ["", "", " # kvádr odečtu od koule #"],
        ["", "", " # koule, od které se odečte kvádr #"],
        ["", "", " # koule vydlabaná kvádrem #"],
        ["", "", " # koule a také kvádr #"],
        ["", "", " # kvádr se také dotýká koule #"],
        ["", "", " # subtract the block from the ball #"],
        ["", "", " # ball with a block taken away #"],
        ["", "", " # the block cuts the ball #"],
        ["", " # koule, od které se odečte kostka #", ""],
        ["", " # sphere with a hole #", ""],
        ["", " # subtract the cube from this #", ""],
        [" # díra #", " # díra v kouli #", ""],
        ["", " # díra v kouli #", ""],
        ["", " # hollow ball #", ""],
        ["", " # cut ball #", ""],
        ["", " # the ball that is cut by the cube #", ""],
        ["", " # vyřezaná koule #", ""],
        ["", " # koule s výřezem #", ""],
        ["", " # z ní se odečte díra #", ""],
        ["", "", " # ball with a hollow #"],
        ["", " # odečtení #", ""],
        [" # díl #", " # důl #", " # důl bez dílu #"],
    ] {
        let found = read(&cut(comments, "14 13"));
        let codes: Vec<Code> = found.findings().iter().map(|d| d.code).collect();
        assert!(!codes.contains(&Code::W340), "{comments:?}");
    }
}

/// A comment above the first record is about that, where it names its shape.
#[test]
fn glass_by_a_comment_on_the_first_line() {
    let rest = "2 11 0 1 0 1\n2 -201 0.05 0.15 0.8\n";
    for comment in ["# glass ball #", "0 # skleněná koule #"] {
        let (_, made) = guessed(&scene(&format!("{comment}\n{rest}")), Code::W337);
        assert!(made[0].contains("2 -203 1.5 1.5 1.5\n"), "{}", made[0]);
    }
    for comment in [
        "# glass ball #\n",
        "# glass ball and a box #",
        "# glass box #",
    ] {
        let found = read(&scene(&format!("{comment}\n{rest}")));
        assert!(found.findings().iter().all(|d| d.code != Code::W337));
    }
}

/// A glass ball on a floor, whose radius may stand first: by its spaces, or because it then stands on the floor.
#[test]
fn the_radius_of_a_sphere_first() {
    let text = |numbers: &str| {
        scene(&format!(
            "21 4 0 1 0 0\n22 11 {numbers}\n22 -201 0.05 0.1 0.85\n22 -203 1.5 1.5 1.5\n2 -101 21 22"
        ))
    };
    let meant = text("0.3 0.7 2.2 0.7");
    assert!(read(&meant).findings().iter().all(|d| d.code != Code::W307));
    for (numbers, is_apart) in [("0.7  0.3 0.7 2.2", true), ("0.7 0.3 0.7 2.2", false)] {
        let (finding, made) = guessed(&text(numbers), Code::W307);
        assert_eq!(made[0], meant);
        let said = finding.wording(Language::Czech).fixes;
        assert_eq!(said[0], "je-li první poloměr, napsat `0.3 0.7 2.2 0.7`");
        assert_eq!(fixed(&text(numbers)) == meant, is_apart);
    }
    // The first number is no radius: below the floor, or with nothing that speaks for it.
    for numbers in ["-0.7  0.3 0.7 2.2", "0.5 0.3 0.7 2.2", "0.3 0.7 2.2  1"] {
        let (finding, _) = guessed(&text(numbers), Code::W307);
        assert!(
            finding.fixes.iter().all(|f| f.title != "fix-radius"),
            "{numbers}"
        );
    }
}

/// An opaque ball on a floor, beside another one, whose radius stands first.
#[test]
fn the_radius_of_an_opaque_sphere_first() {
    let text = |numbers: &str| {
        scene(&format!(
            "21 11 0 1 0 1\n22 11 {numbers}\n23 4 0 1 0 0\n24 -101 21 22\n2 -101 23 24"
        ))
    };
    let meant = text("0.3 0.7 2.2 0.7");
    assert!(read(&meant).findings().iter().all(|d| d.code != Code::W307));
    let (finding, made) = guessed(&text("0.7 0.3 0.7 2.2"), Code::W307);
    assert_eq!((finding.case, &made[0]), ("radius", &meant));
    let said = finding.wording(Language::Czech);
    assert_eq!(
        said.fixes[0],
        "je-li první poloměr, napsat `0.3 0.7 2.2 0.7`"
    );
    // A hill, and a ball that reaches into the other one and would not stand on the floor.
    for numbers in ["5 -3 5 4", "0.5 0.3 0.7 2.2", "0.3 1 1 0.5"] {
        let found = read(&text(numbers));
        assert!(
            found.findings().iter().all(|d| d.code != Code::W307),
            "{numbers}"
        );
    }
}

/// The radius that makes a glass ball touch the floor is proposed for all that it overlaps, and no overlap is rewritten.
#[test]
fn the_radius_of_a_sphere_that_overlaps_two() {
    let text = |numbers: &str| {
        scene(&format!(
            "21 11 -1.5 1 0 1\n22 4 0 1 0 0\n23 11 {numbers}\n23 -201 0.05 0.05 0.9\n\
             23 -203 1.5 1.5 1.5\n24 -101 21 23\n2 -101 24 22"
        ))
    };
    let (written, meant) = (text("0.6 1.2 0.6 1.8"), text("1.2 0.6 1.8 0.6"));
    assert!(read(&meant).findings().iter().all(|d| d.code != Code::W307));
    let all = repair::proposals(&read(&written));
    let found: Vec<_> = all.iter().filter(|d| d.code == Code::W307).collect();
    assert_eq!(found.len(), 2);
    for finding in found {
        assert_eq!(finding.fixes[0].title, "fix-radius");
        let made = fixes::apply(&written, finding.fixes[..1].iter()).0;
        assert_eq!(made, meant);
    }
    assert_eq!(fixed(&written), written);
}

/// Shapes without their types, whose IDs are types: a comment names the shape, and other records use the ID. Each has the
/// drawn ID, what is written, and what is meant.
const LOST_TYPES: &[(u32, &str, &str)] = &[
    (
        3,
        "3 0.5 0.8 1.5 0.8 # koule #\n3 -701 0.9 0.2 0.1",
        "3 11 0.5 0.8 1.5 0.8",
    ),
    (3, "3 0.5 0.8 1.5 0.8 # koule #", "3 11 0.5 0.8 1.5 0.8"),
    (
        4,
        "4 0.5 0.8 1.5 0.8 # skleněná koule #",
        "4 11 0.5 0.8 1.5 0.8",
    ),
    (
        4,
        "4 0.5 0.8 1.5 0.8 # glass ball #\n4 -701 0.9 0.2 0.1",
        "4 11 0.5 0.8 1.5 0.8",
    ),
    (
        4,
        "4 0 1 0 1 # a ball #\n4 -701 0.9 0.2 0.1",
        "4 11 0 1 0 1",
    ),
    (
        3,
        "3 0.5 0.8 1.5 0.8\n3 -701 0.9 0.2 0.1",
        "3 11 0.5 0.8 1.5 0.8",
    ),
    (
        5,
        "5 -1 0 -1 1 1.5 1 # modrý kvádr #\n5 -701 0 0 1",
        "5 12 -1 0 -1 1 1.5 1",
    ),
    // The first number is a type, too.
    (3, "3 1 1 0 1 # koule #", "3 11 1 1 0 1"),
    (3, "3 2 1 0 1 # koule #", "3 11 2 1 0 1"),
    (3, "3 1 2 0 1 # ball #", "3 11 1 2 0 1"),
    (
        3,
        "3 12 1 0 1 # ball #\n3 -701 0.9 0.2 0.1",
        "3 11 12 1 0 1",
    ),
    // The ID is lost.
    (
        7,
        "3 0.5 0.8 1.5 0.8 # koule #\n3 -701 0.9 0.2 0.1",
        "7 3 0.5 0.8 1.5 0.8",
    ),
    (
        4,
        "4 0 1 0 1 # rovina pod koulí #\n4 -701 0.9 0.2 0.1",
        "4 4 0 1 0 1",
    ),
];

#[test]
fn a_shape_without_its_type_by_a_comment() {
    for &(drawn, written, meant) in LOST_TYPES {
        let text = scene(written).replace("9999 2", &format!("9999 {drawn}"));
        let all = repair::proposals(&read(&text));
        let error = all.iter().find(|d| d.is_error()).expect(written);
        let made = fixes::apply(&text, error.fixes[..1].iter()).0;
        let numbers = written.lines().next().unwrap_or_default();
        let numbers = numbers.split(" #").next().unwrap_or_default();
        assert_eq!(made, text.replacen(numbers, meant, 1), "{written}");
        assert_eq!(
            fixed(&text).lines().next(),
            made.lines().next(),
            "{written}"
        );
        let is_typeless = error.code == Code::E006 && error.case == "lost";
        let is_lost = ["7 3", "4 4"].iter().any(|head| meant.starts_with(head));
        assert_eq!(is_typeless, !is_lost, "{written}");
    }
    // A comment that names the profile, or nothing, leaves the number of points wrong.
    for comment in ["", " # válec #", " # krychle #"] {
        let (_, made) = guessed(&scene(&format!("2 1 1 0 1{comment}")), Code::E206);
        assert!(made.is_empty(), "{comment}");
    }
}

/// W321 lengthens no tool where the comment says that it is no tool: only the door is taken from the house.
#[test]
fn a_shared_face_of_operands_in_the_wrong_order() {
    for (house, door, said) in [
        ("domek", "dveře", "domek - dveře"),
        ("house", "door", "house minus door"),
    ] {
        let text = |base: &str, operands: &str| {
            scene(&format!(
                "3 12 -1 0 -1 1 2 1 # {house} #\n4 12 -0.3 {base} 0.5 0.3 1.2 1.5 # {door} #\n2 -103 {operands} # {said} #"
            ))
        };
        let (flush, made) = guessed(&text("0", "4 3"), Code::W321);
        assert!(made.is_empty(), "{flush:?}");
        assert_eq!(fixed(&text("0", "4 3")), text("-0.0012", "3 4"));
        let (_, made) = guessed(&text("0", "3 4"), Code::W321);
        assert_eq!(made, [text("-0.0012", "3 4")]);
    }
}
