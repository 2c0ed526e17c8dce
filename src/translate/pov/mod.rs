//! POV-Ray 3.7 scenes.
//!
//! Coordinates stay as they are; the whole scene is moved and scaled at the end ([`frame`], by what
//! [`reach`] sees of it), since POV-Ray's tolerances are absolute. With `assumed_gamma 1`, no attenuation
//! and no highlights its light is that of the reference ray tracer, except at total internal reflection.
//!
//! From the resolved scene to text: [`cuts`] and [`spread`] say it in another way where that is needed,
//! by [`rewrite`]; [`facts`] about every node, bottom-up; [`build`] with [`descend`], [`union`],
//! [`between`], [`neighbours`], [`difference`], [`grouping`], [`flush`], [`standing`], [`filling`] and [`sets`]
//! says what each object consists of, as [`piece`]s, with [`changes`] where nobody sees them ([`lengthen`](crate::solids::shapes::lengthen),
//! [`offset`]); [`emit`] orders, names and prints them; [`look`] and
//! [`uv`] know POV-Ray's textures, [`shape`] with [`poly`], [`profile`] and [`triangle`] its
//! primitives, [`turned`] the triangles with normals that turn away, [`volumes`] the bounding volumes that may
//! be written; [`camera`] and [`scenery`] do the rest. [`verdict`] says what becomes of each feature.

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
mod emit;
mod facts;
mod filling;
mod flush;
mod frame;
mod grouping;
mod look;
mod matrices;
mod neighbours;
mod offset;
pub mod pictures;
mod piece;
mod planes_moved;
mod poly;
mod profile;
mod reach;
mod rewrite;
mod scenery;
mod sets;
mod shape;
mod sheets;
mod spread;
mod standing;
pub mod target;
mod text;
mod triangle;
mod turned;
mod union;
mod uv;
mod verdict;
mod volumes;

use std::fmt::Write as _;

use super::{Fidelity, File, Report};
use crate::diagnostics::{Complaint, Error};
use crate::scene::{Optics, Render, Scene};
use crate::solids::contacts;
use crate::solids::staging::{Viewpoint, staged};
use crate::syntax::Captions;
use build::Builder;
use camera::Eye;
use emit::Emitter;
use frame::Frame;
use pictures::Pictures;
use text::{entity, number, rgb, vector};

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

/// What faces look like that are only there for POV-Ray to know where a ray leaves an object.
const UNSEEN: &str = "\
    // Where one medium ends in another: a hair behind the face that is seen.\n\
    #declare Unseen = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } };\n";

/// A half-space whose boundary is beyond the farthest that POV-Ray looks.
const EVERYWHERE: &str = "\
    // All of space. What is clipped by it without something else is kept outside of that.\n\
    #declare Everywhere = plane { <0, 1, 0>, 1e9 };\n";

/// POV-Ray's own limit on `max_trace_level`.
const MOST_LEVELS: u32 = 256;

