//! The pictures that pages show are what the commands beside them draw, to the pixel.

mod hard;

use std::fs;
use std::path::{Path, PathBuf};

use image::RgbImage;

use crate::support::program::zpg;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn decoded(path: impl AsRef<Path>) -> RgbImage {
    let path = path.as_ref();
    let picture = image::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    picture.into_rgb8()
}

/// The pictures of a folder, by name.
fn pictures(folder: &str) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let pngs = paths.filter(|path| path.extension().is_some_and(|e| e == "png"));
    let mut all: Vec<_> = pngs
        .map(|p| (p.file_stem().unwrap().to_string_lossy().into_owned(), p))
        .collect();
    all.sort();
    all
}

/// What the gallery's page says draws a picture, but for where it is written.
fn gallery_command(name: &str) -> Vec<String> {
    let page = fs::read_to_string(root().join("scenes/gallery/README.md")).unwrap();
    let command = page
        .lines()
        .find_map(|l| l.strip_prefix("zpg render "))
        .unwrap();
    let mut words: Vec<String> = command
        .split(' ')
        .map(|w| w.replace("NAME", name))
        .collect();
    let output = words.iter().position(|w| w == "-o").unwrap();
    words.drain(output..output + 2);
    let mut besides = page.split("and `").nth(1).unwrap().split('`');
    if besides.next() == Some(name) {
        words.extend(besides.nth(1).unwrap().split(' ').map(str::to_owned));
    }
    words
}

/// What a command draws.
fn drawn(arguments: &[&str]) -> RgbImage {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("drawn.png");
    let output = ["-o", path.to_str().unwrap()];
    let run = zpg(root(), &[&["render"], arguments, &output].concat());
    assert!(
        run.status.success(),
        "{arguments:?}: {}",
        String::from_utf8_lossy(&run.stderr)
    );
    decoded(path)
}

/// The rows of a picture of the gallery.
fn rows(picture: &RgbImage, top: u32, height: u32) -> RgbImage {
    image::imageops::crop_imm(picture, 0, top, picture.width(), height).to_image()
}

/// A band of each, for a quick answer.
#[test]
fn bands_of_the_gallery_are_as_drawn() {
    let all = pictures("scenes/gallery/pictures");
    assert_eq!(all.len(), 10);
    for (name, path) in all {
        let command = gallery_command(&name);
        let words: Vec<&str> = command.iter().map(String::as_str).collect();
        let band = drawn(&[&words[..], &["--crop", "0,56,320,8"]].concat());
        assert!(
            band == rows(&decoded(path), 56, 8),
            "{name} is not what zpg {command:?} draws"
        );
    }
}

#[test]
#[ignore = "draws for minutes"]
fn the_gallery_is_as_drawn() {
    for (name, path) in pictures("scenes/gallery/pictures") {
        let command = gallery_command(&name);
        let words: Vec<&str> = command.iter().map(String::as_str).collect();
        assert!(
            drawn(&words) == decoded(path),
            "{name} is not what zpg {command:?} draws"
        );
    }
}

/// On the right is what `zpg render` draws.
#[test]
fn hard_scenes_are_as_drawn() {
    let [width, height] = hard::SIZE;
    let size = format!("{width}x{height}");
    let all = pictures("scenes/hard/pictures");
    assert_eq!(all.len(), 18);
    for (name, path) in all {
        let scene = format!("scenes/hard/{name}.zpg");
        let ours = drawn(&[&scene, "--size", &size, "--samples", "1"]);
        let sheet = decoded(path);
        let right = image::imageops::crop_imm(&sheet, 2 * (width + hard::GAP), 0, width, height);
        assert!(ours == right.to_image(), "{name}");
    }
}

/// And on the left and in the middle is what textbooks draw.
#[test]
#[ignore = "draws for minutes"]
fn hard_scenes_are_as_textbooks_draw_them() {
    for (name, path) in pictures("scenes/hard/pictures") {
        let scene = root().join(format!("scenes/hard/{name}.zpg"));
        let sheet = hard::beside(&hard::draw(&scene).unwrap());
        let mut png = Vec::new();
        sheet
            .write_png(&mut png, zpg::internals::trace::film::Packing::Quick)
            .unwrap();
        let drawn = image::load_from_memory(&png).unwrap().into_rgb8();
        assert!(drawn == decoded(path), "{name}");
    }
}

/// The strip of all, in which each picture of the gallery is 200 × 150 pixels large, two from the edge and four from
/// the next: the same on average, a tile of 10 × 10 at a time. It is a JPEG.
#[test]
fn the_strip_shows_the_gallery() {
    let strip = decoded(root().join("scenes/gallery/pictures/all.jpg"));
    assert_eq!(strip.dimensions(), (1020, 308));
    let names = [
        ["pawns", "dice", "spectrum", "chain", "quadrics"],
        ["island", "geodesic", "orrery", "bracket", "billion"],
    ];
    let mean = |picture: &RgbImage, left: u32, top: u32, side: u32| -> [f64; 3] {
        let tile = image::imageops::crop_imm(picture, left, top, side, side).to_image();
        let sum = |c: usize| tile.pixels().map(|p| f64::from(p.0[c])).sum::<f64>();
        std::array::from_fn(|c| sum(c) / f64::from(side * side))
    };
    for (row, names) in (0..).zip(names) {
        for (column, name) in (0..).zip(names) {
            let picture = decoded(root().join(format!("scenes/gallery/pictures/{name}.png")));
            for (x, y) in (0..20).flat_map(|x| (0..15).map(move |y| (x, y))) {
                let ours = mean(&picture, 16 * x, 16 * y, 16);
                let there = mean(
                    &strip,
                    2 + 204 * column + 10 * x,
                    2 + 154 * row + 10 * y,
                    10,
                );
                let off = (0..3)
                    .map(|c| (ours[c] - there[c]).abs())
                    .fold(0.0, f64::max);
                assert!(off < 12.0, "{name} at {x}, {y}: {ours:?} {there:?}");
            }
        }
    }
}
