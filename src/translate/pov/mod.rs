//! POV-Ray 3.7 scenes.
//!
//! Coordinates stay as they are; the whole scene is moved and scaled at the end ([`frame`], by what
//! [`reach`] sees of it), since POV-Ray's tolerances are absolute. With `assumed_gamma 1`, no attenuation
//! and no highlights its light is that of the reference ray tracer, except at total internal reflection.
//!
//! From the resolved scene to text, by values in a [`tree`]: [`cuts`] and [`spread`] say the scene in another way where
//! that is needed; [`build`] makes its objects, with their faces apart that POV-Ray could not tell apart;
//! [`simplify`] leaves out what is empty, writes equal objects once and names them; [`print`] writes the text, and never
//! sees the scene.

mod aspects;
mod between;
pub mod brightness;
mod build;
mod camera;
mod changes;
mod coplanar;
mod cuts;
mod descend;
mod difference;
mod facts;
mod filling;
mod flush;
mod frame;
mod grouping;
mod matrices;
mod neighbours;
mod offset;
pub mod pictures;
mod planes_moved;
mod print;
mod reach;
mod rewrite;
mod scenery;
mod sets;
mod sheets;
mod simplify;
mod spread;
mod standing;
mod state;
pub mod target;
mod textures;
mod tree;
mod triangle;
mod turned;
mod union;
mod verdict;
mod volumes;

use std::slice;

use super::{Fidelity, File, Report};
use crate::diagnostics::{Complaint, Error};
use crate::geometry::Aabb;
use crate::scene::{Optics, Render, Scene};
use crate::solids::bounds::node_bounds;
use crate::solids::staging::{Viewpoint, seen_box, staged};
use crate::syntax::Captions;
use build::Builder;
use camera::Eye;
use pictures::Pictures;
use simplify::simplified;
use tree::{Document, Image, Tree, Uses};

/// What the scene itself does not say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// Who takes the picture.
    pub viewpoint: Viewpoint,
    /// How often a ray may be mirrored or refracted.
    pub depth: u32,
    pub pictures: Pictures,
    pub stereo: Stereo,
    /// What comments say about the scene.
    pub captions: Captions,
}

/// What becomes of a pair of cameras.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stereo {
    /// A file for each eye.
    TwoFiles,
    /// One file for both, with a switch.
    OneFile,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            size: (640, 480),
            viewpoint: Viewpoint::Scene,
            depth: 10,
            pictures: Pictures::default(),
            stereo: Stereo::TwoFiles,
            captions: Captions::default(),
        }
    }
}

impl Options {
    fn aspect(&self) -> f64 {
        f64::from(self.size.0) / f64::from(self.size.1)
    }
}

/// A finished translation.
#[derive(Debug)]
pub struct Translation {
    /// One, or those of the left and the right eye.
    pub files: Vec<File>,
    /// How often each file has to be rendered: with 3, `Declare=Channel=0`, 1 and 2 give a picture
    /// each of which red, green and blue count.
    pub passes: u32,
    /// With `Declare=Light_Scale=` this power of two, every value of the pictures is multiplied by it, and none is
    /// brighter than white. Without, none is multiplied.
    pub light_scale: f64,
    pub report: Report,
}

/// POV-Ray's own limit on `max_trace_level`.
const MOST_LEVELS: u32 = 256;

