//! Picture files of every form: what zpg draws of them, and that POV-Ray and Mitsuba draw the same.

use std::fs;
use std::path::Path;

use jpeg_encoder::{ChromaSubsamplingMethod, ColorType, Encoder, SamplingFactor};

use crate::support::picture_file::{Colour, Png, SIZE, zlib};
use crate::support::{mitsuba, program};
use zpg::analysis::Analysis;
use zpg::trace::{Images, Settings, Tracer, selected_camera};
use zpg::translate::mitsuba::{Integrator, Options, write};

/// A picture file, and what it shows.
struct File {
    name: String,
    bytes: Vec<u8>,
    /// Colours from 0 to 255, row by row from the top.
    shown: Vec<[f64; 3]>,
    /// By how much a decoder may differ, in the same numbers.
    most: f64,
}

/// What is drawn wherever a form can hold it: it changes slowly, so that JPEG keeps it.
fn colour(x: usize, y: usize) -> [u8; 3] {
    let (x, y) = (x as u8, y as u8);
    [20 + 12 * x, 30 + 14 * y, 220 - 8 * (x + y)]
}

fn each_pixel<T>(value: impl Fn(usize, usize) -> T) -> Vec<T> {
    let places = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
    places.map(|(x, y)| value(x, y)).collect()
}

