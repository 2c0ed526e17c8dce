//! Cuts that are flush, and cuts that nearly are.

use crate::diagnostics::Applicability;
use crate::lint::testing::{fixed, fixes, found, messages};

/// A box of side 2 about the origin, and 3, cut from it.
fn cut(tool: &str) -> String {
    format!("2 12 -1 -1 -1 1 1 1\n{tool}\n4 -103 2 3\n")
}

#[track_caller]
fn flush(scene: &str) {
    let found = found(scene);
    assert!(
        !found.is_empty() && found.iter().all(|f| f.starts_with("W321")),
        "{scene}\n{found:?}"
    );
}

#[track_caller]
fn silent(scene: &str) {
    // What is left may be nothing, and the box of the render record may cut it: other rules say so.
    let found = found(scene);
    assert!(
        !found.iter().any(|f| f.starts_with("W321")),
        "{scene}\n{found:?}"
    );
}

/// The place named is on both faces, whatever the sizes and wherever they are.
#[test]
fn the_place_named_is_on_both() {
    for (scene, place) in [
        (
            "2 12 100 0 0 100.002 2 2\n3 12 100.0005 .5 .5 100.0015 2 1.5\n4 -103 2 3\n",
            [100.0005..=100.0015, 2.0..=2.0, 0.5..=1.5],
        ),
        (
            "2 12 5 5 5 7 7 7\n3 4 0 1 0 -7\n4 -103 2 3\n",
            [5.0..=7.0, 7.0..=7.0, 5.0..=7.0],
        ),
        (
            "2 12 1e6 0 0 1000002 2 2\n3 12 1000000.5 .5 .5 1000001.5 2 1.5\n4 -103 2 3\n",
            [1_000_000.5..=1_000_001.5, 2.0..=2.0, 0.5..=1.5],
        ),
    ] {
        let message = &messages(scene)[0];
        let (_, point) = message.rsplit_once('(').unwrap();
        let numbers = point.trim_end_matches(')').split(", ");
        for (x, range) in numbers.zip(&place) {
            let x: f64 = x.parse().unwrap();
            assert!(range.contains(&x), "{message}");
        }
    }
}

#[test]
fn a_tool_that_ends_flush() {
    let scene = cut("3 12 -0.5 0 -0.5 0.5 1 0.5 # pocket #");
    assert_eq!(found(&scene), ["W321 2:22"]);
    assert_eq!(
        messages(&scene),
        [
            "in the difference 4, the box 3 ends flush with the box 2: they share a face around (0, 1, 0)"
        ]
    );
    assert_eq!(
        fixes(&scene),
        [("let it reach a hair further".into(), Applicability::Unsafe)]
    );
    assert_eq!(
        fixed(&scene),
        cut("3 12 -0.5 0 -0.5 0.5 1.001 0.5 # pocket #")
    );
    silent(&fixed(&scene));
}

#[test]
fn the_edge_of_the_distance() {
    // The tool's longest side is 1: 1e-9 of it counts as none.
    silent(&cut("3 12 -0.5 0 -0.5 0.5 1.0000000011 0.5"));
    silent(&cut("3 12 -0.5 0 -0.5 0.5 0.9999999989 0.5"));
    flush(&cut("3 12 -0.5 0 -0.5 0.5 1.0000000009 0.5"));
    flush(&cut("3 12 -0.5 0 -0.5 0.5 0.9999999991 0.5"));
}

