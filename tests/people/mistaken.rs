//! Numbers that are those of something else than their type says: a box by its centre, parts of light, a cylinder.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Diagnostic, Language, fixes};

use super::read;

const REST: &str = "9 -501 0 3 12 0 -0.2 -1 0 1 0 45\n50 -402 0.9\n50 -1 4 7 6\n1 9999 2 0\n";

fn scene(lines: &str) -> String {
    format!("{lines}\n{REST}")
}

/// The lines that the proposals for the only error make, and whether one is taken.
fn made(lines: &str) -> (Vec<String>, bool) {
    let text = scene(lines);
    let all = repair::proposals(&read(&text)).into_iter();
    let errors: Vec<Diagnostic> = all.filter(Diagnostic::is_error).collect();
    let [error] = &errors[..] else {
        panic!("{lines}: {errors:?}");
    };
    let shown = |fix| fixes::apply(&text, std::iter::once(fix)).0;
    let made = error.fixes.iter().map(shown);
    let made = made.map(|text| {
        text.strip_suffix(REST)
            .expect("the rest")
            .trim_end()
            .to_owned()
    });
    let made: Vec<String> = made.collect();
    let mended = fixing::to_fixed_point(read(&text), true, Analysis::of);
    let is_taken = mended.analysis.source.text != text;
    if is_taken {
        assert_eq!(mended.analysis.source.text, scene(&made[0]), "{lines}");
    }
    let mut fixes = error.fixes.iter();
    let may_be = fixes.any(|f| f.applicability != Applicability::Choice);
    assert_eq!(may_be, is_taken, "{lines}");
    (made, is_taken)
}

#[track_caller]
fn taken(lines: &str, meant: &str) {
    assert_eq!(made(lines), (vec![meant.to_owned()], true));
}

#[track_caller]
fn untaken(lines: &str, guesses: &[&str]) {
    let guesses = guesses.iter().map(|&g| g.to_owned()).collect();
    assert_eq!(made(lines), (guesses, false));
}

/// The centre 0 1 0 and the edge 2: from -1 0 -1 to 1 2 1.
#[test]
fn boxes_by_centre_and_edge() {
    for word in ["krychle", "kvádr", "Kostka", "a cube", "box"] {
        let line = |numbers: &str| format!("2 12 {numbers}  # {word}: střed, hrana #");
        taken(&line("0 1 0  2"), &line("-1 0 -1 1 2 1"));
    }
    let ball = "2 11 0 1 0  2";
    untaken("2 12 0 1 0  2", &[ball, "2 12 -1 0 -1 1 2 1"]);
    taken("2 12 0 1 0  2 # koule #", "2 11 0 1 0  2 # koule #");
}

/// The radius may stand before the centre.
#[test]
fn balls_by_radius_and_centre() {
    let [one, other] = ["2 11 1 0 1.6 0.8", "2 11 0 1.6 0.8 1"];
    untaken("2 9 1 0 1.6 0.8", &[one, other]);
    // No radius is 0.
    taken("2 9 0 0 1.6 0.8", "2 11 0 0 1.6 0.8");
}

#[test]
fn cylinders_by_a_parabolic_one() {
    for word in ["válec", "cylinder"] {
        let line = |numbers: &str| format!("2 {numbers}  # {word}: poloměr, výška #");
        taken(&line("18 0.5 2"), &line("1 2 0.5 0 0.5 2"));
    }
    untaken("2 18 0.5 2", &["2 1 2 0.5 0 0.5 2"]);
    let line = |numbers: &str| format!("2 {numbers} # parabolický válec #");
    untaken(&line("18 0.5 2"), &[&line("1 2 0.5 0 0.5 2")]);
    taken(
        "2 18 1 0 1 1 3 1 0.5 # válec #",
        "2 1 2 0.5 0 0.5 3\n2 -1 1 0 1 # válec #",
    );
}

/// A comment says which of two numbers is the height.
#[test]
fn cylinders_by_height_and_radius() {
    for (written, meant, said) in [
        ("2 0.1", "0.1 0 0.1 2", "válec: výška 2, poloměr 0.1"),
        ("2 0.1", "0.1 0 0.1 2", "válec: výška, poloměr"),
        ("2 0.1", "0.1 0 0.1 2", "o výšce 2 a poloměru 0.1"),
        (
            "2 0.5",
            "0.5 0 0.5 2",
            "komín: válec, výška 2 a poloměr 0.5",
        ),
        ("0.1 2", "0.1 0 0.1 2", "cylinder: radius 0.1, height 2"),
        ("2 0.1", "0.1 0 0.1 2", "radius 0.1, height 2"),
        ("2 0.1", "2 0 2 0.1", "disc: radius 2, height 0.1"),
        ("3 1", "3 0 3 1", "válec: poloměr a výška"),
        ("3 1", "1 0 1 3", "cylinder: height and radius"),
    ] {
        let line = |numbers: &str| format!("2 1 {numbers} # {said} #");
        let (made, is_taken) = made(&line(written));
        assert_eq!(made[0], line(&format!("2 {meant}")));
        assert!(is_taken, "{said}");
    }
}

/// A shape that a comment names keeps its type.
#[test]
fn shapes_that_comments_name() {
    for word in ["koule", "ball", "červená koule"] {
        untaken(&format!("2 11 2 0.6 0.6 # {word} #"), &[]);
        untaken(&format!("2 11 0 1 0.5 # {word} #"), &[]);
    }
    let ellipsoid = |code: u32, said: &str| format!("2 {code} 2 0.6 0.6{said}");
    untaken(&ellipsoid(11, ""), &[&ellipsoid(10, "")]);
    let said = " # není to koule #";
    untaken(&ellipsoid(11, said), &[&ellipsoid(10, said)]);
}

/// Only what looks like per cent is read as such.
#[test]
fn parts_of_light_above_1() {
    let line = |numbers: &str| format!("2 11 0 1 0 1\n2 -201 {numbers}");
    for (written, meant) in [
        ("80 20 0", "0.8 0.2 0"),
        ("5 15 80", "0.05 0.15 0.8"),
        ("1 2 0", "0.333 0.667 0"),
        ("9 1 0", "0.9 0.1 0"),
        ("0.8 1.85 0", "0.8 0.185 0"),
    ] {
        taken(&line(written), &line(meant));
    }
    untaken(&line("0.3 1.4 0.1"), &[]);
    untaken(&line("0 0 1.5"), &[&line("0 0 1\n2 -203 1.5 1.5 1.5")]);
    untaken(
        &line("0 0.1 1.33"),
        &[&line("0 0.1 0.9\n2 -203 1.33 1.33 1.33")],
    );
    let index = "\n2 -203 1.5 1.5 1.5";
    untaken(&(line("0 0 1.7") + index), &[]);
}

/// Decimal commas among commas.
#[test]
fn decimal_commas_in_a_list() {
    let ball = "2 11 0 1 0 1\n";
    taken(
        &format!("{ball}2 -701 0,9,0,3,0,1"),
        &format!("{ball}2 -701 0.9 0.3 0.1"),
    );
    taken("2 11 0,5,1,0,0,0,1,5", "2 11 0.5 1.0 0.0 1.5");
}

/// What is said of a lost record of its own, in both languages.
#[test]
fn words_of_an_index() {
    let text = scene("2 11 0 1 0 1\n2 -201 0 0 1.5");
    let finding = repair::proposals(&read(&text)).remove(0);
    for (language, title) in [
        (Language::English, "refractive index"),
        (Language::Czech, "index lomu"),
    ] {
        let said = finding.wording(language).fixes;
        assert!(said[0].contains(title), "{said:?}");
    }
}
