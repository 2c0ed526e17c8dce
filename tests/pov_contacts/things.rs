//! Random scenes of things with round numbers, so that many faces of theirs are in one plane: slabs, plates and
//! floors, and on them boxes, cylinders, cones, balls, domes, vessels with and without something in them and
//! blocks with plugged holes, beside, within and upon one another, of glass and opaque, in any order.

use crate::campaign::rng::Rng;
use std::fmt::Write;

/// What everything stands on.
const GROUNDS: [&str; 5] = ["floor", "slab", "slab", "plate", "slab over a floor"];

struct Maker {
    rng: Rng,
    text: String,
    next: u32,
    /// The parts of the union, in order.
    parts: Vec<u32>,
}

/// Things made in one place: one, or one and what is in it; and how high it is.
struct Thing {
    ids: Vec<u32>,
    height: f64,
}

/// A scene with the materials of `looks`.
pub fn scene(seed: u64, looks: &str) -> String {
    let mut m = Maker {
        rng: Rng::new(seed),
        text: looks.to_owned(),
        next: 100,
        parts: Vec::new(),
    };
    m.ground();
    for _ in 0..2 + m.rng.below(3) {
        let [x, z] = [m.quarters(-3, 3), m.quarters(-3, 2)];
        let lower = m.thing(9);
        let height = lower.height;
        m.put(&lower, [x, 0.0, z]);
        if m.rng.chance(0.35) {
            let [x, z] = [x, z].map(|at| at + m.quarters(-1, 1));
            let upper = m.thing(5);
            m.put(&upper, [x, height, z]);
        }
    }
    let mut order = std::mem::take(&mut m.parts);
    if m.rng.chance(0.7) {
        for i in (1..order.len()).rev() {
            order.swap(i, m.rng.below(i + 1));
        }
    }
    let mut root = order[0];
    for part in &order[1..] {
        root = m.record(&format!("-101 {root} {part}"));
    }
    let [x, y, z] = [(-3.0, 3.0), (1.2, 3.5), (4.5, 5.5)].map(|(a, b)| m.rng.range(a, b));
    let lamp = m.rng.range(-3.0, 3.0);
    let down = 0.4 - y;
    m.text
        + &format!(
            "3 -402 0.8\n3 -1 {lamp:.2} 6.1 4.6\n4 -401 0.2\n\
             5 -501 {x:.2} {y:.2} {z:.2} {:.2} {down:.2} {:.2} 0 1 0 40\n1 9999 {root} 14\n",
            -x, -z
        )
}

impl Maker {
    fn record(&mut self, what: &str) -> u32 {
        self.next += 1;
        writeln!(self.text, "{} {what}", self.next).unwrap();
        self.next
    }

    /// A number of quarters from one to another.
    fn quarters(&mut self, from: i32, to: i32) -> f64 {
        let n = self.rng.below((to - from + 1) as usize);
        f64::from(from + n as i32) / 4.0
    }

    fn ground(&mut self) {
        let ground = *self.rng.pick(&GROUNDS);
        if ground.ends_with("floor") {
            let below = if ground == "floor" { 0.0 } else { 0.25 };
            let id = self.record(&format!("4 0 1 0 {below}"));
            let (colour, optics) = (*self.rng.pick(&[11, 14]), *self.rng.pick(&[24, 24, 24, 21]));
            writeln!(self.text, "{id} -299 {colour} {optics}").unwrap();
            self.parts.push(id);
        }
        let slab = ground.starts_with("slab");
        if slab || ground == "plate" {
            let what = if slab {
                let [a, b] = [0; 2].map(|_| self.quarters(-8, -4));
                let (c, d) = (self.quarters(4, 8), self.quarters(2, 6));
                format!("12 {a} -0.25 {b} {c} 0 {d}")
            } else {
                let [below, above] = [0; 2].map(|_| self.quarters(4, 8));
                format!("1 2 {below} -0.125 {above} 0")
            };
            let id = self.record(&what);
            self.material(id);
            self.parts.push(id);
        }
    }

