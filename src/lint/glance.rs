//! A small picture, for rules about what a picture shows.

use crate::scene::{Camera, Scene, Texture};
use crate::trace::pixels::Pixels;
use crate::trace::{Images, Settings, Tracer};
use std::borrow::Cow;
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

/// The scene with a colour in the place of its image textures, for questions that no picture's colours matter to.
pub(super) fn without_images(scene: &Scene) -> Cow<'_, Scene> {
    let is_image = |t: &Option<Texture>| matches!(t, Some(Texture::Image { .. }));
    if !scene.paints.iter().any(|p| is_image(&p.texture)) {
        return Cow::Borrowed(scene);
    }
    let mut plain = scene.clone();
    let images = plain.paints.iter_mut().filter(|p| is_image(&p.texture));
    images.for_each(|p| p.texture = Some(Texture::Colour([0.5; 3])));
    Cow::Owned(plain)
}

/// Shows the pixels of a small picture to `look`, until that breaks off: each one once, and however many those are, they are
/// spread over the picture. `None` where the picture cannot be taken or takes too long.
pub(super) fn glance(
    scene: &Scene,
    images: &Images,
    camera: &Camera,
    depth: u32,
    mut look: impl FnMut(&mut dyn Pixels, u32, u32) -> ControlFlow<()>,
) -> Option<()> {
    let tracer = Tracer::with_images(scene, images).ok()?;
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
