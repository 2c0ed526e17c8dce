//! `zpg render`: the reference ray tracer.

mod output;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Instant;

use serde::Serialize;

use super::camera::CameraArgs;
use super::draft::{self, try_file};
use super::memory::{self, Memory};
use super::paths::is_stdout;
use super::size::Size;
use super::spare::spare;
use super::terminal::{self, progress_bar, stop_on_interrupt, tell};
use super::{LookChoice, Status, complain, load_sound, refuse, usage};
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Error, Span, Value};
use crate::parallel;
use crate::scene::{Camera, Scene};
use crate::solids::staging;
use crate::study::accuracy::{cost, words};
use crate::trace::plan::Plan;
use crate::trace::stats::{Counts, Intersections, Rays, Work};
use crate::trace::{CostMap, Crop, Film, Images, Numbers, Picture, Settings, Tracer};
use output::Output;

/// Draw a scene
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Without -o the picture of SCENE.zpg is written to SCENE.png in the current folder. PNG is 8-bit sRGB,
EXR and PFM are linear, unclamped 32-bit float. What is written is said on standard output; with `-o -`
the PNG itself goes there. A scene with a stereo camera makes two pictures, SCENE_left.png and
SCENE_right.png, unless --stereo says otherwise. Ctrl-C leaves no file.

Examples:
  zpg render scene.zpg
  zpg render scene.zpg -o big.png --size 1920x1080 --samples 16
  zpg render scene.zpg -o film.exr --adaptive 0.01
  zpg render scene.zpg -o - | convert - scene.jpg
  zpg render scene.zpg --cost
  zpg render scene.zpg --crop 200,100,64,64 --stats cost.json")]
pub struct Args {
    /// The scene, as records or as JSON; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// Where to write the picture: .png, .exr or .pfm; `-` is standard output
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Width and height in pixels
    #[arg(
        long,
        value_name = "WxH",
        default_value = "640x480",
        allow_hyphen_values = true
    )]
    size: Size,

    /// Samples in each pixel; one lies in its centre
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = samples, allow_negative_numbers = true)]
    samples: u32,

    /// Up to 1024 samples, until a pixel's estimated error in linear RGB is below this
    #[arg(long, value_name = "TOL", value_parser = tolerance, allow_negative_numbers = true, conflicts_with = "samples")]
    adaptive: Option<f64>,

    /// How often a ray may be reflected or refracted
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    depth: u32,

    /// Leave out what counts for less than this; 0 leaves out nothing [default: 1/4096]
    #[arg(long, value_name = "W", value_parser = cutoff, allow_negative_numbers = true)]
    cutoff: Option<f64>,

    /// The numbers to compute with between a ray and what it hits
    #[arg(long, value_enum, default_value = "f64")]
    precision: Numbers,

    /// Draw this part of the picture only
    #[arg(long, value_name = "X,Y,W,H", allow_hyphen_values = true)]
    crop: Option<CropArg>,

    #[command(flatten)]
    camera: CameraArgs,

    /// How the two pictures of a stereo camera are put [default: pair]
    #[arg(long, value_enum)]
    stereo: Option<Stereo>,

    /// Threads to work with; 0: as many as there are processors. At most four times as many
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = usage::whole::<usize>, allow_negative_numbers = true)]
    threads: usize,

    #[command(flatten)]
    memory: Memory,

    /// Write what it has cost to this file, as JSON: times, rays, tests, the work of each effect; `-` is standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,

    /// Print what it has cost and where: rays, time, the dearest objects and effects
    #[arg(long)]
    cost: bool,

    /// Draw how many intersection tests each pixel took, in false colours
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

/// What a pixel takes until it is in a file, with one sample in it or many.
const PIXEL_BYTES: f64 = 96.0;
const ADAPTIVE_PIXEL_BYTES: f64 = 240.0;

/// Pictures of more pixels than this would need more memory than a machine can be taken to have.
const MAX_PIXELS: u64 = 1 << 28;

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

/// The answer to `--stats`.
#[derive(Serialize)]
struct Stats {
    size: [u32; 2],
    precision: &'static str,
    threads: usize,
    samples: Samples,
    seconds: Seconds,
    rays: Rays,
    intersections: Intersections,
    work: Work,
    uncertain: u64,
    effects: Vec<&'static str>,
    peak_memory_bytes: u64,
}

#[derive(Serialize)]
struct Samples {
    min: u32,
    max: u32,
    mean: f64,
}

