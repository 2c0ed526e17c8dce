//! Whole pictures, checked pixel by pixel where the answer is known.

mod trace_support;

use std::time::Instant;
use trace_support::*;
use zpg::scene::*;

fn save(name: &str, scene: &Scene, settings: &zpg::trace::Settings) {
    if let Ok(dir) = std::env::var("ZPG_TEST_PICTURES") {
        let start = Instant::now();
        let picture = picture(scene, settings);
        eprintln!("{name}: {:?} {:?}", start.elapsed(), picture.counts);
        let file = std::fs::File::create(format!("{dir}/{name}.png")).unwrap();
        picture.film.write_png(file).unwrap();
    }
}

fn checkerboard(b: &mut Builder) -> NodeId {
    let floor = b.shape(Geometry::Rectangle {
        min: [-10.0, -10.0],
        max: [10.0, 10.0],
    });
    let floor = b.paint(
        floor,
        Paint {
            texture: Some(Texture::Checkerboard {
                n: 10,
                m: 10,
                colours: [[0.1; 3], [0.9; 3]],
            }),
            ..Paint::default()
        },
    );
    b.moved(floor, Matrix::rotation(-90.0, 0))
}

#[test]
fn a_still_life() {
    let mut b = Builder::default();
    let floor = checkerboard(&mut b);
    let glass = b.sphere(-1.5, 1.0, 0.0, 1.0);
    let glass = b.made_of(glass, optics(0.0, 0.1, 0.9), 1.5);
    let red = b.sphere(1.5, 1.0, -1.0, 1.0);
    let red = b.coloured(red, [0.8, 0.1, 0.1]);
    let cube = b.cuboid([-0.5, 0.0, 1.0], [0.5, 1.0, 2.0]);
    let hole = b.sphere(0.0, 1.0, 2.0, 0.5);
    let cut = b.difference(cube, hole);
    let cut = b.coloured(cut, [0.2, 0.6, 0.2]);
    let mirror = b.sphere(0.0, 1.5, -3.0, 1.5);
    let mirror = b.made_of(mirror, optics(0.1, 0.8, 0.0), 1.0);
    let root = b.all(&[floor, glass, red, cut, mirror]);
    b.ambient(0.15);
    b.light([5.0, 8.0, 5.0], 0.9);
    b.camera([0.0, 3.0, 8.0], [0.0, -0.25, -1.0], [0.0, 1.0, 0.0], 45.0);
    let scene = b.render(root, [0.3, 0.5, 0.8]);
    save("still", &scene, &small(640, 480));
}

#[test]
fn a_million_spheres() {
    let mut b = Builder::default();
    let mut r = Random(1);
    let first = b.sphere(0.0, 0.0, 0.0, 0.5);
    let count = if std::env::var("ZPG_TEST_PICTURES").is_ok() {
        1_000_000
    } else {
        10_000
    };
    let mut root = first;
    for _ in 1..count {
        let p = r.point(50.0);
        let s = b.sphere(p[0], p[1], p[2], r.within(0.05, 0.4));
        root = b.union(root, s);
    }
    b.light([100.0, 200.0, 300.0], 0.9);
    b.ambient(0.1);
    let scene = b.render(root, [0.3, 0.5, 0.8]);
    let start = Instant::now();
    let t = zpg::trace::Tracer::new(&scene).unwrap();
    eprintln!("build {:?}", start.elapsed());
    drop(t);
    save("million", &scene, &small(640, 480));
}
