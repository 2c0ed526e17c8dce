//! `zpg convert` to JSON and back, from outside: the same scene, bit for bit where it is seen.

use crate::support::program::zpg;
use std::fs;
use std::path::{Path, PathBuf};

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
            "error[E015]: nodes[0]: it names node 3, which must stand before it\n   ╭─[ a.json:1:26 ]",
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
    for (to, why) in [
        ("pov", "ends in .zpg"),
        ("json", "ends in .zpg"),
        ("zpg", "is the scene itself"),
        ("ply", "ends in .zpg"),
    ] {
        fs::write(&scene, text).unwrap();
        let run = zpg(
            dir.path(),
            &["convert", "a.zpg", "--to", to, "-o", "./a.zpg"],
        );
        assert_eq!(run.status.code(), Some(2), "{to}");
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(said.contains(why), "{to}: {said}");
        assert_eq!(fs::read_to_string(&scene).unwrap(), text);
    }
}

/// A scene of one rectangle for each picture.
fn pictured(names: &[&str]) -> String {
    let mut text = String::new();
    let mut root = 2;
    for (name, i) in names.iter().zip(0..) {
        let id = 2 + 2 * i;
        text += &format!("{id} 5 {i} 0 {} 1\n{id} -301 \"{name}\"\n", i + 1);
        if i > 0 {
            text += &format!("{} -101 {root} {id}\n", id + 1);
            root = id + 1;
        }
    }
    text + &format!("1 9999 {root} 0\n")
}

/// A picture of one pixel.
fn pixel(colour: [u8; 3]) -> Vec<u8> {
    let picture = image::RgbImage::from_raw(1, 1, colour.to_vec()).unwrap();
    let mut out = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut out, image::ImageFormat::Png).unwrap();
    out.into_inner()
}

/// What is written into another folder names the same pictures, as far as the language has a path to them.
#[test]
fn pictures_are_found_from_another_folder() {
    let names = [
        "tex.png",
        "two words.png",
        "příliš #1.png",
        "deep/er/./a.png",
    ];
    for (to, input) in [
        ("json", "zpg"),
        ("zpg", "zpg"),
        ("zpg", "json"),
        ("json", "json"),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        fs::create_dir_all(at("a/b/deep/er")).unwrap();
        fs::create_dir_all(at("a/c")).unwrap();
        for (name, i) in names.iter().zip(1..) {
            fs::write(at("a/b").join(name), pixel([50 * i, 9, 0])).unwrap();
        }
        fs::write(at("a/b/t.zpg"), pictured(&names)).unwrap();
        let run = |args: &[&str]| {
            let run = zpg(dir.path(), args);
            let said = String::from_utf8(run.stderr).unwrap();
            assert_eq!(run.status.code(), Some(0), "{args:?}: {said}");
            (run.stdout, said)
        };
        run(&["convert", "a/b/t.zpg", "--to", "json", "-o", "a/b/t.json"]);
        let scene = format!("a/b/t.{input}");
        let draw = |scene: &str| {
            run(&["render", scene, "-o", "p.pfm", "--size", "64x16"]);
            fs::read(at("p.pfm")).unwrap()
        };
        let picture = draw(&scene);
        let text = |name: &str| fs::read_to_string(at(name)).unwrap();
        // A folder by its other name has been written to before.
        let convert = |output: &str| run(&["convert", &scene, "--force", "-o", output]).1;
        // Upwards, and where it is; and through a folder's other name.
        for (folder, prefix) in [("a", "b/"), (".", "a/b/"), ("a/b", ""), ("a/c/../b", "")] {
            let output = format!("{folder}/out.{to}");
            let said = convert(&output);
            assert!(!said.contains("image texture"), "{said}");
            for name in names {
                let name = match prefix {
                    "" => name.to_owned(),
                    _ => format!("{prefix}{}", name.replace("./", "")),
                };
                assert!(text(&output).contains(&format!("\"{name}\"")), "{name}");
            }
            assert!(draw(&output) == picture, "{output}");
        }
        // To standard output as they are.
        let (stdout, said) = run(&["convert", &scene, "--to", to]);
        assert!(!said.contains("image texture"), "{said}");
        assert!(
            String::from_utf8(stdout)
                .unwrap()
                .contains("deep/er/./a.png")
        );
        // Down to one of them, and beside all.
        let output = format!("a/b/deep/out.{to}");
        let said = convert(&output);
        assert!(
            said.contains(&format!(
                "approximate  image texture (only with a copy of příliš #1.png, tex.png, two words.png beside {output}) ×4: \
                 an image must lie in the folder of its scene"
            )),
            "{said}"
        );
        assert!(text(&output).contains("\"er/a.png\"") && text(&output).contains("\"tex.png\""));
        let output = format!("a/c/out.{to}");
        let said = convert(&output);
        assert!(
            said.contains(&format!(
                "deep/er/./a.png, příliš #1.png, tex.png, two words.png beside {output})"
            )),
            "{said}"
        );
        let checked = zpg(dir.path(), &["check", &output]);
        assert_eq!(checked.status.code(), Some(1));
        // Another picture of that name is not the one.
        fs::create_dir_all(at("a/c/deep/er")).unwrap();
        for name in names {
            fs::write(at("a/c").join(name), pixel([0; 3])).unwrap();
        }
        assert!(convert(&output).contains("tex.png"));
        for name in names {
            fs::copy(at("a/b").join(name), at("a/c").join(name)).unwrap();
        }
        let said = convert(&output);
        assert!(!said.contains("image texture"), "{said}");
        assert!(draw(&output) == picture);
    }
}

