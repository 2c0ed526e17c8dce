//! Running the real Mitsuba.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use zpg::translate::mitsuba::Output;

/// The version that `tests/run` installs.
pub const VERSION: &str = "3.9.1";

/// Loads a document, renders it and writes all channels as numbers of four bytes.
const SCRIPT: &str = "\
import sys, numpy, mitsuba
mitsuba.set_variant('scalar_rgb')
mitsuba.set_log_level(mitsuba.LogLevel.Error)
# Not optimised: that would join meshes and number the shapes anew.
scene = mitsuba.load_file(sys.argv[1], optimize=False)
spp = int(sys.argv[3])
image = mitsuba.render(scene, spp=spp) if spp else mitsuba.render(scene)
numpy.array(image).astype('<f4').tofile(sys.argv[2])
";

/// The Python that has it.
fn python() -> PathBuf {
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
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mitsuba");
    fs::create_dir_all(&folder).expect("a folder for the files");
    for (mesh, bytes) in &made.meshes {
        fs::write(folder.join(mesh), bytes).expect("a writable target folder");
    }
    let document = folder.join(format!("{name}.xml"));
    let numbers = folder.join(format!("{name}.bin"));
    fs::write(&document, &made.documents[0].1).expect("a writable target folder");
    let output = Command::new(python())
        .args(["-c", SCRIPT])
        .args([&document, &numbers])
        .arg(samples.to_string())
        .output()
        .expect("Python runs");
    assert!(
        output.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    let bytes = fs::read(numbers).expect("what was rendered");
    bytes
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        .collect()
}
