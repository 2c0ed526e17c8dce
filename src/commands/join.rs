//! `zpg join`: puts the parts of a picture together.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::atomic_file::{AtomicFile, unwritable};
use super::render::output::wrote;
use super::terminal::{self, LookChoice, complain, note};
use super::{Status, refuse_overwrite};
use crate::diagnostics::{Complaint, Value};
use crate::picture_files::{self, Format, Origin, read};

/// Put the parts of a picture together
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The parts are what `zpg render --tile` writes. The picture has the bytes that `zpg render` without --tile would have
written. Parts of another picture, another version of zpg, or other options are refused, and so are rows that are
missing or there twice: the exit status is then 1, and nothing is written or removed. A folder stands for the PNG and
EXR files in it. PNG parts make a PNG; EXR parts make a PNG or an EXR. The parts are removed unless --keep is given;
EXR parts that make a PNG stay, since they have more than it.

Examples:
  zpg join bands/*.png -o scene.png
  zpg join bands -o scene.exr --keep")]
pub struct Args {
    /// The parts, or folders with them
    #[arg(value_name = "PART", required = true)]
    parts: Vec<PathBuf>,

    /// Where to write the picture: .png or .exr
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,

    /// Leave the parts where they are
    #[arg(long)]
    keep: bool,
}

/// The file of a part, with the origin and the format that it states.
struct PartFile {
    path: PathBuf,
    origin: Origin,
    format: Format,
}

/// The reason why no picture is written.
enum Refusal {
    /// Parts are missing, or do not belong to the same picture.
    No(Complaint),
    /// A file cannot be read or written.
    Failure(Complaint),
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    match join(args, look) {
        Ok(_) if look.quiet => {}
        Ok(joined) => {
            let wrote = wrote(&args.output, joined.whole.size);
            let wrote = match joined.removed {
                0 => wrote,
                n => (Complaint::new("wrote-joined").with("wrote", wrote))
                    .with("count", Value::Count(n as u64)),
            };
            let line = wrote.wording(look.language());
            return terminal::print(look, Status::Clean, |out| writeln!(out, "{line}"));
        }
        Err(Refusal::No(complaint)) => {
            complain(look, &complaint);
            return Status::Negative;
        }
        Err(Refusal::Failure(complaint)) => {
            complain(look, &complaint);
            return Status::Failure;
        }
    }
    Status::Clean
}

/// A picture that was made of parts.
struct Joined {
    whole: Origin,
    /// The number of parts that were removed.
    removed: usize,
}

fn join(args: &Args, look: LookChoice) -> Result<Joined, Refusal> {
    let output = args.output.as_path();
    let format = Format::of(output)
        .ok_or_else(|| Complaint::new("joined-format").with("path", output))
        .map_err(Refusal::Failure)?;
    let (files, left_out) = files(&args.parts, output).map_err(Refusal::Failure)?;
    if !left_out.is_empty() {
        note(look, &of_left_out(&left_out));
    }
    if files.is_empty() {
        return Err(Refusal::Failure(Complaint::new("no-parts")));
    }
    let mut parts = (files.into_iter().map(opened)).collect::<Result<Vec<PartFile>, Refusal>>()?;
    parts.sort_by_key(|part| part.origin.span());
    let whole = whole(&parts).map_err(Refusal::No)?;
    let is_srgb = |part: &&PartFile| part.format == Format::Png;
    if let Some(part) = parts.iter().find(is_srgb).filter(|_| format == Format::Exr) {
        let complaint = Complaint::new("exr-of-png").with("path", part.path.as_path());
        return Err(Refusal::No(complaint));
    }
    // Each part is opened again when its rows are needed, and may have changed since.
    let mut fault = None;
    let rows = parts
        .iter()
        .flat_map(|part| rows(part).unwrap_or_else(failing));
    let mut rows = rows.map(|row| {
        row.map_err(|complaint| {
            fault = Some(complaint);
            io::Error::other("a part cannot be read")
        })
    });
    let draft = AtomicFile::create(output).map_err(Refusal::Failure)?;
    let written = draft.finish(|out| picture_files::write(format, out, &whole, &mut rows));
    drop(rows);
    if let Some(complaint) = fault {
        return Err(Refusal::No(complaint));
    }
    written.map_err(Refusal::Failure)?;
    // EXR parts of a PNG stay, since their linear colours are more than a PNG has.
    let is_all = |part: &&PartFile| part.format == format;
    let mut removed = 0;
    if !args.keep {
        for part in parts.iter().filter(is_all) {
            match fs::remove_file(&part.path) {
                Ok(()) => removed += 1,
                // A part that is gone has been removed by another run that joined the same parts.
                Err(e) if e.kind() != io::ErrorKind::NotFound => {
                    return Err(Refusal::Failure(unwritable(&part.path, &e)));
                }
                _ => {}
            }
        }
    }
    Ok(Joined { whole, removed })
}

/// The rows of a part from the top; an error ends them.
type Rows<'p> = Box<dyn Iterator<Item = Result<picture_files::Row, Complaint>> + 'p>;

/// Opens a part again for its rows. `Err` if its origin has changed since it was first read.
fn rows(part: &PartFile) -> Result<Rows<'_>, Complaint> {
    let rows = read::open(&part.path)?;
    match rows.origin == part.origin {
        true => Ok(Box::new(rows.all(&part.path))),
        false => Err(Complaint::new("part-changed").with("path", part.path.as_path())),
    }
}

fn failing<'p>(complaint: Complaint) -> Rows<'p> {
    Box::new(std::iter::once(Err(complaint)))
}

/// Collects the files that are named, and the pictures in the folders that are named. The second list has the pictures
/// in these folders that are no parts: those of other formats, and one with the name of the picture to be made.
fn files(parts: &[PathBuf], output: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>), Complaint> {
    let (mut files, mut left_out) = (Vec::new(), Vec::new());
    for part in parts {
        if !part.is_dir() {
            refuse_overwrite::refuse_overwrite_of_scenes(std::slice::from_ref(part), output)?;
            files.push(part.clone());
            continue;
        }
        let unreadable = |e: io::Error| {
            Complaint::new("cannot-read")
                .with("path", part.as_path())
                .with("reason", Complaint::from(&e))
        };
        for entry in fs::read_dir(part).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            let is_other = || {
                let ending = path.extension().unwrap_or_default();
                OTHERS
                    .iter()
                    .any(|other| ending.eq_ignore_ascii_case(other))
            };
            match Format::of(&path) {
                Some(_) if path.file_name() != output.file_name() => files.push(path),
                Some(_) => left_out.push(path),
                None if is_other() => left_out.push(path),
                None => {}
            }
        }
    }
    left_out.sort();
    Ok((files, left_out))
}

/// The endings of pictures that are no parts.
const OTHERS: [&str; 5] = ["jpg", "jpeg", "webp", "pfm", "apng"];

/// The most left-out files that the note names.
const NAMED_FILES: usize = 8;

/// The note that names the pictures in folders that are left out.
fn of_left_out(left_out: &[PathBuf]) -> Complaint {
    let named = left_out.iter().take(NAMED_FILES);
    let mut named: Vec<String> = named.map(|path| path.display().to_string()).collect();
    if left_out.len() > NAMED_FILES {
        named.push("…".to_owned());
    }
    Complaint::new("parts-left-out").with("paths", named.join(", "))
}

/// Opens the file of a part and reads the origin and the format that it states.
fn opened(path: PathBuf) -> Result<PartFile, Refusal> {
    if let Err(e) = fs::metadata(&path) {
        let complaint = Complaint::new("cannot-read").with("path", path.as_path());
        return Err(Refusal::Failure(
            complaint.with("reason", Complaint::from(&e)),
        ));
    }
    let rows = read::open(&path).map_err(Refusal::No)?;
    Ok(PartFile {
        origin: rows.origin,
        format: rows.format,
        path,
    })
}

/// The origin of the picture that the parts make together. The parts must be sorted by their rows. `Err` if a part does
/// not belong, or rows are missing or there twice.
fn whole(parts: &[PartFile]) -> Result<Origin, Complaint> {
    let unfinished = parts.iter().find(|part| part.origin.unfinished);
    if let Some(part) = unfinished {
        return Err(Complaint::new("joined-unfinished").with("path", part.path.as_path()));
    }
    // Whoever names a finished picture has mistaken it for a part, and wants to keep it.
    if let Some(part) = parts.iter().find(|part| part.origin.is_whole()) {
        return Err(Complaint::new("joined-whole").with("path", part.path.as_path()));
    }
    let most = most_common(parts);
    if let Some(part) = (parts.iter()).find(|p| !p.origin.is_of_one_picture(&most.origin)) {
        let reason = difference(&part.origin, &most.origin);
        return Err(Complaint::new("part-of-another")
            .with("path", part.path.as_path())
            .with("other", most.path.as_path())
            .with("reason", Complaint::new(reason)));
    }
    let height = most.origin.size[1];
    let mut end = 0;
    let mut missing = Vec::new();
    let mut before: Option<&PartFile> = None;
    for part in parts {
        let [first, count] = part.origin.span();
        if let Some(before) = before.filter(|_| first < end) {
            return Err(Complaint::new("rows-twice")
                .with("first", first.to_string())
                .with("last", (end.min(first + count) - 1).to_string())
                .with("path", before.path.as_path())
                .with("other", part.path.as_path()));
        }
        missing.extend((end < first).then_some((end, first)));
        end = first + count;
        before = Some(part);
    }
    missing.extend((end < height).then_some((end, height)));
    if !missing.is_empty() {
        return Err(lacking(&missing, height));
    }
    Ok(Origin {
        rows: vec![[0, height]],
        ..most.origin.clone()
    })
}

/// A part of the picture to which most of the parts belong.
fn most_common(parts: &[PartFile]) -> &PartFile {
    let of = |one: &PartFile| {
        let alike = |part: &&PartFile| part.origin.is_of_one_picture(&one.origin);
        parts.iter().filter(alike).count()
    };
    // Three candidates are enough: after a wrong choice, too, a part of another picture is found and complained about.
    let candidates = &parts[..parts.len().min(3)];
    candidates
        .iter()
        .max_by_key(|part| of(part))
        .unwrap_or(&parts[0])
}

/// The most gaps that the complaint about missing rows names.
const NAMED_GAPS: usize = 8;

/// The complaint about missing rows. `missing` has the first row of each gap and the row behind its last one; `height`
/// is the picture's number of rows.
fn lacking(missing: &[(u32, u32)], height: u32) -> Complaint {
    let gap = |&(start, end): &(u32, u32)| match end - start {
        1 => start.to_string(),
        _ => format!("{start}–{}", end - 1),
    };
    let mut gaps: Vec<String> = missing.iter().take(NAMED_GAPS).map(gap).collect();
    if missing.len() > NAMED_GAPS {
        gaps.push("…".to_owned());
    }
    let count: u32 = missing.iter().map(|(start, end)| end - start).sum();
    Complaint::new("rows-missing")
        .with("rows", gaps.join(", "))
        .with("count", count.to_string())
        .with("height", height.to_string())
}

/// The message that says in what two pictures differ: the version of zpg, the scene or the options.
fn difference(one: &Origin, other: &Origin) -> &'static str {
    match () {
        () if one.version != other.version => "of-another-version",
        () if one.scene != other.scene => "of-another-scene",
        () => "of-other-options",
    }
}
