//! Files that appear when they are complete. Until then they lie beside their place under a name of their
//! own, locked. A run that is killed leaves its drafts behind without the lock, and the next run that
//! writes into the folder removes them.

use std::collections::HashSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, PoisonError};

use tempfile::NamedTempFile;

use crate::diagnostics::Complaint;

/// How the names of drafts begin and end; in between are a few random characters.
const NAME: (&str, &str) = (".zpg-", ".draft");

/// A file under way.
pub enum Draft {
    Temporary(NamedTempFile),
    /// What exists and is not a plain file, a pipe for instance, is written to as it is.
    Direct(File),
}

impl Draft {
    pub fn create(path: &Path) -> io::Result<Draft> {
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => {
                return File::options().write(true).open(path).map(Draft::Direct);
            }
            _ => {}
        }
        temporary(folder_of(path)).map(Draft::Temporary)
    }

    /// Writes the file and puts it in its place, complete or not at all.
    pub fn finish(
        self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> io::Result<()> {
        match self {
            Draft::Temporary(mut file) => {
                let mut out = BufWriter::new(file.as_file_mut());
                write(&mut out)?;
                out.flush()?;
                drop(out);
                file.persist(path)?;
            }
            Draft::Direct(file) => {
                let mut out = BufWriter::new(file);
                write(&mut out)?;
                out.flush()?;
            }
        }
        Ok(())
    }
}

/// The folder that a file lies in.
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Makes sure, before long work begins, that a file can be written; nothing is left of the attempt.
pub fn try_file(path: &Path) -> Result<(), Complaint> {
    // To open a pipe twice would end its reader.
    let is_special = fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir());
    match is_special {
        true => Ok(()),
        false => (Draft::create(path).map(drop)).map_err(|e| unwritable(path, &e)),
    }
}

/// The same for a file whose folder is made if it is not there yet.
pub fn try_file_in_new_folder(path: &Path) -> Result<(), Complaint> {
    match folder_of(path).exists() {
        true => try_file(path),
        false => try_folder(folder_of(path)),
    }
}

/// Makes sure, before long work begins, that files can be written into a folder, which need not be there yet; nothing is
/// left of the attempt.
pub fn try_folder(folder: &Path) -> Result<(), Complaint> {
    let there = folder.ancestors().find(|f| f.exists());
    let there = there.filter(|f| !f.as_os_str().is_empty());
    (temporary(there.unwrap_or(Path::new("."))).map(drop)).map_err(|e| unwritable(folder, &e))
}

/// A new file in a folder for what is not complete, removed unless it is given a name.
pub fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    clear(folder);
    let mut builder = tempfile::Builder::new();
    builder.prefix(NAME.0).suffix(NAME.1);
    // Like any new file: readable for whom the user's mask allows.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        match file.as_file().try_lock() {
            // Another run may have found it without a lock just now, and removed it.
            Ok(()) if !file.path().exists() => {}
            Err(fs::TryLockError::WouldBlock) => {}
            // Where nothing can be locked, nothing is removed either.
            Ok(()) | Err(fs::TryLockError::Error(_)) => return Ok(file),
        }
    }
}

/// Removes what runs that were killed have left in a folder. It is looked at once.
fn clear(folder: &Path) {
    static CLEARED: LazyLock<Mutex<HashSet<PathBuf>>> = LazyLock::new(Mutex::default);
    let mut cleared = CLEARED.lock().unwrap_or_else(PoisonError::into_inner);
    if !cleared.insert(folder.to_owned()) {
        return;
    }
    // What cannot be removed is no reason not to write.
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let is_draft = name.starts_with(NAME.0) && name.ends_with(NAME.1);
        if !is_draft || !entry.file_type().is_ok_and(|t| t.is_file()) {
            continue;
        }
        if let Ok(file) = File::options().write(true).open(entry.path())
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// A file cannot be written.
pub fn unwritable(path: &Path, error: &io::Error) -> Complaint {
    Complaint::new("cannot-write")
        .with("path", path)
        .with("reason", Complaint::from(error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_killed_run_leaves_is_removed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for name in [".zpg-abc.draft", ".zpg-abc.other", "zpg-abc.draft"] {
            fs::write(at(name), "half of a picture").unwrap();
        }
        // Another run is still at this one.
        let theirs = File::create(at(".zpg-def.draft")).unwrap();
        theirs.lock().unwrap();
        let path = at("picture.png");
        let draft = Draft::create(&path).unwrap();
        let there = |name| at(name).exists();
        assert!(!there(".zpg-abc.draft"));
        assert!(there(".zpg-abc.other") && there("zpg-abc.draft") && there(".zpg-def.draft"));
        draft.finish(&path, |out| out.write_all(b"all")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"all");
        let left = fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(left, 4);
    }
}
