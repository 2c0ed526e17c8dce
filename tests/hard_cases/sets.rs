//! Rows about operations.

use super::ask::{Precision, Ray, Written, all_held, ask, data};
use super::cases;
use super::trace_support::Random;
use std::fmt::Write;

pub fn row_27_to_30_equal_faces(precision: Precision) {
    let mut r = Random(27);
    let rays: Vec<Ray> = (0..120)
        .map(|_| {
            let ray = r.ray(4.0);
            Ray::new(ray.line.origin.0, ray.line.direction.0)
        })
        .collect();
    let met = |name: &str| -> usize {
        let answers = all_held(&data(name), &rays, precision);
        answers.iter().map(|a| a.changes.len()).sum()
    };
    assert_eq!(met("sphere-less-itself.zpg"), 0);
    assert_eq!(met("box-less-itself.zpg"), 0);
    assert!(met("sphere-and-itself.zpg") > 20);
    assert!(met("flush-hole.zpg") > 20);
}

/// Records of a random tree over the shapes with IDs from `first`; its root is the last one.
fn tree(text: &mut String, r: &mut Random, first: u32) -> u32 {
    let mut id = first;
    for _ in 0..4 {
        let p = r.point(2.0).0;
        let (s, q) = (r.within(0.3, 1.2), r.point(1.0).abs().0);
        let [x, y, z] = p;
        let _ = match r.below(6) {
            0 => writeln!(text, "{id} 14 {} {}", 1.0 + s, 0.5 * s),
            1 => writeln!(text, "{id} 16 {x} {s}"),
            2 => writeln!(
                text,
                "{id} 12 {x} {y} {z} {} {} {}",
                x + q[0],
                y + q[1],
                z + q[2]
            ),
            3 => writeln!(text, "{id} 4 {x} {y} {z} {s}"),
            4 => writeln!(text, "{id} 20 {s} 1 {s} 1"),
            _ => writeln!(text, "{id} 11 {x} {y} {z} {s}"),
        };
        if r.below(2) == 0 {
            let _ = writeln!(
                text,
                "{id} -2 {} {}\n{id} -1 {y} {z} {x}",
                90.0 * s,
                1 + r.below(3)
            );
        }
        id += 1;
    }
    for _ in 0..4 {
        let operand = |r: &mut Random| first + r.below(u64::from(id - first)) as u32;
        let (a, b) = (operand(r), operand(r));
        let _ = match r.below(4) {
            3 => writeln!(text, "{id} -104 {a}"),
            k => writeln!(text, "{id} -{} {a} {b}", 101 + k),
        };
        id += 1;
    }
    id - 1
}

/// A − A, A ∩ A, A ∪ A, −(−A) and De Morgan's laws on random trees, ray by ray.
pub fn row_37_identities(precision: Precision) {
    let mut r = Random(37);
    let mut met = 0;
    let rounds = cases(3, 10);
    for _ in 0..rounds {
        let mut text = String::new();
        let a = tree(&mut text, &mut r, 10);
        let b = tree(&mut text, &mut r, 50);
        let _ = writeln!(
            text,
            "100 -103 {a} {a}\n101 -102 {a} {a}\n102 -101 {a} {a}\n103 -104 {a}\n104 -104 103\n\
             105 -104 {b}\n106 -101 103 105\n107 -104 106\n108 -102 {a} {b}\n\
             109 -102 103 105\n110 -104 109\n111 -101 {a} {b}\n112 -103 {a} {b}\n\
             113 -102 {a} 105\n114 -101 {a} 103\n2 -105 {a}"
        );
        let scene = Written::new(&text);
        let rays: Vec<Ray> = (0..60)
            .map(|_| {
                let ray = r.ray(4.0);
                Ray::new(ray.line.origin.0, ray.line.direction.0)
            })
            .collect();
        let of = |id: u32| {
            let said = ask(&scene.path, Some(id), &rays, precision);
            let plain = said.into_iter().map(|s| {
                let hits: Vec<_> = s.hits.into_iter().map(|h| (h.t, h.entering)).collect();
                (s.inside, hits)
            });
            plain.collect::<Vec<_>>()
        };
        assert!(of(100).iter().all(|s| *s == (false, vec![])), "{text}");
        assert!(of(114).iter().all(|s| *s == (true, vec![])), "{text}");
        let plain = of(a);
        met += plain.iter().map(|s| s.1.len()).sum::<usize>();
        for same in [101, 102, 104] {
            assert_eq!(of(same), plain, "{same}:\n{text}");
        }
        for (x, y) in [(107, 108), (110, 111), (113, 112)] {
            assert_eq!(of(x), of(y), "{x} {y}:\n{text}");
        }
    }
    assert!(met > 15 * rounds, "{met}");
}
