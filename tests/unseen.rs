//! Parts that no ray can see: pictures without them are the same to the bit, and `zpg plan` names them.

use super::support::{cases, seeds};
use super::trace_support::{Builder, Random, optics, small};
use rayon::prelude::*;
use zpg::internals::analysis::Analysis;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::{Camera, Geometry, NodeId, Paint, Scene, Texture};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::solids::staging::selected_cameras;
use zpg::internals::trace::plan::unseen::view;
use zpg::internals::trace::plan::{Effect, Plan};
use zpg::internals::trace::{Images, Numbers, Settings, Tracer, members};

/// The pictures of all cameras, without what is unseen or with it, as bits; and what they have cost.
fn pictures(scene: &Scene, plan: Plan, numbers: Numbers) -> (Vec<[u32; 3]>, u64) {
    let tracer = Tracer::planned(scene, &Images::default(), plan).unwrap();
    let settings = Settings {
        numbers,
        ..small(33, 25)
    };
    let aspect = 33.0 / 25.0;
    let cameras = match scene.cameras.is_empty() {
        true => selected_cameras(scene, aspect),
        false => scene.cameras.clone(),
    };
    let (mut pixels, mut tests) = (Vec::new(), 0);
    for camera in &cameras {
        let Ok(picture) = tracer.render(camera, &settings, || ()) else {
            continue;
        };
        let bits = picture.film.pixels.iter().map(|p| p.map(f32::to_bits));
        pixels.extend(bits);
        tests += picture.counts.intersections.boxes;
    }
    (pixels, tests)
}

/// Something of about a size, convex or not, about a place on a coarse grid: so that things touch, are
/// concentric and have faces in one place.
fn body(b: &mut Builder, r: &mut Random, size: f64, place: [f64; 3]) -> NodeId {
    let size = size * [1.0, 1.0, 0.75, 0.5][r.below(4) as usize];
    let geometry = match r.below(11) {
        0..=3 => Geometry::Sphere {
            centre: [0.0; 3],
            radius: size,
        },
        4 | 5 => Geometry::Box {
            min: [-size; 3],
            max: [size; 3],
        },
        6 => Geometry::Ellipsoid {
            semi_axes: [size, 0.75 * size, size],
        },
        7 => Geometry::Revolution {
            profile: vec![[0.0, -size], [size, -size], [size, size], [0.0, size]],
            colours: match r.below(2) {
                0 => Vec::new(),
                _ => vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]],
            },
        },
        8 => Geometry::Torus {
            major: 0.75 * size,
            minor: 0.25 * size,
        },
        9 => Geometry::GeodesicSphere {
            radius: size,
            splits: 1,
        },
        _ => Geometry::Rectangle {
            min: [-size; 2],
            max: [size; 2],
        },
    };
    let mut m = Matrix::translation(place[0], place[1], place[2]);
    if r.below(3) == 0 {
        let turn = [30.0, 45.0, 90.0][r.below(3) as usize];
        m = m.after(&Matrix::rotation(turn, r.below(3) as usize));
    }
    let shape = b.shape(geometry);
    b.moved(shape, m)
}

/// With a look of its own: opaque, a mirror or glass, with a texture or without.
fn painted(b: &mut Builder, r: &mut Random, child: NodeId, opaque: bool) -> NodeId {
    let kinds = if opaque { 3 } else { 6 };
    let looks = match r.below(kinds) {
        0 => None,
        1 => Some(optics(0.8, 0.0, 0.0)),
        2 => Some(optics(0.5, 0.4, 0.0)),
        3 => Some(optics(0.1, 0.0, 0.9)),
        _ => Some(optics(0.0, 0.2, 0.8)),
    };
    let colours = [[0.9, 0.2, 0.1], [0.1, 0.3, 0.9]];
    let texture = match r.below(5) {
        0 => Some(Texture::Solid { colours, size: 0.5 }),
        1 => Some(Texture::Checkerboard {
            n: 4,
            m: 3,
            colours,
        }),
        2 => Some(Texture::Colour([0.3, 0.9, 0.5])),
        _ => None,
    };
    let index = match r.below(3) {
        0 => Some([1.5; 3]),
        1 => Some([1.3, 1.4, 1.5]),
        _ => None,
    };
    b.paint(
        child,
        Paint {
            owner: 0,
            texture,
            optics: looks,
            index,
        },
    )
}

