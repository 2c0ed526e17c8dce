//! Mitsuba 3 scenes: XML, and meshes as binary PLY beside it.
//!
//! Spheres, rectangles, boxes, planes and half-spaces that no operation cuts are Mitsuba's own shapes
//! ([`exact`]); everything else is a mesh ([`meshes`]). Materials are as near as its BSDFs allow
//! ([`bsdf`]); [`scenery`] does cameras and lights.

mod bsdf;
mod exact;
mod meshes;
mod scenery;
mod verdict;
mod xml;

use super::{Report, Unsupported, mesh};
use crate::scene::Scene;
use crate::trace::Tracer;
use bsdf::Bsdfs;

/// What Mitsuba is to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Integrator {
    /// A picture, by path tracing.
    #[default]
    Path,
    /// Of what is seen through the middle of each pixel: position (channels 0 to 2), shading normal
    /// (3 to 5), and the number of the shape in [`Output::shapes`], from 1, 0 for none (6).
    Aov,
}

/// What the scene itself does not say.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// How often a ray may be mirrored or refracted.
    pub depth: u32,
    /// As in [`mesh::Options`].
    pub tolerance: Option<f64>,
    pub integrator: Integrator,
    /// What the names of meshes begin with.
    pub stem: String,
}

/// One shape of the translation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShapeInfo {
    /// The entity whose record made the surface.
    pub shape: u32,
    /// The entity whose properties apply.
    pub object: u32,
    /// Not a mesh.
    pub exact: bool,
}

/// A finished translation.
#[derive(Debug)]
pub struct Output {
    /// One, or one for each eye: what the file's name ends with before `.xml`, and the text.
    pub documents: Vec<(&'static str, String)>,
    /// Files beside the documents: name and bytes.
    pub meshes: Vec<(String, Vec<u8>)>,
    /// In the order of Mitsuba's shape index.
    pub shapes: Vec<ShapeInfo>,
    /// How far the meshes may be from the shapes, and where parts without end are cut off.
    pub extent: mesh::Extent,
    pub report: Report,
}

/// Translates a scene that was compiled with its pictures.
///
/// # Errors
/// Something in it has no translation, or too many triangles.
pub fn write(scene: &Scene, tracer: &Tracer, options: &Options) -> Result<Output, Unsupported> {
    scene.render.ok_or_else(|| Unsupported {
        id: 0,
        span: None,
        message: "the scene has no render record: nothing is drawn".to_owned(),
    })?;
    let graph = &tracer.graph;
    let cameras = scenery::cameras(scene, options);
    let of_meshes = mesh::Options {
        tolerance: options.tolerance,
        eye: cameras.first().map(|c| c.position),
    };
    let mut parts = mesh::Parts::of(scene, graph, &of_meshes)?;
    // One medium has no boundary in itself.
    let media: Vec<Option<u64>> = parts
        .skins
        .iter()
        .map(|skin| {
            let (optics, index) = (skin.optics.unwrap_or(0), skin.index.unwrap_or(0));
            let clear = graph.optics[optics as usize].kt != [0.0; 3];
            clear.then_some(u64::from(optics) << 32 | u64::from(index))
        })
        .collect();
    // What is opaque hides what overlaps in it, unless one looks into it.
    let opaque = parts.is_cut_open().then_some(u64::MAX);
    parts.join_by(|piece| media[piece.inside as usize].or(opaque));
    let reach = scenery::reach(&parts.extent.region, &cameras);

    let mut bsdfs = Bsdfs::new(graph);
    let (mut shapes, mut text) = (Vec::new(), String::new());
    let mut cut = meshes::Collector::default();
    for piece in &parts.pieces {
        let skin = &parts.skins[piece.inside as usize];
        let own = piece.whole.then(|| exact::shape(scene, graph, skin, reach));
        match own.flatten() {
            Some(shape) => {
                let bsdf = bsdfs.exact(skin, &shape);
                shapes.push(ShapeInfo {
                    shape: skin.shape,
                    object: skin.object(),
                    exact: true,
                });
                text.push_str(&shape.xml(&bsdf, shapes.len()));
            }
            None => cut.add(piece, &parts.skins, graph, parts.extent.grain()),
        }
    }
    let mut files = Vec::new();
    for mesh in cut.finish(&parts.skins, graph) {
        let bsdf = bsdfs.mesh(&parts.skins[mesh.skin as usize], mesh.colours);
        shapes.push(mesh.info);
        let name = format!("{}_{}.ply", options.stem, shapes.len());
        text.push_str(&xml::ply(&name, &bsdf, &mesh.info, shapes.len()));
        files.push((name, mesh.bytes));
    }
    let names: &[&'static str] = match cameras.len() {
        1 => &[""],
        _ => &["_left", "_right"],
    };
    let mut documents = Vec::new();
    for (name, camera) in names.iter().zip(&cameras) {
        let view = scenery::view(scene, camera, reach, options)?;
        let lights = match options.integrator {
            Integrator::Path => scenery::lights(scene, camera, &parts.extent.region),
            Integrator::Aov => String::new(),
        };
        documents.push((
            *name,
            format!(
                "<!-- made by zpg, for Mitsuba 3 -->\n<scene version=\"3.0.0\">\n{view}{lights}{}{text}</scene>\n",
                bsdfs.text
            ),
        ));
    }
    let extent = parts.extent;
    let mut report = Report::of("mitsuba", scene, |f| verdict::verdict(f, extent.tolerance));
    parts.account(&mut report);
    Ok(Output {
        documents,
        meshes: files,
        shapes,
        extent,
        report,
    })
}
