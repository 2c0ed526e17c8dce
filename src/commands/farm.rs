//! `zpg farm`: writes a job for an engine that runs tasks on many machines.

mod engine;
mod measure;
mod options;
mod scenes;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Command;

use super::frames::Frames;
use super::paths;
use super::render::frames::check_each;
use super::render::options::PictureArgs;
use super::terminal::{self, LookChoice, complain};
use super::time::Seconds;
use super::{Status, load_valid, refuse, usage};
use crate::analysis::config::Configs;
use crate::diagnostics::layout::wrapped;
use crate::diagnostics::{Complaint, Error, Value};
use crate::study::accuracy::number_format;
use engine::{Engine, Work};
use measure::Measured;
use scenes::Scene;

/// Write a job that draws pictures on many machines
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The job is a folder with the scenes and their textures, scripts that draw and join, what the engine reads, and a README
that says how to start it. Nothing in it is about this machine. A large picture is divided into bands of rows, as many as
take about --tile-time each on --cores: some seconds of drawing tell. A task that is done is not done again, and the
pictures have the bytes of those that one machine draws. Of several scenes, those with errors are not drawn, and a sheet
of all pictures with what is wrong with their scenes is made at the end. All options that say what a picture looks like
are those of `zpg render`.

Examples:
  zpg farm scene.zpg --size 8000x6000 --quality final -o job --for slurm
  zpg farm scene.zpg --frames 0-599 --orbit 9,360 -o job --for openjd
  zpg farm submissions -o job --for shell")]
pub struct Args {
    /// Scenes, as records or as JSON, or folders with scenes
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// The folder of the job, which is made
    #[arg(short, long, value_name = "JOB")]
    output: PathBuf,

    /// What runs the job
    #[arg(long = "for", value_enum, value_name = "ENGINE")]
    engine: Engine,

    /// Bands of each picture [default: as many as --tile-time asks for]
    #[arg(long, value_name = "N", value_parser = at_least_one, allow_negative_numbers = true)]
    tiles: Option<u32>,

    /// About how long a task takes
    #[arg(
        long,
        value_name = "TIME",
        default_value = "2m",
        allow_hyphen_values = true
    )]
    tile_time: Seconds,

    /// Processors of a task
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = at_least_one, allow_negative_numbers = true)]
    cores: u32,

    /// The format of the pictures
    #[arg(long, value_enum, default_value = "png")]
    format: Ending,

    #[command(flatten)]
    picture: PictureArgs,
}

/// The formats of pictures that are drawn in bands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Ending {
    /// 8-bit sRGB
    Png,
    /// Linear, unclamped, 32-bit float
    Exr,
}

fn at_least_one(text: &str) -> Result<u32, Complaint> {
    usage::number(text, "expected-number-from-one", |n| {
        (1..=1_000_000).contains(&n)
    })
}

/// Runs `zpg farm`: writes the job's folder and prints a summary. `command` is clap's definition of the whole program.
pub fn run(args: &Args, command: Command, look: LookChoice) -> Status {
    let configs = Configs::default().into();
    let found = paths::expand(&args.paths, &configs, look);
    if found.failed || found.files.is_empty() {
        return Status::Failure;
    }
    // Scenes in the folder of the job are copies that an earlier job has left.
    let (copies, files) = scenes::in_folder(&args.output, found.files);
    let places = scenes::places(&args.paths, files);
    let checked = match copies.first() {
        Some(copy) if places.is_empty() => {
            Err(Complaint::new("would-overwrite-scene").with("path", copy.as_path()))
        }
        _ => scenes::check_places(&places).and_then(|()| args.picture.frames.check()),
    };
    if let Err(complaint) = checked {
        complain(look, &complaint);
        return Status::Failure;
    }
    let is_class = places.len() > 1;
    let mut scenes = Vec::new();
    let mut broken = Vec::new();
    for (path, place) in places {
        let start = Instant::now();
        match load_valid(&path, look) {
            Ok(loaded) => scenes.push(Scene {
                path,
                place,
                loaded,
                reading: start.elapsed().as_secs_f64(),
            }),
            Err(status) if !is_class || status == Status::Failure => return status,
            // Scenes with errors go with the job, so that the sheet can say what is wrong with them.
            Err(_) => broken.push((path, place)),
        }
    }
    let Some(first) = scenes.first() else {
        return Status::Negative;
    };
    let frames = match frames(args, &scenes, look) {
        Ok(frames) => frames,
        Err(status) => return status,
    };
    let options = options::given(command);
    match job(args, options, (&scenes, frames.as_ref()), &broken, look) {
        Ok(said) if look.quiet => drop(said),
        Ok(said) => {
            return terminal::print(look, Status::Clean, |out| writeln!(out, "{said}"));
        }
        Err(error) => return refuse(&first.loaded, error, look),
    }
    Status::Clean
}

