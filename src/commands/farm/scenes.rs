//! The scenes of a job, and the textures that they need.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::analysis::Analysis;
use crate::commands::atomic_file::{self, folder_of, unwritable};
use crate::commands::paths::{is_stdin, place_below};
use crate::commands::refuse_overwrite::refuse_overwrite_of_scenes;
use crate::diagnostics::Complaint;
use crate::scene::Texture;

/// A scene of the job.
pub(super) struct Scene {
    pub path: PathBuf,
    /// The path of the scene within the job's folder of scenes.
    pub place: PathBuf,
    pub loaded: Analysis,
    /// Seconds that it took to read the scene.
    pub reading: f64,
}

/// The file of the job that lists the scenes that are drawn, one a line.
const LIST: &str = "scenes.txt";
/// The folder of the job with the scenes.
const SCENES: &str = "scenes";

/// The files that lie in a folder, and the others.
pub(super) fn in_folder(folder: &Path, files: Vec<PathBuf>) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let folder = folder.canonicalize().ok();
    let is_in = |file: &PathBuf| {
        let place = file.canonicalize().ok();
        (place.zip(folder.as_ref())).is_some_and(|(place, folder)| place.starts_with(folder))
    };
    files.into_iter().partition(is_in)
}

/// Each scene file with its path within the job's folder of scenes. The path is the one below the folder that was
/// named; if two scenes had the same path, folders with numbers keep the scenes apart.
pub(super) fn places(paths: &[PathBuf], files: Vec<PathBuf>) -> Vec<(PathBuf, PathBuf)> {
    let below: Vec<PathBuf> = (files.iter())
        .map(|file| place_below(paths, file))
        .collect();
    let different: BTreeSet<&PathBuf> = below.iter().collect();
    if different.len() == files.len() {
        return files.into_iter().zip(below).collect();
    }
    let folders: BTreeSet<PathBuf> = files.iter().map(|f| folder_of(f).to_owned()).collect();
    let folders: BTreeMap<PathBuf, usize> = folders.into_iter().zip(1..).collect();
    let numbered = |file: PathBuf| {
        let folder = folders[folder_of(&file)].to_string();
        let place = Path::new(&folder).join(file.file_name().unwrap_or_default());
        (file, place)
    };
    files.into_iter().map(numbered).collect()
}

/// Makes sure that a job can name these scenes: its list has a place a line.
pub(super) fn check_places(places: &[(PathBuf, PathBuf)]) -> Result<(), Complaint> {
    for (file, place) in places {
        let is_line = |place: &str| !place.contains(['\n', '\r']);
        match is_stdin(file) {
            true => return Err(Complaint::new("farm-stdin")),
            false if place.to_str().is_some_and(is_line) => {}
            false => return Err(Complaint::new("farm-name").with("path", file.as_path())),
        }
    }
    Ok(())
}

/// Makes sure that each scene has a picture of its own.
pub(super) fn check_pictures(scenes: &[Scene]) -> Result<(), Complaint> {
    let mut seen = HashSet::new();
    let twice = (scenes.iter())
        .map(|scene| scene.place.with_extension(""))
        .find(|picture| !seen.insert(picture.clone()));
    twice.map_or(Ok(()), |picture| {
        Err(Complaint::new("farm-same-name").with("name", picture.display().to_string()))
    })
}

/// A name for the job: letters, digits and dashes.
pub(super) fn name(place: &Path) -> String {
    let stem = place.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| match c.is_ascii_alphanumeric() {
        true => c,
        false => '-',
    };
    format!(
        "zpg-{}",
        stem.chars().map(plain).take(40).collect::<String>()
    )
}

/// Makes sure that the folder does not exist, is empty, or is an earlier job. Returns whether it is an earlier job.
pub(super) fn check_folder(folder: &Path) -> Result<bool, Complaint> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            return atomic_file::try_folder(folder).map(|()| false);
        }
        Err(e) => return Err(unwritable(folder, &e)),
    };
    let is_job = folder.join(LIST).is_file();
    match entries.count() > 0 && !is_job {
        true => Err(Complaint::new("farm-folder").with("path", folder)),
        false => Ok(is_job),
    }
}

/// Copies the scenes, the textures that they name and the `broken` scenes into the job, and writes the list of the
/// scenes that are drawn.
pub(super) fn copy(
    job: &Path,
    scenes: &[Scene],
    broken: &[(PathBuf, PathBuf)],
) -> Result<(), Complaint> {
    let folder = job.join(SCENES);
    for scene in scenes {
        copy_file(&scene.path, &folder.join(&scene.place))?;
        let from = folder_of(&scene.path);
        let to = folder_of(&scene.place);
        for paint in &scene.loaded.scene.paints {
            if let Some(Texture::Image { file, .. }) = &paint.texture
                && from.join(file).is_file()
            {
                copy_file(&from.join(file), &folder.join(to).join(file))?;
            }
        }
    }
    for (path, place) in broken {
        copy_file(path, &folder.join(place))?;
    }
    let list: String = (scenes.iter())
        .map(|scene| format!("{}\n", scene.place.display()))
        .collect();
    atomic_file::write(&job.join(LIST), |out| out.write_all(list.as_bytes()))
}

fn copy_file(from: &Path, to: &Path) -> Result<(), Complaint> {
    let fail = |e: io::Error| unwritable(to, &e);
    fs::create_dir_all(folder_of(to)).map_err(fail)?;
    refuse_overwrite_of_scenes(&[from.to_owned()], to)?;
    let mut file = fs::File::open(from).map_err(fail)?;
    atomic_file::write(to, |out| {
        io::copy(&mut file, &mut io::BufWriter::new(out)).map(drop)
    })
}
