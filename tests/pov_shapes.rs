//! Every shape, bare and with every texture, in operations and transformed, in POV-Ray and in our
//! tracer.

use std::path::Path;

use crate::support;
use support::compare::compare;
use zpg::internals::analysis::Analysis;
use zpg::internals::study::compare::Comparison;

const SIZE: (u32, u32) = (96, 72);

/// A shape of each type and form, about 2 large around the origin.
const SHAPES: &[(&str, &str)] = &[
    (
        "lathe",
        "1 6  0.2 -1  1 -0.8  0.6 -0.1  0.6 0.3  1.1 0.5  0.5 1",
    ),
    ("lathe_to_axis", "1 4  0 -1  1 -0.2  0.7 0.4  0 1"),
    (
        "lathe_ring",
        "1 5  0.5 -0.6  1.2 -0.6  1.2 0.6  0.5 0.4  0.5 -0.6",
    ),
    (
        "lathe_crossing",
        "1 5  0.3 -1  1.2 0.5  0.3 0.5  1.1 -0.9  0.3 -1",
    ),
    ("lathe_cylinder", "1 2  0.8 -1  0.8 0.7"),
    (
        "lathe_coloured",
        "2 5  0.4 -1  1.1 -0.5  0.5 0.2  1 0.6  0.4 1  1 0 0  0 1 0  0 0 1  1 1 0  0 1 1",
    ),
    (
        "lathe_coloured_ring",
        "2 5  0.5 -0.6  1.2 -0.6  1.2 0.6  0.5 0.4  0.5 -0.6  1 0 0  0 1 0  0 0 1  1 1 0  1 0 1",
    ),
    ("plane", "3 0.3 1 0.2 0.4"),
    ("plane_flat", "3 0 -2 0 -1"),
    ("half_space", "4 0.3 2 0.5 0.4"),
    ("rectangle", "5 -1.5 -1 1.2 1.1"),
    ("triangle", "6 -1.2 -0.8 0.2  1.3 -0.6 -0.4  0.1 1.2 0.3"),
    (
        "triangle_normal",
        "7 -1.2 -0.8 0.2  1.3 -0.6 -0.4  0.1 1.2 0.3  0.2 0.5 1",
    ),
    (
        "triangle_normal_back",
        "7 -1.2 -0.8 0.2  1.3 -0.6 -0.4  0.1 1.2 0.3  0.2 -0.5 -1",
    ),
    (
        "triangle_normals",
        "8 -1.2 -0.8 0.2  1.3 -0.6 -0.4  0.1 1.2 0.3  -0.6 -0.3 0.7416  0.6 -0.3 0.7416  0.1 0.6 0.7937",
    ),
    (
        "triangle_normals_uneven",
        "8 -1.2 -0.8 0.2  1.3 -0.6 -0.4  0.1 1.2 0.3  -0.5 -0.3 1  1.5 -0.3 3  0.1 0.6 1",
    ),
    ("sphere_at_origin", "9 1.1"),
    ("ellipsoid", "10 1.3 0.7 0.9"),
    ("sphere", "11 0.2 0.1 -0.1 1.1"),
    ("box", "12 -1 -0.7 -0.6 0.8 0.9 0.7"),
    ("geodesic_0", "13 1.2 0"),
    ("geodesic_2", "13 1.2 2"),
    ("torus", "14 0.8 0.35"),
    ("torus_spindle", "14 0.4 0.8"),
    ("torus_horn", "14 0.6 0.6"),
    (
        "quadric",
        "15 1 0.3 0 0.1  0 1.5 0 0  0 0.2 0.8 0  0 0 0 -1",
    ),
    ("cone", "16 1.5 1"),
    ("cone_down", "16 -1.5 1"),
    ("double_cone", "17 1.1 0.9"),
    ("parabolic_cylinder", "18 0.8"),
    ("hyperbolic_cylinder", "19 0.5 0.9"),
    ("hyperboloid_one", "20 0.5 0.7 0.8 1"),
    ("hyperboloid_two", "20 0.6 0.5 0.7 2"),
    ("hyperbolic_paraboloid", "21 0.8 0.9"),
];

fn is_solid(record: &str) -> bool {
    let code: i32 = record.split_whitespace().next().unwrap().parse().unwrap();
    ![3, 5, 6, 7, 8].contains(&code)
}

/// The shape as object 20 with what changes it, drawn with a floor and cut down to a box.
fn scene(record: &str, changes: &str, root: u32) -> String {
    format!(
        "10 -701 0.9 0.3 0.1\n11 -701 0.2 0.5 0.9\n12 -701 0.3 0.3 0.35\n\
         20 {record}\n{changes}\n\
         30 3 0 1 0 1.9\n30 -701 0.6 0.7 0.4\n\
         31 -101 {root} 30\n\
         40 -401 0.2\n41 -402 0.7\n41 -1 3 5 4\n\
         50 -501  1.5 1.8 4.5  -1.4 -1.9 -4.5  0 1 0  40\n\
         1 9999 31 12  -3.5 -3.1 -3.7 3.3 3.4 3.9\n"
    )
}

