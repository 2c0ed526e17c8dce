//! Picture files.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::commands::draft::{Draft, unwritable};
use crate::diagnostics::Complaint;
use crate::trace::film::Packing;
use crate::trace::{CostMap, Film};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Png,
    Exr,
    Pfm,
}

/// A picture file to be: a temporary file beside it until the picture is complete.
pub struct Output {
    path: PathBuf,
    format: Format,
    file: Draft,
}

impl Output {
    /// Makes sure that the file can be written.
    pub fn create(path: &Path) -> Result<Output, Complaint> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let format = match extension.to_lowercase().as_str() {
            "png" => Format::Png,
            "exr" => Format::Exr,
            "pfm" => Format::Pfm,
            _ => {
                return Err(Complaint::new("unknown-format").with("path", path));
            }
        };
        let file = Draft::create(path).map_err(|e| unwritable(path, &e))?;
        Ok(Output {
            path: path.to_owned(),
            format,
            file,
        })
    }

    /// The same for a map of costs, which is a PNG.
    pub fn create_map(path: &Path) -> Result<Output, Complaint> {
        let output = Output::create(path)?;
        match output.format {
            Format::Png => Ok(output),
            _ => Err(Complaint::new("map-is-png").with("path", path)),
        }
    }

    /// Writes a map of costs whose scale ends at `max`.
    pub fn finish_map(self, costs: &CostMap, max: u32) -> Result<(), Complaint> {
        self.file
            .finish(&self.path, |out| costs.write_png(out, max))
            .map_err(|e| unwritable(&self.path, &e))
    }

    pub fn finish(self, film: &Film) -> Result<(), Complaint> {
        let write = |out: &mut dyn Write| match self.format {
            Format::Png => film.write_png(out, Packing::Quick),
            Format::Exr => film.write_exr(out),
            Format::Pfm => film.write_pfm(out),
        };
        self.file
            .finish(&self.path, write)
            .map_err(|e| unwritable(&self.path, &e))
    }
}
