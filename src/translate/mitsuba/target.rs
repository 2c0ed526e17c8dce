//! Mitsuba: a document, or one for each eye, and meshes beside it.

use std::path::Path;

use super::{Integrator, Options, write};
use crate::diagnostics::{Complaint, Error, Value};
use crate::translate::target::{self, Output, Prepared, Target};

/// Mitsuba 3.
#[derive(Debug)]
pub struct Mitsuba;

impl Target for Mitsuba {
    fn name(&self) -> &'static str {
        "mitsuba"
    }

    fn ending(&self) -> &'static str {
        "xml"
    }

    fn help(&self) -> &'static str {
        "Mitsuba 3: XML, with meshes beside it"
    }

    fn adds_what_is_lacking(&self) -> bool {
        true
    }

    fn draws(&self) -> bool {
        true
    }

    fn write(&self, scene: &Prepared, options: &target::Options) -> Result<Output, Error> {
        let tracer = scene.tracer()?;
        let stem = options.output.and_then(Path::file_stem);
        let own = Options {
            size: options.size,
            viewpoint: options.viewpoint,
            depth: options.depth,
            tolerance: options.tolerance,
            memory: options.memory,
            integrator: Integrator::Path,
            stem: stem.unwrap_or_default().to_string_lossy().into_owned(),
            captions: scene.captions.clone(),
        };
        let made = write(scene.scene(), scene.bounds(), tracer, &own)?;
        if options.output.is_none() && made.documents.len() + made.meshes.len() > 1 {
            let count = |n: usize| Value::Count(n as u64);
            return Err(Error::Request(
                Complaint::new("many-files")
                    .with("documents", count(made.documents.len()))
                    .with("meshes", count(made.meshes.len())),
            ));
        }
        // Meshes are written first, so that no document names a file that is not there.
        let beside = |name: String| options.output.map(|p| p.with_file_name(name));
        let meshes = made.meshes.into_iter();
        let meshes = meshes.map(|(name, bytes)| (beside(name), bytes));
        let documents = made.documents.into_iter();
        let documents =
            documents.map(|(suffix, text)| (options.suffixed(suffix), text.into_bytes()));
        Ok(Output {
            files: meshes.chain(documents).collect(),
            report: made.report,
        })
    }
}
