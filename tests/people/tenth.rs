//! What two newcomers stumbled over, and what was meant.

use serde_json::Value;
use zpg::internals::analysis::{Analysis, fixing, repair};
use zpg::internals::diagnostics::{Applicability, Code, Diagnostic, Fix, fixes};

use super::{fixed, read, said};
use crate::support::program::{folder, text, zpg, zpg_with};

/// A camera, a lamp, and what is drawn.
const REST: &str = "9 -501 0 0 6 0 0 -1 0 1 0 45\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n";

/// A scene with a code, for which there is a guess.
const GUESSES: &[(&str, &str)] = &[
    ("W301", "2 9 1\n2 -701 255 0 51\n"),
    ("W302", "2 9 1\n2 -201 0.5 0.9 0\n"),
    ("W308", "3 9 1\n4 11 1 0 0 1\n3 -701 1 0 0\n2 -102 3 4\n"),
    ("W310", "2 9 1\n3 11 2 0 0 1\n4 -101 2 3\n"),
    ("W320", "2 14 0.3 1\n"),
    (
        "W321",
        "4 12 -1 -1 -1 1 1 1\n3 12 -.5 0 -.5 .5 1 .5\n2 -103 4 3\n",
    ),
    ("W323", "2 9 1\n"),
    ("W324", "2 9 1\n"),
    ("W327", "2 9 1\n2 -1 0 0 0\n"),
    ("N607", "2 12 -1 -1 -1 1 1 1\n2 -2 0.79 2\n"),
    ("E106", "2 9 1\n"),
];

/// The only error of a text, with what is proposed.
fn error(text: &str) -> Diagnostic {
    let all = repair::proposals(&read(text));
    let errors: Vec<Diagnostic> = all.into_iter().filter(Diagnostic::is_error).collect();
    let told: Vec<String> = errors.iter().flat_map(said).collect();
    assert_eq!(errors.len(), 1, "{text}{}", told.join("; "));
    errors[0].clone()
}

/// That the first proposal for the only error is what was meant, and is what is written.
fn is_meant(text: &str, meant: &str) {
    let error = error(text);
    let shown = fixes::apply(text, error.fixes.iter().take(1)).0;
    assert_eq!(shown, meant, "{}", said(&error).join("; "));
    assert_eq!(fixed(text), meant);
}

/// What `zpg check` promises of guesses for warnings and notes is what `--fix --unsafe-fixes` does.
#[test]
fn what_is_promised_of_guesses_is_done() {
    let dir = folder::<&str>(&[]);
    for (code, scene) in GUESSES {
        let rest = match *code {
            "W323" => REST.replace(" 45", " 0.785"),
            "W324" => REST.replace("0 0 -1", "0 0 1"),
            "E106" => REST.replace("1 9999 2 0\n", ""),
            _ => REST.to_owned(),
        };
        let scene = format!("{scene}{rest}");
        let run = |arguments: &[&str]| zpg_with(dir.path(), arguments, &scene);
        let json = run(&["check", "--format", "json", "-"]);
        let json: Value = serde_json::from_slice(&json.stdout).unwrap();
        let all = json["files"][0]["diagnostics"].as_array().unwrap();
        let finding = all.iter().find(|d| d["code"] == *code).expect(&scene);
        let said = text(&run(&["check", "-"]).stdout);
        let fixed = text(&run(&["check", "--fix", "--unsafe-fixes", "-"]).stdout);
        assert_ne!(finding["fixes"][0]["applicability"], "choice", "{said}");
        assert!(said.contains("--unsafe-fixes`."), "{said}");
        assert!(!said.contains("takes no guess"), "{said}");
        assert_ne!(fixed, scene);
    }
}

