//! A small picture, for rules about what a picture shows.

use crate::scene::{Camera, Scene};
use crate::trace::pixels::Pixels;
use crate::trace::{Settings, Tracer};
use std::ops::ControlFlow;

/// The size of the picture, in pixels: a few milliseconds in all.
pub(super) const SIZE: [u32; 2] = [72, 54];
/// Step from one pixel that is looked at to the next, in rows: it has no factor in common with the number of pixels, so
/// that all come up, and is near their golden section, so that the first ones are spread over the picture.
const STRIDE: u32 = 2401;
/// Larger scenes take longer than a few milliseconds to be made ready.
pub(super) const MAX_NODES: usize = 1000;
/// Tests of shapes in a picture, each as dear as 80 of boxes: nothing is said of what takes longer to look at.
const MAX_TESTS: u64 = 18_000;

/// Shows the pixels of a small picture to `look`, until that breaks off: each one once, and however many those are, they are
/// spread over the picture. `None` where the picture cannot be taken or takes too long.
pub(super) fn glance(
    scene: &Scene,
    camera: &Camera,
    depth: u32,
    mut look: impl FnMut(&mut dyn Pixels, u32, u32) -> ControlFlow<()>,
) -> Option<()> {
    let tracer = Tracer::new(scene).ok()?;
    let settings = Settings {
        width: SIZE[0],
        height: SIZE[1],
        depth,
        ..Settings::default()
    };
    let looked = tracer.pixels(camera, &settings, None, |pixels| {
        let count = SIZE[0] * SIZE[1];
        for at in (0..count).map(|i| i * STRIDE % count) {
            let tests = pixels.counts().intersections;
            if tests.boxes / 80 + tests.shape > MAX_TESTS {
                return None;
            }
            if look(pixels, at % SIZE[0], at / SIZE[0]).is_break() {
                break;
            }
        }
        Some(())
    });
    looked.ok()?
}
