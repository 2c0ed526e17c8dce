//! The scenes of the repository in POV-Ray and in our tracer.

mod support;

use std::path::{Path, PathBuf};

use support::compare::compare;

/// Scenes in a folder, in order.
fn scenes(folder: &Path) -> Vec<PathBuf> {
    let mut out: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|e| e.expect("an entry").path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        .collect();
    out.sort();
    out
}

/// Compares all scenes of a folder; names those that have too many wrong pixels.
fn check(folder: &Path, size: (u32, u32), skip: &[&str]) {
    let mut bad = Vec::new();
    for path in scenes(folder) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if skip.contains(&name.as_str()) {
            continue;
        }
        let loaded = zpg::commands::load(&path).unwrap();
        assert!(loaded.sound, "{}", path.display());
        for outcome in compare(&name, &loaded.scene, folder, size) {
            println!(
                "{name:>28}: {:6.3} % wrong, worst {:7.2}/255, {} of {} on edges, {} total reflection",
                100.0 * outcome.share(),
                255.0 * outcome.worst,
                outcome.edges,
                outcome.pixels,
                outcome.total
            );
            if outcome.share() > 0.0005 {
                bad.push((name.clone(), outcome.wrong.len(), outcome.wrong[0]));
            }
        }
    }
    assert!(bad.is_empty(), "{bad:.4?}");
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("scenes")
        .join(name)
}

#[test]
fn gallery() {
    check(&folder("gallery"), (160, 120), &["billion"]);
}

#[test]
fn handout() {
    check(&folder("handout"), (160, 120), &[]);
}

#[test]
fn hard() {
    check(&folder("hard"), (160, 128), &[]);
}

/// Any folder: `POV_SCENES=folder cargo test --test pov_scenes any -- --nocapture`.
#[test]
fn any() {
    if let Some(folder) = std::env::var_os("POV_SCENES") {
        check(Path::new(&folder), (160, 120), &[]);
    }
}
