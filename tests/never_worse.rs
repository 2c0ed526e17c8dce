//! `check --fix` never makes a file worse: scenes with random mistakes, each before and after.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::campaign::rng::Rng;
use crate::support::{program::zpg, seeds};

/// So many mistakes at most are made in one scene.
const MISTAKES: usize = 4;

fn words(text: &str) -> Vec<(usize, usize)> {
    let mut out = Vec::new();
    let mut start = None;
    for (i, c) in text.char_indices() {
        match (c.is_whitespace(), start) {
            (true, Some(s)) => {
                out.push((s, i));
                start = None;
            }
            (false, None) => start = Some(i),
            _ => {}
        }
    }
    out.extend(start.map(|s| (s, text.len())));
    out
}

/// A word as somebody may write it who does not know better.
fn misspelled(rng: &mut Rng, word: &str) -> String {
    let integer = word.parse::<i64>().is_ok();
    match rng.below(18) {
        0 | 1 if integer => format!("{word}.0"),
        2 if integer => format!("{word}e0"),
        3 if integer => format!("{word}.5"),
        0..=3 => word.replacen('.', ",", 1),
        4 => format!("{word},"),
        5 => format!("-{word}"),
        6 => word.trim_start_matches('-').to_owned(),
        7 => format!("({word})"),
        8 => format!("{word}.{}", rng.below(100)),
        9 => format!("{word}-{}", rng.below(10)),
        10 => format!("{word}/{}", rng.below(5)),
        11 => word.replace('-', "−"),
        12 => format!("#{word}"),
        13 => format!("{word}#"),
        14 => format!("{word}{}", rng.pick(&["?", "x", ";", "@", "1e999", "°"])),
        15 => format!("{}", rng.below(60) as i64 - 20),
        16 => (*rng.pick(&["0", "0.0", "1.0", "2.0", "9.0", "-1.0", "-402.0"])).to_owned(),
        _ => (*rng.pick(&["ball", "red", "bílá", "y", "cylinder"])).to_owned(),
    }
}

fn mutant(rng: &mut Rng, scene: &str) -> String {
    let mut text = scene.to_owned();
    for _ in 0..=rng.below(MISTAKES) {
        let all = words(&text);
        if all.len() < 2 {
            break;
        }
        let i = rng.below(all.len());
        let (start, end) = all[i];
        let word = text[start..end].to_owned();
        let other = {
            let (s, e) = all[rng.below(all.len())];
            text[s..e].to_owned()
        };
        match rng.below(10) {
            0 => text.replace_range(start..end, ""),
            1 => text.replace_range(start..end, &format!("{word} {other}")),
            2 => text.replace_range(start..end, &other),
            3 => text.replace_range(start..end, &format!("{word}\n")),
            4 => {
                if let Some(at) = text[start..].find('\n') {
                    text.replace_range(start + at..start + at + 1, " ");
                }
            }
            _ => {
                let wrong = misspelled(rng, &word);
                text.replace_range(start..end, &wrong);
            }
        }
    }
    text
}

/// Short scenes in which most things refer to each other, and those of the repository that are short.
fn scenes() -> Vec<String> {
    let mut out: Vec<String> = [
        "2 9 1\n2 -402 9 1\n50 -1 3 5 5\n1 9999 2 0\n",
        "2 9 1\n50 -402 1\n50 -1 3 5 5\n1 9999 2 0\n",
        "2 12 -1 -1 -1 1 1 1\n3 16 2 1\n3 -2 30 1\n4 -103 2 3\n4 -201 0.5 0.25 0.25\n1 9999 4 0 -2 -2 -2 2 2 2\n",
        "7 -701 1 0 0\n8 -399 10 10 7 7\n2 13 1 3\n2 -299 8 0\n9 -501 0 0 9 0 0 -1 0 1 0 45\n10 -502 9\n1 9999 2 7\n",
        "2 1 3 0 0 1 0.5 0 1\n3 -105 2\n3 -3 1 -1 1\n4 -101 2 3\n4 -602 0 0 0 3\n1 9999 4 0\n",
    ]
    .map(str::to_owned)
    .to_vec();
    for folder in [
        "scenes/handout",
        "scenes/gallery",
        "scenes/hard",
        "tests/corpus",
    ] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|e| e == "zpg") {
                let text = fs::read_to_string(&path).unwrap_or_default();
                if (1..8000).contains(&text.len()) {
                    out.push(text);
                }
            }
        }
    }
    out.sort();
    out
}

