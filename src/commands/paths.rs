//! PATH arguments: a file stands for itself, a folder for the scenes in it.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ignore::WalkBuilder;

use super::terminal::{LookChoice, complain, warn};
use crate::analysis::config::Configs;
use crate::analysis::file::{STDIN, unreadable};
use crate::diagnostics::Complaint;

/// The extension of scene files.
const EXTENSION: &str = "zpg";

/// The files that PATH arguments stand for, each once.
#[derive(Debug, Default)]
pub struct Files {
    /// The files in the order of the arguments; the files of a folder are sorted.
    pub files: Vec<PathBuf>,
    /// Whether a folder, or a part of one, could not be read; the complaint has been printed.
    pub failed: bool,
}

/// Expands each folder to its `*.zpg` files, recursively. Files that `.gitignore` and its kin or the settings exclude
/// are left out. A path that is no folder is taken whatever its name, even if it does not exist: reading it will tell.
pub fn expand(paths: &[PathBuf], configs: &Arc<Configs>, look: LookChoice) -> Files {
    let mut found = Files::default();
    let mut seen = HashSet::new();
    for path in paths {
        if path.is_dir() {
            let mut scenes = scenes_in(path, configs, &mut found.failed, look);
            if scenes.is_empty() {
                warn(
                    look,
                    &Complaint::new("no-scenes").with("path", path.as_path()),
                );
            }
            scenes.sort();
            found.files.extend(scenes);
        } else {
            found.files.push(path.clone());
        }
    }
    found.files.retain(|file| seen.insert(identity(file)));
    found
}

/// The path of a file below the folder among `paths` that it was found in. For a file that is named itself, its bare
/// name.
pub fn place_below(paths: &[PathBuf], file: &Path) -> PathBuf {
    let mut folders = paths.iter().filter(|path| path.is_dir());
    let below = folders.find_map(|folder| file.strip_prefix(folder).ok());
    below.map_or_else(
        || PathBuf::from(file.file_name().unwrap_or_default()),
        Path::to_owned,
    )
}

/// The canonical path of a file, which is the same for all spellings of its path. Standard input and missing files stay
/// as they are written.
fn identity(file: &Path) -> PathBuf {
    if file.as_os_str() == STDIN {
        return file.to_owned();
    }
    file.canonicalize().unwrap_or_else(|_| file.to_owned())
}

/// Whether a path stands for standard input.
pub fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == STDIN
}

/// Whether a path stands for standard output: `-`, as for standard input.
pub fn is_stdout(path: &Path) -> bool {
    is_stdin(path)
}

/// Whether settings exclude a file. Settings that cannot be read exclude nothing; reading the file complains about
/// them.
pub fn is_excluded(configs: &Configs, file: &Path) -> bool {
    (configs.for_file(file)).is_ok_and(|config| config.excludes_file(file))
}

fn scenes_in(
    folder: &Path,
    configs: &Arc<Configs>,
    failed: &mut bool,
    look: LookChoice,
) -> Vec<PathBuf> {
    let mut scenes = Vec::new();
    let mut walk = WalkBuilder::new(folder);
    let configs = configs.clone();
    walk.require_git(false).filter_entry(move |entry| {
        // A folder that an argument names is searched even if the settings exclude it.
        let is_excluded = || {
            let config = configs.for_file(entry.path());
            config.is_ok_and(|config| config.excludes(entry.path()))
        };
        entry.depth() == 0 || !is_excluded()
    });
    for entry in walk.build() {
        match entry {
            Ok(entry) => {
                let is_file = entry.path().is_file();
                let is_scene = entry
                    .path()
                    .extension()
                    .is_some_and(|e| e.eq_ignore_ascii_case(EXTENSION));
                if is_file && is_scene {
                    scenes.push(entry.into_path());
                }
            }
            Err(e) => {
                complain(look, &unreadable_entry(&e, folder));
                *failed = true;
            }
        }
    }
    scenes
}

/// The complaint that a file or a folder within `folder` could not be read.
pub fn unreadable_entry(error: &ignore::Error, folder: &Path) -> Complaint {
    let why = error.io_error();
    let why = why.map_or_else(|| Complaint::quoted(error), Complaint::from);
    unreadable(place(error).unwrap_or(folder), why)
}

/// The file or folder that an error is about; `None` if the error does not name it.
fn place(error: &ignore::Error) -> Option<&Path> {
    match error {
        ignore::Error::WithPath { path, .. } => Some(path),
        ignore::Error::WithDepth { err, .. } | ignore::Error::WithLineNumber { err, .. } => {
            place(err)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn folders_are_sorted_and_ignores_are_honoured() {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        fs::write(at(".gitignore"), "skip.zpg\n").unwrap();
        for name in ["b.zpg", "a.zpg", "skip.zpg", "sub/c.zpg", "d.txt"] {
            fs::write(at(name), "").unwrap();
        }
        let paths = [at("sub/c.zpg"), dir.path().to_owned(), at("d.txt")];
        let found = expand(&paths, &Arc::default(), LookChoice::default());
        let expected = ["sub/c.zpg", "a.zpg", "b.zpg", "d.txt"].map(at);
        assert_eq!(found.files, expected);
        assert!(!found.failed);
        // One file by other names, and two that are not there.
        let other = at("sub/../a.zpg");
        let paths = [other, at("a.zpg"), at("none.zpg"), at("./none.zpg")];
        let found = expand(&paths, &Arc::default(), LookChoice::default());
        assert_eq!(found.files.len(), 2, "{:?}", found.files);
    }
}
