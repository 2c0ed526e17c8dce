//! Meshes: files of their own, named after the scene.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::{Args, Made};
use crate::analysis::Analysis;
use crate::analysis::file::STDIN;
use crate::diagnostics::{Complaint, Error};
use crate::syntax::Captions;
use crate::trace::{Images, Tracer};
use crate::translate::mesh::picture::file_name;
use crate::translate::mesh::{self, Coloured, glb, obj, ply};
use crate::translate::names::Names;

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

/// Makes the scene of triangles.
pub fn make(args: &Args, format: Format, loaded: &Analysis) -> Result<Made, Error> {
    let Some(path) = destination(&args.file, args.output.as_deref(), format.name()) else {
        let complaint = Complaint::new("mesh-without-name").with("format", format.name());
        return Err(Error::Request(complaint));
    };
    let tracer = tracer(loaded)?;
    let options = mesh::Options {
        tolerance: args.tolerance,
        memory: args.memory.for_triangles(),
        eye: None,
        pictured: format != Format::Ply,
    };
    let model = mesh::model(&loaded.scene, &tracer.graph, &options)?;
    let coloured = Coloured::new(&model, &tracer.graph, options.pictured);
    let captions = Captions::of(&loaded.document, &loaded.source.text);
    let names = Names::new(&loaded.scene, &captions);
    let files = match format {
        Format::Ply => vec![(Some(path), ply::write(&coloured))],
        Format::Glb => vec![(Some(path), glb::write(&coloured, &names))],
        Format::Obj => {
            let name = |p: &Path| {
                p.file_name()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned()
            };
            let library = path.with_extension("mtl");
            let stem = path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let picture = |number: u32| path.with_file_name(file_name(&stem, number));
            let (text, materials) = obj::write(&coloured, &names, &name(&library), |number| {
                name(&picture(number))
            });
            let mut files = vec![
                (Some(path.clone()), text.into_bytes()),
                (Some(library), materials.into_bytes()),
            ];
            for (number, picture_of) in &coloured.pictures.all {
                files.push((Some(picture(*number)), picture_of.png.clone()));
            }
            files
        }
    };
    Ok(Made {
        files,
        report: mesh::report(format.name(), &loaded.scene, &model),
    })
}

/// Where to write: where it was said, else beside nobody, in the current folder; `None` for a scene
/// without a name.
fn destination(scene: &Path, said: Option<&Path>, extension: &str) -> Option<PathBuf> {
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
pub fn tracer(loaded: &Analysis) -> Result<Tracer, Error> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let images = Images::load(&loaded.scene, folder)?;
    Tracer::with_images(&loaded.scene, &images)
}
