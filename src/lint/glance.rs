//! A small picture that is traced for rules about what a scene's picture shows.

use crate::scene::{Camera, Scene, Texture};
use crate::trace::pixels::Pixels;
use crate::trace::{Images, Settings, Tracer};
use std::borrow::Cow;
use std::ops::ControlFlow;

/// The size of the picture, in pixels: a few milliseconds in all.
pub(super) const SIZE: [u32; 2] = [72, 54];
/// Step from one examined pixel to the next, counted row by row. The step has no factor in common with the number of
/// pixels, so that all come up, and is near their golden section, so that the first ones are spread over the picture.
const STRIDE: u32 = 2401;
/// Most nodes of a scene: larger scenes take more than a few milliseconds to prepare.
pub(super) const MAX_NODES: usize = 1000;
/// Most intersection tests of shapes for a picture; 80 tests of boxes count as one. A picture that takes more is given
/// up.
const MAX_TESTS: u64 = 18_000;

/// The scene with a colour in place of its image textures, for questions to which the colours of the picture do not
/// matter.
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

/// Shows the pixels of a small picture to `look`, each one once, until `look` breaks off. However many those are, they
/// are spread over the picture. `None` if the picture cannot be taken or takes too long.
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
