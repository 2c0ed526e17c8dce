use super::*;
use crate::geometry::array::{cross, dot, sub};
use crate::solids::bounds::node_bounds;
use crate::trace::Tracer;

/// The model of a scene.
pub(super) fn made(text: &str, tolerance: f64) -> Model {
    let scene = crate::testing::scene(text);
    let tracer = Tracer::new(&scene).unwrap();
    let options = Options {
        tolerance: Some(tolerance),
        ..Options::default()
    };
    model(&scene, &node_bounds(&scene), &tracer.graph, &options).unwrap()
}

fn whole(model: &Model) -> Mesh {
    assert!(model.mesh.is_closed());
    assert_eq!(model.troubles.uncut + model.troubles.unjoined, 0);
    model.mesh.clone()
}

#[test]
fn a_lens_has_the_volume_of_two_caps() {
    // Two unit balls one apart: twice a cap of height ½.
    let m = made("2 9 1\n3 11 1 0 0 1\n4 -102 2 3\n1 9999 4 0", 1e-4);
    let cap = std::f64::consts::PI * 0.25 * 2.5 / 3.0;
    assert!((whole(&m).volume() - 2.0 * cap).abs() < 2e-3);
    // Each half shows its own ball.
    let shapes: Vec<u32> = m
        .mesh
        .labels
        .iter()
        .map(|&l| m.skins[l as usize].shape)
        .collect();
    assert!(shapes.contains(&2) && shapes.contains(&3));
}

#[test]
fn mirrors_keep_the_outside_out() {
    for by in ["-1 1 1", "2 -3 0.5", "-1 -1 -1"] {
        let m = made(
            &format!("2 12 0 0 0 1 2 3\n2 -3 {by}\n3 9 0.5\n4 -101 2 3\n4 -3 1 1 -2\n1 9999 4 0"),
            1e-2,
        );
        assert!(whole(&m).volume() > 0.0);
    }
}

#[test]
fn what_is_cut_looks_like_what_it_was_cut_from() {
    // A red and a green box side by side, and a hole through both.
    let m = made(
        "2 12 -2 0 0 0 1 1\n2 -701 1 0 0\n3 12 0 0 0 2 1 1\n3 -701 0 1 0\n4 -101 2 3\n\
         5 12 -1 0.25 -1 1 0.75 2\n5 -701 0 0 1\n6 -103 4 5\n1 9999 6 0",
        1e-2,
    );
    let mesh = whole(&m);
    assert!((mesh.volume() - 3.0).abs() < 1e-9);
    for t in 0..mesh.triangles.len() {
        let skin = &m.skins[mesh.labels[t] as usize];
        let corners = mesh.corners(t);
        let x = corners.iter().map(|p| p[0]).sum::<f64>();
        assert_eq!(skin.object(), if x < 0.0 { 2 } else { 3 }, "{corners:?}");
    }
    // The hole's walls are made by the third box.
    assert!(mesh.labels.iter().any(|&l| m.skins[l as usize].shape == 5));
}

#[test]
fn things_without_end_are_cut_to_the_render_box() {
    let m = made(
        "2 4 0 1 0 0\n3 -104 2\n4 -102 2 3\n5 20\n6 -101 2 5\n1 9999 6 0 -2 -2 -2 2 2 2",
        1e-3,
    );
    let mesh = whole(&m);
    // Above the floor: the hyperboloid's circles of radius √(1 + y²), up to where the box cuts in.
    let steps = 100_000;
    let height = |i: i32| (f64::from(i) + 0.5) * 2.0 / f64::from(steps);
    let area = |y: f64| {
        let r2 = 1.0 + y * y;
        let r = r2.sqrt();
        if r <= 2.0 {
            return std::f64::consts::PI * r2;
        }
        // Four segments are cut off the disc.
        let half = (2.0 / r).acos();
        std::f64::consts::PI * r2 - 4.0 * (r2 * half - 2.0 * (r2 - 4.0).sqrt())
    };
    let above: f64 = (0..steps)
        .map(|i| area(height(i)) * 2.0 / f64::from(steps))
        .sum();
    let error = (mesh.volume() - 32.0 - above).abs();
    assert!(error < 0.05, "{} {above}", mesh.volume());
    // The box is a hair larger, for faces that lie in its own.
    let (bounds, end) = (mesh.bounds(), 2.0 + 1e-6 * 12f64.sqrt());
    let off = |x: &f64| (x.abs() - end).abs();
    assert!(bounds.min.iter().chain(&bounds.max).all(|x| off(x) < 1e-12));
}

