//! Mitsuba: a document, or one for each eye, and meshes beside it.

use std::path::Path;

use super::mesh::tracer;
use super::{Args, Made, suffixed};
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Error, Value};
use crate::syntax::Captions;
use crate::translate::mitsuba::{self, Integrator, Options, Output};

/// Translates the scene.
pub fn make(args: &Args, loaded: &Analysis) -> Result<Made, Error> {
    let tracer = tracer(loaded)?;
    let stem = args.output.as_deref().and_then(Path::file_stem);
    let options = Options {
        size: (args.size.width, args.size.height),
        depth: args.depth,
        tolerance: args.tolerance,
        memory: args.memory.for_triangles(),
        integrator: Integrator::Path,
        stem: stem.unwrap_or_default().to_string_lossy().into_owned(),
        captions: Captions::of(&loaded.document, &loaded.source.text),
    };
    let made = mitsuba::write(&loaded.scene, &tracer, &options)?;
    if args.output.is_none() && made.documents.len() + made.meshes.len() > 1 {
        let count = |n: usize| Value::Count(n as u64);
        return Err(Error::Request(
            Complaint::new("many-files")
                .with("documents", count(made.documents.len()))
                .with("meshes", count(made.meshes.len())),
        ));
    }
    Ok(files(args.output.as_deref(), made))
}

/// Everything to write, meshes first: a document is there when what it names is there.
fn files(path: Option<&Path>, made: Output) -> Made {
    let beside = |name: String| path.map(|p| p.with_file_name(name));
    let meshes = made.meshes.into_iter();
    let meshes = meshes.map(|(name, bytes)| (beside(name), bytes));
    let documents = made.documents.into_iter();
    let documents =
        documents.map(|(suffix, text)| (path.map(|p| suffixed(p, suffix)), text.into_bytes()));
    Made {
        files: meshes.chain(documents).collect(),
        report: made.report,
    }
}
