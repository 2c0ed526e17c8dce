//! `zpg check --format sarif` against the schema of SARIF 2.1.0, and what the schema cannot say:
//! that places are right, rules are the ones meant, and fixes are those of `--format json`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use jsonschema::Validator;
use serde_json::Value;
use zpg::internals::diagnostics::{Code, Language};

fn validator() -> Validator {
    let schema = include_str!("sarif/sarif-schema-2.1.0.json");
    // The pattern for languages has a bracket too many, with which it is no regular expression; what
    // it is meant to say stands in the description beside it.
    let slip = "^[a-zA-Z]{2}|^[a-zA-Z]{2}-[a-zA-Z]{2}]?$";
    assert!(schema.contains(slip));
    let schema = schema.replace(slip, "^[a-zA-Z]{2}(-[a-zA-Z]{2})?$");
    jsonschema::options()
        .should_validate_formats(true)
        .build(&serde_json::from_str(&schema).unwrap())
        .unwrap()
}

/// Checks files in a folder.
fn check(folder: &Path, args: &[&str]) -> Value {
    let run = crate::support::program::command()
        .arg("check")
        .args(args)
        .current_dir(folder)
        .output()
        .unwrap();
    serde_json::from_slice(&run.stdout).unwrap_or_else(|e| {
        let complaints = String::from_utf8_lossy(&run.stderr);
        panic!("{args:?}: {e}\n{complaints}")
    })
}

