//! `zpg convert` to meshes: the command, and the files it writes.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::support::program::{zpg, zpg_with};

/// A glass ball beside a box with a hole, under a triangle, and a coloured vase.
const SCENE: &str = "\
2 11  0 1 0  1
2 -201  0.1 0.1 0.8
2 -203  1.5 1.5 1.5
3 12  2 0 -1  4 2 1
3 -701  0.9 0.2 0.1
4 9  0.7
4 -1  3 2 0
5 -103  3 4
6 6  -1 3 0  4 3 0  1 4 0
7 2  3  0.5 0  1 1  0.2 2  1 0 0  0 1 0  0 0 1
7 -1  -3 0 0
8 -101  2 5
9 -101  8 6
10 -101  9 7
1 9999  10 0
";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thing.zpg"), SCENE).unwrap();
    folder
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Without `--to`, the ending of the name after `-o` says what it is to be; what was written is said.
#[test]
fn the_ending_says_what_it_is_to_be() {
    let folder = folder();
    for (name, begins) in [
        ("a.pov", &b"// "[..]),
        ("a.XML", b"<"),
        ("a.ply", b"ply"),
        ("a.obj", b"#"),
        ("a.glb", b"glTF"),
        ("a.stl", b"made by zpg"),
        ("a.json", b"{"),
        ("a.zpg", b""),
    ] {
        let output = zpg(folder.path(), &["convert", "thing.zpg", "-o", name]);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        let said = errors(&output);
        assert!(said.contains(&format!("Wrote {name}\n")), "{said}");
        let bytes = std::fs::read(folder.path().join(name)).expect("a file");
        assert!(bytes.starts_with(begins), "{name}");
        let quiet = zpg(
            folder.path(),
            &["convert", "thing.zpg", "-o", name, "-q", "--force"],
        );
        assert_eq!(errors(&quiet), "");
    }
    for arguments in [
        &["convert", "thing.zpg"][..],
        &["convert", "thing.zpg", "-o", "a.txt"],
    ] {
        let output = zpg(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(
            errors(&output).contains("which format?"),
            "{}",
            errors(&output)
        );
    }
}

#[test]
fn meshes_are_named_after_the_scene() {
    let folder = folder();
    for (format, files) in [
        ("ply", &["thing.ply"][..]),
        ("obj", &["thing.obj", "thing.mtl"]),
        ("glb", &["thing.glb"]),
        ("stl", &["thing.stl"]),
    ] {
        let output = zpg(folder.path(), &["convert", "thing.zpg", "--to", format]);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        assert!(output.stdout.is_empty());
        assert!(errors(&output).contains("approximate"));
        for file in files {
            assert!(folder.path().join(file).exists(), "{file}");
        }
    }
}

#[test]
fn a_scene_without_a_name_needs_one() {
    let folder = folder();
    let output = zpg_with(folder.path(), &["convert", "-", "--to", "ply"], SCENE);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("-o"), "{}", errors(&output));
    let named = ["convert", "-", "--to", "ply", "-o", "here.ply"];
    let output = zpg_with(folder.path(), &named, SCENE);
    assert_eq!(output.status.code(), Some(0));
    assert!(folder.path().join("here.ply").exists());
}

/// `-` is standard output, whose bytes are those of the file; also of a scene without a name. An OBJ is several files.
#[test]
fn meshes_go_to_standard_output() {
    let folder = folder();
    let convert = |scene, to, output, input| {
        let arguments = [
            "convert",
            scene,
            "--to",
            to,
            "--tolerance",
            "0.1",
            "-o",
            output,
        ];
        zpg_with(folder.path(), &arguments, input)
    };
    for (scene, input, format) in [
        ("thing.zpg", "", "ply"),
        ("thing.zpg", "", "glb"),
        ("-", SCENE, "stl"),
    ] {
        let output = convert(scene, format, "-", input);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        assert!(!errors(&output).contains("Wrote"), "{}", errors(&output));
        convert("thing.zpg", format, "a", "");
        assert_eq!(output.stdout, fs::read(folder.path().join("a")).unwrap());
    }
    let output = convert("thing.zpg", "obj", "-", "");
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    assert!(errors(&output).contains("several files"));
    assert!(!folder.path().join("-").exists());
}

/// Bytes that are no text would leave a terminal in a strange state.
#[cfg(target_os = "linux")]
#[test]
fn meshes_are_not_shown_on_a_terminal() {
    let folder = folder();
    let command = format!(
        "{} convert thing.zpg --to stl -o -",
        crate::support::program::PATH
    );
    let mut script = std::process::Command::new("script");
    let script = script
        .args(["-qec", &command, "/dev/null"])
        .env("LC_ALL", "C");
    let run = script.current_dir(folder.path()).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
    let said = String::from_utf8(run.stdout).unwrap();
    assert!(
        said.contains("the output is binary and not for a terminal"),
        "{said}"
    );
}

