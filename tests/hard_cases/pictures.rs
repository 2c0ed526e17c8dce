//! Rows about light.

use super::ask::{Precision, Ray, Written, all_held, data};
use super::trace_support::Random;
use std::path::Path;

/// Renders a scene; linear RGB from the top row on.
fn render(scene: &Path, size: (usize, usize), precision: Precision) -> Vec<[f32; 3]> {
    let folder = tempfile::tempdir().unwrap();
    let (width, height) = size;
    let out = crate::support::program::command()
        .arg("render")
        .arg(scene)
        .args([
            "--samples",
            "1",
            "--size",
            &format!("{width}x{height}"),
            "-o",
            "out.pfm",
        ])
        .args(precision_option(precision))
        .current_dir(&folder)
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(0), "{errors}");
    let bytes = std::fs::read(folder.path().join("out.pfm")).unwrap();
    let floats = &bytes[bytes.len() - 12 * width * height..];
    let header = String::from_utf8_lossy(&bytes[..bytes.len() - floats.len()]).into_owned();
    assert!(
        header.starts_with("PF\n") && header.contains("-1"),
        "{header}"
    );
    let float = |b: &[u8]| f32::from_le_bytes(b.try_into().unwrap());
    let pixels: Vec<[f32; 3]> = floats
        .chunks(12)
        .map(|p| [float(&p[..4]), float(&p[4..8]), float(&p[8..])])
        .collect();
    // Portable float maps begin with the lowest row.
    pixels.chunks(width).rev().flatten().copied().collect()
}

/// Double precision is the default.
fn precision_option(precision: Precision) -> Vec<&'static str> {
    match precision {
        Precision::F64 => Vec::new(),
        _ => vec!["--precision", precision.name()],
    }
}

/// With a lamp at the camera everything in view is lit: what is black must be wrong.
pub fn row_24_box_above_a_plane(precision: Precision) {
    let scene = Written::new(
        "3 12 -1 -1 -1 1 1 1\n4 3 0 1 0 1.00007\n2 -101 3 4\n\
         5 -501 3 0.5 4  -3 -1 -4  0 1 0 45\n6 -402 1\n6 -1 3 0.5 4",
    );
    let pixels = render(&scene.path, (96, 72), precision);
    // Rays above the horizon see nothing; the camera looks down, so the lower half sees all.
    let lower = &pixels[96 * 36..];
    for (i, pixel) in lower.iter().enumerate() {
        assert!(pixel[0] > 0.01, "{} {i}: {pixel:?}", precision.name());
    }
}

/// From between the sheet and the receiver, 0.9e-3 apart: no light gets here, and without the
/// sheet it does.
pub fn row_25_sheet_above_a_receiver(precision: Precision) {
    let common = "4 3 0 1 0 0\n6 -402 1\n6 -1 0.25 5 0.125\n\
                  7 -501 -0.9 0.00045 0  1 -0.0005 0  0 1 0 0.01";
    let open = Written::new(&format!("{common}\n2 -105 4"));
    let covered = "3 5 -2 -2 2 2\n3 -2 -90 1\n3 -1 0 0.0009 0\n2 -101 3 4";
    let covered = Written::new(&format!("{common}\n{covered}"));
    let lit = render(&open.path, (16, 12), precision);
    assert!(lit.iter().all(|p| p[0] > 0.9), "{lit:?}");
    let dark = render(&covered.path, (16, 12), precision);
    assert!(dark.iter().all(|p| *p == [0.0; 3]), "{dark:?}");
}

/// The light's way cuts the edge x = z = 1 of a glass box: x + z = 2 − δ, a chord of δ√2. Every
/// one of the two surfaces lets half of it through. The receiver faces the light.
pub fn row_26_corner_of_a_glass_box(precision: Precision) {
    let delta = 6.26e-4 / 2f64.sqrt();
    let common = format!(
        "4 3 1 0 -1 {}\n5 -402 1\n5 -1 6 0 {}\n6 -501 {} 0 5  -1 0 1  0 1 0 1",
        10.0 + delta,
        -4.0 - delta,
        -3.0 - delta,
    );
    let open = Written::new(&format!("{common}\n2 -105 4"));
    let glass = "3 12 -1 -1 -1 1 1 1\n3 -201 0 0 0.5\n2 -101 3 4";
    let glass = Written::new(&format!("{common}\n{glass}"));
    let full = render(&open.path, (1, 1), precision)[0][0];
    let behind = render(&glass.path, (1, 1), precision)[0][0];
    assert!((full - 1.0).abs() < 1e-6, "{full}");
    assert!((behind - 0.25).abs() < 1e-6, "{behind}");
}

/// The union of two equal spheres costs what one costs, and looks the same.
pub fn row_32_equal_spheres_cost_nothing(precision: Precision) {
    let mut r = Random(32);
    let rays: Vec<Ray> = (0..100)
        .map(|_| {
            let ray = r.ray(3.0);
            Ray::new(ray.line.origin.0, ray.line.direction.0)
        })
        .collect();
    all_held(&data("equal-spheres.zpg"), &rays, precision);
    let camera = "5 -501 0 0 5  0 0 -1  0 1 0 30";
    let one = Written::new(&format!("2 11 0 0 0 1\n{camera}"));
    let two = Written::new(&format!("3 11 0 0 0 1\n4 11 0 0 0 1\n2 -101 3 4\n{camera}"));
    let tests = |scene: &Written| {
        let folder = tempfile::tempdir().unwrap();
        let out = crate::support::program::command()
            .arg("render")
            .arg(&scene.path)
            .args(["--samples", "1", "--size", "32x24", "-o", "out.png"])
            .args(["--stats", "stats.json"])
            .args(precision_option(precision))
            .current_dir(&folder)
            .output()
            .unwrap();
        assert!(out.status.success());
        let text = std::fs::read_to_string(folder.path().join("stats.json")).unwrap();
        let stats: serde_json::Value = serde_json::from_str(&text).unwrap();
        stats["intersections"]["shape"].as_u64().unwrap()
    };
    assert_eq!(tests(&one), tests(&two));
    let picture = |s: &Written| render(&s.path, (32, 24), precision);
    assert_eq!(picture(&one), picture(&two));
}
