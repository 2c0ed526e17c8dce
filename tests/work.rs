//! What `zpg render --stats` counts of each effect: nothing where the plan says that it is off, and
//! something where it shows.

use super::support::seeds;
use super::trace_support::{Builder, Random, optics, small};
use rayon::prelude::*;
use serde_json::Value;
use std::fs;
use std::path::Path;
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::{Geometry, NodeId, Paint, Scene, Texture, TriangleNormals};
use zpg::internals::solids::staging::selected_cameras;
use zpg::internals::trace::plan::Plan;
use zpg::internals::trace::stats::Counts;
use zpg::internals::trace::{Images, Numbers, Settings, Tracer};

/// Counters, and the effects that they are work of: where all of these are off the counter is zero.
const COUNTERS: [(&str, &[&str]); 14] = [
    ("shadow", &["shadows"]),
    ("transparent_shadow", &["transparent-shadows"]),
    ("reflection", &["reflection"]),
    ("refraction", &["refraction"]),
    ("channel_split", &["dispersion"]),
    ("uv", &["image-texture", "checkerboard"]),
    ("image_texture", &["image-texture"]),
    ("solid_texture", &["solid-texture"]),
    ("checkerboard", &["checkerboard"]),
    ("vertex_colour", &["vertex-colour"]),
    ("smooth_normal", &["smooth-normals"]),
    ("csg_merge", &["csg"]),
    ("clip", &["clip-box"]),
    ("medium_change", &["refraction"]),
];

/// Checks one picture; says which counters are above zero.
#[track_caller]
fn check(name: &str, work: &Value, effects: &[&str]) -> Vec<&'static str> {
    let counts = work.as_object().unwrap();
    assert_eq!(counts.len(), COUNTERS.len());
    let mut above = Vec::new();
    for (counter, of) in COUNTERS {
        let count = counts[counter].as_u64().unwrap();
        if of.iter().all(|e| !effects.contains(e)) {
            assert_eq!(count, 0, "{counter} in {name}");
        }
        if count > 0 {
            above.push(counter);
        }
    }
    above
}

fn counted(scene: &Scene, images: &Images, numbers: Numbers) -> (Counts, Vec<&'static str>) {
    let plan = Plan::of_picture(scene).unwrap();
    let effects = plan.names();
    let tracer = Tracer::planned(scene, images, plan).unwrap();
    let settings = Settings {
        numbers,
        ..small(40, 30)
    };
    let mut counts = Counts::default();
    for camera in selected_cameras(scene, 40.0 / 30.0) {
        counts += tracer.render(&camera, &settings, || ()).unwrap().counts;
    }
    (counts, effects)
}

/// The gallery shows all of its effects, each of which is counted.
#[test]
fn the_gallery_does_the_work_of_its_effects() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let mut paths: Vec<_> = fs::read_dir(&gallery)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "zpg"));
    paths.sort();
    let mut ever = Vec::new();
    for path in paths {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let loaded = Analysis::new(&name, fs::read(&path).unwrap());
        let images = Images::load(&loaded.scene, &gallery).unwrap_or_default();
        let (counts, effects) = counted(&loaded.scene, &images, Numbers::F64);
        let above = check(&name, &serde_json::to_value(counts.work).unwrap(), &effects);
        for (counter, of) in COUNTERS {
            // An index of 1 changes no medium; nothing else may be on and idle.
            let on = of.iter().any(|e| effects.contains(e));
            let idle = on && !above.contains(&counter) && counter != "medium_change";
            assert!(!idle, "{counter} in {name}");
        }
        ever.extend(above);
    }
    for (counter, _) in COUNTERS {
        assert!(ever.contains(&counter), "{counter}");
    }
}

