//! Whole pictures, checked pixel by pixel where the answer is known.

use crate::trace_support;
use trace_support::*;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::*;
use zpg::internals::trace::film::Packing;

fn save(name: &str, scene: &Scene, settings: &zpg::internals::trace::Settings) {
    if let Ok(dir) = std::env::var("ZPG_TEST_PICTURES") {
        let picture = picture(scene, settings);
        let file = std::fs::File::create(format!("{dir}/{name}.png")).unwrap();
        picture.film.write_png(file, Packing::Small).unwrap();
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

fn still_life() -> Scene {
    let mut b = Builder::default();
    let floor = checkerboard(&mut b);
    let glass = b.sphere([-1.5, 1.0, 0.0], 1.0);
    let glass = b.made_of(glass, optics(0.0, 0.1, 0.9), 1.5);
    let red = b.sphere([1.5, 1.0, -1.0], 1.0);
    let red = b.coloured(red, [0.8, 0.1, 0.1]);
    let cube = b.cuboid([-0.5, 0.0, 1.0], [0.5, 1.0, 2.0]);
    let hole = b.sphere([0.0, 1.0, 2.0], 0.5);
    let cut = b.difference(cube, hole);
    let cut = b.coloured(cut, [0.2, 0.6, 0.2]);
    let mirror = b.sphere([0.0, 1.5, -3.0], 1.5);
    let mirror = b.made_of(mirror, optics(0.1, 0.8, 0.0), 1.0);
    let root = b.all(&[floor, glass, red, cut, mirror]);
    b.ambient(0.15);
    b.light([5.0, 8.0, 5.0], 0.9);
    b.camera([0.0, 3.0, 8.0], [0.0, -0.25, -1.0], [0.0, 1.0, 0.0], 45.0);
    b.render(root, [0.3, 0.5, 0.8])
}

#[test]
fn threads_change_nothing() {
    let scene = still_life();
    save("still", &scene, &small(640, 480));
    let settings = zpg::internals::trace::Settings {
        samples: 3,
        ..small(80, 60)
    };
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| picture(&scene, &settings))
    };
    let (one, four) = (with(1), with(4));
    assert_eq!(one.film, four.film);
    assert_eq!(one.counts, four.counts);
    let crop = zpg::internals::trace::Crop {
        x: 20,
        y: 30,
        width: 7,
        height: 5,
    };
    let part = picture(
        &scene,
        &zpg::internals::trace::Settings {
            crop: Some(crop),
            ..settings.clone()
        },
    );
    assert_eq!((part.film.width, part.film.height), (7, 5));
    for y in 0..5 {
        for x in 0..7 {
            assert_eq!(part.film.pixel(x, y), one.film.pixel(20 + x, 30 + y));
        }
    }
}

#[test]
fn many_spheres() {
    let mut b = Builder::default();
    let mut r = Random(1);
    let first = b.sphere([0.0, 0.0, 0.0], 0.5);
    let count = if std::env::var("ZPG_TEST_PICTURES").is_ok() {
        1_000_000
    } else {
        10_000
    };
    let mut root = first;
    for _ in 1..count {
        let p = r.point(50.0);
        let s = b.sphere([p[0], p[1], p[2]], r.within(0.05, 0.4));
        root = b.union(root, s);
    }
    b.light([100.0, 200.0, 300.0], 0.9);
    b.ambient(0.1);
    let scene = b.render(root, [0.3, 0.5, 0.8]);
    let t = zpg::internals::trace::Tracer::new(&scene).unwrap();
    drop(t);
    save("million", &scene, &small(640, 480));
}

/// A camera at (0, 0, distance) that looks along −z.
fn look(b: &mut Builder, distance: f64) {
    b.camera(
        [0.0, 0.0, distance],
        [0.0, 0.0, -1.0],
        [0.0, 1.0, 0.0],
        40.0,
    );
}

/// The direction of the ray through a pixel's centre for that camera.
fn direction(settings: &zpg::internals::trace::Settings, x: u32, y: u32) -> [f64; 3] {
    let (w, h) = (f64::from(settings.width), f64::from(settings.height));
    let half = 20f64.to_radians().tan();
    let u = (2.0 * (f64::from(x) + 0.5) / w - 1.0) * half * w / h;
    let v = (1.0 - 2.0 * (f64::from(y) + 0.5) / h) * half;
    [u, v, -1.0]
}

