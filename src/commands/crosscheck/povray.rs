//! Comparison of pictures with those of POV-Ray.

use super::{Args, Compared, Outcome, Pictures};
use super::{Asked, Folder, each_camera, images, program, stem};
use crate::analysis::Analysis;
use crate::commands::{LookChoice, atomic_file, terminal};
use crate::diagnostics::{Complaint, Error, Language, Value};
use crate::scene::Camera;
use crate::solids::staging::Viewpoint;
use crate::study::compare::{Comparison, LEGEND};
use crate::study::povray::{PROGRAM, render};
use crate::study::whereabouts::Whereabouts;
use crate::syntax::Captions;
use crate::trace::film::srgb8;
use crate::trace::{Film, Settings, Tracer};
use crate::translate::plain::plain;
use crate::translate::pov::{self, pictures};

const ASKED: Asked = Asked {
    name: "POV-Ray",
    how: "crosscheck-how-povray",
    late: "crosscheck-late-povray",
};

/// Has zpg and POV-Ray draw the picture of each camera, compares the two, and writes them.
pub(super) fn compare(
    args: &Args,
    loaded: &Analysis,
    look: LookChoice,
) -> Result<Vec<Compared<Comparison>>, Error> {
    let staged = args.camera.staged(&loaded.scene, args.size)?;
    let scene = &*staged;
    let size = (args.size.width, args.size.height);
    let bar = args.max_diff / 255.0;
    let name = plain(&stem(args));
    let images = images(loaded)?;
    let (pictures, copies) = pictures::Pictures::beside(&images, &name);
    let options = pov::Options {
        size,
        viewpoint: Viewpoint::Scene,
        depth: args.depth,
        pictures,
        stereo: pov::Stereo::TwoFiles,
        captions: Captions::of(&loaded.document, &loaded.source.text),
        ..pov::Options::default()
    };
    let translation = pov::write(scene, loaded.bounds(), &options)?;
    let tracer = Tracer::with_images(scene, &images)?;
    let settings = Settings {
        width: size.0,
        height: size.1,
        depth: args.depth,
        cutoff: 0.0,
        ..Settings::default()
    };
    let folder = Folder::made(args, loaded, copies.iter().map(|(name, _)| name.as_str()))?;
    for (name, png) in &copies {
        atomic_file::write(&folder.path.join(name), |out| out.write_all(png))?;
    }
    let program = program(args, PROGRAM);
    let cameras: Vec<Camera> = scene.chosen_cameras().copied().collect();
    let suffixes = translation.files.iter().map(|f| f.suffix);
    each_camera(
        args,
        look.language(),
        &folder.path,
        suffixes,
        |i, suffix| {
            let name = format!("{name}{suffix}");
            let theirs = render(&program, &translation, i, size, &folder.path, &name)
                .map_err(|e| ASKED.failed(e, &program, &folder))?;
            let most = (1.0 / translation.light_scale) as f32;
            let progress = terminal::progress_bar(size.1.into(), look);
            let view = (&tracer, &cameras[i], &settings);
            let (comparison, ours) = Comparison::of(view, &theirs, most, bar, || progress.inc(1))?;
            progress.finish_and_clear();
            let pictures = Pictures {
                ours: srgb(&ours),
                theirs: srgb(&theirs),
                difference: comparison.picture(),
            };
            Ok((pictures, comparison))
        },
    )
}

fn srgb(film: &Film) -> Vec<u8> {
    film.pixels.iter().flatten().map(|&x| srgb8(x)).collect()
}

impl Outcome for Comparison {
    fn share(&self) -> f64 {
        self.differing.share_off_silhouettes
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

    fn lines(&self, args: &Args, language: Language) -> Vec<(&'static str, Complaint)> {
        let number = |text: String| language.decimal(text);
        let pixels =
            |message, n: usize| Complaint::new(message).with("pixels", Value::Count(n as u64));
        let differing = &self.differing;
        let percent = format!("{:.3}", 100.0 * differing.share_off_silhouettes);
        let off = pixels("crosscheck-povray-off", differing.off_silhouettes)
            .with("most", number(args.max_diff.to_string()))
            .with("percent", number(percent))
            .with(
                "largest",
                number(format!("{:.3}", 255.0 * self.difference.largest)),
            )
            .with(
                "mean",
                number(format!("{:.3}", 255.0 * self.difference.mean)),
            );
        vec![
            ("crosscheck-off-edges", off),
            (
                "crosscheck-on-silhouettes",
                pixels("crosscheck-povray-on", differing.on_silhouettes),
            ),
            (
                "crosscheck-on-other-edges",
                pixels("crosscheck-povray-edges", differing.on_other_edges),
            ),
            (
                "crosscheck-total-reflection",
                pixels("crosscheck-povray-total", self.total_reflection),
            ),
            (
                "crosscheck-flip",
                Complaint::new("crosscheck-povray-flip")
                    .with("flip", number(format!("{:.4}", self.flip))),
            ),
        ]
    }
}
