//! What `zpg render` writes: picture formats, adaptive sampling, heatmaps, image textures.

use std::fs;
use std::io::Cursor;
use std::path::Path;
use std::process::Command;

use crate::support::program::{folder, words, zpg};

/// A ball and a thin box on black.
const SCENE: &str = "2 11 0 0 0 1\n3 12 1.5 -1 0 1.52 1 0.1\n4 -101 2 3\n9 -501 0 0 8 0 0 -1 0 1 0 30\n\
                     50 -401 1\n1 9999 4 0\n";

#[track_caller]
fn render(folder: &Path, args: &str) -> String {
    let run = zpg(folder, &words(&format!("render {args}")));
    let errors = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(0), "{errors}");
    errors
}

/// Pixels of a PFM, from the top.
fn pfm(path: &Path, width: usize) -> Vec<[f32; 3]> {
    let bytes = fs::read(path).unwrap();
    let header = bytes.split_inclusive(|&b| b == b'\n').take(3);
    let start: usize = header.map(<[u8]>::len).sum();
    let numbers: Vec<f32> = bytes[start..]
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let rows = numbers.chunks_exact(width * 3).rev();
    let flat: Vec<f32> = rows.flatten().copied().collect();
    flat.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect()
}

#[test]
fn exr_and_pfm_hold_the_same_numbers() {
    let dir = folder(&[("a.zpg", SCENE.as_bytes())]);
    render(dir.path(), "a.zpg -o a.pfm --size 40x30 --samples 3");
    render(dir.path(), "a.zpg -o a.exr --size 40x30 --samples 3");
    render(
        dir.path(),
        "a.zpg -o b.exr --size 40x30 --samples 3 --threads 7",
    );
    let expected = pfm(&dir.path().join("a.pfm"), 40);
    use exr::prelude::*;
    let file = dir.path().join("a.exr");
    let read = read_first_rgba_layer_from_file(
        &file,
        |size, _| vec![[0f32; 3]; size.width() * size.height()],
        |pixels, at, (r, g, b, _): (f32, f32, f32, f32)| pixels[at.y() * 40 + at.x()] = [r, g, b],
    )
    .unwrap();
    assert_eq!(read.layer_data.channel_data.pixels, expected);
    let bytes = fs::read(file).unwrap();
    assert!(bytes == fs::read(dir.path().join("b.exr")).unwrap());
}

#[test]
fn adaptive_sampling_is_within_its_tolerance_on_any_number_of_threads() {
    let dir = folder(&[("a.zpg", SCENE.as_bytes())]);
    let size = "--size 64x48";
    for n in [1, 2, 7] {
        render(
            dir.path(),
            &format!("a.zpg -o {n}.pfm {size} --adaptive 0.02 --threads {n} --stats {n}.json"),
        );
    }
    render(
        dir.path(),
        &format!("a.zpg -o fine.pfm {size} --samples 1024"),
    );
    let bytes = |name: &str| fs::read(dir.path().join(name)).unwrap();
    assert!(bytes("1.pfm") == bytes("2.pfm"));
    assert!(bytes("1.pfm") == bytes("7.pfm"));
    let (ours, fine) = (
        pfm(&dir.path().join("1.pfm"), 64),
        pfm(&dir.path().join("fine.pfm"), 64),
    );
    let pairs = ours.iter().flatten().zip(fine.iter().flatten());
    let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(worst <= 0.02, "{worst}");
    let stats: serde_json::Value = serde_json::from_slice(&bytes("1.json")).unwrap();
    let samples = &stats["samples"];
    assert_eq!(samples["min"], 4);
    // Where the contrast is 1, at least 1/0.02.
    assert!(samples["max"].as_u64().unwrap() >= 50, "{samples}");
    assert!(samples["mean"].as_f64().unwrap() < 30.0, "{samples}");
    let rays = stats["rays"]["camera"].as_f64().unwrap();
    assert_eq!(rays, samples["mean"].as_f64().unwrap() * 64.0 * 48.0);
}

