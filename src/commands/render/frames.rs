//! The pictures of a scene whose numbers vary: a file for each frame, or one animated picture.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::output::{Output, left_and_right};
use super::{Args, Job, animation, notes, picture};
use crate::analysis::{Analysis, repair};
use crate::commands::atomic_file::{try_file, unwritable};
use crate::commands::frames::Frames;
use crate::commands::paths::is_stdout;
use crate::commands::refuse_overwrite::refuse_overwrite;
use crate::commands::terminal::{self, LookChoice, complain, note, report};
use crate::commands::{Status, load_valid, refuse};
use crate::diagnostics::{Complaint, Diagnostic, Error, Value};

/// The name endings of films, which other programs make.
const FILMS: [&str; 10] = [
    "mp4", "m4v", "mov", "mkv", "webm", "avi", "mpg", "mpeg", "ogv", "gif",
];

fn ending(path: &Path) -> String {
    let extension = path.extension().unwrap_or_default();
    extension.to_string_lossy().to_lowercase()
}

/// Whether the frames go into one animated picture.
fn is_animated(path: &Path) -> bool {
    ending(path) == "apng"
}

/// Makes sure that the options about frames go together, before anything is read.
pub fn check(args: &Args, is_one: bool) -> Result<(), Complaint> {
    let frames = &args.picture.frames;
    frames.check()?;
    let Some(output) = args.output.as_deref().filter(|path| !path.is_dir()) else {
        return Ok(());
    };
    let about = |message| Err(Complaint::new(message).with("path", output));
    match frames.are_given() {
        false if ending(output) == "gif" => Err(Complaint::new("film-of-one")
            .with("path", output)
            .with("still", output.with_extension("png").as_path())
            .with("animated", output.with_extension("apng").as_path())),
        _ if FILMS.contains(&ending(output).as_str()) => Err(by_ffmpeg(args, output)),
        false if is_animated(output) => about("animation-without-frames"),
        true if is_stdout(output) => about("frames-on-stdout"),
        true if is_animated(output) && !is_one => about("several-in-one-file"),
        true if is_animated(output) && args.tile.is_some() => about("animation-of-tiles"),
        true if frames.has_fps() && !is_animated(output) => about("fps-of-files"),
        _ => Ok(()),
    }
}

/// The complaint that zpg writes no film, with the command of ffmpeg that makes one of frames.
fn by_ffmpeg(args: &Args, film: &Path) -> Complaint {
    let stem = film.file_stem().unwrap_or_default().to_string_lossy();
    let (fps, first) = (args.picture.frames.fps(), args.picture.frames.first());
    let start = match first {
        0 => String::new(),
        _ => format!(" -start_number {first}"),
    };
    // Programs that show films want colours at half the resolution; a GIF has a palette.
    let colours = match ending(film) == "gif" {
        true => "",
        false => " -pix_fmt yuv420p",
    };
    let film = film.to_string_lossy();
    let line = format!("ffmpeg -framerate {fps}{start} -i {stem}.%04d.png{colours} {film}");
    Complaint::new("film-by-ffmpeg")
        .with("path", Path::new(&*film))
        .with("frames", format!("{stem}.png"))
        .with("animated", format!("{stem}.apng"))
        .with("line", line)
}

/// Draws the frames of scenes. The frames of all scenes are checked before the first one is drawn.
pub(super) fn run(args: &Args, jobs: &[Job], stop: &Arc<AtomicBool>, look: LookChoice) -> Status {
    if let Some(told) = args.picture.frames.note() {
        note(look, &told);
    }
    let mut all = Vec::new();
    for job in jobs {
        match prepared(args, job, stop, look) {
            Ok(frames) => all.push(frames),
            Err(status) => return status,
        }
    }
    let print =
        |said: &str| terminal::print(look, Status::Clean, |out| out.write_all(said.as_bytes()));
    let drawn = (jobs.iter().zip(&all)).map(|(job, frames)| match is_animated(&job.picture) {
        true => match animate(args, job, frames, stop, look) {
            Ok(said) => print(&said),
            Err(status) => status,
        },
        false => draw(args, job, frames, stop, look, &mut |_, said| print(&said)),
    });
    let mut worst = Status::Clean;
    for status in drawn {
        worst = worst.max(status);
        if status == Status::Interrupted {
            break;
        }
    }
    worst
}

