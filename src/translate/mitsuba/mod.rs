//! Mitsuba 3 scenes: XML, and meshes as binary PLY beside it.
//!
//! Spheres, rectangles, boxes, planes and half-spaces that no operation cuts are Mitsuba's own shapes
//! ([`exact`]); everything else is a mesh ([`meshes`]). Materials are as near as its BSDFs allow
//! ([`bsdf`]); [`scenery`] does cameras and lights.

mod bsdf;
mod exact;
mod frame;
mod meshes;
mod options;
mod output;
mod scenery;
pub mod target;
mod verdict;
mod written;
mod xml;

use super::mesh::{self, picture};
use super::names::Names;
use super::{Fidelity, Report};
use crate::diagnostics::{Complaint, Error};
use crate::geometry::Aabb;
use crate::scene::{Camera, Scene};
use crate::solids::bounds::NodeBounds;
use crate::solids::staging::staged;
use crate::trace::{Tracer, Walkers, camera::View};
use bsdf::Bsdfs;
pub use frame::SceneFrame;
pub use options::{Integrator, Options};
pub use output::{Output, ShapeInfo};
pub use scenery::{is_exact, square_size};
use written::Written;

/// A comment on the entities of a shape: its own, and the one that its properties come from. Empty if neither is an
/// object of the scene.
fn described(names: &Names, shape: u32, object: u32) -> String {
    let of = |id| names.comment(id).map(|words| format!("{id}: {words}"));
    let own = of(shape);
    let other = of(object).filter(|_| object != shape);
    let all: Vec<String> = own.into_iter().chain(other).collect();
    match all.is_empty() {
        true => String::new(),
        false => xml::comment(&all.join("; in ")),
    }
}

/// The key of pieces that are joined where they overlap.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// Pieces of one medium: optics and index.
    Medium(u32, u32),
    /// Opaque pieces that have surfaces in common: the number of their group.
    Opaque(u32),
}

/// Translates a scene that was compiled with its pictures.
///
/// # Errors
/// A part of the scene has no translation, or too many triangles.
pub fn write(
    scene: &Scene,
    bounds: &[NodeBounds],
    tracer: &Tracer,
    options: &Options,
) -> Result<Output, Error> {
    let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
    let graph = &tracer.graph;
    let aspect = f64::from(options.size.0) / f64::from(options.size.1);
    let staged = staged(scene, options.viewpoint, aspect);
    let scene = &*staged;
    let cameras: Vec<Camera> = scene.chosen_cameras().copied().collect();
    let of_meshes = mesh::Options {
        tolerance: options.tolerance,
        memory: options.memory,
        eye: cameras.first().map(|c| c.position),
        pictured: true,
        plain: false,
        digits: false,
    };
    let mut parts = mesh::Parts::of(scene, bounds, graph, &of_meshes)?;
    parts.drop_equals();
    let clear =
        |skin: &mesh::SurfaceLabel| graph.optics[skin.optics.unwrap_or(0) as usize].kt != [0.0; 3];
    let media: Vec<mesh::Medium> = parts
        .skins
        .iter()
        .map(|skin| mesh::Medium {
            optics: skin.optics.unwrap_or(0),
            index: skin.index.unwrap_or(0),
            clear: clear(skin),
        })
        .collect();
    // An opaque piece hides the parts of others within it, unless a camera looks into it.
    let within = parts.is_cut_open() || cameras.iter().any(|c| is_within(tracer, c, options.size));
    parts.carve(&media, within);
    // Pieces are joined since one medium has no boundary within itself, and the first of several faces in one place is
    // seen.
    let sharing = parts.sharing();
    parts.join_by(|i, piece| {
        let m = media.get(piece.inside as usize)?;
        match m.clear || within {
            true => Some(Kind::Medium(m.optics, m.index)),
            false => sharing[i].map(Kind::Opaque),
        }
    })?;
    let clashes = parts.clashes(scene, graph, |piece| {
        within || media.get(piece.inside as usize).is_some_and(|m| m.clear)
    });
    let frame = SceneFrame::of(&parts.extent.region);
    let extent = parts.extent;
    if !frame.is_plain() {
        parts.place(&frame.matrix());
    }
    let there: Vec<Camera> = cameras.iter().map(|c| frame.camera(c)).collect();
    let eye = there.first().map_or([0.0; 3], |c| c.position);
    let reach = scenery::reach(&parts.extent.region, &there);
    let seen = exact::RequiredExtent {
        centre: parts.extent.region.centre(),
        far: reach,
    };

    // A value with a dollar sign is a parameter to Mitsuba.
    let stem = options.stem.replace('$', "_");
    let mut bsdfs = Bsdfs::new(graph);
    let (mut shapes, mut text) = (Vec::new(), String::new());
    let mut cut = meshes::Collector::default();
    let mut written = Written::new(scene, graph);
    // The number of parts without end that are not cut off as meshes are.
    let mut endless = 0;
    let names = Names::new(scene, &options.captions);
    for piece in &parts.pieces {
        let skin = &parts.skins[piece.inside as usize];
        let own = piece
            .whole
            .then(|| exact::shapes(scene, graph, skin, &seen));
        let Some(own) = own.flatten() else {
            cut.add(piece, &parts.skins, graph, parts.extent.grain(), eye);
            continue;
        };
        written.note(skin, true);
        endless += u64::from(exact::is_endless(scene, graph, skin));
        text.push_str(&described(&names, skin.shape, skin.object()));
        for shape in own {
            let bsdf = bsdfs.exact(skin, &shape, piece.around, &stem);
            shapes.push(ShapeInfo {
                shape: skin.shape,
                object: skin.object(),
                exact: true,
            });
            text.push_str(&shape.xml(&bsdf, shapes.len()));
        }
    }
    let mut files = Vec::new();
    for mesh in cut.finish(&parts.skins, graph) {
        let skin = &parts.skins[mesh.skin as usize];
        written.note(skin, false);
        let bsdf = bsdfs.mesh(skin, mesh.colours, mesh.around, &stem);
        shapes.push(mesh.info);
        let name = format!("{stem}_{}.ply", shapes.len());
        text.push_str(&described(&names, mesh.info.shape, mesh.info.object));
        text.push_str(&xml::ply(&name, &bsdf, &mesh.info, shapes.len()));
        files.push((name, mesh.bytes));
    }
    for number in &bsdfs.images {
        if let Some(picture) = picture::picture(*number, graph) {
            files.push((picture::file_name(&stem, *number), picture.png));
        }
    }
    let names: &[&'static str] = match cameras.len() {
        1 => &[""],
        _ => &["_left", "_right"],
    };
    let all = bounds[render.root as usize].all;
    let all = Aabb::new(frame.place(all.min), frame.place(all.max));
    let mut documents = Vec::new();
    for ((name, camera), there) in names.iter().zip(&cameras).zip(&there) {
        let nearest = frame.scale * nearest(tracer, camera, options.size);
        let view = scenery::view(scene, there, &all, nearest, reach, options)?;
        let lights = match options.integrator {
            Integrator::Path => scenery::lights(scene, &frame, &parts.extent.region),
            Integrator::Aov => String::new(),
        };
        let moved = match frame.is_plain() {
            true => String::new(),
            false => format!(
                "<!-- of the scene's coordinates, {} is taken off; the rest is multiplied by {} -->\n",
                xml::vector(frame.origin),
                crate::translate::number(frame.scale)
            ),
        };
        documents.push((
            *name,
            format!(
                "<!-- made by zpg, for Mitsuba 3 -->\n{moved}<scene version=\"3.0.0\">\n{}{view}{lights}{}{text}</scene>\n",
                bsdfs.dispersion().unwrap_or_default(),
                bsdfs.text
            ),
        ));
    }
    let mut report = Report::of("mitsuba", scene, |f| {
        verdict::verdict(f, extent.tolerance, &written)
    });
    parts.account(&mut report, endless);
    if bsdfs.brightest() > 1.0 {
        let fidelity = Fidelity::approximate("1 instead: Mitsuba knows none");
        report.state("colours above 1", fidelity, "");
    }
    for _ in 0..clashes {
        let doubt = "which of them is seen is up to rounding and the tolerance";
        report.count("surfaces in one place", Fidelity::approximate(doubt), "");
    }
    for camera in &cameras {
        if !scenery::is_exact(camera, options.size) {
            let why = match square_size(&cameras, options.size) {
                Some((width, height)) => Complaint::new("fidelity-square-pixels")
                    .with("width", width.to_string())
                    .with("height", height.to_string()),
                None => Complaint::term("pixels are made square, and no --size helps"),
            };
            let fidelity = Fidelity::Approximate(why);
            report.count(
                "cameras whose pixels are not squares",
                fidelity,
                "perspective",
            );
        }
    }
    Ok(Output {
        documents,
        meshes: files,
        shapes,
        extent,
        frame,
        reach: reach / frame.scale,
        report,
    })
}

