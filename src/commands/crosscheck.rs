//! `zpg crosscheck`: what we see of a scene beside what another program does.

mod labels;
mod mitsuba;
mod povray;

use std::fs;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::atomic_file::{self, try_folder, unwritable};
use super::camera::CameraArgs;
use super::help;
use super::refuse_overwrite::refuse_overwrite;
use super::size::Size;
use super::time::Seconds;
use super::{LookChoice, Status, complain, convert, load_valid, terminal, usage};
use crate::analysis::Analysis;
use crate::analysis::file::STDIN;
use crate::commands::refuse;
use crate::diagnostics::layout::wrapped;
use crate::diagnostics::{Complaint, Error, Language, Value};
use crate::study::program::{Program, ProgramError};
use crate::study::whereabouts::Whereabouts;
use crate::trace;
use crate::trace::film::{Packing, write_rgb8};

/// Compare what we see of a scene with what another program does
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The scene is translated, the program looks at it, and the two are compared pixel by pixel. The answer
is \"no\", with exit status 1, when more than 0.05 % of the pixels differ off silhouettes and other edges.

povray: pictures, in linear light. Where an edge goes through the middle of a pixel, what one sample
shows is up to rounding. It is a silhouette where another object is seen beside it, and else an edge of a
face, a shadow, a pattern, or of what is seen in mirrors and glass. POV-Ray treats total internal
reflection in another way. Each of these is counted by itself.
mitsuba: position, normal and shape of what is seen first, from a Python that has the package mitsuba.
Pixels of which single precision cannot tell what is seen, and those of two surfaces in one place, are counted
by themselves. The answer is also \"no\" if there are more of these pixels than of those that agree.

In DIR are then ours.png, theirs.png, difference.png (green: alike, red: differing, grey: silhouettes,
with povray those that differ; yellow: other edges that differ; blue: what else is counted by itself),
side-by-side.png (all three, with labels), crosscheck.json, and the translation; with _left and _right
for a pair of cameras. Pictures of mitsuba show normals as colours, those of solids outwards.

The answer names the share of the pixels that were compared, unless all were.

Examples:
  zpg crosscheck scene.zpg --with povray
  zpg crosscheck scene.zpg --with povray --size 320x240 -o compared --max-diff 1
  zpg crosscheck scene.zpg --with mitsuba --program venv/bin/python")]
pub struct Args {
    /// The scene
    file: PathBuf,

    /// The program
    #[arg(long, value_enum, value_name = "povray|mitsuba")]
    with: Other,

    /// Size of the pictures, in pixels; at most 16777216 of them
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

    /// The folder for pictures and numbers; SCENE-povray or SCENE-mitsuba if not given
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// povray: by how much a channel of a pixel may differ, in 255ths of white
    #[arg(long, default_value_t = 2.0, value_name = "N", value_parser = difference, allow_negative_numbers = true)]
    max_diff: f64,

    /// povray: how often a ray may be mirrored or refracted
    #[arg(help_heading = help::PICTURE)]
    #[arg(long, default_value_t = 10, value_name = "N", value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    depth: u32,

    /// mitsuba: how far meshes may be from curved surfaces, as for convert
    #[arg(long, value_name = "LEN", value_parser = convert::length, allow_negative_numbers = true)]
    tolerance: Option<f64>,

    /// Where the program is, if it is not found by its name: povray, or python3
    #[arg(long, value_name = "PATH")]
    program: Option<PathBuf>,

    /// How long a run of the program may take: 90s, 2m, 1h; glass that splits colours takes three runs
    #[arg(help_heading = help::LIMITS)]
    #[arg(
        long,
        value_name = "TIME",
        default_value = "10m",
        allow_hyphen_values = true
    )]
    timeout: Seconds,

    /// Print the numbers as JSON
    #[arg(long)]
    json: bool,
}

/// The programs to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Other {
    /// POV-Ray 3.7
    Povray,
    /// Mitsuba 3
    Mitsuba,
}

impl Other {
    /// The name of the program for people.
    fn title(self) -> &'static str {
        match self {
            Other::Povray => "POV-Ray",
            Other::Mitsuba => "Mitsuba",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Other::Povray => "povray",
            Other::Mitsuba => "mitsuba",
        }
    }
}

/// The most pixels of a picture: larger ones would need more memory than a machine can be taken to have. Five pictures
/// are held at once, beside what FLIP makes of two.
const MAX_PIXELS: u64 = 1 << 24;

