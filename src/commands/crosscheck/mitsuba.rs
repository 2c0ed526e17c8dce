//! Geometry, beside Mitsuba's.

use std::io::{self, Write};

use super::{Args, Compared, Outcome, Pictures};
use super::{cameras, each_camera, failed, images, made_folder, program, stem};
use crate::analysis::Analysis;
use crate::diagnostics::Error;
use crate::study::geometry::{self, Comparison, Differences, Shared, our_normals, their_normals};
use crate::study::mitsuba::{PROGRAM, render};
use crate::study::program::ProgramError;
use crate::syntax::Captions;
use crate::trace::Tracer;
use crate::translate::about_camera;
use crate::translate::mitsuba::{Integrator, Options, is_exact, square_size, write};

const HOW: &str = "with `pip install mitsuba numpy`, and name that Python with --program";

/// So many pairs of surfaces in one place are named.
const NAMED: usize = 3;

/// Looks, compares and writes what is seen.
pub fn compare(args: &Args, loaded: &Analysis) -> Result<Vec<Compared<Comparison>>, Error> {
    let scene = &loaded.scene;
    let size = (args.size.width, args.size.height);
    let tracer = Tracer::with_images(scene, &images(loaded)?)?;
    let options = Options {
        size,
        depth: args.depth,
        tolerance: args.tolerance,
        memory: None,
        integrator: Integrator::Aov,
        stem: stem(args),
        captions: Captions::of(&loaded.document, &loaded.source.text),
    };
    let cameras = cameras(scene, args.size);
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
    let made = write(scene, &tracer, &options)?;
    let folder = made_folder(args)?;
    let program = program(args, PROGRAM);
    let fail = |e| failed(e, ("Mitsuba", HOW), &program, &folder);
    let suffixes = made.documents.iter().map(|d| d.0);
    each_camera(args, &folder, suffixes, |i, suffix| {
        let name = format!("{}{suffix}", stem(args));
        let theirs = render(&program, &made, i, &folder, &name, 0).map_err(fail)?;
        let ours = geometry::seen(&tracer, &cameras[i], size);
        let comparison = geometry::compare(&tracer, &cameras[i], &ours, &theirs, size, &made);
        let comparison = comparison.ok_or_else(|| {
            fail(ProgramError::Unexpected(
                "what it has written is of another size",
            ))
        })?;
        let pictures = Pictures {
            ours: our_normals(&ours),
            theirs: their_normals(&theirs),
            difference: comparison.picture(),
        };
        Ok((pictures, comparison))
    })
}

impl Outcome for Comparison {
    fn share(&self) -> f64 {
        self.share_wrong
    }

    fn tells(&self) -> bool {
        Comparison::tells(self)
    }

    fn print(&self, _: &Args, out: &mut dyn Write) -> io::Result<()> {
        writeln!(
            out,
            "  off silhouettes    {} of {} pixels show another shape, place or normal ({:.3} %)",
            self.wrong,
            self.pixels - self.silhouettes - self.cut_off - self.undecided - self.in_one_place,
            100.0 * self.share_wrong,
        )?;
        writeln!(
            out,
            "  silhouettes        {} pixels at the edges of shapes and faces, which are not compared",
            self.silhouettes,
        )?;
        if self.cut_off > 0 {
            writeln!(
                out,
                "  left out           {} pixels where parts without end are cut off in the translation",
                self.cut_off,
            )?;
        }
        if self.undecided > 0 {
            writeln!(
                out,
                "  left out           {} pixels where single precision, which Mitsuba computes in, takes \
                 something else for what is seen",
                self.undecided,
            )?;
        }
        if self.in_one_place > 0 {
            let pair = |s: &Shared| format!("{} and {}", s.shapes[0], s.shapes[1]);
            let named: Vec<String> = self.shared.iter().take(NAMED).map(pair).collect();
            let more = match self.shared.len() > NAMED {
                true => ", …",
                false => "",
            };
            writeln!(
                out,
                "  left out           {} pixels where the surfaces of two shapes are in one place, and which of \
                 them is seen is arbitrary: {}{more}",
                self.in_one_place,
                named.join(", "),
            )?;
        }
        for (kind, d) in [("exact shapes", &self.exact), ("meshes", &self.meshes)] {
            let Differences {
                pixels,
                distance,
                distance_by_allowed,
                angle,
            } = d;
            writeln!(
                out,
                "  {kind:<18} {pixels} pixels; positions differ by at most {distance:.2e}, \
                 {distance_by_allowed:.3} of what is allowed; normals by at most {angle:.3}°",
            )?;
        }
        Ok(())
    }
}
