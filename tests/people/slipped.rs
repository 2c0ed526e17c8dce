//! Operands, numbers and records in the place of others, where sizes and comments say what was meant.

use zpg::internals::diagnostics::{Code, Diagnostic, Language};

use super::{fixed, guessed, read};

fn scene(records: &str, drawn: u32) -> String {
    format!(
        "{records}\n9 -501 2 3 8 -0.2 -0.35 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 8\n1 9999 {drawn} 0\n"
    )
}

fn of_code(text: &str, code: Code) -> Vec<Diagnostic> {
    let all = read(text).findings().to_vec();
    all.into_iter().filter(|d| d.code == code).collect()
}

/// The records, the object that is drawn, and what each proposal makes of a piece of the records.
type Slip = (&'static str, u32, &'static str, &'static [&'static str]);

/// Checks the proposals for a finding, in their order, and that each has words in both languages.
fn expect(code: Code, cases: &[Slip]) {
    for &(records, drawn, written, meant) in cases {
        let text = scene(records, drawn);
        assert_eq!(text.matches(written).count(), 1, "{text}");
        let (finding, made) = guessed(&text, code);
        let meant: Vec<String> = meant.iter().map(|m| text.replace(written, m)).collect();
        assert_eq!(made, meant, "{text}");
        for language in [Language::English, Language::Czech] {
            let said = finding.wording(language);
            assert_eq!(said.fixes.len(), made.len());
            assert!(!said.message.is_empty());
        }
    }
}

/// The pips are much smaller than the die that is taken away from them.
#[test]
fn a_coloured_die_is_taken_away_from_its_pips() {
    let die = |comment: &str| {
        let records = format!(
            "2 12 -6 -2 -4 6 -1 4\n30 12 -1 -1 -1 1 1 1{comment}\n30 -701 0.9 0.1 0.1\n31 11 0 0 1 0.3 # pip in front #\n\
             32 11 0 1 0 0.3 # pip on top #\n33 -101 31 32\n36 -103 33 30\n36 -2 30 2\n40 -101 2 36"
        );
        scene(&records, 40)
    };
    let text = die("");
    let (finding, made) = guessed(&text, Code::W331);
    let meant = ["36 -103 30 33", "36 -101 33 30"];
    assert_eq!(made, meant.map(|m| text.replace("36 -103 33 30", m)));
    for (language, said) in [
        (Language::English, "are its operands swapped?"),
        (Language::Czech, "nejsou operandy prohozené?"),
    ] {
        assert!(finding.wording(language).message.ends_with(said));
    }
    assert_eq!(fixed(&text), text);
    // A large object that a thin tool is taken from is no tool.
    let large = die("").replace("31 11 0 0 1 0.3", "31 12 -4 -4 -4 4 4 0.5");
    let (_, made) = guessed(&large, Code::W331);
    assert_eq!(made, [large.replace("36 -103 33 30", "36 -101 33 30")]);
    // Where W340 says it, W331 has nothing to add.
    for comment in ["# cube without the pips #", "# krychle bez puntíků #"] {
        let name = comment
            .replace("without the pips", "")
            .replace("bez puntíků", "");
        let said = die(&format!(" {name}"))
            .replace("33 -101 31 32", "33 -101 31 32 # all pips, puntíky #")
            .replace("36 -103 33 30", &format!("36 -103 33 30 {comment}"));
        assert_eq!(of_code(&said, Code::W340).len(), 1, "{said}");
        assert!(of_code(&said, Code::W331).is_empty(), "{said}");
    }
}

/// The operands stay as the comment has them, and the ball in the union is the one that is too large.
#[test]
fn a_part_of_a_tool_is_too_large() {
    let cut = |comment: &str| {
        let records = format!(
            "30 12 -1 -1 -1 1 1 1\n31 11 0 0 1 0.3\n32 11 0 1 0 3\n33 -101 31 32\n36 -103 30 33{comment}"
        );
        scene(&records, 36)
    };
    for comment in [
        " # cube without pips #",
        " # krychle bez puntíků #",
        " # cube with holes #",
        " # krychle s otvory #",
    ] {
        let text = cut(comment);
        let (_, made) = guessed(&text, Code::W319);
        assert_eq!(made, [text.replace("0 1 0 3\n", "0 1 0 0.3\n")], "{text}");
        assert_eq!(fixed(&text), text);
    }
    for comment in ["", " # pips #", " # pips without the cube #"] {
        let text = cut(comment);
        let (_, made) = guessed(&text, Code::W319);
        assert_eq!(made, [text.replace("30 33", "33 30")], "{text}");
    }
}

