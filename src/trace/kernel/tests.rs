//! The kernel against the arbiter: lanes have the bits of shapes, and pictures those of pictures.

use super::lanes::{Lanes, V3, mask};
use super::resolved::Resolved;
use super::{cuboid, plane, rectangle, sphere, triangle};
use crate::geometry::Matrix;
use crate::geometry::affine::{Affine, Placement};
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::scene::{Geometry, TriangleNormals};
use crate::testing::{random, scene};
use crate::trace::graph::Graph;
use crate::trace::kernel::leaf::{Kind, Leaf};
use crate::trace::kernel::stage::Stage;
use crate::trace::shapes::triangle::Triangle;
use crate::trace::shapes::{Primitive, Root, Roots};
use crate::trace::stats::Work;
use crate::trace::{Picture, Settings, Tracer, selected_camera};
use std::fmt::Write;

/// Numbers from −1 to 1.
pub fn numbers() -> impl FnMut() -> f64 {
    let mut next = random();
    move || next(2_000_001) as f64 / 1e6 - 1.0
}

/// A graph whose one placement is that of a matrix.
pub fn placed_by(out: &Matrix) -> Graph {
    let back = out.inverse().expect("it can be undone");
    let [out, back] = [out, &back].map(Affine::new);
    Graph {
        placements: vec![Placement { out, back }],
        ..Graph::default()
    }
}

/// The point of a leaf that a line meets, a bound on its error, and the unit normal there, and the point in the leaf's own
/// space: one map after the other.
pub fn located(stage: &Stage, line: &Line, leaf: &Leaf, root: Root) -> [Vec3; 4] {
    let placements = &stage.graph.placements;
    let chain = &stage.chains[leaf.chain as usize];
    let through = |line: Line, &m: &u32| line.through(&placements[m as usize].back);
    let own = chain.iter().fold(*line, through);
    let primitive = &stage.graph.primitives[leaf.primitive as usize];
    let found = primitive.intersect::<f64>().locate(&own, root);
    let (mut point, mut error, mut normal) = (found.point, found.error, found.normal);
    for &m in chain.iter().rev() {
        let maps = &placements[m as usize];
        error = maps.out.point_error(point, error);
        point = maps.out.point(point);
        normal = maps.back.unit_normal(normal);
    }
    [point, error, normal.unit(), found.point]
}