#[test]
fn tolerances_that_cannot_be() {
    let folder = folder();
    for wrong in ["0", "-1", "nan", "inf", "x"] {
        let tolerance = format!("--tolerance={wrong}");
        let output = zpg(
            folder.path(),
            &["convert", "thing.zpg", "--to", "ply", &tolerance],
        );
        assert_eq!(output.status.code(), Some(2), "{wrong}");
    }
    let fine = ["convert", "thing.zpg", "--to", "ply", "--tolerance", "1e-9"];
    let output = zpg(folder.path(), &fine);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        errors(&output).contains("--tolerance"),
        "{}",
        errors(&output)
    );
    assert!(!folder.path().join("thing.ply").exists());
    // More than there are numbers for.
    let beyond = ["convert", "thing.zpg", "--to", "ply", "--tolerance=1e-300"];
    let output = zpg(folder.path(), &beyond);
    assert_eq!(output.status.code(), Some(1));
    let said = errors(&output);
    assert!(said.contains("too small for the triangles"), "{said}");
    assert!(!said.contains("inf"), "{said}");
}

/// What a reader that knows nothing of us finds in the file.
#[test]
fn ply_reads_back_closed() {
    let folder = folder();
    zpg(
        folder.path(),
        &[
            "convert",
            "thing.zpg",
            "--to",
            "ply",
            "--tolerance",
            "0.002",
        ],
    );
    let bytes = fs::read(folder.path().join("thing.ply")).unwrap();
    let end = b"end_header\n";
    let start = bytes.windows(end.len()).position(|w| w == end).unwrap() + end.len();
    let header = std::str::from_utf8(&bytes[..start]).unwrap();
    let count = |element: &str| -> usize {
        let line = header
            .lines()
            .find_map(|l| l.strip_prefix(element))
            .unwrap();
        line.trim().parse().unwrap()
    };
    let (n, m) = (count("element vertex"), count("element face"));
    assert_eq!(bytes.len(), start + 27 * n + 16 * m);
    let float = |at: usize| f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()));
    let numbers =
        |i: usize, first: usize| [0, 1, 2].map(|k| float(start + 27 * i + 4 * (first + k)));
    let (point, normal) = (|i: usize| numbers(i, 0), |i: usize| numbers(i, 3));
    let faces = start + 27 * n;
    let corner = |f: usize, k: usize| {
        let at = faces + 16 * f + 1 + 4 * k;
        i32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
    };
    let mut edges = std::collections::HashMap::new();
    let mut volume = 0.0;
    for f in 0..m {
        assert_eq!(bytes[faces + 16 * f], 3);
        let corners = [0, 1, 2].map(|k| corner(f, k));
        let [p, q, r] = corners.map(point);
        // Where normals or colours differ there are several points in one place.
        let [a, b, c] = [p, q, r].map(|p| p.map(f64::to_bits));
        for edge in [(a, b), (b, c), (c, a)] {
            *edges.entry(edge).or_insert(0) += 1;
        }
        let flat: [f64; 3] = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            (q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j])
        });
        let length = flat.iter().map(|x| x * x).sum::<f64>().sqrt();
        for n in corners.map(normal) {
            // Facets are small: none is seen under more than a few degrees by its curved surface.
            let along: f64 = (0..3).map(|i| n[i] * flat[i]).sum();
            assert!(along > 0.98 * length, "{p:?} {n:?}");
            let unit = n.iter().map(|x| x * x).sum::<f64>();
            assert!((unit - 1.0).abs() < 1e-5);
        }
        volume += (p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]))
            / 6.0;
    }
    let open = edges
        .keys()
        .filter(|(a, b)| edges.get(&(*b, *a)) != Some(&1))
        .count();
    // The triangle alone is open.
    assert_eq!(open, 3);
    assert!(edges.values().all(|n| *n == 1));
    // Ball, box less half a ball, two frustums. The triangle's own cone from the origin: its plane
    // is z = 0.
    let pi = std::f64::consts::PI;
    let frustum = |a: f64, b: f64| pi / 3.0 * (a * a + a * b + b * b);
    let meant =
        4.0 / 3.0 * pi + 8.0 - 2.0 / 3.0 * pi * 0.343 + frustum(0.5, 1.0) + frustum(1.0, 0.2);
    // The surface is less than 60.
    assert!((volume - meant).abs() < 0.002 * 60.0, "{volume} {meant}");
}

