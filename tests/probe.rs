//! `zpg probe` from outside: what it says about rays, pixels and points.

use crate::support::program::zpg_with;
use crate::trace_support;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use trace_support::Random;

fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = crate::support::program::command();
    command
        .arg("probe")
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn probe(folder: &Path, args: &[&str], input: &str) -> Output {
    zpg_with(folder, &[&["probe"], args].concat(), input)
}

fn folder(scene: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), scene).unwrap();
    dir
}

fn lines(out: &Output) -> Vec<Value> {
    let text = std::str::from_utf8(&out.stdout).unwrap();
    text.lines()
        .map(|l| serde_json::from_str(l).unwrap())
        .collect()
}

/// The answers to a question about a scene that must have some.
fn ask(scene: &str, args: &[&str], input: &str) -> Vec<Value> {
    let dir = folder(scene);
    let args: Vec<&str> = ["a.zpg"].iter().chain(args).copied().collect();
    let out = probe(dir.path(), &args, input);
    let errors = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(0), "{errors}");
    lines(&out)
}

fn one(scene: &str, args: &[&str]) -> Value {
    let mut all = ask(scene, args, "");
    assert_eq!(all.len(), 1);
    all.remove(0)
}

/// What a key says for every hit.
fn each(answer: &Value, key: &str) -> Vec<Value> {
    let hits = answer["hits"].as_array().unwrap();
    hits.iter().map(|h| h[key].clone()).collect()
}

const LOOK: &str = "900 -501 0 0 9 0 0 -1 0 1 0 45\n901 -401 1\n";
const DOWN: [&str; 2] = ["--ray", "0 0 9 0 0 -1"];

fn scene(records: &str, root: u32) -> String {
    format!("{records}\n{LOOK}1 9999 {root} 0\n")
}

#[test]
fn the_answer_about_a_sphere() {
    let answer = one(&scene("21 11 0 0 0 5", 21), &DOWN);
    let hits = json!([
        {"t": 4.0, "point": [0.0, 0.0, 5.0], "normal": [0.0, 0.0, 1.0], "uv": [0.75, 0.5],
         "object": 21, "shape": 21, "entering": true},
        {"t": 14.0, "point": [0.0, 0.0, -5.0], "normal": [0.0, 0.0, -1.0], "uv": [0.25, 0.5],
         "object": 21, "shape": 21, "entering": false},
    ]);
    let ray = json!({"origin": [0.0, 0.0, 9.0], "direction": [0.0, 0.0, -1.0]});
    let expected = json!({"ray": ray, "inside_at_origin": false, "hits": hits});
    assert_eq!(answer, expected);
}

#[test]
fn points_may_stand_in_brackets() {
    let scene = scene("2 11 0 0 0 1", 2);
    let plain = one(&scene, &DOWN);
    for ray in ["<0, 0, 9> <0, 0, -1>", "<0,0,9>,<0,0,-1>"] {
        assert_eq!(one(&scene, &["--ray", ray]), plain, "{ray}");
    }
}

#[test]
fn lengths_are_those_of_the_direction() {
    let answer = one(&scene("2 11 0 0 0 1", 2), &["--ray", "0 0 0 0 0 -4"]);
    assert_eq!(answer["inside_at_origin"], true);
    assert_eq!(each(&answer, "t"), [0.25]);
    assert_eq!(each(&answer, "entering"), [false]);
}

#[test]
fn a_cut_face_is_of_both() {
    // A box with a hole that a sphere makes, seen through the hole.
    let records = "2 12 -2 -2 -2 2 2 2\n3 11 0 0 2 1\n4 -103 2 3";
    let answer = one(&scene(records, 4), &DOWN);
    assert_eq!(each(&answer, "t"), [8.0, 11.0]);
    assert_eq!(each(&answer, "shape"), [3, 2]);
    assert_eq!(each(&answer, "object"), [2, 2]);
    let normals = each(&answer, "normal");
    assert_eq!(normals[0], json!([0.0, 0.0, 1.0]));
    let painted = format!("{records}\n4 -701 1 0 0\n5 -101 4 3");
    let answer = one(&scene(&painted, 4), &DOWN);
    assert_eq!(each(&answer, "shape"), [3, 2]);
    assert_eq!(each(&answer, "object"), [4, 4]);
}

