//! The tracer beside the plain kernel: what certainty costs.

use cpu_time::ThreadTime;
use zpg::internals::analysis::Analysis;
use zpg::internals::study::plain::{self, Plain};
use zpg::internals::trace::pixels::Pixels;
use zpg::internals::trace::{Numbers, Settings, Tracer, selected_camera};

use super::scenes::Scene;
use super::{Bars, SIZE};

const RUNS: usize = 3;
/// Certified doubles take at most this many times as long as plain ones.
const CERTAINTY: f64 = 1.15;

/// All pixels on this thread: processor seconds.
fn drawn(pixels: &mut dyn Pixels) -> f64 {
    let start = ThreadTime::now();
    let [across, down] = [SIZE[0] / 8, SIZE[1] / 8];
    for tile in 0..across * down {
        let [left, top] = [tile % across * 8, tile / across * 8];
        let places: Vec<[u32; 2]> = (0..64).map(|i| [left + i % 8, top + i / 8]).collect();
        std::hint::black_box(pixels.sums(&places, 0..1, 1));
    }
    start.elapsed().as_secs_f64()
}

/// Prints a line a scene. Of those that the plain kernel cannot draw it says so.
pub fn certainty(scenes: &[&Scene], bars: &mut Bars) {
    println!("\n| pixels alone | plain-f64, s | f64, s | ratio | bar | dd, s | |");
    println!("|---|---:|---:|---:|---:|---:|---|");
    for scene in scenes {
        let loaded = Analysis::new(&scene.name, scene.text.clone().into_bytes());
        let tracer = Tracer::new(&loaded.scene).expect("the scene can be drawn");
        let camera = selected_camera(&loaded.scene, f64::from(SIZE[0]) / f64::from(SIZE[1]));
        let settings = |numbers| Settings {
            width: SIZE[0],
            height: SIZE[1],
            numbers,
            ..Settings::default()
        };
        let ours = |numbers| {
            let settings = settings(numbers);
            let stage = tracer.stage(&settings);
            let drawn = tracer.pixels(&camera, &settings, stage.as_ref(), drawn);
            drawn.expect("the camera takes pictures")
        };
        if let Err(why) = plain::fits(&tracer, &loaded.scene) {
            println!("| {} | {why} | | | | | |", scene.name);
            continue;
        }
        let mut least = [f64::INFINITY; 2];
        for _ in 0..RUNS {
            let (scene, settings) = (&loaded.scene, settings(Numbers::F64));
            let plain = Plain::<f64>::pixels((scene, &tracer, &camera), &settings, drawn);
            let plain = plain.expect("the kernel draws what fits");
            least = [least[0].min(plain), least[1].min(ours(Numbers::F64))];
        }
        let ratio = least[1] / least[0];
        println!(
            "| {} | {:.2} | {:.2} | {ratio:.2} | {CERTAINTY} | {:.2} | {} |",
            scene.name,
            least[0],
            least[1],
            ours(Numbers::Dd),
            bars.judge(ratio <= CERTAINTY)
        );
    }
}
