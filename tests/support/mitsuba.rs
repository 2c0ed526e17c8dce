//! Running the real Mitsuba.

use std::fs;
use std::path::{Path, PathBuf};

use zpg::internals::study::program::Program;
use zpg::internals::translate::mitsuba::Output;

/// The version that `tests/run` installs.
pub const VERSION: &str = "3.9.1";

/// The Python that has it.
pub fn python() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("a target folder");
    let python = target.join(format!("mitsuba-{VERSION}/bin/python"));
    assert!(
        python.exists(),
        "{} is missing: these tests compare with the real Mitsuba; tests/run installs it",
        python.display()
    );
    python
}

/// Writes a translation and has its first document rendered; channels of all pixels, row by row. The
/// files stay in the target folder, to be looked at.
pub fn render(name: &str, made: &Output, samples: u32) -> Vec<f32> {
    // Of its own, as two pictures of a scene have meshes of the same names.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("mitsuba")
        .join(name);
    fs::create_dir_all(&folder).expect("a folder for the files");
    zpg::internals::study::mitsuba::render(&Program::new(python()), made, 0, &folder, name, samples)
        .unwrap_or_else(|e| panic!("{name}: {e:?}"))
}
