//! Picture files, and pictures on standard output.

use std::path::{Path, PathBuf};

use crate::commands::draft::Draft;
use crate::commands::paths::is_stdout;
use crate::diagnostics::Complaint;
use crate::trace::film::Packing;
use crate::trace::{CostMap, Film};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Format {
    Png,
    Exr,
    Pfm,
}

/// A picture to be.
pub struct Output {
    path: PathBuf,
    draft: Draft,
    format: Format,
}

impl Output {
    /// Makes sure that the file can be written. `-` is standard output, which takes a PNG.
    pub fn create(path: &Path) -> Result<Output, Complaint> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let format = match extension.to_lowercase().as_str() {
            _ if is_stdout(path) => Format::Png,
            "png" => Format::Png,
            "exr" => Format::Exr,
            "pfm" => Format::Pfm,
            _ => {
                return Err(Complaint::new("unknown-format").with("path", path));
            }
        };
        Ok(Output {
            path: path.to_owned(),
            draft: Draft::create(path)?,
            format,
        })
    }

    /// The same for a map of costs, which is a PNG.
    pub fn create_map(path: &Path) -> Result<Output, Complaint> {
        let output = Output::create(path)?;
        match output.format {
            Format::Png if !is_stdout(path) => Ok(output),
            _ => Err(Complaint::new("map-is-png").with("path", path)),
        }
    }

    /// Writes a map of costs whose scale ends at `max`.
    pub fn finish_map(self, costs: &CostMap, max: u32) -> Result<(), Complaint> {
        self.draft.finish(|out| costs.write_png(out, max))
    }

    /// Writes the picture; the file that it is in now.
    pub fn finish(self, film: &Film) -> Result<Option<PathBuf>, Complaint> {
        self.draft.finish(|out| match self.format {
            Format::Png => film.write_png(out, Packing::Quick),
            Format::Exr => film.write_exr(out),
            Format::Pfm => film.write_pfm(out),
        })?;
        Ok(Some(self.path).filter(|path| !is_stdout(path)))
    }
}
