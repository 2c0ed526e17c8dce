//! `zpg sheet`: all pictures of a folder on one sheet.

mod average;
mod cell;
mod entry;
mod findings;
mod image;
mod page;
mod picture;

use std::cell::RefCell;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use ignore::WalkBuilder;

use self::cell::{Cell, Heading, without_picture};
use self::entry::{SheetBox, entries};
use self::findings::Findings;
use super::atomic_file::AtomicFile;
use super::paths::{is_stdout, unreadable_entry};
use super::size::Size;
use super::terminal::{progress_bar, stop_on_interrupt, tell};
use super::{LookChoice, Status, complain, usage};
use crate::analysis::file::unreadable;
use crate::diagnostics::Complaint;
use crate::picture_files;

/// Put all pictures of a folder on one sheet
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The sheet shows each picture of DIR and its subfolders (.png, .jpg, .webp, .exr, .pfm) with its name and size, in
the order of names. A thumbnail pixel is the average of what it covers, in linear light; small pictures keep
their size. Hidden files and earlier sheets are left out.

If DIR holds findings.json, which `zpg check --format json` writes, each picture has the number of errors and
warnings of the scene of its name, and in HTML the findings. A scene without a picture has a box of its own. A
picture belongs to the scene in the same subfolder, or to the only scene of its name. NAME_left, NAME_right
and NAME.0001 belong to the scene NAME.

A picture that cannot be read has a box that says why. Exit status: 2 if there is one, else 0; findings do not
change it.

Examples:
  zpg sheet pictures -o sheet.png
  zpg sheet pictures -o sheet.html --size 320x240
  zpg render submissions/ -o pictures/
  zpg check --format json submissions/ > pictures/findings.json
  zpg sheet pictures -o sheet.html        what each has drawn, and what is wrong with it")]
pub struct Args {
    /// The folder with the pictures
    #[arg(value_name = "DIR")]
    folder: PathBuf,

    /// The sheet: a picture (.png) or a page (.html); `-` is a PNG on standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,

    /// How many pictures a row has at most [default: a number that fits]
    #[arg(long, value_name = "N", value_parser = columns, allow_negative_numbers = true)]
    columns: Option<u32>,

    /// Size of a thumbnail at most, in pixels, from 32x32 to 1024x1024
    #[arg(
        long,
        default_value = "240x180",
        value_name = "WxH",
        value_parser = thumbnail,
        allow_hyphen_values = true
    )]
    size: Size,
}

/// The widths and heights in pixels that a thumbnail may have.
const SIDES: std::ops::RangeInclusive<u32> = 32..=1024;

fn columns(text: &str) -> Result<u32, Complaint> {
    usage::number(text, "expected-columns", |n| (1..=10_000).contains(&n))
}

