//! `zpg render`: the reference ray tracer.

mod animation;
mod cost;
mod fingerprint;
mod frames;
mod notes;
mod output;
mod picture;
mod stats;
mod tile;
mod unfinished;

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::camera::CameraArgs;
use super::frames::FrameArgs;
use super::help;
use super::memory::{self, Memory};
use super::paths::{self, is_stdout};
use super::size::Size;
use super::terminal::{self, stop_on_interrupt, tell};
use super::{LookChoice, Status, complain, load_sound, refuse, usage, watch};
use crate::analysis::config::Configs;
use crate::diagnostics::Complaint;
use crate::parallel;
use crate::trace::{Crop, Numbers};
use output::places;
use tile::Tile;

/// Draw scenes
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Without -o the picture of SCENE.zpg is written to SCENE.png in the current folder. PNG, WebP (lossless) and JPEG
are 8-bit sRGB, EXR and PFM are linear, unclamped 32-bit float. What is written is said on standard output; with
`-o -` the PNG itself goes there. What is wrong with a picture, such as nothing in view, is said on standard error.
A scene with a stereo camera makes two pictures, SCENE_left.png and SCENE_right.png, unless --stereo says otherwise.
Several scenes, or those of a folder, go into the folder that -o names. Frames go into NAME.0000.png and so on; each
is the picture of the scene with its numbers written in. Ctrl-C leaves the rows that are drawn in NAME.part.exr beside
the picture, and --resume draws the others.

Examples:
  zpg render scene.zpg
  zpg render scene.zpg -o big.png --size 1920x1080 --quality good
  zpg render scene.zpg --view top --watch
  zpg render scenes -o pictures
  zpg render scene.zpg -o film.exr --adaptive 0.01
  zpg render scene.zpg -o scene.jpg --exposure 0.7
  zpg render scene.zpg -o orbit.png --frames 0-99 --orbit 9,360
  zpg render scene.zpg -o zoom.apng --frames 0-24 --set 9.fovy=60..20
  zpg render scene.zpg --cost
  zpg render scene.zpg --crop 200,100,64,64 --stats cost.json
  zpg render scene.zpg -o bands/3.png --tile 3/8")]
pub struct Args {
    /// Scenes, as records or as JSON, or folders with scenes; `-` is standard input
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// Where to write the picture: .png, .jpg, .webp, .exr or .pfm; `-` is standard output. Or a folder; or an .apng of
    /// frames
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Draw again whenever the scene, or a picture that it names, changes
    #[arg(short, long)]
    watch: bool,

    /// Width and height in pixels
    #[arg(help_heading = help::PICTURE)]
    #[arg(
        long,
        value_name = "WxH",
        default_value = "640x480",
        allow_hyphen_values = true
    )]
    size: Size,

    /// How smooth edges are [default: draft]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_enum, value_name = "QUALITY", conflicts_with_all = ["samples", "adaptive"])]
    quality: Option<Quality>,

    /// Samples in each pixel; one lies in its centre
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "N", value_parser = samples, allow_negative_numbers = true)]
    samples: Option<u32>,

    /// Up to 1024 samples, until a pixel's estimated error in linear RGB is below this
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "TOL", value_parser = tolerance, allow_negative_numbers = true, conflicts_with = "samples")]
    adaptive: Option<f64>,

    /// Make everything so many times as bright
    #[arg(long, value_name = "TIMES", value_parser = exposure, allow_negative_numbers = true)]
    exposure: Option<f64>,

    /// How often a ray may be reflected or refracted
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    depth: u32,

    /// Leave out what counts for less than this; 0 leaves out nothing [default: 1/4096]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "W", value_parser = cutoff, allow_negative_numbers = true)]
    cutoff: Option<f64>,

    /// The numbers to compute with between a ray and what it hits
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_enum, default_value = "f64")]
    precision: Numbers,

    /// Draw this part of the picture only
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_name = "X,Y,W,H", allow_hyphen_values = true)]
    crop: Option<CropArg>,

    /// Draw this band of rows only, such as 3/8 or 3-5/8; `zpg join` puts bands together
    #[arg(help_heading = help::MACHINES)]
    #[arg(long, value_name = "I/N", requires = "output", conflicts_with_all = ["watch", "heatmap", "cost"], allow_hyphen_values = true)]
    tile: Option<Tile>,

    /// Skip what is drawn already, and go on with what an interrupted run has left
    #[arg(help_heading = help::MACHINES)]
    #[arg(long, conflicts_with_all = ["watch", "heatmap", "cost", "stats"])]
    resume: bool,

    #[command(flatten)]
    camera: CameraArgs,

    #[command(flatten)]
    frames: FrameArgs,

    /// How the two pictures of a stereo camera are put [default: pair]
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, value_enum)]
    stereo: Option<Stereo>,

    /// Threads to work with; 0: as many as there are processors. At most four times as many
    #[arg(help_heading = help::LIMITS)]
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = usage::whole::<usize>, allow_negative_numbers = true)]
    threads: usize,

    #[command(flatten)]
    memory: Memory,

    /// Write what it has cost to this file, as JSON: times, rays, tests, the work of each effect; `-` is standard output
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,

    /// Print what it has cost and where: rays, time, the dearest objects and effects
    #[arg(help_heading = help::REPORTS)]
    #[arg(long)]
    cost: bool,

    /// Draw how many intersection tests each pixel took, in false colours
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, value_name = "OUT.png")]
    heatmap: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
enum Stereo {
    /// Two files, NAME_left and NAME_right
    #[default]
    Pair,
    /// One picture, left beside right
    SideBySide,
    /// One picture for red and cyan glasses
    Anaglyph,
}

