//! Pixels that an edge goes through: of a shape, a shadow, a pattern, or of any of these seen in
//! glass. What a single sample there shows is up to rounding.

use crate::scene::Camera;
use crate::trace::{Picture, Settings, Tracer, Unsupported};

/// How far from a sample an edge counts, in pixels: far more than programs differ in where they send
/// their rays, and too little to make many pixels uncertain.
const NEAR: f64 = 0.02;

/// A picture and what is uncertain in it.
pub struct Studied {
    pub picture: Picture,
    /// For each pixel, row by row: an edge goes through its middle.
    pub edges: Vec<bool>,
    /// For each pixel: some of the light it shows, or shows a hair beside it, was totally reflected.
    pub total_reflection: Vec<bool>,
}

/// Takes a picture and four more, moved by a hair; an edge is where they differ by more than `bar` in
/// a channel, in linear light.
///
/// # Errors
///
/// As [`Tracer::render`].
pub fn study(
    tracer: &Tracer,
    camera: &Camera,
    settings: &Settings,
    bar: f64,
) -> Result<Studied, Unsupported> {
    let picture = tracer.render(camera, settings, || ())?;
    let mut edges = vec![false; picture.film.pixels.len()];
    let mut total_reflection = picture.total_reflection.clone();
    for (dx, dy) in [(NEAR, NEAR), (-NEAR, NEAR), (NEAR, -NEAR), (-NEAR, -NEAR)] {
        let shift = [dx, dy];
        let settings = Settings {
            shift,
            ..settings.clone()
        };
        let moved = tracer.render(camera, &settings, || ())?;
        for (i, (a, b)) in picture
            .film
            .pixels
            .iter()
            .zip(&moved.film.pixels)
            .enumerate()
        {
            edges[i] |= super::compare::distance(*a, *b) > bar;
            total_reflection[i] |= moved.total_reflection[i];
        }
    }
    Ok(Studied {
        picture,
        edges,
        total_reflection,
    })
}
