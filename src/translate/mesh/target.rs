//! Translation into mesh formats. A mesh is written to files that are named after the scene.

use std::borrow::Cow;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::glb_scenery::Scenery;
use super::material::Coloured;
use super::model::{model, report};
use super::options::Options;
use super::picture::file_name;
use super::{glb, obj, ply, precision, stl};
use crate::analysis::file::STDIN;
use crate::diagnostics::{Complaint, Error};
use crate::solids::staging::{Viewpoint, staged};
use crate::translate::names::Names;
use crate::translate::plain::plain;
use crate::translate::target::{self, Output, OutputKind, Prepared, Target};

/// The mesh file formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Ply,
    Obj,
    Glb,
    Stl,
}

impl Target for Format {
    fn name(&self) -> &'static str {
        match self {
            Format::Ply => "ply",
            Format::Obj => "obj",
            Format::Glb => "glb",
            Format::Stl => "stl",
        }
    }

    fn help(&self) -> &'static str {
        match self {
            Format::Ply => "Triangles: Stanford PLY, binary, with colours",
            Format::Obj => "Triangles: Wavefront OBJ, with a library of materials beside it",
            Format::Glb => "Triangles: glTF 2.0, binary",
            Format::Stl => "Triangles: STL, binary, for 3D printers",
        }
    }

    fn draws(&self) -> bool {
        true
    }

    fn form(&self) -> OutputKind {
        match self {
            Format::Obj => OutputKind::Files,
            Format::Ply | Format::Glb | Format::Stl => OutputKind::Binary,
        }
    }

    fn write(&self, scene: &Prepared, options: &target::Options) -> Result<Output, Error> {
        let Some(path) = destination(options.file, options.output, self.name()) else {
            let complaint = Complaint::new("mesh-without-name").with("format", self.name());
            return Err(Error::Request(complaint));
        };
        let tracer = scene.tracer()?;
        let own = Options {
            tolerance: options.tolerance,
            memory: options.memory,
            eye: None,
            pictured: matches!(self, Format::Obj | Format::Glb),
            plain: *self == Format::Stl,
            digits: *self == Format::Obj,
        };
        let model = model(scene.scene(), scene.bounds(), &tracer.graph, &own)?;
        let coloured = Coloured::new(&model, &tracer.graph, own.pictured);
        let names = Names::new(scene.scene(), &scene.captions);
        let mesh = &model.mesh;
        let (files, off) = match self {
            Format::Ply => {
                let places = precision::single(mesh);
                let bytes = ply::write(&coloured, &places.all);
                (vec![(Some(path), bytes)], places.off)
            }
            Format::Stl => {
                let places = precision::single(mesh);
                let bytes = stl::write(&places.all, &mesh.triangles);
                (vec![(Some(path), bytes)], places.off)
            }
            Format::Glb => {
                let places = precision::single(mesh);
                let aspect = f64::from(options.size.0) / f64::from(options.size.1);
                // An automatic camera is left to the viewer, unless it was asked for.
                let seen = match options.viewpoint {
                    Viewpoint::Scene => Cow::Borrowed(scene.scene()),
                    asked => staged(scene.scene(), asked, aspect),
                };
                let scenery =
                    Scenery::of(&seen, &scene.scene().point_lights, &model.extent, &names);
                let bytes = glb::write(&coloured, &places.all, &names, scenery);
                (vec![(Some(path), bytes)], places.off)
            }
            Format::Obj => {
                let places = precision::decimal(mesh, model.extent.tolerance);
                let name = |p: &Path| {
                    p.file_name()
                        .unwrap_or_default()
                        .to_string_lossy()
                        .into_owned()
                };
                // In an OBJ file a name ends at a space, so the stem must not contain one.
                let stem = plain(&path.file_stem().unwrap_or_default().to_string_lossy());
                let library = path.with_file_name(format!("{stem}.mtl"));
                let picture = |number: u32| path.with_file_name(file_name(&stem, number));
                let library_name = name(&library);
                let picture_name = |number| name(&picture(number));
                let (text, materials) =
                    obj::write(&coloured, &places.all, &names, &library_name, picture_name);
                let mut files = vec![
                    (Some(path.clone()), text.into_bytes()),
                    (Some(library), materials.into_bytes()),
                ];
                for (number, picture_of) in &coloured.pictures.all {
                    files.push((Some(picture(*number)), picture_of.png.clone()));
                }
                (files, places.off)
            }
        };
        Ok(Output {
            files,
            report: report(self.name(), scene.scene(), &model, off),
        })
    }
}

/// The path of the output file: `said` if it is given, else the scene's name with `extension`, in the current folder.
/// `None` for a scene without a name.
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
