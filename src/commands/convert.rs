//! `zpg convert`: the scene for other programs.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::draft::{Draft, unwritable};
use super::size::Size;
use super::{Loaded, LookChoice, Status, complain, load_sound};
use crate::diagnostics::Complaint;
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

    /// Where to write; standard output if not given. A stereo pair is written to NAME_left and
    /// NAME_right; on standard output it is one file with a switch
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Size of the picture the camera is for, in pixels
    #[arg(long, default_value = "640x480", value_name = "WxH")]
    size: Size,

    /// How often a ray may be mirrored or refracted
    #[arg(long, default_value_t = 10, value_name = "N")]
    depth: u32,

    /// Write the fidelity report as JSON, too
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// The programs there are translations for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Target {
    /// POV-Ray 3.7
    Pov,
}

/// Reads the scene, translates it, says how well it went.
pub fn run(args: &Args, look: LookChoice) -> Status {
    let loaded = match load_sound(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    match translate(args, &loaded.scene) {
        Ok(translation) => deliver(args, &translation, look),
        Err(unsupported) => refuse(&loaded, &unsupported, look),
    }
}

/// Says what cannot be translated, and where it is written.
pub(super) fn refuse(loaded: &Loaded, unsupported: &Unsupported, look: LookChoice) -> Status {
    let at = unsupported.span.map(|s| loaded.source.position(s.start));
    let place = at.map_or(String::new(), |p| {
        format!("{}:{}:{}: ", loaded.source.path, p.line, p.column)
    });
    complain(look, &Complaint::quoted(format!("{place}{unsupported}")));
    Status::Negative
}

fn translate(args: &Args, scene: &Scene) -> Result<Translation, Unsupported> {
    match args.to {
        Target::Pov => {
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
    }
}

/// What leads from the translation to the pictures beside the scene: nothing where it is written
/// beside them, too, else their folder with its whole path.
pub(super) fn pictures(scene: &Path, output: Option<&Path>) -> String {
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
fn deliver(args: &Args, translation: &Translation, look: LookChoice) -> Status {
    let written = match &args.output {
        Some(path) => translation.files.iter().try_for_each(|file| {
            let path = suffixed(path, file.suffix);
            write_file(&path, &file.text).map_err(|e| (path, e))
        }),
        None => match write_all(&translation.files) {
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
            complain(look, &unwritable(&path, &e));
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

fn write_all(files: &[File]) -> io::Result<()> {
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
