//! Meshes of whole scenes: closed, and where the tracer says that the solids are.

use std::path::{Path, PathBuf};

use crate::campaign::rng::Rng;
use crate::lint_generated::scenes;
use crate::support::{cases, seeds, takes_part};
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::vec::Vec3;
use zpg::internals::scene::Scene;
use zpg::internals::trace::{Images, Tracer, members};
use zpg::internals::translate::mesh::{Mesh, Model, Options, model, report};

fn loaded(path: &Path) -> Analysis {
    Analysis::new(path.to_string_lossy(), std::fs::read(path).unwrap())
}

fn tracer(scene: &Scene, folder: &Path) -> Tracer {
    let images = Images::load(scene, folder).unwrap();
    Tracer::with_images(scene, &images).unwrap()
}

/// Whether a line upwards from a point leaves the mesh more often than it enters it.
fn holds(mesh: &Mesh, p: [f64; 3]) -> bool {
    let mut count = 0;
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let side = |u: [f64; 3], v: [f64; 3]| {
            (u[0] - p[0]) * (v[2] - p[2]) - (u[2] - p[2]) * (v[0] - p[0])
        };
        let (x, y, z) = (side(b, c), side(c, a), side(a, b));
        if (x > 0.0) == (y > 0.0) && (y > 0.0) == (z > 0.0) {
            let at = (x * a[1] + y * b[1] + z * c[1]) / (x + y + z);
            if at > p[1] {
                count += if x + y + z > 0.0 { 1 } else { -1 };
            }
        }
    }
    count != 0
}

/// How far a point is from the nearest triangle.
fn distance(mesh: &Mesh, p: [f64; 3]) -> f64 {
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut least = f64::INFINITY;
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        // Into the plane if that is over the triangle, else to the nearest edge.
        let (e, f, q) = (sub(b, a), sub(c, a), sub(p, a));
        let (ee, ef, ff, qe, qf) = (dot(e, e), dot(e, f), dot(f, f), dot(q, e), dot(q, f));
        let d = ee * ff - ef * ef;
        let (s, u) = ((ff * qe - ef * qf) / d, (ee * qf - ef * qe) / d);
        if s >= 0.0 && u >= 0.0 && s + u <= 1.0 {
            let foot: [f64; 3] = std::array::from_fn(|i| q[i] - s * e[i] - u * f[i]);
            least = least.min(dot(foot, foot));
        }
        for (a, b) in [(a, b), (b, c), (c, a)] {
            let (e, q) = (sub(b, a), sub(p, a));
            let k = (dot(q, e) / dot(e, e)).clamp(0.0, 1.0);
            let foot: [f64; 3] = std::array::from_fn(|i| q[i] - k * e[i]);
            least = least.min(dot(foot, foot));
        }
    }
    least.sqrt()
}

/// What there is to complain about in a model: edges, and points of its region that the tracer sees
/// on the other side, farther from the surface than the tolerance.
fn faults(scene: &Scene, model: &Model, points: usize) -> Vec<String> {
    let mut solid = model.mesh.clone();
    solid.triangles.truncate(model.solid);
    solid.labels.truncate(model.solid);
    let mut out = Vec::new();
    if !solid.is_closed() {
        out.push("not closed".to_owned());
    }
    let region = model.extent.region;
    let root = scene.render.unwrap().root;
    let mut rng = Rng::new(7);
    let (mut held, mut wrong) = (0, 0);
    for _ in 0..points {
        let p: [f64; 3] = std::array::from_fn(|i| rng.range(region.min[i], region.max[i]));
        let inside = members(scene, root, Vec3(p)).unwrap().in_root;
        held += usize::from(inside);
        // Tolerances of operands add up at an edge: where two surfaces meet at an angle.
        if holds(&solid, p) != inside && distance(&solid, p) > 3.0 * model.extent.tolerance {
            wrong += 1;
            if wrong == 1 {
                out.push(format!("at {p:?} the scene says {inside}"));
            }
        }
    }
    if wrong > 0 {
        out.push(format!("{wrong} of {points} points are on the wrong side"));
    }
    // The volume, by another way: within four standard deviations and what the tolerance allows.
    let box_volume: f64 = (0..3).map(|i| region.max[i] - region.min[i]).product();
    let share = held as f64 / points as f64;
    let expected = (solid.volume() / box_volume).clamp(1.0 / points as f64, 0.5);
    let deviation = (expected / points as f64).sqrt();
    let error = (solid.volume() - share * box_volume).abs();
    if error > 4.0 * deviation * box_volume + area(&solid) * model.extent.tolerance {
        out.push(format!(
            "volume {} against {}",
            solid.volume(),
            share * box_volume
        ));
    }
    out
}

fn area(mesh: &Mesh) -> f64 {
    let of = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        let (e, f): ([f64; 3], [f64; 3]) = (
            std::array::from_fn(|i| b[i] - a[i]),
            std::array::from_fn(|i| c[i] - a[i]),
        );
        let n = [
            e[1] * f[2] - e[2] * f[1],
            e[2] * f[0] - e[0] * f[2],
            e[0] * f[1] - e[1] * f[0],
        ];
        (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt() / 2.0
    };
    (0..mesh.triangles.len()).map(of).sum()
}

fn gallery() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let mut out: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "zpg"))
        .collect();
    out.sort();
    out
}

#[test]
fn the_gallery_is_closed_and_in_its_place() {
    for path in gallery() {
        if !takes_part(&path.file_stem().unwrap().to_string_lossy(), 2) {
            continue;
        }
        // A thousand million balls are refused, not made.
        let many = path.file_stem().unwrap() == "billion";
        let loaded = loaded(&path);
        let tracer = tracer(&loaded.scene, path.parent().unwrap());
        let made = model(
            &loaded.scene,
            loaded.bounds(),
            &tracer.graph,
            &Options::default(),
        );
        assert_eq!(made.is_err(), many, "{}", path.display());
        let Ok(model) = made else { continue };
        let faults = faults(&loaded.scene, &model, cases(60, 200));
        assert!(faults.is_empty(), "{}: {faults:?}", path.display());
        let report = report("ply", &loaded.scene, &model, 0.0).to_string();
        assert!(!report.contains("failed") && !report.contains("not joined"));
    }
}

/// Every kind of shape and operation, moved, turned, stretched and mirrored.
#[test]
fn random_scenes_are_closed_and_in_their_place() {
    // More of them on request: MESH_SEEDS=0..1000.
    let (mut failed, mut reported, mut n) = (Vec::new(), 0, 0);
    for seed in seeds("MESH_SEEDS", 0..cases(8, 24)) {
        let loaded = Analysis::new("scene", scenes::scene(seed).into_bytes());
        let tracer = tracer(&loaded.scene, Path::new("."));
        let model = model(
            &loaded.scene,
            loaded.bounds(),
            &tracer.graph,
            &Options::default(),
        )
        .unwrap();
        let report = report("ply", &loaded.scene, &model, 0.0).to_string();
        n += 1;
        let own_up = report.contains("failed") || report.contains("not joined");
        reported += u32::from(own_up);
        let faults = faults(&loaded.scene, &model, 200);
        if !faults.is_empty() {
            failed.push(format!(
                "{seed}: {faults:?}{}",
                if own_up { " (said)" } else { "" }
            ));
        }
    }
    println!(
        "{n} scenes, {reported} with failed operations, {} wrong",
        failed.len()
    );
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