#[test]
fn obj_uses_what_its_library_defines() {
    let folder = folder();
    zpg(
        folder.path(),
        &["convert", "thing.zpg", "--to", "obj", "-o", "a b.obj"],
    );
    let text = fs::read_to_string(folder.path().join("a b.obj")).unwrap();
    // A name without spaces, which end names in such files.
    let name = text.lines().find_map(|l| l.strip_prefix("mtllib "));
    let name = name.unwrap();
    assert!(name.starts_with("a_b_") && !name.contains(' '), "{name}");
    let library = fs::read_to_string(folder.path().join(name)).unwrap();
    let points = text.lines().filter(|l| l.starts_with("v ")).count();
    let normals = text.lines().filter(|l| l.starts_with("vn ")).count();
    let defined: Vec<&str> = library
        .lines()
        .filter_map(|l| l.strip_prefix("newmtl "))
        .collect();
    let used: BTreeSet<&str> = text
        .lines()
        .filter_map(|l| l.strip_prefix("usemtl "))
        .collect();
    assert_eq!(BTreeSet::from_iter(defined.iter().copied()), used);
    // Glass, red, the white triangle, and the vase with colours of its points.
    assert_eq!(defined.len(), 4);
    assert!(library.contains("Kd 0.9 0.2 0.1\n") && library.contains("Ni 1.5\n"));
    for face in text.lines().filter_map(|l| l.strip_prefix("f ")) {
        for corner in face.split(' ') {
            let mut indices = corner.split('/');
            let mut number = || indices.next().unwrap().parse::<usize>();
            assert!((1..=points).contains(&number().unwrap()), "{face}");
            // No picture, and a normal.
            assert!(number().is_err());
            assert!((1..=normals).contains(&number().unwrap()), "{face}");
        }
    }
}

/// Objects are called after the entities that their properties come from: a red ball, and a red box with a hole.
#[test]
fn obj_and_glb_have_the_names_of_the_scene() {
    let folder = folder();
    let scene = "\
2 11  0 1 0  1 # the moon #
2 -701  1 0 0
3 12  5 0 0  7 2 2
3 -701  1 0 0
4 12  6 1 -1  8 1.5 3
5 -103  3 4
6 -101  5 2
1 9999  6 0
";
    fs::write(folder.path().join("moon.zpg"), scene).unwrap();
    for format in ["obj", "glb"] {
        let output = zpg(folder.path(), &["convert", "moon.zpg", "--to", format]);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
    }
    let text = fs::read_to_string(folder.path().join("moon.obj")).unwrap();
    let (points, objects) = text.split_once("# sphere, the moon\no Object_2\n").unwrap();
    let (moon, block) = objects.split_once("# box\no Object_3\n").unwrap();
    let points: Vec<&str> = points
        .lines()
        .filter_map(|l| l.strip_prefix("v "))
        .collect();
    for (faces, held) in [(moon, -1.0..=1.0), (block, 5.0..=7.0)] {
        let mut lines = faces.lines();
        // They look alike.
        assert_eq!(lines.next(), Some("usemtl material_0"));
        for corner in lines.flat_map(|l| l.strip_prefix("f ").unwrap().split(' ')) {
            let point: usize = corner.split('/').next().unwrap().parse().unwrap();
            let x = points[point - 1].split(' ').next().unwrap();
            assert!(held.contains(&x.parse::<f64>().unwrap()), "{x}");
        }
    }
    let bytes = fs::read(folder.path().join("moon.glb")).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + word(12)]).unwrap();
    assert_eq!(json["scenes"][0]["nodes"], serde_json::json!([0, 1]));
    for (i, (name, comment, low, high)) in [
        (
            "Object_2",
            "sphere, the moon",
            [-1.0, 0.0, -1.0],
            [1.0, 2.0, 1.0],
        ),
        ("Object_3", "box", [5.0, 0.0, 0.0], [7.0, 2.0, 2.0]),
    ]
    .into_iter()
    .enumerate()
    {
        assert_eq!(json["nodes"][i]["name"], name);
        let mesh = &json["meshes"][json["nodes"][i]["mesh"].as_u64().unwrap() as usize];
        assert_eq!(mesh["name"], comment);
        let primitive = &mesh["primitives"][0];
        let accessor =
            |name: &serde_json::Value| &json["accessors"][name.as_u64().unwrap() as usize];
        let places = accessor(&primitive["attributes"]["POSITION"]);
        for (bound, expected) in [("min", low), ("max", high)] {
            for k in 0..3 {
                let off = places[bound][k].as_f64().unwrap() - expected[k];
                assert!(off.abs() < 0.01, "{name}: {places}");
            }
        }
        // Every triangle is in the box of its object: the indices count from its own first vertex.
        let start = |accessor: &serde_json::Value| {
            let view = accessor["bufferView"].as_u64().unwrap() as usize;
            let offset = |of: &serde_json::Value| of["byteOffset"].as_u64().unwrap() as usize;
            28 + word(12) + offset(&json["bufferViews"][view]) + offset(accessor)
        };
        let indices = accessor(&primitive["indices"]);
        for k in 0..indices["count"].as_u64().unwrap() as usize {
            let vertex = word(start(indices) + 4 * k);
            assert!(vertex < places["count"].as_u64().unwrap() as usize);
            let x = f32::from_bits(word(start(places) + 12 * vertex) as u32);
            assert!((low[0]..=high[0]).contains(&f64::from(x)), "{name}: {x}");
        }
    }
}

