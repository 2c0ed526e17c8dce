//! Measures how far pixels are from those of a reference.

use super::sample_tiles::Random;
use crate::scene::Rgb;
use crate::trace::film::srgb8;

/// The sRGB transfer function (IEC 61966-2-1) of a linear number, clipped, in steps of 8 bits: 0 to
/// 255, not rounded.
pub fn steps(linear: f64) -> f64 {
    let x = linear.clamp(0.0, 1.0);
    255.0
        * if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * x.powf(1.0 / 2.4) - 0.055
        }
}

/// The error of a picture, measured on the pixels of some tiles.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Root mean square in steps of 1/255 of the sRGB picture, over pixels and channels.
    pub steps: f64,
    /// The interval that holds `steps` of the whole picture with 95 %, by bootstrap over tiles. Both ends are equal
    /// where the whole picture was measured.
    pub interval: [f64; 2],
    /// Root mean square of linear RGB.
    pub rmse: f64,
    /// Mean of squares over (reference² + 0.01), linear (Rousselle et al., "Adaptive Sampling and
    /// Reconstruction using Greedy Error Minimization", 2011).
    pub relmse: f64,
    /// The largest difference of a channel in linear light.
    pub max: f64,
    /// The largest difference of a channel in steps.
    pub max_steps: f64,
    /// The mean of FLIP (Andersson et al., 2020); tile by tile unless the whole picture was measured.
    pub flip: f64,
    /// The number of pixels with a channel that is off by more than a step.
    pub pixels_off: usize,
    /// The number of pixels that differ at all, in doubles.
    pub pixels_differ: usize,
    pub pixels: usize,
}

/// The largest difference of two colours in a channel, in steps.
pub fn distance(a: Rgb, b: Rgb) -> f64 {
    (0..3).fold(0.0, |most, c| {
        f64::max(most, (steps(a[c]) - steps(b[c])).abs())
    })
}

/// Compares pixels with those of a reference. `tiles` has width and height of each tile, in the order of the pixels;
/// `all` says that the tiles make up the whole picture.
pub fn compare(found: &[Rgb], reference: &[Rgb], tiles: &[[u32; 2]], all: bool) -> Measured {
    let mut squares = Vec::with_capacity(tiles.len());
    let mut rest = found.iter().zip(reference);
    let (mut linear, mut relative) = (0.0, 0.0);
    let (mut max, mut max_steps) = (0.0f64, 0.0f64);
    let (mut pixels_off, mut pixels_differ, mut pixels) = (0, 0, 0);
    for size in tiles {
        let count = size[0] as usize * size[1] as usize;
        let mut square = 0.0;
        for (a, b) in rest.by_ref().take(count) {
            pixels += 1;
            pixels_differ += usize::from(a != b);
            if a == b {
                continue;
            }
            let farthest = distance(*a, *b);
            pixels_off += usize::from(farthest > 1.0);
            max_steps = max_steps.max(farthest);
            for c in 0..3 {
                let (d, s) = (a[c] - b[c], steps(a[c]) - steps(b[c]));
                square += s * s;
                linear += d * d;
                relative += d * d / (b[c] * b[c] + 0.01);
                max = max.max(d.abs());
            }
        }
        squares.push((square, count));
    }
    let values = (3 * pixels).max(1) as f64;
    let rms = |tiles: &mut dyn Iterator<Item = &(f64, usize)>| {
        let (sum, count) = tiles.fold((0.0, 0), |s, t| (s.0 + t.0, s.1 + t.1));
        (sum / (3 * count).max(1) as f64).sqrt()
    };
    let total = rms(&mut squares.iter());
    let interval = match all || pixels_differ == 0 {
        true => [total; 2],
        false => {
            let mut random = Random::new(7);
            let mut draws: Vec<f64> = (0..400)
                .map(|_| {
                    let mut picks =
                        (0..squares.len()).map(|_| &squares[random.below(squares.len())]);
                    rms(&mut picks)
                })
                .collect();
            draws.sort_by(f64::total_cmp);
            [draws[10], draws[389]]
        }
    };
    Measured {
        steps: total,
        interval,
        rmse: (linear / values).sqrt(),
        relmse: relative / values,
        max,
        max_steps,
        flip: match pixels_differ {
            0 => 0.0,
            _ => flip(found, reference, tiles),
        },
        pixels_off,
        pixels_differ,
        pixels,
    }
}

/// The mean of FLIP over tiles. Equal tiles are skipped: most tiles of most configurations equal those of the
/// reference.
fn flip(found: &[Rgb], reference: &[Rgb], tiles: &[[u32; 2]]) -> f64 {
    let bytes =
        |pixels: &[Rgb]| -> Vec<u8> { pixels.iter().flatten().map(|&x| srgb8(x as f32)).collect() };
    let (mut at, mut sum, mut count) = (0, 0.0, 0);
    for &[width, height] in tiles {
        let n = width as usize * height as usize;
        let [a, b] = [found, reference].map(|p| bytes(&p[at.min(p.len())..(at + n).min(p.len())]));
        (at, count) = (at + n, count + n);
        if a == b || a.len() != 3 * n {
            continue;
        }
        let image = |bytes: &[u8]| nv_flip::FlipImageRgb8::with_data(width, height, bytes);
        let map = nv_flip::flip(image(&a), image(&b), nv_flip::DEFAULT_PIXELS_PER_DEGREE);
        sum += f64::from(nv_flip::FlipPool::from_image(&map).mean()) * n as f64;
    }
    sum / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_a_step_of_the_picture() {
        for (linear, step) in [(0.0, 0.0), (1.0, 255.0), (2.0, 255.0), (-1.0, 0.0)] {
            assert_eq!(steps(linear).round(), step);
        }
        // As the pictures are written.
        for i in 0..100 {
            let x = f64::from(i) / 99.0;
            assert_eq!(
                steps(f64::from(x as f32)).round() as u8,
                srgb8(x as f32),
                "{x}"
            );
        }
    }

    #[test]
    fn what_differs_in_one_pixel() {
        let reference = vec![[0.5; 3]; 128];
        let mut found = reference.clone();
        found[3] = [1.0, 0.5, 0.5];
        let tiles = [[8, 8], [8, 8]];
        let m = compare(&found, &reference, &tiles, false);
        assert_eq!((m.pixels_off, m.pixels_differ, m.pixels), (1, 1, 128));
        // sRGB of 0.5 is 0.735357.
        let off: f64 = 255.0 * (1.0 - 0.735_356_983_052_449);
        assert!(
            (m.steps - (off * off / 384.0).sqrt()).abs() < 1e-9,
            "{}",
            m.steps
        );
        assert!((m.max_steps - off).abs() < 1e-9 && m.max == 0.5);
        assert!((m.rmse - (0.25f64 / 384.0).sqrt()).abs() < 1e-12);
        assert!((m.relmse - 0.25 / 0.26 / 384.0).abs() < 1e-12);
        assert!(m.interval[0] == 0.0 && m.interval[1] > m.steps);
        let same = compare(&reference, &reference, &tiles, false);
        assert_eq!((same.steps, same.flip, same.interval), (0.0, 0.0, [0.0; 2]));
    }
}
