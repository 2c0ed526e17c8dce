//! Where output goes: links are followed, and what is there already keeps what belongs to it.
#![cfg(unix)]

use std::fs::{self, Permissions};
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::support::program::{command, folder};

const SCENE: &[u8] = b"2 11 0 0 0 0.5\n1 9999 2 0\n";

/// Every argument that names an output, after which its name comes.
const OUTPUTS: [(&str, &str); 15] = [
    ("png", "render a.zpg --size 4x4 -o"),
    ("exr", "render a.zpg --size 4x4 -o"),
    ("pfm", "render a.zpg --size 4x4 -o"),
    ("json", "render a.zpg --size 4x4 -o x.png --stats"),
    ("png", "render a.zpg --size 4x4 -o x.png --heatmap"),
    ("pov", "convert a.zpg --to pov -o"),
    ("json", "convert a.zpg --to json -o"),
    ("zpg", "convert a.zpg --to zpg --force -o"),
    ("xml", "convert a.zpg --to mitsuba -o"),
    ("ply", "convert a.zpg --to ply -o"),
    ("obj", "convert a.zpg --to obj -o"),
    ("glb", "convert a.zpg --to glb -o"),
    ("stl", "convert a.zpg --to stl -o"),
    ("json", "convert a.zpg --to pov -o x.pov --report"),
    ("txt", "check a.zpg -o"),
];

fn zpg_command(folder: &Path, args: &str) -> Command {
    let mut command = command();
    command.args(args.split_whitespace()).current_dir(folder);
    command
}

#[track_caller]
fn runs(command: &mut Command) -> Output {
    let run = command.output().unwrap();
    let said = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(0), "{said}");
    run
}

/// What a command writes into a new file. Some outputs name files beside them after it.
fn plain(ending: &str, args: &str) -> Vec<u8> {
    let dir = folder(&[("a.zpg", SCENE)]);
    runs(&mut zpg_command(
        dir.path(),
        &format!("{args} link.{ending}"),
    ));
    fs::read(dir.path().join(format!("link.{ending}"))).unwrap()
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).unwrap().mode() & 0o7777
}

/// Nothing but this is in a folder.
#[track_caller]
fn holds(folder: &Path, names: &[&str]) {
    let mut left: Vec<String> = (fs::read_dir(folder).unwrap().flatten())
        .map(|entry| entry.file_name().into_string().unwrap())
        .collect();
    left.sort();
    assert_eq!(left, names);
}

#[test]
fn links_are_followed_and_modes_stay() {
    for (ending, args) in OUTPUTS {
        let expected = plain(ending, args);
        // Times differ from run to run.
        let is_same = |path: &Path| {
            let found = fs::read(path).unwrap();
            args.ends_with("--stats") && found.len() > 100 || found == expected
        };
        for old in [Some(0o600), Some(0o664), Some(0o444), None] {
            let dir = folder(&[("a.zpg", SCENE)]);
            let at = |name: &str| dir.path().join(name);
            fs::create_dir(at("far")).unwrap();
            let real = at("far/real");
            if let Some(mode) = old {
                fs::write(&real, "old").unwrap();
                fs::set_permissions(&real, Permissions::from_mode(mode)).unwrap();
            }
            // A link to a link, each relative to its own folder.
            symlink("real", at("far/link")).unwrap();
            let link = format!("link.{ending}");
            symlink("far/link", at(&link)).unwrap();
            runs(&mut zpg_command(dir.path(), &format!("{args} {link}")));
            assert!(is_same(&real), "{args}");
            for link in [&link, "far/link"] {
                let kind = fs::symlink_metadata(at(link)).unwrap().file_type();
                assert!(kind.is_symlink(), "{args} {link}");
            }
            if let Some(old) = old {
                assert_eq!(mode(&real), old, "{args}");
            }
            holds(&at("far"), &["link", "real"]);
        }
        // Without a link, and with two names for one file.
        let dir = folder(&[("a.zpg", SCENE)]);
        let at = |name: &str| dir.path().join(name);
        let name = format!("link.{ending}");
        fs::write(at(&name), "old").unwrap();
        fs::set_permissions(at(&name), Permissions::from_mode(0o640)).unwrap();
        let run = || runs(&mut zpg_command(dir.path(), &format!("{args} {name}")));
        let number = || fs::metadata(at(&name)).unwrap().ino();
        let before = number();
        run();
        assert!(is_same(&at(&name)), "{args}");
        assert_eq!(mode(&at(&name)), 0o640, "{args}");
        assert_ne!(number(), before, "{args}: not in one step");
        fs::hard_link(at(&name), at("other")).unwrap();
        fs::write(at(&name), "old").unwrap();
        run();
        assert!(is_same(&at("other")), "{args}");
    }
}