#[test]
fn a_mirror_room_shows_the_background() {
    let mut b = Builder::default();
    let mut r = Random(4);
    let mut parts = Vec::new();
    for _ in 0..40 {
        let p = r.point(3.0);
        let s = if r.below(2) == 0 {
            b.sphere([p[0], p[1], p[2]], r.within(0.2, 0.8))
        } else {
            b.cuboid(p.0, (p + r.point(1.0).abs()).0)
        };
        let shares = [optics(0.0, 1.0, 0.0), optics(0.0, 0.25, 0.75), CLEAR];
        parts.push(b.made_of(s, shares[r.below(3) as usize], r.within(1.0, 2.0)));
    }
    let root = b.all(&parts);
    look(&mut b, 10.0);
    let background = [0.25, 0.5, 0.75];
    let settings = zpg::internals::trace::Settings {
        // Branches double at every step: deep enough to show, without taking for ever.
        depth: 12,
        cutoff: 1e-3,
        ..small(40, 30)
    };
    let film = picture(&b.render(root, background), &settings).film;
    let mut exact = 0;
    for p in &film.pixels {
        assert!((0..3).all(|c| p[c] <= background[c] as f32 * 1.000_001));
        exact += (0..3).all(|c| (f64::from(p[c]) - background[c]).abs() < 1e-3) as usize;
    }
    assert!(exact > film.pixels.len() / 2);
}

#[test]
fn a_mirror_ball_shows_the_background_unchanged() {
    let mut b = Builder::default();
    let ball = b.sphere([0.0, 0.0, 0.0], 1.0);
    let ball = b.made_of(ball, optics(0.0, 1.0, 0.0), 1.0);
    b.light([1.0, 2.0, 3.0], 1.0);
    let picture = picture(&b.render(ball, [0.25, 0.5, 0.75]), &small(40, 30));
    assert!(picture.film.pixels.iter().all(|p| *p == [0.25, 0.5, 0.75]));
    assert_eq!(picture.counts.rays.shadow, 0);
    assert!(picture.counts.rays.reflection > 100);
}

#[test]
fn closed_rooms() {
    // Inside a closed room of perfect mirrors no ray ever leaves: black, whatever the depth.
    let mut b = Builder::default();
    let room = b.cuboid([-2.0; 3], [2.0; 3]);
    let room = b.made_of(room, optics(0.0, 1.0, 0.0), 1.0);
    look(&mut b, 1.0);
    let scene = b.render(room, [1.0; 3]);
    let settings = zpg::internals::trace::Settings {
        depth: 200,
        ..small(20, 15)
    };
    let picture = picture(&scene, &settings);
    assert!(picture.film.pixels.iter().all(|p| *p == [0.0; 3]));
    assert_eq!(picture.counts.rays.reflection, 300 * 200);
    // A closed white diffuse room under ambient light 0.5 is 0.5 everywhere.
    let mut b = Builder::default();
    let room = b.cuboid([-2.0; 3], [2.0; 3]);
    b.ambient(0.5);
    look(&mut b, 1.0);
    let film = self::picture(&b.render(room, [1.0; 3]), &settings).film;
    assert!(film.pixels.iter().all(|p| *p == [0.5; 3]));
}

#[test]
fn a_checkerboard_by_arithmetic() {
    let mut b = Builder::default();
    let board = b.shape(Geometry::Rectangle {
        min: [-3.0, -2.0],
        max: [3.0, 2.0],
    });
    let colours = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let board = b.paint(
        board,
        Paint {
            texture: Some(Texture::Checkerboard {
                n: 7,
                m: 5,
                colours,
            }),
            ..Paint::default()
        },
    );
    b.ambient(1.0);
    look(&mut b, 6.0);
    let settings = small(64, 48);
    let film = picture(&b.render(board, [0.0; 3]), &settings).film;
    for y in 0..48 {
        for x in 0..64 {
            let d = direction(&settings, x, y);
            let (px, py) = (6.0 * d[0], 6.0 * d[1]);
            let expected = if px.abs() > 3.0 || py.abs() > 2.0 {
                [0.0; 3]
            } else {
                let (u, v) = ((px + 3.0) / 6.0, (py + 2.0) / 4.0);
                let cell = (u * 7.0).floor() + (v * 5.0).floor();
                colours[(cell % 2.0) as usize].map(|c| c as f32)
            };
            assert_eq!(film.pixel(x, y), expected, "{x} {y}");
        }
    }
}

