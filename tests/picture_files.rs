//! Picture files of every form: what zpg draws of them, and that POV-Ray and Mitsuba draw the same.

mod forms;

use std::fs;
use std::path::Path;

use jpeg_encoder::{ColorType, Encoder, SamplingFactor};

use self::forms::{File, files};
use crate::support::picture_file::SIZE;
use crate::support::{mitsuba, program};
use zpg::internals::analysis::Analysis;
use zpg::internals::diagnostics::Code;
use zpg::internals::solids::staging::Viewpoint;
use zpg::internals::trace::{Images, Settings, Tracer, selected_camera};
use zpg::internals::translate::mitsuba::{Integrator, Options, write};

/// The scene shows so many pictures side by side.
const COLUMNS: usize = 12;

/// A scene of all files in a folder, each on a rectangle of its own, in ambient light alone.
fn scene(folder: &Path, files: &[File]) -> String {
    let mut text = String::new();
    for (i, file) in files.iter().enumerate() {
        let path = folder.join(&file.name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, &file.bytes).unwrap();
        let (x, y) = (i % COLUMNS, i / COLUMNS);
        let (right, up) = (x as f64 + 0.9, y as f64 + 0.9);
        let id = i + 2;
        text += &format!(
            "{id} 5 {x} {y} {right} {up}\n{id} -301 \"{}\"\n{id} -201 1 0 0\n",
            file.name
        );
    }
    let mut root = 2;
    for i in 1..files.len() {
        text += &format!("{} -101 {root} {}\n", 1000 + i, i + 2);
        root = 1000 + i;
    }
    let rows = files.len().div_ceil(COLUMNS) as f64;
    let middle = [COLUMNS as f64 / 2.0, rows / 2.0];
    text + &format!(
        "5000 -501 {} {} 20 0 0 -1 0 1 0 34\n5001 -401 1\n1 9999 {root} 0\n",
        middle[0], middle[1]
    )
}

/// At the middle of each texel zpg shows what the file was made of.
#[test]
fn zpg_shows_what_was_stored() {
    let folder = tempfile::tempdir().unwrap();
    let files = files();
    assert!(files.len() > 90);
    let loaded = Analysis::new("scene", scene(folder.path(), &files).into_bytes());
    assert!(loaded.is_sound(), "{:?}", loaded.findings());
    let images = Images::load(&loaded.scene, folder.path()).unwrap();
    let encoded = |x: f64| match x <= 0.003_130_8 {
        true => 12.92 * x * 255.0,
        false => (1.055 * x.powf(1.0 / 2.4) - 0.055) * 255.0,
    };
    for file in &files {
        let bitmap = images.get(&file.name).unwrap();
        let [width, height] = SIZE.map(|n| n as f64);
        for (i, expected) in file.shown.iter().enumerate() {
            let (x, y) = ((i % SIZE[0]) as f64, (i / SIZE[0]) as f64);
            let shown = bitmap.colour([(x + 0.5) / width, 1.0 - (y + 0.5) / height]);
            let shown = shown.map(encoded);
            for c in 0..3 {
                let off = (shown[c] - expected[c]).abs();
                assert!(
                    off < file.most,
                    "{}: {shown:?}, not {expected:?}",
                    file.name
                );
            }
        }
    }
}

