//! Measures how far two pictures of one scene are apart, in linear light.

use serde::Serialize;

use super::silhouette::{Edge, Studied, study};
use super::whereabouts::Whereabouts;
use crate::diagnostics::Error;
use crate::scene::Camera;
use crate::trace::film::srgb8;
use crate::trace::{Film, Settings, Tracer};

/// The largest difference of two colours in a channel.
pub fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let channel = |c: usize| (f64::from(a[c]) - f64::from(b[c])).abs();
    (0..3).map(channel).fold(0.0, f64::max)
}

/// The class of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pixel {
    /// A pixel that differs, with an edge through it.
    Edge(Edge),
    /// A pixel that shows light that was totally reflected, where the other program differs by design.
    Apart,
    Alike,
    Differing,
}

/// The outcome of comparing our picture of a scene with that of another program.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    pub pixels: usize,
    /// Number of pixels off edges that are not compared, since they show light that was totally reflected.
    pub total_reflection: usize,
    pub differing: Differing,
    /// The shape that most of the pixels show that differ off edges.
    pub mostly: Option<Whereabouts>,
    pub difference: Difference,
    /// The mean of the FLIP map of both pictures in sRGB (Andersson et al., "FLIP: A Difference
    /// Evaluator for Alternating Images", 2020): 0 for equal ones.
    pub flip: f32,
    #[serde(skip)]
    map: Vec<(Pixel, f64)>,
    #[serde(skip)]
    bar: f64,
}

/// Pixels that differ by more than the bar.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Differing {
    /// Number of pixels off edges of any kind.
    pub off_silhouettes: usize,
    /// The pixels off edges of any kind as a share of all pixels.
    pub share_off_silhouettes: f64,
    /// Number of pixels at the edge of an object: another object is seen a hair beside the centre.
    pub on_silhouettes: usize,
    /// Number of pixels at an edge within one object: the edge of a face, a shadow or a pattern, or of another object
    /// that is mirrored in it or seen through it.
    pub on_other_edges: usize,
}

/// Differences of the pixels that are compared, off edges and without total reflection, in linear light: 1 is white.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Difference {
    pub largest: f64,
    pub mean: f64,
}

impl Comparison {
    /// Renders our picture in the size of `theirs` and compares both. Returns the comparison and our picture. Our
    /// channels are capped at `most`, the largest value that a channel of theirs can hold. Pixels differ if a channel
    /// differs by more than `bar`. `progress` is called for every finished row.
    ///
    /// # Errors
    ///
    /// As [`Tracer::render`].
    pub fn of(
        (tracer, camera, settings): (&Tracer, &Camera, &Settings),
        theirs: &Film,
        most: f32,
        bar: f64,
        progress: impl Fn() + Sync,
    ) -> Result<(Comparison, Film), Error> {
        let differs =
            |i: usize, p: [f32; 3]| distance(p.map(|c| c.min(most)), theirs.pixels[i]) > bar;
        // An edge counts from a step of half the bar: pictures that show opposite sides of an edge differ by its whole
        // step.
        let ours = study(tracer, camera, settings, bar / 2.0, differs, progress)?;
        let mut comparison = Comparison::new(&ours, theirs, most, bar);
        let size = (settings.width, settings.height);
        comparison.mostly = Whereabouts::of(tracer, camera, size, &comparison.wrong());
        Ok((comparison, ours.picture.film))
    }

    fn new(ours: &Studied, theirs: &Film, most: f32, bar: f64) -> Comparison {
        let held: Vec<[f32; 3]> = (ours.picture.film.pixels.iter())
            .map(|p| p.map(|c| c.min(most)))
            .collect();
        let map: Vec<(Pixel, f64)> = (held.iter().zip(&theirs.pixels).enumerate())
            .map(|(i, (a, b))| {
                let d = distance(*a, *b);
                let pixel = match ours.edges[i] {
                    Some(edge) => Pixel::Edge(edge),
                    None if ours.total_reflection[i] => Pixel::Apart,
                    None if d > bar => Pixel::Differing,
                    None => Pixel::Alike,
                };
                (pixel, d)
            })
            .collect();
        let count = |what: Pixel| map.iter().filter(|p| p.0 == what).count();
        let compared = || {
            let off = |p: &&(Pixel, f64)| matches!(p.0, Pixel::Alike | Pixel::Differing);
            map.iter().filter(off).map(|p| p.1)
        };
        let sum: f64 = compared().sum();
        let off = count(Pixel::Differing);
        Comparison {
            pixels: map.len(),
            total_reflection: count(Pixel::Apart),
            differing: Differing {
                off_silhouettes: off,
                share_off_silhouettes: off as f64 / map.len().max(1) as f64,
                on_silhouettes: count(Pixel::Edge(Edge::Silhouette)),
                on_other_edges: count(Pixel::Edge(Edge::Other)),
            },
            mostly: None,
            difference: Difference {
                largest: compared().fold(0.0, f64::max),
                mean: sum / compared().count().max(1) as f64,
            },
            flip: flip(theirs.width, theirs.height, &held, &theirs.pixels),
            map,
            bar,
        }
    }

