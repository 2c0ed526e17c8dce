//! Light above white, which an image file cannot hold.

use std::borrow::Cow;

use super::model::stretch::power_of_two_about;
use super::tree::Document;
use crate::diagnostics::{Complaint, Value};
use crate::scene::Optics;
use crate::solids::staging::staged;
use crate::trace::{Settings, Tracer};
use crate::translate::number;
use crate::translate::target::{self, Prepared};
use crate::translate::{Fidelity, Report};

/// The smallest factor by which lights are dimmed. A file with 16 bits keeps eight of them then.
const DIMMEST: f64 = 1.0 / 256.0;

/// The power of two by which all light has to be multiplied so that no value of a picture is above white; at least
/// `DIMMEST`. It follows from the recursion of the light: one more bounce on a surface shows at most kd·(all light) +
/// (ks + kt)·(what was seen before).
pub fn light_scale(document: &Document, depth: u32) -> f64 {
    let default = Optics::default();
    let mut brightest = 0.0f64;
    for (c, background) in document.background.into_iter().enumerate() {
        let lights = document.lights.iter().map(|l| l.intensity * l.colour[c]);
        let light = lights.fold(document.ambient[c], |sum, light| sum + light);
        let mut seen = background;
        for _ in 0..=depth {
            let bounce = |o: &Optics| o.kd[c] * light + (o.ks[c] + o.kt[c]) * seen;
            let optics = document.tree.textures.iter().map(|t| &t.optics);
            let all = optics.chain([&default]).map(bounce);
            seen = all.fold(background, f64::max);
        }
        brightest = brightest.max(seen);
    }
    match brightest > 1.0 {
        true => power_of_two_about(1.0 / brightest).max(DIMMEST),
        false => 1.0,
    }
}

/// Width and height, in pixels, of the small picture that shows whether there is light above white.
const PIXELS: (u32, u32) = (80, 60);

/// Reports whether the picture has light above white. `dimmed` is the [light scale](super::Translation::light_scale)
/// with which surely no pixel is brighter than white.
pub fn state(report: &mut Report, scene: &Prepared, options: &target::Options, dimmed: f64) {
    if dimmed >= 1.0 {
        return;
    }
    let (fidelity, note) = match share_above_white(scene, options) {
        Some(0.0) => (
            Fidelity::Exact,
            Complaint::new("fidelity-no-light-above-white"),
        ),
        share => {
            let percent = share.map_or("?".to_owned(), |share| match 100.0 * share {
                few if few < 1.0 => "< 1".to_owned(),
                percent => format!("{percent:.0}"),
            });
            let bound = Complaint::new("fidelity-light-above-white").with("percent", percent);
            let note = Complaint::new("fidelity-light-scale")
                .with("scale", number(dimmed))
                .with("times", Value::Decimal(number(dimmed)));
            (Fidelity::Approximate(bound), note)
        }
    };
    report.state("light above white", fidelity, note);
}

/// The share of the pixels of a small picture that are brighter than white; `None` where none can be drawn.
fn share_above_white(scene: &Prepared, options: &target::Options) -> Option<f64> {
    let aspect = f64::from(options.size.0) / f64::from(options.size.1);
    let drawn = staged(scene.scene(), options.viewpoint, aspect);
    let own = match &drawn {
        Cow::Borrowed(_) => None,
        Cow::Owned(drawn) => Some(Tracer::with_images(drawn, &scene.images().ok()?).ok()?),
    };
    let tracer = match &own {
        Some(own) => own,
        None => scene.tracer().ok()?,
    };
    let settings = Settings {
        width: PIXELS.0,
        height: PIXELS.1,
        depth: options.depth,
        ..Settings::default()
    };
    let (mut above, mut all) = (0, 0);
    for camera in drawn.chosen_cameras() {
        let picture = tracer.render(camera, &settings, || ()).ok()?;
        let pixels = picture.film.pixels.iter();
        above += pixels.filter(|p| p.iter().any(|&c| c > 1.0)).count();
        all += picture.film.pixels.len();
    }
    (all > 0).then(|| above as f64 / all as f64)
}
