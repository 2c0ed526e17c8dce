//! Hashes of what a picture depends on, so that files can say what they are a picture of.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use serde::Serialize;
use sha2::{Digest, Sha256};

use super::Args;
use super::options::{Sampling, Stereo};
use crate::scene::Scene;
use crate::trace::{Images, Settings};
use crate::translate::json;

/// The first half of SHA-256 as 32 hexadecimal digits.
fn digits(hash: Sha256) -> String {
    let half = hash.finalize();
    half[..16]
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// A writer that takes all bytes into a hash.
struct Hashed(Sha256);

impl Write for Hashed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A hash of a scene as it is drawn, with the bytes of its textures; comments and layout do not matter.
pub(super) fn of_scene(scene: &Scene, folder: &Path) -> String {
    let mut hash = of_json(&json::write(scene));
    for file in Images::files(scene) {
        // A texture that cannot be read is complained about when it is to be drawn.
        let bytes = std::fs::read(folder.join(file)).unwrap_or_default();
        hash.update(Sha256::digest(&bytes));
    }
    digits(hash)
}

/// The hash of a value as JSON. The caller may add more bytes.
fn of_json(value: &impl Serialize) -> Sha256 {
    // The buffer gathers JSON, which is written in pieces of a few bytes.
    let mut out = BufWriter::new(Hashed(Sha256::new()));
    // Only writing can fail, and writing into a hash does not.
    let _ = serde_json::to_writer(&mut out, value);
    out.into_inner()
        .map_or_else(|_| Sha256::new(), |hashed| hashed.0)
}

/// The content of a file: what it shows of the cameras of a scene.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Content {
    /// The view of the only camera, or both as one picture.
    Picture,
    Left,
    Right,
    /// Rows that an interrupted run has drawn with the camera of this number, before exposure and stereo are applied.
    Rows(usize),
}

/// The options that a picture depends on. The camera is no part of them, as the hash of the scene has it.
#[derive(Serialize)]
struct Options {
    content: Content,
    size: [u32; 2],
    crop: Option<[u32; 4]>,
    samples: Option<u32>,
    tolerance: Option<f64>,
    depth: u32,
    cutoff: f64,
    numbers: &'static str,
    exposure: Option<f64>,
    stereo: Option<&'static str>,
}

/// A hash of the options that a picture depends on. Neither their spelling nor the band of rows matters.
pub(super) fn of_settings(args: &Args, settings: &Settings, content: Content) -> String {
    let (samples, tolerance) = match args.picture.sampling() {
        Sampling::Fixed(samples) => (Some(samples), None),
        Sampling::Adaptive(tolerance) => (None, Some(tolerance)),
    };
    let is_finished = !matches!(content, Content::Rows(_));
    let stereo = args.picture.stereo.unwrap_or_default();
    let options = Options {
        content,
        size: [settings.width, settings.height],
        crop: args
            .picture
            .crop
            .map(|c| [c.0.x, c.0.y, c.0.width, c.0.height]),
        samples,
        tolerance,
        depth: settings.depth,
        cutoff: settings.cutoff,
        numbers: settings.numbers.name(),
        exposure: args.picture.exposure.filter(|_| is_finished),
        stereo: is_finished.then_some(match stereo {
            Stereo::Pair => "pair",
            Stereo::SideBySide => "side-by-side",
            Stereo::Anaglyph => "anaglyph",
        }),
    };
    digits(of_json(&options))
}
