//! `zpg convert`: the scene for other programs.

mod mesh;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::draft::{Draft, unwritable};
use super::size::Size;
use super::{Loaded, LookChoice, Status, complain, load_sound};
use crate::translate::{Report, Translation, Unsupported, pov};

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

fn translate(args: &Args, scene: &crate::scene::Scene) -> Result<Translation, Unsupported> {
    pov::write(
        scene,
        &pov::Options {
            size: (args.size.width, args.size.height),
            depth: args.depth,
        },
    )
}

/// Writes the translation and its report.
fn deliver(args: &Args, translation: &Translation) -> Status {
    let written = match &args.output {
        Some(path) => write_file(path, &translation.text).map_err(|e| (path.clone(), e)),
        None => match io::stdout().lock().write_all(translation.text.as_bytes()) {
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

fn write_report(path: &Path, report: &Report) -> io::Result<()> {
    let mut text = serde_json::to_string_pretty(&report.to_json())?;
    text.push('\n');
    write_file(path, &text)
}

fn write_file(path: &Path, text: &str) -> io::Result<()> {
    Draft::create(path)?.finish(path, |out| out.write_all(text.as_bytes()))
}