/// Translates a scene.
///
/// # Errors
/// Something in it has no translation.
pub fn write(scene: &Scene, options: &Options) -> Result<Translation, Error> {
    let report = Report::of("pov", scene, |f| verdict::verdict(f, &options.pictures));
    let staged = staged(scene, options.viewpoint, options.aspect());
    let scene = &*staged;
    let reordered = cuts::reordered(scene);
    let scene = reordered.as_ref().unwrap_or(scene);
    let spread = spread::spread(scene);
    let scene = spread.as_ref().unwrap_or(scene);
    let render = scene.render.ok_or_else(Error::nothing_to_draw)?;
    let mut builder = Builder::new(scene, render.root, report);
    let eyes = camera::eyes(scene, &mut builder, options)?;
    if let Some(eye) = eyes.first() {
        builder.turned = turned::turned(scene, &builder.facts, eye);
        builder.holds_turned = turned::holders(scene, &builder.facts, &builder.turned);
    }
    let frame = Frame::of(&mut builder, &eyes);
    builder.hair_of_scene = frame.hair();
    let mut emitter = Emitter::new(&mut builder, &options.captions);
    let root = emitter.declare(render.root);
    let everywhere = emitter.everywhere;
    let (objects, geodesics) = (emitter.text, emitter.geodesics);
    let light_scale = light_scale(&builder, &render, options);

    let mut looks = String::new();
    if builder.unseen {
        looks.push_str(UNSEEN);
        let note = "faces between them stand a hair apart";
        let media = "transparent parts that meet or overlap";
        builder.report.state(media, Fidelity::Exact, note);
    }
    builder
        .looks
        .write(&mut looks, &builder.aspects, scene, &options.pictures);
    let on_surface = scenery::is_lit_from_surface(scene, &builder.bounds, render.root);
    let file = |eyes: &[Eye]| {
        let mut out = String::new();
        header(&mut out, &builder, eyes, options, light_scale);
        settings(&mut out, scene, &render, &frame, options);
        let captions = &options.captions;
        out.push_str(&camera::cameras(eyes, &frame, captions));
        let mut lights = scenery::point_lights(scene, &frame, captions);
        let mut picture = picture(root.as_deref(), &render, &frame, captions);
        if on_surface {
            picture = scenery::light_group(&std::mem::take(&mut lights), &picture);
        }
        out.push_str(&lights);
        out.push('\n');
        out.push_str(&looks);
        out.push('\n');
        if everywhere {
            out.push_str(EVERYWHERE);
        }
        out.push_str(&shape::geodesics(geodesics.iter().copied()));
        out.push_str(&objects);
        out.push_str(&picture);
        out
    };
    let files = match (&eyes[..], options.stereo) {
        ([left, right], Stereo::TwoFiles) => [("_left", left), ("_right", right)]
            .map(|(suffix, eye)| File {
                suffix,
                text: file(std::slice::from_ref(eye)),
            })
            .into(),
        _ => vec![File {
            suffix: "",
            text: file(&eyes),
        }],
    };
    if builder.cut_open && builder.refractive {
        builder.report.state(
            "refraction in solids that the render box cuts open",
            Fidelity::approximate(
                "rays that enter through the cut leave the solid as if they entered it",
            ),
            "",
        );
    }
    if builder.unseen_twice {
        builder.report.state(
            "depth of rays in parts that others surround",
            Fidelity::approximate("light that is mirrored there takes two steps more"),
            "",
        );
    }
    let flush = contacts::pairs(scene, &builder.bounds);
    let is_left = |pair: &[u32; 2]| !pair.iter().any(|shape| builder.longer.contains(shape));
    if let Some([shape, _]) = flush.into_iter().find(is_left) {
        builder.faces_in_one_place(scene.shapes[shape as usize].id);
    }
    if !builder.longer.is_empty() {
        let note = "made longer, where nobody sees them";
        let tools = "solids that end flush with others";
        builder.report.state(tools, Fidelity::Exact, note);
    }
    let drawn = |node| builder.facts.get(node as usize).is_some_and(|f| f.uses > 0);
    let left_out = volumes::left_out(scene, &builder.volumes, drawn);
    if !left_out.is_empty() {
        let ids: Vec<String> = left_out.iter().take(8).map(u32::to_string).collect();
        let more = if left_out.len() > ids.len() {
            ", …"
        } else {
            ""
        };
        builder.report.state(
            "bounding volumes left out",
            Fidelity::Exact,
            Complaint::new("fidelity-volumes").with("ids", ids.join(", ") + more),
        );
    }
    let closed = |file: &str| !options.pictures.path(file).is_ascii();
    if builder.looks.pictures(&builder.aspects).any(closed) {
        builder.report.state(
            "pictures whose paths are not ASCII",
            Fidelity::Dropped,
            "POV-Ray cannot open them: choose a file with -o",
        );
    }
    if options.depth >= MOST_LEVELS {
        builder.report.state(
            "depth",
            Fidelity::Approximate(
                Complaint::new("fidelity-depth").with("depth", (MOST_LEVELS - 1).to_string()),
            ),
            "",
        );
    }
    Ok(Translation {
        files,
        passes: if builder.dispersive { 3 } else { 1 },
        light_scale,
        report: builder.report,
    })
}