/// Large things, mostly opaque, with small ones in and around them: concentric, apart, across their
/// surfaces, in contact; some cut by operations, some used twice; with a region to be drawn or without;
/// cameras and lamps outside and inside.
fn random_scene(seed: u64) -> Scene {
    let mut r = Random(seed << 20);
    let mut b = Builder::default();
    let grid = |r: &mut Random, steps: u64| -> [f64; 3] {
        [0; 3].map(|_| r.below(2 * steps + 1) as f64 * 0.5 - 0.5 * steps as f64)
    };
    let mut parts = Vec::new();
    let mut places = Vec::new();
    for _ in 0..1 + r.below(3) {
        let place = grid(&mut r, 4);
        places.push(place);
        let shell = body(&mut b, &mut r, 2.0, place);
        let opaque = r.below(4) > 0;
        let mut shell = painted(&mut b, &mut r, shell, opaque);
        if r.below(8) == 0 {
            let place = grid(&mut r, 4);
            let cut = body(&mut b, &mut r, 1.0, place);
            shell = match r.below(2) {
                0 => b.difference(shell, cut),
                _ => b.intersection(shell, cut),
            };
        }
        parts.push(shell);
    }
    for _ in 0..1 + r.below(5) {
        let around = places[r.below(places.len() as u64) as usize];
        let steps = [1, 1, 3, 8][r.below(4) as usize];
        let by = grid(&mut r, steps);
        let place = std::array::from_fn(|i| around[i] + by[i]);
        let small = body(&mut b, &mut r, 0.75, place);
        let mut small = painted(&mut b, &mut r, small, false);
        match r.below(8) {
            0 => {
                let tool = body(&mut b, &mut r, 0.5, place);
                small = b.difference(small, tool);
            }
            // The same thing twice, in one place or in two.
            1 => {
                let again = b.moved(small, Matrix::translation(by[2], 0.5, 0.0));
                small = b.union(small, again);
            }
            _ => {}
        }
        parts.push(small);
    }
    // The order of operands, and how unions are nested.
    for i in (1..parts.len()).rev() {
        parts.swap(i, r.below(i as u64 + 1) as usize);
    }
    while parts.len() > 1 {
        let i = r.below(parts.len() as u64 - 1) as usize;
        let other = parts.remove(i + 1);
        let mut both = b.union(parts[i], other);
        if r.below(4) == 0 {
            both = b.moved(both, Matrix::rotation(90.0, r.below(3) as usize));
        }
        if r.below(12) == 0 {
            both = painted(&mut b, &mut r, both, false);
        }
        parts[i] = both;
    }
    if r.below(6) == 0 {
        let floor = match r.below(2) {
            0 => b.half_space([0.0, 1.0, 0.0, 2.0]),
            _ => b.shape(Geometry::Plane([0.0, 1.0, 0.0, 2.0])),
        };
        parts[0] = b.union(parts[0], floor);
    }
    b.ambient(0.3);
    let lamp = match r.below(4) {
        0 => grid(&mut r, 4),
        _ => [5.0, 7.0, 6.0],
    };
    b.light(lamp, 0.7);
    if r.below(8) > 0 {
        let from = r.point(1.0).unit() * 9.0;
        b.camera(from.0, (-from).0, [0.1, 1.0, 0.2], 45.0);
        if r.below(4) == 0 {
            let from = grid(&mut r, 4);
            b.camera(from, [0.3, -0.2, -1.0], [0.1, 1.0, 0.2], 80.0);
        }
        if r.below(6) == 0 {
            let camera = b.scene.cameras.last_mut().unwrap();
            // OpenGL's frustum of 45° or a parallel projection, whose rays start before the camera.
            camera.projection = Some(match r.below(2) {
                0 => Matrix([
                    [2.0, 0.0, 0.0, 0.0],
                    [0.0, 2.4, 0.0, 0.0],
                    [0.0, 0.0, -1.5, -10.0],
                    [0.0, 0.0, -1.0, 0.0],
                ]),
                _ => Matrix::scaling(0.25, 0.25, -0.1),
            });
        }
    }
    let root = parts[0];
    let mut scene = b.render(root, [0.1, 0.2, 0.3]);
    if r.below(2) == 0 {
        let (low, high) = (2.0 + 0.5 * r.below(6) as f64, 2.0 + 0.5 * r.below(6) as f64);
        scene.render.as_mut().unwrap().clip = Some(([-low; 3], [high; 3]));
    }
    scene
}

