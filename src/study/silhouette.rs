//! Finds the pixels that an edge goes through: the edge of an object, a face, a shadow or a pattern, seen directly or
//! in mirrors and glass. On which side of the edge a single sample falls depends on rounding.

use std::f64::consts::TAU;

use super::compare::distance;
use crate::diagnostics::Error;
use crate::parallel;
use crate::scene::Camera;
use crate::trace::camera::View;
use crate::trace::{Picture, Settings, Tracer, Walkers};

/// The distance in pixels between a sample and an edge up to which the edge counts: far more than programs differ in
/// where they send their rays, and too little to make many pixels uncertain.
const EDGE_DISTANCE_PIXELS: f64 = 0.03;

/// The number of samples on the ring around a pixel's centre that are taken first.
const FIRST_RING_SAMPLES: usize = 4;
/// The number of samples on the whole ring, which tell an edge from noise. Of rings whose samples have one of two
/// colours at random, 94 of 100 go up and down more often than two crossing edges do.
const RING: usize = 16;

/// The kind of an edge through the centre of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// On one side another object, or none, is seen first.
    Silhouette,
    /// The same object is seen on both sides, with different colours.
    Other,
}

/// A picture, and the pixels whose value depends on rounding.
pub struct Studied {
    pub picture: Picture,
    /// For each pixel, row by row: the edge through its centre. `None` without an edge, and for pixels not in question.
    pub edges: Vec<Option<Edge>>,
    /// For each pixel: whether some of the light that it shows was totally reflected. For a pixel in question, the
    /// light on the ring around its centre counts, too.
    pub total_reflection: Vec<bool>,
}

/// Renders a picture, and for each pixel in question a ring of samples around its centre. The pixel has an edge if the
/// ring differs by more than `bar` in a channel, in linear light, with one colour on one side and another colour on the
/// other. A ring whose colours alternate more often is noise, and no edge. `in_question` gets the number and the colour
/// of each pixel. `progress` is called for every finished row of the whole picture.
///
/// # Errors
///
/// As [`Tracer::render`].
pub fn study(
    tracer: &Tracer,
    camera: &Camera,
    settings: &Settings,
    bar: f64,
    in_question: impl Fn(usize, [f32; 3]) -> bool,
    progress: impl Fn() + Sync,
) -> Result<Studied, Error> {
    let picture = tracer.render(camera, settings, progress)?;
    let pixels = &picture.film.pixels;
    let mut total_reflection = picture.total_reflection.clone();
    let asked = pixels.iter().enumerate();
    let mut asked: Vec<bool> = asked.map(|(i, p)| in_question(i, *p)).collect();
    let moved = |asked: &[bool], shift: [f64; 2]| {
        let settings = Settings {
            wanted: Some(asked.into()),
            shift,
            ..settings.clone()
        };
        tracer.render(camera, &settings, || ())
    };
    let mut changes = vec![false; pixels.len()];
    for k in 0..FIRST_RING_SAMPLES {
        let moved = moved(&asked, place(k, FIRST_RING_SAMPLES))?;
        for i in (0..pixels.len()).filter(|&i| asked[i]) {
            changes[i] |= distance(pixels[i], moved.film.pixels[i]) > bar;
            total_reflection[i] |= moved.total_reflection[i];
        }
    }
    // Most pixels in question show no edge to the first samples. Only the others get a whole ring.
    asked = changes;
    let which: Vec<usize> = (0..pixels.len()).filter(|&i| asked[i]).collect();
    let mut rings = vec![Ring::default(); which.len()];
    for k in 0..RING {
        let moved = moved(&asked, place(k, RING))?;
        for (ring, &i) in rings.iter_mut().zip(&which) {
            ring.add(moved.film.pixels[i]);
        }
    }
    let objects = objects(tracer, camera, settings, &which);
    let mut edges = vec![None; pixels.len()];
    for ((ring, i), differ) in rings.iter().zip(which).zip(objects) {
        edges[i] = match differ {
            true => Some(Edge::Silhouette),
            false => ring.is_edge(bar).then_some(Edge::Other),
        };
    }
    Ok(Studied {
        picture,
        edges,
        total_reflection,
    })
}

/// The place of sample `k` on a ring of `of` samples, in pixels from the pixel's centre. The ring is turned by half a
/// step: most edges follow rows and columns, and no sample shall lie on such an edge through the centre.
fn place(k: usize, of: usize) -> [f64; 2] {
    let angle = TAU * (k as f64 + 0.5) / of as f64;
    [
        EDGE_DISTANCE_PIXELS * libm::cos(angle),
        EDGE_DISTANCE_PIXELS * libm::sin(angle),
    ]
}

/// For each of `pixels`: whether the ring around its centre sees another object or shape first than the centre does.
fn objects(tracer: &Tracer, camera: &Camera, settings: &Settings, pixels: &[usize]) -> Vec<bool> {
    let Some(view) = View::new(camera, settings.width, settings.height) else {
        return vec![false; pixels.len()];
    };
    let width = settings.width as usize;
    let start = || tracer.walker();
    parallel::map_with(pixels.len(), start, |walkers: &mut Walkers<f64>, n| {
        let (x, y) = (pixels[n] % width, pixels[n] / width);
        let mut seen = |[dx, dy]: [f64; 2]| {
            let ray = view.ray(x as f64 + 0.5 + dx, y as f64 + 0.5 + dy)?;
            let probe = tracer.probe(walkers, &ray);
            probe.crossings.first().map(|c| (c.shape, c.object))
        };
        let middle = seen([0.0; 2]);
        (0..RING).any(|k| seen(place(k, RING)) != middle)
    })
}

