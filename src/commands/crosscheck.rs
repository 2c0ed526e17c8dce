//! `zpg crosscheck`: our picture of a scene beside another program's.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::draft::{Draft, unwritable};
use super::size::Size;
use super::{Loaded, LookChoice, Status, complain, convert, load_sound, report, terminal};
use crate::diagnostics::{Complaint, Diagnostic};
use crate::scene::{Camera, View};
use crate::study::compare::{Comparison, side_by_side};
use crate::study::povray;
use crate::study::program::ProgramError;
use crate::study::silhouette::{Studied, study};
use crate::trace::film::write_rgb8;
use crate::trace::{self, Film, Images, Settings, Tracer, selected_camera};
use crate::translate::{self, pov};

/// Compare our picture of a scene with that of another program
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The scene is translated, the program takes its picture, and the two are compared pixel by pixel in
linear light. On silhouettes, where an edge goes through the middle of a pixel, what one sample shows
is up to rounding; and POV-Ray treats total internal reflection in another way: both are counted by
themselves. The answer is \"no\", with exit status 1, when more than 0.05 % of the pixels differ
elsewhere.

In DIR are then ours.png, theirs.png, difference.png (green: alike, red: differing, grey: silhouettes,
blue: total reflection), side-by-side.png, crosscheck.json, and the translation; with _left and _right
for a pair of cameras.

Examples:
  zpg crosscheck scene.zpg --with povray
  zpg crosscheck scene.zpg --with povray --size 640x480 -o compared --max-diff 1")]
pub struct Args {
    /// The scene
    file: PathBuf,

    /// The program
    #[arg(long, value_enum)]
    with: Program,

    /// Size of the pictures, in pixels
    #[arg(long, default_value = "320x240", value_name = "WxH")]
    size: Size,

    /// The folder for pictures and numbers; SCENE-povray if not given
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// By how much a channel of a pixel may differ, in 255ths of white
    #[arg(long, default_value_t = 2.0, value_name = "N", value_parser = difference)]
    max_diff: f64,

    /// How often a ray may be mirrored or refracted
    #[arg(long, default_value_t = 10, value_name = "N")]
    depth: u32,

    /// Where the program is, if it is not found by its name
    #[arg(long, value_name = "PATH")]
    program: Option<PathBuf>,

    /// Print the numbers as JSON
    #[arg(long)]
    json: bool,
}

/// The programs to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Program {
    /// POV-Ray 3.7
    Povray,
}

/// The largest share of pixels that may differ off silhouettes.
const SHARE: f64 = 0.0005;

fn difference(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x > 0.0 && x <= 255.0 => Ok(x),
        _ => Err("expected a number above 0, up to 255".to_owned()),
    }
}

/// Why there is nothing to compare.
enum Failure {
    Scene(trace::Unsupported),
    Translation(translate::Unsupported),
    Image(Box<Diagnostic>),
    Other(Complaint),
}

impl From<trace::Unsupported> for Failure {
    fn from(e: trace::Unsupported) -> Failure {
        Failure::Scene(e)
    }
}

impl From<Complaint> for Failure {
    fn from(e: Complaint) -> Failure {
        Failure::Other(e)
    }
}

/// The numbers of a run.
#[derive(Serialize)]
struct Answer {
    scene: String,
    with: &'static str,
    size: [u32; 2],
    /// In linear light, where 1 is white.
    max_diff: f64,
    agrees: bool,
    pictures: Vec<Compared>,
}

