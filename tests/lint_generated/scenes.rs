//! Random scenes, valid by construction.

use crate::campaign::rng::Rng;
use std::fmt::Write;
use zpg::internals::syntax::table::{Effect, Kind, RECORD_TYPES};

struct Maker {
    rng: Rng,
    text: String,
    next: u32,
    colours: Vec<u32>,
    optics: Vec<u32>,
    textures: Vec<u32>,
}

/// An object as it stands: whether it is made of solids only.
#[derive(Clone, Copy)]
struct Object {
    id: u32,
    solid: bool,
}

/// A scene with every kind of record but images, in the way of the table.
pub fn scene(seed: u64) -> String {
    let mut m = Maker {
        rng: Rng::new(seed),
        text: String::new(),
        next: 2,
        colours: Vec::new(),
        optics: Vec::new(),
        textures: Vec::new(),
    };
    m.looks();
    let shapes: Vec<i32> = (RECORD_TYPES.iter())
        .filter(|t| matches!(t.effect, Effect::Defines(Kind::Object)) && t.code > 0 && t.code < 100)
        .map(|t| t.code)
        .collect();
    assert_eq!(shapes.len(), 21);
    let mut objects: Vec<Object> = Vec::new();
    for _ in 0..3 + m.rng.below(5) {
        // Half of them round or square, the other half anything.
        let code = match m.rng.chance(0.5) {
            true => [9, 11, 12, 10, 14][m.rng.below(5)],
            false => shapes[m.rng.below(shapes.len())],
        };
        let object = m.shape(code);
        m.change(object);
        objects.push(object);
    }
    for _ in 0..1 + m.rng.below(6) {
        let object = m.operation(&objects);
        m.change(object);
        objects.push(object);
    }
    let mut root = objects[m.rng.below(objects.len())];
    for other in objects.iter().rev().take(3) {
        if other.id != root.id {
            root = m.join(root, *other);
        }
    }
    m.view(root);
    m.text
}

impl Maker {
    fn id(&mut self) -> u32 {
        self.next += 1 + self.rng.below(3) as u32;
        self.next
    }

    fn write(&mut self, id: u32, code: i32, numbers: &[f64]) {
        let _ = write!(self.text, "{id} {code}");
        for x in numbers {
            let _ = write!(self.text, " {x}");
        }
        let comment = self.rng.chance(0.1);
        self.text += if comment { " # so #\n" } else { "\n" };
    }

    fn define(&mut self, code: i32, numbers: &[f64]) -> u32 {
        let id = self.id();
        self.write(id, code, numbers);
        id
    }