/// The colours met on a walk once around a ring: the first, the last, and the extremes of each channel.
#[derive(Debug, Clone, Copy, Default)]
struct Ring {
    first: Option<[f32; 3]>,
    last: [f32; 3],
    least: [f32; 3],
    most: [f32; 3],
    /// For each channel, the sum of all steps up and down along the ring.
    way: [f32; 3],
}

impl Ring {
    fn add(&mut self, colour: [f32; 3]) {
        if self.first.is_none() {
            *self = Ring {
                first: Some(colour),
                last: colour,
                least: colour,
                most: colour,
                way: [0.0; 3],
            };
        }
        for (c, &x) in colour.iter().enumerate() {
            self.way[c] += (x - self.last[c]).abs();
            self.least[c] = self.least[c].min(x);
            self.most[c] = self.most[c].max(x);
        }
        self.last = colour;
    }

    /// Whether the colours go up and down once, as at one edge, or twice, as where two edges cross. Further steps do
    /// not count while their sum is at most `bar`.
    fn is_edge(&self, bar: f64) -> bool {
        let first = self.first.unwrap_or_default();
        (0..3).all(|c| {
            let way = self.way[c] + (first[c] - self.last[c]).abs();
            let once = 2.0 * (self.most[c] - self.least[c]);
            f64::from(way) <= 2.0 * f64::from(once) + bar
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Analysis;
    use crate::solids::staging::selected_cameras;

    const SIZE: u32 = 33;

    /// The edges in the pixels of a scene of 33 by 33, all of which are in question.
    fn edges(text: &str) -> Vec<Option<Edge>> {
        let loaded = Analysis::new("scene", text.as_bytes().to_vec());
        assert!(loaded.is_sound(), "{:?}", loaded.findings());
        let tracer = Tracer::new(&loaded.scene).unwrap();
        let settings = Settings {
            width: SIZE,
            height: SIZE,
            ..Settings::default()
        };
        let camera = &selected_cameras(&loaded.scene, 1.0)[0];
        let studied = study(&tracer, camera, &settings, 1.0 / 255.0, |_, _| true, || ());
        studied.unwrap().edges
    }

    /// The columns that an edge of a kind goes down all the way, but for the first and last rows.
    fn columns(edges: &[Option<Edge>], kind: Edge) -> Vec<u32> {
        let at = |x: u32, y: u32| edges[(y * SIZE + x) as usize];
        let all = |x: &u32| (2..SIZE - 2).all(|y| at(*x, y) == Some(kind));
        (0..SIZE).filter(all).collect()
    }

    const END: &str = "7 -402 1\n7 -1 0 0 9\n8 -401 0.3\n9 -501 0 0 8 0 0 -1 0 1 0 30\n";
    /// The middle column: its rays go through x = 0.
    const MIDDLE: u32 = SIZE / 2;

    #[test]
    fn edges_are_told_by_what_makes_them() {
        let white = "2 5 -9 -9 9 9\n2 -701 1 1 1\n2 -201 1 0 0\n";
        // A blue plate before a white one, which ends at the middle.
        let plates = format!(
            "{white}3 5 0 -9 9 9\n3 -1 0 0 0.001\n3 -701 0 0 1\n4 -101 2 3\n{END}1 9999 4 0\n"
        );
        let found = edges(&plates);
        assert_eq!(columns(&found, Edge::Silhouette), [MIDDLE]);
        assert_eq!(found.iter().flatten().count(), SIZE as usize);
        // A pattern of two cells, of which one edge is at the middle and one is the rectangle's end.
        let cells = format!(
            "2 5 -9 -9 9 9\n2 -201 1 0 0\n3 -701 1 0 0\n4 -701 0 1 0\n2 -399 2 1 3 4\n{END}1 9999 2 0\n"
        );
        let found = edges(&cells);
        assert_eq!(columns(&found, Edge::Other), [MIDDLE]);
        assert!(columns(&found, Edge::Silhouette).is_empty());
        assert_eq!(found.iter().flatten().count(), SIZE as usize);
        // Where four cells meet, two edges cross.
        let found = edges(&cells.replace("2 -399 2 1", "2 -399 2 2"));
        assert_eq!(found.iter().flatten().count(), 2 * SIZE as usize - 1);
    }

    /// Few edges are found in cells far smaller than the ring, where each sample has any of two colours.
    #[test]
    fn noise_is_no_edge() {
        let noise = format!(
            "2 5 -9 -9 9 9\n2 -201 1 0 0\n3 -701 1 0 0\n4 -701 0 1 0\n2 -399 98765431 87654321 3 4\n{END}1 9999 2 0\n"
        );
        let found = edges(&noise).iter().flatten().count();
        assert!(found < (SIZE * SIZE / 8) as usize, "{found}");
    }
}