#[test]
fn tools_of_all_kinds_and_their_fixes() {
    for (tool, longer) in [
        ("3 4 0 -1 0 1", None),
        ("3 16 1 0.5", Some("3 16 1.001 0.5005")),
        ("3 17 1 0.5", Some("3 17 1.001 0.5005")),
        ("3 1 2 0.5 0 0.5 1", Some("3 1 2 0.5 0 0.5 1.001")),
        ("3 1 2 0.5 1 0.5 -1", Some("3 1 2 0.5 1.002 0.5 -1.002")),
        (
            "3 1 4 0.2 0 0.4 0 0.4 1 0.2 1",
            Some("3 1 4 0.2 0 0.4 0 0.4 1.001 0.2 1.001"),
        ),
        (
            "3 1 5 0.2 0 0.4 0 0.4 1 0.2 1 0.2 0",
            Some("3 1 5 0.2 0 0.4 0 0.4 1.001 0.2 1.001 0.2 0"),
        ),
        (
            "3 2 2 0.5 0 0.5 1 1 1 1 0 0 0",
            Some("3 2 2 0.5 0 0.5 1.001 1 1 1 0 0 0"),
        ),
    ] {
        let scene = cut(tool);
        match longer {
            Some(longer) => {
                flush(&scene);
                assert_eq!(fixed(&scene), cut(longer));
                silent(&fixed(&scene));
            }
            // Below y = 1 there is nothing left of the box but this face.
            None => silent(&scene),
        }
    }
    let more = |tool: &str| {
        format!("5 12 0 0 0 9 9 9\n6 12 -1 -1 -1 1 1 1\n2 -101 6 5\n{tool}\n4 -103 2 3\n")
    };
    let scene = more("3 4 0 1 0 -1");
    flush(&scene);
    // A thousandth of the box's side further up.
    assert_eq!(fixed(&scene), more("3 4 0 1 0 -1.002"));
    silent(&fixed(&scene));
}

#[test]
fn what_lies_against_a_face_is_fine() {
    // On top of the box, beside it, and with an edge or a corner on it.
    silent(&cut("3 12 -0.5 1 -0.5 0.5 2 0.5"));
    silent(&cut("3 12 1 -1 -1 3 1 1"));
    silent(&cut("3 12 1 0 -0.5 2 1 0.5"));
    silent(&cut("3 12 1 1 1 2 2 2"));
    // Through it, and within it.
    silent(&cut("3 12 -0.5 -2 -0.5 0.5 2 0.5"));
    silent(&cut("3 12 -0.5 -0.5 -0.5 0.5 0.5 0.5"));
    // The same plane, elsewhere.
    silent(&cut("3 12 5 0 5 6 1 6"));
}

#[test]
fn equal_shapes_are_decided_exactly() {
    silent(&cut("3 12 -1 -1 -1 1 1 1"));
    silent("2 9 1\n3 11 0 0 0 1\n4 -103 2 3\n5 -102 2 3\n");
    silent("2 12 -1 -1 -1 1 1 1\n3 -105 2\n4 -103 2 3\n");
    // Nearly equal ones are not.
    flush("2 9 1\n3 9 1.0000000001\n4 -103 2 3\n");
    flush("2 9 1\n3 9 1\n3 -2 30 1\n4 -103 2 3\n");
}

#[test]
fn intersections() {
    let both = |b: &str| format!("2 12 -1 -1 -1 1 1 1\n3 {b}\n4 -102 2 3\n");
    let touching = both("12 -0.5 1 -0.5 0.5 2 0.5");
    assert_eq!(
        messages(&touching),
        [
            "in the intersection 4, the box 3 and the box 2 only touch: they share a face around (0, 1, 0)"
        ]
    );
    assert!(fixes(&touching).is_empty());
    // Faces that look the same way are in one place whoever wins.
    silent(&both("12 -0.5 0 -0.5 0.5 1 0.5"));
    flush(&both("4 0 -1 0 1"));
    silent(&both("4 0 1 0 -1"));
    // A complement cuts like a difference.
    let pocket = "2 12 -1 -1 -1 1 1 1\n3 12 -0.5 0 -0.5 0.5 1 0.5\n5 -104 3\n4 -102 2 5\n";
    flush(pocket);
    silent(&fixed(pocket));
}

