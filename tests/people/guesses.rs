//! Guesses and fixes of layout that newcomers found to be wrong, in short scenes.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Fix, Language, fixes};
use zpg::internals::format::{Options, format};

use super::read;

fn fixed(text: &str, unsafe_too: bool) -> String {
    let mended = fixing::to_fixed_point(read(text), unsafe_too, Analysis::of);
    mended.analysis.source.text.clone()
}

/// What each fix of the first finding with a code makes of a text.
#[track_caller]
fn proposals(text: &str, code: Code) -> Vec<(Fix, String)> {
    let all = repair::proposals(&read(text));
    let finding = all.iter().find(|d| d.code == code);
    let finding = finding.unwrap_or_else(|| panic!("{text}\n{all:?}"));
    let made = |fix: &Fix| (fix.clone(), fixes::apply(text, std::iter::once(fix)).0);
    finding.fixes.iter().map(made).collect()
}

#[track_caller]
fn first(text: &str, code: Code) -> String {
    let all = proposals(text, code);
    all.first().unwrap_or_else(|| panic!("{text}")).1.clone()
}

/// What the first proposal for the first finding with a code says, in English and in Czech.
#[track_caller]
fn first_said(text: &str, code: Code) -> [String; 2] {
    let all = repair::proposals(&read(text));
    let finding = all.iter().find(|d| d.code == code);
    let finding = finding.unwrap_or_else(|| panic!("{text}\n{all:?}"));
    [Language::English, Language::Czech].map(|l| finding.wording(l).fixes[0].clone())
}

fn codes(text: &str) -> Vec<Code> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).map(|d| d.code).collect()
}

#[test]
fn a_short_camera_takes_no_whole_records() {
    let text = "2 9 1\n9 -501 0 2 10 0 0 -1 45\n50 -402 0.9\n1 9999 2 0\n";
    assert_eq!(codes(text), [Code::E008]);
    let text = "2 9 1\n9 -501 0 0 10 0 0 -1 45\n50 -402 3 3 3\n1 9999 2 0\n";
    assert_eq!(codes(text), [Code::E008, Code::E009]);
    assert_eq!(fixed(text, false), text);
}

#[test]
fn a_doubtful_record_keeps_its_layout() {
    let text = "2 9 1\n4 -101 2 2 3 3\n5 14 3 1\n6 -101 4 3\n1 9999 6 0\n";
    let analysis = read(text);
    let with = |code| analysis.findings().iter().find(move |d| d.code == code);
    assert!(with(Code::W314).is_some());
    assert!(with(Code::S503).is_some_and(|d| d.fixes.is_empty()));
    assert_eq!(format(text, &analysis.document, &Options::default()), text);
    assert_eq!(fixed(text, true), text);
    // On another line nothing is in doubt.
    let apart = text.replace("1 9999 6 0\n", "7 9 2 8 9 3\n1 9999 6 0\n");
    assert!(fixed(&apart, false).contains("\n7 9 2\n8 9 3\n"));
}

#[test]
fn what_a_broken_record_hid_stops_no_fix() {
    let text = "3 11 0 2,5 0 1\n3 11 0 3 0 1\n1 9999 3 0\n";
    assert_eq!(fixed(text, false), text.replace("2,5", "2.5"));
    let text = "3 -701 modrá\n2 9 1\n3 9 2\n4 -101 2 3\n1 9999 4 0\n";
    let meant = "2 9 1\n3 9 2\n3 -701 0 0 1\n4 -101 2 3\n1 9999 4 0\n";
    assert_eq!(fixed(text, true), meant);
}

#[test]
fn a_material_by_the_id_of_a_colour_gets_an_id_of_its_own() {
    let text = "3 -701 0.5 0 0\n3 -201 1 0 0\n2 9 1\n2 -299 3 0\n1 9999 2 0\n";
    let meant = "3 -701 0.5 0 0\n4 -201 1 0 0\n2 9 1\n2 -299 3 4\n1 9999 2 0\n";
    assert_eq!(fixed(text, true), meant);
    let other = "3 -201 1 0 0\n3 -701 0.5 0 0\n2 9 1\n2 -299 0 3\n1 9999 2 0\n";
    let meant = "3 -201 1 0 0\n4 -701 0.5 0 0\n2 9 1\n2 -299 4 3\n1 9999 2 0\n";
    assert_eq!(fixed(other, true), meant);
    // A lamp has a colour and no index.
    let lamp = "2 9 1\n5 -402 1\n5 -203 1 0 0\n1 9999 2 0\n";
    let made = proposals(lamp, Code::E103);
    assert!(made.iter().any(|m| m.1 == lamp.replace("-203", "-701")));
}

#[test]
fn a_missing_operand_is_the_object_that_is_left() {
    let text = "2 9 1\n3 9 2\n4 -101 2\n1 9999 4 0\n";
    assert_eq!(fixed(text, true), text.replace("-101 2", "-101 2 3"));
    for operation in ["-102", "-103"] {
        let text = text.replace("-101", operation);
        let made = proposals(&text, Code::E008);
        assert!(
            !made.is_empty()
                && made
                    .iter()
                    .all(|m| m.1.contains(&format!("4 {operation} ")))
        );
    }
    // With nothing left it may be a complement.
    let alone = "2 9 1\n4 -101 2\n1 9999 4 0\n";
    assert_eq!(first(alone, Code::E008), alone.replace("-101", "-104"));
}

#[test]
fn a_scaling_of_two_numbers_stays_a_scaling() {
    let text = "2 9 1\n2 -3 2 3\n1 9999 2 0\n";
    let made = proposals(text, Code::E008);
    let texts: Vec<&str> = made.iter().map(|m| m.1.as_str()).collect();
    let meant = ["2 3 1", "2 3 3"].map(|numbers| text.replace("2 3", numbers));
    assert_eq!(texts, meant);
    assert!(
        made.iter()
            .all(|m| m.0.applicability == Applicability::Choice)
    );
    assert_eq!(fixed(text, true), text);
    assert!(proposals(&text.replace("-3 2 3", "-1 30 2"), Code::E008).is_empty());
}

#[test]
fn a_direction_of_length_1_is_one() {
    let scene =
        |direction: &str| format!("2 9 1\n9 -501 0 2 10 {direction} 45\n50 -402 0.9\n1 9999 2 0\n");
    let camera = |direction: &str| {
        let text = first(&scene(direction), Code::E008);
        text.lines().nth(1).unwrap().to_owned()
    };
    assert_eq!(camera("0 0 -1"), "9 -501 0 2 10 0 0 -1 0 1 0 45");
    assert_eq!(
        camera("0 -0.196 -0.981"),
        "9 -501 0 2 10 0 -0.196 -0.981 0 1 0 45"
    );
    assert_eq!(camera("0 0 0"), "9 -501 0 2 10 0 -2 -10 0 1 0 45");
    // Upwards nothing is seen: it is the point 1 above the origin.
    assert_eq!(camera("0 1 0"), "9 -501 0 2 10 0 -1 -10 0 1 0 45");
}

