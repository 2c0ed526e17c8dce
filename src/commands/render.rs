//! `zpg render`: the reference ray tracer.

mod animation;
mod cost;
mod fingerprint;
pub mod frames;
mod notes;
pub mod options;
pub mod output;
mod picture;
pub mod stats;
mod tile;
mod unfinished;

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::habits;
use super::help;
use super::memory::{self, Memory};
use super::paths::{self, is_stdout};
use super::terminal::{self, stop_on_interrupt, tell};
use super::{LookChoice, Status, complain, load_valid, refuse, usage, watch};
use crate::analysis::config::Configs;
use crate::diagnostics::Complaint;
use crate::parallel;
use crate::syntax::quote;
use options::PictureArgs;
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
  zpg render scene.zpg -o 3of8.png --tile 3/8")]
pub struct Args {
    /// Scenes, as records or as JSON, or folders with scenes; `-` is standard input
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// Where to write the picture: .png, .jpg, .webp, .exr or .pfm; `-` is standard output. Or a folder; or an .apng of
    /// frames
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Draw again whenever the scene, or a picture that it names, changes
    #[arg(short, long, conflicts_with_all = ["frames", "frames_from"])]
    watch: bool,

    #[command(flatten)]
    picture: PictureArgs,

    /// Draw this band of rows only, such as 3/8 or 3-5/8; `zpg join` puts bands together
    #[arg(help_heading = help::MACHINES)]
    #[arg(long, value_name = "I/N", requires = "output", conflicts_with_all = ["watch", "heatmap", "cost"], allow_hyphen_values = true)]
    tile: Option<Tile>,

    /// Skip what is drawn already, and go on with what an interrupted run has left
    #[arg(help_heading = help::MACHINES)]
    #[arg(long, conflicts_with_all = ["watch", "heatmap", "cost", "stats"])]
    resume: bool,

    /// Threads to work with; 0: as many as there are processors. At most four times as many
    #[arg(help_heading = help::LIMITS)]
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = usage::whole::<usize>, allow_negative_numbers = true)]
    threads: usize,

    #[command(flatten)]
    memory: Memory,

    /// Write what it has cost to this file, as JSON: times, rays, tests, the work of each effect; `-` is standard output
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["frames", "frames_from"])]
    stats: Option<PathBuf>,

    /// Print what it has cost and where: rays, time, the dearest objects and effects
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, conflicts_with_all = ["frames", "frames_from"])]
    cost: bool,

    /// Draw how many intersection tests each pixel took, in false colours
    #[arg(help_heading = help::REPORTS)]
    #[arg(long, value_name = "OUT.png", conflicts_with_all = ["frames", "frames_from"])]
    heatmap: Option<PathBuf>,
}

impl Args {
    /// How many of the outputs go to standard output.
    fn outputs_on_stdout(&self) -> usize {
        let all = [&self.output, &self.stats];
        let named = all.into_iter().flatten();
        named.filter(|path| is_stdout(path)).count()
    }
}

/// A scene file, and the file that its picture goes to.
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
    if let Some(width) = width_behind_watch(args) {
        let complaint = Complaint::new("watch-no-width").with("text", quote(&width));
        complain(look, &complaint);
        return Status::Failure;
    }
    let stop = stop_on_interrupt(look);
    // A change of the pictures that were drawn last is no reason to draw again.
    let drawn = RefCell::new(Vec::new());
    let all = || {
        let Some(jobs) = jobs(args, look) else {
            return Status::Failure;
        };
        if args.picture.frames.are_given() {
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

/// Finds, with `--watch`, a number such as `640` or `640x480` among the paths that names no file: other programs have
/// `-w` for a width, and the user may have meant that.
fn width_behind_watch(args: &Args) -> Option<String> {
    let is_number = |path: &&PathBuf| {
        let text = path.to_str().unwrap_or_default();
        !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit() || c == b'x')
    };
    let mut paths = args.paths.iter().filter(|path| !path.exists());
    let width = paths.find(is_number).filter(|_| args.watch)?;
    Some(width.display().to_string())
}

/// The scenes to draw, each with the file of its picture. `None` if the arguments do not allow that; the complaint has
/// been printed.
fn jobs(args: &Args, look: LookChoice) -> Option<Vec<Job>> {
    // Nothing is drawn if a path that names no scene is meant as an output or as another program's option.
    let no_scene = args.paths.iter().filter(|path| !path.exists());
    let instead = |path: &Path| {
        let translation = habits::translation(path, &args.paths);
        translation.or_else(|| habits::output(path))
    };
    let output = args.output.as_deref().filter(|path| !path.is_dir());
    let picture = output.and_then(|path| {
        let instead = habits::translation(path, &args.paths)?;
        Some(("no-picture", path, instead))
    });
    if let Some((what, path, instead)) = no_scene
        .filter_map(|path| Some(("no-scene", path.as_path(), instead(path)?)))
        .next()
        .or(picture)
    {
        let complaint = Complaint::new("with-reason")
            .with("what", Complaint::new(what).with("path", path))
            .with("reason", instead);
        complain(look, &complaint);
        return None;
    }
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
        None => {
            let below = |scene: &Path| paths::place_below(&args.paths, scene);
            places(&found.files, several, args.output.as_deref(), below)
        }
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
    let mut loaded = match load_valid(&job.scene, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    notes::say_of_records(args, &loaded, look);
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