#[test]
fn links_that_lead_to_no_file_are_refused() {
    let dir = folder(&[("a.zpg", SCENE)]);
    symlink("circle", dir.path().join("circle")).unwrap();
    symlink("nowhere/file", dir.path().join("lost")).unwrap();
    symlink(".", dir.path().join("folder")).unwrap();
    for (link, why) in [
        ("circle", "symbolic links"),
        ("lost", "No such file or directory"),
        ("folder", "is a directory"),
    ] {
        let args = format!("convert a.zpg --to json -o {link}");
        let run = zpg_command(dir.path(), &args).output().unwrap();
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{said}");
        assert!(said.to_lowercase().contains(&why.to_lowercase()), "{said}");
        let kind = fs::symlink_metadata(dir.path().join(link)).unwrap();
        assert!(kind.is_symlink());
    }
    holds(dir.path(), &["a.zpg", "circle", "folder", "lost"]);
}

/// A scene that a link leads to is not written over.
#[test]
fn links_to_what_is_read_are_refused() {
    let dir = folder(&[("a.zpg", SCENE)]);
    symlink("a.zpg", dir.path().join("link.json")).unwrap();
    for args in [
        "convert a.zpg --to json -o link.json",
        "render a.zpg --size 4x4 -o x.png --stats link.json",
        "check a.zpg -o link.json",
    ] {
        let run = zpg_command(dir.path(), args).output().unwrap();
        assert_eq!(run.status.code(), Some(2), "{args}");
        assert_eq!(fs::read(dir.path().join("a.zpg")).unwrap(), SCENE);
    }
}

#[test]
fn devices_and_pipes_are_written_to() {
    let dir = folder(&[("a.zpg", SCENE)]);
    let at = |name: &str| dir.path().join(name);
    let expected = plain("json", "convert a.zpg --to json -o");
    runs(&mut zpg_command(
        dir.path(),
        "convert a.zpg --to json -o /dev/null",
    ));
    let kind = fs::metadata("/dev/null").unwrap().file_type();
    assert!(kind.is_char_device());
    // A pipe, itself and through a link.
    let made = Command::new("mkfifo").arg(at("pipe")).status().unwrap();
    assert!(made.success());
    symlink("pipe", at("link")).unwrap();
    for name in ["pipe", "link"] {
        let reader = Command::new("cat")
            .arg(at("pipe"))
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        runs(&mut zpg_command(
            dir.path(),
            &format!("convert a.zpg --to json -o {name}"),
        ));
        assert_eq!(reader.wait_with_output().unwrap().stdout, expected);
        let kind = fs::symlink_metadata(at("pipe")).unwrap().file_type();
        assert!(kind.is_fifo());
    }
    // Standard output by its name: a pipe, a new file, and a file that goes on.
    if !Path::new("/dev/stdout").exists() {
        return;
    }
    let args = "convert a.zpg --to json -o /dev/stdout";
    let before = fs::symlink_metadata("/dev/stdout").unwrap().ino();
    assert_eq!(runs(&mut zpg_command(dir.path(), args)).stdout, expected);
    let out = fs::File::create(at("out")).unwrap();
    runs(zpg_command(dir.path(), args).stdout(out));
    assert_eq!(fs::read(at("out")).unwrap(), expected);
    let out = fs::File::options().append(true).open(at("out")).unwrap();
    runs(zpg_command(dir.path(), args).stdout(out));
    assert_eq!(fs::read(at("out")).unwrap(), expected.repeat(2));
    let after = fs::symlink_metadata("/dev/stdout").unwrap().ino();
    assert_eq!(before, after);
}