/// Where only the angle of view is out of range, no other number of a camera moves.
#[test]
fn angles_of_view_out_of_range() {
    let scene = |angle: &str| {
        let camera = format!("9 -501 2 5 16 -0.12 -0.3 -1 0 1 0 {angle}");
        format!(
            "2 9 1\n{}",
            REST.replace("9 -501 0 0 6 0 0 -1 0 1 0 45", &camera)
        )
    };
    for (angle, meant) in [
        ("350", Some("35")),
        ("450", Some("45")),
        ("3500", Some("35")),
        ("360", None),
        ("180", None),
        ("0", None),
    ] {
        let error = error(&scene(angle));
        let shown = |fix| fixes::apply(&scene(angle), [fix].into_iter()).0;
        let shown: Vec<String> = error.fixes.iter().map(shown).collect();
        assert_eq!(shown, Vec::from_iter(meant.map(scene)));
        assert!((error.fixes.iter()).all(|f| f.applicability == Applicability::Choice));
        assert_eq!(fixed(&scene(angle)), scene(angle));
    }
    is_meant(&scene("-35"), &scene("35"));
    // The angle stands before the up vector.
    let scene = format!("2 9 1\n{}", REST.replace("0 1 0 45", "45 0 1 0"));
    is_meant(&scene, &format!("2 9 1\n{REST}"));
}

/// Cones and cylinders from end to end, as POV-Ray has them, behind the type of a cone, and of a geodesic sphere.
#[test]
fn cones_from_end_to_end() {
    for numbers in [
        "0 2 0 0 0 0 0 1",
        "0 0 0 0.8 0 0.9 0 0",
        "0 0 0 1 0 2 0 0",
        "0 0 0 1 0 2 0 0.5",
        "0 1 0 1 0 3 0 0",
    ] {
        let by_name = fixed(&format!("2 cone {numbers}\n{REST}"));
        assert!(by_name.starts_with("2 1 2 "), "{by_name}");
        is_meant(&format!("2 16 {numbers}\n{REST}"), &by_name);
    }
    is_meant(
        &format!("2 16 0 0 0 0 2 0 0.5\n{REST}"),
        &format!("2 1 2 0.5 0 0.5 2\n{REST}"),
    );
    is_meant(
        &format!("2 13 0 0 0 0 1 0 0.5\n{REST}"),
        &format!("2 1 2 0.5 0 0.5 1\n{REST}"),
    );
    is_meant(
        &format!("2 13 1 0 2 1 1 2 0.5\n{REST}"),
        &format!("2 1 2 0.5 0 0.5 1\n2 -1 1 0 2\n{REST}"),
    );
    // The ends are not above each other.
    assert_eq!(error(&format!("2 13 0 0 0 1 1 0 0.5\n{REST}")).fixes, []);
    // Nothing in the shape, or nothing to be moved.
    for line in ["2 14 0 1 0 0 0 1 0 0", "2 12 0 0 0 0 1 1 1 2 3 1 0 0"] {
        assert_eq!(error(&format!("{line}\n{REST}")).fixes, []);
    }
    let text = format!("2 11 0 0 0 1 0 0 0\n{REST}");
    let all = error(&text).fixes;
    let is_move = |fix: &_| fixes::apply(&text, [fix].into_iter()).0.contains("2 -1 ");
    assert!(!all.iter().any(is_move));
}

/// A copied record has the ID of the one above, and its own properties have the right one.
#[test]
fn copied_definitions_with_properties() {
    for (scene, (written, meant)) in [
        (
            "2 12 -1 0 -1 1 2 1\n2 -701 0.8 0.2 0.1\n2 11 3 1 0 1\n3 -1 0 0 1\n3 -701 0.2 0.6 0.3\n4 -101 2 3\n",
            ("2 11", "3 11"),
        ),
        (
            "2 12 -1 0 -1 1 2 1\n2 11 3 1 0 1\n3 -201 0.5 0.4 0.1\n3 -3 1 2 1\n4 -101 2 3\n",
            ("2 11", "3 11"),
        ),
        (
            "24 1 4 0 0 1 0 1 1 0 1\n24 -701 1 0 0\n24 1 4 0 0 2 0 2 1 0 1\n25 -1 3 0 0\n25 -701 .2 .3 .4\n30 11 3 3 3 1\n31 -101 30 25\n4 -101 31 24\n",
            ("24 1 4 0 0 2", "25 1 4 0 0 2"),
        ),
    ] {
        let text = format!("{scene}{}", REST.replace("9999 2", "9999 4"));
        is_meant(&text, &text.replace(written, meant));
    }
}

