//! `zpg probe`: what is on a ray, in a pixel or at a point.

mod answer;
mod rays;

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::camera::{CameraArgs, one_camera};
use super::help;
use super::memory::Memory;
use super::size::Size;
use super::terminal::print;
use super::{LookChoice, Needs, Status, complain, load_for, refuse, usage};
use crate::analysis::Analysis;
use crate::analysis::file::{STDIN, unreadable};
use crate::diagnostics::{Complaint, Error, Span, Value};
use crate::geometry::dd::Dd;
use crate::geometry::vec::Vec3;
use crate::scene::{Render, Scene};
use crate::syntax::table::Kind;
use crate::trace::camera::View;
use crate::trace::{Crop, Images, Numbers, Ray, Settings, Tracer, members};
use answer::{PixelAnswer, PointAnswer, RayAnswer};
use rays::{BadRay, Input};

/// Answer questions about rays and points
#[derive(Debug, clap::Args)]
#[command(
    group = clap::ArgGroup::new("question").required(true).args(["ray", "rays", "pixel", "point"]),
    after_help = "\
Prints one JSON object a line, in the order of the rays. A ray's has all boundary crossings with t > 0,
ascending, as if every surface let it through; t is in units of the direction's length. A file of rays
has one a line, `ox oy oz dx dy dz` or with commas; empty lines and what follows a # are skipped. A line that is no
such ray, or one that the precision has no numbers for, is complained about on standard error and has
no answer; the others have theirs, and the exit status is 2. A line of more than 65536 bytes ends the
file.

`shape` is the ID whose record made the surface, a copy's own for a copied shape; `object` is the
outermost entity above it that was given properties, or else the shape. The normal points out of the
solid, also where a cut made the boundary. What lies outside of the render record's box is not
reported, but counts for `inside_at_origin`, the state just behind the origin.

--point lists the IDs of the solids, shapes and operations, that contain the point; boundaries of
shapes belong to them. `in_scene`: whether the whole does, within the render record's box. That is
decided in doubles, with dd where these cannot count the boundaries, whatever --precision says.

Examples:
  zpg probe scene.zpg --ray \"0 0 9  0 0 -1\"
  zpg probe scene.zpg --rays rays.txt > hits.jsonl
  zpg probe scene.zpg --pixel 320,240 --size 640x480
  zpg probe scene.zpg --point \"0 1 0\" --object 4"
)]
pub struct Args {
    /// The scene, as records or as JSON; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// Origin and direction of one ray; commas may stand between the numbers
    #[arg(help_heading = help::QUESTION)]
    #[arg(long, value_name = "OX OY OZ DX DY DZ", allow_hyphen_values = true)]
    ray: Option<RayArg>,

    /// A file of rays; `-` is standard input
    #[arg(help_heading = help::QUESTION)]
    #[arg(long, value_name = "FILE")]
    rays: Option<PathBuf>,

    /// The ray through the centre of a pixel, counted from 0 at the upper left
    #[arg(help_heading = help::QUESTION)]
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pixel: Option<PixelArg>,

    /// A point
    #[arg(help_heading = help::QUESTION)]
    #[arg(long, value_name = "X Y Z", allow_hyphen_values = true)]
    point: Option<PointArg>,

    /// Width and height of the picture that --pixel is in
    #[arg(
        long,
        value_name = "WxH",
        default_value = "640x480",
        requires = "pixel"
    )]
    size: Size,

    #[command(flatten)]
    camera: CameraArgs,

    /// Ask about this object as it stands at the end of the file, not about the whole scene; the
    /// render record's box does not apply
    #[arg(long, value_name = "ID", value_parser = usage::whole::<u32>, allow_negative_numbers = true)]
    object: Option<u32>,

    /// The numbers to compute with; with dd, t, points and normals are strings of 32 digits. It does
    /// not apply to --point
    #[arg(long, value_enum, default_value = "f64")]
    precision: Numbers,

    #[command(flatten)]
    memory: Memory,
}

#[derive(Debug, Clone, Copy)]
struct RayArg(Ray);

impl FromStr for RayArg {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<RayArg, Complaint> {
        rays::parse(s).map(RayArg)
    }
}

#[derive(Debug, Clone, Copy)]
struct PointArg(Vec3);

impl FromStr for PointArg {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<PointArg, Complaint> {
        rays::numbers(s).map(|p| PointArg(Vec3(p)))
    }
}

#[derive(Debug, Clone, Copy)]
struct PixelArg([u32; 2]);

impl FromStr for PixelArg {
    type Err = Complaint;

    fn from_str(s: &str) -> Result<PixelArg, Complaint> {
        let numbers: Result<Vec<u32>, _> = s.split(',').map(|n| n.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x, y]) => Ok(PixelArg([x, y])),
            _ => Err(Complaint::new("expected-pixel")),
        }
    }
}