#[test]
fn a_second_definition_may_have_the_next_id() {
    let text = "12 9 1\n12 11 4 0 0 1\n1 9999 12 0\n";
    assert_eq!(first(text, Code::E102), text.replace("12 11", "13 11"));
    let thrice = "12 9 1\n12 11 4 0 0 1\n12 11 8 0 0 1\n1 9999 12 0\n";
    let mended = "12 9 1\n13 11 4 0 0 1\n14 11 8 0 0 1\n1 9999 12 0\n";
    assert_eq!(fixed(thrice, true), mended);
}

/// A line that ends a scene of a ball, and what it was meant to be.
#[test]
fn words_and_angles_are_what_they_say() {
    for (line, code, meant) in [
        ("2 -701 tmavě modrá", Code::E003, "2 -701 0 0 0.216"),
        ("2 -701 rgb(255,0,0)", Code::E003, "2 -701 1 0 0"),
        ("2 -701 čevená", Code::E003, "2 -701 1 0 0"),
        ("2 otoceni 90 y", Code::E006, "2 -2 90 2"),
        ("2 otočení y 90", Code::E006, "2 -2 90 2"),
        ("2 zrcadlo", Code::E006, "2 -201 0 1 0"),
        ("2 glass", Code::E006, "2 -201 0 0.1 0.9"),
        ("2 -2 pi/2 3", Code::E012, "2 -2 90 3"),
        ("2 -2 PI/4 1", Code::E012, "2 -2 45 1"),
        ("2 -2 -π/2 1", Code::E012, "2 -2 -90 1"),
        ("2 -2 2*pi/3 1", Code::E003, "2 -2 120 1"),
        // What is wrong with the ID comes to light when the axis is right.
        ("22 -2 90 y", Code::E012, "22 -2 90 2"),
    ] {
        let text = format!("2 9 1\n{line}\n1 9999 2 0\n");
        // A name for a type is one guess, what follows it another.
        let made = match code {
            Code::E006 => fixed(&text, true),
            _ => first(&text, code),
        };
        let numbers = |line: &str| -> Vec<String> {
            let numbers = line.split(' ').map(|n| n.parse::<f64>().unwrap());
            numbers.map(|n| format!("{n:.3}")).collect()
        };
        assert_eq!(
            numbers(made.lines().nth(1).unwrap()),
            numbers(meant),
            "{line}"
        );
    }
    // A certain mistake on the line hides no other one.
    let text = "2 koule 0 1 0 1,5\n1 9999 2 0\n";
    assert_eq!(first(text, Code::E006), text.replace("koule", "11"));
    assert_eq!(fixed(text, true), "2 11 0 1 0 1.5\n1 9999 2 0\n");
}

#[test]
fn two_types_with_a_wrong_digit_are_in_a_scene() {
    let text = "2 11 0 1 0 1\n50 -404 0.9\n1 999 2 0\n";
    assert!(read(text).is_scene());
    let table = "2 11 0 1 0 1\n50 -444 0.9\n1 777 2 0\n";
    assert!(!read(table).is_scene());
}

#[test]
fn a_material_may_be_that_of_the_only_object_without_one() {
    let property = |line: &str, assigned: &str| {
        let text = format!("2 9 1\n{line}\n1 9999 2 0\n");
        let meant = format!("2 9 1\n{line}\n{assigned}\n1 9999 2 0\n");
        assert_eq!(fixed(&text, true), meant);
        assert_eq!(fixed(&text, false), text);
    };
    property("3 -201 1 0 0", "2 -299 0 3");
    property("3 -701 1 0 0 # red #", "2 -299 3 0");
    // It may be either's, and what a union has is its parts', too.
    for text in [
        "2 9 1\n4 9 2\n5 -101 2 4\n3 -201 1 0 0\n1 9999 5 0\n",
        "2 9 1\n4 -104 2\n3 -201 1 0 0\n6 -201 0 1 0\n4 -299 0 6\n1 9999 4 0\n",
        "2 9 1\n3 -201 1 0 0\n6 -201 0 1 0\n1 9999 2 0\n",
    ] {
        assert_eq!(fixed(text, true), text);
    }
}

/// The only colour that nothing has is the background where the render record lacks it, or a comment says so.
#[test]
fn a_colour_that_nothing_has_may_be_the_background() {
    let ball = "2 11 0 0 0 1\n2 -701 1 0 0\n";
    let view = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n";
    let plain = "5 -701 0.5 0.7 0.9\n";
    let two = "5 -701 0.5 0.7 0.9 # Obloha #\n6 -701 0 0 1\n";
    let neither = "5 -701 0.5 0.7 0.9\n6 -701 0 0 1\n";
    let used = "5 -701 0.5 0.7 0.9\n2 -299 5 0\n";
    for (colours, background) in [(plain, 5), (two, 5), (neither, 0), (used, 0), ("", 0)] {
        let of = |record: &str| format!("{ball}{colours}{view}{record}");
        let meant = of(&format!("1 9999 2 {background}\n"));
        assert_eq!(first(&of("1 9999 2\n"), Code::E008), meant);
        assert_eq!(first(&of(""), Code::E106).trim_end(), meant.trim_end());
    }
    // Where the render record has none, it is meant only if a comment says so.
    for (colour, is_taken) in [(plain, false), ("5 -701 0.5 0.7 0.9 # the sky #\n", true)] {
        let text = format!("{ball}{colour}{view}1 9999 2 0\n");
        let meant = text.replace("9999 2 0", "9999 2 5");
        assert_eq!(first(&text, Code::W310), meant);
        assert_eq!(fixed(&text, true), if is_taken { meant } else { text });
    }
    // The object without a colour comes first.
    let bare = format!("2 11 0 0 0 1\n{plain}{view}1 9999 2 0\n");
    let both = proposals(&bare, Code::W310);
    assert_eq!(both.len(), 2);
    assert!(both[0].1.contains("\n2 -299 5 0\n"), "{}", both[0].1);
    assert!(both[1].1.ends_with("1 9999 2 5\n"), "{}", both[1].1);
}

