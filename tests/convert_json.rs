//! `zpg convert` to JSON and back, from outside: the same scene, bit for bit where it is seen.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

fn zpg(folder: &Path, args: &[&str]) -> Output {
    crate::support::program::command()
        .args(args)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn scenes() -> Vec<PathBuf> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let mut all: Vec<PathBuf> = ignore::Walk::new(folder)
        .map(|e| e.unwrap().into_path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        // Printed with its mistakes.
        .filter(|p| !p.components().any(|c| c.as_os_str() == "printed"))
        .collect();
    all.sort();
    all
}

/// Whether two cameras take the picture.
fn is_stereo(path: &Path) -> bool {
    let text = fs::read_to_string(path).unwrap();
    text.lines()
        .any(|line| line.split_whitespace().nth(1) == Some("-503"))
}

#[test]
fn scenes_come_back_and_look_the_same() {
    let mut count = 0;
    for path in scenes() {
        let dir = tempfile::tempdir().unwrap();
        for entry in fs::read_dir(path.parent().unwrap()).unwrap() {
            let picture = entry.unwrap().path();
            if picture
                .extension()
                .is_some_and(|e| e == "png" || e == "jpg")
            {
                fs::copy(&picture, dir.path().join(picture.file_name().unwrap())).unwrap();
            }
        }
        fs::copy(&path, dir.path().join("a.zpg")).unwrap();
        let run = |args: &[&str]| {
            let run = zpg(dir.path(), args);
            let said = String::from_utf8_lossy(&run.stderr).into_owned();
            assert_eq!(
                run.status.code(),
                Some(0),
                "{}: {args:?}: {said}",
                path.display()
            );
        };
        run(&["convert", "a.zpg", "--to", "json", "-o", "a.json"]);
        run(&["convert", "a.json", "--to", "zpg", "-o", "b.zpg"]);
        run(&["convert", "b.zpg", "--to", "json", "-o", "b.json"]);
        run(&["fmt", "--check", "b.zpg"]);
        let read = |name: &str| fs::read(dir.path().join(name)).unwrap();
        assert_eq!(read("a.json"), read("b.json"), "{}", path.display());
        for name in ["a.zpg", "b.zpg", "a.json"] {
            let (scene, picture) = (name, format!("{name}.pfm"));
            let mut args = vec!["render", scene, "-o", &picture, "--size", "32x24"];
            if is_stereo(&path) {
                args.extend(["--stereo", "side-by-side"]);
            }
            run(&args);
        }
        // Surfaces keep their order, so that ties are decided alike.
        let picture = read("a.zpg.pfm");
        assert!(picture == read("b.zpg.pfm"), "{}", path.display());
        assert!(picture == read("a.json.pfm"), "{}", path.display());
        count += 1;
    }
    assert!(count > 30, "{count}");
}

#[test]
fn json_of_programs() {
    let dir = tempfile::tempdir().unwrap();
    let write = |text: &str| fs::write(dir.path().join("a.json"), text).unwrap();
    write(r#"{"version": 1, "nodes": [{"type": "sphere", "radius": 1}], "render": {"root": 0}}"#);
    let run = zpg(dir.path(), &["convert", "a.json", "--to", "zpg"]);
    assert_eq!(
        String::from_utf8_lossy(&run.stdout),
        "2 9 1\n\n0 # what is drawn #\n1 9999 2 0\n"
    );
    // Any other target takes it, too.
    let run = zpg(dir.path(), &["convert", "a.json", "--to", "pov"]);
    assert!(String::from_utf8_lossy(&run.stdout).contains("sphere {"));
    for (json, says) in [
        (
            "{",
            "error[E015]: this is not JSON: it ends too early, something is not closed\n   ╭─[ a.json:1:1 ]",
        ),
        (
            r#"{"version": 1, "nodes": [{"type": "sphere", "radius": -1}], "render": {"root": 0}}"#,
            "error[E201]: nodes[0].radius: the radius of the sphere at the origin must be positive\n   ╭─[ a.json:1:55 ]",
        ),
        (
            r#"{"version": 1, "nodes": [{"type": "copy", "of": 3}]}"#,
            "error[E015]: nodes[0]: it names node 3, which does not stand before it\n   ╭─[ a.json:1:26 ]",
        ),
    ] {
        write(json);
        let run = zpg(dir.path(), &["convert", "a.json", "--to", "zpg"]);
        assert_eq!(run.status.code(), Some(1));
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(said.starts_with(says), "{said}");
    }
    write(r#"{"version": 1, "nodes": [{"type": "sphere", "radius": "a"}]}"#);
    let run = zpg(
        dir.path(),
        &["convert", "a.json", "--to", "zpg", "--lang", "cs"],
    );
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(
        said.starts_with("chyba[E015]: nodes[0].radius: očekává se číslo, uvedeno je: `\"a\"`\n   ╭─[ a.json:1:55 ]"),
        "{said}"
    );
    let run = zpg(dir.path(), &["convert", "b.json", "--to", "zpg"]);
    assert_eq!(run.status.code(), Some(2));
}

/// Whatever is asked for, the scene itself is not written over.
#[test]
fn the_scene_is_spared() {
    let dir = tempfile::tempdir().unwrap();
    let scene = dir.path().join("a.zpg");
    let text = "2 9 1\n1 9999 2 0\n";
    for to in ["pov", "json", "zpg", "ply"] {
        fs::write(&scene, text).unwrap();
        let run = zpg(
            dir.path(),
            &["convert", "a.zpg", "--to", to, "-o", "./a.zpg"],
        );
        assert_eq!(run.status.code(), Some(2), "{to}");
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(said.contains("is the scene itself"), "{to}: {said}");
        assert_eq!(fs::read_to_string(&scene).unwrap(), text);
    }
}