fn check(name: &str, text: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let loaded = Analysis::new("scene.zpg", text.into());
    assert!(loaded.is_sound(), "{name}: {:?}\n{text}", loaded.findings());
    let outcomes = compare(name, &loaded.scene, &folder, SIZE);
    let bad = |c: &Comparison| {
        let wrong = c.differing.off_silhouettes;
        println!(
            "{name:>40}: {wrong} wrong, worst {:7.2}/255, {} differ on edges, {} total reflection",
            255.0 * c.difference.largest,
            c.differing.on_silhouettes,
            c.total_reflection
        );
        assert!(
            2 * (c.differing.on_silhouettes + c.total_reflection) < c.pixels,
            "{name}"
        );
        (c.differing.share_off_silhouettes > 0.0005).then(|| format!("{name}: {wrong} wrong"))
    };
    outcomes.iter().filter_map(bad).collect()
}

fn check_all(scenes: impl Iterator<Item = (String, String)>) {
    let only = std::env::var("POV_ONLY").unwrap_or_default();
    let bad: Vec<String> = scenes
        .filter(|(name, _)| name.contains(&only) && support::takes_part(name, 6))
        .flat_map(|(name, text)| check(&name, &text))
        .collect();
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
#[ignore = "needs POV-Ray"]
fn bare() {
    check_all(
        SHAPES
            .iter()
            .map(|(name, record)| (format!("bare_{name}"), scene(record, "20 -2 20 3", 20))),
    );
}

/// Assigned before one transformation and after another; a mirroring scale among them.
const MOVED: [&str; 2] = [
    "20 -2 25 1\n20 -3 -1 0.9 1.1",
    "20 -2 15 3\n20 -1 0.1 0.1 0",
];

fn textured(name: &'static str, texture: &'static str) -> impl Iterator<Item = (String, String)> {
    SHAPES.iter().map(move |(shape, record)| {
        let changes = format!("{}\n{texture}\n{}", MOVED[0], MOVED[1]);
        (format!("{name}_{shape}"), scene(record, &changes, 20))
    })
}

#[test]
#[ignore = "needs POV-Ray"]
fn with_a_checkerboard() {
    check_all(textured("checker", "20 -399 7 5 10 11"));
}

#[test]
#[ignore = "needs POV-Ray"]
fn with_an_image() {
    check_all(textured("image", "20 -301 moon.png"));
}

#[test]
#[ignore = "needs POV-Ray"]
fn with_a_solid_texture() {
    check_all(textured("solid", "20 -302 10 11 0.37"));
}

#[test]
#[ignore = "needs POV-Ray"]
fn transparent() {
    // Rays that come in where the render box cuts a solid open are another matter.
    let is_endless = |name: &str| {
        let endless = ["half_space", "parabolic_cylinder", "hyperbol"];
        endless.iter().any(|e| name.contains(e))
    };
    let clear = textured("clear", "20 -201 0.4 0.1 0.5");
    let glass = textured("glass", "20 -201 0.4 0.1 0.5\n20 -203 1.1 1.1 1.1")
        .filter(|(name, _)| !is_endless(name));
    check_all(clear.chain(glass));
}

#[test]
#[ignore = "needs POV-Ray"]
fn in_operations() {
    // A sphere less the shape, the shape less a box, the shape in a box, glass around the shape.
    let operations = [
        (
            "tool",
            "21 11 0.3 0.2 0.4 1.3\n21 -701 0.9 0.9 0.2\n22 -103 21 20\n",
        ),
        (
            "cut",
            "21 12 0.1 0.05 -0.3 3 3 3\n21 -701 0.9 0.2 0.9\n22 -103 20 21\n",
        ),
        (
            "part",
            "21 12 -0.9 -0.85 -0.7 0.8 0.75 0.9\n21 -701 0.9 0.2 0.9\n22 -102 20 21\n",
        ),
        (
            "complement",
            "21 -104 20\n23 11 0.3 0.2 0.4 1.4\n23 -399 8 6 10 12\n22 -102 23 21\n",
        ),
        (
            "in_glass",
            "21 12 -1.4 -1.2 -1.4 1.4 1.2 1.4\n21 -201 0.1 0 0.8\n21 -203 1.1 1.1 1.1\n22 -101 20 21\n",
        ),
    ];
    check_all(operations.iter().flat_map(|(name, records)| {
        SHAPES
            .iter()
            .filter(|(_, record)| is_solid(record) || *name == "part")
            .map(move |(shape, record)| {
                let changes = format!("20 -2 20 3\n20 -701 0.2 0.8 0.4\n{records}");
                (format!("{name}_{shape}"), scene(record, &changes, 22))
            })
    }));
}