#[test]
fn copies_own_what_the_copied_itself_owned() {
    let records = "2 11 0 0 0 1\n2 -701 1 0 0\n3 -105 2\n3 -1 0 0 -4\n4 -101 2 3\n\
                   5 -105 4\n5 -1 0 0 -10\n6 -101 4 5\n7 -105 4\n7 -201 1 0 0\n7 -1 0 0 -20\n\
                   8 -101 6 7";
    let answer = one(&scene(records, 8), &DOWN);
    assert_eq!(each(&answer, "shape"), [2, 2, 3, 3, 2, 2, 3, 3, 2, 2, 3, 3]);
    assert_eq!(
        each(&answer, "object"),
        [2, 2, 3, 3, 2, 2, 3, 3, 7, 7, 7, 7]
    );
}

#[test]
fn surfaces_have_no_inside() {
    let answer = one(&scene("2 3 0 0 1 0\n3 11 0 0 0 1\n4 -101 2 3", 4), &DOWN);
    assert_eq!(each(&answer, "shape"), [3, 2, 3]);
    assert_eq!(
        each(&answer, "entering"),
        [json!(true), json!(null), json!(false)]
    );
}

#[test]
fn the_box_hides_crossings_of_the_scene_only() {
    let records = "2 11 0 0 0 1\n3 11 0 0 -4 1\n4 -101 2 3";
    let boxed = format!("{records}\n{LOOK}1 9999 4 0 -2 -2 -4 2 2 0\n");
    let answer = one(&boxed, &["--ray", "0 0 0 0 0 -1"]);
    assert_eq!(answer["inside_at_origin"], true);
    assert_eq!(each(&answer, "t"), [1.0, 3.0]);
    assert_eq!(each(&answer, "entering"), [false, true]);
    let answer = one(&boxed, &["--object", "4", "--ray", "0 0 0 0 0 -1"]);
    assert_eq!(each(&answer, "t"), [1.0, 3.0, 5.0]);
    let point = ["--point", "0 0 0.5"];
    let answer = one(&boxed, &point);
    assert_eq!(answer["inside"], json!([2, 4]));
    assert_eq!(answer["in_scene"], false);
    let answer = one(&boxed, &["--object", "4", "--point", "0 0 0.5"]);
    assert_eq!(answer["in_scene"], true);
}

#[test]
fn an_object_needs_no_render_record() {
    let records = "2 11 0 0 0 1\n3 11 0 0 -4 1\n";
    let answer = one(records, &["--object", "3", "--ray", "0 0 9 0 0 -1"]);
    assert_eq!(each(&answer, "t"), [12.0, 14.0]);
}

/// What is not asked about is not spoken of.
#[test]
fn errors_alone_are_said() {
    let said = |scene: &str, args: &[&str]| {
        let dir = folder(scene);
        let args: Vec<&str> = ["a.zpg"].iter().chain(args).copied().collect();
        let out = probe(dir.path(), &args, "0 0 9 0 0 -1\n");
        let error = String::from_utf8(out.stderr).unwrap();
        assert_eq!(out.status.code(), Some(0), "{error}");
        error
    };
    // No camera, no light.
    let bare = "2 11 0 0 0 1\n1 9999 2 0\n";
    assert_eq!(said(bare, &DOWN), "");
    assert_eq!(said(bare, &["--rays", "-"]), "");
    assert_eq!(said(bare, &["--point", "0 0 0"]), "");
    let pixel = ["--pixel", "1,1", "--size", "3x3"];
    assert_eq!(said(bare, &pixel), "");
    assert_eq!(said(&scene("2 11 0 0 0 1", 2), &pixel), "");
    // No render record, which an object does without.
    let lone = "2 11 0 0 0 1\n";
    assert_eq!(said(lone, &["--object", "2", "--point", "0 0 0"]), "");
    // Two records share a line, and a colour is out of range: that is for check to say.
    let odd = "2 11 0 0 0 1 2 -701 9 0 0\n1 9999 2 0\n";
    assert_eq!(said(odd, &DOWN), "");
    // Without warnings errors are not fewer.
    let dir = folder("2 11 0 0 0 -1 2 -701 9 0 0\n1 9999 2 0\n");
    let out = probe(dir.path(), &["a.zpg", "--pixel", "0,0"], "");
    let error = String::from_utf8(out.stderr).unwrap();
    assert_eq!(out.status.code(), Some(1));
    assert!(
        error.contains("error[E201]") && error.contains("Found 1 error in 1 file"),
        "{error}"
    );
    assert!(
        !error.contains("W301") && !error.contains("S503"),
        "{error}"
    );
}