/// `-` is standard output, which then carries nothing else, and takes one output.
#[test]
fn a_hyphen_is_standard_output() {
    let dir = folder(&[("a.zpg", SCENE)]);
    for (ending, args) in OUTPUTS {
        if args.contains("--heatmap") || ending == "obj" || ["exr", "pfm"].contains(&ending) {
            continue;
        }
        let run = runs(&mut zpg_command(dir.path(), &format!("{args} -")));
        let said = &run.stdout;
        match args.contains("--stats") {
            true => assert!(serde_json::from_slice::<serde_json::Value>(said).is_ok()),
            // Some outputs name their scene or what they are written to.
            false => assert_eq!(said.len() / 100, plain(ending, args).len() / 100, "{args}"),
        }
        assert!(!dir.path().join("-").exists(), "{args}");
    }
    for args in [
        "render a.zpg -o - --stats -",
        "convert a.zpg --to pov -o - --report -",
        "convert a.zpg --to json --report -",
    ] {
        let run = zpg_command(dir.path(), args).output().unwrap();
        assert_eq!(
            (run.status.code(), run.stdout.len()),
            (Some(2), 0),
            "{args}"
        );
        assert!(String::from_utf8_lossy(&run.stderr).contains("takes one of the outputs"));
    }
}

/// What a command writes goes to no file whose name says that it is something else, such as another scene. It is refused
/// before any work: nothing else is written either, and not even the scene is read.
#[test]
fn names_that_say_something_else_are_refused() {
    for (args, name, right) in [
        ("convert a.zpg --to pov -o", "b.zpg", ".pov"),
        ("convert a.zpg --to pov -o", "b.xml", ".pov"),
        ("convert a.zpg --to mitsuba -o", "b.zpg", ".xml"),
        ("convert a.zpg --to json -o", "b.zpg", ".json"),
        ("convert a.zpg --to glb -o", "b.zpg", ".glb"),
        ("convert a.zpg --to zpg -o", "b.json", ".zpg"),
        ("convert a.zpg -o new.pov --report", "b.zpg", ".json"),
        (
            "render a.zpg --size 4x4 -o new.png --stats",
            "b.zpg",
            ".json",
        ),
        (
            "render a.zpg --size 4x4 -o new.png --stats",
            "zpg.toml",
            ".json",
        ),
        (
            "render a.zpg --size 4x4 -o new.png --heatmap",
            "b.zpg",
            ".png",
        ),
        ("render a.zpg --size 4x4 -o", "b.zpg", ".png"),
        ("check a.zpg -o", "b.zpg", ".txt"),
        ("check a.zpg --format short -o", "b.json", ".txt"),
        ("check a.zpg --format json -o", "b.zpg", ".json"),
        ("check a.zpg --format sarif -o", "b.ZPG", ".sarif"),
        ("check a.zpg --format junit -o", "b.zpg", ".xml"),
        ("check a.zpg --show-settings -o", "b.zpg", ".toml"),
        ("check a.zpg --show-files -o", "b.zpg", ".txt"),
    ] {
        let dir = folder(&[("a.zpg", SCENE)]);
        let path = dir.path().join(name);
        fs::write(&path, "made by hand").unwrap();
        let run = zpg_command(dir.path(), &format!("{args} {name}"))
            .output()
            .unwrap();
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{args} {name}: {said}");
        assert!(
            said.contains(name) && said.contains(right),
            "{args}: {said}"
        );
        assert_eq!(fs::read(&path).unwrap(), b"made by hand", "{args}");
        let mut left = ["a.zpg", name];
        left.sort_unstable();
        holds(dir.path(), &left);
    }
}

/// Somebody may have written a scene that is there already. `--force` writes over it, but not over the one that is read.
#[test]
fn a_scene_is_not_written_over() {
    let dir = folder(&[("a.zpg", SCENE), ("b.zpg", b"# by hand # 2 9 1")]);
    let at = |name: &str| dir.path().join(name);
    let refused = |args: &str, why: &str| {
        let run = zpg_command(dir.path(), args).output().unwrap();
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{said}");
        assert!(said.contains(why), "{said}");
    };
    refused("convert a.zpg -o b.zpg", "--force");
    refused("convert a.zpg --to zpg -o b.zpg", "--force");
    assert_eq!(fs::read(at("b.zpg")).unwrap(), b"# by hand # 2 9 1");
    fs::write(at("empty.zpg"), "").unwrap();
    for args in ["-o c.zpg", "-o empty.zpg", "-o b.zpg --force"] {
        runs(&mut zpg_command(
            dir.path(),
            &format!("convert a.zpg {args}"),
        ));
    }
    let made = fs::read(at("c.zpg")).unwrap();
    assert_eq!(
        [
            fs::read(at("b.zpg")).unwrap(),
            fs::read(at("empty.zpg")).unwrap()
        ],
        [made.clone(), made]
    );
    refused("convert a.zpg -o a.zpg --force", "the scene itself");
    refused("convert a.zpg -o a.zpg", "the scene itself");
    assert_eq!(fs::read(at("a.zpg")).unwrap(), SCENE);
}
