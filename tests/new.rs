//! `zpg new`: scenes to start with, and what is said of them.

use std::fs;

use crate::support::program::{folder, text, zpg};

/// What `--from` may be, and none.
const TEMPLATES: [Option<&str>; 5] = [
    None,
    Some("glass"),
    Some("bracket"),
    Some("chessboard"),
    Some("stereo"),
];

fn arguments<'a>(file: &'a str, template: Option<&'a str>, lang: &'a str) -> Vec<&'a str> {
    let from = template.map_or(vec![], |name| vec!["--from", name]);
    [&["new", file, "--lang", lang][..], &from].concat()
}

/// Each scene passes what a reviewer runs, in both languages, and is drawn.
#[test]
fn scenes_pass_all_checks_and_are_drawn() {
    for template in TEMPLATES {
        let dir = folder::<&str>(&[]);
        for lang in ["en", "cs"] {
            let file = format!("{lang}.zpg");
            let run = zpg(dir.path(), &arguments(&file, template, lang));
            assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
            assert!(text(&run.stdout).contains(&format!("`zpg render {file}`")));
            let written = fs::read_to_string(dir.path().join(&file)).unwrap();
            let printed = zpg(dir.path(), &arguments("-", template, lang));
            assert_eq!(text(&printed.stdout), written);
            assert_eq!(text(&printed.stderr), "");
        }
        for check in [&["check", "--deny", "all"][..], &["fmt", "--check"]] {
            let run = zpg(dir.path(), check);
            assert_eq!(run.status.code(), Some(0), "{}", text(&run.stdout));
        }
        let run = zpg(dir.path(), &["render", "en.zpg", "--size", "64x48"]);
        assert_eq!(run.status.code(), Some(0));
        let name = if template == Some("stereo") {
            "en_left.png"
        } else {
            "en.png"
        };
        let picture = image::open(dir.path().join(name)).unwrap().into_rgb8();
        // Nothing is too bright to be told apart, and there is light and shade.
        let brightest = |pixel: &image::Rgb<u8>| *pixel.0.iter().max().unwrap();
        let clipped = picture
            .pixels()
            .filter(|p| p.0.iter().all(|c| *c == 255))
            .count();
        assert_eq!(clipped, 0, "{template:?}");
        let dark = picture.pixels().filter(|p| brightest(p) < 80).count();
        let light = picture.pixels().filter(|p| brightest(p) > 160).count();
        assert!(
            dark > 20 && light > 100,
            "{template:?}: {dark} dark, {light} light"
        );
    }
}

#[test]
fn nothing_is_written_over() {
    let dir = folder(&[("a.zpg", ""), ("b.json", "")]);
    for (file, says) in [
        ("a.zpg", "a.zpg already exists"),
        ("b.json", "choose a name that ends in .zpg"),
        ("glass", "write glass.zpg"),
        ("x.txt", "write x.zpg"),
        ("no/such/folder.zpg", "there is no folder no/such"),
    ] {
        let run = zpg(dir.path(), &["new", file]);
        let said = text(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{said}");
        assert!(said.contains(says), "{said}");
        assert_eq!(text(&run.stdout), "");
    }
    assert_eq!(fs::read(dir.path().join("a.zpg")).unwrap(), b"");
    assert!(!dir.path().join("glass").exists());
    let run = zpg(dir.path(), &["new", "a.zpg", "--force", "-q"]);
    assert_eq!(
        (run.status.code(), text(&run.stdout)),
        (Some(0), String::new())
    );
    assert!(!fs::read(dir.path().join("a.zpg")).unwrap().is_empty());
    // What is to be run can be copied into a shell.
    let run = zpg(dir.path(), &["new", "my scene.zpg"]);
    assert!(text(&run.stdout).contains("`zpg render 'my scene.zpg'`"));
}

/// Alone, `zpg` names five commands, and each of them does what it says when they are run one after the other.
#[test]
fn the_program_alone_says_how_to_start() {
    for lang in ["en", "cs"] {
        let dir = folder::<&str>(&[]);
        let run = zpg(dir.path(), &["--lang", lang]);
        assert_eq!(
            (run.status.code(), text(&run.stdout)),
            (Some(2), String::new())
        );
        let said = text(&run.stderr);
        let examples = said.lines().filter_map(|line| line.strip_prefix("  zpg "));
        let commands: Vec<&str> = examples
            .filter_map(|line| line.split("  ").next())
            .collect();
        assert_eq!(commands.len(), 5, "{said}");
        for command in commands {
            let words: Vec<&str> = command.split(' ').chain(["--lang", lang]).collect();
            let run = zpg(dir.path(), &words);
            assert_eq!(
                run.status.code(),
                Some(0),
                "{command}: {}",
                text(&run.stderr)
            );
        }
        let drawn = fs::read_dir(dir.path()).unwrap().filter(|entry| {
            entry
                .as_ref()
                .unwrap()
                .path()
                .extension()
                .is_some_and(|e| e == "png")
        });
        assert_eq!(drawn.count(), 1);
        if lang == "en" {
            assert_eq!(text(&zpg(dir.path(), &[]).stderr), said);
        }
    }
}