#[test]
fn commas_between_numbers() {
    let scene = scene("2 11 0 0 0 1", 2);
    let plain = one(&scene, &["--ray", "0 0 9 0 0 -1"]);
    for ray in ["0,0,9,0,0,-1", "0, 0, 9,  0, 0, -1", "0 0 9, 0 0 -1"] {
        assert_eq!(one(&scene, &["--ray", ray]), plain, "{ray}");
    }
    let point = one(&scene, &["--point", "0.5, 0,0"]);
    assert_eq!(point, one(&scene, &["--point", "0.5 0 0"]));
    let dir = folder(&scene);
    let out = probe(
        dir.path(),
        &["a.zpg", "--rays", "-"],
        "0,0,9,0,0,-1\n0 0 9 0 0 -1\n",
    );
    let lines = String::from_utf8(out.stdout).unwrap();
    let lines: Vec<&str> = lines.lines().collect();
    assert_eq!((lines.len(), lines[0]), (2, lines[1]));
    // Decimal commas make too many numbers.
    let out = probe(dir.path(), &["a.zpg", "--ray", "0,5 0 9 0 0 -1"], "");
    assert_eq!(out.status.code(), Some(2));
    let error = String::from_utf8(out.stderr).unwrap();
    let error = error.split_whitespace().collect::<Vec<_>>().join(" ");
    let told = "numbers have a decimal point: `0.5 0 9 0 0 -1`";
    assert!(error.contains(told), "{error}");
}

#[test]
fn a_pixel_is_a_ray_with_a_colour() {
    let records = "2 11 0 0 0 1\n2 -701 0.5 0.25 1";
    let answer = one(&scene(records, 2), &["--pixel", "1,1", "--size", "3x3"]);
    assert_eq!(answer["pixel"], json!([1, 1]));
    assert_eq!(answer["color"], json!([0.5, 0.25, 1.0]));
    assert_eq!(answer["ray"]["origin"], json!([0.0, 0.0, 9.0]));
    assert_eq!(each(&answer, "t"), [8.0, 10.0]);
    let other = format!("{records}\n8 -501 0 9 0 0 -1 0 0 0 1 45");
    let args = ["--pixel", "1,1", "--size", "3x3", "--camera", "8"];
    let answer = one(&scene(&other, 2), &args);
    assert_eq!(answer["ray"]["origin"], json!([0.0, 9.0, 0.0]));
}

#[test]
fn rays_come_one_a_line() {
    let rays = "# above #\n0 0 9 0 0 -1\n\n  1e0 0 9 0 0 -1 # beside\n5 0 9  0 0 -1";
    let answers = ask(&scene("2 11 0 0 0 2", 2), &["--rays", "-"], rays);
    let origins: Vec<&Value> = answers.iter().map(|a| &a["ray"]["origin"][0]).collect();
    assert_eq!(origins, [0.0, 1.0, 5.0]);
    assert_eq!(answers[2]["hits"], json!([]));
}

#[test]
fn many_rays_keep_their_order() {
    let mut r = Random(7);
    let mut rays = String::new();
    for i in 0..40_000 {
        let d = r.point(1.0);
        writeln!(rays, "{i} 0 9 {} {} {}", d[0], d[1], d[2]).unwrap();
    }
    let answers = ask(&scene("2 11 0 0 0 2", 2), &["--rays", "-"], &rays);
    assert_eq!(answers.len(), 40_000);
    for (i, answer) in answers.iter().enumerate() {
        assert_eq!(answer["ray"]["origin"][0], i as f64);
    }
}

