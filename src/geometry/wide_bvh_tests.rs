use super::*;
use proptest::prelude::*;

/// Boxes somewhere in a cube, as many as asked for.
fn boxes() -> impl Strategy<Value = Vec<Aabb>> {
    let one = (
        [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        [0.0..0.2f64, 0.0..0.2, 0.0..0.2],
    );
    prop::collection::vec(one, 1..200).prop_map(|boxes| {
        let place =
            |(at, size): ([f64; 3], [f64; 3])| Aabb::new(at, [0, 1, 2].map(|i| at[i] + size[i]));
        boxes.into_iter().map(place).collect()
    })
}

/// Scaled and moved.
fn placed(b: &Aabb, scale: f64, offset: [f64; 3]) -> Aabb {
    let image = |p: [f64; 3]| [0, 1, 2].map(|i| (p[i] + offset[i]) * scale);
    Aabb::new(image(b.min), image(b.max))
}

/// The items that a beam meets, with a bound from below on where it comes into each.
fn met(tree: &Tree, beam: &Beam, [from, to]: [f64; 2]) -> Vec<(u32, f64)> {
    let mut pending: Vec<u32> = tree.nodes.first().map(|_| 0).into_iter().collect();
    let mut out = Vec::new();
    while let Some(node) = pending.pop() {
        let node = &tree.nodes[node as usize];
        let (met, near) = beam.meets(node, beam.pace(from), beam.pace(to));
        for slot in (0..WIDTH).filter(|slot| met >> slot & 1 != 0) {
            match node.children[slot].is() {
                Is::Node(node) => pending.push(node),
                Is::Item(item) => out.push((item, beam.unpace(near[slot]))),
            }
        }
    }
    out
}

/// Where a line surely is in a box, and where it may be: its sides moved by a part of the size.
fn stretch(b: &Aabb, line: &Line, by: f64) -> Option<(f64, f64)> {
    let moved = Aabb::new(b.min.map(|x| x - by), b.max.map(|x| x + by));
    moved.clip(line, 0.0, f64::INFINITY)
}

proptest! {
    #[test]
    fn all_boxes_on_the_way_are_met_and_few_others(
        all in boxes(),
        target in [-1.0..1.2f64, -1.0..1.2, -1.0..1.2],
        from in [-4.0..4.0f64, -4.0..4.0, -4.0..4.0],
        along in 0..4usize,
        scale in prop_oneof![Just(0), -900..900i32],
        pace in -60..60i32,
        far in prop_oneof![Just(0.0), 1.0..1e7f64],
    ) {
        let scale = 2f64.powi(scale);
        let offset = [far, -far, far / 3.0];
        let all: Vec<Aabb> = all.iter().map(|b| placed(b, scale, offset)).collect();
        let frame = Frame::around(all.iter());
        let tree = Tree::new((0..).zip(all.iter().copied()).collect(), &frame);
        let items: std::collections::BTreeSet<u32> = tree.items().collect();
        prop_assert!(items.into_iter().eq(0..all.len() as u32));

        let image = |p: [f64; 3]| Vec3([0, 1, 2].map(|i| (p[i] + offset[i]) * scale));
        let mut direction = (image(target) - image(from)) * 2f64.powi(pace);
        // Along an axis, now and then.
        (0..3).filter(|&i| along < 3 && i != along).for_each(|i| direction[i] = 0.0);
        prop_assume!(direction.any());
        let line = Line::new(image(from), direction);
        let beam = Beam::new(&line, &frame);
        let to = 0.75 * 2f64.powi(-pace);
        // More than doubles round, and singles.
        let (hair, breadth) = (scale * (far + 8.0) * 1e-14, scale * (1e-5 + far * 1e-14));
        for window in [[0.0, f64::INFINITY], [0.0, to], [to / 2.0, to]] {
            let met = met(&tree, &beam, window);
            for (i, b) in (0..).zip(&all) {
                let near = met.iter().find(|m| m.0 == i).map(|m| m.1);
                let is_in = |(a, b): &(f64, f64)| *a <= window[1] && *b >= window[0];
                if let Some((enters, _)) = stretch(b, &line, -hair).filter(is_in) {
                    prop_assert!(near.is_some(), "{i} {b:?} {line:?}");
                    let enters = enters.max(window[0]);
                    prop_assert!(near.is_some_and(|near| near <= enters * (1.0 + 1e-12)));
                }
                let widened = |(a, b)| (a * (1.0 - 1e-5), b * (1.0 + 1e-5));
                if stretch(b, &line, breadth).map(widened).filter(is_in).is_none() {
                    prop_assert!(near.is_none(), "{i} {b:?} {line:?} {window:?}");
                }
            }
        }
    }
}

/// Where singles tell nothing every box is met.
#[test]
fn lines_from_beyond_the_numbers_meet_everything() {
    let all = [Aabb::new([0.0; 3], [1.0; 3]), Aabb::new([2.0; 3], [3.0; 3])];
    let frame = Frame::around(all.iter());
    let tree = Tree::new((0..).zip(all).collect(), &frame);
    let [away, up] = [Vec3::new(1e30, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
    for line in [Line::new(away, up), Line::new(Vec3::ZERO, up * 1e-310)] {
        let met = met(&tree, &Beam::new(&line, &frame), [0.0, 1.0]);
        assert_eq!(met.len(), 2);
    }
    let past = Line::new(Vec3::new(1.5, 0.0, 0.0), up);
    assert!(met(&tree, &Beam::new(&past, &frame), [0.0, 9.0]).is_empty());
}

/// Boxes with one centre cannot be told apart by it.
#[test]
fn a_hundred_equal_boxes_are_a_tree() {
    let all = vec![Aabb::new([-1.0; 3], [1.0; 3]); 100];
    let frame = Frame::around(all.iter());
    let tree = Tree::new((0..).zip(all).collect(), &frame);
    let line = Line::new(Vec3::new(0.0, 0.0, 9.0), Vec3::new(0.0, 0.0, -1.0));
    let met = met(&tree, &Beam::new(&line, &frame), [0.0, 99.0]);
    assert_eq!(met.len(), 100);
    assert!(met.iter().all(|m| m.1 > 7.99 && m.1 <= 8.0));
}