/// A link is taken by its name, unless the name lies elsewhere.
#[cfg(unix)]
#[test]
fn pictures_behind_links_are_found_from_another_folder() {
    use std::os::unix::fs::symlink;
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    fs::create_dir_all(at("a/sub")).unwrap();
    fs::write(at("a/sub/real.png"), pixel([9; 3])).unwrap();
    symlink("sub/real.png", at("a/link.png")).unwrap();
    symlink("sub", at("a/other")).unwrap();
    for (picture, to, expected) in [
        ("link.png", "t.json", "a/link.png"),
        ("link.png", "a/sub/t.json", "real.png"),
        ("other/real.png", "t.json", "a/sub/real.png"),
        ("other/real.png", "a/sub/t.json", "real.png"),
    ] {
        fs::write(at("a/t.zpg"), pictured(&[picture])).unwrap();
        let run = zpg(
            dir.path(),
            &["convert", "a/t.zpg", "--to", "json", "-o", to],
        );
        assert_eq!(run.status.code(), Some(0));
        let text = fs::read_to_string(at(to)).unwrap();
        assert!(text.contains(&format!("\"{expected}\"")), "{text}");
        assert_eq!(zpg(dir.path(), &["check", to]).status.code(), Some(0));
    }
}

/// The index 1 of an assignment, which nobody wrote, is neither written nor mentioned, as long as there is no other.
#[test]
fn an_index_that_nobody_wrote() {
    let dir = tempfile::tempdir().unwrap();
    let assigned = "3 -201 0.5 0.5 0\n2 9 1\n2 -299 0 3\n1 9999 2 0\n";
    let glass = "2 9 1\n2 -203 1.5 1.5 1.5\n3 -201 0.5 0.5 0\n2 -299 0 3\n1 9999 2 0\n";
    for (scene, has_index) in [(assigned, false), (glass, true)] {
        fs::write(dir.path().join("a.zpg"), scene).unwrap();
        let run = zpg(dir.path(), &["convert", "a.zpg", "--to", "zpg"]);
        let records = String::from_utf8(run.stdout).unwrap();
        assert_eq!(records.contains("-203"), has_index, "{records}");
        let run = zpg(dir.path(), &["convert", "a.zpg", "-o", "a.glb", "-v"]);
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(said.contains("refractive index"), has_index, "{said}");
    }
}

/// A camera and light that are added are no secret.
#[test]
fn what_is_added_is_said() {
    let dir = tempfile::tempdir().unwrap();
    let camera = "9 -501 0 0 6 0 0 -1 0 1 0 45\n";
    let (no_camera, no_light) = ("the scene has no camera", "the scene has no light");
    for (rest, to, [lacks_camera, lacks_light]) in [
        ("", "pov", [true, true]),
        (camera, "pov", [false, true]),
        ("", "mitsuba", [true, true]),
        ("", "glb", [false; 2]),
        ("", "zpg", [false; 2]),
    ] {
        fs::write(
            dir.path().join("a.zpg"),
            format!("2 9 1\n{rest}1 9999 2 0\n"),
        )
        .unwrap();
        let out = format!("a.{}", if to == "mitsuba" { "xml" } else { to });
        let arguments = [
            "convert",
            "a.zpg",
            "--to",
            to,
            "--force",
            "-o",
            &format!("b{out}"),
        ];
        let run = zpg(dir.path(), &arguments);
        let said = String::from_utf8(run.stderr).unwrap().replace("\n  ", " ");
        assert_eq!(said.contains(no_camera), lacks_camera, "{to}: {said}");
        assert_eq!(said.contains(no_light), lacks_light, "{to}: {said}");
    }
}

/// What the report says of comments, and of a camera that is the only one.
#[test]
fn what_a_report_says() {
    let dir = tempfile::tempdir().unwrap();
    let scene = "2 9 1\n9 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 2 0\n";
    let other = "10 -501 0 0 6 0 0 -1 0 1 0 45\n11 -502 9\n";
    for (text, has_comments, is_choice) in [
        (scene.to_owned(), false, false),
        (format!("{scene}# a ball #\n"), true, false),
        (format!("{scene}{other}"), false, true),
    ] {
        fs::write(dir.path().join("a.zpg"), text).unwrap();
        for to in ["json", "zpg"] {
            let said = zpg(dir.path(), &["convert", "a.zpg", "--to", to, "-v"]);
            let said = String::from_utf8(said.stderr).unwrap();
            let lost = "dropped      comments: the resolved scene has none";
            assert_eq!(said.contains(lost), has_comments, "{said}");
            assert_eq!(said.contains("mono camera"), is_choice, "{said}");
        }
    }
    let said = zpg(dir.path(), &["convert", "a.zpg", "-o", "a.gltf"]);
    let said = String::from_utf8(said.stderr).unwrap();
    assert!(said.contains("`-o a.glb`"), "{said}");
}