    /// A number of two decimals.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        (self.rng.range(low, high) * 100.0).round() / 100.0
    }

    fn numbers<const N: usize>(&mut self, low: f64, high: f64) -> [f64; N] {
        std::array::from_fn(|_| self.number(low, high))
    }

    fn looks(&mut self) {
        for _ in 0..3 {
            let rgb: [f64; 3] = self.numbers(0.0, 1.0);
            let colour = self.define(-701, &rgb);
            self.colours.push(colour);
        }
        let kt = self.number(0.3, 0.9);
        let glass = self.define(-201, &[0.05, 0.05, kt]);
        self.write(glass, -203, &[1.5, 1.5, 1.52]);
        let kd = self.number(0.1, 0.3);
        let tinted = self.define(-202, &[kd, 0.1, 0.5, kd, 0.1, 0.4, kd, 0.1, 0.3]);
        let mirror = self.define(-201, &[0.3, 0.6, 0.0]);
        self.optics = vec![glass, tinted, mirror, 0];
        let [a, b] = [0, 1].map(|i| f64::from(self.colours[i]));
        let board = self.define(-399, &[4.0, 3.0, a, b]);
        let cubes = self.define(-302, &[b, a, 0.4]);
        self.textures = vec![board, cubes, self.colours[2], 0];
    }

    fn shape(&mut self, code: i32) -> Object {
        let numbers: Vec<f64> = match code {
            1 | 2 => {
                let n = 2 + self.rng.below(4);
                let mut y = self.number(-1.5, 0.0);
                let mut out = vec![n as f64];
                for _ in 0..n {
                    out.extend([self.number(0.1, 1.5), y]);
                    y += self.number(0.1, 0.8);
                    y = (y * 100.0).round() / 100.0;
                }
                if code == 2 {
                    for _ in 0..n {
                        out.extend(self.numbers::<3>(0.0, 1.0));
                    }
                }
                out
            }
            3 | 4 => {
                let [a, b, c, d]: [f64; 4] = self.numbers(-1.0, 1.0);
                match self.rng.chance(0.5) {
                    true => vec![0.0, if a < 0.0 { -1.0 } else { 1.0 }, 0.0, d],
                    false => vec![a, b + 2.5, c, d],
                }
            }
            5 => {
                let [x, y]: [f64; 2] = self.numbers(-1.5, 0.0);
                let [w, h]: [f64; 2] = self.numbers(0.5, 2.0);
                vec![x, y, x + w, y + h]
            }
            6..=8 => {
                let mut out: Vec<f64> = self.numbers::<9>(-0.3, 0.3).into();
                // Corners that are not on a line.
                for (i, d) in [(0, -1.5), (4, 1.5), (6, 1.2)] {
                    out[i] += d;
                }
                let normals = [0, 1, 3][(code - 6) as usize];
                for _ in 0..normals {
                    out.extend([self.number(-0.3, 0.3), self.number(-0.3, 0.3), 1.0]);
                }
                out
            }
            9 => vec![self.number(0.3, 1.6)],
            10 => self.numbers::<3>(0.3, 1.6).into(),
            11 => {
                let [x, y, z]: [f64; 3] = self.numbers(-1.5, 1.5);
                vec![x, y, z, self.number(0.3, 1.6)]
            }
            12 => {
                let low: [f64; 3] = self.numbers(-1.8, 0.4);
                let size: [f64; 3] = self.numbers(0.3, 2.5);
                let high = [0, 1, 2].map(|i| low[i] + size[i]);
                low.into_iter().chain(high).collect()
            }
            13 => vec![self.number(0.4, 1.5), self.rng.below(3) as f64],
            14 => vec![self.number(0.8, 1.6), self.number(0.2, 0.6)],
            15 => {
                let [a, b, c]: [f64; 3] = self.numbers(0.4, 2.0);
                let d = self.number(-2.0, -0.4);
                let sign = if self.rng.chance(0.3) { -1.0 } else { 1.0 };
                let mut q = vec![0.0; 16];
                (q[0], q[5], q[10], q[15]) = (a, sign * b, c, d);
                q
            }
            16 | 17 => vec![self.number(0.4, 1.8), self.number(0.3, 1.2)],
            18 => vec![self.number(0.3, 1.5)],
            19 | 21 => self.numbers::<2>(0.3, 1.5).into(),
            20 => {
                let [a, b, c]: [f64; 3] = self.numbers(0.3, 1.5);
                vec![a, b, c, 1.0 + self.rng.below(2) as f64]
            }
            other => panic!("what is type {other}?"),
        };
        let id = self.define(code, &numbers);
        Object {
            id,
            solid: !matches!(code, 3 | 5..=8),
        }
    }

    /// Some transformations, properties and bounding volumes.
    fn change(&mut self, object: Object) {
        let id = object.id;
        for _ in 0..self.rng.below(3) {
            match self.rng.below(4) {
                0 | 1 => {
                    let by: [f64; 3] = self.numbers(-2.5, 2.5);
                    self.write(id, -1, &by);
                }
                2 => {
                    let angle = self.number(-180.0, 180.0);
                    let axis = 1.0 + self.rng.below(3) as f64;
                    self.write(id, -2, &[angle, axis]);
                }
                _ => {
                    let mut by: [f64; 3] = self.numbers(0.5, 1.6);
                    if self.rng.chance(0.5) {
                        by = [by[0]; 3];
                    }
                    if self.rng.chance(0.2) {
                        by[0] = -by[0];
                    }
                    self.write(id, -3, &by);
                }
            }
        }
        if self.rng.chance(0.5) {
            let texture = self.textures[self.rng.below(4)];
            let optics = self.optics[self.rng.below(4)];
            self.write(id, -299, &[f64::from(texture), f64::from(optics)]);
        }
        if self.rng.chance(0.1) {
            self.write(id, -201, &[0.2, 0.0, 0.7]);
            self.write(id, -203, &[1.3, 1.3, 1.3]);
        }
        if self.rng.chance(0.15) {
            let low: [f64; 3] = self.numbers(-4.0, -0.5);
            let high: [f64; 3] = self.numbers(0.5, 4.0);
            let both: Vec<f64> = low.into_iter().chain(high).collect();
            self.write(id, -601, &both);
        }
        if self.rng.chance(0.15) {
            let [x, y, z]: [f64; 3] = self.numbers(-0.5, 0.5);
            let r = self.number(0.8, 5.0);
            self.write(id, -602, &[x, y, z, r]);
        }
    }

    fn operation(&mut self, objects: &[Object]) -> Object {
        let solids: Vec<Object> = objects.iter().copied().filter(|o| o.solid).collect();
        let pick = |rng: &mut Rng, from: &[Object]| from[rng.below(from.len())];
        let kind = self.rng.below(10);
        if kind == 0 || solids.is_empty() {
            let of = pick(&mut self.rng, objects);
            let id = self.define(-105, &[f64::from(of.id)]);
            return Object { id, ..of };
        }
        if kind < 4 {
            let (a, b) = (pick(&mut self.rng, objects), pick(&mut self.rng, objects));
            return self.join(a, b);
        }
        let (a, b) = (pick(&mut self.rng, &solids), pick(&mut self.rng, &solids));
        let (a, b) = (f64::from(a.id), f64::from(b.id));
        let id = match kind {
            4..=6 => self.define(-103, &[a, b]),
            7 | 8 => self.define(-102, &[a, b]),
            _ => {
                let not = self.define(-104, &[b]);
                self.define(-102, &[a, f64::from(not)])
            }
        };
        Object { id, solid: true }
    }

    fn join(&mut self, a: Object, b: Object) -> Object {
        let id = self.define(-101, &[f64::from(a.id), f64::from(b.id)]);
        Object {
            id,
            solid: a.solid && b.solid,
        }
    }

    fn view(&mut self, root: Object) {
        let up = self.number(0.0, 3.0);
        let camera = self.define(-501, &[1.0, up, 9.0, -0.1, -0.1, -1.0, 0.0, 1.0, 0.0, 45.0]);
        self.define(-502, &[f64::from(camera)]);
        self.define(-401, &[0.2]);
        let lamp = self.define(-402, &[0.8]);
        self.write(lamp, -1, &[4.0, 6.0, 8.0]);
        let background = f64::from(self.colours[0]);
        let mut all = vec![f64::from(root.id), background];
        if self.rng.chance(0.4) {
            all.extend(self.numbers::<3>(-6.0, -0.5));
            all.extend(self.numbers::<3>(0.5, 6.0));
        }
        self.write(1, 9999, &all);
    }
}
