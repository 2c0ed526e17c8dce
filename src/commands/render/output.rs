//! Picture files, and pictures on standard output.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use crate::commands::atomic_file::{AtomicFile, folder_of, unwritable};
use crate::commands::paths::is_stdout;
use crate::diagnostics::Complaint;
use crate::picture_files::{self, Origin, Row};
use crate::trace::{CostMap, Film};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Rows(picture_files::Format),
    Jpeg,
    WebP,
    Pfm,
}

impl Format {
    /// The format that the ending of a file name stands for; `None` if there is none.
    fn of(path: &Path) -> Option<Format> {
        if let Some(format) = picture_files::Format::of(path) {
            return Some(Format::Rows(format));
        }
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        Some(match extension.to_lowercase().as_str() {
            "jpg" | "jpeg" => Format::Jpeg,
            "webp" => Format::WebP,
            "pfm" => Format::Pfm,
            _ => return None,
        })
    }

    /// The most pixels that a picture of this format may be wide or high.
    fn longest_side(self) -> u32 {
        match self {
            Format::Jpeg => u16::MAX.into(),
            Format::WebP => 1 << 14,
            Format::Rows(_) | Format::Pfm => u32::MAX,
        }
    }
}

/// A picture file that is being written.
pub struct Output {
    path: PathBuf,
    draft: AtomicFile,
    format: Format,
}

impl Output {
    /// Makes sure that a picture of this width and height, or a part of one, can be written to the file. `-` is
    /// standard output, which takes a PNG.
    pub fn create(path: &Path, size: [u32; 2], is_part: bool) -> Result<Output, Complaint> {
        let format = match is_stdout(path) {
            true => Some(Format::Rows(picture_files::Format::Png)),
            false => Format::of(path),
        };
        let format = format.ok_or_else(|| Complaint::new("unknown-format").with("path", path))?;
        if is_part && !matches!(format, Format::Rows(_)) {
            return Err(Complaint::new("part-format").with("path", path));
        }
        if size.into_iter().any(|side| side > format.longest_side()) {
            let most = format.longest_side().to_string();
            let complaint = Complaint::new("too-large-for-format").with("most", most);
            return Err(complaint.with("path", path));
        }
        Ok(Output {
            path: path.to_owned(),
            draft: AtomicFile::create(path)?,
            format,
        })
    }

    /// Makes sure that a map of costs can be written to the file, which must be a PNG.
    pub fn create_map(path: &Path) -> Result<Output, Complaint> {
        let output = Output::create(path, [0; 2], false)?;
        match output.format {
            Format::Rows(picture_files::Format::Png) if !is_stdout(path) => Ok(output),
            _ => Err(Complaint::new("map-is-png").with("path", path)),
        }
    }

    /// Writes a map of costs whose colour scale ends at `max`, and returns its path.
    pub fn finish_map(self, costs: &CostMap, max: u32) -> Result<PathBuf, Complaint> {
        self.draft.finish(|out| costs.write_png(out, max))?;
        Ok(self.path)
    }

    /// Writes the picture. PNG and EXR also get its origin. Returns the path; `None` for standard output.
    pub fn finish(self, film: &Film, origin: &Origin) -> Result<Option<PathBuf>, Complaint> {
        self.draft.finish(|out| match self.format {
            Format::Rows(format) => {
                let mut rows = film.rows().map(|row| Ok(Row::Linear(row.to_vec())));
                picture_files::write(format, out, origin, &mut rows)
            }
            Format::Jpeg => film.write_jpeg(out),
            Format::WebP => film.write_webp(out),
            Format::Pfm => film.write_pfm(out),
        })?;
        Ok(Some(self.path).filter(|path| !is_stdout(path)))
    }
}

/// The message that a picture was written: its width and height in pixels.
pub fn wrote(path: &Path, [width, height]: [u32; 2]) -> Complaint {
    Complaint::new("wrote-picture")
        .with("path", path)
        .with("width", width.to_string())
        .with("height", height.to_string())
}

/// The file for the picture of each scene. Without `output` it is in the current folder. Several scenes need a folder,
/// which is made. The scenes of a folder keep their subfolders: `below` gives a scene's path below its folder.
pub fn places(
    scenes: &[PathBuf],
    several: bool,
    output: Option<&Path>,
    below: impl Fn(&Path) -> PathBuf,
) -> Result<Vec<PathBuf>, Complaint> {
    let folder = match output {
        Some(path) if is_stdout(path) && several => {
            return Err(Complaint::new("several-on-stdout"));
        }
        Some(path) if several || is_folder(path) => {
            if Format::of(path).is_some() && !path.is_dir() {
                return Err(Complaint::new("several-in-one-file").with("path", path));
            }
            path
        }
        Some(path) => return Ok(vec![path.to_owned()]),
        None => Path::new(""),
    };
    let mut taken = HashMap::new();
    let mut pictures = Vec::new();
    for scene in scenes {
        let within = below(scene);
        let stem = within.file_stem().filter(|stem| *stem != "-");
        let name = with_added(stem.unwrap_or("scene".as_ref()), "", "png");
        let picture = folder.join(&within).with_file_name(name);
        if let Some(other) = taken.insert(picture.clone(), scene) {
            return Err(Complaint::new("pictures-of-one-name")
                .with("path", picture.as_path())
                .with("scene", other.as_path())
                .with("other", scene.as_path()));
        }
        pictures.push(picture);
    }
    for picture in &pictures {
        let folder = folder_of(picture);
        fs::create_dir_all(folder).map_err(|e| unwritable(folder, &e))?;
    }
    Ok(pictures)
}

/// Whether a path names a folder: it is one, or ends with a slash.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(std::path::is_separator)
}

/// Whether a file has the name of the picture, or of the left or right picture of its pair.
pub fn is_made(picture: &Path, file: &Path) -> bool {
    let pair = left_and_right(picture);
    let names = pair.iter().map(PathBuf::as_path).chain([picture]);
    let mut names = names.filter_map(Path::file_name);
    file.file_name()
        .is_some_and(|file| names.any(|name| name == file))
}

/// The paths of the left and the right picture of a stereo pair.
pub fn left_and_right(path: &Path) -> Vec<PathBuf> {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    ["_left", "_right"]
        .map(|side| with_added(path.with_extension("").as_os_str(), side, &extension))
        .into()
}

/// The files beside the picture, one for each camera, in which an interrupted run leaves the rows that it has drawn.
pub fn unfinished(picture: &Path, cameras: usize) -> Vec<PathBuf> {
    let sides: &[&str] = match cameras {
        1 => &[""],
        _ => &["_left", "_right"],
    };
    let stem = picture.with_extension("");
    let part = |side: &&str| with_added(stem.as_os_str(), side, "part.exr");
    sides.iter().map(part).collect()
}

/// A path with something added to its file name, and an extension.
fn with_added(path: &OsStr, name: &str, extension: &str) -> PathBuf {
    let mut path = path.to_owned();
    path.push(format!("{name}.{extension}"));
    path.into()
}
