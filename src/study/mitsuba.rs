//! The surfaces of a translation that the real Mitsuba sees through the centres of pixels.

use std::fs;
use std::path::Path;

use super::program::{Program, ProgramError, run};
use crate::translate::mitsuba::Output;

/// The name of the Python program, which has to have the package `mitsuba`.
pub const PROGRAM: &str = "python3";

/// Loads a document, renders it and writes all channels as numbers of four bytes.
const SCRIPT: &str = "\
import sys, numpy, mitsuba
mitsuba.set_variant('scalar_rgb')
mitsuba.set_log_level(mitsuba.LogLevel.Error)
# Not optimised: that would join meshes and number the shapes anew.
scene = mitsuba.load_file(sys.argv[1], optimize=False)
numpy.array(mitsuba.render(scene, spp=int(sys.argv[3]))).astype('<f4').tofile(sys.argv[2])
";

/// The number of channels of a pixel that [`Integrator::Aov`] writes: position, shading normal, index of the shape.
///
/// [`Integrator::Aov`]: crate::translate::mitsuba::Integrator::Aov
pub const CHANNELS: usize = 7;

/// Renders a document of a translation with Mitsuba and returns the channels of all pixels, row by row. Each pixel gets
/// `samples` samples, or with 0 as many as the document says. Document, meshes and numbers stay in `folder`.
///
/// # Errors
///
/// Python is missing or has no Mitsuba, Mitsuba fails or takes too long, or the folder cannot be written to.
pub fn render(
    python: &Program,
    made: &Output,
    document: usize,
    folder: &Path,
    name: &str,
    samples: u32,
) -> Result<Vec<f32>, ProgramError> {
    let asked = run(python, folder, &["-c", "import mitsuba, numpy"]);
    if let Err(ProgramError::Failed(_)) = asked {
        return Err(ProgramError::Missing);
    }
    asked?;
    for (mesh, bytes) in &made.meshes {
        fs::write(folder.join(mesh), bytes)?;
    }
    let (file, numbers) = (format!("{name}.xml"), format!("{name}.bin"));
    fs::write(folder.join(&file), &made.documents[document].1)?;
    // Numbers that an earlier run has left must not count as the answer.
    let _ = fs::remove_file(folder.join(&numbers));
    let samples = samples.to_string();
    run(python, folder, &["-c", SCRIPT, &file, &numbers, &samples])?;
    let none = |_| ProgramError::Unexpected("it has written no picture");
    let bytes = fs::read(folder.join(&numbers)).map_err(none)?;
    let number = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    Ok(bytes.chunks_exact(4).map(number).collect())
}
