//! One scene, three pictures: the real POV-Ray's of the translation, our tracer's, and that of an
//! independent evaluator. They must agree pixel by pixel.

use crate::support;
use crate::trace_support::Builder;
use std::path::Path;
use support::povray;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::{Camera, Scene, Texture, View};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::solids::staging::{Viewpoint, staged};
use zpg::internals::study::naive::Naive;
use zpg::internals::trace::{Images, Settings, Tracer};
use zpg::internals::translate::pov::{self, Options, Stereo, Translation};

const SIZE: (u32, u32) = (96, 72);
/// Pixels may differ by so much.
const BAR: f64 = 2.0 / 255.0;
/// A pixel whose value changes by more than the bar within this part of a pixel lies on an edge.
const EDGE_WIDTH_PIXELS: f64 = 0.02;

/// The tracer and the evaluator may differ by so much: the evaluator leaves surfaces by a fixed distance, which shows
/// in tiny scenes.
const EVALUATOR_BAR: f64 = BAR;

/// Renders a scene with all three and compares all pixels off edges; those with total reflection,
/// where POV-Ray is known to differ, without POV-Ray.
fn compare(name: &str, scene: &Scene) {
    let options = Options {
        size: SIZE,
        ..Options::default()
    };
    let translation = pov::write(scene, &node_bounds(scene), &options).expect("a translation");
    let staged = staged(
        scene,
        Viewpoint::Scene,
        f64::from(SIZE.0) / f64::from(SIZE.1),
    );
    let camera = *staged.chosen_cameras().next().expect("a camera");
    compare_view(name, &staged, &translation, camera);
}

