//! The scenes of the repository in POV-Ray and in our tracer.

use std::path::{Path, PathBuf};

use crate::lint_generated::scenes;
use crate::support;
use support::compare::compare;
use zpg::commands::Loaded;
use zpg::translate::{Fidelity, pov};

/// Scenes in a folder, in order.
fn files(folder: &Path) -> Vec<PathBuf> {
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
    for path in files(folder) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if skip.contains(&name.as_str()) {
            continue;
        }
        let loaded = zpg::commands::load(&path).unwrap();
        assert!(loaded.sound, "{}", path.display());
        for outcome in compare(&name, &loaded.scene, folder, size) {
            println!(
                "{name:>28}: {:6.3} % wrong, worst {:7.2}/255, {} of {} on edges, {} total reflection",
                100.0 * outcome.differing.share_off_silhouettes,
                255.0 * outcome.difference.largest,
                outcome.silhouettes,
                outcome.pixels,
                outcome.total_reflection
            );
            // Shading normals that face away are turned the other way there.
            let allowed = if name == "island" { 0.001 } else { 0.0005 };
            if outcome.differing.share_off_silhouettes > allowed {
                bad.push((name.clone(), outcome.differing.off_silhouettes));
            }
        }
    }
    assert!(bad.is_empty(), "{bad:?}");
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("scenes")
        .join(name)
}

/// Left out is a chain of 2³⁰ rings.
#[test]
fn gallery() {
    check(&folder("gallery"), (160, 120), &["billion"]);
}

#[test]
fn handout() {
    check(&folder("handout"), (160, 120), &[]);
}

/// Left out are the scenes beyond POV-Ray's numbers: faces in one place, and what is too far, too
/// small or too thin for its tolerances.
#[test]
fn hard() {
    let beyond = [
        "equal-solids",
        "far-group",
        "far-sphere",
        "flush-box",
        "flush-tube",
        "gap",
        "ground",
        "huge",
        "huger",
        "lathe",
        "sheet",
        "thin-torus",
        "thin-torus-far",
    ];
    check(&folder("hard"), (160, 128), &beyond);
}

/// Any folder: `POV_SCENES=folder cargo test --test all pov_scenes any -- --nocapture`.
#[test]
fn any() {
    if let Some(folder) = std::env::var_os("POV_SCENES") {
        check(Path::new(&folder), (160, 120), &[]);
    }
}

/// What a report may call approximate in a scene that agrees off the pixels it shows on.
const KNOWN: [&str; 4] = [
    "total internal reflection",
    "triangle with a normal",
    "triangle with vertex normals",
    "shading normals",
];

/// Random scenes agree where the report says that all is exact. `POV_SEEDS=1..60` chooses others.
#[test]
fn random() {
    // A solid of revolution and its mirror image have their faces in one place.
    const COINCIDENT: [u64; 1] = [8];
    let seeds = std::env::var("POV_SEEDS").unwrap_or("1..25".to_owned());
    let (from, to) = seeds.split_once("..").unwrap();
    let (mut bad, mut exact) = (Vec::new(), 0);
    for seed in from.parse::<u64>().unwrap()..to.parse().unwrap() {
        let text = scenes::scene(seed);
        let loaded = Loaded::new("scene.zpg", text.clone().into());
        assert!(loaded.sound, "{:?}", loaded.diagnostics);
        let name = format!("random_{seed}");
        let translation = pov::write(&loaded.scene, &pov::Options::default()).unwrap();
        let doubtful: Vec<_> = translation
            .report
            .entries()
            .filter(|e| e.fidelity != Fidelity::Exact && !KNOWN.contains(&e.feature.as_str()))
            .map(|e| e.feature.as_str())
            .collect();
        for outcome in compare(&name, &loaded.scene, Path::new("."), (96, 72)) {
            println!(
                "{name:>12}: {:6.3} % wrong, worst {:7.2}/255, {} on edges, {} total reflection {doubtful:?}",
                100.0 * outcome.differing.share_off_silhouettes,
                255.0 * outcome.difference.largest,
                outcome.silhouettes,
                outcome.total_reflection
            );
            if !doubtful.is_empty() || COINCIDENT.contains(&seed) {
                continue;
            }
            exact += 1;
            if outcome.differing.share_off_silhouettes > 0.0005 {
                bad.push(name.clone());
            }
        }
    }
    assert!(bad.is_empty(), "{bad:?}");
    assert!(exact > 10, "{exact}");
}