/// A mirror, a ball of glass, and an index with the mirror's ID.
#[test]
fn an_index_on_a_mirror_is_that_of_the_glass() {
    let scene = |glass: &str, index: &str| {
        let mirror = "2 11 -1 1 0 0.9\n2 -201 0.1 0.9 0\n5 11 3 1 0 0.9\n";
        let rest = "4 -101 2 3\n6 -101 4 5\n9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n";
        format!("{mirror}{glass}{index} -203 1.5 1.5 1.5\n{rest}50 -1 4 6 5\n1 9999 6 0\n")
    };
    let glass = "3 11 1 1 0 0.9\n3 -201 0.05 0.1 0.85\n";
    assert_eq!(first(&scene(glass, "2"), Code::W318), scene(glass, "3"));
    // Of two the one right above.
    let both = format!("5 -201 0.05 0.1 0.85\n{glass}");
    assert_eq!(first(&scene(&both, "2"), Code::W318), scene(&both, "3"));
    // What has an index, and what is opaque, was not meant; and of two that stand further above nobody can tell.
    let indexed = format!("{glass}3 -203 1.3 1.3 1.3\n");
    let apart = format!("{both}2 -701 1 0 0\n");
    for other in [&indexed, "3 11 1 1 0 0.9\n3 -201 0.5 0.5 0\n", &apart] {
        assert_eq!(proposals(&scene(other, "2"), Code::W318).len(), 0);
    }
}

/// The floor's normal is upside down: the camera is in it, and so is the glass.
#[test]
fn a_solid_around_the_camera_is_not_split() {
    let text = "2 4 0 -1 0 0\n3 11 0 1 0 1\n3 -201 0.05 0.1 0.85\n3 -203 1.5 1.5 1.5\n\
                4 -101 2 3\n9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n\
                1 9999 4 0\n";
    let all = repair::proposals(&read(text));
    assert!(all.iter().all(|d| d.code != Code::W307), "{all:?}");
    assert!(all.iter().any(|d| d.code == Code::W325), "{all:?}");
    assert_eq!(fixed(text, true), text);
    // With the floor below, a ball that reaches into it is told.
    let below = text
        .replace("0 -1 0 0", "0 1 0 0")
        .replace("0 1 0 1", "0 0.5 0 1");
    let all = repair::proposals(&read(&below));
    assert!(all.iter().any(|d| d.code == Code::W307), "{all:?}");
}

/// A camera whose position and direction stand in each other's place is inside of the floor.
#[test]
fn a_camera_in_a_solid_may_have_its_position_last() {
    let with = |solid: &str, camera: &str| {
        format!(
            "2 12 -1 0 -1 1 2 1\n{solid}\n4 -101 2 3\n9 -501 {camera} 0 1 0 40\n50 -402 0.9\n\
             50 -1 4 6 5\n1 9999 4 0\n"
        )
    };
    for floor in ["3 12 -8 -1 -8 8 0 8", "3 4 0 1 0 0"] {
        let text = with(floor, "0 -0.2 -1 0 3 12");
        let made = proposals(&text, Code::W325);
        assert_eq!(made[0].1, with(floor, "0 3 12 0 -0.2 -1"));
        assert_eq!(made[0].0.applicability, Applicability::Choice);
        assert_eq!(
            first_said(&text, Code::W325),
            [
                "swap position and direction: write `0 3 12 0 -0.2 -1`",
                "prohodit polohu a směr: napsat `0 3 12 0 -0.2 -1`"
            ]
        );
        assert_eq!(fixed(&text, true), text);
    }
    let is_proposed = |camera: &str| {
        let made = proposals(&with("3 12 -8 -1 -8 8 0 8", camera), Code::W325);
        made.iter().any(|m| m.0.title == "fix-place-and-view")
    };
    // The direction is no place; it is one in a solid; nothing is seen from there.
    for camera in ["0 -0.2 -1 0 0 -1", "0 -0.2 -1 6 -0.5 6", "0 -0.2 1 0 3 12"] {
        assert!(!is_proposed(camera), "{camera}");
    }
}

/// A camera in the floor, of which the minus of y is too much: it is not turned to look out of there.
#[test]
fn a_camera_in_a_floor_has_another_sign() {
    let with = |floor: &str, camera: &str| {
        let rest = "50 -402 0.9\n50 -1 4 6 5\n1 9999 4 0\n";
        format!("2 11 0 1 0 1\n{floor}\n4 -101 2 3\n9 -501 {camera} 0 1 0 40\n{rest}")
    };
    for floor in ["3 4 0 1 0 0", "3 12 -9 -3 -9 9 0 9"] {
        let text = with(floor, "0 -2.5 8 0 -0.2 -1");
        let meant = with(floor, "0 2.5 8 0 -0.2 -1");
        assert_eq!(first(&text, Code::W325), meant);
        assert_eq!(
            first_said(&text, Code::W325),
            [
                "change the sign of y of the camera: write `0 2.5 8`",
                "změnit znaménko y kamery: napsat `0 2.5 8`"
            ]
        );
        assert_eq!(fixed(&text, true), meant);
        let all = repair::proposals(&read(&text));
        let turned = all.iter().filter(|d| d.code == Code::W324);
        assert_eq!(turned.flat_map(|d| &d.fixes).count(), 0, "{text}");
    }
    // It would see nothing from there.
    let away = with("3 4 0 1 0 0", "0 -2.5 8 0 0.2 1");
    assert_eq!(proposals(&away, Code::W325).len(), 0);
}

/// A ball beside the picture that has lost a decimal point: both languages name the number.
#[test]
fn a_coordinate_without_its_decimal_point() {
    let scene = |x: &str| {
        let balls = format!("2 11 -1 0 0 0.8\n3 11 1 0 0 0.8\n4 11 {x} 2 0 0.8\n");
        let rest = "9 -501 0 0 9 0 0 -1 0 1 0 45\n50 -402 0.9\n50 -1 3 5 5\n1 9999 6 0\n";
        format!("{balls}5 -101 2 3\n6 -101 5 4\n{rest}")
    };
    let text = scene("30");
    assert_eq!(first(&text, Code::N608), scene("3.0"));
    assert_eq!(
        first_said(&text, Code::N608),
        [
            "write `3.0`, with a decimal point",
            "napsat `3.0`, s desetinnou tečkou"
        ]
    );
    let then = repair::proposals(&read(&scene("3.0")));
    assert!(then.iter().all(|d| d.code != Code::N608), "{then:?}");
}

