//! Tests of first hits against spans and double-double.

use super::*;
use crate::geometry::dd::Dd;
use crate::testing::{random, scene};
use crate::trace::Tracer;
use crate::trace::search::events::Kind;
use crate::trace::search::query::QueryStatus;
use crate::trace::search::spans::{first_of_kind, is_seen};
use std::fmt::Write;

/// Solids that meet each other, and panes, of so many of the kinds two glasses and something opaque: spheres, tori,
/// lenses, hollow balls, and unions that are painted and moved as a whole. Parts of some are of different kinds. Some
/// scenes have complements, or panes in the faces of solids.
fn things(next: &mut impl FnMut(u64) -> u64, kinds: u64) -> String {
    let mut text = String::from(
        "2 -201 0 0.1 0.9\n2 -203 1.5 1.4 1.3\n3 -201 0 0.2 0.8\n3 -203 1.3 1.3 1.3\n4 -201 1 0 0\n",
    );
    let (mut root, mut numbers, mut kind) = (0, [0.0; 4], 0);
    for id in (10..70).step_by(10) {
        // Now and then the same thing once more, in the same place.
        if root == 0 || next(6) > 0 {
            numbers = [0; 4].map(|_| (next(4001) as f64 - 2000.0) / 2500.0);
            kind = next(6);
        }
        let [x, y, z, r] = numbers;
        let ([a, b], size) = ([id + 1, id + 2], 0.2 + r.abs());
        let half = size / 2.0;
        let shape = match kind {
            0 => format!("{id} 9 {size}\n"),
            1 => format!("{id} 14 {size} {}\n", size / 3.0),
            // What two balls have in common, one without another in it, and both.
            2 => format!("{a} 9 {size}\n{b} 11 0.3 0 0 {size}\n{id} -102 {a} {b}\n"),
            3 => format!("{a} 9 {size}\n{b} 9 {half}\n{id} -103 {a} {b}\n"),
            4 => format!("{a} 9 {half}\n{b} 11 0.4 0 0 {half}\n{id} -101 {a} {b}\n"),
            _ => format!("{id} 5 -{size} -{size} {size} {size}\n"),
        };
        let mut paint = |id: u32| format!("{id} -299 0 {}\n", 2 + next(kinds));
        let painted = match shape.lines().count() {
            3 if id % 20 == 0 => paint(a) + &paint(b),
            _ => paint(id),
        };
        let _ = writeln!(text, "{shape}{painted}{id} -1 {x} {y} {z}");
        if root > 0 {
            let _ = writeln!(text, "{} -101 {root} {id}", id + 5);
        }
        root = if root > 0 { id + 5 } else { id };
    }
    let special = match next(20) {
        // All of space, since a plane has no inside.
        0 => "80 3 0 0 1 0.1\n81 -104 80\n81 -299 0 3",
        // A half-space with a pane in its face, all in glass.
        1 => {
            "80 4 0 0 1 0\n82 5 -1 -1 1 1\n82 -299 0 2\n83 9 20\n83 -299 0 3\n84 -101 82 80\n81 -101 84 83"
        }
        // All but two balls.
        2 => "80 9 0.8\n82 -104 80\n83 11 1 0 0 0.9\n81 -103 82 83\n81 -299 0 2",
        _ => "",
    };
    if !special.is_empty() {
        let _ = writeln!(text, "{special}\n90 -101 {root} 81");
        root = 90;
    }
    text + &format!("1 9999 {root} 0\n")
}

/// A ray to a light is answered from what is transparent alone where it meets nothing opaque.
#[test]
fn as_much_light_gets_through_as_all_spans_let_through() {
    let mut next = random();
    let mut counts = [0; 3];
    for _ in 0..300 {
        let text = things(&mut next, 3);
        let scene = scene(&text);
        let tracer = Tracer::new(&scene).unwrap();
        let mut walkers = tracer.walker::<f64>();
        for _ in 0..100 {
            let mut number = || next(2001) as f64 / 1000.0 - 1.0;
            let mut point = || Vec3::new(number(), number(), number()) * 2.0;
            let (from, to) = (point(), point());
            let mut ray = Ray::new(from, to - from);
            if !tracer.holds(&mut walkers, from) {
                ray.is_outside = true;
            }
            let found = walkers.visibility::<true>(&ray);
            let (_, events) = walkers.walker().trace_spans(&ray, 0.0, 1.0);
            let seen = events.iter().filter(|e| e.kind != Kind::Silent);
            let expected = seen.fold(Vec3::ONE, |share, event| {
                let optics = &tracer.graph.optics[event.owner.medium.optics as usize];
                share.times(Vec3(optics.kt))
            });
            assert_eq!(found, expected, "{text}\n{ray:?}");
            let kind = [expected == Vec3::ZERO, expected == Vec3::ONE];
            counts[kind.iter().position(|&k| k).unwrap_or(2)] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > 3000), "{counts:?}");
}