/// Translates a scene.
///
/// # Errors
/// Something in it has no translation.
pub fn write(scene: &Scene, options: &Options) -> Result<Translation, Error> {
    let mut report = Report::of("pov", scene, |f| verdict::verdict(f, &options.pictures));
    let staged = staged(scene, options.viewpoint, options.aspect());
    let scene = &*staged;
    let reordered = cuts::reordered(scene);
    let scene = reordered.as_ref().unwrap_or(scene);
    let spread = spread::spread(scene);
    let scene = spread.as_ref().unwrap_or(scene);
    let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
    let bounds = node_bounds(scene);
    let whole = match render.clip {
        Some((min, max)) => Aabb::new(min, max),
        None => bounds[render.root as usize].all,
    };
    let eyes = camera::eyes(scene, whole, options, &mut report)?;
    let mut builder = Builder::new(scene, bounds, render.root, &options.captions, report);
    if let Some(eye) = eyes.first() {
        builder.turned = turned::turned(scene, &builder.facts, eye);
        builder.holds_turned = turned::holders(scene, &builder.facts, &builder.turned);
    }
    let seen = seen_box(scene, &builder.bounds);
    let frame = frame::frame(
        seen,
        &eyes,
        reach::reach(scene, &eyes, whole),
        &mut builder.report,
    );
    let hair = frame::hair(&frame);
    builder.hair_of_scene = hair;
    let objects = builder.objects(render.root);
    let lights_in_group = scenery::is_lit_from_surface(scene, &builder.bounds, render.root);
    builder.report_what_is_left();
    let Builder {
        textures,
        aspects,
        mut report,
        cut_open,
        ..
    } = builder;
    let (textures, images) = textures.values(&aspects, scene, &options.pictures);
    let tree = simplified(Tree {
        images,
        root: objects.len().checked_sub(1),
        objects,
        textures,
        uses: Uses::default(),
    });
    report_what_is_used(&tree, cut_open, options, &mut report);
    let light_scale = light_scale(&tree, scene, &render, options);
    let passes = if tree.uses.dispersion { 3 } else { 1 };
    let document = Document {
        title: options.captions.title(),
        size: options.size,
        levels: options.depth.saturating_add(1).min(MOST_LEVELS),
        light_scale,
        frame,
        background: render.background,
        ambient: scenery::ambient(scene),
        lights: scenery::point_lights(scene, &options.captions),
        lights_in_group,
        tree,
        caption: options.captions.entity(render.root_id),
        // A face in a face of the box is drawn, too.
        clip: (render.clip).map(|(min, max)| (min.map(|x| x - hair), max.map(|x| x + hair))),
    };
    let file = |suffix, eyes: &[Eye]| {
        let lenses: Vec<_> = eyes.iter().map(|eye| eye.lens.clone()).collect();
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = print::print(&mut text, &document, &lenses);
        File { suffix, text }
    };
    let files = match (&eyes[..], options.stereo) {
        ([left, right], Stereo::TwoFiles) => {
            { [("_left", left), ("_right", right)].map(|(s, eye)| file(s, slice::from_ref(eye))) }
                .into()
        }
        _ => vec![file("", &eyes)],
    };
    Ok(Translation {
        files,
        passes,
        light_scale,
        report,
    })
}

fn light_scale(tree: &Tree, scene: &Scene, render: &Render, options: &Options) -> f64 {
    let default = Optics::default();
    let optics = tree.textures.iter().map(|texture| &texture.optics);
    let optics = optics.chain(std::iter::once(&default));
    scenery::light_scale(scene, render, optics, options.depth)
}

/// States what it costs that the objects are what they are.
fn report_what_is_used(tree: &Tree, cut_open: bool, options: &Options, report: &mut Report) {
    if tree.uses.unseen {
        let note = "faces between them stand a hair apart";
        let media = "transparent parts that meet or overlap";
        report.state(media, Fidelity::Exact, note);
    }
    if cut_open && tree.uses.refraction {
        report.state(
            "refraction in solids that the render box cuts open",
            Fidelity::approximate(
                "rays that enter through the cut leave the solid as if they entered it",
            ),
            "",
        );
    }
    let closed = |image: &Image| !image.file.is_ascii();
    if tree.images.iter().any(closed) {
        report.state(
            "pictures whose paths are not ASCII",
            Fidelity::Dropped,
            "POV-Ray cannot open them: choose a file with -o",
        );
    }
    if options.depth >= MOST_LEVELS {
        report.state(
            "depth",
            Fidelity::Approximate(
                Complaint::new("fidelity-depth").with("depth", (MOST_LEVELS - 1).to_string()),
            ),
            "",
        );
    }
}
