//! `zpg accuracy`: what accuracy costs in time.

use std::cell::Cell;
use std::fs;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Instant;

use super::atomic_file::{self, try_folder, unwritable};
use super::camera::{CameraArgs, one_camera};
use super::help;
use super::size::Size;
use super::terminal::{print, progress_bar, stop_on_interrupt, width};
use super::time::Seconds;
use super::{LookChoice, Status, complain, load_valid, refuse, usage};
use crate::analysis::Analysis;
use crate::analysis::file::STDIN;
use crate::diagnostics::{Complaint, Error, Language};
use crate::study::accuracy::advice::in_language;
use crate::study::accuracy::configurations::Axis;
use crate::study::accuracy::print::terminal;
use crate::study::accuracy::{self, Options, Report, run::DEFAULT_SECONDS, shapes};
use crate::trace::Images;

/// Tell what accuracy costs in time: what each setting brings to the picture of a scene, and what it takes
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Four kinds of error are measured, each against a reference beyond all that is tried, with the other settings
as plain `zpg render` has them: edges (samples, adaptive), cut light (depth, cutoff), rounding (precision,
solver) and facets (tessellation, levels). What the scene does not call for is not run, and the report says
why. The reference itself is checked by an independent ray tracer in 71 digits.

Of a large picture small tiles are measured, never a smaller picture. Times are the least CPU time on one
thread of several runs in shuffled order; times that differ by less than the measured noise are not ranked.
In DIR are then accuracy.json, accuracy.md, accuracy.svg and accuracy.html. Ctrl-C writes what is finished.

Examples:
  zpg accuracy scene.zpg
  zpg accuracy scene.zpg --size 1920x1080 --budget 10m -o report
  zpg accuracy scene.zpg --axes samples,adaptive --goal 0.5
  zpg accuracy --shapes")]
pub struct Args {
    /// The scene; `-` is standard input
    #[arg(value_name = "FILE", required_unless_present = "shapes")]
    file: Option<PathBuf>,

    /// Width and height of the picture in pixels
    #[arg(help_heading = help::PICTURE)]
    #[arg(
        long,
        value_name = "WxH",
        default_value = "640x480",
        allow_hyphen_values = true
    )]
    size: Size,

    #[command(flatten)]
    camera: CameraArgs,

    /// The settings to try, with commas between them [default: all of them]
    #[arg(long, value_enum, value_delimiter = ',', value_name = "AXIS")]
    axes: Vec<AxisArg>,

    /// Timed runs of each setting [default: 5]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "N", value_parser = runs, allow_negative_numbers = true)]
    runs: Option<usize>,

    /// About how long it may take: 90s, 2m, 1h [default: 2m]
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    budget: Option<Seconds>,

    /// The error that is good enough, in steps of an 8-bit picture
    #[arg(help_heading = help::ACCURACY)]
    #[arg(long, value_name = "STEPS", default_value_t = 1.0, value_parser = goal, allow_negative_numbers = true)]
    goal: f64,

    /// The folder for the report; SCENE-accuracy if not given
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// Instead: time and error of a ray for each shape, number and solver
    #[arg(long, conflicts_with_all = ["file", "axes", "goal"])]
    shapes: bool,

    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum AxisArg {
    Samples,
    Adaptive,
    Depth,
    Cutoff,
    Precision,
    Solver,
    Tessellation,
    Levels,
}

impl From<AxisArg> for Axis {
    fn from(axis: AxisArg) -> Axis {
        match axis {
            AxisArg::Samples => Axis::Samples,
            AxisArg::Adaptive => Axis::Adaptive,
            AxisArg::Depth => Axis::Depth,
            AxisArg::Cutoff => Axis::Cutoff,
            AxisArg::Precision => Axis::Precision,
            AxisArg::Solver => Axis::Solver,
            AxisArg::Tessellation => Axis::Tessellation,
            AxisArg::Levels => Axis::Levels,
        }
    }
}

fn runs(text: &str) -> Result<usize, Complaint> {
    usage::number(text, "expected-runs", |n| (1..=100).contains(&n))
}

fn goal(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-goal", |x| x > 0.0 && x <= 255.0)
}

/// The most pixels of a picture: larger ones would need more memory than a machine can be taken to have.
const MAX_PIXELS: u64 = 1 << 26;

