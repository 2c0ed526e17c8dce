//! Scenes of twenty thousand objects that make rules work hardest. Whatever is done for each pair of
//! objects, or for all of them each time, takes minutes here. `benches/lint.rs` measures the time.

use std::fmt::Write;

use zpg::internals::analysis::{Analysis, repair};
use zpg::internals::diagnostics::Code;
use zpg::internals::diagnostics::render::human::{self, Look};

const N: u32 = 20_000;

/// Where the IDs of results begin.
const RESULTS: u32 = 10_000_000;

/// Checks a scene of `N` objects, 2 and those after it, the way `zpg check` does; what is found.
#[track_caller]
fn check(object: impl Fn(u32) -> String, join: &str) -> Vec<&'static str> {
    let mut text = String::new();
    let (mut root, mut next) = (2, RESULTS);
    for id in 2..2 + N {
        writeln!(text, "{}", object(id)).unwrap();
    }
    for id in 3..2 + N {
        let operands = join.replace("ROOT", &root.to_string());
        let operands = operands.replace("ID", &id.to_string());
        if operands.is_empty() {
            break;
        }
        writeln!(text, "{next} {operands}").unwrap();
        (root, next) = (next, next + 1);
    }
    writeln!(text, "1 9999 {root} 0").unwrap();
    let loaded = Analysis::new("scene.zpg", text.into_bytes());
    let mut out = Vec::new();
    human::write(&mut out, &loaded.source, loaded.findings(), Look::default()).unwrap();
    assert!(out.len() < 1_000_000, "{} bytes", out.len());
    let mut codes: Vec<_> = loaded.findings().iter().map(|d| d.code.as_str()).collect();
    codes.sort_unstable();
    codes.dedup();
    codes
}

/// A coordinate that has no pattern.
fn odd(id: u32, k: u32) -> f64 {
    f64::from(id.wrapping_mul(2_654_435_761).rotate_left(7 * k) % 20_000) / 100.0 - 100.0
}

#[test]
fn bricks_of_a_wall_cut_flush() {
    let brick = |id: u32| {
        let (x, y, z) = (id % 28, id / 28 % 28, id / 784);
        format!("{id} 12 {x} {y} {z} {} {} {}", x + 1, y + 1, z + 1)
    };
    // Bricks side by side have no more than faces in common: nothing of them is cut.
    assert_eq!(check(brick, "-101 ROOT ID"), ["N602", "N603"]);
    assert_eq!(check(brick, "-102 ROOT ID"), ["N602", "N603", "W319"]);
    // Most of them do not even touch the first one.
    assert_eq!(check(brick, "-103 ROOT ID"), ["N602", "N603", "W332"]);
}

#[test]
fn tools_that_all_end_in_one_plane() {
    let tool = |id: u32| {
        let (x, z) = (odd(id, 1) / 1e4, odd(id, 2) / 1e4);
        let y = f64::from(id) / 1e4 + 1.0;
        format!("{id} 12 {x} 0 {z} {} {y} {}", x + 4.0, z + 4.0)
    };
    check(tool, "-103 ROOT ID");
    // And a sheet full of holes.
    let hole = |id: u32| match id {
        2 => "2 12 -200 -1 -200 200 1 200".to_owned(),
        _ => {
            let (x, z) = (odd(id, 1), odd(id, 2));
            format!("{id} 12 {x} -1 {z} {} 1 {}", x + 0.3, z + 0.3)
        }
    };
    assert!(check(hole, "-103 ROOT ID").contains(&"W321"));
}

#[test]
fn a_crowd_about_the_origin() {
    // Every box meets every other one, and differs from it.
    let member = |id: u32| {
        let [x, y, z] = [1, 2, 3].map(|k| odd(id, k) / 100.0);
        let [a, b, c] = [4, 5, 6].map(|k| 1.0 + odd(id, k) / 250.0);
        let seen = f64::from(id) / 1e5;
        format!("{id} 12 0 0 0 {a} {b} {c}\n{id} -1 {x} {y} {z}\n{id} -201 0 0 {seen}")
    };
    assert!(check(member, "-102 ROOT ID").contains(&"W308"));
    check(member, "-103 ROOT ID");
}

#[test]
fn glass_in_one_place() {
    let ball = |id: u32| {
        let [x, y, z] = [1, 2, 3].map(|k| odd(id, k) / 50.0);
        let share = f64::from(id) / 1e5;
        format!("{id} 11 {x} {y} {z} 1\n{id} -201 0 0 {share}")
    };
    assert!(check(ball, "-101 ROOT ID").contains(&"W307"));
    let concentric = |id: u32| format!("{id} 9 {id}\n{id} -201 0 0 {}", f64::from(id) / 1e5);
    assert!(check(concentric, "-101 ROOT ID").contains(&"W307"));
    // The smallest without a larger one.
    assert!(check(concentric, "-103 ROOT ID").contains(&"W319"));
}

