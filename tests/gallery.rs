//! The gallery uses every record type, checks clean, and looks as it did when it was last looked at.
//!
//! `UPDATE_PICTURES=1 cargo test --test all gallery` draws the pictures in tests/golden anew; look at
//! them before they are committed.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use zpg::internals::syntax::ast::Item;
use zpg::internals::syntax::table::RECORD_TYPES;

const SIZE: &str = "96x72";

fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/gallery");
    let mut scenes: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "zpg"))
        .collect();
    scenes.sort();
    assert!(scenes.len() >= 8);
    scenes
}

#[test]
fn every_record_type_is_in_the_gallery() {
    let mut found = BTreeSet::new();
    for path in scenes() {
        let text = fs::read_to_string(&path).unwrap();
        let (document, diagnostics) = zpg::internals::syntax::parse(&text);
        assert!(
            diagnostics.is_empty(),
            "{}: {diagnostics:?}",
            path.display()
        );
        for item in &document.items {
            if let Item::Record(record) = item {
                found.insert(record.ty().code);
            }
        }
    }
    let missing: Vec<i32> = RECORD_TYPES
        .iter()
        .map(|r| r.code)
        .filter(|code| !found.contains(code))
        .collect();
    assert!(missing.is_empty(), "not in the gallery: {missing:?}");
}

#[test]
fn no_scene_is_warned_of() {
    for scene in scenes() {
        let loaded = zpg::internals::analysis::file::load(&scene).unwrap();
        assert!(
            loaded.findings().is_empty(),
            "{}: {:#?}",
            scene.display(),
            loaded.findings()
        );
    }
}

fn read_png(path: &Path) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap()))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.height, bytes)
}

/// At most one pixel in 200 may differ by more than 6/255: last bits of elementary functions differ
/// between systems and move an edge now and then, nothing else.
#[test]
fn pictures_are_as_they_were_looked_at() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let folder = tempfile::tempdir().unwrap();
    for scene in scenes() {
        let name = scene.file_stem().unwrap().to_string_lossy().into_owned();
        let picture = folder.path().join(format!("{name}.png"));
        let text = fs::read_to_string(&scene).unwrap();
        let is_stereo = text
            .lines()
            .any(|l| l.split_whitespace().nth(1) == Some("-503"));
        let stereo: &[&str] = match is_stereo {
            true => &["--stereo", "side-by-side"],
            false => &[],
        };
        let output = crate::support::program::command()
            .args(["render", "--samples", "1", "--size", SIZE])
            .args(stereo)
            .arg("-o")
            .arg(&picture)
            .arg(&scene)
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {told}");
        let kept = golden.join(format!("{name}.png"));
        if std::env::var_os("UPDATE_PICTURES").is_some() {
            fs::copy(&picture, &kept).unwrap();
        }
        let (now, then) = (read_png(&picture), read_png(&kept));
        assert_eq!((now.0, now.1), (then.0, then.1), "{name}");
        let pixels = now.2.chunks(3).zip(then.2.chunks(3));
        let off = pixels
            .filter(|(a, b)| a.iter().zip(*b).any(|(x, y)| x.abs_diff(*y) > 6))
            .count();
        let all = now.2.len() / 3;
        assert!(off * 200 <= all, "{name}: {off} of {all} pixels differ");
    }
}
