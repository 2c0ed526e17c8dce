//! What comments say of mirrors and glass, of radii and edges, and of floors, and the records say otherwise.

use zpg::internals::diagnostics::{Code, Language};

use super::{fixed, guessed, read};

const REST: &str = "50 -402 0.8\n50 -1 4 6 5\n9 -501 0 3 9 0 -0.25 -1 0 1 0 40\n1 9999 2 0\n";

fn scene(records: &str) -> String {
    format!("{records}\n{REST}")
}

/// Checks the guesses, and that a finding is not there any more after any of them.
fn expect(code: Code, cases: &[(&str, &[&str])]) {
    for (written, meant) in cases {
        let (finding, made) = guessed(&scene(written), code);
        let meant: Vec<String> = meant.iter().map(|records| scene(records)).collect();
        assert_eq!(made, meant, "{written}");
        for text in &made {
            assert!(!has(text, code), "{text}");
        }
        for language in [Language::English, Language::Czech] {
            assert_eq!(finding.wording(language).fixes.len(), made.len());
        }
    }
}

fn has(text: &str, code: Code) -> bool {
    read(text).findings().iter().any(|d| d.code == code)
}

#[test]
fn optics_that_are_no_mirror_or_glass() {
    expect(
        Code::W342,
        &[
            (
                "2 11 0 1 0 1 # mirror ball #\n2 -201 0.1 0 0.85",
                &["2 11 0 1 0 1 # mirror ball #\n2 -201 0.1 0.85 0"],
            ),
            (
                "2 11 0 1 0 1 # zrcadlová koule #\n2 -201 0.1 0 0.85",
                &["2 11 0 1 0 1 # zrcadlová koule #\n2 -201 0.1 0.85 0"],
            ),
            (
                "2 11 0 1 0 1 # glass ball #\n2 -201 0.05 0.9 0.05\n2 -203 1.5 1.5 1.5",
                &["2 11 0 1 0 1 # glass ball #\n2 -201 0.05 0.05 0.9\n2 -203 1.5 1.5 1.5"],
            ),
            (
                "2 11 0 1 0 1 # skleněná koule #\n2 -201 0.05 0.9 0.05\n2 -203 1.5 1.5 1.5",
                &["2 11 0 1 0 1 # skleněná koule #\n2 -201 0.05 0.05 0.9\n2 -203 1.5 1.5 1.5"],
            ),
            (
                "2 11 0 1 0 1\n2 -201 0.9 0.06 0.04 # glass #\n2 -203 1.5 1.5 1.5",
                &["2 11 0 1 0 1\n2 -201 0.04 0.06 0.9 # glass #\n2 -203 1.5 1.5 1.5"],
            ),
        ],
    );
}

#[test]
fn a_mirror_without_optics() {
    expect(
        Code::W342,
        &[
            (
                "2 11 0 1 0 1 # mirror ball #",
                &["2 11 0 1 0 1 # mirror ball #\n2 -201 0.1 0.85 0"],
            ),
            (
                "2 11 0 1 0 1 # zrcadlo #\n2 -701 0.1 0.9 0",
                &[
                    "2 11 0 1 0 1 # zrcadlo #\n2 -201 0.1 0.9 0",
                    "2 11 0 1 0 1 # zrcadlo #\n2 -201 0.1 0.85 0\n2 -701 0.1 0.9 0",
                ],
            ),
        ],
    );
    for records in [
        "2 11 0 1 0 1 # mirror ball #\n2 -201 0.1 0.85 0",
        "2 11 0 1 0 1 # mirror ball #\n2 -201 0.4 0.3 0.3",
        "2 11 0 1 0 1 # behind the mirror #",
        "2 11 0 1 0 1 # mirror box #",
        "2 11 0 1 0 1 # mirror image #",
        "2 11 0 1 0 1 # rám zrcadla #",
        "2 11 0 1 0 1 # ball on glass #",
        "3 11 0 1 0 1 # mirror #\n4 12 2 0 0 3 1 1\n2 -101 3 4\n2 -201 0.1 0.85 0",
        "35 -201 0.1 0.85 0\n2 11 0 1 0 1 # mirror #\n2 -299 0 35",
    ] {
        assert!(!has(&scene(records), Code::W342), "{records}");
    }
}

/// A comment that denies a mirror or glass, or tells of another time, calls nothing so.
#[test]
fn what_is_no_mirror_or_glass_yet() {
    for said in [
        "matná koule, ne sklo",
        "ne zrcadlo",
        "(ne zrcadlo)",
        "žádné sklo",
        "zadne sklo",
        "zatím ne skleněná",
        "není sklo",
        "bude sklo",
        "později skleněná",
        "pak zrcadlo",
        "byla skleněná",
        "no mirror",
        "not a mirror",
        "not yet glass",
        "isn't glass",
        "later glass",
        "will be glass",
        "todo: glass",
    ] {
        let records = format!("2 11 0 1 0 1 # {said} #\n2 -701 0.9 0.2 0.1");
        assert!(!has(&scene(&records), Code::W342), "{said}");
    }
    let floor = "3 5 -5 -5 5 5 # není podlaha #\n4 11 0 1 0 1\n2 -101 3 4";
    assert!(!has(&scene(floor), Code::W343));
    // Of what is denied the index is not proposed.
    let clear = |said: &str| format!("2 11 0 1 0 1 # {said} #\n2 -201 0 0.1 0.9");
    assert!(!has(&scene(&clear("ne sklo")), Code::W337));
    let water = clear("voda, ne sklo");
    expect(
        Code::W337,
        &[(&water, &[&format!("{water}\n2 -203 1.33 1.33 1.33")])],
    );
}