/// The options that take several numbers, and how many.
const SEVERAL: [(&str, usize); 3] = [("--ray", 6), ("--pixel", 2), ("--point", 3)];

/// The arguments of the program, with the numbers behind an option of `SEVERAL` joined into one argument. The user
/// need not keep them together with quotes.
pub fn joined(written: impl Iterator<Item = OsString>) -> Vec<OsString> {
    fn number(arg: &OsString) -> Option<&str> {
        let text = arg.to_str()?.trim_end_matches(',');
        text.parse::<f64>().ok().map(|_| text)
    }
    let mut written = written.peekable();
    let mut all = Vec::new();
    while let Some(arg) = written.next() {
        let option = SEVERAL.iter().find(|(name, _)| arg == *name);
        all.push(arg);
        let mut numbers = Vec::new();
        while option.is_some_and(|&(_, count)| numbers.len() < count)
            && let Some(next) = written.next_if(|next| number(next).is_some())
        {
            numbers.extend(number(&next).map(str::to_owned));
        }
        if !numbers.is_empty() {
            all.push(numbers.join(",").into());
        }
    }
    all
}

pub fn run(args: &Args, look: LookChoice) -> Status {
    let from_stdin = |path: &Path| path.as_os_str() == STDIN;
    if from_stdin(&args.file) && args.rays.as_deref().is_some_and(from_stdin) {
        complain(look, &Complaint::new("two-inputs"));
        return Status::Failure;
    }
    if let Err(complaint) = args.memory.admit(&args.file, 1) {
        complain(look, &complaint);
        return Status::Failure;
    }
    // An object can be asked about without a render record.
    let needs = match args.object {
        Some(_) => Needs::Nothing,
        None => Needs::Render,
    };
    let mut loaded = match load_for(needs, &args.file, look) {
        Ok(loaded) => loaded,
        Err(status) => return status,
    };
    answer(args, &mut loaded, look).unwrap_or_else(|error| refuse(&loaded, error, look))
}

fn answer(args: &Args, loaded: &mut Analysis, look: LookChoice) -> Result<Status, Error> {
    let scene = &mut loaded.scene;
    if let Some(id) = args.object {
        scene.render = Some(alone(scene, id)?);
    }
    let scene = &loaded.scene;
    if let (Some(PointArg(point)), Some(render)) = (args.point, scene.render) {
        let found = members(scene, render.root, point)?;
        let shown = render
            .clip
            .is_none_or(|(min, max)| (0..3).all(|i| min[i] <= point[i] && point[i] <= max[i]));
        let answer = PointAnswer::new(point, found, shown);
        return Ok(print(look, Status::Clean, |out| {
            answer::write(out, &answer)
        }));
    }
    if let Some(path) = &args.rays {
        let mut input = open(path)?;
        let tracer = tracer(args, loaded, &loaded.scene)?;
        let bad = |e: BadRay| complain(look, &e.complaint(path));
        let status = match args.precision {
            Numbers::F32 => rays::stream::<f32>(&tracer, &mut input, bad, look),
            Numbers::F64 => rays::stream::<f64>(&tracer, &mut input, bad, look),
            Numbers::Dd => rays::stream::<Dd>(&tracer, &mut input, bad, look),
        };
        check(args, loaded, &tracer)?;
        return Ok(status);
    }
    if let Some(PixelArg(pixel)) = args.pixel {
        let answer = pixel_answer(args, loaded, pixel, look)?;
        return Ok(print(look, Status::Clean, |out| {
            answer::write(out, &answer)
        }));
    }
    let Some(RayArg(ray)) = args.ray else {
        return Err(Error::Request(Complaint::new("no-question")));
    };
    let tracer = tracer(args, loaded, &loaded.scene)?;
    let answer = ray_answer(&tracer, &ray, args.precision)?;
    check(args, loaded, &tracer)?;
    Ok(print(look, Status::Clean, |out| {
        answer::write(out, &answer)
    }))
}

fn ray_answer(tracer: &Tracer, ray: &Ray, numbers: Numbers) -> Result<RayAnswer, Error> {
    let answer = match numbers {
        Numbers::F32 => RayAnswer::new::<f32>(tracer, &mut tracer.walker(), ray),
        Numbers::F64 => RayAnswer::new::<f64>(tracer, &mut tracer.walker(), ray),
        Numbers::Dd => RayAnswer::new::<Dd>(tracer, &mut tracer.walker(), ray),
    };
    answer.map_err(Error::Request)
}

