//! Scenes that people are shown check clean; what is meant is allowed, with the reason beside it.

use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::analysis::Analysis;

/// Folders of good scenes. The other scenes of `tests` and `src` are there for their findings.
const FOLDERS: [&str; 5] = [
    "scenes/gallery",
    "scenes/handout",
    "scenes/hard",
    "tests/emitted",
    "tests/hard_cases",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect()
}

/// What is found in a scene, a line each.
fn found(name: &str, text: &[u8]) -> Vec<String> {
    let loaded = Analysis::new(name, text.to_vec());
    let line = |at: u32| loaded.source.position(at).line;
    (loaded.findings().iter())
        .map(|d| format!("{name}:{}: {}", line(d.span.start), d.code.as_str()))
        .collect()
}

#[test]
fn good_scenes_check_clean() {
    let (mut all, mut wrong) = (0, Vec::new());
    for path in FOLDERS.iter().flat_map(|folder| files(folder, "zpg")) {
        let name = path.to_string_lossy().into_owned();
        let text = fs::read(&path).unwrap();
        wrong.extend(found(&name, &text));
        let text = String::from_utf8(text).unwrap();
        for allowed in text.split("zpg: allow(").skip(1) {
            let (_, reason) = allowed.split_once(')').unwrap();
            let reason = reason.split('#').next().unwrap();
            if reason.split_whitespace().count() < 2 {
                wrong.push(format!("{name}: allowed without a reason"));
            }
        }
        all += 1;
    }
    assert!(all > 70, "{all}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Blocks of the pages that are scenes: they have a render record, and are marked `zpg`. Scenes with a mistake that a
/// page is about are marked `text`.
#[test]
fn scenes_of_the_pages_check_clean() {
    let mut pages = files("docs", "md");
    pages.extend(files(".", "md"));
    let (mut all, mut wrong) = (0, Vec::new());
    for path in pages {
        let page = fs::read_to_string(&path).unwrap();
        for block in page.split("```zpg\n").skip(1) {
            let text = block.split("```").next().unwrap();
            if !text.contains(" 9999 ") {
                continue;
            }
            let name = path.file_name().unwrap().to_string_lossy();
            wrong.extend(found(&name, text.as_bytes()));
            all += 1;
        }
    }
    assert!(all >= 3, "{all}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