#[test]
fn a_radius_and_a_diameter() {
    for said in ["koule o průměru 2", "a ball 2 across", "diameter 2"] {
        let written = format!("2 11 0 1 0 2 # {said} #");
        let meant = format!("2 11 0 1 0 1 # {said} #");
        expect(Code::W341, &[(&written, &[&meant])]);
    }
    for said in ["měsíc o poloměru 0.6", "radius 0.6"] {
        let written = format!("2 11 0.6 3.2 0.6 2 # {said} #");
        let meant = format!("2 11 3.2 0.6 2 0.6 # {said} #");
        expect(Code::W341, &[(&written, &[&meant])]);
    }
    for records in [
        "2 11 0 1 0 1 # diameter 2 #",
        "2 11 0 1 0 2 # diameter 4, radius 2 #",
        "2 11 0.6 3.2 0.6 2 # radius 2 #",
        "2 11 0.6 3.2 0.6 0.6 # radius 0.6 #",
        "2 11 0 1 0 2 # 2 balls #",
    ] {
        assert!(!has(&scene(records), Code::W341), "{records}");
    }
}

#[test]
fn a_box_by_its_edges() {
    let both = |said: &str| {
        ["0.2 0 -2.5 2.2 2 -0.5", "-0.8 -1 -3.5 1.2 1 -1.5"]
            .map(|bounds| format!("2 12 {bounds} # {said} #"))
    };
    for said in ["krychle 2 x 2 x 2", "2×2×2", "krychle", "cube"] {
        let written = format!("2 12 0.2 0 -2.5 2 2 2 # {said} #");
        let [corner, centre] = both(said);
        expect(Code::W341, &[(&written, &[&corner, &centre])]);
    }
    expect(
        Code::W341,
        &[(
            "2 12 1 0 0 2 2 2 # krychle 2 x 2 x 2 s rohem v (1, 0, 0) #",
            &["2 12 1 0 0 3 2 2 # krychle 2 x 2 x 2 s rohem v (1, 0, 0) #"],
        )],
    );
    for records in [
        "2 12 0 0 0 2 2 2 # cube 2 x 2 x 2 #",
        "2 12 -1 0 -1 1 1 1 # cube #",
        "2 12 0.2 0 -2.5 2 2 2 # box #",
        "2 12 0.2 0 -2.5 2 2 2 # 1.8 x 2 x 4.5 #",
    ] {
        assert!(!has(&scene(records), Code::W341), "{records}");
    }
}

#[test]
fn a_floor_that_stands_upright() {
    for said in ["podlaha 10 x 10", "floor"] {
        let text = |turn: &str| format!("3 5 -5 -5 5 5 # {said} #\n{turn}4 11 0 1 0 1\n2 -101 3 4");
        expect(Code::W343, &[(&text(""), &[&text("3 -2 -90 1\n")])]);
    }
    for records in [
        "3 5 -5 -5 5 5 # floor #\n3 -2 90 1\n4 11 0 1 0 1\n2 -101 3 4",
        "3 5 -5 -5 5 5 # floor #\n4 11 0 1 0 1\n2 -101 3 4\n2 -2 -90 1",
        "3 5 -5 -5 5 5 # wall on the floor #\n4 11 0 1 0 1\n2 -101 3 4",
        "3 5 -5 -5 5 5\n4 11 0 1 0 1\n2 -101 3 4",
    ] {
        assert!(!has(&scene(records), Code::W343), "{records}");
    }
    // Up in the picture is along z.
    let lying = scene("2 5 -5 -5 5 5 # floor #")
        .replace("0 3 9 0 -0.25 -1 0 1 0", "0 -9 3 0 1 -0.25 0 0 1");
    assert!(!has(&lying, Code::W343));
}

/// Optics right behind a mirror that are given to another object are the mirror's.
#[test]
fn optics_of_a_mirror_with_another_id() {
    let text = |id: u32, said: &str| {
        scene(&format!(
            "3 11 -1.5 1 0 1 # {said} #\n3 -701 0.9 0.2 0.1\n4 11 1.5 1 0 1 # zrcadlo #\n\
             {id} -201 0.1 0.8 0\n2 -101 3 4"
        ))
    };
    let written = text(3, "červená koule");
    let (finding, made) = guessed(&written, Code::W342);
    assert_eq!(made[0], text(4, "červená koule"));
    assert_eq!(finding.wording(Language::English).fixes[0], "write `4`");
    assert_eq!(finding.wording(Language::Czech).fixes[0], "napsat `4`");
    assert_eq!(fixed(&written), text(4, "červená koule"));
    // Both are mirrors.
    let (_, made) = guessed(&text(3, "zrcadlo"), Code::W342);
    assert!(made[0].contains("4 -201 0.1 0.85 0\n"));
}

/// Each record that is to be added is quoted by itself.
#[test]
fn two_records_to_be_added() {
    let (finding, _) = guessed(&scene("2 11 0 1 0 1 # sklo #"), Code::W342);
    for (language, add) in [(Language::English, "add"), (Language::Czech, "přidat")] {
        let said = finding.wording(language).fixes;
        assert_eq!(
            said,
            [format!(
                "{add} `2 -201 0.05 0.1 0.85`, `2 -203 1.5 1.5 1.5`"
            )]
        );
    }
}