/// The frames, which are the same for all scenes and have been checked in each. `None` if each scene has one picture.
/// `Err` is the exit status; the complaint has been printed.
fn frames(args: &Args, scenes: &[Scene], look: LookChoice) -> Result<Option<Frames>, Status> {
    if let Some(told) = args.picture.frames.note() {
        terminal::note(look, &told);
    }
    // Ctrl-C ends the program at once, and nothing sets this flag.
    let stop = AtomicBool::new(false);
    let mut first = None;
    for scene in scenes.iter().filter(|_| args.picture.frames.are_given()) {
        let frames = Frames::of(&args.picture.frames, &scene.loaded);
        let frames = frames.map_err(|error| refuse(&scene.loaded, error, look))?;
        check_each(&frames, &scene.loaded, &stop, look)?;
        first.get_or_insert(frames);
    }
    Ok(first)
}

/// Writes the folder of the job. Returns the text to print about it.
fn job(
    args: &Args,
    options: String,
    (scenes, frames): (&[Scene], Option<&Frames>),
    broken: &[(PathBuf, PathBuf)],
    look: LookChoice,
) -> Result<String, Error> {
    let is_class = scenes.len() + broken.len() > 1;
    let is_job = scenes::check_folder(&args.output)?;
    scenes::check_pictures(scenes)?;
    let count = frames.map_or(1, Frames::count);
    let measured = measure::measure(&args.picture, scenes, args.tile_time.0)?;
    let tiles = measured.tiles(args.tiles, args.tile_time.0 * f64::from(args.cores))?;
    let pictures = u32::try_from(scenes.len()).unwrap_or(u32::MAX);
    let tasks = [count, tiles]
        .into_iter()
        .try_fold(pictures, u32::checked_mul);
    let tasks = tasks.ok_or_else(|| Complaint::new("too-many-tasks"))?;
    let each = measured.seconds(tiles, args.cores);
    // A user who chooses the number of bands wants one band a run, and make shares single tasks among its processes.
    let chunk = match (args.tiles, args.engine) {
        (Some(_), _) | (_, Engine::Shell) => 1,
        (None, _) => (args.tile_time.0 / each).clamp(1.0, f64::from(tasks)) as u32,
    };
    let chunk = chunk.max(args.engine.least_chunk(tasks));
    let summary = summary(args, &measured, (tasks, tiles, chunk), look);
    let work = Work {
        name: scenes::name(&scenes[0].place),
        summary: summary.clone(),
        options,
        ending: match args.format {
            Ending::Png => "png",
            Ending::Exr => "exr",
        },
        tasks,
        tiles,
        is_framed: frames.is_some(),
        frames: count,
        first_frame: frames.map_or(0, |frames| *frames.drawn().start()),
        digits: frames.map_or(4, |frames| frames.label(0).len()),
        chunk,
        cores: args.cores,
        megabytes: measured.megabytes(tiles),
        minutes: minutes(3.0 * each * f64::from(chunk)),
        join_minutes: minutes(measured.join * f64::from(pictures) * f64::from(count)),
        is_class,
    };
    scenes::copy(&args.output, scenes, broken)?;
    options::copy_table(&args.picture.frames, &args.output)?;
    args.engine.write(&work, look.language(), &args.output)?;
    if is_job {
        terminal::note(
            look,
            &Complaint::new("note-earlier-job").with("path", args.output.as_path()),
        );
    }
    let wrote = Complaint::new("wrote-file").with("path", args.output.as_path());
    let readme = args.output.join("README.md").display().to_string();
    let next = look.language().say("farm-next", &[("path", readme.into())]);
    let summary = wrapped(&format!("{summary} {next}"), terminal::width(), "");
    Ok(format!("{}\n{summary}", wrote.wording(look.language())))
}

/// A time limit in minutes: rounded up, and never short.
fn minutes(seconds: f64) -> u64 {
    (seconds / 60.0).ceil().max(10.0) as u64
}

/// A summary of a job, in a few sentences.
fn summary(
    args: &Args,
    measured: &Measured,
    (tasks, tiles, chunk): (u32, u32, u32),
    look: LookChoice,
) -> String {
    let language = look.language();
    let time = |seconds: f64| Value::from(number_format::seconds(language, seconds));
    let each = measured.seconds(tiles, args.cores);
    let values = [
        ("tasks", Value::Count(tasks.into())),
        ("tiles", Value::Count(tiles.into())),
        ("cores", Value::Count(args.cores.into())),
        ("chunk", Value::Count(chunk.into())),
        ("each", time(each)),
        ("build", time(measured.build)),
        ("all", time(each * f64::from(tasks) * f64::from(args.cores))),
    ];
    language.say("farm-summary", &values)
}