#[test]
fn a_profile_with_a_lost_point_or_with_pairs_the_other_way_round() {
    const SWAPPED: &str = "0.45 0 0.45 1.3 0.15 1.7 0.15 2.1 0.2 2.1 0.2 2.2";
    let lost = "20 1 6 0.45 0 0.45 13 0.15 1.7 0.15 2.1 0.2 2.1 0.2 2.2";
    expect(
        Code::W320,
        &[
            (lost, 20, "13 0.15", &["1.3 0.15"]),
            (
                "20 1 6 0 0.45 1.3 0.45 1.7 0.15 2.1 0.15 2.1 0.2 2.2 0.2 # bottle: height, radius #",
                20,
                "0 0.45 1.3 0.45 1.7 0.15 2.1 0.15 2.1 0.2 2.2 0.2",
                &[SWAPPED],
            ),
            (
                "20 1 6 0 0.45 1.3 0.45 1.7 0.15 2.1 0.15 2.1 0.2 2.2 0.2 # láhev: výška, poloměr #",
                20,
                "0 0.45 1.3 0.45 1.7 0.15 2.1 0.15 2.1 0.2 2.2 0.2",
                &[SWAPPED],
            ),
            // The comment has the other order, and the heights would be radii below zero.
            (
                "20 1 4 2 0 3 2 1 -1 0 -1 # height, radius #",
                20,
                "2 0 3 2 1 -1 0 -1",
                &[],
            ),
        ],
    );
    assert_eq!(
        fixed(&scene(lost, 20)),
        scene(lost, 20).replace(" 13 ", " 1.3 ")
    );
}

#[test]
fn a_lamp_above_that_is_below_everything() {
    let lamp = |comment: &str| {
        let text = scene("2 12 -3 -1 -3 3 0 3\n3 9 0.4\n4 -101 2 3", 4);
        text.replace("50 -1 4 6 8", &format!("50 -1 -5 -8 6{comment}"))
    };
    for comment in [
        " # lamp above the table #",
        " # světlo nad stolem #",
        " # overhead #",
    ] {
        let text = lamp(comment);
        let (finding, made) = guessed(&text, Code::W344);
        assert_eq!(made, [text.replace("-5 -8 6", "-5 8 6")]);
        assert!(of_code(&made[0], Code::W344).is_empty());
        assert_eq!(fixed(&text), made[0]);
        let czech = finding.wording(Language::Czech);
        assert!(czech.message.contains("nad něčím"));
    }
    for comment in ["", " # lamp below, not above #", " # světlo pod stolem #"] {
        assert!(of_code(&lamp(comment), Code::W344).is_empty());
    }
    // A lamp above one of two objects is right.
    let between = lamp(" # lamp above the table #").replace("3 9 0.4", "3 11 0 -12 0 1");
    assert!(of_code(&between, Code::W344).is_empty());
}

/// A cone's tip is at the origin, and its base above it where the height is positive.
#[test]
fn a_cone_whose_tip_is_up() {
    let house = |cone: &str, moved: &str| {
        scene(
            &format!("2 12 -1 0 -1 1 2 1\n5 {cone}\n{moved}6 -101 2 5"),
            6,
        )
    };
    for comment in [
        "roof, tip up",
        "apex upwards",
        "střecha, špička nahoře",
        "kužel špičkou nahoru",
    ] {
        let cone = |height: &str| format!("16 {height} 1.5 # {comment} #");
        for (written, meant) in [("5 -1 0 2 0\n", "5 -1 0 3 0\n"), ("", "")] {
            let text = house(&cone("1"), written);
            let (finding, made) = guessed(&text, Code::W344);
            assert_eq!(made, [house(&cone("-1"), meant)]);
            assert!(of_code(&made[0], Code::W344).is_empty());
            assert_eq!(fixed(&text), made[0]);
            assert!(finding.wording(Language::Czech).message.contains("špičku"));
        }
    }
    for (cone, moved) in [
        ("16 1 1.5 # roof #", "5 -1 0 2 0\n"),
        ("16 -1 1.5 # roof, tip up #", "5 -1 0 3 0\n"),
        ("16 1 1.5 # tip down #", ""),
        ("16 1 1.5 # tip up #", "5 -2 180 1\n5 -1 0 3 0\n"),
    ] {
        assert!(of_code(&house(cone, moved), Code::W344).is_empty());
    }
    // The whole house is turned over.
    let turned = house("16 1 1.5 # tip up #", "").replace("\n9 -501", "\n6 -2 180 1\n9 -501");
    assert!(turned.contains("6 -2") && of_code(&turned, Code::W344).is_empty());
}

/// A mirror might show an object beside the picture, but hardly one that is so far away.
#[test]
fn far_beside_a_picture_with_a_mirror() {
    let of = |x: &str| {
        let records = format!(
            "2 4 0 1 0 0\n3 11 0 1 0 1\n3 -201 0.1 0.8 0.1\n4 11 1.5 0.5 0 0.5\n5 11 {x} 0.4 2 0.4\n\
             6 11 -1 0.3 2 0.3\n7 -101 6 5\n8 -101 7 4\n10 -101 8 3\n11 -101 2 10"
        );
        scene(&records, 11)
    };
    let text = of("15");
    let (_, made) = guessed(&text, Code::N608);
    assert_eq!(made, [of("1.5")]);
    // Out of the picture, but near enough for the mirror.
    let near = of("-5").replace("9 -501 2 3 8", "9 -501 4 3 8");
    assert!(of_code(&near, Code::N608).is_empty());
}

