//! The twelve scenes: five of one kind each, and seven that are made to be hard. Then mixtures, and what rays alone are
//! measured on.

use std::fmt::Write;

pub struct Scene {
    pub name: String,
    /// Whether most of the time goes into intersections and differences.
    pub csg: bool,
    /// How many times as long POV-Ray is to take, where that is another number than for most.
    pub bar: Option<f64>,
    pub text: String,
}

/// Writes records, and hands out IDs.
struct Writer {
    text: String,
    next: u32,
    seed: u64,
}

impl Writer {
    fn new(seed: u64) -> Writer {
        Writer {
            text: String::new(),
            next: 10,
            seed,
        }
    }

    /// A number in a range: splitmix64 (Steele, Lea and Flood, 2014), to four decimals.
    fn real(&mut self, from: f64, to: f64) -> f64 {
        self.seed = self.seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.seed;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let share = (z ^ (z >> 31)) as f64 / u64::MAX as f64;
        ((from + (to - from) * share) * 1e4).round() / 1e4
    }

    fn reals<const N: usize>(&mut self, from: f64, to: f64) -> [f64; N] {
        [(); N].map(|()| self.real(from, to))
    }

    fn chance(&mut self, of: f64) -> bool {
        self.real(0.0, 1.0) < of
    }

    fn line(&mut self, record: impl std::fmt::Display) {
        writeln!(self.text, "{record}").expect("a string takes everything");
    }

    /// A definition under a new ID.
    fn new_record(&mut self, record: impl std::fmt::Display) -> u32 {
        self.next += 1;
        let id = self.next;
        self.line(format_args!("{id} {record}"));
        id
    }

    fn coloured(&mut self, id: u32) {
        let [r, g, b] = self.reals(0.2, 1.0);
        self.line(format_args!("{id} -701 {r} {g} {b}"));
    }

    fn turned(&mut self, id: u32) {
        let [a, b] = self.reals(0.0, 360.0);
        self.line(format_args!("{id} -2 {a} 1"));
        self.line(format_args!("{id} -2 {b} 2"));
    }

    fn moved(&mut self, id: u32, to: [f64; 3]) {
        let [x, y, z] = to;
        self.line(format_args!("{id} -1 {x} {y} {z}"));
    }

    fn scattered(&mut self, id: u32, size: f64) {
        let to = self.reals(-size, size);
        self.moved(id, to);
    }

    /// One union of all, as people write it: pair by pair.
    fn union(&mut self, parts: &[u32]) -> u32 {
        let mut all = parts[0];
        for part in &parts[1..] {
            all = self.new_record(format_args!("-101 {all} {part}"));
        }
        all
    }

    /// The same as a tree.
    fn tree(&mut self, mut parts: Vec<u32>) -> u32 {
        while parts.len() > 1 {
            let pair = |pair: &[u32]| match *pair {
                [a, b] => self.new_record(format_args!("-101 {a} {b}")),
                _ => pair[0],
            };
            parts = parts.chunks(2).map(pair).collect();
        }
        parts[0]
    }

    /// A floor and a wall, for glass to be seen before.
    fn room(&mut self) -> Vec<u32> {
        ["12 -12 -7 -12 12 -6 8", "12 -12 -6 -13 12 12 -12"]
            .map(|record| {
                let id = self.new_record(record);
                self.coloured(id);
                id
            })
            .into()
    }

    fn glass(&mut self, id: u32, index: f64) {
        self.line(format_args!("{id} -201 0.02 0.08 0.9"));
        self.line(format_args!("{id} -203 {index} {index} {index}"));
    }

    fn lamps(&mut self, positions: &[[f64; 3]], intensity: f64) {
        self.new_record("-401 0.15");
        for &at in positions {
            let lamp = self.new_record(format_args!("-402 {intensity}"));
            self.moved(lamp, at);
        }
    }

    /// The camera at a distance, and the render record.
    fn done(mut self, name: &str, csg: bool, root: u32, distance: f64) -> Scene {
        self.new_record(format_args!("-501 0 0 {distance} 0 0 -1 0 1 0 45"));
        let sky = self.new_record("-701 0.1 0.15 0.3");
        self.line(format_args!("1 9999 {root} {sky}"));
        Scene {
            name: name.to_owned(),
            csg,
            bar: None,
            text: self.text,
        }
    }
}

