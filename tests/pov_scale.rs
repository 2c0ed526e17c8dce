//! Translations of scenes that are shared or deep beyond all measure.

use zpg::internals::diagnostics::Span;
use zpg::internals::geometry::Matrix;
use zpg::internals::scene::{
    Geometry, Node, NodeId, Optics, Origin, Paint, Render, Scene, Shape, Texture,
};
use zpg::internals::solids::bounds::node_bounds;
use zpg::internals::syntax::table::ShapeKind;
use zpg::internals::translate::pov::{self, Options};

/// Some spheres in a row; the node of each has its number.
fn spheres(n: u32) -> Scene {
    let mut scene = Scene::default();
    for i in 0..n {
        scene.shapes.push(Shape {
            id: i + 2,
            kind: ShapeKind::Sphere,
            geometry: Geometry::Sphere {
                centre: [f64::from(i), 0.0, 0.0],
                radius: 1.0,
            },
        });
        push(&mut scene, Node::Shape(i));
    }
    scene
}

fn push(scene: &mut Scene, node: Node) -> NodeId {
    scene.nodes.push(node);
    let span = Span::default();
    scene.origins.push(Origin { id: 0, span });
    scene.nodes.len() as NodeId - 1
}

fn translate(mut scene: Scene) -> String {
    scene.render = Some(Render {
        root: scene.nodes.len() as NodeId - 1,
        root_id: 0,
        background: [0.0; 3],
        clip: None,
        span: Span::default(),
    });
    pov::write(&scene, &node_bounds(&scene), &Options::default())
        .unwrap()
        .files
        .remove(0)
        .text
}

/// The deepest nesting of braces.
fn nesting(text: &str) -> i32 {
    let mut depth = 0;
    let depths = text.chars().map(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth
    });
    depths.max().unwrap_or(0)
}

const LONG: u32 = 60_000;

/// A left-deep chain over the spheres.
fn chain(link: impl Fn(u32, NodeId, NodeId) -> Node) -> String {
    let mut scene = spheres(LONG);
    let mut last = 0;
    for i in 1..LONG {
        last = push(&mut scene, link(i, last, i));
    }
    let text = translate(scene);
    assert!(nesting(&text) < 10, "{}", nesting(&text));
    text
}

#[test]
fn long_unions_are_flat() {
    let text = chain(|_, a, b| Node::Union(a, b));
    assert_eq!(text.matches("union {").count(), 1);
    assert_eq!(text.matches("sphere {").count(), LONG as usize);
}

#[test]
fn long_differences_and_intersections_are_flat() {
    let text = chain(|_, a, b| Node::Difference(a, b));
    assert_eq!(text.matches("difference {").count(), 1);
    let text = chain(|_, a, b| Node::Intersection(a, b));
    assert_eq!(text.matches("intersection {").count(), 1);
}

#[test]
fn long_mixed_chains_are_declared() {
    chain(|i, a, b| match i % 2 {
        0 => Node::Union(a, b),
        _ => Node::Difference(a, b),
    });
}

#[test]
fn long_chains_of_changes() {
    for even in [true, false] {
        let mut scene = spheres(1);
        scene.matrices.push(Matrix::translation(1.0, 0.0, 0.0));
        for i in 0..LONG + u32::from(even) {
            let child = scene.nodes.len() as NodeId - 1;
            push(&mut scene, Node::Complement(child));
            if i % 2 == 0 {
                let child = child + 1;
                push(&mut scene, Node::Transform { child, matrix: 0 });
            }
        }
        let text = translate(scene);
        assert_eq!(text.contains("inverse"), even);
        assert!(text.len() < 2000, "{text}");
    }
}

/// Two solids of glass that stand on each other and have all their moves in common.
#[test]
fn long_chains_of_common_moves() {
    let mut scene = spheres(2);
    for (i, index) in [(0, 1.5), (1, 1.3)] {
        let low = f64::from(2 * i) - 1.0;
        scene.shapes[i as usize].geometry = Geometry::Box {
            min: [-1.0, low, -1.0],
            max: [1.0, low + 2.0, 1.0],
        };
        scene.paints.push(Paint {
            owner: 100 + i as u32,
            index: Some([index; 3]),
            ..glass()
        });
    }
    scene.matrices.push(Matrix::rotation(2.0, 0));
    let mut both = [0, 1];
    for _ in 0..LONG {
        for (i, child) in both.iter_mut().enumerate() {
            *child = push(
                &mut scene,
                Node::Transform {
                    child: *child,
                    matrix: 0,
                },
            );
            *child = push(
                &mut scene,
                Node::Paint {
                    child: *child,
                    paint: i as u32,
                },
            );
        }
    }
    push(&mut scene, Node::Union(both[0], both[1]));
    let text = translate(scene);
    assert!(text.len() < 10_000, "{text}");
}