/// A mark of UTF-8 at the start of the file is no part of the first ray; anywhere else it is no number.
#[test]
fn files_of_rays_may_begin_with_a_mark() {
    let dir = folder(&scene("2 11 0 0 0 2", 2));
    let rays = "\u{feff}0 0 9 0 0 -1\n1 0 9 0 0 -1\n";
    let out = probe(dir.path(), &["a.zpg", "--rays", "-"], rays);
    assert_eq!((lines(&out).len(), out.status.code()), (2, Some(0)));
    let out = probe(
        dir.path(),
        &["a.zpg", "--rays", "-"],
        &rays[3..].replace("\n1", "\n\u{feff}1"),
    );
    assert_eq!((lines(&out).len(), out.status.code()), (1, Some(2)));
}

/// The origins' x of the answers to a file of rays, and what was complained about; the status is 2.
fn origins_and_complaints(scene: &str, args: &[&str], rays: &str) -> (Vec<f64>, String) {
    let dir = folder(scene);
    let args: Vec<&str> = ["a.zpg", "--rays", "-"]
        .iter()
        .chain(args)
        .copied()
        .collect();
    let out = probe(dir.path(), &args, rays);
    let error = String::from_utf8(out.stderr.clone()).unwrap();
    assert_eq!(out.status.code(), Some(2), "{error}");
    let origins = lines(&out)
        .into_iter()
        .map(|a| a["ray"]["origin"][0].as_f64());
    (origins.map(Option::unwrap).collect(), error)
}

#[test]
fn bad_rays_are_left_out() {
    let scene = scene("2 11 0 0 0 2", 2);
    for (bad, reason) in [
        ("1 2 3 4 5", "expected 6 numbers, found 5"),
        ("1 2 3 4 5 6 7", "expected 6 numbers, found 7"),
        ("1 2 3 0 -0 0", "the direction is the zero vector"),
        ("1 2 x 0 0 1", "`x` is not a number"),
        ("1 2 nan 0 0 1", "`nan` is not a number"),
        ("1 2 1e999 0 0 1", "`1e999` is out of range"),
    ] {
        let rays = format!("0 0 9 0 0 -1\n# here #\n{bad}\n1 0 9 0 0 -1\n{bad}");
        let (origins, error) = origins_and_complaints(&scene, &[], &rays);
        assert_eq!(origins, [0.0, 1.0]);
        assert_eq!(
            error,
            format!("error: -:3: {reason}\nerror: -:5: {reason}\n")
        );
    }
}

#[test]
fn rays_that_a_precision_has_no_numbers_for_are_left_out() {
    let scene = scene("2 11 0 0 0 2", 2);
    let rays = "0 0 9 0 0 -1\n1 0 1e300 0 0 -1\n2 0 9 0 0 -1e-46\n3 0 9 0 0\n4 0 9 0 0 -1\n";
    let (origins, error) = origins_and_complaints(&scene, &["--precision", "f32"], rays);
    assert_eq!(origins, [0.0, 4.0]);
    let range = "this ray is out of the range of this precision";
    let complaints = [(2, range), (3, range), (4, "expected 6 numbers, found 5")];
    let complaints = complaints.map(|(line, reason)| format!("error: -:{line}: {reason}\n"));
    assert_eq!(error, complaints.concat());
    for precision in ["f64", "dd"] {
        let (origins, error) = origins_and_complaints(&scene, &["--precision", precision], rays);
        assert_eq!(origins, [0.0, 1.0, 2.0, 4.0]);
        assert_eq!(error, complaints[2]);
    }
}

