//! Files that appear when they are complete. Until then each is a draft: a locked file beside its place, under another
//! name. A run that is killed leaves its drafts behind without the lock, and the next run that writes into the folder
//! removes them.
//!
//! `-` is standard output, which is written when all bytes are there. Symbolic links are followed, and the file that
//! they lead to is written. A file that is replaced keeps its owner, permissions and attributes. If a draft cannot have
//! these, the old file is written over in place.

use std::collections::HashSet;
use std::ffi::OsString;
use std::fs::{self, File, Metadata};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, PoisonError};

use tempfile::NamedTempFile;

use super::belongings;
use super::paths::is_stdout;
use super::terminal::unprintable;
use crate::diagnostics::Complaint;

/// How the names of drafts begin and end; in between are a few random characters.
const NAME: (&str, &str) = (".zpg-", ".draft");

/// The most symbolic links that are followed, as on Linux.
const MAX_LINKS: usize = 40;

/// A file that is being written.
pub struct AtomicFile {
    /// The path as it was given.
    path: PathBuf,
    way: WriteMethod,
}

/// How a file is written.
enum WriteMethod {
    /// The draft `file` takes the place of whatever is at `place`.
    Exchange { file: NamedTempFile, place: PathBuf },
    /// The bytes of `file`, which lies in the temporary folder, are copied over the file at `place`.
    Over { file: NamedTempFile, place: PathBuf },
    /// The bytes go straight to the file: it is not a regular one (a pipe, a device), or a process has it open.
    Direct(File),
    /// Standard output, for the path `-`.
    Stdout,
}

impl AtomicFile {
    pub fn create(path: &Path) -> Result<AtomicFile, Complaint> {
        let way = WriteMethod::to(path).map_err(|e| unwritable(path, &e))?;
        let path = path.to_owned();
        Ok(AtomicFile { path, way })
    }

    /// Writes the file and puts it in its place, complete or not at all.
    pub fn finish(
        self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Complaint> {
        let error = |e: io::Error| unwritable(&self.path, &e);
        match self.way {
            WriteMethod::Exchange { mut file, place } => {
                fill(file.as_file_mut(), write).map_err(error)?;
                match file.persist(&place) {
                    Ok(_) => Ok(()),
                    Err(e) if forbids_exchange(&e.error) && place.is_file() => {
                        copy_over(e.file.into_file(), &place, &self.path)
                    }
                    Err(e) => Err(error(e.error)),
                }
            }
            WriteMethod::Over { mut file, place } => {
                fill(file.as_file_mut(), write).map_err(error)?;
                copy_over(file.into_file(), &place, &self.path)
            }
            WriteMethod::Direct(mut file) => fill(&mut file, write).map_err(error),
            WriteMethod::Stdout => {
                let mut bytes = Vec::new();
                let written = write(&mut bytes)
                    .and_then(|()| fill(&mut io::stdout().lock(), |out| out.write_all(&bytes)));
                match written {
                    // A reader that closes the pipe early is no failure.
                    Err(e) if e.kind() != io::ErrorKind::BrokenPipe => Err(unprintable(&e)),
                    _ => Ok(()),
                }
            }
        }
    }
}

impl WriteMethod {
    fn to(path: &Path) -> io::Result<WriteMethod> {
        if is_stdout(path) {
            return Ok(WriteMethod::Stdout);
        }
        let found = match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => {
                return File::options()
                    .write(true)
                    .open(path)
                    .map(WriteMethod::Direct);
            }
            Ok(found) => Some(found),
            Err(_) => None,
        };
        let Some(place) = place(path)? else {
            // A file that a process has open may have content from others, and the new bytes go behind it.
            return File::options()
                .append(true)
                .open(path)
                .map(WriteMethod::Direct);
        };
        let Some(found) = found else {
            let file = temporary(folder_of(&place))?;
            return Ok(WriteMethod::Exchange { file, place });
        };
        if let Some(file) = successor(&place, &found)? {
            return Ok(WriteMethod::Exchange { file, place });
        }
        File::options().write(true).open(&place)?;
        let file = tempfile::Builder::new().prefix("zpg-").tempfile()?;
        Ok(WriteMethod::Over { file, place })
    }
}

/// Writes a file with `write`; it appears when it is complete.
pub fn write(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Complaint> {
    AtomicFile::create(path)?.finish(write)
}

fn fill(
    file: &mut impl Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::new(file);
    write(&mut out)?;
    out.flush()
}

/// The file that a path leads to through symbolic links; it need not exist yet. `None` for a file that a process has
/// open, such as /dev/stdout: it must be written through this path, whatever name it has elsewhere.
fn place(path: &Path) -> io::Result<Option<PathBuf>> {
    let mut place = path.to_owned();
    for _ in 0..MAX_LINKS {
        let folder = folder_of(&place).canonicalize();
        if folder.is_ok_and(|f| f.starts_with("/proc") || f == Path::new("/dev/fd")) {
            return Ok(None);
        }
        match fs::read_link(&place) {
            Ok(target) => place = folder_of(&place).join(target),
            // The path cannot be read as a link, so it is the file itself.
            Err(_) => return Ok(Some(place)),
        }
    }
    // The links are too many or lead to themselves, which the system's own error says best.
    fs::metadata(path).map(|_| Some(place))
}

/// A draft with the owner, permissions and attributes of the file at `place`, which it is to replace. `None` if it
/// cannot replace the file: there are hard links, or the owner, the attributes or the folder forbid it.
fn successor(place: &Path, found: &Metadata) -> io::Result<Option<NamedTempFile>> {
    if belongings::has_other_names(found) {
        return Ok(None);
    }
    match temporary(folder_of(place)) {
        Ok(draft) => {
            let is_alike = belongings::copy(place, found, draft.as_file()).is_ok();
            Ok(is_alike.then_some(draft))
        }
        Err(e) if forbids_exchange(&e) => Ok(None),
        Err(e) => Err(e),
    }
}

/// Whether a file cannot be exchanged, though it may be written.
fn forbids_exchange(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::PermissionDenied
        | io::ErrorKind::ReadOnlyFilesystem
        // Another file system begins at the file, as at some files of a container.
        | io::ErrorKind::ResourceBusy
        | io::ErrorKind::CrossesDevices
    )
}