/// A plane that hides an object from the camera, and what was meant: the other sign of d, or a floor that lies.
#[test]
fn a_plane_that_hides_an_object() {
    let scene = |lines: &str| {
        let rest = "50 -402 0.9\n50 -1 4 6 5\n1 9999 4 0\n";
        format!("{lines}\n4 -101 2 3\n9 -501 0 3 9 0 -0.3 -1 0 1 0 40\n{rest}")
    };
    for (lines, meant, titles) in [
        (
            "2 11 0 0 0 1\n3 3 0 1 0 -1",
            "2 11 0 0 0 1\n3 3 0 1 0 1",
            [
                "change the sign of d: write `0 1 0 1`",
                "změnit znaménko d: napsat `0 1 0 1`",
            ],
        ),
        (
            "2 11 0 1 -3 1\n3 3 0 0 1 0 # floor #",
            "2 11 0 1 -3 1\n3 3 0 1 0 0 # floor #",
            [
                "lay the floor across the y axis: write `0 1 0`",
                "položit podlahu kolmo k ose y: napsat `0 1 0`",
            ],
        ),
    ] {
        let text = scene(lines);
        assert_eq!(first(&text, Code::W335), scene(meant));
        assert_eq!(first_said(&text, Code::W335), titles);
        let then = repair::proposals(&read(&scene(meant)));
        assert!(then.iter().all(|d| d.code != Code::W335), "{then:?}");
    }
    // The other plane would hide it, too, or the lamp.
    for lines in [
        "2 11 0 -4 0 1\n3 3 0 1 0 -1",
        "2 11 0 -9 0 1\n3 3 0 1 0 5.5",
    ] {
        assert_eq!(proposals(&scene(lines), Code::W335).len(), 0, "{lines}");
    }
    // Glass or a mirror may show it.
    for more in ["3 -201 0.5 0 0.5", "2 -201 0.5 0.5 0"] {
        let text = scene(&format!("2 11 0 0 0 1\n3 3 0 1 0 -1\n{more}"));
        let all = repair::proposals(&read(&text));
        assert!(all.iter().all(|d| d.code != Code::W335), "{all:?}");
    }
}

#[test]
fn a_second_move_of_a_lamp_is_that_of_the_next_one() {
    let scene = |lamps: &str| {
        let rest = "2 11 0 0 -3 1\n9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n";
        format!("{rest}{lamps}\n1 9999 2 0\n")
    };
    let one = "50 -402 0.9\n50 -1 4 6 5\n51 -402 0.4\n";
    let slip = scene(&format!("{one}50 -1 -4 6 5"));
    let meant = scene(&format!("{one}51 -1 -4 6 5"));
    assert_eq!(first(&slip, Code::W336), meant);
    assert_eq!(fixed(&slip, true), meant);
    let coloured = scene(&format!("{one}51 -701 1 1 0.5\n50 -1 -4 6 5"));
    assert_eq!(
        first(&coloured, Code::W336),
        coloured.replace("50 -1 -4", "51 -1 -4")
    );
    for right in [
        &meant,
        // The other one is moved below, or 50 has no place yet.
        &scene(&format!("{one}50 -1 -4 6 5\n51 -1 1 1 1")),
        &scene("50 -402 0.9\n51 -402 0.4\n50 -1 -4 6 5"),
        // Both moves are written before the next lamp.
        &scene("50 -402 0.9\n50 -1 4 6 5\n50 -1 0 1 0\n51 -402 0.4"),
    ] {
        let all = repair::proposals(&read(right));
        assert!(all.iter().all(|d| d.code != Code::W336), "{right}\n{all:?}");
    }
    let finding = repair::proposals(&read(&slip))
        .into_iter()
        .find(|d| d.code == Code::W336);
    let finding = finding.expect("a finding");
    for (language, message) in [
        (
            Language::English,
            "the point light 50 is moved a second time, and 51 right above is not moved",
        ),
        (
            Language::Czech,
            "bodové světlo 50 se posouvá podruhé a 51 hned nad tím vůbec",
        ),
    ] {
        assert_eq!(finding.wording(language).message, message);
    }
}

#[test]
fn a_move_of_a_shape_with_a_place_is_that_of_the_next_one() {
    let scene = |shapes: &str| {
        let rest = "9 -501 0 3 9 0 -0.2 -1 0 1 0 45\n50 -402 0.9\n50 -1 4 6 5\n1 9999 23 0\n";
        format!("{shapes}23 -101 21 22\n{rest}")
    };
    let slip = scene("21 11 -1.2 1 0 1\n22 14 0.6 0.2\n21 -1 1.2 0.2 1.4\n");
    let meant = scene("21 11 -1.2 1 0 1\n22 14 0.6 0.2\n22 -1 1.2 0.2 1.4\n");
    assert_eq!(first(&slip, Code::W336), meant);
    assert_eq!(fixed(&slip, true), meant);
    for right in [
        &meant,
        // 21 is at the origin, or 22 is not; 21 has a move above; 22 is moved below, or copied.
        &scene("21 9 1\n22 14 0.6 0.2\n21 -1 1.2 0.2 1.4\n"),
        &scene("21 11 -1.2 1 0 1\n22 11 2 1 0 0.6\n21 -1 1.2 0.2 1.4\n"),
        &scene("21 11 -1.2 1 0 1\n21 -3 1 2 1\n22 14 0.6 0.2\n21 -1 1.2 0.2 1.4\n"),
        &scene("21 11 -1.2 1 0 1\n22 14 0.6 0.2\n21 -1 1.2 0.2 1.4\n22 -1 2 0 0\n"),
        &scene("21 11 -1.2 1 0 1\n22 14 0.6 0.2\n21 -1 1.2 0.2 1.4\n24 -105 22\n"),
        // The move stands right below its own shape.
        &scene("22 14 0.6 0.2\n21 11 -1.2 1 0 1\n21 -1 1.2 0.2 1.4\n"),
    ] {
        let all = repair::proposals(&read(right));
        assert!(all.iter().all(|d| d.code != Code::W336), "{right}\n{all:?}");
    }
    let all = repair::proposals(&read(&slip));
    let finding = all.iter().find(|d| d.code == Code::W336);
    let finding = finding.expect("a finding");
    for (language, message) in [
        (
            Language::English,
            "21 is moved here, and the torus 22 right above is not moved",
        ),
        (
            Language::Czech,
            "zde se posouvá 21 a torus 22 hned nad tím vůbec",
        ),
    ] {
        assert_eq!(finding.wording(language).message, message);
    }
}

#[test]
fn what_changes_a_second_definition_goes_with_it() {
    let camera = "9 -501 0 3 12 0 -0.2 -1 0 1 0 45\n";
    let lamp = "50 -402 1\n50 -1 4 6 5\n";
    // The ID 4 is used and defined nowhere.
    let text = format!(
        "2 11 0 0 0 1\n2 -701 1 0 0\n2 12 2 0 0 3 1 1\n2 -701 0 0 1\n2 -1 0 1 0\n3 -101 2 4\n2 -1 5 0 0\n\
         {camera}{lamp}1 9999 3 0\n"
    );
    let second = "2 12 2 0 0 3 1 1\n2 -701 0 0 1\n2 -1 0 1 0\n";
    assert_eq!(
        fixed(&text, true),
        text.replace(second, &second.replace("2 1", "4 1").replace("2 -", "4 -"))
    );
    // Nothing is undefined, so each gets the next free one.
    for second in [
        "50 -402 0.5\n50 -1 -4 6 5\n",
        "9 -501 1 3 12 0 -0.2 -1 0 1 0 45\n9 -1 0 1 0\n",
    ] {
        let text = format!("2 9 1\n{camera}{lamp}{second}1 9999 2 0\n");
        let id = second.split(' ').next().unwrap();
        let new = second.replace(&format!("{id} -"), "51 -");
        assert_eq!(first(&text, Code::E102), text.replace(second, &new));
    }
}

