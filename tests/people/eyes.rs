//! Two cameras for a stereo picture: one is left out, is no camera, or is in the other's place.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Code, Language, fixes};

use super::read;

fn scene(selection: &str) -> String {
    format!(
        "2 11 0 1 0 1\n9 -501 -0.1 2 8 0 -0.2 -1 0 1 0 40\n10 -501 0.1 2 8 0 -0.2 -1 0 1 0 40\n\
         {selection}\n50 -402 0.9\n50 -1 4 6 5\n1 9999 2 0\n"
    )
}

/// A selection with a slip, what is said, and the first guess.
const SLIPS: &[(&str, Code, &str)] = &[
    ("11 -503 9", Code::E008, "11 -503 9 10"),
    ("11 -503", Code::E008, "11 -503 9 10"),
    ("11 -503 9 12", Code::E101, "11 -503 9 10"),
    ("11 -503 9 9", Code::W338, "11 -503 9 10"),
    ("11 -503 10 9", Code::W338, "11 -503 9 10"),
    ("11 -503 9 10\n12 -502 9", Code::W338, "11 -503 9 10"),
];

#[test]
fn the_other_camera_is_the_other_eye() {
    for (selection, code, meant) in SLIPS {
        let text = scene(selection);
        let all = repair::proposals(&read(&text));
        let found = all.iter().find(|d| d.code == *code).unwrap();
        let made = fixes::apply(&text, found.fixes.first().into_iter()).0;
        assert_eq!(made, scene(meant), "{selection}");
        // No guess has one camera for both eyes.
        for fix in &found.fixes {
            let made = fixes::apply(&text, std::iter::once(fix)).0;
            assert!(!made.contains("-503 9 9"), "{made}");
        }
        for language in [Language::English, Language::Czech] {
            assert!(!found.wording(language).message.is_empty());
        }
    }
    assert!(read(&scene("11 -503 9 10")).findings().is_empty());
}

/// With three cameras nobody knows which one is the other eye, and one that overrides a pair may be meant.
#[test]
fn what_is_open_stays_open() {
    let three = scene("13 -501 3 2 8 0 -0.2 -1 0 1 0 40\n11 -503 9 9");
    let all = repair::proposals(&read(&three));
    let found = all.iter().find(|d| d.code == Code::W338).unwrap();
    assert!(found.fixes.is_empty());
    let overridden = scene("11 -503 9 10\n12 -502 9");
    let mended = fixing::to_fixed_point(read(&overridden), true, Analysis::of);
    assert_eq!(mended.analysis.source.text, overridden);
}