/// Points on the front of time and error, as `zpg accuracy` measures it; see `scenes/accuracy`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
enum Quality {
    /// One sample in each pixel
    #[default]
    Draft,
    /// --adaptive 0.05: about ten times the time, a quarter of the error
    Good,
    /// --adaptive 0.01: about twenty times the time, a tenth of the error
    Final,
}

/// How many samples a pixel takes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sampling {
    Fixed(u32),
    Adaptive(f64),
}

impl Quality {
    fn sampling(self) -> Sampling {
        match self {
            Quality::Draft => Sampling::Fixed(1),
            Quality::Good => Sampling::Adaptive(0.05),
            Quality::Final => Sampling::Adaptive(0.01),
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct CropArg(Crop);

impl FromStr for CropArg {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<CropArg, Complaint> {
        let numbers: Result<Vec<u32>, _> = s.split(',').map(|n| n.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x, y, width, height]) if width > 0 && height > 0 => Ok(CropArg(Crop {
                x,
                y,
                width,
                height,
            })),
            _ => Err(Complaint::new("expected-crop")),
        }
    }
}

fn samples(text: &str) -> Result<u32, Complaint> {
    usage::number(text, "expected-samples", |n| (1..=1_048_576).contains(&n))
}

impl Args {
    /// How many of the outputs go to standard output.
    fn outputs_on_stdout(&self) -> usize {
        let all = [&self.output, &self.stats];
        let named = all.into_iter().flatten();
        named.filter(|path| is_stdout(path)).count()
    }

    fn sampling(&self) -> Sampling {
        match (self.samples, self.adaptive) {
            (Some(samples), _) => Sampling::Fixed(samples),
            (None, Some(tolerance)) => Sampling::Adaptive(tolerance),
            (None, None) => self.quality.unwrap_or_default().sampling(),
        }
    }
}

/// A number from 0 to 1, or a fraction as `--help` has it.
fn cutoff(text: &str) -> Result<f64, Complaint> {
    let number = |text: &str| usage::number(text, "expected-cutoff", |x: f64| x >= 0.0);
    let value = match text.split_once('/') {
        Some((part, whole)) => number(part)? / number(whole)?,
        None => number(text)?,
    };
    match (0.0..=1.0).contains(&value) {
        true => Ok(value),
        false => Err(Complaint::new("expected-cutoff")),
    }
}

fn tolerance(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-tolerance", |x| x > 0.0 && x <= 1.0)
}

fn exposure(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-exposure", |x: f64| x > 0.0 && x.is_finite())
}

/// A scene, and where its picture goes.
struct Job {
    scene: PathBuf,
    picture: PathBuf,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    if let Err(why) = parallel::take_part(memory::threads(args.threads, look)) {
        let complaint = Complaint::new("no-threads").with("reason", why.to_string());
        complain(look, &complaint);
        return Status::Failure;
    }
    let is_one = args.paths.len() == 1 && !args.paths[0].is_dir();
    if let Err(complaint) = frames::check(args, is_one) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let stop = stop_on_interrupt(look);
    // What was drawn last is no reason to draw again.
    let drawn = RefCell::new(Vec::new());
    let all = || {
        let Some(jobs) = jobs(args, look) else {
            return Status::Failure;
        };
        if args.frames.are_given() {
            return frames::run(args, &jobs, &stop, look);
        }
        drawn.replace(jobs.iter().map(|job| job.picture.clone()).collect());
        let wanted = jobs.iter().take_while(|_| !stop.load(Ordering::Relaxed));
        let statuses = wanted.map(|job| one(args, job, &stop, look));
        statuses.max().unwrap_or(Status::Clean)
    };
    let is_drawn = |path: &Path| drawn.borrow().iter().any(|p| output::is_made(p, path));
    match args.watch {
        true => watch::run(&args.paths, look, &stop, is_drawn, all),
        false => all(),
    }
}

/// What there is to draw. What stands in the way is said, and then there is nothing.
fn jobs(args: &Args, look: LookChoice) -> Option<Vec<Job>> {
    let configs = Configs::default().into();
    let found = paths::expand(&args.paths, &configs, look);
    if found.failed || found.files.is_empty() {
        return None;
    }
    let is_folder = args.paths.iter().any(|path| path.is_dir());
    let several = is_folder || args.paths.len() > 1;
    let wrong = match several {
        true if args.stats.is_some() || args.heatmap.is_some() => Some("several-with-one-output"),
        true if args.tile.is_some() => Some("several-with-tile"),
        _ => None,
    };
    let places = match wrong {
        Some(message) => Err(Complaint::new(message)),
        None => places(&found.files, several, args.output.as_deref()),
    };
    match places {
        Ok(places) => {
            let job = |(scene, picture)| Job { scene, picture };
            Some(found.files.into_iter().zip(places).map(job).collect())
        }
        Err(complaint) => {
            complain(look, &complaint);
            None
        }
    }
}

/// Draws one scene.
fn one(args: &Args, job: &Job, stop: &Arc<AtomicBool>, look: LookChoice) -> Status {
    let start = Instant::now();
    if let Err(complaint) = args.memory.admit(&job.scene, 1) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let mut loaded = match load_sound(&job.scene, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    // The records are not needed any more, and take more memory than the scene.
    loaded.forget_records();
    let load = start.elapsed().as_secs_f64();
    match picture::draw(args, job, (&loaded, load), stop, look) {
        // Where standard output carries a picture or numbers, it carries nothing else.
        Ok(said) if args.outputs_on_stdout() > 0 => {
            said.lines().for_each(tell);
            Status::Clean
        }
        Ok(said) => terminal::print(look, Status::Clean, |out| out.write_all(said.as_bytes())),
        Err(error) => refuse(&loaded, error, look),
    }
}