/// Places on shapes without lanes have the bits that one map after the other gives, in groups of any depth.
#[test]
fn places_have_the_bits_of_shapes() {
    let shapes = [
        "14 0.8 0.3",
        "1 3 0.3 -1 0.7 0.2 0.1 0.9",
        "15 1 0 0 0 0 -1 0 0 0 0 1 0 0 0 0 -0.25",
        "14 0.4 0.6",
    ];
    let mut number = numbers();
    let mut found = [0; 4];
    for i in 0..60 {
        let mut text = String::from("3 11 900 0 0 1\n");
        for (id, shape) in (10..).zip(shapes) {
            text += &format!("{id} {shape}\n");
        }
        let mut groups = Vec::new();
        for id in 10..14 {
            let mut whole = id;
            for depth in 0..(i + id) % 4 {
                let next = 20 + 4 * depth + id;
                let (a, b) = (180.0 * number(), 180.0 * number());
                text += &format!("{whole} -3 1 {} 1\n{whole} -2 {a} 1\n", 1.5 + number());
                text += &format!("{whole} -2 {b} {}\n", 2 + depth % 2);
                text += &format!("{whole} -1 {} {} {}\n", number(), number(), number());
                text += &format!("{next} -101 {whole} 3\n");
                whole = next;
            }
            groups.push(whole);
        }
        let [a, b, c, d] = groups[..] else { continue };
        text += &format!("90 -101 {a} {b}\n91 -101 {c} {d}\n92 -101 90 91\n1 9999 92 0\n");
        let scene = scene(&text);
        let tracer = Tracer::new(&scene).unwrap();
        let stage = Stage::new(&tracer.graph, 100).expect("shapes for the kernel");
        let leaves: Vec<&Leaf> = (stage.leaves.iter())
            .filter(|leaf| leaf.kind == Kind::Other)
            .collect();
        for _ in 0..50 {
            let mut lines = Vec::new();
            for leaf in &leaves {
                let mut vector = || Vec3::new(number(), number(), number());
                let (from, to) = (vector() * 9.0, vector());
                let line = Line::new(from, to - from);
                let mut roots = Roots::default();
                let own = stage.line_through(&line, leaf.chain);
                let primitive = &stage.graph.primitives[leaf.primitive as usize];
                primitive.intersect::<f64>().crossings(&own, &mut roots);
                lines.extend(roots.list.first().map(|&root| (*leaf, line, root)));
            }
            let Some(&last) = lines.last() else { continue };
            let four = [0, 1, 2, 3].map(|lane| *lines.get(lane).unwrap_or(&last));
            let origin = V3::gathered(four.each_ref(), |(_, line, _)| &line.origin.0);
            let direction = V3::gathered(four.each_ref(), |(_, line, _)| &line.direction.0);
            let (leaves, roots) = (four.map(|(leaf, ..)| leaf), four.map(|(.., root)| root));
            let places = stage.locate(leaves, (origin, direction), roots, 15, &mut Work::default());
            let all = places.resolved;
            for (lane, (leaf, line, root)) in four.iter().enumerate() {
                assert!(all.clear.to_bitmask() >> lane & 1 != 0, "{text}");
                let of = |v: V3| Vec3(v.columns().map(|column| column[lane]));
                assert_eq!(
                    [
                        of(all.point),
                        of(all.error),
                        of(all.normal),
                        places.local[lane]
                    ],
                    located(&stage, line, leaf, *root),
                    "{text}"
                );
                found[lane] += 1;
            }
        }
    }
    assert!(found.iter().all(|&count| count > 1000), "{found:?}");
}

/// Four times the same.
fn four(v: Vec3) -> V3 {
    V3::splat(v)
}

/// The point that the kernel finds on a line.
fn resolved(geometry: &Geometry, line: &Line, exit: bool) -> Resolved {
    let (o, d) = (four(line.origin), four(line.direction));
    let exit = mask(if exit { 15 } else { 0 });
    let splat = Lanes::splat;
    match *geometry {
        Geometry::Sphere { centre, radius } => {
            sphere::resolve(o, d, four(centre.into()), splat(radius), exit)
        }
        Geometry::Box { min, max } => {
            cuboid::resolve(o, d, four(min.into()), four(max.into()), exit)
        }
        Geometry::Plane([a, b, c, e]) => {
            let normal = four(Vec3::new(a, b, c));
            let power = splat(0.5f64.powi(a.abs().max(b.abs()).max(c.abs()).log2().floor() as i32));
            let plane = plane::Plane {
                normal,
                d: splat(e),
                unit: normal * power,
                c: splat(e) * power,
            };
            plane::resolve(o, d, &plane)
        }
        Geometry::Triangle { ref vertices, .. } => {
            let shape = Triangle::new(**vertices, TriangleNormals::Flat);
            let normal = shape.normal().expect("it has an area");
            triangle::resolve(o, d, shape.vertices().map(four), four(normal))
        }
        _ => rectangle::resolve(o, d),
    }
}

