//! The README and the pages beside it: their commands print what the pages show, and their links lead
//! somewhere.

use std::fs;
use std::path::{Path, PathBuf};

/// The README is read in a few minutes.
const MOST_WORDS: usize = 900;

/// As many as a line of the changelog has.
const MOST_WORDS_OF_AN_ENTRY: usize = 15;

/// The page in each language, and the locale that a reader of it has.
const READMES: [(&str, &str); 2] = [("README.md", "C"), ("README.cs.md", "cs_CZ.UTF-8")];

/// What stands for the rest of a line or of the output.
const REST: &str = "…";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn page(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap()
}

/// The fenced blocks of a page: what stands in the last line before each, its language, its text.
fn blocks(page: &str) -> Vec<(&str, &str, String)> {
    let mut lines = page.lines();
    let (mut blocks, mut before) = (Vec::new(), "");
    while let Some(line) = lines.next() {
        if let Some(language) = line.strip_prefix("```") {
            let text = lines.by_ref().take_while(|l| !l.starts_with("```"));
            let text = text.map(|l| l.to_owned() + "\n").collect();
            blocks.push((std::mem::take(&mut before), language, text));
        } else if !line.trim().is_empty() {
            before = line;
        }
    }
    blocks
}

/// The words of a command; quotes hold words together.
fn words(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (i, part) in command.split('"').enumerate() {
        match i % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

/// Runs a command of the page in a folder and a locale; both of its outputs.
fn run(folder: &Path, command: &str, locale: &str) -> String {
    let words = words(command);
    let arguments = match words.iter().position(|w| w == "--") {
        Some(at) if words[0] == "cargo" => &words[at + 1..],
        _ if words[0] == "zpg" => &words[1..],
        _ => panic!("an unknown program: {command}"),
    };
    let output = crate::support::program::command()
        .args(arguments)
        .env("LC_ALL", locale)
        .current_dir(folder)
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].concat();
    String::from_utf8(said).unwrap()
}

/// Whether an output is as it is shown.
fn is_as_shown(real: &str, shown: &str) -> bool {
    let mut real = real.lines();
    let mut shown = shown.lines();
    loop {
        match (shown.next(), real.next()) {
            (None, None) => return true,
            (Some(REST), _) => return shown.next().is_none(),
            (Some(shown), Some(real)) => match shown.strip_suffix(REST) {
                Some(start) if real.starts_with(start) => {}
                None if shown == real => {}
                _ => return false,
            },
            _ => return false,
        }
    }
}

/// A folder with the scenes that a page shows under a name: ``this is `first.zpg`:``.
fn folder_of(page: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (before, _, text) in blocks(page) {
        let name = before.split('`').find(|part| part.ends_with(".zpg"));
        if let Some(name) = name.filter(|_| before.ends_with(':')) {
            fs::write(folder.path().join(name), text).unwrap();
        }
    }
    folder
}

/// Entries are read at a glance. The newest heading is the version of the program.
#[test]
fn entries_of_the_changelog_are_short() {
    let page = page("CHANGELOG.md");
    let version = page.lines().find_map(|line| line.strip_prefix("## "));
    assert_eq!(version, Some(env!("CARGO_PKG_VERSION")));
    let mut count = 0;
    for line in page.lines() {
        assert!(!line.starts_with(' '), "an entry is one line: {line}");
        if let Some(entry) = line.strip_prefix("- ") {
            let words = entry.split_whitespace().count();
            assert!(words <= MOST_WORDS_OF_AN_ENTRY, "{words} words: {entry}");
            count += 1;
        }
    }
    assert!(count > 50);
}

#[test]
fn the_readme_is_short() {
    for (name, _) in READMES {
        let count = page(name).split_whitespace().count();
        assert!(count <= MOST_WORDS, "{name}: {count} words");
    }
}

#[test]
fn commands_print_what_is_shown() {
    for (name, locale) in READMES {
        commands_of_a_page(name, locale);
    }
}

fn commands_of_a_page(name: &str, locale: &str) {
    let readme = page(name);
    let folder = folder_of(&readme);
    let consoles = blocks(&readme).into_iter().filter(|b| b.1 == "console");
    let mut count = 0;
    for (_, _, text) in consoles {
        for command in text.split("$ ").skip(1) {
            let (command, shown) = command.split_once('\n').unwrap();
            let real = run(folder.path(), command, locale);
            assert!(
                is_as_shown(&real, shown),
                "$ {command}\n{real}\nbut {name} shows\n{shown}"
            );
            count += 1;
        }
    }
    assert!(count >= 6, "{count}");
    // One of them has drawn the picture.
    let decoded = |path: PathBuf| image::open(path).unwrap().into_rgb8();
    let first = blocks(&readme)[0].0.split('`').nth(1).unwrap();
    let drawn = decoded(folder.path().join(first).with_extension("png"));
    assert!(drawn == decoded(root().join("docs/pictures/first.png")));
}

/// The first command that runs from the sources draws a scene of the gallery.
#[test]
fn the_first_command_draws() {
    let readme = page("README.md");
    let from_sources = |b: &(&str, &str, String)| b.1 == "sh" && b.2.starts_with("cargo ");
    let start = blocks(&readme).into_iter().find(from_sources).unwrap().2;
    let command = start.lines().next().unwrap();
    let scene = command.split_whitespace().last().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join(scene);
    fs::create_dir_all(copy.parent().unwrap()).unwrap();
    fs::copy(root().join(scene), &copy).unwrap();
    assert_eq!(
        run(folder.path(), command, "C"),
        "Wrote pawns.png: 640 × 480 pixels\n"
    );
    let picture = Path::new(scene).with_extension("png");
    let picture = folder.path().join(picture.file_name().unwrap());
    assert!(image::open(picture).unwrap().width() > 100);
    // One line says what the tests install, and as whom; another one, which Rust is needed.
    let line = readme
        .lines()
        .find(|l| l.starts_with("`tests/run`"))
        .unwrap();
    assert!(
        ["root", "installs", "POV-Ray", "Mitsuba", "Chromium"]
            .iter()
            .all(|w| line.contains(w)),
        "{line}"
    );
    let manifest = page("Cargo.toml");
    let version = manifest
        .lines()
        .find_map(|l| l.strip_prefix("rust-version = "))
        .unwrap();
    let version = version.trim_matches('"');
    for (name, _) in READMES {
        assert!(page(name).contains(&format!("Rust {version}")), "{name}");
    }
}

/// Both pages have the same tour: the same pictures, and as many commands and blocks of each kind, in this order.
#[test]
fn the_czech_page_has_the_same_tour() {
    let [english, czech] = READMES.map(|(name, _)| page(name));
    let kinds =
        |page: &str| -> Vec<String> { blocks(page).into_iter().map(|b| b.1.to_owned()).collect() };
    assert_eq!(kinds(&english), kinds(&czech));
    let pictures = |page: &str| -> Vec<String> {
        let shown = page.split("![").skip(1);
        shown
            .map(|s| {
                s.split("](")
                    .nth(1)
                    .unwrap()
                    .split(')')
                    .next()
                    .unwrap()
                    .to_owned()
            })
            .collect()
    };
    assert_eq!(pictures(&english), pictures(&czech));
    for strip in [
        "scenes/gallery/pictures/all.jpg",
        "scenes/hard/pictures/thin-torus.png",
    ] {
        assert!(pictures(&english).iter().any(|p| p == strip), "{strip}");
    }
    let programs = |page: &str| -> Vec<String> {
        let commands = page.split("zpg ").skip(1);
        let first = commands.filter_map(|c| c.split(|c: char| !c.is_ascii_alphabetic()).next());
        let known = [
            "check",
            "fmt",
            "render",
            "plan",
            "accuracy",
            "probe",
            "convert",
            "crosscheck",
            "lsp",
            "explain",
        ];
        first
            .filter(|c| known.contains(c))
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(programs(&english), programs(&czech));
    // The line in Czech leads there.
    let line = english
        .lines()
        .find(|l| l.starts_with("Na českém systému"))
        .unwrap();
    assert!(line.contains("(README.cs.md)"), "{line}");
}

/// What GitHub calls a heading in a link.
fn anchor(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase();
    kept.chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}

#[test]
fn links_lead_somewhere() {
    let mut pages: Vec<PathBuf> = ["README.md", "README.cs.md", "CONTRIBUTING.md"]
        .map(PathBuf::from)
        .into();
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let name = entry.unwrap().file_name();
        if name.to_str().unwrap().ends_with(".md") {
            pages.push(Path::new("docs").join(name));
        }
    }
    assert!(pages.len() > 5);
    let mut count = 0;
    for name in pages {
        let text = fs::read_to_string(root().join(&name)).unwrap();
        for link in text.split("](").skip(1) {
            let link = link.split(')').next().unwrap();
            if link.starts_with("http") {
                continue;
            }
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = match file {
                "" => root().join(&name),
                file => root().join(name.parent().unwrap()).join(file),
            };
            assert!(target.exists(), "{}: {link}", name.display());
            if !heading.is_empty() {
                let text = fs::read_to_string(&target).unwrap();
                let mut headings = text.lines().filter(|l| l.starts_with('#')).map(anchor);
                assert!(headings.any(|h| h == heading), "{}: {link}", name.display());
            }
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
}
