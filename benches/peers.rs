//! Two other programs on the same rays: POV-Ray's torus with and without `sturm`, and Mitsuba's sphere and triangles in
//! single precision. What each sees through the middle of every pixel, the shape or nothing, is held against the
//! independent tracer in numbers of 71 digits.
//!
//! `cargo bench --bench peers` prints a table; with `MITSUBA` a Python that has Mitsuba, else `python3` is asked. See
//! benches/README.md.

use std::path::Path;
use std::sync::Arc;

use zpg::internals::analysis::Analysis;
use zpg::internals::scene::{Camera, Scene};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::solids::staging::Viewpoint;
use zpg::internals::study::accuracy::configurations::{Kernel, Settings};
use zpg::internals::study::accuracy::runner::Runner;
use zpg::internals::study::accuracy::sample_tiles::{TILE, Tile};
use zpg::internals::study::naive::{Naive, Wide};
use zpg::internals::study::program::Program;
use zpg::internals::study::{mitsuba, povray};
use zpg::internals::syntax::Captions;
use zpg::internals::trace::{Images, Numbers, Tracer, selected_camera};
use zpg::internals::translate::mitsuba::{
    Integrator, Options as MitsubaOptions, write as to_mitsuba,
};
use zpg::internals::translate::pov::{Options as PovOptions, write as to_pov};

const SIZE: [u32; 2] = [160, 120];
/// So far the shapes are from the middle of the picture, lest rays meet them in what is special.
const ASIDE: [f64; 2] = [0.0123, -0.0456];

/// A shape, where its middle is and how wide it is seen; the camera is at the origin and looks along −z.
struct Case {
    name: &'static str,
    shape: &'static str,
    distance: f64,
    /// How far it is turned about the x axis, in degrees.
    turned: f64,
    fovy: f64,
}

const TORI: [Case; 6] = [
    case("torus of 4 and 1, at 12", "14 4 1", 12.0, 55.0, 50.0),
    case("the same, along its plane", "14 4 1", 12.0, 1.0, 50.0),
    case("torus of 4 and 0.01, at 12", "14 4 0.01", 12.0, 55.0, 50.0),
    case(
        "torus of 4 and 0.0001, at 12",
        "14 4 0.0001",
        12.0,
        55.0,
        50.0,
    ),
    case("torus of 4 and 1, at 1000", "14 4 1", 1e3, 55.0, 0.6),
    case("torus of 4 and 1, at 100 000", "14 4 1", 1e5, 55.0, 6e-3),
];

const SPHERES: [Case; 6] = [
    case("sphere of 1, at 3", "9 1", 3.0, 0.0, 50.0),
    case("sphere of 1, at 1000", "9 1", 1e3, 0.0, 0.16),
    case("sphere of 1, at 100 000", "9 1", 1e5, 0.0, 1.6e-3),
    case("geodesic sphere, level 5, at 3", "13 1 5", 3.0, 0.0, 50.0),
    case(
        "geodesic sphere, level 5, at 1000",
        "13 1 5",
        1e3,
        0.0,
        0.16,
    ),
    case(
        "geodesic sphere, level 5, at 100 000",
        "13 1 5",
        1e5,
        0.0,
        1.6e-3,
    ),
];

const fn case(
    name: &'static str,
    shape: &'static str,
    distance: f64,
    turned: f64,
    fovy: f64,
) -> Case {
    Case {
        name,
        shape,
        distance,
        turned,
        fovy,
    }
}

/// Of each pixel, row by row, whether the shape is seen.
type Silhouette = Vec<bool>;

/// A scene of a case, white on black.
struct Prepared {
    scene: Arc<Scene>,
    camera: Camera,
    images: Images,
    exact: Silhouette,
}

impl Prepared {
    fn of(case: &Case) -> Prepared {
        let text = format!(
            "2 {}\n2 -2 {:?} 1\n2 -1 {:?} {:?} {:?}\n3 -401 1\n4 -501 0 0 0 0 0 -1 0 1 0 {:?}\n1 9999 2 0\n",
            case.shape, case.turned, ASIDE[0], ASIDE[1], -case.distance, case.fovy
        );
        let loaded = Analysis::new(case.name, text.into_bytes());
        assert!(
            loaded.findings().iter().all(|d| !d.is_error()),
            "{:?}",
            loaded.findings()
        );
        let camera = selected_camera(&loaded.scene, f64::from(SIZE[0]) / f64::from(SIZE[1]));
        let images = Images::default();
        let naive = Naive::<Wide>::new(&loaded.scene, &images, &camera, SIZE, 1, 0.0);
        let pixels: Vec<[u32; 2]> = (0..SIZE[0] * SIZE[1])
            .map(|i| [i % SIZE[0], i / SIZE[0]])
            .collect();
        let samples = naive.and_then(|naive| naive.pixels(&pixels));
        let exact = samples
            .expect("one shape is traced")
            .iter()
            .map(|s| s.colour[1] > 0.5)
            .collect();
        Prepared {
            scene: Arc::new(loaded.scene.clone()),
            camera,
            images,
            exact,
        }
    }

    /// In how many pixels a silhouette is wrong.
    fn wrong(&self, seen: &Silhouette) -> usize {
        self.exact.iter().zip(seen).filter(|(a, b)| a != b).count()
    }

