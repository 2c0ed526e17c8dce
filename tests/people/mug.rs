//! Slips in the scene of a mug, and what was meant.

use zpg::internals::analysis::repair;
use zpg::internals::diagnostics::{Code, Diagnostic, Language, fixes};

use super::{fixed, read, said};

/// A mug with a handle, a ball of glass and a cone on a floor, without mistakes.
const MUG: &str = "\
10 -701 0.85 0.2 0.15
11 -701 0.2 0.6 0.3
12 -701 0.3 0.4 0.8
20 -201 0 0.1 0.9
40 1 2 1 0 1 2
41 1 2 0.85 0.15 0.85 2.5
42 -103 40 41
43 14 0.55 0.12
43 -1 1.35 1 0
44 -101 42 43
44 -299 10 0
50 11 -2 0.7 1.2 0.7
50 -299 0 20
50 -203 1.5 1.5 1.5
51 16 1.5 0.6
51 -1 2.5 0 1
51 -299 12 0
60 4 0 1 0 0
60 -299 11 0
70 -101 44 50
71 -101 70 51
72 -101 71 60
80 -501 0 4 9 0 -0.4 -0.9 0 1 0 45
81 -402 0.9
81 -1 -4 6 5
1 9999 72 12
";

/// The scene with a line written in another way.
fn with(line: &str, written: &str) -> String {
    assert_eq!(MUG.matches(&format!("{line}\n")).count(), 1, "{line}");
    MUG.replace(line, written)
}

/// What is said of a scene: what is proposed is tried.
fn findings(text: &str) -> Vec<Diagnostic> {
    repair::proposals(&read(text))
}

/// The scene after the first proposal of its first error.
fn guessed(text: &str) -> String {
    let all = findings(text);
    let first = all.iter().find(|d| d.is_error()).expect(text);
    let fix = first
        .fixes
        .first()
        .unwrap_or_else(|| panic!("{}", said(first).join("; ")));
    fixes::apply(text, [fix].into_iter()).0
}

#[test]
fn the_mug_has_no_mistakes() {
    assert_eq!(findings(MUG), []);
}

/// A space is lost behind a type or an ID: the record has as many numbers as it takes with it.
#[test]
fn lost_spaces_behind_types_and_ids() {
    for (line, written) in [
        ("43 -1 1.35 1 0", "43 -11.35 1 0"),
        ("10 -701 0.85 0.2 0.15", "10 -7010.85 0.2 0.15"),
        ("44 -299 10 0", "44 -29910 0"),
        ("81 -402 0.9", "81 -4020.9"),
        ("71 -101 70 51", "71 -101 7051"),
        ("71 -101 70 51", "71 -10170 51"),
        ("51 -299 12 0", "51 -299 120"),
        ("1 9999 72 12", "1 9999 7212"),
    ] {
        let text = with(line, written);
        let all = findings(&text);
        assert_eq!(all.len(), 1, "{written}");
        assert_eq!((all[0].code, all[0].case), (Code::E003, "glued"));
        assert_eq!(fixed(&text), MUG, "{written}");
    }
    let turned = with("51 -1 2.5 0 1", "51 -2 90 1");
    assert_eq!(fixed(&turned.replace("-2 90", "-290")), turned);
}

/// The right one of two IDs stays.
#[test]
fn the_right_id_stays() {
    for (line, written) in [
        ("1 9999 72 12", "1 9999 73 12"),
        ("1 9999 72 12", "1 9999 5 12"),
        ("42 -103 40 41", "42 -103 40 42"),
    ] {
        assert_eq!(guessed(&with(line, written)), MUG, "{written}");
    }
    let other = with("1 9999 72 12", "1 9999 72 11");
    assert_eq!(guessed(&other.replace("9999 72", "9999 5")), other);
    // All IDs may be off by one, but the first operand may be right, too.
    let text = with("44 -101 42 43", "44 -101 43 44");
    let all = findings(&text);
    let shown: Vec<String> = (all[0].fixes.iter())
        .map(|fix| fixes::apply(&text, [fix].into_iter()).0)
        .collect();
    assert_eq!(shown[0], MUG);
    assert!(shown.contains(&with("44 -101 42 43", "44 -101 43 42")));
    let text = with("42 -103 40 41", "42 -103 41 42");
    assert_eq!(findings(&text)[0].fixes.len(), 2);
    let text = with("42 -103 40 41", "42 -103 42 41");
    let all = findings(&text);
    let mut shown = all[0]
        .fixes
        .iter()
        .map(|fix| fixes::apply(&text, [fix].into_iter()).0);
    assert!(shown.any(|text| text == MUG));
}