#[derive(Serialize, Default)]
struct Seconds {
    load: f64,
    plan: f64,
    build: f64,
    trace: f64,
    encode: f64,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let start = Instant::now();
    if let Err(complaint) = args.memory.admit(&args.file, 1) {
        complain(look, &complaint);
        return Status::Failure;
    }
    if let Err(why) = parallel::take_part(memory::threads(args.threads, look)) {
        let complaint = Complaint::new("no-threads").with("reason", why.to_string());
        complain(look, &complaint);
        return Status::Failure;
    }
    let mut loaded = match load_sound(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    // The records are not needed any more, and take more memory than the scene.
    loaded.forget_records();
    let load = start.elapsed().as_secs_f64();
    match draw(args, &loaded, load, look) {
        // Where standard output carries a picture or numbers, it carries nothing else.
        Ok(said) if args.outputs_on_stdout() > 0 => {
            said.lines().for_each(tell);
            Status::Clean
        }
        Ok(said) => terminal::print(look, Status::Clean, |out| out.write_all(said.as_bytes())),
        Err(error) => refuse(&loaded, error, look),
    }
}

/// Draws, and says what was written and, if that is asked, what it has cost.
fn draw(args: &Args, loaded: &Analysis, load: f64, look: LookChoice) -> Result<String, Error> {
    let staged = args.camera.staged(&loaded.scene, args.size)?;
    let scene = &*staged;
    let stop = stop_on_interrupt(look);
    let settings = Settings {
        stop: Some(stop.clone()),
        ..settings(args)?
    };
    let cameras = cameras(args, scene)?;
    let (width, height) =
        (settings.crop).map_or((settings.width, settings.height), |c| (c.width, c.height));
    let pixel = match args.adaptive {
        None => PIXEL_BYTES,
        Some(_) => ADAPTIVE_PIXEL_BYTES,
    };
    let taken = f64::from(width) * f64::from(height) * pixel * cameras.len() as f64;
    args.memory.grant(taken, "picture-needs-memory")?;
    let stereo = args.stereo.unwrap_or_default();
    let threads = parallel::threads();
    let per_camera = |path: PathBuf| match stereo {
        Stereo::Pair if cameras.len() > 1 => left_and_right(&path),
        _ => vec![path],
    };
    let paths = per_camera(output_path(args));
    if paths.len() > 1 && args.output.as_deref().is_some_and(is_stdout) {
        return Err(Complaint::new("pair-on-stdout").into());
    }
    if args.outputs_on_stdout() > 1 {
        return Err(Complaint::new("two-on-stdout").into());
    }
    let maps: Vec<PathBuf> = (args.heatmap.iter())
        .flat_map(|path| per_camera(path.clone()))
        .collect();
    // What must not or cannot be written is known before anything is drawn.
    let written = paths
        .iter()
        .filter(|path| !is_stdout(path))
        .chain(&maps)
        .chain(args.stats.iter().filter(|path| !is_stdout(path)));
    spare(&args.file, loaded, written.map(PathBuf::as_path))?;
    let outputs = paths
        .iter()
        .map(|path| Output::create(path))
        .collect::<Result<Vec<_>, _>>()?;
    let maps = maps
        .iter()
        .map(|path| Output::create_map(path))
        .collect::<Result<Vec<_>, _>>()?;
    args.stats.iter().try_for_each(|path| try_file(path))?;

    let mut seconds = Seconds {
        load,
        ..Seconds::default()
    };
    let start = Instant::now();
    // What rounding may show in single precision is drawn there.
    let plan = match args.precision {
        Numbers::F32 => Plan::new(scene),
        Numbers::F64 | Numbers::Dd => Plan::of_picture(scene),
    };
    let plan = plan.ok_or_else(Error::nothing_to_draw)?;
    seconds.plan = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let images = Images::load(scene, loaded.source.folder().unwrap_or(Path::new(".")))?;
    let mut tracer = Tracer::planned(scene, &images, plan)?;
    let crowded = |why| {
        let span = scene.render.map_or(Span::default(), |r| r.span);
        Error::at(span, why)
    };
    (args.memory.confine(&mut tracer, taken, threads)).map_err(crowded)?;
    seconds.build = start.elapsed().as_secs_f64();

    let start = Instant::now();
    let rows = settings.crop.map_or(settings.height, |c| c.height);
    let bar = progress_bar(u64::from(rows) * cameras.len() as u64, look);
    let mut pictures = Vec::new();
    for camera in &cameras {
        pictures.push(tracer.render(camera, &settings, || bar.inc(1))?);
    }
    bar.finish_and_clear();
    if stop.load(Ordering::Relaxed) {
        return Err(Error::Interrupted);
    }
    args.memory.check(&tracer).map_err(crowded)?;
    seconds.trace = start.elapsed().as_secs_f64();

    let start = Instant::now();
    let (counts, samples) = totals(&pictures);
    write_maps(maps, &pictures, stereo, look)?;
    let films = compose(pictures, stereo, outputs.len());
    let mut said = String::new();
    for (output, film) in outputs.into_iter().zip(&films) {
        if let Some(path) = output.finish(film)?.filter(|_| !look.quiet) {
            let wrote = Complaint::new("wrote-picture")
                .with("path", path.as_path())
                .with("width", film.width.to_string())
                .with("height", film.height.to_string());
            said += &(wrote.wording(look.language()) + "\n");
        }
    }
    seconds.encode = start.elapsed().as_secs_f64();

    if args.cost {
        said += &spent(
            &cameras[0],
            (loaded, scene),
            &settings,
            (&seconds, &counts),
            look,
        )?;
    }
    if let Some(path) = &args.stats {
        let stats = Stats {
            size: [settings.width, settings.height],
            precision: args.precision.name(),
            threads,
            samples,
            seconds,
            rays: counts.rays,
            intersections: counts.intersections,
            work: counts.work,
            uncertain: counts.uncertain,
            effects: tracer.plan.names(),
            peak_memory_bytes: peak_memory(),
        };
        write_stats(path, &stats)?;
    }
    Ok(said)
}

/// Seconds that are taken to find out where the time of a picture goes.
const COST_SECONDS: f64 = 1.0;

/// What a picture has cost, in some ten lines.
fn spent(
    camera: &Camera,
    (loaded, scene): (&Analysis, &Scene),
    settings: &Settings,
    (seconds, counts): (&Seconds, &Counts),
    look: LookChoice,
) -> Result<String, Error> {
    let language = look.language();
    let images = Images::load(scene, loaded.source.folder().unwrap_or(Path::new(".")))?;
    let scene = Arc::new(scene.clone());
    let cost = cost::cost(scene, &images, *camera, settings, COST_SECONDS)?;
    let background = language.say("accuracy-background", &[]);
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let objects: Vec<String> = (cost.objects.iter().take(3))
        .map(|&(id, share)| match id {
            0 => format!("{background} {}", percent(share)),
            id => format!("#{id} {}", percent(share)),
        })
        .collect();
    let effects: Vec<String> = (cost.effects.iter().take(1))
        .map(|(name, share)| format!("{} {}", words::effect(language, name), percent(*share)))
        .collect();
    let text = |x: f64| words::seconds(language, x);
    let phase = |name, x: f64| (name, Value::from(text(x)));
    let phases = [
        phase("load", seconds.load),
        phase("plan", seconds.plan),
        phase("build", seconds.build),
        phase("trace", seconds.trace),
        phase("encode", seconds.encode),
    ];
    let phases = language.say("cost-seconds", &phases);
    let rays = counts.rays;
    let all = [
        ("cost-camera", rays.camera.to_string()),
        ("cost-shadow", rays.shadow.to_string()),
        ("cost-reflection", rays.reflection.to_string()),
        ("cost-refraction", rays.refraction.to_string()),
        ("cost-boxes", counts.intersections.boxes.to_string()),
        ("cost-shapes", counts.intersections.shape.to_string()),
        ("cost-uncertain", counts.uncertain.to_string()),
        ("cost-phases", phases),
        ("cost-objects", objects.join(" · ")),
        ("cost-effect", effects.join(" · ")),
    ];
    let lines = all.into_iter().filter(|line| !line.1.is_empty());
    let lines = lines.map(|(name, text)| format!("{:<36}{text}\n", language.say(name, &[])));
    Ok(lines.collect())
}

fn settings(args: &Args) -> Result<Settings, Error> {
    let Size { width, height } = args.size;
    let crop = args.crop.map(|c| c.0);
    if let Some(c) = crop {
        let fits =
            |at: u32, extent: u32, side: u32| at.checked_add(extent).is_some_and(|end| end <= side);
        if !fits(c.x, c.width, width) || !fits(c.y, c.height, height) {
            return Err(Complaint::new("crop-too-large")
                .with("width", width.to_string())
                .with("height", height.to_string())
                .into());
        }
    }
    let (w, h) = crop.map_or((width, height), |c| (c.width, c.height));
    if u64::from(w) * u64::from(h) > MAX_PIXELS {
        let max = MAX_PIXELS.to_string();
        return Err(Complaint::new("too-many-pixels").with("max", max).into());
    }
    let default = Settings::default();
    Ok(Settings {
        width,
        height,
        crop,
        wanted: None,
        samples: args.samples,
        tolerance: args.adaptive,
        shift: [0.0; 2],
        depth: args.depth,
        cutoff: args.cutoff.unwrap_or(default.cutoff),
        numbers: args.precision,
        stop: None,
    })
}

/// The cameras that take the picture: one, or left and right.
fn cameras(args: &Args, scene: &Scene) -> Result<Vec<Camera>, Error> {
    let cameras: Vec<Camera> = staging::cameras(scene).copied().collect();
    match args.stereo.is_some() && cameras.len() < 2 {
        true => Err(Complaint::new("stereo-of-one").into()),
        false => Ok(cameras),
    }
}

/// Where the picture goes.
fn output_path(args: &Args) -> PathBuf {
    args.output.clone().unwrap_or_else(|| {
        let stem = args.file.file_stem().filter(|stem| *stem != "-");
        PathBuf::from(stem.unwrap_or("scene".as_ref())).with_added("", "png")
    })
}

/// The paths of a stereo pair.
fn left_and_right(path: &Path) -> Vec<PathBuf> {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    ["_left", "_right"]
        .map(|side| path.with_extension("").with_added(side, &extension))
        .into()
}

trait WithAdded {
    /// The path with something added to its file name, and an extension.
    fn with_added(&self, name: &str, extension: &str) -> PathBuf;
}

impl WithAdded for PathBuf {
    fn with_added(&self, name: &str, extension: &str) -> PathBuf {
        let mut path = self.clone().into_os_string();
        path.push(format!("{name}.{extension}"));
        path.into()
    }
}

/// Puts the pictures of one or two cameras into as many films as there are files.
fn compose(mut pictures: Vec<Picture>, stereo: Stereo, files: usize) -> Vec<Film> {
    match pictures.as_slice() {
        [left, right] if files == 1 => vec![match stereo {
            Stereo::Anaglyph => left.film.anaglyph(&right.film),
            Stereo::SideBySide | Stereo::Pair => left.film.beside(&right.film),
        }],
        _ => pictures.drain(..).map(|p| p.film).collect(),
    }
}

/// What all pictures have cost, and the samples in their pixels.
fn totals(pictures: &[Picture]) -> (Counts, Samples) {
    let mut counts = Counts::default();
    for picture in pictures {
        counts += picture.counts;
    }
    let pixels: usize = pictures.iter().map(|p| p.film.pixels.len()).sum();
    let total: u64 = pictures.iter().map(|p| p.samples.total).sum();
    let samples = Samples {
        min: pictures.iter().map(|p| p.samples.min).min().unwrap_or(0),
        max: pictures.iter().map(|p| p.samples.max).max().unwrap_or(0),
        mean: total as f64 / pixels.max(1) as f64,
    };
    (counts, samples)
}

/// Writes the maps of costs, if they are asked for, on one scale, and says which.
fn write_maps(
    files: Vec<Output>,
    pictures: &[Picture],
    stereo: Stereo,
    look: LookChoice,
) -> Result<(), Error> {
    let maps: Vec<CostMap> = match pictures {
        [left, right] if files.len() == 1 => vec![match stereo {
            Stereo::Anaglyph => left.costs.plus(&right.costs),
            Stereo::SideBySide | Stereo::Pair => left.costs.beside(&right.costs),
        }],
        _ if files.is_empty() => return Ok(()),
        _ => pictures.iter().map(|p| p.costs.clone()).collect(),
    };
    let max = maps.iter().map(CostMap::max).max().unwrap_or(0);
    for (file, map) in files.into_iter().zip(&maps) {
        file.finish_map(map, max)?;
    }
    let scale = Complaint::new("heatmap-scale").with("max", max.to_string());
    if look.quiet {
        return Ok(());
    }
    tell(&scale.wording(look.language()));
    Ok(())
}

fn write_stats(path: &Path, stats: &Stats) -> Result<(), Error> {
    let write = |out: &mut dyn Write| {
        serde_json::to_writer_pretty(&mut *out, stats)?;
        writeln!(out)
    };
    Ok(draft::write(path, write)?)
}

/// The most memory the process has held, in bytes; 0 where the system does not tell.
fn peak_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    let kibibytes: Option<u64> = line.and_then(|l| l.split_whitespace().next()?.parse().ok());
    kibibytes.unwrap_or(0) * 1024
}