#[test]
fn pictures_are_the_same_without_what_is_unseen() {
    let found: Vec<(usize, bool, bool)> = seeds("UNSEEN_SEEDS", 0..cases(300, 1500))
        .into_par_iter()
        .map(|seed| {
            let scene = random_scene(seed);
            let (all, seen) = (
                Plan::new(&scene).unwrap(),
                Plan::of_picture(&scene).unwrap(),
            );
            let (parts, on) = (seen.unseen.len(), |p: &Plan| p.names());
            let quieter = on(&all) != on(&seen);
            let clip = all.on(Effect::ClipBox) && !seen.on(Effect::ClipBox);
            // What is off here is off there.
            assert!(on(&seen).iter().all(|e| on(&all).contains(e)), "{seed}");
            let numbers = if seed % 10 == 0 {
                Numbers::Dd
            } else {
                Numbers::F64
            };
            let (with, without) = (
                pictures(&scene, all, numbers),
                pictures(&scene, seen, numbers),
            );
            assert!(with.0 == without.0, "seed {seed}");
            (parts, quieter, clip)
        })
        .collect();
    // Enough to mean something.
    let count = |f: &dyn Fn(&(usize, bool, bool)) -> bool| found.iter().filter(|x| f(x)).count();
    let some = count(&|x| x.0 > 0);
    let (quieter, unclipped) = (count(&|x| x.1), count(&|x| x.2));
    println!("{some} with unseen parts, {quieter} with fewer effects, {unclipped} not clipped");
    let all = found.len();
    assert!(
        5 * some > all && 25 * quieter > all && 200 * unclipped > all,
        "{some} {quieter} {unclipped}"
    );
}

/// A camera somewhere about a scene, in it or beside it, that looks anywhere.
fn random_camera(r: &mut Random) -> Camera {
    let far = [2.0, 6.0, 20.0][r.below(3) as usize];
    let matrix = match r.below(4) {
        0 => Some(Matrix([
            [2.0, 0.0, 0.0, 0.0],
            [0.0, 2.4, 0.0, 0.0],
            [0.0, 0.0, -1.5, -10.0],
            [0.0, 0.0, -1.0, 0.0],
        ])),
        1 => Some(Matrix::scaling(0.25, 0.25, -0.1)),
        _ => None,
    };
    Camera {
        id: 0,
        position: r.point(far).0,
        direction: r.point(1.0).0,
        up: [0.1, 1.0, 0.2],
        fovy: [10.0, 45.0, 120.0][r.below(3) as usize],
        projection: matrix,
    }
}

