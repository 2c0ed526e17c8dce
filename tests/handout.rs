//! The handout's examples: as printed they give the findings that lie beside them, repaired they
//! give none but the few that are named here.

use std::fmt::Write;
use std::path::PathBuf;

use zpg::analysis::file::load;
use zpg::diagnostics::Diagnostic;

fn scenes(folder: &str) -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        .collect();
    files.sort();
    assert_eq!(files.len(), 4, "{}", folder.display());
    files
}

#[test]
fn printed_examples() {
    for path in scenes("scenes/handout/printed") {
        let loaded = load(&path).unwrap();
        let mut found = String::new();
        for d in loaded.findings() {
            let at = loaded.source.position(d.span.start);
            write!(
                found,
                "{}:{} {} {}",
                at.line,
                at.column,
                d.severity.as_str(),
                d.code.as_str()
            )
            .unwrap();
            for edit in d.fixes.iter().flat_map(|f| &f.edits) {
                let old = loaded.source.slice(edit.span);
                write!(found, ", {old} -> {}", edit.text).unwrap();
            }
            found.push('\n');
        }
        let expected = std::fs::read_to_string(path.with_extension("expected")).unwrap();
        assert_eq!(found, expected, "{}", path.display());
    }
}

/// What is left in the repaired examples, as a code and a line.
const LEFT: &[(&str, &str)] = &[
    // The colour comes after the union that has taken the ball.
    ("3-camera.zpg", "W309 7"),
    // The handout defines the checkerboard 16, and gives 17 one of its own.
    ("4-checkerboard-and-spheres.zpg", "W310 7"),
    // Two balls of different glass overlap.
    ("4-checkerboard-and-spheres.zpg", "W307 20"),
];

#[test]
fn repaired_examples() {
    for path in scenes("scenes/handout") {
        let loaded = load(&path).unwrap();
        let line = |d: &Diagnostic| loaded.source.position(d.span.start).line;
        let found: Vec<String> = (loaded.findings().iter())
            .map(|d| format!("{} {}", d.code.as_str(), line(d)))
            .collect();
        let name = path.file_name().unwrap().to_string_lossy();
        let left = LEFT.iter().filter(|l| name == l.0).map(|l| l.1);
        assert_eq!(found, left.collect::<Vec<_>>(), "{name}");
        assert!(loaded.scene.render.is_some());
    }
}
