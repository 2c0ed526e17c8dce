//! Comparison of geometry with Mitsuba: which shape each pixel shows, where, and with which normal.

use super::{Args, Compared, Outcome, Pictures};
use super::{Asked, Folder, each_camera, images, program, stem};
use crate::analysis::Analysis;
use crate::commands::LookChoice;
use crate::diagnostics::{Complaint, Error, Language, Value};
use crate::scene::Camera;
use crate::solids::staging::Viewpoint;
use crate::study::geometry::{self, Comparison, LEGEND, Shared, our_normals, their_normals};
use crate::study::mitsuba::{PROGRAM, render};
use crate::study::program::ProgramError;
use crate::study::whereabouts::Whereabouts;
use crate::syntax::Captions;
use crate::trace::Tracer;
use crate::translate::about_camera;
use crate::translate::mitsuba::{Integrator, Options, is_exact, square_size, write};

const ASKED: Asked = Asked {
    name: "Mitsuba",
    how: "crosscheck-how-mitsuba",
    late: "crosscheck-late-mitsuba",
};

/// The most pairs of surfaces in one place that are named.
const NAMED: usize = 3;

/// Has zpg and Mitsuba look through each camera, compares what the two see, and writes it as pictures.
pub(super) fn compare(
    args: &Args,
    loaded: &Analysis,
    look: LookChoice,
) -> Result<Vec<Compared<Comparison>>, Error> {
    let staged = args.camera.staged(&loaded.scene, args.size)?;
    let scene = &*staged;
    let size = (args.size.width, args.size.height);
    let tracer = Tracer::with_images(scene, &images(loaded)?)?;
    let options = Options {
        size,
        viewpoint: Viewpoint::Scene,
        depth: args.depth,
        tolerance: args.tolerance,
        memory: None,
        integrator: Integrator::Aov,
        stem: stem(args),
        captions: Captions::of(&loaded.document, &loaded.source.text),
    };
    let cameras: Vec<Camera> = scene.chosen_cameras().copied().collect();
    if let Some(camera) = cameras.iter().find(|c| !is_exact(c, size)) {
        let text = |(width, height): (u32, u32)| format!("{width}x{height}");
        let squares = square_size(&cameras, size);
        let message = match squares {
            Some(_) => "camera-of-no-squares",
            None => "camera-of-never-squares",
        };
        let why = about_camera(camera, message)
            .with("size", text(size))
            .with("other", squares.map_or(String::new(), text));
        return Err(Error::scene(why));
    }
    let made = write(scene, loaded.bounds(), &tracer, &options)?;
    let folder = Folder::made(
        args,
        loaded,
        made.meshes.iter().map(|(name, _)| name.as_str()),
    )?;
    let program = program(args, PROGRAM);
    let fail = |e| ASKED.failed(e, &program, &folder);
    let suffixes = made.documents.iter().map(|d| d.0);
    each_camera(
        args,
        look.language(),
        &folder.path,
        suffixes,
        |i, suffix| {
            let name = format!("{}{suffix}", stem(args));
            let theirs = render(&program, &made, i, &folder.path, &name, 0).map_err(fail)?;
            let ours = geometry::seen(&tracer, &cameras[i], size);
            let comparison = geometry::compare(&tracer, &cameras[i], &ours, &theirs, size, &made);
            let comparison = comparison.ok_or_else(|| {
                fail(ProgramError::Unexpected(
                    "what it has written is of another size",
                ))
            })?;
            let pictures = Pictures {
                ours: our_normals(&ours),
                theirs: their_normals(&ours, &theirs),
                difference: comparison.picture(),
            };
            Ok((pictures, comparison))
        },
    )
}

impl Outcome for Comparison {
    fn share(&self) -> f64 {
        self.share_wrong
    }

    fn pixels(&self) -> [usize; 2] {
        [self.pixels, self.left_out()]
    }

    fn legend() -> &'static [([u8; 3], &'static str)] {
        &LEGEND
    }

    fn mostly(&self) -> Option<Whereabouts> {
        self.mostly
    }

    fn tells(&self) -> bool {
        Comparison::tells(self)
    }

    fn lines(&self, _: &Args, language: Language) -> Vec<(&'static str, Complaint)> {
        let number = |text: String| language.decimal(text);
        let pixels =
            |message, n: usize| Complaint::new(message).with("pixels", Value::Count(n as u64));
        let compared = self.pixels - self.left_out();
        let percent = number(format!("{:.3}", 100.0 * self.share_wrong));
        let off = pixels("crosscheck-mitsuba-off", compared)
            .with("wrong", self.wrong.to_string())
            .with("percent", percent);
        let silhouettes = pixels("crosscheck-mitsuba-silhouettes", self.silhouettes);
        let mut lines = vec![
            ("crosscheck-off-silhouettes", off),
            ("crosscheck-silhouettes", silhouettes),
        ];
        let mut left_out = |message, n: usize, pairs: String| {
            if n > 0 {
                let line = pixels(message, n).with("pairs", pairs);
                lines.push(("crosscheck-left-out", line));
            }
        };
        let pair = |s: &Shared| {
            let [first, last] = s.shapes.map(|id| Value::from(id.to_string()));
            language.say("list-and", &[("first", first), ("last", last)])
        };
        let mut pairs: Vec<String> = self.shared.iter().take(NAMED).map(pair).collect();
        if self.shared.len() > NAMED {
            pairs.push("…".to_owned());
        }
        left_out("crosscheck-mitsuba-cut", self.cut_off, String::new());
        left_out(
            "crosscheck-mitsuba-undecided",
            self.undecided,
            String::new(),
        );
        left_out(
            "crosscheck-mitsuba-shared",
            self.in_one_place,
            pairs.join(", "),
        );
        for (kind, d) in [
            ("crosscheck-exact", &self.exact),
            ("crosscheck-meshes", &self.meshes),
        ] {
            let line = pixels("crosscheck-mitsuba-differences", d.pixels)
                .with("distance", number(format!("{:.2e}", d.distance)))
                .with("share", number(format!("{:.3}", d.distance_by_allowed)))
                .with("angle", number(format!("{:.3}", d.angle)));
            lines.push((kind, line));
        }
        lines
    }
}