/// A JPEG is shown as its camera was held. Exif says on which side of the upright picture the file's first row and its
/// first column are; so that is how the files are made.
#[test]
fn jpegs_are_upright() {
    #[derive(Clone, Copy)]
    enum Side {
        Top,
        Bottom,
        Left,
        Right,
    }
    use Side::{Bottom, Left, Right, Top};
    let sides = [
        (Top, Left),
        (Top, Right),
        (Bottom, Right),
        (Bottom, Left),
        (Left, Top),
        (Right, Top),
        (Right, Bottom),
        (Left, Bottom),
    ];
    let [width, height] = SIZE;
    let grey = |x: usize, y: usize| (40 + 12 * x + 5 * y) as u8;
    // How far a pixel of the upright picture is from a side.
    let from = |side, x: usize, y: usize| match side {
        Top => y,
        Bottom => height - 1 - y,
        Left => x,
        Right => width - 1 - x,
    };
    let folder = tempfile::tempdir().unwrap();
    let loaded = Analysis::new("scene", b"2 5 0 0 1 1\n2 -301 p.jpg\n1 9999 2 0\n".to_vec());
    for (number, (first_row, first_column)) in (1u8..).zip(sides) {
        let turned = matches!(first_row, Left | Right);
        let stored = if turned {
            [height, width]
        } else {
            [width, height]
        };
        let mut data = vec![0; width * height];
        for y in 0..height {
            for x in 0..width {
                let (row, column) = (from(first_row, x, y), from(first_column, x, y));
                data[row * stored[0] + column] = grey(x, y);
            }
        }
        // Both orders of bytes that TIFF has: a tag of 16 bits with one number of 16 bits.
        let large = [
            &b"MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"[..],
            &[number],
            &[0; 6],
        ];
        let small = [
            &b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0"[..],
            &[number],
            &[0; 7],
        ];
        for exif in [large.concat(), small.concat()] {
            let mut bytes = Vec::new();
            let mut encoder = Encoder::new(&mut bytes, 100);
            encoder.add_exif_metadata(&exif).unwrap();
            let [columns, rows] = stored.map(|n| n as u16);
            encoder
                .encode(&data, columns, rows, ColorType::Luma)
                .unwrap();
            fs::write(folder.path().join("p.jpg"), &bytes).unwrap();
            let images = Images::load(&loaded.scene, folder.path()).unwrap();
            let bitmap = images.get("p.jpg").unwrap();
            for y in 0..height {
                for x in 0..width {
                    let (u, v) = (x as f64 + 0.5, y as f64 + 0.5);
                    let shown = bitmap.colour([u / width as f64, 1.0 - v / height as f64])[1];
                    let shown = (1.055 * shown.powf(1.0 / 2.4) - 0.055) * 255.0;
                    let expected = f64::from(grey(x, y));
                    assert!(
                        (shown - expected).abs() < 3.0,
                        "{number}: {x} {y}: {shown} {expected}"
                    );
                }
            }
        }
    }
}

/// What would be drawn wrong is refused.
#[test]
fn jpegs_whose_first_component_is_coarser_are_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let [width, height] = SIZE.map(|n| n as u16);
    let data = vec![100; 4 * SIZE[0] * SIZE[1]];
    for (sampling, read) in [
        (SamplingFactor::F_1_1, true),
        (SamplingFactor::F_2_2, false),
    ] {
        for progressive in [false, true] {
            let mut bytes = Vec::new();
            let mut encoder = Encoder::new(&mut bytes, 100);
            encoder.set_sampling_factor(sampling);
            encoder.set_progressive(progressive);
            encoder
                .encode(&data, width, height, ColorType::Cmyk)
                .unwrap();
            fs::write(folder.path().join("p.jpg"), &bytes).unwrap();
            let text = "2 5 0 0 1 1\n2 -301 p.jpg\n1 9999 2 0\n";
            let loaded = Analysis::new("scene", text.as_bytes().to_vec());
            assert_eq!(Images::load(&loaded.scene, folder.path()).is_ok(), read);
        }
    }
}

const VIEW: (u32, u32) = (360, 300);

#[test]
#[ignore = "needs POV-Ray"]
fn povray_draws_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let text = scene(folder.path(), &files());
    for name in ["škola s mezerou.zpg", "a.zpg"] {
        fs::write(folder.path().join(name), &text).unwrap();
        let size = format!("{}x{}", VIEW.0, VIEW.1);
        let args = [
            "crosscheck",
            name,
            "--with",
            "povray",
            "--size",
            &size,
            "--json",
            "-o",
            "out",
        ];
        let run = program::zpg(folder.path(), &args);
        let said = String::from_utf8_lossy(&run.stderr);
        assert_eq!(
            run.status.code(),
            Some(0),
            "{said}{}",
            String::from_utf8_lossy(&run.stdout)
        );
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        let picture = &json["pictures"][0];
        assert_eq!(picture["differing"]["off_silhouettes"], 0, "{picture}");
        assert!(
            picture["difference"]["largest"].as_f64().unwrap() < 0.5 / 255.0,
            "{picture}"
        );
        // Not all of it is black.
        assert!(
            image::open(folder.path().join("out/theirs.png"))
                .unwrap()
                .into_rgb8()
                .pixels()
                .filter(|p| p.0 != [0; 3])
                .count()
                > 30_000
        );
        if name == "a.zpg" {
            continue;
        }
        // The translation holds what it needs.
        fs::create_dir(folder.path().join("away")).unwrap();
        let args = [
            "convert",
            name,
            "--to",
            "pov",
            "-o",
            "away/čau.pov",
            "--verbose",
        ];
        let run = program::zpg(folder.path(), &args);
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(said.contains("exact        image texture"), "{said}");
        let pov = fs::read_to_string(folder.path().join("away/čau.pov")).unwrap();
        fs::write(folder.path().join("away/b.pov"), pov).unwrap();
        let run = std::process::Command::new("povray")
            .args(["+Ib.pov", "+Ob.png", "+W36", "+H30", "-D"])
            .current_dir(folder.path().join("away"))
            .output()
            .unwrap();
        assert!(
            run.status.success(),
            "{}",
            String::from_utf8_lossy(&run.stderr)
        );
    }
}

