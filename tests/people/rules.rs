//! Slips with a rule of their own.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::render::human::{self, Look};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Language, fixes};

use super::{read, scenes, slips, values};
use crate::rng::Rng;

/// A scene with something of everything, and nothing to be said of it.
pub const SCENE: &str = "\
2 -701 1 0.5 0.2
3 -201 0.6 0.3 0
4 12 -3 -1 -3 3 0 3
4 -299 2 3
5 11 0 1 0 1
5 -1 0.5 0 0
6 12 -1 -1 -1 1 1 1
6 -2 30 2
6 -1 -1.5 2 0
7 -103 6 5
8 -101 4 7
9 -401 0.3
10 -402 0.8
10 -1 3 8 5
10 -701 1 0.9 0.8
11 -501 0 4 12 0 -4 -12 0 1 0 40
1 9999 8 2
";

/// The scene with another line in the place of line `line`.
pub fn with(line: usize, new: &str) -> String {
    (SCENE.lines().enumerate())
        .map(|(i, old)| if i + 1 == line { new } else { old }.to_owned() + "\n")
        .collect()
}

fn errors(text: &str) -> Vec<Diagnostic> {
    let all = repair::proposals(&read(text)).into_iter();
    all.filter(Diagnostic::is_error).collect()
}

/// What the first fix of the only error makes of a text.
#[track_caller]
fn mended(text: &str) -> (Diagnostic, String) {
    let errors = errors(text);
    assert_eq!(errors.len(), 1, "{text}\n{errors:?}");
    let (fixed, _) = fixes::apply(text, errors[0].fixes.first().into_iter());
    (errors[0].clone(), fixed)
}

#[test]
fn nothing_is_wrong_with_the_scene() {
    assert_eq!(read(SCENE).findings(), []);
}

#[test]
fn the_minus_of_all_types_is_lost() {
    let unsigned = SCENE
        .replace(" -7", " 7")
        .replace(" -1 3", " 1 3")
        .replace(" -1 0.5", " 1 0.5");
    let all = (unsigned.replace(" -299", " 299").replace(" -2 30", " 2 30"))
        .replace(" -201", " 201")
        .replace(" -10", " 10")
        .replace(" -1 -1.5", " 1 -1.5")
        .replace(" -40", " 40")
        .replace(" -501", " 501");
    let (finding, fixed) = mended(&all);
    assert_eq!((finding.code, finding.case), (Code::E007, "minus"));
    assert_eq!(values(&fixed), values(SCENE));
    // In all records of a kind.
    let moves = SCENE
        .replace("5 -1 ", "5 1 ")
        .replace("6 -1 -1.5", "6 1 -1.5")
        .replace("10 -1 ", "10 1 ");
    let (finding, fixed) = mended(&moves);
    assert_eq!((finding.code, finding.case), (Code::E007, "minus"));
    assert_eq!(values(&fixed), values(SCENE));
}

#[test]
fn all_minus_signs_are_dashes() {
    for dash in ["−", "–"] {
        let (finding, fixed) = mended(&SCENE.replace('-', dash));
        assert_eq!((finding.code, finding.case), (Code::E003, "dashes"));
        assert_eq!(fixed, SCENE);
    }
}

#[test]
fn a_heading_without_signs() {
    for heading in [
        "red balls",
        "0 red balls",
        "// red balls",
        "-- the scene",
        "; red balls: 2 of them",
    ] {
        let (_, fixed) = mended(&with(3, &format!("{heading}\n4 12 -3 -1 -3 3 0 3")));
        assert_eq!(
            values(&fixed.replace("\n0 #", "\n#")),
            values(SCENE),
            "{heading}\n{fixed}"
        );
    }
}

#[test]
fn definitions_that_need_each_other() {
    let errors = errors(&with(10, "7 -103 6 8"));
    assert_eq!(
        (errors.len(), errors[0].code, errors[0].case),
        (1, Code::E107, "cycle")
    );
    let said = errors[0].wording(Language::English);
    assert!(said.help.unwrap().contains("7 → 8 → 7"), "{}", said.message);
    // One that is only defined later is no circle.
    let found = self::errors(&with(10, "7 -103 6 5\n7 -299 12 0\n12 -701 1 1 1"));
    assert_eq!((found[0].code, found[0].case), (Code::E107, ""));
}

#[test]
fn the_id_of_the_render_record_is_used_for_an_object() {
    let text = SCENE.replace("\n4 ", "\n1 ").replace("-101 4", "-101 1");
    let (finding, fixed) = mended(&text);
    assert_eq!(finding.code, Code::E105);
    let meant = SCENE.replace("\n4 ", "\n12 ").replace("-101 4", "-101 12");
    assert_eq!(values(&fixed), values(&meant));
}

