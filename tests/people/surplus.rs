//! Numbers too many, as other programs have them: what is guessed and taken, and what is left to the reader.

use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Diagnostic, Language, fixes};

use super::{read, said};

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 2 8 0 -0.2 -1 0 1 0 40\n50 -402 0.9\n50 -1 4 6 5\n1 9999 2 0\n";

fn scene(lines: &str) -> String {
    format!("{lines}\n{REST}")
}

/// The only error of a scene.
fn error(lines: &str) -> Diagnostic {
    let all = repair::proposals(&read(&scene(lines)));
    let errors: Vec<Diagnostic> = all.into_iter().filter(Diagnostic::is_error).collect();
    let told: Vec<String> = errors.iter().flat_map(said).collect();
    assert_eq!(errors.len(), 1, "{lines}: {}", told.join("; "));
    errors[0].clone()
}

/// What each proposal for the only error makes of the lines.
fn proposed(lines: &str) -> Vec<String> {
    let text = scene(lines);
    let made = |fix| fixes::apply(&text, std::iter::once(fix)).0;
    let made = error(lines).fixes.iter().map(made).collect::<Vec<_>>();
    let own = |text: String| text.strip_suffix(&format!("\n{REST}")).map(str::to_owned);
    made.into_iter().filter_map(own).collect()
}

/// The lines after all guesses that are taken.
fn fixed(lines: &str) -> String {
    let mended = fixing::to_fixed_point(read(&scene(lines)), true, Analysis::of);
    let text = mended.analysis.source.text.clone();
    text.strip_suffix(&format!("\n{REST}")).unwrap().to_owned()
}

/// That the first proposal is what was meant, and is taken.
fn is_meant(table: &[(&str, &str)]) {
    for (written, meant) in table {
        assert_eq!(proposed(written).first().map(String::as_str), Some(*meant));
        assert_eq!(fixed(written), *meant);
    }
}

/// That these are the proposals, and none is taken.
fn is_choice(written: &str, choices: &[&str]) {
    assert_eq!(proposed(written), choices);
    let fixes = error(written).fixes;
    assert!(
        fixes
            .iter()
            .all(|f| f.applicability == Applicability::Choice)
    );
    assert_eq!(fixed(written), written);
}

/// The label, the notes and the help of the only error.
fn told(lines: &str, language: Language) -> String {
    let words = error(lines).wording(language);
    let rest = words.notes.into_iter().chain(words.help);
    std::iter::once(words.label)
        .chain(rest)
        .collect::<Vec<_>>()
        .join("\n")
}

/// A box with a record behind it.
fn boxed(record: &str) -> String {
    format!("2 12 -1 -1 -1 1 1 1\n2 {record}")
}

/// A vector of length 1 is the axis, and the fourth number the angle, wherever that stands.
#[test]
fn rotations_about_a_vector() {
    for (written, meant) in [
        ("-2 1 0 0 70", "-2 70 1"),
        ("-2 0 1 0 70", "-2 70 2"),
        ("-2 70 0 0 1", "-2 70 3"),
        ("-2 -1 0 0 30", "-2 -30 1"),
        ("-2 0 0 -1 -30", "-2 30 3"),
        ("-2 30 0 -1 0", "-2 -30 2"),
        // No vector of length 1, and only one along an axis.
        ("-2 0 2 0 45", "-2 45 2"),
    ] {
        is_meant(&[(&boxed(written), &boxed(meant))]);
    }
    // π/2 is no angle in degrees, which is another finding.
    let radians = boxed("-2 1 0 0 1.57");
    assert_eq!(proposed(&radians), [boxed("-2 1.57 1")]);
    is_choice(&boxed("-2 1 0 0 1"), &[&boxed("-2 1 3"), &boxed("-2 1 1")]);
    is_choice(
        &boxed("-2 30 0 0 70"),
        &[&boxed("-2 30 3"), &boxed("-2 70 1")],
    );
}

/// (x, y, z) of a quaternion is the sine of half the angle times the axis, w the cosine: sin 45° = cos 45° = 0.7071,
/// sin 22.5° = 0.3827, cos 22.5° = 0.9239, sin 60° = 0.8660, cos 60° = 0.5.
#[test]
fn quaternions() {
    for (written, meant) in [
        ("-2 0 0.7071 0 0.7071", "-2 90 2"),
        ("-2 0.7071 0 0.7071 0", "-2 90 2"),
        ("-2 0.9239 0.3827 0 0", "-2 45 1"),
        ("-2 0 -0.8660 0 0.5", "-2 -120 2"),
        // The same turn with the other sign.
        ("-2 0 0.8660 0 -0.5", "-2 -120 2"),
        ("-2 <0, 0.5, 0, 0.8660>", "-2 60 2"),
    ] {
        is_meant(&[(&boxed(written), &boxed(meant))]);
    }
    // In the first and last place, either may be w: the cosine of half of -135° is 0.3827, too.
    let both = boxed("-2 0.9239 0 0 -0.3827");
    is_choice(&both, &[&boxed("-2 -135 1"), &boxed("-2 -45 3")]);
    let both = boxed("-2 0.7071 0 0 0.7071");
    is_choice(&both, &[&boxed("-2 90 1"), &boxed("-2 90 3")]);
    // A third of a turn about (1, 1, 1).
    let other = boxed("-2 0.5 0.5 0.5 0.5");
    assert!(proposed(&other).is_empty());
    assert!(told(&other, Language::English).contains("quaternion"));
    assert!(told(&other, Language::Czech).contains("kvaternion"));
}

