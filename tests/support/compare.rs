//! Our picture of a scene and POV-Ray's, pixel by pixel.

use std::path::Path;

use super::povray;
use zpg::scene::{Camera, Rgb, Scene, View};
use zpg::trace::{Images, Picture, Settings, Tracer, selected_camera};
use zpg::translate::pov::{self, Options, Translation};

/// Pixels may differ by so much.
pub const BAR: f64 = 2.0 / 255.0;
/// A pixel that changes by more than half the bar within this part of a pixel lies on an edge.
const NEAR: f64 = 0.02;

/// How two pictures compare.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    pub pixels: u32,
    pub edges: u32,
    /// Off edges, with total reflection.
    pub total: u32,
    /// Off edges and without total reflection, more than the bar apart.
    pub wrong: Vec<(u32, u32, Rgb, Rgb)>,
    /// The largest difference off edges and without total reflection.
    pub worst: f64,
}

impl Outcome {
    pub fn share(&self) -> f64 {
        self.wrong.len() as f64 / f64::from(self.pixels)
    }
}

pub fn difference(a: Rgb, b: Rgb) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

/// The cameras that take the pictures of a scene.
fn cameras(scene: &Scene, size: (u32, u32)) -> Vec<Camera> {
    match scene.view {
        View::Stereo { left, right } => vec![scene.cameras[left], scene.cameras[right]],
        _ => vec![selected_camera(
            scene,
            f64::from(size.0) / f64::from(size.1),
        )],
    }
}

/// The camera with its picture moved by so many pixels; a camera with a projection matrix moves it
/// in the clip cube.
fn moved(camera: &Camera, size: (u32, u32), dx: f64, dy: f64) -> Camera {
    let (w, h) = (f64::from(size.0), f64::from(size.1));
    if let Some(p) = &camera.projection {
        let shift = zpg::scene::Matrix::translation(2.0 * dx / w, 2.0 * dy / h, 0.0);
        return Camera {
            projection: Some(shift.after(p)),
            ..*camera
        };
    }
    let basis = zpg::scene::frame::Basis::of(camera).expect("a camera");
    let pixel = 2.0 * (camera.fovy.to_radians() / 2.0).tan() / h;
    let direction = std::array::from_fn(|i| {
        basis.forward[i] + pixel * (dx * basis.right[i] + dy * basis.up[i])
    });
    Camera {
        direction,
        up: basis.up,
        ..*camera
    }
}

/// Compares all pictures of a scene. The scene's images are in `folder`.
pub fn compare(name: &str, scene: &Scene, folder: &Path, size: (u32, u32)) -> Vec<Outcome> {
    let options = Options {
        size,
        pictures: format!("{}/", folder.display()),
        ..Options::default()
    };
    let translation = pov::write(scene, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
    let images = Images::load(scene, folder).unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let tracer = Tracer::with_images(scene, &images).unwrap_or_else(|e| panic!("{name}: {e}"));
    let settings = Settings {
        width: size.0,
        height: size.1,
        depth: options.depth,
        cutoff: 0.0,
        ..Settings::default()
    };
    let cameras = cameras(scene, size);
    assert_eq!(cameras.len(), translation.files.len());
    cameras
        .iter()
        .enumerate()
        .map(|(i, camera)| {
            let take = |dx: f64, dy: f64| {
                tracer
                    .render(&moved(camera, size, dx, dy), &settings, || ())
                    .unwrap_or_else(|e| panic!("{name}: {e}"))
            };
            let ours = tracer.render(camera, &settings, || ()).expect("a camera");
            let near = [(NEAR, NEAR), (-NEAR, NEAR), (NEAR, -NEAR), (-NEAR, -NEAR)]
                .map(|(dx, dy)| take(dx, dy));
            outcome(name, &translation, i, size, &ours, &near)
        })
        .collect()
}

fn outcome(
    name: &str,
    translation: &Translation,
    file: usize,
    size: (u32, u32),
    ours: &Picture,
    near: &[Picture; 4],
) -> Outcome {
    let label = format!("{name}{}", translation.files[file].suffix);
    let theirs = povray::render(&label, translation, file, size);
    let mut out = Outcome {
        pixels: size.0 * size.1,
        ..Outcome::default()
    };
    let mut difference_map = Vec::new();
    for y in 0..size.1 {
        for x in 0..size.0 {
            let i = (y * size.0 + x) as usize;
            let of = |p: &Picture| p.film.pixel(x, y).map(f64::from);
            let here = of(ours);
            // What a file cannot hold.
            let most = 1.0 / translation.light_scale;
            let held = here.map(|c| c.clamp(0.0, most));
            let d = difference(theirs.pixels[i], held);
            let edge = near.iter().any(|p| difference(of(p), here) > BAR / 2.0);
            let total = ours.total_reflection[i] || near.iter().any(|p| p.total_reflection[i]);
            difference_map.push(match (edge, total, d > BAR) {
                (true, _, _) => [60, 60, 60],
                (_, true, _) => [0, 0, 120],
                (_, _, true) => [255, 0, 0],
                _ => [0, (d / BAR * 200.0) as u8, 0],
            });
            match (edge, total) {
                (true, _) => out.edges += 1,
                (_, true) => out.total += 1,
                _ => {
                    out.worst = out.worst.max(d);
                    if d > BAR {
                        out.wrong.push((x, y, theirs.pixels[i], held));
                    }
                }
            }
        }
    }
    side_by_side(&label, size, ours, &theirs, &difference_map);
    out
}

/// Ours, theirs and the difference in one picture, to be looked at.
fn side_by_side(
    label: &str,
    size: (u32, u32),
    ours: &Picture,
    theirs: &povray::Picture,
    map: &[[u8; 3]],
) {
    let srgb = |c: f64| {
        let c = c.clamp(0.0, 1.0);
        let e = if c <= 0.003_130_8 {
            12.92 * c
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        };
        (e * 255.0).round() as u8
    };
    let mut rows = image::RgbImage::new(3 * size.0, size.1);
    for y in 0..size.1 {
        for x in 0..size.0 {
            let i = (y * size.0 + x) as usize;
            let here = ours.film.pixel(x, y).map(f64::from);
            rows.put_pixel(x, y, image::Rgb(here.map(srgb)));
            rows.put_pixel(size.0 + x, y, image::Rgb(theirs.pixels[i].map(srgb)));
            rows.put_pixel(2 * size.0 + x, y, image::Rgb(map[i]));
        }
    }
    let path = povray::folder().join(format!("{label}_compared.png"));
    rows.save(path).expect("a writable target folder");
}
