//! Meshes far from the origin: their points as the files have them, held against the bounds that are reported.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::program::{folder, zpg};

type Point = [f64; 3];

/// What is in a file: points, and triangles of them.
struct Found {
    points: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    report: Value,
}

fn float(bytes: &[u8], at: usize) -> f64 {
    f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()))
}

fn word(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
}

fn read_ply(bytes: &[u8]) -> (Vec<Point>, Vec<[usize; 3]>) {
    let end = b"end_header\n";
    let start = bytes.windows(end.len()).position(|w| w == end).unwrap() + end.len();
    let header = std::str::from_utf8(&bytes[..start]).unwrap();
    let count = |element: &str| -> usize {
        let line = header.lines().find_map(|l| l.strip_prefix(element));
        line.unwrap().trim().parse().unwrap()
    };
    let (n, m) = (count("element vertex"), count("element face"));
    let faces = start + 27 * n;
    (
        (0..n)
            .map(|i| [0, 1, 2].map(|k| float(bytes, start + 27 * i + 4 * k)))
            .collect(),
        (0..m)
            .map(|i| [0, 1, 2].map(|k| word(bytes, faces + 16 * i + 1 + 4 * k)))
            .collect(),
    )
}

/// Of one object.
fn read_glb(bytes: &[u8]) -> (Vec<Point>, Vec<[usize; 3]>) {
    let json: Value = serde_json::from_slice(&bytes[20..20 + word(bytes, 12)]).unwrap();
    let primitive = &json["meshes"][0]["primitives"][0];
    let of = |number: &Value| {
        let accessor = &json["accessors"][number.as_u64().unwrap() as usize];
        let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let offset = |of: &Value| of["byteOffset"].as_u64().unwrap() as usize;
        let start = 28 + word(bytes, 12) + offset(view) + offset(accessor);
        (
            start,
            accessor["count"].as_u64().unwrap() as usize,
            accessor,
        )
    };
    let (start, n, accessor) = of(&primitive["attributes"]["POSITION"]);
    let points: Vec<Point> = (0..n)
        .map(|i| [0, 1, 2].map(|k| float(bytes, start + 12 * i + 4 * k)))
        .collect();
    for k in 0..3 {
        let all = || points.iter().map(|p| p[k]);
        assert_eq!(accessor["min"][k], all().fold(f64::INFINITY, f64::min));
        assert_eq!(accessor["max"][k], all().fold(f64::NEG_INFINITY, f64::max));
    }
    let (start, m, _) = of(&primitive["indices"]);
    let index = |i: usize| word(bytes, start + 4 * i);
    let triangles = (0..m / 3).map(|i| [0, 1, 2].map(|k| index(3 * i + k)));
    (points, triangles.collect())
}

/// Points are written anew for each triangle; those in one place are one point.
fn read_stl(bytes: &[u8]) -> (Vec<Point>, Vec<[usize; 3]>) {
    assert!(!bytes.starts_with(b"solid"));
    let count = word(bytes, 80);
    assert_eq!(bytes.len(), 84 + 50 * count);
    let mut points: Vec<Point> = Vec::new();
    let mut known = HashMap::new();
    let triangles = (0..count).map(|i| {
        let three = |k: usize| [0, 1, 2].map(|n| float(bytes, 84 + 50 * i + 12 * k + 4 * n));
        let [normal, a, b, c] = [0, 1, 2, 3].map(three);
        // The normal is a unit vector, at right angles to two sides, and points out: to where the corners go round
        // counter-clockwise.
        let side = |p: Point| [0, 1, 2].map(|n| p[n] - a[n]);
        let (u, v) = (side(b), side(c));
        let cross = [0, 1, 2].map(|n| {
            let (i, j) = ((n + 1) % 3, (n + 2) % 3);
            u[i] * v[j] - u[j] * v[i]
        });
        let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
        let along: f64 = (0..3).map(|n| normal[n] * cross[n]).sum();
        assert!(along >= length * (1.0 - 1e-6), "{normal:?} {cross:?}");
        [a, b, c].map(|p| {
            let number = known.entry(p.map(f64::to_bits)).or_insert(points.len());
            if *number == points.len() {
                points.push(p);
            }
            *number
        })
    });
    let triangles = triangles.collect();
    (points, triangles)
}

fn read_obj(bytes: &[u8]) -> (Vec<Point>, Vec<[usize; 3]>) {
    let text = std::str::from_utf8(bytes).unwrap();
    let rows = |start: &'static str| text.lines().filter_map(move |l| l.strip_prefix(start));
    let three = |line: &'_ str, read: fn(&str) -> f64| {
        let numbers: Vec<f64> = line.split(' ').take(3).map(read).collect();
        [numbers[0], numbers[1], numbers[2]]
    };
    let point = |line| three(line, |x| x.parse().unwrap());
    let corner = |c: &str| c.split('/').next().unwrap().parse().unwrap();
    (
        rows("v ").map(point).collect(),
        rows("f ")
            .map(|line| three(line, corner).map(|i| i as usize - 1))
            .collect(),
    )
}