/// The largest share of pixels that may differ off silhouettes.
const MAX_DIFFERING_SHARE: f64 = 0.0005;

fn difference(text: &str) -> Result<f64, Complaint> {
    usage::number(text, "expected-difference", |x| x > 0.0 && x <= 255.0)
}

/// The result of a run, as it stands in crosscheck.json.
#[derive(Serialize)]
struct Answer<T> {
    scene: String,
    with: &'static str,
    size: [u32; 2],
    agrees: bool,
    pictures: Vec<Compared<T>>,
}

/// The comparison of a camera's pictures.
#[derive(Serialize)]
struct Compared<T> {
    /// The suffix of the camera's files: `_left`, `_right`, or nothing.
    name: &'static str,
    /// The share of pixels that were compared.
    compared: f64,
    #[serde(flatten)]
    comparison: T,
}

/// The comparison of what zpg and another program see of a scene.
trait Outcome: Serialize {
    /// The share of pixels that differ off silhouettes.
    fn share(&self) -> f64;

    /// How many pixels there are, and how many of them were not compared.
    fn pixels(&self) -> [usize; 2];

    /// The colours of the difference picture, each with the message that says what it means.
    fn legend() -> &'static [([u8; 3], &'static str)];

    /// The share of pixels that were compared.
    fn compared(&self) -> f64 {
        let [all, left_out] = self.pixels();
        1.0 - left_out as f64 / all.max(1) as f64
    }

    /// The shape that shows most of the pixels that differ off silhouettes, and where; `None` if no pixels differ.
    fn mostly(&self) -> Option<Whereabouts>;

    /// Whether enough pixels could be compared for an answer.
    fn tells(&self) -> bool {
        true
    }

    /// The numbers for people, a line each: the message that labels the line, and the rest of the line.
    fn lines(&self, args: &Args, language: Language) -> Vec<(&'static str, Complaint)>;
}

/// The width of the first column of the answer, in characters.
const WIDTH: usize = 18;

/// The names of the picture files that a run writes for each camera.
const PICTURES: [&str; 4] = ["ours", "theirs", "difference", "side-by-side"];