/// Compares what one camera sees.
fn compare_view(name: &str, scene: &Scene, translation: &Translation, camera: Camera) {
    let theirs = povray::render(name, translation, 0, SIZE);
    assert_eq!(theirs.size, SIZE);
    let depth = Options::default().depth;
    let images = Images::default();
    let naive = Naive::<f64>::new(scene, &images, &camera, [SIZE.0, SIZE.1], depth, 0.0).unwrap();
    // Each pixel's centre, and four places around it.
    let around = [
        (0.0, 0.0),
        (EDGE_WIDTH_PIXELS, EDGE_WIDTH_PIXELS),
        (-EDGE_WIDTH_PIXELS, EDGE_WIDTH_PIXELS),
        (EDGE_WIDTH_PIXELS, -EDGE_WIDTH_PIXELS),
        (-EDGE_WIDTH_PIXELS, -EDGE_WIDTH_PIXELS),
    ];
    let places: Vec<[f64; 2]> = (0..SIZE.0 * SIZE.1)
        .flat_map(|i| {
            let [x, y] = [i % SIZE.0, i / SIZE.0].map(|x| f64::from(x) + 0.5);
            around.map(|(dx, dy)| [x + dx, y + dy])
        })
        .collect();
    let evaluated = naive.samples(&places).unwrap();
    let settings = Settings {
        width: SIZE.0,
        height: SIZE.1,
        depth,
        cutoff: 0.0,
        ..Settings::default()
    };
    let ours = Tracer::new(scene)
        .and_then(|t| t.render(&camera, &settings, || ()))
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let (mut edges, mut total, mut wrong, mut worst) = (0, 0, Vec::new(), 0.0f64);
    let mut unlike = Vec::new();
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for y in 0..SIZE.1 {
        for x in 0..SIZE.0 {
            let at = (y * SIZE.0 + x) as usize * around.len();
            let samples = &evaluated[at..at + around.len()];
            let here = samples[0].colour;
            let traced = ours.film.pixel(x, y).map(f64::from);
            let on_edge = samples
                .iter()
                .any(|s| difference(s.colour, here) > BAR / 2.0);
            if !on_edge && difference(traced, here) > EVALUATOR_BAR {
                unlike.push((x, y, traced, here));
            }
            if samples.iter().any(|s| s.rays.totally_reflected > 0) {
                total += 1;
                continue;
            }
            if on_edge {
                edges += 1;
                continue;
            }
            let pixel = theirs.pixels[(y * SIZE.0 + x) as usize];
            let d = difference(pixel, traced);
            worst = worst.max(d);
            range = [range[0].min(here[1]), range[1].max(here[1])];
            if d > BAR {
                wrong.push((x, y, pixel, traced));
            }
        }
    }
    println!(
        "{name}: worst {:.2}/255, {} wrong, {edges} on edges, {total} with total reflection, green {range:.2?}",
        worst * 255.0,
        wrong.len()
    );
    assert!(range[1] > range[0], "{name}: the picture is empty");
    let pixels = SIZE.0 * SIZE.1;
    assert!(
        edges < pixels / 5,
        "{name}: {edges} of {pixels} pixels on edges"
    );
    assert!(
        unlike.is_empty(),
        "{name}: {} pixels of the tracer differ, as (x, y, traced, evaluated): {:.6?}",
        unlike.len(),
        &unlike[..unlike.len().min(5)]
    );
    assert!(
        wrong.is_empty(),
        "{name}: {} pixels differ, as (x, y, povray, ours): {:.4?}\n{}",
        wrong.len(),
        &wrong[..wrong.len().min(5)],
        translation.report
    );
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

const RED: [f64; 3] = [0.9, 0.2, 0.1];
const GREEN: [f64; 3] = [0.2, 0.8, 0.3];
const BLUE: [f64; 3] = [0.2, 0.3, 0.9];

#[test]
#[ignore = "needs POV-Ray"]
fn opaque_shapes() {
    let mut m = Builder::lit();
    let a = m.sphere([-1.2, 0.0, 0.0], 1.0);
    let a = m.coloured(a, RED);
    let b = m.cuboid([0.2, -1.0, -1.0], [1.6, 0.6, 0.5]);
    let b = m.moved(b, Matrix::rotation(30.0, 1));
    let b = m.coloured(b, GREEN);
    let c = m.rectangle([-1.0, 0.0], [1.0, 1.0]);
    let turn = Matrix::translation(0.0, 0.8, -2.0).after(&Matrix::rotation(-20.0, 0));
    let c = m.moved(c, turn);
    let ab = m.union(a, b);
    let all = m.union(ab, c);
    let root = m.on_floor(all);
    compare("opaque_shapes", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn mirrors() {
    let mut m = Builder::lit();
    let a = m.sphere([-1.0, 0.0, 0.0], 1.2);
    let a = m.coloured(a, RED);
    let a = m.mono(a, 0.3, 0.6, 0.0);
    let b = m.cuboid([0.7, -1.2, -1.0], [1.9, 0.6, 0.5]);
    let b = m.optics(b, [0.1, 0.5, 0.2], [0.9, 0.3, 0.5], [0.0; 3]);
    let ab = m.union(a, b);
    let root = m.on_floor(ab);
    compare("mirrors", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn glass_with_index() {
    let mut m = Builder::lit();
    let a = m.sphere([0.0; 3], 1.2);
    let a = m.coloured(a, GREEN);
    let a = m.mono(a, 0.2, 0.2, 0.6);
    let a = m.index(a, [1.3; 3]);
    let root = m.on_floor(a);
    compare("glass_with_index", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn dispersion() {
    let mut m = Builder::lit();
    let a = m.sphere([0.0; 3], 1.2);
    let a = m.mono(a, 0.1, 0.1, 0.8);
    let a = m.index(a, [1.2, 1.35, 1.5]);
    let root = m.on_floor(a);
    compare("dispersion", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn coloured_transmission_and_shadows() {
    let mut m = Builder::lit();
    let a = m.sphere([0.3, 0.6, 0.5], 1.0);
    let a = m.coloured(a, GREEN);
    let a = m.optics(a, [0.3, 0.1, 0.2], [0.1, 0.2, 0.0], [0.5, 0.6, 0.3]);
    let b = m.rectangle([-2.0, -1.0], [0.0, 1.0]);
    let b = m.moved(b, Matrix::translation(0.0, 0.3, -1.0));
    let b = m.optics(b, [0.4; 3], [0.0; 3], [0.1, 0.6, 0.6]);
    let ab = m.union(a, b);
    let root = m.on_floor(ab);
    compare("coloured_transmission", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn checkers_on_each_shape() {
    let mut m = Builder::lit();
    let a = m.sphere([0.3, 0.2, 0.0], 0.9);
    let turn = Matrix::translation(-1.6, 0.0, 0.0).after(&Matrix::rotation(50.0, 2));
    let a = m.moved(a, turn);
    let a = m.checkered(a, 7, 5);
    let b = m.cuboid([0.1, -0.7, -0.9], [1.3, 0.9, 0.5]);
    let b = m.moved(b, Matrix::rotation(30.0, 1));
    let b = m.checkered(b, 3, 5);
    let c = m.rectangle([-1.0, 0.5], [2.0, 1.8]);
    let c = m.moved(c, Matrix::translation(0.0, 0.0, -2.0));
    let c = m.checkered(c, 6, 2);
    let d = m.half_space([1.0, 0.5, 2.0, 12.0]);
    let d = m.checkered(d, 1, 2);
    let ab = m.union(a, b);
    let cd = m.union(c, d);
    let all = m.union(ab, cd);
    let root = m.on_floor(all);
    compare("checkers", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn all_faces_of_a_box() {
    for (name, turn) in [
        ("box_below", Matrix::rotation(110.0, 0)),
        ("box_behind", Matrix::rotation(160.0, 1)),
        ("box_left", Matrix::rotation(70.0, 1)),
    ] {
        let mut m = Builder::lit();
        let b = m.cuboid([-1.0, -0.7, -0.9], [1.2, 1.1, 0.9]);
        let b = m.checkered(b, 3, 5);
        let b = m.moved(b, turn);
        compare(name, &m.done(b));
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn solid_texture_stays_where_it_was_given() {
    let mut m = Builder::lit();
    let a = m.cuboid([-1.0; 3], [1.0; 3]);
    let a = m.moved(a, Matrix::rotation(25.0, 1));
    let texture = Texture::Solid {
        colours: [RED, BLUE],
        size: 0.4,
    };
    let a = m.textured(a, texture.clone());
    let a = m.moved(a, Matrix::rotation(25.0, 2));
    // Given to a whole whose parts have optics of their own.
    let b = m.sphere([1.5, 1.0, 0.0], 0.6);
    let b = m.mono(b, 0.7, 0.2, 0.0);
    let c = m.sphere([2.0, 0.0, 0.0], 0.6);
    let c = m.moved(c, Matrix::rotation(20.0, 2));
    let bc = m.union(b, c);
    let bc = m.textured(bc, texture);
    let ab = m.union(a, bc);
    let root = m.on_floor(ab);
    compare("solid_texture", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn operations_on_painted_operands() {
    let mut m = Builder::lit();
    let a = m.sphere([-1.2, 0.0, 0.0], 1.0);
    let a = m.coloured(a, RED);
    let b = m.cuboid([-1.2, -0.6, -0.6], [0.6, 0.6, 0.6]);
    let b = m.coloured(b, GREEN);
    let i = m.intersection(a, b);
    let c = m.sphere([1.2, 0.2, 0.0], 1.0);
    let c = m.coloured(c, BLUE);
    let d = m.sphere([1.2, 0.6, 0.9], 0.8);
    let d = m.coloured(d, RED);
    let cd = m.difference(c, d);
    let all = m.union(i, cd);
    let root = m.on_floor(all);
    compare("operations", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn a_painted_union_is_cut() {
    let mut m = Builder::lit();
    let a = m.sphere([-0.7, 0.0, 0.0], 1.0);
    let a = m.coloured(a, RED);
    let b = m.cuboid([0.0, -0.9, -0.9], [1.6, 0.5, 0.8]);
    let b = m.checkered(b, 4, 4);
    let ab = m.union(a, b);
    let ab = m.moved(ab, Matrix::rotation(20.0, 1));
    let c = m.sphere([0.3, 0.9, 0.8], 1.1);
    let c = m.coloured(c, BLUE);
    let d = m.half_space([1.0, 0.0, 0.0, 1.1]);
    let cut = m.difference(ab, c);
    let cut = m.difference(cut, d);
    let root = m.on_floor(cut);
    compare("painted_union_cut", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn complements_and_half_spaces() {
    let mut m = Builder::lit();
    let a = m.sphere([0.0; 3], 1.3);
    let a = m.coloured(a, RED);
    let h = m.half_space([0.0, -1.0, -1.0, 0.2]);
    let h = m.coloured(h, GREEN);
    let cut = m.intersection(a, h);
    let b = m.cuboid([-2.0, -0.5, -0.5], [2.0, 0.5, 0.5]);
    let b = m.coloured(b, BLUE);
    let not_b = m.complement(b);
    let rest = m.intersection(cut, not_b);
    let root = m.on_floor(rest);
    compare("complements", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn surfaces_in_operations() {
    let mut m = Builder::lit();
    let s = m.rectangle([-2.0, -1.0], [2.0, 1.5]);
    let s = m.coloured(s, RED);
    let a = m.sphere([-0.8, 0.2, 0.0], 0.9);
    let inside = m.intersection(s, a);
    let inside = m.moved(inside, Matrix::rotation(20.0, 1));
    let t = m.rectangle([-2.0, -1.0], [2.0, 1.5]);
    let t = m.checkered(t, 8, 6);
    let hole = m.sphere([0.0, 0.0, 0.2], 0.6);
    let outside = m.difference(t, hole);
    let outside = m.moved(outside, Matrix::translation(0.8, 0.3, -1.5));
    // Solid and surface together, cut: the surface is cut as well.
    let u = m.plane([1.0, 0.0, 0.2, -1.2]);
    let u = m.coloured(u, GREEN);
    let v = m.sphere([1.4, -0.4, 0.6], 0.7);
    let v = m.coloured(v, BLUE);
    let uv = m.union(u, v);
    let cube = m.cuboid([0.5, -1.0, -0.5], [1.7, 0.6, 1.0]);
    let uv = m.intersection(uv, cube);
    // A surface takes nothing away.
    let w = m.sphere([-1.6, 1.0, -0.5], 0.5);
    let p = m.plane([0.0, 0.0, 1.0, 0.5]);
    let w = m.difference(w, p);
    let x = m.union(inside, outside);
    let y = m.union(uv, w);
    let all = m.union(x, y);
    let root = m.on_floor(all);
    compare("surfaces", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn transparent_unions_and_differences() {
    let mut m = Builder::lit();
    let a = m.sphere([-0.5, 0.0, 0.0], 0.9);
    let a = m.coloured(a, RED);
    let b = m.sphere([0.5, 0.2, 0.0], 0.9);
    let b = m.coloured(b, GREEN);
    let ab = m.union(a, b);
    let c = m.sphere([0.0, 0.6, 0.5], 0.6);
    let d = m.sphere([0.6, 0.8, 0.5], 0.4);
    let cd = m.union(c, d);
    let cut = m.difference(ab, cd);
    let cut = m.mono(cut, 0.4, 0.1, 0.5);
    let cut = m.coloured(cut, BLUE);
    let cut = m.index(cut, [1.1; 3]);
    let root = m.on_floor(cut);
    compare("transparent_operations", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn transparent_parts_of_two_colours() {
    let mut m = Builder::lit();
    let a = m.sphere([-0.5, 0.0, 0.0], 0.9);
    let a = m.coloured(a, RED);
    let b = m.sphere([0.5, 0.2, 0.0], 0.9);
    let b = m.coloured(b, GREEN);
    let ab = m.union(a, b);
    let ab = m.mono(ab, 0.4, 0.1, 0.5);
    let root = m.on_floor(ab);
    compare("two_colours", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn media_in_each_other() {
    let mut m = Builder::lit();
    // An opaque core in glass, and glass that bites into an opaque box.
    let core = m.sphere([-0.9, 0.0, 0.0], 0.4);
    let core = m.coloured(core, RED);
    let shell = m.sphere([-0.9, 0.0, 0.0], 0.9);
    let shell = m.mono(shell, 0.3, 0.0, 0.7);
    let shell = m.index(shell, [1.15; 3]);
    let left = m.union(core, shell);
    let bite = m.sphere([0.7, 0.5, 0.5], 0.8);
    let bite = m.mono(bite, 0.3, 0.1, 0.6);
    let block = m.cuboid([0.4, -1.0, -0.8], [1.7, 0.4, 0.5]);
    let block = m.coloured(block, GREEN);
    let right = m.union(bite, block);
    let all = m.union(left, right);
    let root = m.on_floor(all);
    compare("media", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn coloured_and_bright_lights() {
    let mut m = Builder::default();
    m.camera([1.0, 1.5, 6.0], [-1.0, -1.5, -6.0], [0.0, 2.0, 0.0], 40.0);
    m.coloured_ambient(0.3, [1.0, 0.5, 0.2]);
    m.coloured_ambient(0.2, [0.0, 0.5, 1.0]);
    m.coloured_light([4.0, 6.0, 5.0], 1.5, [1.0, 0.9, 0.2]);
    m.coloured_light([-4.0, 3.0, 5.0], 0.9, [0.2, 0.4, 1.0]);
    let a = m.sphere([0.0; 3], 1.2);
    let a = m.mono(a, 0.8, 0.4, 0.0);
    let root = m.on_floor(a);
    compare("lights", &m.done(root));
}

#[test]
#[ignore = "needs POV-Ray"]
fn automatic_camera_lights_and_box() {
    let mut m = Builder::default();
    let a = m.sphere([10.0, 20.0, -5.0], 30.0);
    let a = m.checkered(a, 8, 6);
    let b = m.half_space([0.0, 1.0, 0.0, 0.0]);
    let b = m.coloured(b, GREEN);
    let root = m.union(a, b);
    let mut scene = m.render(root, [0.3, 0.1, 0.4]);
    let record = scene.render.as_mut().expect("it was made");
    record.clip = Some(([-25.0, -12.0, -40.0], [40.0, 40.0, 10.0]));
    compare("automatic", &scene);
}

/// A small generator of numbers (xorshift); the scenes must be the same every time.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % sides
    }

    /// From −1 to 1, never in step with anything.
    fn unit(&mut self) -> f64 {
        self.roll(1 << 20) as f64 / f64::from(1 << 19) - 1.0
    }
}

/// A random object: shapes, operations, paints, turns; some nodes are used several times.
fn random_object(m: &mut Builder, dice: &mut Dice, transparent: bool) -> u32 {
    let mut nodes = Vec::new();
    for _ in 0..5 {
        let c = [dice.unit(), dice.unit(), dice.unit()];
        let size = 0.6 + 0.4 * dice.unit().abs();
        nodes.push(match dice.roll(5) {
            0 | 1 => m.sphere(c, size),
            2 | 3 => m.cuboid(c.map(|x| x - size), c.map(|x| x + 0.7 * size)),
            _ => {
                let flat = m.rectangle([c[0] - 1.0, c[1] - 1.0], [c[0] + 1.0, c[1] + 1.0]);
                let turn = Matrix::rotation(50.0 * c[2], 1);
                m.moved(flat, Matrix::translation(0.0, 0.0, c[1]).after(&turn))
            }
        });
    }
    // Operands are used up, or moved before they are used again, so that no two faces coincide.
    while nodes.len() > 1 {
        let a = nodes.swap_remove(dice.roll(nodes.len() as u64) as usize);
        let colour = [dice.unit().abs(), dice.unit().abs(), dice.unit().abs()];
        let kt = if transparent && dice.roll(2) == 0 {
            0.5
        } else {
            0.0
        };
        let changed = match dice.roll(12) {
            n @ 0..=5 => {
                let b = nodes.swap_remove(dice.roll(nodes.len() as u64) as usize);
                match n {
                    0..=2 => m.union(a, b),
                    3 | 4 => m.difference(a, b),
                    _ => m.intersection(a, b),
                }
            }
            6 => m.coloured(a, colour),
            7 => m.checkered(a, 3, 2),
            8 => m.mono(a, 0.5, 0.1, kt),
            9 => {
                let texture = Texture::Solid {
                    colours: [colour, RED],
                    size: 0.37,
                };
                m.textured(a, texture)
            }
            10 if nodes.len() < 5 => {
                nodes.push(a);
                let turn = Matrix::rotation(80.0 * dice.unit(), 1);
                m.moved(
                    a,
                    Matrix::translation(dice.unit(), 0.3, dice.unit()).after(&turn),
                )
            }
            _ => m.moved(
                a,
                Matrix::rotation(80.0 * dice.unit(), dice.roll(3) as usize),
            ),
        };
        nodes.push(changed);
    }
    nodes[0]
}

fn random_scenes(name: &str, seeds: std::ops::Range<u64>, transparent: bool) {
    for seed in seeds {
        let mut m = Builder::lit();
        let object = random_object(
            &mut m,
            &mut Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)),
            transparent,
        );
        let root = m.on_floor(object);
        let scene = m.done(root);
        compare(&format!("{name}_{seed}"), &scene);
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn random_opaque_scenes() {
    random_scenes("random_opaque", 1..crate::support::cases(5, 11), false);
}

#[test]
#[ignore = "needs POV-Ray"]
fn random_transparent_scenes() {
    random_scenes("random_transparent", 1..crate::support::cases(5, 11), true);
}

#[test]
#[ignore = "needs POV-Ray"]
fn both_eyes() {
    let mut m = Builder::lit();
    let a = m.sphere([0.0; 3], 1.0);
    let root = m.on_floor(a);
    let mut scene = m.done(root);
    let mut right = scene.cameras[0];
    right.position[0] += 0.5;
    scene.cameras.push(right);
    scene.view = View::Stereo { left: 0, right: 1 };
    let options = Options {
        size: SIZE,
        ..Options::default()
    };
    let one = Options {
        stereo: Stereo::OneFile,
        ..options.clone()
    };
    for (eye, camera) in scene.cameras.iter().enumerate() {
        let mut translation =
            pov::write(&scene, &node_bounds(&scene), &one).expect("a translation");
        let switch = format!("#declare Eye = {eye};\n");
        translation.files[0].text.insert_str(0, &switch);
        compare_view(&format!("eye_{eye}"), &scene, &translation, *camera);
        let mut translation =
            pov::write(&scene, &node_bounds(&scene), &options).expect("a translation");
        let file = translation.files.swap_remove(eye);
        assert_eq!(file.suffix, ["_left", "_right"][eye]);
        translation.files = vec![file];
        compare_view(&format!("eye{eye}"), &scene, &translation, *camera);
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn large_and_small_scenes() {
    let scene = |size: f64| {
        let mut m = Builder::default();
        let a = m.sphere([0.0; 3], size);
        let a = m.mono(a, 0.4, 0.2, 0.4);
        let b = m.cuboid([-2.0 * size, -1.5 * size, -size], [2.0 * size, -size, size]);
        let b = m.checkered(b, 8, 8);
        let root = m.union(a, b);
        m.done(root)
    };
    for (name, size) in [("huge", 1e5), ("small", 1e-3)] {
        compare(name, &scene(size));
    }
    // The evaluator leaves surfaces by a fixed distance, which shows here.
    let tiny = support::compare::compare("tiny", &scene(1e-5), Path::new("."), SIZE);
    assert_eq!(tiny[0].differing.off_silhouettes, 0);
}

#[test]
#[ignore = "needs POV-Ray"]
fn the_scenes_of_the_handout() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/handout");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "zpg") {
            let loaded = zpg::internals::analysis::file::load(&path).unwrap();
            assert!(loaded.is_sound(), "{}", path.display());
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            compare(&name, &loaded.scene);
            count += 1;
        }
    }
    assert_eq!(count, 4);
}