/// A turn by 90° about z takes x to y: its columns are y, −x and z.
#[test]
fn smaller_matrices() {
    let whole = boxed("-4 0 -1 0 0  1 0 0 0  0 0 1 0  0 0 0 1");
    is_meant(&[(&boxed("-4 0 -1 0 1 0 0 0 0 1"), &whole)]);
    // POV-Ray has columns in the place of rows; these can be no rows of four, which would have no inverse.
    let moved = boxed("-4 0 -1 0 2  1 0 0 3  0 0 1 4  0 0 0 1");
    let by_rows = boxed("-4 0 -1 0 2 1 0 0 3 0 0 1 4");
    assert!(proposed(&by_rows).contains(&moved));
    let by_columns = boxed("-4 0 1 0 -1 0 0 0 0 1 2 3 4");
    assert!(proposed(&by_columns).contains(&moved));
    // What is left out of five numbers, nobody can tell.
    let few = boxed("-4 1 2 3 4 5");
    assert!(proposed(&few).is_empty());
    assert!(told(&few, Language::English).contains("3 × 3 matrix of nine numbers"));
    assert!(told(&few, Language::Czech).contains("matice 3 × 3"));
}

#[test]
fn alpha_of_a_colour() {
    let ball = |colour: &str| format!("21 -701 {colour}\n2 11 0 1 0 1\n2 -299 21 0");
    let four = ball("0.9 0.2 0.1 1");
    is_meant(&[(&four, &ball("0.9 0.2 0.1"))]);
    assert!(told(&four, Language::English).contains("alpha"));
    assert!(told(&four, Language::Czech).contains("alfa"));
    // No share is above 1.
    assert!(!told(&ball("0.9 0.2 0.1 7"), Language::English).contains("alpha"));
}

#[test]
fn points_of_a_profile_in_space() {
    is_meant(&[
        (
            "2 1 4  0 0 0  0.5 0 0  0.4 1 0  0 1.2 0",
            "2 1 4  0 0  0.5 0  0.4 1  0 1.2",
        ),
        (
            "2 1 3 0.5 0 0 0.3 0.8 0 0 1.2 0",
            "2 1 3 0.5 0 0.3 0.8 0 1.2",
        ),
        ("2 1 2  0.5 0 0  0.3 0.8 0", "2 1 2  0.5 0  0.3 0.8"),
        (
            "2 1 4 <0,0,0> <0.5,0,0> <0.4,1,0> <0,1.2,0>",
            "2 1 4 0 0 0.5 0 0.4 1 0 1.2",
        ),
        (
            "2 1 3  (0.5, 0, 0)  (0.3, 0.8, 0)  (0, 1.2, 0)",
            "2 1 3  0.5 0  0.3 0.8  0 1.2",
        ),
        (
            "2 2 3  0.5 0 0  0.3 0.8 0  0 1.2 0  1 0 0  0 1 0  0 0 1",
            "2 2 3  0.5 0  0.3 0.8  0 1.2  1 0 0  0 1 0  0 0 1",
        ),
        // Three points, and 2 is wrong.
        ("2 1 2 0.5 0 0 0.3 0.8 0", "2 1 3 0.5 0 0 0.3 0.8 0"),
        (
            "2 1 4  0.5 0  0.5 0.2  0.4 0.3",
            "2 1 3  0.5 0  0.5 0.2  0.4 0.3",
        ),
    ]);
    let deep = "2 1 3  0.5 0 1  0.3 0.8 1  0 1.2 2";
    assert!(proposed(deep).is_empty());
    assert!(told(deep, Language::English).contains("a point of a profile is x y"));
    assert!(told(deep, Language::Czech).contains("bod profilu je x y"));
}

#[test]
fn one_colour_for_a_profile() {
    let written = "2 2 3  0.5 0  0.3 0.8  0 1.2  1 0 0";
    let each = "2 2 3  0.5 0  0.3 0.8  0 1.2  1 0 0  1 0 0  1 0 0";
    let apart = "2 1 3  0.5 0  0.3 0.8  0 1.2\n2 -701 1 0 0";
    is_meant(&[(written, each)]);
    assert_eq!(proposed(written), [each, apart]);
}