#[test]
fn two_holes_that_meet() {
    let scene = "2 12 -2 -2 -2 2 2 2\n3 12 -1 -1 -1 0 1 1\n4 12 0 -1 -1 1 1 1\n\
                 5 -103 2 3\n6 -103 5 4\n";
    assert_eq!(
        messages(scene),
        [
            "in the difference 6, the box 4 cuts up to where the box 3 does: they share a face around (0, 0, 0)"
        ]
    );
    silent(&fixed(scene));
    // As a union, taken away at once, they leave no wall.
    silent(
        "2 12 -2 -2 -2 2 2 2\n3 12 -1 -1 -1 0 1 1\n4 12 0 -1 -1 1 1 1\n5 -101 3 4\n6 -103 2 5\n",
    );
}

#[test]
fn round_faces() {
    // A shaft of a pin's own radius, cut from above; and of a slightly smaller one.
    let pin = |r: &str| format!("2 1 2 1 -1 1 1\n3 1 2 {r} 0 {r} 2\n4 -103 2 3\n");
    flush(&pin("1"));
    assert!(fixes(&pin("1")).is_empty());
    silent(&pin("0.99"));
    // Elsewhere along the same axis.
    silent("2 1 2 1 -1 1 1\n3 1 2 1 1.5 1 2\n4 -103 2 3\n");
    // The mantle of one cone, in pieces of two profiles, turned and moved alike.
    let cone = "2 1 2 0 0 2 4\n3 1 2 0.5 1 1.5 3\n";
    let moved = "2 -2 31 1\n3 -2 31 1\n2 -1 1 2 3\n3 -1 1 2 3\n";
    flush(&format!("{cone}{moved}4 -103 2 3\n"));
    // Nested and touching ones.
    silent("2 9 2\n3 9 1\n4 -103 2 3\n");
    silent("2 9 2\n3 11 1 0 0 1\n4 -103 2 3\n");
    // A cylinder that touches a side of the box along a line.
    silent(&cut("3 1 2 1 -2 1 2"));
    flush("2 14 2 0.5\n3 14 2 0.5\n3 -2 20 2\n4 -103 2 3\n");
    flush("2 10 1 2 1\n3 9 1\n3 -3 1 2 1\n4 -103 2 3\n");
}

#[test]
fn moved_turned_and_nested() {
    // The tool ends flush only once it is moved; the workpiece is turned with it.
    let scene = "2 12 -1 -1 -1 1 1 1\n3 12 -0.5 -0.5 -0.5 0.5 0.5 0.5\n3 -1 0 0.5 0\n\
                 2 -2 33 1\n3 -2 33 1\n2 -1 100 0 0\n3 -1 100 0 0\n4 -103 2 3\n";
    flush(scene);
    silent(&fixed(scene));
    silent(&scene.replace("3 -1 0 0.5 0", "3 -1 0 0.6 0"));
    // What the tool is flush with is covered by another part of the operand.
    let covered = |top: &str| {
        format!(
            "2 12 -1 -1 -1 1 1 1\n5 12 -1 -1 -1 1 {top} 1\n6 -101 2 5\n\
             3 12 -0.5 0 -0.5 0.5 1 0.5\n4 -103 6 3\n"
        )
    };
    silent(&covered("1.5"));
    flush(&covered("0.5"));
    // The tool is cut back itself; the workpiece has a hole there.
    silent(
        "2 12 -1 -1 -1 1 1 1\n5 12 -0.6 -2 -0.6 0.6 2 0.6\n6 -103 2 5\n\
            3 12 -0.5 0 -0.5 0.5 1 0.5\n4 -103 6 3\n",
    );
}

#[test]
fn no_fix_for_what_is_used_elsewhere() {
    let scene = "2 12 -1 -1 -1 1 1 1\n3 12 -0.5 0 -0.5 0.5 1 0.5\n4 -103 2 3\n5 -101 4 3\n";
    flush(scene);
    assert!(fixes(scene).is_empty());
}

#[test]
fn no_fix_that_would_leave_nothing() {
    let wall = |tool: &str| format!("2 12 -1 -1 -1 1 1 1\n3 {tool}\n4 -103 2 3\n");
    for all in ["12 -2 -2 -2 2 0.9999999999999998 2", "4 0 1 0 -1"] {
        flush(&wall(all));
        assert!(fixes(&wall(all)).is_empty());
    }
    assert_eq!(fixes(&wall("12 -2 -0.9 -2 2 1 2")).len(), 1);
}

