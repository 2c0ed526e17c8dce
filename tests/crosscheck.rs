//! `zpg crosscheck` from outside, with the real POV-Ray.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn zpg(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_zpg"))
        .args(args)
        .current_dir(folder)
        .output()
        .unwrap()
}

/// A ball on a checkered floor, seen from above.
const SCENE: &str = "2 11 0 1 0 1\n2 -701 0.9 0.2 0.1\n3 12 -5 -1 -5 5 0 5\n4 -701 0.2 0.4 0.9\n\
    5 -701 0.9 0.9 0.6\n3 -302 4 5 1\n6 -101 2 3\n7 -402 1\n7 -1 4 8 6\n8 -401 0.2\n\
    9 -501 0 4 8 0 -0.4 -1 0 1 0 40\n1 9999 6 0\n";

fn folder(scene: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), scene).unwrap();
    dir
}

#[test]
fn a_scene_agrees() {
    let dir = folder(SCENE);
    let args = ["crosscheck", "a.zpg", "--with", "povray", "--size", "96x72"];
    let run = zpg(dir.path(), &args);
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    let errors = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{said}{errors}");
    assert!(
        said.starts_with("a.zpg with povray, 96x72: agrees\n"),
        "{said}"
    );
    let out = dir.path().join("a-povray");
    let json = fs::read_to_string(out.join("crosscheck.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let picture = &json["pictures"][0];
    assert_eq!(picture["pixels"], 96 * 72);
    assert_eq!(picture["differing"]["off_silhouettes"], 0);
    // The outline of the ball, its shadow's and the checks: some hundreds of pixels, never most.
    let silhouettes = picture["silhouettes"].as_u64().unwrap();
    assert!((20..1000).contains(&silhouettes), "{silhouettes}");
    let size = |name: &str| image::image_dimensions(out.join(name)).unwrap();
    for name in ["ours.png", "theirs.png", "difference.png"] {
        assert_eq!(size(name), (96, 72), "{name}");
    }
    assert_eq!(size("side-by-side.png"), (3 * 96, 72));
}

#[test]
fn other_pictures_differ() {
    // A program that always takes the picture of a darker scene.
    let dir = folder(SCENE);
    let dark = SCENE.replace("7 -402 1", "7 -402 0.5");
    fs::write(dir.path().join("dark.zpg"), dark).unwrap();
    let script = "#!/bin/sh\n\
        for a in \"$@\"; do case $a in +I*) f=${a#+I};; esac; done\n\
        cp ../dark.pov \"$f\"\nexec povray \"$@\"\n";
    let program = dir.path().join("darker");
    fs::write(&program, script).unwrap();
    #[cfg(unix)]
    fs::set_permissions(
        &program,
        std::os::unix::fs::PermissionsExt::from_mode(0o755),
    )
    .unwrap();
    let convert = [
        "convert", "dark.zpg", "--to", "pov", "-o", "dark.pov", "--size", "96x72",
    ];
    assert!(zpg(dir.path(), &convert).status.success());
    let program = program.to_str().unwrap();
    let args = [
        "crosscheck",
        "a.zpg",
        "--with",
        "povray",
        "--size",
        "96x72",
        "--json",
    ];
    let run = zpg(dir.path(), &[&args[..], &["--program", program]].concat());
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
}

#[test]
fn geometry_agrees_with_mitsuba() {
    let dir = folder(SCENE);
    let python = concat!(env!("CARGO_TARGET_TMPDIR"), "/../mitsuba-3.9.1/bin/python");
    assert!(Path::new(python).exists(), "tests/run installs {python}");
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
        said.contains("error: Mitsuba is not installed: get it with `pip install"),
        "{said}"
    );
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
        said.contains("error: POV-Ray is not installed: get it"),
        "{said}"
    );
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