    /// One of the first `kinds` kinds, with its lowest point at a height of 0.
    fn thing(&mut self, kinds: usize) -> Thing {
        let one = |id, height| Thing {
            ids: vec![id],
            height,
        };
        match self.rng.below(kinds) {
            0 | 8 => {
                let (id, height) = self.block();
                one(id, height)
            }
            1 => {
                let (r, h) = (self.quarters(1, 3), self.quarters(2, 5));
                one(self.record(&format!("1 2 {r} 0 {r} {h}")), h)
            }
            2 => {
                let (r, h) = (self.quarters(1, 3), self.quarters(2, 5));
                one(self.record(&format!("1 2 {r} 0 0 {h}")), h)
            }
            3 => {
                let r = self.quarters(1, 2);
                let id = self.record(&format!("9 {r}"));
                writeln!(self.text, "{id} -1 0 {r} 0").unwrap();
                one(id, 2.0 * r)
            }
            4 => {
                let r = self.quarters(1, 3);
                let ball = self.record(&format!("9 {r}"));
                let upper = self.record("4 0 -1 0 0");
                one(self.record(&format!("-102 {ball} {upper}")), r)
            }
            5 => self.vessel(),
            6 => self.cup(),
            _ => self.holed(),
        }
    }

    fn block(&mut self) -> (u32, f64) {
        let [w, d] = [0; 2].map(|_| self.quarters(2, 6) / 2.0);
        let h = self.quarters(1, 5);
        let id = self.record(&format!("12 {} 0 {} {w} {h} {d}", -w, -d));
        (id, h)
    }

    fn vessel(&mut self) -> Thing {
        let (w, h, wall) = (self.quarters(3, 6) / 2.0, self.quarters(2, 5), 0.125);
        let inner = w - wall;
        let outside = self.record(&format!("12 {} 0 {} {w} {h} {w}", -w, -w));
        let hollow = |top: f64| {
            let low = -inner;
            format!("12 {low} {wall} {low} {inner} {top} {inner}")
        };
        let inside = self.record(&hollow(h));
        let mut ids = vec![self.record(&format!("-103 {outside} {inside}"))];
        if self.rng.chance(0.6) {
            let top = wall + (h - wall) * self.rng.pick(&[0.5, 0.75, 1.0]);
            ids.push(self.record(&hollow(top)));
        }
        Thing { ids, height: h }
    }

    fn cup(&mut self) -> Thing {
        let (r, h, wall) = (self.quarters(1, 3), self.quarters(2, 5), 0.05);
        let inner = r - wall;
        let profile = format!("1 5 {r} 0 {r} {h} {inner} {h} {inner} {wall} 0 {wall}");
        let mut ids = vec![self.record(&profile)];
        if self.rng.chance(0.5) {
            let top = wall + (h - wall) * self.rng.pick(&[0.5, 0.75]);
            ids.push(self.record(&format!("1 3 0 {wall} {inner} {wall} {inner} {top}")));
        }
        Thing { ids, height: h }
    }

    fn holed(&mut self) -> Thing {
        let (block, h) = self.block();
        let rod = format!("1 2 0.2 0 0.2 {h}");
        let hole = self.record(&rod);
        let mut ids = vec![self.record(&format!("-103 {block} {hole}"))];
        if self.rng.chance(0.6) {
            ids.push(self.record(&rod));
        }
        Thing { ids, height: h }
    }

    fn material(&mut self, id: u32) {
        let colour = 11 + self.rng.below(4);
        let optics = *self.rng.pick(&[20, 20, 21, 22, 23, 23, 23, 24]);
        writeln!(self.text, "{id} -299 {colour} {optics}").unwrap();
    }

    fn put(&mut self, thing: &Thing, [x, y, z]: [f64; 3]) {
        let turn = *self.rng.pick(&[0, 0, 0, 0, 90, 30, 45]);
        for &id in &thing.ids {
            self.material(id);
            if turn != 0 {
                writeln!(self.text, "{id} -2 {turn} 2").unwrap();
            }
            writeln!(self.text, "{id} -1 {x} {y} {z}").unwrap();
            self.parts.push(id);
        }
    }
}
