//! What comments say of mirrors and glass, of radii and edges, of floors, and of lights, axes, angles and colours, and the
//! records say otherwise.

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
    // One distance is symmetric by chance.
    for said in ["krychle", "cube", "krychle o hraně 2", "kostka s hranou 2"] {
        let text = |numbers: &str| format!("2 12 {numbers} # {said} #");
        let [corner, centre] = ["1 0 -2 3 2 0", "0 -1 -3 2 1 -1"].map(text);
        // The centre comes first where the comment speaks of an edge.
        let meant = match said.contains("hran") {
            true => [&*centre, &corner],
            false => [&*corner, &centre],
        };
        expect(Code::W341, &[(&text("1 0 -2 2 2 2"), &meant)]);
    }
    // Two are not, unless the comment gives the edge.
    let text = |numbers: &str| format!("2 12 {numbers} # cube with edge 2 #");
    let [corner, centre] = ["-2 0 -2 0 2 0", "-3 -1 -3 -1 1 -1"].map(text);
    expect(Code::W341, &[(&text("-2 0 -2 2 2 2"), &[&centre, &corner])]);
    expect(
        Code::W341,
        &[(
            "2 12 1 0 0 2 2 2 # krychle 2 x 2 x 2 s rohem v (1, 0, 0) #",
            &["2 12 1 0 0 3 2 2 # krychle 2 x 2 x 2 s rohem v (1, 0, 0) #"],
        )],
    );
    // The edges are listed behind a word for a size, or have names.
    for said in [
        "size 3 2 2",
        "dům, rozměry 3 2 2",
        "width 3, height 2, depth 2",
        "dům: šířka 3, výška 2, hloubka 2",
    ] {
        let text = |numbers: &str| format!("2 12 {numbers} # {said} #");
        let both = ["-2 0 -1 1 2 1", "-3.5 -1 -2 -0.5 1 0"].map(text);
        let [corner, centre] = both.each_ref().map(String::as_str);
        // A size alone rather stands beside a centre.
        let meant = match said.contains("3,") {
            true => [corner, centre],
            false => [centre, corner],
        };
        expect(Code::W341, &[(&text("-2 0 -1 3 2 2"), &meant)]);
    }
    // Symmetric distances do not matter where the comment speaks of a centre and a size.
    for said in ["dům: střed a velikost", "house: centre and size"] {
        let text = |numbers: &str| format!("2 12 {numbers} # {said} #");
        for (written, meant) in [
            ("-2.75 1 -2 2.5 2 2", "-4 0 -3 -1.5 2 -1"),
            ("-2 1 -2 2 2 2", "-3 0 -3 -1 2 -1"),
        ] {
            expect(Code::W341, &[(&text(written), &[&text(meant)])]);
        }
        assert!(!has(&scene(&text("-2 -1 -2 2 1 2")), Code::W341));
    }
    for records in [
        "2 12 -2 0 -1 1 2 1 # size 3 2 2 #",
        "2 12 -2 0 -1 1 2 1 # width 3, height 2, depth 2 #",
        "2 12 0 0 0 2 2 2 # cube 2 x 2 x 2 #",
        "2 12 -1 0 -1 1 1 1 # cube #",
        "2 12 -1 0 -1 1 2 1 # cube with edge 2 #",
        "2 12 -2 0 -2 2 2 2 # cube #",
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

#[test]
fn a_cone_by_its_height_and_radius() {
    for said in ["cone, radius 1, height 2", "kužel, výška 2, poloměr 1"] {
        let [written, meant] = ["1 2", "2 1"].map(|numbers| format!("2 16 {numbers} # {said} #"));
        expect(Code::W341, &[(&written, &[&meant])]);
    }
    for records in [
        "2 16 1 2 # radius 2, height 1 #",
        "2 16 1 2 # radius 1 #",
        "2 16 1 2 # radius 3, height 2 #",
        "2 16 -1 2 # radius -1, height 2 #",
    ] {
        assert!(!has(&scene(records), Code::W341), "{records}");
    }
}

const BOX: &str = "2 12 -1 0 -1 1 2 1";

#[test]
fn a_light_that_is_no_point() {
    for said in ["ambient", "okolní světlo", "ambientní", "ambient light"] {
        let text = |code: &str| format!("{BOX}\n51 {code} 0.2 # {said} #");
        expect(Code::W344, &[(&text("-402"), &[&text("-401")])]);
    }
    for light in [
        "51 -402 0.2 # ambient #\n51 -1 4 6 5",
        "51 -402 0.2 # a lamp with little ambient light #",
        "51 -402 0.2 # bodové, ne okolní #",
        "51 -402 0.2 # lamp #",
        "51 -401 0.2 # ambient #",
    ] {
        let text = scene(&format!("{BOX}\n{light}"));
        assert!(!has(&text, Code::W344), "{light}");
    }
    // A move behind ambient light is an error.
    for said in ["lamp", "bodové světlo, lampa"] {
        let text = |code: &str| format!("{BOX}\n51 {code} 0.8 # {said} #\n51 -1 4 6 5");
        let (_, made) = guessed(&scene(&text("-401")), Code::E103);
        assert_eq!(made[0], scene(&text("-402")));
    }
}

#[test]
fn a_rotation_about_another_axis() {
    for said in [
        "about y",
        "around y",
        "kolem osy y",
        "45° around the Y-axis",
        "rotace okolo y",
        "osa y",
        "rotate y by 45 degrees",
    ] {
        let text = |axis: u32| format!("{BOX}\n2 -2 45 {axis} # {said} #");
        expect(
            Code::W344,
            &[(&text(1), &[&text(2)]), (&text(3), &[&text(2)])],
        );
        assert!(!has(&scene(&text(2)), Code::W344), "{said}");
    }
    // A vertical axis is y where that is up for the camera, and a comment says the axis where its number is none.
    for said in ["okolo svislé osy", "about the vertical axis", "svislá osa"] {
        let text = |axis: u32| format!("{BOX}\n2 -2 45 {axis} # {said} #");
        expect(Code::W344, &[(&text(1), &[&text(2)])]);
        expect(Code::E205, &[(&text(0), &[&text(2)])]);
        let on_side = scene(&text(1)).replace("-1 0 1 0 40", "-1 0.5 1 0 40");
        assert!(!has(&on_side, Code::W344), "{said}");
    }
    for said in ["otočit okolo osy x", "about x"] {
        let text = |axis: u32| format!("{BOX}\n2 -2 45 {axis} # {said} #");
        expect(Code::E205, &[(&text(0), &[&text(1)])]);
    }
    for said in [
        "along the y axis",
        "about x, then y",
        "so that y is up",
        "around its y axis",
        "kolem své osy y",
        "around the y axis of the box",
        "not about y",
        "z boku",
        "y",
    ] {
        let text = scene(&format!("{BOX}\n2 -2 45 1 # {said} #"));
        assert!(!has(&text, Code::W344), "{said}");
    }
}

#[test]
fn a_rotation_whose_comment_has_degrees() {
    for (radians, said, degrees) in [
        ("0.35", "20 degrees", "20"),
        ("0.35", "20 stupňů", "20"),
        ("0.35", "o 20° kolem y", "20"),
        ("-0.35", "-20°", "-20"),
        ("0.131", "7,5°", "7.5"),
        ("0.63", "π/5", "36"),
    ] {
        let text = |angle: &str| format!("{BOX}\n2 -2 {angle} 2 # {said} #");
        expect(Code::N607, &[(&text(radians), &[&text(degrees)])]);
    }
    for said in ["20", "2 degrees", "0.35 degrees", "-20°", "pi/4", "3*pi/5"] {
        let text = scene(&format!("{BOX}\n2 -2 0.35 2 # {said} #"));
        assert!(!has(&text, Code::N607), "{said}");
    }
}

#[test]
fn a_colour_of_another_name() {
    for (written, said, meant) in [
        ("0 0 1", "red", "1 0 0"),
        ("0 0 1", "červená koule", "1 0 0"),
        ("0.1 0.9 0.1", "the red ball", "1 0 0"),
        ("1 0 0", "modrá", "0 0 1"),
        ("1 0 0", "yellow", "1 1 0"),
        ("0 1 1", "purpurová", "1 0 1"),
        ("0 1 0", "white floor", "1 1 1"),
    ] {
        let text = |numbers: &str| format!("{BOX}\n2 -701 {numbers} # {said} #");
        expect(Code::W344, &[(&text(written), &[&text(meant)])]);
    }
    for colour in [
        "0 0 1 # blue #",
        "0 0 1 # dark red #",
        "0 0 1 # light red #",
        "0 0 1 # tmavě červená #",
        "0 0 1 # reddish #",
        "0 0 1 # red and blue #",
        "0 0 1 # not red #",
        "0 0 1 # azurová #",
        "1 0.2 0 # orange #",
        "0.2 0.6 1 # blue #",
        "0 1 0 # lime #",
        "0 1 0 # orange tree #",
        "0.4 0.5 0.4 # red #",
        "0 0 1 # block #",
    ] {
        let text = scene(&format!("{BOX}\n2 -701 {colour}"));
        assert!(!has(&text, Code::W344), "{colour}");
    }
}

#[test]
fn a_floor_at_another_height() {
    let floor = |d: &str, said: &str| format!("3 4 0 1 0 {d} # {said} #\n4 11 0 2 0 1\n2 -101 3 4");
    for said in ["floor at y = 1", "podlaha y=1", "y = 1,0"] {
        expect(Code::W344, &[(&floor("1", said), &[&floor("-1", said)])]);
    }
    let below = "floor at y = −0.5";
    expect(
        Code::W344,
        &[(&floor("-0.5", below), &[&floor("0.5", below)])],
    );
    let wall = |d: &str| format!("{BOX}\n3 3 2 0 0 {d} # wall x = -3 #\n4 -101 2 3");
    expect(Code::W344, &[(&wall("-6"), &[&wall("6")])]);
    for said in [
        "floor at y = -1",
        "y = 2",
        "x = 1",
        "x + y = 1",
        "y = 1 - 2",
        "normála y = 1",
        "d = 1",
        "y == 1",
    ] {
        assert!(!has(&scene(&floor("1", said)), Code::W344), "{said}");
    }
    for records in [
        floor("1", "y = 1") + "\n3 -1 0 2 0",
        floor("1", "y = 1") + "\n2 -1 0 2 0",
    ] {
        assert!(!has(&scene(&records), Code::W344), "{records}");
    }
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
