//! The pictures of `scenes/hard`: a scene drawn with the textbook's ray tracer in single and in double precision and
//! with the program, beside each other.

use std::fs;
use std::path::Path;
use zpg::internals::analysis::Analysis;
use zpg::internals::scene::{Camera, Scene};
use zpg::internals::study::naive::{Naive, Number};
use zpg::internals::trace::film::Film;
use zpg::internals::trace::{Images, Settings, Tracer, selected_camera};

pub const SIZE: [u32; 2] = [160, 128];
/// Pixels between the pictures of one scene.
pub const GAP: u32 = 4;

pub type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// A scene with the textbook's methods in single and double precision, and with the program.
pub fn draw(path: &Path) -> Outcome<[Film; 3]> {
    let loaded = Analysis::new(path.to_string_lossy(), fs::read(path)?);
    if !loaded.is_sound() {
        return Err("the scene has errors".into());
    }
    let [width, height] = SIZE;
    let camera = selected_camera(&loaded.scene, f64::from(width) / f64::from(height));
    let settings = Settings {
        width,
        height,
        ..Settings::default()
    };
    let ours = Tracer::new(&loaded.scene)?.render(&camera, &settings, || ())?;
    Ok([
        textbook::<f32>(&loaded.scene, &camera)?,
        textbook::<f64>(&loaded.scene, &camera)?,
        ours.film,
    ])
}

fn textbook<T: Number>(scene: &Scene, camera: &Camera) -> Outcome<Film> {
    let Settings { depth, cutoff, .. } = Settings::default();
    let images = Images::default();
    let naive = Naive::<T>::new(scene, &images, camera, SIZE, depth, cutoff);
    let film = naive.and_then(|naive| naive.film());
    Ok(film.map_err(|why| format!("{why:?}"))?)
}

/// The pictures in a row, with white between them.
pub fn beside(films: &[Film; 3]) -> Film {
    let [width, height] = SIZE;
    let row = |film: &Film, y: u32| {
        let start = (y * width) as usize;
        film.pixels[start..start + width as usize].to_vec()
    };
    let gap = vec![[1.0; 3]; GAP as usize];
    let rows = (0..height).map(|y| films.each_ref().map(|film| row(film, y)).join(&gap[..]));
    Film {
        width: 3 * width + 2 * GAP,
        height,
        pixels: rows.flatten().collect(),
    }
}