/// A picture of a camera.
#[derive(Serialize)]
struct Compared {
    /// `_left`, `_right`, or nothing.
    name: &'static str,
    #[serde(flatten)]
    comparison: Comparison,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let mut loaded = match load_sound(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    let failure = match compare(args, &loaded) {
        Ok((answer, folder)) => {
            let status = match answer.agrees {
                true => Status::Clean,
                false => Status::Negative,
            };
            return terminal::print(look, status, |out| match args.json {
                true => {
                    serde_json::to_writer_pretty(&mut *out, &answer)?;
                    writeln!(out)
                }
                false => print(out, &answer, &folder),
            });
        }
        Err(failure) => failure,
    };
    match failure {
        Failure::Scene(e) => {
            loaded.refuse(&args.file, e.span, e.complaint(), look);
            Status::Negative
        }
        Failure::Translation(e) => convert::refuse(&loaded, &e, look),
        Failure::Image(error) => {
            loaded.diagnostics = vec![*error];
            report(&loaded, look);
            Status::Negative
        }
        Failure::Other(complaint) => {
            complain(look, &complaint);
            Status::Failure
        }
    }
}

/// Takes, compares and writes all pictures; says where they are.
fn compare(args: &Args, loaded: &Loaded) -> Result<(Answer, PathBuf), Failure> {
    let scene = &loaded.scene;
    let size = (args.size.width, args.size.height);
    let bar = args.max_diff / 255.0;
    let options = pov::Options {
        size,
        depth: args.depth,
        pictures: convert::pictures(&args.file, None),
        stereo: pov::Stereo::TwoFiles,
    };
    let translation = pov::write(scene, &options).map_err(Failure::Translation)?;
    let images = Images::load(scene, loaded.source.folder().unwrap_or(Path::new(".")))
        .map_err(Failure::Image)?;
    let tracer = Tracer::with_images(scene, &images)?;
    let settings = Settings {
        width: size.0,
        height: size.1,
        depth: args.depth,
        cutoff: 0.0,
        ..Settings::default()
    };
    let stem = args.file.file_stem().unwrap_or("scene".as_ref());
    let stem = stem.to_string_lossy().into_owned();
    let folder = (args.output.clone()).unwrap_or_else(|| PathBuf::from(format!("{stem}-povray")));
    fs::create_dir_all(&folder).map_err(|e| unwritable(&folder, &e))?;
    let program = args
        .program
        .as_deref()
        .unwrap_or(Path::new(povray::PROGRAM));

    let mut pictures = Vec::new();
    for (i, camera) in cameras(loaded, size).iter().enumerate() {
        let suffix = translation.files[i].suffix;
        let name = format!("{stem}{suffix}");
        let theirs = povray::render(program, &translation, i, size, &folder, &name)
            .map_err(|e| failed(e, &folder))?;
        // Half the bar each way: two pictures that are an edge apart differ by all of it.
        let ours = study(&tracer, camera, &settings, bar / 2.0)?;
        let most = (1.0 / translation.light_scale) as f32;
        let comparison = Comparison::new(&ours, &theirs, most, bar);
        write_pictures(&folder, suffix, &ours, &theirs, &comparison)?;
        pictures.push(Compared {
            name: suffix,
            comparison,
        });
    }
    let agrees = |c: &Compared| c.comparison.differing.share_off_silhouettes <= SHARE;
    let answer = Answer {
        scene: args.file.to_string_lossy().into_owned(),
        with: "povray",
        size: size.into(),
        max_diff: bar,
        agrees: pictures.iter().all(agrees),
        pictures,
    };
    write_file(&folder.join("crosscheck.json"), |out| {
        serde_json::to_writer_pretty(&mut *out, &answer)?;
        writeln!(out)
    })?;
    Ok((answer, folder))
}

/// The cameras that take the picture: one, or left and right.
fn cameras(loaded: &Loaded, size: (u32, u32)) -> Vec<Camera> {
    let scene = &loaded.scene;
    if let View::Stereo { left, right } = scene.view
        && let (Some(left), Some(right)) = (scene.cameras.get(left), scene.cameras.get(right))
    {
        return vec![*left, *right];
    }
    let aspect = f64::from(size.0) / f64::from(size.1);
    vec![selected_camera(scene, aspect)]
}

fn failed(error: ProgramError, folder: &Path) -> Complaint {
    let name = povray::PROGRAM;
    match error {
        ProgramError::Missing => Complaint::new("no-program")
            .with("program", "POV-Ray")
            .with(
                "how",
                "`apt-get install povray`, `brew install povray`, https://www.povray.org",
            ),
        ProgramError::Io(e) => unwritable(folder, &e),
        ProgramError::Failed(said) => Complaint::new("program-failed")
            .with("program", name)
            .with("said", said.replace('\n', "\n    ")),
        ProgramError::Unexpected(what) => Complaint::new("program-strange")
            .with("program", name)
            .with("what", what),
    }
}

fn write_pictures(
    folder: &Path,
    suffix: &str,
    ours: &Studied,
    theirs: &Film,
    comparison: &Comparison,
) -> Result<(), Complaint> {
    let path = |name: &str| folder.join(format!("{name}{suffix}.png"));
    let film = &ours.picture.film;
    let (w, h) = (theirs.width, theirs.height);
    write_file(&path("ours"), |out| film.write_png(out))?;
    write_file(&path("theirs"), |out| theirs.write_png(out))?;
    write_file(&path("difference"), |out| {
        write_rgb8(out, w, h, &comparison.picture())
    })?;
    write_file(&path("side-by-side"), |out| {
        write_rgb8(out, 3 * w, h, &side_by_side(film, theirs, comparison))
    })
}

fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Complaint> {
    Draft::create(path)
        .and_then(|draft| draft.finish(path, write))
        .map_err(|e| unwritable(path, &e))
}

/// The answer for people.
fn print(out: &mut dyn Write, answer: &Answer, folder: &Path) -> io::Result<()> {
    let bar = answer.max_diff * 255.0;
    for Compared {
        name,
        comparison: c,
    } in &answer.pictures
    {
        let [width, height] = answer.size;
        let agrees = match c.differing.share_off_silhouettes <= SHARE {
            true => "agrees",
            false => "DIFFERS",
        };
        writeln!(
            out,
            "{}{name} with {}, {width}x{height}: {agrees}",
            answer.scene, answer.with
        )?;
        writeln!(
            out,
            "  off silhouettes    {} pixels differ by more than {bar}/255 ({:.3} %); \
             the largest difference is {:.2}/255, the mean {:.3}/255",
            c.differing.off_silhouettes,
            100.0 * c.differing.share_off_silhouettes,
            255.0 * c.difference.largest,
            255.0 * c.difference.mean,
        )?;
        writeln!(
            out,
            "  on silhouettes     {} of {} pixels differ",
            c.differing.on_silhouettes, c.silhouettes
        )?;
        writeln!(
            out,
            "  total reflection   in {} pixels, not compared: POV-Ray has it otherwise",
            c.total_reflection
        )?;
        writeln!(out, "  FLIP               {:.4}", c.flip)?;
    }
    writeln!(out, "Pictures and numbers are in {}", folder.display())
}
