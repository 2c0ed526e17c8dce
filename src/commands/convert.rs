//! `zpg convert`: the scene for other programs.

use std::collections::HashSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::draft::{Draft, unwritable};
use super::memory::Memory;
use super::size::Size;
use super::terminal::unprintable;
use super::{LookChoice, Needs, Status, complain, load_for, refuse, usage};
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Error, Value};
use crate::scene::Texture;
use crate::translate::Fidelity;
use crate::translate::fidelity::row;
use crate::translate::registry::{TARGETS, named};
use crate::translate::target::{Options, Output, Prepared, Target};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Translate a scene for another program
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Every translation ends with a report on standard error: what of the scene is approximate and by how
much, what is dropped, and how many features are exact; --verbose lists these too.

Examples:
  zpg convert scene.zpg --to pov -o scene.pov
  zpg convert scene.zpg --to mitsuba -o scene.xml
  zpg convert scene.zpg --to glb --tolerance 0.01
  zpg convert scene.zpg --to json | jq .nodes
  zpg convert made-by-a-program.json --to zpg")]
pub struct Args {
    /// The scene, as records or as JSON; `-` is standard input
    file: PathBuf,

    /// What to translate it to
    #[arg(long, value_name = "TO", value_parser = target())]
    to: &'static dyn Target,

    /// Where to write. If not given: standard output, and a mesh to SCENE.ply (obj, glb) in the
    /// current folder. A stereo pair is written to NAME_left and NAME_right; on standard output it is
    /// one file with a switch. Beside NAME.obj there are NAME.mtl and a picture of each texture,
    /// NAME_texture_0.png and so on; beside NAME.xml such pictures, and meshes NAME_1.ply and so on
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Size of the picture the camera is for, in pixels
    #[arg(long, default_value = "640x480", value_name = "WxH")]
    size: Size,

    /// How often a ray may be mirrored or refracted
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = usage::whole::<u32>)]
    depth: u32,

    /// How far meshes may be from curved surfaces, in scene units; by default a thousandth of the
    /// scene's size
    #[arg(long, value_name = "LEN", value_parser = length)]
    tolerance: Option<f64>,

    #[command(flatten)]
    memory: Memory,

    /// Report what is exact as well, each feature
    #[arg(short, long, conflicts_with = "quiet")]
    verbose: bool,

    /// Write the fidelity report as JSON, too
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// Takes the name of a target.
fn target() -> impl TypedValueParser<Value = &'static dyn Target> {
    let values = TARGETS.map(|t| PossibleValue::new(t.name()).help(t.help()));
    PossibleValuesParser::new(values).try_map(|name| named(&name).ok_or("no such target"))
}

/// A length on the command line.
pub(super) fn length(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-length", |x: f64| x > 0.0 && x.is_finite())
}

/// Reads the scene, translates it, says how well it went.
pub fn run(args: &Args, look: LookChoice) -> Status {
    if let Err(complaint) = args.memory.admit(&args.file, 1) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let needs = match args.to.draws() {
        true => Needs::Render,
        false => Needs::Nothing,
    };
    let loaded = match load_for(needs, &args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    let options = Options {
        size: (args.size.width, args.size.height),
        depth: args.depth,
        tolerance: args.tolerance,
        memory: args.memory.for_triangles(),
        confine: &|scene| args.memory.confine_scene(scene),
        file: &args.file,
        output: args.output.as_deref(),
    };
    let made = args.to.write(&Prepared::new(&loaded), &options);
    match made.and_then(|made| spare_sources(args, &loaded, made)) {
        Ok(made) => deliver(args, &made, look),
        Err(error) => refuse(&loaded, error, look),
    }
}

/// Refuses a translation that would be written over the scene itself or a picture that it names.
fn spare_sources(args: &Args, loaded: &Analysis, made: Output) -> Result<Output, Error> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let images: HashSet<PathBuf> = (loaded.scene.paints.iter())
        .filter_map(|paint| match &paint.texture {
            Some(Texture::Image { file, .. }) => folder.join(file).canonicalize().ok(),
            _ => None,
        })
        .collect();
    let written = made.files.iter().filter_map(|(path, _)| path.as_ref());
    // What is not there yet is none of them.
    let scene = args.file.canonicalize().ok();
    for path in written.chain(&args.report) {
        let Ok(there) = path.canonicalize() else {
            continue;
        };
        let what = match () {
            () if images.contains(&there) => "would-overwrite-image",
            () if scene.as_ref() == Some(&there) => "would-overwrite-scene",
            () => continue,
        };
        return Err(Error::Request(
            Complaint::new(what).with("path", path.as_path()),
        ));
    }
    Ok(made)
}

/// Writes the translation and its report.
fn deliver(args: &Args, made: &Output, look: LookChoice) -> Status {
    let written = (made.files.iter())
        .try_for_each(|(path, bytes)| match path {
            Some(path) => write_file(path, bytes),
            None => match io::stdout().lock().write_all(bytes) {
                // Nobody reads any more: that is their choice.
                Err(e) if e.kind() != io::ErrorKind::BrokenPipe => Err(unprintable(&e)),
                _ => Ok(()),
            },
        })
        .and_then(|()| match &args.report {
            Some(path) => {
                let text = format!("{:#}\n", made.report.to_json());
                write_file(path, text.as_bytes())
            }
            None => Ok(()),
        });
    let language = look.language();
    let said = match args.verbose {
        true => made.report.text(language),
        false => {
            let (inexact, exact) = made.report.brief();
            let count = [("count", Value::Count(exact as u64))];
            let line = language.say("fidelity-exact-count", &count);
            let is_said = exact > 0 && !look.quiet;
            let exact = is_said.then(|| row(&Fidelity::Exact, &line, language));
            inexact.text(language) + &exact.unwrap_or_default()
        }
    };
    // Nobody is left to be told when standard error is gone.
    let _ = write!(io::stderr(), "{said}");
    match written {
        Ok(()) => Status::Clean,
        Err(complaint) => {
            complain(look, &complaint);
            Status::Failure
        }
    }
}

fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    Draft::create(path)
        .and_then(|draft| draft.finish(path, |out| out.write_all(bytes)))
        .map_err(|e| unwritable(path, &e))
}
