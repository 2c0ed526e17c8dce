//! Scenes for jobs, and what one machine makes of them.

use std::fs;
use std::path::{Path, PathBuf};

use super::program::{self, folder, text};

/// A ball of glass, a lathe whose third point moves, a box with a picture on it, two cameras.
pub const SCENE: &str = "\
2 11 0 0 0 1\n2 -201 0.2 0.2 0.6\n2 -203 1.5 1.5 1.5\n3 12 1.5 -1 0 2.5 1 0.1\n5 1 3 0.2 -1 0.5 0.5 0.1 1\n\
5 -1 -1.5 0 0\n8 3 0 1 0 1\n8 -301 floor.png\n4 -101 2 3\n6 -101 4 8\n7 -101 6 5\n\
9 -501 0 0 8 0 0 -1 0 1 0 30\n10 -501 1 0 8 0 0 -1 0 1 0 30\n50 -401 1\n51 -402 1\n51 -1 3 5 6\n1 9999 7 0\n";
/// Takes the picture with both of its cameras.
pub const STEREO: &str = "60 -503 9 10\n";
pub const MONO: &str = "60 -502 9\n";

/// A picture of four pixels.
pub fn floor() -> Vec<u8> {
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, 2, 2);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().unwrap();
    let pixels = [200, 10, 10, 240, 240, 240, 240, 240, 240, 10, 200, 10];
    writer.write_image_data(&pixels).unwrap();
    writer.finish().unwrap();
    png
}

/// A folder with one scene.
pub fn one(more: &str) -> tempfile::TempDir {
    let scene = format!("{SCENE}{more}");
    folder(&[("a.zpg", scene.into_bytes()), ("floor.png", floor())])
}

/// What a class has handed in: a name with a space and Czech letters, an error, two folders.
pub fn class() -> tempfile::TempDir {
    let scene = |more: &str| format!("{SCENE}{more}").into_bytes();
    folder(&[
        ("one/žlutý kůň.zpg", scene(STEREO)),
        ("one/a.zpg", scene(MONO)),
        ("one/broken.zpg", b"2 11 0 0 0\n1 9999 2 0\n".to_vec()),
        ("one/floor.png", floor()),
        ("two/a.zpg", scene(MONO)),
        ("two/floor.png", floor()),
    ])
}

/// Runs `zpg`, which ends with this status, and gives what it says.
#[track_caller]
pub fn says(folder: &Path, arguments: &[&str], status: i32) -> String {
    let run = program::zpg(folder, arguments);
    let said = text(&[run.stdout, run.stderr].concat());
    assert_eq!(run.status.code(), Some(status), "{arguments:?}: {said}");
    said
}

/// The pictures in a folder and its subfolders except for bands, by their names there.
pub fn pictures(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let files = ignore::WalkBuilder::new(folder)
        .standard_filters(false)
        .sort_by_file_path(Ord::cmp)
        .filter_entry(|entry| entry.file_name() != "parts")
        .build();
    let paths = files.map(|entry| entry.unwrap().into_path());
    let pictures = paths.filter(|path| path.extension().is_some_and(|e| e == "png" || e == "exr"));
    let read = |path: PathBuf| {
        let name = path.strip_prefix(folder).unwrap().to_owned();
        (name, fs::read(path).unwrap())
    };
    pictures.map(read).collect()
}

/// The pictures in `out` are those that one machine has drawn into `whole`, byte for byte, and no others.
#[track_caller]
pub fn are_those_of(out: &Path, whole: &Path) {
    let [ours, theirs] = [out, whole].map(pictures);
    let names = |all: &[(PathBuf, Vec<u8>)]| -> Vec<PathBuf> {
        all.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&ours), names(&theirs));
    assert!(!ours.is_empty());
    for ((name, our), (_, their)) in ours.iter().zip(&theirs) {
        assert!(our == their, "{}", name.display());
    }
}