/// Where a camera is said to see nothing, its picture has the colour of the background; and a point that is said to be
/// in something opaque is in the scene, by exact numbers.
#[test]
fn what_is_out_of_view_is_in_no_picture() {
    let found: Vec<[usize; 2]> = seeds("UNSEEN_SEEDS", 0..cases(300, 1500))
        .into_par_iter()
        .map(|seed| {
            let scene = random_scene(seed);
            let (bounds, root) = (node_bounds(&scene), scene.render.unwrap().root);
            let plan = Plan::of_picture(&scene).unwrap();
            let tracer = Tracer::planned(&scene, &Images::default(), plan).unwrap();
            let mut r = Random(seed << 20 | 7);
            let mut count = [0; 2];
            for _ in 0..12 {
                let camera = random_camera(&mut r);
                if view::out_of_view(&scene, &bounds, root, &camera, view::Parts::All).is_some() {
                    let picture = tracer.render(&camera, &small(32, 24), || ()).unwrap();
                    let empty = |p: &[f32; 3]| *p == [0.1, 0.2, 0.3];
                    assert!(picture.film.pixels.iter().all(empty), "{seed} {camera:?}");
                    count[0] += 1;
                }
                let place = camera.position;
                let held = view::held(&scene, &bounds, root, &[place]);
                if held[0].is_some_and(|h| !h.on_surface) {
                    let exact = members(&scene, root, place.into()).unwrap();
                    assert!(exact.in_root, "{seed} {place:?}");
                    count[1] += 1;
                }
            }
            count
        })
        .collect();
    let [unseen, inside] = [0, 1].map(|i| found.iter().map(|c| c[i]).sum::<usize>());
    println!("{unseen} cameras that see nothing, {inside} in something");
    assert!(unseen > found.len() && 4 * inside > found.len());
}

const NOTHING: [u32; 0] = [];

fn unseen(text: &str) -> Vec<u32> {
    let loaded = Analysis::new("scene", text.as_bytes().to_vec());
    let plan = Plan::of_picture(&loaded.scene).unwrap();
    let all = pictures(
        &loaded.scene,
        Plan::new(&loaded.scene).unwrap(),
        Numbers::F64,
    );
    let ids = plan.unseen.iter().map(|p| p.id).collect();
    assert!(
        all.0 == pictures(&loaded.scene, plan, Numbers::F64).0,
        "{text}"
    );
    ids
}

/// A ball of glass, 3, in an opaque one, 2; a camera and a lamp outside.
fn balls(more: &str) -> String {
    format!(
        "90 -501 0 0 9 0 0 -1 0 1 0 45\n91 -402 1\n91 -1 5 6 7\n2 11 0 0 0 2\n3 11 0.5 0 0 0.5\n\
         3 -201 0.1 0 0.9\n3 -203 1.4 1.5 1.6\n4 -101 3 2\n{more}\n"
    )
}

#[test]
fn what_lies_inside_of_something_opaque_is_not_seen() {
    assert_eq!(unseen(&balls("1 9999 4 0")), [3]);
    // Moved, painted and copied as a whole.
    assert_eq!(
        unseen(&balls("5 -105 4\n5 -1 3 0 0\n5 -2 30 1\n1 9999 5 0")),
        [3]
    );
    // The opaque one is made clear, or the other one opaque: that one is hidden all the same.
    assert_eq!(unseen(&balls("4 -201 0 0 1\n1 9999 4 0")), NOTHING);
    assert_eq!(unseen(&balls("4 -201 1 0 0\n1 9999 4 0")), [3]);
    // One of three channels is enough.
    assert_eq!(
        unseen(&balls("2 -202 1 0 0 1 0 0 1 0 0.1\n5 -101 3 2\n1 9999 5 0")),
        NOTHING
    );
}

#[test]
fn what_touches_the_surface_from_within_may_be_seen() {
    for (radius, hidden) in [("1.499", true), ("1.5", false), ("1.501", false)] {
        let scene = format!("6 11 0.5 0 0 {radius}\n6 -201 0 0 1\n5 -101 6 4\n1 9999 5 0");
        assert_eq!(unseen(&balls(&scene)).contains(&6), hidden, "{radius}");
    }
}