/// The errors of each file of a folder: codes and the text of the line.
fn errors(folder: &Path) -> BTreeMap<String, Vec<(String, String)>> {
    let run = zpg(folder, &["check", "--format", "json", "."]);
    let said = String::from_utf8_lossy(&run.stderr);
    let report = serde_json::from_slice(&run.stdout);
    let report: Value = report.unwrap_or_else(|e| panic!("{e}: {said}"));
    let mut all: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
    for file in report["files"].as_array().unwrap() {
        let path = file["path"].as_str().unwrap();
        let text = fs::read(folder.join(path)).unwrap();
        let text = String::from_utf8_lossy(&text).into_owned();
        let lines: Vec<&str> = text.split('\n').collect();
        for d in file["diagnostics"].as_array().unwrap() {
            if d["severity"] == "error" {
                let line = d["span"]["start"]["line"].as_u64().unwrap() as usize;
                let code = d["code"].as_str().unwrap().to_owned();
                let error = (code, lines[line - 1].trim().to_owned());
                all.entry(path.to_owned()).or_default().push(error);
            }
        }
    }
    all
}

#[test]
fn no_file_has_more_errors_after_its_fixes() {
    let scenes = scenes();
    assert!(scenes.len() > 20, "{}", scenes.len());
    for unsafe_too in [false, true] {
        let dir = tempfile::tempdir().unwrap();
        let mut count = 0;
        for seed in seeds("NEVER_WORSE", 0..500) {
            let mut rng = Rng::new(seed);
            // The short ones are the likelier, in which most depends on each number.
            let scene = match rng.below(2) {
                0 => &scenes[rng.below(scenes.len())],
                _ => rng.pick(&scenes[..]),
            };
            let name = format!("{seed:07}.zpg");
            fs::write(dir.path().join(name), mutant(&mut rng, scene)).unwrap();
            count += 1;
        }
        let before = errors(dir.path());
        let mut texts = BTreeMap::new();
        for entry in fs::read_dir(dir.path()).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            texts.insert(name, fs::read_to_string(&path).unwrap());
        }
        let fix: &[&str] = match unsafe_too {
            false => &["check", "--fix", "."],
            true => &["check", "--fix", "--unsafe-fixes", "."],
        };
        zpg(dir.path(), fix);
        let after = errors(dir.path());
        let mut wrong = String::new();
        let mut fixed = 0;
        for (name, text) in &texts {
            let now = fs::read_to_string(dir.path().join(name)).unwrap();
            fixed += usize::from(now != *text);
            let none = Vec::new();
            let of = |all: &BTreeMap<String, Vec<(String, String)>>| {
                let key = all.keys().find(|k| k.ends_with(name.as_str()));
                key.map_or_else(|| none.clone(), |k| all[k].clone())
            };
            let (old, new) = (of(&before), of(&after));
            // On a line that is as it was there is nothing new, but that an ID is defined twice, which a record that could
            // not be read may have hidden.
            let lines: Vec<&str> = text.split('\n').map(str::trim).collect();
            let count = |all: &[(String, String)], e: &(String, String)| {
                all.iter().filter(|o| *o == e).count()
            };
            let anew = new
                .iter()
                .filter(|e| e.0 != "E102" && lines.contains(&e.1.as_str()))
                .any(|e| count(&new, e) > count(&old, e));
            if new.len() > old.len() || anew {
                wrong += &format!("{name}: {old:?}, then {new:?}\n{text}\n→\n{now}\n");
            }
        }
        assert!(wrong.is_empty(), "unsafe: {unsafe_too}\n{wrong}");
        assert!(5 * fixed > count, "{fixed} of {count}");
    }
}

/// An ID that is spelled as a real is one: what else is wrong is said at once, and nothing else once the
/// ID is mended.
#[test]
fn ids_spelled_as_reals() {
    for (line, found) in [
        ("2.0 -402 9.0 1", "E010 E009"),
        ("3.0 9", "E010 E008"),
        ("3.0 9 1 1", "E010 E009"),
        ("3.0 9 a", "E010 E012"),
        ("3.0 13 1 2.0 7", "E010 E009"),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let text = format!("2 9 1\n{line}\n50 -1 3 5 5\n1 9999 2 0\n");
        let codes = |text: &str| {
            fs::write(dir.path().join("a.zpg"), text).unwrap();
            let all = errors(dir.path());
            let all = all.into_values().flatten().map(|e| e.0);
            all.collect::<Vec<_>>().join(" ")
        };
        assert!(codes(&text).starts_with(found), "{line}: {}", codes(&text));
        let mended = codes(&text.replacen(".0", "", 1));
        let rest = codes(&text).replacen("E010 ", "", 1);
        assert_eq!(mended, rest, "{line}");
    }
}