fn thumbnail(text: &str) -> Result<Size, Complaint> {
    let size: Size = text.parse()?;
    match SIDES.contains(&size.width) && SIDES.contains(&size.height) {
        true => Ok(size),
        false => Err(Complaint::new("expected-thumbnail")),
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Png,
    Html,
}

impl Format {
    fn of(path: &Path) -> Result<Format, Complaint> {
        let ending = path.extension().unwrap_or_default().to_string_lossy();
        match ending.to_lowercase().as_str() {
            _ if is_stdout(path) => Ok(Format::Png),
            "png" => Ok(Format::Png),
            "html" | "htm" => Ok(Format::Html),
            _ => Err(Complaint::new("sheet-format").with("path", path)),
        }
    }
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    sheet(args, look).unwrap_or_else(|complaint| {
        complain(look, &complaint);
        Status::Failure
    })
}

fn sheet(args: &Args, look: LookChoice) -> Result<Status, Complaint> {
    let format = Format::of(&args.output)?;
    let mut status = Status::Clean;
    let pictures = pictures_in(&args.folder, look, &mut status)?;
    refuse_overwrite(&pictures, &args.output)?;
    let findings = Findings::of_folder(&args.folder)?;
    let scenes = findings.as_ref().map_or(&[][..], |found| &found.scenes);
    let heading = Heading {
        folder: name_of(&args.folder),
        pictures: pictures.len(),
        counts: findings.as_ref().map(Findings::counts),
    };
    let entries = entries(&args.folder, pictures, scenes);
    if entries.is_empty() {
        return Err(Complaint::new("no-pictures").with("path", args.folder.as_path()));
    }
    let language = look.language();
    let line = heading.line(language);
    let layout = image::Layout::new(entries.len(), args.columns, args.size, &line);
    let layout = (format == Format::Png).then_some(layout).transpose()?;
    let draft = AtomicFile::create(&args.output)?;
    let bar = progress_bar(entries.len() as u64, look);
    let stop = stop_on_interrupt(look);
    let unread = RefCell::new(Vec::new());
    let cells = entries.iter().map(|entry| {
        if stop.load(Ordering::Relaxed) {
            return Err(io::ErrorKind::Interrupted.into());
        }
        bar.inc(1);
        let cell = read(entry, args.size);
        if let (Some(path), Err(why)) = (&entry.picture, &cell.picture) {
            unread.borrow_mut().push(unreadable(path, why.clone()));
        }
        Ok(cell)
    });
    let written = draft.finish(|out| match &layout {
        Some(layout) => image::write(out, layout, language, cells),
        None => page::write(out, &heading, args.columns, args.size, language, cells),
    });
    bar.finish_and_clear();
    if stop.load(Ordering::Relaxed) && written.is_err() {
        return Ok(Status::Interrupted);
    }
    written?;
    for complaint in unread.into_inner() {
        complain(look, &complaint);
        status = Status::Failure;
    }
    if !is_stdout(&args.output) && !look.quiet {
        let wrote = Complaint::new("wrote-file").with("path", args.output.as_path());
        tell(&wrote.wording(language));
    }
    Ok(status)
}

fn read<'e>(entry: &'e SheetBox, size: Size) -> Cell<'e> {
    let picture = match (&entry.picture, entry.scene) {
        (Some(path), _) => picture::shrunk(path, [size.width, size.height]),
        (None, scene) => Err(without_picture(
            scene.map_or_else(Default::default, |s| s.counts()),
        )),
    };
    Cell { entry, picture }
}

/// The name of a folder, however the path to it is written.
fn name_of(folder: &Path) -> String {
    let full = folder.canonicalize();
    let name = full.as_deref().ok().and_then(Path::file_name);
    name.unwrap_or(folder.as_os_str())
        .to_string_lossy()
        .into_owned()
}

/// The pictures of a folder and its subfolders, without earlier sheets. A folder that cannot be read is complained
/// about, and makes `status` a failure.
fn pictures_in(
    folder: &Path,
    look: LookChoice,
    status: &mut Status,
) -> Result<Vec<PathBuf>, Complaint> {
    match folder.metadata() {
        Err(e) => return Err(unreadable(folder, Complaint::from(&e))),
        Ok(found) if !found.is_dir() => {
            return Err(unreadable(folder, Complaint::new("io-not-a-directory")));
        }
        Ok(_) => {}
    }
    let mut pictures = Vec::new();
    // `.gitignore` does not count, as it often names pictures.
    let mut walk = WalkBuilder::new(folder);
    walk.standard_filters(false).hidden(true);
    for entry in walk.build() {
        match entry {
            Ok(entry) if is_picture(entry.path()) => pictures.push(entry.into_path()),
            Ok(_) => {}
            Err(e) => {
                complain(look, &unreadable_entry(&e, folder));
                *status = Status::Failure;
            }
        }
    }
    Ok(pictures)
}

/// Whether a file is a whole picture, and no earlier sheet.
fn is_picture(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    let mut endings = picture::ENDINGS.iter();
    endings.any(|e| ending.eq_ignore_ascii_case(e))
        && path.is_file()
        && !image::is_sheet(path)
        && !picture_files::is_part(path)
}

/// Refuses to write over a picture of the sheet.
fn refuse_overwrite(pictures: &[PathBuf], output: &Path) -> Result<(), Complaint> {
    let Ok(there) = output.canonicalize() else {
        return Ok(());
    };
    let mut pictures = pictures
        .iter()
        .filter_map(|picture| picture.canonicalize().ok());
    match pictures.any(|picture| picture == there) {
        true => Err(Complaint::new("would-overwrite-picture").with("path", output)),
        false => Ok(()),
    }
}