#[test]
fn refraction_through_a_sphere_by_snell() {
    // A glass ball before a background of planes: follow the same ray by trigonometry.
    use zpg::internals::geometry::vec::Vec3;
    use zpg::internals::trace::{Hit, Ray, Tracer};
    let mut b = Builder::default();
    let ball = b.sphere([0.0, 0.0, 0.0], 1.0);
    let ball = b.made_of(ball, CLEAR, 1.5);
    let tracer = Tracer::new(&b.render(ball, [0.0; 3])).unwrap();
    let mut walker = tracer.walker();
    let indices = |hit: &Hit| hit.indices.map(|i| tracer.graph.indices[i as usize]);
    for i in 1..100 {
        let offset = f64::from(i) / 100.0;
        let d = Vec3::new(0.0, 0.0, -1.0);
        let mut ray = Ray::new(Vec3::new(offset, 0.0, 5.0), d);
        ray.is_outside = true;
        let first = tracer.hit(&mut walker, &ray).unwrap();
        assert_eq!(
            (indices(&first), first.inside),
            ([[1.0; 3], [1.5; 3]], [false, true])
        );
        let into = zpg::internals::trace::shade::refract(d, first.facing(), 1.0 / 1.5).unwrap();
        let ray = first.leave(into, true);
        let second = tracer.hit(&mut walker, &ray).unwrap();
        assert_eq!(
            (indices(&second), second.inside),
            ([[1.5; 3], [1.0; 3]], [true, false])
        );
        let out = zpg::internals::trace::shade::refract(into, second.facing(), 1.5).unwrap();
        assert!(tracer.hit(&mut walker, &second.leave(out, true)).is_none());
        // Deviation of a ray through a sphere: 2(α − β), sin α = offset, sin β = offset / 1.5.
        let deviation = 2.0 * (offset.asin() - (offset / 1.5).asin());
        assert!((out[0] + deviation.sin()).abs() < 1e-13, "{offset}");
        assert!((out[2] + deviation.cos()).abs() < 1e-13);
        // The chord: 2 cos β.
        let chord = 2.0 * (1.0 - (offset / 1.5).powi(2)).sqrt();
        assert!((second.t - chord).abs() < 1e-13);
    }
}

#[test]
fn shadows_through_glass_are_kt_squared() {
    for (kt, corner) in [(1.0, false), (0.5, false), (0.25, true)] {
        let mut b = Builder::default();
        let floor = b.shape(Geometry::Rectangle {
            min: [-5.0, -5.0],
            max: [5.0, 5.0],
        });
        let plate = if corner {
            // The light grazes a corner of the box: a chord of 6e-4.
            let c = b.cuboid([0.0; 3], [1.0; 3]);
            let m = Matrix::translation(-1.0 + 1e-4, -1.0 + 1e-4, 1.0);
            b.moved(c, m)
        } else {
            b.cuboid([-1.0, -1.0, 1.0], [1.0, 1.0, 1.1])
        };
        let plate = b.made_of(plate, optics(0.0, 0.0, kt), 1.5);
        let root = b.union(floor, plate);
        b.light([0.0, 0.0, 10.0], 1.0);
        b.camera([3.0, 0.0, 3.0], [-1.0, 0.0, -1.0], [0.0, 1.0, 0.0], 1.0);
        let film = picture(&b.render(root, [0.0; 3]), &small(1, 1)).film;
        assert_eq!(film.pixel(0, 0), [(kt * kt) as f32; 3]);
    }
}

