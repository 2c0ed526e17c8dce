//! A short study of a picture's time: the shares of the objects seen first, and of the effects.

use super::axes;
use super::configurations::{Kernel, Settings};
use super::runner::Runner;
use super::sample_tiles::{Tile, chosen};
use crate::diagnostics::Error;
use crate::scene::{Camera, Scene};
use crate::trace::{self, Images};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Shares of a picture's time.
#[derive(Debug, Clone)]
pub struct Cost {
    /// ID and share of the time of each object that is seen first at the centre of a pixel, the largest share first.
    /// The ID 0 is the background.
    pub objects: Vec<(u32, f64)>,
    /// Name of each effect, and the share of the time that is saved when it alone is taken out; the largest share
    /// first.
    pub effects: Vec<(&'static str, f64)>,
}

/// Measures the shares on a few tiles of a picture, for about `seconds` seconds.
///
/// # Errors
///
/// As [`Tracer::render`](crate::trace::Tracer::render).
pub fn cost(
    scene: Arc<Scene>,
    images: &Images,
    camera: Camera,
    settings: &trace::Settings,
    seconds: f64,
) -> Result<Cost, Error> {
    let size = [settings.width, settings.height];
    let mut runner = Runner::new(scene, images, camera, size)?;
    let base = Settings {
        depth: settings.depth,
        cutoff: settings.cutoff,
        kernel: Kernel::Ours(settings.numbers),
        ..Settings::default()
    };
    let all = chosen(size, 1);
    let pilot: Vec<Tile> = all.iter().copied().take(6).collect();
    let each = runner.time(&base, &pilot)?.wall / pilot.len().max(1) as f64;
    let effects = axes::effects(&runner.tracer().plan);
    // Each pixel is timed in three runs, and so are each effect and the whole.
    let runs = 3.0 * (effects.len() + 2) as f64;
    let count = (seconds / (runs * each).max(1e-9)) as usize;
    let tiles: Vec<Tile> = all.into_iter().take(count.max(16)).collect();
    let times = runner.pixel_times(&base, &tiles)?;
    let seen = runner.seen(&base, &tiles)?;
    let total: f64 = times.iter().sum::<f64>().max(1e-300);
    let mut by_object: BTreeMap<u32, f64> = BTreeMap::new();
    for (time, seen) in times.iter().zip(&seen) {
        *by_object.entry(seen.map_or(0, |s| s.object)).or_default() += time / total;
    }
    let mut objects: Vec<(u32, f64)> = by_object.into_iter().collect();
    objects.sort_by(|a, b| b.1.total_cmp(&a.1));
    let least = |runner: &mut Runner, settings: &Settings| -> Result<f64, Error> {
        let mut least = f64::INFINITY;
        for _ in 0..3 {
            least = least.min(runner.time(settings, &tiles)?.cpu);
        }
        Ok(least)
    };
    let whole = least(&mut runner, &base)?;
    let mut shares = Vec::new();
    for (name, without) in effects {
        let time = least(&mut runner, &Settings { without, ..base })?;
        shares.push((name, 1.0 - time / whole));
    }
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(Cost {
        objects,
        effects: shares,
    })
}
