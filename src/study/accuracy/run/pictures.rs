//! The pictures of a report: a small copy of the whole, and parts that are drawn with two settings side by side.

use super::{PICTURES, Run};
use crate::diagnostics::Error;
use crate::scene::Rgb;
use crate::study::accuracy::configurations::{Kernel, Kind, Settings};
use crate::study::accuracy::measure::steps;
use crate::study::accuracy::report::{Pictures, Raster, Report};
use crate::study::accuracy::sample_tiles::{TILE, Tile};
use crate::trace::Numbers;

impl Run<'_> {
    /// Adds to the report a small copy of the picture, and for each kind of error the part where it is worst. The part
    /// is drawn twice: with the default, and with the most accurate configuration that there is time for.
    pub(super) fn pictures(&mut self, report: &mut Report) -> Result<(), Error> {
        let [width, height] = self.options.size;
        // The picture stays small, so that a page with all pictures does, and smaller if its pixels take long.
        let seconds = self.on_all(self.allotted(PICTURES, 0.0) / 2.0);
        let pixels = seconds / self.cost(&Settings::default()).max(1e-12);
        let side = (pixels * f64::from(width.max(height)) / f64::from(width.min(height))).sqrt();
        let side = (side as u32).clamp(80, 320);
        let step = (width.max(height)).div_ceil(side).max(1);
        report.picture = Some(self.coarse(step)?);
        for kind in Kind::ALL {
            let Some(default) = self.worst(kind) else {
                continue;
            };
            let best = (0..self.configurations.len())
                .filter(|&i| self.configurations[i].axis.kind() == kind && !self.known[i].dropped)
                .filter(|&i| !self.configurations[i].is_default())
                .filter(|&i| self.known[i].cost * CROP <= seconds)
                .filter_map(|i| Some((i, self.known[i].measured.as_ref()?.steps)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            let (shown, better, place) = match (kind, best) {
                (Kind::Numbers, _) => {
                    // For numbers, single precision is shown beside doubles.
                    let plain = self.find(Kernel::Ours(Numbers::F32));
                    let exact = self.find(Kernel::Ours(Numbers::F64));
                    match (plain, exact) {
                        (Some(a), Some(b)) => (a, b, default),
                        _ => continue,
                    }
                }
                (_, Some((best, _))) => {
                    let Some(own) = self
                        .configurations
                        .iter()
                        .position(|r| r.axis.kind() == kind && r.is_default())
                    else {
                        continue;
                    };
                    (own, best, default)
                }
                _ => continue,
            };
            let crop = around(place, [width, height]);
            let draw = |run: &mut Self, i: usize| -> Result<(String, Raster), Error> {
                let drawn = run
                    .runner
                    .draw(&run.configurations[i].settings.clone(), &crop.1)?;
                let name = format!(
                    "{} {}",
                    run.configurations[i].axis.name(),
                    run.configurations[i].label
                );
                Ok((name, arranged(&crop, &drawn.colours)))
            };
            let pictures = Pictures {
                kind,
                default: draw(self, shown)?,
                better: draw(self, better)?,
            };
            report.pictures.push(pictures);
        }
        Ok(())
    }

    /// The tile in which the default, or single precision, is farthest from the reference of a kind.
    pub(super) fn worst(&self, kind: Kind) -> Option<Tile> {
        let reference = match kind {
            Kind::Edges => &self.edges,
            Kind::Light => &self.light,
            Kind::Numbers => &self.exact,
            Kind::Facets => return self.tiles.first().copied(),
        };
        let i = match kind {
            Kind::Numbers => self.find(Kernel::Ours(Numbers::F32))?,
            _ => self
                .configurations
                .iter()
                .position(|r| r.axis.kind() == kind && r.is_default())?,
        };
        let drawn = self.known[i].drawn.as_ref()?;
        let mut at = 0;
        let mut worst = (-1.0, *self.tiles.first()?);
        for tile in &self.tiles {
            let range = at..at + tile.count();
            at = range.end;
            let (Some(a), Some(b)) = (drawn.colours.get(range.clone()), reference.get(range))
            else {
                break;
            };
            let pairs = a
                .iter()
                .zip(b)
                .flat_map(|(a, b)| (0..3).map(|c| steps(a[c]) - steps(b[c])));
            let sum: f64 = pairs.map(|d| d * d).sum();
            if sum > worst.0 {
                worst = (sum, *tile);
            }
        }
        Some(worst.1)
    }

    /// Draws every `step`-th pixel of every `step`-th row with the default settings.
    pub(super) fn coarse(&mut self, step: u32) -> Result<Raster, Error> {
        let [w, h] = self.options.size;
        let (width, height) = (w.div_ceil(step), h.div_ceil(step));
        let single = |x: u32, y: u32| Tile {
            x: x * step,
            y: y * step,
            width: 1,
            height: 1,
        };
        let tiles: Vec<Tile> = (0..height)
            .flat_map(|y| (0..width).map(move |x| single(x, y)))
            .collect();
        let drawn = self.runner.draw(&Settings::default(), &tiles)?;
        Ok(Raster {
            width,
            height,
            pixels: drawn.colours,
        })
    }
}

/// Width and height in pixels of the part of the picture that is shown.
const CROP_SIZE: [u32; 2] = [96, 72];
/// The number of pixels of the part that is shown.
const CROP: f64 = (CROP_SIZE[0] * CROP_SIZE[1]) as f64;

/// The part of the picture around a tile: column, row, width and height, and the tiles that make it up.
fn around(tile: Tile, [width, height]: [u32; 2]) -> ([u32; 4], Vec<Tile>) {
    let (w, h) = (CROP_SIZE[0].min(width), CROP_SIZE[1].min(height));
    let start =
        |at: u32, size: u32, all: u32| (at + TILE / 2).saturating_sub(size / 2).min(all - size);
    let (x0, y0) = (start(tile.x, w, width), start(tile.y, h, height));
    let mut tiles = Vec::new();
    for y in (0..h).step_by(TILE as usize) {
        for x in (0..w).step_by(TILE as usize) {
            tiles.push(Tile {
                x: x0 + x,
                y: y0 + y,
                width: TILE.min(w - x),
                height: TILE.min(h - y),
            });
        }
    }
    ([x0, y0, w, h], tiles)
}

fn arranged(([x0, y0, w, h], tiles): &([u32; 4], Vec<Tile>), colours: &[Rgb]) -> Raster {
    let mut pixels = vec![[0.0; 3]; *w as usize * *h as usize];
    let places = tiles.iter().flat_map(|t| t.pixels());
    for ([x, y], colour) in places.zip(colours) {
        pixels[((y - y0) * w + (x - x0)) as usize] = *colour;
    }
    Raster {
        width: *w,
        height: *h,
        pixels,
    }
}