#[test]
fn an_id_that_a_comment_defines_is_no_other() {
    let lamp = "9 -501 0 3 12 0 -0.2 -1 0 1 0 45\n50 -402 1\n50 -1 4 6 5\n";
    for behind in ["1 9999 4 0\n", "4 -1 1 0 0\n5 -101 2 4\n1 9999 5 0\n"] {
        let text = format!("2 11 0 0 0 1 # a 1\n3 11 2 0 0 1\n4 -101 2 3 #\n{lamp}{behind}");
        let all = repair::proposals(&read(&text));
        let said = all
            .iter()
            .filter(|d| d.code == Code::E101)
            .collect::<Vec<_>>();
        assert!(!said.is_empty(), "{all:?}");
        for d in said {
            assert!(d.fixes.is_empty(), "{d:?}");
            let help = "ID 4 is defined inside the comment that begins on line 1";
            assert_eq!(d.wording(Language::English).help.as_deref(), Some(help));
        }
        assert_eq!(fixed(&text, true), text);
    }
    // What the comment only changes is another matter.
    let text = format!("2 9 1 # a\n4 -701 1 0 0\n4 -1 0 0 1 #\n{lamp}1 9999 4 0\n")
        .replace("4 -701 1 0 0\n", "");
    assert_eq!(fixed(&text, true), text.replace("9999 4", "9999 2"));
}

/// What the guesses for an error say, in English.
#[track_caller]
fn titles(text: &str, code: Code) -> Vec<String> {
    let all = repair::proposals(&read(text));
    let finding = all.iter().find(|d| d.code == code);
    finding.expect(text).wording(Language::English).fixes
}

#[test]
fn a_space_within_a_whole_number() {
    let rest = "2 9 1\n30 -402 0.5\n1 9999 2 0\n";
    let camera = format!("{rest}40 -501  0 37  0 -0.35 -1  0 1 0  40\n");
    assert_eq!(
        titles(&camera, Code::E008)[0],
        "if a space is missing, write `3 7`"
    );
    let lamp = format!("{rest}30 -1 46 5\n");
    assert_eq!(
        titles(&lamp, Code::E008),
        ["if a space is missing, write `4 6`"]
    );
    // Of two vectors, tens, several numbers, and shares of light.
    for line in [
        "30 -1 40 5",
        "30 -1 46 55",
        "30 -701 25 1",
        "9 -501 0 5 12 0 -1 0 1 0 45",
    ] {
        let text = format!("{rest}{line}\n");
        let all = titles(&text, Code::E008);
        assert!(!all.iter().any(|t| t.contains("space")), "{line}: {all:?}");
    }
}

#[test]
fn keys_of_a_czech_keyboard_are_named() {
    let text = "2 9 1\n2 -1 č 0 0\n1 9999 2 0\n";
    assert_eq!(
        titles(text, Code::E012),
        ["on a Czech keyboard `č` is the key of 4: write `4`"]
    );
}

#[test]
fn an_axis_behind_its_angle_is_in_its_place() {
    let case = |line: &str| {
        let text = format!("7 12 0 0 0 1 1 1\n{line}\n1 9999 7 0\n");
        let all = repair::proposals(&read(&text)).into_iter();
        let case = all.filter(|d| d.code == Code::E012).map(|d| d.case);
        case.collect::<Vec<_>>()
    };
    assert_eq!(case("7 -2 90 x"), ["axis"]);
    assert_eq!(case("7 -2 x 90"), ["axis-first"]);
}

#[test]
fn a_word_before_a_vector_in_brackets_goes_with_these() {
    let scene = "2 11 0 0 0 1\n13 -701 rgb <0.25, 0.45, 0.75>\n2 -299 13 0\n9 -501 0 0 5 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    assert_eq!(repair::proposals(&read(scene)).len(), 1);
    for (_, made) in proposals(scene, Code::E012) {
        assert!(!made.contains(['<', '>']), "{made}");
    }
    assert!(first(scene, Code::E012).contains("\n13 -701 0.25 0.45 0.75\n"));
}

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 ID 0\n";

fn drawn(text: &str, id: u32) -> String {
    format!("{text}{}", REST.replace("ID", &id.to_string()))
}

/// Four balls, of which any may be joined.
const BALLS: &str = "2 9 1\n3 11 0 1 0 1\n4 11 0 2 0 1\n5 11 1 2 0 1\n";

#[test]
fn a_quadric_that_takes_a_record_for_its_last_row_keeps_its_numbers() {
    for (text, is_row) in [
        ("2 15 1 0 0 0\n0 1 0 0\n0 0 1 0\n2 -2 30 1\n", true),
        ("2 15\n1 0 0 0\n0 1 0 0\n0 0 1 0\n3 14 2 1\n", true),
        ("2 15 1 0 0 0  0 1 0 0  0 0 0 -4\n2 -2 90 1\n", true),
        (
            "2 15 0 0 0 0 2 0 0.5\n2 -2 30 1\n2 -1 2.6 0.8 -0.5\n",
            false,
        ),
    ] {
        let text = drawn(text, 2);
        let all = repair::proposals(&read(&text));
        let with = |code| all.iter().find(move |d| d.code == code).unwrap();
        assert!(with(Code::W304).fixes.is_empty(), "{text}");
        let said = [
            (
                Language::English,
                "takes 16 numbers, here are 12: a row of 4 is missing",
            ),
            (
                Language::Czech,
                "má mít 16 čísel, je jich zde 12: chybí řádek 4 čísel",
            ),
        ];
        for (language, said) in said {
            let words = with(Code::W314).wording(language).message;
            assert_eq!(words.contains(said), is_row, "{words}");
        }
        assert_eq!(fixed(&text, true), text);
        let analysis = read(&text);
        let formatted = format(&text, &analysis.document, &Options::default());
        let (quadric, _) = text.split_once("9 -501").unwrap();
        assert!(formatted.starts_with(quadric), "{formatted}");
    }
    // A row that begins as a record does makes the matrix symmetric here, and a matrix of plain numbers has a safe fix.
    let whole = drawn("2 15\n1 0 0 2\n0 1 0 -2\n0 0 1 30\n2 -2 30 1\n", 2);
    assert!(read(&whole).findings().iter().all(|d| d.code != Code::W314));
    let plain = drawn("2 15\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0.5 -1\n", 2);
    assert!(fixed(&plain, false).contains("0 0 1 0.25\n0 0 0.25 -1\n"));
}