fn form<'a>(depth: u8, colour: Colour, chunks: &'a [(&'a str, Vec<u8>)]) -> Png<'a> {
    Png {
        depth,
        colour,
        chunks,
        interlaced: false,
    }
}

/// PNG of all colours and depths, whole and interlaced, with and without what says how to show the colours.
fn pngs() -> Vec<File> {
    let mut files = Vec::new();
    let mut add = |name: &str,
                   form: Png,
                   sample: &dyn Fn(usize, usize) -> Vec<u16>,
                   shown: &dyn Fn(usize, usize) -> [f64; 3]| {
        for interlaced in [false, true] {
            let form = Png { interlaced, ..form };
            files.push(File {
                name: format!("{name}{}.png", if interlaced { "_interlaced" } else { "" }),
                bytes: form.file(sample),
                shown: each_pixel(shown),
                most: 1e-6,
            });
        }
    };
    // From transparent to opaque.
    let alpha = |x: usize, most: u16| most / SIZE[0] as u16 * x as u16;
    for depth in [1, 2, 4, 8, 16] {
        let most = u32::from(u16::MAX >> (16 - depth));
        let value = |x: usize, y: usize| ((x * 7 + y * 5) as u32 * most / 134) as u16;
        let shown = |x, y| [f64::from(value(x, y)) * 255.0 / f64::from(most); 3];
        let grey = |x, y| vec![value(x, y)];
        add(
            &format!("grey{depth}"),
            form(depth, Colour::Grey, &[]),
            &grey,
            &shown,
        );
        // One of the greys is transparent.
        let clear = [("tRNS", value(3, 3).to_be_bytes().to_vec())];
        add(
            &format!("grey{depth}_key"),
            form(depth, Colour::Grey, &clear),
            &grey,
            &shown,
        );
        if depth < 16 {
            let palette: Vec<[u8; 3]> = (0..=most as usize)
                .map(|i| colour(i % 12, i % 11))
                .collect();
            let plain = [("PLTE", palette.concat())];
            let clear = [("PLTE", palette.concat()), ("tRNS", vec![0, 128])];
            let shown = |x, y| palette[usize::from(value(x, y))].map(f64::from);
            add(
                &format!("palette{depth}"),
                form(depth, Colour::Palette, &plain),
                &grey,
                &shown,
            );
            add(
                &format!("palette{depth}_clear"),
                form(depth, Colour::Palette, &clear),
                &grey,
                &shown,
            );
        }
        if depth >= 8 {
            let by = (most / 255) as u16;
            // In 16 bits a little more than in 8.
            let wide = |x, y| colour(x, y).map(|c| u16::from(c) * by + by / 3).to_vec();
            let shown =
                |x, y| colour(x, y).map(|c| f64::from(u16::from(c) * by + by / 3) / f64::from(by));
            let rgb_key: Vec<u8> = wide(4, 4).iter().flat_map(|s| s.to_be_bytes()).collect();
            let key = [("tRNS", rgb_key)];
            add(
                &format!("rgb{depth}"),
                form(depth, Colour::Rgb, &[]),
                &wide,
                &shown,
            );
            add(
                &format!("rgb{depth}_key"),
                form(depth, Colour::Rgb, &key),
                &wide,
                &shown,
            );
            let rgba = |x, y| [wide(x, y), vec![alpha(x, most as u16)]].concat();
            add(
                &format!("rgba{depth}"),
                form(depth, Colour::Rgba, &[]),
                &rgba,
                &shown,
            );
            let grey_alpha = |x, y| vec![value(x, y), alpha(x, most as u16)];
            let shown = |x, y| [f64::from(value(x, y)) * 255.0 / f64::from(most); 3];
            add(
                &format!("grey_alpha{depth}"),
                form(depth, Colour::GreyAlpha, &[]),
                &grey_alpha,
                &shown,
            );
        }
    }
    // What is said of colours does not change them: zpg takes all pictures as sRGB.
    let gamma = |g: u32| g.to_be_bytes().to_vec();
    let profile = [b"profile\0\0".to_vec(), zlib(&[0; 132])].concat();
    let white: Vec<u8> = [31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000u32]
        .iter()
        .flat_map(|n| n.to_be_bytes())
        .collect();
    let said: [(&str, &[(&str, Vec<u8>)]); 6] = [
        ("linear", &[("gAMA", gamma(100_000))]),
        ("gamma", &[("gAMA", gamma(45_455))]),
        ("srgb", &[("sRGB", vec![0]), ("gAMA", gamma(45_455))]),
        ("primaries", &[("gAMA", gamma(55_556)), ("cHRM", white)]),
        ("profile", &[("iCCP", profile)]),
        (
            "background",
            &[("bKGD", vec![0, 255, 0, 0, 0, 0]), ("sBIT", vec![5, 6, 5])],
        ),
    ];
    let samples = |x, y| colour(x, y).map(u16::from).to_vec();
    let shown = |x, y| colour(x, y).map(f64::from);
    for (name, chunks) in said {
        add(name, form(8, Colour::Rgb, chunks), &samples, &shown);
    }
    files
}

/// JPEG in all the ways there are to store it.
fn jpegs() -> Vec<File> {
    let mut files = Vec::new();
    let [width, height] = SIZE.map(|n| n as u16);
    let rgb = each_pixel(colour).concat();
    let grey = each_pixel(|x, y| colour(x, y)[1]);
    let inks = |black: u8| {
        each_pixel(|x, y| {
            let [r, g, b] = colour(x, y).map(|c| 255 - c);
            [r, g, b, black]
        })
    };
    let colours = [
        ("rgb", ColorType::Rgb, rgb, 255.0),
        ("grey", ColorType::Luma, grey, 255.0),
        ("cmyk", ColorType::Cmyk, inks(0).concat(), 255.0),
        ("cmyk_black", ColorType::Cmyk, inks(80).concat(), 175.0),
        ("ycck", ColorType::CmykAsYcck, inks(80).concat(), 175.0),
    ];
    for (name, kind, data, lightest) in colours {
        let shown = each_pixel(|x, y| match kind {
            ColorType::Luma => [f64::from(colour(x, y)[1]); 3],
            _ => colour(x, y).map(|c| f64::from(c) * lightest / 255.0),
        });
        // Of four pixels with one chroma, blue is most off: by half a step of it each way, 1.772·0.564·((8 + 2.7)/2 +
        // (8 + 7.3)/2) = 13, where 2.7 and 7.3 are the steps of luma.
        for (way, most) in [
            ("", 4.0),
            ("_small", 4.0 + 13.0),
            ("_progressive", 4.0),
            ("_restarts", 4.0),
            ("_said", 4.0),
        ] {
            // The encoder makes CMYK coarser than black, which zpg does not read.
            if way == "_small" && kind == ColorType::Cmyk {
                continue;
            }
            let mut bytes = Vec::new();
            let mut encoder = Encoder::new(&mut bytes, 100);
            encoder.set_sampling_factor(SamplingFactor::F_1_1);
            match way {
                "_small" => {
                    encoder.set_sampling_factor(SamplingFactor::F_2_2);
                    encoder.set_chroma_subsampling_method(ChromaSubsamplingMethod::Average);
                }
                "_progressive" => encoder.set_progressive(true),
                "_restarts" => encoder.set_restart_interval(1),
                "_said" => {
                    encoder.add_icc_profile(&[0; 132]).unwrap();
                    // Held upside down.
                    let turned =
                        b"MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0";
                    encoder.add_exif_metadata(turned).unwrap();
                }
                _ => {}
            }
            encoder.encode(&data, width, height, kind).unwrap();
            files.push(File {
                name: format!("{name}{way}.jpg"),
                bytes,
                shown: shown.clone(),
                most,
            });
        }
    }
    files
}

/// All forms, some of them under names that say something else or that programs stumble over. Names in a scene lead down
/// only.
fn files() -> Vec<File> {
    let mut files = pngs();
    files.extend(jpegs());
    let names = [
        ("rgb.jpg", "jpeg.png"),
        ("rgb8.png", "png.JPG"),
        ("grey.jpg", "none"),
        ("rgb16.png", "škola/měsíc.png"),
        ("cmyk.jpg", "šk%20ola/two words/a'b$c&<d>.jpeg"),
        ("palette4.png", &format!("{}.png", "x".repeat(240))),
        ("rgba8.png", &format!("{}.png", "ř".repeat(120))),
    ];
    for (form, name) in names {
        let file = files.iter().find(|file| file.name == form).unwrap();
        let file = File {
            name: name.to_owned(),
            bytes: file.bytes.clone(),
            shown: file.shown.clone(),
            most: file.most,
        };
        files.push(file);
    }
    files
}

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
        let run = program::zpg(folder.path(), &args, "");
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
        let run = program::zpg(folder.path(), &args, "");
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
        depth: 10,
        tolerance: None,
        memory: None,
        integrator: Integrator::Path,
        stem: "files".to_owned(),
        captions: zpg::syntax::Captions::default(),
    };
    let mut output = write(&loaded.scene, &tracer, &options).unwrap();
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
        let run = program::zpg(folder.path(), &args, "");
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
        "",
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
        let run = program::zpg(folder.path(), &args, "");
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