#[test]
fn two_scenes_in_one_file() {
    let text = [SCENE, SCENE].concat();
    let (finding, fixed) = mended(&text);
    assert_eq!((finding.code, finding.case), (Code::E102, "scenes"));
    let at = text.len() / 2;
    assert_eq!(finding.span.start as usize, at, "where the second begins");
    let analysis = read(&fixed);
    assert!(analysis.is_sound(), "{fixed}");
    // Both are part of what is drawn.
    let unused = |d: &&Diagnostic| d.code == Code::W310;
    assert_eq!(
        analysis.findings().iter().filter(unused).count(),
        0,
        "{fixed}"
    );
    assert_eq!(analysis.scene.shapes.len(), 6);
}

#[test]
fn a_number_too_many_in_the_render_record() {
    for written in [
        "1 9999 9999 8 0 # all #",
        "1 9999 8 8 0 # all #",
        "1 9999 21 8 0 # all #",
    ] {
        let (_, fixed) = mended(&with(17, written));
        assert_eq!(values(&fixed), values(&with(17, "1 9999 8 0")), "{written}");
    }
    // The ID 28, with a space in it.
    let text = with(11, "28 -101 4 7").replace("1 9999 8 2", "1 9999 2 8 0 # all #");
    let (_, fixed) = mended(&text);
    assert_eq!(values(&fixed), values(&text.replace("2 8 0 #", "28 0 #")));
    // What a comment divides is not written anew.
    let text = with(17, "1 9999 9999 # all # 8 0");
    for d in errors(&text) {
        let (fixed, _) = fixes::apply(&text, d.fixes.first().into_iter());
        assert!(fixed.contains("# all #"), "{fixed}");
    }
}

#[test]
fn a_difference_that_makes_sense_in_one_order() {
    let text = "2 9 10\n3 11 0 0 0 5\n4 -103 3 2\n1 9999 4 0\n";
    let found = repair::proposals(&read(text));
    let first = found
        .iter()
        .find(|d| d.code == Code::W319)
        .expect("it is empty");
    let (fixed, _) = fixes::apply(text, first.fixes.first().into_iter());
    assert_eq!(fixed, text.replace("3 2", "2 3"));
}

/// Each is what the handout's words say: the hollow ball, the rectangle, the balls 22 and 21.
#[test]
fn the_handouts_own_mistakes() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/handout/printed/");
    for (name, meant) in [
        (
            "1-half-hollow-sphere.zpg",
            &["4 -103 2 3", "4 -299 0 35"][..],
        ),
        (
            "4-checkerboard-and-spheres.zpg",
            &[
                "16 -399 10 15 14 15",
                "17 5 -10 -15 10 15",
                "17 -399 10 15 14 15",
                "24 -102 22 21",
            ],
        ),
    ] {
        let text = std::fs::read_to_string(folder.to_owned() + name).unwrap();
        let errors = errors(&text);
        let first = errors.iter().filter_map(|d| d.fixes.first());
        let (fixed, count) = fixes::apply(&text, first);
        assert_eq!(count, meant.len(), "{name}");
        for line in meant {
            let is_there = |l: &str| l.starts_with(&format!("{line} "));
            assert!(fixed.lines().any(is_there), "{line}\n{fixed}");
        }
        let analysis = read(&fixed);
        assert!(analysis.is_sound() && !repair::draws_nothing(&analysis));
    }
}

#[test]
fn no_guess_after_a_guess_makes_a_value_worse() {
    for (written, meant) in [
        ("90%", "0.9"),
        ("90 %", "0.9"),
        ("1/4", "0.25"),
        ("O.5", "0.5"),
    ] {
        let text = with(2, &format!("3 -201 0.1 0 {written}"));
        let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
        assert_eq!(
            mended.analysis.source.text,
            with(2, &format!("3 -201 0.1 0 {meant}"))
        );
    }
}

#[test]
fn a_stray_pair_of_signs_is_never_safe() {
    for line in [
        "5 11 0 1 0 1 red ball #",
        "5 11 0 1 0 1 # ball #1 #",
        "5 11 0 1 0 1 #",
    ] {
        let analysis = read(&with(5, line));
        for fix in analysis.findings().iter().flat_map(|d| &d.fixes) {
            let (fixed, _) = fixes::apply(&analysis.source.text, [fix].into_iter());
            let stray = fixed
                .lines()
                .nth(4)
                .unwrap()
                .replace(' ', "")
                .contains("##");
            assert!(
                !stray || fix.applicability == Applicability::Unsafe,
                "{fixed}"
            );
        }
    }
}