/// The place of a torus before its radii: the tube behind is the thinner one.
#[test]
fn the_place_of_a_torus_before_its_radii() {
    let torus = "2 14 1.35 1 0 0.55 0.12";
    let rest = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    let meant = "2 14 0.55 0.12\n2 -1 1.35 1 0";
    assert_eq!(
        guessed(&format!("{torus}\n{rest}")),
        format!("{meant}\n{rest}")
    );
    let handle = "43 14 0.55 0.12\n43 -1 1.35 1 0";
    assert_eq!(guessed(&with(handle, "43 14 1.35 1 0 0.55 0.12")), MUG);
    // A colour behind a slender one.
    let text = format!("2 14 0.55 0.12 0.8 0.2 0.1\n{rest}");
    assert_eq!(
        guessed(&text),
        format!("2 14 0.55 0.12\n2 -701 0.8 0.2 0.1\n{rest}")
    );
}

/// Mirrors and glass make the small picture of a bright scene take long: fewer pixels say it, too.
#[test]
fn too_bright_a_picture_of_mirrors_and_glass() {
    let text = with("81 -402 0.9", "81 -402 60")
        .replace("10 0\n", "10 21\n")
        .replace("11 0\n", "11 21\n")
        .replace("20 -201 0", "21 -201 0.7 0.3 0\n20 -201 0")
        .replace("1 9999", "82 -402 0.5\n82 -1 4 6 5\n1 9999");
    let all = findings(&text);
    assert_eq!(all.len(), 1);
    assert_eq!(all[0].code, Code::N606);
    assert_eq!(findings(&text.replace("-402 60", "-402 0.5")), []);
}

/// The text with the proposal of a number of the first finding with a code.
fn chosen(text: &str, code: Code, number: usize) -> String {
    let all = findings(text);
    let of_code = all.iter().find(|d| d.code == code);
    let d = of_code.unwrap_or_else(|| panic!("{:?}", all.iter().map(said).collect::<Vec<_>>()));
    fixes::apply(text, [&d.fixes[number]].into_iter()).0
}

/// A cone's height and radius in each other's place: the height may be negative.
#[test]
fn height_and_radius_of_a_cone_swapped() {
    let text = with("51 16 1.5 0.6", "51 16 0.6 -1.5");
    let positive = with("51 16 1.5 0.6", "51 16 0.6 1.5");
    assert_eq!(chosen(&text, Code::E201, 0), positive);
    let swapped = with("51 16 1.5 0.6", "51 16 -1.5 0.6");
    assert_eq!(chosen(&text, Code::E201, 1), swapped);
    assert_eq!(fixed(&text), text);
}

/// A profile whose points are written height first.
#[test]
fn coordinates_of_a_profile_swapped() {
    let text = with("40 1 2 1 0 1 2", "40 1 2 0 1 2 1");
    assert_eq!(chosen(&text, Code::W305, 0), MUG);
    let all = findings(&text);
    let help = all[0].wording(Language::Czech).help.unwrap();
    assert!(help.contains("vzdálenost od osy"), "{help}");
    // What has no volume either way is no choice.
    let flat = findings(&with("40 1 2 1 0 1 2", "40 1 2 0 1 0 2"));
    let axis = flat.iter().find(|d| d.code == Code::W305).unwrap();
    assert_eq!(axis.fixes, []);
}

/// An assignment without its type.
#[test]
fn an_assignment_without_its_type() {
    for (line, written) in [("44 -299 10 0", "44 10 0"), ("50 -299 0 20", "50 0 20")] {
        assert_eq!(fixed(&with(line, written)), MUG, "{written}");
    }
    let both = with("50 -299 0 20", "50 -299 11 20");
    assert_eq!(fixed(&both.replace("-299 11 20", "11 20")), both);
}

/// A point or a minus behind a number, and the one index of refraction by its name.
#[test]
fn signs_behind_numbers_and_an_index_by_its_name() {
    for (line, written) in [
        ("51 16 1.5 0.6", "51 16 1.5. 0.6"),
        ("81 -1 -4 6 5", "81 -1 4- 6 5"),
        ("50 -203 1.5 1.5 1.5", "50 ior 1.5"),
    ] {
        assert_eq!(fixed(&with(line, written)), MUG, "{written}");
    }
    // A radius may be above 1, a part of a colour may not.
    let ball = "2 9 2.5\n9 -501 0 0 9 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";
    assert_eq!(fixed(&ball.replace("2.5", "2.5.")), ball);
    let count = i64::MAX;
    assert!(!findings(&format!("2 2 {count} 0 1.5.\n{ball}")).is_empty());
}