/// What a Czech keyboard writes in place of digits and the minus.
#[test]
fn records_by_a_czech_keyboard() {
    let scene = |line: &str| format!("2 9 1\n{}", REST.replace("50 -1 3 5 5", line));
    for (written, meant) in [
        ("50 =1 4 7 6", "50 -1 4 7 6"),
        ("50 -1 0 0 =1", "50 -1 0 0 -1"),
        ("řé =+ č ý ž", "50 -1 4 7 6"),
        ("51 -401 é.2", "51 -401 0.2"),
        ("51 -401 é.5", "51 -401 0.5"),
        ("51 -401 é,8", "51 -401 0.8"),
    ] {
        is_meant(&scene(written), &scene(meant));
    }
}

/// A radius before its centre, a minus before an ID, the radii of an ellipsoid behind the type of a sphere.
#[test]
fn spheres_and_ids() {
    is_meant(
        &format!("2 11 0.6 0 6.6 0\n{REST}"),
        &format!("2 11 0 6.6 0 0.6\n{REST}"),
    );
    is_meant(
        &format!("2 11 0 1 0 1\n-2 -1 0 6 0\n{REST}"),
        &format!("2 11 0 1 0 1\n2 -1 0 6 0\n{REST}"),
    );
    let text = format!("2 11 4 1 3\n{REST}");
    let error = error(&text);
    assert_eq!(
        (error.code, error.fixes[0].applicability),
        (Code::E008, Applicability::Choice)
    );
    let shown = fixes::apply(&text, error.fixes.iter().take(1)).0;
    assert_eq!(shown, text.replace("2 11", "2 10"));
}

/// The texts that the proposals for the only error make, and whether `--unsafe-fixes` takes none.
fn choices(text: &str) -> (Vec<String>, bool) {
    let error = error(text);
    let each = error.fixes.iter();
    let made = each
        .map(|fix| fixes::apply(text, std::iter::once(fix)).0)
        .collect();
    let is_choice = |fix: &Fix| fix.applicability == Applicability::Choice;
    (made, error.fixes.iter().all(is_choice))
}

/// A radius before a centre whose last number is negative: a wider gap says so, else either may be meant.
#[test]
fn radii_before_negative_coordinates() {
    let sphere = |numbers: &str| format!("2 11 {numbers}\n{REST}");
    for (written, meant, is_open) in [
        (
            "1.2  -2 1.2 -1",
            &["-2  1.2 -1 1.2", "1.2  -2 1.2 1"][..],
            false,
        ),
        ("1.2 -2 1.2 -1", &["-2 1.2 -1 1.2", "1.2 -2 1.2 1"], true),
        ("1 0 0  -2", &["1 0 0  2", "0 0 -2  1"], true),
        // No radius is negative.
        ("-1 0 0 -2", &["-1 0 0 2"], true),
    ] {
        let (made, is_choice) = choices(&sphere(written));
        let meant: Vec<String> = meant.iter().map(|numbers| sphere(numbers)).collect();
        assert_eq!((made, is_choice), (meant, is_open), "{written}");
    }
    is_meant(&sphere("1.2  -2 1.2 -1"), &sphere("-2  1.2 -1 1.2"));
}

/// A comment of C before a record and within one.
#[test]
fn comments_of_c_before_something_else() {
    for (written, meant) in [
        ("/* ball */ 2 11 0 0 0 1", "# ball # 2 11 0 0 0 1"),
        ("/*ball*/2 11 0 0 0 1", "# ball #2 11 0 0 0 1"),
        ("2 11 /* right */ 2 0 0 1", "2 11 # right # 2 0 0 1"),
        (
            "/* a */ 2 11 /* b */ 2 0 0 1 /* c */",
            "# a # 2 11 # b # 2 0 0 1 # c #",
        ),
        (
            "2 11 /* right */ 2 0 0 1 // a ball",
            "2 11 # right # 2 0 0 1 # a ball #",
        ),
    ] {
        is_meant(&format!("{written}\n{REST}"), &format!("{meant}\n{REST}"));
    }
}

/// A checkerboard that has but its colours: a field of each in a unit.
#[test]
fn checkerboards_without_their_counts() {
    let scene = |board: &str| {
        let colours = "5 -701 1 1 1\n6 -701 0 0 0\n";
        format!("{colours}2 11 0 0 0 1\n2 -399 {board}\n{REST}")
    };
    is_meant(&scene("5 6"), &scene("1 1 5 6"));
    // A count and a colour.
    assert_ne!(fixed(&scene("4 5")), scene("1 1 4 5"));
}