/// Twelve records in a row that lack the same number: the first is shown, the others are counted.
#[test]
fn a_row_of_records_that_lack_the_same() {
    let rows: String = (20..32).map(|id| format!("{id} 11 {id} 0 1\n")).collect();
    let text = format!("{rows}1 9999 20 0\n");
    let analysis = read(&text);
    let found = repair::proposals(&analysis);
    assert_eq!(found.iter().filter(|d| d.code == Code::E008).count(), 12);
    let print = |found: &[Diagnostic]| {
        let mut out = Vec::new();
        human::write(&mut out, &analysis.source, found, Look::default()).unwrap();
        String::from_utf8(out).unwrap()
    };
    let printed = print(&found);
    assert_eq!(
        printed.matches("error[E008]: too few").count(),
        1,
        "{printed}"
    );
    assert!(
        printed.contains("11 more records like the one on line 1"),
        "{printed}"
    );
    // Three are shown one by one.
    let printed = print(&found[..3]);
    assert_eq!(
        printed.matches("error[E008]: too few").count(),
        3,
        "{printed}"
    );
}

/// Scenes that draw something still do after guesses.
#[test]
fn no_guesses_end_in_a_scene_that_draws_nothing() {
    let mut tried = 0;
    for seed in 0..6 {
        let mut rng = Rng::new(seed);
        let records = scenes::scene(&mut rng, 12);
        for slip in slips::ALL {
            let i = rng.below(records.len());
            let Some(written) = (slip.make)(&mut rng, &records, i) else {
                continue;
            };
            let line = |(k, r): (usize, &scenes::Record)| {
                let line = if k == i {
                    written.line.clone()
                } else {
                    r.line()
                };
                line + "\n"
            };
            let text: String = records.iter().enumerate().map(line).collect();
            let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
            tried += 1;
            assert!(!repair::draws_nothing(&mended.analysis), "{text}");
        }
    }
    assert!(tried > 50, "{tried}");
}

#[test]
fn colours_as_other_programs_write_them() {
    for (written, meant) in [
        ("#ff8000", "1 0.216 0"),
        ("#ff8000 #", "1 0.216 0"),
        ("#FF8000 # orange #", "1 0.216 0 # orange #"),
        ("#ff8000 orange", "1 0.216 0 # orange #"),
        ("0xff8000", "1 0.216 0"),
        ("ff8000", "1 0.216 0"),
        ("\"#ff8000\" # orange #", "1 0.216 0 # orange #"),
        // Not a number of points, nor a power of ten.
        ("804020", "0.216 0.051 0.0144"),
        ("1e0000", "0.013 0 0"),
        ("#fff", "1 1 1"),
        ("#000000", "0 0 0"),
    ] {
        for (line, head) in [(1, "2 -701"), (15, "10 -701")] {
            let (finding, fixed) = mended(&with(line, &format!("{head} {written}")));
            assert_eq!((finding.code, finding.case), (Code::E003, "colour"));
            assert_eq!(fixed, with(line, &format!("{head} {meant}")));
        }
    }
    // Each of several, though the signs could pair up.
    let text = with(1, "2 -701 #804020").replace("10 -701 1 0.9 0.8", "10 -701 #00ff00 # green #");
    let found = errors(&text);
    assert_eq!(found.len(), 2, "{found:?}");
    let (fixed, _) = fixes::apply(&text, found.iter().filter_map(|d| d.fixes.first()));
    let meant = with(1, "2 -701 0.216 0.051 0.0144");
    assert_eq!(
        fixed,
        meant.replace("10 -701 1 0.9 0.8", "10 -701 0 1 0 # green #")
    );
    // A comment in the middle of a colour that is right.
    for right in [
        "2 -701 #ff8000 # 1 0.5 0.2",
        "2 -701 #ff8000\nor so # 1 0.5 0.2",
    ] {
        assert_eq!(errors(&with(1, right)), [], "{right}");
    }
}

#[test]
fn a_reference_beside_one_that_is_none() {
    let text = with(4, "4 -299 0 2");
    let (finding, fixed) = mended(&text);
    assert_eq!(finding.code, Code::E103);
    // The colour in front would leave the optical property in vain.
    assert_eq!(fixed, with(4, "4 -299 0 3"));
    // An object is no property.
    let text = "2 9 1\n3 -201 0.5 0.2 0.1\n15 11 0 3 0 2\n15 -299 0 2\n16 -101 2 15\n1 9999 16 0\n";
    let (_, fixed) = mended(text);
    assert_eq!(fixed, text.replace("-299 0 2", "-299 0 3"));
}

#[test]
fn a_type_is_lost_before_a_number_that_is_one() {
    for numbers in ["-3 -3 -3 3 3 3", "-1 -1 -1 1 1 1", "-2 -1 -2 2 1 2"] {
        let (finding, fixed) = mended(&with(3, &format!("4 {numbers}")));
        assert_eq!((finding.code, finding.case), (Code::E006, "lost"));
        assert_eq!(fixed, with(3, &format!("4 12 {numbers}")));
    }
}