#[test]
fn a_lamp_for_the_last_vertex_is_doubted() {
    let text = drawn("2 6\n0 0 0\n1 0 0\n50 -402 1\n", 2);
    let text = text.replace("50 -402 1\n50 -1 3 5 5\n", "");
    assert!(read(&text).findings().iter().any(|d| d.code == Code::W314));
    // A vertex may look like a ball.
    let vertex = drawn("2 6\n0 0 0\n1 0 0\n3 9 1\n", 2);
    assert!(
        read(&vertex)
            .findings()
            .iter()
            .all(|d| d.code != Code::W314)
    );
}

#[test]
fn three_parts_of_light_above_one_are_an_index() {
    let ball = |lines: &str| drawn(&format!("2 9 1\n{lines}"), 2);
    for (written, meant) in [
        (
            "2 -201 0.1 0.1 0.8\n2 -201 1.5 1.5 1.5\n",
            "2 -201 0.1 0.1 0.8\n2 -203 1.5 1.5 1.5\n",
        ),
        (
            "2 -201 0.1 0.1 0.8\n2 -201 1.33 1.33 1.33\n",
            "2 -201 0.1 0.1 0.8\n2 -203 1.33 1.33 1.33\n",
        ),
        // The two types have changed places.
        (
            "4 -203 0.1 0.1 0.8\n4 -201 1.5 1.5 1.5\n2 -299 0 4\n",
            "4 -201 0.1 0.1 0.8\n4 -203 1.5 1.5 1.5\n2 -299 0 4\n",
        ),
        // The index behind the parts of light.
        (
            "2 -201 0.1 0.1 0.8 1.5\n",
            "2 -201 0.1 0.1 0.8\n2 -203 1.5 1.5 1.5\n",
        ),
        (
            "4 -201 0.1 0.1 0.8 1.51 1.52 1.53\n2 -299 0 4\n",
            "4 -201 0.1 0.1 0.8\n4 -203 1.51 1.52 1.53\n2 -299 0 4\n",
        ),
        ("2 -201 10 85 0\n", "2 -201 0.1 0.85 0\n"),
    ] {
        assert_eq!(fixed(&ball(written), true), ball(meant));
    }
    // It has an index, or is seen through by nobody.
    for text in [
        "2 -201 0.1 0.1 0.8 1.5\n2 -203 1.5 1.5 1.5\n",
        "2 -201 1.5 1.5 1.5\n",
    ] {
        assert_eq!(fixed(&ball(text), true), ball(text));
    }
    let text = ball("4 -203 0.1 0.1 0.8\n4 -201 1.5 1.5 1.5\n2 -299 0 4\n");
    assert_eq!(
        first_said(&text, Code::E206),
        [
            "exchange the types of both records: write `-203` (refractive index) here",
            "vyměnit typy obou záznamů: napsat zde `-203` (index lomu)",
        ]
    );
}

#[test]
fn the_name_of_a_shape_whose_colour_can_be_read_begins_its_record() {
    for (written, meant) in [
        ("sphere { <0, 1, 0>, 1 }", "2 11  0 1 0  1"),
        ("sphere 0 1 0 1", "2 11 0 1 0 1"),
    ] {
        for before in ["", "3 9 2\n"] {
            let text = |line: &str| drawn(&format!("{before}{line}\n2 -701 0.9 0.2 0.1\n"), 2);
            assert_eq!(codes(&text(written)), [Code::E005]);
            assert_eq!(fixed(&text(written), true), text(meant));
        }
    }
}

#[test]
fn operations_on_themselves_get_an_id_each() {
    for (written, meant, id, last) in [
        (
            "6 -101 2 3\n6 -101 6 4\n6 -101 6 5\n",
            "6 -101 2 3\n51 -101 6 4\n52 -101 51 5\n",
            6,
            52,
        ),
        (
            "6 -101 2 3\n6 -101 6 4\n6 -701 1 0 0\n",
            "6 -101 2 3\n51 -101 6 4\n51 -701 1 0 0\n",
            6,
            51,
        ),
        (
            "2 -103 2 3\n2 -103 2 4\n7 -101 2 5\n",
            "51 -103 2 3\n52 -103 51 4\n7 -101 52 5\n",
            7,
            7,
        ),
    ] {
        let text = drawn(&format!("{BALLS}{written}"), id);
        let meant = drawn(&format!("{BALLS}{meant}"), last);
        assert_eq!(codes(&text), [Code::E102]);
        assert_eq!(first(&text, Code::E102), meant);
        assert_eq!(fixed(&text, true), meant);
    }
    let text = drawn(&format!("{BALLS}6 -101 2 3\n6 -101 6 4\n6 -101 6 5\n"), 6);
    assert_eq!(
        first_said(&text, Code::E102),
        [
            "give each of these 2 operations an ID of its own (51, 52), which the next one uses in place of 6",
            "dát každé z těchto 2 operací vlastní ID (51, 52), které místo 6 použije ta další",
        ]
    );
}

#[test]
fn properties_above_their_object_move_behind_it() {
    for (written, meant) in [
        (
            "2 12 -5 -1 -5 5 0 5\n3 -701 1 0 0\n3 -1 1 1 0\n3 9 1\n4 -101 2 3\n",
            "2 12 -5 -1 -5 5 0 5\n3 9 1\n3 -701 1 0 0\n3 -1 1 1 0\n4 -101 2 3\n",
        ),
        (
            "3 -1 1 1 0\n3 -701 1 0 0\n2 9 2\n3 9 1\n4 -101 2 3\n",
            "2 9 2\n3 9 1\n3 -1 1 1 0\n3 -701 1 0 0\n4 -101 2 3\n",
        ),
        (
            "2 9 1\n3 -201 0.5 0.5 0\n3 -701 1 0 0\n3 11 0 1 0 1\n4 -101 2 3\n",
            "2 9 1\n3 11 0 1 0 1\n3 -201 0.5 0.5 0\n3 -701 1 0 0\n4 -101 2 3\n",
        ),
    ] {
        let (text, meant) = (drawn(written, 4), drawn(meant, 4));
        assert_eq!(codes(&text), [Code::E102], "{text}");
        assert_eq!(proposals(&text, Code::E102).len(), 1);
        assert_eq!(fixed(&text, true), meant);
    }
    let two = "3 -701 1 0 0\n3 9 1\n2 -701 1 0 0\n2 -1 0 1 0\n2 9 1\n4 -101 2 3\n";
    let meant = "3 9 1\n3 -701 1 0 0\n2 9 1\n2 -701 1 0 0\n2 -1 0 1 0\n4 -101 2 3\n";
    assert_eq!(fixed(&drawn(two, 4), true), drawn(meant, 4));
    // The colour is that of something else, too.
    let used = drawn("3 -701 1 0 0\n3 9 1\n2 9 1\n4 -101 2 3\n4 -299 3 0\n", 4);
    assert_eq!(fixed(&used, true), used);
    let text = drawn("2 -701 1 0 0\n2 -201 0.5 0.5 0\n2 11 0 1 0 1\n", 2);
    let all = repair::proposals(&read(&text));
    let fixes = |language| all[0].wording(language).fixes[0].clone();
    assert_eq!(
        [fixes(Language::English), fixes(Language::Czech)],
        [
            "move those 2 records below this definition",
            "přesunout ty 2 záznamy pod tuto definici",
        ]
    );
}