/// One effect at a time, where it shows and where it nearly does, through the command line.
#[test]
fn each_effect_is_counted_where_it_shows() {
    let folder = tempfile::tempdir().unwrap();
    let work = |records: &str| -> Value {
        let head = "90 -501 0 0 9 0 0 -1 0 1 0 45\n91 -402 1\n91 -1 5 6 9\n80 -701 1 0 0\n81 -701 0 1 0\n\
                    2 11 0 0 0 1\n3 12 -4 -4 -3 4 4 -2\n";
        fs::write(folder.path().join("a.zpg"), format!("{head}{records}\n")).unwrap();
        let out = crate::support::program::command()
            .current_dir(folder.path())
            .args("render a.zpg -o a.pfm --size 40x30 --stats a.json".split(' '))
            .output()
            .unwrap();
        assert!(
            out.status.success(),
            "{}",
            String::from_utf8_lossy(&out.stderr)
        );
        let stats = fs::read(folder.path().join("a.json")).unwrap();
        let stats: Value = serde_json::from_slice(&stats).unwrap();
        let effects: Vec<&str> = stats["effects"]
            .as_array()
            .unwrap()
            .iter()
            .map(|e| e.as_str().unwrap())
            .collect();
        check(records, &stats["work"], &effects);
        for kind in ["shadow", "reflection", "refraction"] {
            assert_eq!(stats["work"][kind], stats["rays"][kind]);
        }
        stats["work"].clone()
    };
    let both = "4 -101 2 3\n1 9999 4 0";
    for (counter, on, off) in [
        (
            "shadow",
            both.to_owned(),
            "91 -701 0 0 0\n1 9999 2 0".into(),
        ),
        (
            "transparent_shadow",
            format!("2 -201 0.1 0 0.9\n{both}"),
            both.into(),
        ),
        (
            "reflection",
            format!("2 -201 0.5 0.5 0\n{both}"),
            both.into(),
        ),
        (
            "refraction",
            format!("2 -201 0.1 0 0.9\n{both}"),
            both.into(),
        ),
        (
            "channel_split",
            format!("2 -201 0.1 0 0.9\n2 -203 1.4 1.5 1.6\n{both}"),
            format!("2 -201 0.1 0 0.9\n2 -203 1.5 1.5 1.5\n{both}"),
        ),
        (
            "uv",
            format!("2 -399 4 4 80 81\n{both}"),
            format!("2 -302\n{both}"),
        ),
        (
            "checkerboard",
            format!("2 -399 4 4 80 81\n{both}"),
            format!("2 -302\n{both}"),
        ),
        // It does not show where nothing is diffuse.
        (
            "checkerboard",
            format!("3 -399 4 4 80 81\n{both}"),
            format!("3 -399 4 4 80 81\n3 -201 0 1 0\n{both}"),
        ),
        (
            "solid_texture",
            format!("2 -302\n{both}"),
            format!("2 -302\n2 -701 1 0 0\n{both}"),
        ),
        (
            "vertex_colour",
            "5 2 2 1 -1 1 1 1 0 0 0 1 0\n4 -101 5 3\n1 9999 4 0".into(),
            "5 2 2 1 -1 1 1 1 0 0 0 1 0\n5 -201 0 1 0\n4 -101 5 3\n1 9999 4 0".into(),
        ),
        (
            "smooth_normal",
            "5 7 -1 -1 1 1 -1 1 0 1 1 0.1 0 1\n4 -101 5 3\n1 9999 4 0".into(),
            "5 6 -1 -1 1 1 -1 1 0 1 1\n4 -101 5 3\n1 9999 4 0".into(),
        ),
        (
            "csg_merge",
            "5 11 0 0 -2 1\n4 -103 3 5\n1 9999 4 0".into(),
            both.into(),
        ),
        (
            "clip",
            format!("{both} 0 -9 -9 9 9 9"),
            format!("{both} -9 -9 -9 9 9 9"),
        ),
        (
            "medium_change",
            format!("2 -201 0.1 0 0.9\n2 -203 1.5 1.5 1.5\n{both}"),
            format!("2 -201 0.1 0 0.9\n{both}"),
        ),
    ] {
        assert!(
            work(&on)[counter].as_u64().unwrap() > 0,
            "{counter} in {on}"
        );
        assert_eq!(work(&off)[counter], 0, "{counter} in {off}");
    }
}