#[test]
fn glass_that_reaches_in_opens_a_solid() {
    // Across the surface, touching it, and clear of it.
    for (x, hidden) in [("2", false), ("3", false), ("3.001", true), ("4.1", true)] {
        let scene = format!("6 11 {x} 0 0 1\n6 -201 0 0 1\n5 -101 6 4\n1 9999 5 0");
        assert_eq!(unseen(&balls(&scene)).contains(&3), hidden, "{x}");
    }
    // By way of another opaque solid.
    let through = |x: &str| {
        format!(
            "6 12 0 -1 -1 5 1 1\n7 11 {x} 0 0 1\n7 -201 0 0 1\n8 -101 7 6\n5 -101 8 4\n1 9999 5 0"
        )
    };
    assert_eq!(unseen(&balls(&through("5"))), NOTHING);
    assert_eq!(unseen(&balls(&through("9"))), [3]);
}

/// A box that the opaque ball sticks in, and that reaches further back: what opens it opens the ball.
#[test]
fn what_opens_a_neighbour_opens_a_solid() {
    let stuck = |more: &str| {
        balls(&format!(
            "6 12 -1.5 -1.5 -7 1.5 1.5 1.5\n5 -101 4 6\n93 -501 0 0 -9 0 0 1 0 1 0 45\n{more}"
        ))
    };
    assert_eq!(unseen(&stuck("1 9999 5 0")), [3]);
    let camera = "94 -501 0 0 -6 0 0 1 0 1 0 45\n1 9999 5 0";
    assert_eq!(unseen(&stuck(camera)), NOTHING);
    assert_eq!(unseen(&stuck("1 9999 5 0 -9 -9 -8 9 9 9")), [3]);
    assert_eq!(unseen(&stuck("1 9999 5 0 -9 -9 -6 9 9 9")), NOTHING);
}

/// Of two balls that overlap the first is open to glass, the second by way of the first.
#[test]
fn what_is_connected_with_an_open_solid_is_open() {
    let two = |all: &str| {
        balls(&format!(
            "6 11 -2.5 0 0 1\n6 -201 0 0 1\n7 11 2.5 0 0 2\n8 11 3.5 0 0 0.3\n8 -201 0 0 1\n\
             9 -101 7 8\n10 -101 4 9\n11 -101 10 6\n1 9999 {all} 0"
        ))
    };
    assert_eq!(unseen(&two("11")), NOTHING);
    assert_eq!(unseen(&two("10")), [3, 8]);
}

#[test]
fn operations_and_the_region_open_solids() {
    let cut = "6 12 0 0 0 9 9 9\n7 -103 4 6\n1 9999 7 0";
    assert_eq!(unseen(&balls(cut)), NOTHING);
    // A difference beside it opens nothing; of one that is a part itself nothing is known.
    let beside = "6 11 0 5 0 1\n7 11 0 5.5 0 1\n8 -103 6 7\n5 -101 4 8\n1 9999 5 0";
    assert_eq!(unseen(&balls(beside)), [3]);
    assert_eq!(unseen(&balls("1 9999 4 0 -9 -9 -9 9 9 9")), [3]);
    assert_eq!(unseen(&balls("1 9999 4 0 -9 -9 -9 9 9 1")), NOTHING);
    // The region's face touches the ball.
    assert_eq!(unseen(&balls("1 9999 4 0 -9 -9 -9 9 9 2")), NOTHING);
}

#[test]
fn cameras_and_lamps_inside_see() {
    let lamp = "92 -402 1\n92 -1 -1 0 0\n1 9999 4 0";
    assert_eq!(unseen(&balls(lamp)), NOTHING);
    // Either eye, whichever is selected.
    let eye = "93 -501 -1 0 0 1 0 0 0 1 0 45\n94 -503 90 93\n1 9999 4 0";
    assert_eq!(unseen(&balls(eye)), NOTHING);
    let other = "93 -501 -1 0 0 1 0 0 0 1 0 45\n94 -502 90\n1 9999 4 0";
    assert_eq!(unseen(&balls(other)), NOTHING);
    // Rays of a parallel projection start where its box begins: within the ball, and before it.
    let parallel =
        |near: &str| format!("93 -99 0.2 0 0 0 0 0.2 0 0 0 0 -0.1 {near} 0 0 0 1\n1 9999 4 0");
    assert_eq!(unseen(&balls(&parallel("-1"))), NOTHING);
    assert_eq!(unseen(&balls(&parallel("-0.4"))), [3]);
    // The automatic camera stands outside.
    let none: String = balls("1 9999 4 0")
        .lines()
        .skip(1)
        .map(|l| format!("{l}\n"))
        .collect();
    assert_eq!(unseen(&none), [3]);
}