/// Numbers of rays across and down that show how near a camera is to what it sees.
const RAYS: [u32; 2] = [64, 48];

/// The distance from where a camera's rays start to the nearest surface that a grid of rays meets; infinite if they
/// meet none.
fn nearest(tracer: &Tracer, camera: &Camera, (width, height): (u32, u32)) -> f64 {
    let Some(view) = View::new(camera, width, height) else {
        return f64::INFINITY;
    };
    let mut walkers: Walkers<f64> = tracer.walker();
    let [across, down] = RAYS;
    let at = |i: u32, n: u32, size: u32| (f64::from(i) + 0.5) / f64::from(n) * f64::from(size);
    let places = (0..down).flat_map(|y| (0..across).map(move |x| (x, y)));
    let rays = places.filter_map(|(x, y)| view.ray(at(x, across, width), at(y, down, height)));
    rays.filter_map(|ray| {
        let hit = tracer.hit(&mut walkers, &ray)?;
        Some(hit.t * ray.line.direction.length())
    })
    .fold(f64::INFINITY, f64::min)
}

/// Whether rays of a camera start in a solid.
fn is_within(tracer: &Tracer, camera: &Camera, (width, height): (u32, u32)) -> bool {
    let Some(view) = View::new(camera, width, height) else {
        return false;
    };
    let mut walkers: Walkers<f64> = tracer.walker();
    // The rays of a projection matrix start all over the picture.
    let (w, h) = (f64::from(width), f64::from(height));
    let mut within = |x: f64, y: f64| {
        let ray = view.ray(x * w, y * h);
        ray.is_some_and(|ray| tracer.probe(&mut walkers, &ray).inside_at_origin)
    };
    let steps = if view.is_pinhole() { 1..2 } else { 0..5 };
    let places = steps.map(|i| {
        if view.is_pinhole() {
            0.5
        } else {
            f64::from(i) / 4.0
        }
    });
    let places: Vec<f64> = places.collect();
    places.iter().any(|&y| places.iter().any(|&x| within(x, y)))
}
