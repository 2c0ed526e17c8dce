//! Notes on what is wrong with a picture, a line each on standard error.

use super::Args;
use crate::analysis::Analysis;
use crate::commands::LookChoice;
use crate::commands::terminal::note;
use crate::diagnostics::{Complaint, Value};
use crate::geometry::Aabb;
use crate::scene::{Camera, Scene, View};
use crate::solids::bounds::node_bounds;
use crate::solids::staging::{is_dark, seen_box};
use crate::syntax::quote;
use crate::trace::camera;
use crate::trace::film::{MAX_BRIGHT_PERCENT, is_above_white};
use crate::trace::{Film, Picture, Settings, Tracer};

/// The most pixels across, and the most pixels down, that are asked what they see.
const PLACES: u32 = 32;

const NOTHING_IN_VIEW: &str = "note-nothing-in-view";

/// Notes that the scene has no camera or no light, and why a picture shows nothing.
pub(super) fn say(
    args: &Args,
    tracer: &Tracer,
    (scene, cameras): (&Scene, &[Camera]),
    settings: &Settings,
    pictures: &[Picture],
    look: LookChoice,
) {
    if look.quiet {
        return;
    }
    if scene.view == View::Automatic && !args.picture.camera.is_given() {
        note(look, &Complaint::new("note-no-camera"));
    }
    if is_dark(scene) {
        note(look, &Complaint::new("note-no-light"));
    }
    for (camera, picture) in cameras.iter().zip(pictures) {
        let is_of_all = args.picture.camera.is_side() || scene.view == View::Automatic;
        let found = fault(tracer, (scene, camera), settings, picture);
        let found = found.map(|message| match message {
            NOTHING_IN_VIEW if has_nothing(scene, is_of_all && settings.crop.is_none()) => {
                "note-nothing-to-see"
            }
            message => message,
        });
        if let Some(message) = found {
            note(look, &Complaint::new(message));
        }
    }
}

/// Notes records that are hardly meant, before the records are forgotten: objects that are not part of what is drawn,
/// and commas that may be decimal ones. Says nothing for a band.
pub(super) fn say_of_records(args: &Args, loaded: &Analysis, look: LookChoice) {
    if look.quiet || args.tile.is_some() {
        return;
    }
    let commas = loaded.commas_in_doubt();
    if let Some(&first) = commas.first() {
        let (text, line) = (
            &loaded.source.text[first.range()],
            loaded.source.position(first.start).line,
        );
        note(
            look,
            &Complaint::new("note-comma")
                .with("text", quote(text))
                .with("number", quote(&text.replace(',', " ")))
                .with("line", line.to_string())
                .with("more", Value::Count(commas.len() as u64 - 1)),
        );
    }
    let count = loaded.undrawn();
    if count > 0 {
        note(
            look,
            &Complaint::new("note-undrawn").with("count", Value::Count(count as u64)),
        );
    }
}

/// Whether the scene of an empty picture is empty, too: the camera looks at the whole scene (`of_all`), or the scene
/// has nothing to be seen.
fn has_nothing(scene: &Scene, of_all: bool) -> bool {
    of_all || seen_box(scene, &node_bounds(scene)).is_empty()
}

/// The message that says why a picture shows nothing, or not what is meant; `None` if it shows something.
fn fault(
    tracer: &Tracer,
    (scene, camera): (&Scene, &Camera),
    settings: &Settings,
    picture: &Picture,
) -> Option<&'static str> {
    let view = camera::View::new(camera, settings.width, settings.height)?;
    let is_drawn = |(min, max)| Aabb::new(min, max).contains(camera.position);
    let is_drawn = scene.render.is_none_or(|r| r.clip.is_none_or(is_drawn));
    if view.is_pinhole() && is_drawn && tracer.holds(&mut tracer.walker::<f64>(), view.position()) {
        return Some("note-camera-inside");
    }
    let film = &picture.film;
    let [left, top] = settings.crop.map_or([0, 0], |crop| [crop.x, crop.y]);
    let [across, down] = [film.width, film.height].map(|side| side.div_ceil(PLACES).max(1));
    let places = (0..film.height).step_by(down as usize).flat_map(|y| {
        let columns = (0..film.width).step_by(across as usize);
        columns.map(move |x| (x, y))
    });
    let seen = tracer.pixels(camera, settings, None, |pixels| {
        let is_seen = |&(x, y): &(u32, u32)| pixels.seen(left + x, top + y).is_some();
        places.filter(is_seen).collect::<Vec<_>>()
    });
    let seen = seen.ok()?;
    let first = film.pixels.first()?;
    match seen.is_empty() {
        // An object that falls between these places still gives some pixel another colour than the background.
        true => film
            .pixels
            .iter()
            .all(|p| p == first)
            .then_some(NOTHING_IN_VIEW),
        false => {
            let is_black = |&(x, y): &(u32, u32)| film.pixel(x, y) == [0.0; 3];
            let all_black = seen.iter().all(is_black);
            all_black.then_some("note-nothing-lit")
        }
    }
}

/// Notes how much of the pictures is brighter than white, and how to mend that: by the record that gives out more light
/// than it gets, if there is one, or by another exposure.
pub(super) fn say_brightness(loaded: &Analysis, films: &[Film], exposure: f64, look: LookChoice) {
    let pixels = || films.iter().flat_map(|film| &film.pixels);
    let largest = |pixel: &[f32; 3]| pixel.iter().copied().fold(0.0, f32::max);
    let bright = pixels().filter(|&&pixel| is_above_white(pixel)).count();
    let share = 100.0 * bright as f64 / pixels().count().max(1) as f64;
    if share < MAX_BRIGHT_PERCENT {
        return;
    }
    let most = pixels().map(largest).fold(1.0, f32::max);
    let percent = format!("{share:.0}");
    if let Some(id) = loaded.glaring() {
        let complaint = Complaint::new("note-too-bright-by").with("percent", percent);
        note(look, &complaint.with("id", id.to_string()));
        return;
    }
    note(
        look,
        &Complaint::new("note-too-bright")
            .with("percent", percent)
            .with("exposure", rounded_down(exposure / f64::from(most))),
    );
}

/// A number above 0, rounded down to two digits.
fn rounded_down(x: f64) -> String {
    let digits = (1.0 - x.log10().floor()).max(0.0);
    let unit = 10f64.powf(-digits);
    // Without the small term, 0.29 would become 0.28.
    let whole = (x / unit + 1e-9).floor();
    format!("{:.*}", digits as usize, whole * unit)
}

#[cfg(test)]
mod tests {
    use super::rounded_down;

    #[test]
    fn numbers_are_rounded_down() {
        for (x, text) in [
            (1.0, "1.0"),
            (0.5, "0.50"),
            (0.29, "0.29"),
            (0.4599, "0.45"),
            (0.00123, "0.0012"),
            (0.999, "0.99"),
        ] {
            assert_eq!(rounded_down(x), text);
        }
    }
}
