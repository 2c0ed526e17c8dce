//! Picture files, and pictures on standard output.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::commands::draft::Draft;
use crate::commands::paths::is_stdout;
use crate::commands::terminal::unprintable;
use crate::diagnostics::Complaint;
use crate::trace::film::Packing;
use crate::trace::{CostMap, Film};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Png,
    Exr,
    Pfm,
}

/// Where a picture goes, once it is complete.
enum Place {
    Stdout,
    /// A temporary file beside this one until then.
    File(PathBuf, Draft),
}

/// A picture to be.
pub struct Output {
    place: Place,
    format: Format,
}

impl Output {
    /// Makes sure that the file can be written. `-` is standard output, which takes a PNG.
    pub fn create(path: &Path) -> Result<Output, Complaint> {
        if is_stdout(path) {
            return Ok(Output {
                place: Place::Stdout,
                format: Format::Png,
            });
        }
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let format = match extension.to_lowercase().as_str() {
            "png" => Format::Png,
            "exr" => Format::Exr,
            "pfm" => Format::Pfm,
            _ => {
                return Err(Complaint::new("unknown-format").with("path", path));
            }
        };
        let file = Draft::create(path)?;
        Ok(Output {
            place: Place::File(path.to_owned(), file),
            format,
        })
    }

    /// The same for a map of costs, which is a PNG.
    pub fn create_map(path: &Path) -> Result<Output, Complaint> {
        let output = Output::create(path)?;
        match (&output.place, output.format) {
            (Place::File(..), Format::Png) => Ok(output),
            _ => Err(Complaint::new("map-is-png").with("path", path)),
        }
    }

    /// Writes a map of costs whose scale ends at `max`.
    pub fn finish_map(self, costs: &CostMap, max: u32) -> Result<(), Complaint> {
        self.place.put(|out| costs.write_png(out, max)).map(drop)
    }

    /// Writes the picture; the file that it is in now.
    pub fn finish(self, film: &Film) -> Result<Option<PathBuf>, Complaint> {
        self.place.put(|out| match self.format {
            Format::Png => film.write_png(out, Packing::Quick),
            Format::Exr => film.write_exr(out),
            Format::Pfm => film.write_pfm(out),
        })
    }
}

impl Place {
    fn put(
        self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<Option<PathBuf>, Complaint> {
        let (path, file) = match self {
            Place::File(path, file) => (path, file),
            Place::Stdout => {
                let mut bytes = Vec::new();
                let written = write(&mut bytes).and_then(|()| io::stdout().write_all(&bytes));
                return match written.and_then(|()| io::stdout().flush()) {
                    // Nobody reads any more: that is their choice.
                    Err(e) if e.kind() != io::ErrorKind::BrokenPipe => Err(unprintable(&e)),
                    _ => Ok(None),
                };
            }
        };
        file.finish(write)?;
        Ok(Some(path))
    }
}
