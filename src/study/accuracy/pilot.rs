//! Predicts the time that a picture is going to take.

use std::sync::Arc;
use std::time::Instant;

use super::configurations::{Kernel, Settings};
use super::runner::Runner;
use super::sample_tiles::{Tile, chosen};
use crate::diagnostics::Error;
use crate::scene::{Camera, Scene};
use crate::trace::{self, Images};

/// The time that a picture is going to take on one thread, in seconds.
#[derive(Debug, Clone, Copy)]
pub struct Pilot {
    /// Seconds until the first pixel, without reading the scene.
    pub build: f64,
    /// Seconds for all pixels of the picture.
    pub pixels: f64,
}

/// The number of small tiles that are drawn between two looks at the clock.
const AT_ONCE: usize = 16;

/// Predicts the time of a picture from small tiles, spread evenly, that are drawn for about `seconds` seconds.
///
/// # Errors
///
/// As [`Tracer::render`](crate::trace::Tracer::render).
pub fn pilot(
    scene: Arc<Scene>,
    images: &Images,
    camera: Camera,
    settings: &trace::Settings,
    seconds: f64,
) -> Result<Pilot, Error> {
    let start = Instant::now();
    let size = [settings.width, settings.height];
    let mut runner = Runner::new(scene, images, camera, size)?;
    let build = start.elapsed().as_secs_f64();
    let settings_of_tiles = Settings {
        samples: settings.samples,
        tolerance: settings.tolerance,
        depth: settings.depth,
        cutoff: settings.cutoff,
        kernel: Kernel::Ours(settings.numbers),
        ..Settings::default()
    };
    let is_drawn = |tile: &Tile| {
        settings.crop.is_none_or(|crop| {
            let [x, y] = [tile.x.checked_sub(crop.x), tile.y.checked_sub(crop.y)];
            x.is_some_and(|x| x < crop.width) && y.is_some_and(|y| y < crop.height)
        })
    };
    let mut tiles = chosen(size, 16);
    tiles.retain(is_drawn);
    let (mut time, mut pixels) = (0.0, 0);
    let start = Instant::now();
    for tiles in tiles.chunks(AT_ONCE) {
        time += runner.time(&settings_of_tiles, tiles)?.cpu;
        pixels += tiles.iter().map(|tile| tile.count()).sum::<usize>();
        if start.elapsed().as_secs_f64() > seconds {
            break;
        }
    }
    let [width, height] = (settings.crop).map_or(size, |crop| [crop.width, crop.height]);
    let all = f64::from(width) * f64::from(height);
    Ok(Pilot {
        build,
        pixels: time * all / pixels.max(1) as f64,
    })
}
