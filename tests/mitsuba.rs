//! What the real Mitsuba sees of translations, pixel by pixel against our tracer.

use std::path::{Path, PathBuf};

use crate::lint_generated::scenes;
use crate::support::mitsuba;
use zpg::commands::Loaded;
use zpg::study::geometry::{self, Comparison};
use zpg::trace::{Images, Tracer, selected_camera};
use zpg::translate::mitsuba::{Integrator, Options, Output, write};

const SIZE: (u32, u32) = (96, 72);

fn translated(
    name: &str,
    loaded: &Loaded,
    folder: &Path,
    integrator: Integrator,
) -> (Tracer, Output) {
    let scene = &loaded.scene;
    let images = Images::load(scene, folder).unwrap();
    let tracer = Tracer::with_images(scene, &images).unwrap();
    let options = Options {
        size: SIZE,
        depth: 10,
        tolerance: None,
        integrator,
        stem: name.to_owned(),
    };
    let output = write(scene, &tracer, &options).unwrap();
    (tracer, output)
}

fn compare(name: &str, loaded: &Loaded, folder: &Path) -> Comparison {
    let (tracer, output) = translated(name, loaded, folder, Integrator::Aov);
    let theirs = mitsuba::render(name, &output, 0);
    let camera = selected_camera(&loaded.scene, f64::from(SIZE.0) / f64::from(SIZE.1));
    let ours = geometry::seen(&tracer, &camera, SIZE);
    geometry::compare(&tracer, &camera, &ours, &theirs, SIZE, &output).unwrap()
}

fn scenes_in(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("scenes")
        .join(folder);
    let mut out: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        // A thousand million balls are refused.
        .filter(|p| p.file_stem().is_some_and(|s| s != "billion"))
        .collect();
    out.sort();
    out
}

fn loaded(path: &Path) -> Loaded {
    Loaded::new(path.to_string_lossy(), std::fs::read(path).unwrap())
}

#[test]
fn the_scenes_are_where_we_see_them() {
    for folder in ["gallery", "handout", "hard"] {
        for path in scenes_in(folder) {
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            let seen = compare(&name, &loaded(&path), path.parent().unwrap());
            println!("{name}: {seen:.3?}");
            assert_eq!(seen.wrong, 0, "{name}: {seen:?}");
            // In the gallery all can be compared; what is hard is hard for single precision, too.
            let compared = seen.exact.pixels + seen.meshes.pixels;
            assert!(compared > 500 || folder == "hard", "{name}: {seen:?}");
            assert!(seen.undecided == 0 || folder == "hard", "{name}: {seen:?}");
        }
    }
}

#[test]
fn random_scenes_are_where_we_see_them() {
    let range = std::env::var("MITSUBA_SEEDS").ok().and_then(|s| {
        let (a, b) = s.split_once("..")?;
        Some(a.parse().ok()?..b.parse().ok()?)
    });
    let mut wrong = Vec::new();
    for seed in range.unwrap_or(0..12u64) {
        let loaded = Loaded::new("scene", scenes::scene(seed).into_bytes());
        let seen = compare(&format!("random_{seed}"), &loaded, Path::new("."));
        if seen.wrong > 0 {
            wrong.push(format!("{seed}: {seen:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_gallery_is_rendered() {
    for path in scenes_in("gallery") {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let loaded = loaded(&path);
        let (_, output) = translated(&name, &loaded, path.parent().unwrap(), Integrator::Path);
        let pixels = mitsuba::render(&format!("{name}_path"), &output, 1);
        assert_eq!(pixels.len(), 3 * (SIZE.0 * SIZE.1) as usize, "{name}");
        assert!(pixels.iter().all(|x| x.is_finite()), "{name}");
        let lit = pixels.iter().filter(|x| **x > 0.01).count();
        assert!(lit > pixels.len() / 20, "{name}: {lit}");
    }
}
