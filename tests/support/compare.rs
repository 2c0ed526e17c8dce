//! Our picture of a scene and POV-Ray's, pixel by pixel.

use std::path::Path;

use super::{povray, takes_part};
use zpg::internals::analysis::Analysis;
use zpg::internals::scene::{Camera, Scene};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::study::compare::Comparison;
use zpg::internals::trace::{Images, Settings, Tracer};
use zpg::internals::translate::pov::{self, Options, pictures::Pictures};

/// Pixels may differ by so much.
pub const BAR: f64 = 2.0 / 255.0;

/// Compares all pictures of a scene. The scene's images are in `folder`; the differences stay in the
/// target folder, to be looked at.
pub fn compare(name: &str, scene: &Scene, folder: &Path, size: (u32, u32)) -> Vec<Comparison> {
    let options = Options {
        size,
        pictures: Pictures::InPlace(folder.to_owned()),
        ..Options::default()
    };
    let translation =
        pov::write(scene, &node_bounds(scene), &options).unwrap_or_else(|e| panic!("{name}: {e}"));
    let scene = &*staged(
        scene,
        Viewpoint::Scene,
        f64::from(size.0) / f64::from(size.1),
    );
    let images = Images::load(scene, folder).unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let tracer = Tracer::with_images(scene, &images).unwrap_or_else(|e| panic!("{name}: {e}"));
    let settings = Settings {
        width: size.0,
        height: size.1,
        depth: options.depth,
        cutoff: 0.0,
        ..Settings::default()
    };
    let cameras: Vec<Camera> = scene.chosen_cameras().copied().collect();
    assert_eq!(cameras.len(), translation.files.len());
    let mut all = Vec::new();
    for (i, camera) in cameras.iter().enumerate() {
        let label = format!("{name}{}", translation.files[i].suffix);
        let theirs = povray::film(&label, &translation, i, size);
        let most = (1.0 / translation.light_scale) as f32;
        let look = (&tracer, camera, &settings);
        let (comparison, _) = Comparison::of(look, &theirs, most, BAR, || ())
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        let path = povray::folder().join(format!("{label}_difference.png"));
        let rgb = image::ExtendedColorType::Rgb8;
        image::save_buffer(path, &comparison.picture(), size.0, size.1, rgb)
            .expect("a writable target folder");
        all.push(comparison);
    }
    all
}

/// One scene of so many of the long tables of scenes is compared, see [`takes_part`].
const EVERY: u64 = 4;

/// All pixels agree but for those on silhouettes.
pub fn agrees(name: &str, loaded: &Analysis) {
    if !takes_part(name, EVERY) {
        return;
    }
    for outcome in compare(name, &loaded.scene, Path::new("."), (96, 72)) {
        assert_eq!(outcome.differing.off_silhouettes, 0, "{name}");
    }
}

/// As the bar for scenes has it.
pub fn nearly_agrees(name: &str, loaded: &Analysis) {
    if !takes_part(name, EVERY) {
        return;
    }
    for outcome in compare(name, &loaded.scene, Path::new("."), (96, 72)) {
        let share = outcome.differing.share_off_silhouettes;
        assert!(share <= 0.0005, "{name}: {share}");
    }
}
