//! A picture, row by row.

use super::camera::View;
use super::film::{Film, developed};
use super::plan::Effect;
use super::ray::Ray;
use super::sampling::sample;
use super::shade::{DISPERSION, GLASS, Light, Limits, MIRROR, SHADOWS, Shader};
use super::stats::Counts;
use super::vec::Vec3;
use super::{Tracer, Unsupported};
use crate::scene::{Camera, Rgb, Scene, frame};
use rayon::prelude::*;
use std::ops::Range;

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crop {
    pub x: u32,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

/// How a picture is taken.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Size of the whole picture in pixels, at least 1 × 1.
    pub width: u32,
    pub height: u32,
    /// The part of it that is drawn, within the picture; all of it where there is none.
    pub crop: Option<Crop>,
    /// Per pixel, at least 1.
    pub samples: u32,
    /// Rays deeper than this contribute nothing; a camera ray has depth 0.
    pub depth: u32,
    /// Branches that count for less than this contribute nothing; 0: all do.
    pub cutoff: f64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            width: 640,
            height: 480,
            crop: None,
            samples: 1,
            depth: 10,
            cutoff: 1.0 / 4096.0,
        }
    }
}

/// A film and what it has cost.
pub struct Picture {
    pub film: Film,
    pub counts: Counts,
}

/// The camera a scene is seen by: the selected one, or one that frames the scene. Of a stereo pair
/// the left one.
pub fn selected_camera(scene: &Scene, aspect: f64) -> Camera {
    use crate::scene::View::{Automatic, Mono, Stereo};
    let selected = match scene.view {
        Automatic => None,
        Mono(i) => scene.cameras.get(i),
        Stereo { left, .. } => scene.cameras.get(left),
    };
    match selected {
        Some(camera) => *camera,
        None => {
            let bounds = crate::scene::bounds::node_bounds(scene);
            frame::automatic_camera(scene, &bounds, aspect)
        }
    }
}

impl Tracer {
    /// What the plan calls for, as bits. From inside of a lone shape its other side is in the way.
    fn features(&self, outside: bool) -> u8 {
        let plan = &self.plan;
        let inside = plan.lone_convex && !outside;
        [
            (SHADOWS, plan.on(Effect::Shadows) || inside),
            (GLASS, plan.on(Effect::Refraction)),
            (MIRROR, plan.on(Effect::Reflection)),
            (DISPERSION, plan.on(Effect::Dispersion)),
        ]
        .into_iter()
        .fold(0, |bits, (bit, on)| if on { bits | bit } else { bits })
    }

    /// Takes a picture. `progress` is told of every finished row, from any thread.
    ///
    /// Every pixel is computed from the scene and its own place alone, so the result does not
    /// depend on the number of threads.
    ///
    /// # Errors
    ///
    /// A camera that cannot take pictures: see [`View::new`].
    pub fn render(
        &self,
        camera: &Camera,
        settings: &Settings,
        progress: impl Fn() + Sync,
    ) -> Result<Picture, Unsupported> {
        let Settings { width, height, .. } = *settings;
        let view = View::new(camera, width, height).ok_or_else(|| Unsupported {
            what: "what a camera with this projection sees".into(),
            span: Default::default(),
            id: camera.id,
        })?;
        let headlight = [Light {
            position: view.position(),
            power: Vec3::ONE,
        }];
        let lights = self.lights.as_deref().unwrap_or(&headlight);
        let limits = Limits {
            depth: settings.depth,
            cutoff: settings.cutoff,
        };
        let outside = self.clip.is_none()
            && view.is_pinhole()
            && !self.holds(&mut self.walker(), view.position());
        let crop = settings.crop.unwrap_or(Crop {
            x: 0,
            y: 0,
            width,
            height,
        });
        let radiance = radiance(self.features(outside));
        let columns = crop.x..crop.x + crop.width;
        let rows: Vec<(Vec<[f32; 3]>, Counts)> = (crop.y..crop.y + crop.height)
            .into_par_iter()
            .map_init(
                || Shader::new(self, lights, limits),
                |shader, y| {
                    shader.reset();
                    let row = draw_row(
                        |mut ray| {
                            ray.outside = outside;
                            radiance(shader, ray)
                        },
                        &view,
                        columns.clone(),
                        y,
                        settings.samples,
                    );
                    progress();
                    (row, shader.counts())
                },
            )
            .collect();
        let mut counts = Counts::default();
        let mut pixels = Vec::with_capacity(crop.width as usize * crop.height as usize);
        for (row, cost) in rows {
            pixels.extend(row);
            counts += cost;
        }
        Ok(Picture {
            film: Film {
                width: crop.width,
                height: crop.height,
                pixels,
            },
            counts,
        })
    }
}

/// The shading code for these features.
fn radiance<'t>(features: u8) -> fn(&mut Shader<'t>, Ray) -> Rgb {
    macro_rules! table {
        ($($f:literal)*) => {
            [$(Shader::radiance::<$f>),*]
        };
    }
    let table: [fn(&mut Shader<'t>, Ray) -> Rgb; 16] =
        table!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
    table[usize::from(features) % table.len()]
}

fn draw_row(
    mut radiance: impl FnMut(Ray) -> Rgb,
    view: &View,
    columns: Range<u32>,
    y: u32,
    samples: u32,
) -> Vec<[f32; 3]> {
    let samples = samples.max(1);
    columns
        .map(|x| {
            let mut sum = Vec3::ZERO;
            for i in 0..samples {
                let [dx, dy] = sample(x, y, i, samples);
                // Where a projection has no ray there is nothing to be seen.
                if let Some(ray) = view.ray(f64::from(x) + dx, f64::from(y) + dy) {
                    sum = sum + Vec3(radiance(ray));
                }
            }
            developed((sum / f64::from(samples)).0)
        })
        .collect()
}
