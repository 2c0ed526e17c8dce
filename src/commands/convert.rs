//! `zpg convert`: the scene for other programs.

use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::atomic_file::{self, try_file};
use super::camera::CameraArgs;
use super::endings;
use super::habits;
use super::help;
use super::memory::Memory;
use super::paths::is_stdout;
use super::refuse_overwrite::refuse_overwrite;
use super::size::Size;
use super::terminal::{note, tell, width};
use super::{LookChoice, Needs, Status, complain, load_for, refuse, usage};
use crate::analysis::file::STDIN;
use crate::diagnostics::layout::hanging;
use crate::diagnostics::{Complaint, Error, Value};
use crate::scene::{Scene, View};
use crate::solids::staging::is_dark;
use crate::translate::Fidelity;
use crate::translate::fidelity::row;
use crate::translate::registry::{TARGETS, named, of_file};
use crate::translate::target::{Options, Output, OutputKind, Prepared, Target};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Translate a scene for another program
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Every translation ends with a report on standard error: what of the scene is approximate and by how
much, what is dropped, and how many features are exact; --verbose lists these too.

Examples:
  zpg convert scene.zpg -o scene.pov
  zpg convert scene.zpg -o scene.xml
  zpg convert scene.zpg -o scene.glb --tolerance 0.01
  zpg convert scene.zpg --to stl -o - | gzip > scene.stl.gz
  zpg convert scene.zpg --to json | jq .nodes
  zpg convert made-by-a-program.json --to zpg")]
pub struct Args {
    /// The scene, as records or as JSON; `-` is standard input
    file: PathBuf,

    /// What to translate it to; if not given, what the ending of -o stands for
    #[arg(long, value_name = "TO", value_parser = target())]
    to: Option<&'static dyn Target>,

    /// Where to write; `-` is standard output. If not given: standard output, and a mesh to SCENE.ply (obj, glb, stl) in the
    /// current folder. A stereo pair is written to NAME_left and NAME_right; on standard output it is
    /// one file with a switch. Beside NAME.obj there are NAME.mtl and a picture of each texture,
    /// NAME_texture_N.png; beside NAME.xml such pictures, and meshes NAME_1.ply and so on; beside NAME.pov the
    /// scene's pictures, NAME_image_N.png. In the names beside .obj and .pov, what is no letter of ASCII, digit, -, _
    /// or . is replaced
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Write a scene (--to zpg) over a file that is there already
    #[arg(long)]
    force: bool,

    /// Size of the picture the camera is for, in pixels
    #[arg(help_heading = help::PICTURE)]
    #[arg(
        long,
        default_value = "640x480",
        value_name = "WxH",
        allow_hyphen_values = true
    )]
    size: Size,

    #[command(flatten)]
    camera: CameraArgs,

    /// How often a ray may be mirrored or refracted
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    depth: u32,

    /// How far meshes may be from curved surfaces, in scene units; by default a thousandth of the
    /// scene's size
    #[arg(long, value_name = "LEN", value_parser = length, allow_negative_numbers = true)]
    tolerance: Option<f64>,

    #[command(flatten)]
    memory: Memory,

    /// Report what is exact as well, each feature
    #[arg(help_heading = help::REPORTS)]
    #[arg(short, long, conflicts_with = "quiet")]
    verbose: bool,

    /// Write the fidelity report as JSON, too; `-` is standard output
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// The parser of `--to`, which takes the name of a target.
fn target() -> impl TypedValueParser<Value = &'static dyn Target> {
    let values = TARGETS.map(|t| PossibleValue::new(t.name()).help(t.help()));
    PossibleValuesParser::new(values).try_map(|name| named(&name).ok_or("no such target"))
}

/// Reads a length from the command line: a finite number above 0.
pub(super) fn length(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-length", |x: f64| x > 0.0 && x.is_finite())
}

/// Reads the scene, translates it, says how well it went.
pub fn run(args: &Args, look: LookChoice) -> Status {
    if let Err(complaint) = args.memory.admit(&args.file, 1) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let named = args.output.as_deref().and_then(of_file);
    let Some(to) = args.to.or(named) else {
        let is_gltf = |path: &Path| {
            path.extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("gltf"))
        };
        if let Some(path) = args.output.as_deref().filter(|path| is_gltf(path)) {
            let binary = path.with_extension("glb");
            complain(
                look,
                &Complaint::new("gltf-is-glb").with("path", binary.as_path()),
            );
            return Status::Failure;
        }
        let picture = args.output.as_deref();
        if let Some(instead) = picture.and_then(|path| habits::picture(path, &args.file)) {
            complain(look, &instead);
            return Status::Failure;
        }
        let complaint = Complaint::new("no-target");
        complain(
            look,
            &complaint.with("names", TARGETS.map(|t| t.name()).join(", ")),
        );
        return Status::Failure;
    };
    // Files that cannot be written are refused before anything is read.
    if let Err(complaint) = can_write(args, to) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let outputs = [&args.output, &args.report].into_iter().flatten();
    let on_stdout = outputs.filter(|path| is_stdout(path)).count();
    let is_text = to.form() == OutputKind::Text;
    if on_stdout > 1 || on_stdout > 0 && args.output.is_none() && is_text {
        complain(look, &Complaint::new("two-on-stdout"));
        return Status::Failure;
    }
    let needs = match to.draws() {
        true => Needs::Render,
        false => Needs::Nothing,
    };
    let loaded = match load_for(needs, &args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    let viewpoint = match args.camera.viewpoint(&loaded.scene) {
        Ok(viewpoint) => viewpoint,
        Err(error) => return refuse(&loaded, error, look),
    };
    let options = Options {
        viewpoint,
        size: (args.size.width, args.size.height),
        depth: args.depth,
        tolerance: args.tolerance,
        memory: args.memory.for_triangles(),
        confine: &|scene| args.memory.confine_scene(scene),
        file: &args.file,
        language: look.language(),
        // Without an output file, a mesh is named after the scene.
        output: (args.output.as_deref()).filter(|path| !is_text || !is_stdout(path)),
    };
    let made = to
        .write(&Prepared::new(&loaded), &options)
        .map(on_stdout_if_asked);
    let spared = made.and_then(|made| {
        let files = made.files.iter().filter_map(|(path, _)| path.as_deref());
        refuse_overwrite(
            &args.file,
            &loaded,
            files.chain(args.report.as_deref().filter(|path| !is_stdout(path))),
        )
        .and_then(|()| match options.output {
            Some(path) if to.makes_scenes() && !args.force => endings::is_new_scene(path),
            _ => Ok(()),
        })
        .map_err(Error::Request)?;
        Ok(made)
    });
    match spared {
        Ok(made) => {
            if to.adds_what_is_lacking() && !look.quiet {
                say_added(args, &loaded.scene, look);
            }
            deliver(args, &made, look)
        }
        Err(error) => refuse(&loaded, error, look),
    }
}