#[test]
fn obj_has_its_pictures() {
    let folder = folder();
    let board = "2 9 1\n3 -701 1 0 0\n4 -701 0 0 1\n2 -399 4 2 3 4\n1 9999 2 0\n";
    fs::write(folder.path().join("ball.zpg"), board).unwrap();
    let output = zpg(folder.path(), &["convert", "ball.zpg", "--to", "obj"]);
    assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
    let library = fs::read_to_string(folder.path().join("ball.mtl")).unwrap();
    let name = library.lines().find_map(|l| l.strip_prefix("map_Kd "));
    let picture = image::open(folder.path().join(name.unwrap())).unwrap();
    let picture = picture.into_rgb8();
    // Red below on the left, and repeated twice around and once upwards.
    assert_eq!(picture.dimensions(), (2, 2));
    assert_eq!(picture.get_pixel(0, 1).0, [255, 0, 0]);
    assert_eq!(picture.get_pixel(1, 1).0, [0, 0, 255]);
    let text = fs::read_to_string(folder.path().join("ball.obj")).unwrap();
    let row = |start: &str| -> Vec<Vec<f64>> {
        let lines = text.lines().filter_map(|l| l.strip_prefix(start));
        lines
            .map(|l| l.split(' ').map(|x| x.parse().unwrap()).collect())
            .collect()
    };
    let (points, places) = (row("v "), row("vt "));
    let mut seen = 0;
    for corner in text
        .lines()
        .filter_map(|l| l.strip_prefix("f "))
        .flat_map(|l| l.split(' '))
    {
        let numbers: Vec<usize> = corner.split('/').map(|x| x.parse().unwrap()).collect();
        let (p, uv) = (&points[numbers[0] - 1], &places[numbers[1] - 1]);
        if p[0].hypot(p[2]) < 0.1 {
            continue;
        }
        seen += 1;
        // The surface coordinates of the reference: v from the south pole upwards, twice 0 to ½.
        assert!((uv[1] - (-p[1]).clamp(-1.0, 1.0).acos() / std::f64::consts::PI).abs() < 2e-3);
        let turn = (-p[2]).atan2(p[0]) / std::f64::consts::TAU;
        let off = uv[0] / 2.0 - turn;
        assert!((off - off.round()).abs() < 2e-3, "{p:?} {uv:?}");
    }
    assert!(seen > 1000);
}

/// Nothing is written over a picture that the scene itself uses, whatever the target.
#[test]
fn pictures_of_the_scene_stay() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let picture = image::RgbImage::from_pixel(3, 1, image::Rgb([9, 8, 7]));
    picture.save(path("ball_texture_0.png")).unwrap();
    let before = fs::read(path("ball_texture_0.png")).unwrap();
    let ball = "2 9 1\n2 -301 ball_texture_0.png\n1 9999 2 0\n";
    fs::write(path("ball.zpg"), ball).unwrap();
    for arguments in [
        "--to obj",
        "--to obj -o ./ball.obj",
        "--to mitsuba -o ball.xml",
        "--to pov -o ball_texture_0.png",
        "--to json --report ball_texture_0.png",
    ] {
        let arguments = ["convert", "ball.zpg"]
            .into_iter()
            .chain(arguments.split(' '));
        let arguments: Vec<&str> = arguments.collect();
        let output = zpg(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{}", errors(&output));
        assert!(errors(&output).contains("ball_texture_0.png"));
        assert_eq!(fs::read(path("ball_texture_0.png")).unwrap(), before);
        assert!(!path("ball.obj").exists() && !path("ball.xml").exists());
    }
    let output = zpg(
        folder.path(),
        &["convert", "ball.zpg", "--to", "obj", "-o", "other.obj"],
    );
    assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
    let copy = image::open(path("other_texture_0.png")).unwrap();
    assert_eq!(copy.into_rgb8(), picture);
}