/// Opens a file of rays; `-` is standard input.
fn open(path: &Path) -> Result<Input, Error> {
    let input: Box<dyn Read> = if path.as_os_str() == STDIN {
        Box::new(io::stdin().lock())
    } else {
        let file = File::open(path).map_err(|e| Error::Request(unreadable(path, (&e).into())))?;
        Box::new(file)
    };
    Ok(Input::with_capacity(rays::BUFFER, input))
}

/// A render record that shows the object `id` alone, without a box and with the scene's background.
fn alone(scene: &Scene, id: u32) -> Result<Render, Error> {
    let found = scene.entities.iter().find(|e| e.id == id);
    match found {
        Some(entity) => match entity.node() {
            Some(root) => Ok(Render {
                root,
                root_id: id,
                background: scene.render.map_or([0.0; 3], |r| r.background),
                clip: None,
                span: entity.span,
            }),
            None => {
                let kind = entity.kind.unwrap_or(Kind::Undefined).name();
                Err(Error::Request(
                    Complaint::new("not-an-object")
                        .with("id", id.to_string())
                        .with("kind", Value::Term(kind)),
                ))
            }
        },
        None => Err(unknown(scene, id)),
    }
}

/// The most objects that are listed in the complaint that no object has the ID.
const NAMED: usize = 20;

/// The complaint that no object has this ID. It proposes the object whose ID differs in one character, the nearest
/// number of several; if there is none, it lists the objects.
fn unknown(scene: &Scene, id: u32) -> Error {
    let written = id.to_string();
    let objects = scene
        .entities
        .iter()
        .filter(|e| e.kind == Some(Kind::Object));
    let mut objects: Vec<u32> = objects.map(|e| e.id).collect();
    objects.sort_unstable();
    let near = objects
        .iter()
        .filter(|n| strsim::osa_distance(&written, &n.to_string()) <= 1);
    let near = near.min_by_key(|n| (n.abs_diff(id), **n));
    let mut named: Vec<String> = objects.iter().take(NAMED).map(u32::to_string).collect();
    if objects.len() > NAMED {
        named.push("…".to_owned());
    }
    let complaint = match near {
        Some(near) => Complaint::new("no-such-object-near").with("near", near.to_string()),
        None if named.is_empty() => Complaint::new("no-such-object"),
        None => Complaint::new("no-such-object-of").with("objects", named.join(", ")),
    };
    Error::Request(complaint.with("id", id.to_string()))
}

/// Refuses to answer if a ray has needed more memory than allowed.
fn check(args: &Args, loaded: &Analysis, tracer: &Tracer) -> Result<(), Error> {
    (args.memory.check(tracer)).map_err(|e| Error::at(render_span(loaded), e))
}

fn render_span(loaded: &Analysis) -> Span {
    loaded.scene.render.map_or(Span::default(), |r| r.span)
}

/// The tracer of a scene, with its textures loaded and the memory of its rays limited.
fn tracer(args: &Args, loaded: &Analysis, scene: &Scene) -> Result<Tracer, Error> {
    let folder = loaded.source.folder().unwrap_or(Path::new("."));
    let images = Images::load(scene, folder)?;
    let mut tracer = Tracer::with_images(scene, &images)?;
    let threads = rayon::current_num_threads();
    (args.memory.confine(&mut tracer, 0.0, threads))
        .map_err(|e| Error::at(render_span(loaded), e))?;
    Ok(tracer)
}

fn pixel_answer(
    args: &Args,
    loaded: &Analysis,
    pixel: [u32; 2],
    look: LookChoice,
) -> Result<PixelAnswer, Error> {
    let Size { width, height } = args.size;
    let [x, y] = pixel;
    if x >= width || y >= height {
        return Err(Error::Request(
            Complaint::new("not-a-pixel")
                .with("x", x.to_string())
                .with("y", y.to_string())
                .with("width", width.to_string())
                .with("height", height.to_string()),
        ));
    }
    let scene = args.camera.staged(&loaded.scene, args.size)?;
    let camera = one_camera(&scene, look)?;
    let tracer = tracer(args, loaded, &scene)?;
    let settings = Settings {
        width,
        height,
        crop: Some(Crop {
            x,
            y,
            width: 1,
            height: 1,
        }),
        numbers: args.precision,
        ..Settings::default()
    };
    let film = tracer.render(&camera, &settings, || ())?.film;
    let centre = [x, y].map(|i| f64::from(i) + 0.5);
    let ray = View::new(&camera, width, height).and_then(|v| v.ray(centre[0], centre[1]));
    let ray = ray.ok_or_else(|| {
        Error::Request(
            Complaint::new("no-ray-in-pixel")
                .with("x", x.to_string())
                .with("y", y.to_string()),
        )
    })?;
    let answer = ray_answer(&tracer, &ray, args.precision)?;
    check(args, loaded, &tracer)?;
    Ok(PixelAnswer::new(pixel, film.pixel(0, 0), answer))
}