#[test]
fn a_part_of_an_adaptive_picture_is_as_in_the_whole() {
    let dir = folder(&[("a.zpg", SCENE.as_bytes())]);
    render(
        dir.path(),
        "a.zpg -o whole.pfm --size 64x48 --adaptive 0.05",
    );
    render(
        dir.path(),
        "a.zpg -o part.pfm --size 64x48 --adaptive 0.05 --crop 20,5,30,20",
    );
    let whole = pfm(&dir.path().join("whole.pfm"), 64);
    let part = pfm(&dir.path().join("part.pfm"), 30);
    for (i, pixel) in part.iter().enumerate() {
        assert_eq!(*pixel, whole[(5 + i / 30) * 64 + 20 + i % 30], "{i}");
    }
}

#[test]
fn a_heatmap_is_brighter_where_there_is_more_to_test() {
    let dir = folder(&[("a.zpg", SCENE.as_bytes())]);
    let run = zpg(
        dir.path(),
        &words("render a.zpg -o a.png --size 64x48 --heatmap h.png"),
    );
    let wrote = "Wrote a.png: 64 × 48 pixels\nWrote h.png: 64 × 48 pixels\n";
    assert_eq!(String::from_utf8(run.stdout).unwrap(), wrote);
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(
        said.starts_with("heatmap: intersection tests per pixel, from 0"),
        "{said}"
    );
    assert_eq!(said.lines().count(), 1);
    let map = image::open(dir.path().join("h.png")).unwrap().into_rgb8();
    assert_eq!(map.dimensions(), (64, 48));
    let light = |x, y| {
        map.get_pixel(x, y)
            .0
            .iter()
            .map(|&c| u32::from(c))
            .sum::<u32>()
    };
    assert!(light(32, 24) > light(0, 0));
    render(
        dir.path(),
        "a.zpg -o b.png --size 64x48 --heatmap part.png --crop 8,8,20,10",
    );
    let part = image::open(dir.path().join("part.png")).unwrap();
    assert_eq!((part.width(), part.height()), (20, 10));
    let wrong = zpg(dir.path(), &words("render a.zpg --heatmap h.exr"));
    assert_eq!(wrong.status.code(), Some(2));
}

/// A square from (0, 0) to (1, 1) that fills a picture as wide as high.
const SQUARE: &str = "2 5 0 0 1 1\n3 -301 FILE\n2 -299 3 0\n\
                      9 -501 0.5 0.5 1 0 0 -1 0 1 0 53.13010235415598\n50 -401 1\n1 9999 2 0\n";

fn encoded(picture: image::DynamicImage) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    picture.write_to(&mut out, image::ImageFormat::Png).unwrap();
    out.into_inner()
}

#[test]
fn an_image_lies_on_a_rectangle() {
    // Red and green above, blue and white below.
    let rgb = vec![255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255];
    let eight = image::RgbImage::from_raw(2, 2, rgb.clone()).unwrap();
    let wide = rgb.iter().map(|&x| u16::from(x) * 257).collect();
    let sixteen = image::ImageBuffer::from_raw(2, 2, wide).unwrap();
    for picture in [
        image::DynamicImage::ImageRgb8(eight),
        image::DynamicImage::ImageRgb16(sixteen),
    ] {
        let scene = SQUARE.replace("FILE", "p.png");
        let dir = folder(&[("a.zpg", scene.as_bytes()), ("p.png", &encoded(picture))]);
        render(dir.path(), "a.zpg -o a.pfm --size 4x4");
        let pixels = pfm(&dir.path().join("a.pfm"), 4);
        // The centres of the pixels are a quarter of a texel off those of the texels.
        for (y, v) in [0.875, 0.625, 0.375, 0.125].into_iter().enumerate() {
            for (x, u) in [0.125, 0.375, 0.625, 0.875].into_iter().enumerate() {
                // The share of the right and of the upper texel, the picture repeating.
                let share = |s: f64| {
                    if s < 0.5 {
                        0.25f64.max(s * 2.0 - 0.5)
                    } else {
                        0.75
                    }
                };
                let (r, t) = (share(u), share(v));
                let expected = [t * (1.0 - r) + (1.0 - t) * r, r, 1.0 - t];
                for c in 0..3 {
                    let error = f64::from(pixels[y * 4 + x][c]) - expected[c];
                    assert!(
                        error.abs() < 1e-6,
                        "{x},{y}: {:?} {expected:?}",
                        pixels[y * 4 + x]
                    );
                }
            }
        }
    }
}