/// What goes because it stands there twice is a vector, or stands by itself.
#[test]
fn numbers_that_stand_there_twice() {
    is_meant(&[
        ("2 11  0 1 0  0 1 0  1", "2 11  0 1 0  1"),
        ("2 14 1 0.3 1 0.3", "2 14 1 0.3"),
        ("2 12 -1 -1 -1 -1 -1 -1 1 1 1", "2 12 -1 -1 -1 1 1 1"),
        // A point, and the normal up.
        ("2 4  0 0 0  0 1 0", "2 4  0 1 0  0"),
        ("2 4  3 2 5  0 1 0", "2 4  0 1 0  -2"),
        ("2 4  0 0 1  0 0 -5", "2 4  0 0 1  5"),
        ("2 11  0 1 0  1 2 1", "2 10 1 2 1\n2 -1 0 1 0"),
        ("2 11  0 0 0  1 2 1", "2 10 1 2 1"),
    ]);
    // Both have the length 1.
    is_choice("2 4  1 0 0  0 1 0", &["2 4  0 1 0  0", "2 4  1 0 0  0"]);
    // Four corners, of which none is lost.
    let quad = "2 6  -1 0 0  1 0 0  1 1 0  -1 1 0";
    let triangles = "51 6  -1 0 0  1 0 0  1 1 0\n52 6  -1 0 0  1 1 0  -1 1 0\n2 -101 51 52";
    assert_eq!(proposed(quad)[0], triangles);
    assert_eq!(fixed(quad), quad);
    // A normal across the triangle is one.
    is_meant(&[(
        "2 6  -1 0 0  1 0 0  1 1 0  0 0 1",
        "2 7  -1 0 0  1 0 0  1 1 0  0 0 1",
    )]);
}

/// In other programs matrices act on rows.
#[test]
fn matrices_for_rows() {
    is_meant(&[(
        &boxed("-4 1 0 0 0  0 1 0 0  0 0 1 0  2 0 1 1"),
        &boxed("-4 1 0 0 2  0 1 0 0  0 0 1 1  0 0 0 1"),
    )]);
    let written = boxed("-4 1 0 0 0  0 1 0 0  0 0 1 0  2 0 1 2");
    assert!(proposed(&written).is_empty());
}

/// A rectangle without area is rather a plane.
#[test]
fn rectangles_with_the_numbers_of_a_plane() {
    let floor = "3 5 0 1 0 0\n2 11 0 1 0 1\n2 -101 2 3";
    let safe = fixing::to_fixed_point(read(&scene(floor)), false, Analysis::of);
    assert_eq!(safe.analysis.source.text, scene(floor));
    let all = proposed("2 5 0 1 0 0");
    assert!(all.contains(&"2 4 0 1 0 0".to_owned()), "{all:?}");
    assert!(proposed("2 5 0 3 0 0").is_empty());
    is_meant(&[("2 5 0 3 1 0", "2 5 0 0 1 3")]);
}

/// Three parts of light for three channels are those of glass, if their sum is above 1.
#[test]
fn tinted_glass() {
    let ball = |record: &str, behind: &str| format!("2 11 0 1 0 1\n2 {record}{behind}");
    let index = "\n2 -203 1.5 1.5 1.5";
    let meant = "-202 0 0 0.9  0 0 0.95  0 0 0.9";
    is_meant(&[
        (&ball("-202 0.9 0.95 0.9", index), &ball(meant, index)),
        (
            &ball("-202 0.9 0.95 0.9", " # glass #"),
            &ball(meant, " # glass #"),
        ),
        (
            &ball("-202 0.9 0.95 0.9", " # zelené sklo #"),
            &ball(meant, " # zelené sklo #"),
        ),
        // Parts of one surface.
        (
            &ball("-202 0.1 0.1 0.8", index),
            &ball("-201 0.1 0.1 0.8", index),
        ),
    ]);
    let alone = ball("-202 0.9 0.95 0.9", "");
    assert_eq!(fixed(&alone), alone);
}

/// ID and type in each other's place, where the line is right either way.
#[test]
fn shapes_that_are_right_either_way() {
    for (written, meant) in [
        ("11 3  0 1 0  1", "3 11  0 1 0  1"),
        ("11 4  0 1 0  1", "4 11  0 1 0  1"),
    ] {
        let id = &meant[..1];
        let lines = |ball: &str| format!("8 9 0.5\n{ball}\n{id} -201 0.1 0.85 0\n2 -101 8 {id}");
        is_meant(&[(&lines(written), &lines(meant))]);
    }
    // The plane is used.
    let used = "11 3  0 1 0  1\n3 -201 0.1 0.85 0\n2 -101 11 3";
    assert!(proposed(used).iter().all(|p| !p.starts_with("3 11")));
}

/// Where an ID belongs, the finding says whose.
#[test]
fn numbers_with_a_point_for_an_id() {
    let text = "2 9 1\n11 -503 9 0.065";
    assert!(told(text, Language::English).contains("the ID of the right eye's camera"));
    assert!(told(text, Language::Czech).contains("ID kamery pravého oka"));
}
