//! Draws a picture or a stereo pair, writes its files, and says so.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::fingerprint::{self, Content};
use super::options::{Stereo, bytes_of_pixels};
use super::output::{Output, left_and_right, unfinished, wrote};
use super::stats::{Samples, Seconds, Stats, peak_memory, write_stats};
use super::unfinished::Unfinished;
use super::{Args, Job, cost, notes};
use crate::analysis::Analysis;
use crate::commands::LookChoice;
use crate::commands::atomic_file::try_file;
use crate::commands::endings;
use crate::commands::paths::{is_stdin, is_stdout};
use crate::commands::refuse_overwrite::refuse_overwrite;
use crate::commands::terminal::{complain, note, progress_bar, tell};
use crate::diagnostics::{Complaint, Error, Span};
use crate::parallel;
use crate::picture_files::{Format, Origin, read};
use crate::scene::{Camera, Scene};
use crate::trace::plan::Plan;
use crate::trace::stats::Counts;
use crate::trace::{CostMap, Crop, Film, Images, Numbers, Picture, Settings, Tracer};

/// Draws the picture of a job and writes its files. `load` is the seconds that reading the scene took. Returns the
/// lines to print: the files, and what the picture has cost if that is asked.
pub(super) fn draw(
    args: &Args,
    job: &Job,
    (loaded, load): (&Analysis, f64),
    stop: &Arc<AtomicBool>,
    look: LookChoice,
) -> Result<String, Error> {
    let staged = args
        .picture
        .camera
        .staged(&loaded.scene, args.picture.size)?;
    let scene = &*staged;
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let settings = Settings {
        stop: Some(stop.clone()),
        ..args.picture.settings(args.tile)?
    };
    let cameras = cameras(args, scene)?;
    let [width, height] = drawn_size(&settings);
    let band = match args.tile {
        Some(tile) => tile.rows(height)?,
        None => 0..height,
    };
    let pixel = bytes_of_pixels(args.picture.sampling());
    let count = f64::from(width) * f64::from(band.end - band.start);
    let taken = count * pixel * cameras.len() as f64;
    args.memory.grant(taken, "picture-needs-memory")?;
    let stereo = args.picture.stereo.unwrap_or_default();
    let threads = parallel::threads();
    let per_camera = |path: PathBuf| match stereo {
        Stereo::Pair if cameras.len() > 1 => left_and_right(&path),
        _ => vec![path],
    };
    let paths = per_camera(job.picture.clone());
    if paths.len() > 1 && args.output.as_deref().is_some_and(is_stdout) {
        return Err(Complaint::new("pair-on-stdout").into());
    }
    if args.outputs_on_stdout() > 1 {
        return Err(Complaint::new("two-on-stdout").into());
    }
    let maps: Vec<PathBuf> = (args.heatmap.iter())
        .flat_map(|path| per_camera(path.clone()))
        .collect();
    // Files that must not or cannot be written are refused before anything is drawn.
    let written = paths
        .iter()
        .filter(|path| !is_stdout(path))
        .chain(&maps)
        .chain(args.stats.iter().filter(|path| !is_stdout(path)));
    refuse_overwrite(&job.scene, loaded, written.map(PathBuf::as_path))?;
    let across = match stereo {
        Stereo::SideBySide if cameras.len() > 1 => width.saturating_mul(2),
        _ => width,
    };
    let pictures = Pictures {
        args,
        settings: &settings,
        scene: fingerprint::of_scene(scene, folder),
        height,
        band: band.clone(),
    };
    let contents: &[Content] = match paths.len() {
        1 => &[Content::Picture],
        _ => &[Content::Left, Content::Right],
    };
    let origins = contents
        .iter()
        .map(|&content| pictures.origin(across, content));
    let origins: Vec<Origin> = origins.collect();
    if args.resume && paths.iter().zip(&origins).all(|(p, o)| is_drawn(p, o)) {
        let about = |path: &PathBuf| Complaint::new("already-drawn").with("path", path.as_path());
        return Ok(paths.iter().map(|path| line(look, &about(path))).collect());
    }
    let is_silent = |path: &&PathBuf| !is_stdout(path) && Format::of(path).is_none();
    if let Some(path) = paths.iter().find(is_silent).filter(|_| args.resume) {
        note(
            look,
            &Complaint::new("note-drawn-anyway").with("path", path.as_path()),
        );
    }
    let outputs = paths
        .iter()
        .map(|path| Output::create(path, [across, band.end - band.start], args.tile.is_some()))
        .collect::<Result<Vec<_>, _>>()?;
    let maps = maps
        .iter()
        .map(|path| Output::create_map(path))
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(path) = &args.stats {
        endings::fits(path, &["json"])?;
        try_file(path)?;
    }
    // Rows of an interrupted run are not kept with --watch, which Ctrl-C ends for good. Nor are they kept for a scene
    // from standard input or a picture on standard output: an editor that draws in this way draws anew after each
    // change.
    let is_kept = !args.watch && !is_stdin(&job.scene) && !is_stdout(&job.picture);
    let unfinished: Vec<Unfinished> = match is_kept {
        true => (unfinished(&job.picture, cameras.len())
            .into_iter()
            .enumerate())
        .map(|(i, path)| {
            let origin = pictures.origin(width, Content::Rows(i));
            Unfinished { path, origin }
        })
        .collect(),
        false => Vec::new(),
    };

    let mut seconds = Seconds {
        load,
        ..Seconds::default()
    };
    let start = Instant::now();
    // In single precision, rounding may show parts that are hidden otherwise, so that the plan leaves out none.
    let plan = match args.picture.precision {
        Numbers::F32 => Plan::new(scene),
        Numbers::F64 | Numbers::Dd => Plan::of_picture(scene),
    };
    let plan = plan.ok_or_else(Error::nothing_to_draw)?;
    seconds.plan = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let images = Images::load(scene, folder)?;
    let mut tracer = Tracer::planned(scene, &images, plan)?;
    let crowded = |why| {
        let span = scene.render.map_or(Span::default(), |r| r.span);
        Error::at(span, why)
    };
    (args.memory.confine(&mut tracer, taken, threads)).map_err(crowded)?;
    let stage = tracer.stage(&pictures.rows(band.clone()));
    seconds.build = start.elapsed().as_secs_f64();

    let start = Instant::now();
    let rows = band.end - band.start;
    let bar = progress_bar(u64::from(rows) * cameras.len() as u64, look);
    let mut drawn = Vec::new();
    for (i, camera) in cameras.iter().enumerate() {
        let mut draw = |rows: Range<u32>| {
            let settings = pictures.rows(rows);
            tracer.render_on(stage.as_ref(), camera, &settings, || bar.inc(1))
        };
        let before = unfinished.get(i).filter(|_| args.resume);
        drawn.push(match before {
            Some(before) => before.go_on(band.clone(), look, &mut draw)?,
            None => draw(band.clone())?,
        });
    }
    bar.finish_and_clear();
    if stop.load(Ordering::Relaxed) {
        leave(&unfinished, &drawn, band.start, look);
        return Err(Error::Interrupted);
    }
    args.memory.check(&tracer).map_err(crowded)?;
    seconds.trace = start.elapsed().as_secs_f64();

    // A band does not tell what is wrong with the picture.
    let is_whole = args.tile.is_none();
    if is_whole {
        let staged = (&loaded.scene, &cameras[..]);
        notes::say(args, &tracer, staged, &settings, &drawn, look);
    }
    let start = Instant::now();
    let (counts, samples) = totals(&drawn);
    let maps = write_maps(maps, &drawn, stereo, look)?;
    let mut films = compose(drawn, stereo, outputs.len());
    if let Some(times) = args.picture.exposure {
        films.iter_mut().for_each(|film| film.expose(times));
    }
    if is_whole {
        let exposure = args.picture.exposure.unwrap_or(1.0);
        notes::say_brightness(loaded, &films, exposure, look);
    }
    let mut said = String::new();
    for ((output, film), origin) in outputs.into_iter().zip(&films).zip(&origins) {
        if let Some(path) = output.finish(film, origin)? {
            said += &line(look, &wrote_rows(&path, film, origin));
        }
    }
    unfinished.iter().for_each(Unfinished::remove);
    said += &maps;
    seconds.encode = start.elapsed().as_secs_f64();

    if args.cost {
        said += &cost::spent(
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
            precision: args.picture.precision.name(),
            threads,
            samples,
            seconds,
            rays: counts.rays,
            intersections: counts.intersections,
            work: counts.work,
            uncertain: counts.uncertain,
            quick: counts.quick,
            effects: tracer.plan.names(),
            peak_memory_bytes: peak_memory(),
        };
        write_stats(path, &stats)?;
    }
    Ok(said)
}

