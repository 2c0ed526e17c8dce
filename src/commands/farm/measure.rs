//! Estimates how long pictures take, and how much memory.

use std::sync::Arc;

use super::scenes::Scene;
use crate::commands::atomic_file::folder_of;
use crate::commands::render::options::{PictureArgs, bytes_of_pixels};
use crate::commands::render::stats::peak_memory;
use crate::diagnostics::{Complaint, Error};
use crate::study::accuracy::pilot::pilot;
use crate::trace::Images;

/// Seconds taken to foretell how long the pictures take.
const MEASURING_SECONDS: f64 = 6.0;
/// The most scenes that are measured for that, spread evenly over all.
const MAX_SCENES_MEASURED: usize = 6;
/// The most seconds a pixel that putting the bands of a picture together takes: many times the time that was measured.
const JOIN_SECONDS_PER_PIXEL: f64 = 1e-6;
/// Factor on the memory of this process, since another machine may take more.
const MEMORY_MARGIN: f64 = 1.25;

/// The time and the memory that the dearest picture takes.
pub(super) struct Measured {
    /// Seconds to read the scene and to build the tracer.
    pub build: f64,
    /// Seconds to draw all pixels of a picture on one processor.
    pixels: f64,
    /// Rows of a picture.
    rows: u32,
    /// The most bytes that this process has taken.
    process: f64,
    /// Bytes that all pixels of the picture take.
    picture: f64,
    /// The most seconds that putting the bands of the picture together takes.
    pub join: f64,
}

/// Measures the time and the memory of pictures: small parts of some of them are drawn.
///
/// # Errors
///
/// The options do not fit the scenes, or a scene cannot be drawn.
pub(super) fn measure(
    picture: &PictureArgs,
    scenes: &[Scene],
    tile_time: f64,
) -> Result<Measured, Error> {
    let settings = picture.settings(None)?;
    let step = scenes.len().div_ceil(MAX_SCENES_MEASURED).max(1);
    let some = || scenes.iter().step_by(step);
    let seconds = MEASURING_SECONDS.min(tile_time) / some().count().max(1) as f64;
    let (mut build, mut pixels, mut cameras) = (0.0f64, 0.0f64, 1);
    for scene in some() {
        let staged = picture.camera.staged(&scene.loaded.scene, picture.size)?;
        let folder = folder_of(&scene.path);
        let images = Images::load(&staged, folder)?;
        let camera = *staged
            .chosen_cameras()
            .next()
            .ok_or_else(Error::nothing_to_draw)?;
        cameras = cameras.max(staged.chosen_cameras().count());
        let shared = Arc::new(staged.into_owned());
        let pilot = pilot(shared, &images, camera, &settings, seconds)?;
        build = build.max(scene.reading + pilot.build);
        pixels = pixels.max(pilot.pixels);
    }
    let [width, rows] = (settings.crop).map_or([settings.width, settings.height], |crop| {
        [crop.width, crop.height]
    });
    let count = f64::from(width) * f64::from(rows) * cameras as f64;
    Ok(Measured {
        build,
        pixels: pixels * cameras as f64,
        rows,
        process: peak_memory() as f64,
        picture: bytes_of_pixels(picture.sampling()) * count,
        join: JOIN_SECONDS_PER_PIXEL * count,
    })
}

impl Measured {
    /// The number of bands that a picture is divided into: `wanted`, or as many as take `seconds` each on one
    /// processor.
    ///
    /// # Errors
    ///
    /// More bands are wanted than the picture has rows.
    pub(super) fn tiles(&self, wanted: Option<u32>, seconds: f64) -> Result<u32, Complaint> {
        match wanted {
            Some(count) if count > self.rows => Err(Complaint::new("more-tiles-than-rows")
                .with("count", count.to_string())
                .with("height", self.rows.to_string())),
            Some(count) => Ok(count),
            None => Ok((self.pixels / seconds)
                .ceil()
                .clamp(1.0, f64::from(self.rows)) as u32),
        }
    }

    /// The seconds of a task: reading and building, and drawing one of `tiles` bands on `cores` processors.
    pub(super) fn seconds(&self, tiles: u32, cores: u32) -> f64 {
        self.build + self.pixels / f64::from(tiles) / f64::from(cores)
    }

    /// The memory that a task takes at most, in 10⁶ bytes.
    pub(super) fn megabytes(&self, tiles: u32) -> u64 {
        let bytes = MEMORY_MARGIN * self.process + self.picture / f64::from(tiles);
        let hundreds = (bytes / 1e8).ceil() as u64;
        100 * hundreds.max(2)
    }
}