#[test]
fn many_bad_rays_keep_their_order() {
    let mut rays = String::new();
    let mut complaints = String::new();
    for i in 0..40_000 {
        match i % 3 {
            0 => {
                writeln!(rays, "{i} 0 9 0 0").unwrap();
                let line = i + 1;
                writeln!(complaints, "error: -:{line}: expected 6 numbers, found 5").unwrap();
            }
            _ => writeln!(rays, "{i} 0 9 0 0 -1").unwrap(),
        }
    }
    let (origins, error) = origins_and_complaints(&scene("2 11 0 0 0 2", 2), &[], &rays);
    let good = (0..40_000).filter(|i| i % 3 != 0).map(f64::from);
    assert!(good.eq(origins));
    assert!(error == complaints);
}

#[test]
fn a_line_without_end_ends_the_file() {
    let scene = scene("2 11 0 0 0 2", 2);
    let ending = " ".repeat(65_536 - "1 0 9 0 0 -1\n".len());
    let rays = format!("0 0 9 0 0 -1\n1 0 9 0 0 -1{ending}\n2 0 9 0 0 -1 {ending}\n3 0 9 0 0 -1\n");
    let (origins, error) = origins_and_complaints(&scene, &[], &rays);
    assert_eq!(origins, [0.0, 1.0]);
    assert_eq!(error, "error: -:3: the line is longer than 65536 bytes\n");
}

#[test]
fn whoever_waits_for_an_answer_gets_it() {
    let dir = folder(&scene("2 11 0 0 0 2", 2));
    let mut child = command(dir.path(), &["a.zpg", "--rays", "-"])
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let mut answers = BufReader::new(child.stdout.take().unwrap()).lines();
    for z in 3..6 {
        writeln!(stdin, "0 0 {z} 0 0 -1").unwrap();
        let answer: Value = serde_json::from_str(&answers.next().unwrap().unwrap()).unwrap();
        assert_eq!(answer["hits"][0]["t"], f64::from(z - 2));
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
}

#[test]
fn wrong_usage() {
    let dir = folder(&scene("21 11 0 0 0 2\n30 -701 1 1 1", 21));
    for (args, words) in [
        (&["a.zpg"] as &[&str], "missing: <--ray"),
        (&["a.zpg", "--ray", "0 0 9 0 0 0"], "zero vector"),
        (
            &["a.zpg", "--ray", "0 0 9 0 0 -1", "--point", "0 0 0"],
            "cannot be used with",
        ),
        (&["-", "--rays", "-"], "cannot both be standard input"),
        (
            &["a.zpg", "--point", "0 0 0", "--object", "22"],
            "did you mean 21?",
        ),
        (
            &["a.zpg", "--point", "0 0 0", "--object", "30"],
            "30 is a colour, not an object",
        ),
        (
            &["a.zpg", "--pixel", "3,0", "--size", "3x3"],
            "not in a picture of 3x3",
        ),
        (
            &["a.zpg", "--pixel", "0,0", "--camera", "90"],
            "the scene has no camera 90; its cameras: 900",
        ),
        (
            &["a.zpg", "--point", "0 0 0", "--precision", "f16"],
            "there are f32, f64, dd",
        ),
        (&["b.zpg", "--point", "0 0 0"], "cannot read b.zpg"),
        (&["a.zpg", "--rays", "b.txt"], "cannot read b.txt"),
    ] {
        let out = probe(dir.path(), args, "");
        let error = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{args:?}: {error}");
        assert!(error.contains(words), "{args:?}: {error}");
        assert!(out.stdout.is_empty());
    }
    let dir = folder("2 11 0 0 0\n");
    let out = probe(
        dir.path(),
        &["a.zpg", "--point", "0 0 0", "--object", "2"],
        "",
    );
    assert_eq!(out.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&out.stderr).contains("E008"));
}

