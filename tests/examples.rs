//! The examples of every `--help` are run as they stand there, in both languages.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::support::program::{self, folder, text, zpg};

/// What all examples are about: a camera 9, an object 4, and nothing to be said of it.
const SCENE: &str = "2 11  0 1 0  1\n3 12  -3 -1 -3  3 0 3\n4 -101 2 3\n9 -501  0 2 9  0 -0.1 -1  0 1 0  40\n\
                     50 -402 0.8\n50 -1 3 5 4\n51 -401 0.2\n1 9999 4 0\n";

/// Names that examples have for files and folders, in English and in Czech.
const SCENES: [&str; 4] = ["scene.zpg", "scena.zpg", "in.zpg", "vstup.zpg"];
const FOLDERS: [&str; 5] = ["scenes", "sceny", "submissions", "odevzdane", "prace"];
const PICTURES: [&str; 2] = ["pictures", "obrazky"];
const PARTS: [&str; 2] = ["bands", "dily"];
const JSON: [&str; 2] = ["made-by-a-program.json", "vytvorena-programem.json"];
const RAYS: [&str; 2] = ["rays.txt", "paprsky.txt"];

/// What never ends by itself, or takes minutes: it is left alone after some seconds.
const LONG: [&str; 2] = ["--watch", "--shapes"];

/// The names of all commands.
fn commands(dir: &Path) -> Vec<String> {
    let help = text(&zpg(dir, &["--help"]).stdout);
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let names = lines.take_while(|line| !line.is_empty());
    let names = names.filter_map(|line| line.split_whitespace().next().map(str::to_owned));
    names.filter(|name| name != "help").collect()
}

/// The lines of a help that are commands, without what is said of them. Quotes may hold two spaces.
fn examples(help: &str) -> Vec<String> {
    let lines = help.lines().filter(|line| line.starts_with("  zpg "));
    let bare = lines.map(|line| {
        let mut quoted = None;
        let line = line.trim();
        let end = line.char_indices().find(|(at, c)| {
            match quoted {
                None if matches!(c, '"' | '\'') => quoted = Some(*c),
                Some(sign) if sign == *c => quoted = None,
                _ => {}
            }
            quoted.is_none() && line[*at..].starts_with("  ")
        });
        line[..end.map_or(line.len(), |(at, _)| at)].to_owned()
    });
    bare.collect()
}

/// A folder with all that an example may name; parts of pictures in the format that it joins them to.
fn folder_for(example: &str) -> tempfile::TempDir {
    let mut files: Vec<(String, String)> = Vec::new();
    let mut add = |name: String, text: &str| files.push((name, text.to_owned()));
    SCENES
        .iter()
        .for_each(|name| add((*name).to_owned(), SCENE));
    FOLDERS
        .iter()
        .for_each(|name| add(format!("{name}/a.zpg"), SCENE));
    RAYS.iter()
        .for_each(|name| add((*name).to_owned(), "0 0 9  0 0 -1\n"));
    PICTURES
        .iter()
        .for_each(|name| add(format!("{name}/.keep"), ""));
    for name in [
        ".local/share/bash-completion/completions",
        ".config/fish/completions",
        ".zfunc",
    ] {
        add(format!("{name}/other"), "");
    }
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(n, t)| (n.as_str(), t.as_str()))
        .collect();
    let dir = folder(&files);
    let run = |arguments: &[&str]| {
        let run = zpg(dir.path(), arguments);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    };
    if example.starts_with("zpg new") {
        // It writes over nothing.
        fs::remove_file(dir.path().join(SCENES[0])).unwrap();
        fs::remove_file(dir.path().join(SCENES[1])).unwrap();
    }
    let used = |name: &&&str| example.contains(**name);
    for name in JSON.iter().filter(used) {
        run(&["convert", "scene.zpg", "-o", name]);
    }
    for name in PICTURES.iter().filter(used) {
        run(&[
            "render",
            "scene.zpg",
            "-o",
            &format!("{name}/a.png"),
            "--size",
            "16x12",
        ]);
    }
    for name in PARTS.iter().filter(used) {
        let ending = if example.contains(".exr") {
            "exr"
        } else {
            "png"
        };
        fs::create_dir(dir.path().join(name)).unwrap();
        for part in ["1/2", "2/2"] {
            let file = format!("{name}/{}.{ending}", &part[..1]);
            run(&[
                "render",
                "scene.zpg",
                "--size",
                "16x12",
                "--tile",
                part,
                "-o",
                &file,
            ]);
        }
    }
    dir
}

/// The example, with smaller pictures.
fn quick(example: &str) -> String {
    let large = ["1920x1080", "8000x6000"];
    let example = large
        .iter()
        .fold(example.to_owned(), |e, size| e.replace(size, "16x12"));
    let draws = ["zpg render", "zpg accuracy"]
        .iter()
        .any(|c| example.starts_with(c));
    let has_size = ["--size", "--crop", "--shapes", "|"]
        .iter()
        .any(|o| example.contains(o));
    match draws && !has_size {
        true => example + " --size 16x12",
        false => example,
    }
}

/// Runs all examples of a language.
fn run_all(lang: &str) {
    let nowhere = folder::<&str>(&[]);
    let bin = Path::new(program::PATH).parent().unwrap();
    let path = std::env::var("PATH").unwrap();
    let path = format!("{}:{path}", bin.display());
    let mut count = 0;
    for command in commands(nowhere.path())
        .iter()
        .map(String::as_str)
        .chain([""])
    {
        let help = [command, "--help", "--lang", lang];
        let help = &help[usize::from(command.is_empty())..];
        let all = examples(&text(&zpg(nowhere.path(), help).stdout));
        assert!(!all.is_empty(), "{help:?} has no example");
        for example in all {
            let dir = folder_for(&example);
            // Not everybody has this program.
            let line = quick(&example).replace("jq .nodes", "grep nodes");
            let is_long = LONG.iter().any(|option| line.contains(option));
            let seconds = if is_long { "3" } else { "120" };
            let run = Command::new("timeout")
                .args([seconds, "sh", "-c", &line])
                .env("PATH", &path)
                .env("HOME", dir.path())
                .env("LC_ALL", if lang == "cs" { "cs_CZ.UTF-8" } else { "C" })
                .current_dir(dir.path())
                .stdin(Stdio::null())
                .output()
                .unwrap();
            let said = text(&run.stderr);
            let is_right = match run.status.code() {
                Some(0) => true,
                // Nobody talks to the server; the other program need not be there.
                Some(1) => line.starts_with("zpg lsp"),
                Some(2) => line.starts_with("zpg crosscheck") && !said.contains("--help"),
                Some(124) => is_long,
                _ => false,
            };
            assert!(is_right, "{line}: {run:?}");
            count += 1;
        }
    }
    assert!(count > 60, "{count}");
}

#[cfg(unix)]
#[test]
fn english_examples_do_what_they_are_for() {
    run_all("en");
}

#[cfg(unix)]
#[test]
fn czech_examples_do_what_they_are_for() {
    run_all("cs");
}