/// A product for three numbers: POV-Ray's own arithmetic, or the number three times.
#[test]
fn products_for_three_numbers() {
    let scene = |line: &str| format!("2 11 0 0 0 1\n2 {line}\n{REST}");
    for (written, meant) in [
        ("-203 1.5*3", &["-203 1.5 1.5 1.5", "-203 4.5 4.5 4.5"][..]),
        ("-3 3*0.5", &["-3 0.5 0.5 0.5", "-3 1.5 1.5 1.5"]),
        ("-1 0.1*3", &["-1 0.1 0.1 0.1"]),
    ] {
        let meant: Vec<String> = meant.iter().map(|line| scene(line)).collect();
        assert_eq!(choices(&scene(written)), (meant, true), "{written}");
        assert_eq!(fixed(&scene(written)), scene(written));
    }
    is_meant(&scene("-203 0.75*2 1.5 1.5"), &scene("-203 1.5 1.5 1.5"));
}

/// Where a name is that of a translation, the command that writes one is told.
#[test]
fn translations_in_the_place_of_pictures() {
    let dir = folder(&[("scene.zpg", format!("2 9 1\n{REST}"))]);
    for ending in ["pov", "xml", "obj", "ply", "glb", "stl", "json"] {
        let name = format!("dobra.{ending}");
        for arguments in [&["scene.zpg", &name][..], &["scene.zpg", "-o", &name]] {
            let run = zpg(dir.path(), &[&["render"], arguments].concat());
            let told = text(&run.stderr);
            let right = format!("`zpg convert scene.zpg -o {name}`");
            assert!(told.replace("\n  ", " ").contains(&right), "{told}");
            assert_eq!(run.status.code(), Some(2));
        }
    }
}

/// What turns off what is off: never is the opposite proposed.
#[test]
fn options_that_turn_off_what_is_off() {
    let dir = folder::<&str>(&[]);
    for (option, told) in [
        ("--no-unsafe-fixes", "leave out `--unsafe-fixes`"),
        ("--no-force-exclude", "leave out `--force-exclude`"),
        ("--no-fix-only", "without any option"),
        ("--no-show-fixes", "without any option"),
    ] {
        let all = text(&zpg(dir.path(), &["check", option]).stderr).replace("\n  ", " ");
        assert!(all.contains("that is the default") && all.contains(told));
        assert!(
            !all.contains("did you mean") && !all.contains("Usage"),
            "{all}"
        );
    }
}

/// An answer that says what to write has no usage of another option.
#[test]
fn an_answer_without_a_usage() {
    let dir = folder::<&str>(&[]);
    let run = |arguments: &[&str]| text(&zpg(dir.path(), arguments).stderr);
    let all = run(&["check", "--show-fixes", "x"]);
    assert!(
        all.contains("`--diff`") && !all.contains("--show-files"),
        "{all}"
    );
    assert!(run(&["check", "--show-filez"]).contains("Usage"));
}

/// Words of no meaning in settings.
#[test]
fn settings_without_quotes() {
    for (settings, told) in [
        ("align = no\n", "write `true` or `false`"),
        ("[format]\ngroup = True\n", "write `true` or `false`"),
        ("[lint]\nW310 = off # here\n", "write `\"off\"`"),
        ("styl = \"off\"\n", "did you mean `lint.style`?"),
        ("style = \"off\"\n", "did you mean `lint.style`?"),
        ("widht = 80\n", "did you mean `format.width`?"),
    ] {
        let dir = folder(&[("zpg.toml", settings), ("a.zpg", "2 9 1\n1 9999 2 0\n")]);
        let all = text(&zpg(dir.path(), &["check"]).stderr).replace("\n  ", " ");
        assert!(all.contains(told), "{all}");
    }
}