#[test]
fn solids_that_hold_a_point() {
    // 4 takes 3 away from 2; 7 is a complement; 8 a copy of 4.
    let records = "2 11 0 0 0 2\n3 11 1 0 0 1\n4 -103 2 3\n5 5 -1 -1 1 1\n6 -101 4 5\n\
                   7 -104 2\n8 -105 4\n8 -1 10 0 0\n9 -101 6 8\n10 -101 9 7\n";
    let inside = |root: u32, point: &str| {
        let answer = one(&scene(records, root), &["--point", point]);
        (answer["inside"].clone(), answer["in_scene"].clone())
    };
    assert_eq!(inside(9, "-1 0 0"), (json!([2, 4, 6, 9]), json!(true)));
    assert_eq!(inside(9, "1 0 0"), (json!([2, 3]), json!(false)));
    assert_eq!(inside(9, "9 0 0"), (json!([2, 8, 9]), json!(true)));
    assert_eq!(inside(10, "0 7 0"), (json!([7, 10]), json!(true)));
    // On the boundary: in the shape, out of what it is taken away from.
    assert_eq!(inside(9, "-2 0 0"), (json!([2, 4, 6, 9]), json!(true)));
    assert_eq!(inside(9, "0 0 0"), (json!([2, 3]), json!(false)));
    assert_eq!(inside(10, "0 0 2"), (json!([2, 4, 6, 9, 10]), json!(true)));
}

/// `--precision` does not apply to points, and is not refused.
#[test]
fn points_are_the_same_in_every_precision() {
    let scene = scene("2 11 0 0 0 1\n3 -105 2\n3 -1 0.1 0 0\n4 -101 2 3", 4);
    // The last one is in the sphere by less than single precision can tell, if it is in.
    for point in ["0.5 0 0", "1.05 0 0", "-1 0 0", "1.0999999999 0 0"] {
        let answers = ["f32", "f64", "dd"]
            .map(|precision| one(&scene, &["--point", point, "--precision", precision]));
        assert!(answers.iter().all(|a| *a == answers[1]), "{answers:?}");
        assert_eq!(answers[1]["in_scene"], true);
    }
}

#[test]
fn doubled_scenes_are_not_expanded() {
    let mut records = String::from("2 11 0 0 0 1\n");
    let mut last = 2;
    for level in 0..30 {
        let (copy, both) = (last + 1, last + 2);
        let step = 3.0 * f64::from(1u32 << level);
        writeln!(records, "{copy} -105 {last}\n{copy} -1 {step} 0 0").unwrap();
        writeln!(records, "{both} -101 {last} {copy}").unwrap();
        last = both;
    }
    let scene = scene(&records, last);
    let ask = |x: f64| one(&scene, &["--point", &format!("{x} 0 0.5")]);
    let answer = ask(0.0);
    let evens: Vec<u32> = (1..=31).map(|i| 2 * i).collect();
    assert_eq!(answer["inside"], json!(evens));
    // The last of all is in copies only.
    let answer = ask(3.0 * f64::from((1u32 << 30) - 1));
    let odds: Vec<u32> = (1..=30).map(|i| 2 * i + 1).chain([last]).collect();
    assert_eq!(answer["inside"], json!(odds));
    assert_eq!(ask(1.5)["inside"], json!([]));
    // The same thing thirty times over, all in one place.
    let mut records = String::from("2 11 0 0 0 1\n");
    for id in 3..33 {
        writeln!(records, "{id} -101 {0} {0}", id - 1).unwrap();
    }
    let answer = one(&self::scene(&records, 32), &["--point", "0 0 0.5"]);
    assert_eq!(answer["inside"], json!((2..33).collect::<Vec<u32>>()));
}

/// Random solids over spheres, boxes and half-spaces; IDs 2 to `last`.
fn random_records(r: &mut Random, shapes: u32) -> (String, u32) {
    let mut out = String::new();
    for id in 2..2 + shapes {
        let p = r.point(1.5);
        let s = r.within(0.4, 1.5);
        match r.below(3) {
            0 => writeln!(out, "{id} 11 {} {} {} {s}", p[0], p[1], p[2]),
            1 => writeln!(
                out,
                "{id} 12 {} {} {} {} {} {}",
                p[0],
                p[1],
                p[2],
                p[0] + s,
                p[1] + s,
                p[2] + s
            ),
            _ => writeln!(out, "{id} 4 {} {} {} {}", p[0], p[1], p[2], s - 1.0),
        }
        .unwrap();
    }
    let last = 1 + 3 * shapes;
    for id in 2 + shapes..=last {
        let before = u64::from(id - 2);
        let mut pick = || 2 + r.below(before);
        let (a, b) = (pick(), pick());
        match r.below(6) {
            0 => writeln!(out, "{id} -102 {a} {b}"),
            1 => writeln!(out, "{id} -103 {a} {b}"),
            2 => writeln!(out, "{id} -104 {a}"),
            3 => writeln!(
                out,
                "{id} -105 {a}\n{id} -2 {} 2\n{id} -1 0.3 -0.2 0.1",
                10 * b
            ),
            _ => writeln!(out, "{id} -101 {a} {b}"),
        }
        .unwrap();
    }
    (out, last)
}