#[test]
fn many_holes_are_found_in_a_chain() {
    let mut scene = String::from("2 12 0 0 0 1000 1 1000\n");
    let mut id = 2;
    for i in 0..500 {
        let (x, z) = (i % 25 * 30 + 10, i / 25 * 30 + 10);
        let top = if i == 250 { "1" } else { "2" };
        let (tool, next) = (id + 1, id + 2);
        scene += &format!(
            "{tool} 12 {x} -1 {z} {} {top} {}\n{next} -103 {id} {tool}\n",
            x + 5,
            z + 5
        );
        id = next;
    }
    assert_eq!(found(&scene).len(), 1);
}

#[test]
fn long_chains_and_shared_parts_end() {
    // A plate with fifty thousand flush holes, and a difference of copies of copies.
    let mut plate = String::from("2 12 0 0 0 1e6 1 1e6\n");
    for i in 0..50_000 {
        let (tool, next, last) = (2 * i + 3, 2 * i + 4, 2 * i + 2);
        let (x, z) = (i % 250 * 30 + 10, i / 250 * 30 + 10);
        plate += &format!(
            "{tool} 12 {x} 0.5 {z} {} 1 {}\n{next} -103 {last} {tool}\n",
            x + 5,
            z + 5
        );
    }
    let mut copies = String::from("2 12 0 0 0 1 1 1\n");
    for i in 2..60 {
        let (copy, sum) = (2 * i + 100, 2 * i + 101);
        let of = if i == 2 { 2 } else { 2 * i + 99 };
        copies += &format!("{copy} -105 {of}\n{copy} -1 0 1 0\n{sum} -103 {of} {copy}\n");
    }
    for scene in [plate, copies] {
        // A second in a release build; this is for what never ends.
        found(&scene);
    }
}

#[test]
fn what_is_covered_or_cut_off_later_is_not_seen() {
    let flush_cut = "2 12 0 0 0 2 2 2\n3 12 .5 .5 .5 1.5 2 1.5\n4 -103 2 3\n";
    let later = |rest: &str| format!("{flush_cut}{rest}");
    flush(&later("1 9999 4 0\n"));
    // Swallowed by a union, cut off by a difference, left out of an intersection.
    silent(&later("5 12 -1 -1 -1 3 3 3\n6 -101 4 5\n1 9999 6 0\n"));
    silent(&later("5 12 -1 1 -1 3 3 3\n6 -103 4 5\n1 9999 6 0\n"));
    silent(&later("5 12 -1 -1 -1 3 1 3\n6 -102 4 5\n1 9999 6 0\n"));
    // Taken away from something that is not there; and from something that is.
    silent(&later("5 12 5 5 5 6 6 6\n6 -103 5 4\n1 9999 6 0\n"));
    flush(&later("5 12 -1 -1 -1 3 3 3\n6 -103 5 4\n1 9999 6 0\n"));
    // What covers it ends in the very plane: it has its own say there.
    silent(&later("5 12 -1 -1 -1 3 2 3\n6 -101 4 5\n1 9999 6 0\n"));
    // Covered by a part of it only: the rest is seen, and the place named is of the rest.
    let partly = later("5 12 -1 1 -1 1.1 3 3\n6 -101 4 5\n1 9999 6 0\n");
    let message = &messages(&partly)[0];
    let (_, point) = message.rsplit_once('(').unwrap();
    let x: f64 = point.split(',').next().unwrap().parse().unwrap();
    assert!((1.1..=1.5).contains(&x), "{message}");
    // Outside of the render box; within it.
    silent(&later("1 9999 4 0 -1 -1 -1 3 1.9 3 # zpg: allow(W312) #\n"));
    flush(&later("1 9999 4 0 -1 -1 -1 3 2.1 3\n"));
    // Not drawn at all; drawn in one of two places.
    assert_eq!(
        messages(&later("5 9 1\n1 9999 5 0\n")),
        ["the difference 4 is not part of what is drawn"]
    );
    flush(&later(
        "5 12 -1 -1 -1 3 3 3\n6 -105 4\n6 -1 9 0 0\n7 -101 4 5\n8 -101 7 6\n1 9999 8 0\n",
    ));
    // Without a render record the operation's own result counts.
    flush(&later("5 12 -1 -1 -1 3 3 3\n6 -101 4 5\n"));
}