#[test]
fn grey_pictures_are_grey() {
    let grey = image::GrayImage::from_raw(1, 1, vec![188]).unwrap();
    let scene = SQUARE.replace("FILE", "p.png");
    let dir = folder(&[
        ("a.zpg", scene.as_bytes()),
        ("p.png", &encoded(grey.into())),
    ]);
    render(dir.path(), "a.zpg -o a.png --size 1x1");
    let out = image::open(dir.path().join("a.png")).unwrap().into_rgb8();
    assert_eq!(out.get_pixel(0, 0).0, [188; 3]);
}

#[test]
fn bad_pictures_are_errors_of_the_scene() {
    let good = encoded(image::RgbImage::new(9, 9).into());
    let truncated = &good[..good.len() / 2];
    let mut gigantic = good.clone();
    // The width in the header, and its checksum left wrong or not: either way it cannot be used.
    gigantic[16..20].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff]);
    let broad = encoded(image::RgbImage::new(8193, 1).into());
    let text: &[u8] = b"not a picture";
    for bytes in [truncated, &gigantic, &broad, text] {
        let scene = SQUARE.replace("FILE", "p.png");
        let dir = folder(&[("a.zpg", scene.as_bytes()), ("p.png", bytes)]);
        let run = zpg(dir.path(), &words("render a.zpg"));
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(1), "{said}");
        assert!(
            said.starts_with("error[E210]") && said.contains("a.zpg:2:8"),
            "{said}"
        );
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 2);
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_before_the_first_row_leaves_no_file() {
    use std::time::{Duration, Instant};
    let dir = folder(&[("a.zpg", SCENE.as_bytes())]);
    let files = || fs::read_dir(dir.path()).unwrap().count();
    let mut child = crate::support::program::command()
        .args([
            "render",
            "a.zpg",
            "--size",
            "2000x2000",
            "--samples",
            "1000",
        ])
        .current_dir(dir.path())
        .spawn()
        .unwrap();
    let start = Instant::now();
    while files() < 2 && start.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(10));
    }
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(files(), 1);
}

/// Nothing is written over the scene or what it needs, and nothing twice to one file.
#[test]
fn what_is_read_is_spared() {
    let scene = "2 9 1\n2 -301 ball.png\n1 9999 2 0\n";
    let dir = folder(&[("ball.zpg", scene.as_bytes())]);
    fs::write(dir.path().join("a.zpg"), SCENE).unwrap();
    render(dir.path(), "a.zpg -o ball.png --size 4x3");
    let picture = fs::read(dir.path().join("ball.png")).unwrap();
    for args in [
        "render ball.zpg --size 4x3",
        "render ball.zpg --size 4x3 -o x.png --heatmap ball.png",
        "render ball.zpg --size 4x3 -o x.png --stats ball.zpg",
        "render a.zpg --size 4x3 -o x.png --stats x.png",
        "render a.zpg --size 4x3 -o x.png --heatmap ./x.png",
        "convert ball.zpg --to json -o ball.zpg",
        "convert a.zpg --to json -o x.json --report x.json",
        "check a.zpg ball.zpg -o ball.zpg",
    ] {
        let run = zpg(dir.path(), &words(args));
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{args}: {said}");
        let reasons = [
            "would be overwritten",
            "be written twice",
            "the output has another format",
        ];
        assert!(reasons.iter().any(|r| said.contains(r)), "{args}: {said}");
    }
    assert_eq!(fs::read(dir.path().join("ball.png")).unwrap(), picture);
    assert_eq!(
        fs::read_to_string(dir.path().join("ball.zpg")).unwrap(),
        scene
    );
    let left = fs::read_dir(dir.path()).unwrap().count();
    assert_eq!(left, 3);
    // A mesh needs two files: if one of them cannot be written, the other one stays as it is.
    fs::write(dir.path().join("m.obj"), "old").unwrap();
    fs::create_dir(dir.path().join("m.mtl")).unwrap();
    assert_eq!(
        zpg(dir.path(), &words("convert a.zpg --to obj -o m.obj"))
            .status
            .code(),
        Some(2)
    );
    assert_eq!(fs::read_to_string(dir.path().join("m.obj")).unwrap(), "old");
}