/// Three pictures of 8-bit RGB.
struct Pictures {
    ours: Vec<u8>,
    theirs: Vec<u8>,
    difference: Vec<u8>,
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    if u64::from(args.size.width) * u64::from(args.size.height) > MAX_PIXELS {
        let max = MAX_PIXELS.to_string();
        complain(look, &Complaint::new("too-many-pixels").with("max", max));
        return Status::Failure;
    }
    if let Err(complaint) = try_folder(&folder(args)) {
        complain(look, &complaint);
        return Status::Failure;
    }
    let loaded = match load_valid(&args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    terminal::end_on_interrupt(look);
    let said = match args.with {
        Other::Povray => povray::compare(args, &loaded, look)
            .and_then(|c| answer(args, &loaded, c, look.language())),
        Other::Mitsuba => mitsuba::compare(args, &loaded, look)
            .and_then(|c| answer(args, &loaded, c, look.language())),
    };
    match said {
        Ok((agrees, text)) => {
            let status = if agrees {
                Status::Clean
            } else {
                Status::Negative
            };
            terminal::print(look, status, |out| out.write_all(&text))
        }
        Err(error) => refuse(&loaded, error, look),
    }
}

/// Writes crosscheck.json. Returns whether the two programs agree, and the text to print.
fn answer<T: Outcome>(
    args: &Args,
    loaded: &Analysis,
    pictures: Vec<Compared<T>>,
    language: Language,
) -> Result<(bool, Vec<u8>), Error> {
    let answer = Answer {
        scene: args.file.to_string_lossy().into_owned(),
        with: args.with.name(),
        size: [args.size.width, args.size.height],
        agrees: pictures
            .iter()
            .all(|p| p.comparison.share() <= MAX_DIFFERING_SHARE && p.comparison.tells()),
        pictures,
    };
    let folder = folder(args);
    let json = serde_json::to_vec_pretty(&answer).unwrap_or_default();
    let json = [&json[..], b"\n"].concat();
    atomic_file::write(&folder.join("crosscheck.json"), |out| out.write_all(&json))?;
    if args.json {
        return Ok((answer.agrees, json));
    }
    let mut text = String::new();
    for Compared {
        name, comparison, ..
    } in &answer.pictures
    {
        let agrees = match (
            comparison.share() <= MAX_DIFFERING_SHARE,
            comparison.tells(),
        ) {
            (true, true) => agreement(comparison.pixels()),
            (true, false) => Complaint::new("crosscheck-cannot"),
            (false, _) => Complaint::new("crosscheck-differs"),
        };
        let [width, height] = answer.size;
        let line = Complaint::new("crosscheck-answer")
            .with("scene", answer.scene.clone())
            .with("name", *name)
            .with("with", answer.with)
            .with("width", width.to_string())
            .with("height", height.to_string())
            .with("answer", agrees);
        let width = terminal::width();
        text += &(wrapped(&line.wording(language), width, "  ") + "\n");
        let mut lines = comparison.lines(args, language);
        if let Some(found) = comparison.mostly() {
            lines.insert(1, ("crosscheck-where", most(loaded, found)));
        }
        for (what, line) in lines {
            let what = language.say(what, &[]);
            let line = format!("  {what:<WIDTH$} {}", line.wording(language));
            text += &(wrapped(&line, width, &" ".repeat(WIDTH + 3)) + "\n");
        }
    }
    let last = Complaint::new("crosscheck-folder").with("folder", folder.as_path());
    text += &(wrapped(&last.wording(language), terminal::width(), "  ") + "\n");
    Ok((answer.agrees, text.into_bytes()))
}

/// The line that says where most of the differing pixels are: on which shape, in which rows and columns.
fn most(loaded: &Analysis, found: Whereabouts) -> Complaint {
    let record = found
        .shape
        .and_then(|id| Some((id, loaded.definition(id)?)));
    let [rows, columns] = [found.rows, found.columns].map(|ends| ends.map(|n| n.to_string()));
    let what = match (record, found.shape) {
        (Some((id, record)), _) => Complaint::new("crosscheck-of-type")
            .with("id", id.to_string())
            .with("type", Value::Term(record.ty().title)),
        (None, Some(id)) => Complaint::quoted(id),
        (None, None) => Complaint::new("crosscheck-background"),
    };
    let [first_row, last_row] = rows;
    let [first_column, last_column] = columns;
    Complaint::new("crosscheck-mostly")
        .with("pixels", Value::Count(found.pixels as u64))
        .with("what", what)
        .with("first-row", first_row)
        .with("last-row", last_row)
        .with("first-column", first_column)
        .with("last-column", last_column)
}

/// The answer "yes", which says how many of the pixels were compared unless all were. The share is rounded down: 100 %
/// is all.
fn agreement([all, left_out]: [usize; 2]) -> Complaint {
    if left_out == 0 {
        return Complaint::new("crosscheck-agrees");
    }
    let percent = match 100 * (all - left_out) / all {
        0 => "< 1".to_owned(),
        percent => percent.to_string(),
    };
    Complaint::new("crosscheck-agrees-in-part").with("percent", percent)
}

/// The scene's name without its extension; for standard input `scene`.
fn stem(args: &Args) -> String {
    let stem = match args.file.to_str() {
        Some(STDIN) => None,
        _ => args.file.file_stem(),
    };
    let stem = stem.unwrap_or("scene".as_ref());
    stem.to_string_lossy().into_owned()
}

fn folder(args: &Args) -> PathBuf {
    (args.output.clone())
        .unwrap_or_else(|| PathBuf::from(format!("{}-{}", stem(args), args.with.name())))
}

/// The folder for the pictures and numbers of a run.
struct Folder {
    path: PathBuf,
    /// Whether the folder was not there before.
    is_new: bool,
}

impl Folder {
    /// Makes the folder. Refuses if one of the pictures or `files` that go there would overwrite the scene or a picture
    /// that it names.
    fn made<'f>(
        args: &Args,
        loaded: &Analysis,
        files: impl IntoIterator<Item = &'f str>,
    ) -> Result<Folder, Complaint> {
        let path = folder(args);
        let ends = ["", "_left", "_right"];
        let pictures = ends.map(|end| PICTURES.map(|name| format!("{name}{end}.png")));
        let ours = pictures.iter().flatten().map(|name| path.join(name));
        let files = files.into_iter().map(|name| path.join(name));
        let paths: Vec<PathBuf> = ours.chain(files).collect();
        refuse_overwrite(&args.file, loaded, paths.iter().map(PathBuf::as_path))?;
        let is_new = !path.exists();
        match fs::create_dir_all(&path) {
            Ok(()) => Ok(Folder { path, is_new }),
            Err(e) => Err(unwritable(&path, &e)),
        }
    }

