//! A ray tracer as textbooks have it, over any kind of number: the quadratic formula with b² − 4ac, a
//! quartic in closed form, coefficients from the ray's origin wherever that is, and one constant distance
//! within which a ray does not see the surface it leaves.
//!
//! In `f32` and `f64` the tracer shows what these shortcuts do to hard scenes. In [`Wide`] numbers of 71 digits they do
//! no harm, and the colours are the reference. The tracer follows every ray of a pixel, from the camera record on, and
//! shares with the main tracer only the resolved scene, the decoded pictures of its textures and, of
//! [`geometry`](crate::geometry), matrices and arrays.

pub mod boxes;
pub mod form;
pub mod light;
pub mod number;
pub mod polynomial;
pub mod solid;
pub mod trail;

pub use number::{Number, Wide};
pub use solid::Unfit;

use crate::geometry::array::each;
use crate::parallel;
use crate::scene::{Camera, Rgb, Scene, Texture};
use crate::trace::film::developed;
use crate::trace::{Film, Images};
use light::{Lens, RayCounts, Scenery, radiance};
use number::Ray;
use solid::Solids;

/// A scene and a camera, ready to be traced.
pub struct Naive<'s, T: Number> {
    scene: &'s Scene,
    images: &'s Images,
    lens: Lens<T>,
    size: [u32; 2],
    depth: u32,
    cutoff: f64,
}

/// The colour at a point of the picture, and the rays that were sent for it.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// Linear RGB.
    pub colour: Rgb,
    pub rays: RayCounts,
}

impl<'s, T: Number> Naive<'s, T> {
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn new(
        scene: &'s Scene,
        images: &'s Images,
        camera: &Camera,
        [width, height]: [u32; 2],
        depth: u32,
        cutoff: f64,
    ) -> Result<Naive<'s, T>, Unfit> {
        Ok(Naive {
            scene,
            images,
            lens: Lens::new(camera, width, height).ok_or(Unfit::Singular)?,
            size: [width, height],
            depth,
            cutoff,
        })
    }

    fn ready(&self) -> Result<(Scenery<'s, T>, Solids<'s, T>), Unfit> {
        let solids = Solids::new(self.scene)?;
        let mut scenery = Scenery::new(self.scene, self.depth, self.cutoff);
        scenery.records = (0..self.scene.shapes.len() as u32).collect();
        scenery.textures = (solids.textures.iter())
            .map(|&texture| match texture {
                Texture::Image { file, .. } => (texture, self.images.get(file).cloned()),
                _ => (texture, None),
            })
            .collect();
        Ok((scenery, solids))
    }

    /// Renders the whole picture. A colour that is not a number becomes black.
    ///
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn film(&self) -> Result<Film, Unfit> {
        let [width, height] = self.size;
        let pixels: Vec<[u32; 2]> = (0..width * height)
            .map(|i| [i % width, i / width])
            .collect();
        let samples = self.pixels(&pixels)?;
        Ok(Film {
            width,
            height,
            pixels: samples.iter().map(|s| developed(s.colour)).collect(),
        })
    }

    /// The error of a camera ray in doubles, against the exact ray through the centre of a pixel. This is the larger of
    /// two differences in a coordinate: of the direction, and of the origin, the latter divided by the origin's largest
    /// coordinate or 1.
    pub fn aside(&self, [x, y]: [u32; 2], origin: [f64; 3], direction: [f64; 3]) -> f64 {
        let right = self.lens.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let most = |a: [f64; 3], b: [T; 3]| {
            let off = (0..3).map(|i| (T::of(a[i]) - b[i]).abs().wide());
            off.fold(0.0, f64::max)
        };
        let far = origin.iter().fold(1.0, |far, x| f64::max(far, x.abs()));
        most(direction, right.direction).max(most(origin, right.origin) / far)
    }

    /// The colour that is seen along a ray.
    ///
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn along(&self, origin: [f64; 3], direction: [f64; 3]) -> Result<Rgb, Unfit> {
        let (scenery, mut solids) = self.ready()?;
        let ray = Ray {
            origin: each(origin, T::of),
            direction: each(direction, T::of),
        };
        let mut rays = RayCounts::default();
        let colour = radiance(&scenery, &mut solids, ray, false, &mut rays);
        match solids.is_exhausted() {
            true => Err(Unfit::TooManyParts),
            false => Ok(colour),
        }
    }

    /// Follows the rays through the centres of pixels, on all threads.
    ///
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn pixels(&self, pixels: &[[u32; 2]]) -> Result<Vec<Sample>, Unfit> {
        let centres: Vec<[f64; 2]> = (pixels.iter())
            .map(|p| p.map(|x| f64::from(x) + 0.5))
            .collect();
        self.samples(&centres)
    }

    /// Follows the rays through points of the picture, in pixels from its upper left corner, on all threads.
    ///
    /// # Errors
    ///
    /// The scene draws nothing, has too many or too deeply nested parts, or a singular matrix.
    pub fn samples(&self, places: &[[f64; 2]]) -> Result<Vec<Sample>, Unfit> {
        let chunk = places.len().div_ceil(rayon::current_num_threads()).max(1);
        let parts = parallel::map_each(places.chunks(chunk).collect(), |places: &[[f64; 2]]| {
            let (scenery, mut solids) = self.ready()?;
            let samples: Vec<Sample> = (places.iter())
                .map(|&[x, y]| {
                    let mut rays = RayCounts::default();
                    let ray = self.lens.ray(x, y);
                    let colour = radiance(&scenery, &mut solids, ray, false, &mut rays);
                    Sample { colour, rays }
                })
                .collect();
            match solids.is_exhausted() {
                true => Err(Unfit::TooManyParts),
                false => Ok(samples),
            }
        });
        let parts = parts
            .into_iter()
            .collect::<Result<Vec<Vec<Sample>>, Unfit>>()?;
        Ok(parts.concat())
    }
}
