//! Mitsuba: a document, or one for each eye, and meshes beside it.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::mesh::{tracer, write_all};
use super::{Args, refuse, suffixed, write_report};
use crate::commands::draft::unwritable;
use crate::commands::{Loaded, LookChoice, Status, complain};
use crate::translate::mitsuba::{self, Integrator, Options, Output};

/// Translates the scene and writes what comes of it.
pub fn run(args: &Args, loaded: &mut Loaded, look: LookChoice) -> Status {
    let tracer = match tracer(loaded, look) {
        Ok(tracer) => tracer,
        Err(status) => return status,
    };
    let stem = args.output.as_deref().and_then(Path::file_stem);
    let options = Options {
        size: (args.size.width, args.size.height),
        depth: args.depth,
        tolerance: args.tolerance,
        integrator: Integrator::Path,
        stem: stem.unwrap_or_default().to_string_lossy().into_owned(),
    };
    let made = match mitsuba::write(&loaded.scene, &tracer, &options) {
        Ok(made) => made,
        Err(unsupported) => return refuse(loaded, &unsupported),
    };
    let written = match (&args.output, &made.documents[..]) {
        (Some(path), _) => write_all(&files(path, &made)),
        (None, [(_, text)]) if made.meshes.is_empty() => {
            match io::stdout().lock().write_all(text.as_bytes()) {
                // Nobody reads any more: that is their choice.
                Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
                    Err((PathBuf::from("standard output"), e))
                }
                _ => Ok(()),
            }
        }
        (None, documents) => {
            let meshes = made.meshes.len();
            let what = match documents.len() {
                1 => format!("{meshes} meshes beside the document"),
                _ => "one document for each eye".to_owned(),
            };
            complain(&format!(
                "the translation is more than one file, {what}: say with -o where to write it, as in -o scene.xml"
            ));
            return Status::Failure;
        }
    };
    let written = written.and_then(|()| match &args.report {
        Some(path) => write_report(path, &made.report).map_err(|e| (path.clone(), e)),
        None => Ok(()),
    });
    // Nobody is left to be told when standard error is gone.
    let _ = write!(io::stderr(), "{}", made.report);
    match written {
        Ok(()) => Status::Clean,
        Err((path, e)) => {
            complain(&unwritable(&path, &e));
            Status::Failure
        }
    }
}

/// Everything to write, meshes first: a document is there when what it names is there.
fn files(path: &Path, made: &Output) -> Vec<(PathBuf, Vec<u8>)> {
    let meshes = made.meshes.iter();
    let meshes = meshes.map(|(name, bytes)| (path.with_file_name(name), bytes.clone()));
    let documents = made.documents.iter();
    let documents = documents.map(|(suffix, text)| (suffixed(path, suffix), text.clone().into()));
    meshes.chain(documents).collect()
}
