//! A ray tracer as textbooks have it, over any kind of number: the quadratic formula with b² − 4ac, a
//! quartic in closed form, coefficients from the ray's origin wherever that is, and one constant distance
//! within which a ray does not see the surface it leaves.
//!
//! In `f32` and `f64` it shows what becomes of hard scenes. In [`Wide`] numbers of 71 digits all of this is
//! harmless, and it says what is right: it follows every ray of a pixel, from the camera record on, and
//! shares nothing with the tracer but the resolved scene and the decoded pictures of its textures.

pub mod boxes;
pub mod form;
pub mod light;
pub mod number;
pub mod polynomial;
pub mod solid;
pub mod trail;

pub use number::{Number, Wide};
pub use solid::Unfit;

use crate::parallel;
use crate::scene::{Camera, Rgb, Scene, Texture};
use crate::trace::film::developed;
use crate::trace::{Film, Images};
use light::{Lens, RayCounts, Scenery, radiance};
use solid::Solids;

/// A scene made ready, with its camera.
pub struct Naive<'s, T: Number> {
    scene: &'s Scene,
    images: &'s Images,
    lens: Lens<T>,
    size: [u32; 2],
    depth: u32,
    cutoff: f64,
}

/// What a place of the picture shows.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// Linear RGB.
    pub colour: Rgb,
    pub rays: RayCounts,
}

impl<'s, T: Number> Naive<'s, T> {
    /// # Errors
    ///
    /// What is too much for it.
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
        let mut scenery = Scenery::new(self.scene, &self.lens, self.depth, self.cutoff);
        scenery.records = (0..self.scene.shapes.len() as u32).collect();
        scenery.textures = (solids.textures.iter())
            .map(|&texture| match texture {
                Texture::Image { file, .. } => (texture, self.images.get(file).cloned()),
                _ => (texture, None),
            })
            .collect();
        Ok((scenery, solids))
    }

    /// The whole picture; what is no number is black.
    ///
    /// # Errors
    ///
    /// What is too much for it.
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

    /// By how much the colour of a pixel changes, at most, where the direction of its ray is off by what
    /// doubles round it by.
    ///
    /// # Errors
    ///
    /// What is too much for it.
    pub fn sway(&self, [x, y]: [u32; 2]) -> Result<f64, Unfit> {
        let (scenery, mut solids) = self.ready()?;
        let mut rays = RayCounts::default();
        let ray = self.lens.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let middle = radiance(&scenery, &mut solids, ray, false, &mut rays);
        let mut most = 0.0;
        for i in 0..6 {
            let mut ray = ray;
            let by = f64::EPSILON * if i < 3 { 1.0 } else { -1.0 };
            ray.direction[i % 3] = ray.direction[i % 3] + T::of(by);
            let beside = radiance(&scenery, &mut solids, ray, false, &mut rays);
            let off = (0..3).map(|c| (middle[c] - beside[c]).abs());
            most = off.fold(most, f64::max);
        }
        Ok(most)
    }

    /// Follows the rays through the centres of pixels, on all threads.
    ///
    /// # Errors
    ///
    /// What is too much for it.
    pub fn pixels(&self, pixels: &[[u32; 2]]) -> Result<Vec<Sample>, Unfit> {
        let centres: Vec<[f64; 2]> = (pixels.iter())
            .map(|p| p.map(|x| f64::from(x) + 0.5))
            .collect();
        self.samples(&centres)
    }

    /// Follows the rays through places of the picture, in pixels from its upper left corner, on all threads.
    ///
    /// # Errors
    ///
    /// What is too much for it.
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
