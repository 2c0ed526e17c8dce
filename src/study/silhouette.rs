//! Pixels that an edge goes through: of a shape, a shadow, a pattern, or of any of these seen in
//! glass. What a single sample there shows is up to rounding.

use super::compare::distance;
use crate::diagnostics::Error;
use crate::scene::Camera;
use crate::trace::{Picture, Settings, Tracer};

/// How far from a sample an edge counts, in pixels: far more than programs differ in where they send
/// their rays, and too little to make many pixels uncertain.
const NEAR: f64 = 0.02;

/// A picture and what is uncertain in it.
pub struct Studied {
    pub picture: Picture,
    /// For each pixel, row by row: it was in question, and an edge goes through its middle.
    pub edges: Vec<bool>,
    /// For each pixel: some of the light it shows was totally reflected; or of what it shows a hair
    /// beside it, if it was in question.
    pub total_reflection: Vec<bool>,
}

/// Takes a picture, and of the pixels that are in question four more, moved by a hair; an edge is where
/// they differ by more than `bar` in a channel, in linear light. `in_question` is asked about the
/// number and the colour of each pixel, `progress` is told of every row of the whole picture.
///
/// # Errors
///
/// As [`Tracer::render`].
pub fn study(
    tracer: &Tracer,
    camera: &Camera,
    settings: &Settings,
    bar: f64,
    in_question: impl Fn(usize, [f32; 3]) -> bool,
    progress: impl Fn() + Sync,
) -> Result<Studied, Error> {
    let picture = tracer.render(camera, settings, progress)?;
    let pixels = &picture.film.pixels;
    let wanted = pixels.iter().enumerate().map(|(i, p)| in_question(i, *p));
    let settings = Settings {
        wanted: Some(wanted.collect()),
        ..settings.clone()
    };
    let mut edges = vec![false; pixels.len()];
    let mut total_reflection = picture.total_reflection.clone();
    for shift in [[NEAR, NEAR], [-NEAR, NEAR], [NEAR, -NEAR], [-NEAR, -NEAR]] {
        let settings = Settings {
            shift,
            ..settings.clone()
        };
        let moved = tracer.render(camera, &settings, || ())?;
        let wanted = settings.wanted.iter().flat_map(|w| w.iter()).enumerate();
        for (i, _) in wanted.filter(|(_, wanted)| **wanted) {
            edges[i] |= distance(pixels[i], moved.film.pixels[i]) > bar;
            total_reflection[i] |= moved.total_reflection[i];
        }
    }
    Ok(Studied {
        picture,
        edges,
        total_reflection,
    })
}