#[test]
fn what_lies_outside_of_the_region_is_not_seen() {
    let beside = |x: &str, region: &str| {
        balls(&format!(
            "6 11 {x} 0 0 1\n6 -201 0 0 1\n5 -101 6 4\n1 9999 5 0 {region}"
        ))
    };
    assert_eq!(unseen(&beside("9", "-3 -3 -3 3 3 3")), [6, 3]);
    // It touches the region.
    assert_eq!(unseen(&beside("4", "-3 -3 -3 3 3 3")), [3]);
    // All there is.
    let lone = balls("6 11 9 0 0 1\n6 -201 0 0 1\n1 9999 6 0 -3 -3 -3 3 3 3");
    assert_eq!(unseen(&lone), [6]);
}

/// Nothing that is outside of the region turns anything on: neither glass nor the region itself.
#[test]
fn what_is_unseen_asks_for_nothing() {
    let outside = balls("6 11 9 0 0 1\n6 -201 0 0.2 0.8\n5 -101 6 4\n1 9999 5 0 -3 -3 -3 3 3 3");
    let loaded = Analysis::new("scene", outside.into_bytes());
    let plan = Plan::of_picture(&loaded.scene).unwrap();
    assert_eq!(plan.names(), ["diffuse"]);
    assert_eq!((plan.medium_depth, plan.lone_convex), (0, true));
    // All that is reached is counted.
    assert_eq!(plan.shapes["sphere"], 3);
    let all = Plan::new(&loaded.scene).unwrap();
    assert!(all.on(Effect::ClipBox) && all.on(Effect::Refraction) && all.on(Effect::Dispersion));
    let (with, without) = (
        pictures(&loaded.scene, all, Numbers::F64),
        pictures(&loaded.scene, plan, Numbers::F64),
    );
    assert!(with.1 > without.1, "{} {}", with.1, without.1);
}

/// How many parts of a scene are unseen.
fn unseen_parts(text: &str) -> usize {
    let loaded = Analysis::new("scene", text.as_bytes().to_vec());
    let plan = Plan::of_picture(&loaded.scene).unwrap();
    plan.unseen.len()
}

/// Balls and the union of all of them, one after the other; every other one is of glass.
fn chain(balls: impl Iterator<Item = String>) -> String {
    let mut text = "2 -201 0 0 1\n3 9 0.1\n".to_owned();
    let mut last = 3;
    for (i, ball) in (4..).step_by(2).zip(balls) {
        text += &format!("{i} 11 {ball}\n");
        if i % 4 == 0 {
            text += &format!("{i} -299 0 2\n");
        }
        text += &format!("{} -101 {last} {i}\n", i + 1);
        last = i + 1;
    }
    text + &format!("1 9999 {last} 0\n")
}

#[test]
fn large_scenes_are_unseen_parts() {
    // Each ball of glass in an opaque one: of many the largest are asked what they hold.
    let pairs = chain((0..80_000u32).map(|i| {
        let [x, y, z] = [i / 2 % 40, i / 80 % 40, i / 3200].map(|k| 3 * k);
        format!("{x} {y} {z} {}", if i % 2 == 0 { "0.25" } else { "1" })
    }));
    assert_eq!(unseen_parts(&pairs), 4096);
    // All apart, and all in one heap: the searches end.
    let apart = chain((0..80_000u32).map(|i| format!("{} 0 0 1", 3 * i)));
    assert_eq!(unseen_parts(&apart), 0);
    unseen_parts(&chain((0..80_000u32).map(|i| {
        let x = 1e-4 * f64::from(i);
        format!("{x} 0 0 {}", 10.0 - x)
    })));
}
