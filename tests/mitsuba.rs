//! What the real Mitsuba sees of translations, pixel by pixel against our tracer.

use std::path::{Path, PathBuf};

use crate::lint_generated::scenes;
use crate::support::mitsuba;
use zpg::commands::Loaded;
use zpg::scene::Scene;
use zpg::trace::camera::View;
use zpg::trace::{Images, Tracer, Walkers, selected_camera};
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

/// What is seen first through a pixel.
#[derive(Debug, Clone, Copy)]
struct Seen {
    point: [f64; 3],
    normal: [f64; 3],
    distance: f64,
    shape: u32,
    object: u32,
}

fn ours(scene: &Scene, tracer: &Tracer) -> Vec<Option<Seen>> {
    let camera = selected_camera(scene, f64::from(SIZE.0) / f64::from(SIZE.1));
    let view = View::new(&camera, SIZE.0, SIZE.1).unwrap();
    let mut walkers: Walkers<f64> = tracer.walker();
    let mut out = Vec::new();
    for y in 0..SIZE.1 {
        for x in 0..SIZE.0 {
            let ray = view.ray(f64::from(x) + 0.5, f64::from(y) + 0.5).unwrap();
            let probe = tracer.probe(&mut walkers, &ray);
            out.push(probe.crossings.first().map(|c| Seen {
                point: c.hit.point.0,
                normal: c.hit.shading.0,
                distance: c.hit.t * ray.line.direction.length(),
                shape: c.shape,
                object: c.object,
            }));
        }
    }
    out
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Differences between the two, off the silhouettes.
#[derive(Debug, Default)]
struct Account {
    compared: u32,
    edges: u32,
    /// Largest distance across our surface, by what is allowed.
    exact: f64,
    mesh: f64,
    /// Largest angle between shading normals, in degrees.
    exact_angle: f64,
    mesh_angle: f64,
    wrong: Vec<String>,
}

fn compare(name: &str, loaded: &Loaded, folder: &Path) -> Account {
    let (tracer, output) = translated(name, loaded, folder, Integrator::Aov);
    let theirs = mitsuba::render(name, &output, 0);
    let ours = ours(&loaded.scene, &tracer);
    assert_eq!(theirs.len(), 7 * ours.len());
    let (w, h) = (SIZE.0 as usize, SIZE.1 as usize);
    // The default tolerance is a thousandth of the size.
    let size = output.extent.tolerance * 1e3;
    let mut account = Account::default();
    for y in 1..h - 1 {
        for x in 1..w - 1 {
            let at = |x: usize, y: usize| ours[y * w + x];
            let here = at(x, y);
            let smooth = (0..9).all(|k| match (here, at(x + k % 3 - 1, y + k / 3 - 1)) {
                (None, None) => true,
                // One shape and one face, and not a fold of it: the neighbour is near the tangent plane.
                (Some(a), Some(b)) => {
                    let d: [f64; 3] = std::array::from_fn(|i| b.point[i] - a.point[i]);
                    let across = dot(d, a.normal).abs();
                    a.shape == b.shape
                        && a.object == b.object
                        && dot(a.normal, b.normal) > 0.9
                        && across < 0.5 * dot(d, d).sqrt() + 1e-9 * size
                }
                _ => false,
            });
            // Parts without end are cut off somewhere.
            let beyond = |s: Option<Seen>| {
                s.is_some_and(|s| {
                    s.distance > 1e3 * size || !output.extent.region.contains(s.point)
                })
            };
            let cut = |index: usize| {
                let info = index.checked_sub(1).and_then(|i| output.shapes.get(i));
                info.is_none_or(|i| !i.exact)
            };
            let index = theirs[7 * (y * w + x) + 6].round() as usize;
            if !smooth || beyond(here) && cut(index) {
                account.edges += 1;
                continue;
            }
            account.compared += 1;
            let t = &theirs[7 * (y * w + x)..][..7];
            let index = t[6].round() as usize;
            let Some(here) = here else {
                if index != 0 {
                    account
                        .wrong
                        .push(format!("({x}, {y}) shows shape {index} of theirs"));
                }
                continue;
            };
            let Some(info) = index.checked_sub(1).and_then(|i| output.shapes.get(i)) else {
                account
                    .wrong
                    .push(format!("({x}, {y}) shows nothing, and {here:?}"));
                continue;
            };
            let d: [f64; 3] = std::array::from_fn(|i| f64::from(t[i]) - here.point[i]);
            let across = dot(d, here.normal).abs();
            // What is far away is rounded more.
            let rounding = 1e-4 * size.max(1e-3 * here.distance);
            let n: [f64; 3] = std::array::from_fn(|i| f64::from(t[3 + i]));
            let angle = dot(n, here.normal).abs().min(1.0).acos().to_degrees();
            let (worst, worst_angle, allowed) = if info.exact {
                (&mut account.exact, &mut account.exact_angle, rounding)
            } else {
                let allowed = output.extent.tolerance + rounding;
                (&mut account.mesh, &mut account.mesh_angle, allowed)
            };
            *worst = worst.max(across / allowed);
            *worst_angle = worst_angle.max(angle);
            if across > allowed || (info.shape, info.object) != (here.shape, here.object) {
                account.wrong.push(format!(
                    "({x}, {y}) {across:e} of {allowed:e}, {info:?} and {here:?}"
                ));
            }
        }
    }
    account
}

fn gallery() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
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
fn the_gallery_is_where_we_see_it() {
    for path in gallery() {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let account = compare(&name, &loaded(&path), path.parent().unwrap());
        println!("{name}: {account:.3?}");
        assert!(account.compared > 1000, "{name}");
        assert!(
            account.wrong.is_empty(),
            "{name}: {} {:#?}",
            account.wrong.len(),
            account.wrong
        );
    }
}

#[test]
fn random_scenes_are_where_we_see_them() {
    let range = std::env::var("MITSUBA_SEEDS").ok().and_then(|s| {
        let (a, b) = s.split_once("..")?;
        Some(a.parse().ok()?..b.parse().ok()?)
    });
    let (mut wrong, mut compared) = (0, 0);
    for seed in range.unwrap_or(0..12u64) {
        let loaded = Loaded::new("scene", scenes::scene(seed).into_bytes());
        let account = compare(&format!("random_{seed}"), &loaded, Path::new("."));
        if !account.wrong.is_empty() {
            println!(
                "{seed}: {} of {}: {}",
                account.wrong.len(),
                account.compared,
                account.wrong[0]
            );
        }
        wrong += account.wrong.len() as u32;
        compared += account.compared;
    }
    // At the edges of cuts, which bound one shape on both sides, there are a few.
    println!("{wrong} of {compared}");
    assert!(wrong * 1000 <= compared, "{wrong} of {compared}");
}

#[test]
fn the_gallery_is_rendered() {
    for path in gallery() {
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
