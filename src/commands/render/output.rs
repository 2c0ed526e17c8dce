//! Files that appear when they are complete.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::commands::terminal::reason;
use crate::trace::Film;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Png,
    Pfm,
}

/// A picture file to be: a temporary file beside it until the picture is complete.
pub struct Output {
    path: PathBuf,
    format: Format,
    file: Draft,
}

/// A file under way.
pub enum Draft {
    Temporary(tempfile::NamedTempFile),
    /// What exists and is not a plain file, a pipe for instance, is written to as it is.
    Direct(fs::File),
}

impl Output {
    /// Makes sure that the file can be written; the error is a message for people.
    pub fn create(path: &Path) -> Result<Output, String> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let format = match extension.to_lowercase().as_str() {
            "png" => Format::Png,
            "pfm" => Format::Pfm,
            _ => {
                return Err(format!(
                    "cannot tell the format of {}: expected a name that ends in .png or .pfm",
                    path.display()
                ));
            }
        };
        let file = Draft::create(path).map_err(|e| unwritable(path, &e))?;
        Ok(Output {
            path: path.to_owned(),
            format,
            file,
        })
    }

    pub fn finish(self, film: &Film) -> Result<(), String> {
        let write = |out: &mut dyn Write| match self.format {
            Format::Png => film.write_png(out),
            Format::Pfm => film.write_pfm(out),
        };
        self.file
            .finish(&self.path, write)
            .map_err(|e| unwritable(&self.path, &e))
    }
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

/// Why a file could not be written, for people.
pub fn unwritable(path: &Path, error: &io::Error) -> String {
    format!("cannot write {}: {}", path.display(), reason(error))
}