fn light_scale(builder: &Builder, render: &Render, options: &Options) -> f64 {
    let default = Optics::default();
    let looks: Vec<&Optics> = builder
        .looks
        .optics()
        .map(|o| builder.aspects.optics(o))
        .chain(std::iter::once(&default))
        .collect();
    let optics = looks.iter().copied();
    scenery::light_scale(builder.scene, render, optics, options.depth)
}

/// How to render the file so that its pixels can be compared.
fn header(out: &mut String, builder: &Builder, eyes: &[Eye], options: &Options, light_scale: f64) {
    let (w, h) = options.size;
    let mut switches = String::new();
    if builder.dispersive {
        switches += " Declare=Channel=0";
    }
    if eyes.len() > 1 {
        switches += " Declare=Eye=0";
    }
    if light_scale < 1.0 {
        switches += &format!(" Declare=Light_Scale={}", number(light_scale));
    }
    // Writing to a string does not fail.
    if let Some(title) = options.captions.title() {
        let _ = writeln!(out, "// {title}");
    }
    let _ = write!(
        out,
        "// A scene for POV-Ray 3.7. For linear values, one ray through the middle of each pixel:\n\
         //   povray +Iscene.pov +Oscene.png +W{w} +H{h} -A -D +FN16 File_Gamma=1.0{switches}\n"
    );
    if builder.dispersive {
        out.push_str(
            "// Some index differs by channel. Render three times, with Channel 0, 1 and 2, and keep\n\
             // red of the first picture, green of the second and blue of the third.\n\
             #ifndef (Channel) #declare Channel = 0; #end\n",
        );
    }
    if eyes.len() > 1 {
        out.push_str(
            "// A stereo pair: render with Eye 0 (left) and Eye 1 (right).\n\
             #ifndef (Eye) #declare Eye = 0; #end\n",
        );
    }
}

/// Scales, global settings, defaults, background.
fn settings(out: &mut String, scene: &Scene, render: &Render, frame: &Frame, options: &Options) {
    let levels = options.depth.saturating_add(1).min(MOST_LEVELS);
    let ambient = rgb(scenery::ambient(scene));
    let background = rgb(render.background);
    let _ = write!(
        out,
        "#version 3.7;\n\n\
         // All light is multiplied by this. Less than 1 keeps what an image file cannot hold: light above white.\n\
         #ifndef (Light_Scale) #declare Light_Scale = 1; #end\n"
    );
    frame.write(out);
    let _ = write!(
        out,
        "\nglobal_settings {{\n  assumed_gamma 1\n  ambient_light {ambient}*Light_Scale\n  \
         max_trace_level {levels}\n  adc_bailout 0\n}}\n\
         #default {{ texture {{ pigment {{ rgb 1 }} finish {{ ambient 1 diffuse 1 emission 0 }} }} }}\n\
         background {{ {background}*Light_Scale }}\n\n"
    );
}

/// The object that is drawn.
fn picture(root: Option<&str>, render: &Render, frame: &Frame, captions: &Captions) -> String {
    let Some(root) = root else {
        return "\n// There is nothing to draw.\n".to_owned();
    };
    // A face in a face of the box is drawn, too.
    let hair = frame.hair();
    let clip = match render.clip {
        Some((min, max)) => format!(
            "  // only what lies in this box is drawn\n  clipped_by {{ box {{ {}, {} }} }}\n",
            vector(&min.map(|x| x - hair)),
            vector(&max.map(|x| x + hair))
        ),
        None => String::new(),
    };
    format!(
        "\n// the scene: {}\nobject {{\n  {root}\n{clip}  {}\n}}\n",
        entity(render.root_id, captions),
        frame.modifiers()
    )
}
