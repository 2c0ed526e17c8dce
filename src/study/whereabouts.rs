//! The place of most of the differing pixels in a picture.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use serde::Serialize;

use crate::parallel;
use crate::scene::Camera;
use crate::trace::camera::View;
use crate::trace::{Tracer, Walkers};

/// The shape that most of the differing pixels show, and the rows and columns where they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Whereabouts {
    /// The shape's ID, or `None` where nothing is seen.
    pub shape: Option<u32>,
    /// The number of pixels that show the shape.
    pub pixels: usize,
    /// The first and the last row of these pixels, counted from 0 at the top.
    pub rows: [usize; 2],
    /// The first and the last column, counted from 0 at the left.
    pub columns: [usize; 2],
}

impl Whereabouts {
    /// Finds the shape that is seen first in most of `pixels`, which are numbered row by row. `None` if there are no
    /// pixels, or if the camera takes no picture.
    pub fn of(
        tracer: &Tracer,
        camera: &Camera,
        (width, height): (u32, u32),
        pixels: &[usize],
    ) -> Option<Whereabouts> {
        let view = View::new(camera, width, height)?;
        let columns = width as usize;
        let start = || tracer.walker();
        let shapes = parallel::map_with(pixels.len(), start, |walkers: &mut Walkers<f64>, n| {
            let (x, y) = (pixels[n] % columns, pixels[n] / columns);
            let ray = view.ray(x as f64 + 0.5, y as f64 + 0.5)?;
            let probe = tracer.probe(walkers, &ray);
            probe.crossings.first().map(|c| c.shape)
        });
        most(pixels.iter().copied().zip(shapes), columns)
    }
}

/// Finds the shape of the most pixels; among equals, the one with the lowest ID. Each pixel comes with its shape.
fn most(pixels: impl Iterator<Item = (usize, Option<u32>)>, width: usize) -> Option<Whereabouts> {
    let mut all: BTreeMap<Option<u32>, Whereabouts> = BTreeMap::new();
    for (i, shape) in pixels {
        let (x, y) = (i % width, i / width);
        let one = all.entry(shape).or_insert(Whereabouts {
            shape,
            pixels: 0,
            rows: [y; 2],
            columns: [x; 2],
        });
        one.pixels += 1;
        for ([first, last], at) in [(&mut one.rows, y), (&mut one.columns, x)] {
            (*first, *last) = ((*first).min(at), (*last).max(at));
        }
    }
    all.into_values().min_by_key(|one| Reverse(one.pixels))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn most_of_them() {
        // A picture four pixels wide: 7 is seen in (1, 0), (3, 1) and (2, 2), and nothing in two others.
        let pixels = [
            (0, None),
            (1, Some(7)),
            (4, Some(5)),
            (7, Some(7)),
            (10, Some(7)),
            (5, None),
        ];
        let found = most(pixels.into_iter(), 4).unwrap();
        assert_eq!((found.shape, found.pixels), (Some(7), 3));
        assert_eq!((found.rows, found.columns), ([0, 2], [1, 3]));
        assert_eq!(most([(9, None)].into_iter(), 4).unwrap().shape, None);
        assert!(most([].into_iter(), 4).is_none());
    }
}