/// Points that the kernel is sure of have the bits of what the shape itself finds, on lines from near and far, and from its
/// own surface.
#[test]
fn lanes_have_the_bits_of_shapes() {
    let mut number = numbers();
    let mut sure = [0; 5];
    for i in 0..50_000 {
        let kind = i % 5;
        let mut vector = || Vec3::new(number(), number(), number());
        let (a, b, c) = (vector(), vector(), vector());
        let geometry = match kind {
            0 => Geometry::Sphere {
                centre: a.0,
                radius: b[0].abs() + 0.01,
            },
            1 => Geometry::Box {
                min: a.0,
                max: (a + b.abs() + Vec3::ONE * 0.01).0,
            },
            2 => Geometry::Plane([a[0], a[1], a[2], b[0]]),
            3 => Geometry::Triangle {
                vertices: Box::new([(a + b).0, (a + c).0, (a - b - c * 1.5).0]),
                normals: TriangleNormals::Flat,
            },
            _ => Geometry::Rectangle {
                min: [-1.0, -0.5],
                max: [0.5 + a[0].abs(), 0.7],
            },
        };
        let far = if i % 3 == 0 { 1.0 } else { 30.0 };
        let mut line = Line::new(c * far, (a - c * far + b * 0.3).unit());
        if i % 7 == 0 {
            line = Line::new(
                line.origin,
                Vec3::new(0.0, line.direction[1], line.direction[2]),
            );
        }
        let primitive = Primitive::new(&geometry);
        let mut roots = Roots::default();
        for again in [false, true] {
            roots.clear();
            primitive.intersect().crossings(&line, &mut roots);
            let Some(&first) = roots.list.first() else {
                break;
            };
            if again {
                // From the surface, inwards.
                let at = primitive.intersect().locate(&line, first).point;
                line = Line::new(at, line.direction);
                continue;
            }
            for exit in [false, roots.list.len() > 1] {
                let root = roots.list[usize::from(exit)];
                let found = resolved(&geometry, &line, exit);
                if found.clear.to_bitmask() & 1 == 0 || roots.uncertain {
                    continue;
                }
                sure[kind] += 1;
                let located = primitive.intersect().locate(&line, root);
                let lane = |v: V3| Vec3(v.columns().map(|column| column[1]));
                assert_eq!(found.t.to_array()[2], root.t, "{geometry:?} {line:?}");
                assert_eq!(lane(found.point), located.point, "{geometry:?} {line:?}");
                assert_eq!(lane(found.error), located.error, "{geometry:?} {line:?}");
                let normal = lane(found.normal.unit());
                assert_eq!(normal, located.normal.unit(), "{geometry:?} {line:?}");
            }
        }
    }
    assert!(sure.iter().all(|&n| n > 1000), "{sure:?}");
}

