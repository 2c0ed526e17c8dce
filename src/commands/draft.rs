//! Files that appear when they are complete.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::diagnostics::Complaint;

/// A file under way.
pub enum Draft {
    Temporary(tempfile::NamedTempFile),
    /// What exists and is not a plain file, a pipe for instance, is written to as it is.
    Direct(fs::File),
}

impl Draft {
    pub fn create(path: &Path) -> io::Result<Draft> {
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => {
                return fs::File::options()
                    .write(true)
                    .open(path)
                    .map(Draft::Direct);
            }
            _ => {}
        }
        let folder = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let mut builder = tempfile::Builder::new();
        // Like any new file: readable for whom the user's mask allows.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        builder.tempfile_in(folder).map(Draft::Temporary)
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

/// A file cannot be written.
pub fn unwritable(path: &Path, error: &io::Error) -> Complaint {
    Complaint::new("cannot-write")
        .with("path", path)
        .with("reason", Complaint::from(error))
}