/// A place is named only if it shows at three points around it too, at a hundred times the distance
/// that counts as none, here 1.5e-9, since the tool is 1.5 long: the furthest is 0.9 of that across the slit.
#[test]
fn the_edge_of_what_is_around() {
    let slit = |half: f64| {
        format!(
            "2 12 0 0 0 2 2 2\n3 12 .5 .5 .5 1.5 2 1.5\n4 -103 2 3\n5 12 -1 1 -1 {:?} 3 3\n\
             7 12 {:?} 1 -1 3 3 3\n8 -101 5 7\n6 -101 4 8\n1 9999 6 0\n",
            1.0 - half,
            1.0 + half
        )
    };
    flush(&slit(1.4e-7));
    silent(&slit(1.3e-7));
    silent(&slit(1e-12));
}

#[test]
fn the_place_named_is_in_the_scene_that_is_drawn() {
    let scene =
        "2 12 -1 -1 -1 1 1 1\n3 12 -.5 0 -.5 .5 1 .5\n4 -103 2 3\n4 -1 10 20 30\n1 9999 4 0\n";
    assert!(messages(scene)[0].ends_with("around (10, 21, 30)"));
}

#[test]
fn half_spaces_that_touch() {
    let both = |a: &str, b: &str| format!("2 4 {a}\n3 4 {b}\n4 -102 2 3\n");
    assert_eq!(
        messages(&both("0 1 0 0", "0 -1 0 0")),
        [
            "in the intersection 4, the half-space 3 and the half-space 2 only touch: they share a face around (0, 0, 0)"
        ]
    );
    // One equation times any factor; elsewhere than at the origin; at an angle.
    flush(&both("0 1 0 -5", "0 -3 0 15"));
    flush(&both("0.1 0.2 0.3 0.4", "-0.3 -0.6 -0.9 -1.2"));
    // A slab, nothing at all, and a distance that is no rounding, however near to the origin.
    silent(&both("0 1 0 -1", "0 -1 0 0"));
    silent(&both("0 1 0 1", "0 -1 0 0"));
    silent(&both("0 1 0 -1e-12", "0 -1 0 0"));
    flush(&both("0 1 0 -5", "0 -1 0 5.000000004"));
    silent(&both("0 1 0 -5", "0 -1 0 5.000000011"));
    // A wedge and two of one kind.
    silent(&both("0 1 0 0", "1 0 0 0"));
    silent(&both("0 1 0 0", "0 2 0 0"));
}

#[test]
fn quadrics_of_one_surface() {
    for q in [
        "15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 -1",
        "18",
        "19 1 2",
        "20 1 2 3 1",
        "20 1 2 1 2",
        "21",
    ] {
        let moved = "2 -2 30 3\n2 -1 1 2 3\n";
        let same = |rest: &str| {
            format!(
                "2 {q}\n3 {q}\n{moved}{}{rest}4 -103 2 3\n",
                moved.replace("2 -", "3 -")
            )
        };
        // In one place by other records: turned on and back.
        flush(&same("3 -2 20 1\n3 -2 -20 1\n"));
        silent(&same(""));
        silent(&same("3 -1 1 0 0\n"));
    }
    // A matrix times a factor, and its opposite.
    let ball = |f: f64| format!("15 {f} 0 0 0  0 {f} 0 0  0 0 {f} 0  0 0 0 {}", -4.0 * f);
    let pair = |f: f64, op: &str| format!("2 {}\n3 {}\n4 {op} 2 3\n", ball(1.0), ball(f));
    flush(&pair(3.0, "-103"));
    flush(&pair(-3.0, "-102"));
    silent(&pair(3.0, "-102"));
    silent(&pair(-3.0, "-103"));
}