#[test]
fn membership_is_the_parity_of_crossings() {
    let mut r = Random(23);
    for round in 0..12 {
        let (records, last) = random_records(&mut r, 2 + round % 5);
        let scene = scene(&records, last);
        let dir = folder(&scene);
        for _ in 0..3 {
            let p = r.point(2.0);
            let point = format!("{} {} {}", p[0], p[1], p[2]);
            let member = one(&scene, &["--point", &point]);
            let mut rays = String::new();
            for _ in 0..50 {
                let d = r.point(1.0);
                writeln!(rays, "{point} {} {} {}", d[0], d[1], d[2]).unwrap();
            }
            let inside = member["in_scene"] == true;
            let has_root = member["inside"].as_array().unwrap().contains(&json!(last));
            assert_eq!(has_root, inside);
            let out = probe(dir.path(), &["a.zpg", "--rays", "-"], &rays);
            for answer in lines(&out) {
                check(&answer, inside, &scene);
            }
        }
    }
}

/// Sides alternate from the one given, t ascends, normals are units against what is entered.
fn check(answer: &Value, inside: bool, scene: &str) {
    assert_eq!(answer["inside_at_origin"], inside, "{scene}\n{answer}");
    let (mut now, mut last) = (inside, 0.0);
    let d = numbers(&answer["ray"]["direction"]);
    for hit in answer["hits"].as_array().unwrap() {
        let t = hit["t"].as_f64().unwrap();
        assert!(t > last, "{answer}");
        assert_eq!(hit["entering"], !now, "{scene}\n{answer}");
        let n = numbers(&hit["normal"]);
        let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
        assert!((dot(n, n) - 1.0).abs() < 1e-12);
        assert_eq!(dot(n, d) < 0.0, !now, "{answer}");
        (now, last) = (!now, t);
    }
}

fn numbers(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| value[i].as_f64().unwrap())
}

#[test]
fn every_listed_solid_holds_the_point_alone_too() {
    let mut r = Random(41);
    for _ in 0..6 {
        let (records, last) = random_records(&mut r, 3);
        let plain = records.lines().all(|l| !l.contains("-105"));
        let scene = scene(&records, last);
        let p = r.point(1.0);
        let point = format!("{} {} {}", p[0], p[1], p[2]);
        let answer = one(&scene, &["--point", &point]);
        for id in answer["inside"].as_array().unwrap() {
            // Below a copy that was moved a solid may hold the point where it is itself not.
            if plain || *id == json!(last) {
                let alone = one(&scene, &["--point", &point, "--object", &id.to_string()]);
                assert_eq!(alone["in_scene"], true, "{scene}\n{id}");
            }
        }
    }
}

#[test]
fn equal_sets_give_equal_answers() {
    let shapes = "2 11 0 0 0 1.5\n3 12 -1 -1 -1 2 1 1\n";
    let pairs = [
        ("4 -103 2 3", "4 -104 3\n5 -102 2 4"),
        ("4 -102 2 3", "4 -104 2\n5 -104 3\n6 -101 4 5\n7 -104 6"),
        ("4 -101 2 3", "4 -103 2 3\n5 -101 4 3"),
    ];
    let mut r = Random(5);
    let mut rays = String::new();
    for _ in 0..200 {
        let (o, d) = (r.point(3.0), r.point(1.0));
        writeln!(
            rays,
            "{} {} {} {} {} {}",
            o[0], o[1], o[2], d[0], d[1], d[2]
        )
        .unwrap();
    }
    for (a, b) in pairs {
        let [a, b] = [a, b].map(|text| {
            let records = format!("{shapes}{text}");
            let root = text.lines().last().unwrap().split(' ').next().unwrap();
            ask(
                &scene(&records, root.parse().unwrap()),
                &["--rays", "-"],
                &rays,
            )
        });
        for (a, b) in a.iter().zip(&b) {
            for key in ["t", "point", "normal", "entering", "shape"] {
                assert_eq!(each(a, key), each(b, key), "{key}");
            }
        }
    }
}

