//! Fixes for the paths of pictures. A picture that does not exist (E210): the picture with the most similar name beside
//! the scene. A path with `\` (E209): the same path with `/`.

use std::path::{Path, PathBuf};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, SourceFile};
use crate::scene::image_file;
use crate::syntax::quote;

/// The most pictures of a scene for which folders are looked through.
const PICTURES: usize = 16;
/// The most entries of a folder that are looked at.
const ENTRIES: usize = 1000;

/// Gives the findings about pictures that do not exist, and about paths with `\`, their fixes.
pub(super) fn propose(source: &SourceFile, findings: &mut [Diagnostic]) {
    let is_windows = |d: &&mut Diagnostic| d.code == Code::E209 && d.case == image_file::BACKSLASH;
    for d in findings.iter_mut().filter(is_windows) {
        let text = image_file::with_slashes(source.slice(d.span));
        let fix = Fix::replace("fix-write", Applicability::Unsafe, d.span, text.clone());
        d.fixes
            .push(fix.with("number", quote(text.trim_matches('"'))));
    }
    let is_one = |d: &&mut Diagnostic| d.code == Code::E210 && d.case.is_empty();
    let Some(folder) = source.folder() else {
        return;
    };
    for d in findings.iter_mut().filter(is_one).take(PICTURES) {
        let written = source.slice(d.span).trim_matches('"');
        let Some(near) = beside(folder, Path::new(written)) else {
            continue;
        };
        // A name with spaces stands in quotes.
        let text = match near.contains(|c: char| c.is_whitespace() || c == '#') {
            true => format!("\"{near}\""),
            false => near.clone(),
        };
        let fix = Fix::replace("fix-write", Applicability::Unsafe, d.span, text);
        d.fixes.push(fix.with("number", quote(&near)));
    }
}

/// The path of the picture whose name is most similar to that of a file that does not exist, in the same folder. `None`
/// if no name is similar enough. Both paths are relative to the folder of the scene.
fn beside(folder: &Path, file: &Path) -> Option<String> {
    if folder.join(file).exists() {
        return None;
    }
    let written = file.file_name()?.to_str()?.to_lowercase();
    let parent = file.parent().unwrap_or(Path::new(""));
    let parts = |name: &str| match name.rsplit_once('.') {
        Some((stem, ending)) => (stem.to_owned(), ending.to_owned()),
        None => (name.to_owned(), String::new()),
    };
    let (stem, ending) = parts(&written);
    let most = 1 + stem.chars().count() / 5;
    // Another ending of the name counts as one mistake.
    let distance = |name: &str| {
        let (other, with) = parts(name);
        strsim::osa_distance(&stem, &other) + usize::from(with != ending)
    };
    let entries = std::fs::read_dir(folder.join(parent)).ok()?;
    let names = entries.take(ENTRIES).flatten();
    let names = names.filter_map(|entry| entry.file_name().into_string().ok());
    let near = names
        .map(|name| (distance(&name.to_lowercase()), name))
        .filter(|(distance, name)| *distance <= most && !name.contains('"'));
    let is_picture = |path: PathBuf| image_file::is_picture(&path).unwrap_or(false);
    let pictures = near.filter(|(_, name)| is_picture(folder.join(parent).join(name)));
    let (_, name) = pictures.min()?;
    // The separator in a scene is `/` on every system.
    Some(match file.to_str()?.rsplit_once('/') {
        Some((folders, _)) => format!("{folders}/{name}"),
        None => name,
    })
}