/// A scene of some shapes, intersections and differences; some are glass, mirrors or textured.
fn text(number: &mut impl FnMut() -> f64, seed: usize) -> String {
    let mut text = String::from(
        "71 -701 1 0.8 0.2\n72 -701 0.1 0.2 0.6\n70 -399 4 3 71 72\n73 -302 71 72 0.3\n",
    );
    let count = [1, 3, 12][seed % 3];
    let mut union = 0;
    for i in 0..count {
        let id = 200 + 8 * i;
        let [a, b, c, d] = [id + 1, id + 2, id + 4, id + 5];
        let mut real = |by: f64| (number() * by * 100.0).round() / 100.0;
        let r = real(1.0).abs() + 0.3;
        match (i + seed) % 14 {
            0 => writeln!(text, "{id} 11 0 0 0 {r}"),
            1 => writeln!(text, "{id} 12 {0} -0.5 {0} {r} 0.5 {r}", -r),
            2 => writeln!(text, "{id} 5 -1 -1 {r} 1"),
            3 => writeln!(text, "{id} 14 {r} 0.25"),
            4 => writeln!(text, "{id} 16 1.2 {r}"),
            5 => writeln!(text, "{id} 1 4 0 -1 {r} -0.5 0.2 0.3 0 1"),
            6 => writeln!(text, "{id} 13 {r} 1"),
            7 => writeln!(
                text,
                "{a} 11 0 0 0.6 1\n{b} 11 0 0 -0.6 1\n{id} -102 {a} {b}"
            ),
            8 => writeln!(
                text,
                "{a} 12 -1 -1 -1 1 1 1\n{b} 11 0.5 1 1 {r}\n{id} -103 {a} {b}"
            ),
            9 => writeln!(
                text,
                "{a} 12 -1 -1 -1 1 1 1\n{b} 11 0 0 0 {r}\n{a} -701 1 0.2 0.2\n{c} -102 {a} {b}\n\
                 {d} 14 0.9 0.2\n{d} -701 0.1 0.9 0.2\n{c} -2 20 1\n{id} -103 {c} {d}"
            ),
            10 => writeln!(
                text,
                "{a} 12 -1 -1 -1 1 1 1\n{b} 11 0 0 0 {r}\n{b} -701 1 0.2 0.2\n{c} -101 {a} {b}\n\
                 {d} 12 -2 -0.4 -2 2 0.4 2\n{d} -1 0 {r} 0\n{} -103 {c} {d}\n{} 11 0 0 0 1.2\n\
                 {id} -102 {} {}",
                id + 6,
                id + 7,
                id + 6,
                id + 7
            ),
            11 => writeln!(text, "{id} 11 0 0 0 {r}\n{id} -3 1 {r} 1.2"),
            12 => writeln!(text, "{id} 6 -1 -1 0 1 {} 0 0 {r} 1", -r),
            _ => writeln!(
                text,
                "{a} 8 -1 -1 0 1 -1 0 0 1 {r} -1 0 1 1 0 1 0 1 1\n\
                 {b} 7 -1 -1 0 1 -1 0 0 -{r} 1 0.1 0.2 1\n{id} -101 {a} {b}"
            ),
        }
        .unwrap();
        let turn = [90.0, real(180.0)][i % 2];
        writeln!(text, "{id} -2 {turn} {}", 1 + i % 3).unwrap();
        let at = [real(5.0), real(4.0), real(3.0)];
        writeln!(text, "{id} -1 {} {} {}", at[0], at[1], at[2]).unwrap();
        match (i + seed / 3) % 6 {
            0 => writeln!(text, "{id} -201 0.1 0.1 0.8\n{id} -203 1.5 1.5 1.5"),
            1 => writeln!(text, "{id} -201 0.6 0.4 0"),
            2 => writeln!(text, "{id} -299 {} 0", [70, 73][i % 2]),
            _ => writeln!(text, "{id} -701 0.9 0.5 0.3"),
        }
        .unwrap();
        union = match i {
            0 => id,
            _ => {
                writeln!(text, "{} -101 {union} {id}", id + 3).unwrap();
                id + 3
            }
        };
    }
    let floor = ["4 0 1 0 6", "3 0.1 1 0.05 7", "4 0 1 0 1"][seed % 4 % 3];
    writeln!(text, "90 {floor}\n100 -101 {union} 90").unwrap();
    text + "101 -401 0.2\n102 -402 0.5\n102 -1 5 9 8\n103 -402 0.4\n103 -1 -9 5 9\n\
            104 -501 0 0 18 0 0 -1 0 1 0 45\n105 -701 0.1 0.2 0.3\n1 9999 100 105\n"
}

/// A picture by the kernel, and one by the arbiter.
fn pictures(text: &str, settings: &Settings) -> [Picture; 2] {
    projected(text, settings, None)
}

/// The same by the scene's camera with another projection.
fn projected(text: &str, settings: &Settings, projection: Option<Matrix>) -> [Picture; 2] {
    let scene = scene(text);
    let mut tracer = Tracer::new(&scene).unwrap();
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let mut camera = selected_camera(&scene, aspect);
    camera.projection = projection;
    [false, true].map(|without| {
        tracer.graph.without.kernel = without;
        tracer.render(&camera, settings, || ()).unwrap()
    })
}

/// Pictures by the kernel have the bits of pictures by the arbiter, and the same rays.
#[test]
fn pictures_are_those_of_the_arbiter() {
    let mut number = numbers();
    let (mut quick, mut all) = (0, 0);
    for seed in 0..60 {
        let (width, height) = [(33, 21), (7, 5), (40, 30)][seed % 3];
        let settings = Settings {
            width,
            height,
            samples: [1, 1, 3][seed / 3 % 3],
            tolerance: (seed % 5 == 4).then_some(0.1),
            ..Settings::default()
        };
        let [ours, theirs] = pictures(&text(&mut number, seed), &settings);
        assert_eq!(ours.film, theirs.film, "{seed}");
        assert_eq!(ours.counts.rays, theirs.counts.rays, "{seed}");
        assert_eq!(ours.total_reflection, theirs.total_reflection, "{seed}");
        assert_eq!(ours.samples, theirs.samples, "{seed}");
        assert_eq!(theirs.counts.quick, 0);
        quick += ours.counts.quick;
        all += u64::from(width * height);
    }
    assert!(quick > all / 3, "{quick} of {all}");
}