#[test]
fn a_colour_by_its_id_takes_no_glass_away() {
    let glass = "2 -201 0 0 1\n2 -203 1.5 1.5 1.5\n";
    for line in ["2 -701 20\n", "2 -299 20\n"] {
        for (before, behind) in [(glass, ""), ("", glass)] {
            let text = |line: &str| {
                drawn(
                    &format!("2 9 1\n20 -701 1 0 0.5\n{before}{line}{behind}"),
                    2,
                )
            };
            assert_eq!(fixed(&text(line), true), text("2 -701 1 0 0.5\n"));
        }
        let plain = |line: &str| drawn(&format!("2 9 1\n20 -701 1 0 0.5\n{line}"), 2);
        assert_eq!(fixed(&plain(line), true), plain("2 -299 20 0\n"));
    }
}

#[test]
fn a_hole_is_defined_behind_what_it_is_made_in() {
    let parts = "2 12 -1 -1 -1 1 1 1\n3 9 1.2\n";
    for written in ["4 -103 3\n", "4 -103 2\n"] {
        let text = drawn(&format!("{parts}{written}"), 4);
        let meant = drawn(&format!("{parts}4 -103 2 3\n"), 4);
        assert_eq!(first(&text, Code::E008), meant);
    }
}

#[test]
fn square_brackets_separate_as_round_ones_do() {
    for brackets in ["[]", "()", "［］"] {
        let [open, close] = Vec::from_iter(brackets.chars())[..] else {
            panic!("{brackets}");
        };
        let text = drawn("2 9 1\n", 2);
        let written = text.replace("3 5 5", &format!("{open}3,5,5{close}"));
        let all = repair::proposals(&read(&written));
        assert_eq!(Vec::from_iter(all.iter().map(|d| d.code)), [Code::S501]);
        assert_eq!(fixed(&written, false), text);
    }
}

#[test]
fn one_of_three_parts_of_light_is_missing() {
    let text = "2 11 0 1 0 1\n2 -201 0.1 0.85\n50 -402 0.9\n1 9999 2 0\n";
    let all = proposals(text, Code::E008);
    let made: Vec<String> = all.iter().map(|(_, made)| made.clone()).collect();
    let with = |parts| text.replace("0.1 0.85", parts);
    assert_eq!(made, [with("0.1 0 0.85"), with("0.1 0.85 0")]);
    assert_eq!(fixed(text, true), text);
    assert!(proposals(&with("0.9 0.85"), Code::E008).is_empty());
}

#[test]
fn a_translation_of_another_object_is_a_copy() {
    let text = "2 11 -2 1 0 1\n3 -1 2  4 0 0\n4 -101 2 3\n50 -402 0.9\n1 9999 4 0\n";
    let meant = text.replace("3 -1 2  4 0 0", "3 -105 2\n3 -1 4 0 0");
    assert_eq!(first(text, Code::E009), meant);
    assert_eq!(fixed(text, true), meant);
    let copied = text.replace("3 -1 2", "3 -105 2");
    assert_eq!(first(&copied, Code::E009), meant);
    // An object that is there is moved.
    let moved = text.replace("3 -1", "3 11 0 1 0 1\n3 -1");
    assert!(!fixed(&moved, true).contains("-105"));
}

#[test]
fn operands_that_are_too_many_are_those_of_the_operation() {
    let shapes = "2 4 0 1 0 0\n3 11 0 1 0 1\n4 11 2 1 0 1\n5 11 -2 1 0 1\n7 11 0 1 2 1\n";
    for operands in ["3 4 5 7 2", "4 3 5 7 2"] {
        let text = format!("{shapes}23 -101 {operands}\n1 9999 23 0\n");
        let all = repair::proposals(&read(&text));
        let finding = all
            .iter()
            .find(|d| d.code == Code::E009)
            .expect("a finding");
        let said = finding.wording(Language::English).message;
        assert!(
            said.contains("a union takes 2 numbers, here are 5"),
            "{said}"
        );
    }
}

#[test]
fn file_names_with_brackets_stand_in_quotes() {
    for name in ["wood[1].png", "wood(1).png", "my wood.png"] {
        let text = format!("2 11 0 1 0 1\n2 -301 {name}\n50 -402 0.9\n1 9999 2 0\n");
        assert_eq!(codes(&text), [Code::E012]);
        let meant = text.replace(name, &format!("\"{name}\""));
        assert_eq!(fixed(&text, true), meant);
    }
}

/// A glass ball on a floor, with what is joined with them.
fn on_a_floor(floor: &str, more: &str) -> String {
    format!(
        "13 -701 0.5 0.7 0.9\n30 4 {floor}\n32 11 1.6 0.3 2 0.8\n32 -201 0.05 0.1 0.85\n\
         32 -203 1.5 1.5 1.5\n43 -101 30 32\n{more}50 -402 0.8\n50 -1 4 6 5\n\
         60 -501 0 3 9 0 -2 -9 0 1 0 40\n1 9999 43 13\n"
    )
}

