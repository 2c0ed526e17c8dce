//! Scenes of 100 000 objects through all rules of the linter: seconds to read them, and for the rules
//! together. With paths, those scenes instead.
//!
//! Then the small pictures of W330, which looks at scenes without ambient light: milliseconds for 1000 random scenes, and
//! for those of the gallery and the hard ones.

#[path = "../tests/lint_generated/scenes.rs"]
mod random;
#[path = "../tests/campaign/rng.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod rng;

/// Where the random scenes look for their numbers.
mod campaign {
    pub(crate) use super::rng;
}

use std::path::Path;
use std::time::Instant;

use cpu_time::ProcessTime;
use zpg::internals::diagnostics::{Code, SourceFile};
use zpg::internals::{lint, scene, syntax};

/// Shapes in each scene.
const OBJECTS: usize = 100_000;

/// The ID of the first of them; below are camera, light and what one scene needs besides.
const FIRST: usize = 10;

/// Where the IDs of operations begin.
const OPERATIONS: usize = 1_000_000;

/// A number from −1 to 1 that follows no order (Steele and others, SplitMix64).
fn odd(i: usize, k: usize) -> f64 {
    let mut z = (8 * i + k + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ z >> 31) >> 44) as f64 / f64::from(1 << 19) - 1.0
}

/// A scene made of its objects and operations.
#[derive(Default)]
struct Text {
    lines: Vec<String>,
    operations: usize,
}

impl Text {
    fn new(object: impl Fn(usize) -> String) -> Text {
        let lines = (0..OBJECTS).map(|i| object(i).replace("ID", &(FIRST + i).to_string()));
        Text {
            lines: lines.collect(),
            operations: 0,
        }
    }

    /// Joins two objects; the result's ID.
    fn join(&mut self, operation: i32, a: usize, b: usize) -> usize {
        let id = OPERATIONS + self.operations;
        self.operations += 1;
        self.lines.push(format!("{id} {operation} {a} {b}"));
        id
    }

    /// Joins these objects in pairs, then the results.
    fn tree(&mut self, operation: i32, mut ids: Vec<usize>) -> usize {
        while ids.len() > 1 {
            let pairs = ids.chunks(2);
            ids = pairs
                .map(|pair| match *pair {
                    [a, b] => self.join(operation, a, b),
                    _ => pair[0],
                })
                .collect();
        }
        ids[0]
    }

    /// Joins these objects one after the other.
    fn chain(&mut self, operation: i32, ids: Vec<usize>) -> usize {
        let joined = ids.into_iter().reduce(|a, b| self.join(operation, a, b));
        joined.expect("an object")
    }

    fn drawn(mut self, root: usize) -> String {
        self.lines.push(format!(
            "9 -402 1\n9 -1 3 5 5\n8 -501 0 0 90 0 0 -1 0 1 0 45\n1 9999 {root} 0\n"
        ));
        self.lines.join("\n")
    }
}

fn all() -> Vec<usize> {
    (FIRST..FIRST + OBJECTS).collect()
}

/// The objects of a grid whose place has an even sum, or an odd one.
fn every_other(odd: usize) -> Vec<usize> {
    let is = |id: &usize| {
        let [x, y, z] = place(id - FIRST);
        (x + y + z) % 2 == odd
    };
    all().into_iter().filter(is).collect()
}

fn place(i: usize) -> [usize; 3] {
    [i % 47, i / 47 % 47, i / 47 / 47]
}

fn brick(i: usize) -> String {
    let [x, y, z] = place(i);
    format!("ID 12 {x} {y} {z} {} {} {}", x + 1, y + 1, z + 1)
}

/// Shapes all about one place, each with a look of its own.
fn crowd(shape: &str) -> impl Fn(usize) -> String {
    move |i| {
        let [x, y, z] = [1, 2, 3].map(|k| odd(i, k));
        let size = 1.5 + odd(i, 4) / 2.0;
        let shape = shape.replace("SIZE", &format!("{size:.3}"));
        let look = 0.5 + odd(i, 5) / 2.1;
        format!("ID {shape}\nID -1 {x:.3} {y:.3} {z:.3}\nID -201 0 0 {look:.6}")
    }
}