#[test]
fn operands_are_named_as_they_are_written() {
    let scene = "2 12 0 0 0 1 1 1\n3 -105 2\n3 -1 0 1 0\n4 -102 2 3\n";
    assert_eq!(
        messages(scene),
        [
            "in the intersection 4, the box 3 and the box 2 only touch: they share a face around (0.5, 1, 0.5)"
        ]
    );
    // A shape within a copy of more.
    let scene = "2 12 0 0 0 1 1 1\n5 9 .1\n6 -101 2 5\n3 -105 6\n3 -1 0 1 0\n4 -102 6 3\n";
    assert_eq!(
        messages(scene),
        [
            "in the intersection 4, the box 2 in the copy 3 and the box 2 only touch: they share a face around (0.5, 1, 0.5)"
        ]
    );
    // What is copied as a whole is named without the copy.
    let scene = "2 12 0 0 0 2 2 2\n3 12 .5 .5 .5 1.5 2 1.5\n4 -103 2 3\n5 -105 4\n1 9999 5 0\n";
    assert!(
        messages(scene)[0].starts_with("in the difference 4, the box 3 ends flush with the box 2:")
    );
}

#[test]
fn every_tool_of_many_is_found() {
    const COUNT: usize = 10_000;
    let tool = |id: usize, i: usize, deep: &str| {
        let (x, z) = (i % 100 * 30 + 10, i / 100 * 30 + 10);
        format!("{id} 12 {x} {deep} {z} {} 1 {}\n", x + 5, z + 5)
    };
    // One after the other, and in one union.
    let mut chain = String::from("2 12 0 0 0 1e4 1 1e4\n");
    let mut union = chain.clone();
    for i in 0..COUNT {
        let (id, sum, last) = (2 * i + 3, 2 * i + 4, 2 * i + 2);
        chain += &format!("{}{sum} -103 {last} {id}\n", tool(id, i, "0.5"));
        union += &tool(id, i, "0.5");
        if i > 0 {
            let last = if i == 1 { 3 } else { last };
            union += &format!("{sum} -101 {last} {id}\n");
        }
    }
    union += &format!("{} -103 2 {}\n", 2 * COUNT + 10, 2 * COUNT + 2);
    for scene in [chain, union] {
        assert_eq!(found(&scene).len(), COUNT);
    }
}

#[test]
fn states_of_one_shape() {
    // A tool that was part of what it cuts, in another place.
    let scene =
        "5 12 1 0 0 2 1 1\n6 12 -1 0 0 0 1 1\n9 -101 6 5\n5 -1 0 .5 .5\n10 -103 9 5\n1 9999 10 0\n";
    let says = messages(scene);
    assert!(
        says.iter()
            .any(|m| m.contains("the box 5 ends flush with the box 5 in 9")),
        "{says:?}"
    );
}

/// Round faces of different kinds of shapes that lie in one surface.
#[test]
fn cylinders_and_quadrics() {
    let cut = |one: &str, two: &str| {
        let scene = format!("2 {one}\n3 {two}\n4 -103 2 3\n1 9999 4 0\n");
        found(&scene)
            .iter()
            .filter(|f| f.starts_with("W321"))
            .count()
    };
    let quadric = |r2: f64| format!("15 1 0 0 0  0 0 0 0  0 0 1 0  0 0 0 -{r2}");
    let ring = "1 4 0.5 0 1 0 1 2 0.5 2";
    assert_eq!(cut(ring, &quadric(1.0)), 1);
    assert_eq!(cut(ring, &quadric(1.01)), 0);
    let ball = |d: f64| format!("15 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 -{d}");
    assert_eq!(cut("9 2", &ball(4.0)), 1);
    assert_eq!(cut("9 2", &ball(3.9)), 0);
    let cone = "15 1 0 0 0  0 -0.25 0 0  0 0 1 0  0 0 0 0";
    assert_eq!(cut("16 2 1", cone), 1);
    assert_eq!(cut("16 2 1.1", cone), 0);
}
