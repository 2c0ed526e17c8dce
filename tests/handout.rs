//! The handout's examples: as printed they give the findings that lie beside them, repaired they
//! give none, but that in the last one two balls of different glass overlap, as they do in the
//! handout.

use std::fmt::Write;
use std::path::PathBuf;

use zpg::commands::load;

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
        for d in &loaded.diagnostics {
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

#[test]
fn repaired_examples() {
    for path in scenes("scenes/handout") {
        let loaded = load(&path).unwrap();
        let found: Vec<&str> = (loaded.diagnostics.iter())
            .map(|d| d.code.as_str())
            .collect();
        let balls = path.ends_with("4-checkerboard-and-spheres.zpg");
        let expected: &[&str] = if balls { &["W307"] } else { &[] };
        assert_eq!(found, expected, "{}", path.display());
        assert!(loaded.scene.render.is_some());
    }
}