/// The data that all files of one run share.
struct Pictures<'a> {
    args: &'a Args,
    settings: &'a Settings,
    /// The hash of the scene.
    scene: String,
    /// Rows of the whole picture.
    height: u32,
    /// The rows that are drawn.
    band: Range<u32>,
}

impl Pictures<'_> {
    /// The origin that a file states with this content, and with `width` columns.
    fn origin(&self, width: u32, content: Content) -> Origin {
        let is_unfinished = matches!(content, Content::Rows(_));
        Origin {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: self.scene.clone(),
            settings: fingerprint::of_settings(self.args, self.settings, content),
            size: [width, self.height],
            rows: match is_unfinished {
                true => Vec::new(),
                false => vec![[self.band.start, self.band.end - self.band.start]],
            },
            unfinished: is_unfinished,
        }
    }

    /// The settings that draw these rows alone.
    fn rows(&self, rows: Range<u32>) -> Settings {
        let settings = self.settings.clone();
        if rows == (0..self.height) {
            return settings;
        }
        let [width, _] = drawn_size(&settings);
        let [x, y] = settings.crop.map_or([0, 0], |crop| [crop.x, crop.y]);
        let crop = Some(Crop {
            x,
            y: y + rows.start,
            width,
            height: rows.end - rows.start,
        });
        Settings { crop, ..settings }
    }
}