    /// Removes the folder if this run has made it: without an answer of the program it is of no use.
    fn forget(&self) {
        if self.is_new {
            let _ = fs::remove_dir_all(&self.path);
        }
    }
}

/// The program to run, with a path that holds in any folder, and with the time limit.
fn program(args: &Args, name: &str) -> Program {
    let path = match &args.program {
        // The system looks for a name alone where programs are, so that it stays as it is.
        Some(path) if path.components().count() > 1 => {
            std::path::absolute(path).unwrap_or_else(|_| path.clone())
        }
        Some(path) => path.clone(),
        None => PathBuf::from(name),
    };
    Program {
        limit: Some(args.timeout.into()),
        ..Program::new(path)
    }
}

/// Compares what each camera sees, and writes the pictures. `suffixes` has the end of the file names for each camera.
/// `look` gets the number of a camera, from 0, and its suffix, and returns the pictures and their comparison.
fn each_camera<T: Outcome>(
    args: &Args,
    language: Language,
    folder: &Path,
    suffixes: impl IntoIterator<Item = &'static str>,
    mut look: impl FnMut(usize, &str) -> Result<(Pictures, T), Error>,
) -> Result<Vec<Compared<T>>, Error> {
    let say = |message: &'static str| language.say(message, &[]);
    let titles = [
        "zpg".to_owned(),
        args.with.title().to_owned(),
        say("crosscheck-difference"),
    ];
    let legend: Vec<_> = (T::legend().iter())
        .map(|(colour, meaning)| (*colour, say(meaning)))
        .collect();
    let mut compared = Vec::new();
    for (i, name) in suffixes.into_iter().enumerate() {
        let (pictures, comparison) = look(i, name)?;
        write_pictures(folder, name, args.size, &pictures, &titles, &legend)?;
        compared.push(Compared {
            name,
            compared: comparison.compared(),
            comparison,
        });
    }
    Ok(compared)
}

/// Loads the pictures that the scene names.
fn images(loaded: &Analysis) -> Result<trace::Images, Error> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    trace::Images::load(&loaded.scene, folder).map_err(Error::from)
}

/// The words that tell people about a program.
struct Asked {
    /// The name of the program for people.
    name: &'static str,
    /// The message that says how to get the program.
    how: &'static str,
    /// The message that says what to do if the program takes too long.
    late: &'static str,
}

impl Asked {
    /// The complaint that the program gave no answer. Removes a new folder if the program did not even start.
    fn failed(&self, error: ProgramError, program: &Program, folder: &Folder) -> Complaint {
        match error {
            ProgramError::Missing => {
                folder.forget();
                let is_place = program.path.components().count() > 1;
                if is_place && !program.path.exists() {
                    return Complaint::new("no-such-program").with("path", program.path.as_path());
                }
                Complaint::new("no-program")
                    .with("how", Complaint::new(self.how))
                    .with("path", program.path.as_path())
            }
            ProgramError::Start(e) => {
                folder.forget();
                Complaint::new("program-failed").with("said", e.to_string())
            }
            ProgramError::Io(e) => return unwritable(&folder.path, &e),
            ProgramError::Failed(said) => {
                Complaint::new("program-failed").with("said", said.replace('\n', "\n    "))
            }
            ProgramError::Late(limit) => Complaint::new("program-late")
                .with("seconds", limit.as_secs_f64().to_string())
                .with("instead", Complaint::new(self.late)),
            ProgramError::Unexpected(what) => {
                Complaint::new("program-strange").with("what", Value::Term(what))
            }
        }
        .with("program", self.name)
    }
}

fn write_pictures(
    folder: &Path,
    suffix: &str,
    size: Size,
    pictures: &Pictures,
    titles: &[String; 3],
    legend: &[labels::Meaning],
) -> Result<(), Complaint> {
    let Size { width, height } = size;
    let Pictures {
        ours,
        theirs,
        difference,
    } = pictures;
    let [own, other, apart] = titles;
    let titled: [(&str, &[u8]); 3] = [(own, ours), (other, theirs), (apart, difference)];
    let all = labels::beside([width, height], titled, legend);
    let files = [
        ([width, height], ours),
        ([width, height], theirs),
        ([width, height], difference),
        ([all.width, all.height], &all.rgb),
    ];
    for (name, (size, rgb)) in PICTURES.into_iter().zip(files) {
        let path = folder.join(format!("{name}{suffix}.png"));
        atomic_file::write(&path, |out| write_rgb8(out, size, rgb, Packing::Quick))?;
    }
    Ok(())
}