#[test]
fn a_move_between_the_records_of_another_object() {
    let of = |comment: &str| {
        let records = format!(
            "2 4 0 1 0 0\n10 1 2 0.1 0 0.1 2 # rod #\n10 -701 0.5 0.5 0.5\n11 1 4 0.1 0 0.5 0 0.3 0.5 0.1 0.5\n\
             10 -1 0 1.8 0{comment}\n11 -701 0.9 0.9 0.2\n12 -101 10 11\n13 -101 2 12"
        );
        scene(&records, 13)
    };
    let text = of("");
    let (_, made) = guessed(&text, Code::N610);
    assert_eq!(made, [text.replace("10 -1 0", "11 -1 0")]);
    // A comment names the object that is moved, or the other one is moved, too.
    for meant in [
        of(" # lift the wooden rod #").replace("# rod #", "# wooden rod #"),
        text.replace("11 -701", "11 -1 0 2 0\n11 -701"),
        text.replace(
            "10 -1 0 1.8 0\n11 -701 0.9 0.9 0.2",
            "11 -701 0.9 0.9 0.2\n10 -1 0 1.8 0",
        ),
    ] {
        assert!(of_code(&meant, Code::N610).is_empty(), "{meant}");
    }
}

#[test]
fn what_lies_on_a_table_has_the_other_height() {
    expect(
        Code::W335,
        &[
            (
                "2 12 -3 -1 -3 3 0 3\n5 9 0.4\n5 -1 2 -0.5 1 # on the table #\n6 -101 2 5",
                6,
                "5 -1 2 -0.5 1",
                &["5 -1 2 0.5 1"],
            ),
            (
                "2 12 -3 -1 -3 3 0 3\n5 9 0.4\n5 -1 2 -0.5 1 # na stole #\n6 -101 2 5",
                6,
                "5 -1 2 -0.5 1",
                &["5 -1 2 0.5 1"],
            ),
            // Nothing says on, it is in the table, or the other height is inside as well.
            (
                "2 12 -3 -1 -3 3 0 3\n5 9 0.4\n5 -1 2 -0.5 1\n6 -101 2 5",
                6,
                "5 -1 2 -0.5 1",
                &[],
            ),
            (
                "2 12 -3 -1 -3 3 0 3\n5 9 0.4\n5 -1 2 -0.5 1 # hole in the table #\n6 -101 2 5",
                6,
                "5 -1 2 -0.5 1",
                &[],
            ),
            (
                "2 12 -3 -1 -3 3 1 3\n5 9 0.4\n5 -1 2 -0.5 1 # on the table #\n6 -101 2 5",
                6,
                "5 -1 2 -0.5 1",
                &[],
            ),
        ],
    );
}

#[test]
fn a_part_of_a_tool_that_misses_what_is_cut() {
    let of = |y: &str, more: &str| {
        let records = format!(
            "30 12 -1 -1 -1 1 1 1\n31 11 0 0 1 0.3\n32 11 0 {y} 0 0.3\n33 -101 31 32\n36 -103 30 33{more}"
        );
        scene(&records, 36)
    };
    let all = of_code(&of("10", ""), Code::W332);
    assert_eq!((all.len(), all[0].case), (1, "part"));
    for (language, said) in [
        (
            Language::English,
            "a part of that, the sphere 32, does not touch the box 30",
        ),
        (
            Language::Czech,
            "jeho část 32 (koule) se nedotýká objektu 30 (kvádr)",
        ),
    ] {
        let message = all[0].wording(language).message;
        assert!(message.contains(said), "{message}");
    }
    assert!(of_code(&of("1", ""), Code::W332).is_empty());
    // The part, or the whole tool, is for another object, too.
    for more in [
        "\n37 12 -1 9 -1 1 11 1\n38 -103 37 33\n39 -101 36 38",
        "\n37 12 -1 9 -1 1 11 1\n38 -103 37 32\n39 -101 36 38",
    ] {
        let text = of("10", more).replace("9999 36", "9999 39");
        let parts = of_code(&text, Code::W332);
        assert!(parts.iter().all(|d| d.case != "part"), "{text}");
    }
}

#[test]
fn glass_by_its_comment_beside_a_lens_with_an_index() {
    let of = |comment: &str| {
        let records = format!(
            "2 4 0 1 0 0\n20 11 0 1 0 0.8\n20 -201 0.1 0.1 0.8{comment}\n21 10 1 1 0.3\n\
             21 -201 0.1 0.1 0.8\n21 -203 1.5 1.5 1.5\n21 -1 2 1 2\n22 -101 20 21\n23 -101 2 22"
        );
        scene(&records, 23)
    };
    for comment in [" # glass #", " # sklo #"] {
        let text = of(comment);
        let (_, made) = guessed(&text, Code::W337);
        let line = format!("20 -201 0.1 0.1 0.8{comment}\n");
        assert_eq!(
            made,
            [text.replace(&line, &format!("{line}20 -203 1.5 1.5 1.5\n"))]
        );
    }
    for comment in ["", " # no glass #", " # ball #"] {
        assert!(of_code(&of(comment), Code::W337).is_empty());
    }
}