#[test]
fn the_nearest_crossing_says_what_spans_say() {
    let mut next = random();
    let [mut compared, mut outside] = [0; 2];
    for _ in 0..360 {
        let text = things(&mut next, 2);
        let scene = scene(&text);
        let tracer = Tracer::new(&scene).unwrap();
        let mut walkers = tracer.walker::<f64>();
        let mut finest = tracer.walker::<Dd>();
        for _ in 0..60 {
            let mut number = || next(2001) as f64 / 1000.0 - 1.0;
            let mut direction = || Vec3::new(number(), number(), number()).unit();
            let away = direction() * 9.0;
            let mut ray = Ray::new(away, (direction() * 2.0 - away).unit());
            if !tracer.holds(&mut walkers, away) {
                ray.is_outside = true;
            }
            for _ in 0..8 {
                let walker = walkers.walker();
                walker.status = QueryStatus::default();
                let found = walker.first_hit::<true>(&ray, (0.0, f64::INFINITY), false);
                let slow = walker.first_visible(&ray, 0.0, f64::INFINITY);
                let told = |h: Hit| {
                    (
                        h.t, h.inside, h.indices, h.surface, h.entering, h.in_face, h.colour,
                    )
                };
                assert_eq!(found.map(told), slow.map(told), "{text}\n{ray:?}");
                let (start, events) = walker.trace_spans(&ray, 0.0, f64::INFINITY);
                let first = start.and_then(|start| first_of_kind(start, events, is_seen));
                let place = first.map(|(_, event, states)| {
                    (event.t(), states.map(|s| s.inside), states.map(index_in))
                });
                let told = |h: Hit| (h.t, h.inside, h.indices);
                assert_eq!(found.map(told), place, "{text}\n{ray:?}");
                // Double-double takes no shortcut for the surface that the ray has left.
                let exact = finest.first_hit::<true>(&ray.cast());
                let told = |h: Hit| (h.inside, h.indices, h.surface, h.entering, h.in_face);
                let cast = exact.map(|h: Hit<Dd>| h.cast());
                assert_eq!(found.map(told), cast.map(told), "{text}\n{ray:?}");
                compared += 1;
                let Some(hit) = found.filter(|h| h.normal.dot(ray.line.direction) != 0.0) else {
                    break;
                };
                outside += u32::from(ray.is_outside);
                // On through the surface, or back from it, anywhere.
                let onwards = direction()[0] > -0.5;
                let mut out = direction();
                if (out.dot(hit.normal) < 0.0) != (hit.entering == onwards) {
                    out = -out;
                }
                ray = hit.leave(out, onwards);
            }
        }
    }
    assert!(compared > 25_000, "{compared}");
    assert!(outside > 3_000 && compared - outside > 8_000, "{outside}");
}

#[test]
fn shading_normals_are_on_the_geometric_side() {
    let up = Vec3::new(0.0, 0.0, 1.0);
    let at = |x, y, z| beside(Vec3::new(x, y, z), up);
    assert_eq!(at(0.0, 0.0, 4.0), up);
    assert_eq!(at(3.0, 0.0, -4.0), Vec3::new(-0.6, 0.0, 0.8));
    // Of no side, of no direction, and none at all.
    assert_eq!(at(1.0, 0.0, 1e-16), up);
    assert_eq!(at(0.0, 0.0, 0.0), up);
    assert_eq!(at(f64::NAN, 0.0, 1.0), up);
    // Flat, but of a side.
    assert!(at(1.0, 0.0, -1e-14).dot(up) > 0.0 && at(1.0, 0.0, -1e-14)[0] == -1.0);
}
