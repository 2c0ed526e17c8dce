//! Draws the pictures of `scenes/hard` and counts in how many pixels textbook methods go wrong.
//!
//! `cargo bench --bench hard_gallery` draws every scene three times, with the textbook's ray tracer
//! in single and in double precision and with the program, puts the three beside each other into
//! `scenes/hard/pictures/NAME.png`, and writes the table of differing pixels into
//! `scenes/hard/README.md`. With a word behind `--` it draws the scenes with that in their names,
//! and leaves the table as it is.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use hard::{Outcome, beside, draw};
use zpg::internals::trace::film::{Film, Packing};

#[path = "../tests/pictures/hard.rs"]
mod hard;

/// How far two pixels may be apart in 8-bit sRGB, in any channel, and still count as the same.
const MAX_STEPS: u8 = 2;

const BEGIN: &str = "<!-- Figures, written by `cargo bench --bench hard_gallery`. -->\n";
const END: &str = "<!-- End of the figures. -->\n";

fn main() -> Outcome<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/hard");
    let wanted = std::env::args().skip(1).find(|arg| !arg.starts_with('-'));
    let mut paths: Vec<PathBuf> = fs::read_dir(&folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<Outcome<_>>()?;
    paths.retain(|path| path.extension().is_some_and(|e| e == "zpg"));
    paths.sort();
    fs::create_dir_all(folder.join("pictures"))?;
    let mut table = String::from("| scene | f32, textbook | f64, textbook |\n|---|---:|---:|\n");
    for path in &paths {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        if wanted.as_ref().is_some_and(|word| !name.contains(word)) {
            continue;
        }
        let pictures = draw(path).map_err(|e| format!("{name}: {e}"))?;
        let [single, double, ours] = &pictures;
        let shares = [single, double].map(|film| {
            let off = differing(film, ours);
            format!(
                "{off} ({:.1} %)",
                100.0 * off as f64 / ours.pixels.len() as f64
            )
        });
        println!("{name}: {} {}", shares[0], shares[1]);
        writeln!(
            table,
            "| [`{name}`]({name}.zpg) | {} | {} |",
            shares[0], shares[1]
        )?;
        let file = File::create(folder.join(format!("pictures/{name}.png")))?;
        beside(&pictures).write_png(file, Packing::Small)?;
    }
    if wanted.is_none() {
        let page = folder.join("README.md");
        let text = fs::read_to_string(&page)?;
        let (head, rest) = text
            .split_once(BEGIN)
            .ok_or("the page has no place for figures")?;
        let (_, tail) = rest.split_once(END).ok_or("the figures have no end")?;
        fs::write(&page, format!("{head}{BEGIN}{table}{END}{tail}"))?;
    }
    Ok(())
}

/// How many pixels are not the same.
fn differing(a: &Film, b: &Film) -> usize {
    use zpg::internals::trace::film::srgb8;
    let same = |(p, q): (&[f32; 3], &[f32; 3])| {
        (0..3).all(|c| srgb8(p[c]).abs_diff(srgb8(q[c])) <= MAX_STEPS)
    };
    let pairs = a.pixels.iter().zip(&b.pixels);
    pairs.filter(|&pair| !same(pair)).count()
}