const TWO: [[f64; 3]; 2] = [[20.0, 30.0, 25.0], [-25.0, 15.0, 30.0]];

pub fn all(seed: u64) -> Vec<Scene> {
    vec![
        spheres(seed),
        holes(seed),
        tori(seed),
        glass(seed),
        lathes(seed),
        crowd(seed),
        facets(seed),
        textures(seed),
        lights(seed),
        machined(seed),
        lenses(seed),
        everything(seed),
    ]
}

fn spheres(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = Vec::new();
    for _ in 0..10_000 {
        let [x, y, z] = w.reals(-10.0, 10.0);
        let r = w.real(0.05, 0.25);
        let id = w.new_record(format_args!("11 {x} {y} {z} {r}"));
        w.coloured(id);
        if w.chance(0.2) {
            w.line(format_args!("{id} -201 0.6 0.4 0"));
        }
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("ten thousand spheres", false, root, 32.0)
}

fn holes(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = Vec::new();
    for _ in 0..500 {
        let [x, y, z] = w.reals(-4.0, 4.0);
        let r = w.real(0.3, 0.8);
        parts.push(w.new_record(format_args!("11 {x} {y} {z} {r}")));
    }
    let balls = w.union(&parts);
    let block = w.new_record("12 -4 -4 -4 4 4 4");
    let root = w.new_record(format_args!("-103 {block} {balls}"));
    w.line(format_args!("{root} -701 0.8 0.7 0.5"));
    w.line(format_args!("{root} -2 30 2"));
    w.line(format_args!("{root} -2 25 1"));
    w.lamps(&TWO, 0.5);
    let scene = w.done("a box minus 500 spheres", true, root, 16.0);
    Scene {
        bar: Some(40.0),
        ..scene
    }
}

fn tori(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = Vec::new();
    for _ in 0..300 {
        let (major, minor) = (w.real(0.5, 1.5), w.real(0.1, 0.4));
        let id = w.new_record(format_args!("14 {major} {minor}"));
        w.turned(id);
        w.scattered(id, 8.0);
        w.coloured(id);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("300 turned tori", false, root, 25.0)
}

fn glass(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = w.room();
    for i in 0..28 {
        let place = [i % 4, i / 4 % 4, i / 16].map(|k| 2.6 * f64::from(k) - 3.9);
        let [x, y, z] = place;
        let r = w.real(0.8, 1.2);
        let id = w.new_record(format_args!("11 {x} {y} {z} {r}"));
        w.glass(id, 1.5);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("28 glass spheres", false, root, 15.0)
}

/// A vase: a line around the axis.
fn vase(w: &mut Writer, points: usize) -> u32 {
    let mut profile = String::new();
    for i in 0..points {
        let y = 2.0 * i as f64 / (points - 1) as f64 - 1.0;
        let x = 0.3 + 0.25 * (3.0 * y).cos().abs() + w.real(0.0, 0.06);
        write!(profile, " {x:.4} {y:.4}").expect("a string takes everything");
    }
    w.new_record(format_args!("1 {points}{profile}"))
}

fn lathes(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = Vec::new();
    for _ in 0..200 {
        let id = vase(&mut w, 40);
        w.turned(id);
        w.scattered(id, 7.0);
        w.coloured(id);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("200 surfaces of revolution", false, root, 22.0)
}

/// One of the shapes that end, about as large as the unit sphere.
fn any_shape(w: &mut Writer, kind: u32) -> u32 {
    match kind % 6 {
        0 => w.new_record("12 -0.6 -0.5 -0.4 0.6 0.5 0.4"),
        1 => w.new_record("16 1.2 0.6"),
        2 => w.new_record("10 0.9 0.5 0.7"),
        3 => w.new_record("17 0.9 0.5"),
        // An ellipsoid as a matrix.
        4 => w.new_record("15 2 0 0 0 0 1.5 0 0 0 0 3 0 0 0 0 -1"),
        // A cylinder between two planes.
        _ => {
            let tube = w.new_record("15 1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 -0.25");
            let ends = w.new_record("12 -1 -0.7 -1 1 0.7 1");
            w.new_record(format_args!("-102 {tube} {ends}"))
        }
    }
}

fn crowd(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut groups = Vec::new();
    for _ in 0..12 {
        let mut parts = Vec::new();
        for i in 0..60 {
            let id = any_shape(&mut w, i % 5);
            let [x, y, z] = w.reals(0.5, 1.3);
            w.line(format_args!("{id} -3 {x} {y} {z}"));
            w.turned(id);
            w.scattered(id, 2.5);
            w.coloured(id);
            parts.push(id);
        }
        let mut group = w.union(&parts);
        // Ten objects, each of the one before and one more.
        for _ in 0..10 {
            let id = w.new_record("9 0.4");
            w.scattered(id, 2.5);
            group = w.new_record(format_args!("-101 {group} {id}"));
            let [a] = w.reals(0.0, 360.0);
            w.line(format_args!("{group} -2 {a} 2"));
            w.moved(group, [0.1, 0.0, 0.1]);
        }
        w.scattered(group, 6.0);
        groups.push(group);
    }
    let root = w.union(&groups);
    w.lamps(&TWO, 0.5);
    w.done("a crowd in groups ten deep", false, root, 24.0)
}

fn facets(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = vec![w.new_record("13 3 7")];
    w.line(format_args!("{} -701 0.7 0.8 0.9", parts[0]));
    // Waves around it.
    let height = |x: f64, z: f64| -3.0 + 0.3 * (1.3 * x).sin() * (1.7 * z).cos();
    const N: i32 = 224;
    for i in 0..N {
        for k in 0..N {
            let at = |i: i32, k: i32| {
                let [x, z] = [i, k].map(|n| 20.0 * f64::from(n) / f64::from(N) - 10.0);
                format!("{x:.4} {:.4} {z:.4}", height(x, z))
            };
            let [a, b, c, d] = [at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)];
            parts.push(w.new_record(format_args!("6 {a} {b} {c}")));
            parts.push(w.new_record(format_args!("6 {b} {d} {c}")));
        }
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("a geodesic sphere and 100 000 triangles", false, root, 14.0)
}

fn textures(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let colours = [(); 6].map(|()| {
        let [r, g, b] = w.reals(0.0, 1.0);
        w.new_record(format_args!("-701 {r} {g} {b}"))
    });
    let mut parts = Vec::new();
    for i in 0..600u32 {
        let id = match i % 3 {
            0 => w.new_record("9 0.6"),
            1 => w.new_record("14 0.6 0.25"),
            _ => w.new_record("12 -0.5 -0.5 -0.5 0.5 0.5 0.5"),
        };
        let [a, b] = [i, i / 3 + 1].map(|k| colours[k as usize % 6]);
        let texture = match i % 2 {
            0 => w.new_record(format_args!("-399 12 8 {a} {b}")),
            _ => w.new_record(format_args!("-302 {a} {b} 0.2")),
        };
        w.line(format_args!("{id} -299 {texture} 0"));
        w.turned(id);
        w.scattered(id, 7.0);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("textures everywhere", false, root, 22.0)
}

fn lights(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = Vec::new();
    for i in 0..300 {
        let id = any_shape(&mut w, i % 4);
        w.turned(id);
        w.scattered(id, 6.0);
        w.coloured(id);
        parts.push(id);
    }
    let root = w.union(&parts);
    let mut lamps = Vec::new();
    for _ in 0..64 {
        let [x, y] = w.reals(-30.0, 30.0);
        lamps.push([x, y, w.real(12.0, 30.0)]);
    }
    w.lamps(&lamps, 0.016);
    w.done("64 lights", false, root, 20.0)
}

fn machined(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut part = w.new_record("12 -6 -1 -4 6 1 4");
    for i in 0..2000u32 {
        let tool = match i % 4 {
            0 => w.new_record("9 0.2"),
            1 => w.new_record("16 0.5 0.2"),
            2 => w.new_record("12 -0.15 -0.3 -0.15 0.15 0.3 0.15"),
            _ => w.new_record("14 0.18 0.06"),
        };
        w.turned(tool);
        let [x, z] = [w.real(-6.0, 6.0), w.real(-4.0, 4.0)];
        let y = if w.chance(0.8) {
            1.0
        } else {
            w.real(-1.0, 1.0)
        };
        w.moved(tool, [x, y, z]);
        let operation = if i % 5 == 4 { -101 } else { -103 };
        part = w.new_record(format_args!("{operation} {part} {tool}"));
    }
    w.line(format_args!("{part} -701 0.75 0.75 0.8"));
    w.line(format_args!("{part} -2 55 1"));
    w.lamps(&TWO, 0.5);
    let scene = w.done("a machined part of 2 000 operations", true, part, 13.0);
    Scene {
        bar: Some(40.0),
        ..scene
    }
}

fn lenses(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let mut parts = w.room();
    for i in 0..36 {
        let r = w.real(1.1, 1.6);
        let half = w.real(0.7, 0.9);
        let [a, b] = [-half, half].map(|z| w.new_record(format_args!("11 0 0 {z} {r}")));
        let id = w.new_record(format_args!("-102 {a} {b}"));
        // With more of it light would be totally reflected, which POV-Ray does in another way.
        w.glass(id, 1.1);
        w.turned(id);
        let [x, y, z] = [i % 4, i / 4 % 3, i / 12].map(|k| 2.4 * f64::from(k) - 3.6);
        w.moved(id, [x, y, z]);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&TWO, 0.5);
    w.done("lenses of glass", true, root, 15.0)
}

fn everything(seed: u64) -> Scene {
    let mut w = Writer::new(seed);
    let two = [[1.0, 0.9, 0.8], [0.2, 0.3, 0.5]]
        .map(|[r, g, b]| w.new_record(format_args!("-701 {r} {g} {b}")));
    let board = w.new_record(format_args!("-399 10 10 {} {}", two[0], two[1]));
    let mut parts = vec![w.new_record("12 -12 -7 -12 12 -6 12")];
    w.line(format_args!("{} -299 {board} 0", parts[0]));
    for i in 0..400u32 {
        let id = match i % 10 {
            0..=5 => any_shape(&mut w, i % 10),
            6 => w.new_record("14 0.6 0.2"),
            7 => vase(&mut w, 20),
            8 => w.new_record("13 0.7 2"),
            _ => {
                let [a, b] = [any_shape(&mut w, i / 10), any_shape(&mut w, i / 10 + 1)];
                w.moved(b, [0.4, 0.2, 0.1]);
                w.new_record(format_args!("-103 {a} {b}"))
            }
        };
        w.coloured(id);
        match i % 13 {
            0 => {
                w.line(format_args!("{id} -201 0.05 0.05 0.9"));
                w.line(format_args!("{id} -203 1.45 1.45 1.45"));
            }
            1 | 2 => w.line(format_args!("{id} -201 0.6 0.4 0")),
            3 => w.line(format_args!("{id} -299 {board} 0")),
            _ => {}
        }
        w.turned(id);
        w.scattered(id, 6.0);
        parts.push(id);
    }
    let root = w.union(&parts);
    w.lamps(&[TWO[0], TWO[1], [0.0, 30.0, 0.0]], 0.4);
    w.done("everything at once", false, root, 22.0)
}

/// Twenty scenes with shapes, materials, lights and groups as they come.
pub fn mixtures(seed: u64) -> Vec<Scene> {
    (1..=20).map(|number| mixture(seed, number)).collect()
}

fn mixture(seed: u64, number: u64) -> Scene {
    let mut w = Writer::new(seed.wrapping_mul(0x1000).wrapping_add(number));
    let kinds: Vec<u32> = (0..KINDS).filter(|_| w.chance(0.4)).collect();
    let count = 30.0 * 30f64.powf(w.real(0.0, 1.0));
    // Many scenes have nothing of a material.
    let mut share = |most: f64| (w.real(-most, most)).max(0.0);
    let [glass, mirrors, boards] = [share(0.3), share(0.4), share(0.5)];
    let size = 0.9 * count.cbrt();
    let two = [[1.0, 0.9, 0.8], [0.2, 0.3, 0.5]]
        .map(|[r, g, b]| w.new_record(format_args!("-701 {r} {g} {b}")));
    let board = w.new_record(format_args!("-399 10 10 {} {}", two[0], two[1]));
    let mut parts = Vec::new();
    for i in 0..count as usize {
        let kind = kinds.get(i % kinds.len().max(1)).copied().unwrap_or(0);
        let id = part(&mut w, kind);
        if w.chance(boards) {
            w.line(format_args!("{id} -299 {board} 0"));
        } else {
            w.coloured(id);
            if w.chance(glass) {
                let index = w.real(1.05, 1.6);
                w.glass(id, index);
            } else if w.chance(mirrors) {
                w.line(format_args!("{id} -201 0.6 0.4 0"));
            }
        }
        if w.chance(0.3) {
            let [x, y, z] = w.reals(0.5, 1.4);
            w.line(format_args!("{id} -3 {x} {y} {z}"));
        }
        w.turned(id);
        w.scattered(id, size);
        parts.push(id);
    }
    if w.chance(0.4) {
        parts = grouped(&mut w, &parts);
    }
    if w.chance(0.6) {
        let [far, low] = [2.0 * size, -1.2 * size];
        let floor = w.new_record(format_args!(
            "12 {} {} {} {far} {low} {far}",
            -far,
            low - 1.0,
            -far
        ));
        w.coloured(floor);
        parts.push(floor);
    }
    let root = match w.chance(0.5) {
        true => w.union(&parts),
        false => w.tree(parts),
    };
    let lamps: Vec<[f64; 3]> = (0..1 + number % 5)
        .map(|_| [w.real(-40.0, 40.0), w.real(5.0, 40.0), w.real(0.0, 40.0)])
        .collect();
    w.lamps(&lamps, 0.8 / lamps.len() as f64);
    w.done(&format!("mixture {number}"), false, root, 3.2 * size + 2.0)
}

/// Kinds of parts of mixtures.
const KINDS: u32 = 12;

fn part(w: &mut Writer, kind: u32) -> u32 {
    match kind {
        0..=5 => any_shape(w, kind),
        6 => w.new_record("9 0.6"),
        7 => w.new_record("14 0.6 0.2"),
        8 => vase(w, 12),
        9 => w.new_record("13 0.7 2"),
        10 => {
            let [a, b] = ["11 0 0 0.3 0.7", "11 0 0 -0.3 0.7"].map(|ball| w.new_record(ball));
            w.new_record(format_args!("-102 {a} {b}"))
        }
        _ => {
            let kind = w.real(0.0, 5.0) as u32;
            let [a, b] = [any_shape(w, kind), any_shape(w, kind + 1)];
            w.moved(b, [0.4, 0.2, 0.1]);
            w.new_record(format_args!("-103 {a} {b}"))
        }
    }
}

/// Unions of ten parts each, turned and moved.
fn grouped(w: &mut Writer, parts: &[u32]) -> Vec<u32> {
    let group = |some: &[u32]| {
        let id = w.union(some);
        if some.len() > 1 {
            w.turned(id);
            w.scattered(id, 1.0);
        }
        id
    };
    parts.chunks(10).map(group).collect()
}

/// Scenes without lamps, for primary rays alone.
pub fn of_rays(seed: u64) -> Vec<Scene> {
    let without_lamps = |name: &str, fill: fn(&mut Writer) -> Vec<u32>| {
        let mut w = Writer::new(seed);
        let parts = fill(&mut w);
        let root = w.tree(parts);
        w.lamps(&[], 0.0);
        w.done(name, false, root, 22.0)
    };
    vec![
        without_lamps("ten thousand spheres", |w| {
            let sphere = |_| {
                let [x, y, z] = w.reals(-8.0, 8.0);
                let r = w.real(0.05, 0.15);
                w.new_record(format_args!("11 {x} {y} {z} {r}"))
            };
            (0..10_000).map(sphere).collect()
        }),
        without_lamps("a geodesic sphere of level 7", |w| {
            vec![w.new_record("13 6 7")]
        }),
        without_lamps("100 000 triangles", |w| {
            let triangle = |_| {
                let [x, y, z] = w.reals(-8.0, 8.0);
                let mut corner = || {
                    let [a, b, c] = w.reals(-0.2, 0.2);
                    format!("{:.4} {:.4} {:.4}", x + a, y + b, z + c)
                };
                let corners = [corner(), corner(), corner()].join(" ");
                w.new_record(format_args!("6 {corners}"))
            };
            (0..100_000).map(triangle).collect()
        }),
    ]
}
