//! zpg as a library: checks the scenes of a folder, draws a scene from all around, and counts what a ray crosses.
//!
//! `cargo run --example library -- scenes/gallery pictures`

use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use zpg::{
    Analysis, Camera, Language, Look, Packing, Ray, Settings, Tracer, Vec3, selected_camera,
    write_findings,
};

/// The pictures of an orbit, and their size in pixels.
const PICTURES: u32 = 8;
const SIZE: [u32; 2] = [160, 120];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("which folder has the scenes?")?;
    let pictures = PathBuf::from(arguments.next().ok_or("which folder gets the pictures?")?);
    fs::create_dir_all(&pictures)?;
    let mut paths: Vec<PathBuf> = fs::read_dir(&folder)?
        .map(|entry| entry.map(|e| e.path()))
        .collect::<Result<_, _>>()?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "zpg"));
    paths.sort();
    let mut drawn = None;
    for path in &paths {
        let analysis = Analysis::new(path.display().to_string(), fs::read(path)?);
        let look = Look {
            language: Language::English,
            ..Look::default()
        };
        write_findings(
            &mut io::stdout(),
            &analysis.source,
            analysis.findings(),
            look,
        )?;
        // An image texture needs its picture, which `Tracer::with_images` takes.
        drawn = drawn.or_else(|| Some((Tracer::new(&analysis.scene).ok()?, analysis)));
    }
    let (tracer, analysis) = drawn.ok_or("no scene there can be drawn")?;
    let camera = selected_camera(&analysis.scene, f64::from(SIZE[0]) / f64::from(SIZE[1]));
    orbit(&tracer, &camera, &pictures)?;
    let ray = Ray::new(Vec3(camera.position), Vec3(camera.direction));
    let probe = tracer.probe(&mut tracer.walker(), &ray);
    println!(
        "the camera's axis crosses {} boundaries",
        probe.crossings.len()
    );
    Ok(())
}

/// Draws a scene from all around the y axis.
fn orbit(tracer: &Tracer, camera: &Camera, folder: &Path) -> Result<(), Box<dyn Error>> {
    let [width, height] = SIZE;
    let settings = Settings {
        width,
        height,
        ..Settings::default()
    };
    for i in 0..PICTURES {
        let angle = TAU * f64::from(i) / f64::from(PICTURES);
        let turned = Camera {
            position: about_y(camera.position, angle),
            direction: about_y(camera.direction, angle),
            up: about_y(camera.up, angle),
            ..*camera
        };
        let picture = tracer.render(&turned, &settings, || ())?;
        let file = fs::File::create(folder.join(format!("{i}.png")))?;
        picture.film.write_png(file, Packing::Quick)?;
    }
    Ok(())
}

/// A vector turned about the y axis, in radians.
fn about_y([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x + sin * z, y, cos * z - sin * x]
}
