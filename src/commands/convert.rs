//! `zpg convert`: the scene for other programs.

mod mesh;
mod mitsuba;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::draft::{Draft, unwritable};
use super::size::Size;
use super::{Loaded, LookChoice, Status, complain, load_sound};
use crate::scene::Scene;
use crate::translate::{File, Report, Translation, Unsupported, pov};

/// Translate a scene for another program
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The scene; `-` is standard input
    file: PathBuf,

    /// What to translate it to
    #[arg(long, value_enum)]
    to: Target,

    /// Where to write. If not given: standard output, and a mesh to SCENE.ply (obj, glb) in the
    /// current folder
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Size of the picture the camera is for, in pixels
    #[arg(long, default_value = "640x480", value_name = "WxH")]
    size: Size,

    /// How often a ray may be mirrored or refracted
    #[arg(long, default_value_t = 10, value_name = "N")]
    depth: u32,

    /// How far meshes may be from curved surfaces, in scene units; by default a thousandth of the
    /// scene's size
    #[arg(long, value_name = "LEN", value_parser = length)]
    tolerance: Option<f64>,

    /// Write the fidelity report as JSON, too
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// The programs there are translations for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Target {
    /// POV-Ray 3.7
    Pov,
    /// Mitsuba 3: XML, with meshes beside it
    Mitsuba,
    /// Triangles: Stanford PLY, binary, with colours
    Ply,
    /// Triangles: Wavefront OBJ, with a library of materials beside it
    Obj,
    /// Triangles: glTF 2.0, binary
    Glb,
}

/// A length on the command line.
fn length(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x > 0.0 && x.is_finite() => Ok(x),
        _ => Err("expected a length above 0".to_owned()),
    }
}

/// Reads the scene, translates it, says how well it went.
pub fn run(args: &Args, look: LookChoice) -> Status {
    let mut loaded = match load_sound(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    match args.to {
        Target::Pov => match translate(args, &loaded.scene) {
            Ok(translation) => deliver(args, &translation),
            Err(unsupported) => refuse(&loaded, &unsupported),
        },
        Target::Mitsuba => mitsuba::run(args, &mut loaded, look),
        Target::Ply => mesh::run(args, mesh::Format::Ply, &mut loaded, look),
        Target::Obj => mesh::run(args, mesh::Format::Obj, &mut loaded, look),
        Target::Glb => mesh::run(args, mesh::Format::Glb, &mut loaded, look),
    }
}

/// Says what cannot be translated, and where it is written.
fn refuse(loaded: &Loaded, unsupported: &Unsupported) -> Status {
    let at = unsupported.span.map(|s| loaded.source.position(s.start));
    let place = at.map_or(String::new(), |p| {
        format!("{}:{}:{}: ", loaded.source.path, p.line, p.column)
    });
    complain(&format!("{place}{unsupported}"));
    Status::Negative
}

fn translate(args: &Args, scene: &Scene) -> Result<Translation, Unsupported> {
    let options = pov::Options {
        size: (args.size.width, args.size.height),
        depth: args.depth,
        pictures: pictures(&args.file, args.output.as_deref()),
        stereo: match args.output {
            Some(_) => pov::Stereo::TwoFiles,
            None => pov::Stereo::OneFile,
        },
    };
    let pov::Translation { files, report, .. } = pov::write(scene, &options)?;
    Ok(Translation { files, report })
}

/// What leads from the translation to the pictures beside the scene: nothing where it is written
/// beside them, too, else their folder with its whole path.
fn pictures(scene: &Path, output: Option<&Path>) -> String {
    let folder = |path: &Path| {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        folder.unwrap_or(Path::new(".")).canonicalize().ok()
    };
    match (folder(scene), output.map(folder)) {
        (Some(from), Some(Some(to))) if from == to => String::new(),
        (Some(from), _) => format!("{}/", from.display()),
        (None, _) => String::new(),
    }
}

/// Writes the translation and its report.
fn deliver(args: &Args, translation: &Translation) -> Status {
    let written = match &args.output {
        Some(path) => translation.files.iter().try_for_each(|file| {
            let path = suffixed(path, file.suffix);
            write_file(&path, &file.text).map_err(|e| (path, e))
        }),
        None => match print_all(&translation.files) {
            // Nobody reads any more: that is their choice.
            Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
                Err((PathBuf::from("standard output"), e))
            }
            _ => Ok(()),
        },
    };
    let written = written.and_then(|()| match &args.report {
        Some(path) => write_report(path, &translation.report).map_err(|e| (path.clone(), e)),
        None => Ok(()),
    });
    // Nobody is left to be told when standard error is gone.
    let _ = write!(io::stderr(), "{}", translation.report);
    match written {
        Ok(()) => Status::Clean,
        Err((path, e)) => {
            complain(&unwritable(&path, &e));
            Status::Failure
        }
    }
}

/// `NAME` and a suffix, before the extension.
fn suffixed(path: &Path, suffix: &str) -> PathBuf {
    if suffix.is_empty() {
        return path.to_owned();
    }
    let mut name = path.file_stem().unwrap_or_default().to_owned();
    name.push(suffix);
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
}

fn print_all(files: &[File]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    files
        .iter()
        .try_for_each(|f| out.write_all(f.text.as_bytes()))
}

fn write_report(path: &Path, report: &Report) -> io::Result<()> {
    let mut text = serde_json::to_string_pretty(&report.to_json())?;
    text.push('\n');
    write_file(path, &text)
}

fn write_file(path: &Path, text: &str) -> io::Result<()> {
    Draft::create(path)?.finish(path, |out| out.write_all(text.as_bytes()))
}