/// Rays that nearly lie in a surface: the rounding of a coordinate, over such a slope, moves the
/// crossing far along the ray. Doubles know, and say what double-double numbers say.
#[test]
fn shallow_crossings_are_those_of_double_double() {
    let cylinder = "2 15 1 0 0 0  0 1 0 0  0 0 0 0  0 0 0 -1\n";
    let cut = |by: &str| format!("{cylinder}3 4 0 0 1 {by}\n4 -102 2 3\n1 9999 4 0\n");
    let skew = "2 4 1 2 3 0\n3 4 3 -3 1 -17.509375506009484\n4 -102 2 3\n1 9999 4 0\n";
    for (scene, ray) in [
        (cut("0"), "1.0000000000000002 0 -4 -6.1e-17 0 1"),
        (
            cut("4.424344024300808e-05"),
            "1.000000000004 0 -4 -1e-12 0 1",
        ),
        (
            skew.to_owned(),
            "2.99999999999995 -1e-13 -1.00000000000015 3.0000000000001 -2.9999999999998 1.0000000000003",
        ),
        (
            "2 18 .5\n1 9999 2 0\n".to_owned(),
            "0.3 0.36 -4 1e-17 -1e-17 1",
        ),
        (
            "2 18 .5\n1 9999 2 0\n".to_owned(),
            "0.3 0.36 -4 -1e-17 1e-17 1",
        ),
        (
            "2 19\n1 9999 2 0\n".to_owned(),
            "1.25 0.75 -4 1.25e-17 -7.5e-18 1",
        ),
    ] {
        let dir = folder(&scene);
        let [double, exact] = ["f64", "dd"].map(|precision| {
            let args = ["a.zpg", "--ray", ray, "--precision", precision];
            let answer: serde_json::Value =
                serde_json::from_slice(&probe(dir.path(), &args, "").stdout).unwrap();
            let hits = answer["hits"].as_array().unwrap().clone();
            let t = hits.iter().map(|h| match &h["t"] {
                serde_json::Value::String(digits) => digits.parse().unwrap(),
                number => number.as_f64().unwrap(),
            });
            let t: Vec<f64> = t.collect();
            let sides: Vec<_> = hits
                .iter()
                .map(|h| (h["shape"].clone(), h["entering"].clone()))
                .collect();
            (answer["inside_at_origin"].clone(), sides, t)
        });
        assert_eq!((&double.0, &double.1), (&exact.0, &exact.1), "{ray}");
        for (a, b) in double.2.iter().zip(&exact.2) {
            assert!((a - b).abs() <= 1e-15 * b.abs(), "{ray}: {a} {b}");
        }
    }
}

/// Numbers need no quotes.
#[test]
fn numbers_as_several_arguments() {
    let scene = "2 11 0 1 0 1\n1 9999 2 0\n";
    for (whole, several) in [
        (
            &["--ray", "0 1 9  0 0 -1"][..],
            &["--ray", "0", "1", "9", "0", "0", "-1"][..],
        ),
        (&["--point", "0 1 .5"], &["--point", "0,", "1,", ".5"]),
        (&["--pixel", "320,240"], &["--pixel", "320", "240"]),
    ] {
        assert_eq!(one(scene, whole), one(scene, several));
    }
    let dir = folder(scene);
    let run = probe(dir.path(), &["--point", "0", "1", "0", "a.zpg"], "");
    assert_eq!(run.status.code(), Some(0));
    let run = probe(dir.path(), &["--point", "0", "1", "a.zpg"], "");
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(said.contains("expected 3 numbers"), "{said}");
}
