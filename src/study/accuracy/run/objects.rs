//! The time and the error of each object, and maps of both over the picture.

use super::{FEWEST_PIXELS, OBJECTS, PICTURES, Run};
use crate::diagnostics::Error;
use crate::study::accuracy::configurations::Settings;
use crate::study::accuracy::measure::steps;
use crate::study::accuracy::report::{Maps, Object};
use crate::study::accuracy::sample_tiles::Tile;
use std::collections::BTreeMap;

impl Run<'_> {
    /// Measures time and error for each object that is seen first, and as maps over the picture.
    pub(super) fn objects(&mut self) -> Result<(Vec<Object>, Option<Maps>), Error> {
        let settings = Settings {
            samples: 4,
            ..Settings::default()
        };
        // Each pixel is drawn in three runs of four samples.
        let cost = 12.0 * self.cost(&Settings::default());
        let seconds = self.on_one(self.allotted(OBJECTS, PICTURES));
        let tiles = self.tiles_for(seconds, cost, FEWEST_PIXELS);
        let list = self.tiles[..tiles].to_vec();
        let times = self.runner.pixel_times(&settings, &list)?;
        let seen = self.runner.seen(&Settings::default(), &list)?;
        let base = self.runner.draw(&Settings::default(), &list)?;
        let mut sums: BTreeMap<u32, (usize, f64, f64, usize)> = BTreeMap::new();
        let error = |i: usize| -> Option<f64> {
            let (a, b) = (base.colours[i], self.edges.get(i)?);
            Some(
                (0..3)
                    .map(|c| (steps(a[c]) - steps(b[c])).powi(2))
                    .sum::<f64>()
                    / 3.0,
            )
        };
        for (i, (time, seen)) in times.iter().zip(&seen).enumerate() {
            let sum = sums.entry(seen.map_or(0, |s| s.object)).or_default();
            sum.0 += 1;
            sum.1 += time;
            if let Some(square) = error(i) {
                sum.2 += square;
                sum.3 += 1;
            }
        }
        let total =
            |f: fn(&(usize, f64, f64, usize)) -> f64| sums.values().map(f).sum::<f64>().max(1e-300);
        let (pixels, time, square) = (total(|s| s.0 as f64), total(|s| s.1), total(|s| s.2));
        let mut objects: Vec<Object> = (sums.iter())
            .map(|(&id, &(n, t, e, with_error))| Object {
                id,
                share_of_pixels: n as f64 / pixels,
                share_of_time: t / time,
                share_of_error: e / square,
                microseconds_per_pixel: t / n as f64 / 4.0 * 1e6,
                steps: (e / with_error.max(1) as f64).sqrt(),
            })
            .collect();
        objects.sort_by(|a, b| b.share_of_time.total_cmp(&a.share_of_time));
        objects.truncate(100);
        let maps = self.maps(&list, &times, &|i| error(i).map(f64::sqrt));
        Ok((objects, Some(maps)))
    }

    pub(super) fn maps(
        &self,
        list: &[Tile],
        times: &[f64],
        error: &dyn Fn(usize) -> Option<f64>,
    ) -> Maps {
        let [w, h] = self.options.size;
        let block = if self.whole { 1 } else { 32 };
        let (width, height) = (w.div_ceil(block), h.div_ceil(block));
        let count = width as usize * height as usize;
        let mut sums = vec![[0.0f64; 4]; count];
        let mut i = 0;
        for tile in list {
            for [x, y] in tile.pixels() {
                let sum = &mut sums[(y / block * width + x / block) as usize];
                sum[0] += times[i];
                sum[1] += 1.0;
                if let Some(e) = error(i) {
                    sum[2] += e * e;
                    sum[3] += 1.0;
                }
                i += 1;
            }
        }
        Maps {
            width,
            height,
            // A block without pixels gets NaN, as 0 / 0.
            time: sums.iter().map(|s| s[0] / s[1] / 4.0 * 1e6).collect(),
            error: sums.iter().map(|s| (s[2] / s[3]).sqrt()).collect(),
        }
    }
}