fn converted(folder: &Path, to: &str, scene: &str, more: &[&str]) -> Found {
    fs::write(folder.join("a.zpg"), scene).unwrap();
    let file = format!("a.{to}");
    let arguments = [
        "convert", "a.zpg", "--to", to, "-o", &file, "--report", "r.json",
    ];
    let run = zpg(folder, &[&arguments[..], more].concat());
    assert_eq!(run.status.code(), Some(0), "{run:?}");
    let bytes = fs::read(folder.join(file)).unwrap();
    let (points, triangles) = match to {
        "ply" => read_ply(&bytes),
        "glb" => read_glb(&bytes),
        "stl" => read_stl(&bytes),
        _ => read_obj(&bytes),
    };
    Found {
        points,
        triangles,
        report: serde_json::from_slice(&fs::read(folder.join("r.json")).unwrap()).unwrap(),
    }
}

impl Found {
    /// The bound that is reported of a feature; `None` if it is exact or not there.
    fn bound(&self, feature: &str) -> Option<f64> {
        let all = self.report["features"].as_array().unwrap();
        let found = all.iter().find(|f| f["feature"] == feature)?;
        let bound = found["bound"].as_str()?.strip_prefix("within ")?;
        Some(bound.parse().unwrap())
    }

    /// How far triangles are from a ball's surface, at their corners, their middles and those of their edges.
    fn off(&self, centre: Point, radius: f64) -> f64 {
        let mut worst = 0.0f64;
        for t in &self.triangles {
            let corners = t.map(|i| [0, 1, 2].map(|k| self.points[i][k] - centre[k]));
            for weights in [
                [1.0, 0.0, 0.0],
                [0.5, 0.5, 0.0],
                [0.0, 0.5, 0.5],
                [0.5, 0.0, 0.5],
                [1.0 / 3.0; 3],
            ] {
                let p = [0, 1, 2].map(|k| (0..3).map(|c| weights[c] * corners[c][k]).sum::<f64>());
                let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
                worst = worst.max((length - radius).abs());
            }
        }
        worst
    }
}

const TARGETS: [&str; 4] = ["ply", "glb", "obj", "stl"];

#[test]
fn the_bound_holds_at_any_distance() {
    let dir = folder::<&str>(&[]);
    for to in TARGETS {
        for far in [0.0, 1e3, 1e5, 1e6, 1e8, 1e12, 1e16] {
            for (centre, scene) in [
                ([far, 0.0, 0.0], format!("2 11 {far} 0 0 1\n1 9999 2 0\n")),
                (
                    [-far, 3.0, far],
                    format!("2 9 1\n2 -1 {} 3 {far}\n1 9999 2 0\n", -far),
                ),
            ] {
                let found = converted(dir.path(), to, &scene, &[]);
                let feature = ["sphere", "sphere at the origin"].map(|f| found.bound(f));
                let bound = feature.into_iter().flatten().next().unwrap();
                let off = found.off(centre, 1.0);
                // The bound is printed to four digits.
                assert!(off <= bound * 1.001, "{to} {scene}: {off} {bound}");
                // It is no worse than it has to be: what is asked for, and what the numbers cost.
                let tolerance = 1e-3 * 3f64.sqrt();
                let step = match to {
                    "obj" => 2f64.powi(-52),
                    _ => 2f64.powi(-24),
                };
                let numbers = 2.0 * step * (far + 3.0) + 2f64.powi(-51) * far;
                assert!(bound <= 1.02 * tolerance + numbers, "{to} {scene}: {bound}");
                let named = found.bound("coordinates");
                assert_eq!(named.is_some(), bound > 2.001 * tolerance, "{to} {scene}");
            }
        }
    }
}

/// Also where the tolerance is said, and asks for more than single precision has.
#[test]
fn the_tolerance_is_kept_by_digits() {
    let dir = folder::<&str>(&[]);
    for (far, tolerance) in [(1e8, "1e-3"), (1e6, "1e-4"), (1e3, "1e-5")] {
        let scene = format!("2 11 {far} {far} 0 1\n1 9999 2 0\n");
        let found = converted(dir.path(), "obj", &scene, &["--tolerance", tolerance]);
        let off = found.off([far, far, 0.0], 1.0);
        let bound: f64 = tolerance.parse().unwrap();
        assert!(off <= 1.01 * bound, "{scene}: {off}");
        assert_eq!(found.bound("coordinates"), None);
        let longest = found.points.len();
        let mut different: Vec<[u64; 3]> =
            found.points.iter().map(|p| p.map(f64::to_bits)).collect();
        different.sort_unstable();
        different.dedup();
        assert_eq!(different.len(), longest, "points fell together");
    }
}

/// What has flat faces is exact only as long as its corners are.
#[test]
fn corners_are_exact_where_numbers_are() {
    let dir = folder::<&str>(&[]);
    for (corner, to, is_exact) in [
        ("0.1", "ply", true),
        ("0.1", "obj", true),
        ("100000000", "glb", true),
        ("100000001", "glb", false),
        ("100000000.3", "ply", false),
        ("100000000.3", "obj", true),
    ] {
        let scene = format!("2 12 {corner} 0 0 100000008 1 1\n1 9999 2 0\n");
        let found = converted(dir.path(), to, &scene, &["--tolerance", "0.01"]);
        let bound = found.bound("box");
        assert_eq!(bound.is_none(), is_exact, "{corner} {to}");
        let x: f64 = corner.parse().unwrap();
        let least = found
            .points
            .iter()
            .map(|p| p[0])
            .fold(f64::INFINITY, f64::min);
        assert!(
            (least - x).abs() <= bound.unwrap_or(1e-4),
            "{corner} {to}: {least}"
        );
    }
}
