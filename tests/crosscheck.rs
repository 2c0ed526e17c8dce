//! `zpg crosscheck` from outside, with the real POV-Ray.

use crate::support::program::zpg;
use std::fs;
use std::path::Path;

#[cfg(unix)]
use crate::support::endless::Endless;
use crate::support::{mitsuba, program};

/// A ball on a checkered floor, seen from above.
const SCENE: &str = "2 11 0 1 0 1\n2 -701 0.9 0.2 0.1\n3 12 -5 -1 -5 5 0 5\n4 -701 0.2 0.4 0.9\n\
    5 -701 0.9 0.9 0.6\n3 -302 4 5 1\n6 -101 2 3\n7 -402 1\n7 -1 4 8 6\n8 -401 0.2\n\
    9 -501 0 4 8 0 -0.4 -1 0 1 0 40\n1 9999 6 0\n";

fn folder(scene: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), scene).unwrap();
    dir
}

/// A program of some lines of shell.
fn script_in(folder: &Path, lines: &str) -> String {
    let path = folder.join("script");
    fs::write(&path, format!("#!/bin/sh\n{lines}")).unwrap();
    #[cfg(unix)]
    fs::set_permissions(&path, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Both programs, and where they are.
fn programs() -> [(&'static str, String); 2] {
    let python = mitsuba::python().to_str().unwrap().to_owned();
    [("povray", "povray".to_owned()), ("mitsuba", python)]
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
#[ignore = "needs POV-Ray"]
fn a_scene_agrees() {
    let dir = folder(SCENE);
    let args = ["crosscheck", "a.zpg", "--with", "povray", "--size", "96x72"];
    let run = zpg(dir.path(), &args);
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    let errors = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{said}{errors}");
    assert!(
        said.starts_with("a.zpg with povray, 96x72: agrees"),
        "{said}"
    );
    let out = dir.path().join("a-povray");
    let json = fs::read_to_string(out.join("crosscheck.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let picture = &json["pictures"][0];
    assert_eq!(picture["pixels"], 96 * 72);
    assert_eq!(picture["differing"]["off_silhouettes"], 0);
    // On the outline of the ball, its shadow's and those of the checks: some of some hundred pixels.
    let silhouettes = picture["differing"]["on_silhouettes"].as_u64().unwrap();
    assert!(silhouettes < 200, "{silhouettes}");
    // The answer says how much of the picture it is about.
    let edges = picture["differing"]["on_other_edges"].as_u64().unwrap();
    let left_out = silhouettes + edges + picture["total_reflection"].as_u64().unwrap();
    let share = 1.0 - left_out as f64 / (96.0 * 72.0);
    assert!((picture["compared"].as_f64().unwrap() - share).abs() < 1e-12);
    let whole = "a.zpg with povray, 96x72: agrees\n".to_owned();
    let part = format!(
        "a.zpg with povray, 96x72: agrees where compared ({} %)\n",
        (100.0 * share) as u32
    );
    assert!(
        said.starts_with(if left_out == 0 { &whole } else { &part }),
        "{said}"
    );
    let size = |name: &str| image::image_dimensions(out.join(name)).unwrap();
    for name in ["ours.png", "theirs.png", "difference.png"] {
        assert_eq!(size(name), (96, 72), "{name}");
    }
    // All three, with a title above each, and below what the colours mean.
    let read = |name: &str| image::open(out.join(name)).unwrap().to_rgb8();
    let sheet = read("side-by-side.png");
    assert_eq!(sheet.width(), 3 * 96);
    let white = |column: u32| {
        let dots = (0..28).flat_map(|y| (0..96).map(move |x| (96 * column + x, y)));
        dots.filter(|&(x, y)| sheet.get_pixel(x, y).0 == [255; 3])
            .count()
    };
    for (column, name) in (0..).zip(["ours.png", "theirs.png", "difference.png"]) {
        assert!(white(column) > 50, "no title over {name}");
        let alone = read(name);
        let within = image::imageops::crop_imm(&sheet, 96 * column, 28, 96, 72).to_image();
        assert!(within == alone, "{name}");
    }
    assert!(sheet.height() > 28 + 72 + 17);
}

#[test]
#[ignore = "needs POV-Ray"]
fn other_pictures_differ() {
    // A program that always takes the picture of a darker scene.
    let dir = folder(SCENE);
    let dark = SCENE.replace("7 -402 1", "7 -402 0.5");
    fs::write(dir.path().join("dark.zpg"), dark).unwrap();
    let script = "\
        for a in \"$@\"; do case $a in +I*) f=${a#+I};; esac; done\n\
        cp ../dark.pov \"$f\"\nexec povray \"$@\"\n";
    let program = script_in(dir.path(), script);
    let convert = [
        "convert", "dark.zpg", "--to", "pov", "-o", "dark.pov", "--size", "96x72",
    ];
    assert!(zpg(dir.path(), &convert).status.success());
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "povray",
        "--size",
        "96x72",
        "--json",
    ];
    let run = zpg(dir.path(), &[&args[..], &["--program", &program]].concat());
    assert_eq!(
        run.status.code(),
        Some(1),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["agrees"], false);
    let picture = &json["pictures"][0];
    assert!(
        picture["differing"]["share_off_silhouettes"]
            .as_f64()
            .unwrap()
            > 0.5
    );
    assert!(picture["flip"].as_f64().unwrap() > 0.05);
    // The floor is the largest part of the picture. No more of it can differ than all that does.
    let (mostly, differing) = (&picture["mostly"], &picture["differing"]["off_silhouettes"]);
    assert_eq!(mostly["shape"], 3);
    let pixels = mostly["pixels"].as_u64().unwrap();
    assert!(
        pixels > 2000 && pixels < differing.as_u64().unwrap(),
        "{mostly}"
    );
    assert_eq!(mostly["rows"][1], 71);
    let text_only = zpg(
        dir.path(),
        &[&args[..args.len() - 1], &["--program", &program]].concat(),
    );
    let said = text(&text_only.stdout);
    assert!(
        said.contains(&format!(
            "most of them       {pixels} where 3 (box) is seen, in the rows "
        )),
        "{said}"
    );
}

/// POV-Ray's picture of a scene without one of its lamps.
#[test]
#[ignore = "needs POV-Ray"]
fn a_scene_without_a_lamp_differs() {
    let lamp = "20 -402 0.4\n20 -1 -4 3 2\n";
    let dir = folder(&SCENE.replace("1 9999", &format!("{lamp}1 9999")));
    // The light of the lamp is taken out of the file that POV-Ray is given.
    let script = "for a in \"$@\"; do case $a in +I*) f=${a#+I};; esac; done\n\
        grep -q '// 20$' \"$f\" || exit 7\n\
        sed -i '/^light_source.*\\/\\/ 20$/d' \"$f\"\nexec povray \"$@\"\n";
    let program = script_in(dir.path(), script);
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "povray",
        "--size",
        "96x72",
        "--json",
    ];
    for (more, agrees) in [(&[][..], true), (&["--program", &program], false)] {
        let run = zpg(dir.path(), &[&args[..], more].concat());
        let (said, errors) = (text(&run.stdout), text(&run.stderr));
        assert_eq!(
            run.status.code(),
            Some(i32::from(!agrees)),
            "{said}{errors}"
        );
        let json: serde_json::Value = serde_json::from_str(&said).unwrap();
        let differing = &json["pictures"][0]["differing"];
        assert_eq!(differing["off_silhouettes"] == 0, agrees, "{said}");
    }
}

/// Nothing is written over a picture that the scene uses, whatever the folder.
#[test]
#[ignore = "needs POV-Ray and Mitsuba"]
fn pictures_of_the_scene_stay() {
    for (with, path) in programs() {
        let own = match with {
            "povray" => "a_image_1.png",
            _ => "a_texture_0.png",
        };
        for picture in ["ours.png", own] {
            let dir = folder(&format!("2 5 -1 -1 1 1\n2 -301 {picture}\n1 9999 2 0\n"));
            let file = dir.path().join(picture);
            image::RgbImage::new(2, 2).save(&file).unwrap();
            let before = fs::read(&file).unwrap();
            let args = ["crosscheck", "a.zpg", "--with", with, "--program", &path];
            let run = zpg(
                dir.path(),
                &[&args[..], &["--size", "16x12", "-o", "."]].concat(),
            );
            assert_eq!(run.status.code(), Some(2), "{}", text(&run.stdout));
            assert!(text(&run.stderr).contains(picture), "{}", text(&run.stderr));
            assert_eq!(fs::read(&file).unwrap(), before);
        }
    }
}

#[test]
#[ignore = "needs Mitsuba"]
fn geometry_agrees_with_mitsuba() {
    let dir = folder(SCENE);
    let python = mitsuba::python();
    let python = python.to_str().unwrap();
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "mitsuba",
        "--size",
        "96x72",
        "--json",
    ];
    let run = zpg(dir.path(), &[&args[..], &["--program", python]].concat());
    let errors = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{errors}");
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let picture = &json["pictures"][0];
    assert_eq!(
        (picture["pixels"].as_u64(), picture["wrong"].as_u64()),
        (Some(96 * 72), Some(0))
    );
    // The ball is a sphere there; the floor with its texture is a mesh.
    for kind in ["exact", "meshes"] {
        assert!(picture[kind]["pixels"].as_u64().unwrap() > 300, "{picture}");
        assert!(
            picture[kind]["distance_by_allowed"].as_f64().unwrap() < 1.0,
            "{picture}"
        );
    }
    assert!(picture["exact"]["distance"].as_f64().unwrap() < 1e-4 * 12.0);
    for name in [
        "ours.png",
        "theirs.png",
        "difference.png",
        "side-by-side.png",
        "a.xml",
    ] {
        assert!(dir.path().join("a-mitsuba").join(name).exists(), "{name}");
    }
    let none = [&args[..], &["--program", "./nowhere"]].concat();
    let run = zpg(dir.path(), &none);
    assert_eq!(run.status.code(), Some(2));
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(
        said.contains("error: there is no program ") && said.contains("nowhere\n"),
        "{said}"
    );
}

/// The pit of a bitten ball, the outside of a ball, and a rectangle, which has no outside: both pictures show them in
/// the same colours.
#[test]
#[ignore = "needs Mitsuba"]
fn normals_of_both_have_the_same_colours() {
    let dir = folder(
        "2 11 -1 1 0 1\n3 11 -0.5 1.5 1 0.7\n4 -103 2 3\n5 11 1.5 1 0 1\n6 5 -3 -0.5 3 3\n6 -1 0 0 -2\n\
         7 -101 4 5\n8 -101 7 6\n9 -501 0 3 8 0 -0.25 -1 0 1 0 40\n1 9999 8 0\n",
    );
    let python = mitsuba::python();
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "mitsuba",
        "--size",
        "96x72",
    ];
    let run = zpg(
        dir.path(),
        &[&args[..], &["--program", python.to_str().unwrap()]].concat(),
    );
    let said = text(&run.stdout);
    assert_eq!(run.status.code(), Some(0), "{said}{}", text(&run.stderr));
    assert!(
        said.starts_with("a.zpg with mitsuba, 96x72: agrees where compared ("),
        "{said}"
    );
    let read = |name: &str| {
        image::open(dir.path().join("a-mitsuba").join(name))
            .unwrap()
            .to_rgb8()
    };
    let [ours, theirs, difference] = ["ours.png", "theirs.png", "difference.png"].map(read);
    let mut compared = 0;
    for ((a, b), kind) in ours.pixels().zip(theirs.pixels()).zip(difference.pixels()) {
        // Silhouettes are grey.
        if kind.0 != [60; 3] {
            compared += usize::from(a.0 != [0; 3]);
            let apart = (0..3).map(|k| a.0[k].abs_diff(b.0[k])).max();
            // Those of a mesh, where the bite is, differ a little.
            assert!(apart < Some(16), "{a:?} {b:?}");
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// A matrix for pictures that are half as wide again as they are high.
#[test]
#[ignore = "needs POV-Ray"]
fn pixels_that_are_no_squares() {
    let look = |matrix: &str, size: &str| {
        let camera = "2 9 1\n9 -501 0 0 8 0 0 -1 0 1 0 40\n1 9999 2 0\n9 -99 ";
        let dir = folder(&format!("{camera}{matrix}\n"));
        let [(_, _), (with, python)] = programs();
        let args = ["crosscheck", "a.zpg", "--with", with, "--program", &python];
        let run = zpg(dir.path(), &[&args[..], &["--size", size]].concat());
        let to = ["convert", "a.zpg", "--to", "mitsuba", "-o", "a.xml"];
        let converted = zpg(dir.path(), &[&to[..], &["--size", size]].concat());
        (
            run.status.code(),
            text(&run.stderr),
            text(&converted.stderr),
        )
    };
    let square = "1.2 0 0.2 0  0 1.8 0.05 0  0 0 -1.02 -2.02  0 0 -1 0";
    let (status, said, report) = look(square, "32x25");
    assert_eq!(status, Some(1), "{said}");
    assert!(said.contains("not squares at 32x25, "), "{said}");
    // 25 rows have no whole number of pixels; 24 have.
    assert!(said.contains("choose --size 36x24"), "{said}");
    assert!(report.contains("pixels are made square: choose --size 36x24"));
    for size in ["36x24", "39x26"] {
        let (status, said, report) = look(square, size);
        assert_eq!(status, Some(0), "{said}");
        assert!(!report.contains("made square"), "{report}");
    }
    let skewed = "1.2 0.3 0.2 0  0 1.8 0.05 0  0 0 -1.02 -2.02  0 0 -1 0";
    let (status, said, report) = look(skewed, "32x24");
    assert_eq!(status, Some(1));
    assert!(said.contains("no other --size helps"), "{said}");
    assert!(report.contains("no --size helps"), "{report}");
}

#[test]
fn what_is_missing_is_said() {
    let dir = folder(SCENE);
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "povray",
        "--program",
        "./nowhere",
    ];
    let run = zpg(dir.path(), &args);
    assert_eq!(run.status.code(), Some(2));
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(
        said.contains("error: there is no program ") && said.contains("nowhere\n"),
        "{said}"
    );
    // What was prepared for the program goes, too.
    assert!(!dir.path().join("a-povray").exists());
    let with = [
        "crosscheck",
        "a.zpg",
        "--with",
        "mitsuba",
        "--program",
        "./nowhere",
    ];
    assert_eq!(zpg(dir.path(), &with).status.code(), Some(2));
    assert!(!dir.path().join("a-mitsuba").exists());
    // A folder that was there before stays.
    fs::create_dir(dir.path().join("mine")).unwrap();
    zpg(dir.path(), &[&with[..], &["-o", "mine"]].concat());
    assert!(dir.path().join("mine").exists());
    // A name is looked for where programs are, and said as it is.
    let named = [&args[..5], &["nowhere-at-all"]].concat();
    let said = String::from_utf8_lossy(&zpg(dir.path(), &named).stderr).into_owned();
    assert!(said.contains(" (`nowhere-at-all` was tried)"), "{said}");
    let run = zpg(dir.path(), &["crosscheck", "b.zpg", "--with", "povray"]);
    assert_eq!(run.status.code(), Some(2));
    let run = zpg(
        dir.path(),
        &[&args[..], &["--size", "99999x99999"]].concat(),
    );
    assert_eq!(run.status.code(), Some(2));
    fs::write(dir.path().join("b.zpg"), "2 9 1\n").unwrap();
    let run = zpg(dir.path(), &["crosscheck", "b.zpg", "--with", "povray"]);
    assert_eq!(run.status.code(), Some(1));
}

#[test]
#[ignore = "needs POV-Ray"]
fn files_may_be_called_anything() {
    let dir = folder(SCENE);
    for name in ["-two words", "kůň.v1", "it's \"<&>\" %20"] {
        let file = format!("{name}.zpg");
        fs::write(dir.path().join(&file), SCENE).unwrap();
        for (with, path) in programs() {
            let args = ["crosscheck", "--with", with, "--program", &path];
            let args = [&args[..], &["--size", "16x12", "--", &file]].concat();
            let run = zpg(dir.path(), &args);
            assert_eq!(run.status.code(), Some(0), "{file}: {}", text(&run.stderr));
            let out = dir.path().join(format!("{name}-{with}"));
            let size = image::image_dimensions(out.join("theirs.png")).unwrap();
            assert_eq!(size, (16, 12), "{file}");
        }
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn a_scene_from_standard_input() {
    let dir = folder("");
    for (with, path) in programs() {
        let args = ["crosscheck", "-", "--with", with, "--program", &path];
        let args = [&args[..], &["--size", "16x12"]].concat();
        let run = program::zpg_with(dir.path(), &args, SCENE);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let out = dir.path().join(format!("scene-{with}"));
        assert!(out.join("theirs.png").exists());
    }
}

/// Each after one that succeeded, into the same folder.
#[test]
#[ignore = "needs POV-Ray and Mitsuba"]
fn programs_that_fail() {
    for (with, path) in programs() {
        let dir = folder(SCENE);
        let cross = |program: &str| {
            let args = ["crosscheck", "a.zpg", "--with", with, "-o", "out"];
            let run = zpg(
                dir.path(),
                &[&args[..], &["--size", "16x12", "--program", program]].concat(),
            );
            (run.status.code(), text(&run.stderr))
        };
        assert_eq!(cross(&path).0, Some(0));
        // Mitsuba's Python is asked first whether it has the package.
        let asked = "case \"$2\" in import*numpy) exit 0;; esac\n";
        for (lines, said) in [
            ("exit 0\n", "it has written no picture"),
            ("exit 3\n", "exit status: 3"),
            ("echo out of memory >&2\nexit 1\n", "out of memory"),
            ("kill -9 $$\n", "signal: 9"),
        ] {
            let program = script_in(dir.path(), &format!("{asked}{lines}"));
            let (status, errors) = cross(&program);
            assert_eq!(status, Some(2), "{with}, {lines}: {errors}");
            assert!(errors.contains(said), "{with}, {lines}: {errors}");
        }
        // What is there and no program is no missing one.
        let (status, errors) = cross("./a.zpg");
        assert_eq!(status, Some(2));
        assert!(!errors.contains("not installed"), "{errors}");
    }
    let dir = folder(SCENE);
    let without = script_in(dir.path(), "echo No module named mitsuba >&2\nexit 1\n");
    let args = ["crosscheck", "a.zpg", "--with", "mitsuba", "--program"];
    let run = zpg(dir.path(), &[&args[..], &[&without]].concat());
    assert_eq!(run.status.code(), Some(2));
    assert!(text(&run.stderr).contains("Mitsuba is not installed: get it with `pip install"));
}

/// A program is ended with all that it has started when its time is over, and what to do is said.
#[test]
#[cfg(unix)]
fn a_program_that_takes_too_long_is_ended() {
    for (with, instead) in [("povray", "`--size` or `--depth`"), ("mitsuba", "`--size`")] {
        let dir = folder(SCENE);
        let endless = Endless::new(dir.path(), "endless");
        let path = endless.path.to_str().unwrap();
        let args = ["crosscheck", "a.zpg", "--with", with, "--program", path];
        let run = zpg(dir.path(), &[&args[..], &["--timeout", "2s"]].concat());
        assert_eq!(run.status.code(), Some(2));
        let said = text(&run.stderr);
        assert!(
            said.contains("took longer than 2 s: allow it more with `--timeout`"),
            "{said}"
        );
        assert!(said.contains(&format!("a smaller {instead}\n")), "{said}");
        endless.wait_for_end();
    }
}

/// Ctrl-C and SIGTERM, told to zpg alone: what it runs ends, too, and nothing is said of that.
#[test]
#[cfg(unix)]
fn an_interrupted_one_ends_its_programs() {
    use std::process::{Command, Stdio};
    for (with, signal, status) in [
        ("povray", "-INT", 130),
        ("mitsuba", "-INT", 130),
        ("povray", "-TERM", 143),
    ] {
        let dir = folder(SCENE);
        let endless = Endless::new(dir.path(), "endless");
        let child = program::command()
            .args(["crosscheck", "a.zpg", "--with", with, "--program"])
            .arg(&endless.path)
            .current_dir(dir.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        endless.wait_for_start();
        let number = child.id().to_string();
        let told = Command::new("kill").args([signal, &number]).status();
        assert!(told.unwrap().success());
        let run = child.wait_with_output().unwrap();
        assert_eq!(run.status.code(), Some(status), "{}", text(&run.stderr));
        assert_eq!((text(&run.stdout), text(&run.stderr)), Default::default());
        endless.wait_for_end();
    }
}