#[test]
fn touching_glass_is_one_block() {
    // Two blocks of glass, face to face but for less than the rounding of the numbers that place
    // them: no air between them, so nothing is totally reflected and the second medium follows the
    // first. Where the blocks themselves are written with a gap, however thin, there is air in it.
    let mut r = Random(8);
    for round in 0..200 {
        let mut b = Builder::default();
        let turn = Matrix::rotation(r.within(0.0, 360.0), round % 3);
        let turn = Matrix::translation(3.0, 3.0, 3.0).after(&turn);
        let left = b.cuboid([-1.0, -4.0, -4.0], [0.0, 4.0, 4.0]);
        let gap = round % 2 == 1;
        let edge = if gap { 7e-16 } else { 0.0 };
        let right = b.cuboid([edge, -4.0, -4.0], [1.0, 4.0, 4.0]);
        let right = match gap {
            true => right,
            false => b.moved(right, Matrix::translation(7e-16, 0.0, 0.0)),
        };
        let [left, right] = [left, right].map(|n| b.moved(n, turn));
        let left = b.made_of(left, CLEAR, 1.5);
        let right = b.made_of(right, CLEAR, 1.25);
        let root = b.union(left, right);
        let tracer = b.tracer(root);
        let mut walker = tracer.walker();
        use zpg::internals::geometry::vec::Vec3;
        use zpg::internals::trace::Ray;
        let start = turn.point([-3.0, 0.2, 0.1]);
        let d = turn.vector([1.0, r.within(-0.4, 0.4), r.within(-0.4, 0.4)]);
        let mut ray = Ray::new(start.into(), Vec3::from(d).unit());
        let mut indices = vec![1.0];
        for _ in 0..10 {
            let Some(hit) = tracer.hit(&mut walker, &ray) else {
                break;
            };
            let [before, behind] = hit.indices.map(|i| tracer.graph.indices[i as usize][0]);
            assert_eq!(before, *indices.last().unwrap());
            indices.push(behind);
            let ratio = before / behind;
            let bent =
                zpg::internals::trace::shade::refract(ray.line.direction, hit.facing(), ratio);
            ray = hit.leave(bent.unwrap(), true);
        }
        let expected: &[f64] = match gap {
            true => &[1.0, 1.5, 1.0, 1.25, 1.0],
            false => &[1.0, 1.5, 1.25, 1.0],
        };
        assert_eq!(indices, expected, "{round}");
    }
}

#[test]
fn straight_steps_do_not_count() {
    // Twenty sheets of half-clear air: depth 0 sees through all of them.
    let mut b = Builder::default();
    let mut parts = Vec::new();
    for i in 0..5 {
        let z = f64::from(i);
        let c = b.cuboid([-9.0, -9.0, -z - 0.5], [9.0, 9.0, -z]);
        parts.push(b.made_of(c, optics(0.0, 0.0, 0.5), 1.0));
    }
    let root = b.all(&parts);
    look(&mut b, 5.0);
    let settings = zpg::internals::trace::Settings {
        depth: 0,
        cutoff: 0.0,
        ..small(1, 1)
    };
    let film = picture(&b.render(root, [1.0; 3]), &settings).film;
    assert_eq!(film.pixel(0, 0), [1.0 / 1024.0; 3]);
}

#[test]
fn the_region_that_is_drawn_cuts() {
    let mut b = Builder::default();
    let ball = b.sphere([0.0, 0.0, 0.0], 1.0);
    let small_ball = b.sphere([0.0, 0.0, -0.2], 0.4);
    let root = b.union(ball, small_ball);
    b.ambient(1.0);
    look(&mut b, 5.0);
    let mut scene = b.render(root, [0.0, 1.0, 0.0]);
    scene.render.as_mut().unwrap().clip = Some(([-2.0, -2.0, -2.0], [2.0, 2.0, 0.0]));
    let tracer = zpg::internals::trace::Tracer::new(&scene).unwrap();
    let mut walker = tracer.walker();
    use zpg::internals::geometry::vec::Vec3;
    use zpg::internals::trace::Ray;
    let ray = Ray::new(Vec3::new(0.1, 0.0, 5.0), Vec3::new(0.0, 0.0, -1.0));
    let hit = tracer.hit(&mut walker, &ray).unwrap();
    // The front half is cut away: the ray meets the back of the large ball from inside, and what
    // lies within the union is no boundary.
    assert!((hit.t - (5.0 + (1.0f64 - 0.01).sqrt())).abs() < 1e-14);
    assert!(!hit.entering);
}