#[test]
fn the_sign_of_d_of_a_floor_that_overlaps_what_stands_on_it() {
    let text = on_a_floor("0 1 0 -0.5", "");
    let made = proposals(&text, Code::W307);
    let [(turned, meant), (split, _)] = &made[..] else {
        panic!("{made:?}");
    };
    assert_eq!(*meant, on_a_floor("0 1 0 0.5", ""));
    let choices = [turned, split].map(|f| f.applicability);
    assert_eq!(choices, [Applicability::Choice; 2]);
    assert_eq!(fixed(&text, true), text);
    assert!(codes(meant).is_empty());
    assert!(
        !repair::proposals(&read(meant))
            .iter()
            .any(|d| d.code == Code::W307)
    );
    assert_eq!(
        first_said(&text, Code::W307),
        [
            "change the sign of d, for the inside is ax + by + cz + d ≤ 0: write `0 1 0 0.5`",
            "změnit znaménko d, protože vnitřek je ax + by + cz + d ≤ 0: napsat `0 1 0 0.5`",
        ]
    );
    // The second of two balls would be in the floor all the same.
    let lower = "33 11 -2 -0.6 0 0.8\n33 -201 0 0 1\n44 -101 43 33\n";
    for other in [
        on_a_floor("0 1 0 -0.5", lower).replace("9999 43", "9999 44"),
        // The border goes through the origin, or the floor is water.
        on_a_floor("0 1 0 0", ""),
        on_a_floor("0 1 0 -0.5\n30 -201 0.1 0.1 0.8", ""),
    ] {
        for (fix, _) in proposals(&other, Code::W307) {
            assert_eq!(fix.title, "fix", "{other}");
        }
    }
}

#[test]
fn a_direction_that_shows_something_comes_before_a_point() {
    let scene = |camera: &str| {
        format!(
            "30 4 0 1 0 0.5\n31 11 0 1 0 1.5\n43 -101 30 31\n50 -402 0.8\n50 -1 4 6 5\n\
             60 -501 {camera} 40\n1 9999 43 0\n"
        )
    };
    // Both the direction and the point are in sight.
    for (camera, direction, point) in [
        ("0 3 9 0 -2 -9", "0 -2 -9", "0 -5 -18"),
        ("0 2.2 9 0 -0.3 -1.2", "0 -0.3 -1.2", "0 -2.5 -10.2"),
    ] {
        let text = scene(camera);
        let made = proposals(&text, Code::E008);
        let texts: Vec<&String> = made.iter().map(|(_, text)| text).collect();
        let position = camera.strip_suffix(direction).expect(camera);
        let meant = [direction, point].map(|way| scene(&format!("{position}{way} 0 1 0")));
        assert_eq!(texts, meant.iter().collect::<Vec<_>>());
        assert!((made.iter()).all(|(fix, _)| fix.applicability == Applicability::Choice));
        assert_eq!(fixed(&text, true), text);
    }
    for (camera, meant) in [
        ("0 2.2 9 0 -0.2 -1", "0 2.2 9 0 -0.2 -1 0 1 0"),
        // The middle of the ball, and what is above its camera.
        ("0 2 9 0 1 0", "0 2 9 0 -1 -9 0 1 0"),
        ("0 2 9 0.2 0.5 0", "0 2 9 0.2 -1.5 -9 0 1 0"),
        // The point is above all.
        ("0 3 9 0 -2 -7", "0 3 9 0 -2 -7 0 1 0"),
    ] {
        assert_eq!(first(&scene(camera), Code::E008), scene(meant));
    }
}

/// A minus apart from its number: the number with it is the first guess, and the help names it first.
#[test]
fn a_minus_apart_from_its_number() {
    let rest = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 1\n50 -1 4 6 6\n1 9999 2 0\n";
    for (line, meant) in [
        ("2 11 1 - 1.6 0 1", "2 11 1 -1.6 0 1"),
        ("2 4 0 1 0 – 1.6", "2 4 0 1 0 -1.6"),
    ] {
        let text = format!("{line}\n{rest}");
        assert_eq!(first(&text, Code::E001), format!("{meant}\n{rest}"));
        let all = repair::proposals(&read(&text));
        let finding = all.iter().find(|d| d.code == Code::E001).expect(line);
        for (language, help) in [
            (
                Language::English,
                "join it to the number behind it, or remove it",
            ),
            (
                Language::Czech,
                "připojte ho k číslu za ním, nebo ho odstraňte",
            ),
        ] {
            assert_eq!(finding.wording(language).help.as_deref(), Some(help));
        }
    }
    // No sphere has a negative radius.
    let text = format!("2 11 0 1 0 - 1.6\n{rest}");
    assert!(proposals(&text, Code::E001).is_empty());
    // The number of the next line is another record's.
    let text = format!("2 11 0 1 0 1 -\n{rest}");
    let all = repair::proposals(&read(&text));
    assert!(all.iter().all(|d| d.case != "sign"));
}

/// A half-space in which all of an object lies, and what was meant; the next finding is about something else then.
#[test]
fn a_half_space_that_swallows_an_object() {
    let scene = |lines: &str| {
        format!(
            "{lines}\n4 -101 2 3\n9 -501 0 3 8 0 -0.3 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n1 9999 4 0\n"
        )
    };
    let checks = "10 -701 1 0 0\n11 -701 1 1 1\n2 11 2.4 0.9 -1.2 0.9\n2 -399 8 4 10 11\n";
    let ring = "2 14 0.7 0.2\n2 -1 -0.6 0.9 2\n2 -2 80 1\n3 4 0 1 0 0";
    let turned = "2 14 0.7 0.2\n2 -2 80 1\n2 -1 -0.6 0.9 2\n3 4 0 1 0 0";
    for (lines, meant, titles) in [
        (
            format!("{checks}3 4 0 0 1 0 # floor #"),
            format!("{checks}3 4 0 1 0 0 # floor #"),
            [
                "lay the floor across the y axis: write `0 1 0`",
                "položit podlahu kolmo k ose y: napsat `0 1 0`",
            ],
        ),
        (
            "2 11 0 0 0 1\n3 4 0 1 0 -1.5".to_owned(),
            "2 11 0 0 0 1\n3 4 0 1 0 1.5".to_owned(),
            [
                "change the sign of d: write `0 1 0 1.5`",
                "změnit znaménko d: napsat `0 1 0 1.5`",
            ],
        ),
        (
            ring.to_owned(),
            turned.to_owned(),
            [
                "swap the two lines: turn it first, then move it",
                "prohodit oba řádky: nejdřív otočit, potom posunout",
            ],
        ),
    ] {
        let text = scene(&lines);
        let all = repair::proposals(&read(&text));
        assert!(all.iter().all(|d| d.code != Code::W331), "{all:?}");
        assert_eq!(first(&text, Code::W335), scene(&meant));
        assert_eq!(first_said(&text, Code::W335), titles);
        let then = repair::proposals(&read(&scene(&meant)));
        assert!(then.iter().all(|d| d.code != Code::W335), "{then:?}");
    }
    // A wall is no floor, and the swapped lines would leave the ring in the ground.
    for lines in [
        format!("{checks}3 4 0 0 1 0 # wall #"),
        ring.replace("0.9 2", "-1.9 2"),
    ] {
        assert_eq!(proposals(&scene(&lines), Code::W335).len(), 0, "{lines}");
    }
}