/// The file of a frame: its number stands before the ending.
fn place(picture: &Path, label: &str) -> PathBuf {
    match picture.extension() {
        Some(ending) => picture.with_extension(format!("{label}.{}", ending.to_string_lossy())),
        None => picture.with_extension(label),
    }
}

/// The frames of a scene, all of them checked. `Err` is the exit status; the complaint has been printed.
fn prepared(args: &Args, job: &Job, stop: &AtomicBool, look: LookChoice) -> Result<Frames, Status> {
    // Memory holds the scene itself and the scene of a frame.
    if let Err(why) = args.memory.admit(&job.scene, 2) {
        complain(look, &why);
        return Err(Status::Failure);
    }
    let loaded = load_valid(&job.scene, look)?;
    let frames = Frames::of(&args.picture.frames, &loaded).and_then(|frames| {
        writable(args, job, &loaded, &frames)?;
        let staged = args
            .picture
            .camera
            .staged(&loaded.scene, args.picture.size)?;
        // The camera of --view has no ID, which is 0 then.
        let cameras = staged.chosen_cameras().filter(|camera| camera.id > 0);
        for camera in cameras.filter(|camera| frames.leaves_behind(camera)) {
            let id = camera.id.to_string();
            note(look, &Complaint::new("note-camera-stays").with("id", id));
        }
        Ok(frames)
    });
    let frames = frames.map_err(|error| refuse(&loaded, error, look))?;
    check_each(&frames, &loaded, stop, look)?;
    notes::say_of_records(args, &loaded, look);
    Ok(frames)
}

/// Makes sure that the scene of each frame is sound. `Err` is the exit status; the complaint has been printed.
pub fn check_each(
    frames: &Frames,
    loaded: &Analysis,
    stop: &AtomicBool,
    look: LookChoice,
) -> Result<(), Status> {
    for frame in frames.drawn() {
        if stop.load(Ordering::Relaxed) {
            return Err(Status::Interrupted);
        }
        match frames.checked(loaded, frame) {
            Ok(scene) if scene.is_sound() => {}
            Ok(scene) => {
                complain(look, &about("frame-has-errors", frame));
                let mut findings = repair::proposals(&scene);
                findings.retain(Diagnostic::is_error);
                report(&scene.source, &findings, look);
                return Err(Status::Negative);
            }
            Err(why) => {
                complain(look, &about("in-frame", frame).with("why", why));
                return Err(Status::Failure);
            }
        }
    }
    Ok(())
}

fn about(message: &'static str, frame: u32) -> Complaint {
    Complaint::new(message).with("frame", frame.to_string())
}

/// Refuses pictures that cannot be written, or that would overwrite the scene or a picture that it names.
fn writable(args: &Args, job: &Job, loaded: &Analysis, frames: &Frames) -> Result<(), Complaint> {
    let pictures: Vec<PathBuf> = match is_animated(&job.picture) {
        true => {
            try_file(&job.picture)?;
            vec![job.picture.clone()]
        }
        false => {
            let frame = |frame| place(&job.picture, &frames.label(frame));
            drop(Output::create(
                &frame(*frames.drawn().start()),
                [0; 2],
                args.tile.is_some(),
            )?);
            frames.drawn().map(frame).collect()
        }
    };
    // A stereo camera makes a pair of each picture.
    let pairs: Vec<PathBuf> = pictures.iter().flat_map(|p| left_and_right(p)).collect();
    let written = pictures.iter().chain(&pairs);
    refuse_overwrite(&job.scene, loaded, written.map(PathBuf::as_path))
}

