//! Checks the reference by a tracer that shares no code with it.

use super::configurations::Settings;
use super::report::Checked;
use super::runner::Runner;
use super::sample_tiles::{Random, Tile, shuffle};
use crate::diagnostics::Error;
use crate::scene::Rgb;
use crate::study::naive::{Naive, Unfit, Wide};
use crate::trace::Images;
use crate::trace::camera::View;
use crate::trace::pixels::VisibleObject;
use std::time::Instant;

/// Fewest pixels that are checked.
pub const MIN_PIXELS: usize = 120;
/// Most pixels that are checked.
const MAX_PIXELS: usize = 960;
/// Pixels that are followed before the clock is looked at.
const BATCH_PIXELS: usize = 40;

/// The difference in linear light above which a channel is wrong, relative to channels above 1: a tenth of a thousandth
/// of a step. Doubles and double-double come within 1e-10.
pub const WRONG: f64 = 1e-7;

/// The largest error of a camera ray in doubles that is still the right ray, rounded. The rays of the gallery and the
/// hard scenes are off by less than 1e-14, as `tests/accuracy.rs` measures. The rest is left for a view nearly along
/// the up vector and for projection matrices, whose inverses magnify roundings.
pub const SAME_RAY: f64 = 1e-12;

/// The pixels of tiles in random order, each with its number among all pixels. About every second pixel lies on the
/// edge of an object, while there are such pixels.
pub fn order(tiles: &[Tile], seen: &[Option<VisibleObject>]) -> Vec<(usize, [u32; 2])> {
    let (mut edges, mut others) = (Vec::new(), Vec::new());
    let mut first = 0;
    for tile in tiles {
        let object = |i: usize| seen[first + i].map(|s| s.object);
        let (w, count) = (tile.width as usize, tile.count());
        for (i, pixel) in tile.pixels().enumerate() {
            let right = (i + 1) % w != 0 && object(i) != object(i + 1);
            let below = i + w < count && object(i) != object(i + w);
            let list = if right || below {
                &mut edges
            } else {
                &mut others
            };
            list.push((first + i, pixel));
        }
        first += count;
    }
    shuffle(&mut edges, 1);
    shuffle(&mut others, 2);
    let mut random = Random::new(3);
    // Once all pixels of one list are taken, the rest of the other list follows.
    let mut all = Vec::new();
    let (mut edges, mut others) = (edges.into_iter().peekable(), others.into_iter().peekable());
    while edges.peek().is_some() || others.peek().is_some() {
        let edge = others.peek().is_none() || (edges.peek().is_some() && random.below(2) == 0);
        all.extend(if edge { edges.next() } else { others.next() });
    }
    all
}

/// The largest difference of two colours in a channel, relative to channels above 1.
fn difference(ours: Rgb, right: Rgb) -> f64 {
    let off = (0..3).map(|c| (ours[c] - right[c]).abs() / right[c].abs().max(1.0));
    off.fold(0.0, f64::max)
}

/// Whether a pixel is wrong only since its camera ray is rounded to doubles. If so, the independent tracer sees the
/// same colour along the rounded ray; or, where an edge runs close by, along a ray whose direction is one rounding off.
fn is_camera_rounding(naive: &Naive<Wide>, runner: &Runner, place: [u32; 2], ours: Rgb) -> bool {
    let [width, height] = runner.size;
    let view = View::new(runner.camera(), width, height);
    let [x, y] = place.map(|x| f64::from(x) + 0.5);
    let Some(line) = view.and_then(|view| view.ray(x, y)).map(|ray| ray.line) else {
        return false;
    };
    let (origin, direction) = (line.origin.0, line.direction.0);
    let beside = (0..6).map(|i| {
        let mut beside = direction;
        beside[i / 2] += if i % 2 == 0 {
            f64::EPSILON
        } else {
            -f64::EPSILON
        };
        beside
    });
    let shows = |direction| naive.along(origin, direction);
    naive.aside(place, origin, direction) <= SAME_RAY
        && std::iter::once(direction)
            .chain(beside)
            .any(|d| shows(d).is_ok_and(|colour| difference(ours, colour) <= WRONG))
}

fn unfit(unfit: Unfit) -> &'static str {
    match unfit {
        Unfit::NothingDrawn | Unfit::TooManyParts => "accuracy-unfit-parts",
        Unfit::TooDeep => "accuracy-unfit-deep",
        Unfit::TooManyFacets => "accuracy-unfit-facets",
        Unfit::Singular => "accuracy-unfit-matrix",
    }
}

/// Compares pixels of the reference with those of the independent tracer: [`MIN_PIXELS`] unless they take more than
/// `most` seconds, and more while `seconds` last. Each of `pixels` has its number in `colours`, the colours of the
/// reference. The inner `Err` is the name of the message that says why nothing could be checked.
pub fn check(
    runner: &Runner,
    images: &Images,
    settings: &Settings,
    pixels: &[(usize, [u32; 2])],
    colours: &[Rgb],
    [seconds, most]: [f64; 2],
) -> Result<Result<Checked, &'static str>, Error> {
    let start = Instant::now();
    let (depth, cutoff) = (settings.depth, settings.cutoff);
    let naive = Naive::<Wide>::new(
        runner.scene(),
        images,
        runner.camera(),
        runner.size,
        depth,
        cutoff,
    );
    let naive = match naive {
        Ok(naive) => naive,
        Err(why) => return Ok(Err(unfit(why))),
    };
    let mut checked = Checked::default();
    for batch in pixels[..pixels.len().min(MAX_PIXELS)].chunks(BATCH_PIXELS) {
        let places: Vec<[u32; 2]> = batch.iter().map(|p| p.1).collect();
        let found = match naive.pixels(&places) {
            Ok(found) => found,
            Err(why) => return Ok(Err(unfit(why))),
        };
        for ((i, place), sample) in batch.iter().zip(found) {
            let colour = sample.colour;
            checked.rays += sample.rays.sent.iter().sum::<u64>();
            let Some(ours) = colours.get(*i) else {
                continue;
            };
            let off = difference(*ours, colour);
            checked.pixels += 1;
            if off > WRONG || !colour.iter().all(|c| c.is_finite()) {
                if is_camera_rounding(&naive, runner, *place, *ours) {
                    checked.camera_rounding += 1;
                    continue;
                }
                checked.wrong += 1;
                if checked.wrong_pixels.len() < 8 {
                    checked.wrong_pixels.push(*place);
                }
            }
            checked.largest = checked.largest.max(off);
        }
        // The next batch must fit, too.
        let spent = start.elapsed().as_secs_f64();
        let done = checked.pixels;
        let next = spent * (1.0 + BATCH_PIXELS as f64 / done.max(1) as f64);
        let allowed = if done < MIN_PIXELS { most } else { seconds };
        if next > allowed {
            break;
        }
    }
    Ok(Ok(checked))
}
