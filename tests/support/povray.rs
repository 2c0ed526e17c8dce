//! Running the real POV-Ray.

use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::scene::Rgb;
use zpg::internals::study::povray::{PROGRAM, render as take};
use zpg::internals::study::program::Program;
use zpg::internals::trace::Film;
use zpg::internals::translate::pov::Translation;

/// Linear values, row by row.
pub struct Picture {
    pub size: (u32, u32),
    pub pixels: Vec<Rgb>,
}

/// Renders a file of a translation, all passes. The files stay in the target folder, to be looked at.
pub fn render(name: &str, translation: &Translation, file: usize, size: (u32, u32)) -> Picture {
    let film = film(name, translation, file, size);
    Picture {
        size: (film.width, film.height),
        pixels: film.pixels.iter().map(|p| p.map(f64::from)).collect(),
    }
}

/// The same as a film.
pub fn film(name: &str, translation: &Translation, file: usize, size: (u32, u32)) -> Film {
    take(
        &Program::new(PROGRAM),
        translation,
        file,
        size,
        &folder(),
        name,
    )
    .unwrap_or_else(|e| {
        panic!(
            "{name}: povray gave no picture ({e:?}): these tests compare with the real POV-Ray 3.7; \
             install it with `apt-get install povray`"
        )
    })
}

pub fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pov");
    fs::create_dir_all(&folder).expect("a folder for the pictures");
    folder
}