    /// The numbers of the pixels that differ off edges.
    fn wrong(&self) -> Vec<usize> {
        let wrong = |i: &usize| self.map[*i].0 == Pixel::Differing;
        (0..self.map.len()).filter(wrong).collect()
    }

    /// The number of pixels that are not compared: edges that differ, and total reflection.
    pub fn left_out(&self) -> usize {
        self.total_reflection + self.differing.on_silhouettes + self.differing.on_other_edges
    }

    /// Draws the differences in 8-bit RGB, row by row: green up to the bar, dark where nothing differs; red above the
    /// bar; grey for silhouettes that differ, yellow for other edges that differ, blue for total reflection. Grey,
    /// yellow and blue are the brighter the more a pixel differs.
    pub fn picture(&self) -> Vec<u8> {
        let colour = |&(pixel, d): &(Pixel, f64)| {
            let shade = (55.0 + 200.0 * (d / self.bar).min(1.0)) as u8;
            match pixel {
                Pixel::Edge(Edge::Silhouette) => [shade / 2; 3],
                Pixel::Edge(Edge::Other) => [shade, shade, 0],
                Pixel::Apart => [0, 0, shade],
                Pixel::Alike => alike(d / self.bar),
                Pixel::Differing => [255, 0, 0],
            }
        };
        self.map.iter().flat_map(colour).collect()
    }
}

/// The colour of a pixel whose difference is this share of what is allowed: dark green for 0, [`ALIKE`] from 1 on.
pub fn alike(share: f64) -> [u8; 3] {
    const DARKEST_GREEN: f64 = 55.0;
    [
        0,
        (DARKEST_GREEN + (f64::from(ALIKE[1]) - DARKEST_GREEN) * share.min(1.0)) as u8,
        0,
    ]
}

/// The colour of a pixel whose difference is just what is allowed.
pub const ALIKE: [u8; 3] = [0, 200, 0];

/// The colours of [`Comparison::picture`], each with the message that explains it.
pub const LEGEND: [([u8; 3], &str); 5] = [
    (ALIKE, "crosscheck-legend-alike"),
    ([255, 0, 0], "crosscheck-legend-differing"),
    ([127; 3], "crosscheck-legend-silhouettes-differ"),
    ([255, 255, 0], "crosscheck-legend-edges"),
    ([0, 0, 255], "crosscheck-legend-total-reflection"),
];

fn flip(width: u32, height: u32, ours: &[[f32; 3]], theirs: &[[f32; 3]]) -> f32 {
    let image = |pixels: &[[f32; 3]]| {
        let bytes: Vec<u8> = pixels.iter().flatten().map(|&x| srgb8(x)).collect();
        nv_flip::FlipImageRgb8::with_data(width, height, &bytes)
    };
    let map = nv_flip::flip(
        image(ours),
        image(theirs),
        nv_flip::DEFAULT_PIXELS_PER_DEGREE,
    );
    nv_flip::FlipPool::from_image(&map).mean()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(pixels: Vec<[f32; 3]>) -> Film {
        Film {
            width: 4,
            height: pixels.len() as u32 / 4,
            pixels,
        }
    }

    /// No pixel that was compared is black, which the legend does not have.
    #[test]
    fn what_is_alike_is_green() {
        assert_eq!(alike(0.0), [0, 55, 0]);
        assert_eq!([alike(1.0), alike(7.0)], [ALIKE; 2]);
        assert!(alike(0.5)[1] > alike(0.1)[1]);
    }

    #[test]
    fn every_pixel_counts_once() {
        let theirs = film((0..8).map(|i| [i as f32 / 8.0; 3]).collect());
        assert_eq!(distance([0.0, 0.5, 1.0], [0.25, 0.5, 0.5]), 0.5);
        assert_eq!(flip(4, 2, &theirs.pixels, &theirs.pixels), 0.0);
        let black = vec![[0.0; 3]; 8];
        let white = vec![[1.0; 3]; 8];
        assert!(flip(4, 2, &black, &white) > 0.9);
    }
}
