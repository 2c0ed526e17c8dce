//! Refuses outputs that would write over the scene, or over a picture that the scene names.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use crate::analysis::Analysis;
use crate::diagnostics::Complaint;
use crate::scene::Texture;

/// The canonical path of a file that may not exist yet: all spellings of a path give the same result.
fn place(path: &Path) -> PathBuf {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let new = || Some(folder.canonicalize().ok()?.join(path.file_name()?));
    (path.canonicalize().ok().or_else(new)).unwrap_or_else(|| path.to_owned())
}

/// Refuses the outputs `written` if one of them is the scene `file` or a picture that the scene names, or if two of
/// them are one file.
pub(super) fn refuse_overwrite<'p>(
    file: &Path,
    loaded: &Analysis,
    written: impl IntoIterator<Item = &'p Path>,
) -> Result<(), Complaint> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let images: HashSet<PathBuf> = (loaded.scene.paints.iter())
        .filter_map(|paint| match &paint.texture {
            Some(Texture::Image { file, .. }) => folder.join(file).canonicalize().ok(),
            _ => None,
        })
        .collect();
    let scene = file.canonicalize().ok();
    let mut seen = HashSet::new();
    for path in written {
        // A file that does not exist yet needs no protection.
        let there = path.canonicalize().ok();
        let is_new = seen.insert(place(path));
        let what = match &there {
            Some(there) if images.contains(there) => "would-overwrite-image",
            Some(there) if scene.as_ref() == Some(there) => "would-overwrite-scene",
            // Several outputs may go to a device.
            _ if !is_new && there.as_ref().is_none_or(|there| there.is_file()) => {
                "would-write-twice"
            }
            _ => continue,
        };
        return Err(Complaint::new(what).with("path", path));
    }
    Ok(())
}

/// Refuses to write over one of these scenes.
pub(super) fn refuse_overwrite_of_scenes(
    scenes: &[PathBuf],
    written: &Path,
) -> Result<(), Complaint> {
    let Ok(there) = written.canonicalize() else {
        return Ok(());
    };
    let mut scenes = scenes.iter().filter_map(|scene| scene.canonicalize().ok());
    match scenes.any(|scene| scene == there) {
        true => Err(Complaint::new("would-overwrite-scene").with("path", written)),
        false => Ok(()),
    }
}