/// How often: on a mirror and a floor, of which each pixel shows one or the other or nothing.
#[test]
fn counts_are_those_of_the_picture() {
    let mut b = Builder::default();
    let wall = b.cuboid([-50.0, -50.0, -2.0], [50.0, 50.0, -1.0]);
    let wall = b.paint(
        wall,
        Paint {
            texture: Some(Texture::Checkerboard {
                n: 8,
                m: 8,
                colours: [[1.0; 3], [0.0; 3]],
            }),
            ..Paint::default()
        },
    );
    b.camera([0.0, 0.0, 9.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 45.0);
    b.light([0.0, 0.0, 9.0], 1.0);
    let (counts, _) = counted(&b.render(wall, [0.0; 3]), &Images::default(), Numbers::F64);
    // One colour for each pixel, and no shadow on the one side of a lone box.
    assert_eq!(counts.work.checkerboard, 40 * 30);
    assert_eq!(counts.work.uv, 40 * 30);
    assert_eq!((counts.work.shadow, counts.work.csg_merge), (0, 0));
}

fn random_scene(seed: u64) -> Scene {
    let mut r = Random(seed << 16);
    let mut b = Builder::default();
    let mut parts: Vec<NodeId> = Vec::new();
    for _ in 0..2 + r.below(4) {
        let [x, y, z] = r.point(1.5).0;
        let geometry = match r.below(5) {
            0 => Geometry::Box {
                min: [-0.7; 3],
                max: [0.7; 3],
            },
            1 => Geometry::Revolution {
                profile: vec![[0.8, -0.8], [0.4, 0.8]],
                colours: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 1.0]],
            },
            2 => Geometry::Triangle {
                vertices: Box::new([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]]),
                normals: match r.below(2) {
                    0 => TriangleNormals::Flat,
                    _ => TriangleNormals::One([0.2, 0.0, 1.0]),
                },
            },
            _ => Geometry::Sphere {
                centre: [0.0; 3],
                radius: 0.9,
            },
        };
        let mut part = b.shape(geometry);
        part = b.moved(part, Matrix::translation(x, y, z));
        for _ in 0..r.below(3) {
            let colours = [[0.9, 0.2, 0.1], [0.1, 0.3, 0.9]];
            let looks = [
                (1.0, 0.0, 0.0),
                (0.0, 1.0, 0.0),
                (0.0, 0.0, 1.0),
                (0.3, 0.3, 0.4),
            ];
            let (kd, ks, kt) = looks[r.below(4) as usize];
            let paint = Paint {
                owner: 0,
                texture: match r.below(4) {
                    0 => Some(Texture::Solid { colours, size: 0.4 }),
                    1 => Some(Texture::Checkerboard {
                        n: 5,
                        m: 5,
                        colours,
                    }),
                    2 => Some(Texture::Colour(colours[0])),
                    _ => None,
                },
                optics: (r.below(3) > 0).then(|| optics(kd, ks, kt)),
                index: match r.below(4) {
                    0 => Some([1.5; 3]),
                    1 => Some([1.4, 1.5, 1.6]),
                    _ => None,
                },
            };
            part = b.paint(part, paint);
        }
        parts.push(part);
    }
    let mut root = parts[0];
    for &part in &parts[1..] {
        root = match r.below(6) {
            0 => b.difference(root, part),
            1 => b.intersection(root, part),
            _ => b.union(root, part),
        };
    }
    if r.below(10) == 0 {
        root = b.complement(root);
    }
    let from = r.point(1.0).unit() * 8.0;
    b.camera(from.0, (-from).0, [0.1, 1.0, 0.2], 40.0);
    if r.below(4) > 0 {
        b.ambient(0.5);
    }
    if r.below(4) > 0 {
        b.light(r.point(6.0).0, 0.8);
    }
    let mut scene = b.render(root, [0.2; 3]);
    if r.below(3) == 0 {
        let side = r.within(0.5, 4.0);
        scene.render.as_mut().unwrap().clip = Some(([-side; 3], [side; 3]));
    }
    scene
}

#[test]
fn random_scenes_do_no_work_of_effects_that_are_off() {
    let above: Vec<Vec<&str>> = seeds("WORK_SEEDS", 0..1000)
        .into_par_iter()
        .map(|seed| {
            let scene = random_scene(seed);
            let numbers = if seed % 10 == 0 {
                Numbers::Dd
            } else {
                Numbers::F64
            };
            let (counts, effects) = counted(&scene, &Images::default(), numbers);
            let work = serde_json::to_value(counts.work).unwrap();
            check(&format!("seed {seed}"), &work, &effects)
        })
        .collect();
    // Each is met on, often enough.
    for (counter, _) in COUNTERS.iter().filter(|c| c.0 != "image_texture") {
        let scenes = above.iter().filter(|a| a.contains(counter)).count();
        assert!(scenes * 25 > above.len(), "{counter}: {scenes}");
    }
}