/// Writes the bytes of `new` over the file at `place`. A copy of the old content is kept in the temporary folder until
/// that is done; if it fails, the complaint names the copy.
fn copy_over(mut new: File, place: &Path, path: &Path) -> Result<(), Complaint> {
    let folder = std::env::temp_dir();
    let kept = match File::open(place) {
        Ok(old) => Some(keep(old, place).map_err(|e| unwritable(&folder, &e))?),
        // A file that may not be read is written over without a copy.
        Err(_) => None,
    };
    let copied = new.rewind().and_then(|()| {
        let mut file = File::options().write(true).truncate(true).open(place)?;
        io::copy(&mut new, &mut file)?;
        file.sync_all()
    });
    match (copied, kept) {
        (Ok(()), kept) => {
            // A copy that is left does no harm.
            let _ = kept.map(fs::remove_file);
            Ok(())
        }
        (Err(e), Some(kept)) => Err(Complaint::new("cannot-write-in-place")
            .with("path", path)
            .with("reason", Complaint::from(&e))
            .with("copy", kept.as_path())),
        (Err(e), None) => Err(unwritable(path, &e)),
    }
}

/// Copies `old` into the temporary folder, under a name with the ending of `place`. Returns the path of the copy.
fn keep(mut old: File, place: &Path) -> io::Result<PathBuf> {
    let mut ending = OsString::from(".");
    ending.push(place.extension().unwrap_or_default());
    let mut copy = tempfile::Builder::new()
        .prefix("zpg-")
        .suffix(&ending)
        .tempfile()?;
    io::copy(&mut old, &mut copy)?;
    copy.as_file().sync_all()?;
    Ok(copy.keep()?.1)
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
        false => AtomicFile::create(path).map(drop),
    }
}

/// Like [`try_file`], for a file whose folder is made if it does not exist yet.
pub fn try_file_in_new_folder(path: &Path) -> Result<(), Complaint> {
    match folder_of(path).exists() {
        true => try_file(path),
        false => try_folder(folder_of(path)),
    }
}

/// Makes sure, before long work begins, that files can be written into a folder, which need not exist yet; nothing is
/// left of the attempt.
pub fn try_folder(folder: &Path) -> Result<(), Complaint> {
    let there = folder.ancestors().find(|f| f.exists());
    let there = there.filter(|f| !f.as_os_str().is_empty());
    (temporary(there.unwrap_or(Path::new("."))).map(drop)).map_err(|e| unwritable(folder, &e))
}

/// A new, locked draft in a folder. It is removed when it is dropped, unless it is moved to its place.
pub fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    clear(folder);
    let mut builder = tempfile::Builder::new();
    builder.prefix(NAME.0).suffix(NAME.1);
    // The draft gets the mode of any new file, which the user's mask restricts.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        match file.as_file().try_lock() {
            // Another run may have found it without a lock just now, and removed it.
            Ok(()) if !file.path().exists() => {}
            Err(fs::TryLockError::WouldBlock) => {}
            // On a file system without locks, no run removes drafts either.
            Ok(()) | Err(fs::TryLockError::Error(_)) => return Ok(file),
        }
    }
}

/// Removes the drafts that killed runs have left in a folder. A process does this once for each folder.
fn clear(folder: &Path) {
    static CLEARED: LazyLock<Mutex<HashSet<PathBuf>>> = LazyLock::new(Mutex::default);
    let mut cleared = CLEARED.lock().unwrap_or_else(PoisonError::into_inner);
    if !cleared.insert(folder.to_owned()) {
        return;
    }
    // A draft that cannot be removed is no reason not to write.
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

/// The complaint that a file cannot be written. It names the folder if that is missing.
pub fn unwritable(path: &Path, error: &io::Error) -> Complaint {
    let folder = path
        .parent()
        .filter(|f| !f.as_os_str().is_empty() && !f.exists());
    let reason = match folder {
        Some(folder) => Complaint::new("no-folder").with("path", folder),
        None => Complaint::from(error),
    };
    Complaint::new("cannot-write")
        .with("path", path)
        .with("reason", reason)
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
        let draft = AtomicFile::create(&path).unwrap();
        let there = |name| at(name).exists();
        assert!(!there(".zpg-abc.draft"));
        assert!(there(".zpg-abc.other") && there("zpg-abc.draft") && there(".zpg-def.draft"));
        draft.finish(|out| out.write_all(b"all")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"all");
        let left = fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(left, 4);
    }

    /// A file that cannot be written to its end is named together with the copy of what it was.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_copy_is_kept_until_all_is_written() {
        let mut new = tempfile::tempfile().unwrap();
        new.write_all(b"new").unwrap();
        // Nobody may write to it, and root fails when he does.
        let place = Path::new("/proc/version");
        let complaint = copy_over(new, place, Path::new("a.png")).unwrap_err();
        let said = complaint.to_string();
        let (said, copy) = said.split_once("; its old content is kept in ").unwrap();
        assert!(said.starts_with("cannot write a.png: "), "{said}");
        assert_eq!(fs::read(copy).unwrap(), fs::read(place).unwrap());
        fs::remove_file(copy).unwrap();
    }
}
