//! A camera whose comment speaks of the point to look at, where the record has a direction.

use zpg::internals::diagnostics::{Code, Language};

use super::{fixed, guessed, read};

/// A scene that ends with a camera at this place, which sees `drawn`.
fn scene(records: &str, place: &str, direction: &str, said: &str) -> String {
    format!(
        "{records}\n9 -501 {place} {direction} 0 1 0 40 # {said} #\n50 -402 0.5\n50 -1 3 6 5\n1 9999 4 0\n"
    )
}

const SNOWMAN: &str = "2 11 0 0.5 0 0.5\n3 11 0.3 0.4 4 0.4\n4 -101 2 3";
const HOUSE: &str = "2 12 -3 0 -2 -1 2 0\n5 11 2 1 -1 1\n6 -101 2 5\n3 4 0 1 0 0\n4 -101 6 3";

fn has(text: &str, code: Code) -> bool {
    read(text).findings().iter().any(|d| d.code == code)
}

/// The point is (0, 1, -1) and the place (0, 2.4, 8), so the direction is (0, -1.4, -9).
#[test]
fn a_point_to_look_at_where_nothing_is_seen() {
    for said in [
        "kamera se dívá na bod 0 1 -1",
        "kamera: poloha, cíl, nahoru, úhel",
        "míří na sněhuláka",
        "looks at 0 1 -1",
        "camera: position, target, up, angle",
        "look at",
    ] {
        let text = |direction: &str| scene(SNOWMAN, "0 2.4 8", direction, said);
        let (_, made) = guessed(&text("0 1 -1"), Code::W324);
        assert_eq!(made[0], text("0 -1.4 -9"), "{said}");
        assert_eq!(fixed(&text("0 1 -1")), made[0], "{said}");
        assert!(read(&made[0]).findings().is_empty(), "{said}");
        let again = made.iter().filter(|text| **text == made[0]);
        assert_eq!(again.count(), 1);
    }
    // Without such a comment, a short direction has rather a wrong sign.
    for said in ["kamera", "směr pohledu míří na sněhuláka", "looks at 0 5 0"] {
        let text = |direction: &str| scene(SNOWMAN, "0 2.4 8", direction, said);
        let (_, made) = guessed(&text("0 1 -1"), Code::W324);
        assert_eq!(made[0], text("0 -1 -1"), "{said}");
    }
}

/// The point is (0, 0.5, -2) and the place (0, 2, 8), so the direction is (0, -1.5, -10).
#[test]
fn a_point_to_look_at_where_something_is_seen() {
    for said in [
        "kamera: poloha, cíl, nahoru, úhel",
        "dívá se na bod (0, 0.5, -2)",
        "camera: position, target, up, angle",
        "looks at the house",
        "target 0 0.5 -2",
    ] {
        let text = |direction: &str| scene(HOUSE, "0 2 8", direction, said);
        let (finding, made) = guessed(&text("0 0.5 -2"), Code::W344);
        assert_eq!(made, [text("0 -1.5 -10")], "{said}");
        assert_eq!(fixed(&text("0 0.5 -2")), made[0], "{said}");
        assert!(!has(&made[0], Code::W344), "{said}");
        for (language, word) in [(Language::English, "point"), (Language::Czech, "bod")] {
            let wording = finding.wording(language);
            assert!(wording.message.contains(word), "{}", wording.message);
            assert!(wording.fixes[0].contains("0 -1.5 -10"));
        }
    }
}

/// A direction that leads to the point, or to the objects, and a comment that speaks of something else.
#[test]
fn a_direction_that_is_meant() {
    for (place, direction, said) in [
        ("0 2 8", "0 -1.5 -10", "looks at the house"),
        ("0 2 8", "0 -1.5 -10", "looks at 0 0.5 -2"),
        ("0 2 8", "0 -0.3 -2", "kamera: poloha, cíl, nahoru, úhel"),
        ("0 2 8", "0 0 -1", "looks at 0 0 -1"),
        ("0 2 8", "0 0.2 -1", "dívá se na dům"),
        ("0 2 8", "0 0.5 -2", "looks at 0 3 0"),
        ("0 2 8", "0 0.5 -2", "position, direction, up, angle"),
        ("0 2 8", "0 0.5 -2", "poloha, směr, nahoru, úhel"),
        ("0 2 8", "0 0.5 -2", "looks up to the sky"),
        ("0 2 8", "0 0.5 -2", "not looking at the house"),
    ] {
        let text = scene(HOUSE, place, direction, said);
        assert!(!has(&text, Code::W344), "{direction} {said}");
    }
    let turned = scene(HOUSE, "0 2 8", "0 0.5 -2", "look at") + "9 -2 10 2\n";
    assert!(!has(&turned, Code::W344));
}