/// Comments for ruff, unknown topics, the name of a translation, and points as the handout has them.
#[test]
fn smaller_things() {
    let scene = format!("2 9 1 # noqa: W307 #\n{REST}");
    let codes: Vec<Code> = read(&scene).findings().iter().map(|d| d.code).collect();
    assert_eq!(codes, [Code::S504]);
    // Those for black, too; other comments that begin alike are nobody's.
    for (comment, expected) in [
        ("# fmt: off #", &[Code::S504][..]),
        ("# fmt: on #", &[Code::S504]),
        ("# fmt: skip #", &[Code::S504]),
        ("# fmt: offset #", &[]),
    ] {
        let codes: Vec<Code> = read(&format!("2 9 1 {comment}\n{REST}"))
            .findings()
            .iter()
            .map(|d| d.code)
            .filter(|code| *code == Code::S504)
            .collect();
        assert_eq!(codes, expected, "{comment}");
    }
    let dir = folder(&[("scene.zpg", format!("2 9 1\n{REST}"))]);
    let run = |arguments: &[&str]| zpg(dir.path(), arguments);
    for word in ["veverka", "E999"] {
        let told = text(&run(&["explain", word]).stderr);
        assert!(told.contains("`zpg explain` lists all"), "{told}");
    }
    run(&["convert", "scene.zpg", "-o", "base.pov"]);
    let made = std::fs::read_to_string(dir.path().join("base.pov")).unwrap();
    assert!(made.contains("+Ibase.pov +Obase.png "), "{made}");
    // Nothing in a name ends the comment.
    run(&["convert", "scene.zpg", "-o", "a\nsphere { 0, 1 }.pov"]);
    let made = std::fs::read_to_string(dir.path().join("a\nsphere { 0, 1 }.pov")).unwrap();
    assert!(made.contains("+Iscene.pov +Oscene.png "), "{made}");
    let printed = text(&run(&["convert", "scene.zpg", "--to", "pov"]).stdout);
    assert!(printed.contains("+Iscene.pov +Oscene.png "));
    let told = text(&run(&["probe", "scene.zpg", "--point", "[0,6; 1; 1,2]"]).stderr);
    assert!(told.contains("`0.6 1 1.2`"), "{told}");
}

/// The place of a lamp on its line, where its numbers are a shape, too: the lamp does not stay at the origin.
#[test]
fn a_place_of_a_lamp_that_is_a_shape() {
    let scene = |lamp: &str, rest: &str| {
        format!("{lamp}\n{rest}2 11 0 0 0 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 2 0\n")
    };
    let line = "50 -402 1 5 9 5";
    let fix = |text: &str, is_unsafe: bool| {
        let mended = fixing::to_fixed_point(read(text), is_unsafe, Analysis::of);
        mended.analysis.source.text.clone()
    };
    for rest in ["", "50 -1 1 1 1\n"] {
        let text = scene(line, rest);
        assert_eq!(fix(&text, false), text);
        assert_eq!(fix(&text, true), scene("50 -402 1\n50 -1 5 9 5", rest));
    }
    // A ball of its own.
    let known = scene(line, "5 -1 2 2 2\n");
    let apart = scene("50 -402 1\n5 9 5", "5 -1 2 2 2\n");
    assert_eq!(fix(&known, false), apart);
    // A second lamp with the ID is another mistake.
    let again = error(&scene("50 -402 1 4 6 5", "50 -402 0.9\n"));
    assert!(said(&again).iter().any(|s| s.contains("`4 6 5`")));
    assert_eq!(again.fixes[0].applicability, Applicability::Choice);
}

/// What stands in the place of numbers: a name of a colour, an axis without its angle, one colour of two.
#[test]
fn words_in_the_place_of_numbers() {
    is_meant(
        &format!("2 9 1\n2 -701 fuchsiová\n{REST}"),
        &format!("2 9 1\n2 -701 1 0 1\n{REST}"),
    );
    is_meant(
        &format!("5 -701 0 1 0\n2 9 1\n2 -399 1 1 5 1 0 0\n{REST}"),
        &format!("5 -701 0 1 0\n2 9 1\n51 -701 1 0 0\n2 -399 1 1 5 51\n{REST}"),
    );
    let angle = error(&format!("2 9 1\n2 -2 y\n{REST}"));
    assert_eq!((angle.code, angle.case), (Code::E012, "angle"));
}

/// A second render record is not given the ID of the first one.
#[test]
fn a_second_render_record() {
    let again = error(&format!("2 9 1\n{REST}7 9999 2 0\n"));
    assert_eq!((again.code, again.case), (Code::E105, "again"));
    assert!(again.fixes.is_empty());
}