/// Width and height in pixels of the part of a picture that is drawn.
fn drawn_size(settings: &Settings) -> [u32; 2] {
    (settings.crop).map_or([settings.width, settings.height], |c| [c.width, c.height])
}

/// Whether a file states this origin, and its rows can be read to the end.
fn is_drawn(path: &Path, origin: &Origin) -> bool {
    let is_sound = |rows: read::Rows| rows.origin == *origin && rows.all(path).all(|r| r.is_ok());
    read::open(path).is_ok_and(is_sound)
}

/// Keeps the rows that an interrupted run has drawn, and notes their file. `start` is the first row of the band.
fn leave(unfinished: &[Unfinished], drawn: &[Picture], start: u32, look: LookChoice) {
    for (unfinished, picture) in unfinished.iter().zip(drawn) {
        match unfinished.leave(picture, start) {
            Ok(0) => {}
            Ok(rows) => note(
                look,
                &Complaint::new("note-unfinished")
                    .with("path", unfinished.path.as_path())
                    .with(
                        "percent",
                        (100 * rows as usize / picture.finished.len()).to_string(),
                    ),
            ),
            Err(complaint) => complain(look, &complaint),
        }
    }
}

/// The message as a line; empty with `--quiet`.
fn line(look: LookChoice, about: &Complaint) -> String {
    match look.quiet {
        true => String::new(),
        false => about.wording(look.language()) + "\n",
    }
}

/// The message about a file that was written.
fn wrote_rows(path: &Path, film: &Film, origin: &Origin) -> Complaint {
    if origin.is_whole() {
        return wrote(path, [film.width, film.height]);
    }
    let [first, count] = origin.span();
    Complaint::new("wrote-rows")
        .with("path", path)
        .with("first", first.to_string())
        .with("last", (first + count - 1).to_string())
        .with("height", origin.size[1].to_string())
}

/// The cameras that take the picture: one, or left and right.
fn cameras(args: &Args, scene: &Scene) -> Result<Vec<Camera>, Error> {
    let cameras: Vec<Camera> = scene.chosen_cameras().copied().collect();
    match args.picture.stereo.is_some() && cameras.len() < 2 {
        true => Err(Complaint::new("stereo-of-one").into()),
        false => Ok(cameras),
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

/// The cost of all pictures, and the samples in their pixels.
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

/// Writes the maps of costs to `files`, if there are any, all on one colour scale, and prints where the scale ends.
/// Returns the lines that name the files.
fn write_maps(
    files: Vec<Output>,
    pictures: &[Picture],
    stereo: Stereo,
    look: LookChoice,
) -> Result<String, Error> {
    let maps: Vec<CostMap> = match pictures {
        [left, right] if files.len() == 1 => vec![match stereo {
            Stereo::Anaglyph => left.costs.plus(&right.costs),
            Stereo::SideBySide | Stereo::Pair => left.costs.beside(&right.costs),
        }],
        _ if files.is_empty() => return Ok(String::new()),
        _ => pictures.iter().map(|p| p.costs.clone()).collect(),
    };
    let max = maps.iter().map(CostMap::max).max().unwrap_or(0);
    let mut said = String::new();
    for (file, map) in files.into_iter().zip(&maps) {
        let path = file.finish_map(map, max)?;
        said += &line(look, &wrote(&path, [map.width, map.height]));
    }
    let scale = Complaint::new("heatmap-scale").with("max", max.to_string());
    if look.quiet {
        return Ok(String::new());
    }
    tell(&scale.wording(look.language()));
    Ok(said)
}