pub fn run(args: &Args, look: LookChoice) -> Status {
    let Some(file) = &args.file else {
        return shapes(args, look);
    };
    if u64::from(args.size.width) * u64::from(args.size.height) > MAX_PIXELS {
        let max = MAX_PIXELS.to_string();
        complain(look, &Complaint::new("too-many-pixels").with("max", max));
        return Status::Failure;
    }
    if let Err(complaint) = try_folder(&folder(args, file)) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let loaded = match load_valid(file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    match study(args, file, &loaded, look) {
        Ok((report, page)) => {
            let language = look.language();
            let status = match (report.stopped, report.wrong_reference()) {
                (true, _) => Status::Interrupted,
                (false, Some(_)) => Status::Negative,
                (false, None) => Status::Clean,
            };
            print(look, status, |out| match args.json {
                true => {
                    serde_json::to_writer_pretty(&mut *out, &report)?;
                    writeln!(out)
                }
                false => {
                    let report = in_language(&report, language);
                    let text = terminal::text(&report, language, Some(&page), width());
                    out.write_all(text.as_bytes())
                }
            })
        }
        Err(error) => refuse(&loaded, error, look),
    }
}

fn study(
    args: &Args,
    file: &Path,
    loaded: &Analysis,
    look: LookChoice,
) -> Result<(Report, String), Error> {
    let folder = folder(args, file);
    fs::create_dir_all(&folder).map_err(|e| unwritable(&folder, &e))?;
    let images = loaded.source.folder().unwrap_or(Path::new("."));
    let images = Images::load(&loaded.scene, images)?;
    let Size { width, height } = args.size;
    let scene = args.camera.staged(&loaded.scene, args.size)?;
    let camera = one_camera(&scene, look)?;
    let axes = match args.axes.is_empty() {
        true => Axis::ALL.to_vec(),
        false => args.axes.iter().map(|&a| a.into()).collect(),
    };
    let options = Options {
        size: [width, height],
        axes,
        runs: args.runs,
        budget: args.budget.map_or(DEFAULT_SECONDS, |b| b.0),
        goal: args.goal,
        stop: stop_on_interrupt(look),
    };
    let progress = Shown::new(options.budget, look);
    let scene = Arc::new(scene.into_owned());
    let name = file.to_string_lossy();
    let report = accuracy::run(&name, &scene, &images, camera, &options, &|what, share| {
        progress.show(what, share);
    })?;
    progress.bar.finish_and_clear();
    for (name, text) in accuracy::print::files(&report, look.language()) {
        let path = folder.join(name);
        atomic_file::write(&path, |out| out.write_all(text.as_bytes()))?;
    }
    let path = folder.join("accuracy.html").to_string_lossy().into_owned();
    let page = look
        .language()
        .say("accuracy-written", &[("path", path.into())]);
    Ok((report, page))
}

fn folder(args: &Args, file: &Path) -> PathBuf {
    let stem = match file.to_str() {
        Some(STDIN) => None,
        _ => file.file_stem(),
    };
    let stem = stem
        .unwrap_or("scene".as_ref())
        .to_string_lossy()
        .into_owned();
    (args.output.clone()).unwrap_or_else(|| PathBuf::from(format!("{stem}-accuracy")))
}

/// The progress bar with the current step and the seconds that are left, if standard error is a terminal.
struct Shown {
    bar: indicatif::ProgressBar,
    language: Language,
    start: Instant,
    budget: f64,
    last: Cell<&'static str>,
}

impl Shown {
    fn new(budget: f64, look: LookChoice) -> Shown {
        let bar = progress_bar(1000, look);
        if std::io::stderr().is_terminal()
            && let Ok(style) =
                indicatif::ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}")
        {
            bar.set_style(style);
        }
        Shown {
            bar,
            language: look.language(),
            start: Instant::now(),
            budget,
            last: Cell::new(""),
        }
    }

    fn show(&self, what: &'static str, share: f64) {
        self.bar.set_position((share * 1000.0) as u64);
        let spent = self.start.elapsed().as_secs_f64();
        // The time that is left follows from the budget at first, and later from the time that the finished share took.
        let by_budget = (self.budget - spent).max(0.0);
        let by_share = if share > 0.0 {
            spent / share - spent
        } else {
            by_budget
        };
        let left = share * by_share + (1.0 - share) * by_budget;
        let name = self.language.say(what, &[]);
        self.bar.set_message(format!("{name}, {left:.0} s"));
        self.last.set(what);
    }
}

/// Runs `--shapes`: prints the table of time and error for each shape, number and solver, without a scene.
fn shapes(args: &Args, look: LookChoice) -> Status {
    if let Err(complaint) = args.output.iter().try_for_each(|folder| try_folder(folder)) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let seconds = args.budget.map_or(60.0, |b| b.0);
    let stop = stop_on_interrupt(look);
    let bar = progress_bar(1000, look);
    let entries = shapes::run(seconds, &stop, &|share| {
        bar.set_position((share * 1000.0) as u64)
    });
    bar.finish_and_clear();
    let table = shapes::table(&entries, &look.language().say("accuracy-shapes-head", &[]));
    let json = serde_json::to_string_pretty(&entries).unwrap_or_default() + "\n";
    if let Some(folder) = &args.output {
        let write = |name: &str, text: &str| -> Result<(), Complaint> {
            let path = folder.join(name);
            fs::create_dir_all(folder).map_err(|e| unwritable(&path, &e))?;
            atomic_file::write(&path, |out| out.write_all(text.as_bytes()))
        };
        let written = write("shapes.json", &json).and_then(|()| write("shapes.md", &table));
        if let Err(complaint) = written {
            complain(look, &complaint);
            return Status::Failure;
        }
    }
    let status = match stop.load(Ordering::Relaxed) {
        true => Status::Interrupted,
        false => Status::Clean,
    };
    let text = if args.json { json } else { table };
    print(look, status, |out| out.write_all(text.as_bytes()))
}