#[test]
fn faces_in_faces_of_the_render_box_are_there() {
    let m = made(
        "2 9 1\n3 4 0 1 0 1.5\n4 -101 2 3\n1 9999 4 0 -2 -1.5 -2 2 2 2",
        1e-3,
    );
    let floor = |p: &&[f64; 3]| (p[1] + 1.5).abs() < 1e-9;
    assert!(whole(&m).points.iter().filter(floor).count() >= 4);
}

#[test]
fn surfaces_are_cut_by_solids() {
    let area = |m: &Model| -> f64 {
        let all = m.solid..m.mesh.triangles.len();
        all.map(|t| {
            let [a, b, c] = m.mesh.corners(t);
            let n = cross(sub(b, a), sub(c, a));
            dot(n, n).sqrt() / 2.0
        })
        .sum()
    };
    // A square of area 16, less a disc of radius 1; the disc; the square in a union.
    let pi = std::f64::consts::PI;
    for (record, meant) in [("103 2 3", 16.0 - pi), ("102 2 3", pi), ("101 2 3", 16.0)] {
        let m = made(
            &format!("2 5 -2 -2 2 2\n3 9 1\n4 -{record}\n1 9999 4 0"),
            1e-4,
        );
        assert!((area(&m) - meant).abs() < 2e-3, "{record} {}", area(&m));
        assert_eq!(m.solid > 0, record.starts_with("101"));
    }
}

#[test]
fn a_shared_object_keeps_the_tolerance_where_it_is_large() {
    let m = made(
        "2 9 1\n3 -105 2\n3 -3 50 50 50\n3 -1 100 0 0\n4 -101 2 3\n1 9999 4 0",
        0.05,
    );
    let large = 4.0 / 3.0 * std::f64::consts::PI * 125_000.0;
    assert!((whole(&m).volume() - large - 4.0).abs() < 31_416.0 * 0.05);
}

#[test]
fn a_long_chain_needs_no_stack() {
    let mut text = String::new();
    let n = 20_000;
    for i in 0..n {
        let id = 2 + 2 * i;
        let (x, z) = (3 * (i % 150), 3 * (i / 150));
        text += &format!("{id} 11 {x} 0 {z} 1\n");
        if i > 0 {
            let before = if i == 1 { 2 } else { id - 1 };
            text += &format!("{} -101 {before} {id}\n", id + 1);
        }
    }
    text += &format!("1 9999 {} 0\n", 2 * n + 1);
    let m = made(&text, 0.5);
    assert!(m.mesh.is_closed());
    assert_eq!(m.mesh.triangles.len() % (n as usize), 0);
}

#[test]
fn copies_of_copies_are_refused_in_words() {
    // 2⁴⁰ balls.
    let mut text = String::from("2 9 1\n");
    for i in 0..40 {
        let (a, b, c) = (2 + 2 * i, 3 + 2 * i, 4 + 2 * i);
        text += &format!(
            "{b} -105 {a}\n{b} -1 {} 0 0\n{c} -101 {a} {b}\n",
            3.0 * 2f64.powi(i)
        );
    }
    text += "1 9999 82 0\n";
    let scene = crate::testing::scene(&text);
    let tracer = Tracer::new(&scene).unwrap();
    let refused = model(
        &scene,
        &node_bounds(&scene),
        &tracer.graph,
        &Options::default(),
    )
    .unwrap_err();
    assert!(refused.to_string().contains("triangles"), "{refused}");
}

#[test]
fn corners_have_the_normals_of_their_own_faces() {
    // The colours of the ring make many triangles of it; points on its rims lie within the circles.
    let text = "2 2 4 2 0.5 2.6 0.5 2.3 0.9 2 0.5 1 0 0 0 1 1 1 1 1 0.2 0.2 1\n1 9999 2 0";
    let scene = crate::testing::scene(text);
    let tracer = Tracer::new(&scene).unwrap();
    let m = made(text, 1e-3);
    let corners = corners::corners(&m.mesh, &m.skins, &tracer.graph, |_| false);
    assert!(corners.len() > 1000);
    for (t, at) in corners.iter().enumerate() {
        let [a, b, c] = m.mesh.corners(t);
        let n = cross(sub(b, a), sub(c, a));
        let n = n.map(|x| x / dot(n, n).sqrt());
        for corner in at {
            assert!(dot(corner.normal, n) > 0.99, "{:?} {corner:?}", [a, b, c]);
        }
    }
}
