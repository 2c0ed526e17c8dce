//! Cameras and lights of a glb, as programs read them.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::program::zpg;

/// What is in the JSON of a scene's glb.
fn converted(folder: &Path, scene: &Path) -> Value {
    let glb = folder.join("out.glb");
    let path = scene.to_str().unwrap();
    let to = [
        "convert",
        path,
        "--to",
        "glb",
        "--tolerance",
        "0.1",
        "-o",
        "out.glb",
    ];
    let run = zpg(folder, &to);
    assert!(
        run.status.success(),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
    let bytes = fs::read(glb).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    let all = value.as_array().unwrap().iter();
    all.map(|x| x.as_f64().unwrap()).collect()
}

fn near(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len()
        && a.iter()
            .zip(b)
            .all(|(a, b)| (a - b).abs() < 1e-6 * b.abs().max(1.0))
}

/// The ray of a camera through a place of a picture of 4 : 3, from −1 to 1: the definition of glTF 2.0, 3.10.
fn ray(file: &Value, camera: usize, x: f64, y: f64) -> [Vec<f64>; 2] {
    let nodes = file["nodes"].as_array().unwrap();
    let node = nodes.iter().find(|n| n["camera"] == camera).unwrap();
    let matrix = numbers(&node["matrix"]);
    let at = |[a, b, c]: [f64; 3], w: f64| -> Vec<f64> {
        (0..3)
            .map(|i| matrix[i] * a + matrix[4 + i] * b + matrix[8 + i] * c + matrix[12 + i] * w)
            .collect()
    };
    let camera = &file["cameras"][camera];
    let of = |kind: &str, name: &str| camera[kind][name].as_f64();
    if camera["type"] == "perspective" {
        let up = (of("perspective", "yfov").unwrap() / 2.0).tan();
        let across = up * of("perspective", "aspectRatio").unwrap_or(4.0 / 3.0);
        let long = (x * across).hypot(y * up).hypot(1.0);
        return [
            at([0.0; 3], 1.0),
            at([x * across / long, y * up / long, -1.0 / long], 0.0),
        ];
    }
    let [across, up] = ["xmag", "ymag"].map(|name| of("orthographic", name).unwrap());
    [
        at([x * across, y * up, 0.0], 1.0),
        at([0.0, 0.0, -1.0], 0.0),
    ]
}

#[test]
fn cameras_have_our_rays() {
    let dir = tempfile::tempdir().unwrap();
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    // A camera; a pair, of which `probe` takes the left one; a projection matrix of parallel rays.
    for (name, cameras) in [("pawns", 1), ("chain", 2), ("bracket", 1)] {
        let scene = gallery.join(name).with_extension("zpg");
        let file = converted(dir.path(), &scene);
        assert_eq!(file["cameras"].as_array().unwrap().len(), cameras, "{name}");
        let path = scene.to_str().unwrap();
        for (column, row) in [(320, 240), (480, 120), (10, 400)] {
            let pixel = format!("{column},{row}");
            let run = zpg(
                dir.path(),
                &["probe", path, "--size", "640x480", "--pixel", &pixel],
            );
            let first = run.stdout.split(|b| *b == b'\n').next().unwrap();
            let said: Value = serde_json::from_slice(first).unwrap();
            let x = 2.0 * (f64::from(column) + 0.5) / 640.0 - 1.0;
            let y = 1.0 - 2.0 * (f64::from(row) + 0.5) / 480.0;
            for (ours, name) in ray(&file, 0, x, y).iter().zip(["origin", "direction"]) {
                let theirs = numbers(&said["ray"][name]);
                assert!(
                    near(ours, &theirs),
                    "{path} {pixel}: {name} {ours:?} {theirs:?}"
                );
            }
        }
    }
}

/// The camera that takes the picture comes first, and a camera of askew rays is left out, as the report says.
#[test]
fn lights_and_several_cameras() {
    let dir = tempfile::tempdir().unwrap();
    let scene = dir.path().join("a.zpg");
    let text = "2 12 -1 -1 -1 1 1 1\n\
        5 -501 0 0 8 0 0 -1 0 1 0 40\n6 -501 8 0 0 -1 0 0 0 1 0 30 # from the right #\n7 -502 6\n\
        8 -402 0.5 # lamp #\n8 -701 1 0.5 0\n8 -1 3 4 0\n9 -401 0.2\n1 9999 2 0\n";
    fs::write(&scene, text).unwrap();
    let file = converted(dir.path(), &scene);
    let names: Vec<&str> = file["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|n| n["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["Object_2", "Camera_6", "Camera_5", "Light_8"]);
    assert_eq!(file["scenes"][0]["nodes"], serde_json::json!([0, 1, 2, 3]));
    assert_eq!(file["cameras"][0]["name"], "from the right");
    let angle = file["cameras"][0]["perspective"]["yfov"].as_f64().unwrap();
    assert!((angle - std::f64::consts::PI / 6.0).abs() < 1e-12);
    let light = &file["extensions"]["KHR_lights_punctual"]["lights"][0];
    assert_eq!(
        (&light["type"], &light["name"]),
        (&"point".into(), &"lamp".into())
    );
    assert_eq!(numbers(&light["color"]), [1.0, 0.5, 0.0]);
    // 5 from the middle: π · 0.5 · 25 candela are as bright there.
    let candela = light["intensity"].as_f64().unwrap();
    assert!(
        (candela - std::f64::consts::PI * 12.5).abs() < 1e-9,
        "{candela}"
    );
    assert_eq!(numbers(&file["nodes"][3]["translation"]), [3.0, 4.0, 0.0]);
    assert_eq!(
        file["extensionsUsed"],
        serde_json::json!(["KHR_lights_punctual"])
    );
    // An askew frustum.
    let askew = "2 9 1\n7 -501 0 0 8 0 0 -1 0 1 0 40\n7 -99 1.25 0 0.5 0 0 1.6666 -0.3333 0 \
        0 0 -1.01 -1.005 0 0 -1 0\n1 9999 2 0\n";
    fs::write(&scene, askew).unwrap();
    assert_eq!(converted(dir.path(), &scene)["cameras"], Value::Null);
    let run = zpg(dir.path(), &["convert", "a.zpg", "--to", "glb"]);
    let report = String::from_utf8(run.stderr).unwrap();
    assert!(
        report.contains("dropped      projection matrix: glTF has none that look askew"),
        "{report}"
    );
}
