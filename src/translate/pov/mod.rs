//! POV-Ray 3.7 scenes.
//!
//! Coordinates stay as they are; the whole scene is moved and scaled at the end, since POV-Ray's tolerances are
//! absolute. With `assumed_gamma 1`, no attenuation and no highlights its light is that of the reference ray tracer,
//! except at total internal reflection.
//!
//! The scene becomes text in passes, which share a [`tree`] of values. [`lower`] makes POV-Ray's objects from the
//! scene: [`model`] answers its questions about nodes, and [`separate`] decides what to do about faces in one place.
//! [`simplify`] leaves out empty objects and duplicates, and names the rest. [`mod@print`] writes the text: it decides
//! nothing, and never sees the scene.

pub mod brightness;
mod budget;
mod lower;
mod model;
pub mod pictures;
mod print;
mod separate;
mod simplify;
pub mod target;
mod tree;
mod verdict;

use std::slice;

use super::{Fidelity, File, Report};
use crate::diagnostics::{Complaint, Error, Language};
use crate::scene::Scene;
use crate::solids::bounds::NodeBounds;
use crate::solids::staging::{Viewpoint, staged};
use crate::syntax::Captions;
use budget::Budget;
use pictures::Pictures;
use simplify::simplified;
use tree::{Document, Lens};

/// The choices that the scene itself does not make.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// The camera that takes the picture.
    pub viewpoint: Viewpoint,
    /// How often a ray may be mirrored or refracted.
    pub depth: u32,
    pub pictures: Pictures,
    pub stereo: Stereo,
    /// The scene's names in comments.
    pub captions: Captions,
    /// The name of the output file, without its extension. The command at the head of the file has it, unless it has
    /// characters that a shell would treat specially.
    pub name: String,
    /// The language of the comments at the head.
    pub language: Language,
}

/// The treatment of a pair of cameras.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stereo {
    /// A file for each eye.
    TwoFiles,
    /// A single file for both eyes, with a switch.
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
            name: "scene".to_owned(),
            language: Language::English,
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
    /// The file, or those of the left and the right eye.
    pub files: Vec<File>,
    /// The number of times that each file has to be rendered. With 3, `Declare=Channel=0`, 1 and 2 give three pictures:
    /// the red of the first one counts, the green of the second, and the blue of the third.
    pub passes: u32,
    /// Power of two that multiplies every value of the pictures with `Declare=Light_Scale=` this number, so that none
    /// is brighter than white. Without the option no value is multiplied.
    pub light_scale: f64,
    pub report: Report,
}

/// POV-Ray's own limit on `max_trace_level`.
const MAX_TRACE_LEVEL: u32 = 256;

/// Translates a scene to a POV-Ray file. `bounds` holds the bounds of each node of `scene`.
///
/// # Errors
/// A part of the scene has no translation.
pub fn write(
    scene: &Scene,
    bounds: &[NodeBounds],
    options: &Options,
) -> Result<Translation, Error> {
    let report = Report::of("pov", scene, |f| verdict::verdict(f, &options.pictures));
    let staged = staged(scene, options.viewpoint, options.aspect());
    let budget = Budget::default();
    // The staged scene has the same nodes, so the bounds fit it.
    let (scene, facts) =
        lower::rewritten(&staged, bounds, &budget).ok_or_else(Error::nothing_to_draw)?;
    let (mut document, lenses, mut report) = lower::lower(&scene, facts, options, &budget, report)?;
    budget.report(&mut report);
    document.tree = simplified(document.tree);
    document.light_scale = brightness::light_scale(&document, options.depth);
    report_uses(&document, options, &mut report);
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    let name = match options.name.chars().all(is_plain) {
        true => &options.name,
        false => "scene",
    };
    let file = |suffix, lenses: &[Lens]| {
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = print::print(
            &mut text,
            &document,
            lenses,
            &format!("{name}{suffix}"),
            options.language,
        );
        File { suffix, text }
    };
    let files = match (&lenses[..], options.stereo) {
        ([left, right], Stereo::TwoFiles) => vec![
            file("_left", slice::from_ref(left)),
            file("_right", slice::from_ref(right)),
        ],
        _ => vec![file("", &lenses)],
    };
    Ok(Translation {
        files,
        passes: if document.tree.uses.dispersion { 3 } else { 1 },
        light_scale: document.light_scale,
        report,
    })
}

/// Adds lines to the report about what the finished document uses: transparent parts that meet, solids that are cut
/// open, paths of pictures, and depth.
fn report_uses(document: &Document, options: &Options, report: &mut Report) {
    let tree = &document.tree;
    if tree.uses.unseen {
        let note = "faces between them stand a hair apart";
        let media = "transparent parts that meet or overlap";
        report.state(media, Fidelity::Exact, note);
    }
    if document.cut_open && tree.uses.refraction {
        report.state(
            "refraction in solids that the render box cuts open",
            Fidelity::approximate(
                "rays that enter through the cut leave the solid as if they entered it",
            ),
            "",
        );
    }
    if tree.images.iter().any(|image| !image.file.is_ascii()) {
        report.state(
            "pictures whose paths are not ASCII",
            Fidelity::Dropped,
            "POV-Ray cannot open them: choose a file with -o",
        );
    }
    if options.depth >= MAX_TRACE_LEVEL {
        report.state(
            "depth",
            Fidelity::Approximate(
                Complaint::new("fidelity-depth").with("depth", (MAX_TRACE_LEVEL - 1).to_string()),
            ),
            "",
        );
    }
}