fn kinds() -> Vec<(&'static str, String)> {
    let one = |mut text: Text, operation: i32| {
        let root = text.tree(operation, all());
        text.drawn(root)
    };
    let chain = |mut text: Text, operation: i32| {
        let root = text.chain(operation, all());
        text.drawn(root)
    };
    let two = |mut text: Text, operation: i32| {
        let [a, b] = [0, 1].map(|odd| text.tree(-101, every_other(odd)));
        let root = text.join(operation, a, b);
        text.drawn(root)
    };
    let pairs = |mut text: Text, operation: i32| {
        let ids = all();
        let joined = ids
            .chunks_exact(2)
            .map(|p| text.join(operation, p[0], p[1]))
            .collect();
        let root = text.tree(-101, joined);
        text.drawn(root)
    };
    let ball = |i: usize| {
        let [x, y, z] = [1, 2, 3].map(|k| 20.0 * odd(i, k));
        format!("ID 11 {x:.3} {y:.3} {z:.3} 1")
    };
    let glass = |i: usize| {
        let kt = 0.5 + odd(i, 4) / 2.1;
        format!("{}\nID -201 0 0 {kt:.5}", ball(i))
    };
    let wall = |mut text: Text| {
        text.lines.push("3 12 -10 -10 -1 60 60 60".into());
        let mut ids = vec![3];
        ids.extend(all());
        let root = text.chain(-103, ids);
        text.drawn(root)
    };
    let flush = |i: usize| {
        let x = i / 2 * 3;
        match i % 2 {
            0 => format!("ID 12 {x} 0 0 {} 2 2", x + 2),
            _ => format!("ID 12 {x}.5 0.5 0.5 {}.5 2 1.5", x + 1),
        }
    };
    let turned = |i: usize| match i % 2 {
        0 => format!("ID 12 0 0 0 1 1 1\nID -2 {} 1\nID -2 45 3", i % 90),
        _ => "ID 12 1 1 0 2 2 1".to_owned(),
    };
    let bound = |i: usize| {
        let [x, y, z] = [1, 2, 3].map(|k| 50.0 * odd(i, k));
        let r = 1.0 + 0.2 * odd(i, 4);
        format!("ID 14 0.7 0.3\nID -1 {x:.3} {y:.3} {z:.3}\nID -602 {x:.3} {y:.3} {z:.3} {r:.3}")
    };
    vec![
        ("spheres, a union", one(Text::new(ball), -101)),
        (
            "spheres of many kinds of glass, a chain",
            chain(Text::new(glass), -101),
        ),
        ("bricks side by side, a union", one(Text::new(brick), -101)),
        (
            "every other brick without the others",
            two(Text::new(brick), -103),
        ),
        (
            "every other brick within the others",
            two(Text::new(brick), -102),
        ),
        ("a wall without all of its bricks", wall(Text::new(brick))),
        ("blocks with flush cuts", pairs(Text::new(flush), -103)),
        (
            "turned boxes that do not meet",
            pairs(Text::new(turned), -102),
        ),
        (
            "boxes in one place, an intersection",
            one(Text::new(crowd("12 0 0 0 SIZE 1 SIZE")), -102),
        ),
        (
            "boxes in one place, a difference",
            chain(Text::new(crowd("12 0 0 0 SIZE 1 SIZE")), -103),
        ),
        (
            "ellipsoids in one place, an intersection",
            one(
                Text::new(crowd("15 SIZE 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1")),
                -102,
            ),
        ),
        ("tori with bounding spheres", one(Text::new(bound), -101)),
    ]
}

/// The scene without ambient light.
fn darkened(text: &str) -> String {
    let lines = text.lines().map(|line| {
        let mut words = line.split_whitespace();
        match (words.next(), words.next()) {
            (Some(id), Some("-401")) => format!("{id} -401 0\n"),
            _ => format!("{line}\n"),
        }
    });
    lines.collect()
}

/// Milliseconds of CPU that W330 takes for a scene, the best of three times, and whether it says something.
fn looked(text: String) -> (f64, bool) {
    let source = SourceFile::new("scene.zpg", text.into_bytes());
    let (document, mut found) = syntax::parse(&source.text);
    let scene = scene::resolve(&document, &source, &mut found);
    let mut time = f64::INFINITY;
    for _ in 0..3 {
        found.clear();
        let start = ProcessTime::now();
        let bounds = Default::default();
        let context = lint::Context::new(&source.text, &document, &scene, &bounds);
        lint::run(&context, |code| code == Code::W330, &mut found);
        time = time.min(1e3 * start.elapsed().as_secs_f64());
    }
    (time, found.iter().any(|d| d.code == Code::W330))
}

fn small_pictures() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let scenes = |name: &str| {
        let entries = std::fs::read_dir(folder.join(name)).expect("the folder of scenes");
        let paths = entries.map(|e| e.expect("a file").path());
        let scenes = paths.filter(|p| p.extension().is_some_and(|e| e == "zpg"));
        scenes.map(|p| std::fs::read_to_string(p).expect("a scene"))
    };
    let kinds: [(&str, Vec<String>); 2] = [
        ("1000 random scenes", (0..1000).map(random::scene).collect()),
        (
            "gallery and hard scenes",
            scenes("gallery").chain(scenes("hard")).collect(),
        ),
    ];
    println!(
        "\n{:<44} {:>8} {:>8} {:>9}",
        "W330", "median", "max", "findings"
    );
    for (name, texts) in kinds {
        let all = texts.iter().map(|text| looked(darkened(text)));
        let (mut times, said): (Vec<f64>, Vec<bool>) = all.unzip();
        times.sort_unstable_by(f64::total_cmp);
        let (median, max) = (times[times.len() / 2], times[times.len() - 1]);
        let said = said.iter().filter(|s| **s).count();
        println!("{name:<44} {median:>5.2} ms {max:>5.2} ms {said:>9}");
    }
}

fn main() {
    let paths: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let read = |path: &String| std::fs::read_to_string(path).expect("a scene");
    let mut scenes: Vec<(&str, String)> = paths.iter().map(|p| (p.as_str(), read(p))).collect();
    let is_all = scenes.is_empty();
    if is_all {
        scenes = kinds();
    }
    println!("{:<44} {:>8} {:>8} {:>9}", "", "read", "rules", "findings");
    for (name, text) in scenes {
        let start = Instant::now();
        let source = SourceFile::new(name, text.into_bytes());
        let (document, mut found) = syntax::parse(&source.text);
        let scene = scene::resolve(&document, &source, &mut found);
        let read = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let bounds = Default::default();
        let context = lint::Context::new(&source.text, &document, &scene, &bounds);
        lint::run(&context, |_| true, &mut found);
        let rules = start.elapsed().as_secs_f64();
        assert!(!found.iter().any(|d| d.is_error()), "{name}");
        println!("{name:<44} {read:>6.2} s {rules:>6.2} s {:>9}", found.len());
    }
    if is_all {
        small_pictures();
    }
}