    fn kernel(&self, kernel: Kernel) -> usize {
        let mut tiles = Vec::new();
        for y in (0..SIZE[1]).step_by(TILE as usize) {
            for x in (0..SIZE[0]).step_by(TILE as usize) {
                tiles.push(Tile {
                    x,
                    y,
                    width: TILE,
                    height: TILE,
                });
            }
        }
        let settings = Settings {
            kernel,
            ..Settings::default()
        };
        let runner = Runner::new(self.scene.clone(), &self.images, self.camera, SIZE);
        let drawn = runner
            .and_then(|mut runner| runner.draw(&settings, &tiles))
            .expect("one shape is drawn");
        let mut seen = vec![false; self.exact.len()];
        for ([x, y], colour) in tiles.iter().flat_map(|t| t.pixels()).zip(&drawn.colours) {
            seen[(y * SIZE[0] + x) as usize] = colour[1] > 0.5;
        }
        self.wrong(&seen)
    }

    /// As a person writes it. A translation would move the scene to the origin, where numbers are fine.
    fn povray(&self, folder: &Path, case: &Case, sturm: bool) -> Option<usize> {
        let options = PovOptions {
            size: (SIZE[0], SIZE[1]),
            viewpoint: Viewpoint::Scene,
            ..PovOptions::default()
        };
        let mut translation = to_pov(&self.scene, &node_bounds(&self.scene), &options)
            .expect("one shape is translated");
        let up = 2.0 * (case.fovy.to_radians() / 2.0).tan();
        let right = up * f64::from(SIZE[0]) / f64::from(SIZE[1]);
        let [_, major, minor] = case.shape.split(' ').collect::<Vec<_>>()[..] else {
            panic!("a torus has two radii")
        };
        translation.files[0].text = format!(
            "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n\
             camera {{ location 0 direction <0, 0, -1> right <{right:?}, 0, 0> up <0, {up:?}, 0> }}\n\
             torus {{ {major}, {minor} {} rotate {:?}*x translate <{}, {}, {:?}> \
             pigment {{ rgb 1 }} finish {{ ambient 1 diffuse 0 }} }}\n",
            if sturm { "sturm" } else { "" },
            case.turned,
            ASIDE[0],
            ASIDE[1],
            -case.distance,
        );
        let program = &Program::new(povray::PROGRAM);
        let size = (SIZE[0], SIZE[1]);
        let film = povray::render(program, &translation, 0, size, folder, "peer").ok()?;
        Some(self.wrong(&film.pixels.iter().map(|p| p[1] > 0.5).collect()))
    }

    fn mitsuba(&self, folder: &Path, python: &Program) -> Option<usize> {
        let tracer = Tracer::new(&self.scene).expect("one shape is compiled");
        let options = MitsubaOptions {
            size: (SIZE[0], SIZE[1]),
            viewpoint: Viewpoint::Scene,
            depth: 1,
            tolerance: None,
            memory: None,
            integrator: Integrator::Aov,
            stem: "peer".to_owned(),
            captions: Captions::default(),
        };
        let mut made = to_mitsuba(&self.scene, &node_bounds(&self.scene), &tracer, &options)
            .expect("one shape is translated");
        // From the eye on. A translation has rays begin halfway, where single precision tells more.
        let near = "near_clip\" value=\"";
        let text = &mut made.documents[0].1;
        let at = text.find(near).expect("a camera sees from somewhere on") + near.len();
        let end = at + text[at..].find('"').expect("a value ends");
        text.replace_range(at..end, "0.01");
        let numbers = mitsuba::render(python, &made, 0, folder, "peer", 1).ok()?;
        let shapes = numbers.chunks_exact(mitsuba::CHANNELS).map(|c| c[6] > 0.5);
        Some(self.wrong(&shapes.collect()))
    }
}

fn main() {
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let python = std::env::var_os("MITSUBA").unwrap_or_else(|| mitsuba::PROGRAM.into());
    // It runs in another folder; a name without a folder is looked for where programs are.
    let python = std::path::absolute(&python)
        .ok()
        .filter(|p| p.exists())
        .unwrap_or(python.into());
    let shown = |wrong: Option<usize>| wrong.map_or("not installed".to_owned(), |n| n.to_string());
    let ours = |p: &Prepared| {
        [
            Kernel::PlainF32,
            Kernel::PlainF64,
            Kernel::Ours(Numbers::F32),
            Kernel::Ours(Numbers::F64),
        ]
        .map(|kernel| p.kernel(kernel).to_string())
        .join(" | ")
    };
    println!("Wrong pixels of {}, beside 71 digits.\n", SIZE[0] * SIZE[1]);
    println!(
        "| | POV-Ray | with `sturm` | plain-f32 | plain-f64 | f32 | f64 |\n|---|---:|---:|---:|---:|---:|---:|"
    );
    for case in &TORI {
        let p = Prepared::of(case);
        let [quick, sturm] = [false, true].map(|sturm| shown(p.povray(folder.path(), case, sturm)));
        println!("| {} | {quick} | {sturm} | {} |", case.name, ours(&p));
    }
    println!(
        "\n| | Mitsuba, `scalar_rgb` | plain-f32 | plain-f64 | f32 | f64 |\n|---|---:|---:|---:|---:|---:|"
    );
    for case in &SPHERES {
        let p = Prepared::of(case);
        let theirs = shown(p.mitsuba(folder.path(), &Program::new(&python)));
        println!("| {} | {theirs} | {} |", case.name, ours(&p));
    }
}
