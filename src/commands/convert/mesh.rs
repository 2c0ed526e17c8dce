//! Meshes: files of their own, named after the scene.

use std::ffi::OsString;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::{Args, refuse, write_report};
use crate::commands::draft::{Draft, unwritable};
use crate::commands::loaded::STDIN;
use crate::commands::{Loaded, LookChoice, Status, complain, report};
use crate::trace::{self, Images, Tracer};
use crate::translate::Unsupported;
use crate::translate::mesh::{self, Coloured, glb, obj, ply};

/// The kinds of files there are for meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Ply,
    Obj,
    Glb,
}

impl Format {
    fn name(self) -> &'static str {
        match self {
            Format::Ply => "ply",
            Format::Obj => "obj",
            Format::Glb => "glb",
        }
    }
}

/// Makes the scene of triangles and writes them.
pub fn run(args: &Args, format: Format, loaded: &mut Loaded, look: LookChoice) -> Status {
    let Some(path) = destination(&args.file, args.output.as_deref(), format.name()) else {
        complain(&format!(
            "a scene from standard input has no name: say with -o where to write the {} file",
            format.name()
        ));
        return Status::Failure;
    };
    let tracer = match tracer(loaded, look) {
        Ok(tracer) => tracer,
        Err(status) => return status,
    };
    let options = mesh::Options {
        tolerance: args.tolerance,
        eye: None,
    };
    let model = match mesh::model(&loaded.scene, &tracer.graph, &options) {
        Ok(model) => model,
        Err(unsupported) => return refuse(loaded, &unsupported),
    };
    let coloured = Coloured::new(&model, &tracer.graph);
    let files = match format {
        Format::Ply => vec![(path, ply::write(&coloured))],
        Format::Glb => vec![(path, glb::write(&coloured))],
        Format::Obj => {
            let library = path.with_extension("mtl");
            let name = library.file_name().unwrap_or_default().to_string_lossy();
            let (text, materials) = obj::write(&coloured, &name);
            vec![(path, text.into_bytes()), (library, materials.into_bytes())]
        }
    };
    let account = mesh::report(format.name(), &loaded.scene, &model);
    let written = write_all(&files).and_then(|()| match &args.report {
        Some(path) => write_report(path, &account).map_err(|e| (path.clone(), e)),
        None => Ok(()),
    });
    // Nobody is left to be told when standard error is gone.
    let _ = write!(io::stderr(), "{account}");
    match written {
        Ok(()) => Status::Clean,
        Err((path, e)) => {
            complain(&unwritable(&path, &e));
            Status::Failure
        }
    }
}

/// Where to write: where it was said, else beside nobody, in the current folder; `None` for a scene
/// without a name.
pub fn destination(scene: &Path, said: Option<&Path>, extension: &str) -> Option<PathBuf> {
    if let Some(said) = said {
        return Some(said.to_owned());
    }
    if scene == Path::new(STDIN) {
        return None;
    }
    let mut name: OsString = scene.file_stem()?.to_owned();
    name.push(".");
    name.push(extension);
    Some(name.into())
}

/// The scene compiled, with its pictures.
pub fn tracer(loaded: &mut Loaded, look: LookChoice) -> Result<Tracer, Status> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let images = match Images::load(&loaded.scene, folder) {
        Ok(images) => images,
        Err(found) => {
            loaded.diagnostics = vec![*found];
            report(loaded, look);
            return Err(Status::Negative);
        }
    };
    Tracer::with_images(&loaded.scene, &images).map_err(|e: trace::Unsupported| {
        refuse(
            loaded,
            &Unsupported {
                id: e.id,
                span: Some(e.span),
                message: format!("{} cannot be made of triangles", e.what),
            },
        )
    })
}

pub fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<(), (PathBuf, io::Error)> {
    for (path, bytes) in files {
        Draft::create(path)
            .and_then(|d| d.finish(path, |out| out.write_all(bytes)))
            .map_err(|e| (path.clone(), e))?;
    }
    Ok(())
}