/// A half-space that is turned round holds the camera.
#[test]
fn a_half_space_that_is_turned_round() {
    let text = with("60 4 0 1 0 0", "60 4 0 -1 0 0");
    assert_eq!(chosen(&text, Code::W325, 0), MUG);
    assert_eq!(fixed(&text), text);
}

/// A lamp that nothing moves, and things that only touch the floor.
#[test]
fn what_is_said_of_lamps_at_the_origin_and_of_touching_parts() {
    let all = findings(&with("81 -1 -4 6 5", ""));
    let inside = all.iter().find(|d| d.code == Code::W326).unwrap();
    let notes = inside.wording(Language::English).notes;
    assert!(
        notes
            .iter()
            .any(|n| n.contains("at the origin until it is moved")),
        "{notes:?}"
    );
    let text = with("72 -101 71 60", "72 -102 71 60");
    assert_eq!(chosen(&text, Code::W321, 0), MUG);
    assert_eq!(fixed(&text).matches("72 -102 71 60").count(), 1);
}

/// What is said of a command in a folder with the scene, and of the same in Czech.
fn says(dir: &std::path::Path, line: &str) -> [String; 2] {
    ["en", "cs"].map(|language| {
        let words: Vec<&str> = line.split(' ').chain(["--lang", language]).collect();
        let run = crate::support::program::zpg(dir, &words);
        [run.stdout, run.stderr]
            .map(|out| String::from_utf8(out).unwrap())
            .concat()
    })
}

/// Options and words of other programs.
#[test]
fn words_of_other_programs() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.zpg"), MUG).unwrap();
    for (line, words) in [
        ("render a.zpg --format png", ".png`"),
        ("check a.zpg --werror", "--deny warnings"),
        ("check a.zpg --strict", "--deny warnings"),
        ("check a.zpg -Werror", "--deny warnings"),
        ("check a.zpg --max-warnings 0", "--deny warnings"),
        ("render a.zpg --precision double", "f64"),
        ("convert a.zpg --to xml", "mitsuba"),
        ("explain boolean", "-101 B C"),
        ("explain opacity", "kd ks kt"),
        ("explain smooth", "nx1"),
    ] {
        for said in says(dir.path(), line) {
            assert!(said.replace('\n', " ").contains(words), "{line}: {said}");
        }
    }
    for line in ["render a.zpg --seed 3", "check a.zpg -Wall"] {
        let [said, _] = says(dir.path(), line);
        assert!(said.contains("there is no such option"), "{line}: {said}");
    }
}

/// Lines behind the end of a file, and parts that are gone.
#[test]
fn lines_behind_the_end_and_parts_that_are_gone() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.zpg"), MUG).unwrap();
    let said = says(dir.path(), "fmt a.zpg --range 100-200");
    assert!(said.iter().all(|said| said.contains("26")), "{said:?}");
    assert_eq!(
        std::fs::read_to_string(dir.path().join("a.zpg")).unwrap(),
        MUG
    );
    for part in ["1", "2"] {
        let line = format!("render a.zpg --size 40x30 --tile {part}/2 -o {part}.png");
        says(dir.path(), &line);
    }
    let [said, _] = says(dir.path(), "join 1.png 2.png -o whole.png");
    assert!(said.contains("removed its 2 parts"), "{said}");
}

/// The only camera is the one that is selected, and no proposal stands there twice.
#[test]
fn one_camera_and_one_proposal() {
    let text = MUG.replace("1 9999", "91 -502 80\n1 9999");
    assert_eq!(guessed(&text.replace("-502 80", "-502")), text);
    let text = with("40 1 2 1 0 1 2", "40 cylinder <0,0,0>, <0,2,0>, 1");
    let all = findings(&text);
    assert_eq!(all[0].fixes.len(), 1);
    assert_eq!(guessed(&text), MUG);
}

/// Brackets leave no spaces behind.
#[test]
fn brackets_leave_no_spaces() {
    for (line, written) in [
        ("42 -103 40 41", "42 difference { 40 41 }"),
        ("50 11 -2 0.7 1.2 0.7", "50 sphere { <-2, 0.7, 1.2>, 0.7 }"),
        ("81 -1 -4 6 5", "81 -1 ( -4 , 6 , 5 )"),
    ] {
        assert_eq!(fixed(&with(line, written)), MUG, "{written}");
    }
}