/// Pictures of parallel rays are those of the arbiter, whether the rays start before the scene or in the middle of it, where
/// some are in solids.
#[test]
fn pictures_of_parallel_rays_are_those_of_the_arbiter() {
    let mut number = numbers();
    let settings = Settings {
        width: 40,
        height: 30,
        ..Settings::default()
    };
    let mut quick = [0; 2];
    for seed in 0..24 {
        // The camera is at z = 18; rays start where the depth is -1: at z = 18 or z = 0.
        let offset = [-1.0, -4.6][seed % 2];
        let parallel = Matrix([
            [0.15, 0.0, 0.0, 0.0],
            [0.0, 0.2, 0.0, 0.0],
            [0.0, 0.0, -0.2, offset],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        let text = text(&mut number, seed);
        let [ours, theirs] = projected(&text, &settings, Some(parallel));
        assert_eq!(ours.film, theirs.film, "{seed}");
        assert_eq!(ours.counts.rays, theirs.counts.rays, "{seed}");
        assert_eq!(ours.total_reflection, theirs.total_reflection, "{seed}");
        quick[seed % 2] += ours.counts.quick;
    }
    let all = 12 * 40 * 30;
    assert!(quick.iter().all(|&n| n > all / 2), "{quick:?} of {all}");
    assert!(quick[1] < all, "no ray starts in a solid");
}

/// Draws a small picture, which is the arbiter's. How many of its pixels the kernel has asked for, of how many.
fn asked_of(text: &str) -> [u64; 2] {
    let settings = Settings {
        width: 48,
        height: 36,
        cutoff: 0.0,
        ..Settings::default()
    };
    let [ours, theirs] = pictures(text, &settings);
    assert_eq!(ours.film, theirs.film, "{text}");
    let all = u64::from(settings.width * settings.height);
    [all - ours.counts.quick, all]
}

/// Boxes and balls with many holes of all kinds, which overlap each other, opaque and of glass, and light comes through them.
#[test]
fn solids_full_of_holes_are_those_of_the_arbiter() {
    let mut number = numbers();
    let holes = [
        "11 0 0 0 0.3",
        "14 0.25 0.1",
        "12 -0.2 -0.2 -0.2 0.2 0.2 0.2",
        "16 0.4 0.3",
    ];
    let (mut asked, mut all) = (0, 0);
    for seed in 0..8 {
        let mut text = String::from(["10 12 -1 -1 -1 1 1 1\n", "10 11 0 0 0 1.2\n"][seed % 2]);
        let mut whole = 10;
        for i in 0..40 {
            let id = 200 + 2 * i;
            let hole = holes[if seed < 4 { 0 } else { (i + seed) % 4 }];
            let mut real = |by: f64| (number() * by * 100.0).round() / 100.0;
            let [x, y, z, turn] = [real(1.2), real(1.2), real(1.2), real(180.0)];
            writeln!(text, "{id} {hole}\n{id} -2 {turn} {}", 1 + i % 3).unwrap();
            writeln!(text, "{id} -1 {x} {y} {z}\n{} -103 {whole} {id}", id + 1).unwrap();
            whole = id + 1;
        }
        if seed % 4 > 1 {
            text += &format!("{whole} -201 0.1 0.1 0.8\n{whole} -203 1.4 1.4 1.4\n");
        }
        text += &format!(
            "{whole} -2 20 1\n9 12 -3 -2 -3 3 -1.5 3\n8 -101 {whole} 9\n101 -401 0.2\n102 -402 0.8\n102 -1 2 9 4\n\
             104 -501 0 1 5 0 -0.1 -1 0 1 0 45\n1 9999 8 0\n"
        );
        let [own, of] = asked_of(&text);
        (asked, all) = (asked + own, all + of);
    }
    assert!(asked * 50 < all, "{asked} of {all}");
}

/// Solids of second degree and boxes in one heap, up to five deep: each is glass of its own, glass of one kind, or opaque. Light
/// also comes to be within something opaque, whose near face is hidden in glass.
#[test]
fn heaps_are_those_of_the_arbiter() {
    let mut number = numbers();
    let shapes = [
        "10 0.9 0.5 0.7",
        "16 1.2 0.6",
        "1 2 0.5 -0.7 0.4 0.7",
        "15 2 0 0 0 0 1.5 0 0 0 0 3 0 0 0 0 -1",
        "12 -0.6 -0.5 -0.4 0.6 0.5 0.4",
        "11 0 0 0 0.7",
    ];
    let (mut asked, mut all) = (0, 0);
    for seed in 0..8 {
        let mut text = String::new();
        let mut union = 0;
        for i in 0..14 {
            let id = 200 + 4 * i;
            let mut real = |by: f64| (number() * by * 100.0).round() / 100.0;
            match (i + seed) % 7 {
                6 => writeln!(
                    text,
                    "{} 15 1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 -0.25\n{} 12 -1 -0.7 -1 1 0.7 1\n{id} -102 {} {}",
                    id + 1,
                    id + 2,
                    id + 1,
                    id + 2
                ),
                kind => writeln!(text, "{id} {}", shapes[kind]),
            }
            .unwrap();
            let index = [1.5, 1.2 + 0.02 * i as f64][i % 2];
            match i % 3 {
                0 => {}
                _ => writeln!(
                    text,
                    "{id} -201 0.1 0.1 0.8\n{id} -203 {index} {index} {index}"
                )
                .unwrap(),
            }
            let [x, y, z, turn] = [real(0.9), real(0.9), real(0.9), real(180.0)];
            writeln!(text, "{id} -2 {turn} {}\n{id} -1 {x} {y} {z}", 1 + i % 3).unwrap();
            union = match i {
                0 => id,
                _ => {
                    writeln!(text, "{} -101 {union} {id}", id + 3).unwrap();
                    id + 3
                }
            };
        }
        text += &format!(
            "101 -401 0.2\n102 -402 0.5\n102 -1 5 9 8\n104 -501 0 0 6 0 0 -1 0 1 0 45\n1 9999 {union} 0\n"
        );
        let [own, of] = asked_of(&text);
        (asked, all) = (asked + own, all + of);
    }
    // Some of it is asked of the arbiter, and most is not.
    assert!(asked > 0 && asked < all / 2, "{asked} of {all}");
}

/// Light comes through glass into something opaque, whose near face the glass hides, and on through what that hides in turn,
/// which is not near the glass.
#[test]
fn light_passes_what_something_opaque_hides() {
    let text = "2 11 0 0 1 1\n2 -201 0 0 1\n3 11 0 0 0 1\n4 11 0 0 -0.8 0.5\n5 -101 2 3\n6 -101 5 4\n\
                10 -402 1\n10 -1 1 1 9\n11 -501 0 0 6 0 0 -1 0 1 0 30\n1 9999 6 0\n";
    let settings = Settings {
        width: 48,
        height: 36,
        ..Settings::default()
    };
    let [ours, theirs] = pictures(text, &settings);
    assert_eq!(ours.film, theirs.film);
    // At the centre the ray goes through the glass to the far side of the opaque ball, at (0, 0, -1); the lamp is in the
    // direction (1, 1, 10) from there, and the normal is (0, 0, 1).
    let [red, ..] = ours.film.pixels[18 * 48 + 24];
    let cosine = 10.0 / 102.0f32.sqrt();
    assert!((red - cosine).abs() < 0.02, "{red} is not {cosine}");
}

/// A scene that would be expanded to 2⁴⁰ operands is left to the arbiter.
#[test]
fn copies_of_copies_are_not_expanded() {
    let mut text = String::from("10 11 0 0 0 1\n11 12 -0.8 -0.8 -0.8 0.8 0.8 0.8\n12 -103 11 10\n");
    for i in 0..40 {
        let [whole, copy, next] = [12, 13, 14].map(|id| id + 2 * i);
        writeln!(
            text,
            "{copy} -105 {whole}\n{copy} -1 0.05 0.01 0\n{next} -103 {whole} {copy}"
        )
        .unwrap();
    }
    let scene = scene(&format!("{text}1 9999 92 0\n"));
    let tracer = Tracer::new(&scene).unwrap();
    assert!(super::Stage::new(&tracer.graph, 1 << 20).is_none());
}

/// Scenes that the kernel knows all about, or nearly so.
#[test]
fn doubt_is_rare() {
    let end = "90 4 0 1 0 1.5\n90 -701 0.7 0.6 0.5\n91 -101 8 90\n9 -402 0.8\n9 -1 2 5 9\n92 -401 0.1\n\
               93 -501 0 1 8 0 -0.1 -1 0 1 0 45\n94 -701 0.2 0.3 0.5\n1 9999 91 94\n";
    let glass = |id: u32, index: &str| format!("{id} -201 0.05 0.1 0.8\n{id} -203 {index}\n");
    let scenes = [
        // Flat faces that half-spaces cut.
        "2 11 0 0 0 1\n3 4 0 -1 -1 0\n4 -103 2 3\n5 11 0 0 0 1\n6 4 0 -1 -1 0\n7 -102 5 6\n7 -1 2.5 0 0\n\
         8 -101 4 7\n8 -1 -1 0 0\n"
            .to_owned(),
        // A ball of glass in a ball of water, and one that sticks out of it.
        format!(
            "2 11 0 0 0 0.5\n3 11 0.9 0 0 0.4\n4 11 0 0 0 1.2\n5 -101 2 3\n8 -101 5 4\n{}{}{}",
            glass(2, "1.5 1.5 1.5"),
            glass(3, "1.6 1.5 1.7"),
            glass(4, "1.3 1.33 1.33")
        ),
        // Channels part in a half hollow ball, whose flat face is opaque.
        format!(
            "2 9 1.4\n3 11 0 0 0 0.7\n4 -103 2 3\n5 4 1 1 1 0\n8 -102 4 5\n{}",
            glass(4, "1.3 2.1 1.8")
        ),
        // The cut in a union of parts that look alike.
        "2 1 3 0.9 -1 0.3 0 0.6 0.9\n3 11 0 1 0 0.4\n4 -101 2 3\n5 12 -2 0.2 -2 2 0.4 2\n5 -2 20 3\n\
         8 -103 4 5\n8 -701 0.8 0.2 0.1\n"
            .to_owned(),
        // A shape that sticks out of water hides no light where it is in it; two that overlap are one.
        format!(
            "2 11 0 0 0 1\n3 12 0.2 -0.4 -0.5 1.6 0.3 0.5\n4 11 1 0 0 0.6\n5 -101 2 3\n8 -101 5 4\n{}",
            glass(2, "1.33 1.33 1.33")
        ),
        // A box with round corners stands on the floor.
        "2 12 -1 -1.5 -1 1 0.5 1\n3 11 0 -0.5 0 1.42\n8 -102 2 3\n".to_owned(),
    ];
    let settings = Settings {
        width: 60,
        height: 45,
        ..Settings::default()
    };
    for (number, scene) in scenes.iter().enumerate() {
        let [ours, theirs] = pictures(&format!("{scene}{end}"), &settings);
        assert_eq!(ours.film, theirs.film, "{number}");
        assert_eq!(ours.counts.rays, theirs.counts.rays, "{number}");
        let quick = ours.counts.quick;
        assert!(quick > 60 * 45 * 98 / 100, "{number}: {quick}");
    }
}
