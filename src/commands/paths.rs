//! PATH arguments: a file stands for itself, a folder for the scenes in it.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use ignore::WalkBuilder;

use super::terminal::{LookChoice, complain, warn};
use crate::analysis::file::{STDIN, unreadable};
use crate::diagnostics::Complaint;

/// The extension of scene files.
const EXTENSION: &str = "zpg";

/// The files that PATH arguments stand for, each once.
#[derive(Debug, Default)]
pub struct Files {
    /// In the order of the arguments, those of a folder sorted.
    pub files: Vec<PathBuf>,
    /// A folder, or a part of one, could not be read; this has been said.
    pub failed: bool,
}

/// Expands folders to their `*.zpg`, recursively, without what `.gitignore` and its kin exclude.
/// A file is taken whatever it is called, even one that does not exist: reading it will tell.
pub fn expand(paths: &[PathBuf], look: LookChoice) -> Files {
    let mut found = Files::default();
    let mut seen = HashSet::new();
    for path in paths {
        if path.is_dir() {
            let mut scenes = scenes_in(path, &mut found.failed, look);
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

/// The same for a file however it is called.
fn identity(file: &Path) -> PathBuf {
    if file.as_os_str() == STDIN {
        return file.to_owned();
    }
    file.canonicalize().unwrap_or_else(|_| file.to_owned())
}

fn scenes_in(folder: &Path, failed: &mut bool, look: LookChoice) -> Vec<PathBuf> {
    let mut scenes = Vec::new();
    for entry in WalkBuilder::new(folder).require_git(false).build() {
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
                complain(look, &unreadable(folder, Complaint::quoted(e)));
                *failed = true;
            }
        }
    }
    scenes
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
        let found = expand(&paths, LookChoice::default());
        let expected = ["sub/c.zpg", "a.zpg", "b.zpg", "d.txt"].map(at);
        assert_eq!(found.files, expected);
        assert!(!found.failed);
        // One file by other names, and two that are not there.
        let other = at("sub/../a.zpg");
        let paths = [other, at("a.zpg"), at("none.zpg"), at("./none.zpg")];
        let found = expand(&paths, LookChoice::default());
        assert_eq!(found.files.len(), 2, "{:?}", found.files);
    }
}