/// Draws each frame into a file, and hands the file and the lines to print to `is_drawn`. Ends after the first frame
/// with a status that is not clean.
fn draw(
    args: &Args,
    job: &Job,
    frames: &Frames,
    stop: &Arc<AtomicBool>,
    look: LookChoice,
    is_drawn: &mut dyn FnMut(PathBuf, String) -> Status,
) -> Status {
    let mut look = look;
    for frame in frames.drawn() {
        if stop.load(Ordering::Relaxed) {
            return Status::Interrupted;
        }
        let mut scene = frames.scene(frame);
        scene.forget_records();
        let job = Job {
            scene: job.scene.clone(),
            picture: place(&job.picture, &frames.label(frame)),
        };
        let status = match picture::draw(args, &job, (&scene, 0.0), stop, look) {
            Ok(said) => is_drawn(job.picture, said),
            Err(error) => refuse(&scene, in_frame(error, frame, look), look),
        };
        if status != Status::Clean {
            return status;
        }
        // Notes on the first frame hold for most of the others, and are not repeated.
        look = look.without_notes();
    }
    Status::Clean
}

/// The error with the number of the frame that it is about.
fn in_frame(error: Error, frame: u32, look: LookChoice) -> Error {
    match error {
        Error::Scene { why, span } => Error::Scene {
            why: about("in-frame", frame).with("why", why),
            span,
        },
        // Errors about arguments hold for all frames, and those about files name the file of the frame.
        Error::Request(_) | Error::Interrupted => error,
        Error::Finding(_) => {
            complain(look, &about("frame-has-errors", frame));
            error
        }
    }
}

/// Draws the frames into a temporary folder, and makes an animated picture of them, or a stereo pair. Returns the lines
/// to print.
fn animate(
    args: &Args,
    job: &Job,
    frames: &Frames,
    stop: &Arc<AtomicBool>,
    look: LookChoice,
) -> Result<String, Status> {
    let failed = |why: Complaint| {
        complain(look, &why);
        Status::Failure
    };
    let folder = tempfile::Builder::new().prefix("zpg-").tempdir();
    let folder = folder.map_err(|e| failed(unwritable(&std::env::temp_dir(), &e)))?;
    let frame = Job {
        scene: job.scene.clone(),
        picture: folder.path().join("frame.png"),
    };
    let mut drawn = Vec::new();
    let status = draw(args, &frame, frames, stop, look, &mut |path, _| {
        drawn.push(path);
        Status::Clean
    });
    if status != Status::Clean {
        return Err(status);
    }
    // A stereo camera has made a left and a right picture of each frame.
    let parts: Vec<(PathBuf, Vec<PathBuf>)> = match drawn.first().is_some_and(|path| path.exists())
    {
        true => vec![(job.picture.clone(), drawn)],
        false => {
            let of_side = |i: usize| drawn.iter().map(move |p| left_and_right(p).swap_remove(i));
            let sides = left_and_right(&job.picture).into_iter().enumerate();
            sides
                .map(|(i, path)| (path, of_side(i).collect()))
                .collect()
        }
    };
    let mut said = String::new();
    for (path, pictures) in parts {
        let size = animation::write(&path, &pictures, args.picture.frames.fps()).map_err(failed)?;
        let wrote = Complaint::new("wrote-animation")
            .with("path", path.as_path())
            .with("frames", Value::Count(frames.count().into()))
            .with("width", size[0].to_string())
            .with("height", size[1].to_string());
        if !look.quiet {
            said += &(wrote.wording(look.language()) + "\n");
        }
    }
    Ok(said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_before_the_ending() {
        let place = |path: &str| place(Path::new(path), "0007");
        assert_eq!(place("a/b.c.png"), Path::new("a/b.c.0007.png"));
        assert_eq!(place("orbit.EXR"), Path::new("orbit.0007.EXR"));
    }
}