/// The validator of the Khronos group finds nothing to say.
#[test]
#[ignore = "needs the Khronos validator"]
fn glb_is_valid() {
    const VERSION: &str = "2.0.0-dev.3.10";
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap();
    let validator = target.join(format!(
        "gltf-validator-{VERSION}/node_modules/gltf-validator"
    ));
    assert!(
        validator.exists(),
        "{} is missing: this test runs the real validator; tests/run installs it",
        validator.display()
    );
    let folder = folder();
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let mut scenes = vec![folder.path().join("thing.zpg")];
    for entry in fs::read_dir(gallery).unwrap() {
        let path = entry.unwrap().path();
        // A thousand million balls are refused.
        if path.extension().is_some_and(|e| e == "zpg") && !path.ends_with("billion.zpg") {
            scenes.push(path);
        }
    }
    let empty = folder.path().join("empty.zpg");
    fs::write(
        &empty,
        "2 11 0 0 0 1\n3 11 5 0 0 1\n4 -102 2 3\n5 -501 0 0 8 0 0 -1 0 1 0 40\n6 -402 1\n6 -1 1 2 3\n1 9999 4 0\n",
    )
    .unwrap();
    scenes.push(empty);
    let mut files = Vec::new();
    for scene in scenes {
        let path = scene.to_str().unwrap();
        let output = zpg(folder.path(), &["convert", path, "--to", "glb"]);
        assert_eq!(output.status.code(), Some(0), "{path}: {}", errors(&output));
        let name = Path::new(scene.file_name().unwrap()).with_extension("glb");
        files.push(folder.path().join(name));
    }
    assert!(files.len() > 8);
    let script = "\
const validator = require(process.argv[1]), fs = require('fs');
(async () => { for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  const i = report.issues;
  if (i.numErrors + i.numWarnings) { console.log(file, JSON.stringify(i.messages)); process.exitCode = 1; }
} })();";
    let output = Command::new("node")
        .args(["-e", script])
        .arg(validator)
        .args(&files)
        .output()
        .expect("node runs: tests/run installs it");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", errors(&output));
}

#[test]
fn mitsuba_needs_a_place_for_meshes() {
    let folder = folder();
    let output = zpg(folder.path(), &["convert", "thing.zpg", "--to", "mitsuba"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        errors(&output).contains("-o scene.xml"),
        "{}",
        errors(&output)
    );
    let said = ["convert", "thing.zpg", "--to", "mitsuba", "-o", "to.xml"];
    assert_eq!(zpg(folder.path(), &said).status.code(), Some(0));
    let text = fs::read_to_string(folder.path().join("to.xml")).unwrap();
    let named: Vec<&str> = text.split('"').filter(|s| s.ends_with(".ply")).collect();
    assert!(!named.is_empty());
    for name in named {
        assert!(folder.path().join(name).exists(), "{name}");
    }
    // A ball alone fits on one sheet.
    let ball = "2 9 1\n1 9999 2 0\n";
    let output = zpg_with(folder.path(), &["convert", "-", "--to", "mitsuba"], ball);
    assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
    assert!(String::from_utf8_lossy(&output.stdout).contains("<shape type=\"sphere\""));
}

/// Triangles are small for the sake of a checkerboard only where the file shows it.
#[test]
fn what_has_no_colours_has_no_triangles_for_a_checkerboard() {
    let board =
        "2 5 -3 -3 3 3\n9 -501 0 5 5 0 -1 -1 0 1 0 45\n50 -402 1\n50 -1 0 9 0\n1 9999 2 0\n";
    let dir = crate::support::program::folder(&[
        ("plain.zpg", board),
        (
            "checked.zpg",
            &board.replace(
                "9 -501",
                "21 -701 1 1 1\n22 -701 0 0 0\n2 -399 8 8 21 22\n9 -501",
            ),
        ),
    ]);
    let size = |scene: &str, to: &str| {
        let output = zpg(dir.path(), &["convert", scene, "-o", to]);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        std::fs::metadata(dir.path().join(to)).unwrap().len()
    };
    assert_eq!(size("checked.zpg", "a.stl"), size("plain.zpg", "b.stl"));
    assert!(size("checked.zpg", "a.ply") > 4 * size("plain.zpg", "b.ply"));
}