fn array(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn number(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

/// The file that a reference names, relative to the folder.
fn named(uri: &Value) -> PathBuf {
    let uri = uri.as_str().unwrap();
    let mut bytes = Vec::new();
    let mut rest = uri.bytes();
    while let Some(b) = rest.next() {
        assert!(b.is_ascii_graphic(), "{uri}");
        if b == b'%' {
            let hex = [rest.next().unwrap(), rest.next().unwrap()];
            let hex = std::str::from_utf8(&hex).unwrap();
            bytes.push(u8::from_str_radix(hex, 16).unwrap());
        } else {
            bytes.push(b);
        }
    }
    PathBuf::from(String::from_utf8(bytes).unwrap())
}

/// A file as the standard counts: its lines of characters with what ends them, and where on disk
/// each starts.
struct Lines {
    lines: Vec<(usize, Vec<char>)>,
    bytes: Vec<u8>,
    wide: bool,
}

impl Lines {
    fn read(path: &Path) -> Lines {
        let bytes = fs::read(path).unwrap();
        let wide = std::str::from_utf8(&bytes).is_ok();
        let text = if wide {
            String::from_utf8(bytes.clone()).unwrap()
        } else {
            let (text, _) = encoding_rs::WINDOWS_1250.decode_without_bom_handling(&bytes);
            text.into_owned()
        };
        let mut lines = vec![(0, Vec::new())];
        let mut at = 0;
        let mut chars = text.chars().peekable();
        while let Some(c) = chars.next() {
            at += if wide { c.len_utf8() } else { 1 };
            if c == '\u{feff}' && at == 3 {
                // It belongs to no line.
                lines[0].0 = at;
                continue;
            }
            lines.last_mut().unwrap().1.push(c);
            if c == '\n' || c == '\r' && chars.peek() != Some(&'\n') {
                lines.push((at, Vec::new()));
            }
        }
        Lines { lines, bytes, wide }
    }

    /// The byte of a line and a column, both from 1.
    fn byte(&self, line: &Value, column: &Value) -> usize {
        let (start, chars) = &self.lines[number(line) - 1];
        let before = &chars[..number(column) - 1];
        let width = |c: &char| if self.wide { c.len_utf8() } else { 1 };
        start + before.iter().map(width).sum::<usize>()
    }

    /// Lines and columns mean the same as bytes.
    fn assert_region(&self, region: &Value) {
        let start = number(&region["byteOffset"]);
        let end = start + number(&region["byteLength"]);
        assert!(end <= self.bytes.len(), "{region}");
        let from = self.byte(&region["startLine"], &region["startColumn"]);
        let to = self.byte(&region["endLine"], &region["endColumn"]);
        // A finding about the whole file may start at its mark, which is in no column.
        let from = if start == 0 { 0 } else { from };
        assert_eq!((from, to), (start, end), "{region}");
    }
}

/// What holds of every log, and how many results it has.
fn assert_sound(folder: &Path, paths: &[&str], lang: &str) -> usize {
    let with = |format| {
        let options = ["--lang", lang, "--format", format];
        check(folder, &[&options, paths].concat())
    };
    let (log, json) = (with("sarif"), with("json"));
    let faults: Vec<String> = validator()
        .iter_errors(&log)
        .map(|e| format!("{}: {e}", e.instance_path()))
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");

    let run = &log["runs"][0];
    // Programs read it, whoever runs them.
    assert_eq!(run["language"], "en");
    let rules = array(&run["tool"]["driver"]["rules"]);
    let mut spoke = BTreeSet::new();
    let mut results = array(&run["results"]).iter();
    assert_eq!(array(&run["artifacts"]).len(), array(&json["files"]).len());
    for (artifact, file) in array(&run["artifacts"]).iter().zip(array(&json["files"])) {
        let uri = &artifact["location"]["uri"];
        let path = named(uri);
        let given = Path::new(file["path"].as_str().unwrap());
        assert_eq!(path, given.strip_prefix("./").unwrap_or(given));
        let lines = Lines::read(&folder.join(&path));
        let encoding = if lines.wide { "UTF-8" } else { "windows-1250" };
        assert_eq!(artifact["encoding"], encoding);
        for finding in array(&file["diagnostics"]) {
            let result = results.next().unwrap();
            assert_eq!(result["ruleId"], finding["code"]);
            let rule = &rules[number(&result["ruleIndex"])];
            assert_eq!(rule["id"], finding["code"]);
            assert_eq!(rule["name"], finding["name"]);
            spoke.insert(number(&result["ruleIndex"]));
            let level = match finding["severity"].as_str().unwrap() {
                "style" => "note",
                severity => severity,
            };
            assert_eq!(result["level"], level);
            let message = finding["message"].as_str().unwrap();
            let message = message.replace('{', "{{").replace('}', "}}");
            let text = result["message"]["text"].as_str().unwrap();
            assert!(text.starts_with(&message), "{text}");

            let places = array(&result["locations"]);
            assert_eq!(places.len(), 1);
            let related = array(&result["relatedLocations"]);
            assert_eq!(related.len(), array(&finding["labels"]).len());
            for location in places.iter().chain(related) {
                let physical = &location["physicalLocation"];
                assert_eq!(&physical["artifactLocation"]["uri"], uri);
                lines.assert_region(&physical["region"]);
            }
            let start = &places[0]["physicalLocation"]["region"]["byteOffset"];
            assert_eq!(start, &finding["span"]["start"]["offset"]);

            let fixes = array(&result["fixes"]);
            assert_eq!(fixes.len(), array(&finding["fixes"]).len());
            for (fix, expected) in fixes.iter().zip(array(&finding["fixes"])) {
                assert_eq!(
                    fix["properties"]["applicability"],
                    expected["applicability"]
                );
                let change = &fix["artifactChanges"][0];
                assert_eq!(&change["artifactLocation"]["uri"], uri);
                let edits = array(&expected["edits"]);
                let replacements = array(&change["replacements"]);
                assert_eq!(replacements.len(), edits.len());
                for (replacement, edit) in replacements.iter().zip(edits) {
                    let region = &replacement["deletedRegion"];
                    lines.assert_region(region);
                    assert_eq!(region["byteOffset"], edit["start"]);
                    let end = number(&region["byteOffset"]) + number(&region["byteLength"]);
                    assert_eq!(end, number(&edit["end"]));
                    assert_eq!(replacement["insertedContent"]["text"], edit["text"]);
                }
            }
        }
    }
    assert!(results.next().is_none());
    assert_eq!(
        spoke.len(),
        rules.len(),
        "a rule is listed that says nothing"
    );
    array(&run["results"]).len()
}

/// Bytes of scenes: what `zpg explain` shows, and the corpus.
fn scenes() -> Vec<(String, Vec<u8>)> {
    let mut scenes = Vec::new();
    for &code in Code::ALL {
        let page = code.explanation(Language::English);
        let fences = page.split("```zpg\n").skip(1);
        for (i, fence) in fences.enumerate() {
            let scene = fence.split("```").next().unwrap();
            let name = format!("{}-{i}", code.as_str());
            scenes.push((name, scene.as_bytes().to_vec()));
        }
    }
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let mut files: Vec<_> = fs::read_dir(corpus).unwrap().map(|e| e.unwrap()).collect();
    files.sort_by_key(fs::DirEntry::path);
    for file in files {
        let name = file.file_name().into_string().unwrap();
        scenes.push((name.replace(".zpg", ""), fs::read(file.path()).unwrap()));
    }
    scenes
}

#[test]
fn the_scenes_of_the_repository() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let results = assert_sound(
        root,
        &["scenes", "./tests/corpus", "tests/hard_cases"],
        "en",
    );
    assert!(results > 0);
}

#[test]
fn every_page_whatever_the_language() {
    let dir = tempfile::tempdir().unwrap();
    for (name, scene) in scenes() {
        fs::write(dir.path().join(format!("{name}.zpg")), scene).unwrap();
    }
    // The scene in JSON is not found in a folder, but taken where it is named.
    let json = Code::E015
        .explanation(Language::English)
        .split("```")
        .nth(1)
        .unwrap();
    let json = json.strip_prefix("json\n").unwrap();
    fs::write(dir.path().join("E015.json"), json).unwrap();
    let paths = [".", "E015.json"];
    for lang in ["en", "cs"] {
        assert_sound(dir.path(), &paths, lang);
    }
    let log = check(dir.path(), &[&["--format", "sarif"], &paths[..]].concat());
    let rules = array(&log["runs"][0]["tool"]["driver"]["rules"]);
    // All but what no page can show: an unreadable image, and a file that is not UTF-8.
    assert!(rules.len() + 2 >= Code::ALL.len(), "{}", rules.len());
}

#[test]
fn damaged_scenes_under_odd_names() {
    let dir = tempfile::tempdir().unwrap();
    let mut state = 0x5EED_u64;
    let mut random = |below: usize| {
        // Knuth's MMIX generator; its high bits are good.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let damage: [&[u8]; 12] = [
        b"",
        b"\n",
        b"\r",
        b"\r\n",
        b" x ",
        "ž{0}".as_bytes(),
        b"\xf8\xed",
        b"#",
        b" 1e999 ",
        b"<",
        "\u{1f98a}".as_bytes(),
        b" -204 ",
    ];
    for (i, (name, mut scene)) in scenes().into_iter().enumerate() {
        for _ in 0..1 + random(4) {
            let at = random(scene.len() + 1);
            let to = (at + random(4)).min(scene.len());
            scene.splice(at..to, damage[random(damage.len())].iter().copied());
        }
        if i % 4 == 0 {
            scene.splice(0..0, "\u{feff}".bytes());
        }
        let odd = [" ", "ž", "#", "%41", "?", ":", "[0]", "&"][i % 8];
        fs::write(dir.path().join(format!("{name}{odd}.zpg")), scene).unwrap();
    }
    let results = assert_sound(dir.path(), &["."], "en");
    assert!(results > 150, "{results}");
}

#[test]
fn a_run_without_findings_and_one_that_cannot_read() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), "").unwrap();
    let log = check(dir.path(), &["--format", "sarif", "b.zpg"]);
    assert!(validator().is_valid(&log));
    let run = &log["runs"][0];
    // An empty list says that nothing was found; a missing one, that nothing was looked for.
    assert_eq!(run["results"], serde_json::json!([]));
    assert_eq!(run["invocations"][0]["executionSuccessful"], false);
    let log = check(dir.path(), &["--format", "sarif", "a.zpg"]);
    let run = &log["runs"][0];
    assert_eq!(run["invocations"][0]["executionSuccessful"], true);
}

#[test]
fn the_schema_would_notice() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.zpg"), "2 11 0 0 0 -1\n").unwrap();
    let good = check(dir.path(), &["--format", "sarif", "a.zpg"]);
    assert!(validator().is_valid(&good));
    for (place, value) in [
        ("/runs/0/results/0/level", "style"),
        ("/runs/0/columnKind", "chars"),
        ("/runs/0/artifacts/0/location/uri", "a b"),
        ("/version", "2.2"),
    ] {
        let mut bad = good.clone();
        *bad.pointer_mut(place).unwrap() = value.into();
        assert!(!validator().is_valid(&bad), "{place}");
    }
}