/// Notes that the translation adds a camera or a light that the scene lacks.
fn say_added(args: &Args, scene: &Scene, look: LookChoice) {
    if scene.view == View::Automatic && !args.camera.is_given() {
        note(look, &Complaint::new("note-no-camera"));
    }
    if is_dark(scene) {
        note(look, &Complaint::new("note-no-light"));
    }
}

/// Makes sure that the output and the report can be written.
fn can_write(args: &Args, to: &dyn Target) -> Result<(), Complaint> {
    let output = args.output.as_deref().filter(|path| !is_stdout(path));
    if args.output.as_deref().is_some_and(is_stdout) {
        let refused = match to.form() {
            OutputKind::Files => Some("mesh-on-stdout"),
            OutputKind::Binary if io::stdout().is_terminal() => Some("binary-on-terminal"),
            OutputKind::Binary | OutputKind::Text => None,
        };
        refused.map_or(Ok(()), |why| Err(Complaint::new(why)))?;
    }
    output.map_or(Ok(()), |path| endings::fits(path, &[to.ending()]))?;
    (args.report.iter()).try_for_each(|path| endings::fits(path, &["json"]))?;
    let mut named = output.into_iter().chain(args.report.as_deref());
    named.try_for_each(try_file)
}

/// Takes the path from a file that is called `-`: a file without a path goes to standard output.
fn on_stdout_if_asked(mut made: Output) -> Output {
    for (path, _) in &mut made.files {
        path.take_if(|path| is_stdout(path));
    }
    made
}

/// Writes the translation and its report, and prints how exact the translation is.
fn deliver(args: &Args, made: &Output, look: LookChoice) -> Status {
    let report = args.report.as_ref().map(|path| {
        let text = format!("{:#}\n", made.report.to_json());
        (Some(path.clone()), text.into_bytes())
    });
    let written = write(made.files.iter().chain(&report));
    let language = look.language();
    let said = match args.verbose {
        _ if look.quiet => String::new(),
        true => made.report.text(language),
        false => {
            let (inexact, exact) = made.report.brief();
            let count = [("count", Value::Count(exact as u64))];
            let line = language.say("fidelity-exact-count", &count);
            let exact = (exact > 0).then(|| row(&Fidelity::Exact, &line, language));
            inexact.text(language) + &exact.unwrap_or_default()
        }
    };
    // Nobody is left to be told when standard error is gone.
    let mut lines = said.lines().map(|line| hanging(line, width()));
    let _ = lines.try_for_each(|line| writeln!(io::stderr(), "{line}"));
    match written {
        Ok(()) if look.quiet => Status::Clean,
        Ok(()) => say_written(made.files.iter().chain(&report), look),
        Err(complaint) => {
            complain(look, &complaint);
            Status::Failure
        }
    }
}

/// Names the written files on standard error, as one of them may be the device that standard output goes to.
fn say_written<'f>(
    files: impl Iterator<Item = &'f (Option<PathBuf>, Vec<u8>)>,
    look: LookChoice,
) -> Status {
    let named = files.filter_map(|(path, _)| path.as_deref());
    for path in named.filter(|path| !is_stdout(path) && path.is_file()) {
        let line = Complaint::new("wrote-file").with("path", path);
        tell(&line.wording(look.language()));
    }
    Status::Clean
}

/// Writes all files, or none if one of them cannot be begun. A file without a path goes to standard output.
fn write<'f>(
    files: impl Iterator<Item = &'f (Option<PathBuf>, Vec<u8>)> + Clone,
) -> Result<(), Complaint> {
    let mut paths = files.clone().filter_map(|(path, _)| path.as_deref());
    paths.try_for_each(try_file)?;
    for (path, bytes) in files {
        let path = path.as_deref().unwrap_or(Path::new(STDIN));
        atomic_file::write(path, |out| out.write_all(bytes))?;
    }
    Ok(())
}