#[test]
#[ignore = "needs Mitsuba"]
fn mitsuba_draws_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let loaded = Analysis::new("scene", scene(folder.path(), &files()).into_bytes());
    let images = Images::load(&loaded.scene, folder.path()).unwrap();
    let tracer = Tracer::with_images(&loaded.scene, &images).unwrap();
    let options = Options {
        size: VIEW,
        viewpoint: Viewpoint::Scene,
        depth: 10,
        tolerance: None,
        memory: None,
        integrator: Integrator::Path,
        stem: "files".to_owned(),
        captions: zpg::internals::syntax::Captions::default(),
    };
    let mut output = write(&loaded.scene, loaded.bounds(), &tracer, &options).unwrap();
    // One ray through the middle of each pixel, and all light by its colour alone: no noise.
    let document = &mut output.documents[0].1;
    let between = |from: &str, to: &str, by: &str, text: &str| {
        let start = text.find(from).unwrap();
        let end = start + text[start..].find(to).unwrap() + to.len();
        format!("{}{by}{}", &text[..start], &text[end..])
    };
    *document = between(
        "<integrator",
        "</integrator>",
        "<integrator type=\"direct\"><integer name=\"emitter_samples\" value=\"0\"/>\
         <integer name=\"bsdf_samples\" value=\"1\"/></integrator>",
        document,
    );
    *document = between(
        "<sampler",
        "</sampler>",
        "<sampler type=\"stratified\"><integer name=\"sample_count\" value=\"1\"/>\
         <boolean name=\"jitter\" value=\"false\"/></sampler>",
        document,
    );
    let theirs = mitsuba::render("picture_files", &output, 0);
    let camera = selected_camera(&loaded.scene, f64::from(VIEW.0) / f64::from(VIEW.1));
    let settings = Settings {
        width: VIEW.0,
        height: VIEW.1,
        ..Settings::default()
    };
    let ours = tracer.render(&camera, &settings, || ()).unwrap().film;
    assert_eq!(theirs.len(), 3 * ours.pixels.len());
    let lit = |p: &[f32; 3]| *p != [0.0; 3];
    let mut compared = 0;
    let mut worst: f32 = 0.0;
    for (i, p) in ours.pixels.iter().enumerate() {
        // Not at the edges of the rectangles.
        let around = [
            i.wrapping_sub(1),
            i + 1,
            i.wrapping_sub(VIEW.0 as usize),
            i + VIEW.0 as usize,
        ];
        if !around.iter().all(|&k| ours.pixels.get(k).is_some_and(lit)) {
            continue;
        }
        compared += 1;
        for c in 0..3 {
            worst = worst.max((p[c] - theirs[3 * i + c]).abs());
        }
    }
    assert!(compared > 30_000, "{compared}");
    assert!(worst < 1.0 / 255.0, "{}", worst * 255.0);
}

