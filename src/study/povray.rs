//! The real POV-Ray's picture of a translation.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use super::program::{Program, ProgramError, run};
use crate::trace::Film;
use crate::translate::pov::Translation;

/// The name of the program.
pub const PROGRAM: &str = "povray";

/// Renders file number `file` of a translation with POV-Ray, in all its passes, and returns the picture. The scene and
/// the picture of each pass stay in `folder`, under `name`.
///
/// # Errors
///
/// POV-Ray is missing, fails or takes too long, or the folder cannot be written to.
pub fn render(
    program: &Program,
    translation: &Translation,
    file: usize,
    size: (u32, u32),
    folder: &Path,
    name: &str,
) -> Result<Film, ProgramError> {
    let scene = format!("{name}.pov");
    fs::write(folder.join(&scene), &translation.files[file].text)?;
    let take = |picture: &str, pass: Option<u32>| {
        let mut arguments = vec![
            format!("+I{scene}"),
            format!("+O{picture}"),
            format!("+W{}", size.0),
            format!("+H{}", size.1),
        ];
        // No smoothing, no window, 16 bits a channel, linear.
        arguments.extend(["-A", "-D", "+FN16", "File_Gamma=1.0"].map(str::to_owned));
        arguments.push(format!("Declare=Light_Scale={}", translation.light_scale));
        arguments.extend(pass.map(|c| format!("Declare=Channel={c}")));
        // A picture that an earlier run has left must not count as the answer.
        let _ = fs::remove_file(folder.join(picture));
        run(program, folder, &arguments)?;
        read(&folder.join(picture), size, translation.light_scale)
    };
    if translation.passes == 1 {
        return take(&format!("{name}.png"), None);
    }
    let mut film = take(&format!("{name}_0.png"), Some(0))?;
    for c in 1..3 {
        let pass = take(&format!("{name}_{c}.png"), Some(c as u32))?;
        for (whole, part) in film.pixels.iter_mut().zip(pass.pixels) {
            whole[c] = part[c];
        }
    }
    Ok(film)
}

/// Reads a linear PNG of 16 bits, and divides its values by `scale`.
fn read(path: &Path, size: (u32, u32), scale: f64) -> Result<Film, ProgramError> {
    let unexpected = |_| ProgramError::Unexpected("its picture cannot be read");
    let none = |_| ProgramError::Unexpected("it has written no picture");
    let file = File::open(path).map_err(none)?;
    let decoder = png::Decoder::new(BufReader::new(file));
    let mut reader = decoder.read_info().map_err(unexpected)?;
    let info = reader.info();
    if (info.width, info.height) != size || info.bit_depth != png::BitDepth::Sixteen {
        return Err(ProgramError::Unexpected("its picture is of another size"));
    }
    let length = reader.output_buffer_size();
    let mut bytes = vec![0; length.ok_or(ProgramError::Unexpected("its picture is too large"))?];
    let frame = reader.next_frame(&mut bytes).map_err(unexpected)?;
    let samples = frame.color_type.samples();
    let value = |b: &[u8]| {
        let whole = f64::from(u16::from_be_bytes([b[0], b[1]]));
        (whole / f64::from(u16::MAX) / scale) as f32
    };
    // Grey stands for three equal channels.
    let channel = |c: usize| if samples < 3 { 0 } else { 2 * c };
    let pixels = bytes
        .chunks_exact(2 * samples)
        .map(|p| std::array::from_fn(|c| value(&p[channel(c)..])))
        .collect();
    Ok(Film {
        width: size.0,
        height: size.1,
        pixels,
    })
}
