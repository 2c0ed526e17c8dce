//! Running the real POV-Ray.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use zpg::scene::Rgb;
use zpg::translate::pov::Translation;

/// Linear values, row by row.
pub struct Picture {
    pub size: (u32, u32),
    pub pixels: Vec<Rgb>,
}

/// Renders a file of a translation, all passes. The files stay in the target folder, to be looked at.
pub fn render(name: &str, translation: &Translation, file: usize, size: (u32, u32)) -> Picture {
    let text = &translation.files[file].text;
    let dimmed = translation.light_scale;
    if translation.passes == 1 {
        return run(name, text, size, None, dimmed);
    }
    let passes = [0, 1, 2].map(|c| run(name, text, size, Some(c), dimmed));
    let pixels = (0..passes[0].pixels.len())
        .map(|i| std::array::from_fn(|c| passes[c].pixels[i][c]))
        .collect();
    Picture { size, pixels }
}

pub fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pov");
    fs::create_dir_all(&folder).expect("a folder for the pictures");
    folder
}

fn run(name: &str, text: &str, size: (u32, u32), channel: Option<u32>, dimmed: f64) -> Picture {
    let stem = match channel {
        Some(c) => format!("{name}_{c}"),
        None => name.to_owned(),
    };
    let scene = folder().join(format!("{stem}.pov"));
    let picture = folder().join(format!("{stem}.png"));
    fs::write(&scene, text).expect("a writable target folder");
    let mut command = Command::new("povray");
    command
        .arg(format!("+I{}", scene.display()))
        .arg(format!("+O{}", picture.display()))
        .arg(format!("+W{}", size.0))
        .arg(format!("+H{}", size.1))
        .args(["-A", "-D", "+FN16", "File_Gamma=1.0"]);
    if let Some(c) = channel {
        command.arg(format!("Declare=Channel={c}"));
    }
    let output = command.output().unwrap_or_else(|e| {
        panic!(
            "cannot run povray ({e}): these tests compare with the real POV-Ray 3.7; \
             install it with `apt-get install povray`"
        )
    });
    assert!(
        output.status.success(),
        "povray failed on {}:\n{}",
        scene.display(),
        String::from_utf8_lossy(&output.stderr)
    );
    read(&picture, dimmed)
}

fn read(path: &Path, dimmed: f64) -> Picture {
    let file = fs::File::open(path).expect("povray wrote its picture");
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().expect("a PNG file");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut bytes).expect("a whole picture");
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    let samples = info.color_type.samples();
    let value = |b: &[u8]| f64::from(u16::from_be_bytes([b[0], b[1]])) / 65535.0 / dimmed;
    let pixels = bytes
        .chunks_exact(2 * samples)
        .map(|p| std::array::from_fn(|c| value(&p[2 * c..])))
        .collect();
    Picture {
        size: (info.width, info.height),
        pixels,
    }
}