/// Balls of glass of forty kinds, each of which overlaps some of every kind.
#[test]
fn crowds_of_many_media() {
    let mut scene = spheres(10_000);
    for i in 0..10_000u32 {
        if let Geometry::Sphere { centre, .. } = &mut scene.shapes[i as usize].geometry {
            *centre = [i % 31, i / 31 % 31, i / 961].map(|x| 0.9 * f64::from(x));
        }
    }
    for i in 0..40u32 {
        scene.paints.push(Paint {
            owner: 100_000 + i,
            index: Some([1.1 + f64::from(i) / 100.0; 3]),
            ..glass()
        });
    }
    let mut all = None;
    for child in 0..10_000u32 {
        // No neighbours alike.
        let paint = child * 7 % 40;
        let painted = push(&mut scene, Node::Paint { child, paint });
        all = Some(match all {
            Some(all) => push(&mut scene, Node::Union(all, painted)),
            None => painted,
        });
    }
    let text = translate(scene);
    assert_eq!(text.matches("sphere {").count(), 10_000);
}

/// What makes a solid clear.
fn glass() -> Paint {
    Paint {
        optics: Some(Optics {
            kd: [0.1; 3],
            ks: [0.0; 3],
            kt: [0.8; 3],
        }),
        ..Paint::default()
    }
}

/// Sixty times A := B ∪ m(B), with paints in between.
fn doubled(paint: impl Fn(u32) -> Option<Paint>, moved: bool) -> String {
    let mut scene = spheres(1);
    scene
        .matrices
        .push(Matrix::translation(0.5, 0.0, 0.0).after(&Matrix::rotation(40.0, 2)));
    for i in 0..60 {
        let mut last = scene.nodes.len() as NodeId - 1;
        if let Some(p) = paint(i) {
            scene.paints.push(p);
            let paint = scene.paints.len() as u32 - 1;
            last = push(&mut scene, Node::Paint { child: last, paint });
        }
        let other = if moved {
            push(
                &mut scene,
                Node::Transform {
                    child: last,
                    matrix: 0,
                },
            )
        } else {
            last
        };
        push(&mut scene, Node::Union(last, other));
    }
    translate(scene)
}

#[test]
fn shared_nodes_are_never_expanded() {
    assert!(doubled(|_| None, false).len() < 2000);
    let moved = doubled(|_| None, true);
    assert!(
        moved.len() < 40_000,
        "{} bytes: {}",
        moved.len(),
        &moved[..moved.len().min(6000)]
    );
    let glass = |i: u32| Paint {
        owner: 100 + i,
        index: Some([1.5; 3]),
        ..glass()
    };
    assert!(doubled(|i| Some(glass(i)), true).len() < 40_000);
    let solid = |i: u32| Paint {
        owner: 100 + i,
        texture: Some(Texture::Solid {
            colours: [[0.0; 3], [1.0; 3]],
            size: 1.0 + f64::from(i),
        }),
        ..Paint::default()
    };
    assert!(doubled(|i| (i % 7 == 0).then(|| solid(i)), true).len() < 40_000);
}

#[test]
fn every_record_has_a_line_in_the_report() {
    use zpg::internals::syntax::table::RECORD_TYPES;
    let text = include_str!("corpus/all-types.zpg");
    // All objects at once, each feature in use.
    let mut all = text.replace("1 9999 55", "999 -301 moon.png\n55 -299 999 12\n1 9999 ALL");
    let mut joins = String::from(
        "55 -203 1.2 1.3 1.4\n23 -299 14 0\n24 -299 15 0\n29 -299 0 13\n\
         25 -4 0.6 -0.8 0 0 0.48 0.36 -0.8 0 0.64 0.48 0.6 0 0 0 0 1\n",
    );
    let mut last = 55;
    for (n, id) in (20..=42).chain(50..=54).enumerate() {
        let next = 2000 + n;
        joins += &format!("{next} -101 {last} {id}\n");
        last = next;
    }
    all = all.replace("1 9999 ALL", &format!("{joins}1 9999 {last}"));
    let mut seen = std::collections::BTreeSet::new();
    for view in ["", "3001 -502 72\n", "3001 -502 70\n"] {
        let text = all.replace("1 9999", &format!("{view}1 9999"));
        let loaded = zpg::internals::analysis::Analysis::new("scene.zpg", text.clone().into());
        assert!(loaded.is_sound(), "{:?}\n{text}", loaded.findings());
        let translation = pov::write(&loaded.scene, loaded.bounds(), &Options::default()).unwrap();
        seen.extend(translation.report.entries().map(|e| e.feature));
        assert!(!translation.report.has_dropped(), "{}", translation.report);
    }
    let missing: Vec<_> = RECORD_TYPES
        .iter()
        .map(|t| t.title)
        // A placeholder cannot be drawn.
        .filter(|title| *title != "undefined object" && !seen.contains(*title))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}