#[test]
fn copies_of_one_thing() {
    let copy = |id: u32| match id {
        2 => "7000000 12 -1 -1 -1 1 1 1\n7000001 12 -0.5 -1 -0.5 0.5 1 0.5\n\
              7000002 -103 7000000 7000001\n2 -105 7000002"
            .to_owned(),
        _ => {
            let [x, y, z] = [1, 2, 3].map(|k| odd(id, k));
            format!(
                "{id} -105 7000002\n{id} -1 {x} {y} {z}\n{id} -2 {} 2",
                id % 360
            )
        }
    };
    assert!(check(copy, "-101 ROOT ID").contains(&"W321"));
}

#[test]
fn bounds_of_all_that_is_there() {
    let torus = |id: u32| format!("{id} 14 2 0.5");
    let bounded = |id: u32| {
        format!(
            "{}\n{id} -602 0 0 0 {}",
            torus(id),
            1.0 + f64::from(id) / 1e5
        )
    };
    assert!(check(bounded, "-101 ROOT ID").contains(&"W311"));
    // All of them of one object, and one of each step towards it.
    let last = N + 1;
    let many = |id: u32| match id {
        2 => torus(2),
        _ if id < last => torus(id),
        _ => {
            let mut text = torus(id);
            let mut root = 2;
            for i in 3..=last {
                let result = 20_000_000 + i;
                write!(text, "\n{result} -101 {root} {i}\n{result} -602 0 0 0 1").unwrap();
                root = result;
            }
            (0..N).for_each(|i| write!(text, "\n{root} -602 0 0 0 {}", 2 + i % 2).unwrap());
            text
        }
    };
    assert!(check(many, "-101 ROOT ID").contains(&"W311"));
}

#[test]
fn comments_that_allow_in_a_row() {
    let row = |id: u32| match id {
        2 => "# zpg: allow(W301) #\n".repeat(N as usize) + "2 9 1",
        _ => format!("# zpg: allow(W301) #\n{id} 9 1\n{id} -701 2 0 0 # zpg: allow(W301) #"),
    };
    assert!(check(row, "-101 ROOT ID").contains(&"S504"));
    let line = |id: u32| match id {
        2 => format!("2 9 1 {}", "# zpg: allow(W301) # ".repeat(N as usize)),
        _ => String::new(),
    };
    assert_eq!(check(line, ""), ["N602", "N603", "S504"]);
}

#[test]
fn operations_on_one_thing_twice() {
    let object = |id| match id {
        2 => "2 9 1".to_owned(),
        id => format!("{id} -101 2 2"),
    };
    assert!(check(object, "-101 ROOT ID").contains(&"W333"));
}

/// Unions of unions have 2⁴⁰ ways to one sphere; the camera, which takes z for up, is held against the floor.
#[test]
fn ways_to_one_thing() {
    let mut text = "2 11 0 1 0 1\n".to_owned();
    for id in 3..43 {
        writeln!(text, "{id} -101 {0} {0}", id - 1).unwrap();
    }
    text += "60 4 0 1 0 0\n61 -101 42 60\n90 -501 2 5 16 -0.12 -0.1 -1 0 0 1 35\n50 -402 1\n50 -1 5 5 5\n1 9999 61 0\n";
    let loaded = Analysis::new("scene.zpg", text.into_bytes());
    assert!(loaded.findings().iter().any(|d| d.code == Code::W328));
}

/// Where IDs are not defined, all lamps are asked whether something moves them.
#[test]
fn lamps_beside_moves_of_nothing() {
    let mut text = "2 11 0 0 0 1\n".to_owned();
    (0..N).for_each(|i| writeln!(text, "{} -402 0.1", 1000 + i).unwrap());
    (0..N).for_each(|i| writeln!(text, "{} -1 1 2 3", 1000 + i).unwrap());
    for id in RESULTS..RESULTS + 16 {
        writeln!(text, "{id} -1 1 2 3\n{id} -2 30 1").unwrap();
    }
    let loaded = Analysis::new("scene.zpg", (text + "1 9999 2 0\n").into_bytes());
    let told = repair::proposals(&loaded);
    let missing = told.iter().filter(|d| d.code == Code::E101);
    assert_eq!(missing.filter(|d| d.case == "missing").count(), 16);
}
