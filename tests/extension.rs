//! The extension of Visual Studio Code as it lies in the repository: its texts in both languages, and its pictures.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::support::program;

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("editors/vscode")
        .join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap()
}

/// The names in a file of texts; none of the texts is empty.
fn names(file: &str) -> BTreeSet<String> {
    let all: Value = serde_json::from_str(&read(file)).unwrap();
    let all = all.as_object().unwrap();
    assert!(all.values().all(|v| !v.as_str().unwrap().is_empty()));
    all.keys().cloned().collect()
}

/// All strings in a value, with the names that they have there.
fn strings<'a>(name: &'a str, value: &'a Value, out: &mut Vec<(&'a str, &'a str)>) {
    match value {
        Value::String(text) => out.push((name, text)),
        Value::Array(all) => all.iter().for_each(|v| strings(name, v, out)),
        Value::Object(fields) => fields.iter().for_each(|(n, v)| strings(n, v, out)),
        _ => {}
    }
}

/// The texts between a mark and an end.
fn between<'a>(text: &'a str, mark: &'a str, end: char) -> impl Iterator<Item = &'a str> {
    text.match_indices(mark)
        .filter_map(move |(at, _)| text[at + mark.len()..].split(end).next())
}

/// What the editor shows of commands and settings, and what the extension itself says, is there in both languages.
#[test]
fn all_texts_have_both_languages() {
    let package: Value = serde_json::from_str(&read("package.json")).unwrap();
    let mut all = Vec::new();
    strings("", &package, &mut all);
    let text = |s: &str| Some(s.strip_prefix('%')?.strip_suffix('%')?.to_owned());
    let used: BTreeSet<String> = all.iter().filter_map(|(_, s)| text(s)).collect();
    assert!(used.len() > 20);
    assert_eq!(used, names("package.nls.json"));
    assert_eq!(used, names("package.nls.cs.json"));
    // No text stands there by itself but the name of the language.
    let shown = ["title", "description", "displayName"];
    let plain = all
        .iter()
        .filter(|(name, s)| shown.contains(name) && text(s).is_none());
    assert!(plain.clone().all(|(_, s)| *s == "ZPG"), "{plain:?}");
    let sources = ["extension", "preview", "program"].map(|n| read(&format!("src/{n}.ts")));
    let said = sources
        .iter()
        .flat_map(|s| [".t(\"", " t(\"", "[t(\""].map(|mark| between(s, mark, '"')));
    let said: BTreeSet<String> = said.flatten().map(str::to_owned).collect();
    assert_eq!(said, names("l10n/bundle.l10n.cs.json"));
}

/// Places in Czech texts are those of the English ones.
#[test]
fn places_are_the_same() {
    let all: Value = serde_json::from_str(&read("l10n/bundle.l10n.cs.json")).unwrap();
    for (english, czech) in all.as_object().unwrap() {
        let places = |text: &str| ["{0}", "{1}", "{2}"].map(|p| text.matches(p).count());
        assert_eq!(places(english), places(czech.as_str().unwrap()));
    }
}

/// The icon is what zpg draws of the scene beside it.
#[test]
fn the_icon_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = folder.path().join("icon.png");
    let output = program::command()
        .arg("render")
        .arg(path("images/icon.zpg"))
        .args(["--size", "256x256", "--samples", "1", "-o"])
        .arg(&drawn)
        .output()
        .unwrap();
    assert!(output.status.success());
    let [drawn, own] = [drawn, path("images/icon.png")].map(|p| image::open(p).unwrap());
    assert_eq!((own.width(), own.height()), (256, 256));
    assert!(drawn == own, "the icon is not what zpg draws");
}

/// What the page and the package name is there, and is packed.
#[test]
fn what_is_named_is_packed() {
    let package: Value = serde_json::from_str(&read("package.json")).unwrap();
    let packed: Vec<String> = read(".vscodeignore")
        .lines()
        .filter_map(|l| l.strip_prefix('!').map(str::to_owned))
        .collect();
    let named = [
        "package.nls.json",
        "package.nls.cs.json",
        "CHANGELOG.md",
        "INSTALL.md",
        "INSTALL.cs.md",
    ];
    let icon = package["icon"].as_str().unwrap();
    for name in named
        .iter()
        .copied()
        .chain([icon, "l10n/bundle.l10n.cs.json"])
    {
        assert!(path(name).is_file(), "{name}");
        assert!(packed.iter().any(|p| p == name), "{name} is not packed");
    }
    let page = read("README.md");
    let pictures: Vec<&str> = between(&page, "](images/", ')').collect();
    assert!(pictures.len() >= 2);
    for name in pictures {
        let picture = image::open(path("images").join(name)).unwrap();
        assert!(picture.width() >= 400, "{name}");
    }
}