/// On standard output nothing lies beside the translation: POV-Ray opens the scene's own files.
#[test]
fn what_povray_is_to_open_itself_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let files = files();
    let find = |form: &str| files.iter().find(|f| f.name == form).unwrap();
    let write = |name: &str, form: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, &find(form).bytes).unwrap();
    };
    let convert = |picture: &str, more: &[&str]| {
        let text = format!("2 5 0 0 1 1\n2 -301 {picture}\n1 9999 2 0\n");
        fs::write(folder.path().join("a.zpg"), text).unwrap();
        let args = [&["convert", "a.zpg", "--to", "pov"], more].concat();
        let run = program::zpg(folder.path(), &args);
        assert_eq!(run.status.code(), Some(0));
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (text(&run.stdout), text(&run.stderr))
    };
    write("jpeg.png", "rgb.jpg");
    write("png.jpg", "rgb8.png");
    write("škola/měsíc.png", "rgb8.png");
    for (picture, kind) in [
        ("jpeg.png", "jpeg"),
        ("png.jpg", "png"),
        ("škola/měsíc.png", "png"),
    ] {
        for more in [&[][..], &["-o", "-"]] {
            let (pov, report) = convert(picture, more);
            assert!(pov.contains(&format!("image_map {{ {kind} \"")), "{pov}");
            assert!(pov.contains(&format!("/{picture}\" gamma")), "{pov}");
            assert!(report.contains("approximate  image texture"), "{report}");
            let is_said = report.contains("dropped      pictures whose paths are not ASCII: ");
            assert_eq!(is_said, !picture.is_ascii(), "{report}");
        }
        let (_, report) = convert(picture, &["-o", "b.pov"]);
        assert!(
            !report.contains("image texture") && !report.contains("ASCII"),
            "{report}"
        );
        let pov = fs::read_to_string(folder.path().join("b.pov")).unwrap();
        assert!(
            pov.contains("image_map { png \"b_image_1.png\" gamma"),
            "{pov}"
        );
        let copy = image::open(folder.path().join("b_image_1.png"))
            .unwrap()
            .into_rgb8();
        assert_eq!(copy.dimensions(), (SIZE[0] as u32, SIZE[1] as u32));
    }
    // The scene's own picture is not written over.
    write("b_image_1.png", "rgb8.png");
    let text = "2 5 0 0 1 1\n2 -301 b_image_1.png\n1 9999 2 0\n";
    fs::write(folder.path().join("a.zpg"), text).unwrap();
    let run = program::zpg(
        folder.path(),
        &["convert", "a.zpg", "--to", "pov", "-o", "b.pov"],
    );
    assert_eq!(run.status.code(), Some(2));
    assert!(fs::read(folder.path().join("b_image_1.png")).unwrap() == find("rgb8.png").bytes);
}

/// Readers take names in Wavefront files up to a space; some take no others than those of ASCII.
#[test]
fn wavefront_files_name_what_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let files = files();
    fs::write(folder.path().join("p.png"), &files[0].bytes).unwrap();
    let text = "2 5 0 0 1 1\n2 -301 p.png\n1 9999 2 0\n";
    fs::write(folder.path().join("a.zpg"), text).unwrap();
    let long = format!("{}.obj", "ž".repeat(110));
    let mut libraries = std::collections::HashSet::new();
    let names = [
        "two words.obj",
        "two_words.obj",
        "škola.obj",
        "a#b%c\"d.obj",
        " .obj",
        "plain.v2.obj",
        &long,
    ];
    for name in names {
        let args = ["convert", "a.zpg", "--to", "obj", "-o", name];
        let run = program::zpg(folder.path(), &args);
        assert_eq!(
            run.status.code(),
            Some(0),
            "{}",
            String::from_utf8_lossy(&run.stderr)
        );
        let named = |file: &str, key: &str| {
            let text = fs::read_to_string(folder.path().join(file)).unwrap();
            let line = text.lines().find_map(|l| l.strip_prefix(key)).unwrap();
            // As readers split it.
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            assert_eq!(words.len(), 1, "{line}");
            words[0].to_owned()
        };
        let library = named(name, "mtllib ");
        let picture = named(&library, "map_Kd ");
        assert!(library.is_ascii() && picture.is_ascii());
        assert!(
            image::open(folder.path().join(&picture)).is_ok(),
            "{picture}"
        );
        assert_eq!(named(name, "usemtl "), named(&library, "newmtl "));
        libraries.insert(library);
    }
    assert_eq!(libraries.len(), names.len(), "{libraries:?}");
    assert!(libraries.contains("plain.v2.mtl"));
}

/// The look of a picture is told though image textures are in it: beside this scene's file lies the texture.
#[test]
fn bright_and_dark_pictures_with_image_textures() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/gallery/orrery.zpg");
    for (light, place, code) in [
        ("100", "3 5 5", Some(Code::N606)),
        // Behind the ball.
        ("1", "0 0 -9", Some(Code::W330)),
        ("1", "3 5 5", None),
    ] {
        let text = format!(
            "2 11 0 0 0 1\n2 -301 planet.jpg\n9 -501 0 0 6 0 0 -1 0 1 0 40\n50 -402 {light}\n50 -1 {place}\n1 9999 2 0\n"
        );
        let analysis = Analysis::new(path, text.into_bytes());
        let codes = analysis.findings().iter().map(|d| d.code);
        assert_eq!(
            codes.collect::<Vec<_>>(),
            Vec::from_iter(code),
            "{light} {place}"
        );
    }
}
